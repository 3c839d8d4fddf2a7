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

fn function_(param: f32) -> array<u32, 2> {
    var phi_7029_: array<u32, 2>;
    var phi_7030_: array<u32, 2>;
    var phi_7031_: bool;
    var phi_7035_: array<u32, 2>;

    let _e91 = bitcast<u32>(param);
    if (_e91 < 8388608u) {
        phi_7030_ = array<u32, 2>();
        phi_7031_ = true;
    } else {
        let _e95 = ((_e91 >> bitcast<u32>(31i)) == 1u);
        if _e95 {
            phi_7029_ = array<u32, 2>();
        } else {
            phi_7029_ = array<u32, 2>((_e91 << bitcast<u32>(29i)), ((((_e91 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e91 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e109 = phi_7029_;
        phi_7030_ = _e109;
        phi_7031_ = _e95;
    }
    let _e111 = phi_7030_;
    let _e113 = phi_7031_;
    if _e113 {
        phi_7035_ = array<u32, 2>(0u, 0u);
    } else {
        phi_7035_ = _e111;
    }
    let _e115 = phi_7035_;
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
    var phi_205_: u32;
    var phi_221_: u32;
    var phi_242_: u32;
    var phi_243_: u32;
    var phi_246_: type_28;
    var phi_247_: type_28;
    var phi_270_: type_28;
    var phi_720_: f32;
    var phi_727_: f32;
    var phi_732_: f32;
    var phi_739_: f32;
    var phi_744_: f32;
    var phi_757_: f32;
    var phi_764_: f32;
    var phi_769_: f32;
    var phi_776_: f32;
    var phi_781_: f32;
    var phi_786_: f32;
    var phi_803_: f32;
    var phi_810_: f32;
    var phi_815_: f32;
    var phi_822_: f32;
    var phi_827_: f32;
    var phi_841_: f32;
    var phi_848_: f32;
    var phi_853_: f32;
    var phi_860_: f32;
    var phi_865_: f32;
    var phi_870_: f32;
    var phi_887_: f32;
    var phi_894_: f32;
    var phi_899_: f32;
    var phi_906_: f32;
    var phi_911_: f32;
    var phi_925_: f32;
    var phi_932_: f32;
    var phi_937_: f32;
    var phi_944_: f32;
    var phi_949_: f32;
    var phi_954_: f32;
    var phi_985_: f32;
    var phi_991_: f32;
    var phi_998_: f32;
    var phi_1005_: f32;
    var phi_1011_: f32;
    var phi_1018_: f32;
    var phi_1024_: f32;
    var phi_1030_: f32;
    var phi_1036_: f32;
    var phi_1043_: f32;
    var phi_1050_: f32;
    var phi_1074_: f32;
    var phi_1079_: f32;
    var phi_1084_: f32;
    var phi_1089_: f32;
    var phi_1094_: f32;
    var phi_1099_: f32;
    var phi_1109_: f32;
    var phi_3582_: f32;
    var phi_3588_: f32;
    var phi_3593_: f32;
    var phi_3599_: f32;
    var phi_3605_: f32;
    var phi_3610_: f32;
    var phi_3615_: f32;
    var phi_3623_: bool;
    var phi_3628_: f32;
    var phi_3635_: f32;
    var phi_3675_: type_26;
    var phi_3678_: f32;
    var phi_3699_: bool;
    var phi_3705_: type_27;
    var phi_3676_: type_26;
    var phi_3719_: type_27;
    var phi_3679_: f32;
    var local_16: f32;
    var phi_3668_: f32;
    var phi_3732_: f32;
    var phi_3738_: f32;
    var phi_3763_: type_28;
    var phi_3766_: u32;
    var phi_3764_: type_28;
    var phi_3789_: type_28;
    var phi_3833_: u32;
    var phi_3834_: u32;
    var phi_3767_: u32;
    var phi_3835_: u32;
    var phi_3855_: type_28;
    var phi_3856_: type_28;
    var phi_3879_: type_28;
    var phi_3931_: f32;
    var phi_3938_: f32;
    var phi_3949_: bool;
    var phi_3950_: bool;
    var phi_3951_: bool;
    var phi_3952_: bool;
    var phi_3956_: bool;
    var phi_3967_: type_56;
    var phi_3968_: type_56;
    var phi_3969_: bool;
    var phi_3970_: type_56;
    var phi_3971_: bool;
    var phi_3982_: f32;
    var phi_3992_: type_28;
    var phi_3995_: f32;
    var phi_3997_: f32;
    var phi_3999_: f32;
    var phi_3993_: type_28;
    var phi_4022_: type_28;
    var phi_4047_: f32;
    var phi_4048_: f32;
    var phi_4074_: f32;
    var phi_4090_: f32;
    var phi_4097_: bool;
    var phi_4098_: bool;
    var phi_4099_: bool;
    var phi_4105_: f32;
    var phi_4106_: f32;
    var phi_4107_: bool;
    var phi_3996_: f32;
    var phi_3998_: f32;
    var phi_4000_: f32;
    var phi_4108_: f32;
    var phi_4109_: bool;
    var phi_4110_: bool;
    var local_17: bool;
    var phi_4114_: f32;
    var phi_4115_: f32;
    var phi_4122_: type_28;
    var phi_4125_: f32;
    var phi_4123_: type_28;
    var phi_4148_: type_28;
    var phi_4189_: f32;
    var phi_4199_: f32;
    var phi_4207_: bool;
    var phi_4209_: bool;
    var phi_4214_: f32;
    var phi_4215_: bool;
    var phi_4216_: f32;
    var phi_4217_: bool;
    var phi_4218_: bool;
    var phi_4219_: bool;
    var phi_4220_: f32;
    var phi_4126_: f32;
    var phi_4221_: bool;
    var phi_4222_: bool;
    var phi_4223_: bool;
    var phi_4224_: bool;
    var local_18: bool;
    var phi_4228_: bool;
    var phi_4229_: bool;
    var phi_4233_: bool;
    var phi_4237_: f32;
    var phi_4238_: f32;
    var phi_4240_: type_56;
    var phi_4269_: f32;
    var phi_4276_: f32;
    var phi_4281_: f32;
    var phi_4288_: f32;
    var phi_4293_: f32;
    var phi_4306_: f32;
    var phi_4313_: f32;
    var phi_4318_: f32;
    var phi_4325_: f32;
    var phi_4330_: f32;
    var phi_4335_: f32;
    var phi_4394_: f32;
    var phi_4400_: f32;
    var phi_4405_: f32;
    var phi_4411_: f32;
    var phi_4416_: f32;
    var phi_4428_: f32;
    var phi_4434_: f32;
    var phi_4439_: f32;
    var phi_4445_: f32;
    var phi_4450_: f32;
    var phi_4476_: f32;
    var phi_4483_: f32;
    var phi_4488_: f32;
    var phi_4495_: f32;
    var phi_4500_: f32;
    var phi_4513_: f32;
    var phi_4520_: f32;
    var phi_4525_: f32;
    var phi_4532_: f32;
    var phi_4537_: f32;
    var phi_4542_: f32;
    var phi_4601_: f32;
    var phi_4607_: f32;
    var phi_4612_: f32;
    var phi_4618_: f32;
    var phi_4623_: f32;
    var phi_4635_: f32;
    var phi_4641_: f32;
    var phi_4646_: f32;
    var phi_4652_: f32;
    var phi_4657_: f32;
    var phi_4683_: f32;
    var phi_4690_: f32;
    var phi_4695_: f32;
    var phi_4702_: f32;
    var phi_4707_: f32;
    var phi_4720_: f32;
    var phi_4727_: f32;
    var phi_4732_: f32;
    var phi_4739_: f32;
    var phi_4744_: f32;
    var phi_4749_: f32;
    var phi_4808_: f32;
    var phi_4814_: f32;
    var phi_4819_: f32;
    var phi_4825_: f32;
    var phi_4830_: f32;
    var phi_4842_: f32;
    var phi_4848_: f32;
    var phi_4853_: f32;
    var phi_4859_: f32;
    var phi_4864_: f32;
    var phi_4913_: f32;
    var phi_4919_: f32;
    var phi_4947_: f32;
    var phi_4953_: f32;
    var phi_4958_: u32;
    var phi_4959_: u32;
    var phi_4929_: f32;
    var phi_4935_: f32;
    var phi_4940_: u32;
    var phi_4941_: u32;
    var phi_4960_: u32;
    var phi_4961_: u32;
    var phi_5028_: f32;
    var phi_5037_: f32;
    var phi_5168_: f32;
    var phi_5174_: f32;
    var phi_5181_: f32;
    var phi_5224_: type_28;
    var phi_5227_: bool;
    var phi_5225_: type_28;
    var phi_5250_: type_28;
    var phi_5277_: bool;
    var phi_5278_: bool;
    var phi_5228_: bool;
    var phi_5279_: bool;
    var phi_5280_: bool;
    var local_19: bool;
    var phi_5284_: bool;
    var local_20: bool;
    var phi_5291_: u32;
    var phi_5292_: u32;
    var phi_5293_: bool;
    var phi_5294_: u32;
    var phi_5295_: u32;
    var phi_5296_: bool;
    var phi_5300_: u32;
    var phi_5320_: bool;
    var phi_5321_: bool;
    var phi_5322_: bool;
    var phi_5518_: f32;
    var phi_5525_: f32;
    var phi_5530_: f32;
    var phi_5537_: f32;
    var phi_5542_: f32;
    var phi_5555_: f32;
    var phi_5562_: f32;
    var phi_5567_: f32;
    var phi_5574_: f32;
    var phi_5579_: f32;
    var phi_5584_: f32;
    var phi_5601_: f32;
    var phi_5608_: f32;
    var phi_5613_: f32;
    var phi_5620_: f32;
    var phi_5625_: f32;
    var phi_5639_: f32;
    var phi_5646_: f32;
    var phi_5651_: f32;
    var phi_5658_: f32;
    var phi_5663_: f32;
    var phi_5668_: f32;
    var phi_5685_: f32;
    var phi_5692_: f32;
    var phi_5697_: f32;
    var phi_5704_: f32;
    var phi_5709_: f32;
    var phi_5723_: f32;
    var phi_5730_: f32;
    var phi_5735_: f32;
    var phi_5742_: f32;
    var phi_5747_: f32;
    var phi_5752_: f32;
    var phi_5768_: type_28;
    var phi_5771_: f32;
    var phi_5769_: type_28;
    var phi_5794_: type_28;
    var phi_5948_: bool;
    var phi_5949_: bool;
    var phi_5950_: bool;
    var phi_5951_: bool;
    var phi_5952_: bool;
    var phi_5953_: bool;
    var phi_5957_: bool;
    var phi_5997_: array<f32, 3>;
    var phi_5998_: bool;
    var phi_5999_: array<f32, 3>;
    var phi_6000_: bool;
    var phi_6030_: f32;
    var phi_6031_: f32;
    var phi_6058_: f32;
    var phi_6059_: f32;
    var phi_6086_: f32;
    var phi_6087_: f32;
    var phi_6117_: f32;
    var phi_6118_: f32;
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
    var phi_6615_: f32;
    var phi_6616_: f32;
    var phi_6617_: f32;
    var phi_6618_: bool;
    var phi_6622_: bool;
    var phi_6623_: f32;
    var phi_6624_: bool;
    var phi_6625_: bool;
    var phi_6626_: bool;
    var phi_6627_: f32;
    var phi_6628_: bool;
    var phi_6629_: bool;
    var phi_6630_: bool;
    var phi_6491_: f32;
    var phi_6631_: bool;
    var phi_6632_: bool;
    var phi_6633_: bool;
    var phi_6634_: bool;
    var local_22: bool;
    var local_23: f32;
    var local_24: f32;
    var local_25: f32;
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
    var phi_6662_: bool;
    var phi_6663_: bool;
    var phi_6664_: f32;
    var phi_6665_: f32;
    var phi_6666_: bool;
    var phi_6667_: bool;
    var phi_6668_: bool;
    var phi_6669_: bool;
    var phi_6670_: bool;
    var phi_6671_: bool;
    var phi_6672_: bool;
    var phi_6673_: f32;
    var phi_6674_: f32;
    var phi_6675_: bool;
    var phi_6676_: bool;
    var phi_6677_: bool;
    var phi_6678_: bool;
    var phi_6679_: bool;
    var phi_6680_: bool;
    var phi_6681_: bool;
    var phi_6682_: bool;
    var phi_6683_: f32;
    var phi_5772_: f32;
    var phi_6684_: bool;
    var phi_6685_: bool;
    var phi_6686_: bool;
    var phi_6687_: bool;
    var phi_6688_: bool;
    var phi_6689_: bool;
    var phi_6690_: bool;
    var phi_6691_: bool;
    var phi_6692_: bool;
    var local_26: bool;
    var phi_6697_: type_55;
    var phi_6698_: bool;
    var phi_6699_: bool;
    var phi_6700_: bool;
    var phi_6701_: bool;
    var phi_6702_: bool;
    var phi_6703_: bool;
    var phi_6704_: bool;
    var phi_6708_: f32;
    var phi_6709_: bool;
    var phi_6710_: bool;
    var phi_6711_: bool;
    var phi_6712_: bool;
    var phi_6713_: bool;
    var phi_6714_: bool;
    var phi_6715_: bool;
    var phi_6720_: type_55;
    var phi_6721_: bool;
    var phi_6722_: bool;
    var phi_6723_: bool;
    var phi_6724_: bool;
    var phi_6725_: bool;
    var phi_6726_: bool;
    var local_27: f32;
    var phi_6731_: type_55;
    var phi_6732_: bool;
    var phi_6733_: bool;
    var phi_6734_: bool;
    var phi_6735_: bool;
    var phi_6736_: bool;
    var local_28: f32;
    var phi_6741_: type_55;
    var phi_6742_: bool;
    var phi_6743_: bool;
    var phi_6744_: bool;
    var phi_6745_: bool;
    var local_29: f32;
    var phi_6750_: type_55;
    var phi_6751_: bool;
    var phi_6752_: bool;
    var phi_6753_: bool;
    var phi_6754_: bool;
    var phi_6758_: type_55;
    var phi_6759_: bool;
    var phi_6760_: bool;
    var phi_6761_: bool;
    var phi_6765_: bool;
    var phi_6766_: bool;
    var phi_6770_: bool;
    var phi_6771_: bool;
    var phi_6775_: bool;
    var phi_6776_: bool;
    var local_30: f32;
    var phi_6781_: type_55;
    var phi_6782_: bool;
    var phi_6786_: type_55;
    var phi_6793_: bool;
    var phi_6794_: f32;
    var phi_6795_: bool;
    var phi_6796_: bool;
    var phi_6797_: bool;
    var phi_6798_: f32;
    var phi_6799_: bool;
    var phi_6800_: bool;
    var phi_6801_: bool;
    var phi_6802_: f32;
    var phi_6803_: bool;
    var phi_6804_: bool;
    var phi_6805_: bool;
    var phi_6806_: bool;
    var phi_6810_: bool;
    var phi_6811_: bool;
    var phi_6812_: bool;
    var phi_6813_: f32;
    var phi_6814_: type_56;
    var phi_6815_: bool;
    var phi_6816_: bool;
    var phi_6817_: bool;
    var phi_6818_: bool;
    var local_31: bool;
    var phi_6823_: type_55;
    var phi_6824_: bool;
    var phi_6825_: bool;
    var local_32: f32;
    var phi_6830_: type_55;
    var phi_6831_: bool;
    var local_33: type_56;
    var phi_6837_: type_55;
    var phi_6838_: bool;
    var phi_6842_: type_55;
    var phi_1310_: f32;
    var phi_1317_: f32;
    var phi_1322_: f32;
    var phi_1329_: f32;
    var phi_1334_: f32;
    var phi_1347_: f32;
    var phi_1354_: f32;
    var phi_1359_: f32;
    var phi_1366_: f32;
    var phi_1371_: f32;
    var phi_1376_: f32;
    var phi_1393_: f32;
    var phi_1400_: f32;
    var phi_1405_: f32;
    var phi_1412_: f32;
    var phi_1417_: f32;
    var phi_1431_: f32;
    var phi_1438_: f32;
    var phi_1443_: f32;
    var phi_1450_: f32;
    var phi_1455_: f32;
    var phi_1460_: f32;
    var phi_1477_: f32;
    var phi_1484_: f32;
    var phi_1489_: f32;
    var phi_1496_: f32;
    var phi_1501_: f32;
    var phi_1515_: f32;
    var phi_1522_: f32;
    var phi_1527_: f32;
    var phi_1534_: f32;
    var phi_1539_: f32;
    var phi_1544_: f32;
    var phi_1560_: type_28;
    var phi_1563_: f32;
    var phi_1561_: type_28;
    var phi_1586_: type_28;
    var phi_1740_: bool;
    var phi_1741_: bool;
    var phi_1742_: bool;
    var phi_1743_: bool;
    var phi_1744_: bool;
    var phi_1745_: bool;
    var phi_1749_: bool;
    var phi_1789_: array<f32, 3>;
    var phi_1790_: bool;
    var phi_1791_: array<f32, 3>;
    var phi_1792_: bool;
    var phi_1822_: f32;
    var phi_1823_: f32;
    var phi_1850_: f32;
    var phi_1851_: f32;
    var phi_1878_: f32;
    var phi_1879_: f32;
    var phi_1909_: f32;
    var phi_1910_: f32;
    var phi_2053_: type_28;
    var phi_2056_: array<f32, 3>;
    var phi_2054_: type_28;
    var phi_2079_: type_28;
    var phi_2146_: array<f32, 3>;
    var phi_2057_: array<f32, 3>;
    var phi_2147_: array<f32, 3>;
    var phi_2154_: f32;
    var phi_2161_: f32;
    var phi_2169_: f32;
    var phi_2213_: type_26;
    var phi_2216_: f32;
    var phi_2237_: bool;
    var phi_2243_: type_27;
    var phi_2214_: type_26;
    var phi_2257_: type_27;
    var phi_2217_: f32;
    var local_34: f32;
    var phi_2206_: f32;
    var phi_2270_: f32;
    var phi_2279_: type_28;
    var phi_2282_: f32;
    var phi_2280_: type_28;
    var phi_2305_: type_28;
    var phi_2356_: f32;
    var phi_2362_: f32;
    var phi_2375_: bool;
    var phi_2376_: bool;
    var phi_2407_: f32;
    var phi_2408_: f32;
    var phi_2409_: f32;
    var phi_2410_: bool;
    var phi_2414_: bool;
    var phi_2415_: f32;
    var phi_2416_: bool;
    var phi_2417_: bool;
    var phi_2418_: bool;
    var phi_2419_: f32;
    var phi_2420_: bool;
    var phi_2421_: bool;
    var phi_2422_: bool;
    var phi_2283_: f32;
    var phi_2423_: bool;
    var phi_2424_: bool;
    var phi_2425_: bool;
    var phi_2426_: bool;
    var local_35: bool;
    var local_36: f32;
    var local_37: f32;
    var local_38: f32;
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
    var phi_2454_: bool;
    var phi_2455_: bool;
    var phi_2456_: f32;
    var phi_2457_: f32;
    var phi_2458_: bool;
    var phi_2459_: bool;
    var phi_2460_: bool;
    var phi_2461_: bool;
    var phi_2462_: bool;
    var phi_2463_: bool;
    var phi_2464_: bool;
    var phi_2465_: f32;
    var phi_2466_: f32;
    var phi_2467_: bool;
    var phi_2468_: bool;
    var phi_2469_: bool;
    var phi_2470_: bool;
    var phi_2471_: bool;
    var phi_2472_: bool;
    var phi_2473_: bool;
    var phi_2474_: bool;
    var phi_2475_: f32;
    var phi_1564_: f32;
    var phi_2476_: bool;
    var phi_2477_: bool;
    var phi_2478_: bool;
    var phi_2479_: bool;
    var phi_2480_: bool;
    var phi_2481_: bool;
    var phi_2482_: bool;
    var phi_2483_: bool;
    var phi_2484_: bool;
    var local_39: bool;
    var phi_2489_: type_55;
    var phi_2490_: bool;
    var phi_2491_: bool;
    var phi_2492_: bool;
    var phi_2493_: bool;
    var phi_2494_: bool;
    var phi_2495_: bool;
    var phi_2496_: bool;
    var phi_2500_: f32;
    var phi_2501_: bool;
    var phi_2502_: bool;
    var phi_2503_: bool;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2506_: bool;
    var phi_2507_: bool;
    var phi_2512_: type_55;
    var phi_2513_: bool;
    var phi_2514_: bool;
    var phi_2515_: bool;
    var phi_2516_: bool;
    var phi_2517_: bool;
    var phi_2518_: bool;
    var local_40: f32;
    var phi_2523_: type_55;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var phi_2527_: bool;
    var phi_2528_: bool;
    var local_41: f32;
    var phi_2533_: type_55;
    var phi_2534_: bool;
    var phi_2535_: bool;
    var phi_2536_: bool;
    var phi_2537_: bool;
    var local_42: f32;
    var phi_2542_: type_55;
    var phi_2543_: bool;
    var phi_2544_: bool;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2550_: type_55;
    var phi_2551_: bool;
    var phi_2552_: bool;
    var phi_2553_: bool;
    var phi_2557_: bool;
    var phi_2558_: bool;
    var phi_2562_: bool;
    var phi_2563_: bool;
    var phi_2567_: bool;
    var phi_2568_: bool;
    var local_43: f32;
    var phi_2573_: type_55;
    var phi_2574_: bool;
    var phi_2578_: type_55;
    var phi_2592_: type_28;
    var phi_2593_: type_28;
    var phi_2616_: type_28;
    var phi_2636_: f32;
    var phi_2784_: bool;
    var phi_2785_: bool;
    var phi_2786_: bool;
    var phi_2787_: bool;
    var phi_2788_: bool;
    var phi_2789_: bool;
    var phi_2793_: bool;
    var phi_2833_: array<f32, 3>;
    var phi_2834_: bool;
    var phi_2835_: array<f32, 3>;
    var phi_2836_: bool;
    var phi_2866_: f32;
    var phi_2867_: f32;
    var phi_2894_: f32;
    var phi_2895_: f32;
    var phi_2922_: f32;
    var phi_2923_: f32;
    var phi_2953_: f32;
    var phi_2954_: f32;
    var phi_3097_: type_28;
    var phi_3100_: array<f32, 3>;
    var phi_3098_: type_28;
    var phi_3123_: type_28;
    var phi_3190_: array<f32, 3>;
    var phi_3101_: array<f32, 3>;
    var phi_3191_: array<f32, 3>;
    var phi_3223_: type_26;
    var phi_3226_: f32;
    var phi_3247_: bool;
    var phi_3253_: type_27;
    var phi_3224_: type_26;
    var phi_3267_: type_27;
    var phi_3227_: f32;
    var local_44: f32;
    var phi_3216_: f32;
    var phi_3280_: f32;
    var phi_3296_: f32;
    var phi_3303_: f32;
    var phi_3308_: f32;
    var phi_3315_: f32;
    var phi_3320_: f32;
    var phi_3333_: f32;
    var phi_3340_: f32;
    var phi_3345_: f32;
    var phi_3352_: f32;
    var phi_3357_: f32;
    var phi_3362_: f32;
    var phi_3379_: f32;
    var phi_3386_: f32;
    var phi_3391_: f32;
    var phi_3398_: f32;
    var phi_3403_: f32;
    var phi_3417_: f32;
    var phi_3424_: f32;
    var phi_3429_: f32;
    var phi_3436_: f32;
    var phi_3441_: f32;
    var phi_3446_: f32;
    var phi_3463_: f32;
    var phi_3470_: f32;
    var phi_3475_: f32;
    var phi_3482_: f32;
    var phi_3487_: f32;
    var phi_3501_: f32;
    var phi_3508_: f32;
    var phi_3513_: f32;
    var phi_3520_: f32;
    var phi_3525_: f32;
    var phi_3530_: f32;
    var phi_3550_: bool;
    var phi_3551_: bool;
    var phi_3552_: bool;
    var local_45: bool;
    var phi_3557_: type_55;
    var phi_3558_: bool;
    var phi_3563_: type_55;
    var phi_3564_: bool;
    var phi_3566_: type_55;
    var phi_3567_: type_55;
    var phi_3568_: bool;
    var phi_3572_: type_55;
    var phi_6846_: type_55;
    var phi_6847_: type_55;
    var phi_6860_: type_58;
    var phi_6867_: bool;
    var phi_6891_: u32;
    var phi_6895_: type_48;
    var phi_6896_: bool;
    var phi_6897_: bool;
    var phi_6915_: u32;
    var phi_6977_: u32;
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
        phi_205_ = _e125;
    } else {
        phi_205_ = _e127;
    }
    let _e130 = phi_205_;
    let _e131 = (_e130 / 64u);
    if ((_e130 % 64u) > 0u) {
        phi_221_ = (_e131 + 1u);
    } else {
        phi_221_ = _e131;
    }
    let _e136 = phi_221_;
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
            phi_242_ = (_e140 + 1u);
        } else {
            phi_242_ = _e140;
        }
        let _e146 = phi_242_;
        phi_243_ = _e146;
    } else {
        phi_243_ = 0u;
    }
    let _e148 = phi_243_;
    phi_246_ = type_28(0u, _e148);
    loop {
        let _e151 = phi_246_;
        if (_e151.member < _e151.member_1) {
            phi_247_ = type_28((_e151.member + 1u), _e151.member_1);
            phi_270_ = type_28(1u, _e151.member);
        } else {
            phi_247_ = _e151;
            phi_270_ = type_28(0u, type_28().member_1);
        }
        let _e165 = phi_247_;
        let _e167 = phi_270_;
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
                    phi_720_ = -(_e425[0]);
                } else {
                    phi_720_ = _e425[0];
                }
                let _e432 = phi_720_;
                if (_e425[1] < 0f) {
                    phi_727_ = -(_e425[1]);
                } else {
                    phi_727_ = _e425[1];
                }
                let _e436 = phi_727_;
                if (_e432 > _e436) {
                    phi_732_ = _e432;
                } else {
                    phi_732_ = _e436;
                }
                let _e439 = phi_732_;
                if (_e425[2] < 0f) {
                    phi_739_ = -(_e425[2]);
                } else {
                    phi_739_ = _e425[2];
                }
                let _e443 = phi_739_;
                if (_e439 > _e443) {
                    phi_744_ = _e439;
                } else {
                    phi_744_ = _e443;
                }
                let _e446 = phi_744_;
                let _e449 = local_15.member[1u];
                if (_e449[0] < 0f) {
                    phi_757_ = -(_e449[0]);
                } else {
                    phi_757_ = _e449[0];
                }
                let _e456 = phi_757_;
                if (_e449[1] < 0f) {
                    phi_764_ = -(_e449[1]);
                } else {
                    phi_764_ = _e449[1];
                }
                let _e460 = phi_764_;
                if (_e456 > _e460) {
                    phi_769_ = _e456;
                } else {
                    phi_769_ = _e460;
                }
                let _e463 = phi_769_;
                if (_e449[2] < 0f) {
                    phi_776_ = -(_e449[2]);
                } else {
                    phi_776_ = _e449[2];
                }
                let _e467 = phi_776_;
                if (_e463 > _e467) {
                    phi_781_ = _e463;
                } else {
                    phi_781_ = _e467;
                }
                let _e470 = phi_781_;
                if (_e446 > _e470) {
                    phi_786_ = _e446;
                } else {
                    phi_786_ = _e470;
                }
                let _e473 = phi_786_;
                let _e475 = local_15.member_3;
                let _e476 = (_e473 + _e475);
                let _e479 = local_15.member_1[0u];
                if (_e479[0] < 0f) {
                    phi_803_ = -(_e479[0]);
                } else {
                    phi_803_ = _e479[0];
                }
                let _e486 = phi_803_;
                if (_e479[1] < 0f) {
                    phi_810_ = -(_e479[1]);
                } else {
                    phi_810_ = _e479[1];
                }
                let _e490 = phi_810_;
                if (_e486 > _e490) {
                    phi_815_ = _e486;
                } else {
                    phi_815_ = _e490;
                }
                let _e493 = phi_815_;
                if (_e479[2] < 0f) {
                    phi_822_ = -(_e479[2]);
                } else {
                    phi_822_ = _e479[2];
                }
                let _e497 = phi_822_;
                if (_e493 > _e497) {
                    phi_827_ = _e493;
                } else {
                    phi_827_ = _e497;
                }
                let _e500 = phi_827_;
                let _e503 = local_15.member_1[1u];
                if (_e503[0] < 0f) {
                    phi_841_ = -(_e503[0]);
                } else {
                    phi_841_ = _e503[0];
                }
                let _e510 = phi_841_;
                if (_e503[1] < 0f) {
                    phi_848_ = -(_e503[1]);
                } else {
                    phi_848_ = _e503[1];
                }
                let _e514 = phi_848_;
                if (_e510 > _e514) {
                    phi_853_ = _e510;
                } else {
                    phi_853_ = _e514;
                }
                let _e517 = phi_853_;
                if (_e503[2] < 0f) {
                    phi_860_ = -(_e503[2]);
                } else {
                    phi_860_ = _e503[2];
                }
                let _e521 = phi_860_;
                if (_e517 > _e521) {
                    phi_865_ = _e517;
                } else {
                    phi_865_ = _e521;
                }
                let _e524 = phi_865_;
                if (_e500 > _e524) {
                    phi_870_ = _e500;
                } else {
                    phi_870_ = _e524;
                }
                let _e527 = phi_870_;
                let _e529 = local_15.member_3;
                let _e530 = (_e527 + _e529);
                let _e533 = local_15.member_2[0u];
                if (_e533[0] < 0f) {
                    phi_887_ = -(_e533[0]);
                } else {
                    phi_887_ = _e533[0];
                }
                let _e540 = phi_887_;
                if (_e533[1] < 0f) {
                    phi_894_ = -(_e533[1]);
                } else {
                    phi_894_ = _e533[1];
                }
                let _e544 = phi_894_;
                if (_e540 > _e544) {
                    phi_899_ = _e540;
                } else {
                    phi_899_ = _e544;
                }
                let _e547 = phi_899_;
                if (_e533[2] < 0f) {
                    phi_906_ = -(_e533[2]);
                } else {
                    phi_906_ = _e533[2];
                }
                let _e551 = phi_906_;
                if (_e547 > _e551) {
                    phi_911_ = _e547;
                } else {
                    phi_911_ = _e551;
                }
                let _e554 = phi_911_;
                let _e557 = local_15.member_2[1u];
                if (_e557[0] < 0f) {
                    phi_925_ = -(_e557[0]);
                } else {
                    phi_925_ = _e557[0];
                }
                let _e564 = phi_925_;
                if (_e557[1] < 0f) {
                    phi_932_ = -(_e557[1]);
                } else {
                    phi_932_ = _e557[1];
                }
                let _e568 = phi_932_;
                if (_e564 > _e568) {
                    phi_937_ = _e564;
                } else {
                    phi_937_ = _e568;
                }
                let _e571 = phi_937_;
                if (_e557[2] < 0f) {
                    phi_944_ = -(_e557[2]);
                } else {
                    phi_944_ = _e557[2];
                }
                let _e575 = phi_944_;
                if (_e571 > _e575) {
                    phi_949_ = _e571;
                } else {
                    phi_949_ = _e575;
                }
                let _e578 = phi_949_;
                if (_e554 > _e578) {
                    phi_954_ = _e554;
                } else {
                    phi_954_ = _e578;
                }
                let _e581 = phi_954_;
                let _e583 = local_15.member_3;
                let _e584 = (_e581 + _e583);
                let _e586 = ((_e530 * 8f) * _e584);
                let _e593 = local_15.member_3;
                if (_e282 < 0f) {
                    phi_985_ = -(_e282);
                } else {
                    phi_985_ = _e282;
                }
                let _e610 = phi_985_;
                if (_e285 < 0f) {
                    phi_991_ = -(_e285);
                } else {
                    phi_991_ = _e285;
                }
                let _e614 = phi_991_;
                if (_e288 < 0f) {
                    phi_998_ = -(_e288);
                } else {
                    phi_998_ = _e288;
                }
                let _e619 = phi_998_;
                let _e620 = ((_e610 + _e614) + _e619);
                if (_e303 < 0f) {
                    phi_1005_ = -(_e303);
                } else {
                    phi_1005_ = _e303;
                }
                let _e624 = phi_1005_;
                if (_e306 < 0f) {
                    phi_1011_ = -(_e306);
                } else {
                    phi_1011_ = _e306;
                }
                let _e628 = phi_1011_;
                if (_e309 < 0f) {
                    phi_1018_ = -(_e309);
                } else {
                    phi_1018_ = _e309;
                }
                let _e633 = phi_1018_;
                let _e634 = ((_e624 + _e628) + _e633);
                if (_e620 > _e634) {
                    phi_1024_ = _e620;
                } else {
                    phi_1024_ = _e634;
                }
                let _e637 = phi_1024_;
                if (_e352 < 0f) {
                    phi_1030_ = -(_e352);
                } else {
                    phi_1030_ = _e352;
                }
                let _e641 = phi_1030_;
                if (_e353 < 0f) {
                    phi_1036_ = -(_e353);
                } else {
                    phi_1036_ = _e353;
                }
                let _e645 = phi_1036_;
                if (_e354 < 0f) {
                    phi_1043_ = -(_e354);
                } else {
                    phi_1043_ = _e354;
                }
                let _e650 = phi_1043_;
                let _e652 = (((_e641 + _e645) + _e650) * 0.5f);
                if (_e637 > _e652) {
                    phi_1050_ = _e637;
                } else {
                    phi_1050_ = _e652;
                }
                let _e655 = phi_1050_;
                let _e660 = local_15.member_3;
                let _e672 = (((((_e476 * 8f) * _e586) * (0.000000059604645f * (490f / 64f))) + ((_e593 * 19f) * ((_e476 * (_e530 + _e584)) + (_e530 * _e584)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e476) * ((1f + _e530) * (1f + _e584)))));
                let _e673 = (_e365 * 3f);
                let _e674 = (_e422 * 3f);
                if (_e673 < _e674) {
                    phi_1074_ = _e673;
                } else {
                    phi_1074_ = _e674;
                }
                let _e677 = phi_1074_;
                if (_e388 < _e411) {
                    phi_1079_ = _e388;
                } else {
                    phi_1079_ = _e411;
                }
                let _e680 = phi_1079_;
                if (_e677 < _e680) {
                    phi_1084_ = _e677;
                } else {
                    phi_1084_ = _e680;
                }
                let _e683 = phi_1084_;
                if (_e673 > _e674) {
                    phi_1089_ = _e673;
                } else {
                    phi_1089_ = _e674;
                }
                let _e686 = phi_1089_;
                if (_e388 > _e411) {
                    phi_1094_ = _e388;
                } else {
                    phi_1094_ = _e411;
                }
                let _e689 = phi_1094_;
                if (_e686 > _e689) {
                    phi_1099_ = _e686;
                } else {
                    phi_1099_ = _e689;
                }
                let _e692 = phi_1099_;
                let _e697 = -(_e692);
                if (_e683 > _e697) {
                    phi_1109_ = _e683;
                } else {
                    phi_1109_ = _e697;
                }
                let _e700 = phi_1109_;
                if ((_e700 - (_e672 + ((_e267 * (((_e655 + (_e586 * (0.000000059604645f * 4f))) + ((_e660 * 6f) * (_e530 + _e584))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e530) * (1f + _e584))))) * (3f * 1.0001f)))) > 0f) {
                    phi_6847_ = type_55(0u, type_55().member_1);
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
                            phi_1310_ = -(_e3098[0]);
                        } else {
                            phi_1310_ = _e3098[0];
                        }
                        let _e3105 = phi_1310_;
                        if (_e3098[1] < 0f) {
                            phi_1317_ = -(_e3098[1]);
                        } else {
                            phi_1317_ = _e3098[1];
                        }
                        let _e3109 = phi_1317_;
                        if (_e3105 > _e3109) {
                            phi_1322_ = _e3105;
                        } else {
                            phi_1322_ = _e3109;
                        }
                        let _e3112 = phi_1322_;
                        if (_e3098[2] < 0f) {
                            phi_1329_ = -(_e3098[2]);
                        } else {
                            phi_1329_ = _e3098[2];
                        }
                        let _e3116 = phi_1329_;
                        if (_e3112 > _e3116) {
                            phi_1334_ = _e3112;
                        } else {
                            phi_1334_ = _e3116;
                        }
                        let _e3119 = phi_1334_;
                        let _e3122 = local_15.member[1u];
                        if (_e3122[0] < 0f) {
                            phi_1347_ = -(_e3122[0]);
                        } else {
                            phi_1347_ = _e3122[0];
                        }
                        let _e3129 = phi_1347_;
                        if (_e3122[1] < 0f) {
                            phi_1354_ = -(_e3122[1]);
                        } else {
                            phi_1354_ = _e3122[1];
                        }
                        let _e3133 = phi_1354_;
                        if (_e3129 > _e3133) {
                            phi_1359_ = _e3129;
                        } else {
                            phi_1359_ = _e3133;
                        }
                        let _e3136 = phi_1359_;
                        if (_e3122[2] < 0f) {
                            phi_1366_ = -(_e3122[2]);
                        } else {
                            phi_1366_ = _e3122[2];
                        }
                        let _e3140 = phi_1366_;
                        if (_e3136 > _e3140) {
                            phi_1371_ = _e3136;
                        } else {
                            phi_1371_ = _e3140;
                        }
                        let _e3143 = phi_1371_;
                        if (_e3119 > _e3143) {
                            phi_1376_ = _e3119;
                        } else {
                            phi_1376_ = _e3143;
                        }
                        let _e3146 = phi_1376_;
                        let _e3148 = local_15.member_3;
                        let _e3152 = local_15.member_1[0u];
                        if (_e3152[0] < 0f) {
                            phi_1393_ = -(_e3152[0]);
                        } else {
                            phi_1393_ = _e3152[0];
                        }
                        let _e3159 = phi_1393_;
                        if (_e3152[1] < 0f) {
                            phi_1400_ = -(_e3152[1]);
                        } else {
                            phi_1400_ = _e3152[1];
                        }
                        let _e3163 = phi_1400_;
                        if (_e3159 > _e3163) {
                            phi_1405_ = _e3159;
                        } else {
                            phi_1405_ = _e3163;
                        }
                        let _e3166 = phi_1405_;
                        if (_e3152[2] < 0f) {
                            phi_1412_ = -(_e3152[2]);
                        } else {
                            phi_1412_ = _e3152[2];
                        }
                        let _e3170 = phi_1412_;
                        if (_e3166 > _e3170) {
                            phi_1417_ = _e3166;
                        } else {
                            phi_1417_ = _e3170;
                        }
                        let _e3173 = phi_1417_;
                        let _e3176 = local_15.member_1[1u];
                        if (_e3176[0] < 0f) {
                            phi_1431_ = -(_e3176[0]);
                        } else {
                            phi_1431_ = _e3176[0];
                        }
                        let _e3183 = phi_1431_;
                        if (_e3176[1] < 0f) {
                            phi_1438_ = -(_e3176[1]);
                        } else {
                            phi_1438_ = _e3176[1];
                        }
                        let _e3187 = phi_1438_;
                        if (_e3183 > _e3187) {
                            phi_1443_ = _e3183;
                        } else {
                            phi_1443_ = _e3187;
                        }
                        let _e3190 = phi_1443_;
                        if (_e3176[2] < 0f) {
                            phi_1450_ = -(_e3176[2]);
                        } else {
                            phi_1450_ = _e3176[2];
                        }
                        let _e3194 = phi_1450_;
                        if (_e3190 > _e3194) {
                            phi_1455_ = _e3190;
                        } else {
                            phi_1455_ = _e3194;
                        }
                        let _e3197 = phi_1455_;
                        if (_e3173 > _e3197) {
                            phi_1460_ = _e3173;
                        } else {
                            phi_1460_ = _e3197;
                        }
                        let _e3200 = phi_1460_;
                        let _e3202 = local_15.member_3;
                        let _e3206 = local_15.member_2[0u];
                        if (_e3206[0] < 0f) {
                            phi_1477_ = -(_e3206[0]);
                        } else {
                            phi_1477_ = _e3206[0];
                        }
                        let _e3213 = phi_1477_;
                        if (_e3206[1] < 0f) {
                            phi_1484_ = -(_e3206[1]);
                        } else {
                            phi_1484_ = _e3206[1];
                        }
                        let _e3217 = phi_1484_;
                        if (_e3213 > _e3217) {
                            phi_1489_ = _e3213;
                        } else {
                            phi_1489_ = _e3217;
                        }
                        let _e3220 = phi_1489_;
                        if (_e3206[2] < 0f) {
                            phi_1496_ = -(_e3206[2]);
                        } else {
                            phi_1496_ = _e3206[2];
                        }
                        let _e3224 = phi_1496_;
                        if (_e3220 > _e3224) {
                            phi_1501_ = _e3220;
                        } else {
                            phi_1501_ = _e3224;
                        }
                        let _e3227 = phi_1501_;
                        let _e3230 = local_15.member_2[1u];
                        if (_e3230[0] < 0f) {
                            phi_1515_ = -(_e3230[0]);
                        } else {
                            phi_1515_ = _e3230[0];
                        }
                        let _e3237 = phi_1515_;
                        if (_e3230[1] < 0f) {
                            phi_1522_ = -(_e3230[1]);
                        } else {
                            phi_1522_ = _e3230[1];
                        }
                        let _e3241 = phi_1522_;
                        if (_e3237 > _e3241) {
                            phi_1527_ = _e3237;
                        } else {
                            phi_1527_ = _e3241;
                        }
                        let _e3244 = phi_1527_;
                        if (_e3230[2] < 0f) {
                            phi_1534_ = -(_e3230[2]);
                        } else {
                            phi_1534_ = _e3230[2];
                        }
                        let _e3248 = phi_1534_;
                        if (_e3244 > _e3248) {
                            phi_1539_ = _e3244;
                        } else {
                            phi_1539_ = _e3248;
                        }
                        let _e3251 = phi_1539_;
                        if (_e3227 > _e3251) {
                            phi_1544_ = _e3227;
                        } else {
                            phi_1544_ = _e3251;
                        }
                        let _e3254 = phi_1544_;
                        let _e3256 = local_15.member_3;
                        let _e3263 = local_15.member_3;
                        phi_1560_ = type_28(0u, 48u);
                        phi_1563_ = 0f;
                        loop {
                            let _e3269 = phi_1560_;
                            let _e3271 = phi_1563_;
                            local_82 = _e3271;
                            local_40 = _e3271;
                            local_41 = _e3271;
                            local_42 = _e3271;
                            local_43 = _e3271;
                            if (_e3269.member < _e3269.member_1) {
                                phi_1561_ = type_28((_e3269.member + 1u), _e3269.member_1);
                                phi_1586_ = type_28(1u, _e3269.member);
                            } else {
                                phi_1561_ = _e3269;
                                phi_1586_ = type_28(0u, type_28().member_1);
                            }
                            let _e3285 = phi_1561_;
                            let _e3287 = phi_1586_;
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
                                            phi_1740_ = (_e3389 <= 1f);
                                            phi_1741_ = false;
                                        } else {
                                            phi_1740_ = bool();
                                            phi_1741_ = true;
                                        }
                                        let _e3395 = phi_1740_;
                                        let _e3397 = phi_1741_;
                                        phi_1742_ = _e3395;
                                        phi_1743_ = _e3397;
                                    } else {
                                        phi_1742_ = bool();
                                        phi_1743_ = true;
                                    }
                                    let _e3399 = phi_1742_;
                                    let _e3401 = phi_1743_;
                                    phi_1744_ = _e3399;
                                    phi_1745_ = _e3401;
                                } else {
                                    phi_1744_ = bool();
                                    phi_1745_ = true;
                                }
                                let _e3403 = phi_1744_;
                                let _e3405 = phi_1745_;
                                if _e3405 {
                                    phi_1749_ = false;
                                } else {
                                    phi_1749_ = _e3403;
                                }
                                let _e3407 = phi_1749_;
                                if (_e3381 > 0f) {
                                    if _e3407 {
                                        phi_1789_ = array<f32, 3>((_e3309 - ((_e3330 * _e3385) + (_e3351 * _e3389))), (_e3310 - ((_e3331 * _e3385) + (_e3352 * _e3389))), (_e3311 - ((_e3332 * _e3385) + (_e3353 * _e3389))));
                                        phi_1790_ = false;
                                    } else {
                                        phi_1789_ = array<f32, 3>();
                                        phi_1790_ = true;
                                    }
                                    let _e3423 = phi_1789_;
                                    let _e3425 = phi_1790_;
                                    phi_1791_ = _e3423;
                                    phi_1792_ = _e3425;
                                } else {
                                    phi_1791_ = array<f32, 3>();
                                    phi_1792_ = true;
                                }
                                let _e3427 = phi_1791_;
                                let _e3429 = phi_1792_;
                                if _e3429 {
                                    let _e3430 = (_e3309 - _e3330);
                                    let _e3431 = (_e3310 - _e3331);
                                    let _e3432 = (_e3311 - _e3332);
                                    let _e3443 = ((((_e3309 * _e3330) + (_e3310 * _e3331)) + (_e3311 * _e3332)) / (((_e3330 * _e3330) + (_e3331 * _e3331)) + (_e3332 * _e3332)));
                                    if (_e3443 > 0f) {
                                        if (_e3443 < 1f) {
                                            phi_1822_ = _e3443;
                                        } else {
                                            phi_1822_ = 1f;
                                        }
                                        let _e3447 = phi_1822_;
                                        phi_1823_ = _e3447;
                                    } else {
                                        phi_1823_ = 0f;
                                    }
                                    let _e3449 = phi_1823_;
                                    let _e3466 = ((((_e3309 * _e3351) + (_e3310 * _e3352)) + (_e3311 * _e3353)) / (((_e3351 * _e3351) + (_e3352 * _e3352)) + (_e3353 * _e3353)));
                                    if (_e3466 > 0f) {
                                        if (_e3466 < 1f) {
                                            phi_1850_ = _e3466;
                                        } else {
                                            phi_1850_ = 1f;
                                        }
                                        let _e3470 = phi_1850_;
                                        phi_1851_ = _e3470;
                                    } else {
                                        phi_1851_ = 0f;
                                    }
                                    let _e3472 = phi_1851_;
                                    let _e3489 = ((((_e3430 * _e3351) + (_e3431 * _e3352)) + (_e3432 * _e3353)) / (((_e3351 * _e3351) + (_e3352 * _e3352)) + (_e3353 * _e3353)));
                                    if (_e3489 > 0f) {
                                        if (_e3489 < 1f) {
                                            phi_1878_ = _e3489;
                                        } else {
                                            phi_1878_ = 1f;
                                        }
                                        let _e3493 = phi_1878_;
                                        phi_1879_ = _e3493;
                                    } else {
                                        phi_1879_ = 0f;
                                    }
                                    let _e3495 = phi_1879_;
                                    let _e3502 = (_e3309 - _e3351);
                                    let _e3503 = (_e3310 - _e3352);
                                    let _e3504 = (_e3311 - _e3353);
                                    let _e3515 = ((((_e3502 * _e3330) + (_e3503 * _e3331)) + (_e3504 * _e3332)) / (((_e3330 * _e3330) + (_e3331 * _e3331)) + (_e3332 * _e3332)));
                                    if (_e3515 > 0f) {
                                        if (_e3515 < 1f) {
                                            phi_1909_ = _e3515;
                                        } else {
                                            phi_1909_ = 1f;
                                        }
                                        let _e3519 = phi_1909_;
                                        phi_1910_ = _e3519;
                                    } else {
                                        phi_1910_ = 0f;
                                    }
                                    let _e3521 = phi_1910_;
                                    local_11[0u] = array<f32, 3>((_e3309 - (_e3330 * _e3449)), (_e3310 - (_e3331 * _e3449)), (_e3311 - (_e3332 * _e3449)));
                                    local_11[1u] = array<f32, 3>((_e3309 - (_e3351 * _e3472)), (_e3310 - (_e3352 * _e3472)), (_e3311 - (_e3353 * _e3472)));
                                    local_11[2u] = array<f32, 3>((_e3430 - (_e3351 * _e3495)), (_e3431 - (_e3352 * _e3495)), (_e3432 - (_e3353 * _e3495)));
                                    local_11[3u] = array<f32, 3>((_e3502 - (_e3330 * _e3521)), (_e3503 - (_e3331 * _e3521)), (_e3504 - (_e3332 * _e3521)));
                                    let _e3537 = local_11[0u];
                                    phi_2053_ = type_28(1u, 4u);
                                    phi_2056_ = array<f32, 3>(_e3537[0], _e3537[1], _e3537[2]);
                                    loop {
                                        let _e3543 = phi_2053_;
                                        let _e3545 = phi_2056_;
                                        local_69 = _e3545;
                                        if (_e3543.member < _e3543.member_1) {
                                            phi_2054_ = type_28((_e3543.member + 1u), _e3543.member_1);
                                            phi_2079_ = type_28(1u, _e3543.member);
                                        } else {
                                            phi_2054_ = _e3543;
                                            phi_2079_ = type_28(0u, type_28().member_1);
                                        }
                                        let _e3559 = phi_2054_;
                                        let _e3561 = phi_2079_;
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
                                                phi_2146_ = array<f32, 3>(_e3597[0], _e3597[1], _e3597[2]);
                                            } else {
                                                phi_2146_ = _e3545;
                                            }
                                            let _e3603 = phi_2146_;
                                            phi_2057_ = _e3603;
                                        } else {
                                            phi_2057_ = array<f32, 3>();
                                        }
                                        let _e3605 = phi_2057_;
                                        continue;
                                        continuing {
                                            phi_2053_ = _e3559;
                                            phi_2056_ = _e3605;
                                            break if !(_e3565);
                                        }
                                    }
                                    let _e5409 = local_69;
                                    phi_2147_ = _e5409;
                                } else {
                                    phi_2147_ = _e3427;
                                }
                                let _e3608 = phi_2147_;
                                if (_e3608[0] < 0f) {
                                    phi_2154_ = -(_e3608[0]);
                                } else {
                                    phi_2154_ = _e3608[0];
                                }
                                let _e3613 = phi_2154_;
                                if (_e3608[1] < 0f) {
                                    phi_2161_ = -(_e3608[1]);
                                } else {
                                    phi_2161_ = _e3608[1];
                                }
                                let _e3618 = phi_2161_;
                                if (_e3608[2] < 0f) {
                                    phi_2169_ = -(_e3608[2]);
                                } else {
                                    phi_2169_ = _e3608[2];
                                }
                                let _e3624 = phi_2169_;
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
                                                phi_2206_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2206_ = 0f;
                                            }
                                            let _e3700 = phi_2206_;
                                            phi_2270_ = _e3700;
                                        } else {
                                            phi_2213_ = type_26(0i, 5i);
                                            phi_2216_ = bitcast<f32>(((bitcast<u32>(_e3641) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3649 = phi_2213_;
                                                let _e3651 = phi_2216_;
                                                local_34 = _e3651;
                                                if (_e3649.member < _e3649.member_1) {
                                                    let _e3659 = (_e3649.member + 1i);
                                                    if ((false == (_e3659 > _e3649.member)) != false) {
                                                        phi_2237_ = true;
                                                    } else {
                                                        phi_2237_ = false;
                                                    }
                                                    let _e3664 = phi_2237_;
                                                    if _e3664 {
                                                        phi_2243_ = type_27(0u, type_27().member_1);
                                                    } else {
                                                        phi_2243_ = type_27(1u, _e3659);
                                                    }
                                                    let _e3670 = phi_2243_;
                                                    if (bitcast<i32>(_e3670.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2214_ = type_26(_e3670.member_1, _e3649.member_1);
                                                    phi_2257_ = type_27(1u, _e3649.member);
                                                } else {
                                                    phi_2214_ = _e3649;
                                                    phi_2257_ = type_27(0u, type_27().member_1);
                                                }
                                                let _e3680 = phi_2214_;
                                                let _e3682 = phi_2257_;
                                                let _e3685 = (bitcast<i32>(_e3682.member) != 0i);
                                                if _e3685 {
                                                    phi_2217_ = (0.5f * (_e3651 + (_e3641 / _e3651)));
                                                } else {
                                                    phi_2217_ = f32();
                                                }
                                                let _e3690 = phi_2217_;
                                                continue;
                                                continuing {
                                                    phi_2213_ = _e3680;
                                                    phi_2216_ = _e3690;
                                                    break if !(_e3685);
                                                }
                                            }
                                            let _e3695 = local_34;
                                            phi_2270_ = (_e3695 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3702 = phi_2270_;
                                        phi_2279_ = type_28(0u, 4u);
                                        phi_2282_ = 2f;
                                        loop {
                                            let _e3710 = phi_2279_;
                                            let _e3712 = phi_2282_;
                                            local_36 = _e3712;
                                            local_37 = _e3712;
                                            local_38 = _e3712;
                                            local_72 = _e3712;
                                            local_73 = _e3712;
                                            if (_e3710.member < _e3710.member_1) {
                                                phi_2280_ = type_28((_e3710.member + 1u), _e3710.member_1);
                                                phi_2305_ = type_28(1u, _e3710.member);
                                            } else {
                                                phi_2280_ = _e3710;
                                                phi_2305_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e3726 = phi_2280_;
                                            let _e3728 = phi_2305_;
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
                                                    phi_2356_ = -(_e3743);
                                                } else {
                                                    phi_2356_ = _e3743;
                                                }
                                                let _e3758 = phi_2356_;
                                                if (_e3754 < 0f) {
                                                    phi_2362_ = -(_e3754);
                                                } else {
                                                    phi_2362_ = _e3754;
                                                }
                                                let _e3762 = phi_2362_;
                                                let _e3766 = (((((((((_e3146 + _e3148) + (_e3200 + _e3202)) + (_e3254 + _e3256)) * (0.000000059604645f * 16f)) + (_e3263 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e267 * _e3702) * (1f + (0.000000059604645f * 8f)))) + ((_e3758 + _e3762) * (0.000000059604645f * 8f)));
                                                if (_e3743 > _e3766) {
                                                    if (_e3754 > _e3766) {
                                                        phi_2375_ = false;
                                                    } else {
                                                        phi_2375_ = true;
                                                    }
                                                    let _e3770 = phi_2375_;
                                                    phi_2376_ = _e3770;
                                                } else {
                                                    phi_2376_ = true;
                                                }
                                                let _e3772 = phi_2376_;
                                                if _e3772 {
                                                    if ((_e3743 + ((_e3754 - _e3743) * _e3271)) > _e3766) {
                                                        if (_e3754 < _e3743) {
                                                            let _e3780 = ((_e3743 - _e3754) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                            if _e3780 {
                                                                let _e3786 = (((_e3743 - _e3766) / (_e3743 - _e3754)) * (1f - (0.000000059604645f * 16f)));
                                                                if (_e3712 < _e3786) {
                                                                    phi_2407_ = _e3712;
                                                                } else {
                                                                    phi_2407_ = _e3786;
                                                                }
                                                                let _e3789 = phi_2407_;
                                                                phi_2408_ = _e3789;
                                                            } else {
                                                                phi_2408_ = f32();
                                                            }
                                                            let _e3791 = phi_2408_;
                                                            phi_2409_ = _e3791;
                                                            phi_2410_ = _e3780;
                                                        } else {
                                                            phi_2409_ = _e3712;
                                                            phi_2410_ = true;
                                                        }
                                                        let _e3793 = phi_2409_;
                                                        let _e3795 = phi_2410_;
                                                        if _e3795 {
                                                            phi_2414_ = false;
                                                        } else {
                                                            phi_2414_ = true;
                                                        }
                                                        let _e3797 = phi_2414_;
                                                        phi_2415_ = _e3793;
                                                        phi_2416_ = _e3795;
                                                        phi_2417_ = _e3797;
                                                        phi_2418_ = false;
                                                    } else {
                                                        phi_2415_ = f32();
                                                        phi_2416_ = false;
                                                        phi_2417_ = false;
                                                        phi_2418_ = true;
                                                    }
                                                    let _e3799 = phi_2415_;
                                                    let _e3801 = phi_2416_;
                                                    let _e3803 = phi_2417_;
                                                    let _e3805 = phi_2418_;
                                                    phi_2419_ = _e3799;
                                                    phi_2420_ = _e3801;
                                                    phi_2421_ = _e3803;
                                                    phi_2422_ = _e3805;
                                                } else {
                                                    phi_2419_ = _e3712;
                                                    phi_2420_ = true;
                                                    phi_2421_ = false;
                                                    phi_2422_ = false;
                                                }
                                                let _e3807 = phi_2419_;
                                                let _e3809 = phi_2420_;
                                                let _e3811 = phi_2421_;
                                                let _e3813 = phi_2422_;
                                                phi_2283_ = _e3807;
                                                phi_2423_ = _e3809;
                                                phi_2424_ = false;
                                                phi_2425_ = _e3811;
                                                phi_2426_ = _e3813;
                                            } else {
                                                phi_2283_ = f32();
                                                phi_2423_ = false;
                                                phi_2424_ = true;
                                                phi_2425_ = false;
                                                phi_2426_ = false;
                                            }
                                            let _e3815 = phi_2283_;
                                            let _e3817 = phi_2423_;
                                            let _e3819 = phi_2424_;
                                            let _e3821 = phi_2425_;
                                            let _e3823 = phi_2426_;
                                            local_35 = _e3819;
                                            local_70 = _e3821;
                                            local_71 = _e3823;
                                            continue;
                                            continuing {
                                                phi_2279_ = _e3726;
                                                phi_2282_ = _e3815;
                                                break if !(_e3817);
                                            }
                                        }
                                        let _e3826 = local_35;
                                        if _e3826 {
                                            let _e3828 = local_36;
                                            let _e3829 = (_e3828 > 1f);
                                            if _e3829 {
                                                phi_2447_ = false;
                                                phi_2448_ = false;
                                                phi_2449_ = false;
                                            } else {
                                                let _e3831 = local_37;
                                                if (_e3831 > _e3271) {
                                                    let _e3834 = local_38;
                                                    let _e3836 = ((_e3834 - _e3271) < 0.00000000023283064f);
                                                    if _e3836 {
                                                        phi_2443_ = false;
                                                    } else {
                                                        phi_2443_ = true;
                                                    }
                                                    let _e3838 = phi_2443_;
                                                    phi_2444_ = _e3838;
                                                    phi_2445_ = _e3836;
                                                    phi_2446_ = false;
                                                } else {
                                                    phi_2444_ = false;
                                                    phi_2445_ = false;
                                                    phi_2446_ = true;
                                                }
                                                let _e3840 = phi_2444_;
                                                let _e3842 = phi_2445_;
                                                let _e3844 = phi_2446_;
                                                phi_2447_ = _e3840;
                                                phi_2448_ = _e3842;
                                                phi_2449_ = _e3844;
                                            }
                                            let _e3846 = phi_2447_;
                                            let _e3848 = phi_2448_;
                                            let _e3850 = phi_2449_;
                                            phi_2450_ = _e3846;
                                            phi_2451_ = _e3829;
                                            phi_2452_ = _e3848;
                                            phi_2453_ = _e3850;
                                            phi_2454_ = false;
                                            phi_2455_ = false;
                                        } else {
                                            phi_2450_ = false;
                                            phi_2451_ = false;
                                            phi_2452_ = false;
                                            phi_2453_ = false;
                                            let _e5466 = local_70;
                                            phi_2454_ = _e5466;
                                            let _e5469 = local_71;
                                            phi_2455_ = _e5469;
                                        }
                                        let _e3852 = phi_2450_;
                                        let _e3854 = phi_2451_;
                                        let _e3856 = phi_2452_;
                                        let _e3858 = phi_2453_;
                                        let _e3860 = phi_2454_;
                                        let _e3862 = phi_2455_;
                                        let _e5472 = local_72;
                                        phi_2456_ = _e5472;
                                        let _e5475 = local_73;
                                        phi_2457_ = _e5475;
                                        phi_2458_ = _e3852;
                                        phi_2459_ = _e3854;
                                        phi_2460_ = _e3856;
                                        phi_2461_ = _e3858;
                                        phi_2462_ = _e3860;
                                        phi_2463_ = _e3862;
                                        phi_2464_ = false;
                                    } else {
                                        phi_2456_ = f32();
                                        phi_2457_ = f32();
                                        phi_2458_ = false;
                                        phi_2459_ = false;
                                        phi_2460_ = false;
                                        phi_2461_ = false;
                                        phi_2462_ = false;
                                        phi_2463_ = false;
                                        phi_2464_ = true;
                                    }
                                    let _e3864 = phi_2456_;
                                    let _e3866 = phi_2457_;
                                    let _e3868 = phi_2458_;
                                    let _e3870 = phi_2459_;
                                    let _e3872 = phi_2460_;
                                    let _e3874 = phi_2461_;
                                    let _e3876 = phi_2462_;
                                    let _e3878 = phi_2463_;
                                    let _e3880 = phi_2464_;
                                    phi_2465_ = _e3864;
                                    phi_2466_ = _e3866;
                                    phi_2467_ = _e3868;
                                    phi_2468_ = _e3870;
                                    phi_2469_ = _e3872;
                                    phi_2470_ = _e3874;
                                    phi_2471_ = _e3876;
                                    phi_2472_ = _e3878;
                                    phi_2473_ = _e3880;
                                    phi_2474_ = false;
                                } else {
                                    phi_2465_ = f32();
                                    phi_2466_ = f32();
                                    phi_2467_ = false;
                                    phi_2468_ = false;
                                    phi_2469_ = false;
                                    phi_2470_ = false;
                                    phi_2471_ = false;
                                    phi_2472_ = false;
                                    phi_2473_ = false;
                                    phi_2474_ = true;
                                }
                                let _e3882 = phi_2465_;
                                let _e3884 = phi_2466_;
                                let _e3886 = phi_2467_;
                                let _e3888 = phi_2468_;
                                let _e3890 = phi_2469_;
                                let _e3892 = phi_2470_;
                                let _e3894 = phi_2471_;
                                let _e3896 = phi_2472_;
                                let _e3898 = phi_2473_;
                                let _e3900 = phi_2474_;
                                phi_2475_ = _e3882;
                                phi_1564_ = _e3884;
                                phi_2476_ = _e3886;
                                phi_2477_ = _e3888;
                                phi_2478_ = _e3890;
                                phi_2479_ = false;
                                phi_2480_ = _e3892;
                                phi_2481_ = _e3894;
                                phi_2482_ = _e3896;
                                phi_2483_ = _e3898;
                                phi_2484_ = _e3900;
                            } else {
                                phi_2475_ = f32();
                                phi_1564_ = f32();
                                phi_2476_ = false;
                                phi_2477_ = false;
                                phi_2478_ = false;
                                phi_2479_ = true;
                                phi_2480_ = false;
                                phi_2481_ = false;
                                phi_2482_ = false;
                                phi_2483_ = false;
                                phi_2484_ = false;
                            }
                            let _e3902 = phi_2475_;
                            let _e3904 = phi_1564_;
                            let _e3906 = phi_2476_;
                            let _e3908 = phi_2477_;
                            let _e3910 = phi_2478_;
                            let _e3912 = phi_2479_;
                            let _e3914 = phi_2480_;
                            let _e3916 = phi_2481_;
                            let _e3918 = phi_2482_;
                            let _e3920 = phi_2483_;
                            let _e3922 = phi_2484_;
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
                                phi_1560_ = _e3285;
                                phi_1563_ = _e3904;
                                break if !(_e3906);
                            }
                        }
                        let _e3925 = local_39;
                        if _e3925 {
                            phi_2489_ = type_55(0u, type_55().member_1);
                            phi_2490_ = false;
                            phi_2491_ = false;
                            phi_2492_ = false;
                            phi_2493_ = false;
                            phi_2494_ = false;
                            phi_2495_ = false;
                            phi_2496_ = false;
                        } else {
                            phi_2489_ = type_55();
                            let _e5508 = local_74;
                            phi_2490_ = _e5508;
                            let _e5511 = local_75;
                            phi_2491_ = _e5511;
                            let _e5514 = local_76;
                            phi_2492_ = _e5514;
                            let _e5517 = local_77;
                            phi_2493_ = _e5517;
                            let _e5520 = local_78;
                            phi_2494_ = _e5520;
                            let _e5523 = local_79;
                            phi_2495_ = _e5523;
                            let _e5526 = local_80;
                            phi_2496_ = _e5526;
                        }
                        let _e3930 = phi_2489_;
                        let _e3932 = phi_2490_;
                        let _e3934 = phi_2491_;
                        let _e3936 = phi_2492_;
                        let _e3938 = phi_2493_;
                        let _e3940 = phi_2494_;
                        let _e3942 = phi_2495_;
                        let _e3944 = phi_2496_;
                        if _e3932 {
                            let _e5529 = local_81;
                            phi_2500_ = _e5529;
                            phi_2501_ = true;
                            phi_2502_ = false;
                            phi_2503_ = false;
                            phi_2504_ = false;
                            phi_2505_ = false;
                            phi_2506_ = false;
                            phi_2507_ = false;
                        } else {
                            let _e5531 = local_82;
                            phi_2500_ = _e5531;
                            phi_2501_ = _e3934;
                            phi_2502_ = _e3936;
                            phi_2503_ = _e3938;
                            phi_2504_ = _e3940;
                            let _e5538 = local_83;
                            phi_2505_ = _e5538;
                            phi_2506_ = _e3942;
                            phi_2507_ = _e3944;
                        }
                        let _e3946 = phi_2500_;
                        let _e3948 = phi_2501_;
                        let _e3950 = phi_2502_;
                        let _e3952 = phi_2503_;
                        let _e3954 = phi_2504_;
                        let _e3956 = phi_2505_;
                        let _e3958 = phi_2506_;
                        let _e3960 = phi_2507_;
                        if _e3948 {
                            phi_2512_ = type_55(1u, _e3946);
                            phi_2513_ = false;
                            phi_2514_ = false;
                            phi_2515_ = false;
                            phi_2516_ = false;
                            phi_2517_ = false;
                            phi_2518_ = false;
                        } else {
                            phi_2512_ = type_55();
                            phi_2513_ = _e3950;
                            phi_2514_ = _e3952;
                            phi_2515_ = _e3954;
                            phi_2516_ = _e3956;
                            phi_2517_ = _e3958;
                            phi_2518_ = _e3960;
                        }
                        let _e3963 = phi_2512_;
                        let _e3965 = phi_2513_;
                        let _e3967 = phi_2514_;
                        let _e3969 = phi_2515_;
                        let _e3971 = phi_2516_;
                        let _e3973 = phi_2517_;
                        let _e3975 = phi_2518_;
                        if _e3965 {
                            let _e3977 = local_40;
                            phi_2523_ = type_55(1u, _e3977);
                            phi_2524_ = false;
                            phi_2525_ = false;
                            phi_2526_ = true;
                            phi_2527_ = false;
                            phi_2528_ = false;
                        } else {
                            phi_2523_ = _e3930;
                            phi_2524_ = _e3967;
                            phi_2525_ = _e3969;
                            phi_2526_ = _e3971;
                            phi_2527_ = _e3973;
                            phi_2528_ = _e3975;
                        }
                        let _e3980 = phi_2523_;
                        let _e3982 = phi_2524_;
                        let _e3984 = phi_2525_;
                        let _e3986 = phi_2526_;
                        let _e3988 = phi_2527_;
                        let _e3990 = phi_2528_;
                        if _e3982 {
                            let _e3992 = local_41;
                            phi_2533_ = type_55(1u, _e3992);
                            phi_2534_ = false;
                            phi_2535_ = false;
                            phi_2536_ = false;
                            phi_2537_ = false;
                        } else {
                            phi_2533_ = type_55();
                            phi_2534_ = _e3984;
                            phi_2535_ = _e3986;
                            phi_2536_ = _e3988;
                            phi_2537_ = _e3990;
                        }
                        let _e3995 = phi_2533_;
                        let _e3997 = phi_2534_;
                        let _e3999 = phi_2535_;
                        let _e4001 = phi_2536_;
                        let _e4003 = phi_2537_;
                        if _e3997 {
                            let _e4005 = local_42;
                            phi_2542_ = type_55(1u, _e4005);
                            phi_2543_ = true;
                            phi_2544_ = false;
                            phi_2545_ = false;
                            phi_2546_ = false;
                        } else {
                            phi_2542_ = _e3995;
                            phi_2543_ = _e3982;
                            phi_2544_ = _e3999;
                            phi_2545_ = _e4001;
                            phi_2546_ = _e4003;
                        }
                        let _e4008 = phi_2542_;
                        let _e4010 = phi_2543_;
                        let _e4012 = phi_2544_;
                        let _e4014 = phi_2545_;
                        let _e4016 = phi_2546_;
                        if _e4010 {
                            phi_2550_ = _e4008;
                            phi_2551_ = true;
                            phi_2552_ = false;
                            phi_2553_ = false;
                        } else {
                            phi_2550_ = _e3980;
                            phi_2551_ = _e4012;
                            phi_2552_ = _e4014;
                            phi_2553_ = _e4016;
                        }
                        let _e4018 = phi_2550_;
                        let _e4020 = phi_2551_;
                        let _e4022 = phi_2552_;
                        let _e4024 = phi_2553_;
                        if _e4020 {
                            phi_2557_ = false;
                            phi_2558_ = false;
                        } else {
                            phi_2557_ = _e4022;
                            phi_2558_ = _e4024;
                        }
                        let _e4026 = phi_2557_;
                        let _e4028 = phi_2558_;
                        if _e4026 {
                            phi_2562_ = false;
                            phi_2563_ = false;
                        } else {
                            phi_2562_ = _e4028;
                            phi_2563_ = _e4020;
                        }
                        let _e4030 = phi_2562_;
                        let _e4032 = phi_2563_;
                        if _e4030 {
                            phi_2567_ = true;
                            phi_2568_ = false;
                        } else {
                            phi_2567_ = _e4026;
                            phi_2568_ = _e4032;
                        }
                        let _e4034 = phi_2567_;
                        let _e4036 = phi_2568_;
                        if _e4034 {
                            let _e4038 = local_43;
                            phi_2573_ = type_55(1u, _e4038);
                            phi_2574_ = true;
                        } else {
                            phi_2573_ = _e4018;
                            phi_2574_ = _e4036;
                        }
                        let _e4041 = phi_2573_;
                        let _e4043 = phi_2574_;
                        if _e4043 {
                            phi_2578_ = _e4041;
                        } else {
                            phi_2578_ = _e3963;
                        }
                        let _e4045 = phi_2578_;
                        if (_e4045.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_2592_ = type_28(0u, 3u);
                            loop {
                                let _e4058 = phi_2592_;
                                if (_e4058.member < _e4058.member_1) {
                                    phi_2593_ = type_28((_e4058.member + 1u), _e4058.member_1);
                                    phi_2616_ = type_28(1u, _e4058.member);
                                } else {
                                    phi_2593_ = _e4058;
                                    phi_2616_ = type_28(0u, type_28().member_1);
                                }
                                let _e4072 = phi_2593_;
                                let _e4074 = phi_2616_;
                                if (bitcast<i32>(_e4074.member) != 0i) {
                                    if (_e4074.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4081 = local_14[_e4074.member_1];
                                    let _e4082 = (_e4045.member_1 + _e4081);
                                    if (_e4082 < 1f) {
                                        phi_2636_ = _e4082;
                                    } else {
                                        phi_2636_ = 1f;
                                    }
                                    let _e4085 = phi_2636_;
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
                                                phi_2784_ = (_e4184 <= 1f);
                                                phi_2785_ = false;
                                            } else {
                                                phi_2784_ = bool();
                                                phi_2785_ = true;
                                            }
                                            let _e4190 = phi_2784_;
                                            let _e4192 = phi_2785_;
                                            phi_2786_ = _e4190;
                                            phi_2787_ = _e4192;
                                        } else {
                                            phi_2786_ = bool();
                                            phi_2787_ = true;
                                        }
                                        let _e4194 = phi_2786_;
                                        let _e4196 = phi_2787_;
                                        phi_2788_ = _e4194;
                                        phi_2789_ = _e4196;
                                    } else {
                                        phi_2788_ = bool();
                                        phi_2789_ = true;
                                    }
                                    let _e4198 = phi_2788_;
                                    let _e4200 = phi_2789_;
                                    if _e4200 {
                                        phi_2793_ = false;
                                    } else {
                                        phi_2793_ = _e4198;
                                    }
                                    let _e4202 = phi_2793_;
                                    if (_e4176 > 0f) {
                                        if _e4202 {
                                            phi_2833_ = array<f32, 3>((_e4104 - ((_e4125 * _e4180) + (_e4146 * _e4184))), (_e4105 - ((_e4126 * _e4180) + (_e4147 * _e4184))), (_e4106 - ((_e4127 * _e4180) + (_e4148 * _e4184))));
                                            phi_2834_ = false;
                                        } else {
                                            phi_2833_ = array<f32, 3>();
                                            phi_2834_ = true;
                                        }
                                        let _e4218 = phi_2833_;
                                        let _e4220 = phi_2834_;
                                        phi_2835_ = _e4218;
                                        phi_2836_ = _e4220;
                                    } else {
                                        phi_2835_ = array<f32, 3>();
                                        phi_2836_ = true;
                                    }
                                    let _e4222 = phi_2835_;
                                    let _e4224 = phi_2836_;
                                    if _e4224 {
                                        let _e4225 = (_e4104 - _e4125);
                                        let _e4226 = (_e4105 - _e4126);
                                        let _e4227 = (_e4106 - _e4127);
                                        let _e4238 = ((((_e4104 * _e4125) + (_e4105 * _e4126)) + (_e4106 * _e4127)) / (((_e4125 * _e4125) + (_e4126 * _e4126)) + (_e4127 * _e4127)));
                                        if (_e4238 > 0f) {
                                            if (_e4238 < 1f) {
                                                phi_2866_ = _e4238;
                                            } else {
                                                phi_2866_ = 1f;
                                            }
                                            let _e4242 = phi_2866_;
                                            phi_2867_ = _e4242;
                                        } else {
                                            phi_2867_ = 0f;
                                        }
                                        let _e4244 = phi_2867_;
                                        let _e4261 = ((((_e4104 * _e4146) + (_e4105 * _e4147)) + (_e4106 * _e4148)) / (((_e4146 * _e4146) + (_e4147 * _e4147)) + (_e4148 * _e4148)));
                                        if (_e4261 > 0f) {
                                            if (_e4261 < 1f) {
                                                phi_2894_ = _e4261;
                                            } else {
                                                phi_2894_ = 1f;
                                            }
                                            let _e4265 = phi_2894_;
                                            phi_2895_ = _e4265;
                                        } else {
                                            phi_2895_ = 0f;
                                        }
                                        let _e4267 = phi_2895_;
                                        let _e4284 = ((((_e4225 * _e4146) + (_e4226 * _e4147)) + (_e4227 * _e4148)) / (((_e4146 * _e4146) + (_e4147 * _e4147)) + (_e4148 * _e4148)));
                                        if (_e4284 > 0f) {
                                            if (_e4284 < 1f) {
                                                phi_2922_ = _e4284;
                                            } else {
                                                phi_2922_ = 1f;
                                            }
                                            let _e4288 = phi_2922_;
                                            phi_2923_ = _e4288;
                                        } else {
                                            phi_2923_ = 0f;
                                        }
                                        let _e4290 = phi_2923_;
                                        let _e4297 = (_e4104 - _e4146);
                                        let _e4298 = (_e4105 - _e4147);
                                        let _e4299 = (_e4106 - _e4148);
                                        let _e4310 = ((((_e4297 * _e4125) + (_e4298 * _e4126)) + (_e4299 * _e4127)) / (((_e4125 * _e4125) + (_e4126 * _e4126)) + (_e4127 * _e4127)));
                                        if (_e4310 > 0f) {
                                            if (_e4310 < 1f) {
                                                phi_2953_ = _e4310;
                                            } else {
                                                phi_2953_ = 1f;
                                            }
                                            let _e4314 = phi_2953_;
                                            phi_2954_ = _e4314;
                                        } else {
                                            phi_2954_ = 0f;
                                        }
                                        let _e4316 = phi_2954_;
                                        local_10[0u] = array<f32, 3>((_e4104 - (_e4125 * _e4244)), (_e4105 - (_e4126 * _e4244)), (_e4106 - (_e4127 * _e4244)));
                                        local_10[1u] = array<f32, 3>((_e4104 - (_e4146 * _e4267)), (_e4105 - (_e4147 * _e4267)), (_e4106 - (_e4148 * _e4267)));
                                        local_10[2u] = array<f32, 3>((_e4225 - (_e4146 * _e4290)), (_e4226 - (_e4147 * _e4290)), (_e4227 - (_e4148 * _e4290)));
                                        local_10[3u] = array<f32, 3>((_e4297 - (_e4125 * _e4316)), (_e4298 - (_e4126 * _e4316)), (_e4299 - (_e4127 * _e4316)));
                                        let _e4332 = local_10[0u];
                                        phi_3097_ = type_28(1u, 4u);
                                        phi_3100_ = array<f32, 3>(_e4332[0], _e4332[1], _e4332[2]);
                                        loop {
                                            let _e4338 = phi_3097_;
                                            let _e4340 = phi_3100_;
                                            local_84 = _e4340;
                                            if (_e4338.member < _e4338.member_1) {
                                                phi_3098_ = type_28((_e4338.member + 1u), _e4338.member_1);
                                                phi_3123_ = type_28(1u, _e4338.member);
                                            } else {
                                                phi_3098_ = _e4338;
                                                phi_3123_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4354 = phi_3098_;
                                            let _e4356 = phi_3123_;
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
                                                    phi_3190_ = array<f32, 3>(_e4392[0], _e4392[1], _e4392[2]);
                                                } else {
                                                    phi_3190_ = _e4340;
                                                }
                                                let _e4398 = phi_3190_;
                                                phi_3101_ = _e4398;
                                            } else {
                                                phi_3101_ = array<f32, 3>();
                                            }
                                            let _e4400 = phi_3101_;
                                            continue;
                                            continuing {
                                                phi_3097_ = _e4354;
                                                phi_3100_ = _e4400;
                                                break if !(_e4360);
                                            }
                                        }
                                        let _e5612 = local_84;
                                        phi_3191_ = _e5612;
                                    } else {
                                        phi_3191_ = _e4222;
                                    }
                                    let _e4403 = phi_3191_;
                                    let _e4414 = (((_e4403[0] * _e4403[0]) + (_e4403[1] * _e4403[1])) + (_e4403[2] * _e4403[2]));
                                    if (_e4414 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4414 > 0f) {
                                            phi_3216_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3216_ = 0f;
                                        }
                                        let _e4473 = phi_3216_;
                                        phi_3280_ = _e4473;
                                    } else {
                                        phi_3223_ = type_26(0i, 5i);
                                        phi_3226_ = bitcast<f32>(((bitcast<u32>(_e4414) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4422 = phi_3223_;
                                            let _e4424 = phi_3226_;
                                            local_44 = _e4424;
                                            if (_e4422.member < _e4422.member_1) {
                                                let _e4432 = (_e4422.member + 1i);
                                                if ((false == (_e4432 > _e4422.member)) != false) {
                                                    phi_3247_ = true;
                                                } else {
                                                    phi_3247_ = false;
                                                }
                                                let _e4437 = phi_3247_;
                                                if _e4437 {
                                                    phi_3253_ = type_27(0u, type_27().member_1);
                                                } else {
                                                    phi_3253_ = type_27(1u, _e4432);
                                                }
                                                let _e4443 = phi_3253_;
                                                if (bitcast<i32>(_e4443.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3224_ = type_26(_e4443.member_1, _e4422.member_1);
                                                phi_3267_ = type_27(1u, _e4422.member);
                                            } else {
                                                phi_3224_ = _e4422;
                                                phi_3267_ = type_27(0u, type_27().member_1);
                                            }
                                            let _e4453 = phi_3224_;
                                            let _e4455 = phi_3267_;
                                            let _e4458 = (bitcast<i32>(_e4455.member) != 0i);
                                            if _e4458 {
                                                phi_3227_ = (0.5f * (_e4424 + (_e4414 / _e4424)));
                                            } else {
                                                phi_3227_ = f32();
                                            }
                                            let _e4463 = phi_3227_;
                                            continue;
                                            continuing {
                                                phi_3223_ = _e4453;
                                                phi_3226_ = _e4463;
                                                break if !(_e4458);
                                            }
                                        }
                                        let _e4468 = local_44;
                                        phi_3280_ = (_e4468 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e4475 = phi_3280_;
                                    let _e4481 = local_15.member[0u];
                                    if (_e4481[0] < 0f) {
                                        phi_3296_ = -(_e4481[0]);
                                    } else {
                                        phi_3296_ = _e4481[0];
                                    }
                                    let _e4488 = phi_3296_;
                                    if (_e4481[1] < 0f) {
                                        phi_3303_ = -(_e4481[1]);
                                    } else {
                                        phi_3303_ = _e4481[1];
                                    }
                                    let _e4492 = phi_3303_;
                                    if (_e4488 > _e4492) {
                                        phi_3308_ = _e4488;
                                    } else {
                                        phi_3308_ = _e4492;
                                    }
                                    let _e4495 = phi_3308_;
                                    if (_e4481[2] < 0f) {
                                        phi_3315_ = -(_e4481[2]);
                                    } else {
                                        phi_3315_ = _e4481[2];
                                    }
                                    let _e4499 = phi_3315_;
                                    if (_e4495 > _e4499) {
                                        phi_3320_ = _e4495;
                                    } else {
                                        phi_3320_ = _e4499;
                                    }
                                    let _e4502 = phi_3320_;
                                    let _e4505 = local_15.member[1u];
                                    if (_e4505[0] < 0f) {
                                        phi_3333_ = -(_e4505[0]);
                                    } else {
                                        phi_3333_ = _e4505[0];
                                    }
                                    let _e4512 = phi_3333_;
                                    if (_e4505[1] < 0f) {
                                        phi_3340_ = -(_e4505[1]);
                                    } else {
                                        phi_3340_ = _e4505[1];
                                    }
                                    let _e4516 = phi_3340_;
                                    if (_e4512 > _e4516) {
                                        phi_3345_ = _e4512;
                                    } else {
                                        phi_3345_ = _e4516;
                                    }
                                    let _e4519 = phi_3345_;
                                    if (_e4505[2] < 0f) {
                                        phi_3352_ = -(_e4505[2]);
                                    } else {
                                        phi_3352_ = _e4505[2];
                                    }
                                    let _e4523 = phi_3352_;
                                    if (_e4519 > _e4523) {
                                        phi_3357_ = _e4519;
                                    } else {
                                        phi_3357_ = _e4523;
                                    }
                                    let _e4526 = phi_3357_;
                                    if (_e4502 > _e4526) {
                                        phi_3362_ = _e4502;
                                    } else {
                                        phi_3362_ = _e4526;
                                    }
                                    let _e4529 = phi_3362_;
                                    let _e4531 = local_15.member_3;
                                    let _e4535 = local_15.member_1[0u];
                                    if (_e4535[0] < 0f) {
                                        phi_3379_ = -(_e4535[0]);
                                    } else {
                                        phi_3379_ = _e4535[0];
                                    }
                                    let _e4542 = phi_3379_;
                                    if (_e4535[1] < 0f) {
                                        phi_3386_ = -(_e4535[1]);
                                    } else {
                                        phi_3386_ = _e4535[1];
                                    }
                                    let _e4546 = phi_3386_;
                                    if (_e4542 > _e4546) {
                                        phi_3391_ = _e4542;
                                    } else {
                                        phi_3391_ = _e4546;
                                    }
                                    let _e4549 = phi_3391_;
                                    if (_e4535[2] < 0f) {
                                        phi_3398_ = -(_e4535[2]);
                                    } else {
                                        phi_3398_ = _e4535[2];
                                    }
                                    let _e4553 = phi_3398_;
                                    if (_e4549 > _e4553) {
                                        phi_3403_ = _e4549;
                                    } else {
                                        phi_3403_ = _e4553;
                                    }
                                    let _e4556 = phi_3403_;
                                    let _e4559 = local_15.member_1[1u];
                                    if (_e4559[0] < 0f) {
                                        phi_3417_ = -(_e4559[0]);
                                    } else {
                                        phi_3417_ = _e4559[0];
                                    }
                                    let _e4566 = phi_3417_;
                                    if (_e4559[1] < 0f) {
                                        phi_3424_ = -(_e4559[1]);
                                    } else {
                                        phi_3424_ = _e4559[1];
                                    }
                                    let _e4570 = phi_3424_;
                                    if (_e4566 > _e4570) {
                                        phi_3429_ = _e4566;
                                    } else {
                                        phi_3429_ = _e4570;
                                    }
                                    let _e4573 = phi_3429_;
                                    if (_e4559[2] < 0f) {
                                        phi_3436_ = -(_e4559[2]);
                                    } else {
                                        phi_3436_ = _e4559[2];
                                    }
                                    let _e4577 = phi_3436_;
                                    if (_e4573 > _e4577) {
                                        phi_3441_ = _e4573;
                                    } else {
                                        phi_3441_ = _e4577;
                                    }
                                    let _e4580 = phi_3441_;
                                    if (_e4556 > _e4580) {
                                        phi_3446_ = _e4556;
                                    } else {
                                        phi_3446_ = _e4580;
                                    }
                                    let _e4583 = phi_3446_;
                                    let _e4585 = local_15.member_3;
                                    let _e4589 = local_15.member_2[0u];
                                    if (_e4589[0] < 0f) {
                                        phi_3463_ = -(_e4589[0]);
                                    } else {
                                        phi_3463_ = _e4589[0];
                                    }
                                    let _e4596 = phi_3463_;
                                    if (_e4589[1] < 0f) {
                                        phi_3470_ = -(_e4589[1]);
                                    } else {
                                        phi_3470_ = _e4589[1];
                                    }
                                    let _e4600 = phi_3470_;
                                    if (_e4596 > _e4600) {
                                        phi_3475_ = _e4596;
                                    } else {
                                        phi_3475_ = _e4600;
                                    }
                                    let _e4603 = phi_3475_;
                                    if (_e4589[2] < 0f) {
                                        phi_3482_ = -(_e4589[2]);
                                    } else {
                                        phi_3482_ = _e4589[2];
                                    }
                                    let _e4607 = phi_3482_;
                                    if (_e4603 > _e4607) {
                                        phi_3487_ = _e4603;
                                    } else {
                                        phi_3487_ = _e4607;
                                    }
                                    let _e4610 = phi_3487_;
                                    let _e4613 = local_15.member_2[1u];
                                    if (_e4613[0] < 0f) {
                                        phi_3501_ = -(_e4613[0]);
                                    } else {
                                        phi_3501_ = _e4613[0];
                                    }
                                    let _e4620 = phi_3501_;
                                    if (_e4613[1] < 0f) {
                                        phi_3508_ = -(_e4613[1]);
                                    } else {
                                        phi_3508_ = _e4613[1];
                                    }
                                    let _e4624 = phi_3508_;
                                    if (_e4620 > _e4624) {
                                        phi_3513_ = _e4620;
                                    } else {
                                        phi_3513_ = _e4624;
                                    }
                                    let _e4627 = phi_3513_;
                                    if (_e4613[2] < 0f) {
                                        phi_3520_ = -(_e4613[2]);
                                    } else {
                                        phi_3520_ = _e4613[2];
                                    }
                                    let _e4631 = phi_3520_;
                                    if (_e4627 > _e4631) {
                                        phi_3525_ = _e4627;
                                    } else {
                                        phi_3525_ = _e4631;
                                    }
                                    let _e4634 = phi_3525_;
                                    if (_e4610 > _e4634) {
                                        phi_3530_ = _e4610;
                                    } else {
                                        phi_3530_ = _e4634;
                                    }
                                    let _e4637 = phi_3530_;
                                    let _e4639 = local_15.member_3;
                                    let _e4646 = local_15.member_3;
                                    let _e4653 = (((_e4475 * (1f + (0.000000059604645f * 8f))) + (((((((_e4529 + _e4531) + (_e4583 + _e4585)) + (_e4637 + _e4639)) * (0.000000059604645f * 16f)) + (_e4646 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e267);
                                    if _e4653 {
                                        phi_3550_ = false;
                                    } else {
                                        phi_3550_ = true;
                                    }
                                    let _e4655 = phi_3550_;
                                    phi_3551_ = _e4655;
                                    phi_3552_ = _e4653;
                                } else {
                                    phi_3551_ = false;
                                    phi_3552_ = false;
                                }
                                let _e4657 = phi_3551_;
                                let _e4659 = phi_3552_;
                                local_45 = _e4659;
                                continue;
                                continuing {
                                    phi_2592_ = _e4072;
                                    break if !(_e4657);
                                }
                            }
                            let _e4662 = local_45;
                            if _e4662 {
                                phi_3557_ = type_55(1u, _e4045.member_1);
                                phi_3558_ = false;
                            } else {
                                phi_3557_ = type_55();
                                phi_3558_ = true;
                            }
                            let _e4665 = phi_3557_;
                            let _e4667 = phi_3558_;
                            if _e4667 {
                                phi_3563_ = type_55(2u, _e4045.member_1);
                                phi_3564_ = false;
                            } else {
                                phi_3563_ = type_55();
                                phi_3564_ = true;
                            }
                            let _e4670 = phi_3563_;
                            let _e4672 = phi_3564_;
                            phi_3566_ = _e4670;
                            phi_3567_ = _e4665;
                            phi_3568_ = _e4672;
                        } else {
                            phi_3566_ = type_55();
                            phi_3567_ = type_55(0u, type_55().member_1);
                            phi_3568_ = true;
                        }
                        let _e4674 = phi_3566_;
                        let _e4676 = phi_3567_;
                        let _e4678 = phi_3568_;
                        if _e4678 {
                            phi_3572_ = _e4676;
                        } else {
                            phi_3572_ = _e4674;
                        }
                        let _e4680 = phi_3572_;
                        phi_6846_ = _e4680;
                    } else {
                        if (_e365 < 0f) {
                            phi_3582_ = -(_e365);
                        } else {
                            phi_3582_ = _e365;
                        }
                        let _e708 = phi_3582_;
                        if (_e388 < 0f) {
                            phi_3588_ = -(_e388);
                        } else {
                            phi_3588_ = _e388;
                        }
                        let _e712 = phi_3588_;
                        if (_e708 > _e712) {
                            phi_3593_ = _e708;
                        } else {
                            phi_3593_ = _e712;
                        }
                        let _e715 = phi_3593_;
                        if (_e411 < 0f) {
                            phi_3599_ = -(_e411);
                        } else {
                            phi_3599_ = _e411;
                        }
                        let _e719 = phi_3599_;
                        if (_e422 < 0f) {
                            phi_3605_ = -(_e422);
                        } else {
                            phi_3605_ = _e422;
                        }
                        let _e723 = phi_3605_;
                        if (_e719 > _e723) {
                            phi_3610_ = _e719;
                        } else {
                            phi_3610_ = _e723;
                        }
                        let _e726 = phi_3610_;
                        if (_e715 > _e726) {
                            phi_3615_ = _e715;
                        } else {
                            phi_3615_ = _e726;
                        }
                        let _e729 = phi_3615_;
                        let _e730 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e729 >= _e730) {
                            phi_3623_ = (_e729 <= (1f / _e730));
                        } else {
                            phi_3623_ = false;
                        }
                        let _e735 = phi_3623_;
                        if _e735 {
                            phi_3628_ = (0.000000059604645f * 256f);
                        } else {
                            phi_3628_ = 2f;
                        }
                        let _e738 = phi_3628_;
                        let _e740 = ((_e672 * 0.34f) + (_e729 * _e738));
                        if _e735 {
                            phi_3635_ = (1f / _e729);
                        } else {
                            phi_3635_ = 0f;
                        }
                        let _e743 = phi_3635_;
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
                                    phi_3668_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_3668_ = 0f;
                                }
                                let _e818 = phi_3668_;
                                phi_3732_ = _e818;
                            } else {
                                phi_3675_ = type_26(0i, 5i);
                                phi_3678_ = bitcast<f32>(((bitcast<u32>(_e758) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e767 = phi_3675_;
                                    let _e769 = phi_3678_;
                                    local_16 = _e769;
                                    if (_e767.member < _e767.member_1) {
                                        let _e777 = (_e767.member + 1i);
                                        if ((false == (_e777 > _e767.member)) != false) {
                                            phi_3699_ = true;
                                        } else {
                                            phi_3699_ = false;
                                        }
                                        let _e782 = phi_3699_;
                                        if _e782 {
                                            phi_3705_ = type_27(0u, type_27().member_1);
                                        } else {
                                            phi_3705_ = type_27(1u, _e777);
                                        }
                                        let _e788 = phi_3705_;
                                        if (bitcast<i32>(_e788.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_3676_ = type_26(_e788.member_1, _e767.member_1);
                                        phi_3719_ = type_27(1u, _e767.member);
                                    } else {
                                        phi_3676_ = _e767;
                                        phi_3719_ = type_27(0u, type_27().member_1);
                                    }
                                    let _e798 = phi_3676_;
                                    let _e800 = phi_3719_;
                                    let _e803 = (bitcast<i32>(_e800.member) != 0i);
                                    if _e803 {
                                        phi_3679_ = (0.5f * (_e769 + (_e758 / _e769)));
                                    } else {
                                        phi_3679_ = f32();
                                    }
                                    let _e808 = phi_3679_;
                                    continue;
                                    continuing {
                                        phi_3675_ = _e798;
                                        phi_3678_ = _e808;
                                        break if !(_e803);
                                    }
                                }
                                let _e813 = local_16;
                                phi_3732_ = (_e813 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e820 = phi_3732_;
                            if (_e750 < 0f) {
                                phi_3738_ = -(_e820);
                            } else {
                                phi_3738_ = _e820;
                            }
                            let _e824 = phi_3738_;
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
                            phi_3763_ = type_28(0u, 2u);
                            phi_3766_ = 1u;
                            loop {
                                let _e845 = phi_3763_;
                                let _e847 = phi_3766_;
                                local_46 = _e847;
                                if (_e845.member < _e845.member_1) {
                                    phi_3764_ = type_28((_e845.member + 1u), _e845.member_1);
                                    phi_3789_ = type_28(1u, _e845.member);
                                } else {
                                    phi_3764_ = _e845;
                                    phi_3789_ = type_28(0u, type_28().member_1);
                                }
                                let _e861 = phi_3764_;
                                let _e863 = phi_3789_;
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
                                            phi_3833_ = (_e847 + 1u);
                                        } else {
                                            phi_3833_ = _e847;
                                        }
                                        let _e883 = phi_3833_;
                                        phi_3834_ = _e883;
                                    } else {
                                        phi_3834_ = _e847;
                                    }
                                    let _e885 = phi_3834_;
                                    phi_3767_ = _e885;
                                } else {
                                    phi_3767_ = u32();
                                }
                                let _e887 = phi_3767_;
                                continue;
                                continuing {
                                    phi_3763_ = _e861;
                                    phi_3766_ = _e887;
                                    break if !(_e867);
                                }
                            }
                            let _e4890 = local_46;
                            phi_3835_ = _e4890;
                        } else {
                            phi_3835_ = 1u;
                        }
                        let _e890 = phi_3835_;
                        if (_e890 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e890] = 1f;
                        let _e893 = local_7;
                        local_9 = _e893;
                        phi_3855_ = type_28(0u, _e890);
                        loop {
                            let _e896 = phi_3855_;
                            if (_e896.member < _e896.member_1) {
                                phi_3856_ = type_28((_e896.member + 1u), _e896.member_1);
                                phi_3879_ = type_28(1u, _e896.member);
                            } else {
                                phi_3856_ = _e896;
                                phi_3879_ = type_28(0u, type_28().member_1);
                            }
                            let _e910 = phi_3856_;
                            let _e912 = phi_3879_;
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
                                    phi_3931_ = -(_e935);
                                } else {
                                    phi_3931_ = _e935;
                                }
                                let _e951 = phi_3931_;
                                let _e952 = (_e951 > _e740);
                                if (_e947 < 0f) {
                                    phi_3938_ = -(_e947);
                                } else {
                                    phi_3938_ = _e947;
                                }
                                let _e956 = phi_3938_;
                                let _e957 = (_e956 > _e740);
                                if _e952 {
                                    if _e957 {
                                        phi_3949_ = ((_e935 > 0f) != (_e947 > 0f));
                                        phi_3950_ = false;
                                    } else {
                                        phi_3949_ = bool();
                                        phi_3950_ = true;
                                    }
                                    let _e962 = phi_3949_;
                                    let _e964 = phi_3950_;
                                    phi_3951_ = _e962;
                                    phi_3952_ = _e964;
                                } else {
                                    phi_3951_ = bool();
                                    phi_3952_ = true;
                                }
                                let _e966 = phi_3951_;
                                let _e968 = phi_3952_;
                                if _e968 {
                                    phi_3956_ = false;
                                } else {
                                    phi_3956_ = _e966;
                                }
                                let _e970 = phi_3956_;
                                if _e952 {
                                    if _e957 {
                                        if _e970 {
                                            phi_3967_ = type_56();
                                        } else {
                                            phi_3967_ = type_56(1f, 0f, _e970);
                                        }
                                        let _e973 = phi_3967_;
                                        phi_3968_ = _e973;
                                        phi_3969_ = _e970;
                                    } else {
                                        phi_3968_ = type_56();
                                        phi_3969_ = true;
                                    }
                                    let _e975 = phi_3968_;
                                    let _e977 = phi_3969_;
                                    phi_3970_ = _e975;
                                    phi_3971_ = _e977;
                                } else {
                                    phi_3970_ = type_56();
                                    phi_3971_ = true;
                                }
                                let _e979 = phi_3970_;
                                let _e981 = phi_3971_;
                                if _e981 {
                                    if _e952 {
                                        if (_e935 < 0f) {
                                            phi_3982_ = -1f;
                                        } else {
                                            phi_3982_ = 1f;
                                        }
                                        let _e984 = phi_3982_;
                                        let _e987 = (_e411 - _e388);
                                        phi_3992_ = type_28(0u, 64u);
                                        phi_3995_ = _e923;
                                        phi_3997_ = _e919;
                                        phi_3999_ = (0.5f * (_e919 + _e923));
                                        loop {
                                            let _e993 = phi_3992_;
                                            let _e995 = phi_3995_;
                                            let _e997 = phi_3997_;
                                            let _e999 = phi_3999_;
                                            local_48 = _e997;
                                            if (_e993.member < _e993.member_1) {
                                                phi_3993_ = type_28((_e993.member + 1u), _e993.member_1);
                                                phi_4022_ = type_28(1u, _e993.member);
                                            } else {
                                                phi_3993_ = _e993;
                                                phi_4022_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1013 = phi_3993_;
                                            let _e1015 = phi_4022_;
                                            if (bitcast<i32>(_e1015.member) != 0i) {
                                                let _e1019 = (1f - _e999);
                                                let _e1032 = ((_e984 * ((((_e365 * _e1019) + (_e388 * _e999)) * (_e1019 * _e1019)) + (((_e411 * _e1019) + (_e422 * _e999)) * (_e999 * _e999)))) - _e740);
                                                if (_e1032 > 0f) {
                                                    phi_4047_ = _e995;
                                                    phi_4048_ = _e999;
                                                } else {
                                                    phi_4047_ = _e999;
                                                    phi_4048_ = _e997;
                                                }
                                                let _e1035 = phi_4047_;
                                                let _e1037 = phi_4048_;
                                                let _e1039 = ((_e1035 - _e1037) > 0.00000000000022737368f);
                                                if _e1039 {
                                                    let _e1040 = (1f - _e999);
                                                    let _e1052 = (-(_e1032) / (_e984 * (((((_e388 - (3f * _e365)) * _e1040) + (_e987 * _e999)) * _e1040) + (((_e987 * _e1040) + (((3f * _e422) - _e411) * _e999)) * _e999))));
                                                    if (_e1032 > 0f) {
                                                        phi_4074_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_4074_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1058 = phi_4074_;
                                                    let _e1060 = ((_e999 + _e1052) + _e1058);
                                                    if (_e1060 > _e1037) {
                                                        if (_e1060 < _e1035) {
                                                            if (_e1052 < 0f) {
                                                                phi_4090_ = -(_e1052);
                                                            } else {
                                                                phi_4090_ = _e1052;
                                                            }
                                                            let _e1066 = phi_4090_;
                                                            if (_e1066 < (0.5f * (_e1035 - _e1037))) {
                                                                phi_4097_ = false;
                                                            } else {
                                                                phi_4097_ = true;
                                                            }
                                                            let _e1071 = phi_4097_;
                                                            phi_4098_ = _e1071;
                                                        } else {
                                                            phi_4098_ = true;
                                                        }
                                                        let _e1073 = phi_4098_;
                                                        phi_4099_ = _e1073;
                                                    } else {
                                                        phi_4099_ = true;
                                                    }
                                                    let _e1075 = phi_4099_;
                                                    if _e1075 {
                                                        phi_4105_ = (0.5f * (_e1037 + _e1035));
                                                    } else {
                                                        phi_4105_ = _e1060;
                                                    }
                                                    let _e1079 = phi_4105_;
                                                    phi_4106_ = _e1079;
                                                    phi_4107_ = false;
                                                } else {
                                                    phi_4106_ = f32();
                                                    phi_4107_ = true;
                                                }
                                                let _e1081 = phi_4106_;
                                                let _e1083 = phi_4107_;
                                                phi_3996_ = _e1035;
                                                phi_3998_ = _e1037;
                                                phi_4000_ = _e1081;
                                                phi_4108_ = _e1037;
                                                phi_4109_ = _e1039;
                                                phi_4110_ = _e1083;
                                            } else {
                                                phi_3996_ = f32();
                                                phi_3998_ = f32();
                                                phi_4000_ = f32();
                                                phi_4108_ = f32();
                                                phi_4109_ = false;
                                                phi_4110_ = false;
                                            }
                                            let _e1085 = phi_3996_;
                                            let _e1087 = phi_3998_;
                                            let _e1089 = phi_4000_;
                                            let _e1091 = phi_4108_;
                                            let _e1093 = phi_4109_;
                                            let _e1095 = phi_4110_;
                                            local_17 = _e1095;
                                            local_47 = _e1091;
                                            continue;
                                            continuing {
                                                phi_3992_ = _e1013;
                                                phi_3995_ = _e1085;
                                                phi_3997_ = _e1087;
                                                phi_3999_ = _e1089;
                                                break if !(_e1093);
                                            }
                                        }
                                        let _e1098 = local_17;
                                        if _e1098 {
                                            let _e4932 = local_47;
                                            phi_4114_ = _e4932;
                                        } else {
                                            let _e4934 = local_48;
                                            phi_4114_ = _e4934;
                                        }
                                        let _e1100 = phi_4114_;
                                        phi_4115_ = _e1100;
                                    } else {
                                        phi_4115_ = _e919;
                                    }
                                    let _e1102 = phi_4115_;
                                    if _e957 {
                                        phi_4122_ = type_28(0u, 64u);
                                        phi_4125_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1105 = phi_4122_;
                                            let _e1107 = phi_4125_;
                                            if (_e1105.member < _e1105.member_1) {
                                                phi_4123_ = type_28((_e1105.member + 1u), _e1105.member_1);
                                                phi_4148_ = type_28(1u, _e1105.member);
                                            } else {
                                                phi_4123_ = _e1105;
                                                phi_4148_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1121 = phi_4123_;
                                            let _e1123 = phi_4148_;
                                            if (bitcast<i32>(_e1123.member) != 0i) {
                                                let _e1127 = (_e1102 + _e1107);
                                                if (_e1127 < _e923) {
                                                    let _e1129 = (1f - _e1127);
                                                    let _e1140 = ((((_e365 * _e1129) + (_e388 * _e1127)) * (_e1129 * _e1129)) + (((_e411 * _e1129) + (_e422 * _e1127)) * (_e1127 * _e1127)));
                                                    let _e1141 = (1f - _e1102);
                                                    let _e1152 = ((((_e365 * _e1141) + (_e388 * _e1102)) * (_e1141 * _e1141)) + (((_e411 * _e1141) + (_e422 * _e1102)) * (_e1102 * _e1102)));
                                                    if (_e1140 < 0f) {
                                                        phi_4189_ = -(_e1140);
                                                    } else {
                                                        phi_4189_ = _e1140;
                                                    }
                                                    let _e1156 = phi_4189_;
                                                    if (_e1156 > _e740) {
                                                        if (_e1152 < 0f) {
                                                            phi_4199_ = -(_e1152);
                                                        } else {
                                                            phi_4199_ = _e1152;
                                                        }
                                                        let _e1161 = phi_4199_;
                                                        if (_e1161 > _e740) {
                                                            phi_4207_ = ((_e1140 > 0f) == (_e1152 > 0f));
                                                        } else {
                                                            phi_4207_ = false;
                                                        }
                                                        let _e1167 = phi_4207_;
                                                        phi_4209_ = !(_e1167);
                                                    } else {
                                                        phi_4209_ = false;
                                                    }
                                                    let _e1170 = phi_4209_;
                                                    if _e1170 {
                                                        phi_4214_ = f32();
                                                        phi_4215_ = false;
                                                    } else {
                                                        phi_4214_ = (_e1107 + _e1107);
                                                        phi_4215_ = true;
                                                    }
                                                    let _e1173 = phi_4214_;
                                                    let _e1175 = phi_4215_;
                                                    phi_4216_ = _e1173;
                                                    phi_4217_ = _e1175;
                                                    phi_4218_ = _e1170;
                                                    phi_4219_ = false;
                                                } else {
                                                    phi_4216_ = f32();
                                                    phi_4217_ = false;
                                                    phi_4218_ = false;
                                                    phi_4219_ = true;
                                                }
                                                let _e1177 = phi_4216_;
                                                let _e1179 = phi_4217_;
                                                let _e1181 = phi_4218_;
                                                let _e1183 = phi_4219_;
                                                phi_4220_ = _e1127;
                                                phi_4126_ = _e1177;
                                                phi_4221_ = _e1179;
                                                phi_4222_ = _e1181;
                                                phi_4223_ = _e1183;
                                                phi_4224_ = false;
                                            } else {
                                                phi_4220_ = f32();
                                                phi_4126_ = f32();
                                                phi_4221_ = false;
                                                phi_4222_ = false;
                                                phi_4223_ = false;
                                                phi_4224_ = true;
                                            }
                                            let _e1185 = phi_4220_;
                                            let _e1187 = phi_4126_;
                                            let _e1189 = phi_4221_;
                                            let _e1191 = phi_4222_;
                                            let _e1193 = phi_4223_;
                                            let _e1195 = phi_4224_;
                                            local_18 = _e1191;
                                            local_49 = _e1193;
                                            local_50 = _e1195;
                                            local_51 = _e1185;
                                            continue;
                                            continuing {
                                                phi_4122_ = _e1121;
                                                phi_4125_ = _e1187;
                                                break if !(_e1189);
                                            }
                                        }
                                        let _e1198 = local_18;
                                        if _e1198 {
                                            phi_4228_ = false;
                                            phi_4229_ = false;
                                        } else {
                                            let _e4959 = local_49;
                                            phi_4228_ = _e4959;
                                            let _e4962 = local_50;
                                            phi_4229_ = _e4962;
                                        }
                                        let _e1200 = phi_4228_;
                                        let _e1202 = phi_4229_;
                                        if _e1200 {
                                            phi_4233_ = true;
                                        } else {
                                            phi_4233_ = _e1202;
                                        }
                                        let _e1204 = phi_4233_;
                                        if _e1204 {
                                            phi_4237_ = _e923;
                                        } else {
                                            let _e4966 = local_51;
                                            phi_4237_ = _e4966;
                                        }
                                        let _e1206 = phi_4237_;
                                        phi_4238_ = _e1206;
                                    } else {
                                        phi_4238_ = _e923;
                                    }
                                    let _e1208 = phi_4238_;
                                    phi_4240_ = type_56(_e1102, _e1208, _e970);
                                } else {
                                    phi_4240_ = _e979;
                                }
                                let _e1211 = phi_4240_;
                                if (_e1211.member > _e1211.member_1) {
                                    phi_6802_ = f32();
                                    phi_6803_ = true;
                                    phi_6804_ = false;
                                    phi_6805_ = false;
                                    phi_6806_ = false;
                                } else {
                                    let _e1218 = ((_e1211.member_1 - _e1211.member) * 0.5f);
                                    let _e1219 = (_e1211.member + _e1218);
                                    let _e1221 = (_e1218 + (0.000000059604645f * 4f));
                                    let _e1223 = local_15.member_3;
                                    let _e1226 = local_15.member[0u];
                                    if (_e1226[0] < 0f) {
                                        phi_4269_ = -(_e1226[0]);
                                    } else {
                                        phi_4269_ = _e1226[0];
                                    }
                                    let _e1233 = phi_4269_;
                                    if (_e1226[1] < 0f) {
                                        phi_4276_ = -(_e1226[1]);
                                    } else {
                                        phi_4276_ = _e1226[1];
                                    }
                                    let _e1237 = phi_4276_;
                                    if (_e1233 > _e1237) {
                                        phi_4281_ = _e1233;
                                    } else {
                                        phi_4281_ = _e1237;
                                    }
                                    let _e1240 = phi_4281_;
                                    if (_e1226[2] < 0f) {
                                        phi_4288_ = -(_e1226[2]);
                                    } else {
                                        phi_4288_ = _e1226[2];
                                    }
                                    let _e1244 = phi_4288_;
                                    if (_e1240 > _e1244) {
                                        phi_4293_ = _e1240;
                                    } else {
                                        phi_4293_ = _e1244;
                                    }
                                    let _e1247 = phi_4293_;
                                    let _e1249 = local_15.member[1u];
                                    if (_e1249[0] < 0f) {
                                        phi_4306_ = -(_e1249[0]);
                                    } else {
                                        phi_4306_ = _e1249[0];
                                    }
                                    let _e1256 = phi_4306_;
                                    if (_e1249[1] < 0f) {
                                        phi_4313_ = -(_e1249[1]);
                                    } else {
                                        phi_4313_ = _e1249[1];
                                    }
                                    let _e1260 = phi_4313_;
                                    if (_e1256 > _e1260) {
                                        phi_4318_ = _e1256;
                                    } else {
                                        phi_4318_ = _e1260;
                                    }
                                    let _e1263 = phi_4318_;
                                    if (_e1249[2] < 0f) {
                                        phi_4325_ = -(_e1249[2]);
                                    } else {
                                        phi_4325_ = _e1249[2];
                                    }
                                    let _e1267 = phi_4325_;
                                    if (_e1263 > _e1267) {
                                        phi_4330_ = _e1263;
                                    } else {
                                        phi_4330_ = _e1267;
                                    }
                                    let _e1270 = phi_4330_;
                                    if (_e1247 > _e1270) {
                                        phi_4335_ = _e1247;
                                    } else {
                                        phi_4335_ = _e1270;
                                    }
                                    let _e1273 = phi_4335_;
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
                                        phi_4394_ = -(_e1304);
                                    } else {
                                        phi_4394_ = _e1304;
                                    }
                                    let _e1310 = phi_4394_;
                                    if (_e1305 < 0f) {
                                        phi_4400_ = -(_e1305);
                                    } else {
                                        phi_4400_ = _e1305;
                                    }
                                    let _e1314 = phi_4400_;
                                    if (_e1310 > _e1314) {
                                        phi_4405_ = _e1310;
                                    } else {
                                        phi_4405_ = _e1314;
                                    }
                                    let _e1317 = phi_4405_;
                                    if (_e1306 < 0f) {
                                        phi_4411_ = -(_e1306);
                                    } else {
                                        phi_4411_ = _e1306;
                                    }
                                    let _e1321 = phi_4411_;
                                    if (_e1317 > _e1321) {
                                        phi_4416_ = _e1317;
                                    } else {
                                        phi_4416_ = _e1321;
                                    }
                                    let _e1324 = phi_4416_;
                                    let _e1330 = ((((_e1221 * _e1324) * 1.01f) + ((_e1273 + _e1223) * (0.000000059604645f * 8f))) + _e1223);
                                    if (_e1291 < 0f) {
                                        phi_4428_ = -(_e1291);
                                    } else {
                                        phi_4428_ = _e1291;
                                    }
                                    let _e1334 = phi_4428_;
                                    if (_e1292 < 0f) {
                                        phi_4434_ = -(_e1292);
                                    } else {
                                        phi_4434_ = _e1292;
                                    }
                                    let _e1338 = phi_4434_;
                                    if (_e1334 > _e1338) {
                                        phi_4439_ = _e1334;
                                    } else {
                                        phi_4439_ = _e1338;
                                    }
                                    let _e1341 = phi_4439_;
                                    if (_e1293 < 0f) {
                                        phi_4445_ = -(_e1293);
                                    } else {
                                        phi_4445_ = _e1293;
                                    }
                                    let _e1345 = phi_4445_;
                                    if (_e1341 > _e1345) {
                                        phi_4450_ = _e1341;
                                    } else {
                                        phi_4450_ = _e1345;
                                    }
                                    let _e1348 = phi_4450_;
                                    local_3 = type_40(array<f32, 3>(_e1291, _e1292, _e1293), _e1330, (_e1348 + _e1330));
                                    let _e1354 = local_15.member_3;
                                    let _e1356 = local_15.member_1[0u];
                                    if (_e1356[0] < 0f) {
                                        phi_4476_ = -(_e1356[0]);
                                    } else {
                                        phi_4476_ = _e1356[0];
                                    }
                                    let _e1363 = phi_4476_;
                                    if (_e1356[1] < 0f) {
                                        phi_4483_ = -(_e1356[1]);
                                    } else {
                                        phi_4483_ = _e1356[1];
                                    }
                                    let _e1367 = phi_4483_;
                                    if (_e1363 > _e1367) {
                                        phi_4488_ = _e1363;
                                    } else {
                                        phi_4488_ = _e1367;
                                    }
                                    let _e1370 = phi_4488_;
                                    if (_e1356[2] < 0f) {
                                        phi_4495_ = -(_e1356[2]);
                                    } else {
                                        phi_4495_ = _e1356[2];
                                    }
                                    let _e1374 = phi_4495_;
                                    if (_e1370 > _e1374) {
                                        phi_4500_ = _e1370;
                                    } else {
                                        phi_4500_ = _e1374;
                                    }
                                    let _e1377 = phi_4500_;
                                    let _e1379 = local_15.member_1[1u];
                                    if (_e1379[0] < 0f) {
                                        phi_4513_ = -(_e1379[0]);
                                    } else {
                                        phi_4513_ = _e1379[0];
                                    }
                                    let _e1386 = phi_4513_;
                                    if (_e1379[1] < 0f) {
                                        phi_4520_ = -(_e1379[1]);
                                    } else {
                                        phi_4520_ = _e1379[1];
                                    }
                                    let _e1390 = phi_4520_;
                                    if (_e1386 > _e1390) {
                                        phi_4525_ = _e1386;
                                    } else {
                                        phi_4525_ = _e1390;
                                    }
                                    let _e1393 = phi_4525_;
                                    if (_e1379[2] < 0f) {
                                        phi_4532_ = -(_e1379[2]);
                                    } else {
                                        phi_4532_ = _e1379[2];
                                    }
                                    let _e1397 = phi_4532_;
                                    if (_e1393 > _e1397) {
                                        phi_4537_ = _e1393;
                                    } else {
                                        phi_4537_ = _e1397;
                                    }
                                    let _e1400 = phi_4537_;
                                    if (_e1377 > _e1400) {
                                        phi_4542_ = _e1377;
                                    } else {
                                        phi_4542_ = _e1400;
                                    }
                                    let _e1403 = phi_4542_;
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
                                        phi_4601_ = -(_e1434);
                                    } else {
                                        phi_4601_ = _e1434;
                                    }
                                    let _e1440 = phi_4601_;
                                    if (_e1435 < 0f) {
                                        phi_4607_ = -(_e1435);
                                    } else {
                                        phi_4607_ = _e1435;
                                    }
                                    let _e1444 = phi_4607_;
                                    if (_e1440 > _e1444) {
                                        phi_4612_ = _e1440;
                                    } else {
                                        phi_4612_ = _e1444;
                                    }
                                    let _e1447 = phi_4612_;
                                    if (_e1436 < 0f) {
                                        phi_4618_ = -(_e1436);
                                    } else {
                                        phi_4618_ = _e1436;
                                    }
                                    let _e1451 = phi_4618_;
                                    if (_e1447 > _e1451) {
                                        phi_4623_ = _e1447;
                                    } else {
                                        phi_4623_ = _e1451;
                                    }
                                    let _e1454 = phi_4623_;
                                    let _e1460 = ((((_e1221 * _e1454) * 1.01f) + ((_e1403 + _e1354) * (0.000000059604645f * 8f))) + _e1354);
                                    if (_e1421 < 0f) {
                                        phi_4635_ = -(_e1421);
                                    } else {
                                        phi_4635_ = _e1421;
                                    }
                                    let _e1464 = phi_4635_;
                                    if (_e1422 < 0f) {
                                        phi_4641_ = -(_e1422);
                                    } else {
                                        phi_4641_ = _e1422;
                                    }
                                    let _e1468 = phi_4641_;
                                    if (_e1464 > _e1468) {
                                        phi_4646_ = _e1464;
                                    } else {
                                        phi_4646_ = _e1468;
                                    }
                                    let _e1471 = phi_4646_;
                                    if (_e1423 < 0f) {
                                        phi_4652_ = -(_e1423);
                                    } else {
                                        phi_4652_ = _e1423;
                                    }
                                    let _e1475 = phi_4652_;
                                    if (_e1471 > _e1475) {
                                        phi_4657_ = _e1471;
                                    } else {
                                        phi_4657_ = _e1475;
                                    }
                                    let _e1478 = phi_4657_;
                                    local_4 = type_40(array<f32, 3>(_e1421, _e1422, _e1423), _e1460, (_e1478 + _e1460));
                                    let _e1484 = local_15.member_3;
                                    let _e1486 = local_15.member_2[0u];
                                    if (_e1486[0] < 0f) {
                                        phi_4683_ = -(_e1486[0]);
                                    } else {
                                        phi_4683_ = _e1486[0];
                                    }
                                    let _e1493 = phi_4683_;
                                    if (_e1486[1] < 0f) {
                                        phi_4690_ = -(_e1486[1]);
                                    } else {
                                        phi_4690_ = _e1486[1];
                                    }
                                    let _e1497 = phi_4690_;
                                    if (_e1493 > _e1497) {
                                        phi_4695_ = _e1493;
                                    } else {
                                        phi_4695_ = _e1497;
                                    }
                                    let _e1500 = phi_4695_;
                                    if (_e1486[2] < 0f) {
                                        phi_4702_ = -(_e1486[2]);
                                    } else {
                                        phi_4702_ = _e1486[2];
                                    }
                                    let _e1504 = phi_4702_;
                                    if (_e1500 > _e1504) {
                                        phi_4707_ = _e1500;
                                    } else {
                                        phi_4707_ = _e1504;
                                    }
                                    let _e1507 = phi_4707_;
                                    let _e1509 = local_15.member_2[1u];
                                    if (_e1509[0] < 0f) {
                                        phi_4720_ = -(_e1509[0]);
                                    } else {
                                        phi_4720_ = _e1509[0];
                                    }
                                    let _e1516 = phi_4720_;
                                    if (_e1509[1] < 0f) {
                                        phi_4727_ = -(_e1509[1]);
                                    } else {
                                        phi_4727_ = _e1509[1];
                                    }
                                    let _e1520 = phi_4727_;
                                    if (_e1516 > _e1520) {
                                        phi_4732_ = _e1516;
                                    } else {
                                        phi_4732_ = _e1520;
                                    }
                                    let _e1523 = phi_4732_;
                                    if (_e1509[2] < 0f) {
                                        phi_4739_ = -(_e1509[2]);
                                    } else {
                                        phi_4739_ = _e1509[2];
                                    }
                                    let _e1527 = phi_4739_;
                                    if (_e1523 > _e1527) {
                                        phi_4744_ = _e1523;
                                    } else {
                                        phi_4744_ = _e1527;
                                    }
                                    let _e1530 = phi_4744_;
                                    if (_e1507 > _e1530) {
                                        phi_4749_ = _e1507;
                                    } else {
                                        phi_4749_ = _e1530;
                                    }
                                    let _e1533 = phi_4749_;
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
                                        phi_4808_ = -(_e1564);
                                    } else {
                                        phi_4808_ = _e1564;
                                    }
                                    let _e1570 = phi_4808_;
                                    if (_e1565 < 0f) {
                                        phi_4814_ = -(_e1565);
                                    } else {
                                        phi_4814_ = _e1565;
                                    }
                                    let _e1574 = phi_4814_;
                                    if (_e1570 > _e1574) {
                                        phi_4819_ = _e1570;
                                    } else {
                                        phi_4819_ = _e1574;
                                    }
                                    let _e1577 = phi_4819_;
                                    if (_e1566 < 0f) {
                                        phi_4825_ = -(_e1566);
                                    } else {
                                        phi_4825_ = _e1566;
                                    }
                                    let _e1581 = phi_4825_;
                                    if (_e1577 > _e1581) {
                                        phi_4830_ = _e1577;
                                    } else {
                                        phi_4830_ = _e1581;
                                    }
                                    let _e1584 = phi_4830_;
                                    let _e1590 = ((((_e1221 * _e1584) * 1.01f) + ((_e1533 + _e1484) * (0.000000059604645f * 8f))) + _e1484);
                                    if (_e1551 < 0f) {
                                        phi_4842_ = -(_e1551);
                                    } else {
                                        phi_4842_ = _e1551;
                                    }
                                    let _e1594 = phi_4842_;
                                    if (_e1552 < 0f) {
                                        phi_4848_ = -(_e1552);
                                    } else {
                                        phi_4848_ = _e1552;
                                    }
                                    let _e1598 = phi_4848_;
                                    if (_e1594 > _e1598) {
                                        phi_4853_ = _e1594;
                                    } else {
                                        phi_4853_ = _e1598;
                                    }
                                    let _e1601 = phi_4853_;
                                    if (_e1553 < 0f) {
                                        phi_4859_ = -(_e1553);
                                    } else {
                                        phi_4859_ = _e1553;
                                    }
                                    let _e1605 = phi_4859_;
                                    if (_e1601 > _e1605) {
                                        phi_4864_ = _e1601;
                                    } else {
                                        phi_4864_ = _e1605;
                                    }
                                    let _e1608 = phi_4864_;
                                    local_5 = type_40(array<f32, 3>(_e1551, _e1552, _e1553), _e1590, (_e1608 + _e1590));
                                    let _e1613 = local_4.member;
                                    let _e1618 = local_5.member;
                                    let _e1624 = ((_e1613[1] * _e1618[2]) - (_e1613[2] * _e1618[1]));
                                    let _e1627 = ((_e1613[2] * _e1618[0]) - (_e1613[0] * _e1618[2]));
                                    let _e1630 = ((_e1613[0] * _e1618[1]) - (_e1613[1] * _e1618[0]));
                                    if (_e1624 < 0f) {
                                        phi_4913_ = -(_e1624);
                                    } else {
                                        phi_4913_ = _e1624;
                                    }
                                    let _e1634 = phi_4913_;
                                    if (_e1627 < 0f) {
                                        phi_4919_ = -(_e1627);
                                    } else {
                                        phi_4919_ = _e1627;
                                    }
                                    let _e1638 = phi_4919_;
                                    if (_e1634 > _e1638) {
                                        if (_e1624 < 0f) {
                                            phi_4929_ = -(_e1624);
                                        } else {
                                            phi_4929_ = _e1624;
                                        }
                                        let _e1656 = phi_4929_;
                                        if (_e1630 < 0f) {
                                            phi_4935_ = -(_e1630);
                                        } else {
                                            phi_4935_ = _e1630;
                                        }
                                        let _e1660 = phi_4935_;
                                        if (_e1656 > _e1660) {
                                            phi_4940_ = 2u;
                                            phi_4941_ = 1u;
                                        } else {
                                            phi_4940_ = 1u;
                                            phi_4941_ = 0u;
                                        }
                                        let _e1663 = phi_4940_;
                                        let _e1665 = phi_4941_;
                                        phi_4960_ = _e1663;
                                        phi_4961_ = _e1665;
                                    } else {
                                        if (_e1627 < 0f) {
                                            phi_4947_ = -(_e1627);
                                        } else {
                                            phi_4947_ = _e1627;
                                        }
                                        let _e1643 = phi_4947_;
                                        if (_e1630 < 0f) {
                                            phi_4953_ = -(_e1630);
                                        } else {
                                            phi_4953_ = _e1630;
                                        }
                                        let _e1647 = phi_4953_;
                                        if (_e1643 > _e1647) {
                                            phi_4958_ = 0u;
                                            phi_4959_ = 2u;
                                        } else {
                                            phi_4958_ = 1u;
                                            phi_4959_ = 0u;
                                        }
                                        let _e1650 = phi_4958_;
                                        let _e1652 = phi_4959_;
                                        phi_4960_ = _e1650;
                                        phi_4961_ = _e1652;
                                    }
                                    let _e1667 = phi_4960_;
                                    let _e1669 = phi_4961_;
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
                                        phi_5028_ = -(_e1688);
                                    } else {
                                        phi_5028_ = _e1688;
                                    }
                                    let _e1722 = phi_5028_;
                                    if (_e1722 > _e1718) {
                                        if (_e1688 < 0f) {
                                            phi_5037_ = -1f;
                                        } else {
                                            phi_5037_ = 1f;
                                        }
                                        let _e1726 = phi_5037_;
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
                                            phi_5168_ = -(_e1825);
                                        } else {
                                            phi_5168_ = _e1825;
                                        }
                                        let _e1831 = phi_5168_;
                                        if (_e1826 < 0f) {
                                            phi_5174_ = -(_e1826);
                                        } else {
                                            phi_5174_ = _e1826;
                                        }
                                        let _e1835 = phi_5174_;
                                        if (_e1827 < 0f) {
                                            phi_5181_ = -(_e1827);
                                        } else {
                                            phi_5181_ = _e1827;
                                        }
                                        let _e1840 = phi_5181_;
                                        let _e1843 = (((_e1831 + _e1835) + _e1840) * (0.000000059604645f * 4f));
                                        local_6[0u].member = _e1826;
                                        local_6[0u].member_1 = _e1775;
                                        local_6[1u].member = _e1827;
                                        local_6[1u].member_1 = _e1824;
                                        local_6[2u].member = (_e1825 - _e1826);
                                        local_6[2u].member_1 = ((_e1718 + _e1775) + _e1843);
                                        local_6[3u].member = (_e1825 - _e1827);
                                        local_6[3u].member_1 = ((_e1718 + _e1824) + _e1843);
                                        phi_5224_ = type_28(0u, 4u);
                                        phi_5227_ = true;
                                        loop {
                                            let _e1864 = phi_5224_;
                                            let _e1866 = phi_5227_;
                                            local_20 = _e1866;
                                            if (_e1864.member < _e1864.member_1) {
                                                phi_5225_ = type_28((_e1864.member + 1u), _e1864.member_1);
                                                phi_5250_ = type_28(1u, _e1864.member);
                                            } else {
                                                phi_5225_ = _e1864;
                                                phi_5250_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e1880 = phi_5225_;
                                            let _e1882 = phi_5250_;
                                            if (bitcast<i32>(_e1882.member) != 0i) {
                                                if (_e1882.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1890 = local_6[_e1882.member_1].member;
                                                let _e1893 = local_6[_e1882.member_1].member_1;
                                                let _e1895 = (_e1890 < -(_e1893));
                                                if _e1895 {
                                                    phi_5277_ = bool();
                                                    phi_5278_ = false;
                                                } else {
                                                    phi_5277_ = (_e1866 && (_e1890 > _e1893));
                                                    phi_5278_ = true;
                                                }
                                                let _e1899 = phi_5277_;
                                                let _e1901 = phi_5278_;
                                                phi_5228_ = _e1899;
                                                phi_5279_ = _e1901;
                                                phi_5280_ = _e1895;
                                            } else {
                                                phi_5228_ = bool();
                                                phi_5279_ = false;
                                                phi_5280_ = false;
                                            }
                                            let _e1903 = phi_5228_;
                                            let _e1905 = phi_5279_;
                                            let _e1907 = phi_5280_;
                                            local_19 = _e1907;
                                            continue;
                                            continuing {
                                                phi_5224_ = _e1880;
                                                phi_5227_ = _e1903;
                                                break if !(_e1905);
                                            }
                                        }
                                        let _e1910 = local_19;
                                        if _e1910 {
                                            phi_5284_ = false;
                                        } else {
                                            phi_5284_ = true;
                                        }
                                        let _e1912 = phi_5284_;
                                        if _e1912 {
                                            let _e1914 = local_20;
                                            if _e1914 {
                                                phi_5291_ = 1u;
                                            } else {
                                                phi_5291_ = 2u;
                                            }
                                            let _e1916 = phi_5291_;
                                            phi_5292_ = _e1916;
                                            phi_5293_ = false;
                                        } else {
                                            phi_5292_ = u32();
                                            phi_5293_ = true;
                                        }
                                        let _e1918 = phi_5292_;
                                        let _e1920 = phi_5293_;
                                        phi_5294_ = _e1918;
                                        phi_5295_ = 0u;
                                        phi_5296_ = _e1920;
                                    } else {
                                        phi_5294_ = u32();
                                        phi_5295_ = 2u;
                                        phi_5296_ = true;
                                    }
                                    let _e1922 = phi_5294_;
                                    let _e1924 = phi_5295_;
                                    let _e1926 = phi_5296_;
                                    if _e1926 {
                                        phi_5300_ = _e1924;
                                    } else {
                                        phi_5300_ = _e1922;
                                    }
                                    let _e1928 = phi_5300_;
                                    let _e1929 = (_e1928 == 0u);
                                    if _e1929 {
                                        phi_6798_ = f32();
                                        phi_6799_ = false;
                                        phi_6800_ = false;
                                        phi_6801_ = false;
                                    } else {
                                        if (_e1928 == 1u) {
                                            if _e1211.member_2 {
                                                if ((_e1211.member_1 - _e1211.member) <= 0.0000005f) {
                                                    phi_5320_ = false;
                                                } else {
                                                    phi_5320_ = true;
                                                }
                                                let _e1937 = phi_5320_;
                                                phi_5321_ = _e1937;
                                            } else {
                                                phi_5321_ = true;
                                            }
                                            let _e1939 = phi_5321_;
                                            phi_5322_ = _e1939;
                                        } else {
                                            phi_5322_ = true;
                                        }
                                        let _e1941 = phi_5322_;
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
                                                phi_5518_ = -(_e2008[0]);
                                            } else {
                                                phi_5518_ = _e2008[0];
                                            }
                                            let _e2015 = phi_5518_;
                                            if (_e2008[1] < 0f) {
                                                phi_5525_ = -(_e2008[1]);
                                            } else {
                                                phi_5525_ = _e2008[1];
                                            }
                                            let _e2019 = phi_5525_;
                                            if (_e2015 > _e2019) {
                                                phi_5530_ = _e2015;
                                            } else {
                                                phi_5530_ = _e2019;
                                            }
                                            let _e2022 = phi_5530_;
                                            if (_e2008[2] < 0f) {
                                                phi_5537_ = -(_e2008[2]);
                                            } else {
                                                phi_5537_ = _e2008[2];
                                            }
                                            let _e2026 = phi_5537_;
                                            if (_e2022 > _e2026) {
                                                phi_5542_ = _e2022;
                                            } else {
                                                phi_5542_ = _e2026;
                                            }
                                            let _e2029 = phi_5542_;
                                            let _e2032 = local_15.member[1u];
                                            if (_e2032[0] < 0f) {
                                                phi_5555_ = -(_e2032[0]);
                                            } else {
                                                phi_5555_ = _e2032[0];
                                            }
                                            let _e2039 = phi_5555_;
                                            if (_e2032[1] < 0f) {
                                                phi_5562_ = -(_e2032[1]);
                                            } else {
                                                phi_5562_ = _e2032[1];
                                            }
                                            let _e2043 = phi_5562_;
                                            if (_e2039 > _e2043) {
                                                phi_5567_ = _e2039;
                                            } else {
                                                phi_5567_ = _e2043;
                                            }
                                            let _e2046 = phi_5567_;
                                            if (_e2032[2] < 0f) {
                                                phi_5574_ = -(_e2032[2]);
                                            } else {
                                                phi_5574_ = _e2032[2];
                                            }
                                            let _e2050 = phi_5574_;
                                            if (_e2046 > _e2050) {
                                                phi_5579_ = _e2046;
                                            } else {
                                                phi_5579_ = _e2050;
                                            }
                                            let _e2053 = phi_5579_;
                                            if (_e2029 > _e2053) {
                                                phi_5584_ = _e2029;
                                            } else {
                                                phi_5584_ = _e2053;
                                            }
                                            let _e2056 = phi_5584_;
                                            let _e2058 = local_15.member_3;
                                            let _e2062 = local_15.member_1[0u];
                                            if (_e2062[0] < 0f) {
                                                phi_5601_ = -(_e2062[0]);
                                            } else {
                                                phi_5601_ = _e2062[0];
                                            }
                                            let _e2069 = phi_5601_;
                                            if (_e2062[1] < 0f) {
                                                phi_5608_ = -(_e2062[1]);
                                            } else {
                                                phi_5608_ = _e2062[1];
                                            }
                                            let _e2073 = phi_5608_;
                                            if (_e2069 > _e2073) {
                                                phi_5613_ = _e2069;
                                            } else {
                                                phi_5613_ = _e2073;
                                            }
                                            let _e2076 = phi_5613_;
                                            if (_e2062[2] < 0f) {
                                                phi_5620_ = -(_e2062[2]);
                                            } else {
                                                phi_5620_ = _e2062[2];
                                            }
                                            let _e2080 = phi_5620_;
                                            if (_e2076 > _e2080) {
                                                phi_5625_ = _e2076;
                                            } else {
                                                phi_5625_ = _e2080;
                                            }
                                            let _e2083 = phi_5625_;
                                            let _e2086 = local_15.member_1[1u];
                                            if (_e2086[0] < 0f) {
                                                phi_5639_ = -(_e2086[0]);
                                            } else {
                                                phi_5639_ = _e2086[0];
                                            }
                                            let _e2093 = phi_5639_;
                                            if (_e2086[1] < 0f) {
                                                phi_5646_ = -(_e2086[1]);
                                            } else {
                                                phi_5646_ = _e2086[1];
                                            }
                                            let _e2097 = phi_5646_;
                                            if (_e2093 > _e2097) {
                                                phi_5651_ = _e2093;
                                            } else {
                                                phi_5651_ = _e2097;
                                            }
                                            let _e2100 = phi_5651_;
                                            if (_e2086[2] < 0f) {
                                                phi_5658_ = -(_e2086[2]);
                                            } else {
                                                phi_5658_ = _e2086[2];
                                            }
                                            let _e2104 = phi_5658_;
                                            if (_e2100 > _e2104) {
                                                phi_5663_ = _e2100;
                                            } else {
                                                phi_5663_ = _e2104;
                                            }
                                            let _e2107 = phi_5663_;
                                            if (_e2083 > _e2107) {
                                                phi_5668_ = _e2083;
                                            } else {
                                                phi_5668_ = _e2107;
                                            }
                                            let _e2110 = phi_5668_;
                                            let _e2112 = local_15.member_3;
                                            let _e2116 = local_15.member_2[0u];
                                            if (_e2116[0] < 0f) {
                                                phi_5685_ = -(_e2116[0]);
                                            } else {
                                                phi_5685_ = _e2116[0];
                                            }
                                            let _e2123 = phi_5685_;
                                            if (_e2116[1] < 0f) {
                                                phi_5692_ = -(_e2116[1]);
                                            } else {
                                                phi_5692_ = _e2116[1];
                                            }
                                            let _e2127 = phi_5692_;
                                            if (_e2123 > _e2127) {
                                                phi_5697_ = _e2123;
                                            } else {
                                                phi_5697_ = _e2127;
                                            }
                                            let _e2130 = phi_5697_;
                                            if (_e2116[2] < 0f) {
                                                phi_5704_ = -(_e2116[2]);
                                            } else {
                                                phi_5704_ = _e2116[2];
                                            }
                                            let _e2134 = phi_5704_;
                                            if (_e2130 > _e2134) {
                                                phi_5709_ = _e2130;
                                            } else {
                                                phi_5709_ = _e2134;
                                            }
                                            let _e2137 = phi_5709_;
                                            let _e2140 = local_15.member_2[1u];
                                            if (_e2140[0] < 0f) {
                                                phi_5723_ = -(_e2140[0]);
                                            } else {
                                                phi_5723_ = _e2140[0];
                                            }
                                            let _e2147 = phi_5723_;
                                            if (_e2140[1] < 0f) {
                                                phi_5730_ = -(_e2140[1]);
                                            } else {
                                                phi_5730_ = _e2140[1];
                                            }
                                            let _e2151 = phi_5730_;
                                            if (_e2147 > _e2151) {
                                                phi_5735_ = _e2147;
                                            } else {
                                                phi_5735_ = _e2151;
                                            }
                                            let _e2154 = phi_5735_;
                                            if (_e2140[2] < 0f) {
                                                phi_5742_ = -(_e2140[2]);
                                            } else {
                                                phi_5742_ = _e2140[2];
                                            }
                                            let _e2158 = phi_5742_;
                                            if (_e2154 > _e2158) {
                                                phi_5747_ = _e2154;
                                            } else {
                                                phi_5747_ = _e2158;
                                            }
                                            let _e2161 = phi_5747_;
                                            if (_e2137 > _e2161) {
                                                phi_5752_ = _e2137;
                                            } else {
                                                phi_5752_ = _e2161;
                                            }
                                            let _e2164 = phi_5752_;
                                            let _e2166 = local_15.member_3;
                                            let _e2173 = local_15.member_3;
                                            phi_5768_ = type_28(0u, 48u);
                                            phi_5771_ = _e1211.member;
                                            loop {
                                                let _e2179 = phi_5768_;
                                                let _e2181 = phi_5771_;
                                                local_65 = _e2181;
                                                local_27 = _e2181;
                                                local_28 = _e2181;
                                                local_29 = _e2181;
                                                local_30 = _e2181;
                                                if (_e2179.member < _e2179.member_1) {
                                                    phi_5769_ = type_28((_e2179.member + 1u), _e2179.member_1);
                                                    phi_5794_ = type_28(1u, _e2179.member);
                                                } else {
                                                    phi_5769_ = _e2179;
                                                    phi_5794_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e2195 = phi_5769_;
                                                let _e2197 = phi_5794_;
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
                                                                phi_5948_ = (_e2299 <= 1f);
                                                                phi_5949_ = false;
                                                            } else {
                                                                phi_5948_ = bool();
                                                                phi_5949_ = true;
                                                            }
                                                            let _e2305 = phi_5948_;
                                                            let _e2307 = phi_5949_;
                                                            phi_5950_ = _e2305;
                                                            phi_5951_ = _e2307;
                                                        } else {
                                                            phi_5950_ = bool();
                                                            phi_5951_ = true;
                                                        }
                                                        let _e2309 = phi_5950_;
                                                        let _e2311 = phi_5951_;
                                                        phi_5952_ = _e2309;
                                                        phi_5953_ = _e2311;
                                                    } else {
                                                        phi_5952_ = bool();
                                                        phi_5953_ = true;
                                                    }
                                                    let _e2313 = phi_5952_;
                                                    let _e2315 = phi_5953_;
                                                    if _e2315 {
                                                        phi_5957_ = false;
                                                    } else {
                                                        phi_5957_ = _e2313;
                                                    }
                                                    let _e2317 = phi_5957_;
                                                    if (_e2291 > 0f) {
                                                        if _e2317 {
                                                            phi_5997_ = array<f32, 3>((_e2219 - ((_e2240 * _e2295) + (_e2261 * _e2299))), (_e2220 - ((_e2241 * _e2295) + (_e2262 * _e2299))), (_e2221 - ((_e2242 * _e2295) + (_e2263 * _e2299))));
                                                            phi_5998_ = false;
                                                        } else {
                                                            phi_5997_ = array<f32, 3>();
                                                            phi_5998_ = true;
                                                        }
                                                        let _e2333 = phi_5997_;
                                                        let _e2335 = phi_5998_;
                                                        phi_5999_ = _e2333;
                                                        phi_6000_ = _e2335;
                                                    } else {
                                                        phi_5999_ = array<f32, 3>();
                                                        phi_6000_ = true;
                                                    }
                                                    let _e2337 = phi_5999_;
                                                    let _e2339 = phi_6000_;
                                                    if _e2339 {
                                                        let _e2340 = (_e2219 - _e2240);
                                                        let _e2341 = (_e2220 - _e2241);
                                                        let _e2342 = (_e2221 - _e2242);
                                                        let _e2353 = ((((_e2219 * _e2240) + (_e2220 * _e2241)) + (_e2221 * _e2242)) / (((_e2240 * _e2240) + (_e2241 * _e2241)) + (_e2242 * _e2242)));
                                                        if (_e2353 > 0f) {
                                                            if (_e2353 < 1f) {
                                                                phi_6030_ = _e2353;
                                                            } else {
                                                                phi_6030_ = 1f;
                                                            }
                                                            let _e2357 = phi_6030_;
                                                            phi_6031_ = _e2357;
                                                        } else {
                                                            phi_6031_ = 0f;
                                                        }
                                                        let _e2359 = phi_6031_;
                                                        let _e2376 = ((((_e2219 * _e2261) + (_e2220 * _e2262)) + (_e2221 * _e2263)) / (((_e2261 * _e2261) + (_e2262 * _e2262)) + (_e2263 * _e2263)));
                                                        if (_e2376 > 0f) {
                                                            if (_e2376 < 1f) {
                                                                phi_6058_ = _e2376;
                                                            } else {
                                                                phi_6058_ = 1f;
                                                            }
                                                            let _e2380 = phi_6058_;
                                                            phi_6059_ = _e2380;
                                                        } else {
                                                            phi_6059_ = 0f;
                                                        }
                                                        let _e2382 = phi_6059_;
                                                        let _e2399 = ((((_e2340 * _e2261) + (_e2341 * _e2262)) + (_e2342 * _e2263)) / (((_e2261 * _e2261) + (_e2262 * _e2262)) + (_e2263 * _e2263)));
                                                        if (_e2399 > 0f) {
                                                            if (_e2399 < 1f) {
                                                                phi_6086_ = _e2399;
                                                            } else {
                                                                phi_6086_ = 1f;
                                                            }
                                                            let _e2403 = phi_6086_;
                                                            phi_6087_ = _e2403;
                                                        } else {
                                                            phi_6087_ = 0f;
                                                        }
                                                        let _e2405 = phi_6087_;
                                                        let _e2412 = (_e2219 - _e2261);
                                                        let _e2413 = (_e2220 - _e2262);
                                                        let _e2414 = (_e2221 - _e2263);
                                                        let _e2425 = ((((_e2412 * _e2240) + (_e2413 * _e2241)) + (_e2414 * _e2242)) / (((_e2240 * _e2240) + (_e2241 * _e2241)) + (_e2242 * _e2242)));
                                                        if (_e2425 > 0f) {
                                                            if (_e2425 < 1f) {
                                                                phi_6117_ = _e2425;
                                                            } else {
                                                                phi_6117_ = 1f;
                                                            }
                                                            let _e2429 = phi_6117_;
                                                            phi_6118_ = _e2429;
                                                        } else {
                                                            phi_6118_ = 0f;
                                                        }
                                                        let _e2431 = phi_6118_;
                                                        local[0u] = array<f32, 3>((_e2219 - (_e2240 * _e2359)), (_e2220 - (_e2241 * _e2359)), (_e2221 - (_e2242 * _e2359)));
                                                        local[1u] = array<f32, 3>((_e2219 - (_e2261 * _e2382)), (_e2220 - (_e2262 * _e2382)), (_e2221 - (_e2263 * _e2382)));
                                                        local[2u] = array<f32, 3>((_e2340 - (_e2261 * _e2405)), (_e2341 - (_e2262 * _e2405)), (_e2342 - (_e2263 * _e2405)));
                                                        local[3u] = array<f32, 3>((_e2412 - (_e2240 * _e2431)), (_e2413 - (_e2241 * _e2431)), (_e2414 - (_e2242 * _e2431)));
                                                        let _e2447 = local[0u];
                                                        phi_6261_ = type_28(1u, 4u);
                                                        phi_6264_ = array<f32, 3>(_e2447[0], _e2447[1], _e2447[2]);
                                                        loop {
                                                            let _e2453 = phi_6261_;
                                                            let _e2455 = phi_6264_;
                                                            local_52 = _e2455;
                                                            if (_e2453.member < _e2453.member_1) {
                                                                phi_6262_ = type_28((_e2453.member + 1u), _e2453.member_1);
                                                                phi_6287_ = type_28(1u, _e2453.member);
                                                            } else {
                                                                phi_6262_ = _e2453;
                                                                phi_6287_ = type_28(0u, type_28().member_1);
                                                            }
                                                            let _e2469 = phi_6262_;
                                                            let _e2471 = phi_6287_;
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
                                                                    phi_6354_ = array<f32, 3>(_e2507[0], _e2507[1], _e2507[2]);
                                                                } else {
                                                                    phi_6354_ = _e2455;
                                                                }
                                                                let _e2513 = phi_6354_;
                                                                phi_6265_ = _e2513;
                                                            } else {
                                                                phi_6265_ = array<f32, 3>();
                                                            }
                                                            let _e2515 = phi_6265_;
                                                            continue;
                                                            continuing {
                                                                phi_6261_ = _e2469;
                                                                phi_6264_ = _e2515;
                                                                break if !(_e2475);
                                                            }
                                                        }
                                                        let _e5135 = local_52;
                                                        phi_6355_ = _e5135;
                                                    } else {
                                                        phi_6355_ = _e2337;
                                                    }
                                                    let _e2518 = phi_6355_;
                                                    if (_e2518[0] < 0f) {
                                                        phi_6362_ = -(_e2518[0]);
                                                    } else {
                                                        phi_6362_ = _e2518[0];
                                                    }
                                                    let _e2523 = phi_6362_;
                                                    if (_e2518[1] < 0f) {
                                                        phi_6369_ = -(_e2518[1]);
                                                    } else {
                                                        phi_6369_ = _e2518[1];
                                                    }
                                                    let _e2528 = phi_6369_;
                                                    if (_e2518[2] < 0f) {
                                                        phi_6377_ = -(_e2518[2]);
                                                    } else {
                                                        phi_6377_ = _e2518[2];
                                                    }
                                                    let _e2534 = phi_6377_;
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
                                                                    phi_6414_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6414_ = 0f;
                                                                }
                                                                let _e2610 = phi_6414_;
                                                                phi_6478_ = _e2610;
                                                            } else {
                                                                phi_6421_ = type_26(0i, 5i);
                                                                phi_6424_ = bitcast<f32>(((bitcast<u32>(_e2551) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2559 = phi_6421_;
                                                                    let _e2561 = phi_6424_;
                                                                    local_21 = _e2561;
                                                                    if (_e2559.member < _e2559.member_1) {
                                                                        let _e2569 = (_e2559.member + 1i);
                                                                        if ((false == (_e2569 > _e2559.member)) != false) {
                                                                            phi_6445_ = true;
                                                                        } else {
                                                                            phi_6445_ = false;
                                                                        }
                                                                        let _e2574 = phi_6445_;
                                                                        if _e2574 {
                                                                            phi_6451_ = type_27(0u, type_27().member_1);
                                                                        } else {
                                                                            phi_6451_ = type_27(1u, _e2569);
                                                                        }
                                                                        let _e2580 = phi_6451_;
                                                                        if (bitcast<i32>(_e2580.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_6422_ = type_26(_e2580.member_1, _e2559.member_1);
                                                                        phi_6465_ = type_27(1u, _e2559.member);
                                                                    } else {
                                                                        phi_6422_ = _e2559;
                                                                        phi_6465_ = type_27(0u, type_27().member_1);
                                                                    }
                                                                    let _e2590 = phi_6422_;
                                                                    let _e2592 = phi_6465_;
                                                                    let _e2595 = (bitcast<i32>(_e2592.member) != 0i);
                                                                    if _e2595 {
                                                                        phi_6425_ = (0.5f * (_e2561 + (_e2551 / _e2561)));
                                                                    } else {
                                                                        phi_6425_ = f32();
                                                                    }
                                                                    let _e2600 = phi_6425_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6421_ = _e2590;
                                                                        phi_6424_ = _e2600;
                                                                        break if !(_e2595);
                                                                    }
                                                                }
                                                                let _e2605 = local_21;
                                                                phi_6478_ = (_e2605 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2612 = phi_6478_;
                                                            phi_6487_ = type_28(0u, 4u);
                                                            phi_6490_ = 2f;
                                                            loop {
                                                                let _e2620 = phi_6487_;
                                                                let _e2622 = phi_6490_;
                                                                local_23 = _e2622;
                                                                local_24 = _e2622;
                                                                local_25 = _e2622;
                                                                local_55 = _e2622;
                                                                local_56 = _e2622;
                                                                if (_e2620.member < _e2620.member_1) {
                                                                    phi_6488_ = type_28((_e2620.member + 1u), _e2620.member_1);
                                                                    phi_6513_ = type_28(1u, _e2620.member);
                                                                } else {
                                                                    phi_6488_ = _e2620;
                                                                    phi_6513_ = type_28(0u, type_28().member_1);
                                                                }
                                                                let _e2636 = phi_6488_;
                                                                let _e2638 = phi_6513_;
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
                                                                        phi_6564_ = -(_e2653);
                                                                    } else {
                                                                        phi_6564_ = _e2653;
                                                                    }
                                                                    let _e2668 = phi_6564_;
                                                                    if (_e2664 < 0f) {
                                                                        phi_6570_ = -(_e2664);
                                                                    } else {
                                                                        phi_6570_ = _e2664;
                                                                    }
                                                                    let _e2672 = phi_6570_;
                                                                    let _e2676 = (((((((((_e2056 + _e2058) + (_e2110 + _e2112)) + (_e2164 + _e2166)) * (0.000000059604645f * 16f)) + (_e2173 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2612) * (1f + (0.000000059604645f * 8f)))) + ((_e2668 + _e2672) * (0.000000059604645f * 8f)));
                                                                    if (_e2653 > _e2676) {
                                                                        if (_e2664 > _e2676) {
                                                                            phi_6583_ = false;
                                                                        } else {
                                                                            phi_6583_ = true;
                                                                        }
                                                                        let _e2680 = phi_6583_;
                                                                        phi_6584_ = _e2680;
                                                                    } else {
                                                                        phi_6584_ = true;
                                                                    }
                                                                    let _e2682 = phi_6584_;
                                                                    if _e2682 {
                                                                        if ((_e2653 + ((_e2664 - _e2653) * _e2181)) > _e2676) {
                                                                            if (_e2664 < _e2653) {
                                                                                let _e2690 = ((_e2653 - _e2664) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                                                if _e2690 {
                                                                                    let _e2696 = (((_e2653 - _e2676) / (_e2653 - _e2664)) * (1f - (0.000000059604645f * 16f)));
                                                                                    if (_e2622 < _e2696) {
                                                                                        phi_6615_ = _e2622;
                                                                                    } else {
                                                                                        phi_6615_ = _e2696;
                                                                                    }
                                                                                    let _e2699 = phi_6615_;
                                                                                    phi_6616_ = _e2699;
                                                                                } else {
                                                                                    phi_6616_ = f32();
                                                                                }
                                                                                let _e2701 = phi_6616_;
                                                                                phi_6617_ = _e2701;
                                                                                phi_6618_ = _e2690;
                                                                            } else {
                                                                                phi_6617_ = _e2622;
                                                                                phi_6618_ = true;
                                                                            }
                                                                            let _e2703 = phi_6617_;
                                                                            let _e2705 = phi_6618_;
                                                                            if _e2705 {
                                                                                phi_6622_ = false;
                                                                            } else {
                                                                                phi_6622_ = true;
                                                                            }
                                                                            let _e2707 = phi_6622_;
                                                                            phi_6623_ = _e2703;
                                                                            phi_6624_ = _e2705;
                                                                            phi_6625_ = _e2707;
                                                                            phi_6626_ = false;
                                                                        } else {
                                                                            phi_6623_ = f32();
                                                                            phi_6624_ = false;
                                                                            phi_6625_ = false;
                                                                            phi_6626_ = true;
                                                                        }
                                                                        let _e2709 = phi_6623_;
                                                                        let _e2711 = phi_6624_;
                                                                        let _e2713 = phi_6625_;
                                                                        let _e2715 = phi_6626_;
                                                                        phi_6627_ = _e2709;
                                                                        phi_6628_ = _e2711;
                                                                        phi_6629_ = _e2713;
                                                                        phi_6630_ = _e2715;
                                                                    } else {
                                                                        phi_6627_ = _e2622;
                                                                        phi_6628_ = true;
                                                                        phi_6629_ = false;
                                                                        phi_6630_ = false;
                                                                    }
                                                                    let _e2717 = phi_6627_;
                                                                    let _e2719 = phi_6628_;
                                                                    let _e2721 = phi_6629_;
                                                                    let _e2723 = phi_6630_;
                                                                    phi_6491_ = _e2717;
                                                                    phi_6631_ = _e2719;
                                                                    phi_6632_ = false;
                                                                    phi_6633_ = _e2721;
                                                                    phi_6634_ = _e2723;
                                                                } else {
                                                                    phi_6491_ = f32();
                                                                    phi_6631_ = false;
                                                                    phi_6632_ = true;
                                                                    phi_6633_ = false;
                                                                    phi_6634_ = false;
                                                                }
                                                                let _e2725 = phi_6491_;
                                                                let _e2727 = phi_6631_;
                                                                let _e2729 = phi_6632_;
                                                                let _e2731 = phi_6633_;
                                                                let _e2733 = phi_6634_;
                                                                local_22 = _e2729;
                                                                local_53 = _e2731;
                                                                local_54 = _e2733;
                                                                continue;
                                                                continuing {
                                                                    phi_6487_ = _e2636;
                                                                    phi_6490_ = _e2725;
                                                                    break if !(_e2727);
                                                                }
                                                            }
                                                            let _e2736 = local_22;
                                                            if _e2736 {
                                                                let _e2738 = local_23;
                                                                let _e2739 = (_e2738 > _e1211.member_1);
                                                                if _e2739 {
                                                                    phi_6655_ = false;
                                                                    phi_6656_ = false;
                                                                    phi_6657_ = false;
                                                                } else {
                                                                    let _e2741 = local_24;
                                                                    if (_e2741 > _e2181) {
                                                                        let _e2744 = local_25;
                                                                        let _e2746 = ((_e2744 - _e2181) < 0.00000000023283064f);
                                                                        if _e2746 {
                                                                            phi_6651_ = false;
                                                                        } else {
                                                                            phi_6651_ = true;
                                                                        }
                                                                        let _e2748 = phi_6651_;
                                                                        phi_6652_ = _e2748;
                                                                        phi_6653_ = _e2746;
                                                                        phi_6654_ = false;
                                                                    } else {
                                                                        phi_6652_ = false;
                                                                        phi_6653_ = false;
                                                                        phi_6654_ = true;
                                                                    }
                                                                    let _e2750 = phi_6652_;
                                                                    let _e2752 = phi_6653_;
                                                                    let _e2754 = phi_6654_;
                                                                    phi_6655_ = _e2750;
                                                                    phi_6656_ = _e2752;
                                                                    phi_6657_ = _e2754;
                                                                }
                                                                let _e2756 = phi_6655_;
                                                                let _e2758 = phi_6656_;
                                                                let _e2760 = phi_6657_;
                                                                phi_6658_ = _e2756;
                                                                phi_6659_ = _e2739;
                                                                phi_6660_ = _e2758;
                                                                phi_6661_ = _e2760;
                                                                phi_6662_ = false;
                                                                phi_6663_ = false;
                                                            } else {
                                                                phi_6658_ = false;
                                                                phi_6659_ = false;
                                                                phi_6660_ = false;
                                                                phi_6661_ = false;
                                                                let _e5192 = local_53;
                                                                phi_6662_ = _e5192;
                                                                let _e5195 = local_54;
                                                                phi_6663_ = _e5195;
                                                            }
                                                            let _e2762 = phi_6658_;
                                                            let _e2764 = phi_6659_;
                                                            let _e2766 = phi_6660_;
                                                            let _e2768 = phi_6661_;
                                                            let _e2770 = phi_6662_;
                                                            let _e2772 = phi_6663_;
                                                            let _e5198 = local_55;
                                                            phi_6664_ = _e5198;
                                                            let _e5201 = local_56;
                                                            phi_6665_ = _e5201;
                                                            phi_6666_ = _e2762;
                                                            phi_6667_ = _e2764;
                                                            phi_6668_ = _e2766;
                                                            phi_6669_ = _e2768;
                                                            phi_6670_ = _e2770;
                                                            phi_6671_ = _e2772;
                                                            phi_6672_ = false;
                                                        } else {
                                                            phi_6664_ = f32();
                                                            phi_6665_ = f32();
                                                            phi_6666_ = false;
                                                            phi_6667_ = false;
                                                            phi_6668_ = false;
                                                            phi_6669_ = false;
                                                            phi_6670_ = false;
                                                            phi_6671_ = false;
                                                            phi_6672_ = true;
                                                        }
                                                        let _e2774 = phi_6664_;
                                                        let _e2776 = phi_6665_;
                                                        let _e2778 = phi_6666_;
                                                        let _e2780 = phi_6667_;
                                                        let _e2782 = phi_6668_;
                                                        let _e2784 = phi_6669_;
                                                        let _e2786 = phi_6670_;
                                                        let _e2788 = phi_6671_;
                                                        let _e2790 = phi_6672_;
                                                        phi_6673_ = _e2774;
                                                        phi_6674_ = _e2776;
                                                        phi_6675_ = _e2778;
                                                        phi_6676_ = _e2780;
                                                        phi_6677_ = _e2782;
                                                        phi_6678_ = _e2784;
                                                        phi_6679_ = _e2786;
                                                        phi_6680_ = _e2788;
                                                        phi_6681_ = _e2790;
                                                        phi_6682_ = false;
                                                    } else {
                                                        phi_6673_ = f32();
                                                        phi_6674_ = f32();
                                                        phi_6675_ = false;
                                                        phi_6676_ = false;
                                                        phi_6677_ = false;
                                                        phi_6678_ = false;
                                                        phi_6679_ = false;
                                                        phi_6680_ = false;
                                                        phi_6681_ = false;
                                                        phi_6682_ = true;
                                                    }
                                                    let _e2792 = phi_6673_;
                                                    let _e2794 = phi_6674_;
                                                    let _e2796 = phi_6675_;
                                                    let _e2798 = phi_6676_;
                                                    let _e2800 = phi_6677_;
                                                    let _e2802 = phi_6678_;
                                                    let _e2804 = phi_6679_;
                                                    let _e2806 = phi_6680_;
                                                    let _e2808 = phi_6681_;
                                                    let _e2810 = phi_6682_;
                                                    phi_6683_ = _e2792;
                                                    phi_5772_ = _e2794;
                                                    phi_6684_ = _e2796;
                                                    phi_6685_ = _e2798;
                                                    phi_6686_ = _e2800;
                                                    phi_6687_ = false;
                                                    phi_6688_ = _e2802;
                                                    phi_6689_ = _e2804;
                                                    phi_6690_ = _e2806;
                                                    phi_6691_ = _e2808;
                                                    phi_6692_ = _e2810;
                                                } else {
                                                    phi_6683_ = f32();
                                                    phi_5772_ = f32();
                                                    phi_6684_ = false;
                                                    phi_6685_ = false;
                                                    phi_6686_ = false;
                                                    phi_6687_ = true;
                                                    phi_6688_ = false;
                                                    phi_6689_ = false;
                                                    phi_6690_ = false;
                                                    phi_6691_ = false;
                                                    phi_6692_ = false;
                                                }
                                                let _e2812 = phi_6683_;
                                                let _e2814 = phi_5772_;
                                                let _e2816 = phi_6684_;
                                                let _e2818 = phi_6685_;
                                                let _e2820 = phi_6686_;
                                                let _e2822 = phi_6687_;
                                                let _e2824 = phi_6688_;
                                                let _e2826 = phi_6689_;
                                                let _e2828 = phi_6690_;
                                                let _e2830 = phi_6691_;
                                                let _e2832 = phi_6692_;
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
                                                    phi_5768_ = _e2195;
                                                    phi_5771_ = _e2814;
                                                    break if !(_e2816);
                                                }
                                            }
                                            let _e2835 = local_26;
                                            if _e2835 {
                                                phi_6697_ = type_55(0u, type_55().member_1);
                                                phi_6698_ = false;
                                                phi_6699_ = false;
                                                phi_6700_ = false;
                                                phi_6701_ = false;
                                                phi_6702_ = false;
                                                phi_6703_ = false;
                                                phi_6704_ = false;
                                            } else {
                                                phi_6697_ = type_55();
                                                let _e5234 = local_57;
                                                phi_6698_ = _e5234;
                                                let _e5237 = local_58;
                                                phi_6699_ = _e5237;
                                                let _e5240 = local_59;
                                                phi_6700_ = _e5240;
                                                let _e5243 = local_60;
                                                phi_6701_ = _e5243;
                                                let _e5246 = local_61;
                                                phi_6702_ = _e5246;
                                                let _e5249 = local_62;
                                                phi_6703_ = _e5249;
                                                let _e5252 = local_63;
                                                phi_6704_ = _e5252;
                                            }
                                            let _e2840 = phi_6697_;
                                            let _e2842 = phi_6698_;
                                            let _e2844 = phi_6699_;
                                            let _e2846 = phi_6700_;
                                            let _e2848 = phi_6701_;
                                            let _e2850 = phi_6702_;
                                            let _e2852 = phi_6703_;
                                            let _e2854 = phi_6704_;
                                            if _e2842 {
                                                let _e5255 = local_64;
                                                phi_6708_ = _e5255;
                                                phi_6709_ = true;
                                                phi_6710_ = false;
                                                phi_6711_ = false;
                                                phi_6712_ = false;
                                                phi_6713_ = false;
                                                phi_6714_ = false;
                                                phi_6715_ = false;
                                            } else {
                                                let _e5257 = local_65;
                                                phi_6708_ = _e5257;
                                                phi_6709_ = _e2844;
                                                phi_6710_ = _e2846;
                                                phi_6711_ = _e2848;
                                                phi_6712_ = _e2850;
                                                let _e5264 = local_66;
                                                phi_6713_ = _e5264;
                                                phi_6714_ = _e2852;
                                                phi_6715_ = _e2854;
                                            }
                                            let _e2856 = phi_6708_;
                                            let _e2858 = phi_6709_;
                                            let _e2860 = phi_6710_;
                                            let _e2862 = phi_6711_;
                                            let _e2864 = phi_6712_;
                                            let _e2866 = phi_6713_;
                                            let _e2868 = phi_6714_;
                                            let _e2870 = phi_6715_;
                                            if _e2858 {
                                                phi_6720_ = type_55(1u, _e2856);
                                                phi_6721_ = false;
                                                phi_6722_ = false;
                                                phi_6723_ = false;
                                                phi_6724_ = false;
                                                phi_6725_ = false;
                                                phi_6726_ = false;
                                            } else {
                                                phi_6720_ = type_55();
                                                phi_6721_ = _e2860;
                                                phi_6722_ = _e2862;
                                                phi_6723_ = _e2864;
                                                phi_6724_ = _e2866;
                                                phi_6725_ = _e2868;
                                                phi_6726_ = _e2870;
                                            }
                                            let _e2873 = phi_6720_;
                                            let _e2875 = phi_6721_;
                                            let _e2877 = phi_6722_;
                                            let _e2879 = phi_6723_;
                                            let _e2881 = phi_6724_;
                                            let _e2883 = phi_6725_;
                                            let _e2885 = phi_6726_;
                                            if _e2875 {
                                                let _e2887 = local_27;
                                                phi_6731_ = type_55(1u, _e2887);
                                                phi_6732_ = false;
                                                phi_6733_ = false;
                                                phi_6734_ = true;
                                                phi_6735_ = false;
                                                phi_6736_ = false;
                                            } else {
                                                phi_6731_ = _e2840;
                                                phi_6732_ = _e2877;
                                                phi_6733_ = _e2879;
                                                phi_6734_ = _e2881;
                                                phi_6735_ = _e2883;
                                                phi_6736_ = _e2885;
                                            }
                                            let _e2890 = phi_6731_;
                                            let _e2892 = phi_6732_;
                                            let _e2894 = phi_6733_;
                                            let _e2896 = phi_6734_;
                                            let _e2898 = phi_6735_;
                                            let _e2900 = phi_6736_;
                                            if _e2892 {
                                                let _e2902 = local_28;
                                                phi_6741_ = type_55(1u, _e2902);
                                                phi_6742_ = false;
                                                phi_6743_ = false;
                                                phi_6744_ = false;
                                                phi_6745_ = false;
                                            } else {
                                                phi_6741_ = type_55();
                                                phi_6742_ = _e2894;
                                                phi_6743_ = _e2896;
                                                phi_6744_ = _e2898;
                                                phi_6745_ = _e2900;
                                            }
                                            let _e2905 = phi_6741_;
                                            let _e2907 = phi_6742_;
                                            let _e2909 = phi_6743_;
                                            let _e2911 = phi_6744_;
                                            let _e2913 = phi_6745_;
                                            if _e2907 {
                                                let _e2915 = local_29;
                                                phi_6750_ = type_55(1u, _e2915);
                                                phi_6751_ = true;
                                                phi_6752_ = false;
                                                phi_6753_ = false;
                                                phi_6754_ = false;
                                            } else {
                                                phi_6750_ = _e2905;
                                                phi_6751_ = _e2892;
                                                phi_6752_ = _e2909;
                                                phi_6753_ = _e2911;
                                                phi_6754_ = _e2913;
                                            }
                                            let _e2918 = phi_6750_;
                                            let _e2920 = phi_6751_;
                                            let _e2922 = phi_6752_;
                                            let _e2924 = phi_6753_;
                                            let _e2926 = phi_6754_;
                                            if _e2920 {
                                                phi_6758_ = _e2918;
                                                phi_6759_ = true;
                                                phi_6760_ = false;
                                                phi_6761_ = false;
                                            } else {
                                                phi_6758_ = _e2890;
                                                phi_6759_ = _e2922;
                                                phi_6760_ = _e2924;
                                                phi_6761_ = _e2926;
                                            }
                                            let _e2928 = phi_6758_;
                                            let _e2930 = phi_6759_;
                                            let _e2932 = phi_6760_;
                                            let _e2934 = phi_6761_;
                                            if _e2930 {
                                                phi_6765_ = false;
                                                phi_6766_ = false;
                                            } else {
                                                phi_6765_ = _e2932;
                                                phi_6766_ = _e2934;
                                            }
                                            let _e2936 = phi_6765_;
                                            let _e2938 = phi_6766_;
                                            if _e2936 {
                                                phi_6770_ = false;
                                                phi_6771_ = false;
                                            } else {
                                                phi_6770_ = _e2938;
                                                phi_6771_ = _e2930;
                                            }
                                            let _e2940 = phi_6770_;
                                            let _e2942 = phi_6771_;
                                            if _e2940 {
                                                phi_6775_ = true;
                                                phi_6776_ = false;
                                            } else {
                                                phi_6775_ = _e2936;
                                                phi_6776_ = _e2942;
                                            }
                                            let _e2944 = phi_6775_;
                                            let _e2946 = phi_6776_;
                                            if _e2944 {
                                                let _e2948 = local_30;
                                                phi_6781_ = type_55(1u, _e2948);
                                                phi_6782_ = true;
                                            } else {
                                                phi_6781_ = _e2928;
                                                phi_6782_ = _e2946;
                                            }
                                            let _e2951 = phi_6781_;
                                            let _e2953 = phi_6782_;
                                            if _e2953 {
                                                phi_6786_ = _e2951;
                                            } else {
                                                phi_6786_ = _e2873;
                                            }
                                            let _e2955 = phi_6786_;
                                            let _e2958 = (_e2955.member != 0u);
                                            if _e2958 {
                                                phi_6793_ = false;
                                            } else {
                                                phi_6793_ = true;
                                            }
                                            let _e2960 = phi_6793_;
                                            phi_6794_ = _e2955.member_1;
                                            phi_6795_ = _e2960;
                                            phi_6796_ = _e2958;
                                            phi_6797_ = false;
                                        } else {
                                            phi_6794_ = f32();
                                            phi_6795_ = false;
                                            phi_6796_ = false;
                                            phi_6797_ = true;
                                        }
                                        let _e2962 = phi_6794_;
                                        let _e2964 = phi_6795_;
                                        let _e2966 = phi_6796_;
                                        let _e2968 = phi_6797_;
                                        phi_6798_ = _e2962;
                                        phi_6799_ = _e2964;
                                        phi_6800_ = _e2966;
                                        phi_6801_ = _e2968;
                                    }
                                    let _e2970 = phi_6798_;
                                    let _e2972 = phi_6799_;
                                    let _e2974 = phi_6800_;
                                    let _e2976 = phi_6801_;
                                    phi_6802_ = _e2970;
                                    phi_6803_ = _e1929;
                                    phi_6804_ = _e2972;
                                    phi_6805_ = _e2974;
                                    phi_6806_ = _e2976;
                                }
                                let _e2978 = phi_6802_;
                                let _e2980 = phi_6803_;
                                let _e2982 = phi_6804_;
                                let _e2984 = phi_6805_;
                                let _e2986 = phi_6806_;
                                if _e2980 {
                                    phi_6810_ = true;
                                    phi_6811_ = false;
                                    phi_6812_ = false;
                                } else {
                                    phi_6810_ = _e2982;
                                    phi_6811_ = _e2984;
                                    phi_6812_ = _e2986;
                                }
                                let _e2988 = phi_6810_;
                                let _e2990 = phi_6811_;
                                let _e2992 = phi_6812_;
                                phi_6813_ = _e2978;
                                phi_6814_ = _e1211;
                                phi_6815_ = _e2988;
                                phi_6816_ = false;
                                phi_6817_ = _e2990;
                                phi_6818_ = _e2992;
                            } else {
                                phi_6813_ = f32();
                                phi_6814_ = type_56();
                                phi_6815_ = false;
                                phi_6816_ = true;
                                phi_6817_ = false;
                                phi_6818_ = false;
                            }
                            let _e2994 = phi_6813_;
                            let _e2996 = phi_6814_;
                            let _e2998 = phi_6815_;
                            let _e3000 = phi_6816_;
                            let _e3002 = phi_6817_;
                            let _e3004 = phi_6818_;
                            local_31 = _e3000;
                            local_67 = _e3002;
                            local_68 = _e3004;
                            local_32 = _e2994;
                            local_33 = _e2996;
                            continue;
                            continuing {
                                phi_3855_ = _e910;
                                break if !(_e2998);
                            }
                        }
                        let _e3007 = local_31;
                        if _e3007 {
                            phi_6823_ = type_55(0u, type_55().member_1);
                            phi_6824_ = false;
                            phi_6825_ = false;
                        } else {
                            phi_6823_ = type_55();
                            let _e5334 = local_67;
                            phi_6824_ = _e5334;
                            let _e5337 = local_68;
                            phi_6825_ = _e5337;
                        }
                        let _e3012 = phi_6823_;
                        let _e3014 = phi_6824_;
                        let _e3016 = phi_6825_;
                        if _e3014 {
                            let _e3018 = local_32;
                            phi_6830_ = type_55(2u, _e3018);
                            phi_6831_ = false;
                        } else {
                            phi_6830_ = type_55();
                            phi_6831_ = _e3016;
                        }
                        let _e3021 = phi_6830_;
                        let _e3023 = phi_6831_;
                        if _e3023 {
                            let _e3025 = local_33;
                            phi_6837_ = type_55(1u, _e3025.member);
                            phi_6838_ = true;
                        } else {
                            phi_6837_ = _e3021;
                            phi_6838_ = _e3014;
                        }
                        let _e3029 = phi_6837_;
                        let _e3031 = phi_6838_;
                        if _e3031 {
                            phi_6842_ = _e3029;
                        } else {
                            phi_6842_ = _e3012;
                        }
                        let _e3033 = phi_6842_;
                        phi_6846_ = _e3033;
                    }
                    let _e4682 = phi_6846_;
                    phi_6847_ = _e4682;
                }
                let _e4687 = phi_6847_;
                switch bitcast<i32>(_e4687.member) {
                    case 0: {
                        phi_6860_ = type_58(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4693 = function_(_e4687.member_1);
                        phi_6860_ = type_58(0u, _e4693, true);
                        break;
                    }
                    case 2: {
                        let _e4691 = function_(_e4687.member_1);
                        phi_6860_ = type_58(1u, _e4691, true);
                        break;
                    }
                    default: {
                        phi_6860_ = type_58();
                        break;
                    }
                }
                let _e4696 = phi_6860_;
                if _e4696.member_2 {
                    phi_6867_ = (_e4696.member == 0u);
                } else {
                    phi_6867_ = false;
                }
                let _e4701 = phi_6867_;
                if _e4701 {
                    let _e4709 = (_e4696.member_1[1] >> bitcast<u32>(20i));
                    if (_e4709 <= 896u) {
                        phi_6891_ = 0u;
                    } else {
                        phi_6891_ = ((((_e4709 - 896u) << bitcast<u32>(23i)) | ((_e4696.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4696.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4724 = phi_6891_;
                    let _e4726 = atomicMin((&earliest.member[0u]), _e4724);
                }
                phi_6895_ = type_48(_e177, 0u, _e183, _e186, _e4696.member_1);
                phi_6896_ = _e4701;
                phi_6897_ = (_e4696.member != 0u);
            } else {
                phi_6895_ = type_48(_e177, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_6896_ = false;
                phi_6897_ = false;
            }
            let _e4728 = phi_6895_;
            let _e4730 = phi_6896_;
            let _e4732 = phi_6897_;
            let _e4734 = params.member.member_1;
            if ((_e4734 & 16u) != 0u) {
                if (_e108 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4730 {
                    let _e4740 = atomicAdd((&counters[0u]), 1u);
                    phi_6915_ = _e4740;
                } else {
                    phi_6915_ = 0u;
                }
                let _e4742 = phi_6915_;
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
                phi_6977_ = _e4780;
            } else {
                phi_6977_ = 0u;
            }
            let _e4782 = phi_6977_;
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
            phi_246_ = _e165;
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
