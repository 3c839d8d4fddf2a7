struct type_9 {
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

struct type_10 {
    member: type_9,
}

struct type_12 {
    member: array<u32>,
}

struct type_14 {
    member: array<array<u32, 2>>,
}

struct type_17 {
    member: i32,
    member_1: i32,
}

struct type_18 {
    member: u32,
    member_1: i32,
}

struct type_19 {
    member: u32,
    member_1: u32,
}

struct type_21 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

struct type_27 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_28 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_29 {
    member: f32,
    member_1: f32,
}

struct type_32 {
    member: u32,
    member_1: f32,
}

struct type_33 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_34 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_37 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_10;
@group(0) @binding(1) 
var<storage> paths: type_23;
@group(0) @binding(2) 
var<storage> elements: type_14;
@group(0) @binding(3) 
var<storage> input: type_12;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_37;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_37;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_37;
var<workgroup> counters: array<atomic<u32>, 4>;

fn function_(param: f32) -> array<u32, 2> {
    var phi_7030_: array<u32, 2>;
    var phi_7031_: array<u32, 2>;
    var phi_7032_: bool;
    var phi_7036_: array<u32, 2>;

    let _e13 = bitcast<u32>(param);
    if (_e13 < 8388608u) {
        phi_7031_ = array<u32, 2>();
        phi_7032_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_7030_ = array<u32, 2>();
        } else {
            phi_7030_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_7030_;
        phi_7031_ = _e31;
        phi_7032_ = _e17;
    }
    let _e33 = phi_7031_;
    let _e35 = phi_7032_;
    if _e35 {
        phi_7036_ = array<u32, 2>(0u, 0u);
    } else {
        phi_7036_ = _e33;
    }
    let _e37 = phi_7036_;
    return _e37;
}

fn function_1(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<array<f32, 3>, 4>;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: array<array<f32, 3>, 4>;
    var local_3: type_24;
    var local_4: type_24;
    var local_5: type_24;
    var local_6: array<type_29, 4>;
    var local_7: array<f32, 4>;
    var local_8: array<f32, 2>;
    var local_9: array<f32, 4>;
    var local_10: array<array<f32, 3>, 4>;
    var local_11: array<array<f32, 3>, 4>;
    var local_12: array<array<f32, 3>, 4>;
    var local_13: array<array<f32, 3>, 4>;
    var local_14: array<f32, 3>;
    var local_15: type_27;
    var phi_206_: u32;
    var phi_222_: u32;
    var phi_243_: u32;
    var phi_244_: u32;
    var phi_247_: type_19;
    var phi_248_: type_19;
    var phi_271_: type_19;
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
    var phi_3676_: type_17;
    var phi_3679_: f32;
    var phi_3700_: bool;
    var phi_3706_: type_18;
    var phi_3677_: type_17;
    var phi_3720_: type_18;
    var phi_3680_: f32;
    var local_16: f32;
    var phi_3669_: f32;
    var phi_3733_: f32;
    var phi_3739_: f32;
    var phi_3764_: type_19;
    var phi_3767_: u32;
    var phi_3765_: type_19;
    var phi_3790_: type_19;
    var phi_3834_: u32;
    var phi_3835_: u32;
    var phi_3768_: u32;
    var phi_3836_: u32;
    var phi_3856_: type_19;
    var phi_3857_: type_19;
    var phi_3880_: type_19;
    var phi_3932_: f32;
    var phi_3939_: f32;
    var phi_3950_: bool;
    var phi_3951_: bool;
    var phi_3952_: bool;
    var phi_3953_: bool;
    var phi_3957_: bool;
    var phi_3968_: type_33;
    var phi_3969_: type_33;
    var phi_3970_: bool;
    var phi_3971_: type_33;
    var phi_3972_: bool;
    var phi_3983_: f32;
    var phi_3993_: type_19;
    var phi_3996_: f32;
    var phi_3998_: f32;
    var phi_4000_: f32;
    var phi_3994_: type_19;
    var phi_4023_: type_19;
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
    var phi_4123_: type_19;
    var phi_4126_: f32;
    var phi_4124_: type_19;
    var phi_4149_: type_19;
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
    var phi_4241_: type_33;
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
    var phi_5225_: type_19;
    var phi_5228_: bool;
    var phi_5226_: type_19;
    var phi_5251_: type_19;
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
    var phi_5769_: type_19;
    var phi_5772_: f32;
    var phi_5770_: type_19;
    var phi_5795_: type_19;
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
    var phi_6262_: type_19;
    var phi_6265_: array<f32, 3>;
    var phi_6263_: type_19;
    var phi_6288_: type_19;
    var phi_6355_: array<f32, 3>;
    var phi_6266_: array<f32, 3>;
    var phi_6356_: array<f32, 3>;
    var phi_6363_: f32;
    var phi_6370_: f32;
    var phi_6378_: f32;
    var phi_6422_: type_17;
    var phi_6425_: f32;
    var phi_6446_: bool;
    var phi_6452_: type_18;
    var phi_6423_: type_17;
    var phi_6466_: type_18;
    var phi_6426_: f32;
    var local_21: f32;
    var phi_6415_: f32;
    var phi_6479_: f32;
    var phi_6488_: type_19;
    var phi_6491_: f32;
    var phi_6489_: type_19;
    var phi_6514_: type_19;
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
    var phi_6698_: type_32;
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
    var phi_6721_: type_32;
    var phi_6722_: bool;
    var phi_6723_: bool;
    var phi_6724_: bool;
    var phi_6725_: bool;
    var phi_6726_: bool;
    var phi_6727_: bool;
    var local_27: f32;
    var phi_6732_: type_32;
    var phi_6733_: bool;
    var phi_6734_: bool;
    var phi_6735_: bool;
    var phi_6736_: bool;
    var phi_6737_: bool;
    var local_28: f32;
    var phi_6742_: type_32;
    var phi_6743_: bool;
    var phi_6744_: bool;
    var phi_6745_: bool;
    var phi_6746_: bool;
    var local_29: f32;
    var phi_6751_: type_32;
    var phi_6752_: bool;
    var phi_6753_: bool;
    var phi_6754_: bool;
    var phi_6755_: bool;
    var phi_6759_: type_32;
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
    var phi_6782_: type_32;
    var phi_6783_: bool;
    var phi_6787_: type_32;
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
    var phi_6815_: type_33;
    var phi_6816_: bool;
    var phi_6817_: bool;
    var phi_6818_: bool;
    var phi_6819_: bool;
    var local_31: bool;
    var phi_6824_: type_32;
    var phi_6825_: bool;
    var phi_6826_: bool;
    var local_32: f32;
    var phi_6831_: type_32;
    var phi_6832_: bool;
    var local_33: type_33;
    var phi_6838_: type_32;
    var phi_6839_: bool;
    var phi_6843_: type_32;
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
    var phi_1561_: type_19;
    var phi_1564_: f32;
    var phi_1562_: type_19;
    var phi_1587_: type_19;
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
    var phi_2054_: type_19;
    var phi_2057_: array<f32, 3>;
    var phi_2055_: type_19;
    var phi_2080_: type_19;
    var phi_2147_: array<f32, 3>;
    var phi_2058_: array<f32, 3>;
    var phi_2148_: array<f32, 3>;
    var phi_2155_: f32;
    var phi_2162_: f32;
    var phi_2170_: f32;
    var phi_2214_: type_17;
    var phi_2217_: f32;
    var phi_2238_: bool;
    var phi_2244_: type_18;
    var phi_2215_: type_17;
    var phi_2258_: type_18;
    var phi_2218_: f32;
    var local_34: f32;
    var phi_2207_: f32;
    var phi_2271_: f32;
    var phi_2280_: type_19;
    var phi_2283_: f32;
    var phi_2281_: type_19;
    var phi_2306_: type_19;
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
    var phi_2490_: type_32;
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
    var phi_2513_: type_32;
    var phi_2514_: bool;
    var phi_2515_: bool;
    var phi_2516_: bool;
    var phi_2517_: bool;
    var phi_2518_: bool;
    var phi_2519_: bool;
    var local_40: f32;
    var phi_2524_: type_32;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var phi_2527_: bool;
    var phi_2528_: bool;
    var phi_2529_: bool;
    var local_41: f32;
    var phi_2534_: type_32;
    var phi_2535_: bool;
    var phi_2536_: bool;
    var phi_2537_: bool;
    var phi_2538_: bool;
    var local_42: f32;
    var phi_2543_: type_32;
    var phi_2544_: bool;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2547_: bool;
    var phi_2551_: type_32;
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
    var phi_2574_: type_32;
    var phi_2575_: bool;
    var phi_2579_: type_32;
    var phi_2593_: type_19;
    var phi_2594_: type_19;
    var phi_2617_: type_19;
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
    var phi_3098_: type_19;
    var phi_3101_: array<f32, 3>;
    var phi_3099_: type_19;
    var phi_3124_: type_19;
    var phi_3191_: array<f32, 3>;
    var phi_3102_: array<f32, 3>;
    var phi_3192_: array<f32, 3>;
    var phi_3224_: type_17;
    var phi_3227_: f32;
    var phi_3248_: bool;
    var phi_3254_: type_18;
    var phi_3225_: type_17;
    var phi_3268_: type_18;
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
    var phi_3558_: type_32;
    var phi_3559_: bool;
    var phi_3564_: type_32;
    var phi_3565_: bool;
    var phi_3567_: type_32;
    var phi_3568_: type_32;
    var phi_3569_: bool;
    var phi_3573_: type_32;
    var phi_6847_: type_32;
    var phi_6848_: type_32;
    var phi_6861_: type_34;
    var phi_6868_: bool;
    var phi_6892_: u32;
    var phi_6896_: type_28;
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
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e97 = id_2;
    let _e98 = n_2;
    let _e99 = lane_2;
    let _e111 = ((_e97.y * _e98.x) + _e97.x);
    let _e114 = (_e98.x * _e98.y);
    let _e116 = params.member.member_15;
    let _e118 = input.member[0u];
    if (_e116 < _e118) {
        phi_206_ = _e116;
    } else {
        phi_206_ = _e118;
    }
    let _e121 = phi_206_;
    let _e122 = (_e121 / 64u);
    if ((_e121 % 64u) > 0u) {
        phi_222_ = (_e122 + 1u);
    } else {
        phi_222_ = _e122;
    }
    let _e127 = phi_222_;
    if (_e127 > _e111) {
        let _e129 = (_e127 - _e111);
        if (_e114 == 0u) {
            return;
        }
        let _e131 = (_e129 / _e114);
        if (_e114 == 0u) {
            return;
        }
        if ((_e129 % _e114) > 0u) {
            phi_243_ = (_e131 + 1u);
        } else {
            phi_243_ = _e131;
        }
        let _e137 = phi_243_;
        phi_244_ = _e137;
    } else {
        phi_244_ = 0u;
    }
    let _e139 = phi_244_;
    phi_247_ = type_19(0u, _e139);
    loop {
        let _e142 = phi_247_;
        if (_e142.member < _e142.member_1) {
            phi_248_ = type_19((_e142.member + 1u), _e142.member_1);
            phi_271_ = type_19(1u, _e142.member);
        } else {
            phi_248_ = _e142;
            phi_271_ = type_19(0u, type_19().member_1);
        }
        let _e154 = phi_248_;
        let _e156 = phi_271_;
        let _e160 = (bitcast<i32>(_e156.member) != 0i);
        if _e160 {
            let _e164 = (((_e111 + (_e156.member_1 * _e114)) * 64u) + _e99);
            let _e166 = params.member.member_8;
            if (_e164 < _e121) {
                let _e169 = (2u * _e164);
                let _e172 = input.member[(4u + _e169)];
                let _e175 = input.member[(_e169 + 5u)];
                let _e177 = elements.member[_e172];
                let _e179 = elements.member[_e175];
                let _e185 = paths.member[_e177[0]];
                let _e187 = paths.member[_e177[1]];
                let _e193 = paths.member[_e179[0]];
                let _e195 = paths.member[_e179[1]];
                let _e225 = params.member.member_4;
                local_15 = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e193.member[0] - _e185.member[0]), (_e193.member[1] - _e185.member[1]), (_e193.member[2] - _e185.member[2])), array<f32, 3>((_e193.member_1[0] - _e185.member_1[0]), (_e193.member_1[1] - _e185.member_1[1]), (_e193.member_1[2] - _e185.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e187.member[0] - _e185.member[0]), (_e187.member[1] - _e185.member[1]), (_e187.member[2] - _e185.member[2])), array<f32, 3>((_e187.member_1[0] - _e185.member_1[0]), (_e187.member_1[1] - _e185.member_1[1]), (_e187.member_1[2] - _e185.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e193.member[0] - _e195.member[0]), (_e193.member[1] - _e195.member[1]), (_e193.member[2] - _e195.member[2])), array<f32, 3>((_e193.member_1[0] - _e195.member_1[0]), (_e193.member_1[1] - _e195.member_1[1]), (_e193.member_1[2] - _e195.member_1[2]))), (_e225 + _e225));
                let _e256 = params.member.member_5;
                let _e259 = local_15.member_1[0u];
                let _e265 = local_15.member_2[0u];
                let _e271 = ((_e259[1] * _e265[2]) - (_e259[2] * _e265[1]));
                let _e274 = ((_e259[2] * _e265[0]) - (_e259[0] * _e265[2]));
                let _e277 = ((_e259[0] * _e265[1]) - (_e259[1] * _e265[0]));
                let _e280 = local_15.member_1[1u];
                let _e286 = local_15.member_2[1u];
                let _e292 = ((_e280[1] * _e286[2]) - (_e280[2] * _e286[1]));
                let _e295 = ((_e280[2] * _e286[0]) - (_e280[0] * _e286[2]));
                let _e298 = ((_e280[0] * _e286[1]) - (_e280[1] * _e286[0]));
                let _e301 = local_15.member_1[0u];
                let _e307 = local_15.member_2[1u];
                let _e322 = local_15.member_1[1u];
                let _e328 = local_15.member_2[0u];
                let _e341 = (((_e301[1] * _e307[2]) - (_e301[2] * _e307[1])) + ((_e322[1] * _e328[2]) - (_e322[2] * _e328[1])));
                let _e342 = (((_e301[2] * _e307[0]) - (_e301[0] * _e307[2])) + ((_e322[2] * _e328[0]) - (_e322[0] * _e328[2])));
                let _e343 = (((_e301[0] * _e307[1]) - (_e301[1] * _e307[0])) + ((_e322[0] * _e328[1]) - (_e322[1] * _e328[0])));
                let _e346 = local_15.member[0u];
                let _e354 = (((_e346[0] * _e271) + (_e346[1] * _e274)) + (_e346[2] * _e277));
                let _e357 = local_15.member[1u];
                let _e368 = local_15.member[0u];
                let _e377 = ((((_e357[0] * _e271) + (_e357[1] * _e274)) + (_e357[2] * _e277)) + (((_e368[0] * _e341) + (_e368[1] * _e342)) + (_e368[2] * _e343)));
                let _e380 = local_15.member[0u];
                let _e391 = local_15.member[1u];
                let _e400 = ((((_e380[0] * _e292) + (_e380[1] * _e295)) + (_e380[2] * _e298)) + (((_e391[0] * _e341) + (_e391[1] * _e342)) + (_e391[2] * _e343)));
                let _e403 = local_15.member[1u];
                let _e411 = (((_e403[0] * _e292) + (_e403[1] * _e295)) + (_e403[2] * _e298));
                let _e414 = local_15.member[0u];
                if (_e414[0] < 0f) {
                    phi_721_ = -(_e414[0]);
                } else {
                    phi_721_ = _e414[0];
                }
                let _e421 = phi_721_;
                if (_e414[1] < 0f) {
                    phi_728_ = -(_e414[1]);
                } else {
                    phi_728_ = _e414[1];
                }
                let _e425 = phi_728_;
                if (_e421 > _e425) {
                    phi_733_ = _e421;
                } else {
                    phi_733_ = _e425;
                }
                let _e428 = phi_733_;
                if (_e414[2] < 0f) {
                    phi_740_ = -(_e414[2]);
                } else {
                    phi_740_ = _e414[2];
                }
                let _e432 = phi_740_;
                if (_e428 > _e432) {
                    phi_745_ = _e428;
                } else {
                    phi_745_ = _e432;
                }
                let _e435 = phi_745_;
                let _e438 = local_15.member[1u];
                if (_e438[0] < 0f) {
                    phi_758_ = -(_e438[0]);
                } else {
                    phi_758_ = _e438[0];
                }
                let _e445 = phi_758_;
                if (_e438[1] < 0f) {
                    phi_765_ = -(_e438[1]);
                } else {
                    phi_765_ = _e438[1];
                }
                let _e449 = phi_765_;
                if (_e445 > _e449) {
                    phi_770_ = _e445;
                } else {
                    phi_770_ = _e449;
                }
                let _e452 = phi_770_;
                if (_e438[2] < 0f) {
                    phi_777_ = -(_e438[2]);
                } else {
                    phi_777_ = _e438[2];
                }
                let _e456 = phi_777_;
                if (_e452 > _e456) {
                    phi_782_ = _e452;
                } else {
                    phi_782_ = _e456;
                }
                let _e459 = phi_782_;
                if (_e435 > _e459) {
                    phi_787_ = _e435;
                } else {
                    phi_787_ = _e459;
                }
                let _e462 = phi_787_;
                let _e464 = local_15.member_3;
                let _e465 = (_e462 + _e464);
                let _e468 = local_15.member_1[0u];
                if (_e468[0] < 0f) {
                    phi_804_ = -(_e468[0]);
                } else {
                    phi_804_ = _e468[0];
                }
                let _e475 = phi_804_;
                if (_e468[1] < 0f) {
                    phi_811_ = -(_e468[1]);
                } else {
                    phi_811_ = _e468[1];
                }
                let _e479 = phi_811_;
                if (_e475 > _e479) {
                    phi_816_ = _e475;
                } else {
                    phi_816_ = _e479;
                }
                let _e482 = phi_816_;
                if (_e468[2] < 0f) {
                    phi_823_ = -(_e468[2]);
                } else {
                    phi_823_ = _e468[2];
                }
                let _e486 = phi_823_;
                if (_e482 > _e486) {
                    phi_828_ = _e482;
                } else {
                    phi_828_ = _e486;
                }
                let _e489 = phi_828_;
                let _e492 = local_15.member_1[1u];
                if (_e492[0] < 0f) {
                    phi_842_ = -(_e492[0]);
                } else {
                    phi_842_ = _e492[0];
                }
                let _e499 = phi_842_;
                if (_e492[1] < 0f) {
                    phi_849_ = -(_e492[1]);
                } else {
                    phi_849_ = _e492[1];
                }
                let _e503 = phi_849_;
                if (_e499 > _e503) {
                    phi_854_ = _e499;
                } else {
                    phi_854_ = _e503;
                }
                let _e506 = phi_854_;
                if (_e492[2] < 0f) {
                    phi_861_ = -(_e492[2]);
                } else {
                    phi_861_ = _e492[2];
                }
                let _e510 = phi_861_;
                if (_e506 > _e510) {
                    phi_866_ = _e506;
                } else {
                    phi_866_ = _e510;
                }
                let _e513 = phi_866_;
                if (_e489 > _e513) {
                    phi_871_ = _e489;
                } else {
                    phi_871_ = _e513;
                }
                let _e516 = phi_871_;
                let _e518 = local_15.member_3;
                let _e519 = (_e516 + _e518);
                let _e522 = local_15.member_2[0u];
                if (_e522[0] < 0f) {
                    phi_888_ = -(_e522[0]);
                } else {
                    phi_888_ = _e522[0];
                }
                let _e529 = phi_888_;
                if (_e522[1] < 0f) {
                    phi_895_ = -(_e522[1]);
                } else {
                    phi_895_ = _e522[1];
                }
                let _e533 = phi_895_;
                if (_e529 > _e533) {
                    phi_900_ = _e529;
                } else {
                    phi_900_ = _e533;
                }
                let _e536 = phi_900_;
                if (_e522[2] < 0f) {
                    phi_907_ = -(_e522[2]);
                } else {
                    phi_907_ = _e522[2];
                }
                let _e540 = phi_907_;
                if (_e536 > _e540) {
                    phi_912_ = _e536;
                } else {
                    phi_912_ = _e540;
                }
                let _e543 = phi_912_;
                let _e546 = local_15.member_2[1u];
                if (_e546[0] < 0f) {
                    phi_926_ = -(_e546[0]);
                } else {
                    phi_926_ = _e546[0];
                }
                let _e553 = phi_926_;
                if (_e546[1] < 0f) {
                    phi_933_ = -(_e546[1]);
                } else {
                    phi_933_ = _e546[1];
                }
                let _e557 = phi_933_;
                if (_e553 > _e557) {
                    phi_938_ = _e553;
                } else {
                    phi_938_ = _e557;
                }
                let _e560 = phi_938_;
                if (_e546[2] < 0f) {
                    phi_945_ = -(_e546[2]);
                } else {
                    phi_945_ = _e546[2];
                }
                let _e564 = phi_945_;
                if (_e560 > _e564) {
                    phi_950_ = _e560;
                } else {
                    phi_950_ = _e564;
                }
                let _e567 = phi_950_;
                if (_e543 > _e567) {
                    phi_955_ = _e543;
                } else {
                    phi_955_ = _e567;
                }
                let _e570 = phi_955_;
                let _e572 = local_15.member_3;
                let _e573 = (_e570 + _e572);
                let _e575 = ((_e519 * 8f) * _e573);
                let _e582 = local_15.member_3;
                if (_e271 < 0f) {
                    phi_986_ = -(_e271);
                } else {
                    phi_986_ = _e271;
                }
                let _e599 = phi_986_;
                if (_e274 < 0f) {
                    phi_992_ = -(_e274);
                } else {
                    phi_992_ = _e274;
                }
                let _e603 = phi_992_;
                if (_e277 < 0f) {
                    phi_999_ = -(_e277);
                } else {
                    phi_999_ = _e277;
                }
                let _e608 = phi_999_;
                let _e609 = ((_e599 + _e603) + _e608);
                if (_e292 < 0f) {
                    phi_1006_ = -(_e292);
                } else {
                    phi_1006_ = _e292;
                }
                let _e613 = phi_1006_;
                if (_e295 < 0f) {
                    phi_1012_ = -(_e295);
                } else {
                    phi_1012_ = _e295;
                }
                let _e617 = phi_1012_;
                if (_e298 < 0f) {
                    phi_1019_ = -(_e298);
                } else {
                    phi_1019_ = _e298;
                }
                let _e622 = phi_1019_;
                let _e623 = ((_e613 + _e617) + _e622);
                if (_e609 > _e623) {
                    phi_1025_ = _e609;
                } else {
                    phi_1025_ = _e623;
                }
                let _e626 = phi_1025_;
                if (_e341 < 0f) {
                    phi_1031_ = -(_e341);
                } else {
                    phi_1031_ = _e341;
                }
                let _e630 = phi_1031_;
                if (_e342 < 0f) {
                    phi_1037_ = -(_e342);
                } else {
                    phi_1037_ = _e342;
                }
                let _e634 = phi_1037_;
                if (_e343 < 0f) {
                    phi_1044_ = -(_e343);
                } else {
                    phi_1044_ = _e343;
                }
                let _e639 = phi_1044_;
                let _e641 = (((_e630 + _e634) + _e639) * 0.5f);
                if (_e626 > _e641) {
                    phi_1051_ = _e626;
                } else {
                    phi_1051_ = _e641;
                }
                let _e644 = phi_1051_;
                let _e649 = local_15.member_3;
                let _e661 = (((((_e465 * 8f) * _e575) * (0.000000059604645f * (490f / 64f))) + ((_e582 * 19f) * ((_e465 * (_e519 + _e573)) + (_e519 * _e573)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e465) * ((1f + _e519) * (1f + _e573)))));
                let _e662 = (_e354 * 3f);
                let _e663 = (_e411 * 3f);
                if (_e662 < _e663) {
                    phi_1075_ = _e662;
                } else {
                    phi_1075_ = _e663;
                }
                let _e666 = phi_1075_;
                if (_e377 < _e400) {
                    phi_1080_ = _e377;
                } else {
                    phi_1080_ = _e400;
                }
                let _e669 = phi_1080_;
                if (_e666 < _e669) {
                    phi_1085_ = _e666;
                } else {
                    phi_1085_ = _e669;
                }
                let _e672 = phi_1085_;
                if (_e662 > _e663) {
                    phi_1090_ = _e662;
                } else {
                    phi_1090_ = _e663;
                }
                let _e675 = phi_1090_;
                if (_e377 > _e400) {
                    phi_1095_ = _e377;
                } else {
                    phi_1095_ = _e400;
                }
                let _e678 = phi_1095_;
                if (_e675 > _e678) {
                    phi_1100_ = _e675;
                } else {
                    phi_1100_ = _e678;
                }
                let _e681 = phi_1100_;
                let _e686 = -(_e681);
                if (_e672 > _e686) {
                    phi_1110_ = _e672;
                } else {
                    phi_1110_ = _e686;
                }
                let _e689 = phi_1110_;
                if ((_e689 - (_e661 + ((_e256 * (((_e644 + (_e575 * (0.000000059604645f * 4f))) + ((_e649 * 6f) * (_e519 + _e573))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e519) * (1f + _e573))))) * (3f * 1.0001f)))) > 0f) {
                    phi_6848_ = type_32(0u, type_32().member_1);
                } else {
                    if (_e256 > 0f) {
                        let _e2970 = local_15.member[0u];
                        let _e2976 = local_15.member_1[0u];
                        let _e2982 = local_15.member_2[0u];
                        let _e2986 = (_e2970[0] - _e2976[0]);
                        let _e2987 = (_e2970[1] - _e2976[1]);
                        let _e2988 = (_e2970[2] - _e2976[2]);
                        local_12 = array<array<f32, 3>, 4>(_e2970, array<f32, 3>(_e2986, _e2987, _e2988), array<f32, 3>((_e2970[0] - _e2982[0]), (_e2970[1] - _e2982[1]), (_e2970[2] - _e2982[2])), array<f32, 3>((_e2986 - _e2982[0]), (_e2987 - _e2982[1]), (_e2988 - _e2982[2])));
                        let _e3001 = local_15.member[1u];
                        let _e3007 = local_15.member_1[1u];
                        let _e3013 = local_15.member_2[1u];
                        let _e3017 = (_e3001[0] - _e3007[0]);
                        let _e3018 = (_e3001[1] - _e3007[1]);
                        let _e3019 = (_e3001[2] - _e3007[2]);
                        local_13 = array<array<f32, 3>, 4>(_e3001, array<f32, 3>(_e3017, _e3018, _e3019), array<f32, 3>((_e3001[0] - _e3013[0]), (_e3001[1] - _e3013[1]), (_e3001[2] - _e3013[2])), array<f32, 3>((_e3017 - _e3013[0]), (_e3018 - _e3013[1]), (_e3019 - _e3013[2])));
                        let _e3032 = local_15.member[0u];
                        if (_e3032[0] < 0f) {
                            phi_1311_ = -(_e3032[0]);
                        } else {
                            phi_1311_ = _e3032[0];
                        }
                        let _e3039 = phi_1311_;
                        if (_e3032[1] < 0f) {
                            phi_1318_ = -(_e3032[1]);
                        } else {
                            phi_1318_ = _e3032[1];
                        }
                        let _e3043 = phi_1318_;
                        if (_e3039 > _e3043) {
                            phi_1323_ = _e3039;
                        } else {
                            phi_1323_ = _e3043;
                        }
                        let _e3046 = phi_1323_;
                        if (_e3032[2] < 0f) {
                            phi_1330_ = -(_e3032[2]);
                        } else {
                            phi_1330_ = _e3032[2];
                        }
                        let _e3050 = phi_1330_;
                        if (_e3046 > _e3050) {
                            phi_1335_ = _e3046;
                        } else {
                            phi_1335_ = _e3050;
                        }
                        let _e3053 = phi_1335_;
                        let _e3056 = local_15.member[1u];
                        if (_e3056[0] < 0f) {
                            phi_1348_ = -(_e3056[0]);
                        } else {
                            phi_1348_ = _e3056[0];
                        }
                        let _e3063 = phi_1348_;
                        if (_e3056[1] < 0f) {
                            phi_1355_ = -(_e3056[1]);
                        } else {
                            phi_1355_ = _e3056[1];
                        }
                        let _e3067 = phi_1355_;
                        if (_e3063 > _e3067) {
                            phi_1360_ = _e3063;
                        } else {
                            phi_1360_ = _e3067;
                        }
                        let _e3070 = phi_1360_;
                        if (_e3056[2] < 0f) {
                            phi_1367_ = -(_e3056[2]);
                        } else {
                            phi_1367_ = _e3056[2];
                        }
                        let _e3074 = phi_1367_;
                        if (_e3070 > _e3074) {
                            phi_1372_ = _e3070;
                        } else {
                            phi_1372_ = _e3074;
                        }
                        let _e3077 = phi_1372_;
                        if (_e3053 > _e3077) {
                            phi_1377_ = _e3053;
                        } else {
                            phi_1377_ = _e3077;
                        }
                        let _e3080 = phi_1377_;
                        let _e3082 = local_15.member_3;
                        let _e3086 = local_15.member_1[0u];
                        if (_e3086[0] < 0f) {
                            phi_1394_ = -(_e3086[0]);
                        } else {
                            phi_1394_ = _e3086[0];
                        }
                        let _e3093 = phi_1394_;
                        if (_e3086[1] < 0f) {
                            phi_1401_ = -(_e3086[1]);
                        } else {
                            phi_1401_ = _e3086[1];
                        }
                        let _e3097 = phi_1401_;
                        if (_e3093 > _e3097) {
                            phi_1406_ = _e3093;
                        } else {
                            phi_1406_ = _e3097;
                        }
                        let _e3100 = phi_1406_;
                        if (_e3086[2] < 0f) {
                            phi_1413_ = -(_e3086[2]);
                        } else {
                            phi_1413_ = _e3086[2];
                        }
                        let _e3104 = phi_1413_;
                        if (_e3100 > _e3104) {
                            phi_1418_ = _e3100;
                        } else {
                            phi_1418_ = _e3104;
                        }
                        let _e3107 = phi_1418_;
                        let _e3110 = local_15.member_1[1u];
                        if (_e3110[0] < 0f) {
                            phi_1432_ = -(_e3110[0]);
                        } else {
                            phi_1432_ = _e3110[0];
                        }
                        let _e3117 = phi_1432_;
                        if (_e3110[1] < 0f) {
                            phi_1439_ = -(_e3110[1]);
                        } else {
                            phi_1439_ = _e3110[1];
                        }
                        let _e3121 = phi_1439_;
                        if (_e3117 > _e3121) {
                            phi_1444_ = _e3117;
                        } else {
                            phi_1444_ = _e3121;
                        }
                        let _e3124 = phi_1444_;
                        if (_e3110[2] < 0f) {
                            phi_1451_ = -(_e3110[2]);
                        } else {
                            phi_1451_ = _e3110[2];
                        }
                        let _e3128 = phi_1451_;
                        if (_e3124 > _e3128) {
                            phi_1456_ = _e3124;
                        } else {
                            phi_1456_ = _e3128;
                        }
                        let _e3131 = phi_1456_;
                        if (_e3107 > _e3131) {
                            phi_1461_ = _e3107;
                        } else {
                            phi_1461_ = _e3131;
                        }
                        let _e3134 = phi_1461_;
                        let _e3136 = local_15.member_3;
                        let _e3140 = local_15.member_2[0u];
                        if (_e3140[0] < 0f) {
                            phi_1478_ = -(_e3140[0]);
                        } else {
                            phi_1478_ = _e3140[0];
                        }
                        let _e3147 = phi_1478_;
                        if (_e3140[1] < 0f) {
                            phi_1485_ = -(_e3140[1]);
                        } else {
                            phi_1485_ = _e3140[1];
                        }
                        let _e3151 = phi_1485_;
                        if (_e3147 > _e3151) {
                            phi_1490_ = _e3147;
                        } else {
                            phi_1490_ = _e3151;
                        }
                        let _e3154 = phi_1490_;
                        if (_e3140[2] < 0f) {
                            phi_1497_ = -(_e3140[2]);
                        } else {
                            phi_1497_ = _e3140[2];
                        }
                        let _e3158 = phi_1497_;
                        if (_e3154 > _e3158) {
                            phi_1502_ = _e3154;
                        } else {
                            phi_1502_ = _e3158;
                        }
                        let _e3161 = phi_1502_;
                        let _e3164 = local_15.member_2[1u];
                        if (_e3164[0] < 0f) {
                            phi_1516_ = -(_e3164[0]);
                        } else {
                            phi_1516_ = _e3164[0];
                        }
                        let _e3171 = phi_1516_;
                        if (_e3164[1] < 0f) {
                            phi_1523_ = -(_e3164[1]);
                        } else {
                            phi_1523_ = _e3164[1];
                        }
                        let _e3175 = phi_1523_;
                        if (_e3171 > _e3175) {
                            phi_1528_ = _e3171;
                        } else {
                            phi_1528_ = _e3175;
                        }
                        let _e3178 = phi_1528_;
                        if (_e3164[2] < 0f) {
                            phi_1535_ = -(_e3164[2]);
                        } else {
                            phi_1535_ = _e3164[2];
                        }
                        let _e3182 = phi_1535_;
                        if (_e3178 > _e3182) {
                            phi_1540_ = _e3178;
                        } else {
                            phi_1540_ = _e3182;
                        }
                        let _e3185 = phi_1540_;
                        if (_e3161 > _e3185) {
                            phi_1545_ = _e3161;
                        } else {
                            phi_1545_ = _e3185;
                        }
                        let _e3188 = phi_1545_;
                        let _e3190 = local_15.member_3;
                        let _e3197 = local_15.member_3;
                        phi_1561_ = type_19(0u, 48u);
                        phi_1564_ = 0f;
                        loop {
                            let _e3203 = phi_1561_;
                            let _e3205 = phi_1564_;
                            local_82 = _e3205;
                            local_40 = _e3205;
                            local_41 = _e3205;
                            local_42 = _e3205;
                            local_43 = _e3205;
                            if (_e3203.member < _e3203.member_1) {
                                phi_1562_ = type_19((_e3203.member + 1u), _e3203.member_1);
                                phi_1587_ = type_19(1u, _e3203.member);
                            } else {
                                phi_1562_ = _e3203;
                                phi_1587_ = type_19(0u, type_19().member_1);
                            }
                            let _e3217 = phi_1562_;
                            let _e3219 = phi_1587_;
                            if (bitcast<i32>(_e3219.member) != 0i) {
                                let _e3225 = local_15.member[0u];
                                let _e3231 = local_15.member[1u];
                                let _e3241 = (_e3225[0] + ((_e3231[0] - _e3225[0]) * _e3205));
                                let _e3242 = (_e3225[1] + ((_e3231[1] - _e3225[1]) * _e3205));
                                let _e3243 = (_e3225[2] + ((_e3231[2] - _e3225[2]) * _e3205));
                                let _e3246 = local_15.member_1[0u];
                                let _e3252 = local_15.member_1[1u];
                                let _e3262 = (_e3246[0] + ((_e3252[0] - _e3246[0]) * _e3205));
                                let _e3263 = (_e3246[1] + ((_e3252[1] - _e3246[1]) * _e3205));
                                let _e3264 = (_e3246[2] + ((_e3252[2] - _e3246[2]) * _e3205));
                                let _e3267 = local_15.member_2[0u];
                                let _e3273 = local_15.member_2[1u];
                                let _e3283 = (_e3267[0] + ((_e3273[0] - _e3267[0]) * _e3205));
                                let _e3284 = (_e3267[1] + ((_e3273[1] - _e3267[1]) * _e3205));
                                let _e3285 = (_e3267[2] + ((_e3273[2] - _e3267[2]) * _e3205));
                                let _e3290 = (((_e3262 * _e3262) + (_e3263 * _e3263)) + (_e3264 * _e3264));
                                let _e3295 = (((_e3262 * _e3283) + (_e3263 * _e3284)) + (_e3264 * _e3285));
                                let _e3300 = (((_e3283 * _e3283) + (_e3284 * _e3284)) + (_e3285 * _e3285));
                                let _e3305 = (((_e3241 * _e3262) + (_e3242 * _e3263)) + (_e3243 * _e3264));
                                let _e3310 = (((_e3241 * _e3283) + (_e3242 * _e3284)) + (_e3243 * _e3285));
                                let _e3313 = ((_e3290 * _e3300) - (_e3295 * _e3295));
                                let _e3317 = (((_e3305 * _e3300) - (_e3310 * _e3295)) / _e3313);
                                let _e3321 = (((_e3310 * _e3290) - (_e3305 * _e3295)) / _e3313);
                                if (_e3317 >= 0f) {
                                    if (_e3321 >= 0f) {
                                        if (_e3317 <= 1f) {
                                            phi_1741_ = (_e3321 <= 1f);
                                            phi_1742_ = false;
                                        } else {
                                            phi_1741_ = bool();
                                            phi_1742_ = true;
                                        }
                                        let _e3327 = phi_1741_;
                                        let _e3329 = phi_1742_;
                                        phi_1743_ = _e3327;
                                        phi_1744_ = _e3329;
                                    } else {
                                        phi_1743_ = bool();
                                        phi_1744_ = true;
                                    }
                                    let _e3331 = phi_1743_;
                                    let _e3333 = phi_1744_;
                                    phi_1745_ = _e3331;
                                    phi_1746_ = _e3333;
                                } else {
                                    phi_1745_ = bool();
                                    phi_1746_ = true;
                                }
                                let _e3335 = phi_1745_;
                                let _e3337 = phi_1746_;
                                if _e3337 {
                                    phi_1750_ = false;
                                } else {
                                    phi_1750_ = _e3335;
                                }
                                let _e3339 = phi_1750_;
                                if (_e3313 > 0f) {
                                    if _e3339 {
                                        phi_1790_ = array<f32, 3>((_e3241 - ((_e3262 * _e3317) + (_e3283 * _e3321))), (_e3242 - ((_e3263 * _e3317) + (_e3284 * _e3321))), (_e3243 - ((_e3264 * _e3317) + (_e3285 * _e3321))));
                                        phi_1791_ = false;
                                    } else {
                                        phi_1790_ = array<f32, 3>();
                                        phi_1791_ = true;
                                    }
                                    let _e3355 = phi_1790_;
                                    let _e3357 = phi_1791_;
                                    phi_1792_ = _e3355;
                                    phi_1793_ = _e3357;
                                } else {
                                    phi_1792_ = array<f32, 3>();
                                    phi_1793_ = true;
                                }
                                let _e3359 = phi_1792_;
                                let _e3361 = phi_1793_;
                                if _e3361 {
                                    let _e3362 = (_e3241 - _e3262);
                                    let _e3363 = (_e3242 - _e3263);
                                    let _e3364 = (_e3243 - _e3264);
                                    let _e3375 = ((((_e3241 * _e3262) + (_e3242 * _e3263)) + (_e3243 * _e3264)) / (((_e3262 * _e3262) + (_e3263 * _e3263)) + (_e3264 * _e3264)));
                                    if (_e3375 > 0f) {
                                        if (_e3375 < 1f) {
                                            phi_1823_ = _e3375;
                                        } else {
                                            phi_1823_ = 1f;
                                        }
                                        let _e3379 = phi_1823_;
                                        phi_1824_ = _e3379;
                                    } else {
                                        phi_1824_ = 0f;
                                    }
                                    let _e3381 = phi_1824_;
                                    let _e3398 = ((((_e3241 * _e3283) + (_e3242 * _e3284)) + (_e3243 * _e3285)) / (((_e3283 * _e3283) + (_e3284 * _e3284)) + (_e3285 * _e3285)));
                                    if (_e3398 > 0f) {
                                        if (_e3398 < 1f) {
                                            phi_1851_ = _e3398;
                                        } else {
                                            phi_1851_ = 1f;
                                        }
                                        let _e3402 = phi_1851_;
                                        phi_1852_ = _e3402;
                                    } else {
                                        phi_1852_ = 0f;
                                    }
                                    let _e3404 = phi_1852_;
                                    let _e3421 = ((((_e3362 * _e3283) + (_e3363 * _e3284)) + (_e3364 * _e3285)) / (((_e3283 * _e3283) + (_e3284 * _e3284)) + (_e3285 * _e3285)));
                                    if (_e3421 > 0f) {
                                        if (_e3421 < 1f) {
                                            phi_1879_ = _e3421;
                                        } else {
                                            phi_1879_ = 1f;
                                        }
                                        let _e3425 = phi_1879_;
                                        phi_1880_ = _e3425;
                                    } else {
                                        phi_1880_ = 0f;
                                    }
                                    let _e3427 = phi_1880_;
                                    let _e3434 = (_e3241 - _e3283);
                                    let _e3435 = (_e3242 - _e3284);
                                    let _e3436 = (_e3243 - _e3285);
                                    let _e3447 = ((((_e3434 * _e3262) + (_e3435 * _e3263)) + (_e3436 * _e3264)) / (((_e3262 * _e3262) + (_e3263 * _e3263)) + (_e3264 * _e3264)));
                                    if (_e3447 > 0f) {
                                        if (_e3447 < 1f) {
                                            phi_1910_ = _e3447;
                                        } else {
                                            phi_1910_ = 1f;
                                        }
                                        let _e3451 = phi_1910_;
                                        phi_1911_ = _e3451;
                                    } else {
                                        phi_1911_ = 0f;
                                    }
                                    let _e3453 = phi_1911_;
                                    local_11[0u] = array<f32, 3>((_e3241 - (_e3262 * _e3381)), (_e3242 - (_e3263 * _e3381)), (_e3243 - (_e3264 * _e3381)));
                                    local_11[1u] = array<f32, 3>((_e3241 - (_e3283 * _e3404)), (_e3242 - (_e3284 * _e3404)), (_e3243 - (_e3285 * _e3404)));
                                    local_11[2u] = array<f32, 3>((_e3362 - (_e3283 * _e3427)), (_e3363 - (_e3284 * _e3427)), (_e3364 - (_e3285 * _e3427)));
                                    local_11[3u] = array<f32, 3>((_e3434 - (_e3262 * _e3453)), (_e3435 - (_e3263 * _e3453)), (_e3436 - (_e3264 * _e3453)));
                                    let _e3469 = local_11[0u];
                                    phi_2054_ = type_19(1u, 4u);
                                    phi_2057_ = array<f32, 3>(_e3469[0], _e3469[1], _e3469[2]);
                                    loop {
                                        let _e3475 = phi_2054_;
                                        let _e3477 = phi_2057_;
                                        local_69 = _e3477;
                                        if (_e3475.member < _e3475.member_1) {
                                            phi_2055_ = type_19((_e3475.member + 1u), _e3475.member_1);
                                            phi_2080_ = type_19(1u, _e3475.member);
                                        } else {
                                            phi_2055_ = _e3475;
                                            phi_2080_ = type_19(0u, type_19().member_1);
                                        }
                                        let _e3489 = phi_2055_;
                                        let _e3491 = phi_2080_;
                                        let _e3495 = (bitcast<i32>(_e3491.member) != 0i);
                                        if _e3495 {
                                            let _e3497 = local_11[_e3491.member_1];
                                            let _e3502 = local_11[_e3491.member_1];
                                            if ((((_e3497[0] * _e3502[0]) + (_e3497[1] * _e3502[1])) + (_e3497[2] * _e3502[2])) < (((_e3477[0] * _e3477[0]) + (_e3477[1] * _e3477[1])) + (_e3477[2] * _e3477[2]))) {
                                                let _e3524 = local_11[_e3491.member_1];
                                                phi_2147_ = array<f32, 3>(_e3524[0], _e3524[1], _e3524[2]);
                                            } else {
                                                phi_2147_ = _e3477;
                                            }
                                            let _e3530 = phi_2147_;
                                            phi_2058_ = _e3530;
                                        } else {
                                            phi_2058_ = array<f32, 3>();
                                        }
                                        let _e3532 = phi_2058_;
                                        continue;
                                        continuing {
                                            phi_2054_ = _e3489;
                                            phi_2057_ = _e3532;
                                            break if !(_e3495);
                                        }
                                    }
                                    let _e5309 = local_69;
                                    phi_2148_ = _e5309;
                                } else {
                                    phi_2148_ = _e3359;
                                }
                                let _e3535 = phi_2148_;
                                if (_e3535[0] < 0f) {
                                    phi_2155_ = -(_e3535[0]);
                                } else {
                                    phi_2155_ = _e3535[0];
                                }
                                let _e3540 = phi_2155_;
                                if (_e3535[1] < 0f) {
                                    phi_2162_ = -(_e3535[1]);
                                } else {
                                    phi_2162_ = _e3535[1];
                                }
                                let _e3545 = phi_2162_;
                                if (_e3535[2] < 0f) {
                                    phi_2170_ = -(_e3535[2]);
                                } else {
                                    phi_2170_ = _e3535[2];
                                }
                                let _e3551 = phi_2170_;
                                let _e3552 = ((_e3540 + _e3545) + _e3551);
                                if (_e3552 > 0f) {
                                    if ((bitcast<u32>(_e3552) & 2139095040u) != 2139095040u) {
                                        let _e3557 = (1f / _e3552);
                                        let _e3559 = (_e3535[0] * _e3557);
                                        let _e3561 = (_e3535[1] * _e3557);
                                        let _e3563 = (_e3535[2] * _e3557);
                                        let _e3568 = (((_e3559 * _e3559) + (_e3561 * _e3561)) + (_e3563 * _e3563));
                                        if (_e3568 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3568 > 0f) {
                                                phi_2207_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2207_ = 0f;
                                            }
                                            let _e3621 = phi_2207_;
                                            phi_2271_ = _e3621;
                                        } else {
                                            phi_2214_ = type_17(0i, 5i);
                                            phi_2217_ = bitcast<f32>(((bitcast<u32>(_e3568) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3576 = phi_2214_;
                                                let _e3578 = phi_2217_;
                                                local_34 = _e3578;
                                                if (_e3576.member < _e3576.member_1) {
                                                    let _e3585 = (_e3576.member + 1i);
                                                    if ((false == (_e3585 > _e3576.member)) != false) {
                                                        phi_2238_ = true;
                                                    } else {
                                                        phi_2238_ = false;
                                                    }
                                                    let _e3590 = phi_2238_;
                                                    if _e3590 {
                                                        phi_2244_ = type_18(0u, type_18().member_1);
                                                    } else {
                                                        phi_2244_ = type_18(1u, _e3585);
                                                    }
                                                    let _e3595 = phi_2244_;
                                                    phi_2215_ = type_17(_e3595.member_1, _e3576.member_1);
                                                    phi_2258_ = type_18(1u, _e3576.member);
                                                } else {
                                                    phi_2215_ = _e3576;
                                                    phi_2258_ = type_18(0u, type_18().member_1);
                                                }
                                                let _e3601 = phi_2215_;
                                                let _e3603 = phi_2258_;
                                                let _e3606 = (bitcast<i32>(_e3603.member) != 0i);
                                                if _e3606 {
                                                    phi_2218_ = (0.5f * (_e3578 + (_e3568 / _e3578)));
                                                } else {
                                                    phi_2218_ = f32();
                                                }
                                                let _e3611 = phi_2218_;
                                                continue;
                                                continuing {
                                                    phi_2214_ = _e3601;
                                                    phi_2217_ = _e3611;
                                                    break if !(_e3606);
                                                }
                                            }
                                            let _e3616 = local_34;
                                            phi_2271_ = (_e3616 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3623 = phi_2271_;
                                        phi_2280_ = type_19(0u, 4u);
                                        phi_2283_ = 2f;
                                        loop {
                                            let _e3631 = phi_2280_;
                                            let _e3633 = phi_2283_;
                                            local_36 = _e3633;
                                            local_37 = _e3633;
                                            local_38 = _e3633;
                                            local_72 = _e3633;
                                            local_73 = _e3633;
                                            if (_e3631.member < _e3631.member_1) {
                                                phi_2281_ = type_19((_e3631.member + 1u), _e3631.member_1);
                                                phi_2306_ = type_19(1u, _e3631.member);
                                            } else {
                                                phi_2281_ = _e3631;
                                                phi_2306_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e3645 = phi_2281_;
                                            let _e3647 = phi_2306_;
                                            if (bitcast<i32>(_e3647.member) != 0i) {
                                                let _e3653 = local_12[_e3647.member_1];
                                                let _e3661 = (((_e3559 * _e3653[0]) + (_e3561 * _e3653[1])) + (_e3563 * _e3653[2]));
                                                let _e3663 = local_13[_e3647.member_1];
                                                let _e3671 = (((_e3559 * _e3663[0]) + (_e3561 * _e3663[1])) + (_e3563 * _e3663[2]));
                                                if (_e3661 < 0f) {
                                                    phi_2357_ = -(_e3661);
                                                } else {
                                                    phi_2357_ = _e3661;
                                                }
                                                let _e3675 = phi_2357_;
                                                if (_e3671 < 0f) {
                                                    phi_2363_ = -(_e3671);
                                                } else {
                                                    phi_2363_ = _e3671;
                                                }
                                                let _e3679 = phi_2363_;
                                                let _e3683 = (((((((((_e3080 + _e3082) + (_e3134 + _e3136)) + (_e3188 + _e3190)) * (0.000000059604645f * 16f)) + (_e3197 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e256 * _e3623) * (1f + (0.000000059604645f * 8f)))) + ((_e3675 + _e3679) * (0.000000059604645f * 8f)));
                                                if (_e3661 > _e3683) {
                                                    if (_e3671 > _e3683) {
                                                        phi_2376_ = false;
                                                    } else {
                                                        phi_2376_ = true;
                                                    }
                                                    let _e3687 = phi_2376_;
                                                    phi_2377_ = _e3687;
                                                } else {
                                                    phi_2377_ = true;
                                                }
                                                let _e3689 = phi_2377_;
                                                if _e3689 {
                                                    if ((_e3661 + ((_e3671 - _e3661) * _e3205)) > _e3683) {
                                                        if (_e3671 < _e3661) {
                                                            let _e3697 = ((_e3661 - _e3671) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                            if _e3697 {
                                                                let _e3703 = (((_e3661 - _e3683) / (_e3661 - _e3671)) * (1f - (0.000000059604645f * 16f)));
                                                                if (_e3633 < _e3703) {
                                                                    phi_2408_ = _e3633;
                                                                } else {
                                                                    phi_2408_ = _e3703;
                                                                }
                                                                let _e3706 = phi_2408_;
                                                                phi_2409_ = _e3706;
                                                            } else {
                                                                phi_2409_ = f32();
                                                            }
                                                            let _e3708 = phi_2409_;
                                                            phi_2410_ = _e3708;
                                                            phi_2411_ = _e3697;
                                                        } else {
                                                            phi_2410_ = _e3633;
                                                            phi_2411_ = true;
                                                        }
                                                        let _e3710 = phi_2410_;
                                                        let _e3712 = phi_2411_;
                                                        if _e3712 {
                                                            phi_2415_ = false;
                                                        } else {
                                                            phi_2415_ = true;
                                                        }
                                                        let _e3714 = phi_2415_;
                                                        phi_2416_ = _e3710;
                                                        phi_2417_ = _e3712;
                                                        phi_2418_ = _e3714;
                                                        phi_2419_ = false;
                                                    } else {
                                                        phi_2416_ = f32();
                                                        phi_2417_ = false;
                                                        phi_2418_ = false;
                                                        phi_2419_ = true;
                                                    }
                                                    let _e3716 = phi_2416_;
                                                    let _e3718 = phi_2417_;
                                                    let _e3720 = phi_2418_;
                                                    let _e3722 = phi_2419_;
                                                    phi_2420_ = _e3716;
                                                    phi_2421_ = _e3718;
                                                    phi_2422_ = _e3720;
                                                    phi_2423_ = _e3722;
                                                } else {
                                                    phi_2420_ = _e3633;
                                                    phi_2421_ = true;
                                                    phi_2422_ = false;
                                                    phi_2423_ = false;
                                                }
                                                let _e3724 = phi_2420_;
                                                let _e3726 = phi_2421_;
                                                let _e3728 = phi_2422_;
                                                let _e3730 = phi_2423_;
                                                phi_2284_ = _e3724;
                                                phi_2424_ = _e3726;
                                                phi_2425_ = false;
                                                phi_2426_ = _e3728;
                                                phi_2427_ = _e3730;
                                            } else {
                                                phi_2284_ = f32();
                                                phi_2424_ = false;
                                                phi_2425_ = true;
                                                phi_2426_ = false;
                                                phi_2427_ = false;
                                            }
                                            let _e3732 = phi_2284_;
                                            let _e3734 = phi_2424_;
                                            let _e3736 = phi_2425_;
                                            let _e3738 = phi_2426_;
                                            let _e3740 = phi_2427_;
                                            local_35 = _e3736;
                                            local_70 = _e3738;
                                            local_71 = _e3740;
                                            continue;
                                            continuing {
                                                phi_2280_ = _e3645;
                                                phi_2283_ = _e3732;
                                                break if !(_e3734);
                                            }
                                        }
                                        let _e3743 = local_35;
                                        if _e3743 {
                                            let _e3745 = local_36;
                                            let _e3746 = (_e3745 > 1f);
                                            if _e3746 {
                                                phi_2448_ = false;
                                                phi_2449_ = false;
                                                phi_2450_ = false;
                                            } else {
                                                let _e3748 = local_37;
                                                if (_e3748 > _e3205) {
                                                    let _e3751 = local_38;
                                                    let _e3753 = ((_e3751 - _e3205) < 0.00000000023283064f);
                                                    if _e3753 {
                                                        phi_2444_ = false;
                                                    } else {
                                                        phi_2444_ = true;
                                                    }
                                                    let _e3755 = phi_2444_;
                                                    phi_2445_ = _e3755;
                                                    phi_2446_ = _e3753;
                                                    phi_2447_ = false;
                                                } else {
                                                    phi_2445_ = false;
                                                    phi_2446_ = false;
                                                    phi_2447_ = true;
                                                }
                                                let _e3757 = phi_2445_;
                                                let _e3759 = phi_2446_;
                                                let _e3761 = phi_2447_;
                                                phi_2448_ = _e3757;
                                                phi_2449_ = _e3759;
                                                phi_2450_ = _e3761;
                                            }
                                            let _e3763 = phi_2448_;
                                            let _e3765 = phi_2449_;
                                            let _e3767 = phi_2450_;
                                            phi_2451_ = _e3763;
                                            phi_2452_ = _e3746;
                                            phi_2453_ = _e3765;
                                            phi_2454_ = _e3767;
                                            phi_2455_ = false;
                                            phi_2456_ = false;
                                        } else {
                                            phi_2451_ = false;
                                            phi_2452_ = false;
                                            phi_2453_ = false;
                                            phi_2454_ = false;
                                            let _e5366 = local_70;
                                            phi_2455_ = _e5366;
                                            let _e5369 = local_71;
                                            phi_2456_ = _e5369;
                                        }
                                        let _e3769 = phi_2451_;
                                        let _e3771 = phi_2452_;
                                        let _e3773 = phi_2453_;
                                        let _e3775 = phi_2454_;
                                        let _e3777 = phi_2455_;
                                        let _e3779 = phi_2456_;
                                        let _e5372 = local_72;
                                        phi_2457_ = _e5372;
                                        let _e5375 = local_73;
                                        phi_2458_ = _e5375;
                                        phi_2459_ = _e3769;
                                        phi_2460_ = _e3771;
                                        phi_2461_ = _e3773;
                                        phi_2462_ = _e3775;
                                        phi_2463_ = _e3777;
                                        phi_2464_ = _e3779;
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
                                    let _e3781 = phi_2457_;
                                    let _e3783 = phi_2458_;
                                    let _e3785 = phi_2459_;
                                    let _e3787 = phi_2460_;
                                    let _e3789 = phi_2461_;
                                    let _e3791 = phi_2462_;
                                    let _e3793 = phi_2463_;
                                    let _e3795 = phi_2464_;
                                    let _e3797 = phi_2465_;
                                    phi_2466_ = _e3781;
                                    phi_2467_ = _e3783;
                                    phi_2468_ = _e3785;
                                    phi_2469_ = _e3787;
                                    phi_2470_ = _e3789;
                                    phi_2471_ = _e3791;
                                    phi_2472_ = _e3793;
                                    phi_2473_ = _e3795;
                                    phi_2474_ = _e3797;
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
                                let _e3799 = phi_2466_;
                                let _e3801 = phi_2467_;
                                let _e3803 = phi_2468_;
                                let _e3805 = phi_2469_;
                                let _e3807 = phi_2470_;
                                let _e3809 = phi_2471_;
                                let _e3811 = phi_2472_;
                                let _e3813 = phi_2473_;
                                let _e3815 = phi_2474_;
                                let _e3817 = phi_2475_;
                                phi_2476_ = _e3799;
                                phi_1565_ = _e3801;
                                phi_2477_ = _e3803;
                                phi_2478_ = _e3805;
                                phi_2479_ = _e3807;
                                phi_2480_ = false;
                                phi_2481_ = _e3809;
                                phi_2482_ = _e3811;
                                phi_2483_ = _e3813;
                                phi_2484_ = _e3815;
                                phi_2485_ = _e3817;
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
                            let _e3819 = phi_2476_;
                            let _e3821 = phi_1565_;
                            let _e3823 = phi_2477_;
                            let _e3825 = phi_2478_;
                            let _e3827 = phi_2479_;
                            let _e3829 = phi_2480_;
                            let _e3831 = phi_2481_;
                            let _e3833 = phi_2482_;
                            let _e3835 = phi_2483_;
                            let _e3837 = phi_2484_;
                            let _e3839 = phi_2485_;
                            local_39 = _e3825;
                            local_74 = _e3827;
                            local_75 = _e3829;
                            local_76 = _e3831;
                            local_77 = _e3833;
                            local_78 = _e3835;
                            local_79 = _e3837;
                            local_80 = _e3839;
                            local_81 = _e3819;
                            local_83 = _e3825;
                            continue;
                            continuing {
                                phi_1561_ = _e3217;
                                phi_1564_ = _e3821;
                                break if !(_e3823);
                            }
                        }
                        let _e3842 = local_39;
                        if _e3842 {
                            phi_2490_ = type_32(0u, type_32().member_1);
                            phi_2491_ = false;
                            phi_2492_ = false;
                            phi_2493_ = false;
                            phi_2494_ = false;
                            phi_2495_ = false;
                            phi_2496_ = false;
                            phi_2497_ = false;
                        } else {
                            phi_2490_ = type_32();
                            let _e5408 = local_74;
                            phi_2491_ = _e5408;
                            let _e5411 = local_75;
                            phi_2492_ = _e5411;
                            let _e5414 = local_76;
                            phi_2493_ = _e5414;
                            let _e5417 = local_77;
                            phi_2494_ = _e5417;
                            let _e5420 = local_78;
                            phi_2495_ = _e5420;
                            let _e5423 = local_79;
                            phi_2496_ = _e5423;
                            let _e5426 = local_80;
                            phi_2497_ = _e5426;
                        }
                        let _e3846 = phi_2490_;
                        let _e3848 = phi_2491_;
                        let _e3850 = phi_2492_;
                        let _e3852 = phi_2493_;
                        let _e3854 = phi_2494_;
                        let _e3856 = phi_2495_;
                        let _e3858 = phi_2496_;
                        let _e3860 = phi_2497_;
                        if _e3848 {
                            let _e5429 = local_81;
                            phi_2501_ = _e5429;
                            phi_2502_ = true;
                            phi_2503_ = false;
                            phi_2504_ = false;
                            phi_2505_ = false;
                            phi_2506_ = false;
                            phi_2507_ = false;
                            phi_2508_ = false;
                        } else {
                            let _e5431 = local_82;
                            phi_2501_ = _e5431;
                            phi_2502_ = _e3850;
                            phi_2503_ = _e3852;
                            phi_2504_ = _e3854;
                            phi_2505_ = _e3856;
                            let _e5438 = local_83;
                            phi_2506_ = _e5438;
                            phi_2507_ = _e3858;
                            phi_2508_ = _e3860;
                        }
                        let _e3862 = phi_2501_;
                        let _e3864 = phi_2502_;
                        let _e3866 = phi_2503_;
                        let _e3868 = phi_2504_;
                        let _e3870 = phi_2505_;
                        let _e3872 = phi_2506_;
                        let _e3874 = phi_2507_;
                        let _e3876 = phi_2508_;
                        if _e3864 {
                            phi_2513_ = type_32(1u, _e3862);
                            phi_2514_ = false;
                            phi_2515_ = false;
                            phi_2516_ = false;
                            phi_2517_ = false;
                            phi_2518_ = false;
                            phi_2519_ = false;
                        } else {
                            phi_2513_ = type_32();
                            phi_2514_ = _e3866;
                            phi_2515_ = _e3868;
                            phi_2516_ = _e3870;
                            phi_2517_ = _e3872;
                            phi_2518_ = _e3874;
                            phi_2519_ = _e3876;
                        }
                        let _e3879 = phi_2513_;
                        let _e3881 = phi_2514_;
                        let _e3883 = phi_2515_;
                        let _e3885 = phi_2516_;
                        let _e3887 = phi_2517_;
                        let _e3889 = phi_2518_;
                        let _e3891 = phi_2519_;
                        if _e3881 {
                            let _e3893 = local_40;
                            phi_2524_ = type_32(1u, _e3893);
                            phi_2525_ = false;
                            phi_2526_ = false;
                            phi_2527_ = true;
                            phi_2528_ = false;
                            phi_2529_ = false;
                        } else {
                            phi_2524_ = _e3846;
                            phi_2525_ = _e3883;
                            phi_2526_ = _e3885;
                            phi_2527_ = _e3887;
                            phi_2528_ = _e3889;
                            phi_2529_ = _e3891;
                        }
                        let _e3896 = phi_2524_;
                        let _e3898 = phi_2525_;
                        let _e3900 = phi_2526_;
                        let _e3902 = phi_2527_;
                        let _e3904 = phi_2528_;
                        let _e3906 = phi_2529_;
                        if _e3898 {
                            let _e3908 = local_41;
                            phi_2534_ = type_32(1u, _e3908);
                            phi_2535_ = false;
                            phi_2536_ = false;
                            phi_2537_ = false;
                            phi_2538_ = false;
                        } else {
                            phi_2534_ = type_32();
                            phi_2535_ = _e3900;
                            phi_2536_ = _e3902;
                            phi_2537_ = _e3904;
                            phi_2538_ = _e3906;
                        }
                        let _e3911 = phi_2534_;
                        let _e3913 = phi_2535_;
                        let _e3915 = phi_2536_;
                        let _e3917 = phi_2537_;
                        let _e3919 = phi_2538_;
                        if _e3913 {
                            let _e3921 = local_42;
                            phi_2543_ = type_32(1u, _e3921);
                            phi_2544_ = true;
                            phi_2545_ = false;
                            phi_2546_ = false;
                            phi_2547_ = false;
                        } else {
                            phi_2543_ = _e3911;
                            phi_2544_ = _e3898;
                            phi_2545_ = _e3915;
                            phi_2546_ = _e3917;
                            phi_2547_ = _e3919;
                        }
                        let _e3924 = phi_2543_;
                        let _e3926 = phi_2544_;
                        let _e3928 = phi_2545_;
                        let _e3930 = phi_2546_;
                        let _e3932 = phi_2547_;
                        if _e3926 {
                            phi_2551_ = _e3924;
                            phi_2552_ = true;
                            phi_2553_ = false;
                            phi_2554_ = false;
                        } else {
                            phi_2551_ = _e3896;
                            phi_2552_ = _e3928;
                            phi_2553_ = _e3930;
                            phi_2554_ = _e3932;
                        }
                        let _e3934 = phi_2551_;
                        let _e3936 = phi_2552_;
                        let _e3938 = phi_2553_;
                        let _e3940 = phi_2554_;
                        if _e3936 {
                            phi_2558_ = false;
                            phi_2559_ = false;
                        } else {
                            phi_2558_ = _e3938;
                            phi_2559_ = _e3940;
                        }
                        let _e3942 = phi_2558_;
                        let _e3944 = phi_2559_;
                        if _e3942 {
                            phi_2563_ = false;
                            phi_2564_ = false;
                        } else {
                            phi_2563_ = _e3944;
                            phi_2564_ = _e3936;
                        }
                        let _e3946 = phi_2563_;
                        let _e3948 = phi_2564_;
                        if _e3946 {
                            phi_2568_ = true;
                            phi_2569_ = false;
                        } else {
                            phi_2568_ = _e3942;
                            phi_2569_ = _e3948;
                        }
                        let _e3950 = phi_2568_;
                        let _e3952 = phi_2569_;
                        if _e3950 {
                            let _e3954 = local_43;
                            phi_2574_ = type_32(1u, _e3954);
                            phi_2575_ = true;
                        } else {
                            phi_2574_ = _e3934;
                            phi_2575_ = _e3952;
                        }
                        let _e3957 = phi_2574_;
                        let _e3959 = phi_2575_;
                        if _e3959 {
                            phi_2579_ = _e3957;
                        } else {
                            phi_2579_ = _e3879;
                        }
                        let _e3961 = phi_2579_;
                        if (_e3961.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_2593_ = type_19(0u, 3u);
                            loop {
                                let _e3973 = phi_2593_;
                                if (_e3973.member < _e3973.member_1) {
                                    phi_2594_ = type_19((_e3973.member + 1u), _e3973.member_1);
                                    phi_2617_ = type_19(1u, _e3973.member);
                                } else {
                                    phi_2594_ = _e3973;
                                    phi_2617_ = type_19(0u, type_19().member_1);
                                }
                                let _e3985 = phi_2594_;
                                let _e3987 = phi_2617_;
                                if (bitcast<i32>(_e3987.member) != 0i) {
                                    let _e3993 = local_14[_e3987.member_1];
                                    let _e3994 = (_e3961.member_1 + _e3993);
                                    if (_e3994 < 1f) {
                                        phi_2637_ = _e3994;
                                    } else {
                                        phi_2637_ = 1f;
                                    }
                                    let _e3997 = phi_2637_;
                                    let _e4000 = local_15.member[0u];
                                    let _e4006 = local_15.member[1u];
                                    let _e4016 = (_e4000[0] + ((_e4006[0] - _e4000[0]) * _e3997));
                                    let _e4017 = (_e4000[1] + ((_e4006[1] - _e4000[1]) * _e3997));
                                    let _e4018 = (_e4000[2] + ((_e4006[2] - _e4000[2]) * _e3997));
                                    let _e4021 = local_15.member_1[0u];
                                    let _e4027 = local_15.member_1[1u];
                                    let _e4037 = (_e4021[0] + ((_e4027[0] - _e4021[0]) * _e3997));
                                    let _e4038 = (_e4021[1] + ((_e4027[1] - _e4021[1]) * _e3997));
                                    let _e4039 = (_e4021[2] + ((_e4027[2] - _e4021[2]) * _e3997));
                                    let _e4042 = local_15.member_2[0u];
                                    let _e4048 = local_15.member_2[1u];
                                    let _e4058 = (_e4042[0] + ((_e4048[0] - _e4042[0]) * _e3997));
                                    let _e4059 = (_e4042[1] + ((_e4048[1] - _e4042[1]) * _e3997));
                                    let _e4060 = (_e4042[2] + ((_e4048[2] - _e4042[2]) * _e3997));
                                    let _e4065 = (((_e4037 * _e4037) + (_e4038 * _e4038)) + (_e4039 * _e4039));
                                    let _e4070 = (((_e4037 * _e4058) + (_e4038 * _e4059)) + (_e4039 * _e4060));
                                    let _e4075 = (((_e4058 * _e4058) + (_e4059 * _e4059)) + (_e4060 * _e4060));
                                    let _e4080 = (((_e4016 * _e4037) + (_e4017 * _e4038)) + (_e4018 * _e4039));
                                    let _e4085 = (((_e4016 * _e4058) + (_e4017 * _e4059)) + (_e4018 * _e4060));
                                    let _e4088 = ((_e4065 * _e4075) - (_e4070 * _e4070));
                                    let _e4092 = (((_e4080 * _e4075) - (_e4085 * _e4070)) / _e4088);
                                    let _e4096 = (((_e4085 * _e4065) - (_e4080 * _e4070)) / _e4088);
                                    if (_e4092 >= 0f) {
                                        if (_e4096 >= 0f) {
                                            if (_e4092 <= 1f) {
                                                phi_2785_ = (_e4096 <= 1f);
                                                phi_2786_ = false;
                                            } else {
                                                phi_2785_ = bool();
                                                phi_2786_ = true;
                                            }
                                            let _e4102 = phi_2785_;
                                            let _e4104 = phi_2786_;
                                            phi_2787_ = _e4102;
                                            phi_2788_ = _e4104;
                                        } else {
                                            phi_2787_ = bool();
                                            phi_2788_ = true;
                                        }
                                        let _e4106 = phi_2787_;
                                        let _e4108 = phi_2788_;
                                        phi_2789_ = _e4106;
                                        phi_2790_ = _e4108;
                                    } else {
                                        phi_2789_ = bool();
                                        phi_2790_ = true;
                                    }
                                    let _e4110 = phi_2789_;
                                    let _e4112 = phi_2790_;
                                    if _e4112 {
                                        phi_2794_ = false;
                                    } else {
                                        phi_2794_ = _e4110;
                                    }
                                    let _e4114 = phi_2794_;
                                    if (_e4088 > 0f) {
                                        if _e4114 {
                                            phi_2834_ = array<f32, 3>((_e4016 - ((_e4037 * _e4092) + (_e4058 * _e4096))), (_e4017 - ((_e4038 * _e4092) + (_e4059 * _e4096))), (_e4018 - ((_e4039 * _e4092) + (_e4060 * _e4096))));
                                            phi_2835_ = false;
                                        } else {
                                            phi_2834_ = array<f32, 3>();
                                            phi_2835_ = true;
                                        }
                                        let _e4130 = phi_2834_;
                                        let _e4132 = phi_2835_;
                                        phi_2836_ = _e4130;
                                        phi_2837_ = _e4132;
                                    } else {
                                        phi_2836_ = array<f32, 3>();
                                        phi_2837_ = true;
                                    }
                                    let _e4134 = phi_2836_;
                                    let _e4136 = phi_2837_;
                                    if _e4136 {
                                        let _e4137 = (_e4016 - _e4037);
                                        let _e4138 = (_e4017 - _e4038);
                                        let _e4139 = (_e4018 - _e4039);
                                        let _e4150 = ((((_e4016 * _e4037) + (_e4017 * _e4038)) + (_e4018 * _e4039)) / (((_e4037 * _e4037) + (_e4038 * _e4038)) + (_e4039 * _e4039)));
                                        if (_e4150 > 0f) {
                                            if (_e4150 < 1f) {
                                                phi_2867_ = _e4150;
                                            } else {
                                                phi_2867_ = 1f;
                                            }
                                            let _e4154 = phi_2867_;
                                            phi_2868_ = _e4154;
                                        } else {
                                            phi_2868_ = 0f;
                                        }
                                        let _e4156 = phi_2868_;
                                        let _e4173 = ((((_e4016 * _e4058) + (_e4017 * _e4059)) + (_e4018 * _e4060)) / (((_e4058 * _e4058) + (_e4059 * _e4059)) + (_e4060 * _e4060)));
                                        if (_e4173 > 0f) {
                                            if (_e4173 < 1f) {
                                                phi_2895_ = _e4173;
                                            } else {
                                                phi_2895_ = 1f;
                                            }
                                            let _e4177 = phi_2895_;
                                            phi_2896_ = _e4177;
                                        } else {
                                            phi_2896_ = 0f;
                                        }
                                        let _e4179 = phi_2896_;
                                        let _e4196 = ((((_e4137 * _e4058) + (_e4138 * _e4059)) + (_e4139 * _e4060)) / (((_e4058 * _e4058) + (_e4059 * _e4059)) + (_e4060 * _e4060)));
                                        if (_e4196 > 0f) {
                                            if (_e4196 < 1f) {
                                                phi_2923_ = _e4196;
                                            } else {
                                                phi_2923_ = 1f;
                                            }
                                            let _e4200 = phi_2923_;
                                            phi_2924_ = _e4200;
                                        } else {
                                            phi_2924_ = 0f;
                                        }
                                        let _e4202 = phi_2924_;
                                        let _e4209 = (_e4016 - _e4058);
                                        let _e4210 = (_e4017 - _e4059);
                                        let _e4211 = (_e4018 - _e4060);
                                        let _e4222 = ((((_e4209 * _e4037) + (_e4210 * _e4038)) + (_e4211 * _e4039)) / (((_e4037 * _e4037) + (_e4038 * _e4038)) + (_e4039 * _e4039)));
                                        if (_e4222 > 0f) {
                                            if (_e4222 < 1f) {
                                                phi_2954_ = _e4222;
                                            } else {
                                                phi_2954_ = 1f;
                                            }
                                            let _e4226 = phi_2954_;
                                            phi_2955_ = _e4226;
                                        } else {
                                            phi_2955_ = 0f;
                                        }
                                        let _e4228 = phi_2955_;
                                        local_10[0u] = array<f32, 3>((_e4016 - (_e4037 * _e4156)), (_e4017 - (_e4038 * _e4156)), (_e4018 - (_e4039 * _e4156)));
                                        local_10[1u] = array<f32, 3>((_e4016 - (_e4058 * _e4179)), (_e4017 - (_e4059 * _e4179)), (_e4018 - (_e4060 * _e4179)));
                                        local_10[2u] = array<f32, 3>((_e4137 - (_e4058 * _e4202)), (_e4138 - (_e4059 * _e4202)), (_e4139 - (_e4060 * _e4202)));
                                        local_10[3u] = array<f32, 3>((_e4209 - (_e4037 * _e4228)), (_e4210 - (_e4038 * _e4228)), (_e4211 - (_e4039 * _e4228)));
                                        let _e4244 = local_10[0u];
                                        phi_3098_ = type_19(1u, 4u);
                                        phi_3101_ = array<f32, 3>(_e4244[0], _e4244[1], _e4244[2]);
                                        loop {
                                            let _e4250 = phi_3098_;
                                            let _e4252 = phi_3101_;
                                            local_84 = _e4252;
                                            if (_e4250.member < _e4250.member_1) {
                                                phi_3099_ = type_19((_e4250.member + 1u), _e4250.member_1);
                                                phi_3124_ = type_19(1u, _e4250.member);
                                            } else {
                                                phi_3099_ = _e4250;
                                                phi_3124_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e4264 = phi_3099_;
                                            let _e4266 = phi_3124_;
                                            let _e4270 = (bitcast<i32>(_e4266.member) != 0i);
                                            if _e4270 {
                                                let _e4272 = local_10[_e4266.member_1];
                                                let _e4277 = local_10[_e4266.member_1];
                                                if ((((_e4272[0] * _e4277[0]) + (_e4272[1] * _e4277[1])) + (_e4272[2] * _e4277[2])) < (((_e4252[0] * _e4252[0]) + (_e4252[1] * _e4252[1])) + (_e4252[2] * _e4252[2]))) {
                                                    let _e4299 = local_10[_e4266.member_1];
                                                    phi_3191_ = array<f32, 3>(_e4299[0], _e4299[1], _e4299[2]);
                                                } else {
                                                    phi_3191_ = _e4252;
                                                }
                                                let _e4305 = phi_3191_;
                                                phi_3102_ = _e4305;
                                            } else {
                                                phi_3102_ = array<f32, 3>();
                                            }
                                            let _e4307 = phi_3102_;
                                            continue;
                                            continuing {
                                                phi_3098_ = _e4264;
                                                phi_3101_ = _e4307;
                                                break if !(_e4270);
                                            }
                                        }
                                        let _e5512 = local_84;
                                        phi_3192_ = _e5512;
                                    } else {
                                        phi_3192_ = _e4134;
                                    }
                                    let _e4310 = phi_3192_;
                                    let _e4321 = (((_e4310[0] * _e4310[0]) + (_e4310[1] * _e4310[1])) + (_e4310[2] * _e4310[2]));
                                    if (_e4321 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4321 > 0f) {
                                            phi_3217_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3217_ = 0f;
                                        }
                                        let _e4374 = phi_3217_;
                                        phi_3281_ = _e4374;
                                    } else {
                                        phi_3224_ = type_17(0i, 5i);
                                        phi_3227_ = bitcast<f32>(((bitcast<u32>(_e4321) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4329 = phi_3224_;
                                            let _e4331 = phi_3227_;
                                            local_44 = _e4331;
                                            if (_e4329.member < _e4329.member_1) {
                                                let _e4338 = (_e4329.member + 1i);
                                                if ((false == (_e4338 > _e4329.member)) != false) {
                                                    phi_3248_ = true;
                                                } else {
                                                    phi_3248_ = false;
                                                }
                                                let _e4343 = phi_3248_;
                                                if _e4343 {
                                                    phi_3254_ = type_18(0u, type_18().member_1);
                                                } else {
                                                    phi_3254_ = type_18(1u, _e4338);
                                                }
                                                let _e4348 = phi_3254_;
                                                phi_3225_ = type_17(_e4348.member_1, _e4329.member_1);
                                                phi_3268_ = type_18(1u, _e4329.member);
                                            } else {
                                                phi_3225_ = _e4329;
                                                phi_3268_ = type_18(0u, type_18().member_1);
                                            }
                                            let _e4354 = phi_3225_;
                                            let _e4356 = phi_3268_;
                                            let _e4359 = (bitcast<i32>(_e4356.member) != 0i);
                                            if _e4359 {
                                                phi_3228_ = (0.5f * (_e4331 + (_e4321 / _e4331)));
                                            } else {
                                                phi_3228_ = f32();
                                            }
                                            let _e4364 = phi_3228_;
                                            continue;
                                            continuing {
                                                phi_3224_ = _e4354;
                                                phi_3227_ = _e4364;
                                                break if !(_e4359);
                                            }
                                        }
                                        let _e4369 = local_44;
                                        phi_3281_ = (_e4369 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e4376 = phi_3281_;
                                    let _e4382 = local_15.member[0u];
                                    if (_e4382[0] < 0f) {
                                        phi_3297_ = -(_e4382[0]);
                                    } else {
                                        phi_3297_ = _e4382[0];
                                    }
                                    let _e4389 = phi_3297_;
                                    if (_e4382[1] < 0f) {
                                        phi_3304_ = -(_e4382[1]);
                                    } else {
                                        phi_3304_ = _e4382[1];
                                    }
                                    let _e4393 = phi_3304_;
                                    if (_e4389 > _e4393) {
                                        phi_3309_ = _e4389;
                                    } else {
                                        phi_3309_ = _e4393;
                                    }
                                    let _e4396 = phi_3309_;
                                    if (_e4382[2] < 0f) {
                                        phi_3316_ = -(_e4382[2]);
                                    } else {
                                        phi_3316_ = _e4382[2];
                                    }
                                    let _e4400 = phi_3316_;
                                    if (_e4396 > _e4400) {
                                        phi_3321_ = _e4396;
                                    } else {
                                        phi_3321_ = _e4400;
                                    }
                                    let _e4403 = phi_3321_;
                                    let _e4406 = local_15.member[1u];
                                    if (_e4406[0] < 0f) {
                                        phi_3334_ = -(_e4406[0]);
                                    } else {
                                        phi_3334_ = _e4406[0];
                                    }
                                    let _e4413 = phi_3334_;
                                    if (_e4406[1] < 0f) {
                                        phi_3341_ = -(_e4406[1]);
                                    } else {
                                        phi_3341_ = _e4406[1];
                                    }
                                    let _e4417 = phi_3341_;
                                    if (_e4413 > _e4417) {
                                        phi_3346_ = _e4413;
                                    } else {
                                        phi_3346_ = _e4417;
                                    }
                                    let _e4420 = phi_3346_;
                                    if (_e4406[2] < 0f) {
                                        phi_3353_ = -(_e4406[2]);
                                    } else {
                                        phi_3353_ = _e4406[2];
                                    }
                                    let _e4424 = phi_3353_;
                                    if (_e4420 > _e4424) {
                                        phi_3358_ = _e4420;
                                    } else {
                                        phi_3358_ = _e4424;
                                    }
                                    let _e4427 = phi_3358_;
                                    if (_e4403 > _e4427) {
                                        phi_3363_ = _e4403;
                                    } else {
                                        phi_3363_ = _e4427;
                                    }
                                    let _e4430 = phi_3363_;
                                    let _e4432 = local_15.member_3;
                                    let _e4436 = local_15.member_1[0u];
                                    if (_e4436[0] < 0f) {
                                        phi_3380_ = -(_e4436[0]);
                                    } else {
                                        phi_3380_ = _e4436[0];
                                    }
                                    let _e4443 = phi_3380_;
                                    if (_e4436[1] < 0f) {
                                        phi_3387_ = -(_e4436[1]);
                                    } else {
                                        phi_3387_ = _e4436[1];
                                    }
                                    let _e4447 = phi_3387_;
                                    if (_e4443 > _e4447) {
                                        phi_3392_ = _e4443;
                                    } else {
                                        phi_3392_ = _e4447;
                                    }
                                    let _e4450 = phi_3392_;
                                    if (_e4436[2] < 0f) {
                                        phi_3399_ = -(_e4436[2]);
                                    } else {
                                        phi_3399_ = _e4436[2];
                                    }
                                    let _e4454 = phi_3399_;
                                    if (_e4450 > _e4454) {
                                        phi_3404_ = _e4450;
                                    } else {
                                        phi_3404_ = _e4454;
                                    }
                                    let _e4457 = phi_3404_;
                                    let _e4460 = local_15.member_1[1u];
                                    if (_e4460[0] < 0f) {
                                        phi_3418_ = -(_e4460[0]);
                                    } else {
                                        phi_3418_ = _e4460[0];
                                    }
                                    let _e4467 = phi_3418_;
                                    if (_e4460[1] < 0f) {
                                        phi_3425_ = -(_e4460[1]);
                                    } else {
                                        phi_3425_ = _e4460[1];
                                    }
                                    let _e4471 = phi_3425_;
                                    if (_e4467 > _e4471) {
                                        phi_3430_ = _e4467;
                                    } else {
                                        phi_3430_ = _e4471;
                                    }
                                    let _e4474 = phi_3430_;
                                    if (_e4460[2] < 0f) {
                                        phi_3437_ = -(_e4460[2]);
                                    } else {
                                        phi_3437_ = _e4460[2];
                                    }
                                    let _e4478 = phi_3437_;
                                    if (_e4474 > _e4478) {
                                        phi_3442_ = _e4474;
                                    } else {
                                        phi_3442_ = _e4478;
                                    }
                                    let _e4481 = phi_3442_;
                                    if (_e4457 > _e4481) {
                                        phi_3447_ = _e4457;
                                    } else {
                                        phi_3447_ = _e4481;
                                    }
                                    let _e4484 = phi_3447_;
                                    let _e4486 = local_15.member_3;
                                    let _e4490 = local_15.member_2[0u];
                                    if (_e4490[0] < 0f) {
                                        phi_3464_ = -(_e4490[0]);
                                    } else {
                                        phi_3464_ = _e4490[0];
                                    }
                                    let _e4497 = phi_3464_;
                                    if (_e4490[1] < 0f) {
                                        phi_3471_ = -(_e4490[1]);
                                    } else {
                                        phi_3471_ = _e4490[1];
                                    }
                                    let _e4501 = phi_3471_;
                                    if (_e4497 > _e4501) {
                                        phi_3476_ = _e4497;
                                    } else {
                                        phi_3476_ = _e4501;
                                    }
                                    let _e4504 = phi_3476_;
                                    if (_e4490[2] < 0f) {
                                        phi_3483_ = -(_e4490[2]);
                                    } else {
                                        phi_3483_ = _e4490[2];
                                    }
                                    let _e4508 = phi_3483_;
                                    if (_e4504 > _e4508) {
                                        phi_3488_ = _e4504;
                                    } else {
                                        phi_3488_ = _e4508;
                                    }
                                    let _e4511 = phi_3488_;
                                    let _e4514 = local_15.member_2[1u];
                                    if (_e4514[0] < 0f) {
                                        phi_3502_ = -(_e4514[0]);
                                    } else {
                                        phi_3502_ = _e4514[0];
                                    }
                                    let _e4521 = phi_3502_;
                                    if (_e4514[1] < 0f) {
                                        phi_3509_ = -(_e4514[1]);
                                    } else {
                                        phi_3509_ = _e4514[1];
                                    }
                                    let _e4525 = phi_3509_;
                                    if (_e4521 > _e4525) {
                                        phi_3514_ = _e4521;
                                    } else {
                                        phi_3514_ = _e4525;
                                    }
                                    let _e4528 = phi_3514_;
                                    if (_e4514[2] < 0f) {
                                        phi_3521_ = -(_e4514[2]);
                                    } else {
                                        phi_3521_ = _e4514[2];
                                    }
                                    let _e4532 = phi_3521_;
                                    if (_e4528 > _e4532) {
                                        phi_3526_ = _e4528;
                                    } else {
                                        phi_3526_ = _e4532;
                                    }
                                    let _e4535 = phi_3526_;
                                    if (_e4511 > _e4535) {
                                        phi_3531_ = _e4511;
                                    } else {
                                        phi_3531_ = _e4535;
                                    }
                                    let _e4538 = phi_3531_;
                                    let _e4540 = local_15.member_3;
                                    let _e4547 = local_15.member_3;
                                    let _e4554 = (((_e4376 * (1f + (0.000000059604645f * 8f))) + (((((((_e4430 + _e4432) + (_e4484 + _e4486)) + (_e4538 + _e4540)) * (0.000000059604645f * 16f)) + (_e4547 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e256);
                                    if _e4554 {
                                        phi_3551_ = false;
                                    } else {
                                        phi_3551_ = true;
                                    }
                                    let _e4556 = phi_3551_;
                                    phi_3552_ = _e4556;
                                    phi_3553_ = _e4554;
                                } else {
                                    phi_3552_ = false;
                                    phi_3553_ = false;
                                }
                                let _e4558 = phi_3552_;
                                let _e4560 = phi_3553_;
                                local_45 = _e4560;
                                continue;
                                continuing {
                                    phi_2593_ = _e3985;
                                    break if !(_e4558);
                                }
                            }
                            let _e4563 = local_45;
                            if _e4563 {
                                phi_3558_ = type_32(1u, _e3961.member_1);
                                phi_3559_ = false;
                            } else {
                                phi_3558_ = type_32();
                                phi_3559_ = true;
                            }
                            let _e4566 = phi_3558_;
                            let _e4568 = phi_3559_;
                            if _e4568 {
                                phi_3564_ = type_32(2u, _e3961.member_1);
                                phi_3565_ = false;
                            } else {
                                phi_3564_ = type_32();
                                phi_3565_ = true;
                            }
                            let _e4571 = phi_3564_;
                            let _e4573 = phi_3565_;
                            phi_3567_ = _e4571;
                            phi_3568_ = _e4566;
                            phi_3569_ = _e4573;
                        } else {
                            phi_3567_ = type_32();
                            phi_3568_ = type_32(0u, type_32().member_1);
                            phi_3569_ = true;
                        }
                        let _e4575 = phi_3567_;
                        let _e4577 = phi_3568_;
                        let _e4579 = phi_3569_;
                        if _e4579 {
                            phi_3573_ = _e4577;
                        } else {
                            phi_3573_ = _e4575;
                        }
                        let _e4581 = phi_3573_;
                        phi_6847_ = _e4581;
                    } else {
                        if (_e354 < 0f) {
                            phi_3583_ = -(_e354);
                        } else {
                            phi_3583_ = _e354;
                        }
                        let _e697 = phi_3583_;
                        if (_e377 < 0f) {
                            phi_3589_ = -(_e377);
                        } else {
                            phi_3589_ = _e377;
                        }
                        let _e701 = phi_3589_;
                        if (_e697 > _e701) {
                            phi_3594_ = _e697;
                        } else {
                            phi_3594_ = _e701;
                        }
                        let _e704 = phi_3594_;
                        if (_e400 < 0f) {
                            phi_3600_ = -(_e400);
                        } else {
                            phi_3600_ = _e400;
                        }
                        let _e708 = phi_3600_;
                        if (_e411 < 0f) {
                            phi_3606_ = -(_e411);
                        } else {
                            phi_3606_ = _e411;
                        }
                        let _e712 = phi_3606_;
                        if (_e708 > _e712) {
                            phi_3611_ = _e708;
                        } else {
                            phi_3611_ = _e712;
                        }
                        let _e715 = phi_3611_;
                        if (_e704 > _e715) {
                            phi_3616_ = _e704;
                        } else {
                            phi_3616_ = _e715;
                        }
                        let _e718 = phi_3616_;
                        let _e719 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e718 >= _e719) {
                            phi_3624_ = (_e718 <= (1f / _e719));
                        } else {
                            phi_3624_ = false;
                        }
                        let _e724 = phi_3624_;
                        if _e724 {
                            phi_3629_ = (0.000000059604645f * 256f);
                        } else {
                            phi_3629_ = 2f;
                        }
                        let _e727 = phi_3629_;
                        let _e729 = ((_e661 * 0.34f) + (_e718 * _e727));
                        if _e724 {
                            phi_3636_ = (1f / _e718);
                        } else {
                            phi_3636_ = 0f;
                        }
                        let _e732 = phi_3636_;
                        let _e738 = ((_e377 - (3f * _e354)) * _e732);
                        let _e739 = ((_e400 - _e377) * _e732);
                        let _e740 = (((3f * _e411) - _e400) * _e732);
                        local_7[0u] = 0f;
                        local_7[1u] = 1f;
                        local_7[2u] = 1f;
                        local_7[3u] = 1f;
                        let _e747 = ((_e739 * _e739) - (_e738 * _e740));
                        if (_e747 > 0f) {
                            if (_e747 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e747 > 0f) {
                                    phi_3669_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_3669_ = 0f;
                                }
                                let _e801 = phi_3669_;
                                phi_3733_ = _e801;
                            } else {
                                phi_3676_ = type_17(0i, 5i);
                                phi_3679_ = bitcast<f32>(((bitcast<u32>(_e747) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e756 = phi_3676_;
                                    let _e758 = phi_3679_;
                                    local_16 = _e758;
                                    if (_e756.member < _e756.member_1) {
                                        let _e765 = (_e756.member + 1i);
                                        if ((false == (_e765 > _e756.member)) != false) {
                                            phi_3700_ = true;
                                        } else {
                                            phi_3700_ = false;
                                        }
                                        let _e770 = phi_3700_;
                                        if _e770 {
                                            phi_3706_ = type_18(0u, type_18().member_1);
                                        } else {
                                            phi_3706_ = type_18(1u, _e765);
                                        }
                                        let _e775 = phi_3706_;
                                        phi_3677_ = type_17(_e775.member_1, _e756.member_1);
                                        phi_3720_ = type_18(1u, _e756.member);
                                    } else {
                                        phi_3677_ = _e756;
                                        phi_3720_ = type_18(0u, type_18().member_1);
                                    }
                                    let _e781 = phi_3677_;
                                    let _e783 = phi_3720_;
                                    let _e786 = (bitcast<i32>(_e783.member) != 0i);
                                    if _e786 {
                                        phi_3680_ = (0.5f * (_e758 + (_e747 / _e758)));
                                    } else {
                                        phi_3680_ = f32();
                                    }
                                    let _e791 = phi_3680_;
                                    continue;
                                    continuing {
                                        phi_3676_ = _e781;
                                        phi_3679_ = _e791;
                                        break if !(_e786);
                                    }
                                }
                                let _e796 = local_16;
                                phi_3733_ = (_e796 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e803 = phi_3733_;
                            if (_e739 < 0f) {
                                phi_3739_ = -(_e803);
                            } else {
                                phi_3739_ = _e803;
                            }
                            let _e807 = phi_3739_;
                            let _e809 = -((_e739 + _e807));
                            local_8[0u] = (_e809 / (_e809 + _e740));
                            local_8[1u] = (_e738 / (_e738 + _e809));
                            let _e818 = local_8[1u];
                            let _e819 = local_8[0u];
                            if (_e818 < _e819) {
                                let _e822 = local_8[1u];
                                let _e824 = local_8[0u];
                                local_8[0u] = _e822;
                                local_8[1u] = _e824;
                            }
                            phi_3764_ = type_19(0u, 2u);
                            phi_3767_ = 1u;
                            loop {
                                let _e828 = phi_3764_;
                                let _e830 = phi_3767_;
                                local_46 = _e830;
                                if (_e828.member < _e828.member_1) {
                                    phi_3765_ = type_19((_e828.member + 1u), _e828.member_1);
                                    phi_3790_ = type_19(1u, _e828.member);
                                } else {
                                    phi_3765_ = _e828;
                                    phi_3790_ = type_19(0u, type_19().member_1);
                                }
                                let _e842 = phi_3765_;
                                let _e844 = phi_3790_;
                                let _e848 = (bitcast<i32>(_e844.member) != 0i);
                                if _e848 {
                                    let _e850 = local_8[_e844.member_1];
                                    if (_e850 > 0f) {
                                        let _e853 = local_8[_e844.member_1];
                                        if (_e853 < 1f) {
                                            let _e856 = local_8[_e844.member_1];
                                            local_7[_e830] = _e856;
                                            phi_3834_ = (_e830 + 1u);
                                        } else {
                                            phi_3834_ = _e830;
                                        }
                                        let _e860 = phi_3834_;
                                        phi_3835_ = _e860;
                                    } else {
                                        phi_3835_ = _e830;
                                    }
                                    let _e862 = phi_3835_;
                                    phi_3768_ = _e862;
                                } else {
                                    phi_3768_ = u32();
                                }
                                let _e864 = phi_3768_;
                                continue;
                                continuing {
                                    phi_3764_ = _e842;
                                    phi_3767_ = _e864;
                                    break if !(_e848);
                                }
                            }
                            let _e4790 = local_46;
                            phi_3836_ = _e4790;
                        } else {
                            phi_3836_ = 1u;
                        }
                        let _e867 = phi_3836_;
                        local_7[_e867] = 1f;
                        let _e869 = local_7;
                        local_9 = _e869;
                        phi_3856_ = type_19(0u, _e867);
                        loop {
                            let _e872 = phi_3856_;
                            if (_e872.member < _e872.member_1) {
                                phi_3857_ = type_19((_e872.member + 1u), _e872.member_1);
                                phi_3880_ = type_19(1u, _e872.member);
                            } else {
                                phi_3857_ = _e872;
                                phi_3880_ = type_19(0u, type_19().member_1);
                            }
                            let _e884 = phi_3857_;
                            let _e886 = phi_3880_;
                            if (bitcast<i32>(_e886.member) != 0i) {
                                let _e892 = local_9[_e886.member_1];
                                let _e895 = local_9[(_e886.member_1 + 1u)];
                                let _e896 = (1f - _e892);
                                let _e907 = ((((_e354 * _e896) + (_e377 * _e892)) * (_e896 * _e896)) + (((_e400 * _e896) + (_e411 * _e892)) * (_e892 * _e892)));
                                let _e908 = (1f - _e895);
                                let _e919 = ((((_e354 * _e908) + (_e377 * _e895)) * (_e908 * _e908)) + (((_e400 * _e908) + (_e411 * _e895)) * (_e895 * _e895)));
                                if (_e907 < 0f) {
                                    phi_3932_ = -(_e907);
                                } else {
                                    phi_3932_ = _e907;
                                }
                                let _e923 = phi_3932_;
                                let _e924 = (_e923 > _e729);
                                if (_e919 < 0f) {
                                    phi_3939_ = -(_e919);
                                } else {
                                    phi_3939_ = _e919;
                                }
                                let _e928 = phi_3939_;
                                let _e929 = (_e928 > _e729);
                                if _e924 {
                                    if _e929 {
                                        phi_3950_ = ((_e907 > 0f) != (_e919 > 0f));
                                        phi_3951_ = false;
                                    } else {
                                        phi_3950_ = bool();
                                        phi_3951_ = true;
                                    }
                                    let _e934 = phi_3950_;
                                    let _e936 = phi_3951_;
                                    phi_3952_ = _e934;
                                    phi_3953_ = _e936;
                                } else {
                                    phi_3952_ = bool();
                                    phi_3953_ = true;
                                }
                                let _e938 = phi_3952_;
                                let _e940 = phi_3953_;
                                if _e940 {
                                    phi_3957_ = false;
                                } else {
                                    phi_3957_ = _e938;
                                }
                                let _e942 = phi_3957_;
                                if _e924 {
                                    if _e929 {
                                        if _e942 {
                                            phi_3968_ = type_33();
                                        } else {
                                            phi_3968_ = type_33(1f, 0f, _e942);
                                        }
                                        let _e945 = phi_3968_;
                                        phi_3969_ = _e945;
                                        phi_3970_ = _e942;
                                    } else {
                                        phi_3969_ = type_33();
                                        phi_3970_ = true;
                                    }
                                    let _e947 = phi_3969_;
                                    let _e949 = phi_3970_;
                                    phi_3971_ = _e947;
                                    phi_3972_ = _e949;
                                } else {
                                    phi_3971_ = type_33();
                                    phi_3972_ = true;
                                }
                                let _e951 = phi_3971_;
                                let _e953 = phi_3972_;
                                if _e953 {
                                    if _e924 {
                                        if (_e907 < 0f) {
                                            phi_3983_ = -1f;
                                        } else {
                                            phi_3983_ = 1f;
                                        }
                                        let _e956 = phi_3983_;
                                        let _e959 = (_e400 - _e377);
                                        phi_3993_ = type_19(0u, 64u);
                                        phi_3996_ = _e895;
                                        phi_3998_ = _e892;
                                        phi_4000_ = (0.5f * (_e892 + _e895));
                                        loop {
                                            let _e965 = phi_3993_;
                                            let _e967 = phi_3996_;
                                            let _e969 = phi_3998_;
                                            let _e971 = phi_4000_;
                                            local_48 = _e969;
                                            if (_e965.member < _e965.member_1) {
                                                phi_3994_ = type_19((_e965.member + 1u), _e965.member_1);
                                                phi_4023_ = type_19(1u, _e965.member);
                                            } else {
                                                phi_3994_ = _e965;
                                                phi_4023_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e983 = phi_3994_;
                                            let _e985 = phi_4023_;
                                            if (bitcast<i32>(_e985.member) != 0i) {
                                                let _e989 = (1f - _e971);
                                                let _e1002 = ((_e956 * ((((_e354 * _e989) + (_e377 * _e971)) * (_e989 * _e989)) + (((_e400 * _e989) + (_e411 * _e971)) * (_e971 * _e971)))) - _e729);
                                                if (_e1002 > 0f) {
                                                    phi_4048_ = _e967;
                                                    phi_4049_ = _e971;
                                                } else {
                                                    phi_4048_ = _e971;
                                                    phi_4049_ = _e969;
                                                }
                                                let _e1005 = phi_4048_;
                                                let _e1007 = phi_4049_;
                                                let _e1009 = ((_e1005 - _e1007) > 0.00000000000022737368f);
                                                if _e1009 {
                                                    let _e1010 = (1f - _e971);
                                                    let _e1022 = (-(_e1002) / (_e956 * (((((_e377 - (3f * _e354)) * _e1010) + (_e959 * _e971)) * _e1010) + (((_e959 * _e1010) + (((3f * _e411) - _e400) * _e971)) * _e971))));
                                                    if (_e1002 > 0f) {
                                                        phi_4075_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_4075_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1028 = phi_4075_;
                                                    let _e1030 = ((_e971 + _e1022) + _e1028);
                                                    if (_e1030 > _e1007) {
                                                        if (_e1030 < _e1005) {
                                                            if (_e1022 < 0f) {
                                                                phi_4091_ = -(_e1022);
                                                            } else {
                                                                phi_4091_ = _e1022;
                                                            }
                                                            let _e1036 = phi_4091_;
                                                            if (_e1036 < (0.5f * (_e1005 - _e1007))) {
                                                                phi_4098_ = false;
                                                            } else {
                                                                phi_4098_ = true;
                                                            }
                                                            let _e1041 = phi_4098_;
                                                            phi_4099_ = _e1041;
                                                        } else {
                                                            phi_4099_ = true;
                                                        }
                                                        let _e1043 = phi_4099_;
                                                        phi_4100_ = _e1043;
                                                    } else {
                                                        phi_4100_ = true;
                                                    }
                                                    let _e1045 = phi_4100_;
                                                    if _e1045 {
                                                        phi_4106_ = (0.5f * (_e1007 + _e1005));
                                                    } else {
                                                        phi_4106_ = _e1030;
                                                    }
                                                    let _e1049 = phi_4106_;
                                                    phi_4107_ = _e1049;
                                                    phi_4108_ = false;
                                                } else {
                                                    phi_4107_ = f32();
                                                    phi_4108_ = true;
                                                }
                                                let _e1051 = phi_4107_;
                                                let _e1053 = phi_4108_;
                                                phi_3997_ = _e1005;
                                                phi_3999_ = _e1007;
                                                phi_4001_ = _e1051;
                                                phi_4109_ = _e1007;
                                                phi_4110_ = _e1009;
                                                phi_4111_ = _e1053;
                                            } else {
                                                phi_3997_ = f32();
                                                phi_3999_ = f32();
                                                phi_4001_ = f32();
                                                phi_4109_ = f32();
                                                phi_4110_ = false;
                                                phi_4111_ = false;
                                            }
                                            let _e1055 = phi_3997_;
                                            let _e1057 = phi_3999_;
                                            let _e1059 = phi_4001_;
                                            let _e1061 = phi_4109_;
                                            let _e1063 = phi_4110_;
                                            let _e1065 = phi_4111_;
                                            local_17 = _e1065;
                                            local_47 = _e1061;
                                            continue;
                                            continuing {
                                                phi_3993_ = _e983;
                                                phi_3996_ = _e1055;
                                                phi_3998_ = _e1057;
                                                phi_4000_ = _e1059;
                                                break if !(_e1063);
                                            }
                                        }
                                        let _e1068 = local_17;
                                        if _e1068 {
                                            let _e4832 = local_47;
                                            phi_4115_ = _e4832;
                                        } else {
                                            let _e4834 = local_48;
                                            phi_4115_ = _e4834;
                                        }
                                        let _e1070 = phi_4115_;
                                        phi_4116_ = _e1070;
                                    } else {
                                        phi_4116_ = _e892;
                                    }
                                    let _e1072 = phi_4116_;
                                    if _e929 {
                                        phi_4123_ = type_19(0u, 64u);
                                        phi_4126_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1075 = phi_4123_;
                                            let _e1077 = phi_4126_;
                                            if (_e1075.member < _e1075.member_1) {
                                                phi_4124_ = type_19((_e1075.member + 1u), _e1075.member_1);
                                                phi_4149_ = type_19(1u, _e1075.member);
                                            } else {
                                                phi_4124_ = _e1075;
                                                phi_4149_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1089 = phi_4124_;
                                            let _e1091 = phi_4149_;
                                            if (bitcast<i32>(_e1091.member) != 0i) {
                                                let _e1095 = (_e1072 + _e1077);
                                                if (_e1095 < _e895) {
                                                    let _e1097 = (1f - _e1095);
                                                    let _e1108 = ((((_e354 * _e1097) + (_e377 * _e1095)) * (_e1097 * _e1097)) + (((_e400 * _e1097) + (_e411 * _e1095)) * (_e1095 * _e1095)));
                                                    let _e1109 = (1f - _e1072);
                                                    let _e1120 = ((((_e354 * _e1109) + (_e377 * _e1072)) * (_e1109 * _e1109)) + (((_e400 * _e1109) + (_e411 * _e1072)) * (_e1072 * _e1072)));
                                                    if (_e1108 < 0f) {
                                                        phi_4190_ = -(_e1108);
                                                    } else {
                                                        phi_4190_ = _e1108;
                                                    }
                                                    let _e1124 = phi_4190_;
                                                    if (_e1124 > _e729) {
                                                        if (_e1120 < 0f) {
                                                            phi_4200_ = -(_e1120);
                                                        } else {
                                                            phi_4200_ = _e1120;
                                                        }
                                                        let _e1129 = phi_4200_;
                                                        if (_e1129 > _e729) {
                                                            phi_4208_ = ((_e1108 > 0f) == (_e1120 > 0f));
                                                        } else {
                                                            phi_4208_ = false;
                                                        }
                                                        let _e1135 = phi_4208_;
                                                        phi_4210_ = !(_e1135);
                                                    } else {
                                                        phi_4210_ = false;
                                                    }
                                                    let _e1138 = phi_4210_;
                                                    if _e1138 {
                                                        phi_4215_ = f32();
                                                        phi_4216_ = false;
                                                    } else {
                                                        phi_4215_ = (_e1077 + _e1077);
                                                        phi_4216_ = true;
                                                    }
                                                    let _e1141 = phi_4215_;
                                                    let _e1143 = phi_4216_;
                                                    phi_4217_ = _e1141;
                                                    phi_4218_ = _e1143;
                                                    phi_4219_ = _e1138;
                                                    phi_4220_ = false;
                                                } else {
                                                    phi_4217_ = f32();
                                                    phi_4218_ = false;
                                                    phi_4219_ = false;
                                                    phi_4220_ = true;
                                                }
                                                let _e1145 = phi_4217_;
                                                let _e1147 = phi_4218_;
                                                let _e1149 = phi_4219_;
                                                let _e1151 = phi_4220_;
                                                phi_4221_ = _e1095;
                                                phi_4127_ = _e1145;
                                                phi_4222_ = _e1147;
                                                phi_4223_ = _e1149;
                                                phi_4224_ = _e1151;
                                                phi_4225_ = false;
                                            } else {
                                                phi_4221_ = f32();
                                                phi_4127_ = f32();
                                                phi_4222_ = false;
                                                phi_4223_ = false;
                                                phi_4224_ = false;
                                                phi_4225_ = true;
                                            }
                                            let _e1153 = phi_4221_;
                                            let _e1155 = phi_4127_;
                                            let _e1157 = phi_4222_;
                                            let _e1159 = phi_4223_;
                                            let _e1161 = phi_4224_;
                                            let _e1163 = phi_4225_;
                                            local_18 = _e1159;
                                            local_49 = _e1161;
                                            local_50 = _e1163;
                                            local_51 = _e1153;
                                            continue;
                                            continuing {
                                                phi_4123_ = _e1089;
                                                phi_4126_ = _e1155;
                                                break if !(_e1157);
                                            }
                                        }
                                        let _e1166 = local_18;
                                        if _e1166 {
                                            phi_4229_ = false;
                                            phi_4230_ = false;
                                        } else {
                                            let _e4859 = local_49;
                                            phi_4229_ = _e4859;
                                            let _e4862 = local_50;
                                            phi_4230_ = _e4862;
                                        }
                                        let _e1168 = phi_4229_;
                                        let _e1170 = phi_4230_;
                                        if _e1168 {
                                            phi_4234_ = true;
                                        } else {
                                            phi_4234_ = _e1170;
                                        }
                                        let _e1172 = phi_4234_;
                                        if _e1172 {
                                            phi_4238_ = _e895;
                                        } else {
                                            let _e4866 = local_51;
                                            phi_4238_ = _e4866;
                                        }
                                        let _e1174 = phi_4238_;
                                        phi_4239_ = _e1174;
                                    } else {
                                        phi_4239_ = _e895;
                                    }
                                    let _e1176 = phi_4239_;
                                    phi_4241_ = type_33(_e1072, _e1176, _e942);
                                } else {
                                    phi_4241_ = _e951;
                                }
                                let _e1179 = phi_4241_;
                                if (_e1179.member > _e1179.member_1) {
                                    phi_6803_ = f32();
                                    phi_6804_ = true;
                                    phi_6805_ = false;
                                    phi_6806_ = false;
                                    phi_6807_ = false;
                                } else {
                                    let _e1186 = ((_e1179.member_1 - _e1179.member) * 0.5f);
                                    let _e1187 = (_e1179.member + _e1186);
                                    let _e1189 = (_e1186 + (0.000000059604645f * 4f));
                                    let _e1191 = local_15.member_3;
                                    let _e1194 = local_15.member[0u];
                                    if (_e1194[0] < 0f) {
                                        phi_4270_ = -(_e1194[0]);
                                    } else {
                                        phi_4270_ = _e1194[0];
                                    }
                                    let _e1201 = phi_4270_;
                                    if (_e1194[1] < 0f) {
                                        phi_4277_ = -(_e1194[1]);
                                    } else {
                                        phi_4277_ = _e1194[1];
                                    }
                                    let _e1205 = phi_4277_;
                                    if (_e1201 > _e1205) {
                                        phi_4282_ = _e1201;
                                    } else {
                                        phi_4282_ = _e1205;
                                    }
                                    let _e1208 = phi_4282_;
                                    if (_e1194[2] < 0f) {
                                        phi_4289_ = -(_e1194[2]);
                                    } else {
                                        phi_4289_ = _e1194[2];
                                    }
                                    let _e1212 = phi_4289_;
                                    if (_e1208 > _e1212) {
                                        phi_4294_ = _e1208;
                                    } else {
                                        phi_4294_ = _e1212;
                                    }
                                    let _e1215 = phi_4294_;
                                    let _e1217 = local_15.member[1u];
                                    if (_e1217[0] < 0f) {
                                        phi_4307_ = -(_e1217[0]);
                                    } else {
                                        phi_4307_ = _e1217[0];
                                    }
                                    let _e1224 = phi_4307_;
                                    if (_e1217[1] < 0f) {
                                        phi_4314_ = -(_e1217[1]);
                                    } else {
                                        phi_4314_ = _e1217[1];
                                    }
                                    let _e1228 = phi_4314_;
                                    if (_e1224 > _e1228) {
                                        phi_4319_ = _e1224;
                                    } else {
                                        phi_4319_ = _e1228;
                                    }
                                    let _e1231 = phi_4319_;
                                    if (_e1217[2] < 0f) {
                                        phi_4326_ = -(_e1217[2]);
                                    } else {
                                        phi_4326_ = _e1217[2];
                                    }
                                    let _e1235 = phi_4326_;
                                    if (_e1231 > _e1235) {
                                        phi_4331_ = _e1231;
                                    } else {
                                        phi_4331_ = _e1235;
                                    }
                                    let _e1238 = phi_4331_;
                                    if (_e1215 > _e1238) {
                                        phi_4336_ = _e1215;
                                    } else {
                                        phi_4336_ = _e1238;
                                    }
                                    let _e1241 = phi_4336_;
                                    let _e1244 = local_15.member[0u];
                                    let _e1249 = local_15.member[1u];
                                    let _e1259 = (_e1244[0] + ((_e1249[0] - _e1244[0]) * _e1187));
                                    let _e1260 = (_e1244[1] + ((_e1249[1] - _e1244[1]) * _e1187));
                                    let _e1261 = (_e1244[2] + ((_e1249[2] - _e1244[2]) * _e1187));
                                    let _e1263 = local_15.member[1u];
                                    let _e1268 = local_15.member[0u];
                                    let _e1272 = (_e1263[0] - _e1268[0]);
                                    let _e1273 = (_e1263[1] - _e1268[1]);
                                    let _e1274 = (_e1263[2] - _e1268[2]);
                                    if (_e1272 < 0f) {
                                        phi_4395_ = -(_e1272);
                                    } else {
                                        phi_4395_ = _e1272;
                                    }
                                    let _e1278 = phi_4395_;
                                    if (_e1273 < 0f) {
                                        phi_4401_ = -(_e1273);
                                    } else {
                                        phi_4401_ = _e1273;
                                    }
                                    let _e1282 = phi_4401_;
                                    if (_e1278 > _e1282) {
                                        phi_4406_ = _e1278;
                                    } else {
                                        phi_4406_ = _e1282;
                                    }
                                    let _e1285 = phi_4406_;
                                    if (_e1274 < 0f) {
                                        phi_4412_ = -(_e1274);
                                    } else {
                                        phi_4412_ = _e1274;
                                    }
                                    let _e1289 = phi_4412_;
                                    if (_e1285 > _e1289) {
                                        phi_4417_ = _e1285;
                                    } else {
                                        phi_4417_ = _e1289;
                                    }
                                    let _e1292 = phi_4417_;
                                    let _e1298 = ((((_e1189 * _e1292) * 1.01f) + ((_e1241 + _e1191) * (0.000000059604645f * 8f))) + _e1191);
                                    if (_e1259 < 0f) {
                                        phi_4429_ = -(_e1259);
                                    } else {
                                        phi_4429_ = _e1259;
                                    }
                                    let _e1302 = phi_4429_;
                                    if (_e1260 < 0f) {
                                        phi_4435_ = -(_e1260);
                                    } else {
                                        phi_4435_ = _e1260;
                                    }
                                    let _e1306 = phi_4435_;
                                    if (_e1302 > _e1306) {
                                        phi_4440_ = _e1302;
                                    } else {
                                        phi_4440_ = _e1306;
                                    }
                                    let _e1309 = phi_4440_;
                                    if (_e1261 < 0f) {
                                        phi_4446_ = -(_e1261);
                                    } else {
                                        phi_4446_ = _e1261;
                                    }
                                    let _e1313 = phi_4446_;
                                    if (_e1309 > _e1313) {
                                        phi_4451_ = _e1309;
                                    } else {
                                        phi_4451_ = _e1313;
                                    }
                                    let _e1316 = phi_4451_;
                                    local_3 = type_24(array<f32, 3>(_e1259, _e1260, _e1261), _e1298, (_e1316 + _e1298));
                                    let _e1322 = local_15.member_3;
                                    let _e1324 = local_15.member_1[0u];
                                    if (_e1324[0] < 0f) {
                                        phi_4477_ = -(_e1324[0]);
                                    } else {
                                        phi_4477_ = _e1324[0];
                                    }
                                    let _e1331 = phi_4477_;
                                    if (_e1324[1] < 0f) {
                                        phi_4484_ = -(_e1324[1]);
                                    } else {
                                        phi_4484_ = _e1324[1];
                                    }
                                    let _e1335 = phi_4484_;
                                    if (_e1331 > _e1335) {
                                        phi_4489_ = _e1331;
                                    } else {
                                        phi_4489_ = _e1335;
                                    }
                                    let _e1338 = phi_4489_;
                                    if (_e1324[2] < 0f) {
                                        phi_4496_ = -(_e1324[2]);
                                    } else {
                                        phi_4496_ = _e1324[2];
                                    }
                                    let _e1342 = phi_4496_;
                                    if (_e1338 > _e1342) {
                                        phi_4501_ = _e1338;
                                    } else {
                                        phi_4501_ = _e1342;
                                    }
                                    let _e1345 = phi_4501_;
                                    let _e1347 = local_15.member_1[1u];
                                    if (_e1347[0] < 0f) {
                                        phi_4514_ = -(_e1347[0]);
                                    } else {
                                        phi_4514_ = _e1347[0];
                                    }
                                    let _e1354 = phi_4514_;
                                    if (_e1347[1] < 0f) {
                                        phi_4521_ = -(_e1347[1]);
                                    } else {
                                        phi_4521_ = _e1347[1];
                                    }
                                    let _e1358 = phi_4521_;
                                    if (_e1354 > _e1358) {
                                        phi_4526_ = _e1354;
                                    } else {
                                        phi_4526_ = _e1358;
                                    }
                                    let _e1361 = phi_4526_;
                                    if (_e1347[2] < 0f) {
                                        phi_4533_ = -(_e1347[2]);
                                    } else {
                                        phi_4533_ = _e1347[2];
                                    }
                                    let _e1365 = phi_4533_;
                                    if (_e1361 > _e1365) {
                                        phi_4538_ = _e1361;
                                    } else {
                                        phi_4538_ = _e1365;
                                    }
                                    let _e1368 = phi_4538_;
                                    if (_e1345 > _e1368) {
                                        phi_4543_ = _e1345;
                                    } else {
                                        phi_4543_ = _e1368;
                                    }
                                    let _e1371 = phi_4543_;
                                    let _e1374 = local_15.member_1[0u];
                                    let _e1379 = local_15.member_1[1u];
                                    let _e1389 = (_e1374[0] + ((_e1379[0] - _e1374[0]) * _e1187));
                                    let _e1390 = (_e1374[1] + ((_e1379[1] - _e1374[1]) * _e1187));
                                    let _e1391 = (_e1374[2] + ((_e1379[2] - _e1374[2]) * _e1187));
                                    let _e1393 = local_15.member_1[1u];
                                    let _e1398 = local_15.member_1[0u];
                                    let _e1402 = (_e1393[0] - _e1398[0]);
                                    let _e1403 = (_e1393[1] - _e1398[1]);
                                    let _e1404 = (_e1393[2] - _e1398[2]);
                                    if (_e1402 < 0f) {
                                        phi_4602_ = -(_e1402);
                                    } else {
                                        phi_4602_ = _e1402;
                                    }
                                    let _e1408 = phi_4602_;
                                    if (_e1403 < 0f) {
                                        phi_4608_ = -(_e1403);
                                    } else {
                                        phi_4608_ = _e1403;
                                    }
                                    let _e1412 = phi_4608_;
                                    if (_e1408 > _e1412) {
                                        phi_4613_ = _e1408;
                                    } else {
                                        phi_4613_ = _e1412;
                                    }
                                    let _e1415 = phi_4613_;
                                    if (_e1404 < 0f) {
                                        phi_4619_ = -(_e1404);
                                    } else {
                                        phi_4619_ = _e1404;
                                    }
                                    let _e1419 = phi_4619_;
                                    if (_e1415 > _e1419) {
                                        phi_4624_ = _e1415;
                                    } else {
                                        phi_4624_ = _e1419;
                                    }
                                    let _e1422 = phi_4624_;
                                    let _e1428 = ((((_e1189 * _e1422) * 1.01f) + ((_e1371 + _e1322) * (0.000000059604645f * 8f))) + _e1322);
                                    if (_e1389 < 0f) {
                                        phi_4636_ = -(_e1389);
                                    } else {
                                        phi_4636_ = _e1389;
                                    }
                                    let _e1432 = phi_4636_;
                                    if (_e1390 < 0f) {
                                        phi_4642_ = -(_e1390);
                                    } else {
                                        phi_4642_ = _e1390;
                                    }
                                    let _e1436 = phi_4642_;
                                    if (_e1432 > _e1436) {
                                        phi_4647_ = _e1432;
                                    } else {
                                        phi_4647_ = _e1436;
                                    }
                                    let _e1439 = phi_4647_;
                                    if (_e1391 < 0f) {
                                        phi_4653_ = -(_e1391);
                                    } else {
                                        phi_4653_ = _e1391;
                                    }
                                    let _e1443 = phi_4653_;
                                    if (_e1439 > _e1443) {
                                        phi_4658_ = _e1439;
                                    } else {
                                        phi_4658_ = _e1443;
                                    }
                                    let _e1446 = phi_4658_;
                                    local_4 = type_24(array<f32, 3>(_e1389, _e1390, _e1391), _e1428, (_e1446 + _e1428));
                                    let _e1452 = local_15.member_3;
                                    let _e1454 = local_15.member_2[0u];
                                    if (_e1454[0] < 0f) {
                                        phi_4684_ = -(_e1454[0]);
                                    } else {
                                        phi_4684_ = _e1454[0];
                                    }
                                    let _e1461 = phi_4684_;
                                    if (_e1454[1] < 0f) {
                                        phi_4691_ = -(_e1454[1]);
                                    } else {
                                        phi_4691_ = _e1454[1];
                                    }
                                    let _e1465 = phi_4691_;
                                    if (_e1461 > _e1465) {
                                        phi_4696_ = _e1461;
                                    } else {
                                        phi_4696_ = _e1465;
                                    }
                                    let _e1468 = phi_4696_;
                                    if (_e1454[2] < 0f) {
                                        phi_4703_ = -(_e1454[2]);
                                    } else {
                                        phi_4703_ = _e1454[2];
                                    }
                                    let _e1472 = phi_4703_;
                                    if (_e1468 > _e1472) {
                                        phi_4708_ = _e1468;
                                    } else {
                                        phi_4708_ = _e1472;
                                    }
                                    let _e1475 = phi_4708_;
                                    let _e1477 = local_15.member_2[1u];
                                    if (_e1477[0] < 0f) {
                                        phi_4721_ = -(_e1477[0]);
                                    } else {
                                        phi_4721_ = _e1477[0];
                                    }
                                    let _e1484 = phi_4721_;
                                    if (_e1477[1] < 0f) {
                                        phi_4728_ = -(_e1477[1]);
                                    } else {
                                        phi_4728_ = _e1477[1];
                                    }
                                    let _e1488 = phi_4728_;
                                    if (_e1484 > _e1488) {
                                        phi_4733_ = _e1484;
                                    } else {
                                        phi_4733_ = _e1488;
                                    }
                                    let _e1491 = phi_4733_;
                                    if (_e1477[2] < 0f) {
                                        phi_4740_ = -(_e1477[2]);
                                    } else {
                                        phi_4740_ = _e1477[2];
                                    }
                                    let _e1495 = phi_4740_;
                                    if (_e1491 > _e1495) {
                                        phi_4745_ = _e1491;
                                    } else {
                                        phi_4745_ = _e1495;
                                    }
                                    let _e1498 = phi_4745_;
                                    if (_e1475 > _e1498) {
                                        phi_4750_ = _e1475;
                                    } else {
                                        phi_4750_ = _e1498;
                                    }
                                    let _e1501 = phi_4750_;
                                    let _e1504 = local_15.member_2[0u];
                                    let _e1509 = local_15.member_2[1u];
                                    let _e1519 = (_e1504[0] + ((_e1509[0] - _e1504[0]) * _e1187));
                                    let _e1520 = (_e1504[1] + ((_e1509[1] - _e1504[1]) * _e1187));
                                    let _e1521 = (_e1504[2] + ((_e1509[2] - _e1504[2]) * _e1187));
                                    let _e1523 = local_15.member_2[1u];
                                    let _e1528 = local_15.member_2[0u];
                                    let _e1532 = (_e1523[0] - _e1528[0]);
                                    let _e1533 = (_e1523[1] - _e1528[1]);
                                    let _e1534 = (_e1523[2] - _e1528[2]);
                                    if (_e1532 < 0f) {
                                        phi_4809_ = -(_e1532);
                                    } else {
                                        phi_4809_ = _e1532;
                                    }
                                    let _e1538 = phi_4809_;
                                    if (_e1533 < 0f) {
                                        phi_4815_ = -(_e1533);
                                    } else {
                                        phi_4815_ = _e1533;
                                    }
                                    let _e1542 = phi_4815_;
                                    if (_e1538 > _e1542) {
                                        phi_4820_ = _e1538;
                                    } else {
                                        phi_4820_ = _e1542;
                                    }
                                    let _e1545 = phi_4820_;
                                    if (_e1534 < 0f) {
                                        phi_4826_ = -(_e1534);
                                    } else {
                                        phi_4826_ = _e1534;
                                    }
                                    let _e1549 = phi_4826_;
                                    if (_e1545 > _e1549) {
                                        phi_4831_ = _e1545;
                                    } else {
                                        phi_4831_ = _e1549;
                                    }
                                    let _e1552 = phi_4831_;
                                    let _e1558 = ((((_e1189 * _e1552) * 1.01f) + ((_e1501 + _e1452) * (0.000000059604645f * 8f))) + _e1452);
                                    if (_e1519 < 0f) {
                                        phi_4843_ = -(_e1519);
                                    } else {
                                        phi_4843_ = _e1519;
                                    }
                                    let _e1562 = phi_4843_;
                                    if (_e1520 < 0f) {
                                        phi_4849_ = -(_e1520);
                                    } else {
                                        phi_4849_ = _e1520;
                                    }
                                    let _e1566 = phi_4849_;
                                    if (_e1562 > _e1566) {
                                        phi_4854_ = _e1562;
                                    } else {
                                        phi_4854_ = _e1566;
                                    }
                                    let _e1569 = phi_4854_;
                                    if (_e1521 < 0f) {
                                        phi_4860_ = -(_e1521);
                                    } else {
                                        phi_4860_ = _e1521;
                                    }
                                    let _e1573 = phi_4860_;
                                    if (_e1569 > _e1573) {
                                        phi_4865_ = _e1569;
                                    } else {
                                        phi_4865_ = _e1573;
                                    }
                                    let _e1576 = phi_4865_;
                                    local_5 = type_24(array<f32, 3>(_e1519, _e1520, _e1521), _e1558, (_e1576 + _e1558));
                                    let _e1581 = local_4.member;
                                    let _e1586 = local_5.member;
                                    let _e1592 = ((_e1581[1] * _e1586[2]) - (_e1581[2] * _e1586[1]));
                                    let _e1595 = ((_e1581[2] * _e1586[0]) - (_e1581[0] * _e1586[2]));
                                    let _e1598 = ((_e1581[0] * _e1586[1]) - (_e1581[1] * _e1586[0]));
                                    if (_e1592 < 0f) {
                                        phi_4914_ = -(_e1592);
                                    } else {
                                        phi_4914_ = _e1592;
                                    }
                                    let _e1602 = phi_4914_;
                                    if (_e1595 < 0f) {
                                        phi_4920_ = -(_e1595);
                                    } else {
                                        phi_4920_ = _e1595;
                                    }
                                    let _e1606 = phi_4920_;
                                    if (_e1602 > _e1606) {
                                        if (_e1592 < 0f) {
                                            phi_4930_ = -(_e1592);
                                        } else {
                                            phi_4930_ = _e1592;
                                        }
                                        let _e1624 = phi_4930_;
                                        if (_e1598 < 0f) {
                                            phi_4936_ = -(_e1598);
                                        } else {
                                            phi_4936_ = _e1598;
                                        }
                                        let _e1628 = phi_4936_;
                                        if (_e1624 > _e1628) {
                                            phi_4941_ = 2u;
                                            phi_4942_ = 1u;
                                        } else {
                                            phi_4941_ = 1u;
                                            phi_4942_ = 0u;
                                        }
                                        let _e1631 = phi_4941_;
                                        let _e1633 = phi_4942_;
                                        phi_4961_ = _e1631;
                                        phi_4962_ = _e1633;
                                    } else {
                                        if (_e1595 < 0f) {
                                            phi_4948_ = -(_e1595);
                                        } else {
                                            phi_4948_ = _e1595;
                                        }
                                        let _e1611 = phi_4948_;
                                        if (_e1598 < 0f) {
                                            phi_4954_ = -(_e1598);
                                        } else {
                                            phi_4954_ = _e1598;
                                        }
                                        let _e1615 = phi_4954_;
                                        if (_e1611 > _e1615) {
                                            phi_4959_ = 0u;
                                            phi_4960_ = 2u;
                                        } else {
                                            phi_4959_ = 1u;
                                            phi_4960_ = 0u;
                                        }
                                        let _e1618 = phi_4959_;
                                        let _e1620 = phi_4960_;
                                        phi_4961_ = _e1618;
                                        phi_4962_ = _e1620;
                                    }
                                    let _e1635 = phi_4961_;
                                    let _e1637 = phi_4962_;
                                    let _e1640 = local_4.member[_e1637];
                                    let _e1643 = local_5.member[_e1635];
                                    let _e1647 = local_4.member[_e1635];
                                    let _e1650 = local_5.member[_e1637];
                                    let _e1652 = ((_e1640 * _e1643) - (_e1647 * _e1650));
                                    let _e1654 = local_4.member_1;
                                    let _e1656 = local_5.member_2;
                                    let _e1659 = local_4.member_2;
                                    let _e1661 = local_5.member_1;
                                    let _e1666 = local_4.member_2;
                                    let _e1668 = local_5.member_2;
                                    let _e1675 = local_4.member_2;
                                    let _e1678 = local_5.member_2;
                                    let _e1682 = (((((_e1654 * _e1656) + (_e1659 * _e1661)) * 2.01f) + ((_e1666 * _e1668) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1675) * (1f + _e1678))));
                                    if (_e1652 < 0f) {
                                        phi_5029_ = -(_e1652);
                                    } else {
                                        phi_5029_ = _e1652;
                                    }
                                    let _e1686 = phi_5029_;
                                    if (_e1686 > _e1682) {
                                        if (_e1652 < 0f) {
                                            phi_5038_ = -1f;
                                        } else {
                                            phi_5038_ = 1f;
                                        }
                                        let _e1690 = phi_5038_;
                                        let _e1693 = local_3.member[_e1637];
                                        let _e1696 = local_5.member[_e1635];
                                        let _e1700 = local_3.member[_e1635];
                                        let _e1703 = local_5.member[_e1637];
                                        let _e1707 = local_3.member_1;
                                        let _e1709 = local_5.member_2;
                                        let _e1712 = local_3.member_2;
                                        let _e1714 = local_5.member_1;
                                        let _e1719 = local_3.member_2;
                                        let _e1721 = local_5.member_2;
                                        let _e1728 = local_3.member_2;
                                        let _e1731 = local_5.member_2;
                                        let _e1735 = (((((_e1707 * _e1709) + (_e1712 * _e1714)) * 2.01f) + ((_e1719 * _e1721) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1728) * (1f + _e1731))));
                                        let _e1738 = local_4.member[_e1637];
                                        let _e1741 = local_3.member[_e1635];
                                        let _e1745 = local_4.member[_e1635];
                                        let _e1748 = local_3.member[_e1637];
                                        let _e1752 = local_4.member_1;
                                        let _e1754 = local_3.member_2;
                                        let _e1757 = local_4.member_2;
                                        let _e1759 = local_3.member_1;
                                        let _e1764 = local_4.member_2;
                                        let _e1766 = local_3.member_2;
                                        let _e1773 = local_4.member_2;
                                        let _e1776 = local_3.member_2;
                                        let _e1780 = (((((_e1752 * _e1754) + (_e1757 * _e1759)) * 2.01f) + ((_e1764 * _e1766) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1773) * (1f + _e1776))));
                                        let _e1781 = (_e1652 * _e1690);
                                        let _e1782 = (((_e1693 * _e1696) - (_e1700 * _e1703)) * _e1690);
                                        let _e1783 = (((_e1738 * _e1741) - (_e1745 * _e1748)) * _e1690);
                                        if (_e1781 < 0f) {
                                            phi_5169_ = -(_e1781);
                                        } else {
                                            phi_5169_ = _e1781;
                                        }
                                        let _e1787 = phi_5169_;
                                        if (_e1782 < 0f) {
                                            phi_5175_ = -(_e1782);
                                        } else {
                                            phi_5175_ = _e1782;
                                        }
                                        let _e1791 = phi_5175_;
                                        if (_e1783 < 0f) {
                                            phi_5182_ = -(_e1783);
                                        } else {
                                            phi_5182_ = _e1783;
                                        }
                                        let _e1796 = phi_5182_;
                                        let _e1799 = (((_e1787 + _e1791) + _e1796) * (0.000000059604645f * 4f));
                                        local_6[0u].member = _e1782;
                                        local_6[0u].member_1 = _e1735;
                                        local_6[1u].member = _e1783;
                                        local_6[1u].member_1 = _e1780;
                                        local_6[2u].member = (_e1781 - _e1782);
                                        local_6[2u].member_1 = ((_e1682 + _e1735) + _e1799);
                                        local_6[3u].member = (_e1781 - _e1783);
                                        local_6[3u].member_1 = ((_e1682 + _e1780) + _e1799);
                                        phi_5225_ = type_19(0u, 4u);
                                        phi_5228_ = true;
                                        loop {
                                            let _e1820 = phi_5225_;
                                            let _e1822 = phi_5228_;
                                            local_20 = _e1822;
                                            if (_e1820.member < _e1820.member_1) {
                                                phi_5226_ = type_19((_e1820.member + 1u), _e1820.member_1);
                                                phi_5251_ = type_19(1u, _e1820.member);
                                            } else {
                                                phi_5226_ = _e1820;
                                                phi_5251_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1834 = phi_5226_;
                                            let _e1836 = phi_5251_;
                                            if (bitcast<i32>(_e1836.member) != 0i) {
                                                let _e1843 = local_6[_e1836.member_1].member;
                                                let _e1846 = local_6[_e1836.member_1].member_1;
                                                let _e1848 = (_e1843 < -(_e1846));
                                                if _e1848 {
                                                    phi_5278_ = bool();
                                                    phi_5279_ = false;
                                                } else {
                                                    phi_5278_ = (_e1822 && (_e1843 > _e1846));
                                                    phi_5279_ = true;
                                                }
                                                let _e1852 = phi_5278_;
                                                let _e1854 = phi_5279_;
                                                phi_5229_ = _e1852;
                                                phi_5280_ = _e1854;
                                                phi_5281_ = _e1848;
                                            } else {
                                                phi_5229_ = bool();
                                                phi_5280_ = false;
                                                phi_5281_ = false;
                                            }
                                            let _e1856 = phi_5229_;
                                            let _e1858 = phi_5280_;
                                            let _e1860 = phi_5281_;
                                            local_19 = _e1860;
                                            continue;
                                            continuing {
                                                phi_5225_ = _e1834;
                                                phi_5228_ = _e1856;
                                                break if !(_e1858);
                                            }
                                        }
                                        let _e1863 = local_19;
                                        if _e1863 {
                                            phi_5285_ = false;
                                        } else {
                                            phi_5285_ = true;
                                        }
                                        let _e1865 = phi_5285_;
                                        if _e1865 {
                                            let _e1867 = local_20;
                                            if _e1867 {
                                                phi_5292_ = 1u;
                                            } else {
                                                phi_5292_ = 2u;
                                            }
                                            let _e1869 = phi_5292_;
                                            phi_5293_ = _e1869;
                                            phi_5294_ = false;
                                        } else {
                                            phi_5293_ = u32();
                                            phi_5294_ = true;
                                        }
                                        let _e1871 = phi_5293_;
                                        let _e1873 = phi_5294_;
                                        phi_5295_ = _e1871;
                                        phi_5296_ = 0u;
                                        phi_5297_ = _e1873;
                                    } else {
                                        phi_5295_ = u32();
                                        phi_5296_ = 2u;
                                        phi_5297_ = true;
                                    }
                                    let _e1875 = phi_5295_;
                                    let _e1877 = phi_5296_;
                                    let _e1879 = phi_5297_;
                                    if _e1879 {
                                        phi_5301_ = _e1877;
                                    } else {
                                        phi_5301_ = _e1875;
                                    }
                                    let _e1881 = phi_5301_;
                                    let _e1882 = (_e1881 == 0u);
                                    if _e1882 {
                                        phi_6799_ = f32();
                                        phi_6800_ = false;
                                        phi_6801_ = false;
                                        phi_6802_ = false;
                                    } else {
                                        if (_e1881 == 1u) {
                                            if _e1179.member_2 {
                                                if ((_e1179.member_1 - _e1179.member) <= 0.0000005f) {
                                                    phi_5321_ = false;
                                                } else {
                                                    phi_5321_ = true;
                                                }
                                                let _e1890 = phi_5321_;
                                                phi_5322_ = _e1890;
                                            } else {
                                                phi_5322_ = true;
                                            }
                                            let _e1892 = phi_5322_;
                                            phi_5323_ = _e1892;
                                        } else {
                                            phi_5323_ = true;
                                        }
                                        let _e1894 = phi_5323_;
                                        if _e1894 {
                                            let _e1899 = local_15.member[0u];
                                            let _e1905 = local_15.member_1[0u];
                                            let _e1911 = local_15.member_2[0u];
                                            let _e1915 = (_e1899[0] - _e1905[0]);
                                            let _e1916 = (_e1899[1] - _e1905[1]);
                                            let _e1917 = (_e1899[2] - _e1905[2]);
                                            local_1 = array<array<f32, 3>, 4>(_e1899, array<f32, 3>(_e1915, _e1916, _e1917), array<f32, 3>((_e1899[0] - _e1911[0]), (_e1899[1] - _e1911[1]), (_e1899[2] - _e1911[2])), array<f32, 3>((_e1915 - _e1911[0]), (_e1916 - _e1911[1]), (_e1917 - _e1911[2])));
                                            let _e1930 = local_15.member[1u];
                                            let _e1936 = local_15.member_1[1u];
                                            let _e1942 = local_15.member_2[1u];
                                            let _e1946 = (_e1930[0] - _e1936[0]);
                                            let _e1947 = (_e1930[1] - _e1936[1]);
                                            let _e1948 = (_e1930[2] - _e1936[2]);
                                            local_2 = array<array<f32, 3>, 4>(_e1930, array<f32, 3>(_e1946, _e1947, _e1948), array<f32, 3>((_e1930[0] - _e1942[0]), (_e1930[1] - _e1942[1]), (_e1930[2] - _e1942[2])), array<f32, 3>((_e1946 - _e1942[0]), (_e1947 - _e1942[1]), (_e1948 - _e1942[2])));
                                            let _e1961 = local_15.member[0u];
                                            if (_e1961[0] < 0f) {
                                                phi_5519_ = -(_e1961[0]);
                                            } else {
                                                phi_5519_ = _e1961[0];
                                            }
                                            let _e1968 = phi_5519_;
                                            if (_e1961[1] < 0f) {
                                                phi_5526_ = -(_e1961[1]);
                                            } else {
                                                phi_5526_ = _e1961[1];
                                            }
                                            let _e1972 = phi_5526_;
                                            if (_e1968 > _e1972) {
                                                phi_5531_ = _e1968;
                                            } else {
                                                phi_5531_ = _e1972;
                                            }
                                            let _e1975 = phi_5531_;
                                            if (_e1961[2] < 0f) {
                                                phi_5538_ = -(_e1961[2]);
                                            } else {
                                                phi_5538_ = _e1961[2];
                                            }
                                            let _e1979 = phi_5538_;
                                            if (_e1975 > _e1979) {
                                                phi_5543_ = _e1975;
                                            } else {
                                                phi_5543_ = _e1979;
                                            }
                                            let _e1982 = phi_5543_;
                                            let _e1985 = local_15.member[1u];
                                            if (_e1985[0] < 0f) {
                                                phi_5556_ = -(_e1985[0]);
                                            } else {
                                                phi_5556_ = _e1985[0];
                                            }
                                            let _e1992 = phi_5556_;
                                            if (_e1985[1] < 0f) {
                                                phi_5563_ = -(_e1985[1]);
                                            } else {
                                                phi_5563_ = _e1985[1];
                                            }
                                            let _e1996 = phi_5563_;
                                            if (_e1992 > _e1996) {
                                                phi_5568_ = _e1992;
                                            } else {
                                                phi_5568_ = _e1996;
                                            }
                                            let _e1999 = phi_5568_;
                                            if (_e1985[2] < 0f) {
                                                phi_5575_ = -(_e1985[2]);
                                            } else {
                                                phi_5575_ = _e1985[2];
                                            }
                                            let _e2003 = phi_5575_;
                                            if (_e1999 > _e2003) {
                                                phi_5580_ = _e1999;
                                            } else {
                                                phi_5580_ = _e2003;
                                            }
                                            let _e2006 = phi_5580_;
                                            if (_e1982 > _e2006) {
                                                phi_5585_ = _e1982;
                                            } else {
                                                phi_5585_ = _e2006;
                                            }
                                            let _e2009 = phi_5585_;
                                            let _e2011 = local_15.member_3;
                                            let _e2015 = local_15.member_1[0u];
                                            if (_e2015[0] < 0f) {
                                                phi_5602_ = -(_e2015[0]);
                                            } else {
                                                phi_5602_ = _e2015[0];
                                            }
                                            let _e2022 = phi_5602_;
                                            if (_e2015[1] < 0f) {
                                                phi_5609_ = -(_e2015[1]);
                                            } else {
                                                phi_5609_ = _e2015[1];
                                            }
                                            let _e2026 = phi_5609_;
                                            if (_e2022 > _e2026) {
                                                phi_5614_ = _e2022;
                                            } else {
                                                phi_5614_ = _e2026;
                                            }
                                            let _e2029 = phi_5614_;
                                            if (_e2015[2] < 0f) {
                                                phi_5621_ = -(_e2015[2]);
                                            } else {
                                                phi_5621_ = _e2015[2];
                                            }
                                            let _e2033 = phi_5621_;
                                            if (_e2029 > _e2033) {
                                                phi_5626_ = _e2029;
                                            } else {
                                                phi_5626_ = _e2033;
                                            }
                                            let _e2036 = phi_5626_;
                                            let _e2039 = local_15.member_1[1u];
                                            if (_e2039[0] < 0f) {
                                                phi_5640_ = -(_e2039[0]);
                                            } else {
                                                phi_5640_ = _e2039[0];
                                            }
                                            let _e2046 = phi_5640_;
                                            if (_e2039[1] < 0f) {
                                                phi_5647_ = -(_e2039[1]);
                                            } else {
                                                phi_5647_ = _e2039[1];
                                            }
                                            let _e2050 = phi_5647_;
                                            if (_e2046 > _e2050) {
                                                phi_5652_ = _e2046;
                                            } else {
                                                phi_5652_ = _e2050;
                                            }
                                            let _e2053 = phi_5652_;
                                            if (_e2039[2] < 0f) {
                                                phi_5659_ = -(_e2039[2]);
                                            } else {
                                                phi_5659_ = _e2039[2];
                                            }
                                            let _e2057 = phi_5659_;
                                            if (_e2053 > _e2057) {
                                                phi_5664_ = _e2053;
                                            } else {
                                                phi_5664_ = _e2057;
                                            }
                                            let _e2060 = phi_5664_;
                                            if (_e2036 > _e2060) {
                                                phi_5669_ = _e2036;
                                            } else {
                                                phi_5669_ = _e2060;
                                            }
                                            let _e2063 = phi_5669_;
                                            let _e2065 = local_15.member_3;
                                            let _e2069 = local_15.member_2[0u];
                                            if (_e2069[0] < 0f) {
                                                phi_5686_ = -(_e2069[0]);
                                            } else {
                                                phi_5686_ = _e2069[0];
                                            }
                                            let _e2076 = phi_5686_;
                                            if (_e2069[1] < 0f) {
                                                phi_5693_ = -(_e2069[1]);
                                            } else {
                                                phi_5693_ = _e2069[1];
                                            }
                                            let _e2080 = phi_5693_;
                                            if (_e2076 > _e2080) {
                                                phi_5698_ = _e2076;
                                            } else {
                                                phi_5698_ = _e2080;
                                            }
                                            let _e2083 = phi_5698_;
                                            if (_e2069[2] < 0f) {
                                                phi_5705_ = -(_e2069[2]);
                                            } else {
                                                phi_5705_ = _e2069[2];
                                            }
                                            let _e2087 = phi_5705_;
                                            if (_e2083 > _e2087) {
                                                phi_5710_ = _e2083;
                                            } else {
                                                phi_5710_ = _e2087;
                                            }
                                            let _e2090 = phi_5710_;
                                            let _e2093 = local_15.member_2[1u];
                                            if (_e2093[0] < 0f) {
                                                phi_5724_ = -(_e2093[0]);
                                            } else {
                                                phi_5724_ = _e2093[0];
                                            }
                                            let _e2100 = phi_5724_;
                                            if (_e2093[1] < 0f) {
                                                phi_5731_ = -(_e2093[1]);
                                            } else {
                                                phi_5731_ = _e2093[1];
                                            }
                                            let _e2104 = phi_5731_;
                                            if (_e2100 > _e2104) {
                                                phi_5736_ = _e2100;
                                            } else {
                                                phi_5736_ = _e2104;
                                            }
                                            let _e2107 = phi_5736_;
                                            if (_e2093[2] < 0f) {
                                                phi_5743_ = -(_e2093[2]);
                                            } else {
                                                phi_5743_ = _e2093[2];
                                            }
                                            let _e2111 = phi_5743_;
                                            if (_e2107 > _e2111) {
                                                phi_5748_ = _e2107;
                                            } else {
                                                phi_5748_ = _e2111;
                                            }
                                            let _e2114 = phi_5748_;
                                            if (_e2090 > _e2114) {
                                                phi_5753_ = _e2090;
                                            } else {
                                                phi_5753_ = _e2114;
                                            }
                                            let _e2117 = phi_5753_;
                                            let _e2119 = local_15.member_3;
                                            let _e2126 = local_15.member_3;
                                            phi_5769_ = type_19(0u, 48u);
                                            phi_5772_ = _e1179.member;
                                            loop {
                                                let _e2132 = phi_5769_;
                                                let _e2134 = phi_5772_;
                                                local_65 = _e2134;
                                                local_27 = _e2134;
                                                local_28 = _e2134;
                                                local_29 = _e2134;
                                                local_30 = _e2134;
                                                if (_e2132.member < _e2132.member_1) {
                                                    phi_5770_ = type_19((_e2132.member + 1u), _e2132.member_1);
                                                    phi_5795_ = type_19(1u, _e2132.member);
                                                } else {
                                                    phi_5770_ = _e2132;
                                                    phi_5795_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2146 = phi_5770_;
                                                let _e2148 = phi_5795_;
                                                if (bitcast<i32>(_e2148.member) != 0i) {
                                                    let _e2154 = local_15.member[0u];
                                                    let _e2160 = local_15.member[1u];
                                                    let _e2170 = (_e2154[0] + ((_e2160[0] - _e2154[0]) * _e2134));
                                                    let _e2171 = (_e2154[1] + ((_e2160[1] - _e2154[1]) * _e2134));
                                                    let _e2172 = (_e2154[2] + ((_e2160[2] - _e2154[2]) * _e2134));
                                                    let _e2175 = local_15.member_1[0u];
                                                    let _e2181 = local_15.member_1[1u];
                                                    let _e2191 = (_e2175[0] + ((_e2181[0] - _e2175[0]) * _e2134));
                                                    let _e2192 = (_e2175[1] + ((_e2181[1] - _e2175[1]) * _e2134));
                                                    let _e2193 = (_e2175[2] + ((_e2181[2] - _e2175[2]) * _e2134));
                                                    let _e2196 = local_15.member_2[0u];
                                                    let _e2202 = local_15.member_2[1u];
                                                    let _e2212 = (_e2196[0] + ((_e2202[0] - _e2196[0]) * _e2134));
                                                    let _e2213 = (_e2196[1] + ((_e2202[1] - _e2196[1]) * _e2134));
                                                    let _e2214 = (_e2196[2] + ((_e2202[2] - _e2196[2]) * _e2134));
                                                    let _e2219 = (((_e2191 * _e2191) + (_e2192 * _e2192)) + (_e2193 * _e2193));
                                                    let _e2224 = (((_e2191 * _e2212) + (_e2192 * _e2213)) + (_e2193 * _e2214));
                                                    let _e2229 = (((_e2212 * _e2212) + (_e2213 * _e2213)) + (_e2214 * _e2214));
                                                    let _e2234 = (((_e2170 * _e2191) + (_e2171 * _e2192)) + (_e2172 * _e2193));
                                                    let _e2239 = (((_e2170 * _e2212) + (_e2171 * _e2213)) + (_e2172 * _e2214));
                                                    let _e2242 = ((_e2219 * _e2229) - (_e2224 * _e2224));
                                                    let _e2246 = (((_e2234 * _e2229) - (_e2239 * _e2224)) / _e2242);
                                                    let _e2250 = (((_e2239 * _e2219) - (_e2234 * _e2224)) / _e2242);
                                                    if (_e2246 >= 0f) {
                                                        if (_e2250 >= 0f) {
                                                            if (_e2246 <= 1f) {
                                                                phi_5949_ = (_e2250 <= 1f);
                                                                phi_5950_ = false;
                                                            } else {
                                                                phi_5949_ = bool();
                                                                phi_5950_ = true;
                                                            }
                                                            let _e2256 = phi_5949_;
                                                            let _e2258 = phi_5950_;
                                                            phi_5951_ = _e2256;
                                                            phi_5952_ = _e2258;
                                                        } else {
                                                            phi_5951_ = bool();
                                                            phi_5952_ = true;
                                                        }
                                                        let _e2260 = phi_5951_;
                                                        let _e2262 = phi_5952_;
                                                        phi_5953_ = _e2260;
                                                        phi_5954_ = _e2262;
                                                    } else {
                                                        phi_5953_ = bool();
                                                        phi_5954_ = true;
                                                    }
                                                    let _e2264 = phi_5953_;
                                                    let _e2266 = phi_5954_;
                                                    if _e2266 {
                                                        phi_5958_ = false;
                                                    } else {
                                                        phi_5958_ = _e2264;
                                                    }
                                                    let _e2268 = phi_5958_;
                                                    if (_e2242 > 0f) {
                                                        if _e2268 {
                                                            phi_5998_ = array<f32, 3>((_e2170 - ((_e2191 * _e2246) + (_e2212 * _e2250))), (_e2171 - ((_e2192 * _e2246) + (_e2213 * _e2250))), (_e2172 - ((_e2193 * _e2246) + (_e2214 * _e2250))));
                                                            phi_5999_ = false;
                                                        } else {
                                                            phi_5998_ = array<f32, 3>();
                                                            phi_5999_ = true;
                                                        }
                                                        let _e2284 = phi_5998_;
                                                        let _e2286 = phi_5999_;
                                                        phi_6000_ = _e2284;
                                                        phi_6001_ = _e2286;
                                                    } else {
                                                        phi_6000_ = array<f32, 3>();
                                                        phi_6001_ = true;
                                                    }
                                                    let _e2288 = phi_6000_;
                                                    let _e2290 = phi_6001_;
                                                    if _e2290 {
                                                        let _e2291 = (_e2170 - _e2191);
                                                        let _e2292 = (_e2171 - _e2192);
                                                        let _e2293 = (_e2172 - _e2193);
                                                        let _e2304 = ((((_e2170 * _e2191) + (_e2171 * _e2192)) + (_e2172 * _e2193)) / (((_e2191 * _e2191) + (_e2192 * _e2192)) + (_e2193 * _e2193)));
                                                        if (_e2304 > 0f) {
                                                            if (_e2304 < 1f) {
                                                                phi_6031_ = _e2304;
                                                            } else {
                                                                phi_6031_ = 1f;
                                                            }
                                                            let _e2308 = phi_6031_;
                                                            phi_6032_ = _e2308;
                                                        } else {
                                                            phi_6032_ = 0f;
                                                        }
                                                        let _e2310 = phi_6032_;
                                                        let _e2327 = ((((_e2170 * _e2212) + (_e2171 * _e2213)) + (_e2172 * _e2214)) / (((_e2212 * _e2212) + (_e2213 * _e2213)) + (_e2214 * _e2214)));
                                                        if (_e2327 > 0f) {
                                                            if (_e2327 < 1f) {
                                                                phi_6059_ = _e2327;
                                                            } else {
                                                                phi_6059_ = 1f;
                                                            }
                                                            let _e2331 = phi_6059_;
                                                            phi_6060_ = _e2331;
                                                        } else {
                                                            phi_6060_ = 0f;
                                                        }
                                                        let _e2333 = phi_6060_;
                                                        let _e2350 = ((((_e2291 * _e2212) + (_e2292 * _e2213)) + (_e2293 * _e2214)) / (((_e2212 * _e2212) + (_e2213 * _e2213)) + (_e2214 * _e2214)));
                                                        if (_e2350 > 0f) {
                                                            if (_e2350 < 1f) {
                                                                phi_6087_ = _e2350;
                                                            } else {
                                                                phi_6087_ = 1f;
                                                            }
                                                            let _e2354 = phi_6087_;
                                                            phi_6088_ = _e2354;
                                                        } else {
                                                            phi_6088_ = 0f;
                                                        }
                                                        let _e2356 = phi_6088_;
                                                        let _e2363 = (_e2170 - _e2212);
                                                        let _e2364 = (_e2171 - _e2213);
                                                        let _e2365 = (_e2172 - _e2214);
                                                        let _e2376 = ((((_e2363 * _e2191) + (_e2364 * _e2192)) + (_e2365 * _e2193)) / (((_e2191 * _e2191) + (_e2192 * _e2192)) + (_e2193 * _e2193)));
                                                        if (_e2376 > 0f) {
                                                            if (_e2376 < 1f) {
                                                                phi_6118_ = _e2376;
                                                            } else {
                                                                phi_6118_ = 1f;
                                                            }
                                                            let _e2380 = phi_6118_;
                                                            phi_6119_ = _e2380;
                                                        } else {
                                                            phi_6119_ = 0f;
                                                        }
                                                        let _e2382 = phi_6119_;
                                                        local[0u] = array<f32, 3>((_e2170 - (_e2191 * _e2310)), (_e2171 - (_e2192 * _e2310)), (_e2172 - (_e2193 * _e2310)));
                                                        local[1u] = array<f32, 3>((_e2170 - (_e2212 * _e2333)), (_e2171 - (_e2213 * _e2333)), (_e2172 - (_e2214 * _e2333)));
                                                        local[2u] = array<f32, 3>((_e2291 - (_e2212 * _e2356)), (_e2292 - (_e2213 * _e2356)), (_e2293 - (_e2214 * _e2356)));
                                                        local[3u] = array<f32, 3>((_e2363 - (_e2191 * _e2382)), (_e2364 - (_e2192 * _e2382)), (_e2365 - (_e2193 * _e2382)));
                                                        let _e2398 = local[0u];
                                                        phi_6262_ = type_19(1u, 4u);
                                                        phi_6265_ = array<f32, 3>(_e2398[0], _e2398[1], _e2398[2]);
                                                        loop {
                                                            let _e2404 = phi_6262_;
                                                            let _e2406 = phi_6265_;
                                                            local_52 = _e2406;
                                                            if (_e2404.member < _e2404.member_1) {
                                                                phi_6263_ = type_19((_e2404.member + 1u), _e2404.member_1);
                                                                phi_6288_ = type_19(1u, _e2404.member);
                                                            } else {
                                                                phi_6263_ = _e2404;
                                                                phi_6288_ = type_19(0u, type_19().member_1);
                                                            }
                                                            let _e2418 = phi_6263_;
                                                            let _e2420 = phi_6288_;
                                                            let _e2424 = (bitcast<i32>(_e2420.member) != 0i);
                                                            if _e2424 {
                                                                let _e2426 = local[_e2420.member_1];
                                                                let _e2431 = local[_e2420.member_1];
                                                                if ((((_e2426[0] * _e2431[0]) + (_e2426[1] * _e2431[1])) + (_e2426[2] * _e2431[2])) < (((_e2406[0] * _e2406[0]) + (_e2406[1] * _e2406[1])) + (_e2406[2] * _e2406[2]))) {
                                                                    let _e2453 = local[_e2420.member_1];
                                                                    phi_6355_ = array<f32, 3>(_e2453[0], _e2453[1], _e2453[2]);
                                                                } else {
                                                                    phi_6355_ = _e2406;
                                                                }
                                                                let _e2459 = phi_6355_;
                                                                phi_6266_ = _e2459;
                                                            } else {
                                                                phi_6266_ = array<f32, 3>();
                                                            }
                                                            let _e2461 = phi_6266_;
                                                            continue;
                                                            continuing {
                                                                phi_6262_ = _e2418;
                                                                phi_6265_ = _e2461;
                                                                break if !(_e2424);
                                                            }
                                                        }
                                                        let _e5035 = local_52;
                                                        phi_6356_ = _e5035;
                                                    } else {
                                                        phi_6356_ = _e2288;
                                                    }
                                                    let _e2464 = phi_6356_;
                                                    if (_e2464[0] < 0f) {
                                                        phi_6363_ = -(_e2464[0]);
                                                    } else {
                                                        phi_6363_ = _e2464[0];
                                                    }
                                                    let _e2469 = phi_6363_;
                                                    if (_e2464[1] < 0f) {
                                                        phi_6370_ = -(_e2464[1]);
                                                    } else {
                                                        phi_6370_ = _e2464[1];
                                                    }
                                                    let _e2474 = phi_6370_;
                                                    if (_e2464[2] < 0f) {
                                                        phi_6378_ = -(_e2464[2]);
                                                    } else {
                                                        phi_6378_ = _e2464[2];
                                                    }
                                                    let _e2480 = phi_6378_;
                                                    let _e2481 = ((_e2469 + _e2474) + _e2480);
                                                    if (_e2481 > 0f) {
                                                        if ((bitcast<u32>(_e2481) & 2139095040u) != 2139095040u) {
                                                            let _e2486 = (1f / _e2481);
                                                            let _e2488 = (_e2464[0] * _e2486);
                                                            let _e2490 = (_e2464[1] * _e2486);
                                                            let _e2492 = (_e2464[2] * _e2486);
                                                            let _e2497 = (((_e2488 * _e2488) + (_e2490 * _e2490)) + (_e2492 * _e2492));
                                                            if (_e2497 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2497 > 0f) {
                                                                    phi_6415_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6415_ = 0f;
                                                                }
                                                                let _e2550 = phi_6415_;
                                                                phi_6479_ = _e2550;
                                                            } else {
                                                                phi_6422_ = type_17(0i, 5i);
                                                                phi_6425_ = bitcast<f32>(((bitcast<u32>(_e2497) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2505 = phi_6422_;
                                                                    let _e2507 = phi_6425_;
                                                                    local_21 = _e2507;
                                                                    if (_e2505.member < _e2505.member_1) {
                                                                        let _e2514 = (_e2505.member + 1i);
                                                                        if ((false == (_e2514 > _e2505.member)) != false) {
                                                                            phi_6446_ = true;
                                                                        } else {
                                                                            phi_6446_ = false;
                                                                        }
                                                                        let _e2519 = phi_6446_;
                                                                        if _e2519 {
                                                                            phi_6452_ = type_18(0u, type_18().member_1);
                                                                        } else {
                                                                            phi_6452_ = type_18(1u, _e2514);
                                                                        }
                                                                        let _e2524 = phi_6452_;
                                                                        phi_6423_ = type_17(_e2524.member_1, _e2505.member_1);
                                                                        phi_6466_ = type_18(1u, _e2505.member);
                                                                    } else {
                                                                        phi_6423_ = _e2505;
                                                                        phi_6466_ = type_18(0u, type_18().member_1);
                                                                    }
                                                                    let _e2530 = phi_6423_;
                                                                    let _e2532 = phi_6466_;
                                                                    let _e2535 = (bitcast<i32>(_e2532.member) != 0i);
                                                                    if _e2535 {
                                                                        phi_6426_ = (0.5f * (_e2507 + (_e2497 / _e2507)));
                                                                    } else {
                                                                        phi_6426_ = f32();
                                                                    }
                                                                    let _e2540 = phi_6426_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6422_ = _e2530;
                                                                        phi_6425_ = _e2540;
                                                                        break if !(_e2535);
                                                                    }
                                                                }
                                                                let _e2545 = local_21;
                                                                phi_6479_ = (_e2545 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2552 = phi_6479_;
                                                            phi_6488_ = type_19(0u, 4u);
                                                            phi_6491_ = 2f;
                                                            loop {
                                                                let _e2560 = phi_6488_;
                                                                let _e2562 = phi_6491_;
                                                                local_23 = _e2562;
                                                                local_24 = _e2562;
                                                                local_25 = _e2562;
                                                                local_55 = _e2562;
                                                                local_56 = _e2562;
                                                                if (_e2560.member < _e2560.member_1) {
                                                                    phi_6489_ = type_19((_e2560.member + 1u), _e2560.member_1);
                                                                    phi_6514_ = type_19(1u, _e2560.member);
                                                                } else {
                                                                    phi_6489_ = _e2560;
                                                                    phi_6514_ = type_19(0u, type_19().member_1);
                                                                }
                                                                let _e2574 = phi_6489_;
                                                                let _e2576 = phi_6514_;
                                                                if (bitcast<i32>(_e2576.member) != 0i) {
                                                                    let _e2582 = local_1[_e2576.member_1];
                                                                    let _e2590 = (((_e2488 * _e2582[0]) + (_e2490 * _e2582[1])) + (_e2492 * _e2582[2]));
                                                                    let _e2592 = local_2[_e2576.member_1];
                                                                    let _e2600 = (((_e2488 * _e2592[0]) + (_e2490 * _e2592[1])) + (_e2492 * _e2592[2]));
                                                                    if (_e2590 < 0f) {
                                                                        phi_6565_ = -(_e2590);
                                                                    } else {
                                                                        phi_6565_ = _e2590;
                                                                    }
                                                                    let _e2604 = phi_6565_;
                                                                    if (_e2600 < 0f) {
                                                                        phi_6571_ = -(_e2600);
                                                                    } else {
                                                                        phi_6571_ = _e2600;
                                                                    }
                                                                    let _e2608 = phi_6571_;
                                                                    let _e2612 = (((((((((_e2009 + _e2011) + (_e2063 + _e2065)) + (_e2117 + _e2119)) * (0.000000059604645f * 16f)) + (_e2126 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2552) * (1f + (0.000000059604645f * 8f)))) + ((_e2604 + _e2608) * (0.000000059604645f * 8f)));
                                                                    if (_e2590 > _e2612) {
                                                                        if (_e2600 > _e2612) {
                                                                            phi_6584_ = false;
                                                                        } else {
                                                                            phi_6584_ = true;
                                                                        }
                                                                        let _e2616 = phi_6584_;
                                                                        phi_6585_ = _e2616;
                                                                    } else {
                                                                        phi_6585_ = true;
                                                                    }
                                                                    let _e2618 = phi_6585_;
                                                                    if _e2618 {
                                                                        if ((_e2590 + ((_e2600 - _e2590) * _e2134)) > _e2612) {
                                                                            if (_e2600 < _e2590) {
                                                                                let _e2626 = ((_e2590 - _e2600) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                                                if _e2626 {
                                                                                    let _e2632 = (((_e2590 - _e2612) / (_e2590 - _e2600)) * (1f - (0.000000059604645f * 16f)));
                                                                                    if (_e2562 < _e2632) {
                                                                                        phi_6616_ = _e2562;
                                                                                    } else {
                                                                                        phi_6616_ = _e2632;
                                                                                    }
                                                                                    let _e2635 = phi_6616_;
                                                                                    phi_6617_ = _e2635;
                                                                                } else {
                                                                                    phi_6617_ = f32();
                                                                                }
                                                                                let _e2637 = phi_6617_;
                                                                                phi_6618_ = _e2637;
                                                                                phi_6619_ = _e2626;
                                                                            } else {
                                                                                phi_6618_ = _e2562;
                                                                                phi_6619_ = true;
                                                                            }
                                                                            let _e2639 = phi_6618_;
                                                                            let _e2641 = phi_6619_;
                                                                            if _e2641 {
                                                                                phi_6623_ = false;
                                                                            } else {
                                                                                phi_6623_ = true;
                                                                            }
                                                                            let _e2643 = phi_6623_;
                                                                            phi_6624_ = _e2639;
                                                                            phi_6625_ = _e2641;
                                                                            phi_6626_ = _e2643;
                                                                            phi_6627_ = false;
                                                                        } else {
                                                                            phi_6624_ = f32();
                                                                            phi_6625_ = false;
                                                                            phi_6626_ = false;
                                                                            phi_6627_ = true;
                                                                        }
                                                                        let _e2645 = phi_6624_;
                                                                        let _e2647 = phi_6625_;
                                                                        let _e2649 = phi_6626_;
                                                                        let _e2651 = phi_6627_;
                                                                        phi_6628_ = _e2645;
                                                                        phi_6629_ = _e2647;
                                                                        phi_6630_ = _e2649;
                                                                        phi_6631_ = _e2651;
                                                                    } else {
                                                                        phi_6628_ = _e2562;
                                                                        phi_6629_ = true;
                                                                        phi_6630_ = false;
                                                                        phi_6631_ = false;
                                                                    }
                                                                    let _e2653 = phi_6628_;
                                                                    let _e2655 = phi_6629_;
                                                                    let _e2657 = phi_6630_;
                                                                    let _e2659 = phi_6631_;
                                                                    phi_6492_ = _e2653;
                                                                    phi_6632_ = _e2655;
                                                                    phi_6633_ = false;
                                                                    phi_6634_ = _e2657;
                                                                    phi_6635_ = _e2659;
                                                                } else {
                                                                    phi_6492_ = f32();
                                                                    phi_6632_ = false;
                                                                    phi_6633_ = true;
                                                                    phi_6634_ = false;
                                                                    phi_6635_ = false;
                                                                }
                                                                let _e2661 = phi_6492_;
                                                                let _e2663 = phi_6632_;
                                                                let _e2665 = phi_6633_;
                                                                let _e2667 = phi_6634_;
                                                                let _e2669 = phi_6635_;
                                                                local_22 = _e2665;
                                                                local_53 = _e2667;
                                                                local_54 = _e2669;
                                                                continue;
                                                                continuing {
                                                                    phi_6488_ = _e2574;
                                                                    phi_6491_ = _e2661;
                                                                    break if !(_e2663);
                                                                }
                                                            }
                                                            let _e2672 = local_22;
                                                            if _e2672 {
                                                                let _e2674 = local_23;
                                                                let _e2675 = (_e2674 > _e1179.member_1);
                                                                if _e2675 {
                                                                    phi_6656_ = false;
                                                                    phi_6657_ = false;
                                                                    phi_6658_ = false;
                                                                } else {
                                                                    let _e2677 = local_24;
                                                                    if (_e2677 > _e2134) {
                                                                        let _e2680 = local_25;
                                                                        let _e2682 = ((_e2680 - _e2134) < 0.00000000023283064f);
                                                                        if _e2682 {
                                                                            phi_6652_ = false;
                                                                        } else {
                                                                            phi_6652_ = true;
                                                                        }
                                                                        let _e2684 = phi_6652_;
                                                                        phi_6653_ = _e2684;
                                                                        phi_6654_ = _e2682;
                                                                        phi_6655_ = false;
                                                                    } else {
                                                                        phi_6653_ = false;
                                                                        phi_6654_ = false;
                                                                        phi_6655_ = true;
                                                                    }
                                                                    let _e2686 = phi_6653_;
                                                                    let _e2688 = phi_6654_;
                                                                    let _e2690 = phi_6655_;
                                                                    phi_6656_ = _e2686;
                                                                    phi_6657_ = _e2688;
                                                                    phi_6658_ = _e2690;
                                                                }
                                                                let _e2692 = phi_6656_;
                                                                let _e2694 = phi_6657_;
                                                                let _e2696 = phi_6658_;
                                                                phi_6659_ = _e2692;
                                                                phi_6660_ = _e2675;
                                                                phi_6661_ = _e2694;
                                                                phi_6662_ = _e2696;
                                                                phi_6663_ = false;
                                                                phi_6664_ = false;
                                                            } else {
                                                                phi_6659_ = false;
                                                                phi_6660_ = false;
                                                                phi_6661_ = false;
                                                                phi_6662_ = false;
                                                                let _e5092 = local_53;
                                                                phi_6663_ = _e5092;
                                                                let _e5095 = local_54;
                                                                phi_6664_ = _e5095;
                                                            }
                                                            let _e2698 = phi_6659_;
                                                            let _e2700 = phi_6660_;
                                                            let _e2702 = phi_6661_;
                                                            let _e2704 = phi_6662_;
                                                            let _e2706 = phi_6663_;
                                                            let _e2708 = phi_6664_;
                                                            let _e5098 = local_55;
                                                            phi_6665_ = _e5098;
                                                            let _e5101 = local_56;
                                                            phi_6666_ = _e5101;
                                                            phi_6667_ = _e2698;
                                                            phi_6668_ = _e2700;
                                                            phi_6669_ = _e2702;
                                                            phi_6670_ = _e2704;
                                                            phi_6671_ = _e2706;
                                                            phi_6672_ = _e2708;
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
                                                        let _e2710 = phi_6665_;
                                                        let _e2712 = phi_6666_;
                                                        let _e2714 = phi_6667_;
                                                        let _e2716 = phi_6668_;
                                                        let _e2718 = phi_6669_;
                                                        let _e2720 = phi_6670_;
                                                        let _e2722 = phi_6671_;
                                                        let _e2724 = phi_6672_;
                                                        let _e2726 = phi_6673_;
                                                        phi_6674_ = _e2710;
                                                        phi_6675_ = _e2712;
                                                        phi_6676_ = _e2714;
                                                        phi_6677_ = _e2716;
                                                        phi_6678_ = _e2718;
                                                        phi_6679_ = _e2720;
                                                        phi_6680_ = _e2722;
                                                        phi_6681_ = _e2724;
                                                        phi_6682_ = _e2726;
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
                                                    let _e2728 = phi_6674_;
                                                    let _e2730 = phi_6675_;
                                                    let _e2732 = phi_6676_;
                                                    let _e2734 = phi_6677_;
                                                    let _e2736 = phi_6678_;
                                                    let _e2738 = phi_6679_;
                                                    let _e2740 = phi_6680_;
                                                    let _e2742 = phi_6681_;
                                                    let _e2744 = phi_6682_;
                                                    let _e2746 = phi_6683_;
                                                    phi_6684_ = _e2728;
                                                    phi_5773_ = _e2730;
                                                    phi_6685_ = _e2732;
                                                    phi_6686_ = _e2734;
                                                    phi_6687_ = _e2736;
                                                    phi_6688_ = false;
                                                    phi_6689_ = _e2738;
                                                    phi_6690_ = _e2740;
                                                    phi_6691_ = _e2742;
                                                    phi_6692_ = _e2744;
                                                    phi_6693_ = _e2746;
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
                                                let _e2748 = phi_6684_;
                                                let _e2750 = phi_5773_;
                                                let _e2752 = phi_6685_;
                                                let _e2754 = phi_6686_;
                                                let _e2756 = phi_6687_;
                                                let _e2758 = phi_6688_;
                                                let _e2760 = phi_6689_;
                                                let _e2762 = phi_6690_;
                                                let _e2764 = phi_6691_;
                                                let _e2766 = phi_6692_;
                                                let _e2768 = phi_6693_;
                                                local_26 = _e2754;
                                                local_57 = _e2756;
                                                local_58 = _e2758;
                                                local_59 = _e2760;
                                                local_60 = _e2762;
                                                local_61 = _e2764;
                                                local_62 = _e2766;
                                                local_63 = _e2768;
                                                local_64 = _e2748;
                                                local_66 = _e2754;
                                                continue;
                                                continuing {
                                                    phi_5769_ = _e2146;
                                                    phi_5772_ = _e2750;
                                                    break if !(_e2752);
                                                }
                                            }
                                            let _e2771 = local_26;
                                            if _e2771 {
                                                phi_6698_ = type_32(0u, type_32().member_1);
                                                phi_6699_ = false;
                                                phi_6700_ = false;
                                                phi_6701_ = false;
                                                phi_6702_ = false;
                                                phi_6703_ = false;
                                                phi_6704_ = false;
                                                phi_6705_ = false;
                                            } else {
                                                phi_6698_ = type_32();
                                                let _e5134 = local_57;
                                                phi_6699_ = _e5134;
                                                let _e5137 = local_58;
                                                phi_6700_ = _e5137;
                                                let _e5140 = local_59;
                                                phi_6701_ = _e5140;
                                                let _e5143 = local_60;
                                                phi_6702_ = _e5143;
                                                let _e5146 = local_61;
                                                phi_6703_ = _e5146;
                                                let _e5149 = local_62;
                                                phi_6704_ = _e5149;
                                                let _e5152 = local_63;
                                                phi_6705_ = _e5152;
                                            }
                                            let _e2775 = phi_6698_;
                                            let _e2777 = phi_6699_;
                                            let _e2779 = phi_6700_;
                                            let _e2781 = phi_6701_;
                                            let _e2783 = phi_6702_;
                                            let _e2785 = phi_6703_;
                                            let _e2787 = phi_6704_;
                                            let _e2789 = phi_6705_;
                                            if _e2777 {
                                                let _e5155 = local_64;
                                                phi_6709_ = _e5155;
                                                phi_6710_ = true;
                                                phi_6711_ = false;
                                                phi_6712_ = false;
                                                phi_6713_ = false;
                                                phi_6714_ = false;
                                                phi_6715_ = false;
                                                phi_6716_ = false;
                                            } else {
                                                let _e5157 = local_65;
                                                phi_6709_ = _e5157;
                                                phi_6710_ = _e2779;
                                                phi_6711_ = _e2781;
                                                phi_6712_ = _e2783;
                                                phi_6713_ = _e2785;
                                                let _e5164 = local_66;
                                                phi_6714_ = _e5164;
                                                phi_6715_ = _e2787;
                                                phi_6716_ = _e2789;
                                            }
                                            let _e2791 = phi_6709_;
                                            let _e2793 = phi_6710_;
                                            let _e2795 = phi_6711_;
                                            let _e2797 = phi_6712_;
                                            let _e2799 = phi_6713_;
                                            let _e2801 = phi_6714_;
                                            let _e2803 = phi_6715_;
                                            let _e2805 = phi_6716_;
                                            if _e2793 {
                                                phi_6721_ = type_32(1u, _e2791);
                                                phi_6722_ = false;
                                                phi_6723_ = false;
                                                phi_6724_ = false;
                                                phi_6725_ = false;
                                                phi_6726_ = false;
                                                phi_6727_ = false;
                                            } else {
                                                phi_6721_ = type_32();
                                                phi_6722_ = _e2795;
                                                phi_6723_ = _e2797;
                                                phi_6724_ = _e2799;
                                                phi_6725_ = _e2801;
                                                phi_6726_ = _e2803;
                                                phi_6727_ = _e2805;
                                            }
                                            let _e2808 = phi_6721_;
                                            let _e2810 = phi_6722_;
                                            let _e2812 = phi_6723_;
                                            let _e2814 = phi_6724_;
                                            let _e2816 = phi_6725_;
                                            let _e2818 = phi_6726_;
                                            let _e2820 = phi_6727_;
                                            if _e2810 {
                                                let _e2822 = local_27;
                                                phi_6732_ = type_32(1u, _e2822);
                                                phi_6733_ = false;
                                                phi_6734_ = false;
                                                phi_6735_ = true;
                                                phi_6736_ = false;
                                                phi_6737_ = false;
                                            } else {
                                                phi_6732_ = _e2775;
                                                phi_6733_ = _e2812;
                                                phi_6734_ = _e2814;
                                                phi_6735_ = _e2816;
                                                phi_6736_ = _e2818;
                                                phi_6737_ = _e2820;
                                            }
                                            let _e2825 = phi_6732_;
                                            let _e2827 = phi_6733_;
                                            let _e2829 = phi_6734_;
                                            let _e2831 = phi_6735_;
                                            let _e2833 = phi_6736_;
                                            let _e2835 = phi_6737_;
                                            if _e2827 {
                                                let _e2837 = local_28;
                                                phi_6742_ = type_32(1u, _e2837);
                                                phi_6743_ = false;
                                                phi_6744_ = false;
                                                phi_6745_ = false;
                                                phi_6746_ = false;
                                            } else {
                                                phi_6742_ = type_32();
                                                phi_6743_ = _e2829;
                                                phi_6744_ = _e2831;
                                                phi_6745_ = _e2833;
                                                phi_6746_ = _e2835;
                                            }
                                            let _e2840 = phi_6742_;
                                            let _e2842 = phi_6743_;
                                            let _e2844 = phi_6744_;
                                            let _e2846 = phi_6745_;
                                            let _e2848 = phi_6746_;
                                            if _e2842 {
                                                let _e2850 = local_29;
                                                phi_6751_ = type_32(1u, _e2850);
                                                phi_6752_ = true;
                                                phi_6753_ = false;
                                                phi_6754_ = false;
                                                phi_6755_ = false;
                                            } else {
                                                phi_6751_ = _e2840;
                                                phi_6752_ = _e2827;
                                                phi_6753_ = _e2844;
                                                phi_6754_ = _e2846;
                                                phi_6755_ = _e2848;
                                            }
                                            let _e2853 = phi_6751_;
                                            let _e2855 = phi_6752_;
                                            let _e2857 = phi_6753_;
                                            let _e2859 = phi_6754_;
                                            let _e2861 = phi_6755_;
                                            if _e2855 {
                                                phi_6759_ = _e2853;
                                                phi_6760_ = true;
                                                phi_6761_ = false;
                                                phi_6762_ = false;
                                            } else {
                                                phi_6759_ = _e2825;
                                                phi_6760_ = _e2857;
                                                phi_6761_ = _e2859;
                                                phi_6762_ = _e2861;
                                            }
                                            let _e2863 = phi_6759_;
                                            let _e2865 = phi_6760_;
                                            let _e2867 = phi_6761_;
                                            let _e2869 = phi_6762_;
                                            if _e2865 {
                                                phi_6766_ = false;
                                                phi_6767_ = false;
                                            } else {
                                                phi_6766_ = _e2867;
                                                phi_6767_ = _e2869;
                                            }
                                            let _e2871 = phi_6766_;
                                            let _e2873 = phi_6767_;
                                            if _e2871 {
                                                phi_6771_ = false;
                                                phi_6772_ = false;
                                            } else {
                                                phi_6771_ = _e2873;
                                                phi_6772_ = _e2865;
                                            }
                                            let _e2875 = phi_6771_;
                                            let _e2877 = phi_6772_;
                                            if _e2875 {
                                                phi_6776_ = true;
                                                phi_6777_ = false;
                                            } else {
                                                phi_6776_ = _e2871;
                                                phi_6777_ = _e2877;
                                            }
                                            let _e2879 = phi_6776_;
                                            let _e2881 = phi_6777_;
                                            if _e2879 {
                                                let _e2883 = local_30;
                                                phi_6782_ = type_32(1u, _e2883);
                                                phi_6783_ = true;
                                            } else {
                                                phi_6782_ = _e2863;
                                                phi_6783_ = _e2881;
                                            }
                                            let _e2886 = phi_6782_;
                                            let _e2888 = phi_6783_;
                                            if _e2888 {
                                                phi_6787_ = _e2886;
                                            } else {
                                                phi_6787_ = _e2808;
                                            }
                                            let _e2890 = phi_6787_;
                                            let _e2893 = (_e2890.member != 0u);
                                            if _e2893 {
                                                phi_6794_ = false;
                                            } else {
                                                phi_6794_ = true;
                                            }
                                            let _e2895 = phi_6794_;
                                            phi_6795_ = _e2890.member_1;
                                            phi_6796_ = _e2895;
                                            phi_6797_ = _e2893;
                                            phi_6798_ = false;
                                        } else {
                                            phi_6795_ = f32();
                                            phi_6796_ = false;
                                            phi_6797_ = false;
                                            phi_6798_ = true;
                                        }
                                        let _e2897 = phi_6795_;
                                        let _e2899 = phi_6796_;
                                        let _e2901 = phi_6797_;
                                        let _e2903 = phi_6798_;
                                        phi_6799_ = _e2897;
                                        phi_6800_ = _e2899;
                                        phi_6801_ = _e2901;
                                        phi_6802_ = _e2903;
                                    }
                                    let _e2905 = phi_6799_;
                                    let _e2907 = phi_6800_;
                                    let _e2909 = phi_6801_;
                                    let _e2911 = phi_6802_;
                                    phi_6803_ = _e2905;
                                    phi_6804_ = _e1882;
                                    phi_6805_ = _e2907;
                                    phi_6806_ = _e2909;
                                    phi_6807_ = _e2911;
                                }
                                let _e2913 = phi_6803_;
                                let _e2915 = phi_6804_;
                                let _e2917 = phi_6805_;
                                let _e2919 = phi_6806_;
                                let _e2921 = phi_6807_;
                                if _e2915 {
                                    phi_6811_ = true;
                                    phi_6812_ = false;
                                    phi_6813_ = false;
                                } else {
                                    phi_6811_ = _e2917;
                                    phi_6812_ = _e2919;
                                    phi_6813_ = _e2921;
                                }
                                let _e2923 = phi_6811_;
                                let _e2925 = phi_6812_;
                                let _e2927 = phi_6813_;
                                phi_6814_ = _e2913;
                                phi_6815_ = _e1179;
                                phi_6816_ = _e2923;
                                phi_6817_ = false;
                                phi_6818_ = _e2925;
                                phi_6819_ = _e2927;
                            } else {
                                phi_6814_ = f32();
                                phi_6815_ = type_33();
                                phi_6816_ = false;
                                phi_6817_ = true;
                                phi_6818_ = false;
                                phi_6819_ = false;
                            }
                            let _e2929 = phi_6814_;
                            let _e2931 = phi_6815_;
                            let _e2933 = phi_6816_;
                            let _e2935 = phi_6817_;
                            let _e2937 = phi_6818_;
                            let _e2939 = phi_6819_;
                            local_31 = _e2935;
                            local_67 = _e2937;
                            local_68 = _e2939;
                            local_32 = _e2929;
                            local_33 = _e2931;
                            continue;
                            continuing {
                                phi_3856_ = _e884;
                                break if !(_e2933);
                            }
                        }
                        let _e2942 = local_31;
                        if _e2942 {
                            phi_6824_ = type_32(0u, type_32().member_1);
                            phi_6825_ = false;
                            phi_6826_ = false;
                        } else {
                            phi_6824_ = type_32();
                            let _e5234 = local_67;
                            phi_6825_ = _e5234;
                            let _e5237 = local_68;
                            phi_6826_ = _e5237;
                        }
                        let _e2946 = phi_6824_;
                        let _e2948 = phi_6825_;
                        let _e2950 = phi_6826_;
                        if _e2948 {
                            let _e2952 = local_32;
                            phi_6831_ = type_32(2u, _e2952);
                            phi_6832_ = false;
                        } else {
                            phi_6831_ = type_32();
                            phi_6832_ = _e2950;
                        }
                        let _e2955 = phi_6831_;
                        let _e2957 = phi_6832_;
                        if _e2957 {
                            let _e2959 = local_33;
                            phi_6838_ = type_32(1u, _e2959.member);
                            phi_6839_ = true;
                        } else {
                            phi_6838_ = _e2955;
                            phi_6839_ = _e2948;
                        }
                        let _e2963 = phi_6838_;
                        let _e2965 = phi_6839_;
                        if _e2965 {
                            phi_6843_ = _e2963;
                        } else {
                            phi_6843_ = _e2946;
                        }
                        let _e2967 = phi_6843_;
                        phi_6847_ = _e2967;
                    }
                    let _e4583 = phi_6847_;
                    phi_6848_ = _e4583;
                }
                let _e4587 = phi_6848_;
                switch bitcast<i32>(_e4587.member) {
                    case 0: {
                        phi_6861_ = type_34(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4593 = function_(_e4587.member_1);
                        phi_6861_ = type_34(0u, _e4593, true);
                        break;
                    }
                    case 2: {
                        let _e4591 = function_(_e4587.member_1);
                        phi_6861_ = type_34(1u, _e4591, true);
                        break;
                    }
                    default: {
                        phi_6861_ = type_34();
                        break;
                    }
                }
                let _e4596 = phi_6861_;
                if _e4596.member_2 {
                    phi_6868_ = (_e4596.member == 0u);
                } else {
                    phi_6868_ = false;
                }
                let _e4601 = phi_6868_;
                if _e4601 {
                    let _e4609 = (_e4596.member_1[1] >> bitcast<u32>(20i));
                    if (_e4609 <= 896u) {
                        phi_6892_ = 0u;
                    } else {
                        phi_6892_ = ((((_e4609 - 896u) << bitcast<u32>(23i)) | ((_e4596.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4596.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4624 = phi_6892_;
                    let _e4626 = atomicMin((&earliest.member[0u]), _e4624);
                }
                phi_6896_ = type_28(_e166, 0u, _e172, _e175, _e4596.member_1);
                phi_6897_ = _e4601;
                phi_6898_ = (_e4596.member != 0u);
            } else {
                phi_6896_ = type_28(_e166, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_6897_ = false;
                phi_6898_ = false;
            }
            let _e4628 = phi_6896_;
            let _e4630 = phi_6897_;
            let _e4632 = phi_6898_;
            let _e4634 = params.member.member_1;
            if ((_e4634 & 16u) != 0u) {
                if (_e99 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4630 {
                    let _e4640 = atomicAdd((&counters[0u]), 1u);
                    phi_6916_ = _e4640;
                } else {
                    phi_6916_ = 0u;
                }
                let _e4642 = phi_6916_;
                workgroupBarrier();
                if (_e99 == 0u) {
                    let _e4645 = atomicLoad((&counters[0u]));
                    if (_e4645 > 0u) {
                        let _e4648 = atomicAdd((&contacts.member[0u]), _e4645);
                        atomicStore((&counters[1u]), _e4648);
                    }
                }
                workgroupBarrier();
                let _e4651 = atomicLoad((&counters[1u]));
                let _e4652 = (_e4651 + _e4642);
                if _e4630 {
                    let _e4654 = params.member.member_16;
                    if (_e4652 < _e4654) {
                        let _e4656 = (6u * _e4652);
                        atomicStore((&contacts.member[(4u + _e4656)]), _e4628.member);
                        atomicStore((&contacts.member[(_e4656 + 5u)]), _e4628.member_1);
                        atomicStore((&contacts.member[(_e4656 + 6u)]), _e4628.member_2);
                        atomicStore((&contacts.member[(_e4656 + 7u)]), _e4628.member_3);
                        atomicStore((&contacts.member[(_e4656 + 8u)]), _e4628.member_4[0]);
                        atomicStore((&contacts.member[(_e4656 + 9u)]), _e4628.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e99 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4632 {
                let _e4680 = atomicAdd((&counters[0u]), 1u);
                phi_6978_ = _e4680;
            } else {
                phi_6978_ = 0u;
            }
            let _e4682 = phi_6978_;
            workgroupBarrier();
            if (_e99 == 0u) {
                let _e4685 = atomicLoad((&counters[0u]));
                if (_e4685 > 0u) {
                    let _e4688 = atomicAdd((&undecided.member[0u]), _e4685);
                    atomicStore((&counters[1u]), _e4688);
                }
            }
            workgroupBarrier();
            let _e4691 = atomicLoad((&counters[1u]));
            let _e4692 = (_e4691 + _e4682);
            if _e4632 {
                atomicStore((&undecided.member[(4u + (2u * _e4692))]), _e4628.member_2);
                atomicStore((&undecided.member[((2u * _e4692) + 5u)]), _e4628.member_3);
            }
        }
        continue;
        continuing {
            phi_247_ = _e154;
            break if !(_e160);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}
