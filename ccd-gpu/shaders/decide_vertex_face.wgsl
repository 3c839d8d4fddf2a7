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
    member: array<array<u32, 3>>,
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
@group(0) @binding(3) 
var<storage> input: type_12;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_37;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_37;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_37;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> elements: type_14;

fn function_(param: f32) -> array<u32, 2> {
    var phi_172_: array<u32, 2>;
    var phi_173_: array<u32, 2>;
    var phi_174_: bool;
    var phi_178_: array<u32, 2>;

    let _e13 = bitcast<u32>(param);
    if (_e13 < 8388608u) {
        phi_173_ = array<u32, 2>();
        phi_174_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_172_ = array<u32, 2>();
        } else {
            phi_172_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_172_;
        phi_173_ = _e31;
        phi_174_ = _e17;
    }
    let _e33 = phi_173_;
    let _e35 = phi_174_;
    if _e35 {
        phi_178_ = array<u32, 2>(0u, 0u);
    } else {
        phi_178_ = _e33;
    }
    let _e37 = phi_178_;
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
    var phi_233_: u32;
    var phi_249_: u32;
    var phi_270_: u32;
    var phi_271_: u32;
    var phi_274_: type_19;
    var phi_275_: type_19;
    var phi_298_: type_19;
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
    var phi_3692_: type_17;
    var phi_3695_: f32;
    var phi_3716_: bool;
    var phi_3722_: type_18;
    var phi_3693_: type_17;
    var phi_3736_: type_18;
    var phi_3696_: f32;
    var local_16: f32;
    var phi_3685_: f32;
    var phi_3749_: f32;
    var phi_3755_: f32;
    var phi_3780_: type_19;
    var phi_3783_: u32;
    var phi_3781_: type_19;
    var phi_3806_: type_19;
    var phi_3850_: u32;
    var phi_3851_: u32;
    var phi_3784_: u32;
    var phi_3852_: u32;
    var phi_3872_: type_19;
    var phi_3873_: type_19;
    var phi_3896_: type_19;
    var phi_3948_: f32;
    var phi_3955_: f32;
    var phi_3966_: bool;
    var phi_3967_: bool;
    var phi_3968_: bool;
    var phi_3969_: bool;
    var phi_3973_: bool;
    var phi_3984_: type_33;
    var phi_3985_: type_33;
    var phi_3986_: bool;
    var phi_3987_: type_33;
    var phi_3988_: bool;
    var phi_3999_: f32;
    var phi_4009_: type_19;
    var phi_4012_: f32;
    var phi_4014_: f32;
    var phi_4016_: f32;
    var phi_4010_: type_19;
    var phi_4039_: type_19;
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
    var phi_4139_: type_19;
    var phi_4142_: f32;
    var phi_4140_: type_19;
    var phi_4165_: type_19;
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
    var phi_4257_: type_33;
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
    var phi_5241_: type_19;
    var phi_5244_: bool;
    var phi_5242_: type_19;
    var phi_5267_: type_19;
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
    var phi_5785_: type_19;
    var phi_5788_: f32;
    var phi_5786_: type_19;
    var phi_5811_: type_19;
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
    var phi_6278_: type_19;
    var phi_6281_: array<f32, 3>;
    var phi_6279_: type_19;
    var phi_6304_: type_19;
    var phi_6371_: array<f32, 3>;
    var phi_6282_: array<f32, 3>;
    var phi_6372_: array<f32, 3>;
    var phi_6379_: f32;
    var phi_6386_: f32;
    var phi_6394_: f32;
    var phi_6438_: type_17;
    var phi_6441_: f32;
    var phi_6462_: bool;
    var phi_6468_: type_18;
    var phi_6439_: type_17;
    var phi_6482_: type_18;
    var phi_6442_: f32;
    var local_21: f32;
    var phi_6431_: f32;
    var phi_6495_: f32;
    var phi_6504_: type_19;
    var phi_6507_: f32;
    var phi_6505_: type_19;
    var phi_6530_: type_19;
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
    var phi_6714_: type_32;
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
    var phi_6737_: type_32;
    var phi_6738_: bool;
    var phi_6739_: bool;
    var phi_6740_: bool;
    var phi_6741_: bool;
    var phi_6742_: bool;
    var phi_6743_: bool;
    var local_27: f32;
    var phi_6748_: type_32;
    var phi_6749_: bool;
    var phi_6750_: bool;
    var phi_6751_: bool;
    var phi_6752_: bool;
    var phi_6753_: bool;
    var local_28: f32;
    var phi_6758_: type_32;
    var phi_6759_: bool;
    var phi_6760_: bool;
    var phi_6761_: bool;
    var phi_6762_: bool;
    var local_29: f32;
    var phi_6767_: type_32;
    var phi_6768_: bool;
    var phi_6769_: bool;
    var phi_6770_: bool;
    var phi_6771_: bool;
    var phi_6775_: type_32;
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
    var phi_6798_: type_32;
    var phi_6799_: bool;
    var phi_6803_: type_32;
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
    var phi_6831_: type_33;
    var phi_6832_: bool;
    var phi_6833_: bool;
    var phi_6834_: bool;
    var phi_6835_: bool;
    var local_31: bool;
    var phi_6840_: type_32;
    var phi_6841_: bool;
    var phi_6842_: bool;
    var local_32: f32;
    var phi_6847_: type_32;
    var phi_6848_: bool;
    var local_33: type_33;
    var phi_6854_: type_32;
    var phi_6855_: bool;
    var phi_6859_: type_32;
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
    var phi_1577_: type_19;
    var phi_1580_: f32;
    var phi_1578_: type_19;
    var phi_1603_: type_19;
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
    var phi_2070_: type_19;
    var phi_2073_: array<f32, 3>;
    var phi_2071_: type_19;
    var phi_2096_: type_19;
    var phi_2163_: array<f32, 3>;
    var phi_2074_: array<f32, 3>;
    var phi_2164_: array<f32, 3>;
    var phi_2171_: f32;
    var phi_2178_: f32;
    var phi_2186_: f32;
    var phi_2230_: type_17;
    var phi_2233_: f32;
    var phi_2254_: bool;
    var phi_2260_: type_18;
    var phi_2231_: type_17;
    var phi_2274_: type_18;
    var phi_2234_: f32;
    var local_34: f32;
    var phi_2223_: f32;
    var phi_2287_: f32;
    var phi_2296_: type_19;
    var phi_2299_: f32;
    var phi_2297_: type_19;
    var phi_2322_: type_19;
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
    var phi_2506_: type_32;
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
    var phi_2529_: type_32;
    var phi_2530_: bool;
    var phi_2531_: bool;
    var phi_2532_: bool;
    var phi_2533_: bool;
    var phi_2534_: bool;
    var phi_2535_: bool;
    var local_40: f32;
    var phi_2540_: type_32;
    var phi_2541_: bool;
    var phi_2542_: bool;
    var phi_2543_: bool;
    var phi_2544_: bool;
    var phi_2545_: bool;
    var local_41: f32;
    var phi_2550_: type_32;
    var phi_2551_: bool;
    var phi_2552_: bool;
    var phi_2553_: bool;
    var phi_2554_: bool;
    var local_42: f32;
    var phi_2559_: type_32;
    var phi_2560_: bool;
    var phi_2561_: bool;
    var phi_2562_: bool;
    var phi_2563_: bool;
    var phi_2567_: type_32;
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
    var phi_2590_: type_32;
    var phi_2591_: bool;
    var phi_2595_: type_32;
    var phi_2609_: type_19;
    var phi_2610_: type_19;
    var phi_2633_: type_19;
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
    var phi_3114_: type_19;
    var phi_3117_: array<f32, 3>;
    var phi_3115_: type_19;
    var phi_3140_: type_19;
    var phi_3207_: array<f32, 3>;
    var phi_3118_: array<f32, 3>;
    var phi_3208_: array<f32, 3>;
    var phi_3240_: type_17;
    var phi_3243_: f32;
    var phi_3264_: bool;
    var phi_3270_: type_18;
    var phi_3241_: type_17;
    var phi_3284_: type_18;
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
    var phi_3574_: type_32;
    var phi_3575_: bool;
    var phi_3580_: type_32;
    var phi_3581_: bool;
    var phi_3583_: type_32;
    var phi_3584_: type_32;
    var phi_3585_: bool;
    var phi_3589_: type_32;
    var phi_6863_: type_32;
    var phi_6864_: type_32;
    var phi_6877_: type_34;
    var phi_6884_: bool;
    var phi_6908_: u32;
    var phi_6912_: type_28;
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
        phi_233_ = _e116;
    } else {
        phi_233_ = _e118;
    }
    let _e121 = phi_233_;
    let _e122 = (_e121 / 64u);
    if ((_e121 % 64u) > 0u) {
        phi_249_ = (_e122 + 1u);
    } else {
        phi_249_ = _e122;
    }
    let _e127 = phi_249_;
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
            phi_270_ = (_e131 + 1u);
        } else {
            phi_270_ = _e131;
        }
        let _e137 = phi_270_;
        phi_271_ = _e137;
    } else {
        phi_271_ = 0u;
    }
    let _e139 = phi_271_;
    phi_274_ = type_19(0u, _e139);
    loop {
        let _e142 = phi_274_;
        if (_e142.member < _e142.member_1) {
            phi_275_ = type_19((_e142.member + 1u), _e142.member_1);
            phi_298_ = type_19(1u, _e142.member);
        } else {
            phi_275_ = _e142;
            phi_298_ = type_19(0u, type_19().member_1);
        }
        let _e154 = phi_275_;
        let _e156 = phi_298_;
        let _e160 = (bitcast<i32>(_e156.member) != 0i);
        if _e160 {
            let _e164 = (((_e111 + (_e156.member_1 * _e114)) * 64u) + _e99);
            let _e166 = params.member.member_8;
            if (_e164 < _e121) {
                let _e169 = (2u * _e164);
                let _e172 = input.member[(4u + _e169)];
                let _e175 = input.member[(_e169 + 5u)];
                let _e177 = elements.member[_e175];
                let _e182 = paths.member[_e172];
                let _e184 = paths.member[_e177[0]];
                let _e190 = paths.member[_e177[1]];
                let _e192 = paths.member[_e177[2]];
                let _e222 = params.member.member_4;
                local_15 = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e182.member[0] - _e184.member[0]), (_e182.member[1] - _e184.member[1]), (_e182.member[2] - _e184.member[2])), array<f32, 3>((_e182.member_1[0] - _e184.member_1[0]), (_e182.member_1[1] - _e184.member_1[1]), (_e182.member_1[2] - _e184.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e190.member[0] - _e184.member[0]), (_e190.member[1] - _e184.member[1]), (_e190.member[2] - _e184.member[2])), array<f32, 3>((_e190.member_1[0] - _e184.member_1[0]), (_e190.member_1[1] - _e184.member_1[1]), (_e190.member_1[2] - _e184.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e192.member[0] - _e184.member[0]), (_e192.member[1] - _e184.member[1]), (_e192.member[2] - _e184.member[2])), array<f32, 3>((_e192.member_1[0] - _e184.member_1[0]), (_e192.member_1[1] - _e184.member_1[1]), (_e192.member_1[2] - _e184.member_1[2]))), (_e222 + _e222));
                let _e253 = params.member.member_5;
                let _e256 = local_15.member_1[0u];
                let _e262 = local_15.member_2[0u];
                let _e268 = ((_e256[1] * _e262[2]) - (_e256[2] * _e262[1]));
                let _e271 = ((_e256[2] * _e262[0]) - (_e256[0] * _e262[2]));
                let _e274 = ((_e256[0] * _e262[1]) - (_e256[1] * _e262[0]));
                let _e277 = local_15.member_1[1u];
                let _e283 = local_15.member_2[1u];
                let _e289 = ((_e277[1] * _e283[2]) - (_e277[2] * _e283[1]));
                let _e292 = ((_e277[2] * _e283[0]) - (_e277[0] * _e283[2]));
                let _e295 = ((_e277[0] * _e283[1]) - (_e277[1] * _e283[0]));
                let _e298 = local_15.member_1[0u];
                let _e304 = local_15.member_2[1u];
                let _e319 = local_15.member_1[1u];
                let _e325 = local_15.member_2[0u];
                let _e338 = (((_e298[1] * _e304[2]) - (_e298[2] * _e304[1])) + ((_e319[1] * _e325[2]) - (_e319[2] * _e325[1])));
                let _e339 = (((_e298[2] * _e304[0]) - (_e298[0] * _e304[2])) + ((_e319[2] * _e325[0]) - (_e319[0] * _e325[2])));
                let _e340 = (((_e298[0] * _e304[1]) - (_e298[1] * _e304[0])) + ((_e319[0] * _e325[1]) - (_e319[1] * _e325[0])));
                let _e343 = local_15.member[0u];
                let _e351 = (((_e343[0] * _e268) + (_e343[1] * _e271)) + (_e343[2] * _e274));
                let _e354 = local_15.member[1u];
                let _e365 = local_15.member[0u];
                let _e374 = ((((_e354[0] * _e268) + (_e354[1] * _e271)) + (_e354[2] * _e274)) + (((_e365[0] * _e338) + (_e365[1] * _e339)) + (_e365[2] * _e340)));
                let _e377 = local_15.member[0u];
                let _e388 = local_15.member[1u];
                let _e397 = ((((_e377[0] * _e289) + (_e377[1] * _e292)) + (_e377[2] * _e295)) + (((_e388[0] * _e338) + (_e388[1] * _e339)) + (_e388[2] * _e340)));
                let _e400 = local_15.member[1u];
                let _e408 = (((_e400[0] * _e289) + (_e400[1] * _e292)) + (_e400[2] * _e295));
                let _e411 = local_15.member[0u];
                if (_e411[0] < 0f) {
                    phi_737_ = -(_e411[0]);
                } else {
                    phi_737_ = _e411[0];
                }
                let _e418 = phi_737_;
                if (_e411[1] < 0f) {
                    phi_744_ = -(_e411[1]);
                } else {
                    phi_744_ = _e411[1];
                }
                let _e422 = phi_744_;
                if (_e418 > _e422) {
                    phi_749_ = _e418;
                } else {
                    phi_749_ = _e422;
                }
                let _e425 = phi_749_;
                if (_e411[2] < 0f) {
                    phi_756_ = -(_e411[2]);
                } else {
                    phi_756_ = _e411[2];
                }
                let _e429 = phi_756_;
                if (_e425 > _e429) {
                    phi_761_ = _e425;
                } else {
                    phi_761_ = _e429;
                }
                let _e432 = phi_761_;
                let _e435 = local_15.member[1u];
                if (_e435[0] < 0f) {
                    phi_774_ = -(_e435[0]);
                } else {
                    phi_774_ = _e435[0];
                }
                let _e442 = phi_774_;
                if (_e435[1] < 0f) {
                    phi_781_ = -(_e435[1]);
                } else {
                    phi_781_ = _e435[1];
                }
                let _e446 = phi_781_;
                if (_e442 > _e446) {
                    phi_786_ = _e442;
                } else {
                    phi_786_ = _e446;
                }
                let _e449 = phi_786_;
                if (_e435[2] < 0f) {
                    phi_793_ = -(_e435[2]);
                } else {
                    phi_793_ = _e435[2];
                }
                let _e453 = phi_793_;
                if (_e449 > _e453) {
                    phi_798_ = _e449;
                } else {
                    phi_798_ = _e453;
                }
                let _e456 = phi_798_;
                if (_e432 > _e456) {
                    phi_803_ = _e432;
                } else {
                    phi_803_ = _e456;
                }
                let _e459 = phi_803_;
                let _e461 = local_15.member_3;
                let _e462 = (_e459 + _e461);
                let _e465 = local_15.member_1[0u];
                if (_e465[0] < 0f) {
                    phi_820_ = -(_e465[0]);
                } else {
                    phi_820_ = _e465[0];
                }
                let _e472 = phi_820_;
                if (_e465[1] < 0f) {
                    phi_827_ = -(_e465[1]);
                } else {
                    phi_827_ = _e465[1];
                }
                let _e476 = phi_827_;
                if (_e472 > _e476) {
                    phi_832_ = _e472;
                } else {
                    phi_832_ = _e476;
                }
                let _e479 = phi_832_;
                if (_e465[2] < 0f) {
                    phi_839_ = -(_e465[2]);
                } else {
                    phi_839_ = _e465[2];
                }
                let _e483 = phi_839_;
                if (_e479 > _e483) {
                    phi_844_ = _e479;
                } else {
                    phi_844_ = _e483;
                }
                let _e486 = phi_844_;
                let _e489 = local_15.member_1[1u];
                if (_e489[0] < 0f) {
                    phi_858_ = -(_e489[0]);
                } else {
                    phi_858_ = _e489[0];
                }
                let _e496 = phi_858_;
                if (_e489[1] < 0f) {
                    phi_865_ = -(_e489[1]);
                } else {
                    phi_865_ = _e489[1];
                }
                let _e500 = phi_865_;
                if (_e496 > _e500) {
                    phi_870_ = _e496;
                } else {
                    phi_870_ = _e500;
                }
                let _e503 = phi_870_;
                if (_e489[2] < 0f) {
                    phi_877_ = -(_e489[2]);
                } else {
                    phi_877_ = _e489[2];
                }
                let _e507 = phi_877_;
                if (_e503 > _e507) {
                    phi_882_ = _e503;
                } else {
                    phi_882_ = _e507;
                }
                let _e510 = phi_882_;
                if (_e486 > _e510) {
                    phi_887_ = _e486;
                } else {
                    phi_887_ = _e510;
                }
                let _e513 = phi_887_;
                let _e515 = local_15.member_3;
                let _e516 = (_e513 + _e515);
                let _e519 = local_15.member_2[0u];
                if (_e519[0] < 0f) {
                    phi_904_ = -(_e519[0]);
                } else {
                    phi_904_ = _e519[0];
                }
                let _e526 = phi_904_;
                if (_e519[1] < 0f) {
                    phi_911_ = -(_e519[1]);
                } else {
                    phi_911_ = _e519[1];
                }
                let _e530 = phi_911_;
                if (_e526 > _e530) {
                    phi_916_ = _e526;
                } else {
                    phi_916_ = _e530;
                }
                let _e533 = phi_916_;
                if (_e519[2] < 0f) {
                    phi_923_ = -(_e519[2]);
                } else {
                    phi_923_ = _e519[2];
                }
                let _e537 = phi_923_;
                if (_e533 > _e537) {
                    phi_928_ = _e533;
                } else {
                    phi_928_ = _e537;
                }
                let _e540 = phi_928_;
                let _e543 = local_15.member_2[1u];
                if (_e543[0] < 0f) {
                    phi_942_ = -(_e543[0]);
                } else {
                    phi_942_ = _e543[0];
                }
                let _e550 = phi_942_;
                if (_e543[1] < 0f) {
                    phi_949_ = -(_e543[1]);
                } else {
                    phi_949_ = _e543[1];
                }
                let _e554 = phi_949_;
                if (_e550 > _e554) {
                    phi_954_ = _e550;
                } else {
                    phi_954_ = _e554;
                }
                let _e557 = phi_954_;
                if (_e543[2] < 0f) {
                    phi_961_ = -(_e543[2]);
                } else {
                    phi_961_ = _e543[2];
                }
                let _e561 = phi_961_;
                if (_e557 > _e561) {
                    phi_966_ = _e557;
                } else {
                    phi_966_ = _e561;
                }
                let _e564 = phi_966_;
                if (_e540 > _e564) {
                    phi_971_ = _e540;
                } else {
                    phi_971_ = _e564;
                }
                let _e567 = phi_971_;
                let _e569 = local_15.member_3;
                let _e570 = (_e567 + _e569);
                let _e572 = ((_e516 * 8f) * _e570);
                let _e579 = local_15.member_3;
                if (_e268 < 0f) {
                    phi_1002_ = -(_e268);
                } else {
                    phi_1002_ = _e268;
                }
                let _e596 = phi_1002_;
                if (_e271 < 0f) {
                    phi_1008_ = -(_e271);
                } else {
                    phi_1008_ = _e271;
                }
                let _e600 = phi_1008_;
                if (_e274 < 0f) {
                    phi_1015_ = -(_e274);
                } else {
                    phi_1015_ = _e274;
                }
                let _e605 = phi_1015_;
                let _e606 = ((_e596 + _e600) + _e605);
                if (_e289 < 0f) {
                    phi_1022_ = -(_e289);
                } else {
                    phi_1022_ = _e289;
                }
                let _e610 = phi_1022_;
                if (_e292 < 0f) {
                    phi_1028_ = -(_e292);
                } else {
                    phi_1028_ = _e292;
                }
                let _e614 = phi_1028_;
                if (_e295 < 0f) {
                    phi_1035_ = -(_e295);
                } else {
                    phi_1035_ = _e295;
                }
                let _e619 = phi_1035_;
                let _e620 = ((_e610 + _e614) + _e619);
                if (_e606 > _e620) {
                    phi_1041_ = _e606;
                } else {
                    phi_1041_ = _e620;
                }
                let _e623 = phi_1041_;
                if (_e338 < 0f) {
                    phi_1047_ = -(_e338);
                } else {
                    phi_1047_ = _e338;
                }
                let _e627 = phi_1047_;
                if (_e339 < 0f) {
                    phi_1053_ = -(_e339);
                } else {
                    phi_1053_ = _e339;
                }
                let _e631 = phi_1053_;
                if (_e340 < 0f) {
                    phi_1060_ = -(_e340);
                } else {
                    phi_1060_ = _e340;
                }
                let _e636 = phi_1060_;
                let _e638 = (((_e627 + _e631) + _e636) * 0.5f);
                if (_e623 > _e638) {
                    phi_1067_ = _e623;
                } else {
                    phi_1067_ = _e638;
                }
                let _e641 = phi_1067_;
                let _e646 = local_15.member_3;
                let _e658 = (((((_e462 * 8f) * _e572) * (0.000000059604645f * (490f / 64f))) + ((_e579 * 19f) * ((_e462 * (_e516 + _e570)) + (_e516 * _e570)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e462) * ((1f + _e516) * (1f + _e570)))));
                let _e659 = (_e351 * 3f);
                let _e660 = (_e408 * 3f);
                if (_e659 < _e660) {
                    phi_1091_ = _e659;
                } else {
                    phi_1091_ = _e660;
                }
                let _e663 = phi_1091_;
                if (_e374 < _e397) {
                    phi_1096_ = _e374;
                } else {
                    phi_1096_ = _e397;
                }
                let _e666 = phi_1096_;
                if (_e663 < _e666) {
                    phi_1101_ = _e663;
                } else {
                    phi_1101_ = _e666;
                }
                let _e669 = phi_1101_;
                if (_e659 > _e660) {
                    phi_1106_ = _e659;
                } else {
                    phi_1106_ = _e660;
                }
                let _e672 = phi_1106_;
                if (_e374 > _e397) {
                    phi_1111_ = _e374;
                } else {
                    phi_1111_ = _e397;
                }
                let _e675 = phi_1111_;
                if (_e672 > _e675) {
                    phi_1116_ = _e672;
                } else {
                    phi_1116_ = _e675;
                }
                let _e678 = phi_1116_;
                let _e683 = -(_e678);
                if (_e669 > _e683) {
                    phi_1126_ = _e669;
                } else {
                    phi_1126_ = _e683;
                }
                let _e686 = phi_1126_;
                if ((_e686 - (_e658 + ((_e253 * (((_e641 + (_e572 * (0.000000059604645f * 4f))) + ((_e646 * 6f) * (_e516 + _e570))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e516) * (1f + _e570))))) * (3f * 1.0001f)))) > 0f) {
                    phi_6864_ = type_32(0u, type_32().member_1);
                } else {
                    if (_e253 > 0f) {
                        let _e2931 = local_15.member[0u];
                        let _e2937 = local_15.member_1[0u];
                        let _e2943 = local_15.member_2[0u];
                        local_12 = array<array<f32, 3>, 4>(_e2931, array<f32, 3>((_e2931[0] - _e2937[0]), (_e2931[1] - _e2937[1]), (_e2931[2] - _e2937[2])), array<f32, 3>((_e2931[0] - _e2943[0]), (_e2931[1] - _e2943[1]), (_e2931[2] - _e2943[2])), _e2931);
                        let _e2958 = local_15.member[1u];
                        let _e2964 = local_15.member_1[1u];
                        let _e2970 = local_15.member_2[1u];
                        local_13 = array<array<f32, 3>, 4>(_e2958, array<f32, 3>((_e2958[0] - _e2964[0]), (_e2958[1] - _e2964[1]), (_e2958[2] - _e2964[2])), array<f32, 3>((_e2958[0] - _e2970[0]), (_e2958[1] - _e2970[1]), (_e2958[2] - _e2970[2])), _e2958);
                        let _e2985 = local_15.member[0u];
                        if (_e2985[0] < 0f) {
                            phi_1327_ = -(_e2985[0]);
                        } else {
                            phi_1327_ = _e2985[0];
                        }
                        let _e2992 = phi_1327_;
                        if (_e2985[1] < 0f) {
                            phi_1334_ = -(_e2985[1]);
                        } else {
                            phi_1334_ = _e2985[1];
                        }
                        let _e2996 = phi_1334_;
                        if (_e2992 > _e2996) {
                            phi_1339_ = _e2992;
                        } else {
                            phi_1339_ = _e2996;
                        }
                        let _e2999 = phi_1339_;
                        if (_e2985[2] < 0f) {
                            phi_1346_ = -(_e2985[2]);
                        } else {
                            phi_1346_ = _e2985[2];
                        }
                        let _e3003 = phi_1346_;
                        if (_e2999 > _e3003) {
                            phi_1351_ = _e2999;
                        } else {
                            phi_1351_ = _e3003;
                        }
                        let _e3006 = phi_1351_;
                        let _e3009 = local_15.member[1u];
                        if (_e3009[0] < 0f) {
                            phi_1364_ = -(_e3009[0]);
                        } else {
                            phi_1364_ = _e3009[0];
                        }
                        let _e3016 = phi_1364_;
                        if (_e3009[1] < 0f) {
                            phi_1371_ = -(_e3009[1]);
                        } else {
                            phi_1371_ = _e3009[1];
                        }
                        let _e3020 = phi_1371_;
                        if (_e3016 > _e3020) {
                            phi_1376_ = _e3016;
                        } else {
                            phi_1376_ = _e3020;
                        }
                        let _e3023 = phi_1376_;
                        if (_e3009[2] < 0f) {
                            phi_1383_ = -(_e3009[2]);
                        } else {
                            phi_1383_ = _e3009[2];
                        }
                        let _e3027 = phi_1383_;
                        if (_e3023 > _e3027) {
                            phi_1388_ = _e3023;
                        } else {
                            phi_1388_ = _e3027;
                        }
                        let _e3030 = phi_1388_;
                        if (_e3006 > _e3030) {
                            phi_1393_ = _e3006;
                        } else {
                            phi_1393_ = _e3030;
                        }
                        let _e3033 = phi_1393_;
                        let _e3035 = local_15.member_3;
                        let _e3039 = local_15.member_1[0u];
                        if (_e3039[0] < 0f) {
                            phi_1410_ = -(_e3039[0]);
                        } else {
                            phi_1410_ = _e3039[0];
                        }
                        let _e3046 = phi_1410_;
                        if (_e3039[1] < 0f) {
                            phi_1417_ = -(_e3039[1]);
                        } else {
                            phi_1417_ = _e3039[1];
                        }
                        let _e3050 = phi_1417_;
                        if (_e3046 > _e3050) {
                            phi_1422_ = _e3046;
                        } else {
                            phi_1422_ = _e3050;
                        }
                        let _e3053 = phi_1422_;
                        if (_e3039[2] < 0f) {
                            phi_1429_ = -(_e3039[2]);
                        } else {
                            phi_1429_ = _e3039[2];
                        }
                        let _e3057 = phi_1429_;
                        if (_e3053 > _e3057) {
                            phi_1434_ = _e3053;
                        } else {
                            phi_1434_ = _e3057;
                        }
                        let _e3060 = phi_1434_;
                        let _e3063 = local_15.member_1[1u];
                        if (_e3063[0] < 0f) {
                            phi_1448_ = -(_e3063[0]);
                        } else {
                            phi_1448_ = _e3063[0];
                        }
                        let _e3070 = phi_1448_;
                        if (_e3063[1] < 0f) {
                            phi_1455_ = -(_e3063[1]);
                        } else {
                            phi_1455_ = _e3063[1];
                        }
                        let _e3074 = phi_1455_;
                        if (_e3070 > _e3074) {
                            phi_1460_ = _e3070;
                        } else {
                            phi_1460_ = _e3074;
                        }
                        let _e3077 = phi_1460_;
                        if (_e3063[2] < 0f) {
                            phi_1467_ = -(_e3063[2]);
                        } else {
                            phi_1467_ = _e3063[2];
                        }
                        let _e3081 = phi_1467_;
                        if (_e3077 > _e3081) {
                            phi_1472_ = _e3077;
                        } else {
                            phi_1472_ = _e3081;
                        }
                        let _e3084 = phi_1472_;
                        if (_e3060 > _e3084) {
                            phi_1477_ = _e3060;
                        } else {
                            phi_1477_ = _e3084;
                        }
                        let _e3087 = phi_1477_;
                        let _e3089 = local_15.member_3;
                        let _e3093 = local_15.member_2[0u];
                        if (_e3093[0] < 0f) {
                            phi_1494_ = -(_e3093[0]);
                        } else {
                            phi_1494_ = _e3093[0];
                        }
                        let _e3100 = phi_1494_;
                        if (_e3093[1] < 0f) {
                            phi_1501_ = -(_e3093[1]);
                        } else {
                            phi_1501_ = _e3093[1];
                        }
                        let _e3104 = phi_1501_;
                        if (_e3100 > _e3104) {
                            phi_1506_ = _e3100;
                        } else {
                            phi_1506_ = _e3104;
                        }
                        let _e3107 = phi_1506_;
                        if (_e3093[2] < 0f) {
                            phi_1513_ = -(_e3093[2]);
                        } else {
                            phi_1513_ = _e3093[2];
                        }
                        let _e3111 = phi_1513_;
                        if (_e3107 > _e3111) {
                            phi_1518_ = _e3107;
                        } else {
                            phi_1518_ = _e3111;
                        }
                        let _e3114 = phi_1518_;
                        let _e3117 = local_15.member_2[1u];
                        if (_e3117[0] < 0f) {
                            phi_1532_ = -(_e3117[0]);
                        } else {
                            phi_1532_ = _e3117[0];
                        }
                        let _e3124 = phi_1532_;
                        if (_e3117[1] < 0f) {
                            phi_1539_ = -(_e3117[1]);
                        } else {
                            phi_1539_ = _e3117[1];
                        }
                        let _e3128 = phi_1539_;
                        if (_e3124 > _e3128) {
                            phi_1544_ = _e3124;
                        } else {
                            phi_1544_ = _e3128;
                        }
                        let _e3131 = phi_1544_;
                        if (_e3117[2] < 0f) {
                            phi_1551_ = -(_e3117[2]);
                        } else {
                            phi_1551_ = _e3117[2];
                        }
                        let _e3135 = phi_1551_;
                        if (_e3131 > _e3135) {
                            phi_1556_ = _e3131;
                        } else {
                            phi_1556_ = _e3135;
                        }
                        let _e3138 = phi_1556_;
                        if (_e3114 > _e3138) {
                            phi_1561_ = _e3114;
                        } else {
                            phi_1561_ = _e3138;
                        }
                        let _e3141 = phi_1561_;
                        let _e3143 = local_15.member_3;
                        let _e3150 = local_15.member_3;
                        phi_1577_ = type_19(0u, 48u);
                        phi_1580_ = 0f;
                        loop {
                            let _e3156 = phi_1577_;
                            let _e3158 = phi_1580_;
                            local_82 = _e3158;
                            local_40 = _e3158;
                            local_41 = _e3158;
                            local_42 = _e3158;
                            local_43 = _e3158;
                            if (_e3156.member < _e3156.member_1) {
                                phi_1578_ = type_19((_e3156.member + 1u), _e3156.member_1);
                                phi_1603_ = type_19(1u, _e3156.member);
                            } else {
                                phi_1578_ = _e3156;
                                phi_1603_ = type_19(0u, type_19().member_1);
                            }
                            let _e3170 = phi_1578_;
                            let _e3172 = phi_1603_;
                            if (bitcast<i32>(_e3172.member) != 0i) {
                                let _e3178 = local_15.member[0u];
                                let _e3184 = local_15.member[1u];
                                let _e3194 = (_e3178[0] + ((_e3184[0] - _e3178[0]) * _e3158));
                                let _e3195 = (_e3178[1] + ((_e3184[1] - _e3178[1]) * _e3158));
                                let _e3196 = (_e3178[2] + ((_e3184[2] - _e3178[2]) * _e3158));
                                let _e3199 = local_15.member_1[0u];
                                let _e3205 = local_15.member_1[1u];
                                let _e3215 = (_e3199[0] + ((_e3205[0] - _e3199[0]) * _e3158));
                                let _e3216 = (_e3199[1] + ((_e3205[1] - _e3199[1]) * _e3158));
                                let _e3217 = (_e3199[2] + ((_e3205[2] - _e3199[2]) * _e3158));
                                let _e3220 = local_15.member_2[0u];
                                let _e3226 = local_15.member_2[1u];
                                let _e3236 = (_e3220[0] + ((_e3226[0] - _e3220[0]) * _e3158));
                                let _e3237 = (_e3220[1] + ((_e3226[1] - _e3220[1]) * _e3158));
                                let _e3238 = (_e3220[2] + ((_e3226[2] - _e3220[2]) * _e3158));
                                let _e3243 = (((_e3215 * _e3215) + (_e3216 * _e3216)) + (_e3217 * _e3217));
                                let _e3248 = (((_e3215 * _e3236) + (_e3216 * _e3237)) + (_e3217 * _e3238));
                                let _e3253 = (((_e3236 * _e3236) + (_e3237 * _e3237)) + (_e3238 * _e3238));
                                let _e3258 = (((_e3194 * _e3215) + (_e3195 * _e3216)) + (_e3196 * _e3217));
                                let _e3263 = (((_e3194 * _e3236) + (_e3195 * _e3237)) + (_e3196 * _e3238));
                                let _e3266 = ((_e3243 * _e3253) - (_e3248 * _e3248));
                                let _e3270 = (((_e3258 * _e3253) - (_e3263 * _e3248)) / _e3266);
                                let _e3274 = (((_e3263 * _e3243) - (_e3258 * _e3248)) / _e3266);
                                if (_e3270 >= 0f) {
                                    if (_e3274 >= 0f) {
                                        phi_1777_ = ((_e3270 + _e3274) <= 1f);
                                        phi_1778_ = false;
                                    } else {
                                        phi_1777_ = bool();
                                        phi_1778_ = true;
                                    }
                                    let _e3280 = phi_1777_;
                                    let _e3282 = phi_1778_;
                                    phi_1779_ = _e3280;
                                    phi_1780_ = _e3282;
                                } else {
                                    phi_1779_ = bool();
                                    phi_1780_ = true;
                                }
                                let _e3284 = phi_1779_;
                                let _e3286 = phi_1780_;
                                if _e3286 {
                                    phi_1784_ = false;
                                } else {
                                    phi_1784_ = _e3284;
                                }
                                let _e3288 = phi_1784_;
                                if (_e3266 > 0f) {
                                    if _e3288 {
                                        phi_1806_ = array<f32, 3>((_e3194 - ((_e3215 * _e3270) + (_e3236 * _e3274))), (_e3195 - ((_e3216 * _e3270) + (_e3237 * _e3274))), (_e3196 - ((_e3217 * _e3270) + (_e3238 * _e3274))));
                                        phi_1807_ = false;
                                    } else {
                                        phi_1806_ = array<f32, 3>();
                                        phi_1807_ = true;
                                    }
                                    let _e3304 = phi_1806_;
                                    let _e3306 = phi_1807_;
                                    phi_1808_ = _e3304;
                                    phi_1809_ = _e3306;
                                } else {
                                    phi_1808_ = array<f32, 3>();
                                    phi_1809_ = true;
                                }
                                let _e3308 = phi_1808_;
                                let _e3310 = phi_1809_;
                                if _e3310 {
                                    let _e3311 = (_e3194 - _e3215);
                                    let _e3312 = (_e3195 - _e3216);
                                    let _e3313 = (_e3196 - _e3217);
                                    let _e3314 = (_e3236 - _e3215);
                                    let _e3315 = (_e3237 - _e3216);
                                    let _e3316 = (_e3238 - _e3217);
                                    let _e3327 = ((((_e3311 * _e3314) + (_e3312 * _e3315)) + (_e3313 * _e3316)) / (((_e3314 * _e3314) + (_e3315 * _e3315)) + (_e3316 * _e3316)));
                                    if (_e3327 > 0f) {
                                        if (_e3327 < 1f) {
                                            phi_1977_ = _e3327;
                                        } else {
                                            phi_1977_ = 1f;
                                        }
                                        let _e3331 = phi_1977_;
                                        phi_1978_ = _e3331;
                                    } else {
                                        phi_1978_ = 0f;
                                    }
                                    let _e3333 = phi_1978_;
                                    let _e3337 = (_e3311 - (_e3314 * _e3333));
                                    let _e3338 = (_e3312 - (_e3315 * _e3333));
                                    let _e3339 = (_e3313 - (_e3316 * _e3333));
                                    let _e3350 = ((((_e3194 * _e3215) + (_e3195 * _e3216)) + (_e3196 * _e3217)) / (((_e3215 * _e3215) + (_e3216 * _e3216)) + (_e3217 * _e3217)));
                                    if (_e3350 > 0f) {
                                        if (_e3350 < 1f) {
                                            phi_2005_ = _e3350;
                                        } else {
                                            phi_2005_ = 1f;
                                        }
                                        let _e3354 = phi_2005_;
                                        phi_2006_ = _e3354;
                                    } else {
                                        phi_2006_ = 0f;
                                    }
                                    let _e3356 = phi_2006_;
                                    let _e3373 = ((((_e3194 * _e3236) + (_e3195 * _e3237)) + (_e3196 * _e3238)) / (((_e3236 * _e3236) + (_e3237 * _e3237)) + (_e3238 * _e3238)));
                                    if (_e3373 > 0f) {
                                        if (_e3373 < 1f) {
                                            phi_2033_ = _e3373;
                                        } else {
                                            phi_2033_ = 1f;
                                        }
                                        let _e3377 = phi_2033_;
                                        phi_2034_ = _e3377;
                                    } else {
                                        phi_2034_ = 0f;
                                    }
                                    let _e3379 = phi_2034_;
                                    local_11[0u] = array<f32, 3>((_e3194 - (_e3215 * _e3356)), (_e3195 - (_e3216 * _e3356)), (_e3196 - (_e3217 * _e3356)));
                                    local_11[1u] = array<f32, 3>((_e3194 - (_e3236 * _e3379)), (_e3195 - (_e3237 * _e3379)), (_e3196 - (_e3238 * _e3379)));
                                    local_11[2u] = array<f32, 3>(_e3337, _e3338, _e3339);
                                    local_11[3u] = array<f32, 3>(_e3337, _e3338, _e3339);
                                    let _e3395 = local_11[0u];
                                    phi_2070_ = type_19(1u, 4u);
                                    phi_2073_ = array<f32, 3>(_e3395[0], _e3395[1], _e3395[2]);
                                    loop {
                                        let _e3401 = phi_2070_;
                                        let _e3403 = phi_2073_;
                                        local_69 = _e3403;
                                        if (_e3401.member < _e3401.member_1) {
                                            phi_2071_ = type_19((_e3401.member + 1u), _e3401.member_1);
                                            phi_2096_ = type_19(1u, _e3401.member);
                                        } else {
                                            phi_2071_ = _e3401;
                                            phi_2096_ = type_19(0u, type_19().member_1);
                                        }
                                        let _e3415 = phi_2071_;
                                        let _e3417 = phi_2096_;
                                        let _e3421 = (bitcast<i32>(_e3417.member) != 0i);
                                        if _e3421 {
                                            let _e3423 = local_11[_e3417.member_1];
                                            let _e3428 = local_11[_e3417.member_1];
                                            if ((((_e3423[0] * _e3428[0]) + (_e3423[1] * _e3428[1])) + (_e3423[2] * _e3428[2])) < (((_e3403[0] * _e3403[0]) + (_e3403[1] * _e3403[1])) + (_e3403[2] * _e3403[2]))) {
                                                let _e3450 = local_11[_e3417.member_1];
                                                phi_2163_ = array<f32, 3>(_e3450[0], _e3450[1], _e3450[2]);
                                            } else {
                                                phi_2163_ = _e3403;
                                            }
                                            let _e3456 = phi_2163_;
                                            phi_2074_ = _e3456;
                                        } else {
                                            phi_2074_ = array<f32, 3>();
                                        }
                                        let _e3458 = phi_2074_;
                                        continue;
                                        continuing {
                                            phi_2070_ = _e3415;
                                            phi_2073_ = _e3458;
                                            break if !(_e3421);
                                        }
                                    }
                                    let _e5200 = local_69;
                                    phi_2164_ = _e5200;
                                } else {
                                    phi_2164_ = _e3308;
                                }
                                let _e3461 = phi_2164_;
                                if (_e3461[0] < 0f) {
                                    phi_2171_ = -(_e3461[0]);
                                } else {
                                    phi_2171_ = _e3461[0];
                                }
                                let _e3466 = phi_2171_;
                                if (_e3461[1] < 0f) {
                                    phi_2178_ = -(_e3461[1]);
                                } else {
                                    phi_2178_ = _e3461[1];
                                }
                                let _e3471 = phi_2178_;
                                if (_e3461[2] < 0f) {
                                    phi_2186_ = -(_e3461[2]);
                                } else {
                                    phi_2186_ = _e3461[2];
                                }
                                let _e3477 = phi_2186_;
                                let _e3478 = ((_e3466 + _e3471) + _e3477);
                                if (_e3478 > 0f) {
                                    if ((bitcast<u32>(_e3478) & 2139095040u) != 2139095040u) {
                                        let _e3483 = (1f / _e3478);
                                        let _e3485 = (_e3461[0] * _e3483);
                                        let _e3487 = (_e3461[1] * _e3483);
                                        let _e3489 = (_e3461[2] * _e3483);
                                        let _e3494 = (((_e3485 * _e3485) + (_e3487 * _e3487)) + (_e3489 * _e3489));
                                        if (_e3494 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3494 > 0f) {
                                                phi_2223_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2223_ = 0f;
                                            }
                                            let _e3547 = phi_2223_;
                                            phi_2287_ = _e3547;
                                        } else {
                                            phi_2230_ = type_17(0i, 5i);
                                            phi_2233_ = bitcast<f32>(((bitcast<u32>(_e3494) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3502 = phi_2230_;
                                                let _e3504 = phi_2233_;
                                                local_34 = _e3504;
                                                if (_e3502.member < _e3502.member_1) {
                                                    let _e3511 = (_e3502.member + 1i);
                                                    if ((false == (_e3511 > _e3502.member)) != false) {
                                                        phi_2254_ = true;
                                                    } else {
                                                        phi_2254_ = false;
                                                    }
                                                    let _e3516 = phi_2254_;
                                                    if _e3516 {
                                                        phi_2260_ = type_18(0u, type_18().member_1);
                                                    } else {
                                                        phi_2260_ = type_18(1u, _e3511);
                                                    }
                                                    let _e3521 = phi_2260_;
                                                    phi_2231_ = type_17(_e3521.member_1, _e3502.member_1);
                                                    phi_2274_ = type_18(1u, _e3502.member);
                                                } else {
                                                    phi_2231_ = _e3502;
                                                    phi_2274_ = type_18(0u, type_18().member_1);
                                                }
                                                let _e3527 = phi_2231_;
                                                let _e3529 = phi_2274_;
                                                let _e3532 = (bitcast<i32>(_e3529.member) != 0i);
                                                if _e3532 {
                                                    phi_2234_ = (0.5f * (_e3504 + (_e3494 / _e3504)));
                                                } else {
                                                    phi_2234_ = f32();
                                                }
                                                let _e3537 = phi_2234_;
                                                continue;
                                                continuing {
                                                    phi_2230_ = _e3527;
                                                    phi_2233_ = _e3537;
                                                    break if !(_e3532);
                                                }
                                            }
                                            let _e3542 = local_34;
                                            phi_2287_ = (_e3542 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3549 = phi_2287_;
                                        phi_2296_ = type_19(0u, 4u);
                                        phi_2299_ = 2f;
                                        loop {
                                            let _e3557 = phi_2296_;
                                            let _e3559 = phi_2299_;
                                            local_36 = _e3559;
                                            local_37 = _e3559;
                                            local_38 = _e3559;
                                            local_72 = _e3559;
                                            local_73 = _e3559;
                                            if (_e3557.member < _e3557.member_1) {
                                                phi_2297_ = type_19((_e3557.member + 1u), _e3557.member_1);
                                                phi_2322_ = type_19(1u, _e3557.member);
                                            } else {
                                                phi_2297_ = _e3557;
                                                phi_2322_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e3571 = phi_2297_;
                                            let _e3573 = phi_2322_;
                                            if (bitcast<i32>(_e3573.member) != 0i) {
                                                let _e3579 = local_12[_e3573.member_1];
                                                let _e3587 = (((_e3485 * _e3579[0]) + (_e3487 * _e3579[1])) + (_e3489 * _e3579[2]));
                                                let _e3589 = local_13[_e3573.member_1];
                                                let _e3597 = (((_e3485 * _e3589[0]) + (_e3487 * _e3589[1])) + (_e3489 * _e3589[2]));
                                                if (_e3587 < 0f) {
                                                    phi_2373_ = -(_e3587);
                                                } else {
                                                    phi_2373_ = _e3587;
                                                }
                                                let _e3601 = phi_2373_;
                                                if (_e3597 < 0f) {
                                                    phi_2379_ = -(_e3597);
                                                } else {
                                                    phi_2379_ = _e3597;
                                                }
                                                let _e3605 = phi_2379_;
                                                let _e3609 = (((((((((_e3033 + _e3035) + (_e3087 + _e3089)) + (_e3141 + _e3143)) * (0.000000059604645f * 16f)) + (_e3150 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e253 * _e3549) * (1f + (0.000000059604645f * 8f)))) + ((_e3601 + _e3605) * (0.000000059604645f * 8f)));
                                                if (_e3587 > _e3609) {
                                                    if (_e3597 > _e3609) {
                                                        phi_2392_ = false;
                                                    } else {
                                                        phi_2392_ = true;
                                                    }
                                                    let _e3613 = phi_2392_;
                                                    phi_2393_ = _e3613;
                                                } else {
                                                    phi_2393_ = true;
                                                }
                                                let _e3615 = phi_2393_;
                                                if _e3615 {
                                                    if ((_e3587 + ((_e3597 - _e3587) * _e3158)) > _e3609) {
                                                        if (_e3597 < _e3587) {
                                                            let _e3623 = ((_e3587 - _e3597) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                            if _e3623 {
                                                                let _e3629 = (((_e3587 - _e3609) / (_e3587 - _e3597)) * (1f - (0.000000059604645f * 16f)));
                                                                if (_e3559 < _e3629) {
                                                                    phi_2424_ = _e3559;
                                                                } else {
                                                                    phi_2424_ = _e3629;
                                                                }
                                                                let _e3632 = phi_2424_;
                                                                phi_2425_ = _e3632;
                                                            } else {
                                                                phi_2425_ = f32();
                                                            }
                                                            let _e3634 = phi_2425_;
                                                            phi_2426_ = _e3634;
                                                            phi_2427_ = _e3623;
                                                        } else {
                                                            phi_2426_ = _e3559;
                                                            phi_2427_ = true;
                                                        }
                                                        let _e3636 = phi_2426_;
                                                        let _e3638 = phi_2427_;
                                                        if _e3638 {
                                                            phi_2431_ = false;
                                                        } else {
                                                            phi_2431_ = true;
                                                        }
                                                        let _e3640 = phi_2431_;
                                                        phi_2432_ = _e3636;
                                                        phi_2433_ = _e3638;
                                                        phi_2434_ = _e3640;
                                                        phi_2435_ = false;
                                                    } else {
                                                        phi_2432_ = f32();
                                                        phi_2433_ = false;
                                                        phi_2434_ = false;
                                                        phi_2435_ = true;
                                                    }
                                                    let _e3642 = phi_2432_;
                                                    let _e3644 = phi_2433_;
                                                    let _e3646 = phi_2434_;
                                                    let _e3648 = phi_2435_;
                                                    phi_2436_ = _e3642;
                                                    phi_2437_ = _e3644;
                                                    phi_2438_ = _e3646;
                                                    phi_2439_ = _e3648;
                                                } else {
                                                    phi_2436_ = _e3559;
                                                    phi_2437_ = true;
                                                    phi_2438_ = false;
                                                    phi_2439_ = false;
                                                }
                                                let _e3650 = phi_2436_;
                                                let _e3652 = phi_2437_;
                                                let _e3654 = phi_2438_;
                                                let _e3656 = phi_2439_;
                                                phi_2300_ = _e3650;
                                                phi_2440_ = _e3652;
                                                phi_2441_ = false;
                                                phi_2442_ = _e3654;
                                                phi_2443_ = _e3656;
                                            } else {
                                                phi_2300_ = f32();
                                                phi_2440_ = false;
                                                phi_2441_ = true;
                                                phi_2442_ = false;
                                                phi_2443_ = false;
                                            }
                                            let _e3658 = phi_2300_;
                                            let _e3660 = phi_2440_;
                                            let _e3662 = phi_2441_;
                                            let _e3664 = phi_2442_;
                                            let _e3666 = phi_2443_;
                                            local_35 = _e3662;
                                            local_70 = _e3664;
                                            local_71 = _e3666;
                                            continue;
                                            continuing {
                                                phi_2296_ = _e3571;
                                                phi_2299_ = _e3658;
                                                break if !(_e3660);
                                            }
                                        }
                                        let _e3669 = local_35;
                                        if _e3669 {
                                            let _e3671 = local_36;
                                            let _e3672 = (_e3671 > 1f);
                                            if _e3672 {
                                                phi_2464_ = false;
                                                phi_2465_ = false;
                                                phi_2466_ = false;
                                            } else {
                                                let _e3674 = local_37;
                                                if (_e3674 > _e3158) {
                                                    let _e3677 = local_38;
                                                    let _e3679 = ((_e3677 - _e3158) < 0.00000000023283064f);
                                                    if _e3679 {
                                                        phi_2460_ = false;
                                                    } else {
                                                        phi_2460_ = true;
                                                    }
                                                    let _e3681 = phi_2460_;
                                                    phi_2461_ = _e3681;
                                                    phi_2462_ = _e3679;
                                                    phi_2463_ = false;
                                                } else {
                                                    phi_2461_ = false;
                                                    phi_2462_ = false;
                                                    phi_2463_ = true;
                                                }
                                                let _e3683 = phi_2461_;
                                                let _e3685 = phi_2462_;
                                                let _e3687 = phi_2463_;
                                                phi_2464_ = _e3683;
                                                phi_2465_ = _e3685;
                                                phi_2466_ = _e3687;
                                            }
                                            let _e3689 = phi_2464_;
                                            let _e3691 = phi_2465_;
                                            let _e3693 = phi_2466_;
                                            phi_2467_ = _e3689;
                                            phi_2468_ = _e3672;
                                            phi_2469_ = _e3691;
                                            phi_2470_ = _e3693;
                                            phi_2471_ = false;
                                            phi_2472_ = false;
                                        } else {
                                            phi_2467_ = false;
                                            phi_2468_ = false;
                                            phi_2469_ = false;
                                            phi_2470_ = false;
                                            let _e5257 = local_70;
                                            phi_2471_ = _e5257;
                                            let _e5260 = local_71;
                                            phi_2472_ = _e5260;
                                        }
                                        let _e3695 = phi_2467_;
                                        let _e3697 = phi_2468_;
                                        let _e3699 = phi_2469_;
                                        let _e3701 = phi_2470_;
                                        let _e3703 = phi_2471_;
                                        let _e3705 = phi_2472_;
                                        let _e5263 = local_72;
                                        phi_2473_ = _e5263;
                                        let _e5266 = local_73;
                                        phi_2474_ = _e5266;
                                        phi_2475_ = _e3695;
                                        phi_2476_ = _e3697;
                                        phi_2477_ = _e3699;
                                        phi_2478_ = _e3701;
                                        phi_2479_ = _e3703;
                                        phi_2480_ = _e3705;
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
                                    let _e3707 = phi_2473_;
                                    let _e3709 = phi_2474_;
                                    let _e3711 = phi_2475_;
                                    let _e3713 = phi_2476_;
                                    let _e3715 = phi_2477_;
                                    let _e3717 = phi_2478_;
                                    let _e3719 = phi_2479_;
                                    let _e3721 = phi_2480_;
                                    let _e3723 = phi_2481_;
                                    phi_2482_ = _e3707;
                                    phi_2483_ = _e3709;
                                    phi_2484_ = _e3711;
                                    phi_2485_ = _e3713;
                                    phi_2486_ = _e3715;
                                    phi_2487_ = _e3717;
                                    phi_2488_ = _e3719;
                                    phi_2489_ = _e3721;
                                    phi_2490_ = _e3723;
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
                                let _e3725 = phi_2482_;
                                let _e3727 = phi_2483_;
                                let _e3729 = phi_2484_;
                                let _e3731 = phi_2485_;
                                let _e3733 = phi_2486_;
                                let _e3735 = phi_2487_;
                                let _e3737 = phi_2488_;
                                let _e3739 = phi_2489_;
                                let _e3741 = phi_2490_;
                                let _e3743 = phi_2491_;
                                phi_2492_ = _e3725;
                                phi_1581_ = _e3727;
                                phi_2493_ = _e3729;
                                phi_2494_ = _e3731;
                                phi_2495_ = _e3733;
                                phi_2496_ = false;
                                phi_2497_ = _e3735;
                                phi_2498_ = _e3737;
                                phi_2499_ = _e3739;
                                phi_2500_ = _e3741;
                                phi_2501_ = _e3743;
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
                            let _e3745 = phi_2492_;
                            let _e3747 = phi_1581_;
                            let _e3749 = phi_2493_;
                            let _e3751 = phi_2494_;
                            let _e3753 = phi_2495_;
                            let _e3755 = phi_2496_;
                            let _e3757 = phi_2497_;
                            let _e3759 = phi_2498_;
                            let _e3761 = phi_2499_;
                            let _e3763 = phi_2500_;
                            let _e3765 = phi_2501_;
                            local_39 = _e3751;
                            local_74 = _e3753;
                            local_75 = _e3755;
                            local_76 = _e3757;
                            local_77 = _e3759;
                            local_78 = _e3761;
                            local_79 = _e3763;
                            local_80 = _e3765;
                            local_81 = _e3745;
                            local_83 = _e3751;
                            continue;
                            continuing {
                                phi_1577_ = _e3170;
                                phi_1580_ = _e3747;
                                break if !(_e3749);
                            }
                        }
                        let _e3768 = local_39;
                        if _e3768 {
                            phi_2506_ = type_32(0u, type_32().member_1);
                            phi_2507_ = false;
                            phi_2508_ = false;
                            phi_2509_ = false;
                            phi_2510_ = false;
                            phi_2511_ = false;
                            phi_2512_ = false;
                            phi_2513_ = false;
                        } else {
                            phi_2506_ = type_32();
                            let _e5299 = local_74;
                            phi_2507_ = _e5299;
                            let _e5302 = local_75;
                            phi_2508_ = _e5302;
                            let _e5305 = local_76;
                            phi_2509_ = _e5305;
                            let _e5308 = local_77;
                            phi_2510_ = _e5308;
                            let _e5311 = local_78;
                            phi_2511_ = _e5311;
                            let _e5314 = local_79;
                            phi_2512_ = _e5314;
                            let _e5317 = local_80;
                            phi_2513_ = _e5317;
                        }
                        let _e3772 = phi_2506_;
                        let _e3774 = phi_2507_;
                        let _e3776 = phi_2508_;
                        let _e3778 = phi_2509_;
                        let _e3780 = phi_2510_;
                        let _e3782 = phi_2511_;
                        let _e3784 = phi_2512_;
                        let _e3786 = phi_2513_;
                        if _e3774 {
                            let _e5320 = local_81;
                            phi_2517_ = _e5320;
                            phi_2518_ = true;
                            phi_2519_ = false;
                            phi_2520_ = false;
                            phi_2521_ = false;
                            phi_2522_ = false;
                            phi_2523_ = false;
                            phi_2524_ = false;
                        } else {
                            let _e5322 = local_82;
                            phi_2517_ = _e5322;
                            phi_2518_ = _e3776;
                            phi_2519_ = _e3778;
                            phi_2520_ = _e3780;
                            phi_2521_ = _e3782;
                            let _e5329 = local_83;
                            phi_2522_ = _e5329;
                            phi_2523_ = _e3784;
                            phi_2524_ = _e3786;
                        }
                        let _e3788 = phi_2517_;
                        let _e3790 = phi_2518_;
                        let _e3792 = phi_2519_;
                        let _e3794 = phi_2520_;
                        let _e3796 = phi_2521_;
                        let _e3798 = phi_2522_;
                        let _e3800 = phi_2523_;
                        let _e3802 = phi_2524_;
                        if _e3790 {
                            phi_2529_ = type_32(1u, _e3788);
                            phi_2530_ = false;
                            phi_2531_ = false;
                            phi_2532_ = false;
                            phi_2533_ = false;
                            phi_2534_ = false;
                            phi_2535_ = false;
                        } else {
                            phi_2529_ = type_32();
                            phi_2530_ = _e3792;
                            phi_2531_ = _e3794;
                            phi_2532_ = _e3796;
                            phi_2533_ = _e3798;
                            phi_2534_ = _e3800;
                            phi_2535_ = _e3802;
                        }
                        let _e3805 = phi_2529_;
                        let _e3807 = phi_2530_;
                        let _e3809 = phi_2531_;
                        let _e3811 = phi_2532_;
                        let _e3813 = phi_2533_;
                        let _e3815 = phi_2534_;
                        let _e3817 = phi_2535_;
                        if _e3807 {
                            let _e3819 = local_40;
                            phi_2540_ = type_32(1u, _e3819);
                            phi_2541_ = false;
                            phi_2542_ = false;
                            phi_2543_ = true;
                            phi_2544_ = false;
                            phi_2545_ = false;
                        } else {
                            phi_2540_ = _e3772;
                            phi_2541_ = _e3809;
                            phi_2542_ = _e3811;
                            phi_2543_ = _e3813;
                            phi_2544_ = _e3815;
                            phi_2545_ = _e3817;
                        }
                        let _e3822 = phi_2540_;
                        let _e3824 = phi_2541_;
                        let _e3826 = phi_2542_;
                        let _e3828 = phi_2543_;
                        let _e3830 = phi_2544_;
                        let _e3832 = phi_2545_;
                        if _e3824 {
                            let _e3834 = local_41;
                            phi_2550_ = type_32(1u, _e3834);
                            phi_2551_ = false;
                            phi_2552_ = false;
                            phi_2553_ = false;
                            phi_2554_ = false;
                        } else {
                            phi_2550_ = type_32();
                            phi_2551_ = _e3826;
                            phi_2552_ = _e3828;
                            phi_2553_ = _e3830;
                            phi_2554_ = _e3832;
                        }
                        let _e3837 = phi_2550_;
                        let _e3839 = phi_2551_;
                        let _e3841 = phi_2552_;
                        let _e3843 = phi_2553_;
                        let _e3845 = phi_2554_;
                        if _e3839 {
                            let _e3847 = local_42;
                            phi_2559_ = type_32(1u, _e3847);
                            phi_2560_ = true;
                            phi_2561_ = false;
                            phi_2562_ = false;
                            phi_2563_ = false;
                        } else {
                            phi_2559_ = _e3837;
                            phi_2560_ = _e3824;
                            phi_2561_ = _e3841;
                            phi_2562_ = _e3843;
                            phi_2563_ = _e3845;
                        }
                        let _e3850 = phi_2559_;
                        let _e3852 = phi_2560_;
                        let _e3854 = phi_2561_;
                        let _e3856 = phi_2562_;
                        let _e3858 = phi_2563_;
                        if _e3852 {
                            phi_2567_ = _e3850;
                            phi_2568_ = true;
                            phi_2569_ = false;
                            phi_2570_ = false;
                        } else {
                            phi_2567_ = _e3822;
                            phi_2568_ = _e3854;
                            phi_2569_ = _e3856;
                            phi_2570_ = _e3858;
                        }
                        let _e3860 = phi_2567_;
                        let _e3862 = phi_2568_;
                        let _e3864 = phi_2569_;
                        let _e3866 = phi_2570_;
                        if _e3862 {
                            phi_2574_ = false;
                            phi_2575_ = false;
                        } else {
                            phi_2574_ = _e3864;
                            phi_2575_ = _e3866;
                        }
                        let _e3868 = phi_2574_;
                        let _e3870 = phi_2575_;
                        if _e3868 {
                            phi_2579_ = false;
                            phi_2580_ = false;
                        } else {
                            phi_2579_ = _e3870;
                            phi_2580_ = _e3862;
                        }
                        let _e3872 = phi_2579_;
                        let _e3874 = phi_2580_;
                        if _e3872 {
                            phi_2584_ = true;
                            phi_2585_ = false;
                        } else {
                            phi_2584_ = _e3868;
                            phi_2585_ = _e3874;
                        }
                        let _e3876 = phi_2584_;
                        let _e3878 = phi_2585_;
                        if _e3876 {
                            let _e3880 = local_43;
                            phi_2590_ = type_32(1u, _e3880);
                            phi_2591_ = true;
                        } else {
                            phi_2590_ = _e3860;
                            phi_2591_ = _e3878;
                        }
                        let _e3883 = phi_2590_;
                        let _e3885 = phi_2591_;
                        if _e3885 {
                            phi_2595_ = _e3883;
                        } else {
                            phi_2595_ = _e3805;
                        }
                        let _e3887 = phi_2595_;
                        if (_e3887.member != 0u) {
                            local_14[0u] = 0f;
                            local_14[1u] = (0.02f * 0.0000005f);
                            local_14[2u] = (1.8f * 0.0000005f);
                            phi_2609_ = type_19(0u, 3u);
                            loop {
                                let _e3899 = phi_2609_;
                                if (_e3899.member < _e3899.member_1) {
                                    phi_2610_ = type_19((_e3899.member + 1u), _e3899.member_1);
                                    phi_2633_ = type_19(1u, _e3899.member);
                                } else {
                                    phi_2610_ = _e3899;
                                    phi_2633_ = type_19(0u, type_19().member_1);
                                }
                                let _e3911 = phi_2610_;
                                let _e3913 = phi_2633_;
                                if (bitcast<i32>(_e3913.member) != 0i) {
                                    let _e3919 = local_14[_e3913.member_1];
                                    let _e3920 = (_e3887.member_1 + _e3919);
                                    if (_e3920 < 1f) {
                                        phi_2653_ = _e3920;
                                    } else {
                                        phi_2653_ = 1f;
                                    }
                                    let _e3923 = phi_2653_;
                                    let _e3926 = local_15.member[0u];
                                    let _e3932 = local_15.member[1u];
                                    let _e3942 = (_e3926[0] + ((_e3932[0] - _e3926[0]) * _e3923));
                                    let _e3943 = (_e3926[1] + ((_e3932[1] - _e3926[1]) * _e3923));
                                    let _e3944 = (_e3926[2] + ((_e3932[2] - _e3926[2]) * _e3923));
                                    let _e3947 = local_15.member_1[0u];
                                    let _e3953 = local_15.member_1[1u];
                                    let _e3963 = (_e3947[0] + ((_e3953[0] - _e3947[0]) * _e3923));
                                    let _e3964 = (_e3947[1] + ((_e3953[1] - _e3947[1]) * _e3923));
                                    let _e3965 = (_e3947[2] + ((_e3953[2] - _e3947[2]) * _e3923));
                                    let _e3968 = local_15.member_2[0u];
                                    let _e3974 = local_15.member_2[1u];
                                    let _e3984 = (_e3968[0] + ((_e3974[0] - _e3968[0]) * _e3923));
                                    let _e3985 = (_e3968[1] + ((_e3974[1] - _e3968[1]) * _e3923));
                                    let _e3986 = (_e3968[2] + ((_e3974[2] - _e3968[2]) * _e3923));
                                    let _e3991 = (((_e3963 * _e3963) + (_e3964 * _e3964)) + (_e3965 * _e3965));
                                    let _e3996 = (((_e3963 * _e3984) + (_e3964 * _e3985)) + (_e3965 * _e3986));
                                    let _e4001 = (((_e3984 * _e3984) + (_e3985 * _e3985)) + (_e3986 * _e3986));
                                    let _e4006 = (((_e3942 * _e3963) + (_e3943 * _e3964)) + (_e3944 * _e3965));
                                    let _e4011 = (((_e3942 * _e3984) + (_e3943 * _e3985)) + (_e3944 * _e3986));
                                    let _e4014 = ((_e3991 * _e4001) - (_e3996 * _e3996));
                                    let _e4018 = (((_e4006 * _e4001) - (_e4011 * _e3996)) / _e4014);
                                    let _e4022 = (((_e4011 * _e3991) - (_e4006 * _e3996)) / _e4014);
                                    if (_e4018 >= 0f) {
                                        if (_e4022 >= 0f) {
                                            phi_2821_ = ((_e4018 + _e4022) <= 1f);
                                            phi_2822_ = false;
                                        } else {
                                            phi_2821_ = bool();
                                            phi_2822_ = true;
                                        }
                                        let _e4028 = phi_2821_;
                                        let _e4030 = phi_2822_;
                                        phi_2823_ = _e4028;
                                        phi_2824_ = _e4030;
                                    } else {
                                        phi_2823_ = bool();
                                        phi_2824_ = true;
                                    }
                                    let _e4032 = phi_2823_;
                                    let _e4034 = phi_2824_;
                                    if _e4034 {
                                        phi_2828_ = false;
                                    } else {
                                        phi_2828_ = _e4032;
                                    }
                                    let _e4036 = phi_2828_;
                                    if (_e4014 > 0f) {
                                        if _e4036 {
                                            phi_2850_ = array<f32, 3>((_e3942 - ((_e3963 * _e4018) + (_e3984 * _e4022))), (_e3943 - ((_e3964 * _e4018) + (_e3985 * _e4022))), (_e3944 - ((_e3965 * _e4018) + (_e3986 * _e4022))));
                                            phi_2851_ = false;
                                        } else {
                                            phi_2850_ = array<f32, 3>();
                                            phi_2851_ = true;
                                        }
                                        let _e4052 = phi_2850_;
                                        let _e4054 = phi_2851_;
                                        phi_2852_ = _e4052;
                                        phi_2853_ = _e4054;
                                    } else {
                                        phi_2852_ = array<f32, 3>();
                                        phi_2853_ = true;
                                    }
                                    let _e4056 = phi_2852_;
                                    let _e4058 = phi_2853_;
                                    if _e4058 {
                                        let _e4059 = (_e3942 - _e3963);
                                        let _e4060 = (_e3943 - _e3964);
                                        let _e4061 = (_e3944 - _e3965);
                                        let _e4062 = (_e3984 - _e3963);
                                        let _e4063 = (_e3985 - _e3964);
                                        let _e4064 = (_e3986 - _e3965);
                                        let _e4075 = ((((_e4059 * _e4062) + (_e4060 * _e4063)) + (_e4061 * _e4064)) / (((_e4062 * _e4062) + (_e4063 * _e4063)) + (_e4064 * _e4064)));
                                        if (_e4075 > 0f) {
                                            if (_e4075 < 1f) {
                                                phi_3021_ = _e4075;
                                            } else {
                                                phi_3021_ = 1f;
                                            }
                                            let _e4079 = phi_3021_;
                                            phi_3022_ = _e4079;
                                        } else {
                                            phi_3022_ = 0f;
                                        }
                                        let _e4081 = phi_3022_;
                                        let _e4085 = (_e4059 - (_e4062 * _e4081));
                                        let _e4086 = (_e4060 - (_e4063 * _e4081));
                                        let _e4087 = (_e4061 - (_e4064 * _e4081));
                                        let _e4098 = ((((_e3942 * _e3963) + (_e3943 * _e3964)) + (_e3944 * _e3965)) / (((_e3963 * _e3963) + (_e3964 * _e3964)) + (_e3965 * _e3965)));
                                        if (_e4098 > 0f) {
                                            if (_e4098 < 1f) {
                                                phi_3049_ = _e4098;
                                            } else {
                                                phi_3049_ = 1f;
                                            }
                                            let _e4102 = phi_3049_;
                                            phi_3050_ = _e4102;
                                        } else {
                                            phi_3050_ = 0f;
                                        }
                                        let _e4104 = phi_3050_;
                                        let _e4121 = ((((_e3942 * _e3984) + (_e3943 * _e3985)) + (_e3944 * _e3986)) / (((_e3984 * _e3984) + (_e3985 * _e3985)) + (_e3986 * _e3986)));
                                        if (_e4121 > 0f) {
                                            if (_e4121 < 1f) {
                                                phi_3077_ = _e4121;
                                            } else {
                                                phi_3077_ = 1f;
                                            }
                                            let _e4125 = phi_3077_;
                                            phi_3078_ = _e4125;
                                        } else {
                                            phi_3078_ = 0f;
                                        }
                                        let _e4127 = phi_3078_;
                                        local_10[0u] = array<f32, 3>((_e3942 - (_e3963 * _e4104)), (_e3943 - (_e3964 * _e4104)), (_e3944 - (_e3965 * _e4104)));
                                        local_10[1u] = array<f32, 3>((_e3942 - (_e3984 * _e4127)), (_e3943 - (_e3985 * _e4127)), (_e3944 - (_e3986 * _e4127)));
                                        local_10[2u] = array<f32, 3>(_e4085, _e4086, _e4087);
                                        local_10[3u] = array<f32, 3>(_e4085, _e4086, _e4087);
                                        let _e4143 = local_10[0u];
                                        phi_3114_ = type_19(1u, 4u);
                                        phi_3117_ = array<f32, 3>(_e4143[0], _e4143[1], _e4143[2]);
                                        loop {
                                            let _e4149 = phi_3114_;
                                            let _e4151 = phi_3117_;
                                            local_84 = _e4151;
                                            if (_e4149.member < _e4149.member_1) {
                                                phi_3115_ = type_19((_e4149.member + 1u), _e4149.member_1);
                                                phi_3140_ = type_19(1u, _e4149.member);
                                            } else {
                                                phi_3115_ = _e4149;
                                                phi_3140_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e4163 = phi_3115_;
                                            let _e4165 = phi_3140_;
                                            let _e4169 = (bitcast<i32>(_e4165.member) != 0i);
                                            if _e4169 {
                                                let _e4171 = local_10[_e4165.member_1];
                                                let _e4176 = local_10[_e4165.member_1];
                                                if ((((_e4171[0] * _e4176[0]) + (_e4171[1] * _e4176[1])) + (_e4171[2] * _e4176[2])) < (((_e4151[0] * _e4151[0]) + (_e4151[1] * _e4151[1])) + (_e4151[2] * _e4151[2]))) {
                                                    let _e4198 = local_10[_e4165.member_1];
                                                    phi_3207_ = array<f32, 3>(_e4198[0], _e4198[1], _e4198[2]);
                                                } else {
                                                    phi_3207_ = _e4151;
                                                }
                                                let _e4204 = phi_3207_;
                                                phi_3118_ = _e4204;
                                            } else {
                                                phi_3118_ = array<f32, 3>();
                                            }
                                            let _e4206 = phi_3118_;
                                            continue;
                                            continuing {
                                                phi_3114_ = _e4163;
                                                phi_3117_ = _e4206;
                                                break if !(_e4169);
                                            }
                                        }
                                        let _e5399 = local_84;
                                        phi_3208_ = _e5399;
                                    } else {
                                        phi_3208_ = _e4056;
                                    }
                                    let _e4209 = phi_3208_;
                                    let _e4220 = (((_e4209[0] * _e4209[0]) + (_e4209[1] * _e4209[1])) + (_e4209[2] * _e4209[2]));
                                    if (_e4220 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4220 > 0f) {
                                            phi_3233_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3233_ = 0f;
                                        }
                                        let _e4273 = phi_3233_;
                                        phi_3297_ = _e4273;
                                    } else {
                                        phi_3240_ = type_17(0i, 5i);
                                        phi_3243_ = bitcast<f32>(((bitcast<u32>(_e4220) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4228 = phi_3240_;
                                            let _e4230 = phi_3243_;
                                            local_44 = _e4230;
                                            if (_e4228.member < _e4228.member_1) {
                                                let _e4237 = (_e4228.member + 1i);
                                                if ((false == (_e4237 > _e4228.member)) != false) {
                                                    phi_3264_ = true;
                                                } else {
                                                    phi_3264_ = false;
                                                }
                                                let _e4242 = phi_3264_;
                                                if _e4242 {
                                                    phi_3270_ = type_18(0u, type_18().member_1);
                                                } else {
                                                    phi_3270_ = type_18(1u, _e4237);
                                                }
                                                let _e4247 = phi_3270_;
                                                phi_3241_ = type_17(_e4247.member_1, _e4228.member_1);
                                                phi_3284_ = type_18(1u, _e4228.member);
                                            } else {
                                                phi_3241_ = _e4228;
                                                phi_3284_ = type_18(0u, type_18().member_1);
                                            }
                                            let _e4253 = phi_3241_;
                                            let _e4255 = phi_3284_;
                                            let _e4258 = (bitcast<i32>(_e4255.member) != 0i);
                                            if _e4258 {
                                                phi_3244_ = (0.5f * (_e4230 + (_e4220 / _e4230)));
                                            } else {
                                                phi_3244_ = f32();
                                            }
                                            let _e4263 = phi_3244_;
                                            continue;
                                            continuing {
                                                phi_3240_ = _e4253;
                                                phi_3243_ = _e4263;
                                                break if !(_e4258);
                                            }
                                        }
                                        let _e4268 = local_44;
                                        phi_3297_ = (_e4268 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e4275 = phi_3297_;
                                    let _e4281 = local_15.member[0u];
                                    if (_e4281[0] < 0f) {
                                        phi_3313_ = -(_e4281[0]);
                                    } else {
                                        phi_3313_ = _e4281[0];
                                    }
                                    let _e4288 = phi_3313_;
                                    if (_e4281[1] < 0f) {
                                        phi_3320_ = -(_e4281[1]);
                                    } else {
                                        phi_3320_ = _e4281[1];
                                    }
                                    let _e4292 = phi_3320_;
                                    if (_e4288 > _e4292) {
                                        phi_3325_ = _e4288;
                                    } else {
                                        phi_3325_ = _e4292;
                                    }
                                    let _e4295 = phi_3325_;
                                    if (_e4281[2] < 0f) {
                                        phi_3332_ = -(_e4281[2]);
                                    } else {
                                        phi_3332_ = _e4281[2];
                                    }
                                    let _e4299 = phi_3332_;
                                    if (_e4295 > _e4299) {
                                        phi_3337_ = _e4295;
                                    } else {
                                        phi_3337_ = _e4299;
                                    }
                                    let _e4302 = phi_3337_;
                                    let _e4305 = local_15.member[1u];
                                    if (_e4305[0] < 0f) {
                                        phi_3350_ = -(_e4305[0]);
                                    } else {
                                        phi_3350_ = _e4305[0];
                                    }
                                    let _e4312 = phi_3350_;
                                    if (_e4305[1] < 0f) {
                                        phi_3357_ = -(_e4305[1]);
                                    } else {
                                        phi_3357_ = _e4305[1];
                                    }
                                    let _e4316 = phi_3357_;
                                    if (_e4312 > _e4316) {
                                        phi_3362_ = _e4312;
                                    } else {
                                        phi_3362_ = _e4316;
                                    }
                                    let _e4319 = phi_3362_;
                                    if (_e4305[2] < 0f) {
                                        phi_3369_ = -(_e4305[2]);
                                    } else {
                                        phi_3369_ = _e4305[2];
                                    }
                                    let _e4323 = phi_3369_;
                                    if (_e4319 > _e4323) {
                                        phi_3374_ = _e4319;
                                    } else {
                                        phi_3374_ = _e4323;
                                    }
                                    let _e4326 = phi_3374_;
                                    if (_e4302 > _e4326) {
                                        phi_3379_ = _e4302;
                                    } else {
                                        phi_3379_ = _e4326;
                                    }
                                    let _e4329 = phi_3379_;
                                    let _e4331 = local_15.member_3;
                                    let _e4335 = local_15.member_1[0u];
                                    if (_e4335[0] < 0f) {
                                        phi_3396_ = -(_e4335[0]);
                                    } else {
                                        phi_3396_ = _e4335[0];
                                    }
                                    let _e4342 = phi_3396_;
                                    if (_e4335[1] < 0f) {
                                        phi_3403_ = -(_e4335[1]);
                                    } else {
                                        phi_3403_ = _e4335[1];
                                    }
                                    let _e4346 = phi_3403_;
                                    if (_e4342 > _e4346) {
                                        phi_3408_ = _e4342;
                                    } else {
                                        phi_3408_ = _e4346;
                                    }
                                    let _e4349 = phi_3408_;
                                    if (_e4335[2] < 0f) {
                                        phi_3415_ = -(_e4335[2]);
                                    } else {
                                        phi_3415_ = _e4335[2];
                                    }
                                    let _e4353 = phi_3415_;
                                    if (_e4349 > _e4353) {
                                        phi_3420_ = _e4349;
                                    } else {
                                        phi_3420_ = _e4353;
                                    }
                                    let _e4356 = phi_3420_;
                                    let _e4359 = local_15.member_1[1u];
                                    if (_e4359[0] < 0f) {
                                        phi_3434_ = -(_e4359[0]);
                                    } else {
                                        phi_3434_ = _e4359[0];
                                    }
                                    let _e4366 = phi_3434_;
                                    if (_e4359[1] < 0f) {
                                        phi_3441_ = -(_e4359[1]);
                                    } else {
                                        phi_3441_ = _e4359[1];
                                    }
                                    let _e4370 = phi_3441_;
                                    if (_e4366 > _e4370) {
                                        phi_3446_ = _e4366;
                                    } else {
                                        phi_3446_ = _e4370;
                                    }
                                    let _e4373 = phi_3446_;
                                    if (_e4359[2] < 0f) {
                                        phi_3453_ = -(_e4359[2]);
                                    } else {
                                        phi_3453_ = _e4359[2];
                                    }
                                    let _e4377 = phi_3453_;
                                    if (_e4373 > _e4377) {
                                        phi_3458_ = _e4373;
                                    } else {
                                        phi_3458_ = _e4377;
                                    }
                                    let _e4380 = phi_3458_;
                                    if (_e4356 > _e4380) {
                                        phi_3463_ = _e4356;
                                    } else {
                                        phi_3463_ = _e4380;
                                    }
                                    let _e4383 = phi_3463_;
                                    let _e4385 = local_15.member_3;
                                    let _e4389 = local_15.member_2[0u];
                                    if (_e4389[0] < 0f) {
                                        phi_3480_ = -(_e4389[0]);
                                    } else {
                                        phi_3480_ = _e4389[0];
                                    }
                                    let _e4396 = phi_3480_;
                                    if (_e4389[1] < 0f) {
                                        phi_3487_ = -(_e4389[1]);
                                    } else {
                                        phi_3487_ = _e4389[1];
                                    }
                                    let _e4400 = phi_3487_;
                                    if (_e4396 > _e4400) {
                                        phi_3492_ = _e4396;
                                    } else {
                                        phi_3492_ = _e4400;
                                    }
                                    let _e4403 = phi_3492_;
                                    if (_e4389[2] < 0f) {
                                        phi_3499_ = -(_e4389[2]);
                                    } else {
                                        phi_3499_ = _e4389[2];
                                    }
                                    let _e4407 = phi_3499_;
                                    if (_e4403 > _e4407) {
                                        phi_3504_ = _e4403;
                                    } else {
                                        phi_3504_ = _e4407;
                                    }
                                    let _e4410 = phi_3504_;
                                    let _e4413 = local_15.member_2[1u];
                                    if (_e4413[0] < 0f) {
                                        phi_3518_ = -(_e4413[0]);
                                    } else {
                                        phi_3518_ = _e4413[0];
                                    }
                                    let _e4420 = phi_3518_;
                                    if (_e4413[1] < 0f) {
                                        phi_3525_ = -(_e4413[1]);
                                    } else {
                                        phi_3525_ = _e4413[1];
                                    }
                                    let _e4424 = phi_3525_;
                                    if (_e4420 > _e4424) {
                                        phi_3530_ = _e4420;
                                    } else {
                                        phi_3530_ = _e4424;
                                    }
                                    let _e4427 = phi_3530_;
                                    if (_e4413[2] < 0f) {
                                        phi_3537_ = -(_e4413[2]);
                                    } else {
                                        phi_3537_ = _e4413[2];
                                    }
                                    let _e4431 = phi_3537_;
                                    if (_e4427 > _e4431) {
                                        phi_3542_ = _e4427;
                                    } else {
                                        phi_3542_ = _e4431;
                                    }
                                    let _e4434 = phi_3542_;
                                    if (_e4410 > _e4434) {
                                        phi_3547_ = _e4410;
                                    } else {
                                        phi_3547_ = _e4434;
                                    }
                                    let _e4437 = phi_3547_;
                                    let _e4439 = local_15.member_3;
                                    let _e4446 = local_15.member_3;
                                    let _e4453 = (((_e4275 * (1f + (0.000000059604645f * 8f))) + (((((((_e4329 + _e4331) + (_e4383 + _e4385)) + (_e4437 + _e4439)) * (0.000000059604645f * 16f)) + (_e4446 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e253);
                                    if _e4453 {
                                        phi_3567_ = false;
                                    } else {
                                        phi_3567_ = true;
                                    }
                                    let _e4455 = phi_3567_;
                                    phi_3568_ = _e4455;
                                    phi_3569_ = _e4453;
                                } else {
                                    phi_3568_ = false;
                                    phi_3569_ = false;
                                }
                                let _e4457 = phi_3568_;
                                let _e4459 = phi_3569_;
                                local_45 = _e4459;
                                continue;
                                continuing {
                                    phi_2609_ = _e3911;
                                    break if !(_e4457);
                                }
                            }
                            let _e4462 = local_45;
                            if _e4462 {
                                phi_3574_ = type_32(1u, _e3887.member_1);
                                phi_3575_ = false;
                            } else {
                                phi_3574_ = type_32();
                                phi_3575_ = true;
                            }
                            let _e4465 = phi_3574_;
                            let _e4467 = phi_3575_;
                            if _e4467 {
                                phi_3580_ = type_32(2u, _e3887.member_1);
                                phi_3581_ = false;
                            } else {
                                phi_3580_ = type_32();
                                phi_3581_ = true;
                            }
                            let _e4470 = phi_3580_;
                            let _e4472 = phi_3581_;
                            phi_3583_ = _e4470;
                            phi_3584_ = _e4465;
                            phi_3585_ = _e4472;
                        } else {
                            phi_3583_ = type_32();
                            phi_3584_ = type_32(0u, type_32().member_1);
                            phi_3585_ = true;
                        }
                        let _e4474 = phi_3583_;
                        let _e4476 = phi_3584_;
                        let _e4478 = phi_3585_;
                        if _e4478 {
                            phi_3589_ = _e4476;
                        } else {
                            phi_3589_ = _e4474;
                        }
                        let _e4480 = phi_3589_;
                        phi_6863_ = _e4480;
                    } else {
                        if (_e351 < 0f) {
                            phi_3599_ = -(_e351);
                        } else {
                            phi_3599_ = _e351;
                        }
                        let _e694 = phi_3599_;
                        if (_e374 < 0f) {
                            phi_3605_ = -(_e374);
                        } else {
                            phi_3605_ = _e374;
                        }
                        let _e698 = phi_3605_;
                        if (_e694 > _e698) {
                            phi_3610_ = _e694;
                        } else {
                            phi_3610_ = _e698;
                        }
                        let _e701 = phi_3610_;
                        if (_e397 < 0f) {
                            phi_3616_ = -(_e397);
                        } else {
                            phi_3616_ = _e397;
                        }
                        let _e705 = phi_3616_;
                        if (_e408 < 0f) {
                            phi_3622_ = -(_e408);
                        } else {
                            phi_3622_ = _e408;
                        }
                        let _e709 = phi_3622_;
                        if (_e705 > _e709) {
                            phi_3627_ = _e705;
                        } else {
                            phi_3627_ = _e709;
                        }
                        let _e712 = phi_3627_;
                        if (_e701 > _e712) {
                            phi_3632_ = _e701;
                        } else {
                            phi_3632_ = _e712;
                        }
                        let _e715 = phi_3632_;
                        let _e716 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e715 >= _e716) {
                            phi_3640_ = (_e715 <= (1f / _e716));
                        } else {
                            phi_3640_ = false;
                        }
                        let _e721 = phi_3640_;
                        if _e721 {
                            phi_3645_ = (0.000000059604645f * 256f);
                        } else {
                            phi_3645_ = 2f;
                        }
                        let _e724 = phi_3645_;
                        let _e726 = ((_e658 * 0.34f) + (_e715 * _e724));
                        if _e721 {
                            phi_3652_ = (1f / _e715);
                        } else {
                            phi_3652_ = 0f;
                        }
                        let _e729 = phi_3652_;
                        let _e735 = ((_e374 - (3f * _e351)) * _e729);
                        let _e736 = ((_e397 - _e374) * _e729);
                        let _e737 = (((3f * _e408) - _e397) * _e729);
                        local_7[0u] = 0f;
                        local_7[1u] = 1f;
                        local_7[2u] = 1f;
                        local_7[3u] = 1f;
                        let _e744 = ((_e736 * _e736) - (_e735 * _e737));
                        if (_e744 > 0f) {
                            if (_e744 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e744 > 0f) {
                                    phi_3685_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_3685_ = 0f;
                                }
                                let _e798 = phi_3685_;
                                phi_3749_ = _e798;
                            } else {
                                phi_3692_ = type_17(0i, 5i);
                                phi_3695_ = bitcast<f32>(((bitcast<u32>(_e744) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e753 = phi_3692_;
                                    let _e755 = phi_3695_;
                                    local_16 = _e755;
                                    if (_e753.member < _e753.member_1) {
                                        let _e762 = (_e753.member + 1i);
                                        if ((false == (_e762 > _e753.member)) != false) {
                                            phi_3716_ = true;
                                        } else {
                                            phi_3716_ = false;
                                        }
                                        let _e767 = phi_3716_;
                                        if _e767 {
                                            phi_3722_ = type_18(0u, type_18().member_1);
                                        } else {
                                            phi_3722_ = type_18(1u, _e762);
                                        }
                                        let _e772 = phi_3722_;
                                        phi_3693_ = type_17(_e772.member_1, _e753.member_1);
                                        phi_3736_ = type_18(1u, _e753.member);
                                    } else {
                                        phi_3693_ = _e753;
                                        phi_3736_ = type_18(0u, type_18().member_1);
                                    }
                                    let _e778 = phi_3693_;
                                    let _e780 = phi_3736_;
                                    let _e783 = (bitcast<i32>(_e780.member) != 0i);
                                    if _e783 {
                                        phi_3696_ = (0.5f * (_e755 + (_e744 / _e755)));
                                    } else {
                                        phi_3696_ = f32();
                                    }
                                    let _e788 = phi_3696_;
                                    continue;
                                    continuing {
                                        phi_3692_ = _e778;
                                        phi_3695_ = _e788;
                                        break if !(_e783);
                                    }
                                }
                                let _e793 = local_16;
                                phi_3749_ = (_e793 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e800 = phi_3749_;
                            if (_e736 < 0f) {
                                phi_3755_ = -(_e800);
                            } else {
                                phi_3755_ = _e800;
                            }
                            let _e804 = phi_3755_;
                            let _e806 = -((_e736 + _e804));
                            local_8[0u] = (_e806 / (_e806 + _e737));
                            local_8[1u] = (_e735 / (_e735 + _e806));
                            let _e815 = local_8[1u];
                            let _e816 = local_8[0u];
                            if (_e815 < _e816) {
                                let _e819 = local_8[1u];
                                let _e821 = local_8[0u];
                                local_8[0u] = _e819;
                                local_8[1u] = _e821;
                            }
                            phi_3780_ = type_19(0u, 2u);
                            phi_3783_ = 1u;
                            loop {
                                let _e825 = phi_3780_;
                                let _e827 = phi_3783_;
                                local_46 = _e827;
                                if (_e825.member < _e825.member_1) {
                                    phi_3781_ = type_19((_e825.member + 1u), _e825.member_1);
                                    phi_3806_ = type_19(1u, _e825.member);
                                } else {
                                    phi_3781_ = _e825;
                                    phi_3806_ = type_19(0u, type_19().member_1);
                                }
                                let _e839 = phi_3781_;
                                let _e841 = phi_3806_;
                                let _e845 = (bitcast<i32>(_e841.member) != 0i);
                                if _e845 {
                                    let _e847 = local_8[_e841.member_1];
                                    if (_e847 > 0f) {
                                        let _e850 = local_8[_e841.member_1];
                                        if (_e850 < 1f) {
                                            let _e853 = local_8[_e841.member_1];
                                            local_7[_e827] = _e853;
                                            phi_3850_ = (_e827 + 1u);
                                        } else {
                                            phi_3850_ = _e827;
                                        }
                                        let _e857 = phi_3850_;
                                        phi_3851_ = _e857;
                                    } else {
                                        phi_3851_ = _e827;
                                    }
                                    let _e859 = phi_3851_;
                                    phi_3784_ = _e859;
                                } else {
                                    phi_3784_ = u32();
                                }
                                let _e861 = phi_3784_;
                                continue;
                                continuing {
                                    phi_3780_ = _e839;
                                    phi_3783_ = _e861;
                                    break if !(_e845);
                                }
                            }
                            let _e4689 = local_46;
                            phi_3852_ = _e4689;
                        } else {
                            phi_3852_ = 1u;
                        }
                        let _e864 = phi_3852_;
                        local_7[_e864] = 1f;
                        let _e866 = local_7;
                        local_9 = _e866;
                        phi_3872_ = type_19(0u, _e864);
                        loop {
                            let _e869 = phi_3872_;
                            if (_e869.member < _e869.member_1) {
                                phi_3873_ = type_19((_e869.member + 1u), _e869.member_1);
                                phi_3896_ = type_19(1u, _e869.member);
                            } else {
                                phi_3873_ = _e869;
                                phi_3896_ = type_19(0u, type_19().member_1);
                            }
                            let _e881 = phi_3873_;
                            let _e883 = phi_3896_;
                            if (bitcast<i32>(_e883.member) != 0i) {
                                let _e889 = local_9[_e883.member_1];
                                let _e892 = local_9[(_e883.member_1 + 1u)];
                                let _e893 = (1f - _e889);
                                let _e904 = ((((_e351 * _e893) + (_e374 * _e889)) * (_e893 * _e893)) + (((_e397 * _e893) + (_e408 * _e889)) * (_e889 * _e889)));
                                let _e905 = (1f - _e892);
                                let _e916 = ((((_e351 * _e905) + (_e374 * _e892)) * (_e905 * _e905)) + (((_e397 * _e905) + (_e408 * _e892)) * (_e892 * _e892)));
                                if (_e904 < 0f) {
                                    phi_3948_ = -(_e904);
                                } else {
                                    phi_3948_ = _e904;
                                }
                                let _e920 = phi_3948_;
                                let _e921 = (_e920 > _e726);
                                if (_e916 < 0f) {
                                    phi_3955_ = -(_e916);
                                } else {
                                    phi_3955_ = _e916;
                                }
                                let _e925 = phi_3955_;
                                let _e926 = (_e925 > _e726);
                                if _e921 {
                                    if _e926 {
                                        phi_3966_ = ((_e904 > 0f) != (_e916 > 0f));
                                        phi_3967_ = false;
                                    } else {
                                        phi_3966_ = bool();
                                        phi_3967_ = true;
                                    }
                                    let _e931 = phi_3966_;
                                    let _e933 = phi_3967_;
                                    phi_3968_ = _e931;
                                    phi_3969_ = _e933;
                                } else {
                                    phi_3968_ = bool();
                                    phi_3969_ = true;
                                }
                                let _e935 = phi_3968_;
                                let _e937 = phi_3969_;
                                if _e937 {
                                    phi_3973_ = false;
                                } else {
                                    phi_3973_ = _e935;
                                }
                                let _e939 = phi_3973_;
                                if _e921 {
                                    if _e926 {
                                        if _e939 {
                                            phi_3984_ = type_33();
                                        } else {
                                            phi_3984_ = type_33(1f, 0f, _e939);
                                        }
                                        let _e942 = phi_3984_;
                                        phi_3985_ = _e942;
                                        phi_3986_ = _e939;
                                    } else {
                                        phi_3985_ = type_33();
                                        phi_3986_ = true;
                                    }
                                    let _e944 = phi_3985_;
                                    let _e946 = phi_3986_;
                                    phi_3987_ = _e944;
                                    phi_3988_ = _e946;
                                } else {
                                    phi_3987_ = type_33();
                                    phi_3988_ = true;
                                }
                                let _e948 = phi_3987_;
                                let _e950 = phi_3988_;
                                if _e950 {
                                    if _e921 {
                                        if (_e904 < 0f) {
                                            phi_3999_ = -1f;
                                        } else {
                                            phi_3999_ = 1f;
                                        }
                                        let _e953 = phi_3999_;
                                        let _e956 = (_e397 - _e374);
                                        phi_4009_ = type_19(0u, 64u);
                                        phi_4012_ = _e892;
                                        phi_4014_ = _e889;
                                        phi_4016_ = (0.5f * (_e889 + _e892));
                                        loop {
                                            let _e962 = phi_4009_;
                                            let _e964 = phi_4012_;
                                            let _e966 = phi_4014_;
                                            let _e968 = phi_4016_;
                                            local_48 = _e966;
                                            if (_e962.member < _e962.member_1) {
                                                phi_4010_ = type_19((_e962.member + 1u), _e962.member_1);
                                                phi_4039_ = type_19(1u, _e962.member);
                                            } else {
                                                phi_4010_ = _e962;
                                                phi_4039_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e980 = phi_4010_;
                                            let _e982 = phi_4039_;
                                            if (bitcast<i32>(_e982.member) != 0i) {
                                                let _e986 = (1f - _e968);
                                                let _e999 = ((_e953 * ((((_e351 * _e986) + (_e374 * _e968)) * (_e986 * _e986)) + (((_e397 * _e986) + (_e408 * _e968)) * (_e968 * _e968)))) - _e726);
                                                if (_e999 > 0f) {
                                                    phi_4064_ = _e964;
                                                    phi_4065_ = _e968;
                                                } else {
                                                    phi_4064_ = _e968;
                                                    phi_4065_ = _e966;
                                                }
                                                let _e1002 = phi_4064_;
                                                let _e1004 = phi_4065_;
                                                let _e1006 = ((_e1002 - _e1004) > 0.00000000000022737368f);
                                                if _e1006 {
                                                    let _e1007 = (1f - _e968);
                                                    let _e1019 = (-(_e999) / (_e953 * (((((_e374 - (3f * _e351)) * _e1007) + (_e956 * _e968)) * _e1007) + (((_e956 * _e1007) + (((3f * _e408) - _e397) * _e968)) * _e968))));
                                                    if (_e999 > 0f) {
                                                        phi_4091_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_4091_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1025 = phi_4091_;
                                                    let _e1027 = ((_e968 + _e1019) + _e1025);
                                                    if (_e1027 > _e1004) {
                                                        if (_e1027 < _e1002) {
                                                            if (_e1019 < 0f) {
                                                                phi_4107_ = -(_e1019);
                                                            } else {
                                                                phi_4107_ = _e1019;
                                                            }
                                                            let _e1033 = phi_4107_;
                                                            if (_e1033 < (0.5f * (_e1002 - _e1004))) {
                                                                phi_4114_ = false;
                                                            } else {
                                                                phi_4114_ = true;
                                                            }
                                                            let _e1038 = phi_4114_;
                                                            phi_4115_ = _e1038;
                                                        } else {
                                                            phi_4115_ = true;
                                                        }
                                                        let _e1040 = phi_4115_;
                                                        phi_4116_ = _e1040;
                                                    } else {
                                                        phi_4116_ = true;
                                                    }
                                                    let _e1042 = phi_4116_;
                                                    if _e1042 {
                                                        phi_4122_ = (0.5f * (_e1004 + _e1002));
                                                    } else {
                                                        phi_4122_ = _e1027;
                                                    }
                                                    let _e1046 = phi_4122_;
                                                    phi_4123_ = _e1046;
                                                    phi_4124_ = false;
                                                } else {
                                                    phi_4123_ = f32();
                                                    phi_4124_ = true;
                                                }
                                                let _e1048 = phi_4123_;
                                                let _e1050 = phi_4124_;
                                                phi_4013_ = _e1002;
                                                phi_4015_ = _e1004;
                                                phi_4017_ = _e1048;
                                                phi_4125_ = _e1004;
                                                phi_4126_ = _e1006;
                                                phi_4127_ = _e1050;
                                            } else {
                                                phi_4013_ = f32();
                                                phi_4015_ = f32();
                                                phi_4017_ = f32();
                                                phi_4125_ = f32();
                                                phi_4126_ = false;
                                                phi_4127_ = false;
                                            }
                                            let _e1052 = phi_4013_;
                                            let _e1054 = phi_4015_;
                                            let _e1056 = phi_4017_;
                                            let _e1058 = phi_4125_;
                                            let _e1060 = phi_4126_;
                                            let _e1062 = phi_4127_;
                                            local_17 = _e1062;
                                            local_47 = _e1058;
                                            continue;
                                            continuing {
                                                phi_4009_ = _e980;
                                                phi_4012_ = _e1052;
                                                phi_4014_ = _e1054;
                                                phi_4016_ = _e1056;
                                                break if !(_e1060);
                                            }
                                        }
                                        let _e1065 = local_17;
                                        if _e1065 {
                                            let _e4731 = local_47;
                                            phi_4131_ = _e4731;
                                        } else {
                                            let _e4733 = local_48;
                                            phi_4131_ = _e4733;
                                        }
                                        let _e1067 = phi_4131_;
                                        phi_4132_ = _e1067;
                                    } else {
                                        phi_4132_ = _e889;
                                    }
                                    let _e1069 = phi_4132_;
                                    if _e926 {
                                        phi_4139_ = type_19(0u, 64u);
                                        phi_4142_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1072 = phi_4139_;
                                            let _e1074 = phi_4142_;
                                            if (_e1072.member < _e1072.member_1) {
                                                phi_4140_ = type_19((_e1072.member + 1u), _e1072.member_1);
                                                phi_4165_ = type_19(1u, _e1072.member);
                                            } else {
                                                phi_4140_ = _e1072;
                                                phi_4165_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1086 = phi_4140_;
                                            let _e1088 = phi_4165_;
                                            if (bitcast<i32>(_e1088.member) != 0i) {
                                                let _e1092 = (_e1069 + _e1074);
                                                if (_e1092 < _e892) {
                                                    let _e1094 = (1f - _e1092);
                                                    let _e1105 = ((((_e351 * _e1094) + (_e374 * _e1092)) * (_e1094 * _e1094)) + (((_e397 * _e1094) + (_e408 * _e1092)) * (_e1092 * _e1092)));
                                                    let _e1106 = (1f - _e1069);
                                                    let _e1117 = ((((_e351 * _e1106) + (_e374 * _e1069)) * (_e1106 * _e1106)) + (((_e397 * _e1106) + (_e408 * _e1069)) * (_e1069 * _e1069)));
                                                    if (_e1105 < 0f) {
                                                        phi_4206_ = -(_e1105);
                                                    } else {
                                                        phi_4206_ = _e1105;
                                                    }
                                                    let _e1121 = phi_4206_;
                                                    if (_e1121 > _e726) {
                                                        if (_e1117 < 0f) {
                                                            phi_4216_ = -(_e1117);
                                                        } else {
                                                            phi_4216_ = _e1117;
                                                        }
                                                        let _e1126 = phi_4216_;
                                                        if (_e1126 > _e726) {
                                                            phi_4224_ = ((_e1105 > 0f) == (_e1117 > 0f));
                                                        } else {
                                                            phi_4224_ = false;
                                                        }
                                                        let _e1132 = phi_4224_;
                                                        phi_4226_ = !(_e1132);
                                                    } else {
                                                        phi_4226_ = false;
                                                    }
                                                    let _e1135 = phi_4226_;
                                                    if _e1135 {
                                                        phi_4231_ = f32();
                                                        phi_4232_ = false;
                                                    } else {
                                                        phi_4231_ = (_e1074 + _e1074);
                                                        phi_4232_ = true;
                                                    }
                                                    let _e1138 = phi_4231_;
                                                    let _e1140 = phi_4232_;
                                                    phi_4233_ = _e1138;
                                                    phi_4234_ = _e1140;
                                                    phi_4235_ = _e1135;
                                                    phi_4236_ = false;
                                                } else {
                                                    phi_4233_ = f32();
                                                    phi_4234_ = false;
                                                    phi_4235_ = false;
                                                    phi_4236_ = true;
                                                }
                                                let _e1142 = phi_4233_;
                                                let _e1144 = phi_4234_;
                                                let _e1146 = phi_4235_;
                                                let _e1148 = phi_4236_;
                                                phi_4237_ = _e1092;
                                                phi_4143_ = _e1142;
                                                phi_4238_ = _e1144;
                                                phi_4239_ = _e1146;
                                                phi_4240_ = _e1148;
                                                phi_4241_ = false;
                                            } else {
                                                phi_4237_ = f32();
                                                phi_4143_ = f32();
                                                phi_4238_ = false;
                                                phi_4239_ = false;
                                                phi_4240_ = false;
                                                phi_4241_ = true;
                                            }
                                            let _e1150 = phi_4237_;
                                            let _e1152 = phi_4143_;
                                            let _e1154 = phi_4238_;
                                            let _e1156 = phi_4239_;
                                            let _e1158 = phi_4240_;
                                            let _e1160 = phi_4241_;
                                            local_18 = _e1156;
                                            local_49 = _e1158;
                                            local_50 = _e1160;
                                            local_51 = _e1150;
                                            continue;
                                            continuing {
                                                phi_4139_ = _e1086;
                                                phi_4142_ = _e1152;
                                                break if !(_e1154);
                                            }
                                        }
                                        let _e1163 = local_18;
                                        if _e1163 {
                                            phi_4245_ = false;
                                            phi_4246_ = false;
                                        } else {
                                            let _e4758 = local_49;
                                            phi_4245_ = _e4758;
                                            let _e4761 = local_50;
                                            phi_4246_ = _e4761;
                                        }
                                        let _e1165 = phi_4245_;
                                        let _e1167 = phi_4246_;
                                        if _e1165 {
                                            phi_4250_ = true;
                                        } else {
                                            phi_4250_ = _e1167;
                                        }
                                        let _e1169 = phi_4250_;
                                        if _e1169 {
                                            phi_4254_ = _e892;
                                        } else {
                                            let _e4765 = local_51;
                                            phi_4254_ = _e4765;
                                        }
                                        let _e1171 = phi_4254_;
                                        phi_4255_ = _e1171;
                                    } else {
                                        phi_4255_ = _e892;
                                    }
                                    let _e1173 = phi_4255_;
                                    phi_4257_ = type_33(_e1069, _e1173, _e939);
                                } else {
                                    phi_4257_ = _e948;
                                }
                                let _e1176 = phi_4257_;
                                if (_e1176.member > _e1176.member_1) {
                                    phi_6819_ = f32();
                                    phi_6820_ = true;
                                    phi_6821_ = false;
                                    phi_6822_ = false;
                                    phi_6823_ = false;
                                } else {
                                    let _e1183 = ((_e1176.member_1 - _e1176.member) * 0.5f);
                                    let _e1184 = (_e1176.member + _e1183);
                                    let _e1186 = (_e1183 + (0.000000059604645f * 4f));
                                    let _e1188 = local_15.member_3;
                                    let _e1191 = local_15.member[0u];
                                    if (_e1191[0] < 0f) {
                                        phi_4286_ = -(_e1191[0]);
                                    } else {
                                        phi_4286_ = _e1191[0];
                                    }
                                    let _e1198 = phi_4286_;
                                    if (_e1191[1] < 0f) {
                                        phi_4293_ = -(_e1191[1]);
                                    } else {
                                        phi_4293_ = _e1191[1];
                                    }
                                    let _e1202 = phi_4293_;
                                    if (_e1198 > _e1202) {
                                        phi_4298_ = _e1198;
                                    } else {
                                        phi_4298_ = _e1202;
                                    }
                                    let _e1205 = phi_4298_;
                                    if (_e1191[2] < 0f) {
                                        phi_4305_ = -(_e1191[2]);
                                    } else {
                                        phi_4305_ = _e1191[2];
                                    }
                                    let _e1209 = phi_4305_;
                                    if (_e1205 > _e1209) {
                                        phi_4310_ = _e1205;
                                    } else {
                                        phi_4310_ = _e1209;
                                    }
                                    let _e1212 = phi_4310_;
                                    let _e1214 = local_15.member[1u];
                                    if (_e1214[0] < 0f) {
                                        phi_4323_ = -(_e1214[0]);
                                    } else {
                                        phi_4323_ = _e1214[0];
                                    }
                                    let _e1221 = phi_4323_;
                                    if (_e1214[1] < 0f) {
                                        phi_4330_ = -(_e1214[1]);
                                    } else {
                                        phi_4330_ = _e1214[1];
                                    }
                                    let _e1225 = phi_4330_;
                                    if (_e1221 > _e1225) {
                                        phi_4335_ = _e1221;
                                    } else {
                                        phi_4335_ = _e1225;
                                    }
                                    let _e1228 = phi_4335_;
                                    if (_e1214[2] < 0f) {
                                        phi_4342_ = -(_e1214[2]);
                                    } else {
                                        phi_4342_ = _e1214[2];
                                    }
                                    let _e1232 = phi_4342_;
                                    if (_e1228 > _e1232) {
                                        phi_4347_ = _e1228;
                                    } else {
                                        phi_4347_ = _e1232;
                                    }
                                    let _e1235 = phi_4347_;
                                    if (_e1212 > _e1235) {
                                        phi_4352_ = _e1212;
                                    } else {
                                        phi_4352_ = _e1235;
                                    }
                                    let _e1238 = phi_4352_;
                                    let _e1241 = local_15.member[0u];
                                    let _e1246 = local_15.member[1u];
                                    let _e1256 = (_e1241[0] + ((_e1246[0] - _e1241[0]) * _e1184));
                                    let _e1257 = (_e1241[1] + ((_e1246[1] - _e1241[1]) * _e1184));
                                    let _e1258 = (_e1241[2] + ((_e1246[2] - _e1241[2]) * _e1184));
                                    let _e1260 = local_15.member[1u];
                                    let _e1265 = local_15.member[0u];
                                    let _e1269 = (_e1260[0] - _e1265[0]);
                                    let _e1270 = (_e1260[1] - _e1265[1]);
                                    let _e1271 = (_e1260[2] - _e1265[2]);
                                    if (_e1269 < 0f) {
                                        phi_4411_ = -(_e1269);
                                    } else {
                                        phi_4411_ = _e1269;
                                    }
                                    let _e1275 = phi_4411_;
                                    if (_e1270 < 0f) {
                                        phi_4417_ = -(_e1270);
                                    } else {
                                        phi_4417_ = _e1270;
                                    }
                                    let _e1279 = phi_4417_;
                                    if (_e1275 > _e1279) {
                                        phi_4422_ = _e1275;
                                    } else {
                                        phi_4422_ = _e1279;
                                    }
                                    let _e1282 = phi_4422_;
                                    if (_e1271 < 0f) {
                                        phi_4428_ = -(_e1271);
                                    } else {
                                        phi_4428_ = _e1271;
                                    }
                                    let _e1286 = phi_4428_;
                                    if (_e1282 > _e1286) {
                                        phi_4433_ = _e1282;
                                    } else {
                                        phi_4433_ = _e1286;
                                    }
                                    let _e1289 = phi_4433_;
                                    let _e1295 = ((((_e1186 * _e1289) * 1.01f) + ((_e1238 + _e1188) * (0.000000059604645f * 8f))) + _e1188);
                                    if (_e1256 < 0f) {
                                        phi_4445_ = -(_e1256);
                                    } else {
                                        phi_4445_ = _e1256;
                                    }
                                    let _e1299 = phi_4445_;
                                    if (_e1257 < 0f) {
                                        phi_4451_ = -(_e1257);
                                    } else {
                                        phi_4451_ = _e1257;
                                    }
                                    let _e1303 = phi_4451_;
                                    if (_e1299 > _e1303) {
                                        phi_4456_ = _e1299;
                                    } else {
                                        phi_4456_ = _e1303;
                                    }
                                    let _e1306 = phi_4456_;
                                    if (_e1258 < 0f) {
                                        phi_4462_ = -(_e1258);
                                    } else {
                                        phi_4462_ = _e1258;
                                    }
                                    let _e1310 = phi_4462_;
                                    if (_e1306 > _e1310) {
                                        phi_4467_ = _e1306;
                                    } else {
                                        phi_4467_ = _e1310;
                                    }
                                    let _e1313 = phi_4467_;
                                    local_3 = type_24(array<f32, 3>(_e1256, _e1257, _e1258), _e1295, (_e1313 + _e1295));
                                    let _e1319 = local_15.member_3;
                                    let _e1321 = local_15.member_1[0u];
                                    if (_e1321[0] < 0f) {
                                        phi_4493_ = -(_e1321[0]);
                                    } else {
                                        phi_4493_ = _e1321[0];
                                    }
                                    let _e1328 = phi_4493_;
                                    if (_e1321[1] < 0f) {
                                        phi_4500_ = -(_e1321[1]);
                                    } else {
                                        phi_4500_ = _e1321[1];
                                    }
                                    let _e1332 = phi_4500_;
                                    if (_e1328 > _e1332) {
                                        phi_4505_ = _e1328;
                                    } else {
                                        phi_4505_ = _e1332;
                                    }
                                    let _e1335 = phi_4505_;
                                    if (_e1321[2] < 0f) {
                                        phi_4512_ = -(_e1321[2]);
                                    } else {
                                        phi_4512_ = _e1321[2];
                                    }
                                    let _e1339 = phi_4512_;
                                    if (_e1335 > _e1339) {
                                        phi_4517_ = _e1335;
                                    } else {
                                        phi_4517_ = _e1339;
                                    }
                                    let _e1342 = phi_4517_;
                                    let _e1344 = local_15.member_1[1u];
                                    if (_e1344[0] < 0f) {
                                        phi_4530_ = -(_e1344[0]);
                                    } else {
                                        phi_4530_ = _e1344[0];
                                    }
                                    let _e1351 = phi_4530_;
                                    if (_e1344[1] < 0f) {
                                        phi_4537_ = -(_e1344[1]);
                                    } else {
                                        phi_4537_ = _e1344[1];
                                    }
                                    let _e1355 = phi_4537_;
                                    if (_e1351 > _e1355) {
                                        phi_4542_ = _e1351;
                                    } else {
                                        phi_4542_ = _e1355;
                                    }
                                    let _e1358 = phi_4542_;
                                    if (_e1344[2] < 0f) {
                                        phi_4549_ = -(_e1344[2]);
                                    } else {
                                        phi_4549_ = _e1344[2];
                                    }
                                    let _e1362 = phi_4549_;
                                    if (_e1358 > _e1362) {
                                        phi_4554_ = _e1358;
                                    } else {
                                        phi_4554_ = _e1362;
                                    }
                                    let _e1365 = phi_4554_;
                                    if (_e1342 > _e1365) {
                                        phi_4559_ = _e1342;
                                    } else {
                                        phi_4559_ = _e1365;
                                    }
                                    let _e1368 = phi_4559_;
                                    let _e1371 = local_15.member_1[0u];
                                    let _e1376 = local_15.member_1[1u];
                                    let _e1386 = (_e1371[0] + ((_e1376[0] - _e1371[0]) * _e1184));
                                    let _e1387 = (_e1371[1] + ((_e1376[1] - _e1371[1]) * _e1184));
                                    let _e1388 = (_e1371[2] + ((_e1376[2] - _e1371[2]) * _e1184));
                                    let _e1390 = local_15.member_1[1u];
                                    let _e1395 = local_15.member_1[0u];
                                    let _e1399 = (_e1390[0] - _e1395[0]);
                                    let _e1400 = (_e1390[1] - _e1395[1]);
                                    let _e1401 = (_e1390[2] - _e1395[2]);
                                    if (_e1399 < 0f) {
                                        phi_4618_ = -(_e1399);
                                    } else {
                                        phi_4618_ = _e1399;
                                    }
                                    let _e1405 = phi_4618_;
                                    if (_e1400 < 0f) {
                                        phi_4624_ = -(_e1400);
                                    } else {
                                        phi_4624_ = _e1400;
                                    }
                                    let _e1409 = phi_4624_;
                                    if (_e1405 > _e1409) {
                                        phi_4629_ = _e1405;
                                    } else {
                                        phi_4629_ = _e1409;
                                    }
                                    let _e1412 = phi_4629_;
                                    if (_e1401 < 0f) {
                                        phi_4635_ = -(_e1401);
                                    } else {
                                        phi_4635_ = _e1401;
                                    }
                                    let _e1416 = phi_4635_;
                                    if (_e1412 > _e1416) {
                                        phi_4640_ = _e1412;
                                    } else {
                                        phi_4640_ = _e1416;
                                    }
                                    let _e1419 = phi_4640_;
                                    let _e1425 = ((((_e1186 * _e1419) * 1.01f) + ((_e1368 + _e1319) * (0.000000059604645f * 8f))) + _e1319);
                                    if (_e1386 < 0f) {
                                        phi_4652_ = -(_e1386);
                                    } else {
                                        phi_4652_ = _e1386;
                                    }
                                    let _e1429 = phi_4652_;
                                    if (_e1387 < 0f) {
                                        phi_4658_ = -(_e1387);
                                    } else {
                                        phi_4658_ = _e1387;
                                    }
                                    let _e1433 = phi_4658_;
                                    if (_e1429 > _e1433) {
                                        phi_4663_ = _e1429;
                                    } else {
                                        phi_4663_ = _e1433;
                                    }
                                    let _e1436 = phi_4663_;
                                    if (_e1388 < 0f) {
                                        phi_4669_ = -(_e1388);
                                    } else {
                                        phi_4669_ = _e1388;
                                    }
                                    let _e1440 = phi_4669_;
                                    if (_e1436 > _e1440) {
                                        phi_4674_ = _e1436;
                                    } else {
                                        phi_4674_ = _e1440;
                                    }
                                    let _e1443 = phi_4674_;
                                    local_4 = type_24(array<f32, 3>(_e1386, _e1387, _e1388), _e1425, (_e1443 + _e1425));
                                    let _e1449 = local_15.member_3;
                                    let _e1451 = local_15.member_2[0u];
                                    if (_e1451[0] < 0f) {
                                        phi_4700_ = -(_e1451[0]);
                                    } else {
                                        phi_4700_ = _e1451[0];
                                    }
                                    let _e1458 = phi_4700_;
                                    if (_e1451[1] < 0f) {
                                        phi_4707_ = -(_e1451[1]);
                                    } else {
                                        phi_4707_ = _e1451[1];
                                    }
                                    let _e1462 = phi_4707_;
                                    if (_e1458 > _e1462) {
                                        phi_4712_ = _e1458;
                                    } else {
                                        phi_4712_ = _e1462;
                                    }
                                    let _e1465 = phi_4712_;
                                    if (_e1451[2] < 0f) {
                                        phi_4719_ = -(_e1451[2]);
                                    } else {
                                        phi_4719_ = _e1451[2];
                                    }
                                    let _e1469 = phi_4719_;
                                    if (_e1465 > _e1469) {
                                        phi_4724_ = _e1465;
                                    } else {
                                        phi_4724_ = _e1469;
                                    }
                                    let _e1472 = phi_4724_;
                                    let _e1474 = local_15.member_2[1u];
                                    if (_e1474[0] < 0f) {
                                        phi_4737_ = -(_e1474[0]);
                                    } else {
                                        phi_4737_ = _e1474[0];
                                    }
                                    let _e1481 = phi_4737_;
                                    if (_e1474[1] < 0f) {
                                        phi_4744_ = -(_e1474[1]);
                                    } else {
                                        phi_4744_ = _e1474[1];
                                    }
                                    let _e1485 = phi_4744_;
                                    if (_e1481 > _e1485) {
                                        phi_4749_ = _e1481;
                                    } else {
                                        phi_4749_ = _e1485;
                                    }
                                    let _e1488 = phi_4749_;
                                    if (_e1474[2] < 0f) {
                                        phi_4756_ = -(_e1474[2]);
                                    } else {
                                        phi_4756_ = _e1474[2];
                                    }
                                    let _e1492 = phi_4756_;
                                    if (_e1488 > _e1492) {
                                        phi_4761_ = _e1488;
                                    } else {
                                        phi_4761_ = _e1492;
                                    }
                                    let _e1495 = phi_4761_;
                                    if (_e1472 > _e1495) {
                                        phi_4766_ = _e1472;
                                    } else {
                                        phi_4766_ = _e1495;
                                    }
                                    let _e1498 = phi_4766_;
                                    let _e1501 = local_15.member_2[0u];
                                    let _e1506 = local_15.member_2[1u];
                                    let _e1516 = (_e1501[0] + ((_e1506[0] - _e1501[0]) * _e1184));
                                    let _e1517 = (_e1501[1] + ((_e1506[1] - _e1501[1]) * _e1184));
                                    let _e1518 = (_e1501[2] + ((_e1506[2] - _e1501[2]) * _e1184));
                                    let _e1520 = local_15.member_2[1u];
                                    let _e1525 = local_15.member_2[0u];
                                    let _e1529 = (_e1520[0] - _e1525[0]);
                                    let _e1530 = (_e1520[1] - _e1525[1]);
                                    let _e1531 = (_e1520[2] - _e1525[2]);
                                    if (_e1529 < 0f) {
                                        phi_4825_ = -(_e1529);
                                    } else {
                                        phi_4825_ = _e1529;
                                    }
                                    let _e1535 = phi_4825_;
                                    if (_e1530 < 0f) {
                                        phi_4831_ = -(_e1530);
                                    } else {
                                        phi_4831_ = _e1530;
                                    }
                                    let _e1539 = phi_4831_;
                                    if (_e1535 > _e1539) {
                                        phi_4836_ = _e1535;
                                    } else {
                                        phi_4836_ = _e1539;
                                    }
                                    let _e1542 = phi_4836_;
                                    if (_e1531 < 0f) {
                                        phi_4842_ = -(_e1531);
                                    } else {
                                        phi_4842_ = _e1531;
                                    }
                                    let _e1546 = phi_4842_;
                                    if (_e1542 > _e1546) {
                                        phi_4847_ = _e1542;
                                    } else {
                                        phi_4847_ = _e1546;
                                    }
                                    let _e1549 = phi_4847_;
                                    let _e1555 = ((((_e1186 * _e1549) * 1.01f) + ((_e1498 + _e1449) * (0.000000059604645f * 8f))) + _e1449);
                                    if (_e1516 < 0f) {
                                        phi_4859_ = -(_e1516);
                                    } else {
                                        phi_4859_ = _e1516;
                                    }
                                    let _e1559 = phi_4859_;
                                    if (_e1517 < 0f) {
                                        phi_4865_ = -(_e1517);
                                    } else {
                                        phi_4865_ = _e1517;
                                    }
                                    let _e1563 = phi_4865_;
                                    if (_e1559 > _e1563) {
                                        phi_4870_ = _e1559;
                                    } else {
                                        phi_4870_ = _e1563;
                                    }
                                    let _e1566 = phi_4870_;
                                    if (_e1518 < 0f) {
                                        phi_4876_ = -(_e1518);
                                    } else {
                                        phi_4876_ = _e1518;
                                    }
                                    let _e1570 = phi_4876_;
                                    if (_e1566 > _e1570) {
                                        phi_4881_ = _e1566;
                                    } else {
                                        phi_4881_ = _e1570;
                                    }
                                    let _e1573 = phi_4881_;
                                    local_5 = type_24(array<f32, 3>(_e1516, _e1517, _e1518), _e1555, (_e1573 + _e1555));
                                    let _e1578 = local_4.member;
                                    let _e1583 = local_5.member;
                                    let _e1589 = ((_e1578[1] * _e1583[2]) - (_e1578[2] * _e1583[1]));
                                    let _e1592 = ((_e1578[2] * _e1583[0]) - (_e1578[0] * _e1583[2]));
                                    let _e1595 = ((_e1578[0] * _e1583[1]) - (_e1578[1] * _e1583[0]));
                                    if (_e1589 < 0f) {
                                        phi_4930_ = -(_e1589);
                                    } else {
                                        phi_4930_ = _e1589;
                                    }
                                    let _e1599 = phi_4930_;
                                    if (_e1592 < 0f) {
                                        phi_4936_ = -(_e1592);
                                    } else {
                                        phi_4936_ = _e1592;
                                    }
                                    let _e1603 = phi_4936_;
                                    if (_e1599 > _e1603) {
                                        if (_e1589 < 0f) {
                                            phi_4946_ = -(_e1589);
                                        } else {
                                            phi_4946_ = _e1589;
                                        }
                                        let _e1621 = phi_4946_;
                                        if (_e1595 < 0f) {
                                            phi_4952_ = -(_e1595);
                                        } else {
                                            phi_4952_ = _e1595;
                                        }
                                        let _e1625 = phi_4952_;
                                        if (_e1621 > _e1625) {
                                            phi_4957_ = 2u;
                                            phi_4958_ = 1u;
                                        } else {
                                            phi_4957_ = 1u;
                                            phi_4958_ = 0u;
                                        }
                                        let _e1628 = phi_4957_;
                                        let _e1630 = phi_4958_;
                                        phi_4977_ = _e1628;
                                        phi_4978_ = _e1630;
                                    } else {
                                        if (_e1592 < 0f) {
                                            phi_4964_ = -(_e1592);
                                        } else {
                                            phi_4964_ = _e1592;
                                        }
                                        let _e1608 = phi_4964_;
                                        if (_e1595 < 0f) {
                                            phi_4970_ = -(_e1595);
                                        } else {
                                            phi_4970_ = _e1595;
                                        }
                                        let _e1612 = phi_4970_;
                                        if (_e1608 > _e1612) {
                                            phi_4975_ = 0u;
                                            phi_4976_ = 2u;
                                        } else {
                                            phi_4975_ = 1u;
                                            phi_4976_ = 0u;
                                        }
                                        let _e1615 = phi_4975_;
                                        let _e1617 = phi_4976_;
                                        phi_4977_ = _e1615;
                                        phi_4978_ = _e1617;
                                    }
                                    let _e1632 = phi_4977_;
                                    let _e1634 = phi_4978_;
                                    let _e1637 = local_4.member[_e1634];
                                    let _e1640 = local_5.member[_e1632];
                                    let _e1644 = local_4.member[_e1632];
                                    let _e1647 = local_5.member[_e1634];
                                    let _e1649 = ((_e1637 * _e1640) - (_e1644 * _e1647));
                                    let _e1651 = local_4.member_1;
                                    let _e1653 = local_5.member_2;
                                    let _e1656 = local_4.member_2;
                                    let _e1658 = local_5.member_1;
                                    let _e1663 = local_4.member_2;
                                    let _e1665 = local_5.member_2;
                                    let _e1672 = local_4.member_2;
                                    let _e1675 = local_5.member_2;
                                    let _e1679 = (((((_e1651 * _e1653) + (_e1656 * _e1658)) * 2.01f) + ((_e1663 * _e1665) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1672) * (1f + _e1675))));
                                    if (_e1649 < 0f) {
                                        phi_5045_ = -(_e1649);
                                    } else {
                                        phi_5045_ = _e1649;
                                    }
                                    let _e1683 = phi_5045_;
                                    if (_e1683 > _e1679) {
                                        if (_e1649 < 0f) {
                                            phi_5054_ = -1f;
                                        } else {
                                            phi_5054_ = 1f;
                                        }
                                        let _e1687 = phi_5054_;
                                        let _e1690 = local_3.member[_e1634];
                                        let _e1693 = local_5.member[_e1632];
                                        let _e1697 = local_3.member[_e1632];
                                        let _e1700 = local_5.member[_e1634];
                                        let _e1704 = local_3.member_1;
                                        let _e1706 = local_5.member_2;
                                        let _e1709 = local_3.member_2;
                                        let _e1711 = local_5.member_1;
                                        let _e1716 = local_3.member_2;
                                        let _e1718 = local_5.member_2;
                                        let _e1725 = local_3.member_2;
                                        let _e1728 = local_5.member_2;
                                        let _e1732 = (((((_e1704 * _e1706) + (_e1709 * _e1711)) * 2.01f) + ((_e1716 * _e1718) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1725) * (1f + _e1728))));
                                        let _e1735 = local_4.member[_e1634];
                                        let _e1738 = local_3.member[_e1632];
                                        let _e1742 = local_4.member[_e1632];
                                        let _e1745 = local_3.member[_e1634];
                                        let _e1749 = local_4.member_1;
                                        let _e1751 = local_3.member_2;
                                        let _e1754 = local_4.member_2;
                                        let _e1756 = local_3.member_1;
                                        let _e1761 = local_4.member_2;
                                        let _e1763 = local_3.member_2;
                                        let _e1770 = local_4.member_2;
                                        let _e1773 = local_3.member_2;
                                        let _e1777 = (((((_e1749 * _e1751) + (_e1754 * _e1756)) * 2.01f) + ((_e1761 * _e1763) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1770) * (1f + _e1773))));
                                        let _e1778 = (_e1649 * _e1687);
                                        let _e1779 = (((_e1690 * _e1693) - (_e1697 * _e1700)) * _e1687);
                                        let _e1780 = (((_e1735 * _e1738) - (_e1742 * _e1745)) * _e1687);
                                        if (_e1778 < 0f) {
                                            phi_5185_ = -(_e1778);
                                        } else {
                                            phi_5185_ = _e1778;
                                        }
                                        let _e1784 = phi_5185_;
                                        if (_e1779 < 0f) {
                                            phi_5191_ = -(_e1779);
                                        } else {
                                            phi_5191_ = _e1779;
                                        }
                                        let _e1788 = phi_5191_;
                                        if (_e1780 < 0f) {
                                            phi_5198_ = -(_e1780);
                                        } else {
                                            phi_5198_ = _e1780;
                                        }
                                        let _e1793 = phi_5198_;
                                        let _e1798 = ((_e1778 - _e1779) - _e1780);
                                        let _e1801 = (((_e1679 + _e1732) + _e1777) + (((_e1784 + _e1788) + _e1793) * (0.000000059604645f * 4f)));
                                        local_6[0u].member = _e1779;
                                        local_6[0u].member_1 = _e1732;
                                        local_6[1u].member = _e1780;
                                        local_6[1u].member_1 = _e1777;
                                        local_6[2u].member = _e1798;
                                        local_6[2u].member_1 = _e1801;
                                        local_6[3u].member = _e1798;
                                        local_6[3u].member_1 = _e1801;
                                        phi_5241_ = type_19(0u, 4u);
                                        phi_5244_ = true;
                                        loop {
                                            let _e1816 = phi_5241_;
                                            let _e1818 = phi_5244_;
                                            local_20 = _e1818;
                                            if (_e1816.member < _e1816.member_1) {
                                                phi_5242_ = type_19((_e1816.member + 1u), _e1816.member_1);
                                                phi_5267_ = type_19(1u, _e1816.member);
                                            } else {
                                                phi_5242_ = _e1816;
                                                phi_5267_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1830 = phi_5242_;
                                            let _e1832 = phi_5267_;
                                            if (bitcast<i32>(_e1832.member) != 0i) {
                                                let _e1839 = local_6[_e1832.member_1].member;
                                                let _e1842 = local_6[_e1832.member_1].member_1;
                                                let _e1844 = (_e1839 < -(_e1842));
                                                if _e1844 {
                                                    phi_5294_ = bool();
                                                    phi_5295_ = false;
                                                } else {
                                                    phi_5294_ = (_e1818 && (_e1839 > _e1842));
                                                    phi_5295_ = true;
                                                }
                                                let _e1848 = phi_5294_;
                                                let _e1850 = phi_5295_;
                                                phi_5245_ = _e1848;
                                                phi_5296_ = _e1850;
                                                phi_5297_ = _e1844;
                                            } else {
                                                phi_5245_ = bool();
                                                phi_5296_ = false;
                                                phi_5297_ = false;
                                            }
                                            let _e1852 = phi_5245_;
                                            let _e1854 = phi_5296_;
                                            let _e1856 = phi_5297_;
                                            local_19 = _e1856;
                                            continue;
                                            continuing {
                                                phi_5241_ = _e1830;
                                                phi_5244_ = _e1852;
                                                break if !(_e1854);
                                            }
                                        }
                                        let _e1859 = local_19;
                                        if _e1859 {
                                            phi_5301_ = false;
                                        } else {
                                            phi_5301_ = true;
                                        }
                                        let _e1861 = phi_5301_;
                                        if _e1861 {
                                            let _e1863 = local_20;
                                            if _e1863 {
                                                phi_5308_ = 1u;
                                            } else {
                                                phi_5308_ = 2u;
                                            }
                                            let _e1865 = phi_5308_;
                                            phi_5309_ = _e1865;
                                            phi_5310_ = false;
                                        } else {
                                            phi_5309_ = u32();
                                            phi_5310_ = true;
                                        }
                                        let _e1867 = phi_5309_;
                                        let _e1869 = phi_5310_;
                                        phi_5311_ = _e1867;
                                        phi_5312_ = 0u;
                                        phi_5313_ = _e1869;
                                    } else {
                                        phi_5311_ = u32();
                                        phi_5312_ = 2u;
                                        phi_5313_ = true;
                                    }
                                    let _e1871 = phi_5311_;
                                    let _e1873 = phi_5312_;
                                    let _e1875 = phi_5313_;
                                    if _e1875 {
                                        phi_5317_ = _e1873;
                                    } else {
                                        phi_5317_ = _e1871;
                                    }
                                    let _e1877 = phi_5317_;
                                    let _e1878 = (_e1877 == 0u);
                                    if _e1878 {
                                        phi_6815_ = f32();
                                        phi_6816_ = false;
                                        phi_6817_ = false;
                                        phi_6818_ = false;
                                    } else {
                                        if (_e1877 == 1u) {
                                            if _e1176.member_2 {
                                                if ((_e1176.member_1 - _e1176.member) <= 0.0000005f) {
                                                    phi_5337_ = false;
                                                } else {
                                                    phi_5337_ = true;
                                                }
                                                let _e1886 = phi_5337_;
                                                phi_5338_ = _e1886;
                                            } else {
                                                phi_5338_ = true;
                                            }
                                            let _e1888 = phi_5338_;
                                            phi_5339_ = _e1888;
                                        } else {
                                            phi_5339_ = true;
                                        }
                                        let _e1890 = phi_5339_;
                                        if _e1890 {
                                            let _e1895 = local_15.member[0u];
                                            let _e1901 = local_15.member_1[0u];
                                            let _e1907 = local_15.member_2[0u];
                                            local_1 = array<array<f32, 3>, 4>(_e1895, array<f32, 3>((_e1895[0] - _e1901[0]), (_e1895[1] - _e1901[1]), (_e1895[2] - _e1901[2])), array<f32, 3>((_e1895[0] - _e1907[0]), (_e1895[1] - _e1907[1]), (_e1895[2] - _e1907[2])), _e1895);
                                            let _e1922 = local_15.member[1u];
                                            let _e1928 = local_15.member_1[1u];
                                            let _e1934 = local_15.member_2[1u];
                                            local_2 = array<array<f32, 3>, 4>(_e1922, array<f32, 3>((_e1922[0] - _e1928[0]), (_e1922[1] - _e1928[1]), (_e1922[2] - _e1928[2])), array<f32, 3>((_e1922[0] - _e1934[0]), (_e1922[1] - _e1934[1]), (_e1922[2] - _e1934[2])), _e1922);
                                            let _e1949 = local_15.member[0u];
                                            if (_e1949[0] < 0f) {
                                                phi_5535_ = -(_e1949[0]);
                                            } else {
                                                phi_5535_ = _e1949[0];
                                            }
                                            let _e1956 = phi_5535_;
                                            if (_e1949[1] < 0f) {
                                                phi_5542_ = -(_e1949[1]);
                                            } else {
                                                phi_5542_ = _e1949[1];
                                            }
                                            let _e1960 = phi_5542_;
                                            if (_e1956 > _e1960) {
                                                phi_5547_ = _e1956;
                                            } else {
                                                phi_5547_ = _e1960;
                                            }
                                            let _e1963 = phi_5547_;
                                            if (_e1949[2] < 0f) {
                                                phi_5554_ = -(_e1949[2]);
                                            } else {
                                                phi_5554_ = _e1949[2];
                                            }
                                            let _e1967 = phi_5554_;
                                            if (_e1963 > _e1967) {
                                                phi_5559_ = _e1963;
                                            } else {
                                                phi_5559_ = _e1967;
                                            }
                                            let _e1970 = phi_5559_;
                                            let _e1973 = local_15.member[1u];
                                            if (_e1973[0] < 0f) {
                                                phi_5572_ = -(_e1973[0]);
                                            } else {
                                                phi_5572_ = _e1973[0];
                                            }
                                            let _e1980 = phi_5572_;
                                            if (_e1973[1] < 0f) {
                                                phi_5579_ = -(_e1973[1]);
                                            } else {
                                                phi_5579_ = _e1973[1];
                                            }
                                            let _e1984 = phi_5579_;
                                            if (_e1980 > _e1984) {
                                                phi_5584_ = _e1980;
                                            } else {
                                                phi_5584_ = _e1984;
                                            }
                                            let _e1987 = phi_5584_;
                                            if (_e1973[2] < 0f) {
                                                phi_5591_ = -(_e1973[2]);
                                            } else {
                                                phi_5591_ = _e1973[2];
                                            }
                                            let _e1991 = phi_5591_;
                                            if (_e1987 > _e1991) {
                                                phi_5596_ = _e1987;
                                            } else {
                                                phi_5596_ = _e1991;
                                            }
                                            let _e1994 = phi_5596_;
                                            if (_e1970 > _e1994) {
                                                phi_5601_ = _e1970;
                                            } else {
                                                phi_5601_ = _e1994;
                                            }
                                            let _e1997 = phi_5601_;
                                            let _e1999 = local_15.member_3;
                                            let _e2003 = local_15.member_1[0u];
                                            if (_e2003[0] < 0f) {
                                                phi_5618_ = -(_e2003[0]);
                                            } else {
                                                phi_5618_ = _e2003[0];
                                            }
                                            let _e2010 = phi_5618_;
                                            if (_e2003[1] < 0f) {
                                                phi_5625_ = -(_e2003[1]);
                                            } else {
                                                phi_5625_ = _e2003[1];
                                            }
                                            let _e2014 = phi_5625_;
                                            if (_e2010 > _e2014) {
                                                phi_5630_ = _e2010;
                                            } else {
                                                phi_5630_ = _e2014;
                                            }
                                            let _e2017 = phi_5630_;
                                            if (_e2003[2] < 0f) {
                                                phi_5637_ = -(_e2003[2]);
                                            } else {
                                                phi_5637_ = _e2003[2];
                                            }
                                            let _e2021 = phi_5637_;
                                            if (_e2017 > _e2021) {
                                                phi_5642_ = _e2017;
                                            } else {
                                                phi_5642_ = _e2021;
                                            }
                                            let _e2024 = phi_5642_;
                                            let _e2027 = local_15.member_1[1u];
                                            if (_e2027[0] < 0f) {
                                                phi_5656_ = -(_e2027[0]);
                                            } else {
                                                phi_5656_ = _e2027[0];
                                            }
                                            let _e2034 = phi_5656_;
                                            if (_e2027[1] < 0f) {
                                                phi_5663_ = -(_e2027[1]);
                                            } else {
                                                phi_5663_ = _e2027[1];
                                            }
                                            let _e2038 = phi_5663_;
                                            if (_e2034 > _e2038) {
                                                phi_5668_ = _e2034;
                                            } else {
                                                phi_5668_ = _e2038;
                                            }
                                            let _e2041 = phi_5668_;
                                            if (_e2027[2] < 0f) {
                                                phi_5675_ = -(_e2027[2]);
                                            } else {
                                                phi_5675_ = _e2027[2];
                                            }
                                            let _e2045 = phi_5675_;
                                            if (_e2041 > _e2045) {
                                                phi_5680_ = _e2041;
                                            } else {
                                                phi_5680_ = _e2045;
                                            }
                                            let _e2048 = phi_5680_;
                                            if (_e2024 > _e2048) {
                                                phi_5685_ = _e2024;
                                            } else {
                                                phi_5685_ = _e2048;
                                            }
                                            let _e2051 = phi_5685_;
                                            let _e2053 = local_15.member_3;
                                            let _e2057 = local_15.member_2[0u];
                                            if (_e2057[0] < 0f) {
                                                phi_5702_ = -(_e2057[0]);
                                            } else {
                                                phi_5702_ = _e2057[0];
                                            }
                                            let _e2064 = phi_5702_;
                                            if (_e2057[1] < 0f) {
                                                phi_5709_ = -(_e2057[1]);
                                            } else {
                                                phi_5709_ = _e2057[1];
                                            }
                                            let _e2068 = phi_5709_;
                                            if (_e2064 > _e2068) {
                                                phi_5714_ = _e2064;
                                            } else {
                                                phi_5714_ = _e2068;
                                            }
                                            let _e2071 = phi_5714_;
                                            if (_e2057[2] < 0f) {
                                                phi_5721_ = -(_e2057[2]);
                                            } else {
                                                phi_5721_ = _e2057[2];
                                            }
                                            let _e2075 = phi_5721_;
                                            if (_e2071 > _e2075) {
                                                phi_5726_ = _e2071;
                                            } else {
                                                phi_5726_ = _e2075;
                                            }
                                            let _e2078 = phi_5726_;
                                            let _e2081 = local_15.member_2[1u];
                                            if (_e2081[0] < 0f) {
                                                phi_5740_ = -(_e2081[0]);
                                            } else {
                                                phi_5740_ = _e2081[0];
                                            }
                                            let _e2088 = phi_5740_;
                                            if (_e2081[1] < 0f) {
                                                phi_5747_ = -(_e2081[1]);
                                            } else {
                                                phi_5747_ = _e2081[1];
                                            }
                                            let _e2092 = phi_5747_;
                                            if (_e2088 > _e2092) {
                                                phi_5752_ = _e2088;
                                            } else {
                                                phi_5752_ = _e2092;
                                            }
                                            let _e2095 = phi_5752_;
                                            if (_e2081[2] < 0f) {
                                                phi_5759_ = -(_e2081[2]);
                                            } else {
                                                phi_5759_ = _e2081[2];
                                            }
                                            let _e2099 = phi_5759_;
                                            if (_e2095 > _e2099) {
                                                phi_5764_ = _e2095;
                                            } else {
                                                phi_5764_ = _e2099;
                                            }
                                            let _e2102 = phi_5764_;
                                            if (_e2078 > _e2102) {
                                                phi_5769_ = _e2078;
                                            } else {
                                                phi_5769_ = _e2102;
                                            }
                                            let _e2105 = phi_5769_;
                                            let _e2107 = local_15.member_3;
                                            let _e2114 = local_15.member_3;
                                            phi_5785_ = type_19(0u, 48u);
                                            phi_5788_ = _e1176.member;
                                            loop {
                                                let _e2120 = phi_5785_;
                                                let _e2122 = phi_5788_;
                                                local_65 = _e2122;
                                                local_27 = _e2122;
                                                local_28 = _e2122;
                                                local_29 = _e2122;
                                                local_30 = _e2122;
                                                if (_e2120.member < _e2120.member_1) {
                                                    phi_5786_ = type_19((_e2120.member + 1u), _e2120.member_1);
                                                    phi_5811_ = type_19(1u, _e2120.member);
                                                } else {
                                                    phi_5786_ = _e2120;
                                                    phi_5811_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2134 = phi_5786_;
                                                let _e2136 = phi_5811_;
                                                if (bitcast<i32>(_e2136.member) != 0i) {
                                                    let _e2142 = local_15.member[0u];
                                                    let _e2148 = local_15.member[1u];
                                                    let _e2158 = (_e2142[0] + ((_e2148[0] - _e2142[0]) * _e2122));
                                                    let _e2159 = (_e2142[1] + ((_e2148[1] - _e2142[1]) * _e2122));
                                                    let _e2160 = (_e2142[2] + ((_e2148[2] - _e2142[2]) * _e2122));
                                                    let _e2163 = local_15.member_1[0u];
                                                    let _e2169 = local_15.member_1[1u];
                                                    let _e2179 = (_e2163[0] + ((_e2169[0] - _e2163[0]) * _e2122));
                                                    let _e2180 = (_e2163[1] + ((_e2169[1] - _e2163[1]) * _e2122));
                                                    let _e2181 = (_e2163[2] + ((_e2169[2] - _e2163[2]) * _e2122));
                                                    let _e2184 = local_15.member_2[0u];
                                                    let _e2190 = local_15.member_2[1u];
                                                    let _e2200 = (_e2184[0] + ((_e2190[0] - _e2184[0]) * _e2122));
                                                    let _e2201 = (_e2184[1] + ((_e2190[1] - _e2184[1]) * _e2122));
                                                    let _e2202 = (_e2184[2] + ((_e2190[2] - _e2184[2]) * _e2122));
                                                    let _e2207 = (((_e2179 * _e2179) + (_e2180 * _e2180)) + (_e2181 * _e2181));
                                                    let _e2212 = (((_e2179 * _e2200) + (_e2180 * _e2201)) + (_e2181 * _e2202));
                                                    let _e2217 = (((_e2200 * _e2200) + (_e2201 * _e2201)) + (_e2202 * _e2202));
                                                    let _e2222 = (((_e2158 * _e2179) + (_e2159 * _e2180)) + (_e2160 * _e2181));
                                                    let _e2227 = (((_e2158 * _e2200) + (_e2159 * _e2201)) + (_e2160 * _e2202));
                                                    let _e2230 = ((_e2207 * _e2217) - (_e2212 * _e2212));
                                                    let _e2234 = (((_e2222 * _e2217) - (_e2227 * _e2212)) / _e2230);
                                                    let _e2238 = (((_e2227 * _e2207) - (_e2222 * _e2212)) / _e2230);
                                                    if (_e2234 >= 0f) {
                                                        if (_e2238 >= 0f) {
                                                            phi_5985_ = ((_e2234 + _e2238) <= 1f);
                                                            phi_5986_ = false;
                                                        } else {
                                                            phi_5985_ = bool();
                                                            phi_5986_ = true;
                                                        }
                                                        let _e2244 = phi_5985_;
                                                        let _e2246 = phi_5986_;
                                                        phi_5987_ = _e2244;
                                                        phi_5988_ = _e2246;
                                                    } else {
                                                        phi_5987_ = bool();
                                                        phi_5988_ = true;
                                                    }
                                                    let _e2248 = phi_5987_;
                                                    let _e2250 = phi_5988_;
                                                    if _e2250 {
                                                        phi_5992_ = false;
                                                    } else {
                                                        phi_5992_ = _e2248;
                                                    }
                                                    let _e2252 = phi_5992_;
                                                    if (_e2230 > 0f) {
                                                        if _e2252 {
                                                            phi_6014_ = array<f32, 3>((_e2158 - ((_e2179 * _e2234) + (_e2200 * _e2238))), (_e2159 - ((_e2180 * _e2234) + (_e2201 * _e2238))), (_e2160 - ((_e2181 * _e2234) + (_e2202 * _e2238))));
                                                            phi_6015_ = false;
                                                        } else {
                                                            phi_6014_ = array<f32, 3>();
                                                            phi_6015_ = true;
                                                        }
                                                        let _e2268 = phi_6014_;
                                                        let _e2270 = phi_6015_;
                                                        phi_6016_ = _e2268;
                                                        phi_6017_ = _e2270;
                                                    } else {
                                                        phi_6016_ = array<f32, 3>();
                                                        phi_6017_ = true;
                                                    }
                                                    let _e2272 = phi_6016_;
                                                    let _e2274 = phi_6017_;
                                                    if _e2274 {
                                                        let _e2275 = (_e2158 - _e2179);
                                                        let _e2276 = (_e2159 - _e2180);
                                                        let _e2277 = (_e2160 - _e2181);
                                                        let _e2278 = (_e2200 - _e2179);
                                                        let _e2279 = (_e2201 - _e2180);
                                                        let _e2280 = (_e2202 - _e2181);
                                                        let _e2291 = ((((_e2275 * _e2278) + (_e2276 * _e2279)) + (_e2277 * _e2280)) / (((_e2278 * _e2278) + (_e2279 * _e2279)) + (_e2280 * _e2280)));
                                                        if (_e2291 > 0f) {
                                                            if (_e2291 < 1f) {
                                                                phi_6185_ = _e2291;
                                                            } else {
                                                                phi_6185_ = 1f;
                                                            }
                                                            let _e2295 = phi_6185_;
                                                            phi_6186_ = _e2295;
                                                        } else {
                                                            phi_6186_ = 0f;
                                                        }
                                                        let _e2297 = phi_6186_;
                                                        let _e2301 = (_e2275 - (_e2278 * _e2297));
                                                        let _e2302 = (_e2276 - (_e2279 * _e2297));
                                                        let _e2303 = (_e2277 - (_e2280 * _e2297));
                                                        let _e2314 = ((((_e2158 * _e2179) + (_e2159 * _e2180)) + (_e2160 * _e2181)) / (((_e2179 * _e2179) + (_e2180 * _e2180)) + (_e2181 * _e2181)));
                                                        if (_e2314 > 0f) {
                                                            if (_e2314 < 1f) {
                                                                phi_6213_ = _e2314;
                                                            } else {
                                                                phi_6213_ = 1f;
                                                            }
                                                            let _e2318 = phi_6213_;
                                                            phi_6214_ = _e2318;
                                                        } else {
                                                            phi_6214_ = 0f;
                                                        }
                                                        let _e2320 = phi_6214_;
                                                        let _e2337 = ((((_e2158 * _e2200) + (_e2159 * _e2201)) + (_e2160 * _e2202)) / (((_e2200 * _e2200) + (_e2201 * _e2201)) + (_e2202 * _e2202)));
                                                        if (_e2337 > 0f) {
                                                            if (_e2337 < 1f) {
                                                                phi_6241_ = _e2337;
                                                            } else {
                                                                phi_6241_ = 1f;
                                                            }
                                                            let _e2341 = phi_6241_;
                                                            phi_6242_ = _e2341;
                                                        } else {
                                                            phi_6242_ = 0f;
                                                        }
                                                        let _e2343 = phi_6242_;
                                                        local[0u] = array<f32, 3>((_e2158 - (_e2179 * _e2320)), (_e2159 - (_e2180 * _e2320)), (_e2160 - (_e2181 * _e2320)));
                                                        local[1u] = array<f32, 3>((_e2158 - (_e2200 * _e2343)), (_e2159 - (_e2201 * _e2343)), (_e2160 - (_e2202 * _e2343)));
                                                        local[2u] = array<f32, 3>(_e2301, _e2302, _e2303);
                                                        local[3u] = array<f32, 3>(_e2301, _e2302, _e2303);
                                                        let _e2359 = local[0u];
                                                        phi_6278_ = type_19(1u, 4u);
                                                        phi_6281_ = array<f32, 3>(_e2359[0], _e2359[1], _e2359[2]);
                                                        loop {
                                                            let _e2365 = phi_6278_;
                                                            let _e2367 = phi_6281_;
                                                            local_52 = _e2367;
                                                            if (_e2365.member < _e2365.member_1) {
                                                                phi_6279_ = type_19((_e2365.member + 1u), _e2365.member_1);
                                                                phi_6304_ = type_19(1u, _e2365.member);
                                                            } else {
                                                                phi_6279_ = _e2365;
                                                                phi_6304_ = type_19(0u, type_19().member_1);
                                                            }
                                                            let _e2379 = phi_6279_;
                                                            let _e2381 = phi_6304_;
                                                            let _e2385 = (bitcast<i32>(_e2381.member) != 0i);
                                                            if _e2385 {
                                                                let _e2387 = local[_e2381.member_1];
                                                                let _e2392 = local[_e2381.member_1];
                                                                if ((((_e2387[0] * _e2392[0]) + (_e2387[1] * _e2392[1])) + (_e2387[2] * _e2392[2])) < (((_e2367[0] * _e2367[0]) + (_e2367[1] * _e2367[1])) + (_e2367[2] * _e2367[2]))) {
                                                                    let _e2414 = local[_e2381.member_1];
                                                                    phi_6371_ = array<f32, 3>(_e2414[0], _e2414[1], _e2414[2]);
                                                                } else {
                                                                    phi_6371_ = _e2367;
                                                                }
                                                                let _e2420 = phi_6371_;
                                                                phi_6282_ = _e2420;
                                                            } else {
                                                                phi_6282_ = array<f32, 3>();
                                                            }
                                                            let _e2422 = phi_6282_;
                                                            continue;
                                                            continuing {
                                                                phi_6278_ = _e2379;
                                                                phi_6281_ = _e2422;
                                                                break if !(_e2385);
                                                            }
                                                        }
                                                        let _e4930 = local_52;
                                                        phi_6372_ = _e4930;
                                                    } else {
                                                        phi_6372_ = _e2272;
                                                    }
                                                    let _e2425 = phi_6372_;
                                                    if (_e2425[0] < 0f) {
                                                        phi_6379_ = -(_e2425[0]);
                                                    } else {
                                                        phi_6379_ = _e2425[0];
                                                    }
                                                    let _e2430 = phi_6379_;
                                                    if (_e2425[1] < 0f) {
                                                        phi_6386_ = -(_e2425[1]);
                                                    } else {
                                                        phi_6386_ = _e2425[1];
                                                    }
                                                    let _e2435 = phi_6386_;
                                                    if (_e2425[2] < 0f) {
                                                        phi_6394_ = -(_e2425[2]);
                                                    } else {
                                                        phi_6394_ = _e2425[2];
                                                    }
                                                    let _e2441 = phi_6394_;
                                                    let _e2442 = ((_e2430 + _e2435) + _e2441);
                                                    if (_e2442 > 0f) {
                                                        if ((bitcast<u32>(_e2442) & 2139095040u) != 2139095040u) {
                                                            let _e2447 = (1f / _e2442);
                                                            let _e2449 = (_e2425[0] * _e2447);
                                                            let _e2451 = (_e2425[1] * _e2447);
                                                            let _e2453 = (_e2425[2] * _e2447);
                                                            let _e2458 = (((_e2449 * _e2449) + (_e2451 * _e2451)) + (_e2453 * _e2453));
                                                            if (_e2458 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2458 > 0f) {
                                                                    phi_6431_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6431_ = 0f;
                                                                }
                                                                let _e2511 = phi_6431_;
                                                                phi_6495_ = _e2511;
                                                            } else {
                                                                phi_6438_ = type_17(0i, 5i);
                                                                phi_6441_ = bitcast<f32>(((bitcast<u32>(_e2458) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2466 = phi_6438_;
                                                                    let _e2468 = phi_6441_;
                                                                    local_21 = _e2468;
                                                                    if (_e2466.member < _e2466.member_1) {
                                                                        let _e2475 = (_e2466.member + 1i);
                                                                        if ((false == (_e2475 > _e2466.member)) != false) {
                                                                            phi_6462_ = true;
                                                                        } else {
                                                                            phi_6462_ = false;
                                                                        }
                                                                        let _e2480 = phi_6462_;
                                                                        if _e2480 {
                                                                            phi_6468_ = type_18(0u, type_18().member_1);
                                                                        } else {
                                                                            phi_6468_ = type_18(1u, _e2475);
                                                                        }
                                                                        let _e2485 = phi_6468_;
                                                                        phi_6439_ = type_17(_e2485.member_1, _e2466.member_1);
                                                                        phi_6482_ = type_18(1u, _e2466.member);
                                                                    } else {
                                                                        phi_6439_ = _e2466;
                                                                        phi_6482_ = type_18(0u, type_18().member_1);
                                                                    }
                                                                    let _e2491 = phi_6439_;
                                                                    let _e2493 = phi_6482_;
                                                                    let _e2496 = (bitcast<i32>(_e2493.member) != 0i);
                                                                    if _e2496 {
                                                                        phi_6442_ = (0.5f * (_e2468 + (_e2458 / _e2468)));
                                                                    } else {
                                                                        phi_6442_ = f32();
                                                                    }
                                                                    let _e2501 = phi_6442_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6438_ = _e2491;
                                                                        phi_6441_ = _e2501;
                                                                        break if !(_e2496);
                                                                    }
                                                                }
                                                                let _e2506 = local_21;
                                                                phi_6495_ = (_e2506 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2513 = phi_6495_;
                                                            phi_6504_ = type_19(0u, 4u);
                                                            phi_6507_ = 2f;
                                                            loop {
                                                                let _e2521 = phi_6504_;
                                                                let _e2523 = phi_6507_;
                                                                local_23 = _e2523;
                                                                local_24 = _e2523;
                                                                local_25 = _e2523;
                                                                local_55 = _e2523;
                                                                local_56 = _e2523;
                                                                if (_e2521.member < _e2521.member_1) {
                                                                    phi_6505_ = type_19((_e2521.member + 1u), _e2521.member_1);
                                                                    phi_6530_ = type_19(1u, _e2521.member);
                                                                } else {
                                                                    phi_6505_ = _e2521;
                                                                    phi_6530_ = type_19(0u, type_19().member_1);
                                                                }
                                                                let _e2535 = phi_6505_;
                                                                let _e2537 = phi_6530_;
                                                                if (bitcast<i32>(_e2537.member) != 0i) {
                                                                    let _e2543 = local_1[_e2537.member_1];
                                                                    let _e2551 = (((_e2449 * _e2543[0]) + (_e2451 * _e2543[1])) + (_e2453 * _e2543[2]));
                                                                    let _e2553 = local_2[_e2537.member_1];
                                                                    let _e2561 = (((_e2449 * _e2553[0]) + (_e2451 * _e2553[1])) + (_e2453 * _e2553[2]));
                                                                    if (_e2551 < 0f) {
                                                                        phi_6581_ = -(_e2551);
                                                                    } else {
                                                                        phi_6581_ = _e2551;
                                                                    }
                                                                    let _e2565 = phi_6581_;
                                                                    if (_e2561 < 0f) {
                                                                        phi_6587_ = -(_e2561);
                                                                    } else {
                                                                        phi_6587_ = _e2561;
                                                                    }
                                                                    let _e2569 = phi_6587_;
                                                                    let _e2573 = (((((((((_e1997 + _e1999) + (_e2051 + _e2053)) + (_e2105 + _e2107)) * (0.000000059604645f * 16f)) + (_e2114 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2513) * (1f + (0.000000059604645f * 8f)))) + ((_e2565 + _e2569) * (0.000000059604645f * 8f)));
                                                                    if (_e2551 > _e2573) {
                                                                        if (_e2561 > _e2573) {
                                                                            phi_6600_ = false;
                                                                        } else {
                                                                            phi_6600_ = true;
                                                                        }
                                                                        let _e2577 = phi_6600_;
                                                                        phi_6601_ = _e2577;
                                                                    } else {
                                                                        phi_6601_ = true;
                                                                    }
                                                                    let _e2579 = phi_6601_;
                                                                    if _e2579 {
                                                                        if ((_e2551 + ((_e2561 - _e2551) * _e2122)) > _e2573) {
                                                                            if (_e2561 < _e2551) {
                                                                                let _e2587 = ((_e2551 - _e2561) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                                                if _e2587 {
                                                                                    let _e2593 = (((_e2551 - _e2573) / (_e2551 - _e2561)) * (1f - (0.000000059604645f * 16f)));
                                                                                    if (_e2523 < _e2593) {
                                                                                        phi_6632_ = _e2523;
                                                                                    } else {
                                                                                        phi_6632_ = _e2593;
                                                                                    }
                                                                                    let _e2596 = phi_6632_;
                                                                                    phi_6633_ = _e2596;
                                                                                } else {
                                                                                    phi_6633_ = f32();
                                                                                }
                                                                                let _e2598 = phi_6633_;
                                                                                phi_6634_ = _e2598;
                                                                                phi_6635_ = _e2587;
                                                                            } else {
                                                                                phi_6634_ = _e2523;
                                                                                phi_6635_ = true;
                                                                            }
                                                                            let _e2600 = phi_6634_;
                                                                            let _e2602 = phi_6635_;
                                                                            if _e2602 {
                                                                                phi_6639_ = false;
                                                                            } else {
                                                                                phi_6639_ = true;
                                                                            }
                                                                            let _e2604 = phi_6639_;
                                                                            phi_6640_ = _e2600;
                                                                            phi_6641_ = _e2602;
                                                                            phi_6642_ = _e2604;
                                                                            phi_6643_ = false;
                                                                        } else {
                                                                            phi_6640_ = f32();
                                                                            phi_6641_ = false;
                                                                            phi_6642_ = false;
                                                                            phi_6643_ = true;
                                                                        }
                                                                        let _e2606 = phi_6640_;
                                                                        let _e2608 = phi_6641_;
                                                                        let _e2610 = phi_6642_;
                                                                        let _e2612 = phi_6643_;
                                                                        phi_6644_ = _e2606;
                                                                        phi_6645_ = _e2608;
                                                                        phi_6646_ = _e2610;
                                                                        phi_6647_ = _e2612;
                                                                    } else {
                                                                        phi_6644_ = _e2523;
                                                                        phi_6645_ = true;
                                                                        phi_6646_ = false;
                                                                        phi_6647_ = false;
                                                                    }
                                                                    let _e2614 = phi_6644_;
                                                                    let _e2616 = phi_6645_;
                                                                    let _e2618 = phi_6646_;
                                                                    let _e2620 = phi_6647_;
                                                                    phi_6508_ = _e2614;
                                                                    phi_6648_ = _e2616;
                                                                    phi_6649_ = false;
                                                                    phi_6650_ = _e2618;
                                                                    phi_6651_ = _e2620;
                                                                } else {
                                                                    phi_6508_ = f32();
                                                                    phi_6648_ = false;
                                                                    phi_6649_ = true;
                                                                    phi_6650_ = false;
                                                                    phi_6651_ = false;
                                                                }
                                                                let _e2622 = phi_6508_;
                                                                let _e2624 = phi_6648_;
                                                                let _e2626 = phi_6649_;
                                                                let _e2628 = phi_6650_;
                                                                let _e2630 = phi_6651_;
                                                                local_22 = _e2626;
                                                                local_53 = _e2628;
                                                                local_54 = _e2630;
                                                                continue;
                                                                continuing {
                                                                    phi_6504_ = _e2535;
                                                                    phi_6507_ = _e2622;
                                                                    break if !(_e2624);
                                                                }
                                                            }
                                                            let _e2633 = local_22;
                                                            if _e2633 {
                                                                let _e2635 = local_23;
                                                                let _e2636 = (_e2635 > _e1176.member_1);
                                                                if _e2636 {
                                                                    phi_6672_ = false;
                                                                    phi_6673_ = false;
                                                                    phi_6674_ = false;
                                                                } else {
                                                                    let _e2638 = local_24;
                                                                    if (_e2638 > _e2122) {
                                                                        let _e2641 = local_25;
                                                                        let _e2643 = ((_e2641 - _e2122) < 0.00000000023283064f);
                                                                        if _e2643 {
                                                                            phi_6668_ = false;
                                                                        } else {
                                                                            phi_6668_ = true;
                                                                        }
                                                                        let _e2645 = phi_6668_;
                                                                        phi_6669_ = _e2645;
                                                                        phi_6670_ = _e2643;
                                                                        phi_6671_ = false;
                                                                    } else {
                                                                        phi_6669_ = false;
                                                                        phi_6670_ = false;
                                                                        phi_6671_ = true;
                                                                    }
                                                                    let _e2647 = phi_6669_;
                                                                    let _e2649 = phi_6670_;
                                                                    let _e2651 = phi_6671_;
                                                                    phi_6672_ = _e2647;
                                                                    phi_6673_ = _e2649;
                                                                    phi_6674_ = _e2651;
                                                                }
                                                                let _e2653 = phi_6672_;
                                                                let _e2655 = phi_6673_;
                                                                let _e2657 = phi_6674_;
                                                                phi_6675_ = _e2653;
                                                                phi_6676_ = _e2636;
                                                                phi_6677_ = _e2655;
                                                                phi_6678_ = _e2657;
                                                                phi_6679_ = false;
                                                                phi_6680_ = false;
                                                            } else {
                                                                phi_6675_ = false;
                                                                phi_6676_ = false;
                                                                phi_6677_ = false;
                                                                phi_6678_ = false;
                                                                let _e4987 = local_53;
                                                                phi_6679_ = _e4987;
                                                                let _e4990 = local_54;
                                                                phi_6680_ = _e4990;
                                                            }
                                                            let _e2659 = phi_6675_;
                                                            let _e2661 = phi_6676_;
                                                            let _e2663 = phi_6677_;
                                                            let _e2665 = phi_6678_;
                                                            let _e2667 = phi_6679_;
                                                            let _e2669 = phi_6680_;
                                                            let _e4993 = local_55;
                                                            phi_6681_ = _e4993;
                                                            let _e4996 = local_56;
                                                            phi_6682_ = _e4996;
                                                            phi_6683_ = _e2659;
                                                            phi_6684_ = _e2661;
                                                            phi_6685_ = _e2663;
                                                            phi_6686_ = _e2665;
                                                            phi_6687_ = _e2667;
                                                            phi_6688_ = _e2669;
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
                                                        let _e2671 = phi_6681_;
                                                        let _e2673 = phi_6682_;
                                                        let _e2675 = phi_6683_;
                                                        let _e2677 = phi_6684_;
                                                        let _e2679 = phi_6685_;
                                                        let _e2681 = phi_6686_;
                                                        let _e2683 = phi_6687_;
                                                        let _e2685 = phi_6688_;
                                                        let _e2687 = phi_6689_;
                                                        phi_6690_ = _e2671;
                                                        phi_6691_ = _e2673;
                                                        phi_6692_ = _e2675;
                                                        phi_6693_ = _e2677;
                                                        phi_6694_ = _e2679;
                                                        phi_6695_ = _e2681;
                                                        phi_6696_ = _e2683;
                                                        phi_6697_ = _e2685;
                                                        phi_6698_ = _e2687;
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
                                                    let _e2689 = phi_6690_;
                                                    let _e2691 = phi_6691_;
                                                    let _e2693 = phi_6692_;
                                                    let _e2695 = phi_6693_;
                                                    let _e2697 = phi_6694_;
                                                    let _e2699 = phi_6695_;
                                                    let _e2701 = phi_6696_;
                                                    let _e2703 = phi_6697_;
                                                    let _e2705 = phi_6698_;
                                                    let _e2707 = phi_6699_;
                                                    phi_6700_ = _e2689;
                                                    phi_5789_ = _e2691;
                                                    phi_6701_ = _e2693;
                                                    phi_6702_ = _e2695;
                                                    phi_6703_ = _e2697;
                                                    phi_6704_ = false;
                                                    phi_6705_ = _e2699;
                                                    phi_6706_ = _e2701;
                                                    phi_6707_ = _e2703;
                                                    phi_6708_ = _e2705;
                                                    phi_6709_ = _e2707;
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
                                                let _e2709 = phi_6700_;
                                                let _e2711 = phi_5789_;
                                                let _e2713 = phi_6701_;
                                                let _e2715 = phi_6702_;
                                                let _e2717 = phi_6703_;
                                                let _e2719 = phi_6704_;
                                                let _e2721 = phi_6705_;
                                                let _e2723 = phi_6706_;
                                                let _e2725 = phi_6707_;
                                                let _e2727 = phi_6708_;
                                                let _e2729 = phi_6709_;
                                                local_26 = _e2715;
                                                local_57 = _e2717;
                                                local_58 = _e2719;
                                                local_59 = _e2721;
                                                local_60 = _e2723;
                                                local_61 = _e2725;
                                                local_62 = _e2727;
                                                local_63 = _e2729;
                                                local_64 = _e2709;
                                                local_66 = _e2715;
                                                continue;
                                                continuing {
                                                    phi_5785_ = _e2134;
                                                    phi_5788_ = _e2711;
                                                    break if !(_e2713);
                                                }
                                            }
                                            let _e2732 = local_26;
                                            if _e2732 {
                                                phi_6714_ = type_32(0u, type_32().member_1);
                                                phi_6715_ = false;
                                                phi_6716_ = false;
                                                phi_6717_ = false;
                                                phi_6718_ = false;
                                                phi_6719_ = false;
                                                phi_6720_ = false;
                                                phi_6721_ = false;
                                            } else {
                                                phi_6714_ = type_32();
                                                let _e5029 = local_57;
                                                phi_6715_ = _e5029;
                                                let _e5032 = local_58;
                                                phi_6716_ = _e5032;
                                                let _e5035 = local_59;
                                                phi_6717_ = _e5035;
                                                let _e5038 = local_60;
                                                phi_6718_ = _e5038;
                                                let _e5041 = local_61;
                                                phi_6719_ = _e5041;
                                                let _e5044 = local_62;
                                                phi_6720_ = _e5044;
                                                let _e5047 = local_63;
                                                phi_6721_ = _e5047;
                                            }
                                            let _e2736 = phi_6714_;
                                            let _e2738 = phi_6715_;
                                            let _e2740 = phi_6716_;
                                            let _e2742 = phi_6717_;
                                            let _e2744 = phi_6718_;
                                            let _e2746 = phi_6719_;
                                            let _e2748 = phi_6720_;
                                            let _e2750 = phi_6721_;
                                            if _e2738 {
                                                let _e5050 = local_64;
                                                phi_6725_ = _e5050;
                                                phi_6726_ = true;
                                                phi_6727_ = false;
                                                phi_6728_ = false;
                                                phi_6729_ = false;
                                                phi_6730_ = false;
                                                phi_6731_ = false;
                                                phi_6732_ = false;
                                            } else {
                                                let _e5052 = local_65;
                                                phi_6725_ = _e5052;
                                                phi_6726_ = _e2740;
                                                phi_6727_ = _e2742;
                                                phi_6728_ = _e2744;
                                                phi_6729_ = _e2746;
                                                let _e5059 = local_66;
                                                phi_6730_ = _e5059;
                                                phi_6731_ = _e2748;
                                                phi_6732_ = _e2750;
                                            }
                                            let _e2752 = phi_6725_;
                                            let _e2754 = phi_6726_;
                                            let _e2756 = phi_6727_;
                                            let _e2758 = phi_6728_;
                                            let _e2760 = phi_6729_;
                                            let _e2762 = phi_6730_;
                                            let _e2764 = phi_6731_;
                                            let _e2766 = phi_6732_;
                                            if _e2754 {
                                                phi_6737_ = type_32(1u, _e2752);
                                                phi_6738_ = false;
                                                phi_6739_ = false;
                                                phi_6740_ = false;
                                                phi_6741_ = false;
                                                phi_6742_ = false;
                                                phi_6743_ = false;
                                            } else {
                                                phi_6737_ = type_32();
                                                phi_6738_ = _e2756;
                                                phi_6739_ = _e2758;
                                                phi_6740_ = _e2760;
                                                phi_6741_ = _e2762;
                                                phi_6742_ = _e2764;
                                                phi_6743_ = _e2766;
                                            }
                                            let _e2769 = phi_6737_;
                                            let _e2771 = phi_6738_;
                                            let _e2773 = phi_6739_;
                                            let _e2775 = phi_6740_;
                                            let _e2777 = phi_6741_;
                                            let _e2779 = phi_6742_;
                                            let _e2781 = phi_6743_;
                                            if _e2771 {
                                                let _e2783 = local_27;
                                                phi_6748_ = type_32(1u, _e2783);
                                                phi_6749_ = false;
                                                phi_6750_ = false;
                                                phi_6751_ = true;
                                                phi_6752_ = false;
                                                phi_6753_ = false;
                                            } else {
                                                phi_6748_ = _e2736;
                                                phi_6749_ = _e2773;
                                                phi_6750_ = _e2775;
                                                phi_6751_ = _e2777;
                                                phi_6752_ = _e2779;
                                                phi_6753_ = _e2781;
                                            }
                                            let _e2786 = phi_6748_;
                                            let _e2788 = phi_6749_;
                                            let _e2790 = phi_6750_;
                                            let _e2792 = phi_6751_;
                                            let _e2794 = phi_6752_;
                                            let _e2796 = phi_6753_;
                                            if _e2788 {
                                                let _e2798 = local_28;
                                                phi_6758_ = type_32(1u, _e2798);
                                                phi_6759_ = false;
                                                phi_6760_ = false;
                                                phi_6761_ = false;
                                                phi_6762_ = false;
                                            } else {
                                                phi_6758_ = type_32();
                                                phi_6759_ = _e2790;
                                                phi_6760_ = _e2792;
                                                phi_6761_ = _e2794;
                                                phi_6762_ = _e2796;
                                            }
                                            let _e2801 = phi_6758_;
                                            let _e2803 = phi_6759_;
                                            let _e2805 = phi_6760_;
                                            let _e2807 = phi_6761_;
                                            let _e2809 = phi_6762_;
                                            if _e2803 {
                                                let _e2811 = local_29;
                                                phi_6767_ = type_32(1u, _e2811);
                                                phi_6768_ = true;
                                                phi_6769_ = false;
                                                phi_6770_ = false;
                                                phi_6771_ = false;
                                            } else {
                                                phi_6767_ = _e2801;
                                                phi_6768_ = _e2788;
                                                phi_6769_ = _e2805;
                                                phi_6770_ = _e2807;
                                                phi_6771_ = _e2809;
                                            }
                                            let _e2814 = phi_6767_;
                                            let _e2816 = phi_6768_;
                                            let _e2818 = phi_6769_;
                                            let _e2820 = phi_6770_;
                                            let _e2822 = phi_6771_;
                                            if _e2816 {
                                                phi_6775_ = _e2814;
                                                phi_6776_ = true;
                                                phi_6777_ = false;
                                                phi_6778_ = false;
                                            } else {
                                                phi_6775_ = _e2786;
                                                phi_6776_ = _e2818;
                                                phi_6777_ = _e2820;
                                                phi_6778_ = _e2822;
                                            }
                                            let _e2824 = phi_6775_;
                                            let _e2826 = phi_6776_;
                                            let _e2828 = phi_6777_;
                                            let _e2830 = phi_6778_;
                                            if _e2826 {
                                                phi_6782_ = false;
                                                phi_6783_ = false;
                                            } else {
                                                phi_6782_ = _e2828;
                                                phi_6783_ = _e2830;
                                            }
                                            let _e2832 = phi_6782_;
                                            let _e2834 = phi_6783_;
                                            if _e2832 {
                                                phi_6787_ = false;
                                                phi_6788_ = false;
                                            } else {
                                                phi_6787_ = _e2834;
                                                phi_6788_ = _e2826;
                                            }
                                            let _e2836 = phi_6787_;
                                            let _e2838 = phi_6788_;
                                            if _e2836 {
                                                phi_6792_ = true;
                                                phi_6793_ = false;
                                            } else {
                                                phi_6792_ = _e2832;
                                                phi_6793_ = _e2838;
                                            }
                                            let _e2840 = phi_6792_;
                                            let _e2842 = phi_6793_;
                                            if _e2840 {
                                                let _e2844 = local_30;
                                                phi_6798_ = type_32(1u, _e2844);
                                                phi_6799_ = true;
                                            } else {
                                                phi_6798_ = _e2824;
                                                phi_6799_ = _e2842;
                                            }
                                            let _e2847 = phi_6798_;
                                            let _e2849 = phi_6799_;
                                            if _e2849 {
                                                phi_6803_ = _e2847;
                                            } else {
                                                phi_6803_ = _e2769;
                                            }
                                            let _e2851 = phi_6803_;
                                            let _e2854 = (_e2851.member != 0u);
                                            if _e2854 {
                                                phi_6810_ = false;
                                            } else {
                                                phi_6810_ = true;
                                            }
                                            let _e2856 = phi_6810_;
                                            phi_6811_ = _e2851.member_1;
                                            phi_6812_ = _e2856;
                                            phi_6813_ = _e2854;
                                            phi_6814_ = false;
                                        } else {
                                            phi_6811_ = f32();
                                            phi_6812_ = false;
                                            phi_6813_ = false;
                                            phi_6814_ = true;
                                        }
                                        let _e2858 = phi_6811_;
                                        let _e2860 = phi_6812_;
                                        let _e2862 = phi_6813_;
                                        let _e2864 = phi_6814_;
                                        phi_6815_ = _e2858;
                                        phi_6816_ = _e2860;
                                        phi_6817_ = _e2862;
                                        phi_6818_ = _e2864;
                                    }
                                    let _e2866 = phi_6815_;
                                    let _e2868 = phi_6816_;
                                    let _e2870 = phi_6817_;
                                    let _e2872 = phi_6818_;
                                    phi_6819_ = _e2866;
                                    phi_6820_ = _e1878;
                                    phi_6821_ = _e2868;
                                    phi_6822_ = _e2870;
                                    phi_6823_ = _e2872;
                                }
                                let _e2874 = phi_6819_;
                                let _e2876 = phi_6820_;
                                let _e2878 = phi_6821_;
                                let _e2880 = phi_6822_;
                                let _e2882 = phi_6823_;
                                if _e2876 {
                                    phi_6827_ = true;
                                    phi_6828_ = false;
                                    phi_6829_ = false;
                                } else {
                                    phi_6827_ = _e2878;
                                    phi_6828_ = _e2880;
                                    phi_6829_ = _e2882;
                                }
                                let _e2884 = phi_6827_;
                                let _e2886 = phi_6828_;
                                let _e2888 = phi_6829_;
                                phi_6830_ = _e2874;
                                phi_6831_ = _e1176;
                                phi_6832_ = _e2884;
                                phi_6833_ = false;
                                phi_6834_ = _e2886;
                                phi_6835_ = _e2888;
                            } else {
                                phi_6830_ = f32();
                                phi_6831_ = type_33();
                                phi_6832_ = false;
                                phi_6833_ = true;
                                phi_6834_ = false;
                                phi_6835_ = false;
                            }
                            let _e2890 = phi_6830_;
                            let _e2892 = phi_6831_;
                            let _e2894 = phi_6832_;
                            let _e2896 = phi_6833_;
                            let _e2898 = phi_6834_;
                            let _e2900 = phi_6835_;
                            local_31 = _e2896;
                            local_67 = _e2898;
                            local_68 = _e2900;
                            local_32 = _e2890;
                            local_33 = _e2892;
                            continue;
                            continuing {
                                phi_3872_ = _e881;
                                break if !(_e2894);
                            }
                        }
                        let _e2903 = local_31;
                        if _e2903 {
                            phi_6840_ = type_32(0u, type_32().member_1);
                            phi_6841_ = false;
                            phi_6842_ = false;
                        } else {
                            phi_6840_ = type_32();
                            let _e5129 = local_67;
                            phi_6841_ = _e5129;
                            let _e5132 = local_68;
                            phi_6842_ = _e5132;
                        }
                        let _e2907 = phi_6840_;
                        let _e2909 = phi_6841_;
                        let _e2911 = phi_6842_;
                        if _e2909 {
                            let _e2913 = local_32;
                            phi_6847_ = type_32(2u, _e2913);
                            phi_6848_ = false;
                        } else {
                            phi_6847_ = type_32();
                            phi_6848_ = _e2911;
                        }
                        let _e2916 = phi_6847_;
                        let _e2918 = phi_6848_;
                        if _e2918 {
                            let _e2920 = local_33;
                            phi_6854_ = type_32(1u, _e2920.member);
                            phi_6855_ = true;
                        } else {
                            phi_6854_ = _e2916;
                            phi_6855_ = _e2909;
                        }
                        let _e2924 = phi_6854_;
                        let _e2926 = phi_6855_;
                        if _e2926 {
                            phi_6859_ = _e2924;
                        } else {
                            phi_6859_ = _e2907;
                        }
                        let _e2928 = phi_6859_;
                        phi_6863_ = _e2928;
                    }
                    let _e4482 = phi_6863_;
                    phi_6864_ = _e4482;
                }
                let _e4486 = phi_6864_;
                switch bitcast<i32>(_e4486.member) {
                    case 0: {
                        phi_6877_ = type_34(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4492 = function_(_e4486.member_1);
                        phi_6877_ = type_34(0u, _e4492, true);
                        break;
                    }
                    case 2: {
                        let _e4490 = function_(_e4486.member_1);
                        phi_6877_ = type_34(1u, _e4490, true);
                        break;
                    }
                    default: {
                        phi_6877_ = type_34();
                        break;
                    }
                }
                let _e4495 = phi_6877_;
                if _e4495.member_2 {
                    phi_6884_ = (_e4495.member == 0u);
                } else {
                    phi_6884_ = false;
                }
                let _e4500 = phi_6884_;
                if _e4500 {
                    let _e4508 = (_e4495.member_1[1] >> bitcast<u32>(20i));
                    if (_e4508 <= 896u) {
                        phi_6908_ = 0u;
                    } else {
                        phi_6908_ = ((((_e4508 - 896u) << bitcast<u32>(23i)) | ((_e4495.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4495.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4523 = phi_6908_;
                    let _e4525 = atomicMin((&earliest.member[0u]), _e4523);
                }
                phi_6912_ = type_28(_e166, 0u, _e172, _e175, _e4495.member_1);
                phi_6913_ = _e4500;
                phi_6914_ = (_e4495.member != 0u);
            } else {
                phi_6912_ = type_28(_e166, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_6913_ = false;
                phi_6914_ = false;
            }
            let _e4527 = phi_6912_;
            let _e4529 = phi_6913_;
            let _e4531 = phi_6914_;
            let _e4533 = params.member.member_1;
            if ((_e4533 & 16u) != 0u) {
                if (_e99 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4529 {
                    let _e4539 = atomicAdd((&counters[0u]), 1u);
                    phi_6932_ = _e4539;
                } else {
                    phi_6932_ = 0u;
                }
                let _e4541 = phi_6932_;
                workgroupBarrier();
                if (_e99 == 0u) {
                    let _e4544 = atomicLoad((&counters[0u]));
                    if (_e4544 > 0u) {
                        let _e4547 = atomicAdd((&contacts.member[0u]), _e4544);
                        atomicStore((&counters[1u]), _e4547);
                    }
                }
                workgroupBarrier();
                let _e4550 = atomicLoad((&counters[1u]));
                let _e4551 = (_e4550 + _e4541);
                if _e4529 {
                    let _e4553 = params.member.member_16;
                    if (_e4551 < _e4553) {
                        let _e4555 = (6u * _e4551);
                        atomicStore((&contacts.member[(4u + _e4555)]), _e4527.member);
                        atomicStore((&contacts.member[(_e4555 + 5u)]), _e4527.member_1);
                        atomicStore((&contacts.member[(_e4555 + 6u)]), _e4527.member_2);
                        atomicStore((&contacts.member[(_e4555 + 7u)]), _e4527.member_3);
                        atomicStore((&contacts.member[(_e4555 + 8u)]), _e4527.member_4[0]);
                        atomicStore((&contacts.member[(_e4555 + 9u)]), _e4527.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e99 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e4531 {
                let _e4579 = atomicAdd((&counters[0u]), 1u);
                phi_6994_ = _e4579;
            } else {
                phi_6994_ = 0u;
            }
            let _e4581 = phi_6994_;
            workgroupBarrier();
            if (_e99 == 0u) {
                let _e4584 = atomicLoad((&counters[0u]));
                if (_e4584 > 0u) {
                    let _e4587 = atomicAdd((&undecided.member[0u]), _e4584);
                    atomicStore((&counters[1u]), _e4587);
                }
            }
            workgroupBarrier();
            let _e4590 = atomicLoad((&counters[1u]));
            let _e4591 = (_e4590 + _e4581);
            if _e4531 {
                atomicStore((&undecided.member[(4u + (2u * _e4591))]), _e4527.member_2);
                atomicStore((&undecided.member[((2u * _e4591) + 5u)]), _e4527.member_3);
            }
        }
        continue;
        continuing {
            phi_274_ = _e154;
            break if !(_e160);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_1(id, n, lane);
}
