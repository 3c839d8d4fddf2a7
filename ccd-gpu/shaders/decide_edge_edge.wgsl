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
    var phi_203_: u32;
    var phi_219_: u32;
    var phi_240_: u32;
    var phi_241_: u32;
    var phi_244_: type_28;
    var phi_245_: type_28;
    var phi_268_: type_28;
    var phi_718_: f32;
    var phi_725_: f32;
    var phi_730_: f32;
    var phi_737_: f32;
    var phi_742_: f32;
    var phi_755_: f32;
    var phi_762_: f32;
    var phi_767_: f32;
    var phi_774_: f32;
    var phi_779_: f32;
    var phi_784_: f32;
    var phi_801_: f32;
    var phi_808_: f32;
    var phi_813_: f32;
    var phi_820_: f32;
    var phi_825_: f32;
    var phi_839_: f32;
    var phi_846_: f32;
    var phi_851_: f32;
    var phi_858_: f32;
    var phi_863_: f32;
    var phi_868_: f32;
    var phi_885_: f32;
    var phi_892_: f32;
    var phi_897_: f32;
    var phi_904_: f32;
    var phi_909_: f32;
    var phi_923_: f32;
    var phi_930_: f32;
    var phi_935_: f32;
    var phi_942_: f32;
    var phi_947_: f32;
    var phi_952_: f32;
    var phi_983_: f32;
    var phi_989_: f32;
    var phi_996_: f32;
    var phi_1003_: f32;
    var phi_1009_: f32;
    var phi_1016_: f32;
    var phi_1022_: f32;
    var phi_1028_: f32;
    var phi_1034_: f32;
    var phi_1041_: f32;
    var phi_1048_: f32;
    var phi_1072_: f32;
    var phi_1077_: f32;
    var phi_1082_: f32;
    var phi_1087_: f32;
    var phi_1092_: f32;
    var phi_1097_: f32;
    var phi_1107_: f32;
    var phi_3580_: f32;
    var phi_3586_: f32;
    var phi_3591_: f32;
    var phi_3597_: f32;
    var phi_3603_: f32;
    var phi_3608_: f32;
    var phi_3613_: f32;
    var phi_3621_: bool;
    var phi_3626_: f32;
    var phi_3633_: f32;
    var phi_3673_: type_26;
    var phi_3676_: f32;
    var phi_3697_: bool;
    var phi_3703_: type_27;
    var phi_3674_: type_26;
    var phi_3717_: type_27;
    var phi_3677_: f32;
    var local_16: f32;
    var phi_3666_: f32;
    var phi_3730_: f32;
    var phi_3736_: f32;
    var phi_3761_: type_28;
    var phi_3764_: u32;
    var phi_3762_: type_28;
    var phi_3787_: type_28;
    var phi_3831_: u32;
    var phi_3832_: u32;
    var phi_3765_: u32;
    var phi_3833_: u32;
    var phi_3853_: type_28;
    var phi_3854_: type_28;
    var phi_3877_: type_28;
    var phi_3929_: f32;
    var phi_3936_: f32;
    var phi_3947_: bool;
    var phi_3948_: bool;
    var phi_3949_: bool;
    var phi_3950_: bool;
    var phi_3954_: bool;
    var phi_3965_: type_56;
    var phi_3966_: type_56;
    var phi_3967_: bool;
    var phi_3968_: type_56;
    var phi_3969_: bool;
    var phi_3980_: f32;
    var phi_3990_: type_28;
    var phi_3993_: f32;
    var phi_3995_: f32;
    var phi_3997_: f32;
    var phi_3991_: type_28;
    var phi_4020_: type_28;
    var phi_4045_: f32;
    var phi_4046_: f32;
    var phi_4072_: f32;
    var phi_4088_: f32;
    var phi_4095_: bool;
    var phi_4096_: bool;
    var phi_4097_: bool;
    var phi_4103_: f32;
    var phi_4104_: f32;
    var phi_4105_: bool;
    var phi_3994_: f32;
    var phi_3996_: f32;
    var phi_3998_: f32;
    var phi_4106_: f32;
    var phi_4107_: bool;
    var phi_4108_: bool;
    var local_17: bool;
    var phi_4112_: f32;
    var phi_4113_: f32;
    var phi_4120_: type_28;
    var phi_4123_: f32;
    var phi_4121_: type_28;
    var phi_4146_: type_28;
    var phi_4187_: f32;
    var phi_4197_: f32;
    var phi_4205_: bool;
    var phi_4207_: bool;
    var phi_4212_: f32;
    var phi_4213_: bool;
    var phi_4214_: f32;
    var phi_4215_: bool;
    var phi_4216_: bool;
    var phi_4217_: bool;
    var phi_4218_: f32;
    var phi_4124_: f32;
    var phi_4219_: bool;
    var phi_4220_: bool;
    var phi_4221_: bool;
    var phi_4222_: bool;
    var local_18: bool;
    var phi_4226_: bool;
    var phi_4227_: bool;
    var phi_4231_: bool;
    var phi_4235_: f32;
    var phi_4236_: f32;
    var phi_4238_: type_56;
    var phi_4267_: f32;
    var phi_4274_: f32;
    var phi_4279_: f32;
    var phi_4286_: f32;
    var phi_4291_: f32;
    var phi_4304_: f32;
    var phi_4311_: f32;
    var phi_4316_: f32;
    var phi_4323_: f32;
    var phi_4328_: f32;
    var phi_4333_: f32;
    var phi_4392_: f32;
    var phi_4398_: f32;
    var phi_4403_: f32;
    var phi_4409_: f32;
    var phi_4414_: f32;
    var phi_4426_: f32;
    var phi_4432_: f32;
    var phi_4437_: f32;
    var phi_4443_: f32;
    var phi_4448_: f32;
    var phi_4474_: f32;
    var phi_4481_: f32;
    var phi_4486_: f32;
    var phi_4493_: f32;
    var phi_4498_: f32;
    var phi_4511_: f32;
    var phi_4518_: f32;
    var phi_4523_: f32;
    var phi_4530_: f32;
    var phi_4535_: f32;
    var phi_4540_: f32;
    var phi_4599_: f32;
    var phi_4605_: f32;
    var phi_4610_: f32;
    var phi_4616_: f32;
    var phi_4621_: f32;
    var phi_4633_: f32;
    var phi_4639_: f32;
    var phi_4644_: f32;
    var phi_4650_: f32;
    var phi_4655_: f32;
    var phi_4681_: f32;
    var phi_4688_: f32;
    var phi_4693_: f32;
    var phi_4700_: f32;
    var phi_4705_: f32;
    var phi_4718_: f32;
    var phi_4725_: f32;
    var phi_4730_: f32;
    var phi_4737_: f32;
    var phi_4742_: f32;
    var phi_4747_: f32;
    var phi_4806_: f32;
    var phi_4812_: f32;
    var phi_4817_: f32;
    var phi_4823_: f32;
    var phi_4828_: f32;
    var phi_4840_: f32;
    var phi_4846_: f32;
    var phi_4851_: f32;
    var phi_4857_: f32;
    var phi_4862_: f32;
    var phi_4911_: f32;
    var phi_4917_: f32;
    var phi_4945_: f32;
    var phi_4951_: f32;
    var phi_4956_: u32;
    var phi_4957_: u32;
    var phi_4927_: f32;
    var phi_4933_: f32;
    var phi_4938_: u32;
    var phi_4939_: u32;
    var phi_4958_: u32;
    var phi_4959_: u32;
    var phi_5026_: f32;
    var phi_5035_: f32;
    var phi_5166_: f32;
    var phi_5172_: f32;
    var phi_5179_: f32;
    var phi_5222_: type_28;
    var phi_5225_: bool;
    var phi_5223_: type_28;
    var phi_5248_: type_28;
    var phi_5275_: bool;
    var phi_5276_: bool;
    var phi_5226_: bool;
    var phi_5277_: bool;
    var phi_5278_: bool;
    var local_19: bool;
    var phi_5282_: bool;
    var local_20: bool;
    var phi_5289_: u32;
    var phi_5290_: u32;
    var phi_5291_: bool;
    var phi_5292_: u32;
    var phi_5293_: u32;
    var phi_5294_: bool;
    var phi_5298_: u32;
    var phi_5318_: bool;
    var phi_5319_: bool;
    var phi_5320_: bool;
    var phi_5516_: f32;
    var phi_5523_: f32;
    var phi_5528_: f32;
    var phi_5535_: f32;
    var phi_5540_: f32;
    var phi_5553_: f32;
    var phi_5560_: f32;
    var phi_5565_: f32;
    var phi_5572_: f32;
    var phi_5577_: f32;
    var phi_5582_: f32;
    var phi_5599_: f32;
    var phi_5606_: f32;
    var phi_5611_: f32;
    var phi_5618_: f32;
    var phi_5623_: f32;
    var phi_5637_: f32;
    var phi_5644_: f32;
    var phi_5649_: f32;
    var phi_5656_: f32;
    var phi_5661_: f32;
    var phi_5666_: f32;
    var phi_5683_: f32;
    var phi_5690_: f32;
    var phi_5695_: f32;
    var phi_5702_: f32;
    var phi_5707_: f32;
    var phi_5721_: f32;
    var phi_5728_: f32;
    var phi_5733_: f32;
    var phi_5740_: f32;
    var phi_5745_: f32;
    var phi_5750_: f32;
    var phi_5766_: type_28;
    var phi_5769_: f32;
    var phi_5767_: type_28;
    var phi_5792_: type_28;
    var phi_5946_: bool;
    var phi_5947_: bool;
    var phi_5948_: bool;
    var phi_5949_: bool;
    var phi_5950_: bool;
    var phi_5951_: bool;
    var phi_5955_: bool;
    var phi_5995_: array<f32, 3>;
    var phi_5996_: bool;
    var phi_5997_: array<f32, 3>;
    var phi_5998_: bool;
    var phi_6028_: f32;
    var phi_6029_: f32;
    var phi_6056_: f32;
    var phi_6057_: f32;
    var phi_6084_: f32;
    var phi_6085_: f32;
    var phi_6115_: f32;
    var phi_6116_: f32;
    var phi_6259_: type_28;
    var phi_6262_: array<f32, 3>;
    var phi_6260_: type_28;
    var phi_6285_: type_28;
    var phi_6352_: array<f32, 3>;
    var phi_6263_: array<f32, 3>;
    var phi_6353_: array<f32, 3>;
    var phi_6360_: f32;
    var phi_6367_: f32;
    var phi_6375_: f32;
    var phi_6419_: type_26;
    var phi_6422_: f32;
    var phi_6443_: bool;
    var phi_6449_: type_27;
    var phi_6420_: type_26;
    var phi_6463_: type_27;
    var phi_6423_: f32;
    var local_21: f32;
    var phi_6412_: f32;
    var phi_6476_: f32;
    var phi_6485_: type_28;
    var phi_6488_: f32;
    var phi_6486_: type_28;
    var phi_6511_: type_28;
    var phi_6562_: f32;
    var phi_6568_: f32;
    var phi_6581_: bool;
    var phi_6582_: bool;
    var phi_6613_: f32;
    var phi_6614_: f32;
    var phi_6615_: f32;
    var phi_6616_: bool;
    var phi_6620_: bool;
    var phi_6621_: f32;
    var phi_6622_: bool;
    var phi_6623_: bool;
    var phi_6624_: bool;
    var phi_6625_: f32;
    var phi_6626_: bool;
    var phi_6627_: bool;
    var phi_6628_: bool;
    var phi_6489_: f32;
    var phi_6629_: bool;
    var phi_6630_: bool;
    var phi_6631_: bool;
    var phi_6632_: bool;
    var local_22: bool;
    var local_23: f32;
    var local_24: f32;
    var local_25: f32;
    var phi_6649_: bool;
    var phi_6650_: bool;
    var phi_6651_: bool;
    var phi_6652_: bool;
    var phi_6653_: bool;
    var phi_6654_: bool;
    var phi_6655_: bool;
    var phi_6656_: bool;
    var phi_6657_: bool;
    var phi_6658_: bool;
    var phi_6659_: bool;
    var phi_6660_: bool;
    var phi_6661_: bool;
    var phi_6662_: f32;
    var phi_6663_: f32;
    var phi_6664_: bool;
    var phi_6665_: bool;
    var phi_6666_: bool;
    var phi_6667_: bool;
    var phi_6668_: bool;
    var phi_6669_: bool;
    var phi_6670_: bool;
    var phi_6671_: f32;
    var phi_6672_: f32;
    var phi_6673_: bool;
    var phi_6674_: bool;
    var phi_6675_: bool;
    var phi_6676_: bool;
    var phi_6677_: bool;
    var phi_6678_: bool;
    var phi_6679_: bool;
    var phi_6680_: bool;
    var phi_6681_: f32;
    var phi_5770_: f32;
    var phi_6682_: bool;
    var phi_6683_: bool;
    var phi_6684_: bool;
    var phi_6685_: bool;
    var phi_6686_: bool;
    var phi_6687_: bool;
    var phi_6688_: bool;
    var phi_6689_: bool;
    var phi_6690_: bool;
    var local_26: bool;
    var phi_6695_: type_55;
    var phi_6696_: bool;
    var phi_6697_: bool;
    var phi_6698_: bool;
    var phi_6699_: bool;
    var phi_6700_: bool;
    var phi_6701_: bool;
    var phi_6702_: bool;
    var phi_6706_: f32;
    var phi_6707_: bool;
    var phi_6708_: bool;
    var phi_6709_: bool;
    var phi_6710_: bool;
    var phi_6711_: bool;
    var phi_6712_: bool;
    var phi_6713_: bool;
    var phi_6718_: type_55;
    var phi_6719_: bool;
    var phi_6720_: bool;
    var phi_6721_: bool;
    var phi_6722_: bool;
    var phi_6723_: bool;
    var phi_6724_: bool;
    var local_27: f32;
    var phi_6729_: type_55;
    var phi_6730_: bool;
    var phi_6731_: bool;
    var phi_6732_: bool;
    var phi_6733_: bool;
    var phi_6734_: bool;
    var local_28: f32;
    var phi_6739_: type_55;
    var phi_6740_: bool;
    var phi_6741_: bool;
    var phi_6742_: bool;
    var phi_6743_: bool;
    var local_29: f32;
    var phi_6748_: type_55;
    var phi_6749_: bool;
    var phi_6750_: bool;
    var phi_6751_: bool;
    var phi_6752_: bool;
    var phi_6756_: type_55;
    var phi_6757_: bool;
    var phi_6758_: bool;
    var phi_6759_: bool;
    var phi_6763_: bool;
    var phi_6764_: bool;
    var phi_6768_: bool;
    var phi_6769_: bool;
    var phi_6773_: bool;
    var phi_6774_: bool;
    var local_30: f32;
    var phi_6779_: type_55;
    var phi_6780_: bool;
    var phi_6784_: type_55;
    var phi_6791_: bool;
    var phi_6792_: f32;
    var phi_6793_: bool;
    var phi_6794_: bool;
    var phi_6795_: bool;
    var phi_6796_: f32;
    var phi_6797_: bool;
    var phi_6798_: bool;
    var phi_6799_: bool;
    var phi_6800_: f32;
    var phi_6801_: bool;
    var phi_6802_: bool;
    var phi_6803_: bool;
    var phi_6804_: bool;
    var phi_6808_: bool;
    var phi_6809_: bool;
    var phi_6810_: bool;
    var phi_6811_: f32;
    var phi_6812_: type_56;
    var phi_6813_: bool;
    var phi_6814_: bool;
    var phi_6815_: bool;
    var phi_6816_: bool;
    var local_31: bool;
    var phi_6821_: type_55;
    var phi_6822_: bool;
    var phi_6823_: bool;
    var local_32: f32;
    var phi_6828_: type_55;
    var phi_6829_: bool;
    var local_33: type_56;
    var phi_6835_: type_55;
    var phi_6836_: bool;
    var phi_6840_: type_55;
    var phi_1308_: f32;
    var phi_1315_: f32;
    var phi_1320_: f32;
    var phi_1327_: f32;
    var phi_1332_: f32;
    var phi_1345_: f32;
    var phi_1352_: f32;
    var phi_1357_: f32;
    var phi_1364_: f32;
    var phi_1369_: f32;
    var phi_1374_: f32;
    var phi_1391_: f32;
    var phi_1398_: f32;
    var phi_1403_: f32;
    var phi_1410_: f32;
    var phi_1415_: f32;
    var phi_1429_: f32;
    var phi_1436_: f32;
    var phi_1441_: f32;
    var phi_1448_: f32;
    var phi_1453_: f32;
    var phi_1458_: f32;
    var phi_1475_: f32;
    var phi_1482_: f32;
    var phi_1487_: f32;
    var phi_1494_: f32;
    var phi_1499_: f32;
    var phi_1513_: f32;
    var phi_1520_: f32;
    var phi_1525_: f32;
    var phi_1532_: f32;
    var phi_1537_: f32;
    var phi_1542_: f32;
    var phi_1558_: type_28;
    var phi_1561_: f32;
    var phi_1559_: type_28;
    var phi_1584_: type_28;
    var phi_1738_: bool;
    var phi_1739_: bool;
    var phi_1740_: bool;
    var phi_1741_: bool;
    var phi_1742_: bool;
    var phi_1743_: bool;
    var phi_1747_: bool;
    var phi_1787_: array<f32, 3>;
    var phi_1788_: bool;
    var phi_1789_: array<f32, 3>;
    var phi_1790_: bool;
    var phi_1820_: f32;
    var phi_1821_: f32;
    var phi_1848_: f32;
    var phi_1849_: f32;
    var phi_1876_: f32;
    var phi_1877_: f32;
    var phi_1907_: f32;
    var phi_1908_: f32;
    var phi_2051_: type_28;
    var phi_2054_: array<f32, 3>;
    var phi_2052_: type_28;
    var phi_2077_: type_28;
    var phi_2144_: array<f32, 3>;
    var phi_2055_: array<f32, 3>;
    var phi_2145_: array<f32, 3>;
    var phi_2152_: f32;
    var phi_2159_: f32;
    var phi_2167_: f32;
    var phi_2211_: type_26;
    var phi_2214_: f32;
    var phi_2235_: bool;
    var phi_2241_: type_27;
    var phi_2212_: type_26;
    var phi_2255_: type_27;
    var phi_2215_: f32;
    var local_34: f32;
    var phi_2204_: f32;
    var phi_2268_: f32;
    var phi_2277_: type_28;
    var phi_2280_: f32;
    var phi_2278_: type_28;
    var phi_2303_: type_28;
    var phi_2354_: f32;
    var phi_2360_: f32;
    var phi_2373_: bool;
    var phi_2374_: bool;
    var phi_2405_: f32;
    var phi_2406_: f32;
    var phi_2407_: f32;
    var phi_2408_: bool;
    var phi_2412_: bool;
    var phi_2413_: f32;
    var phi_2414_: bool;
    var phi_2415_: bool;
    var phi_2416_: bool;
    var phi_2417_: f32;
    var phi_2418_: bool;
    var phi_2419_: bool;
    var phi_2420_: bool;
    var phi_2281_: f32;
    var phi_2421_: bool;
    var phi_2422_: bool;
    var phi_2423_: bool;
    var phi_2424_: bool;
    var local_35: bool;
    var local_36: f32;
    var local_37: f32;
    var local_38: f32;
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
    var phi_2453_: bool;
    var phi_2454_: f32;
    var phi_2455_: f32;
    var phi_2456_: bool;
    var phi_2457_: bool;
    var phi_2458_: bool;
    var phi_2459_: bool;
    var phi_2460_: bool;
    var phi_2461_: bool;
    var phi_2462_: bool;
    var phi_2463_: f32;
    var phi_2464_: f32;
    var phi_2465_: bool;
    var phi_2466_: bool;
    var phi_2467_: bool;
    var phi_2468_: bool;
    var phi_2469_: bool;
    var phi_2470_: bool;
    var phi_2471_: bool;
    var phi_2472_: bool;
    var phi_2473_: f32;
    var phi_1562_: f32;
    var phi_2474_: bool;
    var phi_2475_: bool;
    var phi_2476_: bool;
    var phi_2477_: bool;
    var phi_2478_: bool;
    var phi_2479_: bool;
    var phi_2480_: bool;
    var phi_2481_: bool;
    var phi_2482_: bool;
    var local_39: bool;
    var phi_2487_: type_55;
    var phi_2488_: bool;
    var phi_2489_: bool;
    var phi_2490_: bool;
    var phi_2491_: bool;
    var phi_2492_: bool;
    var phi_2493_: bool;
    var phi_2494_: bool;
    var phi_2498_: f32;
    var phi_2499_: bool;
    var phi_2500_: bool;
    var phi_2501_: bool;
    var phi_2502_: bool;
    var phi_2503_: bool;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2510_: type_55;
    var phi_2511_: bool;
    var phi_2512_: bool;
    var phi_2513_: bool;
    var phi_2514_: bool;
    var phi_2515_: bool;
    var phi_2516_: bool;
    var local_40: f32;
    var phi_2521_: type_55;
    var phi_2522_: bool;
    var phi_2523_: bool;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var local_41: f32;
    var phi_2531_: type_55;
    var phi_2532_: bool;
    var phi_2533_: bool;
    var phi_2534_: bool;
    var phi_2535_: bool;
    var local_42: f32;
    var phi_2540_: type_55;
    var phi_2541_: bool;
    var phi_2542_: bool;
    var phi_2543_: bool;
    var phi_2544_: bool;
    var phi_2548_: type_55;
    var phi_2549_: bool;
    var phi_2550_: bool;
    var phi_2551_: bool;
    var phi_2555_: bool;
    var phi_2556_: bool;
    var phi_2560_: bool;
    var phi_2561_: bool;
    var phi_2565_: bool;
    var phi_2566_: bool;
    var local_43: f32;
    var phi_2571_: type_55;
    var phi_2572_: bool;
    var phi_2576_: type_55;
    var phi_2590_: type_28;
    var phi_2591_: type_28;
    var phi_2614_: type_28;
    var phi_2634_: f32;
    var phi_2782_: bool;
    var phi_2783_: bool;
    var phi_2784_: bool;
    var phi_2785_: bool;
    var phi_2786_: bool;
    var phi_2787_: bool;
    var phi_2791_: bool;
    var phi_2831_: array<f32, 3>;
    var phi_2832_: bool;
    var phi_2833_: array<f32, 3>;
    var phi_2834_: bool;
    var phi_2864_: f32;
    var phi_2865_: f32;
    var phi_2892_: f32;
    var phi_2893_: f32;
    var phi_2920_: f32;
    var phi_2921_: f32;
    var phi_2951_: f32;
    var phi_2952_: f32;
    var phi_3095_: type_28;
    var phi_3098_: array<f32, 3>;
    var phi_3096_: type_28;
    var phi_3121_: type_28;
    var phi_3188_: array<f32, 3>;
    var phi_3099_: array<f32, 3>;
    var phi_3189_: array<f32, 3>;
    var phi_3221_: type_26;
    var phi_3224_: f32;
    var phi_3245_: bool;
    var phi_3251_: type_27;
    var phi_3222_: type_26;
    var phi_3265_: type_27;
    var phi_3225_: f32;
    var local_44: f32;
    var phi_3214_: f32;
    var phi_3278_: f32;
    var phi_3294_: f32;
    var phi_3301_: f32;
    var phi_3306_: f32;
    var phi_3313_: f32;
    var phi_3318_: f32;
    var phi_3331_: f32;
    var phi_3338_: f32;
    var phi_3343_: f32;
    var phi_3350_: f32;
    var phi_3355_: f32;
    var phi_3360_: f32;
    var phi_3377_: f32;
    var phi_3384_: f32;
    var phi_3389_: f32;
    var phi_3396_: f32;
    var phi_3401_: f32;
    var phi_3415_: f32;
    var phi_3422_: f32;
    var phi_3427_: f32;
    var phi_3434_: f32;
    var phi_3439_: f32;
    var phi_3444_: f32;
    var phi_3461_: f32;
    var phi_3468_: f32;
    var phi_3473_: f32;
    var phi_3480_: f32;
    var phi_3485_: f32;
    var phi_3499_: f32;
    var phi_3506_: f32;
    var phi_3511_: f32;
    var phi_3518_: f32;
    var phi_3523_: f32;
    var phi_3528_: f32;
    var phi_3548_: bool;
    var phi_3549_: bool;
    var phi_3550_: bool;
    var local_45: bool;
    var phi_3555_: type_55;
    var phi_3556_: bool;
    var phi_3561_: type_55;
    var phi_3562_: bool;
    var phi_3564_: type_55;
    var phi_3565_: type_55;
    var phi_3566_: bool;
    var phi_3570_: type_55;
    var phi_6844_: type_55;
    var phi_6845_: type_55;
    var phi_6898_: array<u32, 2>;
    var phi_6899_: array<u32, 2>;
    var phi_6900_: bool;
    var phi_6904_: array<u32, 2>;
    var phi_6872_: array<u32, 2>;
    var phi_6873_: array<u32, 2>;
    var phi_6874_: bool;
    var phi_6878_: array<u32, 2>;
    var phi_6906_: type_58;
    var phi_6913_: bool;
    var phi_6937_: u32;
    var phi_6941_: type_48;
    var phi_6942_: bool;
    var phi_6943_: bool;
    var phi_6961_: u32;
    var phi_7023_: u32;
    var local_46: u32;
    var local_47: f32;
    var local_48: f32;
    var local_49: bool;
    var local_50: bool;
    var local_51: f32;
    var local_52: array<f32, 3>;
    var local_53: bool;
    var local_54: bool;
    var local_55: f32;
    var local_56: f32;
    var local_57: bool;
    var local_58: bool;
    var local_59: bool;
    var local_60: bool;
    var local_61: bool;
    var local_62: bool;
    var local_63: bool;
    var local_64: f32;
    var local_65: f32;
    var local_66: bool;
    var local_67: bool;
    var local_68: bool;
    var local_69: array<f32, 3>;
    var local_70: bool;
    var local_71: bool;
    var local_72: f32;
    var local_73: f32;
    var local_74: bool;
    var local_75: bool;
    var local_76: bool;
    var local_77: bool;
    var local_78: bool;
    var local_79: bool;
    var local_80: bool;
    var local_81: f32;
    var local_82: f32;
    var local_83: bool;
    var local_84: array<f32, 3>;

    let _e106 = id_1;
    let _e107 = n_1;
    let _e108 = lane_1;
    let _e120 = ((_e106.y * _e107.x) + _e106.x);
    let _e123 = (_e107.x * _e107.y);
    let _e125 = params.member.member_15;
    let _e127 = input.member[0u];
    if (_e125 < _e127) {
        phi_203_ = _e125;
    } else {
        phi_203_ = _e127;
    }
    let _e130 = phi_203_;
    let _e131 = (_e130 / 64u);
    if ((_e130 % 64u) > 0u) {
        phi_219_ = (_e131 + 1u);
    } else {
        phi_219_ = _e131;
    }
    let _e136 = phi_219_;
    if (_e136 > _e120) {
        let _e138 = (_e136 - _e120);
        if (_e123 == 0u) {
            return;
        }
        let _e140 = (_e138 / _e123);
        if (_e123 == 0u) {
            return;
        }
        if ((_e138 % _e123) > 0u) {
            phi_240_ = (_e140 + 1u);
        } else {
            phi_240_ = _e140;
        }
        let _e146 = phi_240_;
        phi_241_ = _e146;
    } else {
        phi_241_ = 0u;
    }
    let _e148 = phi_241_;
    phi_244_ = type_28(0u, _e148);
    loop {
        let _e151 = phi_244_;
        if (_e151.member < _e151.member_1) {
            phi_245_ = type_28((_e151.member + 1u), _e151.member_1);
            phi_268_ = type_28(1u, _e151.member);
        } else {
            phi_245_ = _e151;
            phi_268_ = type_28(0u, type_28().member_1);
        }
        let _e165 = phi_245_;
        let _e167 = phi_268_;
        let _e171 = (bitcast<i32>(_e167.member) != 0i);
        if _e171 {
            let _e175 = (((_e120 + (_e167.member_1 * _e123)) * 64u) + _e108);
            let _e177 = params.member.member_8;
            if (_e175 < _e130) {
                let _e180 = (2u * _e175);
                let _e183 = input.member[(4u + _e180)];
                let _e186 = input.member[(_e180 + 5u)];
                let _e188 = elements.member[_e183];
                let _e190 = elements.member[_e186];
                let _e196 = paths.member[_e188[0]];
                let _e198 = paths.member[_e188[1]];
                let _e204 = paths.member[_e190[0]];
                let _e206 = paths.member[_e190[1]];
                let _e236 = params.member.member_4;
                local_15 = type_45(array<array<f32, 3>, 2>(array<f32, 3>((_e204.member[0] - _e196.member[0]), (_e204.member[1] - _e196.member[1]), (_e204.member[2] - _e196.member[2])), array<f32, 3>((_e204.member_1[0] - _e196.member_1[0]), (_e204.member_1[1] - _e196.member_1[1]), (_e204.member_1[2] - _e196.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e198.member[0] - _e196.member[0]), (_e198.member[1] - _e196.member[1]), (_e198.member[2] - _e196.member[2])), array<f32, 3>((_e198.member_1[0] - _e196.member_1[0]), (_e198.member_1[1] - _e196.member_1[1]), (_e198.member_1[2] - _e196.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e204.member[0] - _e206.member[0]), (_e204.member[1] - _e206.member[1]), (_e204.member[2] - _e206.member[2])), array<f32, 3>((_e204.member_1[0] - _e206.member_1[0]), (_e204.member_1[1] - _e206.member_1[1]), (_e204.member_1[2] - _e206.member_1[2]))), (_e236 + _e236));
                let _e267 = params.member.member_5;
                let _e270 = local_15.member_1[0u];
                let _e276 = local_15.member_2[0u];
                let _e282 = ((_e270[1] * _e276[2]) - (_e270[2] * _e276[1]));
                let _e285 = ((_e270[2] * _e276[0]) - (_e270[0] * _e276[2]));
                let _e288 = ((_e270[0] * _e276[1]) - (_e270[1] * _e276[0]));
                let _e291 = local_15.member_1[1u];
                let _e297 = local_15.member_2[1u];
                let _e303 = ((_e291[1] * _e297[2]) - (_e291[2] * _e297[1]));
                let _e306 = ((_e291[2] * _e297[0]) - (_e291[0] * _e297[2]));
                let _e309 = ((_e291[0] * _e297[1]) - (_e291[1] * _e297[0]));
                let _e312 = local_15.member_1[0u];
                let _e318 = local_15.member_2[1u];
                let _e333 = local_15.member_1[1u];
                let _e339 = local_15.member_2[0u];
                let _e352 = (((_e312[1] * _e318[2]) - (_e312[2] * _e318[1])) + ((_e333[1] * _e339[2]) - (_e333[2] * _e339[1])));
                let _e353 = (((_e312[2] * _e318[0]) - (_e312[0] * _e318[2])) + ((_e333[2] * _e339[0]) - (_e333[0] * _e339[2])));
                let _e354 = (((_e312[0] * _e318[1]) - (_e312[1] * _e318[0])) + ((_e333[0] * _e339[1]) - (_e333[1] * _e339[0])));
                let _e357 = local_15.member[0u];
                let _e365 = (((_e357[0] * _e282) + (_e357[1] * _e285)) + (_e357[2] * _e288));
                let _e368 = local_15.member[1u];
                let _e379 = local_15.member[0u];
                let _e388 = ((((_e368[0] * _e282) + (_e368[1] * _e285)) + (_e368[2] * _e288)) + (((_e379[0] * _e352) + (_e379[1] * _e353)) + (_e379[2] * _e354)));
                let _e391 = local_15.member[0u];
                let _e402 = local_15.member[1u];
                let _e411 = ((((_e391[0] * _e303) + (_e391[1] * _e306)) + (_e391[2] * _e309)) + (((_e402[0] * _e352) + (_e402[1] * _e353)) + (_e402[2] * _e354)));
                let _e414 = local_15.member[1u];
                let _e422 = (((_e414[0] * _e303) + (_e414[1] * _e306)) + (_e414[2] * _e309));
                let _e425 = local_15.member[0u];
                if (_e425[0] < 0f) {
                    phi_718_ = -(_e425[0]);
                } else {
                    phi_718_ = _e425[0];
                }
                let _e432 = phi_718_;
                if (_e425[1] < 0f) {
                    phi_725_ = -(_e425[1]);
                } else {
                    phi_725_ = _e425[1];
                }
                let _e436 = phi_725_;
                if (_e432 > _e436) {
                    phi_730_ = _e432;
                } else {
                    phi_730_ = _e436;
                }
                let _e439 = phi_730_;
                if (_e425[2] < 0f) {
                    phi_737_ = -(_e425[2]);
                } else {
                    phi_737_ = _e425[2];
                }
                let _e443 = phi_737_;
                if (_e439 > _e443) {
                    phi_742_ = _e439;
                } else {
                    phi_742_ = _e443;
                }
                let _e446 = phi_742_;
                let _e449 = local_15.member[1u];
                if (_e449[0] < 0f) {
                    phi_755_ = -(_e449[0]);
                } else {
                    phi_755_ = _e449[0];
                }
                let _e456 = phi_755_;
                if (_e449[1] < 0f) {
                    phi_762_ = -(_e449[1]);
                } else {
                    phi_762_ = _e449[1];
                }
                let _e460 = phi_762_;
                if (_e456 > _e460) {
                    phi_767_ = _e456;
                } else {
                    phi_767_ = _e460;
                }
                let _e463 = phi_767_;
                if (_e449[2] < 0f) {
                    phi_774_ = -(_e449[2]);
                } else {
                    phi_774_ = _e449[2];
                }
                let _e467 = phi_774_;
                if (_e463 > _e467) {
                    phi_779_ = _e463;
                } else {
                    phi_779_ = _e467;
                }
                let _e470 = phi_779_;
                if (_e446 > _e470) {
                    phi_784_ = _e446;
                } else {
                    phi_784_ = _e470;
                }
                let _e473 = phi_784_;
                let _e475 = local_15.member_3;
                let _e476 = (_e473 + _e475);
                let _e479 = local_15.member_1[0u];
                if (_e479[0] < 0f) {
                    phi_801_ = -(_e479[0]);
                } else {
                    phi_801_ = _e479[0];
                }
                let _e486 = phi_801_;
                if (_e479[1] < 0f) {
                    phi_808_ = -(_e479[1]);
                } else {
                    phi_808_ = _e479[1];
                }
                let _e490 = phi_808_;
                if (_e486 > _e490) {
                    phi_813_ = _e486;
                } else {
                    phi_813_ = _e490;
                }
                let _e493 = phi_813_;
                if (_e479[2] < 0f) {
                    phi_820_ = -(_e479[2]);
                } else {
                    phi_820_ = _e479[2];
                }
                let _e497 = phi_820_;
                if (_e493 > _e497) {
                    phi_825_ = _e493;
                } else {
                    phi_825_ = _e497;
                }
                let _e500 = phi_825_;
                let _e503 = local_15.member_1[1u];
                if (_e503[0] < 0f) {
                    phi_839_ = -(_e503[0]);
                } else {
                    phi_839_ = _e503[0];
                }
                let _e510 = phi_839_;
                if (_e503[1] < 0f) {
                    phi_846_ = -(_e503[1]);
                } else {
                    phi_846_ = _e503[1];
                }
                let _e514 = phi_846_;
                if (_e510 > _e514) {
                    phi_851_ = _e510;
                } else {
                    phi_851_ = _e514;
                }
                let _e517 = phi_851_;
                if (_e503[2] < 0f) {
                    phi_858_ = -(_e503[2]);
                } else {
                    phi_858_ = _e503[2];
                }
                let _e521 = phi_858_;
                if (_e517 > _e521) {
                    phi_863_ = _e517;
                } else {
                    phi_863_ = _e521;
                }
                let _e524 = phi_863_;
                if (_e500 > _e524) {
                    phi_868_ = _e500;
                } else {
                    phi_868_ = _e524;
                }
                let _e527 = phi_868_;
                let _e529 = local_15.member_3;
                let _e530 = (_e527 + _e529);
                let _e533 = local_15.member_2[0u];
                if (_e533[0] < 0f) {
                    phi_885_ = -(_e533[0]);
                } else {
                    phi_885_ = _e533[0];
                }
                let _e540 = phi_885_;
                if (_e533[1] < 0f) {
                    phi_892_ = -(_e533[1]);
                } else {
                    phi_892_ = _e533[1];
                }
                let _e544 = phi_892_;
                if (_e540 > _e544) {
                    phi_897_ = _e540;
                } else {
                    phi_897_ = _e544;
                }
                let _e547 = phi_897_;
                if (_e533[2] < 0f) {
                    phi_904_ = -(_e533[2]);
                } else {
                    phi_904_ = _e533[2];
                }
                let _e551 = phi_904_;
                if (_e547 > _e551) {
                    phi_909_ = _e547;
                } else {
                    phi_909_ = _e551;
                }
                let _e554 = phi_909_;
                let _e557 = local_15.member_2[1u];
                if (_e557[0] < 0f) {
                    phi_923_ = -(_e557[0]);
                } else {
                    phi_923_ = _e557[0];
                }
                let _e564 = phi_923_;
                if (_e557[1] < 0f) {
                    phi_930_ = -(_e557[1]);
                } else {
                    phi_930_ = _e557[1];
                }
                let _e568 = phi_930_;
                if (_e564 > _e568) {
                    phi_935_ = _e564;
                } else {
                    phi_935_ = _e568;
                }
                let _e571 = phi_935_;
                if (_e557[2] < 0f) {
                    phi_942_ = -(_e557[2]);
                } else {
                    phi_942_ = _e557[2];
                }
                let _e575 = phi_942_;
                if (_e571 > _e575) {
                    phi_947_ = _e571;
                } else {
                    phi_947_ = _e575;
                }
                let _e578 = phi_947_;
                if (_e554 > _e578) {
                    phi_952_ = _e554;
                } else {
                    phi_952_ = _e578;
                }
                let _e581 = phi_952_;
                let _e583 = local_15.member_3;
                let _e584 = (_e581 + _e583);
                let _e586 = ((_e530 * 8f) * _e584);
                let _e593 = local_15.member_3;
                if (_e282 < 0f) {
                    phi_983_ = -(_e282);
                } else {
                    phi_983_ = _e282;
                }
                let _e610 = phi_983_;
                if (_e285 < 0f) {
                    phi_989_ = -(_e285);
                } else {
                    phi_989_ = _e285;
                }
                let _e614 = phi_989_;
                if (_e288 < 0f) {
                    phi_996_ = -(_e288);
                } else {
                    phi_996_ = _e288;
                }
                let _e619 = phi_996_;
                let _e620 = ((_e610 + _e614) + _e619);
                if (_e303 < 0f) {
                    phi_1003_ = -(_e303);
                } else {
                    phi_1003_ = _e303;
                }
                let _e624 = phi_1003_;
                if (_e306 < 0f) {
                    phi_1009_ = -(_e306);
                } else {
                    phi_1009_ = _e306;
                }
                let _e628 = phi_1009_;
                if (_e309 < 0f) {
                    phi_1016_ = -(_e309);
                } else {
                    phi_1016_ = _e309;
                }
                let _e633 = phi_1016_;
                let _e634 = ((_e624 + _e628) + _e633);
                if (_e620 > _e634) {
                    phi_1022_ = _e620;
                } else {
                    phi_1022_ = _e634;
                }
                let _e637 = phi_1022_;
                if (_e352 < 0f) {
                    phi_1028_ = -(_e352);
                } else {
                    phi_1028_ = _e352;
                }
                let _e641 = phi_1028_;
                if (_e353 < 0f) {
                    phi_1034_ = -(_e353);
                } else {
                    phi_1034_ = _e353;
                }
                let _e645 = phi_1034_;
                if (_e354 < 0f) {
                    phi_1041_ = -(_e354);
                } else {
                    phi_1041_ = _e354;
                }
                let _e650 = phi_1041_;
                let _e652 = (((_e641 + _e645) + _e650) * 0.5f);
                if (_e637 > _e652) {
                    phi_1048_ = _e637;
                } else {
                    phi_1048_ = _e652;
                }
                let _e655 = phi_1048_;
                let _e660 = local_15.member_3;
                let _e672 = (((((_e476 * 8f) * _e586) * (0.000000059604645f * (490f / 64f))) + ((_e593 * 19f) * ((_e476 * (_e530 + _e584)) + (_e530 * _e584)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e476) * ((1f + _e530) * (1f + _e584)))));
                let _e673 = (_e365 * 3f);
                let _e674 = (_e422 * 3f);
                if (_e673 < _e674) {
                    phi_1072_ = _e673;
                } else {
                    phi_1072_ = _e674;
                }
                let _e677 = phi_1072_;
                if (_e388 < _e411) {
                    phi_1077_ = _e388;
                } else {
                    phi_1077_ = _e411;
                }
                let _e680 = phi_1077_;
                if (_e677 < _e680) {
                    phi_1082_ = _e677;
                } else {
                    phi_1082_ = _e680;
                }
                let _e683 = phi_1082_;
                if (_e673 > _e674) {
                    phi_1087_ = _e673;
                } else {
                    phi_1087_ = _e674;
                }
                let _e686 = phi_1087_;
                if (_e388 > _e411) {
                    phi_1092_ = _e388;
                } else {
                    phi_1092_ = _e411;
                }
                let _e689 = phi_1092_;
                if (_e686 > _e689) {
                    phi_1097_ = _e686;
                } else {
                    phi_1097_ = _e689;
                }
                let _e692 = phi_1097_;
                let _e697 = -(_e692);
                if (_e683 > _e697) {
                    phi_1107_ = _e683;
                } else {
                    phi_1107_ = _e697;
                }
                let _e700 = phi_1107_;
                if ((_e700 - (_e672 + ((_e267 * (((_e655 + (_e586 * (0.000000059604645f * 4f))) + ((_e660 * 6f) * (_e530 + _e584))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e530) * (1f + _e584))))) * (3f * 1.0001f)))) > 0f) {
                    phi_6845_ = type_55(0u, type_55().member_1);
                } else {
                    if (_e267 > 0f) {
                        let _e3036 = local_15.member[0u];
                        let _e3042 = local_15.member_1[0u];
                        let _e3048 = local_15.member_2[0u];
                        let _e3052 = (_e3036[0] - _e3042[0]);
                        let _e3053 = (_e3036[1] - _e3042[1]);
                        let _e3054 = (_e3036[2] - _e3042[2]);
                        local_12 = array<array<f32, 3>, 4>(_e3036, array<f32, 3>(_e3052, _e3053, _e3054), array<f32, 3>((_e3036[0] - _e3048[0]), (_e3036[1] - _e3048[1]), (_e3036[2] - _e3048[2])), array<f32, 3>((_e3052 - _e3048[0]), (_e3053 - _e3048[1]), (_e3054 - _e3048[2])));
                        let _e3067 = local_15.member[1u];
                        let _e3073 = local_15.member_1[1u];
                        let _e3079 = local_15.member_2[1u];
                        let _e3083 = (_e3067[0] - _e3073[0]);
                        let _e3084 = (_e3067[1] - _e3073[1]);
                        let _e3085 = (_e3067[2] - _e3073[2]);
                        local_13 = array<array<f32, 3>, 4>(_e3067, array<f32, 3>(_e3083, _e3084, _e3085), array<f32, 3>((_e3067[0] - _e3079[0]), (_e3067[1] - _e3079[1]), (_e3067[2] - _e3079[2])), array<f32, 3>((_e3083 - _e3079[0]), (_e3084 - _e3079[1]), (_e3085 - _e3079[2])));
                        let _e3098 = local_15.member[0u];
                        if (_e3098[0] < 0f) {
                            phi_1308_ = -(_e3098[0]);
                        } else {
                            phi_1308_ = _e3098[0];
                        }
                        let _e3105 = phi_1308_;
                        if (_e3098[1] < 0f) {
                            phi_1315_ = -(_e3098[1]);
                        } else {
                            phi_1315_ = _e3098[1];
                        }
                        let _e3109 = phi_1315_;
                        if (_e3105 > _e3109) {
                            phi_1320_ = _e3105;
                        } else {
                            phi_1320_ = _e3109;
                        }
                        let _e3112 = phi_1320_;
                        if (_e3098[2] < 0f) {
                            phi_1327_ = -(_e3098[2]);
                        } else {
                            phi_1327_ = _e3098[2];
                        }
                        let _e3116 = phi_1327_;
                        if (_e3112 > _e3116) {
                            phi_1332_ = _e3112;
                        } else {
                            phi_1332_ = _e3116;
                        }
                        let _e3119 = phi_1332_;
                        let _e3122 = local_15.member[1u];
                        if (_e3122[0] < 0f) {
                            phi_1345_ = -(_e3122[0]);
                        } else {
                            phi_1345_ = _e3122[0];
                        }
                        let _e3129 = phi_1345_;
                        if (_e3122[1] < 0f) {
                            phi_1352_ = -(_e3122[1]);
                        } else {
                            phi_1352_ = _e3122[1];
                        }
                        let _e3133 = phi_1352_;
                        if (_e3129 > _e3133) {
                            phi_1357_ = _e3129;
                        } else {
                            phi_1357_ = _e3133;
                        }
                        let _e3136 = phi_1357_;
                        if (_e3122[2] < 0f) {
                            phi_1364_ = -(_e3122[2]);
                        } else {
                            phi_1364_ = _e3122[2];
                        }
                        let _e3140 = phi_1364_;
                        if (_e3136 > _e3140) {
                            phi_1369_ = _e3136;
                        } else {
                            phi_1369_ = _e3140;
                        }
                        let _e3143 = phi_1369_;
                        if (_e3119 > _e3143) {
                            phi_1374_ = _e3119;
                        } else {
                            phi_1374_ = _e3143;
                        }
                        let _e3146 = phi_1374_;
                        let _e3148 = local_15.member_3;
                        let _e3152 = local_15.member_1[0u];
                        if (_e3152[0] < 0f) {
                            phi_1391_ = -(_e3152[0]);
                        } else {
                            phi_1391_ = _e3152[0];
                        }
                        let _e3159 = phi_1391_;
                        if (_e3152[1] < 0f) {
                            phi_1398_ = -(_e3152[1]);
                        } else {
                            phi_1398_ = _e3152[1];
                        }
                        let _e3163 = phi_1398_;
                        if (_e3159 > _e3163) {
                            phi_1403_ = _e3159;
                        } else {
                            phi_1403_ = _e3163;
                        }
                        let _e3166 = phi_1403_;
                        if (_e3152[2] < 0f) {
                            phi_1410_ = -(_e3152[2]);
                        } else {
                            phi_1410_ = _e3152[2];
                        }
                        let _e3170 = phi_1410_;
                        if (_e3166 > _e3170) {
                            phi_1415_ = _e3166;
                        } else {
                            phi_1415_ = _e3170;
                        }
                        let _e3173 = phi_1415_;
                        let _e3176 = local_15.member_1[1u];
                        if (_e3176[0] < 0f) {
                            phi_1429_ = -(_e3176[0]);
                        } else {
                            phi_1429_ = _e3176[0];
                        }
                        let _e3183 = phi_1429_;
                        if (_e3176[1] < 0f) {
                            phi_1436_ = -(_e3176[1]);
                        } else {
                            phi_1436_ = _e3176[1];
                        }
                        let _e3187 = phi_1436_;
                        if (_e3183 > _e3187) {
                            phi_1441_ = _e3183;
                        } else {
                            phi_1441_ = _e3187;
                        }
                        let _e3190 = phi_1441_;
                        if (_e3176[2] < 0f) {
                            phi_1448_ = -(_e3176[2]);
                        } else {
                            phi_1448_ = _e3176[2];
                        }
                        let _e3194 = phi_1448_;
                        if (_e3190 > _e3194) {
                            phi_1453_ = _e3190;
                        } else {
                            phi_1453_ = _e3194;
                        }
                        let _e3197 = phi_1453_;
                        if (_e3173 > _e3197) {
                            phi_1458_ = _e3173;
                        } else {
                            phi_1458_ = _e3197;
                        }
                        let _e3200 = phi_1458_;
                        let _e3202 = local_15.member_3;
                        let _e3206 = local_15.member_2[0u];
                        if (_e3206[0] < 0f) {
                            phi_1475_ = -(_e3206[0]);
                        } else {
                            phi_1475_ = _e3206[0];
                        }
                        let _e3213 = phi_1475_;
                        if (_e3206[1] < 0f) {
                            phi_1482_ = -(_e3206[1]);
                        } else {
                            phi_1482_ = _e3206[1];
                        }
                        let _e3217 = phi_1482_;
                        if (_e3213 > _e3217) {
                            phi_1487_ = _e3213;
                        } else {
                            phi_1487_ = _e3217;
                        }
                        let _e3220 = phi_1487_;
                        if (_e3206[2] < 0f) {
                            phi_1494_ = -(_e3206[2]);
                        } else {
                            phi_1494_ = _e3206[2];
                        }
                        let _e3224 = phi_1494_;
                        if (_e3220 > _e3224) {
                            phi_1499_ = _e3220;
                        } else {
                            phi_1499_ = _e3224;
                        }
                        let _e3227 = phi_1499_;
                        let _e3230 = local_15.member_2[1u];
                        if (_e3230[0] < 0f) {
                            phi_1513_ = -(_e3230[0]);
                        } else {
                            phi_1513_ = _e3230[0];
                        }
                        let _e3237 = phi_1513_;
                        if (_e3230[1] < 0f) {
                            phi_1520_ = -(_e3230[1]);
                        } else {
                            phi_1520_ = _e3230[1];
                        }
                        let _e3241 = phi_1520_;
                        if (_e3237 > _e3241) {
                            phi_1525_ = _e3237;
                        } else {
                            phi_1525_ = _e3241;
                        }
                        let _e3244 = phi_1525_;
                        if (_e3230[2] < 0f) {
                            phi_1532_ = -(_e3230[2]);
                        } else {
                            phi_1532_ = _e3230[2];
                        }
                        let _e3248 = phi_1532_;
                        if (_e3244 > _e3248) {
                            phi_1537_ = _e3244;
                        } else {
                            phi_1537_ = _e3248;
                        }
                        let _e3251 = phi_1537_;
                        if (_e3227 > _e3251) {
                            phi_1542_ = _e3227;
                        } else {
                            phi_1542_ = _e3251;
                        }
                        let _e3254 = phi_1542_;
                        let _e3256 = local_15.member_3;
                        let _e3263 = local_15.member_3;
                        phi_1558_ = type_28(0u, 48u);
                        phi_1561_ = 0f;
                        loop {
                            let _e3269 = phi_1558_;
                            let _e3271 = phi_1561_;
                            local_82 = _e3271;
                            local_40 = _e3271;
                            local_41 = _e3271;
                            local_42 = _e3271;
                            local_43 = _e3271;
                            if (_e3269.member < _e3269.member_1) {
                                phi_1559_ = type_28((_e3269.member + 1u), _e3269.member_1);
                                phi_1584_ = type_28(1u, _e3269.member);
                            } else {
                                phi_1559_ = _e3269;
                                phi_1584_ = type_28(0u, type_28().member_1);
                            }
                            let _e3285 = phi_1559_;
                            let _e3287 = phi_1584_;
                            if (bitcast<i32>(_e3287.member) != 0i) {
                                let _e3293 = local_15.member[0u];
                                let _e3299 = local_15.member[1u];
                                let _e3309 = (_e3293[0] + ((_e3299[0] - _e3293[0]) * _e3271));
                                let _e3310 = (_e3293[1] + ((_e3299[1] - _e3293[1]) * _e3271));
                                let _e3311 = (_e3293[2] + ((_e3299[2] - _e3293[2]) * _e3271));
                                let _e3314 = local_15.member_1[0u];
                                let _e3320 = local_15.member_1[1u];
                                let _e3330 = (_e3314[0] + ((_e3320[0] - _e3314[0]) * _e3271));
                                let _e3331 = (_e3314[1] + ((_e3320[1] - _e3314[1]) * _e3271));
                                let _e3332 = (_e3314[2] + ((_e3320[2] - _e3314[2]) * _e3271));
                                let _e3335 = local_15.member_2[0u];
                                let _e3341 = local_15.member_2[1u];
                                let _e3351 = (_e3335[0] + ((_e3341[0] - _e3335[0]) * _e3271));
                                let _e3352 = (_e3335[1] + ((_e3341[1] - _e3335[1]) * _e3271));
                                let _e3353 = (_e3335[2] + ((_e3341[2] - _e3335[2]) * _e3271));
                                let _e3358 = (((_e3330 * _e3330) + (_e3331 * _e3331)) + (_e3332 * _e3332));
                                let _e3363 = (((_e3330 * _e3351) + (_e3331 * _e3352)) + (_e3332 * _e3353));
                                let _e3368 = (((_e3351 * _e3351) + (_e3352 * _e3352)) + (_e3353 * _e3353));
                                let _e3373 = (((_e3309 * _e3330) + (_e3310 * _e3331)) + (_e3311 * _e3332));
                                let _e3378 = (((_e3309 * _e3351) + (_e3310 * _e3352)) + (_e3311 * _e3353));
                                let _e3381 = ((_e3358 * _e3368) - (_e3363 * _e3363));
                                let _e3385 = (((_e3373 * _e3368) - (_e3378 * _e3363)) / _e3381);
                                let _e3389 = (((_e3378 * _e3358) - (_e3373 * _e3363)) / _e3381);
                                if (_e3385 >= 0f) {
                                    if (_e3389 >= 0f) {
                                        if (_e3385 <= 1f) {
                                            phi_1738_ = (_e3389 <= 1f);
                                            phi_1739_ = false;
                                        } else {
                                            phi_1738_ = bool();
                                            phi_1739_ = true;
                                        }
                                        let _e3395 = phi_1738_;
                                        let _e3397 = phi_1739_;
                                        phi_1740_ = _e3395;
                                        phi_1741_ = _e3397;
                                    } else {
                                        phi_1740_ = bool();
                                        phi_1741_ = true;
                                    }
                                    let _e3399 = phi_1740_;
                                    let _e3401 = phi_1741_;
                                    phi_1742_ = _e3399;
                                    phi_1743_ = _e3401;
                                } else {
                                    phi_1742_ = bool();
                                    phi_1743_ = true;
                                }
                                let _e3403 = phi_1742_;
                                let _e3405 = phi_1743_;
                                if _e3405 {
                                    phi_1747_ = false;
                                } else {
                                    phi_1747_ = _e3403;
                                }
                                let _e3407 = phi_1747_;
                                if (_e3381 > 0f) {
                                    if _e3407 {
                                        phi_1787_ = array<f32, 3>((_e3309 - ((_e3330 * _e3385) + (_e3351 * _e3389))), (_e3310 - ((_e3331 * _e3385) + (_e3352 * _e3389))), (_e3311 - ((_e3332 * _e3385) + (_e3353 * _e3389))));
                                        phi_1788_ = false;
                                    } else {
                                        phi_1787_ = array<f32, 3>();
                                        phi_1788_ = true;
                                    }
                                    let _e3423 = phi_1787_;
                                    let _e3425 = phi_1788_;
                                    phi_1789_ = _e3423;
                                    phi_1790_ = _e3425;
                                } else {
                                    phi_1789_ = array<f32, 3>();
                                    phi_1790_ = true;
                                }
                                let _e3427 = phi_1789_;
                                let _e3429 = phi_1790_;
                                if _e3429 {
                                    let _e3430 = (_e3309 - _e3330);
                                    let _e3431 = (_e3310 - _e3331);
                                    let _e3432 = (_e3311 - _e3332);
                                    let _e3443 = ((((_e3309 * _e3330) + (_e3310 * _e3331)) + (_e3311 * _e3332)) / (((_e3330 * _e3330) + (_e3331 * _e3331)) + (_e3332 * _e3332)));
                                    if (_e3443 > 0f) {
                                        if (_e3443 < 1f) {
                                            phi_1820_ = _e3443;
                                        } else {
                                            phi_1820_ = 1f;
                                        }
                                        let _e3447 = phi_1820_;
                                        phi_1821_ = _e3447;
                                    } else {
                                        phi_1821_ = 0f;
                                    }
                                    let _e3449 = phi_1821_;
                                    let _e3466 = ((((_e3309 * _e3351) + (_e3310 * _e3352)) + (_e3311 * _e3353)) / (((_e3351 * _e3351) + (_e3352 * _e3352)) + (_e3353 * _e3353)));
                                    if (_e3466 > 0f) {
                                        if (_e3466 < 1f) {
                                            phi_1848_ = _e3466;
                                        } else {
                                            phi_1848_ = 1f;
                                        }
                                        let _e3470 = phi_1848_;
                                        phi_1849_ = _e3470;
                                    } else {
                                        phi_1849_ = 0f;
                                    }
                                    let _e3472 = phi_1849_;
                                    let _e3489 = ((((_e3430 * _e3351) + (_e3431 * _e3352)) + (_e3432 * _e3353)) / (((_e3351 * _e3351) + (_e3352 * _e3352)) + (_e3353 * _e3353)));
                                    if (_e3489 > 0f) {
                                        if (_e3489 < 1f) {
                                            phi_1876_ = _e3489;
                                        } else {
                                            phi_1876_ = 1f;
                                        }
                                        let _e3493 = phi_1876_;
                                        phi_1877_ = _e3493;
                                    } else {
                                        phi_1877_ = 0f;
                                    }
                                    let _e3495 = phi_1877_;
                                    let _e3502 = (_e3309 - _e3351);
                                    let _e3503 = (_e3310 - _e3352);
                                    let _e3504 = (_e3311 - _e3353);
                                    let _e3515 = ((((_e3502 * _e3330) + (_e3503 * _e3331)) + (_e3504 * _e3332)) / (((_e3330 * _e3330) + (_e3331 * _e3331)) + (_e3332 * _e3332)));
                                    if (_e3515 > 0f) {
                                        if (_e3515 < 1f) {
                                            phi_1907_ = _e3515;
                                        } else {
                                            phi_1907_ = 1f;
                                        }
                                        let _e3519 = phi_1907_;
                                        phi_1908_ = _e3519;
                                    } else {
                                        phi_1908_ = 0f;
                                    }
                                    let _e3521 = phi_1908_;
                                    local_11[0u] = array<f32, 3>((_e3309 - (_e3330 * _e3449)), (_e3310 - (_e3331 * _e3449)), (_e3311 - (_e3332 * _e3449)));
                                    local_11[1u] = array<f32, 3>((_e3309 - (_e3351 * _e3472)), (_e3310 - (_e3352 * _e3472)), (_e3311 - (_e3353 * _e3472)));
                                    local_11[2u] = array<f32, 3>((_e3430 - (_e3351 * _e3495)), (_e3431 - (_e3352 * _e3495)), (_e3432 - (_e3353 * _e3495)));
                                    local_11[3u] = array<f32, 3>((_e3502 - (_e3330 * _e3521)), (_e3503 - (_e3331 * _e3521)), (_e3504 - (_e3332 * _e3521)));
                                    let _e3537 = local_11[0u];
                                    phi_2051_ = type_28(1u, 4u);
                                    phi_2054_ = array<f32, 3>(_e3537[0], _e3537[1], _e3537[2]);
                                    loop {
                                        let _e3543 = phi_2051_;
                                        let _e3545 = phi_2054_;
                                        local_69 = _e3545;
                                        if (_e3543.member < _e3543.member_1) {
                                            phi_2052_ = type_28((_e3543.member + 1u), _e3543.member_1);
                                            phi_2077_ = type_28(1u, _e3543.member);
                                        } else {
                                            phi_2052_ = _e3543;
                                            phi_2077_ = type_28(0u, type_28().member_1);
                                        }
                                        let _e3559 = phi_2052_;
                                        let _e3561 = phi_2077_;
                                        let _e3565 = (bitcast<i32>(_e3561.member) != 0i);
                                        if _e3565 {
                                            if (_e3561.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3568 = local_11[_e3561.member_1];
                                            if (_e3561.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3574 = local_11[_e3561.member_1];
                                            if ((((_e3568[0] * _e3574[0]) + (_e3568[1] * _e3574[1])) + (_e3568[2] * _e3574[2])) < (((_e3545[0] * _e3545[0]) + (_e3545[1] * _e3545[1])) + (_e3545[2] * _e3545[2]))) {
                                                if (_e3561.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3597 = local_11[_e3561.member_1];
                                                phi_2144_ = array<f32, 3>(_e3597[0], _e3597[1], _e3597[2]);
                                            } else {
                                                phi_2144_ = _e3545;
                                            }
                                            let _e3603 = phi_2144_;
                                            phi_2055_ = _e3603;
                                        } else {
                                            phi_2055_ = array<f32, 3>();
                                        }
                                        let _e3605 = phi_2055_;
                                        continue;
                                        continuing {
                                            phi_2051_ = _e3559;
                                            phi_2054_ = _e3605;
                                            break if !(_e3565);
                                        }
                                    }
                                    let _e5457 = local_69;
                                    phi_2145_ = _e5457;
                                } else {
                                    phi_2145_ = _e3427;
                                }
                                let _e3608 = phi_2145_;
                                if (_e3608[0] < 0f) {
                                    phi_2152_ = -(_e3608[0]);
                                } else {
                                    phi_2152_ = _e3608[0];
                                }
                                let _e3613 = phi_2152_;
                                if (_e3608[1] < 0f) {
                                    phi_2159_ = -(_e3608[1]);
                                } else {
                                    phi_2159_ = _e3608[1];
                                }
                                let _e3618 = phi_2159_;
                                if (_e3608[2] < 0f) {
                                    phi_2167_ = -(_e3608[2]);
                                } else {
                                    phi_2167_ = _e3608[2];
                                }
                                let _e3624 = phi_2167_;
                                let _e3625 = ((_e3613 + _e3618) + _e3624);
                                if (_e3625 > 0f) {
                                    if ((bitcast<u32>(_e3625) & 2139095040u) != 2139095040u) {
                                        let _e3630 = (1f / _e3625);
                                        let _e3632 = (_e3608[0] * _e3630);
                                        let _e3634 = (_e3608[1] * _e3630);
                                        let _e3636 = (_e3608[2] * _e3630);
                                        let _e3641 = (((_e3632 * _e3632) + (_e3634 * _e3634)) + (_e3636 * _e3636));
                                        if (_e3641 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3641 > 0f) {
                                                phi_2204_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2204_ = 0f;
                                            }
                                            let _e3700 = phi_2204_;
                                            phi_2268_ = _e3700;
                                        } else {
                                            phi_2211_ = type_26(0i, 5i);
                                            phi_2214_ = bitcast<f32>(((bitcast<u32>(_e3641) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3649 = phi_2211_;
                                                let _e3651 = phi_2214_;
                                                local_34 = _e3651;
                                                if (_e3649.member < _e3649.member_1) {
                                                    let _e3659 = (_e3649.member + 1i);
                                                    if ((false == (_e3659 > _e3649.member)) != false) {
                                                        phi_2235_ = true;
                                                    } else {
                                                        phi_2235_ = false;
                                                    }
                                                    let _e3664 = phi_2235_;
                                                    if _e3664 {
                                                        phi_2241_ = type_27(0u, type_27().member_1);
                                                    } else {
                                                        phi_2241_ = type_27(1u, _e3659);
                                                    }
                                                    let _e3670 = phi_2241_;
                                                    if (bitcast<i32>(_e3670.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2212_ = type_26(_e3670.member_1, _e3649.member_1);
                                                    phi_2255_ = type_27(1u, _e3649.member);
                                                } else {
                                                    phi_2212_ = _e3649;
                                                    phi_2255_ = type_27(0u, type_27().member_1);
                                                }
                                                let _e3680 = phi_2212_;
                                                let _e3682 = phi_2255_;
                                                let _e3685 = (bitcast<i32>(_e3682.member) != 0i);
                                                if _e3685 {
                                                    phi_2215_ = (0.5f * (_e3651 + (_e3641 / _e3651)));
                                                } else {
                                                    phi_2215_ = f32();
                                                }
                                                let _e3690 = phi_2215_;
                                                continue;
                                                continuing {
                                                    phi_2211_ = _e3680;
                                                    phi_2214_ = _e3690;
                                                    break if !(_e3685);
                                                }
                                            }
                                            let _e3695 = local_34;
                                            phi_2268_ = (_e3695 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3702 = phi_2268_;
                                        phi_2277_ = type_28(0u, 4u);
                                        phi_2280_ = 2f;
                                        loop {
                                            let _e3710 = phi_2277_;
                                            let _e3712 = phi_2280_;
                                            local_36 = _e3712;
                                            local_37 = _e3712;
                                            local_38 = _e3712;
                                            local_72 = _e3712;
                                            local_73 = _e3712;
                                            if (_e3710.member < _e3710.member_1) {
                                                phi_2278_ = type_28((_e3710.member + 1u), _e3710.member_1);
                                                phi_2303_ = type_28(1u, _e3710.member);
                                            } else {
                                                phi_2278_ = _e3710;
                                                phi_2303_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e3726 = phi_2278_;
                                            let _e3728 = phi_2303_;
                                            if (bitcast<i32>(_e3728.member) != 0i) {
                                                if (_e3728.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3735 = local_12[_e3728.member_1];
                                                let _e3743 = (((_e3632 * _e3735[0]) + (_e3634 * _e3735[1])) + (_e3636 * _e3735[2]));
                                                if (_e3728.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3746 = local_13[_e3728.member_1];
                                                let _e3754 = (((_e3632 * _e3746[0]) + (_e3634 * _e3746[1])) + (_e3636 * _e3746[2]));
                                                if (_e3743 < 0f) {
                                                    phi_2354_ = -(_e3743);
                                                } else {
                                                    phi_2354_ = _e3743;
                                                }
                                                let _e3758 = phi_2354_;
                                                if (_e3754 < 0f) {
                                                    phi_2360_ = -(_e3754);
                                                } else {
                                                    phi_2360_ = _e3754;
                                                }
                                                let _e3762 = phi_2360_;
                                                let _e3766 = (((((((((_e3146 + _e3148) + (_e3200 + _e3202)) + (_e3254 + _e3256)) * (0.000000059604645f * 16f)) + (_e3263 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e267 * _e3702) * (1f + (0.000000059604645f * 8f)))) + ((_e3758 + _e3762) * (0.000000059604645f * 8f)));
                                                if (_e3743 > _e3766) {
                                                    if (_e3754 > _e3766) {
                                                        phi_2373_ = false;
                                                    } else {
                                                        phi_2373_ = true;
                                                    }
                                                    let _e3770 = phi_2373_;
                                                    phi_2374_ = _e3770;
                                                } else {
                                                    phi_2374_ = true;
                                                }
                                                let _e3772 = phi_2374_;
                                                if _e3772 {
                                                    if ((_e3743 + ((_e3754 - _e3743) * _e3271)) > _e3766) {
                                                        if (_e3754 < _e3743) {
                                                            let _e3780 = ((_e3743 - _e3754) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                            if _e3780 {
                                                                let _e3786 = (((_e3743 - _e3766) / (_e3743 - _e3754)) * (1f - (0.000000059604645f * 16f)));
                                                                if (_e3712 < _e3786) {
                                                                    phi_2405_ = _e3712;
                                                                } else {
                                                                    phi_2405_ = _e3786;
                                                                }
                                                                let _e3789 = phi_2405_;
                                                                phi_2406_ = _e3789;
                                                            } else {
                                                                phi_2406_ = f32();
                                                            }
                                                            let _e3791 = phi_2406_;
                                                            phi_2407_ = _e3791;
                                                            phi_2408_ = _e3780;
                                                        } else {
                                                            phi_2407_ = _e3712;
                                                            phi_2408_ = true;
                                                        }
                                                        let _e3793 = phi_2407_;
                                                        let _e3795 = phi_2408_;
                                                        if _e3795 {
                                                            phi_2412_ = false;
                                                        } else {
                                                            phi_2412_ = true;
                                                        }
                                                        let _e3797 = phi_2412_;
                                                        phi_2413_ = _e3793;
                                                        phi_2414_ = _e3795;
                                                        phi_2415_ = _e3797;
                                                        phi_2416_ = false;
                                                    } else {
                                                        phi_2413_ = f32();
                                                        phi_2414_ = false;
                                                        phi_2415_ = false;
                                                        phi_2416_ = true;
                                                    }
                                                    let _e3799 = phi_2413_;
                                                    let _e3801 = phi_2414_;
                                                    let _e3803 = phi_2415_;
                                                    let _e3805 = phi_2416_;
                                                    phi_2417_ = _e3799;
                                                    phi_2418_ = _e3801;
                                                    phi_2419_ = _e3803;
                                                    phi_2420_ = _e3805;
                                                } else {
                                                    phi_2417_ = _e3712;
                                                    phi_2418_ = true;
                                                    phi_2419_ = false;
                                                    phi_2420_ = false;
                                                }
                                                let _e3807 = phi_2417_;
                                                let _e3809 = phi_2418_;
                                                let _e3811 = phi_2419_;
                                                let _e3813 = phi_2420_;
                                                phi_2281_ = _e3807;
                                                phi_2421_ = _e3809;
                                                phi_2422_ = false;
                                                phi_2423_ = _e3811;
                                                phi_2424_ = _e3813;
                                            } else {
                                                phi_2281_ = f32();
                                                phi_2421_ = false;
                                                phi_2422_ = true;
                                                phi_2423_ = false;
                                                phi_2424_ = false;
                                            }
                                            let _e3815 = phi_2281_;
                                            let _e3817 = phi_2421_;
                                            let _e3819 = phi_2422_;
                                            let _e3821 = phi_2423_;
                                            let _e3823 = phi_2424_;
                                            local_35 = _e3819;
                                            local_70 = _e3821;
                                            local_71 = _e3823;
                                            continue;
                                            continuing {
                                                phi_2277_ = _e3726;
                                                phi_2280_ = _e3815;
                                                break if !(_e3817);
                                            }
                                        }
                                        let _e3826 = local_35;
                                        if _e3826 {
                                            let _e3828 = local_36;
                                            let _e3829 = (_e3828 > 1f);
                                            if _e3829 {
                                                phi_2445_ = false;
                                                phi_2446_ = false;
                                                phi_2447_ = false;
                                            } else {
                                                let _e3831 = local_37;
                                                if (_e3831 > _e3271) {
                                                    let _e3834 = local_38;
                                                    let _e3836 = ((_e3834 - _e3271) < 0.00000000023283064f);
                                                    if _e3836 {
                                                        phi_2441_ = false;
                                                    } else {
                                                        phi_2441_ = true;
                                                    }
                                                    let _e3838 = phi_2441_;
                                                    phi_2442_ = _e3838;
                                                    phi_2443_ = _e3836;
                                                    phi_2444_ = false;
                                                } else {
                                                    phi_2442_ = false;
                                                    phi_2443_ = false;
                                                    phi_2444_ = true;
                                                }
                                                let _e3840 = phi_2442_;
                                                let _e3842 = phi_2443_;
                                                let _e3844 = phi_2444_;
                                                phi_2445_ = _e3840;
                                                phi_2446_ = _e3842;
                                                phi_2447_ = _e3844;
                                            }
                                            let _e3846 = phi_2445_;
                                            let _e3848 = phi_2446_;
                                            let _e3850 = phi_2447_;
                                            phi_2448_ = _e3846;
                                            phi_2449_ = _e3829;
                                            phi_2450_ = _e3848;
                                            phi_2451_ = _e3850;
                                            phi_2452_ = false;
                                            phi_2453_ = false;
                                        } else {
                                            phi_2448_ = false;
                                            phi_2449_ = false;
                                            phi_2450_ = false;
                                            phi_2451_ = false;
                                            let _e5514 = local_70;
                                            phi_2452_ = _e5514;
                                            let _e5517 = local_71;
                                            phi_2453_ = _e5517;
                                        }
                                        let _e3852 = phi_2448_;
                                        let _e3854 = phi_2449_;
                                        let _e3856 = phi_2450_;
                                        let _e3858 = phi_2451_;
                                        let _e3860 = phi_2452_;
                                        let _e3862 = phi_2453_;
                                        let _e5520 = local_72;
                                        phi_2454_ = _e5520;
                                        let _e5523 = local_73;
                                        phi_2455_ = _e5523;
                                        phi_2456_ = _e3852;
                                        phi_2457_ = _e3854;
                                        phi_2458_ = _e3856;
                                        phi_2459_ = _e3858;
                                        phi_2460_ = _e3860;
                                        phi_2461_ = _e3862;
                                        phi_2462_ = false;
                                    } else {
                                        phi_2454_ = f32();
                                        phi_2455_ = f32();
                                        phi_2456_ = false;
                                        phi_2457_ = false;
                                        phi_2458_ = false;
                                        phi_2459_ = false;
                                        phi_2460_ = false;
                                        phi_2461_ = false;
                                        phi_2462_ = true;
                                    }
                                    let _e3864 = phi_2454_;
                                    let _e3866 = phi_2455_;
                                    let _e3868 = phi_2456_;
                                    let _e3870 = phi_2457_;
                                    let _e3872 = phi_2458_;
                                    let _e3874 = phi_2459_;
                                    let _e3876 = phi_2460_;
                                    let _e3878 = phi_2461_;
                                    let _e3880 = phi_2462_;
                                    phi_2463_ = _e3864;
                                    phi_2464_ = _e3866;
                                    phi_2465_ = _e3868;
                                    phi_2466_ = _e3870;
                                    phi_2467_ = _e3872;
                                    phi_2468_ = _e3874;
                                    phi_2469_ = _e3876;
                                    phi_2470_ = _e3878;
                                    phi_2471_ = _e3880;
                                    phi_2472_ = false;
                                } else {
                                    phi_2463_ = f32();
                                    phi_2464_ = f32();
                                    phi_2465_ = false;
                                    phi_2466_ = false;
                                    phi_2467_ = false;
                                    phi_2468_ = false;
                                    phi_2469_ = false;
                                    phi_2470_ = false;
                                    phi_2471_ = false;
                                    phi_2472_ = true;
                                }
                                let _e3882 = phi_2463_;
                                let _e3884 = phi_2464_;
                                let _e3886 = phi_2465_;
                                let _e3888 = phi_2466_;
                                let _e3890 = phi_2467_;
                                let _e3892 = phi_2468_;
                                let _e3894 = phi_2469_;
                                let _e3896 = phi_2470_;
                                let _e3898 = phi_2471_;
                                let _e3900 = phi_2472_;
                                phi_2473_ = _e3882;
                                phi_1562_ = _e3884;
                                phi_2474_ = _e3886;
                                phi_2475_ = _e3888;
                                phi_2476_ = _e3890;
                                phi_2477_ = false;
                                phi_2478_ = _e3892;
                                phi_2479_ = _e3894;
                                phi_2480_ = _e3896;
                                phi_2481_ = _e3898;
                                phi_2482_ = _e3900;
                            } else {
                                phi_2473_ = f32();
                                phi_1562_ = f32();
                                phi_2474_ = false;
                                phi_2475_ = false;
                                phi_2476_ = false;
                                phi_2477_ = true;
                                phi_2478_ = false;
                                phi_2479_ = false;
                                phi_2480_ = false;
                                phi_2481_ = false;
                                phi_2482_ = false;
                            }
                            let _e3902 = phi_2473_;
                            let _e3904 = phi_1562_;
                            let _e3906 = phi_2474_;
                            let _e3908 = phi_2475_;
                            let _e3910 = phi_2476_;
                            let _e3912 = phi_2477_;
                            let _e3914 = phi_2478_;
                            let _e3916 = phi_2479_;
                            let _e3918 = phi_2480_;
                            let _e3920 = phi_2481_;
                            let _e3922 = phi_2482_;
                            local_39 = _e3908;
                            local_74 = _e3910;
                            local_75 = _e3912;
                            local_76 = _e3914;
                            local_77 = _e3916;
                            local_78 = _e3918;
                            local_79 = _e3920;
                            local_80 = _e3922;
                            local_81 = _e3902;
                            local_83 = _e3908;
                            continue;
                            continuing {
                                phi_1558_ = _e3285;
                                phi_1561_ = _e3904;
                                break if !(_e3906);
                            }
                        }
                        let _e3925 = local_39;
                        if _e3925 {
                            phi_2487_ = type_55(0u, type_55().member_1);
                            phi_2488_ = false;
                            phi_2489_ = false;
                            phi_2490_ = false;
                            phi_2491_ = false;
                            phi_2492_ = false;
                            phi_2493_ = false;
                            phi_2494_ = false;
                        } else {
                            phi_2487_ = type_55();
                            let _e5556 = local_74;
                            phi_2488_ = _e5556;
                            let _e5559 = local_75;
                            phi_2489_ = _e5559;
                            let _e5562 = local_76;
                            phi_2490_ = _e5562;
                            let _e5565 = local_77;
                            phi_2491_ = _e5565;
                            let _e5568 = local_78;
                            phi_2492_ = _e5568;
                            let _e5571 = local_79;
                            phi_2493_ = _e5571;
                            let _e5574 = local_80;
                            phi_2494_ = _e5574;
                        }
                        let _e3930 = phi_2487_;
                        let _e3932 = phi_2488_;
                        let _e3934 = phi_2489_;
                        let _e3936 = phi_2490_;
                        let _e3938 = phi_2491_;
                        let _e3940 = phi_2492_;
                        let _e3942 = phi_2493_;
                        let _e3944 = phi_2494_;
                        if _e3932 {
                            let _e5577 = local_81;
                            phi_2498_ = _e5577;
                            phi_2499_ = true;
                            phi_2500_ = false;
                            phi_2501_ = false;
                            phi_2502_ = false;
                            phi_2503_ = false;
                            phi_2504_ = false;
                            phi_2505_ = false;
                        } else {
                            let _e5579 = local_82;
                            phi_2498_ = _e5579;
                            phi_2499_ = _e3934;
                            phi_2500_ = _e3936;
                            phi_2501_ = _e3938;
                            phi_2502_ = _e3940;
                            let _e5586 = local_83;
                            phi_2503_ = _e5586;
                            phi_2504_ = _e3942;
                            phi_2505_ = _e3944;
                        }
                        let _e3946 = phi_2498_;
                        let _e3948 = phi_2499_;
                        let _e3950 = phi_2500_;
                        let _e3952 = phi_2501_;
                        let _e3954 = phi_2502_;
                        let _e3956 = phi_2503_;
                        let _e3958 = phi_2504_;
                        let _e3960 = phi_2505_;
                        if _e3948 {
                            phi_2510_ = type_55(1u, _e3946);
                            phi_2511_ = false;
                            phi_2512_ = false;
                            phi_2513_ = false;
                            phi_2514_ = false;
                            phi_2515_ = false;
                            phi_2516_ = false;
                        } else {
                            phi_2510_ = type_55();
                            phi_2511_ = _e3950;
                            phi_2512_ = _e3952;
                            phi_2513_ = _e3954;
                            phi_2514_ = _e3956;
                            phi_2515_ = _e3958;
                            phi_2516_ = _e3960;
                        }
                        let _e3963 = phi_2510_;
                        let _e3965 = phi_2511_;
                        let _e3967 = phi_2512_;
                        let _e3969 = phi_2513_;
                        let _e3971 = phi_2514_;
                        let _e3973 = phi_2515_;
                        let _e3975 = phi_2516_;
                        if _e3965 {
                            let _e3977 = local_40;
                            phi_2521_ = type_55(1u, _e3977);
                            phi_2522_ = false;
                            phi_2523_ = false;
                            phi_2524_ = true;
                            phi_2525_ = false;
                            phi_2526_ = false;
                        } else {
                            phi_2521_ = _e3930;
                            phi_2522_ = _e3967;
                            phi_2523_ = _e3969;
                            phi_2524_ = _e3971;
                            phi_2525_ = _e3973;
                            phi_2526_ = _e3975;
                        }
                        let _e3980 = phi_2521_;
                        let _e3982 = phi_2522_;
                        let _e3984 = phi_2523_;
                        let _e3986 = phi_2524_;
                        let _e3988 = phi_2525_;
                        let _e3990 = phi_2526_;
                        if _e3982 {
                            let _e3992 = local_41;
                            phi_2531_ = type_55(1u, _e3992);
                            phi_2532_ = false;
                            phi_2533_ = false;
                            phi_2534_ = false;
                            phi_2535_ = false;
                        } else {
                            phi_2531_ = type_55();
                            phi_2532_ = _e3984;
                            phi_2533_ = _e3986;
                            phi_2534_ = _e3988;
                            phi_2535_ = _e3990;
                        }
                        let _e3995 = phi_2531_;
                        let _e3997 = phi_2532_;
                        let _e3999 = phi_2533_;
                        let _e4001 = phi_2534_;
                        let _e4003 = phi_2535_;
                        if _e3997 {
                            let _e4005 = local_42;
                            phi_2540_ = type_55(1u, _e4005);
                            phi_2541_ = true;
                            phi_2542_ = false;
                            phi_2543_ = false;
                            phi_2544_ = false;
                        } else {
                            phi_2540_ = _e3995;
                            phi_2541_ = _e3982;
                            phi_2542_ = _e3999;
                            phi_2543_ = _e4001;
                            phi_2544_ = _e4003;
                        }
                        let _e4008 = phi_2540_;
                        let _e4010 = phi_2541_;
                        let _e4012 = phi_2542_;
                        let _e4014 = phi_2543_;
                        let _e4016 = phi_2544_;
                        if _e4010 {
                            phi_2548_ = _e4008;
                            phi_2549_ = true;
                            phi_2550_ = false;
                            phi_2551_ = false;
                        } else {
                            phi_2548_ = _e3980;
                            phi_2549_ = _e4012;
                            phi_2550_ = _e4014;
                            phi_2551_ = _e4016;
                        }
                        let _e4018 = phi_2548_;
                        let _e4020 = phi_2549_;
                        let _e4022 = phi_2550_;
                        let _e4024 = phi_2551_;
                        if _e4020 {
                            phi_2555_ = false;
                            phi_2556_ = false;
                        } else {
                            phi_2555_ = _e4022;
                            phi_2556_ = _e4024;
                        }
                        let _e4026 = phi_2555_;
                        let _e4028 = phi_2556_;
                        if _e4026 {
                            phi_2560_ = false;
                            phi_2561_ = false;
                        } else {
                            phi_2560_ = _e4028;
                            phi_2561_ = _e4020;
                        }
                        let _e4030 = phi_2560_;
                        let _e4032 = phi_2561_;
                        if _e4030 {
                            phi_2565_ = true;
                            phi_2566_ = false;
                        } else {
                            phi_2565_ = _e4026;
                            phi_2566_ = _e4032;
                        }
                        let _e4034 = phi_2565_;
                        let _e4036 = phi_2566_;
                        if _e4034 {
                            let _e4038 = local_43;
                            phi_2571_ = type_55(1u, _e4038);
                            phi_2572_ = true;
                        } else {
                            phi_2571_ = _e4018;
                            phi_2572_ = _e4036;
                        }
                        let _e4041 = phi_2571_;
                        let _e4043 = phi_2572_;
                        if _e4043 {
                            phi_2576_ = _e4041;
                        } else {
                            phi_2576_ = _e3963;
                        }
                        let _e4045 = phi_2576_;
                        if (_e4045.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_2590_ = type_28(0u, 3u);
                            loop {
                                let _e4058 = phi_2590_;
                                if (_e4058.member < _e4058.member_1) {
                                    phi_2591_ = type_28((_e4058.member + 1u), _e4058.member_1);
                                    phi_2614_ = type_28(1u, _e4058.member);
                                } else {
                                    phi_2591_ = _e4058;
                                    phi_2614_ = type_28(0u, type_28().member_1);
                                }
                                let _e4072 = phi_2591_;
                                let _e4074 = phi_2614_;
                                if (bitcast<i32>(_e4074.member) != 0i) {
                                    if (_e4074.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4081 = local_14[_e4074.member_1];
                                    let _e4082 = (_e4045.member_1 + _e4081);
                                    if (_e4082 < 1f) {
                                        phi_2634_ = _e4082;
                                    } else {
                                        phi_2634_ = 1f;
                                    }
                                    let _e4085 = phi_2634_;
                                    let _e4088 = local_15.member[0u];
                                    let _e4094 = local_15.member[1u];
                                    let _e4104 = (_e4088[0] + ((_e4094[0] - _e4088[0]) * _e4085));
                                    let _e4105 = (_e4088[1] + ((_e4094[1] - _e4088[1]) * _e4085));
                                    let _e4106 = (_e4088[2] + ((_e4094[2] - _e4088[2]) * _e4085));
                                    let _e4109 = local_15.member_1[0u];
                                    let _e4115 = local_15.member_1[1u];
                                    let _e4125 = (_e4109[0] + ((_e4115[0] - _e4109[0]) * _e4085));
                                    let _e4126 = (_e4109[1] + ((_e4115[1] - _e4109[1]) * _e4085));
                                    let _e4127 = (_e4109[2] + ((_e4115[2] - _e4109[2]) * _e4085));
                                    let _e4130 = local_15.member_2[0u];
                                    let _e4136 = local_15.member_2[1u];
                                    let _e4146 = (_e4130[0] + ((_e4136[0] - _e4130[0]) * _e4085));
                                    let _e4147 = (_e4130[1] + ((_e4136[1] - _e4130[1]) * _e4085));
                                    let _e4148 = (_e4130[2] + ((_e4136[2] - _e4130[2]) * _e4085));
                                    let _e4153 = (((_e4125 * _e4125) + (_e4126 * _e4126)) + (_e4127 * _e4127));
                                    let _e4158 = (((_e4125 * _e4146) + (_e4126 * _e4147)) + (_e4127 * _e4148));
                                    let _e4163 = (((_e4146 * _e4146) + (_e4147 * _e4147)) + (_e4148 * _e4148));
                                    let _e4168 = (((_e4104 * _e4125) + (_e4105 * _e4126)) + (_e4106 * _e4127));
                                    let _e4173 = (((_e4104 * _e4146) + (_e4105 * _e4147)) + (_e4106 * _e4148));
                                    let _e4176 = ((_e4153 * _e4163) - (_e4158 * _e4158));
                                    let _e4180 = (((_e4168 * _e4163) - (_e4173 * _e4158)) / _e4176);
                                    let _e4184 = (((_e4173 * _e4153) - (_e4168 * _e4158)) / _e4176);
                                    if (_e4180 >= 0f) {
                                        if (_e4184 >= 0f) {
                                            if (_e4180 <= 1f) {
                                                phi_2782_ = (_e4184 <= 1f);
                                                phi_2783_ = false;
                                            } else {
                                                phi_2782_ = bool();
                                                phi_2783_ = true;
                                            }
                                            let _e4190 = phi_2782_;
                                            let _e4192 = phi_2783_;
                                            phi_2784_ = _e4190;
                                            phi_2785_ = _e4192;
                                        } else {
                                            phi_2784_ = bool();
                                            phi_2785_ = true;
                                        }
                                        let _e4194 = phi_2784_;
                                        let _e4196 = phi_2785_;
                                        phi_2786_ = _e4194;
                                        phi_2787_ = _e4196;
                                    } else {
                                        phi_2786_ = bool();
                                        phi_2787_ = true;
                                    }
                                    let _e4198 = phi_2786_;
                                    let _e4200 = phi_2787_;
                                    if _e4200 {
                                        phi_2791_ = false;
                                    } else {
                                        phi_2791_ = _e4198;
                                    }
                                    let _e4202 = phi_2791_;
                                    if (_e4176 > 0f) {
                                        if _e4202 {
                                            phi_2831_ = array<f32, 3>((_e4104 - ((_e4125 * _e4180) + (_e4146 * _e4184))), (_e4105 - ((_e4126 * _e4180) + (_e4147 * _e4184))), (_e4106 - ((_e4127 * _e4180) + (_e4148 * _e4184))));
                                            phi_2832_ = false;
                                        } else {
                                            phi_2831_ = array<f32, 3>();
                                            phi_2832_ = true;
                                        }
                                        let _e4218 = phi_2831_;
                                        let _e4220 = phi_2832_;
                                        phi_2833_ = _e4218;
                                        phi_2834_ = _e4220;
                                    } else {
                                        phi_2833_ = array<f32, 3>();
                                        phi_2834_ = true;
                                    }
                                    let _e4222 = phi_2833_;
                                    let _e4224 = phi_2834_;
                                    if _e4224 {
                                        let _e4225 = (_e4104 - _e4125);
                                        let _e4226 = (_e4105 - _e4126);
                                        let _e4227 = (_e4106 - _e4127);
                                        let _e4238 = ((((_e4104 * _e4125) + (_e4105 * _e4126)) + (_e4106 * _e4127)) / (((_e4125 * _e4125) + (_e4126 * _e4126)) + (_e4127 * _e4127)));
                                        if (_e4238 > 0f) {
                                            if (_e4238 < 1f) {
                                                phi_2864_ = _e4238;
                                            } else {
                                                phi_2864_ = 1f;
                                            }
                                            let _e4242 = phi_2864_;
                                            phi_2865_ = _e4242;
                                        } else {
                                            phi_2865_ = 0f;
                                        }
                                        let _e4244 = phi_2865_;
                                        let _e4261 = ((((_e4104 * _e4146) + (_e4105 * _e4147)) + (_e4106 * _e4148)) / (((_e4146 * _e4146) + (_e4147 * _e4147)) + (_e4148 * _e4148)));
                                        if (_e4261 > 0f) {
                                            if (_e4261 < 1f) {
                                                phi_2892_ = _e4261;
                                            } else {
                                                phi_2892_ = 1f;
                                            }
                                            let _e4265 = phi_2892_;
                                            phi_2893_ = _e4265;
                                        } else {
                                            phi_2893_ = 0f;
                                        }
                                        let _e4267 = phi_2893_;
                                        let _e4284 = ((((_e4225 * _e4146) + (_e4226 * _e4147)) + (_e4227 * _e4148)) / (((_e4146 * _e4146) + (_e4147 * _e4147)) + (_e4148 * _e4148)));
                                        if (_e4284 > 0f) {
                                            if (_e4284 < 1f) {
                                                phi_2920_ = _e4284;
                                            } else {
                                                phi_2920_ = 1f;
                                            }
                                            let _e4288 = phi_2920_;
                                            phi_2921_ = _e4288;
                                        } else {
                                            phi_2921_ = 0f;
                                        }
                                        let _e4290 = phi_2921_;
                                        let _e4297 = (_e4104 - _e4146);
                                        let _e4298 = (_e4105 - _e4147);
                                        let _e4299 = (_e4106 - _e4148);
                                        let _e4310 = ((((_e4297 * _e4125) + (_e4298 * _e4126)) + (_e4299 * _e4127)) / (((_e4125 * _e4125) + (_e4126 * _e4126)) + (_e4127 * _e4127)));
                                        if (_e4310 > 0f) {
                                            if (_e4310 < 1f) {
                                                phi_2951_ = _e4310;
                                            } else {
                                                phi_2951_ = 1f;
                                            }
                                            let _e4314 = phi_2951_;
                                            phi_2952_ = _e4314;
                                        } else {
                                            phi_2952_ = 0f;
                                        }
                                        let _e4316 = phi_2952_;
                                        local_10[0u] = array<f32, 3>((_e4104 - (_e4125 * _e4244)), (_e4105 - (_e4126 * _e4244)), (_e4106 - (_e4127 * _e4244)));
                                        local_10[1u] = array<f32, 3>((_e4104 - (_e4146 * _e4267)), (_e4105 - (_e4147 * _e4267)), (_e4106 - (_e4148 * _e4267)));
                                        local_10[2u] = array<f32, 3>((_e4225 - (_e4146 * _e4290)), (_e4226 - (_e4147 * _e4290)), (_e4227 - (_e4148 * _e4290)));
                                        local_10[3u] = array<f32, 3>((_e4297 - (_e4125 * _e4316)), (_e4298 - (_e4126 * _e4316)), (_e4299 - (_e4127 * _e4316)));
                                        let _e4332 = local_10[0u];
                                        phi_3095_ = type_28(1u, 4u);
                                        phi_3098_ = array<f32, 3>(_e4332[0], _e4332[1], _e4332[2]);
                                        loop {
                                            let _e4338 = phi_3095_;
                                            let _e4340 = phi_3098_;
                                            local_84 = _e4340;
                                            if (_e4338.member < _e4338.member_1) {
                                                phi_3096_ = type_28((_e4338.member + 1u), _e4338.member_1);
                                                phi_3121_ = type_28(1u, _e4338.member);
                                            } else {
                                                phi_3096_ = _e4338;
                                                phi_3121_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4354 = phi_3096_;
                                            let _e4356 = phi_3121_;
                                            let _e4360 = (bitcast<i32>(_e4356.member) != 0i);
                                            if _e4360 {
                                                if (_e4356.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4363 = local_10[_e4356.member_1];
                                                if (_e4356.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4369 = local_10[_e4356.member_1];
                                                if ((((_e4363[0] * _e4369[0]) + (_e4363[1] * _e4369[1])) + (_e4363[2] * _e4369[2])) < (((_e4340[0] * _e4340[0]) + (_e4340[1] * _e4340[1])) + (_e4340[2] * _e4340[2]))) {
                                                    if (_e4356.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4392 = local_10[_e4356.member_1];
                                                    phi_3188_ = array<f32, 3>(_e4392[0], _e4392[1], _e4392[2]);
                                                } else {
                                                    phi_3188_ = _e4340;
                                                }
                                                let _e4398 = phi_3188_;
                                                phi_3099_ = _e4398;
                                            } else {
                                                phi_3099_ = array<f32, 3>();
                                            }
                                            let _e4400 = phi_3099_;
                                            continue;
                                            continuing {
                                                phi_3095_ = _e4354;
                                                phi_3098_ = _e4400;
                                                break if !(_e4360);
                                            }
                                        }
                                        let _e5660 = local_84;
                                        phi_3189_ = _e5660;
                                    } else {
                                        phi_3189_ = _e4222;
                                    }
                                    let _e4403 = phi_3189_;
                                    let _e4414 = (((_e4403[0] * _e4403[0]) + (_e4403[1] * _e4403[1])) + (_e4403[2] * _e4403[2]));
                                    if (_e4414 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4414 > 0f) {
                                            phi_3214_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3214_ = 0f;
                                        }
                                        let _e4473 = phi_3214_;
                                        phi_3278_ = _e4473;
                                    } else {
                                        phi_3221_ = type_26(0i, 5i);
                                        phi_3224_ = bitcast<f32>(((bitcast<u32>(_e4414) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4422 = phi_3221_;
                                            let _e4424 = phi_3224_;
                                            local_44 = _e4424;
                                            if (_e4422.member < _e4422.member_1) {
                                                let _e4432 = (_e4422.member + 1i);
                                                if ((false == (_e4432 > _e4422.member)) != false) {
                                                    phi_3245_ = true;
                                                } else {
                                                    phi_3245_ = false;
                                                }
                                                let _e4437 = phi_3245_;
                                                if _e4437 {
                                                    phi_3251_ = type_27(0u, type_27().member_1);
                                                } else {
                                                    phi_3251_ = type_27(1u, _e4432);
                                                }
                                                let _e4443 = phi_3251_;
                                                if (bitcast<i32>(_e4443.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3222_ = type_26(_e4443.member_1, _e4422.member_1);
                                                phi_3265_ = type_27(1u, _e4422.member);
                                            } else {
                                                phi_3222_ = _e4422;
                                                phi_3265_ = type_27(0u, type_27().member_1);
                                            }
                                            let _e4453 = phi_3222_;
                                            let _e4455 = phi_3265_;
                                            let _e4458 = (bitcast<i32>(_e4455.member) != 0i);
                                            if _e4458 {
                                                phi_3225_ = (0.5f * (_e4424 + (_e4414 / _e4424)));
                                            } else {
                                                phi_3225_ = f32();
                                            }
                                            let _e4463 = phi_3225_;
                                            continue;
                                            continuing {
                                                phi_3221_ = _e4453;
                                                phi_3224_ = _e4463;
                                                break if !(_e4458);
                                            }
                                        }
                                        let _e4468 = local_44;
                                        phi_3278_ = (_e4468 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e4475 = phi_3278_;
                                    let _e4481 = local_15.member[0u];
                                    if (_e4481[0] < 0f) {
                                        phi_3294_ = -(_e4481[0]);
                                    } else {
                                        phi_3294_ = _e4481[0];
                                    }
                                    let _e4488 = phi_3294_;
                                    if (_e4481[1] < 0f) {
                                        phi_3301_ = -(_e4481[1]);
                                    } else {
                                        phi_3301_ = _e4481[1];
                                    }
                                    let _e4492 = phi_3301_;
                                    if (_e4488 > _e4492) {
                                        phi_3306_ = _e4488;
                                    } else {
                                        phi_3306_ = _e4492;
                                    }
                                    let _e4495 = phi_3306_;
                                    if (_e4481[2] < 0f) {
                                        phi_3313_ = -(_e4481[2]);
                                    } else {
                                        phi_3313_ = _e4481[2];
                                    }
                                    let _e4499 = phi_3313_;
                                    if (_e4495 > _e4499) {
                                        phi_3318_ = _e4495;
                                    } else {
                                        phi_3318_ = _e4499;
                                    }
                                    let _e4502 = phi_3318_;
                                    let _e4505 = local_15.member[1u];
                                    if (_e4505[0] < 0f) {
                                        phi_3331_ = -(_e4505[0]);
                                    } else {
                                        phi_3331_ = _e4505[0];
                                    }
                                    let _e4512 = phi_3331_;
                                    if (_e4505[1] < 0f) {
                                        phi_3338_ = -(_e4505[1]);
                                    } else {
                                        phi_3338_ = _e4505[1];
                                    }
                                    let _e4516 = phi_3338_;
                                    if (_e4512 > _e4516) {
                                        phi_3343_ = _e4512;
                                    } else {
                                        phi_3343_ = _e4516;
                                    }
                                    let _e4519 = phi_3343_;
                                    if (_e4505[2] < 0f) {
                                        phi_3350_ = -(_e4505[2]);
                                    } else {
                                        phi_3350_ = _e4505[2];
                                    }
                                    let _e4523 = phi_3350_;
                                    if (_e4519 > _e4523) {
                                        phi_3355_ = _e4519;
                                    } else {
                                        phi_3355_ = _e4523;
                                    }
                                    let _e4526 = phi_3355_;
                                    if (_e4502 > _e4526) {
                                        phi_3360_ = _e4502;
                                    } else {
                                        phi_3360_ = _e4526;
                                    }
                                    let _e4529 = phi_3360_;
                                    let _e4531 = local_15.member_3;
                                    let _e4535 = local_15.member_1[0u];
                                    if (_e4535[0] < 0f) {
                                        phi_3377_ = -(_e4535[0]);
                                    } else {
                                        phi_3377_ = _e4535[0];
                                    }
                                    let _e4542 = phi_3377_;
                                    if (_e4535[1] < 0f) {
                                        phi_3384_ = -(_e4535[1]);
                                    } else {
                                        phi_3384_ = _e4535[1];
                                    }
                                    let _e4546 = phi_3384_;
                                    if (_e4542 > _e4546) {
                                        phi_3389_ = _e4542;
                                    } else {
                                        phi_3389_ = _e4546;
                                    }
                                    let _e4549 = phi_3389_;
                                    if (_e4535[2] < 0f) {
                                        phi_3396_ = -(_e4535[2]);
                                    } else {
                                        phi_3396_ = _e4535[2];
                                    }
                                    let _e4553 = phi_3396_;
                                    if (_e4549 > _e4553) {
                                        phi_3401_ = _e4549;
                                    } else {
                                        phi_3401_ = _e4553;
                                    }
                                    let _e4556 = phi_3401_;
                                    let _e4559 = local_15.member_1[1u];
                                    if (_e4559[0] < 0f) {
                                        phi_3415_ = -(_e4559[0]);
                                    } else {
                                        phi_3415_ = _e4559[0];
                                    }
                                    let _e4566 = phi_3415_;
                                    if (_e4559[1] < 0f) {
                                        phi_3422_ = -(_e4559[1]);
                                    } else {
                                        phi_3422_ = _e4559[1];
                                    }
                                    let _e4570 = phi_3422_;
                                    if (_e4566 > _e4570) {
                                        phi_3427_ = _e4566;
                                    } else {
                                        phi_3427_ = _e4570;
                                    }
                                    let _e4573 = phi_3427_;
                                    if (_e4559[2] < 0f) {
                                        phi_3434_ = -(_e4559[2]);
                                    } else {
                                        phi_3434_ = _e4559[2];
                                    }
                                    let _e4577 = phi_3434_;
                                    if (_e4573 > _e4577) {
                                        phi_3439_ = _e4573;
                                    } else {
                                        phi_3439_ = _e4577;
                                    }
                                    let _e4580 = phi_3439_;
                                    if (_e4556 > _e4580) {
                                        phi_3444_ = _e4556;
                                    } else {
                                        phi_3444_ = _e4580;
                                    }
                                    let _e4583 = phi_3444_;
                                    let _e4585 = local_15.member_3;
                                    let _e4589 = local_15.member_2[0u];
                                    if (_e4589[0] < 0f) {
                                        phi_3461_ = -(_e4589[0]);
                                    } else {
                                        phi_3461_ = _e4589[0];
                                    }
                                    let _e4596 = phi_3461_;
                                    if (_e4589[1] < 0f) {
                                        phi_3468_ = -(_e4589[1]);
                                    } else {
                                        phi_3468_ = _e4589[1];
                                    }
                                    let _e4600 = phi_3468_;
                                    if (_e4596 > _e4600) {
                                        phi_3473_ = _e4596;
                                    } else {
                                        phi_3473_ = _e4600;
                                    }
                                    let _e4603 = phi_3473_;
                                    if (_e4589[2] < 0f) {
                                        phi_3480_ = -(_e4589[2]);
                                    } else {
                                        phi_3480_ = _e4589[2];
                                    }
                                    let _e4607 = phi_3480_;
                                    if (_e4603 > _e4607) {
                                        phi_3485_ = _e4603;
                                    } else {
                                        phi_3485_ = _e4607;
                                    }
                                    let _e4610 = phi_3485_;
                                    let _e4613 = local_15.member_2[1u];
                                    if (_e4613[0] < 0f) {
                                        phi_3499_ = -(_e4613[0]);
                                    } else {
                                        phi_3499_ = _e4613[0];
                                    }
                                    let _e4620 = phi_3499_;
                                    if (_e4613[1] < 0f) {
                                        phi_3506_ = -(_e4613[1]);
                                    } else {
                                        phi_3506_ = _e4613[1];
                                    }
                                    let _e4624 = phi_3506_;
                                    if (_e4620 > _e4624) {
                                        phi_3511_ = _e4620;
                                    } else {
                                        phi_3511_ = _e4624;
                                    }
                                    let _e4627 = phi_3511_;
                                    if (_e4613[2] < 0f) {
                                        phi_3518_ = -(_e4613[2]);
                                    } else {
                                        phi_3518_ = _e4613[2];
                                    }
                                    let _e4631 = phi_3518_;
                                    if (_e4627 > _e4631) {
                                        phi_3523_ = _e4627;
                                    } else {
                                        phi_3523_ = _e4631;
                                    }
                                    let _e4634 = phi_3523_;
                                    if (_e4610 > _e4634) {
                                        phi_3528_ = _e4610;
                                    } else {
                                        phi_3528_ = _e4634;
                                    }
                                    let _e4637 = phi_3528_;
                                    let _e4639 = local_15.member_3;
                                    let _e4646 = local_15.member_3;
                                    let _e4653 = (((_e4475 * (1f + (0.000000059604645f * 8f))) + (((((((_e4529 + _e4531) + (_e4583 + _e4585)) + (_e4637 + _e4639)) * (0.000000059604645f * 16f)) + (_e4646 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e267);
                                    if _e4653 {
                                        phi_3548_ = false;
                                    } else {
                                        phi_3548_ = true;
                                    }
                                    let _e4655 = phi_3548_;
                                    phi_3549_ = _e4655;
                                    phi_3550_ = _e4653;
                                } else {
                                    phi_3549_ = false;
                                    phi_3550_ = false;
                                }
                                let _e4657 = phi_3549_;
                                let _e4659 = phi_3550_;
                                local_45 = _e4659;
                                continue;
                                continuing {
                                    phi_2590_ = _e4072;
                                    break if !(_e4657);
                                }
                            }
                            let _e4662 = local_45;
                            if _e4662 {
                                phi_3555_ = type_55(1u, _e4045.member_1);
                                phi_3556_ = false;
                            } else {
                                phi_3555_ = type_55();
                                phi_3556_ = true;
                            }
                            let _e4665 = phi_3555_;
                            let _e4667 = phi_3556_;
                            if _e4667 {
                                phi_3561_ = type_55(2u, _e4045.member_1);
                                phi_3562_ = false;
                            } else {
                                phi_3561_ = type_55();
                                phi_3562_ = true;
                            }
                            let _e4670 = phi_3561_;
                            let _e4672 = phi_3562_;
                            phi_3564_ = _e4670;
                            phi_3565_ = _e4665;
                            phi_3566_ = _e4672;
                        } else {
                            phi_3564_ = type_55();
                            phi_3565_ = type_55(0u, type_55().member_1);
                            phi_3566_ = true;
                        }
                        let _e4674 = phi_3564_;
                        let _e4676 = phi_3565_;
                        let _e4678 = phi_3566_;
                        if _e4678 {
                            phi_3570_ = _e4676;
                        } else {
                            phi_3570_ = _e4674;
                        }
                        let _e4680 = phi_3570_;
                        phi_6844_ = _e4680;
                    } else {
                        if (_e365 < 0f) {
                            phi_3580_ = -(_e365);
                        } else {
                            phi_3580_ = _e365;
                        }
                        let _e708 = phi_3580_;
                        if (_e388 < 0f) {
                            phi_3586_ = -(_e388);
                        } else {
                            phi_3586_ = _e388;
                        }
                        let _e712 = phi_3586_;
                        if (_e708 > _e712) {
                            phi_3591_ = _e708;
                        } else {
                            phi_3591_ = _e712;
                        }
                        let _e715 = phi_3591_;
                        if (_e411 < 0f) {
                            phi_3597_ = -(_e411);
                        } else {
                            phi_3597_ = _e411;
                        }
                        let _e719 = phi_3597_;
                        if (_e422 < 0f) {
                            phi_3603_ = -(_e422);
                        } else {
                            phi_3603_ = _e422;
                        }
                        let _e723 = phi_3603_;
                        if (_e719 > _e723) {
                            phi_3608_ = _e719;
                        } else {
                            phi_3608_ = _e723;
                        }
                        let _e726 = phi_3608_;
                        if (_e715 > _e726) {
                            phi_3613_ = _e715;
                        } else {
                            phi_3613_ = _e726;
                        }
                        let _e729 = phi_3613_;
                        let _e730 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e729 >= _e730) {
                            phi_3621_ = (_e729 <= (1f / _e730));
                        } else {
                            phi_3621_ = false;
                        }
                        let _e735 = phi_3621_;
                        if _e735 {
                            phi_3626_ = (0.000000059604645f * 256f);
                        } else {
                            phi_3626_ = 2f;
                        }
                        let _e738 = phi_3626_;
                        let _e740 = ((_e672 * 0.34f) + (_e729 * _e738));
                        if _e735 {
                            phi_3633_ = (1f / _e729);
                        } else {
                            phi_3633_ = 0f;
                        }
                        let _e743 = phi_3633_;
                        let _e749 = ((_e388 - (3f * _e365)) * _e743);
                        let _e750 = ((_e411 - _e388) * _e743);
                        let _e751 = (((3f * _e422) - _e411) * _e743);
                        local_7[0u] = 0f;
                        local_7[1u] = 1f;
                        local_7[2u] = 1f;
                        local_7[3u] = 1f;
                        let _e758 = ((_e750 * _e750) - (_e749 * _e751));
                        if (_e758 > 0f) {
                            if (_e758 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e758 > 0f) {
                                    phi_3666_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_3666_ = 0f;
                                }
                                let _e818 = phi_3666_;
                                phi_3730_ = _e818;
                            } else {
                                phi_3673_ = type_26(0i, 5i);
                                phi_3676_ = bitcast<f32>(((bitcast<u32>(_e758) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e767 = phi_3673_;
                                    let _e769 = phi_3676_;
                                    local_16 = _e769;
                                    if (_e767.member < _e767.member_1) {
                                        let _e777 = (_e767.member + 1i);
                                        if ((false == (_e777 > _e767.member)) != false) {
                                            phi_3697_ = true;
                                        } else {
                                            phi_3697_ = false;
                                        }
                                        let _e782 = phi_3697_;
                                        if _e782 {
                                            phi_3703_ = type_27(0u, type_27().member_1);
                                        } else {
                                            phi_3703_ = type_27(1u, _e777);
                                        }
                                        let _e788 = phi_3703_;
                                        if (bitcast<i32>(_e788.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_3674_ = type_26(_e788.member_1, _e767.member_1);
                                        phi_3717_ = type_27(1u, _e767.member);
                                    } else {
                                        phi_3674_ = _e767;
                                        phi_3717_ = type_27(0u, type_27().member_1);
                                    }
                                    let _e798 = phi_3674_;
                                    let _e800 = phi_3717_;
                                    let _e803 = (bitcast<i32>(_e800.member) != 0i);
                                    if _e803 {
                                        phi_3677_ = (0.5f * (_e769 + (_e758 / _e769)));
                                    } else {
                                        phi_3677_ = f32();
                                    }
                                    let _e808 = phi_3677_;
                                    continue;
                                    continuing {
                                        phi_3673_ = _e798;
                                        phi_3676_ = _e808;
                                        break if !(_e803);
                                    }
                                }
                                let _e813 = local_16;
                                phi_3730_ = (_e813 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e820 = phi_3730_;
                            if (_e750 < 0f) {
                                phi_3736_ = -(_e820);
                            } else {
                                phi_3736_ = _e820;
                            }
                            let _e824 = phi_3736_;
                            let _e826 = -((_e750 + _e824));
                            local_8[0u] = (_e826 / (_e826 + _e751));
                            local_8[1u] = (_e749 / (_e749 + _e826));
                            let _e835 = local_8[1u];
                            let _e836 = local_8[0u];
                            if (_e835 < _e836) {
                                let _e839 = local_8[1u];
                                let _e841 = local_8[0u];
                                local_8[0u] = _e839;
                                local_8[1u] = _e841;
                            }
                            phi_3761_ = type_28(0u, 2u);
                            phi_3764_ = 1u;
                            loop {
                                let _e845 = phi_3761_;
                                let _e847 = phi_3764_;
                                local_46 = _e847;
                                if (_e845.member < _e845.member_1) {
                                    phi_3762_ = type_28((_e845.member + 1u), _e845.member_1);
                                    phi_3787_ = type_28(1u, _e845.member);
                                } else {
                                    phi_3762_ = _e845;
                                    phi_3787_ = type_28(0u, type_28().member_1);
                                }
                                let _e861 = phi_3762_;
                                let _e863 = phi_3787_;
                                let _e867 = (bitcast<i32>(_e863.member) != 0i);
                                if _e867 {
                                    if (_e863.member_1 < 2u) {
                                    } else {
                                        return;
                                    }
                                    let _e870 = local_8[_e863.member_1];
                                    if (_e870 > 0f) {
                                        if (_e863.member_1 < 2u) {
                                        } else {
                                            return;
                                        }
                                        let _e874 = local_8[_e863.member_1];
                                        if (_e874 < 1f) {
                                            if (_e863.member_1 < 2u) {
                                            } else {
                                                return;
                                            }
                                            let _e878 = local_8[_e863.member_1];
                                            if (_e847 < 4u) {
                                            } else {
                                                return;
                                            }
                                            local_7[_e847] = _e878;
                                            phi_3831_ = (_e847 + 1u);
                                        } else {
                                            phi_3831_ = _e847;
                                        }
                                        let _e883 = phi_3831_;
                                        phi_3832_ = _e883;
                                    } else {
                                        phi_3832_ = _e847;
                                    }
                                    let _e885 = phi_3832_;
                                    phi_3765_ = _e885;
                                } else {
                                    phi_3765_ = u32();
                                }
                                let _e887 = phi_3765_;
                                continue;
                                continuing {
                                    phi_3761_ = _e861;
                                    phi_3764_ = _e887;
                                    break if !(_e867);
                                }
                            }
                            let _e4938 = local_46;
                            phi_3833_ = _e4938;
                        } else {
                            phi_3833_ = 1u;
                        }
                        let _e890 = phi_3833_;
                        if (_e890 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e890] = 1f;
                        let _e893 = local_7;
                        local_9 = _e893;
                        phi_3853_ = type_28(0u, _e890);
                        loop {
                            let _e896 = phi_3853_;
                            if (_e896.member < _e896.member_1) {
                                phi_3854_ = type_28((_e896.member + 1u), _e896.member_1);
                                phi_3877_ = type_28(1u, _e896.member);
                            } else {
                                phi_3854_ = _e896;
                                phi_3877_ = type_28(0u, type_28().member_1);
                            }
                            let _e910 = phi_3854_;
                            let _e912 = phi_3877_;
                            if (bitcast<i32>(_e912.member) != 0i) {
                                if (_e912.member_1 < 4u) {
                                } else {
                                    return;
                                }
                                let _e919 = local_9[_e912.member_1];
                                let _e920 = (_e912.member_1 + 1u);
                                if (_e920 < 4u) {
                                } else {
                                    return;
                                }
                                let _e923 = local_9[_e920];
                                let _e924 = (1f - _e919);
                                let _e935 = ((((_e365 * _e924) + (_e388 * _e919)) * (_e924 * _e924)) + (((_e411 * _e924) + (_e422 * _e919)) * (_e919 * _e919)));
                                let _e936 = (1f - _e923);
                                let _e947 = ((((_e365 * _e936) + (_e388 * _e923)) * (_e936 * _e936)) + (((_e411 * _e936) + (_e422 * _e923)) * (_e923 * _e923)));
                                if (_e935 < 0f) {
                                    phi_3929_ = -(_e935);
                                } else {
                                    phi_3929_ = _e935;
                                }
                                let _e951 = phi_3929_;
                                let _e952 = (_e951 > _e740);
                                if (_e947 < 0f) {
                                    phi_3936_ = -(_e947);
                                } else {
                                    phi_3936_ = _e947;
                                }
                                let _e956 = phi_3936_;
                                let _e957 = (_e956 > _e740);
                                if _e952 {
                                    if _e957 {
                                        phi_3947_ = ((_e935 > 0f) != (_e947 > 0f));
                                        phi_3948_ = false;
                                    } else {
                                        phi_3947_ = bool();
                                        phi_3948_ = true;
                                    }
                                    let _e962 = phi_3947_;
                                    let _e964 = phi_3948_;
                                    phi_3949_ = _e962;
                                    phi_3950_ = _e964;
                                } else {
                                    phi_3949_ = bool();
                                    phi_3950_ = true;
                                }
                                let _e966 = phi_3949_;
                                let _e968 = phi_3950_;
                                if _e968 {
                                    phi_3954_ = false;
                                } else {
                                    phi_3954_ = _e966;
                                }
                                let _e970 = phi_3954_;
                                if _e952 {
                                    if _e957 {
                                        if _e970 {
                                            phi_3965_ = type_56();
                                        } else {
                                            phi_3965_ = type_56(1f, 0f, _e970);
                                        }
                                        let _e973 = phi_3965_;
                                        phi_3966_ = _e973;
                                        phi_3967_ = _e970;
                                    } else {
                                        phi_3966_ = type_56();
                                        phi_3967_ = true;
                                    }
                                    let _e975 = phi_3966_;
                                    let _e977 = phi_3967_;
                                    phi_3968_ = _e975;
                                    phi_3969_ = _e977;
                                } else {
                                    phi_3968_ = type_56();
                                    phi_3969_ = true;
                                }
                                let _e979 = phi_3968_;
                                let _e981 = phi_3969_;
                                if _e981 {
                                    if _e952 {
                                        if (_e935 < 0f) {
                                            phi_3980_ = -1f;
                                        } else {
                                            phi_3980_ = 1f;
                                        }
                                        let _e984 = phi_3980_;
                                        let _e987 = (_e411 - _e388);
                                        phi_3990_ = type_28(0u, 64u);
                                        phi_3993_ = _e923;
                                        phi_3995_ = _e919;
                                        phi_3997_ = (0.5f * (_e919 + _e923));
                                        loop {
                                            let _e993 = phi_3990_;
                                            let _e995 = phi_3993_;
                                            let _e997 = phi_3995_;
                                            let _e999 = phi_3997_;
                                            local_48 = _e997;
                                            if (_e993.member < _e993.member_1) {
                                                phi_3991_ = type_28((_e993.member + 1u), _e993.member_1);
                                                phi_4020_ = type_28(1u, _e993.member);
                                            } else {
                                                phi_3991_ = _e993;
                                                phi_4020_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1013 = phi_3991_;
                                            let _e1015 = phi_4020_;
                                            if (bitcast<i32>(_e1015.member) != 0i) {
                                                let _e1019 = (1f - _e999);
                                                let _e1032 = ((_e984 * ((((_e365 * _e1019) + (_e388 * _e999)) * (_e1019 * _e1019)) + (((_e411 * _e1019) + (_e422 * _e999)) * (_e999 * _e999)))) - _e740);
                                                if (_e1032 > 0f) {
                                                    phi_4045_ = _e995;
                                                    phi_4046_ = _e999;
                                                } else {
                                                    phi_4045_ = _e999;
                                                    phi_4046_ = _e997;
                                                }
                                                let _e1035 = phi_4045_;
                                                let _e1037 = phi_4046_;
                                                let _e1039 = ((_e1035 - _e1037) > 0.00000000000022737368f);
                                                if _e1039 {
                                                    let _e1040 = (1f - _e999);
                                                    let _e1052 = (-(_e1032) / (_e984 * (((((_e388 - (3f * _e365)) * _e1040) + (_e987 * _e999)) * _e1040) + (((_e987 * _e1040) + (((3f * _e422) - _e411) * _e999)) * _e999))));
                                                    if (_e1032 > 0f) {
                                                        phi_4072_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_4072_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1058 = phi_4072_;
                                                    let _e1060 = ((_e999 + _e1052) + _e1058);
                                                    if (_e1060 > _e1037) {
                                                        if (_e1060 < _e1035) {
                                                            if (_e1052 < 0f) {
                                                                phi_4088_ = -(_e1052);
                                                            } else {
                                                                phi_4088_ = _e1052;
                                                            }
                                                            let _e1066 = phi_4088_;
                                                            if (_e1066 < (0.5f * (_e1035 - _e1037))) {
                                                                phi_4095_ = false;
                                                            } else {
                                                                phi_4095_ = true;
                                                            }
                                                            let _e1071 = phi_4095_;
                                                            phi_4096_ = _e1071;
                                                        } else {
                                                            phi_4096_ = true;
                                                        }
                                                        let _e1073 = phi_4096_;
                                                        phi_4097_ = _e1073;
                                                    } else {
                                                        phi_4097_ = true;
                                                    }
                                                    let _e1075 = phi_4097_;
                                                    if _e1075 {
                                                        phi_4103_ = (0.5f * (_e1037 + _e1035));
                                                    } else {
                                                        phi_4103_ = _e1060;
                                                    }
                                                    let _e1079 = phi_4103_;
                                                    phi_4104_ = _e1079;
                                                    phi_4105_ = false;
                                                } else {
                                                    phi_4104_ = f32();
                                                    phi_4105_ = true;
                                                }
                                                let _e1081 = phi_4104_;
                                                let _e1083 = phi_4105_;
                                                phi_3994_ = _e1035;
                                                phi_3996_ = _e1037;
                                                phi_3998_ = _e1081;
                                                phi_4106_ = _e1037;
                                                phi_4107_ = _e1039;
                                                phi_4108_ = _e1083;
                                            } else {
                                                phi_3994_ = f32();
                                                phi_3996_ = f32();
                                                phi_3998_ = f32();
                                                phi_4106_ = f32();
                                                phi_4107_ = false;
                                                phi_4108_ = false;
                                            }
                                            let _e1085 = phi_3994_;
                                            let _e1087 = phi_3996_;
                                            let _e1089 = phi_3998_;
                                            let _e1091 = phi_4106_;
                                            let _e1093 = phi_4107_;
                                            let _e1095 = phi_4108_;
                                            local_17 = _e1095;
                                            local_47 = _e1091;
                                            continue;
                                            continuing {
                                                phi_3990_ = _e1013;
                                                phi_3993_ = _e1085;
                                                phi_3995_ = _e1087;
                                                phi_3997_ = _e1089;
                                                break if !(_e1093);
                                            }
                                        }
                                        let _e1098 = local_17;
                                        if _e1098 {
                                            let _e4980 = local_47;
                                            phi_4112_ = _e4980;
                                        } else {
                                            let _e4982 = local_48;
                                            phi_4112_ = _e4982;
                                        }
                                        let _e1100 = phi_4112_;
                                        phi_4113_ = _e1100;
                                    } else {
                                        phi_4113_ = _e919;
                                    }
                                    let _e1102 = phi_4113_;
                                    if _e957 {
                                        phi_4120_ = type_28(0u, 64u);
                                        phi_4123_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1105 = phi_4120_;
                                            let _e1107 = phi_4123_;
                                            if (_e1105.member < _e1105.member_1) {
                                                phi_4121_ = type_28((_e1105.member + 1u), _e1105.member_1);
                                                phi_4146_ = type_28(1u, _e1105.member);
                                            } else {
                                                phi_4121_ = _e1105;
                                                phi_4146_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1121 = phi_4121_;
                                            let _e1123 = phi_4146_;
                                            if (bitcast<i32>(_e1123.member) != 0i) {
                                                let _e1127 = (_e1102 + _e1107);
                                                if (_e1127 < _e923) {
                                                    let _e1129 = (1f - _e1127);
                                                    let _e1140 = ((((_e365 * _e1129) + (_e388 * _e1127)) * (_e1129 * _e1129)) + (((_e411 * _e1129) + (_e422 * _e1127)) * (_e1127 * _e1127)));
                                                    let _e1141 = (1f - _e1102);
                                                    let _e1152 = ((((_e365 * _e1141) + (_e388 * _e1102)) * (_e1141 * _e1141)) + (((_e411 * _e1141) + (_e422 * _e1102)) * (_e1102 * _e1102)));
                                                    if (_e1140 < 0f) {
                                                        phi_4187_ = -(_e1140);
                                                    } else {
                                                        phi_4187_ = _e1140;
                                                    }
                                                    let _e1156 = phi_4187_;
                                                    if (_e1156 > _e740) {
                                                        if (_e1152 < 0f) {
                                                            phi_4197_ = -(_e1152);
                                                        } else {
                                                            phi_4197_ = _e1152;
                                                        }
                                                        let _e1161 = phi_4197_;
                                                        if (_e1161 > _e740) {
                                                            phi_4205_ = ((_e1140 > 0f) == (_e1152 > 0f));
                                                        } else {
                                                            phi_4205_ = false;
                                                        }
                                                        let _e1167 = phi_4205_;
                                                        phi_4207_ = !(_e1167);
                                                    } else {
                                                        phi_4207_ = false;
                                                    }
                                                    let _e1170 = phi_4207_;
                                                    if _e1170 {
                                                        phi_4212_ = f32();
                                                        phi_4213_ = false;
                                                    } else {
                                                        phi_4212_ = (_e1107 + _e1107);
                                                        phi_4213_ = true;
                                                    }
                                                    let _e1173 = phi_4212_;
                                                    let _e1175 = phi_4213_;
                                                    phi_4214_ = _e1173;
                                                    phi_4215_ = _e1175;
                                                    phi_4216_ = _e1170;
                                                    phi_4217_ = false;
                                                } else {
                                                    phi_4214_ = f32();
                                                    phi_4215_ = false;
                                                    phi_4216_ = false;
                                                    phi_4217_ = true;
                                                }
                                                let _e1177 = phi_4214_;
                                                let _e1179 = phi_4215_;
                                                let _e1181 = phi_4216_;
                                                let _e1183 = phi_4217_;
                                                phi_4218_ = _e1127;
                                                phi_4124_ = _e1177;
                                                phi_4219_ = _e1179;
                                                phi_4220_ = _e1181;
                                                phi_4221_ = _e1183;
                                                phi_4222_ = false;
                                            } else {
                                                phi_4218_ = f32();
                                                phi_4124_ = f32();
                                                phi_4219_ = false;
                                                phi_4220_ = false;
                                                phi_4221_ = false;
                                                phi_4222_ = true;
                                            }
                                            let _e1185 = phi_4218_;
                                            let _e1187 = phi_4124_;
                                            let _e1189 = phi_4219_;
                                            let _e1191 = phi_4220_;
                                            let _e1193 = phi_4221_;
                                            let _e1195 = phi_4222_;
                                            local_18 = _e1191;
                                            local_49 = _e1193;
                                            local_50 = _e1195;
                                            local_51 = _e1185;
                                            continue;
                                            continuing {
                                                phi_4120_ = _e1121;
                                                phi_4123_ = _e1187;
                                                break if !(_e1189);
                                            }
                                        }
                                        let _e1198 = local_18;
                                        if _e1198 {
                                            phi_4226_ = false;
                                            phi_4227_ = false;
                                        } else {
                                            let _e5007 = local_49;
                                            phi_4226_ = _e5007;
                                            let _e5010 = local_50;
                                            phi_4227_ = _e5010;
                                        }
                                        let _e1200 = phi_4226_;
                                        let _e1202 = phi_4227_;
                                        if _e1200 {
                                            phi_4231_ = true;
                                        } else {
                                            phi_4231_ = _e1202;
                                        }
                                        let _e1204 = phi_4231_;
                                        if _e1204 {
                                            phi_4235_ = _e923;
                                        } else {
                                            let _e5014 = local_51;
                                            phi_4235_ = _e5014;
                                        }
                                        let _e1206 = phi_4235_;
                                        phi_4236_ = _e1206;
                                    } else {
                                        phi_4236_ = _e923;
                                    }
                                    let _e1208 = phi_4236_;
                                    phi_4238_ = type_56(_e1102, _e1208, _e970);
                                } else {
                                    phi_4238_ = _e979;
                                }
                                let _e1211 = phi_4238_;
                                if (_e1211.member > _e1211.member_1) {
                                    phi_6800_ = f32();
                                    phi_6801_ = true;
                                    phi_6802_ = false;
                                    phi_6803_ = false;
                                    phi_6804_ = false;
                                } else {
                                    let _e1218 = ((_e1211.member_1 - _e1211.member) * 0.5f);
                                    let _e1219 = (_e1211.member + _e1218);
                                    let _e1221 = (_e1218 + (0.000000059604645f * 4f));
                                    let _e1223 = local_15.member_3;
                                    let _e1226 = local_15.member[0u];
                                    if (_e1226[0] < 0f) {
                                        phi_4267_ = -(_e1226[0]);
                                    } else {
                                        phi_4267_ = _e1226[0];
                                    }
                                    let _e1233 = phi_4267_;
                                    if (_e1226[1] < 0f) {
                                        phi_4274_ = -(_e1226[1]);
                                    } else {
                                        phi_4274_ = _e1226[1];
                                    }
                                    let _e1237 = phi_4274_;
                                    if (_e1233 > _e1237) {
                                        phi_4279_ = _e1233;
                                    } else {
                                        phi_4279_ = _e1237;
                                    }
                                    let _e1240 = phi_4279_;
                                    if (_e1226[2] < 0f) {
                                        phi_4286_ = -(_e1226[2]);
                                    } else {
                                        phi_4286_ = _e1226[2];
                                    }
                                    let _e1244 = phi_4286_;
                                    if (_e1240 > _e1244) {
                                        phi_4291_ = _e1240;
                                    } else {
                                        phi_4291_ = _e1244;
                                    }
                                    let _e1247 = phi_4291_;
                                    let _e1249 = local_15.member[1u];
                                    if (_e1249[0] < 0f) {
                                        phi_4304_ = -(_e1249[0]);
                                    } else {
                                        phi_4304_ = _e1249[0];
                                    }
                                    let _e1256 = phi_4304_;
                                    if (_e1249[1] < 0f) {
                                        phi_4311_ = -(_e1249[1]);
                                    } else {
                                        phi_4311_ = _e1249[1];
                                    }
                                    let _e1260 = phi_4311_;
                                    if (_e1256 > _e1260) {
                                        phi_4316_ = _e1256;
                                    } else {
                                        phi_4316_ = _e1260;
                                    }
                                    let _e1263 = phi_4316_;
                                    if (_e1249[2] < 0f) {
                                        phi_4323_ = -(_e1249[2]);
                                    } else {
                                        phi_4323_ = _e1249[2];
                                    }
                                    let _e1267 = phi_4323_;
                                    if (_e1263 > _e1267) {
                                        phi_4328_ = _e1263;
                                    } else {
                                        phi_4328_ = _e1267;
                                    }
                                    let _e1270 = phi_4328_;
                                    if (_e1247 > _e1270) {
                                        phi_4333_ = _e1247;
                                    } else {
                                        phi_4333_ = _e1270;
                                    }
                                    let _e1273 = phi_4333_;
                                    let _e1276 = local_15.member[0u];
                                    let _e1281 = local_15.member[1u];
                                    let _e1291 = (_e1276[0] + ((_e1281[0] - _e1276[0]) * _e1219));
                                    let _e1292 = (_e1276[1] + ((_e1281[1] - _e1276[1]) * _e1219));
                                    let _e1293 = (_e1276[2] + ((_e1281[2] - _e1276[2]) * _e1219));
                                    let _e1295 = local_15.member[1u];
                                    let _e1300 = local_15.member[0u];
                                    let _e1304 = (_e1295[0] - _e1300[0]);
                                    let _e1305 = (_e1295[1] - _e1300[1]);
                                    let _e1306 = (_e1295[2] - _e1300[2]);
                                    if (_e1304 < 0f) {
                                        phi_4392_ = -(_e1304);
                                    } else {
                                        phi_4392_ = _e1304;
                                    }
                                    let _e1310 = phi_4392_;
                                    if (_e1305 < 0f) {
                                        phi_4398_ = -(_e1305);
                                    } else {
                                        phi_4398_ = _e1305;
                                    }
                                    let _e1314 = phi_4398_;
                                    if (_e1310 > _e1314) {
                                        phi_4403_ = _e1310;
                                    } else {
                                        phi_4403_ = _e1314;
                                    }
                                    let _e1317 = phi_4403_;
                                    if (_e1306 < 0f) {
                                        phi_4409_ = -(_e1306);
                                    } else {
                                        phi_4409_ = _e1306;
                                    }
                                    let _e1321 = phi_4409_;
                                    if (_e1317 > _e1321) {
                                        phi_4414_ = _e1317;
                                    } else {
                                        phi_4414_ = _e1321;
                                    }
                                    let _e1324 = phi_4414_;
                                    let _e1330 = ((((_e1221 * _e1324) * 1.01f) + ((_e1273 + _e1223) * (0.000000059604645f * 8f))) + _e1223);
                                    if (_e1291 < 0f) {
                                        phi_4426_ = -(_e1291);
                                    } else {
                                        phi_4426_ = _e1291;
                                    }
                                    let _e1334 = phi_4426_;
                                    if (_e1292 < 0f) {
                                        phi_4432_ = -(_e1292);
                                    } else {
                                        phi_4432_ = _e1292;
                                    }
                                    let _e1338 = phi_4432_;
                                    if (_e1334 > _e1338) {
                                        phi_4437_ = _e1334;
                                    } else {
                                        phi_4437_ = _e1338;
                                    }
                                    let _e1341 = phi_4437_;
                                    if (_e1293 < 0f) {
                                        phi_4443_ = -(_e1293);
                                    } else {
                                        phi_4443_ = _e1293;
                                    }
                                    let _e1345 = phi_4443_;
                                    if (_e1341 > _e1345) {
                                        phi_4448_ = _e1341;
                                    } else {
                                        phi_4448_ = _e1345;
                                    }
                                    let _e1348 = phi_4448_;
                                    local_3 = type_40(array<f32, 3>(_e1291, _e1292, _e1293), _e1330, (_e1348 + _e1330));
                                    let _e1354 = local_15.member_3;
                                    let _e1356 = local_15.member_1[0u];
                                    if (_e1356[0] < 0f) {
                                        phi_4474_ = -(_e1356[0]);
                                    } else {
                                        phi_4474_ = _e1356[0];
                                    }
                                    let _e1363 = phi_4474_;
                                    if (_e1356[1] < 0f) {
                                        phi_4481_ = -(_e1356[1]);
                                    } else {
                                        phi_4481_ = _e1356[1];
                                    }
                                    let _e1367 = phi_4481_;
                                    if (_e1363 > _e1367) {
                                        phi_4486_ = _e1363;
                                    } else {
                                        phi_4486_ = _e1367;
                                    }
                                    let _e1370 = phi_4486_;
                                    if (_e1356[2] < 0f) {
                                        phi_4493_ = -(_e1356[2]);
                                    } else {
                                        phi_4493_ = _e1356[2];
                                    }
                                    let _e1374 = phi_4493_;
                                    if (_e1370 > _e1374) {
                                        phi_4498_ = _e1370;
                                    } else {
                                        phi_4498_ = _e1374;
                                    }
                                    let _e1377 = phi_4498_;
                                    let _e1379 = local_15.member_1[1u];
                                    if (_e1379[0] < 0f) {
                                        phi_4511_ = -(_e1379[0]);
                                    } else {
                                        phi_4511_ = _e1379[0];
                                    }
                                    let _e1386 = phi_4511_;
                                    if (_e1379[1] < 0f) {
                                        phi_4518_ = -(_e1379[1]);
                                    } else {
                                        phi_4518_ = _e1379[1];
                                    }
                                    let _e1390 = phi_4518_;
                                    if (_e1386 > _e1390) {
                                        phi_4523_ = _e1386;
                                    } else {
                                        phi_4523_ = _e1390;
                                    }
                                    let _e1393 = phi_4523_;
                                    if (_e1379[2] < 0f) {
                                        phi_4530_ = -(_e1379[2]);
                                    } else {
                                        phi_4530_ = _e1379[2];
                                    }
                                    let _e1397 = phi_4530_;
                                    if (_e1393 > _e1397) {
                                        phi_4535_ = _e1393;
                                    } else {
                                        phi_4535_ = _e1397;
                                    }
                                    let _e1400 = phi_4535_;
                                    if (_e1377 > _e1400) {
                                        phi_4540_ = _e1377;
                                    } else {
                                        phi_4540_ = _e1400;
                                    }
                                    let _e1403 = phi_4540_;
                                    let _e1406 = local_15.member_1[0u];
                                    let _e1411 = local_15.member_1[1u];
                                    let _e1421 = (_e1406[0] + ((_e1411[0] - _e1406[0]) * _e1219));
                                    let _e1422 = (_e1406[1] + ((_e1411[1] - _e1406[1]) * _e1219));
                                    let _e1423 = (_e1406[2] + ((_e1411[2] - _e1406[2]) * _e1219));
                                    let _e1425 = local_15.member_1[1u];
                                    let _e1430 = local_15.member_1[0u];
                                    let _e1434 = (_e1425[0] - _e1430[0]);
                                    let _e1435 = (_e1425[1] - _e1430[1]);
                                    let _e1436 = (_e1425[2] - _e1430[2]);
                                    if (_e1434 < 0f) {
                                        phi_4599_ = -(_e1434);
                                    } else {
                                        phi_4599_ = _e1434;
                                    }
                                    let _e1440 = phi_4599_;
                                    if (_e1435 < 0f) {
                                        phi_4605_ = -(_e1435);
                                    } else {
                                        phi_4605_ = _e1435;
                                    }
                                    let _e1444 = phi_4605_;
                                    if (_e1440 > _e1444) {
                                        phi_4610_ = _e1440;
                                    } else {
                                        phi_4610_ = _e1444;
                                    }
                                    let _e1447 = phi_4610_;
                                    if (_e1436 < 0f) {
                                        phi_4616_ = -(_e1436);
                                    } else {
                                        phi_4616_ = _e1436;
                                    }
                                    let _e1451 = phi_4616_;
                                    if (_e1447 > _e1451) {
                                        phi_4621_ = _e1447;
                                    } else {
                                        phi_4621_ = _e1451;
                                    }
                                    let _e1454 = phi_4621_;
                                    let _e1460 = ((((_e1221 * _e1454) * 1.01f) + ((_e1403 + _e1354) * (0.000000059604645f * 8f))) + _e1354);
                                    if (_e1421 < 0f) {
                                        phi_4633_ = -(_e1421);
                                    } else {
                                        phi_4633_ = _e1421;
                                    }
                                    let _e1464 = phi_4633_;
                                    if (_e1422 < 0f) {
                                        phi_4639_ = -(_e1422);
                                    } else {
                                        phi_4639_ = _e1422;
                                    }
                                    let _e1468 = phi_4639_;
                                    if (_e1464 > _e1468) {
                                        phi_4644_ = _e1464;
                                    } else {
                                        phi_4644_ = _e1468;
                                    }
                                    let _e1471 = phi_4644_;
                                    if (_e1423 < 0f) {
                                        phi_4650_ = -(_e1423);
                                    } else {
                                        phi_4650_ = _e1423;
                                    }
                                    let _e1475 = phi_4650_;
                                    if (_e1471 > _e1475) {
                                        phi_4655_ = _e1471;
                                    } else {
                                        phi_4655_ = _e1475;
                                    }
                                    let _e1478 = phi_4655_;
                                    local_4 = type_40(array<f32, 3>(_e1421, _e1422, _e1423), _e1460, (_e1478 + _e1460));
                                    let _e1484 = local_15.member_3;
                                    let _e1486 = local_15.member_2[0u];
                                    if (_e1486[0] < 0f) {
                                        phi_4681_ = -(_e1486[0]);
                                    } else {
                                        phi_4681_ = _e1486[0];
                                    }
                                    let _e1493 = phi_4681_;
                                    if (_e1486[1] < 0f) {
                                        phi_4688_ = -(_e1486[1]);
                                    } else {
                                        phi_4688_ = _e1486[1];
                                    }
                                    let _e1497 = phi_4688_;
                                    if (_e1493 > _e1497) {
                                        phi_4693_ = _e1493;
                                    } else {
                                        phi_4693_ = _e1497;
                                    }
                                    let _e1500 = phi_4693_;
                                    if (_e1486[2] < 0f) {
                                        phi_4700_ = -(_e1486[2]);
                                    } else {
                                        phi_4700_ = _e1486[2];
                                    }
                                    let _e1504 = phi_4700_;
                                    if (_e1500 > _e1504) {
                                        phi_4705_ = _e1500;
                                    } else {
                                        phi_4705_ = _e1504;
                                    }
                                    let _e1507 = phi_4705_;
                                    let _e1509 = local_15.member_2[1u];
                                    if (_e1509[0] < 0f) {
                                        phi_4718_ = -(_e1509[0]);
                                    } else {
                                        phi_4718_ = _e1509[0];
                                    }
                                    let _e1516 = phi_4718_;
                                    if (_e1509[1] < 0f) {
                                        phi_4725_ = -(_e1509[1]);
                                    } else {
                                        phi_4725_ = _e1509[1];
                                    }
                                    let _e1520 = phi_4725_;
                                    if (_e1516 > _e1520) {
                                        phi_4730_ = _e1516;
                                    } else {
                                        phi_4730_ = _e1520;
                                    }
                                    let _e1523 = phi_4730_;
                                    if (_e1509[2] < 0f) {
                                        phi_4737_ = -(_e1509[2]);
                                    } else {
                                        phi_4737_ = _e1509[2];
                                    }
                                    let _e1527 = phi_4737_;
                                    if (_e1523 > _e1527) {
                                        phi_4742_ = _e1523;
                                    } else {
                                        phi_4742_ = _e1527;
                                    }
                                    let _e1530 = phi_4742_;
                                    if (_e1507 > _e1530) {
                                        phi_4747_ = _e1507;
                                    } else {
                                        phi_4747_ = _e1530;
                                    }
                                    let _e1533 = phi_4747_;
                                    let _e1536 = local_15.member_2[0u];
                                    let _e1541 = local_15.member_2[1u];
                                    let _e1551 = (_e1536[0] + ((_e1541[0] - _e1536[0]) * _e1219));
                                    let _e1552 = (_e1536[1] + ((_e1541[1] - _e1536[1]) * _e1219));
                                    let _e1553 = (_e1536[2] + ((_e1541[2] - _e1536[2]) * _e1219));
                                    let _e1555 = local_15.member_2[1u];
                                    let _e1560 = local_15.member_2[0u];
                                    let _e1564 = (_e1555[0] - _e1560[0]);
                                    let _e1565 = (_e1555[1] - _e1560[1]);
                                    let _e1566 = (_e1555[2] - _e1560[2]);
                                    if (_e1564 < 0f) {
                                        phi_4806_ = -(_e1564);
                                    } else {
                                        phi_4806_ = _e1564;
                                    }
                                    let _e1570 = phi_4806_;
                                    if (_e1565 < 0f) {
                                        phi_4812_ = -(_e1565);
                                    } else {
                                        phi_4812_ = _e1565;
                                    }
                                    let _e1574 = phi_4812_;
                                    if (_e1570 > _e1574) {
                                        phi_4817_ = _e1570;
                                    } else {
                                        phi_4817_ = _e1574;
                                    }
                                    let _e1577 = phi_4817_;
                                    if (_e1566 < 0f) {
                                        phi_4823_ = -(_e1566);
                                    } else {
                                        phi_4823_ = _e1566;
                                    }
                                    let _e1581 = phi_4823_;
                                    if (_e1577 > _e1581) {
                                        phi_4828_ = _e1577;
                                    } else {
                                        phi_4828_ = _e1581;
                                    }
                                    let _e1584 = phi_4828_;
                                    let _e1590 = ((((_e1221 * _e1584) * 1.01f) + ((_e1533 + _e1484) * (0.000000059604645f * 8f))) + _e1484);
                                    if (_e1551 < 0f) {
                                        phi_4840_ = -(_e1551);
                                    } else {
                                        phi_4840_ = _e1551;
                                    }
                                    let _e1594 = phi_4840_;
                                    if (_e1552 < 0f) {
                                        phi_4846_ = -(_e1552);
                                    } else {
                                        phi_4846_ = _e1552;
                                    }
                                    let _e1598 = phi_4846_;
                                    if (_e1594 > _e1598) {
                                        phi_4851_ = _e1594;
                                    } else {
                                        phi_4851_ = _e1598;
                                    }
                                    let _e1601 = phi_4851_;
                                    if (_e1553 < 0f) {
                                        phi_4857_ = -(_e1553);
                                    } else {
                                        phi_4857_ = _e1553;
                                    }
                                    let _e1605 = phi_4857_;
                                    if (_e1601 > _e1605) {
                                        phi_4862_ = _e1601;
                                    } else {
                                        phi_4862_ = _e1605;
                                    }
                                    let _e1608 = phi_4862_;
                                    local_5 = type_40(array<f32, 3>(_e1551, _e1552, _e1553), _e1590, (_e1608 + _e1590));
                                    let _e1613 = local_4.member;
                                    let _e1618 = local_5.member;
                                    let _e1624 = ((_e1613[1] * _e1618[2]) - (_e1613[2] * _e1618[1]));
                                    let _e1627 = ((_e1613[2] * _e1618[0]) - (_e1613[0] * _e1618[2]));
                                    let _e1630 = ((_e1613[0] * _e1618[1]) - (_e1613[1] * _e1618[0]));
                                    if (_e1624 < 0f) {
                                        phi_4911_ = -(_e1624);
                                    } else {
                                        phi_4911_ = _e1624;
                                    }
                                    let _e1634 = phi_4911_;
                                    if (_e1627 < 0f) {
                                        phi_4917_ = -(_e1627);
                                    } else {
                                        phi_4917_ = _e1627;
                                    }
                                    let _e1638 = phi_4917_;
                                    if (_e1634 > _e1638) {
                                        if (_e1624 < 0f) {
                                            phi_4927_ = -(_e1624);
                                        } else {
                                            phi_4927_ = _e1624;
                                        }
                                        let _e1656 = phi_4927_;
                                        if (_e1630 < 0f) {
                                            phi_4933_ = -(_e1630);
                                        } else {
                                            phi_4933_ = _e1630;
                                        }
                                        let _e1660 = phi_4933_;
                                        if (_e1656 > _e1660) {
                                            phi_4938_ = 2u;
                                            phi_4939_ = 1u;
                                        } else {
                                            phi_4938_ = 1u;
                                            phi_4939_ = 0u;
                                        }
                                        let _e1663 = phi_4938_;
                                        let _e1665 = phi_4939_;
                                        phi_4958_ = _e1663;
                                        phi_4959_ = _e1665;
                                    } else {
                                        if (_e1627 < 0f) {
                                            phi_4945_ = -(_e1627);
                                        } else {
                                            phi_4945_ = _e1627;
                                        }
                                        let _e1643 = phi_4945_;
                                        if (_e1630 < 0f) {
                                            phi_4951_ = -(_e1630);
                                        } else {
                                            phi_4951_ = _e1630;
                                        }
                                        let _e1647 = phi_4951_;
                                        if (_e1643 > _e1647) {
                                            phi_4956_ = 0u;
                                            phi_4957_ = 2u;
                                        } else {
                                            phi_4956_ = 1u;
                                            phi_4957_ = 0u;
                                        }
                                        let _e1650 = phi_4956_;
                                        let _e1652 = phi_4957_;
                                        phi_4958_ = _e1650;
                                        phi_4959_ = _e1652;
                                    }
                                    let _e1667 = phi_4958_;
                                    let _e1669 = phi_4959_;
                                    if (_e1669 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1673 = local_4.member[_e1669];
                                    if (_e1667 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1677 = local_5.member[_e1667];
                                    if (_e1667 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1682 = local_4.member[_e1667];
                                    if (_e1669 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1686 = local_5.member[_e1669];
                                    let _e1688 = ((_e1673 * _e1677) - (_e1682 * _e1686));
                                    let _e1690 = local_4.member_1;
                                    let _e1692 = local_5.member_2;
                                    let _e1695 = local_4.member_2;
                                    let _e1697 = local_5.member_1;
                                    let _e1702 = local_4.member_2;
                                    let _e1704 = local_5.member_2;
                                    let _e1711 = local_4.member_2;
                                    let _e1714 = local_5.member_2;
                                    let _e1718 = (((((_e1690 * _e1692) + (_e1695 * _e1697)) * 2.01f) + ((_e1702 * _e1704) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1711) * (1f + _e1714))));
                                    if (_e1688 < 0f) {
                                        phi_5026_ = -(_e1688);
                                    } else {
                                        phi_5026_ = _e1688;
                                    }
                                    let _e1722 = phi_5026_;
                                    if (_e1722 > _e1718) {
                                        if (_e1688 < 0f) {
                                            phi_5035_ = -1f;
                                        } else {
                                            phi_5035_ = 1f;
                                        }
                                        let _e1726 = phi_5035_;
                                        if (_e1669 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1730 = local_3.member[_e1669];
                                        if (_e1667 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1734 = local_5.member[_e1667];
                                        if (_e1667 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1739 = local_3.member[_e1667];
                                        if (_e1669 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1743 = local_5.member[_e1669];
                                        let _e1747 = local_3.member_1;
                                        let _e1749 = local_5.member_2;
                                        let _e1752 = local_3.member_2;
                                        let _e1754 = local_5.member_1;
                                        let _e1759 = local_3.member_2;
                                        let _e1761 = local_5.member_2;
                                        let _e1768 = local_3.member_2;
                                        let _e1771 = local_5.member_2;
                                        let _e1775 = (((((_e1747 * _e1749) + (_e1752 * _e1754)) * 2.01f) + ((_e1759 * _e1761) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1768) * (1f + _e1771))));
                                        if (_e1669 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1779 = local_4.member[_e1669];
                                        if (_e1667 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1783 = local_3.member[_e1667];
                                        if (_e1667 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1788 = local_4.member[_e1667];
                                        if (_e1669 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1792 = local_3.member[_e1669];
                                        let _e1796 = local_4.member_1;
                                        let _e1798 = local_3.member_2;
                                        let _e1801 = local_4.member_2;
                                        let _e1803 = local_3.member_1;
                                        let _e1808 = local_4.member_2;
                                        let _e1810 = local_3.member_2;
                                        let _e1817 = local_4.member_2;
                                        let _e1820 = local_3.member_2;
                                        let _e1824 = (((((_e1796 * _e1798) + (_e1801 * _e1803)) * 2.01f) + ((_e1808 * _e1810) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1817) * (1f + _e1820))));
                                        let _e1825 = (_e1688 * _e1726);
                                        let _e1826 = (((_e1730 * _e1734) - (_e1739 * _e1743)) * _e1726);
                                        let _e1827 = (((_e1779 * _e1783) - (_e1788 * _e1792)) * _e1726);
                                        if (_e1825 < 0f) {
                                            phi_5166_ = -(_e1825);
                                        } else {
                                            phi_5166_ = _e1825;
                                        }
                                        let _e1831 = phi_5166_;
                                        if (_e1826 < 0f) {
                                            phi_5172_ = -(_e1826);
                                        } else {
                                            phi_5172_ = _e1826;
                                        }
                                        let _e1835 = phi_5172_;
                                        if (_e1827 < 0f) {
                                            phi_5179_ = -(_e1827);
                                        } else {
                                            phi_5179_ = _e1827;
                                        }
                                        let _e1840 = phi_5179_;
                                        let _e1843 = (((_e1831 + _e1835) + _e1840) * (0.000000059604645f * 4f));
                                        local_6[0u].member = _e1826;
                                        local_6[0u].member_1 = _e1775;
                                        local_6[1u].member = _e1827;
                                        local_6[1u].member_1 = _e1824;
                                        local_6[2u].member = (_e1825 - _e1826);
                                        local_6[2u].member_1 = ((_e1718 + _e1775) + _e1843);
                                        local_6[3u].member = (_e1825 - _e1827);
                                        local_6[3u].member_1 = ((_e1718 + _e1824) + _e1843);
                                        phi_5222_ = type_28(0u, 4u);
                                        phi_5225_ = true;
                                        loop {
                                            let _e1864 = phi_5222_;
                                            let _e1866 = phi_5225_;
                                            local_20 = _e1866;
                                            if (_e1864.member < _e1864.member_1) {
                                                phi_5223_ = type_28((_e1864.member + 1u), _e1864.member_1);
                                                phi_5248_ = type_28(1u, _e1864.member);
                                            } else {
                                                phi_5223_ = _e1864;
                                                phi_5248_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1880 = phi_5223_;
                                            let _e1882 = phi_5248_;
                                            if (bitcast<i32>(_e1882.member) != 0i) {
                                                if (_e1882.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1890 = local_6[_e1882.member_1].member;
                                                let _e1893 = local_6[_e1882.member_1].member_1;
                                                let _e1895 = (_e1890 < -(_e1893));
                                                if _e1895 {
                                                    phi_5275_ = bool();
                                                    phi_5276_ = false;
                                                } else {
                                                    phi_5275_ = (_e1866 && (_e1890 > _e1893));
                                                    phi_5276_ = true;
                                                }
                                                let _e1899 = phi_5275_;
                                                let _e1901 = phi_5276_;
                                                phi_5226_ = _e1899;
                                                phi_5277_ = _e1901;
                                                phi_5278_ = _e1895;
                                            } else {
                                                phi_5226_ = bool();
                                                phi_5277_ = false;
                                                phi_5278_ = false;
                                            }
                                            let _e1903 = phi_5226_;
                                            let _e1905 = phi_5277_;
                                            let _e1907 = phi_5278_;
                                            local_19 = _e1907;
                                            continue;
                                            continuing {
                                                phi_5222_ = _e1880;
                                                phi_5225_ = _e1903;
                                                break if !(_e1905);
                                            }
                                        }
                                        let _e1910 = local_19;
                                        if _e1910 {
                                            phi_5282_ = false;
                                        } else {
                                            phi_5282_ = true;
                                        }
                                        let _e1912 = phi_5282_;
                                        if _e1912 {
                                            let _e1914 = local_20;
                                            if _e1914 {
                                                phi_5289_ = 1u;
                                            } else {
                                                phi_5289_ = 2u;
                                            }
                                            let _e1916 = phi_5289_;
                                            phi_5290_ = _e1916;
                                            phi_5291_ = false;
                                        } else {
                                            phi_5290_ = u32();
                                            phi_5291_ = true;
                                        }
                                        let _e1918 = phi_5290_;
                                        let _e1920 = phi_5291_;
                                        phi_5292_ = _e1918;
                                        phi_5293_ = 0u;
                                        phi_5294_ = _e1920;
                                    } else {
                                        phi_5292_ = u32();
                                        phi_5293_ = 2u;
                                        phi_5294_ = true;
                                    }
                                    let _e1922 = phi_5292_;
                                    let _e1924 = phi_5293_;
                                    let _e1926 = phi_5294_;
                                    if _e1926 {
                                        phi_5298_ = _e1924;
                                    } else {
                                        phi_5298_ = _e1922;
                                    }
                                    let _e1928 = phi_5298_;
                                    let _e1929 = (_e1928 == 0u);
                                    if _e1929 {
                                        phi_6796_ = f32();
                                        phi_6797_ = false;
                                        phi_6798_ = false;
                                        phi_6799_ = false;
                                    } else {
                                        if (_e1928 == 1u) {
                                            if _e1211.member_2 {
                                                if ((_e1211.member_1 - _e1211.member) <= 0.0000005f) {
                                                    phi_5318_ = false;
                                                } else {
                                                    phi_5318_ = true;
                                                }
                                                let _e1937 = phi_5318_;
                                                phi_5319_ = _e1937;
                                            } else {
                                                phi_5319_ = true;
                                            }
                                            let _e1939 = phi_5319_;
                                            phi_5320_ = _e1939;
                                        } else {
                                            phi_5320_ = true;
                                        }
                                        let _e1941 = phi_5320_;
                                        if _e1941 {
                                            let _e1946 = local_15.member[0u];
                                            let _e1952 = local_15.member_1[0u];
                                            let _e1958 = local_15.member_2[0u];
                                            let _e1962 = (_e1946[0] - _e1952[0]);
                                            let _e1963 = (_e1946[1] - _e1952[1]);
                                            let _e1964 = (_e1946[2] - _e1952[2]);
                                            local_1 = array<array<f32, 3>, 4>(_e1946, array<f32, 3>(_e1962, _e1963, _e1964), array<f32, 3>((_e1946[0] - _e1958[0]), (_e1946[1] - _e1958[1]), (_e1946[2] - _e1958[2])), array<f32, 3>((_e1962 - _e1958[0]), (_e1963 - _e1958[1]), (_e1964 - _e1958[2])));
                                            let _e1977 = local_15.member[1u];
                                            let _e1983 = local_15.member_1[1u];
                                            let _e1989 = local_15.member_2[1u];
                                            let _e1993 = (_e1977[0] - _e1983[0]);
                                            let _e1994 = (_e1977[1] - _e1983[1]);
                                            let _e1995 = (_e1977[2] - _e1983[2]);
                                            local_2 = array<array<f32, 3>, 4>(_e1977, array<f32, 3>(_e1993, _e1994, _e1995), array<f32, 3>((_e1977[0] - _e1989[0]), (_e1977[1] - _e1989[1]), (_e1977[2] - _e1989[2])), array<f32, 3>((_e1993 - _e1989[0]), (_e1994 - _e1989[1]), (_e1995 - _e1989[2])));
                                            let _e2008 = local_15.member[0u];
                                            if (_e2008[0] < 0f) {
                                                phi_5516_ = -(_e2008[0]);
                                            } else {
                                                phi_5516_ = _e2008[0];
                                            }
                                            let _e2015 = phi_5516_;
                                            if (_e2008[1] < 0f) {
                                                phi_5523_ = -(_e2008[1]);
                                            } else {
                                                phi_5523_ = _e2008[1];
                                            }
                                            let _e2019 = phi_5523_;
                                            if (_e2015 > _e2019) {
                                                phi_5528_ = _e2015;
                                            } else {
                                                phi_5528_ = _e2019;
                                            }
                                            let _e2022 = phi_5528_;
                                            if (_e2008[2] < 0f) {
                                                phi_5535_ = -(_e2008[2]);
                                            } else {
                                                phi_5535_ = _e2008[2];
                                            }
                                            let _e2026 = phi_5535_;
                                            if (_e2022 > _e2026) {
                                                phi_5540_ = _e2022;
                                            } else {
                                                phi_5540_ = _e2026;
                                            }
                                            let _e2029 = phi_5540_;
                                            let _e2032 = local_15.member[1u];
                                            if (_e2032[0] < 0f) {
                                                phi_5553_ = -(_e2032[0]);
                                            } else {
                                                phi_5553_ = _e2032[0];
                                            }
                                            let _e2039 = phi_5553_;
                                            if (_e2032[1] < 0f) {
                                                phi_5560_ = -(_e2032[1]);
                                            } else {
                                                phi_5560_ = _e2032[1];
                                            }
                                            let _e2043 = phi_5560_;
                                            if (_e2039 > _e2043) {
                                                phi_5565_ = _e2039;
                                            } else {
                                                phi_5565_ = _e2043;
                                            }
                                            let _e2046 = phi_5565_;
                                            if (_e2032[2] < 0f) {
                                                phi_5572_ = -(_e2032[2]);
                                            } else {
                                                phi_5572_ = _e2032[2];
                                            }
                                            let _e2050 = phi_5572_;
                                            if (_e2046 > _e2050) {
                                                phi_5577_ = _e2046;
                                            } else {
                                                phi_5577_ = _e2050;
                                            }
                                            let _e2053 = phi_5577_;
                                            if (_e2029 > _e2053) {
                                                phi_5582_ = _e2029;
                                            } else {
                                                phi_5582_ = _e2053;
                                            }
                                            let _e2056 = phi_5582_;
                                            let _e2058 = local_15.member_3;
                                            let _e2062 = local_15.member_1[0u];
                                            if (_e2062[0] < 0f) {
                                                phi_5599_ = -(_e2062[0]);
                                            } else {
                                                phi_5599_ = _e2062[0];
                                            }
                                            let _e2069 = phi_5599_;
                                            if (_e2062[1] < 0f) {
                                                phi_5606_ = -(_e2062[1]);
                                            } else {
                                                phi_5606_ = _e2062[1];
                                            }
                                            let _e2073 = phi_5606_;
                                            if (_e2069 > _e2073) {
                                                phi_5611_ = _e2069;
                                            } else {
                                                phi_5611_ = _e2073;
                                            }
                                            let _e2076 = phi_5611_;
                                            if (_e2062[2] < 0f) {
                                                phi_5618_ = -(_e2062[2]);
                                            } else {
                                                phi_5618_ = _e2062[2];
                                            }
                                            let _e2080 = phi_5618_;
                                            if (_e2076 > _e2080) {
                                                phi_5623_ = _e2076;
                                            } else {
                                                phi_5623_ = _e2080;
                                            }
                                            let _e2083 = phi_5623_;
                                            let _e2086 = local_15.member_1[1u];
                                            if (_e2086[0] < 0f) {
                                                phi_5637_ = -(_e2086[0]);
                                            } else {
                                                phi_5637_ = _e2086[0];
                                            }
                                            let _e2093 = phi_5637_;
                                            if (_e2086[1] < 0f) {
                                                phi_5644_ = -(_e2086[1]);
                                            } else {
                                                phi_5644_ = _e2086[1];
                                            }
                                            let _e2097 = phi_5644_;
                                            if (_e2093 > _e2097) {
                                                phi_5649_ = _e2093;
                                            } else {
                                                phi_5649_ = _e2097;
                                            }
                                            let _e2100 = phi_5649_;
                                            if (_e2086[2] < 0f) {
                                                phi_5656_ = -(_e2086[2]);
                                            } else {
                                                phi_5656_ = _e2086[2];
                                            }
                                            let _e2104 = phi_5656_;
                                            if (_e2100 > _e2104) {
                                                phi_5661_ = _e2100;
                                            } else {
                                                phi_5661_ = _e2104;
                                            }
                                            let _e2107 = phi_5661_;
                                            if (_e2083 > _e2107) {
                                                phi_5666_ = _e2083;
                                            } else {
                                                phi_5666_ = _e2107;
                                            }
                                            let _e2110 = phi_5666_;
                                            let _e2112 = local_15.member_3;
                                            let _e2116 = local_15.member_2[0u];
                                            if (_e2116[0] < 0f) {
                                                phi_5683_ = -(_e2116[0]);
                                            } else {
                                                phi_5683_ = _e2116[0];
                                            }
                                            let _e2123 = phi_5683_;
                                            if (_e2116[1] < 0f) {
                                                phi_5690_ = -(_e2116[1]);
                                            } else {
                                                phi_5690_ = _e2116[1];
                                            }
                                            let _e2127 = phi_5690_;
                                            if (_e2123 > _e2127) {
                                                phi_5695_ = _e2123;
                                            } else {
                                                phi_5695_ = _e2127;
                                            }
                                            let _e2130 = phi_5695_;
                                            if (_e2116[2] < 0f) {
                                                phi_5702_ = -(_e2116[2]);
                                            } else {
                                                phi_5702_ = _e2116[2];
                                            }
                                            let _e2134 = phi_5702_;
                                            if (_e2130 > _e2134) {
                                                phi_5707_ = _e2130;
                                            } else {
                                                phi_5707_ = _e2134;
                                            }
                                            let _e2137 = phi_5707_;
                                            let _e2140 = local_15.member_2[1u];
                                            if (_e2140[0] < 0f) {
                                                phi_5721_ = -(_e2140[0]);
                                            } else {
                                                phi_5721_ = _e2140[0];
                                            }
                                            let _e2147 = phi_5721_;
                                            if (_e2140[1] < 0f) {
                                                phi_5728_ = -(_e2140[1]);
                                            } else {
                                                phi_5728_ = _e2140[1];
                                            }
                                            let _e2151 = phi_5728_;
                                            if (_e2147 > _e2151) {
                                                phi_5733_ = _e2147;
                                            } else {
                                                phi_5733_ = _e2151;
                                            }
                                            let _e2154 = phi_5733_;
                                            if (_e2140[2] < 0f) {
                                                phi_5740_ = -(_e2140[2]);
                                            } else {
                                                phi_5740_ = _e2140[2];
                                            }
                                            let _e2158 = phi_5740_;
                                            if (_e2154 > _e2158) {
                                                phi_5745_ = _e2154;
                                            } else {
                                                phi_5745_ = _e2158;
                                            }
                                            let _e2161 = phi_5745_;
                                            if (_e2137 > _e2161) {
                                                phi_5750_ = _e2137;
                                            } else {
                                                phi_5750_ = _e2161;
                                            }
                                            let _e2164 = phi_5750_;
                                            let _e2166 = local_15.member_3;
                                            let _e2173 = local_15.member_3;
                                            phi_5766_ = type_28(0u, 48u);
                                            phi_5769_ = _e1211.member;
                                            loop {
                                                let _e2179 = phi_5766_;
                                                let _e2181 = phi_5769_;
                                                local_65 = _e2181;
                                                local_27 = _e2181;
                                                local_28 = _e2181;
                                                local_29 = _e2181;
                                                local_30 = _e2181;
                                                if (_e2179.member < _e2179.member_1) {
                                                    phi_5767_ = type_28((_e2179.member + 1u), _e2179.member_1);
                                                    phi_5792_ = type_28(1u, _e2179.member);
                                                } else {
                                                    phi_5767_ = _e2179;
                                                    phi_5792_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e2195 = phi_5767_;
                                                let _e2197 = phi_5792_;
                                                if (bitcast<i32>(_e2197.member) != 0i) {
                                                    let _e2203 = local_15.member[0u];
                                                    let _e2209 = local_15.member[1u];
                                                    let _e2219 = (_e2203[0] + ((_e2209[0] - _e2203[0]) * _e2181));
                                                    let _e2220 = (_e2203[1] + ((_e2209[1] - _e2203[1]) * _e2181));
                                                    let _e2221 = (_e2203[2] + ((_e2209[2] - _e2203[2]) * _e2181));
                                                    let _e2224 = local_15.member_1[0u];
                                                    let _e2230 = local_15.member_1[1u];
                                                    let _e2240 = (_e2224[0] + ((_e2230[0] - _e2224[0]) * _e2181));
                                                    let _e2241 = (_e2224[1] + ((_e2230[1] - _e2224[1]) * _e2181));
                                                    let _e2242 = (_e2224[2] + ((_e2230[2] - _e2224[2]) * _e2181));
                                                    let _e2245 = local_15.member_2[0u];
                                                    let _e2251 = local_15.member_2[1u];
                                                    let _e2261 = (_e2245[0] + ((_e2251[0] - _e2245[0]) * _e2181));
                                                    let _e2262 = (_e2245[1] + ((_e2251[1] - _e2245[1]) * _e2181));
                                                    let _e2263 = (_e2245[2] + ((_e2251[2] - _e2245[2]) * _e2181));
                                                    let _e2268 = (((_e2240 * _e2240) + (_e2241 * _e2241)) + (_e2242 * _e2242));
                                                    let _e2273 = (((_e2240 * _e2261) + (_e2241 * _e2262)) + (_e2242 * _e2263));
                                                    let _e2278 = (((_e2261 * _e2261) + (_e2262 * _e2262)) + (_e2263 * _e2263));
                                                    let _e2283 = (((_e2219 * _e2240) + (_e2220 * _e2241)) + (_e2221 * _e2242));
                                                    let _e2288 = (((_e2219 * _e2261) + (_e2220 * _e2262)) + (_e2221 * _e2263));
                                                    let _e2291 = ((_e2268 * _e2278) - (_e2273 * _e2273));
                                                    let _e2295 = (((_e2283 * _e2278) - (_e2288 * _e2273)) / _e2291);
                                                    let _e2299 = (((_e2288 * _e2268) - (_e2283 * _e2273)) / _e2291);
                                                    if (_e2295 >= 0f) {
                                                        if (_e2299 >= 0f) {
                                                            if (_e2295 <= 1f) {
                                                                phi_5946_ = (_e2299 <= 1f);
                                                                phi_5947_ = false;
                                                            } else {
                                                                phi_5946_ = bool();
                                                                phi_5947_ = true;
                                                            }
                                                            let _e2305 = phi_5946_;
                                                            let _e2307 = phi_5947_;
                                                            phi_5948_ = _e2305;
                                                            phi_5949_ = _e2307;
                                                        } else {
                                                            phi_5948_ = bool();
                                                            phi_5949_ = true;
                                                        }
                                                        let _e2309 = phi_5948_;
                                                        let _e2311 = phi_5949_;
                                                        phi_5950_ = _e2309;
                                                        phi_5951_ = _e2311;
                                                    } else {
                                                        phi_5950_ = bool();
                                                        phi_5951_ = true;
                                                    }
                                                    let _e2313 = phi_5950_;
                                                    let _e2315 = phi_5951_;
                                                    if _e2315 {
                                                        phi_5955_ = false;
                                                    } else {
                                                        phi_5955_ = _e2313;
                                                    }
                                                    let _e2317 = phi_5955_;
                                                    if (_e2291 > 0f) {
                                                        if _e2317 {
                                                            phi_5995_ = array<f32, 3>((_e2219 - ((_e2240 * _e2295) + (_e2261 * _e2299))), (_e2220 - ((_e2241 * _e2295) + (_e2262 * _e2299))), (_e2221 - ((_e2242 * _e2295) + (_e2263 * _e2299))));
                                                            phi_5996_ = false;
                                                        } else {
                                                            phi_5995_ = array<f32, 3>();
                                                            phi_5996_ = true;
                                                        }
                                                        let _e2333 = phi_5995_;
                                                        let _e2335 = phi_5996_;
                                                        phi_5997_ = _e2333;
                                                        phi_5998_ = _e2335;
                                                    } else {
                                                        phi_5997_ = array<f32, 3>();
                                                        phi_5998_ = true;
                                                    }
                                                    let _e2337 = phi_5997_;
                                                    let _e2339 = phi_5998_;
                                                    if _e2339 {
                                                        let _e2340 = (_e2219 - _e2240);
                                                        let _e2341 = (_e2220 - _e2241);
                                                        let _e2342 = (_e2221 - _e2242);
                                                        let _e2353 = ((((_e2219 * _e2240) + (_e2220 * _e2241)) + (_e2221 * _e2242)) / (((_e2240 * _e2240) + (_e2241 * _e2241)) + (_e2242 * _e2242)));
                                                        if (_e2353 > 0f) {
                                                            if (_e2353 < 1f) {
                                                                phi_6028_ = _e2353;
                                                            } else {
                                                                phi_6028_ = 1f;
                                                            }
                                                            let _e2357 = phi_6028_;
                                                            phi_6029_ = _e2357;
                                                        } else {
                                                            phi_6029_ = 0f;
                                                        }
                                                        let _e2359 = phi_6029_;
                                                        let _e2376 = ((((_e2219 * _e2261) + (_e2220 * _e2262)) + (_e2221 * _e2263)) / (((_e2261 * _e2261) + (_e2262 * _e2262)) + (_e2263 * _e2263)));
                                                        if (_e2376 > 0f) {
                                                            if (_e2376 < 1f) {
                                                                phi_6056_ = _e2376;
                                                            } else {
                                                                phi_6056_ = 1f;
                                                            }
                                                            let _e2380 = phi_6056_;
                                                            phi_6057_ = _e2380;
                                                        } else {
                                                            phi_6057_ = 0f;
                                                        }
                                                        let _e2382 = phi_6057_;
                                                        let _e2399 = ((((_e2340 * _e2261) + (_e2341 * _e2262)) + (_e2342 * _e2263)) / (((_e2261 * _e2261) + (_e2262 * _e2262)) + (_e2263 * _e2263)));
                                                        if (_e2399 > 0f) {
                                                            if (_e2399 < 1f) {
                                                                phi_6084_ = _e2399;
                                                            } else {
                                                                phi_6084_ = 1f;
                                                            }
                                                            let _e2403 = phi_6084_;
                                                            phi_6085_ = _e2403;
                                                        } else {
                                                            phi_6085_ = 0f;
                                                        }
                                                        let _e2405 = phi_6085_;
                                                        let _e2412 = (_e2219 - _e2261);
                                                        let _e2413 = (_e2220 - _e2262);
                                                        let _e2414 = (_e2221 - _e2263);
                                                        let _e2425 = ((((_e2412 * _e2240) + (_e2413 * _e2241)) + (_e2414 * _e2242)) / (((_e2240 * _e2240) + (_e2241 * _e2241)) + (_e2242 * _e2242)));
                                                        if (_e2425 > 0f) {
                                                            if (_e2425 < 1f) {
                                                                phi_6115_ = _e2425;
                                                            } else {
                                                                phi_6115_ = 1f;
                                                            }
                                                            let _e2429 = phi_6115_;
                                                            phi_6116_ = _e2429;
                                                        } else {
                                                            phi_6116_ = 0f;
                                                        }
                                                        let _e2431 = phi_6116_;
                                                        local[0u] = array<f32, 3>((_e2219 - (_e2240 * _e2359)), (_e2220 - (_e2241 * _e2359)), (_e2221 - (_e2242 * _e2359)));
                                                        local[1u] = array<f32, 3>((_e2219 - (_e2261 * _e2382)), (_e2220 - (_e2262 * _e2382)), (_e2221 - (_e2263 * _e2382)));
                                                        local[2u] = array<f32, 3>((_e2340 - (_e2261 * _e2405)), (_e2341 - (_e2262 * _e2405)), (_e2342 - (_e2263 * _e2405)));
                                                        local[3u] = array<f32, 3>((_e2412 - (_e2240 * _e2431)), (_e2413 - (_e2241 * _e2431)), (_e2414 - (_e2242 * _e2431)));
                                                        let _e2447 = local[0u];
                                                        phi_6259_ = type_28(1u, 4u);
                                                        phi_6262_ = array<f32, 3>(_e2447[0], _e2447[1], _e2447[2]);
                                                        loop {
                                                            let _e2453 = phi_6259_;
                                                            let _e2455 = phi_6262_;
                                                            local_52 = _e2455;
                                                            if (_e2453.member < _e2453.member_1) {
                                                                phi_6260_ = type_28((_e2453.member + 1u), _e2453.member_1);
                                                                phi_6285_ = type_28(1u, _e2453.member);
                                                            } else {
                                                                phi_6260_ = _e2453;
                                                                phi_6285_ = type_28(0u, type_28().member_1);
                                                            }
                                                            let _e2469 = phi_6260_;
                                                            let _e2471 = phi_6285_;
                                                            let _e2475 = (bitcast<i32>(_e2471.member) != 0i);
                                                            if _e2475 {
                                                                if (_e2471.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2478 = local[_e2471.member_1];
                                                                if (_e2471.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2484 = local[_e2471.member_1];
                                                                if ((((_e2478[0] * _e2484[0]) + (_e2478[1] * _e2484[1])) + (_e2478[2] * _e2484[2])) < (((_e2455[0] * _e2455[0]) + (_e2455[1] * _e2455[1])) + (_e2455[2] * _e2455[2]))) {
                                                                    if (_e2471.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2507 = local[_e2471.member_1];
                                                                    phi_6352_ = array<f32, 3>(_e2507[0], _e2507[1], _e2507[2]);
                                                                } else {
                                                                    phi_6352_ = _e2455;
                                                                }
                                                                let _e2513 = phi_6352_;
                                                                phi_6263_ = _e2513;
                                                            } else {
                                                                phi_6263_ = array<f32, 3>();
                                                            }
                                                            let _e2515 = phi_6263_;
                                                            continue;
                                                            continuing {
                                                                phi_6259_ = _e2469;
                                                                phi_6262_ = _e2515;
                                                                break if !(_e2475);
                                                            }
                                                        }
                                                        let _e5183 = local_52;
                                                        phi_6353_ = _e5183;
                                                    } else {
                                                        phi_6353_ = _e2337;
                                                    }
                                                    let _e2518 = phi_6353_;
                                                    if (_e2518[0] < 0f) {
                                                        phi_6360_ = -(_e2518[0]);
                                                    } else {
                                                        phi_6360_ = _e2518[0];
                                                    }
                                                    let _e2523 = phi_6360_;
                                                    if (_e2518[1] < 0f) {
                                                        phi_6367_ = -(_e2518[1]);
                                                    } else {
                                                        phi_6367_ = _e2518[1];
                                                    }
                                                    let _e2528 = phi_6367_;
                                                    if (_e2518[2] < 0f) {
                                                        phi_6375_ = -(_e2518[2]);
                                                    } else {
                                                        phi_6375_ = _e2518[2];
                                                    }
                                                    let _e2534 = phi_6375_;
                                                    let _e2535 = ((_e2523 + _e2528) + _e2534);
                                                    if (_e2535 > 0f) {
                                                        if ((bitcast<u32>(_e2535) & 2139095040u) != 2139095040u) {
                                                            let _e2540 = (1f / _e2535);
                                                            let _e2542 = (_e2518[0] * _e2540);
                                                            let _e2544 = (_e2518[1] * _e2540);
                                                            let _e2546 = (_e2518[2] * _e2540);
                                                            let _e2551 = (((_e2542 * _e2542) + (_e2544 * _e2544)) + (_e2546 * _e2546));
                                                            if (_e2551 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2551 > 0f) {
                                                                    phi_6412_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6412_ = 0f;
                                                                }
                                                                let _e2610 = phi_6412_;
                                                                phi_6476_ = _e2610;
                                                            } else {
                                                                phi_6419_ = type_26(0i, 5i);
                                                                phi_6422_ = bitcast<f32>(((bitcast<u32>(_e2551) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2559 = phi_6419_;
                                                                    let _e2561 = phi_6422_;
                                                                    local_21 = _e2561;
                                                                    if (_e2559.member < _e2559.member_1) {
                                                                        let _e2569 = (_e2559.member + 1i);
                                                                        if ((false == (_e2569 > _e2559.member)) != false) {
                                                                            phi_6443_ = true;
                                                                        } else {
                                                                            phi_6443_ = false;
                                                                        }
                                                                        let _e2574 = phi_6443_;
                                                                        if _e2574 {
                                                                            phi_6449_ = type_27(0u, type_27().member_1);
                                                                        } else {
                                                                            phi_6449_ = type_27(1u, _e2569);
                                                                        }
                                                                        let _e2580 = phi_6449_;
                                                                        if (bitcast<i32>(_e2580.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_6420_ = type_26(_e2580.member_1, _e2559.member_1);
                                                                        phi_6463_ = type_27(1u, _e2559.member);
                                                                    } else {
                                                                        phi_6420_ = _e2559;
                                                                        phi_6463_ = type_27(0u, type_27().member_1);
                                                                    }
                                                                    let _e2590 = phi_6420_;
                                                                    let _e2592 = phi_6463_;
                                                                    let _e2595 = (bitcast<i32>(_e2592.member) != 0i);
                                                                    if _e2595 {
                                                                        phi_6423_ = (0.5f * (_e2561 + (_e2551 / _e2561)));
                                                                    } else {
                                                                        phi_6423_ = f32();
                                                                    }
                                                                    let _e2600 = phi_6423_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6419_ = _e2590;
                                                                        phi_6422_ = _e2600;
                                                                        break if !(_e2595);
                                                                    }
                                                                }
                                                                let _e2605 = local_21;
                                                                phi_6476_ = (_e2605 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2612 = phi_6476_;
                                                            phi_6485_ = type_28(0u, 4u);
                                                            phi_6488_ = 2f;
                                                            loop {
                                                                let _e2620 = phi_6485_;
                                                                let _e2622 = phi_6488_;
                                                                local_23 = _e2622;
                                                                local_24 = _e2622;
                                                                local_25 = _e2622;
                                                                local_55 = _e2622;
                                                                local_56 = _e2622;
                                                                if (_e2620.member < _e2620.member_1) {
                                                                    phi_6486_ = type_28((_e2620.member + 1u), _e2620.member_1);
                                                                    phi_6511_ = type_28(1u, _e2620.member);
                                                                } else {
                                                                    phi_6486_ = _e2620;
                                                                    phi_6511_ = type_28(0u, type_28().member_1);
                                                                }
                                                                let _e2636 = phi_6486_;
                                                                let _e2638 = phi_6511_;
                                                                if (bitcast<i32>(_e2638.member) != 0i) {
                                                                    if (_e2638.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2645 = local_1[_e2638.member_1];
                                                                    let _e2653 = (((_e2542 * _e2645[0]) + (_e2544 * _e2645[1])) + (_e2546 * _e2645[2]));
                                                                    if (_e2638.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2656 = local_2[_e2638.member_1];
                                                                    let _e2664 = (((_e2542 * _e2656[0]) + (_e2544 * _e2656[1])) + (_e2546 * _e2656[2]));
                                                                    if (_e2653 < 0f) {
                                                                        phi_6562_ = -(_e2653);
                                                                    } else {
                                                                        phi_6562_ = _e2653;
                                                                    }
                                                                    let _e2668 = phi_6562_;
                                                                    if (_e2664 < 0f) {
                                                                        phi_6568_ = -(_e2664);
                                                                    } else {
                                                                        phi_6568_ = _e2664;
                                                                    }
                                                                    let _e2672 = phi_6568_;
                                                                    let _e2676 = (((((((((_e2056 + _e2058) + (_e2110 + _e2112)) + (_e2164 + _e2166)) * (0.000000059604645f * 16f)) + (_e2173 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2612) * (1f + (0.000000059604645f * 8f)))) + ((_e2668 + _e2672) * (0.000000059604645f * 8f)));
                                                                    if (_e2653 > _e2676) {
                                                                        if (_e2664 > _e2676) {
                                                                            phi_6581_ = false;
                                                                        } else {
                                                                            phi_6581_ = true;
                                                                        }
                                                                        let _e2680 = phi_6581_;
                                                                        phi_6582_ = _e2680;
                                                                    } else {
                                                                        phi_6582_ = true;
                                                                    }
                                                                    let _e2682 = phi_6582_;
                                                                    if _e2682 {
                                                                        if ((_e2653 + ((_e2664 - _e2653) * _e2181)) > _e2676) {
                                                                            if (_e2664 < _e2653) {
                                                                                let _e2690 = ((_e2653 - _e2664) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                                                if _e2690 {
                                                                                    let _e2696 = (((_e2653 - _e2676) / (_e2653 - _e2664)) * (1f - (0.000000059604645f * 16f)));
                                                                                    if (_e2622 < _e2696) {
                                                                                        phi_6613_ = _e2622;
                                                                                    } else {
                                                                                        phi_6613_ = _e2696;
                                                                                    }
                                                                                    let _e2699 = phi_6613_;
                                                                                    phi_6614_ = _e2699;
                                                                                } else {
                                                                                    phi_6614_ = f32();
                                                                                }
                                                                                let _e2701 = phi_6614_;
                                                                                phi_6615_ = _e2701;
                                                                                phi_6616_ = _e2690;
                                                                            } else {
                                                                                phi_6615_ = _e2622;
                                                                                phi_6616_ = true;
                                                                            }
                                                                            let _e2703 = phi_6615_;
                                                                            let _e2705 = phi_6616_;
                                                                            if _e2705 {
                                                                                phi_6620_ = false;
                                                                            } else {
                                                                                phi_6620_ = true;
                                                                            }
                                                                            let _e2707 = phi_6620_;
                                                                            phi_6621_ = _e2703;
                                                                            phi_6622_ = _e2705;
                                                                            phi_6623_ = _e2707;
                                                                            phi_6624_ = false;
                                                                        } else {
                                                                            phi_6621_ = f32();
                                                                            phi_6622_ = false;
                                                                            phi_6623_ = false;
                                                                            phi_6624_ = true;
                                                                        }
                                                                        let _e2709 = phi_6621_;
                                                                        let _e2711 = phi_6622_;
                                                                        let _e2713 = phi_6623_;
                                                                        let _e2715 = phi_6624_;
                                                                        phi_6625_ = _e2709;
                                                                        phi_6626_ = _e2711;
                                                                        phi_6627_ = _e2713;
                                                                        phi_6628_ = _e2715;
                                                                    } else {
                                                                        phi_6625_ = _e2622;
                                                                        phi_6626_ = true;
                                                                        phi_6627_ = false;
                                                                        phi_6628_ = false;
                                                                    }
                                                                    let _e2717 = phi_6625_;
                                                                    let _e2719 = phi_6626_;
                                                                    let _e2721 = phi_6627_;
                                                                    let _e2723 = phi_6628_;
                                                                    phi_6489_ = _e2717;
                                                                    phi_6629_ = _e2719;
                                                                    phi_6630_ = false;
                                                                    phi_6631_ = _e2721;
                                                                    phi_6632_ = _e2723;
                                                                } else {
                                                                    phi_6489_ = f32();
                                                                    phi_6629_ = false;
                                                                    phi_6630_ = true;
                                                                    phi_6631_ = false;
                                                                    phi_6632_ = false;
                                                                }
                                                                let _e2725 = phi_6489_;
                                                                let _e2727 = phi_6629_;
                                                                let _e2729 = phi_6630_;
                                                                let _e2731 = phi_6631_;
                                                                let _e2733 = phi_6632_;
                                                                local_22 = _e2729;
                                                                local_53 = _e2731;
                                                                local_54 = _e2733;
                                                                continue;
                                                                continuing {
                                                                    phi_6485_ = _e2636;
                                                                    phi_6488_ = _e2725;
                                                                    break if !(_e2727);
                                                                }
                                                            }
                                                            let _e2736 = local_22;
                                                            if _e2736 {
                                                                let _e2738 = local_23;
                                                                let _e2739 = (_e2738 > _e1211.member_1);
                                                                if _e2739 {
                                                                    phi_6653_ = false;
                                                                    phi_6654_ = false;
                                                                    phi_6655_ = false;
                                                                } else {
                                                                    let _e2741 = local_24;
                                                                    if (_e2741 > _e2181) {
                                                                        let _e2744 = local_25;
                                                                        let _e2746 = ((_e2744 - _e2181) < 0.00000000023283064f);
                                                                        if _e2746 {
                                                                            phi_6649_ = false;
                                                                        } else {
                                                                            phi_6649_ = true;
                                                                        }
                                                                        let _e2748 = phi_6649_;
                                                                        phi_6650_ = _e2748;
                                                                        phi_6651_ = _e2746;
                                                                        phi_6652_ = false;
                                                                    } else {
                                                                        phi_6650_ = false;
                                                                        phi_6651_ = false;
                                                                        phi_6652_ = true;
                                                                    }
                                                                    let _e2750 = phi_6650_;
                                                                    let _e2752 = phi_6651_;
                                                                    let _e2754 = phi_6652_;
                                                                    phi_6653_ = _e2750;
                                                                    phi_6654_ = _e2752;
                                                                    phi_6655_ = _e2754;
                                                                }
                                                                let _e2756 = phi_6653_;
                                                                let _e2758 = phi_6654_;
                                                                let _e2760 = phi_6655_;
                                                                phi_6656_ = _e2756;
                                                                phi_6657_ = _e2739;
                                                                phi_6658_ = _e2758;
                                                                phi_6659_ = _e2760;
                                                                phi_6660_ = false;
                                                                phi_6661_ = false;
                                                            } else {
                                                                phi_6656_ = false;
                                                                phi_6657_ = false;
                                                                phi_6658_ = false;
                                                                phi_6659_ = false;
                                                                let _e5240 = local_53;
                                                                phi_6660_ = _e5240;
                                                                let _e5243 = local_54;
                                                                phi_6661_ = _e5243;
                                                            }
                                                            let _e2762 = phi_6656_;
                                                            let _e2764 = phi_6657_;
                                                            let _e2766 = phi_6658_;
                                                            let _e2768 = phi_6659_;
                                                            let _e2770 = phi_6660_;
                                                            let _e2772 = phi_6661_;
                                                            let _e5246 = local_55;
                                                            phi_6662_ = _e5246;
                                                            let _e5249 = local_56;
                                                            phi_6663_ = _e5249;
                                                            phi_6664_ = _e2762;
                                                            phi_6665_ = _e2764;
                                                            phi_6666_ = _e2766;
                                                            phi_6667_ = _e2768;
                                                            phi_6668_ = _e2770;
                                                            phi_6669_ = _e2772;
                                                            phi_6670_ = false;
                                                        } else {
                                                            phi_6662_ = f32();
                                                            phi_6663_ = f32();
                                                            phi_6664_ = false;
                                                            phi_6665_ = false;
                                                            phi_6666_ = false;
                                                            phi_6667_ = false;
                                                            phi_6668_ = false;
                                                            phi_6669_ = false;
                                                            phi_6670_ = true;
                                                        }
                                                        let _e2774 = phi_6662_;
                                                        let _e2776 = phi_6663_;
                                                        let _e2778 = phi_6664_;
                                                        let _e2780 = phi_6665_;
                                                        let _e2782 = phi_6666_;
                                                        let _e2784 = phi_6667_;
                                                        let _e2786 = phi_6668_;
                                                        let _e2788 = phi_6669_;
                                                        let _e2790 = phi_6670_;
                                                        phi_6671_ = _e2774;
                                                        phi_6672_ = _e2776;
                                                        phi_6673_ = _e2778;
                                                        phi_6674_ = _e2780;
                                                        phi_6675_ = _e2782;
                                                        phi_6676_ = _e2784;
                                                        phi_6677_ = _e2786;
                                                        phi_6678_ = _e2788;
                                                        phi_6679_ = _e2790;
                                                        phi_6680_ = false;
                                                    } else {
                                                        phi_6671_ = f32();
                                                        phi_6672_ = f32();
                                                        phi_6673_ = false;
                                                        phi_6674_ = false;
                                                        phi_6675_ = false;
                                                        phi_6676_ = false;
                                                        phi_6677_ = false;
                                                        phi_6678_ = false;
                                                        phi_6679_ = false;
                                                        phi_6680_ = true;
                                                    }
                                                    let _e2792 = phi_6671_;
                                                    let _e2794 = phi_6672_;
                                                    let _e2796 = phi_6673_;
                                                    let _e2798 = phi_6674_;
                                                    let _e2800 = phi_6675_;
                                                    let _e2802 = phi_6676_;
                                                    let _e2804 = phi_6677_;
                                                    let _e2806 = phi_6678_;
                                                    let _e2808 = phi_6679_;
                                                    let _e2810 = phi_6680_;
                                                    phi_6681_ = _e2792;
                                                    phi_5770_ = _e2794;
                                                    phi_6682_ = _e2796;
                                                    phi_6683_ = _e2798;
                                                    phi_6684_ = _e2800;
                                                    phi_6685_ = false;
                                                    phi_6686_ = _e2802;
                                                    phi_6687_ = _e2804;
                                                    phi_6688_ = _e2806;
                                                    phi_6689_ = _e2808;
                                                    phi_6690_ = _e2810;
                                                } else {
                                                    phi_6681_ = f32();
                                                    phi_5770_ = f32();
                                                    phi_6682_ = false;
                                                    phi_6683_ = false;
                                                    phi_6684_ = false;
                                                    phi_6685_ = true;
                                                    phi_6686_ = false;
                                                    phi_6687_ = false;
                                                    phi_6688_ = false;
                                                    phi_6689_ = false;
                                                    phi_6690_ = false;
                                                }
                                                let _e2812 = phi_6681_;
                                                let _e2814 = phi_5770_;
                                                let _e2816 = phi_6682_;
                                                let _e2818 = phi_6683_;
                                                let _e2820 = phi_6684_;
                                                let _e2822 = phi_6685_;
                                                let _e2824 = phi_6686_;
                                                let _e2826 = phi_6687_;
                                                let _e2828 = phi_6688_;
                                                let _e2830 = phi_6689_;
                                                let _e2832 = phi_6690_;
                                                local_26 = _e2818;
                                                local_57 = _e2820;
                                                local_58 = _e2822;
                                                local_59 = _e2824;
                                                local_60 = _e2826;
                                                local_61 = _e2828;
                                                local_62 = _e2830;
                                                local_63 = _e2832;
                                                local_64 = _e2812;
                                                local_66 = _e2818;
                                                continue;
                                                continuing {
                                                    phi_5766_ = _e2195;
                                                    phi_5769_ = _e2814;
                                                    break if !(_e2816);
                                                }
                                            }
                                            let _e2835 = local_26;
                                            if _e2835 {
                                                phi_6695_ = type_55(0u, type_55().member_1);
                                                phi_6696_ = false;
                                                phi_6697_ = false;
                                                phi_6698_ = false;
                                                phi_6699_ = false;
                                                phi_6700_ = false;
                                                phi_6701_ = false;
                                                phi_6702_ = false;
                                            } else {
                                                phi_6695_ = type_55();
                                                let _e5282 = local_57;
                                                phi_6696_ = _e5282;
                                                let _e5285 = local_58;
                                                phi_6697_ = _e5285;
                                                let _e5288 = local_59;
                                                phi_6698_ = _e5288;
                                                let _e5291 = local_60;
                                                phi_6699_ = _e5291;
                                                let _e5294 = local_61;
                                                phi_6700_ = _e5294;
                                                let _e5297 = local_62;
                                                phi_6701_ = _e5297;
                                                let _e5300 = local_63;
                                                phi_6702_ = _e5300;
                                            }
                                            let _e2840 = phi_6695_;
                                            let _e2842 = phi_6696_;
                                            let _e2844 = phi_6697_;
                                            let _e2846 = phi_6698_;
                                            let _e2848 = phi_6699_;
                                            let _e2850 = phi_6700_;
                                            let _e2852 = phi_6701_;
                                            let _e2854 = phi_6702_;
                                            if _e2842 {
                                                let _e5303 = local_64;
                                                phi_6706_ = _e5303;
                                                phi_6707_ = true;
                                                phi_6708_ = false;
                                                phi_6709_ = false;
                                                phi_6710_ = false;
                                                phi_6711_ = false;
                                                phi_6712_ = false;
                                                phi_6713_ = false;
                                            } else {
                                                let _e5305 = local_65;
                                                phi_6706_ = _e5305;
                                                phi_6707_ = _e2844;
                                                phi_6708_ = _e2846;
                                                phi_6709_ = _e2848;
                                                phi_6710_ = _e2850;
                                                let _e5312 = local_66;
                                                phi_6711_ = _e5312;
                                                phi_6712_ = _e2852;
                                                phi_6713_ = _e2854;
                                            }
                                            let _e2856 = phi_6706_;
                                            let _e2858 = phi_6707_;
                                            let _e2860 = phi_6708_;
                                            let _e2862 = phi_6709_;
                                            let _e2864 = phi_6710_;
                                            let _e2866 = phi_6711_;
                                            let _e2868 = phi_6712_;
                                            let _e2870 = phi_6713_;
                                            if _e2858 {
                                                phi_6718_ = type_55(1u, _e2856);
                                                phi_6719_ = false;
                                                phi_6720_ = false;
                                                phi_6721_ = false;
                                                phi_6722_ = false;
                                                phi_6723_ = false;
                                                phi_6724_ = false;
                                            } else {
                                                phi_6718_ = type_55();
                                                phi_6719_ = _e2860;
                                                phi_6720_ = _e2862;
                                                phi_6721_ = _e2864;
                                                phi_6722_ = _e2866;
                                                phi_6723_ = _e2868;
                                                phi_6724_ = _e2870;
                                            }
                                            let _e2873 = phi_6718_;
                                            let _e2875 = phi_6719_;
                                            let _e2877 = phi_6720_;
                                            let _e2879 = phi_6721_;
                                            let _e2881 = phi_6722_;
                                            let _e2883 = phi_6723_;
                                            let _e2885 = phi_6724_;
                                            if _e2875 {
                                                let _e2887 = local_27;
                                                phi_6729_ = type_55(1u, _e2887);
                                                phi_6730_ = false;
                                                phi_6731_ = false;
                                                phi_6732_ = true;
                                                phi_6733_ = false;
                                                phi_6734_ = false;
                                            } else {
                                                phi_6729_ = _e2840;
                                                phi_6730_ = _e2877;
                                                phi_6731_ = _e2879;
                                                phi_6732_ = _e2881;
                                                phi_6733_ = _e2883;
                                                phi_6734_ = _e2885;
                                            }
                                            let _e2890 = phi_6729_;
                                            let _e2892 = phi_6730_;
                                            let _e2894 = phi_6731_;
                                            let _e2896 = phi_6732_;
                                            let _e2898 = phi_6733_;
                                            let _e2900 = phi_6734_;
                                            if _e2892 {
                                                let _e2902 = local_28;
                                                phi_6739_ = type_55(1u, _e2902);
                                                phi_6740_ = false;
                                                phi_6741_ = false;
                                                phi_6742_ = false;
                                                phi_6743_ = false;
                                            } else {
                                                phi_6739_ = type_55();
                                                phi_6740_ = _e2894;
                                                phi_6741_ = _e2896;
                                                phi_6742_ = _e2898;
                                                phi_6743_ = _e2900;
                                            }
                                            let _e2905 = phi_6739_;
                                            let _e2907 = phi_6740_;
                                            let _e2909 = phi_6741_;
                                            let _e2911 = phi_6742_;
                                            let _e2913 = phi_6743_;
                                            if _e2907 {
                                                let _e2915 = local_29;
                                                phi_6748_ = type_55(1u, _e2915);
                                                phi_6749_ = true;
                                                phi_6750_ = false;
                                                phi_6751_ = false;
                                                phi_6752_ = false;
                                            } else {
                                                phi_6748_ = _e2905;
                                                phi_6749_ = _e2892;
                                                phi_6750_ = _e2909;
                                                phi_6751_ = _e2911;
                                                phi_6752_ = _e2913;
                                            }
                                            let _e2918 = phi_6748_;
                                            let _e2920 = phi_6749_;
                                            let _e2922 = phi_6750_;
                                            let _e2924 = phi_6751_;
                                            let _e2926 = phi_6752_;
                                            if _e2920 {
                                                phi_6756_ = _e2918;
                                                phi_6757_ = true;
                                                phi_6758_ = false;
                                                phi_6759_ = false;
                                            } else {
                                                phi_6756_ = _e2890;
                                                phi_6757_ = _e2922;
                                                phi_6758_ = _e2924;
                                                phi_6759_ = _e2926;
                                            }
                                            let _e2928 = phi_6756_;
                                            let _e2930 = phi_6757_;
                                            let _e2932 = phi_6758_;
                                            let _e2934 = phi_6759_;
                                            if _e2930 {
                                                phi_6763_ = false;
                                                phi_6764_ = false;
                                            } else {
                                                phi_6763_ = _e2932;
                                                phi_6764_ = _e2934;
                                            }
                                            let _e2936 = phi_6763_;
                                            let _e2938 = phi_6764_;
                                            if _e2936 {
                                                phi_6768_ = false;
                                                phi_6769_ = false;
                                            } else {
                                                phi_6768_ = _e2938;
                                                phi_6769_ = _e2930;
                                            }
                                            let _e2940 = phi_6768_;
                                            let _e2942 = phi_6769_;
                                            if _e2940 {
                                                phi_6773_ = true;
                                                phi_6774_ = false;
                                            } else {
                                                phi_6773_ = _e2936;
                                                phi_6774_ = _e2942;
                                            }
                                            let _e2944 = phi_6773_;
                                            let _e2946 = phi_6774_;
                                            if _e2944 {
                                                let _e2948 = local_30;
                                                phi_6779_ = type_55(1u, _e2948);
                                                phi_6780_ = true;
                                            } else {
                                                phi_6779_ = _e2928;
                                                phi_6780_ = _e2946;
                                            }
                                            let _e2951 = phi_6779_;
                                            let _e2953 = phi_6780_;
                                            if _e2953 {
                                                phi_6784_ = _e2951;
                                            } else {
                                                phi_6784_ = _e2873;
                                            }
                                            let _e2955 = phi_6784_;
                                            let _e2958 = (_e2955.member != 0u);
                                            if _e2958 {
                                                phi_6791_ = false;
                                            } else {
                                                phi_6791_ = true;
                                            }
                                            let _e2960 = phi_6791_;
                                            phi_6792_ = _e2955.member_1;
                                            phi_6793_ = _e2960;
                                            phi_6794_ = _e2958;
                                            phi_6795_ = false;
                                        } else {
                                            phi_6792_ = f32();
                                            phi_6793_ = false;
                                            phi_6794_ = false;
                                            phi_6795_ = true;
                                        }
                                        let _e2962 = phi_6792_;
                                        let _e2964 = phi_6793_;
                                        let _e2966 = phi_6794_;
                                        let _e2968 = phi_6795_;
                                        phi_6796_ = _e2962;
                                        phi_6797_ = _e2964;
                                        phi_6798_ = _e2966;
                                        phi_6799_ = _e2968;
                                    }
                                    let _e2970 = phi_6796_;
                                    let _e2972 = phi_6797_;
                                    let _e2974 = phi_6798_;
                                    let _e2976 = phi_6799_;
                                    phi_6800_ = _e2970;
                                    phi_6801_ = _e1929;
                                    phi_6802_ = _e2972;
                                    phi_6803_ = _e2974;
                                    phi_6804_ = _e2976;
                                }
                                let _e2978 = phi_6800_;
                                let _e2980 = phi_6801_;
                                let _e2982 = phi_6802_;
                                let _e2984 = phi_6803_;
                                let _e2986 = phi_6804_;
                                if _e2980 {
                                    phi_6808_ = true;
                                    phi_6809_ = false;
                                    phi_6810_ = false;
                                } else {
                                    phi_6808_ = _e2982;
                                    phi_6809_ = _e2984;
                                    phi_6810_ = _e2986;
                                }
                                let _e2988 = phi_6808_;
                                let _e2990 = phi_6809_;
                                let _e2992 = phi_6810_;
                                phi_6811_ = _e2978;
                                phi_6812_ = _e1211;
                                phi_6813_ = _e2988;
                                phi_6814_ = false;
                                phi_6815_ = _e2990;
                                phi_6816_ = _e2992;
                            } else {
                                phi_6811_ = f32();
                                phi_6812_ = type_56();
                                phi_6813_ = false;
                                phi_6814_ = true;
                                phi_6815_ = false;
                                phi_6816_ = false;
                            }
                            let _e2994 = phi_6811_;
                            let _e2996 = phi_6812_;
                            let _e2998 = phi_6813_;
                            let _e3000 = phi_6814_;
                            let _e3002 = phi_6815_;
                            let _e3004 = phi_6816_;
                            local_31 = _e3000;
                            local_67 = _e3002;
                            local_68 = _e3004;
                            local_32 = _e2994;
                            local_33 = _e2996;
                            continue;
                            continuing {
                                phi_3853_ = _e910;
                                break if !(_e2998);
                            }
                        }
                        let _e3007 = local_31;
                        if _e3007 {
                            phi_6821_ = type_55(0u, type_55().member_1);
                            phi_6822_ = false;
                            phi_6823_ = false;
                        } else {
                            phi_6821_ = type_55();
                            let _e5382 = local_67;
                            phi_6822_ = _e5382;
                            let _e5385 = local_68;
                            phi_6823_ = _e5385;
                        }
                        let _e3012 = phi_6821_;
                        let _e3014 = phi_6822_;
                        let _e3016 = phi_6823_;
                        if _e3014 {
                            let _e3018 = local_32;
                            phi_6828_ = type_55(2u, _e3018);
                            phi_6829_ = false;
                        } else {
                            phi_6828_ = type_55();
                            phi_6829_ = _e3016;
                        }
                        let _e3021 = phi_6828_;
                        let _e3023 = phi_6829_;
                        if _e3023 {
                            let _e3025 = local_33;
                            phi_6835_ = type_55(1u, _e3025.member);
                            phi_6836_ = true;
                        } else {
                            phi_6835_ = _e3021;
                            phi_6836_ = _e3014;
                        }
                        let _e3029 = phi_6835_;
                        let _e3031 = phi_6836_;
                        if _e3031 {
                            phi_6840_ = _e3029;
                        } else {
                            phi_6840_ = _e3012;
                        }
                        let _e3033 = phi_6840_;
                        phi_6844_ = _e3033;
                    }
                    let _e4682 = phi_6844_;
                    phi_6845_ = _e4682;
                }
                let _e4687 = phi_6845_;
                switch bitcast<i32>(_e4687.member) {
                    case 0: {
                        phi_6906_ = type_58(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4717 = bitcast<u32>(_e4687.member_1);
                        if (_e4717 < 8388608u) {
                            phi_6873_ = array<u32, 2>();
                            phi_6874_ = true;
                        } else {
                            let _e4721 = ((_e4717 >> bitcast<u32>(31i)) == 1u);
                            if _e4721 {
                                phi_6872_ = array<u32, 2>();
                            } else {
                                phi_6872_ = array<u32, 2>((_e4717 << bitcast<u32>(29i)), ((((_e4717 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e4717 & 8388607u) >> bitcast<u32>(3i))));
                            }
                            let _e4735 = phi_6872_;
                            phi_6873_ = _e4735;
                            phi_6874_ = _e4721;
                        }
                        let _e4737 = phi_6873_;
                        let _e4739 = phi_6874_;
                        if _e4739 {
                            phi_6878_ = array<u32, 2>(0u, 0u);
                        } else {
                            phi_6878_ = _e4737;
                        }
                        let _e4741 = phi_6878_;
                        phi_6906_ = type_58(0u, _e4741, true);
                        break;
                    }
                    case 2: {
                        let _e4691 = bitcast<u32>(_e4687.member_1);
                        if (_e4691 < 8388608u) {
                            phi_6899_ = array<u32, 2>();
                            phi_6900_ = true;
                        } else {
                            let _e4695 = ((_e4691 >> bitcast<u32>(31i)) == 1u);
                            if _e4695 {
                                phi_6898_ = array<u32, 2>();
                            } else {
                                phi_6898_ = array<u32, 2>((_e4691 << bitcast<u32>(29i)), ((((_e4691 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e4691 & 8388607u) >> bitcast<u32>(3i))));
                            }
                            let _e4709 = phi_6898_;
                            phi_6899_ = _e4709;
                            phi_6900_ = _e4695;
                        }
                        let _e4711 = phi_6899_;
                        let _e4713 = phi_6900_;
                        if _e4713 {
                            phi_6904_ = array<u32, 2>(0u, 0u);
                        } else {
                            phi_6904_ = _e4711;
                        }
                        let _e4715 = phi_6904_;
                        phi_6906_ = type_58(1u, _e4715, true);
                        break;
                    }
                    default: {
                        phi_6906_ = type_58();
                        break;
                    }
                }
                let _e4744 = phi_6906_;
                if _e4744.member_2 {
                    phi_6913_ = (_e4744.member == 0u);
                } else {
                    phi_6913_ = false;
                }
                let _e4749 = phi_6913_;
                if _e4749 {
                    let _e4757 = (_e4744.member_1[1] >> bitcast<u32>(20i));
                    if (_e4757 <= 896u) {
                        phi_6937_ = 0u;
                    } else {
                        phi_6937_ = ((((_e4757 - 896u) << bitcast<u32>(23i)) | ((_e4744.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4744.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4772 = phi_6937_;
                    let _e4774 = atomicMin((&earliest.member[0u]), _e4772);
                }
                phi_6941_ = type_48(_e177, 0u, _e183, _e186, _e4744.member_1);
                phi_6942_ = _e4749;
                phi_6943_ = (_e4744.member != 0u);
            } else {
                phi_6941_ = type_48(_e177, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_6942_ = false;
                phi_6943_ = false;
            }
            let _e4776 = phi_6941_;
            let _e4778 = phi_6942_;
            let _e4780 = phi_6943_;
            let _e4782 = params.member.member_1;
            if ((_e4782 & 16u) != 0u) {
                if (_e108 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4778 {
                    let _e4788 = atomicAdd((&counters[0u]), 1u);
                    phi_6961_ = _e4788;
                } else {
                    phi_6961_ = 0u;
                }
                let _e4790 = phi_6961_;
                workgroupBarrier();
                if (_e108 == 0u) {
                    let _e4793 = atomicLoad((&counters[0u]));
                    if (_e4793 > 0u) {
                        let _e4796 = atomicAdd((&contacts.member[0u]), _e4793);
                        atomicStore((&counters[1u]), _e4796);
                    }
                }
                workgroupBarrier();
                let _e4799 = atomicLoad((&counters[1u]));
                let _e4800 = (_e4799 + _e4790);
                if _e4778 {
                    let _e4802 = params.member.member_16;
                    if (_e4800 < _e4802) {
                        let _e4804 = (6u * _e4800);
                        atomicStore((&contacts.member[(4u + _e4804)]), _e4776.member);
                        atomicStore((&contacts.member[(_e4804 + 5u)]), _e4776.member_1);
                        atomicStore((&contacts.member[(_e4804 + 6u)]), _e4776.member_2);
                        atomicStore((&contacts.member[(_e4804 + 7u)]), _e4776.member_3);
                        atomicStore((&contacts.member[(_e4804 + 8u)]), _e4776.member_4[0]);
                        atomicStore((&contacts.member[(_e4804 + 9u)]), _e4776.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e108 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4780 {
                let _e4828 = atomicAdd((&counters[0u]), 1u);
                phi_7023_ = _e4828;
            } else {
                phi_7023_ = 0u;
            }
            let _e4830 = phi_7023_;
            workgroupBarrier();
            if (_e108 == 0u) {
                let _e4833 = atomicLoad((&counters[0u]));
                if (_e4833 > 0u) {
                    let _e4836 = atomicAdd((&undecided.member[0u]), _e4833);
                    atomicStore((&counters[1u]), _e4836);
                }
            }
            workgroupBarrier();
            let _e4839 = atomicLoad((&counters[1u]));
            let _e4840 = (_e4839 + _e4830);
            if _e4780 {
                atomicStore((&undecided.member[(4u + (2u * _e4840))]), _e4776.member_2);
                atomicStore((&undecided.member[((2u * _e4840) + 5u)]), _e4776.member_3);
            }
        }
        continue;
        continuing {
            phi_244_ = _e165;
            break if !(_e171);
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
