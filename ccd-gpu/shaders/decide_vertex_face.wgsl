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
    var phi_3523_: f32;
    var phi_3529_: f32;
    var phi_3534_: f32;
    var phi_3540_: f32;
    var phi_3546_: f32;
    var phi_3551_: f32;
    var phi_3556_: f32;
    var phi_3596_: type_26;
    var phi_3599_: f32;
    var phi_3620_: bool;
    var phi_3626_: type_27;
    var phi_3597_: type_26;
    var phi_3640_: type_27;
    var phi_3600_: f32;
    var local_16: f32;
    var phi_3589_: f32;
    var phi_3653_: f32;
    var phi_3659_: f32;
    var phi_3684_: type_28;
    var phi_3687_: u32;
    var phi_3685_: type_28;
    var phi_3710_: type_28;
    var phi_3754_: u32;
    var phi_3755_: u32;
    var phi_3688_: u32;
    var phi_3756_: u32;
    var phi_3776_: type_28;
    var phi_3777_: type_28;
    var phi_3800_: type_28;
    var phi_3852_: f32;
    var phi_3859_: f32;
    var phi_3870_: bool;
    var phi_3871_: bool;
    var phi_3872_: bool;
    var phi_3873_: bool;
    var phi_3877_: bool;
    var phi_3888_: type_56;
    var phi_3889_: type_56;
    var phi_3890_: bool;
    var phi_3891_: type_56;
    var phi_3892_: bool;
    var phi_3903_: f32;
    var phi_3913_: type_28;
    var phi_3916_: f32;
    var phi_3918_: f32;
    var phi_3920_: f32;
    var phi_3914_: type_28;
    var phi_3943_: type_28;
    var phi_3968_: f32;
    var phi_3969_: f32;
    var phi_3995_: f32;
    var phi_4011_: f32;
    var phi_4018_: bool;
    var phi_4019_: bool;
    var phi_4020_: bool;
    var phi_4026_: f32;
    var phi_4027_: f32;
    var phi_4028_: bool;
    var phi_3917_: f32;
    var phi_3919_: f32;
    var phi_3921_: f32;
    var phi_4029_: f32;
    var phi_4030_: bool;
    var phi_4031_: bool;
    var local_17: bool;
    var phi_4035_: f32;
    var phi_4036_: f32;
    var phi_4043_: type_28;
    var phi_4046_: f32;
    var phi_4044_: type_28;
    var phi_4069_: type_28;
    var phi_4110_: f32;
    var phi_4120_: f32;
    var phi_4128_: bool;
    var phi_4130_: bool;
    var phi_4135_: f32;
    var phi_4136_: bool;
    var phi_4137_: f32;
    var phi_4138_: bool;
    var phi_4139_: bool;
    var phi_4140_: bool;
    var phi_4141_: f32;
    var phi_4047_: f32;
    var phi_4142_: bool;
    var phi_4143_: bool;
    var phi_4144_: bool;
    var phi_4145_: bool;
    var local_18: bool;
    var phi_4149_: bool;
    var phi_4150_: bool;
    var phi_4154_: bool;
    var phi_4158_: f32;
    var phi_4159_: f32;
    var phi_4161_: type_56;
    var phi_4190_: f32;
    var phi_4197_: f32;
    var phi_4202_: f32;
    var phi_4209_: f32;
    var phi_4214_: f32;
    var phi_4227_: f32;
    var phi_4234_: f32;
    var phi_4239_: f32;
    var phi_4246_: f32;
    var phi_4251_: f32;
    var phi_4256_: f32;
    var phi_4315_: f32;
    var phi_4321_: f32;
    var phi_4326_: f32;
    var phi_4332_: f32;
    var phi_4337_: f32;
    var phi_4349_: f32;
    var phi_4355_: f32;
    var phi_4360_: f32;
    var phi_4366_: f32;
    var phi_4371_: f32;
    var phi_4397_: f32;
    var phi_4404_: f32;
    var phi_4409_: f32;
    var phi_4416_: f32;
    var phi_4421_: f32;
    var phi_4434_: f32;
    var phi_4441_: f32;
    var phi_4446_: f32;
    var phi_4453_: f32;
    var phi_4458_: f32;
    var phi_4463_: f32;
    var phi_4522_: f32;
    var phi_4528_: f32;
    var phi_4533_: f32;
    var phi_4539_: f32;
    var phi_4544_: f32;
    var phi_4556_: f32;
    var phi_4562_: f32;
    var phi_4567_: f32;
    var phi_4573_: f32;
    var phi_4578_: f32;
    var phi_4604_: f32;
    var phi_4611_: f32;
    var phi_4616_: f32;
    var phi_4623_: f32;
    var phi_4628_: f32;
    var phi_4641_: f32;
    var phi_4648_: f32;
    var phi_4653_: f32;
    var phi_4660_: f32;
    var phi_4665_: f32;
    var phi_4670_: f32;
    var phi_4729_: f32;
    var phi_4735_: f32;
    var phi_4740_: f32;
    var phi_4746_: f32;
    var phi_4751_: f32;
    var phi_4763_: f32;
    var phi_4769_: f32;
    var phi_4774_: f32;
    var phi_4780_: f32;
    var phi_4785_: f32;
    var phi_4834_: f32;
    var phi_4840_: f32;
    var phi_4868_: f32;
    var phi_4874_: f32;
    var phi_4879_: u32;
    var phi_4880_: u32;
    var phi_4850_: f32;
    var phi_4856_: f32;
    var phi_4861_: u32;
    var phi_4862_: u32;
    var phi_4881_: u32;
    var phi_4882_: u32;
    var phi_4949_: f32;
    var phi_4958_: f32;
    var phi_5089_: f32;
    var phi_5095_: f32;
    var phi_5102_: f32;
    var phi_5145_: type_28;
    var phi_5148_: bool;
    var phi_5146_: type_28;
    var phi_5171_: type_28;
    var phi_5198_: bool;
    var phi_5199_: bool;
    var phi_5149_: bool;
    var phi_5200_: bool;
    var phi_5201_: bool;
    var local_19: bool;
    var phi_5205_: bool;
    var local_20: bool;
    var phi_5212_: u32;
    var phi_5213_: u32;
    var phi_5214_: bool;
    var phi_5215_: u32;
    var phi_5216_: u32;
    var phi_5217_: bool;
    var phi_5221_: u32;
    var phi_5241_: bool;
    var phi_5242_: bool;
    var phi_5243_: bool;
    var phi_5439_: f32;
    var phi_5446_: f32;
    var phi_5451_: f32;
    var phi_5458_: f32;
    var phi_5463_: f32;
    var phi_5476_: f32;
    var phi_5483_: f32;
    var phi_5488_: f32;
    var phi_5495_: f32;
    var phi_5500_: f32;
    var phi_5505_: f32;
    var phi_5522_: f32;
    var phi_5529_: f32;
    var phi_5534_: f32;
    var phi_5541_: f32;
    var phi_5546_: f32;
    var phi_5560_: f32;
    var phi_5567_: f32;
    var phi_5572_: f32;
    var phi_5579_: f32;
    var phi_5584_: f32;
    var phi_5589_: f32;
    var phi_5606_: f32;
    var phi_5613_: f32;
    var phi_5618_: f32;
    var phi_5625_: f32;
    var phi_5630_: f32;
    var phi_5644_: f32;
    var phi_5651_: f32;
    var phi_5656_: f32;
    var phi_5663_: f32;
    var phi_5668_: f32;
    var phi_5673_: f32;
    var phi_5689_: type_28;
    var phi_5692_: f32;
    var phi_5690_: type_28;
    var phi_5715_: type_28;
    var phi_5889_: bool;
    var phi_5890_: bool;
    var phi_5891_: bool;
    var phi_5892_: bool;
    var phi_5896_: bool;
    var phi_5918_: array<f32, 3>;
    var phi_5919_: bool;
    var phi_5920_: array<f32, 3>;
    var phi_5921_: bool;
    var phi_6089_: f32;
    var phi_6090_: f32;
    var phi_6117_: f32;
    var phi_6118_: f32;
    var phi_6145_: f32;
    var phi_6146_: f32;
    var phi_6182_: type_28;
    var phi_6185_: array<f32, 3>;
    var phi_6183_: type_28;
    var phi_6208_: type_28;
    var phi_6275_: array<f32, 3>;
    var phi_6186_: array<f32, 3>;
    var phi_6276_: array<f32, 3>;
    var phi_6283_: f32;
    var phi_6290_: f32;
    var phi_6298_: f32;
    var phi_6342_: type_26;
    var phi_6345_: f32;
    var phi_6366_: bool;
    var phi_6372_: type_27;
    var phi_6343_: type_26;
    var phi_6386_: type_27;
    var phi_6346_: f32;
    var local_21: f32;
    var phi_6335_: f32;
    var phi_6399_: f32;
    var phi_6408_: type_28;
    var phi_6411_: f32;
    var phi_6409_: type_28;
    var phi_6434_: type_28;
    var phi_6485_: f32;
    var phi_6491_: f32;
    var phi_6504_: bool;
    var phi_6505_: bool;
    var phi_6530_: f32;
    var phi_6531_: f32;
    var phi_6532_: f32;
    var phi_6533_: f32;
    var phi_6534_: bool;
    var phi_6412_: f32;
    var phi_6535_: bool;
    var phi_6536_: bool;
    var local_22: bool;
    var local_23: f32;
    var local_24: f32;
    var local_25: f32;
    var phi_6553_: bool;
    var phi_6554_: bool;
    var phi_6555_: bool;
    var phi_6556_: bool;
    var phi_6557_: bool;
    var phi_6558_: bool;
    var phi_6559_: bool;
    var phi_6560_: bool;
    var phi_6561_: bool;
    var phi_6562_: bool;
    var phi_6563_: bool;
    var phi_6564_: bool;
    var phi_6565_: f32;
    var phi_6566_: f32;
    var phi_6567_: bool;
    var phi_6568_: bool;
    var phi_6569_: bool;
    var phi_6570_: bool;
    var phi_6571_: bool;
    var phi_6572_: bool;
    var phi_6573_: f32;
    var phi_6574_: f32;
    var phi_6575_: bool;
    var phi_6576_: bool;
    var phi_6577_: bool;
    var phi_6578_: bool;
    var phi_6579_: bool;
    var phi_6580_: bool;
    var phi_6581_: bool;
    var phi_6582_: f32;
    var phi_5693_: f32;
    var phi_6583_: bool;
    var phi_6584_: bool;
    var phi_6585_: bool;
    var phi_6586_: bool;
    var phi_6587_: bool;
    var phi_6588_: bool;
    var phi_6589_: bool;
    var phi_6590_: bool;
    var local_26: bool;
    var phi_6595_: type_55;
    var phi_6596_: bool;
    var phi_6597_: bool;
    var phi_6598_: bool;
    var phi_6599_: bool;
    var phi_6600_: bool;
    var phi_6601_: bool;
    var phi_6605_: f32;
    var phi_6606_: bool;
    var phi_6607_: bool;
    var phi_6608_: bool;
    var phi_6609_: bool;
    var phi_6610_: bool;
    var phi_6611_: bool;
    var phi_6616_: type_55;
    var phi_6617_: bool;
    var phi_6618_: bool;
    var phi_6619_: bool;
    var phi_6620_: bool;
    var phi_6621_: bool;
    var local_27: f32;
    var phi_6626_: type_55;
    var phi_6627_: bool;
    var phi_6628_: bool;
    var phi_6629_: bool;
    var phi_6630_: bool;
    var local_28: f32;
    var phi_6635_: type_55;
    var phi_6636_: bool;
    var phi_6637_: bool;
    var phi_6638_: bool;
    var phi_6642_: bool;
    var phi_6643_: bool;
    var phi_6647_: bool;
    var phi_6648_: bool;
    var phi_6652_: bool;
    var phi_6653_: bool;
    var local_29: f32;
    var phi_6658_: type_55;
    var phi_6659_: bool;
    var phi_6663_: type_55;
    var phi_6670_: bool;
    var phi_6671_: f32;
    var phi_6672_: bool;
    var phi_6673_: bool;
    var phi_6674_: bool;
    var phi_6675_: f32;
    var phi_6676_: bool;
    var phi_6677_: bool;
    var phi_6678_: bool;
    var phi_6679_: f32;
    var phi_6680_: bool;
    var phi_6681_: bool;
    var phi_6682_: bool;
    var phi_6683_: bool;
    var phi_6687_: bool;
    var phi_6688_: bool;
    var phi_6689_: bool;
    var phi_6690_: f32;
    var phi_6691_: type_56;
    var phi_6692_: bool;
    var phi_6693_: bool;
    var phi_6694_: bool;
    var phi_6695_: bool;
    var local_30: bool;
    var phi_6700_: type_55;
    var phi_6701_: bool;
    var phi_6702_: bool;
    var local_31: f32;
    var phi_6707_: type_55;
    var phi_6708_: bool;
    var local_32: type_56;
    var phi_6714_: type_55;
    var phi_6715_: bool;
    var phi_6719_: type_55;
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
    var phi_1745_: bool;
    var phi_1746_: bool;
    var phi_1747_: bool;
    var phi_1748_: bool;
    var phi_1752_: bool;
    var phi_1774_: array<f32, 3>;
    var phi_1775_: bool;
    var phi_1776_: array<f32, 3>;
    var phi_1777_: bool;
    var phi_1945_: f32;
    var phi_1946_: f32;
    var phi_1973_: f32;
    var phi_1974_: f32;
    var phi_2001_: f32;
    var phi_2002_: f32;
    var phi_2038_: type_28;
    var phi_2041_: array<f32, 3>;
    var phi_2039_: type_28;
    var phi_2064_: type_28;
    var phi_2131_: array<f32, 3>;
    var phi_2042_: array<f32, 3>;
    var phi_2132_: array<f32, 3>;
    var phi_2139_: f32;
    var phi_2146_: f32;
    var phi_2154_: f32;
    var phi_2198_: type_26;
    var phi_2201_: f32;
    var phi_2222_: bool;
    var phi_2228_: type_27;
    var phi_2199_: type_26;
    var phi_2242_: type_27;
    var phi_2202_: f32;
    var local_33: f32;
    var phi_2191_: f32;
    var phi_2255_: f32;
    var phi_2264_: type_28;
    var phi_2267_: f32;
    var phi_2265_: type_28;
    var phi_2290_: type_28;
    var phi_2341_: f32;
    var phi_2347_: f32;
    var phi_2360_: bool;
    var phi_2361_: bool;
    var phi_2386_: f32;
    var phi_2387_: f32;
    var phi_2388_: f32;
    var phi_2389_: f32;
    var phi_2390_: bool;
    var phi_2268_: f32;
    var phi_2391_: bool;
    var phi_2392_: bool;
    var local_34: bool;
    var local_35: f32;
    var local_36: f32;
    var local_37: f32;
    var phi_2409_: bool;
    var phi_2410_: bool;
    var phi_2411_: bool;
    var phi_2412_: bool;
    var phi_2413_: bool;
    var phi_2414_: bool;
    var phi_2415_: bool;
    var phi_2416_: bool;
    var phi_2417_: bool;
    var phi_2418_: bool;
    var phi_2419_: bool;
    var phi_2420_: bool;
    var phi_2421_: f32;
    var phi_2422_: f32;
    var phi_2423_: bool;
    var phi_2424_: bool;
    var phi_2425_: bool;
    var phi_2426_: bool;
    var phi_2427_: bool;
    var phi_2428_: bool;
    var phi_2429_: f32;
    var phi_2430_: f32;
    var phi_2431_: bool;
    var phi_2432_: bool;
    var phi_2433_: bool;
    var phi_2434_: bool;
    var phi_2435_: bool;
    var phi_2436_: bool;
    var phi_2437_: bool;
    var phi_2438_: f32;
    var phi_1549_: f32;
    var phi_2439_: bool;
    var phi_2440_: bool;
    var phi_2441_: bool;
    var phi_2442_: bool;
    var phi_2443_: bool;
    var phi_2444_: bool;
    var phi_2445_: bool;
    var phi_2446_: bool;
    var local_38: bool;
    var phi_2451_: type_55;
    var phi_2452_: bool;
    var phi_2453_: bool;
    var phi_2454_: bool;
    var phi_2455_: bool;
    var phi_2456_: bool;
    var phi_2457_: bool;
    var phi_2461_: f32;
    var phi_2462_: bool;
    var phi_2463_: bool;
    var phi_2464_: bool;
    var phi_2465_: bool;
    var phi_2466_: bool;
    var phi_2467_: bool;
    var phi_2472_: type_55;
    var phi_2473_: bool;
    var phi_2474_: bool;
    var phi_2475_: bool;
    var phi_2476_: bool;
    var phi_2477_: bool;
    var local_39: f32;
    var phi_2482_: type_55;
    var phi_2483_: bool;
    var phi_2484_: bool;
    var phi_2485_: bool;
    var phi_2486_: bool;
    var local_40: f32;
    var phi_2491_: type_55;
    var phi_2492_: bool;
    var phi_2493_: bool;
    var phi_2494_: bool;
    var phi_2498_: bool;
    var phi_2499_: bool;
    var phi_2503_: bool;
    var phi_2504_: bool;
    var phi_2508_: bool;
    var phi_2509_: bool;
    var local_41: f32;
    var phi_2514_: type_55;
    var phi_2515_: bool;
    var phi_2519_: type_55;
    var phi_2533_: type_28;
    var phi_2534_: type_28;
    var phi_2557_: type_28;
    var phi_2577_: f32;
    var phi_2745_: bool;
    var phi_2746_: bool;
    var phi_2747_: bool;
    var phi_2748_: bool;
    var phi_2752_: bool;
    var phi_2774_: array<f32, 3>;
    var phi_2775_: bool;
    var phi_2776_: array<f32, 3>;
    var phi_2777_: bool;
    var phi_2945_: f32;
    var phi_2946_: f32;
    var phi_2973_: f32;
    var phi_2974_: f32;
    var phi_3001_: f32;
    var phi_3002_: f32;
    var phi_3038_: type_28;
    var phi_3041_: array<f32, 3>;
    var phi_3039_: type_28;
    var phi_3064_: type_28;
    var phi_3131_: array<f32, 3>;
    var phi_3042_: array<f32, 3>;
    var phi_3132_: array<f32, 3>;
    var phi_3164_: type_26;
    var phi_3167_: f32;
    var phi_3188_: bool;
    var phi_3194_: type_27;
    var phi_3165_: type_26;
    var phi_3208_: type_27;
    var phi_3168_: f32;
    var local_42: f32;
    var phi_3157_: f32;
    var phi_3221_: f32;
    var phi_3237_: f32;
    var phi_3244_: f32;
    var phi_3249_: f32;
    var phi_3256_: f32;
    var phi_3261_: f32;
    var phi_3274_: f32;
    var phi_3281_: f32;
    var phi_3286_: f32;
    var phi_3293_: f32;
    var phi_3298_: f32;
    var phi_3303_: f32;
    var phi_3320_: f32;
    var phi_3327_: f32;
    var phi_3332_: f32;
    var phi_3339_: f32;
    var phi_3344_: f32;
    var phi_3358_: f32;
    var phi_3365_: f32;
    var phi_3370_: f32;
    var phi_3377_: f32;
    var phi_3382_: f32;
    var phi_3387_: f32;
    var phi_3404_: f32;
    var phi_3411_: f32;
    var phi_3416_: f32;
    var phi_3423_: f32;
    var phi_3428_: f32;
    var phi_3442_: f32;
    var phi_3449_: f32;
    var phi_3454_: f32;
    var phi_3461_: f32;
    var phi_3466_: f32;
    var phi_3471_: f32;
    var phi_3491_: bool;
    var phi_3492_: bool;
    var phi_3493_: bool;
    var local_43: bool;
    var phi_3498_: type_55;
    var phi_3499_: bool;
    var phi_3504_: type_55;
    var phi_3505_: bool;
    var phi_3507_: type_55;
    var phi_3508_: type_55;
    var phi_3509_: bool;
    var phi_3513_: type_55;
    var phi_6723_: type_55;
    var phi_6724_: type_55;
    var phi_6777_: array<u32, 2>;
    var phi_6778_: array<u32, 2>;
    var phi_6779_: bool;
    var phi_6783_: array<u32, 2>;
    var phi_6751_: array<u32, 2>;
    var phi_6752_: array<u32, 2>;
    var phi_6753_: bool;
    var phi_6757_: array<u32, 2>;
    var phi_6785_: type_58;
    var phi_6792_: bool;
    var phi_6816_: u32;
    var phi_6820_: type_48;
    var phi_6821_: bool;
    var phi_6822_: bool;
    var phi_6840_: u32;
    var phi_6902_: u32;
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
                let _e186 = elements.member[_e184];
                let _e191 = paths.member[_e181];
                let _e193 = paths.member[_e186[0]];
                let _e199 = paths.member[_e186[1]];
                let _e201 = paths.member[_e186[2]];
                let _e231 = params.member.member_4;
                local_15 = type_45(array<array<f32, 3>, 2>(array<f32, 3>((_e191.member[0] - _e193.member[0]), (_e191.member[1] - _e193.member[1]), (_e191.member[2] - _e193.member[2])), array<f32, 3>((_e191.member_1[0] - _e193.member_1[0]), (_e191.member_1[1] - _e193.member_1[1]), (_e191.member_1[2] - _e193.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e199.member[0] - _e193.member[0]), (_e199.member[1] - _e193.member[1]), (_e199.member[2] - _e193.member[2])), array<f32, 3>((_e199.member_1[0] - _e193.member_1[0]), (_e199.member_1[1] - _e193.member_1[1]), (_e199.member_1[2] - _e193.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e201.member[0] - _e193.member[0]), (_e201.member[1] - _e193.member[1]), (_e201.member[2] - _e193.member[2])), array<f32, 3>((_e201.member_1[0] - _e193.member_1[0]), (_e201.member_1[1] - _e193.member_1[1]), (_e201.member_1[2] - _e193.member_1[2]))), (_e231 + _e231));
                let _e262 = params.member.member_5;
                let _e265 = local_15.member_1[0u];
                let _e271 = local_15.member_2[0u];
                let _e277 = ((_e265[1] * _e271[2]) - (_e265[2] * _e271[1]));
                let _e280 = ((_e265[2] * _e271[0]) - (_e265[0] * _e271[2]));
                let _e283 = ((_e265[0] * _e271[1]) - (_e265[1] * _e271[0]));
                let _e286 = local_15.member_1[1u];
                let _e292 = local_15.member_2[1u];
                let _e298 = ((_e286[1] * _e292[2]) - (_e286[2] * _e292[1]));
                let _e301 = ((_e286[2] * _e292[0]) - (_e286[0] * _e292[2]));
                let _e304 = ((_e286[0] * _e292[1]) - (_e286[1] * _e292[0]));
                let _e307 = local_15.member_1[0u];
                let _e313 = local_15.member_2[1u];
                let _e328 = local_15.member_1[1u];
                let _e334 = local_15.member_2[0u];
                let _e347 = (((_e307[1] * _e313[2]) - (_e307[2] * _e313[1])) + ((_e328[1] * _e334[2]) - (_e328[2] * _e334[1])));
                let _e348 = (((_e307[2] * _e313[0]) - (_e307[0] * _e313[2])) + ((_e328[2] * _e334[0]) - (_e328[0] * _e334[2])));
                let _e349 = (((_e307[0] * _e313[1]) - (_e307[1] * _e313[0])) + ((_e328[0] * _e334[1]) - (_e328[1] * _e334[0])));
                let _e352 = local_15.member[0u];
                let _e360 = (((_e352[0] * _e277) + (_e352[1] * _e280)) + (_e352[2] * _e283));
                let _e363 = local_15.member[1u];
                let _e374 = local_15.member[0u];
                let _e383 = ((((_e363[0] * _e277) + (_e363[1] * _e280)) + (_e363[2] * _e283)) + (((_e374[0] * _e347) + (_e374[1] * _e348)) + (_e374[2] * _e349)));
                let _e386 = local_15.member[0u];
                let _e397 = local_15.member[1u];
                let _e406 = ((((_e386[0] * _e298) + (_e386[1] * _e301)) + (_e386[2] * _e304)) + (((_e397[0] * _e347) + (_e397[1] * _e348)) + (_e397[2] * _e349)));
                let _e409 = local_15.member[1u];
                let _e417 = (((_e409[0] * _e298) + (_e409[1] * _e301)) + (_e409[2] * _e304));
                let _e420 = local_15.member[0u];
                if (_e420[0] < 0f) {
                    phi_705_ = -(_e420[0]);
                } else {
                    phi_705_ = _e420[0];
                }
                let _e427 = phi_705_;
                if (_e420[1] < 0f) {
                    phi_712_ = -(_e420[1]);
                } else {
                    phi_712_ = _e420[1];
                }
                let _e431 = phi_712_;
                if (_e427 > _e431) {
                    phi_717_ = _e427;
                } else {
                    phi_717_ = _e431;
                }
                let _e434 = phi_717_;
                if (_e420[2] < 0f) {
                    phi_724_ = -(_e420[2]);
                } else {
                    phi_724_ = _e420[2];
                }
                let _e438 = phi_724_;
                if (_e434 > _e438) {
                    phi_729_ = _e434;
                } else {
                    phi_729_ = _e438;
                }
                let _e441 = phi_729_;
                let _e444 = local_15.member[1u];
                if (_e444[0] < 0f) {
                    phi_742_ = -(_e444[0]);
                } else {
                    phi_742_ = _e444[0];
                }
                let _e451 = phi_742_;
                if (_e444[1] < 0f) {
                    phi_749_ = -(_e444[1]);
                } else {
                    phi_749_ = _e444[1];
                }
                let _e455 = phi_749_;
                if (_e451 > _e455) {
                    phi_754_ = _e451;
                } else {
                    phi_754_ = _e455;
                }
                let _e458 = phi_754_;
                if (_e444[2] < 0f) {
                    phi_761_ = -(_e444[2]);
                } else {
                    phi_761_ = _e444[2];
                }
                let _e462 = phi_761_;
                if (_e458 > _e462) {
                    phi_766_ = _e458;
                } else {
                    phi_766_ = _e462;
                }
                let _e465 = phi_766_;
                if (_e441 > _e465) {
                    phi_771_ = _e441;
                } else {
                    phi_771_ = _e465;
                }
                let _e468 = phi_771_;
                let _e470 = local_15.member_3;
                let _e471 = (_e468 + _e470);
                let _e474 = local_15.member_1[0u];
                if (_e474[0] < 0f) {
                    phi_788_ = -(_e474[0]);
                } else {
                    phi_788_ = _e474[0];
                }
                let _e481 = phi_788_;
                if (_e474[1] < 0f) {
                    phi_795_ = -(_e474[1]);
                } else {
                    phi_795_ = _e474[1];
                }
                let _e485 = phi_795_;
                if (_e481 > _e485) {
                    phi_800_ = _e481;
                } else {
                    phi_800_ = _e485;
                }
                let _e488 = phi_800_;
                if (_e474[2] < 0f) {
                    phi_807_ = -(_e474[2]);
                } else {
                    phi_807_ = _e474[2];
                }
                let _e492 = phi_807_;
                if (_e488 > _e492) {
                    phi_812_ = _e488;
                } else {
                    phi_812_ = _e492;
                }
                let _e495 = phi_812_;
                let _e498 = local_15.member_1[1u];
                if (_e498[0] < 0f) {
                    phi_826_ = -(_e498[0]);
                } else {
                    phi_826_ = _e498[0];
                }
                let _e505 = phi_826_;
                if (_e498[1] < 0f) {
                    phi_833_ = -(_e498[1]);
                } else {
                    phi_833_ = _e498[1];
                }
                let _e509 = phi_833_;
                if (_e505 > _e509) {
                    phi_838_ = _e505;
                } else {
                    phi_838_ = _e509;
                }
                let _e512 = phi_838_;
                if (_e498[2] < 0f) {
                    phi_845_ = -(_e498[2]);
                } else {
                    phi_845_ = _e498[2];
                }
                let _e516 = phi_845_;
                if (_e512 > _e516) {
                    phi_850_ = _e512;
                } else {
                    phi_850_ = _e516;
                }
                let _e519 = phi_850_;
                if (_e495 > _e519) {
                    phi_855_ = _e495;
                } else {
                    phi_855_ = _e519;
                }
                let _e522 = phi_855_;
                let _e524 = local_15.member_3;
                let _e525 = (_e522 + _e524);
                let _e528 = local_15.member_2[0u];
                if (_e528[0] < 0f) {
                    phi_872_ = -(_e528[0]);
                } else {
                    phi_872_ = _e528[0];
                }
                let _e535 = phi_872_;
                if (_e528[1] < 0f) {
                    phi_879_ = -(_e528[1]);
                } else {
                    phi_879_ = _e528[1];
                }
                let _e539 = phi_879_;
                if (_e535 > _e539) {
                    phi_884_ = _e535;
                } else {
                    phi_884_ = _e539;
                }
                let _e542 = phi_884_;
                if (_e528[2] < 0f) {
                    phi_891_ = -(_e528[2]);
                } else {
                    phi_891_ = _e528[2];
                }
                let _e546 = phi_891_;
                if (_e542 > _e546) {
                    phi_896_ = _e542;
                } else {
                    phi_896_ = _e546;
                }
                let _e549 = phi_896_;
                let _e552 = local_15.member_2[1u];
                if (_e552[0] < 0f) {
                    phi_910_ = -(_e552[0]);
                } else {
                    phi_910_ = _e552[0];
                }
                let _e559 = phi_910_;
                if (_e552[1] < 0f) {
                    phi_917_ = -(_e552[1]);
                } else {
                    phi_917_ = _e552[1];
                }
                let _e563 = phi_917_;
                if (_e559 > _e563) {
                    phi_922_ = _e559;
                } else {
                    phi_922_ = _e563;
                }
                let _e566 = phi_922_;
                if (_e552[2] < 0f) {
                    phi_929_ = -(_e552[2]);
                } else {
                    phi_929_ = _e552[2];
                }
                let _e570 = phi_929_;
                if (_e566 > _e570) {
                    phi_934_ = _e566;
                } else {
                    phi_934_ = _e570;
                }
                let _e573 = phi_934_;
                if (_e549 > _e573) {
                    phi_939_ = _e549;
                } else {
                    phi_939_ = _e573;
                }
                let _e576 = phi_939_;
                let _e578 = local_15.member_3;
                let _e579 = (_e576 + _e578);
                let _e581 = ((_e525 * 8f) * _e579);
                let _e588 = local_15.member_3;
                if (_e277 < 0f) {
                    phi_970_ = -(_e277);
                } else {
                    phi_970_ = _e277;
                }
                let _e605 = phi_970_;
                if (_e280 < 0f) {
                    phi_976_ = -(_e280);
                } else {
                    phi_976_ = _e280;
                }
                let _e609 = phi_976_;
                if (_e283 < 0f) {
                    phi_983_ = -(_e283);
                } else {
                    phi_983_ = _e283;
                }
                let _e614 = phi_983_;
                let _e615 = ((_e605 + _e609) + _e614);
                if (_e298 < 0f) {
                    phi_990_ = -(_e298);
                } else {
                    phi_990_ = _e298;
                }
                let _e619 = phi_990_;
                if (_e301 < 0f) {
                    phi_996_ = -(_e301);
                } else {
                    phi_996_ = _e301;
                }
                let _e623 = phi_996_;
                if (_e304 < 0f) {
                    phi_1003_ = -(_e304);
                } else {
                    phi_1003_ = _e304;
                }
                let _e628 = phi_1003_;
                let _e629 = ((_e619 + _e623) + _e628);
                if (_e615 > _e629) {
                    phi_1009_ = _e615;
                } else {
                    phi_1009_ = _e629;
                }
                let _e632 = phi_1009_;
                if (_e347 < 0f) {
                    phi_1015_ = -(_e347);
                } else {
                    phi_1015_ = _e347;
                }
                let _e636 = phi_1015_;
                if (_e348 < 0f) {
                    phi_1021_ = -(_e348);
                } else {
                    phi_1021_ = _e348;
                }
                let _e640 = phi_1021_;
                if (_e349 < 0f) {
                    phi_1028_ = -(_e349);
                } else {
                    phi_1028_ = _e349;
                }
                let _e645 = phi_1028_;
                let _e647 = (((_e636 + _e640) + _e645) * 0.5f);
                if (_e632 > _e647) {
                    phi_1035_ = _e632;
                } else {
                    phi_1035_ = _e647;
                }
                let _e650 = phi_1035_;
                let _e655 = local_15.member_3;
                let _e667 = (((((_e471 * 8f) * _e581) * (0.000000059604645f * (490f / 64f))) + ((_e588 * 19f) * ((_e471 * (_e525 + _e579)) + (_e525 * _e579)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e471) * ((1f + _e525) * (1f + _e579)))));
                let _e668 = (_e360 * 3f);
                let _e669 = (_e417 * 3f);
                if (_e668 < _e669) {
                    phi_1059_ = _e668;
                } else {
                    phi_1059_ = _e669;
                }
                let _e672 = phi_1059_;
                if (_e383 < _e406) {
                    phi_1064_ = _e383;
                } else {
                    phi_1064_ = _e406;
                }
                let _e675 = phi_1064_;
                if (_e672 < _e675) {
                    phi_1069_ = _e672;
                } else {
                    phi_1069_ = _e675;
                }
                let _e678 = phi_1069_;
                if (_e668 > _e669) {
                    phi_1074_ = _e668;
                } else {
                    phi_1074_ = _e669;
                }
                let _e681 = phi_1074_;
                if (_e383 > _e406) {
                    phi_1079_ = _e383;
                } else {
                    phi_1079_ = _e406;
                }
                let _e684 = phi_1079_;
                if (_e681 > _e684) {
                    phi_1084_ = _e681;
                } else {
                    phi_1084_ = _e684;
                }
                let _e687 = phi_1084_;
                let _e692 = -(_e687);
                if (_e678 > _e692) {
                    phi_1094_ = _e678;
                } else {
                    phi_1094_ = _e692;
                }
                let _e695 = phi_1094_;
                if ((_e695 - (_e667 + ((_e262 * (((_e650 + (_e581 * (0.000000059604645f * 4f))) + ((_e655 * 6f) * (_e525 + _e579))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e525) * (1f + _e579))))) * (3f * 1.0001f)))) > 0f) {
                    phi_6724_ = type_55(0u, type_55().member_1);
                } else {
                    if (_e262 > 0f) {
                        let _e2919 = local_15.member[0u];
                        let _e2925 = local_15.member_1[0u];
                        let _e2931 = local_15.member_2[0u];
                        local_12 = array<array<f32, 3>, 4>(_e2919, array<f32, 3>((_e2919[0] - _e2925[0]), (_e2919[1] - _e2925[1]), (_e2919[2] - _e2925[2])), array<f32, 3>((_e2919[0] - _e2931[0]), (_e2919[1] - _e2931[1]), (_e2919[2] - _e2931[2])), _e2919);
                        let _e2946 = local_15.member[1u];
                        let _e2952 = local_15.member_1[1u];
                        let _e2958 = local_15.member_2[1u];
                        local_13 = array<array<f32, 3>, 4>(_e2946, array<f32, 3>((_e2946[0] - _e2952[0]), (_e2946[1] - _e2952[1]), (_e2946[2] - _e2952[2])), array<f32, 3>((_e2946[0] - _e2958[0]), (_e2946[1] - _e2958[1]), (_e2946[2] - _e2958[2])), _e2946);
                        let _e2973 = local_15.member[0u];
                        if (_e2973[0] < 0f) {
                            phi_1295_ = -(_e2973[0]);
                        } else {
                            phi_1295_ = _e2973[0];
                        }
                        let _e2980 = phi_1295_;
                        if (_e2973[1] < 0f) {
                            phi_1302_ = -(_e2973[1]);
                        } else {
                            phi_1302_ = _e2973[1];
                        }
                        let _e2984 = phi_1302_;
                        if (_e2980 > _e2984) {
                            phi_1307_ = _e2980;
                        } else {
                            phi_1307_ = _e2984;
                        }
                        let _e2987 = phi_1307_;
                        if (_e2973[2] < 0f) {
                            phi_1314_ = -(_e2973[2]);
                        } else {
                            phi_1314_ = _e2973[2];
                        }
                        let _e2991 = phi_1314_;
                        if (_e2987 > _e2991) {
                            phi_1319_ = _e2987;
                        } else {
                            phi_1319_ = _e2991;
                        }
                        let _e2994 = phi_1319_;
                        let _e2997 = local_15.member[1u];
                        if (_e2997[0] < 0f) {
                            phi_1332_ = -(_e2997[0]);
                        } else {
                            phi_1332_ = _e2997[0];
                        }
                        let _e3004 = phi_1332_;
                        if (_e2997[1] < 0f) {
                            phi_1339_ = -(_e2997[1]);
                        } else {
                            phi_1339_ = _e2997[1];
                        }
                        let _e3008 = phi_1339_;
                        if (_e3004 > _e3008) {
                            phi_1344_ = _e3004;
                        } else {
                            phi_1344_ = _e3008;
                        }
                        let _e3011 = phi_1344_;
                        if (_e2997[2] < 0f) {
                            phi_1351_ = -(_e2997[2]);
                        } else {
                            phi_1351_ = _e2997[2];
                        }
                        let _e3015 = phi_1351_;
                        if (_e3011 > _e3015) {
                            phi_1356_ = _e3011;
                        } else {
                            phi_1356_ = _e3015;
                        }
                        let _e3018 = phi_1356_;
                        if (_e2994 > _e3018) {
                            phi_1361_ = _e2994;
                        } else {
                            phi_1361_ = _e3018;
                        }
                        let _e3021 = phi_1361_;
                        let _e3023 = local_15.member_3;
                        let _e3027 = local_15.member_1[0u];
                        if (_e3027[0] < 0f) {
                            phi_1378_ = -(_e3027[0]);
                        } else {
                            phi_1378_ = _e3027[0];
                        }
                        let _e3034 = phi_1378_;
                        if (_e3027[1] < 0f) {
                            phi_1385_ = -(_e3027[1]);
                        } else {
                            phi_1385_ = _e3027[1];
                        }
                        let _e3038 = phi_1385_;
                        if (_e3034 > _e3038) {
                            phi_1390_ = _e3034;
                        } else {
                            phi_1390_ = _e3038;
                        }
                        let _e3041 = phi_1390_;
                        if (_e3027[2] < 0f) {
                            phi_1397_ = -(_e3027[2]);
                        } else {
                            phi_1397_ = _e3027[2];
                        }
                        let _e3045 = phi_1397_;
                        if (_e3041 > _e3045) {
                            phi_1402_ = _e3041;
                        } else {
                            phi_1402_ = _e3045;
                        }
                        let _e3048 = phi_1402_;
                        let _e3051 = local_15.member_1[1u];
                        if (_e3051[0] < 0f) {
                            phi_1416_ = -(_e3051[0]);
                        } else {
                            phi_1416_ = _e3051[0];
                        }
                        let _e3058 = phi_1416_;
                        if (_e3051[1] < 0f) {
                            phi_1423_ = -(_e3051[1]);
                        } else {
                            phi_1423_ = _e3051[1];
                        }
                        let _e3062 = phi_1423_;
                        if (_e3058 > _e3062) {
                            phi_1428_ = _e3058;
                        } else {
                            phi_1428_ = _e3062;
                        }
                        let _e3065 = phi_1428_;
                        if (_e3051[2] < 0f) {
                            phi_1435_ = -(_e3051[2]);
                        } else {
                            phi_1435_ = _e3051[2];
                        }
                        let _e3069 = phi_1435_;
                        if (_e3065 > _e3069) {
                            phi_1440_ = _e3065;
                        } else {
                            phi_1440_ = _e3069;
                        }
                        let _e3072 = phi_1440_;
                        if (_e3048 > _e3072) {
                            phi_1445_ = _e3048;
                        } else {
                            phi_1445_ = _e3072;
                        }
                        let _e3075 = phi_1445_;
                        let _e3077 = local_15.member_3;
                        let _e3081 = local_15.member_2[0u];
                        if (_e3081[0] < 0f) {
                            phi_1462_ = -(_e3081[0]);
                        } else {
                            phi_1462_ = _e3081[0];
                        }
                        let _e3088 = phi_1462_;
                        if (_e3081[1] < 0f) {
                            phi_1469_ = -(_e3081[1]);
                        } else {
                            phi_1469_ = _e3081[1];
                        }
                        let _e3092 = phi_1469_;
                        if (_e3088 > _e3092) {
                            phi_1474_ = _e3088;
                        } else {
                            phi_1474_ = _e3092;
                        }
                        let _e3095 = phi_1474_;
                        if (_e3081[2] < 0f) {
                            phi_1481_ = -(_e3081[2]);
                        } else {
                            phi_1481_ = _e3081[2];
                        }
                        let _e3099 = phi_1481_;
                        if (_e3095 > _e3099) {
                            phi_1486_ = _e3095;
                        } else {
                            phi_1486_ = _e3099;
                        }
                        let _e3102 = phi_1486_;
                        let _e3105 = local_15.member_2[1u];
                        if (_e3105[0] < 0f) {
                            phi_1500_ = -(_e3105[0]);
                        } else {
                            phi_1500_ = _e3105[0];
                        }
                        let _e3112 = phi_1500_;
                        if (_e3105[1] < 0f) {
                            phi_1507_ = -(_e3105[1]);
                        } else {
                            phi_1507_ = _e3105[1];
                        }
                        let _e3116 = phi_1507_;
                        if (_e3112 > _e3116) {
                            phi_1512_ = _e3112;
                        } else {
                            phi_1512_ = _e3116;
                        }
                        let _e3119 = phi_1512_;
                        if (_e3105[2] < 0f) {
                            phi_1519_ = -(_e3105[2]);
                        } else {
                            phi_1519_ = _e3105[2];
                        }
                        let _e3123 = phi_1519_;
                        if (_e3119 > _e3123) {
                            phi_1524_ = _e3119;
                        } else {
                            phi_1524_ = _e3123;
                        }
                        let _e3126 = phi_1524_;
                        if (_e3102 > _e3126) {
                            phi_1529_ = _e3102;
                        } else {
                            phi_1529_ = _e3126;
                        }
                        let _e3129 = phi_1529_;
                        let _e3131 = local_15.member_3;
                        let _e3138 = local_15.member_3;
                        phi_1545_ = type_28(0u, 48u);
                        phi_1548_ = 0f;
                        loop {
                            let _e3144 = phi_1545_;
                            let _e3146 = phi_1548_;
                            local_74 = _e3146;
                            local_39 = _e3146;
                            local_40 = _e3146;
                            local_41 = _e3146;
                            if (_e3144.member < _e3144.member_1) {
                                phi_1546_ = type_28((_e3144.member + 1u), _e3144.member_1);
                                phi_1571_ = type_28(1u, _e3144.member);
                            } else {
                                phi_1546_ = _e3144;
                                phi_1571_ = type_28(0u, type_28().member_1);
                            }
                            let _e3160 = phi_1546_;
                            let _e3162 = phi_1571_;
                            if (bitcast<i32>(_e3162.member) != 0i) {
                                let _e3168 = local_15.member[0u];
                                let _e3174 = local_15.member[1u];
                                let _e3184 = (_e3168[0] + ((_e3174[0] - _e3168[0]) * _e3146));
                                let _e3185 = (_e3168[1] + ((_e3174[1] - _e3168[1]) * _e3146));
                                let _e3186 = (_e3168[2] + ((_e3174[2] - _e3168[2]) * _e3146));
                                let _e3189 = local_15.member_1[0u];
                                let _e3195 = local_15.member_1[1u];
                                let _e3205 = (_e3189[0] + ((_e3195[0] - _e3189[0]) * _e3146));
                                let _e3206 = (_e3189[1] + ((_e3195[1] - _e3189[1]) * _e3146));
                                let _e3207 = (_e3189[2] + ((_e3195[2] - _e3189[2]) * _e3146));
                                let _e3210 = local_15.member_2[0u];
                                let _e3216 = local_15.member_2[1u];
                                let _e3226 = (_e3210[0] + ((_e3216[0] - _e3210[0]) * _e3146));
                                let _e3227 = (_e3210[1] + ((_e3216[1] - _e3210[1]) * _e3146));
                                let _e3228 = (_e3210[2] + ((_e3216[2] - _e3210[2]) * _e3146));
                                let _e3233 = (((_e3205 * _e3205) + (_e3206 * _e3206)) + (_e3207 * _e3207));
                                let _e3238 = (((_e3205 * _e3226) + (_e3206 * _e3227)) + (_e3207 * _e3228));
                                let _e3243 = (((_e3226 * _e3226) + (_e3227 * _e3227)) + (_e3228 * _e3228));
                                let _e3248 = (((_e3184 * _e3205) + (_e3185 * _e3206)) + (_e3186 * _e3207));
                                let _e3253 = (((_e3184 * _e3226) + (_e3185 * _e3227)) + (_e3186 * _e3228));
                                let _e3256 = ((_e3233 * _e3243) - (_e3238 * _e3238));
                                let _e3260 = (((_e3248 * _e3243) - (_e3253 * _e3238)) / _e3256);
                                let _e3264 = (((_e3253 * _e3233) - (_e3248 * _e3238)) / _e3256);
                                if (_e3260 >= 0f) {
                                    if (_e3264 >= 0f) {
                                        phi_1745_ = ((_e3260 + _e3264) <= 1f);
                                        phi_1746_ = false;
                                    } else {
                                        phi_1745_ = bool();
                                        phi_1746_ = true;
                                    }
                                    let _e3270 = phi_1745_;
                                    let _e3272 = phi_1746_;
                                    phi_1747_ = _e3270;
                                    phi_1748_ = _e3272;
                                } else {
                                    phi_1747_ = bool();
                                    phi_1748_ = true;
                                }
                                let _e3274 = phi_1747_;
                                let _e3276 = phi_1748_;
                                if _e3276 {
                                    phi_1752_ = false;
                                } else {
                                    phi_1752_ = _e3274;
                                }
                                let _e3278 = phi_1752_;
                                if (_e3256 > 0f) {
                                    if _e3278 {
                                        phi_1774_ = array<f32, 3>((_e3184 - ((_e3205 * _e3260) + (_e3226 * _e3264))), (_e3185 - ((_e3206 * _e3260) + (_e3227 * _e3264))), (_e3186 - ((_e3207 * _e3260) + (_e3228 * _e3264))));
                                        phi_1775_ = false;
                                    } else {
                                        phi_1774_ = array<f32, 3>();
                                        phi_1775_ = true;
                                    }
                                    let _e3294 = phi_1774_;
                                    let _e3296 = phi_1775_;
                                    phi_1776_ = _e3294;
                                    phi_1777_ = _e3296;
                                } else {
                                    phi_1776_ = array<f32, 3>();
                                    phi_1777_ = true;
                                }
                                let _e3298 = phi_1776_;
                                let _e3300 = phi_1777_;
                                if _e3300 {
                                    let _e3301 = (_e3184 - _e3205);
                                    let _e3302 = (_e3185 - _e3206);
                                    let _e3303 = (_e3186 - _e3207);
                                    let _e3304 = (_e3226 - _e3205);
                                    let _e3305 = (_e3227 - _e3206);
                                    let _e3306 = (_e3228 - _e3207);
                                    let _e3317 = ((((_e3301 * _e3304) + (_e3302 * _e3305)) + (_e3303 * _e3306)) / (((_e3304 * _e3304) + (_e3305 * _e3305)) + (_e3306 * _e3306)));
                                    if (_e3317 > 0f) {
                                        if (_e3317 < 1f) {
                                            phi_1945_ = _e3317;
                                        } else {
                                            phi_1945_ = 1f;
                                        }
                                        let _e3321 = phi_1945_;
                                        phi_1946_ = _e3321;
                                    } else {
                                        phi_1946_ = 0f;
                                    }
                                    let _e3323 = phi_1946_;
                                    let _e3327 = (_e3301 - (_e3304 * _e3323));
                                    let _e3328 = (_e3302 - (_e3305 * _e3323));
                                    let _e3329 = (_e3303 - (_e3306 * _e3323));
                                    let _e3340 = ((((_e3184 * _e3205) + (_e3185 * _e3206)) + (_e3186 * _e3207)) / (((_e3205 * _e3205) + (_e3206 * _e3206)) + (_e3207 * _e3207)));
                                    if (_e3340 > 0f) {
                                        if (_e3340 < 1f) {
                                            phi_1973_ = _e3340;
                                        } else {
                                            phi_1973_ = 1f;
                                        }
                                        let _e3344 = phi_1973_;
                                        phi_1974_ = _e3344;
                                    } else {
                                        phi_1974_ = 0f;
                                    }
                                    let _e3346 = phi_1974_;
                                    let _e3363 = ((((_e3184 * _e3226) + (_e3185 * _e3227)) + (_e3186 * _e3228)) / (((_e3226 * _e3226) + (_e3227 * _e3227)) + (_e3228 * _e3228)));
                                    if (_e3363 > 0f) {
                                        if (_e3363 < 1f) {
                                            phi_2001_ = _e3363;
                                        } else {
                                            phi_2001_ = 1f;
                                        }
                                        let _e3367 = phi_2001_;
                                        phi_2002_ = _e3367;
                                    } else {
                                        phi_2002_ = 0f;
                                    }
                                    let _e3369 = phi_2002_;
                                    local_11[0u] = array<f32, 3>((_e3184 - (_e3205 * _e3346)), (_e3185 - (_e3206 * _e3346)), (_e3186 - (_e3207 * _e3346)));
                                    local_11[1u] = array<f32, 3>((_e3184 - (_e3226 * _e3369)), (_e3185 - (_e3227 * _e3369)), (_e3186 - (_e3228 * _e3369)));
                                    local_11[2u] = array<f32, 3>(_e3327, _e3328, _e3329);
                                    local_11[3u] = array<f32, 3>(_e3327, _e3328, _e3329);
                                    let _e3385 = local_11[0u];
                                    phi_2038_ = type_28(1u, 4u);
                                    phi_2041_ = array<f32, 3>(_e3385[0], _e3385[1], _e3385[2]);
                                    loop {
                                        let _e3391 = phi_2038_;
                                        let _e3393 = phi_2041_;
                                        local_64 = _e3393;
                                        if (_e3391.member < _e3391.member_1) {
                                            phi_2039_ = type_28((_e3391.member + 1u), _e3391.member_1);
                                            phi_2064_ = type_28(1u, _e3391.member);
                                        } else {
                                            phi_2039_ = _e3391;
                                            phi_2064_ = type_28(0u, type_28().member_1);
                                        }
                                        let _e3407 = phi_2039_;
                                        let _e3409 = phi_2064_;
                                        let _e3413 = (bitcast<i32>(_e3409.member) != 0i);
                                        if _e3413 {
                                            if (_e3409.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3416 = local_11[_e3409.member_1];
                                            if (_e3409.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3422 = local_11[_e3409.member_1];
                                            if ((((_e3416[0] * _e3422[0]) + (_e3416[1] * _e3422[1])) + (_e3416[2] * _e3422[2])) < (((_e3393[0] * _e3393[0]) + (_e3393[1] * _e3393[1])) + (_e3393[2] * _e3393[2]))) {
                                                if (_e3409.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3445 = local_11[_e3409.member_1];
                                                phi_2131_ = array<f32, 3>(_e3445[0], _e3445[1], _e3445[2]);
                                            } else {
                                                phi_2131_ = _e3393;
                                            }
                                            let _e3451 = phi_2131_;
                                            phi_2042_ = _e3451;
                                        } else {
                                            phi_2042_ = array<f32, 3>();
                                        }
                                        let _e3453 = phi_2042_;
                                        continue;
                                        continuing {
                                            phi_2038_ = _e3407;
                                            phi_2041_ = _e3453;
                                            break if !(_e3413);
                                        }
                                    }
                                    let _e5170 = local_64;
                                    phi_2132_ = _e5170;
                                } else {
                                    phi_2132_ = _e3298;
                                }
                                let _e3456 = phi_2132_;
                                if (_e3456[0] < 0f) {
                                    phi_2139_ = -(_e3456[0]);
                                } else {
                                    phi_2139_ = _e3456[0];
                                }
                                let _e3461 = phi_2139_;
                                if (_e3456[1] < 0f) {
                                    phi_2146_ = -(_e3456[1]);
                                } else {
                                    phi_2146_ = _e3456[1];
                                }
                                let _e3466 = phi_2146_;
                                if (_e3456[2] < 0f) {
                                    phi_2154_ = -(_e3456[2]);
                                } else {
                                    phi_2154_ = _e3456[2];
                                }
                                let _e3472 = phi_2154_;
                                let _e3473 = ((_e3461 + _e3466) + _e3472);
                                if (_e3473 > 0f) {
                                    if ((bitcast<u32>(_e3473) & 2139095040u) != 2139095040u) {
                                        let _e3478 = (1f / _e3473);
                                        let _e3480 = (_e3456[0] * _e3478);
                                        let _e3482 = (_e3456[1] * _e3478);
                                        let _e3484 = (_e3456[2] * _e3478);
                                        let _e3489 = (((_e3480 * _e3480) + (_e3482 * _e3482)) + (_e3484 * _e3484));
                                        if (_e3489 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3489 > 0f) {
                                                phi_2191_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2191_ = 0f;
                                            }
                                            let _e3548 = phi_2191_;
                                            phi_2255_ = _e3548;
                                        } else {
                                            phi_2198_ = type_26(0i, 5i);
                                            phi_2201_ = bitcast<f32>(((bitcast<u32>(_e3489) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3497 = phi_2198_;
                                                let _e3499 = phi_2201_;
                                                local_33 = _e3499;
                                                if (_e3497.member < _e3497.member_1) {
                                                    let _e3507 = (_e3497.member + 1i);
                                                    if ((false == (_e3507 > _e3497.member)) != false) {
                                                        phi_2222_ = true;
                                                    } else {
                                                        phi_2222_ = false;
                                                    }
                                                    let _e3512 = phi_2222_;
                                                    if _e3512 {
                                                        phi_2228_ = type_27(0u, type_27().member_1);
                                                    } else {
                                                        phi_2228_ = type_27(1u, _e3507);
                                                    }
                                                    let _e3518 = phi_2228_;
                                                    if (bitcast<i32>(_e3518.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2199_ = type_26(_e3518.member_1, _e3497.member_1);
                                                    phi_2242_ = type_27(1u, _e3497.member);
                                                } else {
                                                    phi_2199_ = _e3497;
                                                    phi_2242_ = type_27(0u, type_27().member_1);
                                                }
                                                let _e3528 = phi_2199_;
                                                let _e3530 = phi_2242_;
                                                let _e3533 = (bitcast<i32>(_e3530.member) != 0i);
                                                if _e3533 {
                                                    phi_2202_ = (0.5f * (_e3499 + (_e3489 / _e3499)));
                                                } else {
                                                    phi_2202_ = f32();
                                                }
                                                let _e3538 = phi_2202_;
                                                continue;
                                                continuing {
                                                    phi_2198_ = _e3528;
                                                    phi_2201_ = _e3538;
                                                    break if !(_e3533);
                                                }
                                            }
                                            let _e3543 = local_33;
                                            phi_2255_ = (_e3543 * (1f + (4f * 0.000000059604645f)));
                                        }
                                        let _e3550 = phi_2255_;
                                        phi_2264_ = type_28(0u, 4u);
                                        phi_2267_ = 2f;
                                        loop {
                                            let _e3558 = phi_2264_;
                                            let _e3560 = phi_2267_;
                                            local_35 = _e3560;
                                            local_36 = _e3560;
                                            local_37 = _e3560;
                                            local_65 = _e3560;
                                            local_66 = _e3560;
                                            if (_e3558.member < _e3558.member_1) {
                                                phi_2265_ = type_28((_e3558.member + 1u), _e3558.member_1);
                                                phi_2290_ = type_28(1u, _e3558.member);
                                            } else {
                                                phi_2265_ = _e3558;
                                                phi_2290_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e3574 = phi_2265_;
                                            let _e3576 = phi_2290_;
                                            if (bitcast<i32>(_e3576.member) != 0i) {
                                                if (_e3576.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3583 = local_12[_e3576.member_1];
                                                let _e3591 = (((_e3480 * _e3583[0]) + (_e3482 * _e3583[1])) + (_e3484 * _e3583[2]));
                                                if (_e3576.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3594 = local_13[_e3576.member_1];
                                                let _e3602 = (((_e3480 * _e3594[0]) + (_e3482 * _e3594[1])) + (_e3484 * _e3594[2]));
                                                if (_e3591 < 0f) {
                                                    phi_2341_ = -(_e3591);
                                                } else {
                                                    phi_2341_ = _e3591;
                                                }
                                                let _e3606 = phi_2341_;
                                                if (_e3602 < 0f) {
                                                    phi_2347_ = -(_e3602);
                                                } else {
                                                    phi_2347_ = _e3602;
                                                }
                                                let _e3610 = phi_2347_;
                                                let _e3614 = (((((((((_e3021 + _e3023) + (_e3075 + _e3077)) + (_e3129 + _e3131)) * (0.000000059604645f * 16f)) + (_e3138 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e262 * _e3550) * (1f + (0.000000059604645f * 8f)))) + ((_e3606 + _e3610) * (0.000000059604645f * 8f)));
                                                if (_e3591 > _e3614) {
                                                    if (_e3602 > _e3614) {
                                                        phi_2360_ = false;
                                                    } else {
                                                        phi_2360_ = true;
                                                    }
                                                    let _e3618 = phi_2360_;
                                                    phi_2361_ = _e3618;
                                                } else {
                                                    phi_2361_ = true;
                                                }
                                                let _e3620 = phi_2361_;
                                                if _e3620 {
                                                    let _e3624 = ((_e3591 + ((_e3602 - _e3591) * _e3146)) > _e3614);
                                                    if _e3624 {
                                                        if (_e3602 < _e3591) {
                                                            let _e3631 = (((_e3591 - _e3614) / (_e3591 - _e3602)) * (1f - (0.000000059604645f * 16f)));
                                                            if (_e3560 < _e3631) {
                                                                phi_2386_ = _e3560;
                                                            } else {
                                                                phi_2386_ = _e3631;
                                                            }
                                                            let _e3634 = phi_2386_;
                                                            phi_2387_ = _e3634;
                                                        } else {
                                                            phi_2387_ = _e3560;
                                                        }
                                                        let _e3636 = phi_2387_;
                                                        phi_2388_ = _e3636;
                                                    } else {
                                                        phi_2388_ = f32();
                                                    }
                                                    let _e3638 = phi_2388_;
                                                    phi_2389_ = _e3638;
                                                    phi_2390_ = _e3624;
                                                } else {
                                                    phi_2389_ = _e3560;
                                                    phi_2390_ = true;
                                                }
                                                let _e3640 = phi_2389_;
                                                let _e3642 = phi_2390_;
                                                phi_2268_ = _e3640;
                                                phi_2391_ = _e3642;
                                                phi_2392_ = false;
                                            } else {
                                                phi_2268_ = f32();
                                                phi_2391_ = false;
                                                phi_2392_ = true;
                                            }
                                            let _e3644 = phi_2268_;
                                            let _e3646 = phi_2391_;
                                            let _e3648 = phi_2392_;
                                            local_34 = _e3648;
                                            continue;
                                            continuing {
                                                phi_2264_ = _e3574;
                                                phi_2267_ = _e3644;
                                                break if !(_e3646);
                                            }
                                        }
                                        let _e3651 = local_34;
                                        if _e3651 {
                                            let _e3653 = local_35;
                                            let _e3654 = (_e3653 > 1f);
                                            if _e3654 {
                                                phi_2413_ = false;
                                                phi_2414_ = false;
                                                phi_2415_ = false;
                                            } else {
                                                let _e3656 = local_36;
                                                if (_e3656 > _e3146) {
                                                    let _e3659 = local_37;
                                                    let _e3661 = ((_e3659 - _e3146) < 0.00000000023283064f);
                                                    if _e3661 {
                                                        phi_2409_ = false;
                                                    } else {
                                                        phi_2409_ = true;
                                                    }
                                                    let _e3663 = phi_2409_;
                                                    phi_2410_ = _e3663;
                                                    phi_2411_ = _e3661;
                                                    phi_2412_ = false;
                                                } else {
                                                    phi_2410_ = false;
                                                    phi_2411_ = false;
                                                    phi_2412_ = true;
                                                }
                                                let _e3665 = phi_2410_;
                                                let _e3667 = phi_2411_;
                                                let _e3669 = phi_2412_;
                                                phi_2413_ = _e3665;
                                                phi_2414_ = _e3667;
                                                phi_2415_ = _e3669;
                                            }
                                            let _e3671 = phi_2413_;
                                            let _e3673 = phi_2414_;
                                            let _e3675 = phi_2415_;
                                            phi_2416_ = _e3671;
                                            phi_2417_ = _e3654;
                                            phi_2418_ = _e3673;
                                            phi_2419_ = _e3675;
                                            phi_2420_ = false;
                                        } else {
                                            phi_2416_ = false;
                                            phi_2417_ = false;
                                            phi_2418_ = false;
                                            phi_2419_ = false;
                                            phi_2420_ = true;
                                        }
                                        let _e3677 = phi_2416_;
                                        let _e3679 = phi_2417_;
                                        let _e3681 = phi_2418_;
                                        let _e3683 = phi_2419_;
                                        let _e3685 = phi_2420_;
                                        let _e5218 = local_65;
                                        phi_2421_ = _e5218;
                                        let _e5221 = local_66;
                                        phi_2422_ = _e5221;
                                        phi_2423_ = _e3677;
                                        phi_2424_ = _e3679;
                                        phi_2425_ = _e3681;
                                        phi_2426_ = _e3683;
                                        phi_2427_ = _e3685;
                                        phi_2428_ = false;
                                    } else {
                                        phi_2421_ = f32();
                                        phi_2422_ = f32();
                                        phi_2423_ = false;
                                        phi_2424_ = false;
                                        phi_2425_ = false;
                                        phi_2426_ = false;
                                        phi_2427_ = false;
                                        phi_2428_ = true;
                                    }
                                    let _e3687 = phi_2421_;
                                    let _e3689 = phi_2422_;
                                    let _e3691 = phi_2423_;
                                    let _e3693 = phi_2424_;
                                    let _e3695 = phi_2425_;
                                    let _e3697 = phi_2426_;
                                    let _e3699 = phi_2427_;
                                    let _e3701 = phi_2428_;
                                    phi_2429_ = _e3687;
                                    phi_2430_ = _e3689;
                                    phi_2431_ = _e3691;
                                    phi_2432_ = _e3693;
                                    phi_2433_ = _e3695;
                                    phi_2434_ = _e3697;
                                    phi_2435_ = _e3699;
                                    phi_2436_ = _e3701;
                                    phi_2437_ = false;
                                } else {
                                    phi_2429_ = f32();
                                    phi_2430_ = f32();
                                    phi_2431_ = false;
                                    phi_2432_ = false;
                                    phi_2433_ = false;
                                    phi_2434_ = false;
                                    phi_2435_ = false;
                                    phi_2436_ = false;
                                    phi_2437_ = true;
                                }
                                let _e3703 = phi_2429_;
                                let _e3705 = phi_2430_;
                                let _e3707 = phi_2431_;
                                let _e3709 = phi_2432_;
                                let _e3711 = phi_2433_;
                                let _e3713 = phi_2434_;
                                let _e3715 = phi_2435_;
                                let _e3717 = phi_2436_;
                                let _e3719 = phi_2437_;
                                phi_2438_ = _e3703;
                                phi_1549_ = _e3705;
                                phi_2439_ = _e3707;
                                phi_2440_ = _e3709;
                                phi_2441_ = _e3711;
                                phi_2442_ = false;
                                phi_2443_ = _e3713;
                                phi_2444_ = _e3715;
                                phi_2445_ = _e3717;
                                phi_2446_ = _e3719;
                            } else {
                                phi_2438_ = f32();
                                phi_1549_ = f32();
                                phi_2439_ = false;
                                phi_2440_ = false;
                                phi_2441_ = false;
                                phi_2442_ = true;
                                phi_2443_ = false;
                                phi_2444_ = false;
                                phi_2445_ = false;
                                phi_2446_ = false;
                            }
                            let _e3721 = phi_2438_;
                            let _e3723 = phi_1549_;
                            let _e3725 = phi_2439_;
                            let _e3727 = phi_2440_;
                            let _e3729 = phi_2441_;
                            let _e3731 = phi_2442_;
                            let _e3733 = phi_2443_;
                            let _e3735 = phi_2444_;
                            let _e3737 = phi_2445_;
                            let _e3739 = phi_2446_;
                            local_38 = _e3727;
                            local_67 = _e3729;
                            local_68 = _e3731;
                            local_69 = _e3733;
                            local_70 = _e3735;
                            local_71 = _e3737;
                            local_72 = _e3739;
                            local_73 = _e3721;
                            local_75 = _e3727;
                            continue;
                            continuing {
                                phi_1545_ = _e3160;
                                phi_1548_ = _e3723;
                                break if !(_e3725);
                            }
                        }
                        let _e3742 = local_38;
                        if _e3742 {
                            phi_2451_ = type_55(0u, type_55().member_1);
                            phi_2452_ = false;
                            phi_2453_ = false;
                            phi_2454_ = false;
                            phi_2455_ = false;
                            phi_2456_ = false;
                            phi_2457_ = false;
                        } else {
                            phi_2451_ = type_55();
                            let _e5251 = local_67;
                            phi_2452_ = _e5251;
                            let _e5254 = local_68;
                            phi_2453_ = _e5254;
                            let _e5257 = local_69;
                            phi_2454_ = _e5257;
                            let _e5260 = local_70;
                            phi_2455_ = _e5260;
                            let _e5263 = local_71;
                            phi_2456_ = _e5263;
                            let _e5266 = local_72;
                            phi_2457_ = _e5266;
                        }
                        let _e3747 = phi_2451_;
                        let _e3749 = phi_2452_;
                        let _e3751 = phi_2453_;
                        let _e3753 = phi_2454_;
                        let _e3755 = phi_2455_;
                        let _e3757 = phi_2456_;
                        let _e3759 = phi_2457_;
                        if _e3749 {
                            let _e5269 = local_73;
                            phi_2461_ = _e5269;
                            phi_2462_ = true;
                            phi_2463_ = false;
                            phi_2464_ = false;
                            phi_2465_ = false;
                            phi_2466_ = false;
                            phi_2467_ = false;
                        } else {
                            let _e5271 = local_74;
                            phi_2461_ = _e5271;
                            phi_2462_ = _e3751;
                            phi_2463_ = _e3753;
                            phi_2464_ = _e3755;
                            let _e5277 = local_75;
                            phi_2465_ = _e5277;
                            phi_2466_ = _e3757;
                            phi_2467_ = _e3759;
                        }
                        let _e3761 = phi_2461_;
                        let _e3763 = phi_2462_;
                        let _e3765 = phi_2463_;
                        let _e3767 = phi_2464_;
                        let _e3769 = phi_2465_;
                        let _e3771 = phi_2466_;
                        let _e3773 = phi_2467_;
                        if _e3763 {
                            phi_2472_ = type_55(1u, _e3761);
                            phi_2473_ = false;
                            phi_2474_ = false;
                            phi_2475_ = false;
                            phi_2476_ = false;
                            phi_2477_ = false;
                        } else {
                            phi_2472_ = type_55();
                            phi_2473_ = _e3765;
                            phi_2474_ = _e3767;
                            phi_2475_ = _e3769;
                            phi_2476_ = _e3771;
                            phi_2477_ = _e3773;
                        }
                        let _e3776 = phi_2472_;
                        let _e3778 = phi_2473_;
                        let _e3780 = phi_2474_;
                        let _e3782 = phi_2475_;
                        let _e3784 = phi_2476_;
                        let _e3786 = phi_2477_;
                        if _e3778 {
                            let _e3788 = local_39;
                            phi_2482_ = type_55(1u, _e3788);
                            phi_2483_ = false;
                            phi_2484_ = true;
                            phi_2485_ = false;
                            phi_2486_ = false;
                        } else {
                            phi_2482_ = _e3747;
                            phi_2483_ = _e3780;
                            phi_2484_ = _e3782;
                            phi_2485_ = _e3784;
                            phi_2486_ = _e3786;
                        }
                        let _e3791 = phi_2482_;
                        let _e3793 = phi_2483_;
                        let _e3795 = phi_2484_;
                        let _e3797 = phi_2485_;
                        let _e3799 = phi_2486_;
                        if _e3793 {
                            let _e3801 = local_40;
                            phi_2491_ = type_55(1u, _e3801);
                            phi_2492_ = true;
                            phi_2493_ = false;
                            phi_2494_ = false;
                        } else {
                            phi_2491_ = _e3791;
                            phi_2492_ = _e3795;
                            phi_2493_ = _e3797;
                            phi_2494_ = _e3799;
                        }
                        let _e3804 = phi_2491_;
                        let _e3806 = phi_2492_;
                        let _e3808 = phi_2493_;
                        let _e3810 = phi_2494_;
                        if _e3806 {
                            phi_2498_ = false;
                            phi_2499_ = false;
                        } else {
                            phi_2498_ = _e3808;
                            phi_2499_ = _e3810;
                        }
                        let _e3812 = phi_2498_;
                        let _e3814 = phi_2499_;
                        if _e3812 {
                            phi_2503_ = false;
                            phi_2504_ = false;
                        } else {
                            phi_2503_ = _e3814;
                            phi_2504_ = _e3806;
                        }
                        let _e3816 = phi_2503_;
                        let _e3818 = phi_2504_;
                        if _e3816 {
                            phi_2508_ = true;
                            phi_2509_ = false;
                        } else {
                            phi_2508_ = _e3812;
                            phi_2509_ = _e3818;
                        }
                        let _e3820 = phi_2508_;
                        let _e3822 = phi_2509_;
                        if _e3820 {
                            let _e3824 = local_41;
                            phi_2514_ = type_55(1u, _e3824);
                            phi_2515_ = true;
                        } else {
                            phi_2514_ = _e3804;
                            phi_2515_ = _e3822;
                        }
                        let _e3827 = phi_2514_;
                        let _e3829 = phi_2515_;
                        if _e3829 {
                            phi_2519_ = _e3827;
                        } else {
                            phi_2519_ = _e3776;
                        }
                        let _e3831 = phi_2519_;
                        if (_e3831.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_2533_ = type_28(0u, 3u);
                            loop {
                                let _e3844 = phi_2533_;
                                if (_e3844.member < _e3844.member_1) {
                                    phi_2534_ = type_28((_e3844.member + 1u), _e3844.member_1);
                                    phi_2557_ = type_28(1u, _e3844.member);
                                } else {
                                    phi_2534_ = _e3844;
                                    phi_2557_ = type_28(0u, type_28().member_1);
                                }
                                let _e3858 = phi_2534_;
                                let _e3860 = phi_2557_;
                                if (bitcast<i32>(_e3860.member) != 0i) {
                                    if (_e3860.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e3867 = local_14[_e3860.member_1];
                                    let _e3868 = (_e3831.member_1 + _e3867);
                                    if (_e3868 < 1f) {
                                        phi_2577_ = _e3868;
                                    } else {
                                        phi_2577_ = 1f;
                                    }
                                    let _e3871 = phi_2577_;
                                    let _e3874 = local_15.member[0u];
                                    let _e3880 = local_15.member[1u];
                                    let _e3890 = (_e3874[0] + ((_e3880[0] - _e3874[0]) * _e3871));
                                    let _e3891 = (_e3874[1] + ((_e3880[1] - _e3874[1]) * _e3871));
                                    let _e3892 = (_e3874[2] + ((_e3880[2] - _e3874[2]) * _e3871));
                                    let _e3895 = local_15.member_1[0u];
                                    let _e3901 = local_15.member_1[1u];
                                    let _e3911 = (_e3895[0] + ((_e3901[0] - _e3895[0]) * _e3871));
                                    let _e3912 = (_e3895[1] + ((_e3901[1] - _e3895[1]) * _e3871));
                                    let _e3913 = (_e3895[2] + ((_e3901[2] - _e3895[2]) * _e3871));
                                    let _e3916 = local_15.member_2[0u];
                                    let _e3922 = local_15.member_2[1u];
                                    let _e3932 = (_e3916[0] + ((_e3922[0] - _e3916[0]) * _e3871));
                                    let _e3933 = (_e3916[1] + ((_e3922[1] - _e3916[1]) * _e3871));
                                    let _e3934 = (_e3916[2] + ((_e3922[2] - _e3916[2]) * _e3871));
                                    let _e3939 = (((_e3911 * _e3911) + (_e3912 * _e3912)) + (_e3913 * _e3913));
                                    let _e3944 = (((_e3911 * _e3932) + (_e3912 * _e3933)) + (_e3913 * _e3934));
                                    let _e3949 = (((_e3932 * _e3932) + (_e3933 * _e3933)) + (_e3934 * _e3934));
                                    let _e3954 = (((_e3890 * _e3911) + (_e3891 * _e3912)) + (_e3892 * _e3913));
                                    let _e3959 = (((_e3890 * _e3932) + (_e3891 * _e3933)) + (_e3892 * _e3934));
                                    let _e3962 = ((_e3939 * _e3949) - (_e3944 * _e3944));
                                    let _e3966 = (((_e3954 * _e3949) - (_e3959 * _e3944)) / _e3962);
                                    let _e3970 = (((_e3959 * _e3939) - (_e3954 * _e3944)) / _e3962);
                                    if (_e3966 >= 0f) {
                                        if (_e3970 >= 0f) {
                                            phi_2745_ = ((_e3966 + _e3970) <= 1f);
                                            phi_2746_ = false;
                                        } else {
                                            phi_2745_ = bool();
                                            phi_2746_ = true;
                                        }
                                        let _e3976 = phi_2745_;
                                        let _e3978 = phi_2746_;
                                        phi_2747_ = _e3976;
                                        phi_2748_ = _e3978;
                                    } else {
                                        phi_2747_ = bool();
                                        phi_2748_ = true;
                                    }
                                    let _e3980 = phi_2747_;
                                    let _e3982 = phi_2748_;
                                    if _e3982 {
                                        phi_2752_ = false;
                                    } else {
                                        phi_2752_ = _e3980;
                                    }
                                    let _e3984 = phi_2752_;
                                    if (_e3962 > 0f) {
                                        if _e3984 {
                                            phi_2774_ = array<f32, 3>((_e3890 - ((_e3911 * _e3966) + (_e3932 * _e3970))), (_e3891 - ((_e3912 * _e3966) + (_e3933 * _e3970))), (_e3892 - ((_e3913 * _e3966) + (_e3934 * _e3970))));
                                            phi_2775_ = false;
                                        } else {
                                            phi_2774_ = array<f32, 3>();
                                            phi_2775_ = true;
                                        }
                                        let _e4000 = phi_2774_;
                                        let _e4002 = phi_2775_;
                                        phi_2776_ = _e4000;
                                        phi_2777_ = _e4002;
                                    } else {
                                        phi_2776_ = array<f32, 3>();
                                        phi_2777_ = true;
                                    }
                                    let _e4004 = phi_2776_;
                                    let _e4006 = phi_2777_;
                                    if _e4006 {
                                        let _e4007 = (_e3890 - _e3911);
                                        let _e4008 = (_e3891 - _e3912);
                                        let _e4009 = (_e3892 - _e3913);
                                        let _e4010 = (_e3932 - _e3911);
                                        let _e4011 = (_e3933 - _e3912);
                                        let _e4012 = (_e3934 - _e3913);
                                        let _e4023 = ((((_e4007 * _e4010) + (_e4008 * _e4011)) + (_e4009 * _e4012)) / (((_e4010 * _e4010) + (_e4011 * _e4011)) + (_e4012 * _e4012)));
                                        if (_e4023 > 0f) {
                                            if (_e4023 < 1f) {
                                                phi_2945_ = _e4023;
                                            } else {
                                                phi_2945_ = 1f;
                                            }
                                            let _e4027 = phi_2945_;
                                            phi_2946_ = _e4027;
                                        } else {
                                            phi_2946_ = 0f;
                                        }
                                        let _e4029 = phi_2946_;
                                        let _e4033 = (_e4007 - (_e4010 * _e4029));
                                        let _e4034 = (_e4008 - (_e4011 * _e4029));
                                        let _e4035 = (_e4009 - (_e4012 * _e4029));
                                        let _e4046 = ((((_e3890 * _e3911) + (_e3891 * _e3912)) + (_e3892 * _e3913)) / (((_e3911 * _e3911) + (_e3912 * _e3912)) + (_e3913 * _e3913)));
                                        if (_e4046 > 0f) {
                                            if (_e4046 < 1f) {
                                                phi_2973_ = _e4046;
                                            } else {
                                                phi_2973_ = 1f;
                                            }
                                            let _e4050 = phi_2973_;
                                            phi_2974_ = _e4050;
                                        } else {
                                            phi_2974_ = 0f;
                                        }
                                        let _e4052 = phi_2974_;
                                        let _e4069 = ((((_e3890 * _e3932) + (_e3891 * _e3933)) + (_e3892 * _e3934)) / (((_e3932 * _e3932) + (_e3933 * _e3933)) + (_e3934 * _e3934)));
                                        if (_e4069 > 0f) {
                                            if (_e4069 < 1f) {
                                                phi_3001_ = _e4069;
                                            } else {
                                                phi_3001_ = 1f;
                                            }
                                            let _e4073 = phi_3001_;
                                            phi_3002_ = _e4073;
                                        } else {
                                            phi_3002_ = 0f;
                                        }
                                        let _e4075 = phi_3002_;
                                        local_10[0u] = array<f32, 3>((_e3890 - (_e3911 * _e4052)), (_e3891 - (_e3912 * _e4052)), (_e3892 - (_e3913 * _e4052)));
                                        local_10[1u] = array<f32, 3>((_e3890 - (_e3932 * _e4075)), (_e3891 - (_e3933 * _e4075)), (_e3892 - (_e3934 * _e4075)));
                                        local_10[2u] = array<f32, 3>(_e4033, _e4034, _e4035);
                                        local_10[3u] = array<f32, 3>(_e4033, _e4034, _e4035);
                                        let _e4091 = local_10[0u];
                                        phi_3038_ = type_28(1u, 4u);
                                        phi_3041_ = array<f32, 3>(_e4091[0], _e4091[1], _e4091[2]);
                                        loop {
                                            let _e4097 = phi_3038_;
                                            let _e4099 = phi_3041_;
                                            local_76 = _e4099;
                                            if (_e4097.member < _e4097.member_1) {
                                                phi_3039_ = type_28((_e4097.member + 1u), _e4097.member_1);
                                                phi_3064_ = type_28(1u, _e4097.member);
                                            } else {
                                                phi_3039_ = _e4097;
                                                phi_3064_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4113 = phi_3039_;
                                            let _e4115 = phi_3064_;
                                            let _e4119 = (bitcast<i32>(_e4115.member) != 0i);
                                            if _e4119 {
                                                if (_e4115.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4122 = local_10[_e4115.member_1];
                                                if (_e4115.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4128 = local_10[_e4115.member_1];
                                                if ((((_e4122[0] * _e4128[0]) + (_e4122[1] * _e4128[1])) + (_e4122[2] * _e4128[2])) < (((_e4099[0] * _e4099[0]) + (_e4099[1] * _e4099[1])) + (_e4099[2] * _e4099[2]))) {
                                                    if (_e4115.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4151 = local_10[_e4115.member_1];
                                                    phi_3131_ = array<f32, 3>(_e4151[0], _e4151[1], _e4151[2]);
                                                } else {
                                                    phi_3131_ = _e4099;
                                                }
                                                let _e4157 = phi_3131_;
                                                phi_3042_ = _e4157;
                                            } else {
                                                phi_3042_ = array<f32, 3>();
                                            }
                                            let _e4159 = phi_3042_;
                                            continue;
                                            continuing {
                                                phi_3038_ = _e4113;
                                                phi_3041_ = _e4159;
                                                break if !(_e4119);
                                            }
                                        }
                                        let _e5334 = local_76;
                                        phi_3132_ = _e5334;
                                    } else {
                                        phi_3132_ = _e4004;
                                    }
                                    let _e4162 = phi_3132_;
                                    let _e4173 = (((_e4162[0] * _e4162[0]) + (_e4162[1] * _e4162[1])) + (_e4162[2] * _e4162[2]));
                                    if (_e4173 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4173 > 0f) {
                                            phi_3157_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3157_ = 0f;
                                        }
                                        let _e4232 = phi_3157_;
                                        phi_3221_ = _e4232;
                                    } else {
                                        phi_3164_ = type_26(0i, 5i);
                                        phi_3167_ = bitcast<f32>(((bitcast<u32>(_e4173) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4181 = phi_3164_;
                                            let _e4183 = phi_3167_;
                                            local_42 = _e4183;
                                            if (_e4181.member < _e4181.member_1) {
                                                let _e4191 = (_e4181.member + 1i);
                                                if ((false == (_e4191 > _e4181.member)) != false) {
                                                    phi_3188_ = true;
                                                } else {
                                                    phi_3188_ = false;
                                                }
                                                let _e4196 = phi_3188_;
                                                if _e4196 {
                                                    phi_3194_ = type_27(0u, type_27().member_1);
                                                } else {
                                                    phi_3194_ = type_27(1u, _e4191);
                                                }
                                                let _e4202 = phi_3194_;
                                                if (bitcast<i32>(_e4202.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3165_ = type_26(_e4202.member_1, _e4181.member_1);
                                                phi_3208_ = type_27(1u, _e4181.member);
                                            } else {
                                                phi_3165_ = _e4181;
                                                phi_3208_ = type_27(0u, type_27().member_1);
                                            }
                                            let _e4212 = phi_3165_;
                                            let _e4214 = phi_3208_;
                                            let _e4217 = (bitcast<i32>(_e4214.member) != 0i);
                                            if _e4217 {
                                                phi_3168_ = (0.5f * (_e4183 + (_e4173 / _e4183)));
                                            } else {
                                                phi_3168_ = f32();
                                            }
                                            let _e4222 = phi_3168_;
                                            continue;
                                            continuing {
                                                phi_3164_ = _e4212;
                                                phi_3167_ = _e4222;
                                                break if !(_e4217);
                                            }
                                        }
                                        let _e4227 = local_42;
                                        phi_3221_ = (_e4227 * (1f + (4f * 0.000000059604645f)));
                                    }
                                    let _e4234 = phi_3221_;
                                    let _e4240 = local_15.member[0u];
                                    if (_e4240[0] < 0f) {
                                        phi_3237_ = -(_e4240[0]);
                                    } else {
                                        phi_3237_ = _e4240[0];
                                    }
                                    let _e4247 = phi_3237_;
                                    if (_e4240[1] < 0f) {
                                        phi_3244_ = -(_e4240[1]);
                                    } else {
                                        phi_3244_ = _e4240[1];
                                    }
                                    let _e4251 = phi_3244_;
                                    if (_e4247 > _e4251) {
                                        phi_3249_ = _e4247;
                                    } else {
                                        phi_3249_ = _e4251;
                                    }
                                    let _e4254 = phi_3249_;
                                    if (_e4240[2] < 0f) {
                                        phi_3256_ = -(_e4240[2]);
                                    } else {
                                        phi_3256_ = _e4240[2];
                                    }
                                    let _e4258 = phi_3256_;
                                    if (_e4254 > _e4258) {
                                        phi_3261_ = _e4254;
                                    } else {
                                        phi_3261_ = _e4258;
                                    }
                                    let _e4261 = phi_3261_;
                                    let _e4264 = local_15.member[1u];
                                    if (_e4264[0] < 0f) {
                                        phi_3274_ = -(_e4264[0]);
                                    } else {
                                        phi_3274_ = _e4264[0];
                                    }
                                    let _e4271 = phi_3274_;
                                    if (_e4264[1] < 0f) {
                                        phi_3281_ = -(_e4264[1]);
                                    } else {
                                        phi_3281_ = _e4264[1];
                                    }
                                    let _e4275 = phi_3281_;
                                    if (_e4271 > _e4275) {
                                        phi_3286_ = _e4271;
                                    } else {
                                        phi_3286_ = _e4275;
                                    }
                                    let _e4278 = phi_3286_;
                                    if (_e4264[2] < 0f) {
                                        phi_3293_ = -(_e4264[2]);
                                    } else {
                                        phi_3293_ = _e4264[2];
                                    }
                                    let _e4282 = phi_3293_;
                                    if (_e4278 > _e4282) {
                                        phi_3298_ = _e4278;
                                    } else {
                                        phi_3298_ = _e4282;
                                    }
                                    let _e4285 = phi_3298_;
                                    if (_e4261 > _e4285) {
                                        phi_3303_ = _e4261;
                                    } else {
                                        phi_3303_ = _e4285;
                                    }
                                    let _e4288 = phi_3303_;
                                    let _e4290 = local_15.member_3;
                                    let _e4294 = local_15.member_1[0u];
                                    if (_e4294[0] < 0f) {
                                        phi_3320_ = -(_e4294[0]);
                                    } else {
                                        phi_3320_ = _e4294[0];
                                    }
                                    let _e4301 = phi_3320_;
                                    if (_e4294[1] < 0f) {
                                        phi_3327_ = -(_e4294[1]);
                                    } else {
                                        phi_3327_ = _e4294[1];
                                    }
                                    let _e4305 = phi_3327_;
                                    if (_e4301 > _e4305) {
                                        phi_3332_ = _e4301;
                                    } else {
                                        phi_3332_ = _e4305;
                                    }
                                    let _e4308 = phi_3332_;
                                    if (_e4294[2] < 0f) {
                                        phi_3339_ = -(_e4294[2]);
                                    } else {
                                        phi_3339_ = _e4294[2];
                                    }
                                    let _e4312 = phi_3339_;
                                    if (_e4308 > _e4312) {
                                        phi_3344_ = _e4308;
                                    } else {
                                        phi_3344_ = _e4312;
                                    }
                                    let _e4315 = phi_3344_;
                                    let _e4318 = local_15.member_1[1u];
                                    if (_e4318[0] < 0f) {
                                        phi_3358_ = -(_e4318[0]);
                                    } else {
                                        phi_3358_ = _e4318[0];
                                    }
                                    let _e4325 = phi_3358_;
                                    if (_e4318[1] < 0f) {
                                        phi_3365_ = -(_e4318[1]);
                                    } else {
                                        phi_3365_ = _e4318[1];
                                    }
                                    let _e4329 = phi_3365_;
                                    if (_e4325 > _e4329) {
                                        phi_3370_ = _e4325;
                                    } else {
                                        phi_3370_ = _e4329;
                                    }
                                    let _e4332 = phi_3370_;
                                    if (_e4318[2] < 0f) {
                                        phi_3377_ = -(_e4318[2]);
                                    } else {
                                        phi_3377_ = _e4318[2];
                                    }
                                    let _e4336 = phi_3377_;
                                    if (_e4332 > _e4336) {
                                        phi_3382_ = _e4332;
                                    } else {
                                        phi_3382_ = _e4336;
                                    }
                                    let _e4339 = phi_3382_;
                                    if (_e4315 > _e4339) {
                                        phi_3387_ = _e4315;
                                    } else {
                                        phi_3387_ = _e4339;
                                    }
                                    let _e4342 = phi_3387_;
                                    let _e4344 = local_15.member_3;
                                    let _e4348 = local_15.member_2[0u];
                                    if (_e4348[0] < 0f) {
                                        phi_3404_ = -(_e4348[0]);
                                    } else {
                                        phi_3404_ = _e4348[0];
                                    }
                                    let _e4355 = phi_3404_;
                                    if (_e4348[1] < 0f) {
                                        phi_3411_ = -(_e4348[1]);
                                    } else {
                                        phi_3411_ = _e4348[1];
                                    }
                                    let _e4359 = phi_3411_;
                                    if (_e4355 > _e4359) {
                                        phi_3416_ = _e4355;
                                    } else {
                                        phi_3416_ = _e4359;
                                    }
                                    let _e4362 = phi_3416_;
                                    if (_e4348[2] < 0f) {
                                        phi_3423_ = -(_e4348[2]);
                                    } else {
                                        phi_3423_ = _e4348[2];
                                    }
                                    let _e4366 = phi_3423_;
                                    if (_e4362 > _e4366) {
                                        phi_3428_ = _e4362;
                                    } else {
                                        phi_3428_ = _e4366;
                                    }
                                    let _e4369 = phi_3428_;
                                    let _e4372 = local_15.member_2[1u];
                                    if (_e4372[0] < 0f) {
                                        phi_3442_ = -(_e4372[0]);
                                    } else {
                                        phi_3442_ = _e4372[0];
                                    }
                                    let _e4379 = phi_3442_;
                                    if (_e4372[1] < 0f) {
                                        phi_3449_ = -(_e4372[1]);
                                    } else {
                                        phi_3449_ = _e4372[1];
                                    }
                                    let _e4383 = phi_3449_;
                                    if (_e4379 > _e4383) {
                                        phi_3454_ = _e4379;
                                    } else {
                                        phi_3454_ = _e4383;
                                    }
                                    let _e4386 = phi_3454_;
                                    if (_e4372[2] < 0f) {
                                        phi_3461_ = -(_e4372[2]);
                                    } else {
                                        phi_3461_ = _e4372[2];
                                    }
                                    let _e4390 = phi_3461_;
                                    if (_e4386 > _e4390) {
                                        phi_3466_ = _e4386;
                                    } else {
                                        phi_3466_ = _e4390;
                                    }
                                    let _e4393 = phi_3466_;
                                    if (_e4369 > _e4393) {
                                        phi_3471_ = _e4369;
                                    } else {
                                        phi_3471_ = _e4393;
                                    }
                                    let _e4396 = phi_3471_;
                                    let _e4398 = local_15.member_3;
                                    let _e4405 = local_15.member_3;
                                    let _e4412 = (((_e4234 * (1f + (0.000000059604645f * 8f))) + (((((((_e4288 + _e4290) + (_e4342 + _e4344)) + (_e4396 + _e4398)) * (0.000000059604645f * 16f)) + (_e4405 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e262);
                                    if _e4412 {
                                        phi_3491_ = false;
                                    } else {
                                        phi_3491_ = true;
                                    }
                                    let _e4414 = phi_3491_;
                                    phi_3492_ = _e4414;
                                    phi_3493_ = _e4412;
                                } else {
                                    phi_3492_ = false;
                                    phi_3493_ = false;
                                }
                                let _e4416 = phi_3492_;
                                let _e4418 = phi_3493_;
                                local_43 = _e4418;
                                continue;
                                continuing {
                                    phi_2533_ = _e3858;
                                    break if !(_e4416);
                                }
                            }
                            let _e4421 = local_43;
                            if _e4421 {
                                phi_3498_ = type_55(1u, _e3831.member_1);
                                phi_3499_ = false;
                            } else {
                                phi_3498_ = type_55();
                                phi_3499_ = true;
                            }
                            let _e4424 = phi_3498_;
                            let _e4426 = phi_3499_;
                            if _e4426 {
                                phi_3504_ = type_55(2u, _e3831.member_1);
                                phi_3505_ = false;
                            } else {
                                phi_3504_ = type_55();
                                phi_3505_ = true;
                            }
                            let _e4429 = phi_3504_;
                            let _e4431 = phi_3505_;
                            phi_3507_ = _e4429;
                            phi_3508_ = _e4424;
                            phi_3509_ = _e4431;
                        } else {
                            phi_3507_ = type_55();
                            phi_3508_ = type_55(0u, type_55().member_1);
                            phi_3509_ = true;
                        }
                        let _e4433 = phi_3507_;
                        let _e4435 = phi_3508_;
                        let _e4437 = phi_3509_;
                        if _e4437 {
                            phi_3513_ = _e4435;
                        } else {
                            phi_3513_ = _e4433;
                        }
                        let _e4439 = phi_3513_;
                        phi_6723_ = _e4439;
                    } else {
                        if (_e360 < 0f) {
                            phi_3523_ = -(_e360);
                        } else {
                            phi_3523_ = _e360;
                        }
                        let _e703 = phi_3523_;
                        if (_e383 < 0f) {
                            phi_3529_ = -(_e383);
                        } else {
                            phi_3529_ = _e383;
                        }
                        let _e707 = phi_3529_;
                        if (_e703 > _e707) {
                            phi_3534_ = _e703;
                        } else {
                            phi_3534_ = _e707;
                        }
                        let _e710 = phi_3534_;
                        if (_e406 < 0f) {
                            phi_3540_ = -(_e406);
                        } else {
                            phi_3540_ = _e406;
                        }
                        let _e714 = phi_3540_;
                        if (_e417 < 0f) {
                            phi_3546_ = -(_e417);
                        } else {
                            phi_3546_ = _e417;
                        }
                        let _e718 = phi_3546_;
                        if (_e714 > _e718) {
                            phi_3551_ = _e714;
                        } else {
                            phi_3551_ = _e718;
                        }
                        let _e721 = phi_3551_;
                        if (_e710 > _e721) {
                            phi_3556_ = _e710;
                        } else {
                            phi_3556_ = _e721;
                        }
                        let _e724 = phi_3556_;
                        let _e727 = ((_e667 * 0.34f) + (_e724 * (0.000000059604645f * 256f)));
                        let _e729 = (_e383 - (3f * _e360));
                        let _e730 = (_e406 - _e383);
                        let _e732 = ((3f * _e417) - _e406);
                        local_7[0u] = 0f;
                        local_7[1u] = 1f;
                        local_7[2u] = 1f;
                        local_7[3u] = 1f;
                        let _e739 = ((_e730 * _e730) - (_e729 * _e732));
                        if (_e739 > 0f) {
                            if (_e739 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e739 > 0f) {
                                    phi_3589_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_3589_ = 0f;
                                }
                                let _e799 = phi_3589_;
                                phi_3653_ = _e799;
                            } else {
                                phi_3596_ = type_26(0i, 5i);
                                phi_3599_ = bitcast<f32>(((bitcast<u32>(_e739) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e748 = phi_3596_;
                                    let _e750 = phi_3599_;
                                    local_16 = _e750;
                                    if (_e748.member < _e748.member_1) {
                                        let _e758 = (_e748.member + 1i);
                                        if ((false == (_e758 > _e748.member)) != false) {
                                            phi_3620_ = true;
                                        } else {
                                            phi_3620_ = false;
                                        }
                                        let _e763 = phi_3620_;
                                        if _e763 {
                                            phi_3626_ = type_27(0u, type_27().member_1);
                                        } else {
                                            phi_3626_ = type_27(1u, _e758);
                                        }
                                        let _e769 = phi_3626_;
                                        if (bitcast<i32>(_e769.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_3597_ = type_26(_e769.member_1, _e748.member_1);
                                        phi_3640_ = type_27(1u, _e748.member);
                                    } else {
                                        phi_3597_ = _e748;
                                        phi_3640_ = type_27(0u, type_27().member_1);
                                    }
                                    let _e779 = phi_3597_;
                                    let _e781 = phi_3640_;
                                    let _e784 = (bitcast<i32>(_e781.member) != 0i);
                                    if _e784 {
                                        phi_3600_ = (0.5f * (_e750 + (_e739 / _e750)));
                                    } else {
                                        phi_3600_ = f32();
                                    }
                                    let _e789 = phi_3600_;
                                    continue;
                                    continuing {
                                        phi_3596_ = _e779;
                                        phi_3599_ = _e789;
                                        break if !(_e784);
                                    }
                                }
                                let _e794 = local_16;
                                phi_3653_ = (_e794 * (1f + (4f * 0.000000059604645f)));
                            }
                            let _e801 = phi_3653_;
                            if (_e730 < 0f) {
                                phi_3659_ = -(_e801);
                            } else {
                                phi_3659_ = _e801;
                            }
                            let _e805 = phi_3659_;
                            let _e807 = -((_e730 + _e805));
                            local_8[0u] = (_e807 / (_e807 + _e732));
                            local_8[1u] = (_e729 / (_e729 + _e807));
                            let _e816 = local_8[1u];
                            let _e817 = local_8[0u];
                            if (_e816 < _e817) {
                                let _e820 = local_8[1u];
                                let _e822 = local_8[0u];
                                local_8[0u] = _e820;
                                local_8[1u] = _e822;
                            }
                            phi_3684_ = type_28(0u, 2u);
                            phi_3687_ = 1u;
                            loop {
                                let _e826 = phi_3684_;
                                let _e828 = phi_3687_;
                                local_44 = _e828;
                                if (_e826.member < _e826.member_1) {
                                    phi_3685_ = type_28((_e826.member + 1u), _e826.member_1);
                                    phi_3710_ = type_28(1u, _e826.member);
                                } else {
                                    phi_3685_ = _e826;
                                    phi_3710_ = type_28(0u, type_28().member_1);
                                }
                                let _e842 = phi_3685_;
                                let _e844 = phi_3710_;
                                let _e848 = (bitcast<i32>(_e844.member) != 0i);
                                if _e848 {
                                    if (_e844.member_1 < 2u) {
                                    } else {
                                        return;
                                    }
                                    let _e851 = local_8[_e844.member_1];
                                    if (_e851 > 0f) {
                                        if (_e844.member_1 < 2u) {
                                        } else {
                                            return;
                                        }
                                        let _e855 = local_8[_e844.member_1];
                                        if (_e855 < 1f) {
                                            if (_e844.member_1 < 2u) {
                                            } else {
                                                return;
                                            }
                                            let _e859 = local_8[_e844.member_1];
                                            if (_e828 < 4u) {
                                            } else {
                                                return;
                                            }
                                            local_7[_e828] = _e859;
                                            phi_3754_ = (_e828 + 1u);
                                        } else {
                                            phi_3754_ = _e828;
                                        }
                                        let _e864 = phi_3754_;
                                        phi_3755_ = _e864;
                                    } else {
                                        phi_3755_ = _e828;
                                    }
                                    let _e866 = phi_3755_;
                                    phi_3688_ = _e866;
                                } else {
                                    phi_3688_ = u32();
                                }
                                let _e868 = phi_3688_;
                                continue;
                                continuing {
                                    phi_3684_ = _e842;
                                    phi_3687_ = _e868;
                                    break if !(_e848);
                                }
                            }
                            let _e4694 = local_44;
                            phi_3756_ = _e4694;
                        } else {
                            phi_3756_ = 1u;
                        }
                        let _e871 = phi_3756_;
                        if (_e871 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e871] = 1f;
                        let _e874 = local_7;
                        local_9 = _e874;
                        phi_3776_ = type_28(0u, _e871);
                        loop {
                            let _e877 = phi_3776_;
                            if (_e877.member < _e877.member_1) {
                                phi_3777_ = type_28((_e877.member + 1u), _e877.member_1);
                                phi_3800_ = type_28(1u, _e877.member);
                            } else {
                                phi_3777_ = _e877;
                                phi_3800_ = type_28(0u, type_28().member_1);
                            }
                            let _e891 = phi_3777_;
                            let _e893 = phi_3800_;
                            if (bitcast<i32>(_e893.member) != 0i) {
                                if (_e893.member_1 < 4u) {
                                } else {
                                    return;
                                }
                                let _e900 = local_9[_e893.member_1];
                                let _e901 = (_e893.member_1 + 1u);
                                if (_e901 < 4u) {
                                } else {
                                    return;
                                }
                                let _e904 = local_9[_e901];
                                let _e905 = (1f - _e900);
                                let _e916 = ((((_e360 * _e905) + (_e383 * _e900)) * (_e905 * _e905)) + (((_e406 * _e905) + (_e417 * _e900)) * (_e900 * _e900)));
                                let _e917 = (1f - _e904);
                                let _e928 = ((((_e360 * _e917) + (_e383 * _e904)) * (_e917 * _e917)) + (((_e406 * _e917) + (_e417 * _e904)) * (_e904 * _e904)));
                                if (_e916 < 0f) {
                                    phi_3852_ = -(_e916);
                                } else {
                                    phi_3852_ = _e916;
                                }
                                let _e932 = phi_3852_;
                                let _e933 = (_e932 > _e727);
                                if (_e928 < 0f) {
                                    phi_3859_ = -(_e928);
                                } else {
                                    phi_3859_ = _e928;
                                }
                                let _e937 = phi_3859_;
                                let _e938 = (_e937 > _e727);
                                if _e933 {
                                    if _e938 {
                                        phi_3870_ = ((_e916 > 0f) != (_e928 > 0f));
                                        phi_3871_ = false;
                                    } else {
                                        phi_3870_ = bool();
                                        phi_3871_ = true;
                                    }
                                    let _e943 = phi_3870_;
                                    let _e945 = phi_3871_;
                                    phi_3872_ = _e943;
                                    phi_3873_ = _e945;
                                } else {
                                    phi_3872_ = bool();
                                    phi_3873_ = true;
                                }
                                let _e947 = phi_3872_;
                                let _e949 = phi_3873_;
                                if _e949 {
                                    phi_3877_ = false;
                                } else {
                                    phi_3877_ = _e947;
                                }
                                let _e951 = phi_3877_;
                                if _e933 {
                                    if _e938 {
                                        if _e951 {
                                            phi_3888_ = type_56();
                                        } else {
                                            phi_3888_ = type_56(1f, 0f, _e951);
                                        }
                                        let _e954 = phi_3888_;
                                        phi_3889_ = _e954;
                                        phi_3890_ = _e951;
                                    } else {
                                        phi_3889_ = type_56();
                                        phi_3890_ = true;
                                    }
                                    let _e956 = phi_3889_;
                                    let _e958 = phi_3890_;
                                    phi_3891_ = _e956;
                                    phi_3892_ = _e958;
                                } else {
                                    phi_3891_ = type_56();
                                    phi_3892_ = true;
                                }
                                let _e960 = phi_3891_;
                                let _e962 = phi_3892_;
                                if _e962 {
                                    if _e933 {
                                        if (_e916 < 0f) {
                                            phi_3903_ = -1f;
                                        } else {
                                            phi_3903_ = 1f;
                                        }
                                        let _e965 = phi_3903_;
                                        let _e968 = (_e406 - _e383);
                                        phi_3913_ = type_28(0u, 64u);
                                        phi_3916_ = _e904;
                                        phi_3918_ = _e900;
                                        phi_3920_ = (0.5f * (_e900 + _e904));
                                        loop {
                                            let _e974 = phi_3913_;
                                            let _e976 = phi_3916_;
                                            let _e978 = phi_3918_;
                                            let _e980 = phi_3920_;
                                            local_46 = _e978;
                                            if (_e974.member < _e974.member_1) {
                                                phi_3914_ = type_28((_e974.member + 1u), _e974.member_1);
                                                phi_3943_ = type_28(1u, _e974.member);
                                            } else {
                                                phi_3914_ = _e974;
                                                phi_3943_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e994 = phi_3914_;
                                            let _e996 = phi_3943_;
                                            if (bitcast<i32>(_e996.member) != 0i) {
                                                let _e1000 = (1f - _e980);
                                                let _e1013 = ((_e965 * ((((_e360 * _e1000) + (_e383 * _e980)) * (_e1000 * _e1000)) + (((_e406 * _e1000) + (_e417 * _e980)) * (_e980 * _e980)))) - _e727);
                                                if (_e1013 > 0f) {
                                                    phi_3968_ = _e976;
                                                    phi_3969_ = _e980;
                                                } else {
                                                    phi_3968_ = _e980;
                                                    phi_3969_ = _e978;
                                                }
                                                let _e1016 = phi_3968_;
                                                let _e1018 = phi_3969_;
                                                let _e1020 = ((_e1016 - _e1018) > 0.00000000000022737368f);
                                                if _e1020 {
                                                    let _e1021 = (1f - _e980);
                                                    let _e1033 = (-(_e1013) / (_e965 * (((((_e383 - (3f * _e360)) * _e1021) + (_e968 * _e980)) * _e1021) + (((_e968 * _e1021) + (((3f * _e417) - _e406) * _e980)) * _e980))));
                                                    if (_e1013 > 0f) {
                                                        phi_3995_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_3995_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1039 = phi_3995_;
                                                    let _e1041 = ((_e980 + _e1033) + _e1039);
                                                    if (_e1041 > _e1018) {
                                                        if (_e1041 < _e1016) {
                                                            if (_e1033 < 0f) {
                                                                phi_4011_ = -(_e1033);
                                                            } else {
                                                                phi_4011_ = _e1033;
                                                            }
                                                            let _e1047 = phi_4011_;
                                                            if (_e1047 < (0.5f * (_e1016 - _e1018))) {
                                                                phi_4018_ = false;
                                                            } else {
                                                                phi_4018_ = true;
                                                            }
                                                            let _e1052 = phi_4018_;
                                                            phi_4019_ = _e1052;
                                                        } else {
                                                            phi_4019_ = true;
                                                        }
                                                        let _e1054 = phi_4019_;
                                                        phi_4020_ = _e1054;
                                                    } else {
                                                        phi_4020_ = true;
                                                    }
                                                    let _e1056 = phi_4020_;
                                                    if _e1056 {
                                                        phi_4026_ = (0.5f * (_e1018 + _e1016));
                                                    } else {
                                                        phi_4026_ = _e1041;
                                                    }
                                                    let _e1060 = phi_4026_;
                                                    phi_4027_ = _e1060;
                                                    phi_4028_ = false;
                                                } else {
                                                    phi_4027_ = f32();
                                                    phi_4028_ = true;
                                                }
                                                let _e1062 = phi_4027_;
                                                let _e1064 = phi_4028_;
                                                phi_3917_ = _e1016;
                                                phi_3919_ = _e1018;
                                                phi_3921_ = _e1062;
                                                phi_4029_ = _e1018;
                                                phi_4030_ = _e1020;
                                                phi_4031_ = _e1064;
                                            } else {
                                                phi_3917_ = f32();
                                                phi_3919_ = f32();
                                                phi_3921_ = f32();
                                                phi_4029_ = f32();
                                                phi_4030_ = false;
                                                phi_4031_ = false;
                                            }
                                            let _e1066 = phi_3917_;
                                            let _e1068 = phi_3919_;
                                            let _e1070 = phi_3921_;
                                            let _e1072 = phi_4029_;
                                            let _e1074 = phi_4030_;
                                            let _e1076 = phi_4031_;
                                            local_17 = _e1076;
                                            local_45 = _e1072;
                                            continue;
                                            continuing {
                                                phi_3913_ = _e994;
                                                phi_3916_ = _e1066;
                                                phi_3918_ = _e1068;
                                                phi_3920_ = _e1070;
                                                break if !(_e1074);
                                            }
                                        }
                                        let _e1079 = local_17;
                                        if _e1079 {
                                            let _e4736 = local_45;
                                            phi_4035_ = _e4736;
                                        } else {
                                            let _e4738 = local_46;
                                            phi_4035_ = _e4738;
                                        }
                                        let _e1081 = phi_4035_;
                                        phi_4036_ = _e1081;
                                    } else {
                                        phi_4036_ = _e900;
                                    }
                                    let _e1083 = phi_4036_;
                                    if _e938 {
                                        phi_4043_ = type_28(0u, 64u);
                                        phi_4046_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1086 = phi_4043_;
                                            let _e1088 = phi_4046_;
                                            if (_e1086.member < _e1086.member_1) {
                                                phi_4044_ = type_28((_e1086.member + 1u), _e1086.member_1);
                                                phi_4069_ = type_28(1u, _e1086.member);
                                            } else {
                                                phi_4044_ = _e1086;
                                                phi_4069_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1102 = phi_4044_;
                                            let _e1104 = phi_4069_;
                                            if (bitcast<i32>(_e1104.member) != 0i) {
                                                let _e1108 = (_e1083 + _e1088);
                                                if (_e1108 < _e904) {
                                                    let _e1110 = (1f - _e1108);
                                                    let _e1121 = ((((_e360 * _e1110) + (_e383 * _e1108)) * (_e1110 * _e1110)) + (((_e406 * _e1110) + (_e417 * _e1108)) * (_e1108 * _e1108)));
                                                    let _e1122 = (1f - _e1083);
                                                    let _e1133 = ((((_e360 * _e1122) + (_e383 * _e1083)) * (_e1122 * _e1122)) + (((_e406 * _e1122) + (_e417 * _e1083)) * (_e1083 * _e1083)));
                                                    if (_e1121 < 0f) {
                                                        phi_4110_ = -(_e1121);
                                                    } else {
                                                        phi_4110_ = _e1121;
                                                    }
                                                    let _e1137 = phi_4110_;
                                                    if (_e1137 > _e727) {
                                                        if (_e1133 < 0f) {
                                                            phi_4120_ = -(_e1133);
                                                        } else {
                                                            phi_4120_ = _e1133;
                                                        }
                                                        let _e1142 = phi_4120_;
                                                        if (_e1142 > _e727) {
                                                            phi_4128_ = ((_e1121 > 0f) == (_e1133 > 0f));
                                                        } else {
                                                            phi_4128_ = false;
                                                        }
                                                        let _e1148 = phi_4128_;
                                                        phi_4130_ = !(_e1148);
                                                    } else {
                                                        phi_4130_ = false;
                                                    }
                                                    let _e1151 = phi_4130_;
                                                    if _e1151 {
                                                        phi_4135_ = f32();
                                                        phi_4136_ = false;
                                                    } else {
                                                        phi_4135_ = (_e1088 + _e1088);
                                                        phi_4136_ = true;
                                                    }
                                                    let _e1154 = phi_4135_;
                                                    let _e1156 = phi_4136_;
                                                    phi_4137_ = _e1154;
                                                    phi_4138_ = _e1156;
                                                    phi_4139_ = _e1151;
                                                    phi_4140_ = false;
                                                } else {
                                                    phi_4137_ = f32();
                                                    phi_4138_ = false;
                                                    phi_4139_ = false;
                                                    phi_4140_ = true;
                                                }
                                                let _e1158 = phi_4137_;
                                                let _e1160 = phi_4138_;
                                                let _e1162 = phi_4139_;
                                                let _e1164 = phi_4140_;
                                                phi_4141_ = _e1108;
                                                phi_4047_ = _e1158;
                                                phi_4142_ = _e1160;
                                                phi_4143_ = _e1162;
                                                phi_4144_ = _e1164;
                                                phi_4145_ = false;
                                            } else {
                                                phi_4141_ = f32();
                                                phi_4047_ = f32();
                                                phi_4142_ = false;
                                                phi_4143_ = false;
                                                phi_4144_ = false;
                                                phi_4145_ = true;
                                            }
                                            let _e1166 = phi_4141_;
                                            let _e1168 = phi_4047_;
                                            let _e1170 = phi_4142_;
                                            let _e1172 = phi_4143_;
                                            let _e1174 = phi_4144_;
                                            let _e1176 = phi_4145_;
                                            local_18 = _e1172;
                                            local_47 = _e1174;
                                            local_48 = _e1176;
                                            local_49 = _e1166;
                                            continue;
                                            continuing {
                                                phi_4043_ = _e1102;
                                                phi_4046_ = _e1168;
                                                break if !(_e1170);
                                            }
                                        }
                                        let _e1179 = local_18;
                                        if _e1179 {
                                            phi_4149_ = false;
                                            phi_4150_ = false;
                                        } else {
                                            let _e4763 = local_47;
                                            phi_4149_ = _e4763;
                                            let _e4766 = local_48;
                                            phi_4150_ = _e4766;
                                        }
                                        let _e1181 = phi_4149_;
                                        let _e1183 = phi_4150_;
                                        if _e1181 {
                                            phi_4154_ = true;
                                        } else {
                                            phi_4154_ = _e1183;
                                        }
                                        let _e1185 = phi_4154_;
                                        if _e1185 {
                                            phi_4158_ = _e904;
                                        } else {
                                            let _e4770 = local_49;
                                            phi_4158_ = _e4770;
                                        }
                                        let _e1187 = phi_4158_;
                                        phi_4159_ = _e1187;
                                    } else {
                                        phi_4159_ = _e904;
                                    }
                                    let _e1189 = phi_4159_;
                                    phi_4161_ = type_56(_e1083, _e1189, _e951);
                                } else {
                                    phi_4161_ = _e960;
                                }
                                let _e1192 = phi_4161_;
                                if (_e1192.member > _e1192.member_1) {
                                    phi_6679_ = f32();
                                    phi_6680_ = true;
                                    phi_6681_ = false;
                                    phi_6682_ = false;
                                    phi_6683_ = false;
                                } else {
                                    let _e1199 = ((_e1192.member_1 - _e1192.member) * 0.5f);
                                    let _e1200 = (_e1192.member + _e1199);
                                    let _e1202 = (_e1199 + (0.000000059604645f * 4f));
                                    let _e1204 = local_15.member_3;
                                    let _e1207 = local_15.member[0u];
                                    if (_e1207[0] < 0f) {
                                        phi_4190_ = -(_e1207[0]);
                                    } else {
                                        phi_4190_ = _e1207[0];
                                    }
                                    let _e1214 = phi_4190_;
                                    if (_e1207[1] < 0f) {
                                        phi_4197_ = -(_e1207[1]);
                                    } else {
                                        phi_4197_ = _e1207[1];
                                    }
                                    let _e1218 = phi_4197_;
                                    if (_e1214 > _e1218) {
                                        phi_4202_ = _e1214;
                                    } else {
                                        phi_4202_ = _e1218;
                                    }
                                    let _e1221 = phi_4202_;
                                    if (_e1207[2] < 0f) {
                                        phi_4209_ = -(_e1207[2]);
                                    } else {
                                        phi_4209_ = _e1207[2];
                                    }
                                    let _e1225 = phi_4209_;
                                    if (_e1221 > _e1225) {
                                        phi_4214_ = _e1221;
                                    } else {
                                        phi_4214_ = _e1225;
                                    }
                                    let _e1228 = phi_4214_;
                                    let _e1230 = local_15.member[1u];
                                    if (_e1230[0] < 0f) {
                                        phi_4227_ = -(_e1230[0]);
                                    } else {
                                        phi_4227_ = _e1230[0];
                                    }
                                    let _e1237 = phi_4227_;
                                    if (_e1230[1] < 0f) {
                                        phi_4234_ = -(_e1230[1]);
                                    } else {
                                        phi_4234_ = _e1230[1];
                                    }
                                    let _e1241 = phi_4234_;
                                    if (_e1237 > _e1241) {
                                        phi_4239_ = _e1237;
                                    } else {
                                        phi_4239_ = _e1241;
                                    }
                                    let _e1244 = phi_4239_;
                                    if (_e1230[2] < 0f) {
                                        phi_4246_ = -(_e1230[2]);
                                    } else {
                                        phi_4246_ = _e1230[2];
                                    }
                                    let _e1248 = phi_4246_;
                                    if (_e1244 > _e1248) {
                                        phi_4251_ = _e1244;
                                    } else {
                                        phi_4251_ = _e1248;
                                    }
                                    let _e1251 = phi_4251_;
                                    if (_e1228 > _e1251) {
                                        phi_4256_ = _e1228;
                                    } else {
                                        phi_4256_ = _e1251;
                                    }
                                    let _e1254 = phi_4256_;
                                    let _e1257 = local_15.member[0u];
                                    let _e1262 = local_15.member[1u];
                                    let _e1272 = (_e1257[0] + ((_e1262[0] - _e1257[0]) * _e1200));
                                    let _e1273 = (_e1257[1] + ((_e1262[1] - _e1257[1]) * _e1200));
                                    let _e1274 = (_e1257[2] + ((_e1262[2] - _e1257[2]) * _e1200));
                                    let _e1276 = local_15.member[1u];
                                    let _e1281 = local_15.member[0u];
                                    let _e1285 = (_e1276[0] - _e1281[0]);
                                    let _e1286 = (_e1276[1] - _e1281[1]);
                                    let _e1287 = (_e1276[2] - _e1281[2]);
                                    if (_e1285 < 0f) {
                                        phi_4315_ = -(_e1285);
                                    } else {
                                        phi_4315_ = _e1285;
                                    }
                                    let _e1291 = phi_4315_;
                                    if (_e1286 < 0f) {
                                        phi_4321_ = -(_e1286);
                                    } else {
                                        phi_4321_ = _e1286;
                                    }
                                    let _e1295 = phi_4321_;
                                    if (_e1291 > _e1295) {
                                        phi_4326_ = _e1291;
                                    } else {
                                        phi_4326_ = _e1295;
                                    }
                                    let _e1298 = phi_4326_;
                                    if (_e1287 < 0f) {
                                        phi_4332_ = -(_e1287);
                                    } else {
                                        phi_4332_ = _e1287;
                                    }
                                    let _e1302 = phi_4332_;
                                    if (_e1298 > _e1302) {
                                        phi_4337_ = _e1298;
                                    } else {
                                        phi_4337_ = _e1302;
                                    }
                                    let _e1305 = phi_4337_;
                                    let _e1311 = ((((_e1202 * _e1305) * 1.01f) + ((_e1254 + _e1204) * (0.000000059604645f * 8f))) + _e1204);
                                    if (_e1272 < 0f) {
                                        phi_4349_ = -(_e1272);
                                    } else {
                                        phi_4349_ = _e1272;
                                    }
                                    let _e1315 = phi_4349_;
                                    if (_e1273 < 0f) {
                                        phi_4355_ = -(_e1273);
                                    } else {
                                        phi_4355_ = _e1273;
                                    }
                                    let _e1319 = phi_4355_;
                                    if (_e1315 > _e1319) {
                                        phi_4360_ = _e1315;
                                    } else {
                                        phi_4360_ = _e1319;
                                    }
                                    let _e1322 = phi_4360_;
                                    if (_e1274 < 0f) {
                                        phi_4366_ = -(_e1274);
                                    } else {
                                        phi_4366_ = _e1274;
                                    }
                                    let _e1326 = phi_4366_;
                                    if (_e1322 > _e1326) {
                                        phi_4371_ = _e1322;
                                    } else {
                                        phi_4371_ = _e1326;
                                    }
                                    let _e1329 = phi_4371_;
                                    local_3 = type_40(array<f32, 3>(_e1272, _e1273, _e1274), _e1311, (_e1329 + _e1311));
                                    let _e1335 = local_15.member_3;
                                    let _e1337 = local_15.member_1[0u];
                                    if (_e1337[0] < 0f) {
                                        phi_4397_ = -(_e1337[0]);
                                    } else {
                                        phi_4397_ = _e1337[0];
                                    }
                                    let _e1344 = phi_4397_;
                                    if (_e1337[1] < 0f) {
                                        phi_4404_ = -(_e1337[1]);
                                    } else {
                                        phi_4404_ = _e1337[1];
                                    }
                                    let _e1348 = phi_4404_;
                                    if (_e1344 > _e1348) {
                                        phi_4409_ = _e1344;
                                    } else {
                                        phi_4409_ = _e1348;
                                    }
                                    let _e1351 = phi_4409_;
                                    if (_e1337[2] < 0f) {
                                        phi_4416_ = -(_e1337[2]);
                                    } else {
                                        phi_4416_ = _e1337[2];
                                    }
                                    let _e1355 = phi_4416_;
                                    if (_e1351 > _e1355) {
                                        phi_4421_ = _e1351;
                                    } else {
                                        phi_4421_ = _e1355;
                                    }
                                    let _e1358 = phi_4421_;
                                    let _e1360 = local_15.member_1[1u];
                                    if (_e1360[0] < 0f) {
                                        phi_4434_ = -(_e1360[0]);
                                    } else {
                                        phi_4434_ = _e1360[0];
                                    }
                                    let _e1367 = phi_4434_;
                                    if (_e1360[1] < 0f) {
                                        phi_4441_ = -(_e1360[1]);
                                    } else {
                                        phi_4441_ = _e1360[1];
                                    }
                                    let _e1371 = phi_4441_;
                                    if (_e1367 > _e1371) {
                                        phi_4446_ = _e1367;
                                    } else {
                                        phi_4446_ = _e1371;
                                    }
                                    let _e1374 = phi_4446_;
                                    if (_e1360[2] < 0f) {
                                        phi_4453_ = -(_e1360[2]);
                                    } else {
                                        phi_4453_ = _e1360[2];
                                    }
                                    let _e1378 = phi_4453_;
                                    if (_e1374 > _e1378) {
                                        phi_4458_ = _e1374;
                                    } else {
                                        phi_4458_ = _e1378;
                                    }
                                    let _e1381 = phi_4458_;
                                    if (_e1358 > _e1381) {
                                        phi_4463_ = _e1358;
                                    } else {
                                        phi_4463_ = _e1381;
                                    }
                                    let _e1384 = phi_4463_;
                                    let _e1387 = local_15.member_1[0u];
                                    let _e1392 = local_15.member_1[1u];
                                    let _e1402 = (_e1387[0] + ((_e1392[0] - _e1387[0]) * _e1200));
                                    let _e1403 = (_e1387[1] + ((_e1392[1] - _e1387[1]) * _e1200));
                                    let _e1404 = (_e1387[2] + ((_e1392[2] - _e1387[2]) * _e1200));
                                    let _e1406 = local_15.member_1[1u];
                                    let _e1411 = local_15.member_1[0u];
                                    let _e1415 = (_e1406[0] - _e1411[0]);
                                    let _e1416 = (_e1406[1] - _e1411[1]);
                                    let _e1417 = (_e1406[2] - _e1411[2]);
                                    if (_e1415 < 0f) {
                                        phi_4522_ = -(_e1415);
                                    } else {
                                        phi_4522_ = _e1415;
                                    }
                                    let _e1421 = phi_4522_;
                                    if (_e1416 < 0f) {
                                        phi_4528_ = -(_e1416);
                                    } else {
                                        phi_4528_ = _e1416;
                                    }
                                    let _e1425 = phi_4528_;
                                    if (_e1421 > _e1425) {
                                        phi_4533_ = _e1421;
                                    } else {
                                        phi_4533_ = _e1425;
                                    }
                                    let _e1428 = phi_4533_;
                                    if (_e1417 < 0f) {
                                        phi_4539_ = -(_e1417);
                                    } else {
                                        phi_4539_ = _e1417;
                                    }
                                    let _e1432 = phi_4539_;
                                    if (_e1428 > _e1432) {
                                        phi_4544_ = _e1428;
                                    } else {
                                        phi_4544_ = _e1432;
                                    }
                                    let _e1435 = phi_4544_;
                                    let _e1441 = ((((_e1202 * _e1435) * 1.01f) + ((_e1384 + _e1335) * (0.000000059604645f * 8f))) + _e1335);
                                    if (_e1402 < 0f) {
                                        phi_4556_ = -(_e1402);
                                    } else {
                                        phi_4556_ = _e1402;
                                    }
                                    let _e1445 = phi_4556_;
                                    if (_e1403 < 0f) {
                                        phi_4562_ = -(_e1403);
                                    } else {
                                        phi_4562_ = _e1403;
                                    }
                                    let _e1449 = phi_4562_;
                                    if (_e1445 > _e1449) {
                                        phi_4567_ = _e1445;
                                    } else {
                                        phi_4567_ = _e1449;
                                    }
                                    let _e1452 = phi_4567_;
                                    if (_e1404 < 0f) {
                                        phi_4573_ = -(_e1404);
                                    } else {
                                        phi_4573_ = _e1404;
                                    }
                                    let _e1456 = phi_4573_;
                                    if (_e1452 > _e1456) {
                                        phi_4578_ = _e1452;
                                    } else {
                                        phi_4578_ = _e1456;
                                    }
                                    let _e1459 = phi_4578_;
                                    local_4 = type_40(array<f32, 3>(_e1402, _e1403, _e1404), _e1441, (_e1459 + _e1441));
                                    let _e1465 = local_15.member_3;
                                    let _e1467 = local_15.member_2[0u];
                                    if (_e1467[0] < 0f) {
                                        phi_4604_ = -(_e1467[0]);
                                    } else {
                                        phi_4604_ = _e1467[0];
                                    }
                                    let _e1474 = phi_4604_;
                                    if (_e1467[1] < 0f) {
                                        phi_4611_ = -(_e1467[1]);
                                    } else {
                                        phi_4611_ = _e1467[1];
                                    }
                                    let _e1478 = phi_4611_;
                                    if (_e1474 > _e1478) {
                                        phi_4616_ = _e1474;
                                    } else {
                                        phi_4616_ = _e1478;
                                    }
                                    let _e1481 = phi_4616_;
                                    if (_e1467[2] < 0f) {
                                        phi_4623_ = -(_e1467[2]);
                                    } else {
                                        phi_4623_ = _e1467[2];
                                    }
                                    let _e1485 = phi_4623_;
                                    if (_e1481 > _e1485) {
                                        phi_4628_ = _e1481;
                                    } else {
                                        phi_4628_ = _e1485;
                                    }
                                    let _e1488 = phi_4628_;
                                    let _e1490 = local_15.member_2[1u];
                                    if (_e1490[0] < 0f) {
                                        phi_4641_ = -(_e1490[0]);
                                    } else {
                                        phi_4641_ = _e1490[0];
                                    }
                                    let _e1497 = phi_4641_;
                                    if (_e1490[1] < 0f) {
                                        phi_4648_ = -(_e1490[1]);
                                    } else {
                                        phi_4648_ = _e1490[1];
                                    }
                                    let _e1501 = phi_4648_;
                                    if (_e1497 > _e1501) {
                                        phi_4653_ = _e1497;
                                    } else {
                                        phi_4653_ = _e1501;
                                    }
                                    let _e1504 = phi_4653_;
                                    if (_e1490[2] < 0f) {
                                        phi_4660_ = -(_e1490[2]);
                                    } else {
                                        phi_4660_ = _e1490[2];
                                    }
                                    let _e1508 = phi_4660_;
                                    if (_e1504 > _e1508) {
                                        phi_4665_ = _e1504;
                                    } else {
                                        phi_4665_ = _e1508;
                                    }
                                    let _e1511 = phi_4665_;
                                    if (_e1488 > _e1511) {
                                        phi_4670_ = _e1488;
                                    } else {
                                        phi_4670_ = _e1511;
                                    }
                                    let _e1514 = phi_4670_;
                                    let _e1517 = local_15.member_2[0u];
                                    let _e1522 = local_15.member_2[1u];
                                    let _e1532 = (_e1517[0] + ((_e1522[0] - _e1517[0]) * _e1200));
                                    let _e1533 = (_e1517[1] + ((_e1522[1] - _e1517[1]) * _e1200));
                                    let _e1534 = (_e1517[2] + ((_e1522[2] - _e1517[2]) * _e1200));
                                    let _e1536 = local_15.member_2[1u];
                                    let _e1541 = local_15.member_2[0u];
                                    let _e1545 = (_e1536[0] - _e1541[0]);
                                    let _e1546 = (_e1536[1] - _e1541[1]);
                                    let _e1547 = (_e1536[2] - _e1541[2]);
                                    if (_e1545 < 0f) {
                                        phi_4729_ = -(_e1545);
                                    } else {
                                        phi_4729_ = _e1545;
                                    }
                                    let _e1551 = phi_4729_;
                                    if (_e1546 < 0f) {
                                        phi_4735_ = -(_e1546);
                                    } else {
                                        phi_4735_ = _e1546;
                                    }
                                    let _e1555 = phi_4735_;
                                    if (_e1551 > _e1555) {
                                        phi_4740_ = _e1551;
                                    } else {
                                        phi_4740_ = _e1555;
                                    }
                                    let _e1558 = phi_4740_;
                                    if (_e1547 < 0f) {
                                        phi_4746_ = -(_e1547);
                                    } else {
                                        phi_4746_ = _e1547;
                                    }
                                    let _e1562 = phi_4746_;
                                    if (_e1558 > _e1562) {
                                        phi_4751_ = _e1558;
                                    } else {
                                        phi_4751_ = _e1562;
                                    }
                                    let _e1565 = phi_4751_;
                                    let _e1571 = ((((_e1202 * _e1565) * 1.01f) + ((_e1514 + _e1465) * (0.000000059604645f * 8f))) + _e1465);
                                    if (_e1532 < 0f) {
                                        phi_4763_ = -(_e1532);
                                    } else {
                                        phi_4763_ = _e1532;
                                    }
                                    let _e1575 = phi_4763_;
                                    if (_e1533 < 0f) {
                                        phi_4769_ = -(_e1533);
                                    } else {
                                        phi_4769_ = _e1533;
                                    }
                                    let _e1579 = phi_4769_;
                                    if (_e1575 > _e1579) {
                                        phi_4774_ = _e1575;
                                    } else {
                                        phi_4774_ = _e1579;
                                    }
                                    let _e1582 = phi_4774_;
                                    if (_e1534 < 0f) {
                                        phi_4780_ = -(_e1534);
                                    } else {
                                        phi_4780_ = _e1534;
                                    }
                                    let _e1586 = phi_4780_;
                                    if (_e1582 > _e1586) {
                                        phi_4785_ = _e1582;
                                    } else {
                                        phi_4785_ = _e1586;
                                    }
                                    let _e1589 = phi_4785_;
                                    local_5 = type_40(array<f32, 3>(_e1532, _e1533, _e1534), _e1571, (_e1589 + _e1571));
                                    let _e1594 = local_4.member;
                                    let _e1599 = local_5.member;
                                    let _e1605 = ((_e1594[1] * _e1599[2]) - (_e1594[2] * _e1599[1]));
                                    let _e1608 = ((_e1594[2] * _e1599[0]) - (_e1594[0] * _e1599[2]));
                                    let _e1611 = ((_e1594[0] * _e1599[1]) - (_e1594[1] * _e1599[0]));
                                    if (_e1605 < 0f) {
                                        phi_4834_ = -(_e1605);
                                    } else {
                                        phi_4834_ = _e1605;
                                    }
                                    let _e1615 = phi_4834_;
                                    if (_e1608 < 0f) {
                                        phi_4840_ = -(_e1608);
                                    } else {
                                        phi_4840_ = _e1608;
                                    }
                                    let _e1619 = phi_4840_;
                                    if (_e1615 > _e1619) {
                                        if (_e1605 < 0f) {
                                            phi_4850_ = -(_e1605);
                                        } else {
                                            phi_4850_ = _e1605;
                                        }
                                        let _e1637 = phi_4850_;
                                        if (_e1611 < 0f) {
                                            phi_4856_ = -(_e1611);
                                        } else {
                                            phi_4856_ = _e1611;
                                        }
                                        let _e1641 = phi_4856_;
                                        if (_e1637 > _e1641) {
                                            phi_4861_ = 2u;
                                            phi_4862_ = 1u;
                                        } else {
                                            phi_4861_ = 1u;
                                            phi_4862_ = 0u;
                                        }
                                        let _e1644 = phi_4861_;
                                        let _e1646 = phi_4862_;
                                        phi_4881_ = _e1644;
                                        phi_4882_ = _e1646;
                                    } else {
                                        if (_e1608 < 0f) {
                                            phi_4868_ = -(_e1608);
                                        } else {
                                            phi_4868_ = _e1608;
                                        }
                                        let _e1624 = phi_4868_;
                                        if (_e1611 < 0f) {
                                            phi_4874_ = -(_e1611);
                                        } else {
                                            phi_4874_ = _e1611;
                                        }
                                        let _e1628 = phi_4874_;
                                        if (_e1624 > _e1628) {
                                            phi_4879_ = 0u;
                                            phi_4880_ = 2u;
                                        } else {
                                            phi_4879_ = 1u;
                                            phi_4880_ = 0u;
                                        }
                                        let _e1631 = phi_4879_;
                                        let _e1633 = phi_4880_;
                                        phi_4881_ = _e1631;
                                        phi_4882_ = _e1633;
                                    }
                                    let _e1648 = phi_4881_;
                                    let _e1650 = phi_4882_;
                                    if (_e1650 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1654 = local_4.member[_e1650];
                                    if (_e1648 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1658 = local_5.member[_e1648];
                                    if (_e1648 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1663 = local_4.member[_e1648];
                                    if (_e1650 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1667 = local_5.member[_e1650];
                                    let _e1669 = ((_e1654 * _e1658) - (_e1663 * _e1667));
                                    let _e1671 = local_4.member_1;
                                    let _e1673 = local_5.member_2;
                                    let _e1676 = local_4.member_2;
                                    let _e1678 = local_5.member_1;
                                    let _e1683 = local_4.member_2;
                                    let _e1685 = local_5.member_2;
                                    let _e1692 = local_4.member_2;
                                    let _e1695 = local_5.member_2;
                                    let _e1699 = (((((_e1671 * _e1673) + (_e1676 * _e1678)) * 2.01f) + ((_e1683 * _e1685) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1692) * (1f + _e1695))));
                                    if (_e1669 < 0f) {
                                        phi_4949_ = -(_e1669);
                                    } else {
                                        phi_4949_ = _e1669;
                                    }
                                    let _e1703 = phi_4949_;
                                    if (_e1703 > _e1699) {
                                        if (_e1669 < 0f) {
                                            phi_4958_ = -1f;
                                        } else {
                                            phi_4958_ = 1f;
                                        }
                                        let _e1707 = phi_4958_;
                                        if (_e1650 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1711 = local_3.member[_e1650];
                                        if (_e1648 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1715 = local_5.member[_e1648];
                                        if (_e1648 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1720 = local_3.member[_e1648];
                                        if (_e1650 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1724 = local_5.member[_e1650];
                                        let _e1728 = local_3.member_1;
                                        let _e1730 = local_5.member_2;
                                        let _e1733 = local_3.member_2;
                                        let _e1735 = local_5.member_1;
                                        let _e1740 = local_3.member_2;
                                        let _e1742 = local_5.member_2;
                                        let _e1749 = local_3.member_2;
                                        let _e1752 = local_5.member_2;
                                        let _e1756 = (((((_e1728 * _e1730) + (_e1733 * _e1735)) * 2.01f) + ((_e1740 * _e1742) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1749) * (1f + _e1752))));
                                        if (_e1650 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1760 = local_4.member[_e1650];
                                        if (_e1648 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1764 = local_3.member[_e1648];
                                        if (_e1648 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1769 = local_4.member[_e1648];
                                        if (_e1650 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1773 = local_3.member[_e1650];
                                        let _e1777 = local_4.member_1;
                                        let _e1779 = local_3.member_2;
                                        let _e1782 = local_4.member_2;
                                        let _e1784 = local_3.member_1;
                                        let _e1789 = local_4.member_2;
                                        let _e1791 = local_3.member_2;
                                        let _e1798 = local_4.member_2;
                                        let _e1801 = local_3.member_2;
                                        let _e1805 = (((((_e1777 * _e1779) + (_e1782 * _e1784)) * 2.01f) + ((_e1789 * _e1791) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1798) * (1f + _e1801))));
                                        let _e1806 = (_e1669 * _e1707);
                                        let _e1807 = (((_e1711 * _e1715) - (_e1720 * _e1724)) * _e1707);
                                        let _e1808 = (((_e1760 * _e1764) - (_e1769 * _e1773)) * _e1707);
                                        if (_e1806 < 0f) {
                                            phi_5089_ = -(_e1806);
                                        } else {
                                            phi_5089_ = _e1806;
                                        }
                                        let _e1812 = phi_5089_;
                                        if (_e1807 < 0f) {
                                            phi_5095_ = -(_e1807);
                                        } else {
                                            phi_5095_ = _e1807;
                                        }
                                        let _e1816 = phi_5095_;
                                        if (_e1808 < 0f) {
                                            phi_5102_ = -(_e1808);
                                        } else {
                                            phi_5102_ = _e1808;
                                        }
                                        let _e1821 = phi_5102_;
                                        let _e1826 = ((_e1806 - _e1807) - _e1808);
                                        let _e1829 = (((_e1699 + _e1756) + _e1805) + (((_e1812 + _e1816) + _e1821) * (0.000000059604645f * 4f)));
                                        local_6[0u].member = _e1807;
                                        local_6[0u].member_1 = _e1756;
                                        local_6[1u].member = _e1808;
                                        local_6[1u].member_1 = _e1805;
                                        local_6[2u].member = _e1826;
                                        local_6[2u].member_1 = _e1829;
                                        local_6[3u].member = _e1826;
                                        local_6[3u].member_1 = _e1829;
                                        phi_5145_ = type_28(0u, 4u);
                                        phi_5148_ = true;
                                        loop {
                                            let _e1844 = phi_5145_;
                                            let _e1846 = phi_5148_;
                                            local_20 = _e1846;
                                            if (_e1844.member < _e1844.member_1) {
                                                phi_5146_ = type_28((_e1844.member + 1u), _e1844.member_1);
                                                phi_5171_ = type_28(1u, _e1844.member);
                                            } else {
                                                phi_5146_ = _e1844;
                                                phi_5171_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1860 = phi_5146_;
                                            let _e1862 = phi_5171_;
                                            if (bitcast<i32>(_e1862.member) != 0i) {
                                                if (_e1862.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1870 = local_6[_e1862.member_1].member;
                                                let _e1873 = local_6[_e1862.member_1].member_1;
                                                let _e1875 = (_e1870 < -(_e1873));
                                                if _e1875 {
                                                    phi_5198_ = bool();
                                                    phi_5199_ = false;
                                                } else {
                                                    phi_5198_ = (_e1846 && (_e1870 > _e1873));
                                                    phi_5199_ = true;
                                                }
                                                let _e1879 = phi_5198_;
                                                let _e1881 = phi_5199_;
                                                phi_5149_ = _e1879;
                                                phi_5200_ = _e1881;
                                                phi_5201_ = _e1875;
                                            } else {
                                                phi_5149_ = bool();
                                                phi_5200_ = false;
                                                phi_5201_ = false;
                                            }
                                            let _e1883 = phi_5149_;
                                            let _e1885 = phi_5200_;
                                            let _e1887 = phi_5201_;
                                            local_19 = _e1887;
                                            continue;
                                            continuing {
                                                phi_5145_ = _e1860;
                                                phi_5148_ = _e1883;
                                                break if !(_e1885);
                                            }
                                        }
                                        let _e1890 = local_19;
                                        if _e1890 {
                                            phi_5205_ = false;
                                        } else {
                                            phi_5205_ = true;
                                        }
                                        let _e1892 = phi_5205_;
                                        if _e1892 {
                                            let _e1894 = local_20;
                                            if _e1894 {
                                                phi_5212_ = 1u;
                                            } else {
                                                phi_5212_ = 2u;
                                            }
                                            let _e1896 = phi_5212_;
                                            phi_5213_ = _e1896;
                                            phi_5214_ = false;
                                        } else {
                                            phi_5213_ = u32();
                                            phi_5214_ = true;
                                        }
                                        let _e1898 = phi_5213_;
                                        let _e1900 = phi_5214_;
                                        phi_5215_ = _e1898;
                                        phi_5216_ = 0u;
                                        phi_5217_ = _e1900;
                                    } else {
                                        phi_5215_ = u32();
                                        phi_5216_ = 2u;
                                        phi_5217_ = true;
                                    }
                                    let _e1902 = phi_5215_;
                                    let _e1904 = phi_5216_;
                                    let _e1906 = phi_5217_;
                                    if _e1906 {
                                        phi_5221_ = _e1904;
                                    } else {
                                        phi_5221_ = _e1902;
                                    }
                                    let _e1908 = phi_5221_;
                                    let _e1909 = (_e1908 == 0u);
                                    if _e1909 {
                                        phi_6675_ = f32();
                                        phi_6676_ = false;
                                        phi_6677_ = false;
                                        phi_6678_ = false;
                                    } else {
                                        if (_e1908 == 1u) {
                                            if _e1192.member_2 {
                                                if ((_e1192.member_1 - _e1192.member) <= 0.0000005f) {
                                                    phi_5241_ = false;
                                                } else {
                                                    phi_5241_ = true;
                                                }
                                                let _e1917 = phi_5241_;
                                                phi_5242_ = _e1917;
                                            } else {
                                                phi_5242_ = true;
                                            }
                                            let _e1919 = phi_5242_;
                                            phi_5243_ = _e1919;
                                        } else {
                                            phi_5243_ = true;
                                        }
                                        let _e1921 = phi_5243_;
                                        if _e1921 {
                                            let _e1926 = local_15.member[0u];
                                            let _e1932 = local_15.member_1[0u];
                                            let _e1938 = local_15.member_2[0u];
                                            local_1 = array<array<f32, 3>, 4>(_e1926, array<f32, 3>((_e1926[0] - _e1932[0]), (_e1926[1] - _e1932[1]), (_e1926[2] - _e1932[2])), array<f32, 3>((_e1926[0] - _e1938[0]), (_e1926[1] - _e1938[1]), (_e1926[2] - _e1938[2])), _e1926);
                                            let _e1953 = local_15.member[1u];
                                            let _e1959 = local_15.member_1[1u];
                                            let _e1965 = local_15.member_2[1u];
                                            local_2 = array<array<f32, 3>, 4>(_e1953, array<f32, 3>((_e1953[0] - _e1959[0]), (_e1953[1] - _e1959[1]), (_e1953[2] - _e1959[2])), array<f32, 3>((_e1953[0] - _e1965[0]), (_e1953[1] - _e1965[1]), (_e1953[2] - _e1965[2])), _e1953);
                                            let _e1980 = local_15.member[0u];
                                            if (_e1980[0] < 0f) {
                                                phi_5439_ = -(_e1980[0]);
                                            } else {
                                                phi_5439_ = _e1980[0];
                                            }
                                            let _e1987 = phi_5439_;
                                            if (_e1980[1] < 0f) {
                                                phi_5446_ = -(_e1980[1]);
                                            } else {
                                                phi_5446_ = _e1980[1];
                                            }
                                            let _e1991 = phi_5446_;
                                            if (_e1987 > _e1991) {
                                                phi_5451_ = _e1987;
                                            } else {
                                                phi_5451_ = _e1991;
                                            }
                                            let _e1994 = phi_5451_;
                                            if (_e1980[2] < 0f) {
                                                phi_5458_ = -(_e1980[2]);
                                            } else {
                                                phi_5458_ = _e1980[2];
                                            }
                                            let _e1998 = phi_5458_;
                                            if (_e1994 > _e1998) {
                                                phi_5463_ = _e1994;
                                            } else {
                                                phi_5463_ = _e1998;
                                            }
                                            let _e2001 = phi_5463_;
                                            let _e2004 = local_15.member[1u];
                                            if (_e2004[0] < 0f) {
                                                phi_5476_ = -(_e2004[0]);
                                            } else {
                                                phi_5476_ = _e2004[0];
                                            }
                                            let _e2011 = phi_5476_;
                                            if (_e2004[1] < 0f) {
                                                phi_5483_ = -(_e2004[1]);
                                            } else {
                                                phi_5483_ = _e2004[1];
                                            }
                                            let _e2015 = phi_5483_;
                                            if (_e2011 > _e2015) {
                                                phi_5488_ = _e2011;
                                            } else {
                                                phi_5488_ = _e2015;
                                            }
                                            let _e2018 = phi_5488_;
                                            if (_e2004[2] < 0f) {
                                                phi_5495_ = -(_e2004[2]);
                                            } else {
                                                phi_5495_ = _e2004[2];
                                            }
                                            let _e2022 = phi_5495_;
                                            if (_e2018 > _e2022) {
                                                phi_5500_ = _e2018;
                                            } else {
                                                phi_5500_ = _e2022;
                                            }
                                            let _e2025 = phi_5500_;
                                            if (_e2001 > _e2025) {
                                                phi_5505_ = _e2001;
                                            } else {
                                                phi_5505_ = _e2025;
                                            }
                                            let _e2028 = phi_5505_;
                                            let _e2030 = local_15.member_3;
                                            let _e2034 = local_15.member_1[0u];
                                            if (_e2034[0] < 0f) {
                                                phi_5522_ = -(_e2034[0]);
                                            } else {
                                                phi_5522_ = _e2034[0];
                                            }
                                            let _e2041 = phi_5522_;
                                            if (_e2034[1] < 0f) {
                                                phi_5529_ = -(_e2034[1]);
                                            } else {
                                                phi_5529_ = _e2034[1];
                                            }
                                            let _e2045 = phi_5529_;
                                            if (_e2041 > _e2045) {
                                                phi_5534_ = _e2041;
                                            } else {
                                                phi_5534_ = _e2045;
                                            }
                                            let _e2048 = phi_5534_;
                                            if (_e2034[2] < 0f) {
                                                phi_5541_ = -(_e2034[2]);
                                            } else {
                                                phi_5541_ = _e2034[2];
                                            }
                                            let _e2052 = phi_5541_;
                                            if (_e2048 > _e2052) {
                                                phi_5546_ = _e2048;
                                            } else {
                                                phi_5546_ = _e2052;
                                            }
                                            let _e2055 = phi_5546_;
                                            let _e2058 = local_15.member_1[1u];
                                            if (_e2058[0] < 0f) {
                                                phi_5560_ = -(_e2058[0]);
                                            } else {
                                                phi_5560_ = _e2058[0];
                                            }
                                            let _e2065 = phi_5560_;
                                            if (_e2058[1] < 0f) {
                                                phi_5567_ = -(_e2058[1]);
                                            } else {
                                                phi_5567_ = _e2058[1];
                                            }
                                            let _e2069 = phi_5567_;
                                            if (_e2065 > _e2069) {
                                                phi_5572_ = _e2065;
                                            } else {
                                                phi_5572_ = _e2069;
                                            }
                                            let _e2072 = phi_5572_;
                                            if (_e2058[2] < 0f) {
                                                phi_5579_ = -(_e2058[2]);
                                            } else {
                                                phi_5579_ = _e2058[2];
                                            }
                                            let _e2076 = phi_5579_;
                                            if (_e2072 > _e2076) {
                                                phi_5584_ = _e2072;
                                            } else {
                                                phi_5584_ = _e2076;
                                            }
                                            let _e2079 = phi_5584_;
                                            if (_e2055 > _e2079) {
                                                phi_5589_ = _e2055;
                                            } else {
                                                phi_5589_ = _e2079;
                                            }
                                            let _e2082 = phi_5589_;
                                            let _e2084 = local_15.member_3;
                                            let _e2088 = local_15.member_2[0u];
                                            if (_e2088[0] < 0f) {
                                                phi_5606_ = -(_e2088[0]);
                                            } else {
                                                phi_5606_ = _e2088[0];
                                            }
                                            let _e2095 = phi_5606_;
                                            if (_e2088[1] < 0f) {
                                                phi_5613_ = -(_e2088[1]);
                                            } else {
                                                phi_5613_ = _e2088[1];
                                            }
                                            let _e2099 = phi_5613_;
                                            if (_e2095 > _e2099) {
                                                phi_5618_ = _e2095;
                                            } else {
                                                phi_5618_ = _e2099;
                                            }
                                            let _e2102 = phi_5618_;
                                            if (_e2088[2] < 0f) {
                                                phi_5625_ = -(_e2088[2]);
                                            } else {
                                                phi_5625_ = _e2088[2];
                                            }
                                            let _e2106 = phi_5625_;
                                            if (_e2102 > _e2106) {
                                                phi_5630_ = _e2102;
                                            } else {
                                                phi_5630_ = _e2106;
                                            }
                                            let _e2109 = phi_5630_;
                                            let _e2112 = local_15.member_2[1u];
                                            if (_e2112[0] < 0f) {
                                                phi_5644_ = -(_e2112[0]);
                                            } else {
                                                phi_5644_ = _e2112[0];
                                            }
                                            let _e2119 = phi_5644_;
                                            if (_e2112[1] < 0f) {
                                                phi_5651_ = -(_e2112[1]);
                                            } else {
                                                phi_5651_ = _e2112[1];
                                            }
                                            let _e2123 = phi_5651_;
                                            if (_e2119 > _e2123) {
                                                phi_5656_ = _e2119;
                                            } else {
                                                phi_5656_ = _e2123;
                                            }
                                            let _e2126 = phi_5656_;
                                            if (_e2112[2] < 0f) {
                                                phi_5663_ = -(_e2112[2]);
                                            } else {
                                                phi_5663_ = _e2112[2];
                                            }
                                            let _e2130 = phi_5663_;
                                            if (_e2126 > _e2130) {
                                                phi_5668_ = _e2126;
                                            } else {
                                                phi_5668_ = _e2130;
                                            }
                                            let _e2133 = phi_5668_;
                                            if (_e2109 > _e2133) {
                                                phi_5673_ = _e2109;
                                            } else {
                                                phi_5673_ = _e2133;
                                            }
                                            let _e2136 = phi_5673_;
                                            let _e2138 = local_15.member_3;
                                            let _e2145 = local_15.member_3;
                                            phi_5689_ = type_28(0u, 48u);
                                            phi_5692_ = _e1192.member;
                                            loop {
                                                let _e2151 = phi_5689_;
                                                let _e2153 = phi_5692_;
                                                local_60 = _e2153;
                                                local_27 = _e2153;
                                                local_28 = _e2153;
                                                local_29 = _e2153;
                                                if (_e2151.member < _e2151.member_1) {
                                                    phi_5690_ = type_28((_e2151.member + 1u), _e2151.member_1);
                                                    phi_5715_ = type_28(1u, _e2151.member);
                                                } else {
                                                    phi_5690_ = _e2151;
                                                    phi_5715_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e2167 = phi_5690_;
                                                let _e2169 = phi_5715_;
                                                if (bitcast<i32>(_e2169.member) != 0i) {
                                                    let _e2175 = local_15.member[0u];
                                                    let _e2181 = local_15.member[1u];
                                                    let _e2191 = (_e2175[0] + ((_e2181[0] - _e2175[0]) * _e2153));
                                                    let _e2192 = (_e2175[1] + ((_e2181[1] - _e2175[1]) * _e2153));
                                                    let _e2193 = (_e2175[2] + ((_e2181[2] - _e2175[2]) * _e2153));
                                                    let _e2196 = local_15.member_1[0u];
                                                    let _e2202 = local_15.member_1[1u];
                                                    let _e2212 = (_e2196[0] + ((_e2202[0] - _e2196[0]) * _e2153));
                                                    let _e2213 = (_e2196[1] + ((_e2202[1] - _e2196[1]) * _e2153));
                                                    let _e2214 = (_e2196[2] + ((_e2202[2] - _e2196[2]) * _e2153));
                                                    let _e2217 = local_15.member_2[0u];
                                                    let _e2223 = local_15.member_2[1u];
                                                    let _e2233 = (_e2217[0] + ((_e2223[0] - _e2217[0]) * _e2153));
                                                    let _e2234 = (_e2217[1] + ((_e2223[1] - _e2217[1]) * _e2153));
                                                    let _e2235 = (_e2217[2] + ((_e2223[2] - _e2217[2]) * _e2153));
                                                    let _e2240 = (((_e2212 * _e2212) + (_e2213 * _e2213)) + (_e2214 * _e2214));
                                                    let _e2245 = (((_e2212 * _e2233) + (_e2213 * _e2234)) + (_e2214 * _e2235));
                                                    let _e2250 = (((_e2233 * _e2233) + (_e2234 * _e2234)) + (_e2235 * _e2235));
                                                    let _e2255 = (((_e2191 * _e2212) + (_e2192 * _e2213)) + (_e2193 * _e2214));
                                                    let _e2260 = (((_e2191 * _e2233) + (_e2192 * _e2234)) + (_e2193 * _e2235));
                                                    let _e2263 = ((_e2240 * _e2250) - (_e2245 * _e2245));
                                                    let _e2267 = (((_e2255 * _e2250) - (_e2260 * _e2245)) / _e2263);
                                                    let _e2271 = (((_e2260 * _e2240) - (_e2255 * _e2245)) / _e2263);
                                                    if (_e2267 >= 0f) {
                                                        if (_e2271 >= 0f) {
                                                            phi_5889_ = ((_e2267 + _e2271) <= 1f);
                                                            phi_5890_ = false;
                                                        } else {
                                                            phi_5889_ = bool();
                                                            phi_5890_ = true;
                                                        }
                                                        let _e2277 = phi_5889_;
                                                        let _e2279 = phi_5890_;
                                                        phi_5891_ = _e2277;
                                                        phi_5892_ = _e2279;
                                                    } else {
                                                        phi_5891_ = bool();
                                                        phi_5892_ = true;
                                                    }
                                                    let _e2281 = phi_5891_;
                                                    let _e2283 = phi_5892_;
                                                    if _e2283 {
                                                        phi_5896_ = false;
                                                    } else {
                                                        phi_5896_ = _e2281;
                                                    }
                                                    let _e2285 = phi_5896_;
                                                    if (_e2263 > 0f) {
                                                        if _e2285 {
                                                            phi_5918_ = array<f32, 3>((_e2191 - ((_e2212 * _e2267) + (_e2233 * _e2271))), (_e2192 - ((_e2213 * _e2267) + (_e2234 * _e2271))), (_e2193 - ((_e2214 * _e2267) + (_e2235 * _e2271))));
                                                            phi_5919_ = false;
                                                        } else {
                                                            phi_5918_ = array<f32, 3>();
                                                            phi_5919_ = true;
                                                        }
                                                        let _e2301 = phi_5918_;
                                                        let _e2303 = phi_5919_;
                                                        phi_5920_ = _e2301;
                                                        phi_5921_ = _e2303;
                                                    } else {
                                                        phi_5920_ = array<f32, 3>();
                                                        phi_5921_ = true;
                                                    }
                                                    let _e2305 = phi_5920_;
                                                    let _e2307 = phi_5921_;
                                                    if _e2307 {
                                                        let _e2308 = (_e2191 - _e2212);
                                                        let _e2309 = (_e2192 - _e2213);
                                                        let _e2310 = (_e2193 - _e2214);
                                                        let _e2311 = (_e2233 - _e2212);
                                                        let _e2312 = (_e2234 - _e2213);
                                                        let _e2313 = (_e2235 - _e2214);
                                                        let _e2324 = ((((_e2308 * _e2311) + (_e2309 * _e2312)) + (_e2310 * _e2313)) / (((_e2311 * _e2311) + (_e2312 * _e2312)) + (_e2313 * _e2313)));
                                                        if (_e2324 > 0f) {
                                                            if (_e2324 < 1f) {
                                                                phi_6089_ = _e2324;
                                                            } else {
                                                                phi_6089_ = 1f;
                                                            }
                                                            let _e2328 = phi_6089_;
                                                            phi_6090_ = _e2328;
                                                        } else {
                                                            phi_6090_ = 0f;
                                                        }
                                                        let _e2330 = phi_6090_;
                                                        let _e2334 = (_e2308 - (_e2311 * _e2330));
                                                        let _e2335 = (_e2309 - (_e2312 * _e2330));
                                                        let _e2336 = (_e2310 - (_e2313 * _e2330));
                                                        let _e2347 = ((((_e2191 * _e2212) + (_e2192 * _e2213)) + (_e2193 * _e2214)) / (((_e2212 * _e2212) + (_e2213 * _e2213)) + (_e2214 * _e2214)));
                                                        if (_e2347 > 0f) {
                                                            if (_e2347 < 1f) {
                                                                phi_6117_ = _e2347;
                                                            } else {
                                                                phi_6117_ = 1f;
                                                            }
                                                            let _e2351 = phi_6117_;
                                                            phi_6118_ = _e2351;
                                                        } else {
                                                            phi_6118_ = 0f;
                                                        }
                                                        let _e2353 = phi_6118_;
                                                        let _e2370 = ((((_e2191 * _e2233) + (_e2192 * _e2234)) + (_e2193 * _e2235)) / (((_e2233 * _e2233) + (_e2234 * _e2234)) + (_e2235 * _e2235)));
                                                        if (_e2370 > 0f) {
                                                            if (_e2370 < 1f) {
                                                                phi_6145_ = _e2370;
                                                            } else {
                                                                phi_6145_ = 1f;
                                                            }
                                                            let _e2374 = phi_6145_;
                                                            phi_6146_ = _e2374;
                                                        } else {
                                                            phi_6146_ = 0f;
                                                        }
                                                        let _e2376 = phi_6146_;
                                                        local[0u] = array<f32, 3>((_e2191 - (_e2212 * _e2353)), (_e2192 - (_e2213 * _e2353)), (_e2193 - (_e2214 * _e2353)));
                                                        local[1u] = array<f32, 3>((_e2191 - (_e2233 * _e2376)), (_e2192 - (_e2234 * _e2376)), (_e2193 - (_e2235 * _e2376)));
                                                        local[2u] = array<f32, 3>(_e2334, _e2335, _e2336);
                                                        local[3u] = array<f32, 3>(_e2334, _e2335, _e2336);
                                                        let _e2392 = local[0u];
                                                        phi_6182_ = type_28(1u, 4u);
                                                        phi_6185_ = array<f32, 3>(_e2392[0], _e2392[1], _e2392[2]);
                                                        loop {
                                                            let _e2398 = phi_6182_;
                                                            let _e2400 = phi_6185_;
                                                            local_50 = _e2400;
                                                            if (_e2398.member < _e2398.member_1) {
                                                                phi_6183_ = type_28((_e2398.member + 1u), _e2398.member_1);
                                                                phi_6208_ = type_28(1u, _e2398.member);
                                                            } else {
                                                                phi_6183_ = _e2398;
                                                                phi_6208_ = type_28(0u, type_28().member_1);
                                                            }
                                                            let _e2414 = phi_6183_;
                                                            let _e2416 = phi_6208_;
                                                            let _e2420 = (bitcast<i32>(_e2416.member) != 0i);
                                                            if _e2420 {
                                                                if (_e2416.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2423 = local[_e2416.member_1];
                                                                if (_e2416.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2429 = local[_e2416.member_1];
                                                                if ((((_e2423[0] * _e2429[0]) + (_e2423[1] * _e2429[1])) + (_e2423[2] * _e2429[2])) < (((_e2400[0] * _e2400[0]) + (_e2400[1] * _e2400[1])) + (_e2400[2] * _e2400[2]))) {
                                                                    if (_e2416.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2452 = local[_e2416.member_1];
                                                                    phi_6275_ = array<f32, 3>(_e2452[0], _e2452[1], _e2452[2]);
                                                                } else {
                                                                    phi_6275_ = _e2400;
                                                                }
                                                                let _e2458 = phi_6275_;
                                                                phi_6186_ = _e2458;
                                                            } else {
                                                                phi_6186_ = array<f32, 3>();
                                                            }
                                                            let _e2460 = phi_6186_;
                                                            continue;
                                                            continuing {
                                                                phi_6182_ = _e2414;
                                                                phi_6185_ = _e2460;
                                                                break if !(_e2420);
                                                            }
                                                        }
                                                        let _e4935 = local_50;
                                                        phi_6276_ = _e4935;
                                                    } else {
                                                        phi_6276_ = _e2305;
                                                    }
                                                    let _e2463 = phi_6276_;
                                                    if (_e2463[0] < 0f) {
                                                        phi_6283_ = -(_e2463[0]);
                                                    } else {
                                                        phi_6283_ = _e2463[0];
                                                    }
                                                    let _e2468 = phi_6283_;
                                                    if (_e2463[1] < 0f) {
                                                        phi_6290_ = -(_e2463[1]);
                                                    } else {
                                                        phi_6290_ = _e2463[1];
                                                    }
                                                    let _e2473 = phi_6290_;
                                                    if (_e2463[2] < 0f) {
                                                        phi_6298_ = -(_e2463[2]);
                                                    } else {
                                                        phi_6298_ = _e2463[2];
                                                    }
                                                    let _e2479 = phi_6298_;
                                                    let _e2480 = ((_e2468 + _e2473) + _e2479);
                                                    if (_e2480 > 0f) {
                                                        if ((bitcast<u32>(_e2480) & 2139095040u) != 2139095040u) {
                                                            let _e2485 = (1f / _e2480);
                                                            let _e2487 = (_e2463[0] * _e2485);
                                                            let _e2489 = (_e2463[1] * _e2485);
                                                            let _e2491 = (_e2463[2] * _e2485);
                                                            let _e2496 = (((_e2487 * _e2487) + (_e2489 * _e2489)) + (_e2491 * _e2491));
                                                            if (_e2496 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2496 > 0f) {
                                                                    phi_6335_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6335_ = 0f;
                                                                }
                                                                let _e2555 = phi_6335_;
                                                                phi_6399_ = _e2555;
                                                            } else {
                                                                phi_6342_ = type_26(0i, 5i);
                                                                phi_6345_ = bitcast<f32>(((bitcast<u32>(_e2496) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2504 = phi_6342_;
                                                                    let _e2506 = phi_6345_;
                                                                    local_21 = _e2506;
                                                                    if (_e2504.member < _e2504.member_1) {
                                                                        let _e2514 = (_e2504.member + 1i);
                                                                        if ((false == (_e2514 > _e2504.member)) != false) {
                                                                            phi_6366_ = true;
                                                                        } else {
                                                                            phi_6366_ = false;
                                                                        }
                                                                        let _e2519 = phi_6366_;
                                                                        if _e2519 {
                                                                            phi_6372_ = type_27(0u, type_27().member_1);
                                                                        } else {
                                                                            phi_6372_ = type_27(1u, _e2514);
                                                                        }
                                                                        let _e2525 = phi_6372_;
                                                                        if (bitcast<i32>(_e2525.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_6343_ = type_26(_e2525.member_1, _e2504.member_1);
                                                                        phi_6386_ = type_27(1u, _e2504.member);
                                                                    } else {
                                                                        phi_6343_ = _e2504;
                                                                        phi_6386_ = type_27(0u, type_27().member_1);
                                                                    }
                                                                    let _e2535 = phi_6343_;
                                                                    let _e2537 = phi_6386_;
                                                                    let _e2540 = (bitcast<i32>(_e2537.member) != 0i);
                                                                    if _e2540 {
                                                                        phi_6346_ = (0.5f * (_e2506 + (_e2496 / _e2506)));
                                                                    } else {
                                                                        phi_6346_ = f32();
                                                                    }
                                                                    let _e2545 = phi_6346_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6342_ = _e2535;
                                                                        phi_6345_ = _e2545;
                                                                        break if !(_e2540);
                                                                    }
                                                                }
                                                                let _e2550 = local_21;
                                                                phi_6399_ = (_e2550 * (1f + (4f * 0.000000059604645f)));
                                                            }
                                                            let _e2557 = phi_6399_;
                                                            phi_6408_ = type_28(0u, 4u);
                                                            phi_6411_ = 2f;
                                                            loop {
                                                                let _e2565 = phi_6408_;
                                                                let _e2567 = phi_6411_;
                                                                local_23 = _e2567;
                                                                local_24 = _e2567;
                                                                local_25 = _e2567;
                                                                local_51 = _e2567;
                                                                local_52 = _e2567;
                                                                if (_e2565.member < _e2565.member_1) {
                                                                    phi_6409_ = type_28((_e2565.member + 1u), _e2565.member_1);
                                                                    phi_6434_ = type_28(1u, _e2565.member);
                                                                } else {
                                                                    phi_6409_ = _e2565;
                                                                    phi_6434_ = type_28(0u, type_28().member_1);
                                                                }
                                                                let _e2581 = phi_6409_;
                                                                let _e2583 = phi_6434_;
                                                                if (bitcast<i32>(_e2583.member) != 0i) {
                                                                    if (_e2583.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2590 = local_1[_e2583.member_1];
                                                                    let _e2598 = (((_e2487 * _e2590[0]) + (_e2489 * _e2590[1])) + (_e2491 * _e2590[2]));
                                                                    if (_e2583.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2601 = local_2[_e2583.member_1];
                                                                    let _e2609 = (((_e2487 * _e2601[0]) + (_e2489 * _e2601[1])) + (_e2491 * _e2601[2]));
                                                                    if (_e2598 < 0f) {
                                                                        phi_6485_ = -(_e2598);
                                                                    } else {
                                                                        phi_6485_ = _e2598;
                                                                    }
                                                                    let _e2613 = phi_6485_;
                                                                    if (_e2609 < 0f) {
                                                                        phi_6491_ = -(_e2609);
                                                                    } else {
                                                                        phi_6491_ = _e2609;
                                                                    }
                                                                    let _e2617 = phi_6491_;
                                                                    let _e2621 = (((((((((_e2028 + _e2030) + (_e2082 + _e2084)) + (_e2136 + _e2138)) * (0.000000059604645f * 16f)) + (_e2145 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2557) * (1f + (0.000000059604645f * 8f)))) + ((_e2613 + _e2617) * (0.000000059604645f * 8f)));
                                                                    if (_e2598 > _e2621) {
                                                                        if (_e2609 > _e2621) {
                                                                            phi_6504_ = false;
                                                                        } else {
                                                                            phi_6504_ = true;
                                                                        }
                                                                        let _e2625 = phi_6504_;
                                                                        phi_6505_ = _e2625;
                                                                    } else {
                                                                        phi_6505_ = true;
                                                                    }
                                                                    let _e2627 = phi_6505_;
                                                                    if _e2627 {
                                                                        let _e2631 = ((_e2598 + ((_e2609 - _e2598) * _e2153)) > _e2621);
                                                                        if _e2631 {
                                                                            if (_e2609 < _e2598) {
                                                                                let _e2638 = (((_e2598 - _e2621) / (_e2598 - _e2609)) * (1f - (0.000000059604645f * 16f)));
                                                                                if (_e2567 < _e2638) {
                                                                                    phi_6530_ = _e2567;
                                                                                } else {
                                                                                    phi_6530_ = _e2638;
                                                                                }
                                                                                let _e2641 = phi_6530_;
                                                                                phi_6531_ = _e2641;
                                                                            } else {
                                                                                phi_6531_ = _e2567;
                                                                            }
                                                                            let _e2643 = phi_6531_;
                                                                            phi_6532_ = _e2643;
                                                                        } else {
                                                                            phi_6532_ = f32();
                                                                        }
                                                                        let _e2645 = phi_6532_;
                                                                        phi_6533_ = _e2645;
                                                                        phi_6534_ = _e2631;
                                                                    } else {
                                                                        phi_6533_ = _e2567;
                                                                        phi_6534_ = true;
                                                                    }
                                                                    let _e2647 = phi_6533_;
                                                                    let _e2649 = phi_6534_;
                                                                    phi_6412_ = _e2647;
                                                                    phi_6535_ = _e2649;
                                                                    phi_6536_ = false;
                                                                } else {
                                                                    phi_6412_ = f32();
                                                                    phi_6535_ = false;
                                                                    phi_6536_ = true;
                                                                }
                                                                let _e2651 = phi_6412_;
                                                                let _e2653 = phi_6535_;
                                                                let _e2655 = phi_6536_;
                                                                local_22 = _e2655;
                                                                continue;
                                                                continuing {
                                                                    phi_6408_ = _e2581;
                                                                    phi_6411_ = _e2651;
                                                                    break if !(_e2653);
                                                                }
                                                            }
                                                            let _e2658 = local_22;
                                                            if _e2658 {
                                                                let _e2660 = local_23;
                                                                let _e2661 = (_e2660 > _e1192.member_1);
                                                                if _e2661 {
                                                                    phi_6557_ = false;
                                                                    phi_6558_ = false;
                                                                    phi_6559_ = false;
                                                                } else {
                                                                    let _e2663 = local_24;
                                                                    if (_e2663 > _e2153) {
                                                                        let _e2666 = local_25;
                                                                        let _e2668 = ((_e2666 - _e2153) < 0.00000000023283064f);
                                                                        if _e2668 {
                                                                            phi_6553_ = false;
                                                                        } else {
                                                                            phi_6553_ = true;
                                                                        }
                                                                        let _e2670 = phi_6553_;
                                                                        phi_6554_ = _e2670;
                                                                        phi_6555_ = _e2668;
                                                                        phi_6556_ = false;
                                                                    } else {
                                                                        phi_6554_ = false;
                                                                        phi_6555_ = false;
                                                                        phi_6556_ = true;
                                                                    }
                                                                    let _e2672 = phi_6554_;
                                                                    let _e2674 = phi_6555_;
                                                                    let _e2676 = phi_6556_;
                                                                    phi_6557_ = _e2672;
                                                                    phi_6558_ = _e2674;
                                                                    phi_6559_ = _e2676;
                                                                }
                                                                let _e2678 = phi_6557_;
                                                                let _e2680 = phi_6558_;
                                                                let _e2682 = phi_6559_;
                                                                phi_6560_ = _e2678;
                                                                phi_6561_ = _e2661;
                                                                phi_6562_ = _e2680;
                                                                phi_6563_ = _e2682;
                                                                phi_6564_ = false;
                                                            } else {
                                                                phi_6560_ = false;
                                                                phi_6561_ = false;
                                                                phi_6562_ = false;
                                                                phi_6563_ = false;
                                                                phi_6564_ = true;
                                                            }
                                                            let _e2684 = phi_6560_;
                                                            let _e2686 = phi_6561_;
                                                            let _e2688 = phi_6562_;
                                                            let _e2690 = phi_6563_;
                                                            let _e2692 = phi_6564_;
                                                            let _e4983 = local_51;
                                                            phi_6565_ = _e4983;
                                                            let _e4986 = local_52;
                                                            phi_6566_ = _e4986;
                                                            phi_6567_ = _e2684;
                                                            phi_6568_ = _e2686;
                                                            phi_6569_ = _e2688;
                                                            phi_6570_ = _e2690;
                                                            phi_6571_ = _e2692;
                                                            phi_6572_ = false;
                                                        } else {
                                                            phi_6565_ = f32();
                                                            phi_6566_ = f32();
                                                            phi_6567_ = false;
                                                            phi_6568_ = false;
                                                            phi_6569_ = false;
                                                            phi_6570_ = false;
                                                            phi_6571_ = false;
                                                            phi_6572_ = true;
                                                        }
                                                        let _e2694 = phi_6565_;
                                                        let _e2696 = phi_6566_;
                                                        let _e2698 = phi_6567_;
                                                        let _e2700 = phi_6568_;
                                                        let _e2702 = phi_6569_;
                                                        let _e2704 = phi_6570_;
                                                        let _e2706 = phi_6571_;
                                                        let _e2708 = phi_6572_;
                                                        phi_6573_ = _e2694;
                                                        phi_6574_ = _e2696;
                                                        phi_6575_ = _e2698;
                                                        phi_6576_ = _e2700;
                                                        phi_6577_ = _e2702;
                                                        phi_6578_ = _e2704;
                                                        phi_6579_ = _e2706;
                                                        phi_6580_ = _e2708;
                                                        phi_6581_ = false;
                                                    } else {
                                                        phi_6573_ = f32();
                                                        phi_6574_ = f32();
                                                        phi_6575_ = false;
                                                        phi_6576_ = false;
                                                        phi_6577_ = false;
                                                        phi_6578_ = false;
                                                        phi_6579_ = false;
                                                        phi_6580_ = false;
                                                        phi_6581_ = true;
                                                    }
                                                    let _e2710 = phi_6573_;
                                                    let _e2712 = phi_6574_;
                                                    let _e2714 = phi_6575_;
                                                    let _e2716 = phi_6576_;
                                                    let _e2718 = phi_6577_;
                                                    let _e2720 = phi_6578_;
                                                    let _e2722 = phi_6579_;
                                                    let _e2724 = phi_6580_;
                                                    let _e2726 = phi_6581_;
                                                    phi_6582_ = _e2710;
                                                    phi_5693_ = _e2712;
                                                    phi_6583_ = _e2714;
                                                    phi_6584_ = _e2716;
                                                    phi_6585_ = _e2718;
                                                    phi_6586_ = false;
                                                    phi_6587_ = _e2720;
                                                    phi_6588_ = _e2722;
                                                    phi_6589_ = _e2724;
                                                    phi_6590_ = _e2726;
                                                } else {
                                                    phi_6582_ = f32();
                                                    phi_5693_ = f32();
                                                    phi_6583_ = false;
                                                    phi_6584_ = false;
                                                    phi_6585_ = false;
                                                    phi_6586_ = true;
                                                    phi_6587_ = false;
                                                    phi_6588_ = false;
                                                    phi_6589_ = false;
                                                    phi_6590_ = false;
                                                }
                                                let _e2728 = phi_6582_;
                                                let _e2730 = phi_5693_;
                                                let _e2732 = phi_6583_;
                                                let _e2734 = phi_6584_;
                                                let _e2736 = phi_6585_;
                                                let _e2738 = phi_6586_;
                                                let _e2740 = phi_6587_;
                                                let _e2742 = phi_6588_;
                                                let _e2744 = phi_6589_;
                                                let _e2746 = phi_6590_;
                                                local_26 = _e2734;
                                                local_53 = _e2736;
                                                local_54 = _e2738;
                                                local_55 = _e2740;
                                                local_56 = _e2742;
                                                local_57 = _e2744;
                                                local_58 = _e2746;
                                                local_59 = _e2728;
                                                local_61 = _e2734;
                                                continue;
                                                continuing {
                                                    phi_5689_ = _e2167;
                                                    phi_5692_ = _e2730;
                                                    break if !(_e2732);
                                                }
                                            }
                                            let _e2749 = local_26;
                                            if _e2749 {
                                                phi_6595_ = type_55(0u, type_55().member_1);
                                                phi_6596_ = false;
                                                phi_6597_ = false;
                                                phi_6598_ = false;
                                                phi_6599_ = false;
                                                phi_6600_ = false;
                                                phi_6601_ = false;
                                            } else {
                                                phi_6595_ = type_55();
                                                let _e5016 = local_53;
                                                phi_6596_ = _e5016;
                                                let _e5019 = local_54;
                                                phi_6597_ = _e5019;
                                                let _e5022 = local_55;
                                                phi_6598_ = _e5022;
                                                let _e5025 = local_56;
                                                phi_6599_ = _e5025;
                                                let _e5028 = local_57;
                                                phi_6600_ = _e5028;
                                                let _e5031 = local_58;
                                                phi_6601_ = _e5031;
                                            }
                                            let _e2754 = phi_6595_;
                                            let _e2756 = phi_6596_;
                                            let _e2758 = phi_6597_;
                                            let _e2760 = phi_6598_;
                                            let _e2762 = phi_6599_;
                                            let _e2764 = phi_6600_;
                                            let _e2766 = phi_6601_;
                                            if _e2756 {
                                                let _e5034 = local_59;
                                                phi_6605_ = _e5034;
                                                phi_6606_ = true;
                                                phi_6607_ = false;
                                                phi_6608_ = false;
                                                phi_6609_ = false;
                                                phi_6610_ = false;
                                                phi_6611_ = false;
                                            } else {
                                                let _e5036 = local_60;
                                                phi_6605_ = _e5036;
                                                phi_6606_ = _e2758;
                                                phi_6607_ = _e2760;
                                                phi_6608_ = _e2762;
                                                let _e5042 = local_61;
                                                phi_6609_ = _e5042;
                                                phi_6610_ = _e2764;
                                                phi_6611_ = _e2766;
                                            }
                                            let _e2768 = phi_6605_;
                                            let _e2770 = phi_6606_;
                                            let _e2772 = phi_6607_;
                                            let _e2774 = phi_6608_;
                                            let _e2776 = phi_6609_;
                                            let _e2778 = phi_6610_;
                                            let _e2780 = phi_6611_;
                                            if _e2770 {
                                                phi_6616_ = type_55(1u, _e2768);
                                                phi_6617_ = false;
                                                phi_6618_ = false;
                                                phi_6619_ = false;
                                                phi_6620_ = false;
                                                phi_6621_ = false;
                                            } else {
                                                phi_6616_ = type_55();
                                                phi_6617_ = _e2772;
                                                phi_6618_ = _e2774;
                                                phi_6619_ = _e2776;
                                                phi_6620_ = _e2778;
                                                phi_6621_ = _e2780;
                                            }
                                            let _e2783 = phi_6616_;
                                            let _e2785 = phi_6617_;
                                            let _e2787 = phi_6618_;
                                            let _e2789 = phi_6619_;
                                            let _e2791 = phi_6620_;
                                            let _e2793 = phi_6621_;
                                            if _e2785 {
                                                let _e2795 = local_27;
                                                phi_6626_ = type_55(1u, _e2795);
                                                phi_6627_ = false;
                                                phi_6628_ = true;
                                                phi_6629_ = false;
                                                phi_6630_ = false;
                                            } else {
                                                phi_6626_ = _e2754;
                                                phi_6627_ = _e2787;
                                                phi_6628_ = _e2789;
                                                phi_6629_ = _e2791;
                                                phi_6630_ = _e2793;
                                            }
                                            let _e2798 = phi_6626_;
                                            let _e2800 = phi_6627_;
                                            let _e2802 = phi_6628_;
                                            let _e2804 = phi_6629_;
                                            let _e2806 = phi_6630_;
                                            if _e2800 {
                                                let _e2808 = local_28;
                                                phi_6635_ = type_55(1u, _e2808);
                                                phi_6636_ = true;
                                                phi_6637_ = false;
                                                phi_6638_ = false;
                                            } else {
                                                phi_6635_ = _e2798;
                                                phi_6636_ = _e2802;
                                                phi_6637_ = _e2804;
                                                phi_6638_ = _e2806;
                                            }
                                            let _e2811 = phi_6635_;
                                            let _e2813 = phi_6636_;
                                            let _e2815 = phi_6637_;
                                            let _e2817 = phi_6638_;
                                            if _e2813 {
                                                phi_6642_ = false;
                                                phi_6643_ = false;
                                            } else {
                                                phi_6642_ = _e2815;
                                                phi_6643_ = _e2817;
                                            }
                                            let _e2819 = phi_6642_;
                                            let _e2821 = phi_6643_;
                                            if _e2819 {
                                                phi_6647_ = false;
                                                phi_6648_ = false;
                                            } else {
                                                phi_6647_ = _e2821;
                                                phi_6648_ = _e2813;
                                            }
                                            let _e2823 = phi_6647_;
                                            let _e2825 = phi_6648_;
                                            if _e2823 {
                                                phi_6652_ = true;
                                                phi_6653_ = false;
                                            } else {
                                                phi_6652_ = _e2819;
                                                phi_6653_ = _e2825;
                                            }
                                            let _e2827 = phi_6652_;
                                            let _e2829 = phi_6653_;
                                            if _e2827 {
                                                let _e2831 = local_29;
                                                phi_6658_ = type_55(1u, _e2831);
                                                phi_6659_ = true;
                                            } else {
                                                phi_6658_ = _e2811;
                                                phi_6659_ = _e2829;
                                            }
                                            let _e2834 = phi_6658_;
                                            let _e2836 = phi_6659_;
                                            if _e2836 {
                                                phi_6663_ = _e2834;
                                            } else {
                                                phi_6663_ = _e2783;
                                            }
                                            let _e2838 = phi_6663_;
                                            let _e2841 = (_e2838.member != 0u);
                                            if _e2841 {
                                                phi_6670_ = false;
                                            } else {
                                                phi_6670_ = true;
                                            }
                                            let _e2843 = phi_6670_;
                                            phi_6671_ = _e2838.member_1;
                                            phi_6672_ = _e2843;
                                            phi_6673_ = _e2841;
                                            phi_6674_ = false;
                                        } else {
                                            phi_6671_ = f32();
                                            phi_6672_ = false;
                                            phi_6673_ = false;
                                            phi_6674_ = true;
                                        }
                                        let _e2845 = phi_6671_;
                                        let _e2847 = phi_6672_;
                                        let _e2849 = phi_6673_;
                                        let _e2851 = phi_6674_;
                                        phi_6675_ = _e2845;
                                        phi_6676_ = _e2847;
                                        phi_6677_ = _e2849;
                                        phi_6678_ = _e2851;
                                    }
                                    let _e2853 = phi_6675_;
                                    let _e2855 = phi_6676_;
                                    let _e2857 = phi_6677_;
                                    let _e2859 = phi_6678_;
                                    phi_6679_ = _e2853;
                                    phi_6680_ = _e1909;
                                    phi_6681_ = _e2855;
                                    phi_6682_ = _e2857;
                                    phi_6683_ = _e2859;
                                }
                                let _e2861 = phi_6679_;
                                let _e2863 = phi_6680_;
                                let _e2865 = phi_6681_;
                                let _e2867 = phi_6682_;
                                let _e2869 = phi_6683_;
                                if _e2863 {
                                    phi_6687_ = true;
                                    phi_6688_ = false;
                                    phi_6689_ = false;
                                } else {
                                    phi_6687_ = _e2865;
                                    phi_6688_ = _e2867;
                                    phi_6689_ = _e2869;
                                }
                                let _e2871 = phi_6687_;
                                let _e2873 = phi_6688_;
                                let _e2875 = phi_6689_;
                                phi_6690_ = _e2861;
                                phi_6691_ = _e1192;
                                phi_6692_ = _e2871;
                                phi_6693_ = false;
                                phi_6694_ = _e2873;
                                phi_6695_ = _e2875;
                            } else {
                                phi_6690_ = f32();
                                phi_6691_ = type_56();
                                phi_6692_ = false;
                                phi_6693_ = true;
                                phi_6694_ = false;
                                phi_6695_ = false;
                            }
                            let _e2877 = phi_6690_;
                            let _e2879 = phi_6691_;
                            let _e2881 = phi_6692_;
                            let _e2883 = phi_6693_;
                            let _e2885 = phi_6694_;
                            let _e2887 = phi_6695_;
                            local_30 = _e2883;
                            local_62 = _e2885;
                            local_63 = _e2887;
                            local_31 = _e2877;
                            local_32 = _e2879;
                            continue;
                            continuing {
                                phi_3776_ = _e891;
                                break if !(_e2881);
                            }
                        }
                        let _e2890 = local_30;
                        if _e2890 {
                            phi_6700_ = type_55(0u, type_55().member_1);
                            phi_6701_ = false;
                            phi_6702_ = false;
                        } else {
                            phi_6700_ = type_55();
                            let _e5099 = local_62;
                            phi_6701_ = _e5099;
                            let _e5102 = local_63;
                            phi_6702_ = _e5102;
                        }
                        let _e2895 = phi_6700_;
                        let _e2897 = phi_6701_;
                        let _e2899 = phi_6702_;
                        if _e2897 {
                            let _e2901 = local_31;
                            phi_6707_ = type_55(2u, _e2901);
                            phi_6708_ = false;
                        } else {
                            phi_6707_ = type_55();
                            phi_6708_ = _e2899;
                        }
                        let _e2904 = phi_6707_;
                        let _e2906 = phi_6708_;
                        if _e2906 {
                            let _e2908 = local_32;
                            phi_6714_ = type_55(1u, _e2908.member);
                            phi_6715_ = true;
                        } else {
                            phi_6714_ = _e2904;
                            phi_6715_ = _e2897;
                        }
                        let _e2912 = phi_6714_;
                        let _e2914 = phi_6715_;
                        if _e2914 {
                            phi_6719_ = _e2912;
                        } else {
                            phi_6719_ = _e2895;
                        }
                        let _e2916 = phi_6719_;
                        phi_6723_ = _e2916;
                    }
                    let _e4441 = phi_6723_;
                    phi_6724_ = _e4441;
                }
                let _e4446 = phi_6724_;
                switch bitcast<i32>(_e4446.member) {
                    case 0: {
                        phi_6785_ = type_58(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4476 = bitcast<u32>(_e4446.member_1);
                        if (_e4476 < 8388608u) {
                            phi_6752_ = array<u32, 2>();
                            phi_6753_ = true;
                        } else {
                            let _e4480 = ((_e4476 >> bitcast<u32>(31i)) == 1u);
                            if _e4480 {
                                phi_6751_ = array<u32, 2>();
                            } else {
                                phi_6751_ = array<u32, 2>((_e4476 << bitcast<u32>(29i)), ((((_e4476 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e4476 & 8388607u) >> bitcast<u32>(3i))));
                            }
                            let _e4494 = phi_6751_;
                            phi_6752_ = _e4494;
                            phi_6753_ = _e4480;
                        }
                        let _e4496 = phi_6752_;
                        let _e4498 = phi_6753_;
                        if _e4498 {
                            phi_6757_ = array<u32, 2>(0u, 0u);
                        } else {
                            phi_6757_ = _e4496;
                        }
                        let _e4500 = phi_6757_;
                        phi_6785_ = type_58(0u, _e4500, true);
                        break;
                    }
                    case 2: {
                        let _e4450 = bitcast<u32>(_e4446.member_1);
                        if (_e4450 < 8388608u) {
                            phi_6778_ = array<u32, 2>();
                            phi_6779_ = true;
                        } else {
                            let _e4454 = ((_e4450 >> bitcast<u32>(31i)) == 1u);
                            if _e4454 {
                                phi_6777_ = array<u32, 2>();
                            } else {
                                phi_6777_ = array<u32, 2>((_e4450 << bitcast<u32>(29i)), ((((_e4450 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e4450 & 8388607u) >> bitcast<u32>(3i))));
                            }
                            let _e4468 = phi_6777_;
                            phi_6778_ = _e4468;
                            phi_6779_ = _e4454;
                        }
                        let _e4470 = phi_6778_;
                        let _e4472 = phi_6779_;
                        if _e4472 {
                            phi_6783_ = array<u32, 2>(0u, 0u);
                        } else {
                            phi_6783_ = _e4470;
                        }
                        let _e4474 = phi_6783_;
                        phi_6785_ = type_58(1u, _e4474, true);
                        break;
                    }
                    default: {
                        phi_6785_ = type_58();
                        break;
                    }
                }
                let _e4503 = phi_6785_;
                if _e4503.member_2 {
                    phi_6792_ = (_e4503.member == 0u);
                } else {
                    phi_6792_ = false;
                }
                let _e4508 = phi_6792_;
                if _e4508 {
                    let _e4516 = (_e4503.member_1[1] >> bitcast<u32>(20i));
                    if (_e4516 <= 896u) {
                        phi_6816_ = 0u;
                    } else {
                        phi_6816_ = ((((_e4516 - 896u) << bitcast<u32>(23i)) | ((_e4503.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4503.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4531 = phi_6816_;
                    let _e4533 = atomicMin((&earliest.member[0u]), _e4531);
                }
                phi_6820_ = type_48(_e175, 0u, _e181, _e184, _e4503.member_1);
                phi_6821_ = _e4508;
                phi_6822_ = (_e4503.member != 0u);
            } else {
                phi_6820_ = type_48(_e175, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_6821_ = false;
                phi_6822_ = false;
            }
            let _e4535 = phi_6820_;
            let _e4537 = phi_6821_;
            let _e4539 = phi_6822_;
            let _e4541 = params.member.member_1;
            if ((_e4541 & 16u) != 0u) {
                if (_e106 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4537 {
                    let _e4547 = atomicAdd((&counters[0u]), 1u);
                    phi_6840_ = _e4547;
                } else {
                    phi_6840_ = 0u;
                }
                let _e4549 = phi_6840_;
                workgroupBarrier();
                if (_e106 == 0u) {
                    let _e4552 = atomicLoad((&counters[0u]));
                    if (_e4552 > 0u) {
                        let _e4555 = atomicAdd((&contacts.member[0u]), _e4552);
                        atomicStore((&counters[1u]), _e4555);
                    }
                }
                workgroupBarrier();
                let _e4558 = atomicLoad((&counters[1u]));
                let _e4559 = (_e4558 + _e4549);
                if _e4537 {
                    let _e4561 = params.member.member_16;
                    if (_e4559 < _e4561) {
                        let _e4563 = (6u * _e4559);
                        atomicStore((&contacts.member[(4u + _e4563)]), _e4535.member);
                        atomicStore((&contacts.member[(_e4563 + 5u)]), _e4535.member_1);
                        atomicStore((&contacts.member[(_e4563 + 6u)]), _e4535.member_2);
                        atomicStore((&contacts.member[(_e4563 + 7u)]), _e4535.member_3);
                        atomicStore((&contacts.member[(_e4563 + 8u)]), _e4535.member_4[0]);
                        atomicStore((&contacts.member[(_e4563 + 9u)]), _e4535.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e106 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4539 {
                let _e4587 = atomicAdd((&counters[0u]), 1u);
                phi_6902_ = _e4587;
            } else {
                phi_6902_ = 0u;
            }
            let _e4589 = phi_6902_;
            workgroupBarrier();
            if (_e106 == 0u) {
                let _e4592 = atomicLoad((&counters[0u]));
                if (_e4592 > 0u) {
                    let _e4595 = atomicAdd((&undecided.member[0u]), _e4592);
                    atomicStore((&counters[1u]), _e4595);
                }
            }
            workgroupBarrier();
            let _e4598 = atomicLoad((&counters[1u]));
            let _e4599 = (_e4598 + _e4589);
            if _e4539 {
                atomicStore((&undecided.member[(4u + (2u * _e4599))]), _e4535.member_2);
                atomicStore((&undecided.member[((2u * _e4599) + 5u)]), _e4535.member_3);
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
