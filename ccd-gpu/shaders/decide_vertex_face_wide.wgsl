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

struct type_23 {
    member: array<array<f64, 3>>,
}

struct type_25 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_30 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_32 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_33 {
    member: f64,
    member_1: f64,
}

struct type_38 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_39 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_40 {
    member: u32,
    member_1: f64,
}

struct type_41 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_44 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> paths: type_27;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_44;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> wide: type_23;
@group(0) @binding(4) 
var<storage> input: type_12;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_44;
@group(0) @binding(3) 
var<storage> elements: type_14;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    return array<f64, 3>(f64(param[0]), f64(param[1]), f64(param[2]));
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    var phi_729_: array<f64, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_729_ = param_2;
    } else {
        phi_729_ = param_1;
    }
    let _e26 = phi_729_;
    return _e26;
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_293_: bool;
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_296_: bool;
    var phi_300_: bool;
    var phi_273_: bool;
    var phi_274_: bool;
    var phi_275_: bool;
    var phi_276_: bool;
    var phi_277_: bool;
    var phi_278_: bool;
    var phi_282_: bool;
    var phi_301_: bool;
    var phi_331_: array<f64, 3>;
    var phi_332_: bool;
    var phi_333_: array<f64, 3>;
    var phi_334_: bool;
    var phi_580_: f64;
    var phi_582_: f64;
    var phi_624_: f64;
    var phi_626_: f64;
    var phi_674_: f64;
    var phi_676_: f64;
    var phi_385_: f64;
    var phi_387_: f64;
    var phi_435_: f64;
    var phi_437_: f64;
    var phi_482_: f64;
    var phi_484_: f64;
    var phi_535_: f64;
    var phi_537_: f64;
    var phi_691_: array<array<f64, 3>, 4>;
    var phi_699_: array<f64, 3>;

    let _e21 = (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2]));
    let _e32 = (((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2]));
    let _e43 = (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2]));
    let _e54 = (((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2]));
    let _e65 = (((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2]));
    let _e68 = ((_e21 * _e43) - (_e32 * _e32));
    let _e69 = f64(0f);
    let _e70 = f64(1f);
    let _e74 = (((_e54 * _e43) - (_e65 * _e32)) / _e68);
    let _e78 = (((_e65 * _e21) - (_e54 * _e32)) / _e68);
    if (param_6 != 0u) {
        if (_e74 >= _e69) {
            if (_e78 >= _e69) {
                if (_e74 <= _e70) {
                    phi_273_ = (_e78 <= _e70);
                    phi_274_ = false;
                } else {
                    phi_273_ = bool();
                    phi_274_ = true;
                }
                let _e99 = phi_273_;
                let _e101 = phi_274_;
                phi_275_ = _e99;
                phi_276_ = _e101;
            } else {
                phi_275_ = bool();
                phi_276_ = true;
            }
            let _e103 = phi_275_;
            let _e105 = phi_276_;
            phi_277_ = _e103;
            phi_278_ = _e105;
        } else {
            phi_277_ = bool();
            phi_278_ = true;
        }
        let _e107 = phi_277_;
        let _e109 = phi_278_;
        if _e109 {
            phi_282_ = false;
        } else {
            phi_282_ = _e107;
        }
        let _e111 = phi_282_;
        phi_301_ = _e111;
    } else {
        if (_e74 >= _e69) {
            if (_e78 >= _e69) {
                phi_293_ = ((_e74 + _e78) <= _e70);
                phi_294_ = false;
            } else {
                phi_293_ = bool();
                phi_294_ = true;
            }
            let _e85 = phi_293_;
            let _e87 = phi_294_;
            phi_295_ = _e85;
            phi_296_ = _e87;
        } else {
            phi_295_ = bool();
            phi_296_ = true;
        }
        let _e89 = phi_295_;
        let _e91 = phi_296_;
        if _e91 {
            phi_300_ = false;
        } else {
            phi_300_ = _e89;
        }
        let _e93 = phi_300_;
        phi_301_ = _e93;
    }
    let _e113 = phi_301_;
    if (_e68 > _e69) {
        if _e113 {
            phi_331_ = array<f64, 3>((param_3[0] - ((param_4[0] * _e74) + (param_5[0] * _e78))), (param_3[1] - ((param_4[1] * _e74) + (param_5[1] * _e78))), (param_3[2] - ((param_4[2] * _e74) + (param_5[2] * _e78))));
            phi_332_ = false;
        } else {
            phi_331_ = array<f64, 3>();
            phi_332_ = true;
        }
        let _e138 = phi_331_;
        let _e140 = phi_332_;
        phi_333_ = _e138;
        phi_334_ = _e140;
    } else {
        phi_333_ = array<f64, 3>();
        phi_334_ = true;
    }
    let _e142 = phi_333_;
    let _e144 = phi_334_;
    if _e144 {
        let _e147 = (param_3[0] - param_4[0]);
        let _e150 = (param_3[1] - param_4[1]);
        let _e153 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e307 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e307 > f64(0f)) {
                if (_e307 < f64(1f)) {
                    phi_385_ = _e307;
                } else {
                    phi_385_ = f64(1f);
                }
                let _e315 = phi_385_;
                phi_387_ = _e315;
            } else {
                phi_387_ = f64(0f);
            }
            let _e317 = phi_387_;
            let _e353 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e353 > f64(0f)) {
                if (_e353 < f64(1f)) {
                    phi_435_ = _e353;
                } else {
                    phi_435_ = f64(1f);
                }
                let _e361 = phi_435_;
                phi_437_ = _e361;
            } else {
                phi_437_ = f64(0f);
            }
            let _e363 = phi_437_;
            let _e396 = ((((_e147 * param_5[0]) + (_e150 * param_5[1])) + (_e153 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e396 > f64(0f)) {
                if (_e396 < f64(1f)) {
                    phi_482_ = _e396;
                } else {
                    phi_482_ = f64(1f);
                }
                let _e404 = phi_482_;
                phi_484_ = _e404;
            } else {
                phi_484_ = f64(0f);
            }
            let _e406 = phi_484_;
            let _e419 = (param_3[0] - param_5[0]);
            let _e422 = (param_3[1] - param_5[1]);
            let _e425 = (param_3[2] - param_5[2]);
            let _e445 = ((((_e419 * param_4[0]) + (_e422 * param_4[1])) + (_e425 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e445 > f64(0f)) {
                if (_e445 < f64(1f)) {
                    phi_535_ = _e445;
                } else {
                    phi_535_ = f64(1f);
                }
                let _e453 = phi_535_;
                phi_537_ = _e453;
            } else {
                phi_537_ = f64(0f);
            }
            let _e455 = phi_537_;
            phi_691_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e317)), (param_3[1] - (param_4[1] * _e317)), (param_3[2] - (param_4[2] * _e317))), array<f64, 3>((param_3[0] - (param_5[0] * _e363)), (param_3[1] - (param_5[1] * _e363)), (param_3[2] - (param_5[2] * _e363))), array<f64, 3>((_e147 - (param_5[0] * _e406)), (_e150 - (param_5[1] * _e406)), (_e153 - (param_5[2] * _e406))), array<f64, 3>((_e419 - (param_4[0] * _e455)), (_e422 - (param_4[1] * _e455)), (_e425 - (param_4[2] * _e455))));
        } else {
            let _e157 = (param_5[0] - param_4[0]);
            let _e160 = (param_5[1] - param_4[1]);
            let _e163 = (param_5[2] - param_4[2]);
            let _e174 = ((((_e147 * _e157) + (_e150 * _e160)) + (_e153 * _e163)) / (((_e157 * _e157) + (_e160 * _e160)) + (_e163 * _e163)));
            if (_e174 > f64(0f)) {
                if (_e174 < f64(1f)) {
                    phi_580_ = _e174;
                } else {
                    phi_580_ = f64(1f);
                }
                let _e182 = phi_580_;
                phi_582_ = _e182;
            } else {
                phi_582_ = f64(0f);
            }
            let _e184 = phi_582_;
            let _e191 = array<f64, 3>((_e147 - (_e157 * _e184)), (_e150 - (_e160 * _e184)), (_e153 - (_e163 * _e184)));
            let _e214 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e214 > f64(0f)) {
                if (_e214 < f64(1f)) {
                    phi_624_ = _e214;
                } else {
                    phi_624_ = f64(1f);
                }
                let _e222 = phi_624_;
                phi_626_ = _e222;
            } else {
                phi_626_ = f64(0f);
            }
            let _e224 = phi_626_;
            let _e260 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e260 > f64(0f)) {
                if (_e260 < f64(1f)) {
                    phi_674_ = _e260;
                } else {
                    phi_674_ = f64(1f);
                }
                let _e268 = phi_674_;
                phi_676_ = _e268;
            } else {
                phi_676_ = f64(0f);
            }
            let _e270 = phi_676_;
            phi_691_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e224)), (param_3[1] - (param_4[1] * _e224)), (param_3[2] - (param_4[2] * _e224))), array<f64, 3>((param_3[0] - (param_5[0] * _e270)), (param_3[1] - (param_5[1] * _e270)), (param_3[2] - (param_5[2] * _e270))), _e191, _e191);
        }
        let _e468 = phi_691_;
        let _e471 = function_1(_e468[0], _e468[1]);
        let _e473 = function_1(_e471, _e468[2]);
        let _e475 = function_1(_e473, _e468[3]);
        phi_699_ = _e475;
    } else {
        phi_699_ = _e142;
    }
    let _e477 = phi_699_;
    return _e477;
}

