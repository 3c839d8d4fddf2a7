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
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_865_: bool;
    var phi_866_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_870_: bool;
    var phi_871_: bool;
    var phi_875_: bool;
    var phi_882_: bool;
    var phi_886_: bool;
    var phi_887_: bool;
    var phi_936_: bool;
    var phi_937_: bool;
    var phi_947_: bool;
    var phi_948_: bool;
    var phi_952_: bool;
    var phi_953_: bool;
    var phi_1002_: type_37;
    var phi_1005_: bool;
    var phi_1003_: type_37;
    var phi_1028_: type_37;
    var phi_1085_: type_37;
    var phi_1088_: array<u32, 2>;
    var phi_1086_: type_37;
    var phi_1111_: type_37;
    var phi_1186_: bool;
    var phi_1187_: bool;
    var phi_1191_: array<u32, 2>;
    var phi_1089_: array<u32, 2>;
    var phi_1242_: type_37;
    var phi_1245_: array<u32, 2>;
    var phi_1243_: type_37;
    var phi_1268_: type_37;
    var phi_1344_: bool;
    var phi_1345_: bool;
    var phi_1349_: array<u32, 2>;
    var phi_1246_: array<u32, 2>;
    var local_18: array<u32, 2>;
    var local_19: array<u32, 2>;
    var local_20: array<u32, 2>;
    var local_21: array<u32, 2>;
    var local_22: array<u32, 2>;
    var local_23: array<u32, 2>;
    var phi_1365_: bool;
    var phi_1366_: bool;
    var phi_1417_: type_37;
    var phi_1420_: array<u32, 2>;
    var phi_1418_: type_37;
    var phi_1443_: type_37;
    var phi_1518_: bool;
    var phi_1519_: bool;
    var phi_1523_: array<u32, 2>;
    var phi_1421_: array<u32, 2>;
    var phi_1574_: type_37;
    var phi_1577_: array<u32, 2>;
    var phi_1575_: type_37;
    var phi_1600_: type_37;
    var phi_1676_: bool;
    var phi_1677_: bool;
    var phi_1681_: array<u32, 2>;
    var phi_1578_: array<u32, 2>;
    var local_24: array<u32, 2>;
    var local_25: array<u32, 2>;
    var local_26: array<u32, 2>;
    var local_27: array<u32, 2>;
    var local_28: array<u32, 2>;
    var local_29: array<u32, 2>;
    var phi_1697_: bool;
    var phi_1698_: bool;
    var phi_1006_: bool;
    var phi_1702_: bool;
    var phi_1703_: bool;
    var phi_1704_: bool;
    var phi_1708_: bool;
    var phi_1709_: bool;
    var phi_1710_: bool;
    var phi_1711_: bool;
    var phi_1712_: bool;
    var phi_1716_: bool;
    var phi_2114_: f32;
    var phi_2121_: f32;
    var phi_2126_: f32;
    var phi_2133_: f32;
    var phi_2138_: f32;
    var phi_2151_: f32;
    var phi_2158_: f32;
    var phi_2163_: f32;
    var phi_2170_: f32;
    var phi_2175_: f32;
    var phi_2180_: f32;
    var phi_2197_: f32;
    var phi_2204_: f32;
    var phi_2209_: f32;
    var phi_2216_: f32;
    var phi_2221_: f32;
    var phi_2235_: f32;
    var phi_2242_: f32;
    var phi_2247_: f32;
    var phi_2254_: f32;
    var phi_2259_: f32;
    var phi_2264_: f32;
    var phi_2281_: f32;
    var phi_2288_: f32;
    var phi_2293_: f32;
    var phi_2300_: f32;
    var phi_2305_: f32;
    var phi_2319_: f32;
    var phi_2326_: f32;
    var phi_2331_: f32;
    var phi_2338_: f32;
    var phi_2343_: f32;
    var phi_2348_: f32;
    var phi_2379_: f32;
    var phi_2385_: f32;
    var phi_2392_: f32;
    var phi_2399_: f32;
    var phi_2405_: f32;
    var phi_2412_: f32;
    var phi_2418_: f32;
    var phi_2424_: f32;
    var phi_2430_: f32;
    var phi_2437_: f32;
    var phi_2444_: f32;
    var phi_2468_: f32;
    var phi_2473_: f32;
    var phi_2478_: f32;
    var phi_2483_: f32;
    var phi_2488_: f32;
    var phi_2493_: f32;
    var phi_2503_: f32;
    var phi_2754_: f32;
    var phi_2761_: f32;
    var phi_2766_: f32;
    var phi_2773_: f32;
    var phi_2778_: f32;
    var phi_2791_: f32;
    var phi_2798_: f32;
    var phi_2803_: f32;
    var phi_2810_: f32;
    var phi_2815_: f32;
    var phi_2820_: f32;
    var phi_2837_: f32;
    var phi_2844_: f32;
    var phi_2849_: f32;
    var phi_2856_: f32;
    var phi_2861_: f32;
    var phi_2875_: f32;
    var phi_2882_: f32;
    var phi_2887_: f32;
    var phi_2894_: f32;
    var phi_2899_: f32;
    var phi_2904_: f32;
    var phi_2921_: f32;
    var phi_2928_: f32;
    var phi_2933_: f32;
    var phi_2940_: f32;
    var phi_2945_: f32;
    var phi_2959_: f32;
    var phi_2966_: f32;
    var phi_2971_: f32;
    var phi_2978_: f32;
    var phi_2983_: f32;
    var phi_2988_: f32;
    var phi_3026_: type_37;
    var phi_3029_: f32;
    var phi_3031_: f32;
    var phi_3027_: type_37;
    var phi_3054_: type_37;
    var phi_3104_: f32;
    var phi_3109_: f32;
    var phi_3114_: f32;
    var phi_3119_: f32;
    var phi_3030_: f32;
    var phi_3032_: f32;
    var phi_3125_: f32;
    var phi_3131_: f32;
    var phi_3138_: f32;
    var local_30: f32;
    var local_31: f32;
    var phi_3148_: f32;
    var phi_3179_: type_37;
    var phi_3182_: f32;
    var phi_3184_: f32;
    var phi_3180_: type_37;
    var phi_3207_: type_37;
    var phi_3257_: f32;
    var phi_3262_: f32;
    var phi_3267_: f32;
    var phi_3272_: f32;
    var phi_3183_: f32;
    var phi_3185_: f32;
    var phi_3278_: f32;
    var phi_3284_: f32;
    var phi_3291_: f32;
    var local_32: f32;
    var local_33: f32;
    var phi_3301_: f32;
    var phi_3311_: f32;
    var phi_3344_: type_37;
    var phi_3347_: f32;
    var phi_3349_: f32;
    var phi_3345_: type_37;
    var phi_3372_: type_37;
    var phi_3422_: f32;
    var phi_3427_: f32;
    var phi_3432_: f32;
    var phi_3437_: f32;
    var phi_3348_: f32;
    var phi_3350_: f32;
    var phi_3443_: f32;
    var phi_3449_: f32;
    var phi_3456_: f32;
    var local_34: f32;
    var local_35: f32;
    var phi_3466_: f32;
    var phi_3476_: f32;
    var phi_3479_: bool;
    var phi_3936_: f32;
    var phi_3943_: f32;
    var phi_3948_: f32;
    var phi_3955_: f32;
    var phi_3960_: f32;
    var phi_3973_: f32;
    var phi_3980_: f32;
    var phi_3985_: f32;
    var phi_3992_: f32;
    var phi_3997_: f32;
    var phi_4002_: f32;
    var phi_4019_: f32;
    var phi_4026_: f32;
    var phi_4031_: f32;
    var phi_4038_: f32;
    var phi_4043_: f32;
    var phi_4057_: f32;
    var phi_4064_: f32;
    var phi_4069_: f32;
    var phi_4076_: f32;
    var phi_4081_: f32;
    var phi_4086_: f32;
    var phi_4103_: f32;
    var phi_4110_: f32;
    var phi_4115_: f32;
    var phi_4122_: f32;
    var phi_4127_: f32;
    var phi_4141_: f32;
    var phi_4148_: f32;
    var phi_4153_: f32;
    var phi_4160_: f32;
    var phi_4165_: f32;
    var phi_4170_: f32;
    var phi_4201_: f32;
    var phi_4207_: f32;
    var phi_4214_: f32;
    var phi_4221_: f32;
    var phi_4227_: f32;
    var phi_4234_: f32;
    var phi_4240_: f32;
    var phi_4246_: f32;
    var phi_4252_: f32;
    var phi_4259_: f32;
    var phi_4266_: f32;
    var phi_4290_: f32;
    var phi_4295_: f32;
    var phi_4300_: f32;
    var phi_4305_: f32;
    var phi_4310_: f32;
    var phi_4315_: f32;
    var phi_4325_: f32;
    var phi_4576_: f32;
    var phi_4583_: f32;
    var phi_4588_: f32;
    var phi_4595_: f32;
    var phi_4600_: f32;
    var phi_4613_: f32;
    var phi_4620_: f32;
    var phi_4625_: f32;
    var phi_4632_: f32;
    var phi_4637_: f32;
    var phi_4642_: f32;
    var phi_4659_: f32;
    var phi_4666_: f32;
    var phi_4671_: f32;
    var phi_4678_: f32;
    var phi_4683_: f32;
    var phi_4697_: f32;
    var phi_4704_: f32;
    var phi_4709_: f32;
    var phi_4716_: f32;
    var phi_4721_: f32;
    var phi_4726_: f32;
    var phi_4743_: f32;
    var phi_4750_: f32;
    var phi_4755_: f32;
    var phi_4762_: f32;
    var phi_4767_: f32;
    var phi_4781_: f32;
    var phi_4788_: f32;
    var phi_4793_: f32;
    var phi_4800_: f32;
    var phi_4805_: f32;
    var phi_4810_: f32;
    var phi_4848_: type_37;
    var phi_4851_: f32;
    var phi_4853_: f32;
    var phi_4849_: type_37;
    var phi_4876_: type_37;
    var phi_4926_: f32;
    var phi_4931_: f32;
    var phi_4936_: f32;
    var phi_4941_: f32;
    var phi_4852_: f32;
    var phi_4854_: f32;
    var phi_4947_: f32;
    var phi_4953_: f32;
    var phi_4960_: f32;
    var local_36: f32;
    var local_37: f32;
    var phi_4970_: f32;
    var phi_5001_: type_37;
    var phi_5004_: f32;
    var phi_5006_: f32;
    var phi_5002_: type_37;
    var phi_5029_: type_37;
    var phi_5079_: f32;
    var phi_5084_: f32;
    var phi_5089_: f32;
    var phi_5094_: f32;
    var phi_5005_: f32;
    var phi_5007_: f32;
    var phi_5100_: f32;
    var phi_5106_: f32;
    var phi_5113_: f32;
    var local_38: f32;
    var local_39: f32;
    var phi_5123_: f32;
    var phi_5133_: f32;
    var phi_5166_: type_37;
    var phi_5169_: f32;
    var phi_5171_: f32;
    var phi_5167_: type_37;
    var phi_5194_: type_37;
    var phi_5244_: f32;
    var phi_5249_: f32;
    var phi_5254_: f32;
    var phi_5259_: f32;
    var phi_5170_: f32;
    var phi_5172_: f32;
    var phi_5265_: f32;
    var phi_5271_: f32;
    var phi_5278_: f32;
    var local_40: f32;
    var local_41: f32;
    var phi_5288_: f32;
    var phi_5298_: f32;
    var phi_5301_: bool;
    var phi_5547_: f32;
    var phi_5554_: f32;
    var phi_5559_: f32;
    var phi_5566_: f32;
    var phi_5571_: f32;
    var phi_5584_: f32;
    var phi_5591_: f32;
    var phi_5596_: f32;
    var phi_5603_: f32;
    var phi_5608_: f32;
    var phi_5613_: f32;
    var phi_5630_: f32;
    var phi_5637_: f32;
    var phi_5642_: f32;
    var phi_5649_: f32;
    var phi_5654_: f32;
    var phi_5668_: f32;
    var phi_5675_: f32;
    var phi_5680_: f32;
    var phi_5687_: f32;
    var phi_5692_: f32;
    var phi_5697_: f32;
    var phi_5714_: f32;
    var phi_5721_: f32;
    var phi_5726_: f32;
    var phi_5733_: f32;
    var phi_5738_: f32;
    var phi_5752_: f32;
    var phi_5759_: f32;
    var phi_5764_: f32;
    var phi_5771_: f32;
    var phi_5776_: f32;
    var phi_5781_: f32;
    var phi_5812_: f32;
    var phi_5818_: f32;
    var phi_5825_: f32;
    var phi_5832_: f32;
    var phi_5838_: f32;
    var phi_5845_: f32;
    var phi_5851_: f32;
    var phi_5857_: f32;
    var phi_5863_: f32;
    var phi_5870_: f32;
    var phi_5877_: f32;
    var phi_5901_: f32;
    var phi_5906_: f32;
    var phi_5911_: f32;
    var phi_5916_: f32;
    var phi_5921_: f32;
    var phi_5926_: f32;
    var phi_5936_: f32;
    var phi_6187_: f32;
    var phi_6194_: f32;
    var phi_6199_: f32;
    var phi_6206_: f32;
    var phi_6211_: f32;
    var phi_6224_: f32;
    var phi_6231_: f32;
    var phi_6236_: f32;
    var phi_6243_: f32;
    var phi_6248_: f32;
    var phi_6253_: f32;
    var phi_6270_: f32;
    var phi_6277_: f32;
    var phi_6282_: f32;
    var phi_6289_: f32;
    var phi_6294_: f32;
    var phi_6308_: f32;
    var phi_6315_: f32;
    var phi_6320_: f32;
    var phi_6327_: f32;
    var phi_6332_: f32;
    var phi_6337_: f32;
    var phi_6354_: f32;
    var phi_6361_: f32;
    var phi_6366_: f32;
    var phi_6373_: f32;
    var phi_6378_: f32;
    var phi_6392_: f32;
    var phi_6399_: f32;
    var phi_6404_: f32;
    var phi_6411_: f32;
    var phi_6416_: f32;
    var phi_6421_: f32;
    var phi_6459_: type_37;
    var phi_6462_: f32;
    var phi_6464_: f32;
    var phi_6460_: type_37;
    var phi_6487_: type_37;
    var phi_6537_: f32;
    var phi_6542_: f32;
    var phi_6547_: f32;
    var phi_6552_: f32;
    var phi_6463_: f32;
    var phi_6465_: f32;
    var phi_6558_: f32;
    var phi_6564_: f32;
    var phi_6571_: f32;
    var local_42: f32;
    var local_43: f32;
    var phi_6581_: f32;
    var phi_6612_: type_37;
    var phi_6615_: f32;
    var phi_6617_: f32;
    var phi_6613_: type_37;
    var phi_6640_: type_37;
    var phi_6690_: f32;
    var phi_6695_: f32;
    var phi_6700_: f32;
    var phi_6705_: f32;
    var phi_6616_: f32;
    var phi_6618_: f32;
    var phi_6711_: f32;
    var phi_6717_: f32;
    var phi_6724_: f32;
    var local_44: f32;
    var local_45: f32;
    var phi_6734_: f32;
    var phi_6744_: f32;
    var phi_6777_: type_37;
    var phi_6780_: f32;
    var phi_6782_: f32;
    var phi_6778_: type_37;
    var phi_6805_: type_37;
    var phi_6855_: f32;
    var phi_6860_: f32;
    var phi_6865_: f32;
    var phi_6870_: f32;
    var phi_6781_: f32;
    var phi_6783_: f32;
    var phi_6876_: f32;
    var phi_6882_: f32;
    var phi_6889_: f32;
    var local_46: f32;
    var local_47: f32;
    var phi_6899_: f32;
    var phi_6909_: f32;
    var phi_6912_: bool;
    var phi_6913_: bool;
    var phi_6915_: bool;
    var phi_6923_: u32;
    var phi_6924_: bool;
    var phi_650_: u32;
    var phi_6925_: bool;
    var phi_6955_: type_35;
    var phi_6958_: u32;
    var phi_6979_: bool;
    var phi_6985_: type_36;
    var phi_6956_: type_35;
    var phi_6999_: type_36;
    var phi_7105_: u32;
    var phi_7106_: bool;
    var phi_6959_: u32;
    var phi_7107_: bool;
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
                        phi_6923_ = u32();
                        phi_6924_ = false;
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
                                let _e532 = local_16.member[0u];
                                let _e535 = local_17.member[0u];
                                if (_e532 == _e535) {
                                    phi_828_ = bool();
                                    phi_829_ = true;
                                } else {
                                    let _e539 = local_16.member[0u];
                                    let _e542 = local_17.member[1u];
                                    let _e543 = (_e539 == _e542);
                                    if _e543 {
                                        phi_827_ = bool();
                                    } else {
                                        let _e546 = local_16.member[0u];
                                        let _e549 = local_17.member[2u];
                                        phi_827_ = (_e546 == _e549);
                                    }
                                    let _e552 = phi_827_;
                                    phi_828_ = _e552;
                                    phi_829_ = _e543;
                                }
                                let _e554 = phi_828_;
                                let _e556 = phi_829_;
                                phi_870_ = _e554;
                                phi_871_ = _e556;
                            } else {
                                let _e494 = local_16.member[0u];
                                let _e497 = local_17.member[0u];
                                if (_e494 == _e497) {
                                    phi_865_ = bool();
                                    phi_866_ = true;
                                } else {
                                    let _e501 = local_16.member[0u];
                                    let _e504 = local_17.member[1u];
                                    if (_e501 == _e504) {
                                        phi_863_ = bool();
                                        phi_864_ = true;
                                    } else {
                                        let _e508 = local_16.member[1u];
                                        let _e511 = local_17.member[0u];
                                        let _e512 = (_e508 == _e511);
                                        if _e512 {
                                            phi_862_ = bool();
                                        } else {
                                            let _e515 = local_16.member[1u];
                                            let _e518 = local_17.member[1u];
                                            phi_862_ = (_e515 == _e518);
                                        }
                                        let _e521 = phi_862_;
                                        phi_863_ = _e521;
                                        phi_864_ = _e512;
                                    }
                                    let _e523 = phi_863_;
                                    let _e525 = phi_864_;
                                    phi_865_ = _e523;
                                    phi_866_ = _e525;
                                }
                                let _e527 = phi_865_;
                                let _e529 = phi_866_;
                                phi_870_ = _e527;
                                phi_871_ = _e529;
                            }
                            let _e558 = phi_870_;
                            let _e560 = phi_871_;
                            if _e560 {
                                phi_875_ = false;
                            } else {
                                phi_875_ = true;
                            }
                            let _e562 = phi_875_;
                            if _e562 {
                                phi_882_ = _e558;
                            } else {
                                phi_882_ = true;
                            }
                            let _e564 = phi_882_;
                            if _e564 {
                                phi_886_ = false;
                            } else {
                                phi_886_ = true;
                            }
                            let _e566 = phi_886_;
                            phi_887_ = _e566;
                        } else {
                            phi_887_ = true;
                        }
                        let _e568 = phi_887_;
                        if _e568 {
                            let _e570 = params.member.member_1;
                            if ((_e570 & 2u) != 0u) {
                                let _e575 = local_16.member[0u];
                                let _e577 = bodies.member[_e575];
                                let _e580 = local_17.member[0u];
                                let _e582 = bodies.member[_e580];
                                if ((_e577 / 2u) == (_e582 / 2u)) {
                                    let _e587 = params.member.member_1;
                                    if !(((_e587 & 4u) != 0u)) {
                                        phi_936_ = false;
                                    } else {
                                        phi_936_ = true;
                                    }
                                    let _e592 = phi_936_;
                                    phi_937_ = _e592;
                                } else {
                                    phi_937_ = true;
                                }
                                let _e594 = phi_937_;
                                if _e594 {
                                    if (((_e577 & _e582) & 1u) == 0u) {
                                        phi_947_ = false;
                                    } else {
                                        phi_947_ = true;
                                    }
                                    let _e599 = phi_947_;
                                    phi_948_ = _e599;
                                } else {
                                    phi_948_ = true;
                                }
                                let _e601 = phi_948_;
                                if _e601 {
                                    phi_952_ = false;
                                } else {
                                    phi_952_ = true;
                                }
                                let _e603 = phi_952_;
                                phi_953_ = _e603;
                            } else {
                                phi_953_ = true;
                            }
                            let _e605 = phi_953_;
                            if _e605 {
                                let _e607 = params.member.member_1;
                                if ((_e607 & 32u) != 0u) {
                                    let _e611 = params.member.member_6;
                                    let _e652 = (((((((_e482.member_1[0] - _e484.member[0]) > _e611) && ((_e484.member_1[0] - _e482.member[0]) > _e611)) && ((_e482.member_1[1] - _e484.member[1]) > _e611)) && ((_e484.member_1[1] - _e482.member[1]) > _e611)) && ((_e482.member_1[2] - _e484.member[2]) > _e611)) && ((_e484.member_1[2] - _e482.member[2]) > _e611));
                                    if _e652 {
                                        phi_1702_ = bool();
                                    } else {
                                        phi_1002_ = type_37(0u, 3u);
                                        phi_1005_ = true;
                                        loop {
                                            let _e656 = phi_1002_;
                                            let _e658 = phi_1005_;
                                            local_48 = _e658;
                                            if (_e656.member < _e656.member_1) {
                                                phi_1003_ = type_37((_e656.member + 1u), _e656.member_1);
                                                phi_1028_ = type_37(1u, _e656.member);
                                            } else {
                                                phi_1003_ = _e656;
                                                phi_1028_ = type_37(0u, type_37().member_1);
                                            }
                                            let _e672 = phi_1003_;
                                            let _e674 = phi_1028_;
                                            let _e678 = (bitcast<i32>(_e674.member) != 0i);
                                            if _e678 {
                                                let _e680 = local_16.member[0u];
                                                let _e682 = keys.member[_e680];
                                                local_14 = array<array<u32, 2>, 6>(array<u32, 2>(_e682[0][0], _e682[0][1]), array<u32, 2>(_e682[1][0], _e682[1][1]), array<u32, 2>(_e682[2][0], _e682[2][1]), array<u32, 2>(_e682[3][0], _e682[3][1]), array<u32, 2>(_e682[4][0], _e682[4][1]), array<u32, 2>(_e682[5][0], _e682[5][1]));
                                                if (_e674.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e710 = local_14[_e674.member_1];
                                                phi_1085_ = type_37(1u, 3u);
                                                phi_1088_ = array<u32, 2>(_e710[0], _e710[1]);
                                                loop {
                                                    let _e715 = phi_1085_;
                                                    let _e717 = phi_1088_;
                                                    local_18 = _e717;
                                                    local_20 = _e717;
                                                    local_22 = _e717;
                                                    if (_e715.member < _e715.member_1) {
                                                        phi_1086_ = type_37((_e715.member + 1u), _e715.member_1);
                                                        phi_1111_ = type_37(1u, _e715.member);
                                                    } else {
                                                        phi_1086_ = _e715;
                                                        phi_1111_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e731 = phi_1086_;
                                                    let _e733 = phi_1111_;
                                                    let _e737 = (bitcast<i32>(_e733.member) != 0i);
                                                    if _e737 {
                                                        if (_e733.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e740 = local_16.member[_e733.member_1];
                                                        let _e742 = keys.member[_e740];
                                                        local_15 = array<array<u32, 2>, 6>(array<u32, 2>(_e742[0][0], _e742[0][1]), array<u32, 2>(_e742[1][0], _e742[1][1]), array<u32, 2>(_e742[2][0], _e742[2][1]), array<u32, 2>(_e742[3][0], _e742[3][1]), array<u32, 2>(_e742[4][0], _e742[4][1]), array<u32, 2>(_e742[5][0], _e742[5][1]));
                                                        if (_e674.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e770 = local_15[_e674.member_1];
                                                        if (_e717[1] > _e770[1]) {
                                                            phi_1187_ = true;
                                                        } else {
                                                            if (_e717[1] == _e770[1]) {
                                                                phi_1186_ = (_e717[0] > _e770[0]);
                                                            } else {
                                                                phi_1186_ = false;
                                                            }
                                                            let _e781 = phi_1186_;
                                                            phi_1187_ = _e781;
                                                        }
                                                        let _e783 = phi_1187_;
                                                        if _e783 {
                                                            phi_1191_ = array<u32, 2>(_e770[0], _e770[1]);
                                                        } else {
                                                            phi_1191_ = _e717;
                                                        }
                                                        let _e785 = phi_1191_;
                                                        phi_1089_ = _e785;
                                                    } else {
                                                        phi_1089_ = array<u32, 2>();
                                                    }
                                                    let _e787 = phi_1089_;
                                                    continue;
                                                    continuing {
                                                        phi_1085_ = _e731;
                                                        phi_1088_ = _e787;
                                                        break if !(_e737);
                                                    }
                                                }
                                                let _e790 = local_17.member[0u];
                                                let _e792 = keys.member[_e790];
                                                local_12 = array<array<u32, 2>, 6>(array<u32, 2>(_e792[0][0], _e792[0][1]), array<u32, 2>(_e792[1][0], _e792[1][1]), array<u32, 2>(_e792[2][0], _e792[2][1]), array<u32, 2>(_e792[3][0], _e792[3][1]), array<u32, 2>(_e792[4][0], _e792[4][1]), array<u32, 2>(_e792[5][0], _e792[5][1]));
                                                let _e818 = (3u + _e674.member_1);
                                                if (_e818 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e821 = local_12[_e818];
                                                phi_1242_ = type_37(1u, 3u);
                                                phi_1245_ = array<u32, 2>(_e821[0], _e821[1]);
                                                loop {
                                                    let _e826 = phi_1242_;
                                                    let _e828 = phi_1245_;
                                                    local_19 = _e828;
                                                    local_21 = _e828;
                                                    local_23 = _e828;
                                                    if (_e826.member < _e826.member_1) {
                                                        phi_1243_ = type_37((_e826.member + 1u), _e826.member_1);
                                                        phi_1268_ = type_37(1u, _e826.member);
                                                    } else {
                                                        phi_1243_ = _e826;
                                                        phi_1268_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e842 = phi_1243_;
                                                    let _e844 = phi_1268_;
                                                    let _e848 = (bitcast<i32>(_e844.member) != 0i);
                                                    if _e848 {
                                                        if (_e844.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e851 = local_17.member[_e844.member_1];
                                                        let _e853 = keys.member[_e851];
                                                        local_13 = array<array<u32, 2>, 6>(array<u32, 2>(_e853[0][0], _e853[0][1]), array<u32, 2>(_e853[1][0], _e853[1][1]), array<u32, 2>(_e853[2][0], _e853[2][1]), array<u32, 2>(_e853[3][0], _e853[3][1]), array<u32, 2>(_e853[4][0], _e853[4][1]), array<u32, 2>(_e853[5][0], _e853[5][1]));
                                                        let _e879 = (3u + _e674.member_1);
                                                        if (_e879 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e882 = local_13[_e879];
                                                        if (_e882[1] > _e828[1]) {
                                                            phi_1345_ = true;
                                                        } else {
                                                            if (_e882[1] == _e828[1]) {
                                                                phi_1344_ = (_e882[0] > _e828[0]);
                                                            } else {
                                                                phi_1344_ = false;
                                                            }
                                                            let _e893 = phi_1344_;
                                                            phi_1345_ = _e893;
                                                        }
                                                        let _e895 = phi_1345_;
                                                        if _e895 {
                                                            phi_1349_ = array<u32, 2>(_e882[0], _e882[1]);
                                                        } else {
                                                            phi_1349_ = _e828;
                                                        }
                                                        let _e897 = phi_1349_;
                                                        phi_1246_ = _e897;
                                                    } else {
                                                        phi_1246_ = array<u32, 2>();
                                                    }
                                                    let _e899 = phi_1246_;
                                                    continue;
                                                    continuing {
                                                        phi_1242_ = _e842;
                                                        phi_1245_ = _e899;
                                                        break if !(_e848);
                                                    }
                                                }
                                                let _e902 = local_18;
                                                let _e905 = local_19;
                                                if (_e902[1] > _e905[1]) {
                                                    phi_1366_ = true;
                                                } else {
                                                    let _e909 = local_20;
                                                    let _e912 = local_21;
                                                    if (_e909[1] == _e912[1]) {
                                                        let _e916 = local_22;
                                                        let _e919 = local_23;
                                                        phi_1365_ = (_e916[0] > _e919[0]);
                                                    } else {
                                                        phi_1365_ = false;
                                                    }
                                                    let _e923 = phi_1365_;
                                                    phi_1366_ = _e923;
                                                }
                                                let _e925 = phi_1366_;
                                                let _e928 = local_17.member[0u];
                                                let _e930 = keys.member[_e928];
                                                local_10 = array<array<u32, 2>, 6>(array<u32, 2>(_e930[0][0], _e930[0][1]), array<u32, 2>(_e930[1][0], _e930[1][1]), array<u32, 2>(_e930[2][0], _e930[2][1]), array<u32, 2>(_e930[3][0], _e930[3][1]), array<u32, 2>(_e930[4][0], _e930[4][1]), array<u32, 2>(_e930[5][0], _e930[5][1]));
                                                if (_e674.member_1 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e958 = local_10[_e674.member_1];
                                                phi_1417_ = type_37(1u, 3u);
                                                phi_1420_ = array<u32, 2>(_e958[0], _e958[1]);
                                                loop {
                                                    let _e963 = phi_1417_;
                                                    let _e965 = phi_1420_;
                                                    local_24 = _e965;
                                                    local_26 = _e965;
                                                    local_28 = _e965;
                                                    if (_e963.member < _e963.member_1) {
                                                        phi_1418_ = type_37((_e963.member + 1u), _e963.member_1);
                                                        phi_1443_ = type_37(1u, _e963.member);
                                                    } else {
                                                        phi_1418_ = _e963;
                                                        phi_1443_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e979 = phi_1418_;
                                                    let _e981 = phi_1443_;
                                                    let _e985 = (bitcast<i32>(_e981.member) != 0i);
                                                    if _e985 {
                                                        if (_e981.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e988 = local_17.member[_e981.member_1];
                                                        let _e990 = keys.member[_e988];
                                                        local_11 = array<array<u32, 2>, 6>(array<u32, 2>(_e990[0][0], _e990[0][1]), array<u32, 2>(_e990[1][0], _e990[1][1]), array<u32, 2>(_e990[2][0], _e990[2][1]), array<u32, 2>(_e990[3][0], _e990[3][1]), array<u32, 2>(_e990[4][0], _e990[4][1]), array<u32, 2>(_e990[5][0], _e990[5][1]));
                                                        if (_e674.member_1 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1018 = local_11[_e674.member_1];
                                                        if (_e965[1] > _e1018[1]) {
                                                            phi_1519_ = true;
                                                        } else {
                                                            if (_e965[1] == _e1018[1]) {
                                                                phi_1518_ = (_e965[0] > _e1018[0]);
                                                            } else {
                                                                phi_1518_ = false;
                                                            }
                                                            let _e1029 = phi_1518_;
                                                            phi_1519_ = _e1029;
                                                        }
                                                        let _e1031 = phi_1519_;
                                                        if _e1031 {
                                                            phi_1523_ = array<u32, 2>(_e1018[0], _e1018[1]);
                                                        } else {
                                                            phi_1523_ = _e965;
                                                        }
                                                        let _e1033 = phi_1523_;
                                                        phi_1421_ = _e1033;
                                                    } else {
                                                        phi_1421_ = array<u32, 2>();
                                                    }
                                                    let _e1035 = phi_1421_;
                                                    continue;
                                                    continuing {
                                                        phi_1417_ = _e979;
                                                        phi_1420_ = _e1035;
                                                        break if !(_e985);
                                                    }
                                                }
                                                let _e1038 = local_16.member[0u];
                                                let _e1040 = keys.member[_e1038];
                                                local_8 = array<array<u32, 2>, 6>(array<u32, 2>(_e1040[0][0], _e1040[0][1]), array<u32, 2>(_e1040[1][0], _e1040[1][1]), array<u32, 2>(_e1040[2][0], _e1040[2][1]), array<u32, 2>(_e1040[3][0], _e1040[3][1]), array<u32, 2>(_e1040[4][0], _e1040[4][1]), array<u32, 2>(_e1040[5][0], _e1040[5][1]));
                                                let _e1066 = (3u + _e674.member_1);
                                                if (_e1066 < 6u) {
                                                } else {
                                                    return;
                                                }
                                                let _e1069 = local_8[_e1066];
                                                phi_1574_ = type_37(1u, 3u);
                                                phi_1577_ = array<u32, 2>(_e1069[0], _e1069[1]);
                                                loop {
                                                    let _e1074 = phi_1574_;
                                                    let _e1076 = phi_1577_;
                                                    local_25 = _e1076;
                                                    local_27 = _e1076;
                                                    local_29 = _e1076;
                                                    if (_e1074.member < _e1074.member_1) {
                                                        phi_1575_ = type_37((_e1074.member + 1u), _e1074.member_1);
                                                        phi_1600_ = type_37(1u, _e1074.member);
                                                    } else {
                                                        phi_1575_ = _e1074;
                                                        phi_1600_ = type_37(0u, type_37().member_1);
                                                    }
                                                    let _e1090 = phi_1575_;
                                                    let _e1092 = phi_1600_;
                                                    let _e1096 = (bitcast<i32>(_e1092.member) != 0i);
                                                    if _e1096 {
                                                        if (_e1092.member_1 < 3u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1099 = local_16.member[_e1092.member_1];
                                                        let _e1101 = keys.member[_e1099];
                                                        local_9 = array<array<u32, 2>, 6>(array<u32, 2>(_e1101[0][0], _e1101[0][1]), array<u32, 2>(_e1101[1][0], _e1101[1][1]), array<u32, 2>(_e1101[2][0], _e1101[2][1]), array<u32, 2>(_e1101[3][0], _e1101[3][1]), array<u32, 2>(_e1101[4][0], _e1101[4][1]), array<u32, 2>(_e1101[5][0], _e1101[5][1]));
                                                        let _e1127 = (3u + _e674.member_1);
                                                        if (_e1127 < 6u) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1130 = local_9[_e1127];
                                                        if (_e1130[1] > _e1076[1]) {
                                                            phi_1677_ = true;
                                                        } else {
                                                            if (_e1130[1] == _e1076[1]) {
                                                                phi_1676_ = (_e1130[0] > _e1076[0]);
                                                            } else {
                                                                phi_1676_ = false;
                                                            }
                                                            let _e1141 = phi_1676_;
                                                            phi_1677_ = _e1141;
                                                        }
                                                        let _e1143 = phi_1677_;
                                                        if _e1143 {
                                                            phi_1681_ = array<u32, 2>(_e1130[0], _e1130[1]);
                                                        } else {
                                                            phi_1681_ = _e1076;
                                                        }
                                                        let _e1145 = phi_1681_;
                                                        phi_1578_ = _e1145;
                                                    } else {
                                                        phi_1578_ = array<u32, 2>();
                                                    }
                                                    let _e1147 = phi_1578_;
                                                    continue;
                                                    continuing {
                                                        phi_1574_ = _e1090;
                                                        phi_1577_ = _e1147;
                                                        break if !(_e1096);
                                                    }
                                                }
                                                let _e1150 = local_24;
                                                let _e1153 = local_25;
                                                if (_e1150[1] > _e1153[1]) {
                                                    phi_1698_ = true;
                                                } else {
                                                    let _e1157 = local_26;
                                                    let _e1160 = local_27;
                                                    if (_e1157[1] == _e1160[1]) {
                                                        let _e1164 = local_28;
                                                        let _e1167 = local_29;
                                                        phi_1697_ = (_e1164[0] > _e1167[0]);
                                                    } else {
                                                        phi_1697_ = false;
                                                    }
                                                    let _e1171 = phi_1697_;
                                                    phi_1698_ = _e1171;
                                                }
                                                let _e1173 = phi_1698_;
                                                phi_1006_ = (_e658 && (!(_e925) && !(_e1173)));
                                            } else {
                                                phi_1006_ = bool();
                                            }
                                            let _e1178 = phi_1006_;
                                            continue;
                                            continuing {
                                                phi_1002_ = _e672;
                                                phi_1005_ = _e1178;
                                                break if !(_e678);
                                            }
                                        }
                                        let _e4763 = local_48;
                                        phi_1702_ = _e4763;
                                    }
                                    let _e1181 = phi_1702_;
                                    phi_1703_ = _e1181;
                                    phi_1704_ = _e652;
                                } else {
                                    phi_1703_ = bool();
                                    phi_1704_ = true;
                                }
                                let _e1183 = phi_1703_;
                                let _e1185 = phi_1704_;
                                if _e1185 {
                                    phi_1708_ = false;
                                } else {
                                    phi_1708_ = true;
                                }
                                let _e1187 = phi_1708_;
                                phi_1709_ = _e1183;
                                phi_1710_ = _e1187;
                            } else {
                                phi_1709_ = false;
                                phi_1710_ = true;
                            }
                            let _e1189 = phi_1709_;
                            let _e1191 = phi_1710_;
                            phi_1711_ = _e1189;
                            phi_1712_ = _e1191;
                        } else {
                            phi_1711_ = false;
                            phi_1712_ = true;
                        }
                        let _e1193 = phi_1711_;
                        let _e1195 = phi_1712_;
                        if _e1195 {
                            phi_1716_ = _e1193;
                        } else {
                            phi_1716_ = true;
                        }
                        let _e1197 = phi_1716_;
                        if _e1197 {
                            let _e1199 = atomicAdd((&counters[5u]), 1u);
                            let _e1201 = params.member.member_4;
                            let _e1203 = params.member.member_5;
                            let _e1206 = local_16.member[0u];
                            let _e1209 = local_17.member[0u];
                            let _e1212 = local_17.member[1u];
                            let _e1215 = local_17.member[2u];
                            let _e1217 = paths.member[_e1206];
                            let _e1219 = paths.member[_e1209];
                            let _e1225 = paths.member[_e1212];
                            let _e1227 = paths.member[_e1215];
                            local_7 = type_72(array<array<f32, 3>, 2>(array<f32, 3>((_e1217.member[0] - _e1219.member[0]), (_e1217.member[1] - _e1219.member[1]), (_e1217.member[2] - _e1219.member[2])), array<f32, 3>((_e1217.member_1[0] - _e1219.member_1[0]), (_e1217.member_1[1] - _e1219.member_1[1]), (_e1217.member_1[2] - _e1219.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1225.member[0] - _e1219.member[0]), (_e1225.member[1] - _e1219.member[1]), (_e1225.member[2] - _e1219.member[2])), array<f32, 3>((_e1225.member_1[0] - _e1219.member_1[0]), (_e1225.member_1[1] - _e1219.member_1[1]), (_e1225.member_1[2] - _e1219.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1227.member[0] - _e1219.member[0]), (_e1227.member[1] - _e1219.member[1]), (_e1227.member[2] - _e1219.member[2])), array<f32, 3>((_e1227.member_1[0] - _e1219.member_1[0]), (_e1227.member_1[1] - _e1219.member_1[1]), (_e1227.member_1[2] - _e1219.member_1[2]))), (_e1201 + _e1201));
                            let _e1287 = local_7.member_1[0u];
                            let _e1293 = local_7.member_2[0u];
                            let _e1299 = ((_e1287[1] * _e1293[2]) - (_e1287[2] * _e1293[1]));
                            let _e1302 = ((_e1287[2] * _e1293[0]) - (_e1287[0] * _e1293[2]));
                            let _e1305 = ((_e1287[0] * _e1293[1]) - (_e1287[1] * _e1293[0]));
                            let _e1308 = local_7.member_1[1u];
                            let _e1314 = local_7.member_2[1u];
                            let _e1320 = ((_e1308[1] * _e1314[2]) - (_e1308[2] * _e1314[1]));
                            let _e1323 = ((_e1308[2] * _e1314[0]) - (_e1308[0] * _e1314[2]));
                            let _e1326 = ((_e1308[0] * _e1314[1]) - (_e1308[1] * _e1314[0]));
                            let _e1329 = local_7.member_1[0u];
                            let _e1335 = local_7.member_2[1u];
                            let _e1350 = local_7.member_1[1u];
                            let _e1356 = local_7.member_2[0u];
                            let _e1369 = (((_e1329[1] * _e1335[2]) - (_e1329[2] * _e1335[1])) + ((_e1350[1] * _e1356[2]) - (_e1350[2] * _e1356[1])));
                            let _e1370 = (((_e1329[2] * _e1335[0]) - (_e1329[0] * _e1335[2])) + ((_e1350[2] * _e1356[0]) - (_e1350[0] * _e1356[2])));
                            let _e1371 = (((_e1329[0] * _e1335[1]) - (_e1329[1] * _e1335[0])) + ((_e1350[0] * _e1356[1]) - (_e1350[1] * _e1356[0])));
                            let _e1374 = local_7.member[0u];
                            let _e1385 = local_7.member[1u];
                            let _e1396 = local_7.member[0u];
                            let _e1405 = ((((_e1385[0] * _e1299) + (_e1385[1] * _e1302)) + (_e1385[2] * _e1305)) + (((_e1396[0] * _e1369) + (_e1396[1] * _e1370)) + (_e1396[2] * _e1371)));
                            let _e1408 = local_7.member[0u];
                            let _e1419 = local_7.member[1u];
                            let _e1428 = ((((_e1408[0] * _e1320) + (_e1408[1] * _e1323)) + (_e1408[2] * _e1326)) + (((_e1419[0] * _e1369) + (_e1419[1] * _e1370)) + (_e1419[2] * _e1371)));
                            let _e1431 = local_7.member[1u];
                            let _e1442 = local_7.member[0u];
                            if (_e1442[0] < 0f) {
                                phi_2114_ = -(_e1442[0]);
                            } else {
                                phi_2114_ = _e1442[0];
                            }
                            let _e1449 = phi_2114_;
                            if (_e1442[1] < 0f) {
                                phi_2121_ = -(_e1442[1]);
                            } else {
                                phi_2121_ = _e1442[1];
                            }
                            let _e1453 = phi_2121_;
                            if (_e1449 > _e1453) {
                                phi_2126_ = _e1449;
                            } else {
                                phi_2126_ = _e1453;
                            }
                            let _e1456 = phi_2126_;
                            if (_e1442[2] < 0f) {
                                phi_2133_ = -(_e1442[2]);
                            } else {
                                phi_2133_ = _e1442[2];
                            }
                            let _e1460 = phi_2133_;
                            if (_e1456 > _e1460) {
                                phi_2138_ = _e1456;
                            } else {
                                phi_2138_ = _e1460;
                            }
                            let _e1463 = phi_2138_;
                            let _e1466 = local_7.member[1u];
                            if (_e1466[0] < 0f) {
                                phi_2151_ = -(_e1466[0]);
                            } else {
                                phi_2151_ = _e1466[0];
                            }
                            let _e1473 = phi_2151_;
                            if (_e1466[1] < 0f) {
                                phi_2158_ = -(_e1466[1]);
                            } else {
                                phi_2158_ = _e1466[1];
                            }
                            let _e1477 = phi_2158_;
                            if (_e1473 > _e1477) {
                                phi_2163_ = _e1473;
                            } else {
                                phi_2163_ = _e1477;
                            }
                            let _e1480 = phi_2163_;
                            if (_e1466[2] < 0f) {
                                phi_2170_ = -(_e1466[2]);
                            } else {
                                phi_2170_ = _e1466[2];
                            }
                            let _e1484 = phi_2170_;
                            if (_e1480 > _e1484) {
                                phi_2175_ = _e1480;
                            } else {
                                phi_2175_ = _e1484;
                            }
                            let _e1487 = phi_2175_;
                            if (_e1463 > _e1487) {
                                phi_2180_ = _e1463;
                            } else {
                                phi_2180_ = _e1487;
                            }
                            let _e1490 = phi_2180_;
                            let _e1492 = local_7.member_3;
                            let _e1493 = (_e1490 + _e1492);
                            let _e1496 = local_7.member_1[0u];
                            if (_e1496[0] < 0f) {
                                phi_2197_ = -(_e1496[0]);
                            } else {
                                phi_2197_ = _e1496[0];
                            }
                            let _e1503 = phi_2197_;
                            if (_e1496[1] < 0f) {
                                phi_2204_ = -(_e1496[1]);
                            } else {
                                phi_2204_ = _e1496[1];
                            }
                            let _e1507 = phi_2204_;
                            if (_e1503 > _e1507) {
                                phi_2209_ = _e1503;
                            } else {
                                phi_2209_ = _e1507;
                            }
                            let _e1510 = phi_2209_;
                            if (_e1496[2] < 0f) {
                                phi_2216_ = -(_e1496[2]);
                            } else {
                                phi_2216_ = _e1496[2];
                            }
                            let _e1514 = phi_2216_;
                            if (_e1510 > _e1514) {
                                phi_2221_ = _e1510;
                            } else {
                                phi_2221_ = _e1514;
                            }
                            let _e1517 = phi_2221_;
                            let _e1520 = local_7.member_1[1u];
                            if (_e1520[0] < 0f) {
                                phi_2235_ = -(_e1520[0]);
                            } else {
                                phi_2235_ = _e1520[0];
                            }
                            let _e1527 = phi_2235_;
                            if (_e1520[1] < 0f) {
                                phi_2242_ = -(_e1520[1]);
                            } else {
                                phi_2242_ = _e1520[1];
                            }
                            let _e1531 = phi_2242_;
                            if (_e1527 > _e1531) {
                                phi_2247_ = _e1527;
                            } else {
                                phi_2247_ = _e1531;
                            }
                            let _e1534 = phi_2247_;
                            if (_e1520[2] < 0f) {
                                phi_2254_ = -(_e1520[2]);
                            } else {
                                phi_2254_ = _e1520[2];
                            }
                            let _e1538 = phi_2254_;
                            if (_e1534 > _e1538) {
                                phi_2259_ = _e1534;
                            } else {
                                phi_2259_ = _e1538;
                            }
                            let _e1541 = phi_2259_;
                            if (_e1517 > _e1541) {
                                phi_2264_ = _e1517;
                            } else {
                                phi_2264_ = _e1541;
                            }
                            let _e1544 = phi_2264_;
                            let _e1546 = local_7.member_3;
                            let _e1547 = (_e1544 + _e1546);
                            let _e1550 = local_7.member_2[0u];
                            if (_e1550[0] < 0f) {
                                phi_2281_ = -(_e1550[0]);
                            } else {
                                phi_2281_ = _e1550[0];
                            }
                            let _e1557 = phi_2281_;
                            if (_e1550[1] < 0f) {
                                phi_2288_ = -(_e1550[1]);
                            } else {
                                phi_2288_ = _e1550[1];
                            }
                            let _e1561 = phi_2288_;
                            if (_e1557 > _e1561) {
                                phi_2293_ = _e1557;
                            } else {
                                phi_2293_ = _e1561;
                            }
                            let _e1564 = phi_2293_;
                            if (_e1550[2] < 0f) {
                                phi_2300_ = -(_e1550[2]);
                            } else {
                                phi_2300_ = _e1550[2];
                            }
                            let _e1568 = phi_2300_;
                            if (_e1564 > _e1568) {
                                phi_2305_ = _e1564;
                            } else {
                                phi_2305_ = _e1568;
                            }
                            let _e1571 = phi_2305_;
                            let _e1574 = local_7.member_2[1u];
                            if (_e1574[0] < 0f) {
                                phi_2319_ = -(_e1574[0]);
                            } else {
                                phi_2319_ = _e1574[0];
                            }
                            let _e1581 = phi_2319_;
                            if (_e1574[1] < 0f) {
                                phi_2326_ = -(_e1574[1]);
                            } else {
                                phi_2326_ = _e1574[1];
                            }
                            let _e1585 = phi_2326_;
                            if (_e1581 > _e1585) {
                                phi_2331_ = _e1581;
                            } else {
                                phi_2331_ = _e1585;
                            }
                            let _e1588 = phi_2331_;
                            if (_e1574[2] < 0f) {
                                phi_2338_ = -(_e1574[2]);
                            } else {
                                phi_2338_ = _e1574[2];
                            }
                            let _e1592 = phi_2338_;
                            if (_e1588 > _e1592) {
                                phi_2343_ = _e1588;
                            } else {
                                phi_2343_ = _e1592;
                            }
                            let _e1595 = phi_2343_;
                            if (_e1571 > _e1595) {
                                phi_2348_ = _e1571;
                            } else {
                                phi_2348_ = _e1595;
                            }
                            let _e1598 = phi_2348_;
                            let _e1600 = local_7.member_3;
                            let _e1601 = (_e1598 + _e1600);
                            let _e1603 = ((_e1547 * 8f) * _e1601);
                            let _e1610 = local_7.member_3;
                            if (_e1299 < 0f) {
                                phi_2379_ = -(_e1299);
                            } else {
                                phi_2379_ = _e1299;
                            }
                            let _e1627 = phi_2379_;
                            if (_e1302 < 0f) {
                                phi_2385_ = -(_e1302);
                            } else {
                                phi_2385_ = _e1302;
                            }
                            let _e1631 = phi_2385_;
                            if (_e1305 < 0f) {
                                phi_2392_ = -(_e1305);
                            } else {
                                phi_2392_ = _e1305;
                            }
                            let _e1636 = phi_2392_;
                            let _e1637 = ((_e1627 + _e1631) + _e1636);
                            if (_e1320 < 0f) {
                                phi_2399_ = -(_e1320);
                            } else {
                                phi_2399_ = _e1320;
                            }
                            let _e1641 = phi_2399_;
                            if (_e1323 < 0f) {
                                phi_2405_ = -(_e1323);
                            } else {
                                phi_2405_ = _e1323;
                            }
                            let _e1645 = phi_2405_;
                            if (_e1326 < 0f) {
                                phi_2412_ = -(_e1326);
                            } else {
                                phi_2412_ = _e1326;
                            }
                            let _e1650 = phi_2412_;
                            let _e1651 = ((_e1641 + _e1645) + _e1650);
                            if (_e1637 > _e1651) {
                                phi_2418_ = _e1637;
                            } else {
                                phi_2418_ = _e1651;
                            }
                            let _e1654 = phi_2418_;
                            if (_e1369 < 0f) {
                                phi_2424_ = -(_e1369);
                            } else {
                                phi_2424_ = _e1369;
                            }
                            let _e1658 = phi_2424_;
                            if (_e1370 < 0f) {
                                phi_2430_ = -(_e1370);
                            } else {
                                phi_2430_ = _e1370;
                            }
                            let _e1662 = phi_2430_;
                            if (_e1371 < 0f) {
                                phi_2437_ = -(_e1371);
                            } else {
                                phi_2437_ = _e1371;
                            }
                            let _e1667 = phi_2437_;
                            let _e1669 = (((_e1658 + _e1662) + _e1667) * 0.5f);
                            if (_e1654 > _e1669) {
                                phi_2444_ = _e1654;
                            } else {
                                phi_2444_ = _e1669;
                            }
                            let _e1672 = phi_2444_;
                            let _e1677 = local_7.member_3;
                            let _e1690 = ((((_e1374[0] * _e1299) + (_e1374[1] * _e1302)) + (_e1374[2] * _e1305)) * 3f);
                            let _e1691 = ((((_e1431[0] * _e1320) + (_e1431[1] * _e1323)) + (_e1431[2] * _e1326)) * 3f);
                            if (_e1690 < _e1691) {
                                phi_2468_ = _e1690;
                            } else {
                                phi_2468_ = _e1691;
                            }
                            let _e1694 = phi_2468_;
                            if (_e1405 < _e1428) {
                                phi_2473_ = _e1405;
                            } else {
                                phi_2473_ = _e1428;
                            }
                            let _e1697 = phi_2473_;
                            if (_e1694 < _e1697) {
                                phi_2478_ = _e1694;
                            } else {
                                phi_2478_ = _e1697;
                            }
                            let _e1700 = phi_2478_;
                            if (_e1690 > _e1691) {
                                phi_2483_ = _e1690;
                            } else {
                                phi_2483_ = _e1691;
                            }
                            let _e1703 = phi_2483_;
                            if (_e1405 > _e1428) {
                                phi_2488_ = _e1405;
                            } else {
                                phi_2488_ = _e1428;
                            }
                            let _e1706 = phi_2488_;
                            if (_e1703 > _e1706) {
                                phi_2493_ = _e1703;
                            } else {
                                phi_2493_ = _e1706;
                            }
                            let _e1709 = phi_2493_;
                            let _e1714 = -(_e1709);
                            if (_e1700 > _e1714) {
                                phi_2503_ = _e1700;
                            } else {
                                phi_2503_ = _e1714;
                            }
                            let _e1717 = phi_2503_;
                            if ((_e1717 - ((((((_e1493 * 8f) * _e1603) * (0.000000059604645f * (490f / 64f))) + ((_e1610 * 19f) * ((_e1493 * (_e1547 + _e1601)) + (_e1547 * _e1601)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1493) * ((1f + _e1547) * (1f + _e1601))))) + ((_e1203 * (((_e1672 + (_e1603 * (0.000000059604645f * 4f))) + ((_e1677 * 6f) * (_e1547 + _e1601))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1547) * (1f + _e1601))))) * (3f * 1.0001f)))) > 0f) {
                                phi_3479_ = true;
                            } else {
                                let _e1722 = local_7.member_1[0u];
                                let _e1728 = local_7.member_1[1u];
                                let _e1732 = (_e1722[0] + _e1728[0]);
                                let _e1733 = (_e1722[1] + _e1728[1]);
                                let _e1734 = (_e1722[2] + _e1728[2]);
                                let _e1737 = local_7.member_2[0u];
                                let _e1743 = local_7.member_2[1u];
                                let _e1747 = (_e1737[0] + _e1743[0]);
                                let _e1748 = (_e1737[1] + _e1743[1]);
                                let _e1749 = (_e1737[2] + _e1743[2]);
                                let _e1752 = ((_e1733 * _e1749) - (_e1734 * _e1748));
                                let _e1755 = ((_e1734 * _e1747) - (_e1732 * _e1749));
                                let _e1758 = ((_e1732 * _e1748) - (_e1733 * _e1747));
                                let _e1761 = local_7.member[0u];
                                let _e1767 = local_7.member_1[0u];
                                let _e1773 = local_7.member_2[0u];
                                let _e1785 = local_7.member[1u];
                                let _e1791 = local_7.member_1[1u];
                                let _e1797 = local_7.member_2[1u];
                                local_5 = array<array<f32, 3>, 4>(_e1761, array<f32, 3>((_e1761[0] - _e1767[0]), (_e1761[1] - _e1767[1]), (_e1761[2] - _e1767[2])), array<f32, 3>((_e1761[0] - _e1773[0]), (_e1761[1] - _e1773[1]), (_e1761[2] - _e1773[2])), _e1761);
                                local_6 = array<array<f32, 3>, 4>(_e1785, array<f32, 3>((_e1785[0] - _e1791[0]), (_e1785[1] - _e1791[1]), (_e1785[2] - _e1791[2])), array<f32, 3>((_e1785[0] - _e1797[0]), (_e1785[1] - _e1797[1]), (_e1785[2] - _e1797[2])), _e1785);
                                let _e1815 = local_7.member[0u];
                                if (_e1815[0] < 0f) {
                                    phi_2754_ = -(_e1815[0]);
                                } else {
                                    phi_2754_ = _e1815[0];
                                }
                                let _e1822 = phi_2754_;
                                if (_e1815[1] < 0f) {
                                    phi_2761_ = -(_e1815[1]);
                                } else {
                                    phi_2761_ = _e1815[1];
                                }
                                let _e1826 = phi_2761_;
                                if (_e1822 > _e1826) {
                                    phi_2766_ = _e1822;
                                } else {
                                    phi_2766_ = _e1826;
                                }
                                let _e1829 = phi_2766_;
                                if (_e1815[2] < 0f) {
                                    phi_2773_ = -(_e1815[2]);
                                } else {
                                    phi_2773_ = _e1815[2];
                                }
                                let _e1833 = phi_2773_;
                                if (_e1829 > _e1833) {
                                    phi_2778_ = _e1829;
                                } else {
                                    phi_2778_ = _e1833;
                                }
                                let _e1836 = phi_2778_;
                                let _e1839 = local_7.member[1u];
                                if (_e1839[0] < 0f) {
                                    phi_2791_ = -(_e1839[0]);
                                } else {
                                    phi_2791_ = _e1839[0];
                                }
                                let _e1846 = phi_2791_;
                                if (_e1839[1] < 0f) {
                                    phi_2798_ = -(_e1839[1]);
                                } else {
                                    phi_2798_ = _e1839[1];
                                }
                                let _e1850 = phi_2798_;
                                if (_e1846 > _e1850) {
                                    phi_2803_ = _e1846;
                                } else {
                                    phi_2803_ = _e1850;
                                }
                                let _e1853 = phi_2803_;
                                if (_e1839[2] < 0f) {
                                    phi_2810_ = -(_e1839[2]);
                                } else {
                                    phi_2810_ = _e1839[2];
                                }
                                let _e1857 = phi_2810_;
                                if (_e1853 > _e1857) {
                                    phi_2815_ = _e1853;
                                } else {
                                    phi_2815_ = _e1857;
                                }
                                let _e1860 = phi_2815_;
                                if (_e1836 > _e1860) {
                                    phi_2820_ = _e1836;
                                } else {
                                    phi_2820_ = _e1860;
                                }
                                let _e1863 = phi_2820_;
                                let _e1865 = local_7.member_3;
                                let _e1869 = local_7.member_1[0u];
                                if (_e1869[0] < 0f) {
                                    phi_2837_ = -(_e1869[0]);
                                } else {
                                    phi_2837_ = _e1869[0];
                                }
                                let _e1876 = phi_2837_;
                                if (_e1869[1] < 0f) {
                                    phi_2844_ = -(_e1869[1]);
                                } else {
                                    phi_2844_ = _e1869[1];
                                }
                                let _e1880 = phi_2844_;
                                if (_e1876 > _e1880) {
                                    phi_2849_ = _e1876;
                                } else {
                                    phi_2849_ = _e1880;
                                }
                                let _e1883 = phi_2849_;
                                if (_e1869[2] < 0f) {
                                    phi_2856_ = -(_e1869[2]);
                                } else {
                                    phi_2856_ = _e1869[2];
                                }
                                let _e1887 = phi_2856_;
                                if (_e1883 > _e1887) {
                                    phi_2861_ = _e1883;
                                } else {
                                    phi_2861_ = _e1887;
                                }
                                let _e1890 = phi_2861_;
                                let _e1893 = local_7.member_1[1u];
                                if (_e1893[0] < 0f) {
                                    phi_2875_ = -(_e1893[0]);
                                } else {
                                    phi_2875_ = _e1893[0];
                                }
                                let _e1900 = phi_2875_;
                                if (_e1893[1] < 0f) {
                                    phi_2882_ = -(_e1893[1]);
                                } else {
                                    phi_2882_ = _e1893[1];
                                }
                                let _e1904 = phi_2882_;
                                if (_e1900 > _e1904) {
                                    phi_2887_ = _e1900;
                                } else {
                                    phi_2887_ = _e1904;
                                }
                                let _e1907 = phi_2887_;
                                if (_e1893[2] < 0f) {
                                    phi_2894_ = -(_e1893[2]);
                                } else {
                                    phi_2894_ = _e1893[2];
                                }
                                let _e1911 = phi_2894_;
                                if (_e1907 > _e1911) {
                                    phi_2899_ = _e1907;
                                } else {
                                    phi_2899_ = _e1911;
                                }
                                let _e1914 = phi_2899_;
                                if (_e1890 > _e1914) {
                                    phi_2904_ = _e1890;
                                } else {
                                    phi_2904_ = _e1914;
                                }
                                let _e1917 = phi_2904_;
                                let _e1919 = local_7.member_3;
                                let _e1923 = local_7.member_2[0u];
                                if (_e1923[0] < 0f) {
                                    phi_2921_ = -(_e1923[0]);
                                } else {
                                    phi_2921_ = _e1923[0];
                                }
                                let _e1930 = phi_2921_;
                                if (_e1923[1] < 0f) {
                                    phi_2928_ = -(_e1923[1]);
                                } else {
                                    phi_2928_ = _e1923[1];
                                }
                                let _e1934 = phi_2928_;
                                if (_e1930 > _e1934) {
                                    phi_2933_ = _e1930;
                                } else {
                                    phi_2933_ = _e1934;
                                }
                                let _e1937 = phi_2933_;
                                if (_e1923[2] < 0f) {
                                    phi_2940_ = -(_e1923[2]);
                                } else {
                                    phi_2940_ = _e1923[2];
                                }
                                let _e1941 = phi_2940_;
                                if (_e1937 > _e1941) {
                                    phi_2945_ = _e1937;
                                } else {
                                    phi_2945_ = _e1941;
                                }
                                let _e1944 = phi_2945_;
                                let _e1947 = local_7.member_2[1u];
                                if (_e1947[0] < 0f) {
                                    phi_2959_ = -(_e1947[0]);
                                } else {
                                    phi_2959_ = _e1947[0];
                                }
                                let _e1954 = phi_2959_;
                                if (_e1947[1] < 0f) {
                                    phi_2966_ = -(_e1947[1]);
                                } else {
                                    phi_2966_ = _e1947[1];
                                }
                                let _e1958 = phi_2966_;
                                if (_e1954 > _e1958) {
                                    phi_2971_ = _e1954;
                                } else {
                                    phi_2971_ = _e1958;
                                }
                                let _e1961 = phi_2971_;
                                if (_e1947[2] < 0f) {
                                    phi_2978_ = -(_e1947[2]);
                                } else {
                                    phi_2978_ = _e1947[2];
                                }
                                let _e1965 = phi_2978_;
                                if (_e1961 > _e1965) {
                                    phi_2983_ = _e1961;
                                } else {
                                    phi_2983_ = _e1965;
                                }
                                let _e1968 = phi_2983_;
                                if (_e1944 > _e1968) {
                                    phi_2988_ = _e1944;
                                } else {
                                    phi_2988_ = _e1968;
                                }
                                let _e1971 = phi_2988_;
                                let _e1973 = local_7.member_3;
                                let _e1976 = (((_e1863 + _e1865) + (_e1917 + _e1919)) + (_e1971 + _e1973));
                                let _e1979 = local_7.member_3;
                                let _e1983 = (((_e1203 * 1.0001f) + (_e1979 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e1986 = ((_e1755 * _e1734) - (_e1758 * _e1733));
                                let _e1989 = ((_e1758 * _e1732) - (_e1752 * _e1734));
                                let _e1992 = ((_e1752 * _e1733) - (_e1755 * _e1732));
                                let _e1994 = local_5[0u];
                                let _e2002 = (((_e1986 * _e1994[0]) + (_e1989 * _e1994[1])) + (_e1992 * _e1994[2]));
                                phi_3026_ = type_37(0u, 4u);
                                phi_3029_ = _e2002;
                                phi_3031_ = _e2002;
                                loop {
                                    let _e2004 = phi_3026_;
                                    let _e2006 = phi_3029_;
                                    let _e2008 = phi_3031_;
                                    local_30 = _e2006;
                                    local_31 = _e2008;
                                    local_49 = _e2008;
                                    if (_e2004.member < _e2004.member_1) {
                                        phi_3027_ = type_37((_e2004.member + 1u), _e2004.member_1);
                                        phi_3054_ = type_37(1u, _e2004.member);
                                    } else {
                                        phi_3027_ = _e2004;
                                        phi_3054_ = type_37(0u, type_37().member_1);
                                    }
                                    let _e2022 = phi_3027_;
                                    let _e2024 = phi_3054_;
                                    let _e2028 = (bitcast<i32>(_e2024.member) != 0i);
                                    if _e2028 {
                                        if (_e2024.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2031 = local_5[_e2024.member_1];
                                        let _e2039 = (((_e1986 * _e2031[0]) + (_e1989 * _e2031[1])) + (_e1992 * _e2031[2]));
                                        if (_e2024.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2042 = local_6[_e2024.member_1];
                                        let _e2050 = (((_e1986 * _e2042[0]) + (_e1989 * _e2042[1])) + (_e1992 * _e2042[2]));
                                        if (_e2008 < _e2039) {
                                            phi_3104_ = _e2008;
                                        } else {
                                            phi_3104_ = _e2039;
                                        }
                                        let _e2053 = phi_3104_;
                                        if (_e2053 < _e2050) {
                                            phi_3109_ = _e2053;
                                        } else {
                                            phi_3109_ = _e2050;
                                        }
                                        let _e2056 = phi_3109_;
                                        if (_e2006 > _e2039) {
                                            phi_3114_ = _e2006;
                                        } else {
                                            phi_3114_ = _e2039;
                                        }
                                        let _e2059 = phi_3114_;
                                        if (_e2059 > _e2050) {
                                            phi_3119_ = _e2059;
                                        } else {
                                            phi_3119_ = _e2050;
                                        }
                                        let _e2062 = phi_3119_;
                                        phi_3030_ = _e2062;
                                        phi_3032_ = _e2056;
                                    } else {
                                        phi_3030_ = f32();
                                        phi_3032_ = f32();
                                    }
                                    let _e2064 = phi_3030_;
                                    let _e2066 = phi_3032_;
                                    continue;
                                    continuing {
                                        phi_3026_ = _e2022;
                                        phi_3029_ = _e2064;
                                        phi_3031_ = _e2066;
                                        break if !(_e2028);
                                    }
                                }
                                if (_e1986 < 0f) {
                                    phi_3125_ = -(_e1986);
                                } else {
                                    phi_3125_ = _e1986;
                                }
                                let _e2071 = phi_3125_;
                                if (_e1989 < 0f) {
                                    phi_3131_ = -(_e1989);
                                } else {
                                    phi_3131_ = _e1989;
                                }
                                let _e2075 = phi_3131_;
                                if (_e1992 < 0f) {
                                    phi_3138_ = -(_e1992);
                                } else {
                                    phi_3138_ = _e1992;
                                }
                                let _e2080 = phi_3138_;
                                let _e2081 = ((_e2071 + _e2075) + _e2080);
                                let _e2086 = local_30;
                                let _e2087 = -(_e2086);
                                let _e2089 = local_31;
                                if (_e2089 > _e2087) {
                                    let _e4874 = local_49;
                                    phi_3148_ = _e4874;
                                } else {
                                    phi_3148_ = _e2087;
                                }
                                let _e2092 = phi_3148_;
                                let _e2097 = (((_e2092 - ((_e2081 * _e1976) * (0.000000059604645f * 17f))) - (_e2081 * _e1983)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2100 = ((_e1755 * _e1749) - (_e1758 * _e1748));
                                let _e2103 = ((_e1758 * _e1747) - (_e1752 * _e1749));
                                let _e2106 = ((_e1752 * _e1748) - (_e1755 * _e1747));
                                let _e2108 = local_5[0u];
                                let _e2116 = (((_e2100 * _e2108[0]) + (_e2103 * _e2108[1])) + (_e2106 * _e2108[2]));
                                phi_3179_ = type_37(0u, 4u);
                                phi_3182_ = _e2116;
                                phi_3184_ = _e2116;
                                loop {
                                    let _e2118 = phi_3179_;
                                    let _e2120 = phi_3182_;
                                    let _e2122 = phi_3184_;
                                    local_32 = _e2120;
                                    local_33 = _e2122;
                                    local_50 = _e2122;
                                    if (_e2118.member < _e2118.member_1) {
                                        phi_3180_ = type_37((_e2118.member + 1u), _e2118.member_1);
                                        phi_3207_ = type_37(1u, _e2118.member);
                                    } else {
                                        phi_3180_ = _e2118;
                                        phi_3207_ = type_37(0u, type_37().member_1);
                                    }
                                    let _e2136 = phi_3180_;
                                    let _e2138 = phi_3207_;
                                    let _e2142 = (bitcast<i32>(_e2138.member) != 0i);
                                    if _e2142 {
                                        if (_e2138.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2145 = local_5[_e2138.member_1];
                                        let _e2153 = (((_e2100 * _e2145[0]) + (_e2103 * _e2145[1])) + (_e2106 * _e2145[2]));
                                        if (_e2138.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2156 = local_6[_e2138.member_1];
                                        let _e2164 = (((_e2100 * _e2156[0]) + (_e2103 * _e2156[1])) + (_e2106 * _e2156[2]));
                                        if (_e2122 < _e2153) {
                                            phi_3257_ = _e2122;
                                        } else {
                                            phi_3257_ = _e2153;
                                        }
                                        let _e2167 = phi_3257_;
                                        if (_e2167 < _e2164) {
                                            phi_3262_ = _e2167;
                                        } else {
                                            phi_3262_ = _e2164;
                                        }
                                        let _e2170 = phi_3262_;
                                        if (_e2120 > _e2153) {
                                            phi_3267_ = _e2120;
                                        } else {
                                            phi_3267_ = _e2153;
                                        }
                                        let _e2173 = phi_3267_;
                                        if (_e2173 > _e2164) {
                                            phi_3272_ = _e2173;
                                        } else {
                                            phi_3272_ = _e2164;
                                        }
                                        let _e2176 = phi_3272_;
                                        phi_3183_ = _e2176;
                                        phi_3185_ = _e2170;
                                    } else {
                                        phi_3183_ = f32();
                                        phi_3185_ = f32();
                                    }
                                    let _e2178 = phi_3183_;
                                    let _e2180 = phi_3185_;
                                    continue;
                                    continuing {
                                        phi_3179_ = _e2136;
                                        phi_3182_ = _e2178;
                                        phi_3184_ = _e2180;
                                        break if !(_e2142);
                                    }
                                }
                                if (_e2100 < 0f) {
                                    phi_3278_ = -(_e2100);
                                } else {
                                    phi_3278_ = _e2100;
                                }
                                let _e2185 = phi_3278_;
                                if (_e2103 < 0f) {
                                    phi_3284_ = -(_e2103);
                                } else {
                                    phi_3284_ = _e2103;
                                }
                                let _e2189 = phi_3284_;
                                if (_e2106 < 0f) {
                                    phi_3291_ = -(_e2106);
                                } else {
                                    phi_3291_ = _e2106;
                                }
                                let _e2194 = phi_3291_;
                                let _e2195 = ((_e2185 + _e2189) + _e2194);
                                let _e2200 = local_32;
                                let _e2201 = -(_e2200);
                                let _e2203 = local_33;
                                if (_e2203 > _e2201) {
                                    let _e4893 = local_50;
                                    phi_3301_ = _e4893;
                                } else {
                                    phi_3301_ = _e2201;
                                }
                                let _e2206 = phi_3301_;
                                let _e2211 = (((_e2206 - ((_e2195 * _e1976) * (0.000000059604645f * 17f))) - (_e2195 * _e1983)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2097 > _e2211) {
                                    phi_3311_ = _e2097;
                                } else {
                                    phi_3311_ = _e2211;
                                }
                                let _e2214 = phi_3311_;
                                let _e2215 = (_e1747 - _e1732);
                                let _e2216 = (_e1748 - _e1733);
                                let _e2217 = (_e1749 - _e1734);
                                let _e2220 = ((_e1755 * _e2217) - (_e1758 * _e2216));
                                let _e2223 = ((_e1758 * _e2215) - (_e1752 * _e2217));
                                let _e2226 = ((_e1752 * _e2216) - (_e1755 * _e2215));
                                let _e2228 = local_5[0u];
                                let _e2236 = (((_e2220 * _e2228[0]) + (_e2223 * _e2228[1])) + (_e2226 * _e2228[2]));
                                phi_3344_ = type_37(0u, 4u);
                                phi_3347_ = _e2236;
                                phi_3349_ = _e2236;
                                loop {
                                    let _e2238 = phi_3344_;
                                    let _e2240 = phi_3347_;
                                    let _e2242 = phi_3349_;
                                    local_34 = _e2240;
                                    local_35 = _e2242;
                                    local_51 = _e2242;
                                    if (_e2238.member < _e2238.member_1) {
                                        phi_3345_ = type_37((_e2238.member + 1u), _e2238.member_1);
                                        phi_3372_ = type_37(1u, _e2238.member);
                                    } else {
                                        phi_3345_ = _e2238;
                                        phi_3372_ = type_37(0u, type_37().member_1);
                                    }
                                    let _e2256 = phi_3345_;
                                    let _e2258 = phi_3372_;
                                    let _e2262 = (bitcast<i32>(_e2258.member) != 0i);
                                    if _e2262 {
                                        if (_e2258.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2265 = local_5[_e2258.member_1];
                                        let _e2273 = (((_e2220 * _e2265[0]) + (_e2223 * _e2265[1])) + (_e2226 * _e2265[2]));
                                        if (_e2258.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2276 = local_6[_e2258.member_1];
                                        let _e2284 = (((_e2220 * _e2276[0]) + (_e2223 * _e2276[1])) + (_e2226 * _e2276[2]));
                                        if (_e2242 < _e2273) {
                                            phi_3422_ = _e2242;
                                        } else {
                                            phi_3422_ = _e2273;
                                        }
                                        let _e2287 = phi_3422_;
                                        if (_e2287 < _e2284) {
                                            phi_3427_ = _e2287;
                                        } else {
                                            phi_3427_ = _e2284;
                                        }
                                        let _e2290 = phi_3427_;
                                        if (_e2240 > _e2273) {
                                            phi_3432_ = _e2240;
                                        } else {
                                            phi_3432_ = _e2273;
                                        }
                                        let _e2293 = phi_3432_;
                                        if (_e2293 > _e2284) {
                                            phi_3437_ = _e2293;
                                        } else {
                                            phi_3437_ = _e2284;
                                        }
                                        let _e2296 = phi_3437_;
                                        phi_3348_ = _e2296;
                                        phi_3350_ = _e2290;
                                    } else {
                                        phi_3348_ = f32();
                                        phi_3350_ = f32();
                                    }
                                    let _e2298 = phi_3348_;
                                    let _e2300 = phi_3350_;
                                    continue;
                                    continuing {
                                        phi_3344_ = _e2256;
                                        phi_3347_ = _e2298;
                                        phi_3349_ = _e2300;
                                        break if !(_e2262);
                                    }
                                }
                                if (_e2220 < 0f) {
                                    phi_3443_ = -(_e2220);
                                } else {
                                    phi_3443_ = _e2220;
                                }
                                let _e2305 = phi_3443_;
                                if (_e2223 < 0f) {
                                    phi_3449_ = -(_e2223);
                                } else {
                                    phi_3449_ = _e2223;
                                }
                                let _e2309 = phi_3449_;
                                if (_e2226 < 0f) {
                                    phi_3456_ = -(_e2226);
                                } else {
                                    phi_3456_ = _e2226;
                                }
                                let _e2314 = phi_3456_;
                                let _e2315 = ((_e2305 + _e2309) + _e2314);
                                let _e2320 = local_34;
                                let _e2321 = -(_e2320);
                                let _e2323 = local_35;
                                if (_e2323 > _e2321) {
                                    let _e4913 = local_51;
                                    phi_3466_ = _e4913;
                                } else {
                                    phi_3466_ = _e2321;
                                }
                                let _e2326 = phi_3466_;
                                let _e2331 = (((_e2326 - ((_e2315 * _e1976) * (0.000000059604645f * 17f))) - (_e2315 * _e1983)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2214 > _e2331) {
                                    phi_3476_ = _e2214;
                                } else {
                                    phi_3476_ = _e2331;
                                }
                                let _e2334 = phi_3476_;
                                phi_3479_ = (_e2334 > 0f);
                            }
                            let _e2337 = phi_3479_;
                            if _e2337 {
                                phi_6915_ = false;
                            } else {
                                let _e2340 = local_7.member[0u];
                                let _e2346 = local_7.member[1u];
                                let _e2353 = ((_e2340[0] + _e2346[0]) * 0.5f);
                                let _e2354 = ((_e2340[1] + _e2346[1]) * 0.5f);
                                let _e2355 = ((_e2340[2] + _e2346[2]) * 0.5f);
                                let _e2358 = local_7.member_1[0u];
                                let _e2364 = local_7.member_1[1u];
                                let _e2371 = ((_e2358[0] + _e2364[0]) * 0.5f);
                                let _e2372 = ((_e2358[1] + _e2364[1]) * 0.5f);
                                let _e2373 = ((_e2358[2] + _e2364[2]) * 0.5f);
                                let _e2376 = local_7.member_2[0u];
                                let _e2382 = local_7.member_2[1u];
                                let _e2389 = ((_e2376[0] + _e2382[0]) * 0.5f);
                                let _e2390 = ((_e2376[1] + _e2382[1]) * 0.5f);
                                let _e2391 = ((_e2376[2] + _e2382[2]) * 0.5f);
                                let _e2394 = local_7.member[0u];
                                let _e2397 = local_7.member_1[0u];
                                let _e2400 = local_7.member_2[0u];
                                let _e2402 = local_7.member_3;
                                let _e2405 = local_7.member[1u];
                                let _e2408 = local_7.member_1[1u];
                                let _e2411 = local_7.member_2[1u];
                                let _e2413 = local_7.member_3;
                                local_4 = array<type_72, 2>(type_72(array<array<f32, 3>, 2>(_e2394, array<f32, 3>(_e2353, _e2354, _e2355)), array<array<f32, 3>, 2>(_e2397, array<f32, 3>(_e2371, _e2372, _e2373)), array<array<f32, 3>, 2>(_e2400, array<f32, 3>(_e2389, _e2390, _e2391)), _e2402), type_72(array<array<f32, 3>, 2>(array<f32, 3>(_e2353, _e2354, _e2355), _e2405), array<array<f32, 3>, 2>(array<f32, 3>(_e2371, _e2372, _e2373), _e2408), array<array<f32, 3>, 2>(array<f32, 3>(_e2389, _e2390, _e2391), _e2411), _e2413));
                                let _e2432 = local_4[0u].member_1[0u];
                                let _e2438 = local_4[0u].member_2[0u];
                                let _e2444 = ((_e2432[1] * _e2438[2]) - (_e2432[2] * _e2438[1]));
                                let _e2447 = ((_e2432[2] * _e2438[0]) - (_e2432[0] * _e2438[2]));
                                let _e2450 = ((_e2432[0] * _e2438[1]) - (_e2432[1] * _e2438[0]));
                                let _e2453 = local_4[0u].member_1[1u];
                                let _e2459 = local_4[0u].member_2[1u];
                                let _e2465 = ((_e2453[1] * _e2459[2]) - (_e2453[2] * _e2459[1]));
                                let _e2468 = ((_e2453[2] * _e2459[0]) - (_e2453[0] * _e2459[2]));
                                let _e2471 = ((_e2453[0] * _e2459[1]) - (_e2453[1] * _e2459[0]));
                                let _e2474 = local_4[0u].member_1[0u];
                                let _e2480 = local_4[0u].member_2[1u];
                                let _e2495 = local_4[0u].member_1[1u];
                                let _e2501 = local_4[0u].member_2[0u];
                                let _e2514 = (((_e2474[1] * _e2480[2]) - (_e2474[2] * _e2480[1])) + ((_e2495[1] * _e2501[2]) - (_e2495[2] * _e2501[1])));
                                let _e2515 = (((_e2474[2] * _e2480[0]) - (_e2474[0] * _e2480[2])) + ((_e2495[2] * _e2501[0]) - (_e2495[0] * _e2501[2])));
                                let _e2516 = (((_e2474[0] * _e2480[1]) - (_e2474[1] * _e2480[0])) + ((_e2495[0] * _e2501[1]) - (_e2495[1] * _e2501[0])));
                                let _e2519 = local_4[0u].member[0u];
                                let _e2530 = local_4[0u].member[1u];
                                let _e2541 = local_4[0u].member[0u];
                                let _e2550 = ((((_e2530[0] * _e2444) + (_e2530[1] * _e2447)) + (_e2530[2] * _e2450)) + (((_e2541[0] * _e2514) + (_e2541[1] * _e2515)) + (_e2541[2] * _e2516)));
                                let _e2553 = local_4[0u].member[0u];
                                let _e2564 = local_4[0u].member[1u];
                                let _e2573 = ((((_e2553[0] * _e2465) + (_e2553[1] * _e2468)) + (_e2553[2] * _e2471)) + (((_e2564[0] * _e2514) + (_e2564[1] * _e2515)) + (_e2564[2] * _e2516)));
                                let _e2576 = local_4[0u].member[1u];
                                let _e2587 = local_4[0u].member[0u];
                                if (_e2587[0] < 0f) {
                                    phi_3936_ = -(_e2587[0]);
                                } else {
                                    phi_3936_ = _e2587[0];
                                }
                                let _e2594 = phi_3936_;
                                if (_e2587[1] < 0f) {
                                    phi_3943_ = -(_e2587[1]);
                                } else {
                                    phi_3943_ = _e2587[1];
                                }
                                let _e2598 = phi_3943_;
                                if (_e2594 > _e2598) {
                                    phi_3948_ = _e2594;
                                } else {
                                    phi_3948_ = _e2598;
                                }
                                let _e2601 = phi_3948_;
                                if (_e2587[2] < 0f) {
                                    phi_3955_ = -(_e2587[2]);
                                } else {
                                    phi_3955_ = _e2587[2];
                                }
                                let _e2605 = phi_3955_;
                                if (_e2601 > _e2605) {
                                    phi_3960_ = _e2601;
                                } else {
                                    phi_3960_ = _e2605;
                                }
                                let _e2608 = phi_3960_;
                                let _e2611 = local_4[0u].member[1u];
                                if (_e2611[0] < 0f) {
                                    phi_3973_ = -(_e2611[0]);
                                } else {
                                    phi_3973_ = _e2611[0];
                                }
                                let _e2618 = phi_3973_;
                                if (_e2611[1] < 0f) {
                                    phi_3980_ = -(_e2611[1]);
                                } else {
                                    phi_3980_ = _e2611[1];
                                }
                                let _e2622 = phi_3980_;
                                if (_e2618 > _e2622) {
                                    phi_3985_ = _e2618;
                                } else {
                                    phi_3985_ = _e2622;
                                }
                                let _e2625 = phi_3985_;
                                if (_e2611[2] < 0f) {
                                    phi_3992_ = -(_e2611[2]);
                                } else {
                                    phi_3992_ = _e2611[2];
                                }
                                let _e2629 = phi_3992_;
                                if (_e2625 > _e2629) {
                                    phi_3997_ = _e2625;
                                } else {
                                    phi_3997_ = _e2629;
                                }
                                let _e2632 = phi_3997_;
                                if (_e2608 > _e2632) {
                                    phi_4002_ = _e2608;
                                } else {
                                    phi_4002_ = _e2632;
                                }
                                let _e2635 = phi_4002_;
                                let _e2637 = local_4[0u].member_3;
                                let _e2638 = (_e2635 + _e2637);
                                let _e2641 = local_4[0u].member_1[0u];
                                if (_e2641[0] < 0f) {
                                    phi_4019_ = -(_e2641[0]);
                                } else {
                                    phi_4019_ = _e2641[0];
                                }
                                let _e2648 = phi_4019_;
                                if (_e2641[1] < 0f) {
                                    phi_4026_ = -(_e2641[1]);
                                } else {
                                    phi_4026_ = _e2641[1];
                                }
                                let _e2652 = phi_4026_;
                                if (_e2648 > _e2652) {
                                    phi_4031_ = _e2648;
                                } else {
                                    phi_4031_ = _e2652;
                                }
                                let _e2655 = phi_4031_;
                                if (_e2641[2] < 0f) {
                                    phi_4038_ = -(_e2641[2]);
                                } else {
                                    phi_4038_ = _e2641[2];
                                }
                                let _e2659 = phi_4038_;
                                if (_e2655 > _e2659) {
                                    phi_4043_ = _e2655;
                                } else {
                                    phi_4043_ = _e2659;
                                }
                                let _e2662 = phi_4043_;
                                let _e2665 = local_4[0u].member_1[1u];
                                if (_e2665[0] < 0f) {
                                    phi_4057_ = -(_e2665[0]);
                                } else {
                                    phi_4057_ = _e2665[0];
                                }
                                let _e2672 = phi_4057_;
                                if (_e2665[1] < 0f) {
                                    phi_4064_ = -(_e2665[1]);
                                } else {
                                    phi_4064_ = _e2665[1];
                                }
                                let _e2676 = phi_4064_;
                                if (_e2672 > _e2676) {
                                    phi_4069_ = _e2672;
                                } else {
                                    phi_4069_ = _e2676;
                                }
                                let _e2679 = phi_4069_;
                                if (_e2665[2] < 0f) {
                                    phi_4076_ = -(_e2665[2]);
                                } else {
                                    phi_4076_ = _e2665[2];
                                }
                                let _e2683 = phi_4076_;
                                if (_e2679 > _e2683) {
                                    phi_4081_ = _e2679;
                                } else {
                                    phi_4081_ = _e2683;
                                }
                                let _e2686 = phi_4081_;
                                if (_e2662 > _e2686) {
                                    phi_4086_ = _e2662;
                                } else {
                                    phi_4086_ = _e2686;
                                }
                                let _e2689 = phi_4086_;
                                let _e2691 = local_4[0u].member_3;
                                let _e2692 = (_e2689 + _e2691);
                                let _e2695 = local_4[0u].member_2[0u];
                                if (_e2695[0] < 0f) {
                                    phi_4103_ = -(_e2695[0]);
                                } else {
                                    phi_4103_ = _e2695[0];
                                }
                                let _e2702 = phi_4103_;
                                if (_e2695[1] < 0f) {
                                    phi_4110_ = -(_e2695[1]);
                                } else {
                                    phi_4110_ = _e2695[1];
                                }
                                let _e2706 = phi_4110_;
                                if (_e2702 > _e2706) {
                                    phi_4115_ = _e2702;
                                } else {
                                    phi_4115_ = _e2706;
                                }
                                let _e2709 = phi_4115_;
                                if (_e2695[2] < 0f) {
                                    phi_4122_ = -(_e2695[2]);
                                } else {
                                    phi_4122_ = _e2695[2];
                                }
                                let _e2713 = phi_4122_;
                                if (_e2709 > _e2713) {
                                    phi_4127_ = _e2709;
                                } else {
                                    phi_4127_ = _e2713;
                                }
                                let _e2716 = phi_4127_;
                                let _e2719 = local_4[0u].member_2[1u];
                                if (_e2719[0] < 0f) {
                                    phi_4141_ = -(_e2719[0]);
                                } else {
                                    phi_4141_ = _e2719[0];
                                }
                                let _e2726 = phi_4141_;
                                if (_e2719[1] < 0f) {
                                    phi_4148_ = -(_e2719[1]);
                                } else {
                                    phi_4148_ = _e2719[1];
                                }
                                let _e2730 = phi_4148_;
                                if (_e2726 > _e2730) {
                                    phi_4153_ = _e2726;
                                } else {
                                    phi_4153_ = _e2730;
                                }
                                let _e2733 = phi_4153_;
                                if (_e2719[2] < 0f) {
                                    phi_4160_ = -(_e2719[2]);
                                } else {
                                    phi_4160_ = _e2719[2];
                                }
                                let _e2737 = phi_4160_;
                                if (_e2733 > _e2737) {
                                    phi_4165_ = _e2733;
                                } else {
                                    phi_4165_ = _e2737;
                                }
                                let _e2740 = phi_4165_;
                                if (_e2716 > _e2740) {
                                    phi_4170_ = _e2716;
                                } else {
                                    phi_4170_ = _e2740;
                                }
                                let _e2743 = phi_4170_;
                                let _e2745 = local_4[0u].member_3;
                                let _e2746 = (_e2743 + _e2745);
                                let _e2748 = ((_e2692 * 8f) * _e2746);
                                let _e2755 = local_4[0u].member_3;
                                if (_e2444 < 0f) {
                                    phi_4201_ = -(_e2444);
                                } else {
                                    phi_4201_ = _e2444;
                                }
                                let _e2772 = phi_4201_;
                                if (_e2447 < 0f) {
                                    phi_4207_ = -(_e2447);
                                } else {
                                    phi_4207_ = _e2447;
                                }
                                let _e2776 = phi_4207_;
                                if (_e2450 < 0f) {
                                    phi_4214_ = -(_e2450);
                                } else {
                                    phi_4214_ = _e2450;
                                }
                                let _e2781 = phi_4214_;
                                let _e2782 = ((_e2772 + _e2776) + _e2781);
                                if (_e2465 < 0f) {
                                    phi_4221_ = -(_e2465);
                                } else {
                                    phi_4221_ = _e2465;
                                }
                                let _e2786 = phi_4221_;
                                if (_e2468 < 0f) {
                                    phi_4227_ = -(_e2468);
                                } else {
                                    phi_4227_ = _e2468;
                                }
                                let _e2790 = phi_4227_;
                                if (_e2471 < 0f) {
                                    phi_4234_ = -(_e2471);
                                } else {
                                    phi_4234_ = _e2471;
                                }
                                let _e2795 = phi_4234_;
                                let _e2796 = ((_e2786 + _e2790) + _e2795);
                                if (_e2782 > _e2796) {
                                    phi_4240_ = _e2782;
                                } else {
                                    phi_4240_ = _e2796;
                                }
                                let _e2799 = phi_4240_;
                                if (_e2514 < 0f) {
                                    phi_4246_ = -(_e2514);
                                } else {
                                    phi_4246_ = _e2514;
                                }
                                let _e2803 = phi_4246_;
                                if (_e2515 < 0f) {
                                    phi_4252_ = -(_e2515);
                                } else {
                                    phi_4252_ = _e2515;
                                }
                                let _e2807 = phi_4252_;
                                if (_e2516 < 0f) {
                                    phi_4259_ = -(_e2516);
                                } else {
                                    phi_4259_ = _e2516;
                                }
                                let _e2812 = phi_4259_;
                                let _e2814 = (((_e2803 + _e2807) + _e2812) * 0.5f);
                                if (_e2799 > _e2814) {
                                    phi_4266_ = _e2799;
                                } else {
                                    phi_4266_ = _e2814;
                                }
                                let _e2817 = phi_4266_;
                                let _e2822 = local_4[0u].member_3;
                                let _e2835 = ((((_e2519[0] * _e2444) + (_e2519[1] * _e2447)) + (_e2519[2] * _e2450)) * 3f);
                                let _e2836 = ((((_e2576[0] * _e2465) + (_e2576[1] * _e2468)) + (_e2576[2] * _e2471)) * 3f);
                                if (_e2835 < _e2836) {
                                    phi_4290_ = _e2835;
                                } else {
                                    phi_4290_ = _e2836;
                                }
                                let _e2839 = phi_4290_;
                                if (_e2550 < _e2573) {
                                    phi_4295_ = _e2550;
                                } else {
                                    phi_4295_ = _e2573;
                                }
                                let _e2842 = phi_4295_;
                                if (_e2839 < _e2842) {
                                    phi_4300_ = _e2839;
                                } else {
                                    phi_4300_ = _e2842;
                                }
                                let _e2845 = phi_4300_;
                                if (_e2835 > _e2836) {
                                    phi_4305_ = _e2835;
                                } else {
                                    phi_4305_ = _e2836;
                                }
                                let _e2848 = phi_4305_;
                                if (_e2550 > _e2573) {
                                    phi_4310_ = _e2550;
                                } else {
                                    phi_4310_ = _e2573;
                                }
                                let _e2851 = phi_4310_;
                                if (_e2848 > _e2851) {
                                    phi_4315_ = _e2848;
                                } else {
                                    phi_4315_ = _e2851;
                                }
                                let _e2854 = phi_4315_;
                                let _e2859 = -(_e2854);
                                if (_e2845 > _e2859) {
                                    phi_4325_ = _e2845;
                                } else {
                                    phi_4325_ = _e2859;
                                }
                                let _e2862 = phi_4325_;
                                if ((_e2862 - ((((((_e2638 * 8f) * _e2748) * (0.000000059604645f * (490f / 64f))) + ((_e2755 * 19f) * ((_e2638 * (_e2692 + _e2746)) + (_e2692 * _e2746)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2638) * ((1f + _e2692) * (1f + _e2746))))) + ((_e1203 * (((_e2817 + (_e2748 * (0.000000059604645f * 4f))) + ((_e2822 * 6f) * (_e2692 + _e2746))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2692) * (1f + _e2746))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_5301_ = true;
                                } else {
                                    let _e2867 = local_4[0u].member_1[0u];
                                    let _e2873 = local_4[0u].member_1[1u];
                                    let _e2877 = (_e2867[0] + _e2873[0]);
                                    let _e2878 = (_e2867[1] + _e2873[1]);
                                    let _e2879 = (_e2867[2] + _e2873[2]);
                                    let _e2882 = local_4[0u].member_2[0u];
                                    let _e2888 = local_4[0u].member_2[1u];
                                    let _e2892 = (_e2882[0] + _e2888[0]);
                                    let _e2893 = (_e2882[1] + _e2888[1]);
                                    let _e2894 = (_e2882[2] + _e2888[2]);
                                    let _e2897 = ((_e2878 * _e2894) - (_e2879 * _e2893));
                                    let _e2900 = ((_e2879 * _e2892) - (_e2877 * _e2894));
                                    let _e2903 = ((_e2877 * _e2893) - (_e2878 * _e2892));
                                    let _e2906 = local_4[0u].member[0u];
                                    let _e2912 = local_4[0u].member_1[0u];
                                    let _e2918 = local_4[0u].member_2[0u];
                                    let _e2930 = local_4[0u].member[1u];
                                    let _e2936 = local_4[0u].member_1[1u];
                                    let _e2942 = local_4[0u].member_2[1u];
                                    local_2 = array<array<f32, 3>, 4>(_e2906, array<f32, 3>((_e2906[0] - _e2912[0]), (_e2906[1] - _e2912[1]), (_e2906[2] - _e2912[2])), array<f32, 3>((_e2906[0] - _e2918[0]), (_e2906[1] - _e2918[1]), (_e2906[2] - _e2918[2])), _e2906);
                                    local_3 = array<array<f32, 3>, 4>(_e2930, array<f32, 3>((_e2930[0] - _e2936[0]), (_e2930[1] - _e2936[1]), (_e2930[2] - _e2936[2])), array<f32, 3>((_e2930[0] - _e2942[0]), (_e2930[1] - _e2942[1]), (_e2930[2] - _e2942[2])), _e2930);
                                    let _e2960 = local_4[0u].member[0u];
                                    if (_e2960[0] < 0f) {
                                        phi_4576_ = -(_e2960[0]);
                                    } else {
                                        phi_4576_ = _e2960[0];
                                    }
                                    let _e2967 = phi_4576_;
                                    if (_e2960[1] < 0f) {
                                        phi_4583_ = -(_e2960[1]);
                                    } else {
                                        phi_4583_ = _e2960[1];
                                    }
                                    let _e2971 = phi_4583_;
                                    if (_e2967 > _e2971) {
                                        phi_4588_ = _e2967;
                                    } else {
                                        phi_4588_ = _e2971;
                                    }
                                    let _e2974 = phi_4588_;
                                    if (_e2960[2] < 0f) {
                                        phi_4595_ = -(_e2960[2]);
                                    } else {
                                        phi_4595_ = _e2960[2];
                                    }
                                    let _e2978 = phi_4595_;
                                    if (_e2974 > _e2978) {
                                        phi_4600_ = _e2974;
                                    } else {
                                        phi_4600_ = _e2978;
                                    }
                                    let _e2981 = phi_4600_;
                                    let _e2984 = local_4[0u].member[1u];
                                    if (_e2984[0] < 0f) {
                                        phi_4613_ = -(_e2984[0]);
                                    } else {
                                        phi_4613_ = _e2984[0];
                                    }
                                    let _e2991 = phi_4613_;
                                    if (_e2984[1] < 0f) {
                                        phi_4620_ = -(_e2984[1]);
                                    } else {
                                        phi_4620_ = _e2984[1];
                                    }
                                    let _e2995 = phi_4620_;
                                    if (_e2991 > _e2995) {
                                        phi_4625_ = _e2991;
                                    } else {
                                        phi_4625_ = _e2995;
                                    }
                                    let _e2998 = phi_4625_;
                                    if (_e2984[2] < 0f) {
                                        phi_4632_ = -(_e2984[2]);
                                    } else {
                                        phi_4632_ = _e2984[2];
                                    }
                                    let _e3002 = phi_4632_;
                                    if (_e2998 > _e3002) {
                                        phi_4637_ = _e2998;
                                    } else {
                                        phi_4637_ = _e3002;
                                    }
                                    let _e3005 = phi_4637_;
                                    if (_e2981 > _e3005) {
                                        phi_4642_ = _e2981;
                                    } else {
                                        phi_4642_ = _e3005;
                                    }
                                    let _e3008 = phi_4642_;
                                    let _e3010 = local_4[0u].member_3;
                                    let _e3014 = local_4[0u].member_1[0u];
                                    if (_e3014[0] < 0f) {
                                        phi_4659_ = -(_e3014[0]);
                                    } else {
                                        phi_4659_ = _e3014[0];
                                    }
                                    let _e3021 = phi_4659_;
                                    if (_e3014[1] < 0f) {
                                        phi_4666_ = -(_e3014[1]);
                                    } else {
                                        phi_4666_ = _e3014[1];
                                    }
                                    let _e3025 = phi_4666_;
                                    if (_e3021 > _e3025) {
                                        phi_4671_ = _e3021;
                                    } else {
                                        phi_4671_ = _e3025;
                                    }
                                    let _e3028 = phi_4671_;
                                    if (_e3014[2] < 0f) {
                                        phi_4678_ = -(_e3014[2]);
                                    } else {
                                        phi_4678_ = _e3014[2];
                                    }
                                    let _e3032 = phi_4678_;
                                    if (_e3028 > _e3032) {
                                        phi_4683_ = _e3028;
                                    } else {
                                        phi_4683_ = _e3032;
                                    }
                                    let _e3035 = phi_4683_;
                                    let _e3038 = local_4[0u].member_1[1u];
                                    if (_e3038[0] < 0f) {
                                        phi_4697_ = -(_e3038[0]);
                                    } else {
                                        phi_4697_ = _e3038[0];
                                    }
                                    let _e3045 = phi_4697_;
                                    if (_e3038[1] < 0f) {
                                        phi_4704_ = -(_e3038[1]);
                                    } else {
                                        phi_4704_ = _e3038[1];
                                    }
                                    let _e3049 = phi_4704_;
                                    if (_e3045 > _e3049) {
                                        phi_4709_ = _e3045;
                                    } else {
                                        phi_4709_ = _e3049;
                                    }
                                    let _e3052 = phi_4709_;
                                    if (_e3038[2] < 0f) {
                                        phi_4716_ = -(_e3038[2]);
                                    } else {
                                        phi_4716_ = _e3038[2];
                                    }
                                    let _e3056 = phi_4716_;
                                    if (_e3052 > _e3056) {
                                        phi_4721_ = _e3052;
                                    } else {
                                        phi_4721_ = _e3056;
                                    }
                                    let _e3059 = phi_4721_;
                                    if (_e3035 > _e3059) {
                                        phi_4726_ = _e3035;
                                    } else {
                                        phi_4726_ = _e3059;
                                    }
                                    let _e3062 = phi_4726_;
                                    let _e3064 = local_4[0u].member_3;
                                    let _e3068 = local_4[0u].member_2[0u];
                                    if (_e3068[0] < 0f) {
                                        phi_4743_ = -(_e3068[0]);
                                    } else {
                                        phi_4743_ = _e3068[0];
                                    }
                                    let _e3075 = phi_4743_;
                                    if (_e3068[1] < 0f) {
                                        phi_4750_ = -(_e3068[1]);
                                    } else {
                                        phi_4750_ = _e3068[1];
                                    }
                                    let _e3079 = phi_4750_;
                                    if (_e3075 > _e3079) {
                                        phi_4755_ = _e3075;
                                    } else {
                                        phi_4755_ = _e3079;
                                    }
                                    let _e3082 = phi_4755_;
                                    if (_e3068[2] < 0f) {
                                        phi_4762_ = -(_e3068[2]);
                                    } else {
                                        phi_4762_ = _e3068[2];
                                    }
                                    let _e3086 = phi_4762_;
                                    if (_e3082 > _e3086) {
                                        phi_4767_ = _e3082;
                                    } else {
                                        phi_4767_ = _e3086;
                                    }
                                    let _e3089 = phi_4767_;
                                    let _e3092 = local_4[0u].member_2[1u];
                                    if (_e3092[0] < 0f) {
                                        phi_4781_ = -(_e3092[0]);
                                    } else {
                                        phi_4781_ = _e3092[0];
                                    }
                                    let _e3099 = phi_4781_;
                                    if (_e3092[1] < 0f) {
                                        phi_4788_ = -(_e3092[1]);
                                    } else {
                                        phi_4788_ = _e3092[1];
                                    }
                                    let _e3103 = phi_4788_;
                                    if (_e3099 > _e3103) {
                                        phi_4793_ = _e3099;
                                    } else {
                                        phi_4793_ = _e3103;
                                    }
                                    let _e3106 = phi_4793_;
                                    if (_e3092[2] < 0f) {
                                        phi_4800_ = -(_e3092[2]);
                                    } else {
                                        phi_4800_ = _e3092[2];
                                    }
                                    let _e3110 = phi_4800_;
                                    if (_e3106 > _e3110) {
                                        phi_4805_ = _e3106;
                                    } else {
                                        phi_4805_ = _e3110;
                                    }
                                    let _e3113 = phi_4805_;
                                    if (_e3089 > _e3113) {
                                        phi_4810_ = _e3089;
                                    } else {
                                        phi_4810_ = _e3113;
                                    }
                                    let _e3116 = phi_4810_;
                                    let _e3118 = local_4[0u].member_3;
                                    let _e3121 = (((_e3008 + _e3010) + (_e3062 + _e3064)) + (_e3116 + _e3118));
                                    let _e3124 = local_4[0u].member_3;
                                    let _e3128 = (((_e1203 * 1.0001f) + (_e3124 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3131 = ((_e2900 * _e2879) - (_e2903 * _e2878));
                                    let _e3134 = ((_e2903 * _e2877) - (_e2897 * _e2879));
                                    let _e3137 = ((_e2897 * _e2878) - (_e2900 * _e2877));
                                    let _e3139 = local_2[0u];
                                    let _e3147 = (((_e3131 * _e3139[0]) + (_e3134 * _e3139[1])) + (_e3137 * _e3139[2]));
                                    phi_4848_ = type_37(0u, 4u);
                                    phi_4851_ = _e3147;
                                    phi_4853_ = _e3147;
                                    loop {
                                        let _e3149 = phi_4848_;
                                        let _e3151 = phi_4851_;
                                        let _e3153 = phi_4853_;
                                        local_36 = _e3151;
                                        local_37 = _e3153;
                                        local_52 = _e3153;
                                        if (_e3149.member < _e3149.member_1) {
                                            phi_4849_ = type_37((_e3149.member + 1u), _e3149.member_1);
                                            phi_4876_ = type_37(1u, _e3149.member);
                                        } else {
                                            phi_4849_ = _e3149;
                                            phi_4876_ = type_37(0u, type_37().member_1);
                                        }
                                        let _e3167 = phi_4849_;
                                        let _e3169 = phi_4876_;
                                        let _e3173 = (bitcast<i32>(_e3169.member) != 0i);
                                        if _e3173 {
                                            if (_e3169.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3176 = local_2[_e3169.member_1];
                                            let _e3184 = (((_e3131 * _e3176[0]) + (_e3134 * _e3176[1])) + (_e3137 * _e3176[2]));
                                            if (_e3169.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3187 = local_3[_e3169.member_1];
                                            let _e3195 = (((_e3131 * _e3187[0]) + (_e3134 * _e3187[1])) + (_e3137 * _e3187[2]));
                                            if (_e3153 < _e3184) {
                                                phi_4926_ = _e3153;
                                            } else {
                                                phi_4926_ = _e3184;
                                            }
                                            let _e3198 = phi_4926_;
                                            if (_e3198 < _e3195) {
                                                phi_4931_ = _e3198;
                                            } else {
                                                phi_4931_ = _e3195;
                                            }
                                            let _e3201 = phi_4931_;
                                            if (_e3151 > _e3184) {
                                                phi_4936_ = _e3151;
                                            } else {
                                                phi_4936_ = _e3184;
                                            }
                                            let _e3204 = phi_4936_;
                                            if (_e3204 > _e3195) {
                                                phi_4941_ = _e3204;
                                            } else {
                                                phi_4941_ = _e3195;
                                            }
                                            let _e3207 = phi_4941_;
                                            phi_4852_ = _e3207;
                                            phi_4854_ = _e3201;
                                        } else {
                                            phi_4852_ = f32();
                                            phi_4854_ = f32();
                                        }
                                        let _e3209 = phi_4852_;
                                        let _e3211 = phi_4854_;
                                        continue;
                                        continuing {
                                            phi_4848_ = _e3167;
                                            phi_4851_ = _e3209;
                                            phi_4853_ = _e3211;
                                            break if !(_e3173);
                                        }
                                    }
                                    if (_e3131 < 0f) {
                                        phi_4947_ = -(_e3131);
                                    } else {
                                        phi_4947_ = _e3131;
                                    }
                                    let _e3216 = phi_4947_;
                                    if (_e3134 < 0f) {
                                        phi_4953_ = -(_e3134);
                                    } else {
                                        phi_4953_ = _e3134;
                                    }
                                    let _e3220 = phi_4953_;
                                    if (_e3137 < 0f) {
                                        phi_4960_ = -(_e3137);
                                    } else {
                                        phi_4960_ = _e3137;
                                    }
                                    let _e3225 = phi_4960_;
                                    let _e3226 = ((_e3216 + _e3220) + _e3225);
                                    let _e3231 = local_36;
                                    let _e3232 = -(_e3231);
                                    let _e3234 = local_37;
                                    if (_e3234 > _e3232) {
                                        let _e5018 = local_52;
                                        phi_4970_ = _e5018;
                                    } else {
                                        phi_4970_ = _e3232;
                                    }
                                    let _e3237 = phi_4970_;
                                    let _e3242 = (((_e3237 - ((_e3226 * _e3121) * (0.000000059604645f * 17f))) - (_e3226 * _e3128)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3245 = ((_e2900 * _e2894) - (_e2903 * _e2893));
                                    let _e3248 = ((_e2903 * _e2892) - (_e2897 * _e2894));
                                    let _e3251 = ((_e2897 * _e2893) - (_e2900 * _e2892));
                                    let _e3253 = local_2[0u];
                                    let _e3261 = (((_e3245 * _e3253[0]) + (_e3248 * _e3253[1])) + (_e3251 * _e3253[2]));
                                    phi_5001_ = type_37(0u, 4u);
                                    phi_5004_ = _e3261;
                                    phi_5006_ = _e3261;
                                    loop {
                                        let _e3263 = phi_5001_;
                                        let _e3265 = phi_5004_;
                                        let _e3267 = phi_5006_;
                                        local_38 = _e3265;
                                        local_39 = _e3267;
                                        local_53 = _e3267;
                                        if (_e3263.member < _e3263.member_1) {
                                            phi_5002_ = type_37((_e3263.member + 1u), _e3263.member_1);
                                            phi_5029_ = type_37(1u, _e3263.member);
                                        } else {
                                            phi_5002_ = _e3263;
                                            phi_5029_ = type_37(0u, type_37().member_1);
                                        }
                                        let _e3281 = phi_5002_;
                                        let _e3283 = phi_5029_;
                                        let _e3287 = (bitcast<i32>(_e3283.member) != 0i);
                                        if _e3287 {
                                            if (_e3283.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3290 = local_2[_e3283.member_1];
                                            let _e3298 = (((_e3245 * _e3290[0]) + (_e3248 * _e3290[1])) + (_e3251 * _e3290[2]));
                                            if (_e3283.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3301 = local_3[_e3283.member_1];
                                            let _e3309 = (((_e3245 * _e3301[0]) + (_e3248 * _e3301[1])) + (_e3251 * _e3301[2]));
                                            if (_e3267 < _e3298) {
                                                phi_5079_ = _e3267;
                                            } else {
                                                phi_5079_ = _e3298;
                                            }
                                            let _e3312 = phi_5079_;
                                            if (_e3312 < _e3309) {
                                                phi_5084_ = _e3312;
                                            } else {
                                                phi_5084_ = _e3309;
                                            }
                                            let _e3315 = phi_5084_;
                                            if (_e3265 > _e3298) {
                                                phi_5089_ = _e3265;
                                            } else {
                                                phi_5089_ = _e3298;
                                            }
                                            let _e3318 = phi_5089_;
                                            if (_e3318 > _e3309) {
                                                phi_5094_ = _e3318;
                                            } else {
                                                phi_5094_ = _e3309;
                                            }
                                            let _e3321 = phi_5094_;
                                            phi_5005_ = _e3321;
                                            phi_5007_ = _e3315;
                                        } else {
                                            phi_5005_ = f32();
                                            phi_5007_ = f32();
                                        }
                                        let _e3323 = phi_5005_;
                                        let _e3325 = phi_5007_;
                                        continue;
                                        continuing {
                                            phi_5001_ = _e3281;
                                            phi_5004_ = _e3323;
                                            phi_5006_ = _e3325;
                                            break if !(_e3287);
                                        }
                                    }
                                    if (_e3245 < 0f) {
                                        phi_5100_ = -(_e3245);
                                    } else {
                                        phi_5100_ = _e3245;
                                    }
                                    let _e3330 = phi_5100_;
                                    if (_e3248 < 0f) {
                                        phi_5106_ = -(_e3248);
                                    } else {
                                        phi_5106_ = _e3248;
                                    }
                                    let _e3334 = phi_5106_;
                                    if (_e3251 < 0f) {
                                        phi_5113_ = -(_e3251);
                                    } else {
                                        phi_5113_ = _e3251;
                                    }
                                    let _e3339 = phi_5113_;
                                    let _e3340 = ((_e3330 + _e3334) + _e3339);
                                    let _e3345 = local_38;
                                    let _e3346 = -(_e3345);
                                    let _e3348 = local_39;
                                    if (_e3348 > _e3346) {
                                        let _e5037 = local_53;
                                        phi_5123_ = _e5037;
                                    } else {
                                        phi_5123_ = _e3346;
                                    }
                                    let _e3351 = phi_5123_;
                                    let _e3356 = (((_e3351 - ((_e3340 * _e3121) * (0.000000059604645f * 17f))) - (_e3340 * _e3128)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3242 > _e3356) {
                                        phi_5133_ = _e3242;
                                    } else {
                                        phi_5133_ = _e3356;
                                    }
                                    let _e3359 = phi_5133_;
                                    let _e3360 = (_e2892 - _e2877);
                                    let _e3361 = (_e2893 - _e2878);
                                    let _e3362 = (_e2894 - _e2879);
                                    let _e3365 = ((_e2900 * _e3362) - (_e2903 * _e3361));
                                    let _e3368 = ((_e2903 * _e3360) - (_e2897 * _e3362));
                                    let _e3371 = ((_e2897 * _e3361) - (_e2900 * _e3360));
                                    let _e3373 = local_2[0u];
                                    let _e3381 = (((_e3365 * _e3373[0]) + (_e3368 * _e3373[1])) + (_e3371 * _e3373[2]));
                                    phi_5166_ = type_37(0u, 4u);
                                    phi_5169_ = _e3381;
                                    phi_5171_ = _e3381;
                                    loop {
                                        let _e3383 = phi_5166_;
                                        let _e3385 = phi_5169_;
                                        let _e3387 = phi_5171_;
                                        local_40 = _e3385;
                                        local_41 = _e3387;
                                        local_54 = _e3387;
                                        if (_e3383.member < _e3383.member_1) {
                                            phi_5167_ = type_37((_e3383.member + 1u), _e3383.member_1);
                                            phi_5194_ = type_37(1u, _e3383.member);
                                        } else {
                                            phi_5167_ = _e3383;
                                            phi_5194_ = type_37(0u, type_37().member_1);
                                        }
                                        let _e3401 = phi_5167_;
                                        let _e3403 = phi_5194_;
                                        let _e3407 = (bitcast<i32>(_e3403.member) != 0i);
                                        if _e3407 {
                                            if (_e3403.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3410 = local_2[_e3403.member_1];
                                            let _e3418 = (((_e3365 * _e3410[0]) + (_e3368 * _e3410[1])) + (_e3371 * _e3410[2]));
                                            if (_e3403.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3421 = local_3[_e3403.member_1];
                                            let _e3429 = (((_e3365 * _e3421[0]) + (_e3368 * _e3421[1])) + (_e3371 * _e3421[2]));
                                            if (_e3387 < _e3418) {
                                                phi_5244_ = _e3387;
                                            } else {
                                                phi_5244_ = _e3418;
                                            }
                                            let _e3432 = phi_5244_;
                                            if (_e3432 < _e3429) {
                                                phi_5249_ = _e3432;
                                            } else {
                                                phi_5249_ = _e3429;
                                            }
                                            let _e3435 = phi_5249_;
                                            if (_e3385 > _e3418) {
                                                phi_5254_ = _e3385;
                                            } else {
                                                phi_5254_ = _e3418;
                                            }
                                            let _e3438 = phi_5254_;
                                            if (_e3438 > _e3429) {
                                                phi_5259_ = _e3438;
                                            } else {
                                                phi_5259_ = _e3429;
                                            }
                                            let _e3441 = phi_5259_;
                                            phi_5170_ = _e3441;
                                            phi_5172_ = _e3435;
                                        } else {
                                            phi_5170_ = f32();
                                            phi_5172_ = f32();
                                        }
                                        let _e3443 = phi_5170_;
                                        let _e3445 = phi_5172_;
                                        continue;
                                        continuing {
                                            phi_5166_ = _e3401;
                                            phi_5169_ = _e3443;
                                            phi_5171_ = _e3445;
                                            break if !(_e3407);
                                        }
                                    }
                                    if (_e3365 < 0f) {
                                        phi_5265_ = -(_e3365);
                                    } else {
                                        phi_5265_ = _e3365;
                                    }
                                    let _e3450 = phi_5265_;
                                    if (_e3368 < 0f) {
                                        phi_5271_ = -(_e3368);
                                    } else {
                                        phi_5271_ = _e3368;
                                    }
                                    let _e3454 = phi_5271_;
                                    if (_e3371 < 0f) {
                                        phi_5278_ = -(_e3371);
                                    } else {
                                        phi_5278_ = _e3371;
                                    }
                                    let _e3459 = phi_5278_;
                                    let _e3460 = ((_e3450 + _e3454) + _e3459);
                                    let _e3465 = local_40;
                                    let _e3466 = -(_e3465);
                                    let _e3468 = local_41;
                                    if (_e3468 > _e3466) {
                                        let _e5057 = local_54;
                                        phi_5288_ = _e5057;
                                    } else {
                                        phi_5288_ = _e3466;
                                    }
                                    let _e3471 = phi_5288_;
                                    let _e3476 = (((_e3471 - ((_e3460 * _e3121) * (0.000000059604645f * 17f))) - (_e3460 * _e3128)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3359 > _e3476) {
                                        phi_5298_ = _e3359;
                                    } else {
                                        phi_5298_ = _e3476;
                                    }
                                    let _e3479 = phi_5298_;
                                    phi_5301_ = (_e3479 > 0f);
                                }
                                let _e3482 = phi_5301_;
                                if _e3482 {
                                    let _e3486 = local_4[1u].member_1[0u];
                                    let _e3492 = local_4[1u].member_2[0u];
                                    let _e3498 = ((_e3486[1] * _e3492[2]) - (_e3486[2] * _e3492[1]));
                                    let _e3501 = ((_e3486[2] * _e3492[0]) - (_e3486[0] * _e3492[2]));
                                    let _e3504 = ((_e3486[0] * _e3492[1]) - (_e3486[1] * _e3492[0]));
                                    let _e3507 = local_4[1u].member_1[1u];
                                    let _e3513 = local_4[1u].member_2[1u];
                                    let _e3519 = ((_e3507[1] * _e3513[2]) - (_e3507[2] * _e3513[1]));
                                    let _e3522 = ((_e3507[2] * _e3513[0]) - (_e3507[0] * _e3513[2]));
                                    let _e3525 = ((_e3507[0] * _e3513[1]) - (_e3507[1] * _e3513[0]));
                                    let _e3528 = local_4[1u].member_1[0u];
                                    let _e3534 = local_4[1u].member_2[1u];
                                    let _e3549 = local_4[1u].member_1[1u];
                                    let _e3555 = local_4[1u].member_2[0u];
                                    let _e3568 = (((_e3528[1] * _e3534[2]) - (_e3528[2] * _e3534[1])) + ((_e3549[1] * _e3555[2]) - (_e3549[2] * _e3555[1])));
                                    let _e3569 = (((_e3528[2] * _e3534[0]) - (_e3528[0] * _e3534[2])) + ((_e3549[2] * _e3555[0]) - (_e3549[0] * _e3555[2])));
                                    let _e3570 = (((_e3528[0] * _e3534[1]) - (_e3528[1] * _e3534[0])) + ((_e3549[0] * _e3555[1]) - (_e3549[1] * _e3555[0])));
                                    let _e3573 = local_4[1u].member[0u];
                                    let _e3584 = local_4[1u].member[1u];
                                    let _e3595 = local_4[1u].member[0u];
                                    let _e3604 = ((((_e3584[0] * _e3498) + (_e3584[1] * _e3501)) + (_e3584[2] * _e3504)) + (((_e3595[0] * _e3568) + (_e3595[1] * _e3569)) + (_e3595[2] * _e3570)));
                                    let _e3607 = local_4[1u].member[0u];
                                    let _e3618 = local_4[1u].member[1u];
                                    let _e3627 = ((((_e3607[0] * _e3519) + (_e3607[1] * _e3522)) + (_e3607[2] * _e3525)) + (((_e3618[0] * _e3568) + (_e3618[1] * _e3569)) + (_e3618[2] * _e3570)));
                                    let _e3630 = local_4[1u].member[1u];
                                    let _e3641 = local_4[1u].member[0u];
                                    if (_e3641[0] < 0f) {
                                        phi_5547_ = -(_e3641[0]);
                                    } else {
                                        phi_5547_ = _e3641[0];
                                    }
                                    let _e3648 = phi_5547_;
                                    if (_e3641[1] < 0f) {
                                        phi_5554_ = -(_e3641[1]);
                                    } else {
                                        phi_5554_ = _e3641[1];
                                    }
                                    let _e3652 = phi_5554_;
                                    if (_e3648 > _e3652) {
                                        phi_5559_ = _e3648;
                                    } else {
                                        phi_5559_ = _e3652;
                                    }
                                    let _e3655 = phi_5559_;
                                    if (_e3641[2] < 0f) {
                                        phi_5566_ = -(_e3641[2]);
                                    } else {
                                        phi_5566_ = _e3641[2];
                                    }
                                    let _e3659 = phi_5566_;
                                    if (_e3655 > _e3659) {
                                        phi_5571_ = _e3655;
                                    } else {
                                        phi_5571_ = _e3659;
                                    }
                                    let _e3662 = phi_5571_;
                                    let _e3665 = local_4[1u].member[1u];
                                    if (_e3665[0] < 0f) {
                                        phi_5584_ = -(_e3665[0]);
                                    } else {
                                        phi_5584_ = _e3665[0];
                                    }
                                    let _e3672 = phi_5584_;
                                    if (_e3665[1] < 0f) {
                                        phi_5591_ = -(_e3665[1]);
                                    } else {
                                        phi_5591_ = _e3665[1];
                                    }
                                    let _e3676 = phi_5591_;
                                    if (_e3672 > _e3676) {
                                        phi_5596_ = _e3672;
                                    } else {
                                        phi_5596_ = _e3676;
                                    }
                                    let _e3679 = phi_5596_;
                                    if (_e3665[2] < 0f) {
                                        phi_5603_ = -(_e3665[2]);
                                    } else {
                                        phi_5603_ = _e3665[2];
                                    }
                                    let _e3683 = phi_5603_;
                                    if (_e3679 > _e3683) {
                                        phi_5608_ = _e3679;
                                    } else {
                                        phi_5608_ = _e3683;
                                    }
                                    let _e3686 = phi_5608_;
                                    if (_e3662 > _e3686) {
                                        phi_5613_ = _e3662;
                                    } else {
                                        phi_5613_ = _e3686;
                                    }
                                    let _e3689 = phi_5613_;
                                    let _e3691 = local_4[1u].member_3;
                                    let _e3692 = (_e3689 + _e3691);
                                    let _e3695 = local_4[1u].member_1[0u];
                                    if (_e3695[0] < 0f) {
                                        phi_5630_ = -(_e3695[0]);
                                    } else {
                                        phi_5630_ = _e3695[0];
                                    }
                                    let _e3702 = phi_5630_;
                                    if (_e3695[1] < 0f) {
                                        phi_5637_ = -(_e3695[1]);
                                    } else {
                                        phi_5637_ = _e3695[1];
                                    }
                                    let _e3706 = phi_5637_;
                                    if (_e3702 > _e3706) {
                                        phi_5642_ = _e3702;
                                    } else {
                                        phi_5642_ = _e3706;
                                    }
                                    let _e3709 = phi_5642_;
                                    if (_e3695[2] < 0f) {
                                        phi_5649_ = -(_e3695[2]);
                                    } else {
                                        phi_5649_ = _e3695[2];
                                    }
                                    let _e3713 = phi_5649_;
                                    if (_e3709 > _e3713) {
                                        phi_5654_ = _e3709;
                                    } else {
                                        phi_5654_ = _e3713;
                                    }
                                    let _e3716 = phi_5654_;
                                    let _e3719 = local_4[1u].member_1[1u];
                                    if (_e3719[0] < 0f) {
                                        phi_5668_ = -(_e3719[0]);
                                    } else {
                                        phi_5668_ = _e3719[0];
                                    }
                                    let _e3726 = phi_5668_;
                                    if (_e3719[1] < 0f) {
                                        phi_5675_ = -(_e3719[1]);
                                    } else {
                                        phi_5675_ = _e3719[1];
                                    }
                                    let _e3730 = phi_5675_;
                                    if (_e3726 > _e3730) {
                                        phi_5680_ = _e3726;
                                    } else {
                                        phi_5680_ = _e3730;
                                    }
                                    let _e3733 = phi_5680_;
                                    if (_e3719[2] < 0f) {
                                        phi_5687_ = -(_e3719[2]);
                                    } else {
                                        phi_5687_ = _e3719[2];
                                    }
                                    let _e3737 = phi_5687_;
                                    if (_e3733 > _e3737) {
                                        phi_5692_ = _e3733;
                                    } else {
                                        phi_5692_ = _e3737;
                                    }
                                    let _e3740 = phi_5692_;
                                    if (_e3716 > _e3740) {
                                        phi_5697_ = _e3716;
                                    } else {
                                        phi_5697_ = _e3740;
                                    }
                                    let _e3743 = phi_5697_;
                                    let _e3745 = local_4[1u].member_3;
                                    let _e3746 = (_e3743 + _e3745);
                                    let _e3749 = local_4[1u].member_2[0u];
                                    if (_e3749[0] < 0f) {
                                        phi_5714_ = -(_e3749[0]);
                                    } else {
                                        phi_5714_ = _e3749[0];
                                    }
                                    let _e3756 = phi_5714_;
                                    if (_e3749[1] < 0f) {
                                        phi_5721_ = -(_e3749[1]);
                                    } else {
                                        phi_5721_ = _e3749[1];
                                    }
                                    let _e3760 = phi_5721_;
                                    if (_e3756 > _e3760) {
                                        phi_5726_ = _e3756;
                                    } else {
                                        phi_5726_ = _e3760;
                                    }
                                    let _e3763 = phi_5726_;
                                    if (_e3749[2] < 0f) {
                                        phi_5733_ = -(_e3749[2]);
                                    } else {
                                        phi_5733_ = _e3749[2];
                                    }
                                    let _e3767 = phi_5733_;
                                    if (_e3763 > _e3767) {
                                        phi_5738_ = _e3763;
                                    } else {
                                        phi_5738_ = _e3767;
                                    }
                                    let _e3770 = phi_5738_;
                                    let _e3773 = local_4[1u].member_2[1u];
                                    if (_e3773[0] < 0f) {
                                        phi_5752_ = -(_e3773[0]);
                                    } else {
                                        phi_5752_ = _e3773[0];
                                    }
                                    let _e3780 = phi_5752_;
                                    if (_e3773[1] < 0f) {
                                        phi_5759_ = -(_e3773[1]);
                                    } else {
                                        phi_5759_ = _e3773[1];
                                    }
                                    let _e3784 = phi_5759_;
                                    if (_e3780 > _e3784) {
                                        phi_5764_ = _e3780;
                                    } else {
                                        phi_5764_ = _e3784;
                                    }
                                    let _e3787 = phi_5764_;
                                    if (_e3773[2] < 0f) {
                                        phi_5771_ = -(_e3773[2]);
                                    } else {
                                        phi_5771_ = _e3773[2];
                                    }
                                    let _e3791 = phi_5771_;
                                    if (_e3787 > _e3791) {
                                        phi_5776_ = _e3787;
                                    } else {
                                        phi_5776_ = _e3791;
                                    }
                                    let _e3794 = phi_5776_;
                                    if (_e3770 > _e3794) {
                                        phi_5781_ = _e3770;
                                    } else {
                                        phi_5781_ = _e3794;
                                    }
                                    let _e3797 = phi_5781_;
                                    let _e3799 = local_4[1u].member_3;
                                    let _e3800 = (_e3797 + _e3799);
                                    let _e3802 = ((_e3746 * 8f) * _e3800);
                                    let _e3809 = local_4[1u].member_3;
                                    if (_e3498 < 0f) {
                                        phi_5812_ = -(_e3498);
                                    } else {
                                        phi_5812_ = _e3498;
                                    }
                                    let _e3826 = phi_5812_;
                                    if (_e3501 < 0f) {
                                        phi_5818_ = -(_e3501);
                                    } else {
                                        phi_5818_ = _e3501;
                                    }
                                    let _e3830 = phi_5818_;
                                    if (_e3504 < 0f) {
                                        phi_5825_ = -(_e3504);
                                    } else {
                                        phi_5825_ = _e3504;
                                    }
                                    let _e3835 = phi_5825_;
                                    let _e3836 = ((_e3826 + _e3830) + _e3835);
                                    if (_e3519 < 0f) {
                                        phi_5832_ = -(_e3519);
                                    } else {
                                        phi_5832_ = _e3519;
                                    }
                                    let _e3840 = phi_5832_;
                                    if (_e3522 < 0f) {
                                        phi_5838_ = -(_e3522);
                                    } else {
                                        phi_5838_ = _e3522;
                                    }
                                    let _e3844 = phi_5838_;
                                    if (_e3525 < 0f) {
                                        phi_5845_ = -(_e3525);
                                    } else {
                                        phi_5845_ = _e3525;
                                    }
                                    let _e3849 = phi_5845_;
                                    let _e3850 = ((_e3840 + _e3844) + _e3849);
                                    if (_e3836 > _e3850) {
                                        phi_5851_ = _e3836;
                                    } else {
                                        phi_5851_ = _e3850;
                                    }
                                    let _e3853 = phi_5851_;
                                    if (_e3568 < 0f) {
                                        phi_5857_ = -(_e3568);
                                    } else {
                                        phi_5857_ = _e3568;
                                    }
                                    let _e3857 = phi_5857_;
                                    if (_e3569 < 0f) {
                                        phi_5863_ = -(_e3569);
                                    } else {
                                        phi_5863_ = _e3569;
                                    }
                                    let _e3861 = phi_5863_;
                                    if (_e3570 < 0f) {
                                        phi_5870_ = -(_e3570);
                                    } else {
                                        phi_5870_ = _e3570;
                                    }
                                    let _e3866 = phi_5870_;
                                    let _e3868 = (((_e3857 + _e3861) + _e3866) * 0.5f);
                                    if (_e3853 > _e3868) {
                                        phi_5877_ = _e3853;
                                    } else {
                                        phi_5877_ = _e3868;
                                    }
                                    let _e3871 = phi_5877_;
                                    let _e3876 = local_4[1u].member_3;
                                    let _e3889 = ((((_e3573[0] * _e3498) + (_e3573[1] * _e3501)) + (_e3573[2] * _e3504)) * 3f);
                                    let _e3890 = ((((_e3630[0] * _e3519) + (_e3630[1] * _e3522)) + (_e3630[2] * _e3525)) * 3f);
                                    if (_e3889 < _e3890) {
                                        phi_5901_ = _e3889;
                                    } else {
                                        phi_5901_ = _e3890;
                                    }
                                    let _e3893 = phi_5901_;
                                    if (_e3604 < _e3627) {
                                        phi_5906_ = _e3604;
                                    } else {
                                        phi_5906_ = _e3627;
                                    }
                                    let _e3896 = phi_5906_;
                                    if (_e3893 < _e3896) {
                                        phi_5911_ = _e3893;
                                    } else {
                                        phi_5911_ = _e3896;
                                    }
                                    let _e3899 = phi_5911_;
                                    if (_e3889 > _e3890) {
                                        phi_5916_ = _e3889;
                                    } else {
                                        phi_5916_ = _e3890;
                                    }
                                    let _e3902 = phi_5916_;
                                    if (_e3604 > _e3627) {
                                        phi_5921_ = _e3604;
                                    } else {
                                        phi_5921_ = _e3627;
                                    }
                                    let _e3905 = phi_5921_;
                                    if (_e3902 > _e3905) {
                                        phi_5926_ = _e3902;
                                    } else {
                                        phi_5926_ = _e3905;
                                    }
                                    let _e3908 = phi_5926_;
                                    let _e3913 = -(_e3908);
                                    if (_e3899 > _e3913) {
                                        phi_5936_ = _e3899;
                                    } else {
                                        phi_5936_ = _e3913;
                                    }
                                    let _e3916 = phi_5936_;
                                    if ((_e3916 - ((((((_e3692 * 8f) * _e3802) * (0.000000059604645f * (490f / 64f))) + ((_e3809 * 19f) * ((_e3692 * (_e3746 + _e3800)) + (_e3746 * _e3800)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3692) * ((1f + _e3746) * (1f + _e3800))))) + ((_e1203 * (((_e3871 + (_e3802 * (0.000000059604645f * 4f))) + ((_e3876 * 6f) * (_e3746 + _e3800))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3746) * (1f + _e3800))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_6912_ = true;
                                    } else {
                                        let _e3921 = local_4[1u].member_1[0u];
                                        let _e3927 = local_4[1u].member_1[1u];
                                        let _e3931 = (_e3921[0] + _e3927[0]);
                                        let _e3932 = (_e3921[1] + _e3927[1]);
                                        let _e3933 = (_e3921[2] + _e3927[2]);
                                        let _e3936 = local_4[1u].member_2[0u];
                                        let _e3942 = local_4[1u].member_2[1u];
                                        let _e3946 = (_e3936[0] + _e3942[0]);
                                        let _e3947 = (_e3936[1] + _e3942[1]);
                                        let _e3948 = (_e3936[2] + _e3942[2]);
                                        let _e3951 = ((_e3932 * _e3948) - (_e3933 * _e3947));
                                        let _e3954 = ((_e3933 * _e3946) - (_e3931 * _e3948));
                                        let _e3957 = ((_e3931 * _e3947) - (_e3932 * _e3946));
                                        let _e3960 = local_4[1u].member[0u];
                                        let _e3966 = local_4[1u].member_1[0u];
                                        let _e3972 = local_4[1u].member_2[0u];
                                        let _e3984 = local_4[1u].member[1u];
                                        let _e3990 = local_4[1u].member_1[1u];
                                        let _e3996 = local_4[1u].member_2[1u];
                                        local = array<array<f32, 3>, 4>(_e3960, array<f32, 3>((_e3960[0] - _e3966[0]), (_e3960[1] - _e3966[1]), (_e3960[2] - _e3966[2])), array<f32, 3>((_e3960[0] - _e3972[0]), (_e3960[1] - _e3972[1]), (_e3960[2] - _e3972[2])), _e3960);
                                        local_1 = array<array<f32, 3>, 4>(_e3984, array<f32, 3>((_e3984[0] - _e3990[0]), (_e3984[1] - _e3990[1]), (_e3984[2] - _e3990[2])), array<f32, 3>((_e3984[0] - _e3996[0]), (_e3984[1] - _e3996[1]), (_e3984[2] - _e3996[2])), _e3984);
                                        let _e4014 = local_4[1u].member[0u];
                                        if (_e4014[0] < 0f) {
                                            phi_6187_ = -(_e4014[0]);
                                        } else {
                                            phi_6187_ = _e4014[0];
                                        }
                                        let _e4021 = phi_6187_;
                                        if (_e4014[1] < 0f) {
                                            phi_6194_ = -(_e4014[1]);
                                        } else {
                                            phi_6194_ = _e4014[1];
                                        }
                                        let _e4025 = phi_6194_;
                                        if (_e4021 > _e4025) {
                                            phi_6199_ = _e4021;
                                        } else {
                                            phi_6199_ = _e4025;
                                        }
                                        let _e4028 = phi_6199_;
                                        if (_e4014[2] < 0f) {
                                            phi_6206_ = -(_e4014[2]);
                                        } else {
                                            phi_6206_ = _e4014[2];
                                        }
                                        let _e4032 = phi_6206_;
                                        if (_e4028 > _e4032) {
                                            phi_6211_ = _e4028;
                                        } else {
                                            phi_6211_ = _e4032;
                                        }
                                        let _e4035 = phi_6211_;
                                        let _e4038 = local_4[1u].member[1u];
                                        if (_e4038[0] < 0f) {
                                            phi_6224_ = -(_e4038[0]);
                                        } else {
                                            phi_6224_ = _e4038[0];
                                        }
                                        let _e4045 = phi_6224_;
                                        if (_e4038[1] < 0f) {
                                            phi_6231_ = -(_e4038[1]);
                                        } else {
                                            phi_6231_ = _e4038[1];
                                        }
                                        let _e4049 = phi_6231_;
                                        if (_e4045 > _e4049) {
                                            phi_6236_ = _e4045;
                                        } else {
                                            phi_6236_ = _e4049;
                                        }
                                        let _e4052 = phi_6236_;
                                        if (_e4038[2] < 0f) {
                                            phi_6243_ = -(_e4038[2]);
                                        } else {
                                            phi_6243_ = _e4038[2];
                                        }
                                        let _e4056 = phi_6243_;
                                        if (_e4052 > _e4056) {
                                            phi_6248_ = _e4052;
                                        } else {
                                            phi_6248_ = _e4056;
                                        }
                                        let _e4059 = phi_6248_;
                                        if (_e4035 > _e4059) {
                                            phi_6253_ = _e4035;
                                        } else {
                                            phi_6253_ = _e4059;
                                        }
                                        let _e4062 = phi_6253_;
                                        let _e4064 = local_4[1u].member_3;
                                        let _e4068 = local_4[1u].member_1[0u];
                                        if (_e4068[0] < 0f) {
                                            phi_6270_ = -(_e4068[0]);
                                        } else {
                                            phi_6270_ = _e4068[0];
                                        }
                                        let _e4075 = phi_6270_;
                                        if (_e4068[1] < 0f) {
                                            phi_6277_ = -(_e4068[1]);
                                        } else {
                                            phi_6277_ = _e4068[1];
                                        }
                                        let _e4079 = phi_6277_;
                                        if (_e4075 > _e4079) {
                                            phi_6282_ = _e4075;
                                        } else {
                                            phi_6282_ = _e4079;
                                        }
                                        let _e4082 = phi_6282_;
                                        if (_e4068[2] < 0f) {
                                            phi_6289_ = -(_e4068[2]);
                                        } else {
                                            phi_6289_ = _e4068[2];
                                        }
                                        let _e4086 = phi_6289_;
                                        if (_e4082 > _e4086) {
                                            phi_6294_ = _e4082;
                                        } else {
                                            phi_6294_ = _e4086;
                                        }
                                        let _e4089 = phi_6294_;
                                        let _e4092 = local_4[1u].member_1[1u];
                                        if (_e4092[0] < 0f) {
                                            phi_6308_ = -(_e4092[0]);
                                        } else {
                                            phi_6308_ = _e4092[0];
                                        }
                                        let _e4099 = phi_6308_;
                                        if (_e4092[1] < 0f) {
                                            phi_6315_ = -(_e4092[1]);
                                        } else {
                                            phi_6315_ = _e4092[1];
                                        }
                                        let _e4103 = phi_6315_;
                                        if (_e4099 > _e4103) {
                                            phi_6320_ = _e4099;
                                        } else {
                                            phi_6320_ = _e4103;
                                        }
                                        let _e4106 = phi_6320_;
                                        if (_e4092[2] < 0f) {
                                            phi_6327_ = -(_e4092[2]);
                                        } else {
                                            phi_6327_ = _e4092[2];
                                        }
                                        let _e4110 = phi_6327_;
                                        if (_e4106 > _e4110) {
                                            phi_6332_ = _e4106;
                                        } else {
                                            phi_6332_ = _e4110;
                                        }
                                        let _e4113 = phi_6332_;
                                        if (_e4089 > _e4113) {
                                            phi_6337_ = _e4089;
                                        } else {
                                            phi_6337_ = _e4113;
                                        }
                                        let _e4116 = phi_6337_;
                                        let _e4118 = local_4[1u].member_3;
                                        let _e4122 = local_4[1u].member_2[0u];
                                        if (_e4122[0] < 0f) {
                                            phi_6354_ = -(_e4122[0]);
                                        } else {
                                            phi_6354_ = _e4122[0];
                                        }
                                        let _e4129 = phi_6354_;
                                        if (_e4122[1] < 0f) {
                                            phi_6361_ = -(_e4122[1]);
                                        } else {
                                            phi_6361_ = _e4122[1];
                                        }
                                        let _e4133 = phi_6361_;
                                        if (_e4129 > _e4133) {
                                            phi_6366_ = _e4129;
                                        } else {
                                            phi_6366_ = _e4133;
                                        }
                                        let _e4136 = phi_6366_;
                                        if (_e4122[2] < 0f) {
                                            phi_6373_ = -(_e4122[2]);
                                        } else {
                                            phi_6373_ = _e4122[2];
                                        }
                                        let _e4140 = phi_6373_;
                                        if (_e4136 > _e4140) {
                                            phi_6378_ = _e4136;
                                        } else {
                                            phi_6378_ = _e4140;
                                        }
                                        let _e4143 = phi_6378_;
                                        let _e4146 = local_4[1u].member_2[1u];
                                        if (_e4146[0] < 0f) {
                                            phi_6392_ = -(_e4146[0]);
                                        } else {
                                            phi_6392_ = _e4146[0];
                                        }
                                        let _e4153 = phi_6392_;
                                        if (_e4146[1] < 0f) {
                                            phi_6399_ = -(_e4146[1]);
                                        } else {
                                            phi_6399_ = _e4146[1];
                                        }
                                        let _e4157 = phi_6399_;
                                        if (_e4153 > _e4157) {
                                            phi_6404_ = _e4153;
                                        } else {
                                            phi_6404_ = _e4157;
                                        }
                                        let _e4160 = phi_6404_;
                                        if (_e4146[2] < 0f) {
                                            phi_6411_ = -(_e4146[2]);
                                        } else {
                                            phi_6411_ = _e4146[2];
                                        }
                                        let _e4164 = phi_6411_;
                                        if (_e4160 > _e4164) {
                                            phi_6416_ = _e4160;
                                        } else {
                                            phi_6416_ = _e4164;
                                        }
                                        let _e4167 = phi_6416_;
                                        if (_e4143 > _e4167) {
                                            phi_6421_ = _e4143;
                                        } else {
                                            phi_6421_ = _e4167;
                                        }
                                        let _e4170 = phi_6421_;
                                        let _e4172 = local_4[1u].member_3;
                                        let _e4175 = (((_e4062 + _e4064) + (_e4116 + _e4118)) + (_e4170 + _e4172));
                                        let _e4178 = local_4[1u].member_3;
                                        let _e4182 = (((_e1203 * 1.0001f) + (_e4178 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4185 = ((_e3954 * _e3933) - (_e3957 * _e3932));
                                        let _e4188 = ((_e3957 * _e3931) - (_e3951 * _e3933));
                                        let _e4191 = ((_e3951 * _e3932) - (_e3954 * _e3931));
                                        let _e4193 = local[0u];
                                        let _e4201 = (((_e4185 * _e4193[0]) + (_e4188 * _e4193[1])) + (_e4191 * _e4193[2]));
                                        phi_6459_ = type_37(0u, 4u);
                                        phi_6462_ = _e4201;
                                        phi_6464_ = _e4201;
                                        loop {
                                            let _e4203 = phi_6459_;
                                            let _e4205 = phi_6462_;
                                            let _e4207 = phi_6464_;
                                            local_42 = _e4205;
                                            local_43 = _e4207;
                                            local_55 = _e4207;
                                            if (_e4203.member < _e4203.member_1) {
                                                phi_6460_ = type_37((_e4203.member + 1u), _e4203.member_1);
                                                phi_6487_ = type_37(1u, _e4203.member);
                                            } else {
                                                phi_6460_ = _e4203;
                                                phi_6487_ = type_37(0u, type_37().member_1);
                                            }
                                            let _e4221 = phi_6460_;
                                            let _e4223 = phi_6487_;
                                            let _e4227 = (bitcast<i32>(_e4223.member) != 0i);
                                            if _e4227 {
                                                if (_e4223.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4230 = local[_e4223.member_1];
                                                let _e4238 = (((_e4185 * _e4230[0]) + (_e4188 * _e4230[1])) + (_e4191 * _e4230[2]));
                                                if (_e4223.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4241 = local_1[_e4223.member_1];
                                                let _e4249 = (((_e4185 * _e4241[0]) + (_e4188 * _e4241[1])) + (_e4191 * _e4241[2]));
                                                if (_e4207 < _e4238) {
                                                    phi_6537_ = _e4207;
                                                } else {
                                                    phi_6537_ = _e4238;
                                                }
                                                let _e4252 = phi_6537_;
                                                if (_e4252 < _e4249) {
                                                    phi_6542_ = _e4252;
                                                } else {
                                                    phi_6542_ = _e4249;
                                                }
                                                let _e4255 = phi_6542_;
                                                if (_e4205 > _e4238) {
                                                    phi_6547_ = _e4205;
                                                } else {
                                                    phi_6547_ = _e4238;
                                                }
                                                let _e4258 = phi_6547_;
                                                if (_e4258 > _e4249) {
                                                    phi_6552_ = _e4258;
                                                } else {
                                                    phi_6552_ = _e4249;
                                                }
                                                let _e4261 = phi_6552_;
                                                phi_6463_ = _e4261;
                                                phi_6465_ = _e4255;
                                            } else {
                                                phi_6463_ = f32();
                                                phi_6465_ = f32();
                                            }
                                            let _e4263 = phi_6463_;
                                            let _e4265 = phi_6465_;
                                            continue;
                                            continuing {
                                                phi_6459_ = _e4221;
                                                phi_6462_ = _e4263;
                                                phi_6464_ = _e4265;
                                                break if !(_e4227);
                                            }
                                        }
                                        if (_e4185 < 0f) {
                                            phi_6558_ = -(_e4185);
                                        } else {
                                            phi_6558_ = _e4185;
                                        }
                                        let _e4270 = phi_6558_;
                                        if (_e4188 < 0f) {
                                            phi_6564_ = -(_e4188);
                                        } else {
                                            phi_6564_ = _e4188;
                                        }
                                        let _e4274 = phi_6564_;
                                        if (_e4191 < 0f) {
                                            phi_6571_ = -(_e4191);
                                        } else {
                                            phi_6571_ = _e4191;
                                        }
                                        let _e4279 = phi_6571_;
                                        let _e4280 = ((_e4270 + _e4274) + _e4279);
                                        let _e4285 = local_42;
                                        let _e4286 = -(_e4285);
                                        let _e4288 = local_43;
                                        if (_e4288 > _e4286) {
                                            let _e5162 = local_55;
                                            phi_6581_ = _e5162;
                                        } else {
                                            phi_6581_ = _e4286;
                                        }
                                        let _e4291 = phi_6581_;
                                        let _e4296 = (((_e4291 - ((_e4280 * _e4175) * (0.000000059604645f * 17f))) - (_e4280 * _e4182)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4299 = ((_e3954 * _e3948) - (_e3957 * _e3947));
                                        let _e4302 = ((_e3957 * _e3946) - (_e3951 * _e3948));
                                        let _e4305 = ((_e3951 * _e3947) - (_e3954 * _e3946));
                                        let _e4307 = local[0u];
                                        let _e4315 = (((_e4299 * _e4307[0]) + (_e4302 * _e4307[1])) + (_e4305 * _e4307[2]));
                                        phi_6612_ = type_37(0u, 4u);
                                        phi_6615_ = _e4315;
                                        phi_6617_ = _e4315;
                                        loop {
                                            let _e4317 = phi_6612_;
                                            let _e4319 = phi_6615_;
                                            let _e4321 = phi_6617_;
                                            local_44 = _e4319;
                                            local_45 = _e4321;
                                            local_56 = _e4321;
                                            if (_e4317.member < _e4317.member_1) {
                                                phi_6613_ = type_37((_e4317.member + 1u), _e4317.member_1);
                                                phi_6640_ = type_37(1u, _e4317.member);
                                            } else {
                                                phi_6613_ = _e4317;
                                                phi_6640_ = type_37(0u, type_37().member_1);
                                            }
                                            let _e4335 = phi_6613_;
                                            let _e4337 = phi_6640_;
                                            let _e4341 = (bitcast<i32>(_e4337.member) != 0i);
                                            if _e4341 {
                                                if (_e4337.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4344 = local[_e4337.member_1];
                                                let _e4352 = (((_e4299 * _e4344[0]) + (_e4302 * _e4344[1])) + (_e4305 * _e4344[2]));
                                                if (_e4337.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4355 = local_1[_e4337.member_1];
                                                let _e4363 = (((_e4299 * _e4355[0]) + (_e4302 * _e4355[1])) + (_e4305 * _e4355[2]));
                                                if (_e4321 < _e4352) {
                                                    phi_6690_ = _e4321;
                                                } else {
                                                    phi_6690_ = _e4352;
                                                }
                                                let _e4366 = phi_6690_;
                                                if (_e4366 < _e4363) {
                                                    phi_6695_ = _e4366;
                                                } else {
                                                    phi_6695_ = _e4363;
                                                }
                                                let _e4369 = phi_6695_;
                                                if (_e4319 > _e4352) {
                                                    phi_6700_ = _e4319;
                                                } else {
                                                    phi_6700_ = _e4352;
                                                }
                                                let _e4372 = phi_6700_;
                                                if (_e4372 > _e4363) {
                                                    phi_6705_ = _e4372;
                                                } else {
                                                    phi_6705_ = _e4363;
                                                }
                                                let _e4375 = phi_6705_;
                                                phi_6616_ = _e4375;
                                                phi_6618_ = _e4369;
                                            } else {
                                                phi_6616_ = f32();
                                                phi_6618_ = f32();
                                            }
                                            let _e4377 = phi_6616_;
                                            let _e4379 = phi_6618_;
                                            continue;
                                            continuing {
                                                phi_6612_ = _e4335;
                                                phi_6615_ = _e4377;
                                                phi_6617_ = _e4379;
                                                break if !(_e4341);
                                            }
                                        }
                                        if (_e4299 < 0f) {
                                            phi_6711_ = -(_e4299);
                                        } else {
                                            phi_6711_ = _e4299;
                                        }
                                        let _e4384 = phi_6711_;
                                        if (_e4302 < 0f) {
                                            phi_6717_ = -(_e4302);
                                        } else {
                                            phi_6717_ = _e4302;
                                        }
                                        let _e4388 = phi_6717_;
                                        if (_e4305 < 0f) {
                                            phi_6724_ = -(_e4305);
                                        } else {
                                            phi_6724_ = _e4305;
                                        }
                                        let _e4393 = phi_6724_;
                                        let _e4394 = ((_e4384 + _e4388) + _e4393);
                                        let _e4399 = local_44;
                                        let _e4400 = -(_e4399);
                                        let _e4402 = local_45;
                                        if (_e4402 > _e4400) {
                                            let _e5181 = local_56;
                                            phi_6734_ = _e5181;
                                        } else {
                                            phi_6734_ = _e4400;
                                        }
                                        let _e4405 = phi_6734_;
                                        let _e4410 = (((_e4405 - ((_e4394 * _e4175) * (0.000000059604645f * 17f))) - (_e4394 * _e4182)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4296 > _e4410) {
                                            phi_6744_ = _e4296;
                                        } else {
                                            phi_6744_ = _e4410;
                                        }
                                        let _e4413 = phi_6744_;
                                        let _e4414 = (_e3946 - _e3931);
                                        let _e4415 = (_e3947 - _e3932);
                                        let _e4416 = (_e3948 - _e3933);
                                        let _e4419 = ((_e3954 * _e4416) - (_e3957 * _e4415));
                                        let _e4422 = ((_e3957 * _e4414) - (_e3951 * _e4416));
                                        let _e4425 = ((_e3951 * _e4415) - (_e3954 * _e4414));
                                        let _e4427 = local[0u];
                                        let _e4435 = (((_e4419 * _e4427[0]) + (_e4422 * _e4427[1])) + (_e4425 * _e4427[2]));
                                        phi_6777_ = type_37(0u, 4u);
                                        phi_6780_ = _e4435;
                                        phi_6782_ = _e4435;
                                        loop {
                                            let _e4437 = phi_6777_;
                                            let _e4439 = phi_6780_;
                                            let _e4441 = phi_6782_;
                                            local_46 = _e4439;
                                            local_47 = _e4441;
                                            local_57 = _e4441;
                                            if (_e4437.member < _e4437.member_1) {
                                                phi_6778_ = type_37((_e4437.member + 1u), _e4437.member_1);
                                                phi_6805_ = type_37(1u, _e4437.member);
                                            } else {
                                                phi_6778_ = _e4437;
                                                phi_6805_ = type_37(0u, type_37().member_1);
                                            }
                                            let _e4455 = phi_6778_;
                                            let _e4457 = phi_6805_;
                                            let _e4461 = (bitcast<i32>(_e4457.member) != 0i);
                                            if _e4461 {
                                                if (_e4457.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4464 = local[_e4457.member_1];
                                                let _e4472 = (((_e4419 * _e4464[0]) + (_e4422 * _e4464[1])) + (_e4425 * _e4464[2]));
                                                if (_e4457.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4475 = local_1[_e4457.member_1];
                                                let _e4483 = (((_e4419 * _e4475[0]) + (_e4422 * _e4475[1])) + (_e4425 * _e4475[2]));
                                                if (_e4441 < _e4472) {
                                                    phi_6855_ = _e4441;
                                                } else {
                                                    phi_6855_ = _e4472;
                                                }
                                                let _e4486 = phi_6855_;
                                                if (_e4486 < _e4483) {
                                                    phi_6860_ = _e4486;
                                                } else {
                                                    phi_6860_ = _e4483;
                                                }
                                                let _e4489 = phi_6860_;
                                                if (_e4439 > _e4472) {
                                                    phi_6865_ = _e4439;
                                                } else {
                                                    phi_6865_ = _e4472;
                                                }
                                                let _e4492 = phi_6865_;
                                                if (_e4492 > _e4483) {
                                                    phi_6870_ = _e4492;
                                                } else {
                                                    phi_6870_ = _e4483;
                                                }
                                                let _e4495 = phi_6870_;
                                                phi_6781_ = _e4495;
                                                phi_6783_ = _e4489;
                                            } else {
                                                phi_6781_ = f32();
                                                phi_6783_ = f32();
                                            }
                                            let _e4497 = phi_6781_;
                                            let _e4499 = phi_6783_;
                                            continue;
                                            continuing {
                                                phi_6777_ = _e4455;
                                                phi_6780_ = _e4497;
                                                phi_6782_ = _e4499;
                                                break if !(_e4461);
                                            }
                                        }
                                        if (_e4419 < 0f) {
                                            phi_6876_ = -(_e4419);
                                        } else {
                                            phi_6876_ = _e4419;
                                        }
                                        let _e4504 = phi_6876_;
                                        if (_e4422 < 0f) {
                                            phi_6882_ = -(_e4422);
                                        } else {
                                            phi_6882_ = _e4422;
                                        }
                                        let _e4508 = phi_6882_;
                                        if (_e4425 < 0f) {
                                            phi_6889_ = -(_e4425);
                                        } else {
                                            phi_6889_ = _e4425;
                                        }
                                        let _e4513 = phi_6889_;
                                        let _e4514 = ((_e4504 + _e4508) + _e4513);
                                        let _e4519 = local_46;
                                        let _e4520 = -(_e4519);
                                        let _e4522 = local_47;
                                        if (_e4522 > _e4520) {
                                            let _e5201 = local_57;
                                            phi_6899_ = _e5201;
                                        } else {
                                            phi_6899_ = _e4520;
                                        }
                                        let _e4525 = phi_6899_;
                                        let _e4530 = (((_e4525 - ((_e4514 * _e4175) * (0.000000059604645f * 17f))) - (_e4514 * _e4182)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4413 > _e4530) {
                                            phi_6909_ = _e4413;
                                        } else {
                                            phi_6909_ = _e4530;
                                        }
                                        let _e4533 = phi_6909_;
                                        phi_6912_ = (_e4533 > 0f);
                                    }
                                    let _e4536 = phi_6912_;
                                    phi_6913_ = _e4536;
                                } else {
                                    phi_6913_ = false;
                                }
                                let _e4538 = phi_6913_;
                                phi_6915_ = !(_e4538);
                            }
                            let _e4541 = phi_6915_;
                            if _e4541 {
                                let _e4543 = atomicAdd((&counters[3u]), 1u);
                                kept[_e4543] = _e445;
                            }
                        }
                        phi_6923_ = (_e408 + 64u);
                        phi_6924_ = true;
                    }
                    let _e4547 = phi_6923_;
                    let _e4549 = phi_6924_;
                    phi_650_ = _e4547;
                    phi_6925_ = _e4549;
                } else {
                    phi_650_ = u32();
                    phi_6925_ = false;
                }
                let _e4551 = phi_650_;
                let _e4553 = phi_6925_;
                continue;
                continuing {
                    phi_646_ = _e437;
                    phi_649_ = _e4551;
                    break if !(_e4553);
                }
            }
            workgroupBarrier();
            if (_e93 == 0u) {
                let _e4557 = atomicLoad((&counters[3u]));
                if (_e4557 > 0u) {
                    let _e4560 = atomicAdd((&output.member[0u]), _e4557);
                    atomicStore((&counters[4u]), _e4560);
                }
            }
            workgroupBarrier();
            let _e4563 = atomicLoad((&counters[4u]));
            if (_e93 == 0u) {
                let _e4566 = atomicLoad((&counters[5u]));
                let _e4568 = atomicAdd((&output.member[1u]), _e4566);
            }
            let _e4570 = atomicLoad((&counters[3u]));
            phi_6955_ = type_35(0i, 16i);
            phi_6958_ = _e93;
            loop {
                let _e4572 = phi_6955_;
                let _e4574 = phi_6958_;
                if (_e4572.member < _e4572.member_1) {
                    let _e4582 = (_e4572.member + 1i);
                    if ((false == (_e4582 > _e4572.member)) != false) {
                        phi_6979_ = true;
                    } else {
                        phi_6979_ = false;
                    }
                    let _e4587 = phi_6979_;
                    if _e4587 {
                        phi_6985_ = type_36(0u, type_36().member_1);
                    } else {
                        phi_6985_ = type_36(1u, _e4582);
                    }
                    let _e4593 = phi_6985_;
                    if (bitcast<i32>(_e4593.member) != 0i) {
                    } else {
                        return;
                    }
                    phi_6956_ = type_35(_e4593.member_1, _e4572.member_1);
                    phi_6999_ = type_36(1u, _e4572.member);
                } else {
                    phi_6956_ = _e4572;
                    phi_6999_ = type_36(0u, type_36().member_1);
                }
                let _e4603 = phi_6956_;
                let _e4605 = phi_6999_;
                if (bitcast<i32>(_e4605.member) != 0i) {
                    if (_e4574 >= _e4570) {
                        phi_7105_ = u32();
                        phi_7106_ = false;
                    } else {
                        let _e4611 = kept[_e4574];
                        let _e4620 = params.member.member_18[0u][0u];
                        let _e4627 = params.member.member_18[0u][2u];
                        let _e4630 = leaves.member[(_e4620 + ((_e186 * 32u) + (_e4611 >> bitcast<u32>(5i))))];
                        let _e4633 = leaves.member[(_e4627 + ((_e189 * 32u) + (_e4611 & 31u)))];
                        let _e4636 = params.member.member_16;
                        let _e4637 = (_e4563 + _e4574);
                        if (_e4637 < _e4636) {
                            atomicStore((&output.member[(4u + (2u * _e4637))]), _e4630.member_1);
                            atomicStore((&output.member[((2u * _e4637) + 5u)]), _e4633.member_1);
                        }
                        phi_7105_ = (_e4574 + 64u);
                        phi_7106_ = true;
                    }
                    let _e4647 = phi_7105_;
                    let _e4649 = phi_7106_;
                    phi_6959_ = _e4647;
                    phi_7107_ = _e4649;
                } else {
                    phi_6959_ = u32();
                    phi_7107_ = false;
                }
                let _e4651 = phi_6959_;
                let _e4653 = phi_7107_;
                continue;
                continuing {
                    phi_6955_ = _e4603;
                    phi_6958_ = _e4651;
                    break if !(_e4653);
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
