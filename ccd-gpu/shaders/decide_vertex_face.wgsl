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
@group(0) @binding(3) 
var<storage> input: type_16;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_62;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_62;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_62;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> elements: type_20;

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
    var phi_705_: f32;
    var phi_712_: f32;
    var phi_717_: f32;
    var phi_724_: f32;
    var phi_729_: f32;
    var phi_742_: f32;
    var phi_749_: f32;
    var phi_754_: f32;
    var phi_761_: f32;
    var phi_766_: f32;
    var phi_771_: f32;
    var phi_788_: f32;
    var phi_795_: f32;
    var phi_800_: f32;
    var phi_807_: f32;
    var phi_812_: f32;
    var phi_826_: f32;
    var phi_833_: f32;
    var phi_838_: f32;
    var phi_845_: f32;
    var phi_850_: f32;
    var phi_855_: f32;
    var phi_872_: f32;
    var phi_879_: f32;
    var phi_884_: f32;
    var phi_891_: f32;
    var phi_896_: f32;
    var phi_910_: f32;
    var phi_917_: f32;
    var phi_922_: f32;
    var phi_929_: f32;
    var phi_934_: f32;
    var phi_939_: f32;
    var phi_970_: f32;
    var phi_976_: f32;
    var phi_983_: f32;
    var phi_990_: f32;
    var phi_996_: f32;
    var phi_1003_: f32;
    var phi_1009_: f32;
    var phi_1015_: f32;
    var phi_1021_: f32;
    var phi_1028_: f32;
    var phi_1035_: f32;
    var phi_1059_: f32;
    var phi_1064_: f32;
    var phi_1069_: f32;
    var phi_1074_: f32;
    var phi_1079_: f32;
    var phi_1084_: f32;
    var phi_1094_: f32;
    var phi_3565_: f32;
    var phi_3571_: f32;
    var phi_3576_: f32;
    var phi_3582_: f32;
    var phi_3588_: f32;
    var phi_3593_: f32;
    var phi_3598_: f32;
    var phi_3638_: type_26;
    var phi_3641_: f32;
    var phi_3662_: bool;
    var phi_3668_: type_27;
    var phi_3639_: type_26;
    var phi_3682_: type_27;
    var phi_3642_: f32;
    var local_16: f32;
    var phi_3631_: f32;
    var phi_3695_: f32;
    var phi_3701_: f32;
    var phi_3726_: type_28;
    var phi_3729_: u32;
    var phi_3727_: type_28;
    var phi_3752_: type_28;
    var phi_3796_: u32;
    var phi_3797_: u32;
    var phi_3730_: u32;
    var phi_3798_: u32;
    var phi_3818_: type_28;
    var phi_3819_: type_28;
    var phi_3842_: type_28;
    var phi_3894_: f32;
    var phi_3901_: f32;
    var phi_3921_: bool;
    var phi_3922_: bool;
    var phi_3923_: bool;
    var phi_3924_: bool;
    var phi_3925_: bool;
    var phi_3926_: bool;
    var phi_3927_: bool;
    var phi_3928_: bool;
    var phi_3929_: bool;
    var phi_3930_: bool;
    var phi_3931_: bool;
    var phi_3941_: bool;
    var phi_3942_: bool;
    var phi_3943_: bool;
    var phi_3944_: bool;
    var phi_3949_: type_56;
    var phi_3950_: bool;
    var phi_3961_: f32;
    var phi_3971_: type_28;
    var phi_3974_: f32;
    var phi_3976_: f32;
    var phi_3978_: f32;
    var phi_3972_: type_28;
    var phi_4001_: type_28;
    var phi_4026_: f32;
    var phi_4027_: f32;
    var phi_4053_: f32;
    var phi_4069_: f32;
    var phi_4076_: bool;
    var phi_4077_: bool;
    var phi_4078_: bool;
    var phi_4084_: f32;
    var phi_4085_: f32;
    var phi_4086_: bool;
    var phi_3975_: f32;
    var phi_3977_: f32;
    var phi_3979_: f32;
    var phi_4087_: f32;
    var phi_4088_: bool;
    var phi_4089_: bool;
    var local_17: bool;
    var phi_4093_: f32;
    var phi_4094_: f32;
    var phi_4101_: type_28;
    var phi_4104_: f32;
    var phi_4102_: type_28;
    var phi_4127_: type_28;
    var phi_4168_: f32;
    var phi_4178_: f32;
    var phi_4186_: bool;
    var phi_4188_: bool;
    var phi_4193_: f32;
    var phi_4194_: bool;
    var phi_4195_: f32;
    var phi_4196_: bool;
    var phi_4197_: bool;
    var phi_4198_: bool;
    var phi_4199_: f32;
    var phi_4105_: f32;
    var phi_4200_: bool;
    var phi_4201_: bool;
    var phi_4202_: bool;
    var phi_4203_: bool;
    var local_18: bool;
    var phi_4207_: bool;
    var phi_4208_: bool;
    var phi_4212_: bool;
    var phi_4216_: f32;
    var phi_4217_: f32;
    var phi_4219_: type_56;
    var phi_4248_: f32;
    var phi_4255_: f32;
    var phi_4260_: f32;
    var phi_4267_: f32;
    var phi_4272_: f32;
    var phi_4285_: f32;
    var phi_4292_: f32;
    var phi_4297_: f32;
    var phi_4304_: f32;
    var phi_4309_: f32;
    var phi_4314_: f32;
    var phi_4373_: f32;
    var phi_4379_: f32;
    var phi_4384_: f32;
    var phi_4390_: f32;
    var phi_4395_: f32;
    var phi_4407_: f32;
    var phi_4413_: f32;
    var phi_4418_: f32;
    var phi_4424_: f32;
    var phi_4429_: f32;
    var phi_4455_: f32;
    var phi_4462_: f32;
    var phi_4467_: f32;
    var phi_4474_: f32;
    var phi_4479_: f32;
    var phi_4492_: f32;
    var phi_4499_: f32;
    var phi_4504_: f32;
    var phi_4511_: f32;
    var phi_4516_: f32;
    var phi_4521_: f32;
    var phi_4580_: f32;
    var phi_4586_: f32;
    var phi_4591_: f32;
    var phi_4597_: f32;
    var phi_4602_: f32;
    var phi_4614_: f32;
    var phi_4620_: f32;
    var phi_4625_: f32;
    var phi_4631_: f32;
    var phi_4636_: f32;
    var phi_4662_: f32;
    var phi_4669_: f32;
    var phi_4674_: f32;
    var phi_4681_: f32;
    var phi_4686_: f32;
    var phi_4699_: f32;
    var phi_4706_: f32;
    var phi_4711_: f32;
    var phi_4718_: f32;
    var phi_4723_: f32;
    var phi_4728_: f32;
    var phi_4787_: f32;
    var phi_4793_: f32;
    var phi_4798_: f32;
    var phi_4804_: f32;
    var phi_4809_: f32;
    var phi_4821_: f32;
    var phi_4827_: f32;
    var phi_4832_: f32;
    var phi_4838_: f32;
    var phi_4843_: f32;
    var phi_4892_: f32;
    var phi_4898_: f32;
    var phi_4926_: f32;
    var phi_4932_: f32;
    var phi_4937_: u32;
    var phi_4938_: u32;
    var phi_4908_: f32;
    var phi_4914_: f32;
    var phi_4919_: u32;
    var phi_4920_: u32;
    var phi_4939_: u32;
    var phi_4940_: u32;
    var phi_5007_: f32;
    var phi_5016_: f32;
    var phi_5147_: f32;
    var phi_5153_: f32;
    var phi_5160_: f32;
    var phi_5203_: type_28;
    var phi_5206_: bool;
    var phi_5204_: type_28;
    var phi_5229_: type_28;
    var phi_5256_: bool;
    var phi_5257_: bool;
    var phi_5207_: bool;
    var phi_5258_: bool;
    var phi_5259_: bool;
    var local_19: bool;
    var phi_5263_: bool;
    var local_20: bool;
    var phi_5270_: u32;
    var phi_5271_: u32;
    var phi_5272_: bool;
    var phi_5273_: u32;
    var phi_5274_: u32;
    var phi_5275_: bool;
    var phi_5279_: u32;
    var phi_5299_: bool;
    var phi_5300_: bool;
    var phi_5301_: bool;
    var phi_5497_: f32;
    var phi_5504_: f32;
    var phi_5509_: f32;
    var phi_5516_: f32;
    var phi_5521_: f32;
    var phi_5534_: f32;
    var phi_5541_: f32;
    var phi_5546_: f32;
    var phi_5553_: f32;
    var phi_5558_: f32;
    var phi_5563_: f32;
    var phi_5580_: f32;
    var phi_5587_: f32;
    var phi_5592_: f32;
    var phi_5599_: f32;
    var phi_5604_: f32;
    var phi_5618_: f32;
    var phi_5625_: f32;
    var phi_5630_: f32;
    var phi_5637_: f32;
    var phi_5642_: f32;
    var phi_5647_: f32;
    var phi_5664_: f32;
    var phi_5671_: f32;
    var phi_5676_: f32;
    var phi_5683_: f32;
    var phi_5688_: f32;
    var phi_5702_: f32;
    var phi_5709_: f32;
    var phi_5714_: f32;
    var phi_5721_: f32;
    var phi_5726_: f32;
    var phi_5731_: f32;
    var phi_5747_: type_28;
    var phi_5750_: f32;
    var phi_5748_: type_28;
    var phi_5773_: type_28;
    var phi_5946_: bool;
    var phi_5947_: bool;
    var phi_5948_: bool;
    var phi_5949_: bool;
    var phi_5962_: bool;
    var phi_5963_: bool;
    var phi_5964_: bool;
    var phi_5965_: bool;
    var phi_5989_: array<f32, 3>;
    var phi_5990_: bool;
    var phi_5991_: array<f32, 3>;
    var phi_5992_: bool;
    var phi_5993_: bool;
    var phi_5994_: array<f32, 3>;
    var phi_5995_: bool;
    var phi_5996_: bool;
    var phi_6000_: bool;
    var phi_6168_: f32;
    var phi_6169_: f32;
    var phi_6196_: f32;
    var phi_6197_: f32;
    var phi_6224_: f32;
    var phi_6225_: f32;
    var phi_6261_: type_28;
    var phi_6264_: array<f32, 3>;
    var phi_6262_: type_28;
    var phi_6287_: type_28;
    var phi_6354_: array<f32, 3>;
    var phi_6265_: array<f32, 3>;
    var phi_6355_: array<f32, 3>;
    var phi_6362_: f32;
    var phi_6369_: f32;
    var phi_6377_: f32;
    var phi_6421_: type_26;
    var phi_6424_: f32;
    var phi_6445_: bool;
    var phi_6451_: type_27;
    var phi_6422_: type_26;
    var phi_6465_: type_27;
    var phi_6425_: f32;
    var local_21: f32;
    var phi_6414_: f32;
    var phi_6478_: f32;
    var phi_6487_: type_28;
    var phi_6490_: f32;
    var phi_6488_: type_28;
    var phi_6513_: type_28;
    var phi_6564_: f32;
    var phi_6570_: f32;
    var phi_6583_: bool;
    var phi_6584_: bool;
    var phi_6609_: f32;
    var phi_6610_: f32;
    var phi_6611_: f32;
    var phi_6612_: f32;
    var phi_6613_: bool;
    var phi_6491_: f32;
    var phi_6614_: bool;
    var phi_6615_: bool;
    var local_22: bool;
    var local_23: f32;
    var local_24: f32;
    var local_25: f32;
    var phi_6632_: bool;
    var phi_6633_: bool;
    var phi_6634_: bool;
    var phi_6635_: bool;
    var phi_6636_: bool;
    var phi_6637_: bool;
    var phi_6638_: bool;
    var phi_6639_: bool;
    var phi_6640_: bool;
    var phi_6641_: bool;
    var phi_6642_: bool;
    var phi_6643_: bool;
    var phi_6644_: f32;
    var phi_6645_: f32;
    var phi_6646_: bool;
    var phi_6647_: bool;
    var phi_6648_: bool;
    var phi_6649_: bool;
    var phi_6650_: bool;
    var phi_6651_: bool;
    var phi_6652_: f32;
    var phi_6653_: f32;
    var phi_6654_: bool;
    var phi_6655_: bool;
    var phi_6656_: bool;
    var phi_6657_: bool;
    var phi_6658_: bool;
    var phi_6659_: bool;
    var phi_6660_: bool;
    var phi_6661_: f32;
    var phi_5751_: f32;
    var phi_6662_: bool;
    var phi_6663_: bool;
    var phi_6664_: bool;
    var phi_6665_: bool;
    var phi_6666_: bool;
    var phi_6667_: bool;
    var phi_6668_: bool;
    var phi_6669_: bool;
    var local_26: bool;
    var phi_6674_: type_55;
    var phi_6675_: bool;
    var phi_6676_: bool;
    var phi_6677_: bool;
    var phi_6678_: bool;
    var phi_6679_: bool;
    var phi_6680_: bool;
    var phi_6684_: f32;
    var phi_6685_: bool;
    var phi_6686_: bool;
    var phi_6687_: bool;
    var phi_6688_: bool;
    var phi_6689_: bool;
    var phi_6690_: bool;
    var phi_6695_: type_55;
    var phi_6696_: bool;
    var phi_6697_: bool;
    var phi_6698_: bool;
    var phi_6699_: bool;
    var phi_6700_: bool;
    var local_27: f32;
    var phi_6705_: type_55;
    var phi_6706_: bool;
    var phi_6707_: bool;
    var phi_6708_: bool;
    var phi_6709_: bool;
    var local_28: f32;
    var phi_6714_: type_55;
    var phi_6715_: bool;
    var phi_6716_: bool;
    var phi_6717_: bool;
    var phi_6721_: bool;
    var phi_6722_: bool;
    var phi_6726_: bool;
    var phi_6727_: bool;
    var phi_6731_: bool;
    var phi_6732_: bool;
    var local_29: f32;
    var phi_6737_: type_55;
    var phi_6738_: bool;
    var phi_6742_: type_55;
    var phi_6749_: bool;
    var phi_6750_: f32;
    var phi_6751_: bool;
    var phi_6752_: bool;
    var phi_6753_: bool;
    var phi_6754_: f32;
    var phi_6755_: bool;
    var phi_6756_: bool;
    var phi_6757_: bool;
    var phi_6758_: f32;
    var phi_6759_: bool;
    var phi_6760_: bool;
    var phi_6761_: bool;
    var phi_6762_: bool;
    var phi_6766_: bool;
    var phi_6767_: bool;
    var phi_6768_: bool;
    var phi_6769_: f32;
    var phi_6770_: type_56;
    var phi_6771_: bool;
    var phi_6772_: bool;
    var phi_6773_: bool;
    var phi_6774_: bool;
    var local_30: bool;
    var phi_6779_: type_55;
    var phi_6780_: bool;
    var phi_6781_: bool;
    var local_31: f32;
    var phi_6786_: type_55;
    var phi_6787_: bool;
    var local_32: type_56;
    var phi_6793_: type_55;
    var phi_6794_: bool;
    var phi_6798_: type_55;
    var phi_1295_: f32;
    var phi_1302_: f32;
    var phi_1307_: f32;
    var phi_1314_: f32;
    var phi_1319_: f32;
    var phi_1332_: f32;
    var phi_1339_: f32;
    var phi_1344_: f32;
    var phi_1351_: f32;
    var phi_1356_: f32;
    var phi_1361_: f32;
    var phi_1378_: f32;
    var phi_1385_: f32;
    var phi_1390_: f32;
    var phi_1397_: f32;
    var phi_1402_: f32;
    var phi_1416_: f32;
    var phi_1423_: f32;
    var phi_1428_: f32;
    var phi_1435_: f32;
    var phi_1440_: f32;
    var phi_1445_: f32;
    var phi_1462_: f32;
    var phi_1469_: f32;
    var phi_1474_: f32;
    var phi_1481_: f32;
    var phi_1486_: f32;
    var phi_1500_: f32;
    var phi_1507_: f32;
    var phi_1512_: f32;
    var phi_1519_: f32;
    var phi_1524_: f32;
    var phi_1529_: f32;
    var phi_1545_: type_28;
    var phi_1548_: f32;
    var phi_1546_: type_28;
    var phi_1571_: type_28;
    var phi_1744_: bool;
    var phi_1745_: bool;
    var phi_1746_: bool;
    var phi_1747_: bool;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1787_: array<f32, 3>;
    var phi_1788_: bool;
    var phi_1789_: array<f32, 3>;
    var phi_1790_: bool;
    var phi_1791_: bool;
    var phi_1792_: array<f32, 3>;
    var phi_1793_: bool;
    var phi_1794_: bool;
    var phi_1798_: bool;
    var phi_1966_: f32;
    var phi_1967_: f32;
    var phi_1994_: f32;
    var phi_1995_: f32;
    var phi_2022_: f32;
    var phi_2023_: f32;
    var phi_2059_: type_28;
    var phi_2062_: array<f32, 3>;
    var phi_2060_: type_28;
    var phi_2085_: type_28;
    var phi_2152_: array<f32, 3>;
    var phi_2063_: array<f32, 3>;
    var phi_2153_: array<f32, 3>;
    var phi_2160_: f32;
    var phi_2167_: f32;
    var phi_2175_: f32;
    var phi_2219_: type_26;
    var phi_2222_: f32;
    var phi_2243_: bool;
    var phi_2249_: type_27;
    var phi_2220_: type_26;
    var phi_2263_: type_27;
    var phi_2223_: f32;
    var local_33: f32;
    var phi_2212_: f32;
    var phi_2276_: f32;
    var phi_2285_: type_28;
    var phi_2288_: f32;
    var phi_2286_: type_28;
    var phi_2311_: type_28;
    var phi_2362_: f32;
    var phi_2368_: f32;
    var phi_2381_: bool;
    var phi_2382_: bool;
    var phi_2407_: f32;
    var phi_2408_: f32;
    var phi_2409_: f32;
    var phi_2410_: f32;
    var phi_2411_: bool;
    var phi_2289_: f32;
    var phi_2412_: bool;
    var phi_2413_: bool;
    var local_34: bool;
    var local_35: f32;
    var local_36: f32;
    var local_37: f32;
    var phi_2430_: bool;
    var phi_2431_: bool;
    var phi_2432_: bool;
    var phi_2433_: bool;
    var phi_2434_: bool;
    var phi_2435_: bool;
    var phi_2436_: bool;
    var phi_2437_: bool;
    var phi_2438_: bool;
    var phi_2439_: bool;
    var phi_2440_: bool;
    var phi_2441_: bool;
    var phi_2442_: f32;
    var phi_2443_: f32;
    var phi_2444_: bool;
    var phi_2445_: bool;
    var phi_2446_: bool;
    var phi_2447_: bool;
    var phi_2448_: bool;
    var phi_2449_: bool;
    var phi_2450_: f32;
    var phi_2451_: f32;
    var phi_2452_: bool;
    var phi_2453_: bool;
    var phi_2454_: bool;
    var phi_2455_: bool;
    var phi_2456_: bool;
    var phi_2457_: bool;
    var phi_2458_: bool;
    var phi_2459_: f32;
    var phi_1549_: f32;
    var phi_2460_: bool;
    var phi_2461_: bool;
    var phi_2462_: bool;
    var phi_2463_: bool;
    var phi_2464_: bool;
    var phi_2465_: bool;
    var phi_2466_: bool;
    var phi_2467_: bool;
    var local_38: bool;
    var phi_2472_: type_55;
    var phi_2473_: bool;
    var phi_2474_: bool;
    var phi_2475_: bool;
    var phi_2476_: bool;
    var phi_2477_: bool;
    var phi_2478_: bool;
    var phi_2482_: f32;
    var phi_2483_: bool;
    var phi_2484_: bool;
    var phi_2485_: bool;
    var phi_2486_: bool;
    var phi_2487_: bool;
    var phi_2488_: bool;
    var phi_2493_: type_55;
    var phi_2494_: bool;
    var phi_2495_: bool;
    var phi_2496_: bool;
    var phi_2497_: bool;
    var phi_2498_: bool;
    var local_39: f32;
    var phi_2503_: type_55;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2506_: bool;
    var phi_2507_: bool;
    var local_40: f32;
    var phi_2512_: type_55;
    var phi_2513_: bool;
    var phi_2514_: bool;
    var phi_2515_: bool;
    var phi_2519_: bool;
    var phi_2520_: bool;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var local_41: f32;
    var phi_2535_: type_55;
    var phi_2536_: bool;
    var phi_2540_: type_55;
    var phi_2554_: type_28;
    var phi_2555_: type_28;
    var phi_2578_: type_28;
    var phi_2598_: f32;
    var phi_2765_: bool;
    var phi_2766_: bool;
    var phi_2767_: bool;
    var phi_2768_: bool;
    var phi_2781_: bool;
    var phi_2782_: bool;
    var phi_2783_: bool;
    var phi_2784_: bool;
    var phi_2808_: array<f32, 3>;
    var phi_2809_: bool;
    var phi_2810_: array<f32, 3>;
    var phi_2811_: bool;
    var phi_2812_: bool;
    var phi_2813_: array<f32, 3>;
    var phi_2814_: bool;
    var phi_2815_: bool;
    var phi_2819_: bool;
    var phi_2987_: f32;
    var phi_2988_: f32;
    var phi_3015_: f32;
    var phi_3016_: f32;
    var phi_3043_: f32;
    var phi_3044_: f32;
    var phi_3080_: type_28;
    var phi_3083_: array<f32, 3>;
    var phi_3081_: type_28;
    var phi_3106_: type_28;
    var phi_3173_: array<f32, 3>;
    var phi_3084_: array<f32, 3>;
    var phi_3174_: array<f32, 3>;
    var phi_3206_: type_26;
    var phi_3209_: f32;
    var phi_3230_: bool;
    var phi_3236_: type_27;
    var phi_3207_: type_26;
    var phi_3250_: type_27;
    var phi_3210_: f32;
    var local_42: f32;
    var phi_3199_: f32;
    var phi_3263_: f32;
    var phi_3279_: f32;
    var phi_3286_: f32;
    var phi_3291_: f32;
    var phi_3298_: f32;
    var phi_3303_: f32;
    var phi_3316_: f32;
    var phi_3323_: f32;
    var phi_3328_: f32;
    var phi_3335_: f32;
    var phi_3340_: f32;
    var phi_3345_: f32;
    var phi_3362_: f32;
    var phi_3369_: f32;
    var phi_3374_: f32;
    var phi_3381_: f32;
    var phi_3386_: f32;
    var phi_3400_: f32;
    var phi_3407_: f32;
    var phi_3412_: f32;
    var phi_3419_: f32;
    var phi_3424_: f32;
    var phi_3429_: f32;
    var phi_3446_: f32;
    var phi_3453_: f32;
    var phi_3458_: f32;
    var phi_3465_: f32;
    var phi_3470_: f32;
    var phi_3484_: f32;
    var phi_3491_: f32;
    var phi_3496_: f32;
    var phi_3503_: f32;
    var phi_3508_: f32;
    var phi_3513_: f32;
    var phi_3533_: bool;
    var phi_3534_: bool;
    var phi_3535_: bool;
    var local_43: bool;
    var phi_3540_: type_55;
    var phi_3541_: bool;
    var phi_3546_: type_55;
    var phi_3547_: bool;
    var phi_3549_: type_55;
    var phi_3550_: type_55;
    var phi_3551_: bool;
    var phi_3555_: type_55;
    var phi_6802_: type_55;
    var phi_6803_: type_55;
    var phi_6856_: array<u32, 2>;
    var phi_6857_: array<u32, 2>;
    var phi_6858_: bool;
    var phi_6862_: array<u32, 2>;
    var phi_6830_: array<u32, 2>;
    var phi_6831_: array<u32, 2>;
    var phi_6832_: bool;
    var phi_6836_: array<u32, 2>;
    var phi_6864_: type_58;
    var phi_6871_: bool;
    var phi_6895_: u32;
    var phi_6916_: u32;
    var phi_6997_: type_48;
    var phi_6998_: bool;
    var phi_6999_: type_48;
    var phi_7000_: bool;
    var phi_7001_: bool;
    var phi_7005_: bool;
    var phi_7009_: type_48;
    var phi_7010_: bool;
    var phi_7021_: u32;
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
                let _e199 = elements.member[_e197];
                let _e204 = paths.member[_e194];
                let _e206 = paths.member[_e199[0]];
                let _e212 = paths.member[_e199[1]];
                let _e214 = paths.member[_e199[2]];
                let _e244 = params.member.member_4;
                local_15 = type_45(array<array<f32, 3>, 2>(array<f32, 3>((_e204.member[0] - _e206.member[0]), (_e204.member[1] - _e206.member[1]), (_e204.member[2] - _e206.member[2])), array<f32, 3>((_e204.member_1[0] - _e206.member_1[0]), (_e204.member_1[1] - _e206.member_1[1]), (_e204.member_1[2] - _e206.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e212.member[0] - _e206.member[0]), (_e212.member[1] - _e206.member[1]), (_e212.member[2] - _e206.member[2])), array<f32, 3>((_e212.member_1[0] - _e206.member_1[0]), (_e212.member_1[1] - _e206.member_1[1]), (_e212.member_1[2] - _e206.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e214.member[0] - _e206.member[0]), (_e214.member[1] - _e206.member[1]), (_e214.member[2] - _e206.member[2])), array<f32, 3>((_e214.member_1[0] - _e206.member_1[0]), (_e214.member_1[1] - _e206.member_1[1]), (_e214.member_1[2] - _e206.member_1[2]))), (_e244 + _e244));
                let _e275 = params.member.member_5;
                let _e278 = local_15.member_1[0u];
                let _e284 = local_15.member_2[0u];
                let _e290 = ((_e278[1] * _e284[2]) - (_e278[2] * _e284[1]));
                let _e293 = ((_e278[2] * _e284[0]) - (_e278[0] * _e284[2]));
                let _e296 = ((_e278[0] * _e284[1]) - (_e278[1] * _e284[0]));
                let _e299 = local_15.member_1[1u];
                let _e305 = local_15.member_2[1u];
                let _e311 = ((_e299[1] * _e305[2]) - (_e299[2] * _e305[1]));
                let _e314 = ((_e299[2] * _e305[0]) - (_e299[0] * _e305[2]));
                let _e317 = ((_e299[0] * _e305[1]) - (_e299[1] * _e305[0]));
                let _e320 = local_15.member_1[0u];
                let _e326 = local_15.member_2[1u];
                let _e341 = local_15.member_1[1u];
                let _e347 = local_15.member_2[0u];
                let _e360 = (((_e320[1] * _e326[2]) - (_e320[2] * _e326[1])) + ((_e341[1] * _e347[2]) - (_e341[2] * _e347[1])));
                let _e361 = (((_e320[2] * _e326[0]) - (_e320[0] * _e326[2])) + ((_e341[2] * _e347[0]) - (_e341[0] * _e347[2])));
                let _e362 = (((_e320[0] * _e326[1]) - (_e320[1] * _e326[0])) + ((_e341[0] * _e347[1]) - (_e341[1] * _e347[0])));
                let _e365 = local_15.member[0u];
                let _e373 = (((_e365[0] * _e290) + (_e365[1] * _e293)) + (_e365[2] * _e296));
                let _e376 = local_15.member[1u];
                let _e387 = local_15.member[0u];
                let _e396 = ((((_e376[0] * _e290) + (_e376[1] * _e293)) + (_e376[2] * _e296)) + (((_e387[0] * _e360) + (_e387[1] * _e361)) + (_e387[2] * _e362)));
                let _e399 = local_15.member[0u];
                let _e410 = local_15.member[1u];
                let _e419 = ((((_e399[0] * _e311) + (_e399[1] * _e314)) + (_e399[2] * _e317)) + (((_e410[0] * _e360) + (_e410[1] * _e361)) + (_e410[2] * _e362)));
                let _e422 = local_15.member[1u];
                let _e430 = (((_e422[0] * _e311) + (_e422[1] * _e314)) + (_e422[2] * _e317));
                let _e433 = local_15.member[0u];
                if (_e433[0] < 0f) {
                    phi_705_ = -(_e433[0]);
                } else {
                    phi_705_ = _e433[0];
                }
                let _e440 = phi_705_;
                if (_e433[1] < 0f) {
                    phi_712_ = -(_e433[1]);
                } else {
                    phi_712_ = _e433[1];
                }
                let _e444 = phi_712_;
                if (_e440 > _e444) {
                    phi_717_ = _e440;
                } else {
                    phi_717_ = _e444;
                }
                let _e447 = phi_717_;
                if (_e433[2] < 0f) {
                    phi_724_ = -(_e433[2]);
                } else {
                    phi_724_ = _e433[2];
                }
                let _e451 = phi_724_;
                if (_e447 > _e451) {
                    phi_729_ = _e447;
                } else {
                    phi_729_ = _e451;
                }
                let _e454 = phi_729_;
                let _e457 = local_15.member[1u];
                if (_e457[0] < 0f) {
                    phi_742_ = -(_e457[0]);
                } else {
                    phi_742_ = _e457[0];
                }
                let _e464 = phi_742_;
                if (_e457[1] < 0f) {
                    phi_749_ = -(_e457[1]);
                } else {
                    phi_749_ = _e457[1];
                }
                let _e468 = phi_749_;
                if (_e464 > _e468) {
                    phi_754_ = _e464;
                } else {
                    phi_754_ = _e468;
                }
                let _e471 = phi_754_;
                if (_e457[2] < 0f) {
                    phi_761_ = -(_e457[2]);
                } else {
                    phi_761_ = _e457[2];
                }
                let _e475 = phi_761_;
                if (_e471 > _e475) {
                    phi_766_ = _e471;
                } else {
                    phi_766_ = _e475;
                }
                let _e478 = phi_766_;
                if (_e454 > _e478) {
                    phi_771_ = _e454;
                } else {
                    phi_771_ = _e478;
                }
                let _e481 = phi_771_;
                let _e483 = local_15.member_3;
                let _e484 = (_e481 + _e483);
                let _e487 = local_15.member_1[0u];
                if (_e487[0] < 0f) {
                    phi_788_ = -(_e487[0]);
                } else {
                    phi_788_ = _e487[0];
                }
                let _e494 = phi_788_;
                if (_e487[1] < 0f) {
                    phi_795_ = -(_e487[1]);
                } else {
                    phi_795_ = _e487[1];
                }
                let _e498 = phi_795_;
                if (_e494 > _e498) {
                    phi_800_ = _e494;
                } else {
                    phi_800_ = _e498;
                }
                let _e501 = phi_800_;
                if (_e487[2] < 0f) {
                    phi_807_ = -(_e487[2]);
                } else {
                    phi_807_ = _e487[2];
                }
                let _e505 = phi_807_;
                if (_e501 > _e505) {
                    phi_812_ = _e501;
                } else {
                    phi_812_ = _e505;
                }
                let _e508 = phi_812_;
                let _e511 = local_15.member_1[1u];
                if (_e511[0] < 0f) {
                    phi_826_ = -(_e511[0]);
                } else {
                    phi_826_ = _e511[0];
                }
                let _e518 = phi_826_;
                if (_e511[1] < 0f) {
                    phi_833_ = -(_e511[1]);
                } else {
                    phi_833_ = _e511[1];
                }
                let _e522 = phi_833_;
                if (_e518 > _e522) {
                    phi_838_ = _e518;
                } else {
                    phi_838_ = _e522;
                }
                let _e525 = phi_838_;
                if (_e511[2] < 0f) {
                    phi_845_ = -(_e511[2]);
                } else {
                    phi_845_ = _e511[2];
                }
                let _e529 = phi_845_;
                if (_e525 > _e529) {
                    phi_850_ = _e525;
                } else {
                    phi_850_ = _e529;
                }
                let _e532 = phi_850_;
                if (_e508 > _e532) {
                    phi_855_ = _e508;
                } else {
                    phi_855_ = _e532;
                }
                let _e535 = phi_855_;
                let _e537 = local_15.member_3;
                let _e538 = (_e535 + _e537);
                let _e541 = local_15.member_2[0u];
                if (_e541[0] < 0f) {
                    phi_872_ = -(_e541[0]);
                } else {
                    phi_872_ = _e541[0];
                }
                let _e548 = phi_872_;
                if (_e541[1] < 0f) {
                    phi_879_ = -(_e541[1]);
                } else {
                    phi_879_ = _e541[1];
                }
                let _e552 = phi_879_;
                if (_e548 > _e552) {
                    phi_884_ = _e548;
                } else {
                    phi_884_ = _e552;
                }
                let _e555 = phi_884_;
                if (_e541[2] < 0f) {
                    phi_891_ = -(_e541[2]);
                } else {
                    phi_891_ = _e541[2];
                }
                let _e559 = phi_891_;
                if (_e555 > _e559) {
                    phi_896_ = _e555;
                } else {
                    phi_896_ = _e559;
                }
                let _e562 = phi_896_;
                let _e565 = local_15.member_2[1u];
                if (_e565[0] < 0f) {
                    phi_910_ = -(_e565[0]);
                } else {
                    phi_910_ = _e565[0];
                }
                let _e572 = phi_910_;
                if (_e565[1] < 0f) {
                    phi_917_ = -(_e565[1]);
                } else {
                    phi_917_ = _e565[1];
                }
                let _e576 = phi_917_;
                if (_e572 > _e576) {
                    phi_922_ = _e572;
                } else {
                    phi_922_ = _e576;
                }
                let _e579 = phi_922_;
                if (_e565[2] < 0f) {
                    phi_929_ = -(_e565[2]);
                } else {
                    phi_929_ = _e565[2];
                }
                let _e583 = phi_929_;
                if (_e579 > _e583) {
                    phi_934_ = _e579;
                } else {
                    phi_934_ = _e583;
                }
                let _e586 = phi_934_;
                if (_e562 > _e586) {
                    phi_939_ = _e562;
                } else {
                    phi_939_ = _e586;
                }
                let _e589 = phi_939_;
                let _e591 = local_15.member_3;
                let _e592 = (_e589 + _e591);
                let _e594 = ((_e538 * 8f) * _e592);
                let _e601 = local_15.member_3;
                if (_e290 < 0f) {
                    phi_970_ = -(_e290);
                } else {
                    phi_970_ = _e290;
                }
                let _e618 = phi_970_;
                if (_e293 < 0f) {
                    phi_976_ = -(_e293);
                } else {
                    phi_976_ = _e293;
                }
                let _e622 = phi_976_;
                if (_e296 < 0f) {
                    phi_983_ = -(_e296);
                } else {
                    phi_983_ = _e296;
                }
                let _e627 = phi_983_;
                let _e628 = ((_e618 + _e622) + _e627);
                if (_e311 < 0f) {
                    phi_990_ = -(_e311);
                } else {
                    phi_990_ = _e311;
                }
                let _e632 = phi_990_;
                if (_e314 < 0f) {
                    phi_996_ = -(_e314);
                } else {
                    phi_996_ = _e314;
                }
                let _e636 = phi_996_;
                if (_e317 < 0f) {
                    phi_1003_ = -(_e317);
                } else {
                    phi_1003_ = _e317;
                }
                let _e641 = phi_1003_;
                let _e642 = ((_e632 + _e636) + _e641);
                if (_e628 > _e642) {
                    phi_1009_ = _e628;
                } else {
                    phi_1009_ = _e642;
                }
                let _e645 = phi_1009_;
                if (_e360 < 0f) {
                    phi_1015_ = -(_e360);
                } else {
                    phi_1015_ = _e360;
                }
                let _e649 = phi_1015_;
                if (_e361 < 0f) {
                    phi_1021_ = -(_e361);
                } else {
                    phi_1021_ = _e361;
                }
                let _e653 = phi_1021_;
                if (_e362 < 0f) {
                    phi_1028_ = -(_e362);
                } else {
                    phi_1028_ = _e362;
                }
                let _e658 = phi_1028_;
                let _e660 = (((_e649 + _e653) + _e658) * 0.5f);
                if (_e645 > _e660) {
                    phi_1035_ = _e645;
                } else {
                    phi_1035_ = _e660;
                }
                let _e663 = phi_1035_;
                let _e668 = local_15.member_3;
                let _e680 = (((((_e484 * 8f) * _e594) * (0.000000059604645f * (490f / 64f))) + ((_e601 * 19f) * ((_e484 * (_e538 + _e592)) + (_e538 * _e592)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e484) * ((1f + _e538) * (1f + _e592)))));
                let _e681 = (_e373 * 3f);
                let _e682 = (_e430 * 3f);
                if (_e681 < _e682) {
                    phi_1059_ = _e681;
                } else {
                    phi_1059_ = _e682;
                }
                let _e685 = phi_1059_;
                if (_e396 < _e419) {
                    phi_1064_ = _e396;
                } else {
                    phi_1064_ = _e419;
                }
                let _e688 = phi_1064_;
                if (_e685 < _e688) {
                    phi_1069_ = _e685;
                } else {
                    phi_1069_ = _e688;
                }
                let _e691 = phi_1069_;
                if (_e681 > _e682) {
                    phi_1074_ = _e681;
                } else {
                    phi_1074_ = _e682;
                }
                let _e694 = phi_1074_;
                if (_e396 > _e419) {
                    phi_1079_ = _e396;
                } else {
                    phi_1079_ = _e419;
                }
                let _e697 = phi_1079_;
                if (_e694 > _e697) {
                    phi_1084_ = _e694;
                } else {
                    phi_1084_ = _e697;
                }
                let _e700 = phi_1084_;
                let _e705 = -(_e700);
                if (_e691 > _e705) {
                    phi_1094_ = _e691;
                } else {
                    phi_1094_ = _e705;
                }
                let _e708 = phi_1094_;
                if ((_e708 - (_e680 + ((_e275 * (((_e663 + (_e594 * (0.000000059604645f * 4f))) + ((_e668 * 6f) * (_e538 + _e592))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e538) * (1f + _e592))))) * (3f * 1.0001f)))) > 0f) {
                    phi_6803_ = type_55(0u, type_55().member_1);
                } else {
                    if (_e275 > 0f) {
                        let _e2963 = local_15.member[0u];
                        let _e2969 = local_15.member_1[0u];
                        let _e2975 = local_15.member_2[0u];
                        local_12 = array<array<f32, 3>, 4>(_e2963, array<f32, 3>((_e2963[0] - _e2969[0]), (_e2963[1] - _e2969[1]), (_e2963[2] - _e2969[2])), array<f32, 3>((_e2963[0] - _e2975[0]), (_e2963[1] - _e2975[1]), (_e2963[2] - _e2975[2])), _e2963);
                        let _e2990 = local_15.member[1u];
                        let _e2996 = local_15.member_1[1u];
                        let _e3002 = local_15.member_2[1u];
                        local_13 = array<array<f32, 3>, 4>(_e2990, array<f32, 3>((_e2990[0] - _e2996[0]), (_e2990[1] - _e2996[1]), (_e2990[2] - _e2996[2])), array<f32, 3>((_e2990[0] - _e3002[0]), (_e2990[1] - _e3002[1]), (_e2990[2] - _e3002[2])), _e2990);
                        let _e3017 = local_15.member[0u];
                        if (_e3017[0] < 0f) {
                            phi_1295_ = -(_e3017[0]);
                        } else {
                            phi_1295_ = _e3017[0];
                        }
                        let _e3024 = phi_1295_;
                        if (_e3017[1] < 0f) {
                            phi_1302_ = -(_e3017[1]);
                        } else {
                            phi_1302_ = _e3017[1];
                        }
                        let _e3028 = phi_1302_;
                        if (_e3024 > _e3028) {
                            phi_1307_ = _e3024;
                        } else {
                            phi_1307_ = _e3028;
                        }
                        let _e3031 = phi_1307_;
                        if (_e3017[2] < 0f) {
                            phi_1314_ = -(_e3017[2]);
                        } else {
                            phi_1314_ = _e3017[2];
                        }
                        let _e3035 = phi_1314_;
                        if (_e3031 > _e3035) {
                            phi_1319_ = _e3031;
                        } else {
                            phi_1319_ = _e3035;
                        }
                        let _e3038 = phi_1319_;
                        let _e3041 = local_15.member[1u];
                        if (_e3041[0] < 0f) {
                            phi_1332_ = -(_e3041[0]);
                        } else {
                            phi_1332_ = _e3041[0];
                        }
                        let _e3048 = phi_1332_;
                        if (_e3041[1] < 0f) {
                            phi_1339_ = -(_e3041[1]);
                        } else {
                            phi_1339_ = _e3041[1];
                        }
                        let _e3052 = phi_1339_;
                        if (_e3048 > _e3052) {
                            phi_1344_ = _e3048;
                        } else {
                            phi_1344_ = _e3052;
                        }
                        let _e3055 = phi_1344_;
                        if (_e3041[2] < 0f) {
                            phi_1351_ = -(_e3041[2]);
                        } else {
                            phi_1351_ = _e3041[2];
                        }
                        let _e3059 = phi_1351_;
                        if (_e3055 > _e3059) {
                            phi_1356_ = _e3055;
                        } else {
                            phi_1356_ = _e3059;
                        }
                        let _e3062 = phi_1356_;
                        if (_e3038 > _e3062) {
                            phi_1361_ = _e3038;
                        } else {
                            phi_1361_ = _e3062;
                        }
                        let _e3065 = phi_1361_;
                        let _e3067 = local_15.member_3;
                        let _e3071 = local_15.member_1[0u];
                        if (_e3071[0] < 0f) {
                            phi_1378_ = -(_e3071[0]);
                        } else {
                            phi_1378_ = _e3071[0];
                        }
                        let _e3078 = phi_1378_;
                        if (_e3071[1] < 0f) {
                            phi_1385_ = -(_e3071[1]);
                        } else {
                            phi_1385_ = _e3071[1];
                        }
                        let _e3082 = phi_1385_;
                        if (_e3078 > _e3082) {
                            phi_1390_ = _e3078;
                        } else {
                            phi_1390_ = _e3082;
                        }
                        let _e3085 = phi_1390_;
                        if (_e3071[2] < 0f) {
                            phi_1397_ = -(_e3071[2]);
                        } else {
                            phi_1397_ = _e3071[2];
                        }
                        let _e3089 = phi_1397_;
                        if (_e3085 > _e3089) {
                            phi_1402_ = _e3085;
                        } else {
                            phi_1402_ = _e3089;
                        }
                        let _e3092 = phi_1402_;
                        let _e3095 = local_15.member_1[1u];
                        if (_e3095[0] < 0f) {
                            phi_1416_ = -(_e3095[0]);
                        } else {
                            phi_1416_ = _e3095[0];
                        }
                        let _e3102 = phi_1416_;
                        if (_e3095[1] < 0f) {
                            phi_1423_ = -(_e3095[1]);
                        } else {
                            phi_1423_ = _e3095[1];
                        }
                        let _e3106 = phi_1423_;
                        if (_e3102 > _e3106) {
                            phi_1428_ = _e3102;
                        } else {
                            phi_1428_ = _e3106;
                        }
                        let _e3109 = phi_1428_;
                        if (_e3095[2] < 0f) {
                            phi_1435_ = -(_e3095[2]);
                        } else {
                            phi_1435_ = _e3095[2];
                        }
                        let _e3113 = phi_1435_;
                        if (_e3109 > _e3113) {
                            phi_1440_ = _e3109;
                        } else {
                            phi_1440_ = _e3113;
                        }
                        let _e3116 = phi_1440_;
                        if (_e3092 > _e3116) {
                            phi_1445_ = _e3092;
                        } else {
                            phi_1445_ = _e3116;
                        }
                        let _e3119 = phi_1445_;
                        let _e3121 = local_15.member_3;
                        let _e3125 = local_15.member_2[0u];
                        if (_e3125[0] < 0f) {
                            phi_1462_ = -(_e3125[0]);
                        } else {
                            phi_1462_ = _e3125[0];
                        }
                        let _e3132 = phi_1462_;
                        if (_e3125[1] < 0f) {
                            phi_1469_ = -(_e3125[1]);
                        } else {
                            phi_1469_ = _e3125[1];
                        }
                        let _e3136 = phi_1469_;
                        if (_e3132 > _e3136) {
                            phi_1474_ = _e3132;
                        } else {
                            phi_1474_ = _e3136;
                        }
                        let _e3139 = phi_1474_;
                        if (_e3125[2] < 0f) {
                            phi_1481_ = -(_e3125[2]);
                        } else {
                            phi_1481_ = _e3125[2];
                        }
                        let _e3143 = phi_1481_;
                        if (_e3139 > _e3143) {
                            phi_1486_ = _e3139;
                        } else {
                            phi_1486_ = _e3143;
                        }
                        let _e3146 = phi_1486_;
                        let _e3149 = local_15.member_2[1u];
                        if (_e3149[0] < 0f) {
                            phi_1500_ = -(_e3149[0]);
                        } else {
                            phi_1500_ = _e3149[0];
                        }
                        let _e3156 = phi_1500_;
                        if (_e3149[1] < 0f) {
                            phi_1507_ = -(_e3149[1]);
                        } else {
                            phi_1507_ = _e3149[1];
                        }
                        let _e3160 = phi_1507_;
                        if (_e3156 > _e3160) {
                            phi_1512_ = _e3156;
                        } else {
                            phi_1512_ = _e3160;
                        }
                        let _e3163 = phi_1512_;
                        if (_e3149[2] < 0f) {
                            phi_1519_ = -(_e3149[2]);
                        } else {
                            phi_1519_ = _e3149[2];
                        }
                        let _e3167 = phi_1519_;
                        if (_e3163 > _e3167) {
                            phi_1524_ = _e3163;
                        } else {
                            phi_1524_ = _e3167;
                        }
                        let _e3170 = phi_1524_;
                        if (_e3146 > _e3170) {
                            phi_1529_ = _e3146;
                        } else {
                            phi_1529_ = _e3170;
                        }
                        let _e3173 = phi_1529_;
                        let _e3175 = local_15.member_3;
                        let _e3182 = local_15.member_3;
                        phi_1545_ = type_28(0u, 48u);
                        phi_1548_ = 0f;
                        loop {
                            let _e3188 = phi_1545_;
                            let _e3190 = phi_1548_;
                            local_74 = _e3190;
                            local_39 = _e3190;
                            local_40 = _e3190;
                            local_41 = _e3190;
                            if (_e3188.member < _e3188.member_1) {
                                phi_1546_ = type_28((_e3188.member + 1u), _e3188.member_1);
                                phi_1571_ = type_28(1u, _e3188.member);
                            } else {
                                phi_1546_ = _e3188;
                                phi_1571_ = type_28(0u, type_28().member_1);
                            }
                            let _e3204 = phi_1546_;
                            let _e3206 = phi_1571_;
                            if (bitcast<i32>(_e3206.member) != 0i) {
                                let _e3212 = local_15.member[0u];
                                let _e3218 = local_15.member[1u];
                                let _e3228 = (_e3212[0] + ((_e3218[0] - _e3212[0]) * _e3190));
                                let _e3229 = (_e3212[1] + ((_e3218[1] - _e3212[1]) * _e3190));
                                let _e3230 = (_e3212[2] + ((_e3218[2] - _e3212[2]) * _e3190));
                                let _e3233 = local_15.member_1[0u];
                                let _e3239 = local_15.member_1[1u];
                                let _e3249 = (_e3233[0] + ((_e3239[0] - _e3233[0]) * _e3190));
                                let _e3250 = (_e3233[1] + ((_e3239[1] - _e3233[1]) * _e3190));
                                let _e3251 = (_e3233[2] + ((_e3239[2] - _e3233[2]) * _e3190));
                                let _e3254 = local_15.member_2[0u];
                                let _e3260 = local_15.member_2[1u];
                                let _e3270 = (_e3254[0] + ((_e3260[0] - _e3254[0]) * _e3190));
                                let _e3271 = (_e3254[1] + ((_e3260[1] - _e3254[1]) * _e3190));
                                let _e3272 = (_e3254[2] + ((_e3260[2] - _e3254[2]) * _e3190));
                                let _e3277 = (((_e3249 * _e3249) + (_e3250 * _e3250)) + (_e3251 * _e3251));
                                let _e3282 = (((_e3249 * _e3270) + (_e3250 * _e3271)) + (_e3251 * _e3272));
                                let _e3287 = (((_e3270 * _e3270) + (_e3271 * _e3271)) + (_e3272 * _e3272));
                                let _e3292 = (((_e3228 * _e3249) + (_e3229 * _e3250)) + (_e3230 * _e3251));
                                let _e3297 = (((_e3228 * _e3270) + (_e3229 * _e3271)) + (_e3230 * _e3272));
                                let _e3300 = ((_e3277 * _e3287) - (_e3282 * _e3282));
                                let _e3304 = (((_e3292 * _e3287) - (_e3297 * _e3282)) / _e3300);
                                let _e3308 = (((_e3297 * _e3277) - (_e3292 * _e3282)) / _e3300);
                                if (_e3304 >= 0f) {
                                    if (_e3308 >= 0f) {
                                        phi_1744_ = ((_e3304 + _e3308) <= 1f);
                                        phi_1745_ = false;
                                    } else {
                                        phi_1744_ = bool();
                                        phi_1745_ = true;
                                    }
                                    let _e3314 = phi_1744_;
                                    let _e3316 = phi_1745_;
                                    phi_1746_ = _e3314;
                                    phi_1747_ = _e3316;
                                } else {
                                    phi_1746_ = bool();
                                    phi_1747_ = true;
                                }
                                let _e3318 = phi_1746_;
                                let _e3320 = phi_1747_;
                                if _e3320 {
                                    let _e3321 = (_e3300 > 0f);
                                    if _e3321 {
                                        phi_1760_ = false;
                                    } else {
                                        phi_1760_ = true;
                                    }
                                    let _e3323 = phi_1760_;
                                    phi_1761_ = false;
                                    phi_1762_ = _e3323;
                                    phi_1763_ = _e3321;
                                } else {
                                    phi_1761_ = true;
                                    phi_1762_ = false;
                                    phi_1763_ = false;
                                }
                                let _e3325 = phi_1761_;
                                let _e3327 = phi_1762_;
                                let _e3329 = phi_1763_;
                                if _e3325 {
                                    if (_e3300 > 0f) {
                                        if _e3318 {
                                            phi_1787_ = array<f32, 3>((_e3228 - ((_e3249 * _e3304) + (_e3270 * _e3308))), (_e3229 - ((_e3250 * _e3304) + (_e3271 * _e3308))), (_e3230 - ((_e3251 * _e3304) + (_e3272 * _e3308))));
                                            phi_1788_ = false;
                                        } else {
                                            phi_1787_ = array<f32, 3>();
                                            phi_1788_ = true;
                                        }
                                        let _e3345 = phi_1787_;
                                        let _e3347 = phi_1788_;
                                        phi_1789_ = _e3345;
                                        phi_1790_ = false;
                                        phi_1791_ = _e3347;
                                    } else {
                                        phi_1789_ = array<f32, 3>();
                                        phi_1790_ = true;
                                        phi_1791_ = false;
                                    }
                                    let _e3349 = phi_1789_;
                                    let _e3351 = phi_1790_;
                                    let _e3353 = phi_1791_;
                                    phi_1792_ = _e3349;
                                    phi_1793_ = _e3351;
                                    phi_1794_ = _e3353;
                                } else {
                                    phi_1792_ = array<f32, 3>();
                                    phi_1793_ = _e3327;
                                    phi_1794_ = _e3329;
                                }
                                let _e3355 = phi_1792_;
                                let _e3357 = phi_1793_;
                                let _e3359 = phi_1794_;
                                if _e3357 {
                                    phi_1798_ = true;
                                } else {
                                    phi_1798_ = _e3359;
                                }
                                let _e3361 = phi_1798_;
                                if _e3361 {
                                    let _e3362 = (_e3228 - _e3249);
                                    let _e3363 = (_e3229 - _e3250);
                                    let _e3364 = (_e3230 - _e3251);
                                    let _e3365 = (_e3270 - _e3249);
                                    let _e3366 = (_e3271 - _e3250);
                                    let _e3367 = (_e3272 - _e3251);
                                    let _e3378 = ((((_e3362 * _e3365) + (_e3363 * _e3366)) + (_e3364 * _e3367)) / (((_e3365 * _e3365) + (_e3366 * _e3366)) + (_e3367 * _e3367)));
                                    if (_e3378 > 0f) {
                                        if (_e3378 < 1f) {
                                            phi_1966_ = _e3378;
                                        } else {
                                            phi_1966_ = 1f;
                                        }
                                        let _e3382 = phi_1966_;
                                        phi_1967_ = _e3382;
                                    } else {
                                        phi_1967_ = 0f;
                                    }
                                    let _e3384 = phi_1967_;
                                    let _e3388 = (_e3362 - (_e3365 * _e3384));
                                    let _e3389 = (_e3363 - (_e3366 * _e3384));
                                    let _e3390 = (_e3364 - (_e3367 * _e3384));
                                    let _e3401 = ((((_e3228 * _e3249) + (_e3229 * _e3250)) + (_e3230 * _e3251)) / (((_e3249 * _e3249) + (_e3250 * _e3250)) + (_e3251 * _e3251)));
                                    if (_e3401 > 0f) {
                                        if (_e3401 < 1f) {
                                            phi_1994_ = _e3401;
                                        } else {
                                            phi_1994_ = 1f;
                                        }
                                        let _e3405 = phi_1994_;
                                        phi_1995_ = _e3405;
                                    } else {
                                        phi_1995_ = 0f;
                                    }
                                    let _e3407 = phi_1995_;
                                    let _e3424 = ((((_e3228 * _e3270) + (_e3229 * _e3271)) + (_e3230 * _e3272)) / (((_e3270 * _e3270) + (_e3271 * _e3271)) + (_e3272 * _e3272)));
                                    if (_e3424 > 0f) {
                                        if (_e3424 < 1f) {
                                            phi_2022_ = _e3424;
                                        } else {
                                            phi_2022_ = 1f;
                                        }
                                        let _e3428 = phi_2022_;
                                        phi_2023_ = _e3428;
                                    } else {
                                        phi_2023_ = 0f;
                                    }
                                    let _e3430 = phi_2023_;
                                    local_11[0u] = array<f32, 3>((_e3228 - (_e3249 * _e3407)), (_e3229 - (_e3250 * _e3407)), (_e3230 - (_e3251 * _e3407)));
                                    local_11[1u] = array<f32, 3>((_e3228 - (_e3270 * _e3430)), (_e3229 - (_e3271 * _e3430)), (_e3230 - (_e3272 * _e3430)));
                                    local_11[2u] = array<f32, 3>(_e3388, _e3389, _e3390);
                                    local_11[3u] = array<f32, 3>(_e3388, _e3389, _e3390);
                                    let _e3446 = local_11[0u];
                                    phi_2059_ = type_28(1u, 4u);
                                    phi_2062_ = array<f32, 3>(_e3446[0], _e3446[1], _e3446[2]);
                                    loop {
                                        let _e3452 = phi_2059_;
                                        let _e3454 = phi_2062_;
                                        local_64 = _e3454;
                                        if (_e3452.member < _e3452.member_1) {
                                            phi_2060_ = type_28((_e3452.member + 1u), _e3452.member_1);
                                            phi_2085_ = type_28(1u, _e3452.member);
                                        } else {
                                            phi_2060_ = _e3452;
                                            phi_2085_ = type_28(0u, type_28().member_1);
                                        }
                                        let _e3468 = phi_2060_;
                                        let _e3470 = phi_2085_;
                                        let _e3474 = (bitcast<i32>(_e3470.member) != 0i);
                                        if _e3474 {
                                            if (_e3470.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3477 = local_11[_e3470.member_1];
                                            if (_e3470.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3483 = local_11[_e3470.member_1];
                                            if ((((_e3477[0] * _e3483[0]) + (_e3477[1] * _e3483[1])) + (_e3477[2] * _e3483[2])) < (((_e3454[0] * _e3454[0]) + (_e3454[1] * _e3454[1])) + (_e3454[2] * _e3454[2]))) {
                                                if (_e3470.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3506 = local_11[_e3470.member_1];
                                                phi_2152_ = array<f32, 3>(_e3506[0], _e3506[1], _e3506[2]);
                                            } else {
                                                phi_2152_ = _e3454;
                                            }
                                            let _e3512 = phi_2152_;
                                            phi_2063_ = _e3512;
                                        } else {
                                            phi_2063_ = array<f32, 3>();
                                        }
                                        let _e3514 = phi_2063_;
                                        continue;
                                        continuing {
                                            phi_2059_ = _e3468;
                                            phi_2062_ = _e3514;
                                            break if !(_e3474);
                                        }
                                    }
                                    let _e5275 = local_64;
                                    phi_2153_ = _e5275;
                                } else {
                                    phi_2153_ = _e3355;
                                }
                                let _e3517 = phi_2153_;
                                if (_e3517[0] < 0f) {
                                    phi_2160_ = -(_e3517[0]);
                                } else {
                                    phi_2160_ = _e3517[0];
                                }
                                let _e3522 = phi_2160_;
                                if (_e3517[1] < 0f) {
                                    phi_2167_ = -(_e3517[1]);
                                } else {
                                    phi_2167_ = _e3517[1];
                                }
                                let _e3527 = phi_2167_;
                                if (_e3517[2] < 0f) {
                                    phi_2175_ = -(_e3517[2]);
                                } else {
                                    phi_2175_ = _e3517[2];
                                }
                                let _e3533 = phi_2175_;
                                let _e3534 = ((_e3522 + _e3527) + _e3533);
                                if (_e3534 > 0f) {
                                    if ((bitcast<u32>(_e3534) & 2139095040u) != 2139095040u) {
                                        let _e3539 = (1f / _e3534);
                                        let _e3541 = (_e3517[0] * _e3539);
                                        let _e3543 = (_e3517[1] * _e3539);
                                        let _e3545 = (_e3517[2] * _e3539);
                                        let _e3550 = (((_e3541 * _e3541) + (_e3543 * _e3543)) + (_e3545 * _e3545));
                                        if (_e3550 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3550 > 0f) {
                                                phi_2212_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2212_ = 0f;
                                            }
                                            let _e3609 = phi_2212_;
                                            phi_2276_ = _e3609;
                                        } else {
                                            phi_2219_ = type_26(0i, 5i);
                                            phi_2222_ = bitcast<f32>(((bitcast<u32>(_e3550) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3558 = phi_2219_;
                                                let _e3560 = phi_2222_;
                                                local_33 = _e3560;
                                                if (_e3558.member < _e3558.member_1) {
                                                    let _e3568 = (_e3558.member + 1i);
                                                    if ((false == (_e3568 > _e3558.member)) != false) {
                                                        phi_2243_ = true;
                                                    } else {
                                                        phi_2243_ = false;
                                                    }
                                                    let _e3573 = phi_2243_;
                                                    if _e3573 {
                                                        phi_2249_ = type_27(0u, type_27().member_1);
                                                    } else {
                                                        phi_2249_ = type_27(1u, _e3568);
                                                    }
                                                    let _e3579 = phi_2249_;
                                                    if (bitcast<i32>(_e3579.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2220_ = type_26(_e3579.member_1, _e3558.member_1);
                                                    phi_2263_ = type_27(1u, _e3558.member);
                                                } else {
                                                    phi_2220_ = _e3558;
                                                    phi_2263_ = type_27(0u, type_27().member_1);
                                                }
                                                let _e3589 = phi_2220_;
                                                let _e3591 = phi_2263_;
                                                let _e3594 = (bitcast<i32>(_e3591.member) != 0i);
                                                if _e3594 {
                                                    phi_2223_ = (0.5f * (_e3560 + (_e3550 / _e3560)));
                                                } else {
                                                    phi_2223_ = f32();
                                                }
                                                let _e3599 = phi_2223_;
                                                continue;
                                                continuing {
                                                    phi_2219_ = _e3589;
                                                    phi_2222_ = _e3599;
                                                    break if !(_e3594);
                                                }
                                            }
                                            let _e3604 = local_33;
                                            phi_2276_ = (_e3604 * (1f + (4f * 0.000000059604645f)));
                                        }
                                        let _e3611 = phi_2276_;
                                        phi_2285_ = type_28(0u, 4u);
                                        phi_2288_ = 2f;
                                        loop {
                                            let _e3619 = phi_2285_;
                                            let _e3621 = phi_2288_;
                                            local_35 = _e3621;
                                            local_36 = _e3621;
                                            local_37 = _e3621;
                                            local_65 = _e3621;
                                            local_66 = _e3621;
                                            if (_e3619.member < _e3619.member_1) {
                                                phi_2286_ = type_28((_e3619.member + 1u), _e3619.member_1);
                                                phi_2311_ = type_28(1u, _e3619.member);
                                            } else {
                                                phi_2286_ = _e3619;
                                                phi_2311_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e3635 = phi_2286_;
                                            let _e3637 = phi_2311_;
                                            if (bitcast<i32>(_e3637.member) != 0i) {
                                                if (_e3637.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3644 = local_12[_e3637.member_1];
                                                let _e3652 = (((_e3541 * _e3644[0]) + (_e3543 * _e3644[1])) + (_e3545 * _e3644[2]));
                                                if (_e3637.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3655 = local_13[_e3637.member_1];
                                                let _e3663 = (((_e3541 * _e3655[0]) + (_e3543 * _e3655[1])) + (_e3545 * _e3655[2]));
                                                if (_e3652 < 0f) {
                                                    phi_2362_ = -(_e3652);
                                                } else {
                                                    phi_2362_ = _e3652;
                                                }
                                                let _e3667 = phi_2362_;
                                                if (_e3663 < 0f) {
                                                    phi_2368_ = -(_e3663);
                                                } else {
                                                    phi_2368_ = _e3663;
                                                }
                                                let _e3671 = phi_2368_;
                                                let _e3675 = (((((((((_e3065 + _e3067) + (_e3119 + _e3121)) + (_e3173 + _e3175)) * (0.000000059604645f * 16f)) + (_e3182 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e275 * _e3611) * (1f + (0.000000059604645f * 8f)))) + ((_e3667 + _e3671) * (0.000000059604645f * 8f)));
                                                if (_e3652 > _e3675) {
                                                    if (_e3663 > _e3675) {
                                                        phi_2381_ = false;
                                                    } else {
                                                        phi_2381_ = true;
                                                    }
                                                    let _e3679 = phi_2381_;
                                                    phi_2382_ = _e3679;
                                                } else {
                                                    phi_2382_ = true;
                                                }
                                                let _e3681 = phi_2382_;
                                                if _e3681 {
                                                    let _e3685 = ((_e3652 + ((_e3663 - _e3652) * _e3190)) > _e3675);
                                                    if _e3685 {
                                                        if (_e3663 < _e3652) {
                                                            let _e3692 = (((_e3652 - _e3675) / (_e3652 - _e3663)) * (1f - (0.000000059604645f * 16f)));
                                                            if (_e3621 < _e3692) {
                                                                phi_2407_ = _e3621;
                                                            } else {
                                                                phi_2407_ = _e3692;
                                                            }
                                                            let _e3695 = phi_2407_;
                                                            phi_2408_ = _e3695;
                                                        } else {
                                                            phi_2408_ = _e3621;
                                                        }
                                                        let _e3697 = phi_2408_;
                                                        phi_2409_ = _e3697;
                                                    } else {
                                                        phi_2409_ = f32();
                                                    }
                                                    let _e3699 = phi_2409_;
                                                    phi_2410_ = _e3699;
                                                    phi_2411_ = _e3685;
                                                } else {
                                                    phi_2410_ = _e3621;
                                                    phi_2411_ = true;
                                                }
                                                let _e3701 = phi_2410_;
                                                let _e3703 = phi_2411_;
                                                phi_2289_ = _e3701;
                                                phi_2412_ = _e3703;
                                                phi_2413_ = false;
                                            } else {
                                                phi_2289_ = f32();
                                                phi_2412_ = false;
                                                phi_2413_ = true;
                                            }
                                            let _e3705 = phi_2289_;
                                            let _e3707 = phi_2412_;
                                            let _e3709 = phi_2413_;
                                            local_34 = _e3709;
                                            continue;
                                            continuing {
                                                phi_2285_ = _e3635;
                                                phi_2288_ = _e3705;
                                                break if !(_e3707);
                                            }
                                        }
                                        let _e3712 = local_34;
                                        if _e3712 {
                                            let _e3714 = local_35;
                                            let _e3715 = (_e3714 > 1f);
                                            if _e3715 {
                                                phi_2434_ = false;
                                                phi_2435_ = false;
                                                phi_2436_ = false;
                                            } else {
                                                let _e3717 = local_36;
                                                if (_e3717 > _e3190) {
                                                    let _e3720 = local_37;
                                                    let _e3722 = ((_e3720 - _e3190) < 0.00000000023283064f);
                                                    if _e3722 {
                                                        phi_2430_ = false;
                                                    } else {
                                                        phi_2430_ = true;
                                                    }
                                                    let _e3724 = phi_2430_;
                                                    phi_2431_ = _e3724;
                                                    phi_2432_ = _e3722;
                                                    phi_2433_ = false;
                                                } else {
                                                    phi_2431_ = false;
                                                    phi_2432_ = false;
                                                    phi_2433_ = true;
                                                }
                                                let _e3726 = phi_2431_;
                                                let _e3728 = phi_2432_;
                                                let _e3730 = phi_2433_;
                                                phi_2434_ = _e3726;
                                                phi_2435_ = _e3728;
                                                phi_2436_ = _e3730;
                                            }
                                            let _e3732 = phi_2434_;
                                            let _e3734 = phi_2435_;
                                            let _e3736 = phi_2436_;
                                            phi_2437_ = _e3732;
                                            phi_2438_ = _e3715;
                                            phi_2439_ = _e3734;
                                            phi_2440_ = _e3736;
                                            phi_2441_ = false;
                                        } else {
                                            phi_2437_ = false;
                                            phi_2438_ = false;
                                            phi_2439_ = false;
                                            phi_2440_ = false;
                                            phi_2441_ = true;
                                        }
                                        let _e3738 = phi_2437_;
                                        let _e3740 = phi_2438_;
                                        let _e3742 = phi_2439_;
                                        let _e3744 = phi_2440_;
                                        let _e3746 = phi_2441_;
                                        let _e5323 = local_65;
                                        phi_2442_ = _e5323;
                                        let _e5326 = local_66;
                                        phi_2443_ = _e5326;
                                        phi_2444_ = _e3738;
                                        phi_2445_ = _e3740;
                                        phi_2446_ = _e3742;
                                        phi_2447_ = _e3744;
                                        phi_2448_ = _e3746;
                                        phi_2449_ = false;
                                    } else {
                                        phi_2442_ = f32();
                                        phi_2443_ = f32();
                                        phi_2444_ = false;
                                        phi_2445_ = false;
                                        phi_2446_ = false;
                                        phi_2447_ = false;
                                        phi_2448_ = false;
                                        phi_2449_ = true;
                                    }
                                    let _e3748 = phi_2442_;
                                    let _e3750 = phi_2443_;
                                    let _e3752 = phi_2444_;
                                    let _e3754 = phi_2445_;
                                    let _e3756 = phi_2446_;
                                    let _e3758 = phi_2447_;
                                    let _e3760 = phi_2448_;
                                    let _e3762 = phi_2449_;
                                    phi_2450_ = _e3748;
                                    phi_2451_ = _e3750;
                                    phi_2452_ = _e3752;
                                    phi_2453_ = _e3754;
                                    phi_2454_ = _e3756;
                                    phi_2455_ = _e3758;
                                    phi_2456_ = _e3760;
                                    phi_2457_ = _e3762;
                                    phi_2458_ = false;
                                } else {
                                    phi_2450_ = f32();
                                    phi_2451_ = f32();
                                    phi_2452_ = false;
                                    phi_2453_ = false;
                                    phi_2454_ = false;
                                    phi_2455_ = false;
                                    phi_2456_ = false;
                                    phi_2457_ = false;
                                    phi_2458_ = true;
                                }
                                let _e3764 = phi_2450_;
                                let _e3766 = phi_2451_;
                                let _e3768 = phi_2452_;
                                let _e3770 = phi_2453_;
                                let _e3772 = phi_2454_;
                                let _e3774 = phi_2455_;
                                let _e3776 = phi_2456_;
                                let _e3778 = phi_2457_;
                                let _e3780 = phi_2458_;
                                phi_2459_ = _e3764;
                                phi_1549_ = _e3766;
                                phi_2460_ = _e3768;
                                phi_2461_ = _e3770;
                                phi_2462_ = _e3772;
                                phi_2463_ = false;
                                phi_2464_ = _e3774;
                                phi_2465_ = _e3776;
                                phi_2466_ = _e3778;
                                phi_2467_ = _e3780;
                            } else {
                                phi_2459_ = f32();
                                phi_1549_ = f32();
                                phi_2460_ = false;
                                phi_2461_ = false;
                                phi_2462_ = false;
                                phi_2463_ = true;
                                phi_2464_ = false;
                                phi_2465_ = false;
                                phi_2466_ = false;
                                phi_2467_ = false;
                            }
                            let _e3782 = phi_2459_;
                            let _e3784 = phi_1549_;
                            let _e3786 = phi_2460_;
                            let _e3788 = phi_2461_;
                            let _e3790 = phi_2462_;
                            let _e3792 = phi_2463_;
                            let _e3794 = phi_2464_;
                            let _e3796 = phi_2465_;
                            let _e3798 = phi_2466_;
                            let _e3800 = phi_2467_;
                            local_38 = _e3788;
                            local_67 = _e3790;
                            local_68 = _e3792;
                            local_69 = _e3794;
                            local_70 = _e3796;
                            local_71 = _e3798;
                            local_72 = _e3800;
                            local_73 = _e3782;
                            local_75 = _e3788;
                            continue;
                            continuing {
                                phi_1545_ = _e3204;
                                phi_1548_ = _e3784;
                                break if !(_e3786);
                            }
                        }
                        let _e3803 = local_38;
                        if _e3803 {
                            phi_2472_ = type_55(0u, type_55().member_1);
                            phi_2473_ = false;
                            phi_2474_ = false;
                            phi_2475_ = false;
                            phi_2476_ = false;
                            phi_2477_ = false;
                            phi_2478_ = false;
                        } else {
                            phi_2472_ = type_55();
                            let _e5356 = local_67;
                            phi_2473_ = _e5356;
                            let _e5359 = local_68;
                            phi_2474_ = _e5359;
                            let _e5362 = local_69;
                            phi_2475_ = _e5362;
                            let _e5365 = local_70;
                            phi_2476_ = _e5365;
                            let _e5368 = local_71;
                            phi_2477_ = _e5368;
                            let _e5371 = local_72;
                            phi_2478_ = _e5371;
                        }
                        let _e3808 = phi_2472_;
                        let _e3810 = phi_2473_;
                        let _e3812 = phi_2474_;
                        let _e3814 = phi_2475_;
                        let _e3816 = phi_2476_;
                        let _e3818 = phi_2477_;
                        let _e3820 = phi_2478_;
                        if _e3810 {
                            let _e5374 = local_73;
                            phi_2482_ = _e5374;
                            phi_2483_ = true;
                            phi_2484_ = false;
                            phi_2485_ = false;
                            phi_2486_ = false;
                            phi_2487_ = false;
                            phi_2488_ = false;
                        } else {
                            let _e5376 = local_74;
                            phi_2482_ = _e5376;
                            phi_2483_ = _e3812;
                            phi_2484_ = _e3814;
                            phi_2485_ = _e3816;
                            let _e5382 = local_75;
                            phi_2486_ = _e5382;
                            phi_2487_ = _e3818;
                            phi_2488_ = _e3820;
                        }
                        let _e3822 = phi_2482_;
                        let _e3824 = phi_2483_;
                        let _e3826 = phi_2484_;
                        let _e3828 = phi_2485_;
                        let _e3830 = phi_2486_;
                        let _e3832 = phi_2487_;
                        let _e3834 = phi_2488_;
                        if _e3824 {
                            phi_2493_ = type_55(1u, _e3822);
                            phi_2494_ = false;
                            phi_2495_ = false;
                            phi_2496_ = false;
                            phi_2497_ = false;
                            phi_2498_ = false;
                        } else {
                            phi_2493_ = type_55();
                            phi_2494_ = _e3826;
                            phi_2495_ = _e3828;
                            phi_2496_ = _e3830;
                            phi_2497_ = _e3832;
                            phi_2498_ = _e3834;
                        }
                        let _e3837 = phi_2493_;
                        let _e3839 = phi_2494_;
                        let _e3841 = phi_2495_;
                        let _e3843 = phi_2496_;
                        let _e3845 = phi_2497_;
                        let _e3847 = phi_2498_;
                        if _e3839 {
                            let _e3849 = local_39;
                            phi_2503_ = type_55(1u, _e3849);
                            phi_2504_ = false;
                            phi_2505_ = true;
                            phi_2506_ = false;
                            phi_2507_ = false;
                        } else {
                            phi_2503_ = _e3808;
                            phi_2504_ = _e3841;
                            phi_2505_ = _e3843;
                            phi_2506_ = _e3845;
                            phi_2507_ = _e3847;
                        }
                        let _e3852 = phi_2503_;
                        let _e3854 = phi_2504_;
                        let _e3856 = phi_2505_;
                        let _e3858 = phi_2506_;
                        let _e3860 = phi_2507_;
                        if _e3854 {
                            let _e3862 = local_40;
                            phi_2512_ = type_55(1u, _e3862);
                            phi_2513_ = true;
                            phi_2514_ = false;
                            phi_2515_ = false;
                        } else {
                            phi_2512_ = _e3852;
                            phi_2513_ = _e3856;
                            phi_2514_ = _e3858;
                            phi_2515_ = _e3860;
                        }
                        let _e3865 = phi_2512_;
                        let _e3867 = phi_2513_;
                        let _e3869 = phi_2514_;
                        let _e3871 = phi_2515_;
                        if _e3867 {
                            phi_2519_ = false;
                            phi_2520_ = false;
                        } else {
                            phi_2519_ = _e3869;
                            phi_2520_ = _e3871;
                        }
                        let _e3873 = phi_2519_;
                        let _e3875 = phi_2520_;
                        if _e3873 {
                            phi_2524_ = false;
                            phi_2525_ = false;
                        } else {
                            phi_2524_ = _e3875;
                            phi_2525_ = _e3867;
                        }
                        let _e3877 = phi_2524_;
                        let _e3879 = phi_2525_;
                        if _e3877 {
                            phi_2529_ = true;
                            phi_2530_ = false;
                        } else {
                            phi_2529_ = _e3873;
                            phi_2530_ = _e3879;
                        }
                        let _e3881 = phi_2529_;
                        let _e3883 = phi_2530_;
                        if _e3881 {
                            let _e3885 = local_41;
                            phi_2535_ = type_55(1u, _e3885);
                            phi_2536_ = true;
                        } else {
                            phi_2535_ = _e3865;
                            phi_2536_ = _e3883;
                        }
                        let _e3888 = phi_2535_;
                        let _e3890 = phi_2536_;
                        if _e3890 {
                            phi_2540_ = _e3888;
                        } else {
                            phi_2540_ = _e3837;
                        }
                        let _e3892 = phi_2540_;
                        if (_e3892.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_2554_ = type_28(0u, 3u);
                            loop {
                                let _e3905 = phi_2554_;
                                if (_e3905.member < _e3905.member_1) {
                                    phi_2555_ = type_28((_e3905.member + 1u), _e3905.member_1);
                                    phi_2578_ = type_28(1u, _e3905.member);
                                } else {
                                    phi_2555_ = _e3905;
                                    phi_2578_ = type_28(0u, type_28().member_1);
                                }
                                let _e3919 = phi_2555_;
                                let _e3921 = phi_2578_;
                                if (bitcast<i32>(_e3921.member) != 0i) {
                                    if (_e3921.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e3928 = local_14[_e3921.member_1];
                                    let _e3929 = (_e3892.member_1 + _e3928);
                                    if (_e3929 < 1f) {
                                        phi_2598_ = _e3929;
                                    } else {
                                        phi_2598_ = 1f;
                                    }
                                    let _e3932 = phi_2598_;
                                    let _e3935 = local_15.member[0u];
                                    let _e3941 = local_15.member[1u];
                                    let _e3951 = (_e3935[0] + ((_e3941[0] - _e3935[0]) * _e3932));
                                    let _e3952 = (_e3935[1] + ((_e3941[1] - _e3935[1]) * _e3932));
                                    let _e3953 = (_e3935[2] + ((_e3941[2] - _e3935[2]) * _e3932));
                                    let _e3956 = local_15.member_1[0u];
                                    let _e3962 = local_15.member_1[1u];
                                    let _e3972 = (_e3956[0] + ((_e3962[0] - _e3956[0]) * _e3932));
                                    let _e3973 = (_e3956[1] + ((_e3962[1] - _e3956[1]) * _e3932));
                                    let _e3974 = (_e3956[2] + ((_e3962[2] - _e3956[2]) * _e3932));
                                    let _e3977 = local_15.member_2[0u];
                                    let _e3983 = local_15.member_2[1u];
                                    let _e3993 = (_e3977[0] + ((_e3983[0] - _e3977[0]) * _e3932));
                                    let _e3994 = (_e3977[1] + ((_e3983[1] - _e3977[1]) * _e3932));
                                    let _e3995 = (_e3977[2] + ((_e3983[2] - _e3977[2]) * _e3932));
                                    let _e4000 = (((_e3972 * _e3972) + (_e3973 * _e3973)) + (_e3974 * _e3974));
                                    let _e4005 = (((_e3972 * _e3993) + (_e3973 * _e3994)) + (_e3974 * _e3995));
                                    let _e4010 = (((_e3993 * _e3993) + (_e3994 * _e3994)) + (_e3995 * _e3995));
                                    let _e4015 = (((_e3951 * _e3972) + (_e3952 * _e3973)) + (_e3953 * _e3974));
                                    let _e4020 = (((_e3951 * _e3993) + (_e3952 * _e3994)) + (_e3953 * _e3995));
                                    let _e4023 = ((_e4000 * _e4010) - (_e4005 * _e4005));
                                    let _e4027 = (((_e4015 * _e4010) - (_e4020 * _e4005)) / _e4023);
                                    let _e4031 = (((_e4020 * _e4000) - (_e4015 * _e4005)) / _e4023);
                                    if (_e4027 >= 0f) {
                                        if (_e4031 >= 0f) {
                                            phi_2765_ = ((_e4027 + _e4031) <= 1f);
                                            phi_2766_ = false;
                                        } else {
                                            phi_2765_ = bool();
                                            phi_2766_ = true;
                                        }
                                        let _e4037 = phi_2765_;
                                        let _e4039 = phi_2766_;
                                        phi_2767_ = _e4037;
                                        phi_2768_ = _e4039;
                                    } else {
                                        phi_2767_ = bool();
                                        phi_2768_ = true;
                                    }
                                    let _e4041 = phi_2767_;
                                    let _e4043 = phi_2768_;
                                    if _e4043 {
                                        let _e4044 = (_e4023 > 0f);
                                        if _e4044 {
                                            phi_2781_ = false;
                                        } else {
                                            phi_2781_ = true;
                                        }
                                        let _e4046 = phi_2781_;
                                        phi_2782_ = false;
                                        phi_2783_ = _e4046;
                                        phi_2784_ = _e4044;
                                    } else {
                                        phi_2782_ = true;
                                        phi_2783_ = false;
                                        phi_2784_ = false;
                                    }
                                    let _e4048 = phi_2782_;
                                    let _e4050 = phi_2783_;
                                    let _e4052 = phi_2784_;
                                    if _e4048 {
                                        if (_e4023 > 0f) {
                                            if _e4041 {
                                                phi_2808_ = array<f32, 3>((_e3951 - ((_e3972 * _e4027) + (_e3993 * _e4031))), (_e3952 - ((_e3973 * _e4027) + (_e3994 * _e4031))), (_e3953 - ((_e3974 * _e4027) + (_e3995 * _e4031))));
                                                phi_2809_ = false;
                                            } else {
                                                phi_2808_ = array<f32, 3>();
                                                phi_2809_ = true;
                                            }
                                            let _e4068 = phi_2808_;
                                            let _e4070 = phi_2809_;
                                            phi_2810_ = _e4068;
                                            phi_2811_ = false;
                                            phi_2812_ = _e4070;
                                        } else {
                                            phi_2810_ = array<f32, 3>();
                                            phi_2811_ = true;
                                            phi_2812_ = false;
                                        }
                                        let _e4072 = phi_2810_;
                                        let _e4074 = phi_2811_;
                                        let _e4076 = phi_2812_;
                                        phi_2813_ = _e4072;
                                        phi_2814_ = _e4074;
                                        phi_2815_ = _e4076;
                                    } else {
                                        phi_2813_ = array<f32, 3>();
                                        phi_2814_ = _e4050;
                                        phi_2815_ = _e4052;
                                    }
                                    let _e4078 = phi_2813_;
                                    let _e4080 = phi_2814_;
                                    let _e4082 = phi_2815_;
                                    if _e4080 {
                                        phi_2819_ = true;
                                    } else {
                                        phi_2819_ = _e4082;
                                    }
                                    let _e4084 = phi_2819_;
                                    if _e4084 {
                                        let _e4085 = (_e3951 - _e3972);
                                        let _e4086 = (_e3952 - _e3973);
                                        let _e4087 = (_e3953 - _e3974);
                                        let _e4088 = (_e3993 - _e3972);
                                        let _e4089 = (_e3994 - _e3973);
                                        let _e4090 = (_e3995 - _e3974);
                                        let _e4101 = ((((_e4085 * _e4088) + (_e4086 * _e4089)) + (_e4087 * _e4090)) / (((_e4088 * _e4088) + (_e4089 * _e4089)) + (_e4090 * _e4090)));
                                        if (_e4101 > 0f) {
                                            if (_e4101 < 1f) {
                                                phi_2987_ = _e4101;
                                            } else {
                                                phi_2987_ = 1f;
                                            }
                                            let _e4105 = phi_2987_;
                                            phi_2988_ = _e4105;
                                        } else {
                                            phi_2988_ = 0f;
                                        }
                                        let _e4107 = phi_2988_;
                                        let _e4111 = (_e4085 - (_e4088 * _e4107));
                                        let _e4112 = (_e4086 - (_e4089 * _e4107));
                                        let _e4113 = (_e4087 - (_e4090 * _e4107));
                                        let _e4124 = ((((_e3951 * _e3972) + (_e3952 * _e3973)) + (_e3953 * _e3974)) / (((_e3972 * _e3972) + (_e3973 * _e3973)) + (_e3974 * _e3974)));
                                        if (_e4124 > 0f) {
                                            if (_e4124 < 1f) {
                                                phi_3015_ = _e4124;
                                            } else {
                                                phi_3015_ = 1f;
                                            }
                                            let _e4128 = phi_3015_;
                                            phi_3016_ = _e4128;
                                        } else {
                                            phi_3016_ = 0f;
                                        }
                                        let _e4130 = phi_3016_;
                                        let _e4147 = ((((_e3951 * _e3993) + (_e3952 * _e3994)) + (_e3953 * _e3995)) / (((_e3993 * _e3993) + (_e3994 * _e3994)) + (_e3995 * _e3995)));
                                        if (_e4147 > 0f) {
                                            if (_e4147 < 1f) {
                                                phi_3043_ = _e4147;
                                            } else {
                                                phi_3043_ = 1f;
                                            }
                                            let _e4151 = phi_3043_;
                                            phi_3044_ = _e4151;
                                        } else {
                                            phi_3044_ = 0f;
                                        }
                                        let _e4153 = phi_3044_;
                                        local_10[0u] = array<f32, 3>((_e3951 - (_e3972 * _e4130)), (_e3952 - (_e3973 * _e4130)), (_e3953 - (_e3974 * _e4130)));
                                        local_10[1u] = array<f32, 3>((_e3951 - (_e3993 * _e4153)), (_e3952 - (_e3994 * _e4153)), (_e3953 - (_e3995 * _e4153)));
                                        local_10[2u] = array<f32, 3>(_e4111, _e4112, _e4113);
                                        local_10[3u] = array<f32, 3>(_e4111, _e4112, _e4113);
                                        let _e4169 = local_10[0u];
                                        phi_3080_ = type_28(1u, 4u);
                                        phi_3083_ = array<f32, 3>(_e4169[0], _e4169[1], _e4169[2]);
                                        loop {
                                            let _e4175 = phi_3080_;
                                            let _e4177 = phi_3083_;
                                            local_76 = _e4177;
                                            if (_e4175.member < _e4175.member_1) {
                                                phi_3081_ = type_28((_e4175.member + 1u), _e4175.member_1);
                                                phi_3106_ = type_28(1u, _e4175.member);
                                            } else {
                                                phi_3081_ = _e4175;
                                                phi_3106_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4191 = phi_3081_;
                                            let _e4193 = phi_3106_;
                                            let _e4197 = (bitcast<i32>(_e4193.member) != 0i);
                                            if _e4197 {
                                                if (_e4193.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4200 = local_10[_e4193.member_1];
                                                if (_e4193.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4206 = local_10[_e4193.member_1];
                                                if ((((_e4200[0] * _e4206[0]) + (_e4200[1] * _e4206[1])) + (_e4200[2] * _e4206[2])) < (((_e4177[0] * _e4177[0]) + (_e4177[1] * _e4177[1])) + (_e4177[2] * _e4177[2]))) {
                                                    if (_e4193.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4229 = local_10[_e4193.member_1];
                                                    phi_3173_ = array<f32, 3>(_e4229[0], _e4229[1], _e4229[2]);
                                                } else {
                                                    phi_3173_ = _e4177;
                                                }
                                                let _e4235 = phi_3173_;
                                                phi_3084_ = _e4235;
                                            } else {
                                                phi_3084_ = array<f32, 3>();
                                            }
                                            let _e4237 = phi_3084_;
                                            continue;
                                            continuing {
                                                phi_3080_ = _e4191;
                                                phi_3083_ = _e4237;
                                                break if !(_e4197);
                                            }
                                        }
                                        let _e5447 = local_76;
                                        phi_3174_ = _e5447;
                                    } else {
                                        phi_3174_ = _e4078;
                                    }
                                    let _e4240 = phi_3174_;
                                    let _e4251 = (((_e4240[0] * _e4240[0]) + (_e4240[1] * _e4240[1])) + (_e4240[2] * _e4240[2]));
                                    if (_e4251 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4251 > 0f) {
                                            phi_3199_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3199_ = 0f;
                                        }
                                        let _e4310 = phi_3199_;
                                        phi_3263_ = _e4310;
                                    } else {
                                        phi_3206_ = type_26(0i, 5i);
                                        phi_3209_ = bitcast<f32>(((bitcast<u32>(_e4251) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4259 = phi_3206_;
                                            let _e4261 = phi_3209_;
                                            local_42 = _e4261;
                                            if (_e4259.member < _e4259.member_1) {
                                                let _e4269 = (_e4259.member + 1i);
                                                if ((false == (_e4269 > _e4259.member)) != false) {
                                                    phi_3230_ = true;
                                                } else {
                                                    phi_3230_ = false;
                                                }
                                                let _e4274 = phi_3230_;
                                                if _e4274 {
                                                    phi_3236_ = type_27(0u, type_27().member_1);
                                                } else {
                                                    phi_3236_ = type_27(1u, _e4269);
                                                }
                                                let _e4280 = phi_3236_;
                                                if (bitcast<i32>(_e4280.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3207_ = type_26(_e4280.member_1, _e4259.member_1);
                                                phi_3250_ = type_27(1u, _e4259.member);
                                            } else {
                                                phi_3207_ = _e4259;
                                                phi_3250_ = type_27(0u, type_27().member_1);
                                            }
                                            let _e4290 = phi_3207_;
                                            let _e4292 = phi_3250_;
                                            let _e4295 = (bitcast<i32>(_e4292.member) != 0i);
                                            if _e4295 {
                                                phi_3210_ = (0.5f * (_e4261 + (_e4251 / _e4261)));
                                            } else {
                                                phi_3210_ = f32();
                                            }
                                            let _e4300 = phi_3210_;
                                            continue;
                                            continuing {
                                                phi_3206_ = _e4290;
                                                phi_3209_ = _e4300;
                                                break if !(_e4295);
                                            }
                                        }
                                        let _e4305 = local_42;
                                        phi_3263_ = (_e4305 * (1f + (4f * 0.000000059604645f)));
                                    }
                                    let _e4312 = phi_3263_;
                                    let _e4318 = local_15.member[0u];
                                    if (_e4318[0] < 0f) {
                                        phi_3279_ = -(_e4318[0]);
                                    } else {
                                        phi_3279_ = _e4318[0];
                                    }
                                    let _e4325 = phi_3279_;
                                    if (_e4318[1] < 0f) {
                                        phi_3286_ = -(_e4318[1]);
                                    } else {
                                        phi_3286_ = _e4318[1];
                                    }
                                    let _e4329 = phi_3286_;
                                    if (_e4325 > _e4329) {
                                        phi_3291_ = _e4325;
                                    } else {
                                        phi_3291_ = _e4329;
                                    }
                                    let _e4332 = phi_3291_;
                                    if (_e4318[2] < 0f) {
                                        phi_3298_ = -(_e4318[2]);
                                    } else {
                                        phi_3298_ = _e4318[2];
                                    }
                                    let _e4336 = phi_3298_;
                                    if (_e4332 > _e4336) {
                                        phi_3303_ = _e4332;
                                    } else {
                                        phi_3303_ = _e4336;
                                    }
                                    let _e4339 = phi_3303_;
                                    let _e4342 = local_15.member[1u];
                                    if (_e4342[0] < 0f) {
                                        phi_3316_ = -(_e4342[0]);
                                    } else {
                                        phi_3316_ = _e4342[0];
                                    }
                                    let _e4349 = phi_3316_;
                                    if (_e4342[1] < 0f) {
                                        phi_3323_ = -(_e4342[1]);
                                    } else {
                                        phi_3323_ = _e4342[1];
                                    }
                                    let _e4353 = phi_3323_;
                                    if (_e4349 > _e4353) {
                                        phi_3328_ = _e4349;
                                    } else {
                                        phi_3328_ = _e4353;
                                    }
                                    let _e4356 = phi_3328_;
                                    if (_e4342[2] < 0f) {
                                        phi_3335_ = -(_e4342[2]);
                                    } else {
                                        phi_3335_ = _e4342[2];
                                    }
                                    let _e4360 = phi_3335_;
                                    if (_e4356 > _e4360) {
                                        phi_3340_ = _e4356;
                                    } else {
                                        phi_3340_ = _e4360;
                                    }
                                    let _e4363 = phi_3340_;
                                    if (_e4339 > _e4363) {
                                        phi_3345_ = _e4339;
                                    } else {
                                        phi_3345_ = _e4363;
                                    }
                                    let _e4366 = phi_3345_;
                                    let _e4368 = local_15.member_3;
                                    let _e4372 = local_15.member_1[0u];
                                    if (_e4372[0] < 0f) {
                                        phi_3362_ = -(_e4372[0]);
                                    } else {
                                        phi_3362_ = _e4372[0];
                                    }
                                    let _e4379 = phi_3362_;
                                    if (_e4372[1] < 0f) {
                                        phi_3369_ = -(_e4372[1]);
                                    } else {
                                        phi_3369_ = _e4372[1];
                                    }
                                    let _e4383 = phi_3369_;
                                    if (_e4379 > _e4383) {
                                        phi_3374_ = _e4379;
                                    } else {
                                        phi_3374_ = _e4383;
                                    }
                                    let _e4386 = phi_3374_;
                                    if (_e4372[2] < 0f) {
                                        phi_3381_ = -(_e4372[2]);
                                    } else {
                                        phi_3381_ = _e4372[2];
                                    }
                                    let _e4390 = phi_3381_;
                                    if (_e4386 > _e4390) {
                                        phi_3386_ = _e4386;
                                    } else {
                                        phi_3386_ = _e4390;
                                    }
                                    let _e4393 = phi_3386_;
                                    let _e4396 = local_15.member_1[1u];
                                    if (_e4396[0] < 0f) {
                                        phi_3400_ = -(_e4396[0]);
                                    } else {
                                        phi_3400_ = _e4396[0];
                                    }
                                    let _e4403 = phi_3400_;
                                    if (_e4396[1] < 0f) {
                                        phi_3407_ = -(_e4396[1]);
                                    } else {
                                        phi_3407_ = _e4396[1];
                                    }
                                    let _e4407 = phi_3407_;
                                    if (_e4403 > _e4407) {
                                        phi_3412_ = _e4403;
                                    } else {
                                        phi_3412_ = _e4407;
                                    }
                                    let _e4410 = phi_3412_;
                                    if (_e4396[2] < 0f) {
                                        phi_3419_ = -(_e4396[2]);
                                    } else {
                                        phi_3419_ = _e4396[2];
                                    }
                                    let _e4414 = phi_3419_;
                                    if (_e4410 > _e4414) {
                                        phi_3424_ = _e4410;
                                    } else {
                                        phi_3424_ = _e4414;
                                    }
                                    let _e4417 = phi_3424_;
                                    if (_e4393 > _e4417) {
                                        phi_3429_ = _e4393;
                                    } else {
                                        phi_3429_ = _e4417;
                                    }
                                    let _e4420 = phi_3429_;
                                    let _e4422 = local_15.member_3;
                                    let _e4426 = local_15.member_2[0u];
                                    if (_e4426[0] < 0f) {
                                        phi_3446_ = -(_e4426[0]);
                                    } else {
                                        phi_3446_ = _e4426[0];
                                    }
                                    let _e4433 = phi_3446_;
                                    if (_e4426[1] < 0f) {
                                        phi_3453_ = -(_e4426[1]);
                                    } else {
                                        phi_3453_ = _e4426[1];
                                    }
                                    let _e4437 = phi_3453_;
                                    if (_e4433 > _e4437) {
                                        phi_3458_ = _e4433;
                                    } else {
                                        phi_3458_ = _e4437;
                                    }
                                    let _e4440 = phi_3458_;
                                    if (_e4426[2] < 0f) {
                                        phi_3465_ = -(_e4426[2]);
                                    } else {
                                        phi_3465_ = _e4426[2];
                                    }
                                    let _e4444 = phi_3465_;
                                    if (_e4440 > _e4444) {
                                        phi_3470_ = _e4440;
                                    } else {
                                        phi_3470_ = _e4444;
                                    }
                                    let _e4447 = phi_3470_;
                                    let _e4450 = local_15.member_2[1u];
                                    if (_e4450[0] < 0f) {
                                        phi_3484_ = -(_e4450[0]);
                                    } else {
                                        phi_3484_ = _e4450[0];
                                    }
                                    let _e4457 = phi_3484_;
                                    if (_e4450[1] < 0f) {
                                        phi_3491_ = -(_e4450[1]);
                                    } else {
                                        phi_3491_ = _e4450[1];
                                    }
                                    let _e4461 = phi_3491_;
                                    if (_e4457 > _e4461) {
                                        phi_3496_ = _e4457;
                                    } else {
                                        phi_3496_ = _e4461;
                                    }
                                    let _e4464 = phi_3496_;
                                    if (_e4450[2] < 0f) {
                                        phi_3503_ = -(_e4450[2]);
                                    } else {
                                        phi_3503_ = _e4450[2];
                                    }
                                    let _e4468 = phi_3503_;
                                    if (_e4464 > _e4468) {
                                        phi_3508_ = _e4464;
                                    } else {
                                        phi_3508_ = _e4468;
                                    }
                                    let _e4471 = phi_3508_;
                                    if (_e4447 > _e4471) {
                                        phi_3513_ = _e4447;
                                    } else {
                                        phi_3513_ = _e4471;
                                    }
                                    let _e4474 = phi_3513_;
                                    let _e4476 = local_15.member_3;
                                    let _e4483 = local_15.member_3;
                                    let _e4490 = (((_e4312 * (1f + (0.000000059604645f * 8f))) + (((((((_e4366 + _e4368) + (_e4420 + _e4422)) + (_e4474 + _e4476)) * (0.000000059604645f * 16f)) + (_e4483 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e275);
                                    if _e4490 {
                                        phi_3533_ = false;
                                    } else {
                                        phi_3533_ = true;
                                    }
                                    let _e4492 = phi_3533_;
                                    phi_3534_ = _e4492;
                                    phi_3535_ = _e4490;
                                } else {
                                    phi_3534_ = false;
                                    phi_3535_ = false;
                                }
                                let _e4494 = phi_3534_;
                                let _e4496 = phi_3535_;
                                local_43 = _e4496;
                                continue;
                                continuing {
                                    phi_2554_ = _e3919;
                                    break if !(_e4494);
                                }
                            }
                            let _e4499 = local_43;
                            if _e4499 {
                                phi_3540_ = type_55(1u, _e3892.member_1);
                                phi_3541_ = false;
                            } else {
                                phi_3540_ = type_55();
                                phi_3541_ = true;
                            }
                            let _e4502 = phi_3540_;
                            let _e4504 = phi_3541_;
                            if _e4504 {
                                phi_3546_ = type_55(2u, _e3892.member_1);
                                phi_3547_ = false;
                            } else {
                                phi_3546_ = type_55();
                                phi_3547_ = true;
                            }
                            let _e4507 = phi_3546_;
                            let _e4509 = phi_3547_;
                            phi_3549_ = _e4507;
                            phi_3550_ = _e4502;
                            phi_3551_ = _e4509;
                        } else {
                            phi_3549_ = type_55();
                            phi_3550_ = type_55(0u, type_55().member_1);
                            phi_3551_ = true;
                        }
                        let _e4511 = phi_3549_;
                        let _e4513 = phi_3550_;
                        let _e4515 = phi_3551_;
                        if _e4515 {
                            phi_3555_ = _e4513;
                        } else {
                            phi_3555_ = _e4511;
                        }
                        let _e4517 = phi_3555_;
                        phi_6802_ = _e4517;
                    } else {
                        if (_e373 < 0f) {
                            phi_3565_ = -(_e373);
                        } else {
                            phi_3565_ = _e373;
                        }
                        let _e716 = phi_3565_;
                        if (_e396 < 0f) {
                            phi_3571_ = -(_e396);
                        } else {
                            phi_3571_ = _e396;
                        }
                        let _e720 = phi_3571_;
                        if (_e716 > _e720) {
                            phi_3576_ = _e716;
                        } else {
                            phi_3576_ = _e720;
                        }
                        let _e723 = phi_3576_;
                        if (_e419 < 0f) {
                            phi_3582_ = -(_e419);
                        } else {
                            phi_3582_ = _e419;
                        }
                        let _e727 = phi_3582_;
                        if (_e430 < 0f) {
                            phi_3588_ = -(_e430);
                        } else {
                            phi_3588_ = _e430;
                        }
                        let _e731 = phi_3588_;
                        if (_e727 > _e731) {
                            phi_3593_ = _e727;
                        } else {
                            phi_3593_ = _e731;
                        }
                        let _e734 = phi_3593_;
                        if (_e723 > _e734) {
                            phi_3598_ = _e723;
                        } else {
                            phi_3598_ = _e734;
                        }
                        let _e737 = phi_3598_;
                        let _e740 = ((_e680 * 0.34f) + (_e737 * (0.000000059604645f * 256f)));
                        let _e742 = (_e396 - (3f * _e373));
                        let _e743 = (_e419 - _e396);
                        let _e745 = ((3f * _e430) - _e419);
                        local_7[0u] = 0f;
                        local_7[1u] = 1f;
                        local_7[2u] = 1f;
                        local_7[3u] = 1f;
                        let _e752 = ((_e743 * _e743) - (_e742 * _e745));
                        if (_e752 > 0f) {
                            if (_e752 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e752 > 0f) {
                                    phi_3631_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_3631_ = 0f;
                                }
                                let _e812 = phi_3631_;
                                phi_3695_ = _e812;
                            } else {
                                phi_3638_ = type_26(0i, 5i);
                                phi_3641_ = bitcast<f32>(((bitcast<u32>(_e752) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e761 = phi_3638_;
                                    let _e763 = phi_3641_;
                                    local_16 = _e763;
                                    if (_e761.member < _e761.member_1) {
                                        let _e771 = (_e761.member + 1i);
                                        if ((false == (_e771 > _e761.member)) != false) {
                                            phi_3662_ = true;
                                        } else {
                                            phi_3662_ = false;
                                        }
                                        let _e776 = phi_3662_;
                                        if _e776 {
                                            phi_3668_ = type_27(0u, type_27().member_1);
                                        } else {
                                            phi_3668_ = type_27(1u, _e771);
                                        }
                                        let _e782 = phi_3668_;
                                        if (bitcast<i32>(_e782.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_3639_ = type_26(_e782.member_1, _e761.member_1);
                                        phi_3682_ = type_27(1u, _e761.member);
                                    } else {
                                        phi_3639_ = _e761;
                                        phi_3682_ = type_27(0u, type_27().member_1);
                                    }
                                    let _e792 = phi_3639_;
                                    let _e794 = phi_3682_;
                                    let _e797 = (bitcast<i32>(_e794.member) != 0i);
                                    if _e797 {
                                        phi_3642_ = (0.5f * (_e763 + (_e752 / _e763)));
                                    } else {
                                        phi_3642_ = f32();
                                    }
                                    let _e802 = phi_3642_;
                                    continue;
                                    continuing {
                                        phi_3638_ = _e792;
                                        phi_3641_ = _e802;
                                        break if !(_e797);
                                    }
                                }
                                let _e807 = local_16;
                                phi_3695_ = (_e807 * (1f + (4f * 0.000000059604645f)));
                            }
                            let _e814 = phi_3695_;
                            if (_e743 < 0f) {
                                phi_3701_ = -(_e814);
                            } else {
                                phi_3701_ = _e814;
                            }
                            let _e818 = phi_3701_;
                            let _e820 = -((_e743 + _e818));
                            local_8[0u] = (_e820 / (_e820 + _e745));
                            local_8[1u] = (_e742 / (_e742 + _e820));
                            let _e829 = local_8[1u];
                            let _e830 = local_8[0u];
                            if (_e829 < _e830) {
                                let _e833 = local_8[1u];
                                let _e835 = local_8[0u];
                                local_8[0u] = _e833;
                                local_8[1u] = _e835;
                            }
                            phi_3726_ = type_28(0u, 2u);
                            phi_3729_ = 1u;
                            loop {
                                let _e839 = phi_3726_;
                                let _e841 = phi_3729_;
                                local_44 = _e841;
                                if (_e839.member < _e839.member_1) {
                                    phi_3727_ = type_28((_e839.member + 1u), _e839.member_1);
                                    phi_3752_ = type_28(1u, _e839.member);
                                } else {
                                    phi_3727_ = _e839;
                                    phi_3752_ = type_28(0u, type_28().member_1);
                                }
                                let _e855 = phi_3727_;
                                let _e857 = phi_3752_;
                                let _e861 = (bitcast<i32>(_e857.member) != 0i);
                                if _e861 {
                                    if (_e857.member_1 < 2u) {
                                    } else {
                                        return;
                                    }
                                    let _e864 = local_8[_e857.member_1];
                                    if (_e864 > 0f) {
                                        if (_e857.member_1 < 2u) {
                                        } else {
                                            return;
                                        }
                                        let _e868 = local_8[_e857.member_1];
                                        if (_e868 < 1f) {
                                            if (_e857.member_1 < 2u) {
                                            } else {
                                                return;
                                            }
                                            let _e872 = local_8[_e857.member_1];
                                            if (_e841 < 4u) {
                                            } else {
                                                return;
                                            }
                                            local_7[_e841] = _e872;
                                            phi_3796_ = (_e841 + 1u);
                                        } else {
                                            phi_3796_ = _e841;
                                        }
                                        let _e877 = phi_3796_;
                                        phi_3797_ = _e877;
                                    } else {
                                        phi_3797_ = _e841;
                                    }
                                    let _e879 = phi_3797_;
                                    phi_3730_ = _e879;
                                } else {
                                    phi_3730_ = u32();
                                }
                                let _e881 = phi_3730_;
                                continue;
                                continuing {
                                    phi_3726_ = _e855;
                                    phi_3729_ = _e881;
                                    break if !(_e861);
                                }
                            }
                            let _e4776 = local_44;
                            phi_3798_ = _e4776;
                        } else {
                            phi_3798_ = 1u;
                        }
                        let _e884 = phi_3798_;
                        if (_e884 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e884] = 1f;
                        let _e887 = local_7;
                        local_9 = _e887;
                        phi_3818_ = type_28(0u, _e884);
                        loop {
                            let _e890 = phi_3818_;
                            if (_e890.member < _e890.member_1) {
                                phi_3819_ = type_28((_e890.member + 1u), _e890.member_1);
                                phi_3842_ = type_28(1u, _e890.member);
                            } else {
                                phi_3819_ = _e890;
                                phi_3842_ = type_28(0u, type_28().member_1);
                            }
                            let _e904 = phi_3819_;
                            let _e906 = phi_3842_;
                            if (bitcast<i32>(_e906.member) != 0i) {
                                if (_e906.member_1 < 4u) {
                                } else {
                                    return;
                                }
                                let _e913 = local_9[_e906.member_1];
                                let _e914 = (_e906.member_1 + 1u);
                                if (_e914 < 4u) {
                                } else {
                                    return;
                                }
                                let _e917 = local_9[_e914];
                                let _e918 = (1f - _e913);
                                let _e929 = ((((_e373 * _e918) + (_e396 * _e913)) * (_e918 * _e918)) + (((_e419 * _e918) + (_e430 * _e913)) * (_e913 * _e913)));
                                let _e930 = (1f - _e917);
                                let _e941 = ((((_e373 * _e930) + (_e396 * _e917)) * (_e930 * _e930)) + (((_e419 * _e930) + (_e430 * _e917)) * (_e917 * _e917)));
                                if (_e929 < 0f) {
                                    phi_3894_ = -(_e929);
                                } else {
                                    phi_3894_ = _e929;
                                }
                                let _e945 = phi_3894_;
                                let _e946 = (_e945 > _e740);
                                if (_e941 < 0f) {
                                    phi_3901_ = -(_e941);
                                } else {
                                    phi_3901_ = _e941;
                                }
                                let _e950 = phi_3901_;
                                let _e951 = (_e950 > _e740);
                                if _e946 {
                                    if _e951 {
                                        let _e954 = ((_e929 > 0f) != (_e941 > 0f));
                                        if _e946 {
                                            if _e951 {
                                                if _e954 {
                                                    phi_3921_ = false;
                                                } else {
                                                    phi_3921_ = true;
                                                }
                                                let _e956 = phi_3921_;
                                                phi_3922_ = _e956;
                                            } else {
                                                phi_3922_ = false;
                                            }
                                            let _e958 = phi_3922_;
                                            phi_3923_ = _e958;
                                        } else {
                                            phi_3923_ = false;
                                        }
                                        let _e960 = phi_3923_;
                                        phi_3924_ = _e954;
                                        phi_3925_ = _e954;
                                        phi_3926_ = false;
                                        phi_3927_ = _e960;
                                    } else {
                                        phi_3924_ = bool();
                                        phi_3925_ = bool();
                                        phi_3926_ = true;
                                        phi_3927_ = false;
                                    }
                                    let _e962 = phi_3924_;
                                    let _e964 = phi_3925_;
                                    let _e966 = phi_3926_;
                                    let _e968 = phi_3927_;
                                    phi_3928_ = _e962;
                                    phi_3929_ = _e964;
                                    phi_3930_ = _e966;
                                    phi_3931_ = _e968;
                                } else {
                                    phi_3928_ = bool();
                                    phi_3929_ = bool();
                                    phi_3930_ = true;
                                    phi_3931_ = false;
                                }
                                let _e970 = phi_3928_;
                                let _e972 = phi_3929_;
                                let _e974 = phi_3930_;
                                let _e976 = phi_3931_;
                                if _e974 {
                                    if _e946 {
                                        phi_3941_ = _e951;
                                    } else {
                                        phi_3941_ = false;
                                    }
                                    let _e978 = phi_3941_;
                                    phi_3942_ = false;
                                    phi_3943_ = false;
                                    phi_3944_ = _e978;
                                } else {
                                    phi_3942_ = _e972;
                                    phi_3943_ = _e970;
                                    phi_3944_ = _e976;
                                }
                                let _e980 = phi_3942_;
                                let _e982 = phi_3943_;
                                let _e984 = phi_3944_;
                                if _e984 {
                                    phi_3949_ = type_56(1f, 0f, _e980);
                                    phi_3950_ = false;
                                } else {
                                    phi_3949_ = type_56();
                                    phi_3950_ = true;
                                }
                                let _e987 = phi_3949_;
                                let _e989 = phi_3950_;
                                if _e989 {
                                    if _e946 {
                                        if (_e929 < 0f) {
                                            phi_3961_ = -1f;
                                        } else {
                                            phi_3961_ = 1f;
                                        }
                                        let _e992 = phi_3961_;
                                        let _e995 = (_e419 - _e396);
                                        phi_3971_ = type_28(0u, 64u);
                                        phi_3974_ = _e917;
                                        phi_3976_ = _e913;
                                        phi_3978_ = (0.5f * (_e913 + _e917));
                                        loop {
                                            let _e1001 = phi_3971_;
                                            let _e1003 = phi_3974_;
                                            let _e1005 = phi_3976_;
                                            let _e1007 = phi_3978_;
                                            local_46 = _e1005;
                                            if (_e1001.member < _e1001.member_1) {
                                                phi_3972_ = type_28((_e1001.member + 1u), _e1001.member_1);
                                                phi_4001_ = type_28(1u, _e1001.member);
                                            } else {
                                                phi_3972_ = _e1001;
                                                phi_4001_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1021 = phi_3972_;
                                            let _e1023 = phi_4001_;
                                            if (bitcast<i32>(_e1023.member) != 0i) {
                                                let _e1027 = (1f - _e1007);
                                                let _e1040 = ((_e992 * ((((_e373 * _e1027) + (_e396 * _e1007)) * (_e1027 * _e1027)) + (((_e419 * _e1027) + (_e430 * _e1007)) * (_e1007 * _e1007)))) - _e740);
                                                if (_e1040 > 0f) {
                                                    phi_4026_ = _e1003;
                                                    phi_4027_ = _e1007;
                                                } else {
                                                    phi_4026_ = _e1007;
                                                    phi_4027_ = _e1005;
                                                }
                                                let _e1043 = phi_4026_;
                                                let _e1045 = phi_4027_;
                                                let _e1047 = ((_e1043 - _e1045) > 0.00000000000022737368f);
                                                if _e1047 {
                                                    let _e1048 = (1f - _e1007);
                                                    let _e1060 = (-(_e1040) / (_e992 * (((((_e396 - (3f * _e373)) * _e1048) + (_e995 * _e1007)) * _e1048) + (((_e995 * _e1048) + (((3f * _e430) - _e419) * _e1007)) * _e1007))));
                                                    if (_e1040 > 0f) {
                                                        phi_4053_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_4053_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1066 = phi_4053_;
                                                    let _e1068 = ((_e1007 + _e1060) + _e1066);
                                                    if (_e1068 > _e1045) {
                                                        if (_e1068 < _e1043) {
                                                            if (_e1060 < 0f) {
                                                                phi_4069_ = -(_e1060);
                                                            } else {
                                                                phi_4069_ = _e1060;
                                                            }
                                                            let _e1074 = phi_4069_;
                                                            if (_e1074 < (0.5f * (_e1043 - _e1045))) {
                                                                phi_4076_ = false;
                                                            } else {
                                                                phi_4076_ = true;
                                                            }
                                                            let _e1079 = phi_4076_;
                                                            phi_4077_ = _e1079;
                                                        } else {
                                                            phi_4077_ = true;
                                                        }
                                                        let _e1081 = phi_4077_;
                                                        phi_4078_ = _e1081;
                                                    } else {
                                                        phi_4078_ = true;
                                                    }
                                                    let _e1083 = phi_4078_;
                                                    if _e1083 {
                                                        phi_4084_ = (0.5f * (_e1045 + _e1043));
                                                    } else {
                                                        phi_4084_ = _e1068;
                                                    }
                                                    let _e1087 = phi_4084_;
                                                    phi_4085_ = _e1087;
                                                    phi_4086_ = false;
                                                } else {
                                                    phi_4085_ = f32();
                                                    phi_4086_ = true;
                                                }
                                                let _e1089 = phi_4085_;
                                                let _e1091 = phi_4086_;
                                                phi_3975_ = _e1043;
                                                phi_3977_ = _e1045;
                                                phi_3979_ = _e1089;
                                                phi_4087_ = _e1045;
                                                phi_4088_ = _e1047;
                                                phi_4089_ = _e1091;
                                            } else {
                                                phi_3975_ = f32();
                                                phi_3977_ = f32();
                                                phi_3979_ = f32();
                                                phi_4087_ = f32();
                                                phi_4088_ = false;
                                                phi_4089_ = false;
                                            }
                                            let _e1093 = phi_3975_;
                                            let _e1095 = phi_3977_;
                                            let _e1097 = phi_3979_;
                                            let _e1099 = phi_4087_;
                                            let _e1101 = phi_4088_;
                                            let _e1103 = phi_4089_;
                                            local_17 = _e1103;
                                            local_45 = _e1099;
                                            continue;
                                            continuing {
                                                phi_3971_ = _e1021;
                                                phi_3974_ = _e1093;
                                                phi_3976_ = _e1095;
                                                phi_3978_ = _e1097;
                                                break if !(_e1101);
                                            }
                                        }
                                        let _e1106 = local_17;
                                        if _e1106 {
                                            let _e4825 = local_45;
                                            phi_4093_ = _e4825;
                                        } else {
                                            let _e4827 = local_46;
                                            phi_4093_ = _e4827;
                                        }
                                        let _e1108 = phi_4093_;
                                        phi_4094_ = _e1108;
                                    } else {
                                        phi_4094_ = _e913;
                                    }
                                    let _e1110 = phi_4094_;
                                    if _e951 {
                                        phi_4101_ = type_28(0u, 64u);
                                        phi_4104_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1113 = phi_4101_;
                                            let _e1115 = phi_4104_;
                                            if (_e1113.member < _e1113.member_1) {
                                                phi_4102_ = type_28((_e1113.member + 1u), _e1113.member_1);
                                                phi_4127_ = type_28(1u, _e1113.member);
                                            } else {
                                                phi_4102_ = _e1113;
                                                phi_4127_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1129 = phi_4102_;
                                            let _e1131 = phi_4127_;
                                            if (bitcast<i32>(_e1131.member) != 0i) {
                                                let _e1135 = (_e1110 + _e1115);
                                                if (_e1135 < _e917) {
                                                    let _e1137 = (1f - _e1135);
                                                    let _e1148 = ((((_e373 * _e1137) + (_e396 * _e1135)) * (_e1137 * _e1137)) + (((_e419 * _e1137) + (_e430 * _e1135)) * (_e1135 * _e1135)));
                                                    let _e1149 = (1f - _e1110);
                                                    let _e1160 = ((((_e373 * _e1149) + (_e396 * _e1110)) * (_e1149 * _e1149)) + (((_e419 * _e1149) + (_e430 * _e1110)) * (_e1110 * _e1110)));
                                                    if (_e1148 < 0f) {
                                                        phi_4168_ = -(_e1148);
                                                    } else {
                                                        phi_4168_ = _e1148;
                                                    }
                                                    let _e1164 = phi_4168_;
                                                    if (_e1164 > _e740) {
                                                        if (_e1160 < 0f) {
                                                            phi_4178_ = -(_e1160);
                                                        } else {
                                                            phi_4178_ = _e1160;
                                                        }
                                                        let _e1169 = phi_4178_;
                                                        if (_e1169 > _e740) {
                                                            phi_4186_ = ((_e1148 > 0f) == (_e1160 > 0f));
                                                        } else {
                                                            phi_4186_ = false;
                                                        }
                                                        let _e1175 = phi_4186_;
                                                        phi_4188_ = !(_e1175);
                                                    } else {
                                                        phi_4188_ = false;
                                                    }
                                                    let _e1178 = phi_4188_;
                                                    if _e1178 {
                                                        phi_4193_ = f32();
                                                        phi_4194_ = false;
                                                    } else {
                                                        phi_4193_ = (_e1115 + _e1115);
                                                        phi_4194_ = true;
                                                    }
                                                    let _e1181 = phi_4193_;
                                                    let _e1183 = phi_4194_;
                                                    phi_4195_ = _e1181;
                                                    phi_4196_ = _e1183;
                                                    phi_4197_ = _e1178;
                                                    phi_4198_ = false;
                                                } else {
                                                    phi_4195_ = f32();
                                                    phi_4196_ = false;
                                                    phi_4197_ = false;
                                                    phi_4198_ = true;
                                                }
                                                let _e1185 = phi_4195_;
                                                let _e1187 = phi_4196_;
                                                let _e1189 = phi_4197_;
                                                let _e1191 = phi_4198_;
                                                phi_4199_ = _e1135;
                                                phi_4105_ = _e1185;
                                                phi_4200_ = _e1187;
                                                phi_4201_ = _e1189;
                                                phi_4202_ = _e1191;
                                                phi_4203_ = false;
                                            } else {
                                                phi_4199_ = f32();
                                                phi_4105_ = f32();
                                                phi_4200_ = false;
                                                phi_4201_ = false;
                                                phi_4202_ = false;
                                                phi_4203_ = true;
                                            }
                                            let _e1193 = phi_4199_;
                                            let _e1195 = phi_4105_;
                                            let _e1197 = phi_4200_;
                                            let _e1199 = phi_4201_;
                                            let _e1201 = phi_4202_;
                                            let _e1203 = phi_4203_;
                                            local_18 = _e1199;
                                            local_47 = _e1201;
                                            local_48 = _e1203;
                                            local_49 = _e1193;
                                            continue;
                                            continuing {
                                                phi_4101_ = _e1129;
                                                phi_4104_ = _e1195;
                                                break if !(_e1197);
                                            }
                                        }
                                        let _e1206 = local_18;
                                        if _e1206 {
                                            phi_4207_ = false;
                                            phi_4208_ = false;
                                        } else {
                                            let _e4852 = local_47;
                                            phi_4207_ = _e4852;
                                            let _e4855 = local_48;
                                            phi_4208_ = _e4855;
                                        }
                                        let _e1208 = phi_4207_;
                                        let _e1210 = phi_4208_;
                                        if _e1208 {
                                            phi_4212_ = true;
                                        } else {
                                            phi_4212_ = _e1210;
                                        }
                                        let _e1212 = phi_4212_;
                                        if _e1212 {
                                            phi_4216_ = _e917;
                                        } else {
                                            let _e4859 = local_49;
                                            phi_4216_ = _e4859;
                                        }
                                        let _e1214 = phi_4216_;
                                        phi_4217_ = _e1214;
                                    } else {
                                        phi_4217_ = _e917;
                                    }
                                    let _e1216 = phi_4217_;
                                    phi_4219_ = type_56(_e1110, _e1216, _e982);
                                } else {
                                    phi_4219_ = _e987;
                                }
                                let _e1219 = phi_4219_;
                                if (_e1219.member > _e1219.member_1) {
                                    phi_6758_ = f32();
                                    phi_6759_ = true;
                                    phi_6760_ = false;
                                    phi_6761_ = false;
                                    phi_6762_ = false;
                                } else {
                                    let _e1226 = ((_e1219.member_1 - _e1219.member) * 0.5f);
                                    let _e1227 = (_e1219.member + _e1226);
                                    let _e1229 = (_e1226 + (0.000000059604645f * 4f));
                                    let _e1231 = local_15.member_3;
                                    let _e1234 = local_15.member[0u];
                                    if (_e1234[0] < 0f) {
                                        phi_4248_ = -(_e1234[0]);
                                    } else {
                                        phi_4248_ = _e1234[0];
                                    }
                                    let _e1241 = phi_4248_;
                                    if (_e1234[1] < 0f) {
                                        phi_4255_ = -(_e1234[1]);
                                    } else {
                                        phi_4255_ = _e1234[1];
                                    }
                                    let _e1245 = phi_4255_;
                                    if (_e1241 > _e1245) {
                                        phi_4260_ = _e1241;
                                    } else {
                                        phi_4260_ = _e1245;
                                    }
                                    let _e1248 = phi_4260_;
                                    if (_e1234[2] < 0f) {
                                        phi_4267_ = -(_e1234[2]);
                                    } else {
                                        phi_4267_ = _e1234[2];
                                    }
                                    let _e1252 = phi_4267_;
                                    if (_e1248 > _e1252) {
                                        phi_4272_ = _e1248;
                                    } else {
                                        phi_4272_ = _e1252;
                                    }
                                    let _e1255 = phi_4272_;
                                    let _e1257 = local_15.member[1u];
                                    if (_e1257[0] < 0f) {
                                        phi_4285_ = -(_e1257[0]);
                                    } else {
                                        phi_4285_ = _e1257[0];
                                    }
                                    let _e1264 = phi_4285_;
                                    if (_e1257[1] < 0f) {
                                        phi_4292_ = -(_e1257[1]);
                                    } else {
                                        phi_4292_ = _e1257[1];
                                    }
                                    let _e1268 = phi_4292_;
                                    if (_e1264 > _e1268) {
                                        phi_4297_ = _e1264;
                                    } else {
                                        phi_4297_ = _e1268;
                                    }
                                    let _e1271 = phi_4297_;
                                    if (_e1257[2] < 0f) {
                                        phi_4304_ = -(_e1257[2]);
                                    } else {
                                        phi_4304_ = _e1257[2];
                                    }
                                    let _e1275 = phi_4304_;
                                    if (_e1271 > _e1275) {
                                        phi_4309_ = _e1271;
                                    } else {
                                        phi_4309_ = _e1275;
                                    }
                                    let _e1278 = phi_4309_;
                                    if (_e1255 > _e1278) {
                                        phi_4314_ = _e1255;
                                    } else {
                                        phi_4314_ = _e1278;
                                    }
                                    let _e1281 = phi_4314_;
                                    let _e1284 = local_15.member[0u];
                                    let _e1289 = local_15.member[1u];
                                    let _e1299 = (_e1284[0] + ((_e1289[0] - _e1284[0]) * _e1227));
                                    let _e1300 = (_e1284[1] + ((_e1289[1] - _e1284[1]) * _e1227));
                                    let _e1301 = (_e1284[2] + ((_e1289[2] - _e1284[2]) * _e1227));
                                    let _e1303 = local_15.member[1u];
                                    let _e1308 = local_15.member[0u];
                                    let _e1312 = (_e1303[0] - _e1308[0]);
                                    let _e1313 = (_e1303[1] - _e1308[1]);
                                    let _e1314 = (_e1303[2] - _e1308[2]);
                                    if (_e1312 < 0f) {
                                        phi_4373_ = -(_e1312);
                                    } else {
                                        phi_4373_ = _e1312;
                                    }
                                    let _e1318 = phi_4373_;
                                    if (_e1313 < 0f) {
                                        phi_4379_ = -(_e1313);
                                    } else {
                                        phi_4379_ = _e1313;
                                    }
                                    let _e1322 = phi_4379_;
                                    if (_e1318 > _e1322) {
                                        phi_4384_ = _e1318;
                                    } else {
                                        phi_4384_ = _e1322;
                                    }
                                    let _e1325 = phi_4384_;
                                    if (_e1314 < 0f) {
                                        phi_4390_ = -(_e1314);
                                    } else {
                                        phi_4390_ = _e1314;
                                    }
                                    let _e1329 = phi_4390_;
                                    if (_e1325 > _e1329) {
                                        phi_4395_ = _e1325;
                                    } else {
                                        phi_4395_ = _e1329;
                                    }
                                    let _e1332 = phi_4395_;
                                    let _e1338 = ((((_e1229 * _e1332) * 1.01f) + ((_e1281 + _e1231) * (0.000000059604645f * 8f))) + _e1231);
                                    if (_e1299 < 0f) {
                                        phi_4407_ = -(_e1299);
                                    } else {
                                        phi_4407_ = _e1299;
                                    }
                                    let _e1342 = phi_4407_;
                                    if (_e1300 < 0f) {
                                        phi_4413_ = -(_e1300);
                                    } else {
                                        phi_4413_ = _e1300;
                                    }
                                    let _e1346 = phi_4413_;
                                    if (_e1342 > _e1346) {
                                        phi_4418_ = _e1342;
                                    } else {
                                        phi_4418_ = _e1346;
                                    }
                                    let _e1349 = phi_4418_;
                                    if (_e1301 < 0f) {
                                        phi_4424_ = -(_e1301);
                                    } else {
                                        phi_4424_ = _e1301;
                                    }
                                    let _e1353 = phi_4424_;
                                    if (_e1349 > _e1353) {
                                        phi_4429_ = _e1349;
                                    } else {
                                        phi_4429_ = _e1353;
                                    }
                                    let _e1356 = phi_4429_;
                                    local_3 = type_40(array<f32, 3>(_e1299, _e1300, _e1301), _e1338, (_e1356 + _e1338));
                                    let _e1362 = local_15.member_3;
                                    let _e1364 = local_15.member_1[0u];
                                    if (_e1364[0] < 0f) {
                                        phi_4455_ = -(_e1364[0]);
                                    } else {
                                        phi_4455_ = _e1364[0];
                                    }
                                    let _e1371 = phi_4455_;
                                    if (_e1364[1] < 0f) {
                                        phi_4462_ = -(_e1364[1]);
                                    } else {
                                        phi_4462_ = _e1364[1];
                                    }
                                    let _e1375 = phi_4462_;
                                    if (_e1371 > _e1375) {
                                        phi_4467_ = _e1371;
                                    } else {
                                        phi_4467_ = _e1375;
                                    }
                                    let _e1378 = phi_4467_;
                                    if (_e1364[2] < 0f) {
                                        phi_4474_ = -(_e1364[2]);
                                    } else {
                                        phi_4474_ = _e1364[2];
                                    }
                                    let _e1382 = phi_4474_;
                                    if (_e1378 > _e1382) {
                                        phi_4479_ = _e1378;
                                    } else {
                                        phi_4479_ = _e1382;
                                    }
                                    let _e1385 = phi_4479_;
                                    let _e1387 = local_15.member_1[1u];
                                    if (_e1387[0] < 0f) {
                                        phi_4492_ = -(_e1387[0]);
                                    } else {
                                        phi_4492_ = _e1387[0];
                                    }
                                    let _e1394 = phi_4492_;
                                    if (_e1387[1] < 0f) {
                                        phi_4499_ = -(_e1387[1]);
                                    } else {
                                        phi_4499_ = _e1387[1];
                                    }
                                    let _e1398 = phi_4499_;
                                    if (_e1394 > _e1398) {
                                        phi_4504_ = _e1394;
                                    } else {
                                        phi_4504_ = _e1398;
                                    }
                                    let _e1401 = phi_4504_;
                                    if (_e1387[2] < 0f) {
                                        phi_4511_ = -(_e1387[2]);
                                    } else {
                                        phi_4511_ = _e1387[2];
                                    }
                                    let _e1405 = phi_4511_;
                                    if (_e1401 > _e1405) {
                                        phi_4516_ = _e1401;
                                    } else {
                                        phi_4516_ = _e1405;
                                    }
                                    let _e1408 = phi_4516_;
                                    if (_e1385 > _e1408) {
                                        phi_4521_ = _e1385;
                                    } else {
                                        phi_4521_ = _e1408;
                                    }
                                    let _e1411 = phi_4521_;
                                    let _e1414 = local_15.member_1[0u];
                                    let _e1419 = local_15.member_1[1u];
                                    let _e1429 = (_e1414[0] + ((_e1419[0] - _e1414[0]) * _e1227));
                                    let _e1430 = (_e1414[1] + ((_e1419[1] - _e1414[1]) * _e1227));
                                    let _e1431 = (_e1414[2] + ((_e1419[2] - _e1414[2]) * _e1227));
                                    let _e1433 = local_15.member_1[1u];
                                    let _e1438 = local_15.member_1[0u];
                                    let _e1442 = (_e1433[0] - _e1438[0]);
                                    let _e1443 = (_e1433[1] - _e1438[1]);
                                    let _e1444 = (_e1433[2] - _e1438[2]);
                                    if (_e1442 < 0f) {
                                        phi_4580_ = -(_e1442);
                                    } else {
                                        phi_4580_ = _e1442;
                                    }
                                    let _e1448 = phi_4580_;
                                    if (_e1443 < 0f) {
                                        phi_4586_ = -(_e1443);
                                    } else {
                                        phi_4586_ = _e1443;
                                    }
                                    let _e1452 = phi_4586_;
                                    if (_e1448 > _e1452) {
                                        phi_4591_ = _e1448;
                                    } else {
                                        phi_4591_ = _e1452;
                                    }
                                    let _e1455 = phi_4591_;
                                    if (_e1444 < 0f) {
                                        phi_4597_ = -(_e1444);
                                    } else {
                                        phi_4597_ = _e1444;
                                    }
                                    let _e1459 = phi_4597_;
                                    if (_e1455 > _e1459) {
                                        phi_4602_ = _e1455;
                                    } else {
                                        phi_4602_ = _e1459;
                                    }
                                    let _e1462 = phi_4602_;
                                    let _e1468 = ((((_e1229 * _e1462) * 1.01f) + ((_e1411 + _e1362) * (0.000000059604645f * 8f))) + _e1362);
                                    if (_e1429 < 0f) {
                                        phi_4614_ = -(_e1429);
                                    } else {
                                        phi_4614_ = _e1429;
                                    }
                                    let _e1472 = phi_4614_;
                                    if (_e1430 < 0f) {
                                        phi_4620_ = -(_e1430);
                                    } else {
                                        phi_4620_ = _e1430;
                                    }
                                    let _e1476 = phi_4620_;
                                    if (_e1472 > _e1476) {
                                        phi_4625_ = _e1472;
                                    } else {
                                        phi_4625_ = _e1476;
                                    }
                                    let _e1479 = phi_4625_;
                                    if (_e1431 < 0f) {
                                        phi_4631_ = -(_e1431);
                                    } else {
                                        phi_4631_ = _e1431;
                                    }
                                    let _e1483 = phi_4631_;
                                    if (_e1479 > _e1483) {
                                        phi_4636_ = _e1479;
                                    } else {
                                        phi_4636_ = _e1483;
                                    }
                                    let _e1486 = phi_4636_;
                                    local_4 = type_40(array<f32, 3>(_e1429, _e1430, _e1431), _e1468, (_e1486 + _e1468));
                                    let _e1492 = local_15.member_3;
                                    let _e1494 = local_15.member_2[0u];
                                    if (_e1494[0] < 0f) {
                                        phi_4662_ = -(_e1494[0]);
                                    } else {
                                        phi_4662_ = _e1494[0];
                                    }
                                    let _e1501 = phi_4662_;
                                    if (_e1494[1] < 0f) {
                                        phi_4669_ = -(_e1494[1]);
                                    } else {
                                        phi_4669_ = _e1494[1];
                                    }
                                    let _e1505 = phi_4669_;
                                    if (_e1501 > _e1505) {
                                        phi_4674_ = _e1501;
                                    } else {
                                        phi_4674_ = _e1505;
                                    }
                                    let _e1508 = phi_4674_;
                                    if (_e1494[2] < 0f) {
                                        phi_4681_ = -(_e1494[2]);
                                    } else {
                                        phi_4681_ = _e1494[2];
                                    }
                                    let _e1512 = phi_4681_;
                                    if (_e1508 > _e1512) {
                                        phi_4686_ = _e1508;
                                    } else {
                                        phi_4686_ = _e1512;
                                    }
                                    let _e1515 = phi_4686_;
                                    let _e1517 = local_15.member_2[1u];
                                    if (_e1517[0] < 0f) {
                                        phi_4699_ = -(_e1517[0]);
                                    } else {
                                        phi_4699_ = _e1517[0];
                                    }
                                    let _e1524 = phi_4699_;
                                    if (_e1517[1] < 0f) {
                                        phi_4706_ = -(_e1517[1]);
                                    } else {
                                        phi_4706_ = _e1517[1];
                                    }
                                    let _e1528 = phi_4706_;
                                    if (_e1524 > _e1528) {
                                        phi_4711_ = _e1524;
                                    } else {
                                        phi_4711_ = _e1528;
                                    }
                                    let _e1531 = phi_4711_;
                                    if (_e1517[2] < 0f) {
                                        phi_4718_ = -(_e1517[2]);
                                    } else {
                                        phi_4718_ = _e1517[2];
                                    }
                                    let _e1535 = phi_4718_;
                                    if (_e1531 > _e1535) {
                                        phi_4723_ = _e1531;
                                    } else {
                                        phi_4723_ = _e1535;
                                    }
                                    let _e1538 = phi_4723_;
                                    if (_e1515 > _e1538) {
                                        phi_4728_ = _e1515;
                                    } else {
                                        phi_4728_ = _e1538;
                                    }
                                    let _e1541 = phi_4728_;
                                    let _e1544 = local_15.member_2[0u];
                                    let _e1549 = local_15.member_2[1u];
                                    let _e1559 = (_e1544[0] + ((_e1549[0] - _e1544[0]) * _e1227));
                                    let _e1560 = (_e1544[1] + ((_e1549[1] - _e1544[1]) * _e1227));
                                    let _e1561 = (_e1544[2] + ((_e1549[2] - _e1544[2]) * _e1227));
                                    let _e1563 = local_15.member_2[1u];
                                    let _e1568 = local_15.member_2[0u];
                                    let _e1572 = (_e1563[0] - _e1568[0]);
                                    let _e1573 = (_e1563[1] - _e1568[1]);
                                    let _e1574 = (_e1563[2] - _e1568[2]);
                                    if (_e1572 < 0f) {
                                        phi_4787_ = -(_e1572);
                                    } else {
                                        phi_4787_ = _e1572;
                                    }
                                    let _e1578 = phi_4787_;
                                    if (_e1573 < 0f) {
                                        phi_4793_ = -(_e1573);
                                    } else {
                                        phi_4793_ = _e1573;
                                    }
                                    let _e1582 = phi_4793_;
                                    if (_e1578 > _e1582) {
                                        phi_4798_ = _e1578;
                                    } else {
                                        phi_4798_ = _e1582;
                                    }
                                    let _e1585 = phi_4798_;
                                    if (_e1574 < 0f) {
                                        phi_4804_ = -(_e1574);
                                    } else {
                                        phi_4804_ = _e1574;
                                    }
                                    let _e1589 = phi_4804_;
                                    if (_e1585 > _e1589) {
                                        phi_4809_ = _e1585;
                                    } else {
                                        phi_4809_ = _e1589;
                                    }
                                    let _e1592 = phi_4809_;
                                    let _e1598 = ((((_e1229 * _e1592) * 1.01f) + ((_e1541 + _e1492) * (0.000000059604645f * 8f))) + _e1492);
                                    if (_e1559 < 0f) {
                                        phi_4821_ = -(_e1559);
                                    } else {
                                        phi_4821_ = _e1559;
                                    }
                                    let _e1602 = phi_4821_;
                                    if (_e1560 < 0f) {
                                        phi_4827_ = -(_e1560);
                                    } else {
                                        phi_4827_ = _e1560;
                                    }
                                    let _e1606 = phi_4827_;
                                    if (_e1602 > _e1606) {
                                        phi_4832_ = _e1602;
                                    } else {
                                        phi_4832_ = _e1606;
                                    }
                                    let _e1609 = phi_4832_;
                                    if (_e1561 < 0f) {
                                        phi_4838_ = -(_e1561);
                                    } else {
                                        phi_4838_ = _e1561;
                                    }
                                    let _e1613 = phi_4838_;
                                    if (_e1609 > _e1613) {
                                        phi_4843_ = _e1609;
                                    } else {
                                        phi_4843_ = _e1613;
                                    }
                                    let _e1616 = phi_4843_;
                                    local_5 = type_40(array<f32, 3>(_e1559, _e1560, _e1561), _e1598, (_e1616 + _e1598));
                                    let _e1621 = local_4.member;
                                    let _e1626 = local_5.member;
                                    let _e1632 = ((_e1621[1] * _e1626[2]) - (_e1621[2] * _e1626[1]));
                                    let _e1635 = ((_e1621[2] * _e1626[0]) - (_e1621[0] * _e1626[2]));
                                    let _e1638 = ((_e1621[0] * _e1626[1]) - (_e1621[1] * _e1626[0]));
                                    if (_e1632 < 0f) {
                                        phi_4892_ = -(_e1632);
                                    } else {
                                        phi_4892_ = _e1632;
                                    }
                                    let _e1642 = phi_4892_;
                                    if (_e1635 < 0f) {
                                        phi_4898_ = -(_e1635);
                                    } else {
                                        phi_4898_ = _e1635;
                                    }
                                    let _e1646 = phi_4898_;
                                    if (_e1642 > _e1646) {
                                        if (_e1632 < 0f) {
                                            phi_4908_ = -(_e1632);
                                        } else {
                                            phi_4908_ = _e1632;
                                        }
                                        let _e1664 = phi_4908_;
                                        if (_e1638 < 0f) {
                                            phi_4914_ = -(_e1638);
                                        } else {
                                            phi_4914_ = _e1638;
                                        }
                                        let _e1668 = phi_4914_;
                                        if (_e1664 > _e1668) {
                                            phi_4919_ = 2u;
                                            phi_4920_ = 1u;
                                        } else {
                                            phi_4919_ = 1u;
                                            phi_4920_ = 0u;
                                        }
                                        let _e1671 = phi_4919_;
                                        let _e1673 = phi_4920_;
                                        phi_4939_ = _e1671;
                                        phi_4940_ = _e1673;
                                    } else {
                                        if (_e1635 < 0f) {
                                            phi_4926_ = -(_e1635);
                                        } else {
                                            phi_4926_ = _e1635;
                                        }
                                        let _e1651 = phi_4926_;
                                        if (_e1638 < 0f) {
                                            phi_4932_ = -(_e1638);
                                        } else {
                                            phi_4932_ = _e1638;
                                        }
                                        let _e1655 = phi_4932_;
                                        if (_e1651 > _e1655) {
                                            phi_4937_ = 0u;
                                            phi_4938_ = 2u;
                                        } else {
                                            phi_4937_ = 1u;
                                            phi_4938_ = 0u;
                                        }
                                        let _e1658 = phi_4937_;
                                        let _e1660 = phi_4938_;
                                        phi_4939_ = _e1658;
                                        phi_4940_ = _e1660;
                                    }
                                    let _e1675 = phi_4939_;
                                    let _e1677 = phi_4940_;
                                    if (_e1677 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1681 = local_4.member[_e1677];
                                    if (_e1675 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1685 = local_5.member[_e1675];
                                    if (_e1675 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1690 = local_4.member[_e1675];
                                    if (_e1677 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1694 = local_5.member[_e1677];
                                    let _e1696 = ((_e1681 * _e1685) - (_e1690 * _e1694));
                                    let _e1698 = local_4.member_1;
                                    let _e1700 = local_5.member_2;
                                    let _e1703 = local_4.member_2;
                                    let _e1705 = local_5.member_1;
                                    let _e1710 = local_4.member_2;
                                    let _e1712 = local_5.member_2;
                                    let _e1719 = local_4.member_2;
                                    let _e1722 = local_5.member_2;
                                    let _e1726 = (((((_e1698 * _e1700) + (_e1703 * _e1705)) * 2.01f) + ((_e1710 * _e1712) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1719) * (1f + _e1722))));
                                    if (_e1696 < 0f) {
                                        phi_5007_ = -(_e1696);
                                    } else {
                                        phi_5007_ = _e1696;
                                    }
                                    let _e1730 = phi_5007_;
                                    if (_e1730 > _e1726) {
                                        if (_e1696 < 0f) {
                                            phi_5016_ = -1f;
                                        } else {
                                            phi_5016_ = 1f;
                                        }
                                        let _e1734 = phi_5016_;
                                        if (_e1677 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1738 = local_3.member[_e1677];
                                        if (_e1675 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1742 = local_5.member[_e1675];
                                        if (_e1675 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1747 = local_3.member[_e1675];
                                        if (_e1677 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1751 = local_5.member[_e1677];
                                        let _e1755 = local_3.member_1;
                                        let _e1757 = local_5.member_2;
                                        let _e1760 = local_3.member_2;
                                        let _e1762 = local_5.member_1;
                                        let _e1767 = local_3.member_2;
                                        let _e1769 = local_5.member_2;
                                        let _e1776 = local_3.member_2;
                                        let _e1779 = local_5.member_2;
                                        let _e1783 = (((((_e1755 * _e1757) + (_e1760 * _e1762)) * 2.01f) + ((_e1767 * _e1769) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1776) * (1f + _e1779))));
                                        if (_e1677 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1787 = local_4.member[_e1677];
                                        if (_e1675 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1791 = local_3.member[_e1675];
                                        if (_e1675 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1796 = local_4.member[_e1675];
                                        if (_e1677 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1800 = local_3.member[_e1677];
                                        let _e1804 = local_4.member_1;
                                        let _e1806 = local_3.member_2;
                                        let _e1809 = local_4.member_2;
                                        let _e1811 = local_3.member_1;
                                        let _e1816 = local_4.member_2;
                                        let _e1818 = local_3.member_2;
                                        let _e1825 = local_4.member_2;
                                        let _e1828 = local_3.member_2;
                                        let _e1832 = (((((_e1804 * _e1806) + (_e1809 * _e1811)) * 2.01f) + ((_e1816 * _e1818) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1825) * (1f + _e1828))));
                                        let _e1833 = (_e1696 * _e1734);
                                        let _e1834 = (((_e1738 * _e1742) - (_e1747 * _e1751)) * _e1734);
                                        let _e1835 = (((_e1787 * _e1791) - (_e1796 * _e1800)) * _e1734);
                                        if (_e1833 < 0f) {
                                            phi_5147_ = -(_e1833);
                                        } else {
                                            phi_5147_ = _e1833;
                                        }
                                        let _e1839 = phi_5147_;
                                        if (_e1834 < 0f) {
                                            phi_5153_ = -(_e1834);
                                        } else {
                                            phi_5153_ = _e1834;
                                        }
                                        let _e1843 = phi_5153_;
                                        if (_e1835 < 0f) {
                                            phi_5160_ = -(_e1835);
                                        } else {
                                            phi_5160_ = _e1835;
                                        }
                                        let _e1848 = phi_5160_;
                                        let _e1853 = ((_e1833 - _e1834) - _e1835);
                                        let _e1856 = (((_e1726 + _e1783) + _e1832) + (((_e1839 + _e1843) + _e1848) * (0.000000059604645f * 4f)));
                                        local_6[0u].member = _e1834;
                                        local_6[0u].member_1 = _e1783;
                                        local_6[1u].member = _e1835;
                                        local_6[1u].member_1 = _e1832;
                                        local_6[2u].member = _e1853;
                                        local_6[2u].member_1 = _e1856;
                                        local_6[3u].member = _e1853;
                                        local_6[3u].member_1 = _e1856;
                                        phi_5203_ = type_28(0u, 4u);
                                        phi_5206_ = true;
                                        loop {
                                            let _e1871 = phi_5203_;
                                            let _e1873 = phi_5206_;
                                            local_20 = _e1873;
                                            if (_e1871.member < _e1871.member_1) {
                                                phi_5204_ = type_28((_e1871.member + 1u), _e1871.member_1);
                                                phi_5229_ = type_28(1u, _e1871.member);
                                            } else {
                                                phi_5204_ = _e1871;
                                                phi_5229_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1887 = phi_5204_;
                                            let _e1889 = phi_5229_;
                                            if (bitcast<i32>(_e1889.member) != 0i) {
                                                if (_e1889.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1897 = local_6[_e1889.member_1].member;
                                                let _e1900 = local_6[_e1889.member_1].member_1;
                                                let _e1902 = (_e1897 < -(_e1900));
                                                if _e1902 {
                                                    phi_5256_ = bool();
                                                    phi_5257_ = false;
                                                } else {
                                                    phi_5256_ = (_e1873 && (_e1897 > _e1900));
                                                    phi_5257_ = true;
                                                }
                                                let _e1906 = phi_5256_;
                                                let _e1908 = phi_5257_;
                                                phi_5207_ = _e1906;
                                                phi_5258_ = _e1908;
                                                phi_5259_ = _e1902;
                                            } else {
                                                phi_5207_ = bool();
                                                phi_5258_ = false;
                                                phi_5259_ = false;
                                            }
                                            let _e1910 = phi_5207_;
                                            let _e1912 = phi_5258_;
                                            let _e1914 = phi_5259_;
                                            local_19 = _e1914;
                                            continue;
                                            continuing {
                                                phi_5203_ = _e1887;
                                                phi_5206_ = _e1910;
                                                break if !(_e1912);
                                            }
                                        }
                                        let _e1917 = local_19;
                                        if _e1917 {
                                            phi_5263_ = false;
                                        } else {
                                            phi_5263_ = true;
                                        }
                                        let _e1919 = phi_5263_;
                                        if _e1919 {
                                            let _e1921 = local_20;
                                            if _e1921 {
                                                phi_5270_ = 1u;
                                            } else {
                                                phi_5270_ = 2u;
                                            }
                                            let _e1923 = phi_5270_;
                                            phi_5271_ = _e1923;
                                            phi_5272_ = false;
                                        } else {
                                            phi_5271_ = u32();
                                            phi_5272_ = true;
                                        }
                                        let _e1925 = phi_5271_;
                                        let _e1927 = phi_5272_;
                                        phi_5273_ = _e1925;
                                        phi_5274_ = 0u;
                                        phi_5275_ = _e1927;
                                    } else {
                                        phi_5273_ = u32();
                                        phi_5274_ = 2u;
                                        phi_5275_ = true;
                                    }
                                    let _e1929 = phi_5273_;
                                    let _e1931 = phi_5274_;
                                    let _e1933 = phi_5275_;
                                    if _e1933 {
                                        phi_5279_ = _e1931;
                                    } else {
                                        phi_5279_ = _e1929;
                                    }
                                    let _e1935 = phi_5279_;
                                    let _e1936 = (_e1935 == 0u);
                                    if _e1936 {
                                        phi_6754_ = f32();
                                        phi_6755_ = false;
                                        phi_6756_ = false;
                                        phi_6757_ = false;
                                    } else {
                                        if (_e1935 == 1u) {
                                            if _e1219.member_2 {
                                                if ((_e1219.member_1 - _e1219.member) <= 0.0000005f) {
                                                    phi_5299_ = false;
                                                } else {
                                                    phi_5299_ = true;
                                                }
                                                let _e1944 = phi_5299_;
                                                phi_5300_ = _e1944;
                                            } else {
                                                phi_5300_ = true;
                                            }
                                            let _e1946 = phi_5300_;
                                            phi_5301_ = _e1946;
                                        } else {
                                            phi_5301_ = true;
                                        }
                                        let _e1948 = phi_5301_;
                                        if _e1948 {
                                            let _e1953 = local_15.member[0u];
                                            let _e1959 = local_15.member_1[0u];
                                            let _e1965 = local_15.member_2[0u];
                                            local_1 = array<array<f32, 3>, 4>(_e1953, array<f32, 3>((_e1953[0] - _e1959[0]), (_e1953[1] - _e1959[1]), (_e1953[2] - _e1959[2])), array<f32, 3>((_e1953[0] - _e1965[0]), (_e1953[1] - _e1965[1]), (_e1953[2] - _e1965[2])), _e1953);
                                            let _e1980 = local_15.member[1u];
                                            let _e1986 = local_15.member_1[1u];
                                            let _e1992 = local_15.member_2[1u];
                                            local_2 = array<array<f32, 3>, 4>(_e1980, array<f32, 3>((_e1980[0] - _e1986[0]), (_e1980[1] - _e1986[1]), (_e1980[2] - _e1986[2])), array<f32, 3>((_e1980[0] - _e1992[0]), (_e1980[1] - _e1992[1]), (_e1980[2] - _e1992[2])), _e1980);
                                            let _e2007 = local_15.member[0u];
                                            if (_e2007[0] < 0f) {
                                                phi_5497_ = -(_e2007[0]);
                                            } else {
                                                phi_5497_ = _e2007[0];
                                            }
                                            let _e2014 = phi_5497_;
                                            if (_e2007[1] < 0f) {
                                                phi_5504_ = -(_e2007[1]);
                                            } else {
                                                phi_5504_ = _e2007[1];
                                            }
                                            let _e2018 = phi_5504_;
                                            if (_e2014 > _e2018) {
                                                phi_5509_ = _e2014;
                                            } else {
                                                phi_5509_ = _e2018;
                                            }
                                            let _e2021 = phi_5509_;
                                            if (_e2007[2] < 0f) {
                                                phi_5516_ = -(_e2007[2]);
                                            } else {
                                                phi_5516_ = _e2007[2];
                                            }
                                            let _e2025 = phi_5516_;
                                            if (_e2021 > _e2025) {
                                                phi_5521_ = _e2021;
                                            } else {
                                                phi_5521_ = _e2025;
                                            }
                                            let _e2028 = phi_5521_;
                                            let _e2031 = local_15.member[1u];
                                            if (_e2031[0] < 0f) {
                                                phi_5534_ = -(_e2031[0]);
                                            } else {
                                                phi_5534_ = _e2031[0];
                                            }
                                            let _e2038 = phi_5534_;
                                            if (_e2031[1] < 0f) {
                                                phi_5541_ = -(_e2031[1]);
                                            } else {
                                                phi_5541_ = _e2031[1];
                                            }
                                            let _e2042 = phi_5541_;
                                            if (_e2038 > _e2042) {
                                                phi_5546_ = _e2038;
                                            } else {
                                                phi_5546_ = _e2042;
                                            }
                                            let _e2045 = phi_5546_;
                                            if (_e2031[2] < 0f) {
                                                phi_5553_ = -(_e2031[2]);
                                            } else {
                                                phi_5553_ = _e2031[2];
                                            }
                                            let _e2049 = phi_5553_;
                                            if (_e2045 > _e2049) {
                                                phi_5558_ = _e2045;
                                            } else {
                                                phi_5558_ = _e2049;
                                            }
                                            let _e2052 = phi_5558_;
                                            if (_e2028 > _e2052) {
                                                phi_5563_ = _e2028;
                                            } else {
                                                phi_5563_ = _e2052;
                                            }
                                            let _e2055 = phi_5563_;
                                            let _e2057 = local_15.member_3;
                                            let _e2061 = local_15.member_1[0u];
                                            if (_e2061[0] < 0f) {
                                                phi_5580_ = -(_e2061[0]);
                                            } else {
                                                phi_5580_ = _e2061[0];
                                            }
                                            let _e2068 = phi_5580_;
                                            if (_e2061[1] < 0f) {
                                                phi_5587_ = -(_e2061[1]);
                                            } else {
                                                phi_5587_ = _e2061[1];
                                            }
                                            let _e2072 = phi_5587_;
                                            if (_e2068 > _e2072) {
                                                phi_5592_ = _e2068;
                                            } else {
                                                phi_5592_ = _e2072;
                                            }
                                            let _e2075 = phi_5592_;
                                            if (_e2061[2] < 0f) {
                                                phi_5599_ = -(_e2061[2]);
                                            } else {
                                                phi_5599_ = _e2061[2];
                                            }
                                            let _e2079 = phi_5599_;
                                            if (_e2075 > _e2079) {
                                                phi_5604_ = _e2075;
                                            } else {
                                                phi_5604_ = _e2079;
                                            }
                                            let _e2082 = phi_5604_;
                                            let _e2085 = local_15.member_1[1u];
                                            if (_e2085[0] < 0f) {
                                                phi_5618_ = -(_e2085[0]);
                                            } else {
                                                phi_5618_ = _e2085[0];
                                            }
                                            let _e2092 = phi_5618_;
                                            if (_e2085[1] < 0f) {
                                                phi_5625_ = -(_e2085[1]);
                                            } else {
                                                phi_5625_ = _e2085[1];
                                            }
                                            let _e2096 = phi_5625_;
                                            if (_e2092 > _e2096) {
                                                phi_5630_ = _e2092;
                                            } else {
                                                phi_5630_ = _e2096;
                                            }
                                            let _e2099 = phi_5630_;
                                            if (_e2085[2] < 0f) {
                                                phi_5637_ = -(_e2085[2]);
                                            } else {
                                                phi_5637_ = _e2085[2];
                                            }
                                            let _e2103 = phi_5637_;
                                            if (_e2099 > _e2103) {
                                                phi_5642_ = _e2099;
                                            } else {
                                                phi_5642_ = _e2103;
                                            }
                                            let _e2106 = phi_5642_;
                                            if (_e2082 > _e2106) {
                                                phi_5647_ = _e2082;
                                            } else {
                                                phi_5647_ = _e2106;
                                            }
                                            let _e2109 = phi_5647_;
                                            let _e2111 = local_15.member_3;
                                            let _e2115 = local_15.member_2[0u];
                                            if (_e2115[0] < 0f) {
                                                phi_5664_ = -(_e2115[0]);
                                            } else {
                                                phi_5664_ = _e2115[0];
                                            }
                                            let _e2122 = phi_5664_;
                                            if (_e2115[1] < 0f) {
                                                phi_5671_ = -(_e2115[1]);
                                            } else {
                                                phi_5671_ = _e2115[1];
                                            }
                                            let _e2126 = phi_5671_;
                                            if (_e2122 > _e2126) {
                                                phi_5676_ = _e2122;
                                            } else {
                                                phi_5676_ = _e2126;
                                            }
                                            let _e2129 = phi_5676_;
                                            if (_e2115[2] < 0f) {
                                                phi_5683_ = -(_e2115[2]);
                                            } else {
                                                phi_5683_ = _e2115[2];
                                            }
                                            let _e2133 = phi_5683_;
                                            if (_e2129 > _e2133) {
                                                phi_5688_ = _e2129;
                                            } else {
                                                phi_5688_ = _e2133;
                                            }
                                            let _e2136 = phi_5688_;
                                            let _e2139 = local_15.member_2[1u];
                                            if (_e2139[0] < 0f) {
                                                phi_5702_ = -(_e2139[0]);
                                            } else {
                                                phi_5702_ = _e2139[0];
                                            }
                                            let _e2146 = phi_5702_;
                                            if (_e2139[1] < 0f) {
                                                phi_5709_ = -(_e2139[1]);
                                            } else {
                                                phi_5709_ = _e2139[1];
                                            }
                                            let _e2150 = phi_5709_;
                                            if (_e2146 > _e2150) {
                                                phi_5714_ = _e2146;
                                            } else {
                                                phi_5714_ = _e2150;
                                            }
                                            let _e2153 = phi_5714_;
                                            if (_e2139[2] < 0f) {
                                                phi_5721_ = -(_e2139[2]);
                                            } else {
                                                phi_5721_ = _e2139[2];
                                            }
                                            let _e2157 = phi_5721_;
                                            if (_e2153 > _e2157) {
                                                phi_5726_ = _e2153;
                                            } else {
                                                phi_5726_ = _e2157;
                                            }
                                            let _e2160 = phi_5726_;
                                            if (_e2136 > _e2160) {
                                                phi_5731_ = _e2136;
                                            } else {
                                                phi_5731_ = _e2160;
                                            }
                                            let _e2163 = phi_5731_;
                                            let _e2165 = local_15.member_3;
                                            let _e2172 = local_15.member_3;
                                            phi_5747_ = type_28(0u, 48u);
                                            phi_5750_ = _e1219.member;
                                            loop {
                                                let _e2178 = phi_5747_;
                                                let _e2180 = phi_5750_;
                                                local_60 = _e2180;
                                                local_27 = _e2180;
                                                local_28 = _e2180;
                                                local_29 = _e2180;
                                                if (_e2178.member < _e2178.member_1) {
                                                    phi_5748_ = type_28((_e2178.member + 1u), _e2178.member_1);
                                                    phi_5773_ = type_28(1u, _e2178.member);
                                                } else {
                                                    phi_5748_ = _e2178;
                                                    phi_5773_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e2194 = phi_5748_;
                                                let _e2196 = phi_5773_;
                                                if (bitcast<i32>(_e2196.member) != 0i) {
                                                    let _e2202 = local_15.member[0u];
                                                    let _e2208 = local_15.member[1u];
                                                    let _e2218 = (_e2202[0] + ((_e2208[0] - _e2202[0]) * _e2180));
                                                    let _e2219 = (_e2202[1] + ((_e2208[1] - _e2202[1]) * _e2180));
                                                    let _e2220 = (_e2202[2] + ((_e2208[2] - _e2202[2]) * _e2180));
                                                    let _e2223 = local_15.member_1[0u];
                                                    let _e2229 = local_15.member_1[1u];
                                                    let _e2239 = (_e2223[0] + ((_e2229[0] - _e2223[0]) * _e2180));
                                                    let _e2240 = (_e2223[1] + ((_e2229[1] - _e2223[1]) * _e2180));
                                                    let _e2241 = (_e2223[2] + ((_e2229[2] - _e2223[2]) * _e2180));
                                                    let _e2244 = local_15.member_2[0u];
                                                    let _e2250 = local_15.member_2[1u];
                                                    let _e2260 = (_e2244[0] + ((_e2250[0] - _e2244[0]) * _e2180));
                                                    let _e2261 = (_e2244[1] + ((_e2250[1] - _e2244[1]) * _e2180));
                                                    let _e2262 = (_e2244[2] + ((_e2250[2] - _e2244[2]) * _e2180));
                                                    let _e2267 = (((_e2239 * _e2239) + (_e2240 * _e2240)) + (_e2241 * _e2241));
                                                    let _e2272 = (((_e2239 * _e2260) + (_e2240 * _e2261)) + (_e2241 * _e2262));
                                                    let _e2277 = (((_e2260 * _e2260) + (_e2261 * _e2261)) + (_e2262 * _e2262));
                                                    let _e2282 = (((_e2218 * _e2239) + (_e2219 * _e2240)) + (_e2220 * _e2241));
                                                    let _e2287 = (((_e2218 * _e2260) + (_e2219 * _e2261)) + (_e2220 * _e2262));
                                                    let _e2290 = ((_e2267 * _e2277) - (_e2272 * _e2272));
                                                    let _e2294 = (((_e2282 * _e2277) - (_e2287 * _e2272)) / _e2290);
                                                    let _e2298 = (((_e2287 * _e2267) - (_e2282 * _e2272)) / _e2290);
                                                    if (_e2294 >= 0f) {
                                                        if (_e2298 >= 0f) {
                                                            phi_5946_ = ((_e2294 + _e2298) <= 1f);
                                                            phi_5947_ = false;
                                                        } else {
                                                            phi_5946_ = bool();
                                                            phi_5947_ = true;
                                                        }
                                                        let _e2304 = phi_5946_;
                                                        let _e2306 = phi_5947_;
                                                        phi_5948_ = _e2304;
                                                        phi_5949_ = _e2306;
                                                    } else {
                                                        phi_5948_ = bool();
                                                        phi_5949_ = true;
                                                    }
                                                    let _e2308 = phi_5948_;
                                                    let _e2310 = phi_5949_;
                                                    if _e2310 {
                                                        let _e2311 = (_e2290 > 0f);
                                                        if _e2311 {
                                                            phi_5962_ = false;
                                                        } else {
                                                            phi_5962_ = true;
                                                        }
                                                        let _e2313 = phi_5962_;
                                                        phi_5963_ = false;
                                                        phi_5964_ = _e2313;
                                                        phi_5965_ = _e2311;
                                                    } else {
                                                        phi_5963_ = true;
                                                        phi_5964_ = false;
                                                        phi_5965_ = false;
                                                    }
                                                    let _e2315 = phi_5963_;
                                                    let _e2317 = phi_5964_;
                                                    let _e2319 = phi_5965_;
                                                    if _e2315 {
                                                        if (_e2290 > 0f) {
                                                            if _e2308 {
                                                                phi_5989_ = array<f32, 3>((_e2218 - ((_e2239 * _e2294) + (_e2260 * _e2298))), (_e2219 - ((_e2240 * _e2294) + (_e2261 * _e2298))), (_e2220 - ((_e2241 * _e2294) + (_e2262 * _e2298))));
                                                                phi_5990_ = false;
                                                            } else {
                                                                phi_5989_ = array<f32, 3>();
                                                                phi_5990_ = true;
                                                            }
                                                            let _e2335 = phi_5989_;
                                                            let _e2337 = phi_5990_;
                                                            phi_5991_ = _e2335;
                                                            phi_5992_ = false;
                                                            phi_5993_ = _e2337;
                                                        } else {
                                                            phi_5991_ = array<f32, 3>();
                                                            phi_5992_ = true;
                                                            phi_5993_ = false;
                                                        }
                                                        let _e2339 = phi_5991_;
                                                        let _e2341 = phi_5992_;
                                                        let _e2343 = phi_5993_;
                                                        phi_5994_ = _e2339;
                                                        phi_5995_ = _e2341;
                                                        phi_5996_ = _e2343;
                                                    } else {
                                                        phi_5994_ = array<f32, 3>();
                                                        phi_5995_ = _e2317;
                                                        phi_5996_ = _e2319;
                                                    }
                                                    let _e2345 = phi_5994_;
                                                    let _e2347 = phi_5995_;
                                                    let _e2349 = phi_5996_;
                                                    if _e2347 {
                                                        phi_6000_ = true;
                                                    } else {
                                                        phi_6000_ = _e2349;
                                                    }
                                                    let _e2351 = phi_6000_;
                                                    if _e2351 {
                                                        let _e2352 = (_e2218 - _e2239);
                                                        let _e2353 = (_e2219 - _e2240);
                                                        let _e2354 = (_e2220 - _e2241);
                                                        let _e2355 = (_e2260 - _e2239);
                                                        let _e2356 = (_e2261 - _e2240);
                                                        let _e2357 = (_e2262 - _e2241);
                                                        let _e2368 = ((((_e2352 * _e2355) + (_e2353 * _e2356)) + (_e2354 * _e2357)) / (((_e2355 * _e2355) + (_e2356 * _e2356)) + (_e2357 * _e2357)));
                                                        if (_e2368 > 0f) {
                                                            if (_e2368 < 1f) {
                                                                phi_6168_ = _e2368;
                                                            } else {
                                                                phi_6168_ = 1f;
                                                            }
                                                            let _e2372 = phi_6168_;
                                                            phi_6169_ = _e2372;
                                                        } else {
                                                            phi_6169_ = 0f;
                                                        }
                                                        let _e2374 = phi_6169_;
                                                        let _e2378 = (_e2352 - (_e2355 * _e2374));
                                                        let _e2379 = (_e2353 - (_e2356 * _e2374));
                                                        let _e2380 = (_e2354 - (_e2357 * _e2374));
                                                        let _e2391 = ((((_e2218 * _e2239) + (_e2219 * _e2240)) + (_e2220 * _e2241)) / (((_e2239 * _e2239) + (_e2240 * _e2240)) + (_e2241 * _e2241)));
                                                        if (_e2391 > 0f) {
                                                            if (_e2391 < 1f) {
                                                                phi_6196_ = _e2391;
                                                            } else {
                                                                phi_6196_ = 1f;
                                                            }
                                                            let _e2395 = phi_6196_;
                                                            phi_6197_ = _e2395;
                                                        } else {
                                                            phi_6197_ = 0f;
                                                        }
                                                        let _e2397 = phi_6197_;
                                                        let _e2414 = ((((_e2218 * _e2260) + (_e2219 * _e2261)) + (_e2220 * _e2262)) / (((_e2260 * _e2260) + (_e2261 * _e2261)) + (_e2262 * _e2262)));
                                                        if (_e2414 > 0f) {
                                                            if (_e2414 < 1f) {
                                                                phi_6224_ = _e2414;
                                                            } else {
                                                                phi_6224_ = 1f;
                                                            }
                                                            let _e2418 = phi_6224_;
                                                            phi_6225_ = _e2418;
                                                        } else {
                                                            phi_6225_ = 0f;
                                                        }
                                                        let _e2420 = phi_6225_;
                                                        local[0u] = array<f32, 3>((_e2218 - (_e2239 * _e2397)), (_e2219 - (_e2240 * _e2397)), (_e2220 - (_e2241 * _e2397)));
                                                        local[1u] = array<f32, 3>((_e2218 - (_e2260 * _e2420)), (_e2219 - (_e2261 * _e2420)), (_e2220 - (_e2262 * _e2420)));
                                                        local[2u] = array<f32, 3>(_e2378, _e2379, _e2380);
                                                        local[3u] = array<f32, 3>(_e2378, _e2379, _e2380);
                                                        let _e2436 = local[0u];
                                                        phi_6261_ = type_28(1u, 4u);
                                                        phi_6264_ = array<f32, 3>(_e2436[0], _e2436[1], _e2436[2]);
                                                        loop {
                                                            let _e2442 = phi_6261_;
                                                            let _e2444 = phi_6264_;
                                                            local_50 = _e2444;
                                                            if (_e2442.member < _e2442.member_1) {
                                                                phi_6262_ = type_28((_e2442.member + 1u), _e2442.member_1);
                                                                phi_6287_ = type_28(1u, _e2442.member);
                                                            } else {
                                                                phi_6262_ = _e2442;
                                                                phi_6287_ = type_28(0u, type_28().member_1);
                                                            }
                                                            let _e2458 = phi_6262_;
                                                            let _e2460 = phi_6287_;
                                                            let _e2464 = (bitcast<i32>(_e2460.member) != 0i);
                                                            if _e2464 {
                                                                if (_e2460.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2467 = local[_e2460.member_1];
                                                                if (_e2460.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2473 = local[_e2460.member_1];
                                                                if ((((_e2467[0] * _e2473[0]) + (_e2467[1] * _e2473[1])) + (_e2467[2] * _e2473[2])) < (((_e2444[0] * _e2444[0]) + (_e2444[1] * _e2444[1])) + (_e2444[2] * _e2444[2]))) {
                                                                    if (_e2460.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2496 = local[_e2460.member_1];
                                                                    phi_6354_ = array<f32, 3>(_e2496[0], _e2496[1], _e2496[2]);
                                                                } else {
                                                                    phi_6354_ = _e2444;
                                                                }
                                                                let _e2502 = phi_6354_;
                                                                phi_6265_ = _e2502;
                                                            } else {
                                                                phi_6265_ = array<f32, 3>();
                                                            }
                                                            let _e2504 = phi_6265_;
                                                            continue;
                                                            continuing {
                                                                phi_6261_ = _e2458;
                                                                phi_6264_ = _e2504;
                                                                break if !(_e2464);
                                                            }
                                                        }
                                                        let _e5032 = local_50;
                                                        phi_6355_ = _e5032;
                                                    } else {
                                                        phi_6355_ = _e2345;
                                                    }
                                                    let _e2507 = phi_6355_;
                                                    if (_e2507[0] < 0f) {
                                                        phi_6362_ = -(_e2507[0]);
                                                    } else {
                                                        phi_6362_ = _e2507[0];
                                                    }
                                                    let _e2512 = phi_6362_;
                                                    if (_e2507[1] < 0f) {
                                                        phi_6369_ = -(_e2507[1]);
                                                    } else {
                                                        phi_6369_ = _e2507[1];
                                                    }
                                                    let _e2517 = phi_6369_;
                                                    if (_e2507[2] < 0f) {
                                                        phi_6377_ = -(_e2507[2]);
                                                    } else {
                                                        phi_6377_ = _e2507[2];
                                                    }
                                                    let _e2523 = phi_6377_;
                                                    let _e2524 = ((_e2512 + _e2517) + _e2523);
                                                    if (_e2524 > 0f) {
                                                        if ((bitcast<u32>(_e2524) & 2139095040u) != 2139095040u) {
                                                            let _e2529 = (1f / _e2524);
                                                            let _e2531 = (_e2507[0] * _e2529);
                                                            let _e2533 = (_e2507[1] * _e2529);
                                                            let _e2535 = (_e2507[2] * _e2529);
                                                            let _e2540 = (((_e2531 * _e2531) + (_e2533 * _e2533)) + (_e2535 * _e2535));
                                                            if (_e2540 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2540 > 0f) {
                                                                    phi_6414_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6414_ = 0f;
                                                                }
                                                                let _e2599 = phi_6414_;
                                                                phi_6478_ = _e2599;
                                                            } else {
                                                                phi_6421_ = type_26(0i, 5i);
                                                                phi_6424_ = bitcast<f32>(((bitcast<u32>(_e2540) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2548 = phi_6421_;
                                                                    let _e2550 = phi_6424_;
                                                                    local_21 = _e2550;
                                                                    if (_e2548.member < _e2548.member_1) {
                                                                        let _e2558 = (_e2548.member + 1i);
                                                                        if ((false == (_e2558 > _e2548.member)) != false) {
                                                                            phi_6445_ = true;
                                                                        } else {
                                                                            phi_6445_ = false;
                                                                        }
                                                                        let _e2563 = phi_6445_;
                                                                        if _e2563 {
                                                                            phi_6451_ = type_27(0u, type_27().member_1);
                                                                        } else {
                                                                            phi_6451_ = type_27(1u, _e2558);
                                                                        }
                                                                        let _e2569 = phi_6451_;
                                                                        if (bitcast<i32>(_e2569.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_6422_ = type_26(_e2569.member_1, _e2548.member_1);
                                                                        phi_6465_ = type_27(1u, _e2548.member);
                                                                    } else {
                                                                        phi_6422_ = _e2548;
                                                                        phi_6465_ = type_27(0u, type_27().member_1);
                                                                    }
                                                                    let _e2579 = phi_6422_;
                                                                    let _e2581 = phi_6465_;
                                                                    let _e2584 = (bitcast<i32>(_e2581.member) != 0i);
                                                                    if _e2584 {
                                                                        phi_6425_ = (0.5f * (_e2550 + (_e2540 / _e2550)));
                                                                    } else {
                                                                        phi_6425_ = f32();
                                                                    }
                                                                    let _e2589 = phi_6425_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6421_ = _e2579;
                                                                        phi_6424_ = _e2589;
                                                                        break if !(_e2584);
                                                                    }
                                                                }
                                                                let _e2594 = local_21;
                                                                phi_6478_ = (_e2594 * (1f + (4f * 0.000000059604645f)));
                                                            }
                                                            let _e2601 = phi_6478_;
                                                            phi_6487_ = type_28(0u, 4u);
                                                            phi_6490_ = 2f;
                                                            loop {
                                                                let _e2609 = phi_6487_;
                                                                let _e2611 = phi_6490_;
                                                                local_23 = _e2611;
                                                                local_24 = _e2611;
                                                                local_25 = _e2611;
                                                                local_51 = _e2611;
                                                                local_52 = _e2611;
                                                                if (_e2609.member < _e2609.member_1) {
                                                                    phi_6488_ = type_28((_e2609.member + 1u), _e2609.member_1);
                                                                    phi_6513_ = type_28(1u, _e2609.member);
                                                                } else {
                                                                    phi_6488_ = _e2609;
                                                                    phi_6513_ = type_28(0u, type_28().member_1);
                                                                }
                                                                let _e2625 = phi_6488_;
                                                                let _e2627 = phi_6513_;
                                                                if (bitcast<i32>(_e2627.member) != 0i) {
                                                                    if (_e2627.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2634 = local_1[_e2627.member_1];
                                                                    let _e2642 = (((_e2531 * _e2634[0]) + (_e2533 * _e2634[1])) + (_e2535 * _e2634[2]));
                                                                    if (_e2627.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2645 = local_2[_e2627.member_1];
                                                                    let _e2653 = (((_e2531 * _e2645[0]) + (_e2533 * _e2645[1])) + (_e2535 * _e2645[2]));
                                                                    if (_e2642 < 0f) {
                                                                        phi_6564_ = -(_e2642);
                                                                    } else {
                                                                        phi_6564_ = _e2642;
                                                                    }
                                                                    let _e2657 = phi_6564_;
                                                                    if (_e2653 < 0f) {
                                                                        phi_6570_ = -(_e2653);
                                                                    } else {
                                                                        phi_6570_ = _e2653;
                                                                    }
                                                                    let _e2661 = phi_6570_;
                                                                    let _e2665 = (((((((((_e2055 + _e2057) + (_e2109 + _e2111)) + (_e2163 + _e2165)) * (0.000000059604645f * 16f)) + (_e2172 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2601) * (1f + (0.000000059604645f * 8f)))) + ((_e2657 + _e2661) * (0.000000059604645f * 8f)));
                                                                    if (_e2642 > _e2665) {
                                                                        if (_e2653 > _e2665) {
                                                                            phi_6583_ = false;
                                                                        } else {
                                                                            phi_6583_ = true;
                                                                        }
                                                                        let _e2669 = phi_6583_;
                                                                        phi_6584_ = _e2669;
                                                                    } else {
                                                                        phi_6584_ = true;
                                                                    }
                                                                    let _e2671 = phi_6584_;
                                                                    if _e2671 {
                                                                        let _e2675 = ((_e2642 + ((_e2653 - _e2642) * _e2180)) > _e2665);
                                                                        if _e2675 {
                                                                            if (_e2653 < _e2642) {
                                                                                let _e2682 = (((_e2642 - _e2665) / (_e2642 - _e2653)) * (1f - (0.000000059604645f * 16f)));
                                                                                if (_e2611 < _e2682) {
                                                                                    phi_6609_ = _e2611;
                                                                                } else {
                                                                                    phi_6609_ = _e2682;
                                                                                }
                                                                                let _e2685 = phi_6609_;
                                                                                phi_6610_ = _e2685;
                                                                            } else {
                                                                                phi_6610_ = _e2611;
                                                                            }
                                                                            let _e2687 = phi_6610_;
                                                                            phi_6611_ = _e2687;
                                                                        } else {
                                                                            phi_6611_ = f32();
                                                                        }
                                                                        let _e2689 = phi_6611_;
                                                                        phi_6612_ = _e2689;
                                                                        phi_6613_ = _e2675;
                                                                    } else {
                                                                        phi_6612_ = _e2611;
                                                                        phi_6613_ = true;
                                                                    }
                                                                    let _e2691 = phi_6612_;
                                                                    let _e2693 = phi_6613_;
                                                                    phi_6491_ = _e2691;
                                                                    phi_6614_ = _e2693;
                                                                    phi_6615_ = false;
                                                                } else {
                                                                    phi_6491_ = f32();
                                                                    phi_6614_ = false;
                                                                    phi_6615_ = true;
                                                                }
                                                                let _e2695 = phi_6491_;
                                                                let _e2697 = phi_6614_;
                                                                let _e2699 = phi_6615_;
                                                                local_22 = _e2699;
                                                                continue;
                                                                continuing {
                                                                    phi_6487_ = _e2625;
                                                                    phi_6490_ = _e2695;
                                                                    break if !(_e2697);
                                                                }
                                                            }
                                                            let _e2702 = local_22;
                                                            if _e2702 {
                                                                let _e2704 = local_23;
                                                                let _e2705 = (_e2704 > _e1219.member_1);
                                                                if _e2705 {
                                                                    phi_6636_ = false;
                                                                    phi_6637_ = false;
                                                                    phi_6638_ = false;
                                                                } else {
                                                                    let _e2707 = local_24;
                                                                    if (_e2707 > _e2180) {
                                                                        let _e2710 = local_25;
                                                                        let _e2712 = ((_e2710 - _e2180) < 0.00000000023283064f);
                                                                        if _e2712 {
                                                                            phi_6632_ = false;
                                                                        } else {
                                                                            phi_6632_ = true;
                                                                        }
                                                                        let _e2714 = phi_6632_;
                                                                        phi_6633_ = _e2714;
                                                                        phi_6634_ = _e2712;
                                                                        phi_6635_ = false;
                                                                    } else {
                                                                        phi_6633_ = false;
                                                                        phi_6634_ = false;
                                                                        phi_6635_ = true;
                                                                    }
                                                                    let _e2716 = phi_6633_;
                                                                    let _e2718 = phi_6634_;
                                                                    let _e2720 = phi_6635_;
                                                                    phi_6636_ = _e2716;
                                                                    phi_6637_ = _e2718;
                                                                    phi_6638_ = _e2720;
                                                                }
                                                                let _e2722 = phi_6636_;
                                                                let _e2724 = phi_6637_;
                                                                let _e2726 = phi_6638_;
                                                                phi_6639_ = _e2722;
                                                                phi_6640_ = _e2705;
                                                                phi_6641_ = _e2724;
                                                                phi_6642_ = _e2726;
                                                                phi_6643_ = false;
                                                            } else {
                                                                phi_6639_ = false;
                                                                phi_6640_ = false;
                                                                phi_6641_ = false;
                                                                phi_6642_ = false;
                                                                phi_6643_ = true;
                                                            }
                                                            let _e2728 = phi_6639_;
                                                            let _e2730 = phi_6640_;
                                                            let _e2732 = phi_6641_;
                                                            let _e2734 = phi_6642_;
                                                            let _e2736 = phi_6643_;
                                                            let _e5080 = local_51;
                                                            phi_6644_ = _e5080;
                                                            let _e5083 = local_52;
                                                            phi_6645_ = _e5083;
                                                            phi_6646_ = _e2728;
                                                            phi_6647_ = _e2730;
                                                            phi_6648_ = _e2732;
                                                            phi_6649_ = _e2734;
                                                            phi_6650_ = _e2736;
                                                            phi_6651_ = false;
                                                        } else {
                                                            phi_6644_ = f32();
                                                            phi_6645_ = f32();
                                                            phi_6646_ = false;
                                                            phi_6647_ = false;
                                                            phi_6648_ = false;
                                                            phi_6649_ = false;
                                                            phi_6650_ = false;
                                                            phi_6651_ = true;
                                                        }
                                                        let _e2738 = phi_6644_;
                                                        let _e2740 = phi_6645_;
                                                        let _e2742 = phi_6646_;
                                                        let _e2744 = phi_6647_;
                                                        let _e2746 = phi_6648_;
                                                        let _e2748 = phi_6649_;
                                                        let _e2750 = phi_6650_;
                                                        let _e2752 = phi_6651_;
                                                        phi_6652_ = _e2738;
                                                        phi_6653_ = _e2740;
                                                        phi_6654_ = _e2742;
                                                        phi_6655_ = _e2744;
                                                        phi_6656_ = _e2746;
                                                        phi_6657_ = _e2748;
                                                        phi_6658_ = _e2750;
                                                        phi_6659_ = _e2752;
                                                        phi_6660_ = false;
                                                    } else {
                                                        phi_6652_ = f32();
                                                        phi_6653_ = f32();
                                                        phi_6654_ = false;
                                                        phi_6655_ = false;
                                                        phi_6656_ = false;
                                                        phi_6657_ = false;
                                                        phi_6658_ = false;
                                                        phi_6659_ = false;
                                                        phi_6660_ = true;
                                                    }
                                                    let _e2754 = phi_6652_;
                                                    let _e2756 = phi_6653_;
                                                    let _e2758 = phi_6654_;
                                                    let _e2760 = phi_6655_;
                                                    let _e2762 = phi_6656_;
                                                    let _e2764 = phi_6657_;
                                                    let _e2766 = phi_6658_;
                                                    let _e2768 = phi_6659_;
                                                    let _e2770 = phi_6660_;
                                                    phi_6661_ = _e2754;
                                                    phi_5751_ = _e2756;
                                                    phi_6662_ = _e2758;
                                                    phi_6663_ = _e2760;
                                                    phi_6664_ = _e2762;
                                                    phi_6665_ = false;
                                                    phi_6666_ = _e2764;
                                                    phi_6667_ = _e2766;
                                                    phi_6668_ = _e2768;
                                                    phi_6669_ = _e2770;
                                                } else {
                                                    phi_6661_ = f32();
                                                    phi_5751_ = f32();
                                                    phi_6662_ = false;
                                                    phi_6663_ = false;
                                                    phi_6664_ = false;
                                                    phi_6665_ = true;
                                                    phi_6666_ = false;
                                                    phi_6667_ = false;
                                                    phi_6668_ = false;
                                                    phi_6669_ = false;
                                                }
                                                let _e2772 = phi_6661_;
                                                let _e2774 = phi_5751_;
                                                let _e2776 = phi_6662_;
                                                let _e2778 = phi_6663_;
                                                let _e2780 = phi_6664_;
                                                let _e2782 = phi_6665_;
                                                let _e2784 = phi_6666_;
                                                let _e2786 = phi_6667_;
                                                let _e2788 = phi_6668_;
                                                let _e2790 = phi_6669_;
                                                local_26 = _e2778;
                                                local_53 = _e2780;
                                                local_54 = _e2782;
                                                local_55 = _e2784;
                                                local_56 = _e2786;
                                                local_57 = _e2788;
                                                local_58 = _e2790;
                                                local_59 = _e2772;
                                                local_61 = _e2778;
                                                continue;
                                                continuing {
                                                    phi_5747_ = _e2194;
                                                    phi_5750_ = _e2774;
                                                    break if !(_e2776);
                                                }
                                            }
                                            let _e2793 = local_26;
                                            if _e2793 {
                                                phi_6674_ = type_55(0u, type_55().member_1);
                                                phi_6675_ = false;
                                                phi_6676_ = false;
                                                phi_6677_ = false;
                                                phi_6678_ = false;
                                                phi_6679_ = false;
                                                phi_6680_ = false;
                                            } else {
                                                phi_6674_ = type_55();
                                                let _e5113 = local_53;
                                                phi_6675_ = _e5113;
                                                let _e5116 = local_54;
                                                phi_6676_ = _e5116;
                                                let _e5119 = local_55;
                                                phi_6677_ = _e5119;
                                                let _e5122 = local_56;
                                                phi_6678_ = _e5122;
                                                let _e5125 = local_57;
                                                phi_6679_ = _e5125;
                                                let _e5128 = local_58;
                                                phi_6680_ = _e5128;
                                            }
                                            let _e2798 = phi_6674_;
                                            let _e2800 = phi_6675_;
                                            let _e2802 = phi_6676_;
                                            let _e2804 = phi_6677_;
                                            let _e2806 = phi_6678_;
                                            let _e2808 = phi_6679_;
                                            let _e2810 = phi_6680_;
                                            if _e2800 {
                                                let _e5131 = local_59;
                                                phi_6684_ = _e5131;
                                                phi_6685_ = true;
                                                phi_6686_ = false;
                                                phi_6687_ = false;
                                                phi_6688_ = false;
                                                phi_6689_ = false;
                                                phi_6690_ = false;
                                            } else {
                                                let _e5133 = local_60;
                                                phi_6684_ = _e5133;
                                                phi_6685_ = _e2802;
                                                phi_6686_ = _e2804;
                                                phi_6687_ = _e2806;
                                                let _e5139 = local_61;
                                                phi_6688_ = _e5139;
                                                phi_6689_ = _e2808;
                                                phi_6690_ = _e2810;
                                            }
                                            let _e2812 = phi_6684_;
                                            let _e2814 = phi_6685_;
                                            let _e2816 = phi_6686_;
                                            let _e2818 = phi_6687_;
                                            let _e2820 = phi_6688_;
                                            let _e2822 = phi_6689_;
                                            let _e2824 = phi_6690_;
                                            if _e2814 {
                                                phi_6695_ = type_55(1u, _e2812);
                                                phi_6696_ = false;
                                                phi_6697_ = false;
                                                phi_6698_ = false;
                                                phi_6699_ = false;
                                                phi_6700_ = false;
                                            } else {
                                                phi_6695_ = type_55();
                                                phi_6696_ = _e2816;
                                                phi_6697_ = _e2818;
                                                phi_6698_ = _e2820;
                                                phi_6699_ = _e2822;
                                                phi_6700_ = _e2824;
                                            }
                                            let _e2827 = phi_6695_;
                                            let _e2829 = phi_6696_;
                                            let _e2831 = phi_6697_;
                                            let _e2833 = phi_6698_;
                                            let _e2835 = phi_6699_;
                                            let _e2837 = phi_6700_;
                                            if _e2829 {
                                                let _e2839 = local_27;
                                                phi_6705_ = type_55(1u, _e2839);
                                                phi_6706_ = false;
                                                phi_6707_ = true;
                                                phi_6708_ = false;
                                                phi_6709_ = false;
                                            } else {
                                                phi_6705_ = _e2798;
                                                phi_6706_ = _e2831;
                                                phi_6707_ = _e2833;
                                                phi_6708_ = _e2835;
                                                phi_6709_ = _e2837;
                                            }
                                            let _e2842 = phi_6705_;
                                            let _e2844 = phi_6706_;
                                            let _e2846 = phi_6707_;
                                            let _e2848 = phi_6708_;
                                            let _e2850 = phi_6709_;
                                            if _e2844 {
                                                let _e2852 = local_28;
                                                phi_6714_ = type_55(1u, _e2852);
                                                phi_6715_ = true;
                                                phi_6716_ = false;
                                                phi_6717_ = false;
                                            } else {
                                                phi_6714_ = _e2842;
                                                phi_6715_ = _e2846;
                                                phi_6716_ = _e2848;
                                                phi_6717_ = _e2850;
                                            }
                                            let _e2855 = phi_6714_;
                                            let _e2857 = phi_6715_;
                                            let _e2859 = phi_6716_;
                                            let _e2861 = phi_6717_;
                                            if _e2857 {
                                                phi_6721_ = false;
                                                phi_6722_ = false;
                                            } else {
                                                phi_6721_ = _e2859;
                                                phi_6722_ = _e2861;
                                            }
                                            let _e2863 = phi_6721_;
                                            let _e2865 = phi_6722_;
                                            if _e2863 {
                                                phi_6726_ = false;
                                                phi_6727_ = false;
                                            } else {
                                                phi_6726_ = _e2865;
                                                phi_6727_ = _e2857;
                                            }
                                            let _e2867 = phi_6726_;
                                            let _e2869 = phi_6727_;
                                            if _e2867 {
                                                phi_6731_ = true;
                                                phi_6732_ = false;
                                            } else {
                                                phi_6731_ = _e2863;
                                                phi_6732_ = _e2869;
                                            }
                                            let _e2871 = phi_6731_;
                                            let _e2873 = phi_6732_;
                                            if _e2871 {
                                                let _e2875 = local_29;
                                                phi_6737_ = type_55(1u, _e2875);
                                                phi_6738_ = true;
                                            } else {
                                                phi_6737_ = _e2855;
                                                phi_6738_ = _e2873;
                                            }
                                            let _e2878 = phi_6737_;
                                            let _e2880 = phi_6738_;
                                            if _e2880 {
                                                phi_6742_ = _e2878;
                                            } else {
                                                phi_6742_ = _e2827;
                                            }
                                            let _e2882 = phi_6742_;
                                            let _e2885 = (_e2882.member != 0u);
                                            if _e2885 {
                                                phi_6749_ = false;
                                            } else {
                                                phi_6749_ = true;
                                            }
                                            let _e2887 = phi_6749_;
                                            phi_6750_ = _e2882.member_1;
                                            phi_6751_ = _e2887;
                                            phi_6752_ = _e2885;
                                            phi_6753_ = false;
                                        } else {
                                            phi_6750_ = f32();
                                            phi_6751_ = false;
                                            phi_6752_ = false;
                                            phi_6753_ = true;
                                        }
                                        let _e2889 = phi_6750_;
                                        let _e2891 = phi_6751_;
                                        let _e2893 = phi_6752_;
                                        let _e2895 = phi_6753_;
                                        phi_6754_ = _e2889;
                                        phi_6755_ = _e2891;
                                        phi_6756_ = _e2893;
                                        phi_6757_ = _e2895;
                                    }
                                    let _e2897 = phi_6754_;
                                    let _e2899 = phi_6755_;
                                    let _e2901 = phi_6756_;
                                    let _e2903 = phi_6757_;
                                    phi_6758_ = _e2897;
                                    phi_6759_ = _e1936;
                                    phi_6760_ = _e2899;
                                    phi_6761_ = _e2901;
                                    phi_6762_ = _e2903;
                                }
                                let _e2905 = phi_6758_;
                                let _e2907 = phi_6759_;
                                let _e2909 = phi_6760_;
                                let _e2911 = phi_6761_;
                                let _e2913 = phi_6762_;
                                if _e2907 {
                                    phi_6766_ = true;
                                    phi_6767_ = false;
                                    phi_6768_ = false;
                                } else {
                                    phi_6766_ = _e2909;
                                    phi_6767_ = _e2911;
                                    phi_6768_ = _e2913;
                                }
                                let _e2915 = phi_6766_;
                                let _e2917 = phi_6767_;
                                let _e2919 = phi_6768_;
                                phi_6769_ = _e2905;
                                phi_6770_ = _e1219;
                                phi_6771_ = _e2915;
                                phi_6772_ = false;
                                phi_6773_ = _e2917;
                                phi_6774_ = _e2919;
                            } else {
                                phi_6769_ = f32();
                                phi_6770_ = type_56();
                                phi_6771_ = false;
                                phi_6772_ = true;
                                phi_6773_ = false;
                                phi_6774_ = false;
                            }
                            let _e2921 = phi_6769_;
                            let _e2923 = phi_6770_;
                            let _e2925 = phi_6771_;
                            let _e2927 = phi_6772_;
                            let _e2929 = phi_6773_;
                            let _e2931 = phi_6774_;
                            local_30 = _e2927;
                            local_62 = _e2929;
                            local_63 = _e2931;
                            local_31 = _e2921;
                            local_32 = _e2923;
                            continue;
                            continuing {
                                phi_3818_ = _e904;
                                break if !(_e2925);
                            }
                        }
                        let _e2934 = local_30;
                        if _e2934 {
                            phi_6779_ = type_55(0u, type_55().member_1);
                            phi_6780_ = false;
                            phi_6781_ = false;
                        } else {
                            phi_6779_ = type_55();
                            let _e5196 = local_62;
                            phi_6780_ = _e5196;
                            let _e5199 = local_63;
                            phi_6781_ = _e5199;
                        }
                        let _e2939 = phi_6779_;
                        let _e2941 = phi_6780_;
                        let _e2943 = phi_6781_;
                        if _e2941 {
                            let _e2945 = local_31;
                            phi_6786_ = type_55(2u, _e2945);
                            phi_6787_ = false;
                        } else {
                            phi_6786_ = type_55();
                            phi_6787_ = _e2943;
                        }
                        let _e2948 = phi_6786_;
                        let _e2950 = phi_6787_;
                        if _e2950 {
                            let _e2952 = local_32;
                            phi_6793_ = type_55(1u, _e2952.member);
                            phi_6794_ = true;
                        } else {
                            phi_6793_ = _e2948;
                            phi_6794_ = _e2941;
                        }
                        let _e2956 = phi_6793_;
                        let _e2958 = phi_6794_;
                        if _e2958 {
                            phi_6798_ = _e2956;
                        } else {
                            phi_6798_ = _e2939;
                        }
                        let _e2960 = phi_6798_;
                        phi_6802_ = _e2960;
                    }
                    let _e4519 = phi_6802_;
                    phi_6803_ = _e4519;
                }
                let _e4524 = phi_6803_;
                switch bitcast<i32>(_e4524.member) {
                    case 0: {
                        phi_6864_ = type_58(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4554 = bitcast<u32>(_e4524.member_1);
                        if (_e4554 < 8388608u) {
                            phi_6831_ = array<u32, 2>();
                            phi_6832_ = true;
                        } else {
                            let _e4558 = ((_e4554 >> bitcast<u32>(31i)) == 1u);
                            if _e4558 {
                                phi_6830_ = array<u32, 2>();
                            } else {
                                phi_6830_ = array<u32, 2>((_e4554 << bitcast<u32>(29i)), ((((_e4554 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e4554 & 8388607u) >> bitcast<u32>(3i))));
                            }
                            let _e4572 = phi_6830_;
                            phi_6831_ = _e4572;
                            phi_6832_ = _e4558;
                        }
                        let _e4574 = phi_6831_;
                        let _e4576 = phi_6832_;
                        if _e4576 {
                            phi_6836_ = array<u32, 2>(0u, 0u);
                        } else {
                            phi_6836_ = _e4574;
                        }
                        let _e4578 = phi_6836_;
                        phi_6864_ = type_58(0u, _e4578, true);
                        break;
                    }
                    case 2: {
                        let _e4528 = bitcast<u32>(_e4524.member_1);
                        if (_e4528 < 8388608u) {
                            phi_6857_ = array<u32, 2>();
                            phi_6858_ = true;
                        } else {
                            let _e4532 = ((_e4528 >> bitcast<u32>(31i)) == 1u);
                            if _e4532 {
                                phi_6856_ = array<u32, 2>();
                            } else {
                                phi_6856_ = array<u32, 2>((_e4528 << bitcast<u32>(29i)), ((((_e4528 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e4528 & 8388607u) >> bitcast<u32>(3i))));
                            }
                            let _e4546 = phi_6856_;
                            phi_6857_ = _e4546;
                            phi_6858_ = _e4532;
                        }
                        let _e4548 = phi_6857_;
                        let _e4550 = phi_6858_;
                        if _e4550 {
                            phi_6862_ = array<u32, 2>(0u, 0u);
                        } else {
                            phi_6862_ = _e4548;
                        }
                        let _e4552 = phi_6862_;
                        phi_6864_ = type_58(1u, _e4552, true);
                        break;
                    }
                    default: {
                        phi_6864_ = type_58();
                        break;
                    }
                }
                let _e4581 = phi_6864_;
                if _e4581.member_2 {
                    phi_6871_ = (_e4581.member == 0u);
                } else {
                    phi_6871_ = false;
                }
                let _e4586 = phi_6871_;
                let _e4588 = (_e4581.member != 0u);
                let _e4590 = type_48(_e175, 0u, _e194, _e197, _e4581.member_1);
                if _e4586 {
                    let _e4594 = (_e4581.member_1[1] >> bitcast<u32>(20i));
                    if (_e4594 <= 896u) {
                        phi_6895_ = 0u;
                    } else {
                        phi_6895_ = ((((_e4594 - 896u) << bitcast<u32>(23i)) | ((_e4581.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4581.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4609 = phi_6895_;
                    let _e4611 = atomicMin((&earliest.member[0u]), _e4609);
                }
                let _e4613 = params.member.member_1;
                let _e4615 = ((_e4613 & 16u) != 0u);
                if _e4615 {
                    if (_e106 == 0u) {
                        atomicStore((&counters[0u]), 0u);
                    }
                    workgroupBarrier();
                    if _e4586 {
                        let _e4619 = atomicAdd((&counters[0u]), 1u);
                        phi_6916_ = _e4619;
                    } else {
                        phi_6916_ = 0u;
                    }
                    let _e4621 = phi_6916_;
                    workgroupBarrier();
                    if (_e106 == 0u) {
                        let _e4624 = atomicLoad((&counters[0u]));
                        if (_e4624 > 0u) {
                            let _e4627 = atomicAdd((&contacts.member[0u]), _e4624);
                            atomicStore((&counters[1u]), _e4627);
                        }
                    }
                    workgroupBarrier();
                    let _e4630 = atomicLoad((&counters[1u]));
                    let _e4631 = (_e4630 + _e4621);
                    if _e4586 {
                        let _e4633 = params.member.member_16;
                        if (_e4631 < _e4633) {
                            let _e4635 = (6u * _e4631);
                            atomicStore((&contacts.member[(4u + _e4635)]), _e175);
                            atomicStore((&contacts.member[(_e4635 + 5u)]), 0u);
                            atomicStore((&contacts.member[(_e4635 + 6u)]), _e194);
                            atomicStore((&contacts.member[(_e4635 + 7u)]), _e197);
                            atomicStore((&contacts.member[(_e4635 + 8u)]), _e4581.member_1[0]);
                            atomicStore((&contacts.member[(_e4635 + 9u)]), _e4581.member_1[1]);
                        }
                    }
                }
                phi_6997_ = _e4590;
                phi_6998_ = _e4588;
                phi_6999_ = _e4590;
                phi_7000_ = _e4588;
                phi_7001_ = _e4615;
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
                phi_6997_ = _e176;
                phi_6998_ = false;
                phi_6999_ = _e176;
                phi_7000_ = false;
                phi_7001_ = _e181;
            }
            let _e4651 = phi_6997_;
            let _e4653 = phi_6998_;
            let _e4655 = phi_6999_;
            let _e4657 = phi_7000_;
            let _e4659 = phi_7001_;
            if _e4659 {
                phi_7005_ = false;
            } else {
                phi_7005_ = true;
            }
            let _e4661 = phi_7005_;
            if _e4661 {
                phi_7009_ = _e4655;
                phi_7010_ = _e4657;
            } else {
                phi_7009_ = _e4651;
                phi_7010_ = _e4653;
            }
            let _e4663 = phi_7009_;
            let _e4665 = phi_7010_;
            workgroupBarrier();
            if (_e106 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4665 {
                let _e4669 = atomicAdd((&counters[0u]), 1u);
                phi_7021_ = _e4669;
            } else {
                phi_7021_ = 0u;
            }
            let _e4671 = phi_7021_;
            workgroupBarrier();
            if (_e106 == 0u) {
                let _e4674 = atomicLoad((&counters[0u]));
                if (_e4674 > 0u) {
                    let _e4677 = atomicAdd((&undecided.member[0u]), _e4674);
                    atomicStore((&counters[1u]), _e4677);
                }
            }
            workgroupBarrier();
            let _e4680 = atomicLoad((&counters[1u]));
            let _e4681 = (_e4680 + _e4671);
            if _e4665 {
                atomicStore((&undecided.member[(4u + (2u * _e4681))]), _e4663.member_2);
                atomicStore((&undecided.member[((2u * _e4681) + 5u)]), _e4663.member_3);
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
fn decide_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
