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

struct type_14 {
    member: i32,
    member_1: i32,
}

struct type_15 {
    member: u32,
    member_1: i32,
}

struct type_17 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_19 {
    member: array<type_17>,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_22 {
    member: u32,
}

struct type_23 {
    member: type_7,
    member_1: type_8,
    member_2: type_22,
}

struct type_24 {
    member: type_23,
}

struct type_26 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

struct type_29 {
    member: array<array<u32, 3>>,
}

struct type_31 {
    member: f32,
    member_1: f32,
}

struct type_34 {
    member: u32,
    member_1: f32,
}

struct type_35 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_36 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_39 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_19;
@group(0) @binding(0) 
var<storage> params: type_24;
@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_39;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_39;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_39;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> elements: type_29;

fn function_(param: array<f32, 3>, param_1: array<f32, 3>) -> array<f32, 3> {
    var phi_675_: array<f32, 3>;

    if ((((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2])) < (((param[0] * param[0]) + (param[1] * param[1])) + (param[2] * param[2]))) {
        phi_675_ = param_1;
    } else {
        phi_675_ = param;
    }
    let _e26 = phi_675_;
    return _e26;
}

fn function_1(param_2: array<f32, 3>, param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: u32) -> array<f32, 3> {
    var phi_267_: bool;
    var phi_268_: bool;
    var phi_269_: bool;
    var phi_270_: bool;
    var phi_274_: bool;
    var phi_247_: bool;
    var phi_248_: bool;
    var phi_249_: bool;
    var phi_250_: bool;
    var phi_251_: bool;
    var phi_252_: bool;
    var phi_256_: bool;
    var phi_275_: bool;
    var phi_305_: array<f32, 3>;
    var phi_306_: bool;
    var phi_307_: array<f32, 3>;
    var phi_308_: bool;
    var phi_535_: f32;
    var phi_536_: f32;
    var phi_575_: f32;
    var phi_576_: f32;
    var phi_621_: f32;
    var phi_622_: f32;
    var phi_356_: f32;
    var phi_357_: f32;
    var phi_402_: f32;
    var phi_403_: f32;
    var phi_445_: f32;
    var phi_446_: f32;
    var phi_494_: f32;
    var phi_495_: f32;
    var phi_637_: array<array<f32, 3>, 4>;
    var phi_645_: array<f32, 3>;

    let _e21 = (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2]));
    let _e32 = (((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2]));
    let _e43 = (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2]));
    let _e54 = (((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2]));
    let _e65 = (((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2]));
    let _e68 = ((_e21 * _e43) - (_e32 * _e32));
    let _e72 = (((_e54 * _e43) - (_e65 * _e32)) / _e68);
    let _e76 = (((_e65 * _e21) - (_e54 * _e32)) / _e68);
    if (param_5 != 0u) {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                if (_e72 <= 1f) {
                    phi_247_ = (_e76 <= 1f);
                    phi_248_ = false;
                } else {
                    phi_247_ = bool();
                    phi_248_ = true;
                }
                let _e97 = phi_247_;
                let _e99 = phi_248_;
                phi_249_ = _e97;
                phi_250_ = _e99;
            } else {
                phi_249_ = bool();
                phi_250_ = true;
            }
            let _e101 = phi_249_;
            let _e103 = phi_250_;
            phi_251_ = _e101;
            phi_252_ = _e103;
        } else {
            phi_251_ = bool();
            phi_252_ = true;
        }
        let _e105 = phi_251_;
        let _e107 = phi_252_;
        if _e107 {
            phi_256_ = false;
        } else {
            phi_256_ = _e105;
        }
        let _e109 = phi_256_;
        phi_275_ = _e109;
    } else {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                phi_267_ = ((_e72 + _e76) <= 1f);
                phi_268_ = false;
            } else {
                phi_267_ = bool();
                phi_268_ = true;
            }
            let _e83 = phi_267_;
            let _e85 = phi_268_;
            phi_269_ = _e83;
            phi_270_ = _e85;
        } else {
            phi_269_ = bool();
            phi_270_ = true;
        }
        let _e87 = phi_269_;
        let _e89 = phi_270_;
        if _e89 {
            phi_274_ = false;
        } else {
            phi_274_ = _e87;
        }
        let _e91 = phi_274_;
        phi_275_ = _e91;
    }
    let _e111 = phi_275_;
    if (_e68 > 0f) {
        if _e111 {
            phi_305_ = array<f32, 3>((param_2[0] - ((param_3[0] * _e72) + (param_4[0] * _e76))), (param_2[1] - ((param_3[1] * _e72) + (param_4[1] * _e76))), (param_2[2] - ((param_3[2] * _e72) + (param_4[2] * _e76))));
            phi_306_ = false;
        } else {
            phi_305_ = array<f32, 3>();
            phi_306_ = true;
        }
        let _e136 = phi_305_;
        let _e138 = phi_306_;
        phi_307_ = _e136;
        phi_308_ = _e138;
    } else {
        phi_307_ = array<f32, 3>();
        phi_308_ = true;
    }
    let _e140 = phi_307_;
    let _e142 = phi_308_;
    if _e142 {
        let _e145 = (param_2[0] - param_3[0]);
        let _e148 = (param_2[1] - param_3[1]);
        let _e151 = (param_2[2] - param_3[2]);
        if (param_5 != 0u) {
            let _e293 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
            if (_e293 > 0f) {
                if (_e293 < 1f) {
                    phi_356_ = _e293;
                } else {
                    phi_356_ = 1f;
                }
                let _e297 = phi_356_;
                phi_357_ = _e297;
            } else {
                phi_357_ = 0f;
            }
            let _e299 = phi_357_;
            let _e335 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e335 > 0f) {
                if (_e335 < 1f) {
                    phi_402_ = _e335;
                } else {
                    phi_402_ = 1f;
                }
                let _e339 = phi_402_;
                phi_403_ = _e339;
            } else {
                phi_403_ = 0f;
            }
            let _e341 = phi_403_;
            let _e374 = ((((_e145 * param_4[0]) + (_e148 * param_4[1])) + (_e151 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e374 > 0f) {
                if (_e374 < 1f) {
                    phi_445_ = _e374;
                } else {
                    phi_445_ = 1f;
                }
                let _e378 = phi_445_;
                phi_446_ = _e378;
            } else {
                phi_446_ = 0f;
            }
            let _e380 = phi_446_;
            let _e393 = (param_2[0] - param_4[0]);
            let _e396 = (param_2[1] - param_4[1]);
            let _e399 = (param_2[2] - param_4[2]);
            let _e419 = ((((_e393 * param_3[0]) + (_e396 * param_3[1])) + (_e399 * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
            if (_e419 > 0f) {
                if (_e419 < 1f) {
                    phi_494_ = _e419;
                } else {
                    phi_494_ = 1f;
                }
                let _e423 = phi_494_;
                phi_495_ = _e423;
            } else {
                phi_495_ = 0f;
            }
            let _e425 = phi_495_;
            phi_637_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e299)), (param_2[1] - (param_3[1] * _e299)), (param_2[2] - (param_3[2] * _e299))), array<f32, 3>((param_2[0] - (param_4[0] * _e341)), (param_2[1] - (param_4[1] * _e341)), (param_2[2] - (param_4[2] * _e341))), array<f32, 3>((_e145 - (param_4[0] * _e380)), (_e148 - (param_4[1] * _e380)), (_e151 - (param_4[2] * _e380))), array<f32, 3>((_e393 - (param_3[0] * _e425)), (_e396 - (param_3[1] * _e425)), (_e399 - (param_3[2] * _e425))));
        } else {
            let _e155 = (param_4[0] - param_3[0]);
            let _e158 = (param_4[1] - param_3[1]);
            let _e161 = (param_4[2] - param_3[2]);
            let _e172 = ((((_e145 * _e155) + (_e148 * _e158)) + (_e151 * _e161)) / (((_e155 * _e155) + (_e158 * _e158)) + (_e161 * _e161)));
            if (_e172 > 0f) {
                if (_e172 < 1f) {
                    phi_535_ = _e172;
                } else {
                    phi_535_ = 1f;
                }
                let _e176 = phi_535_;
                phi_536_ = _e176;
            } else {
                phi_536_ = 0f;
            }
            let _e178 = phi_536_;
            let _e185 = array<f32, 3>((_e145 - (_e155 * _e178)), (_e148 - (_e158 * _e178)), (_e151 - (_e161 * _e178)));
            let _e208 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
            if (_e208 > 0f) {
                if (_e208 < 1f) {
                    phi_575_ = _e208;
                } else {
                    phi_575_ = 1f;
                }
                let _e212 = phi_575_;
                phi_576_ = _e212;
            } else {
                phi_576_ = 0f;
            }
            let _e214 = phi_576_;
            let _e250 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e250 > 0f) {
                if (_e250 < 1f) {
                    phi_621_ = _e250;
                } else {
                    phi_621_ = 1f;
                }
                let _e254 = phi_621_;
                phi_622_ = _e254;
            } else {
                phi_622_ = 0f;
            }
            let _e256 = phi_622_;
            phi_637_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e214)), (param_2[1] - (param_3[1] * _e214)), (param_2[2] - (param_3[2] * _e214))), array<f32, 3>((param_2[0] - (param_4[0] * _e256)), (param_2[1] - (param_4[1] * _e256)), (param_2[2] - (param_4[2] * _e256))), _e185, _e185);
        }
        let _e438 = phi_637_;
        let _e441 = function_(_e438[0], _e438[1]);
        let _e443 = function_(_e441, _e438[2]);
        let _e445 = function_(_e443, _e438[3]);
        phi_645_ = _e445;
    } else {
        phi_645_ = _e140;
    }
    let _e447 = phi_645_;
    return _e447;
}

fn function_2(param_6: f32) -> array<u32, 2> {
    var phi_696_: array<u32, 2>;
    var phi_697_: array<u32, 2>;
    var phi_698_: bool;
    var phi_702_: array<u32, 2>;

    let _e13 = bitcast<u32>(param_6);
    if (_e13 < 8388608u) {
        phi_697_ = array<u32, 2>();
        phi_698_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_696_ = array<u32, 2>();
        } else {
            phi_696_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_696_;
        phi_697_ = _e31;
        phi_698_ = _e17;
    }
    let _e33 = phi_697_;
    let _e35 = phi_698_;
    if _e35 {
        phi_702_ = array<u32, 2>(0u, 0u);
    } else {
        phi_702_ = _e33;
    }
    let _e37 = phi_702_;
    return _e37;
}

