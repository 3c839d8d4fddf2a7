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
    member_11: f32,
    member_12: f32,
    member_13: f32,
    member_14: array<u32, 2>,
    member_15: array<u32, 2>,
    member_16: array<u32, 2>,
}

struct type_8 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_9 {
    member: u32,
    member_1: u32,
}

struct type_10 {
    member: type_7,
    member_1: type_8,
    member_2: type_9,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<u32>,
}

struct type_18 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_19 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_24 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(3) 
var<storage> input: type_13;
@group(0) @binding(4) 
var<storage, read_write> output: type_28;
@group(0) @binding(2) 
var<storage> paths: type_21;
@group(0) @binding(1) 
var<storage> elements: type_13;
var<workgroup> counters: array<atomic<u32>, 3>;
var<workgroup> left: array<type_9, 512>;
var<workgroup> kept: array<type_9, 512>;

fn function_(param: f32, param_1: f32) -> f32 {
    var phi_110_: bool;
    var phi_114_: f32;

    if (param != param) {
        phi_110_ = true;
    } else {
        phi_110_ = (param_1 <= param);
    }
    let _e6 = phi_110_;
    if _e6 {
        phi_114_ = param_1;
    } else {
        phi_114_ = param;
    }
    let _e8 = phi_114_;
    return _e8;
}

fn function_1(param_2: f32, param_3: f32) -> f32 {
    var phi_126_: bool;
    var phi_130_: f32;

    if (param_2 != param_2) {
        phi_126_ = true;
    } else {
        phi_126_ = (param_3 >= param_2);
    }
    let _e6 = phi_126_;
    if _e6 {
        phi_130_ = param_3;
    } else {
        phi_130_ = param_2;
    }
    let _e8 = phi_130_;
    return _e8;
}

