// Generated from ccd-shaders by `cargo xtask shaders`: not to be edited.
struct type_7 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: array<array<u32, 2>, 3>,
    member_9: array<u32, 2>,
    member_10: array<u32, 2>,
}

struct type_8 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_10 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_15 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_19 {
    member: array<array<u32, 2>>,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_26 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_28 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_29 {
    member: u32,
}

struct type_30 {
    member: type_7,
    member_1: type_8,
    member_2: type_29,
}

struct type_31 {
    member: type_30,
}

struct type_34 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> bodies: type_10;
@group(0) @binding(4) 
var<storage> keys: type_26;
@group(0) @binding(5) 
var<storage> paths: type_17;
@group(0) @binding(6) 
var<storage> input: type_10;
@group(0) @binding(7) 
var<storage, read_write> output: type_34;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_31;
@group(0) @binding(1) 
var<storage> boxes: type_23;
@group(0) @binding(2) 
var<storage> elements: type_19;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_137_: bool;
    var phi_138_: bool;
    var phi_142_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_138_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_137_ = (param[0] > param_1[0]);
        } else {
            phi_137_ = false;
        }
        let _e14 = phi_137_;
        phi_138_ = _e14;
    }
    let _e16 = phi_138_;
    if _e16 {
        phi_142_ = param_1;
    } else {
        phi_142_ = param;
    }
    let _e18 = phi_142_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_161_: bool;
    var phi_162_: bool;
    var phi_166_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_162_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_161_ = (param_3[0] > param_2[0]);
        } else {
            phi_161_ = false;
        }
        let _e14 = phi_161_;
        phi_162_ = _e14;
    }
    let _e16 = phi_162_;
    if _e16 {
        phi_166_ = param_3;
    } else {
        phi_166_ = param_2;
    }
    let _e18 = phi_166_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_185_: bool;
    var phi_186_: bool;
    var phi_190_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_186_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_185_ = (param_4[0] > param_5[0]);
        } else {
            phi_185_ = false;
        }
        let _e14 = phi_185_;
        phi_186_ = _e14;
    }
    let _e16 = phi_186_;
    if _e16 {
        phi_190_ = param_5;
    } else {
        phi_190_ = param_4;
    }
    let _e18 = phi_190_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_209_: bool;
    var phi_210_: bool;
    var phi_214_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_210_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_209_ = (param_7[0] > param_6[0]);
        } else {
            phi_209_ = false;
        }
        let _e14 = phi_209_;
        phi_210_ = _e14;
    }
    let _e16 = phi_210_;
    if _e16 {
        phi_214_ = param_7;
    } else {
        phi_214_ = param_6;
    }
    let _e18 = phi_214_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_233_: bool;
    var phi_234_: bool;
    var phi_238_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_234_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_233_ = (param_8[0] > param_9[0]);
        } else {
            phi_233_ = false;
        }
        let _e14 = phi_233_;
        phi_234_ = _e14;
    }
    let _e16 = phi_234_;
    if _e16 {
        phi_238_ = param_9;
    } else {
        phi_238_ = param_8;
    }
    let _e18 = phi_238_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_257_: bool;
    var phi_258_: bool;
    var phi_262_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_258_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_257_ = (param_11[0] > param_10[0]);
        } else {
            phi_257_ = false;
        }
        let _e14 = phi_257_;
        phi_258_ = _e14;
    }
    let _e16 = phi_258_;
    if _e16 {
        phi_262_ = param_11;
    } else {
        phi_262_ = param_10;
    }
    let _e18 = phi_262_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_28;
    var local_1: type_28;
    var local_2: type_28;
    var phi_309_: u32;
    var phi_319_: u32;
    var phi_326_: u32;
    var phi_342_: u32;
    var phi_363_: u32;
    var phi_364_: u32;
    var phi_367_: type_12;
    var phi_368_: type_12;
    var phi_391_: type_12;
    var phi_546_: bool;
    var phi_552_: bool;
    var phi_558_: bool;
    var phi_559_: bool;
    var phi_603_: bool;
    var phi_610_: bool;
    var phi_614_: bool;
    var phi_744_: bool;
    var phi_745_: bool;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_921_: bool;
    var phi_922_: bool;
    var phi_1009_: bool;
    var phi_1010_: bool;
    var phi_1099_: bool;
    var phi_1100_: bool;
    var phi_1187_: bool;
    var phi_1188_: bool;
    var phi_1192_: bool;
    var phi_1193_: bool;
    var phi_1194_: bool;
    var phi_1198_: bool;
    var phi_1199_: bool;
    var phi_1200_: bool;
    var phi_1201_: bool;
    var phi_1202_: bool;
    var phi_1206_: bool;
    var phi_1597_: f32;
    var phi_1604_: f32;
    var phi_1609_: f32;
    var phi_1616_: f32;
    var phi_1621_: f32;
    var phi_1634_: f32;
    var phi_1641_: f32;
    var phi_1646_: f32;
    var phi_1653_: f32;
    var phi_1658_: f32;
    var phi_1663_: f32;
    var phi_1680_: f32;
    var phi_1687_: f32;
    var phi_1692_: f32;
    var phi_1699_: f32;
    var phi_1704_: f32;
    var phi_1718_: f32;
    var phi_1725_: f32;
    var phi_1730_: f32;
    var phi_1737_: f32;
    var phi_1742_: f32;
    var phi_1747_: f32;
    var phi_1764_: f32;
    var phi_1771_: f32;
    var phi_1776_: f32;
    var phi_1783_: f32;
    var phi_1788_: f32;
    var phi_1802_: f32;
    var phi_1809_: f32;
    var phi_1814_: f32;
    var phi_1821_: f32;
    var phi_1826_: f32;
    var phi_1831_: f32;
    var phi_1862_: f32;
    var phi_1868_: f32;
    var phi_1875_: f32;
    var phi_1882_: f32;
    var phi_1888_: f32;
    var phi_1895_: f32;
    var phi_1901_: f32;
    var phi_1907_: f32;
    var phi_1913_: f32;
    var phi_1920_: f32;
    var phi_1927_: f32;
    var phi_1951_: f32;
    var phi_1956_: f32;
    var phi_1961_: f32;
    var phi_1966_: f32;
    var phi_1971_: f32;
    var phi_1976_: f32;
    var phi_1986_: f32;
    var phi_2189_: f32;
    var phi_2196_: f32;
    var phi_2201_: f32;
    var phi_2208_: f32;
    var phi_2213_: f32;
    var phi_2226_: f32;
    var phi_2233_: f32;
    var phi_2238_: f32;
    var phi_2245_: f32;
    var phi_2250_: f32;
    var phi_2255_: f32;
    var phi_2272_: f32;
    var phi_2279_: f32;
    var phi_2284_: f32;
    var phi_2291_: f32;
    var phi_2296_: f32;
    var phi_2310_: f32;
    var phi_2317_: f32;
    var phi_2322_: f32;
    var phi_2329_: f32;
    var phi_2334_: f32;
    var phi_2339_: f32;
    var phi_2356_: f32;
    var phi_2363_: f32;
    var phi_2368_: f32;
    var phi_2375_: f32;
    var phi_2380_: f32;
    var phi_2394_: f32;
    var phi_2401_: f32;
    var phi_2406_: f32;
    var phi_2413_: f32;
    var phi_2418_: f32;
    var phi_2423_: f32;
    var phi_2502_: f32;
    var phi_2507_: f32;
    var phi_2512_: f32;
    var phi_2517_: f32;
    var phi_2522_: f32;
    var phi_2527_: f32;
    var phi_2532_: f32;
    var phi_2537_: f32;
    var phi_2542_: f32;
    var phi_2547_: f32;
    var phi_2552_: f32;
    var phi_2557_: f32;
    var phi_2562_: f32;
    var phi_2567_: f32;
    var phi_2573_: f32;
    var phi_2579_: f32;
    var phi_2586_: f32;
    var phi_2597_: f32;
    var phi_2668_: f32;
    var phi_2673_: f32;
    var phi_2678_: f32;
    var phi_2683_: f32;
    var phi_2688_: f32;
    var phi_2693_: f32;
    var phi_2698_: f32;
    var phi_2703_: f32;
    var phi_2708_: f32;
    var phi_2713_: f32;
    var phi_2718_: f32;
    var phi_2723_: f32;
    var phi_2728_: f32;
    var phi_2733_: f32;
    var phi_2739_: f32;
    var phi_2745_: f32;
    var phi_2752_: f32;
    var phi_2763_: f32;
    var phi_2773_: f32;
    var phi_2955_: bool;
    var phi_3407_: f32;
    var phi_3414_: f32;
    var phi_3419_: f32;
    var phi_3426_: f32;
    var phi_3431_: f32;
    var phi_3444_: f32;
    var phi_3451_: f32;
    var phi_3456_: f32;
    var phi_3463_: f32;
    var phi_3468_: f32;
    var phi_3473_: f32;
    var phi_3490_: f32;
    var phi_3497_: f32;
    var phi_3502_: f32;
    var phi_3509_: f32;
    var phi_3514_: f32;
    var phi_3528_: f32;
    var phi_3535_: f32;
    var phi_3540_: f32;
    var phi_3547_: f32;
    var phi_3552_: f32;
    var phi_3557_: f32;
    var phi_3574_: f32;
    var phi_3581_: f32;
    var phi_3586_: f32;
    var phi_3593_: f32;
    var phi_3598_: f32;
    var phi_3612_: f32;
    var phi_3619_: f32;
    var phi_3624_: f32;
    var phi_3631_: f32;
    var phi_3636_: f32;
    var phi_3641_: f32;
    var phi_3672_: f32;
    var phi_3678_: f32;
    var phi_3685_: f32;
    var phi_3692_: f32;
    var phi_3698_: f32;
    var phi_3705_: f32;
    var phi_3711_: f32;
    var phi_3717_: f32;
    var phi_3723_: f32;
    var phi_3730_: f32;
    var phi_3737_: f32;
    var phi_3761_: f32;
    var phi_3766_: f32;
    var phi_3771_: f32;
    var phi_3776_: f32;
    var phi_3781_: f32;
    var phi_3786_: f32;
    var phi_3796_: f32;
    var phi_3999_: f32;
    var phi_4006_: f32;
    var phi_4011_: f32;
    var phi_4018_: f32;
    var phi_4023_: f32;
    var phi_4036_: f32;
    var phi_4043_: f32;
    var phi_4048_: f32;
    var phi_4055_: f32;
    var phi_4060_: f32;
    var phi_4065_: f32;
    var phi_4082_: f32;
    var phi_4089_: f32;
    var phi_4094_: f32;
    var phi_4101_: f32;
    var phi_4106_: f32;
    var phi_4120_: f32;
    var phi_4127_: f32;
    var phi_4132_: f32;
    var phi_4139_: f32;
    var phi_4144_: f32;
    var phi_4149_: f32;
    var phi_4166_: f32;
    var phi_4173_: f32;
    var phi_4178_: f32;
    var phi_4185_: f32;
    var phi_4190_: f32;
    var phi_4204_: f32;
    var phi_4211_: f32;
    var phi_4216_: f32;
    var phi_4223_: f32;
    var phi_4228_: f32;
    var phi_4233_: f32;
    var phi_4312_: f32;
    var phi_4317_: f32;
    var phi_4322_: f32;
    var phi_4327_: f32;
    var phi_4332_: f32;
    var phi_4337_: f32;
    var phi_4342_: f32;
    var phi_4347_: f32;
    var phi_4352_: f32;
    var phi_4357_: f32;
    var phi_4362_: f32;
    var phi_4367_: f32;
    var phi_4372_: f32;
    var phi_4377_: f32;
    var phi_4383_: f32;
    var phi_4389_: f32;
    var phi_4396_: f32;
    var phi_4407_: f32;
    var phi_4478_: f32;
    var phi_4483_: f32;
    var phi_4488_: f32;
    var phi_4493_: f32;
    var phi_4498_: f32;
    var phi_4503_: f32;
    var phi_4508_: f32;
    var phi_4513_: f32;
    var phi_4518_: f32;
    var phi_4523_: f32;
    var phi_4528_: f32;
    var phi_4533_: f32;
    var phi_4538_: f32;
    var phi_4543_: f32;
    var phi_4549_: f32;
    var phi_4555_: f32;
    var phi_4562_: f32;
    var phi_4573_: f32;
    var phi_4583_: f32;
    var phi_4765_: bool;
    var phi_5010_: f32;
    var phi_5017_: f32;
    var phi_5022_: f32;
    var phi_5029_: f32;
    var phi_5034_: f32;
    var phi_5047_: f32;
    var phi_5054_: f32;
    var phi_5059_: f32;
    var phi_5066_: f32;
    var phi_5071_: f32;
    var phi_5076_: f32;
    var phi_5093_: f32;
    var phi_5100_: f32;
    var phi_5105_: f32;
    var phi_5112_: f32;
    var phi_5117_: f32;
    var phi_5131_: f32;
    var phi_5138_: f32;
    var phi_5143_: f32;
    var phi_5150_: f32;
    var phi_5155_: f32;
    var phi_5160_: f32;
    var phi_5177_: f32;
    var phi_5184_: f32;
    var phi_5189_: f32;
    var phi_5196_: f32;
    var phi_5201_: f32;
    var phi_5215_: f32;
    var phi_5222_: f32;
    var phi_5227_: f32;
    var phi_5234_: f32;
    var phi_5239_: f32;
    var phi_5244_: f32;
    var phi_5275_: f32;
    var phi_5281_: f32;
    var phi_5288_: f32;
    var phi_5295_: f32;
    var phi_5301_: f32;
    var phi_5308_: f32;
    var phi_5314_: f32;
    var phi_5320_: f32;
    var phi_5326_: f32;
    var phi_5333_: f32;
    var phi_5340_: f32;
    var phi_5364_: f32;
    var phi_5369_: f32;
    var phi_5374_: f32;
    var phi_5379_: f32;
    var phi_5384_: f32;
    var phi_5389_: f32;
    var phi_5399_: f32;
    var phi_5602_: f32;
    var phi_5609_: f32;
    var phi_5614_: f32;
    var phi_5621_: f32;
    var phi_5626_: f32;
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
    var phi_5769_: f32;
    var phi_5776_: f32;
    var phi_5781_: f32;
    var phi_5788_: f32;
    var phi_5793_: f32;
    var phi_5807_: f32;
    var phi_5814_: f32;
    var phi_5819_: f32;
    var phi_5826_: f32;
    var phi_5831_: f32;
    var phi_5836_: f32;
    var phi_5915_: f32;
    var phi_5920_: f32;
    var phi_5925_: f32;
    var phi_5930_: f32;
    var phi_5935_: f32;
    var phi_5940_: f32;
    var phi_5945_: f32;
    var phi_5950_: f32;
    var phi_5955_: f32;
    var phi_5960_: f32;
    var phi_5965_: f32;
    var phi_5970_: f32;
    var phi_5975_: f32;
    var phi_5980_: f32;
    var phi_5986_: f32;
    var phi_5992_: f32;
    var phi_5999_: f32;
    var phi_6010_: f32;
    var phi_6081_: f32;
    var phi_6086_: f32;
    var phi_6091_: f32;
    var phi_6096_: f32;
    var phi_6101_: f32;
    var phi_6106_: f32;
    var phi_6111_: f32;
    var phi_6116_: f32;
    var phi_6121_: f32;
    var phi_6126_: f32;
    var phi_6131_: f32;
    var phi_6136_: f32;
    var phi_6141_: f32;
    var phi_6146_: f32;
    var phi_6152_: f32;
    var phi_6158_: f32;
    var phi_6165_: f32;
    var phi_6176_: f32;
    var phi_6186_: f32;
    var phi_6368_: bool;
    var phi_6370_: bool;
    var phi_6372_: bool;
    var phi_6379_: u32;
    var phi_6380_: u32;
    var phi_6381_: bool;
    var phi_6382_: u32;
    var phi_6383_: bool;
    var phi_6384_: type_12;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e45 = id_2;
    let _e46 = n_2;
    let _e47 = lane_2;
    let _e60 = ((_e45.y * _e46.x) + _e45.x);
    let _e63 = (_e46.x * _e46.y);
    let _e66 = params.member.member_1.member_2;
    let _e68 = input.member[0u];
    if (_e66 < _e68) {
        phi_309_ = _e66;
    } else {
        phi_309_ = _e68;
    }
    let _e71 = phi_309_;
    let _e73 = params.member.member_1.member_1;
    if (_e71 > _e73) {
        let _e76 = params.member.member_1.member_1;
        phi_319_ = (_e71 - _e76);
    } else {
        phi_319_ = 0u;
    }
    let _e79 = phi_319_;
    let _e81 = params.member.member_1.member;
    if (_e81 < _e79) {
        phi_326_ = _e81;
    } else {
        phi_326_ = _e79;
    }
    let _e84 = phi_326_;
    let _e85 = (_e84 / 128u);
    if ((_e84 % 128u) > 0u) {
        phi_342_ = (_e85 + 1u);
    } else {
        phi_342_ = _e85;
    }
    let _e90 = phi_342_;
    if (_e90 > _e60) {
        let _e92 = (_e90 - _e60);
        if (_e63 == 0u) {
            return;
        }
        let _e94 = (_e92 / _e63);
        if (_e63 == 0u) {
            return;
        }
        if ((_e92 % _e63) > 0u) {
            phi_363_ = (_e94 + 1u);
        } else {
            phi_363_ = _e94;
        }
        let _e100 = phi_363_;
        phi_364_ = _e100;
    } else {
        phi_364_ = 0u;
    }
    let _e102 = phi_364_;
    phi_367_ = type_12(0u, _e102);
    loop {
        let _e105 = phi_367_;
        if (_e105.member < _e105.member_1) {
            phi_368_ = type_12((_e105.member + 1u), _e105.member_1);
            phi_391_ = type_12(1u, _e105.member);
        } else {
            phi_368_ = _e105;
            phi_391_ = type_12(0u, type_12().member_1);
        }
        let _e117 = phi_368_;
        let _e119 = phi_391_;
        let _e123 = (bitcast<i32>(_e119.member) != 0i);
        if _e123 {
            let _e127 = (((_e60 + (_e119.member_1 * _e63)) * 128u) + _e47);
            if (_e47 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e127 < _e84) {
                let _e133 = params.member.member_1.member_1;
                let _e135 = (2u * (_e133 + _e127));
                let _e138 = input.member[(4u + _e135)];
                let _e141 = input.member[(_e135 + 5u)];
                let _e144 = elements.member[_e138];
                let _e146 = elements.member[_e141];
                let _e156 = params.member.member.member_2[1u];
                let _e160 = params.member.member.member_2[1u];
                let _e163 = boxes.member[(_e156 + _e138)];
                let _e165 = boxes.member[(_e160 + _e141)];
                let _e168 = params.member.member.member_1;
                if ((_e168 & 1u) != 0u) {
                    if (_e146[0] == _e144[0]) {
                        phi_546_ = true;
                    } else {
                        phi_546_ = (_e146[0] == _e144[1]);
                    }
                    let _e174 = phi_546_;
                    if (_e146[1] == _e144[0]) {
                        phi_552_ = true;
                    } else {
                        phi_552_ = (_e146[1] == _e144[1]);
                    }
                    let _e178 = phi_552_;
                    if (_e174 || _e178) {
                        phi_558_ = false;
                    } else {
                        phi_558_ = true;
                    }
                    let _e181 = phi_558_;
                    phi_559_ = _e181;
                } else {
                    phi_559_ = true;
                }
                let _e183 = phi_559_;
                if _e183 {
                    let _e185 = params.member.member.member_1;
                    if ((_e185 & 2u) != 0u) {
                        let _e189 = params.member.member.member_1;
                        let _e193 = bodies.member[_e144[0]];
                        let _e195 = bodies.member[_e146[0]];
                        if ((_e193 / 2u) != (_e195 / 2u)) {
                            phi_603_ = true;
                        } else {
                            phi_603_ = ((_e189 & 4u) != 0u);
                        }
                        let _e200 = phi_603_;
                        if _e200 {
                            phi_610_ = (((_e193 & _e195) & 1u) == 0u);
                        } else {
                            phi_610_ = false;
                        }
                        let _e205 = phi_610_;
                        phi_614_ = _e205;
                    } else {
                        phi_614_ = true;
                    }
                    let _e207 = phi_614_;
                    if _e207 {
                        let _e209 = params.member.member.member_1;
                        if ((_e209 & 32u) != 0u) {
                            let _e213 = params.member.member.member_6;
                            let _e254 = (((((_e163.member_1[0] - _e165.member[0]) > _e213) && ((_e165.member_1[0] - _e163.member[0]) > _e213)) && (((_e163.member_1[1] - _e165.member[1]) > _e213) && ((_e165.member_1[1] - _e163.member[1]) > _e213))) && (((_e163.member_1[2] - _e165.member[2]) > _e213) && ((_e165.member_1[2] - _e163.member[2]) > _e213)));
                            if _e254 {
                                phi_1192_ = bool();
                            } else {
                                let _e256 = keys.member[_e144[0]];
                                let _e259 = keys.member[_e144[1]];
                                let _e261 = function_(_e256[0], _e259[0]);
                                let _e263 = keys.member[_e144[1]];
                                let _e265 = function_(_e261, _e263[0]);
                                let _e267 = keys.member[_e146[0]];
                                let _e270 = keys.member[_e146[1]];
                                let _e272 = function_1(_e267[3], _e270[3]);
                                let _e274 = keys.member[_e146[1]];
                                let _e276 = function_1(_e272, _e274[3]);
                                if (_e265[1] > _e276[1]) {
                                    phi_745_ = true;
                                } else {
                                    if (_e265[1] == _e276[1]) {
                                        phi_744_ = (_e265[0] > _e276[0]);
                                    } else {
                                        phi_744_ = false;
                                    }
                                    let _e287 = phi_744_;
                                    phi_745_ = _e287;
                                }
                                let _e289 = phi_745_;
                                let _e292 = keys.member[_e146[0]];
                                let _e295 = keys.member[_e146[1]];
                                let _e297 = function_(_e292[0], _e295[0]);
                                let _e299 = keys.member[_e146[1]];
                                let _e301 = function_(_e297, _e299[0]);
                                let _e303 = keys.member[_e144[0]];
                                let _e306 = keys.member[_e144[1]];
                                let _e308 = function_1(_e303[3], _e306[3]);
                                let _e310 = keys.member[_e144[1]];
                                let _e312 = function_1(_e308, _e310[3]);
                                if (_e301[1] > _e312[1]) {
                                    phi_833_ = true;
                                } else {
                                    if (_e301[1] == _e312[1]) {
                                        phi_832_ = (_e301[0] > _e312[0]);
                                    } else {
                                        phi_832_ = false;
                                    }
                                    let _e323 = phi_832_;
                                    phi_833_ = _e323;
                                }
                                let _e325 = phi_833_;
                                let _e329 = keys.member[_e144[0]];
                                let _e332 = keys.member[_e144[1]];
                                let _e334 = function_2(_e329[1], _e332[1]);
                                let _e336 = keys.member[_e144[1]];
                                let _e338 = function_2(_e334, _e336[1]);
                                let _e340 = keys.member[_e146[0]];
                                let _e343 = keys.member[_e146[1]];
                                let _e345 = function_3(_e340[4], _e343[4]);
                                let _e347 = keys.member[_e146[1]];
                                let _e349 = function_3(_e345, _e347[4]);
                                if (_e338[1] > _e349[1]) {
                                    phi_922_ = true;
                                } else {
                                    if (_e338[1] == _e349[1]) {
                                        phi_921_ = (_e338[0] > _e349[0]);
                                    } else {
                                        phi_921_ = false;
                                    }
                                    let _e360 = phi_921_;
                                    phi_922_ = _e360;
                                }
                                let _e362 = phi_922_;
                                let _e365 = keys.member[_e146[0]];
                                let _e368 = keys.member[_e146[1]];
                                let _e370 = function_2(_e365[1], _e368[1]);
                                let _e372 = keys.member[_e146[1]];
                                let _e374 = function_2(_e370, _e372[1]);
                                let _e376 = keys.member[_e144[0]];
                                let _e379 = keys.member[_e144[1]];
                                let _e381 = function_3(_e376[4], _e379[4]);
                                let _e383 = keys.member[_e144[1]];
                                let _e385 = function_3(_e381, _e383[4]);
                                if (_e374[1] > _e385[1]) {
                                    phi_1010_ = true;
                                } else {
                                    if (_e374[1] == _e385[1]) {
                                        phi_1009_ = (_e374[0] > _e385[0]);
                                    } else {
                                        phi_1009_ = false;
                                    }
                                    let _e396 = phi_1009_;
                                    phi_1010_ = _e396;
                                }
                                let _e398 = phi_1010_;
                                let _e403 = keys.member[_e144[0]];
                                let _e406 = keys.member[_e144[1]];
                                let _e408 = function_4(_e403[2], _e406[2]);
                                let _e410 = keys.member[_e144[1]];
                                let _e412 = function_4(_e408, _e410[2]);
                                let _e414 = keys.member[_e146[0]];
                                let _e417 = keys.member[_e146[1]];
                                let _e419 = function_5(_e414[5], _e417[5]);
                                let _e421 = keys.member[_e146[1]];
                                let _e423 = function_5(_e419, _e421[5]);
                                if (_e412[1] > _e423[1]) {
                                    phi_1100_ = true;
                                } else {
                                    if (_e412[1] == _e423[1]) {
                                        phi_1099_ = (_e412[0] > _e423[0]);
                                    } else {
                                        phi_1099_ = false;
                                    }
                                    let _e434 = phi_1099_;
                                    phi_1100_ = _e434;
                                }
                                let _e436 = phi_1100_;
                                let _e439 = keys.member[_e146[0]];
                                let _e442 = keys.member[_e146[1]];
                                let _e444 = function_4(_e439[2], _e442[2]);
                                let _e446 = keys.member[_e146[1]];
                                let _e448 = function_4(_e444, _e446[2]);
                                let _e450 = keys.member[_e144[0]];
                                let _e453 = keys.member[_e144[1]];
                                let _e455 = function_5(_e450[5], _e453[5]);
                                let _e457 = keys.member[_e144[1]];
                                let _e459 = function_5(_e455, _e457[5]);
                                if (_e448[1] > _e459[1]) {
                                    phi_1188_ = true;
                                } else {
                                    if (_e448[1] == _e459[1]) {
                                        phi_1187_ = (_e448[0] > _e459[0]);
                                    } else {
                                        phi_1187_ = false;
                                    }
                                    let _e470 = phi_1187_;
                                    phi_1188_ = _e470;
                                }
                                let _e472 = phi_1188_;
                                phi_1192_ = (((!(_e289) && !(_e325)) && (!(_e362) && !(_e398))) && (!(_e436) && !(_e472)));
                            }
                            let _e477 = phi_1192_;
                            phi_1193_ = _e477;
                            phi_1194_ = _e254;
                        } else {
                            phi_1193_ = bool();
                            phi_1194_ = true;
                        }
                        let _e479 = phi_1193_;
                        let _e481 = phi_1194_;
                        if _e481 {
                            phi_1198_ = false;
                        } else {
                            phi_1198_ = true;
                        }
                        let _e483 = phi_1198_;
                        phi_1199_ = _e479;
                        phi_1200_ = _e483;
                    } else {
                        phi_1199_ = false;
                        phi_1200_ = true;
                    }
                    let _e485 = phi_1199_;
                    let _e487 = phi_1200_;
                    phi_1201_ = _e485;
                    phi_1202_ = _e487;
                } else {
                    phi_1201_ = false;
                    phi_1202_ = true;
                }
                let _e489 = phi_1201_;
                let _e491 = phi_1202_;
                if _e491 {
                    phi_1206_ = _e489;
                } else {
                    phi_1206_ = true;
                }
                let _e493 = phi_1206_;
                if _e493 {
                    let _e495 = atomicAdd((&counters[1u]), 1u);
                    let _e498 = params.member.member.member_4;
                    let _e500 = params.member.member.member_5;
                    let _e502 = paths.member[_e144[0]];
                    let _e504 = paths.member[_e144[1]];
                    let _e510 = paths.member[_e146[0]];
                    let _e512 = paths.member[_e146[1]];
                    local_2 = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e510.member[0] - _e502.member[0]), (_e510.member[1] - _e502.member[1]), (_e510.member[2] - _e502.member[2])), array<f32, 3>((_e510.member_1[0] - _e502.member_1[0]), (_e510.member_1[1] - _e502.member_1[1]), (_e510.member_1[2] - _e502.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e504.member[0] - _e502.member[0]), (_e504.member[1] - _e502.member[1]), (_e504.member[2] - _e502.member[2])), array<f32, 3>((_e504.member_1[0] - _e502.member_1[0]), (_e504.member_1[1] - _e502.member_1[1]), (_e504.member_1[2] - _e502.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e510.member[0] - _e512.member[0]), (_e510.member[1] - _e512.member[1]), (_e510.member[2] - _e512.member[2])), array<f32, 3>((_e510.member_1[0] - _e512.member_1[0]), (_e510.member_1[1] - _e512.member_1[1]), (_e510.member_1[2] - _e512.member_1[2]))), (_e498 + _e498));
                    let _e572 = local_2.member_1[0u];
                    let _e578 = local_2.member_2[0u];
                    let _e584 = ((_e572[1] * _e578[2]) - (_e572[2] * _e578[1]));
                    let _e587 = ((_e572[2] * _e578[0]) - (_e572[0] * _e578[2]));
                    let _e590 = ((_e572[0] * _e578[1]) - (_e572[1] * _e578[0]));
                    let _e593 = local_2.member_1[1u];
                    let _e599 = local_2.member_2[1u];
                    let _e605 = ((_e593[1] * _e599[2]) - (_e593[2] * _e599[1]));
                    let _e608 = ((_e593[2] * _e599[0]) - (_e593[0] * _e599[2]));
                    let _e611 = ((_e593[0] * _e599[1]) - (_e593[1] * _e599[0]));
                    let _e614 = local_2.member_1[0u];
                    let _e620 = local_2.member_2[1u];
                    let _e635 = local_2.member_1[1u];
                    let _e641 = local_2.member_2[0u];
                    let _e654 = (((_e614[1] * _e620[2]) - (_e614[2] * _e620[1])) + ((_e635[1] * _e641[2]) - (_e635[2] * _e641[1])));
                    let _e655 = (((_e614[2] * _e620[0]) - (_e614[0] * _e620[2])) + ((_e635[2] * _e641[0]) - (_e635[0] * _e641[2])));
                    let _e656 = (((_e614[0] * _e620[1]) - (_e614[1] * _e620[0])) + ((_e635[0] * _e641[1]) - (_e635[1] * _e641[0])));
                    let _e659 = local_2.member[0u];
                    let _e670 = local_2.member[1u];
                    let _e681 = local_2.member[0u];
                    let _e690 = ((((_e670[0] * _e584) + (_e670[1] * _e587)) + (_e670[2] * _e590)) + (((_e681[0] * _e654) + (_e681[1] * _e655)) + (_e681[2] * _e656)));
                    let _e693 = local_2.member[0u];
                    let _e704 = local_2.member[1u];
                    let _e713 = ((((_e693[0] * _e605) + (_e693[1] * _e608)) + (_e693[2] * _e611)) + (((_e704[0] * _e654) + (_e704[1] * _e655)) + (_e704[2] * _e656)));
                    let _e716 = local_2.member[1u];
                    let _e727 = local_2.member[0u];
                    if (_e727[0] < 0f) {
                        phi_1597_ = -(_e727[0]);
                    } else {
                        phi_1597_ = _e727[0];
                    }
                    let _e734 = phi_1597_;
                    if (_e727[1] < 0f) {
                        phi_1604_ = -(_e727[1]);
                    } else {
                        phi_1604_ = _e727[1];
                    }
                    let _e738 = phi_1604_;
                    if (_e734 > _e738) {
                        phi_1609_ = _e734;
                    } else {
                        phi_1609_ = _e738;
                    }
                    let _e741 = phi_1609_;
                    if (_e727[2] < 0f) {
                        phi_1616_ = -(_e727[2]);
                    } else {
                        phi_1616_ = _e727[2];
                    }
                    let _e745 = phi_1616_;
                    if (_e741 > _e745) {
                        phi_1621_ = _e741;
                    } else {
                        phi_1621_ = _e745;
                    }
                    let _e748 = phi_1621_;
                    let _e751 = local_2.member[1u];
                    if (_e751[0] < 0f) {
                        phi_1634_ = -(_e751[0]);
                    } else {
                        phi_1634_ = _e751[0];
                    }
                    let _e758 = phi_1634_;
                    if (_e751[1] < 0f) {
                        phi_1641_ = -(_e751[1]);
                    } else {
                        phi_1641_ = _e751[1];
                    }
                    let _e762 = phi_1641_;
                    if (_e758 > _e762) {
                        phi_1646_ = _e758;
                    } else {
                        phi_1646_ = _e762;
                    }
                    let _e765 = phi_1646_;
                    if (_e751[2] < 0f) {
                        phi_1653_ = -(_e751[2]);
                    } else {
                        phi_1653_ = _e751[2];
                    }
                    let _e769 = phi_1653_;
                    if (_e765 > _e769) {
                        phi_1658_ = _e765;
                    } else {
                        phi_1658_ = _e769;
                    }
                    let _e772 = phi_1658_;
                    if (_e748 > _e772) {
                        phi_1663_ = _e748;
                    } else {
                        phi_1663_ = _e772;
                    }
                    let _e775 = phi_1663_;
                    let _e777 = local_2.member_3;
                    let _e778 = (_e775 + _e777);
                    let _e781 = local_2.member_1[0u];
                    if (_e781[0] < 0f) {
                        phi_1680_ = -(_e781[0]);
                    } else {
                        phi_1680_ = _e781[0];
                    }
                    let _e788 = phi_1680_;
                    if (_e781[1] < 0f) {
                        phi_1687_ = -(_e781[1]);
                    } else {
                        phi_1687_ = _e781[1];
                    }
                    let _e792 = phi_1687_;
                    if (_e788 > _e792) {
                        phi_1692_ = _e788;
                    } else {
                        phi_1692_ = _e792;
                    }
                    let _e795 = phi_1692_;
                    if (_e781[2] < 0f) {
                        phi_1699_ = -(_e781[2]);
                    } else {
                        phi_1699_ = _e781[2];
                    }
                    let _e799 = phi_1699_;
                    if (_e795 > _e799) {
                        phi_1704_ = _e795;
                    } else {
                        phi_1704_ = _e799;
                    }
                    let _e802 = phi_1704_;
                    let _e805 = local_2.member_1[1u];
                    if (_e805[0] < 0f) {
                        phi_1718_ = -(_e805[0]);
                    } else {
                        phi_1718_ = _e805[0];
                    }
                    let _e812 = phi_1718_;
                    if (_e805[1] < 0f) {
                        phi_1725_ = -(_e805[1]);
                    } else {
                        phi_1725_ = _e805[1];
                    }
                    let _e816 = phi_1725_;
                    if (_e812 > _e816) {
                        phi_1730_ = _e812;
                    } else {
                        phi_1730_ = _e816;
                    }
                    let _e819 = phi_1730_;
                    if (_e805[2] < 0f) {
                        phi_1737_ = -(_e805[2]);
                    } else {
                        phi_1737_ = _e805[2];
                    }
                    let _e823 = phi_1737_;
                    if (_e819 > _e823) {
                        phi_1742_ = _e819;
                    } else {
                        phi_1742_ = _e823;
                    }
                    let _e826 = phi_1742_;
                    if (_e802 > _e826) {
                        phi_1747_ = _e802;
                    } else {
                        phi_1747_ = _e826;
                    }
                    let _e829 = phi_1747_;
                    let _e831 = local_2.member_3;
                    let _e832 = (_e829 + _e831);
                    let _e835 = local_2.member_2[0u];
                    if (_e835[0] < 0f) {
                        phi_1764_ = -(_e835[0]);
                    } else {
                        phi_1764_ = _e835[0];
                    }
                    let _e842 = phi_1764_;
                    if (_e835[1] < 0f) {
                        phi_1771_ = -(_e835[1]);
                    } else {
                        phi_1771_ = _e835[1];
                    }
                    let _e846 = phi_1771_;
                    if (_e842 > _e846) {
                        phi_1776_ = _e842;
                    } else {
                        phi_1776_ = _e846;
                    }
                    let _e849 = phi_1776_;
                    if (_e835[2] < 0f) {
                        phi_1783_ = -(_e835[2]);
                    } else {
                        phi_1783_ = _e835[2];
                    }
                    let _e853 = phi_1783_;
                    if (_e849 > _e853) {
                        phi_1788_ = _e849;
                    } else {
                        phi_1788_ = _e853;
                    }
                    let _e856 = phi_1788_;
                    let _e859 = local_2.member_2[1u];
                    if (_e859[0] < 0f) {
                        phi_1802_ = -(_e859[0]);
                    } else {
                        phi_1802_ = _e859[0];
                    }
                    let _e866 = phi_1802_;
                    if (_e859[1] < 0f) {
                        phi_1809_ = -(_e859[1]);
                    } else {
                        phi_1809_ = _e859[1];
                    }
                    let _e870 = phi_1809_;
                    if (_e866 > _e870) {
                        phi_1814_ = _e866;
                    } else {
                        phi_1814_ = _e870;
                    }
                    let _e873 = phi_1814_;
                    if (_e859[2] < 0f) {
                        phi_1821_ = -(_e859[2]);
                    } else {
                        phi_1821_ = _e859[2];
                    }
                    let _e877 = phi_1821_;
                    if (_e873 > _e877) {
                        phi_1826_ = _e873;
                    } else {
                        phi_1826_ = _e877;
                    }
                    let _e880 = phi_1826_;
                    if (_e856 > _e880) {
                        phi_1831_ = _e856;
                    } else {
                        phi_1831_ = _e880;
                    }
                    let _e883 = phi_1831_;
                    let _e885 = local_2.member_3;
                    let _e886 = (_e883 + _e885);
                    let _e888 = ((_e832 * 8f) * _e886);
                    let _e895 = local_2.member_3;
                    if (_e584 < 0f) {
                        phi_1862_ = -(_e584);
                    } else {
                        phi_1862_ = _e584;
                    }
                    let _e912 = phi_1862_;
                    if (_e587 < 0f) {
                        phi_1868_ = -(_e587);
                    } else {
                        phi_1868_ = _e587;
                    }
                    let _e916 = phi_1868_;
                    if (_e590 < 0f) {
                        phi_1875_ = -(_e590);
                    } else {
                        phi_1875_ = _e590;
                    }
                    let _e921 = phi_1875_;
                    let _e922 = ((_e912 + _e916) + _e921);
                    if (_e605 < 0f) {
                        phi_1882_ = -(_e605);
                    } else {
                        phi_1882_ = _e605;
                    }
                    let _e926 = phi_1882_;
                    if (_e608 < 0f) {
                        phi_1888_ = -(_e608);
                    } else {
                        phi_1888_ = _e608;
                    }
                    let _e930 = phi_1888_;
                    if (_e611 < 0f) {
                        phi_1895_ = -(_e611);
                    } else {
                        phi_1895_ = _e611;
                    }
                    let _e935 = phi_1895_;
                    let _e936 = ((_e926 + _e930) + _e935);
                    if (_e922 > _e936) {
                        phi_1901_ = _e922;
                    } else {
                        phi_1901_ = _e936;
                    }
                    let _e939 = phi_1901_;
                    if (_e654 < 0f) {
                        phi_1907_ = -(_e654);
                    } else {
                        phi_1907_ = _e654;
                    }
                    let _e943 = phi_1907_;
                    if (_e655 < 0f) {
                        phi_1913_ = -(_e655);
                    } else {
                        phi_1913_ = _e655;
                    }
                    let _e947 = phi_1913_;
                    if (_e656 < 0f) {
                        phi_1920_ = -(_e656);
                    } else {
                        phi_1920_ = _e656;
                    }
                    let _e952 = phi_1920_;
                    let _e954 = (((_e943 + _e947) + _e952) * 0.5f);
                    if (_e939 > _e954) {
                        phi_1927_ = _e939;
                    } else {
                        phi_1927_ = _e954;
                    }
                    let _e957 = phi_1927_;
                    let _e962 = local_2.member_3;
                    let _e975 = ((((_e659[0] * _e584) + (_e659[1] * _e587)) + (_e659[2] * _e590)) * 3f);
                    let _e976 = ((((_e716[0] * _e605) + (_e716[1] * _e608)) + (_e716[2] * _e611)) * 3f);
                    if (_e975 < _e976) {
                        phi_1951_ = _e975;
                    } else {
                        phi_1951_ = _e976;
                    }
                    let _e979 = phi_1951_;
                    if (_e690 < _e713) {
                        phi_1956_ = _e690;
                    } else {
                        phi_1956_ = _e713;
                    }
                    let _e982 = phi_1956_;
                    if (_e979 < _e982) {
                        phi_1961_ = _e979;
                    } else {
                        phi_1961_ = _e982;
                    }
                    let _e985 = phi_1961_;
                    if (_e975 > _e976) {
                        phi_1966_ = _e975;
                    } else {
                        phi_1966_ = _e976;
                    }
                    let _e988 = phi_1966_;
                    if (_e690 > _e713) {
                        phi_1971_ = _e690;
                    } else {
                        phi_1971_ = _e713;
                    }
                    let _e991 = phi_1971_;
                    if (_e988 > _e991) {
                        phi_1976_ = _e988;
                    } else {
                        phi_1976_ = _e991;
                    }
                    let _e994 = phi_1976_;
                    let _e999 = -(_e994);
                    if (_e985 > _e999) {
                        phi_1986_ = _e985;
                    } else {
                        phi_1986_ = _e999;
                    }
                    let _e1002 = phi_1986_;
                    let _e1004 = ((_e1002 - ((((((_e778 * 8f) * _e888) * (0.000000059604645f * (524f / 64f))) + ((_e895 * 19f) * ((_e778 * (_e832 + _e886)) + (_e832 * _e886)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e778) * ((1f + _e832) * (1f + _e886))))) + ((_e500 * (((_e957 + (_e888 * (0.000000059604645f * 8f))) + ((_e962 * 6f) * (_e832 + _e886))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e832) * (1f + _e886))))) * (3f * 1.0001f)))) > 0f);
                    if _e1004 {
                        phi_2955_ = _e1004;
                    } else {
                        let _e1007 = local_2.member_1[0u];
                        let _e1013 = local_2.member_1[1u];
                        let _e1017 = (_e1007[0] + _e1013[0]);
                        let _e1018 = (_e1007[1] + _e1013[1]);
                        let _e1019 = (_e1007[2] + _e1013[2]);
                        let _e1022 = local_2.member_2[0u];
                        let _e1028 = local_2.member_2[1u];
                        let _e1032 = (_e1022[0] + _e1028[0]);
                        let _e1033 = (_e1022[1] + _e1028[1]);
                        let _e1034 = (_e1022[2] + _e1028[2]);
                        let _e1037 = ((_e1018 * _e1034) - (_e1019 * _e1033));
                        let _e1040 = ((_e1019 * _e1032) - (_e1017 * _e1034));
                        let _e1043 = ((_e1017 * _e1033) - (_e1018 * _e1032));
                        let _e1046 = local_2.member[0u];
                        let _e1052 = local_2.member_1[0u];
                        let _e1058 = local_2.member_2[0u];
                        let _e1062 = (_e1046[0] - _e1052[0]);
                        let _e1063 = (_e1046[1] - _e1052[1]);
                        let _e1064 = (_e1046[2] - _e1052[2]);
                        let _e1065 = (_e1062 - _e1058[0]);
                        let _e1066 = (_e1063 - _e1058[1]);
                        let _e1067 = (_e1064 - _e1058[2]);
                        let _e1068 = (_e1046[0] - _e1058[0]);
                        let _e1069 = (_e1046[1] - _e1058[1]);
                        let _e1070 = (_e1046[2] - _e1058[2]);
                        let _e1073 = local_2.member[1u];
                        let _e1079 = local_2.member_1[1u];
                        let _e1085 = local_2.member_2[1u];
                        let _e1089 = (_e1073[0] - _e1079[0]);
                        let _e1090 = (_e1073[1] - _e1079[1]);
                        let _e1091 = (_e1073[2] - _e1079[2]);
                        let _e1092 = (_e1089 - _e1085[0]);
                        let _e1093 = (_e1090 - _e1085[1]);
                        let _e1094 = (_e1091 - _e1085[2]);
                        let _e1095 = (_e1073[0] - _e1085[0]);
                        let _e1096 = (_e1073[1] - _e1085[1]);
                        let _e1097 = (_e1073[2] - _e1085[2]);
                        let _e1100 = local_2.member[0u];
                        if (_e1100[0] < 0f) {
                            phi_2189_ = -(_e1100[0]);
                        } else {
                            phi_2189_ = _e1100[0];
                        }
                        let _e1107 = phi_2189_;
                        if (_e1100[1] < 0f) {
                            phi_2196_ = -(_e1100[1]);
                        } else {
                            phi_2196_ = _e1100[1];
                        }
                        let _e1111 = phi_2196_;
                        if (_e1107 > _e1111) {
                            phi_2201_ = _e1107;
                        } else {
                            phi_2201_ = _e1111;
                        }
                        let _e1114 = phi_2201_;
                        if (_e1100[2] < 0f) {
                            phi_2208_ = -(_e1100[2]);
                        } else {
                            phi_2208_ = _e1100[2];
                        }
                        let _e1118 = phi_2208_;
                        if (_e1114 > _e1118) {
                            phi_2213_ = _e1114;
                        } else {
                            phi_2213_ = _e1118;
                        }
                        let _e1121 = phi_2213_;
                        let _e1124 = local_2.member[1u];
                        if (_e1124[0] < 0f) {
                            phi_2226_ = -(_e1124[0]);
                        } else {
                            phi_2226_ = _e1124[0];
                        }
                        let _e1131 = phi_2226_;
                        if (_e1124[1] < 0f) {
                            phi_2233_ = -(_e1124[1]);
                        } else {
                            phi_2233_ = _e1124[1];
                        }
                        let _e1135 = phi_2233_;
                        if (_e1131 > _e1135) {
                            phi_2238_ = _e1131;
                        } else {
                            phi_2238_ = _e1135;
                        }
                        let _e1138 = phi_2238_;
                        if (_e1124[2] < 0f) {
                            phi_2245_ = -(_e1124[2]);
                        } else {
                            phi_2245_ = _e1124[2];
                        }
                        let _e1142 = phi_2245_;
                        if (_e1138 > _e1142) {
                            phi_2250_ = _e1138;
                        } else {
                            phi_2250_ = _e1142;
                        }
                        let _e1145 = phi_2250_;
                        if (_e1121 > _e1145) {
                            phi_2255_ = _e1121;
                        } else {
                            phi_2255_ = _e1145;
                        }
                        let _e1148 = phi_2255_;
                        let _e1150 = local_2.member_3;
                        let _e1154 = local_2.member_1[0u];
                        if (_e1154[0] < 0f) {
                            phi_2272_ = -(_e1154[0]);
                        } else {
                            phi_2272_ = _e1154[0];
                        }
                        let _e1161 = phi_2272_;
                        if (_e1154[1] < 0f) {
                            phi_2279_ = -(_e1154[1]);
                        } else {
                            phi_2279_ = _e1154[1];
                        }
                        let _e1165 = phi_2279_;
                        if (_e1161 > _e1165) {
                            phi_2284_ = _e1161;
                        } else {
                            phi_2284_ = _e1165;
                        }
                        let _e1168 = phi_2284_;
                        if (_e1154[2] < 0f) {
                            phi_2291_ = -(_e1154[2]);
                        } else {
                            phi_2291_ = _e1154[2];
                        }
                        let _e1172 = phi_2291_;
                        if (_e1168 > _e1172) {
                            phi_2296_ = _e1168;
                        } else {
                            phi_2296_ = _e1172;
                        }
                        let _e1175 = phi_2296_;
                        let _e1178 = local_2.member_1[1u];
                        if (_e1178[0] < 0f) {
                            phi_2310_ = -(_e1178[0]);
                        } else {
                            phi_2310_ = _e1178[0];
                        }
                        let _e1185 = phi_2310_;
                        if (_e1178[1] < 0f) {
                            phi_2317_ = -(_e1178[1]);
                        } else {
                            phi_2317_ = _e1178[1];
                        }
                        let _e1189 = phi_2317_;
                        if (_e1185 > _e1189) {
                            phi_2322_ = _e1185;
                        } else {
                            phi_2322_ = _e1189;
                        }
                        let _e1192 = phi_2322_;
                        if (_e1178[2] < 0f) {
                            phi_2329_ = -(_e1178[2]);
                        } else {
                            phi_2329_ = _e1178[2];
                        }
                        let _e1196 = phi_2329_;
                        if (_e1192 > _e1196) {
                            phi_2334_ = _e1192;
                        } else {
                            phi_2334_ = _e1196;
                        }
                        let _e1199 = phi_2334_;
                        if (_e1175 > _e1199) {
                            phi_2339_ = _e1175;
                        } else {
                            phi_2339_ = _e1199;
                        }
                        let _e1202 = phi_2339_;
                        let _e1204 = local_2.member_3;
                        let _e1208 = local_2.member_2[0u];
                        if (_e1208[0] < 0f) {
                            phi_2356_ = -(_e1208[0]);
                        } else {
                            phi_2356_ = _e1208[0];
                        }
                        let _e1215 = phi_2356_;
                        if (_e1208[1] < 0f) {
                            phi_2363_ = -(_e1208[1]);
                        } else {
                            phi_2363_ = _e1208[1];
                        }
                        let _e1219 = phi_2363_;
                        if (_e1215 > _e1219) {
                            phi_2368_ = _e1215;
                        } else {
                            phi_2368_ = _e1219;
                        }
                        let _e1222 = phi_2368_;
                        if (_e1208[2] < 0f) {
                            phi_2375_ = -(_e1208[2]);
                        } else {
                            phi_2375_ = _e1208[2];
                        }
                        let _e1226 = phi_2375_;
                        if (_e1222 > _e1226) {
                            phi_2380_ = _e1222;
                        } else {
                            phi_2380_ = _e1226;
                        }
                        let _e1229 = phi_2380_;
                        let _e1232 = local_2.member_2[1u];
                        if (_e1232[0] < 0f) {
                            phi_2394_ = -(_e1232[0]);
                        } else {
                            phi_2394_ = _e1232[0];
                        }
                        let _e1239 = phi_2394_;
                        if (_e1232[1] < 0f) {
                            phi_2401_ = -(_e1232[1]);
                        } else {
                            phi_2401_ = _e1232[1];
                        }
                        let _e1243 = phi_2401_;
                        if (_e1239 > _e1243) {
                            phi_2406_ = _e1239;
                        } else {
                            phi_2406_ = _e1243;
                        }
                        let _e1246 = phi_2406_;
                        if (_e1232[2] < 0f) {
                            phi_2413_ = -(_e1232[2]);
                        } else {
                            phi_2413_ = _e1232[2];
                        }
                        let _e1250 = phi_2413_;
                        if (_e1246 > _e1250) {
                            phi_2418_ = _e1246;
                        } else {
                            phi_2418_ = _e1250;
                        }
                        let _e1253 = phi_2418_;
                        if (_e1229 > _e1253) {
                            phi_2423_ = _e1229;
                        } else {
                            phi_2423_ = _e1253;
                        }
                        let _e1256 = phi_2423_;
                        let _e1258 = local_2.member_3;
                        let _e1262 = ((((_e1148 + _e1150) + (_e1202 + _e1204)) + (_e1256 + _e1258)) * 2f);
                        let _e1265 = local_2.member_3;
                        let _e1269 = (((_e500 * 1.0001f) + (_e1265 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                        let _e1272 = ((_e1040 * _e1019) - (_e1043 * _e1018));
                        let _e1275 = ((_e1043 * _e1017) - (_e1037 * _e1019));
                        let _e1278 = ((_e1037 * _e1018) - (_e1040 * _e1017));
                        let _e1283 = (((_e1272 * _e1046[0]) + (_e1275 * _e1046[1])) + (_e1278 * _e1046[2]));
                        let _e1288 = (((_e1272 * _e1062) + (_e1275 * _e1063)) + (_e1278 * _e1064));
                        let _e1293 = (((_e1272 * _e1068) + (_e1275 * _e1069)) + (_e1278 * _e1070));
                        let _e1298 = (((_e1272 * _e1065) + (_e1275 * _e1066)) + (_e1278 * _e1067));
                        let _e1303 = (((_e1272 * _e1073[0]) + (_e1275 * _e1073[1])) + (_e1278 * _e1073[2]));
                        let _e1308 = (((_e1272 * _e1089) + (_e1275 * _e1090)) + (_e1278 * _e1091));
                        let _e1313 = (((_e1272 * _e1095) + (_e1275 * _e1096)) + (_e1278 * _e1097));
                        let _e1318 = (((_e1272 * _e1092) + (_e1275 * _e1093)) + (_e1278 * _e1094));
                        if (_e1283 < _e1288) {
                            phi_2502_ = _e1283;
                        } else {
                            phi_2502_ = _e1288;
                        }
                        let _e1321 = phi_2502_;
                        if (_e1293 < _e1298) {
                            phi_2507_ = _e1293;
                        } else {
                            phi_2507_ = _e1298;
                        }
                        let _e1324 = phi_2507_;
                        if (_e1321 < _e1324) {
                            phi_2512_ = _e1321;
                        } else {
                            phi_2512_ = _e1324;
                        }
                        let _e1327 = phi_2512_;
                        if (_e1303 < _e1308) {
                            phi_2517_ = _e1303;
                        } else {
                            phi_2517_ = _e1308;
                        }
                        let _e1330 = phi_2517_;
                        if (_e1313 < _e1318) {
                            phi_2522_ = _e1313;
                        } else {
                            phi_2522_ = _e1318;
                        }
                        let _e1333 = phi_2522_;
                        if (_e1330 < _e1333) {
                            phi_2527_ = _e1330;
                        } else {
                            phi_2527_ = _e1333;
                        }
                        let _e1336 = phi_2527_;
                        if (_e1327 < _e1336) {
                            phi_2532_ = _e1327;
                        } else {
                            phi_2532_ = _e1336;
                        }
                        let _e1339 = phi_2532_;
                        if (_e1283 > _e1288) {
                            phi_2537_ = _e1283;
                        } else {
                            phi_2537_ = _e1288;
                        }
                        let _e1342 = phi_2537_;
                        if (_e1293 > _e1298) {
                            phi_2542_ = _e1293;
                        } else {
                            phi_2542_ = _e1298;
                        }
                        let _e1345 = phi_2542_;
                        if (_e1342 > _e1345) {
                            phi_2547_ = _e1342;
                        } else {
                            phi_2547_ = _e1345;
                        }
                        let _e1348 = phi_2547_;
                        if (_e1303 > _e1308) {
                            phi_2552_ = _e1303;
                        } else {
                            phi_2552_ = _e1308;
                        }
                        let _e1351 = phi_2552_;
                        if (_e1313 > _e1318) {
                            phi_2557_ = _e1313;
                        } else {
                            phi_2557_ = _e1318;
                        }
                        let _e1354 = phi_2557_;
                        if (_e1351 > _e1354) {
                            phi_2562_ = _e1351;
                        } else {
                            phi_2562_ = _e1354;
                        }
                        let _e1357 = phi_2562_;
                        if (_e1348 > _e1357) {
                            phi_2567_ = _e1348;
                        } else {
                            phi_2567_ = _e1357;
                        }
                        let _e1360 = phi_2567_;
                        if (_e1272 < 0f) {
                            phi_2573_ = -(_e1272);
                        } else {
                            phi_2573_ = _e1272;
                        }
                        let _e1364 = phi_2573_;
                        if (_e1275 < 0f) {
                            phi_2579_ = -(_e1275);
                        } else {
                            phi_2579_ = _e1275;
                        }
                        let _e1368 = phi_2579_;
                        if (_e1278 < 0f) {
                            phi_2586_ = -(_e1278);
                        } else {
                            phi_2586_ = _e1278;
                        }
                        let _e1373 = phi_2586_;
                        let _e1374 = ((_e1364 + _e1368) + _e1373);
                        let _e1379 = -(_e1360);
                        if (_e1339 > _e1379) {
                            phi_2597_ = _e1339;
                        } else {
                            phi_2597_ = _e1379;
                        }
                        let _e1382 = phi_2597_;
                        let _e1387 = (((_e1382 - ((_e1374 * _e1262) * (0.000000059604645f * (17f / 2f)))) - (_e1374 * _e1269)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        let _e1390 = ((_e1040 * _e1034) - (_e1043 * _e1033));
                        let _e1393 = ((_e1043 * _e1032) - (_e1037 * _e1034));
                        let _e1396 = ((_e1037 * _e1033) - (_e1040 * _e1032));
                        let _e1401 = (((_e1390 * _e1046[0]) + (_e1393 * _e1046[1])) + (_e1396 * _e1046[2]));
                        let _e1406 = (((_e1390 * _e1062) + (_e1393 * _e1063)) + (_e1396 * _e1064));
                        let _e1411 = (((_e1390 * _e1068) + (_e1393 * _e1069)) + (_e1396 * _e1070));
                        let _e1416 = (((_e1390 * _e1065) + (_e1393 * _e1066)) + (_e1396 * _e1067));
                        let _e1421 = (((_e1390 * _e1073[0]) + (_e1393 * _e1073[1])) + (_e1396 * _e1073[2]));
                        let _e1426 = (((_e1390 * _e1089) + (_e1393 * _e1090)) + (_e1396 * _e1091));
                        let _e1431 = (((_e1390 * _e1095) + (_e1393 * _e1096)) + (_e1396 * _e1097));
                        let _e1436 = (((_e1390 * _e1092) + (_e1393 * _e1093)) + (_e1396 * _e1094));
                        if (_e1401 < _e1406) {
                            phi_2668_ = _e1401;
                        } else {
                            phi_2668_ = _e1406;
                        }
                        let _e1439 = phi_2668_;
                        if (_e1411 < _e1416) {
                            phi_2673_ = _e1411;
                        } else {
                            phi_2673_ = _e1416;
                        }
                        let _e1442 = phi_2673_;
                        if (_e1439 < _e1442) {
                            phi_2678_ = _e1439;
                        } else {
                            phi_2678_ = _e1442;
                        }
                        let _e1445 = phi_2678_;
                        if (_e1421 < _e1426) {
                            phi_2683_ = _e1421;
                        } else {
                            phi_2683_ = _e1426;
                        }
                        let _e1448 = phi_2683_;
                        if (_e1431 < _e1436) {
                            phi_2688_ = _e1431;
                        } else {
                            phi_2688_ = _e1436;
                        }
                        let _e1451 = phi_2688_;
                        if (_e1448 < _e1451) {
                            phi_2693_ = _e1448;
                        } else {
                            phi_2693_ = _e1451;
                        }
                        let _e1454 = phi_2693_;
                        if (_e1445 < _e1454) {
                            phi_2698_ = _e1445;
                        } else {
                            phi_2698_ = _e1454;
                        }
                        let _e1457 = phi_2698_;
                        if (_e1401 > _e1406) {
                            phi_2703_ = _e1401;
                        } else {
                            phi_2703_ = _e1406;
                        }
                        let _e1460 = phi_2703_;
                        if (_e1411 > _e1416) {
                            phi_2708_ = _e1411;
                        } else {
                            phi_2708_ = _e1416;
                        }
                        let _e1463 = phi_2708_;
                        if (_e1460 > _e1463) {
                            phi_2713_ = _e1460;
                        } else {
                            phi_2713_ = _e1463;
                        }
                        let _e1466 = phi_2713_;
                        if (_e1421 > _e1426) {
                            phi_2718_ = _e1421;
                        } else {
                            phi_2718_ = _e1426;
                        }
                        let _e1469 = phi_2718_;
                        if (_e1431 > _e1436) {
                            phi_2723_ = _e1431;
                        } else {
                            phi_2723_ = _e1436;
                        }
                        let _e1472 = phi_2723_;
                        if (_e1469 > _e1472) {
                            phi_2728_ = _e1469;
                        } else {
                            phi_2728_ = _e1472;
                        }
                        let _e1475 = phi_2728_;
                        if (_e1466 > _e1475) {
                            phi_2733_ = _e1466;
                        } else {
                            phi_2733_ = _e1475;
                        }
                        let _e1478 = phi_2733_;
                        if (_e1390 < 0f) {
                            phi_2739_ = -(_e1390);
                        } else {
                            phi_2739_ = _e1390;
                        }
                        let _e1482 = phi_2739_;
                        if (_e1393 < 0f) {
                            phi_2745_ = -(_e1393);
                        } else {
                            phi_2745_ = _e1393;
                        }
                        let _e1486 = phi_2745_;
                        if (_e1396 < 0f) {
                            phi_2752_ = -(_e1396);
                        } else {
                            phi_2752_ = _e1396;
                        }
                        let _e1491 = phi_2752_;
                        let _e1492 = ((_e1482 + _e1486) + _e1491);
                        let _e1497 = -(_e1478);
                        if (_e1457 > _e1497) {
                            phi_2763_ = _e1457;
                        } else {
                            phi_2763_ = _e1497;
                        }
                        let _e1500 = phi_2763_;
                        let _e1505 = (((_e1500 - ((_e1492 * _e1262) * (0.000000059604645f * (17f / 2f)))) - (_e1492 * _e1269)) - (0.000000000000000000000000000000000000011754944f * 64f));
                        if (_e1387 > _e1505) {
                            phi_2773_ = _e1387;
                        } else {
                            phi_2773_ = _e1505;
                        }
                        let _e1508 = phi_2773_;
                        phi_2955_ = (_e1004 || (_e1508 > 0f));
                    }
                    let _e1512 = phi_2955_;
                    if _e1512 {
                        phi_6372_ = _e1512;
                    } else {
                        let _e1515 = local_2.member[0u];
                        let _e1521 = local_2.member[1u];
                        let _e1528 = ((_e1515[0] + _e1521[0]) * 0.5f);
                        let _e1529 = ((_e1515[1] + _e1521[1]) * 0.5f);
                        let _e1530 = ((_e1515[2] + _e1521[2]) * 0.5f);
                        let _e1533 = local_2.member_1[0u];
                        let _e1539 = local_2.member_1[1u];
                        let _e1546 = ((_e1533[0] + _e1539[0]) * 0.5f);
                        let _e1547 = ((_e1533[1] + _e1539[1]) * 0.5f);
                        let _e1548 = ((_e1533[2] + _e1539[2]) * 0.5f);
                        let _e1551 = local_2.member_2[0u];
                        let _e1557 = local_2.member_2[1u];
                        let _e1564 = ((_e1551[0] + _e1557[0]) * 0.5f);
                        let _e1565 = ((_e1551[1] + _e1557[1]) * 0.5f);
                        let _e1566 = ((_e1551[2] + _e1557[2]) * 0.5f);
                        let _e1569 = local_2.member[0u];
                        let _e1572 = local_2.member_1[0u];
                        let _e1575 = local_2.member_2[0u];
                        let _e1577 = local_2.member_3;
                        let _e1580 = local_2.member[1u];
                        let _e1583 = local_2.member_1[1u];
                        let _e1586 = local_2.member_2[1u];
                        let _e1588 = local_2.member_3;
                        local = type_28(array<array<f32, 3>, 2>(_e1569, array<f32, 3>(_e1528, _e1529, _e1530)), array<array<f32, 3>, 2>(_e1572, array<f32, 3>(_e1546, _e1547, _e1548)), array<array<f32, 3>, 2>(_e1575, array<f32, 3>(_e1564, _e1565, _e1566)), _e1577);
                        local_1 = type_28(array<array<f32, 3>, 2>(array<f32, 3>(_e1528, _e1529, _e1530), _e1580), array<array<f32, 3>, 2>(array<f32, 3>(_e1546, _e1547, _e1548), _e1583), array<array<f32, 3>, 2>(array<f32, 3>(_e1564, _e1565, _e1566), _e1586), _e1588);
                        let _e1605 = local.member_1[0u];
                        let _e1611 = local.member_2[0u];
                        let _e1617 = ((_e1605[1] * _e1611[2]) - (_e1605[2] * _e1611[1]));
                        let _e1620 = ((_e1605[2] * _e1611[0]) - (_e1605[0] * _e1611[2]));
                        let _e1623 = ((_e1605[0] * _e1611[1]) - (_e1605[1] * _e1611[0]));
                        let _e1626 = local.member_1[1u];
                        let _e1632 = local.member_2[1u];
                        let _e1638 = ((_e1626[1] * _e1632[2]) - (_e1626[2] * _e1632[1]));
                        let _e1641 = ((_e1626[2] * _e1632[0]) - (_e1626[0] * _e1632[2]));
                        let _e1644 = ((_e1626[0] * _e1632[1]) - (_e1626[1] * _e1632[0]));
                        let _e1647 = local.member_1[0u];
                        let _e1653 = local.member_2[1u];
                        let _e1668 = local.member_1[1u];
                        let _e1674 = local.member_2[0u];
                        let _e1687 = (((_e1647[1] * _e1653[2]) - (_e1647[2] * _e1653[1])) + ((_e1668[1] * _e1674[2]) - (_e1668[2] * _e1674[1])));
                        let _e1688 = (((_e1647[2] * _e1653[0]) - (_e1647[0] * _e1653[2])) + ((_e1668[2] * _e1674[0]) - (_e1668[0] * _e1674[2])));
                        let _e1689 = (((_e1647[0] * _e1653[1]) - (_e1647[1] * _e1653[0])) + ((_e1668[0] * _e1674[1]) - (_e1668[1] * _e1674[0])));
                        let _e1692 = local.member[0u];
                        let _e1703 = local.member[1u];
                        let _e1714 = local.member[0u];
                        let _e1723 = ((((_e1703[0] * _e1617) + (_e1703[1] * _e1620)) + (_e1703[2] * _e1623)) + (((_e1714[0] * _e1687) + (_e1714[1] * _e1688)) + (_e1714[2] * _e1689)));
                        let _e1726 = local.member[0u];
                        let _e1737 = local.member[1u];
                        let _e1746 = ((((_e1726[0] * _e1638) + (_e1726[1] * _e1641)) + (_e1726[2] * _e1644)) + (((_e1737[0] * _e1687) + (_e1737[1] * _e1688)) + (_e1737[2] * _e1689)));
                        let _e1749 = local.member[1u];
                        let _e1760 = local.member[0u];
                        if (_e1760[0] < 0f) {
                            phi_3407_ = -(_e1760[0]);
                        } else {
                            phi_3407_ = _e1760[0];
                        }
                        let _e1767 = phi_3407_;
                        if (_e1760[1] < 0f) {
                            phi_3414_ = -(_e1760[1]);
                        } else {
                            phi_3414_ = _e1760[1];
                        }
                        let _e1771 = phi_3414_;
                        if (_e1767 > _e1771) {
                            phi_3419_ = _e1767;
                        } else {
                            phi_3419_ = _e1771;
                        }
                        let _e1774 = phi_3419_;
                        if (_e1760[2] < 0f) {
                            phi_3426_ = -(_e1760[2]);
                        } else {
                            phi_3426_ = _e1760[2];
                        }
                        let _e1778 = phi_3426_;
                        if (_e1774 > _e1778) {
                            phi_3431_ = _e1774;
                        } else {
                            phi_3431_ = _e1778;
                        }
                        let _e1781 = phi_3431_;
                        let _e1784 = local.member[1u];
                        if (_e1784[0] < 0f) {
                            phi_3444_ = -(_e1784[0]);
                        } else {
                            phi_3444_ = _e1784[0];
                        }
                        let _e1791 = phi_3444_;
                        if (_e1784[1] < 0f) {
                            phi_3451_ = -(_e1784[1]);
                        } else {
                            phi_3451_ = _e1784[1];
                        }
                        let _e1795 = phi_3451_;
                        if (_e1791 > _e1795) {
                            phi_3456_ = _e1791;
                        } else {
                            phi_3456_ = _e1795;
                        }
                        let _e1798 = phi_3456_;
                        if (_e1784[2] < 0f) {
                            phi_3463_ = -(_e1784[2]);
                        } else {
                            phi_3463_ = _e1784[2];
                        }
                        let _e1802 = phi_3463_;
                        if (_e1798 > _e1802) {
                            phi_3468_ = _e1798;
                        } else {
                            phi_3468_ = _e1802;
                        }
                        let _e1805 = phi_3468_;
                        if (_e1781 > _e1805) {
                            phi_3473_ = _e1781;
                        } else {
                            phi_3473_ = _e1805;
                        }
                        let _e1808 = phi_3473_;
                        let _e1810 = local.member_3;
                        let _e1811 = (_e1808 + _e1810);
                        let _e1814 = local.member_1[0u];
                        if (_e1814[0] < 0f) {
                            phi_3490_ = -(_e1814[0]);
                        } else {
                            phi_3490_ = _e1814[0];
                        }
                        let _e1821 = phi_3490_;
                        if (_e1814[1] < 0f) {
                            phi_3497_ = -(_e1814[1]);
                        } else {
                            phi_3497_ = _e1814[1];
                        }
                        let _e1825 = phi_3497_;
                        if (_e1821 > _e1825) {
                            phi_3502_ = _e1821;
                        } else {
                            phi_3502_ = _e1825;
                        }
                        let _e1828 = phi_3502_;
                        if (_e1814[2] < 0f) {
                            phi_3509_ = -(_e1814[2]);
                        } else {
                            phi_3509_ = _e1814[2];
                        }
                        let _e1832 = phi_3509_;
                        if (_e1828 > _e1832) {
                            phi_3514_ = _e1828;
                        } else {
                            phi_3514_ = _e1832;
                        }
                        let _e1835 = phi_3514_;
                        let _e1838 = local.member_1[1u];
                        if (_e1838[0] < 0f) {
                            phi_3528_ = -(_e1838[0]);
                        } else {
                            phi_3528_ = _e1838[0];
                        }
                        let _e1845 = phi_3528_;
                        if (_e1838[1] < 0f) {
                            phi_3535_ = -(_e1838[1]);
                        } else {
                            phi_3535_ = _e1838[1];
                        }
                        let _e1849 = phi_3535_;
                        if (_e1845 > _e1849) {
                            phi_3540_ = _e1845;
                        } else {
                            phi_3540_ = _e1849;
                        }
                        let _e1852 = phi_3540_;
                        if (_e1838[2] < 0f) {
                            phi_3547_ = -(_e1838[2]);
                        } else {
                            phi_3547_ = _e1838[2];
                        }
                        let _e1856 = phi_3547_;
                        if (_e1852 > _e1856) {
                            phi_3552_ = _e1852;
                        } else {
                            phi_3552_ = _e1856;
                        }
                        let _e1859 = phi_3552_;
                        if (_e1835 > _e1859) {
                            phi_3557_ = _e1835;
                        } else {
                            phi_3557_ = _e1859;
                        }
                        let _e1862 = phi_3557_;
                        let _e1864 = local.member_3;
                        let _e1865 = (_e1862 + _e1864);
                        let _e1868 = local.member_2[0u];
                        if (_e1868[0] < 0f) {
                            phi_3574_ = -(_e1868[0]);
                        } else {
                            phi_3574_ = _e1868[0];
                        }
                        let _e1875 = phi_3574_;
                        if (_e1868[1] < 0f) {
                            phi_3581_ = -(_e1868[1]);
                        } else {
                            phi_3581_ = _e1868[1];
                        }
                        let _e1879 = phi_3581_;
                        if (_e1875 > _e1879) {
                            phi_3586_ = _e1875;
                        } else {
                            phi_3586_ = _e1879;
                        }
                        let _e1882 = phi_3586_;
                        if (_e1868[2] < 0f) {
                            phi_3593_ = -(_e1868[2]);
                        } else {
                            phi_3593_ = _e1868[2];
                        }
                        let _e1886 = phi_3593_;
                        if (_e1882 > _e1886) {
                            phi_3598_ = _e1882;
                        } else {
                            phi_3598_ = _e1886;
                        }
                        let _e1889 = phi_3598_;
                        let _e1892 = local.member_2[1u];
                        if (_e1892[0] < 0f) {
                            phi_3612_ = -(_e1892[0]);
                        } else {
                            phi_3612_ = _e1892[0];
                        }
                        let _e1899 = phi_3612_;
                        if (_e1892[1] < 0f) {
                            phi_3619_ = -(_e1892[1]);
                        } else {
                            phi_3619_ = _e1892[1];
                        }
                        let _e1903 = phi_3619_;
                        if (_e1899 > _e1903) {
                            phi_3624_ = _e1899;
                        } else {
                            phi_3624_ = _e1903;
                        }
                        let _e1906 = phi_3624_;
                        if (_e1892[2] < 0f) {
                            phi_3631_ = -(_e1892[2]);
                        } else {
                            phi_3631_ = _e1892[2];
                        }
                        let _e1910 = phi_3631_;
                        if (_e1906 > _e1910) {
                            phi_3636_ = _e1906;
                        } else {
                            phi_3636_ = _e1910;
                        }
                        let _e1913 = phi_3636_;
                        if (_e1889 > _e1913) {
                            phi_3641_ = _e1889;
                        } else {
                            phi_3641_ = _e1913;
                        }
                        let _e1916 = phi_3641_;
                        let _e1918 = local.member_3;
                        let _e1919 = (_e1916 + _e1918);
                        let _e1921 = ((_e1865 * 8f) * _e1919);
                        let _e1928 = local.member_3;
                        if (_e1617 < 0f) {
                            phi_3672_ = -(_e1617);
                        } else {
                            phi_3672_ = _e1617;
                        }
                        let _e1945 = phi_3672_;
                        if (_e1620 < 0f) {
                            phi_3678_ = -(_e1620);
                        } else {
                            phi_3678_ = _e1620;
                        }
                        let _e1949 = phi_3678_;
                        if (_e1623 < 0f) {
                            phi_3685_ = -(_e1623);
                        } else {
                            phi_3685_ = _e1623;
                        }
                        let _e1954 = phi_3685_;
                        let _e1955 = ((_e1945 + _e1949) + _e1954);
                        if (_e1638 < 0f) {
                            phi_3692_ = -(_e1638);
                        } else {
                            phi_3692_ = _e1638;
                        }
                        let _e1959 = phi_3692_;
                        if (_e1641 < 0f) {
                            phi_3698_ = -(_e1641);
                        } else {
                            phi_3698_ = _e1641;
                        }
                        let _e1963 = phi_3698_;
                        if (_e1644 < 0f) {
                            phi_3705_ = -(_e1644);
                        } else {
                            phi_3705_ = _e1644;
                        }
                        let _e1968 = phi_3705_;
                        let _e1969 = ((_e1959 + _e1963) + _e1968);
                        if (_e1955 > _e1969) {
                            phi_3711_ = _e1955;
                        } else {
                            phi_3711_ = _e1969;
                        }
                        let _e1972 = phi_3711_;
                        if (_e1687 < 0f) {
                            phi_3717_ = -(_e1687);
                        } else {
                            phi_3717_ = _e1687;
                        }
                        let _e1976 = phi_3717_;
                        if (_e1688 < 0f) {
                            phi_3723_ = -(_e1688);
                        } else {
                            phi_3723_ = _e1688;
                        }
                        let _e1980 = phi_3723_;
                        if (_e1689 < 0f) {
                            phi_3730_ = -(_e1689);
                        } else {
                            phi_3730_ = _e1689;
                        }
                        let _e1985 = phi_3730_;
                        let _e1987 = (((_e1976 + _e1980) + _e1985) * 0.5f);
                        if (_e1972 > _e1987) {
                            phi_3737_ = _e1972;
                        } else {
                            phi_3737_ = _e1987;
                        }
                        let _e1990 = phi_3737_;
                        let _e1995 = local.member_3;
                        let _e2008 = ((((_e1692[0] * _e1617) + (_e1692[1] * _e1620)) + (_e1692[2] * _e1623)) * 3f);
                        let _e2009 = ((((_e1749[0] * _e1638) + (_e1749[1] * _e1641)) + (_e1749[2] * _e1644)) * 3f);
                        if (_e2008 < _e2009) {
                            phi_3761_ = _e2008;
                        } else {
                            phi_3761_ = _e2009;
                        }
                        let _e2012 = phi_3761_;
                        if (_e1723 < _e1746) {
                            phi_3766_ = _e1723;
                        } else {
                            phi_3766_ = _e1746;
                        }
                        let _e2015 = phi_3766_;
                        if (_e2012 < _e2015) {
                            phi_3771_ = _e2012;
                        } else {
                            phi_3771_ = _e2015;
                        }
                        let _e2018 = phi_3771_;
                        if (_e2008 > _e2009) {
                            phi_3776_ = _e2008;
                        } else {
                            phi_3776_ = _e2009;
                        }
                        let _e2021 = phi_3776_;
                        if (_e1723 > _e1746) {
                            phi_3781_ = _e1723;
                        } else {
                            phi_3781_ = _e1746;
                        }
                        let _e2024 = phi_3781_;
                        if (_e2021 > _e2024) {
                            phi_3786_ = _e2021;
                        } else {
                            phi_3786_ = _e2024;
                        }
                        let _e2027 = phi_3786_;
                        let _e2032 = -(_e2027);
                        if (_e2018 > _e2032) {
                            phi_3796_ = _e2018;
                        } else {
                            phi_3796_ = _e2032;
                        }
                        let _e2035 = phi_3796_;
                        let _e2037 = ((_e2035 - ((((((_e1811 * 8f) * _e1921) * (0.000000059604645f * (524f / 64f))) + ((_e1928 * 19f) * ((_e1811 * (_e1865 + _e1919)) + (_e1865 * _e1919)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1811) * ((1f + _e1865) * (1f + _e1919))))) + ((_e500 * (((_e1990 + (_e1921 * (0.000000059604645f * 8f))) + ((_e1995 * 6f) * (_e1865 + _e1919))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1865) * (1f + _e1919))))) * (3f * 1.0001f)))) > 0f);
                        if _e2037 {
                            phi_4765_ = _e2037;
                        } else {
                            let _e2040 = local.member_1[0u];
                            let _e2046 = local.member_1[1u];
                            let _e2050 = (_e2040[0] + _e2046[0]);
                            let _e2051 = (_e2040[1] + _e2046[1]);
                            let _e2052 = (_e2040[2] + _e2046[2]);
                            let _e2055 = local.member_2[0u];
                            let _e2061 = local.member_2[1u];
                            let _e2065 = (_e2055[0] + _e2061[0]);
                            let _e2066 = (_e2055[1] + _e2061[1]);
                            let _e2067 = (_e2055[2] + _e2061[2]);
                            let _e2070 = ((_e2051 * _e2067) - (_e2052 * _e2066));
                            let _e2073 = ((_e2052 * _e2065) - (_e2050 * _e2067));
                            let _e2076 = ((_e2050 * _e2066) - (_e2051 * _e2065));
                            let _e2079 = local.member[0u];
                            let _e2085 = local.member_1[0u];
                            let _e2091 = local.member_2[0u];
                            let _e2095 = (_e2079[0] - _e2085[0]);
                            let _e2096 = (_e2079[1] - _e2085[1]);
                            let _e2097 = (_e2079[2] - _e2085[2]);
                            let _e2098 = (_e2095 - _e2091[0]);
                            let _e2099 = (_e2096 - _e2091[1]);
                            let _e2100 = (_e2097 - _e2091[2]);
                            let _e2101 = (_e2079[0] - _e2091[0]);
                            let _e2102 = (_e2079[1] - _e2091[1]);
                            let _e2103 = (_e2079[2] - _e2091[2]);
                            let _e2106 = local.member[1u];
                            let _e2112 = local.member_1[1u];
                            let _e2118 = local.member_2[1u];
                            let _e2122 = (_e2106[0] - _e2112[0]);
                            let _e2123 = (_e2106[1] - _e2112[1]);
                            let _e2124 = (_e2106[2] - _e2112[2]);
                            let _e2125 = (_e2122 - _e2118[0]);
                            let _e2126 = (_e2123 - _e2118[1]);
                            let _e2127 = (_e2124 - _e2118[2]);
                            let _e2128 = (_e2106[0] - _e2118[0]);
                            let _e2129 = (_e2106[1] - _e2118[1]);
                            let _e2130 = (_e2106[2] - _e2118[2]);
                            let _e2133 = local.member[0u];
                            if (_e2133[0] < 0f) {
                                phi_3999_ = -(_e2133[0]);
                            } else {
                                phi_3999_ = _e2133[0];
                            }
                            let _e2140 = phi_3999_;
                            if (_e2133[1] < 0f) {
                                phi_4006_ = -(_e2133[1]);
                            } else {
                                phi_4006_ = _e2133[1];
                            }
                            let _e2144 = phi_4006_;
                            if (_e2140 > _e2144) {
                                phi_4011_ = _e2140;
                            } else {
                                phi_4011_ = _e2144;
                            }
                            let _e2147 = phi_4011_;
                            if (_e2133[2] < 0f) {
                                phi_4018_ = -(_e2133[2]);
                            } else {
                                phi_4018_ = _e2133[2];
                            }
                            let _e2151 = phi_4018_;
                            if (_e2147 > _e2151) {
                                phi_4023_ = _e2147;
                            } else {
                                phi_4023_ = _e2151;
                            }
                            let _e2154 = phi_4023_;
                            let _e2157 = local.member[1u];
                            if (_e2157[0] < 0f) {
                                phi_4036_ = -(_e2157[0]);
                            } else {
                                phi_4036_ = _e2157[0];
                            }
                            let _e2164 = phi_4036_;
                            if (_e2157[1] < 0f) {
                                phi_4043_ = -(_e2157[1]);
                            } else {
                                phi_4043_ = _e2157[1];
                            }
                            let _e2168 = phi_4043_;
                            if (_e2164 > _e2168) {
                                phi_4048_ = _e2164;
                            } else {
                                phi_4048_ = _e2168;
                            }
                            let _e2171 = phi_4048_;
                            if (_e2157[2] < 0f) {
                                phi_4055_ = -(_e2157[2]);
                            } else {
                                phi_4055_ = _e2157[2];
                            }
                            let _e2175 = phi_4055_;
                            if (_e2171 > _e2175) {
                                phi_4060_ = _e2171;
                            } else {
                                phi_4060_ = _e2175;
                            }
                            let _e2178 = phi_4060_;
                            if (_e2154 > _e2178) {
                                phi_4065_ = _e2154;
                            } else {
                                phi_4065_ = _e2178;
                            }
                            let _e2181 = phi_4065_;
                            let _e2183 = local.member_3;
                            let _e2187 = local.member_1[0u];
                            if (_e2187[0] < 0f) {
                                phi_4082_ = -(_e2187[0]);
                            } else {
                                phi_4082_ = _e2187[0];
                            }
                            let _e2194 = phi_4082_;
                            if (_e2187[1] < 0f) {
                                phi_4089_ = -(_e2187[1]);
                            } else {
                                phi_4089_ = _e2187[1];
                            }
                            let _e2198 = phi_4089_;
                            if (_e2194 > _e2198) {
                                phi_4094_ = _e2194;
                            } else {
                                phi_4094_ = _e2198;
                            }
                            let _e2201 = phi_4094_;
                            if (_e2187[2] < 0f) {
                                phi_4101_ = -(_e2187[2]);
                            } else {
                                phi_4101_ = _e2187[2];
                            }
                            let _e2205 = phi_4101_;
                            if (_e2201 > _e2205) {
                                phi_4106_ = _e2201;
                            } else {
                                phi_4106_ = _e2205;
                            }
                            let _e2208 = phi_4106_;
                            let _e2211 = local.member_1[1u];
                            if (_e2211[0] < 0f) {
                                phi_4120_ = -(_e2211[0]);
                            } else {
                                phi_4120_ = _e2211[0];
                            }
                            let _e2218 = phi_4120_;
                            if (_e2211[1] < 0f) {
                                phi_4127_ = -(_e2211[1]);
                            } else {
                                phi_4127_ = _e2211[1];
                            }
                            let _e2222 = phi_4127_;
                            if (_e2218 > _e2222) {
                                phi_4132_ = _e2218;
                            } else {
                                phi_4132_ = _e2222;
                            }
                            let _e2225 = phi_4132_;
                            if (_e2211[2] < 0f) {
                                phi_4139_ = -(_e2211[2]);
                            } else {
                                phi_4139_ = _e2211[2];
                            }
                            let _e2229 = phi_4139_;
                            if (_e2225 > _e2229) {
                                phi_4144_ = _e2225;
                            } else {
                                phi_4144_ = _e2229;
                            }
                            let _e2232 = phi_4144_;
                            if (_e2208 > _e2232) {
                                phi_4149_ = _e2208;
                            } else {
                                phi_4149_ = _e2232;
                            }
                            let _e2235 = phi_4149_;
                            let _e2237 = local.member_3;
                            let _e2241 = local.member_2[0u];
                            if (_e2241[0] < 0f) {
                                phi_4166_ = -(_e2241[0]);
                            } else {
                                phi_4166_ = _e2241[0];
                            }
                            let _e2248 = phi_4166_;
                            if (_e2241[1] < 0f) {
                                phi_4173_ = -(_e2241[1]);
                            } else {
                                phi_4173_ = _e2241[1];
                            }
                            let _e2252 = phi_4173_;
                            if (_e2248 > _e2252) {
                                phi_4178_ = _e2248;
                            } else {
                                phi_4178_ = _e2252;
                            }
                            let _e2255 = phi_4178_;
                            if (_e2241[2] < 0f) {
                                phi_4185_ = -(_e2241[2]);
                            } else {
                                phi_4185_ = _e2241[2];
                            }
                            let _e2259 = phi_4185_;
                            if (_e2255 > _e2259) {
                                phi_4190_ = _e2255;
                            } else {
                                phi_4190_ = _e2259;
                            }
                            let _e2262 = phi_4190_;
                            let _e2265 = local.member_2[1u];
                            if (_e2265[0] < 0f) {
                                phi_4204_ = -(_e2265[0]);
                            } else {
                                phi_4204_ = _e2265[0];
                            }
                            let _e2272 = phi_4204_;
                            if (_e2265[1] < 0f) {
                                phi_4211_ = -(_e2265[1]);
                            } else {
                                phi_4211_ = _e2265[1];
                            }
                            let _e2276 = phi_4211_;
                            if (_e2272 > _e2276) {
                                phi_4216_ = _e2272;
                            } else {
                                phi_4216_ = _e2276;
                            }
                            let _e2279 = phi_4216_;
                            if (_e2265[2] < 0f) {
                                phi_4223_ = -(_e2265[2]);
                            } else {
                                phi_4223_ = _e2265[2];
                            }
                            let _e2283 = phi_4223_;
                            if (_e2279 > _e2283) {
                                phi_4228_ = _e2279;
                            } else {
                                phi_4228_ = _e2283;
                            }
                            let _e2286 = phi_4228_;
                            if (_e2262 > _e2286) {
                                phi_4233_ = _e2262;
                            } else {
                                phi_4233_ = _e2286;
                            }
                            let _e2289 = phi_4233_;
                            let _e2291 = local.member_3;
                            let _e2295 = ((((_e2181 + _e2183) + (_e2235 + _e2237)) + (_e2289 + _e2291)) * 2f);
                            let _e2298 = local.member_3;
                            let _e2302 = (((_e500 * 1.0001f) + (_e2298 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e2305 = ((_e2073 * _e2052) - (_e2076 * _e2051));
                            let _e2308 = ((_e2076 * _e2050) - (_e2070 * _e2052));
                            let _e2311 = ((_e2070 * _e2051) - (_e2073 * _e2050));
                            let _e2316 = (((_e2305 * _e2079[0]) + (_e2308 * _e2079[1])) + (_e2311 * _e2079[2]));
                            let _e2321 = (((_e2305 * _e2095) + (_e2308 * _e2096)) + (_e2311 * _e2097));
                            let _e2326 = (((_e2305 * _e2101) + (_e2308 * _e2102)) + (_e2311 * _e2103));
                            let _e2331 = (((_e2305 * _e2098) + (_e2308 * _e2099)) + (_e2311 * _e2100));
                            let _e2336 = (((_e2305 * _e2106[0]) + (_e2308 * _e2106[1])) + (_e2311 * _e2106[2]));
                            let _e2341 = (((_e2305 * _e2122) + (_e2308 * _e2123)) + (_e2311 * _e2124));
                            let _e2346 = (((_e2305 * _e2128) + (_e2308 * _e2129)) + (_e2311 * _e2130));
                            let _e2351 = (((_e2305 * _e2125) + (_e2308 * _e2126)) + (_e2311 * _e2127));
                            if (_e2316 < _e2321) {
                                phi_4312_ = _e2316;
                            } else {
                                phi_4312_ = _e2321;
                            }
                            let _e2354 = phi_4312_;
                            if (_e2326 < _e2331) {
                                phi_4317_ = _e2326;
                            } else {
                                phi_4317_ = _e2331;
                            }
                            let _e2357 = phi_4317_;
                            if (_e2354 < _e2357) {
                                phi_4322_ = _e2354;
                            } else {
                                phi_4322_ = _e2357;
                            }
                            let _e2360 = phi_4322_;
                            if (_e2336 < _e2341) {
                                phi_4327_ = _e2336;
                            } else {
                                phi_4327_ = _e2341;
                            }
                            let _e2363 = phi_4327_;
                            if (_e2346 < _e2351) {
                                phi_4332_ = _e2346;
                            } else {
                                phi_4332_ = _e2351;
                            }
                            let _e2366 = phi_4332_;
                            if (_e2363 < _e2366) {
                                phi_4337_ = _e2363;
                            } else {
                                phi_4337_ = _e2366;
                            }
                            let _e2369 = phi_4337_;
                            if (_e2360 < _e2369) {
                                phi_4342_ = _e2360;
                            } else {
                                phi_4342_ = _e2369;
                            }
                            let _e2372 = phi_4342_;
                            if (_e2316 > _e2321) {
                                phi_4347_ = _e2316;
                            } else {
                                phi_4347_ = _e2321;
                            }
                            let _e2375 = phi_4347_;
                            if (_e2326 > _e2331) {
                                phi_4352_ = _e2326;
                            } else {
                                phi_4352_ = _e2331;
                            }
                            let _e2378 = phi_4352_;
                            if (_e2375 > _e2378) {
                                phi_4357_ = _e2375;
                            } else {
                                phi_4357_ = _e2378;
                            }
                            let _e2381 = phi_4357_;
                            if (_e2336 > _e2341) {
                                phi_4362_ = _e2336;
                            } else {
                                phi_4362_ = _e2341;
                            }
                            let _e2384 = phi_4362_;
                            if (_e2346 > _e2351) {
                                phi_4367_ = _e2346;
                            } else {
                                phi_4367_ = _e2351;
                            }
                            let _e2387 = phi_4367_;
                            if (_e2384 > _e2387) {
                                phi_4372_ = _e2384;
                            } else {
                                phi_4372_ = _e2387;
                            }
                            let _e2390 = phi_4372_;
                            if (_e2381 > _e2390) {
                                phi_4377_ = _e2381;
                            } else {
                                phi_4377_ = _e2390;
                            }
                            let _e2393 = phi_4377_;
                            if (_e2305 < 0f) {
                                phi_4383_ = -(_e2305);
                            } else {
                                phi_4383_ = _e2305;
                            }
                            let _e2397 = phi_4383_;
                            if (_e2308 < 0f) {
                                phi_4389_ = -(_e2308);
                            } else {
                                phi_4389_ = _e2308;
                            }
                            let _e2401 = phi_4389_;
                            if (_e2311 < 0f) {
                                phi_4396_ = -(_e2311);
                            } else {
                                phi_4396_ = _e2311;
                            }
                            let _e2406 = phi_4396_;
                            let _e2407 = ((_e2397 + _e2401) + _e2406);
                            let _e2412 = -(_e2393);
                            if (_e2372 > _e2412) {
                                phi_4407_ = _e2372;
                            } else {
                                phi_4407_ = _e2412;
                            }
                            let _e2415 = phi_4407_;
                            let _e2420 = (((_e2415 - ((_e2407 * _e2295) * (0.000000059604645f * (17f / 2f)))) - (_e2407 * _e2302)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2423 = ((_e2073 * _e2067) - (_e2076 * _e2066));
                            let _e2426 = ((_e2076 * _e2065) - (_e2070 * _e2067));
                            let _e2429 = ((_e2070 * _e2066) - (_e2073 * _e2065));
                            let _e2434 = (((_e2423 * _e2079[0]) + (_e2426 * _e2079[1])) + (_e2429 * _e2079[2]));
                            let _e2439 = (((_e2423 * _e2095) + (_e2426 * _e2096)) + (_e2429 * _e2097));
                            let _e2444 = (((_e2423 * _e2101) + (_e2426 * _e2102)) + (_e2429 * _e2103));
                            let _e2449 = (((_e2423 * _e2098) + (_e2426 * _e2099)) + (_e2429 * _e2100));
                            let _e2454 = (((_e2423 * _e2106[0]) + (_e2426 * _e2106[1])) + (_e2429 * _e2106[2]));
                            let _e2459 = (((_e2423 * _e2122) + (_e2426 * _e2123)) + (_e2429 * _e2124));
                            let _e2464 = (((_e2423 * _e2128) + (_e2426 * _e2129)) + (_e2429 * _e2130));
                            let _e2469 = (((_e2423 * _e2125) + (_e2426 * _e2126)) + (_e2429 * _e2127));
                            if (_e2434 < _e2439) {
                                phi_4478_ = _e2434;
                            } else {
                                phi_4478_ = _e2439;
                            }
                            let _e2472 = phi_4478_;
                            if (_e2444 < _e2449) {
                                phi_4483_ = _e2444;
                            } else {
                                phi_4483_ = _e2449;
                            }
                            let _e2475 = phi_4483_;
                            if (_e2472 < _e2475) {
                                phi_4488_ = _e2472;
                            } else {
                                phi_4488_ = _e2475;
                            }
                            let _e2478 = phi_4488_;
                            if (_e2454 < _e2459) {
                                phi_4493_ = _e2454;
                            } else {
                                phi_4493_ = _e2459;
                            }
                            let _e2481 = phi_4493_;
                            if (_e2464 < _e2469) {
                                phi_4498_ = _e2464;
                            } else {
                                phi_4498_ = _e2469;
                            }
                            let _e2484 = phi_4498_;
                            if (_e2481 < _e2484) {
                                phi_4503_ = _e2481;
                            } else {
                                phi_4503_ = _e2484;
                            }
                            let _e2487 = phi_4503_;
                            if (_e2478 < _e2487) {
                                phi_4508_ = _e2478;
                            } else {
                                phi_4508_ = _e2487;
                            }
                            let _e2490 = phi_4508_;
                            if (_e2434 > _e2439) {
                                phi_4513_ = _e2434;
                            } else {
                                phi_4513_ = _e2439;
                            }
                            let _e2493 = phi_4513_;
                            if (_e2444 > _e2449) {
                                phi_4518_ = _e2444;
                            } else {
                                phi_4518_ = _e2449;
                            }
                            let _e2496 = phi_4518_;
                            if (_e2493 > _e2496) {
                                phi_4523_ = _e2493;
                            } else {
                                phi_4523_ = _e2496;
                            }
                            let _e2499 = phi_4523_;
                            if (_e2454 > _e2459) {
                                phi_4528_ = _e2454;
                            } else {
                                phi_4528_ = _e2459;
                            }
                            let _e2502 = phi_4528_;
                            if (_e2464 > _e2469) {
                                phi_4533_ = _e2464;
                            } else {
                                phi_4533_ = _e2469;
                            }
                            let _e2505 = phi_4533_;
                            if (_e2502 > _e2505) {
                                phi_4538_ = _e2502;
                            } else {
                                phi_4538_ = _e2505;
                            }
                            let _e2508 = phi_4538_;
                            if (_e2499 > _e2508) {
                                phi_4543_ = _e2499;
                            } else {
                                phi_4543_ = _e2508;
                            }
                            let _e2511 = phi_4543_;
                            if (_e2423 < 0f) {
                                phi_4549_ = -(_e2423);
                            } else {
                                phi_4549_ = _e2423;
                            }
                            let _e2515 = phi_4549_;
                            if (_e2426 < 0f) {
                                phi_4555_ = -(_e2426);
                            } else {
                                phi_4555_ = _e2426;
                            }
                            let _e2519 = phi_4555_;
                            if (_e2429 < 0f) {
                                phi_4562_ = -(_e2429);
                            } else {
                                phi_4562_ = _e2429;
                            }
                            let _e2524 = phi_4562_;
                            let _e2525 = ((_e2515 + _e2519) + _e2524);
                            let _e2530 = -(_e2511);
                            if (_e2490 > _e2530) {
                                phi_4573_ = _e2490;
                            } else {
                                phi_4573_ = _e2530;
                            }
                            let _e2533 = phi_4573_;
                            let _e2538 = (((_e2533 - ((_e2525 * _e2295) * (0.000000059604645f * (17f / 2f)))) - (_e2525 * _e2302)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            if (_e2420 > _e2538) {
                                phi_4583_ = _e2420;
                            } else {
                                phi_4583_ = _e2538;
                            }
                            let _e2541 = phi_4583_;
                            phi_4765_ = (_e2037 || (_e2541 > 0f));
                        }
                        let _e2545 = phi_4765_;
                        if _e2545 {
                            let _e2548 = local_1.member_1[0u];
                            let _e2554 = local_1.member_2[0u];
                            let _e2560 = ((_e2548[1] * _e2554[2]) - (_e2548[2] * _e2554[1]));
                            let _e2563 = ((_e2548[2] * _e2554[0]) - (_e2548[0] * _e2554[2]));
                            let _e2566 = ((_e2548[0] * _e2554[1]) - (_e2548[1] * _e2554[0]));
                            let _e2569 = local_1.member_1[1u];
                            let _e2575 = local_1.member_2[1u];
                            let _e2581 = ((_e2569[1] * _e2575[2]) - (_e2569[2] * _e2575[1]));
                            let _e2584 = ((_e2569[2] * _e2575[0]) - (_e2569[0] * _e2575[2]));
                            let _e2587 = ((_e2569[0] * _e2575[1]) - (_e2569[1] * _e2575[0]));
                            let _e2590 = local_1.member_1[0u];
                            let _e2596 = local_1.member_2[1u];
                            let _e2611 = local_1.member_1[1u];
                            let _e2617 = local_1.member_2[0u];
                            let _e2630 = (((_e2590[1] * _e2596[2]) - (_e2590[2] * _e2596[1])) + ((_e2611[1] * _e2617[2]) - (_e2611[2] * _e2617[1])));
                            let _e2631 = (((_e2590[2] * _e2596[0]) - (_e2590[0] * _e2596[2])) + ((_e2611[2] * _e2617[0]) - (_e2611[0] * _e2617[2])));
                            let _e2632 = (((_e2590[0] * _e2596[1]) - (_e2590[1] * _e2596[0])) + ((_e2611[0] * _e2617[1]) - (_e2611[1] * _e2617[0])));
                            let _e2635 = local_1.member[0u];
                            let _e2646 = local_1.member[1u];
                            let _e2657 = local_1.member[0u];
                            let _e2666 = ((((_e2646[0] * _e2560) + (_e2646[1] * _e2563)) + (_e2646[2] * _e2566)) + (((_e2657[0] * _e2630) + (_e2657[1] * _e2631)) + (_e2657[2] * _e2632)));
                            let _e2669 = local_1.member[0u];
                            let _e2680 = local_1.member[1u];
                            let _e2689 = ((((_e2669[0] * _e2581) + (_e2669[1] * _e2584)) + (_e2669[2] * _e2587)) + (((_e2680[0] * _e2630) + (_e2680[1] * _e2631)) + (_e2680[2] * _e2632)));
                            let _e2692 = local_1.member[1u];
                            let _e2703 = local_1.member[0u];
                            if (_e2703[0] < 0f) {
                                phi_5010_ = -(_e2703[0]);
                            } else {
                                phi_5010_ = _e2703[0];
                            }
                            let _e2710 = phi_5010_;
                            if (_e2703[1] < 0f) {
                                phi_5017_ = -(_e2703[1]);
                            } else {
                                phi_5017_ = _e2703[1];
                            }
                            let _e2714 = phi_5017_;
                            if (_e2710 > _e2714) {
                                phi_5022_ = _e2710;
                            } else {
                                phi_5022_ = _e2714;
                            }
                            let _e2717 = phi_5022_;
                            if (_e2703[2] < 0f) {
                                phi_5029_ = -(_e2703[2]);
                            } else {
                                phi_5029_ = _e2703[2];
                            }
                            let _e2721 = phi_5029_;
                            if (_e2717 > _e2721) {
                                phi_5034_ = _e2717;
                            } else {
                                phi_5034_ = _e2721;
                            }
                            let _e2724 = phi_5034_;
                            let _e2727 = local_1.member[1u];
                            if (_e2727[0] < 0f) {
                                phi_5047_ = -(_e2727[0]);
                            } else {
                                phi_5047_ = _e2727[0];
                            }
                            let _e2734 = phi_5047_;
                            if (_e2727[1] < 0f) {
                                phi_5054_ = -(_e2727[1]);
                            } else {
                                phi_5054_ = _e2727[1];
                            }
                            let _e2738 = phi_5054_;
                            if (_e2734 > _e2738) {
                                phi_5059_ = _e2734;
                            } else {
                                phi_5059_ = _e2738;
                            }
                            let _e2741 = phi_5059_;
                            if (_e2727[2] < 0f) {
                                phi_5066_ = -(_e2727[2]);
                            } else {
                                phi_5066_ = _e2727[2];
                            }
                            let _e2745 = phi_5066_;
                            if (_e2741 > _e2745) {
                                phi_5071_ = _e2741;
                            } else {
                                phi_5071_ = _e2745;
                            }
                            let _e2748 = phi_5071_;
                            if (_e2724 > _e2748) {
                                phi_5076_ = _e2724;
                            } else {
                                phi_5076_ = _e2748;
                            }
                            let _e2751 = phi_5076_;
                            let _e2753 = local_1.member_3;
                            let _e2754 = (_e2751 + _e2753);
                            let _e2757 = local_1.member_1[0u];
                            if (_e2757[0] < 0f) {
                                phi_5093_ = -(_e2757[0]);
                            } else {
                                phi_5093_ = _e2757[0];
                            }
                            let _e2764 = phi_5093_;
                            if (_e2757[1] < 0f) {
                                phi_5100_ = -(_e2757[1]);
                            } else {
                                phi_5100_ = _e2757[1];
                            }
                            let _e2768 = phi_5100_;
                            if (_e2764 > _e2768) {
                                phi_5105_ = _e2764;
                            } else {
                                phi_5105_ = _e2768;
                            }
                            let _e2771 = phi_5105_;
                            if (_e2757[2] < 0f) {
                                phi_5112_ = -(_e2757[2]);
                            } else {
                                phi_5112_ = _e2757[2];
                            }
                            let _e2775 = phi_5112_;
                            if (_e2771 > _e2775) {
                                phi_5117_ = _e2771;
                            } else {
                                phi_5117_ = _e2775;
                            }
                            let _e2778 = phi_5117_;
                            let _e2781 = local_1.member_1[1u];
                            if (_e2781[0] < 0f) {
                                phi_5131_ = -(_e2781[0]);
                            } else {
                                phi_5131_ = _e2781[0];
                            }
                            let _e2788 = phi_5131_;
                            if (_e2781[1] < 0f) {
                                phi_5138_ = -(_e2781[1]);
                            } else {
                                phi_5138_ = _e2781[1];
                            }
                            let _e2792 = phi_5138_;
                            if (_e2788 > _e2792) {
                                phi_5143_ = _e2788;
                            } else {
                                phi_5143_ = _e2792;
                            }
                            let _e2795 = phi_5143_;
                            if (_e2781[2] < 0f) {
                                phi_5150_ = -(_e2781[2]);
                            } else {
                                phi_5150_ = _e2781[2];
                            }
                            let _e2799 = phi_5150_;
                            if (_e2795 > _e2799) {
                                phi_5155_ = _e2795;
                            } else {
                                phi_5155_ = _e2799;
                            }
                            let _e2802 = phi_5155_;
                            if (_e2778 > _e2802) {
                                phi_5160_ = _e2778;
                            } else {
                                phi_5160_ = _e2802;
                            }
                            let _e2805 = phi_5160_;
                            let _e2807 = local_1.member_3;
                            let _e2808 = (_e2805 + _e2807);
                            let _e2811 = local_1.member_2[0u];
                            if (_e2811[0] < 0f) {
                                phi_5177_ = -(_e2811[0]);
                            } else {
                                phi_5177_ = _e2811[0];
                            }
                            let _e2818 = phi_5177_;
                            if (_e2811[1] < 0f) {
                                phi_5184_ = -(_e2811[1]);
                            } else {
                                phi_5184_ = _e2811[1];
                            }
                            let _e2822 = phi_5184_;
                            if (_e2818 > _e2822) {
                                phi_5189_ = _e2818;
                            } else {
                                phi_5189_ = _e2822;
                            }
                            let _e2825 = phi_5189_;
                            if (_e2811[2] < 0f) {
                                phi_5196_ = -(_e2811[2]);
                            } else {
                                phi_5196_ = _e2811[2];
                            }
                            let _e2829 = phi_5196_;
                            if (_e2825 > _e2829) {
                                phi_5201_ = _e2825;
                            } else {
                                phi_5201_ = _e2829;
                            }
                            let _e2832 = phi_5201_;
                            let _e2835 = local_1.member_2[1u];
                            if (_e2835[0] < 0f) {
                                phi_5215_ = -(_e2835[0]);
                            } else {
                                phi_5215_ = _e2835[0];
                            }
                            let _e2842 = phi_5215_;
                            if (_e2835[1] < 0f) {
                                phi_5222_ = -(_e2835[1]);
                            } else {
                                phi_5222_ = _e2835[1];
                            }
                            let _e2846 = phi_5222_;
                            if (_e2842 > _e2846) {
                                phi_5227_ = _e2842;
                            } else {
                                phi_5227_ = _e2846;
                            }
                            let _e2849 = phi_5227_;
                            if (_e2835[2] < 0f) {
                                phi_5234_ = -(_e2835[2]);
                            } else {
                                phi_5234_ = _e2835[2];
                            }
                            let _e2853 = phi_5234_;
                            if (_e2849 > _e2853) {
                                phi_5239_ = _e2849;
                            } else {
                                phi_5239_ = _e2853;
                            }
                            let _e2856 = phi_5239_;
                            if (_e2832 > _e2856) {
                                phi_5244_ = _e2832;
                            } else {
                                phi_5244_ = _e2856;
                            }
                            let _e2859 = phi_5244_;
                            let _e2861 = local_1.member_3;
                            let _e2862 = (_e2859 + _e2861);
                            let _e2864 = ((_e2808 * 8f) * _e2862);
                            let _e2871 = local_1.member_3;
                            if (_e2560 < 0f) {
                                phi_5275_ = -(_e2560);
                            } else {
                                phi_5275_ = _e2560;
                            }
                            let _e2888 = phi_5275_;
                            if (_e2563 < 0f) {
                                phi_5281_ = -(_e2563);
                            } else {
                                phi_5281_ = _e2563;
                            }
                            let _e2892 = phi_5281_;
                            if (_e2566 < 0f) {
                                phi_5288_ = -(_e2566);
                            } else {
                                phi_5288_ = _e2566;
                            }
                            let _e2897 = phi_5288_;
                            let _e2898 = ((_e2888 + _e2892) + _e2897);
                            if (_e2581 < 0f) {
                                phi_5295_ = -(_e2581);
                            } else {
                                phi_5295_ = _e2581;
                            }
                            let _e2902 = phi_5295_;
                            if (_e2584 < 0f) {
                                phi_5301_ = -(_e2584);
                            } else {
                                phi_5301_ = _e2584;
                            }
                            let _e2906 = phi_5301_;
                            if (_e2587 < 0f) {
                                phi_5308_ = -(_e2587);
                            } else {
                                phi_5308_ = _e2587;
                            }
                            let _e2911 = phi_5308_;
                            let _e2912 = ((_e2902 + _e2906) + _e2911);
                            if (_e2898 > _e2912) {
                                phi_5314_ = _e2898;
                            } else {
                                phi_5314_ = _e2912;
                            }
                            let _e2915 = phi_5314_;
                            if (_e2630 < 0f) {
                                phi_5320_ = -(_e2630);
                            } else {
                                phi_5320_ = _e2630;
                            }
                            let _e2919 = phi_5320_;
                            if (_e2631 < 0f) {
                                phi_5326_ = -(_e2631);
                            } else {
                                phi_5326_ = _e2631;
                            }
                            let _e2923 = phi_5326_;
                            if (_e2632 < 0f) {
                                phi_5333_ = -(_e2632);
                            } else {
                                phi_5333_ = _e2632;
                            }
                            let _e2928 = phi_5333_;
                            let _e2930 = (((_e2919 + _e2923) + _e2928) * 0.5f);
                            if (_e2915 > _e2930) {
                                phi_5340_ = _e2915;
                            } else {
                                phi_5340_ = _e2930;
                            }
                            let _e2933 = phi_5340_;
                            let _e2938 = local_1.member_3;
                            let _e2951 = ((((_e2635[0] * _e2560) + (_e2635[1] * _e2563)) + (_e2635[2] * _e2566)) * 3f);
                            let _e2952 = ((((_e2692[0] * _e2581) + (_e2692[1] * _e2584)) + (_e2692[2] * _e2587)) * 3f);
                            if (_e2951 < _e2952) {
                                phi_5364_ = _e2951;
                            } else {
                                phi_5364_ = _e2952;
                            }
                            let _e2955 = phi_5364_;
                            if (_e2666 < _e2689) {
                                phi_5369_ = _e2666;
                            } else {
                                phi_5369_ = _e2689;
                            }
                            let _e2958 = phi_5369_;
                            if (_e2955 < _e2958) {
                                phi_5374_ = _e2955;
                            } else {
                                phi_5374_ = _e2958;
                            }
                            let _e2961 = phi_5374_;
                            if (_e2951 > _e2952) {
                                phi_5379_ = _e2951;
                            } else {
                                phi_5379_ = _e2952;
                            }
                            let _e2964 = phi_5379_;
                            if (_e2666 > _e2689) {
                                phi_5384_ = _e2666;
                            } else {
                                phi_5384_ = _e2689;
                            }
                            let _e2967 = phi_5384_;
                            if (_e2964 > _e2967) {
                                phi_5389_ = _e2964;
                            } else {
                                phi_5389_ = _e2967;
                            }
                            let _e2970 = phi_5389_;
                            let _e2975 = -(_e2970);
                            if (_e2961 > _e2975) {
                                phi_5399_ = _e2961;
                            } else {
                                phi_5399_ = _e2975;
                            }
                            let _e2978 = phi_5399_;
                            let _e2980 = ((_e2978 - ((((((_e2754 * 8f) * _e2864) * (0.000000059604645f * (524f / 64f))) + ((_e2871 * 19f) * ((_e2754 * (_e2808 + _e2862)) + (_e2808 * _e2862)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2754) * ((1f + _e2808) * (1f + _e2862))))) + ((_e500 * (((_e2933 + (_e2864 * (0.000000059604645f * 8f))) + ((_e2938 * 6f) * (_e2808 + _e2862))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2808) * (1f + _e2862))))) * (3f * 1.0001f)))) > 0f);
                            if _e2980 {
                                phi_6368_ = _e2980;
                            } else {
                                let _e2983 = local_1.member_1[0u];
                                let _e2989 = local_1.member_1[1u];
                                let _e2993 = (_e2983[0] + _e2989[0]);
                                let _e2994 = (_e2983[1] + _e2989[1]);
                                let _e2995 = (_e2983[2] + _e2989[2]);
                                let _e2998 = local_1.member_2[0u];
                                let _e3004 = local_1.member_2[1u];
                                let _e3008 = (_e2998[0] + _e3004[0]);
                                let _e3009 = (_e2998[1] + _e3004[1]);
                                let _e3010 = (_e2998[2] + _e3004[2]);
                                let _e3013 = ((_e2994 * _e3010) - (_e2995 * _e3009));
                                let _e3016 = ((_e2995 * _e3008) - (_e2993 * _e3010));
                                let _e3019 = ((_e2993 * _e3009) - (_e2994 * _e3008));
                                let _e3022 = local_1.member[0u];
                                let _e3028 = local_1.member_1[0u];
                                let _e3034 = local_1.member_2[0u];
                                let _e3038 = (_e3022[0] - _e3028[0]);
                                let _e3039 = (_e3022[1] - _e3028[1]);
                                let _e3040 = (_e3022[2] - _e3028[2]);
                                let _e3041 = (_e3038 - _e3034[0]);
                                let _e3042 = (_e3039 - _e3034[1]);
                                let _e3043 = (_e3040 - _e3034[2]);
                                let _e3044 = (_e3022[0] - _e3034[0]);
                                let _e3045 = (_e3022[1] - _e3034[1]);
                                let _e3046 = (_e3022[2] - _e3034[2]);
                                let _e3049 = local_1.member[1u];
                                let _e3055 = local_1.member_1[1u];
                                let _e3061 = local_1.member_2[1u];
                                let _e3065 = (_e3049[0] - _e3055[0]);
                                let _e3066 = (_e3049[1] - _e3055[1]);
                                let _e3067 = (_e3049[2] - _e3055[2]);
                                let _e3068 = (_e3065 - _e3061[0]);
                                let _e3069 = (_e3066 - _e3061[1]);
                                let _e3070 = (_e3067 - _e3061[2]);
                                let _e3071 = (_e3049[0] - _e3061[0]);
                                let _e3072 = (_e3049[1] - _e3061[1]);
                                let _e3073 = (_e3049[2] - _e3061[2]);
                                let _e3076 = local_1.member[0u];
                                if (_e3076[0] < 0f) {
                                    phi_5602_ = -(_e3076[0]);
                                } else {
                                    phi_5602_ = _e3076[0];
                                }
                                let _e3083 = phi_5602_;
                                if (_e3076[1] < 0f) {
                                    phi_5609_ = -(_e3076[1]);
                                } else {
                                    phi_5609_ = _e3076[1];
                                }
                                let _e3087 = phi_5609_;
                                if (_e3083 > _e3087) {
                                    phi_5614_ = _e3083;
                                } else {
                                    phi_5614_ = _e3087;
                                }
                                let _e3090 = phi_5614_;
                                if (_e3076[2] < 0f) {
                                    phi_5621_ = -(_e3076[2]);
                                } else {
                                    phi_5621_ = _e3076[2];
                                }
                                let _e3094 = phi_5621_;
                                if (_e3090 > _e3094) {
                                    phi_5626_ = _e3090;
                                } else {
                                    phi_5626_ = _e3094;
                                }
                                let _e3097 = phi_5626_;
                                let _e3100 = local_1.member[1u];
                                if (_e3100[0] < 0f) {
                                    phi_5639_ = -(_e3100[0]);
                                } else {
                                    phi_5639_ = _e3100[0];
                                }
                                let _e3107 = phi_5639_;
                                if (_e3100[1] < 0f) {
                                    phi_5646_ = -(_e3100[1]);
                                } else {
                                    phi_5646_ = _e3100[1];
                                }
                                let _e3111 = phi_5646_;
                                if (_e3107 > _e3111) {
                                    phi_5651_ = _e3107;
                                } else {
                                    phi_5651_ = _e3111;
                                }
                                let _e3114 = phi_5651_;
                                if (_e3100[2] < 0f) {
                                    phi_5658_ = -(_e3100[2]);
                                } else {
                                    phi_5658_ = _e3100[2];
                                }
                                let _e3118 = phi_5658_;
                                if (_e3114 > _e3118) {
                                    phi_5663_ = _e3114;
                                } else {
                                    phi_5663_ = _e3118;
                                }
                                let _e3121 = phi_5663_;
                                if (_e3097 > _e3121) {
                                    phi_5668_ = _e3097;
                                } else {
                                    phi_5668_ = _e3121;
                                }
                                let _e3124 = phi_5668_;
                                let _e3126 = local_1.member_3;
                                let _e3130 = local_1.member_1[0u];
                                if (_e3130[0] < 0f) {
                                    phi_5685_ = -(_e3130[0]);
                                } else {
                                    phi_5685_ = _e3130[0];
                                }
                                let _e3137 = phi_5685_;
                                if (_e3130[1] < 0f) {
                                    phi_5692_ = -(_e3130[1]);
                                } else {
                                    phi_5692_ = _e3130[1];
                                }
                                let _e3141 = phi_5692_;
                                if (_e3137 > _e3141) {
                                    phi_5697_ = _e3137;
                                } else {
                                    phi_5697_ = _e3141;
                                }
                                let _e3144 = phi_5697_;
                                if (_e3130[2] < 0f) {
                                    phi_5704_ = -(_e3130[2]);
                                } else {
                                    phi_5704_ = _e3130[2];
                                }
                                let _e3148 = phi_5704_;
                                if (_e3144 > _e3148) {
                                    phi_5709_ = _e3144;
                                } else {
                                    phi_5709_ = _e3148;
                                }
                                let _e3151 = phi_5709_;
                                let _e3154 = local_1.member_1[1u];
                                if (_e3154[0] < 0f) {
                                    phi_5723_ = -(_e3154[0]);
                                } else {
                                    phi_5723_ = _e3154[0];
                                }
                                let _e3161 = phi_5723_;
                                if (_e3154[1] < 0f) {
                                    phi_5730_ = -(_e3154[1]);
                                } else {
                                    phi_5730_ = _e3154[1];
                                }
                                let _e3165 = phi_5730_;
                                if (_e3161 > _e3165) {
                                    phi_5735_ = _e3161;
                                } else {
                                    phi_5735_ = _e3165;
                                }
                                let _e3168 = phi_5735_;
                                if (_e3154[2] < 0f) {
                                    phi_5742_ = -(_e3154[2]);
                                } else {
                                    phi_5742_ = _e3154[2];
                                }
                                let _e3172 = phi_5742_;
                                if (_e3168 > _e3172) {
                                    phi_5747_ = _e3168;
                                } else {
                                    phi_5747_ = _e3172;
                                }
                                let _e3175 = phi_5747_;
                                if (_e3151 > _e3175) {
                                    phi_5752_ = _e3151;
                                } else {
                                    phi_5752_ = _e3175;
                                }
                                let _e3178 = phi_5752_;
                                let _e3180 = local_1.member_3;
                                let _e3184 = local_1.member_2[0u];
                                if (_e3184[0] < 0f) {
                                    phi_5769_ = -(_e3184[0]);
                                } else {
                                    phi_5769_ = _e3184[0];
                                }
                                let _e3191 = phi_5769_;
                                if (_e3184[1] < 0f) {
                                    phi_5776_ = -(_e3184[1]);
                                } else {
                                    phi_5776_ = _e3184[1];
                                }
                                let _e3195 = phi_5776_;
                                if (_e3191 > _e3195) {
                                    phi_5781_ = _e3191;
                                } else {
                                    phi_5781_ = _e3195;
                                }
                                let _e3198 = phi_5781_;
                                if (_e3184[2] < 0f) {
                                    phi_5788_ = -(_e3184[2]);
                                } else {
                                    phi_5788_ = _e3184[2];
                                }
                                let _e3202 = phi_5788_;
                                if (_e3198 > _e3202) {
                                    phi_5793_ = _e3198;
                                } else {
                                    phi_5793_ = _e3202;
                                }
                                let _e3205 = phi_5793_;
                                let _e3208 = local_1.member_2[1u];
                                if (_e3208[0] < 0f) {
                                    phi_5807_ = -(_e3208[0]);
                                } else {
                                    phi_5807_ = _e3208[0];
                                }
                                let _e3215 = phi_5807_;
                                if (_e3208[1] < 0f) {
                                    phi_5814_ = -(_e3208[1]);
                                } else {
                                    phi_5814_ = _e3208[1];
                                }
                                let _e3219 = phi_5814_;
                                if (_e3215 > _e3219) {
                                    phi_5819_ = _e3215;
                                } else {
                                    phi_5819_ = _e3219;
                                }
                                let _e3222 = phi_5819_;
                                if (_e3208[2] < 0f) {
                                    phi_5826_ = -(_e3208[2]);
                                } else {
                                    phi_5826_ = _e3208[2];
                                }
                                let _e3226 = phi_5826_;
                                if (_e3222 > _e3226) {
                                    phi_5831_ = _e3222;
                                } else {
                                    phi_5831_ = _e3226;
                                }
                                let _e3229 = phi_5831_;
                                if (_e3205 > _e3229) {
                                    phi_5836_ = _e3205;
                                } else {
                                    phi_5836_ = _e3229;
                                }
                                let _e3232 = phi_5836_;
                                let _e3234 = local_1.member_3;
                                let _e3238 = ((((_e3124 + _e3126) + (_e3178 + _e3180)) + (_e3232 + _e3234)) * 2f);
                                let _e3241 = local_1.member_3;
                                let _e3245 = (((_e500 * 1.0001f) + (_e3241 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e3248 = ((_e3016 * _e2995) - (_e3019 * _e2994));
                                let _e3251 = ((_e3019 * _e2993) - (_e3013 * _e2995));
                                let _e3254 = ((_e3013 * _e2994) - (_e3016 * _e2993));
                                let _e3259 = (((_e3248 * _e3022[0]) + (_e3251 * _e3022[1])) + (_e3254 * _e3022[2]));
                                let _e3264 = (((_e3248 * _e3038) + (_e3251 * _e3039)) + (_e3254 * _e3040));
                                let _e3269 = (((_e3248 * _e3044) + (_e3251 * _e3045)) + (_e3254 * _e3046));
                                let _e3274 = (((_e3248 * _e3041) + (_e3251 * _e3042)) + (_e3254 * _e3043));
                                let _e3279 = (((_e3248 * _e3049[0]) + (_e3251 * _e3049[1])) + (_e3254 * _e3049[2]));
                                let _e3284 = (((_e3248 * _e3065) + (_e3251 * _e3066)) + (_e3254 * _e3067));
                                let _e3289 = (((_e3248 * _e3071) + (_e3251 * _e3072)) + (_e3254 * _e3073));
                                let _e3294 = (((_e3248 * _e3068) + (_e3251 * _e3069)) + (_e3254 * _e3070));
                                if (_e3259 < _e3264) {
                                    phi_5915_ = _e3259;
                                } else {
                                    phi_5915_ = _e3264;
                                }
                                let _e3297 = phi_5915_;
                                if (_e3269 < _e3274) {
                                    phi_5920_ = _e3269;
                                } else {
                                    phi_5920_ = _e3274;
                                }
                                let _e3300 = phi_5920_;
                                if (_e3297 < _e3300) {
                                    phi_5925_ = _e3297;
                                } else {
                                    phi_5925_ = _e3300;
                                }
                                let _e3303 = phi_5925_;
                                if (_e3279 < _e3284) {
                                    phi_5930_ = _e3279;
                                } else {
                                    phi_5930_ = _e3284;
                                }
                                let _e3306 = phi_5930_;
                                if (_e3289 < _e3294) {
                                    phi_5935_ = _e3289;
                                } else {
                                    phi_5935_ = _e3294;
                                }
                                let _e3309 = phi_5935_;
                                if (_e3306 < _e3309) {
                                    phi_5940_ = _e3306;
                                } else {
                                    phi_5940_ = _e3309;
                                }
                                let _e3312 = phi_5940_;
                                if (_e3303 < _e3312) {
                                    phi_5945_ = _e3303;
                                } else {
                                    phi_5945_ = _e3312;
                                }
                                let _e3315 = phi_5945_;
                                if (_e3259 > _e3264) {
                                    phi_5950_ = _e3259;
                                } else {
                                    phi_5950_ = _e3264;
                                }
                                let _e3318 = phi_5950_;
                                if (_e3269 > _e3274) {
                                    phi_5955_ = _e3269;
                                } else {
                                    phi_5955_ = _e3274;
                                }
                                let _e3321 = phi_5955_;
                                if (_e3318 > _e3321) {
                                    phi_5960_ = _e3318;
                                } else {
                                    phi_5960_ = _e3321;
                                }
                                let _e3324 = phi_5960_;
                                if (_e3279 > _e3284) {
                                    phi_5965_ = _e3279;
                                } else {
                                    phi_5965_ = _e3284;
                                }
                                let _e3327 = phi_5965_;
                                if (_e3289 > _e3294) {
                                    phi_5970_ = _e3289;
                                } else {
                                    phi_5970_ = _e3294;
                                }
                                let _e3330 = phi_5970_;
                                if (_e3327 > _e3330) {
                                    phi_5975_ = _e3327;
                                } else {
                                    phi_5975_ = _e3330;
                                }
                                let _e3333 = phi_5975_;
                                if (_e3324 > _e3333) {
                                    phi_5980_ = _e3324;
                                } else {
                                    phi_5980_ = _e3333;
                                }
                                let _e3336 = phi_5980_;
                                if (_e3248 < 0f) {
                                    phi_5986_ = -(_e3248);
                                } else {
                                    phi_5986_ = _e3248;
                                }
                                let _e3340 = phi_5986_;
                                if (_e3251 < 0f) {
                                    phi_5992_ = -(_e3251);
                                } else {
                                    phi_5992_ = _e3251;
                                }
                                let _e3344 = phi_5992_;
                                if (_e3254 < 0f) {
                                    phi_5999_ = -(_e3254);
                                } else {
                                    phi_5999_ = _e3254;
                                }
                                let _e3349 = phi_5999_;
                                let _e3350 = ((_e3340 + _e3344) + _e3349);
                                let _e3355 = -(_e3336);
                                if (_e3315 > _e3355) {
                                    phi_6010_ = _e3315;
                                } else {
                                    phi_6010_ = _e3355;
                                }
                                let _e3358 = phi_6010_;
                                let _e3363 = (((_e3358 - ((_e3350 * _e3238) * (0.000000059604645f * (17f / 2f)))) - (_e3350 * _e3245)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e3366 = ((_e3016 * _e3010) - (_e3019 * _e3009));
                                let _e3369 = ((_e3019 * _e3008) - (_e3013 * _e3010));
                                let _e3372 = ((_e3013 * _e3009) - (_e3016 * _e3008));
                                let _e3377 = (((_e3366 * _e3022[0]) + (_e3369 * _e3022[1])) + (_e3372 * _e3022[2]));
                                let _e3382 = (((_e3366 * _e3038) + (_e3369 * _e3039)) + (_e3372 * _e3040));
                                let _e3387 = (((_e3366 * _e3044) + (_e3369 * _e3045)) + (_e3372 * _e3046));
                                let _e3392 = (((_e3366 * _e3041) + (_e3369 * _e3042)) + (_e3372 * _e3043));
                                let _e3397 = (((_e3366 * _e3049[0]) + (_e3369 * _e3049[1])) + (_e3372 * _e3049[2]));
                                let _e3402 = (((_e3366 * _e3065) + (_e3369 * _e3066)) + (_e3372 * _e3067));
                                let _e3407 = (((_e3366 * _e3071) + (_e3369 * _e3072)) + (_e3372 * _e3073));
                                let _e3412 = (((_e3366 * _e3068) + (_e3369 * _e3069)) + (_e3372 * _e3070));
                                if (_e3377 < _e3382) {
                                    phi_6081_ = _e3377;
                                } else {
                                    phi_6081_ = _e3382;
                                }
                                let _e3415 = phi_6081_;
                                if (_e3387 < _e3392) {
                                    phi_6086_ = _e3387;
                                } else {
                                    phi_6086_ = _e3392;
                                }
                                let _e3418 = phi_6086_;
                                if (_e3415 < _e3418) {
                                    phi_6091_ = _e3415;
                                } else {
                                    phi_6091_ = _e3418;
                                }
                                let _e3421 = phi_6091_;
                                if (_e3397 < _e3402) {
                                    phi_6096_ = _e3397;
                                } else {
                                    phi_6096_ = _e3402;
                                }
                                let _e3424 = phi_6096_;
                                if (_e3407 < _e3412) {
                                    phi_6101_ = _e3407;
                                } else {
                                    phi_6101_ = _e3412;
                                }
                                let _e3427 = phi_6101_;
                                if (_e3424 < _e3427) {
                                    phi_6106_ = _e3424;
                                } else {
                                    phi_6106_ = _e3427;
                                }
                                let _e3430 = phi_6106_;
                                if (_e3421 < _e3430) {
                                    phi_6111_ = _e3421;
                                } else {
                                    phi_6111_ = _e3430;
                                }
                                let _e3433 = phi_6111_;
                                if (_e3377 > _e3382) {
                                    phi_6116_ = _e3377;
                                } else {
                                    phi_6116_ = _e3382;
                                }
                                let _e3436 = phi_6116_;
                                if (_e3387 > _e3392) {
                                    phi_6121_ = _e3387;
                                } else {
                                    phi_6121_ = _e3392;
                                }
                                let _e3439 = phi_6121_;
                                if (_e3436 > _e3439) {
                                    phi_6126_ = _e3436;
                                } else {
                                    phi_6126_ = _e3439;
                                }
                                let _e3442 = phi_6126_;
                                if (_e3397 > _e3402) {
                                    phi_6131_ = _e3397;
                                } else {
                                    phi_6131_ = _e3402;
                                }
                                let _e3445 = phi_6131_;
                                if (_e3407 > _e3412) {
                                    phi_6136_ = _e3407;
                                } else {
                                    phi_6136_ = _e3412;
                                }
                                let _e3448 = phi_6136_;
                                if (_e3445 > _e3448) {
                                    phi_6141_ = _e3445;
                                } else {
                                    phi_6141_ = _e3448;
                                }
                                let _e3451 = phi_6141_;
                                if (_e3442 > _e3451) {
                                    phi_6146_ = _e3442;
                                } else {
                                    phi_6146_ = _e3451;
                                }
                                let _e3454 = phi_6146_;
                                if (_e3366 < 0f) {
                                    phi_6152_ = -(_e3366);
                                } else {
                                    phi_6152_ = _e3366;
                                }
                                let _e3458 = phi_6152_;
                                if (_e3369 < 0f) {
                                    phi_6158_ = -(_e3369);
                                } else {
                                    phi_6158_ = _e3369;
                                }
                                let _e3462 = phi_6158_;
                                if (_e3372 < 0f) {
                                    phi_6165_ = -(_e3372);
                                } else {
                                    phi_6165_ = _e3372;
                                }
                                let _e3467 = phi_6165_;
                                let _e3468 = ((_e3458 + _e3462) + _e3467);
                                let _e3473 = -(_e3454);
                                if (_e3433 > _e3473) {
                                    phi_6176_ = _e3433;
                                } else {
                                    phi_6176_ = _e3473;
                                }
                                let _e3476 = phi_6176_;
                                let _e3481 = (((_e3476 - ((_e3468 * _e3238) * (0.000000059604645f * (17f / 2f)))) - (_e3468 * _e3245)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3363 > _e3481) {
                                    phi_6186_ = _e3363;
                                } else {
                                    phi_6186_ = _e3481;
                                }
                                let _e3484 = phi_6186_;
                                phi_6368_ = (_e2980 || (_e3484 > 0f));
                            }
                            let _e3488 = phi_6368_;
                            phi_6370_ = (_e2545 && _e3488);
                        } else {
                            phi_6370_ = _e2545;
                        }
                        let _e3491 = phi_6370_;
                        phi_6372_ = (_e1512 || _e3491);
                    }
                    let _e3494 = phi_6372_;
                    let _e3495 = !(_e3494);
                    if _e3495 {
                        let _e3497 = atomicAdd((&counters[0u]), 1u);
                        phi_6379_ = _e3497;
                    } else {
                        phi_6379_ = 0u;
                    }
                    let _e3499 = phi_6379_;
                    phi_6380_ = _e3499;
                    phi_6381_ = _e3495;
                } else {
                    phi_6380_ = 0u;
                    phi_6381_ = false;
                }
                let _e3501 = phi_6380_;
                let _e3503 = phi_6381_;
                phi_6382_ = _e3501;
                phi_6383_ = _e3503;
                phi_6384_ = type_12(_e138, _e141);
            } else {
                phi_6382_ = 0u;
                phi_6383_ = false;
                phi_6384_ = type_12(0u, 0u);
            }
            let _e3505 = phi_6382_;
            let _e3507 = phi_6383_;
            let _e3509 = phi_6384_;
            workgroupBarrier();
            if (_e47 == 0u) {
                let _e3512 = atomicLoad((&counters[0u]));
                let _e3514 = atomicLoad((&counters[1u]));
                if (_e3512 > 0u) {
                    let _e3517 = atomicAdd((&output.member[0u]), _e3512);
                    if ((_e3517 + _e3512) < _e3517) {
                        let _e3521 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e3517);
                }
                if (_e3514 > 0u) {
                    let _e3525 = atomicAdd((&output.member[1u]), _e3514);
                    if ((_e3525 + _e3514) < _e3525) {
                        let _e3529 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e3507 {
                let _e3531 = params.member.member_1.member_3;
                let _e3533 = atomicLoad((&counters[2u]));
                let _e3534 = (_e3533 + _e3505);
                if (_e3534 < _e3531) {
                    let _e3538 = (2u * _e3534);
                    atomicStore((&output.member[(4u + _e3538)]), _e3509.member);
                    atomicStore((&output.member[(_e3538 + 5u)]), _e3509.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_367_ = _e117;
            break if !(_e123);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_listed_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
