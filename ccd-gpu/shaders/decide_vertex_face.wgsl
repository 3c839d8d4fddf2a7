struct type_8 {
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

struct type_9 {
    member: type_8,
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

struct type_26 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_27 {
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
var<storage> params: type_9;
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

fn function_(param: array<f32, 3>, param_1: array<f32, 3>) -> array<f32, 3> {
    var phi_672_: array<f32, 3>;

    if ((((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2])) < (((param[0] * param[0]) + (param[1] * param[1])) + (param[2] * param[2]))) {
        phi_672_ = param_1;
    } else {
        phi_672_ = param;
    }
    let _e26 = phi_672_;
    return _e26;
}

fn function_1(param_2: array<f32, 3>, param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: u32) -> array<f32, 3> {
    var phi_264_: bool;
    var phi_265_: bool;
    var phi_266_: bool;
    var phi_267_: bool;
    var phi_271_: bool;
    var phi_244_: bool;
    var phi_245_: bool;
    var phi_246_: bool;
    var phi_247_: bool;
    var phi_248_: bool;
    var phi_249_: bool;
    var phi_253_: bool;
    var phi_272_: bool;
    var phi_302_: array<f32, 3>;
    var phi_303_: bool;
    var phi_304_: array<f32, 3>;
    var phi_305_: bool;
    var phi_532_: f32;
    var phi_533_: f32;
    var phi_572_: f32;
    var phi_573_: f32;
    var phi_618_: f32;
    var phi_619_: f32;
    var phi_353_: f32;
    var phi_354_: f32;
    var phi_399_: f32;
    var phi_400_: f32;
    var phi_442_: f32;
    var phi_443_: f32;
    var phi_491_: f32;
    var phi_492_: f32;
    var phi_634_: array<array<f32, 3>, 4>;
    var phi_642_: array<f32, 3>;

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
                    phi_244_ = (_e76 <= 1f);
                    phi_245_ = false;
                } else {
                    phi_244_ = bool();
                    phi_245_ = true;
                }
                let _e97 = phi_244_;
                let _e99 = phi_245_;
                phi_246_ = _e97;
                phi_247_ = _e99;
            } else {
                phi_246_ = bool();
                phi_247_ = true;
            }
            let _e101 = phi_246_;
            let _e103 = phi_247_;
            phi_248_ = _e101;
            phi_249_ = _e103;
        } else {
            phi_248_ = bool();
            phi_249_ = true;
        }
        let _e105 = phi_248_;
        let _e107 = phi_249_;
        if _e107 {
            phi_253_ = false;
        } else {
            phi_253_ = _e105;
        }
        let _e109 = phi_253_;
        phi_272_ = _e109;
    } else {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                phi_264_ = ((_e72 + _e76) <= 1f);
                phi_265_ = false;
            } else {
                phi_264_ = bool();
                phi_265_ = true;
            }
            let _e83 = phi_264_;
            let _e85 = phi_265_;
            phi_266_ = _e83;
            phi_267_ = _e85;
        } else {
            phi_266_ = bool();
            phi_267_ = true;
        }
        let _e87 = phi_266_;
        let _e89 = phi_267_;
        if _e89 {
            phi_271_ = false;
        } else {
            phi_271_ = _e87;
        }
        let _e91 = phi_271_;
        phi_272_ = _e91;
    }
    let _e111 = phi_272_;
    if (_e68 > 0f) {
        if _e111 {
            phi_302_ = array<f32, 3>((param_2[0] - ((param_3[0] * _e72) + (param_4[0] * _e76))), (param_2[1] - ((param_3[1] * _e72) + (param_4[1] * _e76))), (param_2[2] - ((param_3[2] * _e72) + (param_4[2] * _e76))));
            phi_303_ = false;
        } else {
            phi_302_ = array<f32, 3>();
            phi_303_ = true;
        }
        let _e136 = phi_302_;
        let _e138 = phi_303_;
        phi_304_ = _e136;
        phi_305_ = _e138;
    } else {
        phi_304_ = array<f32, 3>();
        phi_305_ = true;
    }
    let _e140 = phi_304_;
    let _e142 = phi_305_;
    if _e142 {
        let _e145 = (param_2[0] - param_3[0]);
        let _e148 = (param_2[1] - param_3[1]);
        let _e151 = (param_2[2] - param_3[2]);
        if (param_5 != 0u) {
            let _e293 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
            if (_e293 > 0f) {
                if (_e293 < 1f) {
                    phi_353_ = _e293;
                } else {
                    phi_353_ = 1f;
                }
                let _e297 = phi_353_;
                phi_354_ = _e297;
            } else {
                phi_354_ = 0f;
            }
            let _e299 = phi_354_;
            let _e335 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e335 > 0f) {
                if (_e335 < 1f) {
                    phi_399_ = _e335;
                } else {
                    phi_399_ = 1f;
                }
                let _e339 = phi_399_;
                phi_400_ = _e339;
            } else {
                phi_400_ = 0f;
            }
            let _e341 = phi_400_;
            let _e374 = ((((_e145 * param_4[0]) + (_e148 * param_4[1])) + (_e151 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e374 > 0f) {
                if (_e374 < 1f) {
                    phi_442_ = _e374;
                } else {
                    phi_442_ = 1f;
                }
                let _e378 = phi_442_;
                phi_443_ = _e378;
            } else {
                phi_443_ = 0f;
            }
            let _e380 = phi_443_;
            let _e393 = (param_2[0] - param_4[0]);
            let _e396 = (param_2[1] - param_4[1]);
            let _e399 = (param_2[2] - param_4[2]);
            let _e419 = ((((_e393 * param_3[0]) + (_e396 * param_3[1])) + (_e399 * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
            if (_e419 > 0f) {
                if (_e419 < 1f) {
                    phi_491_ = _e419;
                } else {
                    phi_491_ = 1f;
                }
                let _e423 = phi_491_;
                phi_492_ = _e423;
            } else {
                phi_492_ = 0f;
            }
            let _e425 = phi_492_;
            phi_634_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e299)), (param_2[1] - (param_3[1] * _e299)), (param_2[2] - (param_3[2] * _e299))), array<f32, 3>((param_2[0] - (param_4[0] * _e341)), (param_2[1] - (param_4[1] * _e341)), (param_2[2] - (param_4[2] * _e341))), array<f32, 3>((_e145 - (param_4[0] * _e380)), (_e148 - (param_4[1] * _e380)), (_e151 - (param_4[2] * _e380))), array<f32, 3>((_e393 - (param_3[0] * _e425)), (_e396 - (param_3[1] * _e425)), (_e399 - (param_3[2] * _e425))));
        } else {
            let _e155 = (param_4[0] - param_3[0]);
            let _e158 = (param_4[1] - param_3[1]);
            let _e161 = (param_4[2] - param_3[2]);
            let _e172 = ((((_e145 * _e155) + (_e148 * _e158)) + (_e151 * _e161)) / (((_e155 * _e155) + (_e158 * _e158)) + (_e161 * _e161)));
            if (_e172 > 0f) {
                if (_e172 < 1f) {
                    phi_532_ = _e172;
                } else {
                    phi_532_ = 1f;
                }
                let _e176 = phi_532_;
                phi_533_ = _e176;
            } else {
                phi_533_ = 0f;
            }
            let _e178 = phi_533_;
            let _e185 = array<f32, 3>((_e145 - (_e155 * _e178)), (_e148 - (_e158 * _e178)), (_e151 - (_e161 * _e178)));
            let _e208 = ((((param_2[0] * param_3[0]) + (param_2[1] * param_3[1])) + (param_2[2] * param_3[2])) / (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])));
            if (_e208 > 0f) {
                if (_e208 < 1f) {
                    phi_572_ = _e208;
                } else {
                    phi_572_ = 1f;
                }
                let _e212 = phi_572_;
                phi_573_ = _e212;
            } else {
                phi_573_ = 0f;
            }
            let _e214 = phi_573_;
            let _e250 = ((((param_2[0] * param_4[0]) + (param_2[1] * param_4[1])) + (param_2[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e250 > 0f) {
                if (_e250 < 1f) {
                    phi_618_ = _e250;
                } else {
                    phi_618_ = 1f;
                }
                let _e254 = phi_618_;
                phi_619_ = _e254;
            } else {
                phi_619_ = 0f;
            }
            let _e256 = phi_619_;
            phi_634_ = array<array<f32, 3>, 4>(array<f32, 3>((param_2[0] - (param_3[0] * _e214)), (param_2[1] - (param_3[1] * _e214)), (param_2[2] - (param_3[2] * _e214))), array<f32, 3>((param_2[0] - (param_4[0] * _e256)), (param_2[1] - (param_4[1] * _e256)), (param_2[2] - (param_4[2] * _e256))), _e185, _e185);
        }
        let _e438 = phi_634_;
        let _e441 = function_(_e438[0], _e438[1]);
        let _e443 = function_(_e441, _e438[2]);
        let _e445 = function_(_e443, _e438[3]);
        phi_642_ = _e445;
    } else {
        phi_642_ = _e140;
    }
    let _e447 = phi_642_;
    return _e447;
}

fn function_2(param_6: f32) -> array<u32, 2> {
    var phi_693_: array<u32, 2>;
    var phi_694_: array<u32, 2>;
    var phi_695_: bool;
    var phi_699_: array<u32, 2>;

    let _e13 = bitcast<u32>(param_6);
    if (_e13 < 8388608u) {
        phi_694_ = array<u32, 2>();
        phi_695_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_693_ = array<u32, 2>();
        } else {
            phi_693_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_693_;
        phi_694_ = _e31;
        phi_695_ = _e17;
    }
    let _e33 = phi_694_;
    let _e35 = phi_695_;
    if _e35 {
        phi_699_ = array<u32, 2>(0u, 0u);
    } else {
        phi_699_ = _e33;
    }
    let _e37 = phi_699_;
    return _e37;
}

