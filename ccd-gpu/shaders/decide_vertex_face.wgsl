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

fn function_(param: f32) -> array<u32, 2> {
    var phi_171_: array<u32, 2>;
    var phi_172_: array<u32, 2>;
    var phi_173_: bool;
    var phi_177_: array<u32, 2>;

    let _e91 = bitcast<u32>(param);
    if (_e91 < 8388608u) {
        phi_172_ = array<u32, 2>();
        phi_173_ = true;
    } else {
        let _e95 = ((_e91 >> bitcast<u32>(31i)) == 1u);
        if _e95 {
            phi_171_ = array<u32, 2>();
        } else {
            phi_171_ = array<u32, 2>((_e91 << bitcast<u32>(29i)), ((((_e91 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e91 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e109 = phi_171_;
        phi_172_ = _e109;
        phi_173_ = _e95;
    }
    let _e111 = phi_172_;
    let _e113 = phi_173_;
    if _e113 {
        phi_177_ = array<u32, 2>(0u, 0u);
    } else {
        phi_177_ = _e111;
    }
    let _e115 = phi_177_;
    return _e115;
}

fn function_1() {
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
    var phi_232_: u32;
    var phi_248_: u32;
    var phi_269_: u32;
    var phi_270_: u32;
    var phi_273_: type_28;
    var phi_274_: type_28;
    var phi_297_: type_28;
    var phi_736_: f32;
    var phi_743_: f32;
    var phi_748_: f32;
    var phi_755_: f32;
    var phi_760_: f32;
    var phi_773_: f32;
    var phi_780_: f32;
    var phi_785_: f32;
    var phi_792_: f32;
    var phi_797_: f32;
    var phi_802_: f32;
    var phi_819_: f32;
    var phi_826_: f32;
    var phi_831_: f32;
    var phi_838_: f32;
    var phi_843_: f32;
    var phi_857_: f32;
    var phi_864_: f32;
    var phi_869_: f32;
    var phi_876_: f32;
    var phi_881_: f32;
    var phi_886_: f32;
    var phi_903_: f32;
    var phi_910_: f32;
    var phi_915_: f32;
    var phi_922_: f32;
    var phi_927_: f32;
    var phi_941_: f32;
    var phi_948_: f32;
    var phi_953_: f32;
    var phi_960_: f32;
    var phi_965_: f32;
    var phi_970_: f32;
    var phi_1001_: f32;
    var phi_1007_: f32;
    var phi_1014_: f32;
    var phi_1021_: f32;
    var phi_1027_: f32;
    var phi_1034_: f32;
    var phi_1040_: f32;
    var phi_1046_: f32;
    var phi_1052_: f32;
    var phi_1059_: f32;
    var phi_1066_: f32;
    var phi_1090_: f32;
    var phi_1095_: f32;
    var phi_1100_: f32;
    var phi_1105_: f32;
    var phi_1110_: f32;
    var phi_1115_: f32;
    var phi_1125_: f32;
    var phi_3598_: f32;
    var phi_3604_: f32;
    var phi_3609_: f32;
    var phi_3615_: f32;
    var phi_3621_: f32;
    var phi_3626_: f32;
    var phi_3631_: f32;
    var phi_3639_: bool;
    var phi_3644_: f32;
    var phi_3651_: f32;
    var phi_3691_: type_26;
    var phi_3694_: f32;
    var phi_3715_: bool;
    var phi_3721_: type_27;
    var phi_3692_: type_26;
    var phi_3735_: type_27;
    var phi_3695_: f32;
    var local_16: f32;
    var phi_3684_: f32;
    var phi_3748_: f32;
    var phi_3754_: f32;
    var phi_3779_: type_28;
    var phi_3782_: u32;
    var phi_3780_: type_28;
    var phi_3805_: type_28;
    var phi_3849_: u32;
    var phi_3850_: u32;
    var phi_3783_: u32;
    var phi_3851_: u32;
    var phi_3871_: type_28;
    var phi_3872_: type_28;
    var phi_3895_: type_28;
    var phi_3947_: f32;
    var phi_3954_: f32;
    var phi_3965_: bool;
    var phi_3966_: bool;
    var phi_3967_: bool;
    var phi_3968_: bool;
    var phi_3972_: bool;
    var phi_3983_: type_56;
    var phi_3984_: type_56;
    var phi_3985_: bool;
    var phi_3986_: type_56;
    var phi_3987_: bool;
    var phi_3998_: f32;
    var phi_4008_: type_28;
    var phi_4011_: f32;
    var phi_4013_: f32;
    var phi_4015_: f32;
    var phi_4009_: type_28;
    var phi_4038_: type_28;
    var phi_4063_: f32;
    var phi_4064_: f32;
    var phi_4090_: f32;
    var phi_4106_: f32;
    var phi_4113_: bool;
    var phi_4114_: bool;
    var phi_4115_: bool;
    var phi_4121_: f32;
    var phi_4122_: f32;
    var phi_4123_: bool;
    var phi_4012_: f32;
    var phi_4014_: f32;
    var phi_4016_: f32;
    var phi_4124_: f32;
    var phi_4125_: bool;
    var phi_4126_: bool;
    var local_17: bool;
    var phi_4130_: f32;
    var phi_4131_: f32;
    var phi_4138_: type_28;
    var phi_4141_: f32;
    var phi_4139_: type_28;
    var phi_4164_: type_28;
    var phi_4205_: f32;
    var phi_4215_: f32;
    var phi_4223_: bool;
    var phi_4225_: bool;
    var phi_4230_: f32;
    var phi_4231_: bool;
    var phi_4232_: f32;
    var phi_4233_: bool;
    var phi_4234_: bool;
    var phi_4235_: bool;
    var phi_4236_: f32;
    var phi_4142_: f32;
    var phi_4237_: bool;
    var phi_4238_: bool;
    var phi_4239_: bool;
    var phi_4240_: bool;
    var local_18: bool;
    var phi_4244_: bool;
    var phi_4245_: bool;
    var phi_4249_: bool;
    var phi_4253_: f32;
    var phi_4254_: f32;
    var phi_4256_: type_56;
    var phi_4285_: f32;
    var phi_4292_: f32;
    var phi_4297_: f32;
    var phi_4304_: f32;
    var phi_4309_: f32;
    var phi_4322_: f32;
    var phi_4329_: f32;
    var phi_4334_: f32;
    var phi_4341_: f32;
    var phi_4346_: f32;
    var phi_4351_: f32;
    var phi_4410_: f32;
    var phi_4416_: f32;
    var phi_4421_: f32;
    var phi_4427_: f32;
    var phi_4432_: f32;
    var phi_4444_: f32;
    var phi_4450_: f32;
    var phi_4455_: f32;
    var phi_4461_: f32;
    var phi_4466_: f32;
    var phi_4492_: f32;
    var phi_4499_: f32;
    var phi_4504_: f32;
    var phi_4511_: f32;
    var phi_4516_: f32;
    var phi_4529_: f32;
    var phi_4536_: f32;
    var phi_4541_: f32;
    var phi_4548_: f32;
    var phi_4553_: f32;
    var phi_4558_: f32;
    var phi_4617_: f32;
    var phi_4623_: f32;
    var phi_4628_: f32;
    var phi_4634_: f32;
    var phi_4639_: f32;
    var phi_4651_: f32;
    var phi_4657_: f32;
    var phi_4662_: f32;
    var phi_4668_: f32;
    var phi_4673_: f32;
    var phi_4699_: f32;
    var phi_4706_: f32;
    var phi_4711_: f32;
    var phi_4718_: f32;
    var phi_4723_: f32;
    var phi_4736_: f32;
    var phi_4743_: f32;
    var phi_4748_: f32;
    var phi_4755_: f32;
    var phi_4760_: f32;
    var phi_4765_: f32;
    var phi_4824_: f32;
    var phi_4830_: f32;
    var phi_4835_: f32;
    var phi_4841_: f32;
    var phi_4846_: f32;
    var phi_4858_: f32;
    var phi_4864_: f32;
    var phi_4869_: f32;
    var phi_4875_: f32;
    var phi_4880_: f32;
    var phi_4929_: f32;
    var phi_4935_: f32;
    var phi_4963_: f32;
    var phi_4969_: f32;
    var phi_4974_: u32;
    var phi_4975_: u32;
    var phi_4945_: f32;
    var phi_4951_: f32;
    var phi_4956_: u32;
    var phi_4957_: u32;
    var phi_4976_: u32;
    var phi_4977_: u32;
    var phi_5044_: f32;
    var phi_5053_: f32;
    var phi_5184_: f32;
    var phi_5190_: f32;
    var phi_5197_: f32;
    var phi_5240_: type_28;
    var phi_5243_: bool;
    var phi_5241_: type_28;
    var phi_5266_: type_28;
    var phi_5293_: bool;
    var phi_5294_: bool;
    var phi_5244_: bool;
    var phi_5295_: bool;
    var phi_5296_: bool;
    var local_19: bool;
    var phi_5300_: bool;
    var local_20: bool;
    var phi_5307_: u32;
    var phi_5308_: u32;
    var phi_5309_: bool;
    var phi_5310_: u32;
    var phi_5311_: u32;
    var phi_5312_: bool;
    var phi_5316_: u32;
    var phi_5336_: bool;
    var phi_5337_: bool;
    var phi_5338_: bool;
    var phi_5534_: f32;
    var phi_5541_: f32;
    var phi_5546_: f32;
    var phi_5553_: f32;
    var phi_5558_: f32;
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
    var phi_5701_: f32;
    var phi_5708_: f32;
    var phi_5713_: f32;
    var phi_5720_: f32;
    var phi_5725_: f32;
    var phi_5739_: f32;
    var phi_5746_: f32;
    var phi_5751_: f32;
    var phi_5758_: f32;
    var phi_5763_: f32;
    var phi_5768_: f32;
    var phi_5784_: type_28;
    var phi_5787_: f32;
    var phi_5785_: type_28;
    var phi_5810_: type_28;
    var phi_5984_: bool;
    var phi_5985_: bool;
    var phi_5986_: bool;
    var phi_5987_: bool;
    var phi_5991_: bool;
    var phi_6013_: array<f32, 3>;
    var phi_6014_: bool;
    var phi_6015_: array<f32, 3>;
    var phi_6016_: bool;
    var phi_6184_: f32;
    var phi_6185_: f32;
    var phi_6212_: f32;
    var phi_6213_: f32;
    var phi_6240_: f32;
    var phi_6241_: f32;
    var phi_6277_: type_28;
    var phi_6280_: array<f32, 3>;
    var phi_6278_: type_28;
    var phi_6303_: type_28;
    var phi_6370_: array<f32, 3>;
    var phi_6281_: array<f32, 3>;
    var phi_6371_: array<f32, 3>;
    var phi_6378_: f32;
    var phi_6385_: f32;
    var phi_6393_: f32;
    var phi_6437_: type_26;
    var phi_6440_: f32;
    var phi_6461_: bool;
    var phi_6467_: type_27;
    var phi_6438_: type_26;
    var phi_6481_: type_27;
    var phi_6441_: f32;
    var local_21: f32;
    var phi_6430_: f32;
    var phi_6494_: f32;
    var phi_6503_: type_28;
    var phi_6506_: f32;
    var phi_6504_: type_28;
    var phi_6529_: type_28;
    var phi_6580_: f32;
    var phi_6586_: f32;
    var phi_6599_: bool;
    var phi_6600_: bool;
    var phi_6631_: f32;
    var phi_6632_: f32;
    var phi_6633_: f32;
    var phi_6634_: bool;
    var phi_6638_: bool;
    var phi_6639_: f32;
    var phi_6640_: bool;
    var phi_6641_: bool;
    var phi_6642_: bool;
    var phi_6643_: f32;
    var phi_6644_: bool;
    var phi_6645_: bool;
    var phi_6646_: bool;
    var phi_6507_: f32;
    var phi_6647_: bool;
    var phi_6648_: bool;
    var phi_6649_: bool;
    var phi_6650_: bool;
    var local_22: bool;
    var local_23: f32;
    var local_24: f32;
    var local_25: f32;
    var phi_6667_: bool;
    var phi_6668_: bool;
    var phi_6669_: bool;
    var phi_6670_: bool;
    var phi_6671_: bool;
    var phi_6672_: bool;
    var phi_6673_: bool;
    var phi_6674_: bool;
    var phi_6675_: bool;
    var phi_6676_: bool;
    var phi_6677_: bool;
    var phi_6678_: bool;
    var phi_6679_: bool;
    var phi_6680_: f32;
    var phi_6681_: f32;
    var phi_6682_: bool;
    var phi_6683_: bool;
    var phi_6684_: bool;
    var phi_6685_: bool;
    var phi_6686_: bool;
    var phi_6687_: bool;
    var phi_6688_: bool;
    var phi_6689_: f32;
    var phi_6690_: f32;
    var phi_6691_: bool;
    var phi_6692_: bool;
    var phi_6693_: bool;
    var phi_6694_: bool;
    var phi_6695_: bool;
    var phi_6696_: bool;
    var phi_6697_: bool;
    var phi_6698_: bool;
    var phi_6699_: f32;
    var phi_5788_: f32;
    var phi_6700_: bool;
    var phi_6701_: bool;
    var phi_6702_: bool;
    var phi_6703_: bool;
    var phi_6704_: bool;
    var phi_6705_: bool;
    var phi_6706_: bool;
    var phi_6707_: bool;
    var phi_6708_: bool;
    var local_26: bool;
    var phi_6713_: type_55;
    var phi_6714_: bool;
    var phi_6715_: bool;
    var phi_6716_: bool;
    var phi_6717_: bool;
    var phi_6718_: bool;
    var phi_6719_: bool;
    var phi_6720_: bool;
    var phi_6724_: f32;
    var phi_6725_: bool;
    var phi_6726_: bool;
    var phi_6727_: bool;
    var phi_6728_: bool;
    var phi_6729_: bool;
    var phi_6730_: bool;
    var phi_6731_: bool;
    var phi_6736_: type_55;
    var phi_6737_: bool;
    var phi_6738_: bool;
    var phi_6739_: bool;
    var phi_6740_: bool;
    var phi_6741_: bool;
    var phi_6742_: bool;
    var local_27: f32;
    var phi_6747_: type_55;
    var phi_6748_: bool;
    var phi_6749_: bool;
    var phi_6750_: bool;
    var phi_6751_: bool;
    var phi_6752_: bool;
    var local_28: f32;
    var phi_6757_: type_55;
    var phi_6758_: bool;
    var phi_6759_: bool;
    var phi_6760_: bool;
    var phi_6761_: bool;
    var local_29: f32;
    var phi_6766_: type_55;
    var phi_6767_: bool;
    var phi_6768_: bool;
    var phi_6769_: bool;
    var phi_6770_: bool;
    var phi_6774_: type_55;
    var phi_6775_: bool;
    var phi_6776_: bool;
    var phi_6777_: bool;
    var phi_6781_: bool;
    var phi_6782_: bool;
    var phi_6786_: bool;
    var phi_6787_: bool;
    var phi_6791_: bool;
    var phi_6792_: bool;
    var local_30: f32;
    var phi_6797_: type_55;
    var phi_6798_: bool;
    var phi_6802_: type_55;
    var phi_6809_: bool;
    var phi_6810_: f32;
    var phi_6811_: bool;
    var phi_6812_: bool;
    var phi_6813_: bool;
    var phi_6814_: f32;
    var phi_6815_: bool;
    var phi_6816_: bool;
    var phi_6817_: bool;
    var phi_6818_: f32;
    var phi_6819_: bool;
    var phi_6820_: bool;
    var phi_6821_: bool;
    var phi_6822_: bool;
    var phi_6826_: bool;
    var phi_6827_: bool;
    var phi_6828_: bool;
    var phi_6829_: f32;
    var phi_6830_: type_56;
    var phi_6831_: bool;
    var phi_6832_: bool;
    var phi_6833_: bool;
    var phi_6834_: bool;
    var local_31: bool;
    var phi_6839_: type_55;
    var phi_6840_: bool;
    var phi_6841_: bool;
    var local_32: f32;
    var phi_6846_: type_55;
    var phi_6847_: bool;
    var local_33: type_56;
    var phi_6853_: type_55;
    var phi_6854_: bool;
    var phi_6858_: type_55;
    var phi_1326_: f32;
    var phi_1333_: f32;
    var phi_1338_: f32;
    var phi_1345_: f32;
    var phi_1350_: f32;
    var phi_1363_: f32;
    var phi_1370_: f32;
    var phi_1375_: f32;
    var phi_1382_: f32;
    var phi_1387_: f32;
    var phi_1392_: f32;
    var phi_1409_: f32;
    var phi_1416_: f32;
    var phi_1421_: f32;
    var phi_1428_: f32;
    var phi_1433_: f32;
    var phi_1447_: f32;
    var phi_1454_: f32;
    var phi_1459_: f32;
    var phi_1466_: f32;
    var phi_1471_: f32;
    var phi_1476_: f32;
    var phi_1493_: f32;
    var phi_1500_: f32;
    var phi_1505_: f32;
    var phi_1512_: f32;
    var phi_1517_: f32;
    var phi_1531_: f32;
    var phi_1538_: f32;
    var phi_1543_: f32;
    var phi_1550_: f32;
    var phi_1555_: f32;
    var phi_1560_: f32;
    var phi_1576_: type_28;
    var phi_1579_: f32;
    var phi_1577_: type_28;
    var phi_1602_: type_28;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1783_: bool;
    var phi_1805_: array<f32, 3>;
    var phi_1806_: bool;
    var phi_1807_: array<f32, 3>;
    var phi_1808_: bool;
    var phi_1976_: f32;
    var phi_1977_: f32;
    var phi_2004_: f32;
    var phi_2005_: f32;
    var phi_2032_: f32;
    var phi_2033_: f32;
    var phi_2069_: type_28;
    var phi_2072_: array<f32, 3>;
    var phi_2070_: type_28;
    var phi_2095_: type_28;
    var phi_2162_: array<f32, 3>;
    var phi_2073_: array<f32, 3>;
    var phi_2163_: array<f32, 3>;
    var phi_2170_: f32;
    var phi_2177_: f32;
    var phi_2185_: f32;
    var phi_2229_: type_26;
    var phi_2232_: f32;
    var phi_2253_: bool;
    var phi_2259_: type_27;
    var phi_2230_: type_26;
    var phi_2273_: type_27;
    var phi_2233_: f32;
    var local_34: f32;
    var phi_2222_: f32;
    var phi_2286_: f32;
    var phi_2295_: type_28;
    var phi_2298_: f32;
    var phi_2296_: type_28;
    var phi_2321_: type_28;
    var phi_2372_: f32;
    var phi_2378_: f32;
    var phi_2391_: bool;
    var phi_2392_: bool;
    var phi_2423_: f32;
    var phi_2424_: f32;
    var phi_2425_: f32;
    var phi_2426_: bool;
    var phi_2430_: bool;
    var phi_2431_: f32;
    var phi_2432_: bool;
    var phi_2433_: bool;
    var phi_2434_: bool;
    var phi_2435_: f32;
    var phi_2436_: bool;
    var phi_2437_: bool;
    var phi_2438_: bool;
    var phi_2299_: f32;
    var phi_2439_: bool;
    var phi_2440_: bool;
    var phi_2441_: bool;
    var phi_2442_: bool;
    var local_35: bool;
    var local_36: f32;
    var local_37: f32;
    var local_38: f32;
    var phi_2459_: bool;
    var phi_2460_: bool;
    var phi_2461_: bool;
    var phi_2462_: bool;
    var phi_2463_: bool;
    var phi_2464_: bool;
    var phi_2465_: bool;
    var phi_2466_: bool;
    var phi_2467_: bool;
    var phi_2468_: bool;
    var phi_2469_: bool;
    var phi_2470_: bool;
    var phi_2471_: bool;
    var phi_2472_: f32;
    var phi_2473_: f32;
    var phi_2474_: bool;
    var phi_2475_: bool;
    var phi_2476_: bool;
    var phi_2477_: bool;
    var phi_2478_: bool;
    var phi_2479_: bool;
    var phi_2480_: bool;
    var phi_2481_: f32;
    var phi_2482_: f32;
    var phi_2483_: bool;
    var phi_2484_: bool;
    var phi_2485_: bool;
    var phi_2486_: bool;
    var phi_2487_: bool;
    var phi_2488_: bool;
    var phi_2489_: bool;
    var phi_2490_: bool;
    var phi_2491_: f32;
    var phi_1580_: f32;
    var phi_2492_: bool;
    var phi_2493_: bool;
    var phi_2494_: bool;
    var phi_2495_: bool;
    var phi_2496_: bool;
    var phi_2497_: bool;
    var phi_2498_: bool;
    var phi_2499_: bool;
    var phi_2500_: bool;
    var local_39: bool;
    var phi_2505_: type_55;
    var phi_2506_: bool;
    var phi_2507_: bool;
    var phi_2508_: bool;
    var phi_2509_: bool;
    var phi_2510_: bool;
    var phi_2511_: bool;
    var phi_2512_: bool;
    var phi_2516_: f32;
    var phi_2517_: bool;
    var phi_2518_: bool;
    var phi_2519_: bool;
    var phi_2520_: bool;
    var phi_2521_: bool;
    var phi_2522_: bool;
    var phi_2523_: bool;
    var phi_2528_: type_55;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var phi_2531_: bool;
    var phi_2532_: bool;
    var phi_2533_: bool;
    var phi_2534_: bool;
    var local_40: f32;
    var phi_2539_: type_55;
    var phi_2540_: bool;
    var phi_2541_: bool;
    var phi_2542_: bool;
    var phi_2543_: bool;
    var phi_2544_: bool;
    var local_41: f32;
    var phi_2549_: type_55;
    var phi_2550_: bool;
    var phi_2551_: bool;
    var phi_2552_: bool;
    var phi_2553_: bool;
    var local_42: f32;
    var phi_2558_: type_55;
    var phi_2559_: bool;
    var phi_2560_: bool;
    var phi_2561_: bool;
    var phi_2562_: bool;
    var phi_2566_: type_55;
    var phi_2567_: bool;
    var phi_2568_: bool;
    var phi_2569_: bool;
    var phi_2573_: bool;
    var phi_2574_: bool;
    var phi_2578_: bool;
    var phi_2579_: bool;
    var phi_2583_: bool;
    var phi_2584_: bool;
    var local_43: f32;
    var phi_2589_: type_55;
    var phi_2590_: bool;
    var phi_2594_: type_55;
    var phi_2608_: type_28;
    var phi_2609_: type_28;
    var phi_2632_: type_28;
    var phi_2652_: f32;
    var phi_2820_: bool;
    var phi_2821_: bool;
    var phi_2822_: bool;
    var phi_2823_: bool;
    var phi_2827_: bool;
    var phi_2849_: array<f32, 3>;
    var phi_2850_: bool;
    var phi_2851_: array<f32, 3>;
    var phi_2852_: bool;
    var phi_3020_: f32;
    var phi_3021_: f32;
    var phi_3048_: f32;
    var phi_3049_: f32;
    var phi_3076_: f32;
    var phi_3077_: f32;
    var phi_3113_: type_28;
    var phi_3116_: array<f32, 3>;
    var phi_3114_: type_28;
    var phi_3139_: type_28;
    var phi_3206_: array<f32, 3>;
    var phi_3117_: array<f32, 3>;
    var phi_3207_: array<f32, 3>;
    var phi_3239_: type_26;
    var phi_3242_: f32;
    var phi_3263_: bool;
    var phi_3269_: type_27;
    var phi_3240_: type_26;
    var phi_3283_: type_27;
    var phi_3243_: f32;
    var local_44: f32;
    var phi_3232_: f32;
    var phi_3296_: f32;
    var phi_3312_: f32;
    var phi_3319_: f32;
    var phi_3324_: f32;
    var phi_3331_: f32;
    var phi_3336_: f32;
    var phi_3349_: f32;
    var phi_3356_: f32;
    var phi_3361_: f32;
    var phi_3368_: f32;
    var phi_3373_: f32;
    var phi_3378_: f32;
    var phi_3395_: f32;
    var phi_3402_: f32;
    var phi_3407_: f32;
    var phi_3414_: f32;
    var phi_3419_: f32;
    var phi_3433_: f32;
    var phi_3440_: f32;
    var phi_3445_: f32;
    var phi_3452_: f32;
    var phi_3457_: f32;
    var phi_3462_: f32;
    var phi_3479_: f32;
    var phi_3486_: f32;
    var phi_3491_: f32;
    var phi_3498_: f32;
    var phi_3503_: f32;
    var phi_3517_: f32;
    var phi_3524_: f32;
    var phi_3529_: f32;
    var phi_3536_: f32;
    var phi_3541_: f32;
    var phi_3546_: f32;
    var phi_3566_: bool;
    var phi_3567_: bool;
    var phi_3568_: bool;
    var local_45: bool;
    var phi_3573_: type_55;
    var phi_3574_: bool;
    var phi_3579_: type_55;
    var phi_3580_: bool;
    var phi_3582_: type_55;
    var phi_3583_: type_55;
    var phi_3584_: bool;
    var phi_3588_: type_55;
    var phi_6862_: type_55;
    var phi_6863_: type_55;
    var phi_6876_: type_58;
    var phi_6883_: bool;
    var phi_6907_: u32;
    var phi_6911_: type_48;
    var phi_6912_: bool;
    var phi_6913_: bool;
    var phi_6931_: u32;
    var phi_6993_: u32;
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
        phi_232_ = _e125;
    } else {
        phi_232_ = _e127;
    }
    let _e130 = phi_232_;
    let _e131 = (_e130 / 64u);
    if ((_e130 % 64u) > 0u) {
        phi_248_ = (_e131 + 1u);
    } else {
        phi_248_ = _e131;
    }
    let _e136 = phi_248_;
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
            phi_269_ = (_e140 + 1u);
        } else {
            phi_269_ = _e140;
        }
        let _e146 = phi_269_;
        phi_270_ = _e146;
    } else {
        phi_270_ = 0u;
    }
    let _e148 = phi_270_;
    phi_273_ = type_28(0u, _e148);
    loop {
        let _e151 = phi_273_;
        if (_e151.member < _e151.member_1) {
            phi_274_ = type_28((_e151.member + 1u), _e151.member_1);
            phi_297_ = type_28(1u, _e151.member);
        } else {
            phi_274_ = _e151;
            phi_297_ = type_28(0u, type_28().member_1);
        }
        let _e165 = phi_274_;
        let _e167 = phi_297_;
        let _e171 = (bitcast<i32>(_e167.member) != 0i);
        if _e171 {
            let _e175 = (((_e120 + (_e167.member_1 * _e123)) * 64u) + _e108);
            let _e177 = params.member.member_8;
            if (_e175 < _e130) {
                let _e180 = (2u * _e175);
                let _e183 = input.member[(4u + _e180)];
                let _e186 = input.member[(_e180 + 5u)];
                let _e188 = elements.member[_e186];
                let _e193 = paths.member[_e183];
                let _e195 = paths.member[_e188[0]];
                let _e201 = paths.member[_e188[1]];
                let _e203 = paths.member[_e188[2]];
                let _e233 = params.member.member_4;
                local_15 = type_45(array<array<f32, 3>, 2>(array<f32, 3>((_e193.member[0] - _e195.member[0]), (_e193.member[1] - _e195.member[1]), (_e193.member[2] - _e195.member[2])), array<f32, 3>((_e193.member_1[0] - _e195.member_1[0]), (_e193.member_1[1] - _e195.member_1[1]), (_e193.member_1[2] - _e195.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e201.member[0] - _e195.member[0]), (_e201.member[1] - _e195.member[1]), (_e201.member[2] - _e195.member[2])), array<f32, 3>((_e201.member_1[0] - _e195.member_1[0]), (_e201.member_1[1] - _e195.member_1[1]), (_e201.member_1[2] - _e195.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e203.member[0] - _e195.member[0]), (_e203.member[1] - _e195.member[1]), (_e203.member[2] - _e195.member[2])), array<f32, 3>((_e203.member_1[0] - _e195.member_1[0]), (_e203.member_1[1] - _e195.member_1[1]), (_e203.member_1[2] - _e195.member_1[2]))), (_e233 + _e233));
                let _e264 = params.member.member_5;
                let _e267 = local_15.member_1[0u];
                let _e273 = local_15.member_2[0u];
                let _e279 = ((_e267[1] * _e273[2]) - (_e267[2] * _e273[1]));
                let _e282 = ((_e267[2] * _e273[0]) - (_e267[0] * _e273[2]));
                let _e285 = ((_e267[0] * _e273[1]) - (_e267[1] * _e273[0]));
                let _e288 = local_15.member_1[1u];
                let _e294 = local_15.member_2[1u];
                let _e300 = ((_e288[1] * _e294[2]) - (_e288[2] * _e294[1]));
                let _e303 = ((_e288[2] * _e294[0]) - (_e288[0] * _e294[2]));
                let _e306 = ((_e288[0] * _e294[1]) - (_e288[1] * _e294[0]));
                let _e309 = local_15.member_1[0u];
                let _e315 = local_15.member_2[1u];
                let _e330 = local_15.member_1[1u];
                let _e336 = local_15.member_2[0u];
                let _e349 = (((_e309[1] * _e315[2]) - (_e309[2] * _e315[1])) + ((_e330[1] * _e336[2]) - (_e330[2] * _e336[1])));
                let _e350 = (((_e309[2] * _e315[0]) - (_e309[0] * _e315[2])) + ((_e330[2] * _e336[0]) - (_e330[0] * _e336[2])));
                let _e351 = (((_e309[0] * _e315[1]) - (_e309[1] * _e315[0])) + ((_e330[0] * _e336[1]) - (_e330[1] * _e336[0])));
                let _e354 = local_15.member[0u];
                let _e362 = (((_e354[0] * _e279) + (_e354[1] * _e282)) + (_e354[2] * _e285));
                let _e365 = local_15.member[1u];
                let _e376 = local_15.member[0u];
                let _e385 = ((((_e365[0] * _e279) + (_e365[1] * _e282)) + (_e365[2] * _e285)) + (((_e376[0] * _e349) + (_e376[1] * _e350)) + (_e376[2] * _e351)));
                let _e388 = local_15.member[0u];
                let _e399 = local_15.member[1u];
                let _e408 = ((((_e388[0] * _e300) + (_e388[1] * _e303)) + (_e388[2] * _e306)) + (((_e399[0] * _e349) + (_e399[1] * _e350)) + (_e399[2] * _e351)));
                let _e411 = local_15.member[1u];
                let _e419 = (((_e411[0] * _e300) + (_e411[1] * _e303)) + (_e411[2] * _e306));
                let _e422 = local_15.member[0u];
                if (_e422[0] < 0f) {
                    phi_736_ = -(_e422[0]);
                } else {
                    phi_736_ = _e422[0];
                }
                let _e429 = phi_736_;
                if (_e422[1] < 0f) {
                    phi_743_ = -(_e422[1]);
                } else {
                    phi_743_ = _e422[1];
                }
                let _e433 = phi_743_;
                if (_e429 > _e433) {
                    phi_748_ = _e429;
                } else {
                    phi_748_ = _e433;
                }
                let _e436 = phi_748_;
                if (_e422[2] < 0f) {
                    phi_755_ = -(_e422[2]);
                } else {
                    phi_755_ = _e422[2];
                }
                let _e440 = phi_755_;
                if (_e436 > _e440) {
                    phi_760_ = _e436;
                } else {
                    phi_760_ = _e440;
                }
                let _e443 = phi_760_;
                let _e446 = local_15.member[1u];
                if (_e446[0] < 0f) {
                    phi_773_ = -(_e446[0]);
                } else {
                    phi_773_ = _e446[0];
                }
                let _e453 = phi_773_;
                if (_e446[1] < 0f) {
                    phi_780_ = -(_e446[1]);
                } else {
                    phi_780_ = _e446[1];
                }
                let _e457 = phi_780_;
                if (_e453 > _e457) {
                    phi_785_ = _e453;
                } else {
                    phi_785_ = _e457;
                }
                let _e460 = phi_785_;
                if (_e446[2] < 0f) {
                    phi_792_ = -(_e446[2]);
                } else {
                    phi_792_ = _e446[2];
                }
                let _e464 = phi_792_;
                if (_e460 > _e464) {
                    phi_797_ = _e460;
                } else {
                    phi_797_ = _e464;
                }
                let _e467 = phi_797_;
                if (_e443 > _e467) {
                    phi_802_ = _e443;
                } else {
                    phi_802_ = _e467;
                }
                let _e470 = phi_802_;
                let _e472 = local_15.member_3;
                let _e473 = (_e470 + _e472);
                let _e476 = local_15.member_1[0u];
                if (_e476[0] < 0f) {
                    phi_819_ = -(_e476[0]);
                } else {
                    phi_819_ = _e476[0];
                }
                let _e483 = phi_819_;
                if (_e476[1] < 0f) {
                    phi_826_ = -(_e476[1]);
                } else {
                    phi_826_ = _e476[1];
                }
                let _e487 = phi_826_;
                if (_e483 > _e487) {
                    phi_831_ = _e483;
                } else {
                    phi_831_ = _e487;
                }
                let _e490 = phi_831_;
                if (_e476[2] < 0f) {
                    phi_838_ = -(_e476[2]);
                } else {
                    phi_838_ = _e476[2];
                }
                let _e494 = phi_838_;
                if (_e490 > _e494) {
                    phi_843_ = _e490;
                } else {
                    phi_843_ = _e494;
                }
                let _e497 = phi_843_;
                let _e500 = local_15.member_1[1u];
                if (_e500[0] < 0f) {
                    phi_857_ = -(_e500[0]);
                } else {
                    phi_857_ = _e500[0];
                }
                let _e507 = phi_857_;
                if (_e500[1] < 0f) {
                    phi_864_ = -(_e500[1]);
                } else {
                    phi_864_ = _e500[1];
                }
                let _e511 = phi_864_;
                if (_e507 > _e511) {
                    phi_869_ = _e507;
                } else {
                    phi_869_ = _e511;
                }
                let _e514 = phi_869_;
                if (_e500[2] < 0f) {
                    phi_876_ = -(_e500[2]);
                } else {
                    phi_876_ = _e500[2];
                }
                let _e518 = phi_876_;
                if (_e514 > _e518) {
                    phi_881_ = _e514;
                } else {
                    phi_881_ = _e518;
                }
                let _e521 = phi_881_;
                if (_e497 > _e521) {
                    phi_886_ = _e497;
                } else {
                    phi_886_ = _e521;
                }
                let _e524 = phi_886_;
                let _e526 = local_15.member_3;
                let _e527 = (_e524 + _e526);
                let _e530 = local_15.member_2[0u];
                if (_e530[0] < 0f) {
                    phi_903_ = -(_e530[0]);
                } else {
                    phi_903_ = _e530[0];
                }
                let _e537 = phi_903_;
                if (_e530[1] < 0f) {
                    phi_910_ = -(_e530[1]);
                } else {
                    phi_910_ = _e530[1];
                }
                let _e541 = phi_910_;
                if (_e537 > _e541) {
                    phi_915_ = _e537;
                } else {
                    phi_915_ = _e541;
                }
                let _e544 = phi_915_;
                if (_e530[2] < 0f) {
                    phi_922_ = -(_e530[2]);
                } else {
                    phi_922_ = _e530[2];
                }
                let _e548 = phi_922_;
                if (_e544 > _e548) {
                    phi_927_ = _e544;
                } else {
                    phi_927_ = _e548;
                }
                let _e551 = phi_927_;
                let _e554 = local_15.member_2[1u];
                if (_e554[0] < 0f) {
                    phi_941_ = -(_e554[0]);
                } else {
                    phi_941_ = _e554[0];
                }
                let _e561 = phi_941_;
                if (_e554[1] < 0f) {
                    phi_948_ = -(_e554[1]);
                } else {
                    phi_948_ = _e554[1];
                }
                let _e565 = phi_948_;
                if (_e561 > _e565) {
                    phi_953_ = _e561;
                } else {
                    phi_953_ = _e565;
                }
                let _e568 = phi_953_;
                if (_e554[2] < 0f) {
                    phi_960_ = -(_e554[2]);
                } else {
                    phi_960_ = _e554[2];
                }
                let _e572 = phi_960_;
                if (_e568 > _e572) {
                    phi_965_ = _e568;
                } else {
                    phi_965_ = _e572;
                }
                let _e575 = phi_965_;
                if (_e551 > _e575) {
                    phi_970_ = _e551;
                } else {
                    phi_970_ = _e575;
                }
                let _e578 = phi_970_;
                let _e580 = local_15.member_3;
                let _e581 = (_e578 + _e580);
                let _e583 = ((_e527 * 8f) * _e581);
                let _e590 = local_15.member_3;
                if (_e279 < 0f) {
                    phi_1001_ = -(_e279);
                } else {
                    phi_1001_ = _e279;
                }
                let _e607 = phi_1001_;
                if (_e282 < 0f) {
                    phi_1007_ = -(_e282);
                } else {
                    phi_1007_ = _e282;
                }
                let _e611 = phi_1007_;
                if (_e285 < 0f) {
                    phi_1014_ = -(_e285);
                } else {
                    phi_1014_ = _e285;
                }
                let _e616 = phi_1014_;
                let _e617 = ((_e607 + _e611) + _e616);
                if (_e300 < 0f) {
                    phi_1021_ = -(_e300);
                } else {
                    phi_1021_ = _e300;
                }
                let _e621 = phi_1021_;
                if (_e303 < 0f) {
                    phi_1027_ = -(_e303);
                } else {
                    phi_1027_ = _e303;
                }
                let _e625 = phi_1027_;
                if (_e306 < 0f) {
                    phi_1034_ = -(_e306);
                } else {
                    phi_1034_ = _e306;
                }
                let _e630 = phi_1034_;
                let _e631 = ((_e621 + _e625) + _e630);
                if (_e617 > _e631) {
                    phi_1040_ = _e617;
                } else {
                    phi_1040_ = _e631;
                }
                let _e634 = phi_1040_;
                if (_e349 < 0f) {
                    phi_1046_ = -(_e349);
                } else {
                    phi_1046_ = _e349;
                }
                let _e638 = phi_1046_;
                if (_e350 < 0f) {
                    phi_1052_ = -(_e350);
                } else {
                    phi_1052_ = _e350;
                }
                let _e642 = phi_1052_;
                if (_e351 < 0f) {
                    phi_1059_ = -(_e351);
                } else {
                    phi_1059_ = _e351;
                }
                let _e647 = phi_1059_;
                let _e649 = (((_e638 + _e642) + _e647) * 0.5f);
                if (_e634 > _e649) {
                    phi_1066_ = _e634;
                } else {
                    phi_1066_ = _e649;
                }
                let _e652 = phi_1066_;
                let _e657 = local_15.member_3;
                let _e669 = (((((_e473 * 8f) * _e583) * (0.000000059604645f * (490f / 64f))) + ((_e590 * 19f) * ((_e473 * (_e527 + _e581)) + (_e527 * _e581)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e473) * ((1f + _e527) * (1f + _e581)))));
                let _e670 = (_e362 * 3f);
                let _e671 = (_e419 * 3f);
                if (_e670 < _e671) {
                    phi_1090_ = _e670;
                } else {
                    phi_1090_ = _e671;
                }
                let _e674 = phi_1090_;
                if (_e385 < _e408) {
                    phi_1095_ = _e385;
                } else {
                    phi_1095_ = _e408;
                }
                let _e677 = phi_1095_;
                if (_e674 < _e677) {
                    phi_1100_ = _e674;
                } else {
                    phi_1100_ = _e677;
                }
                let _e680 = phi_1100_;
                if (_e670 > _e671) {
                    phi_1105_ = _e670;
                } else {
                    phi_1105_ = _e671;
                }
                let _e683 = phi_1105_;
                if (_e385 > _e408) {
                    phi_1110_ = _e385;
                } else {
                    phi_1110_ = _e408;
                }
                let _e686 = phi_1110_;
                if (_e683 > _e686) {
                    phi_1115_ = _e683;
                } else {
                    phi_1115_ = _e686;
                }
                let _e689 = phi_1115_;
                let _e694 = -(_e689);
                if (_e680 > _e694) {
                    phi_1125_ = _e680;
                } else {
                    phi_1125_ = _e694;
                }
                let _e697 = phi_1125_;
                if ((_e697 - (_e669 + ((_e264 * (((_e652 + (_e583 * (0.000000059604645f * 4f))) + ((_e657 * 6f) * (_e527 + _e581))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e527) * (1f + _e581))))) * (3f * 1.0001f)))) > 0f) {
                    phi_6863_ = type_55(0u, type_55().member_1);
                } else {
                    if (_e264 > 0f) {
                        let _e2997 = local_15.member[0u];
                        let _e3003 = local_15.member_1[0u];
                        let _e3009 = local_15.member_2[0u];
                        local_12 = array<array<f32, 3>, 4>(_e2997, array<f32, 3>((_e2997[0] - _e3003[0]), (_e2997[1] - _e3003[1]), (_e2997[2] - _e3003[2])), array<f32, 3>((_e2997[0] - _e3009[0]), (_e2997[1] - _e3009[1]), (_e2997[2] - _e3009[2])), _e2997);
                        let _e3024 = local_15.member[1u];
                        let _e3030 = local_15.member_1[1u];
                        let _e3036 = local_15.member_2[1u];
                        local_13 = array<array<f32, 3>, 4>(_e3024, array<f32, 3>((_e3024[0] - _e3030[0]), (_e3024[1] - _e3030[1]), (_e3024[2] - _e3030[2])), array<f32, 3>((_e3024[0] - _e3036[0]), (_e3024[1] - _e3036[1]), (_e3024[2] - _e3036[2])), _e3024);
                        let _e3051 = local_15.member[0u];
                        if (_e3051[0] < 0f) {
                            phi_1326_ = -(_e3051[0]);
                        } else {
                            phi_1326_ = _e3051[0];
                        }
                        let _e3058 = phi_1326_;
                        if (_e3051[1] < 0f) {
                            phi_1333_ = -(_e3051[1]);
                        } else {
                            phi_1333_ = _e3051[1];
                        }
                        let _e3062 = phi_1333_;
                        if (_e3058 > _e3062) {
                            phi_1338_ = _e3058;
                        } else {
                            phi_1338_ = _e3062;
                        }
                        let _e3065 = phi_1338_;
                        if (_e3051[2] < 0f) {
                            phi_1345_ = -(_e3051[2]);
                        } else {
                            phi_1345_ = _e3051[2];
                        }
                        let _e3069 = phi_1345_;
                        if (_e3065 > _e3069) {
                            phi_1350_ = _e3065;
                        } else {
                            phi_1350_ = _e3069;
                        }
                        let _e3072 = phi_1350_;
                        let _e3075 = local_15.member[1u];
                        if (_e3075[0] < 0f) {
                            phi_1363_ = -(_e3075[0]);
                        } else {
                            phi_1363_ = _e3075[0];
                        }
                        let _e3082 = phi_1363_;
                        if (_e3075[1] < 0f) {
                            phi_1370_ = -(_e3075[1]);
                        } else {
                            phi_1370_ = _e3075[1];
                        }
                        let _e3086 = phi_1370_;
                        if (_e3082 > _e3086) {
                            phi_1375_ = _e3082;
                        } else {
                            phi_1375_ = _e3086;
                        }
                        let _e3089 = phi_1375_;
                        if (_e3075[2] < 0f) {
                            phi_1382_ = -(_e3075[2]);
                        } else {
                            phi_1382_ = _e3075[2];
                        }
                        let _e3093 = phi_1382_;
                        if (_e3089 > _e3093) {
                            phi_1387_ = _e3089;
                        } else {
                            phi_1387_ = _e3093;
                        }
                        let _e3096 = phi_1387_;
                        if (_e3072 > _e3096) {
                            phi_1392_ = _e3072;
                        } else {
                            phi_1392_ = _e3096;
                        }
                        let _e3099 = phi_1392_;
                        let _e3101 = local_15.member_3;
                        let _e3105 = local_15.member_1[0u];
                        if (_e3105[0] < 0f) {
                            phi_1409_ = -(_e3105[0]);
                        } else {
                            phi_1409_ = _e3105[0];
                        }
                        let _e3112 = phi_1409_;
                        if (_e3105[1] < 0f) {
                            phi_1416_ = -(_e3105[1]);
                        } else {
                            phi_1416_ = _e3105[1];
                        }
                        let _e3116 = phi_1416_;
                        if (_e3112 > _e3116) {
                            phi_1421_ = _e3112;
                        } else {
                            phi_1421_ = _e3116;
                        }
                        let _e3119 = phi_1421_;
                        if (_e3105[2] < 0f) {
                            phi_1428_ = -(_e3105[2]);
                        } else {
                            phi_1428_ = _e3105[2];
                        }
                        let _e3123 = phi_1428_;
                        if (_e3119 > _e3123) {
                            phi_1433_ = _e3119;
                        } else {
                            phi_1433_ = _e3123;
                        }
                        let _e3126 = phi_1433_;
                        let _e3129 = local_15.member_1[1u];
                        if (_e3129[0] < 0f) {
                            phi_1447_ = -(_e3129[0]);
                        } else {
                            phi_1447_ = _e3129[0];
                        }
                        let _e3136 = phi_1447_;
                        if (_e3129[1] < 0f) {
                            phi_1454_ = -(_e3129[1]);
                        } else {
                            phi_1454_ = _e3129[1];
                        }
                        let _e3140 = phi_1454_;
                        if (_e3136 > _e3140) {
                            phi_1459_ = _e3136;
                        } else {
                            phi_1459_ = _e3140;
                        }
                        let _e3143 = phi_1459_;
                        if (_e3129[2] < 0f) {
                            phi_1466_ = -(_e3129[2]);
                        } else {
                            phi_1466_ = _e3129[2];
                        }
                        let _e3147 = phi_1466_;
                        if (_e3143 > _e3147) {
                            phi_1471_ = _e3143;
                        } else {
                            phi_1471_ = _e3147;
                        }
                        let _e3150 = phi_1471_;
                        if (_e3126 > _e3150) {
                            phi_1476_ = _e3126;
                        } else {
                            phi_1476_ = _e3150;
                        }
                        let _e3153 = phi_1476_;
                        let _e3155 = local_15.member_3;
                        let _e3159 = local_15.member_2[0u];
                        if (_e3159[0] < 0f) {
                            phi_1493_ = -(_e3159[0]);
                        } else {
                            phi_1493_ = _e3159[0];
                        }
                        let _e3166 = phi_1493_;
                        if (_e3159[1] < 0f) {
                            phi_1500_ = -(_e3159[1]);
                        } else {
                            phi_1500_ = _e3159[1];
                        }
                        let _e3170 = phi_1500_;
                        if (_e3166 > _e3170) {
                            phi_1505_ = _e3166;
                        } else {
                            phi_1505_ = _e3170;
                        }
                        let _e3173 = phi_1505_;
                        if (_e3159[2] < 0f) {
                            phi_1512_ = -(_e3159[2]);
                        } else {
                            phi_1512_ = _e3159[2];
                        }
                        let _e3177 = phi_1512_;
                        if (_e3173 > _e3177) {
                            phi_1517_ = _e3173;
                        } else {
                            phi_1517_ = _e3177;
                        }
                        let _e3180 = phi_1517_;
                        let _e3183 = local_15.member_2[1u];
                        if (_e3183[0] < 0f) {
                            phi_1531_ = -(_e3183[0]);
                        } else {
                            phi_1531_ = _e3183[0];
                        }
                        let _e3190 = phi_1531_;
                        if (_e3183[1] < 0f) {
                            phi_1538_ = -(_e3183[1]);
                        } else {
                            phi_1538_ = _e3183[1];
                        }
                        let _e3194 = phi_1538_;
                        if (_e3190 > _e3194) {
                            phi_1543_ = _e3190;
                        } else {
                            phi_1543_ = _e3194;
                        }
                        let _e3197 = phi_1543_;
                        if (_e3183[2] < 0f) {
                            phi_1550_ = -(_e3183[2]);
                        } else {
                            phi_1550_ = _e3183[2];
                        }
                        let _e3201 = phi_1550_;
                        if (_e3197 > _e3201) {
                            phi_1555_ = _e3197;
                        } else {
                            phi_1555_ = _e3201;
                        }
                        let _e3204 = phi_1555_;
                        if (_e3180 > _e3204) {
                            phi_1560_ = _e3180;
                        } else {
                            phi_1560_ = _e3204;
                        }
                        let _e3207 = phi_1560_;
                        let _e3209 = local_15.member_3;
                        let _e3216 = local_15.member_3;
                        phi_1576_ = type_28(0u, 48u);
                        phi_1579_ = 0f;
                        loop {
                            let _e3222 = phi_1576_;
                            let _e3224 = phi_1579_;
                            local_82 = _e3224;
                            local_40 = _e3224;
                            local_41 = _e3224;
                            local_42 = _e3224;
                            local_43 = _e3224;
                            if (_e3222.member < _e3222.member_1) {
                                phi_1577_ = type_28((_e3222.member + 1u), _e3222.member_1);
                                phi_1602_ = type_28(1u, _e3222.member);
                            } else {
                                phi_1577_ = _e3222;
                                phi_1602_ = type_28(0u, type_28().member_1);
                            }
                            let _e3238 = phi_1577_;
                            let _e3240 = phi_1602_;
                            if (bitcast<i32>(_e3240.member) != 0i) {
                                let _e3246 = local_15.member[0u];
                                let _e3252 = local_15.member[1u];
                                let _e3262 = (_e3246[0] + ((_e3252[0] - _e3246[0]) * _e3224));
                                let _e3263 = (_e3246[1] + ((_e3252[1] - _e3246[1]) * _e3224));
                                let _e3264 = (_e3246[2] + ((_e3252[2] - _e3246[2]) * _e3224));
                                let _e3267 = local_15.member_1[0u];
                                let _e3273 = local_15.member_1[1u];
                                let _e3283 = (_e3267[0] + ((_e3273[0] - _e3267[0]) * _e3224));
                                let _e3284 = (_e3267[1] + ((_e3273[1] - _e3267[1]) * _e3224));
                                let _e3285 = (_e3267[2] + ((_e3273[2] - _e3267[2]) * _e3224));
                                let _e3288 = local_15.member_2[0u];
                                let _e3294 = local_15.member_2[1u];
                                let _e3304 = (_e3288[0] + ((_e3294[0] - _e3288[0]) * _e3224));
                                let _e3305 = (_e3288[1] + ((_e3294[1] - _e3288[1]) * _e3224));
                                let _e3306 = (_e3288[2] + ((_e3294[2] - _e3288[2]) * _e3224));
                                let _e3311 = (((_e3283 * _e3283) + (_e3284 * _e3284)) + (_e3285 * _e3285));
                                let _e3316 = (((_e3283 * _e3304) + (_e3284 * _e3305)) + (_e3285 * _e3306));
                                let _e3321 = (((_e3304 * _e3304) + (_e3305 * _e3305)) + (_e3306 * _e3306));
                                let _e3326 = (((_e3262 * _e3283) + (_e3263 * _e3284)) + (_e3264 * _e3285));
                                let _e3331 = (((_e3262 * _e3304) + (_e3263 * _e3305)) + (_e3264 * _e3306));
                                let _e3334 = ((_e3311 * _e3321) - (_e3316 * _e3316));
                                let _e3338 = (((_e3326 * _e3321) - (_e3331 * _e3316)) / _e3334);
                                let _e3342 = (((_e3331 * _e3311) - (_e3326 * _e3316)) / _e3334);
                                if (_e3338 >= 0f) {
                                    if (_e3342 >= 0f) {
                                        phi_1776_ = ((_e3338 + _e3342) <= 1f);
                                        phi_1777_ = false;
                                    } else {
                                        phi_1776_ = bool();
                                        phi_1777_ = true;
                                    }
                                    let _e3348 = phi_1776_;
                                    let _e3350 = phi_1777_;
                                    phi_1778_ = _e3348;
                                    phi_1779_ = _e3350;
                                } else {
                                    phi_1778_ = bool();
                                    phi_1779_ = true;
                                }
                                let _e3352 = phi_1778_;
                                let _e3354 = phi_1779_;
                                if _e3354 {
                                    phi_1783_ = false;
                                } else {
                                    phi_1783_ = _e3352;
                                }
                                let _e3356 = phi_1783_;
                                if (_e3334 > 0f) {
                                    if _e3356 {
                                        phi_1805_ = array<f32, 3>((_e3262 - ((_e3283 * _e3338) + (_e3304 * _e3342))), (_e3263 - ((_e3284 * _e3338) + (_e3305 * _e3342))), (_e3264 - ((_e3285 * _e3338) + (_e3306 * _e3342))));
                                        phi_1806_ = false;
                                    } else {
                                        phi_1805_ = array<f32, 3>();
                                        phi_1806_ = true;
                                    }
                                    let _e3372 = phi_1805_;
                                    let _e3374 = phi_1806_;
                                    phi_1807_ = _e3372;
                                    phi_1808_ = _e3374;
                                } else {
                                    phi_1807_ = array<f32, 3>();
                                    phi_1808_ = true;
                                }
                                let _e3376 = phi_1807_;
                                let _e3378 = phi_1808_;
                                if _e3378 {
                                    let _e3379 = (_e3262 - _e3283);
                                    let _e3380 = (_e3263 - _e3284);
                                    let _e3381 = (_e3264 - _e3285);
                                    let _e3382 = (_e3304 - _e3283);
                                    let _e3383 = (_e3305 - _e3284);
                                    let _e3384 = (_e3306 - _e3285);
                                    let _e3395 = ((((_e3379 * _e3382) + (_e3380 * _e3383)) + (_e3381 * _e3384)) / (((_e3382 * _e3382) + (_e3383 * _e3383)) + (_e3384 * _e3384)));
                                    if (_e3395 > 0f) {
                                        if (_e3395 < 1f) {
                                            phi_1976_ = _e3395;
                                        } else {
                                            phi_1976_ = 1f;
                                        }
                                        let _e3399 = phi_1976_;
                                        phi_1977_ = _e3399;
                                    } else {
                                        phi_1977_ = 0f;
                                    }
                                    let _e3401 = phi_1977_;
                                    let _e3405 = (_e3379 - (_e3382 * _e3401));
                                    let _e3406 = (_e3380 - (_e3383 * _e3401));
                                    let _e3407 = (_e3381 - (_e3384 * _e3401));
                                    let _e3418 = ((((_e3262 * _e3283) + (_e3263 * _e3284)) + (_e3264 * _e3285)) / (((_e3283 * _e3283) + (_e3284 * _e3284)) + (_e3285 * _e3285)));
                                    if (_e3418 > 0f) {
                                        if (_e3418 < 1f) {
                                            phi_2004_ = _e3418;
                                        } else {
                                            phi_2004_ = 1f;
                                        }
                                        let _e3422 = phi_2004_;
                                        phi_2005_ = _e3422;
                                    } else {
                                        phi_2005_ = 0f;
                                    }
                                    let _e3424 = phi_2005_;
                                    let _e3441 = ((((_e3262 * _e3304) + (_e3263 * _e3305)) + (_e3264 * _e3306)) / (((_e3304 * _e3304) + (_e3305 * _e3305)) + (_e3306 * _e3306)));
                                    if (_e3441 > 0f) {
                                        if (_e3441 < 1f) {
                                            phi_2032_ = _e3441;
                                        } else {
                                            phi_2032_ = 1f;
                                        }
                                        let _e3445 = phi_2032_;
                                        phi_2033_ = _e3445;
                                    } else {
                                        phi_2033_ = 0f;
                                    }
                                    let _e3447 = phi_2033_;
                                    local_11[0u] = array<f32, 3>((_e3262 - (_e3283 * _e3424)), (_e3263 - (_e3284 * _e3424)), (_e3264 - (_e3285 * _e3424)));
                                    local_11[1u] = array<f32, 3>((_e3262 - (_e3304 * _e3447)), (_e3263 - (_e3305 * _e3447)), (_e3264 - (_e3306 * _e3447)));
                                    local_11[2u] = array<f32, 3>(_e3405, _e3406, _e3407);
                                    local_11[3u] = array<f32, 3>(_e3405, _e3406, _e3407);
                                    let _e3463 = local_11[0u];
                                    phi_2069_ = type_28(1u, 4u);
                                    phi_2072_ = array<f32, 3>(_e3463[0], _e3463[1], _e3463[2]);
                                    loop {
                                        let _e3469 = phi_2069_;
                                        let _e3471 = phi_2072_;
                                        local_69 = _e3471;
                                        if (_e3469.member < _e3469.member_1) {
                                            phi_2070_ = type_28((_e3469.member + 1u), _e3469.member_1);
                                            phi_2095_ = type_28(1u, _e3469.member);
                                        } else {
                                            phi_2070_ = _e3469;
                                            phi_2095_ = type_28(0u, type_28().member_1);
                                        }
                                        let _e3485 = phi_2070_;
                                        let _e3487 = phi_2095_;
                                        let _e3491 = (bitcast<i32>(_e3487.member) != 0i);
                                        if _e3491 {
                                            if (_e3487.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3494 = local_11[_e3487.member_1];
                                            if (_e3487.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3500 = local_11[_e3487.member_1];
                                            if ((((_e3494[0] * _e3500[0]) + (_e3494[1] * _e3500[1])) + (_e3494[2] * _e3500[2])) < (((_e3471[0] * _e3471[0]) + (_e3471[1] * _e3471[1])) + (_e3471[2] * _e3471[2]))) {
                                                if (_e3487.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3523 = local_11[_e3487.member_1];
                                                phi_2162_ = array<f32, 3>(_e3523[0], _e3523[1], _e3523[2]);
                                            } else {
                                                phi_2162_ = _e3471;
                                            }
                                            let _e3529 = phi_2162_;
                                            phi_2073_ = _e3529;
                                        } else {
                                            phi_2073_ = array<f32, 3>();
                                        }
                                        let _e3531 = phi_2073_;
                                        continue;
                                        continuing {
                                            phi_2069_ = _e3485;
                                            phi_2072_ = _e3531;
                                            break if !(_e3491);
                                        }
                                    }
                                    let _e5300 = local_69;
                                    phi_2163_ = _e5300;
                                } else {
                                    phi_2163_ = _e3376;
                                }
                                let _e3534 = phi_2163_;
                                if (_e3534[0] < 0f) {
                                    phi_2170_ = -(_e3534[0]);
                                } else {
                                    phi_2170_ = _e3534[0];
                                }
                                let _e3539 = phi_2170_;
                                if (_e3534[1] < 0f) {
                                    phi_2177_ = -(_e3534[1]);
                                } else {
                                    phi_2177_ = _e3534[1];
                                }
                                let _e3544 = phi_2177_;
                                if (_e3534[2] < 0f) {
                                    phi_2185_ = -(_e3534[2]);
                                } else {
                                    phi_2185_ = _e3534[2];
                                }
                                let _e3550 = phi_2185_;
                                let _e3551 = ((_e3539 + _e3544) + _e3550);
                                if (_e3551 > 0f) {
                                    if ((bitcast<u32>(_e3551) & 2139095040u) != 2139095040u) {
                                        let _e3556 = (1f / _e3551);
                                        let _e3558 = (_e3534[0] * _e3556);
                                        let _e3560 = (_e3534[1] * _e3556);
                                        let _e3562 = (_e3534[2] * _e3556);
                                        let _e3567 = (((_e3558 * _e3558) + (_e3560 * _e3560)) + (_e3562 * _e3562));
                                        if (_e3567 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3567 > 0f) {
                                                phi_2222_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2222_ = 0f;
                                            }
                                            let _e3626 = phi_2222_;
                                            phi_2286_ = _e3626;
                                        } else {
                                            phi_2229_ = type_26(0i, 5i);
                                            phi_2232_ = bitcast<f32>(((bitcast<u32>(_e3567) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3575 = phi_2229_;
                                                let _e3577 = phi_2232_;
                                                local_34 = _e3577;
                                                if (_e3575.member < _e3575.member_1) {
                                                    let _e3585 = (_e3575.member + 1i);
                                                    if ((false == (_e3585 > _e3575.member)) != false) {
                                                        phi_2253_ = true;
                                                    } else {
                                                        phi_2253_ = false;
                                                    }
                                                    let _e3590 = phi_2253_;
                                                    if _e3590 {
                                                        phi_2259_ = type_27(0u, type_27().member_1);
                                                    } else {
                                                        phi_2259_ = type_27(1u, _e3585);
                                                    }
                                                    let _e3596 = phi_2259_;
                                                    if (bitcast<i32>(_e3596.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2230_ = type_26(_e3596.member_1, _e3575.member_1);
                                                    phi_2273_ = type_27(1u, _e3575.member);
                                                } else {
                                                    phi_2230_ = _e3575;
                                                    phi_2273_ = type_27(0u, type_27().member_1);
                                                }
                                                let _e3606 = phi_2230_;
                                                let _e3608 = phi_2273_;
                                                let _e3611 = (bitcast<i32>(_e3608.member) != 0i);
                                                if _e3611 {
                                                    phi_2233_ = (0.5f * (_e3577 + (_e3567 / _e3577)));
                                                } else {
                                                    phi_2233_ = f32();
                                                }
                                                let _e3616 = phi_2233_;
                                                continue;
                                                continuing {
                                                    phi_2229_ = _e3606;
                                                    phi_2232_ = _e3616;
                                                    break if !(_e3611);
                                                }
                                            }
                                            let _e3621 = local_34;
                                            phi_2286_ = (_e3621 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3628 = phi_2286_;
                                        phi_2295_ = type_28(0u, 4u);
                                        phi_2298_ = 2f;
                                        loop {
                                            let _e3636 = phi_2295_;
                                            let _e3638 = phi_2298_;
                                            local_36 = _e3638;
                                            local_37 = _e3638;
                                            local_38 = _e3638;
                                            local_72 = _e3638;
                                            local_73 = _e3638;
                                            if (_e3636.member < _e3636.member_1) {
                                                phi_2296_ = type_28((_e3636.member + 1u), _e3636.member_1);
                                                phi_2321_ = type_28(1u, _e3636.member);
                                            } else {
                                                phi_2296_ = _e3636;
                                                phi_2321_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e3652 = phi_2296_;
                                            let _e3654 = phi_2321_;
                                            if (bitcast<i32>(_e3654.member) != 0i) {
                                                if (_e3654.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3661 = local_12[_e3654.member_1];
                                                let _e3669 = (((_e3558 * _e3661[0]) + (_e3560 * _e3661[1])) + (_e3562 * _e3661[2]));
                                                if (_e3654.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3672 = local_13[_e3654.member_1];
                                                let _e3680 = (((_e3558 * _e3672[0]) + (_e3560 * _e3672[1])) + (_e3562 * _e3672[2]));
                                                if (_e3669 < 0f) {
                                                    phi_2372_ = -(_e3669);
                                                } else {
                                                    phi_2372_ = _e3669;
                                                }
                                                let _e3684 = phi_2372_;
                                                if (_e3680 < 0f) {
                                                    phi_2378_ = -(_e3680);
                                                } else {
                                                    phi_2378_ = _e3680;
                                                }
                                                let _e3688 = phi_2378_;
                                                let _e3692 = (((((((((_e3099 + _e3101) + (_e3153 + _e3155)) + (_e3207 + _e3209)) * (0.000000059604645f * 16f)) + (_e3216 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e264 * _e3628) * (1f + (0.000000059604645f * 8f)))) + ((_e3684 + _e3688) * (0.000000059604645f * 8f)));
                                                if (_e3669 > _e3692) {
                                                    if (_e3680 > _e3692) {
                                                        phi_2391_ = false;
                                                    } else {
                                                        phi_2391_ = true;
                                                    }
                                                    let _e3696 = phi_2391_;
                                                    phi_2392_ = _e3696;
                                                } else {
                                                    phi_2392_ = true;
                                                }
                                                let _e3698 = phi_2392_;
                                                if _e3698 {
                                                    if ((_e3669 + ((_e3680 - _e3669) * _e3224)) > _e3692) {
                                                        if (_e3680 < _e3669) {
                                                            let _e3706 = ((_e3669 - _e3680) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                            if _e3706 {
                                                                let _e3712 = (((_e3669 - _e3692) / (_e3669 - _e3680)) * (1f - (0.000000059604645f * 16f)));
                                                                if (_e3638 < _e3712) {
                                                                    phi_2423_ = _e3638;
                                                                } else {
                                                                    phi_2423_ = _e3712;
                                                                }
                                                                let _e3715 = phi_2423_;
                                                                phi_2424_ = _e3715;
                                                            } else {
                                                                phi_2424_ = f32();
                                                            }
                                                            let _e3717 = phi_2424_;
                                                            phi_2425_ = _e3717;
                                                            phi_2426_ = _e3706;
                                                        } else {
                                                            phi_2425_ = _e3638;
                                                            phi_2426_ = true;
                                                        }
                                                        let _e3719 = phi_2425_;
                                                        let _e3721 = phi_2426_;
                                                        if _e3721 {
                                                            phi_2430_ = false;
                                                        } else {
                                                            phi_2430_ = true;
                                                        }
                                                        let _e3723 = phi_2430_;
                                                        phi_2431_ = _e3719;
                                                        phi_2432_ = _e3721;
                                                        phi_2433_ = _e3723;
                                                        phi_2434_ = false;
                                                    } else {
                                                        phi_2431_ = f32();
                                                        phi_2432_ = false;
                                                        phi_2433_ = false;
                                                        phi_2434_ = true;
                                                    }
                                                    let _e3725 = phi_2431_;
                                                    let _e3727 = phi_2432_;
                                                    let _e3729 = phi_2433_;
                                                    let _e3731 = phi_2434_;
                                                    phi_2435_ = _e3725;
                                                    phi_2436_ = _e3727;
                                                    phi_2437_ = _e3729;
                                                    phi_2438_ = _e3731;
                                                } else {
                                                    phi_2435_ = _e3638;
                                                    phi_2436_ = true;
                                                    phi_2437_ = false;
                                                    phi_2438_ = false;
                                                }
                                                let _e3733 = phi_2435_;
                                                let _e3735 = phi_2436_;
                                                let _e3737 = phi_2437_;
                                                let _e3739 = phi_2438_;
                                                phi_2299_ = _e3733;
                                                phi_2439_ = _e3735;
                                                phi_2440_ = false;
                                                phi_2441_ = _e3737;
                                                phi_2442_ = _e3739;
                                            } else {
                                                phi_2299_ = f32();
                                                phi_2439_ = false;
                                                phi_2440_ = true;
                                                phi_2441_ = false;
                                                phi_2442_ = false;
                                            }
                                            let _e3741 = phi_2299_;
                                            let _e3743 = phi_2439_;
                                            let _e3745 = phi_2440_;
                                            let _e3747 = phi_2441_;
                                            let _e3749 = phi_2442_;
                                            local_35 = _e3745;
                                            local_70 = _e3747;
                                            local_71 = _e3749;
                                            continue;
                                            continuing {
                                                phi_2295_ = _e3652;
                                                phi_2298_ = _e3741;
                                                break if !(_e3743);
                                            }
                                        }
                                        let _e3752 = local_35;
                                        if _e3752 {
                                            let _e3754 = local_36;
                                            let _e3755 = (_e3754 > 1f);
                                            if _e3755 {
                                                phi_2463_ = false;
                                                phi_2464_ = false;
                                                phi_2465_ = false;
                                            } else {
                                                let _e3757 = local_37;
                                                if (_e3757 > _e3224) {
                                                    let _e3760 = local_38;
                                                    let _e3762 = ((_e3760 - _e3224) < 0.00000000023283064f);
                                                    if _e3762 {
                                                        phi_2459_ = false;
                                                    } else {
                                                        phi_2459_ = true;
                                                    }
                                                    let _e3764 = phi_2459_;
                                                    phi_2460_ = _e3764;
                                                    phi_2461_ = _e3762;
                                                    phi_2462_ = false;
                                                } else {
                                                    phi_2460_ = false;
                                                    phi_2461_ = false;
                                                    phi_2462_ = true;
                                                }
                                                let _e3766 = phi_2460_;
                                                let _e3768 = phi_2461_;
                                                let _e3770 = phi_2462_;
                                                phi_2463_ = _e3766;
                                                phi_2464_ = _e3768;
                                                phi_2465_ = _e3770;
                                            }
                                            let _e3772 = phi_2463_;
                                            let _e3774 = phi_2464_;
                                            let _e3776 = phi_2465_;
                                            phi_2466_ = _e3772;
                                            phi_2467_ = _e3755;
                                            phi_2468_ = _e3774;
                                            phi_2469_ = _e3776;
                                            phi_2470_ = false;
                                            phi_2471_ = false;
                                        } else {
                                            phi_2466_ = false;
                                            phi_2467_ = false;
                                            phi_2468_ = false;
                                            phi_2469_ = false;
                                            let _e5357 = local_70;
                                            phi_2470_ = _e5357;
                                            let _e5360 = local_71;
                                            phi_2471_ = _e5360;
                                        }
                                        let _e3778 = phi_2466_;
                                        let _e3780 = phi_2467_;
                                        let _e3782 = phi_2468_;
                                        let _e3784 = phi_2469_;
                                        let _e3786 = phi_2470_;
                                        let _e3788 = phi_2471_;
                                        let _e5363 = local_72;
                                        phi_2472_ = _e5363;
                                        let _e5366 = local_73;
                                        phi_2473_ = _e5366;
                                        phi_2474_ = _e3778;
                                        phi_2475_ = _e3780;
                                        phi_2476_ = _e3782;
                                        phi_2477_ = _e3784;
                                        phi_2478_ = _e3786;
                                        phi_2479_ = _e3788;
                                        phi_2480_ = false;
                                    } else {
                                        phi_2472_ = f32();
                                        phi_2473_ = f32();
                                        phi_2474_ = false;
                                        phi_2475_ = false;
                                        phi_2476_ = false;
                                        phi_2477_ = false;
                                        phi_2478_ = false;
                                        phi_2479_ = false;
                                        phi_2480_ = true;
                                    }
                                    let _e3790 = phi_2472_;
                                    let _e3792 = phi_2473_;
                                    let _e3794 = phi_2474_;
                                    let _e3796 = phi_2475_;
                                    let _e3798 = phi_2476_;
                                    let _e3800 = phi_2477_;
                                    let _e3802 = phi_2478_;
                                    let _e3804 = phi_2479_;
                                    let _e3806 = phi_2480_;
                                    phi_2481_ = _e3790;
                                    phi_2482_ = _e3792;
                                    phi_2483_ = _e3794;
                                    phi_2484_ = _e3796;
                                    phi_2485_ = _e3798;
                                    phi_2486_ = _e3800;
                                    phi_2487_ = _e3802;
                                    phi_2488_ = _e3804;
                                    phi_2489_ = _e3806;
                                    phi_2490_ = false;
                                } else {
                                    phi_2481_ = f32();
                                    phi_2482_ = f32();
                                    phi_2483_ = false;
                                    phi_2484_ = false;
                                    phi_2485_ = false;
                                    phi_2486_ = false;
                                    phi_2487_ = false;
                                    phi_2488_ = false;
                                    phi_2489_ = false;
                                    phi_2490_ = true;
                                }
                                let _e3808 = phi_2481_;
                                let _e3810 = phi_2482_;
                                let _e3812 = phi_2483_;
                                let _e3814 = phi_2484_;
                                let _e3816 = phi_2485_;
                                let _e3818 = phi_2486_;
                                let _e3820 = phi_2487_;
                                let _e3822 = phi_2488_;
                                let _e3824 = phi_2489_;
                                let _e3826 = phi_2490_;
                                phi_2491_ = _e3808;
                                phi_1580_ = _e3810;
                                phi_2492_ = _e3812;
                                phi_2493_ = _e3814;
                                phi_2494_ = _e3816;
                                phi_2495_ = false;
                                phi_2496_ = _e3818;
                                phi_2497_ = _e3820;
                                phi_2498_ = _e3822;
                                phi_2499_ = _e3824;
                                phi_2500_ = _e3826;
                            } else {
                                phi_2491_ = f32();
                                phi_1580_ = f32();
                                phi_2492_ = false;
                                phi_2493_ = false;
                                phi_2494_ = false;
                                phi_2495_ = true;
                                phi_2496_ = false;
                                phi_2497_ = false;
                                phi_2498_ = false;
                                phi_2499_ = false;
                                phi_2500_ = false;
                            }
                            let _e3828 = phi_2491_;
                            let _e3830 = phi_1580_;
                            let _e3832 = phi_2492_;
                            let _e3834 = phi_2493_;
                            let _e3836 = phi_2494_;
                            let _e3838 = phi_2495_;
                            let _e3840 = phi_2496_;
                            let _e3842 = phi_2497_;
                            let _e3844 = phi_2498_;
                            let _e3846 = phi_2499_;
                            let _e3848 = phi_2500_;
                            local_39 = _e3834;
                            local_74 = _e3836;
                            local_75 = _e3838;
                            local_76 = _e3840;
                            local_77 = _e3842;
                            local_78 = _e3844;
                            local_79 = _e3846;
                            local_80 = _e3848;
                            local_81 = _e3828;
                            local_83 = _e3834;
                            continue;
                            continuing {
                                phi_1576_ = _e3238;
                                phi_1579_ = _e3830;
                                break if !(_e3832);
                            }
                        }
                        let _e3851 = local_39;
                        if _e3851 {
                            phi_2505_ = type_55(0u, type_55().member_1);
                            phi_2506_ = false;
                            phi_2507_ = false;
                            phi_2508_ = false;
                            phi_2509_ = false;
                            phi_2510_ = false;
                            phi_2511_ = false;
                            phi_2512_ = false;
                        } else {
                            phi_2505_ = type_55();
                            let _e5399 = local_74;
                            phi_2506_ = _e5399;
                            let _e5402 = local_75;
                            phi_2507_ = _e5402;
                            let _e5405 = local_76;
                            phi_2508_ = _e5405;
                            let _e5408 = local_77;
                            phi_2509_ = _e5408;
                            let _e5411 = local_78;
                            phi_2510_ = _e5411;
                            let _e5414 = local_79;
                            phi_2511_ = _e5414;
                            let _e5417 = local_80;
                            phi_2512_ = _e5417;
                        }
                        let _e3856 = phi_2505_;
                        let _e3858 = phi_2506_;
                        let _e3860 = phi_2507_;
                        let _e3862 = phi_2508_;
                        let _e3864 = phi_2509_;
                        let _e3866 = phi_2510_;
                        let _e3868 = phi_2511_;
                        let _e3870 = phi_2512_;
                        if _e3858 {
                            let _e5420 = local_81;
                            phi_2516_ = _e5420;
                            phi_2517_ = true;
                            phi_2518_ = false;
                            phi_2519_ = false;
                            phi_2520_ = false;
                            phi_2521_ = false;
                            phi_2522_ = false;
                            phi_2523_ = false;
                        } else {
                            let _e5422 = local_82;
                            phi_2516_ = _e5422;
                            phi_2517_ = _e3860;
                            phi_2518_ = _e3862;
                            phi_2519_ = _e3864;
                            phi_2520_ = _e3866;
                            let _e5429 = local_83;
                            phi_2521_ = _e5429;
                            phi_2522_ = _e3868;
                            phi_2523_ = _e3870;
                        }
                        let _e3872 = phi_2516_;
                        let _e3874 = phi_2517_;
                        let _e3876 = phi_2518_;
                        let _e3878 = phi_2519_;
                        let _e3880 = phi_2520_;
                        let _e3882 = phi_2521_;
                        let _e3884 = phi_2522_;
                        let _e3886 = phi_2523_;
                        if _e3874 {
                            phi_2528_ = type_55(1u, _e3872);
                            phi_2529_ = false;
                            phi_2530_ = false;
                            phi_2531_ = false;
                            phi_2532_ = false;
                            phi_2533_ = false;
                            phi_2534_ = false;
                        } else {
                            phi_2528_ = type_55();
                            phi_2529_ = _e3876;
                            phi_2530_ = _e3878;
                            phi_2531_ = _e3880;
                            phi_2532_ = _e3882;
                            phi_2533_ = _e3884;
                            phi_2534_ = _e3886;
                        }
                        let _e3889 = phi_2528_;
                        let _e3891 = phi_2529_;
                        let _e3893 = phi_2530_;
                        let _e3895 = phi_2531_;
                        let _e3897 = phi_2532_;
                        let _e3899 = phi_2533_;
                        let _e3901 = phi_2534_;
                        if _e3891 {
                            let _e3903 = local_40;
                            phi_2539_ = type_55(1u, _e3903);
                            phi_2540_ = false;
                            phi_2541_ = false;
                            phi_2542_ = true;
                            phi_2543_ = false;
                            phi_2544_ = false;
                        } else {
                            phi_2539_ = _e3856;
                            phi_2540_ = _e3893;
                            phi_2541_ = _e3895;
                            phi_2542_ = _e3897;
                            phi_2543_ = _e3899;
                            phi_2544_ = _e3901;
                        }
                        let _e3906 = phi_2539_;
                        let _e3908 = phi_2540_;
                        let _e3910 = phi_2541_;
                        let _e3912 = phi_2542_;
                        let _e3914 = phi_2543_;
                        let _e3916 = phi_2544_;
                        if _e3908 {
                            let _e3918 = local_41;
                            phi_2549_ = type_55(1u, _e3918);
                            phi_2550_ = false;
                            phi_2551_ = false;
                            phi_2552_ = false;
                            phi_2553_ = false;
                        } else {
                            phi_2549_ = type_55();
                            phi_2550_ = _e3910;
                            phi_2551_ = _e3912;
                            phi_2552_ = _e3914;
                            phi_2553_ = _e3916;
                        }
                        let _e3921 = phi_2549_;
                        let _e3923 = phi_2550_;
                        let _e3925 = phi_2551_;
                        let _e3927 = phi_2552_;
                        let _e3929 = phi_2553_;
                        if _e3923 {
                            let _e3931 = local_42;
                            phi_2558_ = type_55(1u, _e3931);
                            phi_2559_ = true;
                            phi_2560_ = false;
                            phi_2561_ = false;
                            phi_2562_ = false;
                        } else {
                            phi_2558_ = _e3921;
                            phi_2559_ = _e3908;
                            phi_2560_ = _e3925;
                            phi_2561_ = _e3927;
                            phi_2562_ = _e3929;
                        }
                        let _e3934 = phi_2558_;
                        let _e3936 = phi_2559_;
                        let _e3938 = phi_2560_;
                        let _e3940 = phi_2561_;
                        let _e3942 = phi_2562_;
                        if _e3936 {
                            phi_2566_ = _e3934;
                            phi_2567_ = true;
                            phi_2568_ = false;
                            phi_2569_ = false;
                        } else {
                            phi_2566_ = _e3906;
                            phi_2567_ = _e3938;
                            phi_2568_ = _e3940;
                            phi_2569_ = _e3942;
                        }
                        let _e3944 = phi_2566_;
                        let _e3946 = phi_2567_;
                        let _e3948 = phi_2568_;
                        let _e3950 = phi_2569_;
                        if _e3946 {
                            phi_2573_ = false;
                            phi_2574_ = false;
                        } else {
                            phi_2573_ = _e3948;
                            phi_2574_ = _e3950;
                        }
                        let _e3952 = phi_2573_;
                        let _e3954 = phi_2574_;
                        if _e3952 {
                            phi_2578_ = false;
                            phi_2579_ = false;
                        } else {
                            phi_2578_ = _e3954;
                            phi_2579_ = _e3946;
                        }
                        let _e3956 = phi_2578_;
                        let _e3958 = phi_2579_;
                        if _e3956 {
                            phi_2583_ = true;
                            phi_2584_ = false;
                        } else {
                            phi_2583_ = _e3952;
                            phi_2584_ = _e3958;
                        }
                        let _e3960 = phi_2583_;
                        let _e3962 = phi_2584_;
                        if _e3960 {
                            let _e3964 = local_43;
                            phi_2589_ = type_55(1u, _e3964);
                            phi_2590_ = true;
                        } else {
                            phi_2589_ = _e3944;
                            phi_2590_ = _e3962;
                        }
                        let _e3967 = phi_2589_;
                        let _e3969 = phi_2590_;
                        if _e3969 {
                            phi_2594_ = _e3967;
                        } else {
                            phi_2594_ = _e3889;
                        }
                        let _e3971 = phi_2594_;
                        if (_e3971.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_2608_ = type_28(0u, 3u);
                            loop {
                                let _e3984 = phi_2608_;
                                if (_e3984.member < _e3984.member_1) {
                                    phi_2609_ = type_28((_e3984.member + 1u), _e3984.member_1);
                                    phi_2632_ = type_28(1u, _e3984.member);
                                } else {
                                    phi_2609_ = _e3984;
                                    phi_2632_ = type_28(0u, type_28().member_1);
                                }
                                let _e3998 = phi_2609_;
                                let _e4000 = phi_2632_;
                                if (bitcast<i32>(_e4000.member) != 0i) {
                                    if (_e4000.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4007 = local_14[_e4000.member_1];
                                    let _e4008 = (_e3971.member_1 + _e4007);
                                    if (_e4008 < 1f) {
                                        phi_2652_ = _e4008;
                                    } else {
                                        phi_2652_ = 1f;
                                    }
                                    let _e4011 = phi_2652_;
                                    let _e4014 = local_15.member[0u];
                                    let _e4020 = local_15.member[1u];
                                    let _e4030 = (_e4014[0] + ((_e4020[0] - _e4014[0]) * _e4011));
                                    let _e4031 = (_e4014[1] + ((_e4020[1] - _e4014[1]) * _e4011));
                                    let _e4032 = (_e4014[2] + ((_e4020[2] - _e4014[2]) * _e4011));
                                    let _e4035 = local_15.member_1[0u];
                                    let _e4041 = local_15.member_1[1u];
                                    let _e4051 = (_e4035[0] + ((_e4041[0] - _e4035[0]) * _e4011));
                                    let _e4052 = (_e4035[1] + ((_e4041[1] - _e4035[1]) * _e4011));
                                    let _e4053 = (_e4035[2] + ((_e4041[2] - _e4035[2]) * _e4011));
                                    let _e4056 = local_15.member_2[0u];
                                    let _e4062 = local_15.member_2[1u];
                                    let _e4072 = (_e4056[0] + ((_e4062[0] - _e4056[0]) * _e4011));
                                    let _e4073 = (_e4056[1] + ((_e4062[1] - _e4056[1]) * _e4011));
                                    let _e4074 = (_e4056[2] + ((_e4062[2] - _e4056[2]) * _e4011));
                                    let _e4079 = (((_e4051 * _e4051) + (_e4052 * _e4052)) + (_e4053 * _e4053));
                                    let _e4084 = (((_e4051 * _e4072) + (_e4052 * _e4073)) + (_e4053 * _e4074));
                                    let _e4089 = (((_e4072 * _e4072) + (_e4073 * _e4073)) + (_e4074 * _e4074));
                                    let _e4094 = (((_e4030 * _e4051) + (_e4031 * _e4052)) + (_e4032 * _e4053));
                                    let _e4099 = (((_e4030 * _e4072) + (_e4031 * _e4073)) + (_e4032 * _e4074));
                                    let _e4102 = ((_e4079 * _e4089) - (_e4084 * _e4084));
                                    let _e4106 = (((_e4094 * _e4089) - (_e4099 * _e4084)) / _e4102);
                                    let _e4110 = (((_e4099 * _e4079) - (_e4094 * _e4084)) / _e4102);
                                    if (_e4106 >= 0f) {
                                        if (_e4110 >= 0f) {
                                            phi_2820_ = ((_e4106 + _e4110) <= 1f);
                                            phi_2821_ = false;
                                        } else {
                                            phi_2820_ = bool();
                                            phi_2821_ = true;
                                        }
                                        let _e4116 = phi_2820_;
                                        let _e4118 = phi_2821_;
                                        phi_2822_ = _e4116;
                                        phi_2823_ = _e4118;
                                    } else {
                                        phi_2822_ = bool();
                                        phi_2823_ = true;
                                    }
                                    let _e4120 = phi_2822_;
                                    let _e4122 = phi_2823_;
                                    if _e4122 {
                                        phi_2827_ = false;
                                    } else {
                                        phi_2827_ = _e4120;
                                    }
                                    let _e4124 = phi_2827_;
                                    if (_e4102 > 0f) {
                                        if _e4124 {
                                            phi_2849_ = array<f32, 3>((_e4030 - ((_e4051 * _e4106) + (_e4072 * _e4110))), (_e4031 - ((_e4052 * _e4106) + (_e4073 * _e4110))), (_e4032 - ((_e4053 * _e4106) + (_e4074 * _e4110))));
                                            phi_2850_ = false;
                                        } else {
                                            phi_2849_ = array<f32, 3>();
                                            phi_2850_ = true;
                                        }
                                        let _e4140 = phi_2849_;
                                        let _e4142 = phi_2850_;
                                        phi_2851_ = _e4140;
                                        phi_2852_ = _e4142;
                                    } else {
                                        phi_2851_ = array<f32, 3>();
                                        phi_2852_ = true;
                                    }
                                    let _e4144 = phi_2851_;
                                    let _e4146 = phi_2852_;
                                    if _e4146 {
                                        let _e4147 = (_e4030 - _e4051);
                                        let _e4148 = (_e4031 - _e4052);
                                        let _e4149 = (_e4032 - _e4053);
                                        let _e4150 = (_e4072 - _e4051);
                                        let _e4151 = (_e4073 - _e4052);
                                        let _e4152 = (_e4074 - _e4053);
                                        let _e4163 = ((((_e4147 * _e4150) + (_e4148 * _e4151)) + (_e4149 * _e4152)) / (((_e4150 * _e4150) + (_e4151 * _e4151)) + (_e4152 * _e4152)));
                                        if (_e4163 > 0f) {
                                            if (_e4163 < 1f) {
                                                phi_3020_ = _e4163;
                                            } else {
                                                phi_3020_ = 1f;
                                            }
                                            let _e4167 = phi_3020_;
                                            phi_3021_ = _e4167;
                                        } else {
                                            phi_3021_ = 0f;
                                        }
                                        let _e4169 = phi_3021_;
                                        let _e4173 = (_e4147 - (_e4150 * _e4169));
                                        let _e4174 = (_e4148 - (_e4151 * _e4169));
                                        let _e4175 = (_e4149 - (_e4152 * _e4169));
                                        let _e4186 = ((((_e4030 * _e4051) + (_e4031 * _e4052)) + (_e4032 * _e4053)) / (((_e4051 * _e4051) + (_e4052 * _e4052)) + (_e4053 * _e4053)));
                                        if (_e4186 > 0f) {
                                            if (_e4186 < 1f) {
                                                phi_3048_ = _e4186;
                                            } else {
                                                phi_3048_ = 1f;
                                            }
                                            let _e4190 = phi_3048_;
                                            phi_3049_ = _e4190;
                                        } else {
                                            phi_3049_ = 0f;
                                        }
                                        let _e4192 = phi_3049_;
                                        let _e4209 = ((((_e4030 * _e4072) + (_e4031 * _e4073)) + (_e4032 * _e4074)) / (((_e4072 * _e4072) + (_e4073 * _e4073)) + (_e4074 * _e4074)));
                                        if (_e4209 > 0f) {
                                            if (_e4209 < 1f) {
                                                phi_3076_ = _e4209;
                                            } else {
                                                phi_3076_ = 1f;
                                            }
                                            let _e4213 = phi_3076_;
                                            phi_3077_ = _e4213;
                                        } else {
                                            phi_3077_ = 0f;
                                        }
                                        let _e4215 = phi_3077_;
                                        local_10[0u] = array<f32, 3>((_e4030 - (_e4051 * _e4192)), (_e4031 - (_e4052 * _e4192)), (_e4032 - (_e4053 * _e4192)));
                                        local_10[1u] = array<f32, 3>((_e4030 - (_e4072 * _e4215)), (_e4031 - (_e4073 * _e4215)), (_e4032 - (_e4074 * _e4215)));
                                        local_10[2u] = array<f32, 3>(_e4173, _e4174, _e4175);
                                        local_10[3u] = array<f32, 3>(_e4173, _e4174, _e4175);
                                        let _e4231 = local_10[0u];
                                        phi_3113_ = type_28(1u, 4u);
                                        phi_3116_ = array<f32, 3>(_e4231[0], _e4231[1], _e4231[2]);
                                        loop {
                                            let _e4237 = phi_3113_;
                                            let _e4239 = phi_3116_;
                                            local_84 = _e4239;
                                            if (_e4237.member < _e4237.member_1) {
                                                phi_3114_ = type_28((_e4237.member + 1u), _e4237.member_1);
                                                phi_3139_ = type_28(1u, _e4237.member);
                                            } else {
                                                phi_3114_ = _e4237;
                                                phi_3139_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4253 = phi_3114_;
                                            let _e4255 = phi_3139_;
                                            let _e4259 = (bitcast<i32>(_e4255.member) != 0i);
                                            if _e4259 {
                                                if (_e4255.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4262 = local_10[_e4255.member_1];
                                                if (_e4255.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4268 = local_10[_e4255.member_1];
                                                if ((((_e4262[0] * _e4268[0]) + (_e4262[1] * _e4268[1])) + (_e4262[2] * _e4268[2])) < (((_e4239[0] * _e4239[0]) + (_e4239[1] * _e4239[1])) + (_e4239[2] * _e4239[2]))) {
                                                    if (_e4255.member_1 < 4u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e4291 = local_10[_e4255.member_1];
                                                    phi_3206_ = array<f32, 3>(_e4291[0], _e4291[1], _e4291[2]);
                                                } else {
                                                    phi_3206_ = _e4239;
                                                }
                                                let _e4297 = phi_3206_;
                                                phi_3117_ = _e4297;
                                            } else {
                                                phi_3117_ = array<f32, 3>();
                                            }
                                            let _e4299 = phi_3117_;
                                            continue;
                                            continuing {
                                                phi_3113_ = _e4253;
                                                phi_3116_ = _e4299;
                                                break if !(_e4259);
                                            }
                                        }
                                        let _e5499 = local_84;
                                        phi_3207_ = _e5499;
                                    } else {
                                        phi_3207_ = _e4144;
                                    }
                                    let _e4302 = phi_3207_;
                                    let _e4313 = (((_e4302[0] * _e4302[0]) + (_e4302[1] * _e4302[1])) + (_e4302[2] * _e4302[2]));
                                    if (_e4313 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4313 > 0f) {
                                            phi_3232_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3232_ = 0f;
                                        }
                                        let _e4372 = phi_3232_;
                                        phi_3296_ = _e4372;
                                    } else {
                                        phi_3239_ = type_26(0i, 5i);
                                        phi_3242_ = bitcast<f32>(((bitcast<u32>(_e4313) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4321 = phi_3239_;
                                            let _e4323 = phi_3242_;
                                            local_44 = _e4323;
                                            if (_e4321.member < _e4321.member_1) {
                                                let _e4331 = (_e4321.member + 1i);
                                                if ((false == (_e4331 > _e4321.member)) != false) {
                                                    phi_3263_ = true;
                                                } else {
                                                    phi_3263_ = false;
                                                }
                                                let _e4336 = phi_3263_;
                                                if _e4336 {
                                                    phi_3269_ = type_27(0u, type_27().member_1);
                                                } else {
                                                    phi_3269_ = type_27(1u, _e4331);
                                                }
                                                let _e4342 = phi_3269_;
                                                if (bitcast<i32>(_e4342.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3240_ = type_26(_e4342.member_1, _e4321.member_1);
                                                phi_3283_ = type_27(1u, _e4321.member);
                                            } else {
                                                phi_3240_ = _e4321;
                                                phi_3283_ = type_27(0u, type_27().member_1);
                                            }
                                            let _e4352 = phi_3240_;
                                            let _e4354 = phi_3283_;
                                            let _e4357 = (bitcast<i32>(_e4354.member) != 0i);
                                            if _e4357 {
                                                phi_3243_ = (0.5f * (_e4323 + (_e4313 / _e4323)));
                                            } else {
                                                phi_3243_ = f32();
                                            }
                                            let _e4362 = phi_3243_;
                                            continue;
                                            continuing {
                                                phi_3239_ = _e4352;
                                                phi_3242_ = _e4362;
                                                break if !(_e4357);
                                            }
                                        }
                                        let _e4367 = local_44;
                                        phi_3296_ = (_e4367 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e4374 = phi_3296_;
                                    let _e4380 = local_15.member[0u];
                                    if (_e4380[0] < 0f) {
                                        phi_3312_ = -(_e4380[0]);
                                    } else {
                                        phi_3312_ = _e4380[0];
                                    }
                                    let _e4387 = phi_3312_;
                                    if (_e4380[1] < 0f) {
                                        phi_3319_ = -(_e4380[1]);
                                    } else {
                                        phi_3319_ = _e4380[1];
                                    }
                                    let _e4391 = phi_3319_;
                                    if (_e4387 > _e4391) {
                                        phi_3324_ = _e4387;
                                    } else {
                                        phi_3324_ = _e4391;
                                    }
                                    let _e4394 = phi_3324_;
                                    if (_e4380[2] < 0f) {
                                        phi_3331_ = -(_e4380[2]);
                                    } else {
                                        phi_3331_ = _e4380[2];
                                    }
                                    let _e4398 = phi_3331_;
                                    if (_e4394 > _e4398) {
                                        phi_3336_ = _e4394;
                                    } else {
                                        phi_3336_ = _e4398;
                                    }
                                    let _e4401 = phi_3336_;
                                    let _e4404 = local_15.member[1u];
                                    if (_e4404[0] < 0f) {
                                        phi_3349_ = -(_e4404[0]);
                                    } else {
                                        phi_3349_ = _e4404[0];
                                    }
                                    let _e4411 = phi_3349_;
                                    if (_e4404[1] < 0f) {
                                        phi_3356_ = -(_e4404[1]);
                                    } else {
                                        phi_3356_ = _e4404[1];
                                    }
                                    let _e4415 = phi_3356_;
                                    if (_e4411 > _e4415) {
                                        phi_3361_ = _e4411;
                                    } else {
                                        phi_3361_ = _e4415;
                                    }
                                    let _e4418 = phi_3361_;
                                    if (_e4404[2] < 0f) {
                                        phi_3368_ = -(_e4404[2]);
                                    } else {
                                        phi_3368_ = _e4404[2];
                                    }
                                    let _e4422 = phi_3368_;
                                    if (_e4418 > _e4422) {
                                        phi_3373_ = _e4418;
                                    } else {
                                        phi_3373_ = _e4422;
                                    }
                                    let _e4425 = phi_3373_;
                                    if (_e4401 > _e4425) {
                                        phi_3378_ = _e4401;
                                    } else {
                                        phi_3378_ = _e4425;
                                    }
                                    let _e4428 = phi_3378_;
                                    let _e4430 = local_15.member_3;
                                    let _e4434 = local_15.member_1[0u];
                                    if (_e4434[0] < 0f) {
                                        phi_3395_ = -(_e4434[0]);
                                    } else {
                                        phi_3395_ = _e4434[0];
                                    }
                                    let _e4441 = phi_3395_;
                                    if (_e4434[1] < 0f) {
                                        phi_3402_ = -(_e4434[1]);
                                    } else {
                                        phi_3402_ = _e4434[1];
                                    }
                                    let _e4445 = phi_3402_;
                                    if (_e4441 > _e4445) {
                                        phi_3407_ = _e4441;
                                    } else {
                                        phi_3407_ = _e4445;
                                    }
                                    let _e4448 = phi_3407_;
                                    if (_e4434[2] < 0f) {
                                        phi_3414_ = -(_e4434[2]);
                                    } else {
                                        phi_3414_ = _e4434[2];
                                    }
                                    let _e4452 = phi_3414_;
                                    if (_e4448 > _e4452) {
                                        phi_3419_ = _e4448;
                                    } else {
                                        phi_3419_ = _e4452;
                                    }
                                    let _e4455 = phi_3419_;
                                    let _e4458 = local_15.member_1[1u];
                                    if (_e4458[0] < 0f) {
                                        phi_3433_ = -(_e4458[0]);
                                    } else {
                                        phi_3433_ = _e4458[0];
                                    }
                                    let _e4465 = phi_3433_;
                                    if (_e4458[1] < 0f) {
                                        phi_3440_ = -(_e4458[1]);
                                    } else {
                                        phi_3440_ = _e4458[1];
                                    }
                                    let _e4469 = phi_3440_;
                                    if (_e4465 > _e4469) {
                                        phi_3445_ = _e4465;
                                    } else {
                                        phi_3445_ = _e4469;
                                    }
                                    let _e4472 = phi_3445_;
                                    if (_e4458[2] < 0f) {
                                        phi_3452_ = -(_e4458[2]);
                                    } else {
                                        phi_3452_ = _e4458[2];
                                    }
                                    let _e4476 = phi_3452_;
                                    if (_e4472 > _e4476) {
                                        phi_3457_ = _e4472;
                                    } else {
                                        phi_3457_ = _e4476;
                                    }
                                    let _e4479 = phi_3457_;
                                    if (_e4455 > _e4479) {
                                        phi_3462_ = _e4455;
                                    } else {
                                        phi_3462_ = _e4479;
                                    }
                                    let _e4482 = phi_3462_;
                                    let _e4484 = local_15.member_3;
                                    let _e4488 = local_15.member_2[0u];
                                    if (_e4488[0] < 0f) {
                                        phi_3479_ = -(_e4488[0]);
                                    } else {
                                        phi_3479_ = _e4488[0];
                                    }
                                    let _e4495 = phi_3479_;
                                    if (_e4488[1] < 0f) {
                                        phi_3486_ = -(_e4488[1]);
                                    } else {
                                        phi_3486_ = _e4488[1];
                                    }
                                    let _e4499 = phi_3486_;
                                    if (_e4495 > _e4499) {
                                        phi_3491_ = _e4495;
                                    } else {
                                        phi_3491_ = _e4499;
                                    }
                                    let _e4502 = phi_3491_;
                                    if (_e4488[2] < 0f) {
                                        phi_3498_ = -(_e4488[2]);
                                    } else {
                                        phi_3498_ = _e4488[2];
                                    }
                                    let _e4506 = phi_3498_;
                                    if (_e4502 > _e4506) {
                                        phi_3503_ = _e4502;
                                    } else {
                                        phi_3503_ = _e4506;
                                    }
                                    let _e4509 = phi_3503_;
                                    let _e4512 = local_15.member_2[1u];
                                    if (_e4512[0] < 0f) {
                                        phi_3517_ = -(_e4512[0]);
                                    } else {
                                        phi_3517_ = _e4512[0];
                                    }
                                    let _e4519 = phi_3517_;
                                    if (_e4512[1] < 0f) {
                                        phi_3524_ = -(_e4512[1]);
                                    } else {
                                        phi_3524_ = _e4512[1];
                                    }
                                    let _e4523 = phi_3524_;
                                    if (_e4519 > _e4523) {
                                        phi_3529_ = _e4519;
                                    } else {
                                        phi_3529_ = _e4523;
                                    }
                                    let _e4526 = phi_3529_;
                                    if (_e4512[2] < 0f) {
                                        phi_3536_ = -(_e4512[2]);
                                    } else {
                                        phi_3536_ = _e4512[2];
                                    }
                                    let _e4530 = phi_3536_;
                                    if (_e4526 > _e4530) {
                                        phi_3541_ = _e4526;
                                    } else {
                                        phi_3541_ = _e4530;
                                    }
                                    let _e4533 = phi_3541_;
                                    if (_e4509 > _e4533) {
                                        phi_3546_ = _e4509;
                                    } else {
                                        phi_3546_ = _e4533;
                                    }
                                    let _e4536 = phi_3546_;
                                    let _e4538 = local_15.member_3;
                                    let _e4545 = local_15.member_3;
                                    let _e4552 = (((_e4374 * (1f + (0.000000059604645f * 8f))) + (((((((_e4428 + _e4430) + (_e4482 + _e4484)) + (_e4536 + _e4538)) * (0.000000059604645f * 16f)) + (_e4545 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e264);
                                    if _e4552 {
                                        phi_3566_ = false;
                                    } else {
                                        phi_3566_ = true;
                                    }
                                    let _e4554 = phi_3566_;
                                    phi_3567_ = _e4554;
                                    phi_3568_ = _e4552;
                                } else {
                                    phi_3567_ = false;
                                    phi_3568_ = false;
                                }
                                let _e4556 = phi_3567_;
                                let _e4558 = phi_3568_;
                                local_45 = _e4558;
                                continue;
                                continuing {
                                    phi_2608_ = _e3998;
                                    break if !(_e4556);
                                }
                            }
                            let _e4561 = local_45;
                            if _e4561 {
                                phi_3573_ = type_55(1u, _e3971.member_1);
                                phi_3574_ = false;
                            } else {
                                phi_3573_ = type_55();
                                phi_3574_ = true;
                            }
                            let _e4564 = phi_3573_;
                            let _e4566 = phi_3574_;
                            if _e4566 {
                                phi_3579_ = type_55(2u, _e3971.member_1);
                                phi_3580_ = false;
                            } else {
                                phi_3579_ = type_55();
                                phi_3580_ = true;
                            }
                            let _e4569 = phi_3579_;
                            let _e4571 = phi_3580_;
                            phi_3582_ = _e4569;
                            phi_3583_ = _e4564;
                            phi_3584_ = _e4571;
                        } else {
                            phi_3582_ = type_55();
                            phi_3583_ = type_55(0u, type_55().member_1);
                            phi_3584_ = true;
                        }
                        let _e4573 = phi_3582_;
                        let _e4575 = phi_3583_;
                        let _e4577 = phi_3584_;
                        if _e4577 {
                            phi_3588_ = _e4575;
                        } else {
                            phi_3588_ = _e4573;
                        }
                        let _e4579 = phi_3588_;
                        phi_6862_ = _e4579;
                    } else {
                        if (_e362 < 0f) {
                            phi_3598_ = -(_e362);
                        } else {
                            phi_3598_ = _e362;
                        }
                        let _e705 = phi_3598_;
                        if (_e385 < 0f) {
                            phi_3604_ = -(_e385);
                        } else {
                            phi_3604_ = _e385;
                        }
                        let _e709 = phi_3604_;
                        if (_e705 > _e709) {
                            phi_3609_ = _e705;
                        } else {
                            phi_3609_ = _e709;
                        }
                        let _e712 = phi_3609_;
                        if (_e408 < 0f) {
                            phi_3615_ = -(_e408);
                        } else {
                            phi_3615_ = _e408;
                        }
                        let _e716 = phi_3615_;
                        if (_e419 < 0f) {
                            phi_3621_ = -(_e419);
                        } else {
                            phi_3621_ = _e419;
                        }
                        let _e720 = phi_3621_;
                        if (_e716 > _e720) {
                            phi_3626_ = _e716;
                        } else {
                            phi_3626_ = _e720;
                        }
                        let _e723 = phi_3626_;
                        if (_e712 > _e723) {
                            phi_3631_ = _e712;
                        } else {
                            phi_3631_ = _e723;
                        }
                        let _e726 = phi_3631_;
                        let _e727 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e726 >= _e727) {
                            phi_3639_ = (_e726 <= (1f / _e727));
                        } else {
                            phi_3639_ = false;
                        }
                        let _e732 = phi_3639_;
                        if _e732 {
                            phi_3644_ = (0.000000059604645f * 256f);
                        } else {
                            phi_3644_ = 2f;
                        }
                        let _e735 = phi_3644_;
                        let _e737 = ((_e669 * 0.34f) + (_e726 * _e735));
                        if _e732 {
                            phi_3651_ = (1f / _e726);
                        } else {
                            phi_3651_ = 0f;
                        }
                        let _e740 = phi_3651_;
                        let _e746 = ((_e385 - (3f * _e362)) * _e740);
                        let _e747 = ((_e408 - _e385) * _e740);
                        let _e748 = (((3f * _e419) - _e408) * _e740);
                        local_7[0u] = 0f;
                        local_7[1u] = 1f;
                        local_7[2u] = 1f;
                        local_7[3u] = 1f;
                        let _e755 = ((_e747 * _e747) - (_e746 * _e748));
                        if (_e755 > 0f) {
                            if (_e755 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e755 > 0f) {
                                    phi_3684_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_3684_ = 0f;
                                }
                                let _e815 = phi_3684_;
                                phi_3748_ = _e815;
                            } else {
                                phi_3691_ = type_26(0i, 5i);
                                phi_3694_ = bitcast<f32>(((bitcast<u32>(_e755) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e764 = phi_3691_;
                                    let _e766 = phi_3694_;
                                    local_16 = _e766;
                                    if (_e764.member < _e764.member_1) {
                                        let _e774 = (_e764.member + 1i);
                                        if ((false == (_e774 > _e764.member)) != false) {
                                            phi_3715_ = true;
                                        } else {
                                            phi_3715_ = false;
                                        }
                                        let _e779 = phi_3715_;
                                        if _e779 {
                                            phi_3721_ = type_27(0u, type_27().member_1);
                                        } else {
                                            phi_3721_ = type_27(1u, _e774);
                                        }
                                        let _e785 = phi_3721_;
                                        if (bitcast<i32>(_e785.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_3692_ = type_26(_e785.member_1, _e764.member_1);
                                        phi_3735_ = type_27(1u, _e764.member);
                                    } else {
                                        phi_3692_ = _e764;
                                        phi_3735_ = type_27(0u, type_27().member_1);
                                    }
                                    let _e795 = phi_3692_;
                                    let _e797 = phi_3735_;
                                    let _e800 = (bitcast<i32>(_e797.member) != 0i);
                                    if _e800 {
                                        phi_3695_ = (0.5f * (_e766 + (_e755 / _e766)));
                                    } else {
                                        phi_3695_ = f32();
                                    }
                                    let _e805 = phi_3695_;
                                    continue;
                                    continuing {
                                        phi_3691_ = _e795;
                                        phi_3694_ = _e805;
                                        break if !(_e800);
                                    }
                                }
                                let _e810 = local_16;
                                phi_3748_ = (_e810 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e817 = phi_3748_;
                            if (_e747 < 0f) {
                                phi_3754_ = -(_e817);
                            } else {
                                phi_3754_ = _e817;
                            }
                            let _e821 = phi_3754_;
                            let _e823 = -((_e747 + _e821));
                            local_8[0u] = (_e823 / (_e823 + _e748));
                            local_8[1u] = (_e746 / (_e746 + _e823));
                            let _e832 = local_8[1u];
                            let _e833 = local_8[0u];
                            if (_e832 < _e833) {
                                let _e836 = local_8[1u];
                                let _e838 = local_8[0u];
                                local_8[0u] = _e836;
                                local_8[1u] = _e838;
                            }
                            phi_3779_ = type_28(0u, 2u);
                            phi_3782_ = 1u;
                            loop {
                                let _e842 = phi_3779_;
                                let _e844 = phi_3782_;
                                local_46 = _e844;
                                if (_e842.member < _e842.member_1) {
                                    phi_3780_ = type_28((_e842.member + 1u), _e842.member_1);
                                    phi_3805_ = type_28(1u, _e842.member);
                                } else {
                                    phi_3780_ = _e842;
                                    phi_3805_ = type_28(0u, type_28().member_1);
                                }
                                let _e858 = phi_3780_;
                                let _e860 = phi_3805_;
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
                                            phi_3849_ = (_e844 + 1u);
                                        } else {
                                            phi_3849_ = _e844;
                                        }
                                        let _e880 = phi_3849_;
                                        phi_3850_ = _e880;
                                    } else {
                                        phi_3850_ = _e844;
                                    }
                                    let _e882 = phi_3850_;
                                    phi_3783_ = _e882;
                                } else {
                                    phi_3783_ = u32();
                                }
                                let _e884 = phi_3783_;
                                continue;
                                continuing {
                                    phi_3779_ = _e858;
                                    phi_3782_ = _e884;
                                    break if !(_e864);
                                }
                            }
                            let _e4789 = local_46;
                            phi_3851_ = _e4789;
                        } else {
                            phi_3851_ = 1u;
                        }
                        let _e887 = phi_3851_;
                        if (_e887 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e887] = 1f;
                        let _e890 = local_7;
                        local_9 = _e890;
                        phi_3871_ = type_28(0u, _e887);
                        loop {
                            let _e893 = phi_3871_;
                            if (_e893.member < _e893.member_1) {
                                phi_3872_ = type_28((_e893.member + 1u), _e893.member_1);
                                phi_3895_ = type_28(1u, _e893.member);
                            } else {
                                phi_3872_ = _e893;
                                phi_3895_ = type_28(0u, type_28().member_1);
                            }
                            let _e907 = phi_3872_;
                            let _e909 = phi_3895_;
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
                                let _e932 = ((((_e362 * _e921) + (_e385 * _e916)) * (_e921 * _e921)) + (((_e408 * _e921) + (_e419 * _e916)) * (_e916 * _e916)));
                                let _e933 = (1f - _e920);
                                let _e944 = ((((_e362 * _e933) + (_e385 * _e920)) * (_e933 * _e933)) + (((_e408 * _e933) + (_e419 * _e920)) * (_e920 * _e920)));
                                if (_e932 < 0f) {
                                    phi_3947_ = -(_e932);
                                } else {
                                    phi_3947_ = _e932;
                                }
                                let _e948 = phi_3947_;
                                let _e949 = (_e948 > _e737);
                                if (_e944 < 0f) {
                                    phi_3954_ = -(_e944);
                                } else {
                                    phi_3954_ = _e944;
                                }
                                let _e953 = phi_3954_;
                                let _e954 = (_e953 > _e737);
                                if _e949 {
                                    if _e954 {
                                        phi_3965_ = ((_e932 > 0f) != (_e944 > 0f));
                                        phi_3966_ = false;
                                    } else {
                                        phi_3965_ = bool();
                                        phi_3966_ = true;
                                    }
                                    let _e959 = phi_3965_;
                                    let _e961 = phi_3966_;
                                    phi_3967_ = _e959;
                                    phi_3968_ = _e961;
                                } else {
                                    phi_3967_ = bool();
                                    phi_3968_ = true;
                                }
                                let _e963 = phi_3967_;
                                let _e965 = phi_3968_;
                                if _e965 {
                                    phi_3972_ = false;
                                } else {
                                    phi_3972_ = _e963;
                                }
                                let _e967 = phi_3972_;
                                if _e949 {
                                    if _e954 {
                                        if _e967 {
                                            phi_3983_ = type_56();
                                        } else {
                                            phi_3983_ = type_56(1f, 0f, _e967);
                                        }
                                        let _e970 = phi_3983_;
                                        phi_3984_ = _e970;
                                        phi_3985_ = _e967;
                                    } else {
                                        phi_3984_ = type_56();
                                        phi_3985_ = true;
                                    }
                                    let _e972 = phi_3984_;
                                    let _e974 = phi_3985_;
                                    phi_3986_ = _e972;
                                    phi_3987_ = _e974;
                                } else {
                                    phi_3986_ = type_56();
                                    phi_3987_ = true;
                                }
                                let _e976 = phi_3986_;
                                let _e978 = phi_3987_;
                                if _e978 {
                                    if _e949 {
                                        if (_e932 < 0f) {
                                            phi_3998_ = -1f;
                                        } else {
                                            phi_3998_ = 1f;
                                        }
                                        let _e981 = phi_3998_;
                                        let _e984 = (_e408 - _e385);
                                        phi_4008_ = type_28(0u, 64u);
                                        phi_4011_ = _e920;
                                        phi_4013_ = _e916;
                                        phi_4015_ = (0.5f * (_e916 + _e920));
                                        loop {
                                            let _e990 = phi_4008_;
                                            let _e992 = phi_4011_;
                                            let _e994 = phi_4013_;
                                            let _e996 = phi_4015_;
                                            local_48 = _e994;
                                            if (_e990.member < _e990.member_1) {
                                                phi_4009_ = type_28((_e990.member + 1u), _e990.member_1);
                                                phi_4038_ = type_28(1u, _e990.member);
                                            } else {
                                                phi_4009_ = _e990;
                                                phi_4038_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1010 = phi_4009_;
                                            let _e1012 = phi_4038_;
                                            if (bitcast<i32>(_e1012.member) != 0i) {
                                                let _e1016 = (1f - _e996);
                                                let _e1029 = ((_e981 * ((((_e362 * _e1016) + (_e385 * _e996)) * (_e1016 * _e1016)) + (((_e408 * _e1016) + (_e419 * _e996)) * (_e996 * _e996)))) - _e737);
                                                if (_e1029 > 0f) {
                                                    phi_4063_ = _e992;
                                                    phi_4064_ = _e996;
                                                } else {
                                                    phi_4063_ = _e996;
                                                    phi_4064_ = _e994;
                                                }
                                                let _e1032 = phi_4063_;
                                                let _e1034 = phi_4064_;
                                                let _e1036 = ((_e1032 - _e1034) > 0.00000000000022737368f);
                                                if _e1036 {
                                                    let _e1037 = (1f - _e996);
                                                    let _e1049 = (-(_e1029) / (_e981 * (((((_e385 - (3f * _e362)) * _e1037) + (_e984 * _e996)) * _e1037) + (((_e984 * _e1037) + (((3f * _e419) - _e408) * _e996)) * _e996))));
                                                    if (_e1029 > 0f) {
                                                        phi_4090_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_4090_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1055 = phi_4090_;
                                                    let _e1057 = ((_e996 + _e1049) + _e1055);
                                                    if (_e1057 > _e1034) {
                                                        if (_e1057 < _e1032) {
                                                            if (_e1049 < 0f) {
                                                                phi_4106_ = -(_e1049);
                                                            } else {
                                                                phi_4106_ = _e1049;
                                                            }
                                                            let _e1063 = phi_4106_;
                                                            if (_e1063 < (0.5f * (_e1032 - _e1034))) {
                                                                phi_4113_ = false;
                                                            } else {
                                                                phi_4113_ = true;
                                                            }
                                                            let _e1068 = phi_4113_;
                                                            phi_4114_ = _e1068;
                                                        } else {
                                                            phi_4114_ = true;
                                                        }
                                                        let _e1070 = phi_4114_;
                                                        phi_4115_ = _e1070;
                                                    } else {
                                                        phi_4115_ = true;
                                                    }
                                                    let _e1072 = phi_4115_;
                                                    if _e1072 {
                                                        phi_4121_ = (0.5f * (_e1034 + _e1032));
                                                    } else {
                                                        phi_4121_ = _e1057;
                                                    }
                                                    let _e1076 = phi_4121_;
                                                    phi_4122_ = _e1076;
                                                    phi_4123_ = false;
                                                } else {
                                                    phi_4122_ = f32();
                                                    phi_4123_ = true;
                                                }
                                                let _e1078 = phi_4122_;
                                                let _e1080 = phi_4123_;
                                                phi_4012_ = _e1032;
                                                phi_4014_ = _e1034;
                                                phi_4016_ = _e1078;
                                                phi_4124_ = _e1034;
                                                phi_4125_ = _e1036;
                                                phi_4126_ = _e1080;
                                            } else {
                                                phi_4012_ = f32();
                                                phi_4014_ = f32();
                                                phi_4016_ = f32();
                                                phi_4124_ = f32();
                                                phi_4125_ = false;
                                                phi_4126_ = false;
                                            }
                                            let _e1082 = phi_4012_;
                                            let _e1084 = phi_4014_;
                                            let _e1086 = phi_4016_;
                                            let _e1088 = phi_4124_;
                                            let _e1090 = phi_4125_;
                                            let _e1092 = phi_4126_;
                                            local_17 = _e1092;
                                            local_47 = _e1088;
                                            continue;
                                            continuing {
                                                phi_4008_ = _e1010;
                                                phi_4011_ = _e1082;
                                                phi_4013_ = _e1084;
                                                phi_4015_ = _e1086;
                                                break if !(_e1090);
                                            }
                                        }
                                        let _e1095 = local_17;
                                        if _e1095 {
                                            let _e4831 = local_47;
                                            phi_4130_ = _e4831;
                                        } else {
                                            let _e4833 = local_48;
                                            phi_4130_ = _e4833;
                                        }
                                        let _e1097 = phi_4130_;
                                        phi_4131_ = _e1097;
                                    } else {
                                        phi_4131_ = _e916;
                                    }
                                    let _e1099 = phi_4131_;
                                    if _e954 {
                                        phi_4138_ = type_28(0u, 64u);
                                        phi_4141_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1102 = phi_4138_;
                                            let _e1104 = phi_4141_;
                                            if (_e1102.member < _e1102.member_1) {
                                                phi_4139_ = type_28((_e1102.member + 1u), _e1102.member_1);
                                                phi_4164_ = type_28(1u, _e1102.member);
                                            } else {
                                                phi_4139_ = _e1102;
                                                phi_4164_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1118 = phi_4139_;
                                            let _e1120 = phi_4164_;
                                            if (bitcast<i32>(_e1120.member) != 0i) {
                                                let _e1124 = (_e1099 + _e1104);
                                                if (_e1124 < _e920) {
                                                    let _e1126 = (1f - _e1124);
                                                    let _e1137 = ((((_e362 * _e1126) + (_e385 * _e1124)) * (_e1126 * _e1126)) + (((_e408 * _e1126) + (_e419 * _e1124)) * (_e1124 * _e1124)));
                                                    let _e1138 = (1f - _e1099);
                                                    let _e1149 = ((((_e362 * _e1138) + (_e385 * _e1099)) * (_e1138 * _e1138)) + (((_e408 * _e1138) + (_e419 * _e1099)) * (_e1099 * _e1099)));
                                                    if (_e1137 < 0f) {
                                                        phi_4205_ = -(_e1137);
                                                    } else {
                                                        phi_4205_ = _e1137;
                                                    }
                                                    let _e1153 = phi_4205_;
                                                    if (_e1153 > _e737) {
                                                        if (_e1149 < 0f) {
                                                            phi_4215_ = -(_e1149);
                                                        } else {
                                                            phi_4215_ = _e1149;
                                                        }
                                                        let _e1158 = phi_4215_;
                                                        if (_e1158 > _e737) {
                                                            phi_4223_ = ((_e1137 > 0f) == (_e1149 > 0f));
                                                        } else {
                                                            phi_4223_ = false;
                                                        }
                                                        let _e1164 = phi_4223_;
                                                        phi_4225_ = !(_e1164);
                                                    } else {
                                                        phi_4225_ = false;
                                                    }
                                                    let _e1167 = phi_4225_;
                                                    if _e1167 {
                                                        phi_4230_ = f32();
                                                        phi_4231_ = false;
                                                    } else {
                                                        phi_4230_ = (_e1104 + _e1104);
                                                        phi_4231_ = true;
                                                    }
                                                    let _e1170 = phi_4230_;
                                                    let _e1172 = phi_4231_;
                                                    phi_4232_ = _e1170;
                                                    phi_4233_ = _e1172;
                                                    phi_4234_ = _e1167;
                                                    phi_4235_ = false;
                                                } else {
                                                    phi_4232_ = f32();
                                                    phi_4233_ = false;
                                                    phi_4234_ = false;
                                                    phi_4235_ = true;
                                                }
                                                let _e1174 = phi_4232_;
                                                let _e1176 = phi_4233_;
                                                let _e1178 = phi_4234_;
                                                let _e1180 = phi_4235_;
                                                phi_4236_ = _e1124;
                                                phi_4142_ = _e1174;
                                                phi_4237_ = _e1176;
                                                phi_4238_ = _e1178;
                                                phi_4239_ = _e1180;
                                                phi_4240_ = false;
                                            } else {
                                                phi_4236_ = f32();
                                                phi_4142_ = f32();
                                                phi_4237_ = false;
                                                phi_4238_ = false;
                                                phi_4239_ = false;
                                                phi_4240_ = true;
                                            }
                                            let _e1182 = phi_4236_;
                                            let _e1184 = phi_4142_;
                                            let _e1186 = phi_4237_;
                                            let _e1188 = phi_4238_;
                                            let _e1190 = phi_4239_;
                                            let _e1192 = phi_4240_;
                                            local_18 = _e1188;
                                            local_49 = _e1190;
                                            local_50 = _e1192;
                                            local_51 = _e1182;
                                            continue;
                                            continuing {
                                                phi_4138_ = _e1118;
                                                phi_4141_ = _e1184;
                                                break if !(_e1186);
                                            }
                                        }
                                        let _e1195 = local_18;
                                        if _e1195 {
                                            phi_4244_ = false;
                                            phi_4245_ = false;
                                        } else {
                                            let _e4858 = local_49;
                                            phi_4244_ = _e4858;
                                            let _e4861 = local_50;
                                            phi_4245_ = _e4861;
                                        }
                                        let _e1197 = phi_4244_;
                                        let _e1199 = phi_4245_;
                                        if _e1197 {
                                            phi_4249_ = true;
                                        } else {
                                            phi_4249_ = _e1199;
                                        }
                                        let _e1201 = phi_4249_;
                                        if _e1201 {
                                            phi_4253_ = _e920;
                                        } else {
                                            let _e4865 = local_51;
                                            phi_4253_ = _e4865;
                                        }
                                        let _e1203 = phi_4253_;
                                        phi_4254_ = _e1203;
                                    } else {
                                        phi_4254_ = _e920;
                                    }
                                    let _e1205 = phi_4254_;
                                    phi_4256_ = type_56(_e1099, _e1205, _e967);
                                } else {
                                    phi_4256_ = _e976;
                                }
                                let _e1208 = phi_4256_;
                                if (_e1208.member > _e1208.member_1) {
                                    phi_6818_ = f32();
                                    phi_6819_ = true;
                                    phi_6820_ = false;
                                    phi_6821_ = false;
                                    phi_6822_ = false;
                                } else {
                                    let _e1215 = ((_e1208.member_1 - _e1208.member) * 0.5f);
                                    let _e1216 = (_e1208.member + _e1215);
                                    let _e1218 = (_e1215 + (0.000000059604645f * 4f));
                                    let _e1220 = local_15.member_3;
                                    let _e1223 = local_15.member[0u];
                                    if (_e1223[0] < 0f) {
                                        phi_4285_ = -(_e1223[0]);
                                    } else {
                                        phi_4285_ = _e1223[0];
                                    }
                                    let _e1230 = phi_4285_;
                                    if (_e1223[1] < 0f) {
                                        phi_4292_ = -(_e1223[1]);
                                    } else {
                                        phi_4292_ = _e1223[1];
                                    }
                                    let _e1234 = phi_4292_;
                                    if (_e1230 > _e1234) {
                                        phi_4297_ = _e1230;
                                    } else {
                                        phi_4297_ = _e1234;
                                    }
                                    let _e1237 = phi_4297_;
                                    if (_e1223[2] < 0f) {
                                        phi_4304_ = -(_e1223[2]);
                                    } else {
                                        phi_4304_ = _e1223[2];
                                    }
                                    let _e1241 = phi_4304_;
                                    if (_e1237 > _e1241) {
                                        phi_4309_ = _e1237;
                                    } else {
                                        phi_4309_ = _e1241;
                                    }
                                    let _e1244 = phi_4309_;
                                    let _e1246 = local_15.member[1u];
                                    if (_e1246[0] < 0f) {
                                        phi_4322_ = -(_e1246[0]);
                                    } else {
                                        phi_4322_ = _e1246[0];
                                    }
                                    let _e1253 = phi_4322_;
                                    if (_e1246[1] < 0f) {
                                        phi_4329_ = -(_e1246[1]);
                                    } else {
                                        phi_4329_ = _e1246[1];
                                    }
                                    let _e1257 = phi_4329_;
                                    if (_e1253 > _e1257) {
                                        phi_4334_ = _e1253;
                                    } else {
                                        phi_4334_ = _e1257;
                                    }
                                    let _e1260 = phi_4334_;
                                    if (_e1246[2] < 0f) {
                                        phi_4341_ = -(_e1246[2]);
                                    } else {
                                        phi_4341_ = _e1246[2];
                                    }
                                    let _e1264 = phi_4341_;
                                    if (_e1260 > _e1264) {
                                        phi_4346_ = _e1260;
                                    } else {
                                        phi_4346_ = _e1264;
                                    }
                                    let _e1267 = phi_4346_;
                                    if (_e1244 > _e1267) {
                                        phi_4351_ = _e1244;
                                    } else {
                                        phi_4351_ = _e1267;
                                    }
                                    let _e1270 = phi_4351_;
                                    let _e1273 = local_15.member[0u];
                                    let _e1278 = local_15.member[1u];
                                    let _e1288 = (_e1273[0] + ((_e1278[0] - _e1273[0]) * _e1216));
                                    let _e1289 = (_e1273[1] + ((_e1278[1] - _e1273[1]) * _e1216));
                                    let _e1290 = (_e1273[2] + ((_e1278[2] - _e1273[2]) * _e1216));
                                    let _e1292 = local_15.member[1u];
                                    let _e1297 = local_15.member[0u];
                                    let _e1301 = (_e1292[0] - _e1297[0]);
                                    let _e1302 = (_e1292[1] - _e1297[1]);
                                    let _e1303 = (_e1292[2] - _e1297[2]);
                                    if (_e1301 < 0f) {
                                        phi_4410_ = -(_e1301);
                                    } else {
                                        phi_4410_ = _e1301;
                                    }
                                    let _e1307 = phi_4410_;
                                    if (_e1302 < 0f) {
                                        phi_4416_ = -(_e1302);
                                    } else {
                                        phi_4416_ = _e1302;
                                    }
                                    let _e1311 = phi_4416_;
                                    if (_e1307 > _e1311) {
                                        phi_4421_ = _e1307;
                                    } else {
                                        phi_4421_ = _e1311;
                                    }
                                    let _e1314 = phi_4421_;
                                    if (_e1303 < 0f) {
                                        phi_4427_ = -(_e1303);
                                    } else {
                                        phi_4427_ = _e1303;
                                    }
                                    let _e1318 = phi_4427_;
                                    if (_e1314 > _e1318) {
                                        phi_4432_ = _e1314;
                                    } else {
                                        phi_4432_ = _e1318;
                                    }
                                    let _e1321 = phi_4432_;
                                    let _e1327 = ((((_e1218 * _e1321) * 1.01f) + ((_e1270 + _e1220) * (0.000000059604645f * 8f))) + _e1220);
                                    if (_e1288 < 0f) {
                                        phi_4444_ = -(_e1288);
                                    } else {
                                        phi_4444_ = _e1288;
                                    }
                                    let _e1331 = phi_4444_;
                                    if (_e1289 < 0f) {
                                        phi_4450_ = -(_e1289);
                                    } else {
                                        phi_4450_ = _e1289;
                                    }
                                    let _e1335 = phi_4450_;
                                    if (_e1331 > _e1335) {
                                        phi_4455_ = _e1331;
                                    } else {
                                        phi_4455_ = _e1335;
                                    }
                                    let _e1338 = phi_4455_;
                                    if (_e1290 < 0f) {
                                        phi_4461_ = -(_e1290);
                                    } else {
                                        phi_4461_ = _e1290;
                                    }
                                    let _e1342 = phi_4461_;
                                    if (_e1338 > _e1342) {
                                        phi_4466_ = _e1338;
                                    } else {
                                        phi_4466_ = _e1342;
                                    }
                                    let _e1345 = phi_4466_;
                                    local_3 = type_40(array<f32, 3>(_e1288, _e1289, _e1290), _e1327, (_e1345 + _e1327));
                                    let _e1351 = local_15.member_3;
                                    let _e1353 = local_15.member_1[0u];
                                    if (_e1353[0] < 0f) {
                                        phi_4492_ = -(_e1353[0]);
                                    } else {
                                        phi_4492_ = _e1353[0];
                                    }
                                    let _e1360 = phi_4492_;
                                    if (_e1353[1] < 0f) {
                                        phi_4499_ = -(_e1353[1]);
                                    } else {
                                        phi_4499_ = _e1353[1];
                                    }
                                    let _e1364 = phi_4499_;
                                    if (_e1360 > _e1364) {
                                        phi_4504_ = _e1360;
                                    } else {
                                        phi_4504_ = _e1364;
                                    }
                                    let _e1367 = phi_4504_;
                                    if (_e1353[2] < 0f) {
                                        phi_4511_ = -(_e1353[2]);
                                    } else {
                                        phi_4511_ = _e1353[2];
                                    }
                                    let _e1371 = phi_4511_;
                                    if (_e1367 > _e1371) {
                                        phi_4516_ = _e1367;
                                    } else {
                                        phi_4516_ = _e1371;
                                    }
                                    let _e1374 = phi_4516_;
                                    let _e1376 = local_15.member_1[1u];
                                    if (_e1376[0] < 0f) {
                                        phi_4529_ = -(_e1376[0]);
                                    } else {
                                        phi_4529_ = _e1376[0];
                                    }
                                    let _e1383 = phi_4529_;
                                    if (_e1376[1] < 0f) {
                                        phi_4536_ = -(_e1376[1]);
                                    } else {
                                        phi_4536_ = _e1376[1];
                                    }
                                    let _e1387 = phi_4536_;
                                    if (_e1383 > _e1387) {
                                        phi_4541_ = _e1383;
                                    } else {
                                        phi_4541_ = _e1387;
                                    }
                                    let _e1390 = phi_4541_;
                                    if (_e1376[2] < 0f) {
                                        phi_4548_ = -(_e1376[2]);
                                    } else {
                                        phi_4548_ = _e1376[2];
                                    }
                                    let _e1394 = phi_4548_;
                                    if (_e1390 > _e1394) {
                                        phi_4553_ = _e1390;
                                    } else {
                                        phi_4553_ = _e1394;
                                    }
                                    let _e1397 = phi_4553_;
                                    if (_e1374 > _e1397) {
                                        phi_4558_ = _e1374;
                                    } else {
                                        phi_4558_ = _e1397;
                                    }
                                    let _e1400 = phi_4558_;
                                    let _e1403 = local_15.member_1[0u];
                                    let _e1408 = local_15.member_1[1u];
                                    let _e1418 = (_e1403[0] + ((_e1408[0] - _e1403[0]) * _e1216));
                                    let _e1419 = (_e1403[1] + ((_e1408[1] - _e1403[1]) * _e1216));
                                    let _e1420 = (_e1403[2] + ((_e1408[2] - _e1403[2]) * _e1216));
                                    let _e1422 = local_15.member_1[1u];
                                    let _e1427 = local_15.member_1[0u];
                                    let _e1431 = (_e1422[0] - _e1427[0]);
                                    let _e1432 = (_e1422[1] - _e1427[1]);
                                    let _e1433 = (_e1422[2] - _e1427[2]);
                                    if (_e1431 < 0f) {
                                        phi_4617_ = -(_e1431);
                                    } else {
                                        phi_4617_ = _e1431;
                                    }
                                    let _e1437 = phi_4617_;
                                    if (_e1432 < 0f) {
                                        phi_4623_ = -(_e1432);
                                    } else {
                                        phi_4623_ = _e1432;
                                    }
                                    let _e1441 = phi_4623_;
                                    if (_e1437 > _e1441) {
                                        phi_4628_ = _e1437;
                                    } else {
                                        phi_4628_ = _e1441;
                                    }
                                    let _e1444 = phi_4628_;
                                    if (_e1433 < 0f) {
                                        phi_4634_ = -(_e1433);
                                    } else {
                                        phi_4634_ = _e1433;
                                    }
                                    let _e1448 = phi_4634_;
                                    if (_e1444 > _e1448) {
                                        phi_4639_ = _e1444;
                                    } else {
                                        phi_4639_ = _e1448;
                                    }
                                    let _e1451 = phi_4639_;
                                    let _e1457 = ((((_e1218 * _e1451) * 1.01f) + ((_e1400 + _e1351) * (0.000000059604645f * 8f))) + _e1351);
                                    if (_e1418 < 0f) {
                                        phi_4651_ = -(_e1418);
                                    } else {
                                        phi_4651_ = _e1418;
                                    }
                                    let _e1461 = phi_4651_;
                                    if (_e1419 < 0f) {
                                        phi_4657_ = -(_e1419);
                                    } else {
                                        phi_4657_ = _e1419;
                                    }
                                    let _e1465 = phi_4657_;
                                    if (_e1461 > _e1465) {
                                        phi_4662_ = _e1461;
                                    } else {
                                        phi_4662_ = _e1465;
                                    }
                                    let _e1468 = phi_4662_;
                                    if (_e1420 < 0f) {
                                        phi_4668_ = -(_e1420);
                                    } else {
                                        phi_4668_ = _e1420;
                                    }
                                    let _e1472 = phi_4668_;
                                    if (_e1468 > _e1472) {
                                        phi_4673_ = _e1468;
                                    } else {
                                        phi_4673_ = _e1472;
                                    }
                                    let _e1475 = phi_4673_;
                                    local_4 = type_40(array<f32, 3>(_e1418, _e1419, _e1420), _e1457, (_e1475 + _e1457));
                                    let _e1481 = local_15.member_3;
                                    let _e1483 = local_15.member_2[0u];
                                    if (_e1483[0] < 0f) {
                                        phi_4699_ = -(_e1483[0]);
                                    } else {
                                        phi_4699_ = _e1483[0];
                                    }
                                    let _e1490 = phi_4699_;
                                    if (_e1483[1] < 0f) {
                                        phi_4706_ = -(_e1483[1]);
                                    } else {
                                        phi_4706_ = _e1483[1];
                                    }
                                    let _e1494 = phi_4706_;
                                    if (_e1490 > _e1494) {
                                        phi_4711_ = _e1490;
                                    } else {
                                        phi_4711_ = _e1494;
                                    }
                                    let _e1497 = phi_4711_;
                                    if (_e1483[2] < 0f) {
                                        phi_4718_ = -(_e1483[2]);
                                    } else {
                                        phi_4718_ = _e1483[2];
                                    }
                                    let _e1501 = phi_4718_;
                                    if (_e1497 > _e1501) {
                                        phi_4723_ = _e1497;
                                    } else {
                                        phi_4723_ = _e1501;
                                    }
                                    let _e1504 = phi_4723_;
                                    let _e1506 = local_15.member_2[1u];
                                    if (_e1506[0] < 0f) {
                                        phi_4736_ = -(_e1506[0]);
                                    } else {
                                        phi_4736_ = _e1506[0];
                                    }
                                    let _e1513 = phi_4736_;
                                    if (_e1506[1] < 0f) {
                                        phi_4743_ = -(_e1506[1]);
                                    } else {
                                        phi_4743_ = _e1506[1];
                                    }
                                    let _e1517 = phi_4743_;
                                    if (_e1513 > _e1517) {
                                        phi_4748_ = _e1513;
                                    } else {
                                        phi_4748_ = _e1517;
                                    }
                                    let _e1520 = phi_4748_;
                                    if (_e1506[2] < 0f) {
                                        phi_4755_ = -(_e1506[2]);
                                    } else {
                                        phi_4755_ = _e1506[2];
                                    }
                                    let _e1524 = phi_4755_;
                                    if (_e1520 > _e1524) {
                                        phi_4760_ = _e1520;
                                    } else {
                                        phi_4760_ = _e1524;
                                    }
                                    let _e1527 = phi_4760_;
                                    if (_e1504 > _e1527) {
                                        phi_4765_ = _e1504;
                                    } else {
                                        phi_4765_ = _e1527;
                                    }
                                    let _e1530 = phi_4765_;
                                    let _e1533 = local_15.member_2[0u];
                                    let _e1538 = local_15.member_2[1u];
                                    let _e1548 = (_e1533[0] + ((_e1538[0] - _e1533[0]) * _e1216));
                                    let _e1549 = (_e1533[1] + ((_e1538[1] - _e1533[1]) * _e1216));
                                    let _e1550 = (_e1533[2] + ((_e1538[2] - _e1533[2]) * _e1216));
                                    let _e1552 = local_15.member_2[1u];
                                    let _e1557 = local_15.member_2[0u];
                                    let _e1561 = (_e1552[0] - _e1557[0]);
                                    let _e1562 = (_e1552[1] - _e1557[1]);
                                    let _e1563 = (_e1552[2] - _e1557[2]);
                                    if (_e1561 < 0f) {
                                        phi_4824_ = -(_e1561);
                                    } else {
                                        phi_4824_ = _e1561;
                                    }
                                    let _e1567 = phi_4824_;
                                    if (_e1562 < 0f) {
                                        phi_4830_ = -(_e1562);
                                    } else {
                                        phi_4830_ = _e1562;
                                    }
                                    let _e1571 = phi_4830_;
                                    if (_e1567 > _e1571) {
                                        phi_4835_ = _e1567;
                                    } else {
                                        phi_4835_ = _e1571;
                                    }
                                    let _e1574 = phi_4835_;
                                    if (_e1563 < 0f) {
                                        phi_4841_ = -(_e1563);
                                    } else {
                                        phi_4841_ = _e1563;
                                    }
                                    let _e1578 = phi_4841_;
                                    if (_e1574 > _e1578) {
                                        phi_4846_ = _e1574;
                                    } else {
                                        phi_4846_ = _e1578;
                                    }
                                    let _e1581 = phi_4846_;
                                    let _e1587 = ((((_e1218 * _e1581) * 1.01f) + ((_e1530 + _e1481) * (0.000000059604645f * 8f))) + _e1481);
                                    if (_e1548 < 0f) {
                                        phi_4858_ = -(_e1548);
                                    } else {
                                        phi_4858_ = _e1548;
                                    }
                                    let _e1591 = phi_4858_;
                                    if (_e1549 < 0f) {
                                        phi_4864_ = -(_e1549);
                                    } else {
                                        phi_4864_ = _e1549;
                                    }
                                    let _e1595 = phi_4864_;
                                    if (_e1591 > _e1595) {
                                        phi_4869_ = _e1591;
                                    } else {
                                        phi_4869_ = _e1595;
                                    }
                                    let _e1598 = phi_4869_;
                                    if (_e1550 < 0f) {
                                        phi_4875_ = -(_e1550);
                                    } else {
                                        phi_4875_ = _e1550;
                                    }
                                    let _e1602 = phi_4875_;
                                    if (_e1598 > _e1602) {
                                        phi_4880_ = _e1598;
                                    } else {
                                        phi_4880_ = _e1602;
                                    }
                                    let _e1605 = phi_4880_;
                                    local_5 = type_40(array<f32, 3>(_e1548, _e1549, _e1550), _e1587, (_e1605 + _e1587));
                                    let _e1610 = local_4.member;
                                    let _e1615 = local_5.member;
                                    let _e1621 = ((_e1610[1] * _e1615[2]) - (_e1610[2] * _e1615[1]));
                                    let _e1624 = ((_e1610[2] * _e1615[0]) - (_e1610[0] * _e1615[2]));
                                    let _e1627 = ((_e1610[0] * _e1615[1]) - (_e1610[1] * _e1615[0]));
                                    if (_e1621 < 0f) {
                                        phi_4929_ = -(_e1621);
                                    } else {
                                        phi_4929_ = _e1621;
                                    }
                                    let _e1631 = phi_4929_;
                                    if (_e1624 < 0f) {
                                        phi_4935_ = -(_e1624);
                                    } else {
                                        phi_4935_ = _e1624;
                                    }
                                    let _e1635 = phi_4935_;
                                    if (_e1631 > _e1635) {
                                        if (_e1621 < 0f) {
                                            phi_4945_ = -(_e1621);
                                        } else {
                                            phi_4945_ = _e1621;
                                        }
                                        let _e1653 = phi_4945_;
                                        if (_e1627 < 0f) {
                                            phi_4951_ = -(_e1627);
                                        } else {
                                            phi_4951_ = _e1627;
                                        }
                                        let _e1657 = phi_4951_;
                                        if (_e1653 > _e1657) {
                                            phi_4956_ = 2u;
                                            phi_4957_ = 1u;
                                        } else {
                                            phi_4956_ = 1u;
                                            phi_4957_ = 0u;
                                        }
                                        let _e1660 = phi_4956_;
                                        let _e1662 = phi_4957_;
                                        phi_4976_ = _e1660;
                                        phi_4977_ = _e1662;
                                    } else {
                                        if (_e1624 < 0f) {
                                            phi_4963_ = -(_e1624);
                                        } else {
                                            phi_4963_ = _e1624;
                                        }
                                        let _e1640 = phi_4963_;
                                        if (_e1627 < 0f) {
                                            phi_4969_ = -(_e1627);
                                        } else {
                                            phi_4969_ = _e1627;
                                        }
                                        let _e1644 = phi_4969_;
                                        if (_e1640 > _e1644) {
                                            phi_4974_ = 0u;
                                            phi_4975_ = 2u;
                                        } else {
                                            phi_4974_ = 1u;
                                            phi_4975_ = 0u;
                                        }
                                        let _e1647 = phi_4974_;
                                        let _e1649 = phi_4975_;
                                        phi_4976_ = _e1647;
                                        phi_4977_ = _e1649;
                                    }
                                    let _e1664 = phi_4976_;
                                    let _e1666 = phi_4977_;
                                    if (_e1666 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1670 = local_4.member[_e1666];
                                    if (_e1664 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1674 = local_5.member[_e1664];
                                    if (_e1664 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1679 = local_4.member[_e1664];
                                    if (_e1666 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e1683 = local_5.member[_e1666];
                                    let _e1685 = ((_e1670 * _e1674) - (_e1679 * _e1683));
                                    let _e1687 = local_4.member_1;
                                    let _e1689 = local_5.member_2;
                                    let _e1692 = local_4.member_2;
                                    let _e1694 = local_5.member_1;
                                    let _e1699 = local_4.member_2;
                                    let _e1701 = local_5.member_2;
                                    let _e1708 = local_4.member_2;
                                    let _e1711 = local_5.member_2;
                                    let _e1715 = (((((_e1687 * _e1689) + (_e1692 * _e1694)) * 2.01f) + ((_e1699 * _e1701) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1708) * (1f + _e1711))));
                                    if (_e1685 < 0f) {
                                        phi_5044_ = -(_e1685);
                                    } else {
                                        phi_5044_ = _e1685;
                                    }
                                    let _e1719 = phi_5044_;
                                    if (_e1719 > _e1715) {
                                        if (_e1685 < 0f) {
                                            phi_5053_ = -1f;
                                        } else {
                                            phi_5053_ = 1f;
                                        }
                                        let _e1723 = phi_5053_;
                                        if (_e1666 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1727 = local_3.member[_e1666];
                                        if (_e1664 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1731 = local_5.member[_e1664];
                                        if (_e1664 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1736 = local_3.member[_e1664];
                                        if (_e1666 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1740 = local_5.member[_e1666];
                                        let _e1744 = local_3.member_1;
                                        let _e1746 = local_5.member_2;
                                        let _e1749 = local_3.member_2;
                                        let _e1751 = local_5.member_1;
                                        let _e1756 = local_3.member_2;
                                        let _e1758 = local_5.member_2;
                                        let _e1765 = local_3.member_2;
                                        let _e1768 = local_5.member_2;
                                        let _e1772 = (((((_e1744 * _e1746) + (_e1749 * _e1751)) * 2.01f) + ((_e1756 * _e1758) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1765) * (1f + _e1768))));
                                        if (_e1666 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1776 = local_4.member[_e1666];
                                        if (_e1664 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1780 = local_3.member[_e1664];
                                        if (_e1664 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1785 = local_4.member[_e1664];
                                        if (_e1666 < 3u) {
                                        } else {
                                            return;
                                        }
                                        let _e1789 = local_3.member[_e1666];
                                        let _e1793 = local_4.member_1;
                                        let _e1795 = local_3.member_2;
                                        let _e1798 = local_4.member_2;
                                        let _e1800 = local_3.member_1;
                                        let _e1805 = local_4.member_2;
                                        let _e1807 = local_3.member_2;
                                        let _e1814 = local_4.member_2;
                                        let _e1817 = local_3.member_2;
                                        let _e1821 = (((((_e1793 * _e1795) + (_e1798 * _e1800)) * 2.01f) + ((_e1805 * _e1807) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1814) * (1f + _e1817))));
                                        let _e1822 = (_e1685 * _e1723);
                                        let _e1823 = (((_e1727 * _e1731) - (_e1736 * _e1740)) * _e1723);
                                        let _e1824 = (((_e1776 * _e1780) - (_e1785 * _e1789)) * _e1723);
                                        if (_e1822 < 0f) {
                                            phi_5184_ = -(_e1822);
                                        } else {
                                            phi_5184_ = _e1822;
                                        }
                                        let _e1828 = phi_5184_;
                                        if (_e1823 < 0f) {
                                            phi_5190_ = -(_e1823);
                                        } else {
                                            phi_5190_ = _e1823;
                                        }
                                        let _e1832 = phi_5190_;
                                        if (_e1824 < 0f) {
                                            phi_5197_ = -(_e1824);
                                        } else {
                                            phi_5197_ = _e1824;
                                        }
                                        let _e1837 = phi_5197_;
                                        let _e1842 = ((_e1822 - _e1823) - _e1824);
                                        let _e1845 = (((_e1715 + _e1772) + _e1821) + (((_e1828 + _e1832) + _e1837) * (0.000000059604645f * 4f)));
                                        local_6[0u].member = _e1823;
                                        local_6[0u].member_1 = _e1772;
                                        local_6[1u].member = _e1824;
                                        local_6[1u].member_1 = _e1821;
                                        local_6[2u].member = _e1842;
                                        local_6[2u].member_1 = _e1845;
                                        local_6[3u].member = _e1842;
                                        local_6[3u].member_1 = _e1845;
                                        phi_5240_ = type_28(0u, 4u);
                                        phi_5243_ = true;
                                        loop {
                                            let _e1860 = phi_5240_;
                                            let _e1862 = phi_5243_;
                                            local_20 = _e1862;
                                            if (_e1860.member < _e1860.member_1) {
                                                phi_5241_ = type_28((_e1860.member + 1u), _e1860.member_1);
                                                phi_5266_ = type_28(1u, _e1860.member);
                                            } else {
                                                phi_5241_ = _e1860;
                                                phi_5266_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1876 = phi_5241_;
                                            let _e1878 = phi_5266_;
                                            if (bitcast<i32>(_e1878.member) != 0i) {
                                                if (_e1878.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1886 = local_6[_e1878.member_1].member;
                                                let _e1889 = local_6[_e1878.member_1].member_1;
                                                let _e1891 = (_e1886 < -(_e1889));
                                                if _e1891 {
                                                    phi_5293_ = bool();
                                                    phi_5294_ = false;
                                                } else {
                                                    phi_5293_ = (_e1862 && (_e1886 > _e1889));
                                                    phi_5294_ = true;
                                                }
                                                let _e1895 = phi_5293_;
                                                let _e1897 = phi_5294_;
                                                phi_5244_ = _e1895;
                                                phi_5295_ = _e1897;
                                                phi_5296_ = _e1891;
                                            } else {
                                                phi_5244_ = bool();
                                                phi_5295_ = false;
                                                phi_5296_ = false;
                                            }
                                            let _e1899 = phi_5244_;
                                            let _e1901 = phi_5295_;
                                            let _e1903 = phi_5296_;
                                            local_19 = _e1903;
                                            continue;
                                            continuing {
                                                phi_5240_ = _e1876;
                                                phi_5243_ = _e1899;
                                                break if !(_e1901);
                                            }
                                        }
                                        let _e1906 = local_19;
                                        if _e1906 {
                                            phi_5300_ = false;
                                        } else {
                                            phi_5300_ = true;
                                        }
                                        let _e1908 = phi_5300_;
                                        if _e1908 {
                                            let _e1910 = local_20;
                                            if _e1910 {
                                                phi_5307_ = 1u;
                                            } else {
                                                phi_5307_ = 2u;
                                            }
                                            let _e1912 = phi_5307_;
                                            phi_5308_ = _e1912;
                                            phi_5309_ = false;
                                        } else {
                                            phi_5308_ = u32();
                                            phi_5309_ = true;
                                        }
                                        let _e1914 = phi_5308_;
                                        let _e1916 = phi_5309_;
                                        phi_5310_ = _e1914;
                                        phi_5311_ = 0u;
                                        phi_5312_ = _e1916;
                                    } else {
                                        phi_5310_ = u32();
                                        phi_5311_ = 2u;
                                        phi_5312_ = true;
                                    }
                                    let _e1918 = phi_5310_;
                                    let _e1920 = phi_5311_;
                                    let _e1922 = phi_5312_;
                                    if _e1922 {
                                        phi_5316_ = _e1920;
                                    } else {
                                        phi_5316_ = _e1918;
                                    }
                                    let _e1924 = phi_5316_;
                                    let _e1925 = (_e1924 == 0u);
                                    if _e1925 {
                                        phi_6814_ = f32();
                                        phi_6815_ = false;
                                        phi_6816_ = false;
                                        phi_6817_ = false;
                                    } else {
                                        if (_e1924 == 1u) {
                                            if _e1208.member_2 {
                                                if ((_e1208.member_1 - _e1208.member) <= 0.0000005f) {
                                                    phi_5336_ = false;
                                                } else {
                                                    phi_5336_ = true;
                                                }
                                                let _e1933 = phi_5336_;
                                                phi_5337_ = _e1933;
                                            } else {
                                                phi_5337_ = true;
                                            }
                                            let _e1935 = phi_5337_;
                                            phi_5338_ = _e1935;
                                        } else {
                                            phi_5338_ = true;
                                        }
                                        let _e1937 = phi_5338_;
                                        if _e1937 {
                                            let _e1942 = local_15.member[0u];
                                            let _e1948 = local_15.member_1[0u];
                                            let _e1954 = local_15.member_2[0u];
                                            local_1 = array<array<f32, 3>, 4>(_e1942, array<f32, 3>((_e1942[0] - _e1948[0]), (_e1942[1] - _e1948[1]), (_e1942[2] - _e1948[2])), array<f32, 3>((_e1942[0] - _e1954[0]), (_e1942[1] - _e1954[1]), (_e1942[2] - _e1954[2])), _e1942);
                                            let _e1969 = local_15.member[1u];
                                            let _e1975 = local_15.member_1[1u];
                                            let _e1981 = local_15.member_2[1u];
                                            local_2 = array<array<f32, 3>, 4>(_e1969, array<f32, 3>((_e1969[0] - _e1975[0]), (_e1969[1] - _e1975[1]), (_e1969[2] - _e1975[2])), array<f32, 3>((_e1969[0] - _e1981[0]), (_e1969[1] - _e1981[1]), (_e1969[2] - _e1981[2])), _e1969);
                                            let _e1996 = local_15.member[0u];
                                            if (_e1996[0] < 0f) {
                                                phi_5534_ = -(_e1996[0]);
                                            } else {
                                                phi_5534_ = _e1996[0];
                                            }
                                            let _e2003 = phi_5534_;
                                            if (_e1996[1] < 0f) {
                                                phi_5541_ = -(_e1996[1]);
                                            } else {
                                                phi_5541_ = _e1996[1];
                                            }
                                            let _e2007 = phi_5541_;
                                            if (_e2003 > _e2007) {
                                                phi_5546_ = _e2003;
                                            } else {
                                                phi_5546_ = _e2007;
                                            }
                                            let _e2010 = phi_5546_;
                                            if (_e1996[2] < 0f) {
                                                phi_5553_ = -(_e1996[2]);
                                            } else {
                                                phi_5553_ = _e1996[2];
                                            }
                                            let _e2014 = phi_5553_;
                                            if (_e2010 > _e2014) {
                                                phi_5558_ = _e2010;
                                            } else {
                                                phi_5558_ = _e2014;
                                            }
                                            let _e2017 = phi_5558_;
                                            let _e2020 = local_15.member[1u];
                                            if (_e2020[0] < 0f) {
                                                phi_5571_ = -(_e2020[0]);
                                            } else {
                                                phi_5571_ = _e2020[0];
                                            }
                                            let _e2027 = phi_5571_;
                                            if (_e2020[1] < 0f) {
                                                phi_5578_ = -(_e2020[1]);
                                            } else {
                                                phi_5578_ = _e2020[1];
                                            }
                                            let _e2031 = phi_5578_;
                                            if (_e2027 > _e2031) {
                                                phi_5583_ = _e2027;
                                            } else {
                                                phi_5583_ = _e2031;
                                            }
                                            let _e2034 = phi_5583_;
                                            if (_e2020[2] < 0f) {
                                                phi_5590_ = -(_e2020[2]);
                                            } else {
                                                phi_5590_ = _e2020[2];
                                            }
                                            let _e2038 = phi_5590_;
                                            if (_e2034 > _e2038) {
                                                phi_5595_ = _e2034;
                                            } else {
                                                phi_5595_ = _e2038;
                                            }
                                            let _e2041 = phi_5595_;
                                            if (_e2017 > _e2041) {
                                                phi_5600_ = _e2017;
                                            } else {
                                                phi_5600_ = _e2041;
                                            }
                                            let _e2044 = phi_5600_;
                                            let _e2046 = local_15.member_3;
                                            let _e2050 = local_15.member_1[0u];
                                            if (_e2050[0] < 0f) {
                                                phi_5617_ = -(_e2050[0]);
                                            } else {
                                                phi_5617_ = _e2050[0];
                                            }
                                            let _e2057 = phi_5617_;
                                            if (_e2050[1] < 0f) {
                                                phi_5624_ = -(_e2050[1]);
                                            } else {
                                                phi_5624_ = _e2050[1];
                                            }
                                            let _e2061 = phi_5624_;
                                            if (_e2057 > _e2061) {
                                                phi_5629_ = _e2057;
                                            } else {
                                                phi_5629_ = _e2061;
                                            }
                                            let _e2064 = phi_5629_;
                                            if (_e2050[2] < 0f) {
                                                phi_5636_ = -(_e2050[2]);
                                            } else {
                                                phi_5636_ = _e2050[2];
                                            }
                                            let _e2068 = phi_5636_;
                                            if (_e2064 > _e2068) {
                                                phi_5641_ = _e2064;
                                            } else {
                                                phi_5641_ = _e2068;
                                            }
                                            let _e2071 = phi_5641_;
                                            let _e2074 = local_15.member_1[1u];
                                            if (_e2074[0] < 0f) {
                                                phi_5655_ = -(_e2074[0]);
                                            } else {
                                                phi_5655_ = _e2074[0];
                                            }
                                            let _e2081 = phi_5655_;
                                            if (_e2074[1] < 0f) {
                                                phi_5662_ = -(_e2074[1]);
                                            } else {
                                                phi_5662_ = _e2074[1];
                                            }
                                            let _e2085 = phi_5662_;
                                            if (_e2081 > _e2085) {
                                                phi_5667_ = _e2081;
                                            } else {
                                                phi_5667_ = _e2085;
                                            }
                                            let _e2088 = phi_5667_;
                                            if (_e2074[2] < 0f) {
                                                phi_5674_ = -(_e2074[2]);
                                            } else {
                                                phi_5674_ = _e2074[2];
                                            }
                                            let _e2092 = phi_5674_;
                                            if (_e2088 > _e2092) {
                                                phi_5679_ = _e2088;
                                            } else {
                                                phi_5679_ = _e2092;
                                            }
                                            let _e2095 = phi_5679_;
                                            if (_e2071 > _e2095) {
                                                phi_5684_ = _e2071;
                                            } else {
                                                phi_5684_ = _e2095;
                                            }
                                            let _e2098 = phi_5684_;
                                            let _e2100 = local_15.member_3;
                                            let _e2104 = local_15.member_2[0u];
                                            if (_e2104[0] < 0f) {
                                                phi_5701_ = -(_e2104[0]);
                                            } else {
                                                phi_5701_ = _e2104[0];
                                            }
                                            let _e2111 = phi_5701_;
                                            if (_e2104[1] < 0f) {
                                                phi_5708_ = -(_e2104[1]);
                                            } else {
                                                phi_5708_ = _e2104[1];
                                            }
                                            let _e2115 = phi_5708_;
                                            if (_e2111 > _e2115) {
                                                phi_5713_ = _e2111;
                                            } else {
                                                phi_5713_ = _e2115;
                                            }
                                            let _e2118 = phi_5713_;
                                            if (_e2104[2] < 0f) {
                                                phi_5720_ = -(_e2104[2]);
                                            } else {
                                                phi_5720_ = _e2104[2];
                                            }
                                            let _e2122 = phi_5720_;
                                            if (_e2118 > _e2122) {
                                                phi_5725_ = _e2118;
                                            } else {
                                                phi_5725_ = _e2122;
                                            }
                                            let _e2125 = phi_5725_;
                                            let _e2128 = local_15.member_2[1u];
                                            if (_e2128[0] < 0f) {
                                                phi_5739_ = -(_e2128[0]);
                                            } else {
                                                phi_5739_ = _e2128[0];
                                            }
                                            let _e2135 = phi_5739_;
                                            if (_e2128[1] < 0f) {
                                                phi_5746_ = -(_e2128[1]);
                                            } else {
                                                phi_5746_ = _e2128[1];
                                            }
                                            let _e2139 = phi_5746_;
                                            if (_e2135 > _e2139) {
                                                phi_5751_ = _e2135;
                                            } else {
                                                phi_5751_ = _e2139;
                                            }
                                            let _e2142 = phi_5751_;
                                            if (_e2128[2] < 0f) {
                                                phi_5758_ = -(_e2128[2]);
                                            } else {
                                                phi_5758_ = _e2128[2];
                                            }
                                            let _e2146 = phi_5758_;
                                            if (_e2142 > _e2146) {
                                                phi_5763_ = _e2142;
                                            } else {
                                                phi_5763_ = _e2146;
                                            }
                                            let _e2149 = phi_5763_;
                                            if (_e2125 > _e2149) {
                                                phi_5768_ = _e2125;
                                            } else {
                                                phi_5768_ = _e2149;
                                            }
                                            let _e2152 = phi_5768_;
                                            let _e2154 = local_15.member_3;
                                            let _e2161 = local_15.member_3;
                                            phi_5784_ = type_28(0u, 48u);
                                            phi_5787_ = _e1208.member;
                                            loop {
                                                let _e2167 = phi_5784_;
                                                let _e2169 = phi_5787_;
                                                local_65 = _e2169;
                                                local_27 = _e2169;
                                                local_28 = _e2169;
                                                local_29 = _e2169;
                                                local_30 = _e2169;
                                                if (_e2167.member < _e2167.member_1) {
                                                    phi_5785_ = type_28((_e2167.member + 1u), _e2167.member_1);
                                                    phi_5810_ = type_28(1u, _e2167.member);
                                                } else {
                                                    phi_5785_ = _e2167;
                                                    phi_5810_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e2183 = phi_5785_;
                                                let _e2185 = phi_5810_;
                                                if (bitcast<i32>(_e2185.member) != 0i) {
                                                    let _e2191 = local_15.member[0u];
                                                    let _e2197 = local_15.member[1u];
                                                    let _e2207 = (_e2191[0] + ((_e2197[0] - _e2191[0]) * _e2169));
                                                    let _e2208 = (_e2191[1] + ((_e2197[1] - _e2191[1]) * _e2169));
                                                    let _e2209 = (_e2191[2] + ((_e2197[2] - _e2191[2]) * _e2169));
                                                    let _e2212 = local_15.member_1[0u];
                                                    let _e2218 = local_15.member_1[1u];
                                                    let _e2228 = (_e2212[0] + ((_e2218[0] - _e2212[0]) * _e2169));
                                                    let _e2229 = (_e2212[1] + ((_e2218[1] - _e2212[1]) * _e2169));
                                                    let _e2230 = (_e2212[2] + ((_e2218[2] - _e2212[2]) * _e2169));
                                                    let _e2233 = local_15.member_2[0u];
                                                    let _e2239 = local_15.member_2[1u];
                                                    let _e2249 = (_e2233[0] + ((_e2239[0] - _e2233[0]) * _e2169));
                                                    let _e2250 = (_e2233[1] + ((_e2239[1] - _e2233[1]) * _e2169));
                                                    let _e2251 = (_e2233[2] + ((_e2239[2] - _e2233[2]) * _e2169));
                                                    let _e2256 = (((_e2228 * _e2228) + (_e2229 * _e2229)) + (_e2230 * _e2230));
                                                    let _e2261 = (((_e2228 * _e2249) + (_e2229 * _e2250)) + (_e2230 * _e2251));
                                                    let _e2266 = (((_e2249 * _e2249) + (_e2250 * _e2250)) + (_e2251 * _e2251));
                                                    let _e2271 = (((_e2207 * _e2228) + (_e2208 * _e2229)) + (_e2209 * _e2230));
                                                    let _e2276 = (((_e2207 * _e2249) + (_e2208 * _e2250)) + (_e2209 * _e2251));
                                                    let _e2279 = ((_e2256 * _e2266) - (_e2261 * _e2261));
                                                    let _e2283 = (((_e2271 * _e2266) - (_e2276 * _e2261)) / _e2279);
                                                    let _e2287 = (((_e2276 * _e2256) - (_e2271 * _e2261)) / _e2279);
                                                    if (_e2283 >= 0f) {
                                                        if (_e2287 >= 0f) {
                                                            phi_5984_ = ((_e2283 + _e2287) <= 1f);
                                                            phi_5985_ = false;
                                                        } else {
                                                            phi_5984_ = bool();
                                                            phi_5985_ = true;
                                                        }
                                                        let _e2293 = phi_5984_;
                                                        let _e2295 = phi_5985_;
                                                        phi_5986_ = _e2293;
                                                        phi_5987_ = _e2295;
                                                    } else {
                                                        phi_5986_ = bool();
                                                        phi_5987_ = true;
                                                    }
                                                    let _e2297 = phi_5986_;
                                                    let _e2299 = phi_5987_;
                                                    if _e2299 {
                                                        phi_5991_ = false;
                                                    } else {
                                                        phi_5991_ = _e2297;
                                                    }
                                                    let _e2301 = phi_5991_;
                                                    if (_e2279 > 0f) {
                                                        if _e2301 {
                                                            phi_6013_ = array<f32, 3>((_e2207 - ((_e2228 * _e2283) + (_e2249 * _e2287))), (_e2208 - ((_e2229 * _e2283) + (_e2250 * _e2287))), (_e2209 - ((_e2230 * _e2283) + (_e2251 * _e2287))));
                                                            phi_6014_ = false;
                                                        } else {
                                                            phi_6013_ = array<f32, 3>();
                                                            phi_6014_ = true;
                                                        }
                                                        let _e2317 = phi_6013_;
                                                        let _e2319 = phi_6014_;
                                                        phi_6015_ = _e2317;
                                                        phi_6016_ = _e2319;
                                                    } else {
                                                        phi_6015_ = array<f32, 3>();
                                                        phi_6016_ = true;
                                                    }
                                                    let _e2321 = phi_6015_;
                                                    let _e2323 = phi_6016_;
                                                    if _e2323 {
                                                        let _e2324 = (_e2207 - _e2228);
                                                        let _e2325 = (_e2208 - _e2229);
                                                        let _e2326 = (_e2209 - _e2230);
                                                        let _e2327 = (_e2249 - _e2228);
                                                        let _e2328 = (_e2250 - _e2229);
                                                        let _e2329 = (_e2251 - _e2230);
                                                        let _e2340 = ((((_e2324 * _e2327) + (_e2325 * _e2328)) + (_e2326 * _e2329)) / (((_e2327 * _e2327) + (_e2328 * _e2328)) + (_e2329 * _e2329)));
                                                        if (_e2340 > 0f) {
                                                            if (_e2340 < 1f) {
                                                                phi_6184_ = _e2340;
                                                            } else {
                                                                phi_6184_ = 1f;
                                                            }
                                                            let _e2344 = phi_6184_;
                                                            phi_6185_ = _e2344;
                                                        } else {
                                                            phi_6185_ = 0f;
                                                        }
                                                        let _e2346 = phi_6185_;
                                                        let _e2350 = (_e2324 - (_e2327 * _e2346));
                                                        let _e2351 = (_e2325 - (_e2328 * _e2346));
                                                        let _e2352 = (_e2326 - (_e2329 * _e2346));
                                                        let _e2363 = ((((_e2207 * _e2228) + (_e2208 * _e2229)) + (_e2209 * _e2230)) / (((_e2228 * _e2228) + (_e2229 * _e2229)) + (_e2230 * _e2230)));
                                                        if (_e2363 > 0f) {
                                                            if (_e2363 < 1f) {
                                                                phi_6212_ = _e2363;
                                                            } else {
                                                                phi_6212_ = 1f;
                                                            }
                                                            let _e2367 = phi_6212_;
                                                            phi_6213_ = _e2367;
                                                        } else {
                                                            phi_6213_ = 0f;
                                                        }
                                                        let _e2369 = phi_6213_;
                                                        let _e2386 = ((((_e2207 * _e2249) + (_e2208 * _e2250)) + (_e2209 * _e2251)) / (((_e2249 * _e2249) + (_e2250 * _e2250)) + (_e2251 * _e2251)));
                                                        if (_e2386 > 0f) {
                                                            if (_e2386 < 1f) {
                                                                phi_6240_ = _e2386;
                                                            } else {
                                                                phi_6240_ = 1f;
                                                            }
                                                            let _e2390 = phi_6240_;
                                                            phi_6241_ = _e2390;
                                                        } else {
                                                            phi_6241_ = 0f;
                                                        }
                                                        let _e2392 = phi_6241_;
                                                        local[0u] = array<f32, 3>((_e2207 - (_e2228 * _e2369)), (_e2208 - (_e2229 * _e2369)), (_e2209 - (_e2230 * _e2369)));
                                                        local[1u] = array<f32, 3>((_e2207 - (_e2249 * _e2392)), (_e2208 - (_e2250 * _e2392)), (_e2209 - (_e2251 * _e2392)));
                                                        local[2u] = array<f32, 3>(_e2350, _e2351, _e2352);
                                                        local[3u] = array<f32, 3>(_e2350, _e2351, _e2352);
                                                        let _e2408 = local[0u];
                                                        phi_6277_ = type_28(1u, 4u);
                                                        phi_6280_ = array<f32, 3>(_e2408[0], _e2408[1], _e2408[2]);
                                                        loop {
                                                            let _e2414 = phi_6277_;
                                                            let _e2416 = phi_6280_;
                                                            local_52 = _e2416;
                                                            if (_e2414.member < _e2414.member_1) {
                                                                phi_6278_ = type_28((_e2414.member + 1u), _e2414.member_1);
                                                                phi_6303_ = type_28(1u, _e2414.member);
                                                            } else {
                                                                phi_6278_ = _e2414;
                                                                phi_6303_ = type_28(0u, type_28().member_1);
                                                            }
                                                            let _e2430 = phi_6278_;
                                                            let _e2432 = phi_6303_;
                                                            let _e2436 = (bitcast<i32>(_e2432.member) != 0i);
                                                            if _e2436 {
                                                                if (_e2432.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2439 = local[_e2432.member_1];
                                                                if (_e2432.member_1 < 4u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e2445 = local[_e2432.member_1];
                                                                if ((((_e2439[0] * _e2445[0]) + (_e2439[1] * _e2445[1])) + (_e2439[2] * _e2445[2])) < (((_e2416[0] * _e2416[0]) + (_e2416[1] * _e2416[1])) + (_e2416[2] * _e2416[2]))) {
                                                                    if (_e2432.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2468 = local[_e2432.member_1];
                                                                    phi_6370_ = array<f32, 3>(_e2468[0], _e2468[1], _e2468[2]);
                                                                } else {
                                                                    phi_6370_ = _e2416;
                                                                }
                                                                let _e2474 = phi_6370_;
                                                                phi_6281_ = _e2474;
                                                            } else {
                                                                phi_6281_ = array<f32, 3>();
                                                            }
                                                            let _e2476 = phi_6281_;
                                                            continue;
                                                            continuing {
                                                                phi_6277_ = _e2430;
                                                                phi_6280_ = _e2476;
                                                                break if !(_e2436);
                                                            }
                                                        }
                                                        let _e5030 = local_52;
                                                        phi_6371_ = _e5030;
                                                    } else {
                                                        phi_6371_ = _e2321;
                                                    }
                                                    let _e2479 = phi_6371_;
                                                    if (_e2479[0] < 0f) {
                                                        phi_6378_ = -(_e2479[0]);
                                                    } else {
                                                        phi_6378_ = _e2479[0];
                                                    }
                                                    let _e2484 = phi_6378_;
                                                    if (_e2479[1] < 0f) {
                                                        phi_6385_ = -(_e2479[1]);
                                                    } else {
                                                        phi_6385_ = _e2479[1];
                                                    }
                                                    let _e2489 = phi_6385_;
                                                    if (_e2479[2] < 0f) {
                                                        phi_6393_ = -(_e2479[2]);
                                                    } else {
                                                        phi_6393_ = _e2479[2];
                                                    }
                                                    let _e2495 = phi_6393_;
                                                    let _e2496 = ((_e2484 + _e2489) + _e2495);
                                                    if (_e2496 > 0f) {
                                                        if ((bitcast<u32>(_e2496) & 2139095040u) != 2139095040u) {
                                                            let _e2501 = (1f / _e2496);
                                                            let _e2503 = (_e2479[0] * _e2501);
                                                            let _e2505 = (_e2479[1] * _e2501);
                                                            let _e2507 = (_e2479[2] * _e2501);
                                                            let _e2512 = (((_e2503 * _e2503) + (_e2505 * _e2505)) + (_e2507 * _e2507));
                                                            if (_e2512 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2512 > 0f) {
                                                                    phi_6430_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6430_ = 0f;
                                                                }
                                                                let _e2571 = phi_6430_;
                                                                phi_6494_ = _e2571;
                                                            } else {
                                                                phi_6437_ = type_26(0i, 5i);
                                                                phi_6440_ = bitcast<f32>(((bitcast<u32>(_e2512) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2520 = phi_6437_;
                                                                    let _e2522 = phi_6440_;
                                                                    local_21 = _e2522;
                                                                    if (_e2520.member < _e2520.member_1) {
                                                                        let _e2530 = (_e2520.member + 1i);
                                                                        if ((false == (_e2530 > _e2520.member)) != false) {
                                                                            phi_6461_ = true;
                                                                        } else {
                                                                            phi_6461_ = false;
                                                                        }
                                                                        let _e2535 = phi_6461_;
                                                                        if _e2535 {
                                                                            phi_6467_ = type_27(0u, type_27().member_1);
                                                                        } else {
                                                                            phi_6467_ = type_27(1u, _e2530);
                                                                        }
                                                                        let _e2541 = phi_6467_;
                                                                        if (bitcast<i32>(_e2541.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_6438_ = type_26(_e2541.member_1, _e2520.member_1);
                                                                        phi_6481_ = type_27(1u, _e2520.member);
                                                                    } else {
                                                                        phi_6438_ = _e2520;
                                                                        phi_6481_ = type_27(0u, type_27().member_1);
                                                                    }
                                                                    let _e2551 = phi_6438_;
                                                                    let _e2553 = phi_6481_;
                                                                    let _e2556 = (bitcast<i32>(_e2553.member) != 0i);
                                                                    if _e2556 {
                                                                        phi_6441_ = (0.5f * (_e2522 + (_e2512 / _e2522)));
                                                                    } else {
                                                                        phi_6441_ = f32();
                                                                    }
                                                                    let _e2561 = phi_6441_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6437_ = _e2551;
                                                                        phi_6440_ = _e2561;
                                                                        break if !(_e2556);
                                                                    }
                                                                }
                                                                let _e2566 = local_21;
                                                                phi_6494_ = (_e2566 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2573 = phi_6494_;
                                                            phi_6503_ = type_28(0u, 4u);
                                                            phi_6506_ = 2f;
                                                            loop {
                                                                let _e2581 = phi_6503_;
                                                                let _e2583 = phi_6506_;
                                                                local_23 = _e2583;
                                                                local_24 = _e2583;
                                                                local_25 = _e2583;
                                                                local_55 = _e2583;
                                                                local_56 = _e2583;
                                                                if (_e2581.member < _e2581.member_1) {
                                                                    phi_6504_ = type_28((_e2581.member + 1u), _e2581.member_1);
                                                                    phi_6529_ = type_28(1u, _e2581.member);
                                                                } else {
                                                                    phi_6504_ = _e2581;
                                                                    phi_6529_ = type_28(0u, type_28().member_1);
                                                                }
                                                                let _e2597 = phi_6504_;
                                                                let _e2599 = phi_6529_;
                                                                if (bitcast<i32>(_e2599.member) != 0i) {
                                                                    if (_e2599.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2606 = local_1[_e2599.member_1];
                                                                    let _e2614 = (((_e2503 * _e2606[0]) + (_e2505 * _e2606[1])) + (_e2507 * _e2606[2]));
                                                                    if (_e2599.member_1 < 4u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2617 = local_2[_e2599.member_1];
                                                                    let _e2625 = (((_e2503 * _e2617[0]) + (_e2505 * _e2617[1])) + (_e2507 * _e2617[2]));
                                                                    if (_e2614 < 0f) {
                                                                        phi_6580_ = -(_e2614);
                                                                    } else {
                                                                        phi_6580_ = _e2614;
                                                                    }
                                                                    let _e2629 = phi_6580_;
                                                                    if (_e2625 < 0f) {
                                                                        phi_6586_ = -(_e2625);
                                                                    } else {
                                                                        phi_6586_ = _e2625;
                                                                    }
                                                                    let _e2633 = phi_6586_;
                                                                    let _e2637 = (((((((((_e2044 + _e2046) + (_e2098 + _e2100)) + (_e2152 + _e2154)) * (0.000000059604645f * 16f)) + (_e2161 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2573) * (1f + (0.000000059604645f * 8f)))) + ((_e2629 + _e2633) * (0.000000059604645f * 8f)));
                                                                    if (_e2614 > _e2637) {
                                                                        if (_e2625 > _e2637) {
                                                                            phi_6599_ = false;
                                                                        } else {
                                                                            phi_6599_ = true;
                                                                        }
                                                                        let _e2641 = phi_6599_;
                                                                        phi_6600_ = _e2641;
                                                                    } else {
                                                                        phi_6600_ = true;
                                                                    }
                                                                    let _e2643 = phi_6600_;
                                                                    if _e2643 {
                                                                        if ((_e2614 + ((_e2625 - _e2614) * _e2169)) > _e2637) {
                                                                            if (_e2625 < _e2614) {
                                                                                let _e2651 = ((_e2614 - _e2625) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                                                if _e2651 {
                                                                                    let _e2657 = (((_e2614 - _e2637) / (_e2614 - _e2625)) * (1f - (0.000000059604645f * 16f)));
                                                                                    if (_e2583 < _e2657) {
                                                                                        phi_6631_ = _e2583;
                                                                                    } else {
                                                                                        phi_6631_ = _e2657;
                                                                                    }
                                                                                    let _e2660 = phi_6631_;
                                                                                    phi_6632_ = _e2660;
                                                                                } else {
                                                                                    phi_6632_ = f32();
                                                                                }
                                                                                let _e2662 = phi_6632_;
                                                                                phi_6633_ = _e2662;
                                                                                phi_6634_ = _e2651;
                                                                            } else {
                                                                                phi_6633_ = _e2583;
                                                                                phi_6634_ = true;
                                                                            }
                                                                            let _e2664 = phi_6633_;
                                                                            let _e2666 = phi_6634_;
                                                                            if _e2666 {
                                                                                phi_6638_ = false;
                                                                            } else {
                                                                                phi_6638_ = true;
                                                                            }
                                                                            let _e2668 = phi_6638_;
                                                                            phi_6639_ = _e2664;
                                                                            phi_6640_ = _e2666;
                                                                            phi_6641_ = _e2668;
                                                                            phi_6642_ = false;
                                                                        } else {
                                                                            phi_6639_ = f32();
                                                                            phi_6640_ = false;
                                                                            phi_6641_ = false;
                                                                            phi_6642_ = true;
                                                                        }
                                                                        let _e2670 = phi_6639_;
                                                                        let _e2672 = phi_6640_;
                                                                        let _e2674 = phi_6641_;
                                                                        let _e2676 = phi_6642_;
                                                                        phi_6643_ = _e2670;
                                                                        phi_6644_ = _e2672;
                                                                        phi_6645_ = _e2674;
                                                                        phi_6646_ = _e2676;
                                                                    } else {
                                                                        phi_6643_ = _e2583;
                                                                        phi_6644_ = true;
                                                                        phi_6645_ = false;
                                                                        phi_6646_ = false;
                                                                    }
                                                                    let _e2678 = phi_6643_;
                                                                    let _e2680 = phi_6644_;
                                                                    let _e2682 = phi_6645_;
                                                                    let _e2684 = phi_6646_;
                                                                    phi_6507_ = _e2678;
                                                                    phi_6647_ = _e2680;
                                                                    phi_6648_ = false;
                                                                    phi_6649_ = _e2682;
                                                                    phi_6650_ = _e2684;
                                                                } else {
                                                                    phi_6507_ = f32();
                                                                    phi_6647_ = false;
                                                                    phi_6648_ = true;
                                                                    phi_6649_ = false;
                                                                    phi_6650_ = false;
                                                                }
                                                                let _e2686 = phi_6507_;
                                                                let _e2688 = phi_6647_;
                                                                let _e2690 = phi_6648_;
                                                                let _e2692 = phi_6649_;
                                                                let _e2694 = phi_6650_;
                                                                local_22 = _e2690;
                                                                local_53 = _e2692;
                                                                local_54 = _e2694;
                                                                continue;
                                                                continuing {
                                                                    phi_6503_ = _e2597;
                                                                    phi_6506_ = _e2686;
                                                                    break if !(_e2688);
                                                                }
                                                            }
                                                            let _e2697 = local_22;
                                                            if _e2697 {
                                                                let _e2699 = local_23;
                                                                let _e2700 = (_e2699 > _e1208.member_1);
                                                                if _e2700 {
                                                                    phi_6671_ = false;
                                                                    phi_6672_ = false;
                                                                    phi_6673_ = false;
                                                                } else {
                                                                    let _e2702 = local_24;
                                                                    if (_e2702 > _e2169) {
                                                                        let _e2705 = local_25;
                                                                        let _e2707 = ((_e2705 - _e2169) < 0.00000000023283064f);
                                                                        if _e2707 {
                                                                            phi_6667_ = false;
                                                                        } else {
                                                                            phi_6667_ = true;
                                                                        }
                                                                        let _e2709 = phi_6667_;
                                                                        phi_6668_ = _e2709;
                                                                        phi_6669_ = _e2707;
                                                                        phi_6670_ = false;
                                                                    } else {
                                                                        phi_6668_ = false;
                                                                        phi_6669_ = false;
                                                                        phi_6670_ = true;
                                                                    }
                                                                    let _e2711 = phi_6668_;
                                                                    let _e2713 = phi_6669_;
                                                                    let _e2715 = phi_6670_;
                                                                    phi_6671_ = _e2711;
                                                                    phi_6672_ = _e2713;
                                                                    phi_6673_ = _e2715;
                                                                }
                                                                let _e2717 = phi_6671_;
                                                                let _e2719 = phi_6672_;
                                                                let _e2721 = phi_6673_;
                                                                phi_6674_ = _e2717;
                                                                phi_6675_ = _e2700;
                                                                phi_6676_ = _e2719;
                                                                phi_6677_ = _e2721;
                                                                phi_6678_ = false;
                                                                phi_6679_ = false;
                                                            } else {
                                                                phi_6674_ = false;
                                                                phi_6675_ = false;
                                                                phi_6676_ = false;
                                                                phi_6677_ = false;
                                                                let _e5087 = local_53;
                                                                phi_6678_ = _e5087;
                                                                let _e5090 = local_54;
                                                                phi_6679_ = _e5090;
                                                            }
                                                            let _e2723 = phi_6674_;
                                                            let _e2725 = phi_6675_;
                                                            let _e2727 = phi_6676_;
                                                            let _e2729 = phi_6677_;
                                                            let _e2731 = phi_6678_;
                                                            let _e2733 = phi_6679_;
                                                            let _e5093 = local_55;
                                                            phi_6680_ = _e5093;
                                                            let _e5096 = local_56;
                                                            phi_6681_ = _e5096;
                                                            phi_6682_ = _e2723;
                                                            phi_6683_ = _e2725;
                                                            phi_6684_ = _e2727;
                                                            phi_6685_ = _e2729;
                                                            phi_6686_ = _e2731;
                                                            phi_6687_ = _e2733;
                                                            phi_6688_ = false;
                                                        } else {
                                                            phi_6680_ = f32();
                                                            phi_6681_ = f32();
                                                            phi_6682_ = false;
                                                            phi_6683_ = false;
                                                            phi_6684_ = false;
                                                            phi_6685_ = false;
                                                            phi_6686_ = false;
                                                            phi_6687_ = false;
                                                            phi_6688_ = true;
                                                        }
                                                        let _e2735 = phi_6680_;
                                                        let _e2737 = phi_6681_;
                                                        let _e2739 = phi_6682_;
                                                        let _e2741 = phi_6683_;
                                                        let _e2743 = phi_6684_;
                                                        let _e2745 = phi_6685_;
                                                        let _e2747 = phi_6686_;
                                                        let _e2749 = phi_6687_;
                                                        let _e2751 = phi_6688_;
                                                        phi_6689_ = _e2735;
                                                        phi_6690_ = _e2737;
                                                        phi_6691_ = _e2739;
                                                        phi_6692_ = _e2741;
                                                        phi_6693_ = _e2743;
                                                        phi_6694_ = _e2745;
                                                        phi_6695_ = _e2747;
                                                        phi_6696_ = _e2749;
                                                        phi_6697_ = _e2751;
                                                        phi_6698_ = false;
                                                    } else {
                                                        phi_6689_ = f32();
                                                        phi_6690_ = f32();
                                                        phi_6691_ = false;
                                                        phi_6692_ = false;
                                                        phi_6693_ = false;
                                                        phi_6694_ = false;
                                                        phi_6695_ = false;
                                                        phi_6696_ = false;
                                                        phi_6697_ = false;
                                                        phi_6698_ = true;
                                                    }
                                                    let _e2753 = phi_6689_;
                                                    let _e2755 = phi_6690_;
                                                    let _e2757 = phi_6691_;
                                                    let _e2759 = phi_6692_;
                                                    let _e2761 = phi_6693_;
                                                    let _e2763 = phi_6694_;
                                                    let _e2765 = phi_6695_;
                                                    let _e2767 = phi_6696_;
                                                    let _e2769 = phi_6697_;
                                                    let _e2771 = phi_6698_;
                                                    phi_6699_ = _e2753;
                                                    phi_5788_ = _e2755;
                                                    phi_6700_ = _e2757;
                                                    phi_6701_ = _e2759;
                                                    phi_6702_ = _e2761;
                                                    phi_6703_ = false;
                                                    phi_6704_ = _e2763;
                                                    phi_6705_ = _e2765;
                                                    phi_6706_ = _e2767;
                                                    phi_6707_ = _e2769;
                                                    phi_6708_ = _e2771;
                                                } else {
                                                    phi_6699_ = f32();
                                                    phi_5788_ = f32();
                                                    phi_6700_ = false;
                                                    phi_6701_ = false;
                                                    phi_6702_ = false;
                                                    phi_6703_ = true;
                                                    phi_6704_ = false;
                                                    phi_6705_ = false;
                                                    phi_6706_ = false;
                                                    phi_6707_ = false;
                                                    phi_6708_ = false;
                                                }
                                                let _e2773 = phi_6699_;
                                                let _e2775 = phi_5788_;
                                                let _e2777 = phi_6700_;
                                                let _e2779 = phi_6701_;
                                                let _e2781 = phi_6702_;
                                                let _e2783 = phi_6703_;
                                                let _e2785 = phi_6704_;
                                                let _e2787 = phi_6705_;
                                                let _e2789 = phi_6706_;
                                                let _e2791 = phi_6707_;
                                                let _e2793 = phi_6708_;
                                                local_26 = _e2779;
                                                local_57 = _e2781;
                                                local_58 = _e2783;
                                                local_59 = _e2785;
                                                local_60 = _e2787;
                                                local_61 = _e2789;
                                                local_62 = _e2791;
                                                local_63 = _e2793;
                                                local_64 = _e2773;
                                                local_66 = _e2779;
                                                continue;
                                                continuing {
                                                    phi_5784_ = _e2183;
                                                    phi_5787_ = _e2775;
                                                    break if !(_e2777);
                                                }
                                            }
                                            let _e2796 = local_26;
                                            if _e2796 {
                                                phi_6713_ = type_55(0u, type_55().member_1);
                                                phi_6714_ = false;
                                                phi_6715_ = false;
                                                phi_6716_ = false;
                                                phi_6717_ = false;
                                                phi_6718_ = false;
                                                phi_6719_ = false;
                                                phi_6720_ = false;
                                            } else {
                                                phi_6713_ = type_55();
                                                let _e5129 = local_57;
                                                phi_6714_ = _e5129;
                                                let _e5132 = local_58;
                                                phi_6715_ = _e5132;
                                                let _e5135 = local_59;
                                                phi_6716_ = _e5135;
                                                let _e5138 = local_60;
                                                phi_6717_ = _e5138;
                                                let _e5141 = local_61;
                                                phi_6718_ = _e5141;
                                                let _e5144 = local_62;
                                                phi_6719_ = _e5144;
                                                let _e5147 = local_63;
                                                phi_6720_ = _e5147;
                                            }
                                            let _e2801 = phi_6713_;
                                            let _e2803 = phi_6714_;
                                            let _e2805 = phi_6715_;
                                            let _e2807 = phi_6716_;
                                            let _e2809 = phi_6717_;
                                            let _e2811 = phi_6718_;
                                            let _e2813 = phi_6719_;
                                            let _e2815 = phi_6720_;
                                            if _e2803 {
                                                let _e5150 = local_64;
                                                phi_6724_ = _e5150;
                                                phi_6725_ = true;
                                                phi_6726_ = false;
                                                phi_6727_ = false;
                                                phi_6728_ = false;
                                                phi_6729_ = false;
                                                phi_6730_ = false;
                                                phi_6731_ = false;
                                            } else {
                                                let _e5152 = local_65;
                                                phi_6724_ = _e5152;
                                                phi_6725_ = _e2805;
                                                phi_6726_ = _e2807;
                                                phi_6727_ = _e2809;
                                                phi_6728_ = _e2811;
                                                let _e5159 = local_66;
                                                phi_6729_ = _e5159;
                                                phi_6730_ = _e2813;
                                                phi_6731_ = _e2815;
                                            }
                                            let _e2817 = phi_6724_;
                                            let _e2819 = phi_6725_;
                                            let _e2821 = phi_6726_;
                                            let _e2823 = phi_6727_;
                                            let _e2825 = phi_6728_;
                                            let _e2827 = phi_6729_;
                                            let _e2829 = phi_6730_;
                                            let _e2831 = phi_6731_;
                                            if _e2819 {
                                                phi_6736_ = type_55(1u, _e2817);
                                                phi_6737_ = false;
                                                phi_6738_ = false;
                                                phi_6739_ = false;
                                                phi_6740_ = false;
                                                phi_6741_ = false;
                                                phi_6742_ = false;
                                            } else {
                                                phi_6736_ = type_55();
                                                phi_6737_ = _e2821;
                                                phi_6738_ = _e2823;
                                                phi_6739_ = _e2825;
                                                phi_6740_ = _e2827;
                                                phi_6741_ = _e2829;
                                                phi_6742_ = _e2831;
                                            }
                                            let _e2834 = phi_6736_;
                                            let _e2836 = phi_6737_;
                                            let _e2838 = phi_6738_;
                                            let _e2840 = phi_6739_;
                                            let _e2842 = phi_6740_;
                                            let _e2844 = phi_6741_;
                                            let _e2846 = phi_6742_;
                                            if _e2836 {
                                                let _e2848 = local_27;
                                                phi_6747_ = type_55(1u, _e2848);
                                                phi_6748_ = false;
                                                phi_6749_ = false;
                                                phi_6750_ = true;
                                                phi_6751_ = false;
                                                phi_6752_ = false;
                                            } else {
                                                phi_6747_ = _e2801;
                                                phi_6748_ = _e2838;
                                                phi_6749_ = _e2840;
                                                phi_6750_ = _e2842;
                                                phi_6751_ = _e2844;
                                                phi_6752_ = _e2846;
                                            }
                                            let _e2851 = phi_6747_;
                                            let _e2853 = phi_6748_;
                                            let _e2855 = phi_6749_;
                                            let _e2857 = phi_6750_;
                                            let _e2859 = phi_6751_;
                                            let _e2861 = phi_6752_;
                                            if _e2853 {
                                                let _e2863 = local_28;
                                                phi_6757_ = type_55(1u, _e2863);
                                                phi_6758_ = false;
                                                phi_6759_ = false;
                                                phi_6760_ = false;
                                                phi_6761_ = false;
                                            } else {
                                                phi_6757_ = type_55();
                                                phi_6758_ = _e2855;
                                                phi_6759_ = _e2857;
                                                phi_6760_ = _e2859;
                                                phi_6761_ = _e2861;
                                            }
                                            let _e2866 = phi_6757_;
                                            let _e2868 = phi_6758_;
                                            let _e2870 = phi_6759_;
                                            let _e2872 = phi_6760_;
                                            let _e2874 = phi_6761_;
                                            if _e2868 {
                                                let _e2876 = local_29;
                                                phi_6766_ = type_55(1u, _e2876);
                                                phi_6767_ = true;
                                                phi_6768_ = false;
                                                phi_6769_ = false;
                                                phi_6770_ = false;
                                            } else {
                                                phi_6766_ = _e2866;
                                                phi_6767_ = _e2853;
                                                phi_6768_ = _e2870;
                                                phi_6769_ = _e2872;
                                                phi_6770_ = _e2874;
                                            }
                                            let _e2879 = phi_6766_;
                                            let _e2881 = phi_6767_;
                                            let _e2883 = phi_6768_;
                                            let _e2885 = phi_6769_;
                                            let _e2887 = phi_6770_;
                                            if _e2881 {
                                                phi_6774_ = _e2879;
                                                phi_6775_ = true;
                                                phi_6776_ = false;
                                                phi_6777_ = false;
                                            } else {
                                                phi_6774_ = _e2851;
                                                phi_6775_ = _e2883;
                                                phi_6776_ = _e2885;
                                                phi_6777_ = _e2887;
                                            }
                                            let _e2889 = phi_6774_;
                                            let _e2891 = phi_6775_;
                                            let _e2893 = phi_6776_;
                                            let _e2895 = phi_6777_;
                                            if _e2891 {
                                                phi_6781_ = false;
                                                phi_6782_ = false;
                                            } else {
                                                phi_6781_ = _e2893;
                                                phi_6782_ = _e2895;
                                            }
                                            let _e2897 = phi_6781_;
                                            let _e2899 = phi_6782_;
                                            if _e2897 {
                                                phi_6786_ = false;
                                                phi_6787_ = false;
                                            } else {
                                                phi_6786_ = _e2899;
                                                phi_6787_ = _e2891;
                                            }
                                            let _e2901 = phi_6786_;
                                            let _e2903 = phi_6787_;
                                            if _e2901 {
                                                phi_6791_ = true;
                                                phi_6792_ = false;
                                            } else {
                                                phi_6791_ = _e2897;
                                                phi_6792_ = _e2903;
                                            }
                                            let _e2905 = phi_6791_;
                                            let _e2907 = phi_6792_;
                                            if _e2905 {
                                                let _e2909 = local_30;
                                                phi_6797_ = type_55(1u, _e2909);
                                                phi_6798_ = true;
                                            } else {
                                                phi_6797_ = _e2889;
                                                phi_6798_ = _e2907;
                                            }
                                            let _e2912 = phi_6797_;
                                            let _e2914 = phi_6798_;
                                            if _e2914 {
                                                phi_6802_ = _e2912;
                                            } else {
                                                phi_6802_ = _e2834;
                                            }
                                            let _e2916 = phi_6802_;
                                            let _e2919 = (_e2916.member != 0u);
                                            if _e2919 {
                                                phi_6809_ = false;
                                            } else {
                                                phi_6809_ = true;
                                            }
                                            let _e2921 = phi_6809_;
                                            phi_6810_ = _e2916.member_1;
                                            phi_6811_ = _e2921;
                                            phi_6812_ = _e2919;
                                            phi_6813_ = false;
                                        } else {
                                            phi_6810_ = f32();
                                            phi_6811_ = false;
                                            phi_6812_ = false;
                                            phi_6813_ = true;
                                        }
                                        let _e2923 = phi_6810_;
                                        let _e2925 = phi_6811_;
                                        let _e2927 = phi_6812_;
                                        let _e2929 = phi_6813_;
                                        phi_6814_ = _e2923;
                                        phi_6815_ = _e2925;
                                        phi_6816_ = _e2927;
                                        phi_6817_ = _e2929;
                                    }
                                    let _e2931 = phi_6814_;
                                    let _e2933 = phi_6815_;
                                    let _e2935 = phi_6816_;
                                    let _e2937 = phi_6817_;
                                    phi_6818_ = _e2931;
                                    phi_6819_ = _e1925;
                                    phi_6820_ = _e2933;
                                    phi_6821_ = _e2935;
                                    phi_6822_ = _e2937;
                                }
                                let _e2939 = phi_6818_;
                                let _e2941 = phi_6819_;
                                let _e2943 = phi_6820_;
                                let _e2945 = phi_6821_;
                                let _e2947 = phi_6822_;
                                if _e2941 {
                                    phi_6826_ = true;
                                    phi_6827_ = false;
                                    phi_6828_ = false;
                                } else {
                                    phi_6826_ = _e2943;
                                    phi_6827_ = _e2945;
                                    phi_6828_ = _e2947;
                                }
                                let _e2949 = phi_6826_;
                                let _e2951 = phi_6827_;
                                let _e2953 = phi_6828_;
                                phi_6829_ = _e2939;
                                phi_6830_ = _e1208;
                                phi_6831_ = _e2949;
                                phi_6832_ = false;
                                phi_6833_ = _e2951;
                                phi_6834_ = _e2953;
                            } else {
                                phi_6829_ = f32();
                                phi_6830_ = type_56();
                                phi_6831_ = false;
                                phi_6832_ = true;
                                phi_6833_ = false;
                                phi_6834_ = false;
                            }
                            let _e2955 = phi_6829_;
                            let _e2957 = phi_6830_;
                            let _e2959 = phi_6831_;
                            let _e2961 = phi_6832_;
                            let _e2963 = phi_6833_;
                            let _e2965 = phi_6834_;
                            local_31 = _e2961;
                            local_67 = _e2963;
                            local_68 = _e2965;
                            local_32 = _e2955;
                            local_33 = _e2957;
                            continue;
                            continuing {
                                phi_3871_ = _e907;
                                break if !(_e2959);
                            }
                        }
                        let _e2968 = local_31;
                        if _e2968 {
                            phi_6839_ = type_55(0u, type_55().member_1);
                            phi_6840_ = false;
                            phi_6841_ = false;
                        } else {
                            phi_6839_ = type_55();
                            let _e5229 = local_67;
                            phi_6840_ = _e5229;
                            let _e5232 = local_68;
                            phi_6841_ = _e5232;
                        }
                        let _e2973 = phi_6839_;
                        let _e2975 = phi_6840_;
                        let _e2977 = phi_6841_;
                        if _e2975 {
                            let _e2979 = local_32;
                            phi_6846_ = type_55(2u, _e2979);
                            phi_6847_ = false;
                        } else {
                            phi_6846_ = type_55();
                            phi_6847_ = _e2977;
                        }
                        let _e2982 = phi_6846_;
                        let _e2984 = phi_6847_;
                        if _e2984 {
                            let _e2986 = local_33;
                            phi_6853_ = type_55(1u, _e2986.member);
                            phi_6854_ = true;
                        } else {
                            phi_6853_ = _e2982;
                            phi_6854_ = _e2975;
                        }
                        let _e2990 = phi_6853_;
                        let _e2992 = phi_6854_;
                        if _e2992 {
                            phi_6858_ = _e2990;
                        } else {
                            phi_6858_ = _e2973;
                        }
                        let _e2994 = phi_6858_;
                        phi_6862_ = _e2994;
                    }
                    let _e4581 = phi_6862_;
                    phi_6863_ = _e4581;
                }
                let _e4586 = phi_6863_;
                switch bitcast<i32>(_e4586.member) {
                    case 0: {
                        phi_6876_ = type_58(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4592 = function_(_e4586.member_1);
                        phi_6876_ = type_58(0u, _e4592, true);
                        break;
                    }
                    case 2: {
                        let _e4590 = function_(_e4586.member_1);
                        phi_6876_ = type_58(1u, _e4590, true);
                        break;
                    }
                    default: {
                        phi_6876_ = type_58();
                        break;
                    }
                }
                let _e4595 = phi_6876_;
                if _e4595.member_2 {
                    phi_6883_ = (_e4595.member == 0u);
                } else {
                    phi_6883_ = false;
                }
                let _e4600 = phi_6883_;
                if _e4600 {
                    let _e4608 = (_e4595.member_1[1] >> bitcast<u32>(20i));
                    if (_e4608 <= 896u) {
                        phi_6907_ = 0u;
                    } else {
                        phi_6907_ = ((((_e4608 - 896u) << bitcast<u32>(23i)) | ((_e4595.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4595.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4623 = phi_6907_;
                    let _e4625 = atomicMin((&earliest.member[0u]), _e4623);
                }
                phi_6911_ = type_48(_e177, 0u, _e183, _e186, _e4595.member_1);
                phi_6912_ = _e4600;
                phi_6913_ = (_e4595.member != 0u);
            } else {
                phi_6911_ = type_48(_e177, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_6912_ = false;
                phi_6913_ = false;
            }
            let _e4627 = phi_6911_;
            let _e4629 = phi_6912_;
            let _e4631 = phi_6913_;
            let _e4633 = params.member.member_1;
            if ((_e4633 & 16u) != 0u) {
                if (_e108 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4629 {
                    let _e4639 = atomicAdd((&counters[0u]), 1u);
                    phi_6931_ = _e4639;
                } else {
                    phi_6931_ = 0u;
                }
                let _e4641 = phi_6931_;
                workgroupBarrier();
                if (_e108 == 0u) {
                    let _e4644 = atomicLoad((&counters[0u]));
                    if (_e4644 > 0u) {
                        let _e4647 = atomicAdd((&contacts.member[0u]), _e4644);
                        atomicStore((&counters[1u]), _e4647);
                    }
                }
                workgroupBarrier();
                let _e4650 = atomicLoad((&counters[1u]));
                let _e4651 = (_e4650 + _e4641);
                if _e4629 {
                    let _e4653 = params.member.member_16;
                    if (_e4651 < _e4653) {
                        let _e4655 = (6u * _e4651);
                        atomicStore((&contacts.member[(4u + _e4655)]), _e4627.member);
                        atomicStore((&contacts.member[(_e4655 + 5u)]), _e4627.member_1);
                        atomicStore((&contacts.member[(_e4655 + 6u)]), _e4627.member_2);
                        atomicStore((&contacts.member[(_e4655 + 7u)]), _e4627.member_3);
                        atomicStore((&contacts.member[(_e4655 + 8u)]), _e4627.member_4[0]);
                        atomicStore((&contacts.member[(_e4655 + 9u)]), _e4627.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e108 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4631 {
                let _e4679 = atomicAdd((&counters[0u]), 1u);
                phi_6993_ = _e4679;
            } else {
                phi_6993_ = 0u;
            }
            let _e4681 = phi_6993_;
            workgroupBarrier();
            if (_e108 == 0u) {
                let _e4684 = atomicLoad((&counters[0u]));
                if (_e4684 > 0u) {
                    let _e4687 = atomicAdd((&undecided.member[0u]), _e4684);
                    atomicStore((&counters[1u]), _e4687);
                }
            }
            workgroupBarrier();
            let _e4690 = atomicLoad((&counters[1u]));
            let _e4691 = (_e4690 + _e4681);
            if _e4631 {
                atomicStore((&undecided.member[(4u + (2u * _e4691))]), _e4627.member_2);
                atomicStore((&undecided.member[((2u * _e4691) + 5u)]), _e4627.member_3);
            }
        }
        continue;
        continuing {
            phi_273_ = _e165;
            break if !(_e171);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_1();
}