fn function_2(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_23;
    var local_1: type_23;
    var local_2: type_23;
    var phi_181_: u32;
    var phi_191_: u32;
    var phi_198_: u32;
    var phi_214_: u32;
    var phi_235_: u32;
    var phi_236_: u32;
    var phi_239_: type_9;
    var phi_240_: type_9;
    var phi_263_: type_9;
    var phi_281_: type_9;
    var phi_282_: type_9;
    var phi_305_: type_9;
    var phi_432_: type_18;
    var phi_554_: type_24;
    var phi_601_: type_24;
    var phi_674_: bool;
    var phi_808_: type_23;
    var phi_1088_: f32;
    var phi_1095_: f32;
    var phi_1100_: f32;
    var phi_1107_: f32;
    var phi_1112_: f32;
    var phi_1125_: f32;
    var phi_1132_: f32;
    var phi_1137_: f32;
    var phi_1144_: f32;
    var phi_1149_: f32;
    var phi_1154_: f32;
    var phi_1171_: f32;
    var phi_1178_: f32;
    var phi_1183_: f32;
    var phi_1190_: f32;
    var phi_1195_: f32;
    var phi_1209_: f32;
    var phi_1216_: f32;
    var phi_1221_: f32;
    var phi_1228_: f32;
    var phi_1233_: f32;
    var phi_1238_: f32;
    var phi_1255_: f32;
    var phi_1262_: f32;
    var phi_1267_: f32;
    var phi_1274_: f32;
    var phi_1279_: f32;
    var phi_1293_: f32;
    var phi_1300_: f32;
    var phi_1305_: f32;
    var phi_1312_: f32;
    var phi_1317_: f32;
    var phi_1322_: f32;
    var phi_1353_: f32;
    var phi_1359_: f32;
    var phi_1366_: f32;
    var phi_1373_: f32;
    var phi_1379_: f32;
    var phi_1386_: f32;
    var phi_1392_: f32;
    var phi_1398_: f32;
    var phi_1404_: f32;
    var phi_1411_: f32;
    var phi_1418_: f32;
    var phi_1442_: f32;
    var phi_1447_: f32;
    var phi_1452_: f32;
    var phi_1457_: f32;
    var phi_1462_: f32;
    var phi_1467_: f32;
    var phi_1477_: f32;
    var phi_1593_: array<f32, 3>;
    var phi_1658_: array<f32, 3>;
    var phi_1680_: f32;
    var phi_1687_: f32;
    var phi_1692_: f32;
    var phi_1699_: f32;
    var phi_1704_: f32;
    var phi_1717_: f32;
    var phi_1724_: f32;
    var phi_1729_: f32;
    var phi_1736_: f32;
    var phi_1741_: f32;
    var phi_1746_: f32;
    var phi_1763_: f32;
    var phi_1770_: f32;
    var phi_1775_: f32;
    var phi_1782_: f32;
    var phi_1787_: f32;
    var phi_1801_: f32;
    var phi_1808_: f32;
    var phi_1813_: f32;
    var phi_1820_: f32;
    var phi_1825_: f32;
    var phi_1830_: f32;
    var phi_1847_: f32;
    var phi_1854_: f32;
    var phi_1859_: f32;
    var phi_1866_: f32;
    var phi_1871_: f32;
    var phi_1885_: f32;
    var phi_1892_: f32;
    var phi_1897_: f32;
    var phi_1904_: f32;
    var phi_1909_: f32;
    var phi_1914_: f32;
    var phi_1993_: f32;
    var phi_1998_: f32;
    var phi_2003_: f32;
    var phi_2008_: f32;
    var phi_2013_: f32;
    var phi_2018_: f32;
    var phi_2023_: f32;
    var phi_2028_: f32;
    var phi_2033_: f32;
    var phi_2038_: f32;
    var phi_2043_: f32;
    var phi_2048_: f32;
    var phi_2053_: f32;
    var phi_2058_: f32;
    var phi_2064_: f32;
    var phi_2070_: f32;
    var phi_2077_: f32;
    var phi_2088_: f32;
    var phi_2159_: f32;
    var phi_2164_: f32;
    var phi_2169_: f32;
    var phi_2174_: f32;
    var phi_2179_: f32;
    var phi_2184_: f32;
    var phi_2189_: f32;
    var phi_2194_: f32;
    var phi_2199_: f32;
    var phi_2204_: f32;
    var phi_2209_: f32;
    var phi_2214_: f32;
    var phi_2219_: f32;
    var phi_2224_: f32;
    var phi_2230_: f32;
    var phi_2236_: f32;
    var phi_2243_: f32;
    var phi_2254_: f32;
    var phi_2264_: f32;
    var phi_2337_: f32;
    var phi_2342_: f32;
    var phi_2347_: f32;
    var phi_2352_: f32;
    var phi_2357_: f32;
    var phi_2362_: f32;
    var phi_2367_: f32;
    var phi_2372_: f32;
    var phi_2377_: f32;
    var phi_2382_: f32;
    var phi_2387_: f32;
    var phi_2392_: f32;
    var phi_2397_: f32;
    var phi_2402_: f32;
    var phi_2408_: f32;
    var phi_2414_: f32;
    var phi_2421_: f32;
    var phi_2432_: f32;
    var phi_2442_: f32;
    var phi_2443_: f32;
    var phi_2446_: bool;
    var phi_2455_: bool;
    var phi_2456_: bool;
    var phi_2461_: type_9;
    var phi_2462_: type_9;
    var phi_2485_: type_9;
    var phi_2589_: type_18;
    var phi_2722_: type_23;
    var phi_3101_: f32;
    var phi_3108_: f32;
    var phi_3113_: f32;
    var phi_3120_: f32;
    var phi_3125_: f32;
    var phi_3138_: f32;
    var phi_3145_: f32;
    var phi_3150_: f32;
    var phi_3157_: f32;
    var phi_3162_: f32;
    var phi_3167_: f32;
    var phi_3184_: f32;
    var phi_3191_: f32;
    var phi_3196_: f32;
    var phi_3203_: f32;
    var phi_3208_: f32;
    var phi_3222_: f32;
    var phi_3229_: f32;
    var phi_3234_: f32;
    var phi_3241_: f32;
    var phi_3246_: f32;
    var phi_3251_: f32;
    var phi_3268_: f32;
    var phi_3275_: f32;
    var phi_3280_: f32;
    var phi_3287_: f32;
    var phi_3292_: f32;
    var phi_3306_: f32;
    var phi_3313_: f32;
    var phi_3318_: f32;
    var phi_3325_: f32;
    var phi_3330_: f32;
    var phi_3335_: f32;
    var phi_3366_: f32;
    var phi_3372_: f32;
    var phi_3379_: f32;
    var phi_3386_: f32;
    var phi_3392_: f32;
    var phi_3399_: f32;
    var phi_3405_: f32;
    var phi_3411_: f32;
    var phi_3417_: f32;
    var phi_3424_: f32;
    var phi_3431_: f32;
    var phi_3455_: f32;
    var phi_3460_: f32;
    var phi_3465_: f32;
    var phi_3470_: f32;
    var phi_3475_: f32;
    var phi_3480_: f32;
    var phi_3490_: f32;
    var phi_3606_: array<f32, 3>;
    var phi_3671_: array<f32, 3>;
    var phi_3693_: f32;
    var phi_3700_: f32;
    var phi_3705_: f32;
    var phi_3712_: f32;
    var phi_3717_: f32;
    var phi_3730_: f32;
    var phi_3737_: f32;
    var phi_3742_: f32;
    var phi_3749_: f32;
    var phi_3754_: f32;
    var phi_3759_: f32;
    var phi_3776_: f32;
    var phi_3783_: f32;
    var phi_3788_: f32;
    var phi_3795_: f32;
    var phi_3800_: f32;
    var phi_3814_: f32;
    var phi_3821_: f32;
    var phi_3826_: f32;
    var phi_3833_: f32;
    var phi_3838_: f32;
    var phi_3843_: f32;
    var phi_3860_: f32;
    var phi_3867_: f32;
    var phi_3872_: f32;
    var phi_3879_: f32;
    var phi_3884_: f32;
    var phi_3898_: f32;
    var phi_3905_: f32;
    var phi_3910_: f32;
    var phi_3917_: f32;
    var phi_3922_: f32;
    var phi_3927_: f32;
    var phi_4006_: f32;
    var phi_4011_: f32;
    var phi_4016_: f32;
    var phi_4021_: f32;
    var phi_4026_: f32;
    var phi_4031_: f32;
    var phi_4036_: f32;
    var phi_4041_: f32;
    var phi_4046_: f32;
    var phi_4051_: f32;
    var phi_4056_: f32;
    var phi_4061_: f32;
    var phi_4066_: f32;
    var phi_4071_: f32;
    var phi_4077_: f32;
    var phi_4083_: f32;
    var phi_4090_: f32;
    var phi_4101_: f32;
    var phi_4172_: f32;
    var phi_4177_: f32;
    var phi_4182_: f32;
    var phi_4187_: f32;
    var phi_4192_: f32;
    var phi_4197_: f32;
    var phi_4202_: f32;
    var phi_4207_: f32;
    var phi_4212_: f32;
    var phi_4217_: f32;
    var phi_4222_: f32;
    var phi_4227_: f32;
    var phi_4232_: f32;
    var phi_4237_: f32;
    var phi_4243_: f32;
    var phi_4249_: f32;
    var phi_4256_: f32;
    var phi_4267_: f32;
    var phi_4277_: f32;
    var phi_4350_: f32;
    var phi_4355_: f32;
    var phi_4360_: f32;
    var phi_4365_: f32;
    var phi_4370_: f32;
    var phi_4375_: f32;
    var phi_4380_: f32;
    var phi_4385_: f32;
    var phi_4390_: f32;
    var phi_4395_: f32;
    var phi_4400_: f32;
    var phi_4405_: f32;
    var phi_4410_: f32;
    var phi_4415_: f32;
    var phi_4421_: f32;
    var phi_4427_: f32;
    var phi_4434_: f32;
    var phi_4445_: f32;
    var phi_4455_: f32;
    var phi_4456_: f32;
    var phi_4459_: bool;
    var phi_4704_: f32;
    var phi_4711_: f32;
    var phi_4716_: f32;
    var phi_4723_: f32;
    var phi_4728_: f32;
    var phi_4741_: f32;
    var phi_4748_: f32;
    var phi_4753_: f32;
    var phi_4760_: f32;
    var phi_4765_: f32;
    var phi_4770_: f32;
    var phi_4787_: f32;
    var phi_4794_: f32;
    var phi_4799_: f32;
    var phi_4806_: f32;
    var phi_4811_: f32;
    var phi_4825_: f32;
    var phi_4832_: f32;
    var phi_4837_: f32;
    var phi_4844_: f32;
    var phi_4849_: f32;
    var phi_4854_: f32;
    var phi_4871_: f32;
    var phi_4878_: f32;
    var phi_4883_: f32;
    var phi_4890_: f32;
    var phi_4895_: f32;
    var phi_4909_: f32;
    var phi_4916_: f32;
    var phi_4921_: f32;
    var phi_4928_: f32;
    var phi_4933_: f32;
    var phi_4938_: f32;
    var phi_4969_: f32;
    var phi_4975_: f32;
    var phi_4982_: f32;
    var phi_4989_: f32;
    var phi_4995_: f32;
    var phi_5002_: f32;
    var phi_5008_: f32;
    var phi_5014_: f32;
    var phi_5020_: f32;
    var phi_5027_: f32;
    var phi_5034_: f32;
    var phi_5058_: f32;
    var phi_5063_: f32;
    var phi_5068_: f32;
    var phi_5073_: f32;
    var phi_5078_: f32;
    var phi_5083_: f32;
    var phi_5093_: f32;
    var phi_5209_: array<f32, 3>;
    var phi_5274_: array<f32, 3>;
    var phi_5296_: f32;
    var phi_5303_: f32;
    var phi_5308_: f32;
    var phi_5315_: f32;
    var phi_5320_: f32;
    var phi_5333_: f32;
    var phi_5340_: f32;
    var phi_5345_: f32;
    var phi_5352_: f32;
    var phi_5357_: f32;
    var phi_5362_: f32;
    var phi_5379_: f32;
    var phi_5386_: f32;
    var phi_5391_: f32;
    var phi_5398_: f32;
    var phi_5403_: f32;
    var phi_5417_: f32;
    var phi_5424_: f32;
    var phi_5429_: f32;
    var phi_5436_: f32;
    var phi_5441_: f32;
    var phi_5446_: f32;
    var phi_5463_: f32;
    var phi_5470_: f32;
    var phi_5475_: f32;
    var phi_5482_: f32;
    var phi_5487_: f32;
    var phi_5501_: f32;
    var phi_5508_: f32;
    var phi_5513_: f32;
    var phi_5520_: f32;
    var phi_5525_: f32;
    var phi_5530_: f32;
    var phi_5609_: f32;
    var phi_5614_: f32;
    var phi_5619_: f32;
    var phi_5624_: f32;
    var phi_5629_: f32;
    var phi_5634_: f32;
    var phi_5639_: f32;
    var phi_5644_: f32;
    var phi_5649_: f32;
    var phi_5654_: f32;
    var phi_5659_: f32;
    var phi_5664_: f32;
    var phi_5669_: f32;
    var phi_5674_: f32;
    var phi_5680_: f32;
    var phi_5686_: f32;
    var phi_5693_: f32;
    var phi_5704_: f32;
    var phi_5775_: f32;
    var phi_5780_: f32;
    var phi_5785_: f32;
    var phi_5790_: f32;
    var phi_5795_: f32;
    var phi_5800_: f32;
    var phi_5805_: f32;
    var phi_5810_: f32;
    var phi_5815_: f32;
    var phi_5820_: f32;
    var phi_5825_: f32;
    var phi_5830_: f32;
    var phi_5835_: f32;
    var phi_5840_: f32;
    var phi_5846_: f32;
    var phi_5852_: f32;
    var phi_5859_: f32;
    var phi_5870_: f32;
    var phi_5880_: f32;
    var phi_5953_: f32;
    var phi_5958_: f32;
    var phi_5963_: f32;
    var phi_5968_: f32;
    var phi_5973_: f32;
    var phi_5978_: f32;
    var phi_5983_: f32;
    var phi_5988_: f32;
    var phi_5993_: f32;
    var phi_5998_: f32;
    var phi_6003_: f32;
    var phi_6008_: f32;
    var phi_6013_: f32;
    var phi_6018_: f32;
    var phi_6024_: f32;
    var phi_6030_: f32;
    var phi_6037_: f32;
    var phi_6048_: f32;
    var phi_6058_: f32;
    var phi_6059_: f32;
    var phi_6062_: bool;
    var phi_6064_: bool;
    var phi_6073_: bool;
    var phi_6074_: bool;
    var phi_6102_: type_9;
    var phi_6103_: type_9;
    var phi_6126_: type_9;
    var phi_6160_: bool;
    var phi_6161_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e43 = id_2;
    let _e44 = n_2;
    let _e45 = lane_2;
    let _e55 = ((_e43.y * _e44.x) + _e43.x);
    let _e58 = (_e44.x * _e44.y);
    let _e60 = params.member.member;
    let _e63 = params.member.member_2.member;
    let _e71 = params.member.member_1.member_2;
    let _e73 = input.member[0u];
    if (_e71 < _e73) {
        phi_181_ = _e71;
    } else {
        phi_181_ = _e73;
    }
    let _e76 = phi_181_;
    let _e78 = params.member.member_1.member_1;
    if (_e76 > _e78) {
        let _e81 = params.member.member_1.member_1;
        phi_191_ = (_e76 - _e81);
    } else {
        phi_191_ = 0u;
    }
    let _e84 = phi_191_;
    let _e86 = params.member.member_1.member;
    if (_e86 < _e84) {
        phi_198_ = _e86;
    } else {
        phi_198_ = _e84;
    }
    let _e89 = phi_198_;
    let _e90 = (_e89 / 512u);
    if ((_e89 % 512u) > 0u) {
        phi_214_ = (_e90 + 1u);
    } else {
        phi_214_ = _e90;
    }
    let _e95 = phi_214_;
    if (_e95 > _e55) {
        let _e97 = (_e95 - _e55);
        if (_e58 == 0u) {
            return;
        }
        let _e99 = (_e97 / _e58);
        if (_e58 == 0u) {
            return;
        }
        if ((_e97 % _e58) > 0u) {
            phi_235_ = (_e99 + 1u);
        } else {
            phi_235_ = _e99;
        }
        let _e105 = phi_235_;
        phi_236_ = _e105;
    } else {
        phi_236_ = 0u;
    }
    let _e107 = phi_236_;
    phi_239_ = type_9(0u, _e107);
    loop {
        let _e110 = phi_239_;
        if (_e110.member < _e110.member_1) {
            phi_240_ = type_9((_e110.member + 1u), _e110.member_1);
            phi_263_ = type_9(1u, _e110.member);
        } else {
            phi_240_ = _e110;
            phi_263_ = type_9(0u, type_9().member_1);
        }
        let _e122 = phi_240_;
        let _e124 = phi_263_;
        let _e128 = (bitcast<i32>(_e124.member) != 0i);
        if _e128 {
            if (_e45 <= 1u) {
                atomicStore((&counters[_e45]), 0u);
            }
            workgroupBarrier();
            phi_281_ = type_9(0u, 4u);
            loop {
                let _e135 = phi_281_;
                if (_e135.member < _e135.member_1) {
                    phi_282_ = type_9((_e135.member + 1u), _e135.member_1);
                    phi_305_ = type_9(1u, _e135.member);
                } else {
                    phi_282_ = _e135;
                    phi_305_ = type_9(0u, type_9().member_1);
                }
                let _e147 = phi_282_;
                let _e149 = phi_305_;
                if (bitcast<i32>(_e149.member) != 0i) {
                    let _e156 = ((((_e55 + (_e124.member_1 * _e58)) * 512u) + (_e149.member_1 * 128u)) + _e45);
                    if (_e156 >= _e89) {
                        phi_2455_ = false;
                    } else {
                        let _e160 = params.member.member_1.member_1;
                        let _e162 = (2u * (_e160 + _e156));
                        let _e165 = input.member[(4u + _e162)];
                        let _e168 = input.member[(_e162 + 5u)];
                        if (_e63 == 0u) {
                            let _e184 = (3u * _e168);
                            let _e186 = elements.member[_e184];
                            let _e189 = elements.member[(_e184 + 1u)];
                            let _e192 = elements.member[(_e184 + 2u)];
                            phi_432_ = type_18(0u, array<u32, 4>(_e165, _e186, _e189, _e192));
                        } else {
                            let _e170 = (2u * _e165);
                            let _e171 = (2u * _e168);
                            let _e173 = elements.member[_e170];
                            let _e175 = elements.member[_e171];
                            let _e178 = elements.member[(_e170 + 1u)];
                            let _e181 = elements.member[(_e171 + 1u)];
                            phi_432_ = type_18(1u, array<u32, 4>(_e173, _e178, _e175, _e181));
                        }
                        let _e196 = phi_432_;
                        if ((_e60.member_1 & 512u) != 0u) {
                            phi_674_ = true;
                        } else {
                            let _e201 = paths.member[_e196.member_1[0]];
                            let _e216 = paths.member[_e196.member_1[1]];
                            let _e231 = paths.member[_e196.member_1[2]];
                            let _e246 = paths.member[_e196.member_1[3]];
                            let _e259 = array<f32, 3>(_e201.member.x, _e201.member.y, _e201.member.z);
                            let _e260 = array<f32, 3>(_e201.member_1.x, _e201.member_1.y, _e201.member_1.z);
                            if (_e196.member != 0u) {
                                let _e285 = function_(_e201.member.x, _e216.member.x);
                                let _e286 = function_(_e201.member.y, _e216.member.y);
                                let _e287 = function_(_e201.member.z, _e216.member.z);
                                let _e289 = function_1(_e201.member.x, _e216.member.x);
                                let _e290 = function_1(_e201.member.y, _e216.member.y);
                                let _e291 = function_1(_e201.member.z, _e216.member.z);
                                let _e294 = function_(_e231.member.x, _e246.member.x);
                                let _e295 = function_(_e231.member.y, _e246.member.y);
                                let _e296 = function_(_e231.member.z, _e246.member.z);
                                let _e298 = function_1(_e231.member.x, _e246.member.x);
                                let _e299 = function_1(_e231.member.y, _e246.member.y);
                                let _e300 = function_1(_e231.member.z, _e246.member.z);
                                phi_554_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>(_e285, _e286, _e287), array<f32, 3>(_e289, _e290, _e291)), array<array<f32, 3>, 2>(array<f32, 3>(_e294, _e295, _e296), array<f32, 3>(_e298, _e299, _e300)));
                            } else {
                                let _e262 = function_(_e216.member.x, _e231.member.x);
                                let _e263 = function_(_e216.member.y, _e231.member.y);
                                let _e264 = function_(_e216.member.z, _e231.member.z);
                                let _e265 = function_1(_e216.member.x, _e231.member.x);
                                let _e266 = function_1(_e216.member.y, _e231.member.y);
                                let _e267 = function_1(_e216.member.z, _e231.member.z);
                                let _e269 = function_(_e262, _e246.member.x);
                                let _e270 = function_(_e263, _e246.member.y);
                                let _e271 = function_(_e264, _e246.member.z);
                                let _e273 = function_1(_e262, _e246.member.x);
                                let _e274 = function_1(_e263, _e246.member.y);
                                let _e275 = function_1(_e264, _e246.member.z);
                                let _e276 = function_(_e265, _e246.member.x);
                                let _e277 = function_(_e266, _e246.member.y);
                                let _e278 = function_(_e267, _e246.member.z);
                                let _e279 = function_1(_e265, _e246.member.x);
                                let _e280 = function_1(_e266, _e246.member.y);
                                let _e281 = function_1(_e267, _e246.member.z);
                                phi_554_ = type_24(array<array<f32, 3>, 2>(_e259, _e259), array<array<f32, 3>, 2>(array<f32, 3>(_e269, _e270, _e271), array<f32, 3>(_e279, _e280, _e281)));
                            }
                            let _e305 = phi_554_;
                            if (_e196.member != 0u) {
                                let _e330 = function_(_e201.member_1.x, _e216.member_1.x);
                                let _e331 = function_(_e201.member_1.y, _e216.member_1.y);
                                let _e332 = function_(_e201.member_1.z, _e216.member_1.z);
                                let _e334 = function_1(_e201.member_1.x, _e216.member_1.x);
                                let _e335 = function_1(_e201.member_1.y, _e216.member_1.y);
                                let _e336 = function_1(_e201.member_1.z, _e216.member_1.z);
                                let _e339 = function_(_e231.member_1.x, _e246.member_1.x);
                                let _e340 = function_(_e231.member_1.y, _e246.member_1.y);
                                let _e341 = function_(_e231.member_1.z, _e246.member_1.z);
                                let _e343 = function_1(_e231.member_1.x, _e246.member_1.x);
                                let _e344 = function_1(_e231.member_1.y, _e246.member_1.y);
                                let _e345 = function_1(_e231.member_1.z, _e246.member_1.z);
                                phi_601_ = type_24(array<array<f32, 3>, 2>(array<f32, 3>(_e330, _e331, _e332), array<f32, 3>(_e334, _e335, _e336)), array<array<f32, 3>, 2>(array<f32, 3>(_e339, _e340, _e341), array<f32, 3>(_e343, _e344, _e345)));
                            } else {
                                let _e307 = function_(_e216.member_1.x, _e231.member_1.x);
                                let _e308 = function_(_e216.member_1.y, _e231.member_1.y);
                                let _e309 = function_(_e216.member_1.z, _e231.member_1.z);
                                let _e310 = function_1(_e216.member_1.x, _e231.member_1.x);
                                let _e311 = function_1(_e216.member_1.y, _e231.member_1.y);
                                let _e312 = function_1(_e216.member_1.z, _e231.member_1.z);
                                let _e314 = function_(_e307, _e246.member_1.x);
                                let _e315 = function_(_e308, _e246.member_1.y);
                                let _e316 = function_(_e309, _e246.member_1.z);
                                let _e318 = function_1(_e307, _e246.member_1.x);
                                let _e319 = function_1(_e308, _e246.member_1.y);
                                let _e320 = function_1(_e309, _e246.member_1.z);
                                let _e321 = function_(_e310, _e246.member_1.x);
                                let _e322 = function_(_e311, _e246.member_1.y);
                                let _e323 = function_(_e312, _e246.member_1.z);
                                let _e324 = function_1(_e310, _e246.member_1.x);
                                let _e325 = function_1(_e311, _e246.member_1.y);
                                let _e326 = function_1(_e312, _e246.member_1.z);
                                phi_601_ = type_24(array<array<f32, 3>, 2>(_e260, _e260), array<array<f32, 3>, 2>(array<f32, 3>(_e314, _e315, _e316), array<f32, 3>(_e324, _e325, _e326)));
                            }
                            let _e350 = phi_601_;
                            let _e359 = (((_e60.member_5 + (2f * _e60.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
                            phi_674_ = !(((((((_e305.member[0][0] - _e305.member_1[1][0]) > _e359) && ((_e350.member[0][0] - _e350.member_1[1][0]) > _e359)) || (((_e305.member_1[0][0] - _e305.member[1][0]) > _e359) && ((_e350.member_1[0][0] - _e350.member[1][0]) > _e359))) || ((((_e305.member[0][1] - _e305.member_1[1][1]) > _e359) && ((_e350.member[0][1] - _e350.member_1[1][1]) > _e359)) || (((_e305.member_1[0][1] - _e305.member[1][1]) > _e359) && ((_e350.member_1[0][1] - _e350.member[1][1]) > _e359)))) || ((((_e305.member[0][2] - _e305.member_1[1][2]) > _e359) && ((_e350.member[0][2] - _e350.member_1[1][2]) > _e359)) || (((_e305.member_1[0][2] - _e305.member[1][2]) > _e359) && ((_e350.member_1[0][2] - _e350.member[1][2]) > _e359)))));
                        }
                        let _e445 = phi_674_;
                        if _e445 {
                            let _e448 = paths.member[_e196.member_1[0]];
                            let _e463 = paths.member[_e196.member_1[1]];
                            let _e478 = paths.member[_e196.member_1[2]];
                            let _e493 = paths.member[_e196.member_1[3]];
                            if (_e196.member != 0u) {
                                phi_808_ = type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e478.member.x - _e448.member.x), (_e478.member.y - _e448.member.y), (_e478.member.z - _e448.member.z)), array<f32, 3>((_e478.member_1.x - _e448.member_1.x), (_e478.member_1.y - _e448.member_1.y), (_e478.member_1.z - _e448.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e463.member.x - _e448.member.x), (_e463.member.y - _e448.member.y), (_e463.member.z - _e448.member.z)), array<f32, 3>((_e463.member_1.x - _e448.member_1.x), (_e463.member_1.y - _e448.member_1.y), (_e463.member_1.z - _e448.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e478.member.x - _e493.member.x), (_e478.member.y - _e493.member.y), (_e478.member.z - _e493.member.z)), array<f32, 3>((_e478.member_1.x - _e493.member_1.x), (_e478.member_1.y - _e493.member_1.y), (_e478.member_1.z - _e493.member_1.z))), (_e60.member_4 + _e60.member_4));
                            } else {
                                phi_808_ = type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e448.member.x - _e463.member.x), (_e448.member.y - _e463.member.y), (_e448.member.z - _e463.member.z)), array<f32, 3>((_e448.member_1.x - _e463.member_1.x), (_e448.member_1.y - _e463.member_1.y), (_e448.member_1.z - _e463.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e478.member.x - _e463.member.x), (_e478.member.y - _e463.member.y), (_e478.member.z - _e463.member.z)), array<f32, 3>((_e478.member_1.x - _e463.member_1.x), (_e478.member_1.y - _e463.member_1.y), (_e478.member_1.z - _e463.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e493.member.x - _e463.member.x), (_e493.member.y - _e463.member.y), (_e493.member.z - _e463.member.z)), array<f32, 3>((_e493.member_1.x - _e463.member_1.x), (_e493.member_1.y - _e463.member_1.y), (_e493.member_1.z - _e463.member_1.z))), (_e60.member_4 + _e60.member_4));
                            }
                            let _e566 = phi_808_;
                            local_2 = type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e566.member[0][0], _e566.member[0][1], _e566.member[0][2]), array<f32, 3>(_e566.member[1][0], _e566.member[1][1], _e566.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e566.member_1[0][0], _e566.member_1[0][1], _e566.member_1[0][2]), array<f32, 3>(_e566.member_1[1][0], _e566.member_1[1][1], _e566.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e566.member_2[0][0], _e566.member_2[0][1], _e566.member_2[0][2]), array<f32, 3>(_e566.member_2[1][0], _e566.member_2[1][1], _e566.member_2[1][2])), _e566.member_3);
                            let _e607 = local_2.member_1[0u];
                            let _e613 = local_2.member_2[0u];
                            let _e619 = ((_e607[1] * _e613[2]) - (_e607[2] * _e613[1]));
                            let _e622 = ((_e607[2] * _e613[0]) - (_e607[0] * _e613[2]));
                            let _e625 = ((_e607[0] * _e613[1]) - (_e607[1] * _e613[0]));
                            let _e628 = local_2.member_1[1u];
                            let _e634 = local_2.member_2[1u];
                            let _e640 = ((_e628[1] * _e634[2]) - (_e628[2] * _e634[1]));
                            let _e643 = ((_e628[2] * _e634[0]) - (_e628[0] * _e634[2]));
                            let _e646 = ((_e628[0] * _e634[1]) - (_e628[1] * _e634[0]));
                            let _e649 = local_2.member_1[0u];
                            let _e655 = local_2.member_2[1u];
                            let _e670 = local_2.member_1[1u];
                            let _e676 = local_2.member_2[0u];
                            let _e689 = (((_e649[1] * _e655[2]) - (_e649[2] * _e655[1])) + ((_e670[1] * _e676[2]) - (_e670[2] * _e676[1])));
                            let _e690 = (((_e649[2] * _e655[0]) - (_e649[0] * _e655[2])) + ((_e670[2] * _e676[0]) - (_e670[0] * _e676[2])));
                            let _e691 = (((_e649[0] * _e655[1]) - (_e649[1] * _e655[0])) + ((_e670[0] * _e676[1]) - (_e670[1] * _e676[0])));
                            let _e694 = local_2.member[0u];
                            let _e705 = local_2.member[1u];
                            let _e716 = local_2.member[0u];
                            let _e725 = ((((_e705[0] * _e619) + (_e705[1] * _e622)) + (_e705[2] * _e625)) + (((_e716[0] * _e689) + (_e716[1] * _e690)) + (_e716[2] * _e691)));
                            let _e728 = local_2.member[0u];
                            let _e739 = local_2.member[1u];
                            let _e748 = ((((_e728[0] * _e640) + (_e728[1] * _e643)) + (_e728[2] * _e646)) + (((_e739[0] * _e689) + (_e739[1] * _e690)) + (_e739[2] * _e691)));
                            let _e751 = local_2.member[1u];
                            let _e762 = local_2.member[0u];
                            if (_e762[0] < 0f) {
                                phi_1088_ = -(_e762[0]);
                            } else {
                                phi_1088_ = _e762[0];
                            }
                            let _e769 = phi_1088_;
                            if (_e762[1] < 0f) {
                                phi_1095_ = -(_e762[1]);
                            } else {
                                phi_1095_ = _e762[1];
                            }
                            let _e773 = phi_1095_;
                            if (_e769 > _e773) {
                                phi_1100_ = _e769;
                            } else {
                                phi_1100_ = _e773;
                            }
                            let _e776 = phi_1100_;
                            if (_e762[2] < 0f) {
                                phi_1107_ = -(_e762[2]);
                            } else {
                                phi_1107_ = _e762[2];
                            }
                            let _e780 = phi_1107_;
                            if (_e776 > _e780) {
                                phi_1112_ = _e776;
                            } else {
                                phi_1112_ = _e780;
                            }
                            let _e783 = phi_1112_;
                            let _e786 = local_2.member[1u];
                            if (_e786[0] < 0f) {
                                phi_1125_ = -(_e786[0]);
                            } else {
                                phi_1125_ = _e786[0];
                            }
                            let _e793 = phi_1125_;
                            if (_e786[1] < 0f) {
                                phi_1132_ = -(_e786[1]);
                            } else {
                                phi_1132_ = _e786[1];
                            }
                            let _e797 = phi_1132_;
                            if (_e793 > _e797) {
                                phi_1137_ = _e793;
                            } else {
                                phi_1137_ = _e797;
                            }
                            let _e800 = phi_1137_;
                            if (_e786[2] < 0f) {
                                phi_1144_ = -(_e786[2]);
                            } else {
                                phi_1144_ = _e786[2];
                            }
                            let _e804 = phi_1144_;
                            if (_e800 > _e804) {
                                phi_1149_ = _e800;
                            } else {
                                phi_1149_ = _e804;
                            }
                            let _e807 = phi_1149_;
                            if (_e783 > _e807) {
                                phi_1154_ = _e783;
                            } else {
                                phi_1154_ = _e807;
                            }
                            let _e810 = phi_1154_;
                            let _e812 = local_2.member_3;
                            let _e813 = (_e810 + _e812);
                            let _e816 = local_2.member_1[0u];
                            if (_e816[0] < 0f) {
                                phi_1171_ = -(_e816[0]);
                            } else {
                                phi_1171_ = _e816[0];
                            }
                            let _e823 = phi_1171_;
                            if (_e816[1] < 0f) {
                                phi_1178_ = -(_e816[1]);
                            } else {
                                phi_1178_ = _e816[1];
                            }
                            let _e827 = phi_1178_;
                            if (_e823 > _e827) {
                                phi_1183_ = _e823;
                            } else {
                                phi_1183_ = _e827;
                            }
                            let _e830 = phi_1183_;
                            if (_e816[2] < 0f) {
                                phi_1190_ = -(_e816[2]);
                            } else {
                                phi_1190_ = _e816[2];
                            }
                            let _e834 = phi_1190_;
                            if (_e830 > _e834) {
                                phi_1195_ = _e830;
                            } else {
                                phi_1195_ = _e834;
                            }
                            let _e837 = phi_1195_;
                            let _e840 = local_2.member_1[1u];
                            if (_e840[0] < 0f) {
                                phi_1209_ = -(_e840[0]);
                            } else {
                                phi_1209_ = _e840[0];
                            }
                            let _e847 = phi_1209_;
                            if (_e840[1] < 0f) {
                                phi_1216_ = -(_e840[1]);
                            } else {
                                phi_1216_ = _e840[1];
                            }
                            let _e851 = phi_1216_;
                            if (_e847 > _e851) {
                                phi_1221_ = _e847;
                            } else {
                                phi_1221_ = _e851;
                            }
                            let _e854 = phi_1221_;
                            if (_e840[2] < 0f) {
                                phi_1228_ = -(_e840[2]);
                            } else {
                                phi_1228_ = _e840[2];
                            }
                            let _e858 = phi_1228_;
                            if (_e854 > _e858) {
                                phi_1233_ = _e854;
                            } else {
                                phi_1233_ = _e858;
                            }
                            let _e861 = phi_1233_;
                            if (_e837 > _e861) {
                                phi_1238_ = _e837;
                            } else {
                                phi_1238_ = _e861;
                            }
                            let _e864 = phi_1238_;
                            let _e866 = local_2.member_3;
                            let _e867 = (_e864 + _e866);
                            let _e870 = local_2.member_2[0u];
                            if (_e870[0] < 0f) {
                                phi_1255_ = -(_e870[0]);
                            } else {
                                phi_1255_ = _e870[0];
                            }
                            let _e877 = phi_1255_;
                            if (_e870[1] < 0f) {
                                phi_1262_ = -(_e870[1]);
                            } else {
                                phi_1262_ = _e870[1];
                            }
                            let _e881 = phi_1262_;
                            if (_e877 > _e881) {
                                phi_1267_ = _e877;
                            } else {
                                phi_1267_ = _e881;
                            }
                            let _e884 = phi_1267_;
                            if (_e870[2] < 0f) {
                                phi_1274_ = -(_e870[2]);
                            } else {
                                phi_1274_ = _e870[2];
                            }
                            let _e888 = phi_1274_;
                            if (_e884 > _e888) {
                                phi_1279_ = _e884;
                            } else {
                                phi_1279_ = _e888;
                            }
                            let _e891 = phi_1279_;
                            let _e894 = local_2.member_2[1u];
                            if (_e894[0] < 0f) {
                                phi_1293_ = -(_e894[0]);
                            } else {
                                phi_1293_ = _e894[0];
                            }
                            let _e901 = phi_1293_;
                            if (_e894[1] < 0f) {
                                phi_1300_ = -(_e894[1]);
                            } else {
                                phi_1300_ = _e894[1];
                            }
                            let _e905 = phi_1300_;
                            if (_e901 > _e905) {
                                phi_1305_ = _e901;
                            } else {
                                phi_1305_ = _e905;
                            }
                            let _e908 = phi_1305_;
                            if (_e894[2] < 0f) {
                                phi_1312_ = -(_e894[2]);
                            } else {
                                phi_1312_ = _e894[2];
                            }
                            let _e912 = phi_1312_;
                            if (_e908 > _e912) {
                                phi_1317_ = _e908;
                            } else {
                                phi_1317_ = _e912;
                            }
                            let _e915 = phi_1317_;
                            if (_e891 > _e915) {
                                phi_1322_ = _e891;
                            } else {
                                phi_1322_ = _e915;
                            }
                            let _e918 = phi_1322_;
                            let _e920 = local_2.member_3;
                            let _e921 = (_e918 + _e920);
                            let _e923 = ((_e867 * 8f) * _e921);
                            let _e930 = local_2.member_3;
                            if (_e619 < 0f) {
                                phi_1353_ = -(_e619);
                            } else {
                                phi_1353_ = _e619;
                            }
                            let _e947 = phi_1353_;
                            if (_e622 < 0f) {
                                phi_1359_ = -(_e622);
                            } else {
                                phi_1359_ = _e622;
                            }
                            let _e951 = phi_1359_;
                            if (_e625 < 0f) {
                                phi_1366_ = -(_e625);
                            } else {
                                phi_1366_ = _e625;
                            }
                            let _e956 = phi_1366_;
                            let _e957 = ((_e947 + _e951) + _e956);
                            if (_e640 < 0f) {
                                phi_1373_ = -(_e640);
                            } else {
                                phi_1373_ = _e640;
                            }
                            let _e961 = phi_1373_;
                            if (_e643 < 0f) {
                                phi_1379_ = -(_e643);
                            } else {
                                phi_1379_ = _e643;
                            }
                            let _e965 = phi_1379_;
                            if (_e646 < 0f) {
                                phi_1386_ = -(_e646);
                            } else {
                                phi_1386_ = _e646;
                            }
                            let _e970 = phi_1386_;
                            let _e971 = ((_e961 + _e965) + _e970);
                            if (_e957 > _e971) {
                                phi_1392_ = _e957;
                            } else {
                                phi_1392_ = _e971;
                            }
                            let _e974 = phi_1392_;
                            if (_e689 < 0f) {
                                phi_1398_ = -(_e689);
                            } else {
                                phi_1398_ = _e689;
                            }
                            let _e978 = phi_1398_;
                            if (_e690 < 0f) {
                                phi_1404_ = -(_e690);
                            } else {
                                phi_1404_ = _e690;
                            }
                            let _e982 = phi_1404_;
                            if (_e691 < 0f) {
                                phi_1411_ = -(_e691);
                            } else {
                                phi_1411_ = _e691;
                            }
                            let _e987 = phi_1411_;
                            let _e989 = (((_e978 + _e982) + _e987) * 0.5f);
                            if (_e974 > _e989) {
                                phi_1418_ = _e974;
                            } else {
                                phi_1418_ = _e989;
                            }
                            let _e992 = phi_1418_;
                            let _e997 = local_2.member_3;
                            let _e1010 = ((((_e694[0] * _e619) + (_e694[1] * _e622)) + (_e694[2] * _e625)) * 3f);
                            let _e1011 = ((((_e751[0] * _e640) + (_e751[1] * _e643)) + (_e751[2] * _e646)) * 3f);
                            if (_e1010 < _e1011) {
                                phi_1442_ = _e1010;
                            } else {
                                phi_1442_ = _e1011;
                            }
                            let _e1014 = phi_1442_;
                            if (_e725 < _e748) {
                                phi_1447_ = _e725;
                            } else {
                                phi_1447_ = _e748;
                            }
                            let _e1017 = phi_1447_;
                            if (_e1014 < _e1017) {
                                phi_1452_ = _e1014;
                            } else {
                                phi_1452_ = _e1017;
                            }
                            let _e1020 = phi_1452_;
                            if (_e1010 > _e1011) {
                                phi_1457_ = _e1010;
                            } else {
                                phi_1457_ = _e1011;
                            }
                            let _e1023 = phi_1457_;
                            if (_e725 > _e748) {
                                phi_1462_ = _e725;
                            } else {
                                phi_1462_ = _e748;
                            }
                            let _e1026 = phi_1462_;
                            if (_e1023 > _e1026) {
                                phi_1467_ = _e1023;
                            } else {
                                phi_1467_ = _e1026;
                            }
                            let _e1029 = phi_1467_;
                            let _e1034 = -(_e1029);
                            if (_e1020 > _e1034) {
                                phi_1477_ = _e1020;
                            } else {
                                phi_1477_ = _e1034;
                            }
                            let _e1037 = phi_1477_;
                            let _e1039 = ((_e1037 - ((((((_e813 * 8f) * _e923) * (0.000000059604645f * (524f / 64f))) + ((_e930 * 19f) * ((_e813 * (_e867 + _e921)) + (_e867 * _e921)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e813) * ((1f + _e867) * (1f + _e921))))) + ((_e60.member_5 * (((_e992 + (_e923 * (0.000000059604645f * 8f))) + ((_e997 * 6f) * (_e867 + _e921))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e867) * (1f + _e921))))) * (3f * 1.0001f)))) > 0f);
                            if _e1039 {
                                phi_2446_ = _e1039;
                            } else {
                                let _e1042 = local_2.member_1[0u];
                                let _e1048 = local_2.member_1[1u];
                                let _e1052 = (_e1042[0] + _e1048[0]);
                                let _e1053 = (_e1042[1] + _e1048[1]);
                                let _e1054 = (_e1042[2] + _e1048[2]);
                                let _e1057 = local_2.member_2[0u];
                                let _e1063 = local_2.member_2[1u];
                                let _e1067 = (_e1057[0] + _e1063[0]);
                                let _e1068 = (_e1057[1] + _e1063[1]);
                                let _e1069 = (_e1057[2] + _e1063[2]);
                                let _e1072 = ((_e1053 * _e1069) - (_e1054 * _e1068));
                                let _e1075 = ((_e1054 * _e1067) - (_e1052 * _e1069));
                                let _e1078 = ((_e1052 * _e1068) - (_e1053 * _e1067));
                                let _e1081 = local_2.member[0u];
                                let _e1088 = local_2.member_1[0u];
                                let _e1094 = local_2.member_2[0u];
                                let _e1098 = (_e1081[0] - _e1088[0]);
                                let _e1099 = (_e1081[1] - _e1088[1]);
                                let _e1100 = (_e1081[2] - _e1088[2]);
                                if (_e196.member == 0u) {
                                    phi_1593_ = array<f32, 3>(_e1081[0], _e1081[1], _e1081[2]);
                                } else {
                                    phi_1593_ = array<f32, 3>((_e1098 - _e1094[0]), (_e1099 - _e1094[1]), (_e1100 - _e1094[2]));
                                }
                                let _e1107 = phi_1593_;
                                let _e1108 = (_e1081[0] - _e1094[0]);
                                let _e1109 = (_e1081[1] - _e1094[1]);
                                let _e1110 = (_e1081[2] - _e1094[2]);
                                let _e1113 = local_2.member[1u];
                                let _e1120 = local_2.member_1[1u];
                                let _e1126 = local_2.member_2[1u];
                                let _e1130 = (_e1113[0] - _e1120[0]);
                                let _e1131 = (_e1113[1] - _e1120[1]);
                                let _e1132 = (_e1113[2] - _e1120[2]);
                                if (_e196.member == 0u) {
                                    phi_1658_ = array<f32, 3>(_e1113[0], _e1113[1], _e1113[2]);
                                } else {
                                    phi_1658_ = array<f32, 3>((_e1130 - _e1126[0]), (_e1131 - _e1126[1]), (_e1132 - _e1126[2]));
                                }
                                let _e1139 = phi_1658_;
                                let _e1140 = (_e1113[0] - _e1126[0]);
                                let _e1141 = (_e1113[1] - _e1126[1]);
                                let _e1142 = (_e1113[2] - _e1126[2]);
                                let _e1145 = local_2.member[0u];
                                if (_e1145[0] < 0f) {
                                    phi_1680_ = -(_e1145[0]);
                                } else {
                                    phi_1680_ = _e1145[0];
                                }
                                let _e1152 = phi_1680_;
                                if (_e1145[1] < 0f) {
                                    phi_1687_ = -(_e1145[1]);
                                } else {
                                    phi_1687_ = _e1145[1];
                                }
                                let _e1156 = phi_1687_;
                                if (_e1152 > _e1156) {
                                    phi_1692_ = _e1152;
                                } else {
                                    phi_1692_ = _e1156;
                                }
                                let _e1159 = phi_1692_;
                                if (_e1145[2] < 0f) {
                                    phi_1699_ = -(_e1145[2]);
                                } else {
                                    phi_1699_ = _e1145[2];
                                }
                                let _e1163 = phi_1699_;
                                if (_e1159 > _e1163) {
                                    phi_1704_ = _e1159;
                                } else {
                                    phi_1704_ = _e1163;
                                }
                                let _e1166 = phi_1704_;
                                let _e1169 = local_2.member[1u];
                                if (_e1169[0] < 0f) {
                                    phi_1717_ = -(_e1169[0]);
                                } else {
                                    phi_1717_ = _e1169[0];
                                }
                                let _e1176 = phi_1717_;
                                if (_e1169[1] < 0f) {
                                    phi_1724_ = -(_e1169[1]);
                                } else {
                                    phi_1724_ = _e1169[1];
                                }
                                let _e1180 = phi_1724_;
                                if (_e1176 > _e1180) {
                                    phi_1729_ = _e1176;
                                } else {
                                    phi_1729_ = _e1180;
                                }
                                let _e1183 = phi_1729_;
                                if (_e1169[2] < 0f) {
                                    phi_1736_ = -(_e1169[2]);
                                } else {
                                    phi_1736_ = _e1169[2];
                                }
                                let _e1187 = phi_1736_;
                                if (_e1183 > _e1187) {
                                    phi_1741_ = _e1183;
                                } else {
                                    phi_1741_ = _e1187;
                                }
                                let _e1190 = phi_1741_;
                                if (_e1166 > _e1190) {
                                    phi_1746_ = _e1166;
                                } else {
                                    phi_1746_ = _e1190;
                                }
                                let _e1193 = phi_1746_;
                                let _e1195 = local_2.member_3;
                                let _e1199 = local_2.member_1[0u];
                                if (_e1199[0] < 0f) {
                                    phi_1763_ = -(_e1199[0]);
                                } else {
                                    phi_1763_ = _e1199[0];
                                }
                                let _e1206 = phi_1763_;
                                if (_e1199[1] < 0f) {
                                    phi_1770_ = -(_e1199[1]);
                                } else {
                                    phi_1770_ = _e1199[1];
                                }
                                let _e1210 = phi_1770_;
                                if (_e1206 > _e1210) {
                                    phi_1775_ = _e1206;
                                } else {
                                    phi_1775_ = _e1210;
                                }
                                let _e1213 = phi_1775_;
                                if (_e1199[2] < 0f) {
                                    phi_1782_ = -(_e1199[2]);
                                } else {
                                    phi_1782_ = _e1199[2];
                                }
                                let _e1217 = phi_1782_;
                                if (_e1213 > _e1217) {
                                    phi_1787_ = _e1213;
                                } else {
                                    phi_1787_ = _e1217;
                                }
                                let _e1220 = phi_1787_;
                                let _e1223 = local_2.member_1[1u];
                                if (_e1223[0] < 0f) {
                                    phi_1801_ = -(_e1223[0]);
                                } else {
                                    phi_1801_ = _e1223[0];
                                }
                                let _e1230 = phi_1801_;
                                if (_e1223[1] < 0f) {
                                    phi_1808_ = -(_e1223[1]);
                                } else {
                                    phi_1808_ = _e1223[1];
                                }
                                let _e1234 = phi_1808_;
                                if (_e1230 > _e1234) {
                                    phi_1813_ = _e1230;
                                } else {
                                    phi_1813_ = _e1234;
                                }
                                let _e1237 = phi_1813_;
                                if (_e1223[2] < 0f) {
                                    phi_1820_ = -(_e1223[2]);
                                } else {
                                    phi_1820_ = _e1223[2];
                                }
                                let _e1241 = phi_1820_;
                                if (_e1237 > _e1241) {
                                    phi_1825_ = _e1237;
                                } else {
                                    phi_1825_ = _e1241;
                                }
                                let _e1244 = phi_1825_;
                                if (_e1220 > _e1244) {
                                    phi_1830_ = _e1220;
                                } else {
                                    phi_1830_ = _e1244;
                                }
                                let _e1247 = phi_1830_;
                                let _e1249 = local_2.member_3;
                                let _e1253 = local_2.member_2[0u];
                                if (_e1253[0] < 0f) {
                                    phi_1847_ = -(_e1253[0]);
                                } else {
                                    phi_1847_ = _e1253[0];
                                }
                                let _e1260 = phi_1847_;
                                if (_e1253[1] < 0f) {
                                    phi_1854_ = -(_e1253[1]);
                                } else {
                                    phi_1854_ = _e1253[1];
                                }
                                let _e1264 = phi_1854_;
                                if (_e1260 > _e1264) {
                                    phi_1859_ = _e1260;
                                } else {
                                    phi_1859_ = _e1264;
                                }
                                let _e1267 = phi_1859_;
                                if (_e1253[2] < 0f) {
                                    phi_1866_ = -(_e1253[2]);
                                } else {
                                    phi_1866_ = _e1253[2];
                                }
                                let _e1271 = phi_1866_;
                                if (_e1267 > _e1271) {
                                    phi_1871_ = _e1267;
                                } else {
                                    phi_1871_ = _e1271;
                                }
                                let _e1274 = phi_1871_;
                                let _e1277 = local_2.member_2[1u];
                                if (_e1277[0] < 0f) {
                                    phi_1885_ = -(_e1277[0]);
                                } else {
                                    phi_1885_ = _e1277[0];
                                }
                                let _e1284 = phi_1885_;
                                if (_e1277[1] < 0f) {
                                    phi_1892_ = -(_e1277[1]);
                                } else {
                                    phi_1892_ = _e1277[1];
                                }
                                let _e1288 = phi_1892_;
                                if (_e1284 > _e1288) {
                                    phi_1897_ = _e1284;
                                } else {
                                    phi_1897_ = _e1288;
                                }
                                let _e1291 = phi_1897_;
                                if (_e1277[2] < 0f) {
                                    phi_1904_ = -(_e1277[2]);
                                } else {
                                    phi_1904_ = _e1277[2];
                                }
                                let _e1295 = phi_1904_;
                                if (_e1291 > _e1295) {
                                    phi_1909_ = _e1291;
                                } else {
                                    phi_1909_ = _e1295;
                                }
                                let _e1298 = phi_1909_;
                                if (_e1274 > _e1298) {
                                    phi_1914_ = _e1274;
                                } else {
                                    phi_1914_ = _e1298;
                                }
                                let _e1301 = phi_1914_;
                                let _e1303 = local_2.member_3;
                                let _e1307 = ((((_e1193 + _e1195) + (_e1247 + _e1249)) + (_e1301 + _e1303)) * 2f);
                                let _e1310 = local_2.member_3;
                                let _e1314 = (((_e60.member_5 * 1.0001f) + (_e1310 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e1317 = ((_e1075 * _e1054) - (_e1078 * _e1053));
                                let _e1320 = ((_e1078 * _e1052) - (_e1072 * _e1054));
                                let _e1323 = ((_e1072 * _e1053) - (_e1075 * _e1052));
                                let _e1328 = (((_e1317 * _e1081[0]) + (_e1320 * _e1081[1])) + (_e1323 * _e1081[2]));
                                let _e1333 = (((_e1317 * _e1098) + (_e1320 * _e1099)) + (_e1323 * _e1100));
                                let _e1338 = (((_e1317 * _e1108) + (_e1320 * _e1109)) + (_e1323 * _e1110));
                                let _e1346 = (((_e1317 * _e1107[0]) + (_e1320 * _e1107[1])) + (_e1323 * _e1107[2]));
                                let _e1351 = (((_e1317 * _e1113[0]) + (_e1320 * _e1113[1])) + (_e1323 * _e1113[2]));
                                let _e1356 = (((_e1317 * _e1130) + (_e1320 * _e1131)) + (_e1323 * _e1132));
                                let _e1361 = (((_e1317 * _e1140) + (_e1320 * _e1141)) + (_e1323 * _e1142));
                                let _e1369 = (((_e1317 * _e1139[0]) + (_e1320 * _e1139[1])) + (_e1323 * _e1139[2]));
                                if (_e1328 < _e1333) {
                                    phi_1993_ = _e1328;
                                } else {
                                    phi_1993_ = _e1333;
                                }
                                let _e1372 = phi_1993_;
                                if (_e1338 < _e1346) {
                                    phi_1998_ = _e1338;
                                } else {
                                    phi_1998_ = _e1346;
                                }
                                let _e1375 = phi_1998_;
                                if (_e1372 < _e1375) {
                                    phi_2003_ = _e1372;
                                } else {
                                    phi_2003_ = _e1375;
                                }
                                let _e1378 = phi_2003_;
                                if (_e1351 < _e1356) {
                                    phi_2008_ = _e1351;
                                } else {
                                    phi_2008_ = _e1356;
                                }
                                let _e1381 = phi_2008_;
                                if (_e1361 < _e1369) {
                                    phi_2013_ = _e1361;
                                } else {
                                    phi_2013_ = _e1369;
                                }
                                let _e1384 = phi_2013_;
                                if (_e1381 < _e1384) {
                                    phi_2018_ = _e1381;
                                } else {
                                    phi_2018_ = _e1384;
                                }
                                let _e1387 = phi_2018_;
                                if (_e1378 < _e1387) {
                                    phi_2023_ = _e1378;
                                } else {
                                    phi_2023_ = _e1387;
                                }
                                let _e1390 = phi_2023_;
                                if (_e1328 > _e1333) {
                                    phi_2028_ = _e1328;
                                } else {
                                    phi_2028_ = _e1333;
                                }
                                let _e1393 = phi_2028_;
                                if (_e1338 > _e1346) {
                                    phi_2033_ = _e1338;
                                } else {
                                    phi_2033_ = _e1346;
                                }
                                let _e1396 = phi_2033_;
                                if (_e1393 > _e1396) {
                                    phi_2038_ = _e1393;
                                } else {
                                    phi_2038_ = _e1396;
                                }
                                let _e1399 = phi_2038_;
                                if (_e1351 > _e1356) {
                                    phi_2043_ = _e1351;
                                } else {
                                    phi_2043_ = _e1356;
                                }
                                let _e1402 = phi_2043_;
                                if (_e1361 > _e1369) {
                                    phi_2048_ = _e1361;
                                } else {
                                    phi_2048_ = _e1369;
                                }
                                let _e1405 = phi_2048_;
                                if (_e1402 > _e1405) {
                                    phi_2053_ = _e1402;
                                } else {
                                    phi_2053_ = _e1405;
                                }
                                let _e1408 = phi_2053_;
                                if (_e1399 > _e1408) {
                                    phi_2058_ = _e1399;
                                } else {
                                    phi_2058_ = _e1408;
                                }
                                let _e1411 = phi_2058_;
                                if (_e1317 < 0f) {
                                    phi_2064_ = -(_e1317);
                                } else {
                                    phi_2064_ = _e1317;
                                }
                                let _e1415 = phi_2064_;
                                if (_e1320 < 0f) {
                                    phi_2070_ = -(_e1320);
                                } else {
                                    phi_2070_ = _e1320;
                                }
                                let _e1419 = phi_2070_;
                                if (_e1323 < 0f) {
                                    phi_2077_ = -(_e1323);
                                } else {
                                    phi_2077_ = _e1323;
                                }
                                let _e1424 = phi_2077_;
                                let _e1425 = ((_e1415 + _e1419) + _e1424);
                                let _e1430 = -(_e1411);
                                if (_e1390 > _e1430) {
                                    phi_2088_ = _e1390;
                                } else {
                                    phi_2088_ = _e1430;
                                }
                                let _e1433 = phi_2088_;
                                let _e1438 = (((_e1433 - ((_e1425 * _e1307) * (0.000000059604645f * (17f / 2f)))) - (_e1425 * _e1314)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e1441 = ((_e1075 * _e1069) - (_e1078 * _e1068));
                                let _e1444 = ((_e1078 * _e1067) - (_e1072 * _e1069));
                                let _e1447 = ((_e1072 * _e1068) - (_e1075 * _e1067));
                                let _e1452 = (((_e1441 * _e1081[0]) + (_e1444 * _e1081[1])) + (_e1447 * _e1081[2]));
                                let _e1457 = (((_e1441 * _e1098) + (_e1444 * _e1099)) + (_e1447 * _e1100));
                                let _e1462 = (((_e1441 * _e1108) + (_e1444 * _e1109)) + (_e1447 * _e1110));
                                let _e1470 = (((_e1441 * _e1107[0]) + (_e1444 * _e1107[1])) + (_e1447 * _e1107[2]));
                                let _e1475 = (((_e1441 * _e1113[0]) + (_e1444 * _e1113[1])) + (_e1447 * _e1113[2]));
                                let _e1480 = (((_e1441 * _e1130) + (_e1444 * _e1131)) + (_e1447 * _e1132));
                                let _e1485 = (((_e1441 * _e1140) + (_e1444 * _e1141)) + (_e1447 * _e1142));
                                let _e1493 = (((_e1441 * _e1139[0]) + (_e1444 * _e1139[1])) + (_e1447 * _e1139[2]));
                                if (_e1452 < _e1457) {
                                    phi_2159_ = _e1452;
                                } else {
                                    phi_2159_ = _e1457;
                                }
                                let _e1496 = phi_2159_;
                                if (_e1462 < _e1470) {
                                    phi_2164_ = _e1462;
                                } else {
                                    phi_2164_ = _e1470;
                                }
                                let _e1499 = phi_2164_;
                                if (_e1496 < _e1499) {
                                    phi_2169_ = _e1496;
                                } else {
                                    phi_2169_ = _e1499;
                                }
                                let _e1502 = phi_2169_;
                                if (_e1475 < _e1480) {
                                    phi_2174_ = _e1475;
                                } else {
                                    phi_2174_ = _e1480;
                                }
                                let _e1505 = phi_2174_;
                                if (_e1485 < _e1493) {
                                    phi_2179_ = _e1485;
                                } else {
                                    phi_2179_ = _e1493;
                                }
                                let _e1508 = phi_2179_;
                                if (_e1505 < _e1508) {
                                    phi_2184_ = _e1505;
                                } else {
                                    phi_2184_ = _e1508;
                                }
                                let _e1511 = phi_2184_;
                                if (_e1502 < _e1511) {
                                    phi_2189_ = _e1502;
                                } else {
                                    phi_2189_ = _e1511;
                                }
                                let _e1514 = phi_2189_;
                                if (_e1452 > _e1457) {
                                    phi_2194_ = _e1452;
                                } else {
                                    phi_2194_ = _e1457;
                                }
                                let _e1517 = phi_2194_;
                                if (_e1462 > _e1470) {
                                    phi_2199_ = _e1462;
                                } else {
                                    phi_2199_ = _e1470;
                                }
                                let _e1520 = phi_2199_;
                                if (_e1517 > _e1520) {
                                    phi_2204_ = _e1517;
                                } else {
                                    phi_2204_ = _e1520;
                                }
                                let _e1523 = phi_2204_;
                                if (_e1475 > _e1480) {
                                    phi_2209_ = _e1475;
                                } else {
                                    phi_2209_ = _e1480;
                                }
                                let _e1526 = phi_2209_;
                                if (_e1485 > _e1493) {
                                    phi_2214_ = _e1485;
                                } else {
                                    phi_2214_ = _e1493;
                                }
                                let _e1529 = phi_2214_;
                                if (_e1526 > _e1529) {
                                    phi_2219_ = _e1526;
                                } else {
                                    phi_2219_ = _e1529;
                                }
                                let _e1532 = phi_2219_;
                                if (_e1523 > _e1532) {
                                    phi_2224_ = _e1523;
                                } else {
                                    phi_2224_ = _e1532;
                                }
                                let _e1535 = phi_2224_;
                                if (_e1441 < 0f) {
                                    phi_2230_ = -(_e1441);
                                } else {
                                    phi_2230_ = _e1441;
                                }
                                let _e1539 = phi_2230_;
                                if (_e1444 < 0f) {
                                    phi_2236_ = -(_e1444);
                                } else {
                                    phi_2236_ = _e1444;
                                }
                                let _e1543 = phi_2236_;
                                if (_e1447 < 0f) {
                                    phi_2243_ = -(_e1447);
                                } else {
                                    phi_2243_ = _e1447;
                                }
                                let _e1548 = phi_2243_;
                                let _e1549 = ((_e1539 + _e1543) + _e1548);
                                let _e1554 = -(_e1535);
                                if (_e1514 > _e1554) {
                                    phi_2254_ = _e1514;
                                } else {
                                    phi_2254_ = _e1554;
                                }
                                let _e1557 = phi_2254_;
                                let _e1562 = (((_e1557 - ((_e1549 * _e1307) * (0.000000059604645f * (17f / 2f)))) - (_e1549 * _e1314)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e1438 > _e1562) {
                                    phi_2264_ = _e1438;
                                } else {
                                    phi_2264_ = _e1562;
                                }
                                let _e1565 = phi_2264_;
                                if (_e196.member == 0u) {
                                    let _e1567 = (_e1067 - _e1052);
                                    let _e1568 = (_e1068 - _e1053);
                                    let _e1569 = (_e1069 - _e1054);
                                    let _e1572 = ((_e1075 * _e1569) - (_e1078 * _e1568));
                                    let _e1575 = ((_e1078 * _e1567) - (_e1072 * _e1569));
                                    let _e1578 = ((_e1072 * _e1568) - (_e1075 * _e1567));
                                    let _e1583 = (((_e1572 * _e1081[0]) + (_e1575 * _e1081[1])) + (_e1578 * _e1081[2]));
                                    let _e1588 = (((_e1572 * _e1098) + (_e1575 * _e1099)) + (_e1578 * _e1100));
                                    let _e1593 = (((_e1572 * _e1108) + (_e1575 * _e1109)) + (_e1578 * _e1110));
                                    let _e1601 = (((_e1572 * _e1107[0]) + (_e1575 * _e1107[1])) + (_e1578 * _e1107[2]));
                                    let _e1606 = (((_e1572 * _e1113[0]) + (_e1575 * _e1113[1])) + (_e1578 * _e1113[2]));
                                    let _e1611 = (((_e1572 * _e1130) + (_e1575 * _e1131)) + (_e1578 * _e1132));
                                    let _e1616 = (((_e1572 * _e1140) + (_e1575 * _e1141)) + (_e1578 * _e1142));
                                    let _e1624 = (((_e1572 * _e1139[0]) + (_e1575 * _e1139[1])) + (_e1578 * _e1139[2]));
                                    if (_e1583 < _e1588) {
                                        phi_2337_ = _e1583;
                                    } else {
                                        phi_2337_ = _e1588;
                                    }
                                    let _e1627 = phi_2337_;
                                    if (_e1593 < _e1601) {
                                        phi_2342_ = _e1593;
                                    } else {
                                        phi_2342_ = _e1601;
                                    }
                                    let _e1630 = phi_2342_;
                                    if (_e1627 < _e1630) {
                                        phi_2347_ = _e1627;
                                    } else {
                                        phi_2347_ = _e1630;
                                    }
                                    let _e1633 = phi_2347_;
                                    if (_e1606 < _e1611) {
                                        phi_2352_ = _e1606;
                                    } else {
                                        phi_2352_ = _e1611;
                                    }
                                    let _e1636 = phi_2352_;
                                    if (_e1616 < _e1624) {
                                        phi_2357_ = _e1616;
                                    } else {
                                        phi_2357_ = _e1624;
                                    }
                                    let _e1639 = phi_2357_;
                                    if (_e1636 < _e1639) {
                                        phi_2362_ = _e1636;
                                    } else {
                                        phi_2362_ = _e1639;
                                    }
                                    let _e1642 = phi_2362_;
                                    if (_e1633 < _e1642) {
                                        phi_2367_ = _e1633;
                                    } else {
                                        phi_2367_ = _e1642;
                                    }
                                    let _e1645 = phi_2367_;
                                    if (_e1583 > _e1588) {
                                        phi_2372_ = _e1583;
                                    } else {
                                        phi_2372_ = _e1588;
                                    }
                                    let _e1648 = phi_2372_;
                                    if (_e1593 > _e1601) {
                                        phi_2377_ = _e1593;
                                    } else {
                                        phi_2377_ = _e1601;
                                    }
                                    let _e1651 = phi_2377_;
                                    if (_e1648 > _e1651) {
                                        phi_2382_ = _e1648;
                                    } else {
                                        phi_2382_ = _e1651;
                                    }
                                    let _e1654 = phi_2382_;
                                    if (_e1606 > _e1611) {
                                        phi_2387_ = _e1606;
                                    } else {
                                        phi_2387_ = _e1611;
                                    }
                                    let _e1657 = phi_2387_;
                                    if (_e1616 > _e1624) {
                                        phi_2392_ = _e1616;
                                    } else {
                                        phi_2392_ = _e1624;
                                    }
                                    let _e1660 = phi_2392_;
                                    if (_e1657 > _e1660) {
                                        phi_2397_ = _e1657;
                                    } else {
                                        phi_2397_ = _e1660;
                                    }
                                    let _e1663 = phi_2397_;
                                    if (_e1654 > _e1663) {
                                        phi_2402_ = _e1654;
                                    } else {
                                        phi_2402_ = _e1663;
                                    }
                                    let _e1666 = phi_2402_;
                                    if (_e1572 < 0f) {
                                        phi_2408_ = -(_e1572);
                                    } else {
                                        phi_2408_ = _e1572;
                                    }
                                    let _e1670 = phi_2408_;
                                    if (_e1575 < 0f) {
                                        phi_2414_ = -(_e1575);
                                    } else {
                                        phi_2414_ = _e1575;
                                    }
                                    let _e1674 = phi_2414_;
                                    if (_e1578 < 0f) {
                                        phi_2421_ = -(_e1578);
                                    } else {
                                        phi_2421_ = _e1578;
                                    }
                                    let _e1679 = phi_2421_;
                                    let _e1680 = ((_e1670 + _e1674) + _e1679);
                                    let _e1685 = -(_e1666);
                                    if (_e1645 > _e1685) {
                                        phi_2432_ = _e1645;
                                    } else {
                                        phi_2432_ = _e1685;
                                    }
                                    let _e1688 = phi_2432_;
                                    let _e1693 = (((_e1688 - ((_e1680 * _e1307) * (0.000000059604645f * (17f / 2f)))) - (_e1680 * _e1314)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e1565 > _e1693) {
                                        phi_2442_ = _e1565;
                                    } else {
                                        phi_2442_ = _e1693;
                                    }
                                    let _e1696 = phi_2442_;
                                    phi_2443_ = _e1696;
                                } else {
                                    phi_2443_ = _e1565;
                                }
                                let _e1698 = phi_2443_;
                                phi_2446_ = (_e1039 || (_e1698 > 0f));
                            }
                            let _e1702 = phi_2446_;
                            if _e1702 {
                            } else {
                                let _e1704 = atomicAdd((&counters[0u]), 1u);
                                left[_e1704].member = _e165;
                                left[_e1704].member_1 = _e168;
                            }
                        }
                        phi_2455_ = true;
                    }
                    let _e1709 = phi_2455_;
                    phi_2456_ = _e1709;
                } else {
                    phi_2456_ = false;
                }
                let _e1711 = phi_2456_;
                continue;
                continuing {
                    phi_281_ = _e147;
                    break if !(_e1711);
                }
            }
            workgroupBarrier();
            let _e1714 = atomicLoad((&counters[0u]));
            phi_2461_ = type_9(0u, 4u);
            loop {
                let _e1716 = phi_2461_;
                if (_e1716.member < _e1716.member_1) {
                    phi_2462_ = type_9((_e1716.member + 1u), _e1716.member_1);
                    phi_2485_ = type_9(1u, _e1716.member);
                } else {
                    phi_2462_ = _e1716;
                    phi_2485_ = type_9(0u, type_9().member_1);
                }
                let _e1728 = phi_2462_;
                let _e1730 = phi_2485_;
                if (bitcast<i32>(_e1730.member) != 0i) {
                    let _e1736 = ((_e1730.member_1 * 128u) + _e45);
                    if (_e1736 >= _e1714) {
                        phi_6073_ = false;
                    } else {
                        let _e1740 = left[_e1736].member;
                        let _e1742 = left[_e1736].member_1;
                        if (_e63 == 0u) {
                            let _e1758 = (3u * _e1742);
                            let _e1760 = elements.member[_e1758];
                            let _e1763 = elements.member[(_e1758 + 1u)];
                            let _e1766 = elements.member[(_e1758 + 2u)];
                            phi_2589_ = type_18(0u, array<u32, 4>(_e1740, _e1760, _e1763, _e1766));
                        } else {
                            let _e1744 = (2u * _e1740);
                            let _e1745 = (2u * _e1742);
                            let _e1747 = elements.member[_e1744];
                            let _e1749 = elements.member[_e1745];
                            let _e1752 = elements.member[(_e1744 + 1u)];
                            let _e1755 = elements.member[(_e1745 + 1u)];
                            phi_2589_ = type_18(1u, array<u32, 4>(_e1747, _e1752, _e1749, _e1755));
                        }
                        let _e1770 = phi_2589_;
                        let _e1775 = paths.member[_e1770.member_1[0]];
                        let _e1790 = paths.member[_e1770.member_1[1]];
                        let _e1805 = paths.member[_e1770.member_1[2]];
                        let _e1820 = paths.member[_e1770.member_1[3]];
                        if (_e1770.member != 0u) {
                            phi_2722_ = type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e1805.member.x - _e1775.member.x), (_e1805.member.y - _e1775.member.y), (_e1805.member.z - _e1775.member.z)), array<f32, 3>((_e1805.member_1.x - _e1775.member_1.x), (_e1805.member_1.y - _e1775.member_1.y), (_e1805.member_1.z - _e1775.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1790.member.x - _e1775.member.x), (_e1790.member.y - _e1775.member.y), (_e1790.member.z - _e1775.member.z)), array<f32, 3>((_e1790.member_1.x - _e1775.member_1.x), (_e1790.member_1.y - _e1775.member_1.y), (_e1790.member_1.z - _e1775.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1805.member.x - _e1820.member.x), (_e1805.member.y - _e1820.member.y), (_e1805.member.z - _e1820.member.z)), array<f32, 3>((_e1805.member_1.x - _e1820.member_1.x), (_e1805.member_1.y - _e1820.member_1.y), (_e1805.member_1.z - _e1820.member_1.z))), (_e60.member_4 + _e60.member_4));
                        } else {
                            phi_2722_ = type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e1775.member.x - _e1790.member.x), (_e1775.member.y - _e1790.member.y), (_e1775.member.z - _e1790.member.z)), array<f32, 3>((_e1775.member_1.x - _e1790.member_1.x), (_e1775.member_1.y - _e1790.member_1.y), (_e1775.member_1.z - _e1790.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1805.member.x - _e1790.member.x), (_e1805.member.y - _e1790.member.y), (_e1805.member.z - _e1790.member.z)), array<f32, 3>((_e1805.member_1.x - _e1790.member_1.x), (_e1805.member_1.y - _e1790.member_1.y), (_e1805.member_1.z - _e1790.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1820.member.x - _e1790.member.x), (_e1820.member.y - _e1790.member.y), (_e1820.member.z - _e1790.member.z)), array<f32, 3>((_e1820.member_1.x - _e1790.member_1.x), (_e1820.member_1.y - _e1790.member_1.y), (_e1820.member_1.z - _e1790.member_1.z))), (_e60.member_4 + _e60.member_4));
                        }
                        let _e1893 = phi_2722_;
                        let _e1907 = ((_e1893.member[0][0] + _e1893.member[1][0]) * 0.5f);
                        let _e1908 = ((_e1893.member[0][1] + _e1893.member[1][1]) * 0.5f);
                        let _e1909 = ((_e1893.member[0][2] + _e1893.member[1][2]) * 0.5f);
                        let _e1923 = ((_e1893.member_1[0][0] + _e1893.member_1[1][0]) * 0.5f);
                        let _e1924 = ((_e1893.member_1[0][1] + _e1893.member_1[1][1]) * 0.5f);
                        let _e1925 = ((_e1893.member_1[0][2] + _e1893.member_1[1][2]) * 0.5f);
                        let _e1939 = ((_e1893.member_2[0][0] + _e1893.member_2[1][0]) * 0.5f);
                        let _e1940 = ((_e1893.member_2[0][1] + _e1893.member_2[1][1]) * 0.5f);
                        let _e1941 = ((_e1893.member_2[0][2] + _e1893.member_2[1][2]) * 0.5f);
                        local = type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e1893.member[0][0], _e1893.member[0][1], _e1893.member[0][2]), array<f32, 3>(_e1907, _e1908, _e1909)), array<array<f32, 3>, 2>(array<f32, 3>(_e1893.member_1[0][0], _e1893.member_1[0][1], _e1893.member_1[0][2]), array<f32, 3>(_e1923, _e1924, _e1925)), array<array<f32, 3>, 2>(array<f32, 3>(_e1893.member_2[0][0], _e1893.member_2[0][1], _e1893.member_2[0][2]), array<f32, 3>(_e1939, _e1940, _e1941)), _e1893.member_3);
                        local_1 = type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e1907, _e1908, _e1909), array<f32, 3>(_e1893.member[1][0], _e1893.member[1][1], _e1893.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e1923, _e1924, _e1925), array<f32, 3>(_e1893.member_1[1][0], _e1893.member_1[1][1], _e1893.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e1939, _e1940, _e1941), array<f32, 3>(_e1893.member_2[1][0], _e1893.member_2[1][1], _e1893.member_2[1][2])), _e1893.member_3);
                        let _e1996 = local.member_1[0u];
                        let _e2002 = local.member_2[0u];
                        let _e2008 = ((_e1996[1] * _e2002[2]) - (_e1996[2] * _e2002[1]));
                        let _e2011 = ((_e1996[2] * _e2002[0]) - (_e1996[0] * _e2002[2]));
                        let _e2014 = ((_e1996[0] * _e2002[1]) - (_e1996[1] * _e2002[0]));
                        let _e2017 = local.member_1[1u];
                        let _e2023 = local.member_2[1u];
                        let _e2029 = ((_e2017[1] * _e2023[2]) - (_e2017[2] * _e2023[1]));
                        let _e2032 = ((_e2017[2] * _e2023[0]) - (_e2017[0] * _e2023[2]));
                        let _e2035 = ((_e2017[0] * _e2023[1]) - (_e2017[1] * _e2023[0]));
                        let _e2038 = local.member_1[0u];
                        let _e2044 = local.member_2[1u];
                        let _e2059 = local.member_1[1u];
                        let _e2065 = local.member_2[0u];
                        let _e2078 = (((_e2038[1] * _e2044[2]) - (_e2038[2] * _e2044[1])) + ((_e2059[1] * _e2065[2]) - (_e2059[2] * _e2065[1])));
                        let _e2079 = (((_e2038[2] * _e2044[0]) - (_e2038[0] * _e2044[2])) + ((_e2059[2] * _e2065[0]) - (_e2059[0] * _e2065[2])));
                        let _e2080 = (((_e2038[0] * _e2044[1]) - (_e2038[1] * _e2044[0])) + ((_e2059[0] * _e2065[1]) - (_e2059[1] * _e2065[0])));
                        let _e2083 = local.member[0u];
                        let _e2094 = local.member[1u];
                        let _e2105 = local.member[0u];
                        let _e2114 = ((((_e2094[0] * _e2008) + (_e2094[1] * _e2011)) + (_e2094[2] * _e2014)) + (((_e2105[0] * _e2078) + (_e2105[1] * _e2079)) + (_e2105[2] * _e2080)));
                        let _e2117 = local.member[0u];
                        let _e2128 = local.member[1u];
                        let _e2137 = ((((_e2117[0] * _e2029) + (_e2117[1] * _e2032)) + (_e2117[2] * _e2035)) + (((_e2128[0] * _e2078) + (_e2128[1] * _e2079)) + (_e2128[2] * _e2080)));
                        let _e2140 = local.member[1u];
                        let _e2151 = local.member[0u];
                        if (_e2151[0] < 0f) {
                            phi_3101_ = -(_e2151[0]);
                        } else {
                            phi_3101_ = _e2151[0];
                        }
                        let _e2158 = phi_3101_;
                        if (_e2151[1] < 0f) {
                            phi_3108_ = -(_e2151[1]);
                        } else {
                            phi_3108_ = _e2151[1];
                        }
                        let _e2162 = phi_3108_;
                        if (_e2158 > _e2162) {
                            phi_3113_ = _e2158;
                        } else {
                            phi_3113_ = _e2162;
                        }
                        let _e2165 = phi_3113_;
                        if (_e2151[2] < 0f) {
                            phi_3120_ = -(_e2151[2]);
                        } else {
                            phi_3120_ = _e2151[2];
                        }
                        let _e2169 = phi_3120_;
                        if (_e2165 > _e2169) {
                            phi_3125_ = _e2165;
                        } else {
                            phi_3125_ = _e2169;
                        }
                        let _e2172 = phi_3125_;
                        let _e2175 = local.member[1u];
                        if (_e2175[0] < 0f) {
                            phi_3138_ = -(_e2175[0]);
                        } else {
                            phi_3138_ = _e2175[0];
                        }
                        let _e2182 = phi_3138_;
                        if (_e2175[1] < 0f) {
                            phi_3145_ = -(_e2175[1]);
                        } else {
                            phi_3145_ = _e2175[1];
                        }
                        let _e2186 = phi_3145_;
                        if (_e2182 > _e2186) {
                            phi_3150_ = _e2182;
                        } else {
                            phi_3150_ = _e2186;
                        }
                        let _e2189 = phi_3150_;
                        if (_e2175[2] < 0f) {
                            phi_3157_ = -(_e2175[2]);
                        } else {
                            phi_3157_ = _e2175[2];
                        }
                        let _e2193 = phi_3157_;
                        if (_e2189 > _e2193) {
                            phi_3162_ = _e2189;
                        } else {
                            phi_3162_ = _e2193;
                        }
                        let _e2196 = phi_3162_;
                        if (_e2172 > _e2196) {
                            phi_3167_ = _e2172;
                        } else {
                            phi_3167_ = _e2196;
                        }
                        let _e2199 = phi_3167_;
                        let _e2201 = local.member_3;
                        let _e2202 = (_e2199 + _e2201);
                        let _e2205 = local.member_1[0u];
                        if (_e2205[0] < 0f) {
                            phi_3184_ = -(_e2205[0]);
                        } else {
                            phi_3184_ = _e2205[0];
                        }
                        let _e2212 = phi_3184_;
                        if (_e2205[1] < 0f) {
                            phi_3191_ = -(_e2205[1]);
                        } else {
                            phi_3191_ = _e2205[1];
                        }
                        let _e2216 = phi_3191_;
                        if (_e2212 > _e2216) {
                            phi_3196_ = _e2212;
                        } else {
                            phi_3196_ = _e2216;
                        }
                        let _e2219 = phi_3196_;
                        if (_e2205[2] < 0f) {
                            phi_3203_ = -(_e2205[2]);
                        } else {
                            phi_3203_ = _e2205[2];
                        }
                        let _e2223 = phi_3203_;
                        if (_e2219 > _e2223) {
                            phi_3208_ = _e2219;
                        } else {
                            phi_3208_ = _e2223;
                        }
                        let _e2226 = phi_3208_;
                        let _e2229 = local.member_1[1u];
                        if (_e2229[0] < 0f) {
                            phi_3222_ = -(_e2229[0]);
                        } else {
                            phi_3222_ = _e2229[0];
                        }
                        let _e2236 = phi_3222_;
                        if (_e2229[1] < 0f) {
                            phi_3229_ = -(_e2229[1]);
                        } else {
                            phi_3229_ = _e2229[1];
                        }
                        let _e2240 = phi_3229_;
                        if (_e2236 > _e2240) {
                            phi_3234_ = _e2236;
                        } else {
                            phi_3234_ = _e2240;
                        }
                        let _e2243 = phi_3234_;
                        if (_e2229[2] < 0f) {
                            phi_3241_ = -(_e2229[2]);
                        } else {
                            phi_3241_ = _e2229[2];
                        }
                        let _e2247 = phi_3241_;
                        if (_e2243 > _e2247) {
                            phi_3246_ = _e2243;
                        } else {
                            phi_3246_ = _e2247;
                        }
                        let _e2250 = phi_3246_;
                        if (_e2226 > _e2250) {
                            phi_3251_ = _e2226;
                        } else {
                            phi_3251_ = _e2250;
                        }
                        let _e2253 = phi_3251_;
                        let _e2255 = local.member_3;
                        let _e2256 = (_e2253 + _e2255);
                        let _e2259 = local.member_2[0u];
                        if (_e2259[0] < 0f) {
                            phi_3268_ = -(_e2259[0]);
                        } else {
                            phi_3268_ = _e2259[0];
                        }
                        let _e2266 = phi_3268_;
                        if (_e2259[1] < 0f) {
                            phi_3275_ = -(_e2259[1]);
                        } else {
                            phi_3275_ = _e2259[1];
                        }
                        let _e2270 = phi_3275_;
                        if (_e2266 > _e2270) {
                            phi_3280_ = _e2266;
                        } else {
                            phi_3280_ = _e2270;
                        }
                        let _e2273 = phi_3280_;
                        if (_e2259[2] < 0f) {
                            phi_3287_ = -(_e2259[2]);
                        } else {
                            phi_3287_ = _e2259[2];
                        }
                        let _e2277 = phi_3287_;
                        if (_e2273 > _e2277) {
                            phi_3292_ = _e2273;
                        } else {
                            phi_3292_ = _e2277;
                        }
                        let _e2280 = phi_3292_;
                        let _e2283 = local.member_2[1u];
                        if (_e2283[0] < 0f) {
                            phi_3306_ = -(_e2283[0]);
                        } else {
                            phi_3306_ = _e2283[0];
                        }
                        let _e2290 = phi_3306_;
                        if (_e2283[1] < 0f) {
                            phi_3313_ = -(_e2283[1]);
                        } else {
                            phi_3313_ = _e2283[1];
                        }
                        let _e2294 = phi_3313_;
                        if (_e2290 > _e2294) {
                            phi_3318_ = _e2290;
                        } else {
                            phi_3318_ = _e2294;
                        }
                        let _e2297 = phi_3318_;
                        if (_e2283[2] < 0f) {
                            phi_3325_ = -(_e2283[2]);
                        } else {
                            phi_3325_ = _e2283[2];
                        }
                        let _e2301 = phi_3325_;
                        if (_e2297 > _e2301) {
                            phi_3330_ = _e2297;
                        } else {
                            phi_3330_ = _e2301;
                        }
                        let _e2304 = phi_3330_;
                        if (_e2280 > _e2304) {
                            phi_3335_ = _e2280;
                        } else {
                            phi_3335_ = _e2304;
                        }
                        let _e2307 = phi_3335_;
                        let _e2309 = local.member_3;
                        let _e2310 = (_e2307 + _e2309);
                        let _e2312 = ((_e2256 * 8f) * _e2310);
                        let _e2319 = local.member_3;
                        if (_e2008 < 0f) {
                            phi_3366_ = -(_e2008);
                        } else {
                            phi_3366_ = _e2008;
                        }
                        let _e2336 = phi_3366_;
                        if (_e2011 < 0f) {
                            phi_3372_ = -(_e2011);
                        } else {
                            phi_3372_ = _e2011;
                        }
                        let _e2340 = phi_3372_;
                        if (_e2014 < 0f) {
                            phi_3379_ = -(_e2014);
                        } else {
                            phi_3379_ = _e2014;
                        }
                        let _e2345 = phi_3379_;
                        let _e2346 = ((_e2336 + _e2340) + _e2345);
                        if (_e2029 < 0f) {
                            phi_3386_ = -(_e2029);
                        } else {
                            phi_3386_ = _e2029;
                        }
                        let _e2350 = phi_3386_;
                        if (_e2032 < 0f) {
                            phi_3392_ = -(_e2032);
                        } else {
                            phi_3392_ = _e2032;
                        }
                        let _e2354 = phi_3392_;
                        if (_e2035 < 0f) {
                            phi_3399_ = -(_e2035);
                        } else {
                            phi_3399_ = _e2035;
                        }
                        let _e2359 = phi_3399_;
                        let _e2360 = ((_e2350 + _e2354) + _e2359);
                        if (_e2346 > _e2360) {
                            phi_3405_ = _e2346;
                        } else {
                            phi_3405_ = _e2360;
                        }
                        let _e2363 = phi_3405_;
                        if (_e2078 < 0f) {
                            phi_3411_ = -(_e2078);
                        } else {
                            phi_3411_ = _e2078;
                        }
                        let _e2367 = phi_3411_;
                        if (_e2079 < 0f) {
                            phi_3417_ = -(_e2079);
                        } else {
                            phi_3417_ = _e2079;
                        }
                        let _e2371 = phi_3417_;
                        if (_e2080 < 0f) {
                            phi_3424_ = -(_e2080);
                        } else {
                            phi_3424_ = _e2080;
                        }
                        let _e2376 = phi_3424_;
                        let _e2378 = (((_e2367 + _e2371) + _e2376) * 0.5f);
                        if (_e2363 > _e2378) {
                            phi_3431_ = _e2363;
                        } else {
                            phi_3431_ = _e2378;
                        }
                        let _e2381 = phi_3431_;
                        let _e2386 = local.member_3;
                        let _e2399 = ((((_e2083[0] * _e2008) + (_e2083[1] * _e2011)) + (_e2083[2] * _e2014)) * 3f);
                        let _e2400 = ((((_e2140[0] * _e2029) + (_e2140[1] * _e2032)) + (_e2140[2] * _e2035)) * 3f);
                        if (_e2399 < _e2400) {
                            phi_3455_ = _e2399;
                        } else {
                            phi_3455_ = _e2400;
                        }
                        let _e2403 = phi_3455_;
                        if (_e2114 < _e2137) {
                            phi_3460_ = _e2114;
                        } else {
                            phi_3460_ = _e2137;
                        }
                        let _e2406 = phi_3460_;
                        if (_e2403 < _e2406) {
                            phi_3465_ = _e2403;
                        } else {
                            phi_3465_ = _e2406;
                        }
                        let _e2409 = phi_3465_;
                        if (_e2399 > _e2400) {
                            phi_3470_ = _e2399;
                        } else {
                            phi_3470_ = _e2400;
                        }
                        let _e2412 = phi_3470_;
                        if (_e2114 > _e2137) {
                            phi_3475_ = _e2114;
                        } else {
                            phi_3475_ = _e2137;
                        }
                        let _e2415 = phi_3475_;
                        if (_e2412 > _e2415) {
                            phi_3480_ = _e2412;
                        } else {
                            phi_3480_ = _e2415;
                        }
                        let _e2418 = phi_3480_;
                        let _e2423 = -(_e2418);
                        if (_e2409 > _e2423) {
                            phi_3490_ = _e2409;
                        } else {
                            phi_3490_ = _e2423;
                        }
                        let _e2426 = phi_3490_;
                        let _e2428 = ((_e2426 - ((((((_e2202 * 8f) * _e2312) * (0.000000059604645f * (524f / 64f))) + ((_e2319 * 19f) * ((_e2202 * (_e2256 + _e2310)) + (_e2256 * _e2310)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2202) * ((1f + _e2256) * (1f + _e2310))))) + ((_e60.member_5 * (((_e2381 + (_e2312 * (0.000000059604645f * 8f))) + ((_e2386 * 6f) * (_e2256 + _e2310))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2256) * (1f + _e2310))))) * (3f * 1.0001f)))) > 0f);
                        if _e2428 {
                            phi_4459_ = _e2428;
                        } else {
                            let _e2431 = local.member_1[0u];
                            let _e2437 = local.member_1[1u];
                            let _e2441 = (_e2431[0] + _e2437[0]);
                            let _e2442 = (_e2431[1] + _e2437[1]);
                            let _e2443 = (_e2431[2] + _e2437[2]);
                            let _e2446 = local.member_2[0u];
                            let _e2452 = local.member_2[1u];
                            let _e2456 = (_e2446[0] + _e2452[0]);
                            let _e2457 = (_e2446[1] + _e2452[1]);
                            let _e2458 = (_e2446[2] + _e2452[2]);
                            let _e2461 = ((_e2442 * _e2458) - (_e2443 * _e2457));
                            let _e2464 = ((_e2443 * _e2456) - (_e2441 * _e2458));
                            let _e2467 = ((_e2441 * _e2457) - (_e2442 * _e2456));
                            let _e2470 = local.member[0u];
                            let _e2477 = local.member_1[0u];
                            let _e2483 = local.member_2[0u];
                            let _e2487 = (_e2470[0] - _e2477[0]);
                            let _e2488 = (_e2470[1] - _e2477[1]);
                            let _e2489 = (_e2470[2] - _e2477[2]);
                            if (_e1770.member == 0u) {
                                phi_3606_ = array<f32, 3>(_e2470[0], _e2470[1], _e2470[2]);
                            } else {
                                phi_3606_ = array<f32, 3>((_e2487 - _e2483[0]), (_e2488 - _e2483[1]), (_e2489 - _e2483[2]));
                            }
                            let _e2496 = phi_3606_;
                            let _e2497 = (_e2470[0] - _e2483[0]);
                            let _e2498 = (_e2470[1] - _e2483[1]);
                            let _e2499 = (_e2470[2] - _e2483[2]);
                            let _e2502 = local.member[1u];
                            let _e2509 = local.member_1[1u];
                            let _e2515 = local.member_2[1u];
                            let _e2519 = (_e2502[0] - _e2509[0]);
                            let _e2520 = (_e2502[1] - _e2509[1]);
                            let _e2521 = (_e2502[2] - _e2509[2]);
                            if (_e1770.member == 0u) {
                                phi_3671_ = array<f32, 3>(_e2502[0], _e2502[1], _e2502[2]);
                            } else {
                                phi_3671_ = array<f32, 3>((_e2519 - _e2515[0]), (_e2520 - _e2515[1]), (_e2521 - _e2515[2]));
                            }
                            let _e2528 = phi_3671_;
                            let _e2529 = (_e2502[0] - _e2515[0]);
                            let _e2530 = (_e2502[1] - _e2515[1]);
                            let _e2531 = (_e2502[2] - _e2515[2]);
                            let _e2534 = local.member[0u];
                            if (_e2534[0] < 0f) {
                                phi_3693_ = -(_e2534[0]);
                            } else {
                                phi_3693_ = _e2534[0];
                            }
                            let _e2541 = phi_3693_;
                            if (_e2534[1] < 0f) {
                                phi_3700_ = -(_e2534[1]);
                            } else {
                                phi_3700_ = _e2534[1];
                            }
                            let _e2545 = phi_3700_;
                            if (_e2541 > _e2545) {
                                phi_3705_ = _e2541;
                            } else {
                                phi_3705_ = _e2545;
                            }
                            let _e2548 = phi_3705_;
                            if (_e2534[2] < 0f) {
                                phi_3712_ = -(_e2534[2]);
                            } else {
                                phi_3712_ = _e2534[2];
                            }
                            let _e2552 = phi_3712_;
                            if (_e2548 > _e2552) {
                                phi_3717_ = _e2548;
                            } else {
                                phi_3717_ = _e2552;
                            }
                            let _e2555 = phi_3717_;
                            let _e2558 = local.member[1u];
                            if (_e2558[0] < 0f) {
                                phi_3730_ = -(_e2558[0]);
                            } else {
                                phi_3730_ = _e2558[0];
                            }
                            let _e2565 = phi_3730_;
                            if (_e2558[1] < 0f) {
                                phi_3737_ = -(_e2558[1]);
                            } else {
                                phi_3737_ = _e2558[1];
                            }
                            let _e2569 = phi_3737_;
                            if (_e2565 > _e2569) {
                                phi_3742_ = _e2565;
                            } else {
                                phi_3742_ = _e2569;
                            }
                            let _e2572 = phi_3742_;
                            if (_e2558[2] < 0f) {
                                phi_3749_ = -(_e2558[2]);
                            } else {
                                phi_3749_ = _e2558[2];
                            }
                            let _e2576 = phi_3749_;
                            if (_e2572 > _e2576) {
                                phi_3754_ = _e2572;
                            } else {
                                phi_3754_ = _e2576;
                            }
                            let _e2579 = phi_3754_;
                            if (_e2555 > _e2579) {
                                phi_3759_ = _e2555;
                            } else {
                                phi_3759_ = _e2579;
                            }
                            let _e2582 = phi_3759_;
                            let _e2584 = local.member_3;
                            let _e2588 = local.member_1[0u];
                            if (_e2588[0] < 0f) {
                                phi_3776_ = -(_e2588[0]);
                            } else {
                                phi_3776_ = _e2588[0];
                            }
                            let _e2595 = phi_3776_;
                            if (_e2588[1] < 0f) {
                                phi_3783_ = -(_e2588[1]);
                            } else {
                                phi_3783_ = _e2588[1];
                            }
                            let _e2599 = phi_3783_;
                            if (_e2595 > _e2599) {
                                phi_3788_ = _e2595;
                            } else {
                                phi_3788_ = _e2599;
                            }
                            let _e2602 = phi_3788_;
                            if (_e2588[2] < 0f) {
                                phi_3795_ = -(_e2588[2]);
                            } else {
                                phi_3795_ = _e2588[2];
                            }
                            let _e2606 = phi_3795_;
                            if (_e2602 > _e2606) {
                                phi_3800_ = _e2602;
                            } else {
                                phi_3800_ = _e2606;
                            }
                            let _e2609 = phi_3800_;
                            let _e2612 = local.member_1[1u];
                            if (_e2612[0] < 0f) {
                                phi_3814_ = -(_e2612[0]);
                            } else {
                                phi_3814_ = _e2612[0];
                            }
                            let _e2619 = phi_3814_;
                            if (_e2612[1] < 0f) {
                                phi_3821_ = -(_e2612[1]);
                            } else {
                                phi_3821_ = _e2612[1];
                            }
                            let _e2623 = phi_3821_;
                            if (_e2619 > _e2623) {
                                phi_3826_ = _e2619;
                            } else {
                                phi_3826_ = _e2623;
                            }
                            let _e2626 = phi_3826_;
                            if (_e2612[2] < 0f) {
                                phi_3833_ = -(_e2612[2]);
                            } else {
                                phi_3833_ = _e2612[2];
                            }
                            let _e2630 = phi_3833_;
                            if (_e2626 > _e2630) {
                                phi_3838_ = _e2626;
                            } else {
                                phi_3838_ = _e2630;
                            }
                            let _e2633 = phi_3838_;
                            if (_e2609 > _e2633) {
                                phi_3843_ = _e2609;
                            } else {
                                phi_3843_ = _e2633;
                            }
                            let _e2636 = phi_3843_;
                            let _e2638 = local.member_3;
                            let _e2642 = local.member_2[0u];
                            if (_e2642[0] < 0f) {
                                phi_3860_ = -(_e2642[0]);
                            } else {
                                phi_3860_ = _e2642[0];
                            }
                            let _e2649 = phi_3860_;
                            if (_e2642[1] < 0f) {
                                phi_3867_ = -(_e2642[1]);
                            } else {
                                phi_3867_ = _e2642[1];
                            }
                            let _e2653 = phi_3867_;
                            if (_e2649 > _e2653) {
                                phi_3872_ = _e2649;
                            } else {
                                phi_3872_ = _e2653;
                            }
                            let _e2656 = phi_3872_;
                            if (_e2642[2] < 0f) {
                                phi_3879_ = -(_e2642[2]);
                            } else {
                                phi_3879_ = _e2642[2];
                            }
                            let _e2660 = phi_3879_;
                            if (_e2656 > _e2660) {
                                phi_3884_ = _e2656;
                            } else {
                                phi_3884_ = _e2660;
                            }
                            let _e2663 = phi_3884_;
                            let _e2666 = local.member_2[1u];
                            if (_e2666[0] < 0f) {
                                phi_3898_ = -(_e2666[0]);
                            } else {
                                phi_3898_ = _e2666[0];
                            }
                            let _e2673 = phi_3898_;
                            if (_e2666[1] < 0f) {
                                phi_3905_ = -(_e2666[1]);
                            } else {
                                phi_3905_ = _e2666[1];
                            }
                            let _e2677 = phi_3905_;
                            if (_e2673 > _e2677) {
                                phi_3910_ = _e2673;
                            } else {
                                phi_3910_ = _e2677;
                            }
                            let _e2680 = phi_3910_;
                            if (_e2666[2] < 0f) {
                                phi_3917_ = -(_e2666[2]);
                            } else {
                                phi_3917_ = _e2666[2];
                            }
                            let _e2684 = phi_3917_;
                            if (_e2680 > _e2684) {
                                phi_3922_ = _e2680;
                            } else {
                                phi_3922_ = _e2684;
                            }
                            let _e2687 = phi_3922_;
                            if (_e2663 > _e2687) {
                                phi_3927_ = _e2663;
                            } else {
                                phi_3927_ = _e2687;
                            }
                            let _e2690 = phi_3927_;
                            let _e2692 = local.member_3;
                            let _e2696 = ((((_e2582 + _e2584) + (_e2636 + _e2638)) + (_e2690 + _e2692)) * 2f);
                            let _e2699 = local.member_3;
                            let _e2703 = (((_e60.member_5 * 1.0001f) + (_e2699 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e2706 = ((_e2464 * _e2443) - (_e2467 * _e2442));
                            let _e2709 = ((_e2467 * _e2441) - (_e2461 * _e2443));
                            let _e2712 = ((_e2461 * _e2442) - (_e2464 * _e2441));
                            let _e2717 = (((_e2706 * _e2470[0]) + (_e2709 * _e2470[1])) + (_e2712 * _e2470[2]));
                            let _e2722 = (((_e2706 * _e2487) + (_e2709 * _e2488)) + (_e2712 * _e2489));
                            let _e2727 = (((_e2706 * _e2497) + (_e2709 * _e2498)) + (_e2712 * _e2499));
                            let _e2735 = (((_e2706 * _e2496[0]) + (_e2709 * _e2496[1])) + (_e2712 * _e2496[2]));
                            let _e2740 = (((_e2706 * _e2502[0]) + (_e2709 * _e2502[1])) + (_e2712 * _e2502[2]));
                            let _e2745 = (((_e2706 * _e2519) + (_e2709 * _e2520)) + (_e2712 * _e2521));
                            let _e2750 = (((_e2706 * _e2529) + (_e2709 * _e2530)) + (_e2712 * _e2531));
                            let _e2758 = (((_e2706 * _e2528[0]) + (_e2709 * _e2528[1])) + (_e2712 * _e2528[2]));
                            if (_e2717 < _e2722) {
                                phi_4006_ = _e2717;
                            } else {
                                phi_4006_ = _e2722;
                            }
                            let _e2761 = phi_4006_;
                            if (_e2727 < _e2735) {
                                phi_4011_ = _e2727;
                            } else {
                                phi_4011_ = _e2735;
                            }
                            let _e2764 = phi_4011_;
                            if (_e2761 < _e2764) {
                                phi_4016_ = _e2761;
                            } else {
                                phi_4016_ = _e2764;
                            }
                            let _e2767 = phi_4016_;
                            if (_e2740 < _e2745) {
                                phi_4021_ = _e2740;
                            } else {
                                phi_4021_ = _e2745;
                            }
                            let _e2770 = phi_4021_;
                            if (_e2750 < _e2758) {
                                phi_4026_ = _e2750;
                            } else {
                                phi_4026_ = _e2758;
                            }
                            let _e2773 = phi_4026_;
                            if (_e2770 < _e2773) {
                                phi_4031_ = _e2770;
                            } else {
                                phi_4031_ = _e2773;
                            }
                            let _e2776 = phi_4031_;
                            if (_e2767 < _e2776) {
                                phi_4036_ = _e2767;
                            } else {
                                phi_4036_ = _e2776;
                            }
                            let _e2779 = phi_4036_;
                            if (_e2717 > _e2722) {
                                phi_4041_ = _e2717;
                            } else {
                                phi_4041_ = _e2722;
                            }
                            let _e2782 = phi_4041_;
                            if (_e2727 > _e2735) {
                                phi_4046_ = _e2727;
                            } else {
                                phi_4046_ = _e2735;
                            }
                            let _e2785 = phi_4046_;
                            if (_e2782 > _e2785) {
                                phi_4051_ = _e2782;
                            } else {
                                phi_4051_ = _e2785;
                            }
                            let _e2788 = phi_4051_;
                            if (_e2740 > _e2745) {
                                phi_4056_ = _e2740;
                            } else {
                                phi_4056_ = _e2745;
                            }
                            let _e2791 = phi_4056_;
                            if (_e2750 > _e2758) {
                                phi_4061_ = _e2750;
                            } else {
                                phi_4061_ = _e2758;
                            }
                            let _e2794 = phi_4061_;
                            if (_e2791 > _e2794) {
                                phi_4066_ = _e2791;
                            } else {
                                phi_4066_ = _e2794;
                            }
                            let _e2797 = phi_4066_;
                            if (_e2788 > _e2797) {
                                phi_4071_ = _e2788;
                            } else {
                                phi_4071_ = _e2797;
                            }
                            let _e2800 = phi_4071_;
                            if (_e2706 < 0f) {
                                phi_4077_ = -(_e2706);
                            } else {
                                phi_4077_ = _e2706;
                            }
                            let _e2804 = phi_4077_;
                            if (_e2709 < 0f) {
                                phi_4083_ = -(_e2709);
                            } else {
                                phi_4083_ = _e2709;
                            }
                            let _e2808 = phi_4083_;
                            if (_e2712 < 0f) {
                                phi_4090_ = -(_e2712);
                            } else {
                                phi_4090_ = _e2712;
                            }
                            let _e2813 = phi_4090_;
                            let _e2814 = ((_e2804 + _e2808) + _e2813);
                            let _e2819 = -(_e2800);
                            if (_e2779 > _e2819) {
                                phi_4101_ = _e2779;
                            } else {
                                phi_4101_ = _e2819;
                            }
                            let _e2822 = phi_4101_;
                            let _e2827 = (((_e2822 - ((_e2814 * _e2696) * (0.000000059604645f * (17f / 2f)))) - (_e2814 * _e2703)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            let _e2830 = ((_e2464 * _e2458) - (_e2467 * _e2457));
                            let _e2833 = ((_e2467 * _e2456) - (_e2461 * _e2458));
                            let _e2836 = ((_e2461 * _e2457) - (_e2464 * _e2456));
                            let _e2841 = (((_e2830 * _e2470[0]) + (_e2833 * _e2470[1])) + (_e2836 * _e2470[2]));
                            let _e2846 = (((_e2830 * _e2487) + (_e2833 * _e2488)) + (_e2836 * _e2489));
                            let _e2851 = (((_e2830 * _e2497) + (_e2833 * _e2498)) + (_e2836 * _e2499));
                            let _e2859 = (((_e2830 * _e2496[0]) + (_e2833 * _e2496[1])) + (_e2836 * _e2496[2]));
                            let _e2864 = (((_e2830 * _e2502[0]) + (_e2833 * _e2502[1])) + (_e2836 * _e2502[2]));
                            let _e2869 = (((_e2830 * _e2519) + (_e2833 * _e2520)) + (_e2836 * _e2521));
                            let _e2874 = (((_e2830 * _e2529) + (_e2833 * _e2530)) + (_e2836 * _e2531));
                            let _e2882 = (((_e2830 * _e2528[0]) + (_e2833 * _e2528[1])) + (_e2836 * _e2528[2]));
                            if (_e2841 < _e2846) {
                                phi_4172_ = _e2841;
                            } else {
                                phi_4172_ = _e2846;
                            }
                            let _e2885 = phi_4172_;
                            if (_e2851 < _e2859) {
                                phi_4177_ = _e2851;
                            } else {
                                phi_4177_ = _e2859;
                            }
                            let _e2888 = phi_4177_;
                            if (_e2885 < _e2888) {
                                phi_4182_ = _e2885;
                            } else {
                                phi_4182_ = _e2888;
                            }
                            let _e2891 = phi_4182_;
                            if (_e2864 < _e2869) {
                                phi_4187_ = _e2864;
                            } else {
                                phi_4187_ = _e2869;
                            }
                            let _e2894 = phi_4187_;
                            if (_e2874 < _e2882) {
                                phi_4192_ = _e2874;
                            } else {
                                phi_4192_ = _e2882;
                            }
                            let _e2897 = phi_4192_;
                            if (_e2894 < _e2897) {
                                phi_4197_ = _e2894;
                            } else {
                                phi_4197_ = _e2897;
                            }
                            let _e2900 = phi_4197_;
                            if (_e2891 < _e2900) {
                                phi_4202_ = _e2891;
                            } else {
                                phi_4202_ = _e2900;
                            }
                            let _e2903 = phi_4202_;
                            if (_e2841 > _e2846) {
                                phi_4207_ = _e2841;
                            } else {
                                phi_4207_ = _e2846;
                            }
                            let _e2906 = phi_4207_;
                            if (_e2851 > _e2859) {
                                phi_4212_ = _e2851;
                            } else {
                                phi_4212_ = _e2859;
                            }
                            let _e2909 = phi_4212_;
                            if (_e2906 > _e2909) {
                                phi_4217_ = _e2906;
                            } else {
                                phi_4217_ = _e2909;
                            }
                            let _e2912 = phi_4217_;
                            if (_e2864 > _e2869) {
                                phi_4222_ = _e2864;
                            } else {
                                phi_4222_ = _e2869;
                            }
                            let _e2915 = phi_4222_;
                            if (_e2874 > _e2882) {
                                phi_4227_ = _e2874;
                            } else {
                                phi_4227_ = _e2882;
                            }
                            let _e2918 = phi_4227_;
                            if (_e2915 > _e2918) {
                                phi_4232_ = _e2915;
                            } else {
                                phi_4232_ = _e2918;
                            }
                            let _e2921 = phi_4232_;
                            if (_e2912 > _e2921) {
                                phi_4237_ = _e2912;
                            } else {
                                phi_4237_ = _e2921;
                            }
                            let _e2924 = phi_4237_;
                            if (_e2830 < 0f) {
                                phi_4243_ = -(_e2830);
                            } else {
                                phi_4243_ = _e2830;
                            }
                            let _e2928 = phi_4243_;
                            if (_e2833 < 0f) {
                                phi_4249_ = -(_e2833);
                            } else {
                                phi_4249_ = _e2833;
                            }
                            let _e2932 = phi_4249_;
                            if (_e2836 < 0f) {
                                phi_4256_ = -(_e2836);
                            } else {
                                phi_4256_ = _e2836;
                            }
                            let _e2937 = phi_4256_;
                            let _e2938 = ((_e2928 + _e2932) + _e2937);
                            let _e2943 = -(_e2924);
                            if (_e2903 > _e2943) {
                                phi_4267_ = _e2903;
                            } else {
                                phi_4267_ = _e2943;
                            }
                            let _e2946 = phi_4267_;
                            let _e2951 = (((_e2946 - ((_e2938 * _e2696) * (0.000000059604645f * (17f / 2f)))) - (_e2938 * _e2703)) - (0.000000000000000000000000000000000000011754944f * 64f));
                            if (_e2827 > _e2951) {
                                phi_4277_ = _e2827;
                            } else {
                                phi_4277_ = _e2951;
                            }
                            let _e2954 = phi_4277_;
                            if (_e1770.member == 0u) {
                                let _e2956 = (_e2456 - _e2441);
                                let _e2957 = (_e2457 - _e2442);
                                let _e2958 = (_e2458 - _e2443);
                                let _e2961 = ((_e2464 * _e2958) - (_e2467 * _e2957));
                                let _e2964 = ((_e2467 * _e2956) - (_e2461 * _e2958));
                                let _e2967 = ((_e2461 * _e2957) - (_e2464 * _e2956));
                                let _e2972 = (((_e2961 * _e2470[0]) + (_e2964 * _e2470[1])) + (_e2967 * _e2470[2]));
                                let _e2977 = (((_e2961 * _e2487) + (_e2964 * _e2488)) + (_e2967 * _e2489));
                                let _e2982 = (((_e2961 * _e2497) + (_e2964 * _e2498)) + (_e2967 * _e2499));
                                let _e2990 = (((_e2961 * _e2496[0]) + (_e2964 * _e2496[1])) + (_e2967 * _e2496[2]));
                                let _e2995 = (((_e2961 * _e2502[0]) + (_e2964 * _e2502[1])) + (_e2967 * _e2502[2]));
                                let _e3000 = (((_e2961 * _e2519) + (_e2964 * _e2520)) + (_e2967 * _e2521));
                                let _e3005 = (((_e2961 * _e2529) + (_e2964 * _e2530)) + (_e2967 * _e2531));
                                let _e3013 = (((_e2961 * _e2528[0]) + (_e2964 * _e2528[1])) + (_e2967 * _e2528[2]));
                                if (_e2972 < _e2977) {
                                    phi_4350_ = _e2972;
                                } else {
                                    phi_4350_ = _e2977;
                                }
                                let _e3016 = phi_4350_;
                                if (_e2982 < _e2990) {
                                    phi_4355_ = _e2982;
                                } else {
                                    phi_4355_ = _e2990;
                                }
                                let _e3019 = phi_4355_;
                                if (_e3016 < _e3019) {
                                    phi_4360_ = _e3016;
                                } else {
                                    phi_4360_ = _e3019;
                                }
                                let _e3022 = phi_4360_;
                                if (_e2995 < _e3000) {
                                    phi_4365_ = _e2995;
                                } else {
                                    phi_4365_ = _e3000;
                                }
                                let _e3025 = phi_4365_;
                                if (_e3005 < _e3013) {
                                    phi_4370_ = _e3005;
                                } else {
                                    phi_4370_ = _e3013;
                                }
                                let _e3028 = phi_4370_;
                                if (_e3025 < _e3028) {
                                    phi_4375_ = _e3025;
                                } else {
                                    phi_4375_ = _e3028;
                                }
                                let _e3031 = phi_4375_;
                                if (_e3022 < _e3031) {
                                    phi_4380_ = _e3022;
                                } else {
                                    phi_4380_ = _e3031;
                                }
                                let _e3034 = phi_4380_;
                                if (_e2972 > _e2977) {
                                    phi_4385_ = _e2972;
                                } else {
                                    phi_4385_ = _e2977;
                                }
                                let _e3037 = phi_4385_;
                                if (_e2982 > _e2990) {
                                    phi_4390_ = _e2982;
                                } else {
                                    phi_4390_ = _e2990;
                                }
                                let _e3040 = phi_4390_;
                                if (_e3037 > _e3040) {
                                    phi_4395_ = _e3037;
                                } else {
                                    phi_4395_ = _e3040;
                                }
                                let _e3043 = phi_4395_;
                                if (_e2995 > _e3000) {
                                    phi_4400_ = _e2995;
                                } else {
                                    phi_4400_ = _e3000;
                                }
                                let _e3046 = phi_4400_;
                                if (_e3005 > _e3013) {
                                    phi_4405_ = _e3005;
                                } else {
                                    phi_4405_ = _e3013;
                                }
                                let _e3049 = phi_4405_;
                                if (_e3046 > _e3049) {
                                    phi_4410_ = _e3046;
                                } else {
                                    phi_4410_ = _e3049;
                                }
                                let _e3052 = phi_4410_;
                                if (_e3043 > _e3052) {
                                    phi_4415_ = _e3043;
                                } else {
                                    phi_4415_ = _e3052;
                                }
                                let _e3055 = phi_4415_;
                                if (_e2961 < 0f) {
                                    phi_4421_ = -(_e2961);
                                } else {
                                    phi_4421_ = _e2961;
                                }
                                let _e3059 = phi_4421_;
                                if (_e2964 < 0f) {
                                    phi_4427_ = -(_e2964);
                                } else {
                                    phi_4427_ = _e2964;
                                }
                                let _e3063 = phi_4427_;
                                if (_e2967 < 0f) {
                                    phi_4434_ = -(_e2967);
                                } else {
                                    phi_4434_ = _e2967;
                                }
                                let _e3068 = phi_4434_;
                                let _e3069 = ((_e3059 + _e3063) + _e3068);
                                let _e3074 = -(_e3055);
                                if (_e3034 > _e3074) {
                                    phi_4445_ = _e3034;
                                } else {
                                    phi_4445_ = _e3074;
                                }
                                let _e3077 = phi_4445_;
                                let _e3082 = (((_e3077 - ((_e3069 * _e2696) * (0.000000059604645f * (17f / 2f)))) - (_e3069 * _e2703)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2954 > _e3082) {
                                    phi_4455_ = _e2954;
                                } else {
                                    phi_4455_ = _e3082;
                                }
                                let _e3085 = phi_4455_;
                                phi_4456_ = _e3085;
                            } else {
                                phi_4456_ = _e2954;
                            }
                            let _e3087 = phi_4456_;
                            phi_4459_ = (_e2428 || (_e3087 > 0f));
                        }
                        let _e3091 = phi_4459_;
                        if _e3091 {
                            let _e3094 = local_1.member_1[0u];
                            let _e3100 = local_1.member_2[0u];
                            let _e3106 = ((_e3094[1] * _e3100[2]) - (_e3094[2] * _e3100[1]));
                            let _e3109 = ((_e3094[2] * _e3100[0]) - (_e3094[0] * _e3100[2]));
                            let _e3112 = ((_e3094[0] * _e3100[1]) - (_e3094[1] * _e3100[0]));
                            let _e3115 = local_1.member_1[1u];
                            let _e3121 = local_1.member_2[1u];
                            let _e3127 = ((_e3115[1] * _e3121[2]) - (_e3115[2] * _e3121[1]));
                            let _e3130 = ((_e3115[2] * _e3121[0]) - (_e3115[0] * _e3121[2]));
                            let _e3133 = ((_e3115[0] * _e3121[1]) - (_e3115[1] * _e3121[0]));
                            let _e3136 = local_1.member_1[0u];
                            let _e3142 = local_1.member_2[1u];
                            let _e3157 = local_1.member_1[1u];
                            let _e3163 = local_1.member_2[0u];
                            let _e3176 = (((_e3136[1] * _e3142[2]) - (_e3136[2] * _e3142[1])) + ((_e3157[1] * _e3163[2]) - (_e3157[2] * _e3163[1])));
                            let _e3177 = (((_e3136[2] * _e3142[0]) - (_e3136[0] * _e3142[2])) + ((_e3157[2] * _e3163[0]) - (_e3157[0] * _e3163[2])));
                            let _e3178 = (((_e3136[0] * _e3142[1]) - (_e3136[1] * _e3142[0])) + ((_e3157[0] * _e3163[1]) - (_e3157[1] * _e3163[0])));
                            let _e3181 = local_1.member[0u];
                            let _e3192 = local_1.member[1u];
                            let _e3203 = local_1.member[0u];
                            let _e3212 = ((((_e3192[0] * _e3106) + (_e3192[1] * _e3109)) + (_e3192[2] * _e3112)) + (((_e3203[0] * _e3176) + (_e3203[1] * _e3177)) + (_e3203[2] * _e3178)));
                            let _e3215 = local_1.member[0u];
                            let _e3226 = local_1.member[1u];
                            let _e3235 = ((((_e3215[0] * _e3127) + (_e3215[1] * _e3130)) + (_e3215[2] * _e3133)) + (((_e3226[0] * _e3176) + (_e3226[1] * _e3177)) + (_e3226[2] * _e3178)));
                            let _e3238 = local_1.member[1u];
                            let _e3249 = local_1.member[0u];
                            if (_e3249[0] < 0f) {
                                phi_4704_ = -(_e3249[0]);
                            } else {
                                phi_4704_ = _e3249[0];
                            }
                            let _e3256 = phi_4704_;
                            if (_e3249[1] < 0f) {
                                phi_4711_ = -(_e3249[1]);
                            } else {
                                phi_4711_ = _e3249[1];
                            }
                            let _e3260 = phi_4711_;
                            if (_e3256 > _e3260) {
                                phi_4716_ = _e3256;
                            } else {
                                phi_4716_ = _e3260;
                            }
                            let _e3263 = phi_4716_;
                            if (_e3249[2] < 0f) {
                                phi_4723_ = -(_e3249[2]);
                            } else {
                                phi_4723_ = _e3249[2];
                            }
                            let _e3267 = phi_4723_;
                            if (_e3263 > _e3267) {
                                phi_4728_ = _e3263;
                            } else {
                                phi_4728_ = _e3267;
                            }
                            let _e3270 = phi_4728_;
                            let _e3273 = local_1.member[1u];
                            if (_e3273[0] < 0f) {
                                phi_4741_ = -(_e3273[0]);
                            } else {
                                phi_4741_ = _e3273[0];
                            }
                            let _e3280 = phi_4741_;
                            if (_e3273[1] < 0f) {
                                phi_4748_ = -(_e3273[1]);
                            } else {
                                phi_4748_ = _e3273[1];
                            }
                            let _e3284 = phi_4748_;
                            if (_e3280 > _e3284) {
                                phi_4753_ = _e3280;
                            } else {
                                phi_4753_ = _e3284;
                            }
                            let _e3287 = phi_4753_;
                            if (_e3273[2] < 0f) {
                                phi_4760_ = -(_e3273[2]);
                            } else {
                                phi_4760_ = _e3273[2];
                            }
                            let _e3291 = phi_4760_;
                            if (_e3287 > _e3291) {
                                phi_4765_ = _e3287;
                            } else {
                                phi_4765_ = _e3291;
                            }
                            let _e3294 = phi_4765_;
                            if (_e3270 > _e3294) {
                                phi_4770_ = _e3270;
                            } else {
                                phi_4770_ = _e3294;
                            }
                            let _e3297 = phi_4770_;
                            let _e3299 = local_1.member_3;
                            let _e3300 = (_e3297 + _e3299);
                            let _e3303 = local_1.member_1[0u];
                            if (_e3303[0] < 0f) {
                                phi_4787_ = -(_e3303[0]);
                            } else {
                                phi_4787_ = _e3303[0];
                            }
                            let _e3310 = phi_4787_;
                            if (_e3303[1] < 0f) {
                                phi_4794_ = -(_e3303[1]);
                            } else {
                                phi_4794_ = _e3303[1];
                            }
                            let _e3314 = phi_4794_;
                            if (_e3310 > _e3314) {
                                phi_4799_ = _e3310;
                            } else {
                                phi_4799_ = _e3314;
                            }
                            let _e3317 = phi_4799_;
                            if (_e3303[2] < 0f) {
                                phi_4806_ = -(_e3303[2]);
                            } else {
                                phi_4806_ = _e3303[2];
                            }
                            let _e3321 = phi_4806_;
                            if (_e3317 > _e3321) {
                                phi_4811_ = _e3317;
                            } else {
                                phi_4811_ = _e3321;
                            }
                            let _e3324 = phi_4811_;
                            let _e3327 = local_1.member_1[1u];
                            if (_e3327[0] < 0f) {
                                phi_4825_ = -(_e3327[0]);
                            } else {
                                phi_4825_ = _e3327[0];
                            }
                            let _e3334 = phi_4825_;
                            if (_e3327[1] < 0f) {
                                phi_4832_ = -(_e3327[1]);
                            } else {
                                phi_4832_ = _e3327[1];
                            }
                            let _e3338 = phi_4832_;
                            if (_e3334 > _e3338) {
                                phi_4837_ = _e3334;
                            } else {
                                phi_4837_ = _e3338;
                            }
                            let _e3341 = phi_4837_;
                            if (_e3327[2] < 0f) {
                                phi_4844_ = -(_e3327[2]);
                            } else {
                                phi_4844_ = _e3327[2];
                            }
                            let _e3345 = phi_4844_;
                            if (_e3341 > _e3345) {
                                phi_4849_ = _e3341;
                            } else {
                                phi_4849_ = _e3345;
                            }
                            let _e3348 = phi_4849_;
                            if (_e3324 > _e3348) {
                                phi_4854_ = _e3324;
                            } else {
                                phi_4854_ = _e3348;
                            }
                            let _e3351 = phi_4854_;
                            let _e3353 = local_1.member_3;
                            let _e3354 = (_e3351 + _e3353);
                            let _e3357 = local_1.member_2[0u];
                            if (_e3357[0] < 0f) {
                                phi_4871_ = -(_e3357[0]);
                            } else {
                                phi_4871_ = _e3357[0];
                            }
                            let _e3364 = phi_4871_;
                            if (_e3357[1] < 0f) {
                                phi_4878_ = -(_e3357[1]);
                            } else {
                                phi_4878_ = _e3357[1];
                            }
                            let _e3368 = phi_4878_;
                            if (_e3364 > _e3368) {
                                phi_4883_ = _e3364;
                            } else {
                                phi_4883_ = _e3368;
                            }
                            let _e3371 = phi_4883_;
                            if (_e3357[2] < 0f) {
                                phi_4890_ = -(_e3357[2]);
                            } else {
                                phi_4890_ = _e3357[2];
                            }
                            let _e3375 = phi_4890_;
                            if (_e3371 > _e3375) {
                                phi_4895_ = _e3371;
                            } else {
                                phi_4895_ = _e3375;
                            }
                            let _e3378 = phi_4895_;
                            let _e3381 = local_1.member_2[1u];
                            if (_e3381[0] < 0f) {
                                phi_4909_ = -(_e3381[0]);
                            } else {
                                phi_4909_ = _e3381[0];
                            }
                            let _e3388 = phi_4909_;
                            if (_e3381[1] < 0f) {
                                phi_4916_ = -(_e3381[1]);
                            } else {
                                phi_4916_ = _e3381[1];
                            }
                            let _e3392 = phi_4916_;
                            if (_e3388 > _e3392) {
                                phi_4921_ = _e3388;
                            } else {
                                phi_4921_ = _e3392;
                            }
                            let _e3395 = phi_4921_;
                            if (_e3381[2] < 0f) {
                                phi_4928_ = -(_e3381[2]);
                            } else {
                                phi_4928_ = _e3381[2];
                            }
                            let _e3399 = phi_4928_;
                            if (_e3395 > _e3399) {
                                phi_4933_ = _e3395;
                            } else {
                                phi_4933_ = _e3399;
                            }
                            let _e3402 = phi_4933_;
                            if (_e3378 > _e3402) {
                                phi_4938_ = _e3378;
                            } else {
                                phi_4938_ = _e3402;
                            }
                            let _e3405 = phi_4938_;
                            let _e3407 = local_1.member_3;
                            let _e3408 = (_e3405 + _e3407);
                            let _e3410 = ((_e3354 * 8f) * _e3408);
                            let _e3417 = local_1.member_3;
                            if (_e3106 < 0f) {
                                phi_4969_ = -(_e3106);
                            } else {
                                phi_4969_ = _e3106;
                            }
                            let _e3434 = phi_4969_;
                            if (_e3109 < 0f) {
                                phi_4975_ = -(_e3109);
                            } else {
                                phi_4975_ = _e3109;
                            }
                            let _e3438 = phi_4975_;
                            if (_e3112 < 0f) {
                                phi_4982_ = -(_e3112);
                            } else {
                                phi_4982_ = _e3112;
                            }
                            let _e3443 = phi_4982_;
                            let _e3444 = ((_e3434 + _e3438) + _e3443);
                            if (_e3127 < 0f) {
                                phi_4989_ = -(_e3127);
                            } else {
                                phi_4989_ = _e3127;
                            }
                            let _e3448 = phi_4989_;
                            if (_e3130 < 0f) {
                                phi_4995_ = -(_e3130);
                            } else {
                                phi_4995_ = _e3130;
                            }
                            let _e3452 = phi_4995_;
                            if (_e3133 < 0f) {
                                phi_5002_ = -(_e3133);
                            } else {
                                phi_5002_ = _e3133;
                            }
                            let _e3457 = phi_5002_;
                            let _e3458 = ((_e3448 + _e3452) + _e3457);
                            if (_e3444 > _e3458) {
                                phi_5008_ = _e3444;
                            } else {
                                phi_5008_ = _e3458;
                            }
                            let _e3461 = phi_5008_;
                            if (_e3176 < 0f) {
                                phi_5014_ = -(_e3176);
                            } else {
                                phi_5014_ = _e3176;
                            }
                            let _e3465 = phi_5014_;
                            if (_e3177 < 0f) {
                                phi_5020_ = -(_e3177);
                            } else {
                                phi_5020_ = _e3177;
                            }
                            let _e3469 = phi_5020_;
                            if (_e3178 < 0f) {
                                phi_5027_ = -(_e3178);
                            } else {
                                phi_5027_ = _e3178;
                            }
                            let _e3474 = phi_5027_;
                            let _e3476 = (((_e3465 + _e3469) + _e3474) * 0.5f);
                            if (_e3461 > _e3476) {
                                phi_5034_ = _e3461;
                            } else {
                                phi_5034_ = _e3476;
                            }
                            let _e3479 = phi_5034_;
                            let _e3484 = local_1.member_3;
                            let _e3497 = ((((_e3181[0] * _e3106) + (_e3181[1] * _e3109)) + (_e3181[2] * _e3112)) * 3f);
                            let _e3498 = ((((_e3238[0] * _e3127) + (_e3238[1] * _e3130)) + (_e3238[2] * _e3133)) * 3f);
                            if (_e3497 < _e3498) {
                                phi_5058_ = _e3497;
                            } else {
                                phi_5058_ = _e3498;
                            }
                            let _e3501 = phi_5058_;
                            if (_e3212 < _e3235) {
                                phi_5063_ = _e3212;
                            } else {
                                phi_5063_ = _e3235;
                            }
                            let _e3504 = phi_5063_;
                            if (_e3501 < _e3504) {
                                phi_5068_ = _e3501;
                            } else {
                                phi_5068_ = _e3504;
                            }
                            let _e3507 = phi_5068_;
                            if (_e3497 > _e3498) {
                                phi_5073_ = _e3497;
                            } else {
                                phi_5073_ = _e3498;
                            }
                            let _e3510 = phi_5073_;
                            if (_e3212 > _e3235) {
                                phi_5078_ = _e3212;
                            } else {
                                phi_5078_ = _e3235;
                            }
                            let _e3513 = phi_5078_;
                            if (_e3510 > _e3513) {
                                phi_5083_ = _e3510;
                            } else {
                                phi_5083_ = _e3513;
                            }
                            let _e3516 = phi_5083_;
                            let _e3521 = -(_e3516);
                            if (_e3507 > _e3521) {
                                phi_5093_ = _e3507;
                            } else {
                                phi_5093_ = _e3521;
                            }
                            let _e3524 = phi_5093_;
                            let _e3526 = ((_e3524 - ((((((_e3300 * 8f) * _e3410) * (0.000000059604645f * (524f / 64f))) + ((_e3417 * 19f) * ((_e3300 * (_e3354 + _e3408)) + (_e3354 * _e3408)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3300) * ((1f + _e3354) * (1f + _e3408))))) + ((_e60.member_5 * (((_e3479 + (_e3410 * (0.000000059604645f * 8f))) + ((_e3484 * 6f) * (_e3354 + _e3408))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3354) * (1f + _e3408))))) * (3f * 1.0001f)))) > 0f);
                            if _e3526 {
                                phi_6062_ = _e3526;
                            } else {
                                let _e3529 = local_1.member_1[0u];
                                let _e3535 = local_1.member_1[1u];
                                let _e3539 = (_e3529[0] + _e3535[0]);
                                let _e3540 = (_e3529[1] + _e3535[1]);
                                let _e3541 = (_e3529[2] + _e3535[2]);
                                let _e3544 = local_1.member_2[0u];
                                let _e3550 = local_1.member_2[1u];
                                let _e3554 = (_e3544[0] + _e3550[0]);
                                let _e3555 = (_e3544[1] + _e3550[1]);
                                let _e3556 = (_e3544[2] + _e3550[2]);
                                let _e3559 = ((_e3540 * _e3556) - (_e3541 * _e3555));
                                let _e3562 = ((_e3541 * _e3554) - (_e3539 * _e3556));
                                let _e3565 = ((_e3539 * _e3555) - (_e3540 * _e3554));
                                let _e3568 = local_1.member[0u];
                                let _e3575 = local_1.member_1[0u];
                                let _e3581 = local_1.member_2[0u];
                                let _e3585 = (_e3568[0] - _e3575[0]);
                                let _e3586 = (_e3568[1] - _e3575[1]);
                                let _e3587 = (_e3568[2] - _e3575[2]);
                                if (_e1770.member == 0u) {
                                    phi_5209_ = array<f32, 3>(_e3568[0], _e3568[1], _e3568[2]);
                                } else {
                                    phi_5209_ = array<f32, 3>((_e3585 - _e3581[0]), (_e3586 - _e3581[1]), (_e3587 - _e3581[2]));
                                }
                                let _e3594 = phi_5209_;
                                let _e3595 = (_e3568[0] - _e3581[0]);
                                let _e3596 = (_e3568[1] - _e3581[1]);
                                let _e3597 = (_e3568[2] - _e3581[2]);
                                let _e3600 = local_1.member[1u];
                                let _e3607 = local_1.member_1[1u];
                                let _e3613 = local_1.member_2[1u];
                                let _e3617 = (_e3600[0] - _e3607[0]);
                                let _e3618 = (_e3600[1] - _e3607[1]);
                                let _e3619 = (_e3600[2] - _e3607[2]);
                                if (_e1770.member == 0u) {
                                    phi_5274_ = array<f32, 3>(_e3600[0], _e3600[1], _e3600[2]);
                                } else {
                                    phi_5274_ = array<f32, 3>((_e3617 - _e3613[0]), (_e3618 - _e3613[1]), (_e3619 - _e3613[2]));
                                }
                                let _e3626 = phi_5274_;
                                let _e3627 = (_e3600[0] - _e3613[0]);
                                let _e3628 = (_e3600[1] - _e3613[1]);
                                let _e3629 = (_e3600[2] - _e3613[2]);
                                let _e3632 = local_1.member[0u];
                                if (_e3632[0] < 0f) {
                                    phi_5296_ = -(_e3632[0]);
                                } else {
                                    phi_5296_ = _e3632[0];
                                }
                                let _e3639 = phi_5296_;
                                if (_e3632[1] < 0f) {
                                    phi_5303_ = -(_e3632[1]);
                                } else {
                                    phi_5303_ = _e3632[1];
                                }
                                let _e3643 = phi_5303_;
                                if (_e3639 > _e3643) {
                                    phi_5308_ = _e3639;
                                } else {
                                    phi_5308_ = _e3643;
                                }
                                let _e3646 = phi_5308_;
                                if (_e3632[2] < 0f) {
                                    phi_5315_ = -(_e3632[2]);
                                } else {
                                    phi_5315_ = _e3632[2];
                                }
                                let _e3650 = phi_5315_;
                                if (_e3646 > _e3650) {
                                    phi_5320_ = _e3646;
                                } else {
                                    phi_5320_ = _e3650;
                                }
                                let _e3653 = phi_5320_;
                                let _e3656 = local_1.member[1u];
                                if (_e3656[0] < 0f) {
                                    phi_5333_ = -(_e3656[0]);
                                } else {
                                    phi_5333_ = _e3656[0];
                                }
                                let _e3663 = phi_5333_;
                                if (_e3656[1] < 0f) {
                                    phi_5340_ = -(_e3656[1]);
                                } else {
                                    phi_5340_ = _e3656[1];
                                }
                                let _e3667 = phi_5340_;
                                if (_e3663 > _e3667) {
                                    phi_5345_ = _e3663;
                                } else {
                                    phi_5345_ = _e3667;
                                }
                                let _e3670 = phi_5345_;
                                if (_e3656[2] < 0f) {
                                    phi_5352_ = -(_e3656[2]);
                                } else {
                                    phi_5352_ = _e3656[2];
                                }
                                let _e3674 = phi_5352_;
                                if (_e3670 > _e3674) {
                                    phi_5357_ = _e3670;
                                } else {
                                    phi_5357_ = _e3674;
                                }
                                let _e3677 = phi_5357_;
                                if (_e3653 > _e3677) {
                                    phi_5362_ = _e3653;
                                } else {
                                    phi_5362_ = _e3677;
                                }
                                let _e3680 = phi_5362_;
                                let _e3682 = local_1.member_3;
                                let _e3686 = local_1.member_1[0u];
                                if (_e3686[0] < 0f) {
                                    phi_5379_ = -(_e3686[0]);
                                } else {
                                    phi_5379_ = _e3686[0];
                                }
                                let _e3693 = phi_5379_;
                                if (_e3686[1] < 0f) {
                                    phi_5386_ = -(_e3686[1]);
                                } else {
                                    phi_5386_ = _e3686[1];
                                }
                                let _e3697 = phi_5386_;
                                if (_e3693 > _e3697) {
                                    phi_5391_ = _e3693;
                                } else {
                                    phi_5391_ = _e3697;
                                }
                                let _e3700 = phi_5391_;
                                if (_e3686[2] < 0f) {
                                    phi_5398_ = -(_e3686[2]);
                                } else {
                                    phi_5398_ = _e3686[2];
                                }
                                let _e3704 = phi_5398_;
                                if (_e3700 > _e3704) {
                                    phi_5403_ = _e3700;
                                } else {
                                    phi_5403_ = _e3704;
                                }
                                let _e3707 = phi_5403_;
                                let _e3710 = local_1.member_1[1u];
                                if (_e3710[0] < 0f) {
                                    phi_5417_ = -(_e3710[0]);
                                } else {
                                    phi_5417_ = _e3710[0];
                                }
                                let _e3717 = phi_5417_;
                                if (_e3710[1] < 0f) {
                                    phi_5424_ = -(_e3710[1]);
                                } else {
                                    phi_5424_ = _e3710[1];
                                }
                                let _e3721 = phi_5424_;
                                if (_e3717 > _e3721) {
                                    phi_5429_ = _e3717;
                                } else {
                                    phi_5429_ = _e3721;
                                }
                                let _e3724 = phi_5429_;
                                if (_e3710[2] < 0f) {
                                    phi_5436_ = -(_e3710[2]);
                                } else {
                                    phi_5436_ = _e3710[2];
                                }
                                let _e3728 = phi_5436_;
                                if (_e3724 > _e3728) {
                                    phi_5441_ = _e3724;
                                } else {
                                    phi_5441_ = _e3728;
                                }
                                let _e3731 = phi_5441_;
                                if (_e3707 > _e3731) {
                                    phi_5446_ = _e3707;
                                } else {
                                    phi_5446_ = _e3731;
                                }
                                let _e3734 = phi_5446_;
                                let _e3736 = local_1.member_3;
                                let _e3740 = local_1.member_2[0u];
                                if (_e3740[0] < 0f) {
                                    phi_5463_ = -(_e3740[0]);
                                } else {
                                    phi_5463_ = _e3740[0];
                                }
                                let _e3747 = phi_5463_;
                                if (_e3740[1] < 0f) {
                                    phi_5470_ = -(_e3740[1]);
                                } else {
                                    phi_5470_ = _e3740[1];
                                }
                                let _e3751 = phi_5470_;
                                if (_e3747 > _e3751) {
                                    phi_5475_ = _e3747;
                                } else {
                                    phi_5475_ = _e3751;
                                }
                                let _e3754 = phi_5475_;
                                if (_e3740[2] < 0f) {
                                    phi_5482_ = -(_e3740[2]);
                                } else {
                                    phi_5482_ = _e3740[2];
                                }
                                let _e3758 = phi_5482_;
                                if (_e3754 > _e3758) {
                                    phi_5487_ = _e3754;
                                } else {
                                    phi_5487_ = _e3758;
                                }
                                let _e3761 = phi_5487_;
                                let _e3764 = local_1.member_2[1u];
                                if (_e3764[0] < 0f) {
                                    phi_5501_ = -(_e3764[0]);
                                } else {
                                    phi_5501_ = _e3764[0];
                                }
                                let _e3771 = phi_5501_;
                                if (_e3764[1] < 0f) {
                                    phi_5508_ = -(_e3764[1]);
                                } else {
                                    phi_5508_ = _e3764[1];
                                }
                                let _e3775 = phi_5508_;
                                if (_e3771 > _e3775) {
                                    phi_5513_ = _e3771;
                                } else {
                                    phi_5513_ = _e3775;
                                }
                                let _e3778 = phi_5513_;
                                if (_e3764[2] < 0f) {
                                    phi_5520_ = -(_e3764[2]);
                                } else {
                                    phi_5520_ = _e3764[2];
                                }
                                let _e3782 = phi_5520_;
                                if (_e3778 > _e3782) {
                                    phi_5525_ = _e3778;
                                } else {
                                    phi_5525_ = _e3782;
                                }
                                let _e3785 = phi_5525_;
                                if (_e3761 > _e3785) {
                                    phi_5530_ = _e3761;
                                } else {
                                    phi_5530_ = _e3785;
                                }
                                let _e3788 = phi_5530_;
                                let _e3790 = local_1.member_3;
                                let _e3794 = ((((_e3680 + _e3682) + (_e3734 + _e3736)) + (_e3788 + _e3790)) * 2f);
                                let _e3797 = local_1.member_3;
                                let _e3801 = (((_e60.member_5 * 1.0001f) + (_e3797 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e3804 = ((_e3562 * _e3541) - (_e3565 * _e3540));
                                let _e3807 = ((_e3565 * _e3539) - (_e3559 * _e3541));
                                let _e3810 = ((_e3559 * _e3540) - (_e3562 * _e3539));
                                let _e3815 = (((_e3804 * _e3568[0]) + (_e3807 * _e3568[1])) + (_e3810 * _e3568[2]));
                                let _e3820 = (((_e3804 * _e3585) + (_e3807 * _e3586)) + (_e3810 * _e3587));
                                let _e3825 = (((_e3804 * _e3595) + (_e3807 * _e3596)) + (_e3810 * _e3597));
                                let _e3833 = (((_e3804 * _e3594[0]) + (_e3807 * _e3594[1])) + (_e3810 * _e3594[2]));
                                let _e3838 = (((_e3804 * _e3600[0]) + (_e3807 * _e3600[1])) + (_e3810 * _e3600[2]));
                                let _e3843 = (((_e3804 * _e3617) + (_e3807 * _e3618)) + (_e3810 * _e3619));
                                let _e3848 = (((_e3804 * _e3627) + (_e3807 * _e3628)) + (_e3810 * _e3629));
                                let _e3856 = (((_e3804 * _e3626[0]) + (_e3807 * _e3626[1])) + (_e3810 * _e3626[2]));
                                if (_e3815 < _e3820) {
                                    phi_5609_ = _e3815;
                                } else {
                                    phi_5609_ = _e3820;
                                }
                                let _e3859 = phi_5609_;
                                if (_e3825 < _e3833) {
                                    phi_5614_ = _e3825;
                                } else {
                                    phi_5614_ = _e3833;
                                }
                                let _e3862 = phi_5614_;
                                if (_e3859 < _e3862) {
                                    phi_5619_ = _e3859;
                                } else {
                                    phi_5619_ = _e3862;
                                }
                                let _e3865 = phi_5619_;
                                if (_e3838 < _e3843) {
                                    phi_5624_ = _e3838;
                                } else {
                                    phi_5624_ = _e3843;
                                }
                                let _e3868 = phi_5624_;
                                if (_e3848 < _e3856) {
                                    phi_5629_ = _e3848;
                                } else {
                                    phi_5629_ = _e3856;
                                }
                                let _e3871 = phi_5629_;
                                if (_e3868 < _e3871) {
                                    phi_5634_ = _e3868;
                                } else {
                                    phi_5634_ = _e3871;
                                }
                                let _e3874 = phi_5634_;
                                if (_e3865 < _e3874) {
                                    phi_5639_ = _e3865;
                                } else {
                                    phi_5639_ = _e3874;
                                }
                                let _e3877 = phi_5639_;
                                if (_e3815 > _e3820) {
                                    phi_5644_ = _e3815;
                                } else {
                                    phi_5644_ = _e3820;
                                }
                                let _e3880 = phi_5644_;
                                if (_e3825 > _e3833) {
                                    phi_5649_ = _e3825;
                                } else {
                                    phi_5649_ = _e3833;
                                }
                                let _e3883 = phi_5649_;
                                if (_e3880 > _e3883) {
                                    phi_5654_ = _e3880;
                                } else {
                                    phi_5654_ = _e3883;
                                }
                                let _e3886 = phi_5654_;
                                if (_e3838 > _e3843) {
                                    phi_5659_ = _e3838;
                                } else {
                                    phi_5659_ = _e3843;
                                }
                                let _e3889 = phi_5659_;
                                if (_e3848 > _e3856) {
                                    phi_5664_ = _e3848;
                                } else {
                                    phi_5664_ = _e3856;
                                }
                                let _e3892 = phi_5664_;
                                if (_e3889 > _e3892) {
                                    phi_5669_ = _e3889;
                                } else {
                                    phi_5669_ = _e3892;
                                }
                                let _e3895 = phi_5669_;
                                if (_e3886 > _e3895) {
                                    phi_5674_ = _e3886;
                                } else {
                                    phi_5674_ = _e3895;
                                }
                                let _e3898 = phi_5674_;
                                if (_e3804 < 0f) {
                                    phi_5680_ = -(_e3804);
                                } else {
                                    phi_5680_ = _e3804;
                                }
                                let _e3902 = phi_5680_;
                                if (_e3807 < 0f) {
                                    phi_5686_ = -(_e3807);
                                } else {
                                    phi_5686_ = _e3807;
                                }
                                let _e3906 = phi_5686_;
                                if (_e3810 < 0f) {
                                    phi_5693_ = -(_e3810);
                                } else {
                                    phi_5693_ = _e3810;
                                }
                                let _e3911 = phi_5693_;
                                let _e3912 = ((_e3902 + _e3906) + _e3911);
                                let _e3917 = -(_e3898);
                                if (_e3877 > _e3917) {
                                    phi_5704_ = _e3877;
                                } else {
                                    phi_5704_ = _e3917;
                                }
                                let _e3920 = phi_5704_;
                                let _e3925 = (((_e3920 - ((_e3912 * _e3794) * (0.000000059604645f * (17f / 2f)))) - (_e3912 * _e3801)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e3928 = ((_e3562 * _e3556) - (_e3565 * _e3555));
                                let _e3931 = ((_e3565 * _e3554) - (_e3559 * _e3556));
                                let _e3934 = ((_e3559 * _e3555) - (_e3562 * _e3554));
                                let _e3939 = (((_e3928 * _e3568[0]) + (_e3931 * _e3568[1])) + (_e3934 * _e3568[2]));
                                let _e3944 = (((_e3928 * _e3585) + (_e3931 * _e3586)) + (_e3934 * _e3587));
                                let _e3949 = (((_e3928 * _e3595) + (_e3931 * _e3596)) + (_e3934 * _e3597));
                                let _e3957 = (((_e3928 * _e3594[0]) + (_e3931 * _e3594[1])) + (_e3934 * _e3594[2]));
                                let _e3962 = (((_e3928 * _e3600[0]) + (_e3931 * _e3600[1])) + (_e3934 * _e3600[2]));
                                let _e3967 = (((_e3928 * _e3617) + (_e3931 * _e3618)) + (_e3934 * _e3619));
                                let _e3972 = (((_e3928 * _e3627) + (_e3931 * _e3628)) + (_e3934 * _e3629));
                                let _e3980 = (((_e3928 * _e3626[0]) + (_e3931 * _e3626[1])) + (_e3934 * _e3626[2]));
                                if (_e3939 < _e3944) {
                                    phi_5775_ = _e3939;
                                } else {
                                    phi_5775_ = _e3944;
                                }
                                let _e3983 = phi_5775_;
                                if (_e3949 < _e3957) {
                                    phi_5780_ = _e3949;
                                } else {
                                    phi_5780_ = _e3957;
                                }
                                let _e3986 = phi_5780_;
                                if (_e3983 < _e3986) {
                                    phi_5785_ = _e3983;
                                } else {
                                    phi_5785_ = _e3986;
                                }
                                let _e3989 = phi_5785_;
                                if (_e3962 < _e3967) {
                                    phi_5790_ = _e3962;
                                } else {
                                    phi_5790_ = _e3967;
                                }
                                let _e3992 = phi_5790_;
                                if (_e3972 < _e3980) {
                                    phi_5795_ = _e3972;
                                } else {
                                    phi_5795_ = _e3980;
                                }
                                let _e3995 = phi_5795_;
                                if (_e3992 < _e3995) {
                                    phi_5800_ = _e3992;
                                } else {
                                    phi_5800_ = _e3995;
                                }
                                let _e3998 = phi_5800_;
                                if (_e3989 < _e3998) {
                                    phi_5805_ = _e3989;
                                } else {
                                    phi_5805_ = _e3998;
                                }
                                let _e4001 = phi_5805_;
                                if (_e3939 > _e3944) {
                                    phi_5810_ = _e3939;
                                } else {
                                    phi_5810_ = _e3944;
                                }
                                let _e4004 = phi_5810_;
                                if (_e3949 > _e3957) {
                                    phi_5815_ = _e3949;
                                } else {
                                    phi_5815_ = _e3957;
                                }
                                let _e4007 = phi_5815_;
                                if (_e4004 > _e4007) {
                                    phi_5820_ = _e4004;
                                } else {
                                    phi_5820_ = _e4007;
                                }
                                let _e4010 = phi_5820_;
                                if (_e3962 > _e3967) {
                                    phi_5825_ = _e3962;
                                } else {
                                    phi_5825_ = _e3967;
                                }
                                let _e4013 = phi_5825_;
                                if (_e3972 > _e3980) {
                                    phi_5830_ = _e3972;
                                } else {
                                    phi_5830_ = _e3980;
                                }
                                let _e4016 = phi_5830_;
                                if (_e4013 > _e4016) {
                                    phi_5835_ = _e4013;
                                } else {
                                    phi_5835_ = _e4016;
                                }
                                let _e4019 = phi_5835_;
                                if (_e4010 > _e4019) {
                                    phi_5840_ = _e4010;
                                } else {
                                    phi_5840_ = _e4019;
                                }
                                let _e4022 = phi_5840_;
                                if (_e3928 < 0f) {
                                    phi_5846_ = -(_e3928);
                                } else {
                                    phi_5846_ = _e3928;
                                }
                                let _e4026 = phi_5846_;
                                if (_e3931 < 0f) {
                                    phi_5852_ = -(_e3931);
                                } else {
                                    phi_5852_ = _e3931;
                                }
                                let _e4030 = phi_5852_;
                                if (_e3934 < 0f) {
                                    phi_5859_ = -(_e3934);
                                } else {
                                    phi_5859_ = _e3934;
                                }
                                let _e4035 = phi_5859_;
                                let _e4036 = ((_e4026 + _e4030) + _e4035);
                                let _e4041 = -(_e4022);
                                if (_e4001 > _e4041) {
                                    phi_5870_ = _e4001;
                                } else {
                                    phi_5870_ = _e4041;
                                }
                                let _e4044 = phi_5870_;
                                let _e4049 = (((_e4044 - ((_e4036 * _e3794) * (0.000000059604645f * (17f / 2f)))) - (_e4036 * _e3801)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e3925 > _e4049) {
                                    phi_5880_ = _e3925;
                                } else {
                                    phi_5880_ = _e4049;
                                }
                                let _e4052 = phi_5880_;
                                if (_e1770.member == 0u) {
                                    let _e4054 = (_e3554 - _e3539);
                                    let _e4055 = (_e3555 - _e3540);
                                    let _e4056 = (_e3556 - _e3541);
                                    let _e4059 = ((_e3562 * _e4056) - (_e3565 * _e4055));
                                    let _e4062 = ((_e3565 * _e4054) - (_e3559 * _e4056));
                                    let _e4065 = ((_e3559 * _e4055) - (_e3562 * _e4054));
                                    let _e4070 = (((_e4059 * _e3568[0]) + (_e4062 * _e3568[1])) + (_e4065 * _e3568[2]));
                                    let _e4075 = (((_e4059 * _e3585) + (_e4062 * _e3586)) + (_e4065 * _e3587));
                                    let _e4080 = (((_e4059 * _e3595) + (_e4062 * _e3596)) + (_e4065 * _e3597));
                                    let _e4088 = (((_e4059 * _e3594[0]) + (_e4062 * _e3594[1])) + (_e4065 * _e3594[2]));
                                    let _e4093 = (((_e4059 * _e3600[0]) + (_e4062 * _e3600[1])) + (_e4065 * _e3600[2]));
                                    let _e4098 = (((_e4059 * _e3617) + (_e4062 * _e3618)) + (_e4065 * _e3619));
                                    let _e4103 = (((_e4059 * _e3627) + (_e4062 * _e3628)) + (_e4065 * _e3629));
                                    let _e4111 = (((_e4059 * _e3626[0]) + (_e4062 * _e3626[1])) + (_e4065 * _e3626[2]));
                                    if (_e4070 < _e4075) {
                                        phi_5953_ = _e4070;
                                    } else {
                                        phi_5953_ = _e4075;
                                    }
                                    let _e4114 = phi_5953_;
                                    if (_e4080 < _e4088) {
                                        phi_5958_ = _e4080;
                                    } else {
                                        phi_5958_ = _e4088;
                                    }
                                    let _e4117 = phi_5958_;
                                    if (_e4114 < _e4117) {
                                        phi_5963_ = _e4114;
                                    } else {
                                        phi_5963_ = _e4117;
                                    }
                                    let _e4120 = phi_5963_;
                                    if (_e4093 < _e4098) {
                                        phi_5968_ = _e4093;
                                    } else {
                                        phi_5968_ = _e4098;
                                    }
                                    let _e4123 = phi_5968_;
                                    if (_e4103 < _e4111) {
                                        phi_5973_ = _e4103;
                                    } else {
                                        phi_5973_ = _e4111;
                                    }
                                    let _e4126 = phi_5973_;
                                    if (_e4123 < _e4126) {
                                        phi_5978_ = _e4123;
                                    } else {
                                        phi_5978_ = _e4126;
                                    }
                                    let _e4129 = phi_5978_;
                                    if (_e4120 < _e4129) {
                                        phi_5983_ = _e4120;
                                    } else {
                                        phi_5983_ = _e4129;
                                    }
                                    let _e4132 = phi_5983_;
                                    if (_e4070 > _e4075) {
                                        phi_5988_ = _e4070;
                                    } else {
                                        phi_5988_ = _e4075;
                                    }
                                    let _e4135 = phi_5988_;
                                    if (_e4080 > _e4088) {
                                        phi_5993_ = _e4080;
                                    } else {
                                        phi_5993_ = _e4088;
                                    }
                                    let _e4138 = phi_5993_;
                                    if (_e4135 > _e4138) {
                                        phi_5998_ = _e4135;
                                    } else {
                                        phi_5998_ = _e4138;
                                    }
                                    let _e4141 = phi_5998_;
                                    if (_e4093 > _e4098) {
                                        phi_6003_ = _e4093;
                                    } else {
                                        phi_6003_ = _e4098;
                                    }
                                    let _e4144 = phi_6003_;
                                    if (_e4103 > _e4111) {
                                        phi_6008_ = _e4103;
                                    } else {
                                        phi_6008_ = _e4111;
                                    }
                                    let _e4147 = phi_6008_;
                                    if (_e4144 > _e4147) {
                                        phi_6013_ = _e4144;
                                    } else {
                                        phi_6013_ = _e4147;
                                    }
                                    let _e4150 = phi_6013_;
                                    if (_e4141 > _e4150) {
                                        phi_6018_ = _e4141;
                                    } else {
                                        phi_6018_ = _e4150;
                                    }
                                    let _e4153 = phi_6018_;
                                    if (_e4059 < 0f) {
                                        phi_6024_ = -(_e4059);
                                    } else {
                                        phi_6024_ = _e4059;
                                    }
                                    let _e4157 = phi_6024_;
                                    if (_e4062 < 0f) {
                                        phi_6030_ = -(_e4062);
                                    } else {
                                        phi_6030_ = _e4062;
                                    }
                                    let _e4161 = phi_6030_;
                                    if (_e4065 < 0f) {
                                        phi_6037_ = -(_e4065);
                                    } else {
                                        phi_6037_ = _e4065;
                                    }
                                    let _e4166 = phi_6037_;
                                    let _e4167 = ((_e4157 + _e4161) + _e4166);
                                    let _e4172 = -(_e4153);
                                    if (_e4132 > _e4172) {
                                        phi_6048_ = _e4132;
                                    } else {
                                        phi_6048_ = _e4172;
                                    }
                                    let _e4175 = phi_6048_;
                                    let _e4180 = (((_e4175 - ((_e4167 * _e3794) * (0.000000059604645f * (17f / 2f)))) - (_e4167 * _e3801)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4052 > _e4180) {
                                        phi_6058_ = _e4052;
                                    } else {
                                        phi_6058_ = _e4180;
                                    }
                                    let _e4183 = phi_6058_;
                                    phi_6059_ = _e4183;
                                } else {
                                    phi_6059_ = _e4052;
                                }
                                let _e4185 = phi_6059_;
                                phi_6062_ = (_e3526 || (_e4185 > 0f));
                            }
                            let _e4189 = phi_6062_;
                            phi_6064_ = (_e3091 && _e4189);
                        } else {
                            phi_6064_ = _e3091;
                        }
                        let _e4192 = phi_6064_;
                        if _e4192 {
                        } else {
                            let _e4194 = atomicAdd((&counters[1u]), 1u);
                            kept[_e4194].member = _e1740;
                            kept[_e4194].member_1 = _e1742;
                        }
                        phi_6073_ = true;
                    }
                    let _e4199 = phi_6073_;
                    phi_6074_ = _e4199;
                } else {
                    phi_6074_ = false;
                }
                let _e4201 = phi_6074_;
                continue;
                continuing {
                    phi_2461_ = _e1728;
                    break if !(_e4201);
                }
            }
            workgroupBarrier();
            let _e4204 = atomicLoad((&counters[1u]));
            if (_e45 == 0u) {
                if (_e4204 > 0u) {
                    let _e4208 = atomicAdd((&output.member[0u]), _e4204);
                    if ((_e4208 + _e4204) < _e4208) {
                        let _e4212 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e4208);
                }
            }
            workgroupBarrier();
            let _e4215 = atomicLoad((&counters[2u]));
            phi_6102_ = type_9(0u, 4u);
            loop {
                let _e4217 = phi_6102_;
                if (_e4217.member < _e4217.member_1) {
                    phi_6103_ = type_9((_e4217.member + 1u), _e4217.member_1);
                    phi_6126_ = type_9(1u, _e4217.member);
                } else {
                    phi_6103_ = _e4217;
                    phi_6126_ = type_9(0u, type_9().member_1);
                }
                let _e4229 = phi_6103_;
                let _e4231 = phi_6126_;
                if (bitcast<i32>(_e4231.member) != 0i) {
                    let _e4237 = ((_e4231.member_1 * 128u) + _e45);
                    if (_e4237 >= _e4204) {
                        phi_6160_ = false;
                    } else {
                        let _e4241 = params.member.member_1.member_3;
                        let _e4242 = (_e4215 + _e4237);
                        let _e4245 = kept[_e4237].member;
                        let _e4247 = kept[_e4237].member_1;
                        if (_e4242 < _e4241) {
                            let _e4249 = (2u * _e4242);
                            atomicStore((&output.member[(4u + _e4249)]), _e4245);
                            atomicStore((&output.member[(_e4249 + 5u)]), _e4247);
                        }
                        phi_6160_ = true;
                    }
                    let _e4255 = phi_6160_;
                    phi_6161_ = _e4255;
                } else {
                    phi_6161_ = false;
                }
                let _e4257 = phi_6161_;
                continue;
                continuing {
                    phi_6102_ = _e4229;
                    break if !(_e4257);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_239_ = _e122;
            break if !(_e128);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_2(id, n, lane);
}
