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

struct type_23 {
    member: array<vec4<u32>>,
}

struct type_25 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_37 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_39 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_40 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_42 {
    member: array<type_40>,
}

struct type_43 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_44 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
}

struct type_48 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> nodes: type_27;
var<workgroup> columns: array<type_29, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 10>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 512>;
var<workgroup> firsts: array<u32, 8>;
@group(0) @binding(2) 
var<storage> leaves: type_23;
@group(0) @binding(3) 
var<storage> bodies: type_11;
@group(0) @binding(4) 
var<storage> keys: type_37;
@group(0) @binding(5) 
var<storage> paths: type_42;
@group(0) @binding(6) 
var<storage> input: type_11;
@group(0) @binding(7) 
var<storage, read_write> output: type_48;
var<workgroup> left: array<u32, 512>;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_198_: bool;
    var phi_199_: bool;
    var phi_203_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_199_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_198_ = (param[0] > param_1[0]);
        } else {
            phi_198_ = false;
        }
        let _e14 = phi_198_;
        phi_199_ = _e14;
    }
    let _e16 = phi_199_;
    if _e16 {
        phi_203_ = param_1;
    } else {
        phi_203_ = param;
    }
    let _e18 = phi_203_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_222_: bool;
    var phi_223_: bool;
    var phi_227_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_223_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_222_ = (param_3[0] > param_2[0]);
        } else {
            phi_222_ = false;
        }
        let _e14 = phi_222_;
        phi_223_ = _e14;
    }
    let _e16 = phi_223_;
    if _e16 {
        phi_227_ = param_3;
    } else {
        phi_227_ = param_2;
    }
    let _e18 = phi_227_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_246_: bool;
    var phi_247_: bool;
    var phi_251_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_247_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_246_ = (param_4[0] > param_5[0]);
        } else {
            phi_246_ = false;
        }
        let _e14 = phi_246_;
        phi_247_ = _e14;
    }
    let _e16 = phi_247_;
    if _e16 {
        phi_251_ = param_5;
    } else {
        phi_251_ = param_4;
    }
    let _e18 = phi_251_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_270_: bool;
    var phi_271_: bool;
    var phi_275_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_271_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_270_ = (param_7[0] > param_6[0]);
        } else {
            phi_270_ = false;
        }
        let _e14 = phi_270_;
        phi_271_ = _e14;
    }
    let _e16 = phi_271_;
    if _e16 {
        phi_275_ = param_7;
    } else {
        phi_275_ = param_6;
    }
    let _e18 = phi_275_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_299_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_295_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_294_ = (param_8[0] > param_9[0]);
        } else {
            phi_294_ = false;
        }
        let _e14 = phi_294_;
        phi_295_ = _e14;
    }
    let _e16 = phi_295_;
    if _e16 {
        phi_299_ = param_9;
    } else {
        phi_299_ = param_8;
    }
    let _e18 = phi_299_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_323_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_319_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_318_ = (param_11[0] > param_10[0]);
        } else {
            phi_318_ = false;
        }
        let _e14 = phi_318_;
        phi_319_ = _e14;
    }
    let _e16 = phi_319_;
    if _e16 {
        phi_323_ = param_11;
    } else {
        phi_323_ = param_10;
    }
    let _e18 = phi_323_;
    return _e18;
}

fn function_6(param_12: f32, param_13: f32) -> f32 {
    var phi_8500_: bool;
    var phi_8504_: f32;

    if (param_12 != param_12) {
        phi_8500_ = true;
    } else {
        phi_8500_ = (param_13 >= param_12);
    }
    let _e6 = phi_8500_;
    if _e6 {
        phi_8504_ = param_13;
    } else {
        phi_8504_ = param_12;
    }
    let _e8 = phi_8504_;
    return _e8;
}

fn function_7(param_14: f32, param_15: f32) -> f32 {
    var phi_8484_: bool;
    var phi_8488_: f32;

    if (param_14 != param_14) {
        phi_8484_ = true;
    } else {
        phi_8484_ = (param_15 <= param_14);
    }
    let _e6 = phi_8484_;
    if _e6 {
        phi_8488_ = param_15;
    } else {
        phi_8488_ = param_14;
    }
    let _e8 = phi_8488_;
    return _e8;
}