fn function_3(param_7: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_7);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<array<f64, 3>, 4>;
    var local_1: array<array<f64, 3>, 4>;
    var local_2: type_32;
    var local_3: type_32;
    var local_4: type_32;
    var local_5: array<type_33, 4>;
    var local_6: array<f64, 4>;
    var local_7: array<f64, 2>;
    var local_8: array<f64, 4>;
    var local_9: array<array<f64, 3>, 4>;
    var local_10: array<array<f64, 3>, 4>;
    var local_11: array<f32, 3>;
    var local_12: type_38;
    var phi_789_: u32;
    var phi_805_: u32;
    var phi_826_: u32;
    var phi_827_: u32;
    var phi_830_: type_19;
    var phi_831_: type_19;
    var phi_854_: type_19;
    var phi_1102_: type_39;
    var phi_1471_: f64;
    var phi_1478_: f64;
    var phi_1483_: f64;
    var phi_1490_: f64;
    var phi_1495_: f64;
    var phi_1508_: f64;
    var phi_1515_: f64;
    var phi_1520_: f64;
    var phi_1527_: f64;
    var phi_1532_: f64;
    var phi_1537_: f64;
    var phi_1554_: f64;
    var phi_1561_: f64;
    var phi_1566_: f64;
    var phi_1573_: f64;
    var phi_1578_: f64;
    var phi_1592_: f64;
    var phi_1599_: f64;
    var phi_1604_: f64;
    var phi_1611_: f64;
    var phi_1616_: f64;
    var phi_1621_: f64;
    var phi_1638_: f64;
    var phi_1645_: f64;
    var phi_1650_: f64;
    var phi_1657_: f64;
    var phi_1662_: f64;
    var phi_1676_: f64;
    var phi_1683_: f64;
    var phi_1688_: f64;
    var phi_1695_: f64;
    var phi_1700_: f64;
    var phi_1705_: f64;
    var phi_1742_: f64;
    var phi_1748_: f64;
    var phi_1755_: f64;
    var phi_1762_: f64;
    var phi_1768_: f64;
    var phi_1775_: f64;
    var phi_1781_: f64;
    var phi_1787_: f64;
    var phi_1793_: f64;
    var phi_1800_: f64;
    var phi_1807_: f64;
    var phi_1835_: f64;
    var phi_1840_: f64;
    var phi_1845_: f64;
    var phi_1850_: f64;
    var phi_1855_: f64;
    var phi_1860_: f64;
    var phi_1871_: f64;
    var phi_3454_: f64;
    var phi_3460_: f64;
    var phi_3465_: f64;
    var phi_3471_: f64;
    var phi_3477_: f64;
    var phi_3482_: f64;
    var phi_3487_: f64;
    var phi_3497_: bool;
    var phi_3504_: f64;
    var phi_3512_: f64;
    var phi_3555_: type_17;
    var phi_3558_: f64;
    var phi_3579_: bool;
    var phi_3585_: type_18;
    var phi_3556_: type_17;
    var phi_3599_: type_18;
    var phi_3559_: f64;
    var local_13: f64;
    var phi_3548_: f64;
    var phi_3612_: f64;
    var phi_3618_: f64;
    var phi_3643_: type_19;
    var phi_3646_: u32;
    var phi_3644_: type_19;
    var phi_3669_: type_19;
    var phi_3713_: u32;
    var phi_3714_: u32;
    var phi_3647_: u32;
    var phi_3715_: u32;
    var phi_3735_: type_19;
    var phi_3736_: type_19;
    var phi_3759_: type_19;
    var phi_3813_: f64;
    var phi_3820_: f64;
    var phi_3832_: bool;
    var phi_3833_: bool;
    var phi_3834_: bool;
    var phi_3835_: bool;
    var phi_3839_: bool;
    var phi_3851_: type_41;
    var phi_3852_: type_41;
    var phi_3853_: bool;
    var phi_3854_: type_41;
    var phi_3855_: bool;
    var phi_3868_: f64;
    var phi_3881_: type_19;
    var phi_3884_: f64;
    var phi_3886_: f64;
    var phi_3888_: f64;
    var phi_3882_: type_19;
    var phi_3911_: type_19;
    var phi_3938_: f64;
    var phi_3939_: f64;
    var phi_3967_: f64;
    var phi_3983_: f64;
    var phi_3990_: bool;
    var phi_3991_: bool;
    var phi_3992_: bool;
    var phi_3998_: f64;
    var phi_3999_: f64;
    var phi_4000_: bool;
    var phi_3885_: f64;
    var phi_3887_: f64;
    var phi_3889_: f64;
    var phi_4001_: f64;
    var phi_4002_: bool;
    var phi_4003_: bool;
    var local_14: bool;
    var phi_4007_: f64;
    var phi_4008_: f64;
    var phi_4016_: type_19;
    var phi_4019_: f64;
    var phi_4017_: type_19;
    var phi_4042_: type_19;
    var phi_4085_: f64;
    var phi_4095_: f64;
    var phi_4105_: bool;
    var phi_4107_: bool;
    var phi_4112_: f64;
    var phi_4113_: bool;
    var phi_4114_: f64;
    var phi_4115_: bool;
    var phi_4116_: bool;
    var phi_4117_: bool;
    var phi_4118_: f64;
    var phi_4020_: f64;
    var phi_4119_: bool;
    var phi_4120_: bool;
    var phi_4121_: bool;
    var phi_4122_: bool;
    var local_15: bool;
    var phi_4126_: bool;
    var phi_4127_: bool;
    var phi_4131_: bool;
    var phi_4135_: f64;
    var phi_4136_: f64;
    var phi_4138_: type_41;
    var phi_4169_: f64;
    var phi_4176_: f64;
    var phi_4181_: f64;
    var phi_4188_: f64;
    var phi_4193_: f64;
    var phi_4206_: f64;
    var phi_4213_: f64;
    var phi_4218_: f64;
    var phi_4225_: f64;
    var phi_4230_: f64;
    var phi_4235_: f64;
    var phi_4294_: f64;
    var phi_4300_: f64;
    var phi_4305_: f64;
    var phi_4311_: f64;
    var phi_4316_: f64;
    var phi_4330_: f64;
    var phi_4336_: f64;
    var phi_4341_: f64;
    var phi_4347_: f64;
    var phi_4352_: f64;
    var phi_4378_: f64;
    var phi_4385_: f64;
    var phi_4390_: f64;
    var phi_4397_: f64;
    var phi_4402_: f64;
    var phi_4415_: f64;
    var phi_4422_: f64;
    var phi_4427_: f64;
    var phi_4434_: f64;
    var phi_4439_: f64;
    var phi_4444_: f64;
    var phi_4503_: f64;
    var phi_4509_: f64;
    var phi_4514_: f64;
    var phi_4520_: f64;
    var phi_4525_: f64;
    var phi_4539_: f64;
    var phi_4545_: f64;
    var phi_4550_: f64;
    var phi_4556_: f64;
    var phi_4561_: f64;
    var phi_4587_: f64;
    var phi_4594_: f64;
    var phi_4599_: f64;
    var phi_4606_: f64;
    var phi_4611_: f64;
    var phi_4624_: f64;
    var phi_4631_: f64;
    var phi_4636_: f64;
    var phi_4643_: f64;
    var phi_4648_: f64;
    var phi_4653_: f64;
    var phi_4712_: f64;
    var phi_4718_: f64;
    var phi_4723_: f64;
    var phi_4729_: f64;
    var phi_4734_: f64;
    var phi_4748_: f64;
    var phi_4754_: f64;
    var phi_4759_: f64;
    var phi_4765_: f64;
    var phi_4770_: f64;
    var phi_4819_: f64;
    var phi_4825_: f64;
    var phi_4853_: f64;
    var phi_4859_: f64;
    var phi_4864_: u32;
    var phi_4865_: u32;
    var phi_4835_: f64;
    var phi_4841_: f64;
    var phi_4846_: u32;
    var phi_4847_: u32;
    var phi_4866_: u32;
    var phi_4867_: u32;
    var phi_4938_: f64;
    var phi_4950_: f64;
    var phi_5089_: f64;
    var phi_5095_: f64;
    var phi_5102_: f64;
    var phi_5146_: type_19;
    var phi_5149_: bool;
    var phi_5147_: type_19;
    var phi_5172_: type_19;
    var phi_5199_: bool;
    var phi_5200_: bool;
    var phi_5150_: bool;
    var phi_5201_: bool;
    var phi_5202_: bool;
    var local_16: bool;
    var phi_5206_: bool;
    var local_17: bool;
    var phi_5213_: u32;
    var phi_5214_: u32;
    var phi_5215_: bool;
    var phi_5216_: u32;
    var phi_5217_: u32;
    var phi_5218_: bool;
    var phi_5222_: u32;
    var phi_5243_: bool;
    var phi_5244_: bool;
    var phi_5245_: bool;
    var phi_5442_: f64;
    var phi_5449_: f64;
    var phi_5454_: f64;
    var phi_5461_: f64;
    var phi_5466_: f64;
    var phi_5479_: f64;
    var phi_5486_: f64;
    var phi_5491_: f64;
    var phi_5498_: f64;
    var phi_5503_: f64;
    var phi_5508_: f64;
    var phi_5525_: f64;
    var phi_5532_: f64;
    var phi_5537_: f64;
    var phi_5544_: f64;
    var phi_5549_: f64;
    var phi_5563_: f64;
    var phi_5570_: f64;
    var phi_5575_: f64;
    var phi_5582_: f64;
    var phi_5587_: f64;
    var phi_5592_: f64;
    var phi_5609_: f64;
    var phi_5616_: f64;
    var phi_5621_: f64;
    var phi_5628_: f64;
    var phi_5633_: f64;
    var phi_5647_: f64;
    var phi_5654_: f64;
    var phi_5659_: f64;
    var phi_5666_: f64;
    var phi_5671_: f64;
    var phi_5676_: f64;
    var phi_5696_: type_19;
    var phi_5699_: f64;
    var phi_5697_: type_19;
    var phi_5722_: type_19;
    var phi_5833_: f64;
    var phi_5840_: f64;
    var phi_5848_: f64;
    var phi_5893_: type_17;
    var phi_5896_: f64;
    var phi_5917_: bool;
    var phi_5923_: type_18;
    var phi_5894_: type_17;
    var phi_5937_: type_18;
    var phi_5897_: f64;
    var local_18: f64;
    var phi_5886_: f64;
    var phi_5950_: f64;
    var phi_5963_: type_19;
    var phi_5966_: f64;
    var phi_5964_: type_19;
    var phi_5989_: type_19;
    var phi_6040_: f64;
    var phi_6046_: f64;
    var phi_6060_: bool;
    var phi_6061_: bool;
    var phi_6095_: f64;
    var phi_6096_: f64;
    var phi_6097_: f64;
    var phi_6098_: bool;
    var phi_6102_: bool;
    var phi_6103_: f64;
    var phi_6104_: bool;
    var phi_6105_: bool;
    var phi_6106_: bool;
    var phi_6107_: f64;
    var phi_6108_: bool;
    var phi_6109_: bool;
    var phi_6110_: bool;
    var phi_5967_: f64;
    var phi_6111_: bool;
    var phi_6112_: bool;
    var phi_6113_: bool;
    var phi_6114_: bool;
    var local_19: bool;
    var local_20: f64;
    var local_21: f64;
    var local_22: f64;
    var phi_6132_: bool;
    var phi_6133_: bool;
    var phi_6134_: bool;
    var phi_6135_: bool;
    var phi_6136_: bool;
    var phi_6137_: bool;
    var phi_6138_: bool;
    var phi_6139_: bool;
    var phi_6140_: bool;
    var phi_6141_: bool;
    var phi_6142_: bool;
    var phi_6143_: bool;
    var phi_6144_: bool;
    var phi_6145_: f64;
    var phi_6146_: f64;
    var phi_6147_: bool;
    var phi_6148_: bool;
    var phi_6149_: bool;
    var phi_6150_: bool;
    var phi_6151_: bool;
    var phi_6152_: bool;
    var phi_6153_: bool;
    var phi_6154_: f64;
    var phi_6155_: f64;
    var phi_6156_: bool;
    var phi_6157_: bool;
    var phi_6158_: bool;
    var phi_6159_: bool;
    var phi_6160_: bool;
    var phi_6161_: bool;
    var phi_6162_: bool;
    var phi_6163_: bool;
    var phi_6164_: f64;
    var phi_5700_: f64;
    var phi_6165_: bool;
    var phi_6166_: bool;
    var phi_6167_: bool;
    var phi_6168_: bool;
    var phi_6169_: bool;
    var phi_6170_: bool;
    var phi_6171_: bool;
    var phi_6172_: bool;
    var phi_6173_: bool;
    var local_23: bool;
    var phi_6178_: type_40;
    var phi_6179_: bool;
    var phi_6180_: bool;
    var phi_6181_: bool;
    var phi_6182_: bool;
    var phi_6183_: bool;
    var phi_6184_: bool;
    var phi_6185_: bool;
    var phi_6189_: f64;
    var phi_6190_: bool;
    var phi_6191_: bool;
    var phi_6192_: bool;
    var phi_6193_: bool;
    var phi_6194_: bool;
    var phi_6195_: bool;
    var phi_6196_: bool;
    var phi_6201_: type_40;
    var phi_6202_: bool;
    var phi_6203_: bool;
    var phi_6204_: bool;
    var phi_6205_: bool;
    var phi_6206_: bool;
    var phi_6207_: bool;
    var local_24: f64;
    var phi_6212_: type_40;
    var phi_6213_: bool;
    var phi_6214_: bool;
    var phi_6215_: bool;
    var phi_6216_: bool;
    var phi_6217_: bool;
    var local_25: f64;
    var phi_6222_: type_40;
    var phi_6223_: bool;
    var phi_6224_: bool;
    var phi_6225_: bool;
    var phi_6226_: bool;
    var local_26: f64;
    var phi_6231_: type_40;
    var phi_6232_: bool;
    var phi_6233_: bool;
    var phi_6234_: bool;
    var phi_6235_: bool;
    var phi_6239_: type_40;
    var phi_6240_: bool;
    var phi_6241_: bool;
    var phi_6242_: bool;
    var phi_6246_: bool;
    var phi_6247_: bool;
    var phi_6251_: bool;
    var phi_6252_: bool;
    var phi_6256_: bool;
    var phi_6257_: bool;
    var local_27: f64;
    var phi_6262_: type_40;
    var phi_6263_: bool;
    var phi_6267_: type_40;
    var phi_6274_: bool;
    var phi_6275_: f64;
    var phi_6276_: bool;
    var phi_6277_: bool;
    var phi_6278_: bool;
    var phi_6279_: f64;
    var phi_6280_: bool;
    var phi_6281_: bool;
    var phi_6282_: bool;
    var phi_6283_: f64;
    var phi_6284_: bool;
    var phi_6285_: bool;
    var phi_6286_: bool;
    var phi_6287_: bool;
    var phi_6291_: bool;
    var phi_6292_: bool;
    var phi_6293_: bool;
    var phi_6294_: f64;
    var phi_6295_: type_41;
    var phi_6296_: bool;
    var phi_6297_: bool;
    var phi_6298_: bool;
    var phi_6299_: bool;
    var local_28: bool;
    var phi_6304_: type_40;
    var phi_6305_: bool;
    var phi_6306_: bool;
    var local_29: f64;
    var phi_6311_: type_40;
    var phi_6312_: bool;
    var local_30: type_41;
    var phi_6318_: type_40;
    var phi_6319_: bool;
    var phi_6323_: type_40;
    var phi_2074_: f64;
    var phi_2081_: f64;
    var phi_2086_: f64;
    var phi_2093_: f64;
    var phi_2098_: f64;
    var phi_2111_: f64;
    var phi_2118_: f64;
    var phi_2123_: f64;
    var phi_2130_: f64;
    var phi_2135_: f64;
    var phi_2140_: f64;
    var phi_2157_: f64;
    var phi_2164_: f64;
    var phi_2169_: f64;
    var phi_2176_: f64;
    var phi_2181_: f64;
    var phi_2195_: f64;
    var phi_2202_: f64;
    var phi_2207_: f64;
    var phi_2214_: f64;
    var phi_2219_: f64;
    var phi_2224_: f64;
    var phi_2241_: f64;
    var phi_2248_: f64;
    var phi_2253_: f64;
    var phi_2260_: f64;
    var phi_2265_: f64;
    var phi_2279_: f64;
    var phi_2286_: f64;
    var phi_2291_: f64;
    var phi_2298_: f64;
    var phi_2303_: f64;
    var phi_2308_: f64;
    var phi_2328_: type_19;
    var phi_2331_: f64;
    var phi_2329_: type_19;
    var phi_2354_: type_19;
    var phi_2465_: f64;
    var phi_2472_: f64;
    var phi_2480_: f64;
    var phi_2525_: type_17;
    var phi_2528_: f64;
    var phi_2549_: bool;
    var phi_2555_: type_18;
    var phi_2526_: type_17;
    var phi_2569_: type_18;
    var phi_2529_: f64;
    var local_31: f64;
    var phi_2518_: f64;
    var phi_2582_: f64;
    var phi_2595_: type_19;
    var phi_2598_: f64;
    var phi_2596_: type_19;
    var phi_2621_: type_19;
    var phi_2672_: f64;
    var phi_2678_: f64;
    var phi_2692_: bool;
    var phi_2693_: bool;
    var phi_2727_: f64;
    var phi_2728_: f64;
    var phi_2729_: f64;
    var phi_2730_: bool;
    var phi_2734_: bool;
    var phi_2735_: f64;
    var phi_2736_: bool;
    var phi_2737_: bool;
    var phi_2738_: bool;
    var phi_2739_: f64;
    var phi_2740_: bool;
    var phi_2741_: bool;
    var phi_2742_: bool;
    var phi_2599_: f64;
    var phi_2743_: bool;
    var phi_2744_: bool;
    var phi_2745_: bool;
    var phi_2746_: bool;
    var local_32: bool;
    var local_33: f64;
    var local_34: f64;
    var local_35: f64;
    var phi_2764_: bool;
    var phi_2765_: bool;
    var phi_2766_: bool;
    var phi_2767_: bool;
    var phi_2768_: bool;
    var phi_2769_: bool;
    var phi_2770_: bool;
    var phi_2771_: bool;
    var phi_2772_: bool;
    var phi_2773_: bool;
    var phi_2774_: bool;
    var phi_2775_: bool;
    var phi_2776_: bool;
    var phi_2777_: f64;
    var phi_2778_: f64;
    var phi_2779_: bool;
    var phi_2780_: bool;
    var phi_2781_: bool;
    var phi_2782_: bool;
    var phi_2783_: bool;
    var phi_2784_: bool;
    var phi_2785_: bool;
    var phi_2786_: f64;
    var phi_2787_: f64;
    var phi_2788_: bool;
    var phi_2789_: bool;
    var phi_2790_: bool;
    var phi_2791_: bool;
    var phi_2792_: bool;
    var phi_2793_: bool;
    var phi_2794_: bool;
    var phi_2795_: bool;
    var phi_2796_: f64;
    var phi_2332_: f64;
    var phi_2797_: bool;
    var phi_2798_: bool;
    var phi_2799_: bool;
    var phi_2800_: bool;
    var phi_2801_: bool;
    var phi_2802_: bool;
    var phi_2803_: bool;
    var phi_2804_: bool;
    var phi_2805_: bool;
    var local_36: bool;
    var phi_2810_: type_40;
    var phi_2811_: bool;
    var phi_2812_: bool;
    var phi_2813_: bool;
    var phi_2814_: bool;
    var phi_2815_: bool;
    var phi_2816_: bool;
    var phi_2817_: bool;
    var phi_2821_: f64;
    var phi_2822_: bool;
    var phi_2823_: bool;
    var phi_2824_: bool;
    var phi_2825_: bool;
    var phi_2826_: bool;
    var phi_2827_: bool;
    var phi_2828_: bool;
    var phi_2833_: type_40;
    var phi_2834_: bool;
    var phi_2835_: bool;
    var phi_2836_: bool;
    var phi_2837_: bool;
    var phi_2838_: bool;
    var phi_2839_: bool;
    var local_37: f64;
    var phi_2844_: type_40;
    var phi_2845_: bool;
    var phi_2846_: bool;
    var phi_2847_: bool;
    var phi_2848_: bool;
    var phi_2849_: bool;
    var local_38: f64;
    var phi_2854_: type_40;
    var phi_2855_: bool;
    var phi_2856_: bool;
    var phi_2857_: bool;
    var phi_2858_: bool;
    var local_39: f64;
    var phi_2863_: type_40;
    var phi_2864_: bool;
    var phi_2865_: bool;
    var phi_2866_: bool;
    var phi_2867_: bool;
    var phi_2871_: type_40;
    var phi_2872_: bool;
    var phi_2873_: bool;
    var phi_2874_: bool;
    var phi_2878_: bool;
    var phi_2879_: bool;
    var phi_2883_: bool;
    var phi_2884_: bool;
    var phi_2888_: bool;
    var phi_2889_: bool;
    var local_40: f64;
    var phi_2894_: type_40;
    var phi_2895_: bool;
    var phi_2899_: type_40;
    var phi_2913_: type_19;
    var phi_2914_: type_19;
    var phi_2937_: type_19;
    var phi_2958_: f64;
    var phi_3088_: type_17;
    var phi_3091_: f64;
    var phi_3112_: bool;
    var phi_3118_: type_18;
    var phi_3089_: type_17;
    var phi_3132_: type_18;
    var phi_3092_: f64;
    var local_41: f64;
    var phi_3081_: f64;
    var phi_3145_: f64;
    var phi_3163_: f64;
    var phi_3170_: f64;
    var phi_3175_: f64;
    var phi_3182_: f64;
    var phi_3187_: f64;
    var phi_3200_: f64;
    var phi_3207_: f64;
    var phi_3212_: f64;
    var phi_3219_: f64;
    var phi_3224_: f64;
    var phi_3229_: f64;
    var phi_3246_: f64;
    var phi_3253_: f64;
    var phi_3258_: f64;
    var phi_3265_: f64;
    var phi_3270_: f64;
    var phi_3284_: f64;
    var phi_3291_: f64;
    var phi_3296_: f64;
    var phi_3303_: f64;
    var phi_3308_: f64;
    var phi_3313_: f64;
    var phi_3330_: f64;
    var phi_3337_: f64;
    var phi_3342_: f64;
    var phi_3349_: f64;
    var phi_3354_: f64;
    var phi_3368_: f64;
    var phi_3375_: f64;
    var phi_3380_: f64;
    var phi_3387_: f64;
    var phi_3392_: f64;
    var phi_3397_: f64;
    var phi_3421_: bool;
    var phi_3422_: bool;
    var phi_3423_: bool;
    var local_42: bool;
    var phi_3428_: type_40;
    var phi_3429_: bool;
    var phi_3434_: type_40;
    var phi_3435_: bool;
    var phi_3437_: type_40;
    var phi_3438_: type_40;
    var phi_3439_: bool;
    var phi_3443_: type_40;
    var phi_6327_: type_40;
    var phi_6328_: type_40;
    var phi_6341_: type_30;
    var phi_6364_: u32;
    var phi_6368_: type_29;
    var phi_6369_: bool;
    var phi_6387_: u32;
    var local_43: u32;
    var local_44: f64;
    var local_45: f64;
    var local_46: bool;
    var local_47: bool;
    var local_48: f64;
    var local_49: bool;
    var local_50: bool;
    var local_51: f64;
    var local_52: f64;
    var local_53: bool;
    var local_54: bool;
    var local_55: bool;
    var local_56: bool;
    var local_57: bool;
    var local_58: bool;
    var local_59: bool;
    var local_60: f64;
    var local_61: f64;
    var local_62: bool;
    var local_63: bool;
    var local_64: bool;
    var local_65: bool;
    var local_66: bool;
    var local_67: f64;
    var local_68: f64;
    var local_69: bool;
    var local_70: bool;
    var local_71: bool;
    var local_72: bool;
    var local_73: bool;
    var local_74: bool;
    var local_75: bool;
    var local_76: f64;
    var local_77: f64;
    var local_78: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e99 = id_2;
    let _e100 = n_2;
    let _e101 = lane_2;
    let _e113 = ((_e99.y * _e100.x) + _e99.x);
    let _e116 = (_e100.x * _e100.y);
    let _e118 = params.member.member_15;
    let _e120 = input.member[0u];
    if (_e118 < _e120) {
        phi_789_ = _e118;
    } else {
        phi_789_ = _e120;
    }
    let _e123 = phi_789_;
    let _e124 = (_e123 / 64u);
    if ((_e123 % 64u) > 0u) {
        phi_805_ = (_e124 + 1u);
    } else {
        phi_805_ = _e124;
    }
    let _e129 = phi_805_;
    if (_e129 > _e113) {
        let _e131 = (_e129 - _e113);
        if (_e116 == 0u) {
            return;
        }
        let _e133 = (_e131 / _e116);
        if (_e116 == 0u) {
            return;
        }
        if ((_e131 % _e116) > 0u) {
            phi_826_ = (_e133 + 1u);
        } else {
            phi_826_ = _e133;
        }
        let _e139 = phi_826_;
        phi_827_ = _e139;
    } else {
        phi_827_ = 0u;
    }
    let _e141 = phi_827_;
    phi_830_ = type_19(0u, _e141);
    loop {
        let _e144 = phi_830_;
        if (_e144.member < _e144.member_1) {
            phi_831_ = type_19((_e144.member + 1u), _e144.member_1);
            phi_854_ = type_19(1u, _e144.member);
        } else {
            phi_831_ = _e144;
            phi_854_ = type_19(0u, type_19().member_1);
        }
        let _e156 = phi_831_;
        let _e158 = phi_854_;
        let _e162 = (bitcast<i32>(_e158.member) != 0i);
        if _e162 {
            let _e166 = (((_e113 + (_e158.member_1 * _e116)) * 64u) + _e101);
            let _e168 = params.member.member_8;
            if (_e166 < _e123) {
                let _e171 = (2u * _e166);
                let _e174 = input.member[(4u + _e171)];
                let _e177 = input.member[(_e171 + 5u)];
                let _e179 = elements.member[_e177];
                let _e184 = params.member.member_1;
                if ((_e184 & 8u) != 0u) {
                    let _e223 = paths.member[_e174];
                    let _e225 = paths.member[_e179[0]];
                    let _e231 = paths.member[_e179[1]];
                    let _e233 = paths.member[_e179[2]];
                    let _e270 = function_(array<f32, 3>(_e223.member[0], _e223.member[1], _e223.member[2]));
                    let _e271 = function_(array<f32, 3>(_e225.member[0], _e225.member[1], _e225.member[2]));
                    let _e272 = function_(array<f32, 3>(_e231.member[0], _e231.member[1], _e231.member[2]));
                    let _e273 = function_(array<f32, 3>(_e233.member[0], _e233.member[1], _e233.member[2]));
                    let _e275 = function_(array<f32, 3>(_e223.member_1[0], _e223.member_1[1], _e223.member_1[2]));
                    let _e276 = function_(array<f32, 3>(_e225.member_1[0], _e225.member_1[1], _e225.member_1[2]));
                    let _e277 = function_(array<f32, 3>(_e231.member_1[0], _e231.member_1[1], _e231.member_1[2]));
                    let _e278 = function_(array<f32, 3>(_e233.member_1[0], _e233.member_1[1], _e233.member_1[2]));
                    phi_1102_ = type_39(array<array<f64, 3>, 4>(_e270, _e271, _e272, _e273), array<array<f64, 3>, 4>(_e275, _e276, _e277, _e278));
                } else {
                    let _e188 = wide.member[_e174];
                    let _e191 = params.member.member[0u];
                    let _e194 = wide.member[(_e191 + _e174)];
                    let _e196 = wide.member[_e179[0]];
                    let _e199 = params.member.member[0u];
                    let _e202 = wide.member[(_e199 + _e179[0])];
                    let _e204 = wide.member[_e179[1]];
                    let _e207 = params.member.member[0u];
                    let _e210 = wide.member[(_e207 + _e179[1])];
                    let _e212 = wide.member[_e179[2]];
                    let _e215 = params.member.member[0u];
                    let _e218 = wide.member[(_e215 + _e179[2])];
                    phi_1102_ = type_39(array<array<f64, 3>, 4>(_e188, _e196, _e204, _e212), array<array<f64, 3>, 4>(_e194, _e202, _e210, _e218));
                }
                let _e282 = phi_1102_;
                local_12 = type_38(array<array<f64, 3>, 2>(array<f64, 3>((_e282.member[0][0] - _e282.member[1][0]), (_e282.member[0][1] - _e282.member[1][1]), (_e282.member[0][2] - _e282.member[1][2])), array<f64, 3>((_e282.member_1[0][0] - _e282.member_1[1][0]), (_e282.member_1[0][1] - _e282.member_1[1][1]), (_e282.member_1[0][2] - _e282.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e282.member[2][0] - _e282.member[1][0]), (_e282.member[2][1] - _e282.member[1][1]), (_e282.member[2][2] - _e282.member[1][2])), array<f64, 3>((_e282.member_1[2][0] - _e282.member_1[1][0]), (_e282.member_1[2][1] - _e282.member_1[1][1]), (_e282.member_1[2][2] - _e282.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e282.member[3][0] - _e282.member[1][0]), (_e282.member[3][1] - _e282.member[1][1]), (_e282.member[3][2] - _e282.member[1][2])), array<f64, 3>((_e282.member_1[3][0] - _e282.member_1[1][0]), (_e282.member_1[3][1] - _e282.member_1[1][1]), (_e282.member_1[3][2] - _e282.member_1[1][2]))), (0.0lf + 0.0lf));
                let _e363 = params.member.member_7;
                let _e370 = bitcast<f64>(((u64(_e363[1]) * 4294967296lu) + u64(_e363[0])));
                let _e371 = f64(0f);
                let _e374 = local_12.member_1[0u];
                let _e380 = local_12.member_2[0u];
                let _e386 = ((_e374[1] * _e380[2]) - (_e374[2] * _e380[1]));
                let _e389 = ((_e374[2] * _e380[0]) - (_e374[0] * _e380[2]));
                let _e392 = ((_e374[0] * _e380[1]) - (_e374[1] * _e380[0]));
                let _e395 = local_12.member_1[1u];
                let _e401 = local_12.member_2[1u];
                let _e407 = ((_e395[1] * _e401[2]) - (_e395[2] * _e401[1]));
                let _e410 = ((_e395[2] * _e401[0]) - (_e395[0] * _e401[2]));
                let _e413 = ((_e395[0] * _e401[1]) - (_e395[1] * _e401[0]));
                let _e416 = local_12.member_1[0u];
                let _e422 = local_12.member_2[1u];
                let _e437 = local_12.member_1[1u];
                let _e443 = local_12.member_2[0u];
                let _e456 = (((_e416[1] * _e422[2]) - (_e416[2] * _e422[1])) + ((_e437[1] * _e443[2]) - (_e437[2] * _e443[1])));
                let _e457 = (((_e416[2] * _e422[0]) - (_e416[0] * _e422[2])) + ((_e437[2] * _e443[0]) - (_e437[0] * _e443[2])));
                let _e458 = (((_e416[0] * _e422[1]) - (_e416[1] * _e422[0])) + ((_e437[0] * _e443[1]) - (_e437[1] * _e443[0])));
                let _e461 = local_12.member[0u];
                let _e469 = (((_e461[0] * _e386) + (_e461[1] * _e389)) + (_e461[2] * _e392));
                let _e472 = local_12.member[1u];
                let _e483 = local_12.member[0u];
                let _e492 = ((((_e472[0] * _e386) + (_e472[1] * _e389)) + (_e472[2] * _e392)) + (((_e483[0] * _e456) + (_e483[1] * _e457)) + (_e483[2] * _e458)));
                let _e495 = local_12.member[0u];
                let _e506 = local_12.member[1u];
                let _e515 = ((((_e495[0] * _e407) + (_e495[1] * _e410)) + (_e495[2] * _e413)) + (((_e506[0] * _e456) + (_e506[1] * _e457)) + (_e506[2] * _e458)));
                let _e518 = local_12.member[1u];
                let _e526 = (((_e518[0] * _e407) + (_e518[1] * _e410)) + (_e518[2] * _e413));
                let _e529 = local_12.member[0u];
                if (_e529[0] < 0.0lf) {
                    phi_1471_ = -(_e529[0]);
                } else {
                    phi_1471_ = _e529[0];
                }
                let _e536 = phi_1471_;
                if (_e529[1] < 0.0lf) {
                    phi_1478_ = -(_e529[1]);
                } else {
                    phi_1478_ = _e529[1];
                }
                let _e540 = phi_1478_;
                if (_e536 > _e540) {
                    phi_1483_ = _e536;
                } else {
                    phi_1483_ = _e540;
                }
                let _e543 = phi_1483_;
                if (_e529[2] < 0.0lf) {
                    phi_1490_ = -(_e529[2]);
                } else {
                    phi_1490_ = _e529[2];
                }
                let _e547 = phi_1490_;
                if (_e543 > _e547) {
                    phi_1495_ = _e543;
                } else {
                    phi_1495_ = _e547;
                }
                let _e550 = phi_1495_;
                let _e553 = local_12.member[1u];
                if (_e553[0] < 0.0lf) {
                    phi_1508_ = -(_e553[0]);
                } else {
                    phi_1508_ = _e553[0];
                }
                let _e560 = phi_1508_;
                if (_e553[1] < 0.0lf) {
                    phi_1515_ = -(_e553[1]);
                } else {
                    phi_1515_ = _e553[1];
                }
                let _e564 = phi_1515_;
                if (_e560 > _e564) {
                    phi_1520_ = _e560;
                } else {
                    phi_1520_ = _e564;
                }
                let _e567 = phi_1520_;
                if (_e553[2] < 0.0lf) {
                    phi_1527_ = -(_e553[2]);
                } else {
                    phi_1527_ = _e553[2];
                }
                let _e571 = phi_1527_;
                if (_e567 > _e571) {
                    phi_1532_ = _e567;
                } else {
                    phi_1532_ = _e571;
                }
                let _e574 = phi_1532_;
                if (_e550 > _e574) {
                    phi_1537_ = _e550;
                } else {
                    phi_1537_ = _e574;
                }
                let _e577 = phi_1537_;
                let _e579 = local_12.member_3;
                let _e580 = (_e577 + _e579);
                let _e583 = local_12.member_1[0u];
                if (_e583[0] < 0.0lf) {
                    phi_1554_ = -(_e583[0]);
                } else {
                    phi_1554_ = _e583[0];
                }
                let _e590 = phi_1554_;
                if (_e583[1] < 0.0lf) {
                    phi_1561_ = -(_e583[1]);
                } else {
                    phi_1561_ = _e583[1];
                }
                let _e594 = phi_1561_;
                if (_e590 > _e594) {
                    phi_1566_ = _e590;
                } else {
                    phi_1566_ = _e594;
                }
                let _e597 = phi_1566_;
                if (_e583[2] < 0.0lf) {
                    phi_1573_ = -(_e583[2]);
                } else {
                    phi_1573_ = _e583[2];
                }
                let _e601 = phi_1573_;
                if (_e597 > _e601) {
                    phi_1578_ = _e597;
                } else {
                    phi_1578_ = _e601;
                }
                let _e604 = phi_1578_;
                let _e607 = local_12.member_1[1u];
                if (_e607[0] < 0.0lf) {
                    phi_1592_ = -(_e607[0]);
                } else {
                    phi_1592_ = _e607[0];
                }
                let _e614 = phi_1592_;
                if (_e607[1] < 0.0lf) {
                    phi_1599_ = -(_e607[1]);
                } else {
                    phi_1599_ = _e607[1];
                }
                let _e618 = phi_1599_;
                if (_e614 > _e618) {
                    phi_1604_ = _e614;
                } else {
                    phi_1604_ = _e618;
                }
                let _e621 = phi_1604_;
                if (_e607[2] < 0.0lf) {
                    phi_1611_ = -(_e607[2]);
                } else {
                    phi_1611_ = _e607[2];
                }
                let _e625 = phi_1611_;
                if (_e621 > _e625) {
                    phi_1616_ = _e621;
                } else {
                    phi_1616_ = _e625;
                }
                let _e628 = phi_1616_;
                if (_e604 > _e628) {
                    phi_1621_ = _e604;
                } else {
                    phi_1621_ = _e628;
                }
                let _e631 = phi_1621_;
                let _e633 = local_12.member_3;
                let _e634 = (_e631 + _e633);
                let _e637 = local_12.member_2[0u];
                if (_e637[0] < 0.0lf) {
                    phi_1638_ = -(_e637[0]);
                } else {
                    phi_1638_ = _e637[0];
                }
                let _e644 = phi_1638_;
                if (_e637[1] < 0.0lf) {
                    phi_1645_ = -(_e637[1]);
                } else {
                    phi_1645_ = _e637[1];
                }
                let _e648 = phi_1645_;
                if (_e644 > _e648) {
                    phi_1650_ = _e644;
                } else {
                    phi_1650_ = _e648;
                }
                let _e651 = phi_1650_;
                if (_e637[2] < 0.0lf) {
                    phi_1657_ = -(_e637[2]);
                } else {
                    phi_1657_ = _e637[2];
                }
                let _e655 = phi_1657_;
                if (_e651 > _e655) {
                    phi_1662_ = _e651;
                } else {
                    phi_1662_ = _e655;
                }
                let _e658 = phi_1662_;
                let _e661 = local_12.member_2[1u];
                if (_e661[0] < 0.0lf) {
                    phi_1676_ = -(_e661[0]);
                } else {
                    phi_1676_ = _e661[0];
                }
                let _e668 = phi_1676_;
                if (_e661[1] < 0.0lf) {
                    phi_1683_ = -(_e661[1]);
                } else {
                    phi_1683_ = _e661[1];
                }
                let _e672 = phi_1683_;
                if (_e668 > _e672) {
                    phi_1688_ = _e668;
                } else {
                    phi_1688_ = _e672;
                }
                let _e675 = phi_1688_;
                if (_e661[2] < 0.0lf) {
                    phi_1695_ = -(_e661[2]);
                } else {
                    phi_1695_ = _e661[2];
                }
                let _e679 = phi_1695_;
                if (_e675 > _e679) {
                    phi_1700_ = _e675;
                } else {
                    phi_1700_ = _e679;
                }
                let _e682 = phi_1700_;
                if (_e658 > _e682) {
                    phi_1705_ = _e658;
                } else {
                    phi_1705_ = _e682;
                }
                let _e685 = phi_1705_;
                let _e687 = local_12.member_3;
                let _e688 = (_e685 + _e687);
                let _e689 = f64(1f);
                let _e690 = f64(8f);
                let _e692 = ((_e634 * _e690) * _e688);
                let _e700 = local_12.member_3;
                if (_e386 < 0.0lf) {
                    phi_1742_ = -(_e386);
                } else {
                    phi_1742_ = _e386;
                }
                let _e720 = phi_1742_;
                if (_e389 < 0.0lf) {
                    phi_1748_ = -(_e389);
                } else {
                    phi_1748_ = _e389;
                }
                let _e724 = phi_1748_;
                if (_e392 < 0.0lf) {
                    phi_1755_ = -(_e392);
                } else {
                    phi_1755_ = _e392;
                }
                let _e729 = phi_1755_;
                let _e730 = ((_e720 + _e724) + _e729);
                if (_e407 < 0.0lf) {
                    phi_1762_ = -(_e407);
                } else {
                    phi_1762_ = _e407;
                }
                let _e734 = phi_1762_;
                if (_e410 < 0.0lf) {
                    phi_1768_ = -(_e410);
                } else {
                    phi_1768_ = _e410;
                }
                let _e738 = phi_1768_;
                if (_e413 < 0.0lf) {
                    phi_1775_ = -(_e413);
                } else {
                    phi_1775_ = _e413;
                }
                let _e743 = phi_1775_;
                let _e744 = ((_e734 + _e738) + _e743);
                if (_e730 > _e744) {
                    phi_1781_ = _e730;
                } else {
                    phi_1781_ = _e744;
                }
                let _e747 = phi_1781_;
                if (_e456 < 0.0lf) {
                    phi_1787_ = -(_e456);
                } else {
                    phi_1787_ = _e456;
                }
                let _e751 = phi_1787_;
                if (_e457 < 0.0lf) {
                    phi_1793_ = -(_e457);
                } else {
                    phi_1793_ = _e457;
                }
                let _e755 = phi_1793_;
                if (_e458 < 0.0lf) {
                    phi_1800_ = -(_e458);
                } else {
                    phi_1800_ = _e458;
                }
                let _e760 = phi_1800_;
                let _e762 = (((_e751 + _e755) + _e760) * f64(0.5f));
                if (_e747 > _e762) {
                    phi_1807_ = _e747;
                } else {
                    phi_1807_ = _e762;
                }
                let _e765 = phi_1807_;
                let _e771 = local_12.member_3;
                let _e785 = (((((_e580 * _e690) * _e692) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e700 * f64(19f)) * ((_e580 * (_e634 + _e688)) + (_e634 * _e688)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e689 + _e580) * ((_e689 + _e634) * (_e689 + _e688)))));
                let _e786 = f64(3f);
                let _e787 = (_e469 * _e786);
                let _e788 = (_e526 * _e786);
                if (_e787 < _e788) {
                    phi_1835_ = _e787;
                } else {
                    phi_1835_ = _e788;
                }
                let _e791 = phi_1835_;
                if (_e492 < _e515) {
                    phi_1840_ = _e492;
                } else {
                    phi_1840_ = _e515;
                }
                let _e794 = phi_1840_;
                if (_e791 < _e794) {
                    phi_1845_ = _e791;
                } else {
                    phi_1845_ = _e794;
                }
                let _e797 = phi_1845_;
                if (_e787 > _e788) {
                    phi_1850_ = _e787;
                } else {
                    phi_1850_ = _e788;
                }
                let _e800 = phi_1850_;
                if (_e492 > _e515) {
                    phi_1855_ = _e492;
                } else {
                    phi_1855_ = _e515;
                }
                let _e803 = phi_1855_;
                if (_e800 > _e803) {
                    phi_1860_ = _e800;
                } else {
                    phi_1860_ = _e803;
                }
                let _e806 = phi_1860_;
                let _e812 = -(_e806);
                if (_e797 > _e812) {
                    phi_1871_ = _e797;
                } else {
                    phi_1871_ = _e812;
                }
                let _e815 = phi_1871_;
                if ((_e815 - (_e785 + ((_e370 * (((_e765 + (_e692 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e771 * f64(6f)) * (_e634 + _e688))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e689 + _e634) * (_e689 + _e688))))) * f64((3f * 1.0001f))))) > _e371) {
                    phi_6328_ = type_40(0u, type_40().member_1);
                } else {
                    if (_e370 > _e371) {
                        let _e2904 = f64(1f);
                        let _e2908 = local_12.member[0u];
                        let _e2914 = local_12.member_1[0u];
                        let _e2920 = local_12.member_2[0u];
                        local_9 = array<array<f64, 3>, 4>(_e2908, array<f64, 3>((_e2908[0] - _e2914[0]), (_e2908[1] - _e2914[1]), (_e2908[2] - _e2914[2])), array<f64, 3>((_e2908[0] - _e2920[0]), (_e2908[1] - _e2920[1]), (_e2908[2] - _e2920[2])), _e2908);
                        let _e2935 = local_12.member[1u];
                        let _e2941 = local_12.member_1[1u];
                        let _e2947 = local_12.member_2[1u];
                        local_10 = array<array<f64, 3>, 4>(_e2935, array<f64, 3>((_e2935[0] - _e2941[0]), (_e2935[1] - _e2941[1]), (_e2935[2] - _e2941[2])), array<f64, 3>((_e2935[0] - _e2947[0]), (_e2935[1] - _e2947[1]), (_e2935[2] - _e2947[2])), _e2935);
                        let _e2962 = local_12.member[0u];
                        if (_e2962[0] < 0.0lf) {
                            phi_2074_ = -(_e2962[0]);
                        } else {
                            phi_2074_ = _e2962[0];
                        }
                        let _e2969 = phi_2074_;
                        if (_e2962[1] < 0.0lf) {
                            phi_2081_ = -(_e2962[1]);
                        } else {
                            phi_2081_ = _e2962[1];
                        }
                        let _e2973 = phi_2081_;
                        if (_e2969 > _e2973) {
                            phi_2086_ = _e2969;
                        } else {
                            phi_2086_ = _e2973;
                        }
                        let _e2976 = phi_2086_;
                        if (_e2962[2] < 0.0lf) {
                            phi_2093_ = -(_e2962[2]);
                        } else {
                            phi_2093_ = _e2962[2];
                        }
                        let _e2980 = phi_2093_;
                        if (_e2976 > _e2980) {
                            phi_2098_ = _e2976;
                        } else {
                            phi_2098_ = _e2980;
                        }
                        let _e2983 = phi_2098_;
                        let _e2986 = local_12.member[1u];
                        if (_e2986[0] < 0.0lf) {
                            phi_2111_ = -(_e2986[0]);
                        } else {
                            phi_2111_ = _e2986[0];
                        }
                        let _e2993 = phi_2111_;
                        if (_e2986[1] < 0.0lf) {
                            phi_2118_ = -(_e2986[1]);
                        } else {
                            phi_2118_ = _e2986[1];
                        }
                        let _e2997 = phi_2118_;
                        if (_e2993 > _e2997) {
                            phi_2123_ = _e2993;
                        } else {
                            phi_2123_ = _e2997;
                        }
                        let _e3000 = phi_2123_;
                        if (_e2986[2] < 0.0lf) {
                            phi_2130_ = -(_e2986[2]);
                        } else {
                            phi_2130_ = _e2986[2];
                        }
                        let _e3004 = phi_2130_;
                        if (_e3000 > _e3004) {
                            phi_2135_ = _e3000;
                        } else {
                            phi_2135_ = _e3004;
                        }
                        let _e3007 = phi_2135_;
                        if (_e2983 > _e3007) {
                            phi_2140_ = _e2983;
                        } else {
                            phi_2140_ = _e3007;
                        }
                        let _e3010 = phi_2140_;
                        let _e3012 = local_12.member_3;
                        let _e3016 = local_12.member_1[0u];
                        if (_e3016[0] < 0.0lf) {
                            phi_2157_ = -(_e3016[0]);
                        } else {
                            phi_2157_ = _e3016[0];
                        }
                        let _e3023 = phi_2157_;
                        if (_e3016[1] < 0.0lf) {
                            phi_2164_ = -(_e3016[1]);
                        } else {
                            phi_2164_ = _e3016[1];
                        }
                        let _e3027 = phi_2164_;
                        if (_e3023 > _e3027) {
                            phi_2169_ = _e3023;
                        } else {
                            phi_2169_ = _e3027;
                        }
                        let _e3030 = phi_2169_;
                        if (_e3016[2] < 0.0lf) {
                            phi_2176_ = -(_e3016[2]);
                        } else {
                            phi_2176_ = _e3016[2];
                        }
                        let _e3034 = phi_2176_;
                        if (_e3030 > _e3034) {
                            phi_2181_ = _e3030;
                        } else {
                            phi_2181_ = _e3034;
                        }
                        let _e3037 = phi_2181_;
                        let _e3040 = local_12.member_1[1u];
                        if (_e3040[0] < 0.0lf) {
                            phi_2195_ = -(_e3040[0]);
                        } else {
                            phi_2195_ = _e3040[0];
                        }
                        let _e3047 = phi_2195_;
                        if (_e3040[1] < 0.0lf) {
                            phi_2202_ = -(_e3040[1]);
                        } else {
                            phi_2202_ = _e3040[1];
                        }
                        let _e3051 = phi_2202_;
                        if (_e3047 > _e3051) {
                            phi_2207_ = _e3047;
                        } else {
                            phi_2207_ = _e3051;
                        }
                        let _e3054 = phi_2207_;
                        if (_e3040[2] < 0.0lf) {
                            phi_2214_ = -(_e3040[2]);
                        } else {
                            phi_2214_ = _e3040[2];
                        }
                        let _e3058 = phi_2214_;
                        if (_e3054 > _e3058) {
                            phi_2219_ = _e3054;
                        } else {
                            phi_2219_ = _e3058;
                        }
                        let _e3061 = phi_2219_;
                        if (_e3037 > _e3061) {
                            phi_2224_ = _e3037;
                        } else {
                            phi_2224_ = _e3061;
                        }
                        let _e3064 = phi_2224_;
                        let _e3066 = local_12.member_3;
                        let _e3070 = local_12.member_2[0u];
                        if (_e3070[0] < 0.0lf) {
                            phi_2241_ = -(_e3070[0]);
                        } else {
                            phi_2241_ = _e3070[0];
                        }
                        let _e3077 = phi_2241_;
                        if (_e3070[1] < 0.0lf) {
                            phi_2248_ = -(_e3070[1]);
                        } else {
                            phi_2248_ = _e3070[1];
                        }
                        let _e3081 = phi_2248_;
                        if (_e3077 > _e3081) {
                            phi_2253_ = _e3077;
                        } else {
                            phi_2253_ = _e3081;
                        }
                        let _e3084 = phi_2253_;
                        if (_e3070[2] < 0.0lf) {
                            phi_2260_ = -(_e3070[2]);
                        } else {
                            phi_2260_ = _e3070[2];
                        }
                        let _e3088 = phi_2260_;
                        if (_e3084 > _e3088) {
                            phi_2265_ = _e3084;
                        } else {
                            phi_2265_ = _e3088;
                        }
                        let _e3091 = phi_2265_;
                        let _e3094 = local_12.member_2[1u];
                        if (_e3094[0] < 0.0lf) {
                            phi_2279_ = -(_e3094[0]);
                        } else {
                            phi_2279_ = _e3094[0];
                        }
                        let _e3101 = phi_2279_;
                        if (_e3094[1] < 0.0lf) {
                            phi_2286_ = -(_e3094[1]);
                        } else {
                            phi_2286_ = _e3094[1];
                        }
                        let _e3105 = phi_2286_;
                        if (_e3101 > _e3105) {
                            phi_2291_ = _e3101;
                        } else {
                            phi_2291_ = _e3105;
                        }
                        let _e3108 = phi_2291_;
                        if (_e3094[2] < 0.0lf) {
                            phi_2298_ = -(_e3094[2]);
                        } else {
                            phi_2298_ = _e3094[2];
                        }
                        let _e3112 = phi_2298_;
                        if (_e3108 > _e3112) {
                            phi_2303_ = _e3108;
                        } else {
                            phi_2303_ = _e3112;
                        }
                        let _e3115 = phi_2303_;
                        if (_e3091 > _e3115) {
                            phi_2308_ = _e3091;
                        } else {
                            phi_2308_ = _e3115;
                        }
                        let _e3118 = phi_2308_;
                        let _e3120 = local_12.member_3;
                        let _e3128 = local_12.member_3;
                        phi_2328_ = type_19(0u, 48u);
                        phi_2331_ = f64(0f);
                        loop {
                            let _e3137 = phi_2328_;
                            let _e3139 = phi_2331_;
                            local_77 = _e3139;
                            local_37 = _e3139;
                            local_38 = _e3139;
                            local_39 = _e3139;
                            local_40 = _e3139;
                            if (_e3137.member < _e3137.member_1) {
                                phi_2329_ = type_19((_e3137.member + 1u), _e3137.member_1);
                                phi_2354_ = type_19(1u, _e3137.member);
                            } else {
                                phi_2329_ = _e3137;
                                phi_2354_ = type_19(0u, type_19().member_1);
                            }
                            let _e3151 = phi_2329_;
                            let _e3153 = phi_2354_;
                            if (bitcast<i32>(_e3153.member) != 0i) {
                                let _e3159 = local_12.member[0u];
                                let _e3165 = local_12.member[1u];
                                let _e3181 = local_12.member_1[0u];
                                let _e3187 = local_12.member_1[1u];
                                let _e3203 = local_12.member_2[0u];
                                let _e3209 = local_12.member_2[1u];
                                let _e3223 = function_2(array<f64, 3>((_e3159[0] + ((_e3165[0] - _e3159[0]) * _e3139)), (_e3159[1] + ((_e3165[1] - _e3159[1]) * _e3139)), (_e3159[2] + ((_e3165[2] - _e3159[2]) * _e3139))), array<f64, 3>((_e3181[0] + ((_e3187[0] - _e3181[0]) * _e3139)), (_e3181[1] + ((_e3187[1] - _e3181[1]) * _e3139)), (_e3181[2] + ((_e3187[2] - _e3181[2]) * _e3139))), array<f64, 3>((_e3203[0] + ((_e3209[0] - _e3203[0]) * _e3139)), (_e3203[1] + ((_e3209[1] - _e3203[1]) * _e3139)), (_e3203[2] + ((_e3209[2] - _e3203[2]) * _e3139))), 0u);
                                if (_e3223[0] < 0.0lf) {
                                    phi_2465_ = -(_e3223[0]);
                                } else {
                                    phi_2465_ = _e3223[0];
                                }
                                let _e3228 = phi_2465_;
                                if (_e3223[1] < 0.0lf) {
                                    phi_2472_ = -(_e3223[1]);
                                } else {
                                    phi_2472_ = _e3223[1];
                                }
                                let _e3233 = phi_2472_;
                                if (_e3223[2] < 0.0lf) {
                                    phi_2480_ = -(_e3223[2]);
                                } else {
                                    phi_2480_ = _e3223[2];
                                }
                                let _e3239 = phi_2480_;
                                let _e3240 = ((_e3228 + _e3233) + _e3239);
                                if (_e3240 > f64(0f)) {
                                    if ((bitcast<u64>(_e3240) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e3246 = (f64(1f) / _e3240);
                                        let _e3248 = (_e3223[0] * _e3246);
                                        let _e3250 = (_e3223[1] * _e3246);
                                        let _e3252 = (_e3223[2] * _e3246);
                                        let _e3257 = (((_e3248 * _e3248) + (_e3250 * _e3250)) + (_e3252 * _e3252));
                                        if (_e3257 <= 2.2250738585072014e-308lf) {
                                            if (_e3257 > 0.0lf) {
                                                phi_2518_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2518_ = 0.0lf;
                                            }
                                            let _e3309 = phi_2518_;
                                            phi_2582_ = _e3309;
                                        } else {
                                            phi_2525_ = type_17(0i, 5i);
                                            phi_2528_ = bitcast<f64>(((bitcast<u64>(_e3257) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3264 = phi_2525_;
                                                let _e3266 = phi_2528_;
                                                local_31 = _e3266;
                                                if (_e3264.member < _e3264.member_1) {
                                                    let _e3273 = (_e3264.member + 1i);
                                                    if ((false == (_e3273 > _e3264.member)) != false) {
                                                        phi_2549_ = true;
                                                    } else {
                                                        phi_2549_ = false;
                                                    }
                                                    let _e3278 = phi_2549_;
                                                    if _e3278 {
                                                        phi_2555_ = type_18(0u, type_18().member_1);
                                                    } else {
                                                        phi_2555_ = type_18(1u, _e3273);
                                                    }
                                                    let _e3283 = phi_2555_;
                                                    phi_2526_ = type_17(_e3283.member_1, _e3264.member_1);
                                                    phi_2569_ = type_18(1u, _e3264.member);
                                                } else {
                                                    phi_2526_ = _e3264;
                                                    phi_2569_ = type_18(0u, type_18().member_1);
                                                }
                                                let _e3289 = phi_2526_;
                                                let _e3291 = phi_2569_;
                                                let _e3294 = (bitcast<i32>(_e3291.member) != 0i);
                                                if _e3294 {
                                                    phi_2529_ = (0.5lf * (_e3266 + (_e3257 / _e3266)));
                                                } else {
                                                    phi_2529_ = f64();
                                                }
                                                let _e3299 = phi_2529_;
                                                continue;
                                                continuing {
                                                    phi_2525_ = _e3289;
                                                    phi_2528_ = _e3299;
                                                    break if !(_e3294);
                                                }
                                            }
                                            let _e3304 = local_31;
                                            phi_2582_ = (_e3304 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e3311 = phi_2582_;
                                        phi_2595_ = type_19(0u, 4u);
                                        phi_2598_ = f64(2f);
                                        loop {
                                            let _e3323 = phi_2595_;
                                            let _e3325 = phi_2598_;
                                            local_33 = _e3325;
                                            local_34 = _e3325;
                                            local_35 = _e3325;
                                            local_67 = _e3325;
                                            local_68 = _e3325;
                                            if (_e3323.member < _e3323.member_1) {
                                                phi_2596_ = type_19((_e3323.member + 1u), _e3323.member_1);
                                                phi_2621_ = type_19(1u, _e3323.member);
                                            } else {
                                                phi_2596_ = _e3323;
                                                phi_2621_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e3337 = phi_2596_;
                                            let _e3339 = phi_2621_;
                                            if (bitcast<i32>(_e3339.member) != 0i) {
                                                let _e3345 = local_9[_e3339.member_1];
                                                let _e3353 = (((_e3248 * _e3345[0]) + (_e3250 * _e3345[1])) + (_e3252 * _e3345[2]));
                                                let _e3355 = local_10[_e3339.member_1];
                                                let _e3363 = (((_e3248 * _e3355[0]) + (_e3250 * _e3355[1])) + (_e3252 * _e3355[2]));
                                                if (_e3353 < 0.0lf) {
                                                    phi_2672_ = -(_e3353);
                                                } else {
                                                    phi_2672_ = _e3353;
                                                }
                                                let _e3367 = phi_2672_;
                                                if (_e3363 < 0.0lf) {
                                                    phi_2678_ = -(_e3363);
                                                } else {
                                                    phi_2678_ = _e3363;
                                                }
                                                let _e3371 = phi_2678_;
                                                let _e3376 = (((((((((_e3010 + _e3012) + (_e3064 + _e3066)) + (_e3118 + _e3120)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3128 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e370 * _e3311) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e3367 + _e3371) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e3353 > _e3376) {
                                                    if (_e3363 > _e3376) {
                                                        phi_2692_ = false;
                                                    } else {
                                                        phi_2692_ = true;
                                                    }
                                                    let _e3380 = phi_2692_;
                                                    phi_2693_ = _e3380;
                                                } else {
                                                    phi_2693_ = true;
                                                }
                                                let _e3382 = phi_2693_;
                                                if _e3382 {
                                                    if ((_e3353 + ((_e3363 - _e3353) * _e3139)) > _e3376) {
                                                        if (_e3363 < _e3353) {
                                                            let _e3391 = ((_e3353 - _e3363) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                            if _e3391 {
                                                                let _e3399 = (((_e3353 - _e3376) / (_e3353 - _e3363)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                if (_e3325 < _e3399) {
                                                                    phi_2727_ = _e3325;
                                                                } else {
                                                                    phi_2727_ = _e3399;
                                                                }
                                                                let _e3402 = phi_2727_;
                                                                phi_2728_ = _e3402;
                                                            } else {
                                                                phi_2728_ = f64();
                                                            }
                                                            let _e3404 = phi_2728_;
                                                            phi_2729_ = _e3404;
                                                            phi_2730_ = _e3391;
                                                        } else {
                                                            phi_2729_ = _e3325;
                                                            phi_2730_ = true;
                                                        }
                                                        let _e3406 = phi_2729_;
                                                        let _e3408 = phi_2730_;
                                                        if _e3408 {
                                                            phi_2734_ = false;
                                                        } else {
                                                            phi_2734_ = true;
                                                        }
                                                        let _e3410 = phi_2734_;
                                                        phi_2735_ = _e3406;
                                                        phi_2736_ = _e3408;
                                                        phi_2737_ = _e3410;
                                                        phi_2738_ = false;
                                                    } else {
                                                        phi_2735_ = f64();
                                                        phi_2736_ = false;
                                                        phi_2737_ = false;
                                                        phi_2738_ = true;
                                                    }
                                                    let _e3412 = phi_2735_;
                                                    let _e3414 = phi_2736_;
                                                    let _e3416 = phi_2737_;
                                                    let _e3418 = phi_2738_;
                                                    phi_2739_ = _e3412;
                                                    phi_2740_ = _e3414;
                                                    phi_2741_ = _e3416;
                                                    phi_2742_ = _e3418;
                                                } else {
                                                    phi_2739_ = _e3325;
                                                    phi_2740_ = true;
                                                    phi_2741_ = false;
                                                    phi_2742_ = false;
                                                }
                                                let _e3420 = phi_2739_;
                                                let _e3422 = phi_2740_;
                                                let _e3424 = phi_2741_;
                                                let _e3426 = phi_2742_;
                                                phi_2599_ = _e3420;
                                                phi_2743_ = _e3422;
                                                phi_2744_ = false;
                                                phi_2745_ = _e3424;
                                                phi_2746_ = _e3426;
                                            } else {
                                                phi_2599_ = f64();
                                                phi_2743_ = false;
                                                phi_2744_ = true;
                                                phi_2745_ = false;
                                                phi_2746_ = false;
                                            }
                                            let _e3428 = phi_2599_;
                                            let _e3430 = phi_2743_;
                                            let _e3432 = phi_2744_;
                                            let _e3434 = phi_2745_;
                                            let _e3436 = phi_2746_;
                                            local_32 = _e3432;
                                            local_65 = _e3434;
                                            local_66 = _e3436;
                                            continue;
                                            continuing {
                                                phi_2595_ = _e3337;
                                                phi_2598_ = _e3428;
                                                break if !(_e3430);
                                            }
                                        }
                                        let _e3439 = local_32;
                                        if _e3439 {
                                            let _e3441 = local_33;
                                            let _e3442 = (_e3441 > _e2904);
                                            if _e3442 {
                                                phi_2768_ = false;
                                                phi_2769_ = false;
                                                phi_2770_ = false;
                                            } else {
                                                let _e3444 = local_34;
                                                if (_e3444 > _e3139) {
                                                    let _e3447 = local_35;
                                                    let _e3450 = ((_e3447 - _e3139) < f64(0.00000000023283064f));
                                                    if _e3450 {
                                                        phi_2764_ = false;
                                                    } else {
                                                        phi_2764_ = true;
                                                    }
                                                    let _e3452 = phi_2764_;
                                                    phi_2765_ = _e3452;
                                                    phi_2766_ = _e3450;
                                                    phi_2767_ = false;
                                                } else {
                                                    phi_2765_ = false;
                                                    phi_2766_ = false;
                                                    phi_2767_ = true;
                                                }
                                                let _e3454 = phi_2765_;
                                                let _e3456 = phi_2766_;
                                                let _e3458 = phi_2767_;
                                                phi_2768_ = _e3454;
                                                phi_2769_ = _e3456;
                                                phi_2770_ = _e3458;
                                            }
                                            let _e3460 = phi_2768_;
                                            let _e3462 = phi_2769_;
                                            let _e3464 = phi_2770_;
                                            phi_2771_ = _e3460;
                                            phi_2772_ = _e3442;
                                            phi_2773_ = _e3462;
                                            phi_2774_ = _e3464;
                                            phi_2775_ = false;
                                            phi_2776_ = false;
                                        } else {
                                            phi_2771_ = false;
                                            phi_2772_ = false;
                                            phi_2773_ = false;
                                            phi_2774_ = false;
                                            let _e4736 = local_65;
                                            phi_2775_ = _e4736;
                                            let _e4739 = local_66;
                                            phi_2776_ = _e4739;
                                        }
                                        let _e3466 = phi_2771_;
                                        let _e3468 = phi_2772_;
                                        let _e3470 = phi_2773_;
                                        let _e3472 = phi_2774_;
                                        let _e3474 = phi_2775_;
                                        let _e3476 = phi_2776_;
                                        let _e4742 = local_67;
                                        phi_2777_ = _e4742;
                                        let _e4745 = local_68;
                                        phi_2778_ = _e4745;
                                        phi_2779_ = _e3466;
                                        phi_2780_ = _e3468;
                                        phi_2781_ = _e3470;
                                        phi_2782_ = _e3472;
                                        phi_2783_ = _e3474;
                                        phi_2784_ = _e3476;
                                        phi_2785_ = false;
                                    } else {
                                        phi_2777_ = f64();
                                        phi_2778_ = f64();
                                        phi_2779_ = false;
                                        phi_2780_ = false;
                                        phi_2781_ = false;
                                        phi_2782_ = false;
                                        phi_2783_ = false;
                                        phi_2784_ = false;
                                        phi_2785_ = true;
                                    }
                                    let _e3478 = phi_2777_;
                                    let _e3480 = phi_2778_;
                                    let _e3482 = phi_2779_;
                                    let _e3484 = phi_2780_;
                                    let _e3486 = phi_2781_;
                                    let _e3488 = phi_2782_;
                                    let _e3490 = phi_2783_;
                                    let _e3492 = phi_2784_;
                                    let _e3494 = phi_2785_;
                                    phi_2786_ = _e3478;
                                    phi_2787_ = _e3480;
                                    phi_2788_ = _e3482;
                                    phi_2789_ = _e3484;
                                    phi_2790_ = _e3486;
                                    phi_2791_ = _e3488;
                                    phi_2792_ = _e3490;
                                    phi_2793_ = _e3492;
                                    phi_2794_ = _e3494;
                                    phi_2795_ = false;
                                } else {
                                    phi_2786_ = f64();
                                    phi_2787_ = f64();
                                    phi_2788_ = false;
                                    phi_2789_ = false;
                                    phi_2790_ = false;
                                    phi_2791_ = false;
                                    phi_2792_ = false;
                                    phi_2793_ = false;
                                    phi_2794_ = false;
                                    phi_2795_ = true;
                                }
                                let _e3496 = phi_2786_;
                                let _e3498 = phi_2787_;
                                let _e3500 = phi_2788_;
                                let _e3502 = phi_2789_;
                                let _e3504 = phi_2790_;
                                let _e3506 = phi_2791_;
                                let _e3508 = phi_2792_;
                                let _e3510 = phi_2793_;
                                let _e3512 = phi_2794_;
                                let _e3514 = phi_2795_;
                                phi_2796_ = _e3496;
                                phi_2332_ = _e3498;
                                phi_2797_ = _e3500;
                                phi_2798_ = _e3502;
                                phi_2799_ = _e3504;
                                phi_2800_ = false;
                                phi_2801_ = _e3506;
                                phi_2802_ = _e3508;
                                phi_2803_ = _e3510;
                                phi_2804_ = _e3512;
                                phi_2805_ = _e3514;
                            } else {
                                phi_2796_ = f64();
                                phi_2332_ = f64();
                                phi_2797_ = false;
                                phi_2798_ = false;
                                phi_2799_ = false;
                                phi_2800_ = true;
                                phi_2801_ = false;
                                phi_2802_ = false;
                                phi_2803_ = false;
                                phi_2804_ = false;
                                phi_2805_ = false;
                            }
                            let _e3516 = phi_2796_;
                            let _e3518 = phi_2332_;
                            let _e3520 = phi_2797_;
                            let _e3522 = phi_2798_;
                            let _e3524 = phi_2799_;
                            let _e3526 = phi_2800_;
                            let _e3528 = phi_2801_;
                            let _e3530 = phi_2802_;
                            let _e3532 = phi_2803_;
                            let _e3534 = phi_2804_;
                            let _e3536 = phi_2805_;
                            local_36 = _e3522;
                            local_69 = _e3524;
                            local_70 = _e3526;
                            local_71 = _e3528;
                            local_72 = _e3530;
                            local_73 = _e3532;
                            local_74 = _e3534;
                            local_75 = _e3536;
                            local_76 = _e3516;
                            local_78 = _e3522;
                            continue;
                            continuing {
                                phi_2328_ = _e3151;
                                phi_2331_ = _e3518;
                                break if !(_e3520);
                            }
                        }
                        let _e3539 = local_36;
                        if _e3539 {
                            phi_2810_ = type_40(0u, type_40().member_1);
                            phi_2811_ = false;
                            phi_2812_ = false;
                            phi_2813_ = false;
                            phi_2814_ = false;
                            phi_2815_ = false;
                            phi_2816_ = false;
                            phi_2817_ = false;
                        } else {
                            phi_2810_ = type_40();
                            let _e4778 = local_69;
                            phi_2811_ = _e4778;
                            let _e4781 = local_70;
                            phi_2812_ = _e4781;
                            let _e4784 = local_71;
                            phi_2813_ = _e4784;
                            let _e4787 = local_72;
                            phi_2814_ = _e4787;
                            let _e4790 = local_73;
                            phi_2815_ = _e4790;
                            let _e4793 = local_74;
                            phi_2816_ = _e4793;
                            let _e4796 = local_75;
                            phi_2817_ = _e4796;
                        }
                        let _e3543 = phi_2810_;
                        let _e3545 = phi_2811_;
                        let _e3547 = phi_2812_;
                        let _e3549 = phi_2813_;
                        let _e3551 = phi_2814_;
                        let _e3553 = phi_2815_;
                        let _e3555 = phi_2816_;
                        let _e3557 = phi_2817_;
                        if _e3545 {
                            let _e4799 = local_76;
                            phi_2821_ = _e4799;
                            phi_2822_ = true;
                            phi_2823_ = false;
                            phi_2824_ = false;
                            phi_2825_ = false;
                            phi_2826_ = false;
                            phi_2827_ = false;
                            phi_2828_ = false;
                        } else {
                            let _e4801 = local_77;
                            phi_2821_ = _e4801;
                            phi_2822_ = _e3547;
                            phi_2823_ = _e3549;
                            phi_2824_ = _e3551;
                            phi_2825_ = _e3553;
                            let _e4808 = local_78;
                            phi_2826_ = _e4808;
                            phi_2827_ = _e3555;
                            phi_2828_ = _e3557;
                        }
                        let _e3559 = phi_2821_;
                        let _e3561 = phi_2822_;
                        let _e3563 = phi_2823_;
                        let _e3565 = phi_2824_;
                        let _e3567 = phi_2825_;
                        let _e3569 = phi_2826_;
                        let _e3571 = phi_2827_;
                        let _e3573 = phi_2828_;
                        if _e3561 {
                            phi_2833_ = type_40(1u, _e3559);
                            phi_2834_ = false;
                            phi_2835_ = false;
                            phi_2836_ = false;
                            phi_2837_ = false;
                            phi_2838_ = false;
                            phi_2839_ = false;
                        } else {
                            phi_2833_ = type_40();
                            phi_2834_ = _e3563;
                            phi_2835_ = _e3565;
                            phi_2836_ = _e3567;
                            phi_2837_ = _e3569;
                            phi_2838_ = _e3571;
                            phi_2839_ = _e3573;
                        }
                        let _e3576 = phi_2833_;
                        let _e3578 = phi_2834_;
                        let _e3580 = phi_2835_;
                        let _e3582 = phi_2836_;
                        let _e3584 = phi_2837_;
                        let _e3586 = phi_2838_;
                        let _e3588 = phi_2839_;
                        if _e3578 {
                            let _e3590 = local_37;
                            phi_2844_ = type_40(1u, _e3590);
                            phi_2845_ = false;
                            phi_2846_ = false;
                            phi_2847_ = true;
                            phi_2848_ = false;
                            phi_2849_ = false;
                        } else {
                            phi_2844_ = _e3543;
                            phi_2845_ = _e3580;
                            phi_2846_ = _e3582;
                            phi_2847_ = _e3584;
                            phi_2848_ = _e3586;
                            phi_2849_ = _e3588;
                        }
                        let _e3593 = phi_2844_;
                        let _e3595 = phi_2845_;
                        let _e3597 = phi_2846_;
                        let _e3599 = phi_2847_;
                        let _e3601 = phi_2848_;
                        let _e3603 = phi_2849_;
                        if _e3595 {
                            let _e3605 = local_38;
                            phi_2854_ = type_40(1u, _e3605);
                            phi_2855_ = false;
                            phi_2856_ = false;
                            phi_2857_ = false;
                            phi_2858_ = false;
                        } else {
                            phi_2854_ = type_40();
                            phi_2855_ = _e3597;
                            phi_2856_ = _e3599;
                            phi_2857_ = _e3601;
                            phi_2858_ = _e3603;
                        }
                        let _e3608 = phi_2854_;
                        let _e3610 = phi_2855_;
                        let _e3612 = phi_2856_;
                        let _e3614 = phi_2857_;
                        let _e3616 = phi_2858_;
                        if _e3610 {
                            let _e3618 = local_39;
                            phi_2863_ = type_40(1u, _e3618);
                            phi_2864_ = true;
                            phi_2865_ = false;
                            phi_2866_ = false;
                            phi_2867_ = false;
                        } else {
                            phi_2863_ = _e3608;
                            phi_2864_ = _e3595;
                            phi_2865_ = _e3612;
                            phi_2866_ = _e3614;
                            phi_2867_ = _e3616;
                        }
                        let _e3621 = phi_2863_;
                        let _e3623 = phi_2864_;
                        let _e3625 = phi_2865_;
                        let _e3627 = phi_2866_;
                        let _e3629 = phi_2867_;
                        if _e3623 {
                            phi_2871_ = _e3621;
                            phi_2872_ = true;
                            phi_2873_ = false;
                            phi_2874_ = false;
                        } else {
                            phi_2871_ = _e3593;
                            phi_2872_ = _e3625;
                            phi_2873_ = _e3627;
                            phi_2874_ = _e3629;
                        }
                        let _e3631 = phi_2871_;
                        let _e3633 = phi_2872_;
                        let _e3635 = phi_2873_;
                        let _e3637 = phi_2874_;
                        if _e3633 {
                            phi_2878_ = false;
                            phi_2879_ = false;
                        } else {
                            phi_2878_ = _e3635;
                            phi_2879_ = _e3637;
                        }
                        let _e3639 = phi_2878_;
                        let _e3641 = phi_2879_;
                        if _e3639 {
                            phi_2883_ = false;
                            phi_2884_ = false;
                        } else {
                            phi_2883_ = _e3641;
                            phi_2884_ = _e3633;
                        }
                        let _e3643 = phi_2883_;
                        let _e3645 = phi_2884_;
                        if _e3643 {
                            phi_2888_ = true;
                            phi_2889_ = false;
                        } else {
                            phi_2888_ = _e3639;
                            phi_2889_ = _e3645;
                        }
                        let _e3647 = phi_2888_;
                        let _e3649 = phi_2889_;
                        if _e3647 {
                            let _e3651 = local_40;
                            phi_2894_ = type_40(1u, _e3651);
                            phi_2895_ = true;
                        } else {
                            phi_2894_ = _e3631;
                            phi_2895_ = _e3649;
                        }
                        let _e3654 = phi_2894_;
                        let _e3656 = phi_2895_;
                        if _e3656 {
                            phi_2899_ = _e3654;
                        } else {
                            phi_2899_ = _e3576;
                        }
                        let _e3658 = phi_2899_;
                        if (_e3658.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_2913_ = type_19(0u, 3u);
                            loop {
                                let _e3670 = phi_2913_;
                                if (_e3670.member < _e3670.member_1) {
                                    phi_2914_ = type_19((_e3670.member + 1u), _e3670.member_1);
                                    phi_2937_ = type_19(1u, _e3670.member);
                                } else {
                                    phi_2914_ = _e3670;
                                    phi_2937_ = type_19(0u, type_19().member_1);
                                }
                                let _e3682 = phi_2914_;
                                let _e3684 = phi_2937_;
                                if (bitcast<i32>(_e3684.member) != 0i) {
                                    let _e3690 = local_11[_e3684.member_1];
                                    let _e3692 = (_e3658.member_1 + f64(_e3690));
                                    if (_e3692 < _e2904) {
                                        phi_2958_ = _e3692;
                                    } else {
                                        phi_2958_ = _e2904;
                                    }
                                    let _e3695 = phi_2958_;
                                    let _e3698 = local_12.member[0u];
                                    let _e3704 = local_12.member[1u];
                                    let _e3720 = local_12.member_1[0u];
                                    let _e3726 = local_12.member_1[1u];
                                    let _e3742 = local_12.member_2[0u];
                                    let _e3748 = local_12.member_2[1u];
                                    let _e3762 = function_2(array<f64, 3>((_e3698[0] + ((_e3704[0] - _e3698[0]) * _e3695)), (_e3698[1] + ((_e3704[1] - _e3698[1]) * _e3695)), (_e3698[2] + ((_e3704[2] - _e3698[2]) * _e3695))), array<f64, 3>((_e3720[0] + ((_e3726[0] - _e3720[0]) * _e3695)), (_e3720[1] + ((_e3726[1] - _e3720[1]) * _e3695)), (_e3720[2] + ((_e3726[2] - _e3720[2]) * _e3695))), array<f64, 3>((_e3742[0] + ((_e3748[0] - _e3742[0]) * _e3695)), (_e3742[1] + ((_e3748[1] - _e3742[1]) * _e3695)), (_e3742[2] + ((_e3748[2] - _e3742[2]) * _e3695))), 0u);
                                    let _e3773 = (((_e3762[0] * _e3762[0]) + (_e3762[1] * _e3762[1])) + (_e3762[2] * _e3762[2]));
                                    if (_e3773 <= 2.2250738585072014e-308lf) {
                                        if (_e3773 > 0.0lf) {
                                            phi_3081_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3081_ = 0.0lf;
                                        }
                                        let _e3825 = phi_3081_;
                                        phi_3145_ = _e3825;
                                    } else {
                                        phi_3088_ = type_17(0i, 5i);
                                        phi_3091_ = bitcast<f64>(((bitcast<u64>(_e3773) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e3780 = phi_3088_;
                                            let _e3782 = phi_3091_;
                                            local_41 = _e3782;
                                            if (_e3780.member < _e3780.member_1) {
                                                let _e3789 = (_e3780.member + 1i);
                                                if ((false == (_e3789 > _e3780.member)) != false) {
                                                    phi_3112_ = true;
                                                } else {
                                                    phi_3112_ = false;
                                                }
                                                let _e3794 = phi_3112_;
                                                if _e3794 {
                                                    phi_3118_ = type_18(0u, type_18().member_1);
                                                } else {
                                                    phi_3118_ = type_18(1u, _e3789);
                                                }
                                                let _e3799 = phi_3118_;
                                                phi_3089_ = type_17(_e3799.member_1, _e3780.member_1);
                                                phi_3132_ = type_18(1u, _e3780.member);
                                            } else {
                                                phi_3089_ = _e3780;
                                                phi_3132_ = type_18(0u, type_18().member_1);
                                            }
                                            let _e3805 = phi_3089_;
                                            let _e3807 = phi_3132_;
                                            let _e3810 = (bitcast<i32>(_e3807.member) != 0i);
                                            if _e3810 {
                                                phi_3092_ = (0.5lf * (_e3782 + (_e3773 / _e3782)));
                                            } else {
                                                phi_3092_ = f64();
                                            }
                                            let _e3815 = phi_3092_;
                                            continue;
                                            continuing {
                                                phi_3088_ = _e3805;
                                                phi_3091_ = _e3815;
                                                break if !(_e3810);
                                            }
                                        }
                                        let _e3820 = local_41;
                                        phi_3145_ = (_e3820 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e3827 = phi_3145_;
                                    let _e3835 = local_12.member[0u];
                                    if (_e3835[0] < 0.0lf) {
                                        phi_3163_ = -(_e3835[0]);
                                    } else {
                                        phi_3163_ = _e3835[0];
                                    }
                                    let _e3842 = phi_3163_;
                                    if (_e3835[1] < 0.0lf) {
                                        phi_3170_ = -(_e3835[1]);
                                    } else {
                                        phi_3170_ = _e3835[1];
                                    }
                                    let _e3846 = phi_3170_;
                                    if (_e3842 > _e3846) {
                                        phi_3175_ = _e3842;
                                    } else {
                                        phi_3175_ = _e3846;
                                    }
                                    let _e3849 = phi_3175_;
                                    if (_e3835[2] < 0.0lf) {
                                        phi_3182_ = -(_e3835[2]);
                                    } else {
                                        phi_3182_ = _e3835[2];
                                    }
                                    let _e3853 = phi_3182_;
                                    if (_e3849 > _e3853) {
                                        phi_3187_ = _e3849;
                                    } else {
                                        phi_3187_ = _e3853;
                                    }
                                    let _e3856 = phi_3187_;
                                    let _e3859 = local_12.member[1u];
                                    if (_e3859[0] < 0.0lf) {
                                        phi_3200_ = -(_e3859[0]);
                                    } else {
                                        phi_3200_ = _e3859[0];
                                    }
                                    let _e3866 = phi_3200_;
                                    if (_e3859[1] < 0.0lf) {
                                        phi_3207_ = -(_e3859[1]);
                                    } else {
                                        phi_3207_ = _e3859[1];
                                    }
                                    let _e3870 = phi_3207_;
                                    if (_e3866 > _e3870) {
                                        phi_3212_ = _e3866;
                                    } else {
                                        phi_3212_ = _e3870;
                                    }
                                    let _e3873 = phi_3212_;
                                    if (_e3859[2] < 0.0lf) {
                                        phi_3219_ = -(_e3859[2]);
                                    } else {
                                        phi_3219_ = _e3859[2];
                                    }
                                    let _e3877 = phi_3219_;
                                    if (_e3873 > _e3877) {
                                        phi_3224_ = _e3873;
                                    } else {
                                        phi_3224_ = _e3877;
                                    }
                                    let _e3880 = phi_3224_;
                                    if (_e3856 > _e3880) {
                                        phi_3229_ = _e3856;
                                    } else {
                                        phi_3229_ = _e3880;
                                    }
                                    let _e3883 = phi_3229_;
                                    let _e3885 = local_12.member_3;
                                    let _e3889 = local_12.member_1[0u];
                                    if (_e3889[0] < 0.0lf) {
                                        phi_3246_ = -(_e3889[0]);
                                    } else {
                                        phi_3246_ = _e3889[0];
                                    }
                                    let _e3896 = phi_3246_;
                                    if (_e3889[1] < 0.0lf) {
                                        phi_3253_ = -(_e3889[1]);
                                    } else {
                                        phi_3253_ = _e3889[1];
                                    }
                                    let _e3900 = phi_3253_;
                                    if (_e3896 > _e3900) {
                                        phi_3258_ = _e3896;
                                    } else {
                                        phi_3258_ = _e3900;
                                    }
                                    let _e3903 = phi_3258_;
                                    if (_e3889[2] < 0.0lf) {
                                        phi_3265_ = -(_e3889[2]);
                                    } else {
                                        phi_3265_ = _e3889[2];
                                    }
                                    let _e3907 = phi_3265_;
                                    if (_e3903 > _e3907) {
                                        phi_3270_ = _e3903;
                                    } else {
                                        phi_3270_ = _e3907;
                                    }
                                    let _e3910 = phi_3270_;
                                    let _e3913 = local_12.member_1[1u];
                                    if (_e3913[0] < 0.0lf) {
                                        phi_3284_ = -(_e3913[0]);
                                    } else {
                                        phi_3284_ = _e3913[0];
                                    }
                                    let _e3920 = phi_3284_;
                                    if (_e3913[1] < 0.0lf) {
                                        phi_3291_ = -(_e3913[1]);
                                    } else {
                                        phi_3291_ = _e3913[1];
                                    }
                                    let _e3924 = phi_3291_;
                                    if (_e3920 > _e3924) {
                                        phi_3296_ = _e3920;
                                    } else {
                                        phi_3296_ = _e3924;
                                    }
                                    let _e3927 = phi_3296_;
                                    if (_e3913[2] < 0.0lf) {
                                        phi_3303_ = -(_e3913[2]);
                                    } else {
                                        phi_3303_ = _e3913[2];
                                    }
                                    let _e3931 = phi_3303_;
                                    if (_e3927 > _e3931) {
                                        phi_3308_ = _e3927;
                                    } else {
                                        phi_3308_ = _e3931;
                                    }
                                    let _e3934 = phi_3308_;
                                    if (_e3910 > _e3934) {
                                        phi_3313_ = _e3910;
                                    } else {
                                        phi_3313_ = _e3934;
                                    }
                                    let _e3937 = phi_3313_;
                                    let _e3939 = local_12.member_3;
                                    let _e3943 = local_12.member_2[0u];
                                    if (_e3943[0] < 0.0lf) {
                                        phi_3330_ = -(_e3943[0]);
                                    } else {
                                        phi_3330_ = _e3943[0];
                                    }
                                    let _e3950 = phi_3330_;
                                    if (_e3943[1] < 0.0lf) {
                                        phi_3337_ = -(_e3943[1]);
                                    } else {
                                        phi_3337_ = _e3943[1];
                                    }
                                    let _e3954 = phi_3337_;
                                    if (_e3950 > _e3954) {
                                        phi_3342_ = _e3950;
                                    } else {
                                        phi_3342_ = _e3954;
                                    }
                                    let _e3957 = phi_3342_;
                                    if (_e3943[2] < 0.0lf) {
                                        phi_3349_ = -(_e3943[2]);
                                    } else {
                                        phi_3349_ = _e3943[2];
                                    }
                                    let _e3961 = phi_3349_;
                                    if (_e3957 > _e3961) {
                                        phi_3354_ = _e3957;
                                    } else {
                                        phi_3354_ = _e3961;
                                    }
                                    let _e3964 = phi_3354_;
                                    let _e3967 = local_12.member_2[1u];
                                    if (_e3967[0] < 0.0lf) {
                                        phi_3368_ = -(_e3967[0]);
                                    } else {
                                        phi_3368_ = _e3967[0];
                                    }
                                    let _e3974 = phi_3368_;
                                    if (_e3967[1] < 0.0lf) {
                                        phi_3375_ = -(_e3967[1]);
                                    } else {
                                        phi_3375_ = _e3967[1];
                                    }
                                    let _e3978 = phi_3375_;
                                    if (_e3974 > _e3978) {
                                        phi_3380_ = _e3974;
                                    } else {
                                        phi_3380_ = _e3978;
                                    }
                                    let _e3981 = phi_3380_;
                                    if (_e3967[2] < 0.0lf) {
                                        phi_3387_ = -(_e3967[2]);
                                    } else {
                                        phi_3387_ = _e3967[2];
                                    }
                                    let _e3985 = phi_3387_;
                                    if (_e3981 > _e3985) {
                                        phi_3392_ = _e3981;
                                    } else {
                                        phi_3392_ = _e3985;
                                    }
                                    let _e3988 = phi_3392_;
                                    if (_e3964 > _e3988) {
                                        phi_3397_ = _e3964;
                                    } else {
                                        phi_3397_ = _e3988;
                                    }
                                    let _e3991 = phi_3397_;
                                    let _e3993 = local_12.member_3;
                                    let _e4001 = local_12.member_3;
                                    let _e4011 = (((_e3827 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e3883 + _e3885) + (_e3937 + _e3939)) + (_e3991 + _e3993)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4001 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e370);
                                    if _e4011 {
                                        phi_3421_ = false;
                                    } else {
                                        phi_3421_ = true;
                                    }
                                    let _e4013 = phi_3421_;
                                    phi_3422_ = _e4013;
                                    phi_3423_ = _e4011;
                                } else {
                                    phi_3422_ = false;
                                    phi_3423_ = false;
                                }
                                let _e4015 = phi_3422_;
                                let _e4017 = phi_3423_;
                                local_42 = _e4017;
                                continue;
                                continuing {
                                    phi_2913_ = _e3682;
                                    break if !(_e4015);
                                }
                            }
                            let _e4020 = local_42;
                            if _e4020 {
                                phi_3428_ = type_40(1u, _e3658.member_1);
                                phi_3429_ = false;
                            } else {
                                phi_3428_ = type_40();
                                phi_3429_ = true;
                            }
                            let _e4023 = phi_3428_;
                            let _e4025 = phi_3429_;
                            if _e4025 {
                                phi_3434_ = type_40(2u, _e3658.member_1);
                                phi_3435_ = false;
                            } else {
                                phi_3434_ = type_40();
                                phi_3435_ = true;
                            }
                            let _e4028 = phi_3434_;
                            let _e4030 = phi_3435_;
                            phi_3437_ = _e4028;
                            phi_3438_ = _e4023;
                            phi_3439_ = _e4030;
                        } else {
                            phi_3437_ = type_40();
                            phi_3438_ = type_40(0u, type_40().member_1);
                            phi_3439_ = true;
                        }
                        let _e4032 = phi_3437_;
                        let _e4034 = phi_3438_;
                        let _e4036 = phi_3439_;
                        if _e4036 {
                            phi_3443_ = _e4034;
                        } else {
                            phi_3443_ = _e4032;
                        }
                        let _e4038 = phi_3443_;
                        phi_6327_ = _e4038;
                    } else {
                        if (_e469 < 0.0lf) {
                            phi_3454_ = -(_e469);
                        } else {
                            phi_3454_ = _e469;
                        }
                        let _e824 = phi_3454_;
                        if (_e492 < 0.0lf) {
                            phi_3460_ = -(_e492);
                        } else {
                            phi_3460_ = _e492;
                        }
                        let _e828 = phi_3460_;
                        if (_e824 > _e828) {
                            phi_3465_ = _e824;
                        } else {
                            phi_3465_ = _e828;
                        }
                        let _e831 = phi_3465_;
                        if (_e515 < 0.0lf) {
                            phi_3471_ = -(_e515);
                        } else {
                            phi_3471_ = _e515;
                        }
                        let _e835 = phi_3471_;
                        if (_e526 < 0.0lf) {
                            phi_3477_ = -(_e526);
                        } else {
                            phi_3477_ = _e526;
                        }
                        let _e839 = phi_3477_;
                        if (_e835 > _e839) {
                            phi_3482_ = _e835;
                        } else {
                            phi_3482_ = _e839;
                        }
                        let _e842 = phi_3482_;
                        if (_e831 > _e842) {
                            phi_3487_ = _e831;
                        } else {
                            phi_3487_ = _e842;
                        }
                        let _e845 = phi_3487_;
                        let _e847 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e848 = f64(1f);
                        if (_e845 >= _e847) {
                            phi_3497_ = (_e845 <= (_e848 / _e847));
                        } else {
                            phi_3497_ = false;
                        }
                        let _e853 = phi_3497_;
                        if _e853 {
                            phi_3504_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_3504_ = f64(2f);
                        }
                        let _e858 = phi_3504_;
                        let _e860 = ((_e785 * f64(0.34f)) + (_e845 * _e858));
                        if _e853 {
                            phi_3512_ = (_e848 / _e845);
                        } else {
                            phi_3512_ = f64(0f);
                        }
                        let _e864 = phi_3512_;
                        let _e865 = f64(0f);
                        let _e866 = f64(1f);
                        let _e867 = f64(3f);
                        let _e873 = ((_e492 - (_e867 * _e469)) * _e864);
                        let _e874 = ((_e515 - _e492) * _e864);
                        let _e875 = (((_e867 * _e526) - _e515) * _e864);
                        local_6[0u] = _e865;
                        local_6[1u] = _e866;
                        local_6[2u] = _e866;
                        local_6[3u] = _e866;
                        let _e882 = ((_e874 * _e874) - (_e873 * _e875));
                        if (_e882 > _e865) {
                            if (_e882 <= 2.2250738585072014e-308lf) {
                                if (_e882 > 0.0lf) {
                                    phi_3548_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_3548_ = 0.0lf;
                                }
                                let _e935 = phi_3548_;
                                phi_3612_ = _e935;
                            } else {
                                phi_3555_ = type_17(0i, 5i);
                                phi_3558_ = bitcast<f64>(((bitcast<u64>(_e882) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e890 = phi_3555_;
                                    let _e892 = phi_3558_;
                                    local_13 = _e892;
                                    if (_e890.member < _e890.member_1) {
                                        let _e899 = (_e890.member + 1i);
                                        if ((false == (_e899 > _e890.member)) != false) {
                                            phi_3579_ = true;
                                        } else {
                                            phi_3579_ = false;
                                        }
                                        let _e904 = phi_3579_;
                                        if _e904 {
                                            phi_3585_ = type_18(0u, type_18().member_1);
                                        } else {
                                            phi_3585_ = type_18(1u, _e899);
                                        }
                                        let _e909 = phi_3585_;
                                        phi_3556_ = type_17(_e909.member_1, _e890.member_1);
                                        phi_3599_ = type_18(1u, _e890.member);
                                    } else {
                                        phi_3556_ = _e890;
                                        phi_3599_ = type_18(0u, type_18().member_1);
                                    }
                                    let _e915 = phi_3556_;
                                    let _e917 = phi_3599_;
                                    let _e920 = (bitcast<i32>(_e917.member) != 0i);
                                    if _e920 {
                                        phi_3559_ = (0.5lf * (_e892 + (_e882 / _e892)));
                                    } else {
                                        phi_3559_ = f64();
                                    }
                                    let _e925 = phi_3559_;
                                    continue;
                                    continuing {
                                        phi_3555_ = _e915;
                                        phi_3558_ = _e925;
                                        break if !(_e920);
                                    }
                                }
                                let _e930 = local_13;
                                phi_3612_ = (_e930 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e937 = phi_3612_;
                            if (_e874 < _e865) {
                                phi_3618_ = -(_e937);
                            } else {
                                phi_3618_ = _e937;
                            }
                            let _e941 = phi_3618_;
                            let _e943 = -((_e874 + _e941));
                            local_7[0u] = (_e943 / (_e943 + _e875));
                            local_7[1u] = (_e873 / (_e873 + _e943));
                            let _e952 = local_7[1u];
                            let _e953 = local_7[0u];
                            if (_e952 < _e953) {
                                let _e956 = local_7[1u];
                                let _e958 = local_7[0u];
                                local_7[0u] = _e956;
                                local_7[1u] = _e958;
                            }
                            phi_3643_ = type_19(0u, 2u);
                            phi_3646_ = 1u;
                            loop {
                                let _e962 = phi_3643_;
                                let _e964 = phi_3646_;
                                local_43 = _e964;
                                if (_e962.member < _e962.member_1) {
                                    phi_3644_ = type_19((_e962.member + 1u), _e962.member_1);
                                    phi_3669_ = type_19(1u, _e962.member);
                                } else {
                                    phi_3644_ = _e962;
                                    phi_3669_ = type_19(0u, type_19().member_1);
                                }
                                let _e976 = phi_3644_;
                                let _e978 = phi_3669_;
                                let _e982 = (bitcast<i32>(_e978.member) != 0i);
                                if _e982 {
                                    let _e984 = local_7[_e978.member_1];
                                    if (_e984 > _e865) {
                                        let _e987 = local_7[_e978.member_1];
                                        if (_e987 < _e866) {
                                            let _e990 = local_7[_e978.member_1];
                                            local_6[_e964] = _e990;
                                            phi_3713_ = (_e964 + 1u);
                                        } else {
                                            phi_3713_ = _e964;
                                        }
                                        let _e994 = phi_3713_;
                                        phi_3714_ = _e994;
                                    } else {
                                        phi_3714_ = _e964;
                                    }
                                    let _e996 = phi_3714_;
                                    phi_3647_ = _e996;
                                } else {
                                    phi_3647_ = u32();
                                }
                                let _e998 = phi_3647_;
                                continue;
                                continuing {
                                    phi_3643_ = _e976;
                                    phi_3646_ = _e998;
                                    break if !(_e982);
                                }
                            }
                            let _e4216 = local_43;
                            phi_3715_ = _e4216;
                        } else {
                            phi_3715_ = 1u;
                        }
                        let _e1001 = phi_3715_;
                        local_6[_e1001] = _e866;
                        let _e1003 = local_6;
                        local_8 = _e1003;
                        phi_3735_ = type_19(0u, _e1001);
                        loop {
                            let _e1006 = phi_3735_;
                            if (_e1006.member < _e1006.member_1) {
                                phi_3736_ = type_19((_e1006.member + 1u), _e1006.member_1);
                                phi_3759_ = type_19(1u, _e1006.member);
                            } else {
                                phi_3736_ = _e1006;
                                phi_3759_ = type_19(0u, type_19().member_1);
                            }
                            let _e1018 = phi_3736_;
                            let _e1020 = phi_3759_;
                            if (bitcast<i32>(_e1020.member) != 0i) {
                                let _e1026 = local_8[_e1020.member_1];
                                let _e1029 = local_8[(_e1020.member_1 + 1u)];
                                let _e1031 = (f64(1f) - _e1026);
                                let _e1042 = ((((_e469 * _e1031) + (_e492 * _e1026)) * (_e1031 * _e1031)) + (((_e515 * _e1031) + (_e526 * _e1026)) * (_e1026 * _e1026)));
                                let _e1044 = (f64(1f) - _e1029);
                                let _e1055 = ((((_e469 * _e1044) + (_e492 * _e1029)) * (_e1044 * _e1044)) + (((_e515 * _e1044) + (_e526 * _e1029)) * (_e1029 * _e1029)));
                                if (_e1042 < 0.0lf) {
                                    phi_3813_ = -(_e1042);
                                } else {
                                    phi_3813_ = _e1042;
                                }
                                let _e1059 = phi_3813_;
                                let _e1060 = (_e1059 > _e860);
                                if (_e1055 < 0.0lf) {
                                    phi_3820_ = -(_e1055);
                                } else {
                                    phi_3820_ = _e1055;
                                }
                                let _e1064 = phi_3820_;
                                let _e1065 = (_e1064 > _e860);
                                let _e1066 = f64(0f);
                                if _e1060 {
                                    if _e1065 {
                                        phi_3832_ = ((_e1042 > _e1066) != (_e1055 > _e1066));
                                        phi_3833_ = false;
                                    } else {
                                        phi_3832_ = bool();
                                        phi_3833_ = true;
                                    }
                                    let _e1071 = phi_3832_;
                                    let _e1073 = phi_3833_;
                                    phi_3834_ = _e1071;
                                    phi_3835_ = _e1073;
                                } else {
                                    phi_3834_ = bool();
                                    phi_3835_ = true;
                                }
                                let _e1075 = phi_3834_;
                                let _e1077 = phi_3835_;
                                if _e1077 {
                                    phi_3839_ = false;
                                } else {
                                    phi_3839_ = _e1075;
                                }
                                let _e1079 = phi_3839_;
                                if _e1060 {
                                    if _e1065 {
                                        if _e1079 {
                                            phi_3851_ = type_41();
                                        } else {
                                            phi_3851_ = type_41(f64(1f), _e1066, _e1079);
                                        }
                                        let _e1083 = phi_3851_;
                                        phi_3852_ = _e1083;
                                        phi_3853_ = _e1079;
                                    } else {
                                        phi_3852_ = type_41();
                                        phi_3853_ = true;
                                    }
                                    let _e1085 = phi_3852_;
                                    let _e1087 = phi_3853_;
                                    phi_3854_ = _e1085;
                                    phi_3855_ = _e1087;
                                } else {
                                    phi_3854_ = type_41();
                                    phi_3855_ = true;
                                }
                                let _e1089 = phi_3854_;
                                let _e1091 = phi_3855_;
                                if _e1091 {
                                    if _e1060 {
                                        if (_e1042 < _e1066) {
                                            phi_3868_ = f64(-1f);
                                        } else {
                                            phi_3868_ = f64(1f);
                                        }
                                        let _e1096 = phi_3868_;
                                        let _e1097 = f64(0.00000000000022737368f);
                                        let _e1098 = f64(0.5f);
                                        let _e1099 = f64(3f);
                                        let _e1102 = (_e515 - _e492);
                                        phi_3881_ = type_19(0u, 64u);
                                        phi_3884_ = _e1029;
                                        phi_3886_ = _e1026;
                                        phi_3888_ = (_e1098 * (_e1026 + _e1029));
                                        loop {
                                            let _e1108 = phi_3881_;
                                            let _e1110 = phi_3884_;
                                            let _e1112 = phi_3886_;
                                            let _e1114 = phi_3888_;
                                            local_45 = _e1112;
                                            if (_e1108.member < _e1108.member_1) {
                                                phi_3882_ = type_19((_e1108.member + 1u), _e1108.member_1);
                                                phi_3911_ = type_19(1u, _e1108.member);
                                            } else {
                                                phi_3882_ = _e1108;
                                                phi_3911_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1126 = phi_3882_;
                                            let _e1128 = phi_3911_;
                                            if (bitcast<i32>(_e1128.member) != 0i) {
                                                let _e1133 = (f64(1f) - _e1114);
                                                let _e1146 = ((_e1096 * ((((_e469 * _e1133) + (_e492 * _e1114)) * (_e1133 * _e1133)) + (((_e515 * _e1133) + (_e526 * _e1114)) * (_e1114 * _e1114)))) - _e860);
                                                if (_e1146 > f64(0f)) {
                                                    phi_3938_ = _e1110;
                                                    phi_3939_ = _e1114;
                                                } else {
                                                    phi_3938_ = _e1114;
                                                    phi_3939_ = _e1112;
                                                }
                                                let _e1150 = phi_3938_;
                                                let _e1152 = phi_3939_;
                                                let _e1154 = ((_e1150 - _e1152) > _e1097);
                                                if _e1154 {
                                                    let _e1156 = (f64(1f) - _e1114);
                                                    let _e1168 = (-(_e1146) / (_e1096 * (((((_e492 - (_e1099 * _e469)) * _e1156) + (_e1102 * _e1114)) * _e1156) + (((_e1102 * _e1156) + (((_e1099 * _e526) - _e515) * _e1114)) * _e1114))));
                                                    if (_e1146 > f64(0f)) {
                                                        phi_3967_ = (_e1098 * _e1097);
                                                    } else {
                                                        phi_3967_ = -((_e1098 * _e1097));
                                                    }
                                                    let _e1175 = phi_3967_;
                                                    let _e1177 = ((_e1114 + _e1168) + _e1175);
                                                    if (_e1177 > _e1152) {
                                                        if (_e1177 < _e1150) {
                                                            if (_e1168 < 0.0lf) {
                                                                phi_3983_ = -(_e1168);
                                                            } else {
                                                                phi_3983_ = _e1168;
                                                            }
                                                            let _e1183 = phi_3983_;
                                                            if (_e1183 < (_e1098 * (_e1150 - _e1152))) {
                                                                phi_3990_ = false;
                                                            } else {
                                                                phi_3990_ = true;
                                                            }
                                                            let _e1188 = phi_3990_;
                                                            phi_3991_ = _e1188;
                                                        } else {
                                                            phi_3991_ = true;
                                                        }
                                                        let _e1190 = phi_3991_;
                                                        phi_3992_ = _e1190;
                                                    } else {
                                                        phi_3992_ = true;
                                                    }
                                                    let _e1192 = phi_3992_;
                                                    if _e1192 {
                                                        phi_3998_ = (_e1098 * (_e1152 + _e1150));
                                                    } else {
                                                        phi_3998_ = _e1177;
                                                    }
                                                    let _e1196 = phi_3998_;
                                                    phi_3999_ = _e1196;
                                                    phi_4000_ = false;
                                                } else {
                                                    phi_3999_ = f64();
                                                    phi_4000_ = true;
                                                }
                                                let _e1198 = phi_3999_;
                                                let _e1200 = phi_4000_;
                                                phi_3885_ = _e1150;
                                                phi_3887_ = _e1152;
                                                phi_3889_ = _e1198;
                                                phi_4001_ = _e1152;
                                                phi_4002_ = _e1154;
                                                phi_4003_ = _e1200;
                                            } else {
                                                phi_3885_ = f64();
                                                phi_3887_ = f64();
                                                phi_3889_ = f64();
                                                phi_4001_ = f64();
                                                phi_4002_ = false;
                                                phi_4003_ = false;
                                            }
                                            let _e1202 = phi_3885_;
                                            let _e1204 = phi_3887_;
                                            let _e1206 = phi_3889_;
                                            let _e1208 = phi_4001_;
                                            let _e1210 = phi_4002_;
                                            let _e1212 = phi_4003_;
                                            local_14 = _e1212;
                                            local_44 = _e1208;
                                            continue;
                                            continuing {
                                                phi_3881_ = _e1126;
                                                phi_3884_ = _e1202;
                                                phi_3886_ = _e1204;
                                                phi_3888_ = _e1206;
                                                break if !(_e1210);
                                            }
                                        }
                                        let _e1215 = local_14;
                                        if _e1215 {
                                            let _e4258 = local_44;
                                            phi_4007_ = _e4258;
                                        } else {
                                            let _e4260 = local_45;
                                            phi_4007_ = _e4260;
                                        }
                                        let _e1217 = phi_4007_;
                                        phi_4008_ = _e1217;
                                    } else {
                                        phi_4008_ = _e1026;
                                    }
                                    let _e1219 = phi_4008_;
                                    if _e1065 {
                                        phi_4016_ = type_19(0u, 64u);
                                        phi_4019_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1223 = phi_4016_;
                                            let _e1225 = phi_4019_;
                                            if (_e1223.member < _e1223.member_1) {
                                                phi_4017_ = type_19((_e1223.member + 1u), _e1223.member_1);
                                                phi_4042_ = type_19(1u, _e1223.member);
                                            } else {
                                                phi_4017_ = _e1223;
                                                phi_4042_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1237 = phi_4017_;
                                            let _e1239 = phi_4042_;
                                            if (bitcast<i32>(_e1239.member) != 0i) {
                                                let _e1243 = (_e1219 + _e1225);
                                                if (_e1243 < _e1029) {
                                                    let _e1246 = (f64(1f) - _e1243);
                                                    let _e1257 = ((((_e469 * _e1246) + (_e492 * _e1243)) * (_e1246 * _e1246)) + (((_e515 * _e1246) + (_e526 * _e1243)) * (_e1243 * _e1243)));
                                                    let _e1259 = (f64(1f) - _e1219);
                                                    let _e1270 = ((((_e469 * _e1259) + (_e492 * _e1219)) * (_e1259 * _e1259)) + (((_e515 * _e1259) + (_e526 * _e1219)) * (_e1219 * _e1219)));
                                                    if (_e1257 < 0.0lf) {
                                                        phi_4085_ = -(_e1257);
                                                    } else {
                                                        phi_4085_ = _e1257;
                                                    }
                                                    let _e1274 = phi_4085_;
                                                    if (_e1274 > _e860) {
                                                        if (_e1270 < 0.0lf) {
                                                            phi_4095_ = -(_e1270);
                                                        } else {
                                                            phi_4095_ = _e1270;
                                                        }
                                                        let _e1279 = phi_4095_;
                                                        if (_e1279 > _e860) {
                                                            phi_4105_ = ((_e1257 > f64(0f)) == (_e1270 > f64(0f)));
                                                        } else {
                                                            phi_4105_ = false;
                                                        }
                                                        let _e1287 = phi_4105_;
                                                        phi_4107_ = !(_e1287);
                                                    } else {
                                                        phi_4107_ = false;
                                                    }
                                                    let _e1290 = phi_4107_;
                                                    if _e1290 {
                                                        phi_4112_ = f64();
                                                        phi_4113_ = false;
                                                    } else {
                                                        phi_4112_ = (_e1225 + _e1225);
                                                        phi_4113_ = true;
                                                    }
                                                    let _e1293 = phi_4112_;
                                                    let _e1295 = phi_4113_;
                                                    phi_4114_ = _e1293;
                                                    phi_4115_ = _e1295;
                                                    phi_4116_ = _e1290;
                                                    phi_4117_ = false;
                                                } else {
                                                    phi_4114_ = f64();
                                                    phi_4115_ = false;
                                                    phi_4116_ = false;
                                                    phi_4117_ = true;
                                                }
                                                let _e1297 = phi_4114_;
                                                let _e1299 = phi_4115_;
                                                let _e1301 = phi_4116_;
                                                let _e1303 = phi_4117_;
                                                phi_4118_ = _e1243;
                                                phi_4020_ = _e1297;
                                                phi_4119_ = _e1299;
                                                phi_4120_ = _e1301;
                                                phi_4121_ = _e1303;
                                                phi_4122_ = false;
                                            } else {
                                                phi_4118_ = f64();
                                                phi_4020_ = f64();
                                                phi_4119_ = false;
                                                phi_4120_ = false;
                                                phi_4121_ = false;
                                                phi_4122_ = true;
                                            }
                                            let _e1305 = phi_4118_;
                                            let _e1307 = phi_4020_;
                                            let _e1309 = phi_4119_;
                                            let _e1311 = phi_4120_;
                                            let _e1313 = phi_4121_;
                                            let _e1315 = phi_4122_;
                                            local_15 = _e1311;
                                            local_46 = _e1313;
                                            local_47 = _e1315;
                                            local_48 = _e1305;
                                            continue;
                                            continuing {
                                                phi_4016_ = _e1237;
                                                phi_4019_ = _e1307;
                                                break if !(_e1309);
                                            }
                                        }
                                        let _e1318 = local_15;
                                        if _e1318 {
                                            phi_4126_ = false;
                                            phi_4127_ = false;
                                        } else {
                                            let _e4285 = local_46;
                                            phi_4126_ = _e4285;
                                            let _e4288 = local_47;
                                            phi_4127_ = _e4288;
                                        }
                                        let _e1320 = phi_4126_;
                                        let _e1322 = phi_4127_;
                                        if _e1320 {
                                            phi_4131_ = true;
                                        } else {
                                            phi_4131_ = _e1322;
                                        }
                                        let _e1324 = phi_4131_;
                                        if _e1324 {
                                            phi_4135_ = _e1029;
                                        } else {
                                            let _e4292 = local_48;
                                            phi_4135_ = _e4292;
                                        }
                                        let _e1326 = phi_4135_;
                                        phi_4136_ = _e1326;
                                    } else {
                                        phi_4136_ = _e1029;
                                    }
                                    let _e1328 = phi_4136_;
                                    phi_4138_ = type_41(_e1219, _e1328, _e1079);
                                } else {
                                    phi_4138_ = _e1089;
                                }
                                let _e1331 = phi_4138_;
                                if (_e1331.member > _e1331.member_1) {
                                    phi_6283_ = f64();
                                    phi_6284_ = true;
                                    phi_6285_ = false;
                                    phi_6286_ = false;
                                    phi_6287_ = false;
                                } else {
                                    let _e1339 = ((_e1331.member_1 - _e1331.member) * f64(0.5f));
                                    let _e1340 = (_e1331.member + _e1339);
                                    let _e1343 = (_e1339 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1345 = local_12.member_3;
                                    let _e1348 = local_12.member[0u];
                                    if (_e1348[0] < 0.0lf) {
                                        phi_4169_ = -(_e1348[0]);
                                    } else {
                                        phi_4169_ = _e1348[0];
                                    }
                                    let _e1355 = phi_4169_;
                                    if (_e1348[1] < 0.0lf) {
                                        phi_4176_ = -(_e1348[1]);
                                    } else {
                                        phi_4176_ = _e1348[1];
                                    }
                                    let _e1359 = phi_4176_;
                                    if (_e1355 > _e1359) {
                                        phi_4181_ = _e1355;
                                    } else {
                                        phi_4181_ = _e1359;
                                    }
                                    let _e1362 = phi_4181_;
                                    if (_e1348[2] < 0.0lf) {
                                        phi_4188_ = -(_e1348[2]);
                                    } else {
                                        phi_4188_ = _e1348[2];
                                    }
                                    let _e1366 = phi_4188_;
                                    if (_e1362 > _e1366) {
                                        phi_4193_ = _e1362;
                                    } else {
                                        phi_4193_ = _e1366;
                                    }
                                    let _e1369 = phi_4193_;
                                    let _e1371 = local_12.member[1u];
                                    if (_e1371[0] < 0.0lf) {
                                        phi_4206_ = -(_e1371[0]);
                                    } else {
                                        phi_4206_ = _e1371[0];
                                    }
                                    let _e1378 = phi_4206_;
                                    if (_e1371[1] < 0.0lf) {
                                        phi_4213_ = -(_e1371[1]);
                                    } else {
                                        phi_4213_ = _e1371[1];
                                    }
                                    let _e1382 = phi_4213_;
                                    if (_e1378 > _e1382) {
                                        phi_4218_ = _e1378;
                                    } else {
                                        phi_4218_ = _e1382;
                                    }
                                    let _e1385 = phi_4218_;
                                    if (_e1371[2] < 0.0lf) {
                                        phi_4225_ = -(_e1371[2]);
                                    } else {
                                        phi_4225_ = _e1371[2];
                                    }
                                    let _e1389 = phi_4225_;
                                    if (_e1385 > _e1389) {
                                        phi_4230_ = _e1385;
                                    } else {
                                        phi_4230_ = _e1389;
                                    }
                                    let _e1392 = phi_4230_;
                                    if (_e1369 > _e1392) {
                                        phi_4235_ = _e1369;
                                    } else {
                                        phi_4235_ = _e1392;
                                    }
                                    let _e1395 = phi_4235_;
                                    let _e1398 = local_12.member[0u];
                                    let _e1403 = local_12.member[1u];
                                    let _e1413 = (_e1398[0] + ((_e1403[0] - _e1398[0]) * _e1340));
                                    let _e1414 = (_e1398[1] + ((_e1403[1] - _e1398[1]) * _e1340));
                                    let _e1415 = (_e1398[2] + ((_e1403[2] - _e1398[2]) * _e1340));
                                    let _e1417 = local_12.member[1u];
                                    let _e1422 = local_12.member[0u];
                                    let _e1426 = (_e1417[0] - _e1422[0]);
                                    let _e1427 = (_e1417[1] - _e1422[1]);
                                    let _e1428 = (_e1417[2] - _e1422[2]);
                                    if (_e1426 < 0.0lf) {
                                        phi_4294_ = -(_e1426);
                                    } else {
                                        phi_4294_ = _e1426;
                                    }
                                    let _e1432 = phi_4294_;
                                    if (_e1427 < 0.0lf) {
                                        phi_4300_ = -(_e1427);
                                    } else {
                                        phi_4300_ = _e1427;
                                    }
                                    let _e1436 = phi_4300_;
                                    if (_e1432 > _e1436) {
                                        phi_4305_ = _e1432;
                                    } else {
                                        phi_4305_ = _e1436;
                                    }
                                    let _e1439 = phi_4305_;
                                    if (_e1428 < 0.0lf) {
                                        phi_4311_ = -(_e1428);
                                    } else {
                                        phi_4311_ = _e1428;
                                    }
                                    let _e1443 = phi_4311_;
                                    if (_e1439 > _e1443) {
                                        phi_4316_ = _e1439;
                                    } else {
                                        phi_4316_ = _e1443;
                                    }
                                    let _e1446 = phi_4316_;
                                    let _e1454 = ((((_e1343 * _e1446) * f64(1.01f)) + ((_e1395 + _e1345) * (1.1102230246251565e-16lf * f64(8f)))) + _e1345);
                                    if (_e1413 < 0.0lf) {
                                        phi_4330_ = -(_e1413);
                                    } else {
                                        phi_4330_ = _e1413;
                                    }
                                    let _e1458 = phi_4330_;
                                    if (_e1414 < 0.0lf) {
                                        phi_4336_ = -(_e1414);
                                    } else {
                                        phi_4336_ = _e1414;
                                    }
                                    let _e1462 = phi_4336_;
                                    if (_e1458 > _e1462) {
                                        phi_4341_ = _e1458;
                                    } else {
                                        phi_4341_ = _e1462;
                                    }
                                    let _e1465 = phi_4341_;
                                    if (_e1415 < 0.0lf) {
                                        phi_4347_ = -(_e1415);
                                    } else {
                                        phi_4347_ = _e1415;
                                    }
                                    let _e1469 = phi_4347_;
                                    if (_e1465 > _e1469) {
                                        phi_4352_ = _e1465;
                                    } else {
                                        phi_4352_ = _e1469;
                                    }
                                    let _e1472 = phi_4352_;
                                    local_2 = type_32(array<f64, 3>(_e1413, _e1414, _e1415), _e1454, (_e1472 + _e1454));
                                    let _e1478 = local_12.member_3;
                                    let _e1480 = local_12.member_1[0u];
                                    if (_e1480[0] < 0.0lf) {
                                        phi_4378_ = -(_e1480[0]);
                                    } else {
                                        phi_4378_ = _e1480[0];
                                    }
                                    let _e1487 = phi_4378_;
                                    if (_e1480[1] < 0.0lf) {
                                        phi_4385_ = -(_e1480[1]);
                                    } else {
                                        phi_4385_ = _e1480[1];
                                    }
                                    let _e1491 = phi_4385_;
                                    if (_e1487 > _e1491) {
                                        phi_4390_ = _e1487;
                                    } else {
                                        phi_4390_ = _e1491;
                                    }
                                    let _e1494 = phi_4390_;
                                    if (_e1480[2] < 0.0lf) {
                                        phi_4397_ = -(_e1480[2]);
                                    } else {
                                        phi_4397_ = _e1480[2];
                                    }
                                    let _e1498 = phi_4397_;
                                    if (_e1494 > _e1498) {
                                        phi_4402_ = _e1494;
                                    } else {
                                        phi_4402_ = _e1498;
                                    }
                                    let _e1501 = phi_4402_;
                                    let _e1503 = local_12.member_1[1u];
                                    if (_e1503[0] < 0.0lf) {
                                        phi_4415_ = -(_e1503[0]);
                                    } else {
                                        phi_4415_ = _e1503[0];
                                    }
                                    let _e1510 = phi_4415_;
                                    if (_e1503[1] < 0.0lf) {
                                        phi_4422_ = -(_e1503[1]);
                                    } else {
                                        phi_4422_ = _e1503[1];
                                    }
                                    let _e1514 = phi_4422_;
                                    if (_e1510 > _e1514) {
                                        phi_4427_ = _e1510;
                                    } else {
                                        phi_4427_ = _e1514;
                                    }
                                    let _e1517 = phi_4427_;
                                    if (_e1503[2] < 0.0lf) {
                                        phi_4434_ = -(_e1503[2]);
                                    } else {
                                        phi_4434_ = _e1503[2];
                                    }
                                    let _e1521 = phi_4434_;
                                    if (_e1517 > _e1521) {
                                        phi_4439_ = _e1517;
                                    } else {
                                        phi_4439_ = _e1521;
                                    }
                                    let _e1524 = phi_4439_;
                                    if (_e1501 > _e1524) {
                                        phi_4444_ = _e1501;
                                    } else {
                                        phi_4444_ = _e1524;
                                    }
                                    let _e1527 = phi_4444_;
                                    let _e1530 = local_12.member_1[0u];
                                    let _e1535 = local_12.member_1[1u];
                                    let _e1545 = (_e1530[0] + ((_e1535[0] - _e1530[0]) * _e1340));
                                    let _e1546 = (_e1530[1] + ((_e1535[1] - _e1530[1]) * _e1340));
                                    let _e1547 = (_e1530[2] + ((_e1535[2] - _e1530[2]) * _e1340));
                                    let _e1549 = local_12.member_1[1u];
                                    let _e1554 = local_12.member_1[0u];
                                    let _e1558 = (_e1549[0] - _e1554[0]);
                                    let _e1559 = (_e1549[1] - _e1554[1]);
                                    let _e1560 = (_e1549[2] - _e1554[2]);
                                    if (_e1558 < 0.0lf) {
                                        phi_4503_ = -(_e1558);
                                    } else {
                                        phi_4503_ = _e1558;
                                    }
                                    let _e1564 = phi_4503_;
                                    if (_e1559 < 0.0lf) {
                                        phi_4509_ = -(_e1559);
                                    } else {
                                        phi_4509_ = _e1559;
                                    }
                                    let _e1568 = phi_4509_;
                                    if (_e1564 > _e1568) {
                                        phi_4514_ = _e1564;
                                    } else {
                                        phi_4514_ = _e1568;
                                    }
                                    let _e1571 = phi_4514_;
                                    if (_e1560 < 0.0lf) {
                                        phi_4520_ = -(_e1560);
                                    } else {
                                        phi_4520_ = _e1560;
                                    }
                                    let _e1575 = phi_4520_;
                                    if (_e1571 > _e1575) {
                                        phi_4525_ = _e1571;
                                    } else {
                                        phi_4525_ = _e1575;
                                    }
                                    let _e1578 = phi_4525_;
                                    let _e1586 = ((((_e1343 * _e1578) * f64(1.01f)) + ((_e1527 + _e1478) * (1.1102230246251565e-16lf * f64(8f)))) + _e1478);
                                    if (_e1545 < 0.0lf) {
                                        phi_4539_ = -(_e1545);
                                    } else {
                                        phi_4539_ = _e1545;
                                    }
                                    let _e1590 = phi_4539_;
                                    if (_e1546 < 0.0lf) {
                                        phi_4545_ = -(_e1546);
                                    } else {
                                        phi_4545_ = _e1546;
                                    }
                                    let _e1594 = phi_4545_;
                                    if (_e1590 > _e1594) {
                                        phi_4550_ = _e1590;
                                    } else {
                                        phi_4550_ = _e1594;
                                    }
                                    let _e1597 = phi_4550_;
                                    if (_e1547 < 0.0lf) {
                                        phi_4556_ = -(_e1547);
                                    } else {
                                        phi_4556_ = _e1547;
                                    }
                                    let _e1601 = phi_4556_;
                                    if (_e1597 > _e1601) {
                                        phi_4561_ = _e1597;
                                    } else {
                                        phi_4561_ = _e1601;
                                    }
                                    let _e1604 = phi_4561_;
                                    local_3 = type_32(array<f64, 3>(_e1545, _e1546, _e1547), _e1586, (_e1604 + _e1586));
                                    let _e1610 = local_12.member_3;
                                    let _e1612 = local_12.member_2[0u];
                                    if (_e1612[0] < 0.0lf) {
                                        phi_4587_ = -(_e1612[0]);
                                    } else {
                                        phi_4587_ = _e1612[0];
                                    }
                                    let _e1619 = phi_4587_;
                                    if (_e1612[1] < 0.0lf) {
                                        phi_4594_ = -(_e1612[1]);
                                    } else {
                                        phi_4594_ = _e1612[1];
                                    }
                                    let _e1623 = phi_4594_;
                                    if (_e1619 > _e1623) {
                                        phi_4599_ = _e1619;
                                    } else {
                                        phi_4599_ = _e1623;
                                    }
                                    let _e1626 = phi_4599_;
                                    if (_e1612[2] < 0.0lf) {
                                        phi_4606_ = -(_e1612[2]);
                                    } else {
                                        phi_4606_ = _e1612[2];
                                    }
                                    let _e1630 = phi_4606_;
                                    if (_e1626 > _e1630) {
                                        phi_4611_ = _e1626;
                                    } else {
                                        phi_4611_ = _e1630;
                                    }
                                    let _e1633 = phi_4611_;
                                    let _e1635 = local_12.member_2[1u];
                                    if (_e1635[0] < 0.0lf) {
                                        phi_4624_ = -(_e1635[0]);
                                    } else {
                                        phi_4624_ = _e1635[0];
                                    }
                                    let _e1642 = phi_4624_;
                                    if (_e1635[1] < 0.0lf) {
                                        phi_4631_ = -(_e1635[1]);
                                    } else {
                                        phi_4631_ = _e1635[1];
                                    }
                                    let _e1646 = phi_4631_;
                                    if (_e1642 > _e1646) {
                                        phi_4636_ = _e1642;
                                    } else {
                                        phi_4636_ = _e1646;
                                    }
                                    let _e1649 = phi_4636_;
                                    if (_e1635[2] < 0.0lf) {
                                        phi_4643_ = -(_e1635[2]);
                                    } else {
                                        phi_4643_ = _e1635[2];
                                    }
                                    let _e1653 = phi_4643_;
                                    if (_e1649 > _e1653) {
                                        phi_4648_ = _e1649;
                                    } else {
                                        phi_4648_ = _e1653;
                                    }
                                    let _e1656 = phi_4648_;
                                    if (_e1633 > _e1656) {
                                        phi_4653_ = _e1633;
                                    } else {
                                        phi_4653_ = _e1656;
                                    }
                                    let _e1659 = phi_4653_;
                                    let _e1662 = local_12.member_2[0u];
                                    let _e1667 = local_12.member_2[1u];
                                    let _e1677 = (_e1662[0] + ((_e1667[0] - _e1662[0]) * _e1340));
                                    let _e1678 = (_e1662[1] + ((_e1667[1] - _e1662[1]) * _e1340));
                                    let _e1679 = (_e1662[2] + ((_e1667[2] - _e1662[2]) * _e1340));
                                    let _e1681 = local_12.member_2[1u];
                                    let _e1686 = local_12.member_2[0u];
                                    let _e1690 = (_e1681[0] - _e1686[0]);
                                    let _e1691 = (_e1681[1] - _e1686[1]);
                                    let _e1692 = (_e1681[2] - _e1686[2]);
                                    if (_e1690 < 0.0lf) {
                                        phi_4712_ = -(_e1690);
                                    } else {
                                        phi_4712_ = _e1690;
                                    }
                                    let _e1696 = phi_4712_;
                                    if (_e1691 < 0.0lf) {
                                        phi_4718_ = -(_e1691);
                                    } else {
                                        phi_4718_ = _e1691;
                                    }
                                    let _e1700 = phi_4718_;
                                    if (_e1696 > _e1700) {
                                        phi_4723_ = _e1696;
                                    } else {
                                        phi_4723_ = _e1700;
                                    }
                                    let _e1703 = phi_4723_;
                                    if (_e1692 < 0.0lf) {
                                        phi_4729_ = -(_e1692);
                                    } else {
                                        phi_4729_ = _e1692;
                                    }
                                    let _e1707 = phi_4729_;
                                    if (_e1703 > _e1707) {
                                        phi_4734_ = _e1703;
                                    } else {
                                        phi_4734_ = _e1707;
                                    }
                                    let _e1710 = phi_4734_;
                                    let _e1718 = ((((_e1343 * _e1710) * f64(1.01f)) + ((_e1659 + _e1610) * (1.1102230246251565e-16lf * f64(8f)))) + _e1610);
                                    if (_e1677 < 0.0lf) {
                                        phi_4748_ = -(_e1677);
                                    } else {
                                        phi_4748_ = _e1677;
                                    }
                                    let _e1722 = phi_4748_;
                                    if (_e1678 < 0.0lf) {
                                        phi_4754_ = -(_e1678);
                                    } else {
                                        phi_4754_ = _e1678;
                                    }
                                    let _e1726 = phi_4754_;
                                    if (_e1722 > _e1726) {
                                        phi_4759_ = _e1722;
                                    } else {
                                        phi_4759_ = _e1726;
                                    }
                                    let _e1729 = phi_4759_;
                                    if (_e1679 < 0.0lf) {
                                        phi_4765_ = -(_e1679);
                                    } else {
                                        phi_4765_ = _e1679;
                                    }
                                    let _e1733 = phi_4765_;
                                    if (_e1729 > _e1733) {
                                        phi_4770_ = _e1729;
                                    } else {
                                        phi_4770_ = _e1733;
                                    }
                                    let _e1736 = phi_4770_;
                                    local_4 = type_32(array<f64, 3>(_e1677, _e1678, _e1679), _e1718, (_e1736 + _e1718));
                                    let _e1741 = local_3.member;
                                    let _e1746 = local_4.member;
                                    let _e1752 = ((_e1741[1] * _e1746[2]) - (_e1741[2] * _e1746[1]));
                                    let _e1755 = ((_e1741[2] * _e1746[0]) - (_e1741[0] * _e1746[2]));
                                    let _e1758 = ((_e1741[0] * _e1746[1]) - (_e1741[1] * _e1746[0]));
                                    if (_e1752 < 0.0lf) {
                                        phi_4819_ = -(_e1752);
                                    } else {
                                        phi_4819_ = _e1752;
                                    }
                                    let _e1762 = phi_4819_;
                                    if (_e1755 < 0.0lf) {
                                        phi_4825_ = -(_e1755);
                                    } else {
                                        phi_4825_ = _e1755;
                                    }
                                    let _e1766 = phi_4825_;
                                    if (_e1762 > _e1766) {
                                        if (_e1752 < 0.0lf) {
                                            phi_4835_ = -(_e1752);
                                        } else {
                                            phi_4835_ = _e1752;
                                        }
                                        let _e1784 = phi_4835_;
                                        if (_e1758 < 0.0lf) {
                                            phi_4841_ = -(_e1758);
                                        } else {
                                            phi_4841_ = _e1758;
                                        }
                                        let _e1788 = phi_4841_;
                                        if (_e1784 > _e1788) {
                                            phi_4846_ = 2u;
                                            phi_4847_ = 1u;
                                        } else {
                                            phi_4846_ = 1u;
                                            phi_4847_ = 0u;
                                        }
                                        let _e1791 = phi_4846_;
                                        let _e1793 = phi_4847_;
                                        phi_4866_ = _e1791;
                                        phi_4867_ = _e1793;
                                    } else {
                                        if (_e1755 < 0.0lf) {
                                            phi_4853_ = -(_e1755);
                                        } else {
                                            phi_4853_ = _e1755;
                                        }
                                        let _e1771 = phi_4853_;
                                        if (_e1758 < 0.0lf) {
                                            phi_4859_ = -(_e1758);
                                        } else {
                                            phi_4859_ = _e1758;
                                        }
                                        let _e1775 = phi_4859_;
                                        if (_e1771 > _e1775) {
                                            phi_4864_ = 0u;
                                            phi_4865_ = 2u;
                                        } else {
                                            phi_4864_ = 1u;
                                            phi_4865_ = 0u;
                                        }
                                        let _e1778 = phi_4864_;
                                        let _e1780 = phi_4865_;
                                        phi_4866_ = _e1778;
                                        phi_4867_ = _e1780;
                                    }
                                    let _e1795 = phi_4866_;
                                    let _e1797 = phi_4867_;
                                    let _e1800 = local_3.member[_e1797];
                                    let _e1803 = local_4.member[_e1795];
                                    let _e1807 = local_3.member[_e1795];
                                    let _e1810 = local_4.member[_e1797];
                                    let _e1812 = ((_e1800 * _e1803) - (_e1807 * _e1810));
                                    let _e1813 = f64(1f);
                                    let _e1815 = local_3.member_1;
                                    let _e1817 = local_4.member_2;
                                    let _e1820 = local_3.member_2;
                                    let _e1822 = local_4.member_1;
                                    let _e1828 = local_3.member_2;
                                    let _e1830 = local_4.member_2;
                                    let _e1839 = local_3.member_2;
                                    let _e1842 = local_4.member_2;
                                    let _e1846 = (((((_e1815 * _e1817) + (_e1820 * _e1822)) * f64(2.01f)) + ((_e1828 * _e1830) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1813 + _e1839) * (_e1813 + _e1842))));
                                    if (_e1812 < 0.0lf) {
                                        phi_4938_ = -(_e1812);
                                    } else {
                                        phi_4938_ = _e1812;
                                    }
                                    let _e1850 = phi_4938_;
                                    if (_e1850 > _e1846) {
                                        if (_e1812 < f64(0f)) {
                                            phi_4950_ = f64(-1f);
                                        } else {
                                            phi_4950_ = f64(1f);
                                        }
                                        let _e1857 = phi_4950_;
                                        let _e1860 = local_2.member[_e1797];
                                        let _e1863 = local_4.member[_e1795];
                                        let _e1867 = local_2.member[_e1795];
                                        let _e1870 = local_4.member[_e1797];
                                        let _e1873 = f64(1f);
                                        let _e1875 = local_2.member_1;
                                        let _e1877 = local_4.member_2;
                                        let _e1880 = local_2.member_2;
                                        let _e1882 = local_4.member_1;
                                        let _e1888 = local_2.member_2;
                                        let _e1890 = local_4.member_2;
                                        let _e1899 = local_2.member_2;
                                        let _e1902 = local_4.member_2;
                                        let _e1906 = (((((_e1875 * _e1877) + (_e1880 * _e1882)) * f64(2.01f)) + ((_e1888 * _e1890) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1873 + _e1899) * (_e1873 + _e1902))));
                                        let _e1909 = local_3.member[_e1797];
                                        let _e1912 = local_2.member[_e1795];
                                        let _e1916 = local_3.member[_e1795];
                                        let _e1919 = local_2.member[_e1797];
                                        let _e1922 = f64(1f);
                                        let _e1924 = local_3.member_1;
                                        let _e1926 = local_2.member_2;
                                        let _e1929 = local_3.member_2;
                                        let _e1931 = local_2.member_1;
                                        let _e1937 = local_3.member_2;
                                        let _e1939 = local_2.member_2;
                                        let _e1948 = local_3.member_2;
                                        let _e1951 = local_2.member_2;
                                        let _e1955 = (((((_e1924 * _e1926) + (_e1929 * _e1931)) * f64(2.01f)) + ((_e1937 * _e1939) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1922 + _e1948) * (_e1922 + _e1951))));
                                        let _e1956 = (_e1812 * _e1857);
                                        let _e1957 = (((_e1860 * _e1863) - (_e1867 * _e1870)) * _e1857);
                                        let _e1958 = (((_e1909 * _e1912) - (_e1916 * _e1919)) * _e1857);
                                        if (_e1956 < 0.0lf) {
                                            phi_5089_ = -(_e1956);
                                        } else {
                                            phi_5089_ = _e1956;
                                        }
                                        let _e1962 = phi_5089_;
                                        if (_e1957 < 0.0lf) {
                                            phi_5095_ = -(_e1957);
                                        } else {
                                            phi_5095_ = _e1957;
                                        }
                                        let _e1966 = phi_5095_;
                                        if (_e1958 < 0.0lf) {
                                            phi_5102_ = -(_e1958);
                                        } else {
                                            phi_5102_ = _e1958;
                                        }
                                        let _e1971 = phi_5102_;
                                        let _e1977 = ((_e1956 - _e1957) - _e1958);
                                        let _e1980 = (((_e1846 + _e1906) + _e1955) + (((_e1962 + _e1966) + _e1971) * (1.1102230246251565e-16lf * f64(4f))));
                                        local_5[0u].member = _e1957;
                                        local_5[0u].member_1 = _e1906;
                                        local_5[1u].member = _e1958;
                                        local_5[1u].member_1 = _e1955;
                                        local_5[2u].member = _e1977;
                                        local_5[2u].member_1 = _e1980;
                                        local_5[3u].member = _e1977;
                                        local_5[3u].member_1 = _e1980;
                                        phi_5146_ = type_19(0u, 4u);
                                        phi_5149_ = true;
                                        loop {
                                            let _e1995 = phi_5146_;
                                            let _e1997 = phi_5149_;
                                            local_17 = _e1997;
                                            if (_e1995.member < _e1995.member_1) {
                                                phi_5147_ = type_19((_e1995.member + 1u), _e1995.member_1);
                                                phi_5172_ = type_19(1u, _e1995.member);
                                            } else {
                                                phi_5147_ = _e1995;
                                                phi_5172_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e2009 = phi_5147_;
                                            let _e2011 = phi_5172_;
                                            if (bitcast<i32>(_e2011.member) != 0i) {
                                                let _e2018 = local_5[_e2011.member_1].member;
                                                let _e2021 = local_5[_e2011.member_1].member_1;
                                                let _e2023 = (_e2018 < -(_e2021));
                                                if _e2023 {
                                                    phi_5199_ = bool();
                                                    phi_5200_ = false;
                                                } else {
                                                    phi_5199_ = (_e1997 && (_e2018 > _e2021));
                                                    phi_5200_ = true;
                                                }
                                                let _e2027 = phi_5199_;
                                                let _e2029 = phi_5200_;
                                                phi_5150_ = _e2027;
                                                phi_5201_ = _e2029;
                                                phi_5202_ = _e2023;
                                            } else {
                                                phi_5150_ = bool();
                                                phi_5201_ = false;
                                                phi_5202_ = false;
                                            }
                                            let _e2031 = phi_5150_;
                                            let _e2033 = phi_5201_;
                                            let _e2035 = phi_5202_;
                                            local_16 = _e2035;
                                            continue;
                                            continuing {
                                                phi_5146_ = _e2009;
                                                phi_5149_ = _e2031;
                                                break if !(_e2033);
                                            }
                                        }
                                        let _e2038 = local_16;
                                        if _e2038 {
                                            phi_5206_ = false;
                                        } else {
                                            phi_5206_ = true;
                                        }
                                        let _e2040 = phi_5206_;
                                        if _e2040 {
                                            let _e2042 = local_17;
                                            if _e2042 {
                                                phi_5213_ = 1u;
                                            } else {
                                                phi_5213_ = 2u;
                                            }
                                            let _e2044 = phi_5213_;
                                            phi_5214_ = _e2044;
                                            phi_5215_ = false;
                                        } else {
                                            phi_5214_ = u32();
                                            phi_5215_ = true;
                                        }
                                        let _e2046 = phi_5214_;
                                        let _e2048 = phi_5215_;
                                        phi_5216_ = _e2046;
                                        phi_5217_ = 0u;
                                        phi_5218_ = _e2048;
                                    } else {
                                        phi_5216_ = u32();
                                        phi_5217_ = 2u;
                                        phi_5218_ = true;
                                    }
                                    let _e2050 = phi_5216_;
                                    let _e2052 = phi_5217_;
                                    let _e2054 = phi_5218_;
                                    if _e2054 {
                                        phi_5222_ = _e2052;
                                    } else {
                                        phi_5222_ = _e2050;
                                    }
                                    let _e2056 = phi_5222_;
                                    let _e2057 = (_e2056 == 0u);
                                    if _e2057 {
                                        phi_6279_ = f64();
                                        phi_6280_ = false;
                                        phi_6281_ = false;
                                        phi_6282_ = false;
                                    } else {
                                        if (_e2056 == 1u) {
                                            if _e1331.member_2 {
                                                if ((_e1331.member_1 - _e1331.member) <= f64(0.0000005f)) {
                                                    phi_5243_ = false;
                                                } else {
                                                    phi_5243_ = true;
                                                }
                                                let _e2066 = phi_5243_;
                                                phi_5244_ = _e2066;
                                            } else {
                                                phi_5244_ = true;
                                            }
                                            let _e2068 = phi_5244_;
                                            phi_5245_ = _e2068;
                                        } else {
                                            phi_5245_ = true;
                                        }
                                        let _e2070 = phi_5245_;
                                        if _e2070 {
                                            let _e2076 = local_12.member[0u];
                                            let _e2082 = local_12.member_1[0u];
                                            let _e2088 = local_12.member_2[0u];
                                            local = array<array<f64, 3>, 4>(_e2076, array<f64, 3>((_e2076[0] - _e2082[0]), (_e2076[1] - _e2082[1]), (_e2076[2] - _e2082[2])), array<f64, 3>((_e2076[0] - _e2088[0]), (_e2076[1] - _e2088[1]), (_e2076[2] - _e2088[2])), _e2076);
                                            let _e2103 = local_12.member[1u];
                                            let _e2109 = local_12.member_1[1u];
                                            let _e2115 = local_12.member_2[1u];
                                            local_1 = array<array<f64, 3>, 4>(_e2103, array<f64, 3>((_e2103[0] - _e2109[0]), (_e2103[1] - _e2109[1]), (_e2103[2] - _e2109[2])), array<f64, 3>((_e2103[0] - _e2115[0]), (_e2103[1] - _e2115[1]), (_e2103[2] - _e2115[2])), _e2103);
                                            let _e2130 = local_12.member[0u];
                                            if (_e2130[0] < 0.0lf) {
                                                phi_5442_ = -(_e2130[0]);
                                            } else {
                                                phi_5442_ = _e2130[0];
                                            }
                                            let _e2137 = phi_5442_;
                                            if (_e2130[1] < 0.0lf) {
                                                phi_5449_ = -(_e2130[1]);
                                            } else {
                                                phi_5449_ = _e2130[1];
                                            }
                                            let _e2141 = phi_5449_;
                                            if (_e2137 > _e2141) {
                                                phi_5454_ = _e2137;
                                            } else {
                                                phi_5454_ = _e2141;
                                            }
                                            let _e2144 = phi_5454_;
                                            if (_e2130[2] < 0.0lf) {
                                                phi_5461_ = -(_e2130[2]);
                                            } else {
                                                phi_5461_ = _e2130[2];
                                            }
                                            let _e2148 = phi_5461_;
                                            if (_e2144 > _e2148) {
                                                phi_5466_ = _e2144;
                                            } else {
                                                phi_5466_ = _e2148;
                                            }
                                            let _e2151 = phi_5466_;
                                            let _e2154 = local_12.member[1u];
                                            if (_e2154[0] < 0.0lf) {
                                                phi_5479_ = -(_e2154[0]);
                                            } else {
                                                phi_5479_ = _e2154[0];
                                            }
                                            let _e2161 = phi_5479_;
                                            if (_e2154[1] < 0.0lf) {
                                                phi_5486_ = -(_e2154[1]);
                                            } else {
                                                phi_5486_ = _e2154[1];
                                            }
                                            let _e2165 = phi_5486_;
                                            if (_e2161 > _e2165) {
                                                phi_5491_ = _e2161;
                                            } else {
                                                phi_5491_ = _e2165;
                                            }
                                            let _e2168 = phi_5491_;
                                            if (_e2154[2] < 0.0lf) {
                                                phi_5498_ = -(_e2154[2]);
                                            } else {
                                                phi_5498_ = _e2154[2];
                                            }
                                            let _e2172 = phi_5498_;
                                            if (_e2168 > _e2172) {
                                                phi_5503_ = _e2168;
                                            } else {
                                                phi_5503_ = _e2172;
                                            }
                                            let _e2175 = phi_5503_;
                                            if (_e2151 > _e2175) {
                                                phi_5508_ = _e2151;
                                            } else {
                                                phi_5508_ = _e2175;
                                            }
                                            let _e2178 = phi_5508_;
                                            let _e2180 = local_12.member_3;
                                            let _e2184 = local_12.member_1[0u];
                                            if (_e2184[0] < 0.0lf) {
                                                phi_5525_ = -(_e2184[0]);
                                            } else {
                                                phi_5525_ = _e2184[0];
                                            }
                                            let _e2191 = phi_5525_;
                                            if (_e2184[1] < 0.0lf) {
                                                phi_5532_ = -(_e2184[1]);
                                            } else {
                                                phi_5532_ = _e2184[1];
                                            }
                                            let _e2195 = phi_5532_;
                                            if (_e2191 > _e2195) {
                                                phi_5537_ = _e2191;
                                            } else {
                                                phi_5537_ = _e2195;
                                            }
                                            let _e2198 = phi_5537_;
                                            if (_e2184[2] < 0.0lf) {
                                                phi_5544_ = -(_e2184[2]);
                                            } else {
                                                phi_5544_ = _e2184[2];
                                            }
                                            let _e2202 = phi_5544_;
                                            if (_e2198 > _e2202) {
                                                phi_5549_ = _e2198;
                                            } else {
                                                phi_5549_ = _e2202;
                                            }
                                            let _e2205 = phi_5549_;
                                            let _e2208 = local_12.member_1[1u];
                                            if (_e2208[0] < 0.0lf) {
                                                phi_5563_ = -(_e2208[0]);
                                            } else {
                                                phi_5563_ = _e2208[0];
                                            }
                                            let _e2215 = phi_5563_;
                                            if (_e2208[1] < 0.0lf) {
                                                phi_5570_ = -(_e2208[1]);
                                            } else {
                                                phi_5570_ = _e2208[1];
                                            }
                                            let _e2219 = phi_5570_;
                                            if (_e2215 > _e2219) {
                                                phi_5575_ = _e2215;
                                            } else {
                                                phi_5575_ = _e2219;
                                            }
                                            let _e2222 = phi_5575_;
                                            if (_e2208[2] < 0.0lf) {
                                                phi_5582_ = -(_e2208[2]);
                                            } else {
                                                phi_5582_ = _e2208[2];
                                            }
                                            let _e2226 = phi_5582_;
                                            if (_e2222 > _e2226) {
                                                phi_5587_ = _e2222;
                                            } else {
                                                phi_5587_ = _e2226;
                                            }
                                            let _e2229 = phi_5587_;
                                            if (_e2205 > _e2229) {
                                                phi_5592_ = _e2205;
                                            } else {
                                                phi_5592_ = _e2229;
                                            }
                                            let _e2232 = phi_5592_;
                                            let _e2234 = local_12.member_3;
                                            let _e2238 = local_12.member_2[0u];
                                            if (_e2238[0] < 0.0lf) {
                                                phi_5609_ = -(_e2238[0]);
                                            } else {
                                                phi_5609_ = _e2238[0];
                                            }
                                            let _e2245 = phi_5609_;
                                            if (_e2238[1] < 0.0lf) {
                                                phi_5616_ = -(_e2238[1]);
                                            } else {
                                                phi_5616_ = _e2238[1];
                                            }
                                            let _e2249 = phi_5616_;
                                            if (_e2245 > _e2249) {
                                                phi_5621_ = _e2245;
                                            } else {
                                                phi_5621_ = _e2249;
                                            }
                                            let _e2252 = phi_5621_;
                                            if (_e2238[2] < 0.0lf) {
                                                phi_5628_ = -(_e2238[2]);
                                            } else {
                                                phi_5628_ = _e2238[2];
                                            }
                                            let _e2256 = phi_5628_;
                                            if (_e2252 > _e2256) {
                                                phi_5633_ = _e2252;
                                            } else {
                                                phi_5633_ = _e2256;
                                            }
                                            let _e2259 = phi_5633_;
                                            let _e2262 = local_12.member_2[1u];
                                            if (_e2262[0] < 0.0lf) {
                                                phi_5647_ = -(_e2262[0]);
                                            } else {
                                                phi_5647_ = _e2262[0];
                                            }
                                            let _e2269 = phi_5647_;
                                            if (_e2262[1] < 0.0lf) {
                                                phi_5654_ = -(_e2262[1]);
                                            } else {
                                                phi_5654_ = _e2262[1];
                                            }
                                            let _e2273 = phi_5654_;
                                            if (_e2269 > _e2273) {
                                                phi_5659_ = _e2269;
                                            } else {
                                                phi_5659_ = _e2273;
                                            }
                                            let _e2276 = phi_5659_;
                                            if (_e2262[2] < 0.0lf) {
                                                phi_5666_ = -(_e2262[2]);
                                            } else {
                                                phi_5666_ = _e2262[2];
                                            }
                                            let _e2280 = phi_5666_;
                                            if (_e2276 > _e2280) {
                                                phi_5671_ = _e2276;
                                            } else {
                                                phi_5671_ = _e2280;
                                            }
                                            let _e2283 = phi_5671_;
                                            if (_e2259 > _e2283) {
                                                phi_5676_ = _e2259;
                                            } else {
                                                phi_5676_ = _e2283;
                                            }
                                            let _e2286 = phi_5676_;
                                            let _e2288 = local_12.member_3;
                                            let _e2296 = local_12.member_3;
                                            phi_5696_ = type_19(0u, 48u);
                                            phi_5699_ = _e1331.member;
                                            loop {
                                                let _e2305 = phi_5696_;
                                                let _e2307 = phi_5699_;
                                                local_61 = _e2307;
                                                local_24 = _e2307;
                                                local_25 = _e2307;
                                                local_26 = _e2307;
                                                local_27 = _e2307;
                                                if (_e2305.member < _e2305.member_1) {
                                                    phi_5697_ = type_19((_e2305.member + 1u), _e2305.member_1);
                                                    phi_5722_ = type_19(1u, _e2305.member);
                                                } else {
                                                    phi_5697_ = _e2305;
                                                    phi_5722_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2319 = phi_5697_;
                                                let _e2321 = phi_5722_;
                                                if (bitcast<i32>(_e2321.member) != 0i) {
                                                    let _e2327 = local_12.member[0u];
                                                    let _e2333 = local_12.member[1u];
                                                    let _e2349 = local_12.member_1[0u];
                                                    let _e2355 = local_12.member_1[1u];
                                                    let _e2371 = local_12.member_2[0u];
                                                    let _e2377 = local_12.member_2[1u];
                                                    let _e2391 = function_2(array<f64, 3>((_e2327[0] + ((_e2333[0] - _e2327[0]) * _e2307)), (_e2327[1] + ((_e2333[1] - _e2327[1]) * _e2307)), (_e2327[2] + ((_e2333[2] - _e2327[2]) * _e2307))), array<f64, 3>((_e2349[0] + ((_e2355[0] - _e2349[0]) * _e2307)), (_e2349[1] + ((_e2355[1] - _e2349[1]) * _e2307)), (_e2349[2] + ((_e2355[2] - _e2349[2]) * _e2307))), array<f64, 3>((_e2371[0] + ((_e2377[0] - _e2371[0]) * _e2307)), (_e2371[1] + ((_e2377[1] - _e2371[1]) * _e2307)), (_e2371[2] + ((_e2377[2] - _e2371[2]) * _e2307))), 0u);
                                                    if (_e2391[0] < 0.0lf) {
                                                        phi_5833_ = -(_e2391[0]);
                                                    } else {
                                                        phi_5833_ = _e2391[0];
                                                    }
                                                    let _e2396 = phi_5833_;
                                                    if (_e2391[1] < 0.0lf) {
                                                        phi_5840_ = -(_e2391[1]);
                                                    } else {
                                                        phi_5840_ = _e2391[1];
                                                    }
                                                    let _e2401 = phi_5840_;
                                                    if (_e2391[2] < 0.0lf) {
                                                        phi_5848_ = -(_e2391[2]);
                                                    } else {
                                                        phi_5848_ = _e2391[2];
                                                    }
                                                    let _e2407 = phi_5848_;
                                                    let _e2408 = ((_e2396 + _e2401) + _e2407);
                                                    if (_e2408 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2408) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2414 = (f64(1f) / _e2408);
                                                            let _e2416 = (_e2391[0] * _e2414);
                                                            let _e2418 = (_e2391[1] * _e2414);
                                                            let _e2420 = (_e2391[2] * _e2414);
                                                            let _e2425 = (((_e2416 * _e2416) + (_e2418 * _e2418)) + (_e2420 * _e2420));
                                                            if (_e2425 <= 2.2250738585072014e-308lf) {
                                                                if (_e2425 > 0.0lf) {
                                                                    phi_5886_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_5886_ = 0.0lf;
                                                                }
                                                                let _e2477 = phi_5886_;
                                                                phi_5950_ = _e2477;
                                                            } else {
                                                                phi_5893_ = type_17(0i, 5i);
                                                                phi_5896_ = bitcast<f64>(((bitcast<u64>(_e2425) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2432 = phi_5893_;
                                                                    let _e2434 = phi_5896_;
                                                                    local_18 = _e2434;
                                                                    if (_e2432.member < _e2432.member_1) {
                                                                        let _e2441 = (_e2432.member + 1i);
                                                                        if ((false == (_e2441 > _e2432.member)) != false) {
                                                                            phi_5917_ = true;
                                                                        } else {
                                                                            phi_5917_ = false;
                                                                        }
                                                                        let _e2446 = phi_5917_;
                                                                        if _e2446 {
                                                                            phi_5923_ = type_18(0u, type_18().member_1);
                                                                        } else {
                                                                            phi_5923_ = type_18(1u, _e2441);
                                                                        }
                                                                        let _e2451 = phi_5923_;
                                                                        phi_5894_ = type_17(_e2451.member_1, _e2432.member_1);
                                                                        phi_5937_ = type_18(1u, _e2432.member);
                                                                    } else {
                                                                        phi_5894_ = _e2432;
                                                                        phi_5937_ = type_18(0u, type_18().member_1);
                                                                    }
                                                                    let _e2457 = phi_5894_;
                                                                    let _e2459 = phi_5937_;
                                                                    let _e2462 = (bitcast<i32>(_e2459.member) != 0i);
                                                                    if _e2462 {
                                                                        phi_5897_ = (0.5lf * (_e2434 + (_e2425 / _e2434)));
                                                                    } else {
                                                                        phi_5897_ = f64();
                                                                    }
                                                                    let _e2467 = phi_5897_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_5893_ = _e2457;
                                                                        phi_5896_ = _e2467;
                                                                        break if !(_e2462);
                                                                    }
                                                                }
                                                                let _e2472 = local_18;
                                                                phi_5950_ = (_e2472 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2479 = phi_5950_;
                                                            phi_5963_ = type_19(0u, 4u);
                                                            phi_5966_ = f64(2f);
                                                            loop {
                                                                let _e2491 = phi_5963_;
                                                                let _e2493 = phi_5966_;
                                                                local_20 = _e2493;
                                                                local_21 = _e2493;
                                                                local_22 = _e2493;
                                                                local_51 = _e2493;
                                                                local_52 = _e2493;
                                                                if (_e2491.member < _e2491.member_1) {
                                                                    phi_5964_ = type_19((_e2491.member + 1u), _e2491.member_1);
                                                                    phi_5989_ = type_19(1u, _e2491.member);
                                                                } else {
                                                                    phi_5964_ = _e2491;
                                                                    phi_5989_ = type_19(0u, type_19().member_1);
                                                                }
                                                                let _e2505 = phi_5964_;
                                                                let _e2507 = phi_5989_;
                                                                if (bitcast<i32>(_e2507.member) != 0i) {
                                                                    let _e2513 = local[_e2507.member_1];
                                                                    let _e2521 = (((_e2416 * _e2513[0]) + (_e2418 * _e2513[1])) + (_e2420 * _e2513[2]));
                                                                    let _e2523 = local_1[_e2507.member_1];
                                                                    let _e2531 = (((_e2416 * _e2523[0]) + (_e2418 * _e2523[1])) + (_e2420 * _e2523[2]));
                                                                    if (_e2521 < 0.0lf) {
                                                                        phi_6040_ = -(_e2521);
                                                                    } else {
                                                                        phi_6040_ = _e2521;
                                                                    }
                                                                    let _e2535 = phi_6040_;
                                                                    if (_e2531 < 0.0lf) {
                                                                        phi_6046_ = -(_e2531);
                                                                    } else {
                                                                        phi_6046_ = _e2531;
                                                                    }
                                                                    let _e2539 = phi_6046_;
                                                                    let _e2544 = (((((((((_e2178 + _e2180) + (_e2232 + _e2234)) + (_e2286 + _e2288)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2296 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2479) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2535 + _e2539) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2521 > _e2544) {
                                                                        if (_e2531 > _e2544) {
                                                                            phi_6060_ = false;
                                                                        } else {
                                                                            phi_6060_ = true;
                                                                        }
                                                                        let _e2548 = phi_6060_;
                                                                        phi_6061_ = _e2548;
                                                                    } else {
                                                                        phi_6061_ = true;
                                                                    }
                                                                    let _e2550 = phi_6061_;
                                                                    if _e2550 {
                                                                        if ((_e2521 + ((_e2531 - _e2521) * _e2307)) > _e2544) {
                                                                            if (_e2531 < _e2521) {
                                                                                let _e2559 = ((_e2521 - _e2531) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                                                if _e2559 {
                                                                                    let _e2567 = (((_e2521 - _e2544) / (_e2521 - _e2531)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    if (_e2493 < _e2567) {
                                                                                        phi_6095_ = _e2493;
                                                                                    } else {
                                                                                        phi_6095_ = _e2567;
                                                                                    }
                                                                                    let _e2570 = phi_6095_;
                                                                                    phi_6096_ = _e2570;
                                                                                } else {
                                                                                    phi_6096_ = f64();
                                                                                }
                                                                                let _e2572 = phi_6096_;
                                                                                phi_6097_ = _e2572;
                                                                                phi_6098_ = _e2559;
                                                                            } else {
                                                                                phi_6097_ = _e2493;
                                                                                phi_6098_ = true;
                                                                            }
                                                                            let _e2574 = phi_6097_;
                                                                            let _e2576 = phi_6098_;
                                                                            if _e2576 {
                                                                                phi_6102_ = false;
                                                                            } else {
                                                                                phi_6102_ = true;
                                                                            }
                                                                            let _e2578 = phi_6102_;
                                                                            phi_6103_ = _e2574;
                                                                            phi_6104_ = _e2576;
                                                                            phi_6105_ = _e2578;
                                                                            phi_6106_ = false;
                                                                        } else {
                                                                            phi_6103_ = f64();
                                                                            phi_6104_ = false;
                                                                            phi_6105_ = false;
                                                                            phi_6106_ = true;
                                                                        }
                                                                        let _e2580 = phi_6103_;
                                                                        let _e2582 = phi_6104_;
                                                                        let _e2584 = phi_6105_;
                                                                        let _e2586 = phi_6106_;
                                                                        phi_6107_ = _e2580;
                                                                        phi_6108_ = _e2582;
                                                                        phi_6109_ = _e2584;
                                                                        phi_6110_ = _e2586;
                                                                    } else {
                                                                        phi_6107_ = _e2493;
                                                                        phi_6108_ = true;
                                                                        phi_6109_ = false;
                                                                        phi_6110_ = false;
                                                                    }
                                                                    let _e2588 = phi_6107_;
                                                                    let _e2590 = phi_6108_;
                                                                    let _e2592 = phi_6109_;
                                                                    let _e2594 = phi_6110_;
                                                                    phi_5967_ = _e2588;
                                                                    phi_6111_ = _e2590;
                                                                    phi_6112_ = false;
                                                                    phi_6113_ = _e2592;
                                                                    phi_6114_ = _e2594;
                                                                } else {
                                                                    phi_5967_ = f64();
                                                                    phi_6111_ = false;
                                                                    phi_6112_ = true;
                                                                    phi_6113_ = false;
                                                                    phi_6114_ = false;
                                                                }
                                                                let _e2596 = phi_5967_;
                                                                let _e2598 = phi_6111_;
                                                                let _e2600 = phi_6112_;
                                                                let _e2602 = phi_6113_;
                                                                let _e2604 = phi_6114_;
                                                                local_19 = _e2600;
                                                                local_49 = _e2602;
                                                                local_50 = _e2604;
                                                                continue;
                                                                continuing {
                                                                    phi_5963_ = _e2505;
                                                                    phi_5966_ = _e2596;
                                                                    break if !(_e2598);
                                                                }
                                                            }
                                                            let _e2607 = local_19;
                                                            if _e2607 {
                                                                let _e2609 = local_20;
                                                                let _e2610 = (_e2609 > _e1331.member_1);
                                                                if _e2610 {
                                                                    phi_6136_ = false;
                                                                    phi_6137_ = false;
                                                                    phi_6138_ = false;
                                                                } else {
                                                                    let _e2612 = local_21;
                                                                    if (_e2612 > _e2307) {
                                                                        let _e2615 = local_22;
                                                                        let _e2618 = ((_e2615 - _e2307) < f64(0.00000000023283064f));
                                                                        if _e2618 {
                                                                            phi_6132_ = false;
                                                                        } else {
                                                                            phi_6132_ = true;
                                                                        }
                                                                        let _e2620 = phi_6132_;
                                                                        phi_6133_ = _e2620;
                                                                        phi_6134_ = _e2618;
                                                                        phi_6135_ = false;
                                                                    } else {
                                                                        phi_6133_ = false;
                                                                        phi_6134_ = false;
                                                                        phi_6135_ = true;
                                                                    }
                                                                    let _e2622 = phi_6133_;
                                                                    let _e2624 = phi_6134_;
                                                                    let _e2626 = phi_6135_;
                                                                    phi_6136_ = _e2622;
                                                                    phi_6137_ = _e2624;
                                                                    phi_6138_ = _e2626;
                                                                }
                                                                let _e2628 = phi_6136_;
                                                                let _e2630 = phi_6137_;
                                                                let _e2632 = phi_6138_;
                                                                phi_6139_ = _e2628;
                                                                phi_6140_ = _e2610;
                                                                phi_6141_ = _e2630;
                                                                phi_6142_ = _e2632;
                                                                phi_6143_ = false;
                                                                phi_6144_ = false;
                                                            } else {
                                                                phi_6139_ = false;
                                                                phi_6140_ = false;
                                                                phi_6141_ = false;
                                                                phi_6142_ = false;
                                                                let _e4490 = local_49;
                                                                phi_6143_ = _e4490;
                                                                let _e4493 = local_50;
                                                                phi_6144_ = _e4493;
                                                            }
                                                            let _e2634 = phi_6139_;
                                                            let _e2636 = phi_6140_;
                                                            let _e2638 = phi_6141_;
                                                            let _e2640 = phi_6142_;
                                                            let _e2642 = phi_6143_;
                                                            let _e2644 = phi_6144_;
                                                            let _e4496 = local_51;
                                                            phi_6145_ = _e4496;
                                                            let _e4499 = local_52;
                                                            phi_6146_ = _e4499;
                                                            phi_6147_ = _e2634;
                                                            phi_6148_ = _e2636;
                                                            phi_6149_ = _e2638;
                                                            phi_6150_ = _e2640;
                                                            phi_6151_ = _e2642;
                                                            phi_6152_ = _e2644;
                                                            phi_6153_ = false;
                                                        } else {
                                                            phi_6145_ = f64();
                                                            phi_6146_ = f64();
                                                            phi_6147_ = false;
                                                            phi_6148_ = false;
                                                            phi_6149_ = false;
                                                            phi_6150_ = false;
                                                            phi_6151_ = false;
                                                            phi_6152_ = false;
                                                            phi_6153_ = true;
                                                        }
                                                        let _e2646 = phi_6145_;
                                                        let _e2648 = phi_6146_;
                                                        let _e2650 = phi_6147_;
                                                        let _e2652 = phi_6148_;
                                                        let _e2654 = phi_6149_;
                                                        let _e2656 = phi_6150_;
                                                        let _e2658 = phi_6151_;
                                                        let _e2660 = phi_6152_;
                                                        let _e2662 = phi_6153_;
                                                        phi_6154_ = _e2646;
                                                        phi_6155_ = _e2648;
                                                        phi_6156_ = _e2650;
                                                        phi_6157_ = _e2652;
                                                        phi_6158_ = _e2654;
                                                        phi_6159_ = _e2656;
                                                        phi_6160_ = _e2658;
                                                        phi_6161_ = _e2660;
                                                        phi_6162_ = _e2662;
                                                        phi_6163_ = false;
                                                    } else {
                                                        phi_6154_ = f64();
                                                        phi_6155_ = f64();
                                                        phi_6156_ = false;
                                                        phi_6157_ = false;
                                                        phi_6158_ = false;
                                                        phi_6159_ = false;
                                                        phi_6160_ = false;
                                                        phi_6161_ = false;
                                                        phi_6162_ = false;
                                                        phi_6163_ = true;
                                                    }
                                                    let _e2664 = phi_6154_;
                                                    let _e2666 = phi_6155_;
                                                    let _e2668 = phi_6156_;
                                                    let _e2670 = phi_6157_;
                                                    let _e2672 = phi_6158_;
                                                    let _e2674 = phi_6159_;
                                                    let _e2676 = phi_6160_;
                                                    let _e2678 = phi_6161_;
                                                    let _e2680 = phi_6162_;
                                                    let _e2682 = phi_6163_;
                                                    phi_6164_ = _e2664;
                                                    phi_5700_ = _e2666;
                                                    phi_6165_ = _e2668;
                                                    phi_6166_ = _e2670;
                                                    phi_6167_ = _e2672;
                                                    phi_6168_ = false;
                                                    phi_6169_ = _e2674;
                                                    phi_6170_ = _e2676;
                                                    phi_6171_ = _e2678;
                                                    phi_6172_ = _e2680;
                                                    phi_6173_ = _e2682;
                                                } else {
                                                    phi_6164_ = f64();
                                                    phi_5700_ = f64();
                                                    phi_6165_ = false;
                                                    phi_6166_ = false;
                                                    phi_6167_ = false;
                                                    phi_6168_ = true;
                                                    phi_6169_ = false;
                                                    phi_6170_ = false;
                                                    phi_6171_ = false;
                                                    phi_6172_ = false;
                                                    phi_6173_ = false;
                                                }
                                                let _e2684 = phi_6164_;
                                                let _e2686 = phi_5700_;
                                                let _e2688 = phi_6165_;
                                                let _e2690 = phi_6166_;
                                                let _e2692 = phi_6167_;
                                                let _e2694 = phi_6168_;
                                                let _e2696 = phi_6169_;
                                                let _e2698 = phi_6170_;
                                                let _e2700 = phi_6171_;
                                                let _e2702 = phi_6172_;
                                                let _e2704 = phi_6173_;
                                                local_23 = _e2690;
                                                local_53 = _e2692;
                                                local_54 = _e2694;
                                                local_55 = _e2696;
                                                local_56 = _e2698;
                                                local_57 = _e2700;
                                                local_58 = _e2702;
                                                local_59 = _e2704;
                                                local_60 = _e2684;
                                                local_62 = _e2690;
                                                continue;
                                                continuing {
                                                    phi_5696_ = _e2319;
                                                    phi_5699_ = _e2686;
                                                    break if !(_e2688);
                                                }
                                            }
                                            let _e2707 = local_23;
                                            if _e2707 {
                                                phi_6178_ = type_40(0u, type_40().member_1);
                                                phi_6179_ = false;
                                                phi_6180_ = false;
                                                phi_6181_ = false;
                                                phi_6182_ = false;
                                                phi_6183_ = false;
                                                phi_6184_ = false;
                                                phi_6185_ = false;
                                            } else {
                                                phi_6178_ = type_40();
                                                let _e4532 = local_53;
                                                phi_6179_ = _e4532;
                                                let _e4535 = local_54;
                                                phi_6180_ = _e4535;
                                                let _e4538 = local_55;
                                                phi_6181_ = _e4538;
                                                let _e4541 = local_56;
                                                phi_6182_ = _e4541;
                                                let _e4544 = local_57;
                                                phi_6183_ = _e4544;
                                                let _e4547 = local_58;
                                                phi_6184_ = _e4547;
                                                let _e4550 = local_59;
                                                phi_6185_ = _e4550;
                                            }
                                            let _e2711 = phi_6178_;
                                            let _e2713 = phi_6179_;
                                            let _e2715 = phi_6180_;
                                            let _e2717 = phi_6181_;
                                            let _e2719 = phi_6182_;
                                            let _e2721 = phi_6183_;
                                            let _e2723 = phi_6184_;
                                            let _e2725 = phi_6185_;
                                            if _e2713 {
                                                let _e4553 = local_60;
                                                phi_6189_ = _e4553;
                                                phi_6190_ = true;
                                                phi_6191_ = false;
                                                phi_6192_ = false;
                                                phi_6193_ = false;
                                                phi_6194_ = false;
                                                phi_6195_ = false;
                                                phi_6196_ = false;
                                            } else {
                                                let _e4555 = local_61;
                                                phi_6189_ = _e4555;
                                                phi_6190_ = _e2715;
                                                phi_6191_ = _e2717;
                                                phi_6192_ = _e2719;
                                                phi_6193_ = _e2721;
                                                let _e4562 = local_62;
                                                phi_6194_ = _e4562;
                                                phi_6195_ = _e2723;
                                                phi_6196_ = _e2725;
                                            }
                                            let _e2727 = phi_6189_;
                                            let _e2729 = phi_6190_;
                                            let _e2731 = phi_6191_;
                                            let _e2733 = phi_6192_;
                                            let _e2735 = phi_6193_;
                                            let _e2737 = phi_6194_;
                                            let _e2739 = phi_6195_;
                                            let _e2741 = phi_6196_;
                                            if _e2729 {
                                                phi_6201_ = type_40(1u, _e2727);
                                                phi_6202_ = false;
                                                phi_6203_ = false;
                                                phi_6204_ = false;
                                                phi_6205_ = false;
                                                phi_6206_ = false;
                                                phi_6207_ = false;
                                            } else {
                                                phi_6201_ = type_40();
                                                phi_6202_ = _e2731;
                                                phi_6203_ = _e2733;
                                                phi_6204_ = _e2735;
                                                phi_6205_ = _e2737;
                                                phi_6206_ = _e2739;
                                                phi_6207_ = _e2741;
                                            }
                                            let _e2744 = phi_6201_;
                                            let _e2746 = phi_6202_;
                                            let _e2748 = phi_6203_;
                                            let _e2750 = phi_6204_;
                                            let _e2752 = phi_6205_;
                                            let _e2754 = phi_6206_;
                                            let _e2756 = phi_6207_;
                                            if _e2746 {
                                                let _e2758 = local_24;
                                                phi_6212_ = type_40(1u, _e2758);
                                                phi_6213_ = false;
                                                phi_6214_ = false;
                                                phi_6215_ = true;
                                                phi_6216_ = false;
                                                phi_6217_ = false;
                                            } else {
                                                phi_6212_ = _e2711;
                                                phi_6213_ = _e2748;
                                                phi_6214_ = _e2750;
                                                phi_6215_ = _e2752;
                                                phi_6216_ = _e2754;
                                                phi_6217_ = _e2756;
                                            }
                                            let _e2761 = phi_6212_;
                                            let _e2763 = phi_6213_;
                                            let _e2765 = phi_6214_;
                                            let _e2767 = phi_6215_;
                                            let _e2769 = phi_6216_;
                                            let _e2771 = phi_6217_;
                                            if _e2763 {
                                                let _e2773 = local_25;
                                                phi_6222_ = type_40(1u, _e2773);
                                                phi_6223_ = false;
                                                phi_6224_ = false;
                                                phi_6225_ = false;
                                                phi_6226_ = false;
                                            } else {
                                                phi_6222_ = type_40();
                                                phi_6223_ = _e2765;
                                                phi_6224_ = _e2767;
                                                phi_6225_ = _e2769;
                                                phi_6226_ = _e2771;
                                            }
                                            let _e2776 = phi_6222_;
                                            let _e2778 = phi_6223_;
                                            let _e2780 = phi_6224_;
                                            let _e2782 = phi_6225_;
                                            let _e2784 = phi_6226_;
                                            if _e2778 {
                                                let _e2786 = local_26;
                                                phi_6231_ = type_40(1u, _e2786);
                                                phi_6232_ = true;
                                                phi_6233_ = false;
                                                phi_6234_ = false;
                                                phi_6235_ = false;
                                            } else {
                                                phi_6231_ = _e2776;
                                                phi_6232_ = _e2763;
                                                phi_6233_ = _e2780;
                                                phi_6234_ = _e2782;
                                                phi_6235_ = _e2784;
                                            }
                                            let _e2789 = phi_6231_;
                                            let _e2791 = phi_6232_;
                                            let _e2793 = phi_6233_;
                                            let _e2795 = phi_6234_;
                                            let _e2797 = phi_6235_;
                                            if _e2791 {
                                                phi_6239_ = _e2789;
                                                phi_6240_ = true;
                                                phi_6241_ = false;
                                                phi_6242_ = false;
                                            } else {
                                                phi_6239_ = _e2761;
                                                phi_6240_ = _e2793;
                                                phi_6241_ = _e2795;
                                                phi_6242_ = _e2797;
                                            }
                                            let _e2799 = phi_6239_;
                                            let _e2801 = phi_6240_;
                                            let _e2803 = phi_6241_;
                                            let _e2805 = phi_6242_;
                                            if _e2801 {
                                                phi_6246_ = false;
                                                phi_6247_ = false;
                                            } else {
                                                phi_6246_ = _e2803;
                                                phi_6247_ = _e2805;
                                            }
                                            let _e2807 = phi_6246_;
                                            let _e2809 = phi_6247_;
                                            if _e2807 {
                                                phi_6251_ = false;
                                                phi_6252_ = false;
                                            } else {
                                                phi_6251_ = _e2809;
                                                phi_6252_ = _e2801;
                                            }
                                            let _e2811 = phi_6251_;
                                            let _e2813 = phi_6252_;
                                            if _e2811 {
                                                phi_6256_ = true;
                                                phi_6257_ = false;
                                            } else {
                                                phi_6256_ = _e2807;
                                                phi_6257_ = _e2813;
                                            }
                                            let _e2815 = phi_6256_;
                                            let _e2817 = phi_6257_;
                                            if _e2815 {
                                                let _e2819 = local_27;
                                                phi_6262_ = type_40(1u, _e2819);
                                                phi_6263_ = true;
                                            } else {
                                                phi_6262_ = _e2799;
                                                phi_6263_ = _e2817;
                                            }
                                            let _e2822 = phi_6262_;
                                            let _e2824 = phi_6263_;
                                            if _e2824 {
                                                phi_6267_ = _e2822;
                                            } else {
                                                phi_6267_ = _e2744;
                                            }
                                            let _e2826 = phi_6267_;
                                            let _e2829 = (_e2826.member != 0u);
                                            if _e2829 {
                                                phi_6274_ = false;
                                            } else {
                                                phi_6274_ = true;
                                            }
                                            let _e2831 = phi_6274_;
                                            phi_6275_ = _e2826.member_1;
                                            phi_6276_ = _e2831;
                                            phi_6277_ = _e2829;
                                            phi_6278_ = false;
                                        } else {
                                            phi_6275_ = f64();
                                            phi_6276_ = false;
                                            phi_6277_ = false;
                                            phi_6278_ = true;
                                        }
                                        let _e2833 = phi_6275_;
                                        let _e2835 = phi_6276_;
                                        let _e2837 = phi_6277_;
                                        let _e2839 = phi_6278_;
                                        phi_6279_ = _e2833;
                                        phi_6280_ = _e2835;
                                        phi_6281_ = _e2837;
                                        phi_6282_ = _e2839;
                                    }
                                    let _e2841 = phi_6279_;
                                    let _e2843 = phi_6280_;
                                    let _e2845 = phi_6281_;
                                    let _e2847 = phi_6282_;
                                    phi_6283_ = _e2841;
                                    phi_6284_ = _e2057;
                                    phi_6285_ = _e2843;
                                    phi_6286_ = _e2845;
                                    phi_6287_ = _e2847;
                                }
                                let _e2849 = phi_6283_;
                                let _e2851 = phi_6284_;
                                let _e2853 = phi_6285_;
                                let _e2855 = phi_6286_;
                                let _e2857 = phi_6287_;
                                if _e2851 {
                                    phi_6291_ = true;
                                    phi_6292_ = false;
                                    phi_6293_ = false;
                                } else {
                                    phi_6291_ = _e2853;
                                    phi_6292_ = _e2855;
                                    phi_6293_ = _e2857;
                                }
                                let _e2859 = phi_6291_;
                                let _e2861 = phi_6292_;
                                let _e2863 = phi_6293_;
                                phi_6294_ = _e2849;
                                phi_6295_ = _e1331;
                                phi_6296_ = _e2859;
                                phi_6297_ = false;
                                phi_6298_ = _e2861;
                                phi_6299_ = _e2863;
                            } else {
                                phi_6294_ = f64();
                                phi_6295_ = type_41();
                                phi_6296_ = false;
                                phi_6297_ = true;
                                phi_6298_ = false;
                                phi_6299_ = false;
                            }
                            let _e2865 = phi_6294_;
                            let _e2867 = phi_6295_;
                            let _e2869 = phi_6296_;
                            let _e2871 = phi_6297_;
                            let _e2873 = phi_6298_;
                            let _e2875 = phi_6299_;
                            local_28 = _e2871;
                            local_63 = _e2873;
                            local_64 = _e2875;
                            local_29 = _e2865;
                            local_30 = _e2867;
                            continue;
                            continuing {
                                phi_3735_ = _e1018;
                                break if !(_e2869);
                            }
                        }
                        let _e2878 = local_28;
                        if _e2878 {
                            phi_6304_ = type_40(0u, type_40().member_1);
                            phi_6305_ = false;
                            phi_6306_ = false;
                        } else {
                            phi_6304_ = type_40();
                            let _e4632 = local_63;
                            phi_6305_ = _e4632;
                            let _e4635 = local_64;
                            phi_6306_ = _e4635;
                        }
                        let _e2882 = phi_6304_;
                        let _e2884 = phi_6305_;
                        let _e2886 = phi_6306_;
                        if _e2884 {
                            let _e2888 = local_29;
                            phi_6311_ = type_40(2u, _e2888);
                            phi_6312_ = false;
                        } else {
                            phi_6311_ = type_40();
                            phi_6312_ = _e2886;
                        }
                        let _e2891 = phi_6311_;
                        let _e2893 = phi_6312_;
                        if _e2893 {
                            let _e2895 = local_30;
                            phi_6318_ = type_40(1u, _e2895.member);
                            phi_6319_ = true;
                        } else {
                            phi_6318_ = _e2891;
                            phi_6319_ = _e2884;
                        }
                        let _e2899 = phi_6318_;
                        let _e2901 = phi_6319_;
                        if _e2901 {
                            phi_6323_ = _e2899;
                        } else {
                            phi_6323_ = _e2882;
                        }
                        let _e2903 = phi_6323_;
                        phi_6327_ = _e2903;
                    }
                    let _e4040 = phi_6327_;
                    phi_6328_ = _e4040;
                }
                let _e4044 = phi_6328_;
                switch bitcast<i32>(_e4044.member) {
                    case 0: {
                        phi_6341_ = type_30(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4050 = function_3(_e4044.member_1);
                        phi_6341_ = type_30(0u, _e4050, true);
                        break;
                    }
                    case 2: {
                        let _e4048 = function_3(_e4044.member_1);
                        phi_6341_ = type_30(1u, _e4048, true);
                        break;
                    }
                    default: {
                        phi_6341_ = type_30();
                        break;
                    }
                }
                let _e4053 = phi_6341_;
                if _e4053.member_2 {
                    let _e4060 = (_e4053.member_1[1] >> bitcast<u32>(20i));
                    if (_e4060 <= 896u) {
                        phi_6364_ = 0u;
                    } else {
                        phi_6364_ = ((((_e4060 - 896u) << bitcast<u32>(23i)) | ((_e4053.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4053.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4075 = phi_6364_;
                    let _e4077 = atomicMin((&earliest.member[0u]), _e4075);
                }
                phi_6368_ = type_29(_e168, _e4053.member, _e174, _e177, _e4053.member_1);
                phi_6369_ = _e4053.member_2;
            } else {
                phi_6368_ = type_29(_e168, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_6369_ = false;
            }
            let _e4079 = phi_6368_;
            let _e4081 = phi_6369_;
            let _e4083 = params.member.member_1;
            if ((_e4083 & 16u) != 0u) {
                if (_e101 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4081 {
                    let _e4089 = atomicAdd((&counters[0u]), 1u);
                    phi_6387_ = _e4089;
                } else {
                    phi_6387_ = 0u;
                }
                let _e4091 = phi_6387_;
                workgroupBarrier();
                if (_e101 == 0u) {
                    let _e4094 = atomicLoad((&counters[0u]));
                    if (_e4094 > 0u) {
                        let _e4097 = atomicAdd((&contacts.member[0u]), _e4094);
                        atomicStore((&counters[1u]), _e4097);
                    }
                }
                workgroupBarrier();
                let _e4100 = atomicLoad((&counters[1u]));
                let _e4101 = (_e4100 + _e4091);
                if _e4081 {
                    let _e4103 = params.member.member_16;
                    if (_e4101 < _e4103) {
                        let _e4105 = (6u * _e4101);
                        atomicStore((&contacts.member[(4u + _e4105)]), _e4079.member);
                        atomicStore((&contacts.member[(_e4105 + 5u)]), _e4079.member_1);
                        atomicStore((&contacts.member[(_e4105 + 6u)]), _e4079.member_2);
                        atomicStore((&contacts.member[(_e4105 + 7u)]), _e4079.member_3);
                        atomicStore((&contacts.member[(_e4105 + 8u)]), _e4079.member_4[0]);
                        atomicStore((&contacts.member[(_e4105 + 9u)]), _e4079.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_830_ = _e156;
            break if !(_e162);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