fn function_3(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<array<f32, 3>, 4>;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: type_24;
    var local_3: type_24;
    var local_4: type_24;
    var local_5: array<type_29, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: array<f32, 4>;
    var local_9: array<array<f32, 3>, 4>;
    var local_10: array<array<f32, 3>, 4>;
    var local_11: array<f32, 3>;
    var local_12: type_26;
    var phi_751_: u32;
    var phi_767_: u32;
    var phi_788_: u32;
    var phi_789_: u32;
    var phi_792_: type_19;
    var phi_793_: type_19;
    var phi_816_: type_19;
    var phi_1255_: f32;
    var phi_1262_: f32;
    var phi_1267_: f32;
    var phi_1274_: f32;
    var phi_1279_: f32;
    var phi_1292_: f32;
    var phi_1299_: f32;
    var phi_1304_: f32;
    var phi_1311_: f32;
    var phi_1316_: f32;
    var phi_1321_: f32;
    var phi_1338_: f32;
    var phi_1345_: f32;
    var phi_1350_: f32;
    var phi_1357_: f32;
    var phi_1362_: f32;
    var phi_1376_: f32;
    var phi_1383_: f32;
    var phi_1388_: f32;
    var phi_1395_: f32;
    var phi_1400_: f32;
    var phi_1405_: f32;
    var phi_1422_: f32;
    var phi_1429_: f32;
    var phi_1434_: f32;
    var phi_1441_: f32;
    var phi_1446_: f32;
    var phi_1460_: f32;
    var phi_1467_: f32;
    var phi_1472_: f32;
    var phi_1479_: f32;
    var phi_1484_: f32;
    var phi_1489_: f32;
    var phi_1520_: f32;
    var phi_1526_: f32;
    var phi_1533_: f32;
    var phi_1540_: f32;
    var phi_1546_: f32;
    var phi_1553_: f32;
    var phi_1559_: f32;
    var phi_1565_: f32;
    var phi_1571_: f32;
    var phi_1578_: f32;
    var phi_1585_: f32;
    var phi_1609_: f32;
    var phi_1614_: f32;
    var phi_1619_: f32;
    var phi_1624_: f32;
    var phi_1629_: f32;
    var phi_1634_: f32;
    var phi_1644_: f32;
    var phi_3203_: f32;
    var phi_3209_: f32;
    var phi_3214_: f32;
    var phi_3220_: f32;
    var phi_3226_: f32;
    var phi_3231_: f32;
    var phi_3236_: f32;
    var phi_3244_: bool;
    var phi_3249_: f32;
    var phi_3256_: f32;
    var phi_3296_: type_17;
    var phi_3299_: f32;
    var phi_3320_: bool;
    var phi_3326_: type_18;
    var phi_3297_: type_17;
    var phi_3340_: type_18;
    var phi_3300_: f32;
    var local_13: f32;
    var phi_3289_: f32;
    var phi_3353_: f32;
    var phi_3359_: f32;
    var phi_3384_: type_19;
    var phi_3387_: u32;
    var phi_3385_: type_19;
    var phi_3410_: type_19;
    var phi_3454_: u32;
    var phi_3455_: u32;
    var phi_3388_: u32;
    var phi_3456_: u32;
    var phi_3476_: type_19;
    var phi_3477_: type_19;
    var phi_3500_: type_19;
    var phi_3552_: f32;
    var phi_3559_: f32;
    var phi_3570_: bool;
    var phi_3571_: bool;
    var phi_3572_: bool;
    var phi_3573_: bool;
    var phi_3577_: bool;
    var phi_3588_: type_33;
    var phi_3589_: type_33;
    var phi_3590_: bool;
    var phi_3591_: type_33;
    var phi_3592_: bool;
    var phi_3603_: f32;
    var phi_3613_: type_19;
    var phi_3616_: f32;
    var phi_3618_: f32;
    var phi_3620_: f32;
    var phi_3614_: type_19;
    var phi_3643_: type_19;
    var phi_3668_: f32;
    var phi_3669_: f32;
    var phi_3695_: f32;
    var phi_3711_: f32;
    var phi_3718_: bool;
    var phi_3719_: bool;
    var phi_3720_: bool;
    var phi_3726_: f32;
    var phi_3727_: f32;
    var phi_3728_: bool;
    var phi_3617_: f32;
    var phi_3619_: f32;
    var phi_3621_: f32;
    var phi_3729_: f32;
    var phi_3730_: bool;
    var phi_3731_: bool;
    var local_14: bool;
    var phi_3735_: f32;
    var phi_3736_: f32;
    var phi_3743_: type_19;
    var phi_3746_: f32;
    var phi_3744_: type_19;
    var phi_3769_: type_19;
    var phi_3810_: f32;
    var phi_3820_: f32;
    var phi_3828_: bool;
    var phi_3830_: bool;
    var phi_3835_: f32;
    var phi_3836_: bool;
    var phi_3837_: f32;
    var phi_3838_: bool;
    var phi_3839_: bool;
    var phi_3840_: bool;
    var phi_3841_: f32;
    var phi_3747_: f32;
    var phi_3842_: bool;
    var phi_3843_: bool;
    var phi_3844_: bool;
    var phi_3845_: bool;
    var local_15: bool;
    var phi_3849_: bool;
    var phi_3850_: bool;
    var phi_3854_: bool;
    var phi_3858_: f32;
    var phi_3859_: f32;
    var phi_3861_: type_33;
    var phi_3890_: f32;
    var phi_3897_: f32;
    var phi_3902_: f32;
    var phi_3909_: f32;
    var phi_3914_: f32;
    var phi_3927_: f32;
    var phi_3934_: f32;
    var phi_3939_: f32;
    var phi_3946_: f32;
    var phi_3951_: f32;
    var phi_3956_: f32;
    var phi_4015_: f32;
    var phi_4021_: f32;
    var phi_4026_: f32;
    var phi_4032_: f32;
    var phi_4037_: f32;
    var phi_4049_: f32;
    var phi_4055_: f32;
    var phi_4060_: f32;
    var phi_4066_: f32;
    var phi_4071_: f32;
    var phi_4097_: f32;
    var phi_4104_: f32;
    var phi_4109_: f32;
    var phi_4116_: f32;
    var phi_4121_: f32;
    var phi_4134_: f32;
    var phi_4141_: f32;
    var phi_4146_: f32;
    var phi_4153_: f32;
    var phi_4158_: f32;
    var phi_4163_: f32;
    var phi_4222_: f32;
    var phi_4228_: f32;
    var phi_4233_: f32;
    var phi_4239_: f32;
    var phi_4244_: f32;
    var phi_4256_: f32;
    var phi_4262_: f32;
    var phi_4267_: f32;
    var phi_4273_: f32;
    var phi_4278_: f32;
    var phi_4304_: f32;
    var phi_4311_: f32;
    var phi_4316_: f32;
    var phi_4323_: f32;
    var phi_4328_: f32;
    var phi_4341_: f32;
    var phi_4348_: f32;
    var phi_4353_: f32;
    var phi_4360_: f32;
    var phi_4365_: f32;
    var phi_4370_: f32;
    var phi_4429_: f32;
    var phi_4435_: f32;
    var phi_4440_: f32;
    var phi_4446_: f32;
    var phi_4451_: f32;
    var phi_4463_: f32;
    var phi_4469_: f32;
    var phi_4474_: f32;
    var phi_4480_: f32;
    var phi_4485_: f32;
    var phi_4534_: f32;
    var phi_4540_: f32;
    var phi_4568_: f32;
    var phi_4574_: f32;
    var phi_4579_: u32;
    var phi_4580_: u32;
    var phi_4550_: f32;
    var phi_4556_: f32;
    var phi_4561_: u32;
    var phi_4562_: u32;
    var phi_4581_: u32;
    var phi_4582_: u32;
    var phi_4649_: f32;
    var phi_4658_: f32;
    var phi_4789_: f32;
    var phi_4795_: f32;
    var phi_4802_: f32;
    var phi_4845_: type_19;
    var phi_4848_: bool;
    var phi_4846_: type_19;
    var phi_4871_: type_19;
    var phi_4898_: bool;
    var phi_4899_: bool;
    var phi_4849_: bool;
    var phi_4900_: bool;
    var phi_4901_: bool;
    var local_16: bool;
    var phi_4905_: bool;
    var local_17: bool;
    var phi_4912_: u32;
    var phi_4913_: u32;
    var phi_4914_: bool;
    var phi_4915_: u32;
    var phi_4916_: u32;
    var phi_4917_: bool;
    var phi_4921_: u32;
    var phi_4941_: bool;
    var phi_4942_: bool;
    var phi_4943_: bool;
    var phi_5139_: f32;
    var phi_5146_: f32;
    var phi_5151_: f32;
    var phi_5158_: f32;
    var phi_5163_: f32;
    var phi_5176_: f32;
    var phi_5183_: f32;
    var phi_5188_: f32;
    var phi_5195_: f32;
    var phi_5200_: f32;
    var phi_5205_: f32;
    var phi_5222_: f32;
    var phi_5229_: f32;
    var phi_5234_: f32;
    var phi_5241_: f32;
    var phi_5246_: f32;
    var phi_5260_: f32;
    var phi_5267_: f32;
    var phi_5272_: f32;
    var phi_5279_: f32;
    var phi_5284_: f32;
    var phi_5289_: f32;
    var phi_5306_: f32;
    var phi_5313_: f32;
    var phi_5318_: f32;
    var phi_5325_: f32;
    var phi_5330_: f32;
    var phi_5344_: f32;
    var phi_5351_: f32;
    var phi_5356_: f32;
    var phi_5363_: f32;
    var phi_5368_: f32;
    var phi_5373_: f32;
    var phi_5389_: type_19;
    var phi_5392_: f32;
    var phi_5390_: type_19;
    var phi_5415_: type_19;
    var phi_5526_: f32;
    var phi_5533_: f32;
    var phi_5541_: f32;
    var phi_5585_: type_17;
    var phi_5588_: f32;
    var phi_5609_: bool;
    var phi_5615_: type_18;
    var phi_5586_: type_17;
    var phi_5629_: type_18;
    var phi_5589_: f32;
    var local_18: f32;
    var phi_5578_: f32;
    var phi_5642_: f32;
    var phi_5651_: type_19;
    var phi_5654_: f32;
    var phi_5652_: type_19;
    var phi_5677_: type_19;
    var phi_5728_: f32;
    var phi_5734_: f32;
    var phi_5747_: bool;
    var phi_5748_: bool;
    var phi_5779_: f32;
    var phi_5780_: f32;
    var phi_5781_: f32;
    var phi_5782_: bool;
    var phi_5786_: bool;
    var phi_5787_: f32;
    var phi_5788_: bool;
    var phi_5789_: bool;
    var phi_5790_: bool;
    var phi_5791_: f32;
    var phi_5792_: bool;
    var phi_5793_: bool;
    var phi_5794_: bool;
    var phi_5655_: f32;
    var phi_5795_: bool;
    var phi_5796_: bool;
    var phi_5797_: bool;
    var phi_5798_: bool;
    var local_19: bool;
    var local_20: f32;
    var local_21: f32;
    var local_22: f32;
    var phi_5815_: bool;
    var phi_5816_: bool;
    var phi_5817_: bool;
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
    var phi_5828_: f32;
    var phi_5829_: f32;
    var phi_5830_: bool;
    var phi_5831_: bool;
    var phi_5832_: bool;
    var phi_5833_: bool;
    var phi_5834_: bool;
    var phi_5835_: bool;
    var phi_5836_: bool;
    var phi_5837_: f32;
    var phi_5838_: f32;
    var phi_5839_: bool;
    var phi_5840_: bool;
    var phi_5841_: bool;
    var phi_5842_: bool;
    var phi_5843_: bool;
    var phi_5844_: bool;
    var phi_5845_: bool;
    var phi_5846_: bool;
    var phi_5847_: f32;
    var phi_5393_: f32;
    var phi_5848_: bool;
    var phi_5849_: bool;
    var phi_5850_: bool;
    var phi_5851_: bool;
    var phi_5852_: bool;
    var phi_5853_: bool;
    var phi_5854_: bool;
    var phi_5855_: bool;
    var phi_5856_: bool;
    var local_23: bool;
    var phi_5861_: type_32;
    var phi_5862_: bool;
    var phi_5863_: bool;
    var phi_5864_: bool;
    var phi_5865_: bool;
    var phi_5866_: bool;
    var phi_5867_: bool;
    var phi_5868_: bool;
    var phi_5872_: f32;
    var phi_5873_: bool;
    var phi_5874_: bool;
    var phi_5875_: bool;
    var phi_5876_: bool;
    var phi_5877_: bool;
    var phi_5878_: bool;
    var phi_5879_: bool;
    var phi_5884_: type_32;
    var phi_5885_: bool;
    var phi_5886_: bool;
    var phi_5887_: bool;
    var phi_5888_: bool;
    var phi_5889_: bool;
    var phi_5890_: bool;
    var local_24: f32;
    var phi_5895_: type_32;
    var phi_5896_: bool;
    var phi_5897_: bool;
    var phi_5898_: bool;
    var phi_5899_: bool;
    var phi_5900_: bool;
    var local_25: f32;
    var phi_5905_: type_32;
    var phi_5906_: bool;
    var phi_5907_: bool;
    var phi_5908_: bool;
    var phi_5909_: bool;
    var local_26: f32;
    var phi_5914_: type_32;
    var phi_5915_: bool;
    var phi_5916_: bool;
    var phi_5917_: bool;
    var phi_5918_: bool;
    var phi_5922_: type_32;
    var phi_5923_: bool;
    var phi_5924_: bool;
    var phi_5925_: bool;
    var phi_5929_: bool;
    var phi_5930_: bool;
    var phi_5934_: bool;
    var phi_5935_: bool;
    var phi_5939_: bool;
    var phi_5940_: bool;
    var local_27: f32;
    var phi_5945_: type_32;
    var phi_5946_: bool;
    var phi_5950_: type_32;
    var phi_5957_: bool;
    var phi_5958_: f32;
    var phi_5959_: bool;
    var phi_5960_: bool;
    var phi_5961_: bool;
    var phi_5962_: f32;
    var phi_5963_: bool;
    var phi_5964_: bool;
    var phi_5965_: bool;
    var phi_5966_: f32;
    var phi_5967_: bool;
    var phi_5968_: bool;
    var phi_5969_: bool;
    var phi_5970_: bool;
    var phi_5974_: bool;
    var phi_5975_: bool;
    var phi_5976_: bool;
    var phi_5977_: f32;
    var phi_5978_: type_33;
    var phi_5979_: bool;
    var phi_5980_: bool;
    var phi_5981_: bool;
    var phi_5982_: bool;
    var local_28: bool;
    var phi_5987_: type_32;
    var phi_5988_: bool;
    var phi_5989_: bool;
    var local_29: f32;
    var phi_5994_: type_32;
    var phi_5995_: bool;
    var local_30: type_33;
    var phi_6001_: type_32;
    var phi_6002_: bool;
    var phi_6006_: type_32;
    var phi_1845_: f32;
    var phi_1852_: f32;
    var phi_1857_: f32;
    var phi_1864_: f32;
    var phi_1869_: f32;
    var phi_1882_: f32;
    var phi_1889_: f32;
    var phi_1894_: f32;
    var phi_1901_: f32;
    var phi_1906_: f32;
    var phi_1911_: f32;
    var phi_1928_: f32;
    var phi_1935_: f32;
    var phi_1940_: f32;
    var phi_1947_: f32;
    var phi_1952_: f32;
    var phi_1966_: f32;
    var phi_1973_: f32;
    var phi_1978_: f32;
    var phi_1985_: f32;
    var phi_1990_: f32;
    var phi_1995_: f32;
    var phi_2012_: f32;
    var phi_2019_: f32;
    var phi_2024_: f32;
    var phi_2031_: f32;
    var phi_2036_: f32;
    var phi_2050_: f32;
    var phi_2057_: f32;
    var phi_2062_: f32;
    var phi_2069_: f32;
    var phi_2074_: f32;
    var phi_2079_: f32;
    var phi_2095_: type_19;
    var phi_2098_: f32;
    var phi_2096_: type_19;
    var phi_2121_: type_19;
    var phi_2232_: f32;
    var phi_2239_: f32;
    var phi_2247_: f32;
    var phi_2291_: type_17;
    var phi_2294_: f32;
    var phi_2315_: bool;
    var phi_2321_: type_18;
    var phi_2292_: type_17;
    var phi_2335_: type_18;
    var phi_2295_: f32;
    var local_31: f32;
    var phi_2284_: f32;
    var phi_2348_: f32;
    var phi_2357_: type_19;
    var phi_2360_: f32;
    var phi_2358_: type_19;
    var phi_2383_: type_19;
    var phi_2434_: f32;
    var phi_2440_: f32;
    var phi_2453_: bool;
    var phi_2454_: bool;
    var phi_2485_: f32;
    var phi_2486_: f32;
    var phi_2487_: f32;
    var phi_2488_: bool;
    var phi_2492_: bool;
    var phi_2493_: f32;
    var phi_2494_: bool;
    var phi_2495_: bool;
    var phi_2496_: bool;
    var phi_2497_: f32;
    var phi_2498_: bool;
    var phi_2499_: bool;
    var phi_2500_: bool;
    var phi_2361_: f32;
    var phi_2501_: bool;
    var phi_2502_: bool;
    var phi_2503_: bool;
    var phi_2504_: bool;
    var local_32: bool;
    var local_33: f32;
    var local_34: f32;
    var local_35: f32;
    var phi_2521_: bool;
    var phi_2522_: bool;
    var phi_2523_: bool;
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
    var phi_2534_: f32;
    var phi_2535_: f32;
    var phi_2536_: bool;
    var phi_2537_: bool;
    var phi_2538_: bool;
    var phi_2539_: bool;
    var phi_2540_: bool;
    var phi_2541_: bool;
    var phi_2542_: bool;
    var phi_2543_: f32;
    var phi_2544_: f32;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2547_: bool;
    var phi_2548_: bool;
    var phi_2549_: bool;
    var phi_2550_: bool;
    var phi_2551_: bool;
    var phi_2552_: bool;
    var phi_2553_: f32;
    var phi_2099_: f32;
    var phi_2554_: bool;
    var phi_2555_: bool;
    var phi_2556_: bool;
    var phi_2557_: bool;
    var phi_2558_: bool;
    var phi_2559_: bool;
    var phi_2560_: bool;
    var phi_2561_: bool;
    var phi_2562_: bool;
    var local_36: bool;
    var phi_2567_: type_32;
    var phi_2568_: bool;
    var phi_2569_: bool;
    var phi_2570_: bool;
    var phi_2571_: bool;
    var phi_2572_: bool;
    var phi_2573_: bool;
    var phi_2574_: bool;
    var phi_2578_: f32;
    var phi_2579_: bool;
    var phi_2580_: bool;
    var phi_2581_: bool;
    var phi_2582_: bool;
    var phi_2583_: bool;
    var phi_2584_: bool;
    var phi_2585_: bool;
    var phi_2590_: type_32;
    var phi_2591_: bool;
    var phi_2592_: bool;
    var phi_2593_: bool;
    var phi_2594_: bool;
    var phi_2595_: bool;
    var phi_2596_: bool;
    var local_37: f32;
    var phi_2601_: type_32;
    var phi_2602_: bool;
    var phi_2603_: bool;
    var phi_2604_: bool;
    var phi_2605_: bool;
    var phi_2606_: bool;
    var local_38: f32;
    var phi_2611_: type_32;
    var phi_2612_: bool;
    var phi_2613_: bool;
    var phi_2614_: bool;
    var phi_2615_: bool;
    var local_39: f32;
    var phi_2620_: type_32;
    var phi_2621_: bool;
    var phi_2622_: bool;
    var phi_2623_: bool;
    var phi_2624_: bool;
    var phi_2628_: type_32;
    var phi_2629_: bool;
    var phi_2630_: bool;
    var phi_2631_: bool;
    var phi_2635_: bool;
    var phi_2636_: bool;
    var phi_2640_: bool;
    var phi_2641_: bool;
    var phi_2645_: bool;
    var phi_2646_: bool;
    var local_40: f32;
    var phi_2651_: type_32;
    var phi_2652_: bool;
    var phi_2656_: type_32;
    var phi_2670_: type_19;
    var phi_2671_: type_19;
    var phi_2694_: type_19;
    var phi_2714_: f32;
    var phi_2844_: type_17;
    var phi_2847_: f32;
    var phi_2868_: bool;
    var phi_2874_: type_18;
    var phi_2845_: type_17;
    var phi_2888_: type_18;
    var phi_2848_: f32;
    var local_41: f32;
    var phi_2837_: f32;
    var phi_2901_: f32;
    var phi_2917_: f32;
    var phi_2924_: f32;
    var phi_2929_: f32;
    var phi_2936_: f32;
    var phi_2941_: f32;
    var phi_2954_: f32;
    var phi_2961_: f32;
    var phi_2966_: f32;
    var phi_2973_: f32;
    var phi_2978_: f32;
    var phi_2983_: f32;
    var phi_3000_: f32;
    var phi_3007_: f32;
    var phi_3012_: f32;
    var phi_3019_: f32;
    var phi_3024_: f32;
    var phi_3038_: f32;
    var phi_3045_: f32;
    var phi_3050_: f32;
    var phi_3057_: f32;
    var phi_3062_: f32;
    var phi_3067_: f32;
    var phi_3084_: f32;
    var phi_3091_: f32;
    var phi_3096_: f32;
    var phi_3103_: f32;
    var phi_3108_: f32;
    var phi_3122_: f32;
    var phi_3129_: f32;
    var phi_3134_: f32;
    var phi_3141_: f32;
    var phi_3146_: f32;
    var phi_3151_: f32;
    var phi_3171_: bool;
    var phi_3172_: bool;
    var phi_3173_: bool;
    var local_42: bool;
    var phi_3178_: type_32;
    var phi_3179_: bool;
    var phi_3184_: type_32;
    var phi_3185_: bool;
    var phi_3187_: type_32;
    var phi_3188_: type_32;
    var phi_3189_: bool;
    var phi_3193_: type_32;
    var phi_6010_: type_32;
    var phi_6011_: type_32;
    var phi_6024_: type_34;
    var phi_6031_: bool;
    var phi_6055_: u32;
    var phi_6059_: type_27;
    var phi_6060_: bool;
    var phi_6061_: bool;
    var phi_6079_: u32;
    var phi_6141_: u32;
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
    let _e111 = params.member.member_15;
    let _e113 = input.member[0u];
    if (_e111 < _e113) {
        phi_751_ = _e111;
    } else {
        phi_751_ = _e113;
    }
    let _e116 = phi_751_;
    let _e117 = (_e116 / 64u);
    if ((_e116 % 64u) > 0u) {
        phi_767_ = (_e117 + 1u);
    } else {
        phi_767_ = _e117;
    }
    let _e122 = phi_767_;
    if (_e122 > _e106) {
        let _e124 = (_e122 - _e106);
        if (_e109 == 0u) {
            return;
        }
        let _e126 = (_e124 / _e109);
        if (_e109 == 0u) {
            return;
        }
        if ((_e124 % _e109) > 0u) {
            phi_788_ = (_e126 + 1u);
        } else {
            phi_788_ = _e126;
        }
        let _e132 = phi_788_;
        phi_789_ = _e132;
    } else {
        phi_789_ = 0u;
    }
    let _e134 = phi_789_;
    phi_792_ = type_19(0u, _e134);
    loop {
        let _e137 = phi_792_;
        if (_e137.member < _e137.member_1) {
            phi_793_ = type_19((_e137.member + 1u), _e137.member_1);
            phi_816_ = type_19(1u, _e137.member);
        } else {
            phi_793_ = _e137;
            phi_816_ = type_19(0u, type_19().member_1);
        }
        let _e149 = phi_793_;
        let _e151 = phi_816_;
        let _e155 = (bitcast<i32>(_e151.member) != 0i);
        if _e155 {
            let _e159 = (((_e106 + (_e151.member_1 * _e109)) * 64u) + _e94);
            let _e161 = params.member.member_8;
            if (_e159 < _e116) {
                let _e164 = (2u * _e159);
                let _e167 = input.member[(4u + _e164)];
                let _e170 = input.member[(_e164 + 5u)];
                let _e172 = elements.member[_e170];
                let _e177 = paths.member[_e167];
                let _e179 = paths.member[_e172[0]];
                let _e185 = paths.member[_e172[1]];
                let _e187 = paths.member[_e172[2]];
                let _e217 = params.member.member_4;
                local_12 = type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e177.member[0] - _e179.member[0]), (_e177.member[1] - _e179.member[1]), (_e177.member[2] - _e179.member[2])), array<f32, 3>((_e177.member_1[0] - _e179.member_1[0]), (_e177.member_1[1] - _e179.member_1[1]), (_e177.member_1[2] - _e179.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e185.member[0] - _e179.member[0]), (_e185.member[1] - _e179.member[1]), (_e185.member[2] - _e179.member[2])), array<f32, 3>((_e185.member_1[0] - _e179.member_1[0]), (_e185.member_1[1] - _e179.member_1[1]), (_e185.member_1[2] - _e179.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e187.member[0] - _e179.member[0]), (_e187.member[1] - _e179.member[1]), (_e187.member[2] - _e179.member[2])), array<f32, 3>((_e187.member_1[0] - _e179.member_1[0]), (_e187.member_1[1] - _e179.member_1[1]), (_e187.member_1[2] - _e179.member_1[2]))), (_e217 + _e217));
                let _e248 = params.member.member_5;
                let _e251 = local_12.member_1[0u];
                let _e257 = local_12.member_2[0u];
                let _e263 = ((_e251[1] * _e257[2]) - (_e251[2] * _e257[1]));
                let _e266 = ((_e251[2] * _e257[0]) - (_e251[0] * _e257[2]));
                let _e269 = ((_e251[0] * _e257[1]) - (_e251[1] * _e257[0]));
                let _e272 = local_12.member_1[1u];
                let _e278 = local_12.member_2[1u];
                let _e284 = ((_e272[1] * _e278[2]) - (_e272[2] * _e278[1]));
                let _e287 = ((_e272[2] * _e278[0]) - (_e272[0] * _e278[2]));
                let _e290 = ((_e272[0] * _e278[1]) - (_e272[1] * _e278[0]));
                let _e293 = local_12.member_1[0u];
                let _e299 = local_12.member_2[1u];
                let _e314 = local_12.member_1[1u];
                let _e320 = local_12.member_2[0u];
                let _e333 = (((_e293[1] * _e299[2]) - (_e293[2] * _e299[1])) + ((_e314[1] * _e320[2]) - (_e314[2] * _e320[1])));
                let _e334 = (((_e293[2] * _e299[0]) - (_e293[0] * _e299[2])) + ((_e314[2] * _e320[0]) - (_e314[0] * _e320[2])));
                let _e335 = (((_e293[0] * _e299[1]) - (_e293[1] * _e299[0])) + ((_e314[0] * _e320[1]) - (_e314[1] * _e320[0])));
                let _e338 = local_12.member[0u];
                let _e346 = (((_e338[0] * _e263) + (_e338[1] * _e266)) + (_e338[2] * _e269));
                let _e349 = local_12.member[1u];
                let _e360 = local_12.member[0u];
                let _e369 = ((((_e349[0] * _e263) + (_e349[1] * _e266)) + (_e349[2] * _e269)) + (((_e360[0] * _e333) + (_e360[1] * _e334)) + (_e360[2] * _e335)));
                let _e372 = local_12.member[0u];
                let _e383 = local_12.member[1u];
                let _e392 = ((((_e372[0] * _e284) + (_e372[1] * _e287)) + (_e372[2] * _e290)) + (((_e383[0] * _e333) + (_e383[1] * _e334)) + (_e383[2] * _e335)));
                let _e395 = local_12.member[1u];
                let _e403 = (((_e395[0] * _e284) + (_e395[1] * _e287)) + (_e395[2] * _e290));
                let _e406 = local_12.member[0u];
                if (_e406[0] < 0f) {
                    phi_1255_ = -(_e406[0]);
                } else {
                    phi_1255_ = _e406[0];
                }
                let _e413 = phi_1255_;
                if (_e406[1] < 0f) {
                    phi_1262_ = -(_e406[1]);
                } else {
                    phi_1262_ = _e406[1];
                }
                let _e417 = phi_1262_;
                if (_e413 > _e417) {
                    phi_1267_ = _e413;
                } else {
                    phi_1267_ = _e417;
                }
                let _e420 = phi_1267_;
                if (_e406[2] < 0f) {
                    phi_1274_ = -(_e406[2]);
                } else {
                    phi_1274_ = _e406[2];
                }
                let _e424 = phi_1274_;
                if (_e420 > _e424) {
                    phi_1279_ = _e420;
                } else {
                    phi_1279_ = _e424;
                }
                let _e427 = phi_1279_;
                let _e430 = local_12.member[1u];
                if (_e430[0] < 0f) {
                    phi_1292_ = -(_e430[0]);
                } else {
                    phi_1292_ = _e430[0];
                }
                let _e437 = phi_1292_;
                if (_e430[1] < 0f) {
                    phi_1299_ = -(_e430[1]);
                } else {
                    phi_1299_ = _e430[1];
                }
                let _e441 = phi_1299_;
                if (_e437 > _e441) {
                    phi_1304_ = _e437;
                } else {
                    phi_1304_ = _e441;
                }
                let _e444 = phi_1304_;
                if (_e430[2] < 0f) {
                    phi_1311_ = -(_e430[2]);
                } else {
                    phi_1311_ = _e430[2];
                }
                let _e448 = phi_1311_;
                if (_e444 > _e448) {
                    phi_1316_ = _e444;
                } else {
                    phi_1316_ = _e448;
                }
                let _e451 = phi_1316_;
                if (_e427 > _e451) {
                    phi_1321_ = _e427;
                } else {
                    phi_1321_ = _e451;
                }
                let _e454 = phi_1321_;
                let _e456 = local_12.member_3;
                let _e457 = (_e454 + _e456);
                let _e460 = local_12.member_1[0u];
                if (_e460[0] < 0f) {
                    phi_1338_ = -(_e460[0]);
                } else {
                    phi_1338_ = _e460[0];
                }
                let _e467 = phi_1338_;
                if (_e460[1] < 0f) {
                    phi_1345_ = -(_e460[1]);
                } else {
                    phi_1345_ = _e460[1];
                }
                let _e471 = phi_1345_;
                if (_e467 > _e471) {
                    phi_1350_ = _e467;
                } else {
                    phi_1350_ = _e471;
                }
                let _e474 = phi_1350_;
                if (_e460[2] < 0f) {
                    phi_1357_ = -(_e460[2]);
                } else {
                    phi_1357_ = _e460[2];
                }
                let _e478 = phi_1357_;
                if (_e474 > _e478) {
                    phi_1362_ = _e474;
                } else {
                    phi_1362_ = _e478;
                }
                let _e481 = phi_1362_;
                let _e484 = local_12.member_1[1u];
                if (_e484[0] < 0f) {
                    phi_1376_ = -(_e484[0]);
                } else {
                    phi_1376_ = _e484[0];
                }
                let _e491 = phi_1376_;
                if (_e484[1] < 0f) {
                    phi_1383_ = -(_e484[1]);
                } else {
                    phi_1383_ = _e484[1];
                }
                let _e495 = phi_1383_;
                if (_e491 > _e495) {
                    phi_1388_ = _e491;
                } else {
                    phi_1388_ = _e495;
                }
                let _e498 = phi_1388_;
                if (_e484[2] < 0f) {
                    phi_1395_ = -(_e484[2]);
                } else {
                    phi_1395_ = _e484[2];
                }
                let _e502 = phi_1395_;
                if (_e498 > _e502) {
                    phi_1400_ = _e498;
                } else {
                    phi_1400_ = _e502;
                }
                let _e505 = phi_1400_;
                if (_e481 > _e505) {
                    phi_1405_ = _e481;
                } else {
                    phi_1405_ = _e505;
                }
                let _e508 = phi_1405_;
                let _e510 = local_12.member_3;
                let _e511 = (_e508 + _e510);
                let _e514 = local_12.member_2[0u];
                if (_e514[0] < 0f) {
                    phi_1422_ = -(_e514[0]);
                } else {
                    phi_1422_ = _e514[0];
                }
                let _e521 = phi_1422_;
                if (_e514[1] < 0f) {
                    phi_1429_ = -(_e514[1]);
                } else {
                    phi_1429_ = _e514[1];
                }
                let _e525 = phi_1429_;
                if (_e521 > _e525) {
                    phi_1434_ = _e521;
                } else {
                    phi_1434_ = _e525;
                }
                let _e528 = phi_1434_;
                if (_e514[2] < 0f) {
                    phi_1441_ = -(_e514[2]);
                } else {
                    phi_1441_ = _e514[2];
                }
                let _e532 = phi_1441_;
                if (_e528 > _e532) {
                    phi_1446_ = _e528;
                } else {
                    phi_1446_ = _e532;
                }
                let _e535 = phi_1446_;
                let _e538 = local_12.member_2[1u];
                if (_e538[0] < 0f) {
                    phi_1460_ = -(_e538[0]);
                } else {
                    phi_1460_ = _e538[0];
                }
                let _e545 = phi_1460_;
                if (_e538[1] < 0f) {
                    phi_1467_ = -(_e538[1]);
                } else {
                    phi_1467_ = _e538[1];
                }
                let _e549 = phi_1467_;
                if (_e545 > _e549) {
                    phi_1472_ = _e545;
                } else {
                    phi_1472_ = _e549;
                }
                let _e552 = phi_1472_;
                if (_e538[2] < 0f) {
                    phi_1479_ = -(_e538[2]);
                } else {
                    phi_1479_ = _e538[2];
                }
                let _e556 = phi_1479_;
                if (_e552 > _e556) {
                    phi_1484_ = _e552;
                } else {
                    phi_1484_ = _e556;
                }
                let _e559 = phi_1484_;
                if (_e535 > _e559) {
                    phi_1489_ = _e535;
                } else {
                    phi_1489_ = _e559;
                }
                let _e562 = phi_1489_;
                let _e564 = local_12.member_3;
                let _e565 = (_e562 + _e564);
                let _e567 = ((_e511 * 8f) * _e565);
                let _e574 = local_12.member_3;
                if (_e263 < 0f) {
                    phi_1520_ = -(_e263);
                } else {
                    phi_1520_ = _e263;
                }
                let _e591 = phi_1520_;
                if (_e266 < 0f) {
                    phi_1526_ = -(_e266);
                } else {
                    phi_1526_ = _e266;
                }
                let _e595 = phi_1526_;
                if (_e269 < 0f) {
                    phi_1533_ = -(_e269);
                } else {
                    phi_1533_ = _e269;
                }
                let _e600 = phi_1533_;
                let _e601 = ((_e591 + _e595) + _e600);
                if (_e284 < 0f) {
                    phi_1540_ = -(_e284);
                } else {
                    phi_1540_ = _e284;
                }
                let _e605 = phi_1540_;
                if (_e287 < 0f) {
                    phi_1546_ = -(_e287);
                } else {
                    phi_1546_ = _e287;
                }
                let _e609 = phi_1546_;
                if (_e290 < 0f) {
                    phi_1553_ = -(_e290);
                } else {
                    phi_1553_ = _e290;
                }
                let _e614 = phi_1553_;
                let _e615 = ((_e605 + _e609) + _e614);
                if (_e601 > _e615) {
                    phi_1559_ = _e601;
                } else {
                    phi_1559_ = _e615;
                }
                let _e618 = phi_1559_;
                if (_e333 < 0f) {
                    phi_1565_ = -(_e333);
                } else {
                    phi_1565_ = _e333;
                }
                let _e622 = phi_1565_;
                if (_e334 < 0f) {
                    phi_1571_ = -(_e334);
                } else {
                    phi_1571_ = _e334;
                }
                let _e626 = phi_1571_;
                if (_e335 < 0f) {
                    phi_1578_ = -(_e335);
                } else {
                    phi_1578_ = _e335;
                }
                let _e631 = phi_1578_;
                let _e633 = (((_e622 + _e626) + _e631) * 0.5f);
                if (_e618 > _e633) {
                    phi_1585_ = _e618;
                } else {
                    phi_1585_ = _e633;
                }
                let _e636 = phi_1585_;
                let _e641 = local_12.member_3;
                let _e653 = (((((_e457 * 8f) * _e567) * (0.000000059604645f * (490f / 64f))) + ((_e574 * 19f) * ((_e457 * (_e511 + _e565)) + (_e511 * _e565)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e457) * ((1f + _e511) * (1f + _e565)))));
                let _e654 = (_e346 * 3f);
                let _e655 = (_e403 * 3f);
                if (_e654 < _e655) {
                    phi_1609_ = _e654;
                } else {
                    phi_1609_ = _e655;
                }
                let _e658 = phi_1609_;
                if (_e369 < _e392) {
                    phi_1614_ = _e369;
                } else {
                    phi_1614_ = _e392;
                }
                let _e661 = phi_1614_;
                if (_e658 < _e661) {
                    phi_1619_ = _e658;
                } else {
                    phi_1619_ = _e661;
                }
                let _e664 = phi_1619_;
                if (_e654 > _e655) {
                    phi_1624_ = _e654;
                } else {
                    phi_1624_ = _e655;
                }
                let _e667 = phi_1624_;
                if (_e369 > _e392) {
                    phi_1629_ = _e369;
                } else {
                    phi_1629_ = _e392;
                }
                let _e670 = phi_1629_;
                if (_e667 > _e670) {
                    phi_1634_ = _e667;
                } else {
                    phi_1634_ = _e670;
                }
                let _e673 = phi_1634_;
                let _e678 = -(_e673);
                if (_e664 > _e678) {
                    phi_1644_ = _e664;
                } else {
                    phi_1644_ = _e678;
                }
                let _e681 = phi_1644_;
                if ((_e681 - (_e653 + ((_e248 * (((_e636 + (_e567 * (0.000000059604645f * 4f))) + ((_e641 * 6f) * (_e511 + _e565))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e511) * (1f + _e565))))) * (3f * 1.0001f)))) > 0f) {
                    phi_6011_ = type_32(0u, type_32().member_1);
                } else {
                    if (_e248 > 0f) {
                        let _e2707 = local_12.member[0u];
                        let _e2713 = local_12.member_1[0u];
                        let _e2719 = local_12.member_2[0u];
                        local_9 = array<array<f32, 3>, 4>(_e2707, array<f32, 3>((_e2707[0] - _e2713[0]), (_e2707[1] - _e2713[1]), (_e2707[2] - _e2713[2])), array<f32, 3>((_e2707[0] - _e2719[0]), (_e2707[1] - _e2719[1]), (_e2707[2] - _e2719[2])), _e2707);
                        let _e2734 = local_12.member[1u];
                        let _e2740 = local_12.member_1[1u];
                        let _e2746 = local_12.member_2[1u];
                        local_10 = array<array<f32, 3>, 4>(_e2734, array<f32, 3>((_e2734[0] - _e2740[0]), (_e2734[1] - _e2740[1]), (_e2734[2] - _e2740[2])), array<f32, 3>((_e2734[0] - _e2746[0]), (_e2734[1] - _e2746[1]), (_e2734[2] - _e2746[2])), _e2734);
                        let _e2761 = local_12.member[0u];
                        if (_e2761[0] < 0f) {
                            phi_1845_ = -(_e2761[0]);
                        } else {
                            phi_1845_ = _e2761[0];
                        }
                        let _e2768 = phi_1845_;
                        if (_e2761[1] < 0f) {
                            phi_1852_ = -(_e2761[1]);
                        } else {
                            phi_1852_ = _e2761[1];
                        }
                        let _e2772 = phi_1852_;
                        if (_e2768 > _e2772) {
                            phi_1857_ = _e2768;
                        } else {
                            phi_1857_ = _e2772;
                        }
                        let _e2775 = phi_1857_;
                        if (_e2761[2] < 0f) {
                            phi_1864_ = -(_e2761[2]);
                        } else {
                            phi_1864_ = _e2761[2];
                        }
                        let _e2779 = phi_1864_;
                        if (_e2775 > _e2779) {
                            phi_1869_ = _e2775;
                        } else {
                            phi_1869_ = _e2779;
                        }
                        let _e2782 = phi_1869_;
                        let _e2785 = local_12.member[1u];
                        if (_e2785[0] < 0f) {
                            phi_1882_ = -(_e2785[0]);
                        } else {
                            phi_1882_ = _e2785[0];
                        }
                        let _e2792 = phi_1882_;
                        if (_e2785[1] < 0f) {
                            phi_1889_ = -(_e2785[1]);
                        } else {
                            phi_1889_ = _e2785[1];
                        }
                        let _e2796 = phi_1889_;
                        if (_e2792 > _e2796) {
                            phi_1894_ = _e2792;
                        } else {
                            phi_1894_ = _e2796;
                        }
                        let _e2799 = phi_1894_;
                        if (_e2785[2] < 0f) {
                            phi_1901_ = -(_e2785[2]);
                        } else {
                            phi_1901_ = _e2785[2];
                        }
                        let _e2803 = phi_1901_;
                        if (_e2799 > _e2803) {
                            phi_1906_ = _e2799;
                        } else {
                            phi_1906_ = _e2803;
                        }
                        let _e2806 = phi_1906_;
                        if (_e2782 > _e2806) {
                            phi_1911_ = _e2782;
                        } else {
                            phi_1911_ = _e2806;
                        }
                        let _e2809 = phi_1911_;
                        let _e2811 = local_12.member_3;
                        let _e2815 = local_12.member_1[0u];
                        if (_e2815[0] < 0f) {
                            phi_1928_ = -(_e2815[0]);
                        } else {
                            phi_1928_ = _e2815[0];
                        }
                        let _e2822 = phi_1928_;
                        if (_e2815[1] < 0f) {
                            phi_1935_ = -(_e2815[1]);
                        } else {
                            phi_1935_ = _e2815[1];
                        }
                        let _e2826 = phi_1935_;
                        if (_e2822 > _e2826) {
                            phi_1940_ = _e2822;
                        } else {
                            phi_1940_ = _e2826;
                        }
                        let _e2829 = phi_1940_;
                        if (_e2815[2] < 0f) {
                            phi_1947_ = -(_e2815[2]);
                        } else {
                            phi_1947_ = _e2815[2];
                        }
                        let _e2833 = phi_1947_;
                        if (_e2829 > _e2833) {
                            phi_1952_ = _e2829;
                        } else {
                            phi_1952_ = _e2833;
                        }
                        let _e2836 = phi_1952_;
                        let _e2839 = local_12.member_1[1u];
                        if (_e2839[0] < 0f) {
                            phi_1966_ = -(_e2839[0]);
                        } else {
                            phi_1966_ = _e2839[0];
                        }
                        let _e2846 = phi_1966_;
                        if (_e2839[1] < 0f) {
                            phi_1973_ = -(_e2839[1]);
                        } else {
                            phi_1973_ = _e2839[1];
                        }
                        let _e2850 = phi_1973_;
                        if (_e2846 > _e2850) {
                            phi_1978_ = _e2846;
                        } else {
                            phi_1978_ = _e2850;
                        }
                        let _e2853 = phi_1978_;
                        if (_e2839[2] < 0f) {
                            phi_1985_ = -(_e2839[2]);
                        } else {
                            phi_1985_ = _e2839[2];
                        }
                        let _e2857 = phi_1985_;
                        if (_e2853 > _e2857) {
                            phi_1990_ = _e2853;
                        } else {
                            phi_1990_ = _e2857;
                        }
                        let _e2860 = phi_1990_;
                        if (_e2836 > _e2860) {
                            phi_1995_ = _e2836;
                        } else {
                            phi_1995_ = _e2860;
                        }
                        let _e2863 = phi_1995_;
                        let _e2865 = local_12.member_3;
                        let _e2869 = local_12.member_2[0u];
                        if (_e2869[0] < 0f) {
                            phi_2012_ = -(_e2869[0]);
                        } else {
                            phi_2012_ = _e2869[0];
                        }
                        let _e2876 = phi_2012_;
                        if (_e2869[1] < 0f) {
                            phi_2019_ = -(_e2869[1]);
                        } else {
                            phi_2019_ = _e2869[1];
                        }
                        let _e2880 = phi_2019_;
                        if (_e2876 > _e2880) {
                            phi_2024_ = _e2876;
                        } else {
                            phi_2024_ = _e2880;
                        }
                        let _e2883 = phi_2024_;
                        if (_e2869[2] < 0f) {
                            phi_2031_ = -(_e2869[2]);
                        } else {
                            phi_2031_ = _e2869[2];
                        }
                        let _e2887 = phi_2031_;
                        if (_e2883 > _e2887) {
                            phi_2036_ = _e2883;
                        } else {
                            phi_2036_ = _e2887;
                        }
                        let _e2890 = phi_2036_;
                        let _e2893 = local_12.member_2[1u];
                        if (_e2893[0] < 0f) {
                            phi_2050_ = -(_e2893[0]);
                        } else {
                            phi_2050_ = _e2893[0];
                        }
                        let _e2900 = phi_2050_;
                        if (_e2893[1] < 0f) {
                            phi_2057_ = -(_e2893[1]);
                        } else {
                            phi_2057_ = _e2893[1];
                        }
                        let _e2904 = phi_2057_;
                        if (_e2900 > _e2904) {
                            phi_2062_ = _e2900;
                        } else {
                            phi_2062_ = _e2904;
                        }
                        let _e2907 = phi_2062_;
                        if (_e2893[2] < 0f) {
                            phi_2069_ = -(_e2893[2]);
                        } else {
                            phi_2069_ = _e2893[2];
                        }
                        let _e2911 = phi_2069_;
                        if (_e2907 > _e2911) {
                            phi_2074_ = _e2907;
                        } else {
                            phi_2074_ = _e2911;
                        }
                        let _e2914 = phi_2074_;
                        if (_e2890 > _e2914) {
                            phi_2079_ = _e2890;
                        } else {
                            phi_2079_ = _e2914;
                        }
                        let _e2917 = phi_2079_;
                        let _e2919 = local_12.member_3;
                        let _e2926 = local_12.member_3;
                        phi_2095_ = type_19(0u, 48u);
                        phi_2098_ = 0f;
                        loop {
                            let _e2932 = phi_2095_;
                            let _e2934 = phi_2098_;
                            local_77 = _e2934;
                            local_37 = _e2934;
                            local_38 = _e2934;
                            local_39 = _e2934;
                            local_40 = _e2934;
                            if (_e2932.member < _e2932.member_1) {
                                phi_2096_ = type_19((_e2932.member + 1u), _e2932.member_1);
                                phi_2121_ = type_19(1u, _e2932.member);
                            } else {
                                phi_2096_ = _e2932;
                                phi_2121_ = type_19(0u, type_19().member_1);
                            }
                            let _e2946 = phi_2096_;
                            let _e2948 = phi_2121_;
                            if (bitcast<i32>(_e2948.member) != 0i) {
                                let _e2954 = local_12.member[0u];
                                let _e2960 = local_12.member[1u];
                                let _e2976 = local_12.member_1[0u];
                                let _e2982 = local_12.member_1[1u];
                                let _e2998 = local_12.member_2[0u];
                                let _e3004 = local_12.member_2[1u];
                                let _e3018 = function_1(array<f32, 3>((_e2954[0] + ((_e2960[0] - _e2954[0]) * _e2934)), (_e2954[1] + ((_e2960[1] - _e2954[1]) * _e2934)), (_e2954[2] + ((_e2960[2] - _e2954[2]) * _e2934))), array<f32, 3>((_e2976[0] + ((_e2982[0] - _e2976[0]) * _e2934)), (_e2976[1] + ((_e2982[1] - _e2976[1]) * _e2934)), (_e2976[2] + ((_e2982[2] - _e2976[2]) * _e2934))), array<f32, 3>((_e2998[0] + ((_e3004[0] - _e2998[0]) * _e2934)), (_e2998[1] + ((_e3004[1] - _e2998[1]) * _e2934)), (_e2998[2] + ((_e3004[2] - _e2998[2]) * _e2934))), 0u);
                                if (_e3018[0] < 0f) {
                                    phi_2232_ = -(_e3018[0]);
                                } else {
                                    phi_2232_ = _e3018[0];
                                }
                                let _e3023 = phi_2232_;
                                if (_e3018[1] < 0f) {
                                    phi_2239_ = -(_e3018[1]);
                                } else {
                                    phi_2239_ = _e3018[1];
                                }
                                let _e3028 = phi_2239_;
                                if (_e3018[2] < 0f) {
                                    phi_2247_ = -(_e3018[2]);
                                } else {
                                    phi_2247_ = _e3018[2];
                                }
                                let _e3034 = phi_2247_;
                                let _e3035 = ((_e3023 + _e3028) + _e3034);
                                if (_e3035 > 0f) {
                                    if ((bitcast<u32>(_e3035) & 2139095040u) != 2139095040u) {
                                        let _e3040 = (1f / _e3035);
                                        let _e3042 = (_e3018[0] * _e3040);
                                        let _e3044 = (_e3018[1] * _e3040);
                                        let _e3046 = (_e3018[2] * _e3040);
                                        let _e3051 = (((_e3042 * _e3042) + (_e3044 * _e3044)) + (_e3046 * _e3046));
                                        if (_e3051 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3051 > 0f) {
                                                phi_2284_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2284_ = 0f;
                                            }
                                            let _e3104 = phi_2284_;
                                            phi_2348_ = _e3104;
                                        } else {
                                            phi_2291_ = type_17(0i, 5i);
                                            phi_2294_ = bitcast<f32>(((bitcast<u32>(_e3051) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3059 = phi_2291_;
                                                let _e3061 = phi_2294_;
                                                local_31 = _e3061;
                                                if (_e3059.member < _e3059.member_1) {
                                                    let _e3068 = (_e3059.member + 1i);
                                                    if ((false == (_e3068 > _e3059.member)) != false) {
                                                        phi_2315_ = true;
                                                    } else {
                                                        phi_2315_ = false;
                                                    }
                                                    let _e3073 = phi_2315_;
                                                    if _e3073 {
                                                        phi_2321_ = type_18(0u, type_18().member_1);
                                                    } else {
                                                        phi_2321_ = type_18(1u, _e3068);
                                                    }
                                                    let _e3078 = phi_2321_;
                                                    phi_2292_ = type_17(_e3078.member_1, _e3059.member_1);
                                                    phi_2335_ = type_18(1u, _e3059.member);
                                                } else {
                                                    phi_2292_ = _e3059;
                                                    phi_2335_ = type_18(0u, type_18().member_1);
                                                }
                                                let _e3084 = phi_2292_;
                                                let _e3086 = phi_2335_;
                                                let _e3089 = (bitcast<i32>(_e3086.member) != 0i);
                                                if _e3089 {
                                                    phi_2295_ = (0.5f * (_e3061 + (_e3051 / _e3061)));
                                                } else {
                                                    phi_2295_ = f32();
                                                }
                                                let _e3094 = phi_2295_;
                                                continue;
                                                continuing {
                                                    phi_2291_ = _e3084;
                                                    phi_2294_ = _e3094;
                                                    break if !(_e3089);
                                                }
                                            }
                                            let _e3099 = local_31;
                                            phi_2348_ = (_e3099 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3106 = phi_2348_;
                                        phi_2357_ = type_19(0u, 4u);
                                        phi_2360_ = 2f;
                                        loop {
                                            let _e3114 = phi_2357_;
                                            let _e3116 = phi_2360_;
                                            local_33 = _e3116;
                                            local_34 = _e3116;
                                            local_35 = _e3116;
                                            local_67 = _e3116;
                                            local_68 = _e3116;
                                            if (_e3114.member < _e3114.member_1) {
                                                phi_2358_ = type_19((_e3114.member + 1u), _e3114.member_1);
                                                phi_2383_ = type_19(1u, _e3114.member);
                                            } else {
                                                phi_2358_ = _e3114;
                                                phi_2383_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e3128 = phi_2358_;
                                            let _e3130 = phi_2383_;
                                            if (bitcast<i32>(_e3130.member) != 0i) {
                                                let _e3136 = local_9[_e3130.member_1];
                                                let _e3144 = (((_e3042 * _e3136[0]) + (_e3044 * _e3136[1])) + (_e3046 * _e3136[2]));
                                                let _e3146 = local_10[_e3130.member_1];
                                                let _e3154 = (((_e3042 * _e3146[0]) + (_e3044 * _e3146[1])) + (_e3046 * _e3146[2]));
                                                if (_e3144 < 0f) {
                                                    phi_2434_ = -(_e3144);
                                                } else {
                                                    phi_2434_ = _e3144;
                                                }
                                                let _e3158 = phi_2434_;
                                                if (_e3154 < 0f) {
                                                    phi_2440_ = -(_e3154);
                                                } else {
                                                    phi_2440_ = _e3154;
                                                }
                                                let _e3162 = phi_2440_;
                                                let _e3166 = (((((((((_e2809 + _e2811) + (_e2863 + _e2865)) + (_e2917 + _e2919)) * (0.000000059604645f * 16f)) + (_e2926 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e248 * _e3106) * (1f + (0.000000059604645f * 8f)))) + ((_e3158 + _e3162) * (0.000000059604645f * 8f)));
                                                if (_e3144 > _e3166) {
                                                    if (_e3154 > _e3166) {
                                                        phi_2453_ = false;
                                                    } else {
                                                        phi_2453_ = true;
                                                    }
                                                    let _e3170 = phi_2453_;
                                                    phi_2454_ = _e3170;
                                                } else {
                                                    phi_2454_ = true;
                                                }
                                                let _e3172 = phi_2454_;
                                                if _e3172 {
                                                    if ((_e3144 + ((_e3154 - _e3144) * _e2934)) > _e3166) {
                                                        if (_e3154 < _e3144) {
                                                            let _e3180 = ((_e3144 - _e3154) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                            if _e3180 {
                                                                let _e3186 = (((_e3144 - _e3166) / (_e3144 - _e3154)) * (1f - (0.000000059604645f * 16f)));
                                                                if (_e3116 < _e3186) {
                                                                    phi_2485_ = _e3116;
                                                                } else {
                                                                    phi_2485_ = _e3186;
                                                                }
                                                                let _e3189 = phi_2485_;
                                                                phi_2486_ = _e3189;
                                                            } else {
                                                                phi_2486_ = f32();
                                                            }
                                                            let _e3191 = phi_2486_;
                                                            phi_2487_ = _e3191;
                                                            phi_2488_ = _e3180;
                                                        } else {
                                                            phi_2487_ = _e3116;
                                                            phi_2488_ = true;
                                                        }
                                                        let _e3193 = phi_2487_;
                                                        let _e3195 = phi_2488_;
                                                        if _e3195 {
                                                            phi_2492_ = false;
                                                        } else {
                                                            phi_2492_ = true;
                                                        }
                                                        let _e3197 = phi_2492_;
                                                        phi_2493_ = _e3193;
                                                        phi_2494_ = _e3195;
                                                        phi_2495_ = _e3197;
                                                        phi_2496_ = false;
                                                    } else {
                                                        phi_2493_ = f32();
                                                        phi_2494_ = false;
                                                        phi_2495_ = false;
                                                        phi_2496_ = true;
                                                    }
                                                    let _e3199 = phi_2493_;
                                                    let _e3201 = phi_2494_;
                                                    let _e3203 = phi_2495_;
                                                    let _e3205 = phi_2496_;
                                                    phi_2497_ = _e3199;
                                                    phi_2498_ = _e3201;
                                                    phi_2499_ = _e3203;
                                                    phi_2500_ = _e3205;
                                                } else {
                                                    phi_2497_ = _e3116;
                                                    phi_2498_ = true;
                                                    phi_2499_ = false;
                                                    phi_2500_ = false;
                                                }
                                                let _e3207 = phi_2497_;
                                                let _e3209 = phi_2498_;
                                                let _e3211 = phi_2499_;
                                                let _e3213 = phi_2500_;
                                                phi_2361_ = _e3207;
                                                phi_2501_ = _e3209;
                                                phi_2502_ = false;
                                                phi_2503_ = _e3211;
                                                phi_2504_ = _e3213;
                                            } else {
                                                phi_2361_ = f32();
                                                phi_2501_ = false;
                                                phi_2502_ = true;
                                                phi_2503_ = false;
                                                phi_2504_ = false;
                                            }
                                            let _e3215 = phi_2361_;
                                            let _e3217 = phi_2501_;
                                            let _e3219 = phi_2502_;
                                            let _e3221 = phi_2503_;
                                            let _e3223 = phi_2504_;
                                            local_32 = _e3219;
                                            local_65 = _e3221;
                                            local_66 = _e3223;
                                            continue;
                                            continuing {
                                                phi_2357_ = _e3128;
                                                phi_2360_ = _e3215;
                                                break if !(_e3217);
                                            }
                                        }
                                        let _e3226 = local_32;
                                        if _e3226 {
                                            let _e3228 = local_33;
                                            let _e3229 = (_e3228 > 1f);
                                            if _e3229 {
                                                phi_2525_ = false;
                                                phi_2526_ = false;
                                                phi_2527_ = false;
                                            } else {
                                                let _e3231 = local_34;
                                                if (_e3231 > _e2934) {
                                                    let _e3234 = local_35;
                                                    let _e3236 = ((_e3234 - _e2934) < 0.00000000023283064f);
                                                    if _e3236 {
                                                        phi_2521_ = false;
                                                    } else {
                                                        phi_2521_ = true;
                                                    }
                                                    let _e3238 = phi_2521_;
                                                    phi_2522_ = _e3238;
                                                    phi_2523_ = _e3236;
                                                    phi_2524_ = false;
                                                } else {
                                                    phi_2522_ = false;
                                                    phi_2523_ = false;
                                                    phi_2524_ = true;
                                                }
                                                let _e3240 = phi_2522_;
                                                let _e3242 = phi_2523_;
                                                let _e3244 = phi_2524_;
                                                phi_2525_ = _e3240;
                                                phi_2526_ = _e3242;
                                                phi_2527_ = _e3244;
                                            }
                                            let _e3246 = phi_2525_;
                                            let _e3248 = phi_2526_;
                                            let _e3250 = phi_2527_;
                                            phi_2528_ = _e3246;
                                            phi_2529_ = _e3229;
                                            phi_2530_ = _e3248;
                                            phi_2531_ = _e3250;
                                            phi_2532_ = false;
                                            phi_2533_ = false;
                                        } else {
                                            phi_2528_ = false;
                                            phi_2529_ = false;
                                            phi_2530_ = false;
                                            phi_2531_ = false;
                                            let _e4547 = local_65;
                                            phi_2532_ = _e4547;
                                            let _e4550 = local_66;
                                            phi_2533_ = _e4550;
                                        }
                                        let _e3252 = phi_2528_;
                                        let _e3254 = phi_2529_;
                                        let _e3256 = phi_2530_;
                                        let _e3258 = phi_2531_;
                                        let _e3260 = phi_2532_;
                                        let _e3262 = phi_2533_;
                                        let _e4553 = local_67;
                                        phi_2534_ = _e4553;
                                        let _e4556 = local_68;
                                        phi_2535_ = _e4556;
                                        phi_2536_ = _e3252;
                                        phi_2537_ = _e3254;
                                        phi_2538_ = _e3256;
                                        phi_2539_ = _e3258;
                                        phi_2540_ = _e3260;
                                        phi_2541_ = _e3262;
                                        phi_2542_ = false;
                                    } else {
                                        phi_2534_ = f32();
                                        phi_2535_ = f32();
                                        phi_2536_ = false;
                                        phi_2537_ = false;
                                        phi_2538_ = false;
                                        phi_2539_ = false;
                                        phi_2540_ = false;
                                        phi_2541_ = false;
                                        phi_2542_ = true;
                                    }
                                    let _e3264 = phi_2534_;
                                    let _e3266 = phi_2535_;
                                    let _e3268 = phi_2536_;
                                    let _e3270 = phi_2537_;
                                    let _e3272 = phi_2538_;
                                    let _e3274 = phi_2539_;
                                    let _e3276 = phi_2540_;
                                    let _e3278 = phi_2541_;
                                    let _e3280 = phi_2542_;
                                    phi_2543_ = _e3264;
                                    phi_2544_ = _e3266;
                                    phi_2545_ = _e3268;
                                    phi_2546_ = _e3270;
                                    phi_2547_ = _e3272;
                                    phi_2548_ = _e3274;
                                    phi_2549_ = _e3276;
                                    phi_2550_ = _e3278;
                                    phi_2551_ = _e3280;
                                    phi_2552_ = false;
                                } else {
                                    phi_2543_ = f32();
                                    phi_2544_ = f32();
                                    phi_2545_ = false;
                                    phi_2546_ = false;
                                    phi_2547_ = false;
                                    phi_2548_ = false;
                                    phi_2549_ = false;
                                    phi_2550_ = false;
                                    phi_2551_ = false;
                                    phi_2552_ = true;
                                }
                                let _e3282 = phi_2543_;
                                let _e3284 = phi_2544_;
                                let _e3286 = phi_2545_;
                                let _e3288 = phi_2546_;
                                let _e3290 = phi_2547_;
                                let _e3292 = phi_2548_;
                                let _e3294 = phi_2549_;
                                let _e3296 = phi_2550_;
                                let _e3298 = phi_2551_;
                                let _e3300 = phi_2552_;
                                phi_2553_ = _e3282;
                                phi_2099_ = _e3284;
                                phi_2554_ = _e3286;
                                phi_2555_ = _e3288;
                                phi_2556_ = _e3290;
                                phi_2557_ = false;
                                phi_2558_ = _e3292;
                                phi_2559_ = _e3294;
                                phi_2560_ = _e3296;
                                phi_2561_ = _e3298;
                                phi_2562_ = _e3300;
                            } else {
                                phi_2553_ = f32();
                                phi_2099_ = f32();
                                phi_2554_ = false;
                                phi_2555_ = false;
                                phi_2556_ = false;
                                phi_2557_ = true;
                                phi_2558_ = false;
                                phi_2559_ = false;
                                phi_2560_ = false;
                                phi_2561_ = false;
                                phi_2562_ = false;
                            }
                            let _e3302 = phi_2553_;
                            let _e3304 = phi_2099_;
                            let _e3306 = phi_2554_;
                            let _e3308 = phi_2555_;
                            let _e3310 = phi_2556_;
                            let _e3312 = phi_2557_;
                            let _e3314 = phi_2558_;
                            let _e3316 = phi_2559_;
                            let _e3318 = phi_2560_;
                            let _e3320 = phi_2561_;
                            let _e3322 = phi_2562_;
                            local_36 = _e3308;
                            local_69 = _e3310;
                            local_70 = _e3312;
                            local_71 = _e3314;
                            local_72 = _e3316;
                            local_73 = _e3318;
                            local_74 = _e3320;
                            local_75 = _e3322;
                            local_76 = _e3302;
                            local_78 = _e3308;
                            continue;
                            continuing {
                                phi_2095_ = _e2946;
                                phi_2098_ = _e3304;
                                break if !(_e3306);
                            }
                        }
                        let _e3325 = local_36;
                        if _e3325 {
                            phi_2567_ = type_32(0u, type_32().member_1);
                            phi_2568_ = false;
                            phi_2569_ = false;
                            phi_2570_ = false;
                            phi_2571_ = false;
                            phi_2572_ = false;
                            phi_2573_ = false;
                            phi_2574_ = false;
                        } else {
                            phi_2567_ = type_32();
                            let _e4589 = local_69;
                            phi_2568_ = _e4589;
                            let _e4592 = local_70;
                            phi_2569_ = _e4592;
                            let _e4595 = local_71;
                            phi_2570_ = _e4595;
                            let _e4598 = local_72;
                            phi_2571_ = _e4598;
                            let _e4601 = local_73;
                            phi_2572_ = _e4601;
                            let _e4604 = local_74;
                            phi_2573_ = _e4604;
                            let _e4607 = local_75;
                            phi_2574_ = _e4607;
                        }
                        let _e3329 = phi_2567_;
                        let _e3331 = phi_2568_;
                        let _e3333 = phi_2569_;
                        let _e3335 = phi_2570_;
                        let _e3337 = phi_2571_;
                        let _e3339 = phi_2572_;
                        let _e3341 = phi_2573_;
                        let _e3343 = phi_2574_;
                        if _e3331 {
                            let _e4610 = local_76;
                            phi_2578_ = _e4610;
                            phi_2579_ = true;
                            phi_2580_ = false;
                            phi_2581_ = false;
                            phi_2582_ = false;
                            phi_2583_ = false;
                            phi_2584_ = false;
                            phi_2585_ = false;
                        } else {
                            let _e4612 = local_77;
                            phi_2578_ = _e4612;
                            phi_2579_ = _e3333;
                            phi_2580_ = _e3335;
                            phi_2581_ = _e3337;
                            phi_2582_ = _e3339;
                            let _e4619 = local_78;
                            phi_2583_ = _e4619;
                            phi_2584_ = _e3341;
                            phi_2585_ = _e3343;
                        }
                        let _e3345 = phi_2578_;
                        let _e3347 = phi_2579_;
                        let _e3349 = phi_2580_;
                        let _e3351 = phi_2581_;
                        let _e3353 = phi_2582_;
                        let _e3355 = phi_2583_;
                        let _e3357 = phi_2584_;
                        let _e3359 = phi_2585_;
                        if _e3347 {
                            phi_2590_ = type_32(1u, _e3345);
                            phi_2591_ = false;
                            phi_2592_ = false;
                            phi_2593_ = false;
                            phi_2594_ = false;
                            phi_2595_ = false;
                            phi_2596_ = false;
                        } else {
                            phi_2590_ = type_32();
                            phi_2591_ = _e3349;
                            phi_2592_ = _e3351;
                            phi_2593_ = _e3353;
                            phi_2594_ = _e3355;
                            phi_2595_ = _e3357;
                            phi_2596_ = _e3359;
                        }
                        let _e3362 = phi_2590_;
                        let _e3364 = phi_2591_;
                        let _e3366 = phi_2592_;
                        let _e3368 = phi_2593_;
                        let _e3370 = phi_2594_;
                        let _e3372 = phi_2595_;
                        let _e3374 = phi_2596_;
                        if _e3364 {
                            let _e3376 = local_37;
                            phi_2601_ = type_32(1u, _e3376);
                            phi_2602_ = false;
                            phi_2603_ = false;
                            phi_2604_ = true;
                            phi_2605_ = false;
                            phi_2606_ = false;
                        } else {
                            phi_2601_ = _e3329;
                            phi_2602_ = _e3366;
                            phi_2603_ = _e3368;
                            phi_2604_ = _e3370;
                            phi_2605_ = _e3372;
                            phi_2606_ = _e3374;
                        }
                        let _e3379 = phi_2601_;
                        let _e3381 = phi_2602_;
                        let _e3383 = phi_2603_;
                        let _e3385 = phi_2604_;
                        let _e3387 = phi_2605_;
                        let _e3389 = phi_2606_;
                        if _e3381 {
                            let _e3391 = local_38;
                            phi_2611_ = type_32(1u, _e3391);
                            phi_2612_ = false;
                            phi_2613_ = false;
                            phi_2614_ = false;
                            phi_2615_ = false;
                        } else {
                            phi_2611_ = type_32();
                            phi_2612_ = _e3383;
                            phi_2613_ = _e3385;
                            phi_2614_ = _e3387;
                            phi_2615_ = _e3389;
                        }
                        let _e3394 = phi_2611_;
                        let _e3396 = phi_2612_;
                        let _e3398 = phi_2613_;
                        let _e3400 = phi_2614_;
                        let _e3402 = phi_2615_;
                        if _e3396 {
                            let _e3404 = local_39;
                            phi_2620_ = type_32(1u, _e3404);
                            phi_2621_ = true;
                            phi_2622_ = false;
                            phi_2623_ = false;
                            phi_2624_ = false;
                        } else {
                            phi_2620_ = _e3394;
                            phi_2621_ = _e3381;
                            phi_2622_ = _e3398;
                            phi_2623_ = _e3400;
                            phi_2624_ = _e3402;
                        }
                        let _e3407 = phi_2620_;
                        let _e3409 = phi_2621_;
                        let _e3411 = phi_2622_;
                        let _e3413 = phi_2623_;
                        let _e3415 = phi_2624_;
                        if _e3409 {
                            phi_2628_ = _e3407;
                            phi_2629_ = true;
                            phi_2630_ = false;
                            phi_2631_ = false;
                        } else {
                            phi_2628_ = _e3379;
                            phi_2629_ = _e3411;
                            phi_2630_ = _e3413;
                            phi_2631_ = _e3415;
                        }
                        let _e3417 = phi_2628_;
                        let _e3419 = phi_2629_;
                        let _e3421 = phi_2630_;
                        let _e3423 = phi_2631_;
                        if _e3419 {
                            phi_2635_ = false;
                            phi_2636_ = false;
                        } else {
                            phi_2635_ = _e3421;
                            phi_2636_ = _e3423;
                        }
                        let _e3425 = phi_2635_;
                        let _e3427 = phi_2636_;
                        if _e3425 {
                            phi_2640_ = false;
                            phi_2641_ = false;
                        } else {
                            phi_2640_ = _e3427;
                            phi_2641_ = _e3419;
                        }
                        let _e3429 = phi_2640_;
                        let _e3431 = phi_2641_;
                        if _e3429 {
                            phi_2645_ = true;
                            phi_2646_ = false;
                        } else {
                            phi_2645_ = _e3425;
                            phi_2646_ = _e3431;
                        }
                        let _e3433 = phi_2645_;
                        let _e3435 = phi_2646_;
                        if _e3433 {
                            let _e3437 = local_40;
                            phi_2651_ = type_32(1u, _e3437);
                            phi_2652_ = true;
                        } else {
                            phi_2651_ = _e3417;
                            phi_2652_ = _e3435;
                        }
                        let _e3440 = phi_2651_;
                        let _e3442 = phi_2652_;
                        if _e3442 {
                            phi_2656_ = _e3440;
                        } else {
                            phi_2656_ = _e3362;
                        }
                        let _e3444 = phi_2656_;
                        if (_e3444.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_2670_ = type_19(0u, 3u);
                            loop {
                                let _e3456 = phi_2670_;
                                if (_e3456.member < _e3456.member_1) {
                                    phi_2671_ = type_19((_e3456.member + 1u), _e3456.member_1);
                                    phi_2694_ = type_19(1u, _e3456.member);
                                } else {
                                    phi_2671_ = _e3456;
                                    phi_2694_ = type_19(0u, type_19().member_1);
                                }
                                let _e3468 = phi_2671_;
                                let _e3470 = phi_2694_;
                                if (bitcast<i32>(_e3470.member) != 0i) {
                                    let _e3476 = local_11[_e3470.member_1];
                                    let _e3477 = (_e3444.member_1 + _e3476);
                                    if (_e3477 < 1f) {
                                        phi_2714_ = _e3477;
                                    } else {
                                        phi_2714_ = 1f;
                                    }
                                    let _e3480 = phi_2714_;
                                    let _e3483 = local_12.member[0u];
                                    let _e3489 = local_12.member[1u];
                                    let _e3505 = local_12.member_1[0u];
                                    let _e3511 = local_12.member_1[1u];
                                    let _e3527 = local_12.member_2[0u];
                                    let _e3533 = local_12.member_2[1u];
                                    let _e3547 = function_1(array<f32, 3>((_e3483[0] + ((_e3489[0] - _e3483[0]) * _e3480)), (_e3483[1] + ((_e3489[1] - _e3483[1]) * _e3480)), (_e3483[2] + ((_e3489[2] - _e3483[2]) * _e3480))), array<f32, 3>((_e3505[0] + ((_e3511[0] - _e3505[0]) * _e3480)), (_e3505[1] + ((_e3511[1] - _e3505[1]) * _e3480)), (_e3505[2] + ((_e3511[2] - _e3505[2]) * _e3480))), array<f32, 3>((_e3527[0] + ((_e3533[0] - _e3527[0]) * _e3480)), (_e3527[1] + ((_e3533[1] - _e3527[1]) * _e3480)), (_e3527[2] + ((_e3533[2] - _e3527[2]) * _e3480))), 0u);
                                    let _e3558 = (((_e3547[0] * _e3547[0]) + (_e3547[1] * _e3547[1])) + (_e3547[2] * _e3547[2]));
                                    if (_e3558 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e3558 > 0f) {
                                            phi_2837_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_2837_ = 0f;
                                        }
                                        let _e3611 = phi_2837_;
                                        phi_2901_ = _e3611;
                                    } else {
                                        phi_2844_ = type_17(0i, 5i);
                                        phi_2847_ = bitcast<f32>(((bitcast<u32>(_e3558) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e3566 = phi_2844_;
                                            let _e3568 = phi_2847_;
                                            local_41 = _e3568;
                                            if (_e3566.member < _e3566.member_1) {
                                                let _e3575 = (_e3566.member + 1i);
                                                if ((false == (_e3575 > _e3566.member)) != false) {
                                                    phi_2868_ = true;
                                                } else {
                                                    phi_2868_ = false;
                                                }
                                                let _e3580 = phi_2868_;
                                                if _e3580 {
                                                    phi_2874_ = type_18(0u, type_18().member_1);
                                                } else {
                                                    phi_2874_ = type_18(1u, _e3575);
                                                }
                                                let _e3585 = phi_2874_;
                                                phi_2845_ = type_17(_e3585.member_1, _e3566.member_1);
                                                phi_2888_ = type_18(1u, _e3566.member);
                                            } else {
                                                phi_2845_ = _e3566;
                                                phi_2888_ = type_18(0u, type_18().member_1);
                                            }
                                            let _e3591 = phi_2845_;
                                            let _e3593 = phi_2888_;
                                            let _e3596 = (bitcast<i32>(_e3593.member) != 0i);
                                            if _e3596 {
                                                phi_2848_ = (0.5f * (_e3568 + (_e3558 / _e3568)));
                                            } else {
                                                phi_2848_ = f32();
                                            }
                                            let _e3601 = phi_2848_;
                                            continue;
                                            continuing {
                                                phi_2844_ = _e3591;
                                                phi_2847_ = _e3601;
                                                break if !(_e3596);
                                            }
                                        }
                                        let _e3606 = local_41;
                                        phi_2901_ = (_e3606 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e3613 = phi_2901_;
                                    let _e3619 = local_12.member[0u];
                                    if (_e3619[0] < 0f) {
                                        phi_2917_ = -(_e3619[0]);
                                    } else {
                                        phi_2917_ = _e3619[0];
                                    }
                                    let _e3626 = phi_2917_;
                                    if (_e3619[1] < 0f) {
                                        phi_2924_ = -(_e3619[1]);
                                    } else {
                                        phi_2924_ = _e3619[1];
                                    }
                                    let _e3630 = phi_2924_;
                                    if (_e3626 > _e3630) {
                                        phi_2929_ = _e3626;
                                    } else {
                                        phi_2929_ = _e3630;
                                    }
                                    let _e3633 = phi_2929_;
                                    if (_e3619[2] < 0f) {
                                        phi_2936_ = -(_e3619[2]);
                                    } else {
                                        phi_2936_ = _e3619[2];
                                    }
                                    let _e3637 = phi_2936_;
                                    if (_e3633 > _e3637) {
                                        phi_2941_ = _e3633;
                                    } else {
                                        phi_2941_ = _e3637;
                                    }
                                    let _e3640 = phi_2941_;
                                    let _e3643 = local_12.member[1u];
                                    if (_e3643[0] < 0f) {
                                        phi_2954_ = -(_e3643[0]);
                                    } else {
                                        phi_2954_ = _e3643[0];
                                    }
                                    let _e3650 = phi_2954_;
                                    if (_e3643[1] < 0f) {
                                        phi_2961_ = -(_e3643[1]);
                                    } else {
                                        phi_2961_ = _e3643[1];
                                    }
                                    let _e3654 = phi_2961_;
                                    if (_e3650 > _e3654) {
                                        phi_2966_ = _e3650;
                                    } else {
                                        phi_2966_ = _e3654;
                                    }
                                    let _e3657 = phi_2966_;
                                    if (_e3643[2] < 0f) {
                                        phi_2973_ = -(_e3643[2]);
                                    } else {
                                        phi_2973_ = _e3643[2];
                                    }
                                    let _e3661 = phi_2973_;
                                    if (_e3657 > _e3661) {
                                        phi_2978_ = _e3657;
                                    } else {
                                        phi_2978_ = _e3661;
                                    }
                                    let _e3664 = phi_2978_;
                                    if (_e3640 > _e3664) {
                                        phi_2983_ = _e3640;
                                    } else {
                                        phi_2983_ = _e3664;
                                    }
                                    let _e3667 = phi_2983_;
                                    let _e3669 = local_12.member_3;
                                    let _e3673 = local_12.member_1[0u];
                                    if (_e3673[0] < 0f) {
                                        phi_3000_ = -(_e3673[0]);
                                    } else {
                                        phi_3000_ = _e3673[0];
                                    }
                                    let _e3680 = phi_3000_;
                                    if (_e3673[1] < 0f) {
                                        phi_3007_ = -(_e3673[1]);
                                    } else {
                                        phi_3007_ = _e3673[1];
                                    }
                                    let _e3684 = phi_3007_;
                                    if (_e3680 > _e3684) {
                                        phi_3012_ = _e3680;
                                    } else {
                                        phi_3012_ = _e3684;
                                    }
                                    let _e3687 = phi_3012_;
                                    if (_e3673[2] < 0f) {
                                        phi_3019_ = -(_e3673[2]);
                                    } else {
                                        phi_3019_ = _e3673[2];
                                    }
                                    let _e3691 = phi_3019_;
                                    if (_e3687 > _e3691) {
                                        phi_3024_ = _e3687;
                                    } else {
                                        phi_3024_ = _e3691;
                                    }
                                    let _e3694 = phi_3024_;
                                    let _e3697 = local_12.member_1[1u];
                                    if (_e3697[0] < 0f) {
                                        phi_3038_ = -(_e3697[0]);
                                    } else {
                                        phi_3038_ = _e3697[0];
                                    }
                                    let _e3704 = phi_3038_;
                                    if (_e3697[1] < 0f) {
                                        phi_3045_ = -(_e3697[1]);
                                    } else {
                                        phi_3045_ = _e3697[1];
                                    }
                                    let _e3708 = phi_3045_;
                                    if (_e3704 > _e3708) {
                                        phi_3050_ = _e3704;
                                    } else {
                                        phi_3050_ = _e3708;
                                    }
                                    let _e3711 = phi_3050_;
                                    if (_e3697[2] < 0f) {
                                        phi_3057_ = -(_e3697[2]);
                                    } else {
                                        phi_3057_ = _e3697[2];
                                    }
                                    let _e3715 = phi_3057_;
                                    if (_e3711 > _e3715) {
                                        phi_3062_ = _e3711;
                                    } else {
                                        phi_3062_ = _e3715;
                                    }
                                    let _e3718 = phi_3062_;
                                    if (_e3694 > _e3718) {
                                        phi_3067_ = _e3694;
                                    } else {
                                        phi_3067_ = _e3718;
                                    }
                                    let _e3721 = phi_3067_;
                                    let _e3723 = local_12.member_3;
                                    let _e3727 = local_12.member_2[0u];
                                    if (_e3727[0] < 0f) {
                                        phi_3084_ = -(_e3727[0]);
                                    } else {
                                        phi_3084_ = _e3727[0];
                                    }
                                    let _e3734 = phi_3084_;
                                    if (_e3727[1] < 0f) {
                                        phi_3091_ = -(_e3727[1]);
                                    } else {
                                        phi_3091_ = _e3727[1];
                                    }
                                    let _e3738 = phi_3091_;
                                    if (_e3734 > _e3738) {
                                        phi_3096_ = _e3734;
                                    } else {
                                        phi_3096_ = _e3738;
                                    }
                                    let _e3741 = phi_3096_;
                                    if (_e3727[2] < 0f) {
                                        phi_3103_ = -(_e3727[2]);
                                    } else {
                                        phi_3103_ = _e3727[2];
                                    }
                                    let _e3745 = phi_3103_;
                                    if (_e3741 > _e3745) {
                                        phi_3108_ = _e3741;
                                    } else {
                                        phi_3108_ = _e3745;
                                    }
                                    let _e3748 = phi_3108_;
                                    let _e3751 = local_12.member_2[1u];
                                    if (_e3751[0] < 0f) {
                                        phi_3122_ = -(_e3751[0]);
                                    } else {
                                        phi_3122_ = _e3751[0];
                                    }
                                    let _e3758 = phi_3122_;
                                    if (_e3751[1] < 0f) {
                                        phi_3129_ = -(_e3751[1]);
                                    } else {
                                        phi_3129_ = _e3751[1];
                                    }
                                    let _e3762 = phi_3129_;
                                    if (_e3758 > _e3762) {
                                        phi_3134_ = _e3758;
                                    } else {
                                        phi_3134_ = _e3762;
                                    }
                                    let _e3765 = phi_3134_;
                                    if (_e3751[2] < 0f) {
                                        phi_3141_ = -(_e3751[2]);
                                    } else {
                                        phi_3141_ = _e3751[2];
                                    }
                                    let _e3769 = phi_3141_;
                                    if (_e3765 > _e3769) {
                                        phi_3146_ = _e3765;
                                    } else {
                                        phi_3146_ = _e3769;
                                    }
                                    let _e3772 = phi_3146_;
                                    if (_e3748 > _e3772) {
                                        phi_3151_ = _e3748;
                                    } else {
                                        phi_3151_ = _e3772;
                                    }
                                    let _e3775 = phi_3151_;
                                    let _e3777 = local_12.member_3;
                                    let _e3784 = local_12.member_3;
                                    let _e3791 = (((_e3613 * (1f + (0.000000059604645f * 8f))) + (((((((_e3667 + _e3669) + (_e3721 + _e3723)) + (_e3775 + _e3777)) * (0.000000059604645f * 16f)) + (_e3784 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e248);
                                    if _e3791 {
                                        phi_3171_ = false;
                                    } else {
                                        phi_3171_ = true;
                                    }
                                    let _e3793 = phi_3171_;
                                    phi_3172_ = _e3793;
                                    phi_3173_ = _e3791;
                                } else {
                                    phi_3172_ = false;
                                    phi_3173_ = false;
                                }
                                let _e3795 = phi_3172_;
                                let _e3797 = phi_3173_;
                                local_42 = _e3797;
                                continue;
                                continuing {
                                    phi_2670_ = _e3468;
                                    break if !(_e3795);
                                }
                            }
                            let _e3800 = local_42;
                            if _e3800 {
                                phi_3178_ = type_32(1u, _e3444.member_1);
                                phi_3179_ = false;
                            } else {
                                phi_3178_ = type_32();
                                phi_3179_ = true;
                            }
                            let _e3803 = phi_3178_;
                            let _e3805 = phi_3179_;
                            if _e3805 {
                                phi_3184_ = type_32(2u, _e3444.member_1);
                                phi_3185_ = false;
                            } else {
                                phi_3184_ = type_32();
                                phi_3185_ = true;
                            }
                            let _e3808 = phi_3184_;
                            let _e3810 = phi_3185_;
                            phi_3187_ = _e3808;
                            phi_3188_ = _e3803;
                            phi_3189_ = _e3810;
                        } else {
                            phi_3187_ = type_32();
                            phi_3188_ = type_32(0u, type_32().member_1);
                            phi_3189_ = true;
                        }
                        let _e3812 = phi_3187_;
                        let _e3814 = phi_3188_;
                        let _e3816 = phi_3189_;
                        if _e3816 {
                            phi_3193_ = _e3814;
                        } else {
                            phi_3193_ = _e3812;
                        }
                        let _e3818 = phi_3193_;
                        phi_6010_ = _e3818;
                    } else {
                        if (_e346 < 0f) {
                            phi_3203_ = -(_e346);
                        } else {
                            phi_3203_ = _e346;
                        }
                        let _e689 = phi_3203_;
                        if (_e369 < 0f) {
                            phi_3209_ = -(_e369);
                        } else {
                            phi_3209_ = _e369;
                        }
                        let _e693 = phi_3209_;
                        if (_e689 > _e693) {
                            phi_3214_ = _e689;
                        } else {
                            phi_3214_ = _e693;
                        }
                        let _e696 = phi_3214_;
                        if (_e392 < 0f) {
                            phi_3220_ = -(_e392);
                        } else {
                            phi_3220_ = _e392;
                        }
                        let _e700 = phi_3220_;
                        if (_e403 < 0f) {
                            phi_3226_ = -(_e403);
                        } else {
                            phi_3226_ = _e403;
                        }
                        let _e704 = phi_3226_;
                        if (_e700 > _e704) {
                            phi_3231_ = _e700;
                        } else {
                            phi_3231_ = _e704;
                        }
                        let _e707 = phi_3231_;
                        if (_e696 > _e707) {
                            phi_3236_ = _e696;
                        } else {
                            phi_3236_ = _e707;
                        }
                        let _e710 = phi_3236_;
                        let _e711 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e710 >= _e711) {
                            phi_3244_ = (_e710 <= (1f / _e711));
                        } else {
                            phi_3244_ = false;
                        }
                        let _e716 = phi_3244_;
                        if _e716 {
                            phi_3249_ = (0.000000059604645f * 256f);
                        } else {
                            phi_3249_ = 2f;
                        }
                        let _e719 = phi_3249_;
                        let _e721 = ((_e653 * 0.34f) + (_e710 * _e719));
                        if _e716 {
                            phi_3256_ = (1f / _e710);
                        } else {
                            phi_3256_ = 0f;
                        }
                        let _e724 = phi_3256_;
                        let _e730 = ((_e369 - (3f * _e346)) * _e724);
                        let _e731 = ((_e392 - _e369) * _e724);
                        let _e732 = (((3f * _e403) - _e392) * _e724);
                        local_6[0u] = 0f;
                        local_6[1u] = 1f;
                        local_6[2u] = 1f;
                        local_6[3u] = 1f;
                        let _e739 = ((_e731 * _e731) - (_e730 * _e732));
                        if (_e739 > 0f) {
                            if (_e739 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e739 > 0f) {
                                    phi_3289_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_3289_ = 0f;
                                }
                                let _e793 = phi_3289_;
                                phi_3353_ = _e793;
                            } else {
                                phi_3296_ = type_17(0i, 5i);
                                phi_3299_ = bitcast<f32>(((bitcast<u32>(_e739) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e748 = phi_3296_;
                                    let _e750 = phi_3299_;
                                    local_13 = _e750;
                                    if (_e748.member < _e748.member_1) {
                                        let _e757 = (_e748.member + 1i);
                                        if ((false == (_e757 > _e748.member)) != false) {
                                            phi_3320_ = true;
                                        } else {
                                            phi_3320_ = false;
                                        }
                                        let _e762 = phi_3320_;
                                        if _e762 {
                                            phi_3326_ = type_18(0u, type_18().member_1);
                                        } else {
                                            phi_3326_ = type_18(1u, _e757);
                                        }
                                        let _e767 = phi_3326_;
                                        phi_3297_ = type_17(_e767.member_1, _e748.member_1);
                                        phi_3340_ = type_18(1u, _e748.member);
                                    } else {
                                        phi_3297_ = _e748;
                                        phi_3340_ = type_18(0u, type_18().member_1);
                                    }
                                    let _e773 = phi_3297_;
                                    let _e775 = phi_3340_;
                                    let _e778 = (bitcast<i32>(_e775.member) != 0i);
                                    if _e778 {
                                        phi_3300_ = (0.5f * (_e750 + (_e739 / _e750)));
                                    } else {
                                        phi_3300_ = f32();
                                    }
                                    let _e783 = phi_3300_;
                                    continue;
                                    continuing {
                                        phi_3296_ = _e773;
                                        phi_3299_ = _e783;
                                        break if !(_e778);
                                    }
                                }
                                let _e788 = local_13;
                                phi_3353_ = (_e788 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e795 = phi_3353_;
                            if (_e731 < 0f) {
                                phi_3359_ = -(_e795);
                            } else {
                                phi_3359_ = _e795;
                            }
                            let _e799 = phi_3359_;
                            let _e801 = -((_e731 + _e799));
                            local_7[0u] = (_e801 / (_e801 + _e732));
                            local_7[1u] = (_e730 / (_e730 + _e801));
                            let _e810 = local_7[1u];
                            let _e811 = local_7[0u];
                            if (_e810 < _e811) {
                                let _e814 = local_7[1u];
                                let _e816 = local_7[0u];
                                local_7[0u] = _e814;
                                local_7[1u] = _e816;
                            }
                            phi_3384_ = type_19(0u, 2u);
                            phi_3387_ = 1u;
                            loop {
                                let _e820 = phi_3384_;
                                let _e822 = phi_3387_;
                                local_43 = _e822;
                                if (_e820.member < _e820.member_1) {
                                    phi_3385_ = type_19((_e820.member + 1u), _e820.member_1);
                                    phi_3410_ = type_19(1u, _e820.member);
                                } else {
                                    phi_3385_ = _e820;
                                    phi_3410_ = type_19(0u, type_19().member_1);
                                }
                                let _e834 = phi_3385_;
                                let _e836 = phi_3410_;
                                let _e840 = (bitcast<i32>(_e836.member) != 0i);
                                if _e840 {
                                    let _e842 = local_7[_e836.member_1];
                                    if (_e842 > 0f) {
                                        let _e845 = local_7[_e836.member_1];
                                        if (_e845 < 1f) {
                                            let _e848 = local_7[_e836.member_1];
                                            local_6[_e822] = _e848;
                                            phi_3454_ = (_e822 + 1u);
                                        } else {
                                            phi_3454_ = _e822;
                                        }
                                        let _e852 = phi_3454_;
                                        phi_3455_ = _e852;
                                    } else {
                                        phi_3455_ = _e822;
                                    }
                                    let _e854 = phi_3455_;
                                    phi_3388_ = _e854;
                                } else {
                                    phi_3388_ = u32();
                                }
                                let _e856 = phi_3388_;
                                continue;
                                continuing {
                                    phi_3384_ = _e834;
                                    phi_3387_ = _e856;
                                    break if !(_e840);
                                }
                            }
                            let _e4027 = local_43;
                            phi_3456_ = _e4027;
                        } else {
                            phi_3456_ = 1u;
                        }
                        let _e859 = phi_3456_;
                        local_6[_e859] = 1f;
                        let _e861 = local_6;
                        local_8 = _e861;
                        phi_3476_ = type_19(0u, _e859);
                        loop {
                            let _e864 = phi_3476_;
                            if (_e864.member < _e864.member_1) {
                                phi_3477_ = type_19((_e864.member + 1u), _e864.member_1);
                                phi_3500_ = type_19(1u, _e864.member);
                            } else {
                                phi_3477_ = _e864;
                                phi_3500_ = type_19(0u, type_19().member_1);
                            }
                            let _e876 = phi_3477_;
                            let _e878 = phi_3500_;
                            if (bitcast<i32>(_e878.member) != 0i) {
                                let _e884 = local_8[_e878.member_1];
                                let _e887 = local_8[(_e878.member_1 + 1u)];
                                let _e888 = (1f - _e884);
                                let _e899 = ((((_e346 * _e888) + (_e369 * _e884)) * (_e888 * _e888)) + (((_e392 * _e888) + (_e403 * _e884)) * (_e884 * _e884)));
                                let _e900 = (1f - _e887);
                                let _e911 = ((((_e346 * _e900) + (_e369 * _e887)) * (_e900 * _e900)) + (((_e392 * _e900) + (_e403 * _e887)) * (_e887 * _e887)));
                                if (_e899 < 0f) {
                                    phi_3552_ = -(_e899);
                                } else {
                                    phi_3552_ = _e899;
                                }
                                let _e915 = phi_3552_;
                                let _e916 = (_e915 > _e721);
                                if (_e911 < 0f) {
                                    phi_3559_ = -(_e911);
                                } else {
                                    phi_3559_ = _e911;
                                }
                                let _e920 = phi_3559_;
                                let _e921 = (_e920 > _e721);
                                if _e916 {
                                    if _e921 {
                                        phi_3570_ = ((_e899 > 0f) != (_e911 > 0f));
                                        phi_3571_ = false;
                                    } else {
                                        phi_3570_ = bool();
                                        phi_3571_ = true;
                                    }
                                    let _e926 = phi_3570_;
                                    let _e928 = phi_3571_;
                                    phi_3572_ = _e926;
                                    phi_3573_ = _e928;
                                } else {
                                    phi_3572_ = bool();
                                    phi_3573_ = true;
                                }
                                let _e930 = phi_3572_;
                                let _e932 = phi_3573_;
                                if _e932 {
                                    phi_3577_ = false;
                                } else {
                                    phi_3577_ = _e930;
                                }
                                let _e934 = phi_3577_;
                                if _e916 {
                                    if _e921 {
                                        if _e934 {
                                            phi_3588_ = type_33();
                                        } else {
                                            phi_3588_ = type_33(1f, 0f, _e934);
                                        }
                                        let _e937 = phi_3588_;
                                        phi_3589_ = _e937;
                                        phi_3590_ = _e934;
                                    } else {
                                        phi_3589_ = type_33();
                                        phi_3590_ = true;
                                    }
                                    let _e939 = phi_3589_;
                                    let _e941 = phi_3590_;
                                    phi_3591_ = _e939;
                                    phi_3592_ = _e941;
                                } else {
                                    phi_3591_ = type_33();
                                    phi_3592_ = true;
                                }
                                let _e943 = phi_3591_;
                                let _e945 = phi_3592_;
                                if _e945 {
                                    if _e916 {
                                        if (_e899 < 0f) {
                                            phi_3603_ = -1f;
                                        } else {
                                            phi_3603_ = 1f;
                                        }
                                        let _e948 = phi_3603_;
                                        let _e951 = (_e392 - _e369);
                                        phi_3613_ = type_19(0u, 64u);
                                        phi_3616_ = _e887;
                                        phi_3618_ = _e884;
                                        phi_3620_ = (0.5f * (_e884 + _e887));
                                        loop {
                                            let _e957 = phi_3613_;
                                            let _e959 = phi_3616_;
                                            let _e961 = phi_3618_;
                                            let _e963 = phi_3620_;
                                            local_45 = _e961;
                                            if (_e957.member < _e957.member_1) {
                                                phi_3614_ = type_19((_e957.member + 1u), _e957.member_1);
                                                phi_3643_ = type_19(1u, _e957.member);
                                            } else {
                                                phi_3614_ = _e957;
                                                phi_3643_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e975 = phi_3614_;
                                            let _e977 = phi_3643_;
                                            if (bitcast<i32>(_e977.member) != 0i) {
                                                let _e981 = (1f - _e963);
                                                let _e994 = ((_e948 * ((((_e346 * _e981) + (_e369 * _e963)) * (_e981 * _e981)) + (((_e392 * _e981) + (_e403 * _e963)) * (_e963 * _e963)))) - _e721);
                                                if (_e994 > 0f) {
                                                    phi_3668_ = _e959;
                                                    phi_3669_ = _e963;
                                                } else {
                                                    phi_3668_ = _e963;
                                                    phi_3669_ = _e961;
                                                }
                                                let _e997 = phi_3668_;
                                                let _e999 = phi_3669_;
                                                let _e1001 = ((_e997 - _e999) > 0.00000000000022737368f);
                                                if _e1001 {
                                                    let _e1002 = (1f - _e963);
                                                    let _e1014 = (-(_e994) / (_e948 * (((((_e369 - (3f * _e346)) * _e1002) + (_e951 * _e963)) * _e1002) + (((_e951 * _e1002) + (((3f * _e403) - _e392) * _e963)) * _e963))));
                                                    if (_e994 > 0f) {
                                                        phi_3695_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_3695_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1020 = phi_3695_;
                                                    let _e1022 = ((_e963 + _e1014) + _e1020);
                                                    if (_e1022 > _e999) {
                                                        if (_e1022 < _e997) {
                                                            if (_e1014 < 0f) {
                                                                phi_3711_ = -(_e1014);
                                                            } else {
                                                                phi_3711_ = _e1014;
                                                            }
                                                            let _e1028 = phi_3711_;
                                                            if (_e1028 < (0.5f * (_e997 - _e999))) {
                                                                phi_3718_ = false;
                                                            } else {
                                                                phi_3718_ = true;
                                                            }
                                                            let _e1033 = phi_3718_;
                                                            phi_3719_ = _e1033;
                                                        } else {
                                                            phi_3719_ = true;
                                                        }
                                                        let _e1035 = phi_3719_;
                                                        phi_3720_ = _e1035;
                                                    } else {
                                                        phi_3720_ = true;
                                                    }
                                                    let _e1037 = phi_3720_;
                                                    if _e1037 {
                                                        phi_3726_ = (0.5f * (_e999 + _e997));
                                                    } else {
                                                        phi_3726_ = _e1022;
                                                    }
                                                    let _e1041 = phi_3726_;
                                                    phi_3727_ = _e1041;
                                                    phi_3728_ = false;
                                                } else {
                                                    phi_3727_ = f32();
                                                    phi_3728_ = true;
                                                }
                                                let _e1043 = phi_3727_;
                                                let _e1045 = phi_3728_;
                                                phi_3617_ = _e997;
                                                phi_3619_ = _e999;
                                                phi_3621_ = _e1043;
                                                phi_3729_ = _e999;
                                                phi_3730_ = _e1001;
                                                phi_3731_ = _e1045;
                                            } else {
                                                phi_3617_ = f32();
                                                phi_3619_ = f32();
                                                phi_3621_ = f32();
                                                phi_3729_ = f32();
                                                phi_3730_ = false;
                                                phi_3731_ = false;
                                            }
                                            let _e1047 = phi_3617_;
                                            let _e1049 = phi_3619_;
                                            let _e1051 = phi_3621_;
                                            let _e1053 = phi_3729_;
                                            let _e1055 = phi_3730_;
                                            let _e1057 = phi_3731_;
                                            local_14 = _e1057;
                                            local_44 = _e1053;
                                            continue;
                                            continuing {
                                                phi_3613_ = _e975;
                                                phi_3616_ = _e1047;
                                                phi_3618_ = _e1049;
                                                phi_3620_ = _e1051;
                                                break if !(_e1055);
                                            }
                                        }
                                        let _e1060 = local_14;
                                        if _e1060 {
                                            let _e4069 = local_44;
                                            phi_3735_ = _e4069;
                                        } else {
                                            let _e4071 = local_45;
                                            phi_3735_ = _e4071;
                                        }
                                        let _e1062 = phi_3735_;
                                        phi_3736_ = _e1062;
                                    } else {
                                        phi_3736_ = _e884;
                                    }
                                    let _e1064 = phi_3736_;
                                    if _e921 {
                                        phi_3743_ = type_19(0u, 64u);
                                        phi_3746_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1067 = phi_3743_;
                                            let _e1069 = phi_3746_;
                                            if (_e1067.member < _e1067.member_1) {
                                                phi_3744_ = type_19((_e1067.member + 1u), _e1067.member_1);
                                                phi_3769_ = type_19(1u, _e1067.member);
                                            } else {
                                                phi_3744_ = _e1067;
                                                phi_3769_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1081 = phi_3744_;
                                            let _e1083 = phi_3769_;
                                            if (bitcast<i32>(_e1083.member) != 0i) {
                                                let _e1087 = (_e1064 + _e1069);
                                                if (_e1087 < _e887) {
                                                    let _e1089 = (1f - _e1087);
                                                    let _e1100 = ((((_e346 * _e1089) + (_e369 * _e1087)) * (_e1089 * _e1089)) + (((_e392 * _e1089) + (_e403 * _e1087)) * (_e1087 * _e1087)));
                                                    let _e1101 = (1f - _e1064);
                                                    let _e1112 = ((((_e346 * _e1101) + (_e369 * _e1064)) * (_e1101 * _e1101)) + (((_e392 * _e1101) + (_e403 * _e1064)) * (_e1064 * _e1064)));
                                                    if (_e1100 < 0f) {
                                                        phi_3810_ = -(_e1100);
                                                    } else {
                                                        phi_3810_ = _e1100;
                                                    }
                                                    let _e1116 = phi_3810_;
                                                    if (_e1116 > _e721) {
                                                        if (_e1112 < 0f) {
                                                            phi_3820_ = -(_e1112);
                                                        } else {
                                                            phi_3820_ = _e1112;
                                                        }
                                                        let _e1121 = phi_3820_;
                                                        if (_e1121 > _e721) {
                                                            phi_3828_ = ((_e1100 > 0f) == (_e1112 > 0f));
                                                        } else {
                                                            phi_3828_ = false;
                                                        }
                                                        let _e1127 = phi_3828_;
                                                        phi_3830_ = !(_e1127);
                                                    } else {
                                                        phi_3830_ = false;
                                                    }
                                                    let _e1130 = phi_3830_;
                                                    if _e1130 {
                                                        phi_3835_ = f32();
                                                        phi_3836_ = false;
                                                    } else {
                                                        phi_3835_ = (_e1069 + _e1069);
                                                        phi_3836_ = true;
                                                    }
                                                    let _e1133 = phi_3835_;
                                                    let _e1135 = phi_3836_;
                                                    phi_3837_ = _e1133;
                                                    phi_3838_ = _e1135;
                                                    phi_3839_ = _e1130;
                                                    phi_3840_ = false;
                                                } else {
                                                    phi_3837_ = f32();
                                                    phi_3838_ = false;
                                                    phi_3839_ = false;
                                                    phi_3840_ = true;
                                                }
                                                let _e1137 = phi_3837_;
                                                let _e1139 = phi_3838_;
                                                let _e1141 = phi_3839_;
                                                let _e1143 = phi_3840_;
                                                phi_3841_ = _e1087;
                                                phi_3747_ = _e1137;
                                                phi_3842_ = _e1139;
                                                phi_3843_ = _e1141;
                                                phi_3844_ = _e1143;
                                                phi_3845_ = false;
                                            } else {
                                                phi_3841_ = f32();
                                                phi_3747_ = f32();
                                                phi_3842_ = false;
                                                phi_3843_ = false;
                                                phi_3844_ = false;
                                                phi_3845_ = true;
                                            }
                                            let _e1145 = phi_3841_;
                                            let _e1147 = phi_3747_;
                                            let _e1149 = phi_3842_;
                                            let _e1151 = phi_3843_;
                                            let _e1153 = phi_3844_;
                                            let _e1155 = phi_3845_;
                                            local_15 = _e1151;
                                            local_46 = _e1153;
                                            local_47 = _e1155;
                                            local_48 = _e1145;
                                            continue;
                                            continuing {
                                                phi_3743_ = _e1081;
                                                phi_3746_ = _e1147;
                                                break if !(_e1149);
                                            }
                                        }
                                        let _e1158 = local_15;
                                        if _e1158 {
                                            phi_3849_ = false;
                                            phi_3850_ = false;
                                        } else {
                                            let _e4096 = local_46;
                                            phi_3849_ = _e4096;
                                            let _e4099 = local_47;
                                            phi_3850_ = _e4099;
                                        }
                                        let _e1160 = phi_3849_;
                                        let _e1162 = phi_3850_;
                                        if _e1160 {
                                            phi_3854_ = true;
                                        } else {
                                            phi_3854_ = _e1162;
                                        }
                                        let _e1164 = phi_3854_;
                                        if _e1164 {
                                            phi_3858_ = _e887;
                                        } else {
                                            let _e4103 = local_48;
                                            phi_3858_ = _e4103;
                                        }
                                        let _e1166 = phi_3858_;
                                        phi_3859_ = _e1166;
                                    } else {
                                        phi_3859_ = _e887;
                                    }
                                    let _e1168 = phi_3859_;
                                    phi_3861_ = type_33(_e1064, _e1168, _e934);
                                } else {
                                    phi_3861_ = _e943;
                                }
                                let _e1171 = phi_3861_;
                                if (_e1171.member > _e1171.member_1) {
                                    phi_5966_ = f32();
                                    phi_5967_ = true;
                                    phi_5968_ = false;
                                    phi_5969_ = false;
                                    phi_5970_ = false;
                                } else {
                                    let _e1178 = ((_e1171.member_1 - _e1171.member) * 0.5f);
                                    let _e1179 = (_e1171.member + _e1178);
                                    let _e1181 = (_e1178 + (0.000000059604645f * 4f));
                                    let _e1183 = local_12.member_3;
                                    let _e1186 = local_12.member[0u];
                                    if (_e1186[0] < 0f) {
                                        phi_3890_ = -(_e1186[0]);
                                    } else {
                                        phi_3890_ = _e1186[0];
                                    }
                                    let _e1193 = phi_3890_;
                                    if (_e1186[1] < 0f) {
                                        phi_3897_ = -(_e1186[1]);
                                    } else {
                                        phi_3897_ = _e1186[1];
                                    }
                                    let _e1197 = phi_3897_;
                                    if (_e1193 > _e1197) {
                                        phi_3902_ = _e1193;
                                    } else {
                                        phi_3902_ = _e1197;
                                    }
                                    let _e1200 = phi_3902_;
                                    if (_e1186[2] < 0f) {
                                        phi_3909_ = -(_e1186[2]);
                                    } else {
                                        phi_3909_ = _e1186[2];
                                    }
                                    let _e1204 = phi_3909_;
                                    if (_e1200 > _e1204) {
                                        phi_3914_ = _e1200;
                                    } else {
                                        phi_3914_ = _e1204;
                                    }
                                    let _e1207 = phi_3914_;
                                    let _e1209 = local_12.member[1u];
                                    if (_e1209[0] < 0f) {
                                        phi_3927_ = -(_e1209[0]);
                                    } else {
                                        phi_3927_ = _e1209[0];
                                    }
                                    let _e1216 = phi_3927_;
                                    if (_e1209[1] < 0f) {
                                        phi_3934_ = -(_e1209[1]);
                                    } else {
                                        phi_3934_ = _e1209[1];
                                    }
                                    let _e1220 = phi_3934_;
                                    if (_e1216 > _e1220) {
                                        phi_3939_ = _e1216;
                                    } else {
                                        phi_3939_ = _e1220;
                                    }
                                    let _e1223 = phi_3939_;
                                    if (_e1209[2] < 0f) {
                                        phi_3946_ = -(_e1209[2]);
                                    } else {
                                        phi_3946_ = _e1209[2];
                                    }
                                    let _e1227 = phi_3946_;
                                    if (_e1223 > _e1227) {
                                        phi_3951_ = _e1223;
                                    } else {
                                        phi_3951_ = _e1227;
                                    }
                                    let _e1230 = phi_3951_;
                                    if (_e1207 > _e1230) {
                                        phi_3956_ = _e1207;
                                    } else {
                                        phi_3956_ = _e1230;
                                    }
                                    let _e1233 = phi_3956_;
                                    let _e1236 = local_12.member[0u];
                                    let _e1241 = local_12.member[1u];
                                    let _e1251 = (_e1236[0] + ((_e1241[0] - _e1236[0]) * _e1179));
                                    let _e1252 = (_e1236[1] + ((_e1241[1] - _e1236[1]) * _e1179));
                                    let _e1253 = (_e1236[2] + ((_e1241[2] - _e1236[2]) * _e1179));
                                    let _e1255 = local_12.member[1u];
                                    let _e1260 = local_12.member[0u];
                                    let _e1264 = (_e1255[0] - _e1260[0]);
                                    let _e1265 = (_e1255[1] - _e1260[1]);
                                    let _e1266 = (_e1255[2] - _e1260[2]);
                                    if (_e1264 < 0f) {
                                        phi_4015_ = -(_e1264);
                                    } else {
                                        phi_4015_ = _e1264;
                                    }
                                    let _e1270 = phi_4015_;
                                    if (_e1265 < 0f) {
                                        phi_4021_ = -(_e1265);
                                    } else {
                                        phi_4021_ = _e1265;
                                    }
                                    let _e1274 = phi_4021_;
                                    if (_e1270 > _e1274) {
                                        phi_4026_ = _e1270;
                                    } else {
                                        phi_4026_ = _e1274;
                                    }
                                    let _e1277 = phi_4026_;
                                    if (_e1266 < 0f) {
                                        phi_4032_ = -(_e1266);
                                    } else {
                                        phi_4032_ = _e1266;
                                    }
                                    let _e1281 = phi_4032_;
                                    if (_e1277 > _e1281) {
                                        phi_4037_ = _e1277;
                                    } else {
                                        phi_4037_ = _e1281;
                                    }
                                    let _e1284 = phi_4037_;
                                    let _e1290 = ((((_e1181 * _e1284) * 1.01f) + ((_e1233 + _e1183) * (0.000000059604645f * 8f))) + _e1183);
                                    if (_e1251 < 0f) {
                                        phi_4049_ = -(_e1251);
                                    } else {
                                        phi_4049_ = _e1251;
                                    }
                                    let _e1294 = phi_4049_;
                                    if (_e1252 < 0f) {
                                        phi_4055_ = -(_e1252);
                                    } else {
                                        phi_4055_ = _e1252;
                                    }
                                    let _e1298 = phi_4055_;
                                    if (_e1294 > _e1298) {
                                        phi_4060_ = _e1294;
                                    } else {
                                        phi_4060_ = _e1298;
                                    }
                                    let _e1301 = phi_4060_;
                                    if (_e1253 < 0f) {
                                        phi_4066_ = -(_e1253);
                                    } else {
                                        phi_4066_ = _e1253;
                                    }
                                    let _e1305 = phi_4066_;
                                    if (_e1301 > _e1305) {
                                        phi_4071_ = _e1301;
                                    } else {
                                        phi_4071_ = _e1305;
                                    }
                                    let _e1308 = phi_4071_;
                                    local_2 = type_24(array<f32, 3>(_e1251, _e1252, _e1253), _e1290, (_e1308 + _e1290));
                                    let _e1314 = local_12.member_3;
                                    let _e1316 = local_12.member_1[0u];
                                    if (_e1316[0] < 0f) {
                                        phi_4097_ = -(_e1316[0]);
                                    } else {
                                        phi_4097_ = _e1316[0];
                                    }
                                    let _e1323 = phi_4097_;
                                    if (_e1316[1] < 0f) {
                                        phi_4104_ = -(_e1316[1]);
                                    } else {
                                        phi_4104_ = _e1316[1];
                                    }
                                    let _e1327 = phi_4104_;
                                    if (_e1323 > _e1327) {
                                        phi_4109_ = _e1323;
                                    } else {
                                        phi_4109_ = _e1327;
                                    }
                                    let _e1330 = phi_4109_;
                                    if (_e1316[2] < 0f) {
                                        phi_4116_ = -(_e1316[2]);
                                    } else {
                                        phi_4116_ = _e1316[2];
                                    }
                                    let _e1334 = phi_4116_;
                                    if (_e1330 > _e1334) {
                                        phi_4121_ = _e1330;
                                    } else {
                                        phi_4121_ = _e1334;
                                    }
                                    let _e1337 = phi_4121_;
                                    let _e1339 = local_12.member_1[1u];
                                    if (_e1339[0] < 0f) {
                                        phi_4134_ = -(_e1339[0]);
                                    } else {
                                        phi_4134_ = _e1339[0];
                                    }
                                    let _e1346 = phi_4134_;
                                    if (_e1339[1] < 0f) {
                                        phi_4141_ = -(_e1339[1]);
                                    } else {
                                        phi_4141_ = _e1339[1];
                                    }
                                    let _e1350 = phi_4141_;
                                    if (_e1346 > _e1350) {
                                        phi_4146_ = _e1346;
                                    } else {
                                        phi_4146_ = _e1350;
                                    }
                                    let _e1353 = phi_4146_;
                                    if (_e1339[2] < 0f) {
                                        phi_4153_ = -(_e1339[2]);
                                    } else {
                                        phi_4153_ = _e1339[2];
                                    }
                                    let _e1357 = phi_4153_;
                                    if (_e1353 > _e1357) {
                                        phi_4158_ = _e1353;
                                    } else {
                                        phi_4158_ = _e1357;
                                    }
                                    let _e1360 = phi_4158_;
                                    if (_e1337 > _e1360) {
                                        phi_4163_ = _e1337;
                                    } else {
                                        phi_4163_ = _e1360;
                                    }
                                    let _e1363 = phi_4163_;
                                    let _e1366 = local_12.member_1[0u];
                                    let _e1371 = local_12.member_1[1u];
                                    let _e1381 = (_e1366[0] + ((_e1371[0] - _e1366[0]) * _e1179));
                                    let _e1382 = (_e1366[1] + ((_e1371[1] - _e1366[1]) * _e1179));
                                    let _e1383 = (_e1366[2] + ((_e1371[2] - _e1366[2]) * _e1179));
                                    let _e1385 = local_12.member_1[1u];
                                    let _e1390 = local_12.member_1[0u];
                                    let _e1394 = (_e1385[0] - _e1390[0]);
                                    let _e1395 = (_e1385[1] - _e1390[1]);
                                    let _e1396 = (_e1385[2] - _e1390[2]);
                                    if (_e1394 < 0f) {
                                        phi_4222_ = -(_e1394);
                                    } else {
                                        phi_4222_ = _e1394;
                                    }
                                    let _e1400 = phi_4222_;
                                    if (_e1395 < 0f) {
                                        phi_4228_ = -(_e1395);
                                    } else {
                                        phi_4228_ = _e1395;
                                    }
                                    let _e1404 = phi_4228_;
                                    if (_e1400 > _e1404) {
                                        phi_4233_ = _e1400;
                                    } else {
                                        phi_4233_ = _e1404;
                                    }
                                    let _e1407 = phi_4233_;
                                    if (_e1396 < 0f) {
                                        phi_4239_ = -(_e1396);
                                    } else {
                                        phi_4239_ = _e1396;
                                    }
                                    let _e1411 = phi_4239_;
                                    if (_e1407 > _e1411) {
                                        phi_4244_ = _e1407;
                                    } else {
                                        phi_4244_ = _e1411;
                                    }
                                    let _e1414 = phi_4244_;
                                    let _e1420 = ((((_e1181 * _e1414) * 1.01f) + ((_e1363 + _e1314) * (0.000000059604645f * 8f))) + _e1314);
                                    if (_e1381 < 0f) {
                                        phi_4256_ = -(_e1381);
                                    } else {
                                        phi_4256_ = _e1381;
                                    }
                                    let _e1424 = phi_4256_;
                                    if (_e1382 < 0f) {
                                        phi_4262_ = -(_e1382);
                                    } else {
                                        phi_4262_ = _e1382;
                                    }
                                    let _e1428 = phi_4262_;
                                    if (_e1424 > _e1428) {
                                        phi_4267_ = _e1424;
                                    } else {
                                        phi_4267_ = _e1428;
                                    }
                                    let _e1431 = phi_4267_;
                                    if (_e1383 < 0f) {
                                        phi_4273_ = -(_e1383);
                                    } else {
                                        phi_4273_ = _e1383;
                                    }
                                    let _e1435 = phi_4273_;
                                    if (_e1431 > _e1435) {
                                        phi_4278_ = _e1431;
                                    } else {
                                        phi_4278_ = _e1435;
                                    }
                                    let _e1438 = phi_4278_;
                                    local_3 = type_24(array<f32, 3>(_e1381, _e1382, _e1383), _e1420, (_e1438 + _e1420));
                                    let _e1444 = local_12.member_3;
                                    let _e1446 = local_12.member_2[0u];
                                    if (_e1446[0] < 0f) {
                                        phi_4304_ = -(_e1446[0]);
                                    } else {
                                        phi_4304_ = _e1446[0];
                                    }
                                    let _e1453 = phi_4304_;
                                    if (_e1446[1] < 0f) {
                                        phi_4311_ = -(_e1446[1]);
                                    } else {
                                        phi_4311_ = _e1446[1];
                                    }
                                    let _e1457 = phi_4311_;
                                    if (_e1453 > _e1457) {
                                        phi_4316_ = _e1453;
                                    } else {
                                        phi_4316_ = _e1457;
                                    }
                                    let _e1460 = phi_4316_;
                                    if (_e1446[2] < 0f) {
                                        phi_4323_ = -(_e1446[2]);
                                    } else {
                                        phi_4323_ = _e1446[2];
                                    }
                                    let _e1464 = phi_4323_;
                                    if (_e1460 > _e1464) {
                                        phi_4328_ = _e1460;
                                    } else {
                                        phi_4328_ = _e1464;
                                    }
                                    let _e1467 = phi_4328_;
                                    let _e1469 = local_12.member_2[1u];
                                    if (_e1469[0] < 0f) {
                                        phi_4341_ = -(_e1469[0]);
                                    } else {
                                        phi_4341_ = _e1469[0];
                                    }
                                    let _e1476 = phi_4341_;
                                    if (_e1469[1] < 0f) {
                                        phi_4348_ = -(_e1469[1]);
                                    } else {
                                        phi_4348_ = _e1469[1];
                                    }
                                    let _e1480 = phi_4348_;
                                    if (_e1476 > _e1480) {
                                        phi_4353_ = _e1476;
                                    } else {
                                        phi_4353_ = _e1480;
                                    }
                                    let _e1483 = phi_4353_;
                                    if (_e1469[2] < 0f) {
                                        phi_4360_ = -(_e1469[2]);
                                    } else {
                                        phi_4360_ = _e1469[2];
                                    }
                                    let _e1487 = phi_4360_;
                                    if (_e1483 > _e1487) {
                                        phi_4365_ = _e1483;
                                    } else {
                                        phi_4365_ = _e1487;
                                    }
                                    let _e1490 = phi_4365_;
                                    if (_e1467 > _e1490) {
                                        phi_4370_ = _e1467;
                                    } else {
                                        phi_4370_ = _e1490;
                                    }
                                    let _e1493 = phi_4370_;
                                    let _e1496 = local_12.member_2[0u];
                                    let _e1501 = local_12.member_2[1u];
                                    let _e1511 = (_e1496[0] + ((_e1501[0] - _e1496[0]) * _e1179));
                                    let _e1512 = (_e1496[1] + ((_e1501[1] - _e1496[1]) * _e1179));
                                    let _e1513 = (_e1496[2] + ((_e1501[2] - _e1496[2]) * _e1179));
                                    let _e1515 = local_12.member_2[1u];
                                    let _e1520 = local_12.member_2[0u];
                                    let _e1524 = (_e1515[0] - _e1520[0]);
                                    let _e1525 = (_e1515[1] - _e1520[1]);
                                    let _e1526 = (_e1515[2] - _e1520[2]);
                                    if (_e1524 < 0f) {
                                        phi_4429_ = -(_e1524);
                                    } else {
                                        phi_4429_ = _e1524;
                                    }
                                    let _e1530 = phi_4429_;
                                    if (_e1525 < 0f) {
                                        phi_4435_ = -(_e1525);
                                    } else {
                                        phi_4435_ = _e1525;
                                    }
                                    let _e1534 = phi_4435_;
                                    if (_e1530 > _e1534) {
                                        phi_4440_ = _e1530;
                                    } else {
                                        phi_4440_ = _e1534;
                                    }
                                    let _e1537 = phi_4440_;
                                    if (_e1526 < 0f) {
                                        phi_4446_ = -(_e1526);
                                    } else {
                                        phi_4446_ = _e1526;
                                    }
                                    let _e1541 = phi_4446_;
                                    if (_e1537 > _e1541) {
                                        phi_4451_ = _e1537;
                                    } else {
                                        phi_4451_ = _e1541;
                                    }
                                    let _e1544 = phi_4451_;
                                    let _e1550 = ((((_e1181 * _e1544) * 1.01f) + ((_e1493 + _e1444) * (0.000000059604645f * 8f))) + _e1444);
                                    if (_e1511 < 0f) {
                                        phi_4463_ = -(_e1511);
                                    } else {
                                        phi_4463_ = _e1511;
                                    }
                                    let _e1554 = phi_4463_;
                                    if (_e1512 < 0f) {
                                        phi_4469_ = -(_e1512);
                                    } else {
                                        phi_4469_ = _e1512;
                                    }
                                    let _e1558 = phi_4469_;
                                    if (_e1554 > _e1558) {
                                        phi_4474_ = _e1554;
                                    } else {
                                        phi_4474_ = _e1558;
                                    }
                                    let _e1561 = phi_4474_;
                                    if (_e1513 < 0f) {
                                        phi_4480_ = -(_e1513);
                                    } else {
                                        phi_4480_ = _e1513;
                                    }
                                    let _e1565 = phi_4480_;
                                    if (_e1561 > _e1565) {
                                        phi_4485_ = _e1561;
                                    } else {
                                        phi_4485_ = _e1565;
                                    }
                                    let _e1568 = phi_4485_;
                                    local_4 = type_24(array<f32, 3>(_e1511, _e1512, _e1513), _e1550, (_e1568 + _e1550));
                                    let _e1573 = local_3.member;
                                    let _e1578 = local_4.member;
                                    let _e1584 = ((_e1573[1] * _e1578[2]) - (_e1573[2] * _e1578[1]));
                                    let _e1587 = ((_e1573[2] * _e1578[0]) - (_e1573[0] * _e1578[2]));
                                    let _e1590 = ((_e1573[0] * _e1578[1]) - (_e1573[1] * _e1578[0]));
                                    if (_e1584 < 0f) {
                                        phi_4534_ = -(_e1584);
                                    } else {
                                        phi_4534_ = _e1584;
                                    }
                                    let _e1594 = phi_4534_;
                                    if (_e1587 < 0f) {
                                        phi_4540_ = -(_e1587);
                                    } else {
                                        phi_4540_ = _e1587;
                                    }
                                    let _e1598 = phi_4540_;
                                    if (_e1594 > _e1598) {
                                        if (_e1584 < 0f) {
                                            phi_4550_ = -(_e1584);
                                        } else {
                                            phi_4550_ = _e1584;
                                        }
                                        let _e1616 = phi_4550_;
                                        if (_e1590 < 0f) {
                                            phi_4556_ = -(_e1590);
                                        } else {
                                            phi_4556_ = _e1590;
                                        }
                                        let _e1620 = phi_4556_;
                                        if (_e1616 > _e1620) {
                                            phi_4561_ = 2u;
                                            phi_4562_ = 1u;
                                        } else {
                                            phi_4561_ = 1u;
                                            phi_4562_ = 0u;
                                        }
                                        let _e1623 = phi_4561_;
                                        let _e1625 = phi_4562_;
                                        phi_4581_ = _e1623;
                                        phi_4582_ = _e1625;
                                    } else {
                                        if (_e1587 < 0f) {
                                            phi_4568_ = -(_e1587);
                                        } else {
                                            phi_4568_ = _e1587;
                                        }
                                        let _e1603 = phi_4568_;
                                        if (_e1590 < 0f) {
                                            phi_4574_ = -(_e1590);
                                        } else {
                                            phi_4574_ = _e1590;
                                        }
                                        let _e1607 = phi_4574_;
                                        if (_e1603 > _e1607) {
                                            phi_4579_ = 0u;
                                            phi_4580_ = 2u;
                                        } else {
                                            phi_4579_ = 1u;
                                            phi_4580_ = 0u;
                                        }
                                        let _e1610 = phi_4579_;
                                        let _e1612 = phi_4580_;
                                        phi_4581_ = _e1610;
                                        phi_4582_ = _e1612;
                                    }
                                    let _e1627 = phi_4581_;
                                    let _e1629 = phi_4582_;
                                    let _e1632 = local_3.member[_e1629];
                                    let _e1635 = local_4.member[_e1627];
                                    let _e1639 = local_3.member[_e1627];
                                    let _e1642 = local_4.member[_e1629];
                                    let _e1644 = ((_e1632 * _e1635) - (_e1639 * _e1642));
                                    let _e1646 = local_3.member_1;
                                    let _e1648 = local_4.member_2;
                                    let _e1651 = local_3.member_2;
                                    let _e1653 = local_4.member_1;
                                    let _e1658 = local_3.member_2;
                                    let _e1660 = local_4.member_2;
                                    let _e1667 = local_3.member_2;
                                    let _e1670 = local_4.member_2;
                                    let _e1674 = (((((_e1646 * _e1648) + (_e1651 * _e1653)) * 2.01f) + ((_e1658 * _e1660) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1667) * (1f + _e1670))));
                                    if (_e1644 < 0f) {
                                        phi_4649_ = -(_e1644);
                                    } else {
                                        phi_4649_ = _e1644;
                                    }
                                    let _e1678 = phi_4649_;
                                    if (_e1678 > _e1674) {
                                        if (_e1644 < 0f) {
                                            phi_4658_ = -1f;
                                        } else {
                                            phi_4658_ = 1f;
                                        }
                                        let _e1682 = phi_4658_;
                                        let _e1685 = local_2.member[_e1629];
                                        let _e1688 = local_4.member[_e1627];
                                        let _e1692 = local_2.member[_e1627];
                                        let _e1695 = local_4.member[_e1629];
                                        let _e1699 = local_2.member_1;
                                        let _e1701 = local_4.member_2;
                                        let _e1704 = local_2.member_2;
                                        let _e1706 = local_4.member_1;
                                        let _e1711 = local_2.member_2;
                                        let _e1713 = local_4.member_2;
                                        let _e1720 = local_2.member_2;
                                        let _e1723 = local_4.member_2;
                                        let _e1727 = (((((_e1699 * _e1701) + (_e1704 * _e1706)) * 2.01f) + ((_e1711 * _e1713) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1720) * (1f + _e1723))));
                                        let _e1730 = local_3.member[_e1629];
                                        let _e1733 = local_2.member[_e1627];
                                        let _e1737 = local_3.member[_e1627];
                                        let _e1740 = local_2.member[_e1629];
                                        let _e1744 = local_3.member_1;
                                        let _e1746 = local_2.member_2;
                                        let _e1749 = local_3.member_2;
                                        let _e1751 = local_2.member_1;
                                        let _e1756 = local_3.member_2;
                                        let _e1758 = local_2.member_2;
                                        let _e1765 = local_3.member_2;
                                        let _e1768 = local_2.member_2;
                                        let _e1772 = (((((_e1744 * _e1746) + (_e1749 * _e1751)) * 2.01f) + ((_e1756 * _e1758) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1765) * (1f + _e1768))));
                                        let _e1773 = (_e1644 * _e1682);
                                        let _e1774 = (((_e1685 * _e1688) - (_e1692 * _e1695)) * _e1682);
                                        let _e1775 = (((_e1730 * _e1733) - (_e1737 * _e1740)) * _e1682);
                                        if (_e1773 < 0f) {
                                            phi_4789_ = -(_e1773);
                                        } else {
                                            phi_4789_ = _e1773;
                                        }
                                        let _e1779 = phi_4789_;
                                        if (_e1774 < 0f) {
                                            phi_4795_ = -(_e1774);
                                        } else {
                                            phi_4795_ = _e1774;
                                        }
                                        let _e1783 = phi_4795_;
                                        if (_e1775 < 0f) {
                                            phi_4802_ = -(_e1775);
                                        } else {
                                            phi_4802_ = _e1775;
                                        }
                                        let _e1788 = phi_4802_;
                                        let _e1793 = ((_e1773 - _e1774) - _e1775);
                                        let _e1796 = (((_e1674 + _e1727) + _e1772) + (((_e1779 + _e1783) + _e1788) * (0.000000059604645f * 4f)));
                                        local_5[0u].member = _e1774;
                                        local_5[0u].member_1 = _e1727;
                                        local_5[1u].member = _e1775;
                                        local_5[1u].member_1 = _e1772;
                                        local_5[2u].member = _e1793;
                                        local_5[2u].member_1 = _e1796;
                                        local_5[3u].member = _e1793;
                                        local_5[3u].member_1 = _e1796;
                                        phi_4845_ = type_19(0u, 4u);
                                        phi_4848_ = true;
                                        loop {
                                            let _e1811 = phi_4845_;
                                            let _e1813 = phi_4848_;
                                            local_17 = _e1813;
                                            if (_e1811.member < _e1811.member_1) {
                                                phi_4846_ = type_19((_e1811.member + 1u), _e1811.member_1);
                                                phi_4871_ = type_19(1u, _e1811.member);
                                            } else {
                                                phi_4846_ = _e1811;
                                                phi_4871_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1825 = phi_4846_;
                                            let _e1827 = phi_4871_;
                                            if (bitcast<i32>(_e1827.member) != 0i) {
                                                let _e1834 = local_5[_e1827.member_1].member;
                                                let _e1837 = local_5[_e1827.member_1].member_1;
                                                let _e1839 = (_e1834 < -(_e1837));
                                                if _e1839 {
                                                    phi_4898_ = bool();
                                                    phi_4899_ = false;
                                                } else {
                                                    phi_4898_ = (_e1813 && (_e1834 > _e1837));
                                                    phi_4899_ = true;
                                                }
                                                let _e1843 = phi_4898_;
                                                let _e1845 = phi_4899_;
                                                phi_4849_ = _e1843;
                                                phi_4900_ = _e1845;
                                                phi_4901_ = _e1839;
                                            } else {
                                                phi_4849_ = bool();
                                                phi_4900_ = false;
                                                phi_4901_ = false;
                                            }
                                            let _e1847 = phi_4849_;
                                            let _e1849 = phi_4900_;
                                            let _e1851 = phi_4901_;
                                            local_16 = _e1851;
                                            continue;
                                            continuing {
                                                phi_4845_ = _e1825;
                                                phi_4848_ = _e1847;
                                                break if !(_e1849);
                                            }
                                        }
                                        let _e1854 = local_16;
                                        if _e1854 {
                                            phi_4905_ = false;
                                        } else {
                                            phi_4905_ = true;
                                        }
                                        let _e1856 = phi_4905_;
                                        if _e1856 {
                                            let _e1858 = local_17;
                                            if _e1858 {
                                                phi_4912_ = 1u;
                                            } else {
                                                phi_4912_ = 2u;
                                            }
                                            let _e1860 = phi_4912_;
                                            phi_4913_ = _e1860;
                                            phi_4914_ = false;
                                        } else {
                                            phi_4913_ = u32();
                                            phi_4914_ = true;
                                        }
                                        let _e1862 = phi_4913_;
                                        let _e1864 = phi_4914_;
                                        phi_4915_ = _e1862;
                                        phi_4916_ = 0u;
                                        phi_4917_ = _e1864;
                                    } else {
                                        phi_4915_ = u32();
                                        phi_4916_ = 2u;
                                        phi_4917_ = true;
                                    }
                                    let _e1866 = phi_4915_;
                                    let _e1868 = phi_4916_;
                                    let _e1870 = phi_4917_;
                                    if _e1870 {
                                        phi_4921_ = _e1868;
                                    } else {
                                        phi_4921_ = _e1866;
                                    }
                                    let _e1872 = phi_4921_;
                                    let _e1873 = (_e1872 == 0u);
                                    if _e1873 {
                                        phi_5962_ = f32();
                                        phi_5963_ = false;
                                        phi_5964_ = false;
                                        phi_5965_ = false;
                                    } else {
                                        if (_e1872 == 1u) {
                                            if _e1171.member_2 {
                                                if ((_e1171.member_1 - _e1171.member) <= 0.0000005f) {
                                                    phi_4941_ = false;
                                                } else {
                                                    phi_4941_ = true;
                                                }
                                                let _e1881 = phi_4941_;
                                                phi_4942_ = _e1881;
                                            } else {
                                                phi_4942_ = true;
                                            }
                                            let _e1883 = phi_4942_;
                                            phi_4943_ = _e1883;
                                        } else {
                                            phi_4943_ = true;
                                        }
                                        let _e1885 = phi_4943_;
                                        if _e1885 {
                                            let _e1890 = local_12.member[0u];
                                            let _e1896 = local_12.member_1[0u];
                                            let _e1902 = local_12.member_2[0u];
                                            local = array<array<f32, 3>, 4>(_e1890, array<f32, 3>((_e1890[0] - _e1896[0]), (_e1890[1] - _e1896[1]), (_e1890[2] - _e1896[2])), array<f32, 3>((_e1890[0] - _e1902[0]), (_e1890[1] - _e1902[1]), (_e1890[2] - _e1902[2])), _e1890);
                                            let _e1917 = local_12.member[1u];
                                            let _e1923 = local_12.member_1[1u];
                                            let _e1929 = local_12.member_2[1u];
                                            local_1 = array<array<f32, 3>, 4>(_e1917, array<f32, 3>((_e1917[0] - _e1923[0]), (_e1917[1] - _e1923[1]), (_e1917[2] - _e1923[2])), array<f32, 3>((_e1917[0] - _e1929[0]), (_e1917[1] - _e1929[1]), (_e1917[2] - _e1929[2])), _e1917);
                                            let _e1944 = local_12.member[0u];
                                            if (_e1944[0] < 0f) {
                                                phi_5139_ = -(_e1944[0]);
                                            } else {
                                                phi_5139_ = _e1944[0];
                                            }
                                            let _e1951 = phi_5139_;
                                            if (_e1944[1] < 0f) {
                                                phi_5146_ = -(_e1944[1]);
                                            } else {
                                                phi_5146_ = _e1944[1];
                                            }
                                            let _e1955 = phi_5146_;
                                            if (_e1951 > _e1955) {
                                                phi_5151_ = _e1951;
                                            } else {
                                                phi_5151_ = _e1955;
                                            }
                                            let _e1958 = phi_5151_;
                                            if (_e1944[2] < 0f) {
                                                phi_5158_ = -(_e1944[2]);
                                            } else {
                                                phi_5158_ = _e1944[2];
                                            }
                                            let _e1962 = phi_5158_;
                                            if (_e1958 > _e1962) {
                                                phi_5163_ = _e1958;
                                            } else {
                                                phi_5163_ = _e1962;
                                            }
                                            let _e1965 = phi_5163_;
                                            let _e1968 = local_12.member[1u];
                                            if (_e1968[0] < 0f) {
                                                phi_5176_ = -(_e1968[0]);
                                            } else {
                                                phi_5176_ = _e1968[0];
                                            }
                                            let _e1975 = phi_5176_;
                                            if (_e1968[1] < 0f) {
                                                phi_5183_ = -(_e1968[1]);
                                            } else {
                                                phi_5183_ = _e1968[1];
                                            }
                                            let _e1979 = phi_5183_;
                                            if (_e1975 > _e1979) {
                                                phi_5188_ = _e1975;
                                            } else {
                                                phi_5188_ = _e1979;
                                            }
                                            let _e1982 = phi_5188_;
                                            if (_e1968[2] < 0f) {
                                                phi_5195_ = -(_e1968[2]);
                                            } else {
                                                phi_5195_ = _e1968[2];
                                            }
                                            let _e1986 = phi_5195_;
                                            if (_e1982 > _e1986) {
                                                phi_5200_ = _e1982;
                                            } else {
                                                phi_5200_ = _e1986;
                                            }
                                            let _e1989 = phi_5200_;
                                            if (_e1965 > _e1989) {
                                                phi_5205_ = _e1965;
                                            } else {
                                                phi_5205_ = _e1989;
                                            }
                                            let _e1992 = phi_5205_;
                                            let _e1994 = local_12.member_3;
                                            let _e1998 = local_12.member_1[0u];
                                            if (_e1998[0] < 0f) {
                                                phi_5222_ = -(_e1998[0]);
                                            } else {
                                                phi_5222_ = _e1998[0];
                                            }
                                            let _e2005 = phi_5222_;
                                            if (_e1998[1] < 0f) {
                                                phi_5229_ = -(_e1998[1]);
                                            } else {
                                                phi_5229_ = _e1998[1];
                                            }
                                            let _e2009 = phi_5229_;
                                            if (_e2005 > _e2009) {
                                                phi_5234_ = _e2005;
                                            } else {
                                                phi_5234_ = _e2009;
                                            }
                                            let _e2012 = phi_5234_;
                                            if (_e1998[2] < 0f) {
                                                phi_5241_ = -(_e1998[2]);
                                            } else {
                                                phi_5241_ = _e1998[2];
                                            }
                                            let _e2016 = phi_5241_;
                                            if (_e2012 > _e2016) {
                                                phi_5246_ = _e2012;
                                            } else {
                                                phi_5246_ = _e2016;
                                            }
                                            let _e2019 = phi_5246_;
                                            let _e2022 = local_12.member_1[1u];
                                            if (_e2022[0] < 0f) {
                                                phi_5260_ = -(_e2022[0]);
                                            } else {
                                                phi_5260_ = _e2022[0];
                                            }
                                            let _e2029 = phi_5260_;
                                            if (_e2022[1] < 0f) {
                                                phi_5267_ = -(_e2022[1]);
                                            } else {
                                                phi_5267_ = _e2022[1];
                                            }
                                            let _e2033 = phi_5267_;
                                            if (_e2029 > _e2033) {
                                                phi_5272_ = _e2029;
                                            } else {
                                                phi_5272_ = _e2033;
                                            }
                                            let _e2036 = phi_5272_;
                                            if (_e2022[2] < 0f) {
                                                phi_5279_ = -(_e2022[2]);
                                            } else {
                                                phi_5279_ = _e2022[2];
                                            }
                                            let _e2040 = phi_5279_;
                                            if (_e2036 > _e2040) {
                                                phi_5284_ = _e2036;
                                            } else {
                                                phi_5284_ = _e2040;
                                            }
                                            let _e2043 = phi_5284_;
                                            if (_e2019 > _e2043) {
                                                phi_5289_ = _e2019;
                                            } else {
                                                phi_5289_ = _e2043;
                                            }
                                            let _e2046 = phi_5289_;
                                            let _e2048 = local_12.member_3;
                                            let _e2052 = local_12.member_2[0u];
                                            if (_e2052[0] < 0f) {
                                                phi_5306_ = -(_e2052[0]);
                                            } else {
                                                phi_5306_ = _e2052[0];
                                            }
                                            let _e2059 = phi_5306_;
                                            if (_e2052[1] < 0f) {
                                                phi_5313_ = -(_e2052[1]);
                                            } else {
                                                phi_5313_ = _e2052[1];
                                            }
                                            let _e2063 = phi_5313_;
                                            if (_e2059 > _e2063) {
                                                phi_5318_ = _e2059;
                                            } else {
                                                phi_5318_ = _e2063;
                                            }
                                            let _e2066 = phi_5318_;
                                            if (_e2052[2] < 0f) {
                                                phi_5325_ = -(_e2052[2]);
                                            } else {
                                                phi_5325_ = _e2052[2];
                                            }
                                            let _e2070 = phi_5325_;
                                            if (_e2066 > _e2070) {
                                                phi_5330_ = _e2066;
                                            } else {
                                                phi_5330_ = _e2070;
                                            }
                                            let _e2073 = phi_5330_;
                                            let _e2076 = local_12.member_2[1u];
                                            if (_e2076[0] < 0f) {
                                                phi_5344_ = -(_e2076[0]);
                                            } else {
                                                phi_5344_ = _e2076[0];
                                            }
                                            let _e2083 = phi_5344_;
                                            if (_e2076[1] < 0f) {
                                                phi_5351_ = -(_e2076[1]);
                                            } else {
                                                phi_5351_ = _e2076[1];
                                            }
                                            let _e2087 = phi_5351_;
                                            if (_e2083 > _e2087) {
                                                phi_5356_ = _e2083;
                                            } else {
                                                phi_5356_ = _e2087;
                                            }
                                            let _e2090 = phi_5356_;
                                            if (_e2076[2] < 0f) {
                                                phi_5363_ = -(_e2076[2]);
                                            } else {
                                                phi_5363_ = _e2076[2];
                                            }
                                            let _e2094 = phi_5363_;
                                            if (_e2090 > _e2094) {
                                                phi_5368_ = _e2090;
                                            } else {
                                                phi_5368_ = _e2094;
                                            }
                                            let _e2097 = phi_5368_;
                                            if (_e2073 > _e2097) {
                                                phi_5373_ = _e2073;
                                            } else {
                                                phi_5373_ = _e2097;
                                            }
                                            let _e2100 = phi_5373_;
                                            let _e2102 = local_12.member_3;
                                            let _e2109 = local_12.member_3;
                                            phi_5389_ = type_19(0u, 48u);
                                            phi_5392_ = _e1171.member;
                                            loop {
                                                let _e2115 = phi_5389_;
                                                let _e2117 = phi_5392_;
                                                local_61 = _e2117;
                                                local_24 = _e2117;
                                                local_25 = _e2117;
                                                local_26 = _e2117;
                                                local_27 = _e2117;
                                                if (_e2115.member < _e2115.member_1) {
                                                    phi_5390_ = type_19((_e2115.member + 1u), _e2115.member_1);
                                                    phi_5415_ = type_19(1u, _e2115.member);
                                                } else {
                                                    phi_5390_ = _e2115;
                                                    phi_5415_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2129 = phi_5390_;
                                                let _e2131 = phi_5415_;
                                                if (bitcast<i32>(_e2131.member) != 0i) {
                                                    let _e2137 = local_12.member[0u];
                                                    let _e2143 = local_12.member[1u];
                                                    let _e2159 = local_12.member_1[0u];
                                                    let _e2165 = local_12.member_1[1u];
                                                    let _e2181 = local_12.member_2[0u];
                                                    let _e2187 = local_12.member_2[1u];
                                                    let _e2201 = function_1(array<f32, 3>((_e2137[0] + ((_e2143[0] - _e2137[0]) * _e2117)), (_e2137[1] + ((_e2143[1] - _e2137[1]) * _e2117)), (_e2137[2] + ((_e2143[2] - _e2137[2]) * _e2117))), array<f32, 3>((_e2159[0] + ((_e2165[0] - _e2159[0]) * _e2117)), (_e2159[1] + ((_e2165[1] - _e2159[1]) * _e2117)), (_e2159[2] + ((_e2165[2] - _e2159[2]) * _e2117))), array<f32, 3>((_e2181[0] + ((_e2187[0] - _e2181[0]) * _e2117)), (_e2181[1] + ((_e2187[1] - _e2181[1]) * _e2117)), (_e2181[2] + ((_e2187[2] - _e2181[2]) * _e2117))), 0u);
                                                    if (_e2201[0] < 0f) {
                                                        phi_5526_ = -(_e2201[0]);
                                                    } else {
                                                        phi_5526_ = _e2201[0];
                                                    }
                                                    let _e2206 = phi_5526_;
                                                    if (_e2201[1] < 0f) {
                                                        phi_5533_ = -(_e2201[1]);
                                                    } else {
                                                        phi_5533_ = _e2201[1];
                                                    }
                                                    let _e2211 = phi_5533_;
                                                    if (_e2201[2] < 0f) {
                                                        phi_5541_ = -(_e2201[2]);
                                                    } else {
                                                        phi_5541_ = _e2201[2];
                                                    }
                                                    let _e2217 = phi_5541_;
                                                    let _e2218 = ((_e2206 + _e2211) + _e2217);
                                                    if (_e2218 > 0f) {
                                                        if ((bitcast<u32>(_e2218) & 2139095040u) != 2139095040u) {
                                                            let _e2223 = (1f / _e2218);
                                                            let _e2225 = (_e2201[0] * _e2223);
                                                            let _e2227 = (_e2201[1] * _e2223);
                                                            let _e2229 = (_e2201[2] * _e2223);
                                                            let _e2234 = (((_e2225 * _e2225) + (_e2227 * _e2227)) + (_e2229 * _e2229));
                                                            if (_e2234 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2234 > 0f) {
                                                                    phi_5578_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_5578_ = 0f;
                                                                }
                                                                let _e2287 = phi_5578_;
                                                                phi_5642_ = _e2287;
                                                            } else {
                                                                phi_5585_ = type_17(0i, 5i);
                                                                phi_5588_ = bitcast<f32>(((bitcast<u32>(_e2234) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2242 = phi_5585_;
                                                                    let _e2244 = phi_5588_;
                                                                    local_18 = _e2244;
                                                                    if (_e2242.member < _e2242.member_1) {
                                                                        let _e2251 = (_e2242.member + 1i);
                                                                        if ((false == (_e2251 > _e2242.member)) != false) {
                                                                            phi_5609_ = true;
                                                                        } else {
                                                                            phi_5609_ = false;
                                                                        }
                                                                        let _e2256 = phi_5609_;
                                                                        if _e2256 {
                                                                            phi_5615_ = type_18(0u, type_18().member_1);
                                                                        } else {
                                                                            phi_5615_ = type_18(1u, _e2251);
                                                                        }
                                                                        let _e2261 = phi_5615_;
                                                                        phi_5586_ = type_17(_e2261.member_1, _e2242.member_1);
                                                                        phi_5629_ = type_18(1u, _e2242.member);
                                                                    } else {
                                                                        phi_5586_ = _e2242;
                                                                        phi_5629_ = type_18(0u, type_18().member_1);
                                                                    }
                                                                    let _e2267 = phi_5586_;
                                                                    let _e2269 = phi_5629_;
                                                                    let _e2272 = (bitcast<i32>(_e2269.member) != 0i);
                                                                    if _e2272 {
                                                                        phi_5589_ = (0.5f * (_e2244 + (_e2234 / _e2244)));
                                                                    } else {
                                                                        phi_5589_ = f32();
                                                                    }
                                                                    let _e2277 = phi_5589_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_5585_ = _e2267;
                                                                        phi_5588_ = _e2277;
                                                                        break if !(_e2272);
                                                                    }
                                                                }
                                                                let _e2282 = local_18;
                                                                phi_5642_ = (_e2282 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2289 = phi_5642_;
                                                            phi_5651_ = type_19(0u, 4u);
                                                            phi_5654_ = 2f;
                                                            loop {
                                                                let _e2297 = phi_5651_;
                                                                let _e2299 = phi_5654_;
                                                                local_20 = _e2299;
                                                                local_21 = _e2299;
                                                                local_22 = _e2299;
                                                                local_51 = _e2299;
                                                                local_52 = _e2299;
                                                                if (_e2297.member < _e2297.member_1) {
                                                                    phi_5652_ = type_19((_e2297.member + 1u), _e2297.member_1);
                                                                    phi_5677_ = type_19(1u, _e2297.member);
                                                                } else {
                                                                    phi_5652_ = _e2297;
                                                                    phi_5677_ = type_19(0u, type_19().member_1);
                                                                }
                                                                let _e2311 = phi_5652_;
                                                                let _e2313 = phi_5677_;
                                                                if (bitcast<i32>(_e2313.member) != 0i) {
                                                                    let _e2319 = local[_e2313.member_1];
                                                                    let _e2327 = (((_e2225 * _e2319[0]) + (_e2227 * _e2319[1])) + (_e2229 * _e2319[2]));
                                                                    let _e2329 = local_1[_e2313.member_1];
                                                                    let _e2337 = (((_e2225 * _e2329[0]) + (_e2227 * _e2329[1])) + (_e2229 * _e2329[2]));
                                                                    if (_e2327 < 0f) {
                                                                        phi_5728_ = -(_e2327);
                                                                    } else {
                                                                        phi_5728_ = _e2327;
                                                                    }
                                                                    let _e2341 = phi_5728_;
                                                                    if (_e2337 < 0f) {
                                                                        phi_5734_ = -(_e2337);
                                                                    } else {
                                                                        phi_5734_ = _e2337;
                                                                    }
                                                                    let _e2345 = phi_5734_;
                                                                    let _e2349 = (((((((((_e1992 + _e1994) + (_e2046 + _e2048)) + (_e2100 + _e2102)) * (0.000000059604645f * 16f)) + (_e2109 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2289) * (1f + (0.000000059604645f * 8f)))) + ((_e2341 + _e2345) * (0.000000059604645f * 8f)));
                                                                    if (_e2327 > _e2349) {
                                                                        if (_e2337 > _e2349) {
                                                                            phi_5747_ = false;
                                                                        } else {
                                                                            phi_5747_ = true;
                                                                        }
                                                                        let _e2353 = phi_5747_;
                                                                        phi_5748_ = _e2353;
                                                                    } else {
                                                                        phi_5748_ = true;
                                                                    }
                                                                    let _e2355 = phi_5748_;
                                                                    if _e2355 {
                                                                        if ((_e2327 + ((_e2337 - _e2327) * _e2117)) > _e2349) {
                                                                            if (_e2337 < _e2327) {
                                                                                let _e2363 = ((_e2327 - _e2337) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                                                if _e2363 {
                                                                                    let _e2369 = (((_e2327 - _e2349) / (_e2327 - _e2337)) * (1f - (0.000000059604645f * 16f)));
                                                                                    if (_e2299 < _e2369) {
                                                                                        phi_5779_ = _e2299;
                                                                                    } else {
                                                                                        phi_5779_ = _e2369;
                                                                                    }
                                                                                    let _e2372 = phi_5779_;
                                                                                    phi_5780_ = _e2372;
                                                                                } else {
                                                                                    phi_5780_ = f32();
                                                                                }
                                                                                let _e2374 = phi_5780_;
                                                                                phi_5781_ = _e2374;
                                                                                phi_5782_ = _e2363;
                                                                            } else {
                                                                                phi_5781_ = _e2299;
                                                                                phi_5782_ = true;
                                                                            }
                                                                            let _e2376 = phi_5781_;
                                                                            let _e2378 = phi_5782_;
                                                                            if _e2378 {
                                                                                phi_5786_ = false;
                                                                            } else {
                                                                                phi_5786_ = true;
                                                                            }
                                                                            let _e2380 = phi_5786_;
                                                                            phi_5787_ = _e2376;
                                                                            phi_5788_ = _e2378;
                                                                            phi_5789_ = _e2380;
                                                                            phi_5790_ = false;
                                                                        } else {
                                                                            phi_5787_ = f32();
                                                                            phi_5788_ = false;
                                                                            phi_5789_ = false;
                                                                            phi_5790_ = true;
                                                                        }
                                                                        let _e2382 = phi_5787_;
                                                                        let _e2384 = phi_5788_;
                                                                        let _e2386 = phi_5789_;
                                                                        let _e2388 = phi_5790_;
                                                                        phi_5791_ = _e2382;
                                                                        phi_5792_ = _e2384;
                                                                        phi_5793_ = _e2386;
                                                                        phi_5794_ = _e2388;
                                                                    } else {
                                                                        phi_5791_ = _e2299;
                                                                        phi_5792_ = true;
                                                                        phi_5793_ = false;
                                                                        phi_5794_ = false;
                                                                    }
                                                                    let _e2390 = phi_5791_;
                                                                    let _e2392 = phi_5792_;
                                                                    let _e2394 = phi_5793_;
                                                                    let _e2396 = phi_5794_;
                                                                    phi_5655_ = _e2390;
                                                                    phi_5795_ = _e2392;
                                                                    phi_5796_ = false;
                                                                    phi_5797_ = _e2394;
                                                                    phi_5798_ = _e2396;
                                                                } else {
                                                                    phi_5655_ = f32();
                                                                    phi_5795_ = false;
                                                                    phi_5796_ = true;
                                                                    phi_5797_ = false;
                                                                    phi_5798_ = false;
                                                                }
                                                                let _e2398 = phi_5655_;
                                                                let _e2400 = phi_5795_;
                                                                let _e2402 = phi_5796_;
                                                                let _e2404 = phi_5797_;
                                                                let _e2406 = phi_5798_;
                                                                local_19 = _e2402;
                                                                local_49 = _e2404;
                                                                local_50 = _e2406;
                                                                continue;
                                                                continuing {
                                                                    phi_5651_ = _e2311;
                                                                    phi_5654_ = _e2398;
                                                                    break if !(_e2400);
                                                                }
                                                            }
                                                            let _e2409 = local_19;
                                                            if _e2409 {
                                                                let _e2411 = local_20;
                                                                let _e2412 = (_e2411 > _e1171.member_1);
                                                                if _e2412 {
                                                                    phi_5819_ = false;
                                                                    phi_5820_ = false;
                                                                    phi_5821_ = false;
                                                                } else {
                                                                    let _e2414 = local_21;
                                                                    if (_e2414 > _e2117) {
                                                                        let _e2417 = local_22;
                                                                        let _e2419 = ((_e2417 - _e2117) < 0.00000000023283064f);
                                                                        if _e2419 {
                                                                            phi_5815_ = false;
                                                                        } else {
                                                                            phi_5815_ = true;
                                                                        }
                                                                        let _e2421 = phi_5815_;
                                                                        phi_5816_ = _e2421;
                                                                        phi_5817_ = _e2419;
                                                                        phi_5818_ = false;
                                                                    } else {
                                                                        phi_5816_ = false;
                                                                        phi_5817_ = false;
                                                                        phi_5818_ = true;
                                                                    }
                                                                    let _e2423 = phi_5816_;
                                                                    let _e2425 = phi_5817_;
                                                                    let _e2427 = phi_5818_;
                                                                    phi_5819_ = _e2423;
                                                                    phi_5820_ = _e2425;
                                                                    phi_5821_ = _e2427;
                                                                }
                                                                let _e2429 = phi_5819_;
                                                                let _e2431 = phi_5820_;
                                                                let _e2433 = phi_5821_;
                                                                phi_5822_ = _e2429;
                                                                phi_5823_ = _e2412;
                                                                phi_5824_ = _e2431;
                                                                phi_5825_ = _e2433;
                                                                phi_5826_ = false;
                                                                phi_5827_ = false;
                                                            } else {
                                                                phi_5822_ = false;
                                                                phi_5823_ = false;
                                                                phi_5824_ = false;
                                                                phi_5825_ = false;
                                                                let _e4301 = local_49;
                                                                phi_5826_ = _e4301;
                                                                let _e4304 = local_50;
                                                                phi_5827_ = _e4304;
                                                            }
                                                            let _e2435 = phi_5822_;
                                                            let _e2437 = phi_5823_;
                                                            let _e2439 = phi_5824_;
                                                            let _e2441 = phi_5825_;
                                                            let _e2443 = phi_5826_;
                                                            let _e2445 = phi_5827_;
                                                            let _e4307 = local_51;
                                                            phi_5828_ = _e4307;
                                                            let _e4310 = local_52;
                                                            phi_5829_ = _e4310;
                                                            phi_5830_ = _e2435;
                                                            phi_5831_ = _e2437;
                                                            phi_5832_ = _e2439;
                                                            phi_5833_ = _e2441;
                                                            phi_5834_ = _e2443;
                                                            phi_5835_ = _e2445;
                                                            phi_5836_ = false;
                                                        } else {
                                                            phi_5828_ = f32();
                                                            phi_5829_ = f32();
                                                            phi_5830_ = false;
                                                            phi_5831_ = false;
                                                            phi_5832_ = false;
                                                            phi_5833_ = false;
                                                            phi_5834_ = false;
                                                            phi_5835_ = false;
                                                            phi_5836_ = true;
                                                        }
                                                        let _e2447 = phi_5828_;
                                                        let _e2449 = phi_5829_;
                                                        let _e2451 = phi_5830_;
                                                        let _e2453 = phi_5831_;
                                                        let _e2455 = phi_5832_;
                                                        let _e2457 = phi_5833_;
                                                        let _e2459 = phi_5834_;
                                                        let _e2461 = phi_5835_;
                                                        let _e2463 = phi_5836_;
                                                        phi_5837_ = _e2447;
                                                        phi_5838_ = _e2449;
                                                        phi_5839_ = _e2451;
                                                        phi_5840_ = _e2453;
                                                        phi_5841_ = _e2455;
                                                        phi_5842_ = _e2457;
                                                        phi_5843_ = _e2459;
                                                        phi_5844_ = _e2461;
                                                        phi_5845_ = _e2463;
                                                        phi_5846_ = false;
                                                    } else {
                                                        phi_5837_ = f32();
                                                        phi_5838_ = f32();
                                                        phi_5839_ = false;
                                                        phi_5840_ = false;
                                                        phi_5841_ = false;
                                                        phi_5842_ = false;
                                                        phi_5843_ = false;
                                                        phi_5844_ = false;
                                                        phi_5845_ = false;
                                                        phi_5846_ = true;
                                                    }
                                                    let _e2465 = phi_5837_;
                                                    let _e2467 = phi_5838_;
                                                    let _e2469 = phi_5839_;
                                                    let _e2471 = phi_5840_;
                                                    let _e2473 = phi_5841_;
                                                    let _e2475 = phi_5842_;
                                                    let _e2477 = phi_5843_;
                                                    let _e2479 = phi_5844_;
                                                    let _e2481 = phi_5845_;
                                                    let _e2483 = phi_5846_;
                                                    phi_5847_ = _e2465;
                                                    phi_5393_ = _e2467;
                                                    phi_5848_ = _e2469;
                                                    phi_5849_ = _e2471;
                                                    phi_5850_ = _e2473;
                                                    phi_5851_ = false;
                                                    phi_5852_ = _e2475;
                                                    phi_5853_ = _e2477;
                                                    phi_5854_ = _e2479;
                                                    phi_5855_ = _e2481;
                                                    phi_5856_ = _e2483;
                                                } else {
                                                    phi_5847_ = f32();
                                                    phi_5393_ = f32();
                                                    phi_5848_ = false;
                                                    phi_5849_ = false;
                                                    phi_5850_ = false;
                                                    phi_5851_ = true;
                                                    phi_5852_ = false;
                                                    phi_5853_ = false;
                                                    phi_5854_ = false;
                                                    phi_5855_ = false;
                                                    phi_5856_ = false;
                                                }
                                                let _e2485 = phi_5847_;
                                                let _e2487 = phi_5393_;
                                                let _e2489 = phi_5848_;
                                                let _e2491 = phi_5849_;
                                                let _e2493 = phi_5850_;
                                                let _e2495 = phi_5851_;
                                                let _e2497 = phi_5852_;
                                                let _e2499 = phi_5853_;
                                                let _e2501 = phi_5854_;
                                                let _e2503 = phi_5855_;
                                                let _e2505 = phi_5856_;
                                                local_23 = _e2491;
                                                local_53 = _e2493;
                                                local_54 = _e2495;
                                                local_55 = _e2497;
                                                local_56 = _e2499;
                                                local_57 = _e2501;
                                                local_58 = _e2503;
                                                local_59 = _e2505;
                                                local_60 = _e2485;
                                                local_62 = _e2491;
                                                continue;
                                                continuing {
                                                    phi_5389_ = _e2129;
                                                    phi_5392_ = _e2487;
                                                    break if !(_e2489);
                                                }
                                            }
                                            let _e2508 = local_23;
                                            if _e2508 {
                                                phi_5861_ = type_32(0u, type_32().member_1);
                                                phi_5862_ = false;
                                                phi_5863_ = false;
                                                phi_5864_ = false;
                                                phi_5865_ = false;
                                                phi_5866_ = false;
                                                phi_5867_ = false;
                                                phi_5868_ = false;
                                            } else {
                                                phi_5861_ = type_32();
                                                let _e4343 = local_53;
                                                phi_5862_ = _e4343;
                                                let _e4346 = local_54;
                                                phi_5863_ = _e4346;
                                                let _e4349 = local_55;
                                                phi_5864_ = _e4349;
                                                let _e4352 = local_56;
                                                phi_5865_ = _e4352;
                                                let _e4355 = local_57;
                                                phi_5866_ = _e4355;
                                                let _e4358 = local_58;
                                                phi_5867_ = _e4358;
                                                let _e4361 = local_59;
                                                phi_5868_ = _e4361;
                                            }
                                            let _e2512 = phi_5861_;
                                            let _e2514 = phi_5862_;
                                            let _e2516 = phi_5863_;
                                            let _e2518 = phi_5864_;
                                            let _e2520 = phi_5865_;
                                            let _e2522 = phi_5866_;
                                            let _e2524 = phi_5867_;
                                            let _e2526 = phi_5868_;
                                            if _e2514 {
                                                let _e4364 = local_60;
                                                phi_5872_ = _e4364;
                                                phi_5873_ = true;
                                                phi_5874_ = false;
                                                phi_5875_ = false;
                                                phi_5876_ = false;
                                                phi_5877_ = false;
                                                phi_5878_ = false;
                                                phi_5879_ = false;
                                            } else {
                                                let _e4366 = local_61;
                                                phi_5872_ = _e4366;
                                                phi_5873_ = _e2516;
                                                phi_5874_ = _e2518;
                                                phi_5875_ = _e2520;
                                                phi_5876_ = _e2522;
                                                let _e4373 = local_62;
                                                phi_5877_ = _e4373;
                                                phi_5878_ = _e2524;
                                                phi_5879_ = _e2526;
                                            }
                                            let _e2528 = phi_5872_;
                                            let _e2530 = phi_5873_;
                                            let _e2532 = phi_5874_;
                                            let _e2534 = phi_5875_;
                                            let _e2536 = phi_5876_;
                                            let _e2538 = phi_5877_;
                                            let _e2540 = phi_5878_;
                                            let _e2542 = phi_5879_;
                                            if _e2530 {
                                                phi_5884_ = type_32(1u, _e2528);
                                                phi_5885_ = false;
                                                phi_5886_ = false;
                                                phi_5887_ = false;
                                                phi_5888_ = false;
                                                phi_5889_ = false;
                                                phi_5890_ = false;
                                            } else {
                                                phi_5884_ = type_32();
                                                phi_5885_ = _e2532;
                                                phi_5886_ = _e2534;
                                                phi_5887_ = _e2536;
                                                phi_5888_ = _e2538;
                                                phi_5889_ = _e2540;
                                                phi_5890_ = _e2542;
                                            }
                                            let _e2545 = phi_5884_;
                                            let _e2547 = phi_5885_;
                                            let _e2549 = phi_5886_;
                                            let _e2551 = phi_5887_;
                                            let _e2553 = phi_5888_;
                                            let _e2555 = phi_5889_;
                                            let _e2557 = phi_5890_;
                                            if _e2547 {
                                                let _e2559 = local_24;
                                                phi_5895_ = type_32(1u, _e2559);
                                                phi_5896_ = false;
                                                phi_5897_ = false;
                                                phi_5898_ = true;
                                                phi_5899_ = false;
                                                phi_5900_ = false;
                                            } else {
                                                phi_5895_ = _e2512;
                                                phi_5896_ = _e2549;
                                                phi_5897_ = _e2551;
                                                phi_5898_ = _e2553;
                                                phi_5899_ = _e2555;
                                                phi_5900_ = _e2557;
                                            }
                                            let _e2562 = phi_5895_;
                                            let _e2564 = phi_5896_;
                                            let _e2566 = phi_5897_;
                                            let _e2568 = phi_5898_;
                                            let _e2570 = phi_5899_;
                                            let _e2572 = phi_5900_;
                                            if _e2564 {
                                                let _e2574 = local_25;
                                                phi_5905_ = type_32(1u, _e2574);
                                                phi_5906_ = false;
                                                phi_5907_ = false;
                                                phi_5908_ = false;
                                                phi_5909_ = false;
                                            } else {
                                                phi_5905_ = type_32();
                                                phi_5906_ = _e2566;
                                                phi_5907_ = _e2568;
                                                phi_5908_ = _e2570;
                                                phi_5909_ = _e2572;
                                            }
                                            let _e2577 = phi_5905_;
                                            let _e2579 = phi_5906_;
                                            let _e2581 = phi_5907_;
                                            let _e2583 = phi_5908_;
                                            let _e2585 = phi_5909_;
                                            if _e2579 {
                                                let _e2587 = local_26;
                                                phi_5914_ = type_32(1u, _e2587);
                                                phi_5915_ = true;
                                                phi_5916_ = false;
                                                phi_5917_ = false;
                                                phi_5918_ = false;
                                            } else {
                                                phi_5914_ = _e2577;
                                                phi_5915_ = _e2564;
                                                phi_5916_ = _e2581;
                                                phi_5917_ = _e2583;
                                                phi_5918_ = _e2585;
                                            }
                                            let _e2590 = phi_5914_;
                                            let _e2592 = phi_5915_;
                                            let _e2594 = phi_5916_;
                                            let _e2596 = phi_5917_;
                                            let _e2598 = phi_5918_;
                                            if _e2592 {
                                                phi_5922_ = _e2590;
                                                phi_5923_ = true;
                                                phi_5924_ = false;
                                                phi_5925_ = false;
                                            } else {
                                                phi_5922_ = _e2562;
                                                phi_5923_ = _e2594;
                                                phi_5924_ = _e2596;
                                                phi_5925_ = _e2598;
                                            }
                                            let _e2600 = phi_5922_;
                                            let _e2602 = phi_5923_;
                                            let _e2604 = phi_5924_;
                                            let _e2606 = phi_5925_;
                                            if _e2602 {
                                                phi_5929_ = false;
                                                phi_5930_ = false;
                                            } else {
                                                phi_5929_ = _e2604;
                                                phi_5930_ = _e2606;
                                            }
                                            let _e2608 = phi_5929_;
                                            let _e2610 = phi_5930_;
                                            if _e2608 {
                                                phi_5934_ = false;
                                                phi_5935_ = false;
                                            } else {
                                                phi_5934_ = _e2610;
                                                phi_5935_ = _e2602;
                                            }
                                            let _e2612 = phi_5934_;
                                            let _e2614 = phi_5935_;
                                            if _e2612 {
                                                phi_5939_ = true;
                                                phi_5940_ = false;
                                            } else {
                                                phi_5939_ = _e2608;
                                                phi_5940_ = _e2614;
                                            }
                                            let _e2616 = phi_5939_;
                                            let _e2618 = phi_5940_;
                                            if _e2616 {
                                                let _e2620 = local_27;
                                                phi_5945_ = type_32(1u, _e2620);
                                                phi_5946_ = true;
                                            } else {
                                                phi_5945_ = _e2600;
                                                phi_5946_ = _e2618;
                                            }
                                            let _e2623 = phi_5945_;
                                            let _e2625 = phi_5946_;
                                            if _e2625 {
                                                phi_5950_ = _e2623;
                                            } else {
                                                phi_5950_ = _e2545;
                                            }
                                            let _e2627 = phi_5950_;
                                            let _e2630 = (_e2627.member != 0u);
                                            if _e2630 {
                                                phi_5957_ = false;
                                            } else {
                                                phi_5957_ = true;
                                            }
                                            let _e2632 = phi_5957_;
                                            phi_5958_ = _e2627.member_1;
                                            phi_5959_ = _e2632;
                                            phi_5960_ = _e2630;
                                            phi_5961_ = false;
                                        } else {
                                            phi_5958_ = f32();
                                            phi_5959_ = false;
                                            phi_5960_ = false;
                                            phi_5961_ = true;
                                        }
                                        let _e2634 = phi_5958_;
                                        let _e2636 = phi_5959_;
                                        let _e2638 = phi_5960_;
                                        let _e2640 = phi_5961_;
                                        phi_5962_ = _e2634;
                                        phi_5963_ = _e2636;
                                        phi_5964_ = _e2638;
                                        phi_5965_ = _e2640;
                                    }
                                    let _e2642 = phi_5962_;
                                    let _e2644 = phi_5963_;
                                    let _e2646 = phi_5964_;
                                    let _e2648 = phi_5965_;
                                    phi_5966_ = _e2642;
                                    phi_5967_ = _e1873;
                                    phi_5968_ = _e2644;
                                    phi_5969_ = _e2646;
                                    phi_5970_ = _e2648;
                                }
                                let _e2650 = phi_5966_;
                                let _e2652 = phi_5967_;
                                let _e2654 = phi_5968_;
                                let _e2656 = phi_5969_;
                                let _e2658 = phi_5970_;
                                if _e2652 {
                                    phi_5974_ = true;
                                    phi_5975_ = false;
                                    phi_5976_ = false;
                                } else {
                                    phi_5974_ = _e2654;
                                    phi_5975_ = _e2656;
                                    phi_5976_ = _e2658;
                                }
                                let _e2660 = phi_5974_;
                                let _e2662 = phi_5975_;
                                let _e2664 = phi_5976_;
                                phi_5977_ = _e2650;
                                phi_5978_ = _e1171;
                                phi_5979_ = _e2660;
                                phi_5980_ = false;
                                phi_5981_ = _e2662;
                                phi_5982_ = _e2664;
                            } else {
                                phi_5977_ = f32();
                                phi_5978_ = type_33();
                                phi_5979_ = false;
                                phi_5980_ = true;
                                phi_5981_ = false;
                                phi_5982_ = false;
                            }
                            let _e2666 = phi_5977_;
                            let _e2668 = phi_5978_;
                            let _e2670 = phi_5979_;
                            let _e2672 = phi_5980_;
                            let _e2674 = phi_5981_;
                            let _e2676 = phi_5982_;
                            local_28 = _e2672;
                            local_63 = _e2674;
                            local_64 = _e2676;
                            local_29 = _e2666;
                            local_30 = _e2668;
                            continue;
                            continuing {
                                phi_3476_ = _e876;
                                break if !(_e2670);
                            }
                        }
                        let _e2679 = local_28;
                        if _e2679 {
                            phi_5987_ = type_32(0u, type_32().member_1);
                            phi_5988_ = false;
                            phi_5989_ = false;
                        } else {
                            phi_5987_ = type_32();
                            let _e4443 = local_63;
                            phi_5988_ = _e4443;
                            let _e4446 = local_64;
                            phi_5989_ = _e4446;
                        }
                        let _e2683 = phi_5987_;
                        let _e2685 = phi_5988_;
                        let _e2687 = phi_5989_;
                        if _e2685 {
                            let _e2689 = local_29;
                            phi_5994_ = type_32(2u, _e2689);
                            phi_5995_ = false;
                        } else {
                            phi_5994_ = type_32();
                            phi_5995_ = _e2687;
                        }
                        let _e2692 = phi_5994_;
                        let _e2694 = phi_5995_;
                        if _e2694 {
                            let _e2696 = local_30;
                            phi_6001_ = type_32(1u, _e2696.member);
                            phi_6002_ = true;
                        } else {
                            phi_6001_ = _e2692;
                            phi_6002_ = _e2685;
                        }
                        let _e2700 = phi_6001_;
                        let _e2702 = phi_6002_;
                        if _e2702 {
                            phi_6006_ = _e2700;
                        } else {
                            phi_6006_ = _e2683;
                        }
                        let _e2704 = phi_6006_;
                        phi_6010_ = _e2704;
                    }
                    let _e3820 = phi_6010_;
                    phi_6011_ = _e3820;
                }
                let _e3824 = phi_6011_;
                switch bitcast<i32>(_e3824.member) {
                    case 0: {
                        phi_6024_ = type_34(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e3830 = function_2(_e3824.member_1);
                        phi_6024_ = type_34(0u, _e3830, true);
                        break;
                    }
                    case 2: {
                        let _e3828 = function_2(_e3824.member_1);
                        phi_6024_ = type_34(1u, _e3828, true);
                        break;
                    }
                    default: {
                        phi_6024_ = type_34();
                        break;
                    }
                }
                let _e3833 = phi_6024_;
                if _e3833.member_2 {
                    phi_6031_ = (_e3833.member == 0u);
                } else {
                    phi_6031_ = false;
                }
                let _e3838 = phi_6031_;
                if _e3838 {
                    let _e3846 = (_e3833.member_1[1] >> bitcast<u32>(20i));
                    if (_e3846 <= 896u) {
                        phi_6055_ = 0u;
                    } else {
                        phi_6055_ = ((((_e3846 - 896u) << bitcast<u32>(23i)) | ((_e3833.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e3833.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e3861 = phi_6055_;
                    let _e3863 = atomicMin((&earliest.member[0u]), _e3861);
                }
                phi_6059_ = type_27(_e161, 0u, _e167, _e170, _e3833.member_1);
                phi_6060_ = _e3838;
                phi_6061_ = (_e3833.member != 0u);
            } else {
                phi_6059_ = type_27(_e161, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_6060_ = false;
                phi_6061_ = false;
            }
            let _e3865 = phi_6059_;
            let _e3867 = phi_6060_;
            let _e3869 = phi_6061_;
            let _e3871 = params.member.member_1;
            if ((_e3871 & 16u) != 0u) {
                if (_e94 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e3867 {
                    let _e3877 = atomicAdd((&counters[0u]), 1u);
                    phi_6079_ = _e3877;
                } else {
                    phi_6079_ = 0u;
                }
                let _e3879 = phi_6079_;
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
                if _e3867 {
                    let _e3891 = params.member.member_16;
                    if (_e3889 < _e3891) {
                        let _e3893 = (6u * _e3889);
                        atomicStore((&contacts.member[(4u + _e3893)]), _e3865.member);
                        atomicStore((&contacts.member[(_e3893 + 5u)]), _e3865.member_1);
                        atomicStore((&contacts.member[(_e3893 + 6u)]), _e3865.member_2);
                        atomicStore((&contacts.member[(_e3893 + 7u)]), _e3865.member_3);
                        atomicStore((&contacts.member[(_e3893 + 8u)]), _e3865.member_4[0]);
                        atomicStore((&contacts.member[(_e3893 + 9u)]), _e3865.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e94 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e3869 {
                let _e3917 = atomicAdd((&counters[0u]), 1u);
                phi_6141_ = _e3917;
            } else {
                phi_6141_ = 0u;
            }
            let _e3919 = phi_6141_;
            workgroupBarrier();
            if (_e94 == 0u) {
                let _e3922 = atomicLoad((&counters[0u]));
                if (_e3922 > 0u) {
                    let _e3925 = atomicAdd((&undecided.member[0u]), _e3922);
                    atomicStore((&counters[1u]), _e3925);
                }
            }
            workgroupBarrier();
            let _e3928 = atomicLoad((&counters[1u]));
            let _e3929 = (_e3928 + _e3919);
            if _e3869 {
                atomicStore((&undecided.member[(4u + (2u * _e3929))]), _e3865.member_2);
                atomicStore((&undecided.member[((2u * _e3929) + 5u)]), _e3865.member_3);
            }
        }
        continue;
        continuing {
            phi_792_ = _e149;
            break if !(_e155);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
