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
    var phi_1748_: type_23;
    var phi_1749_: type_23;
    var phi_2138_: f32;
    var phi_2145_: f32;
    var phi_2150_: f32;
    var phi_2157_: f32;
    var phi_2162_: f32;
    var phi_2175_: f32;
    var phi_2182_: f32;
    var phi_2187_: f32;
    var phi_2194_: f32;
    var phi_2199_: f32;
    var phi_2204_: f32;
    var phi_2221_: f32;
    var phi_2228_: f32;
    var phi_2233_: f32;
    var phi_2240_: f32;
    var phi_2245_: f32;
    var phi_2259_: f32;
    var phi_2266_: f32;
    var phi_2271_: f32;
    var phi_2278_: f32;
    var phi_2283_: f32;
    var phi_2288_: f32;
    var phi_2305_: f32;
    var phi_2312_: f32;
    var phi_2317_: f32;
    var phi_2324_: f32;
    var phi_2329_: f32;
    var phi_2343_: f32;
    var phi_2350_: f32;
    var phi_2355_: f32;
    var phi_2362_: f32;
    var phi_2367_: f32;
    var phi_2372_: f32;
    var phi_2403_: f32;
    var phi_2409_: f32;
    var phi_2416_: f32;
    var phi_2423_: f32;
    var phi_2429_: f32;
    var phi_2436_: f32;
    var phi_2442_: f32;
    var phi_2448_: f32;
    var phi_2454_: f32;
    var phi_2461_: f32;
    var phi_2468_: f32;
    var phi_2492_: f32;
    var phi_2497_: f32;
    var phi_2502_: f32;
    var phi_2507_: f32;
    var phi_2512_: f32;
    var phi_2517_: f32;
    var phi_2527_: f32;
    var phi_2778_: f32;
    var phi_2785_: f32;
    var phi_2790_: f32;
    var phi_2797_: f32;
    var phi_2802_: f32;
    var phi_2815_: f32;
    var phi_2822_: f32;
    var phi_2827_: f32;
    var phi_2834_: f32;
    var phi_2839_: f32;
    var phi_2844_: f32;
    var phi_2861_: f32;
    var phi_2868_: f32;
    var phi_2873_: f32;
    var phi_2880_: f32;
    var phi_2885_: f32;
    var phi_2899_: f32;
    var phi_2906_: f32;
    var phi_2911_: f32;
    var phi_2918_: f32;
    var phi_2923_: f32;
    var phi_2928_: f32;
    var phi_2945_: f32;
    var phi_2952_: f32;
    var phi_2957_: f32;
    var phi_2964_: f32;
    var phi_2969_: f32;
    var phi_2983_: f32;
    var phi_2990_: f32;
    var phi_2995_: f32;
    var phi_3002_: f32;
    var phi_3007_: f32;
    var phi_3012_: f32;
    var phi_3050_: type_37;
    var phi_3053_: f32;
    var phi_3055_: f32;
    var phi_3051_: type_37;
    var phi_3078_: type_37;
    var phi_3128_: f32;
    var phi_3133_: f32;
    var phi_3138_: f32;
    var phi_3143_: f32;
    var phi_3054_: f32;
    var phi_3056_: f32;
    var phi_3149_: f32;
    var phi_3155_: f32;
    var phi_3162_: f32;
    var local_30: f32;
    var local_31: f32;
    var phi_3172_: f32;
    var phi_3203_: type_37;
    var phi_3206_: f32;
    var phi_3208_: f32;
    var phi_3204_: type_37;
    var phi_3231_: type_37;
    var phi_3281_: f32;
    var phi_3286_: f32;
    var phi_3291_: f32;
    var phi_3296_: f32;
    var phi_3207_: f32;
    var phi_3209_: f32;
    var phi_3302_: f32;
    var phi_3308_: f32;
    var phi_3315_: f32;
    var local_32: f32;
    var local_33: f32;
    var phi_3325_: f32;
    var phi_3335_: f32;
    var phi_3503_: bool;
    var phi_3960_: f32;
    var phi_3967_: f32;
    var phi_3972_: f32;
    var phi_3979_: f32;
    var phi_3984_: f32;
    var phi_3997_: f32;
    var phi_4004_: f32;
    var phi_4009_: f32;
    var phi_4016_: f32;
    var phi_4021_: f32;
    var phi_4026_: f32;
    var phi_4043_: f32;
    var phi_4050_: f32;
    var phi_4055_: f32;
    var phi_4062_: f32;
    var phi_4067_: f32;
    var phi_4081_: f32;
    var phi_4088_: f32;
    var phi_4093_: f32;
    var phi_4100_: f32;
    var phi_4105_: f32;
    var phi_4110_: f32;
    var phi_4127_: f32;
    var phi_4134_: f32;
    var phi_4139_: f32;
    var phi_4146_: f32;
    var phi_4151_: f32;
    var phi_4165_: f32;
    var phi_4172_: f32;
    var phi_4177_: f32;
    var phi_4184_: f32;
    var phi_4189_: f32;
    var phi_4194_: f32;
    var phi_4225_: f32;
    var phi_4231_: f32;
    var phi_4238_: f32;
    var phi_4245_: f32;
    var phi_4251_: f32;
    var phi_4258_: f32;
    var phi_4264_: f32;
    var phi_4270_: f32;
    var phi_4276_: f32;
    var phi_4283_: f32;
    var phi_4290_: f32;
    var phi_4314_: f32;
    var phi_4319_: f32;
    var phi_4324_: f32;
    var phi_4329_: f32;
    var phi_4334_: f32;
    var phi_4339_: f32;
    var phi_4349_: f32;
    var phi_4600_: f32;
    var phi_4607_: f32;
    var phi_4612_: f32;
    var phi_4619_: f32;
    var phi_4624_: f32;
    var phi_4637_: f32;
    var phi_4644_: f32;
    var phi_4649_: f32;
    var phi_4656_: f32;
    var phi_4661_: f32;
    var phi_4666_: f32;
    var phi_4683_: f32;
    var phi_4690_: f32;
    var phi_4695_: f32;
    var phi_4702_: f32;
    var phi_4707_: f32;
    var phi_4721_: f32;
    var phi_4728_: f32;
    var phi_4733_: f32;
    var phi_4740_: f32;
    var phi_4745_: f32;
    var phi_4750_: f32;
    var phi_4767_: f32;
    var phi_4774_: f32;
    var phi_4779_: f32;
    var phi_4786_: f32;
    var phi_4791_: f32;
    var phi_4805_: f32;
    var phi_4812_: f32;
    var phi_4817_: f32;
    var phi_4824_: f32;
    var phi_4829_: f32;
    var phi_4834_: f32;
    var phi_4872_: type_37;
    var phi_4875_: f32;
    var phi_4877_: f32;
    var phi_4873_: type_37;
    var phi_4900_: type_37;
    var phi_4950_: f32;
    var phi_4955_: f32;
    var phi_4960_: f32;
    var phi_4965_: f32;
    var phi_4876_: f32;
    var phi_4878_: f32;
    var phi_4971_: f32;
    var phi_4977_: f32;
    var phi_4984_: f32;
    var local_34: f32;
    var local_35: f32;
    var phi_4994_: f32;
    var phi_5025_: type_37;
    var phi_5028_: f32;
    var phi_5030_: f32;
    var phi_5026_: type_37;
    var phi_5053_: type_37;
    var phi_5103_: f32;
    var phi_5108_: f32;
    var phi_5113_: f32;
    var phi_5118_: f32;
    var phi_5029_: f32;
    var phi_5031_: f32;
    var phi_5124_: f32;
    var phi_5130_: f32;
    var phi_5137_: f32;
    var local_36: f32;
    var local_37: f32;
    var phi_5147_: f32;
    var phi_5157_: f32;
    var phi_5325_: bool;
    var phi_5571_: f32;
    var phi_5578_: f32;
    var phi_5583_: f32;
    var phi_5590_: f32;
    var phi_5595_: f32;
    var phi_5608_: f32;
    var phi_5615_: f32;
    var phi_5620_: f32;
    var phi_5627_: f32;
    var phi_5632_: f32;
    var phi_5637_: f32;
    var phi_5654_: f32;
    var phi_5661_: f32;
    var phi_5666_: f32;
    var phi_5673_: f32;
    var phi_5678_: f32;
    var phi_5692_: f32;
    var phi_5699_: f32;
    var phi_5704_: f32;
    var phi_5711_: f32;
    var phi_5716_: f32;
    var phi_5721_: f32;
    var phi_5738_: f32;
    var phi_5745_: f32;
    var phi_5750_: f32;
    var phi_5757_: f32;
    var phi_5762_: f32;
    var phi_5776_: f32;
    var phi_5783_: f32;
    var phi_5788_: f32;
    var phi_5795_: f32;
    var phi_5800_: f32;
    var phi_5805_: f32;
    var phi_5836_: f32;
    var phi_5842_: f32;
    var phi_5849_: f32;
    var phi_5856_: f32;
    var phi_5862_: f32;
    var phi_5869_: f32;
    var phi_5875_: f32;
    var phi_5881_: f32;
    var phi_5887_: f32;
    var phi_5894_: f32;
    var phi_5901_: f32;
    var phi_5925_: f32;
    var phi_5930_: f32;
    var phi_5935_: f32;
    var phi_5940_: f32;
    var phi_5945_: f32;
    var phi_5950_: f32;
    var phi_5960_: f32;
    var phi_6211_: f32;
    var phi_6218_: f32;
    var phi_6223_: f32;
    var phi_6230_: f32;
    var phi_6235_: f32;
    var phi_6248_: f32;
    var phi_6255_: f32;
    var phi_6260_: f32;
    var phi_6267_: f32;
    var phi_6272_: f32;
    var phi_6277_: f32;
    var phi_6294_: f32;
    var phi_6301_: f32;
    var phi_6306_: f32;
    var phi_6313_: f32;
    var phi_6318_: f32;
    var phi_6332_: f32;
    var phi_6339_: f32;
    var phi_6344_: f32;
    var phi_6351_: f32;
    var phi_6356_: f32;
    var phi_6361_: f32;
    var phi_6378_: f32;
    var phi_6385_: f32;
    var phi_6390_: f32;
    var phi_6397_: f32;
    var phi_6402_: f32;
    var phi_6416_: f32;
    var phi_6423_: f32;
    var phi_6428_: f32;
    var phi_6435_: f32;
    var phi_6440_: f32;
    var phi_6445_: f32;
    var phi_6483_: type_37;
    var phi_6486_: f32;
    var phi_6488_: f32;
    var phi_6484_: type_37;
    var phi_6511_: type_37;
    var phi_6561_: f32;
    var phi_6566_: f32;
    var phi_6571_: f32;
    var phi_6576_: f32;
    var phi_6487_: f32;
    var phi_6489_: f32;
    var phi_6582_: f32;
    var phi_6588_: f32;
    var phi_6595_: f32;
    var local_38: f32;
    var local_39: f32;
    var phi_6605_: f32;
    var phi_6636_: type_37;
    var phi_6639_: f32;
    var phi_6641_: f32;
    var phi_6637_: type_37;
    var phi_6664_: type_37;
    var phi_6714_: f32;
    var phi_6719_: f32;
    var phi_6724_: f32;
    var phi_6729_: f32;
    var phi_6640_: f32;
    var phi_6642_: f32;
    var phi_6735_: f32;
    var phi_6741_: f32;
    var phi_6748_: f32;
    var local_40: f32;
    var local_41: f32;
    var phi_6758_: f32;
    var phi_6768_: f32;
    var phi_6936_: bool;
    var phi_6937_: bool;
    var phi_6939_: bool;
    var phi_6947_: u32;
    var phi_6948_: bool;
    var phi_650_: u32;
    var phi_6949_: bool;
    var phi_6979_: type_35;
    var phi_6982_: u32;
    var phi_7003_: bool;
    var phi_7009_: type_36;
    var phi_6980_: type_35;
    var phi_7023_: type_36;
    var phi_7105_: type_37;
    var phi_7129_: u32;
    var phi_7130_: bool;
    var phi_6983_: u32;
    var phi_7131_: bool;
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
                        phi_6947_ = u32();
                        phi_6948_ = false;
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
                                            local_42 = _e654;
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
                                        let _e4433 = local_42;
                                        phi_1688_ = _e4433;
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
                            let _e1197 = local_16.member_1;
                            let _e1199 = local_17.member_1;
                            if (_e1197 < _e1199) {
                                phi_1748_ = _e466;
                                phi_1749_ = _e464;
                            } else {
                                phi_1748_ = _e464;
                                phi_1749_ = _e466;
                            }
                            let _e1202 = phi_1748_;
                            let _e1204 = phi_1749_;
                            let _e1206 = params.member.member_4;
                            let _e1208 = params.member.member_5;
                            let _e1218 = paths.member[_e1204.member[0]];
                            let _e1220 = paths.member[_e1204.member[1]];
                            let _e1226 = paths.member[_e1202.member[0]];
                            let _e1228 = paths.member[_e1202.member[1]];
                            local_7 = type_72(array<array<f32, 3>, 2>(array<f32, 3>((_e1226.member[0] - _e1218.member[0]), (_e1226.member[1] - _e1218.member[1]), (_e1226.member[2] - _e1218.member[2])), array<f32, 3>((_e1226.member_1[0] - _e1218.member_1[0]), (_e1226.member_1[1] - _e1218.member_1[1]), (_e1226.member_1[2] - _e1218.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1220.member[0] - _e1218.member[0]), (_e1220.member[1] - _e1218.member[1]), (_e1220.member[2] - _e1218.member[2])), array<f32, 3>((_e1220.member_1[0] - _e1218.member_1[0]), (_e1220.member_1[1] - _e1218.member_1[1]), (_e1220.member_1[2] - _e1218.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1226.member[0] - _e1228.member[0]), (_e1226.member[1] - _e1228.member[1]), (_e1226.member[2] - _e1228.member[2])), array<f32, 3>((_e1226.member_1[0] - _e1228.member_1[0]), (_e1226.member_1[1] - _e1228.member_1[1]), (_e1226.member_1[2] - _e1228.member_1[2]))), (_e1206 + _e1206));
                            let _e1288 = local_7.member_1[0u];
                            let _e1294 = local_7.member_2[0u];
                            let _e1300 = ((_e1288[1] * _e1294[2]) - (_e1288[2] * _e1294[1]));
                            let _e1303 = ((_e1288[2] * _e1294[0]) - (_e1288[0] * _e1294[2]));
                            let _e1306 = ((_e1288[0] * _e1294[1]) - (_e1288[1] * _e1294[0]));
                            let _e1309 = local_7.member_1[1u];
                            let _e1315 = local_7.member_2[1u];
                            let _e1321 = ((_e1309[1] * _e1315[2]) - (_e1309[2] * _e1315[1]));
                            let _e1324 = ((_e1309[2] * _e1315[0]) - (_e1309[0] * _e1315[2]));
                            let _e1327 = ((_e1309[0] * _e1315[1]) - (_e1309[1] * _e1315[0]));
                            let _e1330 = local_7.member_1[0u];
                            let _e1336 = local_7.member_2[1u];
                            let _e1351 = local_7.member_1[1u];
                            let _e1357 = local_7.member_2[0u];
                            let _e1370 = (((_e1330[1] * _e1336[2]) - (_e1330[2] * _e1336[1])) + ((_e1351[1] * _e1357[2]) - (_e1351[2] * _e1357[1])));
                            let _e1371 = (((_e1330[2] * _e1336[0]) - (_e1330[0] * _e1336[2])) + ((_e1351[2] * _e1357[0]) - (_e1351[0] * _e1357[2])));
                            let _e1372 = (((_e1330[0] * _e1336[1]) - (_e1330[1] * _e1336[0])) + ((_e1351[0] * _e1357[1]) - (_e1351[1] * _e1357[0])));
                            let _e1375 = local_7.member[0u];
                            let _e1386 = local_7.member[1u];
                            let _e1397 = local_7.member[0u];
                            let _e1406 = ((((_e1386[0] * _e1300) + (_e1386[1] * _e1303)) + (_e1386[2] * _e1306)) + (((_e1397[0] * _e1370) + (_e1397[1] * _e1371)) + (_e1397[2] * _e1372)));
                            let _e1409 = local_7.member[0u];
                            let _e1420 = local_7.member[1u];
                            let _e1429 = ((((_e1409[0] * _e1321) + (_e1409[1] * _e1324)) + (_e1409[2] * _e1327)) + (((_e1420[0] * _e1370) + (_e1420[1] * _e1371)) + (_e1420[2] * _e1372)));
                            let _e1432 = local_7.member[1u];
                            let _e1443 = local_7.member[0u];
                            if (_e1443[0] < 0f) {
                                phi_2138_ = -(_e1443[0]);
                            } else {
                                phi_2138_ = _e1443[0];
                            }
                            let _e1450 = phi_2138_;
                            if (_e1443[1] < 0f) {
                                phi_2145_ = -(_e1443[1]);
                            } else {
                                phi_2145_ = _e1443[1];
                            }
                            let _e1454 = phi_2145_;
                            if (_e1450 > _e1454) {
                                phi_2150_ = _e1450;
                            } else {
                                phi_2150_ = _e1454;
                            }
                            let _e1457 = phi_2150_;
                            if (_e1443[2] < 0f) {
                                phi_2157_ = -(_e1443[2]);
                            } else {
                                phi_2157_ = _e1443[2];
                            }
                            let _e1461 = phi_2157_;
                            if (_e1457 > _e1461) {
                                phi_2162_ = _e1457;
                            } else {
                                phi_2162_ = _e1461;
                            }
                            let _e1464 = phi_2162_;
                            let _e1467 = local_7.member[1u];
                            if (_e1467[0] < 0f) {
                                phi_2175_ = -(_e1467[0]);
                            } else {
                                phi_2175_ = _e1467[0];
                            }
                            let _e1474 = phi_2175_;
                            if (_e1467[1] < 0f) {
                                phi_2182_ = -(_e1467[1]);
                            } else {
                                phi_2182_ = _e1467[1];
                            }
                            let _e1478 = phi_2182_;
                            if (_e1474 > _e1478) {
                                phi_2187_ = _e1474;
                            } else {
                                phi_2187_ = _e1478;
                            }
                            let _e1481 = phi_2187_;
                            if (_e1467[2] < 0f) {
                                phi_2194_ = -(_e1467[2]);
                            } else {
                                phi_2194_ = _e1467[2];
                            }
                            let _e1485 = phi_2194_;
                            if (_e1481 > _e1485) {
                                phi_2199_ = _e1481;
                            } else {
                                phi_2199_ = _e1485;
                            }
                            let _e1488 = phi_2199_;
                            if (_e1464 > _e1488) {
                                phi_2204_ = _e1464;
                            } else {
                                phi_2204_ = _e1488;
                            }
                            let _e1491 = phi_2204_;
                            let _e1493 = local_7.member_3;
                            let _e1494 = (_e1491 + _e1493);
                            let _e1497 = local_7.member_1[0u];
                            if (_e1497[0] < 0f) {
                                phi_2221_ = -(_e1497[0]);
                            } else {
                                phi_2221_ = _e1497[0];
                            }
                            let _e1504 = phi_2221_;
                            if (_e1497[1] < 0f) {
                                phi_2228_ = -(_e1497[1]);
                            } else {
                                phi_2228_ = _e1497[1];
                            }
                            let _e1508 = phi_2228_;
                            if (_e1504 > _e1508) {
                                phi_2233_ = _e1504;
                            } else {
                                phi_2233_ = _e1508;
                            }
                            let _e1511 = phi_2233_;
                            if (_e1497[2] < 0f) {
                                phi_2240_ = -(_e1497[2]);
                            } else {
                                phi_2240_ = _e1497[2];
                            }
                            let _e1515 = phi_2240_;
                            if (_e1511 > _e1515) {
                                phi_2245_ = _e1511;
                            } else {
                                phi_2245_ = _e1515;
                            }
                            let _e1518 = phi_2245_;
                            let _e1521 = local_7.member_1[1u];
                            if (_e1521[0] < 0f) {
                                phi_2259_ = -(_e1521[0]);
                            } else {
                                phi_2259_ = _e1521[0];
                            }
                            let _e1528 = phi_2259_;
                            if (_e1521[1] < 0f) {
                                phi_2266_ = -(_e1521[1]);
                            } else {
                                phi_2266_ = _e1521[1];
                            }
                            let _e1532 = phi_2266_;
                            if (_e1528 > _e1532) {
                                phi_2271_ = _e1528;
                            } else {
                                phi_2271_ = _e1532;
                            }
                            let _e1535 = phi_2271_;
                            if (_e1521[2] < 0f) {
                                phi_2278_ = -(_e1521[2]);
                            } else {
                                phi_2278_ = _e1521[2];
                            }
                            let _e1539 = phi_2278_;
                            if (_e1535 > _e1539) {
                                phi_2283_ = _e1535;
                            } else {
                                phi_2283_ = _e1539;
                            }
                            let _e1542 = phi_2283_;
                            if (_e1518 > _e1542) {
                                phi_2288_ = _e1518;
                            } else {
                                phi_2288_ = _e1542;
                            }
                            let _e1545 = phi_2288_;
                            let _e1547 = local_7.member_3;
                            let _e1548 = (_e1545 + _e1547);
                            let _e1551 = local_7.member_2[0u];
                            if (_e1551[0] < 0f) {
                                phi_2305_ = -(_e1551[0]);
                            } else {
                                phi_2305_ = _e1551[0];
                            }
                            let _e1558 = phi_2305_;
                            if (_e1551[1] < 0f) {
                                phi_2312_ = -(_e1551[1]);
                            } else {
                                phi_2312_ = _e1551[1];
                            }
                            let _e1562 = phi_2312_;
                            if (_e1558 > _e1562) {
                                phi_2317_ = _e1558;
                            } else {
                                phi_2317_ = _e1562;
                            }
                            let _e1565 = phi_2317_;
                            if (_e1551[2] < 0f) {
                                phi_2324_ = -(_e1551[2]);
                            } else {
                                phi_2324_ = _e1551[2];
                            }
                            let _e1569 = phi_2324_;
                            if (_e1565 > _e1569) {
                                phi_2329_ = _e1565;
                            } else {
                                phi_2329_ = _e1569;
                            }
                            let _e1572 = phi_2329_;
                            let _e1575 = local_7.member_2[1u];
                            if (_e1575[0] < 0f) {
                                phi_2343_ = -(_e1575[0]);
                            } else {
                                phi_2343_ = _e1575[0];
                            }
                            let _e1582 = phi_2343_;
                            if (_e1575[1] < 0f) {
                                phi_2350_ = -(_e1575[1]);
                            } else {
                                phi_2350_ = _e1575[1];
                            }
                            let _e1586 = phi_2350_;
                            if (_e1582 > _e1586) {
                                phi_2355_ = _e1582;
                            } else {
                                phi_2355_ = _e1586;
                            }
                            let _e1589 = phi_2355_;
                            if (_e1575[2] < 0f) {
                                phi_2362_ = -(_e1575[2]);
                            } else {
                                phi_2362_ = _e1575[2];
                            }
                            let _e1593 = phi_2362_;
                            if (_e1589 > _e1593) {
                                phi_2367_ = _e1589;
                            } else {
                                phi_2367_ = _e1593;
                            }
                            let _e1596 = phi_2367_;
                            if (_e1572 > _e1596) {
                                phi_2372_ = _e1572;
                            } else {
                                phi_2372_ = _e1596;
                            }
                            let _e1599 = phi_2372_;
                            let _e1601 = local_7.member_3;
                            let _e1602 = (_e1599 + _e1601);
                            let _e1604 = ((_e1548 * 8f) * _e1602);
                            let _e1611 = local_7.member_3;
                            if (_e1300 < 0f) {
                                phi_2403_ = -(_e1300);
                            } else {
                                phi_2403_ = _e1300;
                            }
                            let _e1628 = phi_2403_;
                            if (_e1303 < 0f) {
                                phi_2409_ = -(_e1303);
                            } else {
                                phi_2409_ = _e1303;
                            }
                            let _e1632 = phi_2409_;
                            if (_e1306 < 0f) {
                                phi_2416_ = -(_e1306);
                            } else {
                                phi_2416_ = _e1306;
                            }
                            let _e1637 = phi_2416_;
                            let _e1638 = ((_e1628 + _e1632) + _e1637);
                            if (_e1321 < 0f) {
                                phi_2423_ = -(_e1321);
                            } else {
                                phi_2423_ = _e1321;
                            }
                            let _e1642 = phi_2423_;
                            if (_e1324 < 0f) {
                                phi_2429_ = -(_e1324);
                            } else {
                                phi_2429_ = _e1324;
                            }
                            let _e1646 = phi_2429_;
                            if (_e1327 < 0f) {
                                phi_2436_ = -(_e1327);
                            } else {
                                phi_2436_ = _e1327;
                            }
                            let _e1651 = phi_2436_;
                            let _e1652 = ((_e1642 + _e1646) + _e1651);
                            if (_e1638 > _e1652) {
                                phi_2442_ = _e1638;
                            } else {
                                phi_2442_ = _e1652;
                            }
                            let _e1655 = phi_2442_;
                            if (_e1370 < 0f) {
                                phi_2448_ = -(_e1370);
                            } else {
                                phi_2448_ = _e1370;
                            }
                            let _e1659 = phi_2448_;
                            if (_e1371 < 0f) {
                                phi_2454_ = -(_e1371);
                            } else {
                                phi_2454_ = _e1371;
                            }
                            let _e1663 = phi_2454_;
                            if (_e1372 < 0f) {
                                phi_2461_ = -(_e1372);
                            } else {
                                phi_2461_ = _e1372;
                            }
                            let _e1668 = phi_2461_;
                            let _e1670 = (((_e1659 + _e1663) + _e1668) * 0.5f);
                            if (_e1655 > _e1670) {
                                phi_2468_ = _e1655;
                            } else {
                                phi_2468_ = _e1670;
                            }
                            let _e1673 = phi_2468_;
                            let _e1678 = local_7.member_3;
                            let _e1691 = ((((_e1375[0] * _e1300) + (_e1375[1] * _e1303)) + (_e1375[2] * _e1306)) * 3f);
                            let _e1692 = ((((_e1432[0] * _e1321) + (_e1432[1] * _e1324)) + (_e1432[2] * _e1327)) * 3f);
                            if (_e1691 < _e1692) {
                                phi_2492_ = _e1691;
                            } else {
                                phi_2492_ = _e1692;
                            }
                            let _e1695 = phi_2492_;
                            if (_e1406 < _e1429) {
                                phi_2497_ = _e1406;
                            } else {
                                phi_2497_ = _e1429;
                            }
                            let _e1698 = phi_2497_;
                            if (_e1695 < _e1698) {
                                phi_2502_ = _e1695;
                            } else {
                                phi_2502_ = _e1698;
                            }
                            let _e1701 = phi_2502_;
                            if (_e1691 > _e1692) {
                                phi_2507_ = _e1691;
                            } else {
                                phi_2507_ = _e1692;
                            }
                            let _e1704 = phi_2507_;
                            if (_e1406 > _e1429) {
                                phi_2512_ = _e1406;
                            } else {
                                phi_2512_ = _e1429;
                            }
                            let _e1707 = phi_2512_;
                            if (_e1704 > _e1707) {
                                phi_2517_ = _e1704;
                            } else {
                                phi_2517_ = _e1707;
                            }
                            let _e1710 = phi_2517_;
                            let _e1715 = -(_e1710);
                            if (_e1701 > _e1715) {
                                phi_2527_ = _e1701;
                            } else {
                                phi_2527_ = _e1715;
                            }
                            let _e1718 = phi_2527_;
                            if ((_e1718 - ((((((_e1494 * 8f) * _e1604) * (0.000000059604645f * (490f / 64f))) + ((_e1611 * 19f) * ((_e1494 * (_e1548 + _e1602)) + (_e1548 * _e1602)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1494) * ((1f + _e1548) * (1f + _e1602))))) + ((_e1208 * (((_e1673 + (_e1604 * (0.000000059604645f * 4f))) + ((_e1678 * 6f) * (_e1548 + _e1602))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1548) * (1f + _e1602))))) * (3f * 1.0001f)))) > 0f) {
                                phi_3503_ = true;
                            } else {
                                let _e1723 = local_7.member_1[0u];
                                let _e1729 = local_7.member_1[1u];
                                let _e1733 = (_e1723[0] + _e1729[0]);
                                let _e1734 = (_e1723[1] + _e1729[1]);
                                let _e1735 = (_e1723[2] + _e1729[2]);
                                let _e1738 = local_7.member_2[0u];
                                let _e1744 = local_7.member_2[1u];
                                let _e1748 = (_e1738[0] + _e1744[0]);
                                let _e1749 = (_e1738[1] + _e1744[1]);
                                let _e1750 = (_e1738[2] + _e1744[2]);
                                let _e1753 = ((_e1734 * _e1750) - (_e1735 * _e1749));
                                let _e1756 = ((_e1735 * _e1748) - (_e1733 * _e1750));
                                let _e1759 = ((_e1733 * _e1749) - (_e1734 * _e1748));
                                let _e1762 = local_7.member[0u];
                                let _e1768 = local_7.member_1[0u];
                                let _e1774 = local_7.member_2[0u];
                                let _e1778 = (_e1762[0] - _e1768[0]);
                                let _e1779 = (_e1762[1] - _e1768[1]);
                                let _e1780 = (_e1762[2] - _e1768[2]);
                                let _e1789 = local_7.member[1u];
                                let _e1795 = local_7.member_1[1u];
                                let _e1801 = local_7.member_2[1u];
                                let _e1805 = (_e1789[0] - _e1795[0]);
                                let _e1806 = (_e1789[1] - _e1795[1]);
                                let _e1807 = (_e1789[2] - _e1795[2]);
                                local_5 = array<array<f32, 3>, 4>(_e1762, array<f32, 3>(_e1778, _e1779, _e1780), array<f32, 3>((_e1762[0] - _e1774[0]), (_e1762[1] - _e1774[1]), (_e1762[2] - _e1774[2])), array<f32, 3>((_e1778 - _e1774[0]), (_e1779 - _e1774[1]), (_e1780 - _e1774[2])));
                                local_6 = array<array<f32, 3>, 4>(_e1789, array<f32, 3>(_e1805, _e1806, _e1807), array<f32, 3>((_e1789[0] - _e1801[0]), (_e1789[1] - _e1801[1]), (_e1789[2] - _e1801[2])), array<f32, 3>((_e1805 - _e1801[0]), (_e1806 - _e1801[1]), (_e1807 - _e1801[2])));
                                let _e1824 = local_7.member[0u];
                                if (_e1824[0] < 0f) {
                                    phi_2778_ = -(_e1824[0]);
                                } else {
                                    phi_2778_ = _e1824[0];
                                }
                                let _e1831 = phi_2778_;
                                if (_e1824[1] < 0f) {
                                    phi_2785_ = -(_e1824[1]);
                                } else {
                                    phi_2785_ = _e1824[1];
                                }
                                let _e1835 = phi_2785_;
                                if (_e1831 > _e1835) {
                                    phi_2790_ = _e1831;
                                } else {
                                    phi_2790_ = _e1835;
                                }
                                let _e1838 = phi_2790_;
                                if (_e1824[2] < 0f) {
                                    phi_2797_ = -(_e1824[2]);
                                } else {
                                    phi_2797_ = _e1824[2];
                                }
                                let _e1842 = phi_2797_;
                                if (_e1838 > _e1842) {
                                    phi_2802_ = _e1838;
                                } else {
                                    phi_2802_ = _e1842;
                                }
                                let _e1845 = phi_2802_;
                                let _e1848 = local_7.member[1u];
                                if (_e1848[0] < 0f) {
                                    phi_2815_ = -(_e1848[0]);
                                } else {
                                    phi_2815_ = _e1848[0];
                                }
                                let _e1855 = phi_2815_;
                                if (_e1848[1] < 0f) {
                                    phi_2822_ = -(_e1848[1]);
                                } else {
                                    phi_2822_ = _e1848[1];
                                }
                                let _e1859 = phi_2822_;
                                if (_e1855 > _e1859) {
                                    phi_2827_ = _e1855;
                                } else {
                                    phi_2827_ = _e1859;
                                }
                                let _e1862 = phi_2827_;
                                if (_e1848[2] < 0f) {
                                    phi_2834_ = -(_e1848[2]);
                                } else {
                                    phi_2834_ = _e1848[2];
                                }
                                let _e1866 = phi_2834_;
                                if (_e1862 > _e1866) {
                                    phi_2839_ = _e1862;
                                } else {
                                    phi_2839_ = _e1866;
                                }
                                let _e1869 = phi_2839_;
                                if (_e1845 > _e1869) {
                                    phi_2844_ = _e1845;
                                } else {
                                    phi_2844_ = _e1869;
                                }
                                let _e1872 = phi_2844_;
                                let _e1874 = local_7.member_3;
                                let _e1878 = local_7.member_1[0u];
                                if (_e1878[0] < 0f) {
                                    phi_2861_ = -(_e1878[0]);
                                } else {
                                    phi_2861_ = _e1878[0];
                                }
                                let _e1885 = phi_2861_;
                                if (_e1878[1] < 0f) {
                                    phi_2868_ = -(_e1878[1]);
                                } else {
                                    phi_2868_ = _e1878[1];
                                }
                                let _e1889 = phi_2868_;
                                if (_e1885 > _e1889) {
                                    phi_2873_ = _e1885;
                                } else {
                                    phi_2873_ = _e1889;
                                }
                                let _e1892 = phi_2873_;
                                if (_e1878[2] < 0f) {
                                    phi_2880_ = -(_e1878[2]);
                                } else {
                                    phi_2880_ = _e1878[2];
                                }
                                let _e1896 = phi_2880_;
                                if (_e1892 > _e1896) {
                                    phi_2885_ = _e1892;
                                } else {
                                    phi_2885_ = _e1896;
                                }
                                let _e1899 = phi_2885_;
                                let _e1902 = local_7.member_1[1u];
                                if (_e1902[0] < 0f) {
                                    phi_2899_ = -(_e1902[0]);
                                } else {
                                    phi_2899_ = _e1902[0];
                                }
                                let _e1909 = phi_2899_;
                                if (_e1902[1] < 0f) {
                                    phi_2906_ = -(_e1902[1]);
                                } else {
                                    phi_2906_ = _e1902[1];
                                }
                                let _e1913 = phi_2906_;
                                if (_e1909 > _e1913) {
                                    phi_2911_ = _e1909;
                                } else {
                                    phi_2911_ = _e1913;
                                }
                                let _e1916 = phi_2911_;
                                if (_e1902[2] < 0f) {
                                    phi_2918_ = -(_e1902[2]);
                                } else {
                                    phi_2918_ = _e1902[2];
                                }
                                let _e1920 = phi_2918_;
                                if (_e1916 > _e1920) {
                                    phi_2923_ = _e1916;
                                } else {
                                    phi_2923_ = _e1920;
                                }
                                let _e1923 = phi_2923_;
                                if (_e1899 > _e1923) {
                                    phi_2928_ = _e1899;
                                } else {
                                    phi_2928_ = _e1923;
                                }
                                let _e1926 = phi_2928_;
                                let _e1928 = local_7.member_3;
                                let _e1932 = local_7.member_2[0u];
                                if (_e1932[0] < 0f) {
                                    phi_2945_ = -(_e1932[0]);
                                } else {
                                    phi_2945_ = _e1932[0];
                                }
                                let _e1939 = phi_2945_;
                                if (_e1932[1] < 0f) {
                                    phi_2952_ = -(_e1932[1]);
                                } else {
                                    phi_2952_ = _e1932[1];
                                }
                                let _e1943 = phi_2952_;
                                if (_e1939 > _e1943) {
                                    phi_2957_ = _e1939;
                                } else {
                                    phi_2957_ = _e1943;
                                }
                                let _e1946 = phi_2957_;
                                if (_e1932[2] < 0f) {
                                    phi_2964_ = -(_e1932[2]);
                                } else {
                                    phi_2964_ = _e1932[2];
                                }
                                let _e1950 = phi_2964_;
                                if (_e1946 > _e1950) {
                                    phi_2969_ = _e1946;
                                } else {
                                    phi_2969_ = _e1950;
                                }
                                let _e1953 = phi_2969_;
                                let _e1956 = local_7.member_2[1u];
                                if (_e1956[0] < 0f) {
                                    phi_2983_ = -(_e1956[0]);
                                } else {
                                    phi_2983_ = _e1956[0];
                                }
                                let _e1963 = phi_2983_;
                                if (_e1956[1] < 0f) {
                                    phi_2990_ = -(_e1956[1]);
                                } else {
                                    phi_2990_ = _e1956[1];
                                }
                                let _e1967 = phi_2990_;
                                if (_e1963 > _e1967) {
                                    phi_2995_ = _e1963;
                                } else {
                                    phi_2995_ = _e1967;
                                }
                                let _e1970 = phi_2995_;
                                if (_e1956[2] < 0f) {
                                    phi_3002_ = -(_e1956[2]);
                                } else {
                                    phi_3002_ = _e1956[2];
                                }
                                let _e1974 = phi_3002_;
                                if (_e1970 > _e1974) {
                                    phi_3007_ = _e1970;
                                } else {
                                    phi_3007_ = _e1974;
                                }
                                let _e1977 = phi_3007_;
                                if (_e1953 > _e1977) {
                                    phi_3012_ = _e1953;
                                } else {
                                    phi_3012_ = _e1977;
                                }
                                let _e1980 = phi_3012_;
                                let _e1982 = local_7.member_3;
                                let _e1985 = (((_e1872 + _e1874) + (_e1926 + _e1928)) + (_e1980 + _e1982));
                                let _e1988 = local_7.member_3;
                                let _e1992 = (((_e1208 * 1.0001f) + (_e1988 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e1995 = ((_e1756 * _e1735) - (_e1759 * _e1734));
                                let _e1998 = ((_e1759 * _e1733) - (_e1753 * _e1735));
                                let _e2001 = ((_e1753 * _e1734) - (_e1756 * _e1733));
                                let _e2003 = local_5[0u];
                                let _e2011 = (((_e1995 * _e2003[0]) + (_e1998 * _e2003[1])) + (_e2001 * _e2003[2]));
                                phi_3050_ = type_37(0u, 4u);
                                phi_3053_ = _e2011;
                                phi_3055_ = _e2011;
                                loop {
                                    let _e2013 = phi_3050_;
                                    let _e2015 = phi_3053_;
                                    let _e2017 = phi_3055_;
                                    local_30 = _e2015;
                                    local_31 = _e2017;
                                    local_43 = _e2017;
                                    if (_e2013.member < _e2013.member_1) {
                                        phi_3051_ = type_37((_e2013.member + 1u), _e2013.member_1);
                                        phi_3078_ = type_37(1u, _e2013.member);
                                    } else {
                                        phi_3051_ = _e2013;
                                        phi_3078_ = type_37(0u, type_37().member_1);
                                    }
                                    let _e2031 = phi_3051_;
                                    let _e2033 = phi_3078_;
                                    let _e2037 = (bitcast<i32>(_e2033.member) != 0i);
                                    if _e2037 {
                                        if (_e2033.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2040 = local_5[_e2033.member_1];
                                        let _e2048 = (((_e1995 * _e2040[0]) + (_e1998 * _e2040[1])) + (_e2001 * _e2040[2]));
                                        if (_e2033.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2051 = local_6[_e2033.member_1];
                                        let _e2059 = (((_e1995 * _e2051[0]) + (_e1998 * _e2051[1])) + (_e2001 * _e2051[2]));
                                        if (_e2017 < _e2048) {
                                            phi_3128_ = _e2017;
                                        } else {
                                            phi_3128_ = _e2048;
                                        }
                                        let _e2062 = phi_3128_;
                                        if (_e2062 < _e2059) {
                                            phi_3133_ = _e2062;
                                        } else {
                                            phi_3133_ = _e2059;
                                        }
                                        let _e2065 = phi_3133_;
                                        if (_e2015 > _e2048) {
                                            phi_3138_ = _e2015;
                                        } else {
                                            phi_3138_ = _e2048;
                                        }
                                        let _e2068 = phi_3138_;
                                        if (_e2068 > _e2059) {
                                            phi_3143_ = _e2068;
                                        } else {
                                            phi_3143_ = _e2059;
                                        }
                                        let _e2071 = phi_3143_;
                                        phi_3054_ = _e2071;
                                        phi_3056_ = _e2065;
                                    } else {
                                        phi_3054_ = f32();
                                        phi_3056_ = f32();
                                    }
                                    let _e2073 = phi_3054_;
                                    let _e2075 = phi_3056_;
                                    continue;
                                    continuing {
                                        phi_3050_ = _e2031;
                                        phi_3053_ = _e2073;
                                        phi_3055_ = _e2075;
                                        break if !(_e2037);
                                    }
                                }
                                if (_e1995 < 0f) {
                                    phi_3149_ = -(_e1995);
                                } else {
                                    phi_3149_ = _e1995;
                                }
                                let _e2080 = phi_3149_;
                                if (_e1998 < 0f) {
                                    phi_3155_ = -(_e1998);
                                } else {
                                    phi_3155_ = _e1998;
                                }
                                let _e2084 = phi_3155_;
                                if (_e2001 < 0f) {
                                    phi_3162_ = -(_e2001);
                                } else {
                                    phi_3162_ = _e2001;
                                }
                                let _e2089 = phi_3162_;
                                let _e2090 = ((_e2080 + _e2084) + _e2089);
                                let _e2095 = local_30;
                                let _e2096 = -(_e2095);
                                let _e2098 = local_31;
                                if (_e2098 > _e2096) {
                                    let _e4546 = local_43;
                                    phi_3172_ = _e4546;
                                } else {
                                    phi_3172_ = _e2096;
                                }
                                let _e2101 = phi_3172_;
                                let _e2106 = (((_e2101 - ((_e2090 * _e1985) * (0.000000059604645f * 17f))) - (_e2090 * _e1992)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2109 = ((_e1756 * _e1750) - (_e1759 * _e1749));
                                let _e2112 = ((_e1759 * _e1748) - (_e1753 * _e1750));
                                let _e2115 = ((_e1753 * _e1749) - (_e1756 * _e1748));
                                let _e2117 = local_5[0u];
                                let _e2125 = (((_e2109 * _e2117[0]) + (_e2112 * _e2117[1])) + (_e2115 * _e2117[2]));
                                phi_3203_ = type_37(0u, 4u);
                                phi_3206_ = _e2125;
                                phi_3208_ = _e2125;
                                loop {
                                    let _e2127 = phi_3203_;
                                    let _e2129 = phi_3206_;
                                    let _e2131 = phi_3208_;
                                    local_32 = _e2129;
                                    local_33 = _e2131;
                                    local_44 = _e2131;
                                    if (_e2127.member < _e2127.member_1) {
                                        phi_3204_ = type_37((_e2127.member + 1u), _e2127.member_1);
                                        phi_3231_ = type_37(1u, _e2127.member);
                                    } else {
                                        phi_3204_ = _e2127;
                                        phi_3231_ = type_37(0u, type_37().member_1);
                                    }
                                    let _e2145 = phi_3204_;
                                    let _e2147 = phi_3231_;
                                    let _e2151 = (bitcast<i32>(_e2147.member) != 0i);
                                    if _e2151 {
                                        if (_e2147.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2154 = local_5[_e2147.member_1];
                                        let _e2162 = (((_e2109 * _e2154[0]) + (_e2112 * _e2154[1])) + (_e2115 * _e2154[2]));
                                        if (_e2147.member_1 < 4u) {
                                        } else {
                                            return;
                                        }
                                        let _e2165 = local_6[_e2147.member_1];
                                        let _e2173 = (((_e2109 * _e2165[0]) + (_e2112 * _e2165[1])) + (_e2115 * _e2165[2]));
                                        if (_e2131 < _e2162) {
                                            phi_3281_ = _e2131;
                                        } else {
                                            phi_3281_ = _e2162;
                                        }
                                        let _e2176 = phi_3281_;
                                        if (_e2176 < _e2173) {
                                            phi_3286_ = _e2176;
                                        } else {
                                            phi_3286_ = _e2173;
                                        }
                                        let _e2179 = phi_3286_;
                                        if (_e2129 > _e2162) {
                                            phi_3291_ = _e2129;
                                        } else {
                                            phi_3291_ = _e2162;
                                        }
                                        let _e2182 = phi_3291_;
                                        if (_e2182 > _e2173) {
                                            phi_3296_ = _e2182;
                                        } else {
                                            phi_3296_ = _e2173;
                                        }
                                        let _e2185 = phi_3296_;
                                        phi_3207_ = _e2185;
                                        phi_3209_ = _e2179;
                                    } else {
                                        phi_3207_ = f32();
                                        phi_3209_ = f32();
                                    }
                                    let _e2187 = phi_3207_;
                                    let _e2189 = phi_3209_;
                                    continue;
                                    continuing {
                                        phi_3203_ = _e2145;
                                        phi_3206_ = _e2187;
                                        phi_3208_ = _e2189;
                                        break if !(_e2151);
                                    }
                                }
                                if (_e2109 < 0f) {
                                    phi_3302_ = -(_e2109);
                                } else {
                                    phi_3302_ = _e2109;
                                }
                                let _e2194 = phi_3302_;
                                if (_e2112 < 0f) {
                                    phi_3308_ = -(_e2112);
                                } else {
                                    phi_3308_ = _e2112;
                                }
                                let _e2198 = phi_3308_;
                                if (_e2115 < 0f) {
                                    phi_3315_ = -(_e2115);
                                } else {
                                    phi_3315_ = _e2115;
                                }
                                let _e2203 = phi_3315_;
                                let _e2204 = ((_e2194 + _e2198) + _e2203);
                                let _e2209 = local_32;
                                let _e2210 = -(_e2209);
                                let _e2212 = local_33;
                                if (_e2212 > _e2210) {
                                    let _e4565 = local_44;
                                    phi_3325_ = _e4565;
                                } else {
                                    phi_3325_ = _e2210;
                                }
                                let _e2215 = phi_3325_;
                                let _e2220 = (((_e2215 - ((_e2204 * _e1985) * (0.000000059604645f * 17f))) - (_e2204 * _e1992)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2106 > _e2220) {
                                    phi_3335_ = _e2106;
                                } else {
                                    phi_3335_ = _e2220;
                                }
                                let _e2223 = phi_3335_;
                                phi_3503_ = (_e2223 > 0f);
                            }
                            let _e2226 = phi_3503_;
                            if _e2226 {
                                phi_6939_ = false;
                            } else {
                                let _e2229 = local_7.member[0u];
                                let _e2235 = local_7.member[1u];
                                let _e2242 = ((_e2229[0] + _e2235[0]) * 0.5f);
                                let _e2243 = ((_e2229[1] + _e2235[1]) * 0.5f);
                                let _e2244 = ((_e2229[2] + _e2235[2]) * 0.5f);
                                let _e2247 = local_7.member_1[0u];
                                let _e2253 = local_7.member_1[1u];
                                let _e2260 = ((_e2247[0] + _e2253[0]) * 0.5f);
                                let _e2261 = ((_e2247[1] + _e2253[1]) * 0.5f);
                                let _e2262 = ((_e2247[2] + _e2253[2]) * 0.5f);
                                let _e2265 = local_7.member_2[0u];
                                let _e2271 = local_7.member_2[1u];
                                let _e2278 = ((_e2265[0] + _e2271[0]) * 0.5f);
                                let _e2279 = ((_e2265[1] + _e2271[1]) * 0.5f);
                                let _e2280 = ((_e2265[2] + _e2271[2]) * 0.5f);
                                let _e2283 = local_7.member[0u];
                                let _e2286 = local_7.member_1[0u];
                                let _e2289 = local_7.member_2[0u];
                                let _e2291 = local_7.member_3;
                                let _e2294 = local_7.member[1u];
                                let _e2297 = local_7.member_1[1u];
                                let _e2300 = local_7.member_2[1u];
                                let _e2302 = local_7.member_3;
                                local_4 = array<type_72, 2>(type_72(array<array<f32, 3>, 2>(_e2283, array<f32, 3>(_e2242, _e2243, _e2244)), array<array<f32, 3>, 2>(_e2286, array<f32, 3>(_e2260, _e2261, _e2262)), array<array<f32, 3>, 2>(_e2289, array<f32, 3>(_e2278, _e2279, _e2280)), _e2291), type_72(array<array<f32, 3>, 2>(array<f32, 3>(_e2242, _e2243, _e2244), _e2294), array<array<f32, 3>, 2>(array<f32, 3>(_e2260, _e2261, _e2262), _e2297), array<array<f32, 3>, 2>(array<f32, 3>(_e2278, _e2279, _e2280), _e2300), _e2302));
                                let _e2321 = local_4[0u].member_1[0u];
                                let _e2327 = local_4[0u].member_2[0u];
                                let _e2333 = ((_e2321[1] * _e2327[2]) - (_e2321[2] * _e2327[1]));
                                let _e2336 = ((_e2321[2] * _e2327[0]) - (_e2321[0] * _e2327[2]));
                                let _e2339 = ((_e2321[0] * _e2327[1]) - (_e2321[1] * _e2327[0]));
                                let _e2342 = local_4[0u].member_1[1u];
                                let _e2348 = local_4[0u].member_2[1u];
                                let _e2354 = ((_e2342[1] * _e2348[2]) - (_e2342[2] * _e2348[1]));
                                let _e2357 = ((_e2342[2] * _e2348[0]) - (_e2342[0] * _e2348[2]));
                                let _e2360 = ((_e2342[0] * _e2348[1]) - (_e2342[1] * _e2348[0]));
                                let _e2363 = local_4[0u].member_1[0u];
                                let _e2369 = local_4[0u].member_2[1u];
                                let _e2384 = local_4[0u].member_1[1u];
                                let _e2390 = local_4[0u].member_2[0u];
                                let _e2403 = (((_e2363[1] * _e2369[2]) - (_e2363[2] * _e2369[1])) + ((_e2384[1] * _e2390[2]) - (_e2384[2] * _e2390[1])));
                                let _e2404 = (((_e2363[2] * _e2369[0]) - (_e2363[0] * _e2369[2])) + ((_e2384[2] * _e2390[0]) - (_e2384[0] * _e2390[2])));
                                let _e2405 = (((_e2363[0] * _e2369[1]) - (_e2363[1] * _e2369[0])) + ((_e2384[0] * _e2390[1]) - (_e2384[1] * _e2390[0])));
                                let _e2408 = local_4[0u].member[0u];
                                let _e2419 = local_4[0u].member[1u];
                                let _e2430 = local_4[0u].member[0u];
                                let _e2439 = ((((_e2419[0] * _e2333) + (_e2419[1] * _e2336)) + (_e2419[2] * _e2339)) + (((_e2430[0] * _e2403) + (_e2430[1] * _e2404)) + (_e2430[2] * _e2405)));
                                let _e2442 = local_4[0u].member[0u];
                                let _e2453 = local_4[0u].member[1u];
                                let _e2462 = ((((_e2442[0] * _e2354) + (_e2442[1] * _e2357)) + (_e2442[2] * _e2360)) + (((_e2453[0] * _e2403) + (_e2453[1] * _e2404)) + (_e2453[2] * _e2405)));
                                let _e2465 = local_4[0u].member[1u];
                                let _e2476 = local_4[0u].member[0u];
                                if (_e2476[0] < 0f) {
                                    phi_3960_ = -(_e2476[0]);
                                } else {
                                    phi_3960_ = _e2476[0];
                                }
                                let _e2483 = phi_3960_;
                                if (_e2476[1] < 0f) {
                                    phi_3967_ = -(_e2476[1]);
                                } else {
                                    phi_3967_ = _e2476[1];
                                }
                                let _e2487 = phi_3967_;
                                if (_e2483 > _e2487) {
                                    phi_3972_ = _e2483;
                                } else {
                                    phi_3972_ = _e2487;
                                }
                                let _e2490 = phi_3972_;
                                if (_e2476[2] < 0f) {
                                    phi_3979_ = -(_e2476[2]);
                                } else {
                                    phi_3979_ = _e2476[2];
                                }
                                let _e2494 = phi_3979_;
                                if (_e2490 > _e2494) {
                                    phi_3984_ = _e2490;
                                } else {
                                    phi_3984_ = _e2494;
                                }
                                let _e2497 = phi_3984_;
                                let _e2500 = local_4[0u].member[1u];
                                if (_e2500[0] < 0f) {
                                    phi_3997_ = -(_e2500[0]);
                                } else {
                                    phi_3997_ = _e2500[0];
                                }
                                let _e2507 = phi_3997_;
                                if (_e2500[1] < 0f) {
                                    phi_4004_ = -(_e2500[1]);
                                } else {
                                    phi_4004_ = _e2500[1];
                                }
                                let _e2511 = phi_4004_;
                                if (_e2507 > _e2511) {
                                    phi_4009_ = _e2507;
                                } else {
                                    phi_4009_ = _e2511;
                                }
                                let _e2514 = phi_4009_;
                                if (_e2500[2] < 0f) {
                                    phi_4016_ = -(_e2500[2]);
                                } else {
                                    phi_4016_ = _e2500[2];
                                }
                                let _e2518 = phi_4016_;
                                if (_e2514 > _e2518) {
                                    phi_4021_ = _e2514;
                                } else {
                                    phi_4021_ = _e2518;
                                }
                                let _e2521 = phi_4021_;
                                if (_e2497 > _e2521) {
                                    phi_4026_ = _e2497;
                                } else {
                                    phi_4026_ = _e2521;
                                }
                                let _e2524 = phi_4026_;
                                let _e2526 = local_4[0u].member_3;
                                let _e2527 = (_e2524 + _e2526);
                                let _e2530 = local_4[0u].member_1[0u];
                                if (_e2530[0] < 0f) {
                                    phi_4043_ = -(_e2530[0]);
                                } else {
                                    phi_4043_ = _e2530[0];
                                }
                                let _e2537 = phi_4043_;
                                if (_e2530[1] < 0f) {
                                    phi_4050_ = -(_e2530[1]);
                                } else {
                                    phi_4050_ = _e2530[1];
                                }
                                let _e2541 = phi_4050_;
                                if (_e2537 > _e2541) {
                                    phi_4055_ = _e2537;
                                } else {
                                    phi_4055_ = _e2541;
                                }
                                let _e2544 = phi_4055_;
                                if (_e2530[2] < 0f) {
                                    phi_4062_ = -(_e2530[2]);
                                } else {
                                    phi_4062_ = _e2530[2];
                                }
                                let _e2548 = phi_4062_;
                                if (_e2544 > _e2548) {
                                    phi_4067_ = _e2544;
                                } else {
                                    phi_4067_ = _e2548;
                                }
                                let _e2551 = phi_4067_;
                                let _e2554 = local_4[0u].member_1[1u];
                                if (_e2554[0] < 0f) {
                                    phi_4081_ = -(_e2554[0]);
                                } else {
                                    phi_4081_ = _e2554[0];
                                }
                                let _e2561 = phi_4081_;
                                if (_e2554[1] < 0f) {
                                    phi_4088_ = -(_e2554[1]);
                                } else {
                                    phi_4088_ = _e2554[1];
                                }
                                let _e2565 = phi_4088_;
                                if (_e2561 > _e2565) {
                                    phi_4093_ = _e2561;
                                } else {
                                    phi_4093_ = _e2565;
                                }
                                let _e2568 = phi_4093_;
                                if (_e2554[2] < 0f) {
                                    phi_4100_ = -(_e2554[2]);
                                } else {
                                    phi_4100_ = _e2554[2];
                                }
                                let _e2572 = phi_4100_;
                                if (_e2568 > _e2572) {
                                    phi_4105_ = _e2568;
                                } else {
                                    phi_4105_ = _e2572;
                                }
                                let _e2575 = phi_4105_;
                                if (_e2551 > _e2575) {
                                    phi_4110_ = _e2551;
                                } else {
                                    phi_4110_ = _e2575;
                                }
                                let _e2578 = phi_4110_;
                                let _e2580 = local_4[0u].member_3;
                                let _e2581 = (_e2578 + _e2580);
                                let _e2584 = local_4[0u].member_2[0u];
                                if (_e2584[0] < 0f) {
                                    phi_4127_ = -(_e2584[0]);
                                } else {
                                    phi_4127_ = _e2584[0];
                                }
                                let _e2591 = phi_4127_;
                                if (_e2584[1] < 0f) {
                                    phi_4134_ = -(_e2584[1]);
                                } else {
                                    phi_4134_ = _e2584[1];
                                }
                                let _e2595 = phi_4134_;
                                if (_e2591 > _e2595) {
                                    phi_4139_ = _e2591;
                                } else {
                                    phi_4139_ = _e2595;
                                }
                                let _e2598 = phi_4139_;
                                if (_e2584[2] < 0f) {
                                    phi_4146_ = -(_e2584[2]);
                                } else {
                                    phi_4146_ = _e2584[2];
                                }
                                let _e2602 = phi_4146_;
                                if (_e2598 > _e2602) {
                                    phi_4151_ = _e2598;
                                } else {
                                    phi_4151_ = _e2602;
                                }
                                let _e2605 = phi_4151_;
                                let _e2608 = local_4[0u].member_2[1u];
                                if (_e2608[0] < 0f) {
                                    phi_4165_ = -(_e2608[0]);
                                } else {
                                    phi_4165_ = _e2608[0];
                                }
                                let _e2615 = phi_4165_;
                                if (_e2608[1] < 0f) {
                                    phi_4172_ = -(_e2608[1]);
                                } else {
                                    phi_4172_ = _e2608[1];
                                }
                                let _e2619 = phi_4172_;
                                if (_e2615 > _e2619) {
                                    phi_4177_ = _e2615;
                                } else {
                                    phi_4177_ = _e2619;
                                }
                                let _e2622 = phi_4177_;
                                if (_e2608[2] < 0f) {
                                    phi_4184_ = -(_e2608[2]);
                                } else {
                                    phi_4184_ = _e2608[2];
                                }
                                let _e2626 = phi_4184_;
                                if (_e2622 > _e2626) {
                                    phi_4189_ = _e2622;
                                } else {
                                    phi_4189_ = _e2626;
                                }
                                let _e2629 = phi_4189_;
                                if (_e2605 > _e2629) {
                                    phi_4194_ = _e2605;
                                } else {
                                    phi_4194_ = _e2629;
                                }
                                let _e2632 = phi_4194_;
                                let _e2634 = local_4[0u].member_3;
                                let _e2635 = (_e2632 + _e2634);
                                let _e2637 = ((_e2581 * 8f) * _e2635);
                                let _e2644 = local_4[0u].member_3;
                                if (_e2333 < 0f) {
                                    phi_4225_ = -(_e2333);
                                } else {
                                    phi_4225_ = _e2333;
                                }
                                let _e2661 = phi_4225_;
                                if (_e2336 < 0f) {
                                    phi_4231_ = -(_e2336);
                                } else {
                                    phi_4231_ = _e2336;
                                }
                                let _e2665 = phi_4231_;
                                if (_e2339 < 0f) {
                                    phi_4238_ = -(_e2339);
                                } else {
                                    phi_4238_ = _e2339;
                                }
                                let _e2670 = phi_4238_;
                                let _e2671 = ((_e2661 + _e2665) + _e2670);
                                if (_e2354 < 0f) {
                                    phi_4245_ = -(_e2354);
                                } else {
                                    phi_4245_ = _e2354;
                                }
                                let _e2675 = phi_4245_;
                                if (_e2357 < 0f) {
                                    phi_4251_ = -(_e2357);
                                } else {
                                    phi_4251_ = _e2357;
                                }
                                let _e2679 = phi_4251_;
                                if (_e2360 < 0f) {
                                    phi_4258_ = -(_e2360);
                                } else {
                                    phi_4258_ = _e2360;
                                }
                                let _e2684 = phi_4258_;
                                let _e2685 = ((_e2675 + _e2679) + _e2684);
                                if (_e2671 > _e2685) {
                                    phi_4264_ = _e2671;
                                } else {
                                    phi_4264_ = _e2685;
                                }
                                let _e2688 = phi_4264_;
                                if (_e2403 < 0f) {
                                    phi_4270_ = -(_e2403);
                                } else {
                                    phi_4270_ = _e2403;
                                }
                                let _e2692 = phi_4270_;
                                if (_e2404 < 0f) {
                                    phi_4276_ = -(_e2404);
                                } else {
                                    phi_4276_ = _e2404;
                                }
                                let _e2696 = phi_4276_;
                                if (_e2405 < 0f) {
                                    phi_4283_ = -(_e2405);
                                } else {
                                    phi_4283_ = _e2405;
                                }
                                let _e2701 = phi_4283_;
                                let _e2703 = (((_e2692 + _e2696) + _e2701) * 0.5f);
                                if (_e2688 > _e2703) {
                                    phi_4290_ = _e2688;
                                } else {
                                    phi_4290_ = _e2703;
                                }
                                let _e2706 = phi_4290_;
                                let _e2711 = local_4[0u].member_3;
                                let _e2724 = ((((_e2408[0] * _e2333) + (_e2408[1] * _e2336)) + (_e2408[2] * _e2339)) * 3f);
                                let _e2725 = ((((_e2465[0] * _e2354) + (_e2465[1] * _e2357)) + (_e2465[2] * _e2360)) * 3f);
                                if (_e2724 < _e2725) {
                                    phi_4314_ = _e2724;
                                } else {
                                    phi_4314_ = _e2725;
                                }
                                let _e2728 = phi_4314_;
                                if (_e2439 < _e2462) {
                                    phi_4319_ = _e2439;
                                } else {
                                    phi_4319_ = _e2462;
                                }
                                let _e2731 = phi_4319_;
                                if (_e2728 < _e2731) {
                                    phi_4324_ = _e2728;
                                } else {
                                    phi_4324_ = _e2731;
                                }
                                let _e2734 = phi_4324_;
                                if (_e2724 > _e2725) {
                                    phi_4329_ = _e2724;
                                } else {
                                    phi_4329_ = _e2725;
                                }
                                let _e2737 = phi_4329_;
                                if (_e2439 > _e2462) {
                                    phi_4334_ = _e2439;
                                } else {
                                    phi_4334_ = _e2462;
                                }
                                let _e2740 = phi_4334_;
                                if (_e2737 > _e2740) {
                                    phi_4339_ = _e2737;
                                } else {
                                    phi_4339_ = _e2740;
                                }
                                let _e2743 = phi_4339_;
                                let _e2748 = -(_e2743);
                                if (_e2734 > _e2748) {
                                    phi_4349_ = _e2734;
                                } else {
                                    phi_4349_ = _e2748;
                                }
                                let _e2751 = phi_4349_;
                                if ((_e2751 - ((((((_e2527 * 8f) * _e2637) * (0.000000059604645f * (490f / 64f))) + ((_e2644 * 19f) * ((_e2527 * (_e2581 + _e2635)) + (_e2581 * _e2635)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2527) * ((1f + _e2581) * (1f + _e2635))))) + ((_e1208 * (((_e2706 + (_e2637 * (0.000000059604645f * 4f))) + ((_e2711 * 6f) * (_e2581 + _e2635))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2581) * (1f + _e2635))))) * (3f * 1.0001f)))) > 0f) {
                                    phi_5325_ = true;
                                } else {
                                    let _e2756 = local_4[0u].member_1[0u];
                                    let _e2762 = local_4[0u].member_1[1u];
                                    let _e2766 = (_e2756[0] + _e2762[0]);
                                    let _e2767 = (_e2756[1] + _e2762[1]);
                                    let _e2768 = (_e2756[2] + _e2762[2]);
                                    let _e2771 = local_4[0u].member_2[0u];
                                    let _e2777 = local_4[0u].member_2[1u];
                                    let _e2781 = (_e2771[0] + _e2777[0]);
                                    let _e2782 = (_e2771[1] + _e2777[1]);
                                    let _e2783 = (_e2771[2] + _e2777[2]);
                                    let _e2786 = ((_e2767 * _e2783) - (_e2768 * _e2782));
                                    let _e2789 = ((_e2768 * _e2781) - (_e2766 * _e2783));
                                    let _e2792 = ((_e2766 * _e2782) - (_e2767 * _e2781));
                                    let _e2795 = local_4[0u].member[0u];
                                    let _e2801 = local_4[0u].member_1[0u];
                                    let _e2807 = local_4[0u].member_2[0u];
                                    let _e2811 = (_e2795[0] - _e2801[0]);
                                    let _e2812 = (_e2795[1] - _e2801[1]);
                                    let _e2813 = (_e2795[2] - _e2801[2]);
                                    let _e2822 = local_4[0u].member[1u];
                                    let _e2828 = local_4[0u].member_1[1u];
                                    let _e2834 = local_4[0u].member_2[1u];
                                    let _e2838 = (_e2822[0] - _e2828[0]);
                                    let _e2839 = (_e2822[1] - _e2828[1]);
                                    let _e2840 = (_e2822[2] - _e2828[2]);
                                    local_2 = array<array<f32, 3>, 4>(_e2795, array<f32, 3>(_e2811, _e2812, _e2813), array<f32, 3>((_e2795[0] - _e2807[0]), (_e2795[1] - _e2807[1]), (_e2795[2] - _e2807[2])), array<f32, 3>((_e2811 - _e2807[0]), (_e2812 - _e2807[1]), (_e2813 - _e2807[2])));
                                    local_3 = array<array<f32, 3>, 4>(_e2822, array<f32, 3>(_e2838, _e2839, _e2840), array<f32, 3>((_e2822[0] - _e2834[0]), (_e2822[1] - _e2834[1]), (_e2822[2] - _e2834[2])), array<f32, 3>((_e2838 - _e2834[0]), (_e2839 - _e2834[1]), (_e2840 - _e2834[2])));
                                    let _e2857 = local_4[0u].member[0u];
                                    if (_e2857[0] < 0f) {
                                        phi_4600_ = -(_e2857[0]);
                                    } else {
                                        phi_4600_ = _e2857[0];
                                    }
                                    let _e2864 = phi_4600_;
                                    if (_e2857[1] < 0f) {
                                        phi_4607_ = -(_e2857[1]);
                                    } else {
                                        phi_4607_ = _e2857[1];
                                    }
                                    let _e2868 = phi_4607_;
                                    if (_e2864 > _e2868) {
                                        phi_4612_ = _e2864;
                                    } else {
                                        phi_4612_ = _e2868;
                                    }
                                    let _e2871 = phi_4612_;
                                    if (_e2857[2] < 0f) {
                                        phi_4619_ = -(_e2857[2]);
                                    } else {
                                        phi_4619_ = _e2857[2];
                                    }
                                    let _e2875 = phi_4619_;
                                    if (_e2871 > _e2875) {
                                        phi_4624_ = _e2871;
                                    } else {
                                        phi_4624_ = _e2875;
                                    }
                                    let _e2878 = phi_4624_;
                                    let _e2881 = local_4[0u].member[1u];
                                    if (_e2881[0] < 0f) {
                                        phi_4637_ = -(_e2881[0]);
                                    } else {
                                        phi_4637_ = _e2881[0];
                                    }
                                    let _e2888 = phi_4637_;
                                    if (_e2881[1] < 0f) {
                                        phi_4644_ = -(_e2881[1]);
                                    } else {
                                        phi_4644_ = _e2881[1];
                                    }
                                    let _e2892 = phi_4644_;
                                    if (_e2888 > _e2892) {
                                        phi_4649_ = _e2888;
                                    } else {
                                        phi_4649_ = _e2892;
                                    }
                                    let _e2895 = phi_4649_;
                                    if (_e2881[2] < 0f) {
                                        phi_4656_ = -(_e2881[2]);
                                    } else {
                                        phi_4656_ = _e2881[2];
                                    }
                                    let _e2899 = phi_4656_;
                                    if (_e2895 > _e2899) {
                                        phi_4661_ = _e2895;
                                    } else {
                                        phi_4661_ = _e2899;
                                    }
                                    let _e2902 = phi_4661_;
                                    if (_e2878 > _e2902) {
                                        phi_4666_ = _e2878;
                                    } else {
                                        phi_4666_ = _e2902;
                                    }
                                    let _e2905 = phi_4666_;
                                    let _e2907 = local_4[0u].member_3;
                                    let _e2911 = local_4[0u].member_1[0u];
                                    if (_e2911[0] < 0f) {
                                        phi_4683_ = -(_e2911[0]);
                                    } else {
                                        phi_4683_ = _e2911[0];
                                    }
                                    let _e2918 = phi_4683_;
                                    if (_e2911[1] < 0f) {
                                        phi_4690_ = -(_e2911[1]);
                                    } else {
                                        phi_4690_ = _e2911[1];
                                    }
                                    let _e2922 = phi_4690_;
                                    if (_e2918 > _e2922) {
                                        phi_4695_ = _e2918;
                                    } else {
                                        phi_4695_ = _e2922;
                                    }
                                    let _e2925 = phi_4695_;
                                    if (_e2911[2] < 0f) {
                                        phi_4702_ = -(_e2911[2]);
                                    } else {
                                        phi_4702_ = _e2911[2];
                                    }
                                    let _e2929 = phi_4702_;
                                    if (_e2925 > _e2929) {
                                        phi_4707_ = _e2925;
                                    } else {
                                        phi_4707_ = _e2929;
                                    }
                                    let _e2932 = phi_4707_;
                                    let _e2935 = local_4[0u].member_1[1u];
                                    if (_e2935[0] < 0f) {
                                        phi_4721_ = -(_e2935[0]);
                                    } else {
                                        phi_4721_ = _e2935[0];
                                    }
                                    let _e2942 = phi_4721_;
                                    if (_e2935[1] < 0f) {
                                        phi_4728_ = -(_e2935[1]);
                                    } else {
                                        phi_4728_ = _e2935[1];
                                    }
                                    let _e2946 = phi_4728_;
                                    if (_e2942 > _e2946) {
                                        phi_4733_ = _e2942;
                                    } else {
                                        phi_4733_ = _e2946;
                                    }
                                    let _e2949 = phi_4733_;
                                    if (_e2935[2] < 0f) {
                                        phi_4740_ = -(_e2935[2]);
                                    } else {
                                        phi_4740_ = _e2935[2];
                                    }
                                    let _e2953 = phi_4740_;
                                    if (_e2949 > _e2953) {
                                        phi_4745_ = _e2949;
                                    } else {
                                        phi_4745_ = _e2953;
                                    }
                                    let _e2956 = phi_4745_;
                                    if (_e2932 > _e2956) {
                                        phi_4750_ = _e2932;
                                    } else {
                                        phi_4750_ = _e2956;
                                    }
                                    let _e2959 = phi_4750_;
                                    let _e2961 = local_4[0u].member_3;
                                    let _e2965 = local_4[0u].member_2[0u];
                                    if (_e2965[0] < 0f) {
                                        phi_4767_ = -(_e2965[0]);
                                    } else {
                                        phi_4767_ = _e2965[0];
                                    }
                                    let _e2972 = phi_4767_;
                                    if (_e2965[1] < 0f) {
                                        phi_4774_ = -(_e2965[1]);
                                    } else {
                                        phi_4774_ = _e2965[1];
                                    }
                                    let _e2976 = phi_4774_;
                                    if (_e2972 > _e2976) {
                                        phi_4779_ = _e2972;
                                    } else {
                                        phi_4779_ = _e2976;
                                    }
                                    let _e2979 = phi_4779_;
                                    if (_e2965[2] < 0f) {
                                        phi_4786_ = -(_e2965[2]);
                                    } else {
                                        phi_4786_ = _e2965[2];
                                    }
                                    let _e2983 = phi_4786_;
                                    if (_e2979 > _e2983) {
                                        phi_4791_ = _e2979;
                                    } else {
                                        phi_4791_ = _e2983;
                                    }
                                    let _e2986 = phi_4791_;
                                    let _e2989 = local_4[0u].member_2[1u];
                                    if (_e2989[0] < 0f) {
                                        phi_4805_ = -(_e2989[0]);
                                    } else {
                                        phi_4805_ = _e2989[0];
                                    }
                                    let _e2996 = phi_4805_;
                                    if (_e2989[1] < 0f) {
                                        phi_4812_ = -(_e2989[1]);
                                    } else {
                                        phi_4812_ = _e2989[1];
                                    }
                                    let _e3000 = phi_4812_;
                                    if (_e2996 > _e3000) {
                                        phi_4817_ = _e2996;
                                    } else {
                                        phi_4817_ = _e3000;
                                    }
                                    let _e3003 = phi_4817_;
                                    if (_e2989[2] < 0f) {
                                        phi_4824_ = -(_e2989[2]);
                                    } else {
                                        phi_4824_ = _e2989[2];
                                    }
                                    let _e3007 = phi_4824_;
                                    if (_e3003 > _e3007) {
                                        phi_4829_ = _e3003;
                                    } else {
                                        phi_4829_ = _e3007;
                                    }
                                    let _e3010 = phi_4829_;
                                    if (_e2986 > _e3010) {
                                        phi_4834_ = _e2986;
                                    } else {
                                        phi_4834_ = _e3010;
                                    }
                                    let _e3013 = phi_4834_;
                                    let _e3015 = local_4[0u].member_3;
                                    let _e3018 = (((_e2905 + _e2907) + (_e2959 + _e2961)) + (_e3013 + _e3015));
                                    let _e3021 = local_4[0u].member_3;
                                    let _e3025 = (((_e1208 * 1.0001f) + (_e3021 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3028 = ((_e2789 * _e2768) - (_e2792 * _e2767));
                                    let _e3031 = ((_e2792 * _e2766) - (_e2786 * _e2768));
                                    let _e3034 = ((_e2786 * _e2767) - (_e2789 * _e2766));
                                    let _e3036 = local_2[0u];
                                    let _e3044 = (((_e3028 * _e3036[0]) + (_e3031 * _e3036[1])) + (_e3034 * _e3036[2]));
                                    phi_4872_ = type_37(0u, 4u);
                                    phi_4875_ = _e3044;
                                    phi_4877_ = _e3044;
                                    loop {
                                        let _e3046 = phi_4872_;
                                        let _e3048 = phi_4875_;
                                        let _e3050 = phi_4877_;
                                        local_34 = _e3048;
                                        local_35 = _e3050;
                                        local_45 = _e3050;
                                        if (_e3046.member < _e3046.member_1) {
                                            phi_4873_ = type_37((_e3046.member + 1u), _e3046.member_1);
                                            phi_4900_ = type_37(1u, _e3046.member);
                                        } else {
                                            phi_4873_ = _e3046;
                                            phi_4900_ = type_37(0u, type_37().member_1);
                                        }
                                        let _e3064 = phi_4873_;
                                        let _e3066 = phi_4900_;
                                        let _e3070 = (bitcast<i32>(_e3066.member) != 0i);
                                        if _e3070 {
                                            if (_e3066.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3073 = local_2[_e3066.member_1];
                                            let _e3081 = (((_e3028 * _e3073[0]) + (_e3031 * _e3073[1])) + (_e3034 * _e3073[2]));
                                            if (_e3066.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3084 = local_3[_e3066.member_1];
                                            let _e3092 = (((_e3028 * _e3084[0]) + (_e3031 * _e3084[1])) + (_e3034 * _e3084[2]));
                                            if (_e3050 < _e3081) {
                                                phi_4950_ = _e3050;
                                            } else {
                                                phi_4950_ = _e3081;
                                            }
                                            let _e3095 = phi_4950_;
                                            if (_e3095 < _e3092) {
                                                phi_4955_ = _e3095;
                                            } else {
                                                phi_4955_ = _e3092;
                                            }
                                            let _e3098 = phi_4955_;
                                            if (_e3048 > _e3081) {
                                                phi_4960_ = _e3048;
                                            } else {
                                                phi_4960_ = _e3081;
                                            }
                                            let _e3101 = phi_4960_;
                                            if (_e3101 > _e3092) {
                                                phi_4965_ = _e3101;
                                            } else {
                                                phi_4965_ = _e3092;
                                            }
                                            let _e3104 = phi_4965_;
                                            phi_4876_ = _e3104;
                                            phi_4878_ = _e3098;
                                        } else {
                                            phi_4876_ = f32();
                                            phi_4878_ = f32();
                                        }
                                        let _e3106 = phi_4876_;
                                        let _e3108 = phi_4878_;
                                        continue;
                                        continuing {
                                            phi_4872_ = _e3064;
                                            phi_4875_ = _e3106;
                                            phi_4877_ = _e3108;
                                            break if !(_e3070);
                                        }
                                    }
                                    if (_e3028 < 0f) {
                                        phi_4971_ = -(_e3028);
                                    } else {
                                        phi_4971_ = _e3028;
                                    }
                                    let _e3113 = phi_4971_;
                                    if (_e3031 < 0f) {
                                        phi_4977_ = -(_e3031);
                                    } else {
                                        phi_4977_ = _e3031;
                                    }
                                    let _e3117 = phi_4977_;
                                    if (_e3034 < 0f) {
                                        phi_4984_ = -(_e3034);
                                    } else {
                                        phi_4984_ = _e3034;
                                    }
                                    let _e3122 = phi_4984_;
                                    let _e3123 = ((_e3113 + _e3117) + _e3122);
                                    let _e3128 = local_34;
                                    let _e3129 = -(_e3128);
                                    let _e3131 = local_35;
                                    if (_e3131 > _e3129) {
                                        let _e4670 = local_45;
                                        phi_4994_ = _e4670;
                                    } else {
                                        phi_4994_ = _e3129;
                                    }
                                    let _e3134 = phi_4994_;
                                    let _e3139 = (((_e3134 - ((_e3123 * _e3018) * (0.000000059604645f * 17f))) - (_e3123 * _e3025)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3142 = ((_e2789 * _e2783) - (_e2792 * _e2782));
                                    let _e3145 = ((_e2792 * _e2781) - (_e2786 * _e2783));
                                    let _e3148 = ((_e2786 * _e2782) - (_e2789 * _e2781));
                                    let _e3150 = local_2[0u];
                                    let _e3158 = (((_e3142 * _e3150[0]) + (_e3145 * _e3150[1])) + (_e3148 * _e3150[2]));
                                    phi_5025_ = type_37(0u, 4u);
                                    phi_5028_ = _e3158;
                                    phi_5030_ = _e3158;
                                    loop {
                                        let _e3160 = phi_5025_;
                                        let _e3162 = phi_5028_;
                                        let _e3164 = phi_5030_;
                                        local_36 = _e3162;
                                        local_37 = _e3164;
                                        local_46 = _e3164;
                                        if (_e3160.member < _e3160.member_1) {
                                            phi_5026_ = type_37((_e3160.member + 1u), _e3160.member_1);
                                            phi_5053_ = type_37(1u, _e3160.member);
                                        } else {
                                            phi_5026_ = _e3160;
                                            phi_5053_ = type_37(0u, type_37().member_1);
                                        }
                                        let _e3178 = phi_5026_;
                                        let _e3180 = phi_5053_;
                                        let _e3184 = (bitcast<i32>(_e3180.member) != 0i);
                                        if _e3184 {
                                            if (_e3180.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3187 = local_2[_e3180.member_1];
                                            let _e3195 = (((_e3142 * _e3187[0]) + (_e3145 * _e3187[1])) + (_e3148 * _e3187[2]));
                                            if (_e3180.member_1 < 4u) {
                                            } else {
                                                return;
                                            }
                                            let _e3198 = local_3[_e3180.member_1];
                                            let _e3206 = (((_e3142 * _e3198[0]) + (_e3145 * _e3198[1])) + (_e3148 * _e3198[2]));
                                            if (_e3164 < _e3195) {
                                                phi_5103_ = _e3164;
                                            } else {
                                                phi_5103_ = _e3195;
                                            }
                                            let _e3209 = phi_5103_;
                                            if (_e3209 < _e3206) {
                                                phi_5108_ = _e3209;
                                            } else {
                                                phi_5108_ = _e3206;
                                            }
                                            let _e3212 = phi_5108_;
                                            if (_e3162 > _e3195) {
                                                phi_5113_ = _e3162;
                                            } else {
                                                phi_5113_ = _e3195;
                                            }
                                            let _e3215 = phi_5113_;
                                            if (_e3215 > _e3206) {
                                                phi_5118_ = _e3215;
                                            } else {
                                                phi_5118_ = _e3206;
                                            }
                                            let _e3218 = phi_5118_;
                                            phi_5029_ = _e3218;
                                            phi_5031_ = _e3212;
                                        } else {
                                            phi_5029_ = f32();
                                            phi_5031_ = f32();
                                        }
                                        let _e3220 = phi_5029_;
                                        let _e3222 = phi_5031_;
                                        continue;
                                        continuing {
                                            phi_5025_ = _e3178;
                                            phi_5028_ = _e3220;
                                            phi_5030_ = _e3222;
                                            break if !(_e3184);
                                        }
                                    }
                                    if (_e3142 < 0f) {
                                        phi_5124_ = -(_e3142);
                                    } else {
                                        phi_5124_ = _e3142;
                                    }
                                    let _e3227 = phi_5124_;
                                    if (_e3145 < 0f) {
                                        phi_5130_ = -(_e3145);
                                    } else {
                                        phi_5130_ = _e3145;
                                    }
                                    let _e3231 = phi_5130_;
                                    if (_e3148 < 0f) {
                                        phi_5137_ = -(_e3148);
                                    } else {
                                        phi_5137_ = _e3148;
                                    }
                                    let _e3236 = phi_5137_;
                                    let _e3237 = ((_e3227 + _e3231) + _e3236);
                                    let _e3242 = local_36;
                                    let _e3243 = -(_e3242);
                                    let _e3245 = local_37;
                                    if (_e3245 > _e3243) {
                                        let _e4689 = local_46;
                                        phi_5147_ = _e4689;
                                    } else {
                                        phi_5147_ = _e3243;
                                    }
                                    let _e3248 = phi_5147_;
                                    let _e3253 = (((_e3248 - ((_e3237 * _e3018) * (0.000000059604645f * 17f))) - (_e3237 * _e3025)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3139 > _e3253) {
                                        phi_5157_ = _e3139;
                                    } else {
                                        phi_5157_ = _e3253;
                                    }
                                    let _e3256 = phi_5157_;
                                    phi_5325_ = (_e3256 > 0f);
                                }
                                let _e3259 = phi_5325_;
                                if _e3259 {
                                    let _e3263 = local_4[1u].member_1[0u];
                                    let _e3269 = local_4[1u].member_2[0u];
                                    let _e3275 = ((_e3263[1] * _e3269[2]) - (_e3263[2] * _e3269[1]));
                                    let _e3278 = ((_e3263[2] * _e3269[0]) - (_e3263[0] * _e3269[2]));
                                    let _e3281 = ((_e3263[0] * _e3269[1]) - (_e3263[1] * _e3269[0]));
                                    let _e3284 = local_4[1u].member_1[1u];
                                    let _e3290 = local_4[1u].member_2[1u];
                                    let _e3296 = ((_e3284[1] * _e3290[2]) - (_e3284[2] * _e3290[1]));
                                    let _e3299 = ((_e3284[2] * _e3290[0]) - (_e3284[0] * _e3290[2]));
                                    let _e3302 = ((_e3284[0] * _e3290[1]) - (_e3284[1] * _e3290[0]));
                                    let _e3305 = local_4[1u].member_1[0u];
                                    let _e3311 = local_4[1u].member_2[1u];
                                    let _e3326 = local_4[1u].member_1[1u];
                                    let _e3332 = local_4[1u].member_2[0u];
                                    let _e3345 = (((_e3305[1] * _e3311[2]) - (_e3305[2] * _e3311[1])) + ((_e3326[1] * _e3332[2]) - (_e3326[2] * _e3332[1])));
                                    let _e3346 = (((_e3305[2] * _e3311[0]) - (_e3305[0] * _e3311[2])) + ((_e3326[2] * _e3332[0]) - (_e3326[0] * _e3332[2])));
                                    let _e3347 = (((_e3305[0] * _e3311[1]) - (_e3305[1] * _e3311[0])) + ((_e3326[0] * _e3332[1]) - (_e3326[1] * _e3332[0])));
                                    let _e3350 = local_4[1u].member[0u];
                                    let _e3361 = local_4[1u].member[1u];
                                    let _e3372 = local_4[1u].member[0u];
                                    let _e3381 = ((((_e3361[0] * _e3275) + (_e3361[1] * _e3278)) + (_e3361[2] * _e3281)) + (((_e3372[0] * _e3345) + (_e3372[1] * _e3346)) + (_e3372[2] * _e3347)));
                                    let _e3384 = local_4[1u].member[0u];
                                    let _e3395 = local_4[1u].member[1u];
                                    let _e3404 = ((((_e3384[0] * _e3296) + (_e3384[1] * _e3299)) + (_e3384[2] * _e3302)) + (((_e3395[0] * _e3345) + (_e3395[1] * _e3346)) + (_e3395[2] * _e3347)));
                                    let _e3407 = local_4[1u].member[1u];
                                    let _e3418 = local_4[1u].member[0u];
                                    if (_e3418[0] < 0f) {
                                        phi_5571_ = -(_e3418[0]);
                                    } else {
                                        phi_5571_ = _e3418[0];
                                    }
                                    let _e3425 = phi_5571_;
                                    if (_e3418[1] < 0f) {
                                        phi_5578_ = -(_e3418[1]);
                                    } else {
                                        phi_5578_ = _e3418[1];
                                    }
                                    let _e3429 = phi_5578_;
                                    if (_e3425 > _e3429) {
                                        phi_5583_ = _e3425;
                                    } else {
                                        phi_5583_ = _e3429;
                                    }
                                    let _e3432 = phi_5583_;
                                    if (_e3418[2] < 0f) {
                                        phi_5590_ = -(_e3418[2]);
                                    } else {
                                        phi_5590_ = _e3418[2];
                                    }
                                    let _e3436 = phi_5590_;
                                    if (_e3432 > _e3436) {
                                        phi_5595_ = _e3432;
                                    } else {
                                        phi_5595_ = _e3436;
                                    }
                                    let _e3439 = phi_5595_;
                                    let _e3442 = local_4[1u].member[1u];
                                    if (_e3442[0] < 0f) {
                                        phi_5608_ = -(_e3442[0]);
                                    } else {
                                        phi_5608_ = _e3442[0];
                                    }
                                    let _e3449 = phi_5608_;
                                    if (_e3442[1] < 0f) {
                                        phi_5615_ = -(_e3442[1]);
                                    } else {
                                        phi_5615_ = _e3442[1];
                                    }
                                    let _e3453 = phi_5615_;
                                    if (_e3449 > _e3453) {
                                        phi_5620_ = _e3449;
                                    } else {
                                        phi_5620_ = _e3453;
                                    }
                                    let _e3456 = phi_5620_;
                                    if (_e3442[2] < 0f) {
                                        phi_5627_ = -(_e3442[2]);
                                    } else {
                                        phi_5627_ = _e3442[2];
                                    }
                                    let _e3460 = phi_5627_;
                                    if (_e3456 > _e3460) {
                                        phi_5632_ = _e3456;
                                    } else {
                                        phi_5632_ = _e3460;
                                    }
                                    let _e3463 = phi_5632_;
                                    if (_e3439 > _e3463) {
                                        phi_5637_ = _e3439;
                                    } else {
                                        phi_5637_ = _e3463;
                                    }
                                    let _e3466 = phi_5637_;
                                    let _e3468 = local_4[1u].member_3;
                                    let _e3469 = (_e3466 + _e3468);
                                    let _e3472 = local_4[1u].member_1[0u];
                                    if (_e3472[0] < 0f) {
                                        phi_5654_ = -(_e3472[0]);
                                    } else {
                                        phi_5654_ = _e3472[0];
                                    }
                                    let _e3479 = phi_5654_;
                                    if (_e3472[1] < 0f) {
                                        phi_5661_ = -(_e3472[1]);
                                    } else {
                                        phi_5661_ = _e3472[1];
                                    }
                                    let _e3483 = phi_5661_;
                                    if (_e3479 > _e3483) {
                                        phi_5666_ = _e3479;
                                    } else {
                                        phi_5666_ = _e3483;
                                    }
                                    let _e3486 = phi_5666_;
                                    if (_e3472[2] < 0f) {
                                        phi_5673_ = -(_e3472[2]);
                                    } else {
                                        phi_5673_ = _e3472[2];
                                    }
                                    let _e3490 = phi_5673_;
                                    if (_e3486 > _e3490) {
                                        phi_5678_ = _e3486;
                                    } else {
                                        phi_5678_ = _e3490;
                                    }
                                    let _e3493 = phi_5678_;
                                    let _e3496 = local_4[1u].member_1[1u];
                                    if (_e3496[0] < 0f) {
                                        phi_5692_ = -(_e3496[0]);
                                    } else {
                                        phi_5692_ = _e3496[0];
                                    }
                                    let _e3503 = phi_5692_;
                                    if (_e3496[1] < 0f) {
                                        phi_5699_ = -(_e3496[1]);
                                    } else {
                                        phi_5699_ = _e3496[1];
                                    }
                                    let _e3507 = phi_5699_;
                                    if (_e3503 > _e3507) {
                                        phi_5704_ = _e3503;
                                    } else {
                                        phi_5704_ = _e3507;
                                    }
                                    let _e3510 = phi_5704_;
                                    if (_e3496[2] < 0f) {
                                        phi_5711_ = -(_e3496[2]);
                                    } else {
                                        phi_5711_ = _e3496[2];
                                    }
                                    let _e3514 = phi_5711_;
                                    if (_e3510 > _e3514) {
                                        phi_5716_ = _e3510;
                                    } else {
                                        phi_5716_ = _e3514;
                                    }
                                    let _e3517 = phi_5716_;
                                    if (_e3493 > _e3517) {
                                        phi_5721_ = _e3493;
                                    } else {
                                        phi_5721_ = _e3517;
                                    }
                                    let _e3520 = phi_5721_;
                                    let _e3522 = local_4[1u].member_3;
                                    let _e3523 = (_e3520 + _e3522);
                                    let _e3526 = local_4[1u].member_2[0u];
                                    if (_e3526[0] < 0f) {
                                        phi_5738_ = -(_e3526[0]);
                                    } else {
                                        phi_5738_ = _e3526[0];
                                    }
                                    let _e3533 = phi_5738_;
                                    if (_e3526[1] < 0f) {
                                        phi_5745_ = -(_e3526[1]);
                                    } else {
                                        phi_5745_ = _e3526[1];
                                    }
                                    let _e3537 = phi_5745_;
                                    if (_e3533 > _e3537) {
                                        phi_5750_ = _e3533;
                                    } else {
                                        phi_5750_ = _e3537;
                                    }
                                    let _e3540 = phi_5750_;
                                    if (_e3526[2] < 0f) {
                                        phi_5757_ = -(_e3526[2]);
                                    } else {
                                        phi_5757_ = _e3526[2];
                                    }
                                    let _e3544 = phi_5757_;
                                    if (_e3540 > _e3544) {
                                        phi_5762_ = _e3540;
                                    } else {
                                        phi_5762_ = _e3544;
                                    }
                                    let _e3547 = phi_5762_;
                                    let _e3550 = local_4[1u].member_2[1u];
                                    if (_e3550[0] < 0f) {
                                        phi_5776_ = -(_e3550[0]);
                                    } else {
                                        phi_5776_ = _e3550[0];
                                    }
                                    let _e3557 = phi_5776_;
                                    if (_e3550[1] < 0f) {
                                        phi_5783_ = -(_e3550[1]);
                                    } else {
                                        phi_5783_ = _e3550[1];
                                    }
                                    let _e3561 = phi_5783_;
                                    if (_e3557 > _e3561) {
                                        phi_5788_ = _e3557;
                                    } else {
                                        phi_5788_ = _e3561;
                                    }
                                    let _e3564 = phi_5788_;
                                    if (_e3550[2] < 0f) {
                                        phi_5795_ = -(_e3550[2]);
                                    } else {
                                        phi_5795_ = _e3550[2];
                                    }
                                    let _e3568 = phi_5795_;
                                    if (_e3564 > _e3568) {
                                        phi_5800_ = _e3564;
                                    } else {
                                        phi_5800_ = _e3568;
                                    }
                                    let _e3571 = phi_5800_;
                                    if (_e3547 > _e3571) {
                                        phi_5805_ = _e3547;
                                    } else {
                                        phi_5805_ = _e3571;
                                    }
                                    let _e3574 = phi_5805_;
                                    let _e3576 = local_4[1u].member_3;
                                    let _e3577 = (_e3574 + _e3576);
                                    let _e3579 = ((_e3523 * 8f) * _e3577);
                                    let _e3586 = local_4[1u].member_3;
                                    if (_e3275 < 0f) {
                                        phi_5836_ = -(_e3275);
                                    } else {
                                        phi_5836_ = _e3275;
                                    }
                                    let _e3603 = phi_5836_;
                                    if (_e3278 < 0f) {
                                        phi_5842_ = -(_e3278);
                                    } else {
                                        phi_5842_ = _e3278;
                                    }
                                    let _e3607 = phi_5842_;
                                    if (_e3281 < 0f) {
                                        phi_5849_ = -(_e3281);
                                    } else {
                                        phi_5849_ = _e3281;
                                    }
                                    let _e3612 = phi_5849_;
                                    let _e3613 = ((_e3603 + _e3607) + _e3612);
                                    if (_e3296 < 0f) {
                                        phi_5856_ = -(_e3296);
                                    } else {
                                        phi_5856_ = _e3296;
                                    }
                                    let _e3617 = phi_5856_;
                                    if (_e3299 < 0f) {
                                        phi_5862_ = -(_e3299);
                                    } else {
                                        phi_5862_ = _e3299;
                                    }
                                    let _e3621 = phi_5862_;
                                    if (_e3302 < 0f) {
                                        phi_5869_ = -(_e3302);
                                    } else {
                                        phi_5869_ = _e3302;
                                    }
                                    let _e3626 = phi_5869_;
                                    let _e3627 = ((_e3617 + _e3621) + _e3626);
                                    if (_e3613 > _e3627) {
                                        phi_5875_ = _e3613;
                                    } else {
                                        phi_5875_ = _e3627;
                                    }
                                    let _e3630 = phi_5875_;
                                    if (_e3345 < 0f) {
                                        phi_5881_ = -(_e3345);
                                    } else {
                                        phi_5881_ = _e3345;
                                    }
                                    let _e3634 = phi_5881_;
                                    if (_e3346 < 0f) {
                                        phi_5887_ = -(_e3346);
                                    } else {
                                        phi_5887_ = _e3346;
                                    }
                                    let _e3638 = phi_5887_;
                                    if (_e3347 < 0f) {
                                        phi_5894_ = -(_e3347);
                                    } else {
                                        phi_5894_ = _e3347;
                                    }
                                    let _e3643 = phi_5894_;
                                    let _e3645 = (((_e3634 + _e3638) + _e3643) * 0.5f);
                                    if (_e3630 > _e3645) {
                                        phi_5901_ = _e3630;
                                    } else {
                                        phi_5901_ = _e3645;
                                    }
                                    let _e3648 = phi_5901_;
                                    let _e3653 = local_4[1u].member_3;
                                    let _e3666 = ((((_e3350[0] * _e3275) + (_e3350[1] * _e3278)) + (_e3350[2] * _e3281)) * 3f);
                                    let _e3667 = ((((_e3407[0] * _e3296) + (_e3407[1] * _e3299)) + (_e3407[2] * _e3302)) * 3f);
                                    if (_e3666 < _e3667) {
                                        phi_5925_ = _e3666;
                                    } else {
                                        phi_5925_ = _e3667;
                                    }
                                    let _e3670 = phi_5925_;
                                    if (_e3381 < _e3404) {
                                        phi_5930_ = _e3381;
                                    } else {
                                        phi_5930_ = _e3404;
                                    }
                                    let _e3673 = phi_5930_;
                                    if (_e3670 < _e3673) {
                                        phi_5935_ = _e3670;
                                    } else {
                                        phi_5935_ = _e3673;
                                    }
                                    let _e3676 = phi_5935_;
                                    if (_e3666 > _e3667) {
                                        phi_5940_ = _e3666;
                                    } else {
                                        phi_5940_ = _e3667;
                                    }
                                    let _e3679 = phi_5940_;
                                    if (_e3381 > _e3404) {
                                        phi_5945_ = _e3381;
                                    } else {
                                        phi_5945_ = _e3404;
                                    }
                                    let _e3682 = phi_5945_;
                                    if (_e3679 > _e3682) {
                                        phi_5950_ = _e3679;
                                    } else {
                                        phi_5950_ = _e3682;
                                    }
                                    let _e3685 = phi_5950_;
                                    let _e3690 = -(_e3685);
                                    if (_e3676 > _e3690) {
                                        phi_5960_ = _e3676;
                                    } else {
                                        phi_5960_ = _e3690;
                                    }
                                    let _e3693 = phi_5960_;
                                    if ((_e3693 - ((((((_e3469 * 8f) * _e3579) * (0.000000059604645f * (490f / 64f))) + ((_e3586 * 19f) * ((_e3469 * (_e3523 + _e3577)) + (_e3523 * _e3577)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3469) * ((1f + _e3523) * (1f + _e3577))))) + ((_e1208 * (((_e3648 + (_e3579 * (0.000000059604645f * 4f))) + ((_e3653 * 6f) * (_e3523 + _e3577))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3523) * (1f + _e3577))))) * (3f * 1.0001f)))) > 0f) {
                                        phi_6936_ = true;
                                    } else {
                                        let _e3698 = local_4[1u].member_1[0u];
                                        let _e3704 = local_4[1u].member_1[1u];
                                        let _e3708 = (_e3698[0] + _e3704[0]);
                                        let _e3709 = (_e3698[1] + _e3704[1]);
                                        let _e3710 = (_e3698[2] + _e3704[2]);
                                        let _e3713 = local_4[1u].member_2[0u];
                                        let _e3719 = local_4[1u].member_2[1u];
                                        let _e3723 = (_e3713[0] + _e3719[0]);
                                        let _e3724 = (_e3713[1] + _e3719[1]);
                                        let _e3725 = (_e3713[2] + _e3719[2]);
                                        let _e3728 = ((_e3709 * _e3725) - (_e3710 * _e3724));
                                        let _e3731 = ((_e3710 * _e3723) - (_e3708 * _e3725));
                                        let _e3734 = ((_e3708 * _e3724) - (_e3709 * _e3723));
                                        let _e3737 = local_4[1u].member[0u];
                                        let _e3743 = local_4[1u].member_1[0u];
                                        let _e3749 = local_4[1u].member_2[0u];
                                        let _e3753 = (_e3737[0] - _e3743[0]);
                                        let _e3754 = (_e3737[1] - _e3743[1]);
                                        let _e3755 = (_e3737[2] - _e3743[2]);
                                        let _e3764 = local_4[1u].member[1u];
                                        let _e3770 = local_4[1u].member_1[1u];
                                        let _e3776 = local_4[1u].member_2[1u];
                                        let _e3780 = (_e3764[0] - _e3770[0]);
                                        let _e3781 = (_e3764[1] - _e3770[1]);
                                        let _e3782 = (_e3764[2] - _e3770[2]);
                                        local = array<array<f32, 3>, 4>(_e3737, array<f32, 3>(_e3753, _e3754, _e3755), array<f32, 3>((_e3737[0] - _e3749[0]), (_e3737[1] - _e3749[1]), (_e3737[2] - _e3749[2])), array<f32, 3>((_e3753 - _e3749[0]), (_e3754 - _e3749[1]), (_e3755 - _e3749[2])));
                                        local_1 = array<array<f32, 3>, 4>(_e3764, array<f32, 3>(_e3780, _e3781, _e3782), array<f32, 3>((_e3764[0] - _e3776[0]), (_e3764[1] - _e3776[1]), (_e3764[2] - _e3776[2])), array<f32, 3>((_e3780 - _e3776[0]), (_e3781 - _e3776[1]), (_e3782 - _e3776[2])));
                                        let _e3799 = local_4[1u].member[0u];
                                        if (_e3799[0] < 0f) {
                                            phi_6211_ = -(_e3799[0]);
                                        } else {
                                            phi_6211_ = _e3799[0];
                                        }
                                        let _e3806 = phi_6211_;
                                        if (_e3799[1] < 0f) {
                                            phi_6218_ = -(_e3799[1]);
                                        } else {
                                            phi_6218_ = _e3799[1];
                                        }
                                        let _e3810 = phi_6218_;
                                        if (_e3806 > _e3810) {
                                            phi_6223_ = _e3806;
                                        } else {
                                            phi_6223_ = _e3810;
                                        }
                                        let _e3813 = phi_6223_;
                                        if (_e3799[2] < 0f) {
                                            phi_6230_ = -(_e3799[2]);
                                        } else {
                                            phi_6230_ = _e3799[2];
                                        }
                                        let _e3817 = phi_6230_;
                                        if (_e3813 > _e3817) {
                                            phi_6235_ = _e3813;
                                        } else {
                                            phi_6235_ = _e3817;
                                        }
                                        let _e3820 = phi_6235_;
                                        let _e3823 = local_4[1u].member[1u];
                                        if (_e3823[0] < 0f) {
                                            phi_6248_ = -(_e3823[0]);
                                        } else {
                                            phi_6248_ = _e3823[0];
                                        }
                                        let _e3830 = phi_6248_;
                                        if (_e3823[1] < 0f) {
                                            phi_6255_ = -(_e3823[1]);
                                        } else {
                                            phi_6255_ = _e3823[1];
                                        }
                                        let _e3834 = phi_6255_;
                                        if (_e3830 > _e3834) {
                                            phi_6260_ = _e3830;
                                        } else {
                                            phi_6260_ = _e3834;
                                        }
                                        let _e3837 = phi_6260_;
                                        if (_e3823[2] < 0f) {
                                            phi_6267_ = -(_e3823[2]);
                                        } else {
                                            phi_6267_ = _e3823[2];
                                        }
                                        let _e3841 = phi_6267_;
                                        if (_e3837 > _e3841) {
                                            phi_6272_ = _e3837;
                                        } else {
                                            phi_6272_ = _e3841;
                                        }
                                        let _e3844 = phi_6272_;
                                        if (_e3820 > _e3844) {
                                            phi_6277_ = _e3820;
                                        } else {
                                            phi_6277_ = _e3844;
                                        }
                                        let _e3847 = phi_6277_;
                                        let _e3849 = local_4[1u].member_3;
                                        let _e3853 = local_4[1u].member_1[0u];
                                        if (_e3853[0] < 0f) {
                                            phi_6294_ = -(_e3853[0]);
                                        } else {
                                            phi_6294_ = _e3853[0];
                                        }
                                        let _e3860 = phi_6294_;
                                        if (_e3853[1] < 0f) {
                                            phi_6301_ = -(_e3853[1]);
                                        } else {
                                            phi_6301_ = _e3853[1];
                                        }
                                        let _e3864 = phi_6301_;
                                        if (_e3860 > _e3864) {
                                            phi_6306_ = _e3860;
                                        } else {
                                            phi_6306_ = _e3864;
                                        }
                                        let _e3867 = phi_6306_;
                                        if (_e3853[2] < 0f) {
                                            phi_6313_ = -(_e3853[2]);
                                        } else {
                                            phi_6313_ = _e3853[2];
                                        }
                                        let _e3871 = phi_6313_;
                                        if (_e3867 > _e3871) {
                                            phi_6318_ = _e3867;
                                        } else {
                                            phi_6318_ = _e3871;
                                        }
                                        let _e3874 = phi_6318_;
                                        let _e3877 = local_4[1u].member_1[1u];
                                        if (_e3877[0] < 0f) {
                                            phi_6332_ = -(_e3877[0]);
                                        } else {
                                            phi_6332_ = _e3877[0];
                                        }
                                        let _e3884 = phi_6332_;
                                        if (_e3877[1] < 0f) {
                                            phi_6339_ = -(_e3877[1]);
                                        } else {
                                            phi_6339_ = _e3877[1];
                                        }
                                        let _e3888 = phi_6339_;
                                        if (_e3884 > _e3888) {
                                            phi_6344_ = _e3884;
                                        } else {
                                            phi_6344_ = _e3888;
                                        }
                                        let _e3891 = phi_6344_;
                                        if (_e3877[2] < 0f) {
                                            phi_6351_ = -(_e3877[2]);
                                        } else {
                                            phi_6351_ = _e3877[2];
                                        }
                                        let _e3895 = phi_6351_;
                                        if (_e3891 > _e3895) {
                                            phi_6356_ = _e3891;
                                        } else {
                                            phi_6356_ = _e3895;
                                        }
                                        let _e3898 = phi_6356_;
                                        if (_e3874 > _e3898) {
                                            phi_6361_ = _e3874;
                                        } else {
                                            phi_6361_ = _e3898;
                                        }
                                        let _e3901 = phi_6361_;
                                        let _e3903 = local_4[1u].member_3;
                                        let _e3907 = local_4[1u].member_2[0u];
                                        if (_e3907[0] < 0f) {
                                            phi_6378_ = -(_e3907[0]);
                                        } else {
                                            phi_6378_ = _e3907[0];
                                        }
                                        let _e3914 = phi_6378_;
                                        if (_e3907[1] < 0f) {
                                            phi_6385_ = -(_e3907[1]);
                                        } else {
                                            phi_6385_ = _e3907[1];
                                        }
                                        let _e3918 = phi_6385_;
                                        if (_e3914 > _e3918) {
                                            phi_6390_ = _e3914;
                                        } else {
                                            phi_6390_ = _e3918;
                                        }
                                        let _e3921 = phi_6390_;
                                        if (_e3907[2] < 0f) {
                                            phi_6397_ = -(_e3907[2]);
                                        } else {
                                            phi_6397_ = _e3907[2];
                                        }
                                        let _e3925 = phi_6397_;
                                        if (_e3921 > _e3925) {
                                            phi_6402_ = _e3921;
                                        } else {
                                            phi_6402_ = _e3925;
                                        }
                                        let _e3928 = phi_6402_;
                                        let _e3931 = local_4[1u].member_2[1u];
                                        if (_e3931[0] < 0f) {
                                            phi_6416_ = -(_e3931[0]);
                                        } else {
                                            phi_6416_ = _e3931[0];
                                        }
                                        let _e3938 = phi_6416_;
                                        if (_e3931[1] < 0f) {
                                            phi_6423_ = -(_e3931[1]);
                                        } else {
                                            phi_6423_ = _e3931[1];
                                        }
                                        let _e3942 = phi_6423_;
                                        if (_e3938 > _e3942) {
                                            phi_6428_ = _e3938;
                                        } else {
                                            phi_6428_ = _e3942;
                                        }
                                        let _e3945 = phi_6428_;
                                        if (_e3931[2] < 0f) {
                                            phi_6435_ = -(_e3931[2]);
                                        } else {
                                            phi_6435_ = _e3931[2];
                                        }
                                        let _e3949 = phi_6435_;
                                        if (_e3945 > _e3949) {
                                            phi_6440_ = _e3945;
                                        } else {
                                            phi_6440_ = _e3949;
                                        }
                                        let _e3952 = phi_6440_;
                                        if (_e3928 > _e3952) {
                                            phi_6445_ = _e3928;
                                        } else {
                                            phi_6445_ = _e3952;
                                        }
                                        let _e3955 = phi_6445_;
                                        let _e3957 = local_4[1u].member_3;
                                        let _e3960 = (((_e3847 + _e3849) + (_e3901 + _e3903)) + (_e3955 + _e3957));
                                        let _e3963 = local_4[1u].member_3;
                                        let _e3967 = (((_e1208 * 1.0001f) + (_e3963 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e3970 = ((_e3731 * _e3710) - (_e3734 * _e3709));
                                        let _e3973 = ((_e3734 * _e3708) - (_e3728 * _e3710));
                                        let _e3976 = ((_e3728 * _e3709) - (_e3731 * _e3708));
                                        let _e3978 = local[0u];
                                        let _e3986 = (((_e3970 * _e3978[0]) + (_e3973 * _e3978[1])) + (_e3976 * _e3978[2]));
                                        phi_6483_ = type_37(0u, 4u);
                                        phi_6486_ = _e3986;
                                        phi_6488_ = _e3986;
                                        loop {
                                            let _e3988 = phi_6483_;
                                            let _e3990 = phi_6486_;
                                            let _e3992 = phi_6488_;
                                            local_38 = _e3990;
                                            local_39 = _e3992;
                                            local_47 = _e3992;
                                            if (_e3988.member < _e3988.member_1) {
                                                phi_6484_ = type_37((_e3988.member + 1u), _e3988.member_1);
                                                phi_6511_ = type_37(1u, _e3988.member);
                                            } else {
                                                phi_6484_ = _e3988;
                                                phi_6511_ = type_37(0u, type_37().member_1);
                                            }
                                            let _e4006 = phi_6484_;
                                            let _e4008 = phi_6511_;
                                            let _e4012 = (bitcast<i32>(_e4008.member) != 0i);
                                            if _e4012 {
                                                if (_e4008.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4015 = local[_e4008.member_1];
                                                let _e4023 = (((_e3970 * _e4015[0]) + (_e3973 * _e4015[1])) + (_e3976 * _e4015[2]));
                                                if (_e4008.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4026 = local_1[_e4008.member_1];
                                                let _e4034 = (((_e3970 * _e4026[0]) + (_e3973 * _e4026[1])) + (_e3976 * _e4026[2]));
                                                if (_e3992 < _e4023) {
                                                    phi_6561_ = _e3992;
                                                } else {
                                                    phi_6561_ = _e4023;
                                                }
                                                let _e4037 = phi_6561_;
                                                if (_e4037 < _e4034) {
                                                    phi_6566_ = _e4037;
                                                } else {
                                                    phi_6566_ = _e4034;
                                                }
                                                let _e4040 = phi_6566_;
                                                if (_e3990 > _e4023) {
                                                    phi_6571_ = _e3990;
                                                } else {
                                                    phi_6571_ = _e4023;
                                                }
                                                let _e4043 = phi_6571_;
                                                if (_e4043 > _e4034) {
                                                    phi_6576_ = _e4043;
                                                } else {
                                                    phi_6576_ = _e4034;
                                                }
                                                let _e4046 = phi_6576_;
                                                phi_6487_ = _e4046;
                                                phi_6489_ = _e4040;
                                            } else {
                                                phi_6487_ = f32();
                                                phi_6489_ = f32();
                                            }
                                            let _e4048 = phi_6487_;
                                            let _e4050 = phi_6489_;
                                            continue;
                                            continuing {
                                                phi_6483_ = _e4006;
                                                phi_6486_ = _e4048;
                                                phi_6488_ = _e4050;
                                                break if !(_e4012);
                                            }
                                        }
                                        if (_e3970 < 0f) {
                                            phi_6582_ = -(_e3970);
                                        } else {
                                            phi_6582_ = _e3970;
                                        }
                                        let _e4055 = phi_6582_;
                                        if (_e3973 < 0f) {
                                            phi_6588_ = -(_e3973);
                                        } else {
                                            phi_6588_ = _e3973;
                                        }
                                        let _e4059 = phi_6588_;
                                        if (_e3976 < 0f) {
                                            phi_6595_ = -(_e3976);
                                        } else {
                                            phi_6595_ = _e3976;
                                        }
                                        let _e4064 = phi_6595_;
                                        let _e4065 = ((_e4055 + _e4059) + _e4064);
                                        let _e4070 = local_38;
                                        let _e4071 = -(_e4070);
                                        let _e4073 = local_39;
                                        if (_e4073 > _e4071) {
                                            let _e4794 = local_47;
                                            phi_6605_ = _e4794;
                                        } else {
                                            phi_6605_ = _e4071;
                                        }
                                        let _e4076 = phi_6605_;
                                        let _e4081 = (((_e4076 - ((_e4065 * _e3960) * (0.000000059604645f * 17f))) - (_e4065 * _e3967)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4084 = ((_e3731 * _e3725) - (_e3734 * _e3724));
                                        let _e4087 = ((_e3734 * _e3723) - (_e3728 * _e3725));
                                        let _e4090 = ((_e3728 * _e3724) - (_e3731 * _e3723));
                                        let _e4092 = local[0u];
                                        let _e4100 = (((_e4084 * _e4092[0]) + (_e4087 * _e4092[1])) + (_e4090 * _e4092[2]));
                                        phi_6636_ = type_37(0u, 4u);
                                        phi_6639_ = _e4100;
                                        phi_6641_ = _e4100;
                                        loop {
                                            let _e4102 = phi_6636_;
                                            let _e4104 = phi_6639_;
                                            let _e4106 = phi_6641_;
                                            local_40 = _e4104;
                                            local_41 = _e4106;
                                            local_48 = _e4106;
                                            if (_e4102.member < _e4102.member_1) {
                                                phi_6637_ = type_37((_e4102.member + 1u), _e4102.member_1);
                                                phi_6664_ = type_37(1u, _e4102.member);
                                            } else {
                                                phi_6637_ = _e4102;
                                                phi_6664_ = type_37(0u, type_37().member_1);
                                            }
                                            let _e4120 = phi_6637_;
                                            let _e4122 = phi_6664_;
                                            let _e4126 = (bitcast<i32>(_e4122.member) != 0i);
                                            if _e4126 {
                                                if (_e4122.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4129 = local[_e4122.member_1];
                                                let _e4137 = (((_e4084 * _e4129[0]) + (_e4087 * _e4129[1])) + (_e4090 * _e4129[2]));
                                                if (_e4122.member_1 < 4u) {
                                                } else {
                                                    return;
                                                }
                                                let _e4140 = local_1[_e4122.member_1];
                                                let _e4148 = (((_e4084 * _e4140[0]) + (_e4087 * _e4140[1])) + (_e4090 * _e4140[2]));
                                                if (_e4106 < _e4137) {
                                                    phi_6714_ = _e4106;
                                                } else {
                                                    phi_6714_ = _e4137;
                                                }
                                                let _e4151 = phi_6714_;
                                                if (_e4151 < _e4148) {
                                                    phi_6719_ = _e4151;
                                                } else {
                                                    phi_6719_ = _e4148;
                                                }
                                                let _e4154 = phi_6719_;
                                                if (_e4104 > _e4137) {
                                                    phi_6724_ = _e4104;
                                                } else {
                                                    phi_6724_ = _e4137;
                                                }
                                                let _e4157 = phi_6724_;
                                                if (_e4157 > _e4148) {
                                                    phi_6729_ = _e4157;
                                                } else {
                                                    phi_6729_ = _e4148;
                                                }
                                                let _e4160 = phi_6729_;
                                                phi_6640_ = _e4160;
                                                phi_6642_ = _e4154;
                                            } else {
                                                phi_6640_ = f32();
                                                phi_6642_ = f32();
                                            }
                                            let _e4162 = phi_6640_;
                                            let _e4164 = phi_6642_;
                                            continue;
                                            continuing {
                                                phi_6636_ = _e4120;
                                                phi_6639_ = _e4162;
                                                phi_6641_ = _e4164;
                                                break if !(_e4126);
                                            }
                                        }
                                        if (_e4084 < 0f) {
                                            phi_6735_ = -(_e4084);
                                        } else {
                                            phi_6735_ = _e4084;
                                        }
                                        let _e4169 = phi_6735_;
                                        if (_e4087 < 0f) {
                                            phi_6741_ = -(_e4087);
                                        } else {
                                            phi_6741_ = _e4087;
                                        }
                                        let _e4173 = phi_6741_;
                                        if (_e4090 < 0f) {
                                            phi_6748_ = -(_e4090);
                                        } else {
                                            phi_6748_ = _e4090;
                                        }
                                        let _e4178 = phi_6748_;
                                        let _e4179 = ((_e4169 + _e4173) + _e4178);
                                        let _e4184 = local_40;
                                        let _e4185 = -(_e4184);
                                        let _e4187 = local_41;
                                        if (_e4187 > _e4185) {
                                            let _e4813 = local_48;
                                            phi_6758_ = _e4813;
                                        } else {
                                            phi_6758_ = _e4185;
                                        }
                                        let _e4190 = phi_6758_;
                                        let _e4195 = (((_e4190 - ((_e4179 * _e3960) * (0.000000059604645f * 17f))) - (_e4179 * _e3967)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4081 > _e4195) {
                                            phi_6768_ = _e4081;
                                        } else {
                                            phi_6768_ = _e4195;
                                        }
                                        let _e4198 = phi_6768_;
                                        phi_6936_ = (_e4198 > 0f);
                                    }
                                    let _e4201 = phi_6936_;
                                    phi_6937_ = _e4201;
                                } else {
                                    phi_6937_ = false;
                                }
                                let _e4203 = phi_6937_;
                                phi_6939_ = !(_e4203);
                            }
                            let _e4206 = phi_6939_;
                            if _e4206 {
                                let _e4208 = atomicAdd((&counters[3u]), 1u);
                                kept[_e4208] = _e445;
                            }
                        }
                        phi_6947_ = (_e408 + 64u);
                        phi_6948_ = true;
                    }
                    let _e4212 = phi_6947_;
                    let _e4214 = phi_6948_;
                    phi_650_ = _e4212;
                    phi_6949_ = _e4214;
                } else {
                    phi_650_ = u32();
                    phi_6949_ = false;
                }
                let _e4216 = phi_650_;
                let _e4218 = phi_6949_;
                continue;
                continuing {
                    phi_646_ = _e437;
                    phi_649_ = _e4216;
                    break if !(_e4218);
                }
            }
            workgroupBarrier();
            if (_e93 == 0u) {
                let _e4222 = atomicLoad((&counters[3u]));
                if (_e4222 > 0u) {
                    let _e4225 = atomicAdd((&output.member[0u]), _e4222);
                    atomicStore((&counters[4u]), _e4225);
                }
            }
            workgroupBarrier();
            let _e4228 = atomicLoad((&counters[4u]));
            if (_e93 == 0u) {
                let _e4231 = atomicLoad((&counters[5u]));
                let _e4233 = atomicAdd((&output.member[1u]), _e4231);
            }
            let _e4235 = atomicLoad((&counters[3u]));
            phi_6979_ = type_35(0i, 16i);
            phi_6982_ = _e93;
            loop {
                let _e4237 = phi_6979_;
                let _e4239 = phi_6982_;
                if (_e4237.member < _e4237.member_1) {
                    let _e4247 = (_e4237.member + 1i);
                    if ((false == (_e4247 > _e4237.member)) != false) {
                        phi_7003_ = true;
                    } else {
                        phi_7003_ = false;
                    }
                    let _e4252 = phi_7003_;
                    if _e4252 {
                        phi_7009_ = type_36(0u, type_36().member_1);
                    } else {
                        phi_7009_ = type_36(1u, _e4247);
                    }
                    let _e4258 = phi_7009_;
                    if (bitcast<i32>(_e4258.member) != 0i) {
                    } else {
                        return;
                    }
                    phi_6980_ = type_35(_e4258.member_1, _e4237.member_1);
                    phi_7023_ = type_36(1u, _e4237.member);
                } else {
                    phi_6980_ = _e4237;
                    phi_7023_ = type_36(0u, type_36().member_1);
                }
                let _e4268 = phi_6980_;
                let _e4270 = phi_7023_;
                if (bitcast<i32>(_e4270.member) != 0i) {
                    if (_e4239 >= _e4235) {
                        phi_7129_ = u32();
                        phi_7130_ = false;
                    } else {
                        let _e4276 = kept[_e4239];
                        let _e4285 = params.member.member_18[0u][1u];
                        let _e4292 = params.member.member_18[0u][1u];
                        let _e4295 = leaves.member[(_e4285 + ((_e186 * 32u) + (_e4276 >> bitcast<u32>(5i))))];
                        let _e4298 = leaves.member[(_e4292 + ((_e189 * 32u) + (_e4276 & 31u)))];
                        if (_e4295.member_1 < _e4298.member_1) {
                            phi_7105_ = type_37(_e4295.member_1, _e4298.member_1);
                        } else {
                            phi_7105_ = type_37(_e4298.member_1, _e4295.member_1);
                        }
                        let _e4304 = phi_7105_;
                        let _e4306 = params.member.member_16;
                        let _e4307 = (_e4228 + _e4239);
                        if (_e4307 < _e4306) {
                            atomicStore((&output.member[(4u + (2u * _e4307))]), _e4304.member);
                            atomicStore((&output.member[((2u * _e4307) + 5u)]), _e4304.member_1);
                        }
                        phi_7129_ = (_e4239 + 64u);
                        phi_7130_ = true;
                    }
                    let _e4319 = phi_7129_;
                    let _e4321 = phi_7130_;
                    phi_6983_ = _e4319;
                    phi_7131_ = _e4321;
                } else {
                    phi_6983_ = u32();
                    phi_7131_ = false;
                }
                let _e4323 = phi_6983_;
                let _e4325 = phi_7131_;
                continue;
                continuing {
                    phi_6979_ = _e4268;
                    phi_6982_ = _e4323;
                    break if !(_e4325);
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
