struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

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
    member_18: array<array<u32, 4>, 8>,
}

struct type_13 {
    member: type_11,
}

struct type_17 {
    member: array<type_6>,
}

struct type_21 {
    member: array<u32>,
}

struct type_23 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_26 {
    member: array<type_23>,
}

struct type_35 {
    member: i32,
    member_1: i32,
}

struct type_36 {
    member: u32,
    member_1: i32,
}

struct type_37 {
    member: u32,
    member_1: u32,
}

struct type_46 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_49 {
    member: array<type_46>,
}

struct type_65 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_72 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_80 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_13;
@group(0) @binding(1) 
var<storage> nodes: type_17;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> sides: array<type_6, 64>;
var<workgroup> names: array<u32, 64>;
var<workgroup> hits: array<u32, 1024>;
@group(0) @binding(2) 
var<storage> leaves: type_26;
@group(0) @binding(3) 
var<storage> bodies: type_21;
@group(0) @binding(4) 
var<storage> keys: type_65;
var<workgroup> kept: array<u32, 1024>;
@group(0) @binding(5) 
var<storage> paths: type_49;
@group(0) @binding(6) 
var<storage> input: type_21;
@group(0) @binding(7) 
var<storage, read_write> output: type_80;

fn function_() {
    var local: array<array<f32, 3>, 4>;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: array<array<f32, 3>, 4>;
    var local_3: array<array<f32, 3>, 4>;
    var local_4: array<type_72, 2>;
    var local_5: array<array<f32, 3>, 4>;
    var local_6: array<array<f32, 3>, 4>;
    var local_7: type_72;
    var local_8: array<array<u32, 2>, 6>;
    var local_9: array<array<u32, 2>, 6>;
    var local_10: array<array<u32, 2>, 6>;
    var local_11: array<array<u32, 2>, 6>;
    var local_12: array<array<u32, 2>, 6>;
    var local_13: array<array<u32, 2>, 6>;
    var local_14: array<array<u32, 2>, 6>;
    var local_15: array<array<u32, 2>, 6>;
    var local_16: type_23;
    var local_17: type_23;
    var phi_225_: u32;
    var phi_252_: u32;
    var phi_253_: u32;
    var phi_260_: u32;
    var phi_281_: u32;
    var phi_282_: u32;
    var phi_285_: type_37;
    var phi_286_: type_37;
    var phi_309_: type_37;
    var phi_361_: array<u32, 2>;
    var phi_369_: u32;
    var phi_370_: u32;
    var phi_375_: u32;
    var phi_376_: u32;
    var phi_494_: u32;
    var phi_525_: bool;
    var phi_530_: type_37;
    var phi_533_: u32;
    var phi_531_: type_37;
    var phi_556_: type_37;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_639_: u32;
    var phi_640_: bool;
    var phi_534_: u32;
    var phi_641_: bool;
    var phi_646_: type_35;
    var phi_649_: u32;
    var phi_670_: bool;
    var phi_676_: type_36;
    var phi_647_: type_35;
    var phi_690_: type_36;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_865_: bool;
    var phi_866_: bool;
    var phi_867_: bool;
    var phi_871_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_833_: bool;
    var phi_872_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_923_: bool;
    var phi_933_: bool;
    var phi_934_: bool;
    var phi_938_: bool;
    var phi_939_: bool;
    var phi_988_: type_37;
    var phi_991_: bool;
    var phi_989_: type_37;
    var phi_1014_: type_37;
    var phi_1071_: type_37;
    var phi_1074_: array<u32, 2>;
    var phi_1072_: type_37;
    var phi_1097_: type_37;
    var phi_1172_: bool;
    var phi_1173_: bool;
    var phi_1177_: array<u32, 2>;
    var phi_1075_: array<u32, 2>;
    var phi_1228_: type_37;
    var phi_1231_: array<u32, 2>;
    var phi_1229_: type_37;
    var phi_1254_: type_37;
    var phi_1330_: bool;
    var phi_1331_: bool;
    var phi_1335_: array<u32, 2>;
    var phi_1232_: array<u32, 2>;
    var local_18: array<u32, 2>;
    var local_19: array<u32, 2>;
    var local_20: array<u32, 2>;
    var local_21: array<u32, 2>;
    var local_22: array<u32, 2>;
    var local_23: array<u32, 2>;
    var phi_1351_: bool;
    var phi_1352_: bool;
    var phi_1403_: type_37;
    var phi_1406_: array<u32, 2>;
    var phi_1404_: type_37;
    var phi_1429_: type_37;
    var phi_1504_: bool;
    var phi_1505_: bool;
    var phi_1509_: array<u32, 2>;
    var phi_1407_: array<u32, 2>;
    var phi_1560_: type_37;
    var phi_1563_: array<u32, 2>;
    var phi_1561_: type_37;
    var phi_1586_: type_37;
    var phi_1662_: bool;
    var phi_1663_: bool;
    var phi_1667_: array<u32, 2>;
    var phi_1564_: array<u32, 2>;
    var local_24: array<u32, 2>;
    var local_25: array<u32, 2>;
    var local_26: array<u32, 2>;
    var local_27: array<u32, 2>;
    var local_28: array<u32, 2>;
    var local_29: array<u32, 2>;
    var phi_1683_: bool;
    var phi_1684_: bool;
    var phi_992_: bool;
    var phi_1688_: bool;
    var phi_1689_: bool;
    var phi_1690_: bool;
    var phi_1694_: bool;
    var phi_1695_: bool;
    var phi_1696_: bool;
    var phi_1697_: bool;
    var phi_1698_: bool;
    var phi_1702_: bool;
    var phi_2100_: f32;
    var phi_2107_: f32;
    var phi_2112_: f32;
    var phi_2119_: f32;
    var phi_2124_: f32;
    var phi_2137_: f32;
    var phi_2144_: f32;
    var phi_2149_: f32;
    var phi_2156_: f32;
    var phi_2161_: f32;
    var phi_2166_: f32;
    var phi_2183_: f32;
    var phi_2190_: f32;
    var phi_2195_: f32;
    var phi_2202_: f32;
    var phi_2207_: f32;
    var phi_2221_: f32;
    var phi_2228_: f32;
    var phi_2233_: f32;
    var phi_2240_: f32;
    var phi_2245_: f32;
    var phi_2250_: f32;
    var phi_2267_: f32;
    var phi_2274_: f32;
    var phi_2279_: f32;
    var phi_2286_: f32;
    var phi_2291_: f32;
    var phi_2305_: f32;
    var phi_2312_: f32;
    var phi_2317_: f32;
    var phi_2324_: f32;
    var phi_2329_: f32;
    var phi_2334_: f32;
    var phi_2365_: f32;
    var phi_2371_: f32;
    var phi_2378_: f32;
    var phi_2385_: f32;
    var phi_2391_: f32;
    var phi_2398_: f32;
    var phi_2404_: f32;
    var phi_2410_: f32;
    var phi_2416_: f32;
    var phi_2423_: f32;
    var phi_2430_: f32;
    var phi_2454_: f32;
    var phi_2459_: f32;
    var phi_2464_: f32;
    var phi_2469_: f32;
    var phi_2474_: f32;
    var phi_2479_: f32;
    var phi_2489_: f32;
    var phi_2740_: f32;
    var phi_2747_: f32;
    var phi_2752_: f32;
    var phi_2759_: f32;
    var phi_2764_: f32;
    var phi_2777_: f32;
    var phi_2784_: f32;
    var phi_2789_: f32;
    var phi_2796_: f32;
    var phi_2801_: f32;
    var phi_2806_: f32;
    var phi_2823_: f32;
    var phi_2830_: f32;
    var phi_2835_: f32;
    var phi_2842_: f32;
    var phi_2847_: f32;
    var phi_2861_: f32;
    var phi_2868_: f32;
    var phi_2873_: f32;
    var phi_2880_: f32;
    var phi_2885_: f32;
    var phi_2890_: f32;
    var phi_2907_: f32;
    var phi_2914_: f32;
    var phi_2919_: f32;
    var phi_2926_: f32;
    var phi_2931_: f32;
    var phi_2945_: f32;
    var phi_2952_: f32;
    var phi_2957_: f32;
    var phi_2964_: f32;
    var phi_2969_: f32;
    var phi_2974_: f32;
    var phi_3012_: type_37;
    var phi_3015_: f32;
    var phi_3017_: f32;
    var phi_3013_: type_37;
    var phi_3040_: type_37;
    var phi_3090_: f32;
    var phi_3095_: f32;
    var phi_3100_: f32;
    var phi_3105_: f32;
    var phi_3016_: f32;
    var phi_3018_: f32;
    var phi_3111_: f32;
    var phi_3117_: f32;
    var phi_3124_: f32;
    var local_30: f32;
    var local_31: f32;
    var phi_3134_: f32;
    var phi_3165_: type_37;
    var phi_3168_: f32;
    var phi_3170_: f32;
    var phi_3166_: type_37;
    var phi_3193_: type_37;
    var phi_3243_: f32;
    var phi_3248_: f32;
    var phi_3253_: f32;
    var phi_3258_: f32;
    var phi_3169_: f32;
    var phi_3171_: f32;
    var phi_3264_: f32;
    var phi_3270_: f32;
    var phi_3277_: f32;
    var local_32: f32;
    var local_33: f32;
    var phi_3287_: f32;
    var phi_3297_: f32;
    var phi_3330_: type_37;
    var phi_3333_: f32;
    var phi_3335_: f32;
    var phi_3331_: type_37;
    var phi_3358_: type_37;
    var phi_3408_: f32;
    var phi_3413_: f32;
    var phi_3418_: f32;
    var phi_3423_: f32;
    var phi_3334_: f32;
    var phi_3336_: f32;
    var phi_3429_: f32;
    var phi_3435_: f32;
    var phi_3442_: f32;
    var local_34: f32;
    var local_35: f32;
    var phi_3452_: f32;
    var phi_3462_: f32;
    var phi_3465_: bool;
    var phi_3922_: f32;
    var phi_3929_: f32;
    var phi_3934_: f32;
    var phi_3941_: f32;
    var phi_3946_: f32;
    var phi_3959_: f32;
    var phi_3966_: f32;
    var phi_3971_: f32;
    var phi_3978_: f32;
    var phi_3983_: f32;
    var phi_3988_: f32;
    var phi_4005_: f32;
    var phi_4012_: f32;
    var phi_4017_: f32;
    var phi_4024_: f32;
    var phi_4029_: f32;
    var phi_4043_: f32;
    var phi_4050_: f32;
    var phi_4055_: f32;
    var phi_4062_: f32;
    var phi_4067_: f32;
    var phi_4072_: f32;
    var phi_4089_: f32;
    var phi_4096_: f32;
    var phi_4101_: f32;
    var phi_4108_: f32;
    var phi_4113_: f32;
    var phi_4127_: f32;
    var phi_4134_: f32;
    var phi_4139_: f32;
    var phi_4146_: f32;
    var phi_4151_: f32;
    var phi_4156_: f32;
    var phi_4187_: f32;
    var phi_4193_: f32;
    var phi_4200_: f32;
    var phi_4207_: f32;
    var phi_4213_: f32;
    var phi_4220_: f32;
    var phi_4226_: f32;
    var phi_4232_: f32;
    var phi_4238_: f32;
    var phi_4245_: f32;
    var phi_4252_: f32;
    var phi_4276_: f32;
    var phi_4281_: f32;
    var phi_4286_: f32;
    var phi_4291_: f32;
    var phi_4296_: f32;
    var phi_4301_: f32;
    var phi_4311_: f32;
    var phi_4562_: f32;
    var phi_4569_: f32;
    var phi_4574_: f32;
    var phi_4581_: f32;
    var phi_4586_: f32;
    var phi_4599_: f32;
    var phi_4606_: f32;
    var phi_4611_: f32;
    var phi_4618_: f32;
    var phi_4623_: f32;
    var phi_4628_: f32;
    var phi_4645_: f32;
    var phi_4652_: f32;
    var phi_4657_: f32;
    var phi_4664_: f32;
    var phi_4669_: f32;
    var phi_4683_: f32;
    var phi_4690_: f32;
    var phi_4695_: f32;
    var phi_4702_: f32;
    var phi_4707_: f32;
    var phi_4712_: f32;
    var phi_4729_: f32;
    var phi_4736_: f32;
    var phi_4741_: f32;
    var phi_4748_: f32;
    var phi_4753_: f32;
    var phi_4767_: f32;
    var phi_4774_: f32;
    var phi_4779_: f32;
    var phi_4786_: f32;
    var phi_4791_: f32;
    var phi_4796_: f32;
    var phi_4834_: type_37;
    var phi_4837_: f32;
    var phi_4839_: f32;
    var phi_4835_: type_37;
    var phi_4862_: type_37;
    var phi_4912_: f32;
    var phi_4917_: f32;
    var phi_4922_: f32;
    var phi_4927_: f32;
    var phi_4838_: f32;
    var phi_4840_: f32;
    var phi_4933_: f32;
    var phi_4939_: f32;
    var phi_4946_: f32;
    var local_36: f32;
    var local_37: f32;
    var phi_4956_: f32;
    var phi_4987_: type_37;
    var phi_4990_: f32;
    var phi_4992_: f32;
    var phi_4988_: type_37;
    var phi_5015_: type_37;
    var phi_5065_: f32;
    var phi_5070_: f32;
    var phi_5075_: f32;
    var phi_5080_: f32;
    var phi_4991_: f32;
    var phi_4993_: f32;
    var phi_5086_: f32;
    var phi_5092_: f32;
    var phi_5099_: f32;
    var local_38: f32;
    var local_39: f32;
    var phi_5109_: f32;
    var phi_5119_: f32;
    var phi_5152_: type_37;
    var phi_5155_: f32;
    var phi_5157_: f32;
    var phi_5153_: type_37;
    var phi_5180_: type_37;
    var phi_5230_: f32;
    var phi_5235_: f32;
    var phi_5240_: f32;
    var phi_5245_: f32;
    var phi_5156_: f32;
    var phi_5158_: f32;
    var phi_5251_: f32;
    var phi_5257_: f32;
    var phi_5264_: f32;
    var local_40: f32;
    var local_41: f32;
    var phi_5274_: f32;
    var phi_5284_: f32;
    var phi_5287_: bool;
    var phi_5533_: f32;
    var phi_5540_: f32;
    var phi_5545_: f32;
    var phi_5552_: f32;
    var phi_5557_: f32;
    var phi_5570_: f32;
    var phi_5577_: f32;
    var phi_5582_: f32;
    var phi_5589_: f32;
    var phi_5594_: f32;
    var phi_5599_: f32;
    var phi_5616_: f32;
    var phi_5623_: f32;
    var phi_5628_: f32;
    var phi_5635_: f32;
    var phi_5640_: f32;
    var phi_5654_: f32;
    var phi_5661_: f32;
    var phi_5666_: f32;
    var phi_5673_: f32;
    var phi_5678_: f32;
    var phi_5683_: f32;
    var phi_5700_: f32;
    var phi_5707_: f32;
    var phi_5712_: f32;
    var phi_5719_: f32;
    var phi_5724_: f32;
    var phi_5738_: f32;
    var phi_5745_: f32;
    var phi_5750_: f32;
    var phi_5757_: f32;
    var phi_5762_: f32;
    var phi_5767_: f32;
    var phi_5798_: f32;
    var phi_5804_: f32;
    var phi_5811_: f32;
    var phi_5818_: f32;
    var phi_5824_: f32;
    var phi_5831_: f32;
    var phi_5837_: f32;
    var phi_5843_: f32;
    var phi_5849_: f32;
    var phi_5856_: f32;
    var phi_5863_: f32;
    var phi_5887_: f32;
    var phi_5892_: f32;
    var phi_5897_: f32;
    var phi_5902_: f32;
    var phi_5907_: f32;
    var phi_5912_: f32;
    var phi_5922_: f32;
    var phi_6173_: f32;
    var phi_6180_: f32;
    var phi_6185_: f32;
    var phi_6192_: f32;
    var phi_6197_: f32;
    var phi_6210_: f32;
    var phi_6217_: f32;
    var phi_6222_: f32;
    var phi_6229_: f32;
    var phi_6234_: f32;
    var phi_6239_: f32;
    var phi_6256_: f32;
    var phi_6263_: f32;
    var phi_6268_: f32;
    var phi_6275_: f32;
    var phi_6280_: f32;
    var phi_6294_: f32;
    var phi_6301_: f32;
    var phi_6306_: f32;
    var phi_6313_: f32;
    var phi_6318_: f32;
    var phi_6323_: f32;
    var phi_6340_: f32;
    var phi_6347_: f32;
    var phi_6352_: f32;
    var phi_6359_: f32;
    var phi_6364_: f32;
    var phi_6378_: f32;
    var phi_6385_: f32;
    var phi_6390_: f32;
    var phi_6397_: f32;
    var phi_6402_: f32;
    var phi_6407_: f32;
    var phi_6445_: type_37;
    var phi_6448_: f32;
    var phi_6450_: f32;
    var phi_6446_: type_37;
    var phi_6473_: type_37;
    var phi_6523_: f32;
    var phi_6528_: f32;
    var phi_6533_: f32;
    var phi_6538_: f32;
    var phi_6449_: f32;
    var phi_6451_: f32;
    var phi_6544_: f32;
    var phi_6550_: f32;
    var phi_6557_: f32;
    var local_42: f32;
    var local_43: f32;
    var phi_6567_: f32;
    var phi_6598_: type_37;
    var phi_6601_: f32;
    var phi_6603_: f32;
    var phi_6599_: type_37;
    var phi_6626_: type_37;
    var phi_6676_: f32;
    var phi_6681_: f32;
    var phi_6686_: f32;
    var phi_6691_: f32;
    var phi_6602_: f32;
    var phi_6604_: f32;
    var phi_6697_: f32;
    var phi_6703_: f32;
    var phi_6710_: f32;
    var local_44: f32;
    var local_45: f32;
    var phi_6720_: f32;
    var phi_6730_: f32;
    var phi_6763_: type_37;
    var phi_6766_: f32;
    var phi_6768_: f32;
    var phi_6764_: type_37;
    var phi_6791_: type_37;
    var phi_6841_: f32;
    var phi_6846_: f32;
    var phi_6851_: f32;
    var phi_6856_: f32;
    var phi_6767_: f32;
    var phi_6769_: f32;
    var phi_6862_: f32;
    var phi_6868_: f32;
    var phi_6875_: f32;
    var local_46: f32;
    var local_47: f32;
    var phi_6885_: f32;
    var phi_6895_: f32;
    var phi_6898_: bool;
    var phi_6899_: bool;
    var phi_6901_: bool;
    var phi_6909_: u32;
    var phi_6910_: bool;
    var phi_650_: u32;
    var phi_6911_: bool;
    var phi_6941_: type_35;
    var phi_6944_: u32;
    var phi_6965_: bool;
    var phi_6971_: type_36;
    var phi_6942_: type_35;
    var phi_6985_: type_36;
    var phi_7091_: u32;
    var phi_7092_: bool;
    var phi_6945_: u32;
    var phi_7093_: bool;
    var local_48: bool;
    var local_49: f32;
    var local_50: f32;
    var local_51: f32;
    var local_52: f32;
    var local_53: f32;
    var local_54: f32;
    var local_55: f32;
    var local_56: f32;
    var local_57: f32;

    let _e91 = id_1;
    let _e92 = n_1;
    let _e93 = lane_1;
    let _e106 = ((_e91.y * _e92.x) + _e91.x);
    let _e109 = (_e92.x * _e92.y);
    let _e111 = params.member.member_15;
    let _e113 = input.member[0u];
    if (_e111 < _e113) {
        phi_225_ = _e111;
    } else {
        phi_225_ = _e113;
    }
    let _e116 = phi_225_;
    let _e118 = params.member.member_12;
    if (_e116 > _e118) {
        let _e121 = params.member.member_12;
        let _e122 = (_e116 - _e121);
        let _e124 = params.member.member_13;
        if (_e124 == 0u) {
            return;
        }
        let _e126 = (_e122 / _e124);
        if (_e124 == 0u) {
            return;
        }
        if ((_e122 % _e124) > 0u) {
            phi_252_ = (_e126 + 1u);
        } else {
            phi_252_ = _e126;
        }
        let _e132 = phi_252_;
        phi_253_ = _e132;
    } else {
        phi_253_ = 0u;
    }
    let _e134 = phi_253_;
    let _e136 = params.member.member_14;
    if (_e136 < _e134) {
        phi_260_ = _e136;
    } else {
        phi_260_ = _e134;
    }
    let _e139 = phi_260_;
    if (_e139 > _e106) {
        let _e141 = (_e139 - _e106);
        if (_e109 == 0u) {
            return;
        }
        let _e143 = (_e141 / _e109);
        if (_e109 == 0u) {
            return;
        }
        if ((_e141 % _e109) > 0u) {
            phi_281_ = (_e143 + 1u);
        } else {
            phi_281_ = _e143;
        }
        let _e149 = phi_281_;
        phi_282_ = _e149;
    } else {
        phi_282_ = 0u;
    }
    let _e151 = phi_282_;
    phi_285_ = type_37(0u, _e151);
    loop {
        let _e154 = phi_285_;
        if (_e154.member < _e154.member_1) {
            phi_286_ = type_37((_e154.member + 1u), _e154.member_1);
            phi_309_ = type_37(1u, _e154.member);
        } else {
            phi_286_ = _e154;
            phi_309_ = type_37(0u, type_37().member_1);
        }
        let _e168 = phi_286_;
        let _e170 = phi_309_;
        let _e174 = (bitcast<i32>(_e170.member) != 0i);
        if _e174 {
            let _e176 = params.member.member_12;
            let _e180 = params.member.member_13;
            let _e183 = (2u * (_e176 + ((_e106 + (_e170.member_1 * _e109)) * _e180)));
            let _e186 = input.member[(4u + _e183)];
            let _e189 = input.member[(_e183 + 5u)];
            if (_e93 < 8u) {
                atomicStore((&counters[_e93]), 0u);
            }
            workgroupBarrier();
            let _e193 = params.member.member_8;
            if (_e193 == 0u) {
                phi_361_ = array<u32, 2>(0u, 2u);
            } else {
                phi_361_ = array<u32, 2>(1u, 1u);
            }
            let _e196 = phi_361_;
            let _e199 = (_e93 / 32u);
            if (_e199 == 0u) {
                phi_369_ = _e196[0];
                phi_370_ = _e186;
            } else {
                phi_369_ = _e196[1];
                phi_370_ = _e189;
            }
            let _e202 = phi_369_;
            let _e204 = phi_370_;
            if (_e199 == 0u) {
                phi_375_ = _e189;
                phi_376_ = _e196[1];
            } else {
                phi_375_ = _e186;
                phi_376_ = _e196[0];
            }
            let _e207 = phi_375_;
            let _e209 = phi_376_;
            let _e211 = params.member.member_9;
            let _e212 = (_e211 - 1u);
            if (_e212 < 8u) {
            } else {
                return;
            }
            if (_e202 < 4u) {
            } else {
                return;
            }
            let _e221 = params.member.member_18[_e212][_e202];
            let _e224 = nodes.member[(_e221 + ((_e204 * 32u) + (_e93 % 32u)))];
            let _e226 = params.member.member_9;
            if (_e226 < 8u) {
            } else {
                return;
            }
            if (_e209 < 4u) {
            } else {
                return;
            }
            let _e232 = params.member.member_18[_e226][_e209];
            let _e235 = nodes.member[(_e232 + _e207)];
            if ((((((_e224.member[0] <= _e235.member_1[0]) && (_e235.member[0] <= _e224.member_1[0])) && (_e224.member[1] <= _e235.member_1[1])) && (_e235.member[1] <= _e224.member_1[1])) && (_e224.member[2] <= _e235.member_1[2])) && (_e235.member[2] <= _e224.member_1[2])) {
                let _e273 = atomicAdd((&counters[_e199]), 1u);
                let _e274 = ((_e199 * 32u) + _e273);
                sides[_e274] = type_6(array<f32, 3>(_e224.member[0], _e224.member[1], _e224.member[2]), array<f32, 3>(_e224.member_1[0], _e224.member_1[1], _e224.member_1[2]));
                names[_e274] = (_e93 % 32u);
            }
            workgroupBarrier();
            let _e290 = atomicLoad((&counters[0u]));
            let _e292 = atomicLoad((&counters[1u]));
            if (_e290 <= 1u) {
                phi_494_ = 0u;
            } else {
                let _e294 = (_e290 - 1u);
                phi_494_ = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e294)), 32u, (_e294 == 0u)));
            }
            let _e302 = phi_494_;
            let _e307 = (_e93 & ((1u << bitcast<u32>((_e302 & 31u))) - 1u));
            if (_e307 < _e290) {
                let _e310 = sides[_e307];
                let _e320 = names[_e307];
                let _e322 = params.member.member_8;
                if (_e322 == 1u) {
                    phi_525_ = (_e186 == _e189);
                } else {
                    phi_525_ = false;
                }
                let _e326 = phi_525_;
                phi_530_ = type_37(0u, 32u);
                phi_533_ = (_e93 >> bitcast<u32>((_e302 & 31u)));
                loop {
                    let _e331 = phi_530_;
                    let _e333 = phi_533_;
                    if (_e331.member < _e331.member_1) {
                        phi_531_ = type_37((_e331.member + 1u), _e331.member_1);
                        phi_556_ = type_37(1u, _e331.member);
                    } else {
                        phi_531_ = _e331;
                        phi_556_ = type_37(0u, type_37().member_1);
                    }
                    let _e347 = phi_531_;
                    let _e349 = phi_556_;
                    if (bitcast<i32>(_e349.member) != 0i) {
                        if (_e333 >= _e292) {
                            phi_639_ = u32();
                            phi_640_ = false;
                        } else {
                            let _e356 = sides[(32u + _e333)];
                            if ((((((_e310.member[0] <= _e356.member_1[0]) && (_e356.member[0] <= _e310.member_1[0])) && (_e310.member[1] <= _e356.member_1[1])) && (_e356.member[1] <= _e310.member_1[1])) && (_e310.member[2] <= _e356.member_1[2])) && (_e356.member[2] <= _e310.member_1[2])) {
                                let _e378 = names[(32u + _e333)];
                                if _e326 {
                                    if (_e320 < _e378) {
                                        phi_626_ = true;
                                    } else {
                                        phi_626_ = false;
                                    }
                                    let _e381 = phi_626_;
                                    phi_627_ = _e381;
                                } else {
                                    phi_627_ = true;
                                }
                                let _e383 = phi_627_;
                                if _e383 {
                                    let _e385 = atomicAdd((&counters[2u]), 1u);
                                    hits[_e385] = ((_e320 << bitcast<u32>(5i)) | _e378);
                                }
                            }
                            phi_639_ = (_e333 + (64u >> bitcast<u32>((_e302 & 31u))));
                            phi_640_ = true;
                        }
                        let _e395 = phi_639_;
                        let _e397 = phi_640_;
                        phi_534_ = _e395;
                        phi_641_ = _e397;
                    } else {
                        phi_534_ = u32();
                        phi_641_ = false;
                    }
                    let _e399 = phi_534_;
                    let _e401 = phi_641_;
                    continue;
                    continuing {
                        phi_530_ = _e347;
                        phi_533_ = _e399;
                        break if !(_e401);
                    }
                }
            }
            workgroupBarrier();
            let _e404 = atomicLoad((&counters[2u]));
            phi_646_ = type_35(0i, 16i);
            phi_649_ = _e93;
            loop {
                let _e406 = phi_646_;
                let _e408 = phi_649_;
                if (_e406.member < _e406.member_1) {
                    let _e416 = (_e406.member + 1i);
                    if ((false == (_e416 > _e406.member)) != false) {
                        phi_670_ = true;
                    } else {
                        phi_670_ = false;
                    }
                    let _e421 = phi_670_;
                    if _e421 {
                        phi_676_ = type_36(0u, type_36().member_1);
                    } else {
                        phi_676_ = type_36(1u, _e416);
                    }
                    let _e427 = phi_676_;
                    if (bitcast<i32>(_e427.member) != 0i) {
                    } else {
                        return;
                    }
                    phi_647_ = type_35(_e427.member_1, _e406.member_1);
                    phi_690_ = type_36(1u, _e406.member);
                } else {
                    phi_647_ = _e406;
                    phi_690_ = type_36(0u, type_36().member_1);
                }
                let _e437 = phi_647_;
                let _e439 = phi_690_;
                if (bitcast<i32>(_e439.member) != 0i) {
                    if (_e408 >= _e404) {
                        phi_6909_ = u32();
                        phi_6910_ = false;
                    } else {
                        let _e445 = hits[_e408];
                        let _e454 = params.member.member_18[0u][0u];
                        let _e455 = (_e454 + ((_e186 * 32u) + (_e445 >> bitcast<u32>(5i))));
                        let _e461 = params.member.member_18[0u][2u];
                        let _e462 = (_e461 + ((_e189 * 32u) + (_e445 & 31u)));
                        let _e464 = leaves.member[_e455];
                        let _e466 = leaves.member[_e462];
                        local_16 = type_23(array<u32, 3>(_e464.member[0], _e464.member[1], _e464.member[2]), _e464.member_1);
                        local_17 = type_23(array<u32, 3>(_e466.member[0], _e466.member[1], _e466.member[2]), _e466.member_1);
                        let _e482 = nodes.member[_e455];
                        let _e484 = nodes.member[_e462];
                        let _e486 = params.member.member_1;
                        if ((_e486 & 1u) != 0u) {
                            let _e490 = params.member.member_8;
                            if (_e490 == 0u) {
                                let _e534 = local_16.member[0u];
                                let _e537 = local_17.member[0u];
                                if (_e534 == _e537) {
                                    phi_828_ = bool();
                                    phi_829_ = true;
                                } else {
                                    let _e541 = local_16.member[0u];
                                    let _e544 = local_17.member[1u];
                                    let _e545 = (_e541 == _e544);
                                    if _e545 {
                                        phi_827_ = bool();
                                    } else {
                                        let _e548 = local_16.member[0u];
                                        let _e551 = local_17.member[2u];
                                        phi_827_ = (_e548 == _e551);
                                    }
                                    let _e554 = phi_827_;
                                    phi_828_ = _e554;
                                    phi_829_ = _e545;
                                }
                                let _e556 = phi_828_;
                                let _e558 = phi_829_;
                                if _e558 {
                                    phi_833_ = true;
                                } else {
                                    phi_833_ = _e556;
                                }
                                let _e560 = phi_833_;
                                phi_872_ = _e560;
                            } else {
                                let _e494 = local_16.member[0u];
                                let _e497 = local_17.member[0u];
                                if (_e494 == _e497) {
                                    phi_866_ = bool();
                                    phi_867_ = true;
                                } else {
                                    let _e501 = local_16.member[0u];
                                    let _e504 = local_17.member[1u];
                                    if (_e501 == _e504) {
                                        phi_864_ = bool();
                                        phi_865_ = true;
                                    } else {
                                        let _e508 = local_16.member[1u];
                                        let _e511 = local_17.member[0u];
                                        let _e512 = (_e508 == _e511);
                                        if _e512 {
                                            phi_863_ = bool();
                                        } else {
                                            let _e515 = local_16.member[1u];
                                            let _e518 = local_17.member[1u];
                                            phi_863_ = (_e515 == _e518);
                                        }
                                        let _e521 = phi_863_;
                                        phi_864_ = _e521;
                                        phi_865_ = _e512;
                                    }
                                    let _e523 = phi_864_;
                                    let _e525 = phi_865_;
                                    phi_866_ = _e523;
                                    phi_867_ = _e525;
                                }
                                let _e527 = phi_866_;
                                let _e529 = phi_867_;
                                if _e529 {
                                    phi_871_ = true;
                                } else {
                                    phi_871_ = _e527;
                                }
                                let _e531 = phi_871_;
                                phi_872_ = _e531;
                            }
                            let _e562 = phi_872_;
                            if _e562 {
                                phi_876_ = false;
                            } else {
                                phi_876_ = true;
                            }
                            let _e564 = phi_876_;
                            phi_877_ = _e564;
                        } else {
                            phi_877_ = true;
                        }
                        let _e566 = phi_877_;
                        if _e566 {
                            let _e568 = params.member.member_1;
                            if ((_e568 & 2u) != 0u) {
                                let _e573 = local_16.member[0u];
                                let _e575 = bodies.member[_e573];
                                let _e578 = local_17.member[0u];
                                let _e580 = bodies.member[_e578];
                                if ((_e575 / 2u) == (_e580 / 2u)) {
                                    let _e585 = params.member.member_1;
                                    phi_923_ = !(((_e585 & 4u) != 0u));
                                } else {
                                    phi_923_ = false;
                                }
                                let _e590 = phi_923_;
                                if _e590 {
                                    phi_934_ = true;
                                } else {
                                    if (((_e575 & _e580) & 1u) == 0u) {
                                        phi_933_ = false;
                                    } else {
                                        phi_933_ = true;
                                    }
                                    let _e595 = phi_933_;
                                    phi_934_ = _e595;
                                }
                                let _e597 = phi_934_;
                                if _e597 {
                                    phi_938_ = false;
                                } else {
                                    phi_938_ = true;
                                }
                                let _e599 = phi_938_;
                                phi_939_ = _e599;
                            } else {
                                phi_939_ = true;
                            }
                            let _e601 = phi_939_;
                            if _e601 {
                                let _e603 = params.member.member_1;
                                if ((_e603 & 32u) != 0u) {
                                    let _e607 = params.member.member_6;
                                    let _e648 = (((((((_e482.member_1[0] - _e484.member[0]) > _e607) && ((_e484.member_1[0] - _e482.member[0]) > _e607)) && ((_e482.member_1[1] - _e484.member[1]) > _e607)) && ((_e484.member_1[1] - _e482.member[1]) > _e607)) && ((_e482.member_1[2] - _e484.member[2]) > _e607)) && ((_e484.member_1[2] - _e482.member[2]) > _e607));
                                    if _e648 {
                                        phi_1688_ = bool();
                                    } else {
                                        phi_988_ = type_37(0u, 3u);
                                        phi_991_ = true;
                                        loop {
                                            let _e652 = phi_988_;
                                            let _e654 = phi_991_;
                                            local_48 = _e654;
                                            if (_e652.member < _e652.member_1) {
                                                phi_989_ = type_37((_e652.member + 1u), _e652.member_1);
                                                phi_1014_ = type_37(1u, _e652.member);
                                            } else {
                                                phi_989_ = _e652;
                                                phi_1014_ = type_37(0u, type_37().member_1);
                                            }
                                            let _e668 = phi_989_;
                                            let _e670 = phi_1014_;
                                            let _e674 = (bitcast<i32>(_e670.member) != 0i);
                                            if _e674 {
                                                let _e676 = local_16.member[0u];
                                                let _e678 = keys.member[_e676];
                                                local_14 = array<array<u32, 2>, 6>(array<u32, 2>(_e678[0][0], _e678[0][1]), array<u32, 2>(_e678[1][0], _e678[1][1]), array<u32, 2>(_e678[2][0], _e678[2][1]), array<u32, 2>(_e678[3][0], _e678[3][1]), array<u32, 2>(_e678[4][0], _e678[4][1]), array<u32, 2>(_e678[5][0], _e678[5][1]));
                                                if (_e670.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e706 = local_14[_e670.member_1];
                                                phi_1071_ = type_37(1u, 3u);
                                                phi_1074_ = array<u32, 2>(_e706[0], _e706[1]);
                                                loop {
                                                    let _e711 = phi_1071_;
                                                    let _e713 = phi_1074_;
                                                    local_18 = _e713;
                                                    local_20 = _e713;
                                                    local_22 = _e713;
                                                    if (_e711.member < _e711.member_1) {
                                                        phi_1072_ = type_37((_e711.member + 1u), _e711.member_1);
                                                        phi_1097_ = type_37(1u, _e711.member);
                                                    } else {
                                                        phi_1072_ = _e711;
                                                        phi_1097_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e727 = phi_1072_;
                                                    let _e729 = phi_1097_;
                                                    let _e733 = (bitcast<i32>(_e729.member) != 0i);
                                                    if _e733 {
                                                        if (_e729.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e736 = local_16.member[_e729.member_1];
                                                        let _e738 = keys.member[_e736];
                                                        local_15 = array<array<u32, 2>, 6>(array<u32, 2>(_e738[0][0], _e738[0][1]), array<u32, 2>(_e738[1][0], _e738[1][1]), array<u32, 2>(_e738[2][0], _e738[2][1]), array<u32, 2>(_e738[3][0], _e738[3][1]), array<u32, 2>(_e738[4][0], _e738[4][1]), array<u32, 2>(_e738[5][0], _e738[5][1]));
                                                        if (_e670.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e766 = local_15[_e670.member_1];
                                                        if (_e713[1] > _e766[1]) {
                                                            phi_1173_ = true;
                                                        } else {
                                                            if (_e713[1] == _e766[1]) {
                                                                phi_1172_ = (_e713[0] > _e766[0]);
                                                            } else {
                                                                phi_1172_ = false;
                                                            }
                                                            let _e777 = phi_1172_;
                                                            phi_1173_ = _e777;
                                                        }
                                                        let _e779 = phi_1173_;
                                                        if _e779 {
                                                            phi_1177_ = array<u32, 2>(_e766[0], _e766[1]);
                                                        } else {
                                                            phi_1177_ = _e713;
                                                        }
                                                        let _e781 = phi_1177_;
                                                        phi_1075_ = _e781;
                                                    } else {
                                                        phi_1075_ = array<u32, 2>();
                                                    }
                                                    let _e783 = phi_1075_;
                                                    continue;
                                                    continuing {
                                                        phi_1071_ = _e727;
                                                        phi_1074_ = _e783;
                                                        break if !(_e733);
                                                    }
                                                }
                                                let _e786 = local_17.member[0u];
                                                let _e788 = keys.member[_e786];
                                                local_12 = array<array<u32, 2>, 6>(array<u32, 2>(_e788[0][0], _e788[0][1]), array<u32, 2>(_e788[1][0], _e788[1][1]), array<u32, 2>(_e788[2][0], _e788[2][1]), array<u32, 2>(_e788[3][0], _e788[3][1]), array<u32, 2>(_e788[4][0], _e788[4][1]), array<u32, 2>(_e788[5][0], _e788[5][1]));
                                                let _e814 = (3u + _e670.member_1);
                                                if (_e814 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e817 = local_12[_e814];
                                                phi_1228_ = type_37(1u, 3u);
                                                phi_1231_ = array<u32, 2>(_e817[0], _e817[1]);
                                                loop {
                                                    let _e822 = phi_1228_;
                                                    let _e824 = phi_1231_;
                                                    local_19 = _e824;
                                                    local_21 = _e824;
                                                    local_23 = _e824;
                                                    if (_e822.member < _e822.member_1) {
                                                        phi_1229_ = type_37((_e822.member + 1u), _e822.member_1);
                                                        phi_1254_ = type_37(1u, _e822.member);
                                                    } else {
                                                        phi_1229_ = _e822;
                                                        phi_1254_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e838 = phi_1229_;
                                                    let _e840 = phi_1254_;
                                                    let _e844 = (bitcast<i32>(_e840.member) != 0i);
                                                    if _e844 {
                                                        if (_e840.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e847 = local_17.member[_e840.member_1];
                                                        let _e849 = keys.member[_e847];
                                                        local_13 = array<array<u32, 2>, 6>(array<u32, 2>(_e849[0][0], _e849[0][1]), array<u32, 2>(_e849[1][0], _e849[1][1]), array<u32, 2>(_e849[2][0], _e849[2][1]), array<u32, 2>(_e849[3][0], _e849[3][1]), array<u32, 2>(_e849[4][0], _e849[4][1]), array<u32, 2>(_e849[5][0], _e849[5][1]));
                                                        let _e875 = (3u + _e670.member_1);
                                                        if (_e875 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e878 = local_13[_e875];
                                                        if (_e878[1] > _e824[1]) {
                                                            phi_1331_ = true;
                                                        } else {
                                                            if (_e878[1] == _e824[1]) {
                                                                phi_1330_ = (_e878[0] > _e824[0]);
                                                            } else {
                                                                phi_1330_ = false;
                                                            }
                                                            let _e889 = phi_1330_;
                                                            phi_1331_ = _e889;
                                                        }
                                                        let _e891 = phi_1331_;
                                                        if _e891 {
                                                            phi_1335_ = array<u32, 2>(_e878[0], _e878[1]);
                                                        } else {
                                                            phi_1335_ = _e824;
                                                        }
                                                        let _e893 = phi_1335_;
                                                        phi_1232_ = _e893;
                                                    } else {
                                                        phi_1232_ = array<u32, 2>();
                                                    }
                                                    let _e895 = phi_1232_;
                                                    continue;
                                                    continuing {
                                                        phi_1228_ = _e838;
                                                        phi_1231_ = _e895;
                                                        break if !(_e844);
                                                    }
                                                }
                                                let _e898 = local_18;
                                                let _e901 = local_19;
                                                if (_e898[1] > _e901[1]) {
                                                    phi_1352_ = true;
                                                } else {
                                                    let _e905 = local_20;
                                                    let _e908 = local_21;
                                                    if (_e905[1] == _e908[1]) {
                                                        let _e912 = local_22;
                                                        let _e915 = local_23;
                                                        phi_1351_ = (_e912[0] > _e915[0]);
                                                    } else {
                                                        phi_1351_ = false;
                                                    }
                                                    let _e919 = phi_1351_;
                                                    phi_1352_ = _e919;
                                                }
                                                let _e921 = phi_1352_;
                                                let _e924 = local_17.member[0u];
                                                let _e926 = keys.member[_e924];
                                                local_10 = array<array<u32, 2>, 6>(array<u32, 2>(_e926[0][0], _e926[0][1]), array<u32, 2>(_e926[1][0], _e926[1][1]), array<u32, 2>(_e926[2][0], _e926[2][1]), array<u32, 2>(_e926[3][0], _e926[3][1]), array<u32, 2>(_e926[4][0], _e926[4][1]), array<u32, 2>(_e926[5][0], _e926[5][1]));
                                                if (_e670.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e954 = local_10[_e670.member_1];
                                                phi_1403_ = type_37(1u, 3u);
                                                phi_1406_ = array<u32, 2>(_e954[0], _e954[1]);
                                                loop {
                                                    let _e959 = phi_1403_;
                                                    let _e961 = phi_1406_;
                                                    local_24 = _e961;
                                                    local_26 = _e961;
                                                    local_28 = _e961;
                                                    if (_e959.member < _e959.member_1) {
                                                        phi_1404_ = type_37((_e959.member + 1u), _e959.member_1);
                                                        phi_1429_ = type_37(1u, _e959.member);
                                                    } else {
                                                        phi_1404_ = _e959;
                                                        phi_1429_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e975 = phi_1404_;
                                                    let _e977 = phi_1429_;
                                                    let _e981 = (bitcast<i32>(_e977.member) != 0i);
                                                    if _e981 {
                                                        if (_e977.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e984 = local_17.member[_e977.member_1];
                                                        let _e986 = keys.member[_e984];
                                                        local_11 = array<array<u32, 2>, 6>(array<u32, 2>(_e986[0][0], _e986[0][1]), array<u32, 2>(_e986[1][0], _e986[1][1]), array<u32, 2>(_e986[2][0], _e986[2][1]), array<u32, 2>(_e986[3][0], _e986[3][1]), array<u32, 2>(_e986[4][0], _e986[4][1]), array<u32, 2>(_e986[5][0], _e986[5][1]));
                                                        if (_e670.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1014 = local_11[_e670.member_1];
                                                        if (_e961[1] > _e1014[1]) {
                                                            phi_1505_ = true;
                                                        } else {
                                                            if (_e961[1] == _e1014[1]) {
                                                                phi_1504_ = (_e961[0] > _e1014[0]);
                                                            } else {
                                                                phi_1504_ = false;
                                                            }
                                                            let _e1025 = phi_1504_;
                                                            phi_1505_ = _e1025;
                                                        }
                                                        let _e1027 = phi_1505_;
                                                        if _e1027 {
                                                            phi_1509_ = array<u32, 2>(_e1014[0], _e1014[1]);
                                                        } else {
                                                            phi_1509_ = _e961;
                                                        }
                                                        let _e1029 = phi_1509_;
                                                        phi_1407_ = _e1029;
                                                    } else {
                                                        phi_1407_ = array<u32, 2>();
                                                    }
                                                    let _e1031 = phi_1407_;
                                                    continue;
                                                    continuing {
                                                        phi_1403_ = _e975;
                                                        phi_1406_ = _e1031;
                                                        break if !(_e981);
                                                    }
                                                }
                                                let _e1034 = local_16.member[0u];
                                                let _e1036 = keys.member[_e1034];
                                                local_8 = array<array<u32, 2>, 6>(array<u32, 2>(_e1036[0][0], _e1036[0][1]), array<u32, 2>(_e1036[1][0], _e1036[1][1]), array<u32, 2>(_e1036[2][0], _e1036[2][1]), array<u32, 2>(_e1036[3][0], _e1036[3][1]), array<u32, 2>(_e1036[4][0], _e1036[4][1]), array<u32, 2>(_e1036[5][0], _e1036[5][1]));
                                                let _e1062 = (3u + _e670.member_1);
                                                if (_e1062 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1065 = local_8[_e1062];
                                                phi_1560_ = type_37(1u, 3u);
                                                phi_1563_ = array<u32, 2>(_e1065[0], _e1065[1]);
                                                loop {
                                                    let _e1070 = phi_1560_;
                                                    let _e1072 = phi_1563_;
                                                    local_25 = _e1072;
                                                    local_27 = _e1072;
                                                    local_29 = _e1072;
                                                    if (_e1070.member < _e1070.member_1) {
                                                        phi_1561_ = type_37((_e1070.member + 1u), _e1070.member_1);
                                                        phi_1586_ = type_37(1u, _e1070.member);
                                                    } else {
                                                        phi_1561_ = _e1070;
                                                        phi_1586_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e1086 = phi_1561_;
                                                    let _e1088 = phi_1586_;
                                                    let _e1092 = (bitcast<i32>(_e1088.member) != 0i);
                                                    if _e1092 {
                                                        if (_e1088.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1095 = local_16.member[_e1088.member_1];
                                                        let _e1097 = keys.member[_e1095];
                                                        local_9 = array<array<u32, 2>, 6>(array<u32, 2>(_e1097[0][0], _e1097[0][1]), array<u32, 2>(_e1097[1][0], _e1097[1][1]), array<u32, 2>(_e1097[2][0], _e1097[2][1]), array<u32, 2>(_e1097[3][0], _e1097[3][1]), array<u32, 2>(_e1097[4][0], _e1097[4][1]), array<u32, 2>(_e1097[5][0], _e1097[5][1]));
                                                        let _e1123 = (3u + _e670.member_1);
                                                        if (_e1123 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1126 = local_9[_e1123];
                                                        if (_e1126[1] > _e1072[1]) {
                                                            phi_1663_ = true;
                                                        } else {
                                                            if (_e1126[1] == _e1072[1]) {
                                                                phi_1662_ = (_e1126[0] > _e1072[0]);
                                                            } else {
                                                                phi_1662_ = false;
                                                            }
                                                            let _e1137 = phi_1662_;
                                                            phi_1663_ = _e1137;
                                                        }
                                                        let _e1139 = phi_1663_;
                                                        if _e1139 {
                                                            phi_1667_ = array<u32, 2>(_e1126[0], _e1126[1]);
                                                        } else {
                                                            phi_1667_ = _e1072;
                                                        }
                                                        let _e1141 = phi_1667_;
                                                        phi_1564_ = _e1141;
                                                    } else {
                                                        phi_1564_ = array<u32, 2>();
                                                    }
                                                    let _e1143 = phi_1564_;
                                                    continue;
                                                    continuing {
                                                        phi_1560_ = _e1086;
                                                        phi_1563_ = _e1143;
                                                        break if !(_e1092);
                                                    }
                                                }
                                                let _e1146 = local_24;
                                                let _e1149 = local_25;
                                                if (_e1146[1] > _e1149[1]) {
                                                    phi_1684_ = true;
                                                } else {
                                                    let _e1153 = local_26;
                                                    let _e1156 = local_27;
                                                    if (_e1153[1] == _e1156[1]) {
                                                        let _e1160 = local_28;
                                                        let _e1163 = local_29;
                                                        phi_1683_ = (_e1160[0] > _e1163[0]);
                                                    } else {
                                                        phi_1683_ = false;
                                                    }
                                                    let _e1167 = phi_1683_;
                                                    phi_1684_ = _e1167;
                                                }
                                                let _e1169 = phi_1684_;
                                                phi_992_ = (_e654 && (!(_e921) && !(_e1169)));
                                            } else {
                                                phi_992_ = bool();
                                            }
                                            let _e1174 = phi_992_;
                                            continue;
                                            continuing {
                                                phi_988_ = _e668;
                                                phi_991_ = _e1174;
                                                break if !(_e674);
                                            }
                                        }
                                        let _e4757 = local_48;
                                        phi_1688_ = _e4757;
                                    }
                                    let _e1177 = phi_1688_;
                                    phi_1689_ = _e1177;
                                    phi_1690_ = _e648;
                                } else {
                                    phi_1689_ = bool();
                                    phi_1690_ = true;
                                }
                                let _e1179 = phi_1689_;
                                let _e1181 = phi_1690_;
                                if _e1181 {
                                    phi_1694_ = false;
                                } else {
                                    phi_1694_ = true;
                                }
                                let _e1183 = phi_1694_;
                                phi_1695_ = _e1179;
                                phi_1696_ = _e1183;
                            } else {
                                phi_1695_ = false;
                                phi_1696_ = true;
                            }
                            let _e1185 = phi_1695_;
                            let _e1187 = phi_1696_;
                            phi_1697_ = _e1185;
                            phi_1698_ = _e1187;
                        } else {
                            phi_1697_ = false;
                            phi_1698_ = true;
                        }
                        let _e1189 = phi_1697_;
                        let _e1191 = phi_1698_;
                        if _e1191 {
                            phi_1702_ = _e1189;
                        } else {
                            phi_1702_ = true;
                        }
                        let _e1193 = phi_1702_;
                        if _e1193 {
                            let _e1195 = atomicAdd((&counters[5u]), 1u);
                            let _e1197 = params.member.member_4;
                            let _e1199 = params.member.member_5;
                            let _e1202 = local_16.member[0u];
                            let _e1205 = local_17.member[0u];
                            let _e1208 = local_17.member[1u];
                            let _e1211 = local_17.member[2u];
                            let _e1213 = paths.member[_e1202];
                            let _e1215 = paths.member[_e1205];
                            let _e1221 = paths.member[_e1208];
                            let _e1223 = paths.member[_e1211];
                            local_7 = type_72(array<array<f32, 3>, 2>(array<f32, 3>((_e1213.member[0] - _e1215.member[0]), (_e1213.member[1] - _e1215.member[1]), (_e1213.member[2] - _e1215.member[2])), array<f32, 3>((_e1213.member_1[0] - _e1215.member_1[0]), (_e1213.member_1[1] - _e1215.member_1[1]), (_e1213.member_1[2] - _e1215.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1221.member[0] - _e1215.member[0]), (_e1221.member[1] - _e1215.member[1]), (_e1221.member[2] - _e1215.member[2])), array<f32, 3>((_e1221.member_1[0] - _e1215.member_1[0]), (_e1221.member_1[1] - _e1215.member_1[1]), (_e1221.member_1[2] - _e1215.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1223.member[0] - _e1215.member[0]), (_e1223.member[1] - _e1215.member[1]), (_e1223.member[2] - _e1215.member[2])), array<f32, 3>((_e1223.member_1[0] - _e1215.member_1[0]), (_e1223.member_1[1] - _e1215.member_1[1]), (_e1223.member_1[2] - _e1215.member_1[2]))), (_e1197 + _e1197));
                            let _e1283 = local_7.member_1[0u];
                            let _e1289 = local_7.member_2[0u];
                            let _e1295 = ((_e1283[1] * _e1289[2]) - (_e1283[2] * _e1289[1]));
                            let _e1298 = ((_e1283[2] * _e1289[0]) - (_e1283[0] * _e1289[2]));
                            let _e1301 = ((_e1283[0] * _e1289[1]) - (_e1283[1] * _e1289[0]));
                            let _e1304 = local_7.member_1[1u];
                            let _e1310 = local_7.member_2[1u];
                            let _e1316 = ((_e1304[1] * _e1310[2]) - (_e1304[2] * _e1310[1]));
                            let _e1319 = ((_e1304[2] * _e1310[0]) - (_e1304[0] * _e1310[2]));
                            let _e1322 = ((_e1304[0] * _e1310[1]) - (_e1304[1] * _e1310[0]));
                            let _e1325 = local_7.member_1[0u];
                            let _e1331 = local_7.member_2[1u];
                            let _e1346 = local_7.member_1[1u];
                            let _e1352 = local_7.member_2[0u];
                            let _e1365 = (((_e1325[1] * _e1331[2]) - (_e1325[2] * _e1331[1])) + ((_e1346[1] * _e1352[2]) - (_e1346[2] * _e1352[1])));
                            let _e1366 = (((_e1325[2] * _e1331[0]) - (_e1325[0] * _e1331[2])) + ((_e1346[2] * _e1352[0]) - (_e1346[0] * _e1352[2])));
                            let _e1367 = (((_e1325[0] * _e1331[1]) - (_e1325[1] * _e1331[0])) + ((_e1346[0] * _e1352[1]) - (_e1346[1] * _e1352[0])));
                            let _e1370 = local_7.member[0u];
                            let _e1381 = local_7.member[1u];
                            let _e1392 = local_7.member[0u];
                            let _e1401 = ((((_e1381[0] * _e1295) + (_e1381[1] * _e1298)) + (_e1381[2] * _e1301)) + (((_e1392[0] * _e1365) + (_e1392[1] * _e1366)) + (_e1392[2] * _e1367)));
                            let _e1404 = local_7.member[0u];
                            let _e1415 = local_7.member[1u];
                            let _e1424 = ((((_e1404[0] * _e1316) + (_e1404[1] * _e1319)) + (_e1404[2] * _e1322)) + (((_e1415[0] * _e1365) + (_e1415[1] * _e1366)) + (_e1415[2] * _e1367)));
                            let _e1427 = local_7.member[1u];
                            let _e1438 = local_7.member[0u];
                            if (_e1438[0] < 0f) {
                                phi_2100_ = -(_e1438[0]);
                            } else {
                                phi_2100_ = _e1438[0];
                            }
                            let _e1445 = phi_2100_;
                            if (_e1438[1] < 0f) {
                                phi_2107_ = -(_e1438[1]);
                            } else {
                                phi_2107_ = _e1438[1];
                            }
                            let _e1449 = phi_2107_;
                            if (_e1445 > _e1449) {
                                phi_2112_ = _e1445;
                            } else {
                                phi_2112_ = _e1449;
                            }
                            let _e1452 = phi_2112_;
                            if (_e1438[2] < 0f) {
                                phi_2119_ = -(_e1438[2]);
                            } else {
                                phi_2119_ = _e1438[2];
                            }
                            let _e1456 = phi_2119_;
                            if (_e1452 > _e1456) {
                                phi_2124_ = _e1452;
                            } else {
                                phi_2124_ = _e1456;
                            }
                            let _e1459 = phi_2124_;
                            let _e1462 = local_7.member[1u];
                            if (_e1462[0] < 0f) {
                                phi_2137_ = -(_e1462[0]);
                            } else {
                                phi_2137_ = _e1462[0];
                            }
                            let _e1469 = phi_2137_;
                            if (_e1462[1] < 0f) {
                                phi_2144_ = -(_e1462[1]);
                            } else {
                                phi_2144_ = _e1462[1];
                            }
                            let _e1473 = phi_2144_;
                            if (_e1469 > _e1473) {
                                phi_2149_ = _e1469;
                            } else {
                                phi_2149_ = _e1473;
                            }
                            let _e1476 = phi_2149_;
                            if (_e1462[2] < 0f) {
                                phi_2156_ = -(_e1462[2]);
                            } else {
                                phi_2156_ = _e1462[2];
                            }
                            let _e1480 = phi_2156_;
                            if (_e1476 > _e1480) {
                                phi_2161_ = _e1476;
                            } else {
                                phi_2161_ = _e1480;
                            }
                            let _e1483 = phi_2161_;
                            if (_e1459 > _e1483) {
                                phi_2166_ = _e1459;
                            } else {
                                phi_2166_ = _e1483;
                            }
                            let _e1486 = phi_2166_;
                            let _e1488 = local_7.member_3;
                            let _e1489 = (_e1486 + _e1488);
                            let _e1492 = local_7.member_1[0u];
                            if (_e1492[0] < 0f) {
                                phi_2183_ = -(_e1492[0]);
                            } else {
                                phi_2183_ = _e1492[0];
                            }
                            let _e1499 = phi_2183_;
                            if (_e1492[1] < 0f) {
                                phi_2190_ = -(_e1492[1]);
                            } else {
                                phi_2190_ = _e1492[1];
                            }
                            let _e1503 = phi_2190_;
                            if (_e1499 > _e1503) {
                                phi_2195_ = _e1499;
                            } else {
                                phi_2195_ = _e1503;
                            }
                            let _e1506 = phi_2195_;
                            if (_e1492[2] < 0f) {
                                phi_2202_ = -(_e1492[2]);
                            } else {
                                phi_2202_ = _e1492[2];
                            }
                            let _e1510 = phi_2202_;
                            if (_e1506 > _e1510) {
                                phi_2207_ = _e1506;
                            } else {
                                phi_2207_ = _e1510;
                            }
                            let _e1513 = phi_2207_;
                            let _e1516 = local_7.member_1[1u];
                            if (_e1516[0] < 0f) {
                                phi_2221_ = -(_e1516[0]);
                            } else {
                                phi_2221_ = _e1516[0];
                            }
                            let _e1523 = phi_2221_;
                            if (_e1516[1] < 0f) {
                                phi_2228_ = -(_e1516[1]);
                            } else {
                                phi_2228_ = _e1516[1];
                            }
                            let _e1527 = phi_2228_;
                            if (_e1523 > _e1527) {
                                phi_2233_ = _e1523;
                            } else {
                                phi_2233_ = _e1527;
                            }
                            let _e1530 = phi_2233_;
                            if (_e1516[2] < 0f) {
                                phi_2240_ = -(_e1516[2]);
                            } else {
                                phi_2240_ = _e1516[2];
                            }
                            let _e1534 = phi_2240_;
                            if (_e1530 > _e1534) {
                                phi_2245_ = _e1530;
                            } else {
                                phi_2245_ = _e1534;
                            }
                            let _e1537 = phi_2245_;
                            if (_e1513 > _e1537) {
                                phi_2250_ = _e1513;
                            } else {
                                phi_2250_ = _e1537;
                            }
                            let _e1540 = phi_2250_;
                            let _e1542 = local_7.member_3;
                            let _e1543 = (_e1540 + _e1542);
                            let _e1546 = local_7.member_2[0u];
                            if (_e1546[0] < 0f) {
                                phi_2267_ = -(_e1546[0]);
                            } else {
                                phi_2267_ = _e1546[0];
                            }
                            let _e1553 = phi_2267_;
                            if (_e1546[1] < 0f) {
                                phi_2274_ = -(_e1546[1]);
                            } else {
                                phi_2274_ = _e1546[1];
                            }
                            let _e1557 = phi_2274_;
                            if (_e1553 > _e1557) {
                                phi_2279_ = _e1553;
                            } else {
                                phi_2279_ = _e1557;
                            }
                            let _e1560 = phi_2279_;
                            if (_e1546[2] < 0f) {
                                phi_2286_ = -(_e1546[2]);
                            } else {
                                phi_2286_ = _e1546[2];
                            }
                            let _e1564 = phi_2286_;
                            if (_e1560 > _e1564) {
                                phi_2291_ = _e1560;
                            } else {
                                phi_2291_ = _e1564;
                            }
                            let _e1567 = phi_2291_;
                            let _e1570 = local_7.member_2[1u];
                            if (_e1570[0] < 0f) {
                                phi_2305_ = -(_e1570[0]);
                            } else {
                                phi_2305_ = _e1570[0];
                            }
                            let _e1577 = phi_2305_;
                            if (_e1570[1] < 0f) {
                                phi_2312_ = -(_e1570[1]);
                            } else {
                                phi_2312_ = _e1570[1];
                            }
                            let _e1581 = phi_2312_;
                            if (_e1577 > _e1581) {
                                phi_2317_ = _e1577;
                            } else {
                                phi_2317_ = _e1581;
                            }
                            let _e1584 = phi_2317_;
                            if (_e1570[2] < 0f) {
                                phi_2324_ = -(_e1570[2]);
                            } else {
                                phi_2324_ = _e1570[2];
                            }
                            let _e1588 = phi_2324_;
                            if (_e1584 > _e1588) {
                                phi_2329_ = _e1584;
                            } else {
                                phi_2329_ = _e1588;
                            }
                            let _e1591 = phi_2329_;
                            if (_e1567 > _e1591) {
                                phi_2334_ = _e1567;
                            } else {
                                phi_2334_ = _e1591;
                            }
                            let _e1594 = phi_2334_;
                            let _e1596 = local_7.member_3;
                            let _e1597 = (_e1594 + _e1596);
                            let _e1599 = ((_e1543 * 8f) * _e1597);
                            let _e1606 = local_7.member_3;
                            if (_e1295 < 0f) {
                                phi_2365_ = -(_e1295);
                            } else {
                                phi_2365_ = _e1295;
                            }
                            let _e1623 = phi_2365_;
                            if (_e1298 < 0f) {
                                phi_2371_ = -(_e1298);
                            } else {
                                phi_2371_ = _e1298;
                            }
                            let _e1627 = phi_2371_;
                            if (_e1301 < 0f) {
                                phi_2378_ = -(_e1301);
                            } else {
                                phi_2378_ = _e1301;
                            }
                            let _e1632 = phi_2378_;
                            let _e1633 = ((_e1623 + _e1627) + _e1632);
                            if (_e1316 < 0f) {
                                phi_2385_ = -(_e1316);
                            } else {
                                phi_2385_ = _e1316;
                            }
                            let _e1637 = phi_2385_;
                            if (_e1319 < 0f) {
                                phi_2391_ = -(_e1319);
                            } else {
                                phi_2391_ = _e1319;
                            }
                            let _e1641 = phi_2391_;
                            if (_e1322 < 0f) {
                                phi_2398_ = -(_e1322);
                            } else {
                                phi_2398_ = _e1322;
                            }
                            let _e1646 = phi_2398_;
                            let _e1647 = ((_e1637 + _e1641) + _e1646);
                            if (_e1633 > _e1647) {
                                phi_2404_ = _e1633;
                            } else {
                                phi_2404_ = _e1647;
                            }
                            let _e1650 = phi_2404_;
                            if (_e1365 < 0f) {
                                phi_2410_ = -(_e1365);
                            } else {
                                phi_2410_ = _e1365;
                            }
                            let _e1654 = phi_2410_;
                            if (_e1366 < 0f) {
                                phi_2416_ = -(_e1366);
                            } else {
                                phi_2416_ = _e1366;
                            }
                            let _e1658 = phi_2416_;
                            if (_e1367 < 0f) {
                                phi_2423_ = -(_e1367);
                            } else {
                                phi_2423_ = _e1367;
                            }
                            let _e1663 = phi_2423_;
                            let _e1665 = (((_e1654 + _e1658) + _e1663) * 0.5f);
                            if (_e1650 > _e1665) {
                                phi_2430_ = _e1650;
                            } else {
                                phi_2430_ = _e1665;
                            }
                            let _e1668 = phi_2430_;
                            let _e1673 = local_7.member_3;
                            let _e1686 = ((((_e1370[0] * _e1295) + (_e1370[1] * _e1298)) + (_e1370[2] * _e1301)) * 3f);
                            let _e1687 = ((((_e1427[0] * _e1316) + (_e1427[1] * _e1319)) + (_e1427[2] * _e1322)) * 3f);
                            if (_e1686 < _e1687) {
                                phi_2454_ = _e1686;
                            } else {
                                phi_2454_ = _e1687;
                            }
                            let _e1690 = phi_2454_;
                            if (_e1401 < _e1424) {
                                phi_2459_ = _e1401;
                            } else {
                                phi_2459_ = _e1424;
                            }
                            let _e1693 = phi_2459_;
                            if (_e1690 < _e1693) {
                                phi_2464_ = _e1690;
                            } else {
                                phi_2464_ = _e1693;
                            }
                            let _e1696 = phi_2464_;
                            if (_e1686 > _e1687) {
                                phi_2469_ = _e1686;
                            } else {
                                phi_2469_ = _e1687;
                            }
                            let _e1699 = phi_2469_;
                            if (_e1401 > _e1424) {
                                phi_2474_ = _e1401;
                            } else {
                                phi_2474_ = _e1424;
                            }
                            let _e1702 = phi_2474_;
                            if (_e1699 > _e1702) {
                                phi_2479_ = _e1699;
                            } else {
                                phi_2479_ = _e1702;
                            }
                            let _e1705 = phi_2479_;
                            let _e1710 = -(_e1705);
                            if (_e1696 > _e1710) {
                                phi_2489_ = _e1696;
                            } else {
                                phi_2489_ = _e1710;
                            }
                            let _e1713 = phi_2489_;
                            if ((_e1713 - ((((((_e1489 * 8f) * _e1599) * (0.000000059604645f * (490f / 64f))) + ((_e1606 * 19f) * ((_e1489 * (_e1543 + _e1597)) + (_e1543 * _e1597)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1489) * ((1f + _e1543) * (1f + _e1597))))) + ((_e1199 * (((_e1668 + (_e1599 * (0.000000059604645f * 4f))) + ((_e1673 * 6f) * (_e1543 + _e1597))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1543) * (1f + _e1597))))) * (3f * 1.0001f)))) > 0f) {
                                phi_3465_ = true;
                            } else {
                                let _e1718 = local_7.member_1[0u];
                                let _e1724 = local_7.member_1[1u];
                                let _e1728 = (_e1718[0] + _e1724[0]);
                                let _e1729 = (_e1718[1] + _e1724[1]);
                                let _e1730 = (_e1718[2] + _e1724[2]);
                                let _e1733 = local_7.member_2[0u];
                                let _e1739 = local_7.member_2[1u];
                                let _e1743 = (_e1733[0] + _e1739[0]);
                                let _e1744 = (_e1733[1] + _e1739[1]);
                                let _e1745 = (_e1733[2] + _e1739[2]);
                                let _e1748 = ((_e1729 * _e1745) - (_e1730 * _e1744));
                                let _e1751 = ((_e1730 * _e1743) - (_e1728 * _e1745));
                                let _e1754 = ((_e1728 * _e1744) - (_e1729 * _e1743));
                                let _e1757 = local_7.member[0u];
                                let _e1763 = local_7.member_1[0u];
                                let _e1769 = local_7.member_2[0u];
                                let _e1781 = local_7.member[1u];
                                let _e1787 = local_7.member_1[1u];
                                let _e1793 = local_7.member_2[1u];
                                local_5 = array<array<f32, 3>, 4>(_e1757, array<f32, 3>((_e1757[0] - _e1763[0]), (_e1757[1] - _e1763[1]), (_e1757[2] - _e1763[2])), array<f32, 3>((_e1757[0] - _e1769[0]), (_e1757[1] - _e1769[1]), (_e1757[2] - _e1769[2])), _e1757);
                                local_6 = array<array<f32, 3>, 4>(_e1781, array<f32, 3>((_e1781[0] - _e1787[0]), (_e1781[1] - _e1787[1]), (_e1781[2] - _e1787[2])), array<f32, 3>((_e1781[0] - _e1793[0]), (_e1781[1] - _e1793[1]), (_e1781[2] - _e1793[2])), _e1781);
                                let _e1811 = local_7.member[0u];
                                if (_e1811[0] < 0f) {
                                    phi_2740_ = -(_e1811[0]);
                                } else {
                                    phi_2740_ = _e1811[0];
                                }
                                let _e1818 = phi_2740_;
                                if (_e1811[1] < 0f) {
                                    phi_2747_ = -(_e1811[1]);
                                } else {
                                    phi_2747_ = _e1811[1];
                                }
                                let _e1822 = phi_2747_;
                                if (_e1818 > _e1822) {
                                    phi_2752_ = _e1818;
                                } else {
                                    phi_2752_ = _e1822;
                                }
                                let _e1825 = phi_2752_;
                                if (_e1811[2] < 0f) {
                                    phi_2759_ = -(_e1811[2]);
                                } else {
                                    phi_2759_ = _e1811[2];
                                }
                                let _e1829 = phi_2759_;
                                if (_e1825 > _e1829) {
                                    phi_2764_ = _e1825;
                                } else {
                                    phi_2764_ = _e1829;
                                }
                                let _e1832 = phi_2764_;
                                let _e1835 = local_7.member[1u];
                                if (_e1835[0] < 0f) {
                                    phi_2777_ = -(_e1835[0]);
                                } else {
                                    phi_2777_ = _e1835[0];
                                }
                                let _e1842 = phi_2777_;
                                if (_e1835[1] < 0f) {
                                    phi_2784_ = -(_e1835[1]);
                                } else {
                                    phi_2784_ = _e1835[1];
                                }
                                let _e1846 = phi_2784_;
                                if (_e1842 > _e1846) {
                                    phi_2789_ = _e1842;
                                } else {
                                    phi_2789_ = _e1846;
                                }
                                let _e1849 = phi_2789_;
                                if (_e1835[2] < 0f) {
                                    phi_2796_ = -(_e1835[2]);
                                } else {
                                    phi_2796_ = _e1835[2];
                                }
                                let _e1853 = phi_2796_;
                                if (_e1849 > _e1853) {
                                    phi_2801_ = _e1849;
                                } else {
                                    phi_2801_ = _e1853;
                                }
                                let _e1856 = phi_2801_;
                                if (_e1832 > _e1856) {
                                    phi_2806_ = _e1832;
                                } else {
                                    phi_2806_ = _e1856;
                                }
                                let _e1859 = phi_2806_;
                                let _e1861 = local_7.member_3;
                                let _e1865 = local_7.member_1[0u];
                                if (_e1865[0] < 0f) {
                                    phi_2823_ = -(_e1865[0]);
                                } else {
                                    phi_2823_ = _e1865[0];
                                }
                                let _e1872 = phi_2823_;
                                if (_e1865[1] < 0f) {
                                    phi_2830_ = -(_e1865[1]);
                                } else {
                                    phi_2830_ = _e1865[1];
                                }
                                let _e1876 = phi_2830_;
                                if (_e1872 > _e1876) {
                                    phi_2835_ = _e1872;
                                } else {
                                    phi_2835_ = _e1876;
                                }
                                let _e1879 = phi_2835_;
                                if (_e1865[2] < 0f) {
                                    phi_2842_ = -(_e1865[2]);
                                } else {
                                    phi_2842_ = _e1865[2];
                                }
                                let _e1883 = phi_2842_;
                                if (_e1879 > _e1883) {
                                    phi_2847_ = _e1879;
                                } else {
                                    phi_2847_ = _e1883;
                                }
                                let _e1886 = phi_2847_;
                                let _e1889 = local_7.member_1[1u];
                                if (_e1889[0] < 0f) {
                                    phi_2861_ = -(_e1889[0]);
                                } else {
                                    phi_2861_ = _e1889[0];
                                }
                                let _e1896 = phi_2861_;
                                if (_e1889[1] < 0f) {
                                    phi_2868_ = -(_e1889[1]);
                                } else {
                                    phi_2868_ = _e1889[1];
                                }
                                let _e1900 = phi_2868_;
                                if (_e1896 > _e1900) {
                                    phi_2873_ = _e1896;
                                } else {
                                    phi_2873_ = _e1900;
                                }
                                let _e1903 = phi_2873_;
                                if (_e1889[2] < 0f) {
                                    phi_2880_ = -(_e1889[2]);
                                } else {
                                    phi_2880_ = _e1889[2];
                                }
                                let _e1907 = phi_2880_;
                                if (_e1903 > _e1907) {
                                    phi_2885_ = _e1903;
                                } else {
                                    phi_2885_ = _e1907;
                                }
                                let _e1910 = phi_2885_;
                                if (_e1886 > _e1910) {
                                    phi_2890_ = _e1886;
                                } else {
                                    phi_2890_ = _e1910;
                                }
                                let _e1913 = phi_2890_;
                                let _e1915 = local_7.member_3;
                                let _e1919 = local_7.member_2[0u];
                                if (_e1919[0] < 0f) {
                                    phi_2907_ = -(_e1919[0]);
                                } else {
                                    phi_2907_ = _e1919[0];
                                }
                                let _e1926 = phi_2907_;
                                if (_e1919[1] < 0f) {
                                    phi_2914_ = -(_e1919[1]);
                                } else {
                                    phi_2914_ = _e1919[1];
                                }
                                let _e1930 = phi_2914_;
                                if (_e1926 > _e1930) {
                                    phi_2919_ = _e1926;
                                } else {
                                    phi_2919_ = _e1930;
                                }
                                let _e1933 = phi_2919_;
                                if (_e1919[2] < 0f) {
                                    phi_2926_ = -(_e1919[2]);
                                } else {
                                    phi_2926_ = _e1919[2];
                                }
                                let _e1937 = phi_2926_;
                                if (_e1933 > _e1937) {
                                    phi_2931_ = _e1933;
                                } else {
                                    phi_2931_ = _e1937;
                                }
                                let _e1940 = phi_2931_;
                                let _e1943 = local_7.member_2[1u];
                                if (_e1943[0] < 0f) {
                                    phi_2945_ = -(_e1943[0]);
                                } else {
                                    phi_2945_ = _e1943[0];
                                }
                                let _e1950 = phi_2945_;
                                if (_e1943[1] < 0f) {
                                    phi_2952_ = -(_e1943[1]);
                                } else {
                                    phi_2952_ = _e1943[1];
                                }
                                let _e1954 = phi_2952_;
                                if (_e1950 > _e1954) {
                                    phi_2957_ = _e1950;
                                } else {
                                    phi_2957_ = _e1954;
                                }
                                let _e1957 = phi_2957_;
                                if (_e1943[2] < 0f) {
                                    phi_2964_ = -(_e1943[2]);
                                } else {
                                    phi_2964_ = _e1943[2];
                                }
                                let _e1961 = phi_2964_;
                                if (_e1957 > _e1961) {
                                    phi_2969_ = _e1957;
                                } else {
                                    phi_2969_ = _e1961;
                                }
                                let _e1964 = phi_2969_;
                                if (_e1940 > _e1964) {
                                    phi_2974_ = _e1940;
                                } else {
                                    phi_2974_ = _e1964;
                                }
                                let _e1967 = phi_2974_;
                                let _e1969 = local_7.member_3;
                                let _e1972 = (((_e1859 + _e1861) + (_e1913 + _e1915)) + (_e1967 + _e1969));
                                let _e1975 = local_7.member_3;
                                let _e1979 = (((_e1199 * 1.0001f) + (_e1975 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e1982 = ((_e1751 * _e1730) - (_e1754 * _e1729));
                                let _e1985 = ((_e1754 * _e1728) - (_e1748 * _e1730));
                                let _e1988 = ((_e1748 * _e1729) - (_e1751 * _e1728));
                                let _e1990 = local_5[0u];
                                let _e1998 = (((_e1982 * _e1990[0]) + (_e1985 * _e1990[1])) + (_e1988 * _e1990[2]));
                                phi_3012_ = type_37(0u, 4u);
                                phi_3015_ = _e1998;
                                phi_3017_ = _e1998;
                                loop {
                                    let _e2000 = phi_3012_;
                                    let _e2002 = phi_3015_;
                                    let _e2004 = phi_3017_;
                                    local_30 = _e2002;
                                    local_31 = _e2004;
                                    local_49 = _e2004;
                                    if (_e2000.member < _e2000.member_1) {
                                        phi_3013_ = type_37((_e2000.member + 1u), _e2000.member_1);
                                        phi_3040_ = type_37(1u, _e2000.member);
                                    } else {
                                        phi_3013_ = _e2000;
                                        phi_3040_ = type_37(0u, type_37().member_1);
                                    }
                                    let _e2018 = phi_3013_;
                                    let _e2020 = phi_3040_;
                                    let _e2024 = (bitcast<i32>(_e2020.member) != 0i);
                                    if _e2024 {
                                        if (_e2020.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2027 = local_5[_e2020.member_1];
                                        let _e2035 = (((_e1982 * _e2027[0]) + (_e1985 * _e2027[1])) + (_e1988 * _e2027[2]));
                                        if (_e2020.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2038 = local_6[_e2020.member_1];
                                        let _e2046 = (((_e1982 * _e2038[0]) + (_e1985 * _e2038[1])) + (_e1988 * _e2038[2]));
                                        if (_e2004 < _e2035) {
                                            phi_3090_ = _e2004;
                                        } else {
                                            phi_3090_ = _e2035;
                                        }
                                        let _e2049 = phi_3090_;
                                        if (_e2049 < _e2046) {
                                            phi_3095_ = _e2049;
                                        } else {
                                            phi_3095_ = _e2046;
                                        }
                                        let _e2052 = phi_3095_;
                                        if (_e2002 > _e2035) {
                                            phi_3100_ = _e2002;
                                        } else {
                                            phi_3100_ = _e2035;
                                        }
                                        let _e2055 = phi_3100_;
                                        if (_e2055 > _e2046) {
                                            phi_3105_ = _e2055;
                                        } else {
                                            phi_3105_ = _e2046;
                                        }
                                        let _e2058 = phi_3105_;
                                        phi_3016_ = _e2058;
                                        phi_3018_ = _e2052;
                                    } else {
                                        phi_3016_ = f32();
                                        phi_3018_ = f32();
                                    }
                                    let _e2060 = phi_3016_;
                                    let _e2062 = phi_3018_;
                                    continue;
                                    continuing {
                                        phi_3012_ = _e2018;
                                        phi_3015_ = _e2060;
                                        phi_3017_ = _e2062;
                                        break if !(_e2024);
                                    }
                                }
                                if (_e1982 < 0f) {
                                    phi_3111_ = -(_e1982);
                                } else {
                                    phi_3111_ = _e1982;
                                }
                                let _e2067 = phi_3111_;
                                if (_e1985 < 0f) {
                                    phi_3117_ = -(_e1985);
                                } else {
                                    phi_3117_ = _e1985;
                                }
                                let _e2071 = phi_3117_;
                                if (_e1988 < 0f) {
                                    phi_3124_ = -(_e1988);
                                } else {
                                    phi_3124_ = _e1988;
                                }
                                let _e2076 = phi_3124_;
                                let _e2077 = ((_e2067 + _e2071) + _e2076);
                                let _e2082 = local_30;
                                let _e2083 = -(_e2082);
                                let _e2085 = local_31;
                                if (_e2085 > _e2083) {
                                    let _e4868 = local_49;
                                    phi_3134_ = _e4868;
                                } else {
                                    phi_3134_ = _e2083;
                                }
                                let _e2088 = phi_3134_;
                                let _e2093 = (((_e2088 - ((_e2077 * _e1972) * (0.000000059604645f * 17f))) - (_e2077 * _e1979)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2096 = ((_e1751 * _e1745) - (_e1754 * _e1744));
                                let _e2099 = ((_e1754 * _e1743) - (_e1748 * _e1745));
                                let _e2102 = ((_e1748 * _e1744) - (_e1751 * _e1743));
                                let _e2104 = local_5[0u];
                                let _e2112 = (((_e2096 * _e2104[0]) + (_e2099 * _e2104[1])) + (_e2102 * _e2104[2]));
                                phi_3165_ = type_37(0u, 4u);
                                phi_3168_ = _e2112;
                                phi_3170_ = _e2112;
                                loop {
                                    let _e2114 = phi_3165_;
                                    let _e2116 = phi_3168_;
                                    let _e2118 = phi_3170_;
                                    local_32 = _e2116;
                                    local_33 = _e2118;
                                    local_50 = _e2118;
                                    if (_e2114.member < _e2114.member_1) {
                                        phi_3166_ = type_37((_e2114.member + 1u), _e2114.member_1);
                                        phi_3193_ = type_37(1u, _e2114.member);
                                    } else {
                                        phi_3166_ = _e2114;
                                        phi_3193_ = type_37(0u, type_37().member_1);
                                    }
                                    let _e2132 = phi_3166_;
                                    let _e2134 = phi_3193_;
                                    let _e2138 = (bitcast<i32>(_e2134.member) != 0i);
                                    if _e2138 {
                                        if (_e2134.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2141 = local_5[_e2134.member_1];
                                        let _e2149 = (((_e2096 * _e2141[0]) + (_e2099 * _e2141[1])) + (_e2102 * _e2141[2]));
                                        if (_e2134.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2152 = local_6[_e2134.member_1];
                                        let _e2160 = (((_e2096 * _e2152[0]) + (_e2099 * _e2152[1])) + (_e2102 * _e2152[2]));
                                        if (_e2118 < _e2149) {
                                            phi_3243_ = _e2118;
                                        } else {
                                            phi_3243_ = _e2149;
                                        }
                                        let _e2163 = phi_3243_;
                                        if (_e2163 < _e2160) {
                                            phi_3248_ = _e2163;
                                        } else {
                                            phi_3248_ = _e2160;
                                        }
                                        let _e2166 = phi_3248_;
                                        if (_e2116 > _e2149) {
                                            phi_3253_ = _e2116;
                                        } else {
                                            phi_3253_ = _e2149;
                                        }
                                        let _e2169 = phi_3253_;
                                        if (_e2169 > _e2160) {
                                            phi_3258_ = _e2169;
                                        } else {
                                            phi_3258_ = _e2160;
                                        }
                                        let _e2172 = phi_3258_;
                                        phi_3169_ = _e2172;
                                        phi_3171_ = _e2166;
                                    } else {
                                        phi_3169_ = f32();
                                        phi_3171_ = f32();
                                    }
                                    let _e2174 = phi_3169_;
                                    let _e2176 = phi_3171_;
                                    continue;
                                    continuing {
                                        phi_3165_ = _e2132;
                                        phi_3168_ = _e2174;
                                        phi_3170_ = _e2176;
                                        break if !(_e2138);
                                    }
                                }
                                if (_e2096 < 0f) {
                                    phi_3264_ = -(_e2096);
                                } else {
                                    phi_3264_ = _e2096;
                                }
                                let _e2181 = phi_3264_;
                                if (_e2099 < 0f) {
                                    phi_3270_ = -(_e2099);
                                } else {
                                    phi_3270_ = _e2099;
                                }
                                let _e2185 = phi_3270_;
                                if (_e2102 < 0f) {
                                    phi_3277_ = -(_e2102);
                                } else {
                                    phi_3277_ = _e2102;
                                }
                                let _e2190 = phi_3277_;
                                let _e2191 = ((_e2181 + _e2185) + _e2190);
                                let _e2196 = local_32;
                                let _e2197 = -(_e2196);
                                let _e2199 = local_33;
                                if (_e2199 > _e2197) {
                                    let _e4887 = local_50;
                                    phi_3287_ = _e4887;
                                } else {
                                    phi_3287_ = _e2197;
                                }
                                let _e2202 = phi_3287_;
                                let _e2207 = (((_e2202 - ((_e2191 * _e1972) * (0.000000059604645f * 17f))) - (_e2191 * _e1979)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2093 > _e2207) {
                                    phi_3297_ = _e2093;
                                } else {
                                    phi_3297_ = _e2207;
                                }
                                let _e2210 = phi_3297_;
                                let _e2211 = (_e1743 - _e1728);
                                let _e2212 = (_e1744 - _e1729);
                                let _e2213 = (_e1745 - _e1730);
                                let _e2216 = ((_e1751 * _e2213) - (_e1754 * _e2212));
                                let _e2219 = ((_e1754 * _e2211) - (_e1748 * _e2213));
                                let _e2222 = ((_e1748 * _e2212) - (_e1751 * _e2211));
                                let _e2224 = local_5[0u];
                                let _e2232 = (((_e2216 * _e2224[0]) + (_e2219 * _e2224[1])) + (_e2222 * _e2224[2]));
                                phi_3330_ = type_37(0u, 4u);
                                phi_3333_ = _e2232;
                                phi_3335_ = _e2232;
                                loop {
                                    let _e2234 = phi_3330_;
                                    let _e2236 = phi_3333_;
                                    let _e2238 = phi_3335_;
                                    local_34 = _e2236;
                                    local_35 = _e2238;
                                    local_51 = _e2238;
                                    if (_e2234.member < _e2234.member_1) {
                                        phi_3331_ = type_37((_e2234.member + 1u), _e2234.member_1);
                                        phi_3358_ = type_37(1u, _e2234.member);
                                    } else {
                                        phi_3331_ = _e2234;
                                        phi_3358_ = type_37(0u, type_37().member_1);
                                    }
                                    let _e2252 = phi_3331_;
                                    let _e2254 = phi_3358_;
                                    let _e2258 = (bitcast<i32>(_e2254.member) != 0i);
                                    if _e2258 {
                                        if (_e2254.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2261 = local_5[_e2254.member_1];
                                        let _e2269 = (((_e2216 * _e2261[0]) + (_e2219 * _e2261[1])) + (_e2222 * _e2261[2]));
                                        if (_e2254.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2272 = local_6[_e2254.member_1];
                                        let _e2280 = (((_e2216 * _e2272[0]) + (_e2219 * _e2272[1])) + (_e2222 * _e2272[2]));
                                        if (_e2238 < _e2269) {
                                            phi_3408_ = _e2238;
                                        } else {
                                            phi_3408_ = _e2269;
                                        }
                                        let _e2283 = phi_3408_;
                                        if (_e2283 < _e2280) {
                                            phi_3413_ = _e2283;
                                        } else {
                                            phi_3413_ = _e2280;
                                        }
                                        let _e2286 = phi_3413_;
                                        if (_e2236 > _e2269) {
                                            phi_3418_ = _e2236;
                                        } else {
                                            phi_3418_ = _e2269;
                                        }
                                        let _e2289 = phi_3418_;
                                        if (_e2289 > _e2280) {
                                            phi_3423_ = _e2289;
                                        } else {
                                            phi_3423_ = _e2280;
                                        }
                                        let _e2292 = phi_3423_;
                                        phi_3334_ = _e2292;
                                        phi_3336_ = _e2286;
                                    } else {
                                        phi_3334_ = f32();
                                        phi_3336_ = f32();
                                    }
                                    let _e2294 = phi_3334_;
                                    let _e2296 = phi_3336_;
                                    continue;
                                    continuing {
                                        phi_3330_ = _e2252;
                                        phi_3333_ = _e2294;
                                        phi_3335_ = _e2296;
                                        break if !(_e2258);
                                    }
                                }
                                if (_e2216 < 0f) {
                                    phi_3429_ = -(_e2216);
                                } else {
                                    phi_3429_ = _e2216;
                                }
                                let _e2301 = phi_3429_;
                                if (_e2219 < 0f) {
                                    phi_3435_ = -(_e2219);
                                } else {
                                    phi_3435_ = _e2219;
                                }
                                let _e2305 = phi_3435_;
                                if (_e2222 < 0f) {
                                    phi_3442_ = -(_e2222);
                                } else {
                                    phi_3442_ = _e2222;
                                }
                                let _e2310 = phi_3442_;
                                let _e2311 = ((_e2301 + _e2305) + _e2310);
                                let _e2316 = local_34;
                                let _e2317 = -(_e2316);
                                let _e2319 = local_35;
                                if (_e2319 > _e2317) {
                                    let _e4907 = local_51;
                                    phi_3452_ = _e4907;
                                } else {
                                    phi_3452_ = _e2317;
                                }
                                let _e2322 = phi_3452_;
                                let _e2327 = (((_e2322 - ((_e2311 * _e1972) * (0.000000059604645f * 17f))) - (_e2311 * _e1979)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2210 > _e2327) {
                                    phi_3462_ = _e2210;
                                } else {
                                    phi_3462_ = _e2327;
                                }
                                let _e2330 = phi_3462_;
                                phi_3465_ = (_e2330 > 0f);
                            }
                            let _e2333 = phi_3465_;
                            if _e2333 {
                                phi_6901_ = false;
                            } else {
                                let _e2336 = local_7.member[0u];
                                let _e2342 = local_7.member[1u];
                                let _e2349 = ((_e2336[0] + _e2342[0]) * 0.5f);
                                let _e2350 = ((_e2336[1] + _e2342[1]) * 0.5f);
                                let _e2351 = ((_e2336[2] + _e2342[2]) * 0.5f);
                                let _e2354 = local_7.member_1[0u];
                                let _e2360 = local_7.member_1[1u];
                                let _e2367 = ((_e2354[0] + _e2360[0]) * 0.5f);
                                let _e2368 = ((_e2354[1] + _e2360[1]) * 0.5f);
                                let _e2369 = ((_e2354[2] + _e2360[2]) * 0.5f);
                                let _e2372 = local_7.member_2[0u];
                                let _e2378 = local_7.member_2[1u];
                                let _e2385 = ((_e2372[0] + _e2378[0]) * 0.5f);
                                let _e2386 = ((_e2372[1] + _e2378[1]) * 0.5f);
                                let _e2387 = ((_e2372[2] + _e2378[2]) * 0.5f);
                                let _e2390 = local_7.member[0u];
                                let _e2393 = local_7.member_1[0u];
                                let _e2396 = local_7.member_2[0u];
                                let _e2398 = local_7.member_3;
                                let _e2401 = local_7.member[1u];
                                let _e2404 = local_7.member_1[1u];
                                let _e2407 = local_7.member_2[1u];
                                let _e2409 = local_7.member_3;
                                local_4 = array<type_72, 2>(type_72(array<array<f32, 3>, 2>(_e2390, array<f32, 3>(_e2349, _e2350, _e2351)), array<array<f32, 3>, 2>(_e2393, array<f32, 3>(_e2367, _e2368, _e2369)), array<array<f32, 3>, 2>(_e2396, array<f32, 3>(_e2385, _e2386, _e2387)), _e2398), type_72(array<array<f32, 3>, 2>(array<f32, 3>(_e2349, _e2350, _e2351), _e2401), array<array<f32, 3>, 2>(array<f32, 3>(_e2367, _e2368, _e2369), _e2404), array<array<f32, 3>, 2>(array<f32, 3>(_e2385, _e2386, _e2387), _e2407), _e2409));
                                let _e2428 = local_4[0u].member_1[0u];
                                let _e2434 = local_4[0u].member_2[0u];
                                let _e2440 = ((_e2428[1] * _e2434[2]) - (_e2428[2] * _e2434[1]));
                                let _e2443 = ((_e2428[2] * _e2434[0]) - (_e2428[0] * _e2434[2]));
                                let _e2446 = ((_e2428[0] * _e2434[1]) - (_e2428[1] * _e2434[0]));
                                let _e2449 = local_4[0u].member_1[1u];
                                let _e2455 = local_4[0u].member_2[1u];
                                let _e2461 = ((_e2449[1] * _e2455[2]) - (_e2449[2] * _e2455[1]));
                                let _e2464 = ((_e2449[2] * _e2455[0]) - (_e2449[0] * _e2455[2]));
                                let _e2467 = ((_e2449[0] * _e2455[1]) - (_e2449[1] * _e2455[0]));
                                let _e2470 = local_4[0u].member_1[0u];
                                let _e2476 = local_4[0u].member_2[1u];
                                let _e2491 = local_4[0u].member_1[1u];
                                let _e2497 = local_4[0u].member_2[0u];
                                let _e2510 = (((_e2470[1] * _e2476[2]) - (_e2470[2] * _e2476[1])) + ((_e2491[1] * _e2497[2]) - (_e2491[2] * _e2497[1])));
                                let _e2511 = (((_e2470[2] * _e2476[0]) - (_e2470[0] * _e2476[2])) + ((_e2491[2] * _e2497[0]) - (_e2491[0] * _e2497[2])));
                                let _e2512 = (((_e2470[0] * _e2476[1]) - (_e2470[1] * _e2476[0])) + ((_e2491[0] * _e2497[1]) - (_e2491[1] * _e2497[0])));
                                let _e2515 = local_4[0u].member[0u];
                                let _e2526 = local_4[0u].member[1u];
                                let _e2537 = local_4[0u].member[0u];
                                let _e2546 = ((((_e2526[0] * _e2440) + (_e2526[1] * _e2443)) + (_e2526[2] * _e2446)) + (((_e2537[0] * _e2510) + (_e2537[1] * _e2511)) + (_e2537[2] * _e2512)));
                                let _e2549 = local_4[0u].member[0u];
                                let _e2560 = local_4[0u].member[1u];
                                let _e2569 = ((((_e2549[0] * _e2461) + (_e2549[1] * _e2464)) + (_e2549[2] * _e2467)) + (((_e2560[0] * _e2510) + (_e2560[1] * _e2511)) + (_e2560[2] * _e2512)));
                                let _e2572 = local_4[0u].member[1u];
                                let _e2583 = local_4[0u].member[0u];
                                if (_e2583[0] < 0f) {
                                    phi_3922_ = -(_e2583[0]);
                                } else {
                                    phi_3922_ = _e2583[0];
                                }
                                let _e2590 = phi_3922_;
                                if (_e2583[1] < 0f) {
                                    phi_3929_ = -(_e2583[1]);
                                } else {
                                    phi_3929_ = _e2583[1];
                                }
                                let _e2594 = phi_3929_;
                                if (_e2590 > _e2594) {
                                    phi_3934_ = _e2590;
                                } else {
                                    phi_3934_ = _e2594;
                                }
                                let _e2597 = phi_3934_;
                                if (_e2583[2] < 0f) {
                                    phi_3941_ = -(_e2583[2]);
                                } else {
                                    phi_3941_ = _e2583[2];
                                }
                                let _e2601 = phi_3941_;
                                if (_e2597 > _e2601) {
                                    phi_3946_ = _e2597;
                                } else {
                                    phi_3946_ = _e2601;
                                }
                                let _e2604 = phi_3946_;
                                let _e2607 = local_4[0u].member[1u];
                                if (_e2607[0] < 0f) {
                                    phi_3959_ = -(_e2607[0]);
                                } else {
                                    phi_3959_ = _e2607[0];
                                }
                                let _e2614 = phi_3959_;
                                if (_e2607[1] < 0f) {
                                    phi_3966_ = -(_e2607[1]);
                                } else {
                                    phi_3966_ = _e2607[1];
                                }
                                let _e2618 = phi_3966_;
                                if (_e2614 > _e2618) {
                                    phi_3971_ = _e2614;
                                } else {
                                    phi_3971_ = _e2618;
                                }
                                let _e2621 = phi_3971_;
                                if (_e2607[2] < 0f) {
                                    phi_3978_ = -(_e2607[2]);
                                } else {
                                    phi_3978_ = _e2607[2];
                                }
                                let _e2625 = phi_3978_;
                                if (_e2621 > _e2625) {
                                    phi_3983_ = _e2621;
                                } else {
                                    phi_3983_ = _e2625;
                                }
                                let _e2628 = phi_3983_;
                                if (_e2604 > _e2628) {
                                    phi_3988_ = _e2604;
                                } else {
                                    phi_3988_ = _e2628;
                                }
                                let _e2631 = phi_3988_;
                                let _e2633 = local_4[0u].member_3;
                                let _e2634 = (_e2631 + _e2633);
                                let _e2637 = local_4[0u].member_1[0u];
                                if (_e2637[0] < 0f) {
                                    phi_4005_ = -(_e2637[0]);
                                } else {
                                    phi_4005_ = _e2637[0];
                                }
                                let _e2644 = phi_4005_;
                                if (_e2637[1] < 0f) {
                                    phi_4012_ = -(_e2637[1]);
                                } else {
                                    phi_4012_ = _e2637[1];
                                }
                                let _e2648 = phi_4012_;
                                if (_e2644 > _e2648) {
                                    phi_4017_ = _e2644;
                                } else {
                                    phi_4017_ = _e2648;
                                }
                                let _e2651 = phi_4017_;
                                if (_e2637[2] < 0f) {
                                    phi_4024_ = -(_e2637[2]);
                                } else {
                                    phi_4024_ = _e2637[2];
                                }
                                let _e2655 = phi_4024_;
                                if (_e2651 > _e2655) {
                                    phi_4029_ = _e2651;
                                } else {
                                    phi_4029_ = _e2655;
                                }
                                let _e2658 = phi_4029_;
                                let _e2661 = local_4[0u].member_1[1u];
                                if (_e2661[0] < 0f) {
                                    phi_4043_ = -(_e2661[0]);
                                } else {
                                    phi_4043_ = _e2661[0];
                                }
                                let _e2668 = phi_4043_;
                                if (_e2661[1] < 0f) {
                                    phi_4050_ = -(_e2661[1]);
                                } else {
                                    phi_4050_ = _e2661[1];
                                }
                                let _e2672 = phi_4050_;
                                if (_e2668 > _e2672) {
                                    phi_4055_ = _e2668;
                                } else {
                                    phi_4055_ = _e2672;
                                }
                                let _e2675 = phi_4055_;
                                if (_e2661[2] < 0f) {
                                    phi_4062_ = -(_e2661[2]);
                                } else {
                                    phi_4062_ = _e2661[2];
                                }
                                let _e2679 = phi_4062_;
                                if (_e2675 > _e2679) {
                                    phi_4067_ = _e2675;
                                } else {
                                    phi_4067_ = _e2679;
                                }
                                let _e2682 = phi_4067_;
                                if (_e2658 > _e2682) {
                                    phi_4072_ = _e2658;
                                } else {
                                    phi_4072_ = _e2682;
                                }
                                let _e2685 = phi_4072_;
                                let _e2687 = local_4[0u].member_3;
                                let _e2688 = (_e2685 + _e2687);
                                let _e2691 = local_4[0u].member_2[0u];
                                if (_e2691[0] < 0f) {
                                    phi_4089_ = -(_e2691[0]);
                                } else {
                                    phi_4089_ = _e2691[0];
                                }
                                let _e2698 = phi_4089_;
                                if (_e2691[1] < 0f) {
                                    phi_4096_ = -(_e2691[1]);
                                } else {
                                    phi_4096_ = _e2691[1];
                                }
                                let _e2702 = phi_4096_;
                                if (_e2698 > _e2702) {
                                    phi_4101_ = _e2698;
                                } else {
                                    phi_4101_ = _e2702;
                                }
                                let _e2705 = phi_4101_;
                                if (_e2691[2] < 0f) {
                                    phi_4108_ = -(_e2691[2]);
                                } else {
                                    phi_4108_ = _e2691[2];
                                }
                                let _e2709 = phi_4108_;
                                if (_e2705 > _e2709) {
                                    phi_4113_ = _e2705;
                                } else {
                                    phi_4113_ = _e2709;
                                }
                                let _e2712 = phi_4113_;
                                let _e2715 = local_4[0u].member_2[1u];
                                if (_e2715[0] < 0f) {
                                    phi_4127_ = -(_e2715[0]);
                                } else {
                                    phi_4127_ = _e2715[0];
                                }
                                let _e2722 = phi_4127_;
                                if (_e2715[1] < 0f) {
                                    phi_4134_ = -(_e2715[1]);
                                } else {
                                    phi_4134_ = _e2715[1];
                                }
                                let _e2726 = phi_4134_;
                                if (_e2722 > _e2726) {
                                    phi_4139_ = _e2722;
                                } else {
                                    phi_4139_ = _e2726;
                                }
                                let _e2729 = phi_4139_;
                                if (_e2715[2] < 0f) {
                                    phi_4146_ = -(_e2715[2]);
                                } else {
                                    phi_4146_ = _e2715[2];
                                }
                                let _e2733 = phi_4146_;
                                if (_e2729 > _e2733) {
                                    phi_4151_ = _e2729;
                                } else {
                                    phi_4151_ = _e2733;
                                }
                                let _e2736 = phi_4151_;
                                if (_e2712 > _e2736) {
                                    phi_4156_ = _e2712;
                                } else {
                                    phi_4156_ = _e2736;
                                }
                                let _e2739 = phi_4156_;
                                let _e2741 = local_4[0u].member_3;
                                let _e2742 = (_e2739 + _e2741);
                                let _e2744 = ((_e2688 * 8f) * _e2742);
                                let _e2751 = local_4[0u].member_3;
                                if (_e2440 < 0f) {
                                    phi_4187_ = -(_e2440);
                                } else {
                                    phi_4187_ = _e2440;
                                }
                                let _e2768 = phi_4187_;
                                if (_e2443 < 0f) {
                                    phi_4193_ = -(_e2443);
                                } else {
                                    phi_4193_ = _e2443;
                                }
                                let _e2772 = phi_4193_;
                                if (_e2446 < 0f) {
                                    phi_4200_ = -(_e2446);
                                } else {
                                    phi_4200_ = _e2446;
                                }
                                let _e2777 = phi_4200_;
                                let _e2778 = ((_e2768 + _e2772) + _e2777);
                                if (_e2461 < 0f) {
                                    phi_4207_ = -(_e2461);
                                } else {
                                    phi_4207_ = _e2461;
                                }
                                let _e2782 = phi_4207_;
                                if (_e2464 < 0f) {
                                    phi_4213_ = -(_e2464);
                                } else {
                                    phi_4213_ = _e2464;
                                }
                                let _e2786 = phi_4213_;
                                if (_e2467 < 0f) {
                                    phi_4220_ = -(_e2467);
                                } else {
                                    phi_4220_ = _e2467;
                                }
                                let _e2791 = phi_4220_;
                                let _e2792 = ((_e2782 + _e2786) + _e2791);
                                if (_e2778 > _e2792) {
                                    phi_4226_ = _e2778;
                                } else {
                                    phi_4226_ = _e2792;
                                }
                                let _e2795 = phi_4226_;
                                if (_e2510 < 0f) {
                                    phi_4232_ = -(_e2510);
                                } else {
                                    phi_4232_ = _e2510;
                                }
                                let _e2799 = phi_4232_;
                                if (_e2511 < 0f) {
                                    phi_4238_ = -(_e2511);
                                } else {
                                    phi_4238_ = _e2511;
                                }
                                let _e2803 = phi_4238_;
                                if (_e2512 < 0f) {
                                    phi_4245_ = -(_e2512);
                                } else {
                                    phi_4245_ = _e2512;
                                }
                                let _e2808 = phi_4245_;
                                let _e2810 = (((_e2799 + _e2803) + _e2808) * 0.5f);
                                if (_e2795 > _e2810) {
                                    phi_4252_ = _e2795;
                                } else {
                                    phi_4252_ = _e2810;
                                }
                                let _e2813 = phi_4252_;
                                let _e2818 = local_4[0u].member_3;
                                let _e2831 = ((((_e2515[0] * _e2440) + (_e2515[1] * _e2443)) + (_e2515[2] * _e2446)) * 3f);
                                let _e2832 = ((((_e2572[0] * _e2461) + (_e2572[1] * _e2464)) + (_e2572[2] * _e2467)) * 3f);
                                if (_e2831 < _e2832) {
                                    phi_4276_ = _e2831;
                                } else {
                                    phi_4276_ = _e2832;
                                }
                                let _e2835 = phi_4276_;
                                if (_e2546 < _e2569) {
                                    phi_4281_ = _e2546;
                                } else {
                                    phi_4281_ = _e2569;
                                }
                                let _e2838 = phi_4281_;
                                if (_e2835 < _e2838) {
                                    phi_4286_ = _e2835;
                                } else {
                                    phi_4286_ = _e2838;
                                }
                                let _e2841 = phi_4286_;
                                if (_e2831 > _e2832) {
                                    phi_4291_ = _e2831;
                                } else {
                                    phi_4291_ = _e2832;
                                }
                                let _e2844 = phi_4291_;
                                if (_e2546 > _e2569) {
                                    phi_4296_ = _e2546;
                                } else {
                                    phi_4296_ = _e2569;
                                }
                                let _e2847 = phi_4296_;
                                if (_e2844 > _e2847) {
                                    phi_4301_ = _e2844;
                                } else {
                                    phi_4301_ = _e2847;
                                }
                                let _e2850 = phi_4301_;
                                let _e2855 = -(_e2850);
                                if (_e2841 > _e2855) {
                                    phi_4311_ = _e2841;
                                } else {
                                    phi_4311_ = _e2855;
                                }
                                let _e2858 = phi_4311_;
                                if ((_e2858 - ((((((_e2634 * 8f) * _e2744) * (0.000000059604645f * (490f / 64f))) + ((_e2751 * 19f) * ((_e2634 * (_e2688 + _e2742)) + (_e2688 * _e2742)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2634) * ((1f + _e2688) * (1f + _e2742))))) + ((_e1199 * (((_e2813 + (_e2744 * (0.000000059604645f * 4f))) + ((_e2818 * 6f) * (_e2688 + _e2742))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2688) * (1f + _e2742))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_5287_ = true;
                                } else {
                                    let _e2863 = local_4[0u].member_1[0u];
                                    let _e2869 = local_4[0u].member_1[1u];
                                    let _e2873 = (_e2863[0] + _e2869[0]);
                                    let _e2874 = (_e2863[1] + _e2869[1]);
                                    let _e2875 = (_e2863[2] + _e2869[2]);
                                    let _e2878 = local_4[0u].member_2[0u];
                                    let _e2884 = local_4[0u].member_2[1u];
                                    let _e2888 = (_e2878[0] + _e2884[0]);
                                    let _e2889 = (_e2878[1] + _e2884[1]);
                                    let _e2890 = (_e2878[2] + _e2884[2]);
                                    let _e2893 = ((_e2874 * _e2890) - (_e2875 * _e2889));
                                    let _e2896 = ((_e2875 * _e2888) - (_e2873 * _e2890));
                                    let _e2899 = ((_e2873 * _e2889) - (_e2874 * _e2888));
                                    let _e2902 = local_4[0u].member[0u];
                                    let _e2908 = local_4[0u].member_1[0u];
                                    let _e2914 = local_4[0u].member_2[0u];
                                    let _e2926 = local_4[0u].member[1u];
                                    let _e2932 = local_4[0u].member_1[1u];
                                    let _e2938 = local_4[0u].member_2[1u];
                                    local_2 = array<array<f32, 3>, 4>(_e2902, array<f32, 3>((_e2902[0] - _e2908[0]), (_e2902[1] - _e2908[1]), (_e2902[2] - _e2908[2])), array<f32, 3>((_e2902[0] - _e2914[0]), (_e2902[1] - _e2914[1]), (_e2902[2] - _e2914[2])), _e2902);
                                    local_3 = array<array<f32, 3>, 4>(_e2926, array<f32, 3>((_e2926[0] - _e2932[0]), (_e2926[1] - _e2932[1]), (_e2926[2] - _e2932[2])), array<f32, 3>((_e2926[0] - _e2938[0]), (_e2926[1] - _e2938[1]), (_e2926[2] - _e2938[2])), _e2926);
                                    let _e2956 = local_4[0u].member[0u];
                                    if (_e2956[0] < 0f) {
                                        phi_4562_ = -(_e2956[0]);
                                    } else {
                                        phi_4562_ = _e2956[0];
                                    }
                                    let _e2963 = phi_4562_;
                                    if (_e2956[1] < 0f) {
                                        phi_4569_ = -(_e2956[1]);
                                    } else {
                                        phi_4569_ = _e2956[1];
                                    }
                                    let _e2967 = phi_4569_;
                                    if (_e2963 > _e2967) {
                                        phi_4574_ = _e2963;
                                    } else {
                                        phi_4574_ = _e2967;
                                    }
                                    let _e2970 = phi_4574_;
                                    if (_e2956[2] < 0f) {
                                        phi_4581_ = -(_e2956[2]);
                                    } else {
                                        phi_4581_ = _e2956[2];
                                    }
                                    let _e2974 = phi_4581_;
                                    if (_e2970 > _e2974) {
                                        phi_4586_ = _e2970;
                                    } else {
                                        phi_4586_ = _e2974;
                                    }
                                    let _e2977 = phi_4586_;
                                    let _e2980 = local_4[0u].member[1u];
                                    if (_e2980[0] < 0f) {
                                        phi_4599_ = -(_e2980[0]);
                                    } else {
                                        phi_4599_ = _e2980[0];
                                    }
                                    let _e2987 = phi_4599_;
                                    if (_e2980[1] < 0f) {
                                        phi_4606_ = -(_e2980[1]);
                                    } else {
                                        phi_4606_ = _e2980[1];
                                    }
                                    let _e2991 = phi_4606_;
                                    if (_e2987 > _e2991) {
                                        phi_4611_ = _e2987;
                                    } else {
                                        phi_4611_ = _e2991;
                                    }
                                    let _e2994 = phi_4611_;
                                    if (_e2980[2] < 0f) {
                                        phi_4618_ = -(_e2980[2]);
                                    } else {
                                        phi_4618_ = _e2980[2];
                                    }
                                    let _e2998 = phi_4618_;
                                    if (_e2994 > _e2998) {
                                        phi_4623_ = _e2994;
                                    } else {
                                        phi_4623_ = _e2998;
                                    }
                                    let _e3001 = phi_4623_;
                                    if (_e2977 > _e3001) {
                                        phi_4628_ = _e2977;
                                    } else {
                                        phi_4628_ = _e3001;
                                    }
                                    let _e3004 = phi_4628_;
                                    let _e3006 = local_4[0u].member_3;
                                    let _e3010 = local_4[0u].member_1[0u];
                                    if (_e3010[0] < 0f) {
                                        phi_4645_ = -(_e3010[0]);
                                    } else {
                                        phi_4645_ = _e3010[0];
                                    }
                                    let _e3017 = phi_4645_;
                                    if (_e3010[1] < 0f) {
                                        phi_4652_ = -(_e3010[1]);
                                    } else {
                                        phi_4652_ = _e3010[1];
                                    }
                                    let _e3021 = phi_4652_;
                                    if (_e3017 > _e3021) {
                                        phi_4657_ = _e3017;
                                    } else {
                                        phi_4657_ = _e3021;
                                    }
                                    let _e3024 = phi_4657_;
                                    if (_e3010[2] < 0f) {
                                        phi_4664_ = -(_e3010[2]);
                                    } else {
                                        phi_4664_ = _e3010[2];
                                    }
                                    let _e3028 = phi_4664_;
                                    if (_e3024 > _e3028) {
                                        phi_4669_ = _e3024;
                                    } else {
                                        phi_4669_ = _e3028;
                                    }
                                    let _e3031 = phi_4669_;
                                    let _e3034 = local_4[0u].member_1[1u];
                                    if (_e3034[0] < 0f) {
                                        phi_4683_ = -(_e3034[0]);
                                    } else {
                                        phi_4683_ = _e3034[0];
                                    }
                                    let _e3041 = phi_4683_;
                                    if (_e3034[1] < 0f) {
                                        phi_4690_ = -(_e3034[1]);
                                    } else {
                                        phi_4690_ = _e3034[1];
                                    }
                                    let _e3045 = phi_4690_;
                                    if (_e3041 > _e3045) {
                                        phi_4695_ = _e3041;
                                    } else {
                                        phi_4695_ = _e3045;
                                    }
                                    let _e3048 = phi_4695_;
                                    if (_e3034[2] < 0f) {
                                        phi_4702_ = -(_e3034[2]);
                                    } else {
                                        phi_4702_ = _e3034[2];
                                    }
                                    let _e3052 = phi_4702_;
                                    if (_e3048 > _e3052) {
                                        phi_4707_ = _e3048;
                                    } else {
                                        phi_4707_ = _e3052;
                                    }
                                    let _e3055 = phi_4707_;
                                    if (_e3031 > _e3055) {
                                        phi_4712_ = _e3031;
                                    } else {
                                        phi_4712_ = _e3055;
                                    }
                                    let _e3058 = phi_4712_;
                                    let _e3060 = local_4[0u].member_3;
                                    let _e3064 = local_4[0u].member_2[0u];
                                    if (_e3064[0] < 0f) {
                                        phi_4729_ = -(_e3064[0]);
                                    } else {
                                        phi_4729_ = _e3064[0];
                                    }
                                    let _e3071 = phi_4729_;
                                    if (_e3064[1] < 0f) {
                                        phi_4736_ = -(_e3064[1]);
                                    } else {
                                        phi_4736_ = _e3064[1];
                                    }
                                    let _e3075 = phi_4736_;
                                    if (_e3071 > _e3075) {
                                        phi_4741_ = _e3071;
                                    } else {
                                        phi_4741_ = _e3075;
                                    }
                                    let _e3078 = phi_4741_;
                                    if (_e3064[2] < 0f) {
                                        phi_4748_ = -(_e3064[2]);
                                    } else {
                                        phi_4748_ = _e3064[2];
                                    }
                                    let _e3082 = phi_4748_;
                                    if (_e3078 > _e3082) {
                                        phi_4753_ = _e3078;
                                    } else {
                                        phi_4753_ = _e3082;
                                    }
                                    let _e3085 = phi_4753_;
                                    let _e3088 = local_4[0u].member_2[1u];
                                    if (_e3088[0] < 0f) {
                                        phi_4767_ = -(_e3088[0]);
                                    } else {
                                        phi_4767_ = _e3088[0];
                                    }
                                    let _e3095 = phi_4767_;
                                    if (_e3088[1] < 0f) {
                                        phi_4774_ = -(_e3088[1]);
                                    } else {
                                        phi_4774_ = _e3088[1];
                                    }
                                    let _e3099 = phi_4774_;
                                    if (_e3095 > _e3099) {
                                        phi_4779_ = _e3095;
                                    } else {
                                        phi_4779_ = _e3099;
                                    }
                                    let _e3102 = phi_4779_;
                                    if (_e3088[2] < 0f) {
                                        phi_4786_ = -(_e3088[2]);
                                    } else {
                                        phi_4786_ = _e3088[2];
                                    }
                                    let _e3106 = phi_4786_;
                                    if (_e3102 > _e3106) {
                                        phi_4791_ = _e3102;
                                    } else {
                                        phi_4791_ = _e3106;
                                    }
                                    let _e3109 = phi_4791_;
                                    if (_e3085 > _e3109) {
                                        phi_4796_ = _e3085;
                                    } else {
                                        phi_4796_ = _e3109;
                                    }
                                    let _e3112 = phi_4796_;
                                    let _e3114 = local_4[0u].member_3;
                                    let _e3117 = (((_e3004 + _e3006) + (_e3058 + _e3060)) + (_e3112 + _e3114));
                                    let _e3120 = local_4[0u].member_3;
                                    let _e3124 = (((_e1199 * 1.0001f) + (_e3120 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3127 = ((_e2896 * _e2875) - (_e2899 * _e2874));
                                    let _e3130 = ((_e2899 * _e2873) - (_e2893 * _e2875));
                                    let _e3133 = ((_e2893 * _e2874) - (_e2896 * _e2873));
                                    let _e3135 = local_2[0u];
                                    let _e3143 = (((_e3127 * _e3135[0]) + (_e3130 * _e3135[1])) + (_e3133 * _e3135[2]));
                                    phi_4834_ = type_37(0u, 4u);
                                    phi_4837_ = _e3143;
                                    phi_4839_ = _e3143;
                                    loop {
                                        let _e3145 = phi_4834_;
                                        let _e3147 = phi_4837_;
                                        let _e3149 = phi_4839_;
                                        local_36 = _e3147;
                                        local_37 = _e3149;
                                        local_52 = _e3149;
                                        if (_e3145.member < _e3145.member_1) {
                                            phi_4835_ = type_37((_e3145.member + 1u), _e3145.member_1);
                                            phi_4862_ = type_37(1u, _e3145.member);
                                        } else {
                                            phi_4835_ = _e3145;
                                            phi_4862_ = type_37(0u, type_37().member_1);
                                        }
                                        let _e3163 = phi_4835_;
                                        let _e3165 = phi_4862_;
                                        let _e3169 = (bitcast<i32>(_e3165.member) != 0i);
                                        if _e3169 {
                                            if (_e3165.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3172 = local_2[_e3165.member_1];
                                            let _e3180 = (((_e3127 * _e3172[0]) + (_e3130 * _e3172[1])) + (_e3133 * _e3172[2]));
                                            if (_e3165.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3183 = local_3[_e3165.member_1];
                                            let _e3191 = (((_e3127 * _e3183[0]) + (_e3130 * _e3183[1])) + (_e3133 * _e3183[2]));
                                            if (_e3149 < _e3180) {
                                                phi_4912_ = _e3149;
                                            } else {
                                                phi_4912_ = _e3180;
                                            }
                                            let _e3194 = phi_4912_;
                                            if (_e3194 < _e3191) {
                                                phi_4917_ = _e3194;
                                            } else {
                                                phi_4917_ = _e3191;
                                            }
                                            let _e3197 = phi_4917_;
                                            if (_e3147 > _e3180) {
                                                phi_4922_ = _e3147;
                                            } else {
                                                phi_4922_ = _e3180;
                                            }
                                            let _e3200 = phi_4922_;
                                            if (_e3200 > _e3191) {
                                                phi_4927_ = _e3200;
                                            } else {
                                                phi_4927_ = _e3191;
                                            }
                                            let _e3203 = phi_4927_;
                                            phi_4838_ = _e3203;
                                            phi_4840_ = _e3197;
                                        } else {
                                            phi_4838_ = f32();
                                            phi_4840_ = f32();
                                        }
                                        let _e3205 = phi_4838_;
                                        let _e3207 = phi_4840_;
                                        continue;
                                        continuing {
                                            phi_4834_ = _e3163;
                                            phi_4837_ = _e3205;
                                            phi_4839_ = _e3207;
                                            break if !(_e3169);
                                        }
                                    }
                                    if (_e3127 < 0f) {
                                        phi_4933_ = -(_e3127);
                                    } else {
                                        phi_4933_ = _e3127;
                                    }
                                    let _e3212 = phi_4933_;
                                    if (_e3130 < 0f) {
                                        phi_4939_ = -(_e3130);
                                    } else {
                                        phi_4939_ = _e3130;
                                    }
                                    let _e3216 = phi_4939_;
                                    if (_e3133 < 0f) {
                                        phi_4946_ = -(_e3133);
                                    } else {
                                        phi_4946_ = _e3133;
                                    }
                                    let _e3221 = phi_4946_;
                                    let _e3222 = ((_e3212 + _e3216) + _e3221);
                                    let _e3227 = local_36;
                                    let _e3228 = -(_e3227);
                                    let _e3230 = local_37;
                                    if (_e3230 > _e3228) {
                                        let _e5012 = local_52;
                                        phi_4956_ = _e5012;
                                    } else {
                                        phi_4956_ = _e3228;
                                    }
                                    let _e3233 = phi_4956_;
                                    let _e3238 = (((_e3233 - ((_e3222 * _e3117) * (0.000000059604645f * 17f))) - (_e3222 * _e3124)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3241 = ((_e2896 * _e2890) - (_e2899 * _e2889));
                                    let _e3244 = ((_e2899 * _e2888) - (_e2893 * _e2890));
                                    let _e3247 = ((_e2893 * _e2889) - (_e2896 * _e2888));
                                    let _e3249 = local_2[0u];
                                    let _e3257 = (((_e3241 * _e3249[0]) + (_e3244 * _e3249[1])) + (_e3247 * _e3249[2]));
                                    phi_4987_ = type_37(0u, 4u);
                                    phi_4990_ = _e3257;
                                    phi_4992_ = _e3257;
                                    loop {
                                        let _e3259 = phi_4987_;
                                        let _e3261 = phi_4990_;
                                        let _e3263 = phi_4992_;
                                        local_38 = _e3261;
                                        local_39 = _e3263;
                                        local_53 = _e3263;
                                        if (_e3259.member < _e3259.member_1) {
                                            phi_4988_ = type_37((_e3259.member + 1u), _e3259.member_1);
                                            phi_5015_ = type_37(1u, _e3259.member);
                                        } else {
                                            phi_4988_ = _e3259;
                                            phi_5015_ = type_37(0u, type_37().member_1);
                                        }
                                        let _e3277 = phi_4988_;
                                        let _e3279 = phi_5015_;
                                        let _e3283 = (bitcast<i32>(_e3279.member) != 0i);
                                        if _e3283 {
                                            if (_e3279.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3286 = local_2[_e3279.member_1];
                                            let _e3294 = (((_e3241 * _e3286[0]) + (_e3244 * _e3286[1])) + (_e3247 * _e3286[2]));
                                            if (_e3279.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3297 = local_3[_e3279.member_1];
                                            let _e3305 = (((_e3241 * _e3297[0]) + (_e3244 * _e3297[1])) + (_e3247 * _e3297[2]));
                                            if (_e3263 < _e3294) {
                                                phi_5065_ = _e3263;
                                            } else {
                                                phi_5065_ = _e3294;
                                            }
                                            let _e3308 = phi_5065_;
                                            if (_e3308 < _e3305) {
                                                phi_5070_ = _e3308;
                                            } else {
                                                phi_5070_ = _e3305;
                                            }
                                            let _e3311 = phi_5070_;
                                            if (_e3261 > _e3294) {
                                                phi_5075_ = _e3261;
                                            } else {
                                                phi_5075_ = _e3294;
                                            }
                                            let _e3314 = phi_5075_;
                                            if (_e3314 > _e3305) {
                                                phi_5080_ = _e3314;
                                            } else {
                                                phi_5080_ = _e3305;
                                            }
                                            let _e3317 = phi_5080_;
                                            phi_4991_ = _e3317;
                                            phi_4993_ = _e3311;
                                        } else {
                                            phi_4991_ = f32();
                                            phi_4993_ = f32();
                                        }
                                        let _e3319 = phi_4991_;
                                        let _e3321 = phi_4993_;
                                        continue;
                                        continuing {
                                            phi_4987_ = _e3277;
                                            phi_4990_ = _e3319;
                                            phi_4992_ = _e3321;
                                            break if !(_e3283);
                                        }
                                    }
                                    if (_e3241 < 0f) {
                                        phi_5086_ = -(_e3241);
                                    } else {
                                        phi_5086_ = _e3241;
                                    }
                                    let _e3326 = phi_5086_;
                                    if (_e3244 < 0f) {
                                        phi_5092_ = -(_e3244);
                                    } else {
                                        phi_5092_ = _e3244;
                                    }
                                    let _e3330 = phi_5092_;
                                    if (_e3247 < 0f) {
                                        phi_5099_ = -(_e3247);
                                    } else {
                                        phi_5099_ = _e3247;
                                    }
                                    let _e3335 = phi_5099_;
                                    let _e3336 = ((_e3326 + _e3330) + _e3335);
                                    let _e3341 = local_38;
                                    let _e3342 = -(_e3341);
                                    let _e3344 = local_39;
                                    if (_e3344 > _e3342) {
                                        let _e5031 = local_53;
                                        phi_5109_ = _e5031;
                                    } else {
                                        phi_5109_ = _e3342;
                                    }
                                    let _e3347 = phi_5109_;
                                    let _e3352 = (((_e3347 - ((_e3336 * _e3117) * (0.000000059604645f * 17f))) - (_e3336 * _e3124)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3238 > _e3352) {
                                        phi_5119_ = _e3238;
                                    } else {
                                        phi_5119_ = _e3352;
                                    }
                                    let _e3355 = phi_5119_;
                                    let _e3356 = (_e2888 - _e2873);
                                    let _e3357 = (_e2889 - _e2874);
                                    let _e3358 = (_e2890 - _e2875);
                                    let _e3361 = ((_e2896 * _e3358) - (_e2899 * _e3357));
                                    let _e3364 = ((_e2899 * _e3356) - (_e2893 * _e3358));
                                    let _e3367 = ((_e2893 * _e3357) - (_e2896 * _e3356));
                                    let _e3369 = local_2[0u];
                                    let _e3377 = (((_e3361 * _e3369[0]) + (_e3364 * _e3369[1])) + (_e3367 * _e3369[2]));
                                    phi_5152_ = type_37(0u, 4u);
                                    phi_5155_ = _e3377;
                                    phi_5157_ = _e3377;
                                    loop {
                                        let _e3379 = phi_5152_;
                                        let _e3381 = phi_5155_;
                                        let _e3383 = phi_5157_;
                                        local_40 = _e3381;
                                        local_41 = _e3383;
                                        local_54 = _e3383;
                                        if (_e3379.member < _e3379.member_1) {
                                            phi_5153_ = type_37((_e3379.member + 1u), _e3379.member_1);
                                            phi_5180_ = type_37(1u, _e3379.member);
                                        } else {
                                            phi_5153_ = _e3379;
                                            phi_5180_ = type_37(0u, type_37().member_1);
                                        }
                                        let _e3397 = phi_5153_;
                                        let _e3399 = phi_5180_;
                                        let _e3403 = (bitcast<i32>(_e3399.member) != 0i);
                                        if _e3403 {
                                            if (_e3399.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3406 = local_2[_e3399.member_1];
                                            let _e3414 = (((_e3361 * _e3406[0]) + (_e3364 * _e3406[1])) + (_e3367 * _e3406[2]));
                                            if (_e3399.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3417 = local_3[_e3399.member_1];
                                            let _e3425 = (((_e3361 * _e3417[0]) + (_e3364 * _e3417[1])) + (_e3367 * _e3417[2]));
                                            if (_e3383 < _e3414) {
                                                phi_5230_ = _e3383;
                                            } else {
                                                phi_5230_ = _e3414;
                                            }
                                            let _e3428 = phi_5230_;
                                            if (_e3428 < _e3425) {
                                                phi_5235_ = _e3428;
                                            } else {
                                                phi_5235_ = _e3425;
                                            }
                                            let _e3431 = phi_5235_;
                                            if (_e3381 > _e3414) {
                                                phi_5240_ = _e3381;
                                            } else {
                                                phi_5240_ = _e3414;
                                            }
                                            let _e3434 = phi_5240_;
                                            if (_e3434 > _e3425) {
                                                phi_5245_ = _e3434;
                                            } else {
                                                phi_5245_ = _e3425;
                                            }
                                            let _e3437 = phi_5245_;
                                            phi_5156_ = _e3437;
                                            phi_5158_ = _e3431;
                                        } else {
                                            phi_5156_ = f32();
                                            phi_5158_ = f32();
                                        }
                                        let _e3439 = phi_5156_;
                                        let _e3441 = phi_5158_;
                                        continue;
                                        continuing {
                                            phi_5152_ = _e3397;
                                            phi_5155_ = _e3439;
                                            phi_5157_ = _e3441;
                                            break if !(_e3403);
                                        }
                                    }
                                    if (_e3361 < 0f) {
                                        phi_5251_ = -(_e3361);
                                    } else {
                                        phi_5251_ = _e3361;
                                    }
                                    let _e3446 = phi_5251_;
                                    if (_e3364 < 0f) {
                                        phi_5257_ = -(_e3364);
                                    } else {
                                        phi_5257_ = _e3364;
                                    }
                                    let _e3450 = phi_5257_;
                                    if (_e3367 < 0f) {
                                        phi_5264_ = -(_e3367);
                                    } else {
                                        phi_5264_ = _e3367;
                                    }
                                    let _e3455 = phi_5264_;
                                    let _e3456 = ((_e3446 + _e3450) + _e3455);
                                    let _e3461 = local_40;
                                    let _e3462 = -(_e3461);
                                    let _e3464 = local_41;
                                    if (_e3464 > _e3462) {
                                        let _e5051 = local_54;
                                        phi_5274_ = _e5051;
                                    } else {
                                        phi_5274_ = _e3462;
                                    }
                                    let _e3467 = phi_5274_;
                                    let _e3472 = (((_e3467 - ((_e3456 * _e3117) * (0.000000059604645f * 17f))) - (_e3456 * _e3124)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3355 > _e3472) {
                                        phi_5284_ = _e3355;
                                    } else {
                                        phi_5284_ = _e3472;
                                    }
                                    let _e3475 = phi_5284_;
                                    phi_5287_ = (_e3475 > 0f);
                                }
                                let _e3478 = phi_5287_;
                                if _e3478 {
                                    let _e3482 = local_4[1u].member_1[0u];
                                    let _e3488 = local_4[1u].member_2[0u];
                                    let _e3494 = ((_e3482[1] * _e3488[2]) - (_e3482[2] * _e3488[1]));
                                    let _e3497 = ((_e3482[2] * _e3488[0]) - (_e3482[0] * _e3488[2]));
                                    let _e3500 = ((_e3482[0] * _e3488[1]) - (_e3482[1] * _e3488[0]));
                                    let _e3503 = local_4[1u].member_1[1u];
                                    let _e3509 = local_4[1u].member_2[1u];
                                    let _e3515 = ((_e3503[1] * _e3509[2]) - (_e3503[2] * _e3509[1]));
                                    let _e3518 = ((_e3503[2] * _e3509[0]) - (_e3503[0] * _e3509[2]));
                                    let _e3521 = ((_e3503[0] * _e3509[1]) - (_e3503[1] * _e3509[0]));
                                    let _e3524 = local_4[1u].member_1[0u];
                                    let _e3530 = local_4[1u].member_2[1u];
                                    let _e3545 = local_4[1u].member_1[1u];
                                    let _e3551 = local_4[1u].member_2[0u];
                                    let _e3564 = (((_e3524[1] * _e3530[2]) - (_e3524[2] * _e3530[1])) + ((_e3545[1] * _e3551[2]) - (_e3545[2] * _e3551[1])));
                                    let _e3565 = (((_e3524[2] * _e3530[0]) - (_e3524[0] * _e3530[2])) + ((_e3545[2] * _e3551[0]) - (_e3545[0] * _e3551[2])));
                                    let _e3566 = (((_e3524[0] * _e3530[1]) - (_e3524[1] * _e3530[0])) + ((_e3545[0] * _e3551[1]) - (_e3545[1] * _e3551[0])));
                                    let _e3569 = local_4[1u].member[0u];
                                    let _e3580 = local_4[1u].member[1u];
                                    let _e3591 = local_4[1u].member[0u];
                                    let _e3600 = ((((_e3580[0] * _e3494) + (_e3580[1] * _e3497)) + (_e3580[2] * _e3500)) + (((_e3591[0] * _e3564) + (_e3591[1] * _e3565)) + (_e3591[2] * _e3566)));
                                    let _e3603 = local_4[1u].member[0u];
                                    let _e3614 = local_4[1u].member[1u];
                                    let _e3623 = ((((_e3603[0] * _e3515) + (_e3603[1] * _e3518)) + (_e3603[2] * _e3521)) + (((_e3614[0] * _e3564) + (_e3614[1] * _e3565)) + (_e3614[2] * _e3566)));
                                    let _e3626 = local_4[1u].member[1u];
                                    let _e3637 = local_4[1u].member[0u];
                                    if (_e3637[0] < 0f) {
                                        phi_5533_ = -(_e3637[0]);
                                    } else {
                                        phi_5533_ = _e3637[0];
                                    }
                                    let _e3644 = phi_5533_;
                                    if (_e3637[1] < 0f) {
                                        phi_5540_ = -(_e3637[1]);
                                    } else {
                                        phi_5540_ = _e3637[1];
                                    }
                                    let _e3648 = phi_5540_;
                                    if (_e3644 > _e3648) {
                                        phi_5545_ = _e3644;
                                    } else {
                                        phi_5545_ = _e3648;
                                    }
                                    let _e3651 = phi_5545_;
                                    if (_e3637[2] < 0f) {
                                        phi_5552_ = -(_e3637[2]);
                                    } else {
                                        phi_5552_ = _e3637[2];
                                    }
                                    let _e3655 = phi_5552_;
                                    if (_e3651 > _e3655) {
                                        phi_5557_ = _e3651;
                                    } else {
                                        phi_5557_ = _e3655;
                                    }
                                    let _e3658 = phi_5557_;
                                    let _e3661 = local_4[1u].member[1u];
                                    if (_e3661[0] < 0f) {
                                        phi_5570_ = -(_e3661[0]);
                                    } else {
                                        phi_5570_ = _e3661[0];
                                    }
                                    let _e3668 = phi_5570_;
                                    if (_e3661[1] < 0f) {
                                        phi_5577_ = -(_e3661[1]);
                                    } else {
                                        phi_5577_ = _e3661[1];
                                    }
                                    let _e3672 = phi_5577_;
                                    if (_e3668 > _e3672) {
                                        phi_5582_ = _e3668;
                                    } else {
                                        phi_5582_ = _e3672;
                                    }
                                    let _e3675 = phi_5582_;
                                    if (_e3661[2] < 0f) {
                                        phi_5589_ = -(_e3661[2]);
                                    } else {
                                        phi_5589_ = _e3661[2];
                                    }
                                    let _e3679 = phi_5589_;
                                    if (_e3675 > _e3679) {
                                        phi_5594_ = _e3675;
                                    } else {
                                        phi_5594_ = _e3679;
                                    }
                                    let _e3682 = phi_5594_;
                                    if (_e3658 > _e3682) {
                                        phi_5599_ = _e3658;
                                    } else {
                                        phi_5599_ = _e3682;
                                    }
                                    let _e3685 = phi_5599_;
                                    let _e3687 = local_4[1u].member_3;
                                    let _e3688 = (_e3685 + _e3687);
                                    let _e3691 = local_4[1u].member_1[0u];
                                    if (_e3691[0] < 0f) {
                                        phi_5616_ = -(_e3691[0]);
                                    } else {
                                        phi_5616_ = _e3691[0];
                                    }
                                    let _e3698 = phi_5616_;
                                    if (_e3691[1] < 0f) {
                                        phi_5623_ = -(_e3691[1]);
                                    } else {
                                        phi_5623_ = _e3691[1];
                                    }
                                    let _e3702 = phi_5623_;
                                    if (_e3698 > _e3702) {
                                        phi_5628_ = _e3698;
                                    } else {
                                        phi_5628_ = _e3702;
                                    }
                                    let _e3705 = phi_5628_;
                                    if (_e3691[2] < 0f) {
                                        phi_5635_ = -(_e3691[2]);
                                    } else {
                                        phi_5635_ = _e3691[2];
                                    }
                                    let _e3709 = phi_5635_;
                                    if (_e3705 > _e3709) {
                                        phi_5640_ = _e3705;
                                    } else {
                                        phi_5640_ = _e3709;
                                    }
                                    let _e3712 = phi_5640_;
                                    let _e3715 = local_4[1u].member_1[1u];
                                    if (_e3715[0] < 0f) {
                                        phi_5654_ = -(_e3715[0]);
                                    } else {
                                        phi_5654_ = _e3715[0];
                                    }
                                    let _e3722 = phi_5654_;
                                    if (_e3715[1] < 0f) {
                                        phi_5661_ = -(_e3715[1]);
                                    } else {
                                        phi_5661_ = _e3715[1];
                                    }
                                    let _e3726 = phi_5661_;
                                    if (_e3722 > _e3726) {
                                        phi_5666_ = _e3722;
                                    } else {
                                        phi_5666_ = _e3726;
                                    }
                                    let _e3729 = phi_5666_;
                                    if (_e3715[2] < 0f) {
                                        phi_5673_ = -(_e3715[2]);
                                    } else {
                                        phi_5673_ = _e3715[2];
                                    }
                                    let _e3733 = phi_5673_;
                                    if (_e3729 > _e3733) {
                                        phi_5678_ = _e3729;
                                    } else {
                                        phi_5678_ = _e3733;
                                    }
                                    let _e3736 = phi_5678_;
                                    if (_e3712 > _e3736) {
                                        phi_5683_ = _e3712;
                                    } else {
                                        phi_5683_ = _e3736;
                                    }
                                    let _e3739 = phi_5683_;
                                    let _e3741 = local_4[1u].member_3;
                                    let _e3742 = (_e3739 + _e3741);
                                    let _e3745 = local_4[1u].member_2[0u];
                                    if (_e3745[0] < 0f) {
                                        phi_5700_ = -(_e3745[0]);
                                    } else {
                                        phi_5700_ = _e3745[0];
                                    }
                                    let _e3752 = phi_5700_;
                                    if (_e3745[1] < 0f) {
                                        phi_5707_ = -(_e3745[1]);
                                    } else {
                                        phi_5707_ = _e3745[1];
                                    }
                                    let _e3756 = phi_5707_;
                                    if (_e3752 > _e3756) {
                                        phi_5712_ = _e3752;
                                    } else {
                                        phi_5712_ = _e3756;
                                    }
                                    let _e3759 = phi_5712_;
                                    if (_e3745[2] < 0f) {
                                        phi_5719_ = -(_e3745[2]);
                                    } else {
                                        phi_5719_ = _e3745[2];
                                    }
                                    let _e3763 = phi_5719_;
                                    if (_e3759 > _e3763) {
                                        phi_5724_ = _e3759;
                                    } else {
                                        phi_5724_ = _e3763;
                                    }
                                    let _e3766 = phi_5724_;
                                    let _e3769 = local_4[1u].member_2[1u];
                                    if (_e3769[0] < 0f) {
                                        phi_5738_ = -(_e3769[0]);
                                    } else {
                                        phi_5738_ = _e3769[0];
                                    }
                                    let _e3776 = phi_5738_;
                                    if (_e3769[1] < 0f) {
                                        phi_5745_ = -(_e3769[1]);
                                    } else {
                                        phi_5745_ = _e3769[1];
                                    }
                                    let _e3780 = phi_5745_;
                                    if (_e3776 > _e3780) {
                                        phi_5750_ = _e3776;
                                    } else {
                                        phi_5750_ = _e3780;
                                    }
                                    let _e3783 = phi_5750_;
                                    if (_e3769[2] < 0f) {
                                        phi_5757_ = -(_e3769[2]);
                                    } else {
                                        phi_5757_ = _e3769[2];
                                    }
                                    let _e3787 = phi_5757_;
                                    if (_e3783 > _e3787) {
                                        phi_5762_ = _e3783;
                                    } else {
                                        phi_5762_ = _e3787;
                                    }
                                    let _e3790 = phi_5762_;
                                    if (_e3766 > _e3790) {
                                        phi_5767_ = _e3766;
                                    } else {
                                        phi_5767_ = _e3790;
                                    }
                                    let _e3793 = phi_5767_;
                                    let _e3795 = local_4[1u].member_3;
                                    let _e3796 = (_e3793 + _e3795);
                                    let _e3798 = ((_e3742 * 8f) * _e3796);
                                    let _e3805 = local_4[1u].member_3;
                                    if (_e3494 < 0f) {
                                        phi_5798_ = -(_e3494);
                                    } else {
                                        phi_5798_ = _e3494;
                                    }
                                    let _e3822 = phi_5798_;
                                    if (_e3497 < 0f) {
                                        phi_5804_ = -(_e3497);
                                    } else {
                                        phi_5804_ = _e3497;
                                    }
                                    let _e3826 = phi_5804_;
                                    if (_e3500 < 0f) {
                                        phi_5811_ = -(_e3500);
                                    } else {
                                        phi_5811_ = _e3500;
                                    }
                                    let _e3831 = phi_5811_;
                                    let _e3832 = ((_e3822 + _e3826) + _e3831);
                                    if (_e3515 < 0f) {
                                        phi_5818_ = -(_e3515);
                                    } else {
                                        phi_5818_ = _e3515;
                                    }
                                    let _e3836 = phi_5818_;
                                    if (_e3518 < 0f) {
                                        phi_5824_ = -(_e3518);
                                    } else {
                                        phi_5824_ = _e3518;
                                    }
                                    let _e3840 = phi_5824_;
                                    if (_e3521 < 0f) {
                                        phi_5831_ = -(_e3521);
                                    } else {
                                        phi_5831_ = _e3521;
                                    }
                                    let _e3845 = phi_5831_;
                                    let _e3846 = ((_e3836 + _e3840) + _e3845);
                                    if (_e3832 > _e3846) {
                                        phi_5837_ = _e3832;
                                    } else {
                                        phi_5837_ = _e3846;
                                    }
                                    let _e3849 = phi_5837_;
                                    if (_e3564 < 0f) {
                                        phi_5843_ = -(_e3564);
                                    } else {
                                        phi_5843_ = _e3564;
                                    }
                                    let _e3853 = phi_5843_;
                                    if (_e3565 < 0f) {
                                        phi_5849_ = -(_e3565);
                                    } else {
                                        phi_5849_ = _e3565;
                                    }
                                    let _e3857 = phi_5849_;
                                    if (_e3566 < 0f) {
                                        phi_5856_ = -(_e3566);
                                    } else {
                                        phi_5856_ = _e3566;
                                    }
                                    let _e3862 = phi_5856_;
                                    let _e3864 = (((_e3853 + _e3857) + _e3862) * 0.5f);
                                    if (_e3849 > _e3864) {
                                        phi_5863_ = _e3849;
                                    } else {
                                        phi_5863_ = _e3864;
                                    }
                                    let _e3867 = phi_5863_;
                                    let _e3872 = local_4[1u].member_3;
                                    let _e3885 = ((((_e3569[0] * _e3494) + (_e3569[1] * _e3497)) + (_e3569[2] * _e3500)) * 3f);
                                    let _e3886 = ((((_e3626[0] * _e3515) + (_e3626[1] * _e3518)) + (_e3626[2] * _e3521)) * 3f);
                                    if (_e3885 < _e3886) {
                                        phi_5887_ = _e3885;
                                    } else {
                                        phi_5887_ = _e3886;
                                    }
                                    let _e3889 = phi_5887_;
                                    if (_e3600 < _e3623) {
                                        phi_5892_ = _e3600;
                                    } else {
                                        phi_5892_ = _e3623;
                                    }
                                    let _e3892 = phi_5892_;
                                    if (_e3889 < _e3892) {
                                        phi_5897_ = _e3889;
                                    } else {
                                        phi_5897_ = _e3892;
                                    }
                                    let _e3895 = phi_5897_;
                                    if (_e3885 > _e3886) {
                                        phi_5902_ = _e3885;
                                    } else {
                                        phi_5902_ = _e3886;
                                    }
                                    let _e3898 = phi_5902_;
                                    if (_e3600 > _e3623) {
                                        phi_5907_ = _e3600;
                                    } else {
                                        phi_5907_ = _e3623;
                                    }
                                    let _e3901 = phi_5907_;
                                    if (_e3898 > _e3901) {
                                        phi_5912_ = _e3898;
                                    } else {
                                        phi_5912_ = _e3901;
                                    }
                                    let _e3904 = phi_5912_;
                                    let _e3909 = -(_e3904);
                                    if (_e3895 > _e3909) {
                                        phi_5922_ = _e3895;
                                    } else {
                                        phi_5922_ = _e3909;
                                    }
                                    let _e3912 = phi_5922_;
                                    if ((_e3912 - ((((((_e3688 * 8f) * _e3798) * (0.000000059604645f * (490f / 64f))) + ((_e3805 * 19f) * ((_e3688 * (_e3742 + _e3796)) + (_e3742 * _e3796)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3688) * ((1f + _e3742) * (1f + _e3796))))) + ((_e1199 * (((_e3867 + (_e3798 * (0.000000059604645f * 4f))) + ((_e3872 * 6f) * (_e3742 + _e3796))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3742) * (1f + _e3796))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_6898_ = true;
                                    } else {
                                        let _e3917 = local_4[1u].member_1[0u];
                                        let _e3923 = local_4[1u].member_1[1u];
                                        let _e3927 = (_e3917[0] + _e3923[0]);
                                        let _e3928 = (_e3917[1] + _e3923[1]);
                                        let _e3929 = (_e3917[2] + _e3923[2]);
                                        let _e3932 = local_4[1u].member_2[0u];
                                        let _e3938 = local_4[1u].member_2[1u];
                                        let _e3942 = (_e3932[0] + _e3938[0]);
                                        let _e3943 = (_e3932[1] + _e3938[1]);
                                        let _e3944 = (_e3932[2] + _e3938[2]);
                                        let _e3947 = ((_e3928 * _e3944) - (_e3929 * _e3943));
                                        let _e3950 = ((_e3929 * _e3942) - (_e3927 * _e3944));
                                        let _e3953 = ((_e3927 * _e3943) - (_e3928 * _e3942));
                                        let _e3956 = local_4[1u].member[0u];
                                        let _e3962 = local_4[1u].member_1[0u];
                                        let _e3968 = local_4[1u].member_2[0u];
                                        let _e3980 = local_4[1u].member[1u];
                                        let _e3986 = local_4[1u].member_1[1u];
                                        let _e3992 = local_4[1u].member_2[1u];
                                        local = array<array<f32, 3>, 4>(_e3956, array<f32, 3>((_e3956[0] - _e3962[0]), (_e3956[1] - _e3962[1]), (_e3956[2] - _e3962[2])), array<f32, 3>((_e3956[0] - _e3968[0]), (_e3956[1] - _e3968[1]), (_e3956[2] - _e3968[2])), _e3956);
                                        local_1 = array<array<f32, 3>, 4>(_e3980, array<f32, 3>((_e3980[0] - _e3986[0]), (_e3980[1] - _e3986[1]), (_e3980[2] - _e3986[2])), array<f32, 3>((_e3980[0] - _e3992[0]), (_e3980[1] - _e3992[1]), (_e3980[2] - _e3992[2])), _e3980);
                                        let _e4010 = local_4[1u].member[0u];
                                        if (_e4010[0] < 0f) {
                                            phi_6173_ = -(_e4010[0]);
                                        } else {
                                            phi_6173_ = _e4010[0];
                                        }
                                        let _e4017 = phi_6173_;
                                        if (_e4010[1] < 0f) {
                                            phi_6180_ = -(_e4010[1]);
                                        } else {
                                            phi_6180_ = _e4010[1];
                                        }
                                        let _e4021 = phi_6180_;
                                        if (_e4017 > _e4021) {
                                            phi_6185_ = _e4017;
                                        } else {
                                            phi_6185_ = _e4021;
                                        }
                                        let _e4024 = phi_6185_;
                                        if (_e4010[2] < 0f) {
                                            phi_6192_ = -(_e4010[2]);
                                        } else {
                                            phi_6192_ = _e4010[2];
                                        }
                                        let _e4028 = phi_6192_;
                                        if (_e4024 > _e4028) {
                                            phi_6197_ = _e4024;
                                        } else {
                                            phi_6197_ = _e4028;
                                        }
                                        let _e4031 = phi_6197_;
                                        let _e4034 = local_4[1u].member[1u];
                                        if (_e4034[0] < 0f) {
                                            phi_6210_ = -(_e4034[0]);
                                        } else {
                                            phi_6210_ = _e4034[0];
                                        }
                                        let _e4041 = phi_6210_;
                                        if (_e4034[1] < 0f) {
                                            phi_6217_ = -(_e4034[1]);
                                        } else {
                                            phi_6217_ = _e4034[1];
                                        }
                                        let _e4045 = phi_6217_;
                                        if (_e4041 > _e4045) {
                                            phi_6222_ = _e4041;
                                        } else {
                                            phi_6222_ = _e4045;
                                        }
                                        let _e4048 = phi_6222_;
                                        if (_e4034[2] < 0f) {
                                            phi_6229_ = -(_e4034[2]);
                                        } else {
                                            phi_6229_ = _e4034[2];
                                        }
                                        let _e4052 = phi_6229_;
                                        if (_e4048 > _e4052) {
                                            phi_6234_ = _e4048;
                                        } else {
                                            phi_6234_ = _e4052;
                                        }
                                        let _e4055 = phi_6234_;
                                        if (_e4031 > _e4055) {
                                            phi_6239_ = _e4031;
                                        } else {
                                            phi_6239_ = _e4055;
                                        }
                                        let _e4058 = phi_6239_;
                                        let _e4060 = local_4[1u].member_3;
                                        let _e4064 = local_4[1u].member_1[0u];
                                        if (_e4064[0] < 0f) {
                                            phi_6256_ = -(_e4064[0]);
                                        } else {
                                            phi_6256_ = _e4064[0];
                                        }
                                        let _e4071 = phi_6256_;
                                        if (_e4064[1] < 0f) {
                                            phi_6263_ = -(_e4064[1]);
                                        } else {
                                            phi_6263_ = _e4064[1];
                                        }
                                        let _e4075 = phi_6263_;
                                        if (_e4071 > _e4075) {
                                            phi_6268_ = _e4071;
                                        } else {
                                            phi_6268_ = _e4075;
                                        }
                                        let _e4078 = phi_6268_;
                                        if (_e4064[2] < 0f) {
                                            phi_6275_ = -(_e4064[2]);
                                        } else {
                                            phi_6275_ = _e4064[2];
                                        }
                                        let _e4082 = phi_6275_;
                                        if (_e4078 > _e4082) {
                                            phi_6280_ = _e4078;
                                        } else {
                                            phi_6280_ = _e4082;
                                        }
                                        let _e4085 = phi_6280_;
                                        let _e4088 = local_4[1u].member_1[1u];
                                        if (_e4088[0] < 0f) {
                                            phi_6294_ = -(_e4088[0]);
                                        } else {
                                            phi_6294_ = _e4088[0];
                                        }
                                        let _e4095 = phi_6294_;
                                        if (_e4088[1] < 0f) {
                                            phi_6301_ = -(_e4088[1]);
                                        } else {
                                            phi_6301_ = _e4088[1];
                                        }
                                        let _e4099 = phi_6301_;
                                        if (_e4095 > _e4099) {
                                            phi_6306_ = _e4095;
                                        } else {
                                            phi_6306_ = _e4099;
                                        }
                                        let _e4102 = phi_6306_;
                                        if (_e4088[2] < 0f) {
                                            phi_6313_ = -(_e4088[2]);
                                        } else {
                                            phi_6313_ = _e4088[2];
                                        }
                                        let _e4106 = phi_6313_;
                                        if (_e4102 > _e4106) {
                                            phi_6318_ = _e4102;
                                        } else {
                                            phi_6318_ = _e4106;
                                        }
                                        let _e4109 = phi_6318_;
                                        if (_e4085 > _e4109) {
                                            phi_6323_ = _e4085;
                                        } else {
                                            phi_6323_ = _e4109;
                                        }
                                        let _e4112 = phi_6323_;
                                        let _e4114 = local_4[1u].member_3;
                                        let _e4118 = local_4[1u].member_2[0u];
                                        if (_e4118[0] < 0f) {
                                            phi_6340_ = -(_e4118[0]);
                                        } else {
                                            phi_6340_ = _e4118[0];
                                        }
                                        let _e4125 = phi_6340_;
                                        if (_e4118[1] < 0f) {
                                            phi_6347_ = -(_e4118[1]);
                                        } else {
                                            phi_6347_ = _e4118[1];
                                        }
                                        let _e4129 = phi_6347_;
                                        if (_e4125 > _e4129) {
                                            phi_6352_ = _e4125;
                                        } else {
                                            phi_6352_ = _e4129;
                                        }
                                        let _e4132 = phi_6352_;
                                        if (_e4118[2] < 0f) {
                                            phi_6359_ = -(_e4118[2]);
                                        } else {
                                            phi_6359_ = _e4118[2];
                                        }
                                        let _e4136 = phi_6359_;
                                        if (_e4132 > _e4136) {
                                            phi_6364_ = _e4132;
                                        } else {
                                            phi_6364_ = _e4136;
                                        }
                                        let _e4139 = phi_6364_;
                                        let _e4142 = local_4[1u].member_2[1u];
                                        if (_e4142[0] < 0f) {
                                            phi_6378_ = -(_e4142[0]);
                                        } else {
                                            phi_6378_ = _e4142[0];
                                        }
                                        let _e4149 = phi_6378_;
                                        if (_e4142[1] < 0f) {
                                            phi_6385_ = -(_e4142[1]);
                                        } else {
                                            phi_6385_ = _e4142[1];
                                        }
                                        let _e4153 = phi_6385_;
                                        if (_e4149 > _e4153) {
                                            phi_6390_ = _e4149;
                                        } else {
                                            phi_6390_ = _e4153;
                                        }
                                        let _e4156 = phi_6390_;
                                        if (_e4142[2] < 0f) {
                                            phi_6397_ = -(_e4142[2]);
                                        } else {
                                            phi_6397_ = _e4142[2];
                                        }
                                        let _e4160 = phi_6397_;
                                        if (_e4156 > _e4160) {
                                            phi_6402_ = _e4156;
                                        } else {
                                            phi_6402_ = _e4160;
                                        }
                                        let _e4163 = phi_6402_;
                                        if (_e4139 > _e4163) {
                                            phi_6407_ = _e4139;
                                        } else {
                                            phi_6407_ = _e4163;
                                        }
                                        let _e4166 = phi_6407_;
                                        let _e4168 = local_4[1u].member_3;
                                        let _e4171 = (((_e4058 + _e4060) + (_e4112 + _e4114)) + (_e4166 + _e4168));
                                        let _e4174 = local_4[1u].member_3;
                                        let _e4178 = (((_e1199 * 1.0001f) + (_e4174 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4181 = ((_e3950 * _e3929) - (_e3953 * _e3928));
                                        let _e4184 = ((_e3953 * _e3927) - (_e3947 * _e3929));
                                        let _e4187 = ((_e3947 * _e3928) - (_e3950 * _e3927));
                                        let _e4189 = local[0u];
                                        let _e4197 = (((_e4181 * _e4189[0]) + (_e4184 * _e4189[1])) + (_e4187 * _e4189[2]));
                                        phi_6445_ = type_37(0u, 4u);
                                        phi_6448_ = _e4197;
                                        phi_6450_ = _e4197;
                                        loop {
                                            let _e4199 = phi_6445_;
                                            let _e4201 = phi_6448_;
                                            let _e4203 = phi_6450_;
                                            local_42 = _e4201;
                                            local_43 = _e4203;
                                            local_55 = _e4203;
                                            if (_e4199.member < _e4199.member_1) {
                                                phi_6446_ = type_37((_e4199.member + 1u), _e4199.member_1);
                                                phi_6473_ = type_37(1u, _e4199.member);
                                            } else {
                                                phi_6446_ = _e4199;
                                                phi_6473_ = type_37(0u, type_37().member_1);
                                            }
                                            let _e4217 = phi_6446_;
                                            let _e4219 = phi_6473_;
                                            let _e4223 = (bitcast<i32>(_e4219.member) != 0i);
                                            if _e4223 {
                                                if (_e4219.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4226 = local[_e4219.member_1];
                                                let _e4234 = (((_e4181 * _e4226[0]) + (_e4184 * _e4226[1])) + (_e4187 * _e4226[2]));
                                                if (_e4219.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4237 = local_1[_e4219.member_1];
                                                let _e4245 = (((_e4181 * _e4237[0]) + (_e4184 * _e4237[1])) + (_e4187 * _e4237[2]));
                                                if (_e4203 < _e4234) {
                                                    phi_6523_ = _e4203;
                                                } else {
                                                    phi_6523_ = _e4234;
                                                }
                                                let _e4248 = phi_6523_;
                                                if (_e4248 < _e4245) {
                                                    phi_6528_ = _e4248;
                                                } else {
                                                    phi_6528_ = _e4245;
                                                }
                                                let _e4251 = phi_6528_;
                                                if (_e4201 > _e4234) {
                                                    phi_6533_ = _e4201;
                                                } else {
                                                    phi_6533_ = _e4234;
                                                }
                                                let _e4254 = phi_6533_;
                                                if (_e4254 > _e4245) {
                                                    phi_6538_ = _e4254;
                                                } else {
                                                    phi_6538_ = _e4245;
                                                }
                                                let _e4257 = phi_6538_;
                                                phi_6449_ = _e4257;
                                                phi_6451_ = _e4251;
                                            } else {
                                                phi_6449_ = f32();
                                                phi_6451_ = f32();
                                            }
                                            let _e4259 = phi_6449_;
                                            let _e4261 = phi_6451_;
                                            continue;
                                            continuing {
                                                phi_6445_ = _e4217;
                                                phi_6448_ = _e4259;
                                                phi_6450_ = _e4261;
                                                break if !(_e4223);
                                            }
                                        }
                                        if (_e4181 < 0f) {
                                            phi_6544_ = -(_e4181);
                                        } else {
                                            phi_6544_ = _e4181;
                                        }
                                        let _e4266 = phi_6544_;
                                        if (_e4184 < 0f) {
                                            phi_6550_ = -(_e4184);
                                        } else {
                                            phi_6550_ = _e4184;
                                        }
                                        let _e4270 = phi_6550_;
                                        if (_e4187 < 0f) {
                                            phi_6557_ = -(_e4187);
                                        } else {
                                            phi_6557_ = _e4187;
                                        }
                                        let _e4275 = phi_6557_;
                                        let _e4276 = ((_e4266 + _e4270) + _e4275);
                                        let _e4281 = local_42;
                                        let _e4282 = -(_e4281);
                                        let _e4284 = local_43;
                                        if (_e4284 > _e4282) {
                                            let _e5156 = local_55;
                                            phi_6567_ = _e5156;
                                        } else {
                                            phi_6567_ = _e4282;
                                        }
                                        let _e4287 = phi_6567_;
                                        let _e4292 = (((_e4287 - ((_e4276 * _e4171) * (0.000000059604645f * 17f))) - (_e4276 * _e4178)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4295 = ((_e3950 * _e3944) - (_e3953 * _e3943));
                                        let _e4298 = ((_e3953 * _e3942) - (_e3947 * _e3944));
                                        let _e4301 = ((_e3947 * _e3943) - (_e3950 * _e3942));
                                        let _e4303 = local[0u];
                                        let _e4311 = (((_e4295 * _e4303[0]) + (_e4298 * _e4303[1])) + (_e4301 * _e4303[2]));
                                        phi_6598_ = type_37(0u, 4u);
                                        phi_6601_ = _e4311;
                                        phi_6603_ = _e4311;
                                        loop {
                                            let _e4313 = phi_6598_;
                                            let _e4315 = phi_6601_;
                                            let _e4317 = phi_6603_;
                                            local_44 = _e4315;
                                            local_45 = _e4317;
                                            local_56 = _e4317;
                                            if (_e4313.member < _e4313.member_1) {
                                                phi_6599_ = type_37((_e4313.member + 1u), _e4313.member_1);
                                                phi_6626_ = type_37(1u, _e4313.member);
                                            } else {
                                                phi_6599_ = _e4313;
                                                phi_6626_ = type_37(0u, type_37().member_1);
                                            }
                                            let _e4331 = phi_6599_;
                                            let _e4333 = phi_6626_;
                                            let _e4337 = (bitcast<i32>(_e4333.member) != 0i);
                                            if _e4337 {
                                                if (_e4333.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4340 = local[_e4333.member_1];
                                                let _e4348 = (((_e4295 * _e4340[0]) + (_e4298 * _e4340[1])) + (_e4301 * _e4340[2]));
                                                if (_e4333.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4351 = local_1[_e4333.member_1];
                                                let _e4359 = (((_e4295 * _e4351[0]) + (_e4298 * _e4351[1])) + (_e4301 * _e4351[2]));
                                                if (_e4317 < _e4348) {
                                                    phi_6676_ = _e4317;
                                                } else {
                                                    phi_6676_ = _e4348;
                                                }
                                                let _e4362 = phi_6676_;
                                                if (_e4362 < _e4359) {
                                                    phi_6681_ = _e4362;
                                                } else {
                                                    phi_6681_ = _e4359;
                                                }
                                                let _e4365 = phi_6681_;
                                                if (_e4315 > _e4348) {
                                                    phi_6686_ = _e4315;
                                                } else {
                                                    phi_6686_ = _e4348;
                                                }
                                                let _e4368 = phi_6686_;
                                                if (_e4368 > _e4359) {
                                                    phi_6691_ = _e4368;
                                                } else {
                                                    phi_6691_ = _e4359;
                                                }
                                                let _e4371 = phi_6691_;
                                                phi_6602_ = _e4371;
                                                phi_6604_ = _e4365;
                                            } else {
                                                phi_6602_ = f32();
                                                phi_6604_ = f32();
                                            }
                                            let _e4373 = phi_6602_;
                                            let _e4375 = phi_6604_;
                                            continue;
                                            continuing {
                                                phi_6598_ = _e4331;
                                                phi_6601_ = _e4373;
                                                phi_6603_ = _e4375;
                                                break if !(_e4337);
                                            }
                                        }
                                        if (_e4295 < 0f) {
                                            phi_6697_ = -(_e4295);
                                        } else {
                                            phi_6697_ = _e4295;
                                        }
                                        let _e4380 = phi_6697_;
                                        if (_e4298 < 0f) {
                                            phi_6703_ = -(_e4298);
                                        } else {
                                            phi_6703_ = _e4298;
                                        }
                                        let _e4384 = phi_6703_;
                                        if (_e4301 < 0f) {
                                            phi_6710_ = -(_e4301);
                                        } else {
                                            phi_6710_ = _e4301;
                                        }
                                        let _e4389 = phi_6710_;
                                        let _e4390 = ((_e4380 + _e4384) + _e4389);
                                        let _e4395 = local_44;
                                        let _e4396 = -(_e4395);
                                        let _e4398 = local_45;
                                        if (_e4398 > _e4396) {
                                            let _e5175 = local_56;
                                            phi_6720_ = _e5175;
                                        } else {
                                            phi_6720_ = _e4396;
                                        }
                                        let _e4401 = phi_6720_;
                                        let _e4406 = (((_e4401 - ((_e4390 * _e4171) * (0.000000059604645f * 17f))) - (_e4390 * _e4178)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4292 > _e4406) {
                                            phi_6730_ = _e4292;
                                        } else {
                                            phi_6730_ = _e4406;
                                        }
                                        let _e4409 = phi_6730_;
                                        let _e4410 = (_e3942 - _e3927);
                                        let _e4411 = (_e3943 - _e3928);
                                        let _e4412 = (_e3944 - _e3929);
                                        let _e4415 = ((_e3950 * _e4412) - (_e3953 * _e4411));
                                        let _e4418 = ((_e3953 * _e4410) - (_e3947 * _e4412));
                                        let _e4421 = ((_e3947 * _e4411) - (_e3950 * _e4410));
                                        let _e4423 = local[0u];
                                        let _e4431 = (((_e4415 * _e4423[0]) + (_e4418 * _e4423[1])) + (_e4421 * _e4423[2]));
                                        phi_6763_ = type_37(0u, 4u);
                                        phi_6766_ = _e4431;
                                        phi_6768_ = _e4431;
                                        loop {
                                            let _e4433 = phi_6763_;
                                            let _e4435 = phi_6766_;
                                            let _e4437 = phi_6768_;
                                            local_46 = _e4435;
                                            local_47 = _e4437;
                                            local_57 = _e4437;
                                            if (_e4433.member < _e4433.member_1) {
                                                phi_6764_ = type_37((_e4433.member + 1u), _e4433.member_1);
                                                phi_6791_ = type_37(1u, _e4433.member);
                                            } else {
                                                phi_6764_ = _e4433;
                                                phi_6791_ = type_37(0u, type_37().member_1);
                                            }
                                            let _e4451 = phi_6764_;
                                            let _e4453 = phi_6791_;
                                            let _e4457 = (bitcast<i32>(_e4453.member) != 0i);
                                            if _e4457 {
                                                if (_e4453.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4460 = local[_e4453.member_1];
                                                let _e4468 = (((_e4415 * _e4460[0]) + (_e4418 * _e4460[1])) + (_e4421 * _e4460[2]));
                                                if (_e4453.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4471 = local_1[_e4453.member_1];
                                                let _e4479 = (((_e4415 * _e4471[0]) + (_e4418 * _e4471[1])) + (_e4421 * _e4471[2]));
                                                if (_e4437 < _e4468) {
                                                    phi_6841_ = _e4437;
                                                } else {
                                                    phi_6841_ = _e4468;
                                                }
                                                let _e4482 = phi_6841_;
                                                if (_e4482 < _e4479) {
                                                    phi_6846_ = _e4482;
                                                } else {
                                                    phi_6846_ = _e4479;
                                                }
                                                let _e4485 = phi_6846_;
                                                if (_e4435 > _e4468) {
                                                    phi_6851_ = _e4435;
                                                } else {
                                                    phi_6851_ = _e4468;
                                                }
                                                let _e4488 = phi_6851_;
                                                if (_e4488 > _e4479) {
                                                    phi_6856_ = _e4488;
                                                } else {
                                                    phi_6856_ = _e4479;
                                                }
                                                let _e4491 = phi_6856_;
                                                phi_6767_ = _e4491;
                                                phi_6769_ = _e4485;
                                            } else {
                                                phi_6767_ = f32();
                                                phi_6769_ = f32();
                                            }
                                            let _e4493 = phi_6767_;
                                            let _e4495 = phi_6769_;
                                            continue;
                                            continuing {
                                                phi_6763_ = _e4451;
                                                phi_6766_ = _e4493;
                                                phi_6768_ = _e4495;
                                                break if !(_e4457);
                                            }
                                        }
                                        if (_e4415 < 0f) {
                                            phi_6862_ = -(_e4415);
                                        } else {
                                            phi_6862_ = _e4415;
                                        }
                                        let _e4500 = phi_6862_;
                                        if (_e4418 < 0f) {
                                            phi_6868_ = -(_e4418);
                                        } else {
                                            phi_6868_ = _e4418;
                                        }
                                        let _e4504 = phi_6868_;
                                        if (_e4421 < 0f) {
                                            phi_6875_ = -(_e4421);
                                        } else {
                                            phi_6875_ = _e4421;
                                        }
                                        let _e4509 = phi_6875_;
                                        let _e4510 = ((_e4500 + _e4504) + _e4509);
                                        let _e4515 = local_46;
                                        let _e4516 = -(_e4515);
                                        let _e4518 = local_47;
                                        if (_e4518 > _e4516) {
                                            let _e5195 = local_57;
                                            phi_6885_ = _e5195;
                                        } else {
                                            phi_6885_ = _e4516;
                                        }
                                        let _e4521 = phi_6885_;
                                        let _e4526 = (((_e4521 - ((_e4510 * _e4171) * (0.000000059604645f * 17f))) - (_e4510 * _e4178)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4409 > _e4526) {
                                            phi_6895_ = _e4409;
                                        } else {
                                            phi_6895_ = _e4526;
                                        }
                                        let _e4529 = phi_6895_;
                                        phi_6898_ = (_e4529 > 0f);
                                    }
                                    let _e4532 = phi_6898_;
                                    phi_6899_ = _e4532;
                                } else {
                                    phi_6899_ = false;
                                }
                                let _e4534 = phi_6899_;
                                phi_6901_ = !(_e4534);
                            }
                            let _e4537 = phi_6901_;
                            if _e4537 {
                                let _e4539 = atomicAdd((&counters[3u]), 1u);
                                kept[_e4539] = _e445;
                            }
                        }
                        phi_6909_ = (_e408 + 64u);
                        phi_6910_ = true;
                    }
                    let _e4543 = phi_6909_;
                    let _e4545 = phi_6910_;
                    phi_650_ = _e4543;
                    phi_6911_ = _e4545;
                } else {
                    phi_650_ = u32();
                    phi_6911_ = false;
                }
                let _e4547 = phi_650_;
                let _e4549 = phi_6911_;
                continue;
                continuing {
                    phi_646_ = _e437;
                    phi_649_ = _e4547;
                    break if !(_e4549);
                }
            }
            workgroupBarrier();
            if (_e93 == 0u) {
                let _e4553 = atomicLoad((&counters[3u]));
                if (_e4553 > 0u) {
                    let _e4556 = atomicAdd((&output.member[0u]), _e4553);
                    atomicStore((&counters[4u]), _e4556);
                }
            }
            workgroupBarrier();
            let _e4559 = atomicLoad((&counters[4u]));
            if (_e93 == 0u) {
                let _e4562 = atomicLoad((&counters[5u]));
                let _e4564 = atomicAdd((&output.member[1u]), _e4562);
            }
            let _e4566 = atomicLoad((&counters[3u]));
            phi_6941_ = type_35(0i, 16i);
            phi_6944_ = _e93;
            loop {
                let _e4568 = phi_6941_;
                let _e4570 = phi_6944_;
                if (_e4568.member < _e4568.member_1) {
                    let _e4578 = (_e4568.member + 1i);
                    if ((false == (_e4578 > _e4568.member)) != false) {
                        phi_6965_ = true;
                    } else {
                        phi_6965_ = false;
                    }
                    let _e4583 = phi_6965_;
                    if _e4583 {
                        phi_6971_ = type_36(0u, type_36().member_1);
                    } else {
                        phi_6971_ = type_36(1u, _e4578);
                    }
                    let _e4589 = phi_6971_;
                    if (bitcast<i32>(_e4589.member) != 0i) {
                    } else {
                        return;
                    }
                    phi_6942_ = type_35(_e4589.member_1, _e4568.member_1);
                    phi_6985_ = type_36(1u, _e4568.member);
                } else {
                    phi_6942_ = _e4568;
                    phi_6985_ = type_36(0u, type_36().member_1);
                }
                let _e4599 = phi_6942_;
                let _e4601 = phi_6985_;
                if (bitcast<i32>(_e4601.member) != 0i) {
                    if (_e4570 >= _e4566) {
                        phi_7091_ = u32();
                        phi_7092_ = false;
                    } else {
                        let _e4607 = kept[_e4570];
                        let _e4616 = params.member.member_18[0u][0u];
                        let _e4623 = params.member.member_18[0u][2u];
                        let _e4626 = leaves.member[(_e4616 + ((_e186 * 32u) + (_e4607 >> bitcast<u32>(5i))))];
                        let _e4629 = leaves.member[(_e4623 + ((_e189 * 32u) + (_e4607 & 31u)))];
                        let _e4632 = params.member.member_16;
                        let _e4633 = (_e4559 + _e4570);
                        if (_e4633 < _e4632) {
                            atomicStore((&output.member[(4u + (2u * _e4633))]), _e4626.member_1);
                            atomicStore((&output.member[((2u * _e4633) + 5u)]), _e4629.member_1);
                        }
                        phi_7091_ = (_e4570 + 64u);
                        phi_7092_ = true;
                    }
                    let _e4643 = phi_7091_;
                    let _e4645 = phi_7092_;
                    phi_6945_ = _e4643;
                    phi_7093_ = _e4645;
                } else {
                    phi_6945_ = u32();
                    phi_7093_ = false;
                }
                let _e4647 = phi_6945_;
                let _e4649 = phi_7093_;
                continue;
                continuing {
                    phi_6941_ = _e4599;
                    phi_6944_ = _e4647;
                    break if !(_e4649);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_285_ = _e168;
            break if !(_e174);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn filter_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
