struct type_11 {
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
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_13 {
    member: type_11,
}

struct type_17 {
    member: array<u32>,
}

struct type_21 {
    member: array<array<u32, 2>>,
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

struct type_34 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_37 {
    member: array<type_34>,
}

struct type_42 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

struct type_47 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_50 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_51 {
    member: f32,
    member_1: f32,
}

struct type_56 {
    member: u32,
    member_1: f32,
}

struct type_57 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_59 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_63 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_13;
@group(0) @binding(1) 
var<storage> paths: type_37;
@group(0) @binding(2) 
var<storage> elements: type_21;
@group(0) @binding(3) 
var<storage> input: type_17;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_63;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_63;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_63;
var<workgroup> counters: array<atomic<u32>, 4>;

fn function_(param: f32) -> array<u32, 2> {
    var phi_7030_: array<u32, 2>;
    var phi_7031_: array<u32, 2>;
    var phi_7032_: bool;
    var phi_7036_: array<u32, 2>;

    let _e91 = bitcast<u32>(param);
    if (_e91 < 8388608u) {
        phi_7031_ = array<u32, 2>();
        phi_7032_ = true;
    } else {
        let _e95 = ((_e91 >> bitcast<u32>(31i)) == 1u);
        if _e95 {
            phi_7030_ = array<u32, 2>();
        } else {
            phi_7030_ = array<u32, 2>((_e91 << bitcast<u32>(29i)), ((((_e91 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e91 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e109 = phi_7030_;
        phi_7031_ = _e109;
        phi_7032_ = _e95;
    }
    let _e111 = phi_7031_;
    let _e113 = phi_7032_;
    if _e113 {
        phi_7036_ = array<u32, 2>(0u, 0u);
    } else {
        phi_7036_ = _e111;
    }
    let _e115 = phi_7036_;
    return _e115;
}

fn function_1() {
    var local: array<array<f32, 3>, 4>;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: array<array<f32, 3>, 4>;
    var local_3: type_42;
    var local_4: type_42;
    var local_5: type_42;
    var local_6: array<type_51, 4>;
    var local_7: array<f32, 4>;
    var local_8: array<f32, 2>;
    var local_9: array<f32, 4>;
    var local_10: array<array<f32, 3>, 4>;
    var local_11: array<array<f32, 3>, 4>;
    var local_12: array<array<f32, 3>, 4>;
    var local_13: array<array<f32, 3>, 4>;
    var local_14: array<f32, 3>;
    var local_15: type_47;
    var phi_206_: u32;
    var phi_222_: u32;
    var phi_243_: u32;
    var phi_244_: u32;
    var phi_247_: type_29;
    var phi_248_: type_29;
    var phi_271_: type_29;
    var phi_721_: f32;
    var phi_728_: f32;
    var phi_733_: f32;
    var phi_740_: f32;
    var phi_745_: f32;
    var phi_758_: f32;
    var phi_765_: f32;
    var phi_770_: f32;
    var phi_777_: f32;
    var phi_782_: f32;
    var phi_787_: f32;
    var phi_804_: f32;
    var phi_811_: f32;
    var phi_816_: f32;
    var phi_823_: f32;
    var phi_828_: f32;
    var phi_842_: f32;
    var phi_849_: f32;
    var phi_854_: f32;
    var phi_861_: f32;
    var phi_866_: f32;
    var phi_871_: f32;
    var phi_888_: f32;
    var phi_895_: f32;
    var phi_900_: f32;
    var phi_907_: f32;
    var phi_912_: f32;
    var phi_926_: f32;
    var phi_933_: f32;
    var phi_938_: f32;
    var phi_945_: f32;
    var phi_950_: f32;
    var phi_955_: f32;
    var phi_986_: f32;
    var phi_992_: f32;
    var phi_999_: f32;
    var phi_1006_: f32;
    var phi_1012_: f32;
    var phi_1019_: f32;
    var phi_1025_: f32;
    var phi_1031_: f32;
    var phi_1037_: f32;
    var phi_1044_: f32;
    var phi_1051_: f32;
    var phi_1075_: f32;
    var phi_1080_: f32;
    var phi_1085_: f32;
    var phi_1090_: f32;
    var phi_1095_: f32;
    var phi_1100_: f32;
    var phi_1110_: f32;
    var phi_3583_: f32;
    var phi_3589_: f32;
    var phi_3594_: f32;
    var phi_3600_: f32;
    var phi_3606_: f32;
    var phi_3611_: f32;
    var phi_3616_: f32;
    var phi_3624_: bool;
    var phi_3629_: f32;
    var phi_3636_: f32;
    var phi_3676_: type_27;
    var phi_3679_: f32;
    var phi_3700_: bool;
    var phi_3706_: type_28;
    var phi_3677_: type_27;
    var phi_3720_: type_28;
    var phi_3680_: f32;
    var local_16: f32;
    var phi_3669_: f32;
    var phi_3733_: f32;
    var phi_3739_: f32;
    var phi_3764_: type_29;
    var phi_3767_: u32;
    var phi_3765_: type_29;
    var phi_3790_: type_29;
    var phi_3834_: u32;
    var phi_3835_: u32;
    var phi_3768_: u32;
    var phi_3836_: u32;
    var phi_3856_: type_29;
    var phi_3857_: type_29;
    var phi_3880_: type_29;
    var phi_3932_: f32;
    var phi_3939_: f32;
    var phi_3950_: bool;
    var phi_3951_: bool;
    var phi_3952_: bool;
    var phi_3953_: bool;
    var phi_3957_: bool;
    var phi_3968_: type_57;
    var phi_3969_: type_57;
    var phi_3970_: bool;
    var phi_3971_: type_57;
    var phi_3972_: bool;
    var phi_3983_: f32;
    var phi_3993_: type_29;
    var phi_3996_: f32;
    var phi_3998_: f32;
    var phi_4000_: f32;
    var phi_3994_: type_29;
    var phi_4023_: type_29;
    var phi_4048_: f32;
    var phi_4049_: f32;
    var phi_4075_: f32;
    var phi_4091_: f32;
    var phi_4098_: bool;
    var phi_4099_: bool;
    var phi_4100_: bool;
    var phi_4106_: f32;
    var phi_4107_: f32;
    var phi_4108_: bool;
    var phi_3997_: f32;
    var phi_3999_: f32;
    var phi_4001_: f32;
    var phi_4109_: f32;
    var phi_4110_: bool;
    var phi_4111_: bool;
    var local_17: bool;
    var phi_4115_: f32;
    var phi_4116_: f32;
    var phi_4123_: type_29;
    var phi_4126_: f32;
    var phi_4124_: type_29;
    var phi_4149_: type_29;
    var phi_4190_: f32;
    var phi_4200_: f32;
    var phi_4208_: bool;
    var phi_4210_: bool;
    var phi_4215_: f32;
    var phi_4216_: bool;
    var phi_4217_: f32;
    var phi_4218_: bool;
    var phi_4219_: bool;
    var phi_4220_: bool;
    var phi_4221_: f32;
    var phi_4127_: f32;
    var phi_4222_: bool;
    var phi_4223_: bool;
    var phi_4224_: bool;
    var phi_4225_: bool;
    var local_18: bool;
    var phi_4229_: bool;
    var phi_4230_: bool;
    var phi_4234_: bool;
    var phi_4238_: f32;
    var phi_4239_: f32;
    var phi_4241_: type_57;
    var phi_4270_: f32;
    var phi_4277_: f32;
    var phi_4282_: f32;
    var phi_4289_: f32;
    var phi_4294_: f32;
    var phi_4307_: f32;
    var phi_4314_: f32;
    var phi_4319_: f32;
    var phi_4326_: f32;
    var phi_4331_: f32;
    var phi_4336_: f32;
    var phi_4395_: f32;
    var phi_4401_: f32;
    var phi_4406_: f32;
    var phi_4412_: f32;
    var phi_4417_: f32;
    var phi_4429_: f32;
    var phi_4435_: f32;
    var phi_4440_: f32;
    var phi_4446_: f32;
    var phi_4451_: f32;
    var phi_4477_: f32;
    var phi_4484_: f32;
    var phi_4489_: f32;
    var phi_4496_: f32;
    var phi_4501_: f32;
    var phi_4514_: f32;
    var phi_4521_: f32;
    var phi_4526_: f32;
    var phi_4533_: f32;
    var phi_4538_: f32;
    var phi_4543_: f32;
    var phi_4602_: f32;
    var phi_4608_: f32;
    var phi_4613_: f32;
    var phi_4619_: f32;
    var phi_4624_: f32;
    var phi_4636_: f32;
    var phi_4642_: f32;
    var phi_4647_: f32;
    var phi_4653_: f32;
    var phi_4658_: f32;
    var phi_4684_: f32;
    var phi_4691_: f32;
    var phi_4696_: f32;
    var phi_4703_: f32;
    var phi_4708_: f32;
    var phi_4721_: f32;
    var phi_4728_: f32;
    var phi_4733_: f32;
    var phi_4740_: f32;
    var phi_4745_: f32;
    var phi_4750_: f32;
    var phi_4809_: f32;
    var phi_4815_: f32;
    var phi_4820_: f32;
    var phi_4826_: f32;
    var phi_4831_: f32;
    var phi_4843_: f32;
    var phi_4849_: f32;
    var phi_4854_: f32;
    var phi_4860_: f32;
    var phi_4865_: f32;
    var phi_4914_: f32;
    var phi_4920_: f32;
    var phi_4948_: f32;
    var phi_4954_: f32;
    var phi_4959_: u32;
    var phi_4960_: u32;
    var phi_4930_: f32;
    var phi_4936_: f32;
    var phi_4941_: u32;
    var phi_4942_: u32;
    var phi_4961_: u32;
    var phi_4962_: u32;
    var phi_5029_: f32;
    var phi_5038_: f32;
    var phi_5169_: f32;
    var phi_5175_: f32;
    var phi_5182_: f32;
    var phi_5225_: type_29;
    var phi_5228_: bool;
    var phi_5226_: type_29;
    var phi_5251_: type_29;
    var phi_5278_: bool;
    var phi_5279_: bool;
    var phi_5229_: bool;
    var phi_5280_: bool;
    var phi_5281_: bool;
    var local_19: bool;
    var phi_5285_: bool;
    var local_20: bool;
    var phi_5292_: u32;
    var phi_5293_: u32;
    var phi_5294_: bool;
    var phi_5295_: u32;
    var phi_5296_: u32;
    var phi_5297_: bool;
    var phi_5301_: u32;
    var phi_5321_: bool;
    var phi_5322_: bool;
    var phi_5323_: bool;
    var phi_5519_: f32;
    var phi_5526_: f32;
    var phi_5531_: f32;
    var phi_5538_: f32;
    var phi_5543_: f32;
    var phi_5556_: f32;
    var phi_5563_: f32;
    var phi_5568_: f32;
    var phi_5575_: f32;
    var phi_5580_: f32;
    var phi_5585_: f32;
    var phi_5602_: f32;
    var phi_5609_: f32;
    var phi_5614_: f32;
    var phi_5621_: f32;
    var phi_5626_: f32;
    var phi_5640_: f32;
    var phi_5647_: f32;
    var phi_5652_: f32;
    var phi_5659_: f32;
    var phi_5664_: f32;
    var phi_5669_: f32;
    var phi_5686_: f32;
    var phi_5693_: f32;
    var phi_5698_: f32;
    var phi_5705_: f32;
    var phi_5710_: f32;
    var phi_5724_: f32;
    var phi_5731_: f32;
    var phi_5736_: f32;
    var phi_5743_: f32;
    var phi_5748_: f32;
    var phi_5753_: f32;
    var phi_5769_: type_29;
    var phi_5772_: f32;
    var phi_5770_: type_29;
    var phi_5795_: type_29;
    var phi_5949_: bool;
    var phi_5950_: bool;
    var phi_5951_: bool;
    var phi_5952_: bool;
    var phi_5953_: bool;
    var phi_5954_: bool;
    var phi_5958_: bool;
    var phi_5998_: array<f32, 3>;
    var phi_5999_: bool;
    var phi_6000_: array<f32, 3>;
    var phi_6001_: bool;
    var phi_6031_: f32;
    var phi_6032_: f32;
    var phi_6059_: f32;
    var phi_6060_: f32;
    var phi_6087_: f32;
    var phi_6088_: f32;
    var phi_6118_: f32;
    var phi_6119_: f32;
    var phi_6262_: type_29;
    var phi_6265_: array<f32, 3>;
    var phi_6263_: type_29;
    var phi_6288_: type_29;
    var phi_6355_: array<f32, 3>;
    var phi_6266_: array<f32, 3>;
    var phi_6356_: array<f32, 3>;
    var phi_6363_: f32;
    var phi_6370_: f32;
    var phi_6378_: f32;
    var phi_6422_: type_27;
    var phi_6425_: f32;
    var phi_6446_: bool;
    var phi_6452_: type_28;
    var phi_6423_: type_27;
    var phi_6466_: type_28;
    var phi_6426_: f32;
    var local_21: f32;
    var phi_6415_: f32;
    var phi_6479_: f32;
    var phi_6488_: type_29;
    var phi_6491_: f32;
    var phi_6489_: type_29;
    var phi_6514_: type_29;
    var phi_6565_: f32;
    var phi_6571_: f32;
    var phi_6584_: bool;
    var phi_6585_: bool;
    var phi_6616_: f32;
    var phi_6617_: f32;
    var phi_6618_: f32;
    var phi_6619_: bool;
    var phi_6623_: bool;
    var phi_6624_: f32;
    var phi_6625_: bool;
    var phi_6626_: bool;
    var phi_6627_: bool;
    var phi_6628_: f32;
    var phi_6629_: bool;
    var phi_6630_: bool;
    var phi_6631_: bool;
    var phi_6492_: f32;
    var phi_6632_: bool;
    var phi_6633_: bool;
    var phi_6634_: bool;
    var phi_6635_: bool;
    var local_22: bool;
    var local_23: f32;
    var local_24: f32;
    var local_25: f32;
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
    var phi_6662_: bool;
    var phi_6663_: bool;
    var phi_6664_: bool;
    var phi_6665_: f32;
    var phi_6666_: f32;
    var phi_6667_: bool;
    var phi_6668_: bool;
    var phi_6669_: bool;
    var phi_6670_: bool;
    var phi_6671_: bool;
    var phi_6672_: bool;
    var phi_6673_: bool;
    var phi_6674_: f32;
    var phi_6675_: f32;
    var phi_6676_: bool;
    var phi_6677_: bool;
    var phi_6678_: bool;
    var phi_6679_: bool;
    var phi_6680_: bool;
    var phi_6681_: bool;
    var phi_6682_: bool;
    var phi_6683_: bool;
    var phi_6684_: f32;
    var phi_5773_: f32;
    var phi_6685_: bool;
    var phi_6686_: bool;
    var phi_6687_: bool;
    var phi_6688_: bool;
    var phi_6689_: bool;
    var phi_6690_: bool;
    var phi_6691_: bool;
    var phi_6692_: bool;
    var phi_6693_: bool;
    var local_26: bool;
    var phi_6698_: type_56;
    var phi_6699_: bool;
    var phi_6700_: bool;
    var phi_6701_: bool;
    var phi_6702_: bool;
    var phi_6703_: bool;
    var phi_6704_: bool;
    var phi_6705_: bool;
    var phi_6709_: f32;
    var phi_6710_: bool;
    var phi_6711_: bool;
    var phi_6712_: bool;
    var phi_6713_: bool;
    var phi_6714_: bool;
    var phi_6715_: bool;
    var phi_6716_: bool;
    var phi_6721_: type_56;
    var phi_6722_: bool;
    var phi_6723_: bool;
    var phi_6724_: bool;
    var phi_6725_: bool;
    var phi_6726_: bool;
    var phi_6727_: bool;
    var local_27: f32;
    var phi_6732_: type_56;
    var phi_6733_: bool;
    var phi_6734_: bool;
    var phi_6735_: bool;
    var phi_6736_: bool;
    var phi_6737_: bool;
    var local_28: f32;
    var phi_6742_: type_56;
    var phi_6743_: bool;
    var phi_6744_: bool;
    var phi_6745_: bool;
    var phi_6746_: bool;
    var local_29: f32;
    var phi_6751_: type_56;
    var phi_6752_: bool;
    var phi_6753_: bool;
    var phi_6754_: bool;
    var phi_6755_: bool;
    var phi_6759_: type_56;
    var phi_6760_: bool;
    var phi_6761_: bool;
    var phi_6762_: bool;
    var phi_6766_: bool;
    var phi_6767_: bool;
    var phi_6771_: bool;
    var phi_6772_: bool;
    var phi_6776_: bool;
    var phi_6777_: bool;
    var local_30: f32;
    var phi_6782_: type_56;
    var phi_6783_: bool;
    var phi_6787_: type_56;
    var phi_6794_: bool;
    var phi_6795_: f32;
    var phi_6796_: bool;
    var phi_6797_: bool;
    var phi_6798_: bool;
    var phi_6799_: f32;
    var phi_6800_: bool;
    var phi_6801_: bool;
    var phi_6802_: bool;
    var phi_6803_: f32;
    var phi_6804_: bool;
    var phi_6805_: bool;
    var phi_6806_: bool;
    var phi_6807_: bool;
    var phi_6811_: bool;
    var phi_6812_: bool;
    var phi_6813_: bool;
    var phi_6814_: f32;
    var phi_6815_: type_57;
    var phi_6816_: bool;
    var phi_6817_: bool;
    var phi_6818_: bool;
    var phi_6819_: bool;
    var local_31: bool;
    var phi_6824_: type_56;
    var phi_6825_: bool;
    var phi_6826_: bool;
    var local_32: f32;
    var phi_6831_: type_56;
    var phi_6832_: bool;
    var local_33: type_57;
    var phi_6838_: type_56;
    var phi_6839_: bool;
    var phi_6843_: type_56;
    var phi_1311_: f32;
    var phi_1318_: f32;
    var phi_1323_: f32;
    var phi_1330_: f32;
    var phi_1335_: f32;
    var phi_1348_: f32;
    var phi_1355_: f32;
    var phi_1360_: f32;
    var phi_1367_: f32;
    var phi_1372_: f32;
    var phi_1377_: f32;
    var phi_1394_: f32;
    var phi_1401_: f32;
    var phi_1406_: f32;
    var phi_1413_: f32;
    var phi_1418_: f32;
    var phi_1432_: f32;
    var phi_1439_: f32;
    var phi_1444_: f32;
    var phi_1451_: f32;
    var phi_1456_: f32;
    var phi_1461_: f32;
    var phi_1478_: f32;
    var phi_1485_: f32;
    var phi_1490_: f32;
    var phi_1497_: f32;
    var phi_1502_: f32;
    var phi_1516_: f32;
    var phi_1523_: f32;
    var phi_1528_: f32;
    var phi_1535_: f32;
    var phi_1540_: f32;
    var phi_1545_: f32;
    var phi_1561_: type_29;
    var phi_1564_: f32;
    var phi_1562_: type_29;
    var phi_1587_: type_29;
    var phi_1741_: bool;
    var phi_1742_: bool;
    var phi_1743_: bool;
    var phi_1744_: bool;
    var phi_1745_: bool;
    var phi_1746_: bool;
    var phi_1750_: bool;
    var phi_1790_: array<f32, 3>;
    var phi_1791_: bool;
    var phi_1792_: array<f32, 3>;
    var phi_1793_: bool;
    var phi_1823_: f32;
    var phi_1824_: f32;
    var phi_1851_: f32;
    var phi_1852_: f32;
    var phi_1879_: f32;
    var phi_1880_: f32;
    var phi_1910_: f32;
    var phi_1911_: f32;
    var phi_2054_: type_29;
    var phi_2057_: array<f32, 3>;
    var phi_2055_: type_29;
    var phi_2080_: type_29;
    var phi_2147_: array<f32, 3>;
    var phi_2058_: array<f32, 3>;
    var phi_2148_: array<f32, 3>;
    var phi_2155_: f32;
    var phi_2162_: f32;
    var phi_2170_: f32;
    var phi_2214_: type_27;
    var phi_2217_: f32;
    var phi_2238_: bool;
    var phi_2244_: type_28;
    var phi_2215_: type_27;
    var phi_2258_: type_28;
    var phi_2218_: f32;
    var local_34: f32;
    var phi_2207_: f32;
    var phi_2271_: f32;
    var phi_2280_: type_29;
    var phi_2283_: f32;
    var phi_2281_: type_29;
    var phi_2306_: type_29;
    var phi_2357_: f32;
    var phi_2363_: f32;
    var phi_2376_: bool;
    var phi_2377_: bool;
    var phi_2408_: f32;
    var phi_2409_: f32;
    var phi_2410_: f32;
    var phi_2411_: bool;
    var phi_2415_: bool;
    var phi_2416_: f32;
    var phi_2417_: bool;
    var phi_2418_: bool;
    var phi_2419_: bool;
    var phi_2420_: f32;
    var phi_2421_: bool;
    var phi_2422_: bool;
    var phi_2423_: bool;
    var phi_2284_: f32;
    var phi_2424_: bool;
    var phi_2425_: bool;
    var phi_2426_: bool;
    var phi_2427_: bool;
    var local_35: bool;
    var local_36: f32;
    var local_37: f32;
    var local_38: f32;
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
    var phi_2454_: bool;
    var phi_2455_: bool;
    var phi_2456_: bool;
    var phi_2457_: f32;
    var phi_2458_: f32;
    var phi_2459_: bool;
    var phi_2460_: bool;
    var phi_2461_: bool;
    var phi_2462_: bool;
    var phi_2463_: bool;
    var phi_2464_: bool;
    var phi_2465_: bool;
    var phi_2466_: f32;
    var phi_2467_: f32;
    var phi_2468_: bool;
    var phi_2469_: bool;
    var phi_2470_: bool;
    var phi_2471_: bool;
    var phi_2472_: bool;
    var phi_2473_: bool;
    var phi_2474_: bool;
    var phi_2475_: bool;
    var phi_2476_: f32;
    var phi_1565_: f32;
    var phi_2477_: bool;
    var phi_2478_: bool;
    var phi_2479_: bool;
    var phi_2480_: bool;
    var phi_2481_: bool;
    var phi_2482_: bool;
    var phi_2483_: bool;
    var phi_2484_: bool;
    var phi_2485_: bool;
    var local_39: bool;
    var phi_2490_: type_56;
    var phi_2491_: bool;
    var phi_2492_: bool;
    var phi_2493_: bool;
    var phi_2494_: bool;
    var phi_2495_: bool;
    var phi_2496_: bool;
    var phi_2497_: bool;
    var phi_2501_: f32;
    var phi_2502_: bool;
    var phi_2503_: bool;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2506_: bool;
    var phi_2507_: bool;
    var phi_2508_: bool;
    var phi_2513_: type_56;
    var phi_2514_: bool;
    var phi_2515_: bool;
    var phi_2516_: bool;
    var phi_2517_: bool;
    var phi_2518_: bool;
    var phi_2519_: bool;
    var local_40: f32;
    var phi_2524_: type_56;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var phi_2527_: bool;
    var phi_2528_: bool;
    var phi_2529_: bool;
    var local_41: f32;
    var phi_2534_: type_56;
    var phi_2535_: bool;
    var phi_2536_: bool;
    var phi_2537_: bool;
    var phi_2538_: bool;
    var local_42: f32;
    var phi_2543_: type_56;
    var phi_2544_: bool;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2547_: bool;
    var phi_2551_: type_56;
    var phi_2552_: bool;
    var phi_2553_: bool;
    var phi_2554_: bool;
    var phi_2558_: bool;
    var phi_2559_: bool;
    var phi_2563_: bool;
    var phi_2564_: bool;
    var phi_2568_: bool;
    var phi_2569_: bool;
    var local_43: f32;
    var phi_2574_: type_56;
    var phi_2575_: bool;
    var phi_2579_: type_56;
    var phi_2593_: type_29;
    var phi_2594_: type_29;
    var phi_2617_: type_29;
    var phi_2637_: f32;
    var phi_2785_: bool;
    var phi_2786_: bool;
    var phi_2787_: bool;
    var phi_2788_: bool;
    var phi_2789_: bool;
    var phi_2790_: bool;
    var phi_2794_: bool;
    var phi_2834_: array<f32, 3>;
    var phi_2835_: bool;
    var phi_2836_: array<f32, 3>;
    var phi_2837_: bool;
    var phi_2867_: f32;
    var phi_2868_: f32;
    var phi_2895_: f32;
    var phi_2896_: f32;
    var phi_2923_: f32;
    var phi_2924_: f32;
    var phi_2954_: f32;
    var phi_2955_: f32;
    var phi_3098_: type_29;
    var phi_3101_: array<f32, 3>;
    var phi_3099_: type_29;
    var phi_3124_: type_29;
    var phi_3191_: array<f32, 3>;
    var phi_3102_: array<f32, 3>;
    var phi_3192_: array<f32, 3>;
    var phi_3224_: type_27;
    var phi_3227_: f32;
    var phi_3248_: bool;
    var phi_3254_: type_28;
    var phi_3225_: type_27;
    var phi_3268_: type_28;
    var phi_3228_: f32;
    var local_44: f32;
    var phi_3217_: f32;
    var phi_3281_: f32;
    var phi_3297_: f32;
    var phi_3304_: f32;
    var phi_3309_: f32;
    var phi_3316_: f32;
    var phi_3321_: f32;
    var phi_3334_: f32;
    var phi_3341_: f32;
    var phi_3346_: f32;
    var phi_3353_: f32;
    var phi_3358_: f32;
    var phi_3363_: f32;
    var phi_3380_: f32;
    var phi_3387_: f32;
    var phi_3392_: f32;
    var phi_3399_: f32;
    var phi_3404_: f32;
    var phi_3418_: f32;
    var phi_3425_: f32;
    var phi_3430_: f32;
    var phi_3437_: f32;
    var phi_3442_: f32;
    var phi_3447_: f32;
    var phi_3464_: f32;
    var phi_3471_: f32;
    var phi_3476_: f32;
    var phi_3483_: f32;
    var phi_3488_: f32;
    var phi_3502_: f32;
    var phi_3509_: f32;
    var phi_3514_: f32;
    var phi_3521_: f32;
    var phi_3526_: f32;
    var phi_3531_: f32;
    var phi_3551_: bool;
    var phi_3552_: bool;
    var phi_3553_: bool;
    var local_45: bool;
    var phi_3558_: type_56;
    var phi_3559_: bool;
    var phi_3564_: type_56;
    var phi_3565_: bool;
    var phi_3567_: type_56;
    var phi_3568_: type_56;
    var phi_3569_: bool;
    var phi_3573_: type_56;
    var phi_6847_: type_56;
    var phi_6848_: type_56;
    var phi_6861_: type_59;
    var phi_6868_: bool;
    var phi_6892_: u32;
    var phi_6896_: type_50;
    var phi_6897_: bool;
    var phi_6898_: bool;
    var phi_6916_: u32;
    var phi_6978_: u32;
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
        phi_206_ = _e125;
    } else {
        phi_206_ = _e127;
    }
    let _e130 = phi_206_;
    let _e131 = (_e130 / 64u);
    if ((_e130 % 64u) > 0u) {
        phi_222_ = (_e131 + 1u);
    } else {
        phi_222_ = _e131;
    }
    let _e136 = phi_222_;
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
            phi_243_ = (_e140 + 1u);
        } else {
            phi_243_ = _e140;
        }
        let _e146 = phi_243_;
        phi_244_ = _e146;
    } else {
        phi_244_ = 0u;
    }
    let _e148 = phi_244_;
    phi_247_ = type_29(0u, _e148);
    loop {
        let _e151 = phi_247_;
        if (_e151.member < _e151.member_1) {
            phi_248_ = type_29((_e151.member + 1u), _e151.member_1);
            phi_271_ = type_29(1u, _e151.member);
        } else {
            phi_248_ = _e151;
            phi_271_ = type_29(0u, type_29().member_1);
        }
        let _e165 = phi_248_;
        let _e167 = phi_271_;
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
                local_15 = type_47(array<array<f32, 3>, 2>(array<f32, 3>((_e204.member[0] - _e196.member[0]), (_e204.member[1] - _e196.member[1]), (_e204.member[2] - _e196.member[2])), array<f32, 3>((_e204.member_1[0] - _e196.member_1[0]), (_e204.member_1[1] - _e196.member_1[1]), (_e204.member_1[2] - _e196.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e198.member[0] - _e196.member[0]), (_e198.member[1] - _e196.member[1]), (_e198.member[2] - _e196.member[2])), array<f32, 3>((_e198.member_1[0] - _e196.member_1[0]), (_e198.member_1[1] - _e196.member_1[1]), (_e198.member_1[2] - _e196.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e204.member[0] - _e206.member[0]), (_e204.member[1] - _e206.member[1]), (_e204.member[2] - _e206.member[2])), array<f32, 3>((_e204.member_1[0] - _e206.member_1[0]), (_e204.member_1[1] - _e206.member_1[1]), (_e204.member_1[2] - _e206.member_1[2]))), (_e236 + _e236));
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
                    phi_721_ = -(_e425[0]);
                } else {
                    phi_721_ = _e425[0];
                }
                let _e432 = phi_721_;
                if (_e425[1] < 0f) {
                    phi_728_ = -(_e425[1]);
                } else {
                    phi_728_ = _e425[1];
                }
                let _e436 = phi_728_;
                if (_e432 > _e436) {
                    phi_733_ = _e432;
                } else {
                    phi_733_ = _e436;
                }
                let _e439 = phi_733_;
                if (_e425[2] < 0f) {
                    phi_740_ = -(_e425[2]);
                } else {
                    phi_740_ = _e425[2];
                }
                let _e443 = phi_740_;
                if (_e439 > _e443) {
                    phi_745_ = _e439;
                } else {
                    phi_745_ = _e443;
                }
                let _e446 = phi_745_;
                let _e449 = local_15.member[1u];
                if (_e449[0] < 0f) {
                    phi_758_ = -(_e449[0]);
                } else {
                    phi_758_ = _e449[0];
                }
                let _e456 = phi_758_;
                if (_e449[1] < 0f) {
                    phi_765_ = -(_e449[1]);
                } else {
                    phi_765_ = _e449[1];
                }
                let _e460 = phi_765_;
                if (_e456 > _e460) {
                    phi_770_ = _e456;
                } else {
                    phi_770_ = _e460;
                }
                let _e463 = phi_770_;
                if (_e449[2] < 0f) {
                    phi_777_ = -(_e449[2]);
                } else {
                    phi_777_ = _e449[2];
                }
                let _e467 = phi_777_;
                if (_e463 > _e467) {
                    phi_782_ = _e463;
                } else {
                    phi_782_ = _e467;
                }
                let _e470 = phi_782_;
                if (_e446 > _e470) {
                    phi_787_ = _e446;
                } else {
                    phi_787_ = _e470;
                }
                let _e473 = phi_787_;
                let _e475 = local_15.member_3;
                let _e476 = (_e473 + _e475);
                let _e479 = local_15.member_1[0u];
                if (_e479[0] < 0f) {
                    phi_804_ = -(_e479[0]);
                } else {
                    phi_804_ = _e479[0];
                }
                let _e486 = phi_804_;
                if (_e479[1] < 0f) {
                    phi_811_ = -(_e479[1]);
                } else {
                    phi_811_ = _e479[1];
                }
                let _e490 = phi_811_;
                if (_e486 > _e490) {
                    phi_816_ = _e486;
                } else {
                    phi_816_ = _e490;
                }
                let _e493 = phi_816_;
                if (_e479[2] < 0f) {
                    phi_823_ = -(_e479[2]);
                } else {
                    phi_823_ = _e479[2];
                }
                let _e497 = phi_823_;
                if (_e493 > _e497) {
                    phi_828_ = _e493;
                } else {
                    phi_828_ = _e497;
                }
                let _e500 = phi_828_;
                let _e503 = local_15.member_1[1u];
                if (_e503[0] < 0f) {
                    phi_842_ = -(_e503[0]);
                } else {
                    phi_842_ = _e503[0];
                }
                let _e510 = phi_842_;
                if (_e503[1] < 0f) {
                    phi_849_ = -(_e503[1]);
                } else {
                    phi_849_ = _e503[1];
                }
                let _e514 = phi_849_;
                if (_e510 > _e514) {
                    phi_854_ = _e510;
                } else {
                    phi_854_ = _e514;
                }
                let _e517 = phi_854_;
                if (_e503[2] < 0f) {
                    phi_861_ = -(_e503[2]);
                } else {
                    phi_861_ = _e503[2];
                }
                let _e521 = phi_861_;
                if (_e517 > _e521) {
                    phi_866_ = _e517;
                } else {
                    phi_866_ = _e521;
                }
                let _e524 = phi_866_;
                if (_e500 > _e524) {
                    phi_871_ = _e500;
                } else {
                    phi_871_ = _e524;
                }
                let _e527 = phi_871_;
                let _e529 = local_15.member_3;
                let _e530 = (_e527 + _e529);
                let _e533 = local_15.member_2[0u];
                if (_e533[0] < 0f) {
                    phi_888_ = -(_e533[0]);
                } else {
                    phi_888_ = _e533[0];
                }
                let _e540 = phi_888_;
                if (_e533[1] < 0f) {
                    phi_895_ = -(_e533[1]);
                } else {
                    phi_895_ = _e533[1];
                }
                let _e544 = phi_895_;
                if (_e540 > _e544) {
                    phi_900_ = _e540;
                } else {
                    phi_900_ = _e544;
                }
                let _e547 = phi_900_;
                if (_e533[2] < 0f) {
                    phi_907_ = -(_e533[2]);
                } else {
                    phi_907_ = _e533[2];
                }
                let _e551 = phi_907_;
                if (_e547 > _e551) {
                    phi_912_ = _e547;
                } else {
                    phi_912_ = _e551;
                }
                let _e554 = phi_912_;
                let _e557 = local_15.member_2[1u];
                if (_e557[0] < 0f) {
                    phi_926_ = -(_e557[0]);
                } else {
                    phi_926_ = _e557[0];
                }
                let _e564 = phi_926_;
                if (_e557[1] < 0f) {
                    phi_933_ = -(_e557[1]);
                } else {
                    phi_933_ = _e557[1];
                }
                let _e568 = phi_933_;
                if (_e564 > _e568) {
                    phi_938_ = _e564;
                } else {
                    phi_938_ = _e568;
                }
                let _e571 = phi_938_;
                if (_e557[2] < 0f) {
                    phi_945_ = -(_e557[2]);
                } else {
                    phi_945_ = _e557[2];
                }
                let _e575 = phi_945_;
                if (_e571 > _e575) {
                    phi_950_ = _e571;
                } else {
                    phi_950_ = _e575;
                }
                let _e578 = phi_950_;
                if (_e554 > _e578) {
                    phi_955_ = _e554;
                } else {
                    phi_955_ = _e578;
                }
                let _e581 = phi_955_;
                let _e583 = local_15.member_3;
                let _e584 = (_e581 + _e583);
                let _e586 = ((_e530 * 8f) * _e584);
                let _e593 = local_15.member_3;
                if (_e282 < 0f) {
                    phi_986_ = -(_e282);
                } else {
                    phi_986_ = _e282;
                }
                let _e610 = phi_986_;
                if (_e285 < 0f) {
                    phi_992_ = -(_e285);
                } else {
                    phi_992_ = _e285;
                }
                let _e614 = phi_992_;
                if (_e288 < 0f) {
                    phi_999_ = -(_e288);
                } else {
                    phi_999_ = _e288;
                }
                let _e619 = phi_999_;
                let _e620 = ((_e610 + _e614) + _e619);
                if (_e303 < 0f) {
                    phi_1006_ = -(_e303);
                } else {
                    phi_1006_ = _e303;
                }
                let _e624 = phi_1006_;
                if (_e306 < 0f) {
                    phi_1012_ = -(_e306);
                } else {
                    phi_1012_ = _e306;
                }
                let _e628 = phi_1012_;
                if (_e309 < 0f) {
                    phi_1019_ = -(_e309);
                } else {
                    phi_1019_ = _e309;
                }
                let _e633 = phi_1019_;
                let _e634 = ((_e624 + _e628) + _e633);
                if (_e620 > _e634) {
                    phi_1025_ = _e620;
                } else {
                    phi_1025_ = _e634;
                }
                let _e637 = phi_1025_;
                if (_e352 < 0f) {
                    phi_1031_ = -(_e352);
                } else {
                    phi_1031_ = _e352;
                }
                let _e641 = phi_1031_;
                if (_e353 < 0f) {
                    phi_1037_ = -(_e353);
                } else {
                    phi_1037_ = _e353;
                }
                let _e645 = phi_1037_;
                if (_e354 < 0f) {
                    phi_1044_ = -(_e354);
                } else {
                    phi_1044_ = _e354;
                }
                let _e650 = phi_1044_;
                let _e652 = (((_e641 + _e645) + _e650) * 0.5f);
                if (_e637 > _e652) {
                    phi_1051_ = _e637;
                } else {
                    phi_1051_ = _e652;
                }
                let _e655 = phi_1051_;
                let _e660 = local_15.member_3;
                let _e672 = (((((_e476 * 8f) * _e586) * (0.000000059604645f * (490f / 64f))) + ((_e593 * 19f) * ((_e476 * (_e530 + _e584)) + (_e530 * _e584)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e476) * ((1f + _e530) * (1f + _e584)))));
                let _e673 = (_e365 * 3f);
                let _e674 = (_e422 * 3f);
                if (_e673 < _e674) {
                    phi_1075_ = _e673;
                } else {
                    phi_1075_ = _e674;
                }
                let _e677 = phi_1075_;
                if (_e388 < _e411) {
                    phi_1080_ = _e388;
                } else {
                    phi_1080_ = _e411;
                }
                let _e680 = phi_1080_;
                if (_e677 < _e680) {
                    phi_1085_ = _e677;
                } else {
                    phi_1085_ = _e680;
                }
                let _e683 = phi_1085_;
                if (_e673 > _e674) {
                    phi_1090_ = _e673;
                } else {
                    phi_1090_ = _e674;
                }
                let _e686 = phi_1090_;
                if (_e388 > _e411) {
                    phi_1095_ = _e388;
                } else {
                    phi_1095_ = _e411;
                }
                let _e689 = phi_1095_;
                if (_e686 > _e689) {
                    phi_1100_ = _e686;
                } else {
                    phi_1100_ = _e689;
                }
                let _e692 = phi_1100_;
                let _e697 = -(_e692);
                if (_e683 > _e697) {
                    phi_1110_ = _e683;
                } else {
                    phi_1110_ = _e697;
                }
                let _e700 = phi_1110_;
                if ((_e700 - (_e672 + ((_e267 * (((_e655 + (_e586 * (0.000000059604645f * 4f))) + ((_e660 * 6f) * (_e530 + _e584))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e530) * (1f + _e584))))) * (3f * 1.0001f)))) > 0f) {
                    phi_6848_ = type_56(0u, type_56().member_1);
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
                            phi_1311_ = -(_e3098[0]);
                        } else {
                            phi_1311_ = _e3098[0];
                        }
                        let _e3105 = phi_1311_;
                        if (_e3098[1] < 0f) {
                            phi_1318_ = -(_e3098[1]);
                        } else {
                            phi_1318_ = _e3098[1];
                        }
                        let _e3109 = phi_1318_;
                        if (_e3105 > _e3109) {
                            phi_1323_ = _e3105;
                        } else {
                            phi_1323_ = _e3109;
                        }
                        let _e3112 = phi_1323_;
                        if (_e3098[2] < 0f) {
                            phi_1330_ = -(_e3098[2]);
                        } else {
                            phi_1330_ = _e3098[2];
                        }
                        let _e3116 = phi_1330_;
                        if (_e3112 > _e3116) {
                            phi_1335_ = _e3112;
                        } else {
                            phi_1335_ = _e3116;
                        }
                        let _e3119 = phi_1335_;
                        let _e3122 = local_15.member[1u];
                        if (_e3122[0] < 0f) {
                            phi_1348_ = -(_e3122[0]);
                        } else {
                            phi_1348_ = _e3122[0];
                        }
                        let _e3129 = phi_1348_;
                        if (_e3122[1] < 0f) {
                            phi_1355_ = -(_e3122[1]);
                        } else {
                            phi_1355_ = _e3122[1];
                        }
                        let _e3133 = phi_1355_;
                        if (_e3129 > _e3133) {
                            phi_1360_ = _e3129;
                        } else {
                            phi_1360_ = _e3133;
                        }
                        let _e3136 = phi_1360_;
                        if (_e3122[2] < 0f) {
                            phi_1367_ = -(_e3122[2]);
                        } else {
                            phi_1367_ = _e3122[2];
                        }
                        let _e3140 = phi_1367_;
                        if (_e3136 > _e3140) {
                            phi_1372_ = _e3136;
                        } else {
                            phi_1372_ = _e3140;
                        }
                        let _e3143 = phi_1372_;
                        if (_e3119 > _e3143) {
                            phi_1377_ = _e3119;
                        } else {
                            phi_1377_ = _e3143;
                        }
                        let _e3146 = phi_1377_;
                        let _e3148 = local_15.member_3;
                        let _e3152 = local_15.member_1[0u];
                        if (_e3152[0] < 0f) {
                            phi_1394_ = -(_e3152[0]);
                        } else {
                            phi_1394_ = _e3152[0];
                        }
                        let _e3159 = phi_1394_;
                        if (_e3152[1] < 0f) {
                            phi_1401_ = -(_e3152[1]);
                        } else {
                            phi_1401_ = _e3152[1];
                        }
                        let _e3163 = phi_1401_;
                        if (_e3159 > _e3163) {
                            phi_1406_ = _e3159;
                        } else {
                            phi_1406_ = _e3163;
                        }
                        let _e3166 = phi_1406_;
                        if (_e3152[2] < 0f) {
                            phi_1413_ = -(_e3152[2]);
                        } else {
                            phi_1413_ = _e3152[2];
                        }
                        let _e3170 = phi_1413_;
                        if (_e3166 > _e3170) {
                            phi_1418_ = _e3166;
                        } else {
                            phi_1418_ = _e3170;
                        }
                        let _e3173 = phi_1418_;
                        let _e3176 = local_15.member_1[1u];
                        if (_e3176[0] < 0f) {
                            phi_1432_ = -(_e3176[0]);
                        } else {
                            phi_1432_ = _e3176[0];
                        }
                        let _e3183 = phi_1432_;
                        if (_e3176[1] < 0f) {
                            phi_1439_ = -(_e3176[1]);
                        } else {
                            phi_1439_ = _e3176[1];
                        }
                        let _e3187 = phi_1439_;
                        if (_e3183 > _e3187) {
                            phi_1444_ = _e3183;
                        } else {
                            phi_1444_ = _e3187;
                        }
                        let _e3190 = phi_1444_;
                        if (_e3176[2] < 0f) {
                            phi_1451_ = -(_e3176[2]);
                        } else {
                            phi_1451_ = _e3176[2];
                        }
                        let _e3194 = phi_1451_;
                        if (_e3190 > _e3194) {
                            phi_1456_ = _e3190;
                        } else {
                            phi_1456_ = _e3194;
                        }
                        let _e3197 = phi_1456_;
                        if (_e3173 > _e3197) {
                            phi_1461_ = _e3173;
                        } else {
                            phi_1461_ = _e3197;
                        }
                        let _e3200 = phi_1461_;
                        let _e3202 = local_15.member_3;
                        let _e3206 = local_15.member_2[0u];
                        if (_e3206[0] < 0f) {
                            phi_1478_ = -(_e3206[0]);
                        } else {
                            phi_1478_ = _e3206[0];
                        }
                        let _e3213 = phi_1478_;
                        if (_e3206[1] < 0f) {
                            phi_1485_ = -(_e3206[1]);
                        } else {
                            phi_1485_ = _e3206[1];
                        }
                        let _e3217 = phi_1485_;
                        if (_e3213 > _e3217) {
                            phi_1490_ = _e3213;
                        } else {
                            phi_1490_ = _e3217;
                        }
                        let _e3220 = phi_1490_;
                        if (_e3206[2] < 0f) {
                            phi_1497_ = -(_e3206[2]);
                        } else {
                            phi_1497_ = _e3206[2];
                        }
                        let _e3224 = phi_1497_;
                        if (_e3220 > _e3224) {
                            phi_1502_ = _e3220;
                        } else {
                            phi_1502_ = _e3224;
                        }
                        let _e3227 = phi_1502_;
                        let _e3230 = local_15.member_2[1u];
                        if (_e3230[0] < 0f) {
                            phi_1516_ = -(_e3230[0]);
                        } else {
                            phi_1516_ = _e3230[0];
                        }
                        let _e3237 = phi_1516_;
                        if (_e3230[1] < 0f) {
                            phi_1523_ = -(_e3230[1]);
                        } else {
                            phi_1523_ = _e3230[1];
                        }
                        let _e3241 = phi_1523_;
                        if (_e3237 > _e3241) {
                            phi_1528_ = _e3237;
                        } else {
                            phi_1528_ = _e3241;
                        }
                        let _e3244 = phi_1528_;
                        if (_e3230[2] < 0f) {
                            phi_1535_ = -(_e3230[2]);
                        } else {
                            phi_1535_ = _e3230[2];
                        }
                        let _e3248 = phi_1535_;
                        if (_e3244 > _e3248) {
                            phi_1540_ = _e3244;
                        } else {
                            phi_1540_ = _e3248;
                        }
                        let _e3251 = phi_1540_;
                        if (_e3227 > _e3251) {
                            phi_1545_ = _e3227;
                        } else {
                            phi_1545_ = _e3251;
                        }
                        let _e3254 = phi_1545_;
                        let _e3256 = local_15.member_3;
                        let _e3263 = local_15.member_3;
                        phi_1561_ = type_29(0u, 48u);
                        phi_1564_ = 0f;
                        loop {
                            let _e3269 = phi_1561_;
                            let _e3271 = phi_1564_;
                            local_82 = _e3271;
                            local_40 = _e3271;
                            local_41 = _e3271;
                            local_42 = _e3271;
                            local_43 = _e3271;
                            if (_e3269.member < _e3269.member_1) {
                                phi_1562_ = type_29((_e3269.member + 1u), _e3269.member_1);
                                phi_1587_ = type_29(1u, _e3269.member);
                            } else {
                                phi_1562_ = _e3269;
                                phi_1587_ = type_29(0u, type_29().member_1);
                            }
                            let _e3285 = phi_1562_;
                            let _e3287 = phi_1587_;
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
                                            phi_1741_ = (_e3389 <= 1f);
                                            phi_1742_ = false;
                                        } else {
                                            phi_1741_ = bool();
                                            phi_1742_ = true;
                                        }
                                        let _e3395 = phi_1741_;
                                        let _e3397 = phi_1742_;
                                        phi_1743_ = _e3395;
                                        phi_1744_ = _e3397;
                                    } else {
                                        phi_1743_ = bool();
                                        phi_1744_ = true;
                                    }
                                    let _e3399 = phi_1743_;
                                    let _e3401 = phi_1744_;
                                    phi_1745_ = _e3399;
                                    phi_1746_ = _e3401;
                                } else {
                                    phi_1745_ = bool();
                                    phi_1746_ = true;
                                }
                                let _e3403 = phi_1745_;
                                let _e3405 = phi_1746_;
                                if _e3405 {
                                    phi_1750_ = false;
                                } else {
                                    phi_1750_ = _e3403;
                                }
                                let _e3407 = phi_1750_;
                                if (_e3381 > 0f) {
                                    if _e3407 {
                                        phi_1790_ = array<f32, 3>((_e3309 - ((_e3330 * _e3385) + (_e3351 * _e3389))), (_e3310 - ((_e3331 * _e3385) + (_e3352 * _e3389))), (_e3311 - ((_e3332 * _e3385) + (_e3353 * _e3389))));
                                        phi_1791_ = false;
                                    } else {
                                        phi_1790_ = array<f32, 3>();
                                        phi_1791_ = true;
                                    }
                                    let _e3423 = phi_1790_;
                                    let _e3425 = phi_1791_;
                                    phi_1792_ = _e3423;
                                    phi_1793_ = _e3425;
                                } else {
                                    phi_1792_ = array<f32, 3>();
                                    phi_1793_ = true;
                                }
                                let _e3427 = phi_1792_;
                                let _e3429 = phi_1793_;
                                if _e3429 {
                                    let _e3430 = (_e3309 - _e3330);
                                    let _e3431 = (_e3310 - _e3331);
                                    let _e3432 = (_e3311 - _e3332);
                                    let _e3443 = ((((_e3309 * _e3330) + (_e3310 * _e3331)) + (_e3311 * _e3332)) / (((_e3330 * _e3330) + (_e3331 * _e3331)) + (_e3332 * _e3332)));
                                    if (_e3443 > 0f) {
                                        if (_e3443 < 1f) {
                                            phi_1823_ = _e3443;
                                        } else {
                                            phi_1823_ = 1f;
                                        }
                                        let _e3447 = phi_1823_;
                                        phi_1824_ = _e3447;
                                    } else {
                                        phi_1824_ = 0f;
                                    }
                                    let _e3449 = phi_1824_;
                                    let _e3466 = ((((_e3309 * _e3351) + (_e3310 * _e3352)) + (_e3311 * _e3353)) / (((_e3351 * _e3351) + (_e3352 * _e3352)) + (_e3353 * _e3353)));
                                    if (_e3466 > 0f) {
                                        if (_e3466 < 1f) {
                                            phi_1851_ = _e3466;
                                        } else {
                                            phi_1851_ = 1f;
                                        }
                                        let _e3470 = phi_1851_;
                                        phi_1852_ = _e3470;
                                    } else {
                                        phi_1852_ = 0f;
                                    }
                                    let _e3472 = phi_1852_;
                                    let _e3489 = ((((_e3430 * _e3351) + (_e3431 * _e3352)) + (_e3432 * _e3353)) / (((_e3351 * _e3351) + (_e3352 * _e3352)) + (_e3353 * _e3353)));
                                    if (_e3489 > 0f) {
                                        if (_e3489 < 1f) {
                                            phi_1879_ = _e3489;
                                        } else {
                                            phi_1879_ = 1f;
                                        }
                                        let _e3493 = phi_1879_;
                                        phi_1880_ = _e3493;
                                    } else {
                                        phi_1880_ = 0f;
                                    }
                                    let _e3495 = phi_1880_;
                                    let _e3502 = (_e3309 - _e3351);
                                    let _e3503 = (_e3310 - _e3352);
                                    let _e3504 = (_e3311 - _e3353);
                                    let _e3515 = ((((_e3502 * _e3330) + (_e3503 * _e3331)) + (_e3504 * _e3332)) / (((_e3330 * _e3330) + (_e3331 * _e3331)) + (_e3332 * _e3332)));
                                    if (_e3515 > 0f) {
                                        if (_e3515 < 1f) {
                                            phi_1910_ = _e3515;
                                        } else {
                                            phi_1910_ = 1f;
                                        }
                                        let _e3519 = phi_1910_;
                                        phi_1911_ = _e3519;
                                    } else {
                                        phi_1911_ = 0f;
                                    }
                                    let _e3521 = phi_1911_;
                                    local_11[0u] = array<f32, 3>((_e3309 - (_e3330 * _e3449)), (_e3310 - (_e3331 * _e3449)), (_e3311 - (_e3332 * _e3449)));
                                    local_11[1u] = array<f32, 3>((_e3309 - (_e3351 * _e3472)), (_e3310 - (_e3352 * _e3472)), (_e3311 - (_e3353 * _e3472)));
                                    local_11[2u] = array<f32, 3>((_e3430 - (_e3351 * _e3495)), (_e3431 - (_e3352 * _e3495)), (_e3432 - (_e3353 * _e3495)));
                                    local_11[3u] = array<f32, 3>((_e3502 - (_e3330 * _e3521)), (_e3503 - (_e3331 * _e3521)), (_e3504 - (_e3332 * _e3521)));
                                    let _e3537 = local_11[0u];
                                    phi_2054_ = type_29(1u, 4u);
                                    phi_2057_ = array<f32, 3>(_e3537[0], _e3537[1], _e3537[2]);
                                    loop {
                                        let _e3543 = phi_2054_;
                                        let _e3545 = phi_2057_;
                                        local_69 = _e3545;
                                        if (_e3543.member < _e3543.member_1) {
                                            phi_2055_ = type_29((_e3543.member + 1u), _e3543.member_1);
                                            phi_2080_ = type_29(1u, _e3543.member);
                                        } else {
                                            phi_2055_ = _e3543;
                                            phi_2080_ = type_29(0u, type_29().member_1);
                                        }
                                        let _e3559 = phi_2055_;
                                        let _e3561 = phi_2080_;
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
                                                phi_2147_ = array<f32, 3>(_e3597[0], _e3597[1], _e3597[2]);
                                            } else {
                                                phi_2147_ = _e3545;
                                            }
                                            let _e3603 = phi_2147_;
                                            phi_2058_ = _e3603;
                                        } else {
                                            phi_2058_ = array<f32, 3>();
                                        }
                                        let _e3605 = phi_2058_;
                                        continue;
                                        continuing {
                                            phi_2054_ = _e3559;
                                            phi_2057_ = _e3605;
                                            break if !(_e3565);
                                        }
                                    }
                                    let _e5409 = local_69;
                                    phi_2148_ = _e5409;
                                } else {
                                    phi_2148_ = _e3427;
                                }
                                let _e3608 = phi_2148_;
                                if (_e3608[0] < 0f) {
                                    phi_2155_ = -(_e3608[0]);
                                } else {
                                    phi_2155_ = _e3608[0];
                                }
                                let _e3613 = phi_2155_;
                                if (_e3608[1] < 0f) {
                                    phi_2162_ = -(_e3608[1]);
                                } else {
                                    phi_2162_ = _e3608[1];
                                }
                                let _e3618 = phi_2162_;
                                if (_e3608[2] < 0f) {
                                    phi_2170_ = -(_e3608[2]);
                                } else {
                                    phi_2170_ = _e3608[2];
                                }
                                let _e3624 = phi_2170_;
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
                                                phi_2207_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2207_ = 0f;
                                            }
                                            let _e3700 = phi_2207_;
                                            phi_2271_ = _e3700;
                                        } else {
                                            phi_2214_ = type_27(0i, 5i);
                                            phi_2217_ = bitcast<f32>(((bitcast<u32>(_e3641) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3649 = phi_2214_;
                                                let _e3651 = phi_2217_;
                                                local_34 = _e3651;
                                                if (_e3649.member < _e3649.member_1) {
                                                    let _e3659 = (_e3649.member + 1i);
                                                    if ((false == (_e3659 > _e3649.member)) != false) {
                                                        phi_2238_ = true;
                                                    } else {
                                                        phi_2238_ = false;
                                                    }
                                                    let _e3664 = phi_2238_;
                                                    if _e3664 {
                                                        phi_2244_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_2244_ = type_28(1u, _e3659);
                                                    }
                                                    let _e3670 = phi_2244_;
                                                    if (bitcast<i32>(_e3670.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2215_ = type_27(_e3670.member_1, _e3649.member_1);
                                                    phi_2258_ = type_28(1u, _e3649.member);
                                                } else {
                                                    phi_2215_ = _e3649;
                                                    phi_2258_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e3680 = phi_2215_;
                                                let _e3682 = phi_2258_;
                                                let _e3685 = (bitcast<i32>(_e3682.member) != 0i);
                                                if _e3685 {
                                                    phi_2218_ = (0.5f * (_e3651 + (_e3641 / _e3651)));
                                                } else {
                                                    phi_2218_ = f32();
                                                }
                                                let _e3690 = phi_2218_;
                                                continue;
                                                continuing {
                                                    phi_2214_ = _e3680;
                                                    phi_2217_ = _e3690;
                                                    break if !(_e3685);
                                                }
                                            }
                                            let _e3695 = local_34;
                                            phi_2271_ = (_e3695 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3702 = phi_2271_;
                                        phi_2280_ = type_29(0u, 4u);
                                        phi_2283_ = 2f;
                                        loop {
                                            let _e3710 = phi_2280_;
                                            let _e3712 = phi_2283_;
                                            local_36 = _e3712;
                                            local_37 = _e3712;
                                            local_38 = _e3712;
                                            local_72 = _e3712;
                                            local_73 = _e3712;
                                            if (_e3710.member < _e3710.member_1) {
                                                phi_2281_ = type_29((_e3710.member + 1u), _e3710.member_1);
                                                phi_2306_ = type_29(1u, _e3710.member);
                                            } else {
                                                phi_2281_ = _e3710;
                                                phi_2306_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e3726 = phi_2281_;
                                            let _e3728 = phi_2306_;
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
                                                    phi_2357_ = -(_e3743);
                                                } else {
                                                    phi_2357_ = _e3743;
                                                }
                                                let _e3758 = phi_2357_;
                                                if (_e3754 < 0f) {
                                                    phi_2363_ = -(_e3754);
                                                } else {
                                                    phi_2363_ = _e3754;
                                                }
                                                let _e3762 = phi_2363_;
                                                let _e3766 = (((((((((_e3146 + _e3148) + (_e3200 + _e3202)) + (_e3254 + _e3256)) * (0.000000059604645f * 16f)) + (_e3263 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e267 * _e3702) * (1f + (0.000000059604645f * 8f)))) + ((_e3758 + _e3762) * (0.000000059604645f * 8f)));
                                                if (_e3743 > _e3766) {
                                                    if (_e3754 > _e3766) {
                                                        phi_2376_ = false;
                                                    } else {
                                                        phi_2376_ = true;
                                                    }
                                                    let _e3770 = phi_2376_;
                                                    phi_2377_ = _e3770;
                                                } else {
                                                    phi_2377_ = true;
                                                }
                                                let _e3772 = phi_2377_;
                                                if _e3772 {
                                                    if ((_e3743 + ((_e3754 - _e3743) * _e3271)) > _e3766) {
                                                        if (_e3754 < _e3743) {
                                                            let _e3780 = ((_e3743 - _e3754) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                            if _e3780 {
                                                                let _e3786 = (((_e3743 - _e3766) / (_e3743 - _e3754)) * (1f - (0.000000059604645f * 16f)));
                                                                if (_e3712 < _e3786) {
                                                                    phi_2408_ = _e3712;
                                                                } else {
                                                                    phi_2408_ = _e3786;
                                                                }
                                                                let _e3789 = phi_2408_;
                                                                phi_2409_ = _e3789;
                                                            } else {
                                                                phi_2409_ = f32();
                                                            }
                                                            let _e3791 = phi_2409_;
                                                            phi_2410_ = _e3791;
                                                            phi_2411_ = _e3780;
                                                        } else {
                                                            phi_2410_ = _e3712;
                                                            phi_2411_ = true;
                                                        }
                                                        let _e3793 = phi_2410_;
                                                        let _e3795 = phi_2411_;
                                                        if _e3795 {
                                                            phi_2415_ = false;
                                                        } else {
                                                            phi_2415_ = true;
                                                        }
                                                        let _e3797 = phi_2415_;
                                                        phi_2416_ = _e3793;
                                                        phi_2417_ = _e3795;
                                                        phi_2418_ = _e3797;
                                                        phi_2419_ = false;
                                                    } else {
                                                        phi_2416_ = f32();
                                                        phi_2417_ = false;
                                                        phi_2418_ = false;
                                                        phi_2419_ = true;
                                                    }
                                                    let _e3799 = phi_2416_;
                                                    let _e3801 = phi_2417_;
                                                    let _e3803 = phi_2418_;
                                                    let _e3805 = phi_2419_;
                                                    phi_2420_ = _e3799;
                                                    phi_2421_ = _e3801;
                                                    phi_2422_ = _e3803;
                                                    phi_2423_ = _e3805;
                                                } else {
                                                    phi_2420_ = _e3712;
                                                    phi_2421_ = true;
                                                    phi_2422_ = false;
                                                    phi_2423_ = false;
                                                }
                                                let _e3807 = phi_2420_;
                                                let _e3809 = phi_2421_;
                                                let _e3811 = phi_2422_;
                                                let _e3813 = phi_2423_;
                                                phi_2284_ = _e3807;
                                                phi_2424_ = _e3809;
                                                phi_2425_ = false;
                                                phi_2426_ = _e3811;
                                                phi_2427_ = _e3813;
                                            } else {
                                                phi_2284_ = f32();
                                                phi_2424_ = false;
                                                phi_2425_ = true;
                                                phi_2426_ = false;
                                                phi_2427_ = false;
                                            }
                                            let _e3815 = phi_2284_;
                                            let _e3817 = phi_2424_;
                                            let _e3819 = phi_2425_;
                                            let _e3821 = phi_2426_;
                                            let _e3823 = phi_2427_;
                                            local_35 = _e3819;
                                            local_70 = _e3821;
                                            local_71 = _e3823;
                                            continue;
                                            continuing {
                                                phi_2280_ = _e3726;
                                                phi_2283_ = _e3815;
                                                break if !(_e3817);
                                            }
                                        }
                                        let _e3826 = local_35;
                                        if _e3826 {
                                            let _e3828 = local_36;
                                            let _e3829 = (_e3828 > 1f);
                                            if _e3829 {
                                                phi_2448_ = false;
                                                phi_2449_ = false;
                                                phi_2450_ = false;
                                            } else {
                                                let _e3831 = local_37;
                                                if (_e3831 > _e3271) {
                                                    let _e3834 = local_38;
                                                    let _e3836 = ((_e3834 - _e3271) < 0.00000000023283064f);
                                                    if _e3836 {
                                                        phi_2444_ = false;
                                                    } else {
                                                        phi_2444_ = true;
                                                    }
                                                    let _e3838 = phi_2444_;
                                                    phi_2445_ = _e3838;
                                                    phi_2446_ = _e3836;
                                                    phi_2447_ = false;
                                                } else {
                                                    phi_2445_ = false;
                                                    phi_2446_ = false;
                                                    phi_2447_ = true;
                                                }
                                                let _e3840 = phi_2445_;
                                                let _e3842 = phi_2446_;
                                                let _e3844 = phi_2447_;
                                                phi_2448_ = _e3840;
                                                phi_2449_ = _e3842;
                                                phi_2450_ = _e3844;
                                            }
                                            let _e3846 = phi_2448_;
                                            let _e3848 = phi_2449_;
                                            let _e3850 = phi_2450_;
                                            phi_2451_ = _e3846;
                                            phi_2452_ = _e3829;
                                            phi_2453_ = _e3848;
                                            phi_2454_ = _e3850;
                                            phi_2455_ = false;
                                            phi_2456_ = false;
                                        } else {
                                            phi_2451_ = false;
                                            phi_2452_ = false;
                                            phi_2453_ = false;
                                            phi_2454_ = false;
                                            let _e5466 = local_70;
                                            phi_2455_ = _e5466;
                                            let _e5469 = local_71;
                                            phi_2456_ = _e5469;
                                        }
                                        let _e3852 = phi_2451_;
                                        let _e3854 = phi_2452_;
                                        let _e3856 = phi_2453_;
                                        let _e3858 = phi_2454_;
                                        let _e3860 = phi_2455_;
                                        let _e3862 = phi_2456_;
                                        let _e5472 = local_72;
                                        phi_2457_ = _e5472;
                                        let _e5475 = local_73;
                                        phi_2458_ = _e5475;
                                        phi_2459_ = _e3852;
                                        phi_2460_ = _e3854;
                                        phi_2461_ = _e3856;
                                        phi_2462_ = _e3858;
                                        phi_2463_ = _e3860;
                                        phi_2464_ = _e3862;
                                        phi_2465_ = false;
                                    } else {
                                        phi_2457_ = f32();
                                        phi_2458_ = f32();
                                        phi_2459_ = false;
                                        phi_2460_ = false;
                                        phi_2461_ = false;
                                        phi_2462_ = false;
                                        phi_2463_ = false;
                                        phi_2464_ = false;
                                        phi_2465_ = true;
                                    }
                                    let _e3864 = phi_2457_;
                                    let _e3866 = phi_2458_;
                                    let _e3868 = phi_2459_;
                                    let _e3870 = phi_2460_;
                                    let _e3872 = phi_2461_;
                                    let _e3874 = phi_2462_;
                                    let _e3876 = phi_2463_;
                                    let _e3878 = phi_2464_;
                                    let _e3880 = phi_2465_;
                                    phi_2466_ = _e3864;
                                    phi_2467_ = _e3866;
                                    phi_2468_ = _e3868;
                                    phi_2469_ = _e3870;
                                    phi_2470_ = _e3872;
                                    phi_2471_ = _e3874;
                                    phi_2472_ = _e3876;
                                    phi_2473_ = _e3878;
                                    phi_2474_ = _e3880;
                                    phi_2475_ = false;
                                } else {
                                    phi_2466_ = f32();
                                    phi_2467_ = f32();
                                    phi_2468_ = false;
                                    phi_2469_ = false;
                                    phi_2470_ = false;
                                    phi_2471_ = false;
                                    phi_2472_ = false;
                                    phi_2473_ = false;
                                    phi_2474_ = false;
                                    phi_2475_ = true;
                                }
                                let _e3882 = phi_2466_;
                                let _e3884 = phi_2467_;
                                let _e3886 = phi_2468_;
                                let _e3888 = phi_2469_;
                                let _e3890 = phi_2470_;
                                let _e3892 = phi_2471_;
                                let _e3894 = phi_2472_;
                                let _e3896 = phi_2473_;
                                let _e3898 = phi_2474_;
                                let _e3900 = phi_2475_;
                                phi_2476_ = _e3882;
                                phi_1565_ = _e3884;
                                phi_2477_ = _e3886;
                                phi_2478_ = _e3888;
                                phi_2479_ = _e3890;
                                phi_2480_ = false;
                                phi_2481_ = _e3892;
                                phi_2482_ = _e3894;
                                phi_2483_ = _e3896;
                                phi_2484_ = _e3898;
                                phi_2485_ = _e3900;
                            } else {
                                phi_2476_ = f32();
                                phi_1565_ = f32();
                                phi_2477_ = false;
                                phi_2478_ = false;
                                phi_2479_ = false;
                                phi_2480_ = true;
                                phi_2481_ = false;
                                phi_2482_ = false;
                                phi_2483_ = false;
                                phi_2484_ = false;
                                phi_2485_ = false;
                            }
                            let _e3902 = phi_2476_;
                            let _e3904 = phi_1565_;
                            let _e3906 = phi_2477_;
                            let _e3908 = phi_2478_;
                            let _e3910 = phi_2479_;
                            let _e3912 = phi_2480_;
                            let _e3914 = phi_2481_;
                            let _e3916 = phi_2482_;
                            let _e3918 = phi_2483_;
                            let _e3920 = phi_2484_;
                            let _e3922 = phi_2485_;
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
                                phi_1561_ = _e3285;
                                phi_1564_ = _e3904;
                                break if !(_e3906);
                            }
                        }
                        let _e3925 = local_39;
                        if _e3925 {
                            phi_2490_ = type_56(0u, type_56().member_1);
                            phi_2491_ = false;
                            phi_2492_ = false;
                            phi_2493_ = false;
                            phi_2494_ = false;
                            phi_2495_ = false;
                            phi_2496_ = false;
                            phi_2497_ = false;
                        } else {
                            phi_2490_ = type_56();
                            let _e5508 = local_74;
                            phi_2491_ = _e5508;
                            let _e5511 = local_75;
                            phi_2492_ = _e5511;
                            let _e5514 = local_76;
                            phi_2493_ = _e5514;
                            let _e5517 = local_77;
                            phi_2494_ = _e5517;
                            let _e5520 = local_78;
                            phi_2495_ = _e5520;
                            let _e5523 = local_79;
                            phi_2496_ = _e5523;
                            let _e5526 = local_80;
                            phi_2497_ = _e5526;
                        }
                        let _e3930 = phi_2490_;
                        let _e3932 = phi_2491_;
                        let _e3934 = phi_2492_;
                        let _e3936 = phi_2493_;
                        let _e3938 = phi_2494_;
                        let _e3940 = phi_2495_;
                        let _e3942 = phi_2496_;
                        let _e3944 = phi_2497_;
                        if _e3932 {
                            let _e5529 = local_81;
                            phi_2501_ = _e5529;
                            phi_2502_ = true;
                            phi_2503_ = false;
                            phi_2504_ = false;
                            phi_2505_ = false;
                            phi_2506_ = false;
                            phi_2507_ = false;
                            phi_2508_ = false;
                        } else {
                            let _e5531 = local_82;
                            phi_2501_ = _e5531;
                            phi_2502_ = _e3934;
                            phi_2503_ = _e3936;
                            phi_2504_ = _e3938;
                            phi_2505_ = _e3940;
                            let _e5538 = local_83;
                            phi_2506_ = _e5538;
                            phi_2507_ = _e3942;
                            phi_2508_ = _e3944;
                        }
                        let _e3946 = phi_2501_;
                        let _e3948 = phi_2502_;
                        let _e3950 = phi_2503_;
                        let _e3952 = phi_2504_;
                        let _e3954 = phi_2505_;
                        let _e3956 = phi_2506_;
                        let _e3958 = phi_2507_;
                        let _e3960 = phi_2508_;
                        if _e3948 {
                            phi_2513_ = type_56(1u, _e3946);
                            phi_2514_ = false;
                            phi_2515_ = false;
                            phi_2516_ = false;
                            phi_2517_ = false;
                            phi_2518_ = false;
                            phi_2519_ = false;
                        } else {
                            phi_2513_ = type_56();
                            phi_2514_ = _e3950;
                            phi_2515_ = _e3952;
                            phi_2516_ = _e3954;
                            phi_2517_ = _e3956;
                            phi_2518_ = _e3958;
                            phi_2519_ = _e3960;
                        }
                        let _e3963 = phi_2513_;
                        let _e3965 = phi_2514_;
                        let _e3967 = phi_2515_;
                        let _e3969 = phi_2516_;
                        let _e3971 = phi_2517_;
                        let _e3973 = phi_2518_;
                        let _e3975 = phi_2519_;
                        if _e3965 {
                            let _e3977 = local_40;
                            phi_2524_ = type_56(1u, _e3977);
                            phi_2525_ = false;
                            phi_2526_ = false;
                            phi_2527_ = true;
                            phi_2528_ = false;
                            phi_2529_ = false;
                        } else {
                            phi_2524_ = _e3930;
                            phi_2525_ = _e3967;
                            phi_2526_ = _e3969;
                            phi_2527_ = _e3971;
                            phi_2528_ = _e3973;
                            phi_2529_ = _e3975;
                        }
                        let _e3980 = phi_2524_;
                        let _e3982 = phi_2525_;
                        let _e3984 = phi_2526_;
                        let _e3986 = phi_2527_;
                        let _e3988 = phi_2528_;
                        let _e3990 = phi_2529_;
                        if _e3982 {
                            let _e3992 = local_41;
                            phi_2534_ = type_56(1u, _e3992);
                            phi_2535_ = false;
                            phi_2536_ = false;
                            phi_2537_ = false;
                            phi_2538_ = false;
                        } else {
                            phi_2534_ = type_56();
                            phi_2535_ = _e3984;
                            phi_2536_ = _e3986;
                            phi_2537_ = _e3988;
                            phi_2538_ = _e3990;
                        }
                        let _e3995 = phi_2534_;
                        let _e3997 = phi_2535_;
                        let _e3999 = phi_2536_;
                        let _e4001 = phi_2537_;
                        let _e4003 = phi_2538_;
                        if _e3997 {
                            let _e4005 = local_42;
                            phi_2543_ = type_56(1u, _e4005);
                            phi_2544_ = true;
                            phi_2545_ = false;
                            phi_2546_ = false;
                            phi_2547_ = false;
                        } else {
                            phi_2543_ = _e3995;
                            phi_2544_ = _e3982;
                            phi_2545_ = _e3999;
                            phi_2546_ = _e4001;
                            phi_2547_ = _e4003;
                        }
                        let _e4008 = phi_2543_;
                        let _e4010 = phi_2544_;
                        let _e4012 = phi_2545_;
                        let _e4014 = phi_2546_;
                        let _e4016 = phi_2547_;
                        if _e4010 {
                            phi_2551_ = _e4008;
                            phi_2552_ = true;
                            phi_2553_ = false;
                            phi_2554_ = false;
                        } else {
                            phi_2551_ = _e3980;
                            phi_2552_ = _e4012;
                            phi_2553_ = _e4014;
                            phi_2554_ = _e4016;
                        }
                        let _e4018 = phi_2551_;
                        let _e4020 = phi_2552_;
                        let _e4022 = phi_2553_;
                        let _e4024 = phi_2554_;
                        if _e4020 {
                            phi_2558_ = false;
                            phi_2559_ = false;
                        } else {
                            phi_2558_ = _e4022;
                            phi_2559_ = _e4024;
                        }
                        let _e4026 = phi_2558_;
                        let _e4028 = phi_2559_;
                        if _e4026 {
                            phi_2563_ = false;
                            phi_2564_ = false;
                        } else {
                            phi_2563_ = _e4028;
                            phi_2564_ = _e4020;
                        }
                        let _e4030 = phi_2563_;
                        let _e4032 = phi_2564_;
                        if _e4030 {
                            phi_2568_ = true;
                            phi_2569_ = false;
                        } else {
                            phi_2568_ = _e4026;
                            phi_2569_ = _e4032;
                        }
                        let _e4034 = phi_2568_;
                        let _e4036 = phi_2569_;
                        if _e4034 {
                            let _e4038 = local_43;
                            phi_2574_ = type_56(1u, _e4038);
                            phi_2575_ = true;
                        } else {
                            phi_2574_ = _e4018;
                            phi_2575_ = _e4036;
                        }
                        let _e4041 = phi_2574_;
                        let _e4043 = phi_2575_;
                        if _e4043 {
                            phi_2579_ = _e4041;
                        } else {
                            phi_2579_ = _e3963;
                        }
                        let _e4045 = phi_2579_;
                        if (_e4045.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_2593_ = type_29(0u, 3u);
                            loop {
                                let _e4058 = phi_2593_;
                                if (_e4058.member < _e4058.member_1) {
                                    phi_2594_ = type_29((_e4058.member + 1u), _e4058.member_1);
                                    phi_2617_ = type_29(1u, _e4058.member);
                                } else {
                                    phi_2594_ = _e4058;
                                    phi_2617_ = type_29(0u, type_29().member_1);
                                }
                                let _e4072 = phi_2594_;
                                let _e4074 = phi_2617_;
                                if (bitcast<i32>(_e4074.member) != 0i) {
                                    if (_e4074.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4081 = local_14[_e4074.member_1];
                                    let _e4082 = (_e4045.member_1 + _e4081);
                                    if (_e4082 < 1f) {
                                        phi_2637_ = _e4082;
                                    } else {
                                        phi_2637_ = 1f;
                                    }
                                    let _e4085 = phi_2637_;
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
                                                phi_2785_ = (_e4184 <= 1f);
                                                phi_2786_ = false;
                                            } else {
                                                phi_2785_ = bool();
                                                phi_2786_ = true;
                                            }
                                            let _e4190 = phi_2785_;
                                            let _e4192 = phi_2786_;
                                            phi_2787_ = _e4190;
                                            phi_2788_ = _e4192;
                                        } else {
                                            phi_2787_ = bool();
                                            phi_2788_ = true;
                                        }
                                        let _e4194 = phi_2787_;
                                        let _e4196 = phi_2788_;
                                        phi_2789_ = _e4194;
                                        phi_2790_ = _e4196;
                                    } else {
                                        phi_2789_ = bool();
                                        phi_2790_ = true;
                                    }
                                    let _e4198 = phi_2789_;
                                    let _e4200 = phi_2790_;
                                    if _e4200 {
                                        phi_2794_ = false;
                                    } else {
                                        phi_2794_ = _e4198;
                                    }
                                    let _e4202 = phi_2794_;
                                    if (_e4176 > 0f) {
                                        if _e4202 {
                                            phi_2834_ = array<f32, 3>((_e4104 - ((_e4125 * _e4180) + (_e4146 * _e4184))), (_e4105 - ((_e4126 * _e4180) + (_e4147 * _e4184))), (_e4106 - ((_e4127 * _e4180) + (_e4148 * _e4184))));
                                            phi_2835_ = false;
                                        } else {
                                            phi_2834_ = array<f32, 3>();
                                            phi_2835_ = true;
                                        }
                                        let _e4218 = phi_2834_;
                                        let _e4220 = phi_2835_;
                                        phi_2836_ = _e4218;
                                        phi_2837_ = _e4220;
                                    } else {
                                        phi_2836_ = array<f32, 3>();
                                        phi_2837_ = true;
                                    }
                                    let _e4222 = phi_2836_;
                                    let _e4224 = phi_2837_;
                                    if _e4224 {
                                        let _e4225 = (_e4104 - _e4125);
                                        let _e4226 = (_e4105 - _e4126);
                                        let _e4227 = (_e4106 - _e4127);
                                        let _e4238 = ((((_e4104 * _e4125) + (_e4105 * _e4126)) + (_e4106 * _e4127)) / (((_e4125 * _e4125) + (_e4126 * _e4126)) + (_e4127 * _e4127)));
                                        if (_e4238 > 0f) {
                                            if (_e4238 < 1f) {
                                                phi_2867_ = _e4238;
                                            } else {
                                                phi_2867_ = 1f;
                                            }
                                            let _e4242 = phi_2867_;
                                            phi_2868_ = _e4242;
                                        } else {
                                            phi_2868_ = 0f;
                                        }
                                        let _e4244 = phi_2868_;
                                        let _e4261 = ((((_e4104 * _e4146) + (_e4105 * _e4147)) + (_e4106 * _e4148)) / (((_e4146 * _e4146) + (_e4147 * _e4147)) + (_e4148 * _e4148)));
                                        if (_e4261 > 0f) {
                                            if (_e4261 < 1f) {
                                                phi_2895_ = _e4261;
                                            } else {
                                                phi_2895_ = 1f;
                                            }
                                            let _e4265 = phi_2895_;
                                            phi_2896_ = _e4265;
                                        } else {
                                            phi_2896_ = 0f;
                                        }
                                        let _e4267 = phi_2896_;
                                        let _e4284 = ((((_e4225 * _e4146) + (_e4226 * _e4147)) + (_e4227 * _e4148)) / (((_e4146 * _e4146) + (_e4147 * _e4147)) + (_e4148 * _e4148)));
                                        if (_e4284 > 0f) {
                                            if (_e4284 < 1f) {
                                                phi_2923_ = _e4284;
                                            } else {
                                                phi_2923_ = 1f;
                                            }
                                            let _e4288 = phi_2923_;
                                            phi_2924_ = _e4288;
                                        } else {
                                            phi_2924_ = 0f;
                                        }
                                        let _e4290 = phi_2924_;
                                        let _e4297 = (_e4104 - _e4146);
                                        let _e4298 = (_e4105 - _e4147);
                                        let _e4299 = (_e4106 - _e4148);
                                        let _e4310 = ((((_e4297 * _e4125) + (_e4298 * _e4126)) + (_e4299 * _e4127)) / (((_e4125 * _e4125) + (_e4126 * _e4126)) + (_e4127 * _e4127)));
                                        if (_e4310 > 0f) {
                                            if (_e4310 < 1f) {
                                                phi_2954_ = _e4310;
                                            } else {
                                                phi_2954_ = 1f;
                                            }
                                            let _e4314 = phi_2954_;
                                            phi_2955_ = _e4314;
                                        } else {
                                            phi_2955_ = 0f;
                                        }
                                        let _e4316 = phi_2955_;
                                        local_10[0u] = array<f32, 3>((_e4104 - (_e4125 * _e4244)), (_e4105 - (_e4126 * _e4244)), (_e4106 - (_e4127 * _e4244)));
                                        local_10[1u] = array<f32, 3>((_e4104 - (_e4146 * _e4267)), (_e4105 - (_e4147 * _e4267)), (_e4106 - (_e4148 * _e4267)));
                                        local_10[2u] = array<f32, 3>((_e4225 - (_e4146 * _e4290)), (_e4226 - (_e4147 * _e4290)), (_e4227 - (_e4148 * _e4290)));
                                        local_10[3u] = array<f32, 3>((_e4297 - (_e4125 * _e4316)), (_e4298 - (_e4126 * _e4316)), (_e4299 - (_e4127 * _e4316)));
                                        let _e4332 = local_10[0u];
                                        phi_3098_ = type_29(1u, 4u);
                                        phi_3101_ = array<f32, 3>(_e4332[0], _e4332[1], _e4332[2]);
                                        loop {
                                            let _e4338 = phi_3098_;
                                            let _e4340 = phi_3101_;
                                            local_84 = _e4340;
                                            if (_e4338.member < _e4338.member_1) {
                                                phi_3099_ = type_29((_e4338.member + 1u), _e4338.member_1);
                                                phi_3124_ = type_29(1u, _e4338.member);
                                            } else {
                                                phi_3099_ = _e4338;
                                                phi_3124_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e4354 = phi_3099_;
                                            let _e4356 = phi_3124_;
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
                                                    phi_3191_ = array<f32, 3>(_e4392[0], _e4392[1], _e4392[2]);
                                                } else {
                                                    phi_3191_ = _e4340;
                                                }
                                                let _e4398 = phi_3191_;
                                                phi_3102_ = _e4398;
                                            } else {
                                                phi_3102_ = array<f32, 3>();
                                            }
                                            let _e4400 = phi_3102_;
                                            continue;
                                            continuing {
                                                phi_3098_ = _e4354;
                                                phi_3101_ = _e4400;
                                                break if !(_e4360);
                                            }
                                        }
                                        let _e5612 = local_84;
                                        phi_3192_ = _e5612;
                                    } else {
                                        phi_3192_ = _e4222;
                                    }
                                    let _e4403 = phi_3192_;
                                    let _e4414 = (((_e4403[0] * _e4403[0]) + (_e4403[1] * _e4403[1])) + (_e4403[2] * _e4403[2]));
                                    if (_e4414 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4414 > 0f) {
                                            phi_3217_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3217_ = 0f;
                                        }
                                        let _e4473 = phi_3217_;
                                        phi_3281_ = _e4473;
                                    } else {
                                        phi_3224_ = type_27(0i, 5i);
                                        phi_3227_ = bitcast<f32>(((bitcast<u32>(_e4414) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4422 = phi_3224_;
                                            let _e4424 = phi_3227_;
                                            local_44 = _e4424;
                                            if (_e4422.member < _e4422.member_1) {
                                                let _e4432 = (_e4422.member + 1i);
                                                if ((false == (_e4432 > _e4422.member)) != false) {
                                                    phi_3248_ = true;
                                                } else {
                                                    phi_3248_ = false;
                                                }
                                                let _e4437 = phi_3248_;
                                                if _e4437 {
                                                    phi_3254_ = type_28(0u, type_28().member_1);
                                                } else {
                                                    phi_3254_ = type_28(1u, _e4432);
                                                }
                                                let _e4443 = phi_3254_;
                                                if (bitcast<i32>(_e4443.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3225_ = type_27(_e4443.member_1, _e4422.member_1);
                                                phi_3268_ = type_28(1u, _e4422.member);
                                            } else {
                                                phi_3225_ = _e4422;
                                                phi_3268_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4453 = phi_3225_;
                                            let _e4455 = phi_3268_;
                                            let _e4458 = (bitcast<i32>(_e4455.member) != 0i);
                                            if _e4458 {
                                                phi_3228_ = (0.5f * (_e4424 + (_e4414 / _e4424)));
                                            } else {
                                                phi_3228_ = f32();
                                            }
                                            let _e4463 = phi_3228_;
                                            continue;
                                            continuing {
                                                phi_3224_ = _e4453;
                                                phi_3227_ = _e4463;
                                                break if !(_e4458);
                                            }
                                        }
                                        let _e4468 = local_44;
                                        phi_3281_ = (_e4468 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e4475 = phi_3281_;
                                    let _e4481 = local_15.member[0u];
                                    if (_e4481[0] < 0f) {
                                        phi_3297_ = -(_e4481[0]);
                                    } else {
                                        phi_3297_ = _e4481[0];
                                    }
                                    let _e4488 = phi_3297_;
                                    if (_e4481[1] < 0f) {
                                        phi_3304_ = -(_e4481[1]);
                                    } else {
                                        phi_3304_ = _e4481[1];
                                    }
                                    let _e4492 = phi_3304_;
                                    if (_e4488 > _e4492) {
                                        phi_3309_ = _e4488;
                                    } else {
                                        phi_3309_ = _e4492;
                                    }
                                    let _e4495 = phi_3309_;
                                    if (_e4481[2] < 0f) {
                                        phi_3316_ = -(_e4481[2]);
                                    } else {
                                        phi_3316_ = _e4481[2];
                                    }
                                    let _e4499 = phi_3316_;
                                    if (_e4495 > _e4499) {
                                        phi_3321_ = _e4495;
                                    } else {
                                        phi_3321_ = _e4499;
                                    }
                                    let _e4502 = phi_3321_;
                                    let _e4505 = local_15.member[1u];
                                    if (_e4505[0] < 0f) {
                                        phi_3334_ = -(_e4505[0]);
                                    } else {
                                        phi_3334_ = _e4505[0];
                                    }
                                    let _e4512 = phi_3334_;
                                    if (_e4505[1] < 0f) {
                                        phi_3341_ = -(_e4505[1]);
                                    } else {
                                        phi_3341_ = _e4505[1];
                                    }
                                    let _e4516 = phi_3341_;
                                    if (_e4512 > _e4516) {
                                        phi_3346_ = _e4512;
                                    } else {
                                        phi_3346_ = _e4516;
                                    }
                                    let _e4519 = phi_3346_;
                                    if (_e4505[2] < 0f) {
                                        phi_3353_ = -(_e4505[2]);
                                    } else {
                                        phi_3353_ = _e4505[2];
                                    }
                                    let _e4523 = phi_3353_;
                                    if (_e4519 > _e4523) {
                                        phi_3358_ = _e4519;
                                    } else {
                                        phi_3358_ = _e4523;
                                    }
                                    let _e4526 = phi_3358_;
                                    if (_e4502 > _e4526) {
                                        phi_3363_ = _e4502;
                                    } else {
                                        phi_3363_ = _e4526;
                                    }
                                    let _e4529 = phi_3363_;
                                    let _e4531 = local_15.member_3;
                                    let _e4535 = local_15.member_1[0u];
                                    if (_e4535[0] < 0f) {
                                        phi_3380_ = -(_e4535[0]);
                                    } else {
                                        phi_3380_ = _e4535[0];
                                    }
                                    let _e4542 = phi_3380_;
                                    if (_e4535[1] < 0f) {
                                        phi_3387_ = -(_e4535[1]);
                                    } else {
                                        phi_3387_ = _e4535[1];
                                    }
                                    let _e4546 = phi_3387_;
                                    if (_e4542 > _e4546) {
                                        phi_3392_ = _e4542;
                                    } else {
                                        phi_3392_ = _e4546;
                                    }
                                    let _e4549 = phi_3392_;
                                    if (_e4535[2] < 0f) {
                                        phi_3399_ = -(_e4535[2]);
                                    } else {
                                        phi_3399_ = _e4535[2];
                                    }
                                    let _e4553 = phi_3399_;
                                    if (_e4549 > _e4553) {
                                        phi_3404_ = _e4549;
                                    } else {
                                        phi_3404_ = _e4553;
                                    }
                                    let _e4556 = phi_3404_;
                                    let _e4559 = local_15.member_1[1u];
                                    if (_e4559[0] < 0f) {
                                        phi_3418_ = -(_e4559[0]);
                                    } else {
                                        phi_3418_ = _e4559[0];
                                    }
                                    let _e4566 = phi_3418_;
                                    if (_e4559[1] < 0f) {
                                        phi_3425_ = -(_e4559[1]);
                                    } else {
                                        phi_3425_ = _e4559[1];
                                    }
                                    let _e4570 = phi_3425_;
                                    if (_e4566 > _e4570) {
                                        phi_3430_ = _e4566;
                                    } else {
                                        phi_3430_ = _e4570;
                                    }
                                    let _e4573 = phi_3430_;
                                    if (_e4559[2] < 0f) {
                                        phi_3437_ = -(_e4559[2]);
                                    } else {
                                        phi_3437_ = _e4559[2];
                                    }
                                    let _e4577 = phi_3437_;
                                    if (_e4573 > _e4577) {
                                        phi_3442_ = _e4573;
                                    } else {
                                        phi_3442_ = _e4577;
                                    }
                                    let _e4580 = phi_3442_;
                                    if (_e4556 > _e4580) {
                                        phi_3447_ = _e4556;
                                    } else {
                                        phi_3447_ = _e4580;
                                    }
                                    let _e4583 = phi_3447_;
                                    let _e4585 = local_15.member_3;
                                    let _e4589 = local_15.member_2[0u];
                                    if (_e4589[0] < 0f) {
                                        phi_3464_ = -(_e4589[0]);
                                    } else {
                                        phi_3464_ = _e4589[0];
                                    }
                                    let _e4596 = phi_3464_;
                                    if (_e4589[1] < 0f) {
                                        phi_3471_ = -(_e4589[1]);
                                    } else {
                                        phi_3471_ = _e4589[1];
                                    }
                                    let _e4600 = phi_3471_;
                                    if (_e4596 > _e4600) {
                                        phi_3476_ = _e4596;
                                    } else {
                                        phi_3476_ = _e4600;
                                    }
                                    let _e4603 = phi_3476_;
                                    if (_e4589[2] < 0f) {
                                        phi_3483_ = -(_e4589[2]);
                                    } else {
                                        phi_3483_ = _e4589[2];
                                    }
                                    let _e4607 = phi_3483_;
                                    if (_e4603 > _e4607) {
                                        phi_3488_ = _e4603;
                                    } else {
                                        phi_3488_ = _e4607;
                                    }
                                    let _e4610 = phi_3488_;
                                    let _e4613 = local_15.member_2[1u];
                                    if (_e4613[0] < 0f) {
                                        phi_3502_ = -(_e4613[0]);
                                    } else {
                                        phi_3502_ = _e4613[0];
                                    }
                                    let _e4620 = phi_3502_;
                                    if (_e4613[1] < 0f) {
                                        phi_3509_ = -(_e4613[1]);
                                    } else {
                                        phi_3509_ = _e4613[1];
                                    }
                                    let _e4624 = phi_3509_;
                                    if (_e4620 > _e4624) {
                                        phi_3514_ = _e4620;
                                    } else {
                                        phi_3514_ = _e4624;
                                    }
                                    let _e4627 = phi_3514_;
                                    if (_e4613[2] < 0f) {
                                        phi_3521_ = -(_e4613[2]);
                                    } else {
                                        phi_3521_ = _e4613[2];
                                    }
                                    let _e4631 = phi_3521_;
                                    if (_e4627 > _e4631) {
                                        phi_3526_ = _e4627;
                                    } else {
                                        phi_3526_ = _e4631;
                                    }
                                    let _e4634 = phi_3526_;
                                    if (_e4610 > _e4634) {
                                        phi_3531_ = _e4610;
                                    } else {
                                        phi_3531_ = _e4634;
                                    }
                                    let _e4637 = phi_3531_;
                                    let _e4639 = local_15.member_3;
                                    let _e4646 = local_15.member_3;
                                    let _e4653 = (((_e4475 * (1f + (0.000000059604645f * 8f))) + (((((((_e4529 + _e4531) + (_e4583 + _e4585)) + (_e4637 + _e4639)) * (0.000000059604645f * 16f)) + (_e4646 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e267);
                                    if _e4653 {
                                        phi_3551_ = false;
                                    } else {
                                        phi_3551_ = true;
                                    }
                                    let _e4655 = phi_3551_;
                                    phi_3552_ = _e4655;
                                    phi_3553_ = _e4653;
                                } else {
                                    phi_3552_ = false;
                                    phi_3553_ = false;
                                }
                                let _e4657 = phi_3552_;
                                let _e4659 = phi_3553_;
                                local_45 = _e4659;
                                continue;
                                continuing {
                                    phi_2593_ = _e4072;
                                    break if !(_e4657);
                                }
                            }
                            let _e4662 = local_45;
                            if _e4662 {
                                phi_3558_ = type_56(1u, _e4045.member_1);
                                phi_3559_ = false;
                            } else {
                                phi_3558_ = type_56();
                                phi_3559_ = true;
                            }
                            let _e4665 = phi_3558_;
                            let _e4667 = phi_3559_;
                            if _e4667 {
                                phi_3564_ = type_56(2u, _e4045.member_1);
                                phi_3565_ = false;
                            } else {
                                phi_3564_ = type_56();
                                phi_3565_ = true;
                            }
                            let _e4670 = phi_3564_;
                            let _e4672 = phi_3565_;
                            phi_3567_ = _e4670;
                            phi_3568_ = _e4665;
                            phi_3569_ = _e4672;
                        } else {
                            phi_3567_ = type_56();
                            phi_3568_ = type_56(0u, type_56().member_1);
                            phi_3569_ = true;
                        }
                        let _e4674 = phi_3567_;
                        let _e4676 = phi_3568_;
                        let _e4678 = phi_3569_;
                        if _e4678 {
                            phi_3573_ = _e4676;
                        } else {
                            phi_3573_ = _e4674;
                        }
                        let _e4680 = phi_3573_;
                        phi_6847_ = _e4680;
                    } else {
                        if (_e365 < 0f) {
                            phi_3583_ = -(_e365);
                        } else {
                            phi_3583_ = _e365;
                        }
                        let _e708 = phi_3583_;
                        if (_e388 < 0f) {
                            phi_3589_ = -(_e388);
                        } else {
                            phi_3589_ = _e388;
                        }
                        let _e712 = phi_3589_;
                        if (_e708 > _e712) {
                            phi_3594_ = _e708;
                        } else {
                            phi_3594_ = _e712;
                        }
                        let _e715 = phi_3594_;
                        if (_e411 < 0f) {
                            phi_3600_ = -(_e411);
                        } else {
                            phi_3600_ = _e411;
                        }
                        let _e719 = phi_3600_;
                        if (_e422 < 0f) {
                            phi_3606_ = -(_e422);
                        } else {
                            phi_3606_ = _e422;
                        }
                        let _e723 = phi_3606_;
                        if (_e719 > _e723) {
                            phi_3611_ = _e719;
                        } else {
                            phi_3611_ = _e723;
                        }
                        let _e726 = phi_3611_;
                        if (_e715 > _e726) {
                            phi_3616_ = _e715;
                        } else {
                            phi_3616_ = _e726;
                        }
                        let _e729 = phi_3616_;
                        let _e730 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e729 >= _e730) {
                            phi_3624_ = (_e729 <= (1f / _e730));
                        } else {
                            phi_3624_ = false;
                        }
                        let _e735 = phi_3624_;
                        if _e735 {
                            phi_3629_ = (0.000000059604645f * 256f);
                        } else {
                            phi_3629_ = 2f;
                        }
                        let _e738 = phi_3629_;
                        let _e740 = ((_e672 * 0.34f) + (_e729 * _e738));
                        if _e735 {
                            phi_3636_ = (1f / _e729);
                        } else {
                            phi_3636_ = 0f;
                        }
                        let _e743 = phi_3636_;
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
                                    phi_3669_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_3669_ = 0f;
                                }
                                let _e818 = phi_3669_;
                                phi_3733_ = _e818;
                            } else {
                                phi_3676_ = type_27(0i, 5i);
                                phi_3679_ = bitcast<f32>(((bitcast<u32>(_e758) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e767 = phi_3676_;
                                    let _e769 = phi_3679_;
                                    local_16 = _e769;
                                    if (_e767.member < _e767.member_1) {
                                        let _e777 = (_e767.member + 1i);
                                        if ((false == (_e777 > _e767.member)) != false) {
                                            phi_3700_ = true;
                                        } else {
                                            phi_3700_ = false;
                                        }
                                        let _e782 = phi_3700_;
                                        if _e782 {
                                            phi_3706_ = type_28(0u, type_28().member_1);
                                        } else {
                                            phi_3706_ = type_28(1u, _e777);
                                        }
                                        let _e788 = phi_3706_;
                                        if (bitcast<i32>(_e788.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_3677_ = type_27(_e788.member_1, _e767.member_1);
                                        phi_3720_ = type_28(1u, _e767.member);
                                    } else {
                                        phi_3677_ = _e767;
                                        phi_3720_ = type_28(0u, type_28().member_1);
                                    }
                                    let _e798 = phi_3677_;
                                    let _e800 = phi_3720_;
                                    let _e803 = (bitcast<i32>(_e800.member) != 0i);
                                    if _e803 {
                                        phi_3680_ = (0.5f * (_e769 + (_e758 / _e769)));
                                    } else {
                                        phi_3680_ = f32();
                                    }
                                    let _e808 = phi_3680_;
                                    continue;
                                    continuing {
                                        phi_3676_ = _e798;
                                        phi_3679_ = _e808;
                                        break if !(_e803);
                                    }
                                }
                                let _e813 = local_16;
                                phi_3733_ = (_e813 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e820 = phi_3733_;
                            if (_e750 < 0f) {
                                phi_3739_ = -(_e820);
                            } else {
                                phi_3739_ = _e820;
                            }
                            let _e824 = phi_3739_;
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
                            phi_3764_ = type_29(0u, 2u);
                            phi_3767_ = 1u;
                            loop {
                                let _e845 = phi_3764_;
                                let _e847 = phi_3767_;
                                local_46 = _e847;
                                if (_e845.member < _e845.member_1) {
                                    phi_3765_ = type_29((_e845.member + 1u), _e845.member_1);
                                    phi_3790_ = type_29(1u, _e845.member);
                                } else {
                                    phi_3765_ = _e845;
                                    phi_3790_ = type_29(0u, type_29().member_1);
                                }
                                let _e861 = phi_3765_;
                                let _e863 = phi_3790_;
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
                                            phi_3834_ = (_e847 + 1u);
                                        } else {
                                            phi_3834_ = _e847;
                                        }
                                        let _e883 = phi_3834_;
                                        phi_3835_ = _e883;
                                    } else {
                                        phi_3835_ = _e847;
                                    }
                                    let _e885 = phi_3835_;
                                    phi_3768_ = _e885;
                                } else {
                                    phi_3768_ = u32();
                                }
                                let _e887 = phi_3768_;
                                continue;
                                continuing {
                                    phi_3764_ = _e861;
                                    phi_3767_ = _e887;
                                    break if !(_e867);
                                }
                            }
                            let _e4890 = local_46;
                            phi_3836_ = _e4890;
                        } else {
                            phi_3836_ = 1u;
                        }
                        let _e890 = phi_3836_;
                        if (_e890 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e890] = 1f;
                        let _e893 = local_7;
                        local_9 = _e893;
                        phi_3856_ = type_29(0u, _e890);
                        loop {
                            let _e896 = phi_3856_;
                            if (_e896.member < _e896.member_1) {
                                phi_3857_ = type_29((_e896.member + 1u), _e896.member_1);
                                phi_3880_ = type_29(1u, _e896.member);
                            } else {
                                phi_3857_ = _e896;
                                phi_3880_ = type_29(0u, type_29().member_1);
                            }
                            let _e910 = phi_3857_;
                            let _e912 = phi_3880_;
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
                                    phi_3932_ = -(_e935);
                                } else {
                                    phi_3932_ = _e935;
                                }
                                let _e951 = phi_3932_;
                                let _e952 = (_e951 > _e740);
                                if (_e947 < 0f) {
                                    phi_3939_ = -(_e947);
                                } else {
                                    phi_3939_ = _e947;
                                }
                                let _e956 = phi_3939_;
                                let _e957 = (_e956 > _e740);
                                if _e952 {
                                    if _e957 {
                                        phi_3950_ = ((_e935 > 0f) != (_e947 > 0f));
                                        phi_3951_ = false;
                                    } else {
                                        phi_3950_ = bool();
                                        phi_3951_ = true;
                                    }
                                    let _e962 = phi_3950_;
                                    let _e964 = phi_3951_;
                                    phi_3952_ = _e962;
                                    phi_3953_ = _e964;
                                } else {
                                    phi_3952_ = bool();
                                    phi_3953_ = true;
                                }
                                let _e966 = phi_3952_;
                                let _e968 = phi_3953_;
                                if _e968 {
                                    phi_3957_ = false;
                                } else {
                                    phi_3957_ = _e966;
                                }
                                let _e970 = phi_3957_;
                                if _e952 {
                                    if _e957 {
                                        if _e970 {
                                            phi_3968_ = type_57();
                                        } else {
                                            phi_3968_ = type_57(1f, 0f, _e970);
                                        }
                                        let _e973 = phi_3968_;
                                        phi_3969_ = _e973;
                                        phi_3970_ = _e970;
                                    } else {
                                        phi_3969_ = type_57();
                                        phi_3970_ = true;
                                    }
                                    let _e975 = phi_3969_;
                                    let _e977 = phi_3970_;
                                    phi_3971_ = _e975;
                                    phi_3972_ = _e977;
                                } else {
                                    phi_3971_ = type_57();
                                    phi_3972_ = true;
                                }
                                let _e979 = phi_3971_;
                                let _e981 = phi_3972_;
                                if _e981 {
                                    if _e952 {
                                        if (_e935 < 0f) {
                                            phi_3983_ = -1f;
                                        } else {
                                            phi_3983_ = 1f;
                                        }
                                        let _e984 = phi_3983_;
                                        let _e987 = (_e411 - _e388);
                                        phi_3993_ = type_29(0u, 64u);
                                        phi_3996_ = _e923;
                                        phi_3998_ = _e919;
                                        phi_4000_ = (0.5f * (_e919 + _e923));
                                        loop {
                                            let _e993 = phi_3993_;
                                            let _e995 = phi_3996_;
                                            let _e997 = phi_3998_;
                                            let _e999 = phi_4000_;
                                            local_48 = _e997;
                                            if (_e993.member < _e993.member_1) {
                                                phi_3994_ = type_29((_e993.member + 1u), _e993.member_1);
                                                phi_4023_ = type_29(1u, _e993.member);
                                            } else {
                                                phi_3994_ = _e993;
                                                phi_4023_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1013 = phi_3994_;
                                            let _e1015 = phi_4023_;
                                            if (bitcast<i32>(_e1015.member) != 0i) {
                                                let _e1019 = (1f - _e999);
                                                let _e1032 = ((_e984 * ((((_e365 * _e1019) + (_e388 * _e999)) * (_e1019 * _e1019)) + (((_e411 * _e1019) + (_e422 * _e999)) * (_e999 * _e999)))) - _e740);
                                                if (_e1032 > 0f) {
                                                    phi_4048_ = _e995;
                                                    phi_4049_ = _e999;
                                                } else {
                                                    phi_4048_ = _e999;
                                                    phi_4049_ = _e997;
                                                }
                                                let _e1035 = phi_4048_;
                                                let _e1037 = phi_4049_;
                                                let _e1039 = ((_e1035 - _e1037) > 0.00000000000022737368f);
                                                if _e1039 {
                                                    let _e1040 = (1f - _e999);
                                                    let _e1052 = (-(_e1032) / (_e984 * (((((_e388 - (3f * _e365)) * _e1040) + (_e987 * _e999)) * _e1040) + (((_e987 * _e1040) + (((3f * _e422) - _e411) * _e999)) * _e999))));
                                                    if (_e1032 > 0f) {
                                                        phi_4075_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_4075_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1058 = phi_4075_;
                                                    let _e1060 = ((_e999 + _e1052) + _e1058);
                                                    if (_e1060 > _e1037) {
                                                        if (_e1060 < _e1035) {
                                                            if (_e1052 < 0f) {
                                                                phi_4091_ = -(_e1052);
                                                            } else {
                                                                phi_4091_ = _e1052;
                                                            }
                                                            let _e1066 = phi_4091_;
                                                            if (_e1066 < (0.5f * (_e1035 - _e1037))) {
                                                                phi_4098_ = false;
                                                            } else {
                                                                phi_4098_ = true;
                                                            }
                                                            let _e1071 = phi_4098_;
                                                            phi_4099_ = _e1071;
                                                        } else {
                                                            phi_4099_ = true;
                                                        }
                                                        let _e1073 = phi_4099_;
                                                        phi_4100_ = _e1073;
                                                    } else {
                                                        phi_4100_ = true;
                                                    }
                                                    let _e1075 = phi_4100_;
                                                    if _e1075 {
                                                        phi_4106_ = (0.5f * (_e1037 + _e1035));
                                                    } else {
                                                        phi_4106_ = _e1060;
                                                    }
                                                    let _e1079 = phi_4106_;
                                                    phi_4107_ = _e1079;
                                                    phi_4108_ = false;
                                                } else {
                                                    phi_4107_ = f32();
                                                    phi_4108_ = true;
                                                }
                                                let _e1081 = phi_4107_;
                                                let _e1083 = phi_4108_;
                                                phi_3997_ = _e1035;
                                                phi_3999_ = _e1037;
                                                phi_4001_ = _e1081;
                                                phi_4109_ = _e1037;
                                                phi_4110_ = _e1039;
                                                phi_4111_ = _e1083;
                                            } else {
                                                phi_3997_ = f32();
                                                phi_3999_ = f32();
                                                phi_4001_ = f32();
                                                phi_4109_ = f32();
                                                phi_4110_ = false;
                                                phi_4111_ = false;
                                            }
                                            let _e1085 = phi_3997_;
                                            let _e1087 = phi_3999_;
                                            let _e1089 = phi_4001_;
                                            let _e1091 = phi_4109_;
                                            let _e1093 = phi_4110_;
                                            let _e1095 = phi_4111_;
                                            local_17 = _e1095;
                                            local_47 = _e1091;
                                            continue;
                                            continuing {
                                                phi_3993_ = _e1013;
                                                phi_3996_ = _e1085;
                                                phi_3998_ = _e1087;
                                                phi_4000_ = _e1089;
                                                break if !(_e1093);
                                            }
                                        }
                                        let _e1098 = local_17;
                                        if _e1098 {
                                            let _e4932 = local_47;
                                            phi_4115_ = _e4932;
                                        } else {
                                            let _e4934 = local_48;
                                            phi_4115_ = _e4934;
                                        }
                                        let _e1100 = phi_4115_;
                                        phi_4116_ = _e1100;
                                    } else {
                                        phi_4116_ = _e919;
                                    }
                                    let _e1102 = phi_4116_;
                                    if _e957 {
                                        phi_4123_ = type_29(0u, 64u);
                                        phi_4126_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1105 = phi_4123_;
                                            let _e1107 = phi_4126_;
                                            if (_e1105.member < _e1105.member_1) {
                                                phi_4124_ = type_29((_e1105.member + 1u), _e1105.member_1);
                                                phi_4149_ = type_29(1u, _e1105.member);
                                            } else {
                                                phi_4124_ = _e1105;
                                                phi_4149_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1121 = phi_4124_;
                                            let _e1123 = phi_4149_;
                                            if (bitcast<i32>(_e1123.member) != 0i) {
                                                let _e1127 = (_e1102 + _e1107);
                                                if (_e1127 < _e923) {
                                                    let _e1129 = (1f - _e1127);
                                                    let _e1140 = ((((_e365 * _e1129) + (_e388 * _e1127)) * (_e1129 * _e1129)) + (((_e411 * _e1129) + (_e422 * _e1127)) * (_e1127 * _e1127)));
                                                    let _e1141 = (1f - _e1102);
                                                    let _e1152 = ((((_e365 * _e1141) + (_e388 * _e1102)) * (_e1141 * _e1141)) + (((_e411 * _e1141) + (_e422 * _e1102)) * (_e1102 * _e1102)));
                                                    if (_e1140 < 0f) {
                                                        phi_4190_ = -(_e1140);
                                                    } else {
                                                        phi_4190_ = _e1140;
                                                    }
                                                    let _e1156 = phi_4190_;
                                                    if (_e1156 > _e740) {
                                                        if (_e1152 < 0f) {
                                                            phi_4200_ = -(_e1152);
                                                        } else {
                                                            phi_4200_ = _e1152;
                                                        }
                                                        let _e1161 = phi_4200_;
                                                        if (_e1161 > _e740) {
                                                            phi_4208_ = ((_e1140 > 0f) == (_e1152 > 0f));
                                                        } else {
                                                            phi_4208_ = false;
                                                        }
                                                        let _e1167 = phi_4208_;
                                                        phi_4210_ = !(_e1167);
                                                    } else {
                                                        phi_4210_ = false;
                                                    }
                                                    let _e1170 = phi_4210_;
                                                    if _e1170 {
                                                        phi_4215_ = f32();
                                                        phi_4216_ = false;
                                                    } else {
                                                        phi_4215_ = (_e1107 + _e1107);
                                                        phi_4216_ = true;
                                                    }
                                                    let _e1173 = phi_4215_;
                                                    let _e1175 = phi_4216_;
                                                    phi_4217_ = _e1173;
                                                    phi_4218_ = _e1175;
                                                    phi_4219_ = _e1170;
                                                    phi_4220_ = false;
                                                } else {
                                                    phi_4217_ = f32();
                                                    phi_4218_ = false;
                                                    phi_4219_ = false;
                                                    phi_4220_ = true;
                                                }
                                                let _e1177 = phi_4217_;
                                                let _e1179 = phi_4218_;
                                                let _e1181 = phi_4219_;
                                                let _e1183 = phi_4220_;
                                                phi_4221_ = _e1127;
                                                phi_4127_ = _e1177;
                                                phi_4222_ = _e1179;
                                                phi_4223_ = _e1181;
                                                phi_4224_ = _e1183;
                                                phi_4225_ = false;
                                            } else {
                                                phi_4221_ = f32();
                                                phi_4127_ = f32();
                                                phi_4222_ = false;
                                                phi_4223_ = false;
                                                phi_4224_ = false;
                                                phi_4225_ = true;
                                            }
                                            let _e1185 = phi_4221_;
                                            let _e1187 = phi_4127_;
                                            let _e1189 = phi_4222_;
                                            let _e1191 = phi_4223_;
                                            let _e1193 = phi_4224_;
                                            let _e1195 = phi_4225_;
                                            local_18 = _e1191;
                                            local_49 = _e1193;
                                            local_50 = _e1195;
                                            local_51 = _e1185;
                                            continue;
                                            continuing {
                                                phi_4123_ = _e1121;
                                                phi_4126_ = _e1187;
                                                break if !(_e1189);
                                            }
                                        }
                                        let _e1198 = local_18;
                                        if _e1198 {
                                            phi_4229_ = false;
                                            phi_4230_ = false;
                                        } else {
                                            let _e4959 = local_49;
                                            phi_4229_ = _e4959;
                                            let _e4962 = local_50;
                                            phi_4230_ = _e4962;
                                        }
                                        let _e1200 = phi_4229_;
                                        let _e1202 = phi_4230_;
                                        if _e1200 {
                                            phi_4234_ = true;
                                        } else {
                                            phi_4234_ = _e1202;
                                        }
                                        let _e1204 = phi_4234_;
                                        if _e1204 {
                                            phi_4238_ = _e923;
                                        } else {
                                            let _e4966 = local_51;
                                            phi_4238_ = _e4966;
                                        }
                                        let _e1206 = phi_4238_;
                                        phi_4239_ = _e1206;
                                    } else {
                                        phi_4239_ = _e923;
                                    }
                                    let _e1208 = phi_4239_;
                                    phi_4241_ = type_57(_e1102, _e1208, _e970);
                                } else {
                                    phi_4241_ = _e979;
                                }
                                let _e1211 = phi_4241_;
                                if (_e1211.member > _e1211.member_1) {
                                    phi_6803_ = f32();
                                    phi_6804_ = true;
                                    phi_6805_ = false;
                                    phi_6806_ = false;
                                    phi_6807_ = false;
                                } else {
                                    let _e1218 = ((_e1211.member_1 - _e1211.member) * 0.5f);
                                    let _e1219 = (_e1211.member + _e1218);
                                    let _e1221 = (_e1218 + (0.000000059604645f * 4f));
                                    let _e1223 = local_15.member_3;
                                    let _e1226 = local_15.member[0u];
                                    if (_e1226[0] < 0f) {
                                        phi_4270_ = -(_e1226[0]);
                                    } else {
                                        phi_4270_ = _e1226[0];
                                    }
                                    let _e1233 = phi_4270_;
                                    if (_e1226[1] < 0f) {
                                        phi_4277_ = -(_e1226[1]);
                                    } else {
                                        phi_4277_ = _e1226[1];
                                    }
                                    let _e1237 = phi_4277_;
                                    if (_e1233 > _e1237) {
                                        phi_4282_ = _e1233;
                                    } else {
                                        phi_4282_ = _e1237;
                                    }
                                    let _e1240 = phi_4282_;
                                    if (_e1226[2] < 0f) {
                                        phi_4289_ = -(_e1226[2]);
                                    } else {
                                        phi_4289_ = _e1226[2];
                                    }
                                    let _e1244 = phi_4289_;
                                    if (_e1240 > _e1244) {
                                        phi_4294_ = _e1240;
                                    } else {
                                        phi_4294_ = _e1244;
                                    }
                                    let _e1247 = phi_4294_;
                                    let _e1249 = local_15.member[1u];
                                    if (_e1249[0] < 0f) {
                                        phi_4307_ = -(_e1249[0]);
                                    } else {
                                        phi_4307_ = _e1249[0];
                                    }
                                    let _e1256 = phi_4307_;
                                    if (_e1249[1] < 0f) {
                                        phi_4314_ = -(_e1249[1]);
                                    } else {
                                        phi_4314_ = _e1249[1];
                                    }
                                    let _e1260 = phi_4314_;
                                    if (_e1256 > _e1260) {
                                        phi_4319_ = _e1256;
                                    } else {
                                        phi_4319_ = _e1260;
                                    }
                                    let _e1263 = phi_4319_;
                                    if (_e1249[2] < 0f) {
                                        phi_4326_ = -(_e1249[2]);
                                    } else {
                                        phi_4326_ = _e1249[2];
                                    }
                                    let _e1267 = phi_4326_;
                                    if (_e1263 > _e1267) {
                                        phi_4331_ = _e1263;
                                    } else {
                                        phi_4331_ = _e1267;
                                    }
                                    let _e1270 = phi_4331_;
                                    if (_e1247 > _e1270) {
                                        phi_4336_ = _e1247;
                                    } else {
                                        phi_4336_ = _e1270;
                                    }
                                    let _e1273 = phi_4336_;
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
                                        phi_4395_ = -(_e1304);
                                    } else {
                                        phi_4395_ = _e1304;
                                    }
                                    let _e1310 = phi_4395_;
                                    if (_e1305 < 0f) {
                                        phi_4401_ = -(_e1305);
                                    } else {
                                        phi_4401_ = _e1305;
                                    }
                                    let _e1314 = phi_4401_;
                                    if (_e1310 > _e1314) {
                                        phi_4406_ = _e1310;
                                    } else {
                                        phi_4406_ = _e1314;
                                    }
                                    let _e1317 = phi_4406_;
                                    if (_e1306 < 0f) {
                                        phi_4412_ = -(_e1306);
                                    } else {
                                        phi_4412_ = _e1306;
                                    }
                                    let _e1321 = phi_4412_;
                                    if (_e1317 > _e1321) {
                                        phi_4417_ = _e1317;
                                    } else {
                                        phi_4417_ = _e1321;
                                    }
                                    let _e1324 = phi_4417_;
                                    let _e1330 = ((((_e1221 * _e1324) * 1.01f) + ((_e1273 + _e1223) * (0.000000059604645f * 8f))) + _e1223);
                                    if (_e1291 < 0f) {
                                        phi_4429_ = -(_e1291);
                                    } else {
                                        phi_4429_ = _e1291;
                                    }
                                    let _e1334 = phi_4429_;
                                    if (_e1292 < 0f) {
                                        phi_4435_ = -(_e1292);
                                    } else {
                                        phi_4435_ = _e1292;
                                    }
                                    let _e1338 = phi_4435_;
                                    if (_e1334 > _e1338) {
                                        phi_4440_ = _e1334;
                                    } else {
                                        phi_4440_ = _e1338;
                                    }
                                    let _e1341 = phi_4440_;
                                    if (_e1293 < 0f) {
                                        phi_4446_ = -(_e1293);
                                    } else {
                                        phi_4446_ = _e1293;
                                    }
                                    let _e1345 = phi_4446_;
                                    if (_e1341 > _e1345) {
                                        phi_4451_ = _e1341;
                                    } else {
                                        phi_4451_ = _e1345;
                                    }
                                    let _e1348 = phi_4451_;
                                    local_3 = type_42(array<f32, 3>(_e1291, _e1292, _e1293), _e1330, (_e1348 + _e1330));
                                    let _e1354 = local_15.member_3;
                                    let _e1356 = local_15.member_1[0u];
                                    if (_e1356[0] < 0f) {
                                        phi_4477_ = -(_e1356[0]);
                                    } else {
                                        phi_4477_ = _e1356[0];
                                    }
                                    let _e1363 = phi_4477_;
                                    if (_e1356[1] < 0f) {
                                        phi_4484_ = -(_e1356[1]);
                                    } else {
                                        phi_4484_ = _e1356[1];
                                    }
                                    let _e1367 = phi_4484_;
                                    if (_e1363 > _e1367) {
                                        phi_4489_ = _e1363;
                                    } else {
                                        phi_4489_ = _e1367;
                                    }
                                    let _e1370 = phi_4489_;
                                    if (_e1356[2] < 0f) {
                                        phi_4496_ = -(_e1356[2]);
                                    } else {
                                        phi_4496_ = _e1356[2];
                                    }
                                    let _e1374 = phi_4496_;
                                    if (_e1370 > _e1374) {
                                        phi_4501_ = _e1370;
                                    } else {
                                        phi_4501_ = _e1374;
                                    }
                                    let _e1377 = phi_4501_;
                                    let _e1379 = local_15.member_1[1u];
                                    if (_e1379[0] < 0f) {
                                        phi_4514_ = -(_e1379[0]);
                                    } else {
                                        phi_4514_ = _e1379[0];
                                    }
                                    let _e1386 = phi_4514_;
                                    if (_e1379[1] < 0f) {
                                        phi_4521_ = -(_e1379[1]);
                                    } else {
                                        phi_4521_ = _e1379[1];
                                    }
                                    let _e1390 = phi_4521_;
                                    if (_e1386 > _e1390) {
                                        phi_4526_ = _e1386;
                                    } else {
                                        phi_4526_ = _e1390;
                                    }
                                    let _e1393 = phi_4526_;
                                    if (_e1379[2] < 0f) {
                                        phi_4533_ = -(_e1379[2]);
                                    } else {
                                        phi_4533_ = _e1379[2];
                                    }
                                    let _e1397 = phi_4533_;
                                    if (_e1393 > _e1397) {
                                        phi_4538_ = _e1393;
                                    } else {
                                        phi_4538_ = _e1397;
                                    }
                                    let _e1400 = phi_4538_;
                                    if (_e1377 > _e1400) {
                                        phi_4543_ = _e1377;
                                    } else {
                                        phi_4543_ = _e1400;
                                    }
                                    let _e1403 = phi_4543_;
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
                                        phi_4602_ = -(_e1434);
                                    } else {
                                        phi_4602_ = _e1434;
                                    }
                                    let _e1440 = phi_4602_;
                                    if (_e1435 < 0f) {
                                        phi_4608_ = -(_e1435);
                                    } else {
                                        phi_4608_ = _e1435;
                                    }
                                    let _e1444 = phi_4608_;
                                    if (_e1440 > _e1444) {
                                        phi_4613_ = _e1440;
                                    } else {
                                        phi_4613_ = _e1444;
                                    }
                                    let _e1447 = phi_4613_;
                                    if (_e1436 < 0f) {
                                        phi_4619_ = -(_e1436);
                                    } else {
                                        phi_4619_ = _e1436;
                                    }
                                    let _e1451 = phi_4619_;
                                    if (_e1447 > _e1451) {
                                        phi_4624_ = _e1447;
                                    } else {
                                        phi_4624_ = _e1451;
                                    }
                                    let _e1454 = phi_4624_;
                                    let _e1460 = ((((_e1221 * _e1454) * 1.01f) + ((_e1403 + _e1354) * (0.000000059604645f * 8f))) + _e1354);
                                    if (_e1421 < 0f) {
                                        phi_4636_ = -(_e1421);
                                    } else {
                                        phi_4636_ = _e1421;
                                    }
                                    let _e1464 = phi_4636_;
                                    if (_e1422 < 0f) {
                                        phi_4642_ = -(_e1422);
                                    } else {
                                        phi_4642_ = _e1422;
                                    }
                                    let _e1468 = phi_4642_;
                                    if (_e1464 > _e1468) {
                                        phi_4647_ = _e1464;
                                    } else {
                                        phi_4647_ = _e1468;
                                    }
                                    let _e1471 = phi_4647_;
                                    if (_e1423 < 0f) {
                                        phi_4653_ = -(_e1423);
                                    } else {
                                        phi_4653_ = _e1423;
                                    }
                                    let _e1475 = phi_4653_;
                                    if (_e1471 > _e1475) {
                                        phi_4658_ = _e1471;
                                    } else {
                                        phi_4658_ = _e1475;
                                    }
                                    let _e1478 = phi_4658_;
                                    local_4 = type_42(array<f32, 3>(_e1421, _e1422, _e1423), _e1460, (_e1478 + _e1460));
                                    let _e1484 = local_15.member_3;
                                    let _e1486 = local_15.member_2[0u];
                                    if (_e1486[0] < 0f) {
                                        phi_4684_ = -(_e1486[0]);
                                    } else {
                                        phi_4684_ = _e1486[0];
                                    }
                                    let _e1493 = phi_4684_;
                                    if (_e1486[1] < 0f) {
                                        phi_4691_ = -(_e1486[1]);
                                    } else {
                                        phi_4691_ = _e1486[1];
                                    }
                                    let _e1497 = phi_4691_;
                                    if (_e1493 > _e1497) {
                                        phi_4696_ = _e1493;
                                    } else {
                                        phi_4696_ = _e1497;
                                    }
                                    let _e1500 = phi_4696_;
                                    if (_e1486[2] < 0f) {
                                        phi_4703_ = -(_e1486[2]);
                                    } else {
                                        phi_4703_ = _e1486[2];
                                    }
                                    let _e1504 = phi_4703_;
                                    if (_e1500 > _e1504) {
                                        phi_4708_ = _e1500;
                                    } else {
                                        phi_4708_ = _e1504;
                                    }
                                    let _e1507 = phi_4708_;
                                    let _e1509 = local_15.member_2[1u];
                                    if (_e1509[0] < 0f) {
                                        phi_4721_ = -(_e1509[0]);
                                    } else {
                                        phi_4721_ = _e1509[0];
                                    }
                                    let _e1516 = phi_4721_;
                                    if (_e1509[1] < 0f) {
                                        phi_4728_ = -(_e1509[1]);
                                    } else {
                                        phi_4728_ = _e1509[1];
                                    }
                                    let _e1520 = phi_4728_;
                                    if (_e1516 > _e1520) {
                                        phi_4733_ = _e1516;
                                    } else {
                                        phi_4733_ = _e1520;
                                    }
                                    let _e1523 = phi_4733_;
                                    if (_e1509[2] < 0f) {
                                        phi_4740_ = -(_e1509[2]);
                                    } else {
                                        phi_4740_ = _e1509[2];
                                    }
                                    let _e1527 = phi_4740_;
                                    if (_e1523 > _e1527) {
                                        phi_4745_ = _e1523;
                                    } else {
                                        phi_4745_ = _e1527;
                                    }
                                    let _e1530 = phi_4745_;
                                    if (_e1507 > _e1530) {
                                        phi_4750_ = _e1507;
                                    } else {
                                        phi_4750_ = _e1530;
                                    }
                                    let _e1533 = phi_4750_;
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
                                        phi_4809_ = -(_e1564);
                                    } else {
                                        phi_4809_ = _e1564;
                                    }
                                    let _e1570 = phi_4809_;
                                    if (_e1565 < 0f) {
                                        phi_4815_ = -(_e1565);
                                    } else {
                                        phi_4815_ = _e1565;
                                    }
                                    let _e1574 = phi_4815_;
                                    if (_e1570 > _e1574) {
                                        phi_4820_ = _e1570;
                                    } else {
                                        phi_4820_ = _e1574;
                                    }
                                    let _e1577 = phi_4820_;
                                    if (_e1566 < 0f) {
                                        phi_4826_ = -(_e1566);
                                    } else {
                                        phi_4826_ = _e1566;
                                    }
                                    let _e1581 = phi_4826_;
                                    if (_e1577 > _e1581) {
                                        phi_4831_ = _e1577;
                                    } else {
                                        phi_4831_ = _e1581;
                                    }
                                    let _e1584 = phi_4831_;
                                    let _e1590 = ((((_e1221 * _e1584) * 1.01f) + ((_e1533 + _e1484) * (0.000000059604645f * 8f))) + _e1484);
                                    if (_e1551 < 0f) {
                                        phi_4843_ = -(_e1551);
                                    } else {
                                        phi_4843_ = _e1551;
                                    }
                                    let _e1594 = phi_4843_;
                                    if (_e1552 < 0f) {
                                        phi_4849_ = -(_e1552);
                                    } else {
                                        phi_4849_ = _e1552;
                                    }
                                    let _e1598 = phi_4849_;
                                    if (_e1594 > _e1598) {
                                        phi_4854_ = _e1594;
                                    } else {
                                        phi_4854_ = _e1598;
                                    }
                                    let _e1601 = phi_4854_;
                                    if (_e1553 < 0f) {
                                        phi_4860_ = -(_e1553);
                                    } else {
                                        phi_4860_ = _e1553;
                                    }
                                    let _e1605 = phi_4860_;
                                    if (_e1601 > _e1605) {
                                        phi_4865_ = _e1601;
                                    } else {
                                        phi_4865_ = _e1605;
                                    }
                                    let _e1608 = phi_4865_;
                                    local_5 = type_42(array<f32, 3>(_e1551, _e1552, _e1553), _e1590, (_e1608 + _e1590));
                                    let _e1613 = local_4.member;
                                    let _e1618 = local_5.member;
                                    let _e1624 = ((_e1613[1] * _e1618[2]) - (_e1613[2] * _e1618[1]));
                                    let _e1627 = ((_e1613[2] * _e1618[0]) - (_e1613[0] * _e1618[2]));
                                    let _e1630 = ((_e1613[0] * _e1618[1]) - (_e1613[1] * _e1618[0]));
                                    if (_e1624 < 0f) {
                                        phi_4914_ = -(_e1624);
                                    } else {
                                        phi_4914_ = _e1624;
                                    }
                                    let _e1634 = phi_4914_;
                                    if (_e1627 < 0f) {
                                        phi_4920_ = -(_e1627);
                                    } else {
                                        phi_4920_ = _e1627;
                                    }
                                    let _e1638 = phi_4920_;
                                    if (_e1634 > _e1638) {
                                        if (_e1624 < 0f) {
                                            phi_4930_ = -(_e1624);
                                        } else {
                                            phi_4930_ = _e1624;
                                        }
                                        let _e1656 = phi_4930_;
                                        if (_e1630 < 0f) {
                                            phi_4936_ = -(_e1630);
                                        } else {
                                            phi_4936_ = _e1630;
                                        }
                                        let _e1660 = phi_4936_;
                                        if (_e1656 > _e1660) {
                                            phi_4941_ = 2u;
                                            phi_4942_ = 1u;
                                        } else {
                                            phi_4941_ = 1u;
                                            phi_4942_ = 0u;
                                        }
                                        let _e1663 = phi_4941_;
                                        let _e1665 = phi_4942_;
                                        phi_4961_ = _e1663;
                                        phi_4962_ = _e1665;
                                    } else {
                                        if (_e1627 < 0f) {
                                            phi_4948_ = -(_e1627);
                                        } else {
                                            phi_4948_ = _e1627;
                                        }
                                        let _e1643 = phi_4948_;
                                        if (_e1630 < 0f) {
                                            phi_4954_ = -(_e1630);
                                        } else {
                                            phi_4954_ = _e1630;
                                        }
                                        let _e1647 = phi_4954_;
                                        if (_e1643 > _e1647) {
                                            phi_4959_ = 0u;
                                            phi_4960_ = 2u;
                                        } else {
                                            phi_4959_ = 1u;
                                            phi_4960_ = 0u;
                                        }
                                        let _e1650 = phi_4959_;
                                        let _e1652 = phi_4960_;
                                        phi_4961_ = _e1650;
                                        phi_4962_ = _e1652;
                                    }
                                    let _e1667 = phi_4961_;
                                    let _e1669 = phi_4962_;
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
                                        phi_5029_ = -(_e1688);
                                    } else {
                                        phi_5029_ = _e1688;
                                    }
                                    let _e1722 = phi_5029_;
                                    if (_e1722 > _e1718) {
                                        if (_e1688 < 0f) {
                                            phi_5038_ = -1f;
                                        } else {
                                            phi_5038_ = 1f;
                                        }
                                        let _e1726 = phi_5038_;
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
                                            phi_5169_ = -(_e1825);
                                        } else {
                                            phi_5169_ = _e1825;
                                        }
                                        let _e1831 = phi_5169_;
                                        if (_e1826 < 0f) {
                                            phi_5175_ = -(_e1826);
                                        } else {
                                            phi_5175_ = _e1826;
                                        }
                                        let _e1835 = phi_5175_;
                                        if (_e1827 < 0f) {
                                            phi_5182_ = -(_e1827);
                                        } else {
                                            phi_5182_ = _e1827;
                                        }
                                        let _e1840 = phi_5182_;
                                        let _e1843 = (((_e1831 + _e1835) + _e1840) * (0.000000059604645f * 4f));
                                        local_6[0u].member = _e1826;
                                        local_6[0u].member_1 = _e1775;
                                        local_6[1u].member = _e1827;
                                        local_6[1u].member_1 = _e1824;
                                        local_6[2u].member = (_e1825 - _e1826);
                                        local_6[2u].member_1 = ((_e1718 + _e1775) + _e1843);
                                        local_6[3u].member = (_e1825 - _e1827);
                                        local_6[3u].member_1 = ((_e1718 + _e1824) + _e1843);
                                        phi_5225_ = type_29(0u, 4u);
                                        phi_5228_ = true;
                                        loop {
                                            let _e1864 = phi_5225_;
                                            let _e1866 = phi_5228_;
                                            local_20 = _e1866;
                                            if (_e1864.member < _e1864.member_1) {
                                                phi_5226_ = type_29((_e1864.member + 1u), _e1864.member_1);
                                                phi_5251_ = type_29(1u, _e1864.member);
                                            } else {
                                                phi_5226_ = _e1864;
                                                phi_5251_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1880 = phi_5226_;
                                            let _e1882 = phi_5251_;
                                            if (bitcast<i32>(_e1882.member) != 0i) {
                                                if (_e1882.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1890 = local_6[_e1882.member_1].member;
                                                let _e1893 = local_6[_e1882.member_1].member_1;
                                                let _e1895 = (_e1890 < -(_e1893));
                                                if _e1895 {
                                                    phi_5278_ = bool();
                                                    phi_5279_ = false;
                                                } else {
                                                    phi_5278_ = (_e1866 && (_e1890 > _e1893));
                                                    phi_5279_ = true;
                                                }
                                                let _e1899 = phi_5278_;
                                                let _e1901 = phi_5279_;
                                                phi_5229_ = _e1899;
                                                phi_5280_ = _e1901;
                                                phi_5281_ = _e1895;
                                            } else {
                                                phi_5229_ = bool();
                                                phi_5280_ = false;
                                                phi_5281_ = false;
                                            }
                                            let _e1903 = phi_5229_;
                                            let _e1905 = phi_5280_;
                                            let _e1907 = phi_5281_;
                                            local_19 = _e1907;
                                            continue;
                                            continuing {
                                                phi_5225_ = _e1880;
                                                phi_5228_ = _e1903;
                                                break if !(_e1905);
                                            }
                                        }
                                        let _e1910 = local_19;
                                        if _e1910 {
                                            phi_5285_ = false;
                                        } else {
                                            phi_5285_ = true;
                                        }
                                        let _e1912 = phi_5285_;
                                        if _e1912 {
                                            let _e1914 = local_20;
                                            if _e1914 {
                                                phi_5292_ = 1u;
                                            } else {
                                                phi_5292_ = 2u;
                                            }
                                            let _e1916 = phi_5292_;
                                            phi_5293_ = _e1916;
                                            phi_5294_ = false;
                                        } else {
                                            phi_5293_ = u32();
                                            phi_5294_ = true;
                                        }
                                        let _e1918 = phi_5293_;
                                        let _e1920 = phi_5294_;
                                        phi_5295_ = _e1918;
                                        phi_5296_ = 0u;
                                        phi_5297_ = _e1920;
                                    } else {
                                        phi_5295_ = u32();
                                        phi_5296_ = 2u;
                                        phi_5297_ = true;
                                    }
                                    let _e1922 = phi_5295_;
                                    let _e1924 = phi_5296_;
                                    let _e1926 = phi_5297_;
                                    if _e1926 {
                                        phi_5301_ = _e1924;
                                    } else {
                                        phi_5301_ = _e1922;
                                    }
                                    let _e1928 = phi_5301_;
                                    let _e1929 = (_e1928 == 0u);
                                    if _e1929 {
                                        phi_6799_ = f32();
                                        phi_6800_ = false;
                                        phi_6801_ = false;
                                        phi_6802_ = false;
                                    } else {
                                        if (_e1928 == 1u) {
                                            if _e1211.member_2 {
                                                if ((_e1211.member_1 - _e1211.member) <= 0.0000005f) {
                                                    phi_5321_ = false;
                                                } else {
                                                    phi_5321_ = true;
                                                }
                                                let _e1937 = phi_5321_;
                                                phi_5322_ = _e1937;
                                            } else {
                                                phi_5322_ = true;
                                            }
                                            let _e1939 = phi_5322_;
                                            phi_5323_ = _e1939;
                                        } else {
                                            phi_5323_ = true;
                                        }
                                        let _e1941 = phi_5323_;
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
                                                phi_5519_ = -(_e2008[0]);
                                            } else {
                                                phi_5519_ = _e2008[0];
                                            }
                                            let _e2015 = phi_5519_;
                                            if (_e2008[1] < 0f) {
                                                phi_5526_ = -(_e2008[1]);
                                            } else {
                                                phi_5526_ = _e2008[1];
                                            }
                                            let _e2019 = phi_5526_;
                                            if (_e2015 > _e2019) {
                                                phi_5531_ = _e2015;
                                            } else {
                                                phi_5531_ = _e2019;
                                            }
                                            let _e2022 = phi_5531_;
                                            if (_e2008[2] < 0f) {
                                                phi_5538_ = -(_e2008[2]);
                                            } else {
                                                phi_5538_ = _e2008[2];
                                            }
                                            let _e2026 = phi_5538_;
                                            if (_e2022 > _e2026) {
                                                phi_5543_ = _e2022;
                                            } else {
                                                phi_5543_ = _e2026;
                                            }
                                            let _e2029 = phi_5543_;
                                            let _e2032 = local_15.member[1u];
                                            if (_e2032[0] < 0f) {
                                                phi_5556_ = -(_e2032[0]);
                                            } else {
                                                phi_5556_ = _e2032[0];
                                            }
                                            let _e2039 = phi_5556_;
                                            if (_e2032[1] < 0f) {
                                                phi_5563_ = -(_e2032[1]);
                                            } else {
                                                phi_5563_ = _e2032[1];
                                            }
                                            let _e2043 = phi_5563_;
                                            if (_e2039 > _e2043) {
                                                phi_5568_ = _e2039;
                                            } else {
                                                phi_5568_ = _e2043;
                                            }
                                            let _e2046 = phi_5568_;
                                            if (_e2032[2] < 0f) {
                                                phi_5575_ = -(_e2032[2]);
                                            } else {
                                                phi_5575_ = _e2032[2];
                                            }
                                            let _e2050 = phi_5575_;
                                            if (_e2046 > _e2050) {
                                                phi_5580_ = _e2046;
                                            } else {
                                                phi_5580_ = _e2050;
                                            }
                                            let _e2053 = phi_5580_;
                                            if (_e2029 > _e2053) {
                                                phi_5585_ = _e2029;
                                            } else {
                                                phi_5585_ = _e2053;
                                            }
                                            let _e2056 = phi_5585_;
                                            let _e2058 = local_15.member_3;
                                            let _e2062 = local_15.member_1[0u];
                                            if (_e2062[0] < 0f) {
                                                phi_5602_ = -(_e2062[0]);
                                            } else {
                                                phi_5602_ = _e2062[0];
                                            }
                                            let _e2069 = phi_5602_;
                                            if (_e2062[1] < 0f) {
                                                phi_5609_ = -(_e2062[1]);
                                            } else {
                                                phi_5609_ = _e2062[1];
                                            }
                                            let _e2073 = phi_5609_;
                                            if (_e2069 > _e2073) {
                                                phi_5614_ = _e2069;
                                            } else {
                                                phi_5614_ = _e2073;
                                            }
                                            let _e2076 = phi_5614_;
                                            if (_e2062[2] < 0f) {
                                                phi_5621_ = -(_e2062[2]);
                                            } else {
                                                phi_5621_ = _e2062[2];
                                            }
                                            let _e2080 = phi_5621_;
                                            if (_e2076 > _e2080) {
                                                phi_5626_ = _e2076;
                                            } else {
                                                phi_5626_ = _e2080;
                                            }
                                            let _e2083 = phi_5626_;
                                            let _e2086 = local_15.member_1[1u];
                                            if (_e2086[0] < 0f) {
                                                phi_5640_ = -(_e2086[0]);
                                            } else {
                                                phi_5640_ = _e2086[0];
                                            }
                                            let _e2093 = phi_5640_;
                                            if (_e2086[1] < 0f) {
                                                phi_5647_ = -(_e2086[1]);
                                            } else {
                                                phi_5647_ = _e2086[1];
                                            }
                                            let _e2097 = phi_5647_;
                                            if (_e2093 > _e2097) {
                                                phi_5652_ = _e2093;
                                            } else {
                                                phi_5652_ = _e2097;
                                            }
                                            let _e2100 = phi_5652_;
                                            if (_e2086[2] < 0f) {
                                                phi_5659_ = -(_e2086[2]);
                                            } else {
                                                phi_5659_ = _e2086[2];
                                            }
                                            let _e2104 = phi_5659_;
                                            if (_e2100 > _e2104) {
                                                phi_5664_ = _e2100;
                                            } else {
                                                phi_5664_ = _e2104;
                                            }
                                            let _e2107 = phi_5664_;
                                            if (_e2083 > _e2107) {
                                                phi_5669_ = _e2083;
                                            } else {
                                                phi_5669_ = _e2107;
                                            }
                                            let _e2110 = phi_5669_;
                                            let _e2112 = local_15.member_3;
                                            let _e2116 = local_15.member_2[0u];
                                            if (_e2116[0] < 0f) {
                                                phi_5686_ = -(_e2116[0]);
                                            } else {
                                                phi_5686_ = _e2116[0];
                                            }
                                            let _e2123 = phi_5686_;
                                            if (_e2116[1] < 0f) {
                                                phi_5693_ = -(_e2116[1]);
                                            } else {
                                                phi_5693_ = _e2116[1];
                                            }
                                            let _e2127 = phi_5693_;
                                            if (_e2123 > _e2127) {
                                                phi_5698_ = _e2123;
                                            } else {
                                                phi_5698_ = _e2127;
                                            }
                                            let _e2130 = phi_5698_;
                                            if (_e2116[2] < 0f) {
                                                phi_5705_ = -(_e2116[2]);
                                            } else {
                                                phi_5705_ = _e2116[2];
                                            }
                                            let _e2134 = phi_5705_;
                                            if (_e2130 > _e2134) {
                                                phi_5710_ = _e2130;
                                            } else {
                                                phi_5710_ = _e2134;
                                            }
                                            let _e2137 = phi_5710_;
                                            let _e2140 = local_15.member_2[1u];
                                            if (_e2140[0] < 0f) {
                                                phi_5724_ = -(_e2140[0]);
                                            } else {
                                                phi_5724_ = _e2140[0];
                                            }
                                            let _e2147 = phi_5724_;
                                            if (_e2140[1] < 0f) {
                                                phi_5731_ = -(_e2140[1]);
                                            } else {
                                                phi_5731_ = _e2140[1];
                                            }
                                            let _e2151 = phi_5731_;
                                            if (_e2147 > _e2151) {
                                                phi_5736_ = _e2147;
                                            } else {
                                                phi_5736_ = _e2151;
                                            }
                                            let _e2154 = phi_5736_;
                                            if (_e2140[2] < 0f) {
                                                phi_5743_ = -(_e2140[2]);
                                            } else {
                                                phi_5743_ = _e2140[2];
                                            }
                                            let _e2158 = phi_5743_;
                                            if (_e2154 > _e2158) {
                                                phi_5748_ = _e2154;
                                            } else {
                                                phi_5748_ = _e2158;
                                            }
                                            let _e2161 = phi_5748_;
                                            if (_e2137 > _e2161) {
                                                phi_5753_ = _e2137;
                                            } else {
                                                phi_5753_ = _e2161;
                                            }
                                            let _e2164 = phi_5753_;
                                            let _e2166 = local_15.member_3;
                                            let _e2173 = local_15.member_3;
                                            phi_5769_ = type_29(0u, 48u);
                                            phi_5772_ = _e1211.member;
                                            loop {
                                                let _e2179 = phi_5769_;
                                                let _e2181 = phi_5772_;
                                                local_65 = _e2181;
                                                local_27 = _e2181;
                                                local_28 = _e2181;
                                                local_29 = _e2181;
                                                local_30 = _e2181;
                                                if (_e2179.member < _e2179.member_1) {
                                                    phi_5770_ = type_29((_e2179.member + 1u), _e2179.member_1);
                                                    phi_5795_ = type_29(1u, _e2179.member);
                                                } else {
                                                    phi_5770_ = _e2179;
                                                    phi_5795_ = type_29(0u, type_29().member_1);
                                                }
                                                let _e2195 = phi_5770_;
                                                let _e2197 = phi_5795_;
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
                                                                phi_5949_ = (_e2299 <= 1f);
                                                                phi_5950_ = false;
                                                            } else {
                                                                phi_5949_ = bool();
                                                                phi_5950_ = true;
                                                            }
                                                            let _e2305 = phi_5949_;
                                                            let _e2307 = phi_5950_;
                                                            phi_5951_ = _e2305;
                                                            phi_5952_ = _e2307;
                                                        } else {
                                                            phi_5951_ = bool();
                                                            phi_5952_ = true;
                                                        }
                                                        let _e2309 = phi_5951_;
                                                        let _e2311 = phi_5952_;
                                                        phi_5953_ = _e2309;
                                                        phi_5954_ = _e2311;
                                                    } else {
                                                        phi_5953_ = bool();
                                                        phi_5954_ = true;
                                                    }
                                                    let _e2313 = phi_5953_;
                                                    let _e2315 = phi_5954_;
                                                    if _e2315 {
                                                        phi_5958_ = false;
                                                    } else {
                                                        phi_5958_ = _e2313;
                                                    }
                                                    let _e2317 = phi_5958_;
                                                    if (_e2291 > 0f) {
                                                        if _e2317 {
                                                            phi_5998_ = array<f32, 3>((_e2219 - ((_e2240 * _e2295) + (_e2261 * _e2299))), (_e2220 - ((_e2241 * _e2295) + (_e2262 * _e2299))), (_e2221 - ((_e2242 * _e2295) + (_e2263 * _e2299))));
                                                            phi_5999_ = false;
                                                        } else {
                                                            phi_5998_ = array<f32, 3>();
                                                            phi_5999_ = true;
                                                        }
                                                        let _e2333 = phi_5998_;
                                                        let _e2335 = phi_5999_;
                                                        phi_6000_ = _e2333;
                                                        phi_6001_ = _e2335;
                                                    } else {
                                                        phi_6000_ = array<f32, 3>();
                                                        phi_6001_ = true;
                                                    }
                                                    let _e2337 = phi_6000_;
                                                    let _e2339 = phi_6001_;
                                                    if _e2339 {
                                                        let _e2340 = (_e2219 - _e2240);
                                                        let _e2341 = (_e2220 - _e2241);
                                                        let _e2342 = (_e2221 - _e2242);
                                                        let _e2353 = ((((_e2219 * _e2240) + (_e2220 * _e2241)) + (_e2221 * _e2242)) / (((_e2240 * _e2240) + (_e2241 * _e2241)) + (_e2242 * _e2242)));
                                                        if (_e2353 > 0f) {
                                                            if (_e2353 < 1f) {
                                                                phi_6031_ = _e2353;
                                                            } else {
                                                                phi_6031_ = 1f;
                                                            }
                                                            let _e2357 = phi_6031_;
                                                            phi_6032_ = _e2357;
                                                        } else {
                                                            phi_6032_ = 0f;
                                                        }
                                                        let _e2359 = phi_6032_;
                                                        let _e2376 = ((((_e2219 * _e2261) + (_e2220 * _e2262)) + (_e2221 * _e2263)) / (((_e2261 * _e2261) + (_e2262 * _e2262)) + (_e2263 * _e2263)));
                                                        if (_e2376 > 0f) {
                                                            if (_e2376 < 1f) {
                                                                phi_6059_ = _e2376;
                                                            } else {
                                                                phi_6059_ = 1f;
                                                            }
                                                            let _e2380 = phi_6059_;
                                                            phi_6060_ = _e2380;
                                                        } else {
                                                            phi_6060_ = 0f;
                                                        }
                                                        let _e2382 = phi_6060_;
                                                        let _e2399 = ((((_e2340 * _e2261) + (_e2341 * _e2262)) + (_e2342 * _e2263)) / (((_e2261 * _e2261) + (_e2262 * _e2262)) + (_e2263 * _e2263)));
                                                        if (_e2399 > 0f) {
                                                            if (_e2399 < 1f) {
                                                                phi_6087_ = _e2399;
                                                            } else {
                                                                phi_6087_ = 1f;
                                                            }
                                                            let _e2403 = phi_6087_;
                                                            phi_6088_ = _e2403;
                                                        } else {
                                                            phi_6088_ = 0f;
                                                        }
                                                        let _e2405 = phi_6088_;
                                                        let _e2412 = (_e2219 - _e2261);
                                                        let _e2413 = (_e2220 - _e2262);
                                                        let _e2414 = (_e2221 - _e2263);
                                                        let _e2425 = ((((_e2412 * _e2240) + (_e2413 * _e2241)) + (_e2414 * _e2242)) / (((_e2240 * _e2240) + (_e2241 * _e2241)) + (_e2242 * _e2242)));
                                                        if (_e2425 > 0f) {
                                                            if (_e2425 < 1f) {
                                                                phi_6118_ = _e2425;
                                                            } else {
                                                                phi_6118_ = 1f;
                                                            }
                                                            let _e2429 = phi_6118_;
                                                            phi_6119_ = _e2429;
                                                        } else {
                                                            phi_6119_ = 0f;
                                                        }
                                                        let _e2431 = phi_6119_;
                                                        local[0u] = array<f32, 3>((_e2219 - (_e2240 * _e2359)), (_e2220 - (_e2241 * _e2359)), (_e2221 - (_e2242 * _e2359)));
                                                        local[1u] = array<f32, 3>((_e2219 - (_e2261 * _e2382)), (_e2220 - (_e2262 * _e2382)), (_e2221 - (_e2263 * _e2382)));
                                                        local[2u] = array<f32, 3>((_e2340 - (_e2261 * _e2405)), (_e2341 - (_e2262 * _e2405)), (_e2342 - (_e2263 * _e2405)));
                                                        local[3u] = array<f32, 3>((_e2412 - (_e2240 * _e2431)), (_e2413 - (_e2241 * _e2431)), (_e2414 - (_e2242 * _e2431)));
                                                        let _e2447 = local[0u];
                                                        phi_6262_ = type_29(1u, 4u);
                                                        phi_6265_ = array<f32, 3>(_e2447[0], _e2447[1], _e2447[2]);
                                                        loop {
                                                            let _e2453 = phi_6262_;
                                                            let _e2455 = phi_6265_;
                                                            local_52 = _e2455;
                                                            if (_e2453.member < _e2453.member_1) {
                                                                phi_6263_ = type_29((_e2453.member + 1u), _e2453.member_1);
                                                                phi_6288_ = type_29(1u, _e2453.member);
                                                            } else {
                                                                phi_6263_ = _e2453;
                                                                phi_6288_ = type_29(0u, type_29().member_1);
                                                            }
                                                            let _e2469 = phi_6263_;
                                                            let _e2471 = phi_6288_;
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
                                                                    phi_6355_ = array<f32, 3>(_e2507[0], _e2507[1], _e2507[2]);
                                                                } else {
                                                                    phi_6355_ = _e2455;
                                                                }
                                                                let _e2513 = phi_6355_;
                                                                phi_6266_ = _e2513;
                                                            } else {
                                                                phi_6266_ = array<f32, 3>();
                                                            }
                                                            let _e2515 = phi_6266_;
                                                            continue;
                                                            continuing {
                                                                phi_6262_ = _e2469;
                                                                phi_6265_ = _e2515;
                                                                break if !(_e2475);
                                                            }
                                                        }
                                                        let _e5135 = local_52;
                                                        phi_6356_ = _e5135;
                                                    } else {
                                                        phi_6356_ = _e2337;
                                                    }
                                                    let _e2518 = phi_6356_;
                                                    if (_e2518[0] < 0f) {
                                                        phi_6363_ = -(_e2518[0]);
                                                    } else {
                                                        phi_6363_ = _e2518[0];
                                                    }
                                                    let _e2523 = phi_6363_;
                                                    if (_e2518[1] < 0f) {
                                                        phi_6370_ = -(_e2518[1]);
                                                    } else {
                                                        phi_6370_ = _e2518[1];
                                                    }
                                                    let _e2528 = phi_6370_;
                                                    if (_e2518[2] < 0f) {
                                                        phi_6378_ = -(_e2518[2]);
                                                    } else {
                                                        phi_6378_ = _e2518[2];
                                                    }
                                                    let _e2534 = phi_6378_;
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
                                                                    phi_6415_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6415_ = 0f;
                                                                }
                                                                let _e2610 = phi_6415_;
                                                                phi_6479_ = _e2610;
                                                            } else {
                                                                phi_6422_ = type_27(0i, 5i);
                                                                phi_6425_ = bitcast<f32>(((bitcast<u32>(_e2551) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2559 = phi_6422_;
                                                                    let _e2561 = phi_6425_;
                                                                    local_21 = _e2561;
                                                                    if (_e2559.member < _e2559.member_1) {
                                                                        let _e2569 = (_e2559.member + 1i);
                                                                        if ((false == (_e2569 > _e2559.member)) != false) {
                                                                            phi_6446_ = true;
                                                                        } else {
                                                                            phi_6446_ = false;
                                                                        }
                                                                        let _e2574 = phi_6446_;
                                                                        if _e2574 {
                                                                            phi_6452_ = type_28(0u, type_28().member_1);
                                                                        } else {
                                                                            phi_6452_ = type_28(1u, _e2569);
                                                                        }
                                                                        let _e2580 = phi_6452_;
                                                                        if (bitcast<i32>(_e2580.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_6423_ = type_27(_e2580.member_1, _e2559.member_1);
                                                                        phi_6466_ = type_28(1u, _e2559.member);
                                                                    } else {
                                                                        phi_6423_ = _e2559;
                                                                        phi_6466_ = type_28(0u, type_28().member_1);
                                                                    }
                                                                    let _e2590 = phi_6423_;
                                                                    let _e2592 = phi_6466_;
                                                                    let _e2595 = (bitcast<i32>(_e2592.member) != 0i);
                                                                    if _e2595 {
                                                                        phi_6426_ = (0.5f * (_e2561 + (_e2551 / _e2561)));
                                                                    } else {
                                                                        phi_6426_ = f32();
                                                                    }
                                                                    let _e2600 = phi_6426_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6422_ = _e2590;
                                                                        phi_6425_ = _e2600;
                                                                        break if !(_e2595);
                                                                    }
                                                                }
                                                                let _e2605 = local_21;
                                                                phi_6479_ = (_e2605 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2612 = phi_6479_;
                                                            phi_6488_ = type_29(0u, 4u);
                                                            phi_6491_ = 2f;
                                                            loop {
                                                                let _e2620 = phi_6488_;
                                                                let _e2622 = phi_6491_;
                                                                local_23 = _e2622;
                                                                local_24 = _e2622;
                                                                local_25 = _e2622;
                                                                local_55 = _e2622;
                                                                local_56 = _e2622;
                                                                if (_e2620.member < _e2620.member_1) {
                                                                    phi_6489_ = type_29((_e2620.member + 1u), _e2620.member_1);
                                                                    phi_6514_ = type_29(1u, _e2620.member);
                                                                } else {
                                                                    phi_6489_ = _e2620;
                                                                    phi_6514_ = type_29(0u, type_29().member_1);
                                                                }
                                                                let _e2636 = phi_6489_;
                                                                let _e2638 = phi_6514_;
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
                                                                        phi_6565_ = -(_e2653);
                                                                    } else {
                                                                        phi_6565_ = _e2653;
                                                                    }
                                                                    let _e2668 = phi_6565_;
                                                                    if (_e2664 < 0f) {
                                                                        phi_6571_ = -(_e2664);
                                                                    } else {
                                                                        phi_6571_ = _e2664;
                                                                    }
                                                                    let _e2672 = phi_6571_;
                                                                    let _e2676 = (((((((((_e2056 + _e2058) + (_e2110 + _e2112)) + (_e2164 + _e2166)) * (0.000000059604645f * 16f)) + (_e2173 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2612) * (1f + (0.000000059604645f * 8f)))) + ((_e2668 + _e2672) * (0.000000059604645f * 8f)));
                                                                    if (_e2653 > _e2676) {
                                                                        if (_e2664 > _e2676) {
                                                                            phi_6584_ = false;
                                                                        } else {
                                                                            phi_6584_ = true;
                                                                        }
                                                                        let _e2680 = phi_6584_;
                                                                        phi_6585_ = _e2680;
                                                                    } else {
                                                                        phi_6585_ = true;
                                                                    }
                                                                    let _e2682 = phi_6585_;
                                                                    if _e2682 {
                                                                        if ((_e2653 + ((_e2664 - _e2653) * _e2181)) > _e2676) {
                                                                            if (_e2664 < _e2653) {
                                                                                let _e2690 = ((_e2653 - _e2664) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                                                if _e2690 {
                                                                                    let _e2696 = (((_e2653 - _e2676) / (_e2653 - _e2664)) * (1f - (0.000000059604645f * 16f)));
                                                                                    if (_e2622 < _e2696) {
                                                                                        phi_6616_ = _e2622;
                                                                                    } else {
                                                                                        phi_6616_ = _e2696;
                                                                                    }
                                                                                    let _e2699 = phi_6616_;
                                                                                    phi_6617_ = _e2699;
                                                                                } else {
                                                                                    phi_6617_ = f32();
                                                                                }
                                                                                let _e2701 = phi_6617_;
                                                                                phi_6618_ = _e2701;
                                                                                phi_6619_ = _e2690;
                                                                            } else {
                                                                                phi_6618_ = _e2622;
                                                                                phi_6619_ = true;
                                                                            }
                                                                            let _e2703 = phi_6618_;
                                                                            let _e2705 = phi_6619_;
                                                                            if _e2705 {
                                                                                phi_6623_ = false;
                                                                            } else {
                                                                                phi_6623_ = true;
                                                                            }
                                                                            let _e2707 = phi_6623_;
                                                                            phi_6624_ = _e2703;
                                                                            phi_6625_ = _e2705;
                                                                            phi_6626_ = _e2707;
                                                                            phi_6627_ = false;
                                                                        } else {
                                                                            phi_6624_ = f32();
                                                                            phi_6625_ = false;
                                                                            phi_6626_ = false;
                                                                            phi_6627_ = true;
                                                                        }
                                                                        let _e2709 = phi_6624_;
                                                                        let _e2711 = phi_6625_;
                                                                        let _e2713 = phi_6626_;
                                                                        let _e2715 = phi_6627_;
                                                                        phi_6628_ = _e2709;
                                                                        phi_6629_ = _e2711;
                                                                        phi_6630_ = _e2713;
                                                                        phi_6631_ = _e2715;
                                                                    } else {
                                                                        phi_6628_ = _e2622;
                                                                        phi_6629_ = true;
                                                                        phi_6630_ = false;
                                                                        phi_6631_ = false;
                                                                    }
                                                                    let _e2717 = phi_6628_;
                                                                    let _e2719 = phi_6629_;
                                                                    let _e2721 = phi_6630_;
                                                                    let _e2723 = phi_6631_;
                                                                    phi_6492_ = _e2717;
                                                                    phi_6632_ = _e2719;
                                                                    phi_6633_ = false;
                                                                    phi_6634_ = _e2721;
                                                                    phi_6635_ = _e2723;
                                                                } else {
                                                                    phi_6492_ = f32();
                                                                    phi_6632_ = false;
                                                                    phi_6633_ = true;
                                                                    phi_6634_ = false;
                                                                    phi_6635_ = false;
                                                                }
                                                                let _e2725 = phi_6492_;
                                                                let _e2727 = phi_6632_;
                                                                let _e2729 = phi_6633_;
                                                                let _e2731 = phi_6634_;
                                                                let _e2733 = phi_6635_;
                                                                local_22 = _e2729;
                                                                local_53 = _e2731;
                                                                local_54 = _e2733;
                                                                continue;
                                                                continuing {
                                                                    phi_6488_ = _e2636;
                                                                    phi_6491_ = _e2725;
                                                                    break if !(_e2727);
                                                                }
                                                            }
                                                            let _e2736 = local_22;
                                                            if _e2736 {
                                                                let _e2738 = local_23;
                                                                let _e2739 = (_e2738 > _e1211.member_1);
                                                                if _e2739 {
                                                                    phi_6656_ = false;
                                                                    phi_6657_ = false;
                                                                    phi_6658_ = false;
                                                                } else {
                                                                    let _e2741 = local_24;
                                                                    if (_e2741 > _e2181) {
                                                                        let _e2744 = local_25;
                                                                        let _e2746 = ((_e2744 - _e2181) < 0.00000000023283064f);
                                                                        if _e2746 {
                                                                            phi_6652_ = false;
                                                                        } else {
                                                                            phi_6652_ = true;
                                                                        }
                                                                        let _e2748 = phi_6652_;
                                                                        phi_6653_ = _e2748;
                                                                        phi_6654_ = _e2746;
                                                                        phi_6655_ = false;
                                                                    } else {
                                                                        phi_6653_ = false;
                                                                        phi_6654_ = false;
                                                                        phi_6655_ = true;
                                                                    }
                                                                    let _e2750 = phi_6653_;
                                                                    let _e2752 = phi_6654_;
                                                                    let _e2754 = phi_6655_;
                                                                    phi_6656_ = _e2750;
                                                                    phi_6657_ = _e2752;
                                                                    phi_6658_ = _e2754;
                                                                }
                                                                let _e2756 = phi_6656_;
                                                                let _e2758 = phi_6657_;
                                                                let _e2760 = phi_6658_;
                                                                phi_6659_ = _e2756;
                                                                phi_6660_ = _e2739;
                                                                phi_6661_ = _e2758;
                                                                phi_6662_ = _e2760;
                                                                phi_6663_ = false;
                                                                phi_6664_ = false;
                                                            } else {
                                                                phi_6659_ = false;
                                                                phi_6660_ = false;
                                                                phi_6661_ = false;
                                                                phi_6662_ = false;
                                                                let _e5192 = local_53;
                                                                phi_6663_ = _e5192;
                                                                let _e5195 = local_54;
                                                                phi_6664_ = _e5195;
                                                            }
                                                            let _e2762 = phi_6659_;
                                                            let _e2764 = phi_6660_;
                                                            let _e2766 = phi_6661_;
                                                            let _e2768 = phi_6662_;
                                                            let _e2770 = phi_6663_;
                                                            let _e2772 = phi_6664_;
                                                            let _e5198 = local_55;
                                                            phi_6665_ = _e5198;
                                                            let _e5201 = local_56;
                                                            phi_6666_ = _e5201;
                                                            phi_6667_ = _e2762;
                                                            phi_6668_ = _e2764;
                                                            phi_6669_ = _e2766;
                                                            phi_6670_ = _e2768;
                                                            phi_6671_ = _e2770;
                                                            phi_6672_ = _e2772;
                                                            phi_6673_ = false;
                                                        } else {
                                                            phi_6665_ = f32();
                                                            phi_6666_ = f32();
                                                            phi_6667_ = false;
                                                            phi_6668_ = false;
                                                            phi_6669_ = false;
                                                            phi_6670_ = false;
                                                            phi_6671_ = false;
                                                            phi_6672_ = false;
                                                            phi_6673_ = true;
                                                        }
                                                        let _e2774 = phi_6665_;
                                                        let _e2776 = phi_6666_;
                                                        let _e2778 = phi_6667_;
                                                        let _e2780 = phi_6668_;
                                                        let _e2782 = phi_6669_;
                                                        let _e2784 = phi_6670_;
                                                        let _e2786 = phi_6671_;
                                                        let _e2788 = phi_6672_;
                                                        let _e2790 = phi_6673_;
                                                        phi_6674_ = _e2774;
                                                        phi_6675_ = _e2776;
                                                        phi_6676_ = _e2778;
                                                        phi_6677_ = _e2780;
                                                        phi_6678_ = _e2782;
                                                        phi_6679_ = _e2784;
                                                        phi_6680_ = _e2786;
                                                        phi_6681_ = _e2788;
                                                        phi_6682_ = _e2790;
                                                        phi_6683_ = false;
                                                    } else {
                                                        phi_6674_ = f32();
                                                        phi_6675_ = f32();
                                                        phi_6676_ = false;
                                                        phi_6677_ = false;
                                                        phi_6678_ = false;
                                                        phi_6679_ = false;
                                                        phi_6680_ = false;
                                                        phi_6681_ = false;
                                                        phi_6682_ = false;
                                                        phi_6683_ = true;
                                                    }
                                                    let _e2792 = phi_6674_;
                                                    let _e2794 = phi_6675_;
                                                    let _e2796 = phi_6676_;
                                                    let _e2798 = phi_6677_;
                                                    let _e2800 = phi_6678_;
                                                    let _e2802 = phi_6679_;
                                                    let _e2804 = phi_6680_;
                                                    let _e2806 = phi_6681_;
                                                    let _e2808 = phi_6682_;
                                                    let _e2810 = phi_6683_;
                                                    phi_6684_ = _e2792;
                                                    phi_5773_ = _e2794;
                                                    phi_6685_ = _e2796;
                                                    phi_6686_ = _e2798;
                                                    phi_6687_ = _e2800;
                                                    phi_6688_ = false;
                                                    phi_6689_ = _e2802;
                                                    phi_6690_ = _e2804;
                                                    phi_6691_ = _e2806;
                                                    phi_6692_ = _e2808;
                                                    phi_6693_ = _e2810;
                                                } else {
                                                    phi_6684_ = f32();
                                                    phi_5773_ = f32();
                                                    phi_6685_ = false;
                                                    phi_6686_ = false;
                                                    phi_6687_ = false;
                                                    phi_6688_ = true;
                                                    phi_6689_ = false;
                                                    phi_6690_ = false;
                                                    phi_6691_ = false;
                                                    phi_6692_ = false;
                                                    phi_6693_ = false;
                                                }
                                                let _e2812 = phi_6684_;
                                                let _e2814 = phi_5773_;
                                                let _e2816 = phi_6685_;
                                                let _e2818 = phi_6686_;
                                                let _e2820 = phi_6687_;
                                                let _e2822 = phi_6688_;
                                                let _e2824 = phi_6689_;
                                                let _e2826 = phi_6690_;
                                                let _e2828 = phi_6691_;
                                                let _e2830 = phi_6692_;
                                                let _e2832 = phi_6693_;
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
                                                    phi_5769_ = _e2195;
                                                    phi_5772_ = _e2814;
                                                    break if !(_e2816);
                                                }
                                            }
                                            let _e2835 = local_26;
                                            if _e2835 {
                                                phi_6698_ = type_56(0u, type_56().member_1);
                                                phi_6699_ = false;
                                                phi_6700_ = false;
                                                phi_6701_ = false;
                                                phi_6702_ = false;
                                                phi_6703_ = false;
                                                phi_6704_ = false;
                                                phi_6705_ = false;
                                            } else {
                                                phi_6698_ = type_56();
                                                let _e5234 = local_57;
                                                phi_6699_ = _e5234;
                                                let _e5237 = local_58;
                                                phi_6700_ = _e5237;
                                                let _e5240 = local_59;
                                                phi_6701_ = _e5240;
                                                let _e5243 = local_60;
                                                phi_6702_ = _e5243;
                                                let _e5246 = local_61;
                                                phi_6703_ = _e5246;
                                                let _e5249 = local_62;
                                                phi_6704_ = _e5249;
                                                let _e5252 = local_63;
                                                phi_6705_ = _e5252;
                                            }
                                            let _e2840 = phi_6698_;
                                            let _e2842 = phi_6699_;
                                            let _e2844 = phi_6700_;
                                            let _e2846 = phi_6701_;
                                            let _e2848 = phi_6702_;
                                            let _e2850 = phi_6703_;
                                            let _e2852 = phi_6704_;
                                            let _e2854 = phi_6705_;
                                            if _e2842 {
                                                let _e5255 = local_64;
                                                phi_6709_ = _e5255;
                                                phi_6710_ = true;
                                                phi_6711_ = false;
                                                phi_6712_ = false;
                                                phi_6713_ = false;
                                                phi_6714_ = false;
                                                phi_6715_ = false;
                                                phi_6716_ = false;
                                            } else {
                                                let _e5257 = local_65;
                                                phi_6709_ = _e5257;
                                                phi_6710_ = _e2844;
                                                phi_6711_ = _e2846;
                                                phi_6712_ = _e2848;
                                                phi_6713_ = _e2850;
                                                let _e5264 = local_66;
                                                phi_6714_ = _e5264;
                                                phi_6715_ = _e2852;
                                                phi_6716_ = _e2854;
                                            }
                                            let _e2856 = phi_6709_;
                                            let _e2858 = phi_6710_;
                                            let _e2860 = phi_6711_;
                                            let _e2862 = phi_6712_;
                                            let _e2864 = phi_6713_;
                                            let _e2866 = phi_6714_;
                                            let _e2868 = phi_6715_;
                                            let _e2870 = phi_6716_;
                                            if _e2858 {
                                                phi_6721_ = type_56(1u, _e2856);
                                                phi_6722_ = false;
                                                phi_6723_ = false;
                                                phi_6724_ = false;
                                                phi_6725_ = false;
                                                phi_6726_ = false;
                                                phi_6727_ = false;
                                            } else {
                                                phi_6721_ = type_56();
                                                phi_6722_ = _e2860;
                                                phi_6723_ = _e2862;
                                                phi_6724_ = _e2864;
                                                phi_6725_ = _e2866;
                                                phi_6726_ = _e2868;
                                                phi_6727_ = _e2870;
                                            }
                                            let _e2873 = phi_6721_;
                                            let _e2875 = phi_6722_;
                                            let _e2877 = phi_6723_;
                                            let _e2879 = phi_6724_;
                                            let _e2881 = phi_6725_;
                                            let _e2883 = phi_6726_;
                                            let _e2885 = phi_6727_;
                                            if _e2875 {
                                                let _e2887 = local_27;
                                                phi_6732_ = type_56(1u, _e2887);
                                                phi_6733_ = false;
                                                phi_6734_ = false;
                                                phi_6735_ = true;
                                                phi_6736_ = false;
                                                phi_6737_ = false;
                                            } else {
                                                phi_6732_ = _e2840;
                                                phi_6733_ = _e2877;
                                                phi_6734_ = _e2879;
                                                phi_6735_ = _e2881;
                                                phi_6736_ = _e2883;
                                                phi_6737_ = _e2885;
                                            }
                                            let _e2890 = phi_6732_;
                                            let _e2892 = phi_6733_;
                                            let _e2894 = phi_6734_;
                                            let _e2896 = phi_6735_;
                                            let _e2898 = phi_6736_;
                                            let _e2900 = phi_6737_;
                                            if _e2892 {
                                                let _e2902 = local_28;
                                                phi_6742_ = type_56(1u, _e2902);
                                                phi_6743_ = false;
                                                phi_6744_ = false;
                                                phi_6745_ = false;
                                                phi_6746_ = false;
                                            } else {
                                                phi_6742_ = type_56();
                                                phi_6743_ = _e2894;
                                                phi_6744_ = _e2896;
                                                phi_6745_ = _e2898;
                                                phi_6746_ = _e2900;
                                            }
                                            let _e2905 = phi_6742_;
                                            let _e2907 = phi_6743_;
                                            let _e2909 = phi_6744_;
                                            let _e2911 = phi_6745_;
                                            let _e2913 = phi_6746_;
                                            if _e2907 {
                                                let _e2915 = local_29;
                                                phi_6751_ = type_56(1u, _e2915);
                                                phi_6752_ = true;
                                                phi_6753_ = false;
                                                phi_6754_ = false;
                                                phi_6755_ = false;
                                            } else {
                                                phi_6751_ = _e2905;
                                                phi_6752_ = _e2892;
                                                phi_6753_ = _e2909;
                                                phi_6754_ = _e2911;
                                                phi_6755_ = _e2913;
                                            }
                                            let _e2918 = phi_6751_;
                                            let _e2920 = phi_6752_;
                                            let _e2922 = phi_6753_;
                                            let _e2924 = phi_6754_;
                                            let _e2926 = phi_6755_;
                                            if _e2920 {
                                                phi_6759_ = _e2918;
                                                phi_6760_ = true;
                                                phi_6761_ = false;
                                                phi_6762_ = false;
                                            } else {
                                                phi_6759_ = _e2890;
                                                phi_6760_ = _e2922;
                                                phi_6761_ = _e2924;
                                                phi_6762_ = _e2926;
                                            }
                                            let _e2928 = phi_6759_;
                                            let _e2930 = phi_6760_;
                                            let _e2932 = phi_6761_;
                                            let _e2934 = phi_6762_;
                                            if _e2930 {
                                                phi_6766_ = false;
                                                phi_6767_ = false;
                                            } else {
                                                phi_6766_ = _e2932;
                                                phi_6767_ = _e2934;
                                            }
                                            let _e2936 = phi_6766_;
                                            let _e2938 = phi_6767_;
                                            if _e2936 {
                                                phi_6771_ = false;
                                                phi_6772_ = false;
                                            } else {
                                                phi_6771_ = _e2938;
                                                phi_6772_ = _e2930;
                                            }
                                            let _e2940 = phi_6771_;
                                            let _e2942 = phi_6772_;
                                            if _e2940 {
                                                phi_6776_ = true;
                                                phi_6777_ = false;
                                            } else {
                                                phi_6776_ = _e2936;
                                                phi_6777_ = _e2942;
                                            }
                                            let _e2944 = phi_6776_;
                                            let _e2946 = phi_6777_;
                                            if _e2944 {
                                                let _e2948 = local_30;
                                                phi_6782_ = type_56(1u, _e2948);
                                                phi_6783_ = true;
                                            } else {
                                                phi_6782_ = _e2928;
                                                phi_6783_ = _e2946;
                                            }
                                            let _e2951 = phi_6782_;
                                            let _e2953 = phi_6783_;
                                            if _e2953 {
                                                phi_6787_ = _e2951;
                                            } else {
                                                phi_6787_ = _e2873;
                                            }
                                            let _e2955 = phi_6787_;
                                            let _e2958 = (_e2955.member != 0u);
                                            if _e2958 {
                                                phi_6794_ = false;
                                            } else {
                                                phi_6794_ = true;
                                            }
                                            let _e2960 = phi_6794_;
                                            phi_6795_ = _e2955.member_1;
                                            phi_6796_ = _e2960;
                                            phi_6797_ = _e2958;
                                            phi_6798_ = false;
                                        } else {
                                            phi_6795_ = f32();
                                            phi_6796_ = false;
                                            phi_6797_ = false;
                                            phi_6798_ = true;
                                        }
                                        let _e2962 = phi_6795_;
                                        let _e2964 = phi_6796_;
                                        let _e2966 = phi_6797_;
                                        let _e2968 = phi_6798_;
                                        phi_6799_ = _e2962;
                                        phi_6800_ = _e2964;
                                        phi_6801_ = _e2966;
                                        phi_6802_ = _e2968;
                                    }
                                    let _e2970 = phi_6799_;
                                    let _e2972 = phi_6800_;
                                    let _e2974 = phi_6801_;
                                    let _e2976 = phi_6802_;
                                    phi_6803_ = _e2970;
                                    phi_6804_ = _e1929;
                                    phi_6805_ = _e2972;
                                    phi_6806_ = _e2974;
                                    phi_6807_ = _e2976;
                                }
                                let _e2978 = phi_6803_;
                                let _e2980 = phi_6804_;
                                let _e2982 = phi_6805_;
                                let _e2984 = phi_6806_;
                                let _e2986 = phi_6807_;
                                if _e2980 {
                                    phi_6811_ = true;
                                    phi_6812_ = false;
                                    phi_6813_ = false;
                                } else {
                                    phi_6811_ = _e2982;
                                    phi_6812_ = _e2984;
                                    phi_6813_ = _e2986;
                                }
                                let _e2988 = phi_6811_;
                                let _e2990 = phi_6812_;
                                let _e2992 = phi_6813_;
                                phi_6814_ = _e2978;
                                phi_6815_ = _e1211;
                                phi_6816_ = _e2988;
                                phi_6817_ = false;
                                phi_6818_ = _e2990;
                                phi_6819_ = _e2992;
                            } else {
                                phi_6814_ = f32();
                                phi_6815_ = type_57();
                                phi_6816_ = false;
                                phi_6817_ = true;
                                phi_6818_ = false;
                                phi_6819_ = false;
                            }
                            let _e2994 = phi_6814_;
                            let _e2996 = phi_6815_;
                            let _e2998 = phi_6816_;
                            let _e3000 = phi_6817_;
                            let _e3002 = phi_6818_;
                            let _e3004 = phi_6819_;
                            local_31 = _e3000;
                            local_67 = _e3002;
                            local_68 = _e3004;
                            local_32 = _e2994;
                            local_33 = _e2996;
                            continue;
                            continuing {
                                phi_3856_ = _e910;
                                break if !(_e2998);
                            }
                        }
                        let _e3007 = local_31;
                        if _e3007 {
                            phi_6824_ = type_56(0u, type_56().member_1);
                            phi_6825_ = false;
                            phi_6826_ = false;
                        } else {
                            phi_6824_ = type_56();
                            let _e5334 = local_67;
                            phi_6825_ = _e5334;
                            let _e5337 = local_68;
                            phi_6826_ = _e5337;
                        }
                        let _e3012 = phi_6824_;
                        let _e3014 = phi_6825_;
                        let _e3016 = phi_6826_;
                        if _e3014 {
                            let _e3018 = local_32;
                            phi_6831_ = type_56(2u, _e3018);
                            phi_6832_ = false;
                        } else {
                            phi_6831_ = type_56();
                            phi_6832_ = _e3016;
                        }
                        let _e3021 = phi_6831_;
                        let _e3023 = phi_6832_;
                        if _e3023 {
                            let _e3025 = local_33;
                            phi_6838_ = type_56(1u, _e3025.member);
                            phi_6839_ = true;
                        } else {
                            phi_6838_ = _e3021;
                            phi_6839_ = _e3014;
                        }
                        let _e3029 = phi_6838_;
                        let _e3031 = phi_6839_;
                        if _e3031 {
                            phi_6843_ = _e3029;
                        } else {
                            phi_6843_ = _e3012;
                        }
                        let _e3033 = phi_6843_;
                        phi_6847_ = _e3033;
                    }
                    let _e4682 = phi_6847_;
                    phi_6848_ = _e4682;
                }
                let _e4687 = phi_6848_;
                switch bitcast<i32>(_e4687.member) {
                    case 0: {
                        phi_6861_ = type_59(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4693 = function_(_e4687.member_1);
                        phi_6861_ = type_59(0u, _e4693, true);
                        break;
                    }
                    case 2: {
                        let _e4691 = function_(_e4687.member_1);
                        phi_6861_ = type_59(1u, _e4691, true);
                        break;
                    }
                    default: {
                        phi_6861_ = type_59();
                        break;
                    }
                }
                let _e4696 = phi_6861_;
                if _e4696.member_2 {
                    phi_6868_ = (_e4696.member == 0u);
                } else {
                    phi_6868_ = false;
                }
                let _e4701 = phi_6868_;
                if _e4701 {
                    let _e4709 = (_e4696.member_1[1] >> bitcast<u32>(20i));
                    if (_e4709 <= 896u) {
                        phi_6892_ = 0u;
                    } else {
                        phi_6892_ = ((((_e4709 - 896u) << bitcast<u32>(23i)) | ((_e4696.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4696.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4724 = phi_6892_;
                    let _e4726 = atomicMin((&earliest.member[0u]), _e4724);
                }
                phi_6896_ = type_50(_e177, 0u, _e183, _e186, _e4696.member_1);
                phi_6897_ = _e4701;
                phi_6898_ = (_e4696.member != 0u);
            } else {
                phi_6896_ = type_50(_e177, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_6897_ = false;
                phi_6898_ = false;
            }
            let _e4728 = phi_6896_;
            let _e4730 = phi_6897_;
            let _e4732 = phi_6898_;
            let _e4734 = params.member.member_1;
            if ((_e4734 & 16u) != 0u) {
                if (_e108 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4730 {
                    let _e4740 = atomicAdd((&counters[0u]), 1u);
                    phi_6916_ = _e4740;
                } else {
                    phi_6916_ = 0u;
                }
                let _e4742 = phi_6916_;
                workgroupBarrier();
                if (_e108 == 0u) {
                    let _e4745 = atomicLoad((&counters[0u]));
                    if (_e4745 > 0u) {
                        let _e4748 = atomicAdd((&contacts.member[0u]), _e4745);
                        atomicStore((&counters[1u]), _e4748);
                    }
                }
                workgroupBarrier();
                let _e4751 = atomicLoad((&counters[1u]));
                let _e4752 = (_e4751 + _e4742);
                if _e4730 {
                    let _e4754 = params.member.member_16;
                    if (_e4752 < _e4754) {
                        let _e4756 = (6u * _e4752);
                        atomicStore((&contacts.member[(4u + _e4756)]), _e4728.member);
                        atomicStore((&contacts.member[(_e4756 + 5u)]), _e4728.member_1);
                        atomicStore((&contacts.member[(_e4756 + 6u)]), _e4728.member_2);
                        atomicStore((&contacts.member[(_e4756 + 7u)]), _e4728.member_3);
                        atomicStore((&contacts.member[(_e4756 + 8u)]), _e4728.member_4[0]);
                        atomicStore((&contacts.member[(_e4756 + 9u)]), _e4728.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e108 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4732 {
                let _e4780 = atomicAdd((&counters[0u]), 1u);
                phi_6978_ = _e4780;
            } else {
                phi_6978_ = 0u;
            }
            let _e4782 = phi_6978_;
            workgroupBarrier();
            if (_e108 == 0u) {
                let _e4785 = atomicLoad((&counters[0u]));
                if (_e4785 > 0u) {
                    let _e4788 = atomicAdd((&undecided.member[0u]), _e4785);
                    atomicStore((&counters[1u]), _e4788);
                }
            }
            workgroupBarrier();
            let _e4791 = atomicLoad((&counters[1u]));
            let _e4792 = (_e4791 + _e4782);
            if _e4732 {
                atomicStore((&undecided.member[(4u + (2u * _e4792))]), _e4728.member_2);
                atomicStore((&undecided.member[((2u * _e4792) + 5u)]), _e4728.member_3);
            }
        }
        continue;
        continuing {
            phi_247_ = _e165;
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
    function_1();
}
