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

struct type_11 {
    member: array<u32>,
}

struct type_15 {
    member: i32,
    member_1: i32,
}

struct type_16 {
    member: u32,
    member_1: i32,
}

struct type_18 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

struct type_22 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_24 {
    member: array<type_22>,
}

struct type_25 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_31 {
    member: array<type_29>,
}

struct type_33 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_39 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_41 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_45 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(2) 
var<storage> leaves: type_27;
@group(0) @binding(1) 
var<storage> nodes: type_31;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_33, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(3) 
var<storage> bodies: type_11;
@group(0) @binding(4) 
var<storage> keys: type_39;
@group(0) @binding(5) 
var<storage> paths: type_24;
@group(0) @binding(6) 
var<storage> input: type_11;
@group(0) @binding(7) 
var<storage, read_write> output: type_45;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_179_: bool;
    var phi_180_: bool;
    var phi_184_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_180_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_179_ = (param[0] > param_1[0]);
        } else {
            phi_179_ = false;
        }
        let _e14 = phi_179_;
        phi_180_ = _e14;
    }
    let _e16 = phi_180_;
    if _e16 {
        phi_184_ = param_1;
    } else {
        phi_184_ = param;
    }
    let _e18 = phi_184_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_203_: bool;
    var phi_204_: bool;
    var phi_208_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_204_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_203_ = (param_3[0] > param_2[0]);
        } else {
            phi_203_ = false;
        }
        let _e14 = phi_203_;
        phi_204_ = _e14;
    }
    let _e16 = phi_204_;
    if _e16 {
        phi_208_ = param_3;
    } else {
        phi_208_ = param_2;
    }
    let _e18 = phi_208_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_227_: bool;
    var phi_228_: bool;
    var phi_232_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_228_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_227_ = (param_4[0] > param_5[0]);
        } else {
            phi_227_ = false;
        }
        let _e14 = phi_227_;
        phi_228_ = _e14;
    }
    let _e16 = phi_228_;
    if _e16 {
        phi_232_ = param_5;
    } else {
        phi_232_ = param_4;
    }
    let _e18 = phi_232_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_251_: bool;
    var phi_252_: bool;
    var phi_256_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_252_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_251_ = (param_7[0] > param_6[0]);
        } else {
            phi_251_ = false;
        }
        let _e14 = phi_251_;
        phi_252_ = _e14;
    }
    let _e16 = phi_252_;
    if _e16 {
        phi_256_ = param_7;
    } else {
        phi_256_ = param_6;
    }
    let _e18 = phi_256_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_275_: bool;
    var phi_276_: bool;
    var phi_280_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_276_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_275_ = (param_8[0] > param_9[0]);
        } else {
            phi_275_ = false;
        }
        let _e14 = phi_275_;
        phi_276_ = _e14;
    }
    let _e16 = phi_276_;
    if _e16 {
        phi_280_ = param_9;
    } else {
        phi_280_ = param_8;
    }
    let _e18 = phi_280_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_299_: bool;
    var phi_300_: bool;
    var phi_304_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_300_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_299_ = (param_11[0] > param_10[0]);
        } else {
            phi_299_ = false;
        }
        let _e14 = phi_299_;
        phi_300_ = _e14;
    }
    let _e16 = phi_300_;
    if _e16 {
        phi_304_ = param_11;
    } else {
        phi_304_ = param_10;
    }
    let _e18 = phi_304_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_41;
    var local_1: type_41;
    var local_2: type_41;
    var phi_351_: u32;
    var phi_392_: u32;
    var phi_393_: u32;
    var phi_401_: u32;
    var phi_417_: u32;
    var phi_438_: u32;
    var phi_439_: u32;
    var phi_442_: type_9;
    var phi_443_: type_9;
    var phi_466_: type_9;
    var phi_507_: u32;
    var phi_508_: u32;
    var phi_516_: u32;
    var phi_528_: u32;
    var phi_613_: array<u32, 2>;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_822_: type_33;
    var phi_835_: type_9;
    var phi_838_: u32;
    var phi_836_: type_9;
    var phi_861_: type_9;
    var phi_927_: bool;
    var phi_928_: bool;
    var phi_929_: bool;
    var phi_933_: bool;
    var phi_951_: u32;
    var phi_952_: u32;
    var phi_953_: u32;
    var phi_839_: u32;
    var phi_956_: type_9;
    var phi_959_: u32;
    var phi_957_: type_9;
    var phi_982_: type_9;
    var phi_1102_: bool;
    var phi_1108_: bool;
    var phi_1114_: bool;
    var phi_1115_: bool;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1167_: bool;
    var phi_1283_: bool;
    var phi_1284_: bool;
    var phi_1321_: u32;
    var phi_1322_: u32;
    var phi_1327_: type_15;
    var phi_1330_: u32;
    var phi_1332_: u32;
    var phi_1353_: bool;
    var phi_1359_: type_16;
    var phi_1328_: type_15;
    var phi_1373_: type_16;
    var phi_1441_: bool;
    var phi_1442_: bool;
    var phi_1443_: bool;
    var phi_1444_: bool;
    var phi_1448_: bool;
    var phi_1449_: bool;
    var phi_1454_: u32;
    var phi_1455_: u32;
    var phi_1456_: u32;
    var phi_1457_: u32;
    var phi_1458_: bool;
    var phi_1331_: u32;
    var phi_1333_: u32;
    var phi_1459_: bool;
    var local_3: u32;
    var local_4: u32;
    var phi_1507_: bool;
    var phi_1508_: bool;
    var phi_1509_: bool;
    var phi_1510_: bool;
    var phi_1514_: bool;
    var phi_1515_: bool;
    var phi_1519_: bool;
    var phi_1523_: bool;
    var phi_1524_: bool;
    var phi_1528_: bool;
    var phi_1529_: bool;
    var phi_1533_: bool;
    var phi_1534_: bool;
    var phi_1658_: bool;
    var phi_1659_: bool;
    var phi_1752_: bool;
    var phi_1753_: bool;
    var phi_1847_: bool;
    var phi_1848_: bool;
    var phi_1941_: bool;
    var phi_1942_: bool;
    var phi_2037_: bool;
    var phi_2038_: bool;
    var phi_2131_: bool;
    var phi_2132_: bool;
    var phi_2136_: bool;
    var phi_2137_: bool;
    var phi_2138_: bool;
    var phi_2142_: bool;
    var phi_2143_: bool;
    var phi_2144_: bool;
    var phi_2145_: bool;
    var phi_2146_: bool;
    var phi_2150_: bool;
    var phi_2166_: type_9;
    var phi_2212_: u32;
    var phi_2213_: bool;
    var phi_960_: u32;
    var phi_2214_: bool;
    var phi_2221_: u32;
    var phi_2224_: type_9;
    var phi_2225_: type_9;
    var phi_2248_: type_9;
    var phi_2376_: bool;
    var phi_2382_: bool;
    var phi_2388_: bool;
    var phi_2389_: bool;
    var phi_2433_: bool;
    var phi_2434_: bool;
    var phi_2441_: bool;
    var phi_2557_: bool;
    var phi_2558_: bool;
    var phi_2595_: u32;
    var phi_2596_: u32;
    var phi_2601_: type_15;
    var phi_2604_: u32;
    var phi_2606_: u32;
    var phi_2627_: bool;
    var phi_2633_: type_16;
    var phi_2602_: type_15;
    var phi_2647_: type_16;
    var phi_2715_: bool;
    var phi_2716_: bool;
    var phi_2717_: bool;
    var phi_2718_: bool;
    var phi_2722_: bool;
    var phi_2723_: bool;
    var phi_2728_: u32;
    var phi_2729_: u32;
    var phi_2730_: u32;
    var phi_2731_: u32;
    var phi_2732_: bool;
    var phi_2605_: u32;
    var phi_2607_: u32;
    var phi_2733_: bool;
    var local_5: u32;
    var local_6: u32;
    var phi_2781_: bool;
    var phi_2782_: bool;
    var phi_2783_: bool;
    var phi_2784_: bool;
    var phi_2788_: bool;
    var phi_2789_: bool;
    var phi_2793_: bool;
    var phi_2797_: bool;
    var phi_2798_: bool;
    var phi_2802_: bool;
    var phi_2803_: bool;
    var phi_2807_: bool;
    var phi_2808_: bool;
    var phi_2932_: bool;
    var phi_2933_: bool;
    var phi_3026_: bool;
    var phi_3027_: bool;
    var phi_3121_: bool;
    var phi_3122_: bool;
    var phi_3215_: bool;
    var phi_3216_: bool;
    var phi_3311_: bool;
    var phi_3312_: bool;
    var phi_3405_: bool;
    var phi_3406_: bool;
    var phi_3410_: bool;
    var phi_3411_: bool;
    var phi_3412_: bool;
    var phi_3416_: bool;
    var phi_3417_: bool;
    var phi_3418_: bool;
    var phi_3419_: bool;
    var phi_3420_: bool;
    var phi_3424_: bool;
    var phi_3441_: array<u32, 3>;
    var phi_3442_: array<u32, 3>;
    var phi_3865_: f32;
    var phi_3872_: f32;
    var phi_3877_: f32;
    var phi_3884_: f32;
    var phi_3889_: f32;
    var phi_3902_: f32;
    var phi_3909_: f32;
    var phi_3914_: f32;
    var phi_3921_: f32;
    var phi_3926_: f32;
    var phi_3931_: f32;
    var phi_3948_: f32;
    var phi_3955_: f32;
    var phi_3960_: f32;
    var phi_3967_: f32;
    var phi_3972_: f32;
    var phi_3986_: f32;
    var phi_3993_: f32;
    var phi_3998_: f32;
    var phi_4005_: f32;
    var phi_4010_: f32;
    var phi_4015_: f32;
    var phi_4032_: f32;
    var phi_4039_: f32;
    var phi_4044_: f32;
    var phi_4051_: f32;
    var phi_4056_: f32;
    var phi_4070_: f32;
    var phi_4077_: f32;
    var phi_4082_: f32;
    var phi_4089_: f32;
    var phi_4094_: f32;
    var phi_4099_: f32;
    var phi_4130_: f32;
    var phi_4136_: f32;
    var phi_4143_: f32;
    var phi_4150_: f32;
    var phi_4156_: f32;
    var phi_4163_: f32;
    var phi_4169_: f32;
    var phi_4175_: f32;
    var phi_4181_: f32;
    var phi_4188_: f32;
    var phi_4195_: f32;
    var phi_4219_: f32;
    var phi_4224_: f32;
    var phi_4229_: f32;
    var phi_4234_: f32;
    var phi_4239_: f32;
    var phi_4244_: f32;
    var phi_4254_: f32;
    var phi_4457_: f32;
    var phi_4464_: f32;
    var phi_4469_: f32;
    var phi_4476_: f32;
    var phi_4481_: f32;
    var phi_4494_: f32;
    var phi_4501_: f32;
    var phi_4506_: f32;
    var phi_4513_: f32;
    var phi_4518_: f32;
    var phi_4523_: f32;
    var phi_4540_: f32;
    var phi_4547_: f32;
    var phi_4552_: f32;
    var phi_4559_: f32;
    var phi_4564_: f32;
    var phi_4578_: f32;
    var phi_4585_: f32;
    var phi_4590_: f32;
    var phi_4597_: f32;
    var phi_4602_: f32;
    var phi_4607_: f32;
    var phi_4624_: f32;
    var phi_4631_: f32;
    var phi_4636_: f32;
    var phi_4643_: f32;
    var phi_4648_: f32;
    var phi_4662_: f32;
    var phi_4669_: f32;
    var phi_4674_: f32;
    var phi_4681_: f32;
    var phi_4686_: f32;
    var phi_4691_: f32;
    var phi_4770_: f32;
    var phi_4775_: f32;
    var phi_4780_: f32;
    var phi_4785_: f32;
    var phi_4790_: f32;
    var phi_4795_: f32;
    var phi_4800_: f32;
    var phi_4805_: f32;
    var phi_4810_: f32;
    var phi_4815_: f32;
    var phi_4820_: f32;
    var phi_4825_: f32;
    var phi_4830_: f32;
    var phi_4835_: f32;
    var phi_4841_: f32;
    var phi_4847_: f32;
    var phi_4854_: f32;
    var phi_4865_: f32;
    var phi_4936_: f32;
    var phi_4941_: f32;
    var phi_4946_: f32;
    var phi_4951_: f32;
    var phi_4956_: f32;
    var phi_4961_: f32;
    var phi_4966_: f32;
    var phi_4971_: f32;
    var phi_4976_: f32;
    var phi_4981_: f32;
    var phi_4986_: f32;
    var phi_4991_: f32;
    var phi_4996_: f32;
    var phi_5001_: f32;
    var phi_5007_: f32;
    var phi_5013_: f32;
    var phi_5020_: f32;
    var phi_5031_: f32;
    var phi_5041_: f32;
    var phi_5223_: bool;
    var phi_5675_: f32;
    var phi_5682_: f32;
    var phi_5687_: f32;
    var phi_5694_: f32;
    var phi_5699_: f32;
    var phi_5712_: f32;
    var phi_5719_: f32;
    var phi_5724_: f32;
    var phi_5731_: f32;
    var phi_5736_: f32;
    var phi_5741_: f32;
    var phi_5758_: f32;
    var phi_5765_: f32;
    var phi_5770_: f32;
    var phi_5777_: f32;
    var phi_5782_: f32;
    var phi_5796_: f32;
    var phi_5803_: f32;
    var phi_5808_: f32;
    var phi_5815_: f32;
    var phi_5820_: f32;
    var phi_5825_: f32;
    var phi_5842_: f32;
    var phi_5849_: f32;
    var phi_5854_: f32;
    var phi_5861_: f32;
    var phi_5866_: f32;
    var phi_5880_: f32;
    var phi_5887_: f32;
    var phi_5892_: f32;
    var phi_5899_: f32;
    var phi_5904_: f32;
    var phi_5909_: f32;
    var phi_5940_: f32;
    var phi_5946_: f32;
    var phi_5953_: f32;
    var phi_5960_: f32;
    var phi_5966_: f32;
    var phi_5973_: f32;
    var phi_5979_: f32;
    var phi_5985_: f32;
    var phi_5991_: f32;
    var phi_5998_: f32;
    var phi_6005_: f32;
    var phi_6029_: f32;
    var phi_6034_: f32;
    var phi_6039_: f32;
    var phi_6044_: f32;
    var phi_6049_: f32;
    var phi_6054_: f32;
    var phi_6064_: f32;
    var phi_6267_: f32;
    var phi_6274_: f32;
    var phi_6279_: f32;
    var phi_6286_: f32;
    var phi_6291_: f32;
    var phi_6304_: f32;
    var phi_6311_: f32;
    var phi_6316_: f32;
    var phi_6323_: f32;
    var phi_6328_: f32;
    var phi_6333_: f32;
    var phi_6350_: f32;
    var phi_6357_: f32;
    var phi_6362_: f32;
    var phi_6369_: f32;
    var phi_6374_: f32;
    var phi_6388_: f32;
    var phi_6395_: f32;
    var phi_6400_: f32;
    var phi_6407_: f32;
    var phi_6412_: f32;
    var phi_6417_: f32;
    var phi_6434_: f32;
    var phi_6441_: f32;
    var phi_6446_: f32;
    var phi_6453_: f32;
    var phi_6458_: f32;
    var phi_6472_: f32;
    var phi_6479_: f32;
    var phi_6484_: f32;
    var phi_6491_: f32;
    var phi_6496_: f32;
    var phi_6501_: f32;
    var phi_6580_: f32;
    var phi_6585_: f32;
    var phi_6590_: f32;
    var phi_6595_: f32;
    var phi_6600_: f32;
    var phi_6605_: f32;
    var phi_6610_: f32;
    var phi_6615_: f32;
    var phi_6620_: f32;
    var phi_6625_: f32;
    var phi_6630_: f32;
    var phi_6635_: f32;
    var phi_6640_: f32;
    var phi_6645_: f32;
    var phi_6651_: f32;
    var phi_6657_: f32;
    var phi_6664_: f32;
    var phi_6675_: f32;
    var phi_6746_: f32;
    var phi_6751_: f32;
    var phi_6756_: f32;
    var phi_6761_: f32;
    var phi_6766_: f32;
    var phi_6771_: f32;
    var phi_6776_: f32;
    var phi_6781_: f32;
    var phi_6786_: f32;
    var phi_6791_: f32;
    var phi_6796_: f32;
    var phi_6801_: f32;
    var phi_6806_: f32;
    var phi_6811_: f32;
    var phi_6817_: f32;
    var phi_6823_: f32;
    var phi_6830_: f32;
    var phi_6841_: f32;
    var phi_6851_: f32;
    var phi_7033_: bool;
    var phi_7278_: f32;
    var phi_7285_: f32;
    var phi_7290_: f32;
    var phi_7297_: f32;
    var phi_7302_: f32;
    var phi_7315_: f32;
    var phi_7322_: f32;
    var phi_7327_: f32;
    var phi_7334_: f32;
    var phi_7339_: f32;
    var phi_7344_: f32;
    var phi_7361_: f32;
    var phi_7368_: f32;
    var phi_7373_: f32;
    var phi_7380_: f32;
    var phi_7385_: f32;
    var phi_7399_: f32;
    var phi_7406_: f32;
    var phi_7411_: f32;
    var phi_7418_: f32;
    var phi_7423_: f32;
    var phi_7428_: f32;
    var phi_7445_: f32;
    var phi_7452_: f32;
    var phi_7457_: f32;
    var phi_7464_: f32;
    var phi_7469_: f32;
    var phi_7483_: f32;
    var phi_7490_: f32;
    var phi_7495_: f32;
    var phi_7502_: f32;
    var phi_7507_: f32;
    var phi_7512_: f32;
    var phi_7543_: f32;
    var phi_7549_: f32;
    var phi_7556_: f32;
    var phi_7563_: f32;
    var phi_7569_: f32;
    var phi_7576_: f32;
    var phi_7582_: f32;
    var phi_7588_: f32;
    var phi_7594_: f32;
    var phi_7601_: f32;
    var phi_7608_: f32;
    var phi_7632_: f32;
    var phi_7637_: f32;
    var phi_7642_: f32;
    var phi_7647_: f32;
    var phi_7652_: f32;
    var phi_7657_: f32;
    var phi_7667_: f32;
    var phi_7870_: f32;
    var phi_7877_: f32;
    var phi_7882_: f32;
    var phi_7889_: f32;
    var phi_7894_: f32;
    var phi_7907_: f32;
    var phi_7914_: f32;
    var phi_7919_: f32;
    var phi_7926_: f32;
    var phi_7931_: f32;
    var phi_7936_: f32;
    var phi_7953_: f32;
    var phi_7960_: f32;
    var phi_7965_: f32;
    var phi_7972_: f32;
    var phi_7977_: f32;
    var phi_7991_: f32;
    var phi_7998_: f32;
    var phi_8003_: f32;
    var phi_8010_: f32;
    var phi_8015_: f32;
    var phi_8020_: f32;
    var phi_8037_: f32;
    var phi_8044_: f32;
    var phi_8049_: f32;
    var phi_8056_: f32;
    var phi_8061_: f32;
    var phi_8075_: f32;
    var phi_8082_: f32;
    var phi_8087_: f32;
    var phi_8094_: f32;
    var phi_8099_: f32;
    var phi_8104_: f32;
    var phi_8183_: f32;
    var phi_8188_: f32;
    var phi_8193_: f32;
    var phi_8198_: f32;
    var phi_8203_: f32;
    var phi_8208_: f32;
    var phi_8213_: f32;
    var phi_8218_: f32;
    var phi_8223_: f32;
    var phi_8228_: f32;
    var phi_8233_: f32;
    var phi_8238_: f32;
    var phi_8243_: f32;
    var phi_8248_: f32;
    var phi_8254_: f32;
    var phi_8260_: f32;
    var phi_8267_: f32;
    var phi_8278_: f32;
    var phi_8349_: f32;
    var phi_8354_: f32;
    var phi_8359_: f32;
    var phi_8364_: f32;
    var phi_8369_: f32;
    var phi_8374_: f32;
    var phi_8379_: f32;
    var phi_8384_: f32;
    var phi_8389_: f32;
    var phi_8394_: f32;
    var phi_8399_: f32;
    var phi_8404_: f32;
    var phi_8409_: f32;
    var phi_8414_: f32;
    var phi_8420_: f32;
    var phi_8426_: f32;
    var phi_8433_: f32;
    var phi_8444_: f32;
    var phi_8454_: f32;
    var phi_8636_: bool;
    var phi_8638_: bool;
    var phi_8640_: bool;
    var phi_8651_: bool;
    var phi_8652_: bool;
    var phi_8702_: type_9;
    var phi_8703_: type_9;
    var phi_8726_: type_9;
    var phi_8749_: u32;
    var phi_8804_: type_9;
    var phi_8823_: bool;
    var phi_8824_: bool;
    var local_7: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e69 = id_2;
    let _e70 = n_2;
    let _e71 = lane_2;
    let _e84 = ((_e69.y * _e70.x) + _e69.x);
    let _e87 = (_e70.x * _e70.y);
    let _e90 = params.member.member_1.member_2;
    let _e92 = input.member[0u];
    if (_e90 < _e92) {
        phi_351_ = _e90;
    } else {
        phi_351_ = _e92;
    }
    let _e95 = phi_351_;
    let _e96 = (_e71 / 32u);
    let _e97 = (_e71 % 32u);
    let _e100 = params.member.member_1.member_1;
    if (_e95 > _e100) {
        let _e104 = params.member.member_1.member_1;
        let _e105 = (_e95 - _e104);
        let _e108 = params.member.member_2.member_3;
        if (_e108 == 0u) {
            return;
        }
        let _e110 = (_e105 / _e108);
        if (_e108 == 0u) {
            return;
        }
        if ((_e105 % _e108) > 0u) {
            phi_392_ = (_e110 + 1u);
        } else {
            phi_392_ = _e110;
        }
        let _e116 = phi_392_;
        phi_393_ = _e116;
    } else {
        phi_393_ = 0u;
    }
    let _e118 = phi_393_;
    let _e121 = params.member.member_2.member_4;
    if (_e121 < _e118) {
        phi_401_ = _e121;
    } else {
        phi_401_ = _e118;
    }
    let _e124 = phi_401_;
    let _e125 = (_e124 / 4u);
    if ((_e124 % 4u) > 0u) {
        phi_417_ = (_e125 + 1u);
    } else {
        phi_417_ = _e125;
    }
    let _e130 = phi_417_;
    if (_e130 > _e84) {
        let _e132 = (_e130 - _e84);
        if (_e87 == 0u) {
            return;
        }
        let _e134 = (_e132 / _e87);
        if (_e87 == 0u) {
            return;
        }
        if ((_e132 % _e87) > 0u) {
            phi_438_ = (_e134 + 1u);
        } else {
            phi_438_ = _e134;
        }
        let _e140 = phi_438_;
        phi_439_ = _e140;
    } else {
        phi_439_ = 0u;
    }
    let _e142 = phi_439_;
    phi_442_ = type_9(0u, _e142);
    loop {
        let _e145 = phi_442_;
        if (_e145.member < _e145.member_1) {
            phi_443_ = type_9((_e145.member + 1u), _e145.member_1);
            phi_466_ = type_9(1u, _e145.member);
        } else {
            phi_443_ = _e145;
            phi_466_ = type_9(0u, type_9().member_1);
        }
        let _e157 = phi_443_;
        let _e159 = phi_466_;
        let _e163 = (bitcast<i32>(_e159.member) != 0i);
        if _e163 {
            let _e167 = (((_e84 + (_e159.member_1 * _e87)) * 4u) + _e96);
            let _e170 = params.member.member_1.member_1;
            if (_e95 > _e170) {
                let _e174 = params.member.member_1.member_1;
                let _e175 = (_e95 - _e174);
                let _e178 = params.member.member_2.member_3;
                if (_e178 == 0u) {
                    return;
                }
                let _e180 = (_e175 / _e178);
                if (_e178 == 0u) {
                    return;
                }
                if ((_e175 % _e178) > 0u) {
                    phi_507_ = (_e180 + 1u);
                } else {
                    phi_507_ = _e180;
                }
                let _e186 = phi_507_;
                phi_508_ = _e186;
            } else {
                phi_508_ = 0u;
            }
            let _e188 = phi_508_;
            let _e191 = params.member.member_2.member_4;
            if (_e191 < _e188) {
                phi_516_ = _e191;
            } else {
                phi_516_ = _e188;
            }
            let _e194 = phi_516_;
            let _e195 = (_e167 < _e194);
            let _e198 = params.member.member_1.member_1;
            if _e195 {
                let _e201 = params.member.member_2.member_3;
                phi_528_ = (_e167 * _e201);
            } else {
                phi_528_ = 0u;
            }
            let _e204 = phi_528_;
            let _e206 = (2u * (_e198 + _e204));
            let _e209 = input.member[(4u + _e206)];
            let _e212 = input.member[(_e206 + 5u)];
            if (_e71 < 8u) {
                atomicStore((&counters[_e71]), 0u);
            }
            workgroupBarrier();
            let _e220 = params.member.member_2.member[0u][1u];
            let _e221 = (_e220 + (_e209 * 32u));
            let _e227 = params.member.member_2.member[0u][1u];
            let _e228 = (_e227 + (_e212 * 32u));
            if (_e97 == 0u) {
                firsts[(2u * _e96)] = _e221;
                firsts[((2u * _e96) + 1u)] = _e228;
            }
            let _e237 = params.member.member_2.member_1;
            if (_e237 == 0u) {
                phi_613_ = array<u32, 2>(0u, 2u);
            } else {
                phi_613_ = array<u32, 2>(1u, 1u);
            }
            let _e240 = phi_613_;
            let _e243 = (_e71 / 32u);
            let _e244 = (_e71 % 32u);
            let _e248 = params.member.member_2.member_2;
            let _e252 = params.member.member_2.member[_e248][_e240[0]];
            let _e255 = nodes.member[(_e252 + _e209)];
            let _e271 = params.member.member_2.member_2;
            let _e275 = params.member.member_2.member[_e271][_e240[1]];
            let _e278 = nodes.member[(_e275 + _e212)];
            let _e294 = params.member.member_2.member_2;
            let _e301 = params.member.member_2.member[(_e294 - 1u)][_e240[0]];
            let _e304 = nodes.member[(_e301 + ((_e209 * 32u) + _e244))];
            let _e323 = params.member.member_2.member_2;
            let _e330 = params.member.member_2.member[(_e323 - 1u)][_e240[1]];
            let _e333 = nodes.member[(_e330 + ((_e212 * 32u) + _e244))];
            if _e195 {
                if ((((((_e333.member.x <= _e255.member_1.y) && (_e255.member.x <= _e333.member_1.y)) && (_e333.member.y <= _e255.member_2.x)) && (_e255.member.y <= _e333.member_2.x)) && (_e333.member_1.x <= _e255.member_2.y)) && (_e255.member_1.x <= _e333.member_2.y)) {
                    let _e359 = atomicAdd((&counters[_e243]), 1u);
                    let _e360 = ((_e243 * 32u) + _e359);
                    columns[_e360] = type_33(array<f32, 3>(_e333.member.x, _e333.member.y, _e333.member_1.x), array<f32, 3>(_e333.member_1.y, _e333.member_2.x, _e333.member_2.y));
                    names[_e360] = _e244;
                }
            }
            workgroupBarrier();
            if _e195 {
                if ((((((_e304.member.x <= _e278.member_1.y) && (_e278.member.x <= _e304.member_1.y)) && (_e304.member.y <= _e278.member_2.x)) && (_e278.member.y <= _e304.member_2.x)) && (_e304.member_1.x <= _e278.member_2.y)) && (_e278.member_1.x <= _e304.member_2.y)) {
                    phi_817_ = false;
                } else {
                    phi_817_ = true;
                }
                let _e378 = phi_817_;
                phi_818_ = _e378;
            } else {
                phi_818_ = true;
            }
            let _e380 = phi_818_;
            if _e380 {
                phi_822_ = type_33(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_822_ = type_33(array<f32, 3>(_e304.member.x, _e304.member.y, _e304.member_1.x), array<f32, 3>(_e304.member_1.y, _e304.member_2.x, _e304.member_2.y));
            }
            let _e382 = phi_822_;
            let _e384 = (_e71 / 32u);
            let _e385 = (_e71 % 32u);
            let _e387 = atomicLoad((&counters[_e384]));
            phi_835_ = type_9(0u, _e387);
            phi_838_ = 0u;
            loop {
                let _e390 = phi_835_;
                let _e392 = phi_838_;
                local_7 = _e392;
                if (_e390.member < _e390.member_1) {
                    phi_836_ = type_9((_e390.member + 1u), _e390.member_1);
                    phi_861_ = type_9(1u, _e390.member);
                } else {
                    phi_836_ = _e390;
                    phi_861_ = type_9(0u, type_9().member_1);
                }
                let _e404 = phi_836_;
                let _e406 = phi_861_;
                let _e410 = (bitcast<i32>(_e406.member) != 0i);
                if _e410 {
                    let _e414 = names[((_e384 * 32u) + _e406.member_1)];
                    let _e418 = columns[((_e384 * 32u) + _e406.member_1)];
                    if ((((((_e382.member[0] <= _e418.member_1[0]) && (_e418.member[0] <= _e382.member_1[0])) && (_e382.member[1] <= _e418.member_1[1])) && (_e418.member[1] <= _e382.member_1[1])) && (_e382.member[2] <= _e418.member_1[2])) && (_e418.member[2] <= _e382.member_1[2])) {
                        if (_e209 == _e212) {
                            let _e450 = (_e385 < _e414);
                            if _e450 {
                                phi_927_ = bool();
                            } else {
                                phi_927_ = false;
                            }
                            let _e452 = phi_927_;
                            phi_928_ = _e452;
                            phi_929_ = _e450;
                        } else {
                            phi_928_ = bool();
                            phi_929_ = true;
                        }
                        let _e454 = phi_928_;
                        let _e456 = phi_929_;
                        if _e456 {
                            phi_933_ = true;
                        } else {
                            phi_933_ = _e454;
                        }
                        let _e458 = phi_933_;
                        if _e458 {
                            let _e460 = atomicAdd((&counters[4u]), 1u);
                            if (_e460 < 2048u) {
                                hits[_e460] = (((_e384 << bitcast<u32>(10i)) | (_e385 << bitcast<u32>(5i))) | _e414);
                                phi_951_ = _e392;
                            } else {
                                phi_951_ = (_e392 | (1u << bitcast<u32>((_e406.member_1 & 31u))));
                            }
                            let _e474 = phi_951_;
                            phi_952_ = _e474;
                        } else {
                            phi_952_ = _e392;
                        }
                        let _e476 = phi_952_;
                        phi_953_ = _e476;
                    } else {
                        phi_953_ = _e392;
                    }
                    let _e478 = phi_953_;
                    phi_839_ = _e478;
                } else {
                    phi_839_ = u32();
                }
                let _e480 = phi_839_;
                continue;
                continuing {
                    phi_835_ = _e404;
                    phi_838_ = _e480;
                    break if !(_e410);
                }
            }
            phi_956_ = type_9(0u, 32u);
            let _e4995 = local_7;
            phi_959_ = _e4995;
            loop {
                let _e483 = phi_956_;
                let _e485 = phi_959_;
                if (_e483.member < _e483.member_1) {
                    phi_957_ = type_9((_e483.member + 1u), _e483.member_1);
                    phi_982_ = type_9(1u, _e483.member);
                } else {
                    phi_957_ = _e483;
                    phi_982_ = type_9(0u, type_9().member_1);
                }
                let _e497 = phi_957_;
                let _e499 = phi_982_;
                if (bitcast<i32>(_e499.member) != 0i) {
                    if (_e485 == 0u) {
                        phi_2212_ = u32();
                        phi_2213_ = false;
                    } else {
                        let _e510 = names[((_e96 * 32u) + select(firstTrailingBit(_e485), 32u, (_e485 == 0u)))];
                        let _e513 = (_e221 + _e97);
                        let _e514 = (_e228 + _e510);
                        let _e516 = leaves.member[_e513];
                        let _e518 = leaves.member[_e514];
                        let _e520 = nodes.member[_e513];
                        let _e534 = nodes.member[_e514];
                        let _e549 = params.member.member.member_1;
                        if ((_e549 & 1u) != 0u) {
                            if (_e518.member[0] == _e516.member[0]) {
                                phi_1102_ = true;
                            } else {
                                phi_1102_ = (_e518.member[0] == _e516.member[1]);
                            }
                            let _e563 = phi_1102_;
                            if (_e518.member[1] == _e516.member[0]) {
                                phi_1108_ = true;
                            } else {
                                phi_1108_ = (_e518.member[1] == _e516.member[1]);
                            }
                            let _e567 = phi_1108_;
                            if (_e563 || _e567) {
                                phi_1114_ = false;
                            } else {
                                phi_1114_ = true;
                            }
                            let _e570 = phi_1114_;
                            phi_1115_ = _e570;
                        } else {
                            phi_1115_ = true;
                        }
                        let _e572 = phi_1115_;
                        if _e572 {
                            let _e574 = params.member.member.member_1;
                            if ((_e574 & 2u) != 0u) {
                                let _e580 = bodies.member[_e516.member[0]];
                                let _e584 = bodies.member[_e518.member[0]];
                                if ((_e580 / 4u) != (_e584 / 4u)) {
                                    phi_1160_ = true;
                                } else {
                                    if ((_e580 & 2u) == 0u) {
                                        phi_1159_ = false;
                                    } else {
                                        phi_1159_ = true;
                                    }
                                    let _e591 = phi_1159_;
                                    phi_1160_ = _e591;
                                }
                                let _e593 = phi_1160_;
                                if _e593 {
                                    phi_1167_ = (((_e580 & _e584) & 1u) == 0u);
                                } else {
                                    phi_1167_ = false;
                                }
                                let _e598 = phi_1167_;
                                if _e598 {
                                    let _e600 = params.member.member.member_1;
                                    if ((_e600 & 4u) != 0u) {
                                        let _e605 = params.member.member.member[0u];
                                        let _e607 = bodies.member[_e605];
                                        let _e610 = bodies.member[(_e605 + 1u)];
                                        let _e615 = ((_e605 + 4u) + (2u * (_e580 >> bitcast<u32>(2i))));
                                        let _e620 = ((_e605 + 4u) + (2u * (_e584 >> bitcast<u32>(2i))));
                                        let _e622 = bodies.member[_e615];
                                        let _e624 = bodies.member[_e620];
                                        let _e633 = bodies.member[((((_e605 + 4u) + (2u * _e607)) + (_e622 * _e610)) + (_e624 / 32u))];
                                        let _e636 = bodies.member[(_e615 + 1u)];
                                        let _e639 = bodies.member[(_e620 + 1u)];
                                        if (_e636 == _e639) {
                                            if (((_e633 >> bitcast<u32>(((_e624 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_1283_ = true;
                                            } else {
                                                phi_1283_ = ((_e580 >> bitcast<u32>(2i)) == (_e584 >> bitcast<u32>(2i)));
                                            }
                                            let _e653 = phi_1283_;
                                            phi_1284_ = _e653;
                                        } else {
                                            phi_1284_ = false;
                                        }
                                        let _e655 = phi_1284_;
                                        if _e655 {
                                            let _e660 = bodies.member[(_e605 + 2u)];
                                            let _e663 = bodies.member[(_e605 + 3u)];
                                            let _e664 = (_e663 + _e605);
                                            if (_e518.member_1 < _e516.member_1) {
                                                phi_1321_ = _e516.member_1;
                                                phi_1322_ = _e518.member_1;
                                            } else {
                                                phi_1321_ = _e518.member_1;
                                                phi_1322_ = _e516.member_1;
                                            }
                                            let _e667 = phi_1321_;
                                            let _e669 = phi_1322_;
                                            phi_1327_ = type_15(0i, 32i);
                                            phi_1330_ = _e660;
                                            phi_1332_ = 0u;
                                            loop {
                                                let _e671 = phi_1327_;
                                                let _e673 = phi_1330_;
                                                let _e675 = phi_1332_;
                                                local_3 = _e675;
                                                local_4 = _e675;
                                                if (_e671.member < _e671.member_1) {
                                                    let _e682 = (_e671.member + 1i);
                                                    if ((false == (_e682 > _e671.member)) != false) {
                                                        phi_1353_ = true;
                                                    } else {
                                                        phi_1353_ = false;
                                                    }
                                                    let _e687 = phi_1353_;
                                                    if _e687 {
                                                        phi_1359_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_1359_ = type_16(1u, _e682);
                                                    }
                                                    let _e692 = phi_1359_;
                                                    phi_1328_ = type_15(_e692.member_1, _e671.member_1);
                                                    phi_1373_ = type_16(1u, _e671.member);
                                                } else {
                                                    phi_1328_ = _e671;
                                                    phi_1373_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e698 = phi_1328_;
                                                let _e700 = phi_1373_;
                                                if (bitcast<i32>(_e700.member) != 0i) {
                                                    if (_e675 >= _e673) {
                                                        phi_1456_ = u32();
                                                        phi_1457_ = u32();
                                                        phi_1458_ = false;
                                                    } else {
                                                        let _e707 = (_e675 + ((_e673 - _e675) / 2u));
                                                        let _e709 = (_e664 + (3u * _e707));
                                                        let _e711 = bodies.member[_e709];
                                                        let _e714 = bodies.member[(_e709 + 1u)];
                                                        let _e717 = bodies.member[(_e709 + 2u)];
                                                        if (_e711 < 1u) {
                                                            phi_1449_ = true;
                                                        } else {
                                                            if (_e711 == 1u) {
                                                                if (_e714 < _e669) {
                                                                    phi_1443_ = false;
                                                                } else {
                                                                    if (_e714 == _e669) {
                                                                        if (_e717 < _e667) {
                                                                            phi_1441_ = false;
                                                                        } else {
                                                                            phi_1441_ = true;
                                                                        }
                                                                        let _e724 = phi_1441_;
                                                                        phi_1442_ = _e724;
                                                                    } else {
                                                                        phi_1442_ = true;
                                                                    }
                                                                    let _e726 = phi_1442_;
                                                                    phi_1443_ = _e726;
                                                                }
                                                                let _e728 = phi_1443_;
                                                                phi_1444_ = _e728;
                                                            } else {
                                                                phi_1444_ = true;
                                                            }
                                                            let _e730 = phi_1444_;
                                                            if _e730 {
                                                                phi_1448_ = false;
                                                            } else {
                                                                phi_1448_ = true;
                                                            }
                                                            let _e732 = phi_1448_;
                                                            phi_1449_ = _e732;
                                                        }
                                                        let _e734 = phi_1449_;
                                                        if _e734 {
                                                            phi_1454_ = _e673;
                                                            phi_1455_ = (_e707 + 1u);
                                                        } else {
                                                            phi_1454_ = _e707;
                                                            phi_1455_ = _e675;
                                                        }
                                                        let _e737 = phi_1454_;
                                                        let _e739 = phi_1455_;
                                                        phi_1456_ = _e737;
                                                        phi_1457_ = _e739;
                                                        phi_1458_ = true;
                                                    }
                                                    let _e741 = phi_1456_;
                                                    let _e743 = phi_1457_;
                                                    let _e745 = phi_1458_;
                                                    phi_1331_ = _e741;
                                                    phi_1333_ = _e743;
                                                    phi_1459_ = _e745;
                                                } else {
                                                    phi_1331_ = u32();
                                                    phi_1333_ = u32();
                                                    phi_1459_ = false;
                                                }
                                                let _e747 = phi_1331_;
                                                let _e749 = phi_1333_;
                                                let _e751 = phi_1459_;
                                                continue;
                                                continuing {
                                                    phi_1327_ = _e698;
                                                    phi_1330_ = _e747;
                                                    phi_1332_ = _e749;
                                                    break if !(_e751);
                                                }
                                            }
                                            let _e754 = local_3;
                                            if (_e754 < _e660) {
                                                let _e757 = local_4;
                                                let _e759 = (_e664 + (3u * _e757));
                                                let _e761 = bodies.member[_e759];
                                                if (_e761 == 1u) {
                                                    let _e765 = bodies.member[(_e759 + 1u)];
                                                    if (_e765 == _e669) {
                                                        let _e769 = bodies.member[(_e759 + 2u)];
                                                        phi_1507_ = (_e769 == _e667);
                                                        phi_1508_ = false;
                                                    } else {
                                                        phi_1507_ = bool();
                                                        phi_1508_ = true;
                                                    }
                                                    let _e772 = phi_1507_;
                                                    let _e774 = phi_1508_;
                                                    phi_1509_ = _e772;
                                                    phi_1510_ = _e774;
                                                } else {
                                                    phi_1509_ = bool();
                                                    phi_1510_ = true;
                                                }
                                                let _e776 = phi_1509_;
                                                let _e778 = phi_1510_;
                                                if _e778 {
                                                    phi_1514_ = false;
                                                } else {
                                                    phi_1514_ = _e776;
                                                }
                                                let _e780 = phi_1514_;
                                                phi_1515_ = _e780;
                                            } else {
                                                phi_1515_ = false;
                                            }
                                            let _e782 = phi_1515_;
                                            phi_1519_ = _e782;
                                        } else {
                                            phi_1519_ = true;
                                        }
                                        let _e784 = phi_1519_;
                                        if _e784 {
                                            phi_1523_ = false;
                                        } else {
                                            phi_1523_ = true;
                                        }
                                        let _e786 = phi_1523_;
                                        phi_1524_ = _e786;
                                    } else {
                                        phi_1524_ = true;
                                    }
                                    let _e788 = phi_1524_;
                                    if _e788 {
                                        phi_1528_ = false;
                                    } else {
                                        phi_1528_ = true;
                                    }
                                    let _e790 = phi_1528_;
                                    phi_1529_ = _e790;
                                } else {
                                    phi_1529_ = true;
                                }
                                let _e792 = phi_1529_;
                                if _e792 {
                                    phi_1533_ = false;
                                } else {
                                    phi_1533_ = true;
                                }
                                let _e794 = phi_1533_;
                                phi_1534_ = _e794;
                            } else {
                                phi_1534_ = true;
                            }
                            let _e796 = phi_1534_;
                            if _e796 {
                                let _e798 = params.member.member.member_1;
                                if ((_e798 & 32u) != 0u) {
                                    let _e802 = params.member.member.member_6;
                                    let _e819 = (((((_e520.member_1.y - _e534.member.x) > _e802) && ((_e534.member_1.y - _e520.member.x) > _e802)) && (((_e520.member_2.x - _e534.member.y) > _e802) && ((_e534.member_2.x - _e520.member.y) > _e802))) && (((_e520.member_2.y - _e534.member_1.x) > _e802) && ((_e534.member_2.y - _e520.member_1.x) > _e802)));
                                    if _e819 {
                                        phi_2136_ = bool();
                                    } else {
                                        let _e823 = keys.member[_e516.member[0]];
                                        let _e828 = keys.member[_e516.member[1]];
                                        let _e830 = function_(_e823[0], _e828[0]);
                                        let _e834 = keys.member[_e516.member[2]];
                                        let _e836 = function_(_e830, _e834[0]);
                                        let _e840 = keys.member[_e518.member[0]];
                                        let _e845 = keys.member[_e518.member[1]];
                                        let _e847 = function_1(_e840[3], _e845[3]);
                                        let _e851 = keys.member[_e518.member[2]];
                                        let _e853 = function_1(_e847, _e851[3]);
                                        if (_e836[1] > _e853[1]) {
                                            phi_1659_ = true;
                                        } else {
                                            if (_e836[1] == _e853[1]) {
                                                phi_1658_ = (_e836[0] > _e853[0]);
                                            } else {
                                                phi_1658_ = false;
                                            }
                                            let _e864 = phi_1658_;
                                            phi_1659_ = _e864;
                                        }
                                        let _e866 = phi_1659_;
                                        let _e871 = keys.member[_e518.member[0]];
                                        let _e876 = keys.member[_e518.member[1]];
                                        let _e878 = function_(_e871[0], _e876[0]);
                                        let _e882 = keys.member[_e518.member[2]];
                                        let _e884 = function_(_e878, _e882[0]);
                                        let _e888 = keys.member[_e516.member[0]];
                                        let _e893 = keys.member[_e516.member[1]];
                                        let _e895 = function_1(_e888[3], _e893[3]);
                                        let _e899 = keys.member[_e516.member[2]];
                                        let _e901 = function_1(_e895, _e899[3]);
                                        if (_e884[1] > _e901[1]) {
                                            phi_1753_ = true;
                                        } else {
                                            if (_e884[1] == _e901[1]) {
                                                phi_1752_ = (_e884[0] > _e901[0]);
                                            } else {
                                                phi_1752_ = false;
                                            }
                                            let _e912 = phi_1752_;
                                            phi_1753_ = _e912;
                                        }
                                        let _e914 = phi_1753_;
                                        let _e920 = keys.member[_e516.member[0]];
                                        let _e925 = keys.member[_e516.member[1]];
                                        let _e927 = function_2(_e920[1], _e925[1]);
                                        let _e931 = keys.member[_e516.member[2]];
                                        let _e933 = function_2(_e927, _e931[1]);
                                        let _e937 = keys.member[_e518.member[0]];
                                        let _e942 = keys.member[_e518.member[1]];
                                        let _e944 = function_3(_e937[4], _e942[4]);
                                        let _e948 = keys.member[_e518.member[2]];
                                        let _e950 = function_3(_e944, _e948[4]);
                                        if (_e933[1] > _e950[1]) {
                                            phi_1848_ = true;
                                        } else {
                                            if (_e933[1] == _e950[1]) {
                                                phi_1847_ = (_e933[0] > _e950[0]);
                                            } else {
                                                phi_1847_ = false;
                                            }
                                            let _e961 = phi_1847_;
                                            phi_1848_ = _e961;
                                        }
                                        let _e963 = phi_1848_;
                                        let _e968 = keys.member[_e518.member[0]];
                                        let _e973 = keys.member[_e518.member[1]];
                                        let _e975 = function_2(_e968[1], _e973[1]);
                                        let _e979 = keys.member[_e518.member[2]];
                                        let _e981 = function_2(_e975, _e979[1]);
                                        let _e985 = keys.member[_e516.member[0]];
                                        let _e990 = keys.member[_e516.member[1]];
                                        let _e992 = function_3(_e985[4], _e990[4]);
                                        let _e996 = keys.member[_e516.member[2]];
                                        let _e998 = function_3(_e992, _e996[4]);
                                        if (_e981[1] > _e998[1]) {
                                            phi_1942_ = true;
                                        } else {
                                            if (_e981[1] == _e998[1]) {
                                                phi_1941_ = (_e981[0] > _e998[0]);
                                            } else {
                                                phi_1941_ = false;
                                            }
                                            let _e1009 = phi_1941_;
                                            phi_1942_ = _e1009;
                                        }
                                        let _e1011 = phi_1942_;
                                        let _e1018 = keys.member[_e516.member[0]];
                                        let _e1023 = keys.member[_e516.member[1]];
                                        let _e1025 = function_4(_e1018[2], _e1023[2]);
                                        let _e1029 = keys.member[_e516.member[2]];
                                        let _e1031 = function_4(_e1025, _e1029[2]);
                                        let _e1035 = keys.member[_e518.member[0]];
                                        let _e1040 = keys.member[_e518.member[1]];
                                        let _e1042 = function_5(_e1035[5], _e1040[5]);
                                        let _e1046 = keys.member[_e518.member[2]];
                                        let _e1048 = function_5(_e1042, _e1046[5]);
                                        if (_e1031[1] > _e1048[1]) {
                                            phi_2038_ = true;
                                        } else {
                                            if (_e1031[1] == _e1048[1]) {
                                                phi_2037_ = (_e1031[0] > _e1048[0]);
                                            } else {
                                                phi_2037_ = false;
                                            }
                                            let _e1059 = phi_2037_;
                                            phi_2038_ = _e1059;
                                        }
                                        let _e1061 = phi_2038_;
                                        let _e1066 = keys.member[_e518.member[0]];
                                        let _e1071 = keys.member[_e518.member[1]];
                                        let _e1073 = function_4(_e1066[2], _e1071[2]);
                                        let _e1077 = keys.member[_e518.member[2]];
                                        let _e1079 = function_4(_e1073, _e1077[2]);
                                        let _e1083 = keys.member[_e516.member[0]];
                                        let _e1088 = keys.member[_e516.member[1]];
                                        let _e1090 = function_5(_e1083[5], _e1088[5]);
                                        let _e1094 = keys.member[_e516.member[2]];
                                        let _e1096 = function_5(_e1090, _e1094[5]);
                                        if (_e1079[1] > _e1096[1]) {
                                            phi_2132_ = true;
                                        } else {
                                            if (_e1079[1] == _e1096[1]) {
                                                phi_2131_ = (_e1079[0] > _e1096[0]);
                                            } else {
                                                phi_2131_ = false;
                                            }
                                            let _e1107 = phi_2131_;
                                            phi_2132_ = _e1107;
                                        }
                                        let _e1109 = phi_2132_;
                                        phi_2136_ = (((!(_e866) && !(_e914)) && (!(_e963) && !(_e1011))) && (!(_e1061) && !(_e1109)));
                                    }
                                    let _e1114 = phi_2136_;
                                    phi_2137_ = _e1114;
                                    phi_2138_ = _e819;
                                } else {
                                    phi_2137_ = bool();
                                    phi_2138_ = true;
                                }
                                let _e1116 = phi_2137_;
                                let _e1118 = phi_2138_;
                                if _e1118 {
                                    phi_2142_ = false;
                                } else {
                                    phi_2142_ = true;
                                }
                                let _e1120 = phi_2142_;
                                phi_2143_ = _e1116;
                                phi_2144_ = _e1120;
                            } else {
                                phi_2143_ = false;
                                phi_2144_ = true;
                            }
                            let _e1122 = phi_2143_;
                            let _e1124 = phi_2144_;
                            phi_2145_ = _e1122;
                            phi_2146_ = _e1124;
                        } else {
                            phi_2145_ = false;
                            phi_2146_ = true;
                        }
                        let _e1126 = phi_2145_;
                        let _e1128 = phi_2146_;
                        if _e1128 {
                            phi_2150_ = _e1126;
                        } else {
                            phi_2150_ = true;
                        }
                        let _e1130 = phi_2150_;
                        if _e1130 {
                            if (_e516.member_1 < _e518.member_1) {
                                phi_2166_ = type_9(_e516.member_1, _e518.member_1);
                            } else {
                                phi_2166_ = type_9(_e518.member_1, _e516.member_1);
                            }
                            let _e1137 = phi_2166_;
                            let _e1142 = params.member.member_1.member_3;
                            let _e1144 = atomicAdd((&output.member[0u]), 1u);
                            if ((_e1144 + 1u) < _e1144) {
                                let _e1148 = atomicAdd((&output.member[2u]), 1u);
                            }
                            if (_e1144 < _e1142) {
                                let _e1150 = (2u * _e1144);
                                atomicStore((&output.member[(4u + _e1150)]), _e1137.member);
                                atomicStore((&output.member[(_e1150 + 5u)]), _e1137.member_1);
                            }
                            let _e1156 = atomicAdd((&output.member[1u]), 1u);
                            if ((_e1156 + 1u) < _e1156) {
                                let _e1160 = atomicAdd((&output.member[3u]), 1u);
                            }
                        }
                        phi_2212_ = (_e485 & (_e485 - 1u));
                        phi_2213_ = true;
                    }
                    let _e1162 = phi_2212_;
                    let _e1164 = phi_2213_;
                    phi_960_ = _e1162;
                    phi_2214_ = _e1164;
                } else {
                    phi_960_ = u32();
                    phi_2214_ = false;
                }
                let _e1166 = phi_960_;
                let _e1168 = phi_2214_;
                continue;
                continuing {
                    phi_956_ = _e497;
                    phi_959_ = _e1166;
                    break if !(_e1168);
                }
            }
            workgroupBarrier();
            let _e1171 = atomicLoad((&counters[4u]));
            if (2048u < _e1171) {
                phi_2221_ = 2048u;
            } else {
                phi_2221_ = _e1171;
            }
            let _e1174 = phi_2221_;
            phi_2224_ = type_9(0u, 16u);
            loop {
                let _e1176 = phi_2224_;
                if (_e1176.member < _e1176.member_1) {
                    phi_2225_ = type_9((_e1176.member + 1u), _e1176.member_1);
                    phi_2248_ = type_9(1u, _e1176.member);
                } else {
                    phi_2225_ = _e1176;
                    phi_2248_ = type_9(0u, type_9().member_1);
                }
                let _e1188 = phi_2225_;
                let _e1190 = phi_2248_;
                if (bitcast<i32>(_e1190.member) != 0i) {
                    let _e1196 = (_e71 + (_e1190.member_1 * 128u));
                    if (_e1196 >= _e1174) {
                        phi_8651_ = false;
                    } else {
                        let _e1199 = hits[_e1196];
                        let _e1202 = ((_e1199 >> bitcast<u32>(10i)) & 3u);
                        let _e1209 = firsts[(2u * _e1202)];
                        let _e1210 = (_e1209 + ((_e1199 >> bitcast<u32>(5i)) & 31u));
                        let _e1214 = firsts[((2u * _e1202) + 1u)];
                        let _e1215 = (_e1214 + (_e1199 & 31u));
                        let _e1217 = leaves.member[_e1210];
                        let _e1219 = leaves.member[_e1215];
                        let _e1221 = nodes.member[_e1210];
                        let _e1235 = nodes.member[_e1215];
                        let _e1250 = params.member.member.member_1;
                        if ((_e1250 & 1u) != 0u) {
                            if (_e1219.member[0] == _e1217.member[0]) {
                                phi_2376_ = true;
                            } else {
                                phi_2376_ = (_e1219.member[0] == _e1217.member[1]);
                            }
                            let _e1264 = phi_2376_;
                            if (_e1219.member[1] == _e1217.member[0]) {
                                phi_2382_ = true;
                            } else {
                                phi_2382_ = (_e1219.member[1] == _e1217.member[1]);
                            }
                            let _e1268 = phi_2382_;
                            if (_e1264 || _e1268) {
                                phi_2388_ = false;
                            } else {
                                phi_2388_ = true;
                            }
                            let _e1271 = phi_2388_;
                            phi_2389_ = _e1271;
                        } else {
                            phi_2389_ = true;
                        }
                        let _e1273 = phi_2389_;
                        if _e1273 {
                            let _e1275 = params.member.member.member_1;
                            if ((_e1275 & 2u) != 0u) {
                                let _e1281 = bodies.member[_e1217.member[0]];
                                let _e1285 = bodies.member[_e1219.member[0]];
                                if ((_e1281 / 4u) != (_e1285 / 4u)) {
                                    phi_2434_ = true;
                                } else {
                                    if ((_e1281 & 2u) == 0u) {
                                        phi_2433_ = false;
                                    } else {
                                        phi_2433_ = true;
                                    }
                                    let _e1292 = phi_2433_;
                                    phi_2434_ = _e1292;
                                }
                                let _e1294 = phi_2434_;
                                if _e1294 {
                                    phi_2441_ = (((_e1281 & _e1285) & 1u) == 0u);
                                } else {
                                    phi_2441_ = false;
                                }
                                let _e1299 = phi_2441_;
                                if _e1299 {
                                    let _e1301 = params.member.member.member_1;
                                    if ((_e1301 & 4u) != 0u) {
                                        let _e1306 = params.member.member.member[0u];
                                        let _e1308 = bodies.member[_e1306];
                                        let _e1311 = bodies.member[(_e1306 + 1u)];
                                        let _e1316 = ((_e1306 + 4u) + (2u * (_e1281 >> bitcast<u32>(2i))));
                                        let _e1321 = ((_e1306 + 4u) + (2u * (_e1285 >> bitcast<u32>(2i))));
                                        let _e1323 = bodies.member[_e1316];
                                        let _e1325 = bodies.member[_e1321];
                                        let _e1334 = bodies.member[((((_e1306 + 4u) + (2u * _e1308)) + (_e1323 * _e1311)) + (_e1325 / 32u))];
                                        let _e1337 = bodies.member[(_e1316 + 1u)];
                                        let _e1340 = bodies.member[(_e1321 + 1u)];
                                        if (_e1337 == _e1340) {
                                            if (((_e1334 >> bitcast<u32>(((_e1325 % 32u) & 31u))) & 1u) == 1u) {
                                                phi_2557_ = true;
                                            } else {
                                                phi_2557_ = ((_e1281 >> bitcast<u32>(2i)) == (_e1285 >> bitcast<u32>(2i)));
                                            }
                                            let _e1354 = phi_2557_;
                                            phi_2558_ = _e1354;
                                        } else {
                                            phi_2558_ = false;
                                        }
                                        let _e1356 = phi_2558_;
                                        if _e1356 {
                                            let _e1361 = bodies.member[(_e1306 + 2u)];
                                            let _e1364 = bodies.member[(_e1306 + 3u)];
                                            let _e1365 = (_e1364 + _e1306);
                                            if (_e1219.member_1 < _e1217.member_1) {
                                                phi_2595_ = _e1217.member_1;
                                                phi_2596_ = _e1219.member_1;
                                            } else {
                                                phi_2595_ = _e1219.member_1;
                                                phi_2596_ = _e1217.member_1;
                                            }
                                            let _e1368 = phi_2595_;
                                            let _e1370 = phi_2596_;
                                            phi_2601_ = type_15(0i, 32i);
                                            phi_2604_ = _e1361;
                                            phi_2606_ = 0u;
                                            loop {
                                                let _e1372 = phi_2601_;
                                                let _e1374 = phi_2604_;
                                                let _e1376 = phi_2606_;
                                                local_5 = _e1376;
                                                local_6 = _e1376;
                                                if (_e1372.member < _e1372.member_1) {
                                                    let _e1383 = (_e1372.member + 1i);
                                                    if ((false == (_e1383 > _e1372.member)) != false) {
                                                        phi_2627_ = true;
                                                    } else {
                                                        phi_2627_ = false;
                                                    }
                                                    let _e1388 = phi_2627_;
                                                    if _e1388 {
                                                        phi_2633_ = type_16(0u, type_16().member_1);
                                                    } else {
                                                        phi_2633_ = type_16(1u, _e1383);
                                                    }
                                                    let _e1393 = phi_2633_;
                                                    phi_2602_ = type_15(_e1393.member_1, _e1372.member_1);
                                                    phi_2647_ = type_16(1u, _e1372.member);
                                                } else {
                                                    phi_2602_ = _e1372;
                                                    phi_2647_ = type_16(0u, type_16().member_1);
                                                }
                                                let _e1399 = phi_2602_;
                                                let _e1401 = phi_2647_;
                                                if (bitcast<i32>(_e1401.member) != 0i) {
                                                    if (_e1376 >= _e1374) {
                                                        phi_2730_ = u32();
                                                        phi_2731_ = u32();
                                                        phi_2732_ = false;
                                                    } else {
                                                        let _e1408 = (_e1376 + ((_e1374 - _e1376) / 2u));
                                                        let _e1410 = (_e1365 + (3u * _e1408));
                                                        let _e1412 = bodies.member[_e1410];
                                                        let _e1415 = bodies.member[(_e1410 + 1u)];
                                                        let _e1418 = bodies.member[(_e1410 + 2u)];
                                                        if (_e1412 < 1u) {
                                                            phi_2723_ = true;
                                                        } else {
                                                            if (_e1412 == 1u) {
                                                                if (_e1415 < _e1370) {
                                                                    phi_2717_ = false;
                                                                } else {
                                                                    if (_e1415 == _e1370) {
                                                                        if (_e1418 < _e1368) {
                                                                            phi_2715_ = false;
                                                                        } else {
                                                                            phi_2715_ = true;
                                                                        }
                                                                        let _e1425 = phi_2715_;
                                                                        phi_2716_ = _e1425;
                                                                    } else {
                                                                        phi_2716_ = true;
                                                                    }
                                                                    let _e1427 = phi_2716_;
                                                                    phi_2717_ = _e1427;
                                                                }
                                                                let _e1429 = phi_2717_;
                                                                phi_2718_ = _e1429;
                                                            } else {
                                                                phi_2718_ = true;
                                                            }
                                                            let _e1431 = phi_2718_;
                                                            if _e1431 {
                                                                phi_2722_ = false;
                                                            } else {
                                                                phi_2722_ = true;
                                                            }
                                                            let _e1433 = phi_2722_;
                                                            phi_2723_ = _e1433;
                                                        }
                                                        let _e1435 = phi_2723_;
                                                        if _e1435 {
                                                            phi_2728_ = _e1374;
                                                            phi_2729_ = (_e1408 + 1u);
                                                        } else {
                                                            phi_2728_ = _e1408;
                                                            phi_2729_ = _e1376;
                                                        }
                                                        let _e1438 = phi_2728_;
                                                        let _e1440 = phi_2729_;
                                                        phi_2730_ = _e1438;
                                                        phi_2731_ = _e1440;
                                                        phi_2732_ = true;
                                                    }
                                                    let _e1442 = phi_2730_;
                                                    let _e1444 = phi_2731_;
                                                    let _e1446 = phi_2732_;
                                                    phi_2605_ = _e1442;
                                                    phi_2607_ = _e1444;
                                                    phi_2733_ = _e1446;
                                                } else {
                                                    phi_2605_ = u32();
                                                    phi_2607_ = u32();
                                                    phi_2733_ = false;
                                                }
                                                let _e1448 = phi_2605_;
                                                let _e1450 = phi_2607_;
                                                let _e1452 = phi_2733_;
                                                continue;
                                                continuing {
                                                    phi_2601_ = _e1399;
                                                    phi_2604_ = _e1448;
                                                    phi_2606_ = _e1450;
                                                    break if !(_e1452);
                                                }
                                            }
                                            let _e1455 = local_5;
                                            if (_e1455 < _e1361) {
                                                let _e1458 = local_6;
                                                let _e1460 = (_e1365 + (3u * _e1458));
                                                let _e1462 = bodies.member[_e1460];
                                                if (_e1462 == 1u) {
                                                    let _e1466 = bodies.member[(_e1460 + 1u)];
                                                    if (_e1466 == _e1370) {
                                                        let _e1470 = bodies.member[(_e1460 + 2u)];
                                                        phi_2781_ = (_e1470 == _e1368);
                                                        phi_2782_ = false;
                                                    } else {
                                                        phi_2781_ = bool();
                                                        phi_2782_ = true;
                                                    }
                                                    let _e1473 = phi_2781_;
                                                    let _e1475 = phi_2782_;
                                                    phi_2783_ = _e1473;
                                                    phi_2784_ = _e1475;
                                                } else {
                                                    phi_2783_ = bool();
                                                    phi_2784_ = true;
                                                }
                                                let _e1477 = phi_2783_;
                                                let _e1479 = phi_2784_;
                                                if _e1479 {
                                                    phi_2788_ = false;
                                                } else {
                                                    phi_2788_ = _e1477;
                                                }
                                                let _e1481 = phi_2788_;
                                                phi_2789_ = _e1481;
                                            } else {
                                                phi_2789_ = false;
                                            }
                                            let _e1483 = phi_2789_;
                                            phi_2793_ = _e1483;
                                        } else {
                                            phi_2793_ = true;
                                        }
                                        let _e1485 = phi_2793_;
                                        if _e1485 {
                                            phi_2797_ = false;
                                        } else {
                                            phi_2797_ = true;
                                        }
                                        let _e1487 = phi_2797_;
                                        phi_2798_ = _e1487;
                                    } else {
                                        phi_2798_ = true;
                                    }
                                    let _e1489 = phi_2798_;
                                    if _e1489 {
                                        phi_2802_ = false;
                                    } else {
                                        phi_2802_ = true;
                                    }
                                    let _e1491 = phi_2802_;
                                    phi_2803_ = _e1491;
                                } else {
                                    phi_2803_ = true;
                                }
                                let _e1493 = phi_2803_;
                                if _e1493 {
                                    phi_2807_ = false;
                                } else {
                                    phi_2807_ = true;
                                }
                                let _e1495 = phi_2807_;
                                phi_2808_ = _e1495;
                            } else {
                                phi_2808_ = true;
                            }
                            let _e1497 = phi_2808_;
                            if _e1497 {
                                let _e1499 = params.member.member.member_1;
                                if ((_e1499 & 32u) != 0u) {
                                    let _e1503 = params.member.member.member_6;
                                    let _e1520 = (((((_e1221.member_1.y - _e1235.member.x) > _e1503) && ((_e1235.member_1.y - _e1221.member.x) > _e1503)) && (((_e1221.member_2.x - _e1235.member.y) > _e1503) && ((_e1235.member_2.x - _e1221.member.y) > _e1503))) && (((_e1221.member_2.y - _e1235.member_1.x) > _e1503) && ((_e1235.member_2.y - _e1221.member_1.x) > _e1503)));
                                    if _e1520 {
                                        phi_3410_ = bool();
                                    } else {
                                        let _e1524 = keys.member[_e1217.member[0]];
                                        let _e1529 = keys.member[_e1217.member[1]];
                                        let _e1531 = function_(_e1524[0], _e1529[0]);
                                        let _e1535 = keys.member[_e1217.member[2]];
                                        let _e1537 = function_(_e1531, _e1535[0]);
                                        let _e1541 = keys.member[_e1219.member[0]];
                                        let _e1546 = keys.member[_e1219.member[1]];
                                        let _e1548 = function_1(_e1541[3], _e1546[3]);
                                        let _e1552 = keys.member[_e1219.member[2]];
                                        let _e1554 = function_1(_e1548, _e1552[3]);
                                        if (_e1537[1] > _e1554[1]) {
                                            phi_2933_ = true;
                                        } else {
                                            if (_e1537[1] == _e1554[1]) {
                                                phi_2932_ = (_e1537[0] > _e1554[0]);
                                            } else {
                                                phi_2932_ = false;
                                            }
                                            let _e1565 = phi_2932_;
                                            phi_2933_ = _e1565;
                                        }
                                        let _e1567 = phi_2933_;
                                        let _e1572 = keys.member[_e1219.member[0]];
                                        let _e1577 = keys.member[_e1219.member[1]];
                                        let _e1579 = function_(_e1572[0], _e1577[0]);
                                        let _e1583 = keys.member[_e1219.member[2]];
                                        let _e1585 = function_(_e1579, _e1583[0]);
                                        let _e1589 = keys.member[_e1217.member[0]];
                                        let _e1594 = keys.member[_e1217.member[1]];
                                        let _e1596 = function_1(_e1589[3], _e1594[3]);
                                        let _e1600 = keys.member[_e1217.member[2]];
                                        let _e1602 = function_1(_e1596, _e1600[3]);
                                        if (_e1585[1] > _e1602[1]) {
                                            phi_3027_ = true;
                                        } else {
                                            if (_e1585[1] == _e1602[1]) {
                                                phi_3026_ = (_e1585[0] > _e1602[0]);
                                            } else {
                                                phi_3026_ = false;
                                            }
                                            let _e1613 = phi_3026_;
                                            phi_3027_ = _e1613;
                                        }
                                        let _e1615 = phi_3027_;
                                        let _e1621 = keys.member[_e1217.member[0]];
                                        let _e1626 = keys.member[_e1217.member[1]];
                                        let _e1628 = function_2(_e1621[1], _e1626[1]);
                                        let _e1632 = keys.member[_e1217.member[2]];
                                        let _e1634 = function_2(_e1628, _e1632[1]);
                                        let _e1638 = keys.member[_e1219.member[0]];
                                        let _e1643 = keys.member[_e1219.member[1]];
                                        let _e1645 = function_3(_e1638[4], _e1643[4]);
                                        let _e1649 = keys.member[_e1219.member[2]];
                                        let _e1651 = function_3(_e1645, _e1649[4]);
                                        if (_e1634[1] > _e1651[1]) {
                                            phi_3122_ = true;
                                        } else {
                                            if (_e1634[1] == _e1651[1]) {
                                                phi_3121_ = (_e1634[0] > _e1651[0]);
                                            } else {
                                                phi_3121_ = false;
                                            }
                                            let _e1662 = phi_3121_;
                                            phi_3122_ = _e1662;
                                        }
                                        let _e1664 = phi_3122_;
                                        let _e1669 = keys.member[_e1219.member[0]];
                                        let _e1674 = keys.member[_e1219.member[1]];
                                        let _e1676 = function_2(_e1669[1], _e1674[1]);
                                        let _e1680 = keys.member[_e1219.member[2]];
                                        let _e1682 = function_2(_e1676, _e1680[1]);
                                        let _e1686 = keys.member[_e1217.member[0]];
                                        let _e1691 = keys.member[_e1217.member[1]];
                                        let _e1693 = function_3(_e1686[4], _e1691[4]);
                                        let _e1697 = keys.member[_e1217.member[2]];
                                        let _e1699 = function_3(_e1693, _e1697[4]);
                                        if (_e1682[1] > _e1699[1]) {
                                            phi_3216_ = true;
                                        } else {
                                            if (_e1682[1] == _e1699[1]) {
                                                phi_3215_ = (_e1682[0] > _e1699[0]);
                                            } else {
                                                phi_3215_ = false;
                                            }
                                            let _e1710 = phi_3215_;
                                            phi_3216_ = _e1710;
                                        }
                                        let _e1712 = phi_3216_;
                                        let _e1719 = keys.member[_e1217.member[0]];
                                        let _e1724 = keys.member[_e1217.member[1]];
                                        let _e1726 = function_4(_e1719[2], _e1724[2]);
                                        let _e1730 = keys.member[_e1217.member[2]];
                                        let _e1732 = function_4(_e1726, _e1730[2]);
                                        let _e1736 = keys.member[_e1219.member[0]];
                                        let _e1741 = keys.member[_e1219.member[1]];
                                        let _e1743 = function_5(_e1736[5], _e1741[5]);
                                        let _e1747 = keys.member[_e1219.member[2]];
                                        let _e1749 = function_5(_e1743, _e1747[5]);
                                        if (_e1732[1] > _e1749[1]) {
                                            phi_3312_ = true;
                                        } else {
                                            if (_e1732[1] == _e1749[1]) {
                                                phi_3311_ = (_e1732[0] > _e1749[0]);
                                            } else {
                                                phi_3311_ = false;
                                            }
                                            let _e1760 = phi_3311_;
                                            phi_3312_ = _e1760;
                                        }
                                        let _e1762 = phi_3312_;
                                        let _e1767 = keys.member[_e1219.member[0]];
                                        let _e1772 = keys.member[_e1219.member[1]];
                                        let _e1774 = function_4(_e1767[2], _e1772[2]);
                                        let _e1778 = keys.member[_e1219.member[2]];
                                        let _e1780 = function_4(_e1774, _e1778[2]);
                                        let _e1784 = keys.member[_e1217.member[0]];
                                        let _e1789 = keys.member[_e1217.member[1]];
                                        let _e1791 = function_5(_e1784[5], _e1789[5]);
                                        let _e1795 = keys.member[_e1217.member[2]];
                                        let _e1797 = function_5(_e1791, _e1795[5]);
                                        if (_e1780[1] > _e1797[1]) {
                                            phi_3406_ = true;
                                        } else {
                                            if (_e1780[1] == _e1797[1]) {
                                                phi_3405_ = (_e1780[0] > _e1797[0]);
                                            } else {
                                                phi_3405_ = false;
                                            }
                                            let _e1808 = phi_3405_;
                                            phi_3406_ = _e1808;
                                        }
                                        let _e1810 = phi_3406_;
                                        phi_3410_ = (((!(_e1567) && !(_e1615)) && (!(_e1664) && !(_e1712))) && (!(_e1762) && !(_e1810)));
                                    }
                                    let _e1815 = phi_3410_;
                                    phi_3411_ = _e1815;
                                    phi_3412_ = _e1520;
                                } else {
                                    phi_3411_ = bool();
                                    phi_3412_ = true;
                                }
                                let _e1817 = phi_3411_;
                                let _e1819 = phi_3412_;
                                if _e1819 {
                                    phi_3416_ = false;
                                } else {
                                    phi_3416_ = true;
                                }
                                let _e1821 = phi_3416_;
                                phi_3417_ = _e1817;
                                phi_3418_ = _e1821;
                            } else {
                                phi_3417_ = false;
                                phi_3418_ = true;
                            }
                            let _e1823 = phi_3417_;
                            let _e1825 = phi_3418_;
                            phi_3419_ = _e1823;
                            phi_3420_ = _e1825;
                        } else {
                            phi_3419_ = false;
                            phi_3420_ = true;
                        }
                        let _e1827 = phi_3419_;
                        let _e1829 = phi_3420_;
                        if _e1829 {
                            phi_3424_ = _e1827;
                        } else {
                            phi_3424_ = true;
                        }
                        let _e1831 = phi_3424_;
                        if _e1831 {
                            let _e1833 = atomicAdd((&counters[7u]), 1u);
                            if (_e1217.member_1 < _e1219.member_1) {
                                phi_3441_ = _e1219.member;
                                phi_3442_ = _e1217.member;
                            } else {
                                phi_3441_ = _e1217.member;
                                phi_3442_ = _e1219.member;
                            }
                            let _e1843 = phi_3441_;
                            let _e1845 = phi_3442_;
                            let _e1851 = params.member.member.member_4;
                            let _e1853 = params.member.member.member_5;
                            let _e1855 = paths.member[_e1845[0]];
                            let _e1857 = paths.member[_e1845[1]];
                            let _e1863 = paths.member[_e1843[0]];
                            let _e1865 = paths.member[_e1843[1]];
                            local_2 = type_41(array<array<f32, 3>, 2>(array<f32, 3>((_e1863.member[0] - _e1855.member[0]), (_e1863.member[1] - _e1855.member[1]), (_e1863.member[2] - _e1855.member[2])), array<f32, 3>((_e1863.member_1[0] - _e1855.member_1[0]), (_e1863.member_1[1] - _e1855.member_1[1]), (_e1863.member_1[2] - _e1855.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1857.member[0] - _e1855.member[0]), (_e1857.member[1] - _e1855.member[1]), (_e1857.member[2] - _e1855.member[2])), array<f32, 3>((_e1857.member_1[0] - _e1855.member_1[0]), (_e1857.member_1[1] - _e1855.member_1[1]), (_e1857.member_1[2] - _e1855.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e1863.member[0] - _e1865.member[0]), (_e1863.member[1] - _e1865.member[1]), (_e1863.member[2] - _e1865.member[2])), array<f32, 3>((_e1863.member_1[0] - _e1865.member_1[0]), (_e1863.member_1[1] - _e1865.member_1[1]), (_e1863.member_1[2] - _e1865.member_1[2]))), (_e1851 + _e1851));
                            let _e1925 = local_2.member_1[0u];
                            let _e1931 = local_2.member_2[0u];
                            let _e1937 = ((_e1925[1] * _e1931[2]) - (_e1925[2] * _e1931[1]));
                            let _e1940 = ((_e1925[2] * _e1931[0]) - (_e1925[0] * _e1931[2]));
                            let _e1943 = ((_e1925[0] * _e1931[1]) - (_e1925[1] * _e1931[0]));
                            let _e1946 = local_2.member_1[1u];
                            let _e1952 = local_2.member_2[1u];
                            let _e1958 = ((_e1946[1] * _e1952[2]) - (_e1946[2] * _e1952[1]));
                            let _e1961 = ((_e1946[2] * _e1952[0]) - (_e1946[0] * _e1952[2]));
                            let _e1964 = ((_e1946[0] * _e1952[1]) - (_e1946[1] * _e1952[0]));
                            let _e1967 = local_2.member_1[0u];
                            let _e1973 = local_2.member_2[1u];
                            let _e1988 = local_2.member_1[1u];
                            let _e1994 = local_2.member_2[0u];
                            let _e2007 = (((_e1967[1] * _e1973[2]) - (_e1967[2] * _e1973[1])) + ((_e1988[1] * _e1994[2]) - (_e1988[2] * _e1994[1])));
                            let _e2008 = (((_e1967[2] * _e1973[0]) - (_e1967[0] * _e1973[2])) + ((_e1988[2] * _e1994[0]) - (_e1988[0] * _e1994[2])));
                            let _e2009 = (((_e1967[0] * _e1973[1]) - (_e1967[1] * _e1973[0])) + ((_e1988[0] * _e1994[1]) - (_e1988[1] * _e1994[0])));
                            let _e2012 = local_2.member[0u];
                            let _e2023 = local_2.member[1u];
                            let _e2034 = local_2.member[0u];
                            let _e2043 = ((((_e2023[0] * _e1937) + (_e2023[1] * _e1940)) + (_e2023[2] * _e1943)) + (((_e2034[0] * _e2007) + (_e2034[1] * _e2008)) + (_e2034[2] * _e2009)));
                            let _e2046 = local_2.member[0u];
                            let _e2057 = local_2.member[1u];
                            let _e2066 = ((((_e2046[0] * _e1958) + (_e2046[1] * _e1961)) + (_e2046[2] * _e1964)) + (((_e2057[0] * _e2007) + (_e2057[1] * _e2008)) + (_e2057[2] * _e2009)));
                            let _e2069 = local_2.member[1u];
                            let _e2080 = local_2.member[0u];
                            if (_e2080[0] < 0f) {
                                phi_3865_ = -(_e2080[0]);
                            } else {
                                phi_3865_ = _e2080[0];
                            }
                            let _e2087 = phi_3865_;
                            if (_e2080[1] < 0f) {
                                phi_3872_ = -(_e2080[1]);
                            } else {
                                phi_3872_ = _e2080[1];
                            }
                            let _e2091 = phi_3872_;
                            if (_e2087 > _e2091) {
                                phi_3877_ = _e2087;
                            } else {
                                phi_3877_ = _e2091;
                            }
                            let _e2094 = phi_3877_;
                            if (_e2080[2] < 0f) {
                                phi_3884_ = -(_e2080[2]);
                            } else {
                                phi_3884_ = _e2080[2];
                            }
                            let _e2098 = phi_3884_;
                            if (_e2094 > _e2098) {
                                phi_3889_ = _e2094;
                            } else {
                                phi_3889_ = _e2098;
                            }
                            let _e2101 = phi_3889_;
                            let _e2104 = local_2.member[1u];
                            if (_e2104[0] < 0f) {
                                phi_3902_ = -(_e2104[0]);
                            } else {
                                phi_3902_ = _e2104[0];
                            }
                            let _e2111 = phi_3902_;
                            if (_e2104[1] < 0f) {
                                phi_3909_ = -(_e2104[1]);
                            } else {
                                phi_3909_ = _e2104[1];
                            }
                            let _e2115 = phi_3909_;
                            if (_e2111 > _e2115) {
                                phi_3914_ = _e2111;
                            } else {
                                phi_3914_ = _e2115;
                            }
                            let _e2118 = phi_3914_;
                            if (_e2104[2] < 0f) {
                                phi_3921_ = -(_e2104[2]);
                            } else {
                                phi_3921_ = _e2104[2];
                            }
                            let _e2122 = phi_3921_;
                            if (_e2118 > _e2122) {
                                phi_3926_ = _e2118;
                            } else {
                                phi_3926_ = _e2122;
                            }
                            let _e2125 = phi_3926_;
                            if (_e2101 > _e2125) {
                                phi_3931_ = _e2101;
                            } else {
                                phi_3931_ = _e2125;
                            }
                            let _e2128 = phi_3931_;
                            let _e2130 = local_2.member_3;
                            let _e2131 = (_e2128 + _e2130);
                            let _e2134 = local_2.member_1[0u];
                            if (_e2134[0] < 0f) {
                                phi_3948_ = -(_e2134[0]);
                            } else {
                                phi_3948_ = _e2134[0];
                            }
                            let _e2141 = phi_3948_;
                            if (_e2134[1] < 0f) {
                                phi_3955_ = -(_e2134[1]);
                            } else {
                                phi_3955_ = _e2134[1];
                            }
                            let _e2145 = phi_3955_;
                            if (_e2141 > _e2145) {
                                phi_3960_ = _e2141;
                            } else {
                                phi_3960_ = _e2145;
                            }
                            let _e2148 = phi_3960_;
                            if (_e2134[2] < 0f) {
                                phi_3967_ = -(_e2134[2]);
                            } else {
                                phi_3967_ = _e2134[2];
                            }
                            let _e2152 = phi_3967_;
                            if (_e2148 > _e2152) {
                                phi_3972_ = _e2148;
                            } else {
                                phi_3972_ = _e2152;
                            }
                            let _e2155 = phi_3972_;
                            let _e2158 = local_2.member_1[1u];
                            if (_e2158[0] < 0f) {
                                phi_3986_ = -(_e2158[0]);
                            } else {
                                phi_3986_ = _e2158[0];
                            }
                            let _e2165 = phi_3986_;
                            if (_e2158[1] < 0f) {
                                phi_3993_ = -(_e2158[1]);
                            } else {
                                phi_3993_ = _e2158[1];
                            }
                            let _e2169 = phi_3993_;
                            if (_e2165 > _e2169) {
                                phi_3998_ = _e2165;
                            } else {
                                phi_3998_ = _e2169;
                            }
                            let _e2172 = phi_3998_;
                            if (_e2158[2] < 0f) {
                                phi_4005_ = -(_e2158[2]);
                            } else {
                                phi_4005_ = _e2158[2];
                            }
                            let _e2176 = phi_4005_;
                            if (_e2172 > _e2176) {
                                phi_4010_ = _e2172;
                            } else {
                                phi_4010_ = _e2176;
                            }
                            let _e2179 = phi_4010_;
                            if (_e2155 > _e2179) {
                                phi_4015_ = _e2155;
                            } else {
                                phi_4015_ = _e2179;
                            }
                            let _e2182 = phi_4015_;
                            let _e2184 = local_2.member_3;
                            let _e2185 = (_e2182 + _e2184);
                            let _e2188 = local_2.member_2[0u];
                            if (_e2188[0] < 0f) {
                                phi_4032_ = -(_e2188[0]);
                            } else {
                                phi_4032_ = _e2188[0];
                            }
                            let _e2195 = phi_4032_;
                            if (_e2188[1] < 0f) {
                                phi_4039_ = -(_e2188[1]);
                            } else {
                                phi_4039_ = _e2188[1];
                            }
                            let _e2199 = phi_4039_;
                            if (_e2195 > _e2199) {
                                phi_4044_ = _e2195;
                            } else {
                                phi_4044_ = _e2199;
                            }
                            let _e2202 = phi_4044_;
                            if (_e2188[2] < 0f) {
                                phi_4051_ = -(_e2188[2]);
                            } else {
                                phi_4051_ = _e2188[2];
                            }
                            let _e2206 = phi_4051_;
                            if (_e2202 > _e2206) {
                                phi_4056_ = _e2202;
                            } else {
                                phi_4056_ = _e2206;
                            }
                            let _e2209 = phi_4056_;
                            let _e2212 = local_2.member_2[1u];
                            if (_e2212[0] < 0f) {
                                phi_4070_ = -(_e2212[0]);
                            } else {
                                phi_4070_ = _e2212[0];
                            }
                            let _e2219 = phi_4070_;
                            if (_e2212[1] < 0f) {
                                phi_4077_ = -(_e2212[1]);
                            } else {
                                phi_4077_ = _e2212[1];
                            }
                            let _e2223 = phi_4077_;
                            if (_e2219 > _e2223) {
                                phi_4082_ = _e2219;
                            } else {
                                phi_4082_ = _e2223;
                            }
                            let _e2226 = phi_4082_;
                            if (_e2212[2] < 0f) {
                                phi_4089_ = -(_e2212[2]);
                            } else {
                                phi_4089_ = _e2212[2];
                            }
                            let _e2230 = phi_4089_;
                            if (_e2226 > _e2230) {
                                phi_4094_ = _e2226;
                            } else {
                                phi_4094_ = _e2230;
                            }
                            let _e2233 = phi_4094_;
                            if (_e2209 > _e2233) {
                                phi_4099_ = _e2209;
                            } else {
                                phi_4099_ = _e2233;
                            }
                            let _e2236 = phi_4099_;
                            let _e2238 = local_2.member_3;
                            let _e2239 = (_e2236 + _e2238);
                            let _e2241 = ((_e2185 * 8f) * _e2239);
                            let _e2248 = local_2.member_3;
                            if (_e1937 < 0f) {
                                phi_4130_ = -(_e1937);
                            } else {
                                phi_4130_ = _e1937;
                            }
                            let _e2265 = phi_4130_;
                            if (_e1940 < 0f) {
                                phi_4136_ = -(_e1940);
                            } else {
                                phi_4136_ = _e1940;
                            }
                            let _e2269 = phi_4136_;
                            if (_e1943 < 0f) {
                                phi_4143_ = -(_e1943);
                            } else {
                                phi_4143_ = _e1943;
                            }
                            let _e2274 = phi_4143_;
                            let _e2275 = ((_e2265 + _e2269) + _e2274);
                            if (_e1958 < 0f) {
                                phi_4150_ = -(_e1958);
                            } else {
                                phi_4150_ = _e1958;
                            }
                            let _e2279 = phi_4150_;
                            if (_e1961 < 0f) {
                                phi_4156_ = -(_e1961);
                            } else {
                                phi_4156_ = _e1961;
                            }
                            let _e2283 = phi_4156_;
                            if (_e1964 < 0f) {
                                phi_4163_ = -(_e1964);
                            } else {
                                phi_4163_ = _e1964;
                            }
                            let _e2288 = phi_4163_;
                            let _e2289 = ((_e2279 + _e2283) + _e2288);
                            if (_e2275 > _e2289) {
                                phi_4169_ = _e2275;
                            } else {
                                phi_4169_ = _e2289;
                            }
                            let _e2292 = phi_4169_;
                            if (_e2007 < 0f) {
                                phi_4175_ = -(_e2007);
                            } else {
                                phi_4175_ = _e2007;
                            }
                            let _e2296 = phi_4175_;
                            if (_e2008 < 0f) {
                                phi_4181_ = -(_e2008);
                            } else {
                                phi_4181_ = _e2008;
                            }
                            let _e2300 = phi_4181_;
                            if (_e2009 < 0f) {
                                phi_4188_ = -(_e2009);
                            } else {
                                phi_4188_ = _e2009;
                            }
                            let _e2305 = phi_4188_;
                            let _e2307 = (((_e2296 + _e2300) + _e2305) * 0.5f);
                            if (_e2292 > _e2307) {
                                phi_4195_ = _e2292;
                            } else {
                                phi_4195_ = _e2307;
                            }
                            let _e2310 = phi_4195_;
                            let _e2315 = local_2.member_3;
                            let _e2328 = ((((_e2012[0] * _e1937) + (_e2012[1] * _e1940)) + (_e2012[2] * _e1943)) * 3f);
                            let _e2329 = ((((_e2069[0] * _e1958) + (_e2069[1] * _e1961)) + (_e2069[2] * _e1964)) * 3f);
                            if (_e2328 < _e2329) {
                                phi_4219_ = _e2328;
                            } else {
                                phi_4219_ = _e2329;
                            }
                            let _e2332 = phi_4219_;
                            if (_e2043 < _e2066) {
                                phi_4224_ = _e2043;
                            } else {
                                phi_4224_ = _e2066;
                            }
                            let _e2335 = phi_4224_;
                            if (_e2332 < _e2335) {
                                phi_4229_ = _e2332;
                            } else {
                                phi_4229_ = _e2335;
                            }
                            let _e2338 = phi_4229_;
                            if (_e2328 > _e2329) {
                                phi_4234_ = _e2328;
                            } else {
                                phi_4234_ = _e2329;
                            }
                            let _e2341 = phi_4234_;
                            if (_e2043 > _e2066) {
                                phi_4239_ = _e2043;
                            } else {
                                phi_4239_ = _e2066;
                            }
                            let _e2344 = phi_4239_;
                            if (_e2341 > _e2344) {
                                phi_4244_ = _e2341;
                            } else {
                                phi_4244_ = _e2344;
                            }
                            let _e2347 = phi_4244_;
                            let _e2352 = -(_e2347);
                            if (_e2338 > _e2352) {
                                phi_4254_ = _e2338;
                            } else {
                                phi_4254_ = _e2352;
                            }
                            let _e2355 = phi_4254_;
                            let _e2357 = ((_e2355 - ((((((_e2131 * 8f) * _e2241) * (0.000000059604645f * (524f / 64f))) + ((_e2248 * 19f) * ((_e2131 * (_e2185 + _e2239)) + (_e2185 * _e2239)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2131) * ((1f + _e2185) * (1f + _e2239))))) + ((_e1853 * (((_e2310 + (_e2241 * (0.000000059604645f * 8f))) + ((_e2315 * 6f) * (_e2185 + _e2239))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2185) * (1f + _e2239))))) * (3f * 1.0001f)))) > 0f);
                            if _e2357 {
                                phi_5223_ = _e2357;
                            } else {
                                let _e2360 = local_2.member_1[0u];
                                let _e2366 = local_2.member_1[1u];
                                let _e2370 = (_e2360[0] + _e2366[0]);
                                let _e2371 = (_e2360[1] + _e2366[1]);
                                let _e2372 = (_e2360[2] + _e2366[2]);
                                let _e2375 = local_2.member_2[0u];
                                let _e2381 = local_2.member_2[1u];
                                let _e2385 = (_e2375[0] + _e2381[0]);
                                let _e2386 = (_e2375[1] + _e2381[1]);
                                let _e2387 = (_e2375[2] + _e2381[2]);
                                let _e2390 = ((_e2371 * _e2387) - (_e2372 * _e2386));
                                let _e2393 = ((_e2372 * _e2385) - (_e2370 * _e2387));
                                let _e2396 = ((_e2370 * _e2386) - (_e2371 * _e2385));
                                let _e2399 = local_2.member[0u];
                                let _e2405 = local_2.member_1[0u];
                                let _e2411 = local_2.member_2[0u];
                                let _e2415 = (_e2399[0] - _e2405[0]);
                                let _e2416 = (_e2399[1] - _e2405[1]);
                                let _e2417 = (_e2399[2] - _e2405[2]);
                                let _e2418 = (_e2415 - _e2411[0]);
                                let _e2419 = (_e2416 - _e2411[1]);
                                let _e2420 = (_e2417 - _e2411[2]);
                                let _e2421 = (_e2399[0] - _e2411[0]);
                                let _e2422 = (_e2399[1] - _e2411[1]);
                                let _e2423 = (_e2399[2] - _e2411[2]);
                                let _e2426 = local_2.member[1u];
                                let _e2432 = local_2.member_1[1u];
                                let _e2438 = local_2.member_2[1u];
                                let _e2442 = (_e2426[0] - _e2432[0]);
                                let _e2443 = (_e2426[1] - _e2432[1]);
                                let _e2444 = (_e2426[2] - _e2432[2]);
                                let _e2445 = (_e2442 - _e2438[0]);
                                let _e2446 = (_e2443 - _e2438[1]);
                                let _e2447 = (_e2444 - _e2438[2]);
                                let _e2448 = (_e2426[0] - _e2438[0]);
                                let _e2449 = (_e2426[1] - _e2438[1]);
                                let _e2450 = (_e2426[2] - _e2438[2]);
                                let _e2453 = local_2.member[0u];
                                if (_e2453[0] < 0f) {
                                    phi_4457_ = -(_e2453[0]);
                                } else {
                                    phi_4457_ = _e2453[0];
                                }
                                let _e2460 = phi_4457_;
                                if (_e2453[1] < 0f) {
                                    phi_4464_ = -(_e2453[1]);
                                } else {
                                    phi_4464_ = _e2453[1];
                                }
                                let _e2464 = phi_4464_;
                                if (_e2460 > _e2464) {
                                    phi_4469_ = _e2460;
                                } else {
                                    phi_4469_ = _e2464;
                                }
                                let _e2467 = phi_4469_;
                                if (_e2453[2] < 0f) {
                                    phi_4476_ = -(_e2453[2]);
                                } else {
                                    phi_4476_ = _e2453[2];
                                }
                                let _e2471 = phi_4476_;
                                if (_e2467 > _e2471) {
                                    phi_4481_ = _e2467;
                                } else {
                                    phi_4481_ = _e2471;
                                }
                                let _e2474 = phi_4481_;
                                let _e2477 = local_2.member[1u];
                                if (_e2477[0] < 0f) {
                                    phi_4494_ = -(_e2477[0]);
                                } else {
                                    phi_4494_ = _e2477[0];
                                }
                                let _e2484 = phi_4494_;
                                if (_e2477[1] < 0f) {
                                    phi_4501_ = -(_e2477[1]);
                                } else {
                                    phi_4501_ = _e2477[1];
                                }
                                let _e2488 = phi_4501_;
                                if (_e2484 > _e2488) {
                                    phi_4506_ = _e2484;
                                } else {
                                    phi_4506_ = _e2488;
                                }
                                let _e2491 = phi_4506_;
                                if (_e2477[2] < 0f) {
                                    phi_4513_ = -(_e2477[2]);
                                } else {
                                    phi_4513_ = _e2477[2];
                                }
                                let _e2495 = phi_4513_;
                                if (_e2491 > _e2495) {
                                    phi_4518_ = _e2491;
                                } else {
                                    phi_4518_ = _e2495;
                                }
                                let _e2498 = phi_4518_;
                                if (_e2474 > _e2498) {
                                    phi_4523_ = _e2474;
                                } else {
                                    phi_4523_ = _e2498;
                                }
                                let _e2501 = phi_4523_;
                                let _e2503 = local_2.member_3;
                                let _e2507 = local_2.member_1[0u];
                                if (_e2507[0] < 0f) {
                                    phi_4540_ = -(_e2507[0]);
                                } else {
                                    phi_4540_ = _e2507[0];
                                }
                                let _e2514 = phi_4540_;
                                if (_e2507[1] < 0f) {
                                    phi_4547_ = -(_e2507[1]);
                                } else {
                                    phi_4547_ = _e2507[1];
                                }
                                let _e2518 = phi_4547_;
                                if (_e2514 > _e2518) {
                                    phi_4552_ = _e2514;
                                } else {
                                    phi_4552_ = _e2518;
                                }
                                let _e2521 = phi_4552_;
                                if (_e2507[2] < 0f) {
                                    phi_4559_ = -(_e2507[2]);
                                } else {
                                    phi_4559_ = _e2507[2];
                                }
                                let _e2525 = phi_4559_;
                                if (_e2521 > _e2525) {
                                    phi_4564_ = _e2521;
                                } else {
                                    phi_4564_ = _e2525;
                                }
                                let _e2528 = phi_4564_;
                                let _e2531 = local_2.member_1[1u];
                                if (_e2531[0] < 0f) {
                                    phi_4578_ = -(_e2531[0]);
                                } else {
                                    phi_4578_ = _e2531[0];
                                }
                                let _e2538 = phi_4578_;
                                if (_e2531[1] < 0f) {
                                    phi_4585_ = -(_e2531[1]);
                                } else {
                                    phi_4585_ = _e2531[1];
                                }
                                let _e2542 = phi_4585_;
                                if (_e2538 > _e2542) {
                                    phi_4590_ = _e2538;
                                } else {
                                    phi_4590_ = _e2542;
                                }
                                let _e2545 = phi_4590_;
                                if (_e2531[2] < 0f) {
                                    phi_4597_ = -(_e2531[2]);
                                } else {
                                    phi_4597_ = _e2531[2];
                                }
                                let _e2549 = phi_4597_;
                                if (_e2545 > _e2549) {
                                    phi_4602_ = _e2545;
                                } else {
                                    phi_4602_ = _e2549;
                                }
                                let _e2552 = phi_4602_;
                                if (_e2528 > _e2552) {
                                    phi_4607_ = _e2528;
                                } else {
                                    phi_4607_ = _e2552;
                                }
                                let _e2555 = phi_4607_;
                                let _e2557 = local_2.member_3;
                                let _e2561 = local_2.member_2[0u];
                                if (_e2561[0] < 0f) {
                                    phi_4624_ = -(_e2561[0]);
                                } else {
                                    phi_4624_ = _e2561[0];
                                }
                                let _e2568 = phi_4624_;
                                if (_e2561[1] < 0f) {
                                    phi_4631_ = -(_e2561[1]);
                                } else {
                                    phi_4631_ = _e2561[1];
                                }
                                let _e2572 = phi_4631_;
                                if (_e2568 > _e2572) {
                                    phi_4636_ = _e2568;
                                } else {
                                    phi_4636_ = _e2572;
                                }
                                let _e2575 = phi_4636_;
                                if (_e2561[2] < 0f) {
                                    phi_4643_ = -(_e2561[2]);
                                } else {
                                    phi_4643_ = _e2561[2];
                                }
                                let _e2579 = phi_4643_;
                                if (_e2575 > _e2579) {
                                    phi_4648_ = _e2575;
                                } else {
                                    phi_4648_ = _e2579;
                                }
                                let _e2582 = phi_4648_;
                                let _e2585 = local_2.member_2[1u];
                                if (_e2585[0] < 0f) {
                                    phi_4662_ = -(_e2585[0]);
                                } else {
                                    phi_4662_ = _e2585[0];
                                }
                                let _e2592 = phi_4662_;
                                if (_e2585[1] < 0f) {
                                    phi_4669_ = -(_e2585[1]);
                                } else {
                                    phi_4669_ = _e2585[1];
                                }
                                let _e2596 = phi_4669_;
                                if (_e2592 > _e2596) {
                                    phi_4674_ = _e2592;
                                } else {
                                    phi_4674_ = _e2596;
                                }
                                let _e2599 = phi_4674_;
                                if (_e2585[2] < 0f) {
                                    phi_4681_ = -(_e2585[2]);
                                } else {
                                    phi_4681_ = _e2585[2];
                                }
                                let _e2603 = phi_4681_;
                                if (_e2599 > _e2603) {
                                    phi_4686_ = _e2599;
                                } else {
                                    phi_4686_ = _e2603;
                                }
                                let _e2606 = phi_4686_;
                                if (_e2582 > _e2606) {
                                    phi_4691_ = _e2582;
                                } else {
                                    phi_4691_ = _e2606;
                                }
                                let _e2609 = phi_4691_;
                                let _e2611 = local_2.member_3;
                                let _e2615 = ((((_e2501 + _e2503) + (_e2555 + _e2557)) + (_e2609 + _e2611)) * 2f);
                                let _e2618 = local_2.member_3;
                                let _e2622 = (((_e1853 * 1.0001f) + (_e2618 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e2625 = ((_e2393 * _e2372) - (_e2396 * _e2371));
                                let _e2628 = ((_e2396 * _e2370) - (_e2390 * _e2372));
                                let _e2631 = ((_e2390 * _e2371) - (_e2393 * _e2370));
                                let _e2636 = (((_e2625 * _e2399[0]) + (_e2628 * _e2399[1])) + (_e2631 * _e2399[2]));
                                let _e2641 = (((_e2625 * _e2415) + (_e2628 * _e2416)) + (_e2631 * _e2417));
                                let _e2646 = (((_e2625 * _e2421) + (_e2628 * _e2422)) + (_e2631 * _e2423));
                                let _e2651 = (((_e2625 * _e2418) + (_e2628 * _e2419)) + (_e2631 * _e2420));
                                let _e2656 = (((_e2625 * _e2426[0]) + (_e2628 * _e2426[1])) + (_e2631 * _e2426[2]));
                                let _e2661 = (((_e2625 * _e2442) + (_e2628 * _e2443)) + (_e2631 * _e2444));
                                let _e2666 = (((_e2625 * _e2448) + (_e2628 * _e2449)) + (_e2631 * _e2450));
                                let _e2671 = (((_e2625 * _e2445) + (_e2628 * _e2446)) + (_e2631 * _e2447));
                                if (_e2636 < _e2641) {
                                    phi_4770_ = _e2636;
                                } else {
                                    phi_4770_ = _e2641;
                                }
                                let _e2674 = phi_4770_;
                                if (_e2646 < _e2651) {
                                    phi_4775_ = _e2646;
                                } else {
                                    phi_4775_ = _e2651;
                                }
                                let _e2677 = phi_4775_;
                                if (_e2674 < _e2677) {
                                    phi_4780_ = _e2674;
                                } else {
                                    phi_4780_ = _e2677;
                                }
                                let _e2680 = phi_4780_;
                                if (_e2656 < _e2661) {
                                    phi_4785_ = _e2656;
                                } else {
                                    phi_4785_ = _e2661;
                                }
                                let _e2683 = phi_4785_;
                                if (_e2666 < _e2671) {
                                    phi_4790_ = _e2666;
                                } else {
                                    phi_4790_ = _e2671;
                                }
                                let _e2686 = phi_4790_;
                                if (_e2683 < _e2686) {
                                    phi_4795_ = _e2683;
                                } else {
                                    phi_4795_ = _e2686;
                                }
                                let _e2689 = phi_4795_;
                                if (_e2680 < _e2689) {
                                    phi_4800_ = _e2680;
                                } else {
                                    phi_4800_ = _e2689;
                                }
                                let _e2692 = phi_4800_;
                                if (_e2636 > _e2641) {
                                    phi_4805_ = _e2636;
                                } else {
                                    phi_4805_ = _e2641;
                                }
                                let _e2695 = phi_4805_;
                                if (_e2646 > _e2651) {
                                    phi_4810_ = _e2646;
                                } else {
                                    phi_4810_ = _e2651;
                                }
                                let _e2698 = phi_4810_;
                                if (_e2695 > _e2698) {
                                    phi_4815_ = _e2695;
                                } else {
                                    phi_4815_ = _e2698;
                                }
                                let _e2701 = phi_4815_;
                                if (_e2656 > _e2661) {
                                    phi_4820_ = _e2656;
                                } else {
                                    phi_4820_ = _e2661;
                                }
                                let _e2704 = phi_4820_;
                                if (_e2666 > _e2671) {
                                    phi_4825_ = _e2666;
                                } else {
                                    phi_4825_ = _e2671;
                                }
                                let _e2707 = phi_4825_;
                                if (_e2704 > _e2707) {
                                    phi_4830_ = _e2704;
                                } else {
                                    phi_4830_ = _e2707;
                                }
                                let _e2710 = phi_4830_;
                                if (_e2701 > _e2710) {
                                    phi_4835_ = _e2701;
                                } else {
                                    phi_4835_ = _e2710;
                                }
                                let _e2713 = phi_4835_;
                                if (_e2625 < 0f) {
                                    phi_4841_ = -(_e2625);
                                } else {
                                    phi_4841_ = _e2625;
                                }
                                let _e2717 = phi_4841_;
                                if (_e2628 < 0f) {
                                    phi_4847_ = -(_e2628);
                                } else {
                                    phi_4847_ = _e2628;
                                }
                                let _e2721 = phi_4847_;
                                if (_e2631 < 0f) {
                                    phi_4854_ = -(_e2631);
                                } else {
                                    phi_4854_ = _e2631;
                                }
                                let _e2726 = phi_4854_;
                                let _e2727 = ((_e2717 + _e2721) + _e2726);
                                let _e2732 = -(_e2713);
                                if (_e2692 > _e2732) {
                                    phi_4865_ = _e2692;
                                } else {
                                    phi_4865_ = _e2732;
                                }
                                let _e2735 = phi_4865_;
                                let _e2740 = (((_e2735 - ((_e2727 * _e2615) * (0.000000059604645f * (17f / 2f)))) - (_e2727 * _e2622)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                let _e2743 = ((_e2393 * _e2387) - (_e2396 * _e2386));
                                let _e2746 = ((_e2396 * _e2385) - (_e2390 * _e2387));
                                let _e2749 = ((_e2390 * _e2386) - (_e2393 * _e2385));
                                let _e2754 = (((_e2743 * _e2399[0]) + (_e2746 * _e2399[1])) + (_e2749 * _e2399[2]));
                                let _e2759 = (((_e2743 * _e2415) + (_e2746 * _e2416)) + (_e2749 * _e2417));
                                let _e2764 = (((_e2743 * _e2421) + (_e2746 * _e2422)) + (_e2749 * _e2423));
                                let _e2769 = (((_e2743 * _e2418) + (_e2746 * _e2419)) + (_e2749 * _e2420));
                                let _e2774 = (((_e2743 * _e2426[0]) + (_e2746 * _e2426[1])) + (_e2749 * _e2426[2]));
                                let _e2779 = (((_e2743 * _e2442) + (_e2746 * _e2443)) + (_e2749 * _e2444));
                                let _e2784 = (((_e2743 * _e2448) + (_e2746 * _e2449)) + (_e2749 * _e2450));
                                let _e2789 = (((_e2743 * _e2445) + (_e2746 * _e2446)) + (_e2749 * _e2447));
                                if (_e2754 < _e2759) {
                                    phi_4936_ = _e2754;
                                } else {
                                    phi_4936_ = _e2759;
                                }
                                let _e2792 = phi_4936_;
                                if (_e2764 < _e2769) {
                                    phi_4941_ = _e2764;
                                } else {
                                    phi_4941_ = _e2769;
                                }
                                let _e2795 = phi_4941_;
                                if (_e2792 < _e2795) {
                                    phi_4946_ = _e2792;
                                } else {
                                    phi_4946_ = _e2795;
                                }
                                let _e2798 = phi_4946_;
                                if (_e2774 < _e2779) {
                                    phi_4951_ = _e2774;
                                } else {
                                    phi_4951_ = _e2779;
                                }
                                let _e2801 = phi_4951_;
                                if (_e2784 < _e2789) {
                                    phi_4956_ = _e2784;
                                } else {
                                    phi_4956_ = _e2789;
                                }
                                let _e2804 = phi_4956_;
                                if (_e2801 < _e2804) {
                                    phi_4961_ = _e2801;
                                } else {
                                    phi_4961_ = _e2804;
                                }
                                let _e2807 = phi_4961_;
                                if (_e2798 < _e2807) {
                                    phi_4966_ = _e2798;
                                } else {
                                    phi_4966_ = _e2807;
                                }
                                let _e2810 = phi_4966_;
                                if (_e2754 > _e2759) {
                                    phi_4971_ = _e2754;
                                } else {
                                    phi_4971_ = _e2759;
                                }
                                let _e2813 = phi_4971_;
                                if (_e2764 > _e2769) {
                                    phi_4976_ = _e2764;
                                } else {
                                    phi_4976_ = _e2769;
                                }
                                let _e2816 = phi_4976_;
                                if (_e2813 > _e2816) {
                                    phi_4981_ = _e2813;
                                } else {
                                    phi_4981_ = _e2816;
                                }
                                let _e2819 = phi_4981_;
                                if (_e2774 > _e2779) {
                                    phi_4986_ = _e2774;
                                } else {
                                    phi_4986_ = _e2779;
                                }
                                let _e2822 = phi_4986_;
                                if (_e2784 > _e2789) {
                                    phi_4991_ = _e2784;
                                } else {
                                    phi_4991_ = _e2789;
                                }
                                let _e2825 = phi_4991_;
                                if (_e2822 > _e2825) {
                                    phi_4996_ = _e2822;
                                } else {
                                    phi_4996_ = _e2825;
                                }
                                let _e2828 = phi_4996_;
                                if (_e2819 > _e2828) {
                                    phi_5001_ = _e2819;
                                } else {
                                    phi_5001_ = _e2828;
                                }
                                let _e2831 = phi_5001_;
                                if (_e2743 < 0f) {
                                    phi_5007_ = -(_e2743);
                                } else {
                                    phi_5007_ = _e2743;
                                }
                                let _e2835 = phi_5007_;
                                if (_e2746 < 0f) {
                                    phi_5013_ = -(_e2746);
                                } else {
                                    phi_5013_ = _e2746;
                                }
                                let _e2839 = phi_5013_;
                                if (_e2749 < 0f) {
                                    phi_5020_ = -(_e2749);
                                } else {
                                    phi_5020_ = _e2749;
                                }
                                let _e2844 = phi_5020_;
                                let _e2845 = ((_e2835 + _e2839) + _e2844);
                                let _e2850 = -(_e2831);
                                if (_e2810 > _e2850) {
                                    phi_5031_ = _e2810;
                                } else {
                                    phi_5031_ = _e2850;
                                }
                                let _e2853 = phi_5031_;
                                let _e2858 = (((_e2853 - ((_e2845 * _e2615) * (0.000000059604645f * (17f / 2f)))) - (_e2845 * _e2622)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                if (_e2740 > _e2858) {
                                    phi_5041_ = _e2740;
                                } else {
                                    phi_5041_ = _e2858;
                                }
                                let _e2861 = phi_5041_;
                                phi_5223_ = (_e2357 || (_e2861 > 0f));
                            }
                            let _e2865 = phi_5223_;
                            if _e2865 {
                                phi_8640_ = _e2865;
                            } else {
                                let _e2868 = local_2.member[0u];
                                let _e2874 = local_2.member[1u];
                                let _e2881 = ((_e2868[0] + _e2874[0]) * 0.5f);
                                let _e2882 = ((_e2868[1] + _e2874[1]) * 0.5f);
                                let _e2883 = ((_e2868[2] + _e2874[2]) * 0.5f);
                                let _e2886 = local_2.member_1[0u];
                                let _e2892 = local_2.member_1[1u];
                                let _e2899 = ((_e2886[0] + _e2892[0]) * 0.5f);
                                let _e2900 = ((_e2886[1] + _e2892[1]) * 0.5f);
                                let _e2901 = ((_e2886[2] + _e2892[2]) * 0.5f);
                                let _e2904 = local_2.member_2[0u];
                                let _e2910 = local_2.member_2[1u];
                                let _e2917 = ((_e2904[0] + _e2910[0]) * 0.5f);
                                let _e2918 = ((_e2904[1] + _e2910[1]) * 0.5f);
                                let _e2919 = ((_e2904[2] + _e2910[2]) * 0.5f);
                                let _e2922 = local_2.member[0u];
                                let _e2925 = local_2.member_1[0u];
                                let _e2928 = local_2.member_2[0u];
                                let _e2930 = local_2.member_3;
                                let _e2933 = local_2.member[1u];
                                let _e2936 = local_2.member_1[1u];
                                let _e2939 = local_2.member_2[1u];
                                let _e2941 = local_2.member_3;
                                local = type_41(array<array<f32, 3>, 2>(_e2922, array<f32, 3>(_e2881, _e2882, _e2883)), array<array<f32, 3>, 2>(_e2925, array<f32, 3>(_e2899, _e2900, _e2901)), array<array<f32, 3>, 2>(_e2928, array<f32, 3>(_e2917, _e2918, _e2919)), _e2930);
                                local_1 = type_41(array<array<f32, 3>, 2>(array<f32, 3>(_e2881, _e2882, _e2883), _e2933), array<array<f32, 3>, 2>(array<f32, 3>(_e2899, _e2900, _e2901), _e2936), array<array<f32, 3>, 2>(array<f32, 3>(_e2917, _e2918, _e2919), _e2939), _e2941);
                                let _e2958 = local.member_1[0u];
                                let _e2964 = local.member_2[0u];
                                let _e2970 = ((_e2958[1] * _e2964[2]) - (_e2958[2] * _e2964[1]));
                                let _e2973 = ((_e2958[2] * _e2964[0]) - (_e2958[0] * _e2964[2]));
                                let _e2976 = ((_e2958[0] * _e2964[1]) - (_e2958[1] * _e2964[0]));
                                let _e2979 = local.member_1[1u];
                                let _e2985 = local.member_2[1u];
                                let _e2991 = ((_e2979[1] * _e2985[2]) - (_e2979[2] * _e2985[1]));
                                let _e2994 = ((_e2979[2] * _e2985[0]) - (_e2979[0] * _e2985[2]));
                                let _e2997 = ((_e2979[0] * _e2985[1]) - (_e2979[1] * _e2985[0]));
                                let _e3000 = local.member_1[0u];
                                let _e3006 = local.member_2[1u];
                                let _e3021 = local.member_1[1u];
                                let _e3027 = local.member_2[0u];
                                let _e3040 = (((_e3000[1] * _e3006[2]) - (_e3000[2] * _e3006[1])) + ((_e3021[1] * _e3027[2]) - (_e3021[2] * _e3027[1])));
                                let _e3041 = (((_e3000[2] * _e3006[0]) - (_e3000[0] * _e3006[2])) + ((_e3021[2] * _e3027[0]) - (_e3021[0] * _e3027[2])));
                                let _e3042 = (((_e3000[0] * _e3006[1]) - (_e3000[1] * _e3006[0])) + ((_e3021[0] * _e3027[1]) - (_e3021[1] * _e3027[0])));
                                let _e3045 = local.member[0u];
                                let _e3056 = local.member[1u];
                                let _e3067 = local.member[0u];
                                let _e3076 = ((((_e3056[0] * _e2970) + (_e3056[1] * _e2973)) + (_e3056[2] * _e2976)) + (((_e3067[0] * _e3040) + (_e3067[1] * _e3041)) + (_e3067[2] * _e3042)));
                                let _e3079 = local.member[0u];
                                let _e3090 = local.member[1u];
                                let _e3099 = ((((_e3079[0] * _e2991) + (_e3079[1] * _e2994)) + (_e3079[2] * _e2997)) + (((_e3090[0] * _e3040) + (_e3090[1] * _e3041)) + (_e3090[2] * _e3042)));
                                let _e3102 = local.member[1u];
                                let _e3113 = local.member[0u];
                                if (_e3113[0] < 0f) {
                                    phi_5675_ = -(_e3113[0]);
                                } else {
                                    phi_5675_ = _e3113[0];
                                }
                                let _e3120 = phi_5675_;
                                if (_e3113[1] < 0f) {
                                    phi_5682_ = -(_e3113[1]);
                                } else {
                                    phi_5682_ = _e3113[1];
                                }
                                let _e3124 = phi_5682_;
                                if (_e3120 > _e3124) {
                                    phi_5687_ = _e3120;
                                } else {
                                    phi_5687_ = _e3124;
                                }
                                let _e3127 = phi_5687_;
                                if (_e3113[2] < 0f) {
                                    phi_5694_ = -(_e3113[2]);
                                } else {
                                    phi_5694_ = _e3113[2];
                                }
                                let _e3131 = phi_5694_;
                                if (_e3127 > _e3131) {
                                    phi_5699_ = _e3127;
                                } else {
                                    phi_5699_ = _e3131;
                                }
                                let _e3134 = phi_5699_;
                                let _e3137 = local.member[1u];
                                if (_e3137[0] < 0f) {
                                    phi_5712_ = -(_e3137[0]);
                                } else {
                                    phi_5712_ = _e3137[0];
                                }
                                let _e3144 = phi_5712_;
                                if (_e3137[1] < 0f) {
                                    phi_5719_ = -(_e3137[1]);
                                } else {
                                    phi_5719_ = _e3137[1];
                                }
                                let _e3148 = phi_5719_;
                                if (_e3144 > _e3148) {
                                    phi_5724_ = _e3144;
                                } else {
                                    phi_5724_ = _e3148;
                                }
                                let _e3151 = phi_5724_;
                                if (_e3137[2] < 0f) {
                                    phi_5731_ = -(_e3137[2]);
                                } else {
                                    phi_5731_ = _e3137[2];
                                }
                                let _e3155 = phi_5731_;
                                if (_e3151 > _e3155) {
                                    phi_5736_ = _e3151;
                                } else {
                                    phi_5736_ = _e3155;
                                }
                                let _e3158 = phi_5736_;
                                if (_e3134 > _e3158) {
                                    phi_5741_ = _e3134;
                                } else {
                                    phi_5741_ = _e3158;
                                }
                                let _e3161 = phi_5741_;
                                let _e3163 = local.member_3;
                                let _e3164 = (_e3161 + _e3163);
                                let _e3167 = local.member_1[0u];
                                if (_e3167[0] < 0f) {
                                    phi_5758_ = -(_e3167[0]);
                                } else {
                                    phi_5758_ = _e3167[0];
                                }
                                let _e3174 = phi_5758_;
                                if (_e3167[1] < 0f) {
                                    phi_5765_ = -(_e3167[1]);
                                } else {
                                    phi_5765_ = _e3167[1];
                                }
                                let _e3178 = phi_5765_;
                                if (_e3174 > _e3178) {
                                    phi_5770_ = _e3174;
                                } else {
                                    phi_5770_ = _e3178;
                                }
                                let _e3181 = phi_5770_;
                                if (_e3167[2] < 0f) {
                                    phi_5777_ = -(_e3167[2]);
                                } else {
                                    phi_5777_ = _e3167[2];
                                }
                                let _e3185 = phi_5777_;
                                if (_e3181 > _e3185) {
                                    phi_5782_ = _e3181;
                                } else {
                                    phi_5782_ = _e3185;
                                }
                                let _e3188 = phi_5782_;
                                let _e3191 = local.member_1[1u];
                                if (_e3191[0] < 0f) {
                                    phi_5796_ = -(_e3191[0]);
                                } else {
                                    phi_5796_ = _e3191[0];
                                }
                                let _e3198 = phi_5796_;
                                if (_e3191[1] < 0f) {
                                    phi_5803_ = -(_e3191[1]);
                                } else {
                                    phi_5803_ = _e3191[1];
                                }
                                let _e3202 = phi_5803_;
                                if (_e3198 > _e3202) {
                                    phi_5808_ = _e3198;
                                } else {
                                    phi_5808_ = _e3202;
                                }
                                let _e3205 = phi_5808_;
                                if (_e3191[2] < 0f) {
                                    phi_5815_ = -(_e3191[2]);
                                } else {
                                    phi_5815_ = _e3191[2];
                                }
                                let _e3209 = phi_5815_;
                                if (_e3205 > _e3209) {
                                    phi_5820_ = _e3205;
                                } else {
                                    phi_5820_ = _e3209;
                                }
                                let _e3212 = phi_5820_;
                                if (_e3188 > _e3212) {
                                    phi_5825_ = _e3188;
                                } else {
                                    phi_5825_ = _e3212;
                                }
                                let _e3215 = phi_5825_;
                                let _e3217 = local.member_3;
                                let _e3218 = (_e3215 + _e3217);
                                let _e3221 = local.member_2[0u];
                                if (_e3221[0] < 0f) {
                                    phi_5842_ = -(_e3221[0]);
                                } else {
                                    phi_5842_ = _e3221[0];
                                }
                                let _e3228 = phi_5842_;
                                if (_e3221[1] < 0f) {
                                    phi_5849_ = -(_e3221[1]);
                                } else {
                                    phi_5849_ = _e3221[1];
                                }
                                let _e3232 = phi_5849_;
                                if (_e3228 > _e3232) {
                                    phi_5854_ = _e3228;
                                } else {
                                    phi_5854_ = _e3232;
                                }
                                let _e3235 = phi_5854_;
                                if (_e3221[2] < 0f) {
                                    phi_5861_ = -(_e3221[2]);
                                } else {
                                    phi_5861_ = _e3221[2];
                                }
                                let _e3239 = phi_5861_;
                                if (_e3235 > _e3239) {
                                    phi_5866_ = _e3235;
                                } else {
                                    phi_5866_ = _e3239;
                                }
                                let _e3242 = phi_5866_;
                                let _e3245 = local.member_2[1u];
                                if (_e3245[0] < 0f) {
                                    phi_5880_ = -(_e3245[0]);
                                } else {
                                    phi_5880_ = _e3245[0];
                                }
                                let _e3252 = phi_5880_;
                                if (_e3245[1] < 0f) {
                                    phi_5887_ = -(_e3245[1]);
                                } else {
                                    phi_5887_ = _e3245[1];
                                }
                                let _e3256 = phi_5887_;
                                if (_e3252 > _e3256) {
                                    phi_5892_ = _e3252;
                                } else {
                                    phi_5892_ = _e3256;
                                }
                                let _e3259 = phi_5892_;
                                if (_e3245[2] < 0f) {
                                    phi_5899_ = -(_e3245[2]);
                                } else {
                                    phi_5899_ = _e3245[2];
                                }
                                let _e3263 = phi_5899_;
                                if (_e3259 > _e3263) {
                                    phi_5904_ = _e3259;
                                } else {
                                    phi_5904_ = _e3263;
                                }
                                let _e3266 = phi_5904_;
                                if (_e3242 > _e3266) {
                                    phi_5909_ = _e3242;
                                } else {
                                    phi_5909_ = _e3266;
                                }
                                let _e3269 = phi_5909_;
                                let _e3271 = local.member_3;
                                let _e3272 = (_e3269 + _e3271);
                                let _e3274 = ((_e3218 * 8f) * _e3272);
                                let _e3281 = local.member_3;
                                if (_e2970 < 0f) {
                                    phi_5940_ = -(_e2970);
                                } else {
                                    phi_5940_ = _e2970;
                                }
                                let _e3298 = phi_5940_;
                                if (_e2973 < 0f) {
                                    phi_5946_ = -(_e2973);
                                } else {
                                    phi_5946_ = _e2973;
                                }
                                let _e3302 = phi_5946_;
                                if (_e2976 < 0f) {
                                    phi_5953_ = -(_e2976);
                                } else {
                                    phi_5953_ = _e2976;
                                }
                                let _e3307 = phi_5953_;
                                let _e3308 = ((_e3298 + _e3302) + _e3307);
                                if (_e2991 < 0f) {
                                    phi_5960_ = -(_e2991);
                                } else {
                                    phi_5960_ = _e2991;
                                }
                                let _e3312 = phi_5960_;
                                if (_e2994 < 0f) {
                                    phi_5966_ = -(_e2994);
                                } else {
                                    phi_5966_ = _e2994;
                                }
                                let _e3316 = phi_5966_;
                                if (_e2997 < 0f) {
                                    phi_5973_ = -(_e2997);
                                } else {
                                    phi_5973_ = _e2997;
                                }
                                let _e3321 = phi_5973_;
                                let _e3322 = ((_e3312 + _e3316) + _e3321);
                                if (_e3308 > _e3322) {
                                    phi_5979_ = _e3308;
                                } else {
                                    phi_5979_ = _e3322;
                                }
                                let _e3325 = phi_5979_;
                                if (_e3040 < 0f) {
                                    phi_5985_ = -(_e3040);
                                } else {
                                    phi_5985_ = _e3040;
                                }
                                let _e3329 = phi_5985_;
                                if (_e3041 < 0f) {
                                    phi_5991_ = -(_e3041);
                                } else {
                                    phi_5991_ = _e3041;
                                }
                                let _e3333 = phi_5991_;
                                if (_e3042 < 0f) {
                                    phi_5998_ = -(_e3042);
                                } else {
                                    phi_5998_ = _e3042;
                                }
                                let _e3338 = phi_5998_;
                                let _e3340 = (((_e3329 + _e3333) + _e3338) * 0.5f);
                                if (_e3325 > _e3340) {
                                    phi_6005_ = _e3325;
                                } else {
                                    phi_6005_ = _e3340;
                                }
                                let _e3343 = phi_6005_;
                                let _e3348 = local.member_3;
                                let _e3361 = ((((_e3045[0] * _e2970) + (_e3045[1] * _e2973)) + (_e3045[2] * _e2976)) * 3f);
                                let _e3362 = ((((_e3102[0] * _e2991) + (_e3102[1] * _e2994)) + (_e3102[2] * _e2997)) * 3f);
                                if (_e3361 < _e3362) {
                                    phi_6029_ = _e3361;
                                } else {
                                    phi_6029_ = _e3362;
                                }
                                let _e3365 = phi_6029_;
                                if (_e3076 < _e3099) {
                                    phi_6034_ = _e3076;
                                } else {
                                    phi_6034_ = _e3099;
                                }
                                let _e3368 = phi_6034_;
                                if (_e3365 < _e3368) {
                                    phi_6039_ = _e3365;
                                } else {
                                    phi_6039_ = _e3368;
                                }
                                let _e3371 = phi_6039_;
                                if (_e3361 > _e3362) {
                                    phi_6044_ = _e3361;
                                } else {
                                    phi_6044_ = _e3362;
                                }
                                let _e3374 = phi_6044_;
                                if (_e3076 > _e3099) {
                                    phi_6049_ = _e3076;
                                } else {
                                    phi_6049_ = _e3099;
                                }
                                let _e3377 = phi_6049_;
                                if (_e3374 > _e3377) {
                                    phi_6054_ = _e3374;
                                } else {
                                    phi_6054_ = _e3377;
                                }
                                let _e3380 = phi_6054_;
                                let _e3385 = -(_e3380);
                                if (_e3371 > _e3385) {
                                    phi_6064_ = _e3371;
                                } else {
                                    phi_6064_ = _e3385;
                                }
                                let _e3388 = phi_6064_;
                                let _e3390 = ((_e3388 - ((((((_e3164 * 8f) * _e3274) * (0.000000059604645f * (524f / 64f))) + ((_e3281 * 19f) * ((_e3164 * (_e3218 + _e3272)) + (_e3218 * _e3272)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3164) * ((1f + _e3218) * (1f + _e3272))))) + ((_e1853 * (((_e3343 + (_e3274 * (0.000000059604645f * 8f))) + ((_e3348 * 6f) * (_e3218 + _e3272))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3218) * (1f + _e3272))))) * (3f * 1.0001f)))) > 0f);
                                if _e3390 {
                                    phi_7033_ = _e3390;
                                } else {
                                    let _e3393 = local.member_1[0u];
                                    let _e3399 = local.member_1[1u];
                                    let _e3403 = (_e3393[0] + _e3399[0]);
                                    let _e3404 = (_e3393[1] + _e3399[1]);
                                    let _e3405 = (_e3393[2] + _e3399[2]);
                                    let _e3408 = local.member_2[0u];
                                    let _e3414 = local.member_2[1u];
                                    let _e3418 = (_e3408[0] + _e3414[0]);
                                    let _e3419 = (_e3408[1] + _e3414[1]);
                                    let _e3420 = (_e3408[2] + _e3414[2]);
                                    let _e3423 = ((_e3404 * _e3420) - (_e3405 * _e3419));
                                    let _e3426 = ((_e3405 * _e3418) - (_e3403 * _e3420));
                                    let _e3429 = ((_e3403 * _e3419) - (_e3404 * _e3418));
                                    let _e3432 = local.member[0u];
                                    let _e3438 = local.member_1[0u];
                                    let _e3444 = local.member_2[0u];
                                    let _e3448 = (_e3432[0] - _e3438[0]);
                                    let _e3449 = (_e3432[1] - _e3438[1]);
                                    let _e3450 = (_e3432[2] - _e3438[2]);
                                    let _e3451 = (_e3448 - _e3444[0]);
                                    let _e3452 = (_e3449 - _e3444[1]);
                                    let _e3453 = (_e3450 - _e3444[2]);
                                    let _e3454 = (_e3432[0] - _e3444[0]);
                                    let _e3455 = (_e3432[1] - _e3444[1]);
                                    let _e3456 = (_e3432[2] - _e3444[2]);
                                    let _e3459 = local.member[1u];
                                    let _e3465 = local.member_1[1u];
                                    let _e3471 = local.member_2[1u];
                                    let _e3475 = (_e3459[0] - _e3465[0]);
                                    let _e3476 = (_e3459[1] - _e3465[1]);
                                    let _e3477 = (_e3459[2] - _e3465[2]);
                                    let _e3478 = (_e3475 - _e3471[0]);
                                    let _e3479 = (_e3476 - _e3471[1]);
                                    let _e3480 = (_e3477 - _e3471[2]);
                                    let _e3481 = (_e3459[0] - _e3471[0]);
                                    let _e3482 = (_e3459[1] - _e3471[1]);
                                    let _e3483 = (_e3459[2] - _e3471[2]);
                                    let _e3486 = local.member[0u];
                                    if (_e3486[0] < 0f) {
                                        phi_6267_ = -(_e3486[0]);
                                    } else {
                                        phi_6267_ = _e3486[0];
                                    }
                                    let _e3493 = phi_6267_;
                                    if (_e3486[1] < 0f) {
                                        phi_6274_ = -(_e3486[1]);
                                    } else {
                                        phi_6274_ = _e3486[1];
                                    }
                                    let _e3497 = phi_6274_;
                                    if (_e3493 > _e3497) {
                                        phi_6279_ = _e3493;
                                    } else {
                                        phi_6279_ = _e3497;
                                    }
                                    let _e3500 = phi_6279_;
                                    if (_e3486[2] < 0f) {
                                        phi_6286_ = -(_e3486[2]);
                                    } else {
                                        phi_6286_ = _e3486[2];
                                    }
                                    let _e3504 = phi_6286_;
                                    if (_e3500 > _e3504) {
                                        phi_6291_ = _e3500;
                                    } else {
                                        phi_6291_ = _e3504;
                                    }
                                    let _e3507 = phi_6291_;
                                    let _e3510 = local.member[1u];
                                    if (_e3510[0] < 0f) {
                                        phi_6304_ = -(_e3510[0]);
                                    } else {
                                        phi_6304_ = _e3510[0];
                                    }
                                    let _e3517 = phi_6304_;
                                    if (_e3510[1] < 0f) {
                                        phi_6311_ = -(_e3510[1]);
                                    } else {
                                        phi_6311_ = _e3510[1];
                                    }
                                    let _e3521 = phi_6311_;
                                    if (_e3517 > _e3521) {
                                        phi_6316_ = _e3517;
                                    } else {
                                        phi_6316_ = _e3521;
                                    }
                                    let _e3524 = phi_6316_;
                                    if (_e3510[2] < 0f) {
                                        phi_6323_ = -(_e3510[2]);
                                    } else {
                                        phi_6323_ = _e3510[2];
                                    }
                                    let _e3528 = phi_6323_;
                                    if (_e3524 > _e3528) {
                                        phi_6328_ = _e3524;
                                    } else {
                                        phi_6328_ = _e3528;
                                    }
                                    let _e3531 = phi_6328_;
                                    if (_e3507 > _e3531) {
                                        phi_6333_ = _e3507;
                                    } else {
                                        phi_6333_ = _e3531;
                                    }
                                    let _e3534 = phi_6333_;
                                    let _e3536 = local.member_3;
                                    let _e3540 = local.member_1[0u];
                                    if (_e3540[0] < 0f) {
                                        phi_6350_ = -(_e3540[0]);
                                    } else {
                                        phi_6350_ = _e3540[0];
                                    }
                                    let _e3547 = phi_6350_;
                                    if (_e3540[1] < 0f) {
                                        phi_6357_ = -(_e3540[1]);
                                    } else {
                                        phi_6357_ = _e3540[1];
                                    }
                                    let _e3551 = phi_6357_;
                                    if (_e3547 > _e3551) {
                                        phi_6362_ = _e3547;
                                    } else {
                                        phi_6362_ = _e3551;
                                    }
                                    let _e3554 = phi_6362_;
                                    if (_e3540[2] < 0f) {
                                        phi_6369_ = -(_e3540[2]);
                                    } else {
                                        phi_6369_ = _e3540[2];
                                    }
                                    let _e3558 = phi_6369_;
                                    if (_e3554 > _e3558) {
                                        phi_6374_ = _e3554;
                                    } else {
                                        phi_6374_ = _e3558;
                                    }
                                    let _e3561 = phi_6374_;
                                    let _e3564 = local.member_1[1u];
                                    if (_e3564[0] < 0f) {
                                        phi_6388_ = -(_e3564[0]);
                                    } else {
                                        phi_6388_ = _e3564[0];
                                    }
                                    let _e3571 = phi_6388_;
                                    if (_e3564[1] < 0f) {
                                        phi_6395_ = -(_e3564[1]);
                                    } else {
                                        phi_6395_ = _e3564[1];
                                    }
                                    let _e3575 = phi_6395_;
                                    if (_e3571 > _e3575) {
                                        phi_6400_ = _e3571;
                                    } else {
                                        phi_6400_ = _e3575;
                                    }
                                    let _e3578 = phi_6400_;
                                    if (_e3564[2] < 0f) {
                                        phi_6407_ = -(_e3564[2]);
                                    } else {
                                        phi_6407_ = _e3564[2];
                                    }
                                    let _e3582 = phi_6407_;
                                    if (_e3578 > _e3582) {
                                        phi_6412_ = _e3578;
                                    } else {
                                        phi_6412_ = _e3582;
                                    }
                                    let _e3585 = phi_6412_;
                                    if (_e3561 > _e3585) {
                                        phi_6417_ = _e3561;
                                    } else {
                                        phi_6417_ = _e3585;
                                    }
                                    let _e3588 = phi_6417_;
                                    let _e3590 = local.member_3;
                                    let _e3594 = local.member_2[0u];
                                    if (_e3594[0] < 0f) {
                                        phi_6434_ = -(_e3594[0]);
                                    } else {
                                        phi_6434_ = _e3594[0];
                                    }
                                    let _e3601 = phi_6434_;
                                    if (_e3594[1] < 0f) {
                                        phi_6441_ = -(_e3594[1]);
                                    } else {
                                        phi_6441_ = _e3594[1];
                                    }
                                    let _e3605 = phi_6441_;
                                    if (_e3601 > _e3605) {
                                        phi_6446_ = _e3601;
                                    } else {
                                        phi_6446_ = _e3605;
                                    }
                                    let _e3608 = phi_6446_;
                                    if (_e3594[2] < 0f) {
                                        phi_6453_ = -(_e3594[2]);
                                    } else {
                                        phi_6453_ = _e3594[2];
                                    }
                                    let _e3612 = phi_6453_;
                                    if (_e3608 > _e3612) {
                                        phi_6458_ = _e3608;
                                    } else {
                                        phi_6458_ = _e3612;
                                    }
                                    let _e3615 = phi_6458_;
                                    let _e3618 = local.member_2[1u];
                                    if (_e3618[0] < 0f) {
                                        phi_6472_ = -(_e3618[0]);
                                    } else {
                                        phi_6472_ = _e3618[0];
                                    }
                                    let _e3625 = phi_6472_;
                                    if (_e3618[1] < 0f) {
                                        phi_6479_ = -(_e3618[1]);
                                    } else {
                                        phi_6479_ = _e3618[1];
                                    }
                                    let _e3629 = phi_6479_;
                                    if (_e3625 > _e3629) {
                                        phi_6484_ = _e3625;
                                    } else {
                                        phi_6484_ = _e3629;
                                    }
                                    let _e3632 = phi_6484_;
                                    if (_e3618[2] < 0f) {
                                        phi_6491_ = -(_e3618[2]);
                                    } else {
                                        phi_6491_ = _e3618[2];
                                    }
                                    let _e3636 = phi_6491_;
                                    if (_e3632 > _e3636) {
                                        phi_6496_ = _e3632;
                                    } else {
                                        phi_6496_ = _e3636;
                                    }
                                    let _e3639 = phi_6496_;
                                    if (_e3615 > _e3639) {
                                        phi_6501_ = _e3615;
                                    } else {
                                        phi_6501_ = _e3639;
                                    }
                                    let _e3642 = phi_6501_;
                                    let _e3644 = local.member_3;
                                    let _e3648 = ((((_e3534 + _e3536) + (_e3588 + _e3590)) + (_e3642 + _e3644)) * 2f);
                                    let _e3651 = local.member_3;
                                    let _e3655 = (((_e1853 * 1.0001f) + (_e3651 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3658 = ((_e3426 * _e3405) - (_e3429 * _e3404));
                                    let _e3661 = ((_e3429 * _e3403) - (_e3423 * _e3405));
                                    let _e3664 = ((_e3423 * _e3404) - (_e3426 * _e3403));
                                    let _e3669 = (((_e3658 * _e3432[0]) + (_e3661 * _e3432[1])) + (_e3664 * _e3432[2]));
                                    let _e3674 = (((_e3658 * _e3448) + (_e3661 * _e3449)) + (_e3664 * _e3450));
                                    let _e3679 = (((_e3658 * _e3454) + (_e3661 * _e3455)) + (_e3664 * _e3456));
                                    let _e3684 = (((_e3658 * _e3451) + (_e3661 * _e3452)) + (_e3664 * _e3453));
                                    let _e3689 = (((_e3658 * _e3459[0]) + (_e3661 * _e3459[1])) + (_e3664 * _e3459[2]));
                                    let _e3694 = (((_e3658 * _e3475) + (_e3661 * _e3476)) + (_e3664 * _e3477));
                                    let _e3699 = (((_e3658 * _e3481) + (_e3661 * _e3482)) + (_e3664 * _e3483));
                                    let _e3704 = (((_e3658 * _e3478) + (_e3661 * _e3479)) + (_e3664 * _e3480));
                                    if (_e3669 < _e3674) {
                                        phi_6580_ = _e3669;
                                    } else {
                                        phi_6580_ = _e3674;
                                    }
                                    let _e3707 = phi_6580_;
                                    if (_e3679 < _e3684) {
                                        phi_6585_ = _e3679;
                                    } else {
                                        phi_6585_ = _e3684;
                                    }
                                    let _e3710 = phi_6585_;
                                    if (_e3707 < _e3710) {
                                        phi_6590_ = _e3707;
                                    } else {
                                        phi_6590_ = _e3710;
                                    }
                                    let _e3713 = phi_6590_;
                                    if (_e3689 < _e3694) {
                                        phi_6595_ = _e3689;
                                    } else {
                                        phi_6595_ = _e3694;
                                    }
                                    let _e3716 = phi_6595_;
                                    if (_e3699 < _e3704) {
                                        phi_6600_ = _e3699;
                                    } else {
                                        phi_6600_ = _e3704;
                                    }
                                    let _e3719 = phi_6600_;
                                    if (_e3716 < _e3719) {
                                        phi_6605_ = _e3716;
                                    } else {
                                        phi_6605_ = _e3719;
                                    }
                                    let _e3722 = phi_6605_;
                                    if (_e3713 < _e3722) {
                                        phi_6610_ = _e3713;
                                    } else {
                                        phi_6610_ = _e3722;
                                    }
                                    let _e3725 = phi_6610_;
                                    if (_e3669 > _e3674) {
                                        phi_6615_ = _e3669;
                                    } else {
                                        phi_6615_ = _e3674;
                                    }
                                    let _e3728 = phi_6615_;
                                    if (_e3679 > _e3684) {
                                        phi_6620_ = _e3679;
                                    } else {
                                        phi_6620_ = _e3684;
                                    }
                                    let _e3731 = phi_6620_;
                                    if (_e3728 > _e3731) {
                                        phi_6625_ = _e3728;
                                    } else {
                                        phi_6625_ = _e3731;
                                    }
                                    let _e3734 = phi_6625_;
                                    if (_e3689 > _e3694) {
                                        phi_6630_ = _e3689;
                                    } else {
                                        phi_6630_ = _e3694;
                                    }
                                    let _e3737 = phi_6630_;
                                    if (_e3699 > _e3704) {
                                        phi_6635_ = _e3699;
                                    } else {
                                        phi_6635_ = _e3704;
                                    }
                                    let _e3740 = phi_6635_;
                                    if (_e3737 > _e3740) {
                                        phi_6640_ = _e3737;
                                    } else {
                                        phi_6640_ = _e3740;
                                    }
                                    let _e3743 = phi_6640_;
                                    if (_e3734 > _e3743) {
                                        phi_6645_ = _e3734;
                                    } else {
                                        phi_6645_ = _e3743;
                                    }
                                    let _e3746 = phi_6645_;
                                    if (_e3658 < 0f) {
                                        phi_6651_ = -(_e3658);
                                    } else {
                                        phi_6651_ = _e3658;
                                    }
                                    let _e3750 = phi_6651_;
                                    if (_e3661 < 0f) {
                                        phi_6657_ = -(_e3661);
                                    } else {
                                        phi_6657_ = _e3661;
                                    }
                                    let _e3754 = phi_6657_;
                                    if (_e3664 < 0f) {
                                        phi_6664_ = -(_e3664);
                                    } else {
                                        phi_6664_ = _e3664;
                                    }
                                    let _e3759 = phi_6664_;
                                    let _e3760 = ((_e3750 + _e3754) + _e3759);
                                    let _e3765 = -(_e3746);
                                    if (_e3725 > _e3765) {
                                        phi_6675_ = _e3725;
                                    } else {
                                        phi_6675_ = _e3765;
                                    }
                                    let _e3768 = phi_6675_;
                                    let _e3773 = (((_e3768 - ((_e3760 * _e3648) * (0.000000059604645f * (17f / 2f)))) - (_e3760 * _e3655)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e3776 = ((_e3426 * _e3420) - (_e3429 * _e3419));
                                    let _e3779 = ((_e3429 * _e3418) - (_e3423 * _e3420));
                                    let _e3782 = ((_e3423 * _e3419) - (_e3426 * _e3418));
                                    let _e3787 = (((_e3776 * _e3432[0]) + (_e3779 * _e3432[1])) + (_e3782 * _e3432[2]));
                                    let _e3792 = (((_e3776 * _e3448) + (_e3779 * _e3449)) + (_e3782 * _e3450));
                                    let _e3797 = (((_e3776 * _e3454) + (_e3779 * _e3455)) + (_e3782 * _e3456));
                                    let _e3802 = (((_e3776 * _e3451) + (_e3779 * _e3452)) + (_e3782 * _e3453));
                                    let _e3807 = (((_e3776 * _e3459[0]) + (_e3779 * _e3459[1])) + (_e3782 * _e3459[2]));
                                    let _e3812 = (((_e3776 * _e3475) + (_e3779 * _e3476)) + (_e3782 * _e3477));
                                    let _e3817 = (((_e3776 * _e3481) + (_e3779 * _e3482)) + (_e3782 * _e3483));
                                    let _e3822 = (((_e3776 * _e3478) + (_e3779 * _e3479)) + (_e3782 * _e3480));
                                    if (_e3787 < _e3792) {
                                        phi_6746_ = _e3787;
                                    } else {
                                        phi_6746_ = _e3792;
                                    }
                                    let _e3825 = phi_6746_;
                                    if (_e3797 < _e3802) {
                                        phi_6751_ = _e3797;
                                    } else {
                                        phi_6751_ = _e3802;
                                    }
                                    let _e3828 = phi_6751_;
                                    if (_e3825 < _e3828) {
                                        phi_6756_ = _e3825;
                                    } else {
                                        phi_6756_ = _e3828;
                                    }
                                    let _e3831 = phi_6756_;
                                    if (_e3807 < _e3812) {
                                        phi_6761_ = _e3807;
                                    } else {
                                        phi_6761_ = _e3812;
                                    }
                                    let _e3834 = phi_6761_;
                                    if (_e3817 < _e3822) {
                                        phi_6766_ = _e3817;
                                    } else {
                                        phi_6766_ = _e3822;
                                    }
                                    let _e3837 = phi_6766_;
                                    if (_e3834 < _e3837) {
                                        phi_6771_ = _e3834;
                                    } else {
                                        phi_6771_ = _e3837;
                                    }
                                    let _e3840 = phi_6771_;
                                    if (_e3831 < _e3840) {
                                        phi_6776_ = _e3831;
                                    } else {
                                        phi_6776_ = _e3840;
                                    }
                                    let _e3843 = phi_6776_;
                                    if (_e3787 > _e3792) {
                                        phi_6781_ = _e3787;
                                    } else {
                                        phi_6781_ = _e3792;
                                    }
                                    let _e3846 = phi_6781_;
                                    if (_e3797 > _e3802) {
                                        phi_6786_ = _e3797;
                                    } else {
                                        phi_6786_ = _e3802;
                                    }
                                    let _e3849 = phi_6786_;
                                    if (_e3846 > _e3849) {
                                        phi_6791_ = _e3846;
                                    } else {
                                        phi_6791_ = _e3849;
                                    }
                                    let _e3852 = phi_6791_;
                                    if (_e3807 > _e3812) {
                                        phi_6796_ = _e3807;
                                    } else {
                                        phi_6796_ = _e3812;
                                    }
                                    let _e3855 = phi_6796_;
                                    if (_e3817 > _e3822) {
                                        phi_6801_ = _e3817;
                                    } else {
                                        phi_6801_ = _e3822;
                                    }
                                    let _e3858 = phi_6801_;
                                    if (_e3855 > _e3858) {
                                        phi_6806_ = _e3855;
                                    } else {
                                        phi_6806_ = _e3858;
                                    }
                                    let _e3861 = phi_6806_;
                                    if (_e3852 > _e3861) {
                                        phi_6811_ = _e3852;
                                    } else {
                                        phi_6811_ = _e3861;
                                    }
                                    let _e3864 = phi_6811_;
                                    if (_e3776 < 0f) {
                                        phi_6817_ = -(_e3776);
                                    } else {
                                        phi_6817_ = _e3776;
                                    }
                                    let _e3868 = phi_6817_;
                                    if (_e3779 < 0f) {
                                        phi_6823_ = -(_e3779);
                                    } else {
                                        phi_6823_ = _e3779;
                                    }
                                    let _e3872 = phi_6823_;
                                    if (_e3782 < 0f) {
                                        phi_6830_ = -(_e3782);
                                    } else {
                                        phi_6830_ = _e3782;
                                    }
                                    let _e3877 = phi_6830_;
                                    let _e3878 = ((_e3868 + _e3872) + _e3877);
                                    let _e3883 = -(_e3864);
                                    if (_e3843 > _e3883) {
                                        phi_6841_ = _e3843;
                                    } else {
                                        phi_6841_ = _e3883;
                                    }
                                    let _e3886 = phi_6841_;
                                    let _e3891 = (((_e3886 - ((_e3878 * _e3648) * (0.000000059604645f * (17f / 2f)))) - (_e3878 * _e3655)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e3773 > _e3891) {
                                        phi_6851_ = _e3773;
                                    } else {
                                        phi_6851_ = _e3891;
                                    }
                                    let _e3894 = phi_6851_;
                                    phi_7033_ = (_e3390 || (_e3894 > 0f));
                                }
                                let _e3898 = phi_7033_;
                                if _e3898 {
                                    let _e3901 = local_1.member_1[0u];
                                    let _e3907 = local_1.member_2[0u];
                                    let _e3913 = ((_e3901[1] * _e3907[2]) - (_e3901[2] * _e3907[1]));
                                    let _e3916 = ((_e3901[2] * _e3907[0]) - (_e3901[0] * _e3907[2]));
                                    let _e3919 = ((_e3901[0] * _e3907[1]) - (_e3901[1] * _e3907[0]));
                                    let _e3922 = local_1.member_1[1u];
                                    let _e3928 = local_1.member_2[1u];
                                    let _e3934 = ((_e3922[1] * _e3928[2]) - (_e3922[2] * _e3928[1]));
                                    let _e3937 = ((_e3922[2] * _e3928[0]) - (_e3922[0] * _e3928[2]));
                                    let _e3940 = ((_e3922[0] * _e3928[1]) - (_e3922[1] * _e3928[0]));
                                    let _e3943 = local_1.member_1[0u];
                                    let _e3949 = local_1.member_2[1u];
                                    let _e3964 = local_1.member_1[1u];
                                    let _e3970 = local_1.member_2[0u];
                                    let _e3983 = (((_e3943[1] * _e3949[2]) - (_e3943[2] * _e3949[1])) + ((_e3964[1] * _e3970[2]) - (_e3964[2] * _e3970[1])));
                                    let _e3984 = (((_e3943[2] * _e3949[0]) - (_e3943[0] * _e3949[2])) + ((_e3964[2] * _e3970[0]) - (_e3964[0] * _e3970[2])));
                                    let _e3985 = (((_e3943[0] * _e3949[1]) - (_e3943[1] * _e3949[0])) + ((_e3964[0] * _e3970[1]) - (_e3964[1] * _e3970[0])));
                                    let _e3988 = local_1.member[0u];
                                    let _e3999 = local_1.member[1u];
                                    let _e4010 = local_1.member[0u];
                                    let _e4019 = ((((_e3999[0] * _e3913) + (_e3999[1] * _e3916)) + (_e3999[2] * _e3919)) + (((_e4010[0] * _e3983) + (_e4010[1] * _e3984)) + (_e4010[2] * _e3985)));
                                    let _e4022 = local_1.member[0u];
                                    let _e4033 = local_1.member[1u];
                                    let _e4042 = ((((_e4022[0] * _e3934) + (_e4022[1] * _e3937)) + (_e4022[2] * _e3940)) + (((_e4033[0] * _e3983) + (_e4033[1] * _e3984)) + (_e4033[2] * _e3985)));
                                    let _e4045 = local_1.member[1u];
                                    let _e4056 = local_1.member[0u];
                                    if (_e4056[0] < 0f) {
                                        phi_7278_ = -(_e4056[0]);
                                    } else {
                                        phi_7278_ = _e4056[0];
                                    }
                                    let _e4063 = phi_7278_;
                                    if (_e4056[1] < 0f) {
                                        phi_7285_ = -(_e4056[1]);
                                    } else {
                                        phi_7285_ = _e4056[1];
                                    }
                                    let _e4067 = phi_7285_;
                                    if (_e4063 > _e4067) {
                                        phi_7290_ = _e4063;
                                    } else {
                                        phi_7290_ = _e4067;
                                    }
                                    let _e4070 = phi_7290_;
                                    if (_e4056[2] < 0f) {
                                        phi_7297_ = -(_e4056[2]);
                                    } else {
                                        phi_7297_ = _e4056[2];
                                    }
                                    let _e4074 = phi_7297_;
                                    if (_e4070 > _e4074) {
                                        phi_7302_ = _e4070;
                                    } else {
                                        phi_7302_ = _e4074;
                                    }
                                    let _e4077 = phi_7302_;
                                    let _e4080 = local_1.member[1u];
                                    if (_e4080[0] < 0f) {
                                        phi_7315_ = -(_e4080[0]);
                                    } else {
                                        phi_7315_ = _e4080[0];
                                    }
                                    let _e4087 = phi_7315_;
                                    if (_e4080[1] < 0f) {
                                        phi_7322_ = -(_e4080[1]);
                                    } else {
                                        phi_7322_ = _e4080[1];
                                    }
                                    let _e4091 = phi_7322_;
                                    if (_e4087 > _e4091) {
                                        phi_7327_ = _e4087;
                                    } else {
                                        phi_7327_ = _e4091;
                                    }
                                    let _e4094 = phi_7327_;
                                    if (_e4080[2] < 0f) {
                                        phi_7334_ = -(_e4080[2]);
                                    } else {
                                        phi_7334_ = _e4080[2];
                                    }
                                    let _e4098 = phi_7334_;
                                    if (_e4094 > _e4098) {
                                        phi_7339_ = _e4094;
                                    } else {
                                        phi_7339_ = _e4098;
                                    }
                                    let _e4101 = phi_7339_;
                                    if (_e4077 > _e4101) {
                                        phi_7344_ = _e4077;
                                    } else {
                                        phi_7344_ = _e4101;
                                    }
                                    let _e4104 = phi_7344_;
                                    let _e4106 = local_1.member_3;
                                    let _e4107 = (_e4104 + _e4106);
                                    let _e4110 = local_1.member_1[0u];
                                    if (_e4110[0] < 0f) {
                                        phi_7361_ = -(_e4110[0]);
                                    } else {
                                        phi_7361_ = _e4110[0];
                                    }
                                    let _e4117 = phi_7361_;
                                    if (_e4110[1] < 0f) {
                                        phi_7368_ = -(_e4110[1]);
                                    } else {
                                        phi_7368_ = _e4110[1];
                                    }
                                    let _e4121 = phi_7368_;
                                    if (_e4117 > _e4121) {
                                        phi_7373_ = _e4117;
                                    } else {
                                        phi_7373_ = _e4121;
                                    }
                                    let _e4124 = phi_7373_;
                                    if (_e4110[2] < 0f) {
                                        phi_7380_ = -(_e4110[2]);
                                    } else {
                                        phi_7380_ = _e4110[2];
                                    }
                                    let _e4128 = phi_7380_;
                                    if (_e4124 > _e4128) {
                                        phi_7385_ = _e4124;
                                    } else {
                                        phi_7385_ = _e4128;
                                    }
                                    let _e4131 = phi_7385_;
                                    let _e4134 = local_1.member_1[1u];
                                    if (_e4134[0] < 0f) {
                                        phi_7399_ = -(_e4134[0]);
                                    } else {
                                        phi_7399_ = _e4134[0];
                                    }
                                    let _e4141 = phi_7399_;
                                    if (_e4134[1] < 0f) {
                                        phi_7406_ = -(_e4134[1]);
                                    } else {
                                        phi_7406_ = _e4134[1];
                                    }
                                    let _e4145 = phi_7406_;
                                    if (_e4141 > _e4145) {
                                        phi_7411_ = _e4141;
                                    } else {
                                        phi_7411_ = _e4145;
                                    }
                                    let _e4148 = phi_7411_;
                                    if (_e4134[2] < 0f) {
                                        phi_7418_ = -(_e4134[2]);
                                    } else {
                                        phi_7418_ = _e4134[2];
                                    }
                                    let _e4152 = phi_7418_;
                                    if (_e4148 > _e4152) {
                                        phi_7423_ = _e4148;
                                    } else {
                                        phi_7423_ = _e4152;
                                    }
                                    let _e4155 = phi_7423_;
                                    if (_e4131 > _e4155) {
                                        phi_7428_ = _e4131;
                                    } else {
                                        phi_7428_ = _e4155;
                                    }
                                    let _e4158 = phi_7428_;
                                    let _e4160 = local_1.member_3;
                                    let _e4161 = (_e4158 + _e4160);
                                    let _e4164 = local_1.member_2[0u];
                                    if (_e4164[0] < 0f) {
                                        phi_7445_ = -(_e4164[0]);
                                    } else {
                                        phi_7445_ = _e4164[0];
                                    }
                                    let _e4171 = phi_7445_;
                                    if (_e4164[1] < 0f) {
                                        phi_7452_ = -(_e4164[1]);
                                    } else {
                                        phi_7452_ = _e4164[1];
                                    }
                                    let _e4175 = phi_7452_;
                                    if (_e4171 > _e4175) {
                                        phi_7457_ = _e4171;
                                    } else {
                                        phi_7457_ = _e4175;
                                    }
                                    let _e4178 = phi_7457_;
                                    if (_e4164[2] < 0f) {
                                        phi_7464_ = -(_e4164[2]);
                                    } else {
                                        phi_7464_ = _e4164[2];
                                    }
                                    let _e4182 = phi_7464_;
                                    if (_e4178 > _e4182) {
                                        phi_7469_ = _e4178;
                                    } else {
                                        phi_7469_ = _e4182;
                                    }
                                    let _e4185 = phi_7469_;
                                    let _e4188 = local_1.member_2[1u];
                                    if (_e4188[0] < 0f) {
                                        phi_7483_ = -(_e4188[0]);
                                    } else {
                                        phi_7483_ = _e4188[0];
                                    }
                                    let _e4195 = phi_7483_;
                                    if (_e4188[1] < 0f) {
                                        phi_7490_ = -(_e4188[1]);
                                    } else {
                                        phi_7490_ = _e4188[1];
                                    }
                                    let _e4199 = phi_7490_;
                                    if (_e4195 > _e4199) {
                                        phi_7495_ = _e4195;
                                    } else {
                                        phi_7495_ = _e4199;
                                    }
                                    let _e4202 = phi_7495_;
                                    if (_e4188[2] < 0f) {
                                        phi_7502_ = -(_e4188[2]);
                                    } else {
                                        phi_7502_ = _e4188[2];
                                    }
                                    let _e4206 = phi_7502_;
                                    if (_e4202 > _e4206) {
                                        phi_7507_ = _e4202;
                                    } else {
                                        phi_7507_ = _e4206;
                                    }
                                    let _e4209 = phi_7507_;
                                    if (_e4185 > _e4209) {
                                        phi_7512_ = _e4185;
                                    } else {
                                        phi_7512_ = _e4209;
                                    }
                                    let _e4212 = phi_7512_;
                                    let _e4214 = local_1.member_3;
                                    let _e4215 = (_e4212 + _e4214);
                                    let _e4217 = ((_e4161 * 8f) * _e4215);
                                    let _e4224 = local_1.member_3;
                                    if (_e3913 < 0f) {
                                        phi_7543_ = -(_e3913);
                                    } else {
                                        phi_7543_ = _e3913;
                                    }
                                    let _e4241 = phi_7543_;
                                    if (_e3916 < 0f) {
                                        phi_7549_ = -(_e3916);
                                    } else {
                                        phi_7549_ = _e3916;
                                    }
                                    let _e4245 = phi_7549_;
                                    if (_e3919 < 0f) {
                                        phi_7556_ = -(_e3919);
                                    } else {
                                        phi_7556_ = _e3919;
                                    }
                                    let _e4250 = phi_7556_;
                                    let _e4251 = ((_e4241 + _e4245) + _e4250);
                                    if (_e3934 < 0f) {
                                        phi_7563_ = -(_e3934);
                                    } else {
                                        phi_7563_ = _e3934;
                                    }
                                    let _e4255 = phi_7563_;
                                    if (_e3937 < 0f) {
                                        phi_7569_ = -(_e3937);
                                    } else {
                                        phi_7569_ = _e3937;
                                    }
                                    let _e4259 = phi_7569_;
                                    if (_e3940 < 0f) {
                                        phi_7576_ = -(_e3940);
                                    } else {
                                        phi_7576_ = _e3940;
                                    }
                                    let _e4264 = phi_7576_;
                                    let _e4265 = ((_e4255 + _e4259) + _e4264);
                                    if (_e4251 > _e4265) {
                                        phi_7582_ = _e4251;
                                    } else {
                                        phi_7582_ = _e4265;
                                    }
                                    let _e4268 = phi_7582_;
                                    if (_e3983 < 0f) {
                                        phi_7588_ = -(_e3983);
                                    } else {
                                        phi_7588_ = _e3983;
                                    }
                                    let _e4272 = phi_7588_;
                                    if (_e3984 < 0f) {
                                        phi_7594_ = -(_e3984);
                                    } else {
                                        phi_7594_ = _e3984;
                                    }
                                    let _e4276 = phi_7594_;
                                    if (_e3985 < 0f) {
                                        phi_7601_ = -(_e3985);
                                    } else {
                                        phi_7601_ = _e3985;
                                    }
                                    let _e4281 = phi_7601_;
                                    let _e4283 = (((_e4272 + _e4276) + _e4281) * 0.5f);
                                    if (_e4268 > _e4283) {
                                        phi_7608_ = _e4268;
                                    } else {
                                        phi_7608_ = _e4283;
                                    }
                                    let _e4286 = phi_7608_;
                                    let _e4291 = local_1.member_3;
                                    let _e4304 = ((((_e3988[0] * _e3913) + (_e3988[1] * _e3916)) + (_e3988[2] * _e3919)) * 3f);
                                    let _e4305 = ((((_e4045[0] * _e3934) + (_e4045[1] * _e3937)) + (_e4045[2] * _e3940)) * 3f);
                                    if (_e4304 < _e4305) {
                                        phi_7632_ = _e4304;
                                    } else {
                                        phi_7632_ = _e4305;
                                    }
                                    let _e4308 = phi_7632_;
                                    if (_e4019 < _e4042) {
                                        phi_7637_ = _e4019;
                                    } else {
                                        phi_7637_ = _e4042;
                                    }
                                    let _e4311 = phi_7637_;
                                    if (_e4308 < _e4311) {
                                        phi_7642_ = _e4308;
                                    } else {
                                        phi_7642_ = _e4311;
                                    }
                                    let _e4314 = phi_7642_;
                                    if (_e4304 > _e4305) {
                                        phi_7647_ = _e4304;
                                    } else {
                                        phi_7647_ = _e4305;
                                    }
                                    let _e4317 = phi_7647_;
                                    if (_e4019 > _e4042) {
                                        phi_7652_ = _e4019;
                                    } else {
                                        phi_7652_ = _e4042;
                                    }
                                    let _e4320 = phi_7652_;
                                    if (_e4317 > _e4320) {
                                        phi_7657_ = _e4317;
                                    } else {
                                        phi_7657_ = _e4320;
                                    }
                                    let _e4323 = phi_7657_;
                                    let _e4328 = -(_e4323);
                                    if (_e4314 > _e4328) {
                                        phi_7667_ = _e4314;
                                    } else {
                                        phi_7667_ = _e4328;
                                    }
                                    let _e4331 = phi_7667_;
                                    let _e4333 = ((_e4331 - ((((((_e4107 * 8f) * _e4217) * (0.000000059604645f * (524f / 64f))) + ((_e4224 * 19f) * ((_e4107 * (_e4161 + _e4215)) + (_e4161 * _e4215)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4107) * ((1f + _e4161) * (1f + _e4215))))) + ((_e1853 * (((_e4286 + (_e4217 * (0.000000059604645f * 8f))) + ((_e4291 * 6f) * (_e4161 + _e4215))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4161) * (1f + _e4215))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4333 {
                                        phi_8636_ = _e4333;
                                    } else {
                                        let _e4336 = local_1.member_1[0u];
                                        let _e4342 = local_1.member_1[1u];
                                        let _e4346 = (_e4336[0] + _e4342[0]);
                                        let _e4347 = (_e4336[1] + _e4342[1]);
                                        let _e4348 = (_e4336[2] + _e4342[2]);
                                        let _e4351 = local_1.member_2[0u];
                                        let _e4357 = local_1.member_2[1u];
                                        let _e4361 = (_e4351[0] + _e4357[0]);
                                        let _e4362 = (_e4351[1] + _e4357[1]);
                                        let _e4363 = (_e4351[2] + _e4357[2]);
                                        let _e4366 = ((_e4347 * _e4363) - (_e4348 * _e4362));
                                        let _e4369 = ((_e4348 * _e4361) - (_e4346 * _e4363));
                                        let _e4372 = ((_e4346 * _e4362) - (_e4347 * _e4361));
                                        let _e4375 = local_1.member[0u];
                                        let _e4381 = local_1.member_1[0u];
                                        let _e4387 = local_1.member_2[0u];
                                        let _e4391 = (_e4375[0] - _e4381[0]);
                                        let _e4392 = (_e4375[1] - _e4381[1]);
                                        let _e4393 = (_e4375[2] - _e4381[2]);
                                        let _e4394 = (_e4391 - _e4387[0]);
                                        let _e4395 = (_e4392 - _e4387[1]);
                                        let _e4396 = (_e4393 - _e4387[2]);
                                        let _e4397 = (_e4375[0] - _e4387[0]);
                                        let _e4398 = (_e4375[1] - _e4387[1]);
                                        let _e4399 = (_e4375[2] - _e4387[2]);
                                        let _e4402 = local_1.member[1u];
                                        let _e4408 = local_1.member_1[1u];
                                        let _e4414 = local_1.member_2[1u];
                                        let _e4418 = (_e4402[0] - _e4408[0]);
                                        let _e4419 = (_e4402[1] - _e4408[1]);
                                        let _e4420 = (_e4402[2] - _e4408[2]);
                                        let _e4421 = (_e4418 - _e4414[0]);
                                        let _e4422 = (_e4419 - _e4414[1]);
                                        let _e4423 = (_e4420 - _e4414[2]);
                                        let _e4424 = (_e4402[0] - _e4414[0]);
                                        let _e4425 = (_e4402[1] - _e4414[1]);
                                        let _e4426 = (_e4402[2] - _e4414[2]);
                                        let _e4429 = local_1.member[0u];
                                        if (_e4429[0] < 0f) {
                                            phi_7870_ = -(_e4429[0]);
                                        } else {
                                            phi_7870_ = _e4429[0];
                                        }
                                        let _e4436 = phi_7870_;
                                        if (_e4429[1] < 0f) {
                                            phi_7877_ = -(_e4429[1]);
                                        } else {
                                            phi_7877_ = _e4429[1];
                                        }
                                        let _e4440 = phi_7877_;
                                        if (_e4436 > _e4440) {
                                            phi_7882_ = _e4436;
                                        } else {
                                            phi_7882_ = _e4440;
                                        }
                                        let _e4443 = phi_7882_;
                                        if (_e4429[2] < 0f) {
                                            phi_7889_ = -(_e4429[2]);
                                        } else {
                                            phi_7889_ = _e4429[2];
                                        }
                                        let _e4447 = phi_7889_;
                                        if (_e4443 > _e4447) {
                                            phi_7894_ = _e4443;
                                        } else {
                                            phi_7894_ = _e4447;
                                        }
                                        let _e4450 = phi_7894_;
                                        let _e4453 = local_1.member[1u];
                                        if (_e4453[0] < 0f) {
                                            phi_7907_ = -(_e4453[0]);
                                        } else {
                                            phi_7907_ = _e4453[0];
                                        }
                                        let _e4460 = phi_7907_;
                                        if (_e4453[1] < 0f) {
                                            phi_7914_ = -(_e4453[1]);
                                        } else {
                                            phi_7914_ = _e4453[1];
                                        }
                                        let _e4464 = phi_7914_;
                                        if (_e4460 > _e4464) {
                                            phi_7919_ = _e4460;
                                        } else {
                                            phi_7919_ = _e4464;
                                        }
                                        let _e4467 = phi_7919_;
                                        if (_e4453[2] < 0f) {
                                            phi_7926_ = -(_e4453[2]);
                                        } else {
                                            phi_7926_ = _e4453[2];
                                        }
                                        let _e4471 = phi_7926_;
                                        if (_e4467 > _e4471) {
                                            phi_7931_ = _e4467;
                                        } else {
                                            phi_7931_ = _e4471;
                                        }
                                        let _e4474 = phi_7931_;
                                        if (_e4450 > _e4474) {
                                            phi_7936_ = _e4450;
                                        } else {
                                            phi_7936_ = _e4474;
                                        }
                                        let _e4477 = phi_7936_;
                                        let _e4479 = local_1.member_3;
                                        let _e4483 = local_1.member_1[0u];
                                        if (_e4483[0] < 0f) {
                                            phi_7953_ = -(_e4483[0]);
                                        } else {
                                            phi_7953_ = _e4483[0];
                                        }
                                        let _e4490 = phi_7953_;
                                        if (_e4483[1] < 0f) {
                                            phi_7960_ = -(_e4483[1]);
                                        } else {
                                            phi_7960_ = _e4483[1];
                                        }
                                        let _e4494 = phi_7960_;
                                        if (_e4490 > _e4494) {
                                            phi_7965_ = _e4490;
                                        } else {
                                            phi_7965_ = _e4494;
                                        }
                                        let _e4497 = phi_7965_;
                                        if (_e4483[2] < 0f) {
                                            phi_7972_ = -(_e4483[2]);
                                        } else {
                                            phi_7972_ = _e4483[2];
                                        }
                                        let _e4501 = phi_7972_;
                                        if (_e4497 > _e4501) {
                                            phi_7977_ = _e4497;
                                        } else {
                                            phi_7977_ = _e4501;
                                        }
                                        let _e4504 = phi_7977_;
                                        let _e4507 = local_1.member_1[1u];
                                        if (_e4507[0] < 0f) {
                                            phi_7991_ = -(_e4507[0]);
                                        } else {
                                            phi_7991_ = _e4507[0];
                                        }
                                        let _e4514 = phi_7991_;
                                        if (_e4507[1] < 0f) {
                                            phi_7998_ = -(_e4507[1]);
                                        } else {
                                            phi_7998_ = _e4507[1];
                                        }
                                        let _e4518 = phi_7998_;
                                        if (_e4514 > _e4518) {
                                            phi_8003_ = _e4514;
                                        } else {
                                            phi_8003_ = _e4518;
                                        }
                                        let _e4521 = phi_8003_;
                                        if (_e4507[2] < 0f) {
                                            phi_8010_ = -(_e4507[2]);
                                        } else {
                                            phi_8010_ = _e4507[2];
                                        }
                                        let _e4525 = phi_8010_;
                                        if (_e4521 > _e4525) {
                                            phi_8015_ = _e4521;
                                        } else {
                                            phi_8015_ = _e4525;
                                        }
                                        let _e4528 = phi_8015_;
                                        if (_e4504 > _e4528) {
                                            phi_8020_ = _e4504;
                                        } else {
                                            phi_8020_ = _e4528;
                                        }
                                        let _e4531 = phi_8020_;
                                        let _e4533 = local_1.member_3;
                                        let _e4537 = local_1.member_2[0u];
                                        if (_e4537[0] < 0f) {
                                            phi_8037_ = -(_e4537[0]);
                                        } else {
                                            phi_8037_ = _e4537[0];
                                        }
                                        let _e4544 = phi_8037_;
                                        if (_e4537[1] < 0f) {
                                            phi_8044_ = -(_e4537[1]);
                                        } else {
                                            phi_8044_ = _e4537[1];
                                        }
                                        let _e4548 = phi_8044_;
                                        if (_e4544 > _e4548) {
                                            phi_8049_ = _e4544;
                                        } else {
                                            phi_8049_ = _e4548;
                                        }
                                        let _e4551 = phi_8049_;
                                        if (_e4537[2] < 0f) {
                                            phi_8056_ = -(_e4537[2]);
                                        } else {
                                            phi_8056_ = _e4537[2];
                                        }
                                        let _e4555 = phi_8056_;
                                        if (_e4551 > _e4555) {
                                            phi_8061_ = _e4551;
                                        } else {
                                            phi_8061_ = _e4555;
                                        }
                                        let _e4558 = phi_8061_;
                                        let _e4561 = local_1.member_2[1u];
                                        if (_e4561[0] < 0f) {
                                            phi_8075_ = -(_e4561[0]);
                                        } else {
                                            phi_8075_ = _e4561[0];
                                        }
                                        let _e4568 = phi_8075_;
                                        if (_e4561[1] < 0f) {
                                            phi_8082_ = -(_e4561[1]);
                                        } else {
                                            phi_8082_ = _e4561[1];
                                        }
                                        let _e4572 = phi_8082_;
                                        if (_e4568 > _e4572) {
                                            phi_8087_ = _e4568;
                                        } else {
                                            phi_8087_ = _e4572;
                                        }
                                        let _e4575 = phi_8087_;
                                        if (_e4561[2] < 0f) {
                                            phi_8094_ = -(_e4561[2]);
                                        } else {
                                            phi_8094_ = _e4561[2];
                                        }
                                        let _e4579 = phi_8094_;
                                        if (_e4575 > _e4579) {
                                            phi_8099_ = _e4575;
                                        } else {
                                            phi_8099_ = _e4579;
                                        }
                                        let _e4582 = phi_8099_;
                                        if (_e4558 > _e4582) {
                                            phi_8104_ = _e4558;
                                        } else {
                                            phi_8104_ = _e4582;
                                        }
                                        let _e4585 = phi_8104_;
                                        let _e4587 = local_1.member_3;
                                        let _e4591 = ((((_e4477 + _e4479) + (_e4531 + _e4533)) + (_e4585 + _e4587)) * 2f);
                                        let _e4594 = local_1.member_3;
                                        let _e4598 = (((_e1853 * 1.0001f) + (_e4594 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e4601 = ((_e4369 * _e4348) - (_e4372 * _e4347));
                                        let _e4604 = ((_e4372 * _e4346) - (_e4366 * _e4348));
                                        let _e4607 = ((_e4366 * _e4347) - (_e4369 * _e4346));
                                        let _e4612 = (((_e4601 * _e4375[0]) + (_e4604 * _e4375[1])) + (_e4607 * _e4375[2]));
                                        let _e4617 = (((_e4601 * _e4391) + (_e4604 * _e4392)) + (_e4607 * _e4393));
                                        let _e4622 = (((_e4601 * _e4397) + (_e4604 * _e4398)) + (_e4607 * _e4399));
                                        let _e4627 = (((_e4601 * _e4394) + (_e4604 * _e4395)) + (_e4607 * _e4396));
                                        let _e4632 = (((_e4601 * _e4402[0]) + (_e4604 * _e4402[1])) + (_e4607 * _e4402[2]));
                                        let _e4637 = (((_e4601 * _e4418) + (_e4604 * _e4419)) + (_e4607 * _e4420));
                                        let _e4642 = (((_e4601 * _e4424) + (_e4604 * _e4425)) + (_e4607 * _e4426));
                                        let _e4647 = (((_e4601 * _e4421) + (_e4604 * _e4422)) + (_e4607 * _e4423));
                                        if (_e4612 < _e4617) {
                                            phi_8183_ = _e4612;
                                        } else {
                                            phi_8183_ = _e4617;
                                        }
                                        let _e4650 = phi_8183_;
                                        if (_e4622 < _e4627) {
                                            phi_8188_ = _e4622;
                                        } else {
                                            phi_8188_ = _e4627;
                                        }
                                        let _e4653 = phi_8188_;
                                        if (_e4650 < _e4653) {
                                            phi_8193_ = _e4650;
                                        } else {
                                            phi_8193_ = _e4653;
                                        }
                                        let _e4656 = phi_8193_;
                                        if (_e4632 < _e4637) {
                                            phi_8198_ = _e4632;
                                        } else {
                                            phi_8198_ = _e4637;
                                        }
                                        let _e4659 = phi_8198_;
                                        if (_e4642 < _e4647) {
                                            phi_8203_ = _e4642;
                                        } else {
                                            phi_8203_ = _e4647;
                                        }
                                        let _e4662 = phi_8203_;
                                        if (_e4659 < _e4662) {
                                            phi_8208_ = _e4659;
                                        } else {
                                            phi_8208_ = _e4662;
                                        }
                                        let _e4665 = phi_8208_;
                                        if (_e4656 < _e4665) {
                                            phi_8213_ = _e4656;
                                        } else {
                                            phi_8213_ = _e4665;
                                        }
                                        let _e4668 = phi_8213_;
                                        if (_e4612 > _e4617) {
                                            phi_8218_ = _e4612;
                                        } else {
                                            phi_8218_ = _e4617;
                                        }
                                        let _e4671 = phi_8218_;
                                        if (_e4622 > _e4627) {
                                            phi_8223_ = _e4622;
                                        } else {
                                            phi_8223_ = _e4627;
                                        }
                                        let _e4674 = phi_8223_;
                                        if (_e4671 > _e4674) {
                                            phi_8228_ = _e4671;
                                        } else {
                                            phi_8228_ = _e4674;
                                        }
                                        let _e4677 = phi_8228_;
                                        if (_e4632 > _e4637) {
                                            phi_8233_ = _e4632;
                                        } else {
                                            phi_8233_ = _e4637;
                                        }
                                        let _e4680 = phi_8233_;
                                        if (_e4642 > _e4647) {
                                            phi_8238_ = _e4642;
                                        } else {
                                            phi_8238_ = _e4647;
                                        }
                                        let _e4683 = phi_8238_;
                                        if (_e4680 > _e4683) {
                                            phi_8243_ = _e4680;
                                        } else {
                                            phi_8243_ = _e4683;
                                        }
                                        let _e4686 = phi_8243_;
                                        if (_e4677 > _e4686) {
                                            phi_8248_ = _e4677;
                                        } else {
                                            phi_8248_ = _e4686;
                                        }
                                        let _e4689 = phi_8248_;
                                        if (_e4601 < 0f) {
                                            phi_8254_ = -(_e4601);
                                        } else {
                                            phi_8254_ = _e4601;
                                        }
                                        let _e4693 = phi_8254_;
                                        if (_e4604 < 0f) {
                                            phi_8260_ = -(_e4604);
                                        } else {
                                            phi_8260_ = _e4604;
                                        }
                                        let _e4697 = phi_8260_;
                                        if (_e4607 < 0f) {
                                            phi_8267_ = -(_e4607);
                                        } else {
                                            phi_8267_ = _e4607;
                                        }
                                        let _e4702 = phi_8267_;
                                        let _e4703 = ((_e4693 + _e4697) + _e4702);
                                        let _e4708 = -(_e4689);
                                        if (_e4668 > _e4708) {
                                            phi_8278_ = _e4668;
                                        } else {
                                            phi_8278_ = _e4708;
                                        }
                                        let _e4711 = phi_8278_;
                                        let _e4716 = (((_e4711 - ((_e4703 * _e4591) * (0.000000059604645f * (17f / 2f)))) - (_e4703 * _e4598)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e4719 = ((_e4369 * _e4363) - (_e4372 * _e4362));
                                        let _e4722 = ((_e4372 * _e4361) - (_e4366 * _e4363));
                                        let _e4725 = ((_e4366 * _e4362) - (_e4369 * _e4361));
                                        let _e4730 = (((_e4719 * _e4375[0]) + (_e4722 * _e4375[1])) + (_e4725 * _e4375[2]));
                                        let _e4735 = (((_e4719 * _e4391) + (_e4722 * _e4392)) + (_e4725 * _e4393));
                                        let _e4740 = (((_e4719 * _e4397) + (_e4722 * _e4398)) + (_e4725 * _e4399));
                                        let _e4745 = (((_e4719 * _e4394) + (_e4722 * _e4395)) + (_e4725 * _e4396));
                                        let _e4750 = (((_e4719 * _e4402[0]) + (_e4722 * _e4402[1])) + (_e4725 * _e4402[2]));
                                        let _e4755 = (((_e4719 * _e4418) + (_e4722 * _e4419)) + (_e4725 * _e4420));
                                        let _e4760 = (((_e4719 * _e4424) + (_e4722 * _e4425)) + (_e4725 * _e4426));
                                        let _e4765 = (((_e4719 * _e4421) + (_e4722 * _e4422)) + (_e4725 * _e4423));
                                        if (_e4730 < _e4735) {
                                            phi_8349_ = _e4730;
                                        } else {
                                            phi_8349_ = _e4735;
                                        }
                                        let _e4768 = phi_8349_;
                                        if (_e4740 < _e4745) {
                                            phi_8354_ = _e4740;
                                        } else {
                                            phi_8354_ = _e4745;
                                        }
                                        let _e4771 = phi_8354_;
                                        if (_e4768 < _e4771) {
                                            phi_8359_ = _e4768;
                                        } else {
                                            phi_8359_ = _e4771;
                                        }
                                        let _e4774 = phi_8359_;
                                        if (_e4750 < _e4755) {
                                            phi_8364_ = _e4750;
                                        } else {
                                            phi_8364_ = _e4755;
                                        }
                                        let _e4777 = phi_8364_;
                                        if (_e4760 < _e4765) {
                                            phi_8369_ = _e4760;
                                        } else {
                                            phi_8369_ = _e4765;
                                        }
                                        let _e4780 = phi_8369_;
                                        if (_e4777 < _e4780) {
                                            phi_8374_ = _e4777;
                                        } else {
                                            phi_8374_ = _e4780;
                                        }
                                        let _e4783 = phi_8374_;
                                        if (_e4774 < _e4783) {
                                            phi_8379_ = _e4774;
                                        } else {
                                            phi_8379_ = _e4783;
                                        }
                                        let _e4786 = phi_8379_;
                                        if (_e4730 > _e4735) {
                                            phi_8384_ = _e4730;
                                        } else {
                                            phi_8384_ = _e4735;
                                        }
                                        let _e4789 = phi_8384_;
                                        if (_e4740 > _e4745) {
                                            phi_8389_ = _e4740;
                                        } else {
                                            phi_8389_ = _e4745;
                                        }
                                        let _e4792 = phi_8389_;
                                        if (_e4789 > _e4792) {
                                            phi_8394_ = _e4789;
                                        } else {
                                            phi_8394_ = _e4792;
                                        }
                                        let _e4795 = phi_8394_;
                                        if (_e4750 > _e4755) {
                                            phi_8399_ = _e4750;
                                        } else {
                                            phi_8399_ = _e4755;
                                        }
                                        let _e4798 = phi_8399_;
                                        if (_e4760 > _e4765) {
                                            phi_8404_ = _e4760;
                                        } else {
                                            phi_8404_ = _e4765;
                                        }
                                        let _e4801 = phi_8404_;
                                        if (_e4798 > _e4801) {
                                            phi_8409_ = _e4798;
                                        } else {
                                            phi_8409_ = _e4801;
                                        }
                                        let _e4804 = phi_8409_;
                                        if (_e4795 > _e4804) {
                                            phi_8414_ = _e4795;
                                        } else {
                                            phi_8414_ = _e4804;
                                        }
                                        let _e4807 = phi_8414_;
                                        if (_e4719 < 0f) {
                                            phi_8420_ = -(_e4719);
                                        } else {
                                            phi_8420_ = _e4719;
                                        }
                                        let _e4811 = phi_8420_;
                                        if (_e4722 < 0f) {
                                            phi_8426_ = -(_e4722);
                                        } else {
                                            phi_8426_ = _e4722;
                                        }
                                        let _e4815 = phi_8426_;
                                        if (_e4725 < 0f) {
                                            phi_8433_ = -(_e4725);
                                        } else {
                                            phi_8433_ = _e4725;
                                        }
                                        let _e4820 = phi_8433_;
                                        let _e4821 = ((_e4811 + _e4815) + _e4820);
                                        let _e4826 = -(_e4807);
                                        if (_e4786 > _e4826) {
                                            phi_8444_ = _e4786;
                                        } else {
                                            phi_8444_ = _e4826;
                                        }
                                        let _e4829 = phi_8444_;
                                        let _e4834 = (((_e4829 - ((_e4821 * _e4591) * (0.000000059604645f * (17f / 2f)))) - (_e4821 * _e4598)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4716 > _e4834) {
                                            phi_8454_ = _e4716;
                                        } else {
                                            phi_8454_ = _e4834;
                                        }
                                        let _e4837 = phi_8454_;
                                        phi_8636_ = (_e4333 || (_e4837 > 0f));
                                    }
                                    let _e4841 = phi_8636_;
                                    phi_8638_ = (_e3898 && _e4841);
                                } else {
                                    phi_8638_ = _e3898;
                                }
                                let _e4844 = phi_8638_;
                                phi_8640_ = (_e2865 || _e4844);
                            }
                            let _e4847 = phi_8640_;
                            if !(_e4847) {
                                let _e4850 = atomicAdd((&counters[5u]), 1u);
                                hits[_e1196] = ((2147483648u | (_e4850 << bitcast<u32>(12i))) | _e1199);
                            }
                        }
                        phi_8651_ = true;
                    }
                    let _e4857 = phi_8651_;
                    phi_8652_ = _e4857;
                } else {
                    phi_8652_ = false;
                }
                let _e4859 = phi_8652_;
                continue;
                continuing {
                    phi_2224_ = _e1188;
                    break if !(_e4859);
                }
            }
            workgroupBarrier();
            if (_e71 == 0u) {
                let _e4863 = atomicLoad((&counters[5u]));
                if (_e4863 > 0u) {
                    let _e4866 = atomicAdd((&output.member[0u]), _e4863);
                    if ((_e4866 + _e4863) < _e4866) {
                        let _e4870 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e4866);
                }
            }
            workgroupBarrier();
            let _e4873 = atomicLoad((&counters[6u]));
            if (_e71 == 0u) {
                let _e4876 = atomicLoad((&counters[7u]));
                if (_e4876 > 0u) {
                    let _e4879 = atomicAdd((&output.member[1u]), _e4876);
                    if ((_e4879 + _e4876) < _e4879) {
                        let _e4883 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            phi_8702_ = type_9(0u, 16u);
            loop {
                let _e4885 = phi_8702_;
                if (_e4885.member < _e4885.member_1) {
                    phi_8703_ = type_9((_e4885.member + 1u), _e4885.member_1);
                    phi_8726_ = type_9(1u, _e4885.member);
                } else {
                    phi_8703_ = _e4885;
                    phi_8726_ = type_9(0u, type_9().member_1);
                }
                let _e4897 = phi_8703_;
                let _e4899 = phi_8726_;
                if (bitcast<i32>(_e4899.member) != 0i) {
                    let _e4905 = (_e71 + (_e4899.member_1 * 128u));
                    if (_e4905 >= _e1174) {
                        phi_8823_ = false;
                    } else {
                        let _e4908 = hits[_e4905];
                        if ((_e4908 & 2147483648u) == 0u) {
                            phi_8749_ = 4294967295u;
                        } else {
                            phi_8749_ = ((_e4908 & 2147483647u) >> bitcast<u32>(12i));
                        }
                        let _e4915 = phi_8749_;
                        if (_e4915 != 4294967295u) {
                            let _e4919 = ((_e4908 >> bitcast<u32>(10i)) & 3u);
                            let _e4926 = firsts[(2u * _e4919)];
                            let _e4929 = leaves.member[(_e4926 + ((_e4908 >> bitcast<u32>(5i)) & 31u))];
                            let _e4933 = firsts[((2u * _e4919) + 1u)];
                            let _e4936 = leaves.member[(_e4933 + (_e4908 & 31u))];
                            let _e4941 = params.member.member_1.member_3;
                            let _e4942 = (_e4873 + _e4915);
                            if (_e4929.member_1 < _e4936.member_1) {
                                phi_8804_ = type_9(_e4929.member_1, _e4936.member_1);
                            } else {
                                phi_8804_ = type_9(_e4936.member_1, _e4929.member_1);
                            }
                            let _e4947 = phi_8804_;
                            if (_e4942 < _e4941) {
                                let _e4951 = (2u * _e4942);
                                atomicStore((&output.member[(4u + _e4951)]), _e4947.member);
                                atomicStore((&output.member[(_e4951 + 5u)]), _e4947.member_1);
                            }
                        }
                        phi_8823_ = true;
                    }
                    let _e4957 = phi_8823_;
                    phi_8824_ = _e4957;
                } else {
                    phi_8824_ = false;
                }
                let _e4959 = phi_8824_;
                continue;
                continuing {
                    phi_8702_ = _e4897;
                    break if !(_e4959);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_442_ = _e157;
            break if !(_e163);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
