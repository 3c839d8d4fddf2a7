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
    var phi_3534_: f32;
    var phi_3540_: f32;
    var phi_3545_: f32;
    var phi_3551_: f32;
    var phi_3557_: f32;
    var phi_3562_: f32;
    var phi_3567_: f32;
    var phi_3607_: type_26;
    var phi_3610_: f32;
    var phi_3631_: bool;
    var phi_3637_: type_27;
    var phi_3608_: type_26;
    var phi_3651_: type_27;
    var phi_3611_: f32;
    var local_16: f32;
    var phi_3600_: f32;
    var phi_3664_: f32;
    var phi_3670_: f32;
    var phi_3695_: type_28;
    var phi_3698_: u32;
    var phi_3696_: type_28;
    var phi_3721_: type_28;
    var phi_3765_: u32;
    var phi_3766_: u32;
    var phi_3699_: u32;
    var phi_3767_: u32;
    var phi_3787_: type_28;
    var phi_3788_: type_28;
    var phi_3811_: type_28;
    var phi_3863_: f32;
    var phi_3870_: f32;
    var phi_3881_: bool;
    var phi_3882_: bool;
    var phi_3883_: bool;
    var phi_3884_: bool;
    var phi_3888_: bool;
    var phi_3899_: type_56;
    var phi_3900_: type_56;
    var phi_3901_: bool;
    var phi_3902_: type_56;
    var phi_3903_: bool;
    var phi_3914_: f32;
    var phi_3924_: type_28;
    var phi_3927_: f32;
    var phi_3929_: f32;
    var phi_3931_: f32;
    var phi_3925_: type_28;
    var phi_3954_: type_28;
    var phi_3979_: f32;
    var phi_3980_: f32;
    var phi_4006_: f32;
    var phi_4022_: f32;
    var phi_4029_: bool;
    var phi_4030_: bool;
    var phi_4031_: bool;
    var phi_4037_: f32;
    var phi_4038_: f32;
    var phi_4039_: bool;
    var phi_3928_: f32;
    var phi_3930_: f32;
    var phi_3932_: f32;
    var phi_4040_: f32;
    var phi_4041_: bool;
    var phi_4042_: bool;
    var local_17: bool;
    var phi_4046_: f32;
    var phi_4047_: f32;
    var phi_4054_: type_28;
    var phi_4057_: f32;
    var phi_4055_: type_28;
    var phi_4080_: type_28;
    var phi_4121_: f32;
    var phi_4131_: f32;
    var phi_4139_: bool;
    var phi_4141_: bool;
    var phi_4146_: f32;
    var phi_4147_: bool;
    var phi_4148_: f32;
    var phi_4149_: bool;
    var phi_4150_: bool;
    var phi_4151_: bool;
    var phi_4152_: f32;
    var phi_4058_: f32;
    var phi_4153_: bool;
    var phi_4154_: bool;
    var phi_4155_: bool;
    var phi_4156_: bool;
    var local_18: bool;
    var phi_4160_: bool;
    var phi_4161_: bool;
    var phi_4165_: bool;
    var phi_4169_: f32;
    var phi_4170_: f32;
    var phi_4172_: type_56;
    var phi_4201_: f32;
    var phi_4208_: f32;
    var phi_4213_: f32;
    var phi_4220_: f32;
    var phi_4225_: f32;
    var phi_4238_: f32;
    var phi_4245_: f32;
    var phi_4250_: f32;
    var phi_4257_: f32;
    var phi_4262_: f32;
    var phi_4267_: f32;
    var phi_4326_: f32;
    var phi_4332_: f32;
    var phi_4337_: f32;
    var phi_4343_: f32;
    var phi_4348_: f32;
    var phi_4360_: f32;
    var phi_4366_: f32;
    var phi_4371_: f32;
    var phi_4377_: f32;
    var phi_4382_: f32;
    var phi_4408_: f32;
    var phi_4415_: f32;
    var phi_4420_: f32;
    var phi_4427_: f32;
    var phi_4432_: f32;
    var phi_4445_: f32;
    var phi_4452_: f32;
    var phi_4457_: f32;
    var phi_4464_: f32;
    var phi_4469_: f32;
    var phi_4474_: f32;
    var phi_4533_: f32;
    var phi_4539_: f32;
    var phi_4544_: f32;
    var phi_4550_: f32;
    var phi_4555_: f32;
    var phi_4567_: f32;
    var phi_4573_: f32;
    var phi_4578_: f32;
    var phi_4584_: f32;
    var phi_4589_: f32;
    var phi_4615_: f32;
    var phi_4622_: f32;
    var phi_4627_: f32;
    var phi_4634_: f32;
    var phi_4639_: f32;
    var phi_4652_: f32;
    var phi_4659_: f32;
    var phi_4664_: f32;
    var phi_4671_: f32;
    var phi_4676_: f32;
    var phi_4681_: f32;
    var phi_4740_: f32;
    var phi_4746_: f32;
    var phi_4751_: f32;
    var phi_4757_: f32;
    var phi_4762_: f32;
    var phi_4774_: f32;
    var phi_4780_: f32;
    var phi_4785_: f32;
    var phi_4791_: f32;
    var phi_4796_: f32;
    var phi_4845_: f32;
    var phi_4851_: f32;
    var phi_4879_: f32;
    var phi_4885_: f32;
    var phi_4890_: u32;
    var phi_4891_: u32;
    var phi_4861_: f32;
    var phi_4867_: f32;
    var phi_4872_: u32;
    var phi_4873_: u32;
    var phi_4892_: u32;
    var phi_4893_: u32;
    var phi_4960_: f32;
    var phi_4969_: f32;
    var phi_5100_: f32;
    var phi_5106_: f32;
    var phi_5113_: f32;
    var phi_5156_: type_28;
    var phi_5159_: bool;
    var phi_5157_: type_28;
    var phi_5182_: type_28;
    var phi_5209_: bool;
    var phi_5210_: bool;
    var phi_5160_: bool;
    var phi_5211_: bool;
    var phi_5212_: bool;
    var local_19: bool;
    var phi_5216_: bool;
    var local_20: bool;
    var phi_5223_: u32;
    var phi_5224_: u32;
    var phi_5225_: bool;
    var phi_5226_: u32;
    var phi_5227_: u32;
    var phi_5228_: bool;
    var phi_5232_: u32;
    var phi_5252_: bool;
    var phi_5253_: bool;
    var phi_5254_: bool;
    var phi_5450_: f32;
    var phi_5457_: f32;
    var phi_5462_: f32;
    var phi_5469_: f32;
    var phi_5474_: f32;
    var phi_5487_: f32;
    var phi_5494_: f32;
    var phi_5499_: f32;
    var phi_5506_: f32;
    var phi_5511_: f32;
    var phi_5516_: f32;
    var phi_5533_: f32;
    var phi_5540_: f32;
    var phi_5545_: f32;
    var phi_5552_: f32;
    var phi_5557_: f32;
    var phi_5571_: f32;
    var phi_5578_: f32;
    var phi_5583_: f32;
    var phi_5590_: f32;
    var phi_5595_: f32;
    var phi_5600_: f32;
    var phi_5617_: f32;
    var phi_5624_: f32;
    var phi_5629_: f32;
    var phi_5636_: f32;
    var phi_5641_: f32;
    var phi_5655_: f32;
    var phi_5662_: f32;
    var phi_5667_: f32;
    var phi_5674_: f32;
    var phi_5679_: f32;
    var phi_5684_: f32;
    var phi_5700_: type_28;
    var phi_5703_: f32;
    var phi_5701_: type_28;
    var phi_5726_: type_28;
    var phi_5880_: bool;
    var phi_5881_: bool;
    var phi_5882_: bool;
    var phi_5883_: bool;
    var phi_5884_: bool;
    var phi_5885_: bool;
    var phi_5889_: bool;
    var phi_5929_: array<f32, 3>;
    var phi_5930_: bool;
    var phi_5931_: array<f32, 3>;
    var phi_5932_: bool;
    var phi_5962_: f32;
    var phi_5963_: f32;
    var phi_5990_: f32;
    var phi_5991_: f32;
    var phi_6018_: f32;
    var phi_6019_: f32;
    var phi_6049_: f32;
    var phi_6050_: f32;
    var phi_6193_: type_28;
    var phi_6196_: array<f32, 3>;
    var phi_6194_: type_28;
    var phi_6219_: type_28;
    var phi_6286_: array<f32, 3>;
    var phi_6197_: array<f32, 3>;
    var phi_6287_: array<f32, 3>;
    var phi_6294_: f32;
    var phi_6301_: f32;
    var phi_6309_: f32;
    var phi_6353_: type_26;
    var phi_6356_: f32;
    var phi_6377_: bool;
    var phi_6383_: type_27;
    var phi_6354_: type_26;
    var phi_6397_: type_27;
    var phi_6357_: f32;
    var local_21: f32;
    var phi_6346_: f32;
    var phi_6410_: f32;
    var phi_6419_: type_28;
    var phi_6422_: f32;
    var phi_6420_: type_28;
    var phi_6445_: type_28;
    var phi_6496_: f32;
    var phi_6502_: f32;
    var phi_6515_: bool;
    var phi_6516_: bool;
    var phi_6541_: f32;
    var phi_6542_: f32;
    var phi_6543_: f32;
    var phi_6544_: f32;
    var phi_6545_: bool;
    var phi_6423_: f32;
    var phi_6546_: bool;
    var phi_6547_: bool;
    var local_22: bool;
    var local_23: f32;
    var local_24: f32;
    var local_25: f32;
    var phi_6564_: bool;
    var phi_6565_: bool;
    var phi_6566_: bool;
    var phi_6567_: bool;
    var phi_6568_: bool;
    var phi_6569_: bool;
    var phi_6570_: bool;
    var phi_6571_: bool;
    var phi_6572_: bool;
    var phi_6573_: bool;
    var phi_6574_: bool;
    var phi_6575_: bool;
    var phi_6576_: f32;
    var phi_6577_: f32;
    var phi_6578_: bool;
    var phi_6579_: bool;
    var phi_6580_: bool;
    var phi_6581_: bool;
    var phi_6582_: bool;
    var phi_6583_: bool;
    var phi_6584_: f32;
    var phi_6585_: f32;
    var phi_6586_: bool;
    var phi_6587_: bool;
    var phi_6588_: bool;
    var phi_6589_: bool;
    var phi_6590_: bool;
    var phi_6591_: bool;
    var phi_6592_: bool;
    var phi_6593_: f32;
    var phi_5704_: f32;
    var phi_6594_: bool;
    var phi_6595_: bool;
    var phi_6596_: bool;
    var phi_6597_: bool;
    var phi_6598_: bool;
    var phi_6599_: bool;
    var phi_6600_: bool;
    var phi_6601_: bool;
    var local_26: bool;
    var phi_6606_: type_55;
    var phi_6607_: bool;
    var phi_6608_: bool;
    var phi_6609_: bool;
    var phi_6610_: bool;
    var phi_6611_: bool;
    var phi_6612_: bool;
    var phi_6616_: f32;
    var phi_6617_: bool;
    var phi_6618_: bool;
    var phi_6619_: bool;
    var phi_6620_: bool;
    var phi_6621_: bool;
    var phi_6622_: bool;
    var phi_6627_: type_55;
    var phi_6628_: bool;
    var phi_6629_: bool;
    var phi_6630_: bool;
    var phi_6631_: bool;
    var phi_6632_: bool;
    var local_27: f32;
    var phi_6637_: type_55;
    var phi_6638_: bool;
    var phi_6639_: bool;
    var phi_6640_: bool;
    var phi_6641_: bool;
    var local_28: f32;
    var phi_6646_: type_55;
    var phi_6647_: bool;
    var phi_6648_: bool;
    var phi_6649_: bool;
    var phi_6653_: bool;
    var phi_6654_: bool;
    var phi_6658_: bool;
    var phi_6659_: bool;
    var phi_6663_: bool;
    var phi_6664_: bool;
    var local_29: f32;
    var phi_6669_: type_55;
    var phi_6670_: bool;
    var phi_6674_: type_55;
    var phi_6681_: bool;
    var phi_6682_: f32;
    var phi_6683_: bool;
    var phi_6684_: bool;
    var phi_6685_: bool;
    var phi_6686_: f32;
    var phi_6687_: bool;
    var phi_6688_: bool;
    var phi_6689_: bool;
    var phi_6690_: f32;
    var phi_6691_: bool;
    var phi_6692_: bool;
    var phi_6693_: bool;
    var phi_6694_: bool;
    var phi_6698_: bool;
    var phi_6699_: bool;
    var phi_6700_: bool;
    var phi_6701_: f32;
    var phi_6702_: type_56;
    var phi_6703_: bool;
    var phi_6704_: bool;
    var phi_6705_: bool;
    var phi_6706_: bool;
    var local_30: bool;
    var phi_6711_: type_55;
    var phi_6712_: bool;
    var phi_6713_: bool;
    var local_31: f32;
    var phi_6718_: type_55;
    var phi_6719_: bool;
    var local_32: type_56;
    var phi_6725_: type_55;
    var phi_6726_: bool;
    var phi_6730_: type_55;
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
    var phi_1745_: bool;
    var phi_1785_: array<f32, 3>;
    var phi_1786_: bool;
    var phi_1787_: array<f32, 3>;
    var phi_1788_: bool;
    var phi_1818_: f32;
    var phi_1819_: f32;
    var phi_1846_: f32;
    var phi_1847_: f32;
    var phi_1874_: f32;
    var phi_1875_: f32;
    var phi_1905_: f32;
    var phi_1906_: f32;
    var phi_2049_: type_28;
    var phi_2052_: array<f32, 3>;
    var phi_2050_: type_28;
    var phi_2075_: type_28;
    var phi_2142_: array<f32, 3>;
    var phi_2053_: array<f32, 3>;
    var phi_2143_: array<f32, 3>;
    var phi_2150_: f32;
    var phi_2157_: f32;
    var phi_2165_: f32;
    var phi_2209_: type_26;
    var phi_2212_: f32;
    var phi_2233_: bool;
    var phi_2239_: type_27;
    var phi_2210_: type_26;
    var phi_2253_: type_27;
    var phi_2213_: f32;
    var local_33: f32;
    var phi_2202_: f32;
    var phi_2266_: f32;
    var phi_2275_: type_28;
    var phi_2278_: f32;
    var phi_2276_: type_28;
    var phi_2301_: type_28;
    var phi_2352_: f32;
    var phi_2358_: f32;
    var phi_2371_: bool;
    var phi_2372_: bool;
    var phi_2397_: f32;
    var phi_2398_: f32;
    var phi_2399_: f32;
    var phi_2400_: f32;
    var phi_2401_: bool;
    var phi_2279_: f32;
    var phi_2402_: bool;
    var phi_2403_: bool;
    var local_34: bool;
    var local_35: f32;
    var local_36: f32;
    var local_37: f32;
    var phi_2420_: bool;
    var phi_2421_: bool;
    var phi_2422_: bool;
    var phi_2423_: bool;
    var phi_2424_: bool;
    var phi_2425_: bool;
    var phi_2426_: bool;
    var phi_2427_: bool;
    var phi_2428_: bool;
    var phi_2429_: bool;
    var phi_2430_: bool;
    var phi_2431_: bool;
    var phi_2432_: f32;
    var phi_2433_: f32;
    var phi_2434_: bool;
    var phi_2435_: bool;
    var phi_2436_: bool;
    var phi_2437_: bool;
    var phi_2438_: bool;
    var phi_2439_: bool;
    var phi_2440_: f32;
    var phi_2441_: f32;
    var phi_2442_: bool;
    var phi_2443_: bool;
    var phi_2444_: bool;
    var phi_2445_: bool;
    var phi_2446_: bool;
    var phi_2447_: bool;
    var phi_2448_: bool;
    var phi_2449_: f32;
    var phi_1560_: f32;
    var phi_2450_: bool;
    var phi_2451_: bool;
    var phi_2452_: bool;
    var phi_2453_: bool;
    var phi_2454_: bool;
    var phi_2455_: bool;
    var phi_2456_: bool;
    var phi_2457_: bool;
    var local_38: bool;
    var phi_2462_: type_55;
    var phi_2463_: bool;
    var phi_2464_: bool;
    var phi_2465_: bool;
    var phi_2466_: bool;
    var phi_2467_: bool;
    var phi_2468_: bool;
    var phi_2472_: f32;
    var phi_2473_: bool;
    var phi_2474_: bool;
    var phi_2475_: bool;
    var phi_2476_: bool;
    var phi_2477_: bool;
    var phi_2478_: bool;
    var phi_2483_: type_55;
    var phi_2484_: bool;
    var phi_2485_: bool;
    var phi_2486_: bool;
    var phi_2487_: bool;
    var phi_2488_: bool;
    var local_39: f32;
    var phi_2493_: type_55;
    var phi_2494_: bool;
    var phi_2495_: bool;
    var phi_2496_: bool;
    var phi_2497_: bool;
    var local_40: f32;
    var phi_2502_: type_55;
    var phi_2503_: bool;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2509_: bool;
    var phi_2510_: bool;
    var phi_2514_: bool;
    var phi_2515_: bool;
    var phi_2519_: bool;
    var phi_2520_: bool;
    var local_41: f32;
    var phi_2525_: type_55;
    var phi_2526_: bool;
    var phi_2530_: type_55;
    var phi_2544_: type_28;
    var phi_2545_: type_28;
    var phi_2568_: type_28;
    var phi_2588_: f32;
    var phi_2736_: bool;
    var phi_2737_: bool;
    var phi_2738_: bool;
    var phi_2739_: bool;
    var phi_2740_: bool;
    var phi_2741_: bool;
    var phi_2745_: bool;
    var phi_2785_: array<f32, 3>;
    var phi_2786_: bool;
    var phi_2787_: array<f32, 3>;
    var phi_2788_: bool;
    var phi_2818_: f32;
    var phi_2819_: f32;
    var phi_2846_: f32;
    var phi_2847_: f32;
    var phi_2874_: f32;
    var phi_2875_: f32;
    var phi_2905_: f32;
    var phi_2906_: f32;
    var phi_3049_: type_28;
    var phi_3052_: array<f32, 3>;
    var phi_3050_: type_28;
    var phi_3075_: type_28;
    var phi_3142_: array<f32, 3>;
    var phi_3053_: array<f32, 3>;
    var phi_3143_: array<f32, 3>;
    var phi_3175_: type_26;
    var phi_3178_: f32;
    var phi_3199_: bool;
    var phi_3205_: type_27;
    var phi_3176_: type_26;
    var phi_3219_: type_27;
    var phi_3179_: f32;
    var local_42: f32;
    var phi_3168_: f32;
    var phi_3232_: f32;
    var phi_3248_: f32;
    var phi_3255_: f32;
    var phi_3260_: f32;
    var phi_3267_: f32;
    var phi_3272_: f32;
    var phi_3285_: f32;
    var phi_3292_: f32;
    var phi_3297_: f32;
    var phi_3304_: f32;
    var phi_3309_: f32;
    var phi_3314_: f32;
    var phi_3331_: f32;
    var phi_3338_: f32;
    var phi_3343_: f32;
    var phi_3350_: f32;
    var phi_3355_: f32;
    var phi_3369_: f32;
    var phi_3376_: f32;
    var phi_3381_: f32;
    var phi_3388_: f32;
    var phi_3393_: f32;
    var phi_3398_: f32;
    var phi_3415_: f32;
    var phi_3422_: f32;
    var phi_3427_: f32;
    var phi_3434_: f32;
    var phi_3439_: f32;
    var phi_3453_: f32;
    var phi_3460_: f32;
    var phi_3465_: f32;
    var phi_3472_: f32;
    var phi_3477_: f32;
    var phi_3482_: f32;
    var phi_3502_: bool;
    var phi_3503_: bool;
    var phi_3504_: bool;
    var local_43: bool;
    var phi_3509_: type_55;
    var phi_3510_: bool;
    var phi_3515_: type_55;
    var phi_3516_: bool;
    var phi_3518_: type_55;
    var phi_3519_: type_55;
    var phi_3520_: bool;
    var phi_3524_: type_55;
    var phi_6734_: type_55;
    var phi_6735_: type_55;
    var phi_6788_: array<u32, 2>;
    var phi_6789_: array<u32, 2>;
    var phi_6790_: bool;
    var phi_6794_: array<u32, 2>;
    var phi_6762_: array<u32, 2>;
    var phi_6763_: array<u32, 2>;
    var phi_6764_: bool;
    var phi_6768_: array<u32, 2>;
    var phi_6796_: type_58;
    var phi_6803_: bool;
    var phi_6827_: u32;
    var phi_6831_: type_48;
    var phi_6832_: bool;
    var phi_6833_: bool;
    var phi_6851_: u32;
    var phi_6913_: u32;
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
            if (_e173 < _e128) {
                let _e178 = (2u * _e173);
                let _e181 = input.member[(4u + _e178)];
                let _e184 = input.member[(_e178 + 5u)];
                let _e186 = elements.member[_e181];
                let _e188 = elements.member[_e184];
                let _e194 = paths.member[_e186[0]];
                let _e196 = paths.member[_e186[1]];
                let _e202 = paths.member[_e188[0]];
                let _e204 = paths.member[_e188[1]];
                let _e234 = params.member.member_4;
                local_15 = type_45(array<array<f32, 3>, 2>(array<f32, 3>((_e202.member[0] - _e194.member[0]), (_e202.member[1] - _e194.member[1]), (_e202.member[2] - _e194.member[2])), array<f32, 3>((_e202.member_1[0] - _e194.member_1[0]), (_e202.member_1[1] - _e194.member_1[1]), (_e202.member_1[2] - _e194.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e196.member[0] - _e194.member[0]), (_e196.member[1] - _e194.member[1]), (_e196.member[2] - _e194.member[2])), array<f32, 3>((_e196.member_1[0] - _e194.member_1[0]), (_e196.member_1[1] - _e194.member_1[1]), (_e196.member_1[2] - _e194.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e202.member[0] - _e204.member[0]), (_e202.member[1] - _e204.member[1]), (_e202.member[2] - _e204.member[2])), array<f32, 3>((_e202.member_1[0] - _e204.member_1[0]), (_e202.member_1[1] - _e204.member_1[1]), (_e202.member_1[2] - _e204.member_1[2]))), (_e234 + _e234));
                let _e265 = params.member.member_5;
                let _e268 = local_15.member_1[0u];
                let _e274 = local_15.member_2[0u];
                let _e280 = ((_e268[1] * _e274[2]) - (_e268[2] * _e274[1]));
                let _e283 = ((_e268[2] * _e274[0]) - (_e268[0] * _e274[2]));
                let _e286 = ((_e268[0] * _e274[1]) - (_e268[1] * _e274[0]));
                let _e289 = local_15.member_1[1u];
                let _e295 = local_15.member_2[1u];
                let _e301 = ((_e289[1] * _e295[2]) - (_e289[2] * _e295[1]));
                let _e304 = ((_e289[2] * _e295[0]) - (_e289[0] * _e295[2]));
                let _e307 = ((_e289[0] * _e295[1]) - (_e289[1] * _e295[0]));
                let _e310 = local_15.member_1[0u];
                let _e316 = local_15.member_2[1u];
                let _e331 = local_15.member_1[1u];
                let _e337 = local_15.member_2[0u];
                let _e350 = (((_e310[1] * _e316[2]) - (_e310[2] * _e316[1])) + ((_e331[1] * _e337[2]) - (_e331[2] * _e337[1])));
                let _e351 = (((_e310[2] * _e316[0]) - (_e310[0] * _e316[2])) + ((_e331[2] * _e337[0]) - (_e331[0] * _e337[2])));
                let _e352 = (((_e310[0] * _e316[1]) - (_e310[1] * _e316[0])) + ((_e331[0] * _e337[1]) - (_e331[1] * _e337[0])));
                let _e355 = local_15.member[0u];
                let _e363 = (((_e355[0] * _e280) + (_e355[1] * _e283)) + (_e355[2] * _e286));
                let _e366 = local_15.member[1u];
                let _e377 = local_15.member[0u];
                let _e386 = ((((_e366[0] * _e280) + (_e366[1] * _e283)) + (_e366[2] * _e286)) + (((_e377[0] * _e350) + (_e377[1] * _e351)) + (_e377[2] * _e352)));
                let _e389 = local_15.member[0u];
                let _e400 = local_15.member[1u];
                let _e409 = ((((_e389[0] * _e301) + (_e389[1] * _e304)) + (_e389[2] * _e307)) + (((_e400[0] * _e350) + (_e400[1] * _e351)) + (_e400[2] * _e352)));
                let _e412 = local_15.member[1u];
                let _e420 = (((_e412[0] * _e301) + (_e412[1] * _e304)) + (_e412[2] * _e307));
                let _e423 = local_15.member[0u];
                if (_e423[0] < 0f) {
                    phi_716_ = -(_e423[0]);
                } else {
                    phi_716_ = _e423[0];
                }
                let _e430 = phi_716_;
                if (_e423[1] < 0f) {
                    phi_723_ = -(_e423[1]);
                } else {
                    phi_723_ = _e423[1];
                }
                let _e434 = phi_723_;
                if (_e430 > _e434) {
                    phi_728_ = _e430;
                } else {
                    phi_728_ = _e434;
                }
                let _e437 = phi_728_;
                if (_e423[2] < 0f) {
                    phi_735_ = -(_e423[2]);
                } else {
                    phi_735_ = _e423[2];
                }
                let _e441 = phi_735_;
                if (_e437 > _e441) {
                    phi_740_ = _e437;
                } else {
                    phi_740_ = _e441;
                }
                let _e444 = phi_740_;
                let _e447 = local_15.member[1u];
                if (_e447[0] < 0f) {
                    phi_753_ = -(_e447[0]);
                } else {
                    phi_753_ = _e447[0];
                }
                let _e454 = phi_753_;
                if (_e447[1] < 0f) {
                    phi_760_ = -(_e447[1]);
                } else {
                    phi_760_ = _e447[1];
                }
                let _e458 = phi_760_;
                if (_e454 > _e458) {
                    phi_765_ = _e454;
                } else {
                    phi_765_ = _e458;
                }
                let _e461 = phi_765_;
                if (_e447[2] < 0f) {
                    phi_772_ = -(_e447[2]);
                } else {
                    phi_772_ = _e447[2];
                }
                let _e465 = phi_772_;
                if (_e461 > _e465) {
                    phi_777_ = _e461;
                } else {
                    phi_777_ = _e465;
                }
                let _e468 = phi_777_;
                if (_e444 > _e468) {
                    phi_782_ = _e444;
                } else {
                    phi_782_ = _e468;
                }
                let _e471 = phi_782_;
                let _e473 = local_15.member_3;
                let _e474 = (_e471 + _e473);
                let _e477 = local_15.member_1[0u];
                if (_e477[0] < 0f) {
                    phi_799_ = -(_e477[0]);
                } else {
                    phi_799_ = _e477[0];
                }
                let _e484 = phi_799_;
                if (_e477[1] < 0f) {
                    phi_806_ = -(_e477[1]);
                } else {
                    phi_806_ = _e477[1];
                }
                let _e488 = phi_806_;
                if (_e484 > _e488) {
                    phi_811_ = _e484;
                } else {
                    phi_811_ = _e488;
                }
                let _e491 = phi_811_;
                if (_e477[2] < 0f) {
                    phi_818_ = -(_e477[2]);
                } else {
                    phi_818_ = _e477[2];
                }
                let _e495 = phi_818_;
                if (_e491 > _e495) {
                    phi_823_ = _e491;
                } else {
                    phi_823_ = _e495;
                }
                let _e498 = phi_823_;
                let _e501 = local_15.member_1[1u];
                if (_e501[0] < 0f) {
                    phi_837_ = -(_e501[0]);
                } else {
                    phi_837_ = _e501[0];
                }
                let _e508 = phi_837_;
                if (_e501[1] < 0f) {
                    phi_844_ = -(_e501[1]);
                } else {
                    phi_844_ = _e501[1];
                }
                let _e512 = phi_844_;
                if (_e508 > _e512) {
                    phi_849_ = _e508;
                } else {
                    phi_849_ = _e512;
                }
                let _e515 = phi_849_;
                if (_e501[2] < 0f) {
                    phi_856_ = -(_e501[2]);
                } else {
                    phi_856_ = _e501[2];
                }
                let _e519 = phi_856_;
                if (_e515 > _e519) {
                    phi_861_ = _e515;
                } else {
                    phi_861_ = _e519;
                }
                let _e522 = phi_861_;
                if (_e498 > _e522) {
                    phi_866_ = _e498;
                } else {
                    phi_866_ = _e522;
                }
                let _e525 = phi_866_;
                let _e527 = local_15.member_3;
                let _e528 = (_e525 + _e527);
                let _e531 = local_15.member_2[0u];
                if (_e531[0] < 0f) {
                    phi_883_ = -(_e531[0]);
                } else {
                    phi_883_ = _e531[0];
                }
                let _e538 = phi_883_;
                if (_e531[1] < 0f) {
                    phi_890_ = -(_e531[1]);
                } else {
                    phi_890_ = _e531[1];
                }
                let _e542 = phi_890_;
                if (_e538 > _e542) {
                    phi_895_ = _e538;
                } else {
                    phi_895_ = _e542;
                }
                let _e545 = phi_895_;
                if (_e531[2] < 0f) {
                    phi_902_ = -(_e531[2]);
                } else {
                    phi_902_ = _e531[2];
                }
                let _e549 = phi_902_;
                if (_e545 > _e549) {
                    phi_907_ = _e545;
                } else {
                    phi_907_ = _e549;
                }
                let _e552 = phi_907_;
                let _e555 = local_15.member_2[1u];
                if (_e555[0] < 0f) {
                    phi_921_ = -(_e555[0]);
                } else {
                    phi_921_ = _e555[0];
                }
                let _e562 = phi_921_;
                if (_e555[1] < 0f) {
                    phi_928_ = -(_e555[1]);
                } else {
                    phi_928_ = _e555[1];
                }
                let _e566 = phi_928_;
                if (_e562 > _e566) {
                    phi_933_ = _e562;
                } else {
                    phi_933_ = _e566;
                }
                let _e569 = phi_933_;
                if (_e555[2] < 0f) {
                    phi_940_ = -(_e555[2]);
                } else {
                    phi_940_ = _e555[2];
                }
                let _e573 = phi_940_;
                if (_e569 > _e573) {
                    phi_945_ = _e569;
                } else {
                    phi_945_ = _e573;
                }
                let _e576 = phi_945_;
                if (_e552 > _e576) {
                    phi_950_ = _e552;
                } else {
                    phi_950_ = _e576;
                }
                let _e579 = phi_950_;
                let _e581 = local_15.member_3;
                let _e582 = (_e579 + _e581);
                let _e584 = ((_e528 * 8f) * _e582);
                let _e591 = local_15.member_3;
                if (_e280 < 0f) {
                    phi_981_ = -(_e280);
                } else {
                    phi_981_ = _e280;
                }
                let _e608 = phi_981_;
                if (_e283 < 0f) {
                    phi_987_ = -(_e283);
                } else {
                    phi_987_ = _e283;
                }
                let _e612 = phi_987_;
                if (_e286 < 0f) {
                    phi_994_ = -(_e286);
                } else {
                    phi_994_ = _e286;
                }
                let _e617 = phi_994_;
                let _e618 = ((_e608 + _e612) + _e617);
                if (_e301 < 0f) {
                    phi_1001_ = -(_e301);
                } else {
                    phi_1001_ = _e301;
                }
                let _e622 = phi_1001_;
                if (_e304 < 0f) {
                    phi_1007_ = -(_e304);
                } else {
                    phi_1007_ = _e304;
                }
                let _e626 = phi_1007_;
                if (_e307 < 0f) {
                    phi_1014_ = -(_e307);
                } else {
                    phi_1014_ = _e307;
                }
                let _e631 = phi_1014_;
                let _e632 = ((_e622 + _e626) + _e631);
                if (_e618 > _e632) {
                    phi_1020_ = _e618;
                } else {
                    phi_1020_ = _e632;
                }
                let _e635 = phi_1020_;
                if (_e350 < 0f) {
                    phi_1026_ = -(_e350);
                } else {
                    phi_1026_ = _e350;
                }
                let _e639 = phi_1026_;
                if (_e351 < 0f) {
                    phi_1032_ = -(_e351);
                } else {
                    phi_1032_ = _e351;
                }
                let _e643 = phi_1032_;
                if (_e352 < 0f) {
                    phi_1039_ = -(_e352);
                } else {
                    phi_1039_ = _e352;
                }
                let _e648 = phi_1039_;
                let _e650 = (((_e639 + _e643) + _e648) * 0.5f);
                if (_e635 > _e650) {
                    phi_1046_ = _e635;
                } else {
                    phi_1046_ = _e650;
                }
                let _e653 = phi_1046_;
                let _e658 = local_15.member_3;
                let _e670 = (((((_e474 * 8f) * _e584) * (0.000000059604645f * (490f / 64f))) + ((_e591 * 19f) * ((_e474 * (_e528 + _e582)) + (_e528 * _e582)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e474) * ((1f + _e528) * (1f + _e582)))));
                let _e671 = (_e363 * 3f);
                let _e672 = (_e420 * 3f);
                if (_e671 < _e672) {
                    phi_1070_ = _e671;
                } else {
                    phi_1070_ = _e672;
                }
                let _e675 = phi_1070_;
                if (_e386 < _e409) {
                    phi_1075_ = _e386;
                } else {
                    phi_1075_ = _e409;
                }
                let _e678 = phi_1075_;
                if (_e675 < _e678) {
                    phi_1080_ = _e675;
                } else {
                    phi_1080_ = _e678;
                }
                let _e681 = phi_1080_;
                if (_e671 > _e672) {
                    phi_1085_ = _e671;
                } else {
                    phi_1085_ = _e672;
                }
                let _e684 = phi_1085_;
                if (_e386 > _e409) {
                    phi_1090_ = _e386;
                } else {
                    phi_1090_ = _e409;
                }
                let _e687 = phi_1090_;
                if (_e684 > _e687) {
                    phi_1095_ = _e684;
                } else {
                    phi_1095_ = _e687;
                }
                let _e690 = phi_1095_;
                let _e695 = -(_e690);
                if (_e681 > _e695) {
                    phi_1105_ = _e681;
                } else {
                    phi_1105_ = _e695;
                }
                let _e698 = phi_1105_;
                if ((_e698 - (_e670 + ((_e265 * (((_e653 + (_e584 * (0.000000059604645f * 4f))) + ((_e658 * 6f) * (_e528 + _e582))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e528) * (1f + _e582))))) * (3f * 1.0001f)))) > 0f) {
                    phi_6735_ = type_55(0u, type_55().member_1);
                } else {
                    if (_e265 > 0f) {
                        let _e2958 = local_15.member[0u];
                        let _e2964 = local_15.member_1[0u];
                        let _e2970 = local_15.member_2[0u];
                        let _e2974 = (_e2958[0] - _e2964[0]);
                        let _e2975 = (_e2958[1] - _e2964[1]);
                        let _e2976 = (_e2958[2] - _e2964[2]);
                        local_12 = array<array<f32, 3>, 4>(_e2958, array<f32, 3>(_e2974, _e2975, _e2976), array<f32, 3>((_e2958[0] - _e2970[0]), (_e2958[1] - _e2970[1]), (_e2958[2] - _e2970[2])), array<f32, 3>((_e2974 - _e2970[0]), (_e2975 - _e2970[1]), (_e2976 - _e2970[2])));
                        let _e2989 = local_15.member[1u];
                        let _e2995 = local_15.member_1[1u];
                        let _e3001 = local_15.member_2[1u];
                        let _e3005 = (_e2989[0] - _e2995[0]);
                        let _e3006 = (_e2989[1] - _e2995[1]);
                        let _e3007 = (_e2989[2] - _e2995[2]);
                        local_13 = array<array<f32, 3>, 4>(_e2989, array<f32, 3>(_e3005, _e3006, _e3007), array<f32, 3>((_e2989[0] - _e3001[0]), (_e2989[1] - _e3001[1]), (_e2989[2] - _e3001[2])), array<f32, 3>((_e3005 - _e3001[0]), (_e3006 - _e3001[1]), (_e3007 - _e3001[2])));
                        let _e3020 = local_15.member[0u];
                        if (_e3020[0] < 0f) {
                            phi_1306_ = -(_e3020[0]);
                        } else {
                            phi_1306_ = _e3020[0];
                        }
                        let _e3027 = phi_1306_;
                        if (_e3020[1] < 0f) {
                            phi_1313_ = -(_e3020[1]);
                        } else {
                            phi_1313_ = _e3020[1];
                        }
                        let _e3031 = phi_1313_;
                        if (_e3027 > _e3031) {
                            phi_1318_ = _e3027;
                        } else {
                            phi_1318_ = _e3031;
                        }
                        let _e3034 = phi_1318_;
                        if (_e3020[2] < 0f) {
                            phi_1325_ = -(_e3020[2]);
                        } else {
                            phi_1325_ = _e3020[2];
                        }
                        let _e3038 = phi_1325_;
                        if (_e3034 > _e3038) {
                            phi_1330_ = _e3034;
                        } else {
                            phi_1330_ = _e3038;
                        }
                        let _e3041 = phi_1330_;
                        let _e3044 = local_15.member[1u];
                        if (_e3044[0] < 0f) {
                            phi_1343_ = -(_e3044[0]);
                        } else {
                            phi_1343_ = _e3044[0];
                        }
                        let _e3051 = phi_1343_;
                        if (_e3044[1] < 0f) {
                            phi_1350_ = -(_e3044[1]);
                        } else {
                            phi_1350_ = _e3044[1];
                        }
                        let _e3055 = phi_1350_;
                        if (_e3051 > _e3055) {
                            phi_1355_ = _e3051;
                        } else {
                            phi_1355_ = _e3055;
                        }
                        let _e3058 = phi_1355_;
                        if (_e3044[2] < 0f) {
                            phi_1362_ = -(_e3044[2]);
                        } else {
                            phi_1362_ = _e3044[2];
                        }
                        let _e3062 = phi_1362_;
                        if (_e3058 > _e3062) {
                            phi_1367_ = _e3058;
                        } else {
                            phi_1367_ = _e3062;
                        }
                        let _e3065 = phi_1367_;
                        if (_e3041 > _e3065) {
                            phi_1372_ = _e3041;
                        } else {
                            phi_1372_ = _e3065;
                        }
                        let _e3068 = phi_1372_;
                        let _e3070 = local_15.member_3;
                        let _e3074 = local_15.member_1[0u];
                        if (_e3074[0] < 0f) {
                            phi_1389_ = -(_e3074[0]);
                        } else {
                            phi_1389_ = _e3074[0];
                        }
                        let _e3081 = phi_1389_;
                        if (_e3074[1] < 0f) {
                            phi_1396_ = -(_e3074[1]);
                        } else {
                            phi_1396_ = _e3074[1];
                        }
                        let _e3085 = phi_1396_;
                        if (_e3081 > _e3085) {
                            phi_1401_ = _e3081;
                        } else {
                            phi_1401_ = _e3085;
                        }
                        let _e3088 = phi_1401_;
                        if (_e3074[2] < 0f) {
                            phi_1408_ = -(_e3074[2]);
                        } else {
                            phi_1408_ = _e3074[2];
                        }
                        let _e3092 = phi_1408_;
                        if (_e3088 > _e3092) {
                            phi_1413_ = _e3088;
                        } else {
                            phi_1413_ = _e3092;
                        }
                        let _e3095 = phi_1413_;
                        let _e3098 = local_15.member_1[1u];
                        if (_e3098[0] < 0f) {
                            phi_1427_ = -(_e3098[0]);
                        } else {
                            phi_1427_ = _e3098[0];
                        }
                        let _e3105 = phi_1427_;
                        if (_e3098[1] < 0f) {
                            phi_1434_ = -(_e3098[1]);
                        } else {
                            phi_1434_ = _e3098[1];
                        }
                        let _e3109 = phi_1434_;
                        if (_e3105 > _e3109) {
                            phi_1439_ = _e3105;
                        } else {
                            phi_1439_ = _e3109;
                        }
                        let _e3112 = phi_1439_;
                        if (_e3098[2] < 0f) {
                            phi_1446_ = -(_e3098[2]);
                        } else {
                            phi_1446_ = _e3098[2];
                        }
                        let _e3116 = phi_1446_;
                        if (_e3112 > _e3116) {
                            phi_1451_ = _e3112;
                        } else {
                            phi_1451_ = _e3116;
                        }
                        let _e3119 = phi_1451_;
                        if (_e3095 > _e3119) {
                            phi_1456_ = _e3095;
                        } else {
                            phi_1456_ = _e3119;
                        }
                        let _e3122 = phi_1456_;
                        let _e3124 = local_15.member_3;
                        let _e3128 = local_15.member_2[0u];
                        if (_e3128[0] < 0f) {
                            phi_1473_ = -(_e3128[0]);
                        } else {
                            phi_1473_ = _e3128[0];
                        }
                        let _e3135 = phi_1473_;
                        if (_e3128[1] < 0f) {
                            phi_1480_ = -(_e3128[1]);
                        } else {
                            phi_1480_ = _e3128[1];
                        }
                        let _e3139 = phi_1480_;
                        if (_e3135 > _e3139) {
                            phi_1485_ = _e3135;
                        } else {
                            phi_1485_ = _e3139;
                        }
                        let _e3142 = phi_1485_;
                        if (_e3128[2] < 0f) {
                            phi_1492_ = -(_e3128[2]);
                        } else {
                            phi_1492_ = _e3128[2];
                        }
                        let _e3146 = phi_1492_;
                        if (_e3142 > _e3146) {
                            phi_1497_ = _e3142;
                        } else {
                            phi_1497_ = _e3146;
                        }
                        let _e3149 = phi_1497_;
                        let _e3152 = local_15.member_2[1u];
                        if (_e3152[0] < 0f) {
                            phi_1511_ = -(_e3152[0]);
                        } else {
                            phi_1511_ = _e3152[0];
                        }
                        let _e3159 = phi_1511_;
                        if (_e3152[1] < 0f) {
                            phi_1518_ = -(_e3152[1]);
                        } else {
                            phi_1518_ = _e3152[1];
                        }
                        let _e3163 = phi_1518_;
                        if (_e3159 > _e3163) {
                            phi_1523_ = _e3159;
                        } else {
                            phi_1523_ = _e3163;
                        }
                        let _e3166 = phi_1523_;
                        if (_e3152[2] < 0f) {
                            phi_1530_ = -(_e3152[2]);
                        } else {
                            phi_1530_ = _e3152[2];
                        }
                        let _e3170 = phi_1530_;
                        if (_e3166 > _e3170) {
                            phi_1535_ = _e3166;
                        } else {
                            phi_1535_ = _e3170;
                        }
                        let _e3173 = phi_1535_;
                        if (_e3149 > _e3173) {
                            phi_1540_ = _e3149;
                        } else {
                            phi_1540_ = _e3173;
                        }
                        let _e3176 = phi_1540_;
                        let _e3178 = local_15.member_3;
                        let _e3185 = local_15.member_3;
                        phi_1556_ = type_28(0u, 48u);
                        phi_1559_ = 0f;
                        loop {
                            let _e3191 = phi_1556_;
                            let _e3193 = phi_1559_;
                            local_74 = _e3193;
                            local_39 = _e3193;
                            local_40 = _e3193;
                            local_41 = _e3193;
                            if (_e3191.member < _e3191.member_1) {
                                phi_1557_ = type_28((_e3191.member + 1u), _e3191.member_1);
                                phi_1582_ = type_28(1u, _e3191.member);
                            } else {
                                phi_1557_ = _e3191;
                                phi_1582_ = type_28(0u, type_28().member_1);
                            }
                            let _e3207 = phi_1557_;
                            let _e3209 = phi_1582_;
                            if (bitcast<i32>(_e3209.member) != 0i) {
                                let _e3215 = local_15.member[0u];
                                let _e3221 = local_15.member[1u];
                                let _e3231 = (_e3215[0] + ((_e3221[0] - _e3215[0]) * _e3193));
                                let _e3232 = (_e3215[1] + ((_e3221[1] - _e3215[1]) * _e3193));
                                let _e3233 = (_e3215[2] + ((_e3221[2] - _e3215[2]) * _e3193));
                                let _e3236 = local_15.member_1[0u];
                                let _e3242 = local_15.member_1[1u];
                                let _e3252 = (_e3236[0] + ((_e3242[0] - _e3236[0]) * _e3193));
                                let _e3253 = (_e3236[1] + ((_e3242[1] - _e3236[1]) * _e3193));
                                let _e3254 = (_e3236[2] + ((_e3242[2] - _e3236[2]) * _e3193));
                                let _e3257 = local_15.member_2[0u];
                                let _e3263 = local_15.member_2[1u];
                                let _e3273 = (_e3257[0] + ((_e3263[0] - _e3257[0]) * _e3193));
                                let _e3274 = (_e3257[1] + ((_e3263[1] - _e3257[1]) * _e3193));
                                let _e3275 = (_e3257[2] + ((_e3263[2] - _e3257[2]) * _e3193));
                                let _e3280 = (((_e3252 * _e3252) + (_e3253 * _e3253)) + (_e3254 * _e3254));
                                let _e3285 = (((_e3252 * _e3273) + (_e3253 * _e3274)) + (_e3254 * _e3275));
                                let _e3290 = (((_e3273 * _e3273) + (_e3274 * _e3274)) + (_e3275 * _e3275));
                                let _e3295 = (((_e3231 * _e3252) + (_e3232 * _e3253)) + (_e3233 * _e3254));
                                let _e3300 = (((_e3231 * _e3273) + (_e3232 * _e3274)) + (_e3233 * _e3275));
                                let _e3303 = ((_e3280 * _e3290) - (_e3285 * _e3285));
                                let _e3307 = (((_e3295 * _e3290) - (_e3300 * _e3285)) / _e3303);
                                let _e3311 = (((_e3300 * _e3280) - (_e3295 * _e3285)) / _e3303);
                                if (_e3307 >= 0f) {
                                    if (_e3311 >= 0f) {
                                        if (_e3307 <= 1f) {
                                            phi_1736_ = (_e3311 <= 1f);
                                            phi_1737_ = false;
                                        } else {
                                            phi_1736_ = bool();
                                            phi_1737_ = true;
                                        }
                                        let _e3317 = phi_1736_;
                                        let _e3319 = phi_1737_;
                                        phi_1738_ = _e3317;
                                        phi_1739_ = _e3319;
                                    } else {
                                        phi_1738_ = bool();
                                        phi_1739_ = true;
                                    }
                                    let _e3321 = phi_1738_;
                                    let _e3323 = phi_1739_;
                                    phi_1740_ = _e3321;
                                    phi_1741_ = _e3323;
                                } else {
                                    phi_1740_ = bool();
                                    phi_1741_ = true;
                                }
                                let _e3325 = phi_1740_;
                                let _e3327 = phi_1741_;
                                if _e3327 {
                                    phi_1745_ = false;
                                } else {
                                    phi_1745_ = _e3325;
                                }
                                let _e3329 = phi_1745_;
                                if (_e3303 > 0f) {
                                    if _e3329 {
                                        phi_1785_ = array<f32, 3>((_e3231 - ((_e3252 * _e3307) + (_e3273 * _e3311))), (_e3232 - ((_e3253 * _e3307) + (_e3274 * _e3311))), (_e3233 - ((_e3254 * _e3307) + (_e3275 * _e3311))));
                                        phi_1786_ = false;
                                    } else {
                                        phi_1785_ = array<f32, 3>();
                                        phi_1786_ = true;
                                    }
                                    let _e3345 = phi_1785_;
                                    let _e3347 = phi_1786_;
                                    phi_1787_ = _e3345;
                                    phi_1788_ = _e3347;
                                } else {
                                    phi_1787_ = array<f32, 3>();
                                    phi_1788_ = true;
                                }
                                let _e3349 = phi_1787_;
                                let _e3351 = phi_1788_;
                                if _e3351 {
                                    let _e3352 = (_e3231 - _e3252);
                                    let _e3353 = (_e3232 - _e3253);
                                    let _e3354 = (_e3233 - _e3254);
                                    let _e3365 = ((((_e3231 * _e3252) + (_e3232 * _e3253)) + (_e3233 * _e3254)) / (((_e3252 * _e3252) + (_e3253 * _e3253)) + (_e3254 * _e3254)));
                                    if (_e3365 > 0f) {
                                        if (_e3365 < 1f) {
                                            phi_1818_ = _e3365;
                                        } else {
                                            phi_1818_ = 1f;
                                        }
                                        let _e3369 = phi_1818_;
                                        phi_1819_ = _e3369;
                                    } else {
                                        phi_1819_ = 0f;
                                    }
                                    let _e3371 = phi_1819_;
                                    let _e3388 = ((((_e3231 * _e3273) + (_e3232 * _e3274)) + (_e3233 * _e3275)) / (((_e3273 * _e3273) + (_e3274 * _e3274)) + (_e3275 * _e3275)));
                                    if (_e3388 > 0f) {
                                        if (_e3388 < 1f) {
                                            phi_1846_ = _e3388;
                                        } else {
                                            phi_1846_ = 1f;
                                        }
                                        let _e3392 = phi_1846_;
                                        phi_1847_ = _e3392;
                                    } else {
                                        phi_1847_ = 0f;
                                    }
                                    let _e3394 = phi_1847_;
                                    let _e3411 = ((((_e3352 * _e3273) + (_e3353 * _e3274)) + (_e3354 * _e3275)) / (((_e3273 * _e3273) + (_e3274 * _e3274)) + (_e3275 * _e3275)));
                                    if (_e3411 > 0f) {
                                        if (_e3411 < 1f) {
                                            phi_1874_ = _e3411;
                                        } else {
                                            phi_1874_ = 1f;
                                        }
                                        let _e3415 = phi_1874_;
                                        phi_1875_ = _e3415;
                                    } else {
                                        phi_1875_ = 0f;
                                    }
                                    let _e3417 = phi_1875_;
                                    let _e3424 = (_e3231 - _e3273);
                                    let _e3425 = (_e3232 - _e3274);
                                    let _e3426 = (_e3233 - _e3275);
                                    let _e3437 = ((((_e3424 * _e3252) + (_e3425 * _e3253)) + (_e3426 * _e3254)) / (((_e3252 * _e3252) + (_e3253 * _e3253)) + (_e3254 * _e3254)));
                                    if (_e3437 > 0f) {
                                        if (_e3437 < 1f) {
                                            phi_1905_ = _e3437;
                                        } else {
                                            phi_1905_ = 1f;
                                        }
                                        let _e3441 = phi_1905_;
                                        phi_1906_ = _e3441;
                                    } else {
                                        phi_1906_ = 0f;
                                    }
                                    let _e3443 = phi_1906_;
                                    local_11[0u] = array<f32, 3>((_e3231 - (_e3252 * _e3371)), (_e3232 - (_e3253 * _e3371)), (_e3233 - (_e3254 * _e3371)));
                                    local_11[1u] = array<f32, 3>((_e3231 - (_e3273 * _e3394)), (_e3232 - (_e3274 * _e3394)), (_e3233 - (_e3275 * _e3394)));
                                    local_11[2u] = array<f32, 3>((_e3352 - (_e3273 * _e3417)), (_e3353 - (_e3274 * _e3417)), (_e3354 - (_e3275 * _e3417)));
                                    local_11[3u] = array<f32, 3>((_e3424 - (_e3252 * _e3443)), (_e3425 - (_e3253 * _e3443)), (_e3426 - (_e3254 * _e3443)));
                                    let _e3459 = local_11[0u];
                                    phi_2049_ = type_28(1u, 4u);
                                    phi_2052_ = array<f32, 3>(_e3459[0], _e3459[1], _e3459[2]);
                                    loop {
                                        let _e3465 = phi_2049_;
                                        let _e3467 = phi_2052_;
                                        local_64 = _e3467;
                                        if (_e3465.member < _e3465.member_1) {
                                            phi_2050_ = type_28((_e3465.member + 1u), _e3465.member_1);
                                            phi_2075_ = type_28(1u, _e3465.member);
                                        } else {
                                            phi_2050_ = _e3465;
                                            phi_2075_ = type_28(0u, type_28().member_1);
                                        }
                                        let _e3481 = phi_2050_;
                                        let _e3483 = phi_2075_;
                                        let _e3487 = (bitcast<i32>(_e3483.member) != 0i);
                                        if _e3487 {
                                            if (_e3483.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3490 = local_11[_e3483.member_1];
                                            if (_e3483.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3496 = local_11[_e3483.member_1];
                                            if ((((_e3490[0] * _e3496[0]) + (_e3490[1] * _e3496[1])) + (_e3490[2] * _e3496[2])) < (((_e3467[0] * _e3467[0]) + (_e3467[1] * _e3467[1])) + (_e3467[2] * _e3467[2]))) {
                                                if (_e3483.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3519 = local_11[_e3483.member_1];
                                                phi_2142_ = array<f32, 3>(_e3519[0], _e3519[1], _e3519[2]);
                                            } else {
                                                phi_2142_ = _e3467;
                                            }
                                            let _e3525 = phi_2142_;
                                            phi_2053_ = _e3525;
                                        } else {
                                            phi_2053_ = array<f32, 3>();
                                        }
                                        let _e3527 = phi_2053_;
                                        continue;
                                        continuing {
                                            phi_2049_ = _e3481;
                                            phi_2052_ = _e3527;
                                            break if !(_e3487);
                                        }
                                    }
                                    let _e5279 = local_64;
                                    phi_2143_ = _e5279;
                                } else {
                                    phi_2143_ = _e3349;
                                }
                                let _e3530 = phi_2143_;
                                if (_e3530[0] < 0f) {
                                    phi_2150_ = -(_e3530[0]);
                                } else {
                                    phi_2150_ = _e3530[0];
                                }
                                let _e3535 = phi_2150_;
                                if (_e3530[1] < 0f) {
                                    phi_2157_ = -(_e3530[1]);
                                } else {
                                    phi_2157_ = _e3530[1];
                                }
                                let _e3540 = phi_2157_;
                                if (_e3530[2] < 0f) {
                                    phi_2165_ = -(_e3530[2]);
                                } else {
                                    phi_2165_ = _e3530[2];
                                }
                                let _e3546 = phi_2165_;
                                let _e3547 = ((_e3535 + _e3540) + _e3546);
                                if (_e3547 > 0f) {
                                    if ((bitcast<u32>(_e3547) & 2139095040u) != 2139095040u) {
                                        let _e3552 = (1f / _e3547);
                                        let _e3554 = (_e3530[0] * _e3552);
                                        let _e3556 = (_e3530[1] * _e3552);
                                        let _e3558 = (_e3530[2] * _e3552);
                                        let _e3563 = (((_e3554 * _e3554) + (_e3556 * _e3556)) + (_e3558 * _e3558));
                                        if (_e3563 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3563 > 0f) {
                                                phi_2202_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2202_ = 0f;
                                            }
                                            let _e3622 = phi_2202_;
                                            phi_2266_ = _e3622;
                                        } else {
                                            phi_2209_ = type_26(0i, 5i);
                                            phi_2212_ = bitcast<f32>(((bitcast<u32>(_e3563) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3571 = phi_2209_;
                                                let _e3573 = phi_2212_;
                                                local_33 = _e3573;
                                                if (_e3571.member < _e3571.member_1) {
                                                    let _e3581 = (_e3571.member + 1i);
                                                    if ((false == (_e3581 > _e3571.member)) != false) {
                                                        phi_2233_ = true;
                                                    } else {
                                                        phi_2233_ = false;
                                                    }
                                                    let _e3586 = phi_2233_;
                                                    if _e3586 {
                                                        phi_2239_ = type_27(0u, type_27().member_1);
                                                    } else {
                                                        phi_2239_ = type_27(1u, _e3581);
                                                    }
                                                    let _e3592 = phi_2239_;
                                                    if (bitcast<i32>(_e3592.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2210_ = type_26(_e3592.member_1, _e3571.member_1);
                                                    phi_2253_ = type_27(1u, _e3571.member);
                                                } else {
                                                    phi_2210_ = _e3571;
                                                    phi_2253_ = type_27(0u, type_27().member_1);
                                                }
                                                let _e3602 = phi_2210_;
                                                let _e3604 = phi_2253_;
                                                let _e3607 = (bitcast<i32>(_e3604.member) != 0i);
                                                if _e3607 {
                                                    phi_2213_ = (0.5f * (_e3573 + (_e3563 / _e3573)));
                                                } else {
                                                    phi_2213_ = f32();
                                                }
                                                let _e3612 = phi_2213_;
                                                continue;
                                                continuing {
                                                    phi_2209_ = _e3602;
                                                    phi_2212_ = _e3612;
                                                    break if !(_e3607);
                                                }
                                            }
                                            let _e3617 = local_33;
                                            phi_2266_ = (_e3617 * (1f + (4f * 0.000000059604645f)));
                                        }
                                        let _e3624 = phi_2266_;
                                        phi_2275_ = type_28(0u, 4u);
                                        phi_2278_ = 2f;
                                        loop {
                                            let _e3632 = phi_2275_;
                                            let _e3634 = phi_2278_;
                                            local_35 = _e3634;
                                            local_36 = _e3634;
                                            local_37 = _e3634;
                                            local_65 = _e3634;
                                            local_66 = _e3634;
                                            if (_e3632.member < _e3632.member_1) {
                                                phi_2276_ = type_28((_e3632.member + 1u), _e3632.member_1);
                                                phi_2301_ = type_28(1u, _e3632.member);
                                            } else {
                                                phi_2276_ = _e3632;
                                                phi_2301_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e3648 = phi_2276_;
                                            let _e3650 = phi_2301_;
                                            if (bitcast<i32>(_e3650.member) != 0i) {
                                                if (_e3650.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3657 = local_12[_e3650.member_1];
                                                let _e3665 = (((_e3554 * _e3657[0]) + (_e3556 * _e3657[1])) + (_e3558 * _e3657[2]));
                                                if (_e3650.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3668 = local_13[_e3650.member_1];
                                                let _e3676 = (((_e3554 * _e3668[0]) + (_e3556 * _e3668[1])) + (_e3558 * _e3668[2]));
                                                if (_e3665 < 0f) {
                                                    phi_2352_ = -(_e3665);
                                                } else {
                                                    phi_2352_ = _e3665;
                                                }
                                                let _e3680 = phi_2352_;
                                                if (_e3676 < 0f) {
                                                    phi_2358_ = -(_e3676);
                                                } else {
                                                    phi_2358_ = _e3676;
                                                }
                                                let _e3684 = phi_2358_;
                                                let _e3688 = (((((((((_e3068 + _e3070) + (_e3122 + _e3124)) + (_e3176 + _e3178)) * (0.000000059604645f * 16f)) + (_e3185 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e265 * _e3624) * (1f + (0.000000059604645f * 8f)))) + ((_e3680 + _e3684) * (0.000000059604645f * 8f)));
                                                if (_e3665 > _e3688) {
                                                    if (_e3676 > _e3688) {
                                                        phi_2371_ = false;
                                                    } else {
                                                        phi_2371_ = true;
                                                    }
                                                    let _e3692 = phi_2371_;
                                                    phi_2372_ = _e3692;
                                                } else {
                                                    phi_2372_ = true;
                                                }
                                                let _e3694 = phi_2372_;
                                                if _e3694 {
                                                    let _e3698 = ((_e3665 + ((_e3676 - _e3665) * _e3193)) > _e3688);
                                                    if _e3698 {
                                                        if (_e3676 < _e3665) {
                                                            let _e3705 = (((_e3665 - _e3688) / (_e3665 - _e3676)) * (1f - (0.000000059604645f * 16f)));
                                                            if (_e3634 < _e3705) {
                                                                phi_2397_ = _e3634;
                                                            } else {
                                                                phi_2397_ = _e3705;
                                                            }
                                                            let _e3708 = phi_2397_;
                                                            phi_2398_ = _e3708;
                                                        } else {
                                                            phi_2398_ = _e3634;
                                                        }
                                                        let _e3710 = phi_2398_;
                                                        phi_2399_ = _e3710;
                                                    } else {
                                                        phi_2399_ = f32();
                                                    }
                                                    let _e3712 = phi_2399_;
                                                    phi_2400_ = _e3712;
                                                    phi_2401_ = _e3698;
                                                } else {
                                                    phi_2400_ = _e3634;
                                                    phi_2401_ = true;
                                                }
                                                let _e3714 = phi_2400_;
                                                let _e3716 = phi_2401_;
                                                phi_2279_ = _e3714;
                                                phi_2402_ = _e3716;
                                                phi_2403_ = false;
                                            } else {
                                                phi_2279_ = f32();
                                                phi_2402_ = false;
                                                phi_2403_ = true;
                                            }
                                            let _e3718 = phi_2279_;
                                            let _e3720 = phi_2402_;
                                            let _e3722 = phi_2403_;
                                            local_34 = _e3722;
                                            continue;
                                            continuing {
                                                phi_2275_ = _e3648;
                                                phi_2278_ = _e3718;
                                                break if !(_e3720);
                                            }
                                        }
                                        let _e3725 = local_34;
                                        if _e3725 {
                                            let _e3727 = local_35;
                                            let _e3728 = (_e3727 > 1f);
                                            if _e3728 {
                                                phi_2424_ = false;
                                                phi_2425_ = false;
                                                phi_2426_ = false;
                                            } else {
                                                let _e3730 = local_36;
                                                if (_e3730 > _e3193) {
                                                    let _e3733 = local_37;
                                                    let _e3735 = ((_e3733 - _e3193) < 0.00000000023283064f);
                                                    if _e3735 {
                                                        phi_2420_ = false;
                                                    } else {
                                                        phi_2420_ = true;
                                                    }
                                                    let _e3737 = phi_2420_;
                                                    phi_2421_ = _e3737;
                                                    phi_2422_ = _e3735;
                                                    phi_2423_ = false;
                                                } else {
                                                    phi_2421_ = false;
                                                    phi_2422_ = false;
                                                    phi_2423_ = true;
                                                }
                                                let _e3739 = phi_2421_;
                                                let _e3741 = phi_2422_;
                                                let _e3743 = phi_2423_;
                                                phi_2424_ = _e3739;
                                                phi_2425_ = _e3741;
                                                phi_2426_ = _e3743;
                                            }
                                            let _e3745 = phi_2424_;
                                            let _e3747 = phi_2425_;
                                            let _e3749 = phi_2426_;
                                            phi_2427_ = _e3745;
                                            phi_2428_ = _e3728;
                                            phi_2429_ = _e3747;
                                            phi_2430_ = _e3749;
                                            phi_2431_ = false;
                                        } else {
                                            phi_2427_ = false;
                                            phi_2428_ = false;
                                            phi_2429_ = false;
                                            phi_2430_ = false;
                                            phi_2431_ = true;
                                        }
                                        let _e3751 = phi_2427_;
                                        let _e3753 = phi_2428_;
                                        let _e3755 = phi_2429_;
                                        let _e3757 = phi_2430_;
                                        let _e3759 = phi_2431_;
                                        let _e5327 = local_65;
                                        phi_2432_ = _e5327;
                                        let _e5330 = local_66;
                                        phi_2433_ = _e5330;
                                        phi_2434_ = _e3751;
                                        phi_2435_ = _e3753;
                                        phi_2436_ = _e3755;
                                        phi_2437_ = _e3757;
                                        phi_2438_ = _e3759;
                                        phi_2439_ = false;
                                    } else {
                                        phi_2432_ = f32();
                                        phi_2433_ = f32();
                                        phi_2434_ = false;
                                        phi_2435_ = false;
                                        phi_2436_ = false;
                                        phi_2437_ = false;
                                        phi_2438_ = false;
                                        phi_2439_ = true;
                                    }
                                    let _e3761 = phi_2432_;
                                    let _e3763 = phi_2433_;
                                    let _e3765 = phi_2434_;
                                    let _e3767 = phi_2435_;
                                    let _e3769 = phi_2436_;
                                    let _e3771 = phi_2437_;
                                    let _e3773 = phi_2438_;
                                    let _e3775 = phi_2439_;
                                    phi_2440_ = _e3761;
                                    phi_2441_ = _e3763;
                                    phi_2442_ = _e3765;
                                    phi_2443_ = _e3767;
                                    phi_2444_ = _e3769;
                                    phi_2445_ = _e3771;
                                    phi_2446_ = _e3773;
                                    phi_2447_ = _e3775;
                                    phi_2448_ = false;
                                } else {
                                    phi_2440_ = f32();
                                    phi_2441_ = f32();
                                    phi_2442_ = false;
                                    phi_2443_ = false;
                                    phi_2444_ = false;
                                    phi_2445_ = false;
                                    phi_2446_ = false;
                                    phi_2447_ = false;
                                    phi_2448_ = true;
                                }
                                let _e3777 = phi_2440_;
                                let _e3779 = phi_2441_;
                                let _e3781 = phi_2442_;
                                let _e3783 = phi_2443_;
                                let _e3785 = phi_2444_;
                                let _e3787 = phi_2445_;
                                let _e3789 = phi_2446_;
                                let _e3791 = phi_2447_;
                                let _e3793 = phi_2448_;
                                phi_2449_ = _e3777;
                                phi_1560_ = _e3779;
                                phi_2450_ = _e3781;
                                phi_2451_ = _e3783;
                                phi_2452_ = _e3785;
                                phi_2453_ = false;
                                phi_2454_ = _e3787;
                                phi_2455_ = _e3789;
                                phi_2456_ = _e3791;
                                phi_2457_ = _e3793;
                            } else {
                                phi_2449_ = f32();
                                phi_1560_ = f32();
                                phi_2450_ = false;
                                phi_2451_ = false;
                                phi_2452_ = false;
                                phi_2453_ = true;
                                phi_2454_ = false;
                                phi_2455_ = false;
                                phi_2456_ = false;
                                phi_2457_ = false;
                            }
                            let _e3795 = phi_2449_;
                            let _e3797 = phi_1560_;
                            let _e3799 = phi_2450_;
                            let _e3801 = phi_2451_;
                            let _e3803 = phi_2452_;
                            let _e3805 = phi_2453_;
                            let _e3807 = phi_2454_;
                            let _e3809 = phi_2455_;
                            let _e3811 = phi_2456_;
                            let _e3813 = phi_2457_;
                            local_38 = _e3801;
                            local_67 = _e3803;
                            local_68 = _e3805;
                            local_69 = _e3807;
                            local_70 = _e3809;
                            local_71 = _e3811;
                            local_72 = _e3813;
                            local_73 = _e3795;
                            local_75 = _e3801;
                            continue;
                            continuing {
                                phi_1556_ = _e3207;
                                phi_1559_ = _e3797;
                                break if !(_e3799);
                            }
                        }
                        let _e3816 = local_38;
                        if _e3816 {
                            phi_2462_ = type_55(0u, type_55().member_1);
                            phi_2463_ = false;
                            phi_2464_ = false;
                            phi_2465_ = false;
                            phi_2466_ = false;
                            phi_2467_ = false;
                            phi_2468_ = false;
                        } else {
                            phi_2462_ = type_55();
                            let _e5360 = local_67;
                            phi_2463_ = _e5360;
                            let _e5363 = local_68;
                            phi_2464_ = _e5363;
                            let _e5366 = local_69;
                            phi_2465_ = _e5366;
                            let _e5369 = local_70;
                            phi_2466_ = _e5369;
                            let _e5372 = local_71;
                            phi_2467_ = _e5372;
                            let _e5375 = local_72;
                            phi_2468_ = _e5375;
                        }
                        let _e3821 = phi_2462_;
                        let _e3823 = phi_2463_;
                        let _e3825 = phi_2464_;
                        let _e3827 = phi_2465_;
                        let _e3829 = phi_2466_;
                        let _e3831 = phi_2467_;
                        let _e3833 = phi_2468_;
                        if _e3823 {
                            let _e5378 = local_73;
                            phi_2472_ = _e5378;
                            phi_2473_ = true;
                            phi_2474_ = false;
                            phi_2475_ = false;
                            phi_2476_ = false;
                            phi_2477_ = false;
                            phi_2478_ = false;
                        } else {
                            let _e5380 = local_74;
                            phi_2472_ = _e5380;
                            phi_2473_ = _e3825;
                            phi_2474_ = _e3827;
                            phi_2475_ = _e3829;
                            let _e5386 = local_75;
                            phi_2476_ = _e5386;
                            phi_2477_ = _e3831;
                            phi_2478_ = _e3833;
                        }
                        let _e3835 = phi_2472_;
                        let _e3837 = phi_2473_;
                        let _e3839 = phi_2474_;
                        let _e3841 = phi_2475_;
                        let _e3843 = phi_2476_;
                        let _e3845 = phi_2477_;
                        let _e3847 = phi_2478_;
                        if _e3837 {
                            phi_2483_ = type_55(1u, _e3835);
                            phi_2484_ = false;
                            phi_2485_ = false;
                            phi_2486_ = false;
                            phi_2487_ = false;
                            phi_2488_ = false;
                        } else {
                            phi_2483_ = type_55();
                            phi_2484_ = _e3839;
                            phi_2485_ = _e3841;
                            phi_2486_ = _e3843;
                            phi_2487_ = _e3845;
                            phi_2488_ = _e3847;
                        }
                        let _e3850 = phi_2483_;
                        let _e3852 = phi_2484_;
                        let _e3854 = phi_2485_;
                        let _e3856 = phi_2486_;
                        let _e3858 = phi_2487_;
                        let _e3860 = phi_2488_;
                        if _e3852 {
                            let _e3862 = local_39;
                            phi_2493_ = type_55(1u, _e3862);
                            phi_2494_ = false;
                            phi_2495_ = true;
                            phi_2496_ = false;
                            phi_2497_ = false;
                        } else {
                            phi_2493_ = _e3821;
                            phi_2494_ = _e3854;
                            phi_2495_ = _e3856;
                            phi_2496_ = _e3858;
                            phi_2497_ = _e3860;
                        }
                        let _e3865 = phi_2493_;
                        let _e3867 = phi_2494_;
                        let _e3869 = phi_2495_;
                        let _e3871 = phi_2496_;
                        let _e3873 = phi_2497_;
                        if _e3867 {
                            let _e3875 = local_40;
                            phi_2502_ = type_55(1u, _e3875);
                            phi_2503_ = true;
                            phi_2504_ = false;
                            phi_2505_ = false;
                        } else {
                            phi_2502_ = _e3865;
                            phi_2503_ = _e3869;
                            phi_2504_ = _e3871;
                            phi_2505_ = _e3873;
                        }
                        let _e3878 = phi_2502_;
                        let _e3880 = phi_2503_;
                        let _e3882 = phi_2504_;
                        let _e3884 = phi_2505_;
                        if _e3880 {
                            phi_2509_ = false;
                            phi_2510_ = false;
                        } else {
                            phi_2509_ = _e3882;
                            phi_2510_ = _e3884;
                        }
                        let _e3886 = phi_2509_;
                        let _e3888 = phi_2510_;
                        if _e3886 {
                            phi_2514_ = false;
                            phi_2515_ = false;
                        } else {
                            phi_2514_ = _e3888;
                            phi_2515_ = _e3880;
                        }
                        let _e3890 = phi_2514_;
                        let _e3892 = phi_2515_;
                        if _e3890 {
                            phi_2519_ = true;
                            phi_2520_ = false;
                        } else {
                            phi_2519_ = _e3886;
                            phi_2520_ = _e3892;
                        }
                        let _e3894 = phi_2519_;
                        let _e3896 = phi_2520_;
                        if _e3894 {
                            let _e3898 = local_41;
                            phi_2525_ = type_55(1u, _e3898);
                            phi_2526_ = true;
                        } else {
                            phi_2525_ = _e3878;
                            phi_2526_ = _e3896;
                        }
                        let _e3901 = phi_2525_;
                        let _e3903 = phi_2526_;
                        if _e3903 {
                            phi_2530_ = _e3901;
                        } else {
                            phi_2530_ = _e3850;
                        }
                        let _e3905 = phi_2530_;
                        if (_e3905.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_2544_ = type_28(0u, 3u);
                            loop {
                                let _e3918 = phi_2544_;
                                if (_e3918.member < _e3918.member_1) {
                                    phi_2545_ = type_28((_e3918.member + 1u), _e3918.member_1);
                                    phi_2568_ = type_28(1u, _e3918.member);
                                } else {
                                    phi_2545_ = _e3918;
                                    phi_2568_ = type_28(0u, type_28().member_1);
                                }
                                let _e3932 = phi_2545_;
                                let _e3934 = phi_2568_;
                                if (bitcast<i32>(_e3934.member) != 0i) {
                                    if (_e3934.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e3941 = local_14[_e3934.member_1];
                                    let _e3942 = (_e3905.member_1 + _e3941);
                                    if (_e3942 < 1f) {
                                        phi_2588_ = _e3942;
                                    } else {
                                        phi_2588_ = 1f;
                                    }
                                    let _e3945 = phi_2588_;
                                    let _e3948 = local_15.member[0u];
                                    let _e3954 = local_15.member[1u];
                                    let _e3964 = (_e3948[0] + ((_e3954[0] - _e3948[0]) * _e3945));
                                    let _e3965 = (_e3948[1] + ((_e3954[1] - _e3948[1]) * _e3945));
                                    let _e3966 = (_e3948[2] + ((_e3954[2] - _e3948[2]) * _e3945));
                                    let _e3969 = local_15.member_1[0u];
                                    let _e3975 = local_15.member_1[1u];
                                    let _e3985 = (_e3969[0] + ((_e3975[0] - _e3969[0]) * _e3945));
                                    let _e3986 = (_e3969[1] + ((_e3975[1] - _e3969[1]) * _e3945));
                                    let _e3987 = (_e3969[2] + ((_e3975[2] - _e3969[2]) * _e3945));
                                    let _e3990 = local_15.member_2[0u];
                                    let _e3996 = local_15.member_2[1u];
                                    let _e4006 = (_e3990[0] + ((_e3996[0] - _e3990[0]) * _e3945));
                                    let _e4007 = (_e3990[1] + ((_e3996[1] - _e3990[1]) * _e3945));
                                    let _e4008 = (_e3990[2] + ((_e3996[2] - _e3990[2]) * _e3945));
                                    let _e4013 = (((_e3985 * _e3985) + (_e3986 * _e3986)) + (_e3987 * _e3987));
                                    let _e4018 = (((_e3985 * _e4006) + (_e3986 * _e4007)) + (_e3987 * _e4008));
                                    let _e4023 = (((_e4006 * _e4006) + (_e4007 * _e4007)) + (_e4008 * _e4008));
                                    let _e4028 = (((_e3964 * _e3985) + (_e3965 * _e3986)) + (_e3966 * _e3987));
                                    let _e4033 = (((_e3964 * _e4006) + (_e3965 * _e4007)) + (_e3966 * _e4008));
                                    let _e4036 = ((_e4013 * _e4023) - (_e4018 * _e4018));
                                    let _e4040 = (((_e4028 * _e4023) - (_e4033 * _e4018)) / _e4036);
                                    let _e4044 = (((_e4033 * _e4013) - (_e4028 * _e4018)) / _e4036);
                                    if (_e4040 >= 0f) {
                                        if (_e4044 >= 0f) {
                                            if (_e4040 <= 1f) {
                                                phi_2736_ = (_e4044 <= 1f);
                                                phi_2737_ = false;
                                            } else {
                                                phi_2736_ = bool();
                                                phi_2737_ = true;
                                            }
                                            let _e4050 = phi_2736_;
                                            let _e4052 = phi_2737_;
                                            phi_2738_ = _e4050;
                                            phi_2739_ = _e4052;
                                        } else {
                                            phi_2738_ = bool();
                                            phi_2739_ = true;
                                        }
                                        let _e4054 = phi_2738_;
                                        let _e4056 = phi_2739_;
                                        phi_2740_ = _e4054;
                                        phi_2741_ = _e4056;
                                    } else {
                                        phi_2740_ = bool();
                                        phi_2741_ = true;
                                    }
                                    let _e4058 = phi_2740_;
                                    let _e4060 = phi_2741_;
                                    if _e4060 {
                                        phi_2745_ = false;
                                    } else {
                                        phi_2745_ = _e4058;
                                    }
                                    let _e4062 = phi_2745_;
                                    if (_e4036 > 0f) {
                                        if _e4062 {
                                            phi_2785_ = array<f32, 3>((_e3964 - ((_e3985 * _e4040) + (_e4006 * _e4044))), (_e3965 - ((_e3986 * _e4040) + (_e4007 * _e4044))), (_e3966 - ((_e3987 * _e4040) + (_e4008 * _e4044))));
                                            phi_2786_ = false;
                                        } else {
                                            phi_2785_ = array<f32, 3>();
                                            phi_2786_ = true;
                                        }
                                        let _e4078 = phi_2785_;
                                        let _e4080 = phi_2786_;
                                        phi_2787_ = _e4078;
                                        phi_2788_ = _e4080;
                                    } else {
                                        phi_2787_ = array<f32, 3>();
                                        phi_2788_ = true;
                                    }
                                    let _e4082 = phi_2787_;
                                    let _e4084 = phi_2788_;
                                    if _e4084 {
                                        let _e4085 = (_e3964 - _e3985);
                                        let _e4086 = (_e3965 - _e3986);
                                        let _e4087 = (_e3966 - _e3987);
                                        let _e4098 = ((((_e3964 * _e3985) + (_e3965 * _e3986)) + (_e3966 * _e3987)) / (((_e3985 * _e3985) + (_e3986 * _e3986)) + (_e3987 * _e3987)));
                                        if (_e4098 > 0f) {
                                            if (_e4098 < 1f) {
                                                phi_2818_ = _e4098;
                                            } else {
                                                phi_2818_ = 1f;
                                            }
                                            let _e4102 = phi_2818_;
                                            phi_2819_ = _e4102;
                                        } else {
                                            phi_2819_ = 0f;
                                        }
                                        let _e4104 = phi_2819_;
                                        let _e4121 = ((((_e3964 * _e4006) + (_e3965 * _e4007)) + (_e3966 * _e4008)) / (((_e4006 * _e4006) + (_e4007 * _e4007)) + (_e4008 * _e4008)));
                                        if (_e4121 > 0f) {
                                            if (_e4121 < 1f) {
                                                phi_2846_ = _e4121;
                                            } else {
                                                phi_2846_ = 1f;
                                            }
                                            let _e4125 = phi_2846_;
                                            phi_2847_ = _e4125;
                                        } else {
                                            phi_2847_ = 0f;
                                        }
                                        let _e4127 = phi_2847_;
                                        let _e4144 = ((((_e4085 * _e4006) + (_e4086 * _e4007)) + (_e4087 * _e4008)) / (((_e4006 * _e4006) + (_e4007 * _e4007)) + (_e4008 * _e4008)));
                                        if (_e4144 > 0f) {
                                            if (_e4144 < 1f) {
                                                phi_2874_ = _e4144;
                                            } else {
                                                phi_2874_ = 1f;
                                            }
                                            let _e4148 = phi_2874_;
                                            phi_2875_ = _e4148;
                                        } else {
                                            phi_2875_ = 0f;
                                        }
                                        let _e4150 = phi_2875_;
                                        let _e4157 = (_e3964 - _e4006);
                                        let _e4158 = (_e3965 - _e4007);
                                        let _e4159 = (_e3966 - _e4008);
                                        let _e4170 = ((((_e4157 * _e3985) + (_e4158 * _e3986)) + (_e4159 * _e3987)) / (((_e3985 * _e3985) + (_e3986 * _e3986)) + (_e3987 * _e3987)));
                                        if (_e4170 > 0f) {
                                            if (_e4170 < 1f) {
                                                phi_2905_ = _e4170;
                                            } else {
                                                phi_2905_ = 1f;
                                            }
                                            let _e4174 = phi_2905_;
                                            phi_2906_ = _e4174;
                                        } else {
                                            phi_2906_ = 0f;
                                        }
                                        let _e4176 = phi_2906_;
                                        local_10[0u] = array<f32, 3>((_e3964 - (_e3985 * _e4104)), (_e3965 - (_e3986 * _e4104)), (_e3966 - (_e3987 * _e4104)));
                                        local_10[1u] = array<f32, 3>((_e3964 - (_e4006 * _e4127)), (_e3965 - (_e4007 * _e4127)), (_e3966 - (_e4008 * _e4127)));
                                        local_10[2u] = array<f32, 3>((_e4085 - (_e4006 * _e4150)), (_e4086 - (_e4007 * _e4150)), (_e4087 - (_e4008 * _e4150)));
                                        local_10[3u] = array<f32, 3>((_e4157 - (_e3985 * _e4176)), (_e4158 - (_e3986 * _e4176)), (_e4159 - (_e3987 * _e4176)));
                                        let _e4192 = local_10[0u];
                                        phi_3049_ = type_28(1u, 4u);
                                        phi_3052_ = array<f32, 3>(_e4192[0], _e4192[1], _e4192[2]);
                                        loop {
                                            let _e4198 = phi_3049_;
                                            let _e4200 = phi_3052_;
                                            local_76 = _e4200;
                                            if (_e4198.member < _e4198.member_1) {
                                                phi_3050_ = type_28((_e4198.member + 1u), _e4198.member_1);
                                                phi_3075_ = type_28(1u, _e4198.member);
                                            } else {
                                                phi_3050_ = _e4198;
                                                phi_3075_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4214 = phi_3050_;
                                            let _e4216 = phi_3075_;
                                            let _e4220 = (bitcast<i32>(_e4216.member) != 0i);
                                            if _e4220 {
                                                if (_e4216.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4223 = local_10[_e4216.member_1];
                                                if (_e4216.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4229 = local_10[_e4216.member_1];
                                                if ((((_e4223[0] * _e4229[0]) + (_e4223[1] * _e4229[1])) + (_e4223[2] * _e4229[2])) < (((_e4200[0] * _e4200[0]) + (_e4200[1] * _e4200[1])) + (_e4200[2] * _e4200[2]))) {
                                                    if (_e4216.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4252 = local_10[_e4216.member_1];
                                                    phi_3142_ = array<f32, 3>(_e4252[0], _e4252[1], _e4252[2]);
                                                } else {
                                                    phi_3142_ = _e4200;
                                                }
                                                let _e4258 = phi_3142_;
                                                phi_3053_ = _e4258;
                                            } else {
                                                phi_3053_ = array<f32, 3>();
                                            }
                                            let _e4260 = phi_3053_;
                                            continue;
                                            continuing {
                                                phi_3049_ = _e4214;
                                                phi_3052_ = _e4260;
                                                break if !(_e4220);
                                            }
                                        }
                                        let _e5447 = local_76;
                                        phi_3143_ = _e5447;
                                    } else {
                                        phi_3143_ = _e4082;
                                    }
                                    let _e4263 = phi_3143_;
                                    let _e4274 = (((_e4263[0] * _e4263[0]) + (_e4263[1] * _e4263[1])) + (_e4263[2] * _e4263[2]));
                                    if (_e4274 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4274 > 0f) {
                                            phi_3168_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3168_ = 0f;
                                        }
                                        let _e4333 = phi_3168_;
                                        phi_3232_ = _e4333;
                                    } else {
                                        phi_3175_ = type_26(0i, 5i);
                                        phi_3178_ = bitcast<f32>(((bitcast<u32>(_e4274) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4282 = phi_3175_;
                                            let _e4284 = phi_3178_;
                                            local_42 = _e4284;
                                            if (_e4282.member < _e4282.member_1) {
                                                let _e4292 = (_e4282.member + 1i);
                                                if ((false == (_e4292 > _e4282.member)) != false) {
                                                    phi_3199_ = true;
                                                } else {
                                                    phi_3199_ = false;
                                                }
                                                let _e4297 = phi_3199_;
                                                if _e4297 {
                                                    phi_3205_ = type_27(0u, type_27().member_1);
                                                } else {
                                                    phi_3205_ = type_27(1u, _e4292);
                                                }
                                                let _e4303 = phi_3205_;
                                                if (bitcast<i32>(_e4303.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3176_ = type_26(_e4303.member_1, _e4282.member_1);
                                                phi_3219_ = type_27(1u, _e4282.member);
                                            } else {
                                                phi_3176_ = _e4282;
                                                phi_3219_ = type_27(0u, type_27().member_1);
                                            }
                                            let _e4313 = phi_3176_;
                                            let _e4315 = phi_3219_;
                                            let _e4318 = (bitcast<i32>(_e4315.member) != 0i);
                                            if _e4318 {
                                                phi_3179_ = (0.5f * (_e4284 + (_e4274 / _e4284)));
                                            } else {
                                                phi_3179_ = f32();
                                            }
                                            let _e4323 = phi_3179_;
                                            continue;
                                            continuing {
                                                phi_3175_ = _e4313;
                                                phi_3178_ = _e4323;
                                                break if !(_e4318);
                                            }
                                        }
                                        let _e4328 = local_42;
                                        phi_3232_ = (_e4328 * (1f + (4f * 0.000000059604645f)));
                                    }
                                    let _e4335 = phi_3232_;
                                    let _e4341 = local_15.member[0u];
                                    if (_e4341[0] < 0f) {
                                        phi_3248_ = -(_e4341[0]);
                                    } else {
                                        phi_3248_ = _e4341[0];
                                    }
                                    let _e4348 = phi_3248_;
                                    if (_e4341[1] < 0f) {
                                        phi_3255_ = -(_e4341[1]);
                                    } else {
                                        phi_3255_ = _e4341[1];
                                    }
                                    let _e4352 = phi_3255_;
                                    if (_e4348 > _e4352) {
                                        phi_3260_ = _e4348;
                                    } else {
                                        phi_3260_ = _e4352;
                                    }
                                    let _e4355 = phi_3260_;
                                    if (_e4341[2] < 0f) {
                                        phi_3267_ = -(_e4341[2]);
                                    } else {
                                        phi_3267_ = _e4341[2];
                                    }
                                    let _e4359 = phi_3267_;
                                    if (_e4355 > _e4359) {
                                        phi_3272_ = _e4355;
                                    } else {
                                        phi_3272_ = _e4359;
                                    }
                                    let _e4362 = phi_3272_;
                                    let _e4365 = local_15.member[1u];
                                    if (_e4365[0] < 0f) {
                                        phi_3285_ = -(_e4365[0]);
                                    } else {
                                        phi_3285_ = _e4365[0];
                                    }
                                    let _e4372 = phi_3285_;
                                    if (_e4365[1] < 0f) {
                                        phi_3292_ = -(_e4365[1]);
                                    } else {
                                        phi_3292_ = _e4365[1];
                                    }
                                    let _e4376 = phi_3292_;
                                    if (_e4372 > _e4376) {
                                        phi_3297_ = _e4372;
                                    } else {
                                        phi_3297_ = _e4376;
                                    }
                                    let _e4379 = phi_3297_;
                                    if (_e4365[2] < 0f) {
                                        phi_3304_ = -(_e4365[2]);
                                    } else {
                                        phi_3304_ = _e4365[2];
                                    }
                                    let _e4383 = phi_3304_;
                                    if (_e4379 > _e4383) {
                                        phi_3309_ = _e4379;
                                    } else {
                                        phi_3309_ = _e4383;
                                    }
                                    let _e4386 = phi_3309_;
                                    if (_e4362 > _e4386) {
                                        phi_3314_ = _e4362;
                                    } else {
                                        phi_3314_ = _e4386;
                                    }
                                    let _e4389 = phi_3314_;
                                    let _e4391 = local_15.member_3;
                                    let _e4395 = local_15.member_1[0u];
                                    if (_e4395[0] < 0f) {
                                        phi_3331_ = -(_e4395[0]);
                                    } else {
                                        phi_3331_ = _e4395[0];
                                    }
                                    let _e4402 = phi_3331_;
                                    if (_e4395[1] < 0f) {
                                        phi_3338_ = -(_e4395[1]);
                                    } else {
                                        phi_3338_ = _e4395[1];
                                    }
                                    let _e4406 = phi_3338_;
                                    if (_e4402 > _e4406) {
                                        phi_3343_ = _e4402;
                                    } else {
                                        phi_3343_ = _e4406;
                                    }
                                    let _e4409 = phi_3343_;
                                    if (_e4395[2] < 0f) {
                                        phi_3350_ = -(_e4395[2]);
                                    } else {
                                        phi_3350_ = _e4395[2];
                                    }
                                    let _e4413 = phi_3350_;
                                    if (_e4409 > _e4413) {
                                        phi_3355_ = _e4409;
                                    } else {
                                        phi_3355_ = _e4413;
                                    }
                                    let _e4416 = phi_3355_;
                                    let _e4419 = local_15.member_1[1u];
                                    if (_e4419[0] < 0f) {
                                        phi_3369_ = -(_e4419[0]);
                                    } else {
                                        phi_3369_ = _e4419[0];
                                    }
                                    let _e4426 = phi_3369_;
                                    if (_e4419[1] < 0f) {
                                        phi_3376_ = -(_e4419[1]);
                                    } else {
                                        phi_3376_ = _e4419[1];
                                    }
                                    let _e4430 = phi_3376_;
                                    if (_e4426 > _e4430) {
                                        phi_3381_ = _e4426;
                                    } else {
                                        phi_3381_ = _e4430;
                                    }
                                    let _e4433 = phi_3381_;
                                    if (_e4419[2] < 0f) {
                                        phi_3388_ = -(_e4419[2]);
                                    } else {
                                        phi_3388_ = _e4419[2];
                                    }
                                    let _e4437 = phi_3388_;
                                    if (_e4433 > _e4437) {
                                        phi_3393_ = _e4433;
                                    } else {
                                        phi_3393_ = _e4437;
                                    }
                                    let _e4440 = phi_3393_;
                                    if (_e4416 > _e4440) {
                                        phi_3398_ = _e4416;
                                    } else {
                                        phi_3398_ = _e4440;
                                    }
                                    let _e4443 = phi_3398_;
                                    let _e4445 = local_15.member_3;
                                    let _e4449 = local_15.member_2[0u];
                                    if (_e4449[0] < 0f) {
                                        phi_3415_ = -(_e4449[0]);
                                    } else {
                                        phi_3415_ = _e4449[0];
                                    }
                                    let _e4456 = phi_3415_;
                                    if (_e4449[1] < 0f) {
                                        phi_3422_ = -(_e4449[1]);
                                    } else {
                                        phi_3422_ = _e4449[1];
                                    }
                                    let _e4460 = phi_3422_;
                                    if (_e4456 > _e4460) {
                                        phi_3427_ = _e4456;
                                    } else {
                                        phi_3427_ = _e4460;
                                    }
                                    let _e4463 = phi_3427_;
                                    if (_e4449[2] < 0f) {
                                        phi_3434_ = -(_e4449[2]);
                                    } else {
                                        phi_3434_ = _e4449[2];
                                    }
                                    let _e4467 = phi_3434_;
                                    if (_e4463 > _e4467) {
                                        phi_3439_ = _e4463;
                                    } else {
                                        phi_3439_ = _e4467;
                                    }
                                    let _e4470 = phi_3439_;
                                    let _e4473 = local_15.member_2[1u];
                                    if (_e4473[0] < 0f) {
                                        phi_3453_ = -(_e4473[0]);
                                    } else {
                                        phi_3453_ = _e4473[0];
                                    }
                                    let _e4480 = phi_3453_;
                                    if (_e4473[1] < 0f) {
                                        phi_3460_ = -(_e4473[1]);
                                    } else {
                                        phi_3460_ = _e4473[1];
                                    }
                                    let _e4484 = phi_3460_;
                                    if (_e4480 > _e4484) {
                                        phi_3465_ = _e4480;
                                    } else {
                                        phi_3465_ = _e4484;
                                    }
                                    let _e4487 = phi_3465_;
                                    if (_e4473[2] < 0f) {
                                        phi_3472_ = -(_e4473[2]);
                                    } else {
                                        phi_3472_ = _e4473[2];
                                    }
                                    let _e4491 = phi_3472_;
                                    if (_e4487 > _e4491) {
                                        phi_3477_ = _e4487;
                                    } else {
                                        phi_3477_ = _e4491;
                                    }
                                    let _e4494 = phi_3477_;
                                    if (_e4470 > _e4494) {
                                        phi_3482_ = _e4470;
                                    } else {
                                        phi_3482_ = _e4494;
                                    }
                                    let _e4497 = phi_3482_;
                                    let _e4499 = local_15.member_3;
                                    let _e4506 = local_15.member_3;
                                    let _e4513 = (((_e4335 * (1f + (0.000000059604645f * 8f))) + (((((((_e4389 + _e4391) + (_e4443 + _e4445)) + (_e4497 + _e4499)) * (0.000000059604645f * 16f)) + (_e4506 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e265);
                                    if _e4513 {
                                        phi_3502_ = false;
                                    } else {
                                        phi_3502_ = true;
                                    }
                                    let _e4515 = phi_3502_;
                                    phi_3503_ = _e4515;
                                    phi_3504_ = _e4513;
                                } else {
                                    phi_3503_ = false;
                                    phi_3504_ = false;
                                }
                                let _e4517 = phi_3503_;
                                let _e4519 = phi_3504_;
                                local_43 = _e4519;
                                continue;
                                continuing {
                                    phi_2544_ = _e3932;
                                    break if !(_e4517);
                                }
                            }
                            let _e4522 = local_43;
                            if _e4522 {
                                phi_3509_ = type_55(1u, _e3905.member_1);
                                phi_3510_ = false;
                            } else {
                                phi_3509_ = type_55();
                                phi_3510_ = true;
                            }
                            let _e4525 = phi_3509_;
                            let _e4527 = phi_3510_;
                            if _e4527 {
                                phi_3515_ = type_55(2u, _e3905.member_1);
                                phi_3516_ = false;
                            } else {
                                phi_3515_ = type_55();
                                phi_3516_ = true;
                            }
                            let _e4530 = phi_3515_;
                            let _e4532 = phi_3516_;
                            phi_3518_ = _e4530;
                            phi_3519_ = _e4525;
                            phi_3520_ = _e4532;
                        } else {
                            phi_3518_ = type_55();
                            phi_3519_ = type_55(0u, type_55().member_1);
                            phi_3520_ = true;
                        }
                        let _e4534 = phi_3518_;
                        let _e4536 = phi_3519_;
                        let _e4538 = phi_3520_;
                        if _e4538 {
                            phi_3524_ = _e4536;
                        } else {
                            phi_3524_ = _e4534;
                        }
                        let _e4540 = phi_3524_;
                        phi_6734_ = _e4540;
                    } else {
                        if (_e363 < 0f) {
                            phi_3534_ = -(_e363);
                        } else {
                            phi_3534_ = _e363;
                        }
                        let _e706 = phi_3534_;
                        if (_e386 < 0f) {
                            phi_3540_ = -(_e386);
                        } else {
                            phi_3540_ = _e386;
                        }
                        let _e710 = phi_3540_;
                        if (_e706 > _e710) {
                            phi_3545_ = _e706;
                        } else {
                            phi_3545_ = _e710;
                        }
                        let _e713 = phi_3545_;
                        if (_e409 < 0f) {
                            phi_3551_ = -(_e409);
                        } else {
                            phi_3551_ = _e409;
                        }
                        let _e717 = phi_3551_;
                        if (_e420 < 0f) {
                            phi_3557_ = -(_e420);
                        } else {
                            phi_3557_ = _e420;
                        }
                        let _e721 = phi_3557_;
                        if (_e717 > _e721) {
                            phi_3562_ = _e717;
                        } else {
                            phi_3562_ = _e721;
                        }
                        let _e724 = phi_3562_;
                        if (_e713 > _e724) {
                            phi_3567_ = _e713;
                        } else {
                            phi_3567_ = _e724;
                        }
                        let _e727 = phi_3567_;
                        let _e730 = ((_e670 * 0.34f) + (_e727 * (0.000000059604645f * 256f)));
                        let _e732 = (_e386 - (3f * _e363));
                        let _e733 = (_e409 - _e386);
                        let _e735 = ((3f * _e420) - _e409);
                        local_7[0u] = 0f;
                        local_7[1u] = 1f;
                        local_7[2u] = 1f;
                        local_7[3u] = 1f;
                        let _e742 = ((_e733 * _e733) - (_e732 * _e735));
                        if (_e742 > 0f) {
                            if (_e742 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e742 > 0f) {
                                    phi_3600_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_3600_ = 0f;
                                }
                                let _e802 = phi_3600_;
                                phi_3664_ = _e802;
                            } else {
                                phi_3607_ = type_26(0i, 5i);
                                phi_3610_ = bitcast<f32>(((bitcast<u32>(_e742) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e751 = phi_3607_;
                                    let _e753 = phi_3610_;
                                    local_16 = _e753;
                                    if (_e751.member < _e751.member_1) {
                                        let _e761 = (_e751.member + 1i);
                                        if ((false == (_e761 > _e751.member)) != false) {
                                            phi_3631_ = true;
                                        } else {
                                            phi_3631_ = false;
                                        }
                                        let _e766 = phi_3631_;
                                        if _e766 {
                                            phi_3637_ = type_27(0u, type_27().member_1);
                                        } else {
                                            phi_3637_ = type_27(1u, _e761);
                                        }
                                        let _e772 = phi_3637_;
                                        if (bitcast<i32>(_e772.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_3608_ = type_26(_e772.member_1, _e751.member_1);
                                        phi_3651_ = type_27(1u, _e751.member);
                                    } else {
                                        phi_3608_ = _e751;
                                        phi_3651_ = type_27(0u, type_27().member_1);
                                    }
                                    let _e782 = phi_3608_;
                                    let _e784 = phi_3651_;
                                    let _e787 = (bitcast<i32>(_e784.member) != 0i);
                                    if _e787 {
                                        phi_3611_ = (0.5f * (_e753 + (_e742 / _e753)));
                                    } else {
                                        phi_3611_ = f32();
                                    }
                                    let _e792 = phi_3611_;
                                    continue;
                                    continuing {
                                        phi_3607_ = _e782;
                                        phi_3610_ = _e792;
                                        break if !(_e787);
                                    }
                                }
                                let _e797 = local_16;
                                phi_3664_ = (_e797 * (1f + (4f * 0.000000059604645f)));
                            }
                            let _e804 = phi_3664_;
                            if (_e733 < 0f) {
                                phi_3670_ = -(_e804);
                            } else {
                                phi_3670_ = _e804;
                            }
                            let _e808 = phi_3670_;
                            let _e810 = -((_e733 + _e808));
                            local_8[0u] = (_e810 / (_e810 + _e735));
                            local_8[1u] = (_e732 / (_e732 + _e810));
                            let _e819 = local_8[1u];
                            let _e820 = local_8[0u];
                            if (_e819 < _e820) {
                                let _e823 = local_8[1u];
                                let _e825 = local_8[0u];
                                local_8[0u] = _e823;
                                local_8[1u] = _e825;
                            }
                            phi_3695_ = type_28(0u, 2u);
                            phi_3698_ = 1u;
                            loop {
                                let _e829 = phi_3695_;
                                let _e831 = phi_3698_;
                                local_44 = _e831;
                                if (_e829.member < _e829.member_1) {
                                    phi_3696_ = type_28((_e829.member + 1u), _e829.member_1);
                                    phi_3721_ = type_28(1u, _e829.member);
                                } else {
                                    phi_3696_ = _e829;
                                    phi_3721_ = type_28(0u, type_28().member_1);
                                }
                                let _e845 = phi_3696_;
                                let _e847 = phi_3721_;
                                let _e851 = (bitcast<i32>(_e847.member) != 0i);
                                if _e851 {
                                    if (_e847.member_1 < 2u) {
                                    } else {
                                        return;
                                    }
                                    let _e854 = local_8[_e847.member_1];
                                    if (_e854 > 0f) {
                                        if (_e847.member_1 < 2u) {
                                        } else {
                                            return;
                                        }
                                        let _e858 = local_8[_e847.member_1];
                                        if (_e858 < 1f) {
                                            if (_e847.member_1 < 2u) {
                                            } else {
                                                return;
                                            }
                                            let _e862 = local_8[_e847.member_1];
                                            if (_e831 < 4u) {
                                            } else {
                                                return;
                                            }
                                            local_7[_e831] = _e862;
                                            phi_3765_ = (_e831 + 1u);
                                        } else {
                                            phi_3765_ = _e831;
                                        }
                                        let _e867 = phi_3765_;
                                        phi_3766_ = _e867;
                                    } else {
                                        phi_3766_ = _e831;
                                    }
                                    let _e869 = phi_3766_;
                                    phi_3699_ = _e869;
                                } else {
                                    phi_3699_ = u32();
                                }
                                let _e871 = phi_3699_;
                                continue;
                                continuing {
                                    phi_3695_ = _e845;
                                    phi_3698_ = _e871;
                                    break if !(_e851);
                                }
                            }
                            let _e4795 = local_44;
                            phi_3767_ = _e4795;
                        } else {
                            phi_3767_ = 1u;
                        }
                        let _e874 = phi_3767_;
                        if (_e874 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e874] = 1f;
                        let _e877 = local_7;
                        local_9 = _e877;
                        phi_3787_ = type_28(0u, _e874);
                        loop {
                            let _e880 = phi_3787_;
                            if (_e880.member < _e880.member_1) {
                                phi_3788_ = type_28((_e880.member + 1u), _e880.member_1);
                                phi_3811_ = type_28(1u, _e880.member);
                            } else {
                                phi_3788_ = _e880;
                                phi_3811_ = type_28(0u, type_28().member_1);
                            }
                            let _e894 = phi_3788_;
                            let _e896 = phi_3811_;
                            if (bitcast<i32>(_e896.member) != 0i) {
                                if (_e896.member_1 < 4u) {
                                } else {
                                    return;
                                }
                                let _e903 = local_9[_e896.member_1];
                                let _e904 = (_e896.member_1 + 1u);
                                if (_e904 < 4u) {
                                } else {
                                    return;
                                }
                                let _e907 = local_9[_e904];
                                let _e908 = (1f - _e903);
                                let _e919 = ((((_e363 * _e908) + (_e386 * _e903)) * (_e908 * _e908)) + (((_e409 * _e908) + (_e420 * _e903)) * (_e903 * _e903)));
                                let _e920 = (1f - _e907);
                                let _e931 = ((((_e363 * _e920) + (_e386 * _e907)) * (_e920 * _e920)) + (((_e409 * _e920) + (_e420 * _e907)) * (_e907 * _e907)));
                                if (_e919 < 0f) {
                                    phi_3863_ = -(_e919);
                                } else {
                                    phi_3863_ = _e919;
                                }
                                let _e935 = phi_3863_;
                                let _e936 = (_e935 > _e730);
                                if (_e931 < 0f) {
                                    phi_3870_ = -(_e931);
                                } else {
                                    phi_3870_ = _e931;
                                }
                                let _e940 = phi_3870_;
                                let _e941 = (_e940 > _e730);
                                if _e936 {
                                    if _e941 {
                                        phi_3881_ = ((_e919 > 0f) != (_e931 > 0f));
                                        phi_3882_ = false;
                                    } else {
                                        phi_3881_ = bool();
                                        phi_3882_ = true;
                                    }
                                    let _e946 = phi_3881_;
                                    let _e948 = phi_3882_;
                                    phi_3883_ = _e946;
                                    phi_3884_ = _e948;
                                } else {
                                    phi_3883_ = bool();
                                    phi_3884_ = true;
                                }
                                let _e950 = phi_3883_;
                                let _e952 = phi_3884_;
                                if _e952 {
                                    phi_3888_ = false;
                                } else {
                                    phi_3888_ = _e950;
                                }
                                let _e954 = phi_3888_;
                                if _e936 {
                                    if _e941 {
                                        if _e954 {
                                            phi_3899_ = type_56();
                                        } else {
                                            phi_3899_ = type_56(1f, 0f, _e954);
                                        }
                                        let _e957 = phi_3899_;
                                        phi_3900_ = _e957;
                                        phi_3901_ = _e954;
                                    } else {
                                        phi_3900_ = type_56();
                                        phi_3901_ = true;
                                    }
                                    let _e959 = phi_3900_;
                                    let _e961 = phi_3901_;
                                    phi_3902_ = _e959;
                                    phi_3903_ = _e961;
                                } else {
                                    phi_3902_ = type_56();
                                    phi_3903_ = true;
                                }
                                let _e963 = phi_3902_;
                                let _e965 = phi_3903_;
                                if _e965 {
                                    if _e936 {
                                        if (_e919 < 0f) {
                                            phi_3914_ = -1f;
                                        } else {
                                            phi_3914_ = 1f;
                                        }
                                        let _e968 = phi_3914_;
                                        let _e971 = (_e409 - _e386);
                                        phi_3924_ = type_28(0u, 64u);
                                        phi_3927_ = _e907;
                                        phi_3929_ = _e903;
                                        phi_3931_ = (0.5f * (_e903 + _e907));
                                        loop {
                                            let _e977 = phi_3924_;
                                            let _e979 = phi_3927_;
                                            let _e981 = phi_3929_;
                                            let _e983 = phi_3931_;
                                            local_46 = _e981;
                                            if (_e977.member < _e977.member_1) {
                                                phi_3925_ = type_28((_e977.member + 1u), _e977.member_1);
                                                phi_3954_ = type_28(1u, _e977.member);
                                            } else {
                                                phi_3925_ = _e977;
                                                phi_3954_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e997 = phi_3925_;
                                            let _e999 = phi_3954_;
                                            if (bitcast<i32>(_e999.member) != 0i) {
                                                let _e1003 = (1f - _e983);
                                                let _e1016 = ((_e968 * ((((_e363 * _e1003) + (_e386 * _e983)) * (_e1003 * _e1003)) + (((_e409 * _e1003) + (_e420 * _e983)) * (_e983 * _e983)))) - _e730);
                                                if (_e1016 > 0f) {
                                                    phi_3979_ = _e979;
                                                    phi_3980_ = _e983;
                                                } else {
                                                    phi_3979_ = _e983;
                                                    phi_3980_ = _e981;
                                                }
                                                let _e1019 = phi_3979_;
                                                let _e1021 = phi_3980_;
                                                let _e1023 = ((_e1019 - _e1021) > 0.00000000000022737368f);
                                                if _e1023 {
                                                    let _e1024 = (1f - _e983);
                                                    let _e1036 = (-(_e1016) / (_e968 * (((((_e386 - (3f * _e363)) * _e1024) + (_e971 * _e983)) * _e1024) + (((_e971 * _e1024) + (((3f * _e420) - _e409) * _e983)) * _e983))));
                                                    if (_e1016 > 0f) {
                                                        phi_4006_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_4006_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1042 = phi_4006_;
                                                    let _e1044 = ((_e983 + _e1036) + _e1042);
                                                    if (_e1044 > _e1021) {
                                                        if (_e1044 < _e1019) {
                                                            if (_e1036 < 0f) {
                                                                phi_4022_ = -(_e1036);
                                                            } else {
                                                                phi_4022_ = _e1036;
                                                            }
                                                            let _e1050 = phi_4022_;
                                                            if (_e1050 < (0.5f * (_e1019 - _e1021))) {
                                                                phi_4029_ = false;
                                                            } else {
                                                                phi_4029_ = true;
                                                            }
                                                            let _e1055 = phi_4029_;
                                                            phi_4030_ = _e1055;
                                                        } else {
                                                            phi_4030_ = true;
                                                        }
                                                        let _e1057 = phi_4030_;
                                                        phi_4031_ = _e1057;
                                                    } else {
                                                        phi_4031_ = true;
                                                    }
                                                    let _e1059 = phi_4031_;
                                                    if _e1059 {
                                                        phi_4037_ = (0.5f * (_e1021 + _e1019));
                                                    } else {
                                                        phi_4037_ = _e1044;
                                                    }
                                                    let _e1063 = phi_4037_;
                                                    phi_4038_ = _e1063;
                                                    phi_4039_ = false;
                                                } else {
                                                    phi_4038_ = f32();
                                                    phi_4039_ = true;
                                                }
                                                let _e1065 = phi_4038_;
                                                let _e1067 = phi_4039_;
                                                phi_3928_ = _e1019;
                                                phi_3930_ = _e1021;
                                                phi_3932_ = _e1065;
                                                phi_4040_ = _e1021;
                                                phi_4041_ = _e1023;
                                                phi_4042_ = _e1067;
                                            } else {
                                                phi_3928_ = f32();
                                                phi_3930_ = f32();
                                                phi_3932_ = f32();
                                                phi_4040_ = f32();
                                                phi_4041_ = false;
                                                phi_4042_ = false;
                                            }
                                            let _e1069 = phi_3928_;
                                            let _e1071 = phi_3930_;
                                            let _e1073 = phi_3932_;
                                            let _e1075 = phi_4040_;
                                            let _e1077 = phi_4041_;
                                            let _e1079 = phi_4042_;
                                            local_17 = _e1079;
                                            local_45 = _e1075;
                                            continue;
                                            continuing {
                                                phi_3924_ = _e997;
                                                phi_3927_ = _e1069;
                                                phi_3929_ = _e1071;
                                                phi_3931_ = _e1073;
                                                break if !(_e1077);
                                            }
                                        }
                                        let _e1082 = local_17;
                                        if _e1082 {
                                            let _e4837 = local_45;
                                            phi_4046_ = _e4837;
                                        } else {
                                            let _e4839 = local_46;
                                            phi_4046_ = _e4839;
                                        }
                                        let _e1084 = phi_4046_;
                                        phi_4047_ = _e1084;
                                    } else {
                                        phi_4047_ = _e903;
                                    }
                                    let _e1086 = phi_4047_;
                                    if _e941 {
                                        phi_4054_ = type_28(0u, 64u);
                                        phi_4057_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1089 = phi_4054_;
                                            let _e1091 = phi_4057_;
                                            if (_e1089.member < _e1089.member_1) {
                                                phi_4055_ = type_28((_e1089.member + 1u), _e1089.member_1);
                                                phi_4080_ = type_28(1u, _e1089.member);
                                            } else {
                                                phi_4055_ = _e1089;
                                                phi_4080_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1105 = phi_4055_;
                                            let _e1107 = phi_4080_;
                                            if (bitcast<i32>(_e1107.member) != 0i) {
                                                let _e1111 = (_e1086 + _e1091);
                                                if (_e1111 < _e907) {
                                                    let _e1113 = (1f - _e1111);
                                                    let _e1124 = ((((_e363 * _e1113) + (_e386 * _e1111)) * (_e1113 * _e1113)) + (((_e409 * _e1113) + (_e420 * _e1111)) * (_e1111 * _e1111)));
                                                    let _e1125 = (1f - _e1086);
                                                    let _e1136 = ((((_e363 * _e1125) + (_e386 * _e1086)) * (_e1125 * _e1125)) + (((_e409 * _e1125) + (_e420 * _e1086)) * (_e1086 * _e1086)));
                                                    if (_e1124 < 0f) {
                                                        phi_4121_ = -(_e1124);
                                                    } else {
                                                        phi_4121_ = _e1124;
                                                    }
                                                    let _e1140 = phi_4121_;
                                                    if (_e1140 > _e730) {
                                                        if (_e1136 < 0f) {
                                                            phi_4131_ = -(_e1136);
                                                        } else {
                                                            phi_4131_ = _e1136;
                                                        }
                                                        let _e1145 = phi_4131_;
                                                        if (_e1145 > _e730) {
                                                            phi_4139_ = ((_e1124 > 0f) == (_e1136 > 0f));
                                                        } else {
                                                            phi_4139_ = false;
                                                        }
                                                        let _e1151 = phi_4139_;
                                                        phi_4141_ = !(_e1151);
                                                    } else {
                                                        phi_4141_ = false;
                                                    }
                                                    let _e1154 = phi_4141_;
                                                    if _e1154 {
                                                        phi_4146_ = f32();
                                                        phi_4147_ = false;
                                                    } else {
                                                        phi_4146_ = (_e1091 + _e1091);
                                                        phi_4147_ = true;
                                                    }
                                                    let _e1157 = phi_4146_;
                                                    let _e1159 = phi_4147_;
                                                    phi_4148_ = _e1157;
                                                    phi_4149_ = _e1159;
                                                    phi_4150_ = _e1154;
                                                    phi_4151_ = false;
                                                } else {
                                                    phi_4148_ = f32();
                                                    phi_4149_ = false;
                                                    phi_4150_ = false;
                                                    phi_4151_ = true;
                                                }
                                                let _e1161 = phi_4148_;
                                                let _e1163 = phi_4149_;
                                                let _e1165 = phi_4150_;
                                                let _e1167 = phi_4151_;
                                                phi_4152_ = _e1111;
                                                phi_4058_ = _e1161;
                                                phi_4153_ = _e1163;
                                                phi_4154_ = _e1165;
                                                phi_4155_ = _e1167;
                                                phi_4156_ = false;
                                            } else {
                                                phi_4152_ = f32();
                                                phi_4058_ = f32();
                                                phi_4153_ = false;
                                                phi_4154_ = false;
                                                phi_4155_ = false;
                                                phi_4156_ = true;
                                            }
                                            let _e1169 = phi_4152_;
                                            let _e1171 = phi_4058_;
                                            let _e1173 = phi_4153_;
                                            let _e1175 = phi_4154_;
                                            let _e1177 = phi_4155_;
                                            let _e1179 = phi_4156_;
                                            local_18 = _e1175;
                                            local_47 = _e1177;
                                            local_48 = _e1179;
                                            local_49 = _e1169;
                                            continue;
                                            continuing {
                                                phi_4054_ = _e1105;
                                                phi_4057_ = _e1171;
                                                break if !(_e1173);
                                            }
                                        }
                                        let _e1182 = local_18;
                                        if _e1182 {
                                            phi_4160_ = false;
                                            phi_4161_ = false;
                                        } else {
                                            let _e4864 = local_47;
                                            phi_4160_ = _e4864;
                                            let _e4867 = local_48;
                                            phi_4161_ = _e4867;
                                        }
                                        let _e1184 = phi_4160_;
                                        let _e1186 = phi_4161_;
                                        if _e1184 {
                                            phi_4165_ = true;
                                        } else {
                                            phi_4165_ = _e1186;
                                        }
                                        let _e1188 = phi_4165_;
                                        if _e1188 {
                                            phi_4169_ = _e907;
                                        } else {
                                            let _e4871 = local_49;
                                            phi_4169_ = _e4871;
                                        }
                                        let _e1190 = phi_4169_;
                                        phi_4170_ = _e1190;
                                    } else {
                                        phi_4170_ = _e907;
                                    }
                                    let _e1192 = phi_4170_;
                                    phi_4172_ = type_56(_e1086, _e1192, _e954);
                                } else {
                                    phi_4172_ = _e963;
                                }
                                let _e1195 = phi_4172_;
                                if (_e1195.member > _e1195.member_1) {
                                    phi_6690_ = f32();
                                    phi_6691_ = true;
                                    phi_6692_ = false;
                                    phi_6693_ = false;
                                    phi_6694_ = false;
                                } else {
                                    let _e1202 = ((_e1195.member_1 - _e1195.member) * 0.5f);
                                    let _e1203 = (_e1195.member + _e1202);
                                    let _e1205 = (_e1202 + (0.000000059604645f * 4f));
                                    let _e1207 = local_15.member_3;
                                    let _e1210 = local_15.member[0u];
                                    if (_e1210[0] < 0f) {
                                        phi_4201_ = -(_e1210[0]);
                                    } else {
                                        phi_4201_ = _e1210[0];
                                    }
                                    let _e1217 = phi_4201_;
                                    if (_e1210[1] < 0f) {
                                        phi_4208_ = -(_e1210[1]);
                                    } else {
                                        phi_4208_ = _e1210[1];
                                    }
                                    let _e1221 = phi_4208_;
                                    if (_e1217 > _e1221) {
                                        phi_4213_ = _e1217;
                                    } else {
                                        phi_4213_ = _e1221;
                                    }
                                    let _e1224 = phi_4213_;
                                    if (_e1210[2] < 0f) {
                                        phi_4220_ = -(_e1210[2]);
                                    } else {
                                        phi_4220_ = _e1210[2];
                                    }
                                    let _e1228 = phi_4220_;
                                    if (_e1224 > _e1228) {
                                        phi_4225_ = _e1224;
                                    } else {
                                        phi_4225_ = _e1228;
                                    }
                                    let _e1231 = phi_4225_;
                                    let _e1233 = local_15.member[1u];
                                    if (_e1233[0] < 0f) {
                                        phi_4238_ = -(_e1233[0]);
                                    } else {
                                        phi_4238_ = _e1233[0];
                                    }
                                    let _e1240 = phi_4238_;
                                    if (_e1233[1] < 0f) {
                                        phi_4245_ = -(_e1233[1]);
                                    } else {
                                        phi_4245_ = _e1233[1];
                                    }
                                    let _e1244 = phi_4245_;
                                    if (_e1240 > _e1244) {
                                        phi_4250_ = _e1240;
                                    } else {
                                        phi_4250_ = _e1244;
                                    }
                                    let _e1247 = phi_4250_;
                                    if (_e1233[2] < 0f) {
                                        phi_4257_ = -(_e1233[2]);
                                    } else {
                                        phi_4257_ = _e1233[2];
                                    }
                                    let _e1251 = phi_4257_;
                                    if (_e1247 > _e1251) {
                                        phi_4262_ = _e1247;
                                    } else {
                                        phi_4262_ = _e1251;
                                    }
                                    let _e1254 = phi_4262_;
                                    if (_e1231 > _e1254) {
                                        phi_4267_ = _e1231;
                                    } else {
                                        phi_4267_ = _e1254;
                                    }
                                    let _e1257 = phi_4267_;
                                    let _e1260 = local_15.member[0u];
                                    let _e1265 = local_15.member[1u];
                                    let _e1275 = (_e1260[0] + ((_e1265[0] - _e1260[0]) * _e1203));
                                    let _e1276 = (_e1260[1] + ((_e1265[1] - _e1260[1]) * _e1203));
                                    let _e1277 = (_e1260[2] + ((_e1265[2] - _e1260[2]) * _e1203));
                                    let _e1279 = local_15.member[1u];
                                    let _e1284 = local_15.member[0u];
                                    let _e1288 = (_e1279[0] - _e1284[0]);
                                    let _e1289 = (_e1279[1] - _e1284[1]);
                                    let _e1290 = (_e1279[2] - _e1284[2]);
                                    if (_e1288 < 0f) {
                                        phi_4326_ = -(_e1288);
                                    } else {
                                        phi_4326_ = _e1288;
                                    }
                                    let _e1294 = phi_4326_;
                                    if (_e1289 < 0f) {
                                        phi_4332_ = -(_e1289);
                                    } else {
                                        phi_4332_ = _e1289;
                                    }
                                    let _e1298 = phi_4332_;
                                    if (_e1294 > _e1298) {
                                        phi_4337_ = _e1294;
                                    } else {
                                        phi_4337_ = _e1298;
                                    }
                                    let _e1301 = phi_4337_;
                                    if (_e1290 < 0f) {
                                        phi_4343_ = -(_e1290);
                                    } else {
                                        phi_4343_ = _e1290;
                                    }
                                    let _e1305 = phi_4343_;
                                    if (_e1301 > _e1305) {
                                        phi_4348_ = _e1301;
                                    } else {
                                        phi_4348_ = _e1305;
                                    }
                                    let _e1308 = phi_4348_;
                                    let _e1314 = ((((_e1205 * _e1308) * 1.01f) + ((_e1257 + _e1207) * (0.000000059604645f * 8f))) + _e1207);
                                    if (_e1275 < 0f) {
                                        phi_4360_ = -(_e1275);
                                    } else {
                                        phi_4360_ = _e1275;
                                    }
                                    let _e1318 = phi_4360_;
                                    if (_e1276 < 0f) {
                                        phi_4366_ = -(_e1276);
                                    } else {
                                        phi_4366_ = _e1276;
                                    }
                                    let _e1322 = phi_4366_;
                                    if (_e1318 > _e1322) {
                                        phi_4371_ = _e1318;
                                    } else {
                                        phi_4371_ = _e1322;
                                    }
                                    let _e1325 = phi_4371_;
                                    if (_e1277 < 0f) {
                                        phi_4377_ = -(_e1277);
                                    } else {
                                        phi_4377_ = _e1277;
                                    }
                                    let _e1329 = phi_4377_;
                                    if (_e1325 > _e1329) {
                                        phi_4382_ = _e1325;
                                    } else {
                                        phi_4382_ = _e1329;
                                    }
                                    let _e1332 = phi_4382_;
                                    local_3 = type_40(array<f32, 3>(_e1275, _e1276, _e1277), _e1314, (_e1332 + _e1314));
                                    let _e1338 = local_15.member_3;
                                    let _e1340 = local_15.member_1[0u];
                                    if (_e1340[0] < 0f) {
                                        phi_4408_ = -(_e1340[0]);
                                    } else {
                                        phi_4408_ = _e1340[0];
                                    }
                                    let _e1347 = phi_4408_;
                                    if (_e1340[1] < 0f) {
                                        phi_4415_ = -(_e1340[1]);
                                    } else {
                                        phi_4415_ = _e1340[1];
                                    }
                                    let _e1351 = phi_4415_;
                                    if (_e1347 > _e1351) {
                                        phi_4420_ = _e1347;
                                    } else {
                                        phi_4420_ = _e1351;
                                    }
                                    let _e1354 = phi_4420_;
                                    if (_e1340[2] < 0f) {
                                        phi_4427_ = -(_e1340[2]);
                                    } else {
                                        phi_4427_ = _e1340[2];
                                    }
                                    let _e1358 = phi_4427_;
                                    if (_e1354 > _e1358) {
                                        phi_4432_ = _e1354;
                                    } else {
                                        phi_4432_ = _e1358;
                                    }
                                    let _e1361 = phi_4432_;
                                    let _e1363 = local_15.member_1[1u];
                                    if (_e1363[0] < 0f) {
                                        phi_4445_ = -(_e1363[0]);
                                    } else {
                                        phi_4445_ = _e1363[0];
                                    }
                                    let _e1370 = phi_4445_;
                                    if (_e1363[1] < 0f) {
                                        phi_4452_ = -(_e1363[1]);
                                    } else {
                                        phi_4452_ = _e1363[1];
                                    }
                                    let _e1374 = phi_4452_;
                                    if (_e1370 > _e1374) {
                                        phi_4457_ = _e1370;
                                    } else {
                                        phi_4457_ = _e1374;
                                    }
                                    let _e1377 = phi_4457_;
                                    if (_e1363[2] < 0f) {
                                        phi_4464_ = -(_e1363[2]);
                                    } else {
                                        phi_4464_ = _e1363[2];
                                    }
                                    let _e1381 = phi_4464_;
                                    if (_e1377 > _e1381) {
                                        phi_4469_ = _e1377;
                                    } else {
                                        phi_4469_ = _e1381;
                                    }
                                    let _e1384 = phi_4469_;
                                    if (_e1361 > _e1384) {
                                        phi_4474_ = _e1361;
                                    } else {
                                        phi_4474_ = _e1384;
                                    }
                                    let _e1387 = phi_4474_;
                                    let _e1390 = local_15.member_1[0u];
                                    let _e1395 = local_15.member_1[1u];
                                    let _e1405 = (_e1390[0] + ((_e1395[0] - _e1390[0]) * _e1203));
                                    let _e1406 = (_e1390[1] + ((_e1395[1] - _e1390[1]) * _e1203));
                                    let _e1407 = (_e1390[2] + ((_e1395[2] - _e1390[2]) * _e1203));
                                    let _e1409 = local_15.member_1[1u];
                                    let _e1414 = local_15.member_1[0u];
                                    let _e1418 = (_e1409[0] - _e1414[0]);
                                    let _e1419 = (_e1409[1] - _e1414[1]);
                                    let _e1420 = (_e1409[2] - _e1414[2]);
                                    if (_e1418 < 0f) {
                                        phi_4533_ = -(_e1418);
                                    } else {
                                        phi_4533_ = _e1418;
                                    }
                                    let _e1424 = phi_4533_;
                                    if (_e1419 < 0f) {
                                        phi_4539_ = -(_e1419);
                                    } else {
                                        phi_4539_ = _e1419;
                                    }
                                    let _e1428 = phi_4539_;
                                    if (_e1424 > _e1428) {
                                        phi_4544_ = _e1424;
                                    } else {
                                        phi_4544_ = _e1428;
                                    }
                                    let _e1431 = phi_4544_;
                                    if (_e1420 < 0f) {
                                        phi_4550_ = -(_e1420);
                                    } else {
                                        phi_4550_ = _e1420;
                                    }
                                    let _e1435 = phi_4550_;
                                    if (_e1431 > _e1435) {
                                        phi_4555_ = _e1431;
                                    } else {
                                        phi_4555_ = _e1435;
                                    }
                                    let _e1438 = phi_4555_;
                                    let _e1444 = ((((_e1205 * _e1438) * 1.01f) + ((_e1387 + _e1338) * (0.000000059604645f * 8f))) + _e1338);
                                    if (_e1405 < 0f) {
                                        phi_4567_ = -(_e1405);
                                    } else {
                                        phi_4567_ = _e1405;
                                    }
                                    let _e1448 = phi_4567_;
                                    if (_e1406 < 0f) {
                                        phi_4573_ = -(_e1406);
                                    } else {
                                        phi_4573_ = _e1406;
                                    }
                                    let _e1452 = phi_4573_;
                                    if (_e1448 > _e1452) {
                                        phi_4578_ = _e1448;
                                    } else {
                                        phi_4578_ = _e1452;
                                    }
                                    let _e1455 = phi_4578_;
                                    if (_e1407 < 0f) {
                                        phi_4584_ = -(_e1407);
                                    } else {
                                        phi_4584_ = _e1407;
                                    }
                                    let _e1459 = phi_4584_;
                                    if (_e1455 > _e1459) {
                                        phi_4589_ = _e1455;
                                    } else {
                                        phi_4589_ = _e1459;
                                    }
                                    let _e1462 = phi_4589_;
                                    local_4 = type_40(array<f32, 3>(_e1405, _e1406, _e1407), _e1444, (_e1462 + _e1444));
                                    let _e1468 = local_15.member_3;
                                    let _e1470 = local_15.member_2[0u];
                                    if (_e1470[0] < 0f) {
                                        phi_4615_ = -(_e1470[0]);
                                    } else {
                                        phi_4615_ = _e1470[0];
                                    }
                                    let _e1477 = phi_4615_;
                                    if (_e1470[1] < 0f) {
                                        phi_4622_ = -(_e1470[1]);
                                    } else {
                                        phi_4622_ = _e1470[1];
                                    }
                                    let _e1481 = phi_4622_;
                                    if (_e1477 > _e1481) {
                                        phi_4627_ = _e1477;
                                    } else {
                                        phi_4627_ = _e1481;
                                    }
                                    let _e1484 = phi_4627_;
                                    if (_e1470[2] < 0f) {
                                        phi_4634_ = -(_e1470[2]);
                                    } else {
                                        phi_4634_ = _e1470[2];
                                    }
                                    let _e1488 = phi_4634_;
                                    if (_e1484 > _e1488) {
                                        phi_4639_ = _e1484;
                                    } else {
                                        phi_4639_ = _e1488;
                                    }
                                    let _e1491 = phi_4639_;
                                    let _e1493 = local_15.member_2[1u];
                                    if (_e1493[0] < 0f) {
                                        phi_4652_ = -(_e1493[0]);
                                    } else {
                                        phi_4652_ = _e1493[0];
                                    }
                                    let _e1500 = phi_4652_;
                                    if (_e1493[1] < 0f) {
                                        phi_4659_ = -(_e1493[1]);
                                    } else {
                                        phi_4659_ = _e1493[1];
                                    }
                                    let _e1504 = phi_4659_;
                                    if (_e1500 > _e1504) {
                                        phi_4664_ = _e1500;
                                    } else {
                                        phi_4664_ = _e1504;
                                    }
                                    let _e1507 = phi_4664_;
                                    if (_e1493[2] < 0f) {
                                        phi_4671_ = -(_e1493[2]);
                                    } else {
                                        phi_4671_ = _e1493[2];
                                    }
                                    let _e1511 = phi_4671_;
                                    if (_e1507 > _e1511) {
                                        phi_4676_ = _e1507;
                                    } else {
                                        phi_4676_ = _e1511;
                                    }
                                    let _e1514 = phi_4676_;
                                    if (_e1491 > _e1514) {
                                        phi_4681_ = _e1491;
                                    } else {
                                        phi_4681_ = _e1514;
                                    }
                                    let _e1517 = phi_4681_;
                                    let _e1520 = local_15.member_2[0u];
                                    let _e1525 = local_15.member_2[1u];
                                    let _e1535 = (_e1520[0] + ((_e1525[0] - _e1520[0]) * _e1203));
                                    let _e1536 = (_e1520[1] + ((_e1525[1] - _e1520[1]) * _e1203));
                                    let _e1537 = (_e1520[2] + ((_e1525[2] - _e1520[2]) * _e1203));
                                    let _e1539 = local_15.member_2[1u];
                                    let _e1544 = local_15.member_2[0u];
                                    let _e1548 = (_e1539[0] - _e1544[0]);
                                    let _e1549 = (_e1539[1] - _e1544[1]);
                                    let _e1550 = (_e1539[2] - _e1544[2]);
                                    if (_e1548 < 0f) {
                                        phi_4740_ = -(_e1548);
                                    } else {
                                        phi_4740_ = _e1548;
                                    }
                                    let _e1554 = phi_4740_;
                                    if (_e1549 < 0f) {
                                        phi_4746_ = -(_e1549);
                                    } else {
                                        phi_4746_ = _e1549;
                                    }
                                    let _e1558 = phi_4746_;
                                    if (_e1554 > _e1558) {
                                        phi_4751_ = _e1554;
                                    } else {
                                        phi_4751_ = _e1558;
                                    }
                                    let _e1561 = phi_4751_;
                                    if (_e1550 < 0f) {
                                        phi_4757_ = -(_e1550);
                                    } else {
                                        phi_4757_ = _e1550;
                                    }
                                    let _e1565 = phi_4757_;
                                    if (_e1561 > _e1565) {
                                        phi_4762_ = _e1561;
                                    } else {
                                        phi_4762_ = _e1565;
                                    }
                                    let _e1568 = phi_4762_;
                                    let _e1574 = ((((_e1205 * _e1568) * 1.01f) + ((_e1517 + _e1468) * (0.000000059604645f * 8f))) + _e1468);
                                    if (_e1535 < 0f) {
                                        phi_4774_ = -(_e1535);
                                    } else {
                                        phi_4774_ = _e1535;
                                    }
                                    let _e1578 = phi_4774_;
                                    if (_e1536 < 0f) {
                                        phi_4780_ = -(_e1536);
                                    } else {
                                        phi_4780_ = _e1536;
                                    }
                                    let _e1582 = phi_4780_;
                                    if (_e1578 > _e1582) {
                                        phi_4785_ = _e1578;
                                    } else {
                                        phi_4785_ = _e1582;
                                    }
                                    let _e1585 = phi_4785_;
                                    if (_e1537 < 0f) {
                                        phi_4791_ = -(_e1537);
                                    } else {
                                        phi_4791_ = _e1537;
                                    }
                                    let _e1589 = phi_4791_;
                                    if (_e1585 > _e1589) {
                                        phi_4796_ = _e1585;
                                    } else {
                                        phi_4796_ = _e1589;
                                    }
                                    let _e1592 = phi_4796_;
                                    local_5 = type_40(array<f32, 3>(_e1535, _e1536, _e1537), _e1574, (_e1592 + _e1574));
                                    let _e1597 = local_4.member;
                                    let _e1602 = local_5.member;
                                    let _e1608 = ((_e1597[1] * _e1602[2]) - (_e1597[2] * _e1602[1]));
                                    let _e1611 = ((_e1597[2] * _e1602[0]) - (_e1597[0] * _e1602[2]));
                                    let _e1614 = ((_e1597[0] * _e1602[1]) - (_e1597[1] * _e1602[0]));
                                    if (_e1608 < 0f) {
                                        phi_4845_ = -(_e1608);
                                    } else {
                                        phi_4845_ = _e1608;
                                    }
                                    let _e1618 = phi_4845_;
                                    if (_e1611 < 0f) {
                                        phi_4851_ = -(_e1611);
                                    } else {
                                        phi_4851_ = _e1611;
                                    }
                                    let _e1622 = phi_4851_;
                                    if (_e1618 > _e1622) {
                                        if (_e1608 < 0f) {
                                            phi_4861_ = -(_e1608);
                                        } else {
                                            phi_4861_ = _e1608;
                                        }
                                        let _e1640 = phi_4861_;
                                        if (_e1614 < 0f) {
                                            phi_4867_ = -(_e1614);
                                        } else {
                                            phi_4867_ = _e1614;
                                        }
                                        let _e1644 = phi_4867_;
                                        if (_e1640 > _e1644) {
                                            phi_4872_ = 2u;
                                            phi_4873_ = 1u;
                                        } else {
                                            phi_4872_ = 1u;
                                            phi_4873_ = 0u;
                                        }
                                        let _e1647 = phi_4872_;
                                        let _e1649 = phi_4873_;
                                        phi_4892_ = _e1647;
                                        phi_4893_ = _e1649;
                                    } else {
                                        if (_e1611 < 0f) {
                                            phi_4879_ = -(_e1611);
                                        } else {
                                            phi_4879_ = _e1611;
                                        }
                                        let _e1627 = phi_4879_;
                                        if (_e1614 < 0f) {
                                            phi_4885_ = -(_e1614);
                                        } else {
                                            phi_4885_ = _e1614;
                                        }
                                        let _e1631 = phi_4885_;
                                        if (_e1627 > _e1631) {
                                            phi_4890_ = 0u;
                                            phi_4891_ = 2u;
                                        } else {
                                            phi_4890_ = 1u;
                                            phi_4891_ = 0u;
                                        }
                                        let _e1634 = phi_4890_;
                                        let _e1636 = phi_4891_;
                                        phi_4892_ = _e1634;
                                        phi_4893_ = _e1636;
                                    }
                                    let _e1651 = phi_4892_;
                                    let _e1653 = phi_4893_;
                                    if (_e1653 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1657 = local_4.member[_e1653];
                                    if (_e1651 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1661 = local_5.member[_e1651];
                                    if (_e1651 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1666 = local_4.member[_e1651];
                                    if (_e1653 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1670 = local_5.member[_e1653];
                                    let _e1672 = ((_e1657 * _e1661) - (_e1666 * _e1670));
                                    let _e1674 = local_4.member_1;
                                    let _e1676 = local_5.member_2;
                                    let _e1679 = local_4.member_2;
                                    let _e1681 = local_5.member_1;
                                    let _e1686 = local_4.member_2;
                                    let _e1688 = local_5.member_2;
                                    let _e1695 = local_4.member_2;
                                    let _e1698 = local_5.member_2;
                                    let _e1702 = (((((_e1674 * _e1676) + (_e1679 * _e1681)) * 2.01f) + ((_e1686 * _e1688) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1695) * (1f + _e1698))));
                                    if (_e1672 < 0f) {
                                        phi_4960_ = -(_e1672);
                                    } else {
                                        phi_4960_ = _e1672;
                                    }
                                    let _e1706 = phi_4960_;
                                    if (_e1706 > _e1702) {
                                        if (_e1672 < 0f) {
                                            phi_4969_ = -1f;
                                        } else {
                                            phi_4969_ = 1f;
                                        }
                                        let _e1710 = phi_4969_;
                                        if (_e1653 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1714 = local_3.member[_e1653];
                                        if (_e1651 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1718 = local_5.member[_e1651];
                                        if (_e1651 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1723 = local_3.member[_e1651];
                                        if (_e1653 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1727 = local_5.member[_e1653];
                                        let _e1731 = local_3.member_1;
                                        let _e1733 = local_5.member_2;
                                        let _e1736 = local_3.member_2;
                                        let _e1738 = local_5.member_1;
                                        let _e1743 = local_3.member_2;
                                        let _e1745 = local_5.member_2;
                                        let _e1752 = local_3.member_2;
                                        let _e1755 = local_5.member_2;
                                        let _e1759 = (((((_e1731 * _e1733) + (_e1736 * _e1738)) * 2.01f) + ((_e1743 * _e1745) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1752) * (1f + _e1755))));
                                        if (_e1653 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1763 = local_4.member[_e1653];
                                        if (_e1651 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1767 = local_3.member[_e1651];
                                        if (_e1651 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1772 = local_4.member[_e1651];
                                        if (_e1653 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1776 = local_3.member[_e1653];
                                        let _e1780 = local_4.member_1;
                                        let _e1782 = local_3.member_2;
                                        let _e1785 = local_4.member_2;
                                        let _e1787 = local_3.member_1;
                                        let _e1792 = local_4.member_2;
                                        let _e1794 = local_3.member_2;
                                        let _e1801 = local_4.member_2;
                                        let _e1804 = local_3.member_2;
                                        let _e1808 = (((((_e1780 * _e1782) + (_e1785 * _e1787)) * 2.01f) + ((_e1792 * _e1794) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1801) * (1f + _e1804))));
                                        let _e1809 = (_e1672 * _e1710);
                                        let _e1810 = (((_e1714 * _e1718) - (_e1723 * _e1727)) * _e1710);
                                        let _e1811 = (((_e1763 * _e1767) - (_e1772 * _e1776)) * _e1710);
                                        if (_e1809 < 0f) {
                                            phi_5100_ = -(_e1809);
                                        } else {
                                            phi_5100_ = _e1809;
                                        }
                                        let _e1815 = phi_5100_;
                                        if (_e1810 < 0f) {
                                            phi_5106_ = -(_e1810);
                                        } else {
                                            phi_5106_ = _e1810;
                                        }
                                        let _e1819 = phi_5106_;
                                        if (_e1811 < 0f) {
                                            phi_5113_ = -(_e1811);
                                        } else {
                                            phi_5113_ = _e1811;
                                        }
                                        let _e1824 = phi_5113_;
                                        let _e1827 = (((_e1815 + _e1819) + _e1824) * (0.000000059604645f * 4f));
                                        local_6[0u].member = _e1810;
                                        local_6[0u].member_1 = _e1759;
                                        local_6[1u].member = _e1811;
                                        local_6[1u].member_1 = _e1808;
                                        local_6[2u].member = (_e1809 - _e1810);
                                        local_6[2u].member_1 = ((_e1702 + _e1759) + _e1827);
                                        local_6[3u].member = (_e1809 - _e1811);
                                        local_6[3u].member_1 = ((_e1702 + _e1808) + _e1827);
                                        phi_5156_ = type_28(0u, 4u);
                                        phi_5159_ = true;
                                        loop {
                                            let _e1848 = phi_5156_;
                                            let _e1850 = phi_5159_;
                                            local_20 = _e1850;
                                            if (_e1848.member < _e1848.member_1) {
                                                phi_5157_ = type_28((_e1848.member + 1u), _e1848.member_1);
                                                phi_5182_ = type_28(1u, _e1848.member);
                                            } else {
                                                phi_5157_ = _e1848;
                                                phi_5182_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1864 = phi_5157_;
                                            let _e1866 = phi_5182_;
                                            if (bitcast<i32>(_e1866.member) != 0i) {
                                                if (_e1866.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1874 = local_6[_e1866.member_1].member;
                                                let _e1877 = local_6[_e1866.member_1].member_1;
                                                let _e1879 = (_e1874 < -(_e1877));
                                                if _e1879 {
                                                    phi_5209_ = bool();
                                                    phi_5210_ = false;
                                                } else {
                                                    phi_5209_ = (_e1850 && (_e1874 > _e1877));
                                                    phi_5210_ = true;
                                                }
                                                let _e1883 = phi_5209_;
                                                let _e1885 = phi_5210_;
                                                phi_5160_ = _e1883;
                                                phi_5211_ = _e1885;
                                                phi_5212_ = _e1879;
                                            } else {
                                                phi_5160_ = bool();
                                                phi_5211_ = false;
                                                phi_5212_ = false;
                                            }
                                            let _e1887 = phi_5160_;
                                            let _e1889 = phi_5211_;
                                            let _e1891 = phi_5212_;
                                            local_19 = _e1891;
                                            continue;
                                            continuing {
                                                phi_5156_ = _e1864;
                                                phi_5159_ = _e1887;
                                                break if !(_e1889);
                                            }
                                        }
                                        let _e1894 = local_19;
                                        if _e1894 {
                                            phi_5216_ = false;
                                        } else {
                                            phi_5216_ = true;
                                        }
                                        let _e1896 = phi_5216_;
                                        if _e1896 {
                                            let _e1898 = local_20;
                                            if _e1898 {
                                                phi_5223_ = 1u;
                                            } else {
                                                phi_5223_ = 2u;
                                            }
                                            let _e1900 = phi_5223_;
                                            phi_5224_ = _e1900;
                                            phi_5225_ = false;
                                        } else {
                                            phi_5224_ = u32();
                                            phi_5225_ = true;
                                        }
                                        let _e1902 = phi_5224_;
                                        let _e1904 = phi_5225_;
                                        phi_5226_ = _e1902;
                                        phi_5227_ = 0u;
                                        phi_5228_ = _e1904;
                                    } else {
                                        phi_5226_ = u32();
                                        phi_5227_ = 2u;
                                        phi_5228_ = true;
                                    }
                                    let _e1906 = phi_5226_;
                                    let _e1908 = phi_5227_;
                                    let _e1910 = phi_5228_;
                                    if _e1910 {
                                        phi_5232_ = _e1908;
                                    } else {
                                        phi_5232_ = _e1906;
                                    }
                                    let _e1912 = phi_5232_;
                                    let _e1913 = (_e1912 == 0u);
                                    if _e1913 {
                                        phi_6686_ = f32();
                                        phi_6687_ = false;
                                        phi_6688_ = false;
                                        phi_6689_ = false;
                                    } else {
                                        if (_e1912 == 1u) {
                                            if _e1195.member_2 {
                                                if ((_e1195.member_1 - _e1195.member) <= 0.0000005f) {
                                                    phi_5252_ = false;
                                                } else {
                                                    phi_5252_ = true;
                                                }
                                                let _e1921 = phi_5252_;
                                                phi_5253_ = _e1921;
                                            } else {
                                                phi_5253_ = true;
                                            }
                                            let _e1923 = phi_5253_;
                                            phi_5254_ = _e1923;
                                        } else {
                                            phi_5254_ = true;
                                        }
                                        let _e1925 = phi_5254_;
                                        if _e1925 {
                                            let _e1930 = local_15.member[0u];
                                            let _e1936 = local_15.member_1[0u];
                                            let _e1942 = local_15.member_2[0u];
                                            let _e1946 = (_e1930[0] - _e1936[0]);
                                            let _e1947 = (_e1930[1] - _e1936[1]);
                                            let _e1948 = (_e1930[2] - _e1936[2]);
                                            local_1 = array<array<f32, 3>, 4>(_e1930, array<f32, 3>(_e1946, _e1947, _e1948), array<f32, 3>((_e1930[0] - _e1942[0]), (_e1930[1] - _e1942[1]), (_e1930[2] - _e1942[2])), array<f32, 3>((_e1946 - _e1942[0]), (_e1947 - _e1942[1]), (_e1948 - _e1942[2])));
                                            let _e1961 = local_15.member[1u];
                                            let _e1967 = local_15.member_1[1u];
                                            let _e1973 = local_15.member_2[1u];
                                            let _e1977 = (_e1961[0] - _e1967[0]);
                                            let _e1978 = (_e1961[1] - _e1967[1]);
                                            let _e1979 = (_e1961[2] - _e1967[2]);
                                            local_2 = array<array<f32, 3>, 4>(_e1961, array<f32, 3>(_e1977, _e1978, _e1979), array<f32, 3>((_e1961[0] - _e1973[0]), (_e1961[1] - _e1973[1]), (_e1961[2] - _e1973[2])), array<f32, 3>((_e1977 - _e1973[0]), (_e1978 - _e1973[1]), (_e1979 - _e1973[2])));
                                            let _e1992 = local_15.member[0u];
                                            if (_e1992[0] < 0f) {
                                                phi_5450_ = -(_e1992[0]);
                                            } else {
                                                phi_5450_ = _e1992[0];
                                            }
                                            let _e1999 = phi_5450_;
                                            if (_e1992[1] < 0f) {
                                                phi_5457_ = -(_e1992[1]);
                                            } else {
                                                phi_5457_ = _e1992[1];
                                            }
                                            let _e2003 = phi_5457_;
                                            if (_e1999 > _e2003) {
                                                phi_5462_ = _e1999;
                                            } else {
                                                phi_5462_ = _e2003;
                                            }
                                            let _e2006 = phi_5462_;
                                            if (_e1992[2] < 0f) {
                                                phi_5469_ = -(_e1992[2]);
                                            } else {
                                                phi_5469_ = _e1992[2];
                                            }
                                            let _e2010 = phi_5469_;
                                            if (_e2006 > _e2010) {
                                                phi_5474_ = _e2006;
                                            } else {
                                                phi_5474_ = _e2010;
                                            }
                                            let _e2013 = phi_5474_;
                                            let _e2016 = local_15.member[1u];
                                            if (_e2016[0] < 0f) {
                                                phi_5487_ = -(_e2016[0]);
                                            } else {
                                                phi_5487_ = _e2016[0];
                                            }
                                            let _e2023 = phi_5487_;
                                            if (_e2016[1] < 0f) {
                                                phi_5494_ = -(_e2016[1]);
                                            } else {
                                                phi_5494_ = _e2016[1];
                                            }
                                            let _e2027 = phi_5494_;
                                            if (_e2023 > _e2027) {
                                                phi_5499_ = _e2023;
                                            } else {
                                                phi_5499_ = _e2027;
                                            }
                                            let _e2030 = phi_5499_;
                                            if (_e2016[2] < 0f) {
                                                phi_5506_ = -(_e2016[2]);
                                            } else {
                                                phi_5506_ = _e2016[2];
                                            }
                                            let _e2034 = phi_5506_;
                                            if (_e2030 > _e2034) {
                                                phi_5511_ = _e2030;
                                            } else {
                                                phi_5511_ = _e2034;
                                            }
                                            let _e2037 = phi_5511_;
                                            if (_e2013 > _e2037) {
                                                phi_5516_ = _e2013;
                                            } else {
                                                phi_5516_ = _e2037;
                                            }
                                            let _e2040 = phi_5516_;
                                            let _e2042 = local_15.member_3;
                                            let _e2046 = local_15.member_1[0u];
                                            if (_e2046[0] < 0f) {
                                                phi_5533_ = -(_e2046[0]);
                                            } else {
                                                phi_5533_ = _e2046[0];
                                            }
                                            let _e2053 = phi_5533_;
                                            if (_e2046[1] < 0f) {
                                                phi_5540_ = -(_e2046[1]);
                                            } else {
                                                phi_5540_ = _e2046[1];
                                            }
                                            let _e2057 = phi_5540_;
                                            if (_e2053 > _e2057) {
                                                phi_5545_ = _e2053;
                                            } else {
                                                phi_5545_ = _e2057;
                                            }
                                            let _e2060 = phi_5545_;
                                            if (_e2046[2] < 0f) {
                                                phi_5552_ = -(_e2046[2]);
                                            } else {
                                                phi_5552_ = _e2046[2];
                                            }
                                            let _e2064 = phi_5552_;
                                            if (_e2060 > _e2064) {
                                                phi_5557_ = _e2060;
                                            } else {
                                                phi_5557_ = _e2064;
                                            }
                                            let _e2067 = phi_5557_;
                                            let _e2070 = local_15.member_1[1u];
                                            if (_e2070[0] < 0f) {
                                                phi_5571_ = -(_e2070[0]);
                                            } else {
                                                phi_5571_ = _e2070[0];
                                            }
                                            let _e2077 = phi_5571_;
                                            if (_e2070[1] < 0f) {
                                                phi_5578_ = -(_e2070[1]);
                                            } else {
                                                phi_5578_ = _e2070[1];
                                            }
                                            let _e2081 = phi_5578_;
                                            if (_e2077 > _e2081) {
                                                phi_5583_ = _e2077;
                                            } else {
                                                phi_5583_ = _e2081;
                                            }
                                            let _e2084 = phi_5583_;
                                            if (_e2070[2] < 0f) {
                                                phi_5590_ = -(_e2070[2]);
                                            } else {
                                                phi_5590_ = _e2070[2];
                                            }
                                            let _e2088 = phi_5590_;
                                            if (_e2084 > _e2088) {
                                                phi_5595_ = _e2084;
                                            } else {
                                                phi_5595_ = _e2088;
                                            }
                                            let _e2091 = phi_5595_;
                                            if (_e2067 > _e2091) {
                                                phi_5600_ = _e2067;
                                            } else {
                                                phi_5600_ = _e2091;
                                            }
                                            let _e2094 = phi_5600_;
                                            let _e2096 = local_15.member_3;
                                            let _e2100 = local_15.member_2[0u];
                                            if (_e2100[0] < 0f) {
                                                phi_5617_ = -(_e2100[0]);
                                            } else {
                                                phi_5617_ = _e2100[0];
                                            }
                                            let _e2107 = phi_5617_;
                                            if (_e2100[1] < 0f) {
                                                phi_5624_ = -(_e2100[1]);
                                            } else {
                                                phi_5624_ = _e2100[1];
                                            }
                                            let _e2111 = phi_5624_;
                                            if (_e2107 > _e2111) {
                                                phi_5629_ = _e2107;
                                            } else {
                                                phi_5629_ = _e2111;
                                            }
                                            let _e2114 = phi_5629_;
                                            if (_e2100[2] < 0f) {
                                                phi_5636_ = -(_e2100[2]);
                                            } else {
                                                phi_5636_ = _e2100[2];
                                            }
                                            let _e2118 = phi_5636_;
                                            if (_e2114 > _e2118) {
                                                phi_5641_ = _e2114;
                                            } else {
                                                phi_5641_ = _e2118;
                                            }
                                            let _e2121 = phi_5641_;
                                            let _e2124 = local_15.member_2[1u];
                                            if (_e2124[0] < 0f) {
                                                phi_5655_ = -(_e2124[0]);
                                            } else {
                                                phi_5655_ = _e2124[0];
                                            }
                                            let _e2131 = phi_5655_;
                                            if (_e2124[1] < 0f) {
                                                phi_5662_ = -(_e2124[1]);
                                            } else {
                                                phi_5662_ = _e2124[1];
                                            }
                                            let _e2135 = phi_5662_;
                                            if (_e2131 > _e2135) {
                                                phi_5667_ = _e2131;
                                            } else {
                                                phi_5667_ = _e2135;
                                            }
                                            let _e2138 = phi_5667_;
                                            if (_e2124[2] < 0f) {
                                                phi_5674_ = -(_e2124[2]);
                                            } else {
                                                phi_5674_ = _e2124[2];
                                            }
                                            let _e2142 = phi_5674_;
                                            if (_e2138 > _e2142) {
                                                phi_5679_ = _e2138;
                                            } else {
                                                phi_5679_ = _e2142;
                                            }
                                            let _e2145 = phi_5679_;
                                            if (_e2121 > _e2145) {
                                                phi_5684_ = _e2121;
                                            } else {
                                                phi_5684_ = _e2145;
                                            }
                                            let _e2148 = phi_5684_;
                                            let _e2150 = local_15.member_3;
                                            let _e2157 = local_15.member_3;
                                            phi_5700_ = type_28(0u, 48u);
                                            phi_5703_ = _e1195.member;
                                            loop {
                                                let _e2163 = phi_5700_;
                                                let _e2165 = phi_5703_;
                                                local_60 = _e2165;
                                                local_27 = _e2165;
                                                local_28 = _e2165;
                                                local_29 = _e2165;
                                                if (_e2163.member < _e2163.member_1) {
                                                    phi_5701_ = type_28((_e2163.member + 1u), _e2163.member_1);
                                                    phi_5726_ = type_28(1u, _e2163.member);
                                                } else {
                                                    phi_5701_ = _e2163;
                                                    phi_5726_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e2179 = phi_5701_;
                                                let _e2181 = phi_5726_;
                                                if (bitcast<i32>(_e2181.member) != 0i) {
                                                    let _e2187 = local_15.member[0u];
                                                    let _e2193 = local_15.member[1u];
                                                    let _e2203 = (_e2187[0] + ((_e2193[0] - _e2187[0]) * _e2165));
                                                    let _e2204 = (_e2187[1] + ((_e2193[1] - _e2187[1]) * _e2165));
                                                    let _e2205 = (_e2187[2] + ((_e2193[2] - _e2187[2]) * _e2165));
                                                    let _e2208 = local_15.member_1[0u];
                                                    let _e2214 = local_15.member_1[1u];
                                                    let _e2224 = (_e2208[0] + ((_e2214[0] - _e2208[0]) * _e2165));
                                                    let _e2225 = (_e2208[1] + ((_e2214[1] - _e2208[1]) * _e2165));
                                                    let _e2226 = (_e2208[2] + ((_e2214[2] - _e2208[2]) * _e2165));
                                                    let _e2229 = local_15.member_2[0u];
                                                    let _e2235 = local_15.member_2[1u];
                                                    let _e2245 = (_e2229[0] + ((_e2235[0] - _e2229[0]) * _e2165));
                                                    let _e2246 = (_e2229[1] + ((_e2235[1] - _e2229[1]) * _e2165));
                                                    let _e2247 = (_e2229[2] + ((_e2235[2] - _e2229[2]) * _e2165));
                                                    let _e2252 = (((_e2224 * _e2224) + (_e2225 * _e2225)) + (_e2226 * _e2226));
                                                    let _e2257 = (((_e2224 * _e2245) + (_e2225 * _e2246)) + (_e2226 * _e2247));
                                                    let _e2262 = (((_e2245 * _e2245) + (_e2246 * _e2246)) + (_e2247 * _e2247));
                                                    let _e2267 = (((_e2203 * _e2224) + (_e2204 * _e2225)) + (_e2205 * _e2226));
                                                    let _e2272 = (((_e2203 * _e2245) + (_e2204 * _e2246)) + (_e2205 * _e2247));
                                                    let _e2275 = ((_e2252 * _e2262) - (_e2257 * _e2257));
                                                    let _e2279 = (((_e2267 * _e2262) - (_e2272 * _e2257)) / _e2275);
                                                    let _e2283 = (((_e2272 * _e2252) - (_e2267 * _e2257)) / _e2275);
                                                    if (_e2279 >= 0f) {
                                                        if (_e2283 >= 0f) {
                                                            if (_e2279 <= 1f) {
                                                                phi_5880_ = (_e2283 <= 1f);
                                                                phi_5881_ = false;
                                                            } else {
                                                                phi_5880_ = bool();
                                                                phi_5881_ = true;
                                                            }
                                                            let _e2289 = phi_5880_;
                                                            let _e2291 = phi_5881_;
                                                            phi_5882_ = _e2289;
                                                            phi_5883_ = _e2291;
                                                        } else {
                                                            phi_5882_ = bool();
                                                            phi_5883_ = true;
                                                        }
                                                        let _e2293 = phi_5882_;
                                                        let _e2295 = phi_5883_;
                                                        phi_5884_ = _e2293;
                                                        phi_5885_ = _e2295;
                                                    } else {
                                                        phi_5884_ = bool();
                                                        phi_5885_ = true;
                                                    }
                                                    let _e2297 = phi_5884_;
                                                    let _e2299 = phi_5885_;
                                                    if _e2299 {
                                                        phi_5889_ = false;
                                                    } else {
                                                        phi_5889_ = _e2297;
                                                    }
                                                    let _e2301 = phi_5889_;
                                                    if (_e2275 > 0f) {
                                                        if _e2301 {
                                                            phi_5929_ = array<f32, 3>((_e2203 - ((_e2224 * _e2279) + (_e2245 * _e2283))), (_e2204 - ((_e2225 * _e2279) + (_e2246 * _e2283))), (_e2205 - ((_e2226 * _e2279) + (_e2247 * _e2283))));
                                                            phi_5930_ = false;
                                                        } else {
                                                            phi_5929_ = array<f32, 3>();
                                                            phi_5930_ = true;
                                                        }
                                                        let _e2317 = phi_5929_;
                                                        let _e2319 = phi_5930_;
                                                        phi_5931_ = _e2317;
                                                        phi_5932_ = _e2319;
                                                    } else {
                                                        phi_5931_ = array<f32, 3>();
                                                        phi_5932_ = true;
                                                    }
                                                    let _e2321 = phi_5931_;
                                                    let _e2323 = phi_5932_;
                                                    if _e2323 {
                                                        let _e2324 = (_e2203 - _e2224);
                                                        let _e2325 = (_e2204 - _e2225);
                                                        let _e2326 = (_e2205 - _e2226);
                                                        let _e2337 = ((((_e2203 * _e2224) + (_e2204 * _e2225)) + (_e2205 * _e2226)) / (((_e2224 * _e2224) + (_e2225 * _e2225)) + (_e2226 * _e2226)));
                                                        if (_e2337 > 0f) {
                                                            if (_e2337 < 1f) {
                                                                phi_5962_ = _e2337;
                                                            } else {
                                                                phi_5962_ = 1f;
                                                            }
                                                            let _e2341 = phi_5962_;
                                                            phi_5963_ = _e2341;
                                                        } else {
                                                            phi_5963_ = 0f;
                                                        }
                                                        let _e2343 = phi_5963_;
                                                        let _e2360 = ((((_e2203 * _e2245) + (_e2204 * _e2246)) + (_e2205 * _e2247)) / (((_e2245 * _e2245) + (_e2246 * _e2246)) + (_e2247 * _e2247)));
                                                        if (_e2360 > 0f) {
                                                            if (_e2360 < 1f) {
                                                                phi_5990_ = _e2360;
                                                            } else {
                                                                phi_5990_ = 1f;
                                                            }
                                                            let _e2364 = phi_5990_;
                                                            phi_5991_ = _e2364;
                                                        } else {
                                                            phi_5991_ = 0f;
                                                        }
                                                        let _e2366 = phi_5991_;
                                                        let _e2383 = ((((_e2324 * _e2245) + (_e2325 * _e2246)) + (_e2326 * _e2247)) / (((_e2245 * _e2245) + (_e2246 * _e2246)) + (_e2247 * _e2247)));
                                                        if (_e2383 > 0f) {
                                                            if (_e2383 < 1f) {
                                                                phi_6018_ = _e2383;
                                                            } else {
                                                                phi_6018_ = 1f;
                                                            }
                                                            let _e2387 = phi_6018_;
                                                            phi_6019_ = _e2387;
                                                        } else {
                                                            phi_6019_ = 0f;
                                                        }
                                                        let _e2389 = phi_6019_;
                                                        let _e2396 = (_e2203 - _e2245);
                                                        let _e2397 = (_e2204 - _e2246);
                                                        let _e2398 = (_e2205 - _e2247);
                                                        let _e2409 = ((((_e2396 * _e2224) + (_e2397 * _e2225)) + (_e2398 * _e2226)) / (((_e2224 * _e2224) + (_e2225 * _e2225)) + (_e2226 * _e2226)));
                                                        if (_e2409 > 0f) {
                                                            if (_e2409 < 1f) {
                                                                phi_6049_ = _e2409;
                                                            } else {
                                                                phi_6049_ = 1f;
                                                            }
                                                            let _e2413 = phi_6049_;
                                                            phi_6050_ = _e2413;
                                                        } else {
                                                            phi_6050_ = 0f;
                                                        }
                                                        let _e2415 = phi_6050_;
                                                        local[0u] = array<f32, 3>((_e2203 - (_e2224 * _e2343)), (_e2204 - (_e2225 * _e2343)), (_e2205 - (_e2226 * _e2343)));
                                                        local[1u] = array<f32, 3>((_e2203 - (_e2245 * _e2366)), (_e2204 - (_e2246 * _e2366)), (_e2205 - (_e2247 * _e2366)));
                                                        local[2u] = array<f32, 3>((_e2324 - (_e2245 * _e2389)), (_e2325 - (_e2246 * _e2389)), (_e2326 - (_e2247 * _e2389)));
                                                        local[3u] = array<f32, 3>((_e2396 - (_e2224 * _e2415)), (_e2397 - (_e2225 * _e2415)), (_e2398 - (_e2226 * _e2415)));
                                                        let _e2431 = local[0u];
                                                        phi_6193_ = type_28(1u, 4u);
                                                        phi_6196_ = array<f32, 3>(_e2431[0], _e2431[1], _e2431[2]);
                                                        loop {
                                                            let _e2437 = phi_6193_;
                                                            let _e2439 = phi_6196_;
                                                            local_50 = _e2439;
                                                            if (_e2437.member < _e2437.member_1) {
                                                                phi_6194_ = type_28((_e2437.member + 1u), _e2437.member_1);
                                                                phi_6219_ = type_28(1u, _e2437.member);
                                                            } else {
                                                                phi_6194_ = _e2437;
                                                                phi_6219_ = type_28(0u, type_28().member_1);
                                                            }
                                                            let _e2453 = phi_6194_;
                                                            let _e2455 = phi_6219_;
                                                            let _e2459 = (bitcast<i32>(_e2455.member) != 0i);
                                                            if _e2459 {
                                                                if (_e2455.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2462 = local[_e2455.member_1];
                                                                if (_e2455.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2468 = local[_e2455.member_1];
                                                                if ((((_e2462[0] * _e2468[0]) + (_e2462[1] * _e2468[1])) + (_e2462[2] * _e2468[2])) < (((_e2439[0] * _e2439[0]) + (_e2439[1] * _e2439[1])) + (_e2439[2] * _e2439[2]))) {
                                                                    if (_e2455.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2491 = local[_e2455.member_1];
                                                                    phi_6286_ = array<f32, 3>(_e2491[0], _e2491[1], _e2491[2]);
                                                                } else {
                                                                    phi_6286_ = _e2439;
                                                                }
                                                                let _e2497 = phi_6286_;
                                                                phi_6197_ = _e2497;
                                                            } else {
                                                                phi_6197_ = array<f32, 3>();
                                                            }
                                                            let _e2499 = phi_6197_;
                                                            continue;
                                                            continuing {
                                                                phi_6193_ = _e2453;
                                                                phi_6196_ = _e2499;
                                                                break if !(_e2459);
                                                            }
                                                        }
                                                        let _e5040 = local_50;
                                                        phi_6287_ = _e5040;
                                                    } else {
                                                        phi_6287_ = _e2321;
                                                    }
                                                    let _e2502 = phi_6287_;
                                                    if (_e2502[0] < 0f) {
                                                        phi_6294_ = -(_e2502[0]);
                                                    } else {
                                                        phi_6294_ = _e2502[0];
                                                    }
                                                    let _e2507 = phi_6294_;
                                                    if (_e2502[1] < 0f) {
                                                        phi_6301_ = -(_e2502[1]);
                                                    } else {
                                                        phi_6301_ = _e2502[1];
                                                    }
                                                    let _e2512 = phi_6301_;
                                                    if (_e2502[2] < 0f) {
                                                        phi_6309_ = -(_e2502[2]);
                                                    } else {
                                                        phi_6309_ = _e2502[2];
                                                    }
                                                    let _e2518 = phi_6309_;
                                                    let _e2519 = ((_e2507 + _e2512) + _e2518);
                                                    if (_e2519 > 0f) {
                                                        if ((bitcast<u32>(_e2519) & 2139095040u) != 2139095040u) {
                                                            let _e2524 = (1f / _e2519);
                                                            let _e2526 = (_e2502[0] * _e2524);
                                                            let _e2528 = (_e2502[1] * _e2524);
                                                            let _e2530 = (_e2502[2] * _e2524);
                                                            let _e2535 = (((_e2526 * _e2526) + (_e2528 * _e2528)) + (_e2530 * _e2530));
                                                            if (_e2535 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2535 > 0f) {
                                                                    phi_6346_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6346_ = 0f;
                                                                }
                                                                let _e2594 = phi_6346_;
                                                                phi_6410_ = _e2594;
                                                            } else {
                                                                phi_6353_ = type_26(0i, 5i);
                                                                phi_6356_ = bitcast<f32>(((bitcast<u32>(_e2535) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2543 = phi_6353_;
                                                                    let _e2545 = phi_6356_;
                                                                    local_21 = _e2545;
                                                                    if (_e2543.member < _e2543.member_1) {
                                                                        let _e2553 = (_e2543.member + 1i);
                                                                        if ((false == (_e2553 > _e2543.member)) != false) {
                                                                            phi_6377_ = true;
                                                                        } else {
                                                                            phi_6377_ = false;
                                                                        }
                                                                        let _e2558 = phi_6377_;
                                                                        if _e2558 {
                                                                            phi_6383_ = type_27(0u, type_27().member_1);
                                                                        } else {
                                                                            phi_6383_ = type_27(1u, _e2553);
                                                                        }
                                                                        let _e2564 = phi_6383_;
                                                                        if (bitcast<i32>(_e2564.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_6354_ = type_26(_e2564.member_1, _e2543.member_1);
                                                                        phi_6397_ = type_27(1u, _e2543.member);
                                                                    } else {
                                                                        phi_6354_ = _e2543;
                                                                        phi_6397_ = type_27(0u, type_27().member_1);
                                                                    }
                                                                    let _e2574 = phi_6354_;
                                                                    let _e2576 = phi_6397_;
                                                                    let _e2579 = (bitcast<i32>(_e2576.member) != 0i);
                                                                    if _e2579 {
                                                                        phi_6357_ = (0.5f * (_e2545 + (_e2535 / _e2545)));
                                                                    } else {
                                                                        phi_6357_ = f32();
                                                                    }
                                                                    let _e2584 = phi_6357_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6353_ = _e2574;
                                                                        phi_6356_ = _e2584;
                                                                        break if !(_e2579);
                                                                    }
                                                                }
                                                                let _e2589 = local_21;
                                                                phi_6410_ = (_e2589 * (1f + (4f * 0.000000059604645f)));
                                                            }
                                                            let _e2596 = phi_6410_;
                                                            phi_6419_ = type_28(0u, 4u);
                                                            phi_6422_ = 2f;
                                                            loop {
                                                                let _e2604 = phi_6419_;
                                                                let _e2606 = phi_6422_;
                                                                local_23 = _e2606;
                                                                local_24 = _e2606;
                                                                local_25 = _e2606;
                                                                local_51 = _e2606;
                                                                local_52 = _e2606;
                                                                if (_e2604.member < _e2604.member_1) {
                                                                    phi_6420_ = type_28((_e2604.member + 1u), _e2604.member_1);
                                                                    phi_6445_ = type_28(1u, _e2604.member);
                                                                } else {
                                                                    phi_6420_ = _e2604;
                                                                    phi_6445_ = type_28(0u, type_28().member_1);
                                                                }
                                                                let _e2620 = phi_6420_;
                                                                let _e2622 = phi_6445_;
                                                                if (bitcast<i32>(_e2622.member) != 0i) {
                                                                    if (_e2622.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2629 = local_1[_e2622.member_1];
                                                                    let _e2637 = (((_e2526 * _e2629[0]) + (_e2528 * _e2629[1])) + (_e2530 * _e2629[2]));
                                                                    if (_e2622.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2640 = local_2[_e2622.member_1];
                                                                    let _e2648 = (((_e2526 * _e2640[0]) + (_e2528 * _e2640[1])) + (_e2530 * _e2640[2]));
                                                                    if (_e2637 < 0f) {
                                                                        phi_6496_ = -(_e2637);
                                                                    } else {
                                                                        phi_6496_ = _e2637;
                                                                    }
                                                                    let _e2652 = phi_6496_;
                                                                    if (_e2648 < 0f) {
                                                                        phi_6502_ = -(_e2648);
                                                                    } else {
                                                                        phi_6502_ = _e2648;
                                                                    }
                                                                    let _e2656 = phi_6502_;
                                                                    let _e2660 = (((((((((_e2040 + _e2042) + (_e2094 + _e2096)) + (_e2148 + _e2150)) * (0.000000059604645f * 16f)) + (_e2157 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2596) * (1f + (0.000000059604645f * 8f)))) + ((_e2652 + _e2656) * (0.000000059604645f * 8f)));
                                                                    if (_e2637 > _e2660) {
                                                                        if (_e2648 > _e2660) {
                                                                            phi_6515_ = false;
                                                                        } else {
                                                                            phi_6515_ = true;
                                                                        }
                                                                        let _e2664 = phi_6515_;
                                                                        phi_6516_ = _e2664;
                                                                    } else {
                                                                        phi_6516_ = true;
                                                                    }
                                                                    let _e2666 = phi_6516_;
                                                                    if _e2666 {
                                                                        let _e2670 = ((_e2637 + ((_e2648 - _e2637) * _e2165)) > _e2660);
                                                                        if _e2670 {
                                                                            if (_e2648 < _e2637) {
                                                                                let _e2677 = (((_e2637 - _e2660) / (_e2637 - _e2648)) * (1f - (0.000000059604645f * 16f)));
                                                                                if (_e2606 < _e2677) {
                                                                                    phi_6541_ = _e2606;
                                                                                } else {
                                                                                    phi_6541_ = _e2677;
                                                                                }
                                                                                let _e2680 = phi_6541_;
                                                                                phi_6542_ = _e2680;
                                                                            } else {
                                                                                phi_6542_ = _e2606;
                                                                            }
                                                                            let _e2682 = phi_6542_;
                                                                            phi_6543_ = _e2682;
                                                                        } else {
                                                                            phi_6543_ = f32();
                                                                        }
                                                                        let _e2684 = phi_6543_;
                                                                        phi_6544_ = _e2684;
                                                                        phi_6545_ = _e2670;
                                                                    } else {
                                                                        phi_6544_ = _e2606;
                                                                        phi_6545_ = true;
                                                                    }
                                                                    let _e2686 = phi_6544_;
                                                                    let _e2688 = phi_6545_;
                                                                    phi_6423_ = _e2686;
                                                                    phi_6546_ = _e2688;
                                                                    phi_6547_ = false;
                                                                } else {
                                                                    phi_6423_ = f32();
                                                                    phi_6546_ = false;
                                                                    phi_6547_ = true;
                                                                }
                                                                let _e2690 = phi_6423_;
                                                                let _e2692 = phi_6546_;
                                                                let _e2694 = phi_6547_;
                                                                local_22 = _e2694;
                                                                continue;
                                                                continuing {
                                                                    phi_6419_ = _e2620;
                                                                    phi_6422_ = _e2690;
                                                                    break if !(_e2692);
                                                                }
                                                            }
                                                            let _e2697 = local_22;
                                                            if _e2697 {
                                                                let _e2699 = local_23;
                                                                let _e2700 = (_e2699 > _e1195.member_1);
                                                                if _e2700 {
                                                                    phi_6568_ = false;
                                                                    phi_6569_ = false;
                                                                    phi_6570_ = false;
                                                                } else {
                                                                    let _e2702 = local_24;
                                                                    if (_e2702 > _e2165) {
                                                                        let _e2705 = local_25;
                                                                        let _e2707 = ((_e2705 - _e2165) < 0.00000000023283064f);
                                                                        if _e2707 {
                                                                            phi_6564_ = false;
                                                                        } else {
                                                                            phi_6564_ = true;
                                                                        }
                                                                        let _e2709 = phi_6564_;
                                                                        phi_6565_ = _e2709;
                                                                        phi_6566_ = _e2707;
                                                                        phi_6567_ = false;
                                                                    } else {
                                                                        phi_6565_ = false;
                                                                        phi_6566_ = false;
                                                                        phi_6567_ = true;
                                                                    }
                                                                    let _e2711 = phi_6565_;
                                                                    let _e2713 = phi_6566_;
                                                                    let _e2715 = phi_6567_;
                                                                    phi_6568_ = _e2711;
                                                                    phi_6569_ = _e2713;
                                                                    phi_6570_ = _e2715;
                                                                }
                                                                let _e2717 = phi_6568_;
                                                                let _e2719 = phi_6569_;
                                                                let _e2721 = phi_6570_;
                                                                phi_6571_ = _e2717;
                                                                phi_6572_ = _e2700;
                                                                phi_6573_ = _e2719;
                                                                phi_6574_ = _e2721;
                                                                phi_6575_ = false;
                                                            } else {
                                                                phi_6571_ = false;
                                                                phi_6572_ = false;
                                                                phi_6573_ = false;
                                                                phi_6574_ = false;
                                                                phi_6575_ = true;
                                                            }
                                                            let _e2723 = phi_6571_;
                                                            let _e2725 = phi_6572_;
                                                            let _e2727 = phi_6573_;
                                                            let _e2729 = phi_6574_;
                                                            let _e2731 = phi_6575_;
                                                            let _e5088 = local_51;
                                                            phi_6576_ = _e5088;
                                                            let _e5091 = local_52;
                                                            phi_6577_ = _e5091;
                                                            phi_6578_ = _e2723;
                                                            phi_6579_ = _e2725;
                                                            phi_6580_ = _e2727;
                                                            phi_6581_ = _e2729;
                                                            phi_6582_ = _e2731;
                                                            phi_6583_ = false;
                                                        } else {
                                                            phi_6576_ = f32();
                                                            phi_6577_ = f32();
                                                            phi_6578_ = false;
                                                            phi_6579_ = false;
                                                            phi_6580_ = false;
                                                            phi_6581_ = false;
                                                            phi_6582_ = false;
                                                            phi_6583_ = true;
                                                        }
                                                        let _e2733 = phi_6576_;
                                                        let _e2735 = phi_6577_;
                                                        let _e2737 = phi_6578_;
                                                        let _e2739 = phi_6579_;
                                                        let _e2741 = phi_6580_;
                                                        let _e2743 = phi_6581_;
                                                        let _e2745 = phi_6582_;
                                                        let _e2747 = phi_6583_;
                                                        phi_6584_ = _e2733;
                                                        phi_6585_ = _e2735;
                                                        phi_6586_ = _e2737;
                                                        phi_6587_ = _e2739;
                                                        phi_6588_ = _e2741;
                                                        phi_6589_ = _e2743;
                                                        phi_6590_ = _e2745;
                                                        phi_6591_ = _e2747;
                                                        phi_6592_ = false;
                                                    } else {
                                                        phi_6584_ = f32();
                                                        phi_6585_ = f32();
                                                        phi_6586_ = false;
                                                        phi_6587_ = false;
                                                        phi_6588_ = false;
                                                        phi_6589_ = false;
                                                        phi_6590_ = false;
                                                        phi_6591_ = false;
                                                        phi_6592_ = true;
                                                    }
                                                    let _e2749 = phi_6584_;
                                                    let _e2751 = phi_6585_;
                                                    let _e2753 = phi_6586_;
                                                    let _e2755 = phi_6587_;
                                                    let _e2757 = phi_6588_;
                                                    let _e2759 = phi_6589_;
                                                    let _e2761 = phi_6590_;
                                                    let _e2763 = phi_6591_;
                                                    let _e2765 = phi_6592_;
                                                    phi_6593_ = _e2749;
                                                    phi_5704_ = _e2751;
                                                    phi_6594_ = _e2753;
                                                    phi_6595_ = _e2755;
                                                    phi_6596_ = _e2757;
                                                    phi_6597_ = false;
                                                    phi_6598_ = _e2759;
                                                    phi_6599_ = _e2761;
                                                    phi_6600_ = _e2763;
                                                    phi_6601_ = _e2765;
                                                } else {
                                                    phi_6593_ = f32();
                                                    phi_5704_ = f32();
                                                    phi_6594_ = false;
                                                    phi_6595_ = false;
                                                    phi_6596_ = false;
                                                    phi_6597_ = true;
                                                    phi_6598_ = false;
                                                    phi_6599_ = false;
                                                    phi_6600_ = false;
                                                    phi_6601_ = false;
                                                }
                                                let _e2767 = phi_6593_;
                                                let _e2769 = phi_5704_;
                                                let _e2771 = phi_6594_;
                                                let _e2773 = phi_6595_;
                                                let _e2775 = phi_6596_;
                                                let _e2777 = phi_6597_;
                                                let _e2779 = phi_6598_;
                                                let _e2781 = phi_6599_;
                                                let _e2783 = phi_6600_;
                                                let _e2785 = phi_6601_;
                                                local_26 = _e2773;
                                                local_53 = _e2775;
                                                local_54 = _e2777;
                                                local_55 = _e2779;
                                                local_56 = _e2781;
                                                local_57 = _e2783;
                                                local_58 = _e2785;
                                                local_59 = _e2767;
                                                local_61 = _e2773;
                                                continue;
                                                continuing {
                                                    phi_5700_ = _e2179;
                                                    phi_5703_ = _e2769;
                                                    break if !(_e2771);
                                                }
                                            }
                                            let _e2788 = local_26;
                                            if _e2788 {
                                                phi_6606_ = type_55(0u, type_55().member_1);
                                                phi_6607_ = false;
                                                phi_6608_ = false;
                                                phi_6609_ = false;
                                                phi_6610_ = false;
                                                phi_6611_ = false;
                                                phi_6612_ = false;
                                            } else {
                                                phi_6606_ = type_55();
                                                let _e5121 = local_53;
                                                phi_6607_ = _e5121;
                                                let _e5124 = local_54;
                                                phi_6608_ = _e5124;
                                                let _e5127 = local_55;
                                                phi_6609_ = _e5127;
                                                let _e5130 = local_56;
                                                phi_6610_ = _e5130;
                                                let _e5133 = local_57;
                                                phi_6611_ = _e5133;
                                                let _e5136 = local_58;
                                                phi_6612_ = _e5136;
                                            }
                                            let _e2793 = phi_6606_;
                                            let _e2795 = phi_6607_;
                                            let _e2797 = phi_6608_;
                                            let _e2799 = phi_6609_;
                                            let _e2801 = phi_6610_;
                                            let _e2803 = phi_6611_;
                                            let _e2805 = phi_6612_;
                                            if _e2795 {
                                                let _e5139 = local_59;
                                                phi_6616_ = _e5139;
                                                phi_6617_ = true;
                                                phi_6618_ = false;
                                                phi_6619_ = false;
                                                phi_6620_ = false;
                                                phi_6621_ = false;
                                                phi_6622_ = false;
                                            } else {
                                                let _e5141 = local_60;
                                                phi_6616_ = _e5141;
                                                phi_6617_ = _e2797;
                                                phi_6618_ = _e2799;
                                                phi_6619_ = _e2801;
                                                let _e5147 = local_61;
                                                phi_6620_ = _e5147;
                                                phi_6621_ = _e2803;
                                                phi_6622_ = _e2805;
                                            }
                                            let _e2807 = phi_6616_;
                                            let _e2809 = phi_6617_;
                                            let _e2811 = phi_6618_;
                                            let _e2813 = phi_6619_;
                                            let _e2815 = phi_6620_;
                                            let _e2817 = phi_6621_;
                                            let _e2819 = phi_6622_;
                                            if _e2809 {
                                                phi_6627_ = type_55(1u, _e2807);
                                                phi_6628_ = false;
                                                phi_6629_ = false;
                                                phi_6630_ = false;
                                                phi_6631_ = false;
                                                phi_6632_ = false;
                                            } else {
                                                phi_6627_ = type_55();
                                                phi_6628_ = _e2811;
                                                phi_6629_ = _e2813;
                                                phi_6630_ = _e2815;
                                                phi_6631_ = _e2817;
                                                phi_6632_ = _e2819;
                                            }
                                            let _e2822 = phi_6627_;
                                            let _e2824 = phi_6628_;
                                            let _e2826 = phi_6629_;
                                            let _e2828 = phi_6630_;
                                            let _e2830 = phi_6631_;
                                            let _e2832 = phi_6632_;
                                            if _e2824 {
                                                let _e2834 = local_27;
                                                phi_6637_ = type_55(1u, _e2834);
                                                phi_6638_ = false;
                                                phi_6639_ = true;
                                                phi_6640_ = false;
                                                phi_6641_ = false;
                                            } else {
                                                phi_6637_ = _e2793;
                                                phi_6638_ = _e2826;
                                                phi_6639_ = _e2828;
                                                phi_6640_ = _e2830;
                                                phi_6641_ = _e2832;
                                            }
                                            let _e2837 = phi_6637_;
                                            let _e2839 = phi_6638_;
                                            let _e2841 = phi_6639_;
                                            let _e2843 = phi_6640_;
                                            let _e2845 = phi_6641_;
                                            if _e2839 {
                                                let _e2847 = local_28;
                                                phi_6646_ = type_55(1u, _e2847);
                                                phi_6647_ = true;
                                                phi_6648_ = false;
                                                phi_6649_ = false;
                                            } else {
                                                phi_6646_ = _e2837;
                                                phi_6647_ = _e2841;
                                                phi_6648_ = _e2843;
                                                phi_6649_ = _e2845;
                                            }
                                            let _e2850 = phi_6646_;
                                            let _e2852 = phi_6647_;
                                            let _e2854 = phi_6648_;
                                            let _e2856 = phi_6649_;
                                            if _e2852 {
                                                phi_6653_ = false;
                                                phi_6654_ = false;
                                            } else {
                                                phi_6653_ = _e2854;
                                                phi_6654_ = _e2856;
                                            }
                                            let _e2858 = phi_6653_;
                                            let _e2860 = phi_6654_;
                                            if _e2858 {
                                                phi_6658_ = false;
                                                phi_6659_ = false;
                                            } else {
                                                phi_6658_ = _e2860;
                                                phi_6659_ = _e2852;
                                            }
                                            let _e2862 = phi_6658_;
                                            let _e2864 = phi_6659_;
                                            if _e2862 {
                                                phi_6663_ = true;
                                                phi_6664_ = false;
                                            } else {
                                                phi_6663_ = _e2858;
                                                phi_6664_ = _e2864;
                                            }
                                            let _e2866 = phi_6663_;
                                            let _e2868 = phi_6664_;
                                            if _e2866 {
                                                let _e2870 = local_29;
                                                phi_6669_ = type_55(1u, _e2870);
                                                phi_6670_ = true;
                                            } else {
                                                phi_6669_ = _e2850;
                                                phi_6670_ = _e2868;
                                            }
                                            let _e2873 = phi_6669_;
                                            let _e2875 = phi_6670_;
                                            if _e2875 {
                                                phi_6674_ = _e2873;
                                            } else {
                                                phi_6674_ = _e2822;
                                            }
                                            let _e2877 = phi_6674_;
                                            let _e2880 = (_e2877.member != 0u);
                                            if _e2880 {
                                                phi_6681_ = false;
                                            } else {
                                                phi_6681_ = true;
                                            }
                                            let _e2882 = phi_6681_;
                                            phi_6682_ = _e2877.member_1;
                                            phi_6683_ = _e2882;
                                            phi_6684_ = _e2880;
                                            phi_6685_ = false;
                                        } else {
                                            phi_6682_ = f32();
                                            phi_6683_ = false;
                                            phi_6684_ = false;
                                            phi_6685_ = true;
                                        }
                                        let _e2884 = phi_6682_;
                                        let _e2886 = phi_6683_;
                                        let _e2888 = phi_6684_;
                                        let _e2890 = phi_6685_;
                                        phi_6686_ = _e2884;
                                        phi_6687_ = _e2886;
                                        phi_6688_ = _e2888;
                                        phi_6689_ = _e2890;
                                    }
                                    let _e2892 = phi_6686_;
                                    let _e2894 = phi_6687_;
                                    let _e2896 = phi_6688_;
                                    let _e2898 = phi_6689_;
                                    phi_6690_ = _e2892;
                                    phi_6691_ = _e1913;
                                    phi_6692_ = _e2894;
                                    phi_6693_ = _e2896;
                                    phi_6694_ = _e2898;
                                }
                                let _e2900 = phi_6690_;
                                let _e2902 = phi_6691_;
                                let _e2904 = phi_6692_;
                                let _e2906 = phi_6693_;
                                let _e2908 = phi_6694_;
                                if _e2902 {
                                    phi_6698_ = true;
                                    phi_6699_ = false;
                                    phi_6700_ = false;
                                } else {
                                    phi_6698_ = _e2904;
                                    phi_6699_ = _e2906;
                                    phi_6700_ = _e2908;
                                }
                                let _e2910 = phi_6698_;
                                let _e2912 = phi_6699_;
                                let _e2914 = phi_6700_;
                                phi_6701_ = _e2900;
                                phi_6702_ = _e1195;
                                phi_6703_ = _e2910;
                                phi_6704_ = false;
                                phi_6705_ = _e2912;
                                phi_6706_ = _e2914;
                            } else {
                                phi_6701_ = f32();
                                phi_6702_ = type_56();
                                phi_6703_ = false;
                                phi_6704_ = true;
                                phi_6705_ = false;
                                phi_6706_ = false;
                            }
                            let _e2916 = phi_6701_;
                            let _e2918 = phi_6702_;
                            let _e2920 = phi_6703_;
                            let _e2922 = phi_6704_;
                            let _e2924 = phi_6705_;
                            let _e2926 = phi_6706_;
                            local_30 = _e2922;
                            local_62 = _e2924;
                            local_63 = _e2926;
                            local_31 = _e2916;
                            local_32 = _e2918;
                            continue;
                            continuing {
                                phi_3787_ = _e894;
                                break if !(_e2920);
                            }
                        }
                        let _e2929 = local_30;
                        if _e2929 {
                            phi_6711_ = type_55(0u, type_55().member_1);
                            phi_6712_ = false;
                            phi_6713_ = false;
                        } else {
                            phi_6711_ = type_55();
                            let _e5204 = local_62;
                            phi_6712_ = _e5204;
                            let _e5207 = local_63;
                            phi_6713_ = _e5207;
                        }
                        let _e2934 = phi_6711_;
                        let _e2936 = phi_6712_;
                        let _e2938 = phi_6713_;
                        if _e2936 {
                            let _e2940 = local_31;
                            phi_6718_ = type_55(2u, _e2940);
                            phi_6719_ = false;
                        } else {
                            phi_6718_ = type_55();
                            phi_6719_ = _e2938;
                        }
                        let _e2943 = phi_6718_;
                        let _e2945 = phi_6719_;
                        if _e2945 {
                            let _e2947 = local_32;
                            phi_6725_ = type_55(1u, _e2947.member);
                            phi_6726_ = true;
                        } else {
                            phi_6725_ = _e2943;
                            phi_6726_ = _e2936;
                        }
                        let _e2951 = phi_6725_;
                        let _e2953 = phi_6726_;
                        if _e2953 {
                            phi_6730_ = _e2951;
                        } else {
                            phi_6730_ = _e2934;
                        }
                        let _e2955 = phi_6730_;
                        phi_6734_ = _e2955;
                    }
                    let _e4542 = phi_6734_;
                    phi_6735_ = _e4542;
                }
                let _e4547 = phi_6735_;
                switch bitcast<i32>(_e4547.member) {
                    case 0: {
                        phi_6796_ = type_58(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4577 = bitcast<u32>(_e4547.member_1);
                        if (_e4577 < 8388608u) {
                            phi_6763_ = array<u32, 2>();
                            phi_6764_ = true;
                        } else {
                            let _e4581 = ((_e4577 >> bitcast<u32>(31i)) == 1u);
                            if _e4581 {
                                phi_6762_ = array<u32, 2>();
                            } else {
                                phi_6762_ = array<u32, 2>((_e4577 << bitcast<u32>(29i)), ((((_e4577 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e4577 & 8388607u) >> bitcast<u32>(3i))));
                            }
                            let _e4595 = phi_6762_;
                            phi_6763_ = _e4595;
                            phi_6764_ = _e4581;
                        }
                        let _e4597 = phi_6763_;
                        let _e4599 = phi_6764_;
                        if _e4599 {
                            phi_6768_ = array<u32, 2>(0u, 0u);
                        } else {
                            phi_6768_ = _e4597;
                        }
                        let _e4601 = phi_6768_;
                        phi_6796_ = type_58(0u, _e4601, true);
                        break;
                    }
                    case 2: {
                        let _e4551 = bitcast<u32>(_e4547.member_1);
                        if (_e4551 < 8388608u) {
                            phi_6789_ = array<u32, 2>();
                            phi_6790_ = true;
                        } else {
                            let _e4555 = ((_e4551 >> bitcast<u32>(31i)) == 1u);
                            if _e4555 {
                                phi_6788_ = array<u32, 2>();
                            } else {
                                phi_6788_ = array<u32, 2>((_e4551 << bitcast<u32>(29i)), ((((_e4551 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e4551 & 8388607u) >> bitcast<u32>(3i))));
                            }
                            let _e4569 = phi_6788_;
                            phi_6789_ = _e4569;
                            phi_6790_ = _e4555;
                        }
                        let _e4571 = phi_6789_;
                        let _e4573 = phi_6790_;
                        if _e4573 {
                            phi_6794_ = array<u32, 2>(0u, 0u);
                        } else {
                            phi_6794_ = _e4571;
                        }
                        let _e4575 = phi_6794_;
                        phi_6796_ = type_58(1u, _e4575, true);
                        break;
                    }
                    default: {
                        phi_6796_ = type_58();
                        break;
                    }
                }
                let _e4604 = phi_6796_;
                if _e4604.member_2 {
                    phi_6803_ = (_e4604.member == 0u);
                } else {
                    phi_6803_ = false;
                }
                let _e4609 = phi_6803_;
                if _e4609 {
                    let _e4617 = (_e4604.member_1[1] >> bitcast<u32>(20i));
                    if (_e4617 <= 896u) {
                        phi_6827_ = 0u;
                    } else {
                        phi_6827_ = ((((_e4617 - 896u) << bitcast<u32>(23i)) | ((_e4604.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4604.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4632 = phi_6827_;
                    let _e4634 = atomicMin((&earliest.member[0u]), _e4632);
                }
                phi_6831_ = type_48(_e175, 0u, _e181, _e184, _e4604.member_1);
                phi_6832_ = _e4609;
                phi_6833_ = (_e4604.member != 0u);
            } else {
                phi_6831_ = type_48(_e175, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_6832_ = false;
                phi_6833_ = false;
            }
            let _e4636 = phi_6831_;
            let _e4638 = phi_6832_;
            let _e4640 = phi_6833_;
            let _e4642 = params.member.member_1;
            if ((_e4642 & 16u) != 0u) {
                if (_e106 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4638 {
                    let _e4648 = atomicAdd((&counters[0u]), 1u);
                    phi_6851_ = _e4648;
                } else {
                    phi_6851_ = 0u;
                }
                let _e4650 = phi_6851_;
                workgroupBarrier();
                if (_e106 == 0u) {
                    let _e4653 = atomicLoad((&counters[0u]));
                    if (_e4653 > 0u) {
                        let _e4656 = atomicAdd((&contacts.member[0u]), _e4653);
                        atomicStore((&counters[1u]), _e4656);
                    }
                }
                workgroupBarrier();
                let _e4659 = atomicLoad((&counters[1u]));
                let _e4660 = (_e4659 + _e4650);
                if _e4638 {
                    let _e4662 = params.member.member_16;
                    if (_e4660 < _e4662) {
                        let _e4664 = (6u * _e4660);
                        atomicStore((&contacts.member[(4u + _e4664)]), _e4636.member);
                        atomicStore((&contacts.member[(_e4664 + 5u)]), _e4636.member_1);
                        atomicStore((&contacts.member[(_e4664 + 6u)]), _e4636.member_2);
                        atomicStore((&contacts.member[(_e4664 + 7u)]), _e4636.member_3);
                        atomicStore((&contacts.member[(_e4664 + 8u)]), _e4636.member_4[0]);
                        atomicStore((&contacts.member[(_e4664 + 9u)]), _e4636.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e106 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4640 {
                let _e4688 = atomicAdd((&counters[0u]), 1u);
                phi_6913_ = _e4688;
            } else {
                phi_6913_ = 0u;
            }
            let _e4690 = phi_6913_;
            workgroupBarrier();
            if (_e106 == 0u) {
                let _e4693 = atomicLoad((&counters[0u]));
                if (_e4693 > 0u) {
                    let _e4696 = atomicAdd((&undecided.member[0u]), _e4693);
                    atomicStore((&counters[1u]), _e4696);
                }
            }
            workgroupBarrier();
            let _e4699 = atomicLoad((&counters[1u]));
            let _e4700 = (_e4699 + _e4690);
            if _e4640 {
                atomicStore((&undecided.member[(4u + (2u * _e4700))]), _e4636.member_2);
                atomicStore((&undecided.member[((2u * _e4700) + 5u)]), _e4636.member_3);
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