fn function_8(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_39;
    var local_1: type_39;
    var local_2: type_39;
    var phi_377_: u32;
    var phi_426_: u32;
    var phi_427_: u32;
    var phi_435_: u32;
    var phi_451_: u32;
    var phi_474_: u32;
    var phi_475_: u32;
    var phi_478_: type_9;
    var phi_479_: type_9;
    var phi_504_: type_9;
    var phi_551_: u32;
    var phi_552_: u32;
    var phi_560_: u32;
    var phi_574_: u32;
    var phi_677_: array<u32, 2>;
    var phi_838_: bool;
    var phi_876_: type_29;
    var phi_905_: u32;
    var phi_908_: type_9;
    var phi_911_: u32;
    var phi_909_: type_9;
    var phi_934_: type_9;
    var phi_912_: u32;
    var local_3: u32;
    var phi_1123_: u32;
    var phi_1129_: type_9;
    var phi_1132_: u32;
    var phi_1130_: type_9;
    var phi_1155_: type_9;
    var phi_1179_: bool;
    var phi_1180_: bool;
    var phi_1181_: bool;
    var phi_1185_: bool;
    var phi_1193_: bool;
    var phi_1201_: u32;
    var phi_1133_: u32;
    var phi_1202_: u32;
    var phi_1212_: type_9;
    var phi_1238_: u32;
    var phi_1241_: type_9;
    var phi_1244_: type_9;
    var phi_1242_: type_9;
    var phi_1269_: type_9;
    var phi_1286_: type_9;
    var phi_1289_: type_9;
    var phi_1290_: type_9;
    var phi_1312_: type_9;
    var phi_1346_: type_9;
    var phi_1347_: bool;
    var phi_1287_: type_9;
    var phi_1348_: bool;
    var phi_1356_: u32;
    var phi_1359_: type_9;
    var phi_1360_: type_9;
    var phi_1385_: type_9;
    var phi_1541_: bool;
    var phi_1547_: bool;
    var phi_1553_: bool;
    var phi_1554_: bool;
    var phi_1595_: bool;
    var phi_1596_: bool;
    var phi_1603_: bool;
    var phi_1717_: bool;
    var phi_1718_: bool;
    var phi_1753_: u32;
    var phi_1754_: u32;
    var phi_1759_: type_15;
    var phi_1762_: u32;
    var phi_1764_: u32;
    var phi_1785_: bool;
    var phi_1791_: type_16;
    var phi_1760_: type_15;
    var phi_1805_: type_16;
    var phi_1873_: bool;
    var phi_1874_: bool;
    var phi_1875_: bool;
    var phi_1876_: bool;
    var phi_1880_: bool;
    var phi_1881_: bool;
    var phi_1886_: u32;
    var phi_1887_: u32;
    var phi_1888_: u32;
    var phi_1889_: u32;
    var phi_1890_: bool;
    var phi_1763_: u32;
    var phi_1765_: u32;
    var phi_1891_: bool;
    var local_4: u32;
    var local_5: u32;
    var phi_1939_: bool;
    var phi_1940_: bool;
    var phi_1941_: bool;
    var phi_1942_: bool;
    var phi_1946_: bool;
    var phi_1947_: bool;
    var phi_1951_: bool;
    var phi_1955_: bool;
    var phi_1956_: bool;
    var phi_1960_: bool;
    var phi_1961_: bool;
    var phi_1965_: bool;
    var phi_1966_: bool;
    var phi_2082_: bool;
    var phi_2083_: bool;
    var phi_2170_: bool;
    var phi_2171_: bool;
    var phi_2259_: bool;
    var phi_2260_: bool;
    var phi_2347_: bool;
    var phi_2348_: bool;
    var phi_2437_: bool;
    var phi_2438_: bool;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var phi_2530_: bool;
    var phi_2531_: bool;
    var phi_2532_: bool;
    var phi_2536_: bool;
    var phi_2537_: bool;
    var phi_2538_: bool;
    var phi_2539_: bool;
    var phi_2540_: bool;
    var phi_2544_: bool;
    var phi_2579_: type_43;
    var phi_2704_: type_44;
    var phi_2751_: type_44;
    var phi_2823_: bool;
    var phi_2824_: bool;
    var phi_2829_: type_9;
    var phi_2830_: type_9;
    var phi_2853_: type_9;
    var phi_2924_: type_43;
    var phi_3058_: type_39;
    var phi_3338_: f32;
    var phi_3345_: f32;
    var phi_3350_: f32;
    var phi_3357_: f32;
    var phi_3362_: f32;
    var phi_3375_: f32;
    var phi_3382_: f32;
    var phi_3387_: f32;
    var phi_3394_: f32;
    var phi_3399_: f32;
    var phi_3404_: f32;
    var phi_3421_: f32;
    var phi_3428_: f32;
    var phi_3433_: f32;
    var phi_3440_: f32;
    var phi_3445_: f32;
    var phi_3459_: f32;
    var phi_3466_: f32;
    var phi_3471_: f32;
    var phi_3478_: f32;
    var phi_3483_: f32;
    var phi_3488_: f32;
    var phi_3505_: f32;
    var phi_3512_: f32;
    var phi_3517_: f32;
    var phi_3524_: f32;
    var phi_3529_: f32;
    var phi_3543_: f32;
    var phi_3550_: f32;
    var phi_3555_: f32;
    var phi_3562_: f32;
    var phi_3567_: f32;
    var phi_3572_: f32;
    var phi_3603_: f32;
    var phi_3609_: f32;
    var phi_3616_: f32;
    var phi_3623_: f32;
    var phi_3629_: f32;
    var phi_3636_: f32;
    var phi_3642_: f32;
    var phi_3648_: f32;
    var phi_3654_: f32;
    var phi_3661_: f32;
    var phi_3668_: f32;
    var phi_3692_: f32;
    var phi_3697_: f32;
    var phi_3702_: f32;
    var phi_3707_: f32;
    var phi_3712_: f32;
    var phi_3717_: f32;
    var phi_3727_: f32;
    var phi_3843_: array<f32, 3>;
    var phi_3908_: array<f32, 3>;
    var phi_3930_: f32;
    var phi_3937_: f32;
    var phi_3942_: f32;
    var phi_3949_: f32;
    var phi_3954_: f32;
    var phi_3967_: f32;
    var phi_3974_: f32;
    var phi_3979_: f32;
    var phi_3986_: f32;
    var phi_3991_: f32;
    var phi_3996_: f32;
    var phi_4013_: f32;
    var phi_4020_: f32;
    var phi_4025_: f32;
    var phi_4032_: f32;
    var phi_4037_: f32;
    var phi_4051_: f32;
    var phi_4058_: f32;
    var phi_4063_: f32;
    var phi_4070_: f32;
    var phi_4075_: f32;
    var phi_4080_: f32;
    var phi_4097_: f32;
    var phi_4104_: f32;
    var phi_4109_: f32;
    var phi_4116_: f32;
    var phi_4121_: f32;
    var phi_4135_: f32;
    var phi_4142_: f32;
    var phi_4147_: f32;
    var phi_4154_: f32;
    var phi_4159_: f32;
    var phi_4164_: f32;
    var phi_4243_: f32;
    var phi_4248_: f32;
    var phi_4253_: f32;
    var phi_4258_: f32;
    var phi_4263_: f32;
    var phi_4268_: f32;
    var phi_4273_: f32;
    var phi_4278_: f32;
    var phi_4283_: f32;
    var phi_4288_: f32;
    var phi_4293_: f32;
    var phi_4298_: f32;
    var phi_4303_: f32;
    var phi_4308_: f32;
    var phi_4314_: f32;
    var phi_4320_: f32;
    var phi_4327_: f32;
    var phi_4338_: f32;
    var phi_4409_: f32;
    var phi_4414_: f32;
    var phi_4419_: f32;
    var phi_4424_: f32;
    var phi_4429_: f32;
    var phi_4434_: f32;
    var phi_4439_: f32;
    var phi_4444_: f32;
    var phi_4449_: f32;
    var phi_4454_: f32;
    var phi_4459_: f32;
    var phi_4464_: f32;
    var phi_4469_: f32;
    var phi_4474_: f32;
    var phi_4480_: f32;
    var phi_4486_: f32;
    var phi_4493_: f32;
    var phi_4504_: f32;
    var phi_4514_: f32;
    var phi_4587_: f32;
    var phi_4592_: f32;
    var phi_4597_: f32;
    var phi_4602_: f32;
    var phi_4607_: f32;
    var phi_4612_: f32;
    var phi_4617_: f32;
    var phi_4622_: f32;
    var phi_4627_: f32;
    var phi_4632_: f32;
    var phi_4637_: f32;
    var phi_4642_: f32;
    var phi_4647_: f32;
    var phi_4652_: f32;
    var phi_4658_: f32;
    var phi_4664_: f32;
    var phi_4671_: f32;
    var phi_4682_: f32;
    var phi_4692_: f32;
    var phi_4693_: f32;
    var phi_4696_: bool;
    var phi_4704_: bool;
    var phi_4705_: bool;
    var phi_4710_: type_9;
    var phi_4711_: type_9;
    var phi_4734_: type_9;
    var phi_4805_: type_43;
    var phi_4939_: type_39;
    var phi_5318_: f32;
    var phi_5325_: f32;
    var phi_5330_: f32;
    var phi_5337_: f32;
    var phi_5342_: f32;
    var phi_5355_: f32;
    var phi_5362_: f32;
    var phi_5367_: f32;
    var phi_5374_: f32;
    var phi_5379_: f32;
    var phi_5384_: f32;
    var phi_5401_: f32;
    var phi_5408_: f32;
    var phi_5413_: f32;
    var phi_5420_: f32;
    var phi_5425_: f32;
    var phi_5439_: f32;
    var phi_5446_: f32;
    var phi_5451_: f32;
    var phi_5458_: f32;
    var phi_5463_: f32;
    var phi_5468_: f32;
    var phi_5485_: f32;
    var phi_5492_: f32;
    var phi_5497_: f32;
    var phi_5504_: f32;
    var phi_5509_: f32;
    var phi_5523_: f32;
    var phi_5530_: f32;
    var phi_5535_: f32;
    var phi_5542_: f32;
    var phi_5547_: f32;
    var phi_5552_: f32;
    var phi_5583_: f32;
    var phi_5589_: f32;
    var phi_5596_: f32;
    var phi_5603_: f32;
    var phi_5609_: f32;
    var phi_5616_: f32;
    var phi_5622_: f32;
    var phi_5628_: f32;
    var phi_5634_: f32;
    var phi_5641_: f32;
    var phi_5648_: f32;
    var phi_5672_: f32;
    var phi_5677_: f32;
    var phi_5682_: f32;
    var phi_5687_: f32;
    var phi_5692_: f32;
    var phi_5697_: f32;
    var phi_5707_: f32;
    var phi_5823_: array<f32, 3>;
    var phi_5888_: array<f32, 3>;
    var phi_5910_: f32;
    var phi_5917_: f32;
    var phi_5922_: f32;
    var phi_5929_: f32;
    var phi_5934_: f32;
    var phi_5947_: f32;
    var phi_5954_: f32;
    var phi_5959_: f32;
    var phi_5966_: f32;
    var phi_5971_: f32;
    var phi_5976_: f32;
    var phi_5993_: f32;
    var phi_6000_: f32;
    var phi_6005_: f32;
    var phi_6012_: f32;
    var phi_6017_: f32;
    var phi_6031_: f32;
    var phi_6038_: f32;
    var phi_6043_: f32;
    var phi_6050_: f32;
    var phi_6055_: f32;
    var phi_6060_: f32;
    var phi_6077_: f32;
    var phi_6084_: f32;
    var phi_6089_: f32;
    var phi_6096_: f32;
    var phi_6101_: f32;
    var phi_6115_: f32;
    var phi_6122_: f32;
    var phi_6127_: f32;
    var phi_6134_: f32;
    var phi_6139_: f32;
    var phi_6144_: f32;
    var phi_6223_: f32;
    var phi_6228_: f32;
    var phi_6233_: f32;
    var phi_6238_: f32;
    var phi_6243_: f32;
    var phi_6248_: f32;
    var phi_6253_: f32;
    var phi_6258_: f32;
    var phi_6263_: f32;
    var phi_6268_: f32;
    var phi_6273_: f32;
    var phi_6278_: f32;
    var phi_6283_: f32;
    var phi_6288_: f32;
    var phi_6294_: f32;
    var phi_6300_: f32;
    var phi_6307_: f32;
    var phi_6318_: f32;
    var phi_6389_: f32;
    var phi_6394_: f32;
    var phi_6399_: f32;
    var phi_6404_: f32;
    var phi_6409_: f32;
    var phi_6414_: f32;
    var phi_6419_: f32;
    var phi_6424_: f32;
    var phi_6429_: f32;
    var phi_6434_: f32;
    var phi_6439_: f32;
    var phi_6444_: f32;
    var phi_6449_: f32;
    var phi_6454_: f32;
    var phi_6460_: f32;
    var phi_6466_: f32;
    var phi_6473_: f32;
    var phi_6484_: f32;
    var phi_6494_: f32;
    var phi_6567_: f32;
    var phi_6572_: f32;
    var phi_6577_: f32;
    var phi_6582_: f32;
    var phi_6587_: f32;
    var phi_6592_: f32;
    var phi_6597_: f32;
    var phi_6602_: f32;
    var phi_6607_: f32;
    var phi_6612_: f32;
    var phi_6617_: f32;
    var phi_6622_: f32;
    var phi_6627_: f32;
    var phi_6632_: f32;
    var phi_6638_: f32;
    var phi_6644_: f32;
    var phi_6651_: f32;
    var phi_6662_: f32;
    var phi_6672_: f32;
    var phi_6673_: f32;
    var phi_6676_: bool;
    var phi_6921_: f32;
    var phi_6928_: f32;
    var phi_6933_: f32;
    var phi_6940_: f32;
    var phi_6945_: f32;
    var phi_6958_: f32;
    var phi_6965_: f32;
    var phi_6970_: f32;
    var phi_6977_: f32;
    var phi_6982_: f32;
    var phi_6987_: f32;
    var phi_7004_: f32;
    var phi_7011_: f32;
    var phi_7016_: f32;
    var phi_7023_: f32;
    var phi_7028_: f32;
    var phi_7042_: f32;
    var phi_7049_: f32;
    var phi_7054_: f32;
    var phi_7061_: f32;
    var phi_7066_: f32;
    var phi_7071_: f32;
    var phi_7088_: f32;
    var phi_7095_: f32;
    var phi_7100_: f32;
    var phi_7107_: f32;
    var phi_7112_: f32;
    var phi_7126_: f32;
    var phi_7133_: f32;
    var phi_7138_: f32;
    var phi_7145_: f32;
    var phi_7150_: f32;
    var phi_7155_: f32;
    var phi_7186_: f32;
    var phi_7192_: f32;
    var phi_7199_: f32;
    var phi_7206_: f32;
    var phi_7212_: f32;
    var phi_7219_: f32;
    var phi_7225_: f32;
    var phi_7231_: f32;
    var phi_7237_: f32;
    var phi_7244_: f32;
    var phi_7251_: f32;
    var phi_7275_: f32;
    var phi_7280_: f32;
    var phi_7285_: f32;
    var phi_7290_: f32;
    var phi_7295_: f32;
    var phi_7300_: f32;
    var phi_7310_: f32;
    var phi_7426_: array<f32, 3>;
    var phi_7491_: array<f32, 3>;
    var phi_7513_: f32;
    var phi_7520_: f32;
    var phi_7525_: f32;
    var phi_7532_: f32;
    var phi_7537_: f32;
    var phi_7550_: f32;
    var phi_7557_: f32;
    var phi_7562_: f32;
    var phi_7569_: f32;
    var phi_7574_: f32;
    var phi_7579_: f32;
    var phi_7596_: f32;
    var phi_7603_: f32;
    var phi_7608_: f32;
    var phi_7615_: f32;
    var phi_7620_: f32;
    var phi_7634_: f32;
    var phi_7641_: f32;
    var phi_7646_: f32;
    var phi_7653_: f32;
    var phi_7658_: f32;
    var phi_7663_: f32;
    var phi_7680_: f32;
    var phi_7687_: f32;
    var phi_7692_: f32;
    var phi_7699_: f32;
    var phi_7704_: f32;
    var phi_7718_: f32;
    var phi_7725_: f32;
    var phi_7730_: f32;
    var phi_7737_: f32;
    var phi_7742_: f32;
    var phi_7747_: f32;
    var phi_7826_: f32;
    var phi_7831_: f32;
    var phi_7836_: f32;
    var phi_7841_: f32;
    var phi_7846_: f32;
    var phi_7851_: f32;
    var phi_7856_: f32;
    var phi_7861_: f32;
    var phi_7866_: f32;
    var phi_7871_: f32;
    var phi_7876_: f32;
    var phi_7881_: f32;
    var phi_7886_: f32;
    var phi_7891_: f32;
    var phi_7897_: f32;
    var phi_7903_: f32;
    var phi_7910_: f32;
    var phi_7921_: f32;
    var phi_7992_: f32;
    var phi_7997_: f32;
    var phi_8002_: f32;
    var phi_8007_: f32;
    var phi_8012_: f32;
    var phi_8017_: f32;
    var phi_8022_: f32;
    var phi_8027_: f32;
    var phi_8032_: f32;
    var phi_8037_: f32;
    var phi_8042_: f32;
    var phi_8047_: f32;
    var phi_8052_: f32;
    var phi_8057_: f32;
    var phi_8063_: f32;
    var phi_8069_: f32;
    var phi_8076_: f32;
    var phi_8087_: f32;
    var phi_8097_: f32;
    var phi_8170_: f32;
    var phi_8175_: f32;
    var phi_8180_: f32;
    var phi_8185_: f32;
    var phi_8190_: f32;
    var phi_8195_: f32;
    var phi_8200_: f32;
    var phi_8205_: f32;
    var phi_8210_: f32;
    var phi_8215_: f32;
    var phi_8220_: f32;
    var phi_8225_: f32;
    var phi_8230_: f32;
    var phi_8235_: f32;
    var phi_8241_: f32;
    var phi_8247_: f32;
    var phi_8254_: f32;
    var phi_8265_: f32;
    var phi_8275_: f32;
    var phi_8276_: f32;
    var phi_8279_: bool;
    var phi_8281_: bool;
    var phi_8292_: bool;
    var phi_8293_: bool;
    var phi_8329_: type_9;
    var phi_8330_: type_9;
    var phi_8353_: type_9;
    var phi_8377_: u32;
    var phi_8429_: type_9;
    var phi_8448_: bool;
    var phi_8449_: bool;
    var phi_1245_: type_9;
    var local_6: u32;
    var local_7: u32;
    var local_8: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e71 = id_2;
    let _e72 = n_2;
    let _e73 = lane_2;
    let _e86 = ((_e71.y * _e72.x) + _e71.x);
    let _e89 = (_e72.x * _e72.y);
    let _e91 = params.member.member;
    let _e96 = params.member.member_1.member_2;
    let _e98 = input.member[0u];
    if (_e96 < _e98) {
        phi_377_ = _e96;
    } else {
        phi_377_ = _e98;
    }
    let _e101 = phi_377_;
    if (_e73 == 0u) {
        atomicStore((&counters[9u]), 0u);
    }
    let _e106 = params.member.member_1.member_1;
    if (_e101 > _e106) {
        let _e110 = params.member.member_1.member_1;
        let _e111 = (_e101 - _e110);
        let _e114 = params.member.member_2.member_3;
        if (_e114 == 0u) {
            return;
        }
        let _e116 = (_e111 / _e114);
        if (_e114 == 0u) {
            return;
        }
        if ((_e111 % _e114) > 0u) {
            phi_426_ = (_e116 + 1u);
        } else {
            phi_426_ = _e116;
        }
        let _e122 = phi_426_;
        phi_427_ = _e122;
    } else {
        phi_427_ = 0u;
    }
    let _e124 = phi_427_;
    let _e127 = params.member.member_2.member_4;
    if (_e127 < _e124) {
        phi_435_ = _e127;
    } else {
        phi_435_ = _e124;
    }
    let _e130 = phi_435_;
    let _e131 = (_e130 / 4u);
    if ((_e130 % 4u) > 0u) {
        phi_451_ = (_e131 + 1u);
    } else {
        phi_451_ = _e131;
    }
    let _e136 = phi_451_;
    if (_e136 > _e86) {
        let _e138 = (_e136 - _e86);
        if (_e89 == 0u) {
            return;
        }
        let _e140 = (_e138 / _e89);
        if (_e89 == 0u) {
            return;
        }
        if ((_e138 % _e89) > 0u) {
            phi_474_ = (_e140 + 1u);
        } else {
            phi_474_ = _e140;
        }
        let _e146 = phi_474_;
        phi_475_ = _e146;
    } else {
        phi_475_ = 0u;
    }
    let _e148 = phi_475_;
    phi_478_ = type_9(0u, _e148);
    loop {
        let _e151 = phi_478_;
        if (_e151.member < _e151.member_1) {
            phi_479_ = type_9((_e151.member + 1u), _e151.member_1);
            phi_504_ = type_9(1u, _e151.member);
        } else {
            phi_479_ = _e151;
            phi_504_ = type_9(0u, type_9().member_1);
        }
        let _e163 = phi_479_;
        let _e165 = phi_504_;
        let _e169 = (bitcast<i32>(_e165.member) != 0i);
        if _e169 {
            let _e174 = (((_e86 + (_e165.member_1 * _e89)) * 4u) + (_e73 / 32u));
            let _e177 = params.member.member_1.member_1;
            if (_e101 > _e177) {
                let _e181 = params.member.member_1.member_1;
                let _e182 = (_e101 - _e181);
                let _e185 = params.member.member_2.member_3;
                if (_e185 == 0u) {
                    return;
                }
                let _e187 = (_e182 / _e185);
                if (_e185 == 0u) {
                    return;
                }
                if ((_e182 % _e185) > 0u) {
                    phi_551_ = (_e187 + 1u);
                } else {
                    phi_551_ = _e187;
                }
                let _e193 = phi_551_;
                phi_552_ = _e193;
            } else {
                phi_552_ = 0u;
            }
            let _e195 = phi_552_;
            let _e198 = params.member.member_2.member_4;
            if (_e198 < _e195) {
                phi_560_ = _e198;
            } else {
                phi_560_ = _e195;
            }
            let _e201 = phi_560_;
            let _e202 = (_e174 < _e201);
            let _e205 = params.member.member_1.member_1;
            let _e208 = params.member.member_2.member_3;
            if _e202 {
                phi_574_ = (_e174 * _e208);
            } else {
                phi_574_ = 0u;
            }
            let _e211 = phi_574_;
            let _e213 = (2u * (_e205 + _e211));
            let _e216 = input.member[(4u + _e213)];
            let _e219 = input.member[(_e213 + 5u)];
            if (_e73 <= 7u) {
                atomicStore((&counters[_e73]), 0u);
            }
            workgroupBarrier();
            if ((_e73 % 32u) == 0u) {
                let _e225 = (_e73 / 32u);
                let _e231 = params.member.member_2.member[0u][1u];
                firsts[(2u * _e225)] = (_e231 + (_e216 * 32u));
                let _e240 = params.member.member_2.member[0u][1u];
                firsts[((2u * _e225) + 1u)] = (_e240 + (_e219 * 32u));
            }
            let _e245 = params.member.member_2.member_1;
            if (_e245 == 0u) {
                phi_677_ = array<u32, 2>(0u, 2u);
            } else {
                phi_677_ = array<u32, 2>(1u, 1u);
            }
            let _e248 = phi_677_;
            let _e251 = (_e73 / 32u);
            let _e252 = (_e73 % 32u);
            let _e254 = params.member.member_2.member_2;
            let _e258 = params.member.member_2.member[_e254][_e248[0]];
            let _e261 = nodes.member[(_e258 + _e216)];
            let _e275 = params.member.member_2.member_2;
            let _e279 = params.member.member_2.member[_e275][_e248[1]];
            let _e282 = nodes.member[(_e279 + _e219)];
            let _e296 = params.member.member_2.member_2;
            let _e303 = params.member.member_2.member[(_e296 - 1u)][_e248[0]];
            let _e306 = nodes.member[(_e303 + ((_e216 * 32u) + _e252))];
            let _e323 = params.member.member_2.member_2;
            let _e330 = params.member.member_2.member[(_e323 - 1u)][_e248[1]];
            let _e333 = nodes.member[(_e330 + ((_e219 * 32u) + _e252))];
            if _e202 {
                phi_838_ = ((((((_e306.member.x <= _e282.member_1.y) && (_e282.member.x <= _e306.member_1.y)) && (_e306.member.y <= _e282.member_2.x)) && (_e282.member.y <= _e306.member_2.x)) && (_e306.member_1.x <= _e282.member_2.y)) && (_e282.member_1.x <= _e306.member_2.y));
            } else {
                phi_838_ = false;
            }
            let _e358 = phi_838_;
            if _e202 {
                if ((((((_e333.member.x <= _e261.member_1.y) && (_e261.member.x <= _e333.member_1.y)) && (_e333.member.y <= _e261.member_2.x)) && (_e261.member.y <= _e333.member_2.x)) && (_e333.member_1.x <= _e261.member_2.y)) && (_e261.member_1.x <= _e333.member_2.y)) {
                    let _e372 = atomicAdd((&counters[_e251]), 1u);
                    let _e373 = ((_e251 * 32u) + _e372);
                    columns[_e373] = type_29(array<f32, 3>(_e333.member.x, _e333.member.y, _e333.member_1.x), array<f32, 3>(_e333.member_1.y, _e333.member_2.x, _e333.member_2.y));
                    names[_e373] = _e252;
                }
            }
            if _e358 {
                phi_876_ = type_29(array<f32, 3>(_e306.member.x, _e306.member.y, _e306.member_1.x), array<f32, 3>(_e306.member_1.y, _e306.member_2.x, _e306.member_2.y));
            } else {
                phi_876_ = type_29(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e380 = phi_876_;
            workgroupBarrier();
            let _e381 = (_e216 == _e219);
            let _e382 = (_e73 / 32u);
            let _e384 = (_e382 * 32u);
            let _e386 = atomicLoad((&counters[_e382]));
            let _e387 = (_e386 / 4u);
            if ((_e386 % 4u) > 0u) {
                phi_905_ = (_e387 + 1u);
            } else {
                phi_905_ = _e387;
            }
            let _e392 = phi_905_;
            phi_908_ = type_9(0u, _e392);
            phi_911_ = 0u;
            loop {
                let _e395 = phi_908_;
                let _e397 = phi_911_;
                local_3 = _e397;
                local_6 = _e397;
                if (_e395.member < _e395.member_1) {
                    phi_909_ = type_9((_e395.member + 1u), _e395.member_1);
                    phi_934_ = type_9(1u, _e395.member);
                } else {
                    phi_909_ = _e395;
                    phi_934_ = type_9(0u, type_9().member_1);
                }
                let _e409 = phi_909_;
                let _e411 = phi_934_;
                let _e415 = (bitcast<i32>(_e411.member) != 0i);
                if _e415 {
                    let _e416 = (4u * _e411.member_1);
                    let _e419 = columns[(_e384 + _e416)];
                    let _e458 = columns[((_e384 + _e416) + 1u)];
                    let _e499 = columns[((_e384 + _e416) + 2u)];
                    let _e540 = columns[((_e384 + _e416) + 3u)];
                    phi_912_ = (_e397 | ((((select(0u, 1u, ((((((_e380.member[0] <= _e419.member_1[0]) && (_e419.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e419.member_1[1])) && (_e419.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e419.member_1[2])) && (_e419.member[2] <= _e380.member_1[2]))) << bitcast<u32>((_e416 & 31u))) | (select(0u, 1u, ((((((_e380.member[0] <= _e458.member_1[0]) && (_e458.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e458.member_1[1])) && (_e458.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e458.member_1[2])) && (_e458.member[2] <= _e380.member_1[2]))) << bitcast<u32>(((_e416 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e380.member[0] <= _e499.member_1[0]) && (_e499.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e499.member_1[1])) && (_e499.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e499.member_1[2])) && (_e499.member[2] <= _e380.member_1[2]))) << bitcast<u32>(((_e416 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e380.member[0] <= _e540.member_1[0]) && (_e540.member[0] <= _e380.member_1[0])) && (_e380.member[1] <= _e540.member_1[1])) && (_e540.member[1] <= _e380.member_1[1])) && (_e380.member[2] <= _e540.member_1[2])) && (_e540.member[2] <= _e380.member_1[2]))) << bitcast<u32>(((_e416 + 3u) & 31u)))));
                } else {
                    phi_912_ = u32();
                }
                let _e580 = phi_912_;
                continue;
                continuing {
                    phi_908_ = _e409;
                    phi_911_ = _e580;
                    break if !(_e415);
                }
            }
            if (_e386 < 32u) {
                let _e588 = local_3;
                phi_1123_ = (_e588 & ((1u << bitcast<u32>((_e386 & 31u))) - 1u));
            } else {
                let _e5559 = local_6;
                phi_1123_ = _e5559;
            }
            let _e591 = phi_1123_;
            if _e381 {
                phi_1129_ = type_9(0u, _e386);
                phi_1132_ = _e591;
                loop {
                    let _e594 = phi_1129_;
                    let _e596 = phi_1132_;
                    local_7 = _e596;
                    if (_e594.member < _e594.member_1) {
                        phi_1130_ = type_9((_e594.member + 1u), _e594.member_1);
                        phi_1155_ = type_9(1u, _e594.member);
                    } else {
                        phi_1130_ = _e594;
                        phi_1155_ = type_9(0u, type_9().member_1);
                    }
                    let _e608 = phi_1130_;
                    let _e610 = phi_1155_;
                    let _e614 = (bitcast<i32>(_e610.member) != 0i);
                    if _e614 {
                        let _e617 = names[(_e384 + _e610.member_1)];
                        if _e381 {
                            let _e618 = ((_e73 % 32u) < _e617);
                            if _e618 {
                                phi_1179_ = bool();
                            } else {
                                phi_1179_ = false;
                            }
                            let _e620 = phi_1179_;
                            phi_1180_ = _e620;
                            phi_1181_ = _e618;
                        } else {
                            phi_1180_ = bool();
                            phi_1181_ = true;
                        }
                        let _e622 = phi_1180_;
                        let _e624 = phi_1181_;
                        if _e624 {
                            phi_1185_ = true;
                        } else {
                            phi_1185_ = _e622;
                        }
                        let _e626 = phi_1185_;
                        if _e626 {
                            phi_1193_ = false;
                        } else {
                            phi_1193_ = true;
                        }
                        let _e628 = phi_1193_;
                        if _e628 {
                            phi_1201_ = (_e596 & ~((1u << bitcast<u32>((_e610.member_1 & 31u)))));
                        } else {
                            phi_1201_ = _e596;
                        }
                        let _e635 = phi_1201_;
                        phi_1133_ = _e635;
                    } else {
                        phi_1133_ = u32();
                    }
                    let _e637 = phi_1133_;
                    continue;
                    continuing {
                        phi_1129_ = _e608;
                        phi_1132_ = _e637;
                        break if !(_e614);
                    }
                }
                let _e5573 = local_7;
                phi_1202_ = _e5573;
            } else {
                phi_1202_ = _e591;
            }
            let _e640 = phi_1202_;
            let _e642 = countOneBits(_e640);
            if (_e642 > 0u) {
                let _e645 = atomicAdd((&counters[4u]), _e642);
                phi_1212_ = type_9(_e640, _e645);
            } else {
                phi_1212_ = type_9(_e640, 0u);
            }
            let _e648 = phi_1212_;
            workgroupBarrier();
            if (_e73 == 0u) {
                let _e651 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e651;
            }
            let _e654 = workgroupUniformLoad((&n_hits[0u]));
            let _e655 = (_e654 / 512u);
            if ((_e654 % 512u) > 0u) {
                phi_1238_ = (_e655 + 1u);
            } else {
                phi_1238_ = _e655;
            }
            let _e660 = phi_1238_;
            phi_1241_ = type_9(0u, _e660);
            phi_1244_ = _e648;
            loop {
                let _e663 = phi_1241_;
                let _e665 = phi_1244_;
                if (_e663.member < _e663.member_1) {
                    phi_1242_ = type_9((_e663.member + 1u), _e663.member_1);
                    phi_1269_ = type_9(1u, _e663.member);
                } else {
                    phi_1242_ = _e663;
                    phi_1269_ = type_9(0u, type_9().member_1);
                }
                let _e677 = phi_1242_;
                let _e679 = phi_1269_;
                let _e683 = (bitcast<i32>(_e679.member) != 0i);
                if _e683 {
                    let _e684 = (_e73 / 32u);
                    let _e686 = (_e679.member_1 * 512u);
                    phi_1286_ = _e665;
                    phi_1289_ = type_9(0u, countOneBits(_e665.member));
                    loop {
                        let _e691 = phi_1286_;
                        let _e693 = phi_1289_;
                        local_8 = _e691;
                        if (_e693.member < _e693.member_1) {
                            phi_1290_ = type_9((_e693.member + 1u), _e693.member_1);
                            phi_1312_ = type_9(1u, _e693.member);
                        } else {
                            phi_1290_ = _e693;
                            phi_1312_ = type_9(0u, type_9().member_1);
                        }
                        let _e705 = phi_1290_;
                        let _e707 = phi_1312_;
                        if (bitcast<i32>(_e707.member) != 0i) {
                            let _e712 = (_e691.member_1 - _e686);
                            if (_e712 >= 512u) {
                                phi_1346_ = type_9();
                                phi_1347_ = false;
                            } else {
                                let _e721 = names[((_e684 * 32u) + select(firstTrailingBit(_e691.member), 32u, (_e691.member == 0u)))];
                                hits[_e712] = (((_e684 << bitcast<u32>(10i)) | ((_e73 % 32u) << bitcast<u32>(5i))) | _e721);
                                phi_1346_ = type_9((_e691.member & (_e691.member - 1u)), (_e691.member_1 + 1u));
                                phi_1347_ = true;
                            }
                            let _e737 = phi_1346_;
                            let _e739 = phi_1347_;
                            phi_1287_ = _e737;
                            phi_1348_ = _e739;
                        } else {
                            phi_1287_ = type_9();
                            phi_1348_ = false;
                        }
                        let _e741 = phi_1287_;
                        let _e743 = phi_1348_;
                        continue;
                        continuing {
                            phi_1286_ = _e741;
                            phi_1289_ = _e705;
                            break if !(_e743);
                        }
                    }
                    workgroupBarrier();
                    let _e746 = n_hits[0u];
                    let _e747 = (_e746 - _e686);
                    if (512u < _e747) {
                        phi_1356_ = 512u;
                    } else {
                        phi_1356_ = _e747;
                    }
                    let _e750 = phi_1356_;
                    phi_1359_ = type_9(0u, 4u);
                    loop {
                        let _e752 = phi_1359_;
                        if (_e752.member < _e752.member_1) {
                            phi_1360_ = type_9((_e752.member + 1u), _e752.member_1);
                            phi_1385_ = type_9(1u, _e752.member);
                        } else {
                            phi_1360_ = _e752;
                            phi_1385_ = type_9(0u, type_9().member_1);
                        }
                        let _e764 = phi_1360_;
                        let _e766 = phi_1385_;
                        if (bitcast<i32>(_e766.member) != 0i) {
                            let _e772 = (_e73 + (_e766.member_1 * 128u));
                            if (_e772 >= _e750) {
                                phi_2823_ = false;
                            } else {
                                let _e775 = hits[_e772];
                                let _e778 = ((_e775 >> bitcast<u32>(10i)) & 3u);
                                let _e785 = firsts[(2u * _e778)];
                                let _e790 = firsts[((2u * _e778) + 1u)];
                                let _e793 = leaves.member[(_e785 + ((_e775 >> bitcast<u32>(5i)) & 31u))];
                                let _e799 = leaves.member[(_e790 + (_e775 & 31u))];
                                let _e806 = ((_e775 >> bitcast<u32>(10i)) & 3u);
                                let _e813 = firsts[(2u * _e806)];
                                let _e818 = firsts[((2u * _e806) + 1u)];
                                let _e821 = nodes.member[(_e813 + ((_e775 >> bitcast<u32>(5i)) & 31u))];
                                let _e835 = nodes.member[(_e818 + (_e775 & 31u))];
                                if ((_e91.member_1 & 1u) != 0u) {
                                    if (_e799.x == _e793.x) {
                                        phi_1541_ = true;
                                    } else {
                                        phi_1541_ = (_e799.x == _e793.y);
                                    }
                                    let _e854 = phi_1541_;
                                    if (_e799.y == _e793.x) {
                                        phi_1547_ = true;
                                    } else {
                                        phi_1547_ = (_e799.y == _e793.y);
                                    }
                                    let _e858 = phi_1547_;
                                    if (_e854 || _e858) {
                                        phi_1553_ = false;
                                    } else {
                                        phi_1553_ = true;
                                    }
                                    let _e861 = phi_1553_;
                                    phi_1554_ = _e861;
                                } else {
                                    phi_1554_ = true;
                                }
                                let _e863 = phi_1554_;
                                if _e863 {
                                    if ((_e91.member_1 & 2u) != 0u) {
                                        let _e868 = bodies.member[_e793.x];
                                        let _e870 = bodies.member[_e799.x];
                                        if ((_e868 / 4u) != (_e870 / 4u)) {
                                            phi_1596_ = true;
                                        } else {
                                            if ((_e868 & 2u) == 0u) {
                                                phi_1595_ = false;
                                            } else {
                                                phi_1595_ = true;
                                            }
                                            let _e877 = phi_1595_;
                                            phi_1596_ = _e877;
                                        }
                                        let _e879 = phi_1596_;
                                        if _e879 {
                                            phi_1603_ = (((_e868 & _e870) & 1u) == 0u);
                                        } else {
                                            phi_1603_ = false;
                                        }
                                        let _e884 = phi_1603_;
                                        if _e884 {
                                            if ((_e91.member_1 & 4u) != 0u) {
                                                let _e891 = bodies.member[_e91.member[0]];
                                                let _e894 = bodies.member[(_e91.member[0] + 1u)];
                                                let _e899 = ((_e91.member[0] + 4u) + (2u * (_e868 >> bitcast<u32>(2i))));
                                                let _e904 = ((_e91.member[0] + 4u) + (2u * (_e870 >> bitcast<u32>(2i))));
                                                let _e906 = bodies.member[_e899];
                                                let _e908 = bodies.member[_e904];
                                                let _e917 = bodies.member[((((_e91.member[0] + 4u) + (2u * _e891)) + (_e906 * _e894)) + (_e908 / 32u))];
                                                let _e920 = bodies.member[(_e899 + 1u)];
                                                let _e923 = bodies.member[(_e904 + 1u)];
                                                if (_e920 == _e923) {
                                                    if (((_e917 >> bitcast<u32>(((_e908 % 32u) & 31u))) & 1u) == 1u) {
                                                        phi_1717_ = true;
                                                    } else {
                                                        phi_1717_ = ((_e868 >> bitcast<u32>(2i)) == (_e870 >> bitcast<u32>(2i)));
                                                    }
                                                    let _e937 = phi_1717_;
                                                    phi_1718_ = _e937;
                                                } else {
                                                    phi_1718_ = false;
                                                }
                                                let _e939 = phi_1718_;
                                                if _e939 {
                                                    let _e942 = bodies.member[(_e91.member[0] + 2u)];
                                                    let _e945 = bodies.member[(_e91.member[0] + 3u)];
                                                    let _e946 = (_e945 + _e91.member[0]);
                                                    if (_e799.w < _e793.w) {
                                                        phi_1753_ = _e793.w;
                                                        phi_1754_ = _e799.w;
                                                    } else {
                                                        phi_1753_ = _e799.w;
                                                        phi_1754_ = _e793.w;
                                                    }
                                                    let _e949 = phi_1753_;
                                                    let _e951 = phi_1754_;
                                                    phi_1759_ = type_15(0i, 32i);
                                                    phi_1762_ = _e942;
                                                    phi_1764_ = 0u;
                                                    loop {
                                                        let _e953 = phi_1759_;
                                                        let _e955 = phi_1762_;
                                                        let _e957 = phi_1764_;
                                                        local_4 = _e957;
                                                        local_5 = _e957;
                                                        if (_e953.member < _e953.member_1) {
                                                            let _e964 = (_e953.member + 1i);
                                                            if ((false == (_e964 > _e953.member)) != false) {
                                                                phi_1785_ = true;
                                                            } else {
                                                                phi_1785_ = false;
                                                            }
                                                            let _e969 = phi_1785_;
                                                            if _e969 {
                                                                phi_1791_ = type_16(0u, type_16().member_1);
                                                            } else {
                                                                phi_1791_ = type_16(1u, _e964);
                                                            }
                                                            let _e974 = phi_1791_;
                                                            phi_1760_ = type_15(_e974.member_1, _e953.member_1);
                                                            phi_1805_ = type_16(1u, _e953.member);
                                                        } else {
                                                            phi_1760_ = _e953;
                                                            phi_1805_ = type_16(0u, type_16().member_1);
                                                        }
                                                        let _e980 = phi_1760_;
                                                        let _e982 = phi_1805_;
                                                        if (bitcast<i32>(_e982.member) != 0i) {
                                                            if (_e957 >= _e955) {
                                                                phi_1888_ = u32();
                                                                phi_1889_ = u32();
                                                                phi_1890_ = false;
                                                            } else {
                                                                let _e989 = (_e957 + ((_e955 - _e957) / 2u));
                                                                let _e991 = (_e946 + (3u * _e989));
                                                                let _e993 = bodies.member[_e991];
                                                                let _e996 = bodies.member[(_e991 + 1u)];
                                                                let _e999 = bodies.member[(_e991 + 2u)];
                                                                if (_e993 < 1u) {
                                                                    phi_1881_ = true;
                                                                } else {
                                                                    if (_e993 == 1u) {
                                                                        if (_e996 < _e951) {
                                                                            phi_1875_ = false;
                                                                        } else {
                                                                            if (_e996 == _e951) {
                                                                                if (_e999 < _e949) {
                                                                                    phi_1873_ = false;
                                                                                } else {
                                                                                    phi_1873_ = true;
                                                                                }
                                                                                let _e1006 = phi_1873_;
                                                                                phi_1874_ = _e1006;
                                                                            } else {
                                                                                phi_1874_ = true;
                                                                            }
                                                                            let _e1008 = phi_1874_;
                                                                            phi_1875_ = _e1008;
                                                                        }
                                                                        let _e1010 = phi_1875_;
                                                                        phi_1876_ = _e1010;
                                                                    } else {
                                                                        phi_1876_ = true;
                                                                    }
                                                                    let _e1012 = phi_1876_;
                                                                    if _e1012 {
                                                                        phi_1880_ = false;
                                                                    } else {
                                                                        phi_1880_ = true;
                                                                    }
                                                                    let _e1014 = phi_1880_;
                                                                    phi_1881_ = _e1014;
                                                                }
                                                                let _e1016 = phi_1881_;
                                                                if _e1016 {
                                                                    phi_1886_ = _e955;
                                                                    phi_1887_ = (_e989 + 1u);
                                                                } else {
                                                                    phi_1886_ = _e989;
                                                                    phi_1887_ = _e957;
                                                                }
                                                                let _e1019 = phi_1886_;
                                                                let _e1021 = phi_1887_;
                                                                phi_1888_ = _e1019;
                                                                phi_1889_ = _e1021;
                                                                phi_1890_ = true;
                                                            }
                                                            let _e1023 = phi_1888_;
                                                            let _e1025 = phi_1889_;
                                                            let _e1027 = phi_1890_;
                                                            phi_1763_ = _e1023;
                                                            phi_1765_ = _e1025;
                                                            phi_1891_ = _e1027;
                                                        } else {
                                                            phi_1763_ = u32();
                                                            phi_1765_ = u32();
                                                            phi_1891_ = false;
                                                        }
                                                        let _e1029 = phi_1763_;
                                                        let _e1031 = phi_1765_;
                                                        let _e1033 = phi_1891_;
                                                        continue;
                                                        continuing {
                                                            phi_1759_ = _e980;
                                                            phi_1762_ = _e1029;
                                                            phi_1764_ = _e1031;
                                                            break if !(_e1033);
                                                        }
                                                    }
                                                    let _e1036 = local_4;
                                                    if (_e1036 < _e942) {
                                                        let _e1039 = local_5;
                                                        let _e1041 = (_e946 + (3u * _e1039));
                                                        let _e1043 = bodies.member[_e1041];
                                                        if (_e1043 == 1u) {
                                                            let _e1047 = bodies.member[(_e1041 + 1u)];
                                                            if (_e1047 == _e951) {
                                                                let _e1051 = bodies.member[(_e1041 + 2u)];
                                                                phi_1939_ = (_e1051 == _e949);
                                                                phi_1940_ = false;
                                                            } else {
                                                                phi_1939_ = bool();
                                                                phi_1940_ = true;
                                                            }
                                                            let _e1054 = phi_1939_;
                                                            let _e1056 = phi_1940_;
                                                            phi_1941_ = _e1054;
                                                            phi_1942_ = _e1056;
                                                        } else {
                                                            phi_1941_ = bool();
                                                            phi_1942_ = true;
                                                        }
                                                        let _e1058 = phi_1941_;
                                                        let _e1060 = phi_1942_;
                                                        if _e1060 {
                                                            phi_1946_ = false;
                                                        } else {
                                                            phi_1946_ = _e1058;
                                                        }
                                                        let _e1062 = phi_1946_;
                                                        phi_1947_ = _e1062;
                                                    } else {
                                                        phi_1947_ = false;
                                                    }
                                                    let _e1064 = phi_1947_;
                                                    phi_1951_ = _e1064;
                                                } else {
                                                    phi_1951_ = true;
                                                }
                                                let _e1066 = phi_1951_;
                                                if _e1066 {
                                                    phi_1955_ = false;
                                                } else {
                                                    phi_1955_ = true;
                                                }
                                                let _e1068 = phi_1955_;
                                                phi_1956_ = _e1068;
                                            } else {
                                                phi_1956_ = true;
                                            }
                                            let _e1070 = phi_1956_;
                                            if _e1070 {
                                                phi_1960_ = false;
                                            } else {
                                                phi_1960_ = true;
                                            }
                                            let _e1072 = phi_1960_;
                                            phi_1961_ = _e1072;
                                        } else {
                                            phi_1961_ = true;
                                        }
                                        let _e1074 = phi_1961_;
                                        if _e1074 {
                                            phi_1965_ = false;
                                        } else {
                                            phi_1965_ = true;
                                        }
                                        let _e1076 = phi_1965_;
                                        phi_1966_ = _e1076;
                                    } else {
                                        phi_1966_ = true;
                                    }
                                    let _e1078 = phi_1966_;
                                    if _e1078 {
                                        if ((_e91.member_1 & 32u) != 0u) {
                                            let _e1099 = (((((_e821.member_1.y - _e835.member.x) > _e91.member_6) && ((_e835.member_1.y - _e821.member.x) > _e91.member_6)) && (((_e821.member_2.x - _e835.member.y) > _e91.member_6) && ((_e835.member_2.x - _e821.member.y) > _e91.member_6))) && (((_e821.member_2.y - _e835.member_1.x) > _e91.member_6) && ((_e835.member_2.y - _e821.member_1.x) > _e91.member_6)));
                                            if _e1099 {
                                                phi_2530_ = bool();
                                            } else {
                                                let _e1101 = keys.member[_e793.x];
                                                let _e1104 = keys.member[_e793.y];
                                                let _e1106 = function_(_e1101[0], _e1104[0]);
                                                let _e1108 = keys.member[_e793.z];
                                                let _e1110 = function_(_e1106, _e1108[0]);
                                                let _e1112 = keys.member[_e799.x];
                                                let _e1115 = keys.member[_e799.y];
                                                let _e1117 = function_1(_e1112[3], _e1115[3]);
                                                let _e1119 = keys.member[_e799.z];
                                                let _e1121 = function_1(_e1117, _e1119[3]);
                                                if (_e1110[1] > _e1121[1]) {
                                                    phi_2083_ = true;
                                                } else {
                                                    if (_e1110[1] == _e1121[1]) {
                                                        phi_2082_ = (_e1110[0] > _e1121[0]);
                                                    } else {
                                                        phi_2082_ = false;
                                                    }
                                                    let _e1132 = phi_2082_;
                                                    phi_2083_ = _e1132;
                                                }
                                                let _e1134 = phi_2083_;
                                                let _e1137 = keys.member[_e799.x];
                                                let _e1140 = keys.member[_e799.y];
                                                let _e1142 = function_(_e1137[0], _e1140[0]);
                                                let _e1144 = keys.member[_e799.z];
                                                let _e1146 = function_(_e1142, _e1144[0]);
                                                let _e1148 = keys.member[_e793.x];
                                                let _e1151 = keys.member[_e793.y];
                                                let _e1153 = function_1(_e1148[3], _e1151[3]);
                                                let _e1155 = keys.member[_e793.z];
                                                let _e1157 = function_1(_e1153, _e1155[3]);
                                                if (_e1146[1] > _e1157[1]) {
                                                    phi_2171_ = true;
                                                } else {
                                                    if (_e1146[1] == _e1157[1]) {
                                                        phi_2170_ = (_e1146[0] > _e1157[0]);
                                                    } else {
                                                        phi_2170_ = false;
                                                    }
                                                    let _e1168 = phi_2170_;
                                                    phi_2171_ = _e1168;
                                                }
                                                let _e1170 = phi_2171_;
                                                let _e1174 = keys.member[_e793.x];
                                                let _e1177 = keys.member[_e793.y];
                                                let _e1179 = function_2(_e1174[1], _e1177[1]);
                                                let _e1181 = keys.member[_e793.z];
                                                let _e1183 = function_2(_e1179, _e1181[1]);
                                                let _e1185 = keys.member[_e799.x];
                                                let _e1188 = keys.member[_e799.y];
                                                let _e1190 = function_3(_e1185[4], _e1188[4]);
                                                let _e1192 = keys.member[_e799.z];
                                                let _e1194 = function_3(_e1190, _e1192[4]);
                                                if (_e1183[1] > _e1194[1]) {
                                                    phi_2260_ = true;
                                                } else {
                                                    if (_e1183[1] == _e1194[1]) {
                                                        phi_2259_ = (_e1183[0] > _e1194[0]);
                                                    } else {
                                                        phi_2259_ = false;
                                                    }
                                                    let _e1205 = phi_2259_;
                                                    phi_2260_ = _e1205;
                                                }
                                                let _e1207 = phi_2260_;
                                                let _e1210 = keys.member[_e799.x];
                                                let _e1213 = keys.member[_e799.y];
                                                let _e1215 = function_2(_e1210[1], _e1213[1]);
                                                let _e1217 = keys.member[_e799.z];
                                                let _e1219 = function_2(_e1215, _e1217[1]);
                                                let _e1221 = keys.member[_e793.x];
                                                let _e1224 = keys.member[_e793.y];
                                                let _e1226 = function_3(_e1221[4], _e1224[4]);
                                                let _e1228 = keys.member[_e793.z];
                                                let _e1230 = function_3(_e1226, _e1228[4]);
                                                if (_e1219[1] > _e1230[1]) {
                                                    phi_2348_ = true;
                                                } else {
                                                    if (_e1219[1] == _e1230[1]) {
                                                        phi_2347_ = (_e1219[0] > _e1230[0]);
                                                    } else {
                                                        phi_2347_ = false;
                                                    }
                                                    let _e1241 = phi_2347_;
                                                    phi_2348_ = _e1241;
                                                }
                                                let _e1243 = phi_2348_;
                                                let _e1248 = keys.member[_e793.x];
                                                let _e1251 = keys.member[_e793.y];
                                                let _e1253 = function_4(_e1248[2], _e1251[2]);
                                                let _e1255 = keys.member[_e793.z];
                                                let _e1257 = function_4(_e1253, _e1255[2]);
                                                let _e1259 = keys.member[_e799.x];
                                                let _e1262 = keys.member[_e799.y];
                                                let _e1264 = function_5(_e1259[5], _e1262[5]);
                                                let _e1266 = keys.member[_e799.z];
                                                let _e1268 = function_5(_e1264, _e1266[5]);
                                                if (_e1257[1] > _e1268[1]) {
                                                    phi_2438_ = true;
                                                } else {
                                                    if (_e1257[1] == _e1268[1]) {
                                                        phi_2437_ = (_e1257[0] > _e1268[0]);
                                                    } else {
                                                        phi_2437_ = false;
                                                    }
                                                    let _e1279 = phi_2437_;
                                                    phi_2438_ = _e1279;
                                                }
                                                let _e1281 = phi_2438_;
                                                let _e1284 = keys.member[_e799.x];
                                                let _e1287 = keys.member[_e799.y];
                                                let _e1289 = function_4(_e1284[2], _e1287[2]);
                                                let _e1291 = keys.member[_e799.z];
                                                let _e1293 = function_4(_e1289, _e1291[2]);
                                                let _e1295 = keys.member[_e793.x];
                                                let _e1298 = keys.member[_e793.y];
                                                let _e1300 = function_5(_e1295[5], _e1298[5]);
                                                let _e1302 = keys.member[_e793.z];
                                                let _e1304 = function_5(_e1300, _e1302[5]);
                                                if (_e1293[1] > _e1304[1]) {
                                                    phi_2526_ = true;
                                                } else {
                                                    if (_e1293[1] == _e1304[1]) {
                                                        phi_2525_ = (_e1293[0] > _e1304[0]);
                                                    } else {
                                                        phi_2525_ = false;
                                                    }
                                                    let _e1315 = phi_2525_;
                                                    phi_2526_ = _e1315;
                                                }
                                                let _e1317 = phi_2526_;
                                                phi_2530_ = (((!(_e1134) && !(_e1170)) && (!(_e1207) && !(_e1243))) && (!(_e1281) && !(_e1317)));
                                            }
                                            let _e1322 = phi_2530_;
                                            phi_2531_ = _e1322;
                                            phi_2532_ = _e1099;
                                        } else {
                                            phi_2531_ = bool();
                                            phi_2532_ = true;
                                        }
                                        let _e1324 = phi_2531_;
                                        let _e1326 = phi_2532_;
                                        if _e1326 {
                                            phi_2536_ = false;
                                        } else {
                                            phi_2536_ = true;
                                        }
                                        let _e1328 = phi_2536_;
                                        phi_2537_ = _e1324;
                                        phi_2538_ = _e1328;
                                    } else {
                                        phi_2537_ = false;
                                        phi_2538_ = true;
                                    }
                                    let _e1330 = phi_2537_;
                                    let _e1332 = phi_2538_;
                                    phi_2539_ = _e1330;
                                    phi_2540_ = _e1332;
                                } else {
                                    phi_2539_ = false;
                                    phi_2540_ = true;
                                }
                                let _e1334 = phi_2539_;
                                let _e1336 = phi_2540_;
                                if _e1336 {
                                    phi_2544_ = _e1334;
                                } else {
                                    phi_2544_ = true;
                                }
                                let _e1338 = phi_2544_;
                                if _e1338 {
                                    let _e1340 = atomicAdd((&counters[9u]), 1u);
                                }
                                if _e1338 {
                                    if (_e793.w < _e799.w) {
                                        phi_2579_ = type_43(1u, array<u32, 4>(_e793.x, _e793.y, _e799.x, _e799.y));
                                    } else {
                                        phi_2579_ = type_43(1u, array<u32, 4>(_e799.x, _e799.y, _e793.x, _e793.y));
                                    }
                                    let _e1347 = phi_2579_;
                                    let _e1352 = paths.member[_e1347.member_1[0]];
                                    let _e1367 = paths.member[_e1347.member_1[1]];
                                    let _e1382 = paths.member[_e1347.member_1[2]];
                                    let _e1397 = paths.member[_e1347.member_1[3]];
                                    let _e1410 = array<f32, 3>(_e1352.member.x, _e1352.member.y, _e1352.member.z);
                                    let _e1411 = array<f32, 3>(_e1352.member_1.x, _e1352.member_1.y, _e1352.member_1.z);
                                    let _e1416 = (((_e91.member_5 + (2f * _e91.member_4)) * 1.0001f) + (8f * 0.000000000000000000000000000000000000011754944f));
                                    if (_e1347.member != 0u) {
                                        let _e1441 = function_7(_e1352.member.x, _e1367.member.x);
                                        let _e1442 = function_7(_e1352.member.y, _e1367.member.y);
                                        let _e1443 = function_7(_e1352.member.z, _e1367.member.z);
                                        let _e1445 = function_6(_e1352.member.x, _e1367.member.x);
                                        let _e1446 = function_6(_e1352.member.y, _e1367.member.y);
                                        let _e1447 = function_6(_e1352.member.z, _e1367.member.z);
                                        let _e1450 = function_7(_e1382.member.x, _e1397.member.x);
                                        let _e1451 = function_7(_e1382.member.y, _e1397.member.y);
                                        let _e1452 = function_7(_e1382.member.z, _e1397.member.z);
                                        let _e1454 = function_6(_e1382.member.x, _e1397.member.x);
                                        let _e1455 = function_6(_e1382.member.y, _e1397.member.y);
                                        let _e1456 = function_6(_e1382.member.z, _e1397.member.z);
                                        phi_2704_ = type_44(array<array<f32, 3>, 2>(array<f32, 3>(_e1441, _e1442, _e1443), array<f32, 3>(_e1445, _e1446, _e1447)), array<array<f32, 3>, 2>(array<f32, 3>(_e1450, _e1451, _e1452), array<f32, 3>(_e1454, _e1455, _e1456)));
                                    } else {
                                        let _e1418 = function_7(_e1367.member.x, _e1382.member.x);
                                        let _e1419 = function_7(_e1367.member.y, _e1382.member.y);
                                        let _e1420 = function_7(_e1367.member.z, _e1382.member.z);
                                        let _e1421 = function_6(_e1367.member.x, _e1382.member.x);
                                        let _e1422 = function_6(_e1367.member.y, _e1382.member.y);
                                        let _e1423 = function_6(_e1367.member.z, _e1382.member.z);
                                        let _e1425 = function_7(_e1418, _e1397.member.x);
                                        let _e1426 = function_7(_e1419, _e1397.member.y);
                                        let _e1427 = function_7(_e1420, _e1397.member.z);
                                        let _e1429 = function_6(_e1418, _e1397.member.x);
                                        let _e1430 = function_6(_e1419, _e1397.member.y);
                                        let _e1431 = function_6(_e1420, _e1397.member.z);
                                        let _e1432 = function_7(_e1421, _e1397.member.x);
                                        let _e1433 = function_7(_e1422, _e1397.member.y);
                                        let _e1434 = function_7(_e1423, _e1397.member.z);
                                        let _e1435 = function_6(_e1421, _e1397.member.x);
                                        let _e1436 = function_6(_e1422, _e1397.member.y);
                                        let _e1437 = function_6(_e1423, _e1397.member.z);
                                        phi_2704_ = type_44(array<array<f32, 3>, 2>(_e1410, _e1410), array<array<f32, 3>, 2>(array<f32, 3>(_e1425, _e1426, _e1427), array<f32, 3>(_e1435, _e1436, _e1437)));
                                    }
                                    let _e1461 = phi_2704_;
                                    if (_e1347.member != 0u) {
                                        let _e1486 = function_7(_e1352.member_1.x, _e1367.member_1.x);
                                        let _e1487 = function_7(_e1352.member_1.y, _e1367.member_1.y);
                                        let _e1488 = function_7(_e1352.member_1.z, _e1367.member_1.z);
                                        let _e1490 = function_6(_e1352.member_1.x, _e1367.member_1.x);
                                        let _e1491 = function_6(_e1352.member_1.y, _e1367.member_1.y);
                                        let _e1492 = function_6(_e1352.member_1.z, _e1367.member_1.z);
                                        let _e1495 = function_7(_e1382.member_1.x, _e1397.member_1.x);
                                        let _e1496 = function_7(_e1382.member_1.y, _e1397.member_1.y);
                                        let _e1497 = function_7(_e1382.member_1.z, _e1397.member_1.z);
                                        let _e1499 = function_6(_e1382.member_1.x, _e1397.member_1.x);
                                        let _e1500 = function_6(_e1382.member_1.y, _e1397.member_1.y);
                                        let _e1501 = function_6(_e1382.member_1.z, _e1397.member_1.z);
                                        phi_2751_ = type_44(array<array<f32, 3>, 2>(array<f32, 3>(_e1486, _e1487, _e1488), array<f32, 3>(_e1490, _e1491, _e1492)), array<array<f32, 3>, 2>(array<f32, 3>(_e1495, _e1496, _e1497), array<f32, 3>(_e1499, _e1500, _e1501)));
                                    } else {
                                        let _e1463 = function_7(_e1367.member_1.x, _e1382.member_1.x);
                                        let _e1464 = function_7(_e1367.member_1.y, _e1382.member_1.y);
                                        let _e1465 = function_7(_e1367.member_1.z, _e1382.member_1.z);
                                        let _e1466 = function_6(_e1367.member_1.x, _e1382.member_1.x);
                                        let _e1467 = function_6(_e1367.member_1.y, _e1382.member_1.y);
                                        let _e1468 = function_6(_e1367.member_1.z, _e1382.member_1.z);
                                        let _e1470 = function_7(_e1463, _e1397.member_1.x);
                                        let _e1471 = function_7(_e1464, _e1397.member_1.y);
                                        let _e1472 = function_7(_e1465, _e1397.member_1.z);
                                        let _e1474 = function_6(_e1463, _e1397.member_1.x);
                                        let _e1475 = function_6(_e1464, _e1397.member_1.y);
                                        let _e1476 = function_6(_e1465, _e1397.member_1.z);
                                        let _e1477 = function_7(_e1466, _e1397.member_1.x);
                                        let _e1478 = function_7(_e1467, _e1397.member_1.y);
                                        let _e1479 = function_7(_e1468, _e1397.member_1.z);
                                        let _e1480 = function_6(_e1466, _e1397.member_1.x);
                                        let _e1481 = function_6(_e1467, _e1397.member_1.y);
                                        let _e1482 = function_6(_e1468, _e1397.member_1.z);
                                        phi_2751_ = type_44(array<array<f32, 3>, 2>(_e1411, _e1411), array<array<f32, 3>, 2>(array<f32, 3>(_e1470, _e1471, _e1472), array<f32, 3>(_e1480, _e1481, _e1482)));
                                    }
                                    let _e1506 = phi_2751_;
                                    if !(((((((_e1461.member[0][0] - _e1461.member_1[1][0]) > _e1416) && ((_e1506.member[0][0] - _e1506.member_1[1][0]) > _e1416)) || (((_e1461.member_1[0][0] - _e1461.member[1][0]) > _e1416) && ((_e1506.member_1[0][0] - _e1506.member[1][0]) > _e1416))) || ((((_e1461.member[0][1] - _e1461.member_1[1][1]) > _e1416) && ((_e1506.member[0][1] - _e1506.member_1[1][1]) > _e1416)) || (((_e1461.member_1[0][1] - _e1461.member[1][1]) > _e1416) && ((_e1506.member_1[0][1] - _e1506.member[1][1]) > _e1416)))) || ((((_e1461.member[0][2] - _e1461.member_1[1][2]) > _e1416) && ((_e1506.member[0][2] - _e1506.member_1[1][2]) > _e1416)) || (((_e1461.member_1[0][2] - _e1461.member[1][2]) > _e1416) && ((_e1506.member_1[0][2] - _e1506.member[1][2]) > _e1416))))) {
                                        let _e1596 = atomicAdd((&counters[5u]), 1u);
                                        left[_e1596] = _e775;
                                    }
                                }
                                phi_2823_ = true;
                            }
                            let _e1599 = phi_2823_;
                            phi_2824_ = _e1599;
                        } else {
                            phi_2824_ = false;
                        }
                        let _e1601 = phi_2824_;
                        continue;
                        continuing {
                            phi_1359_ = _e764;
                            break if !(_e1601);
                        }
                    }
                    workgroupBarrier();
                    let _e1604 = atomicLoad((&counters[5u]));
                    phi_2829_ = type_9(0u, 4u);
                    loop {
                        let _e1606 = phi_2829_;
                        if (_e1606.member < _e1606.member_1) {
                            phi_2830_ = type_9((_e1606.member + 1u), _e1606.member_1);
                            phi_2853_ = type_9(1u, _e1606.member);
                        } else {
                            phi_2830_ = _e1606;
                            phi_2853_ = type_9(0u, type_9().member_1);
                        }
                        let _e1618 = phi_2830_;
                        let _e1620 = phi_2853_;
                        if (bitcast<i32>(_e1620.member) != 0i) {
                            let _e1626 = (_e73 + (_e1620.member_1 * 128u));
                            if (_e1626 >= _e1604) {
                                phi_4704_ = false;
                            } else {
                                let _e1629 = left[_e1626];
                                let _e1632 = ((_e1629 >> bitcast<u32>(10i)) & 3u);
                                let _e1639 = firsts[(2u * _e1632)];
                                let _e1644 = firsts[((2u * _e1632) + 1u)];
                                let _e1647 = leaves.member[(_e1639 + ((_e1629 >> bitcast<u32>(5i)) & 31u))];
                                let _e1652 = leaves.member[(_e1644 + (_e1629 & 31u))];
                                if (_e1647.w < _e1652.w) {
                                    phi_2924_ = type_43(1u, array<u32, 4>(_e1647.x, _e1647.y, _e1652.x, _e1652.y));
                                } else {
                                    phi_2924_ = type_43(1u, array<u32, 4>(_e1652.x, _e1652.y, _e1647.x, _e1647.y));
                                }
                                let _e1662 = phi_2924_;
                                let _e1667 = paths.member[_e1662.member_1[0]];
                                let _e1682 = paths.member[_e1662.member_1[1]];
                                let _e1697 = paths.member[_e1662.member_1[2]];
                                let _e1712 = paths.member[_e1662.member_1[3]];
                                if (_e1662.member != 0u) {
                                    phi_3058_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e1697.member.x - _e1667.member.x), (_e1697.member.y - _e1667.member.y), (_e1697.member.z - _e1667.member.z)), array<f32, 3>((_e1697.member_1.x - _e1667.member_1.x), (_e1697.member_1.y - _e1667.member_1.y), (_e1697.member_1.z - _e1667.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1682.member.x - _e1667.member.x), (_e1682.member.y - _e1667.member.y), (_e1682.member.z - _e1667.member.z)), array<f32, 3>((_e1682.member_1.x - _e1667.member_1.x), (_e1682.member_1.y - _e1667.member_1.y), (_e1682.member_1.z - _e1667.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1697.member.x - _e1712.member.x), (_e1697.member.y - _e1712.member.y), (_e1697.member.z - _e1712.member.z)), array<f32, 3>((_e1697.member_1.x - _e1712.member_1.x), (_e1697.member_1.y - _e1712.member_1.y), (_e1697.member_1.z - _e1712.member_1.z))), (_e91.member_4 + _e91.member_4));
                                } else {
                                    phi_3058_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e1667.member.x - _e1682.member.x), (_e1667.member.y - _e1682.member.y), (_e1667.member.z - _e1682.member.z)), array<f32, 3>((_e1667.member_1.x - _e1682.member_1.x), (_e1667.member_1.y - _e1682.member_1.y), (_e1667.member_1.z - _e1682.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1697.member.x - _e1682.member.x), (_e1697.member.y - _e1682.member.y), (_e1697.member.z - _e1682.member.z)), array<f32, 3>((_e1697.member_1.x - _e1682.member_1.x), (_e1697.member_1.y - _e1682.member_1.y), (_e1697.member_1.z - _e1682.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e1712.member.x - _e1682.member.x), (_e1712.member.y - _e1682.member.y), (_e1712.member.z - _e1682.member.z)), array<f32, 3>((_e1712.member_1.x - _e1682.member_1.x), (_e1712.member_1.y - _e1682.member_1.y), (_e1712.member_1.z - _e1682.member_1.z))), (_e91.member_4 + _e91.member_4));
                                }
                                let _e1785 = phi_3058_;
                                local_2 = type_39(array<array<f32, 3>, 2>(array<f32, 3>(_e1785.member[0][0], _e1785.member[0][1], _e1785.member[0][2]), array<f32, 3>(_e1785.member[1][0], _e1785.member[1][1], _e1785.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e1785.member_1[0][0], _e1785.member_1[0][1], _e1785.member_1[0][2]), array<f32, 3>(_e1785.member_1[1][0], _e1785.member_1[1][1], _e1785.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e1785.member_2[0][0], _e1785.member_2[0][1], _e1785.member_2[0][2]), array<f32, 3>(_e1785.member_2[1][0], _e1785.member_2[1][1], _e1785.member_2[1][2])), _e1785.member_3);
                                let _e1826 = local_2.member_1[0u];
                                let _e1832 = local_2.member_2[0u];
                                let _e1838 = ((_e1826[1] * _e1832[2]) - (_e1826[2] * _e1832[1]));
                                let _e1841 = ((_e1826[2] * _e1832[0]) - (_e1826[0] * _e1832[2]));
                                let _e1844 = ((_e1826[0] * _e1832[1]) - (_e1826[1] * _e1832[0]));
                                let _e1847 = local_2.member_1[1u];
                                let _e1853 = local_2.member_2[1u];
                                let _e1859 = ((_e1847[1] * _e1853[2]) - (_e1847[2] * _e1853[1]));
                                let _e1862 = ((_e1847[2] * _e1853[0]) - (_e1847[0] * _e1853[2]));
                                let _e1865 = ((_e1847[0] * _e1853[1]) - (_e1847[1] * _e1853[0]));
                                let _e1868 = local_2.member_1[0u];
                                let _e1874 = local_2.member_2[1u];
                                let _e1889 = local_2.member_1[1u];
                                let _e1895 = local_2.member_2[0u];
                                let _e1908 = (((_e1868[1] * _e1874[2]) - (_e1868[2] * _e1874[1])) + ((_e1889[1] * _e1895[2]) - (_e1889[2] * _e1895[1])));
                                let _e1909 = (((_e1868[2] * _e1874[0]) - (_e1868[0] * _e1874[2])) + ((_e1889[2] * _e1895[0]) - (_e1889[0] * _e1895[2])));
                                let _e1910 = (((_e1868[0] * _e1874[1]) - (_e1868[1] * _e1874[0])) + ((_e1889[0] * _e1895[1]) - (_e1889[1] * _e1895[0])));
                                let _e1913 = local_2.member[0u];
                                let _e1924 = local_2.member[1u];
                                let _e1935 = local_2.member[0u];
                                let _e1944 = ((((_e1924[0] * _e1838) + (_e1924[1] * _e1841)) + (_e1924[2] * _e1844)) + (((_e1935[0] * _e1908) + (_e1935[1] * _e1909)) + (_e1935[2] * _e1910)));
                                let _e1947 = local_2.member[0u];
                                let _e1958 = local_2.member[1u];
                                let _e1967 = ((((_e1947[0] * _e1859) + (_e1947[1] * _e1862)) + (_e1947[2] * _e1865)) + (((_e1958[0] * _e1908) + (_e1958[1] * _e1909)) + (_e1958[2] * _e1910)));
                                let _e1970 = local_2.member[1u];
                                let _e1981 = local_2.member[0u];
                                if (_e1981[0] < 0f) {
                                    phi_3338_ = -(_e1981[0]);
                                } else {
                                    phi_3338_ = _e1981[0];
                                }
                                let _e1988 = phi_3338_;
                                if (_e1981[1] < 0f) {
                                    phi_3345_ = -(_e1981[1]);
                                } else {
                                    phi_3345_ = _e1981[1];
                                }
                                let _e1992 = phi_3345_;
                                if (_e1988 > _e1992) {
                                    phi_3350_ = _e1988;
                                } else {
                                    phi_3350_ = _e1992;
                                }
                                let _e1995 = phi_3350_;
                                if (_e1981[2] < 0f) {
                                    phi_3357_ = -(_e1981[2]);
                                } else {
                                    phi_3357_ = _e1981[2];
                                }
                                let _e1999 = phi_3357_;
                                if (_e1995 > _e1999) {
                                    phi_3362_ = _e1995;
                                } else {
                                    phi_3362_ = _e1999;
                                }
                                let _e2002 = phi_3362_;
                                let _e2005 = local_2.member[1u];
                                if (_e2005[0] < 0f) {
                                    phi_3375_ = -(_e2005[0]);
                                } else {
                                    phi_3375_ = _e2005[0];
                                }
                                let _e2012 = phi_3375_;
                                if (_e2005[1] < 0f) {
                                    phi_3382_ = -(_e2005[1]);
                                } else {
                                    phi_3382_ = _e2005[1];
                                }
                                let _e2016 = phi_3382_;
                                if (_e2012 > _e2016) {
                                    phi_3387_ = _e2012;
                                } else {
                                    phi_3387_ = _e2016;
                                }
                                let _e2019 = phi_3387_;
                                if (_e2005[2] < 0f) {
                                    phi_3394_ = -(_e2005[2]);
                                } else {
                                    phi_3394_ = _e2005[2];
                                }
                                let _e2023 = phi_3394_;
                                if (_e2019 > _e2023) {
                                    phi_3399_ = _e2019;
                                } else {
                                    phi_3399_ = _e2023;
                                }
                                let _e2026 = phi_3399_;
                                if (_e2002 > _e2026) {
                                    phi_3404_ = _e2002;
                                } else {
                                    phi_3404_ = _e2026;
                                }
                                let _e2029 = phi_3404_;
                                let _e2031 = local_2.member_3;
                                let _e2032 = (_e2029 + _e2031);
                                let _e2035 = local_2.member_1[0u];
                                if (_e2035[0] < 0f) {
                                    phi_3421_ = -(_e2035[0]);
                                } else {
                                    phi_3421_ = _e2035[0];
                                }
                                let _e2042 = phi_3421_;
                                if (_e2035[1] < 0f) {
                                    phi_3428_ = -(_e2035[1]);
                                } else {
                                    phi_3428_ = _e2035[1];
                                }
                                let _e2046 = phi_3428_;
                                if (_e2042 > _e2046) {
                                    phi_3433_ = _e2042;
                                } else {
                                    phi_3433_ = _e2046;
                                }
                                let _e2049 = phi_3433_;
                                if (_e2035[2] < 0f) {
                                    phi_3440_ = -(_e2035[2]);
                                } else {
                                    phi_3440_ = _e2035[2];
                                }
                                let _e2053 = phi_3440_;
                                if (_e2049 > _e2053) {
                                    phi_3445_ = _e2049;
                                } else {
                                    phi_3445_ = _e2053;
                                }
                                let _e2056 = phi_3445_;
                                let _e2059 = local_2.member_1[1u];
                                if (_e2059[0] < 0f) {
                                    phi_3459_ = -(_e2059[0]);
                                } else {
                                    phi_3459_ = _e2059[0];
                                }
                                let _e2066 = phi_3459_;
                                if (_e2059[1] < 0f) {
                                    phi_3466_ = -(_e2059[1]);
                                } else {
                                    phi_3466_ = _e2059[1];
                                }
                                let _e2070 = phi_3466_;
                                if (_e2066 > _e2070) {
                                    phi_3471_ = _e2066;
                                } else {
                                    phi_3471_ = _e2070;
                                }
                                let _e2073 = phi_3471_;
                                if (_e2059[2] < 0f) {
                                    phi_3478_ = -(_e2059[2]);
                                } else {
                                    phi_3478_ = _e2059[2];
                                }
                                let _e2077 = phi_3478_;
                                if (_e2073 > _e2077) {
                                    phi_3483_ = _e2073;
                                } else {
                                    phi_3483_ = _e2077;
                                }
                                let _e2080 = phi_3483_;
                                if (_e2056 > _e2080) {
                                    phi_3488_ = _e2056;
                                } else {
                                    phi_3488_ = _e2080;
                                }
                                let _e2083 = phi_3488_;
                                let _e2085 = local_2.member_3;
                                let _e2086 = (_e2083 + _e2085);
                                let _e2089 = local_2.member_2[0u];
                                if (_e2089[0] < 0f) {
                                    phi_3505_ = -(_e2089[0]);
                                } else {
                                    phi_3505_ = _e2089[0];
                                }
                                let _e2096 = phi_3505_;
                                if (_e2089[1] < 0f) {
                                    phi_3512_ = -(_e2089[1]);
                                } else {
                                    phi_3512_ = _e2089[1];
                                }
                                let _e2100 = phi_3512_;
                                if (_e2096 > _e2100) {
                                    phi_3517_ = _e2096;
                                } else {
                                    phi_3517_ = _e2100;
                                }
                                let _e2103 = phi_3517_;
                                if (_e2089[2] < 0f) {
                                    phi_3524_ = -(_e2089[2]);
                                } else {
                                    phi_3524_ = _e2089[2];
                                }
                                let _e2107 = phi_3524_;
                                if (_e2103 > _e2107) {
                                    phi_3529_ = _e2103;
                                } else {
                                    phi_3529_ = _e2107;
                                }
                                let _e2110 = phi_3529_;
                                let _e2113 = local_2.member_2[1u];
                                if (_e2113[0] < 0f) {
                                    phi_3543_ = -(_e2113[0]);
                                } else {
                                    phi_3543_ = _e2113[0];
                                }
                                let _e2120 = phi_3543_;
                                if (_e2113[1] < 0f) {
                                    phi_3550_ = -(_e2113[1]);
                                } else {
                                    phi_3550_ = _e2113[1];
                                }
                                let _e2124 = phi_3550_;
                                if (_e2120 > _e2124) {
                                    phi_3555_ = _e2120;
                                } else {
                                    phi_3555_ = _e2124;
                                }
                                let _e2127 = phi_3555_;
                                if (_e2113[2] < 0f) {
                                    phi_3562_ = -(_e2113[2]);
                                } else {
                                    phi_3562_ = _e2113[2];
                                }
                                let _e2131 = phi_3562_;
                                if (_e2127 > _e2131) {
                                    phi_3567_ = _e2127;
                                } else {
                                    phi_3567_ = _e2131;
                                }
                                let _e2134 = phi_3567_;
                                if (_e2110 > _e2134) {
                                    phi_3572_ = _e2110;
                                } else {
                                    phi_3572_ = _e2134;
                                }
                                let _e2137 = phi_3572_;
                                let _e2139 = local_2.member_3;
                                let _e2140 = (_e2137 + _e2139);
                                let _e2142 = ((_e2086 * 8f) * _e2140);
                                let _e2149 = local_2.member_3;
                                if (_e1838 < 0f) {
                                    phi_3603_ = -(_e1838);
                                } else {
                                    phi_3603_ = _e1838;
                                }
                                let _e2166 = phi_3603_;
                                if (_e1841 < 0f) {
                                    phi_3609_ = -(_e1841);
                                } else {
                                    phi_3609_ = _e1841;
                                }
                                let _e2170 = phi_3609_;
                                if (_e1844 < 0f) {
                                    phi_3616_ = -(_e1844);
                                } else {
                                    phi_3616_ = _e1844;
                                }
                                let _e2175 = phi_3616_;
                                let _e2176 = ((_e2166 + _e2170) + _e2175);
                                if (_e1859 < 0f) {
                                    phi_3623_ = -(_e1859);
                                } else {
                                    phi_3623_ = _e1859;
                                }
                                let _e2180 = phi_3623_;
                                if (_e1862 < 0f) {
                                    phi_3629_ = -(_e1862);
                                } else {
                                    phi_3629_ = _e1862;
                                }
                                let _e2184 = phi_3629_;
                                if (_e1865 < 0f) {
                                    phi_3636_ = -(_e1865);
                                } else {
                                    phi_3636_ = _e1865;
                                }
                                let _e2189 = phi_3636_;
                                let _e2190 = ((_e2180 + _e2184) + _e2189);
                                if (_e2176 > _e2190) {
                                    phi_3642_ = _e2176;
                                } else {
                                    phi_3642_ = _e2190;
                                }
                                let _e2193 = phi_3642_;
                                if (_e1908 < 0f) {
                                    phi_3648_ = -(_e1908);
                                } else {
                                    phi_3648_ = _e1908;
                                }
                                let _e2197 = phi_3648_;
                                if (_e1909 < 0f) {
                                    phi_3654_ = -(_e1909);
                                } else {
                                    phi_3654_ = _e1909;
                                }
                                let _e2201 = phi_3654_;
                                if (_e1910 < 0f) {
                                    phi_3661_ = -(_e1910);
                                } else {
                                    phi_3661_ = _e1910;
                                }
                                let _e2206 = phi_3661_;
                                let _e2208 = (((_e2197 + _e2201) + _e2206) * 0.5f);
                                if (_e2193 > _e2208) {
                                    phi_3668_ = _e2193;
                                } else {
                                    phi_3668_ = _e2208;
                                }
                                let _e2211 = phi_3668_;
                                let _e2216 = local_2.member_3;
                                let _e2229 = ((((_e1913[0] * _e1838) + (_e1913[1] * _e1841)) + (_e1913[2] * _e1844)) * 3f);
                                let _e2230 = ((((_e1970[0] * _e1859) + (_e1970[1] * _e1862)) + (_e1970[2] * _e1865)) * 3f);
                                if (_e2229 < _e2230) {
                                    phi_3692_ = _e2229;
                                } else {
                                    phi_3692_ = _e2230;
                                }
                                let _e2233 = phi_3692_;
                                if (_e1944 < _e1967) {
                                    phi_3697_ = _e1944;
                                } else {
                                    phi_3697_ = _e1967;
                                }
                                let _e2236 = phi_3697_;
                                if (_e2233 < _e2236) {
                                    phi_3702_ = _e2233;
                                } else {
                                    phi_3702_ = _e2236;
                                }
                                let _e2239 = phi_3702_;
                                if (_e2229 > _e2230) {
                                    phi_3707_ = _e2229;
                                } else {
                                    phi_3707_ = _e2230;
                                }
                                let _e2242 = phi_3707_;
                                if (_e1944 > _e1967) {
                                    phi_3712_ = _e1944;
                                } else {
                                    phi_3712_ = _e1967;
                                }
                                let _e2245 = phi_3712_;
                                if (_e2242 > _e2245) {
                                    phi_3717_ = _e2242;
                                } else {
                                    phi_3717_ = _e2245;
                                }
                                let _e2248 = phi_3717_;
                                let _e2253 = -(_e2248);
                                if (_e2239 > _e2253) {
                                    phi_3727_ = _e2239;
                                } else {
                                    phi_3727_ = _e2253;
                                }
                                let _e2256 = phi_3727_;
                                let _e2258 = ((_e2256 - ((((((_e2032 * 8f) * _e2142) * (0.000000059604645f * (524f / 64f))) + ((_e2149 * 19f) * ((_e2032 * (_e2086 + _e2140)) + (_e2086 * _e2140)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2032) * ((1f + _e2086) * (1f + _e2140))))) + ((_e91.member_5 * (((_e2211 + (_e2142 * (0.000000059604645f * 8f))) + ((_e2216 * 6f) * (_e2086 + _e2140))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e2086) * (1f + _e2140))))) * (3f * 1.0001f)))) > 0f);
                                if _e2258 {
                                    phi_4696_ = _e2258;
                                } else {
                                    let _e2261 = local_2.member_1[0u];
                                    let _e2267 = local_2.member_1[1u];
                                    let _e2271 = (_e2261[0] + _e2267[0]);
                                    let _e2272 = (_e2261[1] + _e2267[1]);
                                    let _e2273 = (_e2261[2] + _e2267[2]);
                                    let _e2276 = local_2.member_2[0u];
                                    let _e2282 = local_2.member_2[1u];
                                    let _e2286 = (_e2276[0] + _e2282[0]);
                                    let _e2287 = (_e2276[1] + _e2282[1]);
                                    let _e2288 = (_e2276[2] + _e2282[2]);
                                    let _e2291 = ((_e2272 * _e2288) - (_e2273 * _e2287));
                                    let _e2294 = ((_e2273 * _e2286) - (_e2271 * _e2288));
                                    let _e2297 = ((_e2271 * _e2287) - (_e2272 * _e2286));
                                    let _e2300 = local_2.member[0u];
                                    let _e2307 = local_2.member_1[0u];
                                    let _e2313 = local_2.member_2[0u];
                                    let _e2317 = (_e2300[0] - _e2307[0]);
                                    let _e2318 = (_e2300[1] - _e2307[1]);
                                    let _e2319 = (_e2300[2] - _e2307[2]);
                                    if (_e1662.member == 0u) {
                                        phi_3843_ = array<f32, 3>(_e2300[0], _e2300[1], _e2300[2]);
                                    } else {
                                        phi_3843_ = array<f32, 3>((_e2317 - _e2313[0]), (_e2318 - _e2313[1]), (_e2319 - _e2313[2]));
                                    }
                                    let _e2326 = phi_3843_;
                                    let _e2327 = (_e2300[0] - _e2313[0]);
                                    let _e2328 = (_e2300[1] - _e2313[1]);
                                    let _e2329 = (_e2300[2] - _e2313[2]);
                                    let _e2332 = local_2.member[1u];
                                    let _e2339 = local_2.member_1[1u];
                                    let _e2345 = local_2.member_2[1u];
                                    let _e2349 = (_e2332[0] - _e2339[0]);
                                    let _e2350 = (_e2332[1] - _e2339[1]);
                                    let _e2351 = (_e2332[2] - _e2339[2]);
                                    if (_e1662.member == 0u) {
                                        phi_3908_ = array<f32, 3>(_e2332[0], _e2332[1], _e2332[2]);
                                    } else {
                                        phi_3908_ = array<f32, 3>((_e2349 - _e2345[0]), (_e2350 - _e2345[1]), (_e2351 - _e2345[2]));
                                    }
                                    let _e2358 = phi_3908_;
                                    let _e2359 = (_e2332[0] - _e2345[0]);
                                    let _e2360 = (_e2332[1] - _e2345[1]);
                                    let _e2361 = (_e2332[2] - _e2345[2]);
                                    let _e2364 = local_2.member[0u];
                                    if (_e2364[0] < 0f) {
                                        phi_3930_ = -(_e2364[0]);
                                    } else {
                                        phi_3930_ = _e2364[0];
                                    }
                                    let _e2371 = phi_3930_;
                                    if (_e2364[1] < 0f) {
                                        phi_3937_ = -(_e2364[1]);
                                    } else {
                                        phi_3937_ = _e2364[1];
                                    }
                                    let _e2375 = phi_3937_;
                                    if (_e2371 > _e2375) {
                                        phi_3942_ = _e2371;
                                    } else {
                                        phi_3942_ = _e2375;
                                    }
                                    let _e2378 = phi_3942_;
                                    if (_e2364[2] < 0f) {
                                        phi_3949_ = -(_e2364[2]);
                                    } else {
                                        phi_3949_ = _e2364[2];
                                    }
                                    let _e2382 = phi_3949_;
                                    if (_e2378 > _e2382) {
                                        phi_3954_ = _e2378;
                                    } else {
                                        phi_3954_ = _e2382;
                                    }
                                    let _e2385 = phi_3954_;
                                    let _e2388 = local_2.member[1u];
                                    if (_e2388[0] < 0f) {
                                        phi_3967_ = -(_e2388[0]);
                                    } else {
                                        phi_3967_ = _e2388[0];
                                    }
                                    let _e2395 = phi_3967_;
                                    if (_e2388[1] < 0f) {
                                        phi_3974_ = -(_e2388[1]);
                                    } else {
                                        phi_3974_ = _e2388[1];
                                    }
                                    let _e2399 = phi_3974_;
                                    if (_e2395 > _e2399) {
                                        phi_3979_ = _e2395;
                                    } else {
                                        phi_3979_ = _e2399;
                                    }
                                    let _e2402 = phi_3979_;
                                    if (_e2388[2] < 0f) {
                                        phi_3986_ = -(_e2388[2]);
                                    } else {
                                        phi_3986_ = _e2388[2];
                                    }
                                    let _e2406 = phi_3986_;
                                    if (_e2402 > _e2406) {
                                        phi_3991_ = _e2402;
                                    } else {
                                        phi_3991_ = _e2406;
                                    }
                                    let _e2409 = phi_3991_;
                                    if (_e2385 > _e2409) {
                                        phi_3996_ = _e2385;
                                    } else {
                                        phi_3996_ = _e2409;
                                    }
                                    let _e2412 = phi_3996_;
                                    let _e2414 = local_2.member_3;
                                    let _e2418 = local_2.member_1[0u];
                                    if (_e2418[0] < 0f) {
                                        phi_4013_ = -(_e2418[0]);
                                    } else {
                                        phi_4013_ = _e2418[0];
                                    }
                                    let _e2425 = phi_4013_;
                                    if (_e2418[1] < 0f) {
                                        phi_4020_ = -(_e2418[1]);
                                    } else {
                                        phi_4020_ = _e2418[1];
                                    }
                                    let _e2429 = phi_4020_;
                                    if (_e2425 > _e2429) {
                                        phi_4025_ = _e2425;
                                    } else {
                                        phi_4025_ = _e2429;
                                    }
                                    let _e2432 = phi_4025_;
                                    if (_e2418[2] < 0f) {
                                        phi_4032_ = -(_e2418[2]);
                                    } else {
                                        phi_4032_ = _e2418[2];
                                    }
                                    let _e2436 = phi_4032_;
                                    if (_e2432 > _e2436) {
                                        phi_4037_ = _e2432;
                                    } else {
                                        phi_4037_ = _e2436;
                                    }
                                    let _e2439 = phi_4037_;
                                    let _e2442 = local_2.member_1[1u];
                                    if (_e2442[0] < 0f) {
                                        phi_4051_ = -(_e2442[0]);
                                    } else {
                                        phi_4051_ = _e2442[0];
                                    }
                                    let _e2449 = phi_4051_;
                                    if (_e2442[1] < 0f) {
                                        phi_4058_ = -(_e2442[1]);
                                    } else {
                                        phi_4058_ = _e2442[1];
                                    }
                                    let _e2453 = phi_4058_;
                                    if (_e2449 > _e2453) {
                                        phi_4063_ = _e2449;
                                    } else {
                                        phi_4063_ = _e2453;
                                    }
                                    let _e2456 = phi_4063_;
                                    if (_e2442[2] < 0f) {
                                        phi_4070_ = -(_e2442[2]);
                                    } else {
                                        phi_4070_ = _e2442[2];
                                    }
                                    let _e2460 = phi_4070_;
                                    if (_e2456 > _e2460) {
                                        phi_4075_ = _e2456;
                                    } else {
                                        phi_4075_ = _e2460;
                                    }
                                    let _e2463 = phi_4075_;
                                    if (_e2439 > _e2463) {
                                        phi_4080_ = _e2439;
                                    } else {
                                        phi_4080_ = _e2463;
                                    }
                                    let _e2466 = phi_4080_;
                                    let _e2468 = local_2.member_3;
                                    let _e2472 = local_2.member_2[0u];
                                    if (_e2472[0] < 0f) {
                                        phi_4097_ = -(_e2472[0]);
                                    } else {
                                        phi_4097_ = _e2472[0];
                                    }
                                    let _e2479 = phi_4097_;
                                    if (_e2472[1] < 0f) {
                                        phi_4104_ = -(_e2472[1]);
                                    } else {
                                        phi_4104_ = _e2472[1];
                                    }
                                    let _e2483 = phi_4104_;
                                    if (_e2479 > _e2483) {
                                        phi_4109_ = _e2479;
                                    } else {
                                        phi_4109_ = _e2483;
                                    }
                                    let _e2486 = phi_4109_;
                                    if (_e2472[2] < 0f) {
                                        phi_4116_ = -(_e2472[2]);
                                    } else {
                                        phi_4116_ = _e2472[2];
                                    }
                                    let _e2490 = phi_4116_;
                                    if (_e2486 > _e2490) {
                                        phi_4121_ = _e2486;
                                    } else {
                                        phi_4121_ = _e2490;
                                    }
                                    let _e2493 = phi_4121_;
                                    let _e2496 = local_2.member_2[1u];
                                    if (_e2496[0] < 0f) {
                                        phi_4135_ = -(_e2496[0]);
                                    } else {
                                        phi_4135_ = _e2496[0];
                                    }
                                    let _e2503 = phi_4135_;
                                    if (_e2496[1] < 0f) {
                                        phi_4142_ = -(_e2496[1]);
                                    } else {
                                        phi_4142_ = _e2496[1];
                                    }
                                    let _e2507 = phi_4142_;
                                    if (_e2503 > _e2507) {
                                        phi_4147_ = _e2503;
                                    } else {
                                        phi_4147_ = _e2507;
                                    }
                                    let _e2510 = phi_4147_;
                                    if (_e2496[2] < 0f) {
                                        phi_4154_ = -(_e2496[2]);
                                    } else {
                                        phi_4154_ = _e2496[2];
                                    }
                                    let _e2514 = phi_4154_;
                                    if (_e2510 > _e2514) {
                                        phi_4159_ = _e2510;
                                    } else {
                                        phi_4159_ = _e2514;
                                    }
                                    let _e2517 = phi_4159_;
                                    if (_e2493 > _e2517) {
                                        phi_4164_ = _e2493;
                                    } else {
                                        phi_4164_ = _e2517;
                                    }
                                    let _e2520 = phi_4164_;
                                    let _e2522 = local_2.member_3;
                                    let _e2526 = ((((_e2412 + _e2414) + (_e2466 + _e2468)) + (_e2520 + _e2522)) * 2f);
                                    let _e2529 = local_2.member_3;
                                    let _e2533 = (((_e91.member_5 * 1.0001f) + (_e2529 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e2536 = ((_e2294 * _e2273) - (_e2297 * _e2272));
                                    let _e2539 = ((_e2297 * _e2271) - (_e2291 * _e2273));
                                    let _e2542 = ((_e2291 * _e2272) - (_e2294 * _e2271));
                                    let _e2547 = (((_e2536 * _e2300[0]) + (_e2539 * _e2300[1])) + (_e2542 * _e2300[2]));
                                    let _e2552 = (((_e2536 * _e2317) + (_e2539 * _e2318)) + (_e2542 * _e2319));
                                    let _e2557 = (((_e2536 * _e2327) + (_e2539 * _e2328)) + (_e2542 * _e2329));
                                    let _e2565 = (((_e2536 * _e2326[0]) + (_e2539 * _e2326[1])) + (_e2542 * _e2326[2]));
                                    let _e2570 = (((_e2536 * _e2332[0]) + (_e2539 * _e2332[1])) + (_e2542 * _e2332[2]));
                                    let _e2575 = (((_e2536 * _e2349) + (_e2539 * _e2350)) + (_e2542 * _e2351));
                                    let _e2580 = (((_e2536 * _e2359) + (_e2539 * _e2360)) + (_e2542 * _e2361));
                                    let _e2588 = (((_e2536 * _e2358[0]) + (_e2539 * _e2358[1])) + (_e2542 * _e2358[2]));
                                    if (_e2547 < _e2552) {
                                        phi_4243_ = _e2547;
                                    } else {
                                        phi_4243_ = _e2552;
                                    }
                                    let _e2591 = phi_4243_;
                                    if (_e2557 < _e2565) {
                                        phi_4248_ = _e2557;
                                    } else {
                                        phi_4248_ = _e2565;
                                    }
                                    let _e2594 = phi_4248_;
                                    if (_e2591 < _e2594) {
                                        phi_4253_ = _e2591;
                                    } else {
                                        phi_4253_ = _e2594;
                                    }
                                    let _e2597 = phi_4253_;
                                    if (_e2570 < _e2575) {
                                        phi_4258_ = _e2570;
                                    } else {
                                        phi_4258_ = _e2575;
                                    }
                                    let _e2600 = phi_4258_;
                                    if (_e2580 < _e2588) {
                                        phi_4263_ = _e2580;
                                    } else {
                                        phi_4263_ = _e2588;
                                    }
                                    let _e2603 = phi_4263_;
                                    if (_e2600 < _e2603) {
                                        phi_4268_ = _e2600;
                                    } else {
                                        phi_4268_ = _e2603;
                                    }
                                    let _e2606 = phi_4268_;
                                    if (_e2597 < _e2606) {
                                        phi_4273_ = _e2597;
                                    } else {
                                        phi_4273_ = _e2606;
                                    }
                                    let _e2609 = phi_4273_;
                                    if (_e2547 > _e2552) {
                                        phi_4278_ = _e2547;
                                    } else {
                                        phi_4278_ = _e2552;
                                    }
                                    let _e2612 = phi_4278_;
                                    if (_e2557 > _e2565) {
                                        phi_4283_ = _e2557;
                                    } else {
                                        phi_4283_ = _e2565;
                                    }
                                    let _e2615 = phi_4283_;
                                    if (_e2612 > _e2615) {
                                        phi_4288_ = _e2612;
                                    } else {
                                        phi_4288_ = _e2615;
                                    }
                                    let _e2618 = phi_4288_;
                                    if (_e2570 > _e2575) {
                                        phi_4293_ = _e2570;
                                    } else {
                                        phi_4293_ = _e2575;
                                    }
                                    let _e2621 = phi_4293_;
                                    if (_e2580 > _e2588) {
                                        phi_4298_ = _e2580;
                                    } else {
                                        phi_4298_ = _e2588;
                                    }
                                    let _e2624 = phi_4298_;
                                    if (_e2621 > _e2624) {
                                        phi_4303_ = _e2621;
                                    } else {
                                        phi_4303_ = _e2624;
                                    }
                                    let _e2627 = phi_4303_;
                                    if (_e2618 > _e2627) {
                                        phi_4308_ = _e2618;
                                    } else {
                                        phi_4308_ = _e2627;
                                    }
                                    let _e2630 = phi_4308_;
                                    if (_e2536 < 0f) {
                                        phi_4314_ = -(_e2536);
                                    } else {
                                        phi_4314_ = _e2536;
                                    }
                                    let _e2634 = phi_4314_;
                                    if (_e2539 < 0f) {
                                        phi_4320_ = -(_e2539);
                                    } else {
                                        phi_4320_ = _e2539;
                                    }
                                    let _e2638 = phi_4320_;
                                    if (_e2542 < 0f) {
                                        phi_4327_ = -(_e2542);
                                    } else {
                                        phi_4327_ = _e2542;
                                    }
                                    let _e2643 = phi_4327_;
                                    let _e2644 = ((_e2634 + _e2638) + _e2643);
                                    let _e2649 = -(_e2630);
                                    if (_e2609 > _e2649) {
                                        phi_4338_ = _e2609;
                                    } else {
                                        phi_4338_ = _e2649;
                                    }
                                    let _e2652 = phi_4338_;
                                    let _e2657 = (((_e2652 - ((_e2644 * _e2526) * (0.000000059604645f * (17f / 2f)))) - (_e2644 * _e2533)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e2660 = ((_e2294 * _e2288) - (_e2297 * _e2287));
                                    let _e2663 = ((_e2297 * _e2286) - (_e2291 * _e2288));
                                    let _e2666 = ((_e2291 * _e2287) - (_e2294 * _e2286));
                                    let _e2671 = (((_e2660 * _e2300[0]) + (_e2663 * _e2300[1])) + (_e2666 * _e2300[2]));
                                    let _e2676 = (((_e2660 * _e2317) + (_e2663 * _e2318)) + (_e2666 * _e2319));
                                    let _e2681 = (((_e2660 * _e2327) + (_e2663 * _e2328)) + (_e2666 * _e2329));
                                    let _e2689 = (((_e2660 * _e2326[0]) + (_e2663 * _e2326[1])) + (_e2666 * _e2326[2]));
                                    let _e2694 = (((_e2660 * _e2332[0]) + (_e2663 * _e2332[1])) + (_e2666 * _e2332[2]));
                                    let _e2699 = (((_e2660 * _e2349) + (_e2663 * _e2350)) + (_e2666 * _e2351));
                                    let _e2704 = (((_e2660 * _e2359) + (_e2663 * _e2360)) + (_e2666 * _e2361));
                                    let _e2712 = (((_e2660 * _e2358[0]) + (_e2663 * _e2358[1])) + (_e2666 * _e2358[2]));
                                    if (_e2671 < _e2676) {
                                        phi_4409_ = _e2671;
                                    } else {
                                        phi_4409_ = _e2676;
                                    }
                                    let _e2715 = phi_4409_;
                                    if (_e2681 < _e2689) {
                                        phi_4414_ = _e2681;
                                    } else {
                                        phi_4414_ = _e2689;
                                    }
                                    let _e2718 = phi_4414_;
                                    if (_e2715 < _e2718) {
                                        phi_4419_ = _e2715;
                                    } else {
                                        phi_4419_ = _e2718;
                                    }
                                    let _e2721 = phi_4419_;
                                    if (_e2694 < _e2699) {
                                        phi_4424_ = _e2694;
                                    } else {
                                        phi_4424_ = _e2699;
                                    }
                                    let _e2724 = phi_4424_;
                                    if (_e2704 < _e2712) {
                                        phi_4429_ = _e2704;
                                    } else {
                                        phi_4429_ = _e2712;
                                    }
                                    let _e2727 = phi_4429_;
                                    if (_e2724 < _e2727) {
                                        phi_4434_ = _e2724;
                                    } else {
                                        phi_4434_ = _e2727;
                                    }
                                    let _e2730 = phi_4434_;
                                    if (_e2721 < _e2730) {
                                        phi_4439_ = _e2721;
                                    } else {
                                        phi_4439_ = _e2730;
                                    }
                                    let _e2733 = phi_4439_;
                                    if (_e2671 > _e2676) {
                                        phi_4444_ = _e2671;
                                    } else {
                                        phi_4444_ = _e2676;
                                    }
                                    let _e2736 = phi_4444_;
                                    if (_e2681 > _e2689) {
                                        phi_4449_ = _e2681;
                                    } else {
                                        phi_4449_ = _e2689;
                                    }
                                    let _e2739 = phi_4449_;
                                    if (_e2736 > _e2739) {
                                        phi_4454_ = _e2736;
                                    } else {
                                        phi_4454_ = _e2739;
                                    }
                                    let _e2742 = phi_4454_;
                                    if (_e2694 > _e2699) {
                                        phi_4459_ = _e2694;
                                    } else {
                                        phi_4459_ = _e2699;
                                    }
                                    let _e2745 = phi_4459_;
                                    if (_e2704 > _e2712) {
                                        phi_4464_ = _e2704;
                                    } else {
                                        phi_4464_ = _e2712;
                                    }
                                    let _e2748 = phi_4464_;
                                    if (_e2745 > _e2748) {
                                        phi_4469_ = _e2745;
                                    } else {
                                        phi_4469_ = _e2748;
                                    }
                                    let _e2751 = phi_4469_;
                                    if (_e2742 > _e2751) {
                                        phi_4474_ = _e2742;
                                    } else {
                                        phi_4474_ = _e2751;
                                    }
                                    let _e2754 = phi_4474_;
                                    if (_e2660 < 0f) {
                                        phi_4480_ = -(_e2660);
                                    } else {
                                        phi_4480_ = _e2660;
                                    }
                                    let _e2758 = phi_4480_;
                                    if (_e2663 < 0f) {
                                        phi_4486_ = -(_e2663);
                                    } else {
                                        phi_4486_ = _e2663;
                                    }
                                    let _e2762 = phi_4486_;
                                    if (_e2666 < 0f) {
                                        phi_4493_ = -(_e2666);
                                    } else {
                                        phi_4493_ = _e2666;
                                    }
                                    let _e2767 = phi_4493_;
                                    let _e2768 = ((_e2758 + _e2762) + _e2767);
                                    let _e2773 = -(_e2754);
                                    if (_e2733 > _e2773) {
                                        phi_4504_ = _e2733;
                                    } else {
                                        phi_4504_ = _e2773;
                                    }
                                    let _e2776 = phi_4504_;
                                    let _e2781 = (((_e2776 - ((_e2768 * _e2526) * (0.000000059604645f * (17f / 2f)))) - (_e2768 * _e2533)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e2657 > _e2781) {
                                        phi_4514_ = _e2657;
                                    } else {
                                        phi_4514_ = _e2781;
                                    }
                                    let _e2784 = phi_4514_;
                                    if (_e1662.member == 0u) {
                                        let _e2786 = (_e2286 - _e2271);
                                        let _e2787 = (_e2287 - _e2272);
                                        let _e2788 = (_e2288 - _e2273);
                                        let _e2791 = ((_e2294 * _e2788) - (_e2297 * _e2787));
                                        let _e2794 = ((_e2297 * _e2786) - (_e2291 * _e2788));
                                        let _e2797 = ((_e2291 * _e2787) - (_e2294 * _e2786));
                                        let _e2802 = (((_e2791 * _e2300[0]) + (_e2794 * _e2300[1])) + (_e2797 * _e2300[2]));
                                        let _e2807 = (((_e2791 * _e2317) + (_e2794 * _e2318)) + (_e2797 * _e2319));
                                        let _e2812 = (((_e2791 * _e2327) + (_e2794 * _e2328)) + (_e2797 * _e2329));
                                        let _e2820 = (((_e2791 * _e2326[0]) + (_e2794 * _e2326[1])) + (_e2797 * _e2326[2]));
                                        let _e2825 = (((_e2791 * _e2332[0]) + (_e2794 * _e2332[1])) + (_e2797 * _e2332[2]));
                                        let _e2830 = (((_e2791 * _e2349) + (_e2794 * _e2350)) + (_e2797 * _e2351));
                                        let _e2835 = (((_e2791 * _e2359) + (_e2794 * _e2360)) + (_e2797 * _e2361));
                                        let _e2843 = (((_e2791 * _e2358[0]) + (_e2794 * _e2358[1])) + (_e2797 * _e2358[2]));
                                        if (_e2802 < _e2807) {
                                            phi_4587_ = _e2802;
                                        } else {
                                            phi_4587_ = _e2807;
                                        }
                                        let _e2846 = phi_4587_;
                                        if (_e2812 < _e2820) {
                                            phi_4592_ = _e2812;
                                        } else {
                                            phi_4592_ = _e2820;
                                        }
                                        let _e2849 = phi_4592_;
                                        if (_e2846 < _e2849) {
                                            phi_4597_ = _e2846;
                                        } else {
                                            phi_4597_ = _e2849;
                                        }
                                        let _e2852 = phi_4597_;
                                        if (_e2825 < _e2830) {
                                            phi_4602_ = _e2825;
                                        } else {
                                            phi_4602_ = _e2830;
                                        }
                                        let _e2855 = phi_4602_;
                                        if (_e2835 < _e2843) {
                                            phi_4607_ = _e2835;
                                        } else {
                                            phi_4607_ = _e2843;
                                        }
                                        let _e2858 = phi_4607_;
                                        if (_e2855 < _e2858) {
                                            phi_4612_ = _e2855;
                                        } else {
                                            phi_4612_ = _e2858;
                                        }
                                        let _e2861 = phi_4612_;
                                        if (_e2852 < _e2861) {
                                            phi_4617_ = _e2852;
                                        } else {
                                            phi_4617_ = _e2861;
                                        }
                                        let _e2864 = phi_4617_;
                                        if (_e2802 > _e2807) {
                                            phi_4622_ = _e2802;
                                        } else {
                                            phi_4622_ = _e2807;
                                        }
                                        let _e2867 = phi_4622_;
                                        if (_e2812 > _e2820) {
                                            phi_4627_ = _e2812;
                                        } else {
                                            phi_4627_ = _e2820;
                                        }
                                        let _e2870 = phi_4627_;
                                        if (_e2867 > _e2870) {
                                            phi_4632_ = _e2867;
                                        } else {
                                            phi_4632_ = _e2870;
                                        }
                                        let _e2873 = phi_4632_;
                                        if (_e2825 > _e2830) {
                                            phi_4637_ = _e2825;
                                        } else {
                                            phi_4637_ = _e2830;
                                        }
                                        let _e2876 = phi_4637_;
                                        if (_e2835 > _e2843) {
                                            phi_4642_ = _e2835;
                                        } else {
                                            phi_4642_ = _e2843;
                                        }
                                        let _e2879 = phi_4642_;
                                        if (_e2876 > _e2879) {
                                            phi_4647_ = _e2876;
                                        } else {
                                            phi_4647_ = _e2879;
                                        }
                                        let _e2882 = phi_4647_;
                                        if (_e2873 > _e2882) {
                                            phi_4652_ = _e2873;
                                        } else {
                                            phi_4652_ = _e2882;
                                        }
                                        let _e2885 = phi_4652_;
                                        if (_e2791 < 0f) {
                                            phi_4658_ = -(_e2791);
                                        } else {
                                            phi_4658_ = _e2791;
                                        }
                                        let _e2889 = phi_4658_;
                                        if (_e2794 < 0f) {
                                            phi_4664_ = -(_e2794);
                                        } else {
                                            phi_4664_ = _e2794;
                                        }
                                        let _e2893 = phi_4664_;
                                        if (_e2797 < 0f) {
                                            phi_4671_ = -(_e2797);
                                        } else {
                                            phi_4671_ = _e2797;
                                        }
                                        let _e2898 = phi_4671_;
                                        let _e2899 = ((_e2889 + _e2893) + _e2898);
                                        let _e2904 = -(_e2885);
                                        if (_e2864 > _e2904) {
                                            phi_4682_ = _e2864;
                                        } else {
                                            phi_4682_ = _e2904;
                                        }
                                        let _e2907 = phi_4682_;
                                        let _e2912 = (((_e2907 - ((_e2899 * _e2526) * (0.000000059604645f * (17f / 2f)))) - (_e2899 * _e2533)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e2784 > _e2912) {
                                            phi_4692_ = _e2784;
                                        } else {
                                            phi_4692_ = _e2912;
                                        }
                                        let _e2915 = phi_4692_;
                                        phi_4693_ = _e2915;
                                    } else {
                                        phi_4693_ = _e2784;
                                    }
                                    let _e2917 = phi_4693_;
                                    phi_4696_ = (_e2258 || (_e2917 > 0f));
                                }
                                let _e2921 = phi_4696_;
                                if !(_e2921) {
                                    let _e2924 = atomicAdd((&counters[6u]), 1u);
                                    hits[_e2924] = _e1629;
                                }
                                phi_4704_ = true;
                            }
                            let _e2927 = phi_4704_;
                            phi_4705_ = _e2927;
                        } else {
                            phi_4705_ = false;
                        }
                        let _e2929 = phi_4705_;
                        continue;
                        continuing {
                            phi_2829_ = _e1618;
                            break if !(_e2929);
                        }
                    }
                    workgroupBarrier();
                    let _e2932 = atomicLoad((&counters[6u]));
                    phi_4710_ = type_9(0u, 4u);
                    loop {
                        let _e2934 = phi_4710_;
                        if (_e2934.member < _e2934.member_1) {
                            phi_4711_ = type_9((_e2934.member + 1u), _e2934.member_1);
                            phi_4734_ = type_9(1u, _e2934.member);
                        } else {
                            phi_4711_ = _e2934;
                            phi_4734_ = type_9(0u, type_9().member_1);
                        }
                        let _e2946 = phi_4711_;
                        let _e2948 = phi_4734_;
                        if (bitcast<i32>(_e2948.member) != 0i) {
                            let _e2954 = (_e73 + (_e2948.member_1 * 128u));
                            if (_e2954 >= _e2932) {
                                phi_8292_ = false;
                            } else {
                                let _e2957 = hits[_e2954];
                                let _e2960 = ((_e2957 >> bitcast<u32>(10i)) & 3u);
                                let _e2967 = firsts[(2u * _e2960)];
                                let _e2972 = firsts[((2u * _e2960) + 1u)];
                                let _e2975 = leaves.member[(_e2967 + ((_e2957 >> bitcast<u32>(5i)) & 31u))];
                                let _e2980 = leaves.member[(_e2972 + (_e2957 & 31u))];
                                if (_e2975.w < _e2980.w) {
                                    phi_4805_ = type_43(1u, array<u32, 4>(_e2975.x, _e2975.y, _e2980.x, _e2980.y));
                                } else {
                                    phi_4805_ = type_43(1u, array<u32, 4>(_e2980.x, _e2980.y, _e2975.x, _e2975.y));
                                }
                                let _e2990 = phi_4805_;
                                let _e2995 = paths.member[_e2990.member_1[0]];
                                let _e3010 = paths.member[_e2990.member_1[1]];
                                let _e3025 = paths.member[_e2990.member_1[2]];
                                let _e3040 = paths.member[_e2990.member_1[3]];
                                if (_e2990.member != 0u) {
                                    phi_4939_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e3025.member.x - _e2995.member.x), (_e3025.member.y - _e2995.member.y), (_e3025.member.z - _e2995.member.z)), array<f32, 3>((_e3025.member_1.x - _e2995.member_1.x), (_e3025.member_1.y - _e2995.member_1.y), (_e3025.member_1.z - _e2995.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e3010.member.x - _e2995.member.x), (_e3010.member.y - _e2995.member.y), (_e3010.member.z - _e2995.member.z)), array<f32, 3>((_e3010.member_1.x - _e2995.member_1.x), (_e3010.member_1.y - _e2995.member_1.y), (_e3010.member_1.z - _e2995.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e3025.member.x - _e3040.member.x), (_e3025.member.y - _e3040.member.y), (_e3025.member.z - _e3040.member.z)), array<f32, 3>((_e3025.member_1.x - _e3040.member_1.x), (_e3025.member_1.y - _e3040.member_1.y), (_e3025.member_1.z - _e3040.member_1.z))), (_e91.member_4 + _e91.member_4));
                                } else {
                                    phi_4939_ = type_39(array<array<f32, 3>, 2>(array<f32, 3>((_e2995.member.x - _e3010.member.x), (_e2995.member.y - _e3010.member.y), (_e2995.member.z - _e3010.member.z)), array<f32, 3>((_e2995.member_1.x - _e3010.member_1.x), (_e2995.member_1.y - _e3010.member_1.y), (_e2995.member_1.z - _e3010.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e3025.member.x - _e3010.member.x), (_e3025.member.y - _e3010.member.y), (_e3025.member.z - _e3010.member.z)), array<f32, 3>((_e3025.member_1.x - _e3010.member_1.x), (_e3025.member_1.y - _e3010.member_1.y), (_e3025.member_1.z - _e3010.member_1.z))), array<array<f32, 3>, 2>(array<f32, 3>((_e3040.member.x - _e3010.member.x), (_e3040.member.y - _e3010.member.y), (_e3040.member.z - _e3010.member.z)), array<f32, 3>((_e3040.member_1.x - _e3010.member_1.x), (_e3040.member_1.y - _e3010.member_1.y), (_e3040.member_1.z - _e3010.member_1.z))), (_e91.member_4 + _e91.member_4));
                                }
                                let _e3113 = phi_4939_;
                                let _e3127 = ((_e3113.member[0][0] + _e3113.member[1][0]) * 0.5f);
                                let _e3128 = ((_e3113.member[0][1] + _e3113.member[1][1]) * 0.5f);
                                let _e3129 = ((_e3113.member[0][2] + _e3113.member[1][2]) * 0.5f);
                                let _e3143 = ((_e3113.member_1[0][0] + _e3113.member_1[1][0]) * 0.5f);
                                let _e3144 = ((_e3113.member_1[0][1] + _e3113.member_1[1][1]) * 0.5f);
                                let _e3145 = ((_e3113.member_1[0][2] + _e3113.member_1[1][2]) * 0.5f);
                                let _e3159 = ((_e3113.member_2[0][0] + _e3113.member_2[1][0]) * 0.5f);
                                let _e3160 = ((_e3113.member_2[0][1] + _e3113.member_2[1][1]) * 0.5f);
                                let _e3161 = ((_e3113.member_2[0][2] + _e3113.member_2[1][2]) * 0.5f);
                                local = type_39(array<array<f32, 3>, 2>(array<f32, 3>(_e3113.member[0][0], _e3113.member[0][1], _e3113.member[0][2]), array<f32, 3>(_e3127, _e3128, _e3129)), array<array<f32, 3>, 2>(array<f32, 3>(_e3113.member_1[0][0], _e3113.member_1[0][1], _e3113.member_1[0][2]), array<f32, 3>(_e3143, _e3144, _e3145)), array<array<f32, 3>, 2>(array<f32, 3>(_e3113.member_2[0][0], _e3113.member_2[0][1], _e3113.member_2[0][2]), array<f32, 3>(_e3159, _e3160, _e3161)), _e3113.member_3);
                                local_1 = type_39(array<array<f32, 3>, 2>(array<f32, 3>(_e3127, _e3128, _e3129), array<f32, 3>(_e3113.member[1][0], _e3113.member[1][1], _e3113.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e3143, _e3144, _e3145), array<f32, 3>(_e3113.member_1[1][0], _e3113.member_1[1][1], _e3113.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e3159, _e3160, _e3161), array<f32, 3>(_e3113.member_2[1][0], _e3113.member_2[1][1], _e3113.member_2[1][2])), _e3113.member_3);
                                let _e3216 = local.member_1[0u];
                                let _e3222 = local.member_2[0u];
                                let _e3228 = ((_e3216[1] * _e3222[2]) - (_e3216[2] * _e3222[1]));
                                let _e3231 = ((_e3216[2] * _e3222[0]) - (_e3216[0] * _e3222[2]));
                                let _e3234 = ((_e3216[0] * _e3222[1]) - (_e3216[1] * _e3222[0]));
                                let _e3237 = local.member_1[1u];
                                let _e3243 = local.member_2[1u];
                                let _e3249 = ((_e3237[1] * _e3243[2]) - (_e3237[2] * _e3243[1]));
                                let _e3252 = ((_e3237[2] * _e3243[0]) - (_e3237[0] * _e3243[2]));
                                let _e3255 = ((_e3237[0] * _e3243[1]) - (_e3237[1] * _e3243[0]));
                                let _e3258 = local.member_1[0u];
                                let _e3264 = local.member_2[1u];
                                let _e3279 = local.member_1[1u];
                                let _e3285 = local.member_2[0u];
                                let _e3298 = (((_e3258[1] * _e3264[2]) - (_e3258[2] * _e3264[1])) + ((_e3279[1] * _e3285[2]) - (_e3279[2] * _e3285[1])));
                                let _e3299 = (((_e3258[2] * _e3264[0]) - (_e3258[0] * _e3264[2])) + ((_e3279[2] * _e3285[0]) - (_e3279[0] * _e3285[2])));
                                let _e3300 = (((_e3258[0] * _e3264[1]) - (_e3258[1] * _e3264[0])) + ((_e3279[0] * _e3285[1]) - (_e3279[1] * _e3285[0])));
                                let _e3303 = local.member[0u];
                                let _e3314 = local.member[1u];
                                let _e3325 = local.member[0u];
                                let _e3334 = ((((_e3314[0] * _e3228) + (_e3314[1] * _e3231)) + (_e3314[2] * _e3234)) + (((_e3325[0] * _e3298) + (_e3325[1] * _e3299)) + (_e3325[2] * _e3300)));
                                let _e3337 = local.member[0u];
                                let _e3348 = local.member[1u];
                                let _e3357 = ((((_e3337[0] * _e3249) + (_e3337[1] * _e3252)) + (_e3337[2] * _e3255)) + (((_e3348[0] * _e3298) + (_e3348[1] * _e3299)) + (_e3348[2] * _e3300)));
                                let _e3360 = local.member[1u];
                                let _e3371 = local.member[0u];
                                if (_e3371[0] < 0f) {
                                    phi_5318_ = -(_e3371[0]);
                                } else {
                                    phi_5318_ = _e3371[0];
                                }
                                let _e3378 = phi_5318_;
                                if (_e3371[1] < 0f) {
                                    phi_5325_ = -(_e3371[1]);
                                } else {
                                    phi_5325_ = _e3371[1];
                                }
                                let _e3382 = phi_5325_;
                                if (_e3378 > _e3382) {
                                    phi_5330_ = _e3378;
                                } else {
                                    phi_5330_ = _e3382;
                                }
                                let _e3385 = phi_5330_;
                                if (_e3371[2] < 0f) {
                                    phi_5337_ = -(_e3371[2]);
                                } else {
                                    phi_5337_ = _e3371[2];
                                }
                                let _e3389 = phi_5337_;
                                if (_e3385 > _e3389) {
                                    phi_5342_ = _e3385;
                                } else {
                                    phi_5342_ = _e3389;
                                }
                                let _e3392 = phi_5342_;
                                let _e3395 = local.member[1u];
                                if (_e3395[0] < 0f) {
                                    phi_5355_ = -(_e3395[0]);
                                } else {
                                    phi_5355_ = _e3395[0];
                                }
                                let _e3402 = phi_5355_;
                                if (_e3395[1] < 0f) {
                                    phi_5362_ = -(_e3395[1]);
                                } else {
                                    phi_5362_ = _e3395[1];
                                }
                                let _e3406 = phi_5362_;
                                if (_e3402 > _e3406) {
                                    phi_5367_ = _e3402;
                                } else {
                                    phi_5367_ = _e3406;
                                }
                                let _e3409 = phi_5367_;
                                if (_e3395[2] < 0f) {
                                    phi_5374_ = -(_e3395[2]);
                                } else {
                                    phi_5374_ = _e3395[2];
                                }
                                let _e3413 = phi_5374_;
                                if (_e3409 > _e3413) {
                                    phi_5379_ = _e3409;
                                } else {
                                    phi_5379_ = _e3413;
                                }
                                let _e3416 = phi_5379_;
                                if (_e3392 > _e3416) {
                                    phi_5384_ = _e3392;
                                } else {
                                    phi_5384_ = _e3416;
                                }
                                let _e3419 = phi_5384_;
                                let _e3421 = local.member_3;
                                let _e3422 = (_e3419 + _e3421);
                                let _e3425 = local.member_1[0u];
                                if (_e3425[0] < 0f) {
                                    phi_5401_ = -(_e3425[0]);
                                } else {
                                    phi_5401_ = _e3425[0];
                                }
                                let _e3432 = phi_5401_;
                                if (_e3425[1] < 0f) {
                                    phi_5408_ = -(_e3425[1]);
                                } else {
                                    phi_5408_ = _e3425[1];
                                }
                                let _e3436 = phi_5408_;
                                if (_e3432 > _e3436) {
                                    phi_5413_ = _e3432;
                                } else {
                                    phi_5413_ = _e3436;
                                }
                                let _e3439 = phi_5413_;
                                if (_e3425[2] < 0f) {
                                    phi_5420_ = -(_e3425[2]);
                                } else {
                                    phi_5420_ = _e3425[2];
                                }
                                let _e3443 = phi_5420_;
                                if (_e3439 > _e3443) {
                                    phi_5425_ = _e3439;
                                } else {
                                    phi_5425_ = _e3443;
                                }
                                let _e3446 = phi_5425_;
                                let _e3449 = local.member_1[1u];
                                if (_e3449[0] < 0f) {
                                    phi_5439_ = -(_e3449[0]);
                                } else {
                                    phi_5439_ = _e3449[0];
                                }
                                let _e3456 = phi_5439_;
                                if (_e3449[1] < 0f) {
                                    phi_5446_ = -(_e3449[1]);
                                } else {
                                    phi_5446_ = _e3449[1];
                                }
                                let _e3460 = phi_5446_;
                                if (_e3456 > _e3460) {
                                    phi_5451_ = _e3456;
                                } else {
                                    phi_5451_ = _e3460;
                                }
                                let _e3463 = phi_5451_;
                                if (_e3449[2] < 0f) {
                                    phi_5458_ = -(_e3449[2]);
                                } else {
                                    phi_5458_ = _e3449[2];
                                }
                                let _e3467 = phi_5458_;
                                if (_e3463 > _e3467) {
                                    phi_5463_ = _e3463;
                                } else {
                                    phi_5463_ = _e3467;
                                }
                                let _e3470 = phi_5463_;
                                if (_e3446 > _e3470) {
                                    phi_5468_ = _e3446;
                                } else {
                                    phi_5468_ = _e3470;
                                }
                                let _e3473 = phi_5468_;
                                let _e3475 = local.member_3;
                                let _e3476 = (_e3473 + _e3475);
                                let _e3479 = local.member_2[0u];
                                if (_e3479[0] < 0f) {
                                    phi_5485_ = -(_e3479[0]);
                                } else {
                                    phi_5485_ = _e3479[0];
                                }
                                let _e3486 = phi_5485_;
                                if (_e3479[1] < 0f) {
                                    phi_5492_ = -(_e3479[1]);
                                } else {
                                    phi_5492_ = _e3479[1];
                                }
                                let _e3490 = phi_5492_;
                                if (_e3486 > _e3490) {
                                    phi_5497_ = _e3486;
                                } else {
                                    phi_5497_ = _e3490;
                                }
                                let _e3493 = phi_5497_;
                                if (_e3479[2] < 0f) {
                                    phi_5504_ = -(_e3479[2]);
                                } else {
                                    phi_5504_ = _e3479[2];
                                }
                                let _e3497 = phi_5504_;
                                if (_e3493 > _e3497) {
                                    phi_5509_ = _e3493;
                                } else {
                                    phi_5509_ = _e3497;
                                }
                                let _e3500 = phi_5509_;
                                let _e3503 = local.member_2[1u];
                                if (_e3503[0] < 0f) {
                                    phi_5523_ = -(_e3503[0]);
                                } else {
                                    phi_5523_ = _e3503[0];
                                }
                                let _e3510 = phi_5523_;
                                if (_e3503[1] < 0f) {
                                    phi_5530_ = -(_e3503[1]);
                                } else {
                                    phi_5530_ = _e3503[1];
                                }
                                let _e3514 = phi_5530_;
                                if (_e3510 > _e3514) {
                                    phi_5535_ = _e3510;
                                } else {
                                    phi_5535_ = _e3514;
                                }
                                let _e3517 = phi_5535_;
                                if (_e3503[2] < 0f) {
                                    phi_5542_ = -(_e3503[2]);
                                } else {
                                    phi_5542_ = _e3503[2];
                                }
                                let _e3521 = phi_5542_;
                                if (_e3517 > _e3521) {
                                    phi_5547_ = _e3517;
                                } else {
                                    phi_5547_ = _e3521;
                                }
                                let _e3524 = phi_5547_;
                                if (_e3500 > _e3524) {
                                    phi_5552_ = _e3500;
                                } else {
                                    phi_5552_ = _e3524;
                                }
                                let _e3527 = phi_5552_;
                                let _e3529 = local.member_3;
                                let _e3530 = (_e3527 + _e3529);
                                let _e3532 = ((_e3476 * 8f) * _e3530);
                                let _e3539 = local.member_3;
                                if (_e3228 < 0f) {
                                    phi_5583_ = -(_e3228);
                                } else {
                                    phi_5583_ = _e3228;
                                }
                                let _e3556 = phi_5583_;
                                if (_e3231 < 0f) {
                                    phi_5589_ = -(_e3231);
                                } else {
                                    phi_5589_ = _e3231;
                                }
                                let _e3560 = phi_5589_;
                                if (_e3234 < 0f) {
                                    phi_5596_ = -(_e3234);
                                } else {
                                    phi_5596_ = _e3234;
                                }
                                let _e3565 = phi_5596_;
                                let _e3566 = ((_e3556 + _e3560) + _e3565);
                                if (_e3249 < 0f) {
                                    phi_5603_ = -(_e3249);
                                } else {
                                    phi_5603_ = _e3249;
                                }
                                let _e3570 = phi_5603_;
                                if (_e3252 < 0f) {
                                    phi_5609_ = -(_e3252);
                                } else {
                                    phi_5609_ = _e3252;
                                }
                                let _e3574 = phi_5609_;
                                if (_e3255 < 0f) {
                                    phi_5616_ = -(_e3255);
                                } else {
                                    phi_5616_ = _e3255;
                                }
                                let _e3579 = phi_5616_;
                                let _e3580 = ((_e3570 + _e3574) + _e3579);
                                if (_e3566 > _e3580) {
                                    phi_5622_ = _e3566;
                                } else {
                                    phi_5622_ = _e3580;
                                }
                                let _e3583 = phi_5622_;
                                if (_e3298 < 0f) {
                                    phi_5628_ = -(_e3298);
                                } else {
                                    phi_5628_ = _e3298;
                                }
                                let _e3587 = phi_5628_;
                                if (_e3299 < 0f) {
                                    phi_5634_ = -(_e3299);
                                } else {
                                    phi_5634_ = _e3299;
                                }
                                let _e3591 = phi_5634_;
                                if (_e3300 < 0f) {
                                    phi_5641_ = -(_e3300);
                                } else {
                                    phi_5641_ = _e3300;
                                }
                                let _e3596 = phi_5641_;
                                let _e3598 = (((_e3587 + _e3591) + _e3596) * 0.5f);
                                if (_e3583 > _e3598) {
                                    phi_5648_ = _e3583;
                                } else {
                                    phi_5648_ = _e3598;
                                }
                                let _e3601 = phi_5648_;
                                let _e3606 = local.member_3;
                                let _e3619 = ((((_e3303[0] * _e3228) + (_e3303[1] * _e3231)) + (_e3303[2] * _e3234)) * 3f);
                                let _e3620 = ((((_e3360[0] * _e3249) + (_e3360[1] * _e3252)) + (_e3360[2] * _e3255)) * 3f);
                                if (_e3619 < _e3620) {
                                    phi_5672_ = _e3619;
                                } else {
                                    phi_5672_ = _e3620;
                                }
                                let _e3623 = phi_5672_;
                                if (_e3334 < _e3357) {
                                    phi_5677_ = _e3334;
                                } else {
                                    phi_5677_ = _e3357;
                                }
                                let _e3626 = phi_5677_;
                                if (_e3623 < _e3626) {
                                    phi_5682_ = _e3623;
                                } else {
                                    phi_5682_ = _e3626;
                                }
                                let _e3629 = phi_5682_;
                                if (_e3619 > _e3620) {
                                    phi_5687_ = _e3619;
                                } else {
                                    phi_5687_ = _e3620;
                                }
                                let _e3632 = phi_5687_;
                                if (_e3334 > _e3357) {
                                    phi_5692_ = _e3334;
                                } else {
                                    phi_5692_ = _e3357;
                                }
                                let _e3635 = phi_5692_;
                                if (_e3632 > _e3635) {
                                    phi_5697_ = _e3632;
                                } else {
                                    phi_5697_ = _e3635;
                                }
                                let _e3638 = phi_5697_;
                                let _e3643 = -(_e3638);
                                if (_e3629 > _e3643) {
                                    phi_5707_ = _e3629;
                                } else {
                                    phi_5707_ = _e3643;
                                }
                                let _e3646 = phi_5707_;
                                let _e3648 = ((_e3646 - ((((((_e3422 * 8f) * _e3532) * (0.000000059604645f * (524f / 64f))) + ((_e3539 * 19f) * ((_e3422 * (_e3476 + _e3530)) + (_e3476 * _e3530)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3422) * ((1f + _e3476) * (1f + _e3530))))) + ((_e91.member_5 * (((_e3601 + (_e3532 * (0.000000059604645f * 8f))) + ((_e3606 * 6f) * (_e3476 + _e3530))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3476) * (1f + _e3530))))) * (3f * 1.0001f)))) > 0f);
                                if _e3648 {
                                    phi_6676_ = _e3648;
                                } else {
                                    let _e3651 = local.member_1[0u];
                                    let _e3657 = local.member_1[1u];
                                    let _e3661 = (_e3651[0] + _e3657[0]);
                                    let _e3662 = (_e3651[1] + _e3657[1]);
                                    let _e3663 = (_e3651[2] + _e3657[2]);
                                    let _e3666 = local.member_2[0u];
                                    let _e3672 = local.member_2[1u];
                                    let _e3676 = (_e3666[0] + _e3672[0]);
                                    let _e3677 = (_e3666[1] + _e3672[1]);
                                    let _e3678 = (_e3666[2] + _e3672[2]);
                                    let _e3681 = ((_e3662 * _e3678) - (_e3663 * _e3677));
                                    let _e3684 = ((_e3663 * _e3676) - (_e3661 * _e3678));
                                    let _e3687 = ((_e3661 * _e3677) - (_e3662 * _e3676));
                                    let _e3690 = local.member[0u];
                                    let _e3697 = local.member_1[0u];
                                    let _e3703 = local.member_2[0u];
                                    let _e3707 = (_e3690[0] - _e3697[0]);
                                    let _e3708 = (_e3690[1] - _e3697[1]);
                                    let _e3709 = (_e3690[2] - _e3697[2]);
                                    if (_e2990.member == 0u) {
                                        phi_5823_ = array<f32, 3>(_e3690[0], _e3690[1], _e3690[2]);
                                    } else {
                                        phi_5823_ = array<f32, 3>((_e3707 - _e3703[0]), (_e3708 - _e3703[1]), (_e3709 - _e3703[2]));
                                    }
                                    let _e3716 = phi_5823_;
                                    let _e3717 = (_e3690[0] - _e3703[0]);
                                    let _e3718 = (_e3690[1] - _e3703[1]);
                                    let _e3719 = (_e3690[2] - _e3703[2]);
                                    let _e3722 = local.member[1u];
                                    let _e3729 = local.member_1[1u];
                                    let _e3735 = local.member_2[1u];
                                    let _e3739 = (_e3722[0] - _e3729[0]);
                                    let _e3740 = (_e3722[1] - _e3729[1]);
                                    let _e3741 = (_e3722[2] - _e3729[2]);
                                    if (_e2990.member == 0u) {
                                        phi_5888_ = array<f32, 3>(_e3722[0], _e3722[1], _e3722[2]);
                                    } else {
                                        phi_5888_ = array<f32, 3>((_e3739 - _e3735[0]), (_e3740 - _e3735[1]), (_e3741 - _e3735[2]));
                                    }
                                    let _e3748 = phi_5888_;
                                    let _e3749 = (_e3722[0] - _e3735[0]);
                                    let _e3750 = (_e3722[1] - _e3735[1]);
                                    let _e3751 = (_e3722[2] - _e3735[2]);
                                    let _e3754 = local.member[0u];
                                    if (_e3754[0] < 0f) {
                                        phi_5910_ = -(_e3754[0]);
                                    } else {
                                        phi_5910_ = _e3754[0];
                                    }
                                    let _e3761 = phi_5910_;
                                    if (_e3754[1] < 0f) {
                                        phi_5917_ = -(_e3754[1]);
                                    } else {
                                        phi_5917_ = _e3754[1];
                                    }
                                    let _e3765 = phi_5917_;
                                    if (_e3761 > _e3765) {
                                        phi_5922_ = _e3761;
                                    } else {
                                        phi_5922_ = _e3765;
                                    }
                                    let _e3768 = phi_5922_;
                                    if (_e3754[2] < 0f) {
                                        phi_5929_ = -(_e3754[2]);
                                    } else {
                                        phi_5929_ = _e3754[2];
                                    }
                                    let _e3772 = phi_5929_;
                                    if (_e3768 > _e3772) {
                                        phi_5934_ = _e3768;
                                    } else {
                                        phi_5934_ = _e3772;
                                    }
                                    let _e3775 = phi_5934_;
                                    let _e3778 = local.member[1u];
                                    if (_e3778[0] < 0f) {
                                        phi_5947_ = -(_e3778[0]);
                                    } else {
                                        phi_5947_ = _e3778[0];
                                    }
                                    let _e3785 = phi_5947_;
                                    if (_e3778[1] < 0f) {
                                        phi_5954_ = -(_e3778[1]);
                                    } else {
                                        phi_5954_ = _e3778[1];
                                    }
                                    let _e3789 = phi_5954_;
                                    if (_e3785 > _e3789) {
                                        phi_5959_ = _e3785;
                                    } else {
                                        phi_5959_ = _e3789;
                                    }
                                    let _e3792 = phi_5959_;
                                    if (_e3778[2] < 0f) {
                                        phi_5966_ = -(_e3778[2]);
                                    } else {
                                        phi_5966_ = _e3778[2];
                                    }
                                    let _e3796 = phi_5966_;
                                    if (_e3792 > _e3796) {
                                        phi_5971_ = _e3792;
                                    } else {
                                        phi_5971_ = _e3796;
                                    }
                                    let _e3799 = phi_5971_;
                                    if (_e3775 > _e3799) {
                                        phi_5976_ = _e3775;
                                    } else {
                                        phi_5976_ = _e3799;
                                    }
                                    let _e3802 = phi_5976_;
                                    let _e3804 = local.member_3;
                                    let _e3808 = local.member_1[0u];
                                    if (_e3808[0] < 0f) {
                                        phi_5993_ = -(_e3808[0]);
                                    } else {
                                        phi_5993_ = _e3808[0];
                                    }
                                    let _e3815 = phi_5993_;
                                    if (_e3808[1] < 0f) {
                                        phi_6000_ = -(_e3808[1]);
                                    } else {
                                        phi_6000_ = _e3808[1];
                                    }
                                    let _e3819 = phi_6000_;
                                    if (_e3815 > _e3819) {
                                        phi_6005_ = _e3815;
                                    } else {
                                        phi_6005_ = _e3819;
                                    }
                                    let _e3822 = phi_6005_;
                                    if (_e3808[2] < 0f) {
                                        phi_6012_ = -(_e3808[2]);
                                    } else {
                                        phi_6012_ = _e3808[2];
                                    }
                                    let _e3826 = phi_6012_;
                                    if (_e3822 > _e3826) {
                                        phi_6017_ = _e3822;
                                    } else {
                                        phi_6017_ = _e3826;
                                    }
                                    let _e3829 = phi_6017_;
                                    let _e3832 = local.member_1[1u];
                                    if (_e3832[0] < 0f) {
                                        phi_6031_ = -(_e3832[0]);
                                    } else {
                                        phi_6031_ = _e3832[0];
                                    }
                                    let _e3839 = phi_6031_;
                                    if (_e3832[1] < 0f) {
                                        phi_6038_ = -(_e3832[1]);
                                    } else {
                                        phi_6038_ = _e3832[1];
                                    }
                                    let _e3843 = phi_6038_;
                                    if (_e3839 > _e3843) {
                                        phi_6043_ = _e3839;
                                    } else {
                                        phi_6043_ = _e3843;
                                    }
                                    let _e3846 = phi_6043_;
                                    if (_e3832[2] < 0f) {
                                        phi_6050_ = -(_e3832[2]);
                                    } else {
                                        phi_6050_ = _e3832[2];
                                    }
                                    let _e3850 = phi_6050_;
                                    if (_e3846 > _e3850) {
                                        phi_6055_ = _e3846;
                                    } else {
                                        phi_6055_ = _e3850;
                                    }
                                    let _e3853 = phi_6055_;
                                    if (_e3829 > _e3853) {
                                        phi_6060_ = _e3829;
                                    } else {
                                        phi_6060_ = _e3853;
                                    }
                                    let _e3856 = phi_6060_;
                                    let _e3858 = local.member_3;
                                    let _e3862 = local.member_2[0u];
                                    if (_e3862[0] < 0f) {
                                        phi_6077_ = -(_e3862[0]);
                                    } else {
                                        phi_6077_ = _e3862[0];
                                    }
                                    let _e3869 = phi_6077_;
                                    if (_e3862[1] < 0f) {
                                        phi_6084_ = -(_e3862[1]);
                                    } else {
                                        phi_6084_ = _e3862[1];
                                    }
                                    let _e3873 = phi_6084_;
                                    if (_e3869 > _e3873) {
                                        phi_6089_ = _e3869;
                                    } else {
                                        phi_6089_ = _e3873;
                                    }
                                    let _e3876 = phi_6089_;
                                    if (_e3862[2] < 0f) {
                                        phi_6096_ = -(_e3862[2]);
                                    } else {
                                        phi_6096_ = _e3862[2];
                                    }
                                    let _e3880 = phi_6096_;
                                    if (_e3876 > _e3880) {
                                        phi_6101_ = _e3876;
                                    } else {
                                        phi_6101_ = _e3880;
                                    }
                                    let _e3883 = phi_6101_;
                                    let _e3886 = local.member_2[1u];
                                    if (_e3886[0] < 0f) {
                                        phi_6115_ = -(_e3886[0]);
                                    } else {
                                        phi_6115_ = _e3886[0];
                                    }
                                    let _e3893 = phi_6115_;
                                    if (_e3886[1] < 0f) {
                                        phi_6122_ = -(_e3886[1]);
                                    } else {
                                        phi_6122_ = _e3886[1];
                                    }
                                    let _e3897 = phi_6122_;
                                    if (_e3893 > _e3897) {
                                        phi_6127_ = _e3893;
                                    } else {
                                        phi_6127_ = _e3897;
                                    }
                                    let _e3900 = phi_6127_;
                                    if (_e3886[2] < 0f) {
                                        phi_6134_ = -(_e3886[2]);
                                    } else {
                                        phi_6134_ = _e3886[2];
                                    }
                                    let _e3904 = phi_6134_;
                                    if (_e3900 > _e3904) {
                                        phi_6139_ = _e3900;
                                    } else {
                                        phi_6139_ = _e3904;
                                    }
                                    let _e3907 = phi_6139_;
                                    if (_e3883 > _e3907) {
                                        phi_6144_ = _e3883;
                                    } else {
                                        phi_6144_ = _e3907;
                                    }
                                    let _e3910 = phi_6144_;
                                    let _e3912 = local.member_3;
                                    let _e3916 = ((((_e3802 + _e3804) + (_e3856 + _e3858)) + (_e3910 + _e3912)) * 2f);
                                    let _e3919 = local.member_3;
                                    let _e3923 = (((_e91.member_5 * 1.0001f) + (_e3919 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                    let _e3926 = ((_e3684 * _e3663) - (_e3687 * _e3662));
                                    let _e3929 = ((_e3687 * _e3661) - (_e3681 * _e3663));
                                    let _e3932 = ((_e3681 * _e3662) - (_e3684 * _e3661));
                                    let _e3937 = (((_e3926 * _e3690[0]) + (_e3929 * _e3690[1])) + (_e3932 * _e3690[2]));
                                    let _e3942 = (((_e3926 * _e3707) + (_e3929 * _e3708)) + (_e3932 * _e3709));
                                    let _e3947 = (((_e3926 * _e3717) + (_e3929 * _e3718)) + (_e3932 * _e3719));
                                    let _e3955 = (((_e3926 * _e3716[0]) + (_e3929 * _e3716[1])) + (_e3932 * _e3716[2]));
                                    let _e3960 = (((_e3926 * _e3722[0]) + (_e3929 * _e3722[1])) + (_e3932 * _e3722[2]));
                                    let _e3965 = (((_e3926 * _e3739) + (_e3929 * _e3740)) + (_e3932 * _e3741));
                                    let _e3970 = (((_e3926 * _e3749) + (_e3929 * _e3750)) + (_e3932 * _e3751));
                                    let _e3978 = (((_e3926 * _e3748[0]) + (_e3929 * _e3748[1])) + (_e3932 * _e3748[2]));
                                    if (_e3937 < _e3942) {
                                        phi_6223_ = _e3937;
                                    } else {
                                        phi_6223_ = _e3942;
                                    }
                                    let _e3981 = phi_6223_;
                                    if (_e3947 < _e3955) {
                                        phi_6228_ = _e3947;
                                    } else {
                                        phi_6228_ = _e3955;
                                    }
                                    let _e3984 = phi_6228_;
                                    if (_e3981 < _e3984) {
                                        phi_6233_ = _e3981;
                                    } else {
                                        phi_6233_ = _e3984;
                                    }
                                    let _e3987 = phi_6233_;
                                    if (_e3960 < _e3965) {
                                        phi_6238_ = _e3960;
                                    } else {
                                        phi_6238_ = _e3965;
                                    }
                                    let _e3990 = phi_6238_;
                                    if (_e3970 < _e3978) {
                                        phi_6243_ = _e3970;
                                    } else {
                                        phi_6243_ = _e3978;
                                    }
                                    let _e3993 = phi_6243_;
                                    if (_e3990 < _e3993) {
                                        phi_6248_ = _e3990;
                                    } else {
                                        phi_6248_ = _e3993;
                                    }
                                    let _e3996 = phi_6248_;
                                    if (_e3987 < _e3996) {
                                        phi_6253_ = _e3987;
                                    } else {
                                        phi_6253_ = _e3996;
                                    }
                                    let _e3999 = phi_6253_;
                                    if (_e3937 > _e3942) {
                                        phi_6258_ = _e3937;
                                    } else {
                                        phi_6258_ = _e3942;
                                    }
                                    let _e4002 = phi_6258_;
                                    if (_e3947 > _e3955) {
                                        phi_6263_ = _e3947;
                                    } else {
                                        phi_6263_ = _e3955;
                                    }
                                    let _e4005 = phi_6263_;
                                    if (_e4002 > _e4005) {
                                        phi_6268_ = _e4002;
                                    } else {
                                        phi_6268_ = _e4005;
                                    }
                                    let _e4008 = phi_6268_;
                                    if (_e3960 > _e3965) {
                                        phi_6273_ = _e3960;
                                    } else {
                                        phi_6273_ = _e3965;
                                    }
                                    let _e4011 = phi_6273_;
                                    if (_e3970 > _e3978) {
                                        phi_6278_ = _e3970;
                                    } else {
                                        phi_6278_ = _e3978;
                                    }
                                    let _e4014 = phi_6278_;
                                    if (_e4011 > _e4014) {
                                        phi_6283_ = _e4011;
                                    } else {
                                        phi_6283_ = _e4014;
                                    }
                                    let _e4017 = phi_6283_;
                                    if (_e4008 > _e4017) {
                                        phi_6288_ = _e4008;
                                    } else {
                                        phi_6288_ = _e4017;
                                    }
                                    let _e4020 = phi_6288_;
                                    if (_e3926 < 0f) {
                                        phi_6294_ = -(_e3926);
                                    } else {
                                        phi_6294_ = _e3926;
                                    }
                                    let _e4024 = phi_6294_;
                                    if (_e3929 < 0f) {
                                        phi_6300_ = -(_e3929);
                                    } else {
                                        phi_6300_ = _e3929;
                                    }
                                    let _e4028 = phi_6300_;
                                    if (_e3932 < 0f) {
                                        phi_6307_ = -(_e3932);
                                    } else {
                                        phi_6307_ = _e3932;
                                    }
                                    let _e4033 = phi_6307_;
                                    let _e4034 = ((_e4024 + _e4028) + _e4033);
                                    let _e4039 = -(_e4020);
                                    if (_e3999 > _e4039) {
                                        phi_6318_ = _e3999;
                                    } else {
                                        phi_6318_ = _e4039;
                                    }
                                    let _e4042 = phi_6318_;
                                    let _e4047 = (((_e4042 - ((_e4034 * _e3916) * (0.000000059604645f * (17f / 2f)))) - (_e4034 * _e3923)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    let _e4050 = ((_e3684 * _e3678) - (_e3687 * _e3677));
                                    let _e4053 = ((_e3687 * _e3676) - (_e3681 * _e3678));
                                    let _e4056 = ((_e3681 * _e3677) - (_e3684 * _e3676));
                                    let _e4061 = (((_e4050 * _e3690[0]) + (_e4053 * _e3690[1])) + (_e4056 * _e3690[2]));
                                    let _e4066 = (((_e4050 * _e3707) + (_e4053 * _e3708)) + (_e4056 * _e3709));
                                    let _e4071 = (((_e4050 * _e3717) + (_e4053 * _e3718)) + (_e4056 * _e3719));
                                    let _e4079 = (((_e4050 * _e3716[0]) + (_e4053 * _e3716[1])) + (_e4056 * _e3716[2]));
                                    let _e4084 = (((_e4050 * _e3722[0]) + (_e4053 * _e3722[1])) + (_e4056 * _e3722[2]));
                                    let _e4089 = (((_e4050 * _e3739) + (_e4053 * _e3740)) + (_e4056 * _e3741));
                                    let _e4094 = (((_e4050 * _e3749) + (_e4053 * _e3750)) + (_e4056 * _e3751));
                                    let _e4102 = (((_e4050 * _e3748[0]) + (_e4053 * _e3748[1])) + (_e4056 * _e3748[2]));
                                    if (_e4061 < _e4066) {
                                        phi_6389_ = _e4061;
                                    } else {
                                        phi_6389_ = _e4066;
                                    }
                                    let _e4105 = phi_6389_;
                                    if (_e4071 < _e4079) {
                                        phi_6394_ = _e4071;
                                    } else {
                                        phi_6394_ = _e4079;
                                    }
                                    let _e4108 = phi_6394_;
                                    if (_e4105 < _e4108) {
                                        phi_6399_ = _e4105;
                                    } else {
                                        phi_6399_ = _e4108;
                                    }
                                    let _e4111 = phi_6399_;
                                    if (_e4084 < _e4089) {
                                        phi_6404_ = _e4084;
                                    } else {
                                        phi_6404_ = _e4089;
                                    }
                                    let _e4114 = phi_6404_;
                                    if (_e4094 < _e4102) {
                                        phi_6409_ = _e4094;
                                    } else {
                                        phi_6409_ = _e4102;
                                    }
                                    let _e4117 = phi_6409_;
                                    if (_e4114 < _e4117) {
                                        phi_6414_ = _e4114;
                                    } else {
                                        phi_6414_ = _e4117;
                                    }
                                    let _e4120 = phi_6414_;
                                    if (_e4111 < _e4120) {
                                        phi_6419_ = _e4111;
                                    } else {
                                        phi_6419_ = _e4120;
                                    }
                                    let _e4123 = phi_6419_;
                                    if (_e4061 > _e4066) {
                                        phi_6424_ = _e4061;
                                    } else {
                                        phi_6424_ = _e4066;
                                    }
                                    let _e4126 = phi_6424_;
                                    if (_e4071 > _e4079) {
                                        phi_6429_ = _e4071;
                                    } else {
                                        phi_6429_ = _e4079;
                                    }
                                    let _e4129 = phi_6429_;
                                    if (_e4126 > _e4129) {
                                        phi_6434_ = _e4126;
                                    } else {
                                        phi_6434_ = _e4129;
                                    }
                                    let _e4132 = phi_6434_;
                                    if (_e4084 > _e4089) {
                                        phi_6439_ = _e4084;
                                    } else {
                                        phi_6439_ = _e4089;
                                    }
                                    let _e4135 = phi_6439_;
                                    if (_e4094 > _e4102) {
                                        phi_6444_ = _e4094;
                                    } else {
                                        phi_6444_ = _e4102;
                                    }
                                    let _e4138 = phi_6444_;
                                    if (_e4135 > _e4138) {
                                        phi_6449_ = _e4135;
                                    } else {
                                        phi_6449_ = _e4138;
                                    }
                                    let _e4141 = phi_6449_;
                                    if (_e4132 > _e4141) {
                                        phi_6454_ = _e4132;
                                    } else {
                                        phi_6454_ = _e4141;
                                    }
                                    let _e4144 = phi_6454_;
                                    if (_e4050 < 0f) {
                                        phi_6460_ = -(_e4050);
                                    } else {
                                        phi_6460_ = _e4050;
                                    }
                                    let _e4148 = phi_6460_;
                                    if (_e4053 < 0f) {
                                        phi_6466_ = -(_e4053);
                                    } else {
                                        phi_6466_ = _e4053;
                                    }
                                    let _e4152 = phi_6466_;
                                    if (_e4056 < 0f) {
                                        phi_6473_ = -(_e4056);
                                    } else {
                                        phi_6473_ = _e4056;
                                    }
                                    let _e4157 = phi_6473_;
                                    let _e4158 = ((_e4148 + _e4152) + _e4157);
                                    let _e4163 = -(_e4144);
                                    if (_e4123 > _e4163) {
                                        phi_6484_ = _e4123;
                                    } else {
                                        phi_6484_ = _e4163;
                                    }
                                    let _e4166 = phi_6484_;
                                    let _e4171 = (((_e4166 - ((_e4158 * _e3916) * (0.000000059604645f * (17f / 2f)))) - (_e4158 * _e3923)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                    if (_e4047 > _e4171) {
                                        phi_6494_ = _e4047;
                                    } else {
                                        phi_6494_ = _e4171;
                                    }
                                    let _e4174 = phi_6494_;
                                    if (_e2990.member == 0u) {
                                        let _e4176 = (_e3676 - _e3661);
                                        let _e4177 = (_e3677 - _e3662);
                                        let _e4178 = (_e3678 - _e3663);
                                        let _e4181 = ((_e3684 * _e4178) - (_e3687 * _e4177));
                                        let _e4184 = ((_e3687 * _e4176) - (_e3681 * _e4178));
                                        let _e4187 = ((_e3681 * _e4177) - (_e3684 * _e4176));
                                        let _e4192 = (((_e4181 * _e3690[0]) + (_e4184 * _e3690[1])) + (_e4187 * _e3690[2]));
                                        let _e4197 = (((_e4181 * _e3707) + (_e4184 * _e3708)) + (_e4187 * _e3709));
                                        let _e4202 = (((_e4181 * _e3717) + (_e4184 * _e3718)) + (_e4187 * _e3719));
                                        let _e4210 = (((_e4181 * _e3716[0]) + (_e4184 * _e3716[1])) + (_e4187 * _e3716[2]));
                                        let _e4215 = (((_e4181 * _e3722[0]) + (_e4184 * _e3722[1])) + (_e4187 * _e3722[2]));
                                        let _e4220 = (((_e4181 * _e3739) + (_e4184 * _e3740)) + (_e4187 * _e3741));
                                        let _e4225 = (((_e4181 * _e3749) + (_e4184 * _e3750)) + (_e4187 * _e3751));
                                        let _e4233 = (((_e4181 * _e3748[0]) + (_e4184 * _e3748[1])) + (_e4187 * _e3748[2]));
                                        if (_e4192 < _e4197) {
                                            phi_6567_ = _e4192;
                                        } else {
                                            phi_6567_ = _e4197;
                                        }
                                        let _e4236 = phi_6567_;
                                        if (_e4202 < _e4210) {
                                            phi_6572_ = _e4202;
                                        } else {
                                            phi_6572_ = _e4210;
                                        }
                                        let _e4239 = phi_6572_;
                                        if (_e4236 < _e4239) {
                                            phi_6577_ = _e4236;
                                        } else {
                                            phi_6577_ = _e4239;
                                        }
                                        let _e4242 = phi_6577_;
                                        if (_e4215 < _e4220) {
                                            phi_6582_ = _e4215;
                                        } else {
                                            phi_6582_ = _e4220;
                                        }
                                        let _e4245 = phi_6582_;
                                        if (_e4225 < _e4233) {
                                            phi_6587_ = _e4225;
                                        } else {
                                            phi_6587_ = _e4233;
                                        }
                                        let _e4248 = phi_6587_;
                                        if (_e4245 < _e4248) {
                                            phi_6592_ = _e4245;
                                        } else {
                                            phi_6592_ = _e4248;
                                        }
                                        let _e4251 = phi_6592_;
                                        if (_e4242 < _e4251) {
                                            phi_6597_ = _e4242;
                                        } else {
                                            phi_6597_ = _e4251;
                                        }
                                        let _e4254 = phi_6597_;
                                        if (_e4192 > _e4197) {
                                            phi_6602_ = _e4192;
                                        } else {
                                            phi_6602_ = _e4197;
                                        }
                                        let _e4257 = phi_6602_;
                                        if (_e4202 > _e4210) {
                                            phi_6607_ = _e4202;
                                        } else {
                                            phi_6607_ = _e4210;
                                        }
                                        let _e4260 = phi_6607_;
                                        if (_e4257 > _e4260) {
                                            phi_6612_ = _e4257;
                                        } else {
                                            phi_6612_ = _e4260;
                                        }
                                        let _e4263 = phi_6612_;
                                        if (_e4215 > _e4220) {
                                            phi_6617_ = _e4215;
                                        } else {
                                            phi_6617_ = _e4220;
                                        }
                                        let _e4266 = phi_6617_;
                                        if (_e4225 > _e4233) {
                                            phi_6622_ = _e4225;
                                        } else {
                                            phi_6622_ = _e4233;
                                        }
                                        let _e4269 = phi_6622_;
                                        if (_e4266 > _e4269) {
                                            phi_6627_ = _e4266;
                                        } else {
                                            phi_6627_ = _e4269;
                                        }
                                        let _e4272 = phi_6627_;
                                        if (_e4263 > _e4272) {
                                            phi_6632_ = _e4263;
                                        } else {
                                            phi_6632_ = _e4272;
                                        }
                                        let _e4275 = phi_6632_;
                                        if (_e4181 < 0f) {
                                            phi_6638_ = -(_e4181);
                                        } else {
                                            phi_6638_ = _e4181;
                                        }
                                        let _e4279 = phi_6638_;
                                        if (_e4184 < 0f) {
                                            phi_6644_ = -(_e4184);
                                        } else {
                                            phi_6644_ = _e4184;
                                        }
                                        let _e4283 = phi_6644_;
                                        if (_e4187 < 0f) {
                                            phi_6651_ = -(_e4187);
                                        } else {
                                            phi_6651_ = _e4187;
                                        }
                                        let _e4288 = phi_6651_;
                                        let _e4289 = ((_e4279 + _e4283) + _e4288);
                                        let _e4294 = -(_e4275);
                                        if (_e4254 > _e4294) {
                                            phi_6662_ = _e4254;
                                        } else {
                                            phi_6662_ = _e4294;
                                        }
                                        let _e4297 = phi_6662_;
                                        let _e4302 = (((_e4297 - ((_e4289 * _e3916) * (0.000000059604645f * (17f / 2f)))) - (_e4289 * _e3923)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e4174 > _e4302) {
                                            phi_6672_ = _e4174;
                                        } else {
                                            phi_6672_ = _e4302;
                                        }
                                        let _e4305 = phi_6672_;
                                        phi_6673_ = _e4305;
                                    } else {
                                        phi_6673_ = _e4174;
                                    }
                                    let _e4307 = phi_6673_;
                                    phi_6676_ = (_e3648 || (_e4307 > 0f));
                                }
                                let _e4311 = phi_6676_;
                                if _e4311 {
                                    let _e4314 = local_1.member_1[0u];
                                    let _e4320 = local_1.member_2[0u];
                                    let _e4326 = ((_e4314[1] * _e4320[2]) - (_e4314[2] * _e4320[1]));
                                    let _e4329 = ((_e4314[2] * _e4320[0]) - (_e4314[0] * _e4320[2]));
                                    let _e4332 = ((_e4314[0] * _e4320[1]) - (_e4314[1] * _e4320[0]));
                                    let _e4335 = local_1.member_1[1u];
                                    let _e4341 = local_1.member_2[1u];
                                    let _e4347 = ((_e4335[1] * _e4341[2]) - (_e4335[2] * _e4341[1]));
                                    let _e4350 = ((_e4335[2] * _e4341[0]) - (_e4335[0] * _e4341[2]));
                                    let _e4353 = ((_e4335[0] * _e4341[1]) - (_e4335[1] * _e4341[0]));
                                    let _e4356 = local_1.member_1[0u];
                                    let _e4362 = local_1.member_2[1u];
                                    let _e4377 = local_1.member_1[1u];
                                    let _e4383 = local_1.member_2[0u];
                                    let _e4396 = (((_e4356[1] * _e4362[2]) - (_e4356[2] * _e4362[1])) + ((_e4377[1] * _e4383[2]) - (_e4377[2] * _e4383[1])));
                                    let _e4397 = (((_e4356[2] * _e4362[0]) - (_e4356[0] * _e4362[2])) + ((_e4377[2] * _e4383[0]) - (_e4377[0] * _e4383[2])));
                                    let _e4398 = (((_e4356[0] * _e4362[1]) - (_e4356[1] * _e4362[0])) + ((_e4377[0] * _e4383[1]) - (_e4377[1] * _e4383[0])));
                                    let _e4401 = local_1.member[0u];
                                    let _e4412 = local_1.member[1u];
                                    let _e4423 = local_1.member[0u];
                                    let _e4432 = ((((_e4412[0] * _e4326) + (_e4412[1] * _e4329)) + (_e4412[2] * _e4332)) + (((_e4423[0] * _e4396) + (_e4423[1] * _e4397)) + (_e4423[2] * _e4398)));
                                    let _e4435 = local_1.member[0u];
                                    let _e4446 = local_1.member[1u];
                                    let _e4455 = ((((_e4435[0] * _e4347) + (_e4435[1] * _e4350)) + (_e4435[2] * _e4353)) + (((_e4446[0] * _e4396) + (_e4446[1] * _e4397)) + (_e4446[2] * _e4398)));
                                    let _e4458 = local_1.member[1u];
                                    let _e4469 = local_1.member[0u];
                                    if (_e4469[0] < 0f) {
                                        phi_6921_ = -(_e4469[0]);
                                    } else {
                                        phi_6921_ = _e4469[0];
                                    }
                                    let _e4476 = phi_6921_;
                                    if (_e4469[1] < 0f) {
                                        phi_6928_ = -(_e4469[1]);
                                    } else {
                                        phi_6928_ = _e4469[1];
                                    }
                                    let _e4480 = phi_6928_;
                                    if (_e4476 > _e4480) {
                                        phi_6933_ = _e4476;
                                    } else {
                                        phi_6933_ = _e4480;
                                    }
                                    let _e4483 = phi_6933_;
                                    if (_e4469[2] < 0f) {
                                        phi_6940_ = -(_e4469[2]);
                                    } else {
                                        phi_6940_ = _e4469[2];
                                    }
                                    let _e4487 = phi_6940_;
                                    if (_e4483 > _e4487) {
                                        phi_6945_ = _e4483;
                                    } else {
                                        phi_6945_ = _e4487;
                                    }
                                    let _e4490 = phi_6945_;
                                    let _e4493 = local_1.member[1u];
                                    if (_e4493[0] < 0f) {
                                        phi_6958_ = -(_e4493[0]);
                                    } else {
                                        phi_6958_ = _e4493[0];
                                    }
                                    let _e4500 = phi_6958_;
                                    if (_e4493[1] < 0f) {
                                        phi_6965_ = -(_e4493[1]);
                                    } else {
                                        phi_6965_ = _e4493[1];
                                    }
                                    let _e4504 = phi_6965_;
                                    if (_e4500 > _e4504) {
                                        phi_6970_ = _e4500;
                                    } else {
                                        phi_6970_ = _e4504;
                                    }
                                    let _e4507 = phi_6970_;
                                    if (_e4493[2] < 0f) {
                                        phi_6977_ = -(_e4493[2]);
                                    } else {
                                        phi_6977_ = _e4493[2];
                                    }
                                    let _e4511 = phi_6977_;
                                    if (_e4507 > _e4511) {
                                        phi_6982_ = _e4507;
                                    } else {
                                        phi_6982_ = _e4511;
                                    }
                                    let _e4514 = phi_6982_;
                                    if (_e4490 > _e4514) {
                                        phi_6987_ = _e4490;
                                    } else {
                                        phi_6987_ = _e4514;
                                    }
                                    let _e4517 = phi_6987_;
                                    let _e4519 = local_1.member_3;
                                    let _e4520 = (_e4517 + _e4519);
                                    let _e4523 = local_1.member_1[0u];
                                    if (_e4523[0] < 0f) {
                                        phi_7004_ = -(_e4523[0]);
                                    } else {
                                        phi_7004_ = _e4523[0];
                                    }
                                    let _e4530 = phi_7004_;
                                    if (_e4523[1] < 0f) {
                                        phi_7011_ = -(_e4523[1]);
                                    } else {
                                        phi_7011_ = _e4523[1];
                                    }
                                    let _e4534 = phi_7011_;
                                    if (_e4530 > _e4534) {
                                        phi_7016_ = _e4530;
                                    } else {
                                        phi_7016_ = _e4534;
                                    }
                                    let _e4537 = phi_7016_;
                                    if (_e4523[2] < 0f) {
                                        phi_7023_ = -(_e4523[2]);
                                    } else {
                                        phi_7023_ = _e4523[2];
                                    }
                                    let _e4541 = phi_7023_;
                                    if (_e4537 > _e4541) {
                                        phi_7028_ = _e4537;
                                    } else {
                                        phi_7028_ = _e4541;
                                    }
                                    let _e4544 = phi_7028_;
                                    let _e4547 = local_1.member_1[1u];
                                    if (_e4547[0] < 0f) {
                                        phi_7042_ = -(_e4547[0]);
                                    } else {
                                        phi_7042_ = _e4547[0];
                                    }
                                    let _e4554 = phi_7042_;
                                    if (_e4547[1] < 0f) {
                                        phi_7049_ = -(_e4547[1]);
                                    } else {
                                        phi_7049_ = _e4547[1];
                                    }
                                    let _e4558 = phi_7049_;
                                    if (_e4554 > _e4558) {
                                        phi_7054_ = _e4554;
                                    } else {
                                        phi_7054_ = _e4558;
                                    }
                                    let _e4561 = phi_7054_;
                                    if (_e4547[2] < 0f) {
                                        phi_7061_ = -(_e4547[2]);
                                    } else {
                                        phi_7061_ = _e4547[2];
                                    }
                                    let _e4565 = phi_7061_;
                                    if (_e4561 > _e4565) {
                                        phi_7066_ = _e4561;
                                    } else {
                                        phi_7066_ = _e4565;
                                    }
                                    let _e4568 = phi_7066_;
                                    if (_e4544 > _e4568) {
                                        phi_7071_ = _e4544;
                                    } else {
                                        phi_7071_ = _e4568;
                                    }
                                    let _e4571 = phi_7071_;
                                    let _e4573 = local_1.member_3;
                                    let _e4574 = (_e4571 + _e4573);
                                    let _e4577 = local_1.member_2[0u];
                                    if (_e4577[0] < 0f) {
                                        phi_7088_ = -(_e4577[0]);
                                    } else {
                                        phi_7088_ = _e4577[0];
                                    }
                                    let _e4584 = phi_7088_;
                                    if (_e4577[1] < 0f) {
                                        phi_7095_ = -(_e4577[1]);
                                    } else {
                                        phi_7095_ = _e4577[1];
                                    }
                                    let _e4588 = phi_7095_;
                                    if (_e4584 > _e4588) {
                                        phi_7100_ = _e4584;
                                    } else {
                                        phi_7100_ = _e4588;
                                    }
                                    let _e4591 = phi_7100_;
                                    if (_e4577[2] < 0f) {
                                        phi_7107_ = -(_e4577[2]);
                                    } else {
                                        phi_7107_ = _e4577[2];
                                    }
                                    let _e4595 = phi_7107_;
                                    if (_e4591 > _e4595) {
                                        phi_7112_ = _e4591;
                                    } else {
                                        phi_7112_ = _e4595;
                                    }
                                    let _e4598 = phi_7112_;
                                    let _e4601 = local_1.member_2[1u];
                                    if (_e4601[0] < 0f) {
                                        phi_7126_ = -(_e4601[0]);
                                    } else {
                                        phi_7126_ = _e4601[0];
                                    }
                                    let _e4608 = phi_7126_;
                                    if (_e4601[1] < 0f) {
                                        phi_7133_ = -(_e4601[1]);
                                    } else {
                                        phi_7133_ = _e4601[1];
                                    }
                                    let _e4612 = phi_7133_;
                                    if (_e4608 > _e4612) {
                                        phi_7138_ = _e4608;
                                    } else {
                                        phi_7138_ = _e4612;
                                    }
                                    let _e4615 = phi_7138_;
                                    if (_e4601[2] < 0f) {
                                        phi_7145_ = -(_e4601[2]);
                                    } else {
                                        phi_7145_ = _e4601[2];
                                    }
                                    let _e4619 = phi_7145_;
                                    if (_e4615 > _e4619) {
                                        phi_7150_ = _e4615;
                                    } else {
                                        phi_7150_ = _e4619;
                                    }
                                    let _e4622 = phi_7150_;
                                    if (_e4598 > _e4622) {
                                        phi_7155_ = _e4598;
                                    } else {
                                        phi_7155_ = _e4622;
                                    }
                                    let _e4625 = phi_7155_;
                                    let _e4627 = local_1.member_3;
                                    let _e4628 = (_e4625 + _e4627);
                                    let _e4630 = ((_e4574 * 8f) * _e4628);
                                    let _e4637 = local_1.member_3;
                                    if (_e4326 < 0f) {
                                        phi_7186_ = -(_e4326);
                                    } else {
                                        phi_7186_ = _e4326;
                                    }
                                    let _e4654 = phi_7186_;
                                    if (_e4329 < 0f) {
                                        phi_7192_ = -(_e4329);
                                    } else {
                                        phi_7192_ = _e4329;
                                    }
                                    let _e4658 = phi_7192_;
                                    if (_e4332 < 0f) {
                                        phi_7199_ = -(_e4332);
                                    } else {
                                        phi_7199_ = _e4332;
                                    }
                                    let _e4663 = phi_7199_;
                                    let _e4664 = ((_e4654 + _e4658) + _e4663);
                                    if (_e4347 < 0f) {
                                        phi_7206_ = -(_e4347);
                                    } else {
                                        phi_7206_ = _e4347;
                                    }
                                    let _e4668 = phi_7206_;
                                    if (_e4350 < 0f) {
                                        phi_7212_ = -(_e4350);
                                    } else {
                                        phi_7212_ = _e4350;
                                    }
                                    let _e4672 = phi_7212_;
                                    if (_e4353 < 0f) {
                                        phi_7219_ = -(_e4353);
                                    } else {
                                        phi_7219_ = _e4353;
                                    }
                                    let _e4677 = phi_7219_;
                                    let _e4678 = ((_e4668 + _e4672) + _e4677);
                                    if (_e4664 > _e4678) {
                                        phi_7225_ = _e4664;
                                    } else {
                                        phi_7225_ = _e4678;
                                    }
                                    let _e4681 = phi_7225_;
                                    if (_e4396 < 0f) {
                                        phi_7231_ = -(_e4396);
                                    } else {
                                        phi_7231_ = _e4396;
                                    }
                                    let _e4685 = phi_7231_;
                                    if (_e4397 < 0f) {
                                        phi_7237_ = -(_e4397);
                                    } else {
                                        phi_7237_ = _e4397;
                                    }
                                    let _e4689 = phi_7237_;
                                    if (_e4398 < 0f) {
                                        phi_7244_ = -(_e4398);
                                    } else {
                                        phi_7244_ = _e4398;
                                    }
                                    let _e4694 = phi_7244_;
                                    let _e4696 = (((_e4685 + _e4689) + _e4694) * 0.5f);
                                    if (_e4681 > _e4696) {
                                        phi_7251_ = _e4681;
                                    } else {
                                        phi_7251_ = _e4696;
                                    }
                                    let _e4699 = phi_7251_;
                                    let _e4704 = local_1.member_3;
                                    let _e4717 = ((((_e4401[0] * _e4326) + (_e4401[1] * _e4329)) + (_e4401[2] * _e4332)) * 3f);
                                    let _e4718 = ((((_e4458[0] * _e4347) + (_e4458[1] * _e4350)) + (_e4458[2] * _e4353)) * 3f);
                                    if (_e4717 < _e4718) {
                                        phi_7275_ = _e4717;
                                    } else {
                                        phi_7275_ = _e4718;
                                    }
                                    let _e4721 = phi_7275_;
                                    if (_e4432 < _e4455) {
                                        phi_7280_ = _e4432;
                                    } else {
                                        phi_7280_ = _e4455;
                                    }
                                    let _e4724 = phi_7280_;
                                    if (_e4721 < _e4724) {
                                        phi_7285_ = _e4721;
                                    } else {
                                        phi_7285_ = _e4724;
                                    }
                                    let _e4727 = phi_7285_;
                                    if (_e4717 > _e4718) {
                                        phi_7290_ = _e4717;
                                    } else {
                                        phi_7290_ = _e4718;
                                    }
                                    let _e4730 = phi_7290_;
                                    if (_e4432 > _e4455) {
                                        phi_7295_ = _e4432;
                                    } else {
                                        phi_7295_ = _e4455;
                                    }
                                    let _e4733 = phi_7295_;
                                    if (_e4730 > _e4733) {
                                        phi_7300_ = _e4730;
                                    } else {
                                        phi_7300_ = _e4733;
                                    }
                                    let _e4736 = phi_7300_;
                                    let _e4741 = -(_e4736);
                                    if (_e4727 > _e4741) {
                                        phi_7310_ = _e4727;
                                    } else {
                                        phi_7310_ = _e4741;
                                    }
                                    let _e4744 = phi_7310_;
                                    let _e4746 = ((_e4744 - ((((((_e4520 * 8f) * _e4630) * (0.000000059604645f * (524f / 64f))) + ((_e4637 * 19f) * ((_e4520 * (_e4574 + _e4628)) + (_e4574 * _e4628)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4520) * ((1f + _e4574) * (1f + _e4628))))) + ((_e91.member_5 * (((_e4699 + (_e4630 * (0.000000059604645f * 8f))) + ((_e4704 * 6f) * (_e4574 + _e4628))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e4574) * (1f + _e4628))))) * (3f * 1.0001f)))) > 0f);
                                    if _e4746 {
                                        phi_8279_ = _e4746;
                                    } else {
                                        let _e4749 = local_1.member_1[0u];
                                        let _e4755 = local_1.member_1[1u];
                                        let _e4759 = (_e4749[0] + _e4755[0]);
                                        let _e4760 = (_e4749[1] + _e4755[1]);
                                        let _e4761 = (_e4749[2] + _e4755[2]);
                                        let _e4764 = local_1.member_2[0u];
                                        let _e4770 = local_1.member_2[1u];
                                        let _e4774 = (_e4764[0] + _e4770[0]);
                                        let _e4775 = (_e4764[1] + _e4770[1]);
                                        let _e4776 = (_e4764[2] + _e4770[2]);
                                        let _e4779 = ((_e4760 * _e4776) - (_e4761 * _e4775));
                                        let _e4782 = ((_e4761 * _e4774) - (_e4759 * _e4776));
                                        let _e4785 = ((_e4759 * _e4775) - (_e4760 * _e4774));
                                        let _e4788 = local_1.member[0u];
                                        let _e4795 = local_1.member_1[0u];
                                        let _e4801 = local_1.member_2[0u];
                                        let _e4805 = (_e4788[0] - _e4795[0]);
                                        let _e4806 = (_e4788[1] - _e4795[1]);
                                        let _e4807 = (_e4788[2] - _e4795[2]);
                                        if (_e2990.member == 0u) {
                                            phi_7426_ = array<f32, 3>(_e4788[0], _e4788[1], _e4788[2]);
                                        } else {
                                            phi_7426_ = array<f32, 3>((_e4805 - _e4801[0]), (_e4806 - _e4801[1]), (_e4807 - _e4801[2]));
                                        }
                                        let _e4814 = phi_7426_;
                                        let _e4815 = (_e4788[0] - _e4801[0]);
                                        let _e4816 = (_e4788[1] - _e4801[1]);
                                        let _e4817 = (_e4788[2] - _e4801[2]);
                                        let _e4820 = local_1.member[1u];
                                        let _e4827 = local_1.member_1[1u];
                                        let _e4833 = local_1.member_2[1u];
                                        let _e4837 = (_e4820[0] - _e4827[0]);
                                        let _e4838 = (_e4820[1] - _e4827[1]);
                                        let _e4839 = (_e4820[2] - _e4827[2]);
                                        if (_e2990.member == 0u) {
                                            phi_7491_ = array<f32, 3>(_e4820[0], _e4820[1], _e4820[2]);
                                        } else {
                                            phi_7491_ = array<f32, 3>((_e4837 - _e4833[0]), (_e4838 - _e4833[1]), (_e4839 - _e4833[2]));
                                        }
                                        let _e4846 = phi_7491_;
                                        let _e4847 = (_e4820[0] - _e4833[0]);
                                        let _e4848 = (_e4820[1] - _e4833[1]);
                                        let _e4849 = (_e4820[2] - _e4833[2]);
                                        let _e4852 = local_1.member[0u];
                                        if (_e4852[0] < 0f) {
                                            phi_7513_ = -(_e4852[0]);
                                        } else {
                                            phi_7513_ = _e4852[0];
                                        }
                                        let _e4859 = phi_7513_;
                                        if (_e4852[1] < 0f) {
                                            phi_7520_ = -(_e4852[1]);
                                        } else {
                                            phi_7520_ = _e4852[1];
                                        }
                                        let _e4863 = phi_7520_;
                                        if (_e4859 > _e4863) {
                                            phi_7525_ = _e4859;
                                        } else {
                                            phi_7525_ = _e4863;
                                        }
                                        let _e4866 = phi_7525_;
                                        if (_e4852[2] < 0f) {
                                            phi_7532_ = -(_e4852[2]);
                                        } else {
                                            phi_7532_ = _e4852[2];
                                        }
                                        let _e4870 = phi_7532_;
                                        if (_e4866 > _e4870) {
                                            phi_7537_ = _e4866;
                                        } else {
                                            phi_7537_ = _e4870;
                                        }
                                        let _e4873 = phi_7537_;
                                        let _e4876 = local_1.member[1u];
                                        if (_e4876[0] < 0f) {
                                            phi_7550_ = -(_e4876[0]);
                                        } else {
                                            phi_7550_ = _e4876[0];
                                        }
                                        let _e4883 = phi_7550_;
                                        if (_e4876[1] < 0f) {
                                            phi_7557_ = -(_e4876[1]);
                                        } else {
                                            phi_7557_ = _e4876[1];
                                        }
                                        let _e4887 = phi_7557_;
                                        if (_e4883 > _e4887) {
                                            phi_7562_ = _e4883;
                                        } else {
                                            phi_7562_ = _e4887;
                                        }
                                        let _e4890 = phi_7562_;
                                        if (_e4876[2] < 0f) {
                                            phi_7569_ = -(_e4876[2]);
                                        } else {
                                            phi_7569_ = _e4876[2];
                                        }
                                        let _e4894 = phi_7569_;
                                        if (_e4890 > _e4894) {
                                            phi_7574_ = _e4890;
                                        } else {
                                            phi_7574_ = _e4894;
                                        }
                                        let _e4897 = phi_7574_;
                                        if (_e4873 > _e4897) {
                                            phi_7579_ = _e4873;
                                        } else {
                                            phi_7579_ = _e4897;
                                        }
                                        let _e4900 = phi_7579_;
                                        let _e4902 = local_1.member_3;
                                        let _e4906 = local_1.member_1[0u];
                                        if (_e4906[0] < 0f) {
                                            phi_7596_ = -(_e4906[0]);
                                        } else {
                                            phi_7596_ = _e4906[0];
                                        }
                                        let _e4913 = phi_7596_;
                                        if (_e4906[1] < 0f) {
                                            phi_7603_ = -(_e4906[1]);
                                        } else {
                                            phi_7603_ = _e4906[1];
                                        }
                                        let _e4917 = phi_7603_;
                                        if (_e4913 > _e4917) {
                                            phi_7608_ = _e4913;
                                        } else {
                                            phi_7608_ = _e4917;
                                        }
                                        let _e4920 = phi_7608_;
                                        if (_e4906[2] < 0f) {
                                            phi_7615_ = -(_e4906[2]);
                                        } else {
                                            phi_7615_ = _e4906[2];
                                        }
                                        let _e4924 = phi_7615_;
                                        if (_e4920 > _e4924) {
                                            phi_7620_ = _e4920;
                                        } else {
                                            phi_7620_ = _e4924;
                                        }
                                        let _e4927 = phi_7620_;
                                        let _e4930 = local_1.member_1[1u];
                                        if (_e4930[0] < 0f) {
                                            phi_7634_ = -(_e4930[0]);
                                        } else {
                                            phi_7634_ = _e4930[0];
                                        }
                                        let _e4937 = phi_7634_;
                                        if (_e4930[1] < 0f) {
                                            phi_7641_ = -(_e4930[1]);
                                        } else {
                                            phi_7641_ = _e4930[1];
                                        }
                                        let _e4941 = phi_7641_;
                                        if (_e4937 > _e4941) {
                                            phi_7646_ = _e4937;
                                        } else {
                                            phi_7646_ = _e4941;
                                        }
                                        let _e4944 = phi_7646_;
                                        if (_e4930[2] < 0f) {
                                            phi_7653_ = -(_e4930[2]);
                                        } else {
                                            phi_7653_ = _e4930[2];
                                        }
                                        let _e4948 = phi_7653_;
                                        if (_e4944 > _e4948) {
                                            phi_7658_ = _e4944;
                                        } else {
                                            phi_7658_ = _e4948;
                                        }
                                        let _e4951 = phi_7658_;
                                        if (_e4927 > _e4951) {
                                            phi_7663_ = _e4927;
                                        } else {
                                            phi_7663_ = _e4951;
                                        }
                                        let _e4954 = phi_7663_;
                                        let _e4956 = local_1.member_3;
                                        let _e4960 = local_1.member_2[0u];
                                        if (_e4960[0] < 0f) {
                                            phi_7680_ = -(_e4960[0]);
                                        } else {
                                            phi_7680_ = _e4960[0];
                                        }
                                        let _e4967 = phi_7680_;
                                        if (_e4960[1] < 0f) {
                                            phi_7687_ = -(_e4960[1]);
                                        } else {
                                            phi_7687_ = _e4960[1];
                                        }
                                        let _e4971 = phi_7687_;
                                        if (_e4967 > _e4971) {
                                            phi_7692_ = _e4967;
                                        } else {
                                            phi_7692_ = _e4971;
                                        }
                                        let _e4974 = phi_7692_;
                                        if (_e4960[2] < 0f) {
                                            phi_7699_ = -(_e4960[2]);
                                        } else {
                                            phi_7699_ = _e4960[2];
                                        }
                                        let _e4978 = phi_7699_;
                                        if (_e4974 > _e4978) {
                                            phi_7704_ = _e4974;
                                        } else {
                                            phi_7704_ = _e4978;
                                        }
                                        let _e4981 = phi_7704_;
                                        let _e4984 = local_1.member_2[1u];
                                        if (_e4984[0] < 0f) {
                                            phi_7718_ = -(_e4984[0]);
                                        } else {
                                            phi_7718_ = _e4984[0];
                                        }
                                        let _e4991 = phi_7718_;
                                        if (_e4984[1] < 0f) {
                                            phi_7725_ = -(_e4984[1]);
                                        } else {
                                            phi_7725_ = _e4984[1];
                                        }
                                        let _e4995 = phi_7725_;
                                        if (_e4991 > _e4995) {
                                            phi_7730_ = _e4991;
                                        } else {
                                            phi_7730_ = _e4995;
                                        }
                                        let _e4998 = phi_7730_;
                                        if (_e4984[2] < 0f) {
                                            phi_7737_ = -(_e4984[2]);
                                        } else {
                                            phi_7737_ = _e4984[2];
                                        }
                                        let _e5002 = phi_7737_;
                                        if (_e4998 > _e5002) {
                                            phi_7742_ = _e4998;
                                        } else {
                                            phi_7742_ = _e5002;
                                        }
                                        let _e5005 = phi_7742_;
                                        if (_e4981 > _e5005) {
                                            phi_7747_ = _e4981;
                                        } else {
                                            phi_7747_ = _e5005;
                                        }
                                        let _e5008 = phi_7747_;
                                        let _e5010 = local_1.member_3;
                                        let _e5014 = ((((_e4900 + _e4902) + (_e4954 + _e4956)) + (_e5008 + _e5010)) * 2f);
                                        let _e5017 = local_1.member_3;
                                        let _e5021 = (((_e91.member_5 * 1.0001f) + (_e5017 * 3.1f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                        let _e5024 = ((_e4782 * _e4761) - (_e4785 * _e4760));
                                        let _e5027 = ((_e4785 * _e4759) - (_e4779 * _e4761));
                                        let _e5030 = ((_e4779 * _e4760) - (_e4782 * _e4759));
                                        let _e5035 = (((_e5024 * _e4788[0]) + (_e5027 * _e4788[1])) + (_e5030 * _e4788[2]));
                                        let _e5040 = (((_e5024 * _e4805) + (_e5027 * _e4806)) + (_e5030 * _e4807));
                                        let _e5045 = (((_e5024 * _e4815) + (_e5027 * _e4816)) + (_e5030 * _e4817));
                                        let _e5053 = (((_e5024 * _e4814[0]) + (_e5027 * _e4814[1])) + (_e5030 * _e4814[2]));
                                        let _e5058 = (((_e5024 * _e4820[0]) + (_e5027 * _e4820[1])) + (_e5030 * _e4820[2]));
                                        let _e5063 = (((_e5024 * _e4837) + (_e5027 * _e4838)) + (_e5030 * _e4839));
                                        let _e5068 = (((_e5024 * _e4847) + (_e5027 * _e4848)) + (_e5030 * _e4849));
                                        let _e5076 = (((_e5024 * _e4846[0]) + (_e5027 * _e4846[1])) + (_e5030 * _e4846[2]));
                                        if (_e5035 < _e5040) {
                                            phi_7826_ = _e5035;
                                        } else {
                                            phi_7826_ = _e5040;
                                        }
                                        let _e5079 = phi_7826_;
                                        if (_e5045 < _e5053) {
                                            phi_7831_ = _e5045;
                                        } else {
                                            phi_7831_ = _e5053;
                                        }
                                        let _e5082 = phi_7831_;
                                        if (_e5079 < _e5082) {
                                            phi_7836_ = _e5079;
                                        } else {
                                            phi_7836_ = _e5082;
                                        }
                                        let _e5085 = phi_7836_;
                                        if (_e5058 < _e5063) {
                                            phi_7841_ = _e5058;
                                        } else {
                                            phi_7841_ = _e5063;
                                        }
                                        let _e5088 = phi_7841_;
                                        if (_e5068 < _e5076) {
                                            phi_7846_ = _e5068;
                                        } else {
                                            phi_7846_ = _e5076;
                                        }
                                        let _e5091 = phi_7846_;
                                        if (_e5088 < _e5091) {
                                            phi_7851_ = _e5088;
                                        } else {
                                            phi_7851_ = _e5091;
                                        }
                                        let _e5094 = phi_7851_;
                                        if (_e5085 < _e5094) {
                                            phi_7856_ = _e5085;
                                        } else {
                                            phi_7856_ = _e5094;
                                        }
                                        let _e5097 = phi_7856_;
                                        if (_e5035 > _e5040) {
                                            phi_7861_ = _e5035;
                                        } else {
                                            phi_7861_ = _e5040;
                                        }
                                        let _e5100 = phi_7861_;
                                        if (_e5045 > _e5053) {
                                            phi_7866_ = _e5045;
                                        } else {
                                            phi_7866_ = _e5053;
                                        }
                                        let _e5103 = phi_7866_;
                                        if (_e5100 > _e5103) {
                                            phi_7871_ = _e5100;
                                        } else {
                                            phi_7871_ = _e5103;
                                        }
                                        let _e5106 = phi_7871_;
                                        if (_e5058 > _e5063) {
                                            phi_7876_ = _e5058;
                                        } else {
                                            phi_7876_ = _e5063;
                                        }
                                        let _e5109 = phi_7876_;
                                        if (_e5068 > _e5076) {
                                            phi_7881_ = _e5068;
                                        } else {
                                            phi_7881_ = _e5076;
                                        }
                                        let _e5112 = phi_7881_;
                                        if (_e5109 > _e5112) {
                                            phi_7886_ = _e5109;
                                        } else {
                                            phi_7886_ = _e5112;
                                        }
                                        let _e5115 = phi_7886_;
                                        if (_e5106 > _e5115) {
                                            phi_7891_ = _e5106;
                                        } else {
                                            phi_7891_ = _e5115;
                                        }
                                        let _e5118 = phi_7891_;
                                        if (_e5024 < 0f) {
                                            phi_7897_ = -(_e5024);
                                        } else {
                                            phi_7897_ = _e5024;
                                        }
                                        let _e5122 = phi_7897_;
                                        if (_e5027 < 0f) {
                                            phi_7903_ = -(_e5027);
                                        } else {
                                            phi_7903_ = _e5027;
                                        }
                                        let _e5126 = phi_7903_;
                                        if (_e5030 < 0f) {
                                            phi_7910_ = -(_e5030);
                                        } else {
                                            phi_7910_ = _e5030;
                                        }
                                        let _e5131 = phi_7910_;
                                        let _e5132 = ((_e5122 + _e5126) + _e5131);
                                        let _e5137 = -(_e5118);
                                        if (_e5097 > _e5137) {
                                            phi_7921_ = _e5097;
                                        } else {
                                            phi_7921_ = _e5137;
                                        }
                                        let _e5140 = phi_7921_;
                                        let _e5145 = (((_e5140 - ((_e5132 * _e5014) * (0.000000059604645f * (17f / 2f)))) - (_e5132 * _e5021)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        let _e5148 = ((_e4782 * _e4776) - (_e4785 * _e4775));
                                        let _e5151 = ((_e4785 * _e4774) - (_e4779 * _e4776));
                                        let _e5154 = ((_e4779 * _e4775) - (_e4782 * _e4774));
                                        let _e5159 = (((_e5148 * _e4788[0]) + (_e5151 * _e4788[1])) + (_e5154 * _e4788[2]));
                                        let _e5164 = (((_e5148 * _e4805) + (_e5151 * _e4806)) + (_e5154 * _e4807));
                                        let _e5169 = (((_e5148 * _e4815) + (_e5151 * _e4816)) + (_e5154 * _e4817));
                                        let _e5177 = (((_e5148 * _e4814[0]) + (_e5151 * _e4814[1])) + (_e5154 * _e4814[2]));
                                        let _e5182 = (((_e5148 * _e4820[0]) + (_e5151 * _e4820[1])) + (_e5154 * _e4820[2]));
                                        let _e5187 = (((_e5148 * _e4837) + (_e5151 * _e4838)) + (_e5154 * _e4839));
                                        let _e5192 = (((_e5148 * _e4847) + (_e5151 * _e4848)) + (_e5154 * _e4849));
                                        let _e5200 = (((_e5148 * _e4846[0]) + (_e5151 * _e4846[1])) + (_e5154 * _e4846[2]));
                                        if (_e5159 < _e5164) {
                                            phi_7992_ = _e5159;
                                        } else {
                                            phi_7992_ = _e5164;
                                        }
                                        let _e5203 = phi_7992_;
                                        if (_e5169 < _e5177) {
                                            phi_7997_ = _e5169;
                                        } else {
                                            phi_7997_ = _e5177;
                                        }
                                        let _e5206 = phi_7997_;
                                        if (_e5203 < _e5206) {
                                            phi_8002_ = _e5203;
                                        } else {
                                            phi_8002_ = _e5206;
                                        }
                                        let _e5209 = phi_8002_;
                                        if (_e5182 < _e5187) {
                                            phi_8007_ = _e5182;
                                        } else {
                                            phi_8007_ = _e5187;
                                        }
                                        let _e5212 = phi_8007_;
                                        if (_e5192 < _e5200) {
                                            phi_8012_ = _e5192;
                                        } else {
                                            phi_8012_ = _e5200;
                                        }
                                        let _e5215 = phi_8012_;
                                        if (_e5212 < _e5215) {
                                            phi_8017_ = _e5212;
                                        } else {
                                            phi_8017_ = _e5215;
                                        }
                                        let _e5218 = phi_8017_;
                                        if (_e5209 < _e5218) {
                                            phi_8022_ = _e5209;
                                        } else {
                                            phi_8022_ = _e5218;
                                        }
                                        let _e5221 = phi_8022_;
                                        if (_e5159 > _e5164) {
                                            phi_8027_ = _e5159;
                                        } else {
                                            phi_8027_ = _e5164;
                                        }
                                        let _e5224 = phi_8027_;
                                        if (_e5169 > _e5177) {
                                            phi_8032_ = _e5169;
                                        } else {
                                            phi_8032_ = _e5177;
                                        }
                                        let _e5227 = phi_8032_;
                                        if (_e5224 > _e5227) {
                                            phi_8037_ = _e5224;
                                        } else {
                                            phi_8037_ = _e5227;
                                        }
                                        let _e5230 = phi_8037_;
                                        if (_e5182 > _e5187) {
                                            phi_8042_ = _e5182;
                                        } else {
                                            phi_8042_ = _e5187;
                                        }
                                        let _e5233 = phi_8042_;
                                        if (_e5192 > _e5200) {
                                            phi_8047_ = _e5192;
                                        } else {
                                            phi_8047_ = _e5200;
                                        }
                                        let _e5236 = phi_8047_;
                                        if (_e5233 > _e5236) {
                                            phi_8052_ = _e5233;
                                        } else {
                                            phi_8052_ = _e5236;
                                        }
                                        let _e5239 = phi_8052_;
                                        if (_e5230 > _e5239) {
                                            phi_8057_ = _e5230;
                                        } else {
                                            phi_8057_ = _e5239;
                                        }
                                        let _e5242 = phi_8057_;
                                        if (_e5148 < 0f) {
                                            phi_8063_ = -(_e5148);
                                        } else {
                                            phi_8063_ = _e5148;
                                        }
                                        let _e5246 = phi_8063_;
                                        if (_e5151 < 0f) {
                                            phi_8069_ = -(_e5151);
                                        } else {
                                            phi_8069_ = _e5151;
                                        }
                                        let _e5250 = phi_8069_;
                                        if (_e5154 < 0f) {
                                            phi_8076_ = -(_e5154);
                                        } else {
                                            phi_8076_ = _e5154;
                                        }
                                        let _e5255 = phi_8076_;
                                        let _e5256 = ((_e5246 + _e5250) + _e5255);
                                        let _e5261 = -(_e5242);
                                        if (_e5221 > _e5261) {
                                            phi_8087_ = _e5221;
                                        } else {
                                            phi_8087_ = _e5261;
                                        }
                                        let _e5264 = phi_8087_;
                                        let _e5269 = (((_e5264 - ((_e5256 * _e5014) * (0.000000059604645f * (17f / 2f)))) - (_e5256 * _e5021)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                        if (_e5145 > _e5269) {
                                            phi_8097_ = _e5145;
                                        } else {
                                            phi_8097_ = _e5269;
                                        }
                                        let _e5272 = phi_8097_;
                                        if (_e2990.member == 0u) {
                                            let _e5274 = (_e4774 - _e4759);
                                            let _e5275 = (_e4775 - _e4760);
                                            let _e5276 = (_e4776 - _e4761);
                                            let _e5279 = ((_e4782 * _e5276) - (_e4785 * _e5275));
                                            let _e5282 = ((_e4785 * _e5274) - (_e4779 * _e5276));
                                            let _e5285 = ((_e4779 * _e5275) - (_e4782 * _e5274));
                                            let _e5290 = (((_e5279 * _e4788[0]) + (_e5282 * _e4788[1])) + (_e5285 * _e4788[2]));
                                            let _e5295 = (((_e5279 * _e4805) + (_e5282 * _e4806)) + (_e5285 * _e4807));
                                            let _e5300 = (((_e5279 * _e4815) + (_e5282 * _e4816)) + (_e5285 * _e4817));
                                            let _e5308 = (((_e5279 * _e4814[0]) + (_e5282 * _e4814[1])) + (_e5285 * _e4814[2]));
                                            let _e5313 = (((_e5279 * _e4820[0]) + (_e5282 * _e4820[1])) + (_e5285 * _e4820[2]));
                                            let _e5318 = (((_e5279 * _e4837) + (_e5282 * _e4838)) + (_e5285 * _e4839));
                                            let _e5323 = (((_e5279 * _e4847) + (_e5282 * _e4848)) + (_e5285 * _e4849));
                                            let _e5331 = (((_e5279 * _e4846[0]) + (_e5282 * _e4846[1])) + (_e5285 * _e4846[2]));
                                            if (_e5290 < _e5295) {
                                                phi_8170_ = _e5290;
                                            } else {
                                                phi_8170_ = _e5295;
                                            }
                                            let _e5334 = phi_8170_;
                                            if (_e5300 < _e5308) {
                                                phi_8175_ = _e5300;
                                            } else {
                                                phi_8175_ = _e5308;
                                            }
                                            let _e5337 = phi_8175_;
                                            if (_e5334 < _e5337) {
                                                phi_8180_ = _e5334;
                                            } else {
                                                phi_8180_ = _e5337;
                                            }
                                            let _e5340 = phi_8180_;
                                            if (_e5313 < _e5318) {
                                                phi_8185_ = _e5313;
                                            } else {
                                                phi_8185_ = _e5318;
                                            }
                                            let _e5343 = phi_8185_;
                                            if (_e5323 < _e5331) {
                                                phi_8190_ = _e5323;
                                            } else {
                                                phi_8190_ = _e5331;
                                            }
                                            let _e5346 = phi_8190_;
                                            if (_e5343 < _e5346) {
                                                phi_8195_ = _e5343;
                                            } else {
                                                phi_8195_ = _e5346;
                                            }
                                            let _e5349 = phi_8195_;
                                            if (_e5340 < _e5349) {
                                                phi_8200_ = _e5340;
                                            } else {
                                                phi_8200_ = _e5349;
                                            }
                                            let _e5352 = phi_8200_;
                                            if (_e5290 > _e5295) {
                                                phi_8205_ = _e5290;
                                            } else {
                                                phi_8205_ = _e5295;
                                            }
                                            let _e5355 = phi_8205_;
                                            if (_e5300 > _e5308) {
                                                phi_8210_ = _e5300;
                                            } else {
                                                phi_8210_ = _e5308;
                                            }
                                            let _e5358 = phi_8210_;
                                            if (_e5355 > _e5358) {
                                                phi_8215_ = _e5355;
                                            } else {
                                                phi_8215_ = _e5358;
                                            }
                                            let _e5361 = phi_8215_;
                                            if (_e5313 > _e5318) {
                                                phi_8220_ = _e5313;
                                            } else {
                                                phi_8220_ = _e5318;
                                            }
                                            let _e5364 = phi_8220_;
                                            if (_e5323 > _e5331) {
                                                phi_8225_ = _e5323;
                                            } else {
                                                phi_8225_ = _e5331;
                                            }
                                            let _e5367 = phi_8225_;
                                            if (_e5364 > _e5367) {
                                                phi_8230_ = _e5364;
                                            } else {
                                                phi_8230_ = _e5367;
                                            }
                                            let _e5370 = phi_8230_;
                                            if (_e5361 > _e5370) {
                                                phi_8235_ = _e5361;
                                            } else {
                                                phi_8235_ = _e5370;
                                            }
                                            let _e5373 = phi_8235_;
                                            if (_e5279 < 0f) {
                                                phi_8241_ = -(_e5279);
                                            } else {
                                                phi_8241_ = _e5279;
                                            }
                                            let _e5377 = phi_8241_;
                                            if (_e5282 < 0f) {
                                                phi_8247_ = -(_e5282);
                                            } else {
                                                phi_8247_ = _e5282;
                                            }
                                            let _e5381 = phi_8247_;
                                            if (_e5285 < 0f) {
                                                phi_8254_ = -(_e5285);
                                            } else {
                                                phi_8254_ = _e5285;
                                            }
                                            let _e5386 = phi_8254_;
                                            let _e5387 = ((_e5377 + _e5381) + _e5386);
                                            let _e5392 = -(_e5373);
                                            if (_e5352 > _e5392) {
                                                phi_8265_ = _e5352;
                                            } else {
                                                phi_8265_ = _e5392;
                                            }
                                            let _e5395 = phi_8265_;
                                            let _e5400 = (((_e5395 - ((_e5387 * _e5014) * (0.000000059604645f * (17f / 2f)))) - (_e5387 * _e5021)) - (0.000000000000000000000000000000000000011754944f * 64f));
                                            if (_e5272 > _e5400) {
                                                phi_8275_ = _e5272;
                                            } else {
                                                phi_8275_ = _e5400;
                                            }
                                            let _e5403 = phi_8275_;
                                            phi_8276_ = _e5403;
                                        } else {
                                            phi_8276_ = _e5272;
                                        }
                                        let _e5405 = phi_8276_;
                                        phi_8279_ = (_e4746 || (_e5405 > 0f));
                                    }
                                    let _e5409 = phi_8279_;
                                    phi_8281_ = (_e4311 && _e5409);
                                } else {
                                    phi_8281_ = _e4311;
                                }
                                let _e5412 = phi_8281_;
                                if !(_e5412) {
                                    let _e5415 = atomicAdd((&counters[7u]), 1u);
                                    hits[_e2954] = ((2147483648u | (_e5415 << bitcast<u32>(12i))) | _e2957);
                                }
                                phi_8292_ = true;
                            }
                            let _e5422 = phi_8292_;
                            phi_8293_ = _e5422;
                        } else {
                            phi_8293_ = false;
                        }
                        let _e5424 = phi_8293_;
                        continue;
                        continuing {
                            phi_4710_ = _e2946;
                            break if !(_e5424);
                        }
                    }
                    let _e5428 = params.member.member_1.member_3;
                    workgroupBarrier();
                    if (_e73 == 0u) {
                        let _e5431 = atomicLoad((&counters[7u]));
                        if (_e5431 > 0u) {
                            let _e5434 = atomicAdd((&output.member[0u]), _e5431);
                            if ((_e5434 + _e5431) < _e5434) {
                                let _e5438 = atomicAdd((&output.member[2u]), 1u);
                            }
                            atomicStore((&counters[8u]), _e5434);
                        }
                        atomicStore((&counters[5u]), 0u);
                        atomicStore((&counters[6u]), 0u);
                        atomicStore((&counters[7u]), 0u);
                    }
                    workgroupBarrier();
                    let _e5444 = atomicLoad((&counters[8u]));
                    phi_8329_ = type_9(0u, 4u);
                    loop {
                        let _e5446 = phi_8329_;
                        if (_e5446.member < _e5446.member_1) {
                            phi_8330_ = type_9((_e5446.member + 1u), _e5446.member_1);
                            phi_8353_ = type_9(1u, _e5446.member);
                        } else {
                            phi_8330_ = _e5446;
                            phi_8353_ = type_9(0u, type_9().member_1);
                        }
                        let _e5458 = phi_8330_;
                        let _e5460 = phi_8353_;
                        if (bitcast<i32>(_e5460.member) != 0i) {
                            let _e5466 = (_e73 + (_e5460.member_1 * 128u));
                            if (_e5466 >= _e2932) {
                                phi_8448_ = false;
                            } else {
                                let _e5469 = hits[_e5466];
                                if ((_e5469 & 2147483648u) == 0u) {
                                    phi_8377_ = 4294967295u;
                                } else {
                                    phi_8377_ = ((_e5469 & 2147483647u) >> bitcast<u32>(12i));
                                }
                                let _e5476 = phi_8377_;
                                if (_e5476 != 4294967295u) {
                                    let _e5480 = ((_e5469 >> bitcast<u32>(10i)) & 3u);
                                    let _e5487 = firsts[(2u * _e5480)];
                                    let _e5492 = firsts[((2u * _e5480) + 1u)];
                                    let _e5495 = leaves.member[(_e5487 + ((_e5469 >> bitcast<u32>(5i)) & 31u))];
                                    let _e5498 = leaves.member[(_e5492 + (_e5469 & 31u))];
                                    let _e5500 = (_e5444 + _e5476);
                                    if (_e5495.w < _e5498.w) {
                                        phi_8429_ = type_9(_e5495.w, _e5498.w);
                                    } else {
                                        phi_8429_ = type_9(_e5498.w, _e5495.w);
                                    }
                                    let _e5505 = phi_8429_;
                                    if (_e5500 < _e5428) {
                                        let _e5509 = (2u * _e5500);
                                        atomicStore((&output.member[(4u + _e5509)]), _e5505.member);
                                        atomicStore((&output.member[(_e5509 + 5u)]), _e5505.member_1);
                                    }
                                }
                                phi_8448_ = true;
                            }
                            let _e5515 = phi_8448_;
                            phi_8449_ = _e5515;
                        } else {
                            phi_8449_ = false;
                        }
                        let _e5517 = phi_8449_;
                        continue;
                        continuing {
                            phi_8329_ = _e5458;
                            break if !(_e5517);
                        }
                    }
                    workgroupBarrier();
                    let _e6121 = local_8;
                    phi_1245_ = _e6121;
                } else {
                    phi_1245_ = type_9();
                }
                let _e5520 = phi_1245_;
                continue;
                continuing {
                    phi_1241_ = _e677;
                    phi_1244_ = _e5520;
                    break if !(_e683);
                }
            }
        }
        continue;
        continuing {
            phi_478_ = _e163;
            break if !(_e169);
        }
    }
    if (_e73 == 0u) {
        let _e5525 = atomicLoad((&counters[9u]));
        if (_e5525 > 0u) {
            let _e5528 = atomicAdd((&output.member[1u]), _e5525);
            if ((_e5528 + _e5525) < _e5528) {
                let _e5532 = atomicAdd((&output.member[3u]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn filter_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_8(id, n, lane);
}