fn function_3(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<array<f32, 3>, 4>;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: type_27;
    var local_3: type_27;
    var local_4: type_27;
    var local_5: array<type_31, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: array<f32, 4>;
    var local_9: array<array<f32, 3>, 4>;
    var local_10: array<array<f32, 3>, 4>;
    var local_11: array<f32, 3>;
    var local_12: type_26;
    var phi_755_: u32;
    var phi_771_: u32;
    var phi_792_: u32;
    var phi_793_: u32;
    var phi_796_: type_9;
    var phi_797_: type_9;
    var phi_820_: type_9;
    var phi_1258_: f32;
    var phi_1265_: f32;
    var phi_1270_: f32;
    var phi_1277_: f32;
    var phi_1282_: f32;
    var phi_1295_: f32;
    var phi_1302_: f32;
    var phi_1307_: f32;
    var phi_1314_: f32;
    var phi_1319_: f32;
    var phi_1324_: f32;
    var phi_1341_: f32;
    var phi_1348_: f32;
    var phi_1353_: f32;
    var phi_1360_: f32;
    var phi_1365_: f32;
    var phi_1379_: f32;
    var phi_1386_: f32;
    var phi_1391_: f32;
    var phi_1398_: f32;
    var phi_1403_: f32;
    var phi_1408_: f32;
    var phi_1425_: f32;
    var phi_1432_: f32;
    var phi_1437_: f32;
    var phi_1444_: f32;
    var phi_1449_: f32;
    var phi_1463_: f32;
    var phi_1470_: f32;
    var phi_1475_: f32;
    var phi_1482_: f32;
    var phi_1487_: f32;
    var phi_1492_: f32;
    var phi_1523_: f32;
    var phi_1529_: f32;
    var phi_1536_: f32;
    var phi_1543_: f32;
    var phi_1549_: f32;
    var phi_1556_: f32;
    var phi_1562_: f32;
    var phi_1568_: f32;
    var phi_1574_: f32;
    var phi_1581_: f32;
    var phi_1588_: f32;
    var phi_1612_: f32;
    var phi_1617_: f32;
    var phi_1622_: f32;
    var phi_1627_: f32;
    var phi_1632_: f32;
    var phi_1637_: f32;
    var phi_1647_: f32;
    var phi_3206_: f32;
    var phi_3212_: f32;
    var phi_3217_: f32;
    var phi_3223_: f32;
    var phi_3229_: f32;
    var phi_3234_: f32;
    var phi_3239_: f32;
    var phi_3247_: bool;
    var phi_3252_: f32;
    var phi_3259_: f32;
    var phi_3299_: type_14;
    var phi_3302_: f32;
    var phi_3323_: bool;
    var phi_3329_: type_15;
    var phi_3300_: type_14;
    var phi_3343_: type_15;
    var phi_3303_: f32;
    var local_13: f32;
    var phi_3292_: f32;
    var phi_3356_: f32;
    var phi_3362_: f32;
    var phi_3387_: type_9;
    var phi_3390_: u32;
    var phi_3388_: type_9;
    var phi_3413_: type_9;
    var phi_3457_: u32;
    var phi_3458_: u32;
    var phi_3391_: u32;
    var phi_3459_: u32;
    var phi_3479_: type_9;
    var phi_3480_: type_9;
    var phi_3503_: type_9;
    var phi_3555_: f32;
    var phi_3562_: f32;
    var phi_3573_: bool;
    var phi_3574_: bool;
    var phi_3575_: bool;
    var phi_3576_: bool;
    var phi_3580_: bool;
    var phi_3591_: type_35;
    var phi_3592_: type_35;
    var phi_3593_: bool;
    var phi_3594_: type_35;
    var phi_3595_: bool;
    var phi_3606_: f32;
    var phi_3616_: type_9;
    var phi_3619_: f32;
    var phi_3621_: f32;
    var phi_3623_: f32;
    var phi_3617_: type_9;
    var phi_3646_: type_9;
    var phi_3671_: f32;
    var phi_3672_: f32;
    var phi_3698_: f32;
    var phi_3714_: f32;
    var phi_3721_: bool;
    var phi_3722_: bool;
    var phi_3723_: bool;
    var phi_3729_: f32;
    var phi_3730_: f32;
    var phi_3731_: bool;
    var phi_3620_: f32;
    var phi_3622_: f32;
    var phi_3624_: f32;
    var phi_3732_: f32;
    var phi_3733_: bool;
    var phi_3734_: bool;
    var local_14: bool;
    var phi_3738_: f32;
    var phi_3739_: f32;
    var phi_3746_: type_9;
    var phi_3749_: f32;
    var phi_3747_: type_9;
    var phi_3772_: type_9;
    var phi_3813_: f32;
    var phi_3823_: f32;
    var phi_3831_: bool;
    var phi_3833_: bool;
    var phi_3838_: f32;
    var phi_3839_: bool;
    var phi_3840_: f32;
    var phi_3841_: bool;
    var phi_3842_: bool;
    var phi_3843_: bool;
    var phi_3844_: f32;
    var phi_3750_: f32;
    var phi_3845_: bool;
    var phi_3846_: bool;
    var phi_3847_: bool;
    var phi_3848_: bool;
    var local_15: bool;
    var phi_3852_: bool;
    var phi_3853_: bool;
    var phi_3857_: bool;
    var phi_3861_: f32;
    var phi_3862_: f32;
    var phi_3864_: type_35;
    var phi_3893_: f32;
    var phi_3900_: f32;
    var phi_3905_: f32;
    var phi_3912_: f32;
    var phi_3917_: f32;
    var phi_3930_: f32;
    var phi_3937_: f32;
    var phi_3942_: f32;
    var phi_3949_: f32;
    var phi_3954_: f32;
    var phi_3959_: f32;
    var phi_4018_: f32;
    var phi_4024_: f32;
    var phi_4029_: f32;
    var phi_4035_: f32;
    var phi_4040_: f32;
    var phi_4052_: f32;
    var phi_4058_: f32;
    var phi_4063_: f32;
    var phi_4069_: f32;
    var phi_4074_: f32;
    var phi_4100_: f32;
    var phi_4107_: f32;
    var phi_4112_: f32;
    var phi_4119_: f32;
    var phi_4124_: f32;
    var phi_4137_: f32;
    var phi_4144_: f32;
    var phi_4149_: f32;
    var phi_4156_: f32;
    var phi_4161_: f32;
    var phi_4166_: f32;
    var phi_4225_: f32;
    var phi_4231_: f32;
    var phi_4236_: f32;
    var phi_4242_: f32;
    var phi_4247_: f32;
    var phi_4259_: f32;
    var phi_4265_: f32;
    var phi_4270_: f32;
    var phi_4276_: f32;
    var phi_4281_: f32;
    var phi_4307_: f32;
    var phi_4314_: f32;
    var phi_4319_: f32;
    var phi_4326_: f32;
    var phi_4331_: f32;
    var phi_4344_: f32;
    var phi_4351_: f32;
    var phi_4356_: f32;
    var phi_4363_: f32;
    var phi_4368_: f32;
    var phi_4373_: f32;
    var phi_4432_: f32;
    var phi_4438_: f32;
    var phi_4443_: f32;
    var phi_4449_: f32;
    var phi_4454_: f32;
    var phi_4466_: f32;
    var phi_4472_: f32;
    var phi_4477_: f32;
    var phi_4483_: f32;
    var phi_4488_: f32;
    var phi_4537_: f32;
    var phi_4543_: f32;
    var phi_4571_: f32;
    var phi_4577_: f32;
    var phi_4582_: u32;
    var phi_4583_: u32;
    var phi_4553_: f32;
    var phi_4559_: f32;
    var phi_4564_: u32;
    var phi_4565_: u32;
    var phi_4584_: u32;
    var phi_4585_: u32;
    var phi_4652_: f32;
    var phi_4661_: f32;
    var phi_4792_: f32;
    var phi_4798_: f32;
    var phi_4805_: f32;
    var phi_4848_: type_9;
    var phi_4851_: bool;
    var phi_4849_: type_9;
    var phi_4874_: type_9;
    var phi_4901_: bool;
    var phi_4902_: bool;
    var phi_4852_: bool;
    var phi_4903_: bool;
    var phi_4904_: bool;
    var local_16: bool;
    var phi_4908_: bool;
    var local_17: bool;
    var phi_4915_: u32;
    var phi_4916_: u32;
    var phi_4917_: bool;
    var phi_4918_: u32;
    var phi_4919_: u32;
    var phi_4920_: bool;
    var phi_4924_: u32;
    var phi_4944_: bool;
    var phi_4945_: bool;
    var phi_4946_: bool;
    var phi_5142_: f32;
    var phi_5149_: f32;
    var phi_5154_: f32;
    var phi_5161_: f32;
    var phi_5166_: f32;
    var phi_5179_: f32;
    var phi_5186_: f32;
    var phi_5191_: f32;
    var phi_5198_: f32;
    var phi_5203_: f32;
    var phi_5208_: f32;
    var phi_5225_: f32;
    var phi_5232_: f32;
    var phi_5237_: f32;
    var phi_5244_: f32;
    var phi_5249_: f32;
    var phi_5263_: f32;
    var phi_5270_: f32;
    var phi_5275_: f32;
    var phi_5282_: f32;
    var phi_5287_: f32;
    var phi_5292_: f32;
    var phi_5309_: f32;
    var phi_5316_: f32;
    var phi_5321_: f32;
    var phi_5328_: f32;
    var phi_5333_: f32;
    var phi_5347_: f32;
    var phi_5354_: f32;
    var phi_5359_: f32;
    var phi_5366_: f32;
    var phi_5371_: f32;
    var phi_5376_: f32;
    var phi_5392_: type_9;
    var phi_5395_: f32;
    var phi_5393_: type_9;
    var phi_5418_: type_9;
    var phi_5529_: f32;
    var phi_5536_: f32;
    var phi_5544_: f32;
    var phi_5588_: type_14;
    var phi_5591_: f32;
    var phi_5612_: bool;
    var phi_5618_: type_15;
    var phi_5589_: type_14;
    var phi_5632_: type_15;
    var phi_5592_: f32;
    var local_18: f32;
    var phi_5581_: f32;
    var phi_5645_: f32;
    var phi_5654_: type_9;
    var phi_5657_: f32;
    var phi_5655_: type_9;
    var phi_5680_: type_9;
    var phi_5731_: f32;
    var phi_5737_: f32;
    var phi_5750_: bool;
    var phi_5751_: bool;
    var phi_5782_: f32;
    var phi_5783_: f32;
    var phi_5784_: f32;
    var phi_5785_: bool;
    var phi_5789_: bool;
    var phi_5790_: f32;
    var phi_5791_: bool;
    var phi_5792_: bool;
    var phi_5793_: bool;
    var phi_5794_: f32;
    var phi_5795_: bool;
    var phi_5796_: bool;
    var phi_5797_: bool;
    var phi_5658_: f32;
    var phi_5798_: bool;
    var phi_5799_: bool;
    var phi_5800_: bool;
    var phi_5801_: bool;
    var local_19: bool;
    var local_20: f32;
    var local_21: f32;
    var local_22: f32;
    var phi_5818_: bool;
    var phi_5819_: bool;
    var phi_5820_: bool;
    var phi_5821_: bool;
    var phi_5822_: bool;
    var phi_5823_: bool;
    var phi_5824_: bool;
    var phi_5825_: bool;
    var phi_5826_: bool;
    var phi_5827_: bool;
    var phi_5828_: bool;
    var phi_5829_: bool;
    var phi_5830_: bool;
    var phi_5831_: f32;
    var phi_5832_: f32;
    var phi_5833_: bool;
    var phi_5834_: bool;
    var phi_5835_: bool;
    var phi_5836_: bool;
    var phi_5837_: bool;
    var phi_5838_: bool;
    var phi_5839_: bool;
    var phi_5840_: f32;
    var phi_5841_: f32;
    var phi_5842_: bool;
    var phi_5843_: bool;
    var phi_5844_: bool;
    var phi_5845_: bool;
    var phi_5846_: bool;
    var phi_5847_: bool;
    var phi_5848_: bool;
    var phi_5849_: bool;
    var phi_5850_: f32;
    var phi_5396_: f32;
    var phi_5851_: bool;
    var phi_5852_: bool;
    var phi_5853_: bool;
    var phi_5854_: bool;
    var phi_5855_: bool;
    var phi_5856_: bool;
    var phi_5857_: bool;
    var phi_5858_: bool;
    var phi_5859_: bool;
    var local_23: bool;
    var phi_5864_: type_34;
    var phi_5865_: bool;
    var phi_5866_: bool;
    var phi_5867_: bool;
    var phi_5868_: bool;
    var phi_5869_: bool;
    var phi_5870_: bool;
    var phi_5871_: bool;
    var phi_5875_: f32;
    var phi_5876_: bool;
    var phi_5877_: bool;
    var phi_5878_: bool;
    var phi_5879_: bool;
    var phi_5880_: bool;
    var phi_5881_: bool;
    var phi_5882_: bool;
    var phi_5887_: type_34;
    var phi_5888_: bool;
    var phi_5889_: bool;
    var phi_5890_: bool;
    var phi_5891_: bool;
    var phi_5892_: bool;
    var phi_5893_: bool;
    var local_24: f32;
    var phi_5898_: type_34;
    var phi_5899_: bool;
    var phi_5900_: bool;
    var phi_5901_: bool;
    var phi_5902_: bool;
    var phi_5903_: bool;
    var local_25: f32;
    var phi_5908_: type_34;
    var phi_5909_: bool;
    var phi_5910_: bool;
    var phi_5911_: bool;
    var phi_5912_: bool;
    var local_26: f32;
    var phi_5917_: type_34;
    var phi_5918_: bool;
    var phi_5919_: bool;
    var phi_5920_: bool;
    var phi_5921_: bool;
    var phi_5925_: type_34;
    var phi_5926_: bool;
    var phi_5927_: bool;
    var phi_5928_: bool;
    var phi_5932_: bool;
    var phi_5933_: bool;
    var phi_5937_: bool;
    var phi_5938_: bool;
    var phi_5942_: bool;
    var phi_5943_: bool;
    var local_27: f32;
    var phi_5948_: type_34;
    var phi_5949_: bool;
    var phi_5953_: type_34;
    var phi_5960_: bool;
    var phi_5961_: f32;
    var phi_5962_: bool;
    var phi_5963_: bool;
    var phi_5964_: bool;
    var phi_5965_: f32;
    var phi_5966_: bool;
    var phi_5967_: bool;
    var phi_5968_: bool;
    var phi_5969_: f32;
    var phi_5970_: bool;
    var phi_5971_: bool;
    var phi_5972_: bool;
    var phi_5973_: bool;
    var phi_5977_: bool;
    var phi_5978_: bool;
    var phi_5979_: bool;
    var phi_5980_: f32;
    var phi_5981_: type_35;
    var phi_5982_: bool;
    var phi_5983_: bool;
    var phi_5984_: bool;
    var phi_5985_: bool;
    var local_28: bool;
    var phi_5990_: type_34;
    var phi_5991_: bool;
    var phi_5992_: bool;
    var local_29: f32;
    var phi_5997_: type_34;
    var phi_5998_: bool;
    var local_30: type_35;
    var phi_6004_: type_34;
    var phi_6005_: bool;
    var phi_6009_: type_34;
    var phi_1848_: f32;
    var phi_1855_: f32;
    var phi_1860_: f32;
    var phi_1867_: f32;
    var phi_1872_: f32;
    var phi_1885_: f32;
    var phi_1892_: f32;
    var phi_1897_: f32;
    var phi_1904_: f32;
    var phi_1909_: f32;
    var phi_1914_: f32;
    var phi_1931_: f32;
    var phi_1938_: f32;
    var phi_1943_: f32;
    var phi_1950_: f32;
    var phi_1955_: f32;
    var phi_1969_: f32;
    var phi_1976_: f32;
    var phi_1981_: f32;
    var phi_1988_: f32;
    var phi_1993_: f32;
    var phi_1998_: f32;
    var phi_2015_: f32;
    var phi_2022_: f32;
    var phi_2027_: f32;
    var phi_2034_: f32;
    var phi_2039_: f32;
    var phi_2053_: f32;
    var phi_2060_: f32;
    var phi_2065_: f32;
    var phi_2072_: f32;
    var phi_2077_: f32;
    var phi_2082_: f32;
    var phi_2098_: type_9;
    var phi_2101_: f32;
    var phi_2099_: type_9;
    var phi_2124_: type_9;
    var phi_2235_: f32;
    var phi_2242_: f32;
    var phi_2250_: f32;
    var phi_2294_: type_14;
    var phi_2297_: f32;
    var phi_2318_: bool;
    var phi_2324_: type_15;
    var phi_2295_: type_14;
    var phi_2338_: type_15;
    var phi_2298_: f32;
    var local_31: f32;
    var phi_2287_: f32;
    var phi_2351_: f32;
    var phi_2360_: type_9;
    var phi_2363_: f32;
    var phi_2361_: type_9;
    var phi_2386_: type_9;
    var phi_2437_: f32;
    var phi_2443_: f32;
    var phi_2456_: bool;
    var phi_2457_: bool;
    var phi_2488_: f32;
    var phi_2489_: f32;
    var phi_2490_: f32;
    var phi_2491_: bool;
    var phi_2495_: bool;
    var phi_2496_: f32;
    var phi_2497_: bool;
    var phi_2498_: bool;
    var phi_2499_: bool;
    var phi_2500_: f32;
    var phi_2501_: bool;
    var phi_2502_: bool;
    var phi_2503_: bool;
    var phi_2364_: f32;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2506_: bool;
    var phi_2507_: bool;
    var local_32: bool;
    var local_33: f32;
    var local_34: f32;
    var local_35: f32;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var phi_2527_: bool;
    var phi_2528_: bool;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var phi_2531_: bool;
    var phi_2532_: bool;
    var phi_2533_: bool;
    var phi_2534_: bool;
    var phi_2535_: bool;
    var phi_2536_: bool;
    var phi_2537_: f32;
    var phi_2538_: f32;
    var phi_2539_: bool;
    var phi_2540_: bool;
    var phi_2541_: bool;
    var phi_2542_: bool;
    var phi_2543_: bool;
    var phi_2544_: bool;
    var phi_2545_: bool;
    var phi_2546_: f32;
    var phi_2547_: f32;
    var phi_2548_: bool;
    var phi_2549_: bool;
    var phi_2550_: bool;
    var phi_2551_: bool;
    var phi_2552_: bool;
    var phi_2553_: bool;
    var phi_2554_: bool;
    var phi_2555_: bool;
    var phi_2556_: f32;
    var phi_2102_: f32;
    var phi_2557_: bool;
    var phi_2558_: bool;
    var phi_2559_: bool;
    var phi_2560_: bool;
    var phi_2561_: bool;
    var phi_2562_: bool;
    var phi_2563_: bool;
    var phi_2564_: bool;
    var phi_2565_: bool;
    var local_36: bool;
    var phi_2570_: type_34;
    var phi_2571_: bool;
    var phi_2572_: bool;
    var phi_2573_: bool;
    var phi_2574_: bool;
    var phi_2575_: bool;
    var phi_2576_: bool;
    var phi_2577_: bool;
    var phi_2581_: f32;
    var phi_2582_: bool;
    var phi_2583_: bool;
    var phi_2584_: bool;
    var phi_2585_: bool;
    var phi_2586_: bool;
    var phi_2587_: bool;
    var phi_2588_: bool;
    var phi_2593_: type_34;
    var phi_2594_: bool;
    var phi_2595_: bool;
    var phi_2596_: bool;
    var phi_2597_: bool;
    var phi_2598_: bool;
    var phi_2599_: bool;
    var local_37: f32;
    var phi_2604_: type_34;
    var phi_2605_: bool;
    var phi_2606_: bool;
    var phi_2607_: bool;
    var phi_2608_: bool;
    var phi_2609_: bool;
    var local_38: f32;
    var phi_2614_: type_34;
    var phi_2615_: bool;
    var phi_2616_: bool;
    var phi_2617_: bool;
    var phi_2618_: bool;
    var local_39: f32;
    var phi_2623_: type_34;
    var phi_2624_: bool;
    var phi_2625_: bool;
    var phi_2626_: bool;
    var phi_2627_: bool;
    var phi_2631_: type_34;
    var phi_2632_: bool;
    var phi_2633_: bool;
    var phi_2634_: bool;
    var phi_2638_: bool;
    var phi_2639_: bool;
    var phi_2643_: bool;
    var phi_2644_: bool;
    var phi_2648_: bool;
    var phi_2649_: bool;
    var local_40: f32;
    var phi_2654_: type_34;
    var phi_2655_: bool;
    var phi_2659_: type_34;
    var phi_2673_: type_9;
    var phi_2674_: type_9;
    var phi_2697_: type_9;
    var phi_2717_: f32;
    var phi_2847_: type_14;
    var phi_2850_: f32;
    var phi_2871_: bool;
    var phi_2877_: type_15;
    var phi_2848_: type_14;
    var phi_2891_: type_15;
    var phi_2851_: f32;
    var local_41: f32;
    var phi_2840_: f32;
    var phi_2904_: f32;
    var phi_2920_: f32;
    var phi_2927_: f32;
    var phi_2932_: f32;
    var phi_2939_: f32;
    var phi_2944_: f32;
    var phi_2957_: f32;
    var phi_2964_: f32;
    var phi_2969_: f32;
    var phi_2976_: f32;
    var phi_2981_: f32;
    var phi_2986_: f32;
    var phi_3003_: f32;
    var phi_3010_: f32;
    var phi_3015_: f32;
    var phi_3022_: f32;
    var phi_3027_: f32;
    var phi_3041_: f32;
    var phi_3048_: f32;
    var phi_3053_: f32;
    var phi_3060_: f32;
    var phi_3065_: f32;
    var phi_3070_: f32;
    var phi_3087_: f32;
    var phi_3094_: f32;
    var phi_3099_: f32;
    var phi_3106_: f32;
    var phi_3111_: f32;
    var phi_3125_: f32;
    var phi_3132_: f32;
    var phi_3137_: f32;
    var phi_3144_: f32;
    var phi_3149_: f32;
    var phi_3154_: f32;
    var phi_3174_: bool;
    var phi_3175_: bool;
    var phi_3176_: bool;
    var local_42: bool;
    var phi_3181_: type_34;
    var phi_3182_: bool;
    var phi_3187_: type_34;
    var phi_3188_: bool;
    var phi_3190_: type_34;
    var phi_3191_: type_34;
    var phi_3192_: bool;
    var phi_3196_: type_34;
    var phi_6013_: type_34;
    var phi_6014_: type_34;
    var phi_6027_: type_36;
    var phi_6034_: bool;
    var phi_6058_: u32;
    var phi_6062_: type_20;
    var phi_6063_: bool;
    var phi_6064_: bool;
    var phi_6083_: u32;
    var phi_6146_: u32;
    var local_43: u32;
    var local_44: f32;
    var local_45: f32;
    var local_46: bool;
    var local_47: bool;
    var local_48: f32;
    var local_49: bool;
    var local_50: bool;
    var local_51: f32;
    var local_52: f32;
    var local_53: bool;
    var local_54: bool;
    var local_55: bool;
    var local_56: bool;
    var local_57: bool;
    var local_58: bool;
    var local_59: bool;
    var local_60: f32;
    var local_61: f32;
    var local_62: bool;
    var local_63: bool;
    var local_64: bool;
    var local_65: bool;
    var local_66: bool;
    var local_67: f32;
    var local_68: f32;
    var local_69: bool;
    var local_70: bool;
    var local_71: bool;
    var local_72: bool;
    var local_73: bool;
    var local_74: bool;
    var local_75: bool;
    var local_76: f32;
    var local_77: f32;
    var local_78: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e92 = id_2;
    let _e93 = n_2;
    let _e94 = lane_2;
    let _e106 = ((_e92.y * _e93.x) + _e92.x);
    let _e109 = (_e93.x * _e93.y);
    let _e112 = params.member.member_1.member_2;
    let _e114 = input.member[0u];
    if (_e112 < _e114) {
        phi_755_ = _e112;
    } else {
        phi_755_ = _e114;
    }
    let _e117 = phi_755_;
    let _e118 = (_e117 / 64u);
    if ((_e117 % 64u) > 0u) {
        phi_771_ = (_e118 + 1u);
    } else {
        phi_771_ = _e118;
    }
    let _e123 = phi_771_;
    if (_e123 > _e106) {
        let _e125 = (_e123 - _e106);
        if (_e109 == 0u) {
            return;
        }
        let _e127 = (_e125 / _e109);
        if (_e109 == 0u) {
            return;
        }
        if ((_e125 % _e109) > 0u) {
            phi_792_ = (_e127 + 1u);
        } else {
            phi_792_ = _e127;
        }
        let _e133 = phi_792_;
        phi_793_ = _e133;
    } else {
        phi_793_ = 0u;
    }
    let _e135 = phi_793_;
    phi_796_ = type_9(0u, _e135);
    loop {
        let _e138 = phi_796_;
        if (_e138.member < _e138.member_1) {
            phi_797_ = type_9((_e138.member + 1u), _e138.member_1);
            phi_820_ = type_9(1u, _e138.member);
        } else {
            phi_797_ = _e138;
            phi_820_ = type_9(0u, type_9().member_1);
        }
        let _e150 = phi_797_;
        let _e152 = phi_820_;
        let _e156 = (bitcast<i32>(_e152.member) != 0i);
        if _e156 {
            let _e160 = (((_e106 + (_e152.member_1 * _e109)) * 64u) + _e94);
            if (_e160 < _e117) {
                let _e162 = (2u * _e160);
                let _e165 = input.member[(4u + _e162)];
                let _e168 = input.member[(_e162 + 5u)];
                let _e171 = elements.member[_e168];
                let _e176 = paths.member[_e165];
                let _e178 = paths.member[_e171[0]];
                let _e184 = paths.member[_e171[1]];
                let _e186 = paths.member[_e171[2]];
                let _e216 = params.member.member.member_4;
                local_12 = type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e176.member[0] - _e178.member[0]), (_e176.member[1] - _e178.member[1]), (_e176.member[2] - _e178.member[2])), array<f32, 3>((_e176.member_1[0] - _e178.member_1[0]), (_e176.member_1[1] - _e178.member_1[1]), (_e176.member_1[2] - _e178.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e184.member[0] - _e178.member[0]), (_e184.member[1] - _e178.member[1]), (_e184.member[2] - _e178.member[2])), array<f32, 3>((_e184.member_1[0] - _e178.member_1[0]), (_e184.member_1[1] - _e178.member_1[1]), (_e184.member_1[2] - _e178.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e186.member[0] - _e178.member[0]), (_e186.member[1] - _e178.member[1]), (_e186.member[2] - _e178.member[2])), array<f32, 3>((_e186.member_1[0] - _e178.member_1[0]), (_e186.member_1[1] - _e178.member_1[1]), (_e186.member_1[2] - _e178.member_1[2]))), (_e216 + _e216));
                let _e247 = params.member.member.member_5;
                let _e250 = local_12.member_1[0u];
                let _e256 = local_12.member_2[0u];
                let _e262 = ((_e250[1] * _e256[2]) - (_e250[2] * _e256[1]));
                let _e265 = ((_e250[2] * _e256[0]) - (_e250[0] * _e256[2]));
                let _e268 = ((_e250[0] * _e256[1]) - (_e250[1] * _e256[0]));
                let _e271 = local_12.member_1[1u];
                let _e277 = local_12.member_2[1u];
                let _e283 = ((_e271[1] * _e277[2]) - (_e271[2] * _e277[1]));
                let _e286 = ((_e271[2] * _e277[0]) - (_e271[0] * _e277[2]));
                let _e289 = ((_e271[0] * _e277[1]) - (_e271[1] * _e277[0]));
                let _e292 = local_12.member_1[0u];
                let _e298 = local_12.member_2[1u];
                let _e313 = local_12.member_1[1u];
                let _e319 = local_12.member_2[0u];
                let _e332 = (((_e292[1] * _e298[2]) - (_e292[2] * _e298[1])) + ((_e313[1] * _e319[2]) - (_e313[2] * _e319[1])));
                let _e333 = (((_e292[2] * _e298[0]) - (_e292[0] * _e298[2])) + ((_e313[2] * _e319[0]) - (_e313[0] * _e319[2])));
                let _e334 = (((_e292[0] * _e298[1]) - (_e292[1] * _e298[0])) + ((_e313[0] * _e319[1]) - (_e313[1] * _e319[0])));
                let _e337 = local_12.member[0u];
                let _e345 = (((_e337[0] * _e262) + (_e337[1] * _e265)) + (_e337[2] * _e268));
                let _e348 = local_12.member[1u];
                let _e359 = local_12.member[0u];
                let _e368 = ((((_e348[0] * _e262) + (_e348[1] * _e265)) + (_e348[2] * _e268)) + (((_e359[0] * _e332) + (_e359[1] * _e333)) + (_e359[2] * _e334)));
                let _e371 = local_12.member[0u];
                let _e382 = local_12.member[1u];
                let _e391 = ((((_e371[0] * _e283) + (_e371[1] * _e286)) + (_e371[2] * _e289)) + (((_e382[0] * _e332) + (_e382[1] * _e333)) + (_e382[2] * _e334)));
                let _e394 = local_12.member[1u];
                let _e402 = (((_e394[0] * _e283) + (_e394[1] * _e286)) + (_e394[2] * _e289));
                let _e405 = local_12.member[0u];
                if (_e405[0] < 0f) {
                    phi_1258_ = -(_e405[0]);
                } else {
                    phi_1258_ = _e405[0];
                }
                let _e412 = phi_1258_;
                if (_e405[1] < 0f) {
                    phi_1265_ = -(_e405[1]);
                } else {
                    phi_1265_ = _e405[1];
                }
                let _e416 = phi_1265_;
                if (_e412 > _e416) {
                    phi_1270_ = _e412;
                } else {
                    phi_1270_ = _e416;
                }
                let _e419 = phi_1270_;
                if (_e405[2] < 0f) {
                    phi_1277_ = -(_e405[2]);
                } else {
                    phi_1277_ = _e405[2];
                }
                let _e423 = phi_1277_;
                if (_e419 > _e423) {
                    phi_1282_ = _e419;
                } else {
                    phi_1282_ = _e423;
                }
                let _e426 = phi_1282_;
                let _e429 = local_12.member[1u];
                if (_e429[0] < 0f) {
                    phi_1295_ = -(_e429[0]);
                } else {
                    phi_1295_ = _e429[0];
                }
                let _e436 = phi_1295_;
                if (_e429[1] < 0f) {
                    phi_1302_ = -(_e429[1]);
                } else {
                    phi_1302_ = _e429[1];
                }
                let _e440 = phi_1302_;
                if (_e436 > _e440) {
                    phi_1307_ = _e436;
                } else {
                    phi_1307_ = _e440;
                }
                let _e443 = phi_1307_;
                if (_e429[2] < 0f) {
                    phi_1314_ = -(_e429[2]);
                } else {
                    phi_1314_ = _e429[2];
                }
                let _e447 = phi_1314_;
                if (_e443 > _e447) {
                    phi_1319_ = _e443;
                } else {
                    phi_1319_ = _e447;
                }
                let _e450 = phi_1319_;
                if (_e426 > _e450) {
                    phi_1324_ = _e426;
                } else {
                    phi_1324_ = _e450;
                }
                let _e453 = phi_1324_;
                let _e455 = local_12.member_3;
                let _e456 = (_e453 + _e455);
                let _e459 = local_12.member_1[0u];
                if (_e459[0] < 0f) {
                    phi_1341_ = -(_e459[0]);
                } else {
                    phi_1341_ = _e459[0];
                }
                let _e466 = phi_1341_;
                if (_e459[1] < 0f) {
                    phi_1348_ = -(_e459[1]);
                } else {
                    phi_1348_ = _e459[1];
                }
                let _e470 = phi_1348_;
                if (_e466 > _e470) {
                    phi_1353_ = _e466;
                } else {
                    phi_1353_ = _e470;
                }
                let _e473 = phi_1353_;
                if (_e459[2] < 0f) {
                    phi_1360_ = -(_e459[2]);
                } else {
                    phi_1360_ = _e459[2];
                }
                let _e477 = phi_1360_;
                if (_e473 > _e477) {
                    phi_1365_ = _e473;
                } else {
                    phi_1365_ = _e477;
                }
                let _e480 = phi_1365_;
                let _e483 = local_12.member_1[1u];
                if (_e483[0] < 0f) {
                    phi_1379_ = -(_e483[0]);
                } else {
                    phi_1379_ = _e483[0];
                }
                let _e490 = phi_1379_;
                if (_e483[1] < 0f) {
                    phi_1386_ = -(_e483[1]);
                } else {
                    phi_1386_ = _e483[1];
                }
                let _e494 = phi_1386_;
                if (_e490 > _e494) {
                    phi_1391_ = _e490;
                } else {
                    phi_1391_ = _e494;
                }
                let _e497 = phi_1391_;
                if (_e483[2] < 0f) {
                    phi_1398_ = -(_e483[2]);
                } else {
                    phi_1398_ = _e483[2];
                }
                let _e501 = phi_1398_;
                if (_e497 > _e501) {
                    phi_1403_ = _e497;
                } else {
                    phi_1403_ = _e501;
                }
                let _e504 = phi_1403_;
                if (_e480 > _e504) {
                    phi_1408_ = _e480;
                } else {
                    phi_1408_ = _e504;
                }
                let _e507 = phi_1408_;
                let _e509 = local_12.member_3;
                let _e510 = (_e507 + _e509);
                let _e513 = local_12.member_2[0u];
                if (_e513[0] < 0f) {
                    phi_1425_ = -(_e513[0]);
                } else {
                    phi_1425_ = _e513[0];
                }
                let _e520 = phi_1425_;
                if (_e513[1] < 0f) {
                    phi_1432_ = -(_e513[1]);
                } else {
                    phi_1432_ = _e513[1];
                }
                let _e524 = phi_1432_;
                if (_e520 > _e524) {
                    phi_1437_ = _e520;
                } else {
                    phi_1437_ = _e524;
                }
                let _e527 = phi_1437_;
                if (_e513[2] < 0f) {
                    phi_1444_ = -(_e513[2]);
                } else {
                    phi_1444_ = _e513[2];
                }
                let _e531 = phi_1444_;
                if (_e527 > _e531) {
                    phi_1449_ = _e527;
                } else {
                    phi_1449_ = _e531;
                }
                let _e534 = phi_1449_;
                let _e537 = local_12.member_2[1u];
                if (_e537[0] < 0f) {
                    phi_1463_ = -(_e537[0]);
                } else {
                    phi_1463_ = _e537[0];
                }
                let _e544 = phi_1463_;
                if (_e537[1] < 0f) {
                    phi_1470_ = -(_e537[1]);
                } else {
                    phi_1470_ = _e537[1];
                }
                let _e548 = phi_1470_;
                if (_e544 > _e548) {
                    phi_1475_ = _e544;
                } else {
                    phi_1475_ = _e548;
                }
                let _e551 = phi_1475_;
                if (_e537[2] < 0f) {
                    phi_1482_ = -(_e537[2]);
                } else {
                    phi_1482_ = _e537[2];
                }
                let _e555 = phi_1482_;
                if (_e551 > _e555) {
                    phi_1487_ = _e551;
                } else {
                    phi_1487_ = _e555;
                }
                let _e558 = phi_1487_;
                if (_e534 > _e558) {
                    phi_1492_ = _e534;
                } else {
                    phi_1492_ = _e558;
                }
                let _e561 = phi_1492_;
                let _e563 = local_12.member_3;
                let _e564 = (_e561 + _e563);
                let _e566 = ((_e510 * 8f) * _e564);
                let _e573 = local_12.member_3;
                if (_e262 < 0f) {
                    phi_1523_ = -(_e262);
                } else {
                    phi_1523_ = _e262;
                }
                let _e590 = phi_1523_;
                if (_e265 < 0f) {
                    phi_1529_ = -(_e265);
                } else {
                    phi_1529_ = _e265;
                }
                let _e594 = phi_1529_;
                if (_e268 < 0f) {
                    phi_1536_ = -(_e268);
                } else {
                    phi_1536_ = _e268;
                }
                let _e599 = phi_1536_;
                let _e600 = ((_e590 + _e594) + _e599);
                if (_e283 < 0f) {
                    phi_1543_ = -(_e283);
                } else {
                    phi_1543_ = _e283;
                }
                let _e604 = phi_1543_;
                if (_e286 < 0f) {
                    phi_1549_ = -(_e286);
                } else {
                    phi_1549_ = _e286;
                }
                let _e608 = phi_1549_;
                if (_e289 < 0f) {
                    phi_1556_ = -(_e289);
                } else {
                    phi_1556_ = _e289;
                }
                let _e613 = phi_1556_;
                let _e614 = ((_e604 + _e608) + _e613);
                if (_e600 > _e614) {
                    phi_1562_ = _e600;
                } else {
                    phi_1562_ = _e614;
                }
                let _e617 = phi_1562_;
                if (_e332 < 0f) {
                    phi_1568_ = -(_e332);
                } else {
                    phi_1568_ = _e332;
                }
                let _e621 = phi_1568_;
                if (_e333 < 0f) {
                    phi_1574_ = -(_e333);
                } else {
                    phi_1574_ = _e333;
                }
                let _e625 = phi_1574_;
                if (_e334 < 0f) {
                    phi_1581_ = -(_e334);
                } else {
                    phi_1581_ = _e334;
                }
                let _e630 = phi_1581_;
                let _e632 = (((_e621 + _e625) + _e630) * 0.5f);
                if (_e617 > _e632) {
                    phi_1588_ = _e617;
                } else {
                    phi_1588_ = _e632;
                }
                let _e635 = phi_1588_;
                let _e640 = local_12.member_3;
                let _e652 = (((((_e456 * 8f) * _e566) * (0.000000059604645f * (490f / 64f))) + ((_e573 * 19f) * ((_e456 * (_e510 + _e564)) + (_e510 * _e564)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e456) * ((1f + _e510) * (1f + _e564)))));
                let _e653 = (_e345 * 3f);
                let _e654 = (_e402 * 3f);
                if (_e653 < _e654) {
                    phi_1612_ = _e653;
                } else {
                    phi_1612_ = _e654;
                }
                let _e657 = phi_1612_;
                if (_e368 < _e391) {
                    phi_1617_ = _e368;
                } else {
                    phi_1617_ = _e391;
                }
                let _e660 = phi_1617_;
                if (_e657 < _e660) {
                    phi_1622_ = _e657;
                } else {
                    phi_1622_ = _e660;
                }
                let _e663 = phi_1622_;
                if (_e653 > _e654) {
                    phi_1627_ = _e653;
                } else {
                    phi_1627_ = _e654;
                }
                let _e666 = phi_1627_;
                if (_e368 > _e391) {
                    phi_1632_ = _e368;
                } else {
                    phi_1632_ = _e391;
                }
                let _e669 = phi_1632_;
                if (_e666 > _e669) {
                    phi_1637_ = _e666;
                } else {
                    phi_1637_ = _e669;
                }
                let _e672 = phi_1637_;
                let _e677 = -(_e672);
                if (_e663 > _e677) {
                    phi_1647_ = _e663;
                } else {
                    phi_1647_ = _e677;
                }
                let _e680 = phi_1647_;
                if ((_e680 - (_e652 + ((_e247 * (((_e635 + (_e566 * (0.000000059604645f * 4f))) + ((_e640 * 6f) * (_e510 + _e564))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e510) * (1f + _e564))))) * (3f * 1.0001f)))) > 0f) {
                    phi_6014_ = type_34(0u, type_34().member_1);
                } else {
                    if (_e247 > 0f) {
                        let _e2706 = local_12.member[0u];
                        let _e2712 = local_12.member_1[0u];
                        let _e2718 = local_12.member_2[0u];
                        local_9 = array<array<f32, 3>, 4>(_e2706, array<f32, 3>((_e2706[0] - _e2712[0]), (_e2706[1] - _e2712[1]), (_e2706[2] - _e2712[2])), array<f32, 3>((_e2706[0] - _e2718[0]), (_e2706[1] - _e2718[1]), (_e2706[2] - _e2718[2])), _e2706);
                        let _e2733 = local_12.member[1u];
                        let _e2739 = local_12.member_1[1u];
                        let _e2745 = local_12.member_2[1u];
                        local_10 = array<array<f32, 3>, 4>(_e2733, array<f32, 3>((_e2733[0] - _e2739[0]), (_e2733[1] - _e2739[1]), (_e2733[2] - _e2739[2])), array<f32, 3>((_e2733[0] - _e2745[0]), (_e2733[1] - _e2745[1]), (_e2733[2] - _e2745[2])), _e2733);
                        let _e2760 = local_12.member[0u];
                        if (_e2760[0] < 0f) {
                            phi_1848_ = -(_e2760[0]);
                        } else {
                            phi_1848_ = _e2760[0];
                        }
                        let _e2767 = phi_1848_;
                        if (_e2760[1] < 0f) {
                            phi_1855_ = -(_e2760[1]);
                        } else {
                            phi_1855_ = _e2760[1];
                        }
                        let _e2771 = phi_1855_;
                        if (_e2767 > _e2771) {
                            phi_1860_ = _e2767;
                        } else {
                            phi_1860_ = _e2771;
                        }
                        let _e2774 = phi_1860_;
                        if (_e2760[2] < 0f) {
                            phi_1867_ = -(_e2760[2]);
                        } else {
                            phi_1867_ = _e2760[2];
                        }
                        let _e2778 = phi_1867_;
                        if (_e2774 > _e2778) {
                            phi_1872_ = _e2774;
                        } else {
                            phi_1872_ = _e2778;
                        }
                        let _e2781 = phi_1872_;
                        let _e2784 = local_12.member[1u];
                        if (_e2784[0] < 0f) {
                            phi_1885_ = -(_e2784[0]);
                        } else {
                            phi_1885_ = _e2784[0];
                        }
                        let _e2791 = phi_1885_;
                        if (_e2784[1] < 0f) {
                            phi_1892_ = -(_e2784[1]);
                        } else {
                            phi_1892_ = _e2784[1];
                        }
                        let _e2795 = phi_1892_;
                        if (_e2791 > _e2795) {
                            phi_1897_ = _e2791;
                        } else {
                            phi_1897_ = _e2795;
                        }
                        let _e2798 = phi_1897_;
                        if (_e2784[2] < 0f) {
                            phi_1904_ = -(_e2784[2]);
                        } else {
                            phi_1904_ = _e2784[2];
                        }
                        let _e2802 = phi_1904_;
                        if (_e2798 > _e2802) {
                            phi_1909_ = _e2798;
                        } else {
                            phi_1909_ = _e2802;
                        }
                        let _e2805 = phi_1909_;
                        if (_e2781 > _e2805) {
                            phi_1914_ = _e2781;
                        } else {
                            phi_1914_ = _e2805;
                        }
                        let _e2808 = phi_1914_;
                        let _e2810 = local_12.member_3;
                        let _e2814 = local_12.member_1[0u];
                        if (_e2814[0] < 0f) {
                            phi_1931_ = -(_e2814[0]);
                        } else {
                            phi_1931_ = _e2814[0];
                        }
                        let _e2821 = phi_1931_;
                        if (_e2814[1] < 0f) {
                            phi_1938_ = -(_e2814[1]);
                        } else {
                            phi_1938_ = _e2814[1];
                        }
                        let _e2825 = phi_1938_;
                        if (_e2821 > _e2825) {
                            phi_1943_ = _e2821;
                        } else {
                            phi_1943_ = _e2825;
                        }
                        let _e2828 = phi_1943_;
                        if (_e2814[2] < 0f) {
                            phi_1950_ = -(_e2814[2]);
                        } else {
                            phi_1950_ = _e2814[2];
                        }
                        let _e2832 = phi_1950_;
                        if (_e2828 > _e2832) {
                            phi_1955_ = _e2828;
                        } else {
                            phi_1955_ = _e2832;
                        }
                        let _e2835 = phi_1955_;
                        let _e2838 = local_12.member_1[1u];
                        if (_e2838[0] < 0f) {
                            phi_1969_ = -(_e2838[0]);
                        } else {
                            phi_1969_ = _e2838[0];
                        }
                        let _e2845 = phi_1969_;
                        if (_e2838[1] < 0f) {
                            phi_1976_ = -(_e2838[1]);
                        } else {
                            phi_1976_ = _e2838[1];
                        }
                        let _e2849 = phi_1976_;
                        if (_e2845 > _e2849) {
                            phi_1981_ = _e2845;
                        } else {
                            phi_1981_ = _e2849;
                        }
                        let _e2852 = phi_1981_;
                        if (_e2838[2] < 0f) {
                            phi_1988_ = -(_e2838[2]);
                        } else {
                            phi_1988_ = _e2838[2];
                        }
                        let _e2856 = phi_1988_;
                        if (_e2852 > _e2856) {
                            phi_1993_ = _e2852;
                        } else {
                            phi_1993_ = _e2856;
                        }
                        let _e2859 = phi_1993_;
                        if (_e2835 > _e2859) {
                            phi_1998_ = _e2835;
                        } else {
                            phi_1998_ = _e2859;
                        }
                        let _e2862 = phi_1998_;
                        let _e2864 = local_12.member_3;
                        let _e2868 = local_12.member_2[0u];
                        if (_e2868[0] < 0f) {
                            phi_2015_ = -(_e2868[0]);
                        } else {
                            phi_2015_ = _e2868[0];
                        }
                        let _e2875 = phi_2015_;
                        if (_e2868[1] < 0f) {
                            phi_2022_ = -(_e2868[1]);
                        } else {
                            phi_2022_ = _e2868[1];
                        }
                        let _e2879 = phi_2022_;
                        if (_e2875 > _e2879) {
                            phi_2027_ = _e2875;
                        } else {
                            phi_2027_ = _e2879;
                        }
                        let _e2882 = phi_2027_;
                        if (_e2868[2] < 0f) {
                            phi_2034_ = -(_e2868[2]);
                        } else {
                            phi_2034_ = _e2868[2];
                        }
                        let _e2886 = phi_2034_;
                        if (_e2882 > _e2886) {
                            phi_2039_ = _e2882;
                        } else {
                            phi_2039_ = _e2886;
                        }
                        let _e2889 = phi_2039_;
                        let _e2892 = local_12.member_2[1u];
                        if (_e2892[0] < 0f) {
                            phi_2053_ = -(_e2892[0]);
                        } else {
                            phi_2053_ = _e2892[0];
                        }
                        let _e2899 = phi_2053_;
                        if (_e2892[1] < 0f) {
                            phi_2060_ = -(_e2892[1]);
                        } else {
                            phi_2060_ = _e2892[1];
                        }
                        let _e2903 = phi_2060_;
                        if (_e2899 > _e2903) {
                            phi_2065_ = _e2899;
                        } else {
                            phi_2065_ = _e2903;
                        }
                        let _e2906 = phi_2065_;
                        if (_e2892[2] < 0f) {
                            phi_2072_ = -(_e2892[2]);
                        } else {
                            phi_2072_ = _e2892[2];
                        }
                        let _e2910 = phi_2072_;
                        if (_e2906 > _e2910) {
                            phi_2077_ = _e2906;
                        } else {
                            phi_2077_ = _e2910;
                        }
                        let _e2913 = phi_2077_;
                        if (_e2889 > _e2913) {
                            phi_2082_ = _e2889;
                        } else {
                            phi_2082_ = _e2913;
                        }
                        let _e2916 = phi_2082_;
                        let _e2918 = local_12.member_3;
                        let _e2925 = local_12.member_3;
                        phi_2098_ = type_9(0u, 48u);
                        phi_2101_ = 0f;
                        loop {
                            let _e2931 = phi_2098_;
                            let _e2933 = phi_2101_;
                            local_77 = _e2933;
                            local_37 = _e2933;
                            local_38 = _e2933;
                            local_39 = _e2933;
                            local_40 = _e2933;
                            if (_e2931.member < _e2931.member_1) {
                                phi_2099_ = type_9((_e2931.member + 1u), _e2931.member_1);
                                phi_2124_ = type_9(1u, _e2931.member);
                            } else {
                                phi_2099_ = _e2931;
                                phi_2124_ = type_9(0u, type_9().member_1);
                            }
                            let _e2945 = phi_2099_;
                            let _e2947 = phi_2124_;
                            if (bitcast<i32>(_e2947.member) != 0i) {
                                let _e2953 = local_12.member[0u];
                                let _e2959 = local_12.member[1u];
                                let _e2975 = local_12.member_1[0u];
                                let _e2981 = local_12.member_1[1u];
                                let _e2997 = local_12.member_2[0u];
                                let _e3003 = local_12.member_2[1u];
                                let _e3017 = function_1(array<f32, 3>((_e2953[0] + ((_e2959[0] - _e2953[0]) * _e2933)), (_e2953[1] + ((_e2959[1] - _e2953[1]) * _e2933)), (_e2953[2] + ((_e2959[2] - _e2953[2]) * _e2933))), array<f32, 3>((_e2975[0] + ((_e2981[0] - _e2975[0]) * _e2933)), (_e2975[1] + ((_e2981[1] - _e2975[1]) * _e2933)), (_e2975[2] + ((_e2981[2] - _e2975[2]) * _e2933))), array<f32, 3>((_e2997[0] + ((_e3003[0] - _e2997[0]) * _e2933)), (_e2997[1] + ((_e3003[1] - _e2997[1]) * _e2933)), (_e2997[2] + ((_e3003[2] - _e2997[2]) * _e2933))), 0u);
                                if (_e3017[0] < 0f) {
                                    phi_2235_ = -(_e3017[0]);
                                } else {
                                    phi_2235_ = _e3017[0];
                                }
                                let _e3022 = phi_2235_;
                                if (_e3017[1] < 0f) {
                                    phi_2242_ = -(_e3017[1]);
                                } else {
                                    phi_2242_ = _e3017[1];
                                }
                                let _e3027 = phi_2242_;
                                if (_e3017[2] < 0f) {
                                    phi_2250_ = -(_e3017[2]);
                                } else {
                                    phi_2250_ = _e3017[2];
                                }
                                let _e3033 = phi_2250_;
                                let _e3034 = ((_e3022 + _e3027) + _e3033);
                                if (_e3034 > 0f) {
                                    if ((bitcast<u32>(_e3034) & 2139095040u) != 2139095040u) {
                                        let _e3039 = (1f / _e3034);
                                        let _e3041 = (_e3017[0] * _e3039);
                                        let _e3043 = (_e3017[1] * _e3039);
                                        let _e3045 = (_e3017[2] * _e3039);
                                        let _e3050 = (((_e3041 * _e3041) + (_e3043 * _e3043)) + (_e3045 * _e3045));
                                        if (_e3050 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3050 > 0f) {
                                                phi_2287_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2287_ = 0f;
                                            }
                                            let _e3103 = phi_2287_;
                                            phi_2351_ = _e3103;
                                        } else {
                                            phi_2294_ = type_14(0i, 5i);
                                            phi_2297_ = bitcast<f32>(((bitcast<u32>(_e3050) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3058 = phi_2294_;
                                                let _e3060 = phi_2297_;
                                                local_31 = _e3060;
                                                if (_e3058.member < _e3058.member_1) {
                                                    let _e3067 = (_e3058.member + 1i);
                                                    if ((false == (_e3067 > _e3058.member)) != false) {
                                                        phi_2318_ = true;
                                                    } else {
                                                        phi_2318_ = false;
                                                    }
                                                    let _e3072 = phi_2318_;
                                                    if _e3072 {
                                                        phi_2324_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_2324_ = type_15(1u, _e3067);
                                                    }
                                                    let _e3077 = phi_2324_;
                                                    phi_2295_ = type_14(_e3077.member_1, _e3058.member_1);
                                                    phi_2338_ = type_15(1u, _e3058.member);
                                                } else {
                                                    phi_2295_ = _e3058;
                                                    phi_2338_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e3083 = phi_2295_;
                                                let _e3085 = phi_2338_;
                                                let _e3088 = (bitcast<i32>(_e3085.member) != 0i);
                                                if _e3088 {
                                                    phi_2298_ = (0.5f * (_e3060 + (_e3050 / _e3060)));
                                                } else {
                                                    phi_2298_ = f32();
                                                }
                                                let _e3093 = phi_2298_;
                                                continue;
                                                continuing {
                                                    phi_2294_ = _e3083;
                                                    phi_2297_ = _e3093;
                                                    break if !(_e3088);
                                                }
                                            }
                                            let _e3098 = local_31;
                                            phi_2351_ = (_e3098 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3105 = phi_2351_;
                                        phi_2360_ = type_9(0u, 4u);
                                        phi_2363_ = 2f;
                                        loop {
                                            let _e3113 = phi_2360_;
                                            let _e3115 = phi_2363_;
                                            local_33 = _e3115;
                                            local_34 = _e3115;
                                            local_35 = _e3115;
                                            local_67 = _e3115;
                                            local_68 = _e3115;
                                            if (_e3113.member < _e3113.member_1) {
                                                phi_2361_ = type_9((_e3113.member + 1u), _e3113.member_1);
                                                phi_2386_ = type_9(1u, _e3113.member);
                                            } else {
                                                phi_2361_ = _e3113;
                                                phi_2386_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e3127 = phi_2361_;
                                            let _e3129 = phi_2386_;
                                            if (bitcast<i32>(_e3129.member) != 0i) {
                                                let _e3135 = local_9[_e3129.member_1];
                                                let _e3143 = (((_e3041 * _e3135[0]) + (_e3043 * _e3135[1])) + (_e3045 * _e3135[2]));
                                                let _e3145 = local_10[_e3129.member_1];
                                                let _e3153 = (((_e3041 * _e3145[0]) + (_e3043 * _e3145[1])) + (_e3045 * _e3145[2]));
                                                if (_e3143 < 0f) {
                                                    phi_2437_ = -(_e3143);
                                                } else {
                                                    phi_2437_ = _e3143;
                                                }
                                                let _e3157 = phi_2437_;
                                                if (_e3153 < 0f) {
                                                    phi_2443_ = -(_e3153);
                                                } else {
                                                    phi_2443_ = _e3153;
                                                }
                                                let _e3161 = phi_2443_;
                                                let _e3165 = (((((((((_e2808 + _e2810) + (_e2862 + _e2864)) + (_e2916 + _e2918)) * (0.000000059604645f * 16f)) + (_e2925 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e247 * _e3105) * (1f + (0.000000059604645f * 8f)))) + ((_e3157 + _e3161) * (0.000000059604645f * 8f)));
                                                if (_e3143 > _e3165) {
                                                    if (_e3153 > _e3165) {
                                                        phi_2456_ = false;
                                                    } else {
                                                        phi_2456_ = true;
                                                    }
                                                    let _e3169 = phi_2456_;
                                                    phi_2457_ = _e3169;
                                                } else {
                                                    phi_2457_ = true;
                                                }
                                                let _e3171 = phi_2457_;
                                                if _e3171 {
                                                    if ((_e3143 + ((_e3153 - _e3143) * _e2933)) > _e3165) {
                                                        if (_e3153 < _e3143) {
                                                            let _e3179 = ((_e3143 - _e3153) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                            if _e3179 {
                                                                let _e3185 = (((_e3143 - _e3165) / (_e3143 - _e3153)) * (1f - (0.000000059604645f * 16f)));
                                                                if (_e3115 < _e3185) {
                                                                    phi_2488_ = _e3115;
                                                                } else {
                                                                    phi_2488_ = _e3185;
                                                                }
                                                                let _e3188 = phi_2488_;
                                                                phi_2489_ = _e3188;
                                                            } else {
                                                                phi_2489_ = f32();
                                                            }
                                                            let _e3190 = phi_2489_;
                                                            phi_2490_ = _e3190;
                                                            phi_2491_ = _e3179;
                                                        } else {
                                                            phi_2490_ = _e3115;
                                                            phi_2491_ = true;
                                                        }
                                                        let _e3192 = phi_2490_;
                                                        let _e3194 = phi_2491_;
                                                        if _e3194 {
                                                            phi_2495_ = false;
                                                        } else {
                                                            phi_2495_ = true;
                                                        }
                                                        let _e3196 = phi_2495_;
                                                        phi_2496_ = _e3192;
                                                        phi_2497_ = _e3194;
                                                        phi_2498_ = _e3196;
                                                        phi_2499_ = false;
                                                    } else {
                                                        phi_2496_ = f32();
                                                        phi_2497_ = false;
                                                        phi_2498_ = false;
                                                        phi_2499_ = true;
                                                    }
                                                    let _e3198 = phi_2496_;
                                                    let _e3200 = phi_2497_;
                                                    let _e3202 = phi_2498_;
                                                    let _e3204 = phi_2499_;
                                                    phi_2500_ = _e3198;
                                                    phi_2501_ = _e3200;
                                                    phi_2502_ = _e3202;
                                                    phi_2503_ = _e3204;
                                                } else {
                                                    phi_2500_ = _e3115;
                                                    phi_2501_ = true;
                                                    phi_2502_ = false;
                                                    phi_2503_ = false;
                                                }
                                                let _e3206 = phi_2500_;
                                                let _e3208 = phi_2501_;
                                                let _e3210 = phi_2502_;
                                                let _e3212 = phi_2503_;
                                                phi_2364_ = _e3206;
                                                phi_2504_ = _e3208;
                                                phi_2505_ = false;
                                                phi_2506_ = _e3210;
                                                phi_2507_ = _e3212;
                                            } else {
                                                phi_2364_ = f32();
                                                phi_2504_ = false;
                                                phi_2505_ = true;
                                                phi_2506_ = false;
                                                phi_2507_ = false;
                                            }
                                            let _e3214 = phi_2364_;
                                            let _e3216 = phi_2504_;
                                            let _e3218 = phi_2505_;
                                            let _e3220 = phi_2506_;
                                            let _e3222 = phi_2507_;
                                            local_32 = _e3218;
                                            local_65 = _e3220;
                                            local_66 = _e3222;
                                            continue;
                                            continuing {
                                                phi_2360_ = _e3127;
                                                phi_2363_ = _e3214;
                                                break if !(_e3216);
                                            }
                                        }
                                        let _e3225 = local_32;
                                        if _e3225 {
                                            let _e3227 = local_33;
                                            let _e3228 = (_e3227 > 1f);
                                            if _e3228 {
                                                phi_2528_ = false;
                                                phi_2529_ = false;
                                                phi_2530_ = false;
                                            } else {
                                                let _e3230 = local_34;
                                                if (_e3230 > _e2933) {
                                                    let _e3233 = local_35;
                                                    let _e3235 = ((_e3233 - _e2933) < 0.00000000023283064f);
                                                    if _e3235 {
                                                        phi_2524_ = false;
                                                    } else {
                                                        phi_2524_ = true;
                                                    }
                                                    let _e3237 = phi_2524_;
                                                    phi_2525_ = _e3237;
                                                    phi_2526_ = _e3235;
                                                    phi_2527_ = false;
                                                } else {
                                                    phi_2525_ = false;
                                                    phi_2526_ = false;
                                                    phi_2527_ = true;
                                                }
                                                let _e3239 = phi_2525_;
                                                let _e3241 = phi_2526_;
                                                let _e3243 = phi_2527_;
                                                phi_2528_ = _e3239;
                                                phi_2529_ = _e3241;
                                                phi_2530_ = _e3243;
                                            }
                                            let _e3245 = phi_2528_;
                                            let _e3247 = phi_2529_;
                                            let _e3249 = phi_2530_;
                                            phi_2531_ = _e3245;
                                            phi_2532_ = _e3228;
                                            phi_2533_ = _e3247;
                                            phi_2534_ = _e3249;
                                            phi_2535_ = false;
                                            phi_2536_ = false;
                                        } else {
                                            phi_2531_ = false;
                                            phi_2532_ = false;
                                            phi_2533_ = false;
                                            phi_2534_ = false;
                                            let _e4551 = local_65;
                                            phi_2535_ = _e4551;
                                            let _e4554 = local_66;
                                            phi_2536_ = _e4554;
                                        }
                                        let _e3251 = phi_2531_;
                                        let _e3253 = phi_2532_;
                                        let _e3255 = phi_2533_;
                                        let _e3257 = phi_2534_;
                                        let _e3259 = phi_2535_;
                                        let _e3261 = phi_2536_;
                                        let _e4557 = local_67;
                                        phi_2537_ = _e4557;
                                        let _e4560 = local_68;
                                        phi_2538_ = _e4560;
                                        phi_2539_ = _e3251;
                                        phi_2540_ = _e3253;
                                        phi_2541_ = _e3255;
                                        phi_2542_ = _e3257;
                                        phi_2543_ = _e3259;
                                        phi_2544_ = _e3261;
                                        phi_2545_ = false;
                                    } else {
                                        phi_2537_ = f32();
                                        phi_2538_ = f32();
                                        phi_2539_ = false;
                                        phi_2540_ = false;
                                        phi_2541_ = false;
                                        phi_2542_ = false;
                                        phi_2543_ = false;
                                        phi_2544_ = false;
                                        phi_2545_ = true;
                                    }
                                    let _e3263 = phi_2537_;
                                    let _e3265 = phi_2538_;
                                    let _e3267 = phi_2539_;
                                    let _e3269 = phi_2540_;
                                    let _e3271 = phi_2541_;
                                    let _e3273 = phi_2542_;
                                    let _e3275 = phi_2543_;
                                    let _e3277 = phi_2544_;
                                    let _e3279 = phi_2545_;
                                    phi_2546_ = _e3263;
                                    phi_2547_ = _e3265;
                                    phi_2548_ = _e3267;
                                    phi_2549_ = _e3269;
                                    phi_2550_ = _e3271;
                                    phi_2551_ = _e3273;
                                    phi_2552_ = _e3275;
                                    phi_2553_ = _e3277;
                                    phi_2554_ = _e3279;
                                    phi_2555_ = false;
                                } else {
                                    phi_2546_ = f32();
                                    phi_2547_ = f32();
                                    phi_2548_ = false;
                                    phi_2549_ = false;
                                    phi_2550_ = false;
                                    phi_2551_ = false;
                                    phi_2552_ = false;
                                    phi_2553_ = false;
                                    phi_2554_ = false;
                                    phi_2555_ = true;
                                }
                                let _e3281 = phi_2546_;
                                let _e3283 = phi_2547_;
                                let _e3285 = phi_2548_;
                                let _e3287 = phi_2549_;
                                let _e3289 = phi_2550_;
                                let _e3291 = phi_2551_;
                                let _e3293 = phi_2552_;
                                let _e3295 = phi_2553_;
                                let _e3297 = phi_2554_;
                                let _e3299 = phi_2555_;
                                phi_2556_ = _e3281;
                                phi_2102_ = _e3283;
                                phi_2557_ = _e3285;
                                phi_2558_ = _e3287;
                                phi_2559_ = _e3289;
                                phi_2560_ = false;
                                phi_2561_ = _e3291;
                                phi_2562_ = _e3293;
                                phi_2563_ = _e3295;
                                phi_2564_ = _e3297;
                                phi_2565_ = _e3299;
                            } else {
                                phi_2556_ = f32();
                                phi_2102_ = f32();
                                phi_2557_ = false;
                                phi_2558_ = false;
                                phi_2559_ = false;
                                phi_2560_ = true;
                                phi_2561_ = false;
                                phi_2562_ = false;
                                phi_2563_ = false;
                                phi_2564_ = false;
                                phi_2565_ = false;
                            }
                            let _e3301 = phi_2556_;
                            let _e3303 = phi_2102_;
                            let _e3305 = phi_2557_;
                            let _e3307 = phi_2558_;
                            let _e3309 = phi_2559_;
                            let _e3311 = phi_2560_;
                            let _e3313 = phi_2561_;
                            let _e3315 = phi_2562_;
                            let _e3317 = phi_2563_;
                            let _e3319 = phi_2564_;
                            let _e3321 = phi_2565_;
                            local_36 = _e3307;
                            local_69 = _e3309;
                            local_70 = _e3311;
                            local_71 = _e3313;
                            local_72 = _e3315;
                            local_73 = _e3317;
                            local_74 = _e3319;
                            local_75 = _e3321;
                            local_76 = _e3301;
                            local_78 = _e3307;
                            continue;
                            continuing {
                                phi_2098_ = _e2945;
                                phi_2101_ = _e3303;
                                break if !(_e3305);
                            }
                        }
                        let _e3324 = local_36;
                        if _e3324 {
                            phi_2570_ = type_34(0u, type_34().member_1);
                            phi_2571_ = false;
                            phi_2572_ = false;
                            phi_2573_ = false;
                            phi_2574_ = false;
                            phi_2575_ = false;
                            phi_2576_ = false;
                            phi_2577_ = false;
                        } else {
                            phi_2570_ = type_34();
                            let _e4593 = local_69;
                            phi_2571_ = _e4593;
                            let _e4596 = local_70;
                            phi_2572_ = _e4596;
                            let _e4599 = local_71;
                            phi_2573_ = _e4599;
                            let _e4602 = local_72;
                            phi_2574_ = _e4602;
                            let _e4605 = local_73;
                            phi_2575_ = _e4605;
                            let _e4608 = local_74;
                            phi_2576_ = _e4608;
                            let _e4611 = local_75;
                            phi_2577_ = _e4611;
                        }
                        let _e3328 = phi_2570_;
                        let _e3330 = phi_2571_;
                        let _e3332 = phi_2572_;
                        let _e3334 = phi_2573_;
                        let _e3336 = phi_2574_;
                        let _e3338 = phi_2575_;
                        let _e3340 = phi_2576_;
                        let _e3342 = phi_2577_;
                        if _e3330 {
                            let _e4614 = local_76;
                            phi_2581_ = _e4614;
                            phi_2582_ = true;
                            phi_2583_ = false;
                            phi_2584_ = false;
                            phi_2585_ = false;
                            phi_2586_ = false;
                            phi_2587_ = false;
                            phi_2588_ = false;
                        } else {
                            let _e4616 = local_77;
                            phi_2581_ = _e4616;
                            phi_2582_ = _e3332;
                            phi_2583_ = _e3334;
                            phi_2584_ = _e3336;
                            phi_2585_ = _e3338;
                            let _e4623 = local_78;
                            phi_2586_ = _e4623;
                            phi_2587_ = _e3340;
                            phi_2588_ = _e3342;
                        }
                        let _e3344 = phi_2581_;
                        let _e3346 = phi_2582_;
                        let _e3348 = phi_2583_;
                        let _e3350 = phi_2584_;
                        let _e3352 = phi_2585_;
                        let _e3354 = phi_2586_;
                        let _e3356 = phi_2587_;
                        let _e3358 = phi_2588_;
                        if _e3346 {
                            phi_2593_ = type_34(1u, _e3344);
                            phi_2594_ = false;
                            phi_2595_ = false;
                            phi_2596_ = false;
                            phi_2597_ = false;
                            phi_2598_ = false;
                            phi_2599_ = false;
                        } else {
                            phi_2593_ = type_34();
                            phi_2594_ = _e3348;
                            phi_2595_ = _e3350;
                            phi_2596_ = _e3352;
                            phi_2597_ = _e3354;
                            phi_2598_ = _e3356;
                            phi_2599_ = _e3358;
                        }
                        let _e3361 = phi_2593_;
                        let _e3363 = phi_2594_;
                        let _e3365 = phi_2595_;
                        let _e3367 = phi_2596_;
                        let _e3369 = phi_2597_;
                        let _e3371 = phi_2598_;
                        let _e3373 = phi_2599_;
                        if _e3363 {
                            let _e3375 = local_37;
                            phi_2604_ = type_34(1u, _e3375);
                            phi_2605_ = false;
                            phi_2606_ = false;
                            phi_2607_ = true;
                            phi_2608_ = false;
                            phi_2609_ = false;
                        } else {
                            phi_2604_ = _e3328;
                            phi_2605_ = _e3365;
                            phi_2606_ = _e3367;
                            phi_2607_ = _e3369;
                            phi_2608_ = _e3371;
                            phi_2609_ = _e3373;
                        }
                        let _e3378 = phi_2604_;
                        let _e3380 = phi_2605_;
                        let _e3382 = phi_2606_;
                        let _e3384 = phi_2607_;
                        let _e3386 = phi_2608_;
                        let _e3388 = phi_2609_;
                        if _e3380 {
                            let _e3390 = local_38;
                            phi_2614_ = type_34(1u, _e3390);
                            phi_2615_ = false;
                            phi_2616_ = false;
                            phi_2617_ = false;
                            phi_2618_ = false;
                        } else {
                            phi_2614_ = type_34();
                            phi_2615_ = _e3382;
                            phi_2616_ = _e3384;
                            phi_2617_ = _e3386;
                            phi_2618_ = _e3388;
                        }
                        let _e3393 = phi_2614_;
                        let _e3395 = phi_2615_;
                        let _e3397 = phi_2616_;
                        let _e3399 = phi_2617_;
                        let _e3401 = phi_2618_;
                        if _e3395 {
                            let _e3403 = local_39;
                            phi_2623_ = type_34(1u, _e3403);
                            phi_2624_ = true;
                            phi_2625_ = false;
                            phi_2626_ = false;
                            phi_2627_ = false;
                        } else {
                            phi_2623_ = _e3393;
                            phi_2624_ = _e3380;
                            phi_2625_ = _e3397;
                            phi_2626_ = _e3399;
                            phi_2627_ = _e3401;
                        }
                        let _e3406 = phi_2623_;
                        let _e3408 = phi_2624_;
                        let _e3410 = phi_2625_;
                        let _e3412 = phi_2626_;
                        let _e3414 = phi_2627_;
                        if _e3408 {
                            phi_2631_ = _e3406;
                            phi_2632_ = true;
                            phi_2633_ = false;
                            phi_2634_ = false;
                        } else {
                            phi_2631_ = _e3378;
                            phi_2632_ = _e3410;
                            phi_2633_ = _e3412;
                            phi_2634_ = _e3414;
                        }
                        let _e3416 = phi_2631_;
                        let _e3418 = phi_2632_;
                        let _e3420 = phi_2633_;
                        let _e3422 = phi_2634_;
                        if _e3418 {
                            phi_2638_ = false;
                            phi_2639_ = false;
                        } else {
                            phi_2638_ = _e3420;
                            phi_2639_ = _e3422;
                        }
                        let _e3424 = phi_2638_;
                        let _e3426 = phi_2639_;
                        if _e3424 {
                            phi_2643_ = false;
                            phi_2644_ = false;
                        } else {
                            phi_2643_ = _e3426;
                            phi_2644_ = _e3418;
                        }
                        let _e3428 = phi_2643_;
                        let _e3430 = phi_2644_;
                        if _e3428 {
                            phi_2648_ = true;
                            phi_2649_ = false;
                        } else {
                            phi_2648_ = _e3424;
                            phi_2649_ = _e3430;
                        }
                        let _e3432 = phi_2648_;
                        let _e3434 = phi_2649_;
                        if _e3432 {
                            let _e3436 = local_40;
                            phi_2654_ = type_34(1u, _e3436);
                            phi_2655_ = true;
                        } else {
                            phi_2654_ = _e3416;
                            phi_2655_ = _e3434;
                        }
                        let _e3439 = phi_2654_;
                        let _e3441 = phi_2655_;
                        if _e3441 {
                            phi_2659_ = _e3439;
                        } else {
                            phi_2659_ = _e3361;
                        }
                        let _e3443 = phi_2659_;
                        if (_e3443.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_2673_ = type_9(0u, 3u);
                            loop {
                                let _e3455 = phi_2673_;
                                if (_e3455.member < _e3455.member_1) {
                                    phi_2674_ = type_9((_e3455.member + 1u), _e3455.member_1);
                                    phi_2697_ = type_9(1u, _e3455.member);
                                } else {
                                    phi_2674_ = _e3455;
                                    phi_2697_ = type_9(0u, type_9().member_1);
                                }
                                let _e3467 = phi_2674_;
                                let _e3469 = phi_2697_;
                                if (bitcast<i32>(_e3469.member) != 0i) {
                                    let _e3475 = local_11[_e3469.member_1];
                                    let _e3476 = (_e3443.member_1 + _e3475);
                                    if (_e3476 < 1f) {
                                        phi_2717_ = _e3476;
                                    } else {
                                        phi_2717_ = 1f;
                                    }
                                    let _e3479 = phi_2717_;
                                    let _e3482 = local_12.member[0u];
                                    let _e3488 = local_12.member[1u];
                                    let _e3504 = local_12.member_1[0u];
                                    let _e3510 = local_12.member_1[1u];
                                    let _e3526 = local_12.member_2[0u];
                                    let _e3532 = local_12.member_2[1u];
                                    let _e3546 = function_1(array<f32, 3>((_e3482[0] + ((_e3488[0] - _e3482[0]) * _e3479)), (_e3482[1] + ((_e3488[1] - _e3482[1]) * _e3479)), (_e3482[2] + ((_e3488[2] - _e3482[2]) * _e3479))), array<f32, 3>((_e3504[0] + ((_e3510[0] - _e3504[0]) * _e3479)), (_e3504[1] + ((_e3510[1] - _e3504[1]) * _e3479)), (_e3504[2] + ((_e3510[2] - _e3504[2]) * _e3479))), array<f32, 3>((_e3526[0] + ((_e3532[0] - _e3526[0]) * _e3479)), (_e3526[1] + ((_e3532[1] - _e3526[1]) * _e3479)), (_e3526[2] + ((_e3532[2] - _e3526[2]) * _e3479))), 0u);
                                    let _e3557 = (((_e3546[0] * _e3546[0]) + (_e3546[1] * _e3546[1])) + (_e3546[2] * _e3546[2]));
                                    if (_e3557 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e3557 > 0f) {
                                            phi_2840_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_2840_ = 0f;
                                        }
                                        let _e3610 = phi_2840_;
                                        phi_2904_ = _e3610;
                                    } else {
                                        phi_2847_ = type_14(0i, 5i);
                                        phi_2850_ = bitcast<f32>(((bitcast<u32>(_e3557) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e3565 = phi_2847_;
                                            let _e3567 = phi_2850_;
                                            local_41 = _e3567;
                                            if (_e3565.member < _e3565.member_1) {
                                                let _e3574 = (_e3565.member + 1i);
                                                if ((false == (_e3574 > _e3565.member)) != false) {
                                                    phi_2871_ = true;
                                                } else {
                                                    phi_2871_ = false;
                                                }
                                                let _e3579 = phi_2871_;
                                                if _e3579 {
                                                    phi_2877_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_2877_ = type_15(1u, _e3574);
                                                }
                                                let _e3584 = phi_2877_;
                                                phi_2848_ = type_14(_e3584.member_1, _e3565.member_1);
                                                phi_2891_ = type_15(1u, _e3565.member);
                                            } else {
                                                phi_2848_ = _e3565;
                                                phi_2891_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e3590 = phi_2848_;
                                            let _e3592 = phi_2891_;
                                            let _e3595 = (bitcast<i32>(_e3592.member) != 0i);
                                            if _e3595 {
                                                phi_2851_ = (0.5f * (_e3567 + (_e3557 / _e3567)));
                                            } else {
                                                phi_2851_ = f32();
                                            }
                                            let _e3600 = phi_2851_;
                                            continue;
                                            continuing {
                                                phi_2847_ = _e3590;
                                                phi_2850_ = _e3600;
                                                break if !(_e3595);
                                            }
                                        }
                                        let _e3605 = local_41;
                                        phi_2904_ = (_e3605 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e3612 = phi_2904_;
                                    let _e3618 = local_12.member[0u];
                                    if (_e3618[0] < 0f) {
                                        phi_2920_ = -(_e3618[0]);
                                    } else {
                                        phi_2920_ = _e3618[0];
                                    }
                                    let _e3625 = phi_2920_;
                                    if (_e3618[1] < 0f) {
                                        phi_2927_ = -(_e3618[1]);
                                    } else {
                                        phi_2927_ = _e3618[1];
                                    }
                                    let _e3629 = phi_2927_;
                                    if (_e3625 > _e3629) {
                                        phi_2932_ = _e3625;
                                    } else {
                                        phi_2932_ = _e3629;
                                    }
                                    let _e3632 = phi_2932_;
                                    if (_e3618[2] < 0f) {
                                        phi_2939_ = -(_e3618[2]);
                                    } else {
                                        phi_2939_ = _e3618[2];
                                    }
                                    let _e3636 = phi_2939_;
                                    if (_e3632 > _e3636) {
                                        phi_2944_ = _e3632;
                                    } else {
                                        phi_2944_ = _e3636;
                                    }
                                    let _e3639 = phi_2944_;
                                    let _e3642 = local_12.member[1u];
                                    if (_e3642[0] < 0f) {
                                        phi_2957_ = -(_e3642[0]);
                                    } else {
                                        phi_2957_ = _e3642[0];
                                    }
                                    let _e3649 = phi_2957_;
                                    if (_e3642[1] < 0f) {
                                        phi_2964_ = -(_e3642[1]);
                                    } else {
                                        phi_2964_ = _e3642[1];
                                    }
                                    let _e3653 = phi_2964_;
                                    if (_e3649 > _e3653) {
                                        phi_2969_ = _e3649;
                                    } else {
                                        phi_2969_ = _e3653;
                                    }
                                    let _e3656 = phi_2969_;
                                    if (_e3642[2] < 0f) {
                                        phi_2976_ = -(_e3642[2]);
                                    } else {
                                        phi_2976_ = _e3642[2];
                                    }
                                    let _e3660 = phi_2976_;
                                    if (_e3656 > _e3660) {
                                        phi_2981_ = _e3656;
                                    } else {
                                        phi_2981_ = _e3660;
                                    }
                                    let _e3663 = phi_2981_;
                                    if (_e3639 > _e3663) {
                                        phi_2986_ = _e3639;
                                    } else {
                                        phi_2986_ = _e3663;
                                    }
                                    let _e3666 = phi_2986_;
                                    let _e3668 = local_12.member_3;
                                    let _e3672 = local_12.member_1[0u];
                                    if (_e3672[0] < 0f) {
                                        phi_3003_ = -(_e3672[0]);
                                    } else {
                                        phi_3003_ = _e3672[0];
                                    }
                                    let _e3679 = phi_3003_;
                                    if (_e3672[1] < 0f) {
                                        phi_3010_ = -(_e3672[1]);
                                    } else {
                                        phi_3010_ = _e3672[1];
                                    }
                                    let _e3683 = phi_3010_;
                                    if (_e3679 > _e3683) {
                                        phi_3015_ = _e3679;
                                    } else {
                                        phi_3015_ = _e3683;
                                    }
                                    let _e3686 = phi_3015_;
                                    if (_e3672[2] < 0f) {
                                        phi_3022_ = -(_e3672[2]);
                                    } else {
                                        phi_3022_ = _e3672[2];
                                    }
                                    let _e3690 = phi_3022_;
                                    if (_e3686 > _e3690) {
                                        phi_3027_ = _e3686;
                                    } else {
                                        phi_3027_ = _e3690;
                                    }
                                    let _e3693 = phi_3027_;
                                    let _e3696 = local_12.member_1[1u];
                                    if (_e3696[0] < 0f) {
                                        phi_3041_ = -(_e3696[0]);
                                    } else {
                                        phi_3041_ = _e3696[0];
                                    }
                                    let _e3703 = phi_3041_;
                                    if (_e3696[1] < 0f) {
                                        phi_3048_ = -(_e3696[1]);
                                    } else {
                                        phi_3048_ = _e3696[1];
                                    }
                                    let _e3707 = phi_3048_;
                                    if (_e3703 > _e3707) {
                                        phi_3053_ = _e3703;
                                    } else {
                                        phi_3053_ = _e3707;
                                    }
                                    let _e3710 = phi_3053_;
                                    if (_e3696[2] < 0f) {
                                        phi_3060_ = -(_e3696[2]);
                                    } else {
                                        phi_3060_ = _e3696[2];
                                    }
                                    let _e3714 = phi_3060_;
                                    if (_e3710 > _e3714) {
                                        phi_3065_ = _e3710;
                                    } else {
                                        phi_3065_ = _e3714;
                                    }
                                    let _e3717 = phi_3065_;
                                    if (_e3693 > _e3717) {
                                        phi_3070_ = _e3693;
                                    } else {
                                        phi_3070_ = _e3717;
                                    }
                                    let _e3720 = phi_3070_;
                                    let _e3722 = local_12.member_3;
                                    let _e3726 = local_12.member_2[0u];
                                    if (_e3726[0] < 0f) {
                                        phi_3087_ = -(_e3726[0]);
                                    } else {
                                        phi_3087_ = _e3726[0];
                                    }
                                    let _e3733 = phi_3087_;
                                    if (_e3726[1] < 0f) {
                                        phi_3094_ = -(_e3726[1]);
                                    } else {
                                        phi_3094_ = _e3726[1];
                                    }
                                    let _e3737 = phi_3094_;
                                    if (_e3733 > _e3737) {
                                        phi_3099_ = _e3733;
                                    } else {
                                        phi_3099_ = _e3737;
                                    }
                                    let _e3740 = phi_3099_;
                                    if (_e3726[2] < 0f) {
                                        phi_3106_ = -(_e3726[2]);
                                    } else {
                                        phi_3106_ = _e3726[2];
                                    }
                                    let _e3744 = phi_3106_;
                                    if (_e3740 > _e3744) {
                                        phi_3111_ = _e3740;
                                    } else {
                                        phi_3111_ = _e3744;
                                    }
                                    let _e3747 = phi_3111_;
                                    let _e3750 = local_12.member_2[1u];
                                    if (_e3750[0] < 0f) {
                                        phi_3125_ = -(_e3750[0]);
                                    } else {
                                        phi_3125_ = _e3750[0];
                                    }
                                    let _e3757 = phi_3125_;
                                    if (_e3750[1] < 0f) {
                                        phi_3132_ = -(_e3750[1]);
                                    } else {
                                        phi_3132_ = _e3750[1];
                                    }
                                    let _e3761 = phi_3132_;
                                    if (_e3757 > _e3761) {
                                        phi_3137_ = _e3757;
                                    } else {
                                        phi_3137_ = _e3761;
                                    }
                                    let _e3764 = phi_3137_;
                                    if (_e3750[2] < 0f) {
                                        phi_3144_ = -(_e3750[2]);
                                    } else {
                                        phi_3144_ = _e3750[2];
                                    }
                                    let _e3768 = phi_3144_;
                                    if (_e3764 > _e3768) {
                                        phi_3149_ = _e3764;
                                    } else {
                                        phi_3149_ = _e3768;
                                    }
                                    let _e3771 = phi_3149_;
                                    if (_e3747 > _e3771) {
                                        phi_3154_ = _e3747;
                                    } else {
                                        phi_3154_ = _e3771;
                                    }
                                    let _e3774 = phi_3154_;
                                    let _e3776 = local_12.member_3;
                                    let _e3783 = local_12.member_3;
                                    let _e3790 = (((_e3612 * (1f + (0.000000059604645f * 8f))) + (((((((_e3666 + _e3668) + (_e3720 + _e3722)) + (_e3774 + _e3776)) * (0.000000059604645f * 16f)) + (_e3783 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e247);
                                    if _e3790 {
                                        phi_3174_ = false;
                                    } else {
                                        phi_3174_ = true;
                                    }
                                    let _e3792 = phi_3174_;
                                    phi_3175_ = _e3792;
                                    phi_3176_ = _e3790;
                                } else {
                                    phi_3175_ = false;
                                    phi_3176_ = false;
                                }
                                let _e3794 = phi_3175_;
                                let _e3796 = phi_3176_;
                                local_42 = _e3796;
                                continue;
                                continuing {
                                    phi_2673_ = _e3467;
                                    break if !(_e3794);
                                }
                            }
                            let _e3799 = local_42;
                            if _e3799 {
                                phi_3181_ = type_34(1u, _e3443.member_1);
                                phi_3182_ = false;
                            } else {
                                phi_3181_ = type_34();
                                phi_3182_ = true;
                            }
                            let _e3802 = phi_3181_;
                            let _e3804 = phi_3182_;
                            if _e3804 {
                                phi_3187_ = type_34(2u, _e3443.member_1);
                                phi_3188_ = false;
                            } else {
                                phi_3187_ = type_34();
                                phi_3188_ = true;
                            }
                            let _e3807 = phi_3187_;
                            let _e3809 = phi_3188_;
                            phi_3190_ = _e3807;
                            phi_3191_ = _e3802;
                            phi_3192_ = _e3809;
                        } else {
                            phi_3190_ = type_34();
                            phi_3191_ = type_34(0u, type_34().member_1);
                            phi_3192_ = true;
                        }
                        let _e3811 = phi_3190_;
                        let _e3813 = phi_3191_;
                        let _e3815 = phi_3192_;
                        if _e3815 {
                            phi_3196_ = _e3813;
                        } else {
                            phi_3196_ = _e3811;
                        }
                        let _e3817 = phi_3196_;
                        phi_6013_ = _e3817;
                    } else {
                        if (_e345 < 0f) {
                            phi_3206_ = -(_e345);
                        } else {
                            phi_3206_ = _e345;
                        }
                        let _e688 = phi_3206_;
                        if (_e368 < 0f) {
                            phi_3212_ = -(_e368);
                        } else {
                            phi_3212_ = _e368;
                        }
                        let _e692 = phi_3212_;
                        if (_e688 > _e692) {
                            phi_3217_ = _e688;
                        } else {
                            phi_3217_ = _e692;
                        }
                        let _e695 = phi_3217_;
                        if (_e391 < 0f) {
                            phi_3223_ = -(_e391);
                        } else {
                            phi_3223_ = _e391;
                        }
                        let _e699 = phi_3223_;
                        if (_e402 < 0f) {
                            phi_3229_ = -(_e402);
                        } else {
                            phi_3229_ = _e402;
                        }
                        let _e703 = phi_3229_;
                        if (_e699 > _e703) {
                            phi_3234_ = _e699;
                        } else {
                            phi_3234_ = _e703;
                        }
                        let _e706 = phi_3234_;
                        if (_e695 > _e706) {
                            phi_3239_ = _e695;
                        } else {
                            phi_3239_ = _e706;
                        }
                        let _e709 = phi_3239_;
                        let _e710 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e709 >= _e710) {
                            phi_3247_ = (_e709 <= (1f / _e710));
                        } else {
                            phi_3247_ = false;
                        }
                        let _e715 = phi_3247_;
                        if _e715 {
                            phi_3252_ = (0.000000059604645f * 256f);
                        } else {
                            phi_3252_ = 2f;
                        }
                        let _e718 = phi_3252_;
                        let _e720 = ((_e652 * 0.34f) + (_e709 * _e718));
                        if _e715 {
                            phi_3259_ = (1f / _e709);
                        } else {
                            phi_3259_ = 0f;
                        }
                        let _e723 = phi_3259_;
                        let _e729 = ((_e368 - (3f * _e345)) * _e723);
                        let _e730 = ((_e391 - _e368) * _e723);
                        let _e731 = (((3f * _e402) - _e391) * _e723);
                        local_6[0u] = 0f;
                        local_6[1u] = 1f;
                        local_6[2u] = 1f;
                        local_6[3u] = 1f;
                        let _e738 = ((_e730 * _e730) - (_e729 * _e731));
                        if (_e738 > 0f) {
                            if (_e738 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e738 > 0f) {
                                    phi_3292_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_3292_ = 0f;
                                }
                                let _e792 = phi_3292_;
                                phi_3356_ = _e792;
                            } else {
                                phi_3299_ = type_14(0i, 5i);
                                phi_3302_ = bitcast<f32>(((bitcast<u32>(_e738) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e747 = phi_3299_;
                                    let _e749 = phi_3302_;
                                    local_13 = _e749;
                                    if (_e747.member < _e747.member_1) {
                                        let _e756 = (_e747.member + 1i);
                                        if ((false == (_e756 > _e747.member)) != false) {
                                            phi_3323_ = true;
                                        } else {
                                            phi_3323_ = false;
                                        }
                                        let _e761 = phi_3323_;
                                        if _e761 {
                                            phi_3329_ = type_15(0u, type_15().member_1);
                                        } else {
                                            phi_3329_ = type_15(1u, _e756);
                                        }
                                        let _e766 = phi_3329_;
                                        phi_3300_ = type_14(_e766.member_1, _e747.member_1);
                                        phi_3343_ = type_15(1u, _e747.member);
                                    } else {
                                        phi_3300_ = _e747;
                                        phi_3343_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e772 = phi_3300_;
                                    let _e774 = phi_3343_;
                                    let _e777 = (bitcast<i32>(_e774.member) != 0i);
                                    if _e777 {
                                        phi_3303_ = (0.5f * (_e749 + (_e738 / _e749)));
                                    } else {
                                        phi_3303_ = f32();
                                    }
                                    let _e782 = phi_3303_;
                                    continue;
                                    continuing {
                                        phi_3299_ = _e772;
                                        phi_3302_ = _e782;
                                        break if !(_e777);
                                    }
                                }
                                let _e787 = local_13;
                                phi_3356_ = (_e787 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e794 = phi_3356_;
                            if (_e730 < 0f) {
                                phi_3362_ = -(_e794);
                            } else {
                                phi_3362_ = _e794;
                            }
                            let _e798 = phi_3362_;
                            let _e800 = -((_e730 + _e798));
                            local_7[0u] = (_e800 / (_e800 + _e731));
                            local_7[1u] = (_e729 / (_e729 + _e800));
                            let _e809 = local_7[1u];
                            let _e810 = local_7[0u];
                            if (_e809 < _e810) {
                                let _e813 = local_7[1u];
                                let _e815 = local_7[0u];
                                local_7[0u] = _e813;
                                local_7[1u] = _e815;
                            }
                            phi_3387_ = type_9(0u, 2u);
                            phi_3390_ = 1u;
                            loop {
                                let _e819 = phi_3387_;
                                let _e821 = phi_3390_;
                                local_43 = _e821;
                                if (_e819.member < _e819.member_1) {
                                    phi_3388_ = type_9((_e819.member + 1u), _e819.member_1);
                                    phi_3413_ = type_9(1u, _e819.member);
                                } else {
                                    phi_3388_ = _e819;
                                    phi_3413_ = type_9(0u, type_9().member_1);
                                }
                                let _e833 = phi_3388_;
                                let _e835 = phi_3413_;
                                let _e839 = (bitcast<i32>(_e835.member) != 0i);
                                if _e839 {
                                    let _e841 = local_7[_e835.member_1];
                                    if (_e841 > 0f) {
                                        let _e844 = local_7[_e835.member_1];
                                        if (_e844 < 1f) {
                                            let _e847 = local_7[_e835.member_1];
                                            local_6[_e821] = _e847;
                                            phi_3457_ = (_e821 + 1u);
                                        } else {
                                            phi_3457_ = _e821;
                                        }
                                        let _e851 = phi_3457_;
                                        phi_3458_ = _e851;
                                    } else {
                                        phi_3458_ = _e821;
                                    }
                                    let _e853 = phi_3458_;
                                    phi_3391_ = _e853;
                                } else {
                                    phi_3391_ = u32();
                                }
                                let _e855 = phi_3391_;
                                continue;
                                continuing {
                                    phi_3387_ = _e833;
                                    phi_3390_ = _e855;
                                    break if !(_e839);
                                }
                            }
                            let _e4031 = local_43;
                            phi_3459_ = _e4031;
                        } else {
                            phi_3459_ = 1u;
                        }
                        let _e858 = phi_3459_;
                        local_6[_e858] = 1f;
                        let _e860 = local_6;
                        local_8 = _e860;
                        phi_3479_ = type_9(0u, _e858);
                        loop {
                            let _e863 = phi_3479_;
                            if (_e863.member < _e863.member_1) {
                                phi_3480_ = type_9((_e863.member + 1u), _e863.member_1);
                                phi_3503_ = type_9(1u, _e863.member);
                            } else {
                                phi_3480_ = _e863;
                                phi_3503_ = type_9(0u, type_9().member_1);
                            }
                            let _e875 = phi_3480_;
                            let _e877 = phi_3503_;
                            if (bitcast<i32>(_e877.member) != 0i) {
                                let _e883 = local_8[_e877.member_1];
                                let _e886 = local_8[(_e877.member_1 + 1u)];
                                let _e887 = (1f - _e883);
                                let _e898 = ((((_e345 * _e887) + (_e368 * _e883)) * (_e887 * _e887)) + (((_e391 * _e887) + (_e402 * _e883)) * (_e883 * _e883)));
                                let _e899 = (1f - _e886);
                                let _e910 = ((((_e345 * _e899) + (_e368 * _e886)) * (_e899 * _e899)) + (((_e391 * _e899) + (_e402 * _e886)) * (_e886 * _e886)));
                                if (_e898 < 0f) {
                                    phi_3555_ = -(_e898);
                                } else {
                                    phi_3555_ = _e898;
                                }
                                let _e914 = phi_3555_;
                                let _e915 = (_e914 > _e720);
                                if (_e910 < 0f) {
                                    phi_3562_ = -(_e910);
                                } else {
                                    phi_3562_ = _e910;
                                }
                                let _e919 = phi_3562_;
                                let _e920 = (_e919 > _e720);
                                if _e915 {
                                    if _e920 {
                                        phi_3573_ = ((_e898 > 0f) != (_e910 > 0f));
                                        phi_3574_ = false;
                                    } else {
                                        phi_3573_ = bool();
                                        phi_3574_ = true;
                                    }
                                    let _e925 = phi_3573_;
                                    let _e927 = phi_3574_;
                                    phi_3575_ = _e925;
                                    phi_3576_ = _e927;
                                } else {
                                    phi_3575_ = bool();
                                    phi_3576_ = true;
                                }
                                let _e929 = phi_3575_;
                                let _e931 = phi_3576_;
                                if _e931 {
                                    phi_3580_ = false;
                                } else {
                                    phi_3580_ = _e929;
                                }
                                let _e933 = phi_3580_;
                                if _e915 {
                                    if _e920 {
                                        if _e933 {
                                            phi_3591_ = type_35();
                                        } else {
                                            phi_3591_ = type_35(1f, 0f, _e933);
                                        }
                                        let _e936 = phi_3591_;
                                        phi_3592_ = _e936;
                                        phi_3593_ = _e933;
                                    } else {
                                        phi_3592_ = type_35();
                                        phi_3593_ = true;
                                    }
                                    let _e938 = phi_3592_;
                                    let _e940 = phi_3593_;
                                    phi_3594_ = _e938;
                                    phi_3595_ = _e940;
                                } else {
                                    phi_3594_ = type_35();
                                    phi_3595_ = true;
                                }
                                let _e942 = phi_3594_;
                                let _e944 = phi_3595_;
                                if _e944 {
                                    if _e915 {
                                        if (_e898 < 0f) {
                                            phi_3606_ = -1f;
                                        } else {
                                            phi_3606_ = 1f;
                                        }
                                        let _e947 = phi_3606_;
                                        let _e950 = (_e391 - _e368);
                                        phi_3616_ = type_9(0u, 64u);
                                        phi_3619_ = _e886;
                                        phi_3621_ = _e883;
                                        phi_3623_ = (0.5f * (_e883 + _e886));
                                        loop {
                                            let _e956 = phi_3616_;
                                            let _e958 = phi_3619_;
                                            let _e960 = phi_3621_;
                                            let _e962 = phi_3623_;
                                            local_45 = _e960;
                                            if (_e956.member < _e956.member_1) {
                                                phi_3617_ = type_9((_e956.member + 1u), _e956.member_1);
                                                phi_3646_ = type_9(1u, _e956.member);
                                            } else {
                                                phi_3617_ = _e956;
                                                phi_3646_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e974 = phi_3617_;
                                            let _e976 = phi_3646_;
                                            if (bitcast<i32>(_e976.member) != 0i) {
                                                let _e980 = (1f - _e962);
                                                let _e993 = ((_e947 * ((((_e345 * _e980) + (_e368 * _e962)) * (_e980 * _e980)) + (((_e391 * _e980) + (_e402 * _e962)) * (_e962 * _e962)))) - _e720);
                                                if (_e993 > 0f) {
                                                    phi_3671_ = _e958;
                                                    phi_3672_ = _e962;
                                                } else {
                                                    phi_3671_ = _e962;
                                                    phi_3672_ = _e960;
                                                }
                                                let _e996 = phi_3671_;
                                                let _e998 = phi_3672_;
                                                let _e1000 = ((_e996 - _e998) > 0.00000000000022737368f);
                                                if _e1000 {
                                                    let _e1001 = (1f - _e962);
                                                    let _e1013 = (-(_e993) / (_e947 * (((((_e368 - (3f * _e345)) * _e1001) + (_e950 * _e962)) * _e1001) + (((_e950 * _e1001) + (((3f * _e402) - _e391) * _e962)) * _e962))));
                                                    if (_e993 > 0f) {
                                                        phi_3698_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_3698_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1019 = phi_3698_;
                                                    let _e1021 = ((_e962 + _e1013) + _e1019);
                                                    if (_e1021 > _e998) {
                                                        if (_e1021 < _e996) {
                                                            if (_e1013 < 0f) {
                                                                phi_3714_ = -(_e1013);
                                                            } else {
                                                                phi_3714_ = _e1013;
                                                            }
                                                            let _e1027 = phi_3714_;
                                                            if (_e1027 < (0.5f * (_e996 - _e998))) {
                                                                phi_3721_ = false;
                                                            } else {
                                                                phi_3721_ = true;
                                                            }
                                                            let _e1032 = phi_3721_;
                                                            phi_3722_ = _e1032;
                                                        } else {
                                                            phi_3722_ = true;
                                                        }
                                                        let _e1034 = phi_3722_;
                                                        phi_3723_ = _e1034;
                                                    } else {
                                                        phi_3723_ = true;
                                                    }
                                                    let _e1036 = phi_3723_;
                                                    if _e1036 {
                                                        phi_3729_ = (0.5f * (_e998 + _e996));
                                                    } else {
                                                        phi_3729_ = _e1021;
                                                    }
                                                    let _e1040 = phi_3729_;
                                                    phi_3730_ = _e1040;
                                                    phi_3731_ = false;
                                                } else {
                                                    phi_3730_ = f32();
                                                    phi_3731_ = true;
                                                }
                                                let _e1042 = phi_3730_;
                                                let _e1044 = phi_3731_;
                                                phi_3620_ = _e996;
                                                phi_3622_ = _e998;
                                                phi_3624_ = _e1042;
                                                phi_3732_ = _e998;
                                                phi_3733_ = _e1000;
                                                phi_3734_ = _e1044;
                                            } else {
                                                phi_3620_ = f32();
                                                phi_3622_ = f32();
                                                phi_3624_ = f32();
                                                phi_3732_ = f32();
                                                phi_3733_ = false;
                                                phi_3734_ = false;
                                            }
                                            let _e1046 = phi_3620_;
                                            let _e1048 = phi_3622_;
                                            let _e1050 = phi_3624_;
                                            let _e1052 = phi_3732_;
                                            let _e1054 = phi_3733_;
                                            let _e1056 = phi_3734_;
                                            local_14 = _e1056;
                                            local_44 = _e1052;
                                            continue;
                                            continuing {
                                                phi_3616_ = _e974;
                                                phi_3619_ = _e1046;
                                                phi_3621_ = _e1048;
                                                phi_3623_ = _e1050;
                                                break if !(_e1054);
                                            }
                                        }
                                        let _e1059 = local_14;
                                        if _e1059 {
                                            let _e4073 = local_44;
                                            phi_3738_ = _e4073;
                                        } else {
                                            let _e4075 = local_45;
                                            phi_3738_ = _e4075;
                                        }
                                        let _e1061 = phi_3738_;
                                        phi_3739_ = _e1061;
                                    } else {
                                        phi_3739_ = _e883;
                                    }
                                    let _e1063 = phi_3739_;
                                    if _e920 {
                                        phi_3746_ = type_9(0u, 64u);
                                        phi_3749_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1066 = phi_3746_;
                                            let _e1068 = phi_3749_;
                                            if (_e1066.member < _e1066.member_1) {
                                                phi_3747_ = type_9((_e1066.member + 1u), _e1066.member_1);
                                                phi_3772_ = type_9(1u, _e1066.member);
                                            } else {
                                                phi_3747_ = _e1066;
                                                phi_3772_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1080 = phi_3747_;
                                            let _e1082 = phi_3772_;
                                            if (bitcast<i32>(_e1082.member) != 0i) {
                                                let _e1086 = (_e1063 + _e1068);
                                                if (_e1086 < _e886) {
                                                    let _e1088 = (1f - _e1086);
                                                    let _e1099 = ((((_e345 * _e1088) + (_e368 * _e1086)) * (_e1088 * _e1088)) + (((_e391 * _e1088) + (_e402 * _e1086)) * (_e1086 * _e1086)));
                                                    let _e1100 = (1f - _e1063);
                                                    let _e1111 = ((((_e345 * _e1100) + (_e368 * _e1063)) * (_e1100 * _e1100)) + (((_e391 * _e1100) + (_e402 * _e1063)) * (_e1063 * _e1063)));
                                                    if (_e1099 < 0f) {
                                                        phi_3813_ = -(_e1099);
                                                    } else {
                                                        phi_3813_ = _e1099;
                                                    }
                                                    let _e1115 = phi_3813_;
                                                    if (_e1115 > _e720) {
                                                        if (_e1111 < 0f) {
                                                            phi_3823_ = -(_e1111);
                                                        } else {
                                                            phi_3823_ = _e1111;
                                                        }
                                                        let _e1120 = phi_3823_;
                                                        if (_e1120 > _e720) {
                                                            phi_3831_ = ((_e1099 > 0f) == (_e1111 > 0f));
                                                        } else {
                                                            phi_3831_ = false;
                                                        }
                                                        let _e1126 = phi_3831_;
                                                        phi_3833_ = !(_e1126);
                                                    } else {
                                                        phi_3833_ = false;
                                                    }
                                                    let _e1129 = phi_3833_;
                                                    if _e1129 {
                                                        phi_3838_ = f32();
                                                        phi_3839_ = false;
                                                    } else {
                                                        phi_3838_ = (_e1068 + _e1068);
                                                        phi_3839_ = true;
                                                    }
                                                    let _e1132 = phi_3838_;
                                                    let _e1134 = phi_3839_;
                                                    phi_3840_ = _e1132;
                                                    phi_3841_ = _e1134;
                                                    phi_3842_ = _e1129;
                                                    phi_3843_ = false;
                                                } else {
                                                    phi_3840_ = f32();
                                                    phi_3841_ = false;
                                                    phi_3842_ = false;
                                                    phi_3843_ = true;
                                                }
                                                let _e1136 = phi_3840_;
                                                let _e1138 = phi_3841_;
                                                let _e1140 = phi_3842_;
                                                let _e1142 = phi_3843_;
                                                phi_3844_ = _e1086;
                                                phi_3750_ = _e1136;
                                                phi_3845_ = _e1138;
                                                phi_3846_ = _e1140;
                                                phi_3847_ = _e1142;
                                                phi_3848_ = false;
                                            } else {
                                                phi_3844_ = f32();
                                                phi_3750_ = f32();
                                                phi_3845_ = false;
                                                phi_3846_ = false;
                                                phi_3847_ = false;
                                                phi_3848_ = true;
                                            }
                                            let _e1144 = phi_3844_;
                                            let _e1146 = phi_3750_;
                                            let _e1148 = phi_3845_;
                                            let _e1150 = phi_3846_;
                                            let _e1152 = phi_3847_;
                                            let _e1154 = phi_3848_;
                                            local_15 = _e1150;
                                            local_46 = _e1152;
                                            local_47 = _e1154;
                                            local_48 = _e1144;
                                            continue;
                                            continuing {
                                                phi_3746_ = _e1080;
                                                phi_3749_ = _e1146;
                                                break if !(_e1148);
                                            }
                                        }
                                        let _e1157 = local_15;
                                        if _e1157 {
                                            phi_3852_ = false;
                                            phi_3853_ = false;
                                        } else {
                                            let _e4100 = local_46;
                                            phi_3852_ = _e4100;
                                            let _e4103 = local_47;
                                            phi_3853_ = _e4103;
                                        }
                                        let _e1159 = phi_3852_;
                                        let _e1161 = phi_3853_;
                                        if _e1159 {
                                            phi_3857_ = true;
                                        } else {
                                            phi_3857_ = _e1161;
                                        }
                                        let _e1163 = phi_3857_;
                                        if _e1163 {
                                            phi_3861_ = _e886;
                                        } else {
                                            let _e4107 = local_48;
                                            phi_3861_ = _e4107;
                                        }
                                        let _e1165 = phi_3861_;
                                        phi_3862_ = _e1165;
                                    } else {
                                        phi_3862_ = _e886;
                                    }
                                    let _e1167 = phi_3862_;
                                    phi_3864_ = type_35(_e1063, _e1167, _e933);
                                } else {
                                    phi_3864_ = _e942;
                                }
                                let _e1170 = phi_3864_;
                                if (_e1170.member > _e1170.member_1) {
                                    phi_5969_ = f32();
                                    phi_5970_ = true;
                                    phi_5971_ = false;
                                    phi_5972_ = false;
                                    phi_5973_ = false;
                                } else {
                                    let _e1177 = ((_e1170.member_1 - _e1170.member) * 0.5f);
                                    let _e1178 = (_e1170.member + _e1177);
                                    let _e1180 = (_e1177 + (0.000000059604645f * 4f));
                                    let _e1182 = local_12.member_3;
                                    let _e1185 = local_12.member[0u];
                                    if (_e1185[0] < 0f) {
                                        phi_3893_ = -(_e1185[0]);
                                    } else {
                                        phi_3893_ = _e1185[0];
                                    }
                                    let _e1192 = phi_3893_;
                                    if (_e1185[1] < 0f) {
                                        phi_3900_ = -(_e1185[1]);
                                    } else {
                                        phi_3900_ = _e1185[1];
                                    }
                                    let _e1196 = phi_3900_;
                                    if (_e1192 > _e1196) {
                                        phi_3905_ = _e1192;
                                    } else {
                                        phi_3905_ = _e1196;
                                    }
                                    let _e1199 = phi_3905_;
                                    if (_e1185[2] < 0f) {
                                        phi_3912_ = -(_e1185[2]);
                                    } else {
                                        phi_3912_ = _e1185[2];
                                    }
                                    let _e1203 = phi_3912_;
                                    if (_e1199 > _e1203) {
                                        phi_3917_ = _e1199;
                                    } else {
                                        phi_3917_ = _e1203;
                                    }
                                    let _e1206 = phi_3917_;
                                    let _e1208 = local_12.member[1u];
                                    if (_e1208[0] < 0f) {
                                        phi_3930_ = -(_e1208[0]);
                                    } else {
                                        phi_3930_ = _e1208[0];
                                    }
                                    let _e1215 = phi_3930_;
                                    if (_e1208[1] < 0f) {
                                        phi_3937_ = -(_e1208[1]);
                                    } else {
                                        phi_3937_ = _e1208[1];
                                    }
                                    let _e1219 = phi_3937_;
                                    if (_e1215 > _e1219) {
                                        phi_3942_ = _e1215;
                                    } else {
                                        phi_3942_ = _e1219;
                                    }
                                    let _e1222 = phi_3942_;
                                    if (_e1208[2] < 0f) {
                                        phi_3949_ = -(_e1208[2]);
                                    } else {
                                        phi_3949_ = _e1208[2];
                                    }
                                    let _e1226 = phi_3949_;
                                    if (_e1222 > _e1226) {
                                        phi_3954_ = _e1222;
                                    } else {
                                        phi_3954_ = _e1226;
                                    }
                                    let _e1229 = phi_3954_;
                                    if (_e1206 > _e1229) {
                                        phi_3959_ = _e1206;
                                    } else {
                                        phi_3959_ = _e1229;
                                    }
                                    let _e1232 = phi_3959_;
                                    let _e1235 = local_12.member[0u];
                                    let _e1240 = local_12.member[1u];
                                    let _e1250 = (_e1235[0] + ((_e1240[0] - _e1235[0]) * _e1178));
                                    let _e1251 = (_e1235[1] + ((_e1240[1] - _e1235[1]) * _e1178));
                                    let _e1252 = (_e1235[2] + ((_e1240[2] - _e1235[2]) * _e1178));
                                    let _e1254 = local_12.member[1u];
                                    let _e1259 = local_12.member[0u];
                                    let _e1263 = (_e1254[0] - _e1259[0]);
                                    let _e1264 = (_e1254[1] - _e1259[1]);
                                    let _e1265 = (_e1254[2] - _e1259[2]);
                                    if (_e1263 < 0f) {
                                        phi_4018_ = -(_e1263);
                                    } else {
                                        phi_4018_ = _e1263;
                                    }
                                    let _e1269 = phi_4018_;
                                    if (_e1264 < 0f) {
                                        phi_4024_ = -(_e1264);
                                    } else {
                                        phi_4024_ = _e1264;
                                    }
                                    let _e1273 = phi_4024_;
                                    if (_e1269 > _e1273) {
                                        phi_4029_ = _e1269;
                                    } else {
                                        phi_4029_ = _e1273;
                                    }
                                    let _e1276 = phi_4029_;
                                    if (_e1265 < 0f) {
                                        phi_4035_ = -(_e1265);
                                    } else {
                                        phi_4035_ = _e1265;
                                    }
                                    let _e1280 = phi_4035_;
                                    if (_e1276 > _e1280) {
                                        phi_4040_ = _e1276;
                                    } else {
                                        phi_4040_ = _e1280;
                                    }
                                    let _e1283 = phi_4040_;
                                    let _e1289 = ((((_e1180 * _e1283) * 1.01f) + ((_e1232 + _e1182) * (0.000000059604645f * 8f))) + _e1182);
                                    if (_e1250 < 0f) {
                                        phi_4052_ = -(_e1250);
                                    } else {
                                        phi_4052_ = _e1250;
                                    }
                                    let _e1293 = phi_4052_;
                                    if (_e1251 < 0f) {
                                        phi_4058_ = -(_e1251);
                                    } else {
                                        phi_4058_ = _e1251;
                                    }
                                    let _e1297 = phi_4058_;
                                    if (_e1293 > _e1297) {
                                        phi_4063_ = _e1293;
                                    } else {
                                        phi_4063_ = _e1297;
                                    }
                                    let _e1300 = phi_4063_;
                                    if (_e1252 < 0f) {
                                        phi_4069_ = -(_e1252);
                                    } else {
                                        phi_4069_ = _e1252;
                                    }
                                    let _e1304 = phi_4069_;
                                    if (_e1300 > _e1304) {
                                        phi_4074_ = _e1300;
                                    } else {
                                        phi_4074_ = _e1304;
                                    }
                                    let _e1307 = phi_4074_;
                                    local_2 = type_27(array<f32, 3>(_e1250, _e1251, _e1252), _e1289, (_e1307 + _e1289));
                                    let _e1313 = local_12.member_3;
                                    let _e1315 = local_12.member_1[0u];
                                    if (_e1315[0] < 0f) {
                                        phi_4100_ = -(_e1315[0]);
                                    } else {
                                        phi_4100_ = _e1315[0];
                                    }
                                    let _e1322 = phi_4100_;
                                    if (_e1315[1] < 0f) {
                                        phi_4107_ = -(_e1315[1]);
                                    } else {
                                        phi_4107_ = _e1315[1];
                                    }
                                    let _e1326 = phi_4107_;
                                    if (_e1322 > _e1326) {
                                        phi_4112_ = _e1322;
                                    } else {
                                        phi_4112_ = _e1326;
                                    }
                                    let _e1329 = phi_4112_;
                                    if (_e1315[2] < 0f) {
                                        phi_4119_ = -(_e1315[2]);
                                    } else {
                                        phi_4119_ = _e1315[2];
                                    }
                                    let _e1333 = phi_4119_;
                                    if (_e1329 > _e1333) {
                                        phi_4124_ = _e1329;
                                    } else {
                                        phi_4124_ = _e1333;
                                    }
                                    let _e1336 = phi_4124_;
                                    let _e1338 = local_12.member_1[1u];
                                    if (_e1338[0] < 0f) {
                                        phi_4137_ = -(_e1338[0]);
                                    } else {
                                        phi_4137_ = _e1338[0];
                                    }
                                    let _e1345 = phi_4137_;
                                    if (_e1338[1] < 0f) {
                                        phi_4144_ = -(_e1338[1]);
                                    } else {
                                        phi_4144_ = _e1338[1];
                                    }
                                    let _e1349 = phi_4144_;
                                    if (_e1345 > _e1349) {
                                        phi_4149_ = _e1345;
                                    } else {
                                        phi_4149_ = _e1349;
                                    }
                                    let _e1352 = phi_4149_;
                                    if (_e1338[2] < 0f) {
                                        phi_4156_ = -(_e1338[2]);
                                    } else {
                                        phi_4156_ = _e1338[2];
                                    }
                                    let _e1356 = phi_4156_;
                                    if (_e1352 > _e1356) {
                                        phi_4161_ = _e1352;
                                    } else {
                                        phi_4161_ = _e1356;
                                    }
                                    let _e1359 = phi_4161_;
                                    if (_e1336 > _e1359) {
                                        phi_4166_ = _e1336;
                                    } else {
                                        phi_4166_ = _e1359;
                                    }
                                    let _e1362 = phi_4166_;
                                    let _e1365 = local_12.member_1[0u];
                                    let _e1370 = local_12.member_1[1u];
                                    let _e1380 = (_e1365[0] + ((_e1370[0] - _e1365[0]) * _e1178));
                                    let _e1381 = (_e1365[1] + ((_e1370[1] - _e1365[1]) * _e1178));
                                    let _e1382 = (_e1365[2] + ((_e1370[2] - _e1365[2]) * _e1178));
                                    let _e1384 = local_12.member_1[1u];
                                    let _e1389 = local_12.member_1[0u];
                                    let _e1393 = (_e1384[0] - _e1389[0]);
                                    let _e1394 = (_e1384[1] - _e1389[1]);
                                    let _e1395 = (_e1384[2] - _e1389[2]);
                                    if (_e1393 < 0f) {
                                        phi_4225_ = -(_e1393);
                                    } else {
                                        phi_4225_ = _e1393;
                                    }
                                    let _e1399 = phi_4225_;
                                    if (_e1394 < 0f) {
                                        phi_4231_ = -(_e1394);
                                    } else {
                                        phi_4231_ = _e1394;
                                    }
                                    let _e1403 = phi_4231_;
                                    if (_e1399 > _e1403) {
                                        phi_4236_ = _e1399;
                                    } else {
                                        phi_4236_ = _e1403;
                                    }
                                    let _e1406 = phi_4236_;
                                    if (_e1395 < 0f) {
                                        phi_4242_ = -(_e1395);
                                    } else {
                                        phi_4242_ = _e1395;
                                    }
                                    let _e1410 = phi_4242_;
                                    if (_e1406 > _e1410) {
                                        phi_4247_ = _e1406;
                                    } else {
                                        phi_4247_ = _e1410;
                                    }
                                    let _e1413 = phi_4247_;
                                    let _e1419 = ((((_e1180 * _e1413) * 1.01f) + ((_e1362 + _e1313) * (0.000000059604645f * 8f))) + _e1313);
                                    if (_e1380 < 0f) {
                                        phi_4259_ = -(_e1380);
                                    } else {
                                        phi_4259_ = _e1380;
                                    }
                                    let _e1423 = phi_4259_;
                                    if (_e1381 < 0f) {
                                        phi_4265_ = -(_e1381);
                                    } else {
                                        phi_4265_ = _e1381;
                                    }
                                    let _e1427 = phi_4265_;
                                    if (_e1423 > _e1427) {
                                        phi_4270_ = _e1423;
                                    } else {
                                        phi_4270_ = _e1427;
                                    }
                                    let _e1430 = phi_4270_;
                                    if (_e1382 < 0f) {
                                        phi_4276_ = -(_e1382);
                                    } else {
                                        phi_4276_ = _e1382;
                                    }
                                    let _e1434 = phi_4276_;
                                    if (_e1430 > _e1434) {
                                        phi_4281_ = _e1430;
                                    } else {
                                        phi_4281_ = _e1434;
                                    }
                                    let _e1437 = phi_4281_;
                                    local_3 = type_27(array<f32, 3>(_e1380, _e1381, _e1382), _e1419, (_e1437 + _e1419));
                                    let _e1443 = local_12.member_3;
                                    let _e1445 = local_12.member_2[0u];
                                    if (_e1445[0] < 0f) {
                                        phi_4307_ = -(_e1445[0]);
                                    } else {
                                        phi_4307_ = _e1445[0];
                                    }
                                    let _e1452 = phi_4307_;
                                    if (_e1445[1] < 0f) {
                                        phi_4314_ = -(_e1445[1]);
                                    } else {
                                        phi_4314_ = _e1445[1];
                                    }
                                    let _e1456 = phi_4314_;
                                    if (_e1452 > _e1456) {
                                        phi_4319_ = _e1452;
                                    } else {
                                        phi_4319_ = _e1456;
                                    }
                                    let _e1459 = phi_4319_;
                                    if (_e1445[2] < 0f) {
                                        phi_4326_ = -(_e1445[2]);
                                    } else {
                                        phi_4326_ = _e1445[2];
                                    }
                                    let _e1463 = phi_4326_;
                                    if (_e1459 > _e1463) {
                                        phi_4331_ = _e1459;
                                    } else {
                                        phi_4331_ = _e1463;
                                    }
                                    let _e1466 = phi_4331_;
                                    let _e1468 = local_12.member_2[1u];
                                    if (_e1468[0] < 0f) {
                                        phi_4344_ = -(_e1468[0]);
                                    } else {
                                        phi_4344_ = _e1468[0];
                                    }
                                    let _e1475 = phi_4344_;
                                    if (_e1468[1] < 0f) {
                                        phi_4351_ = -(_e1468[1]);
                                    } else {
                                        phi_4351_ = _e1468[1];
                                    }
                                    let _e1479 = phi_4351_;
                                    if (_e1475 > _e1479) {
                                        phi_4356_ = _e1475;
                                    } else {
                                        phi_4356_ = _e1479;
                                    }
                                    let _e1482 = phi_4356_;
                                    if (_e1468[2] < 0f) {
                                        phi_4363_ = -(_e1468[2]);
                                    } else {
                                        phi_4363_ = _e1468[2];
                                    }
                                    let _e1486 = phi_4363_;
                                    if (_e1482 > _e1486) {
                                        phi_4368_ = _e1482;
                                    } else {
                                        phi_4368_ = _e1486;
                                    }
                                    let _e1489 = phi_4368_;
                                    if (_e1466 > _e1489) {
                                        phi_4373_ = _e1466;
                                    } else {
                                        phi_4373_ = _e1489;
                                    }
                                    let _e1492 = phi_4373_;
                                    let _e1495 = local_12.member_2[0u];
                                    let _e1500 = local_12.member_2[1u];
                                    let _e1510 = (_e1495[0] + ((_e1500[0] - _e1495[0]) * _e1178));
                                    let _e1511 = (_e1495[1] + ((_e1500[1] - _e1495[1]) * _e1178));
                                    let _e1512 = (_e1495[2] + ((_e1500[2] - _e1495[2]) * _e1178));
                                    let _e1514 = local_12.member_2[1u];
                                    let _e1519 = local_12.member_2[0u];
                                    let _e1523 = (_e1514[0] - _e1519[0]);
                                    let _e1524 = (_e1514[1] - _e1519[1]);
                                    let _e1525 = (_e1514[2] - _e1519[2]);
                                    if (_e1523 < 0f) {
                                        phi_4432_ = -(_e1523);
                                    } else {
                                        phi_4432_ = _e1523;
                                    }
                                    let _e1529 = phi_4432_;
                                    if (_e1524 < 0f) {
                                        phi_4438_ = -(_e1524);
                                    } else {
                                        phi_4438_ = _e1524;
                                    }
                                    let _e1533 = phi_4438_;
                                    if (_e1529 > _e1533) {
                                        phi_4443_ = _e1529;
                                    } else {
                                        phi_4443_ = _e1533;
                                    }
                                    let _e1536 = phi_4443_;
                                    if (_e1525 < 0f) {
                                        phi_4449_ = -(_e1525);
                                    } else {
                                        phi_4449_ = _e1525;
                                    }
                                    let _e1540 = phi_4449_;
                                    if (_e1536 > _e1540) {
                                        phi_4454_ = _e1536;
                                    } else {
                                        phi_4454_ = _e1540;
                                    }
                                    let _e1543 = phi_4454_;
                                    let _e1549 = ((((_e1180 * _e1543) * 1.01f) + ((_e1492 + _e1443) * (0.000000059604645f * 8f))) + _e1443);
                                    if (_e1510 < 0f) {
                                        phi_4466_ = -(_e1510);
                                    } else {
                                        phi_4466_ = _e1510;
                                    }
                                    let _e1553 = phi_4466_;
                                    if (_e1511 < 0f) {
                                        phi_4472_ = -(_e1511);
                                    } else {
                                        phi_4472_ = _e1511;
                                    }
                                    let _e1557 = phi_4472_;
                                    if (_e1553 > _e1557) {
                                        phi_4477_ = _e1553;
                                    } else {
                                        phi_4477_ = _e1557;
                                    }
                                    let _e1560 = phi_4477_;
                                    if (_e1512 < 0f) {
                                        phi_4483_ = -(_e1512);
                                    } else {
                                        phi_4483_ = _e1512;
                                    }
                                    let _e1564 = phi_4483_;
                                    if (_e1560 > _e1564) {
                                        phi_4488_ = _e1560;
                                    } else {
                                        phi_4488_ = _e1564;
                                    }
                                    let _e1567 = phi_4488_;
                                    local_4 = type_27(array<f32, 3>(_e1510, _e1511, _e1512), _e1549, (_e1567 + _e1549));
                                    let _e1572 = local_3.member;
                                    let _e1577 = local_4.member;
                                    let _e1583 = ((_e1572[1] * _e1577[2]) - (_e1572[2] * _e1577[1]));
                                    let _e1586 = ((_e1572[2] * _e1577[0]) - (_e1572[0] * _e1577[2]));
                                    let _e1589 = ((_e1572[0] * _e1577[1]) - (_e1572[1] * _e1577[0]));
                                    if (_e1583 < 0f) {
                                        phi_4537_ = -(_e1583);
                                    } else {
                                        phi_4537_ = _e1583;
                                    }
                                    let _e1593 = phi_4537_;
                                    if (_e1586 < 0f) {
                                        phi_4543_ = -(_e1586);
                                    } else {
                                        phi_4543_ = _e1586;
                                    }
                                    let _e1597 = phi_4543_;
                                    if (_e1593 > _e1597) {
                                        if (_e1583 < 0f) {
                                            phi_4553_ = -(_e1583);
                                        } else {
                                            phi_4553_ = _e1583;
                                        }
                                        let _e1615 = phi_4553_;
                                        if (_e1589 < 0f) {
                                            phi_4559_ = -(_e1589);
                                        } else {
                                            phi_4559_ = _e1589;
                                        }
                                        let _e1619 = phi_4559_;
                                        if (_e1615 > _e1619) {
                                            phi_4564_ = 2u;
                                            phi_4565_ = 1u;
                                        } else {
                                            phi_4564_ = 1u;
                                            phi_4565_ = 0u;
                                        }
                                        let _e1622 = phi_4564_;
                                        let _e1624 = phi_4565_;
                                        phi_4584_ = _e1622;
                                        phi_4585_ = _e1624;
                                    } else {
                                        if (_e1586 < 0f) {
                                            phi_4571_ = -(_e1586);
                                        } else {
                                            phi_4571_ = _e1586;
                                        }
                                        let _e1602 = phi_4571_;
                                        if (_e1589 < 0f) {
                                            phi_4577_ = -(_e1589);
                                        } else {
                                            phi_4577_ = _e1589;
                                        }
                                        let _e1606 = phi_4577_;
                                        if (_e1602 > _e1606) {
                                            phi_4582_ = 0u;
                                            phi_4583_ = 2u;
                                        } else {
                                            phi_4582_ = 1u;
                                            phi_4583_ = 0u;
                                        }
                                        let _e1609 = phi_4582_;
                                        let _e1611 = phi_4583_;
                                        phi_4584_ = _e1609;
                                        phi_4585_ = _e1611;
                                    }
                                    let _e1626 = phi_4584_;
                                    let _e1628 = phi_4585_;
                                    let _e1631 = local_3.member[_e1628];
                                    let _e1634 = local_4.member[_e1626];
                                    let _e1638 = local_3.member[_e1626];
                                    let _e1641 = local_4.member[_e1628];
                                    let _e1643 = ((_e1631 * _e1634) - (_e1638 * _e1641));
                                    let _e1645 = local_3.member_1;
                                    let _e1647 = local_4.member_2;
                                    let _e1650 = local_3.member_2;
                                    let _e1652 = local_4.member_1;
                                    let _e1657 = local_3.member_2;
                                    let _e1659 = local_4.member_2;
                                    let _e1666 = local_3.member_2;
                                    let _e1669 = local_4.member_2;
                                    let _e1673 = (((((_e1645 * _e1647) + (_e1650 * _e1652)) * 2.01f) + ((_e1657 * _e1659) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1666) * (1f + _e1669))));
                                    if (_e1643 < 0f) {
                                        phi_4652_ = -(_e1643);
                                    } else {
                                        phi_4652_ = _e1643;
                                    }
                                    let _e1677 = phi_4652_;
                                    if (_e1677 > _e1673) {
                                        if (_e1643 < 0f) {
                                            phi_4661_ = -1f;
                                        } else {
                                            phi_4661_ = 1f;
                                        }
                                        let _e1681 = phi_4661_;
                                        let _e1684 = local_2.member[_e1628];
                                        let _e1687 = local_4.member[_e1626];
                                        let _e1691 = local_2.member[_e1626];
                                        let _e1694 = local_4.member[_e1628];
                                        let _e1698 = local_2.member_1;
                                        let _e1700 = local_4.member_2;
                                        let _e1703 = local_2.member_2;
                                        let _e1705 = local_4.member_1;
                                        let _e1710 = local_2.member_2;
                                        let _e1712 = local_4.member_2;
                                        let _e1719 = local_2.member_2;
                                        let _e1722 = local_4.member_2;
                                        let _e1726 = (((((_e1698 * _e1700) + (_e1703 * _e1705)) * 2.01f) + ((_e1710 * _e1712) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1719) * (1f + _e1722))));
                                        let _e1729 = local_3.member[_e1628];
                                        let _e1732 = local_2.member[_e1626];
                                        let _e1736 = local_3.member[_e1626];
                                        let _e1739 = local_2.member[_e1628];
                                        let _e1743 = local_3.member_1;
                                        let _e1745 = local_2.member_2;
                                        let _e1748 = local_3.member_2;
                                        let _e1750 = local_2.member_1;
                                        let _e1755 = local_3.member_2;
                                        let _e1757 = local_2.member_2;
                                        let _e1764 = local_3.member_2;
                                        let _e1767 = local_2.member_2;
                                        let _e1771 = (((((_e1743 * _e1745) + (_e1748 * _e1750)) * 2.01f) + ((_e1755 * _e1757) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1764) * (1f + _e1767))));
                                        let _e1772 = (_e1643 * _e1681);
                                        let _e1773 = (((_e1684 * _e1687) - (_e1691 * _e1694)) * _e1681);
                                        let _e1774 = (((_e1729 * _e1732) - (_e1736 * _e1739)) * _e1681);
                                        if (_e1772 < 0f) {
                                            phi_4792_ = -(_e1772);
                                        } else {
                                            phi_4792_ = _e1772;
                                        }
                                        let _e1778 = phi_4792_;
                                        if (_e1773 < 0f) {
                                            phi_4798_ = -(_e1773);
                                        } else {
                                            phi_4798_ = _e1773;
                                        }
                                        let _e1782 = phi_4798_;
                                        if (_e1774 < 0f) {
                                            phi_4805_ = -(_e1774);
                                        } else {
                                            phi_4805_ = _e1774;
                                        }
                                        let _e1787 = phi_4805_;
                                        let _e1792 = ((_e1772 - _e1773) - _e1774);
                                        let _e1795 = (((_e1673 + _e1726) + _e1771) + (((_e1778 + _e1782) + _e1787) * (0.000000059604645f * 4f)));
                                        local_5[0u].member = _e1773;
                                        local_5[0u].member_1 = _e1726;
                                        local_5[1u].member = _e1774;
                                        local_5[1u].member_1 = _e1771;
                                        local_5[2u].member = _e1792;
                                        local_5[2u].member_1 = _e1795;
                                        local_5[3u].member = _e1792;
                                        local_5[3u].member_1 = _e1795;
                                        phi_4848_ = type_9(0u, 4u);
                                        phi_4851_ = true;
                                        loop {
                                            let _e1810 = phi_4848_;
                                            let _e1812 = phi_4851_;
                                            local_17 = _e1812;
                                            if (_e1810.member < _e1810.member_1) {
                                                phi_4849_ = type_9((_e1810.member + 1u), _e1810.member_1);
                                                phi_4874_ = type_9(1u, _e1810.member);
                                            } else {
                                                phi_4849_ = _e1810;
                                                phi_4874_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1824 = phi_4849_;
                                            let _e1826 = phi_4874_;
                                            if (bitcast<i32>(_e1826.member) != 0i) {
                                                let _e1833 = local_5[_e1826.member_1].member;
                                                let _e1836 = local_5[_e1826.member_1].member_1;
                                                let _e1838 = (_e1833 < -(_e1836));
                                                if _e1838 {
                                                    phi_4901_ = bool();
                                                    phi_4902_ = false;
                                                } else {
                                                    phi_4901_ = (_e1812 && (_e1833 > _e1836));
                                                    phi_4902_ = true;
                                                }
                                                let _e1842 = phi_4901_;
                                                let _e1844 = phi_4902_;
                                                phi_4852_ = _e1842;
                                                phi_4903_ = _e1844;
                                                phi_4904_ = _e1838;
                                            } else {
                                                phi_4852_ = bool();
                                                phi_4903_ = false;
                                                phi_4904_ = false;
                                            }
                                            let _e1846 = phi_4852_;
                                            let _e1848 = phi_4903_;
                                            let _e1850 = phi_4904_;
                                            local_16 = _e1850;
                                            continue;
                                            continuing {
                                                phi_4848_ = _e1824;
                                                phi_4851_ = _e1846;
                                                break if !(_e1848);
                                            }
                                        }
                                        let _e1853 = local_16;
                                        if _e1853 {
                                            phi_4908_ = false;
                                        } else {
                                            phi_4908_ = true;
                                        }
                                        let _e1855 = phi_4908_;
                                        if _e1855 {
                                            let _e1857 = local_17;
                                            if _e1857 {
                                                phi_4915_ = 1u;
                                            } else {
                                                phi_4915_ = 2u;
                                            }
                                            let _e1859 = phi_4915_;
                                            phi_4916_ = _e1859;
                                            phi_4917_ = false;
                                        } else {
                                            phi_4916_ = u32();
                                            phi_4917_ = true;
                                        }
                                        let _e1861 = phi_4916_;
                                        let _e1863 = phi_4917_;
                                        phi_4918_ = _e1861;
                                        phi_4919_ = 0u;
                                        phi_4920_ = _e1863;
                                    } else {
                                        phi_4918_ = u32();
                                        phi_4919_ = 2u;
                                        phi_4920_ = true;
                                    }
                                    let _e1865 = phi_4918_;
                                    let _e1867 = phi_4919_;
                                    let _e1869 = phi_4920_;
                                    if _e1869 {
                                        phi_4924_ = _e1867;
                                    } else {
                                        phi_4924_ = _e1865;
                                    }
                                    let _e1871 = phi_4924_;
                                    let _e1872 = (_e1871 == 0u);
                                    if _e1872 {
                                        phi_5965_ = f32();
                                        phi_5966_ = false;
                                        phi_5967_ = false;
                                        phi_5968_ = false;
                                    } else {
                                        if (_e1871 == 1u) {
                                            if _e1170.member_2 {
                                                if ((_e1170.member_1 - _e1170.member) <= 0.0000005f) {
                                                    phi_4944_ = false;
                                                } else {
                                                    phi_4944_ = true;
                                                }
                                                let _e1880 = phi_4944_;
                                                phi_4945_ = _e1880;
                                            } else {
                                                phi_4945_ = true;
                                            }
                                            let _e1882 = phi_4945_;
                                            phi_4946_ = _e1882;
                                        } else {
                                            phi_4946_ = true;
                                        }
                                        let _e1884 = phi_4946_;
                                        if _e1884 {
                                            let _e1889 = local_12.member[0u];
                                            let _e1895 = local_12.member_1[0u];
                                            let _e1901 = local_12.member_2[0u];
                                            local = array<array<f32, 3>, 4>(_e1889, array<f32, 3>((_e1889[0] - _e1895[0]), (_e1889[1] - _e1895[1]), (_e1889[2] - _e1895[2])), array<f32, 3>((_e1889[0] - _e1901[0]), (_e1889[1] - _e1901[1]), (_e1889[2] - _e1901[2])), _e1889);
                                            let _e1916 = local_12.member[1u];
                                            let _e1922 = local_12.member_1[1u];
                                            let _e1928 = local_12.member_2[1u];
                                            local_1 = array<array<f32, 3>, 4>(_e1916, array<f32, 3>((_e1916[0] - _e1922[0]), (_e1916[1] - _e1922[1]), (_e1916[2] - _e1922[2])), array<f32, 3>((_e1916[0] - _e1928[0]), (_e1916[1] - _e1928[1]), (_e1916[2] - _e1928[2])), _e1916);
                                            let _e1943 = local_12.member[0u];
                                            if (_e1943[0] < 0f) {
                                                phi_5142_ = -(_e1943[0]);
                                            } else {
                                                phi_5142_ = _e1943[0];
                                            }
                                            let _e1950 = phi_5142_;
                                            if (_e1943[1] < 0f) {
                                                phi_5149_ = -(_e1943[1]);
                                            } else {
                                                phi_5149_ = _e1943[1];
                                            }
                                            let _e1954 = phi_5149_;
                                            if (_e1950 > _e1954) {
                                                phi_5154_ = _e1950;
                                            } else {
                                                phi_5154_ = _e1954;
                                            }
                                            let _e1957 = phi_5154_;
                                            if (_e1943[2] < 0f) {
                                                phi_5161_ = -(_e1943[2]);
                                            } else {
                                                phi_5161_ = _e1943[2];
                                            }
                                            let _e1961 = phi_5161_;
                                            if (_e1957 > _e1961) {
                                                phi_5166_ = _e1957;
                                            } else {
                                                phi_5166_ = _e1961;
                                            }
                                            let _e1964 = phi_5166_;
                                            let _e1967 = local_12.member[1u];
                                            if (_e1967[0] < 0f) {
                                                phi_5179_ = -(_e1967[0]);
                                            } else {
                                                phi_5179_ = _e1967[0];
                                            }
                                            let _e1974 = phi_5179_;
                                            if (_e1967[1] < 0f) {
                                                phi_5186_ = -(_e1967[1]);
                                            } else {
                                                phi_5186_ = _e1967[1];
                                            }
                                            let _e1978 = phi_5186_;
                                            if (_e1974 > _e1978) {
                                                phi_5191_ = _e1974;
                                            } else {
                                                phi_5191_ = _e1978;
                                            }
                                            let _e1981 = phi_5191_;
                                            if (_e1967[2] < 0f) {
                                                phi_5198_ = -(_e1967[2]);
                                            } else {
                                                phi_5198_ = _e1967[2];
                                            }
                                            let _e1985 = phi_5198_;
                                            if (_e1981 > _e1985) {
                                                phi_5203_ = _e1981;
                                            } else {
                                                phi_5203_ = _e1985;
                                            }
                                            let _e1988 = phi_5203_;
                                            if (_e1964 > _e1988) {
                                                phi_5208_ = _e1964;
                                            } else {
                                                phi_5208_ = _e1988;
                                            }
                                            let _e1991 = phi_5208_;
                                            let _e1993 = local_12.member_3;
                                            let _e1997 = local_12.member_1[0u];
                                            if (_e1997[0] < 0f) {
                                                phi_5225_ = -(_e1997[0]);
                                            } else {
                                                phi_5225_ = _e1997[0];
                                            }
                                            let _e2004 = phi_5225_;
                                            if (_e1997[1] < 0f) {
                                                phi_5232_ = -(_e1997[1]);
                                            } else {
                                                phi_5232_ = _e1997[1];
                                            }
                                            let _e2008 = phi_5232_;
                                            if (_e2004 > _e2008) {
                                                phi_5237_ = _e2004;
                                            } else {
                                                phi_5237_ = _e2008;
                                            }
                                            let _e2011 = phi_5237_;
                                            if (_e1997[2] < 0f) {
                                                phi_5244_ = -(_e1997[2]);
                                            } else {
                                                phi_5244_ = _e1997[2];
                                            }
                                            let _e2015 = phi_5244_;
                                            if (_e2011 > _e2015) {
                                                phi_5249_ = _e2011;
                                            } else {
                                                phi_5249_ = _e2015;
                                            }
                                            let _e2018 = phi_5249_;
                                            let _e2021 = local_12.member_1[1u];
                                            if (_e2021[0] < 0f) {
                                                phi_5263_ = -(_e2021[0]);
                                            } else {
                                                phi_5263_ = _e2021[0];
                                            }
                                            let _e2028 = phi_5263_;
                                            if (_e2021[1] < 0f) {
                                                phi_5270_ = -(_e2021[1]);
                                            } else {
                                                phi_5270_ = _e2021[1];
                                            }
                                            let _e2032 = phi_5270_;
                                            if (_e2028 > _e2032) {
                                                phi_5275_ = _e2028;
                                            } else {
                                                phi_5275_ = _e2032;
                                            }
                                            let _e2035 = phi_5275_;
                                            if (_e2021[2] < 0f) {
                                                phi_5282_ = -(_e2021[2]);
                                            } else {
                                                phi_5282_ = _e2021[2];
                                            }
                                            let _e2039 = phi_5282_;
                                            if (_e2035 > _e2039) {
                                                phi_5287_ = _e2035;
                                            } else {
                                                phi_5287_ = _e2039;
                                            }
                                            let _e2042 = phi_5287_;
                                            if (_e2018 > _e2042) {
                                                phi_5292_ = _e2018;
                                            } else {
                                                phi_5292_ = _e2042;
                                            }
                                            let _e2045 = phi_5292_;
                                            let _e2047 = local_12.member_3;
                                            let _e2051 = local_12.member_2[0u];
                                            if (_e2051[0] < 0f) {
                                                phi_5309_ = -(_e2051[0]);
                                            } else {
                                                phi_5309_ = _e2051[0];
                                            }
                                            let _e2058 = phi_5309_;
                                            if (_e2051[1] < 0f) {
                                                phi_5316_ = -(_e2051[1]);
                                            } else {
                                                phi_5316_ = _e2051[1];
                                            }
                                            let _e2062 = phi_5316_;
                                            if (_e2058 > _e2062) {
                                                phi_5321_ = _e2058;
                                            } else {
                                                phi_5321_ = _e2062;
                                            }
                                            let _e2065 = phi_5321_;
                                            if (_e2051[2] < 0f) {
                                                phi_5328_ = -(_e2051[2]);
                                            } else {
                                                phi_5328_ = _e2051[2];
                                            }
                                            let _e2069 = phi_5328_;
                                            if (_e2065 > _e2069) {
                                                phi_5333_ = _e2065;
                                            } else {
                                                phi_5333_ = _e2069;
                                            }
                                            let _e2072 = phi_5333_;
                                            let _e2075 = local_12.member_2[1u];
                                            if (_e2075[0] < 0f) {
                                                phi_5347_ = -(_e2075[0]);
                                            } else {
                                                phi_5347_ = _e2075[0];
                                            }
                                            let _e2082 = phi_5347_;
                                            if (_e2075[1] < 0f) {
                                                phi_5354_ = -(_e2075[1]);
                                            } else {
                                                phi_5354_ = _e2075[1];
                                            }
                                            let _e2086 = phi_5354_;
                                            if (_e2082 > _e2086) {
                                                phi_5359_ = _e2082;
                                            } else {
                                                phi_5359_ = _e2086;
                                            }
                                            let _e2089 = phi_5359_;
                                            if (_e2075[2] < 0f) {
                                                phi_5366_ = -(_e2075[2]);
                                            } else {
                                                phi_5366_ = _e2075[2];
                                            }
                                            let _e2093 = phi_5366_;
                                            if (_e2089 > _e2093) {
                                                phi_5371_ = _e2089;
                                            } else {
                                                phi_5371_ = _e2093;
                                            }
                                            let _e2096 = phi_5371_;
                                            if (_e2072 > _e2096) {
                                                phi_5376_ = _e2072;
                                            } else {
                                                phi_5376_ = _e2096;
                                            }
                                            let _e2099 = phi_5376_;
                                            let _e2101 = local_12.member_3;
                                            let _e2108 = local_12.member_3;
                                            phi_5392_ = type_9(0u, 48u);
                                            phi_5395_ = _e1170.member;
                                            loop {
                                                let _e2114 = phi_5392_;
                                                let _e2116 = phi_5395_;
                                                local_61 = _e2116;
                                                local_24 = _e2116;
                                                local_25 = _e2116;
                                                local_26 = _e2116;
                                                local_27 = _e2116;
                                                if (_e2114.member < _e2114.member_1) {
                                                    phi_5393_ = type_9((_e2114.member + 1u), _e2114.member_1);
                                                    phi_5418_ = type_9(1u, _e2114.member);
                                                } else {
                                                    phi_5393_ = _e2114;
                                                    phi_5418_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2128 = phi_5393_;
                                                let _e2130 = phi_5418_;
                                                if (bitcast<i32>(_e2130.member) != 0i) {
                                                    let _e2136 = local_12.member[0u];
                                                    let _e2142 = local_12.member[1u];
                                                    let _e2158 = local_12.member_1[0u];
                                                    let _e2164 = local_12.member_1[1u];
                                                    let _e2180 = local_12.member_2[0u];
                                                    let _e2186 = local_12.member_2[1u];
                                                    let _e2200 = function_1(array<f32, 3>((_e2136[0] + ((_e2142[0] - _e2136[0]) * _e2116)), (_e2136[1] + ((_e2142[1] - _e2136[1]) * _e2116)), (_e2136[2] + ((_e2142[2] - _e2136[2]) * _e2116))), array<f32, 3>((_e2158[0] + ((_e2164[0] - _e2158[0]) * _e2116)), (_e2158[1] + ((_e2164[1] - _e2158[1]) * _e2116)), (_e2158[2] + ((_e2164[2] - _e2158[2]) * _e2116))), array<f32, 3>((_e2180[0] + ((_e2186[0] - _e2180[0]) * _e2116)), (_e2180[1] + ((_e2186[1] - _e2180[1]) * _e2116)), (_e2180[2] + ((_e2186[2] - _e2180[2]) * _e2116))), 0u);
                                                    if (_e2200[0] < 0f) {
                                                        phi_5529_ = -(_e2200[0]);
                                                    } else {
                                                        phi_5529_ = _e2200[0];
                                                    }
                                                    let _e2205 = phi_5529_;
                                                    if (_e2200[1] < 0f) {
                                                        phi_5536_ = -(_e2200[1]);
                                                    } else {
                                                        phi_5536_ = _e2200[1];
                                                    }
                                                    let _e2210 = phi_5536_;
                                                    if (_e2200[2] < 0f) {
                                                        phi_5544_ = -(_e2200[2]);
                                                    } else {
                                                        phi_5544_ = _e2200[2];
                                                    }
                                                    let _e2216 = phi_5544_;
                                                    let _e2217 = ((_e2205 + _e2210) + _e2216);
                                                    if (_e2217 > 0f) {
                                                        if ((bitcast<u32>(_e2217) & 2139095040u) != 2139095040u) {
                                                            let _e2222 = (1f / _e2217);
                                                            let _e2224 = (_e2200[0] * _e2222);
                                                            let _e2226 = (_e2200[1] * _e2222);
                                                            let _e2228 = (_e2200[2] * _e2222);
                                                            let _e2233 = (((_e2224 * _e2224) + (_e2226 * _e2226)) + (_e2228 * _e2228));
                                                            if (_e2233 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2233 > 0f) {
                                                                    phi_5581_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_5581_ = 0f;
                                                                }
                                                                let _e2286 = phi_5581_;
                                                                phi_5645_ = _e2286;
                                                            } else {
                                                                phi_5588_ = type_14(0i, 5i);
                                                                phi_5591_ = bitcast<f32>(((bitcast<u32>(_e2233) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2241 = phi_5588_;
                                                                    let _e2243 = phi_5591_;
                                                                    local_18 = _e2243;
                                                                    if (_e2241.member < _e2241.member_1) {
                                                                        let _e2250 = (_e2241.member + 1i);
                                                                        if ((false == (_e2250 > _e2241.member)) != false) {
                                                                            phi_5612_ = true;
                                                                        } else {
                                                                            phi_5612_ = false;
                                                                        }
                                                                        let _e2255 = phi_5612_;
                                                                        if _e2255 {
                                                                            phi_5618_ = type_15(0u, type_15().member_1);
                                                                        } else {
                                                                            phi_5618_ = type_15(1u, _e2250);
                                                                        }
                                                                        let _e2260 = phi_5618_;
                                                                        phi_5589_ = type_14(_e2260.member_1, _e2241.member_1);
                                                                        phi_5632_ = type_15(1u, _e2241.member);
                                                                    } else {
                                                                        phi_5589_ = _e2241;
                                                                        phi_5632_ = type_15(0u, type_15().member_1);
                                                                    }
                                                                    let _e2266 = phi_5589_;
                                                                    let _e2268 = phi_5632_;
                                                                    let _e2271 = (bitcast<i32>(_e2268.member) != 0i);
                                                                    if _e2271 {
                                                                        phi_5592_ = (0.5f * (_e2243 + (_e2233 / _e2243)));
                                                                    } else {
                                                                        phi_5592_ = f32();
                                                                    }
                                                                    let _e2276 = phi_5592_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_5588_ = _e2266;
                                                                        phi_5591_ = _e2276;
                                                                        break if !(_e2271);
                                                                    }
                                                                }
                                                                let _e2281 = local_18;
                                                                phi_5645_ = (_e2281 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2288 = phi_5645_;
                                                            phi_5654_ = type_9(0u, 4u);
                                                            phi_5657_ = 2f;
                                                            loop {
                                                                let _e2296 = phi_5654_;
                                                                let _e2298 = phi_5657_;
                                                                local_20 = _e2298;
                                                                local_21 = _e2298;
                                                                local_22 = _e2298;
                                                                local_51 = _e2298;
                                                                local_52 = _e2298;
                                                                if (_e2296.member < _e2296.member_1) {
                                                                    phi_5655_ = type_9((_e2296.member + 1u), _e2296.member_1);
                                                                    phi_5680_ = type_9(1u, _e2296.member);
                                                                } else {
                                                                    phi_5655_ = _e2296;
                                                                    phi_5680_ = type_9(0u, type_9().member_1);
                                                                }
                                                                let _e2310 = phi_5655_;
                                                                let _e2312 = phi_5680_;
                                                                if (bitcast<i32>(_e2312.member) != 0i) {
                                                                    let _e2318 = local[_e2312.member_1];
                                                                    let _e2326 = (((_e2224 * _e2318[0]) + (_e2226 * _e2318[1])) + (_e2228 * _e2318[2]));
                                                                    let _e2328 = local_1[_e2312.member_1];
                                                                    let _e2336 = (((_e2224 * _e2328[0]) + (_e2226 * _e2328[1])) + (_e2228 * _e2328[2]));
                                                                    if (_e2326 < 0f) {
                                                                        phi_5731_ = -(_e2326);
                                                                    } else {
                                                                        phi_5731_ = _e2326;
                                                                    }
                                                                    let _e2340 = phi_5731_;
                                                                    if (_e2336 < 0f) {
                                                                        phi_5737_ = -(_e2336);
                                                                    } else {
                                                                        phi_5737_ = _e2336;
                                                                    }
                                                                    let _e2344 = phi_5737_;
                                                                    let _e2348 = (((((((((_e1991 + _e1993) + (_e2045 + _e2047)) + (_e2099 + _e2101)) * (0.000000059604645f * 16f)) + (_e2108 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2288) * (1f + (0.000000059604645f * 8f)))) + ((_e2340 + _e2344) * (0.000000059604645f * 8f)));
                                                                    if (_e2326 > _e2348) {
                                                                        if (_e2336 > _e2348) {
                                                                            phi_5750_ = false;
                                                                        } else {
                                                                            phi_5750_ = true;
                                                                        }
                                                                        let _e2352 = phi_5750_;
                                                                        phi_5751_ = _e2352;
                                                                    } else {
                                                                        phi_5751_ = true;
                                                                    }
                                                                    let _e2354 = phi_5751_;
                                                                    if _e2354 {
                                                                        if ((_e2326 + ((_e2336 - _e2326) * _e2116)) > _e2348) {
                                                                            if (_e2336 < _e2326) {
                                                                                let _e2362 = ((_e2326 - _e2336) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                                                if _e2362 {
                                                                                    let _e2368 = (((_e2326 - _e2348) / (_e2326 - _e2336)) * (1f - (0.000000059604645f * 16f)));
                                                                                    if (_e2298 < _e2368) {
                                                                                        phi_5782_ = _e2298;
                                                                                    } else {
                                                                                        phi_5782_ = _e2368;
                                                                                    }
                                                                                    let _e2371 = phi_5782_;
                                                                                    phi_5783_ = _e2371;
                                                                                } else {
                                                                                    phi_5783_ = f32();
                                                                                }
                                                                                let _e2373 = phi_5783_;
                                                                                phi_5784_ = _e2373;
                                                                                phi_5785_ = _e2362;
                                                                            } else {
                                                                                phi_5784_ = _e2298;
                                                                                phi_5785_ = true;
                                                                            }
                                                                            let _e2375 = phi_5784_;
                                                                            let _e2377 = phi_5785_;
                                                                            if _e2377 {
                                                                                phi_5789_ = false;
                                                                            } else {
                                                                                phi_5789_ = true;
                                                                            }
                                                                            let _e2379 = phi_5789_;
                                                                            phi_5790_ = _e2375;
                                                                            phi_5791_ = _e2377;
                                                                            phi_5792_ = _e2379;
                                                                            phi_5793_ = false;
                                                                        } else {
                                                                            phi_5790_ = f32();
                                                                            phi_5791_ = false;
                                                                            phi_5792_ = false;
                                                                            phi_5793_ = true;
                                                                        }
                                                                        let _e2381 = phi_5790_;
                                                                        let _e2383 = phi_5791_;
                                                                        let _e2385 = phi_5792_;
                                                                        let _e2387 = phi_5793_;
                                                                        phi_5794_ = _e2381;
                                                                        phi_5795_ = _e2383;
                                                                        phi_5796_ = _e2385;
                                                                        phi_5797_ = _e2387;
                                                                    } else {
                                                                        phi_5794_ = _e2298;
                                                                        phi_5795_ = true;
                                                                        phi_5796_ = false;
                                                                        phi_5797_ = false;
                                                                    }
                                                                    let _e2389 = phi_5794_;
                                                                    let _e2391 = phi_5795_;
                                                                    let _e2393 = phi_5796_;
                                                                    let _e2395 = phi_5797_;
                                                                    phi_5658_ = _e2389;
                                                                    phi_5798_ = _e2391;
                                                                    phi_5799_ = false;
                                                                    phi_5800_ = _e2393;
                                                                    phi_5801_ = _e2395;
                                                                } else {
                                                                    phi_5658_ = f32();
                                                                    phi_5798_ = false;
                                                                    phi_5799_ = true;
                                                                    phi_5800_ = false;
                                                                    phi_5801_ = false;
                                                                }
                                                                let _e2397 = phi_5658_;
                                                                let _e2399 = phi_5798_;
                                                                let _e2401 = phi_5799_;
                                                                let _e2403 = phi_5800_;
                                                                let _e2405 = phi_5801_;
                                                                local_19 = _e2401;
                                                                local_49 = _e2403;
                                                                local_50 = _e2405;
                                                                continue;
                                                                continuing {
                                                                    phi_5654_ = _e2310;
                                                                    phi_5657_ = _e2397;
                                                                    break if !(_e2399);
                                                                }
                                                            }
                                                            let _e2408 = local_19;
                                                            if _e2408 {
                                                                let _e2410 = local_20;
                                                                let _e2411 = (_e2410 > _e1170.member_1);
                                                                if _e2411 {
                                                                    phi_5822_ = false;
                                                                    phi_5823_ = false;
                                                                    phi_5824_ = false;
                                                                } else {
                                                                    let _e2413 = local_21;
                                                                    if (_e2413 > _e2116) {
                                                                        let _e2416 = local_22;
                                                                        let _e2418 = ((_e2416 - _e2116) < 0.00000000023283064f);
                                                                        if _e2418 {
                                                                            phi_5818_ = false;
                                                                        } else {
                                                                            phi_5818_ = true;
                                                                        }
                                                                        let _e2420 = phi_5818_;
                                                                        phi_5819_ = _e2420;
                                                                        phi_5820_ = _e2418;
                                                                        phi_5821_ = false;
                                                                    } else {
                                                                        phi_5819_ = false;
                                                                        phi_5820_ = false;
                                                                        phi_5821_ = true;
                                                                    }
                                                                    let _e2422 = phi_5819_;
                                                                    let _e2424 = phi_5820_;
                                                                    let _e2426 = phi_5821_;
                                                                    phi_5822_ = _e2422;
                                                                    phi_5823_ = _e2424;
                                                                    phi_5824_ = _e2426;
                                                                }
                                                                let _e2428 = phi_5822_;
                                                                let _e2430 = phi_5823_;
                                                                let _e2432 = phi_5824_;
                                                                phi_5825_ = _e2428;
                                                                phi_5826_ = _e2411;
                                                                phi_5827_ = _e2430;
                                                                phi_5828_ = _e2432;
                                                                phi_5829_ = false;
                                                                phi_5830_ = false;
                                                            } else {
                                                                phi_5825_ = false;
                                                                phi_5826_ = false;
                                                                phi_5827_ = false;
                                                                phi_5828_ = false;
                                                                let _e4305 = local_49;
                                                                phi_5829_ = _e4305;
                                                                let _e4308 = local_50;
                                                                phi_5830_ = _e4308;
                                                            }
                                                            let _e2434 = phi_5825_;
                                                            let _e2436 = phi_5826_;
                                                            let _e2438 = phi_5827_;
                                                            let _e2440 = phi_5828_;
                                                            let _e2442 = phi_5829_;
                                                            let _e2444 = phi_5830_;
                                                            let _e4311 = local_51;
                                                            phi_5831_ = _e4311;
                                                            let _e4314 = local_52;
                                                            phi_5832_ = _e4314;
                                                            phi_5833_ = _e2434;
                                                            phi_5834_ = _e2436;
                                                            phi_5835_ = _e2438;
                                                            phi_5836_ = _e2440;
                                                            phi_5837_ = _e2442;
                                                            phi_5838_ = _e2444;
                                                            phi_5839_ = false;
                                                        } else {
                                                            phi_5831_ = f32();
                                                            phi_5832_ = f32();
                                                            phi_5833_ = false;
                                                            phi_5834_ = false;
                                                            phi_5835_ = false;
                                                            phi_5836_ = false;
                                                            phi_5837_ = false;
                                                            phi_5838_ = false;
                                                            phi_5839_ = true;
                                                        }
                                                        let _e2446 = phi_5831_;
                                                        let _e2448 = phi_5832_;
                                                        let _e2450 = phi_5833_;
                                                        let _e2452 = phi_5834_;
                                                        let _e2454 = phi_5835_;
                                                        let _e2456 = phi_5836_;
                                                        let _e2458 = phi_5837_;
                                                        let _e2460 = phi_5838_;
                                                        let _e2462 = phi_5839_;
                                                        phi_5840_ = _e2446;
                                                        phi_5841_ = _e2448;
                                                        phi_5842_ = _e2450;
                                                        phi_5843_ = _e2452;
                                                        phi_5844_ = _e2454;
                                                        phi_5845_ = _e2456;
                                                        phi_5846_ = _e2458;
                                                        phi_5847_ = _e2460;
                                                        phi_5848_ = _e2462;
                                                        phi_5849_ = false;
                                                    } else {
                                                        phi_5840_ = f32();
                                                        phi_5841_ = f32();
                                                        phi_5842_ = false;
                                                        phi_5843_ = false;
                                                        phi_5844_ = false;
                                                        phi_5845_ = false;
                                                        phi_5846_ = false;
                                                        phi_5847_ = false;
                                                        phi_5848_ = false;
                                                        phi_5849_ = true;
                                                    }
                                                    let _e2464 = phi_5840_;
                                                    let _e2466 = phi_5841_;
                                                    let _e2468 = phi_5842_;
                                                    let _e2470 = phi_5843_;
                                                    let _e2472 = phi_5844_;
                                                    let _e2474 = phi_5845_;
                                                    let _e2476 = phi_5846_;
                                                    let _e2478 = phi_5847_;
                                                    let _e2480 = phi_5848_;
                                                    let _e2482 = phi_5849_;
                                                    phi_5850_ = _e2464;
                                                    phi_5396_ = _e2466;
                                                    phi_5851_ = _e2468;
                                                    phi_5852_ = _e2470;
                                                    phi_5853_ = _e2472;
                                                    phi_5854_ = false;
                                                    phi_5855_ = _e2474;
                                                    phi_5856_ = _e2476;
                                                    phi_5857_ = _e2478;
                                                    phi_5858_ = _e2480;
                                                    phi_5859_ = _e2482;
                                                } else {
                                                    phi_5850_ = f32();
                                                    phi_5396_ = f32();
                                                    phi_5851_ = false;
                                                    phi_5852_ = false;
                                                    phi_5853_ = false;
                                                    phi_5854_ = true;
                                                    phi_5855_ = false;
                                                    phi_5856_ = false;
                                                    phi_5857_ = false;
                                                    phi_5858_ = false;
                                                    phi_5859_ = false;
                                                }
                                                let _e2484 = phi_5850_;
                                                let _e2486 = phi_5396_;
                                                let _e2488 = phi_5851_;
                                                let _e2490 = phi_5852_;
                                                let _e2492 = phi_5853_;
                                                let _e2494 = phi_5854_;
                                                let _e2496 = phi_5855_;
                                                let _e2498 = phi_5856_;
                                                let _e2500 = phi_5857_;
                                                let _e2502 = phi_5858_;
                                                let _e2504 = phi_5859_;
                                                local_23 = _e2490;
                                                local_53 = _e2492;
                                                local_54 = _e2494;
                                                local_55 = _e2496;
                                                local_56 = _e2498;
                                                local_57 = _e2500;
                                                local_58 = _e2502;
                                                local_59 = _e2504;
                                                local_60 = _e2484;
                                                local_62 = _e2490;
                                                continue;
                                                continuing {
                                                    phi_5392_ = _e2128;
                                                    phi_5395_ = _e2486;
                                                    break if !(_e2488);
                                                }
                                            }
                                            let _e2507 = local_23;
                                            if _e2507 {
                                                phi_5864_ = type_34(0u, type_34().member_1);
                                                phi_5865_ = false;
                                                phi_5866_ = false;
                                                phi_5867_ = false;
                                                phi_5868_ = false;
                                                phi_5869_ = false;
                                                phi_5870_ = false;
                                                phi_5871_ = false;
                                            } else {
                                                phi_5864_ = type_34();
                                                let _e4347 = local_53;
                                                phi_5865_ = _e4347;
                                                let _e4350 = local_54;
                                                phi_5866_ = _e4350;
                                                let _e4353 = local_55;
                                                phi_5867_ = _e4353;
                                                let _e4356 = local_56;
                                                phi_5868_ = _e4356;
                                                let _e4359 = local_57;
                                                phi_5869_ = _e4359;
                                                let _e4362 = local_58;
                                                phi_5870_ = _e4362;
                                                let _e4365 = local_59;
                                                phi_5871_ = _e4365;
                                            }
                                            let _e2511 = phi_5864_;
                                            let _e2513 = phi_5865_;
                                            let _e2515 = phi_5866_;
                                            let _e2517 = phi_5867_;
                                            let _e2519 = phi_5868_;
                                            let _e2521 = phi_5869_;
                                            let _e2523 = phi_5870_;
                                            let _e2525 = phi_5871_;
                                            if _e2513 {
                                                let _e4368 = local_60;
                                                phi_5875_ = _e4368;
                                                phi_5876_ = true;
                                                phi_5877_ = false;
                                                phi_5878_ = false;
                                                phi_5879_ = false;
                                                phi_5880_ = false;
                                                phi_5881_ = false;
                                                phi_5882_ = false;
                                            } else {
                                                let _e4370 = local_61;
                                                phi_5875_ = _e4370;
                                                phi_5876_ = _e2515;
                                                phi_5877_ = _e2517;
                                                phi_5878_ = _e2519;
                                                phi_5879_ = _e2521;
                                                let _e4377 = local_62;
                                                phi_5880_ = _e4377;
                                                phi_5881_ = _e2523;
                                                phi_5882_ = _e2525;
                                            }
                                            let _e2527 = phi_5875_;
                                            let _e2529 = phi_5876_;
                                            let _e2531 = phi_5877_;
                                            let _e2533 = phi_5878_;
                                            let _e2535 = phi_5879_;
                                            let _e2537 = phi_5880_;
                                            let _e2539 = phi_5881_;
                                            let _e2541 = phi_5882_;
                                            if _e2529 {
                                                phi_5887_ = type_34(1u, _e2527);
                                                phi_5888_ = false;
                                                phi_5889_ = false;
                                                phi_5890_ = false;
                                                phi_5891_ = false;
                                                phi_5892_ = false;
                                                phi_5893_ = false;
                                            } else {
                                                phi_5887_ = type_34();
                                                phi_5888_ = _e2531;
                                                phi_5889_ = _e2533;
                                                phi_5890_ = _e2535;
                                                phi_5891_ = _e2537;
                                                phi_5892_ = _e2539;
                                                phi_5893_ = _e2541;
                                            }
                                            let _e2544 = phi_5887_;
                                            let _e2546 = phi_5888_;
                                            let _e2548 = phi_5889_;
                                            let _e2550 = phi_5890_;
                                            let _e2552 = phi_5891_;
                                            let _e2554 = phi_5892_;
                                            let _e2556 = phi_5893_;
                                            if _e2546 {
                                                let _e2558 = local_24;
                                                phi_5898_ = type_34(1u, _e2558);
                                                phi_5899_ = false;
                                                phi_5900_ = false;
                                                phi_5901_ = true;
                                                phi_5902_ = false;
                                                phi_5903_ = false;
                                            } else {
                                                phi_5898_ = _e2511;
                                                phi_5899_ = _e2548;
                                                phi_5900_ = _e2550;
                                                phi_5901_ = _e2552;
                                                phi_5902_ = _e2554;
                                                phi_5903_ = _e2556;
                                            }
                                            let _e2561 = phi_5898_;
                                            let _e2563 = phi_5899_;
                                            let _e2565 = phi_5900_;
                                            let _e2567 = phi_5901_;
                                            let _e2569 = phi_5902_;
                                            let _e2571 = phi_5903_;
                                            if _e2563 {
                                                let _e2573 = local_25;
                                                phi_5908_ = type_34(1u, _e2573);
                                                phi_5909_ = false;
                                                phi_5910_ = false;
                                                phi_5911_ = false;
                                                phi_5912_ = false;
                                            } else {
                                                phi_5908_ = type_34();
                                                phi_5909_ = _e2565;
                                                phi_5910_ = _e2567;
                                                phi_5911_ = _e2569;
                                                phi_5912_ = _e2571;
                                            }
                                            let _e2576 = phi_5908_;
                                            let _e2578 = phi_5909_;
                                            let _e2580 = phi_5910_;
                                            let _e2582 = phi_5911_;
                                            let _e2584 = phi_5912_;
                                            if _e2578 {
                                                let _e2586 = local_26;
                                                phi_5917_ = type_34(1u, _e2586);
                                                phi_5918_ = true;
                                                phi_5919_ = false;
                                                phi_5920_ = false;
                                                phi_5921_ = false;
                                            } else {
                                                phi_5917_ = _e2576;
                                                phi_5918_ = _e2563;
                                                phi_5919_ = _e2580;
                                                phi_5920_ = _e2582;
                                                phi_5921_ = _e2584;
                                            }
                                            let _e2589 = phi_5917_;
                                            let _e2591 = phi_5918_;
                                            let _e2593 = phi_5919_;
                                            let _e2595 = phi_5920_;
                                            let _e2597 = phi_5921_;
                                            if _e2591 {
                                                phi_5925_ = _e2589;
                                                phi_5926_ = true;
                                                phi_5927_ = false;
                                                phi_5928_ = false;
                                            } else {
                                                phi_5925_ = _e2561;
                                                phi_5926_ = _e2593;
                                                phi_5927_ = _e2595;
                                                phi_5928_ = _e2597;
                                            }
                                            let _e2599 = phi_5925_;
                                            let _e2601 = phi_5926_;
                                            let _e2603 = phi_5927_;
                                            let _e2605 = phi_5928_;
                                            if _e2601 {
                                                phi_5932_ = false;
                                                phi_5933_ = false;
                                            } else {
                                                phi_5932_ = _e2603;
                                                phi_5933_ = _e2605;
                                            }
                                            let _e2607 = phi_5932_;
                                            let _e2609 = phi_5933_;
                                            if _e2607 {
                                                phi_5937_ = false;
                                                phi_5938_ = false;
                                            } else {
                                                phi_5937_ = _e2609;
                                                phi_5938_ = _e2601;
                                            }
                                            let _e2611 = phi_5937_;
                                            let _e2613 = phi_5938_;
                                            if _e2611 {
                                                phi_5942_ = true;
                                                phi_5943_ = false;
                                            } else {
                                                phi_5942_ = _e2607;
                                                phi_5943_ = _e2613;
                                            }
                                            let _e2615 = phi_5942_;
                                            let _e2617 = phi_5943_;
                                            if _e2615 {
                                                let _e2619 = local_27;
                                                phi_5948_ = type_34(1u, _e2619);
                                                phi_5949_ = true;
                                            } else {
                                                phi_5948_ = _e2599;
                                                phi_5949_ = _e2617;
                                            }
                                            let _e2622 = phi_5948_;
                                            let _e2624 = phi_5949_;
                                            if _e2624 {
                                                phi_5953_ = _e2622;
                                            } else {
                                                phi_5953_ = _e2544;
                                            }
                                            let _e2626 = phi_5953_;
                                            let _e2629 = (_e2626.member != 0u);
                                            if _e2629 {
                                                phi_5960_ = false;
                                            } else {
                                                phi_5960_ = true;
                                            }
                                            let _e2631 = phi_5960_;
                                            phi_5961_ = _e2626.member_1;
                                            phi_5962_ = _e2631;
                                            phi_5963_ = _e2629;
                                            phi_5964_ = false;
                                        } else {
                                            phi_5961_ = f32();
                                            phi_5962_ = false;
                                            phi_5963_ = false;
                                            phi_5964_ = true;
                                        }
                                        let _e2633 = phi_5961_;
                                        let _e2635 = phi_5962_;
                                        let _e2637 = phi_5963_;
                                        let _e2639 = phi_5964_;
                                        phi_5965_ = _e2633;
                                        phi_5966_ = _e2635;
                                        phi_5967_ = _e2637;
                                        phi_5968_ = _e2639;
                                    }
                                    let _e2641 = phi_5965_;
                                    let _e2643 = phi_5966_;
                                    let _e2645 = phi_5967_;
                                    let _e2647 = phi_5968_;
                                    phi_5969_ = _e2641;
                                    phi_5970_ = _e1872;
                                    phi_5971_ = _e2643;
                                    phi_5972_ = _e2645;
                                    phi_5973_ = _e2647;
                                }
                                let _e2649 = phi_5969_;
                                let _e2651 = phi_5970_;
                                let _e2653 = phi_5971_;
                                let _e2655 = phi_5972_;
                                let _e2657 = phi_5973_;
                                if _e2651 {
                                    phi_5977_ = true;
                                    phi_5978_ = false;
                                    phi_5979_ = false;
                                } else {
                                    phi_5977_ = _e2653;
                                    phi_5978_ = _e2655;
                                    phi_5979_ = _e2657;
                                }
                                let _e2659 = phi_5977_;
                                let _e2661 = phi_5978_;
                                let _e2663 = phi_5979_;
                                phi_5980_ = _e2649;
                                phi_5981_ = _e1170;
                                phi_5982_ = _e2659;
                                phi_5983_ = false;
                                phi_5984_ = _e2661;
                                phi_5985_ = _e2663;
                            } else {
                                phi_5980_ = f32();
                                phi_5981_ = type_35();
                                phi_5982_ = false;
                                phi_5983_ = true;
                                phi_5984_ = false;
                                phi_5985_ = false;
                            }
                            let _e2665 = phi_5980_;
                            let _e2667 = phi_5981_;
                            let _e2669 = phi_5982_;
                            let _e2671 = phi_5983_;
                            let _e2673 = phi_5984_;
                            let _e2675 = phi_5985_;
                            local_28 = _e2671;
                            local_63 = _e2673;
                            local_64 = _e2675;
                            local_29 = _e2665;
                            local_30 = _e2667;
                            continue;
                            continuing {
                                phi_3479_ = _e875;
                                break if !(_e2669);
                            }
                        }
                        let _e2678 = local_28;
                        if _e2678 {
                            phi_5990_ = type_34(0u, type_34().member_1);
                            phi_5991_ = false;
                            phi_5992_ = false;
                        } else {
                            phi_5990_ = type_34();
                            let _e4447 = local_63;
                            phi_5991_ = _e4447;
                            let _e4450 = local_64;
                            phi_5992_ = _e4450;
                        }
                        let _e2682 = phi_5990_;
                        let _e2684 = phi_5991_;
                        let _e2686 = phi_5992_;
                        if _e2684 {
                            let _e2688 = local_29;
                            phi_5997_ = type_34(2u, _e2688);
                            phi_5998_ = false;
                        } else {
                            phi_5997_ = type_34();
                            phi_5998_ = _e2686;
                        }
                        let _e2691 = phi_5997_;
                        let _e2693 = phi_5998_;
                        if _e2693 {
                            let _e2695 = local_30;
                            phi_6004_ = type_34(1u, _e2695.member);
                            phi_6005_ = true;
                        } else {
                            phi_6004_ = _e2691;
                            phi_6005_ = _e2684;
                        }
                        let _e2699 = phi_6004_;
                        let _e2701 = phi_6005_;
                        if _e2701 {
                            phi_6009_ = _e2699;
                        } else {
                            phi_6009_ = _e2682;
                        }
                        let _e2703 = phi_6009_;
                        phi_6013_ = _e2703;
                    }
                    let _e3819 = phi_6013_;
                    phi_6014_ = _e3819;
                }
                let _e3823 = phi_6014_;
                switch bitcast<i32>(_e3823.member) {
                    case 0: {
                        phi_6027_ = type_36(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e3829 = function_2(_e3823.member_1);
                        phi_6027_ = type_36(0u, _e3829, true);
                        break;
                    }
                    case 2: {
                        let _e3827 = function_2(_e3823.member_1);
                        phi_6027_ = type_36(1u, _e3827, true);
                        break;
                    }
                    default: {
                        phi_6027_ = type_36();
                        break;
                    }
                }
                let _e3832 = phi_6027_;
                if _e3832.member_2 {
                    phi_6034_ = (_e3832.member == 0u);
                } else {
                    phi_6034_ = false;
                }
                let _e3837 = phi_6034_;
                if _e3837 {
                    let _e3845 = (_e3832.member_1[1] >> bitcast<u32>(20i));
                    if (_e3845 <= 896u) {
                        phi_6058_ = 0u;
                    } else {
                        phi_6058_ = ((((_e3845 - 896u) << bitcast<u32>(23i)) | ((_e3832.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e3832.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e3860 = phi_6058_;
                    let _e3862 = atomicMin((&earliest.member[0u]), _e3860);
                }
                phi_6062_ = type_20(0u, 0u, _e165, _e168, _e3832.member_1);
                phi_6063_ = _e3837;
                phi_6064_ = (_e3832.member != 0u);
            } else {
                phi_6062_ = type_20(0u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_6063_ = false;
                phi_6064_ = false;
            }
            let _e3864 = phi_6062_;
            let _e3866 = phi_6063_;
            let _e3868 = phi_6064_;
            let _e3871 = params.member.member.member_1;
            if ((_e3871 & 16u) != 0u) {
                if (_e94 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e3866 {
                    let _e3877 = atomicAdd((&counters[0u]), 1u);
                    phi_6083_ = _e3877;
                } else {
                    phi_6083_ = 0u;
                }
                let _e3879 = phi_6083_;
                workgroupBarrier();
                if (_e94 == 0u) {
                    let _e3882 = atomicLoad((&counters[0u]));
                    if (_e3882 > 0u) {
                        let _e3885 = atomicAdd((&contacts.member[0u]), _e3882);
                        atomicStore((&counters[1u]), _e3885);
                    }
                }
                workgroupBarrier();
                let _e3888 = atomicLoad((&counters[1u]));
                let _e3889 = (_e3888 + _e3879);
                if _e3866 {
                    let _e3892 = params.member.member_1.member_3;
                    if (_e3889 < _e3892) {
                        let _e3894 = (6u * _e3889);
                        atomicStore((&contacts.member[(4u + _e3894)]), _e3864.member);
                        atomicStore((&contacts.member[(_e3894 + 5u)]), _e3864.member_1);
                        atomicStore((&contacts.member[(_e3894 + 6u)]), _e3864.member_2);
                        atomicStore((&contacts.member[(_e3894 + 7u)]), _e3864.member_3);
                        atomicStore((&contacts.member[(_e3894 + 8u)]), _e3864.member_4[0]);
                        atomicStore((&contacts.member[(_e3894 + 9u)]), _e3864.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e94 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e3868 {
                let _e3918 = atomicAdd((&counters[0u]), 1u);
                phi_6146_ = _e3918;
            } else {
                phi_6146_ = 0u;
            }
            let _e3920 = phi_6146_;
            workgroupBarrier();
            if (_e94 == 0u) {
                let _e3923 = atomicLoad((&counters[0u]));
                if (_e3923 > 0u) {
                    let _e3926 = atomicAdd((&undecided.member[0u]), _e3923);
                    atomicStore((&counters[1u]), _e3926);
                }
            }
            workgroupBarrier();
            let _e3929 = atomicLoad((&counters[1u]));
            let _e3930 = (_e3929 + _e3920);
            if _e3868 {
                let _e3933 = params.member.member_2.member;
                if (_e3930 < _e3933) {
                    let _e3937 = (2u * _e3930);
                    atomicStore((&undecided.member[(4u + _e3937)]), _e3864.member_2);
                    atomicStore((&undecided.member[(_e3937 + 5u)]), _e3864.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_796_ = _e150;
            break if !(_e156);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
