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
@group(0) @binding(3) 
var<storage> input: type_17;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_63;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_63;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_63;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> elements: type_21;

fn function_(param: f32) -> array<u32, 2> {
    var phi_172_: array<u32, 2>;
    var phi_173_: array<u32, 2>;
    var phi_174_: bool;
    var phi_178_: array<u32, 2>;

    let _e91 = bitcast<u32>(param);
    if (_e91 < 8388608u) {
        phi_173_ = array<u32, 2>();
        phi_174_ = true;
    } else {
        let _e95 = ((_e91 >> bitcast<u32>(31i)) == 1u);
        if _e95 {
            phi_172_ = array<u32, 2>();
        } else {
            phi_172_ = array<u32, 2>((_e91 << bitcast<u32>(29i)), ((((_e91 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e91 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e109 = phi_172_;
        phi_173_ = _e109;
        phi_174_ = _e95;
    }
    let _e111 = phi_173_;
    let _e113 = phi_174_;
    if _e113 {
        phi_178_ = array<u32, 2>(0u, 0u);
    } else {
        phi_178_ = _e111;
    }
    let _e115 = phi_178_;
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
    var phi_233_: u32;
    var phi_249_: u32;
    var phi_270_: u32;
    var phi_271_: u32;
    var phi_274_: type_29;
    var phi_275_: type_29;
    var phi_298_: type_29;
    var phi_737_: f32;
    var phi_744_: f32;
    var phi_749_: f32;
    var phi_756_: f32;
    var phi_761_: f32;
    var phi_774_: f32;
    var phi_781_: f32;
    var phi_786_: f32;
    var phi_793_: f32;
    var phi_798_: f32;
    var phi_803_: f32;
    var phi_820_: f32;
    var phi_827_: f32;
    var phi_832_: f32;
    var phi_839_: f32;
    var phi_844_: f32;
    var phi_858_: f32;
    var phi_865_: f32;
    var phi_870_: f32;
    var phi_877_: f32;
    var phi_882_: f32;
    var phi_887_: f32;
    var phi_904_: f32;
    var phi_911_: f32;
    var phi_916_: f32;
    var phi_923_: f32;
    var phi_928_: f32;
    var phi_942_: f32;
    var phi_949_: f32;
    var phi_954_: f32;
    var phi_961_: f32;
    var phi_966_: f32;
    var phi_971_: f32;
    var phi_1002_: f32;
    var phi_1008_: f32;
    var phi_1015_: f32;
    var phi_1022_: f32;
    var phi_1028_: f32;
    var phi_1035_: f32;
    var phi_1041_: f32;
    var phi_1047_: f32;
    var phi_1053_: f32;
    var phi_1060_: f32;
    var phi_1067_: f32;
    var phi_1091_: f32;
    var phi_1096_: f32;
    var phi_1101_: f32;
    var phi_1106_: f32;
    var phi_1111_: f32;
    var phi_1116_: f32;
    var phi_1126_: f32;
    var phi_3599_: f32;
    var phi_3605_: f32;
    var phi_3610_: f32;
    var phi_3616_: f32;
    var phi_3622_: f32;
    var phi_3627_: f32;
    var phi_3632_: f32;
    var phi_3640_: bool;
    var phi_3645_: f32;
    var phi_3652_: f32;
    var phi_3692_: type_27;
    var phi_3695_: f32;
    var phi_3716_: bool;
    var phi_3722_: type_28;
    var phi_3693_: type_27;
    var phi_3736_: type_28;
    var phi_3696_: f32;
    var local_16: f32;
    var phi_3685_: f32;
    var phi_3749_: f32;
    var phi_3755_: f32;
    var phi_3780_: type_29;
    var phi_3783_: u32;
    var phi_3781_: type_29;
    var phi_3806_: type_29;
    var phi_3850_: u32;
    var phi_3851_: u32;
    var phi_3784_: u32;
    var phi_3852_: u32;
    var phi_3872_: type_29;
    var phi_3873_: type_29;
    var phi_3896_: type_29;
    var phi_3948_: f32;
    var phi_3955_: f32;
    var phi_3966_: bool;
    var phi_3967_: bool;
    var phi_3968_: bool;
    var phi_3969_: bool;
    var phi_3973_: bool;
    var phi_3984_: type_57;
    var phi_3985_: type_57;
    var phi_3986_: bool;
    var phi_3987_: type_57;
    var phi_3988_: bool;
    var phi_3999_: f32;
    var phi_4009_: type_29;
    var phi_4012_: f32;
    var phi_4014_: f32;
    var phi_4016_: f32;
    var phi_4010_: type_29;
    var phi_4039_: type_29;
    var phi_4064_: f32;
    var phi_4065_: f32;
    var phi_4091_: f32;
    var phi_4107_: f32;
    var phi_4114_: bool;
    var phi_4115_: bool;
    var phi_4116_: bool;
    var phi_4122_: f32;
    var phi_4123_: f32;
    var phi_4124_: bool;
    var phi_4013_: f32;
    var phi_4015_: f32;
    var phi_4017_: f32;
    var phi_4125_: f32;
    var phi_4126_: bool;
    var phi_4127_: bool;
    var local_17: bool;
    var phi_4131_: f32;
    var phi_4132_: f32;
    var phi_4139_: type_29;
    var phi_4142_: f32;
    var phi_4140_: type_29;
    var phi_4165_: type_29;
    var phi_4206_: f32;
    var phi_4216_: f32;
    var phi_4224_: bool;
    var phi_4226_: bool;
    var phi_4231_: f32;
    var phi_4232_: bool;
    var phi_4233_: f32;
    var phi_4234_: bool;
    var phi_4235_: bool;
    var phi_4236_: bool;
    var phi_4237_: f32;
    var phi_4143_: f32;
    var phi_4238_: bool;
    var phi_4239_: bool;
    var phi_4240_: bool;
    var phi_4241_: bool;
    var local_18: bool;
    var phi_4245_: bool;
    var phi_4246_: bool;
    var phi_4250_: bool;
    var phi_4254_: f32;
    var phi_4255_: f32;
    var phi_4257_: type_57;
    var phi_4286_: f32;
    var phi_4293_: f32;
    var phi_4298_: f32;
    var phi_4305_: f32;
    var phi_4310_: f32;
    var phi_4323_: f32;
    var phi_4330_: f32;
    var phi_4335_: f32;
    var phi_4342_: f32;
    var phi_4347_: f32;
    var phi_4352_: f32;
    var phi_4411_: f32;
    var phi_4417_: f32;
    var phi_4422_: f32;
    var phi_4428_: f32;
    var phi_4433_: f32;
    var phi_4445_: f32;
    var phi_4451_: f32;
    var phi_4456_: f32;
    var phi_4462_: f32;
    var phi_4467_: f32;
    var phi_4493_: f32;
    var phi_4500_: f32;
    var phi_4505_: f32;
    var phi_4512_: f32;
    var phi_4517_: f32;
    var phi_4530_: f32;
    var phi_4537_: f32;
    var phi_4542_: f32;
    var phi_4549_: f32;
    var phi_4554_: f32;
    var phi_4559_: f32;
    var phi_4618_: f32;
    var phi_4624_: f32;
    var phi_4629_: f32;
    var phi_4635_: f32;
    var phi_4640_: f32;
    var phi_4652_: f32;
    var phi_4658_: f32;
    var phi_4663_: f32;
    var phi_4669_: f32;
    var phi_4674_: f32;
    var phi_4700_: f32;
    var phi_4707_: f32;
    var phi_4712_: f32;
    var phi_4719_: f32;
    var phi_4724_: f32;
    var phi_4737_: f32;
    var phi_4744_: f32;
    var phi_4749_: f32;
    var phi_4756_: f32;
    var phi_4761_: f32;
    var phi_4766_: f32;
    var phi_4825_: f32;
    var phi_4831_: f32;
    var phi_4836_: f32;
    var phi_4842_: f32;
    var phi_4847_: f32;
    var phi_4859_: f32;
    var phi_4865_: f32;
    var phi_4870_: f32;
    var phi_4876_: f32;
    var phi_4881_: f32;
    var phi_4930_: f32;
    var phi_4936_: f32;
    var phi_4964_: f32;
    var phi_4970_: f32;
    var phi_4975_: u32;
    var phi_4976_: u32;
    var phi_4946_: f32;
    var phi_4952_: f32;
    var phi_4957_: u32;
    var phi_4958_: u32;
    var phi_4977_: u32;
    var phi_4978_: u32;
    var phi_5045_: f32;
    var phi_5054_: f32;
    var phi_5185_: f32;
    var phi_5191_: f32;
    var phi_5198_: f32;
    var phi_5241_: type_29;
    var phi_5244_: bool;
    var phi_5242_: type_29;
    var phi_5267_: type_29;
    var phi_5294_: bool;
    var phi_5295_: bool;
    var phi_5245_: bool;
    var phi_5296_: bool;
    var phi_5297_: bool;
    var local_19: bool;
    var phi_5301_: bool;
    var local_20: bool;
    var phi_5308_: u32;
    var phi_5309_: u32;
    var phi_5310_: bool;
    var phi_5311_: u32;
    var phi_5312_: u32;
    var phi_5313_: bool;
    var phi_5317_: u32;
    var phi_5337_: bool;
    var phi_5338_: bool;
    var phi_5339_: bool;
    var phi_5535_: f32;
    var phi_5542_: f32;
    var phi_5547_: f32;
    var phi_5554_: f32;
    var phi_5559_: f32;
    var phi_5572_: f32;
    var phi_5579_: f32;
    var phi_5584_: f32;
    var phi_5591_: f32;
    var phi_5596_: f32;
    var phi_5601_: f32;
    var phi_5618_: f32;
    var phi_5625_: f32;
    var phi_5630_: f32;
    var phi_5637_: f32;
    var phi_5642_: f32;
    var phi_5656_: f32;
    var phi_5663_: f32;
    var phi_5668_: f32;
    var phi_5675_: f32;
    var phi_5680_: f32;
    var phi_5685_: f32;
    var phi_5702_: f32;
    var phi_5709_: f32;
    var phi_5714_: f32;
    var phi_5721_: f32;
    var phi_5726_: f32;
    var phi_5740_: f32;
    var phi_5747_: f32;
    var phi_5752_: f32;
    var phi_5759_: f32;
    var phi_5764_: f32;
    var phi_5769_: f32;
    var phi_5785_: type_29;
    var phi_5788_: f32;
    var phi_5786_: type_29;
    var phi_5811_: type_29;
    var phi_5985_: bool;
    var phi_5986_: bool;
    var phi_5987_: bool;
    var phi_5988_: bool;
    var phi_5992_: bool;
    var phi_6014_: array<f32, 3>;
    var phi_6015_: bool;
    var phi_6016_: array<f32, 3>;
    var phi_6017_: bool;
    var phi_6185_: f32;
    var phi_6186_: f32;
    var phi_6213_: f32;
    var phi_6214_: f32;
    var phi_6241_: f32;
    var phi_6242_: f32;
    var phi_6278_: type_29;
    var phi_6281_: array<f32, 3>;
    var phi_6279_: type_29;
    var phi_6304_: type_29;
    var phi_6371_: array<f32, 3>;
    var phi_6282_: array<f32, 3>;
    var phi_6372_: array<f32, 3>;
    var phi_6379_: f32;
    var phi_6386_: f32;
    var phi_6394_: f32;
    var phi_6438_: type_27;
    var phi_6441_: f32;
    var phi_6462_: bool;
    var phi_6468_: type_28;
    var phi_6439_: type_27;
    var phi_6482_: type_28;
    var phi_6442_: f32;
    var local_21: f32;
    var phi_6431_: f32;
    var phi_6495_: f32;
    var phi_6504_: type_29;
    var phi_6507_: f32;
    var phi_6505_: type_29;
    var phi_6530_: type_29;
    var phi_6581_: f32;
    var phi_6587_: f32;
    var phi_6600_: bool;
    var phi_6601_: bool;
    var phi_6632_: f32;
    var phi_6633_: f32;
    var phi_6634_: f32;
    var phi_6635_: bool;
    var phi_6639_: bool;
    var phi_6640_: f32;
    var phi_6641_: bool;
    var phi_6642_: bool;
    var phi_6643_: bool;
    var phi_6644_: f32;
    var phi_6645_: bool;
    var phi_6646_: bool;
    var phi_6647_: bool;
    var phi_6508_: f32;
    var phi_6648_: bool;
    var phi_6649_: bool;
    var phi_6650_: bool;
    var phi_6651_: bool;
    var local_22: bool;
    var local_23: f32;
    var local_24: f32;
    var local_25: f32;
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
    var phi_6680_: bool;
    var phi_6681_: f32;
    var phi_6682_: f32;
    var phi_6683_: bool;
    var phi_6684_: bool;
    var phi_6685_: bool;
    var phi_6686_: bool;
    var phi_6687_: bool;
    var phi_6688_: bool;
    var phi_6689_: bool;
    var phi_6690_: f32;
    var phi_6691_: f32;
    var phi_6692_: bool;
    var phi_6693_: bool;
    var phi_6694_: bool;
    var phi_6695_: bool;
    var phi_6696_: bool;
    var phi_6697_: bool;
    var phi_6698_: bool;
    var phi_6699_: bool;
    var phi_6700_: f32;
    var phi_5789_: f32;
    var phi_6701_: bool;
    var phi_6702_: bool;
    var phi_6703_: bool;
    var phi_6704_: bool;
    var phi_6705_: bool;
    var phi_6706_: bool;
    var phi_6707_: bool;
    var phi_6708_: bool;
    var phi_6709_: bool;
    var local_26: bool;
    var phi_6714_: type_56;
    var phi_6715_: bool;
    var phi_6716_: bool;
    var phi_6717_: bool;
    var phi_6718_: bool;
    var phi_6719_: bool;
    var phi_6720_: bool;
    var phi_6721_: bool;
    var phi_6725_: f32;
    var phi_6726_: bool;
    var phi_6727_: bool;
    var phi_6728_: bool;
    var phi_6729_: bool;
    var phi_6730_: bool;
    var phi_6731_: bool;
    var phi_6732_: bool;
    var phi_6737_: type_56;
    var phi_6738_: bool;
    var phi_6739_: bool;
    var phi_6740_: bool;
    var phi_6741_: bool;
    var phi_6742_: bool;
    var phi_6743_: bool;
    var local_27: f32;
    var phi_6748_: type_56;
    var phi_6749_: bool;
    var phi_6750_: bool;
    var phi_6751_: bool;
    var phi_6752_: bool;
    var phi_6753_: bool;
    var local_28: f32;
    var phi_6758_: type_56;
    var phi_6759_: bool;
    var phi_6760_: bool;
    var phi_6761_: bool;
    var phi_6762_: bool;
    var local_29: f32;
    var phi_6767_: type_56;
    var phi_6768_: bool;
    var phi_6769_: bool;
    var phi_6770_: bool;
    var phi_6771_: bool;
    var phi_6775_: type_56;
    var phi_6776_: bool;
    var phi_6777_: bool;
    var phi_6778_: bool;
    var phi_6782_: bool;
    var phi_6783_: bool;
    var phi_6787_: bool;
    var phi_6788_: bool;
    var phi_6792_: bool;
    var phi_6793_: bool;
    var local_30: f32;
    var phi_6798_: type_56;
    var phi_6799_: bool;
    var phi_6803_: type_56;
    var phi_6810_: bool;
    var phi_6811_: f32;
    var phi_6812_: bool;
    var phi_6813_: bool;
    var phi_6814_: bool;
    var phi_6815_: f32;
    var phi_6816_: bool;
    var phi_6817_: bool;
    var phi_6818_: bool;
    var phi_6819_: f32;
    var phi_6820_: bool;
    var phi_6821_: bool;
    var phi_6822_: bool;
    var phi_6823_: bool;
    var phi_6827_: bool;
    var phi_6828_: bool;
    var phi_6829_: bool;
    var phi_6830_: f32;
    var phi_6831_: type_57;
    var phi_6832_: bool;
    var phi_6833_: bool;
    var phi_6834_: bool;
    var phi_6835_: bool;
    var local_31: bool;
    var phi_6840_: type_56;
    var phi_6841_: bool;
    var phi_6842_: bool;
    var local_32: f32;
    var phi_6847_: type_56;
    var phi_6848_: bool;
    var local_33: type_57;
    var phi_6854_: type_56;
    var phi_6855_: bool;
    var phi_6859_: type_56;
    var phi_1327_: f32;
    var phi_1334_: f32;
    var phi_1339_: f32;
    var phi_1346_: f32;
    var phi_1351_: f32;
    var phi_1364_: f32;
    var phi_1371_: f32;
    var phi_1376_: f32;
    var phi_1383_: f32;
    var phi_1388_: f32;
    var phi_1393_: f32;
    var phi_1410_: f32;
    var phi_1417_: f32;
    var phi_1422_: f32;
    var phi_1429_: f32;
    var phi_1434_: f32;
    var phi_1448_: f32;
    var phi_1455_: f32;
    var phi_1460_: f32;
    var phi_1467_: f32;
    var phi_1472_: f32;
    var phi_1477_: f32;
    var phi_1494_: f32;
    var phi_1501_: f32;
    var phi_1506_: f32;
    var phi_1513_: f32;
    var phi_1518_: f32;
    var phi_1532_: f32;
    var phi_1539_: f32;
    var phi_1544_: f32;
    var phi_1551_: f32;
    var phi_1556_: f32;
    var phi_1561_: f32;
    var phi_1577_: type_29;
    var phi_1580_: f32;
    var phi_1578_: type_29;
    var phi_1603_: type_29;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1780_: bool;
    var phi_1784_: bool;
    var phi_1806_: array<f32, 3>;
    var phi_1807_: bool;
    var phi_1808_: array<f32, 3>;
    var phi_1809_: bool;
    var phi_1977_: f32;
    var phi_1978_: f32;
    var phi_2005_: f32;
    var phi_2006_: f32;
    var phi_2033_: f32;
    var phi_2034_: f32;
    var phi_2070_: type_29;
    var phi_2073_: array<f32, 3>;
    var phi_2071_: type_29;
    var phi_2096_: type_29;
    var phi_2163_: array<f32, 3>;
    var phi_2074_: array<f32, 3>;
    var phi_2164_: array<f32, 3>;
    var phi_2171_: f32;
    var phi_2178_: f32;
    var phi_2186_: f32;
    var phi_2230_: type_27;
    var phi_2233_: f32;
    var phi_2254_: bool;
    var phi_2260_: type_28;
    var phi_2231_: type_27;
    var phi_2274_: type_28;
    var phi_2234_: f32;
    var local_34: f32;
    var phi_2223_: f32;
    var phi_2287_: f32;
    var phi_2296_: type_29;
    var phi_2299_: f32;
    var phi_2297_: type_29;
    var phi_2322_: type_29;
    var phi_2373_: f32;
    var phi_2379_: f32;
    var phi_2392_: bool;
    var phi_2393_: bool;
    var phi_2424_: f32;
    var phi_2425_: f32;
    var phi_2426_: f32;
    var phi_2427_: bool;
    var phi_2431_: bool;
    var phi_2432_: f32;
    var phi_2433_: bool;
    var phi_2434_: bool;
    var phi_2435_: bool;
    var phi_2436_: f32;
    var phi_2437_: bool;
    var phi_2438_: bool;
    var phi_2439_: bool;
    var phi_2300_: f32;
    var phi_2440_: bool;
    var phi_2441_: bool;
    var phi_2442_: bool;
    var phi_2443_: bool;
    var local_35: bool;
    var local_36: f32;
    var local_37: f32;
    var local_38: f32;
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
    var phi_2472_: bool;
    var phi_2473_: f32;
    var phi_2474_: f32;
    var phi_2475_: bool;
    var phi_2476_: bool;
    var phi_2477_: bool;
    var phi_2478_: bool;
    var phi_2479_: bool;
    var phi_2480_: bool;
    var phi_2481_: bool;
    var phi_2482_: f32;
    var phi_2483_: f32;
    var phi_2484_: bool;
    var phi_2485_: bool;
    var phi_2486_: bool;
    var phi_2487_: bool;
    var phi_2488_: bool;
    var phi_2489_: bool;
    var phi_2490_: bool;
    var phi_2491_: bool;
    var phi_2492_: f32;
    var phi_1581_: f32;
    var phi_2493_: bool;
    var phi_2494_: bool;
    var phi_2495_: bool;
    var phi_2496_: bool;
    var phi_2497_: bool;
    var phi_2498_: bool;
    var phi_2499_: bool;
    var phi_2500_: bool;
    var phi_2501_: bool;
    var local_39: bool;
    var phi_2506_: type_56;
    var phi_2507_: bool;
    var phi_2508_: bool;
    var phi_2509_: bool;
    var phi_2510_: bool;
    var phi_2511_: bool;
    var phi_2512_: bool;
    var phi_2513_: bool;
    var phi_2517_: f32;
    var phi_2518_: bool;
    var phi_2519_: bool;
    var phi_2520_: bool;
    var phi_2521_: bool;
    var phi_2522_: bool;
    var phi_2523_: bool;
    var phi_2524_: bool;
    var phi_2529_: type_56;
    var phi_2530_: bool;
    var phi_2531_: bool;
    var phi_2532_: bool;
    var phi_2533_: bool;
    var phi_2534_: bool;
    var phi_2535_: bool;
    var local_40: f32;
    var phi_2540_: type_56;
    var phi_2541_: bool;
    var phi_2542_: bool;
    var phi_2543_: bool;
    var phi_2544_: bool;
    var phi_2545_: bool;
    var local_41: f32;
    var phi_2550_: type_56;
    var phi_2551_: bool;
    var phi_2552_: bool;
    var phi_2553_: bool;
    var phi_2554_: bool;
    var local_42: f32;
    var phi_2559_: type_56;
    var phi_2560_: bool;
    var phi_2561_: bool;
    var phi_2562_: bool;
    var phi_2563_: bool;
    var phi_2567_: type_56;
    var phi_2568_: bool;
    var phi_2569_: bool;
    var phi_2570_: bool;
    var phi_2574_: bool;
    var phi_2575_: bool;
    var phi_2579_: bool;
    var phi_2580_: bool;
    var phi_2584_: bool;
    var phi_2585_: bool;
    var local_43: f32;
    var phi_2590_: type_56;
    var phi_2591_: bool;
    var phi_2595_: type_56;
    var phi_2609_: type_29;
    var phi_2610_: type_29;
    var phi_2633_: type_29;
    var phi_2653_: f32;
    var phi_2821_: bool;
    var phi_2822_: bool;
    var phi_2823_: bool;
    var phi_2824_: bool;
    var phi_2828_: bool;
    var phi_2850_: array<f32, 3>;
    var phi_2851_: bool;
    var phi_2852_: array<f32, 3>;
    var phi_2853_: bool;
    var phi_3021_: f32;
    var phi_3022_: f32;
    var phi_3049_: f32;
    var phi_3050_: f32;
    var phi_3077_: f32;
    var phi_3078_: f32;
    var phi_3114_: type_29;
    var phi_3117_: array<f32, 3>;
    var phi_3115_: type_29;
    var phi_3140_: type_29;
    var phi_3207_: array<f32, 3>;
    var phi_3118_: array<f32, 3>;
    var phi_3208_: array<f32, 3>;
    var phi_3240_: type_27;
    var phi_3243_: f32;
    var phi_3264_: bool;
    var phi_3270_: type_28;
    var phi_3241_: type_27;
    var phi_3284_: type_28;
    var phi_3244_: f32;
    var local_44: f32;
    var phi_3233_: f32;
    var phi_3297_: f32;
    var phi_3313_: f32;
    var phi_3320_: f32;
    var phi_3325_: f32;
    var phi_3332_: f32;
    var phi_3337_: f32;
    var phi_3350_: f32;
    var phi_3357_: f32;
    var phi_3362_: f32;
    var phi_3369_: f32;
    var phi_3374_: f32;
    var phi_3379_: f32;
    var phi_3396_: f32;
    var phi_3403_: f32;
    var phi_3408_: f32;
    var phi_3415_: f32;
    var phi_3420_: f32;
    var phi_3434_: f32;
    var phi_3441_: f32;
    var phi_3446_: f32;
    var phi_3453_: f32;
    var phi_3458_: f32;
    var phi_3463_: f32;
    var phi_3480_: f32;
    var phi_3487_: f32;
    var phi_3492_: f32;
    var phi_3499_: f32;
    var phi_3504_: f32;
    var phi_3518_: f32;
    var phi_3525_: f32;
    var phi_3530_: f32;
    var phi_3537_: f32;
    var phi_3542_: f32;
    var phi_3547_: f32;
    var phi_3567_: bool;
    var phi_3568_: bool;
    var phi_3569_: bool;
    var local_45: bool;
    var phi_3574_: type_56;
    var phi_3575_: bool;
    var phi_3580_: type_56;
    var phi_3581_: bool;
    var phi_3583_: type_56;
    var phi_3584_: type_56;
    var phi_3585_: bool;
    var phi_3589_: type_56;
    var phi_6863_: type_56;
    var phi_6864_: type_56;
    var phi_6877_: type_59;
    var phi_6884_: bool;
    var phi_6908_: u32;
    var phi_6912_: type_50;
    var phi_6913_: bool;
    var phi_6914_: bool;
    var phi_6932_: u32;
    var phi_6994_: u32;
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
        phi_233_ = _e125;
    } else {
        phi_233_ = _e127;
    }
    let _e130 = phi_233_;
    let _e131 = (_e130 / 64u);
    if ((_e130 % 64u) > 0u) {
        phi_249_ = (_e131 + 1u);
    } else {
        phi_249_ = _e131;
    }
    let _e136 = phi_249_;
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
            phi_270_ = (_e140 + 1u);
        } else {
            phi_270_ = _e140;
        }
        let _e146 = phi_270_;
        phi_271_ = _e146;
    } else {
        phi_271_ = 0u;
    }
    let _e148 = phi_271_;
    phi_274_ = type_29(0u, _e148);
    loop {
        let _e151 = phi_274_;
        if (_e151.member < _e151.member_1) {
            phi_275_ = type_29((_e151.member + 1u), _e151.member_1);
            phi_298_ = type_29(1u, _e151.member);
        } else {
            phi_275_ = _e151;
            phi_298_ = type_29(0u, type_29().member_1);
        }
        let _e165 = phi_275_;
        let _e167 = phi_298_;
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
                local_15 = type_47(array<array<f32, 3>, 2>(array<f32, 3>((_e193.member[0] - _e195.member[0]), (_e193.member[1] - _e195.member[1]), (_e193.member[2] - _e195.member[2])), array<f32, 3>((_e193.member_1[0] - _e195.member_1[0]), (_e193.member_1[1] - _e195.member_1[1]), (_e193.member_1[2] - _e195.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e201.member[0] - _e195.member[0]), (_e201.member[1] - _e195.member[1]), (_e201.member[2] - _e195.member[2])), array<f32, 3>((_e201.member_1[0] - _e195.member_1[0]), (_e201.member_1[1] - _e195.member_1[1]), (_e201.member_1[2] - _e195.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e203.member[0] - _e195.member[0]), (_e203.member[1] - _e195.member[1]), (_e203.member[2] - _e195.member[2])), array<f32, 3>((_e203.member_1[0] - _e195.member_1[0]), (_e203.member_1[1] - _e195.member_1[1]), (_e203.member_1[2] - _e195.member_1[2]))), (_e233 + _e233));
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
                    phi_737_ = -(_e422[0]);
                } else {
                    phi_737_ = _e422[0];
                }
                let _e429 = phi_737_;
                if (_e422[1] < 0f) {
                    phi_744_ = -(_e422[1]);
                } else {
                    phi_744_ = _e422[1];
                }
                let _e433 = phi_744_;
                if (_e429 > _e433) {
                    phi_749_ = _e429;
                } else {
                    phi_749_ = _e433;
                }
                let _e436 = phi_749_;
                if (_e422[2] < 0f) {
                    phi_756_ = -(_e422[2]);
                } else {
                    phi_756_ = _e422[2];
                }
                let _e440 = phi_756_;
                if (_e436 > _e440) {
                    phi_761_ = _e436;
                } else {
                    phi_761_ = _e440;
                }
                let _e443 = phi_761_;
                let _e446 = local_15.member[1u];
                if (_e446[0] < 0f) {
                    phi_774_ = -(_e446[0]);
                } else {
                    phi_774_ = _e446[0];
                }
                let _e453 = phi_774_;
                if (_e446[1] < 0f) {
                    phi_781_ = -(_e446[1]);
                } else {
                    phi_781_ = _e446[1];
                }
                let _e457 = phi_781_;
                if (_e453 > _e457) {
                    phi_786_ = _e453;
                } else {
                    phi_786_ = _e457;
                }
                let _e460 = phi_786_;
                if (_e446[2] < 0f) {
                    phi_793_ = -(_e446[2]);
                } else {
                    phi_793_ = _e446[2];
                }
                let _e464 = phi_793_;
                if (_e460 > _e464) {
                    phi_798_ = _e460;
                } else {
                    phi_798_ = _e464;
                }
                let _e467 = phi_798_;
                if (_e443 > _e467) {
                    phi_803_ = _e443;
                } else {
                    phi_803_ = _e467;
                }
                let _e470 = phi_803_;
                let _e472 = local_15.member_3;
                let _e473 = (_e470 + _e472);
                let _e476 = local_15.member_1[0u];
                if (_e476[0] < 0f) {
                    phi_820_ = -(_e476[0]);
                } else {
                    phi_820_ = _e476[0];
                }
                let _e483 = phi_820_;
                if (_e476[1] < 0f) {
                    phi_827_ = -(_e476[1]);
                } else {
                    phi_827_ = _e476[1];
                }
                let _e487 = phi_827_;
                if (_e483 > _e487) {
                    phi_832_ = _e483;
                } else {
                    phi_832_ = _e487;
                }
                let _e490 = phi_832_;
                if (_e476[2] < 0f) {
                    phi_839_ = -(_e476[2]);
                } else {
                    phi_839_ = _e476[2];
                }
                let _e494 = phi_839_;
                if (_e490 > _e494) {
                    phi_844_ = _e490;
                } else {
                    phi_844_ = _e494;
                }
                let _e497 = phi_844_;
                let _e500 = local_15.member_1[1u];
                if (_e500[0] < 0f) {
                    phi_858_ = -(_e500[0]);
                } else {
                    phi_858_ = _e500[0];
                }
                let _e507 = phi_858_;
                if (_e500[1] < 0f) {
                    phi_865_ = -(_e500[1]);
                } else {
                    phi_865_ = _e500[1];
                }
                let _e511 = phi_865_;
                if (_e507 > _e511) {
                    phi_870_ = _e507;
                } else {
                    phi_870_ = _e511;
                }
                let _e514 = phi_870_;
                if (_e500[2] < 0f) {
                    phi_877_ = -(_e500[2]);
                } else {
                    phi_877_ = _e500[2];
                }
                let _e518 = phi_877_;
                if (_e514 > _e518) {
                    phi_882_ = _e514;
                } else {
                    phi_882_ = _e518;
                }
                let _e521 = phi_882_;
                if (_e497 > _e521) {
                    phi_887_ = _e497;
                } else {
                    phi_887_ = _e521;
                }
                let _e524 = phi_887_;
                let _e526 = local_15.member_3;
                let _e527 = (_e524 + _e526);
                let _e530 = local_15.member_2[0u];
                if (_e530[0] < 0f) {
                    phi_904_ = -(_e530[0]);
                } else {
                    phi_904_ = _e530[0];
                }
                let _e537 = phi_904_;
                if (_e530[1] < 0f) {
                    phi_911_ = -(_e530[1]);
                } else {
                    phi_911_ = _e530[1];
                }
                let _e541 = phi_911_;
                if (_e537 > _e541) {
                    phi_916_ = _e537;
                } else {
                    phi_916_ = _e541;
                }
                let _e544 = phi_916_;
                if (_e530[2] < 0f) {
                    phi_923_ = -(_e530[2]);
                } else {
                    phi_923_ = _e530[2];
                }
                let _e548 = phi_923_;
                if (_e544 > _e548) {
                    phi_928_ = _e544;
                } else {
                    phi_928_ = _e548;
                }
                let _e551 = phi_928_;
                let _e554 = local_15.member_2[1u];
                if (_e554[0] < 0f) {
                    phi_942_ = -(_e554[0]);
                } else {
                    phi_942_ = _e554[0];
                }
                let _e561 = phi_942_;
                if (_e554[1] < 0f) {
                    phi_949_ = -(_e554[1]);
                } else {
                    phi_949_ = _e554[1];
                }
                let _e565 = phi_949_;
                if (_e561 > _e565) {
                    phi_954_ = _e561;
                } else {
                    phi_954_ = _e565;
                }
                let _e568 = phi_954_;
                if (_e554[2] < 0f) {
                    phi_961_ = -(_e554[2]);
                } else {
                    phi_961_ = _e554[2];
                }
                let _e572 = phi_961_;
                if (_e568 > _e572) {
                    phi_966_ = _e568;
                } else {
                    phi_966_ = _e572;
                }
                let _e575 = phi_966_;
                if (_e551 > _e575) {
                    phi_971_ = _e551;
                } else {
                    phi_971_ = _e575;
                }
                let _e578 = phi_971_;
                let _e580 = local_15.member_3;
                let _e581 = (_e578 + _e580);
                let _e583 = ((_e527 * 8f) * _e581);
                let _e590 = local_15.member_3;
                if (_e279 < 0f) {
                    phi_1002_ = -(_e279);
                } else {
                    phi_1002_ = _e279;
                }
                let _e607 = phi_1002_;
                if (_e282 < 0f) {
                    phi_1008_ = -(_e282);
                } else {
                    phi_1008_ = _e282;
                }
                let _e611 = phi_1008_;
                if (_e285 < 0f) {
                    phi_1015_ = -(_e285);
                } else {
                    phi_1015_ = _e285;
                }
                let _e616 = phi_1015_;
                let _e617 = ((_e607 + _e611) + _e616);
                if (_e300 < 0f) {
                    phi_1022_ = -(_e300);
                } else {
                    phi_1022_ = _e300;
                }
                let _e621 = phi_1022_;
                if (_e303 < 0f) {
                    phi_1028_ = -(_e303);
                } else {
                    phi_1028_ = _e303;
                }
                let _e625 = phi_1028_;
                if (_e306 < 0f) {
                    phi_1035_ = -(_e306);
                } else {
                    phi_1035_ = _e306;
                }
                let _e630 = phi_1035_;
                let _e631 = ((_e621 + _e625) + _e630);
                if (_e617 > _e631) {
                    phi_1041_ = _e617;
                } else {
                    phi_1041_ = _e631;
                }
                let _e634 = phi_1041_;
                if (_e349 < 0f) {
                    phi_1047_ = -(_e349);
                } else {
                    phi_1047_ = _e349;
                }
                let _e638 = phi_1047_;
                if (_e350 < 0f) {
                    phi_1053_ = -(_e350);
                } else {
                    phi_1053_ = _e350;
                }
                let _e642 = phi_1053_;
                if (_e351 < 0f) {
                    phi_1060_ = -(_e351);
                } else {
                    phi_1060_ = _e351;
                }
                let _e647 = phi_1060_;
                let _e649 = (((_e638 + _e642) + _e647) * 0.5f);
                if (_e634 > _e649) {
                    phi_1067_ = _e634;
                } else {
                    phi_1067_ = _e649;
                }
                let _e652 = phi_1067_;
                let _e657 = local_15.member_3;
                let _e669 = (((((_e473 * 8f) * _e583) * (0.000000059604645f * (490f / 64f))) + ((_e590 * 19f) * ((_e473 * (_e527 + _e581)) + (_e527 * _e581)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e473) * ((1f + _e527) * (1f + _e581)))));
                let _e670 = (_e362 * 3f);
                let _e671 = (_e419 * 3f);
                if (_e670 < _e671) {
                    phi_1091_ = _e670;
                } else {
                    phi_1091_ = _e671;
                }
                let _e674 = phi_1091_;
                if (_e385 < _e408) {
                    phi_1096_ = _e385;
                } else {
                    phi_1096_ = _e408;
                }
                let _e677 = phi_1096_;
                if (_e674 < _e677) {
                    phi_1101_ = _e674;
                } else {
                    phi_1101_ = _e677;
                }
                let _e680 = phi_1101_;
                if (_e670 > _e671) {
                    phi_1106_ = _e670;
                } else {
                    phi_1106_ = _e671;
                }
                let _e683 = phi_1106_;
                if (_e385 > _e408) {
                    phi_1111_ = _e385;
                } else {
                    phi_1111_ = _e408;
                }
                let _e686 = phi_1111_;
                if (_e683 > _e686) {
                    phi_1116_ = _e683;
                } else {
                    phi_1116_ = _e686;
                }
                let _e689 = phi_1116_;
                let _e694 = -(_e689);
                if (_e680 > _e694) {
                    phi_1126_ = _e680;
                } else {
                    phi_1126_ = _e694;
                }
                let _e697 = phi_1126_;
                if ((_e697 - (_e669 + ((_e264 * (((_e652 + (_e583 * (0.000000059604645f * 4f))) + ((_e657 * 6f) * (_e527 + _e581))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e527) * (1f + _e581))))) * (3f * 1.0001f)))) > 0f) {
                    phi_6864_ = type_56(0u, type_56().member_1);
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
                            phi_1327_ = -(_e3051[0]);
                        } else {
                            phi_1327_ = _e3051[0];
                        }
                        let _e3058 = phi_1327_;
                        if (_e3051[1] < 0f) {
                            phi_1334_ = -(_e3051[1]);
                        } else {
                            phi_1334_ = _e3051[1];
                        }
                        let _e3062 = phi_1334_;
                        if (_e3058 > _e3062) {
                            phi_1339_ = _e3058;
                        } else {
                            phi_1339_ = _e3062;
                        }
                        let _e3065 = phi_1339_;
                        if (_e3051[2] < 0f) {
                            phi_1346_ = -(_e3051[2]);
                        } else {
                            phi_1346_ = _e3051[2];
                        }
                        let _e3069 = phi_1346_;
                        if (_e3065 > _e3069) {
                            phi_1351_ = _e3065;
                        } else {
                            phi_1351_ = _e3069;
                        }
                        let _e3072 = phi_1351_;
                        let _e3075 = local_15.member[1u];
                        if (_e3075[0] < 0f) {
                            phi_1364_ = -(_e3075[0]);
                        } else {
                            phi_1364_ = _e3075[0];
                        }
                        let _e3082 = phi_1364_;
                        if (_e3075[1] < 0f) {
                            phi_1371_ = -(_e3075[1]);
                        } else {
                            phi_1371_ = _e3075[1];
                        }
                        let _e3086 = phi_1371_;
                        if (_e3082 > _e3086) {
                            phi_1376_ = _e3082;
                        } else {
                            phi_1376_ = _e3086;
                        }
                        let _e3089 = phi_1376_;
                        if (_e3075[2] < 0f) {
                            phi_1383_ = -(_e3075[2]);
                        } else {
                            phi_1383_ = _e3075[2];
                        }
                        let _e3093 = phi_1383_;
                        if (_e3089 > _e3093) {
                            phi_1388_ = _e3089;
                        } else {
                            phi_1388_ = _e3093;
                        }
                        let _e3096 = phi_1388_;
                        if (_e3072 > _e3096) {
                            phi_1393_ = _e3072;
                        } else {
                            phi_1393_ = _e3096;
                        }
                        let _e3099 = phi_1393_;
                        let _e3101 = local_15.member_3;
                        let _e3105 = local_15.member_1[0u];
                        if (_e3105[0] < 0f) {
                            phi_1410_ = -(_e3105[0]);
                        } else {
                            phi_1410_ = _e3105[0];
                        }
                        let _e3112 = phi_1410_;
                        if (_e3105[1] < 0f) {
                            phi_1417_ = -(_e3105[1]);
                        } else {
                            phi_1417_ = _e3105[1];
                        }
                        let _e3116 = phi_1417_;
                        if (_e3112 > _e3116) {
                            phi_1422_ = _e3112;
                        } else {
                            phi_1422_ = _e3116;
                        }
                        let _e3119 = phi_1422_;
                        if (_e3105[2] < 0f) {
                            phi_1429_ = -(_e3105[2]);
                        } else {
                            phi_1429_ = _e3105[2];
                        }
                        let _e3123 = phi_1429_;
                        if (_e3119 > _e3123) {
                            phi_1434_ = _e3119;
                        } else {
                            phi_1434_ = _e3123;
                        }
                        let _e3126 = phi_1434_;
                        let _e3129 = local_15.member_1[1u];
                        if (_e3129[0] < 0f) {
                            phi_1448_ = -(_e3129[0]);
                        } else {
                            phi_1448_ = _e3129[0];
                        }
                        let _e3136 = phi_1448_;
                        if (_e3129[1] < 0f) {
                            phi_1455_ = -(_e3129[1]);
                        } else {
                            phi_1455_ = _e3129[1];
                        }
                        let _e3140 = phi_1455_;
                        if (_e3136 > _e3140) {
                            phi_1460_ = _e3136;
                        } else {
                            phi_1460_ = _e3140;
                        }
                        let _e3143 = phi_1460_;
                        if (_e3129[2] < 0f) {
                            phi_1467_ = -(_e3129[2]);
                        } else {
                            phi_1467_ = _e3129[2];
                        }
                        let _e3147 = phi_1467_;
                        if (_e3143 > _e3147) {
                            phi_1472_ = _e3143;
                        } else {
                            phi_1472_ = _e3147;
                        }
                        let _e3150 = phi_1472_;
                        if (_e3126 > _e3150) {
                            phi_1477_ = _e3126;
                        } else {
                            phi_1477_ = _e3150;
                        }
                        let _e3153 = phi_1477_;
                        let _e3155 = local_15.member_3;
                        let _e3159 = local_15.member_2[0u];
                        if (_e3159[0] < 0f) {
                            phi_1494_ = -(_e3159[0]);
                        } else {
                            phi_1494_ = _e3159[0];
                        }
                        let _e3166 = phi_1494_;
                        if (_e3159[1] < 0f) {
                            phi_1501_ = -(_e3159[1]);
                        } else {
                            phi_1501_ = _e3159[1];
                        }
                        let _e3170 = phi_1501_;
                        if (_e3166 > _e3170) {
                            phi_1506_ = _e3166;
                        } else {
                            phi_1506_ = _e3170;
                        }
                        let _e3173 = phi_1506_;
                        if (_e3159[2] < 0f) {
                            phi_1513_ = -(_e3159[2]);
                        } else {
                            phi_1513_ = _e3159[2];
                        }
                        let _e3177 = phi_1513_;
                        if (_e3173 > _e3177) {
                            phi_1518_ = _e3173;
                        } else {
                            phi_1518_ = _e3177;
                        }
                        let _e3180 = phi_1518_;
                        let _e3183 = local_15.member_2[1u];
                        if (_e3183[0] < 0f) {
                            phi_1532_ = -(_e3183[0]);
                        } else {
                            phi_1532_ = _e3183[0];
                        }
                        let _e3190 = phi_1532_;
                        if (_e3183[1] < 0f) {
                            phi_1539_ = -(_e3183[1]);
                        } else {
                            phi_1539_ = _e3183[1];
                        }
                        let _e3194 = phi_1539_;
                        if (_e3190 > _e3194) {
                            phi_1544_ = _e3190;
                        } else {
                            phi_1544_ = _e3194;
                        }
                        let _e3197 = phi_1544_;
                        if (_e3183[2] < 0f) {
                            phi_1551_ = -(_e3183[2]);
                        } else {
                            phi_1551_ = _e3183[2];
                        }
                        let _e3201 = phi_1551_;
                        if (_e3197 > _e3201) {
                            phi_1556_ = _e3197;
                        } else {
                            phi_1556_ = _e3201;
                        }
                        let _e3204 = phi_1556_;
                        if (_e3180 > _e3204) {
                            phi_1561_ = _e3180;
                        } else {
                            phi_1561_ = _e3204;
                        }
                        let _e3207 = phi_1561_;
                        let _e3209 = local_15.member_3;
                        let _e3216 = local_15.member_3;
                        phi_1577_ = type_29(0u, 48u);
                        phi_1580_ = 0f;
                        loop {
                            let _e3222 = phi_1577_;
                            let _e3224 = phi_1580_;
                            local_82 = _e3224;
                            local_40 = _e3224;
                            local_41 = _e3224;
                            local_42 = _e3224;
                            local_43 = _e3224;
                            if (_e3222.member < _e3222.member_1) {
                                phi_1578_ = type_29((_e3222.member + 1u), _e3222.member_1);
                                phi_1603_ = type_29(1u, _e3222.member);
                            } else {
                                phi_1578_ = _e3222;
                                phi_1603_ = type_29(0u, type_29().member_1);
                            }
                            let _e3238 = phi_1578_;
                            let _e3240 = phi_1603_;
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
                                        phi_1777_ = ((_e3338 + _e3342) <= 1f);
                                        phi_1778_ = false;
                                    } else {
                                        phi_1777_ = bool();
                                        phi_1778_ = true;
                                    }
                                    let _e3348 = phi_1777_;
                                    let _e3350 = phi_1778_;
                                    phi_1779_ = _e3348;
                                    phi_1780_ = _e3350;
                                } else {
                                    phi_1779_ = bool();
                                    phi_1780_ = true;
                                }
                                let _e3352 = phi_1779_;
                                let _e3354 = phi_1780_;
                                if _e3354 {
                                    phi_1784_ = false;
                                } else {
                                    phi_1784_ = _e3352;
                                }
                                let _e3356 = phi_1784_;
                                if (_e3334 > 0f) {
                                    if _e3356 {
                                        phi_1806_ = array<f32, 3>((_e3262 - ((_e3283 * _e3338) + (_e3304 * _e3342))), (_e3263 - ((_e3284 * _e3338) + (_e3305 * _e3342))), (_e3264 - ((_e3285 * _e3338) + (_e3306 * _e3342))));
                                        phi_1807_ = false;
                                    } else {
                                        phi_1806_ = array<f32, 3>();
                                        phi_1807_ = true;
                                    }
                                    let _e3372 = phi_1806_;
                                    let _e3374 = phi_1807_;
                                    phi_1808_ = _e3372;
                                    phi_1809_ = _e3374;
                                } else {
                                    phi_1808_ = array<f32, 3>();
                                    phi_1809_ = true;
                                }
                                let _e3376 = phi_1808_;
                                let _e3378 = phi_1809_;
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
                                            phi_1977_ = _e3395;
                                        } else {
                                            phi_1977_ = 1f;
                                        }
                                        let _e3399 = phi_1977_;
                                        phi_1978_ = _e3399;
                                    } else {
                                        phi_1978_ = 0f;
                                    }
                                    let _e3401 = phi_1978_;
                                    let _e3405 = (_e3379 - (_e3382 * _e3401));
                                    let _e3406 = (_e3380 - (_e3383 * _e3401));
                                    let _e3407 = (_e3381 - (_e3384 * _e3401));
                                    let _e3418 = ((((_e3262 * _e3283) + (_e3263 * _e3284)) + (_e3264 * _e3285)) / (((_e3283 * _e3283) + (_e3284 * _e3284)) + (_e3285 * _e3285)));
                                    if (_e3418 > 0f) {
                                        if (_e3418 < 1f) {
                                            phi_2005_ = _e3418;
                                        } else {
                                            phi_2005_ = 1f;
                                        }
                                        let _e3422 = phi_2005_;
                                        phi_2006_ = _e3422;
                                    } else {
                                        phi_2006_ = 0f;
                                    }
                                    let _e3424 = phi_2006_;
                                    let _e3441 = ((((_e3262 * _e3304) + (_e3263 * _e3305)) + (_e3264 * _e3306)) / (((_e3304 * _e3304) + (_e3305 * _e3305)) + (_e3306 * _e3306)));
                                    if (_e3441 > 0f) {
                                        if (_e3441 < 1f) {
                                            phi_2033_ = _e3441;
                                        } else {
                                            phi_2033_ = 1f;
                                        }
                                        let _e3445 = phi_2033_;
                                        phi_2034_ = _e3445;
                                    } else {
                                        phi_2034_ = 0f;
                                    }
                                    let _e3447 = phi_2034_;
                                    local_11[0u] = array<f32, 3>((_e3262 - (_e3283 * _e3424)), (_e3263 - (_e3284 * _e3424)), (_e3264 - (_e3285 * _e3424)));
                                    local_11[1u] = array<f32, 3>((_e3262 - (_e3304 * _e3447)), (_e3263 - (_e3305 * _e3447)), (_e3264 - (_e3306 * _e3447)));
                                    local_11[2u] = array<f32, 3>(_e3405, _e3406, _e3407);
                                    local_11[3u] = array<f32, 3>(_e3405, _e3406, _e3407);
                                    let _e3463 = local_11[0u];
                                    phi_2070_ = type_29(1u, 4u);
                                    phi_2073_ = array<f32, 3>(_e3463[0], _e3463[1], _e3463[2]);
                                    loop {
                                        let _e3469 = phi_2070_;
                                        let _e3471 = phi_2073_;
                                        local_69 = _e3471;
                                        if (_e3469.member < _e3469.member_1) {
                                            phi_2071_ = type_29((_e3469.member + 1u), _e3469.member_1);
                                            phi_2096_ = type_29(1u, _e3469.member);
                                        } else {
                                            phi_2071_ = _e3469;
                                            phi_2096_ = type_29(0u, type_29().member_1);
                                        }
                                        let _e3485 = phi_2071_;
                                        let _e3487 = phi_2096_;
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
                                                phi_2163_ = array<f32, 3>(_e3523[0], _e3523[1], _e3523[2]);
                                            } else {
                                                phi_2163_ = _e3471;
                                            }
                                            let _e3529 = phi_2163_;
                                            phi_2074_ = _e3529;
                                        } else {
                                            phi_2074_ = array<f32, 3>();
                                        }
                                        let _e3531 = phi_2074_;
                                        continue;
                                        continuing {
                                            phi_2070_ = _e3485;
                                            phi_2073_ = _e3531;
                                            break if !(_e3491);
                                        }
                                    }
                                    let _e5300 = local_69;
                                    phi_2164_ = _e5300;
                                } else {
                                    phi_2164_ = _e3376;
                                }
                                let _e3534 = phi_2164_;
                                if (_e3534[0] < 0f) {
                                    phi_2171_ = -(_e3534[0]);
                                } else {
                                    phi_2171_ = _e3534[0];
                                }
                                let _e3539 = phi_2171_;
                                if (_e3534[1] < 0f) {
                                    phi_2178_ = -(_e3534[1]);
                                } else {
                                    phi_2178_ = _e3534[1];
                                }
                                let _e3544 = phi_2178_;
                                if (_e3534[2] < 0f) {
                                    phi_2186_ = -(_e3534[2]);
                                } else {
                                    phi_2186_ = _e3534[2];
                                }
                                let _e3550 = phi_2186_;
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
                                                phi_2223_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2223_ = 0f;
                                            }
                                            let _e3626 = phi_2223_;
                                            phi_2287_ = _e3626;
                                        } else {
                                            phi_2230_ = type_27(0i, 5i);
                                            phi_2233_ = bitcast<f32>(((bitcast<u32>(_e3567) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3575 = phi_2230_;
                                                let _e3577 = phi_2233_;
                                                local_34 = _e3577;
                                                if (_e3575.member < _e3575.member_1) {
                                                    let _e3585 = (_e3575.member + 1i);
                                                    if ((false == (_e3585 > _e3575.member)) != false) {
                                                        phi_2254_ = true;
                                                    } else {
                                                        phi_2254_ = false;
                                                    }
                                                    let _e3590 = phi_2254_;
                                                    if _e3590 {
                                                        phi_2260_ = type_28(0u, type_28().member_1);
                                                    } else {
                                                        phi_2260_ = type_28(1u, _e3585);
                                                    }
                                                    let _e3596 = phi_2260_;
                                                    if (bitcast<i32>(_e3596.member) != 0i) {
                                                    } else {
                                                        return;
                                                    }
                                                    phi_2231_ = type_27(_e3596.member_1, _e3575.member_1);
                                                    phi_2274_ = type_28(1u, _e3575.member);
                                                } else {
                                                    phi_2231_ = _e3575;
                                                    phi_2274_ = type_28(0u, type_28().member_1);
                                                }
                                                let _e3606 = phi_2231_;
                                                let _e3608 = phi_2274_;
                                                let _e3611 = (bitcast<i32>(_e3608.member) != 0i);
                                                if _e3611 {
                                                    phi_2234_ = (0.5f * (_e3577 + (_e3567 / _e3577)));
                                                } else {
                                                    phi_2234_ = f32();
                                                }
                                                let _e3616 = phi_2234_;
                                                continue;
                                                continuing {
                                                    phi_2230_ = _e3606;
                                                    phi_2233_ = _e3616;
                                                    break if !(_e3611);
                                                }
                                            }
                                            let _e3621 = local_34;
                                            phi_2287_ = (_e3621 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3628 = phi_2287_;
                                        phi_2296_ = type_29(0u, 4u);
                                        phi_2299_ = 2f;
                                        loop {
                                            let _e3636 = phi_2296_;
                                            let _e3638 = phi_2299_;
                                            local_36 = _e3638;
                                            local_37 = _e3638;
                                            local_38 = _e3638;
                                            local_72 = _e3638;
                                            local_73 = _e3638;
                                            if (_e3636.member < _e3636.member_1) {
                                                phi_2297_ = type_29((_e3636.member + 1u), _e3636.member_1);
                                                phi_2322_ = type_29(1u, _e3636.member);
                                            } else {
                                                phi_2297_ = _e3636;
                                                phi_2322_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e3652 = phi_2297_;
                                            let _e3654 = phi_2322_;
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
                                                    phi_2373_ = -(_e3669);
                                                } else {
                                                    phi_2373_ = _e3669;
                                                }
                                                let _e3684 = phi_2373_;
                                                if (_e3680 < 0f) {
                                                    phi_2379_ = -(_e3680);
                                                } else {
                                                    phi_2379_ = _e3680;
                                                }
                                                let _e3688 = phi_2379_;
                                                let _e3692 = (((((((((_e3099 + _e3101) + (_e3153 + _e3155)) + (_e3207 + _e3209)) * (0.000000059604645f * 16f)) + (_e3216 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e264 * _e3628) * (1f + (0.000000059604645f * 8f)))) + ((_e3684 + _e3688) * (0.000000059604645f * 8f)));
                                                if (_e3669 > _e3692) {
                                                    if (_e3680 > _e3692) {
                                                        phi_2392_ = false;
                                                    } else {
                                                        phi_2392_ = true;
                                                    }
                                                    let _e3696 = phi_2392_;
                                                    phi_2393_ = _e3696;
                                                } else {
                                                    phi_2393_ = true;
                                                }
                                                let _e3698 = phi_2393_;
                                                if _e3698 {
                                                    if ((_e3669 + ((_e3680 - _e3669) * _e3224)) > _e3692) {
                                                        if (_e3680 < _e3669) {
                                                            let _e3706 = ((_e3669 - _e3680) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                            if _e3706 {
                                                                let _e3712 = (((_e3669 - _e3692) / (_e3669 - _e3680)) * (1f - (0.000000059604645f * 16f)));
                                                                if (_e3638 < _e3712) {
                                                                    phi_2424_ = _e3638;
                                                                } else {
                                                                    phi_2424_ = _e3712;
                                                                }
                                                                let _e3715 = phi_2424_;
                                                                phi_2425_ = _e3715;
                                                            } else {
                                                                phi_2425_ = f32();
                                                            }
                                                            let _e3717 = phi_2425_;
                                                            phi_2426_ = _e3717;
                                                            phi_2427_ = _e3706;
                                                        } else {
                                                            phi_2426_ = _e3638;
                                                            phi_2427_ = true;
                                                        }
                                                        let _e3719 = phi_2426_;
                                                        let _e3721 = phi_2427_;
                                                        if _e3721 {
                                                            phi_2431_ = false;
                                                        } else {
                                                            phi_2431_ = true;
                                                        }
                                                        let _e3723 = phi_2431_;
                                                        phi_2432_ = _e3719;
                                                        phi_2433_ = _e3721;
                                                        phi_2434_ = _e3723;
                                                        phi_2435_ = false;
                                                    } else {
                                                        phi_2432_ = f32();
                                                        phi_2433_ = false;
                                                        phi_2434_ = false;
                                                        phi_2435_ = true;
                                                    }
                                                    let _e3725 = phi_2432_;
                                                    let _e3727 = phi_2433_;
                                                    let _e3729 = phi_2434_;
                                                    let _e3731 = phi_2435_;
                                                    phi_2436_ = _e3725;
                                                    phi_2437_ = _e3727;
                                                    phi_2438_ = _e3729;
                                                    phi_2439_ = _e3731;
                                                } else {
                                                    phi_2436_ = _e3638;
                                                    phi_2437_ = true;
                                                    phi_2438_ = false;
                                                    phi_2439_ = false;
                                                }
                                                let _e3733 = phi_2436_;
                                                let _e3735 = phi_2437_;
                                                let _e3737 = phi_2438_;
                                                let _e3739 = phi_2439_;
                                                phi_2300_ = _e3733;
                                                phi_2440_ = _e3735;
                                                phi_2441_ = false;
                                                phi_2442_ = _e3737;
                                                phi_2443_ = _e3739;
                                            } else {
                                                phi_2300_ = f32();
                                                phi_2440_ = false;
                                                phi_2441_ = true;
                                                phi_2442_ = false;
                                                phi_2443_ = false;
                                            }
                                            let _e3741 = phi_2300_;
                                            let _e3743 = phi_2440_;
                                            let _e3745 = phi_2441_;
                                            let _e3747 = phi_2442_;
                                            let _e3749 = phi_2443_;
                                            local_35 = _e3745;
                                            local_70 = _e3747;
                                            local_71 = _e3749;
                                            continue;
                                            continuing {
                                                phi_2296_ = _e3652;
                                                phi_2299_ = _e3741;
                                                break if !(_e3743);
                                            }
                                        }
                                        let _e3752 = local_35;
                                        if _e3752 {
                                            let _e3754 = local_36;
                                            let _e3755 = (_e3754 > 1f);
                                            if _e3755 {
                                                phi_2464_ = false;
                                                phi_2465_ = false;
                                                phi_2466_ = false;
                                            } else {
                                                let _e3757 = local_37;
                                                if (_e3757 > _e3224) {
                                                    let _e3760 = local_38;
                                                    let _e3762 = ((_e3760 - _e3224) < 0.00000000023283064f);
                                                    if _e3762 {
                                                        phi_2460_ = false;
                                                    } else {
                                                        phi_2460_ = true;
                                                    }
                                                    let _e3764 = phi_2460_;
                                                    phi_2461_ = _e3764;
                                                    phi_2462_ = _e3762;
                                                    phi_2463_ = false;
                                                } else {
                                                    phi_2461_ = false;
                                                    phi_2462_ = false;
                                                    phi_2463_ = true;
                                                }
                                                let _e3766 = phi_2461_;
                                                let _e3768 = phi_2462_;
                                                let _e3770 = phi_2463_;
                                                phi_2464_ = _e3766;
                                                phi_2465_ = _e3768;
                                                phi_2466_ = _e3770;
                                            }
                                            let _e3772 = phi_2464_;
                                            let _e3774 = phi_2465_;
                                            let _e3776 = phi_2466_;
                                            phi_2467_ = _e3772;
                                            phi_2468_ = _e3755;
                                            phi_2469_ = _e3774;
                                            phi_2470_ = _e3776;
                                            phi_2471_ = false;
                                            phi_2472_ = false;
                                        } else {
                                            phi_2467_ = false;
                                            phi_2468_ = false;
                                            phi_2469_ = false;
                                            phi_2470_ = false;
                                            let _e5357 = local_70;
                                            phi_2471_ = _e5357;
                                            let _e5360 = local_71;
                                            phi_2472_ = _e5360;
                                        }
                                        let _e3778 = phi_2467_;
                                        let _e3780 = phi_2468_;
                                        let _e3782 = phi_2469_;
                                        let _e3784 = phi_2470_;
                                        let _e3786 = phi_2471_;
                                        let _e3788 = phi_2472_;
                                        let _e5363 = local_72;
                                        phi_2473_ = _e5363;
                                        let _e5366 = local_73;
                                        phi_2474_ = _e5366;
                                        phi_2475_ = _e3778;
                                        phi_2476_ = _e3780;
                                        phi_2477_ = _e3782;
                                        phi_2478_ = _e3784;
                                        phi_2479_ = _e3786;
                                        phi_2480_ = _e3788;
                                        phi_2481_ = false;
                                    } else {
                                        phi_2473_ = f32();
                                        phi_2474_ = f32();
                                        phi_2475_ = false;
                                        phi_2476_ = false;
                                        phi_2477_ = false;
                                        phi_2478_ = false;
                                        phi_2479_ = false;
                                        phi_2480_ = false;
                                        phi_2481_ = true;
                                    }
                                    let _e3790 = phi_2473_;
                                    let _e3792 = phi_2474_;
                                    let _e3794 = phi_2475_;
                                    let _e3796 = phi_2476_;
                                    let _e3798 = phi_2477_;
                                    let _e3800 = phi_2478_;
                                    let _e3802 = phi_2479_;
                                    let _e3804 = phi_2480_;
                                    let _e3806 = phi_2481_;
                                    phi_2482_ = _e3790;
                                    phi_2483_ = _e3792;
                                    phi_2484_ = _e3794;
                                    phi_2485_ = _e3796;
                                    phi_2486_ = _e3798;
                                    phi_2487_ = _e3800;
                                    phi_2488_ = _e3802;
                                    phi_2489_ = _e3804;
                                    phi_2490_ = _e3806;
                                    phi_2491_ = false;
                                } else {
                                    phi_2482_ = f32();
                                    phi_2483_ = f32();
                                    phi_2484_ = false;
                                    phi_2485_ = false;
                                    phi_2486_ = false;
                                    phi_2487_ = false;
                                    phi_2488_ = false;
                                    phi_2489_ = false;
                                    phi_2490_ = false;
                                    phi_2491_ = true;
                                }
                                let _e3808 = phi_2482_;
                                let _e3810 = phi_2483_;
                                let _e3812 = phi_2484_;
                                let _e3814 = phi_2485_;
                                let _e3816 = phi_2486_;
                                let _e3818 = phi_2487_;
                                let _e3820 = phi_2488_;
                                let _e3822 = phi_2489_;
                                let _e3824 = phi_2490_;
                                let _e3826 = phi_2491_;
                                phi_2492_ = _e3808;
                                phi_1581_ = _e3810;
                                phi_2493_ = _e3812;
                                phi_2494_ = _e3814;
                                phi_2495_ = _e3816;
                                phi_2496_ = false;
                                phi_2497_ = _e3818;
                                phi_2498_ = _e3820;
                                phi_2499_ = _e3822;
                                phi_2500_ = _e3824;
                                phi_2501_ = _e3826;
                            } else {
                                phi_2492_ = f32();
                                phi_1581_ = f32();
                                phi_2493_ = false;
                                phi_2494_ = false;
                                phi_2495_ = false;
                                phi_2496_ = true;
                                phi_2497_ = false;
                                phi_2498_ = false;
                                phi_2499_ = false;
                                phi_2500_ = false;
                                phi_2501_ = false;
                            }
                            let _e3828 = phi_2492_;
                            let _e3830 = phi_1581_;
                            let _e3832 = phi_2493_;
                            let _e3834 = phi_2494_;
                            let _e3836 = phi_2495_;
                            let _e3838 = phi_2496_;
                            let _e3840 = phi_2497_;
                            let _e3842 = phi_2498_;
                            let _e3844 = phi_2499_;
                            let _e3846 = phi_2500_;
                            let _e3848 = phi_2501_;
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
                                phi_1577_ = _e3238;
                                phi_1580_ = _e3830;
                                break if !(_e3832);
                            }
                        }
                        let _e3851 = local_39;
                        if _e3851 {
                            phi_2506_ = type_56(0u, type_56().member_1);
                            phi_2507_ = false;
                            phi_2508_ = false;
                            phi_2509_ = false;
                            phi_2510_ = false;
                            phi_2511_ = false;
                            phi_2512_ = false;
                            phi_2513_ = false;
                        } else {
                            phi_2506_ = type_56();
                            let _e5399 = local_74;
                            phi_2507_ = _e5399;
                            let _e5402 = local_75;
                            phi_2508_ = _e5402;
                            let _e5405 = local_76;
                            phi_2509_ = _e5405;
                            let _e5408 = local_77;
                            phi_2510_ = _e5408;
                            let _e5411 = local_78;
                            phi_2511_ = _e5411;
                            let _e5414 = local_79;
                            phi_2512_ = _e5414;
                            let _e5417 = local_80;
                            phi_2513_ = _e5417;
                        }
                        let _e3856 = phi_2506_;
                        let _e3858 = phi_2507_;
                        let _e3860 = phi_2508_;
                        let _e3862 = phi_2509_;
                        let _e3864 = phi_2510_;
                        let _e3866 = phi_2511_;
                        let _e3868 = phi_2512_;
                        let _e3870 = phi_2513_;
                        if _e3858 {
                            let _e5420 = local_81;
                            phi_2517_ = _e5420;
                            phi_2518_ = true;
                            phi_2519_ = false;
                            phi_2520_ = false;
                            phi_2521_ = false;
                            phi_2522_ = false;
                            phi_2523_ = false;
                            phi_2524_ = false;
                        } else {
                            let _e5422 = local_82;
                            phi_2517_ = _e5422;
                            phi_2518_ = _e3860;
                            phi_2519_ = _e3862;
                            phi_2520_ = _e3864;
                            phi_2521_ = _e3866;
                            let _e5429 = local_83;
                            phi_2522_ = _e5429;
                            phi_2523_ = _e3868;
                            phi_2524_ = _e3870;
                        }
                        let _e3872 = phi_2517_;
                        let _e3874 = phi_2518_;
                        let _e3876 = phi_2519_;
                        let _e3878 = phi_2520_;
                        let _e3880 = phi_2521_;
                        let _e3882 = phi_2522_;
                        let _e3884 = phi_2523_;
                        let _e3886 = phi_2524_;
                        if _e3874 {
                            phi_2529_ = type_56(1u, _e3872);
                            phi_2530_ = false;
                            phi_2531_ = false;
                            phi_2532_ = false;
                            phi_2533_ = false;
                            phi_2534_ = false;
                            phi_2535_ = false;
                        } else {
                            phi_2529_ = type_56();
                            phi_2530_ = _e3876;
                            phi_2531_ = _e3878;
                            phi_2532_ = _e3880;
                            phi_2533_ = _e3882;
                            phi_2534_ = _e3884;
                            phi_2535_ = _e3886;
                        }
                        let _e3889 = phi_2529_;
                        let _e3891 = phi_2530_;
                        let _e3893 = phi_2531_;
                        let _e3895 = phi_2532_;
                        let _e3897 = phi_2533_;
                        let _e3899 = phi_2534_;
                        let _e3901 = phi_2535_;
                        if _e3891 {
                            let _e3903 = local_40;
                            phi_2540_ = type_56(1u, _e3903);
                            phi_2541_ = false;
                            phi_2542_ = false;
                            phi_2543_ = true;
                            phi_2544_ = false;
                            phi_2545_ = false;
                        } else {
                            phi_2540_ = _e3856;
                            phi_2541_ = _e3893;
                            phi_2542_ = _e3895;
                            phi_2543_ = _e3897;
                            phi_2544_ = _e3899;
                            phi_2545_ = _e3901;
                        }
                        let _e3906 = phi_2540_;
                        let _e3908 = phi_2541_;
                        let _e3910 = phi_2542_;
                        let _e3912 = phi_2543_;
                        let _e3914 = phi_2544_;
                        let _e3916 = phi_2545_;
                        if _e3908 {
                            let _e3918 = local_41;
                            phi_2550_ = type_56(1u, _e3918);
                            phi_2551_ = false;
                            phi_2552_ = false;
                            phi_2553_ = false;
                            phi_2554_ = false;
                        } else {
                            phi_2550_ = type_56();
                            phi_2551_ = _e3910;
                            phi_2552_ = _e3912;
                            phi_2553_ = _e3914;
                            phi_2554_ = _e3916;
                        }
                        let _e3921 = phi_2550_;
                        let _e3923 = phi_2551_;
                        let _e3925 = phi_2552_;
                        let _e3927 = phi_2553_;
                        let _e3929 = phi_2554_;
                        if _e3923 {
                            let _e3931 = local_42;
                            phi_2559_ = type_56(1u, _e3931);
                            phi_2560_ = true;
                            phi_2561_ = false;
                            phi_2562_ = false;
                            phi_2563_ = false;
                        } else {
                            phi_2559_ = _e3921;
                            phi_2560_ = _e3908;
                            phi_2561_ = _e3925;
                            phi_2562_ = _e3927;
                            phi_2563_ = _e3929;
                        }
                        let _e3934 = phi_2559_;
                        let _e3936 = phi_2560_;
                        let _e3938 = phi_2561_;
                        let _e3940 = phi_2562_;
                        let _e3942 = phi_2563_;
                        if _e3936 {
                            phi_2567_ = _e3934;
                            phi_2568_ = true;
                            phi_2569_ = false;
                            phi_2570_ = false;
                        } else {
                            phi_2567_ = _e3906;
                            phi_2568_ = _e3938;
                            phi_2569_ = _e3940;
                            phi_2570_ = _e3942;
                        }
                        let _e3944 = phi_2567_;
                        let _e3946 = phi_2568_;
                        let _e3948 = phi_2569_;
                        let _e3950 = phi_2570_;
                        if _e3946 {
                            phi_2574_ = false;
                            phi_2575_ = false;
                        } else {
                            phi_2574_ = _e3948;
                            phi_2575_ = _e3950;
                        }
                        let _e3952 = phi_2574_;
                        let _e3954 = phi_2575_;
                        if _e3952 {
                            phi_2579_ = false;
                            phi_2580_ = false;
                        } else {
                            phi_2579_ = _e3954;
                            phi_2580_ = _e3946;
                        }
                        let _e3956 = phi_2579_;
                        let _e3958 = phi_2580_;
                        if _e3956 {
                            phi_2584_ = true;
                            phi_2585_ = false;
                        } else {
                            phi_2584_ = _e3952;
                            phi_2585_ = _e3958;
                        }
                        let _e3960 = phi_2584_;
                        let _e3962 = phi_2585_;
                        if _e3960 {
                            let _e3964 = local_43;
                            phi_2590_ = type_56(1u, _e3964);
                            phi_2591_ = true;
                        } else {
                            phi_2590_ = _e3944;
                            phi_2591_ = _e3962;
                        }
                        let _e3967 = phi_2590_;
                        let _e3969 = phi_2591_;
                        if _e3969 {
                            phi_2595_ = _e3967;
                        } else {
                            phi_2595_ = _e3889;
                        }
                        let _e3971 = phi_2595_;
                        if (_e3971.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_2609_ = type_29(0u, 3u);
                            loop {
                                let _e3984 = phi_2609_;
                                if (_e3984.member < _e3984.member_1) {
                                    phi_2610_ = type_29((_e3984.member + 1u), _e3984.member_1);
                                    phi_2633_ = type_29(1u, _e3984.member);
                                } else {
                                    phi_2610_ = _e3984;
                                    phi_2633_ = type_29(0u, type_29().member_1);
                                }
                                let _e3998 = phi_2610_;
                                let _e4000 = phi_2633_;
                                if (bitcast<i32>(_e4000.member) != 0i) {
                                    if (_e4000.member_1 < 3u) {
                                    } else {
                                        return;
                                    }
                                    let _e4007 = local_14[_e4000.member_1];
                                    let _e4008 = (_e3971.member_1 + _e4007);
                                    if (_e4008 < 1f) {
                                        phi_2653_ = _e4008;
                                    } else {
                                        phi_2653_ = 1f;
                                    }
                                    let _e4011 = phi_2653_;
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
                                            phi_2821_ = ((_e4106 + _e4110) <= 1f);
                                            phi_2822_ = false;
                                        } else {
                                            phi_2821_ = bool();
                                            phi_2822_ = true;
                                        }
                                        let _e4116 = phi_2821_;
                                        let _e4118 = phi_2822_;
                                        phi_2823_ = _e4116;
                                        phi_2824_ = _e4118;
                                    } else {
                                        phi_2823_ = bool();
                                        phi_2824_ = true;
                                    }
                                    let _e4120 = phi_2823_;
                                    let _e4122 = phi_2824_;
                                    if _e4122 {
                                        phi_2828_ = false;
                                    } else {
                                        phi_2828_ = _e4120;
                                    }
                                    let _e4124 = phi_2828_;
                                    if (_e4102 > 0f) {
                                        if _e4124 {
                                            phi_2850_ = array<f32, 3>((_e4030 - ((_e4051 * _e4106) + (_e4072 * _e4110))), (_e4031 - ((_e4052 * _e4106) + (_e4073 * _e4110))), (_e4032 - ((_e4053 * _e4106) + (_e4074 * _e4110))));
                                            phi_2851_ = false;
                                        } else {
                                            phi_2850_ = array<f32, 3>();
                                            phi_2851_ = true;
                                        }
                                        let _e4140 = phi_2850_;
                                        let _e4142 = phi_2851_;
                                        phi_2852_ = _e4140;
                                        phi_2853_ = _e4142;
                                    } else {
                                        phi_2852_ = array<f32, 3>();
                                        phi_2853_ = true;
                                    }
                                    let _e4144 = phi_2852_;
                                    let _e4146 = phi_2853_;
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
                                                phi_3021_ = _e4163;
                                            } else {
                                                phi_3021_ = 1f;
                                            }
                                            let _e4167 = phi_3021_;
                                            phi_3022_ = _e4167;
                                        } else {
                                            phi_3022_ = 0f;
                                        }
                                        let _e4169 = phi_3022_;
                                        let _e4173 = (_e4147 - (_e4150 * _e4169));
                                        let _e4174 = (_e4148 - (_e4151 * _e4169));
                                        let _e4175 = (_e4149 - (_e4152 * _e4169));
                                        let _e4186 = ((((_e4030 * _e4051) + (_e4031 * _e4052)) + (_e4032 * _e4053)) / (((_e4051 * _e4051) + (_e4052 * _e4052)) + (_e4053 * _e4053)));
                                        if (_e4186 > 0f) {
                                            if (_e4186 < 1f) {
                                                phi_3049_ = _e4186;
                                            } else {
                                                phi_3049_ = 1f;
                                            }
                                            let _e4190 = phi_3049_;
                                            phi_3050_ = _e4190;
                                        } else {
                                            phi_3050_ = 0f;
                                        }
                                        let _e4192 = phi_3050_;
                                        let _e4209 = ((((_e4030 * _e4072) + (_e4031 * _e4073)) + (_e4032 * _e4074)) / (((_e4072 * _e4072) + (_e4073 * _e4073)) + (_e4074 * _e4074)));
                                        if (_e4209 > 0f) {
                                            if (_e4209 < 1f) {
                                                phi_3077_ = _e4209;
                                            } else {
                                                phi_3077_ = 1f;
                                            }
                                            let _e4213 = phi_3077_;
                                            phi_3078_ = _e4213;
                                        } else {
                                            phi_3078_ = 0f;
                                        }
                                        let _e4215 = phi_3078_;
                                        local_10[0u] = array<f32, 3>((_e4030 - (_e4051 * _e4192)), (_e4031 - (_e4052 * _e4192)), (_e4032 - (_e4053 * _e4192)));
                                        local_10[1u] = array<f32, 3>((_e4030 - (_e4072 * _e4215)), (_e4031 - (_e4073 * _e4215)), (_e4032 - (_e4074 * _e4215)));
                                        local_10[2u] = array<f32, 3>(_e4173, _e4174, _e4175);
                                        local_10[3u] = array<f32, 3>(_e4173, _e4174, _e4175);
                                        let _e4231 = local_10[0u];
                                        phi_3114_ = type_29(1u, 4u);
                                        phi_3117_ = array<f32, 3>(_e4231[0], _e4231[1], _e4231[2]);
                                        loop {
                                            let _e4237 = phi_3114_;
                                            let _e4239 = phi_3117_;
                                            local_84 = _e4239;
                                            if (_e4237.member < _e4237.member_1) {
                                                phi_3115_ = type_29((_e4237.member + 1u), _e4237.member_1);
                                                phi_3140_ = type_29(1u, _e4237.member);
                                            } else {
                                                phi_3115_ = _e4237;
                                                phi_3140_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e4253 = phi_3115_;
                                            let _e4255 = phi_3140_;
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
                                                    phi_3207_ = array<f32, 3>(_e4291[0], _e4291[1], _e4291[2]);
                                                } else {
                                                    phi_3207_ = _e4239;
                                                }
                                                let _e4297 = phi_3207_;
                                                phi_3118_ = _e4297;
                                            } else {
                                                phi_3118_ = array<f32, 3>();
                                            }
                                            let _e4299 = phi_3118_;
                                            continue;
                                            continuing {
                                                phi_3114_ = _e4253;
                                                phi_3117_ = _e4299;
                                                break if !(_e4259);
                                            }
                                        }
                                        let _e5499 = local_84;
                                        phi_3208_ = _e5499;
                                    } else {
                                        phi_3208_ = _e4144;
                                    }
                                    let _e4302 = phi_3208_;
                                    let _e4313 = (((_e4302[0] * _e4302[0]) + (_e4302[1] * _e4302[1])) + (_e4302[2] * _e4302[2]));
                                    if (_e4313 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4313 > 0f) {
                                            phi_3233_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3233_ = 0f;
                                        }
                                        let _e4372 = phi_3233_;
                                        phi_3297_ = _e4372;
                                    } else {
                                        phi_3240_ = type_27(0i, 5i);
                                        phi_3243_ = bitcast<f32>(((bitcast<u32>(_e4313) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4321 = phi_3240_;
                                            let _e4323 = phi_3243_;
                                            local_44 = _e4323;
                                            if (_e4321.member < _e4321.member_1) {
                                                let _e4331 = (_e4321.member + 1i);
                                                if ((false == (_e4331 > _e4321.member)) != false) {
                                                    phi_3264_ = true;
                                                } else {
                                                    phi_3264_ = false;
                                                }
                                                let _e4336 = phi_3264_;
                                                if _e4336 {
                                                    phi_3270_ = type_28(0u, type_28().member_1);
                                                } else {
                                                    phi_3270_ = type_28(1u, _e4331);
                                                }
                                                let _e4342 = phi_3270_;
                                                if (bitcast<i32>(_e4342.member) != 0i) {
                                                } else {
                                                    return;
                                                }
                                                phi_3241_ = type_27(_e4342.member_1, _e4321.member_1);
                                                phi_3284_ = type_28(1u, _e4321.member);
                                            } else {
                                                phi_3241_ = _e4321;
                                                phi_3284_ = type_28(0u, type_28().member_1);
                                            }
                                            let _e4352 = phi_3241_;
                                            let _e4354 = phi_3284_;
                                            let _e4357 = (bitcast<i32>(_e4354.member) != 0i);
                                            if _e4357 {
                                                phi_3244_ = (0.5f * (_e4323 + (_e4313 / _e4323)));
                                            } else {
                                                phi_3244_ = f32();
                                            }
                                            let _e4362 = phi_3244_;
                                            continue;
                                            continuing {
                                                phi_3240_ = _e4352;
                                                phi_3243_ = _e4362;
                                                break if !(_e4357);
                                            }
                                        }
                                        let _e4367 = local_44;
                                        phi_3297_ = (_e4367 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e4374 = phi_3297_;
                                    let _e4380 = local_15.member[0u];
                                    if (_e4380[0] < 0f) {
                                        phi_3313_ = -(_e4380[0]);
                                    } else {
                                        phi_3313_ = _e4380[0];
                                    }
                                    let _e4387 = phi_3313_;
                                    if (_e4380[1] < 0f) {
                                        phi_3320_ = -(_e4380[1]);
                                    } else {
                                        phi_3320_ = _e4380[1];
                                    }
                                    let _e4391 = phi_3320_;
                                    if (_e4387 > _e4391) {
                                        phi_3325_ = _e4387;
                                    } else {
                                        phi_3325_ = _e4391;
                                    }
                                    let _e4394 = phi_3325_;
                                    if (_e4380[2] < 0f) {
                                        phi_3332_ = -(_e4380[2]);
                                    } else {
                                        phi_3332_ = _e4380[2];
                                    }
                                    let _e4398 = phi_3332_;
                                    if (_e4394 > _e4398) {
                                        phi_3337_ = _e4394;
                                    } else {
                                        phi_3337_ = _e4398;
                                    }
                                    let _e4401 = phi_3337_;
                                    let _e4404 = local_15.member[1u];
                                    if (_e4404[0] < 0f) {
                                        phi_3350_ = -(_e4404[0]);
                                    } else {
                                        phi_3350_ = _e4404[0];
                                    }
                                    let _e4411 = phi_3350_;
                                    if (_e4404[1] < 0f) {
                                        phi_3357_ = -(_e4404[1]);
                                    } else {
                                        phi_3357_ = _e4404[1];
                                    }
                                    let _e4415 = phi_3357_;
                                    if (_e4411 > _e4415) {
                                        phi_3362_ = _e4411;
                                    } else {
                                        phi_3362_ = _e4415;
                                    }
                                    let _e4418 = phi_3362_;
                                    if (_e4404[2] < 0f) {
                                        phi_3369_ = -(_e4404[2]);
                                    } else {
                                        phi_3369_ = _e4404[2];
                                    }
                                    let _e4422 = phi_3369_;
                                    if (_e4418 > _e4422) {
                                        phi_3374_ = _e4418;
                                    } else {
                                        phi_3374_ = _e4422;
                                    }
                                    let _e4425 = phi_3374_;
                                    if (_e4401 > _e4425) {
                                        phi_3379_ = _e4401;
                                    } else {
                                        phi_3379_ = _e4425;
                                    }
                                    let _e4428 = phi_3379_;
                                    let _e4430 = local_15.member_3;
                                    let _e4434 = local_15.member_1[0u];
                                    if (_e4434[0] < 0f) {
                                        phi_3396_ = -(_e4434[0]);
                                    } else {
                                        phi_3396_ = _e4434[0];
                                    }
                                    let _e4441 = phi_3396_;
                                    if (_e4434[1] < 0f) {
                                        phi_3403_ = -(_e4434[1]);
                                    } else {
                                        phi_3403_ = _e4434[1];
                                    }
                                    let _e4445 = phi_3403_;
                                    if (_e4441 > _e4445) {
                                        phi_3408_ = _e4441;
                                    } else {
                                        phi_3408_ = _e4445;
                                    }
                                    let _e4448 = phi_3408_;
                                    if (_e4434[2] < 0f) {
                                        phi_3415_ = -(_e4434[2]);
                                    } else {
                                        phi_3415_ = _e4434[2];
                                    }
                                    let _e4452 = phi_3415_;
                                    if (_e4448 > _e4452) {
                                        phi_3420_ = _e4448;
                                    } else {
                                        phi_3420_ = _e4452;
                                    }
                                    let _e4455 = phi_3420_;
                                    let _e4458 = local_15.member_1[1u];
                                    if (_e4458[0] < 0f) {
                                        phi_3434_ = -(_e4458[0]);
                                    } else {
                                        phi_3434_ = _e4458[0];
                                    }
                                    let _e4465 = phi_3434_;
                                    if (_e4458[1] < 0f) {
                                        phi_3441_ = -(_e4458[1]);
                                    } else {
                                        phi_3441_ = _e4458[1];
                                    }
                                    let _e4469 = phi_3441_;
                                    if (_e4465 > _e4469) {
                                        phi_3446_ = _e4465;
                                    } else {
                                        phi_3446_ = _e4469;
                                    }
                                    let _e4472 = phi_3446_;
                                    if (_e4458[2] < 0f) {
                                        phi_3453_ = -(_e4458[2]);
                                    } else {
                                        phi_3453_ = _e4458[2];
                                    }
                                    let _e4476 = phi_3453_;
                                    if (_e4472 > _e4476) {
                                        phi_3458_ = _e4472;
                                    } else {
                                        phi_3458_ = _e4476;
                                    }
                                    let _e4479 = phi_3458_;
                                    if (_e4455 > _e4479) {
                                        phi_3463_ = _e4455;
                                    } else {
                                        phi_3463_ = _e4479;
                                    }
                                    let _e4482 = phi_3463_;
                                    let _e4484 = local_15.member_3;
                                    let _e4488 = local_15.member_2[0u];
                                    if (_e4488[0] < 0f) {
                                        phi_3480_ = -(_e4488[0]);
                                    } else {
                                        phi_3480_ = _e4488[0];
                                    }
                                    let _e4495 = phi_3480_;
                                    if (_e4488[1] < 0f) {
                                        phi_3487_ = -(_e4488[1]);
                                    } else {
                                        phi_3487_ = _e4488[1];
                                    }
                                    let _e4499 = phi_3487_;
                                    if (_e4495 > _e4499) {
                                        phi_3492_ = _e4495;
                                    } else {
                                        phi_3492_ = _e4499;
                                    }
                                    let _e4502 = phi_3492_;
                                    if (_e4488[2] < 0f) {
                                        phi_3499_ = -(_e4488[2]);
                                    } else {
                                        phi_3499_ = _e4488[2];
                                    }
                                    let _e4506 = phi_3499_;
                                    if (_e4502 > _e4506) {
                                        phi_3504_ = _e4502;
                                    } else {
                                        phi_3504_ = _e4506;
                                    }
                                    let _e4509 = phi_3504_;
                                    let _e4512 = local_15.member_2[1u];
                                    if (_e4512[0] < 0f) {
                                        phi_3518_ = -(_e4512[0]);
                                    } else {
                                        phi_3518_ = _e4512[0];
                                    }
                                    let _e4519 = phi_3518_;
                                    if (_e4512[1] < 0f) {
                                        phi_3525_ = -(_e4512[1]);
                                    } else {
                                        phi_3525_ = _e4512[1];
                                    }
                                    let _e4523 = phi_3525_;
                                    if (_e4519 > _e4523) {
                                        phi_3530_ = _e4519;
                                    } else {
                                        phi_3530_ = _e4523;
                                    }
                                    let _e4526 = phi_3530_;
                                    if (_e4512[2] < 0f) {
                                        phi_3537_ = -(_e4512[2]);
                                    } else {
                                        phi_3537_ = _e4512[2];
                                    }
                                    let _e4530 = phi_3537_;
                                    if (_e4526 > _e4530) {
                                        phi_3542_ = _e4526;
                                    } else {
                                        phi_3542_ = _e4530;
                                    }
                                    let _e4533 = phi_3542_;
                                    if (_e4509 > _e4533) {
                                        phi_3547_ = _e4509;
                                    } else {
                                        phi_3547_ = _e4533;
                                    }
                                    let _e4536 = phi_3547_;
                                    let _e4538 = local_15.member_3;
                                    let _e4545 = local_15.member_3;
                                    let _e4552 = (((_e4374 * (1f + (0.000000059604645f * 8f))) + (((((((_e4428 + _e4430) + (_e4482 + _e4484)) + (_e4536 + _e4538)) * (0.000000059604645f * 16f)) + (_e4545 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e264);
                                    if _e4552 {
                                        phi_3567_ = false;
                                    } else {
                                        phi_3567_ = true;
                                    }
                                    let _e4554 = phi_3567_;
                                    phi_3568_ = _e4554;
                                    phi_3569_ = _e4552;
                                } else {
                                    phi_3568_ = false;
                                    phi_3569_ = false;
                                }
                                let _e4556 = phi_3568_;
                                let _e4558 = phi_3569_;
                                local_45 = _e4558;
                                continue;
                                continuing {
                                    phi_2609_ = _e3998;
                                    break if !(_e4556);
                                }
                            }
                            let _e4561 = local_45;
                            if _e4561 {
                                phi_3574_ = type_56(1u, _e3971.member_1);
                                phi_3575_ = false;
                            } else {
                                phi_3574_ = type_56();
                                phi_3575_ = true;
                            }
                            let _e4564 = phi_3574_;
                            let _e4566 = phi_3575_;
                            if _e4566 {
                                phi_3580_ = type_56(2u, _e3971.member_1);
                                phi_3581_ = false;
                            } else {
                                phi_3580_ = type_56();
                                phi_3581_ = true;
                            }
                            let _e4569 = phi_3580_;
                            let _e4571 = phi_3581_;
                            phi_3583_ = _e4569;
                            phi_3584_ = _e4564;
                            phi_3585_ = _e4571;
                        } else {
                            phi_3583_ = type_56();
                            phi_3584_ = type_56(0u, type_56().member_1);
                            phi_3585_ = true;
                        }
                        let _e4573 = phi_3583_;
                        let _e4575 = phi_3584_;
                        let _e4577 = phi_3585_;
                        if _e4577 {
                            phi_3589_ = _e4575;
                        } else {
                            phi_3589_ = _e4573;
                        }
                        let _e4579 = phi_3589_;
                        phi_6863_ = _e4579;
                    } else {
                        if (_e362 < 0f) {
                            phi_3599_ = -(_e362);
                        } else {
                            phi_3599_ = _e362;
                        }
                        let _e705 = phi_3599_;
                        if (_e385 < 0f) {
                            phi_3605_ = -(_e385);
                        } else {
                            phi_3605_ = _e385;
                        }
                        let _e709 = phi_3605_;
                        if (_e705 > _e709) {
                            phi_3610_ = _e705;
                        } else {
                            phi_3610_ = _e709;
                        }
                        let _e712 = phi_3610_;
                        if (_e408 < 0f) {
                            phi_3616_ = -(_e408);
                        } else {
                            phi_3616_ = _e408;
                        }
                        let _e716 = phi_3616_;
                        if (_e419 < 0f) {
                            phi_3622_ = -(_e419);
                        } else {
                            phi_3622_ = _e419;
                        }
                        let _e720 = phi_3622_;
                        if (_e716 > _e720) {
                            phi_3627_ = _e716;
                        } else {
                            phi_3627_ = _e720;
                        }
                        let _e723 = phi_3627_;
                        if (_e712 > _e723) {
                            phi_3632_ = _e712;
                        } else {
                            phi_3632_ = _e723;
                        }
                        let _e726 = phi_3632_;
                        let _e727 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e726 >= _e727) {
                            phi_3640_ = (_e726 <= (1f / _e727));
                        } else {
                            phi_3640_ = false;
                        }
                        let _e732 = phi_3640_;
                        if _e732 {
                            phi_3645_ = (0.000000059604645f * 256f);
                        } else {
                            phi_3645_ = 2f;
                        }
                        let _e735 = phi_3645_;
                        let _e737 = ((_e669 * 0.34f) + (_e726 * _e735));
                        if _e732 {
                            phi_3652_ = (1f / _e726);
                        } else {
                            phi_3652_ = 0f;
                        }
                        let _e740 = phi_3652_;
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
                                    phi_3685_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_3685_ = 0f;
                                }
                                let _e815 = phi_3685_;
                                phi_3749_ = _e815;
                            } else {
                                phi_3692_ = type_27(0i, 5i);
                                phi_3695_ = bitcast<f32>(((bitcast<u32>(_e755) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e764 = phi_3692_;
                                    let _e766 = phi_3695_;
                                    local_16 = _e766;
                                    if (_e764.member < _e764.member_1) {
                                        let _e774 = (_e764.member + 1i);
                                        if ((false == (_e774 > _e764.member)) != false) {
                                            phi_3716_ = true;
                                        } else {
                                            phi_3716_ = false;
                                        }
                                        let _e779 = phi_3716_;
                                        if _e779 {
                                            phi_3722_ = type_28(0u, type_28().member_1);
                                        } else {
                                            phi_3722_ = type_28(1u, _e774);
                                        }
                                        let _e785 = phi_3722_;
                                        if (bitcast<i32>(_e785.member) != 0i) {
                                        } else {
                                            return;
                                        }
                                        phi_3693_ = type_27(_e785.member_1, _e764.member_1);
                                        phi_3736_ = type_28(1u, _e764.member);
                                    } else {
                                        phi_3693_ = _e764;
                                        phi_3736_ = type_28(0u, type_28().member_1);
                                    }
                                    let _e795 = phi_3693_;
                                    let _e797 = phi_3736_;
                                    let _e800 = (bitcast<i32>(_e797.member) != 0i);
                                    if _e800 {
                                        phi_3696_ = (0.5f * (_e766 + (_e755 / _e766)));
                                    } else {
                                        phi_3696_ = f32();
                                    }
                                    let _e805 = phi_3696_;
                                    continue;
                                    continuing {
                                        phi_3692_ = _e795;
                                        phi_3695_ = _e805;
                                        break if !(_e800);
                                    }
                                }
                                let _e810 = local_16;
                                phi_3749_ = (_e810 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e817 = phi_3749_;
                            if (_e747 < 0f) {
                                phi_3755_ = -(_e817);
                            } else {
                                phi_3755_ = _e817;
                            }
                            let _e821 = phi_3755_;
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
                            phi_3780_ = type_29(0u, 2u);
                            phi_3783_ = 1u;
                            loop {
                                let _e842 = phi_3780_;
                                let _e844 = phi_3783_;
                                local_46 = _e844;
                                if (_e842.member < _e842.member_1) {
                                    phi_3781_ = type_29((_e842.member + 1u), _e842.member_1);
                                    phi_3806_ = type_29(1u, _e842.member);
                                } else {
                                    phi_3781_ = _e842;
                                    phi_3806_ = type_29(0u, type_29().member_1);
                                }
                                let _e858 = phi_3781_;
                                let _e860 = phi_3806_;
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
                                            phi_3850_ = (_e844 + 1u);
                                        } else {
                                            phi_3850_ = _e844;
                                        }
                                        let _e880 = phi_3850_;
                                        phi_3851_ = _e880;
                                    } else {
                                        phi_3851_ = _e844;
                                    }
                                    let _e882 = phi_3851_;
                                    phi_3784_ = _e882;
                                } else {
                                    phi_3784_ = u32();
                                }
                                let _e884 = phi_3784_;
                                continue;
                                continuing {
                                    phi_3780_ = _e858;
                                    phi_3783_ = _e884;
                                    break if !(_e864);
                                }
                            }
                            let _e4789 = local_46;
                            phi_3852_ = _e4789;
                        } else {
                            phi_3852_ = 1u;
                        }
                        let _e887 = phi_3852_;
                        if (_e887 < 4u) {
                        } else {
                            return;
                        }
                        local_7[_e887] = 1f;
                        let _e890 = local_7;
                        local_9 = _e890;
                        phi_3872_ = type_29(0u, _e887);
                        loop {
                            let _e893 = phi_3872_;
                            if (_e893.member < _e893.member_1) {
                                phi_3873_ = type_29((_e893.member + 1u), _e893.member_1);
                                phi_3896_ = type_29(1u, _e893.member);
                            } else {
                                phi_3873_ = _e893;
                                phi_3896_ = type_29(0u, type_29().member_1);
                            }
                            let _e907 = phi_3873_;
                            let _e909 = phi_3896_;
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
                                    phi_3948_ = -(_e932);
                                } else {
                                    phi_3948_ = _e932;
                                }
                                let _e948 = phi_3948_;
                                let _e949 = (_e948 > _e737);
                                if (_e944 < 0f) {
                                    phi_3955_ = -(_e944);
                                } else {
                                    phi_3955_ = _e944;
                                }
                                let _e953 = phi_3955_;
                                let _e954 = (_e953 > _e737);
                                if _e949 {
                                    if _e954 {
                                        phi_3966_ = ((_e932 > 0f) != (_e944 > 0f));
                                        phi_3967_ = false;
                                    } else {
                                        phi_3966_ = bool();
                                        phi_3967_ = true;
                                    }
                                    let _e959 = phi_3966_;
                                    let _e961 = phi_3967_;
                                    phi_3968_ = _e959;
                                    phi_3969_ = _e961;
                                } else {
                                    phi_3968_ = bool();
                                    phi_3969_ = true;
                                }
                                let _e963 = phi_3968_;
                                let _e965 = phi_3969_;
                                if _e965 {
                                    phi_3973_ = false;
                                } else {
                                    phi_3973_ = _e963;
                                }
                                let _e967 = phi_3973_;
                                if _e949 {
                                    if _e954 {
                                        if _e967 {
                                            phi_3984_ = type_57();
                                        } else {
                                            phi_3984_ = type_57(1f, 0f, _e967);
                                        }
                                        let _e970 = phi_3984_;
                                        phi_3985_ = _e970;
                                        phi_3986_ = _e967;
                                    } else {
                                        phi_3985_ = type_57();
                                        phi_3986_ = true;
                                    }
                                    let _e972 = phi_3985_;
                                    let _e974 = phi_3986_;
                                    phi_3987_ = _e972;
                                    phi_3988_ = _e974;
                                } else {
                                    phi_3987_ = type_57();
                                    phi_3988_ = true;
                                }
                                let _e976 = phi_3987_;
                                let _e978 = phi_3988_;
                                if _e978 {
                                    if _e949 {
                                        if (_e932 < 0f) {
                                            phi_3999_ = -1f;
                                        } else {
                                            phi_3999_ = 1f;
                                        }
                                        let _e981 = phi_3999_;
                                        let _e984 = (_e408 - _e385);
                                        phi_4009_ = type_29(0u, 64u);
                                        phi_4012_ = _e920;
                                        phi_4014_ = _e916;
                                        phi_4016_ = (0.5f * (_e916 + _e920));
                                        loop {
                                            let _e990 = phi_4009_;
                                            let _e992 = phi_4012_;
                                            let _e994 = phi_4014_;
                                            let _e996 = phi_4016_;
                                            local_48 = _e994;
                                            if (_e990.member < _e990.member_1) {
                                                phi_4010_ = type_29((_e990.member + 1u), _e990.member_1);
                                                phi_4039_ = type_29(1u, _e990.member);
                                            } else {
                                                phi_4010_ = _e990;
                                                phi_4039_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1010 = phi_4010_;
                                            let _e1012 = phi_4039_;
                                            if (bitcast<i32>(_e1012.member) != 0i) {
                                                let _e1016 = (1f - _e996);
                                                let _e1029 = ((_e981 * ((((_e362 * _e1016) + (_e385 * _e996)) * (_e1016 * _e1016)) + (((_e408 * _e1016) + (_e419 * _e996)) * (_e996 * _e996)))) - _e737);
                                                if (_e1029 > 0f) {
                                                    phi_4064_ = _e992;
                                                    phi_4065_ = _e996;
                                                } else {
                                                    phi_4064_ = _e996;
                                                    phi_4065_ = _e994;
                                                }
                                                let _e1032 = phi_4064_;
                                                let _e1034 = phi_4065_;
                                                let _e1036 = ((_e1032 - _e1034) > 0.00000000000022737368f);
                                                if _e1036 {
                                                    let _e1037 = (1f - _e996);
                                                    let _e1049 = (-(_e1029) / (_e981 * (((((_e385 - (3f * _e362)) * _e1037) + (_e984 * _e996)) * _e1037) + (((_e984 * _e1037) + (((3f * _e419) - _e408) * _e996)) * _e996))));
                                                    if (_e1029 > 0f) {
                                                        phi_4091_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_4091_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1055 = phi_4091_;
                                                    let _e1057 = ((_e996 + _e1049) + _e1055);
                                                    if (_e1057 > _e1034) {
                                                        if (_e1057 < _e1032) {
                                                            if (_e1049 < 0f) {
                                                                phi_4107_ = -(_e1049);
                                                            } else {
                                                                phi_4107_ = _e1049;
                                                            }
                                                            let _e1063 = phi_4107_;
                                                            if (_e1063 < (0.5f * (_e1032 - _e1034))) {
                                                                phi_4114_ = false;
                                                            } else {
                                                                phi_4114_ = true;
                                                            }
                                                            let _e1068 = phi_4114_;
                                                            phi_4115_ = _e1068;
                                                        } else {
                                                            phi_4115_ = true;
                                                        }
                                                        let _e1070 = phi_4115_;
                                                        phi_4116_ = _e1070;
                                                    } else {
                                                        phi_4116_ = true;
                                                    }
                                                    let _e1072 = phi_4116_;
                                                    if _e1072 {
                                                        phi_4122_ = (0.5f * (_e1034 + _e1032));
                                                    } else {
                                                        phi_4122_ = _e1057;
                                                    }
                                                    let _e1076 = phi_4122_;
                                                    phi_4123_ = _e1076;
                                                    phi_4124_ = false;
                                                } else {
                                                    phi_4123_ = f32();
                                                    phi_4124_ = true;
                                                }
                                                let _e1078 = phi_4123_;
                                                let _e1080 = phi_4124_;
                                                phi_4013_ = _e1032;
                                                phi_4015_ = _e1034;
                                                phi_4017_ = _e1078;
                                                phi_4125_ = _e1034;
                                                phi_4126_ = _e1036;
                                                phi_4127_ = _e1080;
                                            } else {
                                                phi_4013_ = f32();
                                                phi_4015_ = f32();
                                                phi_4017_ = f32();
                                                phi_4125_ = f32();
                                                phi_4126_ = false;
                                                phi_4127_ = false;
                                            }
                                            let _e1082 = phi_4013_;
                                            let _e1084 = phi_4015_;
                                            let _e1086 = phi_4017_;
                                            let _e1088 = phi_4125_;
                                            let _e1090 = phi_4126_;
                                            let _e1092 = phi_4127_;
                                            local_17 = _e1092;
                                            local_47 = _e1088;
                                            continue;
                                            continuing {
                                                phi_4009_ = _e1010;
                                                phi_4012_ = _e1082;
                                                phi_4014_ = _e1084;
                                                phi_4016_ = _e1086;
                                                break if !(_e1090);
                                            }
                                        }
                                        let _e1095 = local_17;
                                        if _e1095 {
                                            let _e4831 = local_47;
                                            phi_4131_ = _e4831;
                                        } else {
                                            let _e4833 = local_48;
                                            phi_4131_ = _e4833;
                                        }
                                        let _e1097 = phi_4131_;
                                        phi_4132_ = _e1097;
                                    } else {
                                        phi_4132_ = _e916;
                                    }
                                    let _e1099 = phi_4132_;
                                    if _e954 {
                                        phi_4139_ = type_29(0u, 64u);
                                        phi_4142_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1102 = phi_4139_;
                                            let _e1104 = phi_4142_;
                                            if (_e1102.member < _e1102.member_1) {
                                                phi_4140_ = type_29((_e1102.member + 1u), _e1102.member_1);
                                                phi_4165_ = type_29(1u, _e1102.member);
                                            } else {
                                                phi_4140_ = _e1102;
                                                phi_4165_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1118 = phi_4140_;
                                            let _e1120 = phi_4165_;
                                            if (bitcast<i32>(_e1120.member) != 0i) {
                                                let _e1124 = (_e1099 + _e1104);
                                                if (_e1124 < _e920) {
                                                    let _e1126 = (1f - _e1124);
                                                    let _e1137 = ((((_e362 * _e1126) + (_e385 * _e1124)) * (_e1126 * _e1126)) + (((_e408 * _e1126) + (_e419 * _e1124)) * (_e1124 * _e1124)));
                                                    let _e1138 = (1f - _e1099);
                                                    let _e1149 = ((((_e362 * _e1138) + (_e385 * _e1099)) * (_e1138 * _e1138)) + (((_e408 * _e1138) + (_e419 * _e1099)) * (_e1099 * _e1099)));
                                                    if (_e1137 < 0f) {
                                                        phi_4206_ = -(_e1137);
                                                    } else {
                                                        phi_4206_ = _e1137;
                                                    }
                                                    let _e1153 = phi_4206_;
                                                    if (_e1153 > _e737) {
                                                        if (_e1149 < 0f) {
                                                            phi_4216_ = -(_e1149);
                                                        } else {
                                                            phi_4216_ = _e1149;
                                                        }
                                                        let _e1158 = phi_4216_;
                                                        if (_e1158 > _e737) {
                                                            phi_4224_ = ((_e1137 > 0f) == (_e1149 > 0f));
                                                        } else {
                                                            phi_4224_ = false;
                                                        }
                                                        let _e1164 = phi_4224_;
                                                        phi_4226_ = !(_e1164);
                                                    } else {
                                                        phi_4226_ = false;
                                                    }
                                                    let _e1167 = phi_4226_;
                                                    if _e1167 {
                                                        phi_4231_ = f32();
                                                        phi_4232_ = false;
                                                    } else {
                                                        phi_4231_ = (_e1104 + _e1104);
                                                        phi_4232_ = true;
                                                    }
                                                    let _e1170 = phi_4231_;
                                                    let _e1172 = phi_4232_;
                                                    phi_4233_ = _e1170;
                                                    phi_4234_ = _e1172;
                                                    phi_4235_ = _e1167;
                                                    phi_4236_ = false;
                                                } else {
                                                    phi_4233_ = f32();
                                                    phi_4234_ = false;
                                                    phi_4235_ = false;
                                                    phi_4236_ = true;
                                                }
                                                let _e1174 = phi_4233_;
                                                let _e1176 = phi_4234_;
                                                let _e1178 = phi_4235_;
                                                let _e1180 = phi_4236_;
                                                phi_4237_ = _e1124;
                                                phi_4143_ = _e1174;
                                                phi_4238_ = _e1176;
                                                phi_4239_ = _e1178;
                                                phi_4240_ = _e1180;
                                                phi_4241_ = false;
                                            } else {
                                                phi_4237_ = f32();
                                                phi_4143_ = f32();
                                                phi_4238_ = false;
                                                phi_4239_ = false;
                                                phi_4240_ = false;
                                                phi_4241_ = true;
                                            }
                                            let _e1182 = phi_4237_;
                                            let _e1184 = phi_4143_;
                                            let _e1186 = phi_4238_;
                                            let _e1188 = phi_4239_;
                                            let _e1190 = phi_4240_;
                                            let _e1192 = phi_4241_;
                                            local_18 = _e1188;
                                            local_49 = _e1190;
                                            local_50 = _e1192;
                                            local_51 = _e1182;
                                            continue;
                                            continuing {
                                                phi_4139_ = _e1118;
                                                phi_4142_ = _e1184;
                                                break if !(_e1186);
                                            }
                                        }
                                        let _e1195 = local_18;
                                        if _e1195 {
                                            phi_4245_ = false;
                                            phi_4246_ = false;
                                        } else {
                                            let _e4858 = local_49;
                                            phi_4245_ = _e4858;
                                            let _e4861 = local_50;
                                            phi_4246_ = _e4861;
                                        }
                                        let _e1197 = phi_4245_;
                                        let _e1199 = phi_4246_;
                                        if _e1197 {
                                            phi_4250_ = true;
                                        } else {
                                            phi_4250_ = _e1199;
                                        }
                                        let _e1201 = phi_4250_;
                                        if _e1201 {
                                            phi_4254_ = _e920;
                                        } else {
                                            let _e4865 = local_51;
                                            phi_4254_ = _e4865;
                                        }
                                        let _e1203 = phi_4254_;
                                        phi_4255_ = _e1203;
                                    } else {
                                        phi_4255_ = _e920;
                                    }
                                    let _e1205 = phi_4255_;
                                    phi_4257_ = type_57(_e1099, _e1205, _e967);
                                } else {
                                    phi_4257_ = _e976;
                                }
                                let _e1208 = phi_4257_;
                                if (_e1208.member > _e1208.member_1) {
                                    phi_6819_ = f32();
                                    phi_6820_ = true;
                                    phi_6821_ = false;
                                    phi_6822_ = false;
                                    phi_6823_ = false;
                                } else {
                                    let _e1215 = ((_e1208.member_1 - _e1208.member) * 0.5f);
                                    let _e1216 = (_e1208.member + _e1215);
                                    let _e1218 = (_e1215 + (0.000000059604645f * 4f));
                                    let _e1220 = local_15.member_3;
                                    let _e1223 = local_15.member[0u];
                                    if (_e1223[0] < 0f) {
                                        phi_4286_ = -(_e1223[0]);
                                    } else {
                                        phi_4286_ = _e1223[0];
                                    }
                                    let _e1230 = phi_4286_;
                                    if (_e1223[1] < 0f) {
                                        phi_4293_ = -(_e1223[1]);
                                    } else {
                                        phi_4293_ = _e1223[1];
                                    }
                                    let _e1234 = phi_4293_;
                                    if (_e1230 > _e1234) {
                                        phi_4298_ = _e1230;
                                    } else {
                                        phi_4298_ = _e1234;
                                    }
                                    let _e1237 = phi_4298_;
                                    if (_e1223[2] < 0f) {
                                        phi_4305_ = -(_e1223[2]);
                                    } else {
                                        phi_4305_ = _e1223[2];
                                    }
                                    let _e1241 = phi_4305_;
                                    if (_e1237 > _e1241) {
                                        phi_4310_ = _e1237;
                                    } else {
                                        phi_4310_ = _e1241;
                                    }
                                    let _e1244 = phi_4310_;
                                    let _e1246 = local_15.member[1u];
                                    if (_e1246[0] < 0f) {
                                        phi_4323_ = -(_e1246[0]);
                                    } else {
                                        phi_4323_ = _e1246[0];
                                    }
                                    let _e1253 = phi_4323_;
                                    if (_e1246[1] < 0f) {
                                        phi_4330_ = -(_e1246[1]);
                                    } else {
                                        phi_4330_ = _e1246[1];
                                    }
                                    let _e1257 = phi_4330_;
                                    if (_e1253 > _e1257) {
                                        phi_4335_ = _e1253;
                                    } else {
                                        phi_4335_ = _e1257;
                                    }
                                    let _e1260 = phi_4335_;
                                    if (_e1246[2] < 0f) {
                                        phi_4342_ = -(_e1246[2]);
                                    } else {
                                        phi_4342_ = _e1246[2];
                                    }
                                    let _e1264 = phi_4342_;
                                    if (_e1260 > _e1264) {
                                        phi_4347_ = _e1260;
                                    } else {
                                        phi_4347_ = _e1264;
                                    }
                                    let _e1267 = phi_4347_;
                                    if (_e1244 > _e1267) {
                                        phi_4352_ = _e1244;
                                    } else {
                                        phi_4352_ = _e1267;
                                    }
                                    let _e1270 = phi_4352_;
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
                                        phi_4411_ = -(_e1301);
                                    } else {
                                        phi_4411_ = _e1301;
                                    }
                                    let _e1307 = phi_4411_;
                                    if (_e1302 < 0f) {
                                        phi_4417_ = -(_e1302);
                                    } else {
                                        phi_4417_ = _e1302;
                                    }
                                    let _e1311 = phi_4417_;
                                    if (_e1307 > _e1311) {
                                        phi_4422_ = _e1307;
                                    } else {
                                        phi_4422_ = _e1311;
                                    }
                                    let _e1314 = phi_4422_;
                                    if (_e1303 < 0f) {
                                        phi_4428_ = -(_e1303);
                                    } else {
                                        phi_4428_ = _e1303;
                                    }
                                    let _e1318 = phi_4428_;
                                    if (_e1314 > _e1318) {
                                        phi_4433_ = _e1314;
                                    } else {
                                        phi_4433_ = _e1318;
                                    }
                                    let _e1321 = phi_4433_;
                                    let _e1327 = ((((_e1218 * _e1321) * 1.01f) + ((_e1270 + _e1220) * (0.000000059604645f * 8f))) + _e1220);
                                    if (_e1288 < 0f) {
                                        phi_4445_ = -(_e1288);
                                    } else {
                                        phi_4445_ = _e1288;
                                    }
                                    let _e1331 = phi_4445_;
                                    if (_e1289 < 0f) {
                                        phi_4451_ = -(_e1289);
                                    } else {
                                        phi_4451_ = _e1289;
                                    }
                                    let _e1335 = phi_4451_;
                                    if (_e1331 > _e1335) {
                                        phi_4456_ = _e1331;
                                    } else {
                                        phi_4456_ = _e1335;
                                    }
                                    let _e1338 = phi_4456_;
                                    if (_e1290 < 0f) {
                                        phi_4462_ = -(_e1290);
                                    } else {
                                        phi_4462_ = _e1290;
                                    }
                                    let _e1342 = phi_4462_;
                                    if (_e1338 > _e1342) {
                                        phi_4467_ = _e1338;
                                    } else {
                                        phi_4467_ = _e1342;
                                    }
                                    let _e1345 = phi_4467_;
                                    local_3 = type_42(array<f32, 3>(_e1288, _e1289, _e1290), _e1327, (_e1345 + _e1327));
                                    let _e1351 = local_15.member_3;
                                    let _e1353 = local_15.member_1[0u];
                                    if (_e1353[0] < 0f) {
                                        phi_4493_ = -(_e1353[0]);
                                    } else {
                                        phi_4493_ = _e1353[0];
                                    }
                                    let _e1360 = phi_4493_;
                                    if (_e1353[1] < 0f) {
                                        phi_4500_ = -(_e1353[1]);
                                    } else {
                                        phi_4500_ = _e1353[1];
                                    }
                                    let _e1364 = phi_4500_;
                                    if (_e1360 > _e1364) {
                                        phi_4505_ = _e1360;
                                    } else {
                                        phi_4505_ = _e1364;
                                    }
                                    let _e1367 = phi_4505_;
                                    if (_e1353[2] < 0f) {
                                        phi_4512_ = -(_e1353[2]);
                                    } else {
                                        phi_4512_ = _e1353[2];
                                    }
                                    let _e1371 = phi_4512_;
                                    if (_e1367 > _e1371) {
                                        phi_4517_ = _e1367;
                                    } else {
                                        phi_4517_ = _e1371;
                                    }
                                    let _e1374 = phi_4517_;
                                    let _e1376 = local_15.member_1[1u];
                                    if (_e1376[0] < 0f) {
                                        phi_4530_ = -(_e1376[0]);
                                    } else {
                                        phi_4530_ = _e1376[0];
                                    }
                                    let _e1383 = phi_4530_;
                                    if (_e1376[1] < 0f) {
                                        phi_4537_ = -(_e1376[1]);
                                    } else {
                                        phi_4537_ = _e1376[1];
                                    }
                                    let _e1387 = phi_4537_;
                                    if (_e1383 > _e1387) {
                                        phi_4542_ = _e1383;
                                    } else {
                                        phi_4542_ = _e1387;
                                    }
                                    let _e1390 = phi_4542_;
                                    if (_e1376[2] < 0f) {
                                        phi_4549_ = -(_e1376[2]);
                                    } else {
                                        phi_4549_ = _e1376[2];
                                    }
                                    let _e1394 = phi_4549_;
                                    if (_e1390 > _e1394) {
                                        phi_4554_ = _e1390;
                                    } else {
                                        phi_4554_ = _e1394;
                                    }
                                    let _e1397 = phi_4554_;
                                    if (_e1374 > _e1397) {
                                        phi_4559_ = _e1374;
                                    } else {
                                        phi_4559_ = _e1397;
                                    }
                                    let _e1400 = phi_4559_;
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
                                        phi_4618_ = -(_e1431);
                                    } else {
                                        phi_4618_ = _e1431;
                                    }
                                    let _e1437 = phi_4618_;
                                    if (_e1432 < 0f) {
                                        phi_4624_ = -(_e1432);
                                    } else {
                                        phi_4624_ = _e1432;
                                    }
                                    let _e1441 = phi_4624_;
                                    if (_e1437 > _e1441) {
                                        phi_4629_ = _e1437;
                                    } else {
                                        phi_4629_ = _e1441;
                                    }
                                    let _e1444 = phi_4629_;
                                    if (_e1433 < 0f) {
                                        phi_4635_ = -(_e1433);
                                    } else {
                                        phi_4635_ = _e1433;
                                    }
                                    let _e1448 = phi_4635_;
                                    if (_e1444 > _e1448) {
                                        phi_4640_ = _e1444;
                                    } else {
                                        phi_4640_ = _e1448;
                                    }
                                    let _e1451 = phi_4640_;
                                    let _e1457 = ((((_e1218 * _e1451) * 1.01f) + ((_e1400 + _e1351) * (0.000000059604645f * 8f))) + _e1351);
                                    if (_e1418 < 0f) {
                                        phi_4652_ = -(_e1418);
                                    } else {
                                        phi_4652_ = _e1418;
                                    }
                                    let _e1461 = phi_4652_;
                                    if (_e1419 < 0f) {
                                        phi_4658_ = -(_e1419);
                                    } else {
                                        phi_4658_ = _e1419;
                                    }
                                    let _e1465 = phi_4658_;
                                    if (_e1461 > _e1465) {
                                        phi_4663_ = _e1461;
                                    } else {
                                        phi_4663_ = _e1465;
                                    }
                                    let _e1468 = phi_4663_;
                                    if (_e1420 < 0f) {
                                        phi_4669_ = -(_e1420);
                                    } else {
                                        phi_4669_ = _e1420;
                                    }
                                    let _e1472 = phi_4669_;
                                    if (_e1468 > _e1472) {
                                        phi_4674_ = _e1468;
                                    } else {
                                        phi_4674_ = _e1472;
                                    }
                                    let _e1475 = phi_4674_;
                                    local_4 = type_42(array<f32, 3>(_e1418, _e1419, _e1420), _e1457, (_e1475 + _e1457));
                                    let _e1481 = local_15.member_3;
                                    let _e1483 = local_15.member_2[0u];
                                    if (_e1483[0] < 0f) {
                                        phi_4700_ = -(_e1483[0]);
                                    } else {
                                        phi_4700_ = _e1483[0];
                                    }
                                    let _e1490 = phi_4700_;
                                    if (_e1483[1] < 0f) {
                                        phi_4707_ = -(_e1483[1]);
                                    } else {
                                        phi_4707_ = _e1483[1];
                                    }
                                    let _e1494 = phi_4707_;
                                    if (_e1490 > _e1494) {
                                        phi_4712_ = _e1490;
                                    } else {
                                        phi_4712_ = _e1494;
                                    }
                                    let _e1497 = phi_4712_;
                                    if (_e1483[2] < 0f) {
                                        phi_4719_ = -(_e1483[2]);
                                    } else {
                                        phi_4719_ = _e1483[2];
                                    }
                                    let _e1501 = phi_4719_;
                                    if (_e1497 > _e1501) {
                                        phi_4724_ = _e1497;
                                    } else {
                                        phi_4724_ = _e1501;
                                    }
                                    let _e1504 = phi_4724_;
                                    let _e1506 = local_15.member_2[1u];
                                    if (_e1506[0] < 0f) {
                                        phi_4737_ = -(_e1506[0]);
                                    } else {
                                        phi_4737_ = _e1506[0];
                                    }
                                    let _e1513 = phi_4737_;
                                    if (_e1506[1] < 0f) {
                                        phi_4744_ = -(_e1506[1]);
                                    } else {
                                        phi_4744_ = _e1506[1];
                                    }
                                    let _e1517 = phi_4744_;
                                    if (_e1513 > _e1517) {
                                        phi_4749_ = _e1513;
                                    } else {
                                        phi_4749_ = _e1517;
                                    }
                                    let _e1520 = phi_4749_;
                                    if (_e1506[2] < 0f) {
                                        phi_4756_ = -(_e1506[2]);
                                    } else {
                                        phi_4756_ = _e1506[2];
                                    }
                                    let _e1524 = phi_4756_;
                                    if (_e1520 > _e1524) {
                                        phi_4761_ = _e1520;
                                    } else {
                                        phi_4761_ = _e1524;
                                    }
                                    let _e1527 = phi_4761_;
                                    if (_e1504 > _e1527) {
                                        phi_4766_ = _e1504;
                                    } else {
                                        phi_4766_ = _e1527;
                                    }
                                    let _e1530 = phi_4766_;
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
                                        phi_4825_ = -(_e1561);
                                    } else {
                                        phi_4825_ = _e1561;
                                    }
                                    let _e1567 = phi_4825_;
                                    if (_e1562 < 0f) {
                                        phi_4831_ = -(_e1562);
                                    } else {
                                        phi_4831_ = _e1562;
                                    }
                                    let _e1571 = phi_4831_;
                                    if (_e1567 > _e1571) {
                                        phi_4836_ = _e1567;
                                    } else {
                                        phi_4836_ = _e1571;
                                    }
                                    let _e1574 = phi_4836_;
                                    if (_e1563 < 0f) {
                                        phi_4842_ = -(_e1563);
                                    } else {
                                        phi_4842_ = _e1563;
                                    }
                                    let _e1578 = phi_4842_;
                                    if (_e1574 > _e1578) {
                                        phi_4847_ = _e1574;
                                    } else {
                                        phi_4847_ = _e1578;
                                    }
                                    let _e1581 = phi_4847_;
                                    let _e1587 = ((((_e1218 * _e1581) * 1.01f) + ((_e1530 + _e1481) * (0.000000059604645f * 8f))) + _e1481);
                                    if (_e1548 < 0f) {
                                        phi_4859_ = -(_e1548);
                                    } else {
                                        phi_4859_ = _e1548;
                                    }
                                    let _e1591 = phi_4859_;
                                    if (_e1549 < 0f) {
                                        phi_4865_ = -(_e1549);
                                    } else {
                                        phi_4865_ = _e1549;
                                    }
                                    let _e1595 = phi_4865_;
                                    if (_e1591 > _e1595) {
                                        phi_4870_ = _e1591;
                                    } else {
                                        phi_4870_ = _e1595;
                                    }
                                    let _e1598 = phi_4870_;
                                    if (_e1550 < 0f) {
                                        phi_4876_ = -(_e1550);
                                    } else {
                                        phi_4876_ = _e1550;
                                    }
                                    let _e1602 = phi_4876_;
                                    if (_e1598 > _e1602) {
                                        phi_4881_ = _e1598;
                                    } else {
                                        phi_4881_ = _e1602;
                                    }
                                    let _e1605 = phi_4881_;
                                    local_5 = type_42(array<f32, 3>(_e1548, _e1549, _e1550), _e1587, (_e1605 + _e1587));
                                    let _e1610 = local_4.member;
                                    let _e1615 = local_5.member;
                                    let _e1621 = ((_e1610[1] * _e1615[2]) - (_e1610[2] * _e1615[1]));
                                    let _e1624 = ((_e1610[2] * _e1615[0]) - (_e1610[0] * _e1615[2]));
                                    let _e1627 = ((_e1610[0] * _e1615[1]) - (_e1610[1] * _e1615[0]));
                                    if (_e1621 < 0f) {
                                        phi_4930_ = -(_e1621);
                                    } else {
                                        phi_4930_ = _e1621;
                                    }
                                    let _e1631 = phi_4930_;
                                    if (_e1624 < 0f) {
                                        phi_4936_ = -(_e1624);
                                    } else {
                                        phi_4936_ = _e1624;
                                    }
                                    let _e1635 = phi_4936_;
                                    if (_e1631 > _e1635) {
                                        if (_e1621 < 0f) {
                                            phi_4946_ = -(_e1621);
                                        } else {
                                            phi_4946_ = _e1621;
                                        }
                                        let _e1653 = phi_4946_;
                                        if (_e1627 < 0f) {
                                            phi_4952_ = -(_e1627);
                                        } else {
                                            phi_4952_ = _e1627;
                                        }
                                        let _e1657 = phi_4952_;
                                        if (_e1653 > _e1657) {
                                            phi_4957_ = 2u;
                                            phi_4958_ = 1u;
                                        } else {
                                            phi_4957_ = 1u;
                                            phi_4958_ = 0u;
                                        }
                                        let _e1660 = phi_4957_;
                                        let _e1662 = phi_4958_;
                                        phi_4977_ = _e1660;
                                        phi_4978_ = _e1662;
                                    } else {
                                        if (_e1624 < 0f) {
                                            phi_4964_ = -(_e1624);
                                        } else {
                                            phi_4964_ = _e1624;
                                        }
                                        let _e1640 = phi_4964_;
                                        if (_e1627 < 0f) {
                                            phi_4970_ = -(_e1627);
                                        } else {
                                            phi_4970_ = _e1627;
                                        }
                                        let _e1644 = phi_4970_;
                                        if (_e1640 > _e1644) {
                                            phi_4975_ = 0u;
                                            phi_4976_ = 2u;
                                        } else {
                                            phi_4975_ = 1u;
                                            phi_4976_ = 0u;
                                        }
                                        let _e1647 = phi_4975_;
                                        let _e1649 = phi_4976_;
                                        phi_4977_ = _e1647;
                                        phi_4978_ = _e1649;
                                    }
                                    let _e1664 = phi_4977_;
                                    let _e1666 = phi_4978_;
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
                                        phi_5045_ = -(_e1685);
                                    } else {
                                        phi_5045_ = _e1685;
                                    }
                                    let _e1719 = phi_5045_;
                                    if (_e1719 > _e1715) {
                                        if (_e1685 < 0f) {
                                            phi_5054_ = -1f;
                                        } else {
                                            phi_5054_ = 1f;
                                        }
                                        let _e1723 = phi_5054_;
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
                                            phi_5185_ = -(_e1822);
                                        } else {
                                            phi_5185_ = _e1822;
                                        }
                                        let _e1828 = phi_5185_;
                                        if (_e1823 < 0f) {
                                            phi_5191_ = -(_e1823);
                                        } else {
                                            phi_5191_ = _e1823;
                                        }
                                        let _e1832 = phi_5191_;
                                        if (_e1824 < 0f) {
                                            phi_5198_ = -(_e1824);
                                        } else {
                                            phi_5198_ = _e1824;
                                        }
                                        let _e1837 = phi_5198_;
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
                                        phi_5241_ = type_29(0u, 4u);
                                        phi_5244_ = true;
                                        loop {
                                            let _e1860 = phi_5241_;
                                            let _e1862 = phi_5244_;
                                            local_20 = _e1862;
                                            if (_e1860.member < _e1860.member_1) {
                                                phi_5242_ = type_29((_e1860.member + 1u), _e1860.member_1);
                                                phi_5267_ = type_29(1u, _e1860.member);
                                            } else {
                                                phi_5242_ = _e1860;
                                                phi_5267_ = type_29(0u, type_29().member_1);
                                            }
                                            let _e1876 = phi_5242_;
                                            let _e1878 = phi_5267_;
                                            if (bitcast<i32>(_e1878.member) != 0i) {
                                                if (_e1878.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1886 = local_6[_e1878.member_1].member;
                                                let _e1889 = local_6[_e1878.member_1].member_1;
                                                let _e1891 = (_e1886 < -(_e1889));
                                                if _e1891 {
                                                    phi_5294_ = bool();
                                                    phi_5295_ = false;
                                                } else {
                                                    phi_5294_ = (_e1862 && (_e1886 > _e1889));
                                                    phi_5295_ = true;
                                                }
                                                let _e1895 = phi_5294_;
                                                let _e1897 = phi_5295_;
                                                phi_5245_ = _e1895;
                                                phi_5296_ = _e1897;
                                                phi_5297_ = _e1891;
                                            } else {
                                                phi_5245_ = bool();
                                                phi_5296_ = false;
                                                phi_5297_ = false;
                                            }
                                            let _e1899 = phi_5245_;
                                            let _e1901 = phi_5296_;
                                            let _e1903 = phi_5297_;
                                            local_19 = _e1903;
                                            continue;
                                            continuing {
                                                phi_5241_ = _e1876;
                                                phi_5244_ = _e1899;
                                                break if !(_e1901);
                                            }
                                        }
                                        let _e1906 = local_19;
                                        if _e1906 {
                                            phi_5301_ = false;
                                        } else {
                                            phi_5301_ = true;
                                        }
                                        let _e1908 = phi_5301_;
                                        if _e1908 {
                                            let _e1910 = local_20;
                                            if _e1910 {
                                                phi_5308_ = 1u;
                                            } else {
                                                phi_5308_ = 2u;
                                            }
                                            let _e1912 = phi_5308_;
                                            phi_5309_ = _e1912;
                                            phi_5310_ = false;
                                        } else {
                                            phi_5309_ = u32();
                                            phi_5310_ = true;
                                        }
                                        let _e1914 = phi_5309_;
                                        let _e1916 = phi_5310_;
                                        phi_5311_ = _e1914;
                                        phi_5312_ = 0u;
                                        phi_5313_ = _e1916;
                                    } else {
                                        phi_5311_ = u32();
                                        phi_5312_ = 2u;
                                        phi_5313_ = true;
                                    }
                                    let _e1918 = phi_5311_;
                                    let _e1920 = phi_5312_;
                                    let _e1922 = phi_5313_;
                                    if _e1922 {
                                        phi_5317_ = _e1920;
                                    } else {
                                        phi_5317_ = _e1918;
                                    }
                                    let _e1924 = phi_5317_;
                                    let _e1925 = (_e1924 == 0u);
                                    if _e1925 {
                                        phi_6815_ = f32();
                                        phi_6816_ = false;
                                        phi_6817_ = false;
                                        phi_6818_ = false;
                                    } else {
                                        if (_e1924 == 1u) {
                                            if _e1208.member_2 {
                                                if ((_e1208.member_1 - _e1208.member) <= 0.0000005f) {
                                                    phi_5337_ = false;
                                                } else {
                                                    phi_5337_ = true;
                                                }
                                                let _e1933 = phi_5337_;
                                                phi_5338_ = _e1933;
                                            } else {
                                                phi_5338_ = true;
                                            }
                                            let _e1935 = phi_5338_;
                                            phi_5339_ = _e1935;
                                        } else {
                                            phi_5339_ = true;
                                        }
                                        let _e1937 = phi_5339_;
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
                                                phi_5535_ = -(_e1996[0]);
                                            } else {
                                                phi_5535_ = _e1996[0];
                                            }
                                            let _e2003 = phi_5535_;
                                            if (_e1996[1] < 0f) {
                                                phi_5542_ = -(_e1996[1]);
                                            } else {
                                                phi_5542_ = _e1996[1];
                                            }
                                            let _e2007 = phi_5542_;
                                            if (_e2003 > _e2007) {
                                                phi_5547_ = _e2003;
                                            } else {
                                                phi_5547_ = _e2007;
                                            }
                                            let _e2010 = phi_5547_;
                                            if (_e1996[2] < 0f) {
                                                phi_5554_ = -(_e1996[2]);
                                            } else {
                                                phi_5554_ = _e1996[2];
                                            }
                                            let _e2014 = phi_5554_;
                                            if (_e2010 > _e2014) {
                                                phi_5559_ = _e2010;
                                            } else {
                                                phi_5559_ = _e2014;
                                            }
                                            let _e2017 = phi_5559_;
                                            let _e2020 = local_15.member[1u];
                                            if (_e2020[0] < 0f) {
                                                phi_5572_ = -(_e2020[0]);
                                            } else {
                                                phi_5572_ = _e2020[0];
                                            }
                                            let _e2027 = phi_5572_;
                                            if (_e2020[1] < 0f) {
                                                phi_5579_ = -(_e2020[1]);
                                            } else {
                                                phi_5579_ = _e2020[1];
                                            }
                                            let _e2031 = phi_5579_;
                                            if (_e2027 > _e2031) {
                                                phi_5584_ = _e2027;
                                            } else {
                                                phi_5584_ = _e2031;
                                            }
                                            let _e2034 = phi_5584_;
                                            if (_e2020[2] < 0f) {
                                                phi_5591_ = -(_e2020[2]);
                                            } else {
                                                phi_5591_ = _e2020[2];
                                            }
                                            let _e2038 = phi_5591_;
                                            if (_e2034 > _e2038) {
                                                phi_5596_ = _e2034;
                                            } else {
                                                phi_5596_ = _e2038;
                                            }
                                            let _e2041 = phi_5596_;
                                            if (_e2017 > _e2041) {
                                                phi_5601_ = _e2017;
                                            } else {
                                                phi_5601_ = _e2041;
                                            }
                                            let _e2044 = phi_5601_;
                                            let _e2046 = local_15.member_3;
                                            let _e2050 = local_15.member_1[0u];
                                            if (_e2050[0] < 0f) {
                                                phi_5618_ = -(_e2050[0]);
                                            } else {
                                                phi_5618_ = _e2050[0];
                                            }
                                            let _e2057 = phi_5618_;
                                            if (_e2050[1] < 0f) {
                                                phi_5625_ = -(_e2050[1]);
                                            } else {
                                                phi_5625_ = _e2050[1];
                                            }
                                            let _e2061 = phi_5625_;
                                            if (_e2057 > _e2061) {
                                                phi_5630_ = _e2057;
                                            } else {
                                                phi_5630_ = _e2061;
                                            }
                                            let _e2064 = phi_5630_;
                                            if (_e2050[2] < 0f) {
                                                phi_5637_ = -(_e2050[2]);
                                            } else {
                                                phi_5637_ = _e2050[2];
                                            }
                                            let _e2068 = phi_5637_;
                                            if (_e2064 > _e2068) {
                                                phi_5642_ = _e2064;
                                            } else {
                                                phi_5642_ = _e2068;
                                            }
                                            let _e2071 = phi_5642_;
                                            let _e2074 = local_15.member_1[1u];
                                            if (_e2074[0] < 0f) {
                                                phi_5656_ = -(_e2074[0]);
                                            } else {
                                                phi_5656_ = _e2074[0];
                                            }
                                            let _e2081 = phi_5656_;
                                            if (_e2074[1] < 0f) {
                                                phi_5663_ = -(_e2074[1]);
                                            } else {
                                                phi_5663_ = _e2074[1];
                                            }
                                            let _e2085 = phi_5663_;
                                            if (_e2081 > _e2085) {
                                                phi_5668_ = _e2081;
                                            } else {
                                                phi_5668_ = _e2085;
                                            }
                                            let _e2088 = phi_5668_;
                                            if (_e2074[2] < 0f) {
                                                phi_5675_ = -(_e2074[2]);
                                            } else {
                                                phi_5675_ = _e2074[2];
                                            }
                                            let _e2092 = phi_5675_;
                                            if (_e2088 > _e2092) {
                                                phi_5680_ = _e2088;
                                            } else {
                                                phi_5680_ = _e2092;
                                            }
                                            let _e2095 = phi_5680_;
                                            if (_e2071 > _e2095) {
                                                phi_5685_ = _e2071;
                                            } else {
                                                phi_5685_ = _e2095;
                                            }
                                            let _e2098 = phi_5685_;
                                            let _e2100 = local_15.member_3;
                                            let _e2104 = local_15.member_2[0u];
                                            if (_e2104[0] < 0f) {
                                                phi_5702_ = -(_e2104[0]);
                                            } else {
                                                phi_5702_ = _e2104[0];
                                            }
                                            let _e2111 = phi_5702_;
                                            if (_e2104[1] < 0f) {
                                                phi_5709_ = -(_e2104[1]);
                                            } else {
                                                phi_5709_ = _e2104[1];
                                            }
                                            let _e2115 = phi_5709_;
                                            if (_e2111 > _e2115) {
                                                phi_5714_ = _e2111;
                                            } else {
                                                phi_5714_ = _e2115;
                                            }
                                            let _e2118 = phi_5714_;
                                            if (_e2104[2] < 0f) {
                                                phi_5721_ = -(_e2104[2]);
                                            } else {
                                                phi_5721_ = _e2104[2];
                                            }
                                            let _e2122 = phi_5721_;
                                            if (_e2118 > _e2122) {
                                                phi_5726_ = _e2118;
                                            } else {
                                                phi_5726_ = _e2122;
                                            }
                                            let _e2125 = phi_5726_;
                                            let _e2128 = local_15.member_2[1u];
                                            if (_e2128[0] < 0f) {
                                                phi_5740_ = -(_e2128[0]);
                                            } else {
                                                phi_5740_ = _e2128[0];
                                            }
                                            let _e2135 = phi_5740_;
                                            if (_e2128[1] < 0f) {
                                                phi_5747_ = -(_e2128[1]);
                                            } else {
                                                phi_5747_ = _e2128[1];
                                            }
                                            let _e2139 = phi_5747_;
                                            if (_e2135 > _e2139) {
                                                phi_5752_ = _e2135;
                                            } else {
                                                phi_5752_ = _e2139;
                                            }
                                            let _e2142 = phi_5752_;
                                            if (_e2128[2] < 0f) {
                                                phi_5759_ = -(_e2128[2]);
                                            } else {
                                                phi_5759_ = _e2128[2];
                                            }
                                            let _e2146 = phi_5759_;
                                            if (_e2142 > _e2146) {
                                                phi_5764_ = _e2142;
                                            } else {
                                                phi_5764_ = _e2146;
                                            }
                                            let _e2149 = phi_5764_;
                                            if (_e2125 > _e2149) {
                                                phi_5769_ = _e2125;
                                            } else {
                                                phi_5769_ = _e2149;
                                            }
                                            let _e2152 = phi_5769_;
                                            let _e2154 = local_15.member_3;
                                            let _e2161 = local_15.member_3;
                                            phi_5785_ = type_29(0u, 48u);
                                            phi_5788_ = _e1208.member;
                                            loop {
                                                let _e2167 = phi_5785_;
                                                let _e2169 = phi_5788_;
                                                local_65 = _e2169;
                                                local_27 = _e2169;
                                                local_28 = _e2169;
                                                local_29 = _e2169;
                                                local_30 = _e2169;
                                                if (_e2167.member < _e2167.member_1) {
                                                    phi_5786_ = type_29((_e2167.member + 1u), _e2167.member_1);
                                                    phi_5811_ = type_29(1u, _e2167.member);
                                                } else {
                                                    phi_5786_ = _e2167;
                                                    phi_5811_ = type_29(0u, type_29().member_1);
                                                }
                                                let _e2183 = phi_5786_;
                                                let _e2185 = phi_5811_;
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
                                                            phi_5985_ = ((_e2283 + _e2287) <= 1f);
                                                            phi_5986_ = false;
                                                        } else {
                                                            phi_5985_ = bool();
                                                            phi_5986_ = true;
                                                        }
                                                        let _e2293 = phi_5985_;
                                                        let _e2295 = phi_5986_;
                                                        phi_5987_ = _e2293;
                                                        phi_5988_ = _e2295;
                                                    } else {
                                                        phi_5987_ = bool();
                                                        phi_5988_ = true;
                                                    }
                                                    let _e2297 = phi_5987_;
                                                    let _e2299 = phi_5988_;
                                                    if _e2299 {
                                                        phi_5992_ = false;
                                                    } else {
                                                        phi_5992_ = _e2297;
                                                    }
                                                    let _e2301 = phi_5992_;
                                                    if (_e2279 > 0f) {
                                                        if _e2301 {
                                                            phi_6014_ = array<f32, 3>((_e2207 - ((_e2228 * _e2283) + (_e2249 * _e2287))), (_e2208 - ((_e2229 * _e2283) + (_e2250 * _e2287))), (_e2209 - ((_e2230 * _e2283) + (_e2251 * _e2287))));
                                                            phi_6015_ = false;
                                                        } else {
                                                            phi_6014_ = array<f32, 3>();
                                                            phi_6015_ = true;
                                                        }
                                                        let _e2317 = phi_6014_;
                                                        let _e2319 = phi_6015_;
                                                        phi_6016_ = _e2317;
                                                        phi_6017_ = _e2319;
                                                    } else {
                                                        phi_6016_ = array<f32, 3>();
                                                        phi_6017_ = true;
                                                    }
                                                    let _e2321 = phi_6016_;
                                                    let _e2323 = phi_6017_;
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
                                                                phi_6185_ = _e2340;
                                                            } else {
                                                                phi_6185_ = 1f;
                                                            }
                                                            let _e2344 = phi_6185_;
                                                            phi_6186_ = _e2344;
                                                        } else {
                                                            phi_6186_ = 0f;
                                                        }
                                                        let _e2346 = phi_6186_;
                                                        let _e2350 = (_e2324 - (_e2327 * _e2346));
                                                        let _e2351 = (_e2325 - (_e2328 * _e2346));
                                                        let _e2352 = (_e2326 - (_e2329 * _e2346));
                                                        let _e2363 = ((((_e2207 * _e2228) + (_e2208 * _e2229)) + (_e2209 * _e2230)) / (((_e2228 * _e2228) + (_e2229 * _e2229)) + (_e2230 * _e2230)));
                                                        if (_e2363 > 0f) {
                                                            if (_e2363 < 1f) {
                                                                phi_6213_ = _e2363;
                                                            } else {
                                                                phi_6213_ = 1f;
                                                            }
                                                            let _e2367 = phi_6213_;
                                                            phi_6214_ = _e2367;
                                                        } else {
                                                            phi_6214_ = 0f;
                                                        }
                                                        let _e2369 = phi_6214_;
                                                        let _e2386 = ((((_e2207 * _e2249) + (_e2208 * _e2250)) + (_e2209 * _e2251)) / (((_e2249 * _e2249) + (_e2250 * _e2250)) + (_e2251 * _e2251)));
                                                        if (_e2386 > 0f) {
                                                            if (_e2386 < 1f) {
                                                                phi_6241_ = _e2386;
                                                            } else {
                                                                phi_6241_ = 1f;
                                                            }
                                                            let _e2390 = phi_6241_;
                                                            phi_6242_ = _e2390;
                                                        } else {
                                                            phi_6242_ = 0f;
                                                        }
                                                        let _e2392 = phi_6242_;
                                                        local[0u] = array<f32, 3>((_e2207 - (_e2228 * _e2369)), (_e2208 - (_e2229 * _e2369)), (_e2209 - (_e2230 * _e2369)));
                                                        local[1u] = array<f32, 3>((_e2207 - (_e2249 * _e2392)), (_e2208 - (_e2250 * _e2392)), (_e2209 - (_e2251 * _e2392)));
                                                        local[2u] = array<f32, 3>(_e2350, _e2351, _e2352);
                                                        local[3u] = array<f32, 3>(_e2350, _e2351, _e2352);
                                                        let _e2408 = local[0u];
                                                        phi_6278_ = type_29(1u, 4u);
                                                        phi_6281_ = array<f32, 3>(_e2408[0], _e2408[1], _e2408[2]);
                                                        loop {
                                                            let _e2414 = phi_6278_;
                                                            let _e2416 = phi_6281_;
                                                            local_52 = _e2416;
                                                            if (_e2414.member < _e2414.member_1) {
                                                                phi_6279_ = type_29((_e2414.member + 1u), _e2414.member_1);
                                                                phi_6304_ = type_29(1u, _e2414.member);
                                                            } else {
                                                                phi_6279_ = _e2414;
                                                                phi_6304_ = type_29(0u, type_29().member_1);
                                                            }
                                                            let _e2430 = phi_6279_;
                                                            let _e2432 = phi_6304_;
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
                                                                    phi_6371_ = array<f32, 3>(_e2468[0], _e2468[1], _e2468[2]);
                                                                } else {
                                                                    phi_6371_ = _e2416;
                                                                }
                                                                let _e2474 = phi_6371_;
                                                                phi_6282_ = _e2474;
                                                            } else {
                                                                phi_6282_ = array<f32, 3>();
                                                            }
                                                            let _e2476 = phi_6282_;
                                                            continue;
                                                            continuing {
                                                                phi_6278_ = _e2430;
                                                                phi_6281_ = _e2476;
                                                                break if !(_e2436);
                                                            }
                                                        }
                                                        let _e5030 = local_52;
                                                        phi_6372_ = _e5030;
                                                    } else {
                                                        phi_6372_ = _e2321;
                                                    }
                                                    let _e2479 = phi_6372_;
                                                    if (_e2479[0] < 0f) {
                                                        phi_6379_ = -(_e2479[0]);
                                                    } else {
                                                        phi_6379_ = _e2479[0];
                                                    }
                                                    let _e2484 = phi_6379_;
                                                    if (_e2479[1] < 0f) {
                                                        phi_6386_ = -(_e2479[1]);
                                                    } else {
                                                        phi_6386_ = _e2479[1];
                                                    }
                                                    let _e2489 = phi_6386_;
                                                    if (_e2479[2] < 0f) {
                                                        phi_6394_ = -(_e2479[2]);
                                                    } else {
                                                        phi_6394_ = _e2479[2];
                                                    }
                                                    let _e2495 = phi_6394_;
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
                                                                    phi_6431_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6431_ = 0f;
                                                                }
                                                                let _e2571 = phi_6431_;
                                                                phi_6495_ = _e2571;
                                                            } else {
                                                                phi_6438_ = type_27(0i, 5i);
                                                                phi_6441_ = bitcast<f32>(((bitcast<u32>(_e2512) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2520 = phi_6438_;
                                                                    let _e2522 = phi_6441_;
                                                                    local_21 = _e2522;
                                                                    if (_e2520.member < _e2520.member_1) {
                                                                        let _e2530 = (_e2520.member + 1i);
                                                                        if ((false == (_e2530 > _e2520.member)) != false) {
                                                                            phi_6462_ = true;
                                                                        } else {
                                                                            phi_6462_ = false;
                                                                        }
                                                                        let _e2535 = phi_6462_;
                                                                        if _e2535 {
                                                                            phi_6468_ = type_28(0u, type_28().member_1);
                                                                        } else {
                                                                            phi_6468_ = type_28(1u, _e2530);
                                                                        }
                                                                        let _e2541 = phi_6468_;
                                                                        if (bitcast<i32>(_e2541.member) != 0i) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        phi_6439_ = type_27(_e2541.member_1, _e2520.member_1);
                                                                        phi_6482_ = type_28(1u, _e2520.member);
                                                                    } else {
                                                                        phi_6439_ = _e2520;
                                                                        phi_6482_ = type_28(0u, type_28().member_1);
                                                                    }
                                                                    let _e2551 = phi_6439_;
                                                                    let _e2553 = phi_6482_;
                                                                    let _e2556 = (bitcast<i32>(_e2553.member) != 0i);
                                                                    if _e2556 {
                                                                        phi_6442_ = (0.5f * (_e2522 + (_e2512 / _e2522)));
                                                                    } else {
                                                                        phi_6442_ = f32();
                                                                    }
                                                                    let _e2561 = phi_6442_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6438_ = _e2551;
                                                                        phi_6441_ = _e2561;
                                                                        break if !(_e2556);
                                                                    }
                                                                }
                                                                let _e2566 = local_21;
                                                                phi_6495_ = (_e2566 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2573 = phi_6495_;
                                                            phi_6504_ = type_29(0u, 4u);
                                                            phi_6507_ = 2f;
                                                            loop {
                                                                let _e2581 = phi_6504_;
                                                                let _e2583 = phi_6507_;
                                                                local_23 = _e2583;
                                                                local_24 = _e2583;
                                                                local_25 = _e2583;
                                                                local_55 = _e2583;
                                                                local_56 = _e2583;
                                                                if (_e2581.member < _e2581.member_1) {
                                                                    phi_6505_ = type_29((_e2581.member + 1u), _e2581.member_1);
                                                                    phi_6530_ = type_29(1u, _e2581.member);
                                                                } else {
                                                                    phi_6505_ = _e2581;
                                                                    phi_6530_ = type_29(0u, type_29().member_1);
                                                                }
                                                                let _e2597 = phi_6505_;
                                                                let _e2599 = phi_6530_;
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
                                                                        phi_6581_ = -(_e2614);
                                                                    } else {
                                                                        phi_6581_ = _e2614;
                                                                    }
                                                                    let _e2629 = phi_6581_;
                                                                    if (_e2625 < 0f) {
                                                                        phi_6587_ = -(_e2625);
                                                                    } else {
                                                                        phi_6587_ = _e2625;
                                                                    }
                                                                    let _e2633 = phi_6587_;
                                                                    let _e2637 = (((((((((_e2044 + _e2046) + (_e2098 + _e2100)) + (_e2152 + _e2154)) * (0.000000059604645f * 16f)) + (_e2161 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2573) * (1f + (0.000000059604645f * 8f)))) + ((_e2629 + _e2633) * (0.000000059604645f * 8f)));
                                                                    if (_e2614 > _e2637) {
                                                                        if (_e2625 > _e2637) {
                                                                            phi_6600_ = false;
                                                                        } else {
                                                                            phi_6600_ = true;
                                                                        }
                                                                        let _e2641 = phi_6600_;
                                                                        phi_6601_ = _e2641;
                                                                    } else {
                                                                        phi_6601_ = true;
                                                                    }
                                                                    let _e2643 = phi_6601_;
                                                                    if _e2643 {
                                                                        if ((_e2614 + ((_e2625 - _e2614) * _e2169)) > _e2637) {
                                                                            if (_e2625 < _e2614) {
                                                                                let _e2651 = ((_e2614 - _e2625) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                                                if _e2651 {
                                                                                    let _e2657 = (((_e2614 - _e2637) / (_e2614 - _e2625)) * (1f - (0.000000059604645f * 16f)));
                                                                                    if (_e2583 < _e2657) {
                                                                                        phi_6632_ = _e2583;
                                                                                    } else {
                                                                                        phi_6632_ = _e2657;
                                                                                    }
                                                                                    let _e2660 = phi_6632_;
                                                                                    phi_6633_ = _e2660;
                                                                                } else {
                                                                                    phi_6633_ = f32();
                                                                                }
                                                                                let _e2662 = phi_6633_;
                                                                                phi_6634_ = _e2662;
                                                                                phi_6635_ = _e2651;
                                                                            } else {
                                                                                phi_6634_ = _e2583;
                                                                                phi_6635_ = true;
                                                                            }
                                                                            let _e2664 = phi_6634_;
                                                                            let _e2666 = phi_6635_;
                                                                            if _e2666 {
                                                                                phi_6639_ = false;
                                                                            } else {
                                                                                phi_6639_ = true;
                                                                            }
                                                                            let _e2668 = phi_6639_;
                                                                            phi_6640_ = _e2664;
                                                                            phi_6641_ = _e2666;
                                                                            phi_6642_ = _e2668;
                                                                            phi_6643_ = false;
                                                                        } else {
                                                                            phi_6640_ = f32();
                                                                            phi_6641_ = false;
                                                                            phi_6642_ = false;
                                                                            phi_6643_ = true;
                                                                        }
                                                                        let _e2670 = phi_6640_;
                                                                        let _e2672 = phi_6641_;
                                                                        let _e2674 = phi_6642_;
                                                                        let _e2676 = phi_6643_;
                                                                        phi_6644_ = _e2670;
                                                                        phi_6645_ = _e2672;
                                                                        phi_6646_ = _e2674;
                                                                        phi_6647_ = _e2676;
                                                                    } else {
                                                                        phi_6644_ = _e2583;
                                                                        phi_6645_ = true;
                                                                        phi_6646_ = false;
                                                                        phi_6647_ = false;
                                                                    }
                                                                    let _e2678 = phi_6644_;
                                                                    let _e2680 = phi_6645_;
                                                                    let _e2682 = phi_6646_;
                                                                    let _e2684 = phi_6647_;
                                                                    phi_6508_ = _e2678;
                                                                    phi_6648_ = _e2680;
                                                                    phi_6649_ = false;
                                                                    phi_6650_ = _e2682;
                                                                    phi_6651_ = _e2684;
                                                                } else {
                                                                    phi_6508_ = f32();
                                                                    phi_6648_ = false;
                                                                    phi_6649_ = true;
                                                                    phi_6650_ = false;
                                                                    phi_6651_ = false;
                                                                }
                                                                let _e2686 = phi_6508_;
                                                                let _e2688 = phi_6648_;
                                                                let _e2690 = phi_6649_;
                                                                let _e2692 = phi_6650_;
                                                                let _e2694 = phi_6651_;
                                                                local_22 = _e2690;
                                                                local_53 = _e2692;
                                                                local_54 = _e2694;
                                                                continue;
                                                                continuing {
                                                                    phi_6504_ = _e2597;
                                                                    phi_6507_ = _e2686;
                                                                    break if !(_e2688);
                                                                }
                                                            }
                                                            let _e2697 = local_22;
                                                            if _e2697 {
                                                                let _e2699 = local_23;
                                                                let _e2700 = (_e2699 > _e1208.member_1);
                                                                if _e2700 {
                                                                    phi_6672_ = false;
                                                                    phi_6673_ = false;
                                                                    phi_6674_ = false;
                                                                } else {
                                                                    let _e2702 = local_24;
                                                                    if (_e2702 > _e2169) {
                                                                        let _e2705 = local_25;
                                                                        let _e2707 = ((_e2705 - _e2169) < 0.00000000023283064f);
                                                                        if _e2707 {
                                                                            phi_6668_ = false;
                                                                        } else {
                                                                            phi_6668_ = true;
                                                                        }
                                                                        let _e2709 = phi_6668_;
                                                                        phi_6669_ = _e2709;
                                                                        phi_6670_ = _e2707;
                                                                        phi_6671_ = false;
                                                                    } else {
                                                                        phi_6669_ = false;
                                                                        phi_6670_ = false;
                                                                        phi_6671_ = true;
                                                                    }
                                                                    let _e2711 = phi_6669_;
                                                                    let _e2713 = phi_6670_;
                                                                    let _e2715 = phi_6671_;
                                                                    phi_6672_ = _e2711;
                                                                    phi_6673_ = _e2713;
                                                                    phi_6674_ = _e2715;
                                                                }
                                                                let _e2717 = phi_6672_;
                                                                let _e2719 = phi_6673_;
                                                                let _e2721 = phi_6674_;
                                                                phi_6675_ = _e2717;
                                                                phi_6676_ = _e2700;
                                                                phi_6677_ = _e2719;
                                                                phi_6678_ = _e2721;
                                                                phi_6679_ = false;
                                                                phi_6680_ = false;
                                                            } else {
                                                                phi_6675_ = false;
                                                                phi_6676_ = false;
                                                                phi_6677_ = false;
                                                                phi_6678_ = false;
                                                                let _e5087 = local_53;
                                                                phi_6679_ = _e5087;
                                                                let _e5090 = local_54;
                                                                phi_6680_ = _e5090;
                                                            }
                                                            let _e2723 = phi_6675_;
                                                            let _e2725 = phi_6676_;
                                                            let _e2727 = phi_6677_;
                                                            let _e2729 = phi_6678_;
                                                            let _e2731 = phi_6679_;
                                                            let _e2733 = phi_6680_;
                                                            let _e5093 = local_55;
                                                            phi_6681_ = _e5093;
                                                            let _e5096 = local_56;
                                                            phi_6682_ = _e5096;
                                                            phi_6683_ = _e2723;
                                                            phi_6684_ = _e2725;
                                                            phi_6685_ = _e2727;
                                                            phi_6686_ = _e2729;
                                                            phi_6687_ = _e2731;
                                                            phi_6688_ = _e2733;
                                                            phi_6689_ = false;
                                                        } else {
                                                            phi_6681_ = f32();
                                                            phi_6682_ = f32();
                                                            phi_6683_ = false;
                                                            phi_6684_ = false;
                                                            phi_6685_ = false;
                                                            phi_6686_ = false;
                                                            phi_6687_ = false;
                                                            phi_6688_ = false;
                                                            phi_6689_ = true;
                                                        }
                                                        let _e2735 = phi_6681_;
                                                        let _e2737 = phi_6682_;
                                                        let _e2739 = phi_6683_;
                                                        let _e2741 = phi_6684_;
                                                        let _e2743 = phi_6685_;
                                                        let _e2745 = phi_6686_;
                                                        let _e2747 = phi_6687_;
                                                        let _e2749 = phi_6688_;
                                                        let _e2751 = phi_6689_;
                                                        phi_6690_ = _e2735;
                                                        phi_6691_ = _e2737;
                                                        phi_6692_ = _e2739;
                                                        phi_6693_ = _e2741;
                                                        phi_6694_ = _e2743;
                                                        phi_6695_ = _e2745;
                                                        phi_6696_ = _e2747;
                                                        phi_6697_ = _e2749;
                                                        phi_6698_ = _e2751;
                                                        phi_6699_ = false;
                                                    } else {
                                                        phi_6690_ = f32();
                                                        phi_6691_ = f32();
                                                        phi_6692_ = false;
                                                        phi_6693_ = false;
                                                        phi_6694_ = false;
                                                        phi_6695_ = false;
                                                        phi_6696_ = false;
                                                        phi_6697_ = false;
                                                        phi_6698_ = false;
                                                        phi_6699_ = true;
                                                    }
                                                    let _e2753 = phi_6690_;
                                                    let _e2755 = phi_6691_;
                                                    let _e2757 = phi_6692_;
                                                    let _e2759 = phi_6693_;
                                                    let _e2761 = phi_6694_;
                                                    let _e2763 = phi_6695_;
                                                    let _e2765 = phi_6696_;
                                                    let _e2767 = phi_6697_;
                                                    let _e2769 = phi_6698_;
                                                    let _e2771 = phi_6699_;
                                                    phi_6700_ = _e2753;
                                                    phi_5789_ = _e2755;
                                                    phi_6701_ = _e2757;
                                                    phi_6702_ = _e2759;
                                                    phi_6703_ = _e2761;
                                                    phi_6704_ = false;
                                                    phi_6705_ = _e2763;
                                                    phi_6706_ = _e2765;
                                                    phi_6707_ = _e2767;
                                                    phi_6708_ = _e2769;
                                                    phi_6709_ = _e2771;
                                                } else {
                                                    phi_6700_ = f32();
                                                    phi_5789_ = f32();
                                                    phi_6701_ = false;
                                                    phi_6702_ = false;
                                                    phi_6703_ = false;
                                                    phi_6704_ = true;
                                                    phi_6705_ = false;
                                                    phi_6706_ = false;
                                                    phi_6707_ = false;
                                                    phi_6708_ = false;
                                                    phi_6709_ = false;
                                                }
                                                let _e2773 = phi_6700_;
                                                let _e2775 = phi_5789_;
                                                let _e2777 = phi_6701_;
                                                let _e2779 = phi_6702_;
                                                let _e2781 = phi_6703_;
                                                let _e2783 = phi_6704_;
                                                let _e2785 = phi_6705_;
                                                let _e2787 = phi_6706_;
                                                let _e2789 = phi_6707_;
                                                let _e2791 = phi_6708_;
                                                let _e2793 = phi_6709_;
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
                                                    phi_5785_ = _e2183;
                                                    phi_5788_ = _e2775;
                                                    break if !(_e2777);
                                                }
                                            }
                                            let _e2796 = local_26;
                                            if _e2796 {
                                                phi_6714_ = type_56(0u, type_56().member_1);
                                                phi_6715_ = false;
                                                phi_6716_ = false;
                                                phi_6717_ = false;
                                                phi_6718_ = false;
                                                phi_6719_ = false;
                                                phi_6720_ = false;
                                                phi_6721_ = false;
                                            } else {
                                                phi_6714_ = type_56();
                                                let _e5129 = local_57;
                                                phi_6715_ = _e5129;
                                                let _e5132 = local_58;
                                                phi_6716_ = _e5132;
                                                let _e5135 = local_59;
                                                phi_6717_ = _e5135;
                                                let _e5138 = local_60;
                                                phi_6718_ = _e5138;
                                                let _e5141 = local_61;
                                                phi_6719_ = _e5141;
                                                let _e5144 = local_62;
                                                phi_6720_ = _e5144;
                                                let _e5147 = local_63;
                                                phi_6721_ = _e5147;
                                            }
                                            let _e2801 = phi_6714_;
                                            let _e2803 = phi_6715_;
                                            let _e2805 = phi_6716_;
                                            let _e2807 = phi_6717_;
                                            let _e2809 = phi_6718_;
                                            let _e2811 = phi_6719_;
                                            let _e2813 = phi_6720_;
                                            let _e2815 = phi_6721_;
                                            if _e2803 {
                                                let _e5150 = local_64;
                                                phi_6725_ = _e5150;
                                                phi_6726_ = true;
                                                phi_6727_ = false;
                                                phi_6728_ = false;
                                                phi_6729_ = false;
                                                phi_6730_ = false;
                                                phi_6731_ = false;
                                                phi_6732_ = false;
                                            } else {
                                                let _e5152 = local_65;
                                                phi_6725_ = _e5152;
                                                phi_6726_ = _e2805;
                                                phi_6727_ = _e2807;
                                                phi_6728_ = _e2809;
                                                phi_6729_ = _e2811;
                                                let _e5159 = local_66;
                                                phi_6730_ = _e5159;
                                                phi_6731_ = _e2813;
                                                phi_6732_ = _e2815;
                                            }
                                            let _e2817 = phi_6725_;
                                            let _e2819 = phi_6726_;
                                            let _e2821 = phi_6727_;
                                            let _e2823 = phi_6728_;
                                            let _e2825 = phi_6729_;
                                            let _e2827 = phi_6730_;
                                            let _e2829 = phi_6731_;
                                            let _e2831 = phi_6732_;
                                            if _e2819 {
                                                phi_6737_ = type_56(1u, _e2817);
                                                phi_6738_ = false;
                                                phi_6739_ = false;
                                                phi_6740_ = false;
                                                phi_6741_ = false;
                                                phi_6742_ = false;
                                                phi_6743_ = false;
                                            } else {
                                                phi_6737_ = type_56();
                                                phi_6738_ = _e2821;
                                                phi_6739_ = _e2823;
                                                phi_6740_ = _e2825;
                                                phi_6741_ = _e2827;
                                                phi_6742_ = _e2829;
                                                phi_6743_ = _e2831;
                                            }
                                            let _e2834 = phi_6737_;
                                            let _e2836 = phi_6738_;
                                            let _e2838 = phi_6739_;
                                            let _e2840 = phi_6740_;
                                            let _e2842 = phi_6741_;
                                            let _e2844 = phi_6742_;
                                            let _e2846 = phi_6743_;
                                            if _e2836 {
                                                let _e2848 = local_27;
                                                phi_6748_ = type_56(1u, _e2848);
                                                phi_6749_ = false;
                                                phi_6750_ = false;
                                                phi_6751_ = true;
                                                phi_6752_ = false;
                                                phi_6753_ = false;
                                            } else {
                                                phi_6748_ = _e2801;
                                                phi_6749_ = _e2838;
                                                phi_6750_ = _e2840;
                                                phi_6751_ = _e2842;
                                                phi_6752_ = _e2844;
                                                phi_6753_ = _e2846;
                                            }
                                            let _e2851 = phi_6748_;
                                            let _e2853 = phi_6749_;
                                            let _e2855 = phi_6750_;
                                            let _e2857 = phi_6751_;
                                            let _e2859 = phi_6752_;
                                            let _e2861 = phi_6753_;
                                            if _e2853 {
                                                let _e2863 = local_28;
                                                phi_6758_ = type_56(1u, _e2863);
                                                phi_6759_ = false;
                                                phi_6760_ = false;
                                                phi_6761_ = false;
                                                phi_6762_ = false;
                                            } else {
                                                phi_6758_ = type_56();
                                                phi_6759_ = _e2855;
                                                phi_6760_ = _e2857;
                                                phi_6761_ = _e2859;
                                                phi_6762_ = _e2861;
                                            }
                                            let _e2866 = phi_6758_;
                                            let _e2868 = phi_6759_;
                                            let _e2870 = phi_6760_;
                                            let _e2872 = phi_6761_;
                                            let _e2874 = phi_6762_;
                                            if _e2868 {
                                                let _e2876 = local_29;
                                                phi_6767_ = type_56(1u, _e2876);
                                                phi_6768_ = true;
                                                phi_6769_ = false;
                                                phi_6770_ = false;
                                                phi_6771_ = false;
                                            } else {
                                                phi_6767_ = _e2866;
                                                phi_6768_ = _e2853;
                                                phi_6769_ = _e2870;
                                                phi_6770_ = _e2872;
                                                phi_6771_ = _e2874;
                                            }
                                            let _e2879 = phi_6767_;
                                            let _e2881 = phi_6768_;
                                            let _e2883 = phi_6769_;
                                            let _e2885 = phi_6770_;
                                            let _e2887 = phi_6771_;
                                            if _e2881 {
                                                phi_6775_ = _e2879;
                                                phi_6776_ = true;
                                                phi_6777_ = false;
                                                phi_6778_ = false;
                                            } else {
                                                phi_6775_ = _e2851;
                                                phi_6776_ = _e2883;
                                                phi_6777_ = _e2885;
                                                phi_6778_ = _e2887;
                                            }
                                            let _e2889 = phi_6775_;
                                            let _e2891 = phi_6776_;
                                            let _e2893 = phi_6777_;
                                            let _e2895 = phi_6778_;
                                            if _e2891 {
                                                phi_6782_ = false;
                                                phi_6783_ = false;
                                            } else {
                                                phi_6782_ = _e2893;
                                                phi_6783_ = _e2895;
                                            }
                                            let _e2897 = phi_6782_;
                                            let _e2899 = phi_6783_;
                                            if _e2897 {
                                                phi_6787_ = false;
                                                phi_6788_ = false;
                                            } else {
                                                phi_6787_ = _e2899;
                                                phi_6788_ = _e2891;
                                            }
                                            let _e2901 = phi_6787_;
                                            let _e2903 = phi_6788_;
                                            if _e2901 {
                                                phi_6792_ = true;
                                                phi_6793_ = false;
                                            } else {
                                                phi_6792_ = _e2897;
                                                phi_6793_ = _e2903;
                                            }
                                            let _e2905 = phi_6792_;
                                            let _e2907 = phi_6793_;
                                            if _e2905 {
                                                let _e2909 = local_30;
                                                phi_6798_ = type_56(1u, _e2909);
                                                phi_6799_ = true;
                                            } else {
                                                phi_6798_ = _e2889;
                                                phi_6799_ = _e2907;
                                            }
                                            let _e2912 = phi_6798_;
                                            let _e2914 = phi_6799_;
                                            if _e2914 {
                                                phi_6803_ = _e2912;
                                            } else {
                                                phi_6803_ = _e2834;
                                            }
                                            let _e2916 = phi_6803_;
                                            let _e2919 = (_e2916.member != 0u);
                                            if _e2919 {
                                                phi_6810_ = false;
                                            } else {
                                                phi_6810_ = true;
                                            }
                                            let _e2921 = phi_6810_;
                                            phi_6811_ = _e2916.member_1;
                                            phi_6812_ = _e2921;
                                            phi_6813_ = _e2919;
                                            phi_6814_ = false;
                                        } else {
                                            phi_6811_ = f32();
                                            phi_6812_ = false;
                                            phi_6813_ = false;
                                            phi_6814_ = true;
                                        }
                                        let _e2923 = phi_6811_;
                                        let _e2925 = phi_6812_;
                                        let _e2927 = phi_6813_;
                                        let _e2929 = phi_6814_;
                                        phi_6815_ = _e2923;
                                        phi_6816_ = _e2925;
                                        phi_6817_ = _e2927;
                                        phi_6818_ = _e2929;
                                    }
                                    let _e2931 = phi_6815_;
                                    let _e2933 = phi_6816_;
                                    let _e2935 = phi_6817_;
                                    let _e2937 = phi_6818_;
                                    phi_6819_ = _e2931;
                                    phi_6820_ = _e1925;
                                    phi_6821_ = _e2933;
                                    phi_6822_ = _e2935;
                                    phi_6823_ = _e2937;
                                }
                                let _e2939 = phi_6819_;
                                let _e2941 = phi_6820_;
                                let _e2943 = phi_6821_;
                                let _e2945 = phi_6822_;
                                let _e2947 = phi_6823_;
                                if _e2941 {
                                    phi_6827_ = true;
                                    phi_6828_ = false;
                                    phi_6829_ = false;
                                } else {
                                    phi_6827_ = _e2943;
                                    phi_6828_ = _e2945;
                                    phi_6829_ = _e2947;
                                }
                                let _e2949 = phi_6827_;
                                let _e2951 = phi_6828_;
                                let _e2953 = phi_6829_;
                                phi_6830_ = _e2939;
                                phi_6831_ = _e1208;
                                phi_6832_ = _e2949;
                                phi_6833_ = false;
                                phi_6834_ = _e2951;
                                phi_6835_ = _e2953;
                            } else {
                                phi_6830_ = f32();
                                phi_6831_ = type_57();
                                phi_6832_ = false;
                                phi_6833_ = true;
                                phi_6834_ = false;
                                phi_6835_ = false;
                            }
                            let _e2955 = phi_6830_;
                            let _e2957 = phi_6831_;
                            let _e2959 = phi_6832_;
                            let _e2961 = phi_6833_;
                            let _e2963 = phi_6834_;
                            let _e2965 = phi_6835_;
                            local_31 = _e2961;
                            local_67 = _e2963;
                            local_68 = _e2965;
                            local_32 = _e2955;
                            local_33 = _e2957;
                            continue;
                            continuing {
                                phi_3872_ = _e907;
                                break if !(_e2959);
                            }
                        }
                        let _e2968 = local_31;
                        if _e2968 {
                            phi_6840_ = type_56(0u, type_56().member_1);
                            phi_6841_ = false;
                            phi_6842_ = false;
                        } else {
                            phi_6840_ = type_56();
                            let _e5229 = local_67;
                            phi_6841_ = _e5229;
                            let _e5232 = local_68;
                            phi_6842_ = _e5232;
                        }
                        let _e2973 = phi_6840_;
                        let _e2975 = phi_6841_;
                        let _e2977 = phi_6842_;
                        if _e2975 {
                            let _e2979 = local_32;
                            phi_6847_ = type_56(2u, _e2979);
                            phi_6848_ = false;
                        } else {
                            phi_6847_ = type_56();
                            phi_6848_ = _e2977;
                        }
                        let _e2982 = phi_6847_;
                        let _e2984 = phi_6848_;
                        if _e2984 {
                            let _e2986 = local_33;
                            phi_6854_ = type_56(1u, _e2986.member);
                            phi_6855_ = true;
                        } else {
                            phi_6854_ = _e2982;
                            phi_6855_ = _e2975;
                        }
                        let _e2990 = phi_6854_;
                        let _e2992 = phi_6855_;
                        if _e2992 {
                            phi_6859_ = _e2990;
                        } else {
                            phi_6859_ = _e2973;
                        }
                        let _e2994 = phi_6859_;
                        phi_6863_ = _e2994;
                    }
                    let _e4581 = phi_6863_;
                    phi_6864_ = _e4581;
                }
                let _e4586 = phi_6864_;
                switch bitcast<i32>(_e4586.member) {
                    case 0: {
                        phi_6877_ = type_59(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4592 = function_(_e4586.member_1);
                        phi_6877_ = type_59(0u, _e4592, true);
                        break;
                    }
                    case 2: {
                        let _e4590 = function_(_e4586.member_1);
                        phi_6877_ = type_59(1u, _e4590, true);
                        break;
                    }
                    default: {
                        phi_6877_ = type_59();
                        break;
                    }
                }
                let _e4595 = phi_6877_;
                if _e4595.member_2 {
                    phi_6884_ = (_e4595.member == 0u);
                } else {
                    phi_6884_ = false;
                }
                let _e4600 = phi_6884_;
                if _e4600 {
                    let _e4608 = (_e4595.member_1[1] >> bitcast<u32>(20i));
                    if (_e4608 <= 896u) {
                        phi_6908_ = 0u;
                    } else {
                        phi_6908_ = ((((_e4608 - 896u) << bitcast<u32>(23i)) | ((_e4595.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4595.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4623 = phi_6908_;
                    let _e4625 = atomicMin((&earliest.member[0u]), _e4623);
                }
                phi_6912_ = type_50(_e177, 0u, _e183, _e186, _e4595.member_1);
                phi_6913_ = _e4600;
                phi_6914_ = (_e4595.member != 0u);
            } else {
                phi_6912_ = type_50(_e177, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_6913_ = false;
                phi_6914_ = false;
            }
            let _e4627 = phi_6912_;
            let _e4629 = phi_6913_;
            let _e4631 = phi_6914_;
            let _e4633 = params.member.member_1;
            if ((_e4633 & 16u) != 0u) {
                if (_e108 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4629 {
                    let _e4639 = atomicAdd((&counters[0u]), 1u);
                    phi_6932_ = _e4639;
                } else {
                    phi_6932_ = 0u;
                }
                let _e4641 = phi_6932_;
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
                phi_6994_ = _e4679;
            } else {
                phi_6994_ = 0u;
            }
            let _e4681 = phi_6994_;
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
            phi_274_ = _e165;
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
