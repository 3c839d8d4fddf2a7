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
    var phi_1762_: type_23;
    var phi_1763_: type_23;
    var phi_2152_: f32;
    var phi_2159_: f32;
    var phi_2164_: f32;
    var phi_2171_: f32;
    var phi_2176_: f32;
    var phi_2189_: f32;
    var phi_2196_: f32;
    var phi_2201_: f32;
    var phi_2208_: f32;
    var phi_2213_: f32;
    var phi_2218_: f32;
    var phi_2235_: f32;
    var phi_2242_: f32;
    var phi_2247_: f32;
    var phi_2254_: f32;
    var phi_2259_: f32;
    var phi_2273_: f32;
    var phi_2280_: f32;
    var phi_2285_: f32;
    var phi_2292_: f32;
    var phi_2297_: f32;
    var phi_2302_: f32;
    var phi_2319_: f32;
    var phi_2326_: f32;
    var phi_2331_: f32;
    var phi_2338_: f32;
    var phi_2343_: f32;
    var phi_2357_: f32;
    var phi_2364_: f32;
    var phi_2369_: f32;
    var phi_2376_: f32;
    var phi_2381_: f32;
    var phi_2386_: f32;
    var phi_2417_: f32;
    var phi_2423_: f32;
    var phi_2430_: f32;
    var phi_2437_: f32;
    var phi_2443_: f32;
    var phi_2450_: f32;
    var phi_2456_: f32;
    var phi_2462_: f32;
    var phi_2468_: f32;
    var phi_2475_: f32;
    var phi_2482_: f32;
    var phi_2506_: f32;
    var phi_2511_: f32;
    var phi_2516_: f32;
    var phi_2521_: f32;
    var phi_2526_: f32;
    var phi_2531_: f32;
    var phi_2541_: f32;
    var phi_2792_: f32;
    var phi_2799_: f32;
    var phi_2804_: f32;
    var phi_2811_: f32;
    var phi_2816_: f32;
    var phi_2829_: f32;
    var phi_2836_: f32;
    var phi_2841_: f32;
    var phi_2848_: f32;
    var phi_2853_: f32;
    var phi_2858_: f32;
    var phi_2875_: f32;
    var phi_2882_: f32;
    var phi_2887_: f32;
    var phi_2894_: f32;
    var phi_2899_: f32;
    var phi_2913_: f32;
    var phi_2920_: f32;
    var phi_2925_: f32;
    var phi_2932_: f32;
    var phi_2937_: f32;
    var phi_2942_: f32;
    var phi_2959_: f32;
    var phi_2966_: f32;
    var phi_2971_: f32;
    var phi_2978_: f32;
    var phi_2983_: f32;
    var phi_2997_: f32;
    var phi_3004_: f32;
    var phi_3009_: f32;
    var phi_3016_: f32;
    var phi_3021_: f32;
    var phi_3026_: f32;
    var phi_3064_: type_37;
    var phi_3067_: f32;
    var phi_3069_: f32;
    var phi_3065_: type_37;
    var phi_3092_: type_37;
    var phi_3142_: f32;
    var phi_3147_: f32;
    var phi_3152_: f32;
    var phi_3157_: f32;
    var phi_3068_: f32;
    var phi_3070_: f32;
    var phi_3163_: f32;
    var phi_3169_: f32;
    var phi_3176_: f32;
    var local_30: f32;
    var local_31: f32;
    var phi_3186_: f32;
    var phi_3217_: type_37;
    var phi_3220_: f32;
    var phi_3222_: f32;
    var phi_3218_: type_37;
    var phi_3245_: type_37;
    var phi_3295_: f32;
    var phi_3300_: f32;
    var phi_3305_: f32;
    var phi_3310_: f32;
    var phi_3221_: f32;
    var phi_3223_: f32;
    var phi_3316_: f32;
    var phi_3322_: f32;
    var phi_3329_: f32;
    var local_32: f32;
    var local_33: f32;
    var phi_3339_: f32;
    var phi_3349_: f32;
    var phi_3517_: bool;
    var phi_3974_: f32;
    var phi_3981_: f32;
    var phi_3986_: f32;
    var phi_3993_: f32;
    var phi_3998_: f32;
    var phi_4011_: f32;
    var phi_4018_: f32;
    var phi_4023_: f32;
    var phi_4030_: f32;
    var phi_4035_: f32;
    var phi_4040_: f32;
    var phi_4057_: f32;
    var phi_4064_: f32;
    var phi_4069_: f32;
    var phi_4076_: f32;
    var phi_4081_: f32;
    var phi_4095_: f32;
    var phi_4102_: f32;
    var phi_4107_: f32;
    var phi_4114_: f32;
    var phi_4119_: f32;
    var phi_4124_: f32;
    var phi_4141_: f32;
    var phi_4148_: f32;
    var phi_4153_: f32;
    var phi_4160_: f32;
    var phi_4165_: f32;
    var phi_4179_: f32;
    var phi_4186_: f32;
    var phi_4191_: f32;
    var phi_4198_: f32;
    var phi_4203_: f32;
    var phi_4208_: f32;
    var phi_4239_: f32;
    var phi_4245_: f32;
    var phi_4252_: f32;
    var phi_4259_: f32;
    var phi_4265_: f32;
    var phi_4272_: f32;
    var phi_4278_: f32;
    var phi_4284_: f32;
    var phi_4290_: f32;
    var phi_4297_: f32;
    var phi_4304_: f32;
    var phi_4328_: f32;
    var phi_4333_: f32;
    var phi_4338_: f32;
    var phi_4343_: f32;
    var phi_4348_: f32;
    var phi_4353_: f32;
    var phi_4363_: f32;
    var phi_4614_: f32;
    var phi_4621_: f32;
    var phi_4626_: f32;
    var phi_4633_: f32;
    var phi_4638_: f32;
    var phi_4651_: f32;
    var phi_4658_: f32;
    var phi_4663_: f32;
    var phi_4670_: f32;
    var phi_4675_: f32;
    var phi_4680_: f32;
    var phi_4697_: f32;
    var phi_4704_: f32;
    var phi_4709_: f32;
    var phi_4716_: f32;
    var phi_4721_: f32;
    var phi_4735_: f32;
    var phi_4742_: f32;
    var phi_4747_: f32;
    var phi_4754_: f32;
    var phi_4759_: f32;
    var phi_4764_: f32;
    var phi_4781_: f32;
    var phi_4788_: f32;
    var phi_4793_: f32;
    var phi_4800_: f32;
    var phi_4805_: f32;
    var phi_4819_: f32;
    var phi_4826_: f32;
    var phi_4831_: f32;
    var phi_4838_: f32;
    var phi_4843_: f32;
    var phi_4848_: f32;
    var phi_4886_: type_37;
    var phi_4889_: f32;
    var phi_4891_: f32;
    var phi_4887_: type_37;
    var phi_4914_: type_37;
    var phi_4964_: f32;
    var phi_4969_: f32;
    var phi_4974_: f32;
    var phi_4979_: f32;
    var phi_4890_: f32;
    var phi_4892_: f32;
    var phi_4985_: f32;
    var phi_4991_: f32;
    var phi_4998_: f32;
    var local_34: f32;
    var local_35: f32;
    var phi_5008_: f32;
    var phi_5039_: type_37;
    var phi_5042_: f32;
    var phi_5044_: f32;
    var phi_5040_: type_37;
    var phi_5067_: type_37;
    var phi_5117_: f32;
    var phi_5122_: f32;
    var phi_5127_: f32;
    var phi_5132_: f32;
    var phi_5043_: f32;
    var phi_5045_: f32;
    var phi_5138_: f32;
    var phi_5144_: f32;
    var phi_5151_: f32;
    var local_36: f32;
    var local_37: f32;
    var phi_5161_: f32;
    var phi_5171_: f32;
    var phi_5339_: bool;
    var phi_5585_: f32;
    var phi_5592_: f32;
    var phi_5597_: f32;
    var phi_5604_: f32;
    var phi_5609_: f32;
    var phi_5622_: f32;
    var phi_5629_: f32;
    var phi_5634_: f32;
    var phi_5641_: f32;
    var phi_5646_: f32;
    var phi_5651_: f32;
    var phi_5668_: f32;
    var phi_5675_: f32;
    var phi_5680_: f32;
    var phi_5687_: f32;
    var phi_5692_: f32;
    var phi_5706_: f32;
    var phi_5713_: f32;
    var phi_5718_: f32;
    var phi_5725_: f32;
    var phi_5730_: f32;
    var phi_5735_: f32;
    var phi_5752_: f32;
    var phi_5759_: f32;
    var phi_5764_: f32;
    var phi_5771_: f32;
    var phi_5776_: f32;
    var phi_5790_: f32;
    var phi_5797_: f32;
    var phi_5802_: f32;
    var phi_5809_: f32;
    var phi_5814_: f32;
    var phi_5819_: f32;
    var phi_5850_: f32;
    var phi_5856_: f32;
    var phi_5863_: f32;
    var phi_5870_: f32;
    var phi_5876_: f32;
    var phi_5883_: f32;
    var phi_5889_: f32;
    var phi_5895_: f32;
    var phi_5901_: f32;
    var phi_5908_: f32;
    var phi_5915_: f32;
    var phi_5939_: f32;
    var phi_5944_: f32;
    var phi_5949_: f32;
    var phi_5954_: f32;
    var phi_5959_: f32;
    var phi_5964_: f32;
    var phi_5974_: f32;
    var phi_6225_: f32;
    var phi_6232_: f32;
    var phi_6237_: f32;
    var phi_6244_: f32;
    var phi_6249_: f32;
    var phi_6262_: f32;
    var phi_6269_: f32;
    var phi_6274_: f32;
    var phi_6281_: f32;
    var phi_6286_: f32;
    var phi_6291_: f32;
    var phi_6308_: f32;
    var phi_6315_: f32;
    var phi_6320_: f32;
    var phi_6327_: f32;
    var phi_6332_: f32;
    var phi_6346_: f32;
    var phi_6353_: f32;
    var phi_6358_: f32;
    var phi_6365_: f32;
    var phi_6370_: f32;
    var phi_6375_: f32;
    var phi_6392_: f32;
    var phi_6399_: f32;
    var phi_6404_: f32;
    var phi_6411_: f32;
    var phi_6416_: f32;
    var phi_6430_: f32;
    var phi_6437_: f32;
    var phi_6442_: f32;
    var phi_6449_: f32;
    var phi_6454_: f32;
    var phi_6459_: f32;
    var phi_6497_: type_37;
    var phi_6500_: f32;
    var phi_6502_: f32;
    var phi_6498_: type_37;
    var phi_6525_: type_37;
    var phi_6575_: f32;
    var phi_6580_: f32;
    var phi_6585_: f32;
    var phi_6590_: f32;
    var phi_6501_: f32;
    var phi_6503_: f32;
    var phi_6596_: f32;
    var phi_6602_: f32;
    var phi_6609_: f32;
    var local_38: f32;
    var local_39: f32;
    var phi_6619_: f32;
    var phi_6650_: type_37;
    var phi_6653_: f32;
    var phi_6655_: f32;
    var phi_6651_: type_37;
    var phi_6678_: type_37;
    var phi_6728_: f32;
    var phi_6733_: f32;
    var phi_6738_: f32;
    var phi_6743_: f32;
    var phi_6654_: f32;
    var phi_6656_: f32;
    var phi_6749_: f32;
    var phi_6755_: f32;
    var phi_6762_: f32;
    var local_40: f32;
    var local_41: f32;
    var phi_6772_: f32;
    var phi_6782_: f32;
    var phi_6950_: bool;
    var phi_6951_: bool;
    var phi_6953_: bool;
    var phi_6961_: u32;
    var phi_6962_: bool;
    var phi_650_: u32;
    var phi_6963_: bool;
    var phi_6993_: type_35;
    var phi_6996_: u32;
    var phi_7017_: bool;
    var phi_7023_: type_36;
    var phi_6994_: type_35;
    var phi_7037_: type_36;
    var phi_7119_: type_37;
    var phi_7143_: u32;
    var phi_7144_: bool;
    var phi_6997_: u32;
    var phi_7145_: bool;
    var local_42: bool;
    var local_43: f32;
    var local_44: f32;
    var local_45: f32;
    var local_46: f32;
    var local_47: f32;
    var local_48: f32;

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
                        phi_6961_ = u32();
                        phi_6962_ = false;
                    } else {
                        let _e445 = hits[_e408];
                        let _e454 = params.member.member_18[0u][1u];
                        let _e455 = (_e454 + ((_e186 * 32u) + (_e445 >> bitcast<u32>(5i))));
                        let _e461 = params.member.member_18[0u][1u];
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
                                            local_42 = _e658;
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
                                        let _e4439 = local_42;
                                        phi_1702_ = _e4439;
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
                            let _e1201 = local_16.member_1;
                            let _e1203 = local_17.member_1;
                            if (_e1201 < _e1203) {
                                phi_1762_ = _e466;
                                phi_1763_ = _e464;
                            } else {
                                phi_1762_ = _e464;
                                phi_1763_ = _e466;
                            }
                            let _e1206 = phi_1762_;
                            let _e1208 = phi_1763_;
                            let _e1210 = params.member.member_4;
                            let _e1212 = params.member.member_5;
                            let _e1222 = paths.member[_e1208.member[0]];
                            let _e1224 = paths.member[_e1208.member[1]];
                            let _e1230 = paths.member[_e1206.member[0]];
                            let _e1232 = paths.member[_e1206.member[1]];
                            local_7 = type_72(array<array<f32, 3>, 2>(array<f32, 3>((_e1230.member[0] - _e1222.member[0]), (_e1230.member[1] - _e1222.member[1]), (_e1230.member[2] - _e1222.member[2])), array<f32, 3>((_e1230.member_1[0] - _e1222.member_1[0]), (_e1230.member_1[1] - _e1222.member_1[1]), (_e1230.member_1[2] - _e1222.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1224.member[0] - _e1222.member[0]), (_e1224.member[1] - _e1222.member[1]), (_e1224.member[2] - _e1222.member[2])), array<f32, 3>((_e1224.member_1[0] - _e1222.member_1[0]), (_e1224.member_1[1] - _e1222.member_1[1]), (_e1224.member_1[2] - _e1222.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1230.member[0] - _e1232.member[0]), (_e1230.member[1] - _e1232.member[1]), (_e1230.member[2] - _e1232.member[2])), array<f32, 3>((_e1230.member_1[0] - _e1232.member_1[0]), (_e1230.member_1[1] - _e1232.member_1[1]), (_e1230.member_1[2] - _e1232.member_1[2]))), (_e1210 + _e1210));
                            let _e1292 = local_7.member_1[0u];
                            let _e1298 = local_7.member_2[0u];
                            let _e1304 = ((_e1292[1] * _e1298[2]) - (_e1292[2] * _e1298[1]));
                            let _e1307 = ((_e1292[2] * _e1298[0]) - (_e1292[0] * _e1298[2]));
                            let _e1310 = ((_e1292[0] * _e1298[1]) - (_e1292[1] * _e1298[0]));
                            let _e1313 = local_7.member_1[1u];
                            let _e1319 = local_7.member_2[1u];
                            let _e1325 = ((_e1313[1] * _e1319[2]) - (_e1313[2] * _e1319[1]));
                            let _e1328 = ((_e1313[2] * _e1319[0]) - (_e1313[0] * _e1319[2]));
                            let _e1331 = ((_e1313[0] * _e1319[1]) - (_e1313[1] * _e1319[0]));
                            let _e1334 = local_7.member_1[0u];
                            let _e1340 = local_7.member_2[1u];
                            let _e1355 = local_7.member_1[1u];
                            let _e1361 = local_7.member_2[0u];
                            let _e1374 = (((_e1334[1] * _e1340[2]) - (_e1334[2] * _e1340[1])) + ((_e1355[1] * _e1361[2]) - (_e1355[2] * _e1361[1])));
                            let _e1375 = (((_e1334[2] * _e1340[0]) - (_e1334[0] * _e1340[2])) + ((_e1355[2] * _e1361[0]) - (_e1355[0] * _e1361[2])));
                            let _e1376 = (((_e1334[0] * _e1340[1]) - (_e1334[1] * _e1340[0])) + ((_e1355[0] * _e1361[1]) - (_e1355[1] * _e1361[0])));
                            let _e1379 = local_7.member[0u];
                            let _e1390 = local_7.member[1u];
                            let _e1401 = local_7.member[0u];
                            let _e1410 = ((((_e1390[0] * _e1304) + (_e1390[1] * _e1307)) + (_e1390[2] * _e1310)) + (((_e1401[0] * _e1374) + (_e1401[1] * _e1375)) + (_e1401[2] * _e1376)));
                            let _e1413 = local_7.member[0u];
                            let _e1424 = local_7.member[1u];
                            let _e1433 = ((((_e1413[0] * _e1325) + (_e1413[1] * _e1328)) + (_e1413[2] * _e1331)) + (((_e1424[0] * _e1374) + (_e1424[1] * _e1375)) + (_e1424[2] * _e1376)));
                            let _e1436 = local_7.member[1u];
                            let _e1447 = local_7.member[0u];
                            if (_e1447[0] < 0f) {
                                phi_2152_ = -(_e1447[0]);
                            } else {
                                phi_2152_ = _e1447[0];
                            }
                            let _e1454 = phi_2152_;
                            if (_e1447[1] < 0f) {
                                phi_2159_ = -(_e1447[1]);
                            } else {
                                phi_2159_ = _e1447[1];
                            }
                            let _e1458 = phi_2159_;
                            if (_e1454 > _e1458) {
                                phi_2164_ = _e1454;
                            } else {
                                phi_2164_ = _e1458;
                            }
                            let _e1461 = phi_2164_;
                            if (_e1447[2] < 0f) {
                                phi_2171_ = -(_e1447[2]);
                            } else {
                                phi_2171_ = _e1447[2];
                            }
                            let _e1465 = phi_2171_;
                            if (_e1461 > _e1465) {
                                phi_2176_ = _e1461;
                            } else {
                                phi_2176_ = _e1465;
                            }
                            let _e1468 = phi_2176_;
                            let _e1471 = local_7.member[1u];
                            if (_e1471[0] < 0f) {
                                phi_2189_ = -(_e1471[0]);
                            } else {
                                phi_2189_ = _e1471[0];
                            }
                            let _e1478 = phi_2189_;
                            if (_e1471[1] < 0f) {
                                phi_2196_ = -(_e1471[1]);
                            } else {
                                phi_2196_ = _e1471[1];
                            }
                            let _e1482 = phi_2196_;
                            if (_e1478 > _e1482) {
                                phi_2201_ = _e1478;
                            } else {
                                phi_2201_ = _e1482;
                            }
                            let _e1485 = phi_2201_;
                            if (_e1471[2] < 0f) {
                                phi_2208_ = -(_e1471[2]);
                            } else {
                                phi_2208_ = _e1471[2];
                            }
                            let _e1489 = phi_2208_;
                            if (_e1485 > _e1489) {
                                phi_2213_ = _e1485;
                            } else {
                                phi_2213_ = _e1489;
                            }
                            let _e1492 = phi_2213_;
                            if (_e1468 > _e1492) {
                                phi_2218_ = _e1468;
                            } else {
                                phi_2218_ = _e1492;
                            }
                            let _e1495 = phi_2218_;
                            let _e1497 = local_7.member_3;
                            let _e1498 = (_e1495 + _e1497);
                            let _e1501 = local_7.member_1[0u];
                            if (_e1501[0] < 0f) {
                                phi_2235_ = -(_e1501[0]);
                            } else {
                                phi_2235_ = _e1501[0];
                            }
                            let _e1508 = phi_2235_;
                            if (_e1501[1] < 0f) {
                                phi_2242_ = -(_e1501[1]);
                            } else {
                                phi_2242_ = _e1501[1];
                            }
                            let _e1512 = phi_2242_;
                            if (_e1508 > _e1512) {
                                phi_2247_ = _e1508;
                            } else {
                                phi_2247_ = _e1512;
                            }
                            let _e1515 = phi_2247_;
                            if (_e1501[2] < 0f) {
                                phi_2254_ = -(_e1501[2]);
                            } else {
                                phi_2254_ = _e1501[2];
                            }
                            let _e1519 = phi_2254_;
                            if (_e1515 > _e1519) {
                                phi_2259_ = _e1515;
                            } else {
                                phi_2259_ = _e1519;
                            }
                            let _e1522 = phi_2259_;
                            let _e1525 = local_7.member_1[1u];
                            if (_e1525[0] < 0f) {
                                phi_2273_ = -(_e1525[0]);
                            } else {
                                phi_2273_ = _e1525[0];
                            }
                            let _e1532 = phi_2273_;
                            if (_e1525[1] < 0f) {
                                phi_2280_ = -(_e1525[1]);
                            } else {
                                phi_2280_ = _e1525[1];
                            }
                            let _e1536 = phi_2280_;
                            if (_e1532 > _e1536) {
                                phi_2285_ = _e1532;
                            } else {
                                phi_2285_ = _e1536;
                            }
                            let _e1539 = phi_2285_;
                            if (_e1525[2] < 0f) {
                                phi_2292_ = -(_e1525[2]);
                            } else {
                                phi_2292_ = _e1525[2];
                            }
                            let _e1543 = phi_2292_;
                            if (_e1539 > _e1543) {
                                phi_2297_ = _e1539;
                            } else {
                                phi_2297_ = _e1543;
                            }
                            let _e1546 = phi_2297_;
                            if (_e1522 > _e1546) {
                                phi_2302_ = _e1522;
                            } else {
                                phi_2302_ = _e1546;
                            }
                            let _e1549 = phi_2302_;
                            let _e1551 = local_7.member_3;
                            let _e1552 = (_e1549 + _e1551);
                            let _e1555 = local_7.member_2[0u];
                            if (_e1555[0] < 0f) {
                                phi_2319_ = -(_e1555[0]);
                            } else {
                                phi_2319_ = _e1555[0];
                            }
                            let _e1562 = phi_2319_;
                            if (_e1555[1] < 0f) {
                                phi_2326_ = -(_e1555[1]);
                            } else {
                                phi_2326_ = _e1555[1];
                            }
                            let _e1566 = phi_2326_;
                            if (_e1562 > _e1566) {
                                phi_2331_ = _e1562;
                            } else {
                                phi_2331_ = _e1566;
                            }
                            let _e1569 = phi_2331_;
                            if (_e1555[2] < 0f) {
                                phi_2338_ = -(_e1555[2]);
                            } else {
                                phi_2338_ = _e1555[2];
                            }
                            let _e1573 = phi_2338_;
                            if (_e1569 > _e1573) {
                                phi_2343_ = _e1569;
                            } else {
                                phi_2343_ = _e1573;
                            }
                            let _e1576 = phi_2343_;
                            let _e1579 = local_7.member_2[1u];
                            if (_e1579[0] < 0f) {
                                phi_2357_ = -(_e1579[0]);
                            } else {
                                phi_2357_ = _e1579[0];
                            }
                            let _e1586 = phi_2357_;
                            if (_e1579[1] < 0f) {
                                phi_2364_ = -(_e1579[1]);
                            } else {
                                phi_2364_ = _e1579[1];
                            }
                            let _e1590 = phi_2364_;
                            if (_e1586 > _e1590) {
                                phi_2369_ = _e1586;
                            } else {
                                phi_2369_ = _e1590;
                            }
                            let _e1593 = phi_2369_;
                            if (_e1579[2] < 0f) {
                                phi_2376_ = -(_e1579[2]);
                            } else {
                                phi_2376_ = _e1579[2];
                            }
                            let _e1597 = phi_2376_;
                            if (_e1593 > _e1597) {
                                phi_2381_ = _e1593;
                            } else {
                                phi_2381_ = _e1597;
                            }
                            let _e1600 = phi_2381_;
                            if (_e1576 > _e1600) {
                                phi_2386_ = _e1576;
                            } else {
                                phi_2386_ = _e1600;
                            }
                            let _e1603 = phi_2386_;
                            let _e1605 = local_7.member_3;
                            let _e1606 = (_e1603 + _e1605);
                            let _e1608 = ((_e1552 * 8f) * _e1606);
                            let _e1615 = local_7.member_3;
                            if (_e1304 < 0f) {
                                phi_2417_ = -(_e1304);
                            } else {
                                phi_2417_ = _e1304;
                            }
                            let _e1632 = phi_2417_;
                            if (_e1307 < 0f) {
                                phi_2423_ = -(_e1307);
                            } else {
                                phi_2423_ = _e1307;
                            }
                            let _e1636 = phi_2423_;
                            if (_e1310 < 0f) {
                                phi_2430_ = -(_e1310);
                            } else {
                                phi_2430_ = _e1310;
                            }
                            let _e1641 = phi_2430_;
                            let _e1642 = ((_e1632 + _e1636) + _e1641);
                            if (_e1325 < 0f) {
                                phi_2437_ = -(_e1325);
                            } else {
                                phi_2437_ = _e1325;
                            }
                            let _e1646 = phi_2437_;
                            if (_e1328 < 0f) {
                                phi_2443_ = -(_e1328);
                            } else {
                                phi_2443_ = _e1328;
                            }
                            let _e1650 = phi_2443_;
                            if (_e1331 < 0f) {
                                phi_2450_ = -(_e1331);
                            } else {
                                phi_2450_ = _e1331;
                            }
                            let _e1655 = phi_2450_;
                            let _e1656 = ((_e1646 + _e1650) + _e1655);
                            if (_e1642 > _e1656) {
                                phi_2456_ = _e1642;
                            } else {
                                phi_2456_ = _e1656;
                            }
                            let _e1659 = phi_2456_;
                            if (_e1374 < 0f) {
                                phi_2462_ = -(_e1374);
                            } else {
                                phi_2462_ = _e1374;
                            }
                            let _e1663 = phi_2462_;
                            if (_e1375 < 0f) {
                                phi_2468_ = -(_e1375);
                            } else {
                                phi_2468_ = _e1375;
                            }
                            let _e1667 = phi_2468_;
                            if (_e1376 < 0f) {
                                phi_2475_ = -(_e1376);
                            } else {
                                phi_2475_ = _e1376;
                            }
                            let _e1672 = phi_2475_;
                            let _e1674 = (((_e1663 + _e1667) + _e1672) * 0.5f);
                            if (_e1659 > _e1674) {
                                phi_2482_ = _e1659;
                            } else {
                                phi_2482_ = _e1674;
                            }
                            let _e1677 = phi_2482_;
                            let _e1682 = local_7.member_3;
                            let _e1695 = ((((_e1379[0] * _e1304) + (_e1379[1] * _e1307)) + (_e1379[2] * _e1310)) * 3f);
                            let _e1696 = ((((_e1436[0] * _e1325) + (_e1436[1] * _e1328)) + (_e1436[2] * _e1331)) * 3f);
                            if (_e1695 < _e1696) {
                                phi_2506_ = _e1695;
                            } else {
                                phi_2506_ = _e1696;
                            }
                            let _e1699 = phi_2506_;
                            if (_e1410 < _e1433) {
                                phi_2511_ = _e1410;
                            } else {
                                phi_2511_ = _e1433;
                            }
                            let _e1702 = phi_2511_;
                            if (_e1699 < _e1702) {
                                phi_2516_ = _e1699;
                            } else {
                                phi_2516_ = _e1702;
                            }
                            let _e1705 = phi_2516_;
                            if (_e1695 > _e1696) {
                                phi_2521_ = _e1695;
                            } else {
                                phi_2521_ = _e1696;
                            }
                            let _e1708 = phi_2521_;
                            if (_e1410 > _e1433) {
                                phi_2526_ = _e1410;
                            } else {
                                phi_2526_ = _e1433;
                            }
                            let _e1711 = phi_2526_;
                            if (_e1708 > _e1711) {
                                phi_2531_ = _e1708;
                            } else {
                                phi_2531_ = _e1711;
                            }
                            let _e1714 = phi_2531_;
                            let _e1719 = -(_e1714);
                            if (_e1705 > _e1719) {
                                phi_2541_ = _e1705;
                            } else {
                                phi_2541_ = _e1719;
                            }
                            let _e1722 = phi_2541_;
                            if ((_e1722 - ((((((_e1498 * 8f) * _e1608) * (0.000000059604645f * (490f / 64f))) + ((_e1615 * 19f) * ((_e1498 * (_e1552 + _e1606)) + (_e1552 * _e1606)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1498) * ((1f + _e1552) * (1f + _e1606))))) + ((_e1212 * (((_e1677 + (_e1608 * (0.000000059604645f * 4f))) + ((_e1682 * 6f) * (_e1552 + _e1606))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1552) * (1f + _e1606))))) * (3f * 1.0001f)))) > 0f) {
                                phi_3517_ = true;
                            } else {
                                let _e1727 = local_7.member_1[0u];
                                let _e1733 = local_7.member_1[1u];
                                let _e1737 = (_e1727[0] + _e1733[0]);
                                let _e1738 = (_e1727[1] + _e1733[1]);
                                let _e1739 = (_e1727[2] + _e1733[2]);
                                let _e1742 = local_7.member_2[0u];
                                let _e1748 = local_7.member_2[1u];
                                let _e1752 = (_e1742[0] + _e1748[0]);
                                let _e1753 = (_e1742[1] + _e1748[1]);
                                let _e1754 = (_e1742[2] + _e1748[2]);
                                let _e1757 = ((_e1738 * _e1754) - (_e1739 * _e1753));
                                let _e1760 = ((_e1739 * _e1752) - (_e1737 * _e1754));
                                let _e1763 = ((_e1737 * _e1753) - (_e1738 * _e1752));
                                let _e1766 = local_7.member[0u];
                                let _e1772 = local_7.member_1[0u];
                                let _e1778 = local_7.member_2[0u];
                                let _e1782 = (_e1766[0] - _e1772[0]);
                                let _e1783 = (_e1766[1] - _e1772[1]);
                                let _e1784 = (_e1766[2] - _e1772[2]);
                                let _e1793 = local_7.member[1u];
                                let _e1799 = local_7.member_1[1u];
                                let _e1805 = local_7.member_2[1u];
                                let _e1809 = (_e1793[0] - _e1799[0]);
                                let _e1810 = (_e1793[1] - _e1799[1]);
                                let _e1811 = (_e1793[2] - _e1799[2]);
                                local_5 = array<array<f32, 3>, 4>(_e1766, array<f32, 3>(_e1782, _e1783, _e1784), array<f32, 3>((_e1766[0] - _e1778[0]), (_e1766[1] - _e1778[1]), (_e1766[2] - _e1778[2])), array<f32, 3>((_e1782 - _e1778[0]), (_e1783 - _e1778[1]), (_e1784 - _e1778[2])));
                                local_6 = array<array<f32, 3>, 4>(_e1793, array<f32, 3>(_e1809, _e1810, _e1811), array<f32, 3>((_e1793[0] - _e1805[0]), (_e1793[1] - _e1805[1]), (_e1793[2] - _e1805[2])), array<f32, 3>((_e1809 - _e1805[0]), (_e1810 - _e1805[1]), (_e1811 - _e1805[2])));
                                let _e1828 = local_7.member[0u];
                                if (_e1828[0] < 0f) {
                                    phi_2792_ = -(_e1828[0]);
                                } else {
                                    phi_2792_ = _e1828[0];
                                }
                                let _e1835 = phi_2792_;
                                if (_e1828[1] < 0f) {
                                    phi_2799_ = -(_e1828[1]);
                                } else {
                                    phi_2799_ = _e1828[1];
                                }
                                let _e1839 = phi_2799_;
                                if (_e1835 > _e1839) {
                                    phi_2804_ = _e1835;
                                } else {
                                    phi_2804_ = _e1839;
                                }
                                let _e1842 = phi_2804_;
                                if (_e1828[2] < 0f) {
                                    phi_2811_ = -(_e1828[2]);
                                } else {
                                    phi_2811_ = _e1828[2];
                                }
                                let _e1846 = phi_2811_;
                                if (_e1842 > _e1846) {
                                    phi_2816_ = _e1842;
                                } else {
                                    phi_2816_ = _e1846;
                                }
                                let _e1849 = phi_2816_;
                                let _e1852 = local_7.member[1u];
                                if (_e1852[0] < 0f) {
                                    phi_2829_ = -(_e1852[0]);
                                } else {
                                    phi_2829_ = _e1852[0];
                                }
                                let _e1859 = phi_2829_;
                                if (_e1852[1] < 0f) {
                                    phi_2836_ = -(_e1852[1]);
                                } else {
                                    phi_2836_ = _e1852[1];
                                }
                                let _e1863 = phi_2836_;
                                if (_e1859 > _e1863) {
                                    phi_2841_ = _e1859;
                                } else {
                                    phi_2841_ = _e1863;
                                }
                                let _e1866 = phi_2841_;
                                if (_e1852[2] < 0f) {
                                    phi_2848_ = -(_e1852[2]);
                                } else {
                                    phi_2848_ = _e1852[2];
                                }
                                let _e1870 = phi_2848_;
                                if (_e1866 > _e1870) {
                                    phi_2853_ = _e1866;
                                } else {
                                    phi_2853_ = _e1870;
                                }
                                let _e1873 = phi_2853_;
                                if (_e1849 > _e1873) {
                                    phi_2858_ = _e1849;
                                } else {
                                    phi_2858_ = _e1873;
                                }
                                let _e1876 = phi_2858_;
                                let _e1878 = local_7.member_3;
                                let _e1882 = local_7.member_1[0u];
                                if (_e1882[0] < 0f) {
                                    phi_2875_ = -(_e1882[0]);
                                } else {
                                    phi_2875_ = _e1882[0];
                                }
                                let _e1889 = phi_2875_;
                                if (_e1882[1] < 0f) {
                                    phi_2882_ = -(_e1882[1]);
                                } else {
                                    phi_2882_ = _e1882[1];
                                }
                                let _e1893 = phi_2882_;
                                if (_e1889 > _e1893) {
                                    phi_2887_ = _e1889;
                                } else {
                                    phi_2887_ = _e1893;
                                }
                                let _e1896 = phi_2887_;
                                if (_e1882[2] < 0f) {
                                    phi_2894_ = -(_e1882[2]);
                                } else {
                                    phi_2894_ = _e1882[2];
                                }
                                let _e1900 = phi_2894_;
                                if (_e1896 > _e1900) {
                                    phi_2899_ = _e1896;
                                } else {
                                    phi_2899_ = _e1900;
                                }
                                let _e1903 = phi_2899_;
                                let _e1906 = local_7.member_1[1u];
                                if (_e1906[0] < 0f) {
                                    phi_2913_ = -(_e1906[0]);
                                } else {
                                    phi_2913_ = _e1906[0];
                                }
                                let _e1913 = phi_2913_;
                                if (_e1906[1] < 0f) {
                                    phi_2920_ = -(_e1906[1]);
                                } else {
                                    phi_2920_ = _e1906[1];
                                }
                                let _e1917 = phi_2920_;
                                if (_e1913 > _e1917) {
                                    phi_2925_ = _e1913;
                                } else {
                                    phi_2925_ = _e1917;
                                }
                                let _e1920 = phi_2925_;
                                if (_e1906[2] < 0f) {
                                    phi_2932_ = -(_e1906[2]);
                                } else {
                                    phi_2932_ = _e1906[2];
                                }
                                let _e1924 = phi_2932_;
                                if (_e1920 > _e1924) {
                                    phi_2937_ = _e1920;
                                } else {
                                    phi_2937_ = _e1924;
                                }
                                let _e1927 = phi_2937_;
                                if (_e1903 > _e1927) {
                                    phi_2942_ = _e1903;
                                } else {
                                    phi_2942_ = _e1927;
                                }
                                let _e1930 = phi_2942_;
                                let _e1932 = local_7.member_3;
                                let _e1936 = local_7.member_2[0u];
                                if (_e1936[0] < 0f) {
                                    phi_2959_ = -(_e1936[0]);
                                } else {
                                    phi_2959_ = _e1936[0];
                                }
                                let _e1943 = phi_2959_;
                                if (_e1936[1] < 0f) {
                                    phi_2966_ = -(_e1936[1]);
                                } else {
                                    phi_2966_ = _e1936[1];
                                }
                                let _e1947 = phi_2966_;
                                if (_e1943 > _e1947) {
                                    phi_2971_ = _e1943;
                                } else {
                                    phi_2971_ = _e1947;
                                }
                                let _e1950 = phi_2971_;
                                if (_e1936[2] < 0f) {
                                    phi_2978_ = -(_e1936[2]);
                                } else {
                                    phi_2978_ = _e1936[2];
                                }
                                let _e1954 = phi_2978_;
                                if (_e1950 > _e1954) {
                                    phi_2983_ = _e1950;
                                } else {
                                    phi_2983_ = _e1954;
                                }
                                let _e1957 = phi_2983_;
                                let _e1960 = local_7.member_2[1u];
                                if (_e1960[0] < 0f) {
                                    phi_2997_ = -(_e1960[0]);
                                } else {
                                    phi_2997_ = _e1960[0];
                                }
                                let _e1967 = phi_2997_;
                                if (_e1960[1] < 0f) {
                                    phi_3004_ = -(_e1960[1]);
                                } else {
                                    phi_3004_ = _e1960[1];
                                }
                                let _e1971 = phi_3004_;
                                if (_e1967 > _e1971) {
                                    phi_3009_ = _e1967;
                                } else {
                                    phi_3009_ = _e1971;
                                }
                                let _e1974 = phi_3009_;
                                if (_e1960[2] < 0f) {
                                    phi_3016_ = -(_e1960[2]);
                                } else {
                                    phi_3016_ = _e1960[2];
                                }
                                let _e1978 = phi_3016_;
                                if (_e1974 > _e1978) {
                                    phi_3021_ = _e1974;
                                } else {
                                    phi_3021_ = _e1978;
                                }
                                let _e1981 = phi_3021_;
                                if (_e1957 > _e1981) {
                                    phi_3026_ = _e1957;
                                } else {
                                    phi_3026_ = _e1981;
                                }
                                let _e1984 = phi_3026_;
                                let _e1986 = local_7.member_3;
                                let _e1989 = (((_e1876 + _e1878) + (_e1930 + _e1932)) + (_e1984 + _e1986));
                                let _e1992 = local_7.member_3;
                                let _e1996 = (((_e1212 * 1.0001f) + (_e1992 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e1999 = ((_e1760 * _e1739) - (_e1763 * _e1738));
                                let _e2002 = ((_e1763 * _e1737) - (_e1757 * _e1739));
                                let _e2005 = ((_e1757 * _e1738) - (_e1760 * _e1737));
                                let _e2007 = local_5[0u];
                                let _e2015 = (((_e1999 * _e2007[0]) + (_e2002 * _e2007[1])) + (_e2005 * _e2007[2]));
                                phi_3064_ = type_37(0u, 4u);
                                phi_3067_ = _e2015;
                                phi_3069_ = _e2015;
                                loop {
                                    let _e2017 = phi_3064_;
                                    let _e2019 = phi_3067_;
                                    let _e2021 = phi_3069_;
                                    local_30 = _e2019;
                                    local_31 = _e2021;
                                    local_43 = _e2021;
                                    if (_e2017.member < _e2017.member_1) {
                                        phi_3065_ = type_37((_e2017.member + 1u), _e2017.member_1);
                                        phi_3092_ = type_37(1u, _e2017.member);
                                    } else {
                                        phi_3065_ = _e2017;
                                        phi_3092_ = type_37(0u, type_37().member_1);
                                    }
                                    let _e2035 = phi_3065_;
                                    let _e2037 = phi_3092_;
                                    let _e2041 = (bitcast<i32>(_e2037.member) != 0i);
                                    if _e2041 {
                                        if (_e2037.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2044 = local_5[_e2037.member_1];
                                        let _e2052 = (((_e1999 * _e2044[0]) + (_e2002 * _e2044[1])) + (_e2005 * _e2044[2]));
                                        if (_e2037.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2055 = local_6[_e2037.member_1];
                                        let _e2063 = (((_e1999 * _e2055[0]) + (_e2002 * _e2055[1])) + (_e2005 * _e2055[2]));
                                        if (_e2021 < _e2052) {
                                            phi_3142_ = _e2021;
                                        } else {
                                            phi_3142_ = _e2052;
                                        }
                                        let _e2066 = phi_3142_;
                                        if (_e2066 < _e2063) {
                                            phi_3147_ = _e2066;
                                        } else {
                                            phi_3147_ = _e2063;
                                        }
                                        let _e2069 = phi_3147_;
                                        if (_e2019 > _e2052) {
                                            phi_3152_ = _e2019;
                                        } else {
                                            phi_3152_ = _e2052;
                                        }
                                        let _e2072 = phi_3152_;
                                        if (_e2072 > _e2063) {
                                            phi_3157_ = _e2072;
                                        } else {
                                            phi_3157_ = _e2063;
                                        }
                                        let _e2075 = phi_3157_;
                                        phi_3068_ = _e2075;
                                        phi_3070_ = _e2069;
                                    } else {
                                        phi_3068_ = f32();
                                        phi_3070_ = f32();
                                    }
                                    let _e2077 = phi_3068_;
                                    let _e2079 = phi_3070_;
                                    continue;
                                    continuing {
                                        phi_3064_ = _e2035;
                                        phi_3067_ = _e2077;
                                        phi_3069_ = _e2079;
                                        break if !(_e2041);
                                    }
                                }
                                if (_e1999 < 0f) {
                                    phi_3163_ = -(_e1999);
                                } else {
                                    phi_3163_ = _e1999;
                                }
                                let _e2084 = phi_3163_;
                                if (_e2002 < 0f) {
                                    phi_3169_ = -(_e2002);
                                } else {
                                    phi_3169_ = _e2002;
                                }
                                let _e2088 = phi_3169_;
                                if (_e2005 < 0f) {
                                    phi_3176_ = -(_e2005);
                                } else {
                                    phi_3176_ = _e2005;
                                }
                                let _e2093 = phi_3176_;
                                let _e2094 = ((_e2084 + _e2088) + _e2093);
                                let _e2099 = local_30;
                                let _e2100 = -(_e2099);
                                let _e2102 = local_31;
                                if (_e2102 > _e2100) {
                                    let _e4552 = local_43;
                                    phi_3186_ = _e4552;
                                } else {
                                    phi_3186_ = _e2100;
                                }
                                let _e2105 = phi_3186_;
                                let _e2110 = (((_e2105 - ((_e2094 * _e1989) * (0.000000059604645f * 17f))) - (_e2094 * _e1996)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2113 = ((_e1760 * _e1754) - (_e1763 * _e1753));
                                let _e2116 = ((_e1763 * _e1752) - (_e1757 * _e1754));
                                let _e2119 = ((_e1757 * _e1753) - (_e1760 * _e1752));
                                let _e2121 = local_5[0u];
                                let _e2129 = (((_e2113 * _e2121[0]) + (_e2116 * _e2121[1])) + (_e2119 * _e2121[2]));
                                phi_3217_ = type_37(0u, 4u);
                                phi_3220_ = _e2129;
                                phi_3222_ = _e2129;
                                loop {
                                    let _e2131 = phi_3217_;
                                    let _e2133 = phi_3220_;
                                    let _e2135 = phi_3222_;
                                    local_32 = _e2133;
                                    local_33 = _e2135;
                                    local_44 = _e2135;
                                    if (_e2131.member < _e2131.member_1) {
                                        phi_3218_ = type_37((_e2131.member + 1u), _e2131.member_1);
                                        phi_3245_ = type_37(1u, _e2131.member);
                                    } else {
                                        phi_3218_ = _e2131;
                                        phi_3245_ = type_37(0u, type_37().member_1);
                                    }
                                    let _e2149 = phi_3218_;
                                    let _e2151 = phi_3245_;
                                    let _e2155 = (bitcast<i32>(_e2151.member) != 0i);
                                    if _e2155 {
                                        if (_e2151.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2158 = local_5[_e2151.member_1];
                                        let _e2166 = (((_e2113 * _e2158[0]) + (_e2116 * _e2158[1])) + (_e2119 * _e2158[2]));
                                        if (_e2151.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2169 = local_6[_e2151.member_1];
                                        let _e2177 = (((_e2113 * _e2169[0]) + (_e2116 * _e2169[1])) + (_e2119 * _e2169[2]));
                                        if (_e2135 < _e2166) {
                                            phi_3295_ = _e2135;
                                        } else {
                                            phi_3295_ = _e2166;
                                        }
                                        let _e2180 = phi_3295_;
                                        if (_e2180 < _e2177) {
                                            phi_3300_ = _e2180;
                                        } else {
                                            phi_3300_ = _e2177;
                                        }
                                        let _e2183 = phi_3300_;
                                        if (_e2133 > _e2166) {
                                            phi_3305_ = _e2133;
                                        } else {
                                            phi_3305_ = _e2166;
                                        }
                                        let _e2186 = phi_3305_;
                                        if (_e2186 > _e2177) {
                                            phi_3310_ = _e2186;
                                        } else {
                                            phi_3310_ = _e2177;
                                        }
                                        let _e2189 = phi_3310_;
                                        phi_3221_ = _e2189;
                                        phi_3223_ = _e2183;
                                    } else {
                                        phi_3221_ = f32();
                                        phi_3223_ = f32();
                                    }
                                    let _e2191 = phi_3221_;
                                    let _e2193 = phi_3223_;
                                    continue;
                                    continuing {
                                        phi_3217_ = _e2149;
                                        phi_3220_ = _e2191;
                                        phi_3222_ = _e2193;
                                        break if !(_e2155);
                                    }
                                }
                                if (_e2113 < 0f) {
                                    phi_3316_ = -(_e2113);
                                } else {
                                    phi_3316_ = _e2113;
                                }
                                let _e2198 = phi_3316_;
                                if (_e2116 < 0f) {
                                    phi_3322_ = -(_e2116);
                                } else {
                                    phi_3322_ = _e2116;
                                }
                                let _e2202 = phi_3322_;
                                if (_e2119 < 0f) {
                                    phi_3329_ = -(_e2119);
                                } else {
                                    phi_3329_ = _e2119;
                                }
                                let _e2207 = phi_3329_;
                                let _e2208 = ((_e2198 + _e2202) + _e2207);
                                let _e2213 = local_32;
                                let _e2214 = -(_e2213);
                                let _e2216 = local_33;
                                if (_e2216 > _e2214) {
                                    let _e4571 = local_44;
                                    phi_3339_ = _e4571;
                                } else {
                                    phi_3339_ = _e2214;
                                }
                                let _e2219 = phi_3339_;
                                let _e2224 = (((_e2219 - ((_e2208 * _e1989) * (0.000000059604645f * 17f))) - (_e2208 * _e1996)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2110 > _e2224) {
                                    phi_3349_ = _e2110;
                                } else {
                                    phi_3349_ = _e2224;
                                }
                                let _e2227 = phi_3349_;
                                phi_3517_ = (_e2227 > 0f);
                            }
                            let _e2230 = phi_3517_;
                            if _e2230 {
                                phi_6953_ = false;
                            } else {
                                let _e2233 = local_7.member[0u];
                                let _e2239 = local_7.member[1u];
                                let _e2246 = ((_e2233[0] + _e2239[0]) * 0.5f);
                                let _e2247 = ((_e2233[1] + _e2239[1]) * 0.5f);
                                let _e2248 = ((_e2233[2] + _e2239[2]) * 0.5f);
                                let _e2251 = local_7.member_1[0u];
                                let _e2257 = local_7.member_1[1u];
                                let _e2264 = ((_e2251[0] + _e2257[0]) * 0.5f);
                                let _e2265 = ((_e2251[1] + _e2257[1]) * 0.5f);
                                let _e2266 = ((_e2251[2] + _e2257[2]) * 0.5f);
                                let _e2269 = local_7.member_2[0u];
                                let _e2275 = local_7.member_2[1u];
                                let _e2282 = ((_e2269[0] + _e2275[0]) * 0.5f);
                                let _e2283 = ((_e2269[1] + _e2275[1]) * 0.5f);
                                let _e2284 = ((_e2269[2] + _e2275[2]) * 0.5f);
                                let _e2287 = local_7.member[0u];
                                let _e2290 = local_7.member_1[0u];
                                let _e2293 = local_7.member_2[0u];
                                let _e2295 = local_7.member_3;
                                let _e2298 = local_7.member[1u];
                                let _e2301 = local_7.member_1[1u];
                                let _e2304 = local_7.member_2[1u];
                                let _e2306 = local_7.member_3;
                                local_4 = array<type_72, 2>(type_72(array<array<f32, 3>, 2>(_e2287, array<f32, 3>(_e2246, _e2247, _e2248)), array<array<f32, 3>, 2>(_e2290, array<f32, 3>(_e2264, _e2265, _e2266)), array<array<f32, 3>, 2>(_e2293, array<f32, 3>(_e2282, _e2283, _e2284)), _e2295), type_72(array<array<f32, 3>, 2>(array<f32, 3>(_e2246, _e2247, _e2248), _e2298), array<array<f32, 3>, 2>(array<f32, 3>(_e2264, _e2265, _e2266), _e2301), array<array<f32, 3>, 2>(array<f32, 3>(_e2282, _e2283, _e2284), _e2304), _e2306));
                                let _e2325 = local_4[0u].member_1[0u];
                                let _e2331 = local_4[0u].member_2[0u];
                                let _e2337 = ((_e2325[1] * _e2331[2]) - (_e2325[2] * _e2331[1]));
                                let _e2340 = ((_e2325[2] * _e2331[0]) - (_e2325[0] * _e2331[2]));
                                let _e2343 = ((_e2325[0] * _e2331[1]) - (_e2325[1] * _e2331[0]));
                                let _e2346 = local_4[0u].member_1[1u];
                                let _e2352 = local_4[0u].member_2[1u];
                                let _e2358 = ((_e2346[1] * _e2352[2]) - (_e2346[2] * _e2352[1]));
                                let _e2361 = ((_e2346[2] * _e2352[0]) - (_e2346[0] * _e2352[2]));
                                let _e2364 = ((_e2346[0] * _e2352[1]) - (_e2346[1] * _e2352[0]));
                                let _e2367 = local_4[0u].member_1[0u];
                                let _e2373 = local_4[0u].member_2[1u];
                                let _e2388 = local_4[0u].member_1[1u];
                                let _e2394 = local_4[0u].member_2[0u];
                                let _e2407 = (((_e2367[1] * _e2373[2]) - (_e2367[2] * _e2373[1])) + ((_e2388[1] * _e2394[2]) - (_e2388[2] * _e2394[1])));
                                let _e2408 = (((_e2367[2] * _e2373[0]) - (_e2367[0] * _e2373[2])) + ((_e2388[2] * _e2394[0]) - (_e2388[0] * _e2394[2])));
                                let _e2409 = (((_e2367[0] * _e2373[1]) - (_e2367[1] * _e2373[0])) + ((_e2388[0] * _e2394[1]) - (_e2388[1] * _e2394[0])));
                                let _e2412 = local_4[0u].member[0u];
                                let _e2423 = local_4[0u].member[1u];
                                let _e2434 = local_4[0u].member[0u];
                                let _e2443 = ((((_e2423[0] * _e2337) + (_e2423[1] * _e2340)) + (_e2423[2] * _e2343)) + (((_e2434[0] * _e2407) + (_e2434[1] * _e2408)) + (_e2434[2] * _e2409)));
                                let _e2446 = local_4[0u].member[0u];
                                let _e2457 = local_4[0u].member[1u];
                                let _e2466 = ((((_e2446[0] * _e2358) + (_e2446[1] * _e2361)) + (_e2446[2] * _e2364)) + (((_e2457[0] * _e2407) + (_e2457[1] * _e2408)) + (_e2457[2] * _e2409)));
                                let _e2469 = local_4[0u].member[1u];
                                let _e2480 = local_4[0u].member[0u];
                                if (_e2480[0] < 0f) {
                                    phi_3974_ = -(_e2480[0]);
                                } else {
                                    phi_3974_ = _e2480[0];
                                }
                                let _e2487 = phi_3974_;
                                if (_e2480[1] < 0f) {
                                    phi_3981_ = -(_e2480[1]);
                                } else {
                                    phi_3981_ = _e2480[1];
                                }
                                let _e2491 = phi_3981_;
                                if (_e2487 > _e2491) {
                                    phi_3986_ = _e2487;
                                } else {
                                    phi_3986_ = _e2491;
                                }
                                let _e2494 = phi_3986_;
                                if (_e2480[2] < 0f) {
                                    phi_3993_ = -(_e2480[2]);
                                } else {
                                    phi_3993_ = _e2480[2];
                                }
                                let _e2498 = phi_3993_;
                                if (_e2494 > _e2498) {
                                    phi_3998_ = _e2494;
                                } else {
                                    phi_3998_ = _e2498;
                                }
                                let _e2501 = phi_3998_;
                                let _e2504 = local_4[0u].member[1u];
                                if (_e2504[0] < 0f) {
                                    phi_4011_ = -(_e2504[0]);
                                } else {
                                    phi_4011_ = _e2504[0];
                                }
                                let _e2511 = phi_4011_;
                                if (_e2504[1] < 0f) {
                                    phi_4018_ = -(_e2504[1]);
                                } else {
                                    phi_4018_ = _e2504[1];
                                }
                                let _e2515 = phi_4018_;
                                if (_e2511 > _e2515) {
                                    phi_4023_ = _e2511;
                                } else {
                                    phi_4023_ = _e2515;
                                }
                                let _e2518 = phi_4023_;
                                if (_e2504[2] < 0f) {
                                    phi_4030_ = -(_e2504[2]);
                                } else {
                                    phi_4030_ = _e2504[2];
                                }
                                let _e2522 = phi_4030_;
                                if (_e2518 > _e2522) {
                                    phi_4035_ = _e2518;
                                } else {
                                    phi_4035_ = _e2522;
                                }
                                let _e2525 = phi_4035_;
                                if (_e2501 > _e2525) {
                                    phi_4040_ = _e2501;
                                } else {
                                    phi_4040_ = _e2525;
                                }
                                let _e2528 = phi_4040_;
                                let _e2530 = local_4[0u].member_3;
                                let _e2531 = (_e2528 + _e2530);
                                let _e2534 = local_4[0u].member_1[0u];
                                if (_e2534[0] < 0f) {
                                    phi_4057_ = -(_e2534[0]);
                                } else {
                                    phi_4057_ = _e2534[0];
                                }
                                let _e2541 = phi_4057_;
                                if (_e2534[1] < 0f) {
                                    phi_4064_ = -(_e2534[1]);
                                } else {
                                    phi_4064_ = _e2534[1];
                                }
                                let _e2545 = phi_4064_;
                                if (_e2541 > _e2545) {
                                    phi_4069_ = _e2541;
                                } else {
                                    phi_4069_ = _e2545;
                                }
                                let _e2548 = phi_4069_;
                                if (_e2534[2] < 0f) {
                                    phi_4076_ = -(_e2534[2]);
                                } else {
                                    phi_4076_ = _e2534[2];
                                }
                                let _e2552 = phi_4076_;
                                if (_e2548 > _e2552) {
                                    phi_4081_ = _e2548;
                                } else {
                                    phi_4081_ = _e2552;
                                }
                                let _e2555 = phi_4081_;
                                let _e2558 = local_4[0u].member_1[1u];
                                if (_e2558[0] < 0f) {
                                    phi_4095_ = -(_e2558[0]);
                                } else {
                                    phi_4095_ = _e2558[0];
                                }
                                let _e2565 = phi_4095_;
                                if (_e2558[1] < 0f) {
                                    phi_4102_ = -(_e2558[1]);
                                } else {
                                    phi_4102_ = _e2558[1];
                                }
                                let _e2569 = phi_4102_;
                                if (_e2565 > _e2569) {
                                    phi_4107_ = _e2565;
                                } else {
                                    phi_4107_ = _e2569;
                                }
                                let _e2572 = phi_4107_;
                                if (_e2558[2] < 0f) {
                                    phi_4114_ = -(_e2558[2]);
                                } else {
                                    phi_4114_ = _e2558[2];
                                }
                                let _e2576 = phi_4114_;
                                if (_e2572 > _e2576) {
                                    phi_4119_ = _e2572;
                                } else {
                                    phi_4119_ = _e2576;
                                }
                                let _e2579 = phi_4119_;
                                if (_e2555 > _e2579) {
                                    phi_4124_ = _e2555;
                                } else {
                                    phi_4124_ = _e2579;
                                }
                                let _e2582 = phi_4124_;
                                let _e2584 = local_4[0u].member_3;
                                let _e2585 = (_e2582 + _e2584);
                                let _e2588 = local_4[0u].member_2[0u];
                                if (_e2588[0] < 0f) {
                                    phi_4141_ = -(_e2588[0]);
                                } else {
                                    phi_4141_ = _e2588[0];
                                }
                                let _e2595 = phi_4141_;
                                if (_e2588[1] < 0f) {
                                    phi_4148_ = -(_e2588[1]);
                                } else {
                                    phi_4148_ = _e2588[1];
                                }
                                let _e2599 = phi_4148_;
                                if (_e2595 > _e2599) {
                                    phi_4153_ = _e2595;
                                } else {
                                    phi_4153_ = _e2599;
                                }
                                let _e2602 = phi_4153_;
                                if (_e2588[2] < 0f) {
                                    phi_4160_ = -(_e2588[2]);
                                } else {
                                    phi_4160_ = _e2588[2];
                                }
                                let _e2606 = phi_4160_;
                                if (_e2602 > _e2606) {
                                    phi_4165_ = _e2602;
                                } else {
                                    phi_4165_ = _e2606;
                                }
                                let _e2609 = phi_4165_;
                                let _e2612 = local_4[0u].member_2[1u];
                                if (_e2612[0] < 0f) {
                                    phi_4179_ = -(_e2612[0]);
                                } else {
                                    phi_4179_ = _e2612[0];
                                }
                                let _e2619 = phi_4179_;
                                if (_e2612[1] < 0f) {
                                    phi_4186_ = -(_e2612[1]);
                                } else {
                                    phi_4186_ = _e2612[1];
                                }
                                let _e2623 = phi_4186_;
                                if (_e2619 > _e2623) {
                                    phi_4191_ = _e2619;
                                } else {
                                    phi_4191_ = _e2623;
                                }
                                let _e2626 = phi_4191_;
                                if (_e2612[2] < 0f) {
                                    phi_4198_ = -(_e2612[2]);
                                } else {
                                    phi_4198_ = _e2612[2];
                                }
                                let _e2630 = phi_4198_;
                                if (_e2626 > _e2630) {
                                    phi_4203_ = _e2626;
                                } else {
                                    phi_4203_ = _e2630;
                                }
                                let _e2633 = phi_4203_;
                                if (_e2609 > _e2633) {
                                    phi_4208_ = _e2609;
                                } else {
                                    phi_4208_ = _e2633;
                                }
                                let _e2636 = phi_4208_;
                                let _e2638 = local_4[0u].member_3;
                                let _e2639 = (_e2636 + _e2638);
                                let _e2641 = ((_e2585 * 8f) * _e2639);
                                let _e2648 = local_4[0u].member_3;
                                if (_e2337 < 0f) {
                                    phi_4239_ = -(_e2337);
                                } else {
                                    phi_4239_ = _e2337;
                                }
                                let _e2665 = phi_4239_;
                                if (_e2340 < 0f) {
                                    phi_4245_ = -(_e2340);
                                } else {
                                    phi_4245_ = _e2340;
                                }
                                let _e2669 = phi_4245_;
                                if (_e2343 < 0f) {
                                    phi_4252_ = -(_e2343);
                                } else {
                                    phi_4252_ = _e2343;
                                }
                                let _e2674 = phi_4252_;
                                let _e2675 = ((_e2665 + _e2669) + _e2674);
                                if (_e2358 < 0f) {
                                    phi_4259_ = -(_e2358);
                                } else {
                                    phi_4259_ = _e2358;
                                }
                                let _e2679 = phi_4259_;
                                if (_e2361 < 0f) {
                                    phi_4265_ = -(_e2361);
                                } else {
                                    phi_4265_ = _e2361;
                                }
                                let _e2683 = phi_4265_;
                                if (_e2364 < 0f) {
                                    phi_4272_ = -(_e2364);
                                } else {
                                    phi_4272_ = _e2364;
                                }
                                let _e2688 = phi_4272_;
                                let _e2689 = ((_e2679 + _e2683) + _e2688);
                                if (_e2675 > _e2689) {
                                    phi_4278_ = _e2675;
                                } else {
                                    phi_4278_ = _e2689;
                                }
                                let _e2692 = phi_4278_;
                                if (_e2407 < 0f) {
                                    phi_4284_ = -(_e2407);
                                } else {
                                    phi_4284_ = _e2407;
                                }
                                let _e2696 = phi_4284_;
                                if (_e2408 < 0f) {
                                    phi_4290_ = -(_e2408);
                                } else {
                                    phi_4290_ = _e2408;
                                }
                                let _e2700 = phi_4290_;
                                if (_e2409 < 0f) {
                                    phi_4297_ = -(_e2409);
                                } else {
                                    phi_4297_ = _e2409;
                                }
                                let _e2705 = phi_4297_;
                                let _e2707 = (((_e2696 + _e2700) + _e2705) * 0.5f);
                                if (_e2692 > _e2707) {
                                    phi_4304_ = _e2692;
                                } else {
                                    phi_4304_ = _e2707;
                                }
                                let _e2710 = phi_4304_;
                                let _e2715 = local_4[0u].member_3;
                                let _e2728 = ((((_e2412[0] * _e2337) + (_e2412[1] * _e2340)) + (_e2412[2] * _e2343)) * 3f);
                                let _e2729 = ((((_e2469[0] * _e2358) + (_e2469[1] * _e2361)) + (_e2469[2] * _e2364)) * 3f);
                                if (_e2728 < _e2729) {
                                    phi_4328_ = _e2728;
                                } else {
                                    phi_4328_ = _e2729;
                                }
                                let _e2732 = phi_4328_;
                                if (_e2443 < _e2466) {
                                    phi_4333_ = _e2443;
                                } else {
                                    phi_4333_ = _e2466;
                                }
                                let _e2735 = phi_4333_;
                                if (_e2732 < _e2735) {
                                    phi_4338_ = _e2732;
                                } else {
                                    phi_4338_ = _e2735;
                                }
                                let _e2738 = phi_4338_;
                                if (_e2728 > _e2729) {
                                    phi_4343_ = _e2728;
                                } else {
                                    phi_4343_ = _e2729;
                                }
                                let _e2741 = phi_4343_;
                                if (_e2443 > _e2466) {
                                    phi_4348_ = _e2443;
                                } else {
                                    phi_4348_ = _e2466;
                                }
                                let _e2744 = phi_4348_;
                                if (_e2741 > _e2744) {
                                    phi_4353_ = _e2741;
                                } else {
                                    phi_4353_ = _e2744;
                                }
                                let _e2747 = phi_4353_;
                                let _e2752 = -(_e2747);
                                if (_e2738 > _e2752) {
                                    phi_4363_ = _e2738;
                                } else {
                                    phi_4363_ = _e2752;
                                }
                                let _e2755 = phi_4363_;
                                if ((_e2755 - ((((((_e2531 * 8f) * _e2641) * (0.000000059604645f * (490f / 64f))) + ((_e2648 * 19f) * ((_e2531 * (_e2585 + _e2639)) + (_e2585 * _e2639)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2531) * ((1f + _e2585) * (1f + _e2639))))) + ((_e1212 * (((_e2710 + (_e2641 * (0.000000059604645f * 4f))) + ((_e2715 * 6f) * (_e2585 + _e2639))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2585) * (1f + _e2639))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_5339_ = true;
                                } else {
                                    let _e2760 = local_4[0u].member_1[0u];
                                    let _e2766 = local_4[0u].member_1[1u];
                                    let _e2770 = (_e2760[0] + _e2766[0]);
                                    let _e2771 = (_e2760[1] + _e2766[1]);
                                    let _e2772 = (_e2760[2] + _e2766[2]);
                                    let _e2775 = local_4[0u].member_2[0u];
                                    let _e2781 = local_4[0u].member_2[1u];
                                    let _e2785 = (_e2775[0] + _e2781[0]);
                                    let _e2786 = (_e2775[1] + _e2781[1]);
                                    let _e2787 = (_e2775[2] + _e2781[2]);
                                    let _e2790 = ((_e2771 * _e2787) - (_e2772 * _e2786));
                                    let _e2793 = ((_e2772 * _e2785) - (_e2770 * _e2787));
                                    let _e2796 = ((_e2770 * _e2786) - (_e2771 * _e2785));
                                    let _e2799 = local_4[0u].member[0u];
                                    let _e2805 = local_4[0u].member_1[0u];
                                    let _e2811 = local_4[0u].member_2[0u];
                                    let _e2815 = (_e2799[0] - _e2805[0]);
                                    let _e2816 = (_e2799[1] - _e2805[1]);
                                    let _e2817 = (_e2799[2] - _e2805[2]);
                                    let _e2826 = local_4[0u].member[1u];
                                    let _e2832 = local_4[0u].member_1[1u];
                                    let _e2838 = local_4[0u].member_2[1u];
                                    let _e2842 = (_e2826[0] - _e2832[0]);
                                    let _e2843 = (_e2826[1] - _e2832[1]);
                                    let _e2844 = (_e2826[2] - _e2832[2]);
                                    local_2 = array<array<f32, 3>, 4>(_e2799, array<f32, 3>(_e2815, _e2816, _e2817), array<f32, 3>((_e2799[0] - _e2811[0]), (_e2799[1] - _e2811[1]), (_e2799[2] - _e2811[2])), array<f32, 3>((_e2815 - _e2811[0]), (_e2816 - _e2811[1]), (_e2817 - _e2811[2])));
                                    local_3 = array<array<f32, 3>, 4>(_e2826, array<f32, 3>(_e2842, _e2843, _e2844), array<f32, 3>((_e2826[0] - _e2838[0]), (_e2826[1] - _e2838[1]), (_e2826[2] - _e2838[2])), array<f32, 3>((_e2842 - _e2838[0]), (_e2843 - _e2838[1]), (_e2844 - _e2838[2])));
                                    let _e2861 = local_4[0u].member[0u];
                                    if (_e2861[0] < 0f) {
                                        phi_4614_ = -(_e2861[0]);
                                    } else {
                                        phi_4614_ = _e2861[0];
                                    }
                                    let _e2868 = phi_4614_;
                                    if (_e2861[1] < 0f) {
                                        phi_4621_ = -(_e2861[1]);
                                    } else {
                                        phi_4621_ = _e2861[1];
                                    }
                                    let _e2872 = phi_4621_;
                                    if (_e2868 > _e2872) {
                                        phi_4626_ = _e2868;
                                    } else {
                                        phi_4626_ = _e2872;
                                    }
                                    let _e2875 = phi_4626_;
                                    if (_e2861[2] < 0f) {
                                        phi_4633_ = -(_e2861[2]);
                                    } else {
                                        phi_4633_ = _e2861[2];
                                    }
                                    let _e2879 = phi_4633_;
                                    if (_e2875 > _e2879) {
                                        phi_4638_ = _e2875;
                                    } else {
                                        phi_4638_ = _e2879;
                                    }
                                    let _e2882 = phi_4638_;
                                    let _e2885 = local_4[0u].member[1u];
                                    if (_e2885[0] < 0f) {
                                        phi_4651_ = -(_e2885[0]);
                                    } else {
                                        phi_4651_ = _e2885[0];
                                    }
                                    let _e2892 = phi_4651_;
                                    if (_e2885[1] < 0f) {
                                        phi_4658_ = -(_e2885[1]);
                                    } else {
                                        phi_4658_ = _e2885[1];
                                    }
                                    let _e2896 = phi_4658_;
                                    if (_e2892 > _e2896) {
                                        phi_4663_ = _e2892;
                                    } else {
                                        phi_4663_ = _e2896;
                                    }
                                    let _e2899 = phi_4663_;
                                    if (_e2885[2] < 0f) {
                                        phi_4670_ = -(_e2885[2]);
                                    } else {
                                        phi_4670_ = _e2885[2];
                                    }
                                    let _e2903 = phi_4670_;
                                    if (_e2899 > _e2903) {
                                        phi_4675_ = _e2899;
                                    } else {
                                        phi_4675_ = _e2903;
                                    }
                                    let _e2906 = phi_4675_;
                                    if (_e2882 > _e2906) {
                                        phi_4680_ = _e2882;
                                    } else {
                                        phi_4680_ = _e2906;
                                    }
                                    let _e2909 = phi_4680_;
                                    let _e2911 = local_4[0u].member_3;
                                    let _e2915 = local_4[0u].member_1[0u];
                                    if (_e2915[0] < 0f) {
                                        phi_4697_ = -(_e2915[0]);
                                    } else {
                                        phi_4697_ = _e2915[0];
                                    }
                                    let _e2922 = phi_4697_;
                                    if (_e2915[1] < 0f) {
                                        phi_4704_ = -(_e2915[1]);
                                    } else {
                                        phi_4704_ = _e2915[1];
                                    }
                                    let _e2926 = phi_4704_;
                                    if (_e2922 > _e2926) {
                                        phi_4709_ = _e2922;
                                    } else {
                                        phi_4709_ = _e2926;
                                    }
                                    let _e2929 = phi_4709_;
                                    if (_e2915[2] < 0f) {
                                        phi_4716_ = -(_e2915[2]);
                                    } else {
                                        phi_4716_ = _e2915[2];
                                    }
                                    let _e2933 = phi_4716_;
                                    if (_e2929 > _e2933) {
                                        phi_4721_ = _e2929;
                                    } else {
                                        phi_4721_ = _e2933;
                                    }
                                    let _e2936 = phi_4721_;
                                    let _e2939 = local_4[0u].member_1[1u];
                                    if (_e2939[0] < 0f) {
                                        phi_4735_ = -(_e2939[0]);
                                    } else {
                                        phi_4735_ = _e2939[0];
                                    }
                                    let _e2946 = phi_4735_;
                                    if (_e2939[1] < 0f) {
                                        phi_4742_ = -(_e2939[1]);
                                    } else {
                                        phi_4742_ = _e2939[1];
                                    }
                                    let _e2950 = phi_4742_;
                                    if (_e2946 > _e2950) {
                                        phi_4747_ = _e2946;
                                    } else {
                                        phi_4747_ = _e2950;
                                    }
                                    let _e2953 = phi_4747_;
                                    if (_e2939[2] < 0f) {
                                        phi_4754_ = -(_e2939[2]);
                                    } else {
                                        phi_4754_ = _e2939[2];
                                    }
                                    let _e2957 = phi_4754_;
                                    if (_e2953 > _e2957) {
                                        phi_4759_ = _e2953;
                                    } else {
                                        phi_4759_ = _e2957;
                                    }
                                    let _e2960 = phi_4759_;
                                    if (_e2936 > _e2960) {
                                        phi_4764_ = _e2936;
                                    } else {
                                        phi_4764_ = _e2960;
                                    }
                                    let _e2963 = phi_4764_;
                                    let _e2965 = local_4[0u].member_3;
                                    let _e2969 = local_4[0u].member_2[0u];
                                    if (_e2969[0] < 0f) {
                                        phi_4781_ = -(_e2969[0]);
                                    } else {
                                        phi_4781_ = _e2969[0];
                                    }
                                    let _e2976 = phi_4781_;
                                    if (_e2969[1] < 0f) {
                                        phi_4788_ = -(_e2969[1]);
                                    } else {
                                        phi_4788_ = _e2969[1];
                                    }
                                    let _e2980 = phi_4788_;
                                    if (_e2976 > _e2980) {
                                        phi_4793_ = _e2976;
                                    } else {
                                        phi_4793_ = _e2980;
                                    }
                                    let _e2983 = phi_4793_;
                                    if (_e2969[2] < 0f) {
                                        phi_4800_ = -(_e2969[2]);
                                    } else {
                                        phi_4800_ = _e2969[2];
                                    }
                                    let _e2987 = phi_4800_;
                                    if (_e2983 > _e2987) {
                                        phi_4805_ = _e2983;
                                    } else {
                                        phi_4805_ = _e2987;
                                    }
                                    let _e2990 = phi_4805_;
                                    let _e2993 = local_4[0u].member_2[1u];
                                    if (_e2993[0] < 0f) {
                                        phi_4819_ = -(_e2993[0]);
                                    } else {
                                        phi_4819_ = _e2993[0];
                                    }
                                    let _e3000 = phi_4819_;
                                    if (_e2993[1] < 0f) {
                                        phi_4826_ = -(_e2993[1]);
                                    } else {
                                        phi_4826_ = _e2993[1];
                                    }
                                    let _e3004 = phi_4826_;
                                    if (_e3000 > _e3004) {
                                        phi_4831_ = _e3000;
                                    } else {
                                        phi_4831_ = _e3004;
                                    }
                                    let _e3007 = phi_4831_;
                                    if (_e2993[2] < 0f) {
                                        phi_4838_ = -(_e2993[2]);
                                    } else {
                                        phi_4838_ = _e2993[2];
                                    }
                                    let _e3011 = phi_4838_;
                                    if (_e3007 > _e3011) {
                                        phi_4843_ = _e3007;
                                    } else {
                                        phi_4843_ = _e3011;
                                    }
                                    let _e3014 = phi_4843_;
                                    if (_e2990 > _e3014) {
                                        phi_4848_ = _e2990;
                                    } else {
                                        phi_4848_ = _e3014;
                                    }
                                    let _e3017 = phi_4848_;
                                    let _e3019 = local_4[0u].member_3;
                                    let _e3022 = (((_e2909 + _e2911) + (_e2963 + _e2965)) + (_e3017 + _e3019));
                                    let _e3025 = local_4[0u].member_3;
                                    let _e3029 = (((_e1212 * 1.0001f) + (_e3025 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3032 = ((_e2793 * _e2772) - (_e2796 * _e2771));
                                    let _e3035 = ((_e2796 * _e2770) - (_e2790 * _e2772));
                                    let _e3038 = ((_e2790 * _e2771) - (_e2793 * _e2770));
                                    let _e3040 = local_2[0u];
                                    let _e3048 = (((_e3032 * _e3040[0]) + (_e3035 * _e3040[1])) + (_e3038 * _e3040[2]));
                                    phi_4886_ = type_37(0u, 4u);
                                    phi_4889_ = _e3048;
                                    phi_4891_ = _e3048;
                                    loop {
                                        let _e3050 = phi_4886_;
                                        let _e3052 = phi_4889_;
                                        let _e3054 = phi_4891_;
                                        local_34 = _e3052;
                                        local_35 = _e3054;
                                        local_45 = _e3054;
                                        if (_e3050.member < _e3050.member_1) {
                                            phi_4887_ = type_37((_e3050.member + 1u), _e3050.member_1);
                                            phi_4914_ = type_37(1u, _e3050.member);
                                        } else {
                                            phi_4887_ = _e3050;
                                            phi_4914_ = type_37(0u, type_37().member_1);
                                        }
                                        let _e3068 = phi_4887_;
                                        let _e3070 = phi_4914_;
                                        let _e3074 = (bitcast<i32>(_e3070.member) != 0i);
                                        if _e3074 {
                                            if (_e3070.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3077 = local_2[_e3070.member_1];
                                            let _e3085 = (((_e3032 * _e3077[0]) + (_e3035 * _e3077[1])) + (_e3038 * _e3077[2]));
                                            if (_e3070.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3088 = local_3[_e3070.member_1];
                                            let _e3096 = (((_e3032 * _e3088[0]) + (_e3035 * _e3088[1])) + (_e3038 * _e3088[2]));
                                            if (_e3054 < _e3085) {
                                                phi_4964_ = _e3054;
                                            } else {
                                                phi_4964_ = _e3085;
                                            }
                                            let _e3099 = phi_4964_;
                                            if (_e3099 < _e3096) {
                                                phi_4969_ = _e3099;
                                            } else {
                                                phi_4969_ = _e3096;
                                            }
                                            let _e3102 = phi_4969_;
                                            if (_e3052 > _e3085) {
                                                phi_4974_ = _e3052;
                                            } else {
                                                phi_4974_ = _e3085;
                                            }
                                            let _e3105 = phi_4974_;
                                            if (_e3105 > _e3096) {
                                                phi_4979_ = _e3105;
                                            } else {
                                                phi_4979_ = _e3096;
                                            }
                                            let _e3108 = phi_4979_;
                                            phi_4890_ = _e3108;
                                            phi_4892_ = _e3102;
                                        } else {
                                            phi_4890_ = f32();
                                            phi_4892_ = f32();
                                        }
                                        let _e3110 = phi_4890_;
                                        let _e3112 = phi_4892_;
                                        continue;
                                        continuing {
                                            phi_4886_ = _e3068;
                                            phi_4889_ = _e3110;
                                            phi_4891_ = _e3112;
                                            break if !(_e3074);
                                        }
                                    }
                                    if (_e3032 < 0f) {
                                        phi_4985_ = -(_e3032);
                                    } else {
                                        phi_4985_ = _e3032;
                                    }
                                    let _e3117 = phi_4985_;
                                    if (_e3035 < 0f) {
                                        phi_4991_ = -(_e3035);
                                    } else {
                                        phi_4991_ = _e3035;
                                    }
                                    let _e3121 = phi_4991_;
                                    if (_e3038 < 0f) {
                                        phi_4998_ = -(_e3038);
                                    } else {
                                        phi_4998_ = _e3038;
                                    }
                                    let _e3126 = phi_4998_;
                                    let _e3127 = ((_e3117 + _e3121) + _e3126);
                                    let _e3132 = local_34;
                                    let _e3133 = -(_e3132);
                                    let _e3135 = local_35;
                                    if (_e3135 > _e3133) {
                                        let _e4676 = local_45;
                                        phi_5008_ = _e4676;
                                    } else {
                                        phi_5008_ = _e3133;
                                    }
                                    let _e3138 = phi_5008_;
                                    let _e3143 = (((_e3138 - ((_e3127 * _e3022) * (0.000000059604645f * 17f))) - (_e3127 * _e3029)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3146 = ((_e2793 * _e2787) - (_e2796 * _e2786));
                                    let _e3149 = ((_e2796 * _e2785) - (_e2790 * _e2787));
                                    let _e3152 = ((_e2790 * _e2786) - (_e2793 * _e2785));
                                    let _e3154 = local_2[0u];
                                    let _e3162 = (((_e3146 * _e3154[0]) + (_e3149 * _e3154[1])) + (_e3152 * _e3154[2]));
                                    phi_5039_ = type_37(0u, 4u);
                                    phi_5042_ = _e3162;
                                    phi_5044_ = _e3162;
                                    loop {
                                        let _e3164 = phi_5039_;
                                        let _e3166 = phi_5042_;
                                        let _e3168 = phi_5044_;
                                        local_36 = _e3166;
                                        local_37 = _e3168;
                                        local_46 = _e3168;
                                        if (_e3164.member < _e3164.member_1) {
                                            phi_5040_ = type_37((_e3164.member + 1u), _e3164.member_1);
                                            phi_5067_ = type_37(1u, _e3164.member);
                                        } else {
                                            phi_5040_ = _e3164;
                                            phi_5067_ = type_37(0u, type_37().member_1);
                                        }
                                        let _e3182 = phi_5040_;
                                        let _e3184 = phi_5067_;
                                        let _e3188 = (bitcast<i32>(_e3184.member) != 0i);
                                        if _e3188 {
                                            if (_e3184.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3191 = local_2[_e3184.member_1];
                                            let _e3199 = (((_e3146 * _e3191[0]) + (_e3149 * _e3191[1])) + (_e3152 * _e3191[2]));
                                            if (_e3184.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3202 = local_3[_e3184.member_1];
                                            let _e3210 = (((_e3146 * _e3202[0]) + (_e3149 * _e3202[1])) + (_e3152 * _e3202[2]));
                                            if (_e3168 < _e3199) {
                                                phi_5117_ = _e3168;
                                            } else {
                                                phi_5117_ = _e3199;
                                            }
                                            let _e3213 = phi_5117_;
                                            if (_e3213 < _e3210) {
                                                phi_5122_ = _e3213;
                                            } else {
                                                phi_5122_ = _e3210;
                                            }
                                            let _e3216 = phi_5122_;
                                            if (_e3166 > _e3199) {
                                                phi_5127_ = _e3166;
                                            } else {
                                                phi_5127_ = _e3199;
                                            }
                                            let _e3219 = phi_5127_;
                                            if (_e3219 > _e3210) {
                                                phi_5132_ = _e3219;
                                            } else {
                                                phi_5132_ = _e3210;
                                            }
                                            let _e3222 = phi_5132_;
                                            phi_5043_ = _e3222;
                                            phi_5045_ = _e3216;
                                        } else {
                                            phi_5043_ = f32();
                                            phi_5045_ = f32();
                                        }
                                        let _e3224 = phi_5043_;
                                        let _e3226 = phi_5045_;
                                        continue;
                                        continuing {
                                            phi_5039_ = _e3182;
                                            phi_5042_ = _e3224;
                                            phi_5044_ = _e3226;
                                            break if !(_e3188);
                                        }
                                    }
                                    if (_e3146 < 0f) {
                                        phi_5138_ = -(_e3146);
                                    } else {
                                        phi_5138_ = _e3146;
                                    }
                                    let _e3231 = phi_5138_;
                                    if (_e3149 < 0f) {
                                        phi_5144_ = -(_e3149);
                                    } else {
                                        phi_5144_ = _e3149;
                                    }
                                    let _e3235 = phi_5144_;
                                    if (_e3152 < 0f) {
                                        phi_5151_ = -(_e3152);
                                    } else {
                                        phi_5151_ = _e3152;
                                    }
                                    let _e3240 = phi_5151_;
                                    let _e3241 = ((_e3231 + _e3235) + _e3240);
                                    let _e3246 = local_36;
                                    let _e3247 = -(_e3246);
                                    let _e3249 = local_37;
                                    if (_e3249 > _e3247) {
                                        let _e4695 = local_46;
                                        phi_5161_ = _e4695;
                                    } else {
                                        phi_5161_ = _e3247;
                                    }
                                    let _e3252 = phi_5161_;
                                    let _e3257 = (((_e3252 - ((_e3241 * _e3022) * (0.000000059604645f * 17f))) - (_e3241 * _e3029)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3143 > _e3257) {
                                        phi_5171_ = _e3143;
                                    } else {
                                        phi_5171_ = _e3257;
                                    }
                                    let _e3260 = phi_5171_;
                                    phi_5339_ = (_e3260 > 0f);
                                }
                                let _e3263 = phi_5339_;
                                if _e3263 {
                                    let _e3267 = local_4[1u].member_1[0u];
                                    let _e3273 = local_4[1u].member_2[0u];
                                    let _e3279 = ((_e3267[1] * _e3273[2]) - (_e3267[2] * _e3273[1]));
                                    let _e3282 = ((_e3267[2] * _e3273[0]) - (_e3267[0] * _e3273[2]));
                                    let _e3285 = ((_e3267[0] * _e3273[1]) - (_e3267[1] * _e3273[0]));
                                    let _e3288 = local_4[1u].member_1[1u];
                                    let _e3294 = local_4[1u].member_2[1u];
                                    let _e3300 = ((_e3288[1] * _e3294[2]) - (_e3288[2] * _e3294[1]));
                                    let _e3303 = ((_e3288[2] * _e3294[0]) - (_e3288[0] * _e3294[2]));
                                    let _e3306 = ((_e3288[0] * _e3294[1]) - (_e3288[1] * _e3294[0]));
                                    let _e3309 = local_4[1u].member_1[0u];
                                    let _e3315 = local_4[1u].member_2[1u];
                                    let _e3330 = local_4[1u].member_1[1u];
                                    let _e3336 = local_4[1u].member_2[0u];
                                    let _e3349 = (((_e3309[1] * _e3315[2]) - (_e3309[2] * _e3315[1])) + ((_e3330[1] * _e3336[2]) - (_e3330[2] * _e3336[1])));
                                    let _e3350 = (((_e3309[2] * _e3315[0]) - (_e3309[0] * _e3315[2])) + ((_e3330[2] * _e3336[0]) - (_e3330[0] * _e3336[2])));
                                    let _e3351 = (((_e3309[0] * _e3315[1]) - (_e3309[1] * _e3315[0])) + ((_e3330[0] * _e3336[1]) - (_e3330[1] * _e3336[0])));
                                    let _e3354 = local_4[1u].member[0u];
                                    let _e3365 = local_4[1u].member[1u];
                                    let _e3376 = local_4[1u].member[0u];
                                    let _e3385 = ((((_e3365[0] * _e3279) + (_e3365[1] * _e3282)) + (_e3365[2] * _e3285)) + (((_e3376[0] * _e3349) + (_e3376[1] * _e3350)) + (_e3376[2] * _e3351)));
                                    let _e3388 = local_4[1u].member[0u];
                                    let _e3399 = local_4[1u].member[1u];
                                    let _e3408 = ((((_e3388[0] * _e3300) + (_e3388[1] * _e3303)) + (_e3388[2] * _e3306)) + (((_e3399[0] * _e3349) + (_e3399[1] * _e3350)) + (_e3399[2] * _e3351)));
                                    let _e3411 = local_4[1u].member[1u];
                                    let _e3422 = local_4[1u].member[0u];
                                    if (_e3422[0] < 0f) {
                                        phi_5585_ = -(_e3422[0]);
                                    } else {
                                        phi_5585_ = _e3422[0];
                                    }
                                    let _e3429 = phi_5585_;
                                    if (_e3422[1] < 0f) {
                                        phi_5592_ = -(_e3422[1]);
                                    } else {
                                        phi_5592_ = _e3422[1];
                                    }
                                    let _e3433 = phi_5592_;
                                    if (_e3429 > _e3433) {
                                        phi_5597_ = _e3429;
                                    } else {
                                        phi_5597_ = _e3433;
                                    }
                                    let _e3436 = phi_5597_;
                                    if (_e3422[2] < 0f) {
                                        phi_5604_ = -(_e3422[2]);
                                    } else {
                                        phi_5604_ = _e3422[2];
                                    }
                                    let _e3440 = phi_5604_;
                                    if (_e3436 > _e3440) {
                                        phi_5609_ = _e3436;
                                    } else {
                                        phi_5609_ = _e3440;
                                    }
                                    let _e3443 = phi_5609_;
                                    let _e3446 = local_4[1u].member[1u];
                                    if (_e3446[0] < 0f) {
                                        phi_5622_ = -(_e3446[0]);
                                    } else {
                                        phi_5622_ = _e3446[0];
                                    }
                                    let _e3453 = phi_5622_;
                                    if (_e3446[1] < 0f) {
                                        phi_5629_ = -(_e3446[1]);
                                    } else {
                                        phi_5629_ = _e3446[1];
                                    }
                                    let _e3457 = phi_5629_;
                                    if (_e3453 > _e3457) {
                                        phi_5634_ = _e3453;
                                    } else {
                                        phi_5634_ = _e3457;
                                    }
                                    let _e3460 = phi_5634_;
                                    if (_e3446[2] < 0f) {
                                        phi_5641_ = -(_e3446[2]);
                                    } else {
                                        phi_5641_ = _e3446[2];
                                    }
                                    let _e3464 = phi_5641_;
                                    if (_e3460 > _e3464) {
                                        phi_5646_ = _e3460;
                                    } else {
                                        phi_5646_ = _e3464;
                                    }
                                    let _e3467 = phi_5646_;
                                    if (_e3443 > _e3467) {
                                        phi_5651_ = _e3443;
                                    } else {
                                        phi_5651_ = _e3467;
                                    }
                                    let _e3470 = phi_5651_;
                                    let _e3472 = local_4[1u].member_3;
                                    let _e3473 = (_e3470 + _e3472);
                                    let _e3476 = local_4[1u].member_1[0u];
                                    if (_e3476[0] < 0f) {
                                        phi_5668_ = -(_e3476[0]);
                                    } else {
                                        phi_5668_ = _e3476[0];
                                    }
                                    let _e3483 = phi_5668_;
                                    if (_e3476[1] < 0f) {
                                        phi_5675_ = -(_e3476[1]);
                                    } else {
                                        phi_5675_ = _e3476[1];
                                    }
                                    let _e3487 = phi_5675_;
                                    if (_e3483 > _e3487) {
                                        phi_5680_ = _e3483;
                                    } else {
                                        phi_5680_ = _e3487;
                                    }
                                    let _e3490 = phi_5680_;
                                    if (_e3476[2] < 0f) {
                                        phi_5687_ = -(_e3476[2]);
                                    } else {
                                        phi_5687_ = _e3476[2];
                                    }
                                    let _e3494 = phi_5687_;
                                    if (_e3490 > _e3494) {
                                        phi_5692_ = _e3490;
                                    } else {
                                        phi_5692_ = _e3494;
                                    }
                                    let _e3497 = phi_5692_;
                                    let _e3500 = local_4[1u].member_1[1u];
                                    if (_e3500[0] < 0f) {
                                        phi_5706_ = -(_e3500[0]);
                                    } else {
                                        phi_5706_ = _e3500[0];
                                    }
                                    let _e3507 = phi_5706_;
                                    if (_e3500[1] < 0f) {
                                        phi_5713_ = -(_e3500[1]);
                                    } else {
                                        phi_5713_ = _e3500[1];
                                    }
                                    let _e3511 = phi_5713_;
                                    if (_e3507 > _e3511) {
                                        phi_5718_ = _e3507;
                                    } else {
                                        phi_5718_ = _e3511;
                                    }
                                    let _e3514 = phi_5718_;
                                    if (_e3500[2] < 0f) {
                                        phi_5725_ = -(_e3500[2]);
                                    } else {
                                        phi_5725_ = _e3500[2];
                                    }
                                    let _e3518 = phi_5725_;
                                    if (_e3514 > _e3518) {
                                        phi_5730_ = _e3514;
                                    } else {
                                        phi_5730_ = _e3518;
                                    }
                                    let _e3521 = phi_5730_;
                                    if (_e3497 > _e3521) {
                                        phi_5735_ = _e3497;
                                    } else {
                                        phi_5735_ = _e3521;
                                    }
                                    let _e3524 = phi_5735_;
                                    let _e3526 = local_4[1u].member_3;
                                    let _e3527 = (_e3524 + _e3526);
                                    let _e3530 = local_4[1u].member_2[0u];
                                    if (_e3530[0] < 0f) {
                                        phi_5752_ = -(_e3530[0]);
                                    } else {
                                        phi_5752_ = _e3530[0];
                                    }
                                    let _e3537 = phi_5752_;
                                    if (_e3530[1] < 0f) {
                                        phi_5759_ = -(_e3530[1]);
                                    } else {
                                        phi_5759_ = _e3530[1];
                                    }
                                    let _e3541 = phi_5759_;
                                    if (_e3537 > _e3541) {
                                        phi_5764_ = _e3537;
                                    } else {
                                        phi_5764_ = _e3541;
                                    }
                                    let _e3544 = phi_5764_;
                                    if (_e3530[2] < 0f) {
                                        phi_5771_ = -(_e3530[2]);
                                    } else {
                                        phi_5771_ = _e3530[2];
                                    }
                                    let _e3548 = phi_5771_;
                                    if (_e3544 > _e3548) {
                                        phi_5776_ = _e3544;
                                    } else {
                                        phi_5776_ = _e3548;
                                    }
                                    let _e3551 = phi_5776_;
                                    let _e3554 = local_4[1u].member_2[1u];
                                    if (_e3554[0] < 0f) {
                                        phi_5790_ = -(_e3554[0]);
                                    } else {
                                        phi_5790_ = _e3554[0];
                                    }
                                    let _e3561 = phi_5790_;
                                    if (_e3554[1] < 0f) {
                                        phi_5797_ = -(_e3554[1]);
                                    } else {
                                        phi_5797_ = _e3554[1];
                                    }
                                    let _e3565 = phi_5797_;
                                    if (_e3561 > _e3565) {
                                        phi_5802_ = _e3561;
                                    } else {
                                        phi_5802_ = _e3565;
                                    }
                                    let _e3568 = phi_5802_;
                                    if (_e3554[2] < 0f) {
                                        phi_5809_ = -(_e3554[2]);
                                    } else {
                                        phi_5809_ = _e3554[2];
                                    }
                                    let _e3572 = phi_5809_;
                                    if (_e3568 > _e3572) {
                                        phi_5814_ = _e3568;
                                    } else {
                                        phi_5814_ = _e3572;
                                    }
                                    let _e3575 = phi_5814_;
                                    if (_e3551 > _e3575) {
                                        phi_5819_ = _e3551;
                                    } else {
                                        phi_5819_ = _e3575;
                                    }
                                    let _e3578 = phi_5819_;
                                    let _e3580 = local_4[1u].member_3;
                                    let _e3581 = (_e3578 + _e3580);
                                    let _e3583 = ((_e3527 * 8f) * _e3581);
                                    let _e3590 = local_4[1u].member_3;
                                    if (_e3279 < 0f) {
                                        phi_5850_ = -(_e3279);
                                    } else {
                                        phi_5850_ = _e3279;
                                    }
                                    let _e3607 = phi_5850_;
                                    if (_e3282 < 0f) {
                                        phi_5856_ = -(_e3282);
                                    } else {
                                        phi_5856_ = _e3282;
                                    }
                                    let _e3611 = phi_5856_;
                                    if (_e3285 < 0f) {
                                        phi_5863_ = -(_e3285);
                                    } else {
                                        phi_5863_ = _e3285;
                                    }
                                    let _e3616 = phi_5863_;
                                    let _e3617 = ((_e3607 + _e3611) + _e3616);
                                    if (_e3300 < 0f) {
                                        phi_5870_ = -(_e3300);
                                    } else {
                                        phi_5870_ = _e3300;
                                    }
                                    let _e3621 = phi_5870_;
                                    if (_e3303 < 0f) {
                                        phi_5876_ = -(_e3303);
                                    } else {
                                        phi_5876_ = _e3303;
                                    }
                                    let _e3625 = phi_5876_;
                                    if (_e3306 < 0f) {
                                        phi_5883_ = -(_e3306);
                                    } else {
                                        phi_5883_ = _e3306;
                                    }
                                    let _e3630 = phi_5883_;
                                    let _e3631 = ((_e3621 + _e3625) + _e3630);
                                    if (_e3617 > _e3631) {
                                        phi_5889_ = _e3617;
                                    } else {
                                        phi_5889_ = _e3631;
                                    }
                                    let _e3634 = phi_5889_;
                                    if (_e3349 < 0f) {
                                        phi_5895_ = -(_e3349);
                                    } else {
                                        phi_5895_ = _e3349;
                                    }
                                    let _e3638 = phi_5895_;
                                    if (_e3350 < 0f) {
                                        phi_5901_ = -(_e3350);
                                    } else {
                                        phi_5901_ = _e3350;
                                    }
                                    let _e3642 = phi_5901_;
                                    if (_e3351 < 0f) {
                                        phi_5908_ = -(_e3351);
                                    } else {
                                        phi_5908_ = _e3351;
                                    }
                                    let _e3647 = phi_5908_;
                                    let _e3649 = (((_e3638 + _e3642) + _e3647) * 0.5f);
                                    if (_e3634 > _e3649) {
                                        phi_5915_ = _e3634;
                                    } else {
                                        phi_5915_ = _e3649;
                                    }
                                    let _e3652 = phi_5915_;
                                    let _e3657 = local_4[1u].member_3;
                                    let _e3670 = ((((_e3354[0] * _e3279) + (_e3354[1] * _e3282)) + (_e3354[2] * _e3285)) * 3f);
                                    let _e3671 = ((((_e3411[0] * _e3300) + (_e3411[1] * _e3303)) + (_e3411[2] * _e3306)) * 3f);
                                    if (_e3670 < _e3671) {
                                        phi_5939_ = _e3670;
                                    } else {
                                        phi_5939_ = _e3671;
                                    }
                                    let _e3674 = phi_5939_;
                                    if (_e3385 < _e3408) {
                                        phi_5944_ = _e3385;
                                    } else {
                                        phi_5944_ = _e3408;
                                    }
                                    let _e3677 = phi_5944_;
                                    if (_e3674 < _e3677) {
                                        phi_5949_ = _e3674;
                                    } else {
                                        phi_5949_ = _e3677;
                                    }
                                    let _e3680 = phi_5949_;
                                    if (_e3670 > _e3671) {
                                        phi_5954_ = _e3670;
                                    } else {
                                        phi_5954_ = _e3671;
                                    }
                                    let _e3683 = phi_5954_;
                                    if (_e3385 > _e3408) {
                                        phi_5959_ = _e3385;
                                    } else {
                                        phi_5959_ = _e3408;
                                    }
                                    let _e3686 = phi_5959_;
                                    if (_e3683 > _e3686) {
                                        phi_5964_ = _e3683;
                                    } else {
                                        phi_5964_ = _e3686;
                                    }
                                    let _e3689 = phi_5964_;
                                    let _e3694 = -(_e3689);
                                    if (_e3680 > _e3694) {
                                        phi_5974_ = _e3680;
                                    } else {
                                        phi_5974_ = _e3694;
                                    }
                                    let _e3697 = phi_5974_;
                                    if ((_e3697 - ((((((_e3473 * 8f) * _e3583) * (0.000000059604645f * (490f / 64f))) + ((_e3590 * 19f) * ((_e3473 * (_e3527 + _e3581)) + (_e3527 * _e3581)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3473) * ((1f + _e3527) * (1f + _e3581))))) + ((_e1212 * (((_e3652 + (_e3583 * (0.000000059604645f * 4f))) + ((_e3657 * 6f) * (_e3527 + _e3581))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3527) * (1f + _e3581))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_6950_ = true;
                                    } else {
                                        let _e3702 = local_4[1u].member_1[0u];
                                        let _e3708 = local_4[1u].member_1[1u];
                                        let _e3712 = (_e3702[0] + _e3708[0]);
                                        let _e3713 = (_e3702[1] + _e3708[1]);
                                        let _e3714 = (_e3702[2] + _e3708[2]);
                                        let _e3717 = local_4[1u].member_2[0u];
                                        let _e3723 = local_4[1u].member_2[1u];
                                        let _e3727 = (_e3717[0] + _e3723[0]);
                                        let _e3728 = (_e3717[1] + _e3723[1]);
                                        let _e3729 = (_e3717[2] + _e3723[2]);
                                        let _e3732 = ((_e3713 * _e3729) - (_e3714 * _e3728));
                                        let _e3735 = ((_e3714 * _e3727) - (_e3712 * _e3729));
                                        let _e3738 = ((_e3712 * _e3728) - (_e3713 * _e3727));
                                        let _e3741 = local_4[1u].member[0u];
                                        let _e3747 = local_4[1u].member_1[0u];
                                        let _e3753 = local_4[1u].member_2[0u];
                                        let _e3757 = (_e3741[0] - _e3747[0]);
                                        let _e3758 = (_e3741[1] - _e3747[1]);
                                        let _e3759 = (_e3741[2] - _e3747[2]);
                                        let _e3768 = local_4[1u].member[1u];
                                        let _e3774 = local_4[1u].member_1[1u];
                                        let _e3780 = local_4[1u].member_2[1u];
                                        let _e3784 = (_e3768[0] - _e3774[0]);
                                        let _e3785 = (_e3768[1] - _e3774[1]);
                                        let _e3786 = (_e3768[2] - _e3774[2]);
                                        local = array<array<f32, 3>, 4>(_e3741, array<f32, 3>(_e3757, _e3758, _e3759), array<f32, 3>((_e3741[0] - _e3753[0]), (_e3741[1] - _e3753[1]), (_e3741[2] - _e3753[2])), array<f32, 3>((_e3757 - _e3753[0]), (_e3758 - _e3753[1]), (_e3759 - _e3753[2])));
                                        local_1 = array<array<f32, 3>, 4>(_e3768, array<f32, 3>(_e3784, _e3785, _e3786), array<f32, 3>((_e3768[0] - _e3780[0]), (_e3768[1] - _e3780[1]), (_e3768[2] - _e3780[2])), array<f32, 3>((_e3784 - _e3780[0]), (_e3785 - _e3780[1]), (_e3786 - _e3780[2])));
                                        let _e3803 = local_4[1u].member[0u];
                                        if (_e3803[0] < 0f) {
                                            phi_6225_ = -(_e3803[0]);
                                        } else {
                                            phi_6225_ = _e3803[0];
                                        }
                                        let _e3810 = phi_6225_;
                                        if (_e3803[1] < 0f) {
                                            phi_6232_ = -(_e3803[1]);
                                        } else {
                                            phi_6232_ = _e3803[1];
                                        }
                                        let _e3814 = phi_6232_;
                                        if (_e3810 > _e3814) {
                                            phi_6237_ = _e3810;
                                        } else {
                                            phi_6237_ = _e3814;
                                        }
                                        let _e3817 = phi_6237_;
                                        if (_e3803[2] < 0f) {
                                            phi_6244_ = -(_e3803[2]);
                                        } else {
                                            phi_6244_ = _e3803[2];
                                        }
                                        let _e3821 = phi_6244_;
                                        if (_e3817 > _e3821) {
                                            phi_6249_ = _e3817;
                                        } else {
                                            phi_6249_ = _e3821;
                                        }
                                        let _e3824 = phi_6249_;
                                        let _e3827 = local_4[1u].member[1u];
                                        if (_e3827[0] < 0f) {
                                            phi_6262_ = -(_e3827[0]);
                                        } else {
                                            phi_6262_ = _e3827[0];
                                        }
                                        let _e3834 = phi_6262_;
                                        if (_e3827[1] < 0f) {
                                            phi_6269_ = -(_e3827[1]);
                                        } else {
                                            phi_6269_ = _e3827[1];
                                        }
                                        let _e3838 = phi_6269_;
                                        if (_e3834 > _e3838) {
                                            phi_6274_ = _e3834;
                                        } else {
                                            phi_6274_ = _e3838;
                                        }
                                        let _e3841 = phi_6274_;
                                        if (_e3827[2] < 0f) {
                                            phi_6281_ = -(_e3827[2]);
                                        } else {
                                            phi_6281_ = _e3827[2];
                                        }
                                        let _e3845 = phi_6281_;
                                        if (_e3841 > _e3845) {
                                            phi_6286_ = _e3841;
                                        } else {
                                            phi_6286_ = _e3845;
                                        }
                                        let _e3848 = phi_6286_;
                                        if (_e3824 > _e3848) {
                                            phi_6291_ = _e3824;
                                        } else {
                                            phi_6291_ = _e3848;
                                        }
                                        let _e3851 = phi_6291_;
                                        let _e3853 = local_4[1u].member_3;
                                        let _e3857 = local_4[1u].member_1[0u];
                                        if (_e3857[0] < 0f) {
                                            phi_6308_ = -(_e3857[0]);
                                        } else {
                                            phi_6308_ = _e3857[0];
                                        }
                                        let _e3864 = phi_6308_;
                                        if (_e3857[1] < 0f) {
                                            phi_6315_ = -(_e3857[1]);
                                        } else {
                                            phi_6315_ = _e3857[1];
                                        }
                                        let _e3868 = phi_6315_;
                                        if (_e3864 > _e3868) {
                                            phi_6320_ = _e3864;
                                        } else {
                                            phi_6320_ = _e3868;
                                        }
                                        let _e3871 = phi_6320_;
                                        if (_e3857[2] < 0f) {
                                            phi_6327_ = -(_e3857[2]);
                                        } else {
                                            phi_6327_ = _e3857[2];
                                        }
                                        let _e3875 = phi_6327_;
                                        if (_e3871 > _e3875) {
                                            phi_6332_ = _e3871;
                                        } else {
                                            phi_6332_ = _e3875;
                                        }
                                        let _e3878 = phi_6332_;
                                        let _e3881 = local_4[1u].member_1[1u];
                                        if (_e3881[0] < 0f) {
                                            phi_6346_ = -(_e3881[0]);
                                        } else {
                                            phi_6346_ = _e3881[0];
                                        }
                                        let _e3888 = phi_6346_;
                                        if (_e3881[1] < 0f) {
                                            phi_6353_ = -(_e3881[1]);
                                        } else {
                                            phi_6353_ = _e3881[1];
                                        }
                                        let _e3892 = phi_6353_;
                                        if (_e3888 > _e3892) {
                                            phi_6358_ = _e3888;
                                        } else {
                                            phi_6358_ = _e3892;
                                        }
                                        let _e3895 = phi_6358_;
                                        if (_e3881[2] < 0f) {
                                            phi_6365_ = -(_e3881[2]);
                                        } else {
                                            phi_6365_ = _e3881[2];
                                        }
                                        let _e3899 = phi_6365_;
                                        if (_e3895 > _e3899) {
                                            phi_6370_ = _e3895;
                                        } else {
                                            phi_6370_ = _e3899;
                                        }
                                        let _e3902 = phi_6370_;
                                        if (_e3878 > _e3902) {
                                            phi_6375_ = _e3878;
                                        } else {
                                            phi_6375_ = _e3902;
                                        }
                                        let _e3905 = phi_6375_;
                                        let _e3907 = local_4[1u].member_3;
                                        let _e3911 = local_4[1u].member_2[0u];
                                        if (_e3911[0] < 0f) {
                                            phi_6392_ = -(_e3911[0]);
                                        } else {
                                            phi_6392_ = _e3911[0];
                                        }
                                        let _e3918 = phi_6392_;
                                        if (_e3911[1] < 0f) {
                                            phi_6399_ = -(_e3911[1]);
                                        } else {
                                            phi_6399_ = _e3911[1];
                                        }
                                        let _e3922 = phi_6399_;
                                        if (_e3918 > _e3922) {
                                            phi_6404_ = _e3918;
                                        } else {
                                            phi_6404_ = _e3922;
                                        }
                                        let _e3925 = phi_6404_;
                                        if (_e3911[2] < 0f) {
                                            phi_6411_ = -(_e3911[2]);
                                        } else {
                                            phi_6411_ = _e3911[2];
                                        }
                                        let _e3929 = phi_6411_;
                                        if (_e3925 > _e3929) {
                                            phi_6416_ = _e3925;
                                        } else {
                                            phi_6416_ = _e3929;
                                        }
                                        let _e3932 = phi_6416_;
                                        let _e3935 = local_4[1u].member_2[1u];
                                        if (_e3935[0] < 0f) {
                                            phi_6430_ = -(_e3935[0]);
                                        } else {
                                            phi_6430_ = _e3935[0];
                                        }
                                        let _e3942 = phi_6430_;
                                        if (_e3935[1] < 0f) {
                                            phi_6437_ = -(_e3935[1]);
                                        } else {
                                            phi_6437_ = _e3935[1];
                                        }
                                        let _e3946 = phi_6437_;
                                        if (_e3942 > _e3946) {
                                            phi_6442_ = _e3942;
                                        } else {
                                            phi_6442_ = _e3946;
                                        }
                                        let _e3949 = phi_6442_;
                                        if (_e3935[2] < 0f) {
                                            phi_6449_ = -(_e3935[2]);
                                        } else {
                                            phi_6449_ = _e3935[2];
                                        }
                                        let _e3953 = phi_6449_;
                                        if (_e3949 > _e3953) {
                                            phi_6454_ = _e3949;
                                        } else {
                                            phi_6454_ = _e3953;
                                        }
                                        let _e3956 = phi_6454_;
                                        if (_e3932 > _e3956) {
                                            phi_6459_ = _e3932;
                                        } else {
                                            phi_6459_ = _e3956;
                                        }
                                        let _e3959 = phi_6459_;
                                        let _e3961 = local_4[1u].member_3;
                                        let _e3964 = (((_e3851 + _e3853) + (_e3905 + _e3907)) + (_e3959 + _e3961));
                                        let _e3967 = local_4[1u].member_3;
                                        let _e3971 = (((_e1212 * 1.0001f) + (_e3967 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e3974 = ((_e3735 * _e3714) - (_e3738 * _e3713));
                                        let _e3977 = ((_e3738 * _e3712) - (_e3732 * _e3714));
                                        let _e3980 = ((_e3732 * _e3713) - (_e3735 * _e3712));
                                        let _e3982 = local[0u];
                                        let _e3990 = (((_e3974 * _e3982[0]) + (_e3977 * _e3982[1])) + (_e3980 * _e3982[2]));
                                        phi_6497_ = type_37(0u, 4u);
                                        phi_6500_ = _e3990;
                                        phi_6502_ = _e3990;
                                        loop {
                                            let _e3992 = phi_6497_;
                                            let _e3994 = phi_6500_;
                                            let _e3996 = phi_6502_;
                                            local_38 = _e3994;
                                            local_39 = _e3996;
                                            local_47 = _e3996;
                                            if (_e3992.member < _e3992.member_1) {
                                                phi_6498_ = type_37((_e3992.member + 1u), _e3992.member_1);
                                                phi_6525_ = type_37(1u, _e3992.member);
                                            } else {
                                                phi_6498_ = _e3992;
                                                phi_6525_ = type_37(0u, type_37().member_1);
                                            }
                                            let _e4010 = phi_6498_;
                                            let _e4012 = phi_6525_;
                                            let _e4016 = (bitcast<i32>(_e4012.member) != 0i);
                                            if _e4016 {
                                                if (_e4012.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4019 = local[_e4012.member_1];
                                                let _e4027 = (((_e3974 * _e4019[0]) + (_e3977 * _e4019[1])) + (_e3980 * _e4019[2]));
                                                if (_e4012.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4030 = local_1[_e4012.member_1];
                                                let _e4038 = (((_e3974 * _e4030[0]) + (_e3977 * _e4030[1])) + (_e3980 * _e4030[2]));
                                                if (_e3996 < _e4027) {
                                                    phi_6575_ = _e3996;
                                                } else {
                                                    phi_6575_ = _e4027;
                                                }
                                                let _e4041 = phi_6575_;
                                                if (_e4041 < _e4038) {
                                                    phi_6580_ = _e4041;
                                                } else {
                                                    phi_6580_ = _e4038;
                                                }
                                                let _e4044 = phi_6580_;
                                                if (_e3994 > _e4027) {
                                                    phi_6585_ = _e3994;
                                                } else {
                                                    phi_6585_ = _e4027;
                                                }
                                                let _e4047 = phi_6585_;
                                                if (_e4047 > _e4038) {
                                                    phi_6590_ = _e4047;
                                                } else {
                                                    phi_6590_ = _e4038;
                                                }
                                                let _e4050 = phi_6590_;
                                                phi_6501_ = _e4050;
                                                phi_6503_ = _e4044;
                                            } else {
                                                phi_6501_ = f32();
                                                phi_6503_ = f32();
                                            }
                                            let _e4052 = phi_6501_;
                                            let _e4054 = phi_6503_;
                                            continue;
                                            continuing {
                                                phi_6497_ = _e4010;
                                                phi_6500_ = _e4052;
                                                phi_6502_ = _e4054;
                                                break if !(_e4016);
                                            }
                                        }
                                        if (_e3974 < 0f) {
                                            phi_6596_ = -(_e3974);
                                        } else {
                                            phi_6596_ = _e3974;
                                        }
                                        let _e4059 = phi_6596_;
                                        if (_e3977 < 0f) {
                                            phi_6602_ = -(_e3977);
                                        } else {
                                            phi_6602_ = _e3977;
                                        }
                                        let _e4063 = phi_6602_;
                                        if (_e3980 < 0f) {
                                            phi_6609_ = -(_e3980);
                                        } else {
                                            phi_6609_ = _e3980;
                                        }
                                        let _e4068 = phi_6609_;
                                        let _e4069 = ((_e4059 + _e4063) + _e4068);
                                        let _e4074 = local_38;
                                        let _e4075 = -(_e4074);
                                        let _e4077 = local_39;
                                        if (_e4077 > _e4075) {
                                            let _e4800 = local_47;
                                            phi_6619_ = _e4800;
                                        } else {
                                            phi_6619_ = _e4075;
                                        }
                                        let _e4080 = phi_6619_;
                                        let _e4085 = (((_e4080 - ((_e4069 * _e3964) * (0.000000059604645f * 17f))) - (_e4069 * _e3971)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4088 = ((_e3735 * _e3729) - (_e3738 * _e3728));
                                        let _e4091 = ((_e3738 * _e3727) - (_e3732 * _e3729));
                                        let _e4094 = ((_e3732 * _e3728) - (_e3735 * _e3727));
                                        let _e4096 = local[0u];
                                        let _e4104 = (((_e4088 * _e4096[0]) + (_e4091 * _e4096[1])) + (_e4094 * _e4096[2]));
                                        phi_6650_ = type_37(0u, 4u);
                                        phi_6653_ = _e4104;
                                        phi_6655_ = _e4104;
                                        loop {
                                            let _e4106 = phi_6650_;
                                            let _e4108 = phi_6653_;
                                            let _e4110 = phi_6655_;
                                            local_40 = _e4108;
                                            local_41 = _e4110;
                                            local_48 = _e4110;
                                            if (_e4106.member < _e4106.member_1) {
                                                phi_6651_ = type_37((_e4106.member + 1u), _e4106.member_1);
                                                phi_6678_ = type_37(1u, _e4106.member);
                                            } else {
                                                phi_6651_ = _e4106;
                                                phi_6678_ = type_37(0u, type_37().member_1);
                                            }
                                            let _e4124 = phi_6651_;
                                            let _e4126 = phi_6678_;
                                            let _e4130 = (bitcast<i32>(_e4126.member) != 0i);
                                            if _e4130 {
                                                if (_e4126.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4133 = local[_e4126.member_1];
                                                let _e4141 = (((_e4088 * _e4133[0]) + (_e4091 * _e4133[1])) + (_e4094 * _e4133[2]));
                                                if (_e4126.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4144 = local_1[_e4126.member_1];
                                                let _e4152 = (((_e4088 * _e4144[0]) + (_e4091 * _e4144[1])) + (_e4094 * _e4144[2]));
                                                if (_e4110 < _e4141) {
                                                    phi_6728_ = _e4110;
                                                } else {
                                                    phi_6728_ = _e4141;
                                                }
                                                let _e4155 = phi_6728_;
                                                if (_e4155 < _e4152) {
                                                    phi_6733_ = _e4155;
                                                } else {
                                                    phi_6733_ = _e4152;
                                                }
                                                let _e4158 = phi_6733_;
                                                if (_e4108 > _e4141) {
                                                    phi_6738_ = _e4108;
                                                } else {
                                                    phi_6738_ = _e4141;
                                                }
                                                let _e4161 = phi_6738_;
                                                if (_e4161 > _e4152) {
                                                    phi_6743_ = _e4161;
                                                } else {
                                                    phi_6743_ = _e4152;
                                                }
                                                let _e4164 = phi_6743_;
                                                phi_6654_ = _e4164;
                                                phi_6656_ = _e4158;
                                            } else {
                                                phi_6654_ = f32();
                                                phi_6656_ = f32();
                                            }
                                            let _e4166 = phi_6654_;
                                            let _e4168 = phi_6656_;
                                            continue;
                                            continuing {
                                                phi_6650_ = _e4124;
                                                phi_6653_ = _e4166;
                                                phi_6655_ = _e4168;
                                                break if !(_e4130);
                                            }
                                        }
                                        if (_e4088 < 0f) {
                                            phi_6749_ = -(_e4088);
                                        } else {
                                            phi_6749_ = _e4088;
                                        }
                                        let _e4173 = phi_6749_;
                                        if (_e4091 < 0f) {
                                            phi_6755_ = -(_e4091);
                                        } else {
                                            phi_6755_ = _e4091;
                                        }
                                        let _e4177 = phi_6755_;
                                        if (_e4094 < 0f) {
                                            phi_6762_ = -(_e4094);
                                        } else {
                                            phi_6762_ = _e4094;
                                        }
                                        let _e4182 = phi_6762_;
                                        let _e4183 = ((_e4173 + _e4177) + _e4182);
                                        let _e4188 = local_40;
                                        let _e4189 = -(_e4188);
                                        let _e4191 = local_41;
                                        if (_e4191 > _e4189) {
                                            let _e4819 = local_48;
                                            phi_6772_ = _e4819;
                                        } else {
                                            phi_6772_ = _e4189;
                                        }
                                        let _e4194 = phi_6772_;
                                        let _e4199 = (((_e4194 - ((_e4183 * _e3964) * (0.000000059604645f * 17f))) - (_e4183 * _e3971)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4085 > _e4199) {
                                            phi_6782_ = _e4085;
                                        } else {
                                            phi_6782_ = _e4199;
                                        }
                                        let _e4202 = phi_6782_;
                                        phi_6950_ = (_e4202 > 0f);
                                    }
                                    let _e4205 = phi_6950_;
                                    phi_6951_ = _e4205;
                                } else {
                                    phi_6951_ = false;
                                }
                                let _e4207 = phi_6951_;
                                phi_6953_ = !(_e4207);
                            }
                            let _e4210 = phi_6953_;
                            if _e4210 {
                                let _e4212 = atomicAdd((&counters[3u]), 1u);
                                kept[_e4212] = _e445;
                            }
                        }
                        phi_6961_ = (_e408 + 64u);
                        phi_6962_ = true;
                    }
                    let _e4216 = phi_6961_;
                    let _e4218 = phi_6962_;
                    phi_650_ = _e4216;
                    phi_6963_ = _e4218;
                } else {
                    phi_650_ = u32();
                    phi_6963_ = false;
                }
                let _e4220 = phi_650_;
                let _e4222 = phi_6963_;
                continue;
                continuing {
                    phi_646_ = _e437;
                    phi_649_ = _e4220;
                    break if !(_e4222);
                }
            }
            workgroupBarrier();
            if (_e93 == 0u) {
                let _e4226 = atomicLoad((&counters[3u]));
                if (_e4226 > 0u) {
                    let _e4229 = atomicAdd((&output.member[0u]), _e4226);
                    atomicStore((&counters[4u]), _e4229);
                }
            }
            workgroupBarrier();
            let _e4232 = atomicLoad((&counters[4u]));
            if (_e93 == 0u) {
                let _e4235 = atomicLoad((&counters[5u]));
                let _e4237 = atomicAdd((&output.member[1u]), _e4235);
            }
            let _e4239 = atomicLoad((&counters[3u]));
            phi_6993_ = type_35(0i, 16i);
            phi_6996_ = _e93;
            loop {
                let _e4241 = phi_6993_;
                let _e4243 = phi_6996_;
                if (_e4241.member < _e4241.member_1) {
                    let _e4251 = (_e4241.member + 1i);
                    if ((false == (_e4251 > _e4241.member)) != false) {
                        phi_7017_ = true;
                    } else {
                        phi_7017_ = false;
                    }
                    let _e4256 = phi_7017_;
                    if _e4256 {
                        phi_7023_ = type_36(0u, type_36().member_1);
                    } else {
                        phi_7023_ = type_36(1u, _e4251);
                    }
                    let _e4262 = phi_7023_;
                    if (bitcast<i32>(_e4262.member) != 0i) {
                    } else {
                        return;
                    }
                    phi_6994_ = type_35(_e4262.member_1, _e4241.member_1);
                    phi_7037_ = type_36(1u, _e4241.member);
                } else {
                    phi_6994_ = _e4241;
                    phi_7037_ = type_36(0u, type_36().member_1);
                }
                let _e4272 = phi_6994_;
                let _e4274 = phi_7037_;
                if (bitcast<i32>(_e4274.member) != 0i) {
                    if (_e4243 >= _e4239) {
                        phi_7143_ = u32();
                        phi_7144_ = false;
                    } else {
                        let _e4280 = kept[_e4243];
                        let _e4289 = params.member.member_18[0u][1u];
                        let _e4296 = params.member.member_18[0u][1u];
                        let _e4299 = leaves.member[(_e4289 + ((_e186 * 32u) + (_e4280 >> bitcast<u32>(5i))))];
                        let _e4302 = leaves.member[(_e4296 + ((_e189 * 32u) + (_e4280 & 31u)))];
                        if (_e4299.member_1 < _e4302.member_1) {
                            phi_7119_ = type_37(_e4299.member_1, _e4302.member_1);
                        } else {
                            phi_7119_ = type_37(_e4302.member_1, _e4299.member_1);
                        }
                        let _e4308 = phi_7119_;
                        let _e4310 = params.member.member_16;
                        let _e4311 = (_e4232 + _e4243);
                        if (_e4311 < _e4310) {
                            atomicStore((&output.member[(4u + (2u * _e4311))]), _e4308.member);
                            atomicStore((&output.member[((2u * _e4311) + 5u)]), _e4308.member_1);
                        }
                        phi_7143_ = (_e4243 + 64u);
                        phi_7144_ = true;
                    }
                    let _e4323 = phi_7143_;
                    let _e4325 = phi_7144_;
                    phi_6997_ = _e4323;
                    phi_7145_ = _e4325;
                } else {
                    phi_6997_ = u32();
                    phi_7145_ = false;
                }
                let _e4327 = phi_6997_;
                let _e4329 = phi_7145_;
                continue;
                continuing {
                    phi_6993_ = _e4272;
                    phi_6996_ = _e4327;
                    break if !(_e4329);
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
fn filter_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
