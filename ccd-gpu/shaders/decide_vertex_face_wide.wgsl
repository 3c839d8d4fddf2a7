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

struct type_16 {
    member: i32,
    member_1: i32,
}

struct type_17 {
    member: u32,
    member_1: i32,
}

struct type_19 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_22 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_24 {
    member: u32,
}

struct type_25 {
    member: type_7,
    member_1: type_8,
    member_2: type_24,
}

struct type_26 {
    member: type_25,
}

struct type_28 {
    member: array<array<u32, 3>>,
}

struct type_31 {
    member: array<array<f64, 3>>,
}

struct type_32 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_34 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_35 {
    member: f64,
    member_1: f64,
}

struct type_40 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_41 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_42 {
    member: u32,
    member_1: f64,
}

struct type_43 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_46 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_21;
@group(0) @binding(0) 
var<storage> params: type_26;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_46;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> positions: type_31;
@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_46;
@group(0) @binding(3) 
var<storage> elements: type_28;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    return array<f64, 3>(f64(param[0]), f64(param[1]), f64(param[2]));
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    var phi_732_: array<f64, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_732_ = param_2;
    } else {
        phi_732_ = param_1;
    }
    let _e26 = phi_732_;
    return _e26;
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_296_: bool;
    var phi_297_: bool;
    var phi_298_: bool;
    var phi_299_: bool;
    var phi_303_: bool;
    var phi_276_: bool;
    var phi_277_: bool;
    var phi_278_: bool;
    var phi_279_: bool;
    var phi_280_: bool;
    var phi_281_: bool;
    var phi_285_: bool;
    var phi_304_: bool;
    var phi_334_: array<f64, 3>;
    var phi_335_: bool;
    var phi_336_: array<f64, 3>;
    var phi_337_: bool;
    var phi_583_: f64;
    var phi_585_: f64;
    var phi_627_: f64;
    var phi_629_: f64;
    var phi_677_: f64;
    var phi_679_: f64;
    var phi_388_: f64;
    var phi_390_: f64;
    var phi_438_: f64;
    var phi_440_: f64;
    var phi_485_: f64;
    var phi_487_: f64;
    var phi_538_: f64;
    var phi_540_: f64;
    var phi_694_: array<array<f64, 3>, 4>;
    var phi_702_: array<f64, 3>;

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
                    phi_276_ = (_e78 <= _e70);
                    phi_277_ = false;
                } else {
                    phi_276_ = bool();
                    phi_277_ = true;
                }
                let _e99 = phi_276_;
                let _e101 = phi_277_;
                phi_278_ = _e99;
                phi_279_ = _e101;
            } else {
                phi_278_ = bool();
                phi_279_ = true;
            }
            let _e103 = phi_278_;
            let _e105 = phi_279_;
            phi_280_ = _e103;
            phi_281_ = _e105;
        } else {
            phi_280_ = bool();
            phi_281_ = true;
        }
        let _e107 = phi_280_;
        let _e109 = phi_281_;
        if _e109 {
            phi_285_ = false;
        } else {
            phi_285_ = _e107;
        }
        let _e111 = phi_285_;
        phi_304_ = _e111;
    } else {
        if (_e74 >= _e69) {
            if (_e78 >= _e69) {
                phi_296_ = ((_e74 + _e78) <= _e70);
                phi_297_ = false;
            } else {
                phi_296_ = bool();
                phi_297_ = true;
            }
            let _e85 = phi_296_;
            let _e87 = phi_297_;
            phi_298_ = _e85;
            phi_299_ = _e87;
        } else {
            phi_298_ = bool();
            phi_299_ = true;
        }
        let _e89 = phi_298_;
        let _e91 = phi_299_;
        if _e91 {
            phi_303_ = false;
        } else {
            phi_303_ = _e89;
        }
        let _e93 = phi_303_;
        phi_304_ = _e93;
    }
    let _e113 = phi_304_;
    if (_e68 > _e69) {
        if _e113 {
            phi_334_ = array<f64, 3>((param_3[0] - ((param_4[0] * _e74) + (param_5[0] * _e78))), (param_3[1] - ((param_4[1] * _e74) + (param_5[1] * _e78))), (param_3[2] - ((param_4[2] * _e74) + (param_5[2] * _e78))));
            phi_335_ = false;
        } else {
            phi_334_ = array<f64, 3>();
            phi_335_ = true;
        }
        let _e138 = phi_334_;
        let _e140 = phi_335_;
        phi_336_ = _e138;
        phi_337_ = _e140;
    } else {
        phi_336_ = array<f64, 3>();
        phi_337_ = true;
    }
    let _e142 = phi_336_;
    let _e144 = phi_337_;
    if _e144 {
        let _e147 = (param_3[0] - param_4[0]);
        let _e150 = (param_3[1] - param_4[1]);
        let _e153 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e307 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e307 > f64(0f)) {
                if (_e307 < f64(1f)) {
                    phi_388_ = _e307;
                } else {
                    phi_388_ = f64(1f);
                }
                let _e315 = phi_388_;
                phi_390_ = _e315;
            } else {
                phi_390_ = f64(0f);
            }
            let _e317 = phi_390_;
            let _e353 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e353 > f64(0f)) {
                if (_e353 < f64(1f)) {
                    phi_438_ = _e353;
                } else {
                    phi_438_ = f64(1f);
                }
                let _e361 = phi_438_;
                phi_440_ = _e361;
            } else {
                phi_440_ = f64(0f);
            }
            let _e363 = phi_440_;
            let _e396 = ((((_e147 * param_5[0]) + (_e150 * param_5[1])) + (_e153 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e396 > f64(0f)) {
                if (_e396 < f64(1f)) {
                    phi_485_ = _e396;
                } else {
                    phi_485_ = f64(1f);
                }
                let _e404 = phi_485_;
                phi_487_ = _e404;
            } else {
                phi_487_ = f64(0f);
            }
            let _e406 = phi_487_;
            let _e419 = (param_3[0] - param_5[0]);
            let _e422 = (param_3[1] - param_5[1]);
            let _e425 = (param_3[2] - param_5[2]);
            let _e445 = ((((_e419 * param_4[0]) + (_e422 * param_4[1])) + (_e425 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e445 > f64(0f)) {
                if (_e445 < f64(1f)) {
                    phi_538_ = _e445;
                } else {
                    phi_538_ = f64(1f);
                }
                let _e453 = phi_538_;
                phi_540_ = _e453;
            } else {
                phi_540_ = f64(0f);
            }
            let _e455 = phi_540_;
            phi_694_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e317)), (param_3[1] - (param_4[1] * _e317)), (param_3[2] - (param_4[2] * _e317))), array<f64, 3>((param_3[0] - (param_5[0] * _e363)), (param_3[1] - (param_5[1] * _e363)), (param_3[2] - (param_5[2] * _e363))), array<f64, 3>((_e147 - (param_5[0] * _e406)), (_e150 - (param_5[1] * _e406)), (_e153 - (param_5[2] * _e406))), array<f64, 3>((_e419 - (param_4[0] * _e455)), (_e422 - (param_4[1] * _e455)), (_e425 - (param_4[2] * _e455))));
        } else {
            let _e157 = (param_5[0] - param_4[0]);
            let _e160 = (param_5[1] - param_4[1]);
            let _e163 = (param_5[2] - param_4[2]);
            let _e174 = ((((_e147 * _e157) + (_e150 * _e160)) + (_e153 * _e163)) / (((_e157 * _e157) + (_e160 * _e160)) + (_e163 * _e163)));
            if (_e174 > f64(0f)) {
                if (_e174 < f64(1f)) {
                    phi_583_ = _e174;
                } else {
                    phi_583_ = f64(1f);
                }
                let _e182 = phi_583_;
                phi_585_ = _e182;
            } else {
                phi_585_ = f64(0f);
            }
            let _e184 = phi_585_;
            let _e191 = array<f64, 3>((_e147 - (_e157 * _e184)), (_e150 - (_e160 * _e184)), (_e153 - (_e163 * _e184)));
            let _e214 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e214 > f64(0f)) {
                if (_e214 < f64(1f)) {
                    phi_627_ = _e214;
                } else {
                    phi_627_ = f64(1f);
                }
                let _e222 = phi_627_;
                phi_629_ = _e222;
            } else {
                phi_629_ = f64(0f);
            }
            let _e224 = phi_629_;
            let _e260 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e260 > f64(0f)) {
                if (_e260 < f64(1f)) {
                    phi_677_ = _e260;
                } else {
                    phi_677_ = f64(1f);
                }
                let _e268 = phi_677_;
                phi_679_ = _e268;
            } else {
                phi_679_ = f64(0f);
            }
            let _e270 = phi_679_;
            phi_694_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e224)), (param_3[1] - (param_4[1] * _e224)), (param_3[2] - (param_4[2] * _e224))), array<f64, 3>((param_3[0] - (param_5[0] * _e270)), (param_3[1] - (param_5[1] * _e270)), (param_3[2] - (param_5[2] * _e270))), _e191, _e191);
        }
        let _e468 = phi_694_;
        let _e471 = function_1(_e468[0], _e468[1]);
        let _e473 = function_1(_e471, _e468[2]);
        let _e475 = function_1(_e473, _e468[3]);
        phi_702_ = _e475;
    } else {
        phi_702_ = _e142;
    }
    let _e477 = phi_702_;
    return _e477;
}

fn function_3(param_7: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_7);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<array<f64, 3>, 4>;
    var local_1: array<array<f64, 3>, 4>;
    var local_2: type_34;
    var local_3: type_34;
    var local_4: type_34;
    var local_5: array<type_35, 4>;
    var local_6: array<f64, 4>;
    var local_7: array<f64, 2>;
    var local_8: array<f64, 4>;
    var local_9: array<array<f64, 3>, 4>;
    var local_10: array<array<f64, 3>, 4>;
    var local_11: array<f32, 3>;
    var local_12: type_40;
    var phi_793_: u32;
    var phi_809_: u32;
    var phi_830_: u32;
    var phi_831_: u32;
    var phi_834_: type_9;
    var phi_835_: type_9;
    var phi_858_: type_9;
    var phi_1105_: type_41;
    var phi_1474_: f64;
    var phi_1481_: f64;
    var phi_1486_: f64;
    var phi_1493_: f64;
    var phi_1498_: f64;
    var phi_1511_: f64;
    var phi_1518_: f64;
    var phi_1523_: f64;
    var phi_1530_: f64;
    var phi_1535_: f64;
    var phi_1540_: f64;
    var phi_1557_: f64;
    var phi_1564_: f64;
    var phi_1569_: f64;
    var phi_1576_: f64;
    var phi_1581_: f64;
    var phi_1595_: f64;
    var phi_1602_: f64;
    var phi_1607_: f64;
    var phi_1614_: f64;
    var phi_1619_: f64;
    var phi_1624_: f64;
    var phi_1641_: f64;
    var phi_1648_: f64;
    var phi_1653_: f64;
    var phi_1660_: f64;
    var phi_1665_: f64;
    var phi_1679_: f64;
    var phi_1686_: f64;
    var phi_1691_: f64;
    var phi_1698_: f64;
    var phi_1703_: f64;
    var phi_1708_: f64;
    var phi_1745_: f64;
    var phi_1751_: f64;
    var phi_1758_: f64;
    var phi_1765_: f64;
    var phi_1771_: f64;
    var phi_1778_: f64;
    var phi_1784_: f64;
    var phi_1790_: f64;
    var phi_1796_: f64;
    var phi_1803_: f64;
    var phi_1810_: f64;
    var phi_1838_: f64;
    var phi_1843_: f64;
    var phi_1848_: f64;
    var phi_1853_: f64;
    var phi_1858_: f64;
    var phi_1863_: f64;
    var phi_1874_: f64;
    var phi_3457_: f64;
    var phi_3463_: f64;
    var phi_3468_: f64;
    var phi_3474_: f64;
    var phi_3480_: f64;
    var phi_3485_: f64;
    var phi_3490_: f64;
    var phi_3500_: bool;
    var phi_3507_: f64;
    var phi_3515_: f64;
    var phi_3558_: type_16;
    var phi_3561_: f64;
    var phi_3582_: bool;
    var phi_3588_: type_17;
    var phi_3559_: type_16;
    var phi_3602_: type_17;
    var phi_3562_: f64;
    var local_13: f64;
    var phi_3551_: f64;
    var phi_3615_: f64;
    var phi_3621_: f64;
    var phi_3646_: type_9;
    var phi_3649_: u32;
    var phi_3647_: type_9;
    var phi_3672_: type_9;
    var phi_3716_: u32;
    var phi_3717_: u32;
    var phi_3650_: u32;
    var phi_3718_: u32;
    var phi_3738_: type_9;
    var phi_3739_: type_9;
    var phi_3762_: type_9;
    var phi_3816_: f64;
    var phi_3823_: f64;
    var phi_3835_: bool;
    var phi_3836_: bool;
    var phi_3837_: bool;
    var phi_3838_: bool;
    var phi_3842_: bool;
    var phi_3854_: type_43;
    var phi_3855_: type_43;
    var phi_3856_: bool;
    var phi_3857_: type_43;
    var phi_3858_: bool;
    var phi_3871_: f64;
    var phi_3884_: type_9;
    var phi_3887_: f64;
    var phi_3889_: f64;
    var phi_3891_: f64;
    var phi_3885_: type_9;
    var phi_3914_: type_9;
    var phi_3941_: f64;
    var phi_3942_: f64;
    var phi_3970_: f64;
    var phi_3986_: f64;
    var phi_3993_: bool;
    var phi_3994_: bool;
    var phi_3995_: bool;
    var phi_4001_: f64;
    var phi_4002_: f64;
    var phi_4003_: bool;
    var phi_3888_: f64;
    var phi_3890_: f64;
    var phi_3892_: f64;
    var phi_4004_: f64;
    var phi_4005_: bool;
    var phi_4006_: bool;
    var local_14: bool;
    var phi_4010_: f64;
    var phi_4011_: f64;
    var phi_4019_: type_9;
    var phi_4022_: f64;
    var phi_4020_: type_9;
    var phi_4045_: type_9;
    var phi_4088_: f64;
    var phi_4098_: f64;
    var phi_4108_: bool;
    var phi_4110_: bool;
    var phi_4115_: f64;
    var phi_4116_: bool;
    var phi_4117_: f64;
    var phi_4118_: bool;
    var phi_4119_: bool;
    var phi_4120_: bool;
    var phi_4121_: f64;
    var phi_4023_: f64;
    var phi_4122_: bool;
    var phi_4123_: bool;
    var phi_4124_: bool;
    var phi_4125_: bool;
    var local_15: bool;
    var phi_4129_: bool;
    var phi_4130_: bool;
    var phi_4134_: bool;
    var phi_4138_: f64;
    var phi_4139_: f64;
    var phi_4141_: type_43;
    var phi_4172_: f64;
    var phi_4179_: f64;
    var phi_4184_: f64;
    var phi_4191_: f64;
    var phi_4196_: f64;
    var phi_4209_: f64;
    var phi_4216_: f64;
    var phi_4221_: f64;
    var phi_4228_: f64;
    var phi_4233_: f64;
    var phi_4238_: f64;
    var phi_4297_: f64;
    var phi_4303_: f64;
    var phi_4308_: f64;
    var phi_4314_: f64;
    var phi_4319_: f64;
    var phi_4333_: f64;
    var phi_4339_: f64;
    var phi_4344_: f64;
    var phi_4350_: f64;
    var phi_4355_: f64;
    var phi_4381_: f64;
    var phi_4388_: f64;
    var phi_4393_: f64;
    var phi_4400_: f64;
    var phi_4405_: f64;
    var phi_4418_: f64;
    var phi_4425_: f64;
    var phi_4430_: f64;
    var phi_4437_: f64;
    var phi_4442_: f64;
    var phi_4447_: f64;
    var phi_4506_: f64;
    var phi_4512_: f64;
    var phi_4517_: f64;
    var phi_4523_: f64;
    var phi_4528_: f64;
    var phi_4542_: f64;
    var phi_4548_: f64;
    var phi_4553_: f64;
    var phi_4559_: f64;
    var phi_4564_: f64;
    var phi_4590_: f64;
    var phi_4597_: f64;
    var phi_4602_: f64;
    var phi_4609_: f64;
    var phi_4614_: f64;
    var phi_4627_: f64;
    var phi_4634_: f64;
    var phi_4639_: f64;
    var phi_4646_: f64;
    var phi_4651_: f64;
    var phi_4656_: f64;
    var phi_4715_: f64;
    var phi_4721_: f64;
    var phi_4726_: f64;
    var phi_4732_: f64;
    var phi_4737_: f64;
    var phi_4751_: f64;
    var phi_4757_: f64;
    var phi_4762_: f64;
    var phi_4768_: f64;
    var phi_4773_: f64;
    var phi_4822_: f64;
    var phi_4828_: f64;
    var phi_4856_: f64;
    var phi_4862_: f64;
    var phi_4867_: u32;
    var phi_4868_: u32;
    var phi_4838_: f64;
    var phi_4844_: f64;
    var phi_4849_: u32;
    var phi_4850_: u32;
    var phi_4869_: u32;
    var phi_4870_: u32;
    var phi_4941_: f64;
    var phi_4953_: f64;
    var phi_5092_: f64;
    var phi_5098_: f64;
    var phi_5105_: f64;
    var phi_5149_: type_9;
    var phi_5152_: bool;
    var phi_5150_: type_9;
    var phi_5175_: type_9;
    var phi_5202_: bool;
    var phi_5203_: bool;
    var phi_5153_: bool;
    var phi_5204_: bool;
    var phi_5205_: bool;
    var local_16: bool;
    var phi_5209_: bool;
    var local_17: bool;
    var phi_5216_: u32;
    var phi_5217_: u32;
    var phi_5218_: bool;
    var phi_5219_: u32;
    var phi_5220_: u32;
    var phi_5221_: bool;
    var phi_5225_: u32;
    var phi_5246_: bool;
    var phi_5247_: bool;
    var phi_5248_: bool;
    var phi_5445_: f64;
    var phi_5452_: f64;
    var phi_5457_: f64;
    var phi_5464_: f64;
    var phi_5469_: f64;
    var phi_5482_: f64;
    var phi_5489_: f64;
    var phi_5494_: f64;
    var phi_5501_: f64;
    var phi_5506_: f64;
    var phi_5511_: f64;
    var phi_5528_: f64;
    var phi_5535_: f64;
    var phi_5540_: f64;
    var phi_5547_: f64;
    var phi_5552_: f64;
    var phi_5566_: f64;
    var phi_5573_: f64;
    var phi_5578_: f64;
    var phi_5585_: f64;
    var phi_5590_: f64;
    var phi_5595_: f64;
    var phi_5612_: f64;
    var phi_5619_: f64;
    var phi_5624_: f64;
    var phi_5631_: f64;
    var phi_5636_: f64;
    var phi_5650_: f64;
    var phi_5657_: f64;
    var phi_5662_: f64;
    var phi_5669_: f64;
    var phi_5674_: f64;
    var phi_5679_: f64;
    var phi_5699_: type_9;
    var phi_5702_: f64;
    var phi_5700_: type_9;
    var phi_5725_: type_9;
    var phi_5836_: f64;
    var phi_5843_: f64;
    var phi_5851_: f64;
    var phi_5896_: type_16;
    var phi_5899_: f64;
    var phi_5920_: bool;
    var phi_5926_: type_17;
    var phi_5897_: type_16;
    var phi_5940_: type_17;
    var phi_5900_: f64;
    var local_18: f64;
    var phi_5889_: f64;
    var phi_5953_: f64;
    var phi_5966_: type_9;
    var phi_5969_: f64;
    var phi_5967_: type_9;
    var phi_5992_: type_9;
    var phi_6043_: f64;
    var phi_6049_: f64;
    var phi_6063_: bool;
    var phi_6064_: bool;
    var phi_6098_: f64;
    var phi_6099_: f64;
    var phi_6100_: f64;
    var phi_6101_: bool;
    var phi_6105_: bool;
    var phi_6106_: f64;
    var phi_6107_: bool;
    var phi_6108_: bool;
    var phi_6109_: bool;
    var phi_6110_: f64;
    var phi_6111_: bool;
    var phi_6112_: bool;
    var phi_6113_: bool;
    var phi_5970_: f64;
    var phi_6114_: bool;
    var phi_6115_: bool;
    var phi_6116_: bool;
    var phi_6117_: bool;
    var local_19: bool;
    var local_20: f64;
    var local_21: f64;
    var local_22: f64;
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
    var phi_6145_: bool;
    var phi_6146_: bool;
    var phi_6147_: bool;
    var phi_6148_: f64;
    var phi_6149_: f64;
    var phi_6150_: bool;
    var phi_6151_: bool;
    var phi_6152_: bool;
    var phi_6153_: bool;
    var phi_6154_: bool;
    var phi_6155_: bool;
    var phi_6156_: bool;
    var phi_6157_: f64;
    var phi_6158_: f64;
    var phi_6159_: bool;
    var phi_6160_: bool;
    var phi_6161_: bool;
    var phi_6162_: bool;
    var phi_6163_: bool;
    var phi_6164_: bool;
    var phi_6165_: bool;
    var phi_6166_: bool;
    var phi_6167_: f64;
    var phi_5703_: f64;
    var phi_6168_: bool;
    var phi_6169_: bool;
    var phi_6170_: bool;
    var phi_6171_: bool;
    var phi_6172_: bool;
    var phi_6173_: bool;
    var phi_6174_: bool;
    var phi_6175_: bool;
    var phi_6176_: bool;
    var local_23: bool;
    var phi_6181_: type_42;
    var phi_6182_: bool;
    var phi_6183_: bool;
    var phi_6184_: bool;
    var phi_6185_: bool;
    var phi_6186_: bool;
    var phi_6187_: bool;
    var phi_6188_: bool;
    var phi_6192_: f64;
    var phi_6193_: bool;
    var phi_6194_: bool;
    var phi_6195_: bool;
    var phi_6196_: bool;
    var phi_6197_: bool;
    var phi_6198_: bool;
    var phi_6199_: bool;
    var phi_6204_: type_42;
    var phi_6205_: bool;
    var phi_6206_: bool;
    var phi_6207_: bool;
    var phi_6208_: bool;
    var phi_6209_: bool;
    var phi_6210_: bool;
    var local_24: f64;
    var phi_6215_: type_42;
    var phi_6216_: bool;
    var phi_6217_: bool;
    var phi_6218_: bool;
    var phi_6219_: bool;
    var phi_6220_: bool;
    var local_25: f64;
    var phi_6225_: type_42;
    var phi_6226_: bool;
    var phi_6227_: bool;
    var phi_6228_: bool;
    var phi_6229_: bool;
    var local_26: f64;
    var phi_6234_: type_42;
    var phi_6235_: bool;
    var phi_6236_: bool;
    var phi_6237_: bool;
    var phi_6238_: bool;
    var phi_6242_: type_42;
    var phi_6243_: bool;
    var phi_6244_: bool;
    var phi_6245_: bool;
    var phi_6249_: bool;
    var phi_6250_: bool;
    var phi_6254_: bool;
    var phi_6255_: bool;
    var phi_6259_: bool;
    var phi_6260_: bool;
    var local_27: f64;
    var phi_6265_: type_42;
    var phi_6266_: bool;
    var phi_6270_: type_42;
    var phi_6277_: bool;
    var phi_6278_: f64;
    var phi_6279_: bool;
    var phi_6280_: bool;
    var phi_6281_: bool;
    var phi_6282_: f64;
    var phi_6283_: bool;
    var phi_6284_: bool;
    var phi_6285_: bool;
    var phi_6286_: f64;
    var phi_6287_: bool;
    var phi_6288_: bool;
    var phi_6289_: bool;
    var phi_6290_: bool;
    var phi_6294_: bool;
    var phi_6295_: bool;
    var phi_6296_: bool;
    var phi_6297_: f64;
    var phi_6298_: type_43;
    var phi_6299_: bool;
    var phi_6300_: bool;
    var phi_6301_: bool;
    var phi_6302_: bool;
    var local_28: bool;
    var phi_6307_: type_42;
    var phi_6308_: bool;
    var phi_6309_: bool;
    var local_29: f64;
    var phi_6314_: type_42;
    var phi_6315_: bool;
    var local_30: type_43;
    var phi_6321_: type_42;
    var phi_6322_: bool;
    var phi_6326_: type_42;
    var phi_2077_: f64;
    var phi_2084_: f64;
    var phi_2089_: f64;
    var phi_2096_: f64;
    var phi_2101_: f64;
    var phi_2114_: f64;
    var phi_2121_: f64;
    var phi_2126_: f64;
    var phi_2133_: f64;
    var phi_2138_: f64;
    var phi_2143_: f64;
    var phi_2160_: f64;
    var phi_2167_: f64;
    var phi_2172_: f64;
    var phi_2179_: f64;
    var phi_2184_: f64;
    var phi_2198_: f64;
    var phi_2205_: f64;
    var phi_2210_: f64;
    var phi_2217_: f64;
    var phi_2222_: f64;
    var phi_2227_: f64;
    var phi_2244_: f64;
    var phi_2251_: f64;
    var phi_2256_: f64;
    var phi_2263_: f64;
    var phi_2268_: f64;
    var phi_2282_: f64;
    var phi_2289_: f64;
    var phi_2294_: f64;
    var phi_2301_: f64;
    var phi_2306_: f64;
    var phi_2311_: f64;
    var phi_2331_: type_9;
    var phi_2334_: f64;
    var phi_2332_: type_9;
    var phi_2357_: type_9;
    var phi_2468_: f64;
    var phi_2475_: f64;
    var phi_2483_: f64;
    var phi_2528_: type_16;
    var phi_2531_: f64;
    var phi_2552_: bool;
    var phi_2558_: type_17;
    var phi_2529_: type_16;
    var phi_2572_: type_17;
    var phi_2532_: f64;
    var local_31: f64;
    var phi_2521_: f64;
    var phi_2585_: f64;
    var phi_2598_: type_9;
    var phi_2601_: f64;
    var phi_2599_: type_9;
    var phi_2624_: type_9;
    var phi_2675_: f64;
    var phi_2681_: f64;
    var phi_2695_: bool;
    var phi_2696_: bool;
    var phi_2730_: f64;
    var phi_2731_: f64;
    var phi_2732_: f64;
    var phi_2733_: bool;
    var phi_2737_: bool;
    var phi_2738_: f64;
    var phi_2739_: bool;
    var phi_2740_: bool;
    var phi_2741_: bool;
    var phi_2742_: f64;
    var phi_2743_: bool;
    var phi_2744_: bool;
    var phi_2745_: bool;
    var phi_2602_: f64;
    var phi_2746_: bool;
    var phi_2747_: bool;
    var phi_2748_: bool;
    var phi_2749_: bool;
    var local_32: bool;
    var local_33: f64;
    var local_34: f64;
    var local_35: f64;
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
    var phi_2777_: bool;
    var phi_2778_: bool;
    var phi_2779_: bool;
    var phi_2780_: f64;
    var phi_2781_: f64;
    var phi_2782_: bool;
    var phi_2783_: bool;
    var phi_2784_: bool;
    var phi_2785_: bool;
    var phi_2786_: bool;
    var phi_2787_: bool;
    var phi_2788_: bool;
    var phi_2789_: f64;
    var phi_2790_: f64;
    var phi_2791_: bool;
    var phi_2792_: bool;
    var phi_2793_: bool;
    var phi_2794_: bool;
    var phi_2795_: bool;
    var phi_2796_: bool;
    var phi_2797_: bool;
    var phi_2798_: bool;
    var phi_2799_: f64;
    var phi_2335_: f64;
    var phi_2800_: bool;
    var phi_2801_: bool;
    var phi_2802_: bool;
    var phi_2803_: bool;
    var phi_2804_: bool;
    var phi_2805_: bool;
    var phi_2806_: bool;
    var phi_2807_: bool;
    var phi_2808_: bool;
    var local_36: bool;
    var phi_2813_: type_42;
    var phi_2814_: bool;
    var phi_2815_: bool;
    var phi_2816_: bool;
    var phi_2817_: bool;
    var phi_2818_: bool;
    var phi_2819_: bool;
    var phi_2820_: bool;
    var phi_2824_: f64;
    var phi_2825_: bool;
    var phi_2826_: bool;
    var phi_2827_: bool;
    var phi_2828_: bool;
    var phi_2829_: bool;
    var phi_2830_: bool;
    var phi_2831_: bool;
    var phi_2836_: type_42;
    var phi_2837_: bool;
    var phi_2838_: bool;
    var phi_2839_: bool;
    var phi_2840_: bool;
    var phi_2841_: bool;
    var phi_2842_: bool;
    var local_37: f64;
    var phi_2847_: type_42;
    var phi_2848_: bool;
    var phi_2849_: bool;
    var phi_2850_: bool;
    var phi_2851_: bool;
    var phi_2852_: bool;
    var local_38: f64;
    var phi_2857_: type_42;
    var phi_2858_: bool;
    var phi_2859_: bool;
    var phi_2860_: bool;
    var phi_2861_: bool;
    var local_39: f64;
    var phi_2866_: type_42;
    var phi_2867_: bool;
    var phi_2868_: bool;
    var phi_2869_: bool;
    var phi_2870_: bool;
    var phi_2874_: type_42;
    var phi_2875_: bool;
    var phi_2876_: bool;
    var phi_2877_: bool;
    var phi_2881_: bool;
    var phi_2882_: bool;
    var phi_2886_: bool;
    var phi_2887_: bool;
    var phi_2891_: bool;
    var phi_2892_: bool;
    var local_40: f64;
    var phi_2897_: type_42;
    var phi_2898_: bool;
    var phi_2902_: type_42;
    var phi_2916_: type_9;
    var phi_2917_: type_9;
    var phi_2940_: type_9;
    var phi_2961_: f64;
    var phi_3091_: type_16;
    var phi_3094_: f64;
    var phi_3115_: bool;
    var phi_3121_: type_17;
    var phi_3092_: type_16;
    var phi_3135_: type_17;
    var phi_3095_: f64;
    var local_41: f64;
    var phi_3084_: f64;
    var phi_3148_: f64;
    var phi_3166_: f64;
    var phi_3173_: f64;
    var phi_3178_: f64;
    var phi_3185_: f64;
    var phi_3190_: f64;
    var phi_3203_: f64;
    var phi_3210_: f64;
    var phi_3215_: f64;
    var phi_3222_: f64;
    var phi_3227_: f64;
    var phi_3232_: f64;
    var phi_3249_: f64;
    var phi_3256_: f64;
    var phi_3261_: f64;
    var phi_3268_: f64;
    var phi_3273_: f64;
    var phi_3287_: f64;
    var phi_3294_: f64;
    var phi_3299_: f64;
    var phi_3306_: f64;
    var phi_3311_: f64;
    var phi_3316_: f64;
    var phi_3333_: f64;
    var phi_3340_: f64;
    var phi_3345_: f64;
    var phi_3352_: f64;
    var phi_3357_: f64;
    var phi_3371_: f64;
    var phi_3378_: f64;
    var phi_3383_: f64;
    var phi_3390_: f64;
    var phi_3395_: f64;
    var phi_3400_: f64;
    var phi_3424_: bool;
    var phi_3425_: bool;
    var phi_3426_: bool;
    var local_42: bool;
    var phi_3431_: type_42;
    var phi_3432_: bool;
    var phi_3437_: type_42;
    var phi_3438_: bool;
    var phi_3440_: type_42;
    var phi_3441_: type_42;
    var phi_3442_: bool;
    var phi_3446_: type_42;
    var phi_6330_: type_42;
    var phi_6331_: type_42;
    var phi_6344_: type_32;
    var phi_6367_: u32;
    var phi_6371_: type_22;
    var phi_6372_: bool;
    var phi_6391_: u32;
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
    let _e119 = params.member.member_1.member_2;
    let _e121 = input.member[0u];
    if (_e119 < _e121) {
        phi_793_ = _e119;
    } else {
        phi_793_ = _e121;
    }
    let _e124 = phi_793_;
    let _e125 = (_e124 / 64u);
    if ((_e124 % 64u) > 0u) {
        phi_809_ = (_e125 + 1u);
    } else {
        phi_809_ = _e125;
    }
    let _e130 = phi_809_;
    if (_e130 > _e113) {
        let _e132 = (_e130 - _e113);
        if (_e116 == 0u) {
            return;
        }
        let _e134 = (_e132 / _e116);
        if (_e116 == 0u) {
            return;
        }
        if ((_e132 % _e116) > 0u) {
            phi_830_ = (_e134 + 1u);
        } else {
            phi_830_ = _e134;
        }
        let _e140 = phi_830_;
        phi_831_ = _e140;
    } else {
        phi_831_ = 0u;
    }
    let _e142 = phi_831_;
    phi_834_ = type_9(0u, _e142);
    loop {
        let _e145 = phi_834_;
        if (_e145.member < _e145.member_1) {
            phi_835_ = type_9((_e145.member + 1u), _e145.member_1);
            phi_858_ = type_9(1u, _e145.member);
        } else {
            phi_835_ = _e145;
            phi_858_ = type_9(0u, type_9().member_1);
        }
        let _e157 = phi_835_;
        let _e159 = phi_858_;
        let _e163 = (bitcast<i32>(_e159.member) != 0i);
        if _e163 {
            let _e167 = (((_e113 + (_e159.member_1 * _e116)) * 64u) + _e101);
            if (_e167 < _e124) {
                let _e169 = (2u * _e167);
                let _e172 = input.member[(4u + _e169)];
                let _e175 = input.member[(_e169 + 5u)];
                let _e178 = elements.member[_e175];
                let _e183 = params.member.member.member_1;
                if ((_e183 & 8u) != 0u) {
                    let _e222 = paths.member[_e172];
                    let _e224 = paths.member[_e178[0]];
                    let _e230 = paths.member[_e178[1]];
                    let _e232 = paths.member[_e178[2]];
                    let _e269 = function_(array<f32, 3>(_e222.member[0], _e222.member[1], _e222.member[2]));
                    let _e270 = function_(array<f32, 3>(_e224.member[0], _e224.member[1], _e224.member[2]));
                    let _e271 = function_(array<f32, 3>(_e230.member[0], _e230.member[1], _e230.member[2]));
                    let _e272 = function_(array<f32, 3>(_e232.member[0], _e232.member[1], _e232.member[2]));
                    let _e274 = function_(array<f32, 3>(_e222.member_1[0], _e222.member_1[1], _e222.member_1[2]));
                    let _e275 = function_(array<f32, 3>(_e224.member_1[0], _e224.member_1[1], _e224.member_1[2]));
                    let _e276 = function_(array<f32, 3>(_e230.member_1[0], _e230.member_1[1], _e230.member_1[2]));
                    let _e277 = function_(array<f32, 3>(_e232.member_1[0], _e232.member_1[1], _e232.member_1[2]));
                    phi_1105_ = type_41(array<array<f64, 3>, 4>(_e269, _e270, _e271, _e272), array<array<f64, 3>, 4>(_e274, _e275, _e276, _e277));
                } else {
                    let _e187 = positions.member[_e172];
                    let _e190 = params.member.member.member[0u];
                    let _e193 = positions.member[(_e190 + _e172)];
                    let _e195 = positions.member[_e178[0]];
                    let _e198 = params.member.member.member[0u];
                    let _e201 = positions.member[(_e198 + _e178[0])];
                    let _e203 = positions.member[_e178[1]];
                    let _e206 = params.member.member.member[0u];
                    let _e209 = positions.member[(_e206 + _e178[1])];
                    let _e211 = positions.member[_e178[2]];
                    let _e214 = params.member.member.member[0u];
                    let _e217 = positions.member[(_e214 + _e178[2])];
                    phi_1105_ = type_41(array<array<f64, 3>, 4>(_e187, _e195, _e203, _e211), array<array<f64, 3>, 4>(_e193, _e201, _e209, _e217));
                }
                let _e281 = phi_1105_;
                local_12 = type_40(array<array<f64, 3>, 2>(array<f64, 3>((_e281.member[0][0] - _e281.member[1][0]), (_e281.member[0][1] - _e281.member[1][1]), (_e281.member[0][2] - _e281.member[1][2])), array<f64, 3>((_e281.member_1[0][0] - _e281.member_1[1][0]), (_e281.member_1[0][1] - _e281.member_1[1][1]), (_e281.member_1[0][2] - _e281.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e281.member[2][0] - _e281.member[1][0]), (_e281.member[2][1] - _e281.member[1][1]), (_e281.member[2][2] - _e281.member[1][2])), array<f64, 3>((_e281.member_1[2][0] - _e281.member_1[1][0]), (_e281.member_1[2][1] - _e281.member_1[1][1]), (_e281.member_1[2][2] - _e281.member_1[1][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e281.member[3][0] - _e281.member[1][0]), (_e281.member[3][1] - _e281.member[1][1]), (_e281.member[3][2] - _e281.member[1][2])), array<f64, 3>((_e281.member_1[3][0] - _e281.member_1[1][0]), (_e281.member_1[3][1] - _e281.member_1[1][1]), (_e281.member_1[3][2] - _e281.member_1[1][2]))), (0.0lf + 0.0lf));
                let _e362 = params.member.member.member_7;
                let _e369 = bitcast<f64>(((u64(_e362[1]) * 4294967296lu) + u64(_e362[0])));
                let _e370 = f64(0f);
                let _e373 = local_12.member_1[0u];
                let _e379 = local_12.member_2[0u];
                let _e385 = ((_e373[1] * _e379[2]) - (_e373[2] * _e379[1]));
                let _e388 = ((_e373[2] * _e379[0]) - (_e373[0] * _e379[2]));
                let _e391 = ((_e373[0] * _e379[1]) - (_e373[1] * _e379[0]));
                let _e394 = local_12.member_1[1u];
                let _e400 = local_12.member_2[1u];
                let _e406 = ((_e394[1] * _e400[2]) - (_e394[2] * _e400[1]));
                let _e409 = ((_e394[2] * _e400[0]) - (_e394[0] * _e400[2]));
                let _e412 = ((_e394[0] * _e400[1]) - (_e394[1] * _e400[0]));
                let _e415 = local_12.member_1[0u];
                let _e421 = local_12.member_2[1u];
                let _e436 = local_12.member_1[1u];
                let _e442 = local_12.member_2[0u];
                let _e455 = (((_e415[1] * _e421[2]) - (_e415[2] * _e421[1])) + ((_e436[1] * _e442[2]) - (_e436[2] * _e442[1])));
                let _e456 = (((_e415[2] * _e421[0]) - (_e415[0] * _e421[2])) + ((_e436[2] * _e442[0]) - (_e436[0] * _e442[2])));
                let _e457 = (((_e415[0] * _e421[1]) - (_e415[1] * _e421[0])) + ((_e436[0] * _e442[1]) - (_e436[1] * _e442[0])));
                let _e460 = local_12.member[0u];
                let _e468 = (((_e460[0] * _e385) + (_e460[1] * _e388)) + (_e460[2] * _e391));
                let _e471 = local_12.member[1u];
                let _e482 = local_12.member[0u];
                let _e491 = ((((_e471[0] * _e385) + (_e471[1] * _e388)) + (_e471[2] * _e391)) + (((_e482[0] * _e455) + (_e482[1] * _e456)) + (_e482[2] * _e457)));
                let _e494 = local_12.member[0u];
                let _e505 = local_12.member[1u];
                let _e514 = ((((_e494[0] * _e406) + (_e494[1] * _e409)) + (_e494[2] * _e412)) + (((_e505[0] * _e455) + (_e505[1] * _e456)) + (_e505[2] * _e457)));
                let _e517 = local_12.member[1u];
                let _e525 = (((_e517[0] * _e406) + (_e517[1] * _e409)) + (_e517[2] * _e412));
                let _e528 = local_12.member[0u];
                if (_e528[0] < 0.0lf) {
                    phi_1474_ = -(_e528[0]);
                } else {
                    phi_1474_ = _e528[0];
                }
                let _e535 = phi_1474_;
                if (_e528[1] < 0.0lf) {
                    phi_1481_ = -(_e528[1]);
                } else {
                    phi_1481_ = _e528[1];
                }
                let _e539 = phi_1481_;
                if (_e535 > _e539) {
                    phi_1486_ = _e535;
                } else {
                    phi_1486_ = _e539;
                }
                let _e542 = phi_1486_;
                if (_e528[2] < 0.0lf) {
                    phi_1493_ = -(_e528[2]);
                } else {
                    phi_1493_ = _e528[2];
                }
                let _e546 = phi_1493_;
                if (_e542 > _e546) {
                    phi_1498_ = _e542;
                } else {
                    phi_1498_ = _e546;
                }
                let _e549 = phi_1498_;
                let _e552 = local_12.member[1u];
                if (_e552[0] < 0.0lf) {
                    phi_1511_ = -(_e552[0]);
                } else {
                    phi_1511_ = _e552[0];
                }
                let _e559 = phi_1511_;
                if (_e552[1] < 0.0lf) {
                    phi_1518_ = -(_e552[1]);
                } else {
                    phi_1518_ = _e552[1];
                }
                let _e563 = phi_1518_;
                if (_e559 > _e563) {
                    phi_1523_ = _e559;
                } else {
                    phi_1523_ = _e563;
                }
                let _e566 = phi_1523_;
                if (_e552[2] < 0.0lf) {
                    phi_1530_ = -(_e552[2]);
                } else {
                    phi_1530_ = _e552[2];
                }
                let _e570 = phi_1530_;
                if (_e566 > _e570) {
                    phi_1535_ = _e566;
                } else {
                    phi_1535_ = _e570;
                }
                let _e573 = phi_1535_;
                if (_e549 > _e573) {
                    phi_1540_ = _e549;
                } else {
                    phi_1540_ = _e573;
                }
                let _e576 = phi_1540_;
                let _e578 = local_12.member_3;
                let _e579 = (_e576 + _e578);
                let _e582 = local_12.member_1[0u];
                if (_e582[0] < 0.0lf) {
                    phi_1557_ = -(_e582[0]);
                } else {
                    phi_1557_ = _e582[0];
                }
                let _e589 = phi_1557_;
                if (_e582[1] < 0.0lf) {
                    phi_1564_ = -(_e582[1]);
                } else {
                    phi_1564_ = _e582[1];
                }
                let _e593 = phi_1564_;
                if (_e589 > _e593) {
                    phi_1569_ = _e589;
                } else {
                    phi_1569_ = _e593;
                }
                let _e596 = phi_1569_;
                if (_e582[2] < 0.0lf) {
                    phi_1576_ = -(_e582[2]);
                } else {
                    phi_1576_ = _e582[2];
                }
                let _e600 = phi_1576_;
                if (_e596 > _e600) {
                    phi_1581_ = _e596;
                } else {
                    phi_1581_ = _e600;
                }
                let _e603 = phi_1581_;
                let _e606 = local_12.member_1[1u];
                if (_e606[0] < 0.0lf) {
                    phi_1595_ = -(_e606[0]);
                } else {
                    phi_1595_ = _e606[0];
                }
                let _e613 = phi_1595_;
                if (_e606[1] < 0.0lf) {
                    phi_1602_ = -(_e606[1]);
                } else {
                    phi_1602_ = _e606[1];
                }
                let _e617 = phi_1602_;
                if (_e613 > _e617) {
                    phi_1607_ = _e613;
                } else {
                    phi_1607_ = _e617;
                }
                let _e620 = phi_1607_;
                if (_e606[2] < 0.0lf) {
                    phi_1614_ = -(_e606[2]);
                } else {
                    phi_1614_ = _e606[2];
                }
                let _e624 = phi_1614_;
                if (_e620 > _e624) {
                    phi_1619_ = _e620;
                } else {
                    phi_1619_ = _e624;
                }
                let _e627 = phi_1619_;
                if (_e603 > _e627) {
                    phi_1624_ = _e603;
                } else {
                    phi_1624_ = _e627;
                }
                let _e630 = phi_1624_;
                let _e632 = local_12.member_3;
                let _e633 = (_e630 + _e632);
                let _e636 = local_12.member_2[0u];
                if (_e636[0] < 0.0lf) {
                    phi_1641_ = -(_e636[0]);
                } else {
                    phi_1641_ = _e636[0];
                }
                let _e643 = phi_1641_;
                if (_e636[1] < 0.0lf) {
                    phi_1648_ = -(_e636[1]);
                } else {
                    phi_1648_ = _e636[1];
                }
                let _e647 = phi_1648_;
                if (_e643 > _e647) {
                    phi_1653_ = _e643;
                } else {
                    phi_1653_ = _e647;
                }
                let _e650 = phi_1653_;
                if (_e636[2] < 0.0lf) {
                    phi_1660_ = -(_e636[2]);
                } else {
                    phi_1660_ = _e636[2];
                }
                let _e654 = phi_1660_;
                if (_e650 > _e654) {
                    phi_1665_ = _e650;
                } else {
                    phi_1665_ = _e654;
                }
                let _e657 = phi_1665_;
                let _e660 = local_12.member_2[1u];
                if (_e660[0] < 0.0lf) {
                    phi_1679_ = -(_e660[0]);
                } else {
                    phi_1679_ = _e660[0];
                }
                let _e667 = phi_1679_;
                if (_e660[1] < 0.0lf) {
                    phi_1686_ = -(_e660[1]);
                } else {
                    phi_1686_ = _e660[1];
                }
                let _e671 = phi_1686_;
                if (_e667 > _e671) {
                    phi_1691_ = _e667;
                } else {
                    phi_1691_ = _e671;
                }
                let _e674 = phi_1691_;
                if (_e660[2] < 0.0lf) {
                    phi_1698_ = -(_e660[2]);
                } else {
                    phi_1698_ = _e660[2];
                }
                let _e678 = phi_1698_;
                if (_e674 > _e678) {
                    phi_1703_ = _e674;
                } else {
                    phi_1703_ = _e678;
                }
                let _e681 = phi_1703_;
                if (_e657 > _e681) {
                    phi_1708_ = _e657;
                } else {
                    phi_1708_ = _e681;
                }
                let _e684 = phi_1708_;
                let _e686 = local_12.member_3;
                let _e687 = (_e684 + _e686);
                let _e688 = f64(1f);
                let _e689 = f64(8f);
                let _e691 = ((_e633 * _e689) * _e687);
                let _e699 = local_12.member_3;
                if (_e385 < 0.0lf) {
                    phi_1745_ = -(_e385);
                } else {
                    phi_1745_ = _e385;
                }
                let _e719 = phi_1745_;
                if (_e388 < 0.0lf) {
                    phi_1751_ = -(_e388);
                } else {
                    phi_1751_ = _e388;
                }
                let _e723 = phi_1751_;
                if (_e391 < 0.0lf) {
                    phi_1758_ = -(_e391);
                } else {
                    phi_1758_ = _e391;
                }
                let _e728 = phi_1758_;
                let _e729 = ((_e719 + _e723) + _e728);
                if (_e406 < 0.0lf) {
                    phi_1765_ = -(_e406);
                } else {
                    phi_1765_ = _e406;
                }
                let _e733 = phi_1765_;
                if (_e409 < 0.0lf) {
                    phi_1771_ = -(_e409);
                } else {
                    phi_1771_ = _e409;
                }
                let _e737 = phi_1771_;
                if (_e412 < 0.0lf) {
                    phi_1778_ = -(_e412);
                } else {
                    phi_1778_ = _e412;
                }
                let _e742 = phi_1778_;
                let _e743 = ((_e733 + _e737) + _e742);
                if (_e729 > _e743) {
                    phi_1784_ = _e729;
                } else {
                    phi_1784_ = _e743;
                }
                let _e746 = phi_1784_;
                if (_e455 < 0.0lf) {
                    phi_1790_ = -(_e455);
                } else {
                    phi_1790_ = _e455;
                }
                let _e750 = phi_1790_;
                if (_e456 < 0.0lf) {
                    phi_1796_ = -(_e456);
                } else {
                    phi_1796_ = _e456;
                }
                let _e754 = phi_1796_;
                if (_e457 < 0.0lf) {
                    phi_1803_ = -(_e457);
                } else {
                    phi_1803_ = _e457;
                }
                let _e759 = phi_1803_;
                let _e761 = (((_e750 + _e754) + _e759) * f64(0.5f));
                if (_e746 > _e761) {
                    phi_1810_ = _e746;
                } else {
                    phi_1810_ = _e761;
                }
                let _e764 = phi_1810_;
                let _e770 = local_12.member_3;
                let _e784 = (((((_e579 * _e689) * _e691) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e699 * f64(19f)) * ((_e579 * (_e633 + _e687)) + (_e633 * _e687)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e688 + _e579) * ((_e688 + _e633) * (_e688 + _e687)))));
                let _e785 = f64(3f);
                let _e786 = (_e468 * _e785);
                let _e787 = (_e525 * _e785);
                if (_e786 < _e787) {
                    phi_1838_ = _e786;
                } else {
                    phi_1838_ = _e787;
                }
                let _e790 = phi_1838_;
                if (_e491 < _e514) {
                    phi_1843_ = _e491;
                } else {
                    phi_1843_ = _e514;
                }
                let _e793 = phi_1843_;
                if (_e790 < _e793) {
                    phi_1848_ = _e790;
                } else {
                    phi_1848_ = _e793;
                }
                let _e796 = phi_1848_;
                if (_e786 > _e787) {
                    phi_1853_ = _e786;
                } else {
                    phi_1853_ = _e787;
                }
                let _e799 = phi_1853_;
                if (_e491 > _e514) {
                    phi_1858_ = _e491;
                } else {
                    phi_1858_ = _e514;
                }
                let _e802 = phi_1858_;
                if (_e799 > _e802) {
                    phi_1863_ = _e799;
                } else {
                    phi_1863_ = _e802;
                }
                let _e805 = phi_1863_;
                let _e811 = -(_e805);
                if (_e796 > _e811) {
                    phi_1874_ = _e796;
                } else {
                    phi_1874_ = _e811;
                }
                let _e814 = phi_1874_;
                if ((_e814 - (_e784 + ((_e369 * (((_e764 + (_e691 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e770 * f64(6f)) * (_e633 + _e687))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e688 + _e633) * (_e688 + _e687))))) * f64((3f * 1.0001f))))) > _e370) {
                    phi_6331_ = type_42(0u, type_42().member_1);
                } else {
                    if (_e369 > _e370) {
                        let _e2903 = f64(1f);
                        let _e2907 = local_12.member[0u];
                        let _e2913 = local_12.member_1[0u];
                        let _e2919 = local_12.member_2[0u];
                        local_9 = array<array<f64, 3>, 4>(_e2907, array<f64, 3>((_e2907[0] - _e2913[0]), (_e2907[1] - _e2913[1]), (_e2907[2] - _e2913[2])), array<f64, 3>((_e2907[0] - _e2919[0]), (_e2907[1] - _e2919[1]), (_e2907[2] - _e2919[2])), _e2907);
                        let _e2934 = local_12.member[1u];
                        let _e2940 = local_12.member_1[1u];
                        let _e2946 = local_12.member_2[1u];
                        local_10 = array<array<f64, 3>, 4>(_e2934, array<f64, 3>((_e2934[0] - _e2940[0]), (_e2934[1] - _e2940[1]), (_e2934[2] - _e2940[2])), array<f64, 3>((_e2934[0] - _e2946[0]), (_e2934[1] - _e2946[1]), (_e2934[2] - _e2946[2])), _e2934);
                        let _e2961 = local_12.member[0u];
                        if (_e2961[0] < 0.0lf) {
                            phi_2077_ = -(_e2961[0]);
                        } else {
                            phi_2077_ = _e2961[0];
                        }
                        let _e2968 = phi_2077_;
                        if (_e2961[1] < 0.0lf) {
                            phi_2084_ = -(_e2961[1]);
                        } else {
                            phi_2084_ = _e2961[1];
                        }
                        let _e2972 = phi_2084_;
                        if (_e2968 > _e2972) {
                            phi_2089_ = _e2968;
                        } else {
                            phi_2089_ = _e2972;
                        }
                        let _e2975 = phi_2089_;
                        if (_e2961[2] < 0.0lf) {
                            phi_2096_ = -(_e2961[2]);
                        } else {
                            phi_2096_ = _e2961[2];
                        }
                        let _e2979 = phi_2096_;
                        if (_e2975 > _e2979) {
                            phi_2101_ = _e2975;
                        } else {
                            phi_2101_ = _e2979;
                        }
                        let _e2982 = phi_2101_;
                        let _e2985 = local_12.member[1u];
                        if (_e2985[0] < 0.0lf) {
                            phi_2114_ = -(_e2985[0]);
                        } else {
                            phi_2114_ = _e2985[0];
                        }
                        let _e2992 = phi_2114_;
                        if (_e2985[1] < 0.0lf) {
                            phi_2121_ = -(_e2985[1]);
                        } else {
                            phi_2121_ = _e2985[1];
                        }
                        let _e2996 = phi_2121_;
                        if (_e2992 > _e2996) {
                            phi_2126_ = _e2992;
                        } else {
                            phi_2126_ = _e2996;
                        }
                        let _e2999 = phi_2126_;
                        if (_e2985[2] < 0.0lf) {
                            phi_2133_ = -(_e2985[2]);
                        } else {
                            phi_2133_ = _e2985[2];
                        }
                        let _e3003 = phi_2133_;
                        if (_e2999 > _e3003) {
                            phi_2138_ = _e2999;
                        } else {
                            phi_2138_ = _e3003;
                        }
                        let _e3006 = phi_2138_;
                        if (_e2982 > _e3006) {
                            phi_2143_ = _e2982;
                        } else {
                            phi_2143_ = _e3006;
                        }
                        let _e3009 = phi_2143_;
                        let _e3011 = local_12.member_3;
                        let _e3015 = local_12.member_1[0u];
                        if (_e3015[0] < 0.0lf) {
                            phi_2160_ = -(_e3015[0]);
                        } else {
                            phi_2160_ = _e3015[0];
                        }
                        let _e3022 = phi_2160_;
                        if (_e3015[1] < 0.0lf) {
                            phi_2167_ = -(_e3015[1]);
                        } else {
                            phi_2167_ = _e3015[1];
                        }
                        let _e3026 = phi_2167_;
                        if (_e3022 > _e3026) {
                            phi_2172_ = _e3022;
                        } else {
                            phi_2172_ = _e3026;
                        }
                        let _e3029 = phi_2172_;
                        if (_e3015[2] < 0.0lf) {
                            phi_2179_ = -(_e3015[2]);
                        } else {
                            phi_2179_ = _e3015[2];
                        }
                        let _e3033 = phi_2179_;
                        if (_e3029 > _e3033) {
                            phi_2184_ = _e3029;
                        } else {
                            phi_2184_ = _e3033;
                        }
                        let _e3036 = phi_2184_;
                        let _e3039 = local_12.member_1[1u];
                        if (_e3039[0] < 0.0lf) {
                            phi_2198_ = -(_e3039[0]);
                        } else {
                            phi_2198_ = _e3039[0];
                        }
                        let _e3046 = phi_2198_;
                        if (_e3039[1] < 0.0lf) {
                            phi_2205_ = -(_e3039[1]);
                        } else {
                            phi_2205_ = _e3039[1];
                        }
                        let _e3050 = phi_2205_;
                        if (_e3046 > _e3050) {
                            phi_2210_ = _e3046;
                        } else {
                            phi_2210_ = _e3050;
                        }
                        let _e3053 = phi_2210_;
                        if (_e3039[2] < 0.0lf) {
                            phi_2217_ = -(_e3039[2]);
                        } else {
                            phi_2217_ = _e3039[2];
                        }
                        let _e3057 = phi_2217_;
                        if (_e3053 > _e3057) {
                            phi_2222_ = _e3053;
                        } else {
                            phi_2222_ = _e3057;
                        }
                        let _e3060 = phi_2222_;
                        if (_e3036 > _e3060) {
                            phi_2227_ = _e3036;
                        } else {
                            phi_2227_ = _e3060;
                        }
                        let _e3063 = phi_2227_;
                        let _e3065 = local_12.member_3;
                        let _e3069 = local_12.member_2[0u];
                        if (_e3069[0] < 0.0lf) {
                            phi_2244_ = -(_e3069[0]);
                        } else {
                            phi_2244_ = _e3069[0];
                        }
                        let _e3076 = phi_2244_;
                        if (_e3069[1] < 0.0lf) {
                            phi_2251_ = -(_e3069[1]);
                        } else {
                            phi_2251_ = _e3069[1];
                        }
                        let _e3080 = phi_2251_;
                        if (_e3076 > _e3080) {
                            phi_2256_ = _e3076;
                        } else {
                            phi_2256_ = _e3080;
                        }
                        let _e3083 = phi_2256_;
                        if (_e3069[2] < 0.0lf) {
                            phi_2263_ = -(_e3069[2]);
                        } else {
                            phi_2263_ = _e3069[2];
                        }
                        let _e3087 = phi_2263_;
                        if (_e3083 > _e3087) {
                            phi_2268_ = _e3083;
                        } else {
                            phi_2268_ = _e3087;
                        }
                        let _e3090 = phi_2268_;
                        let _e3093 = local_12.member_2[1u];
                        if (_e3093[0] < 0.0lf) {
                            phi_2282_ = -(_e3093[0]);
                        } else {
                            phi_2282_ = _e3093[0];
                        }
                        let _e3100 = phi_2282_;
                        if (_e3093[1] < 0.0lf) {
                            phi_2289_ = -(_e3093[1]);
                        } else {
                            phi_2289_ = _e3093[1];
                        }
                        let _e3104 = phi_2289_;
                        if (_e3100 > _e3104) {
                            phi_2294_ = _e3100;
                        } else {
                            phi_2294_ = _e3104;
                        }
                        let _e3107 = phi_2294_;
                        if (_e3093[2] < 0.0lf) {
                            phi_2301_ = -(_e3093[2]);
                        } else {
                            phi_2301_ = _e3093[2];
                        }
                        let _e3111 = phi_2301_;
                        if (_e3107 > _e3111) {
                            phi_2306_ = _e3107;
                        } else {
                            phi_2306_ = _e3111;
                        }
                        let _e3114 = phi_2306_;
                        if (_e3090 > _e3114) {
                            phi_2311_ = _e3090;
                        } else {
                            phi_2311_ = _e3114;
                        }
                        let _e3117 = phi_2311_;
                        let _e3119 = local_12.member_3;
                        let _e3127 = local_12.member_3;
                        phi_2331_ = type_9(0u, 48u);
                        phi_2334_ = f64(0f);
                        loop {
                            let _e3136 = phi_2331_;
                            let _e3138 = phi_2334_;
                            local_77 = _e3138;
                            local_37 = _e3138;
                            local_38 = _e3138;
                            local_39 = _e3138;
                            local_40 = _e3138;
                            if (_e3136.member < _e3136.member_1) {
                                phi_2332_ = type_9((_e3136.member + 1u), _e3136.member_1);
                                phi_2357_ = type_9(1u, _e3136.member);
                            } else {
                                phi_2332_ = _e3136;
                                phi_2357_ = type_9(0u, type_9().member_1);
                            }
                            let _e3150 = phi_2332_;
                            let _e3152 = phi_2357_;
                            if (bitcast<i32>(_e3152.member) != 0i) {
                                let _e3158 = local_12.member[0u];
                                let _e3164 = local_12.member[1u];
                                let _e3180 = local_12.member_1[0u];
                                let _e3186 = local_12.member_1[1u];
                                let _e3202 = local_12.member_2[0u];
                                let _e3208 = local_12.member_2[1u];
                                let _e3222 = function_2(array<f64, 3>((_e3158[0] + ((_e3164[0] - _e3158[0]) * _e3138)), (_e3158[1] + ((_e3164[1] - _e3158[1]) * _e3138)), (_e3158[2] + ((_e3164[2] - _e3158[2]) * _e3138))), array<f64, 3>((_e3180[0] + ((_e3186[0] - _e3180[0]) * _e3138)), (_e3180[1] + ((_e3186[1] - _e3180[1]) * _e3138)), (_e3180[2] + ((_e3186[2] - _e3180[2]) * _e3138))), array<f64, 3>((_e3202[0] + ((_e3208[0] - _e3202[0]) * _e3138)), (_e3202[1] + ((_e3208[1] - _e3202[1]) * _e3138)), (_e3202[2] + ((_e3208[2] - _e3202[2]) * _e3138))), 0u);
                                if (_e3222[0] < 0.0lf) {
                                    phi_2468_ = -(_e3222[0]);
                                } else {
                                    phi_2468_ = _e3222[0];
                                }
                                let _e3227 = phi_2468_;
                                if (_e3222[1] < 0.0lf) {
                                    phi_2475_ = -(_e3222[1]);
                                } else {
                                    phi_2475_ = _e3222[1];
                                }
                                let _e3232 = phi_2475_;
                                if (_e3222[2] < 0.0lf) {
                                    phi_2483_ = -(_e3222[2]);
                                } else {
                                    phi_2483_ = _e3222[2];
                                }
                                let _e3238 = phi_2483_;
                                let _e3239 = ((_e3227 + _e3232) + _e3238);
                                if (_e3239 > f64(0f)) {
                                    if ((bitcast<u64>(_e3239) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e3245 = (f64(1f) / _e3239);
                                        let _e3247 = (_e3222[0] * _e3245);
                                        let _e3249 = (_e3222[1] * _e3245);
                                        let _e3251 = (_e3222[2] * _e3245);
                                        let _e3256 = (((_e3247 * _e3247) + (_e3249 * _e3249)) + (_e3251 * _e3251));
                                        if (_e3256 <= 2.2250738585072014e-308lf) {
                                            if (_e3256 > 0.0lf) {
                                                phi_2521_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2521_ = 0.0lf;
                                            }
                                            let _e3308 = phi_2521_;
                                            phi_2585_ = _e3308;
                                        } else {
                                            phi_2528_ = type_16(0i, 5i);
                                            phi_2531_ = bitcast<f64>(((bitcast<u64>(_e3256) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3263 = phi_2528_;
                                                let _e3265 = phi_2531_;
                                                local_31 = _e3265;
                                                if (_e3263.member < _e3263.member_1) {
                                                    let _e3272 = (_e3263.member + 1i);
                                                    if ((false == (_e3272 > _e3263.member)) != false) {
                                                        phi_2552_ = true;
                                                    } else {
                                                        phi_2552_ = false;
                                                    }
                                                    let _e3277 = phi_2552_;
                                                    if _e3277 {
                                                        phi_2558_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_2558_ = type_17(1u, _e3272);
                                                    }
                                                    let _e3282 = phi_2558_;
                                                    phi_2529_ = type_16(_e3282.member_1, _e3263.member_1);
                                                    phi_2572_ = type_17(1u, _e3263.member);
                                                } else {
                                                    phi_2529_ = _e3263;
                                                    phi_2572_ = type_17(0u, type_17().member_1);
                                                }
                                                let _e3288 = phi_2529_;
                                                let _e3290 = phi_2572_;
                                                let _e3293 = (bitcast<i32>(_e3290.member) != 0i);
                                                if _e3293 {
                                                    phi_2532_ = (0.5lf * (_e3265 + (_e3256 / _e3265)));
                                                } else {
                                                    phi_2532_ = f64();
                                                }
                                                let _e3298 = phi_2532_;
                                                continue;
                                                continuing {
                                                    phi_2528_ = _e3288;
                                                    phi_2531_ = _e3298;
                                                    break if !(_e3293);
                                                }
                                            }
                                            let _e3303 = local_31;
                                            phi_2585_ = (_e3303 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e3310 = phi_2585_;
                                        phi_2598_ = type_9(0u, 4u);
                                        phi_2601_ = f64(2f);
                                        loop {
                                            let _e3322 = phi_2598_;
                                            let _e3324 = phi_2601_;
                                            local_33 = _e3324;
                                            local_34 = _e3324;
                                            local_35 = _e3324;
                                            local_67 = _e3324;
                                            local_68 = _e3324;
                                            if (_e3322.member < _e3322.member_1) {
                                                phi_2599_ = type_9((_e3322.member + 1u), _e3322.member_1);
                                                phi_2624_ = type_9(1u, _e3322.member);
                                            } else {
                                                phi_2599_ = _e3322;
                                                phi_2624_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e3336 = phi_2599_;
                                            let _e3338 = phi_2624_;
                                            if (bitcast<i32>(_e3338.member) != 0i) {
                                                let _e3344 = local_9[_e3338.member_1];
                                                let _e3352 = (((_e3247 * _e3344[0]) + (_e3249 * _e3344[1])) + (_e3251 * _e3344[2]));
                                                let _e3354 = local_10[_e3338.member_1];
                                                let _e3362 = (((_e3247 * _e3354[0]) + (_e3249 * _e3354[1])) + (_e3251 * _e3354[2]));
                                                if (_e3352 < 0.0lf) {
                                                    phi_2675_ = -(_e3352);
                                                } else {
                                                    phi_2675_ = _e3352;
                                                }
                                                let _e3366 = phi_2675_;
                                                if (_e3362 < 0.0lf) {
                                                    phi_2681_ = -(_e3362);
                                                } else {
                                                    phi_2681_ = _e3362;
                                                }
                                                let _e3370 = phi_2681_;
                                                let _e3375 = (((((((((_e3009 + _e3011) + (_e3063 + _e3065)) + (_e3117 + _e3119)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3127 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e369 * _e3310) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e3366 + _e3370) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e3352 > _e3375) {
                                                    if (_e3362 > _e3375) {
                                                        phi_2695_ = false;
                                                    } else {
                                                        phi_2695_ = true;
                                                    }
                                                    let _e3379 = phi_2695_;
                                                    phi_2696_ = _e3379;
                                                } else {
                                                    phi_2696_ = true;
                                                }
                                                let _e3381 = phi_2696_;
                                                if _e3381 {
                                                    if ((_e3352 + ((_e3362 - _e3352) * _e3138)) > _e3375) {
                                                        if (_e3362 < _e3352) {
                                                            let _e3390 = ((_e3352 - _e3362) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                            if _e3390 {
                                                                let _e3398 = (((_e3352 - _e3375) / (_e3352 - _e3362)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                if (_e3324 < _e3398) {
                                                                    phi_2730_ = _e3324;
                                                                } else {
                                                                    phi_2730_ = _e3398;
                                                                }
                                                                let _e3401 = phi_2730_;
                                                                phi_2731_ = _e3401;
                                                            } else {
                                                                phi_2731_ = f64();
                                                            }
                                                            let _e3403 = phi_2731_;
                                                            phi_2732_ = _e3403;
                                                            phi_2733_ = _e3390;
                                                        } else {
                                                            phi_2732_ = _e3324;
                                                            phi_2733_ = true;
                                                        }
                                                        let _e3405 = phi_2732_;
                                                        let _e3407 = phi_2733_;
                                                        if _e3407 {
                                                            phi_2737_ = false;
                                                        } else {
                                                            phi_2737_ = true;
                                                        }
                                                        let _e3409 = phi_2737_;
                                                        phi_2738_ = _e3405;
                                                        phi_2739_ = _e3407;
                                                        phi_2740_ = _e3409;
                                                        phi_2741_ = false;
                                                    } else {
                                                        phi_2738_ = f64();
                                                        phi_2739_ = false;
                                                        phi_2740_ = false;
                                                        phi_2741_ = true;
                                                    }
                                                    let _e3411 = phi_2738_;
                                                    let _e3413 = phi_2739_;
                                                    let _e3415 = phi_2740_;
                                                    let _e3417 = phi_2741_;
                                                    phi_2742_ = _e3411;
                                                    phi_2743_ = _e3413;
                                                    phi_2744_ = _e3415;
                                                    phi_2745_ = _e3417;
                                                } else {
                                                    phi_2742_ = _e3324;
                                                    phi_2743_ = true;
                                                    phi_2744_ = false;
                                                    phi_2745_ = false;
                                                }
                                                let _e3419 = phi_2742_;
                                                let _e3421 = phi_2743_;
                                                let _e3423 = phi_2744_;
                                                let _e3425 = phi_2745_;
                                                phi_2602_ = _e3419;
                                                phi_2746_ = _e3421;
                                                phi_2747_ = false;
                                                phi_2748_ = _e3423;
                                                phi_2749_ = _e3425;
                                            } else {
                                                phi_2602_ = f64();
                                                phi_2746_ = false;
                                                phi_2747_ = true;
                                                phi_2748_ = false;
                                                phi_2749_ = false;
                                            }
                                            let _e3427 = phi_2602_;
                                            let _e3429 = phi_2746_;
                                            let _e3431 = phi_2747_;
                                            let _e3433 = phi_2748_;
                                            let _e3435 = phi_2749_;
                                            local_32 = _e3431;
                                            local_65 = _e3433;
                                            local_66 = _e3435;
                                            continue;
                                            continuing {
                                                phi_2598_ = _e3336;
                                                phi_2601_ = _e3427;
                                                break if !(_e3429);
                                            }
                                        }
                                        let _e3438 = local_32;
                                        if _e3438 {
                                            let _e3440 = local_33;
                                            let _e3441 = (_e3440 > _e2903);
                                            if _e3441 {
                                                phi_2771_ = false;
                                                phi_2772_ = false;
                                                phi_2773_ = false;
                                            } else {
                                                let _e3443 = local_34;
                                                if (_e3443 > _e3138) {
                                                    let _e3446 = local_35;
                                                    let _e3449 = ((_e3446 - _e3138) < f64(0.00000000023283064f));
                                                    if _e3449 {
                                                        phi_2767_ = false;
                                                    } else {
                                                        phi_2767_ = true;
                                                    }
                                                    let _e3451 = phi_2767_;
                                                    phi_2768_ = _e3451;
                                                    phi_2769_ = _e3449;
                                                    phi_2770_ = false;
                                                } else {
                                                    phi_2768_ = false;
                                                    phi_2769_ = false;
                                                    phi_2770_ = true;
                                                }
                                                let _e3453 = phi_2768_;
                                                let _e3455 = phi_2769_;
                                                let _e3457 = phi_2770_;
                                                phi_2771_ = _e3453;
                                                phi_2772_ = _e3455;
                                                phi_2773_ = _e3457;
                                            }
                                            let _e3459 = phi_2771_;
                                            let _e3461 = phi_2772_;
                                            let _e3463 = phi_2773_;
                                            phi_2774_ = _e3459;
                                            phi_2775_ = _e3441;
                                            phi_2776_ = _e3461;
                                            phi_2777_ = _e3463;
                                            phi_2778_ = false;
                                            phi_2779_ = false;
                                        } else {
                                            phi_2774_ = false;
                                            phi_2775_ = false;
                                            phi_2776_ = false;
                                            phi_2777_ = false;
                                            let _e4737 = local_65;
                                            phi_2778_ = _e4737;
                                            let _e4740 = local_66;
                                            phi_2779_ = _e4740;
                                        }
                                        let _e3465 = phi_2774_;
                                        let _e3467 = phi_2775_;
                                        let _e3469 = phi_2776_;
                                        let _e3471 = phi_2777_;
                                        let _e3473 = phi_2778_;
                                        let _e3475 = phi_2779_;
                                        let _e4743 = local_67;
                                        phi_2780_ = _e4743;
                                        let _e4746 = local_68;
                                        phi_2781_ = _e4746;
                                        phi_2782_ = _e3465;
                                        phi_2783_ = _e3467;
                                        phi_2784_ = _e3469;
                                        phi_2785_ = _e3471;
                                        phi_2786_ = _e3473;
                                        phi_2787_ = _e3475;
                                        phi_2788_ = false;
                                    } else {
                                        phi_2780_ = f64();
                                        phi_2781_ = f64();
                                        phi_2782_ = false;
                                        phi_2783_ = false;
                                        phi_2784_ = false;
                                        phi_2785_ = false;
                                        phi_2786_ = false;
                                        phi_2787_ = false;
                                        phi_2788_ = true;
                                    }
                                    let _e3477 = phi_2780_;
                                    let _e3479 = phi_2781_;
                                    let _e3481 = phi_2782_;
                                    let _e3483 = phi_2783_;
                                    let _e3485 = phi_2784_;
                                    let _e3487 = phi_2785_;
                                    let _e3489 = phi_2786_;
                                    let _e3491 = phi_2787_;
                                    let _e3493 = phi_2788_;
                                    phi_2789_ = _e3477;
                                    phi_2790_ = _e3479;
                                    phi_2791_ = _e3481;
                                    phi_2792_ = _e3483;
                                    phi_2793_ = _e3485;
                                    phi_2794_ = _e3487;
                                    phi_2795_ = _e3489;
                                    phi_2796_ = _e3491;
                                    phi_2797_ = _e3493;
                                    phi_2798_ = false;
                                } else {
                                    phi_2789_ = f64();
                                    phi_2790_ = f64();
                                    phi_2791_ = false;
                                    phi_2792_ = false;
                                    phi_2793_ = false;
                                    phi_2794_ = false;
                                    phi_2795_ = false;
                                    phi_2796_ = false;
                                    phi_2797_ = false;
                                    phi_2798_ = true;
                                }
                                let _e3495 = phi_2789_;
                                let _e3497 = phi_2790_;
                                let _e3499 = phi_2791_;
                                let _e3501 = phi_2792_;
                                let _e3503 = phi_2793_;
                                let _e3505 = phi_2794_;
                                let _e3507 = phi_2795_;
                                let _e3509 = phi_2796_;
                                let _e3511 = phi_2797_;
                                let _e3513 = phi_2798_;
                                phi_2799_ = _e3495;
                                phi_2335_ = _e3497;
                                phi_2800_ = _e3499;
                                phi_2801_ = _e3501;
                                phi_2802_ = _e3503;
                                phi_2803_ = false;
                                phi_2804_ = _e3505;
                                phi_2805_ = _e3507;
                                phi_2806_ = _e3509;
                                phi_2807_ = _e3511;
                                phi_2808_ = _e3513;
                            } else {
                                phi_2799_ = f64();
                                phi_2335_ = f64();
                                phi_2800_ = false;
                                phi_2801_ = false;
                                phi_2802_ = false;
                                phi_2803_ = true;
                                phi_2804_ = false;
                                phi_2805_ = false;
                                phi_2806_ = false;
                                phi_2807_ = false;
                                phi_2808_ = false;
                            }
                            let _e3515 = phi_2799_;
                            let _e3517 = phi_2335_;
                            let _e3519 = phi_2800_;
                            let _e3521 = phi_2801_;
                            let _e3523 = phi_2802_;
                            let _e3525 = phi_2803_;
                            let _e3527 = phi_2804_;
                            let _e3529 = phi_2805_;
                            let _e3531 = phi_2806_;
                            let _e3533 = phi_2807_;
                            let _e3535 = phi_2808_;
                            local_36 = _e3521;
                            local_69 = _e3523;
                            local_70 = _e3525;
                            local_71 = _e3527;
                            local_72 = _e3529;
                            local_73 = _e3531;
                            local_74 = _e3533;
                            local_75 = _e3535;
                            local_76 = _e3515;
                            local_78 = _e3521;
                            continue;
                            continuing {
                                phi_2331_ = _e3150;
                                phi_2334_ = _e3517;
                                break if !(_e3519);
                            }
                        }
                        let _e3538 = local_36;
                        if _e3538 {
                            phi_2813_ = type_42(0u, type_42().member_1);
                            phi_2814_ = false;
                            phi_2815_ = false;
                            phi_2816_ = false;
                            phi_2817_ = false;
                            phi_2818_ = false;
                            phi_2819_ = false;
                            phi_2820_ = false;
                        } else {
                            phi_2813_ = type_42();
                            let _e4779 = local_69;
                            phi_2814_ = _e4779;
                            let _e4782 = local_70;
                            phi_2815_ = _e4782;
                            let _e4785 = local_71;
                            phi_2816_ = _e4785;
                            let _e4788 = local_72;
                            phi_2817_ = _e4788;
                            let _e4791 = local_73;
                            phi_2818_ = _e4791;
                            let _e4794 = local_74;
                            phi_2819_ = _e4794;
                            let _e4797 = local_75;
                            phi_2820_ = _e4797;
                        }
                        let _e3542 = phi_2813_;
                        let _e3544 = phi_2814_;
                        let _e3546 = phi_2815_;
                        let _e3548 = phi_2816_;
                        let _e3550 = phi_2817_;
                        let _e3552 = phi_2818_;
                        let _e3554 = phi_2819_;
                        let _e3556 = phi_2820_;
                        if _e3544 {
                            let _e4800 = local_76;
                            phi_2824_ = _e4800;
                            phi_2825_ = true;
                            phi_2826_ = false;
                            phi_2827_ = false;
                            phi_2828_ = false;
                            phi_2829_ = false;
                            phi_2830_ = false;
                            phi_2831_ = false;
                        } else {
                            let _e4802 = local_77;
                            phi_2824_ = _e4802;
                            phi_2825_ = _e3546;
                            phi_2826_ = _e3548;
                            phi_2827_ = _e3550;
                            phi_2828_ = _e3552;
                            let _e4809 = local_78;
                            phi_2829_ = _e4809;
                            phi_2830_ = _e3554;
                            phi_2831_ = _e3556;
                        }
                        let _e3558 = phi_2824_;
                        let _e3560 = phi_2825_;
                        let _e3562 = phi_2826_;
                        let _e3564 = phi_2827_;
                        let _e3566 = phi_2828_;
                        let _e3568 = phi_2829_;
                        let _e3570 = phi_2830_;
                        let _e3572 = phi_2831_;
                        if _e3560 {
                            phi_2836_ = type_42(1u, _e3558);
                            phi_2837_ = false;
                            phi_2838_ = false;
                            phi_2839_ = false;
                            phi_2840_ = false;
                            phi_2841_ = false;
                            phi_2842_ = false;
                        } else {
                            phi_2836_ = type_42();
                            phi_2837_ = _e3562;
                            phi_2838_ = _e3564;
                            phi_2839_ = _e3566;
                            phi_2840_ = _e3568;
                            phi_2841_ = _e3570;
                            phi_2842_ = _e3572;
                        }
                        let _e3575 = phi_2836_;
                        let _e3577 = phi_2837_;
                        let _e3579 = phi_2838_;
                        let _e3581 = phi_2839_;
                        let _e3583 = phi_2840_;
                        let _e3585 = phi_2841_;
                        let _e3587 = phi_2842_;
                        if _e3577 {
                            let _e3589 = local_37;
                            phi_2847_ = type_42(1u, _e3589);
                            phi_2848_ = false;
                            phi_2849_ = false;
                            phi_2850_ = true;
                            phi_2851_ = false;
                            phi_2852_ = false;
                        } else {
                            phi_2847_ = _e3542;
                            phi_2848_ = _e3579;
                            phi_2849_ = _e3581;
                            phi_2850_ = _e3583;
                            phi_2851_ = _e3585;
                            phi_2852_ = _e3587;
                        }
                        let _e3592 = phi_2847_;
                        let _e3594 = phi_2848_;
                        let _e3596 = phi_2849_;
                        let _e3598 = phi_2850_;
                        let _e3600 = phi_2851_;
                        let _e3602 = phi_2852_;
                        if _e3594 {
                            let _e3604 = local_38;
                            phi_2857_ = type_42(1u, _e3604);
                            phi_2858_ = false;
                            phi_2859_ = false;
                            phi_2860_ = false;
                            phi_2861_ = false;
                        } else {
                            phi_2857_ = type_42();
                            phi_2858_ = _e3596;
                            phi_2859_ = _e3598;
                            phi_2860_ = _e3600;
                            phi_2861_ = _e3602;
                        }
                        let _e3607 = phi_2857_;
                        let _e3609 = phi_2858_;
                        let _e3611 = phi_2859_;
                        let _e3613 = phi_2860_;
                        let _e3615 = phi_2861_;
                        if _e3609 {
                            let _e3617 = local_39;
                            phi_2866_ = type_42(1u, _e3617);
                            phi_2867_ = true;
                            phi_2868_ = false;
                            phi_2869_ = false;
                            phi_2870_ = false;
                        } else {
                            phi_2866_ = _e3607;
                            phi_2867_ = _e3594;
                            phi_2868_ = _e3611;
                            phi_2869_ = _e3613;
                            phi_2870_ = _e3615;
                        }
                        let _e3620 = phi_2866_;
                        let _e3622 = phi_2867_;
                        let _e3624 = phi_2868_;
                        let _e3626 = phi_2869_;
                        let _e3628 = phi_2870_;
                        if _e3622 {
                            phi_2874_ = _e3620;
                            phi_2875_ = true;
                            phi_2876_ = false;
                            phi_2877_ = false;
                        } else {
                            phi_2874_ = _e3592;
                            phi_2875_ = _e3624;
                            phi_2876_ = _e3626;
                            phi_2877_ = _e3628;
                        }
                        let _e3630 = phi_2874_;
                        let _e3632 = phi_2875_;
                        let _e3634 = phi_2876_;
                        let _e3636 = phi_2877_;
                        if _e3632 {
                            phi_2881_ = false;
                            phi_2882_ = false;
                        } else {
                            phi_2881_ = _e3634;
                            phi_2882_ = _e3636;
                        }
                        let _e3638 = phi_2881_;
                        let _e3640 = phi_2882_;
                        if _e3638 {
                            phi_2886_ = false;
                            phi_2887_ = false;
                        } else {
                            phi_2886_ = _e3640;
                            phi_2887_ = _e3632;
                        }
                        let _e3642 = phi_2886_;
                        let _e3644 = phi_2887_;
                        if _e3642 {
                            phi_2891_ = true;
                            phi_2892_ = false;
                        } else {
                            phi_2891_ = _e3638;
                            phi_2892_ = _e3644;
                        }
                        let _e3646 = phi_2891_;
                        let _e3648 = phi_2892_;
                        if _e3646 {
                            let _e3650 = local_40;
                            phi_2897_ = type_42(1u, _e3650);
                            phi_2898_ = true;
                        } else {
                            phi_2897_ = _e3630;
                            phi_2898_ = _e3648;
                        }
                        let _e3653 = phi_2897_;
                        let _e3655 = phi_2898_;
                        if _e3655 {
                            phi_2902_ = _e3653;
                        } else {
                            phi_2902_ = _e3575;
                        }
                        let _e3657 = phi_2902_;
                        if (_e3657.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_2916_ = type_9(0u, 3u);
                            loop {
                                let _e3669 = phi_2916_;
                                if (_e3669.member < _e3669.member_1) {
                                    phi_2917_ = type_9((_e3669.member + 1u), _e3669.member_1);
                                    phi_2940_ = type_9(1u, _e3669.member);
                                } else {
                                    phi_2917_ = _e3669;
                                    phi_2940_ = type_9(0u, type_9().member_1);
                                }
                                let _e3681 = phi_2917_;
                                let _e3683 = phi_2940_;
                                if (bitcast<i32>(_e3683.member) != 0i) {
                                    let _e3689 = local_11[_e3683.member_1];
                                    let _e3691 = (_e3657.member_1 + f64(_e3689));
                                    if (_e3691 < _e2903) {
                                        phi_2961_ = _e3691;
                                    } else {
                                        phi_2961_ = _e2903;
                                    }
                                    let _e3694 = phi_2961_;
                                    let _e3697 = local_12.member[0u];
                                    let _e3703 = local_12.member[1u];
                                    let _e3719 = local_12.member_1[0u];
                                    let _e3725 = local_12.member_1[1u];
                                    let _e3741 = local_12.member_2[0u];
                                    let _e3747 = local_12.member_2[1u];
                                    let _e3761 = function_2(array<f64, 3>((_e3697[0] + ((_e3703[0] - _e3697[0]) * _e3694)), (_e3697[1] + ((_e3703[1] - _e3697[1]) * _e3694)), (_e3697[2] + ((_e3703[2] - _e3697[2]) * _e3694))), array<f64, 3>((_e3719[0] + ((_e3725[0] - _e3719[0]) * _e3694)), (_e3719[1] + ((_e3725[1] - _e3719[1]) * _e3694)), (_e3719[2] + ((_e3725[2] - _e3719[2]) * _e3694))), array<f64, 3>((_e3741[0] + ((_e3747[0] - _e3741[0]) * _e3694)), (_e3741[1] + ((_e3747[1] - _e3741[1]) * _e3694)), (_e3741[2] + ((_e3747[2] - _e3741[2]) * _e3694))), 0u);
                                    let _e3772 = (((_e3761[0] * _e3761[0]) + (_e3761[1] * _e3761[1])) + (_e3761[2] * _e3761[2]));
                                    if (_e3772 <= 2.2250738585072014e-308lf) {
                                        if (_e3772 > 0.0lf) {
                                            phi_3084_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3084_ = 0.0lf;
                                        }
                                        let _e3824 = phi_3084_;
                                        phi_3148_ = _e3824;
                                    } else {
                                        phi_3091_ = type_16(0i, 5i);
                                        phi_3094_ = bitcast<f64>(((bitcast<u64>(_e3772) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e3779 = phi_3091_;
                                            let _e3781 = phi_3094_;
                                            local_41 = _e3781;
                                            if (_e3779.member < _e3779.member_1) {
                                                let _e3788 = (_e3779.member + 1i);
                                                if ((false == (_e3788 > _e3779.member)) != false) {
                                                    phi_3115_ = true;
                                                } else {
                                                    phi_3115_ = false;
                                                }
                                                let _e3793 = phi_3115_;
                                                if _e3793 {
                                                    phi_3121_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_3121_ = type_17(1u, _e3788);
                                                }
                                                let _e3798 = phi_3121_;
                                                phi_3092_ = type_16(_e3798.member_1, _e3779.member_1);
                                                phi_3135_ = type_17(1u, _e3779.member);
                                            } else {
                                                phi_3092_ = _e3779;
                                                phi_3135_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e3804 = phi_3092_;
                                            let _e3806 = phi_3135_;
                                            let _e3809 = (bitcast<i32>(_e3806.member) != 0i);
                                            if _e3809 {
                                                phi_3095_ = (0.5lf * (_e3781 + (_e3772 / _e3781)));
                                            } else {
                                                phi_3095_ = f64();
                                            }
                                            let _e3814 = phi_3095_;
                                            continue;
                                            continuing {
                                                phi_3091_ = _e3804;
                                                phi_3094_ = _e3814;
                                                break if !(_e3809);
                                            }
                                        }
                                        let _e3819 = local_41;
                                        phi_3148_ = (_e3819 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e3826 = phi_3148_;
                                    let _e3834 = local_12.member[0u];
                                    if (_e3834[0] < 0.0lf) {
                                        phi_3166_ = -(_e3834[0]);
                                    } else {
                                        phi_3166_ = _e3834[0];
                                    }
                                    let _e3841 = phi_3166_;
                                    if (_e3834[1] < 0.0lf) {
                                        phi_3173_ = -(_e3834[1]);
                                    } else {
                                        phi_3173_ = _e3834[1];
                                    }
                                    let _e3845 = phi_3173_;
                                    if (_e3841 > _e3845) {
                                        phi_3178_ = _e3841;
                                    } else {
                                        phi_3178_ = _e3845;
                                    }
                                    let _e3848 = phi_3178_;
                                    if (_e3834[2] < 0.0lf) {
                                        phi_3185_ = -(_e3834[2]);
                                    } else {
                                        phi_3185_ = _e3834[2];
                                    }
                                    let _e3852 = phi_3185_;
                                    if (_e3848 > _e3852) {
                                        phi_3190_ = _e3848;
                                    } else {
                                        phi_3190_ = _e3852;
                                    }
                                    let _e3855 = phi_3190_;
                                    let _e3858 = local_12.member[1u];
                                    if (_e3858[0] < 0.0lf) {
                                        phi_3203_ = -(_e3858[0]);
                                    } else {
                                        phi_3203_ = _e3858[0];
                                    }
                                    let _e3865 = phi_3203_;
                                    if (_e3858[1] < 0.0lf) {
                                        phi_3210_ = -(_e3858[1]);
                                    } else {
                                        phi_3210_ = _e3858[1];
                                    }
                                    let _e3869 = phi_3210_;
                                    if (_e3865 > _e3869) {
                                        phi_3215_ = _e3865;
                                    } else {
                                        phi_3215_ = _e3869;
                                    }
                                    let _e3872 = phi_3215_;
                                    if (_e3858[2] < 0.0lf) {
                                        phi_3222_ = -(_e3858[2]);
                                    } else {
                                        phi_3222_ = _e3858[2];
                                    }
                                    let _e3876 = phi_3222_;
                                    if (_e3872 > _e3876) {
                                        phi_3227_ = _e3872;
                                    } else {
                                        phi_3227_ = _e3876;
                                    }
                                    let _e3879 = phi_3227_;
                                    if (_e3855 > _e3879) {
                                        phi_3232_ = _e3855;
                                    } else {
                                        phi_3232_ = _e3879;
                                    }
                                    let _e3882 = phi_3232_;
                                    let _e3884 = local_12.member_3;
                                    let _e3888 = local_12.member_1[0u];
                                    if (_e3888[0] < 0.0lf) {
                                        phi_3249_ = -(_e3888[0]);
                                    } else {
                                        phi_3249_ = _e3888[0];
                                    }
                                    let _e3895 = phi_3249_;
                                    if (_e3888[1] < 0.0lf) {
                                        phi_3256_ = -(_e3888[1]);
                                    } else {
                                        phi_3256_ = _e3888[1];
                                    }
                                    let _e3899 = phi_3256_;
                                    if (_e3895 > _e3899) {
                                        phi_3261_ = _e3895;
                                    } else {
                                        phi_3261_ = _e3899;
                                    }
                                    let _e3902 = phi_3261_;
                                    if (_e3888[2] < 0.0lf) {
                                        phi_3268_ = -(_e3888[2]);
                                    } else {
                                        phi_3268_ = _e3888[2];
                                    }
                                    let _e3906 = phi_3268_;
                                    if (_e3902 > _e3906) {
                                        phi_3273_ = _e3902;
                                    } else {
                                        phi_3273_ = _e3906;
                                    }
                                    let _e3909 = phi_3273_;
                                    let _e3912 = local_12.member_1[1u];
                                    if (_e3912[0] < 0.0lf) {
                                        phi_3287_ = -(_e3912[0]);
                                    } else {
                                        phi_3287_ = _e3912[0];
                                    }
                                    let _e3919 = phi_3287_;
                                    if (_e3912[1] < 0.0lf) {
                                        phi_3294_ = -(_e3912[1]);
                                    } else {
                                        phi_3294_ = _e3912[1];
                                    }
                                    let _e3923 = phi_3294_;
                                    if (_e3919 > _e3923) {
                                        phi_3299_ = _e3919;
                                    } else {
                                        phi_3299_ = _e3923;
                                    }
                                    let _e3926 = phi_3299_;
                                    if (_e3912[2] < 0.0lf) {
                                        phi_3306_ = -(_e3912[2]);
                                    } else {
                                        phi_3306_ = _e3912[2];
                                    }
                                    let _e3930 = phi_3306_;
                                    if (_e3926 > _e3930) {
                                        phi_3311_ = _e3926;
                                    } else {
                                        phi_3311_ = _e3930;
                                    }
                                    let _e3933 = phi_3311_;
                                    if (_e3909 > _e3933) {
                                        phi_3316_ = _e3909;
                                    } else {
                                        phi_3316_ = _e3933;
                                    }
                                    let _e3936 = phi_3316_;
                                    let _e3938 = local_12.member_3;
                                    let _e3942 = local_12.member_2[0u];
                                    if (_e3942[0] < 0.0lf) {
                                        phi_3333_ = -(_e3942[0]);
                                    } else {
                                        phi_3333_ = _e3942[0];
                                    }
                                    let _e3949 = phi_3333_;
                                    if (_e3942[1] < 0.0lf) {
                                        phi_3340_ = -(_e3942[1]);
                                    } else {
                                        phi_3340_ = _e3942[1];
                                    }
                                    let _e3953 = phi_3340_;
                                    if (_e3949 > _e3953) {
                                        phi_3345_ = _e3949;
                                    } else {
                                        phi_3345_ = _e3953;
                                    }
                                    let _e3956 = phi_3345_;
                                    if (_e3942[2] < 0.0lf) {
                                        phi_3352_ = -(_e3942[2]);
                                    } else {
                                        phi_3352_ = _e3942[2];
                                    }
                                    let _e3960 = phi_3352_;
                                    if (_e3956 > _e3960) {
                                        phi_3357_ = _e3956;
                                    } else {
                                        phi_3357_ = _e3960;
                                    }
                                    let _e3963 = phi_3357_;
                                    let _e3966 = local_12.member_2[1u];
                                    if (_e3966[0] < 0.0lf) {
                                        phi_3371_ = -(_e3966[0]);
                                    } else {
                                        phi_3371_ = _e3966[0];
                                    }
                                    let _e3973 = phi_3371_;
                                    if (_e3966[1] < 0.0lf) {
                                        phi_3378_ = -(_e3966[1]);
                                    } else {
                                        phi_3378_ = _e3966[1];
                                    }
                                    let _e3977 = phi_3378_;
                                    if (_e3973 > _e3977) {
                                        phi_3383_ = _e3973;
                                    } else {
                                        phi_3383_ = _e3977;
                                    }
                                    let _e3980 = phi_3383_;
                                    if (_e3966[2] < 0.0lf) {
                                        phi_3390_ = -(_e3966[2]);
                                    } else {
                                        phi_3390_ = _e3966[2];
                                    }
                                    let _e3984 = phi_3390_;
                                    if (_e3980 > _e3984) {
                                        phi_3395_ = _e3980;
                                    } else {
                                        phi_3395_ = _e3984;
                                    }
                                    let _e3987 = phi_3395_;
                                    if (_e3963 > _e3987) {
                                        phi_3400_ = _e3963;
                                    } else {
                                        phi_3400_ = _e3987;
                                    }
                                    let _e3990 = phi_3400_;
                                    let _e3992 = local_12.member_3;
                                    let _e4000 = local_12.member_3;
                                    let _e4010 = (((_e3826 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e3882 + _e3884) + (_e3936 + _e3938)) + (_e3990 + _e3992)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4000 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e369);
                                    if _e4010 {
                                        phi_3424_ = false;
                                    } else {
                                        phi_3424_ = true;
                                    }
                                    let _e4012 = phi_3424_;
                                    phi_3425_ = _e4012;
                                    phi_3426_ = _e4010;
                                } else {
                                    phi_3425_ = false;
                                    phi_3426_ = false;
                                }
                                let _e4014 = phi_3425_;
                                let _e4016 = phi_3426_;
                                local_42 = _e4016;
                                continue;
                                continuing {
                                    phi_2916_ = _e3681;
                                    break if !(_e4014);
                                }
                            }
                            let _e4019 = local_42;
                            if _e4019 {
                                phi_3431_ = type_42(1u, _e3657.member_1);
                                phi_3432_ = false;
                            } else {
                                phi_3431_ = type_42();
                                phi_3432_ = true;
                            }
                            let _e4022 = phi_3431_;
                            let _e4024 = phi_3432_;
                            if _e4024 {
                                phi_3437_ = type_42(2u, _e3657.member_1);
                                phi_3438_ = false;
                            } else {
                                phi_3437_ = type_42();
                                phi_3438_ = true;
                            }
                            let _e4027 = phi_3437_;
                            let _e4029 = phi_3438_;
                            phi_3440_ = _e4027;
                            phi_3441_ = _e4022;
                            phi_3442_ = _e4029;
                        } else {
                            phi_3440_ = type_42();
                            phi_3441_ = type_42(0u, type_42().member_1);
                            phi_3442_ = true;
                        }
                        let _e4031 = phi_3440_;
                        let _e4033 = phi_3441_;
                        let _e4035 = phi_3442_;
                        if _e4035 {
                            phi_3446_ = _e4033;
                        } else {
                            phi_3446_ = _e4031;
                        }
                        let _e4037 = phi_3446_;
                        phi_6330_ = _e4037;
                    } else {
                        if (_e468 < 0.0lf) {
                            phi_3457_ = -(_e468);
                        } else {
                            phi_3457_ = _e468;
                        }
                        let _e823 = phi_3457_;
                        if (_e491 < 0.0lf) {
                            phi_3463_ = -(_e491);
                        } else {
                            phi_3463_ = _e491;
                        }
                        let _e827 = phi_3463_;
                        if (_e823 > _e827) {
                            phi_3468_ = _e823;
                        } else {
                            phi_3468_ = _e827;
                        }
                        let _e830 = phi_3468_;
                        if (_e514 < 0.0lf) {
                            phi_3474_ = -(_e514);
                        } else {
                            phi_3474_ = _e514;
                        }
                        let _e834 = phi_3474_;
                        if (_e525 < 0.0lf) {
                            phi_3480_ = -(_e525);
                        } else {
                            phi_3480_ = _e525;
                        }
                        let _e838 = phi_3480_;
                        if (_e834 > _e838) {
                            phi_3485_ = _e834;
                        } else {
                            phi_3485_ = _e838;
                        }
                        let _e841 = phi_3485_;
                        if (_e830 > _e841) {
                            phi_3490_ = _e830;
                        } else {
                            phi_3490_ = _e841;
                        }
                        let _e844 = phi_3490_;
                        let _e846 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e847 = f64(1f);
                        if (_e844 >= _e846) {
                            phi_3500_ = (_e844 <= (_e847 / _e846));
                        } else {
                            phi_3500_ = false;
                        }
                        let _e852 = phi_3500_;
                        if _e852 {
                            phi_3507_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_3507_ = f64(2f);
                        }
                        let _e857 = phi_3507_;
                        let _e859 = ((_e784 * f64(0.34f)) + (_e844 * _e857));
                        if _e852 {
                            phi_3515_ = (_e847 / _e844);
                        } else {
                            phi_3515_ = f64(0f);
                        }
                        let _e863 = phi_3515_;
                        let _e864 = f64(0f);
                        let _e865 = f64(1f);
                        let _e866 = f64(3f);
                        let _e872 = ((_e491 - (_e866 * _e468)) * _e863);
                        let _e873 = ((_e514 - _e491) * _e863);
                        let _e874 = (((_e866 * _e525) - _e514) * _e863);
                        local_6[0u] = _e864;
                        local_6[1u] = _e865;
                        local_6[2u] = _e865;
                        local_6[3u] = _e865;
                        let _e881 = ((_e873 * _e873) - (_e872 * _e874));
                        if (_e881 > _e864) {
                            if (_e881 <= 2.2250738585072014e-308lf) {
                                if (_e881 > 0.0lf) {
                                    phi_3551_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_3551_ = 0.0lf;
                                }
                                let _e934 = phi_3551_;
                                phi_3615_ = _e934;
                            } else {
                                phi_3558_ = type_16(0i, 5i);
                                phi_3561_ = bitcast<f64>(((bitcast<u64>(_e881) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e889 = phi_3558_;
                                    let _e891 = phi_3561_;
                                    local_13 = _e891;
                                    if (_e889.member < _e889.member_1) {
                                        let _e898 = (_e889.member + 1i);
                                        if ((false == (_e898 > _e889.member)) != false) {
                                            phi_3582_ = true;
                                        } else {
                                            phi_3582_ = false;
                                        }
                                        let _e903 = phi_3582_;
                                        if _e903 {
                                            phi_3588_ = type_17(0u, type_17().member_1);
                                        } else {
                                            phi_3588_ = type_17(1u, _e898);
                                        }
                                        let _e908 = phi_3588_;
                                        phi_3559_ = type_16(_e908.member_1, _e889.member_1);
                                        phi_3602_ = type_17(1u, _e889.member);
                                    } else {
                                        phi_3559_ = _e889;
                                        phi_3602_ = type_17(0u, type_17().member_1);
                                    }
                                    let _e914 = phi_3559_;
                                    let _e916 = phi_3602_;
                                    let _e919 = (bitcast<i32>(_e916.member) != 0i);
                                    if _e919 {
                                        phi_3562_ = (0.5lf * (_e891 + (_e881 / _e891)));
                                    } else {
                                        phi_3562_ = f64();
                                    }
                                    let _e924 = phi_3562_;
                                    continue;
                                    continuing {
                                        phi_3558_ = _e914;
                                        phi_3561_ = _e924;
                                        break if !(_e919);
                                    }
                                }
                                let _e929 = local_13;
                                phi_3615_ = (_e929 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e936 = phi_3615_;
                            if (_e873 < _e864) {
                                phi_3621_ = -(_e936);
                            } else {
                                phi_3621_ = _e936;
                            }
                            let _e940 = phi_3621_;
                            let _e942 = -((_e873 + _e940));
                            local_7[0u] = (_e942 / (_e942 + _e874));
                            local_7[1u] = (_e872 / (_e872 + _e942));
                            let _e951 = local_7[1u];
                            let _e952 = local_7[0u];
                            if (_e951 < _e952) {
                                let _e955 = local_7[1u];
                                let _e957 = local_7[0u];
                                local_7[0u] = _e955;
                                local_7[1u] = _e957;
                            }
                            phi_3646_ = type_9(0u, 2u);
                            phi_3649_ = 1u;
                            loop {
                                let _e961 = phi_3646_;
                                let _e963 = phi_3649_;
                                local_43 = _e963;
                                if (_e961.member < _e961.member_1) {
                                    phi_3647_ = type_9((_e961.member + 1u), _e961.member_1);
                                    phi_3672_ = type_9(1u, _e961.member);
                                } else {
                                    phi_3647_ = _e961;
                                    phi_3672_ = type_9(0u, type_9().member_1);
                                }
                                let _e975 = phi_3647_;
                                let _e977 = phi_3672_;
                                let _e981 = (bitcast<i32>(_e977.member) != 0i);
                                if _e981 {
                                    let _e983 = local_7[_e977.member_1];
                                    if (_e983 > _e864) {
                                        let _e986 = local_7[_e977.member_1];
                                        if (_e986 < _e865) {
                                            let _e989 = local_7[_e977.member_1];
                                            local_6[_e963] = _e989;
                                            phi_3716_ = (_e963 + 1u);
                                        } else {
                                            phi_3716_ = _e963;
                                        }
                                        let _e993 = phi_3716_;
                                        phi_3717_ = _e993;
                                    } else {
                                        phi_3717_ = _e963;
                                    }
                                    let _e995 = phi_3717_;
                                    phi_3650_ = _e995;
                                } else {
                                    phi_3650_ = u32();
                                }
                                let _e997 = phi_3650_;
                                continue;
                                continuing {
                                    phi_3646_ = _e975;
                                    phi_3649_ = _e997;
                                    break if !(_e981);
                                }
                            }
                            let _e4217 = local_43;
                            phi_3718_ = _e4217;
                        } else {
                            phi_3718_ = 1u;
                        }
                        let _e1000 = phi_3718_;
                        local_6[_e1000] = _e865;
                        let _e1002 = local_6;
                        local_8 = _e1002;
                        phi_3738_ = type_9(0u, _e1000);
                        loop {
                            let _e1005 = phi_3738_;
                            if (_e1005.member < _e1005.member_1) {
                                phi_3739_ = type_9((_e1005.member + 1u), _e1005.member_1);
                                phi_3762_ = type_9(1u, _e1005.member);
                            } else {
                                phi_3739_ = _e1005;
                                phi_3762_ = type_9(0u, type_9().member_1);
                            }
                            let _e1017 = phi_3739_;
                            let _e1019 = phi_3762_;
                            if (bitcast<i32>(_e1019.member) != 0i) {
                                let _e1025 = local_8[_e1019.member_1];
                                let _e1028 = local_8[(_e1019.member_1 + 1u)];
                                let _e1030 = (f64(1f) - _e1025);
                                let _e1041 = ((((_e468 * _e1030) + (_e491 * _e1025)) * (_e1030 * _e1030)) + (((_e514 * _e1030) + (_e525 * _e1025)) * (_e1025 * _e1025)));
                                let _e1043 = (f64(1f) - _e1028);
                                let _e1054 = ((((_e468 * _e1043) + (_e491 * _e1028)) * (_e1043 * _e1043)) + (((_e514 * _e1043) + (_e525 * _e1028)) * (_e1028 * _e1028)));
                                if (_e1041 < 0.0lf) {
                                    phi_3816_ = -(_e1041);
                                } else {
                                    phi_3816_ = _e1041;
                                }
                                let _e1058 = phi_3816_;
                                let _e1059 = (_e1058 > _e859);
                                if (_e1054 < 0.0lf) {
                                    phi_3823_ = -(_e1054);
                                } else {
                                    phi_3823_ = _e1054;
                                }
                                let _e1063 = phi_3823_;
                                let _e1064 = (_e1063 > _e859);
                                let _e1065 = f64(0f);
                                if _e1059 {
                                    if _e1064 {
                                        phi_3835_ = ((_e1041 > _e1065) != (_e1054 > _e1065));
                                        phi_3836_ = false;
                                    } else {
                                        phi_3835_ = bool();
                                        phi_3836_ = true;
                                    }
                                    let _e1070 = phi_3835_;
                                    let _e1072 = phi_3836_;
                                    phi_3837_ = _e1070;
                                    phi_3838_ = _e1072;
                                } else {
                                    phi_3837_ = bool();
                                    phi_3838_ = true;
                                }
                                let _e1074 = phi_3837_;
                                let _e1076 = phi_3838_;
                                if _e1076 {
                                    phi_3842_ = false;
                                } else {
                                    phi_3842_ = _e1074;
                                }
                                let _e1078 = phi_3842_;
                                if _e1059 {
                                    if _e1064 {
                                        if _e1078 {
                                            phi_3854_ = type_43();
                                        } else {
                                            phi_3854_ = type_43(f64(1f), _e1065, _e1078);
                                        }
                                        let _e1082 = phi_3854_;
                                        phi_3855_ = _e1082;
                                        phi_3856_ = _e1078;
                                    } else {
                                        phi_3855_ = type_43();
                                        phi_3856_ = true;
                                    }
                                    let _e1084 = phi_3855_;
                                    let _e1086 = phi_3856_;
                                    phi_3857_ = _e1084;
                                    phi_3858_ = _e1086;
                                } else {
                                    phi_3857_ = type_43();
                                    phi_3858_ = true;
                                }
                                let _e1088 = phi_3857_;
                                let _e1090 = phi_3858_;
                                if _e1090 {
                                    if _e1059 {
                                        if (_e1041 < _e1065) {
                                            phi_3871_ = f64(-1f);
                                        } else {
                                            phi_3871_ = f64(1f);
                                        }
                                        let _e1095 = phi_3871_;
                                        let _e1096 = f64(0.00000000000022737368f);
                                        let _e1097 = f64(0.5f);
                                        let _e1098 = f64(3f);
                                        let _e1101 = (_e514 - _e491);
                                        phi_3884_ = type_9(0u, 64u);
                                        phi_3887_ = _e1028;
                                        phi_3889_ = _e1025;
                                        phi_3891_ = (_e1097 * (_e1025 + _e1028));
                                        loop {
                                            let _e1107 = phi_3884_;
                                            let _e1109 = phi_3887_;
                                            let _e1111 = phi_3889_;
                                            let _e1113 = phi_3891_;
                                            local_45 = _e1111;
                                            if (_e1107.member < _e1107.member_1) {
                                                phi_3885_ = type_9((_e1107.member + 1u), _e1107.member_1);
                                                phi_3914_ = type_9(1u, _e1107.member);
                                            } else {
                                                phi_3885_ = _e1107;
                                                phi_3914_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1125 = phi_3885_;
                                            let _e1127 = phi_3914_;
                                            if (bitcast<i32>(_e1127.member) != 0i) {
                                                let _e1132 = (f64(1f) - _e1113);
                                                let _e1145 = ((_e1095 * ((((_e468 * _e1132) + (_e491 * _e1113)) * (_e1132 * _e1132)) + (((_e514 * _e1132) + (_e525 * _e1113)) * (_e1113 * _e1113)))) - _e859);
                                                if (_e1145 > f64(0f)) {
                                                    phi_3941_ = _e1109;
                                                    phi_3942_ = _e1113;
                                                } else {
                                                    phi_3941_ = _e1113;
                                                    phi_3942_ = _e1111;
                                                }
                                                let _e1149 = phi_3941_;
                                                let _e1151 = phi_3942_;
                                                let _e1153 = ((_e1149 - _e1151) > _e1096);
                                                if _e1153 {
                                                    let _e1155 = (f64(1f) - _e1113);
                                                    let _e1167 = (-(_e1145) / (_e1095 * (((((_e491 - (_e1098 * _e468)) * _e1155) + (_e1101 * _e1113)) * _e1155) + (((_e1101 * _e1155) + (((_e1098 * _e525) - _e514) * _e1113)) * _e1113))));
                                                    if (_e1145 > f64(0f)) {
                                                        phi_3970_ = (_e1097 * _e1096);
                                                    } else {
                                                        phi_3970_ = -((_e1097 * _e1096));
                                                    }
                                                    let _e1174 = phi_3970_;
                                                    let _e1176 = ((_e1113 + _e1167) + _e1174);
                                                    if (_e1176 > _e1151) {
                                                        if (_e1176 < _e1149) {
                                                            if (_e1167 < 0.0lf) {
                                                                phi_3986_ = -(_e1167);
                                                            } else {
                                                                phi_3986_ = _e1167;
                                                            }
                                                            let _e1182 = phi_3986_;
                                                            if (_e1182 < (_e1097 * (_e1149 - _e1151))) {
                                                                phi_3993_ = false;
                                                            } else {
                                                                phi_3993_ = true;
                                                            }
                                                            let _e1187 = phi_3993_;
                                                            phi_3994_ = _e1187;
                                                        } else {
                                                            phi_3994_ = true;
                                                        }
                                                        let _e1189 = phi_3994_;
                                                        phi_3995_ = _e1189;
                                                    } else {
                                                        phi_3995_ = true;
                                                    }
                                                    let _e1191 = phi_3995_;
                                                    if _e1191 {
                                                        phi_4001_ = (_e1097 * (_e1151 + _e1149));
                                                    } else {
                                                        phi_4001_ = _e1176;
                                                    }
                                                    let _e1195 = phi_4001_;
                                                    phi_4002_ = _e1195;
                                                    phi_4003_ = false;
                                                } else {
                                                    phi_4002_ = f64();
                                                    phi_4003_ = true;
                                                }
                                                let _e1197 = phi_4002_;
                                                let _e1199 = phi_4003_;
                                                phi_3888_ = _e1149;
                                                phi_3890_ = _e1151;
                                                phi_3892_ = _e1197;
                                                phi_4004_ = _e1151;
                                                phi_4005_ = _e1153;
                                                phi_4006_ = _e1199;
                                            } else {
                                                phi_3888_ = f64();
                                                phi_3890_ = f64();
                                                phi_3892_ = f64();
                                                phi_4004_ = f64();
                                                phi_4005_ = false;
                                                phi_4006_ = false;
                                            }
                                            let _e1201 = phi_3888_;
                                            let _e1203 = phi_3890_;
                                            let _e1205 = phi_3892_;
                                            let _e1207 = phi_4004_;
                                            let _e1209 = phi_4005_;
                                            let _e1211 = phi_4006_;
                                            local_14 = _e1211;
                                            local_44 = _e1207;
                                            continue;
                                            continuing {
                                                phi_3884_ = _e1125;
                                                phi_3887_ = _e1201;
                                                phi_3889_ = _e1203;
                                                phi_3891_ = _e1205;
                                                break if !(_e1209);
                                            }
                                        }
                                        let _e1214 = local_14;
                                        if _e1214 {
                                            let _e4259 = local_44;
                                            phi_4010_ = _e4259;
                                        } else {
                                            let _e4261 = local_45;
                                            phi_4010_ = _e4261;
                                        }
                                        let _e1216 = phi_4010_;
                                        phi_4011_ = _e1216;
                                    } else {
                                        phi_4011_ = _e1025;
                                    }
                                    let _e1218 = phi_4011_;
                                    if _e1064 {
                                        phi_4019_ = type_9(0u, 64u);
                                        phi_4022_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1222 = phi_4019_;
                                            let _e1224 = phi_4022_;
                                            if (_e1222.member < _e1222.member_1) {
                                                phi_4020_ = type_9((_e1222.member + 1u), _e1222.member_1);
                                                phi_4045_ = type_9(1u, _e1222.member);
                                            } else {
                                                phi_4020_ = _e1222;
                                                phi_4045_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1236 = phi_4020_;
                                            let _e1238 = phi_4045_;
                                            if (bitcast<i32>(_e1238.member) != 0i) {
                                                let _e1242 = (_e1218 + _e1224);
                                                if (_e1242 < _e1028) {
                                                    let _e1245 = (f64(1f) - _e1242);
                                                    let _e1256 = ((((_e468 * _e1245) + (_e491 * _e1242)) * (_e1245 * _e1245)) + (((_e514 * _e1245) + (_e525 * _e1242)) * (_e1242 * _e1242)));
                                                    let _e1258 = (f64(1f) - _e1218);
                                                    let _e1269 = ((((_e468 * _e1258) + (_e491 * _e1218)) * (_e1258 * _e1258)) + (((_e514 * _e1258) + (_e525 * _e1218)) * (_e1218 * _e1218)));
                                                    if (_e1256 < 0.0lf) {
                                                        phi_4088_ = -(_e1256);
                                                    } else {
                                                        phi_4088_ = _e1256;
                                                    }
                                                    let _e1273 = phi_4088_;
                                                    if (_e1273 > _e859) {
                                                        if (_e1269 < 0.0lf) {
                                                            phi_4098_ = -(_e1269);
                                                        } else {
                                                            phi_4098_ = _e1269;
                                                        }
                                                        let _e1278 = phi_4098_;
                                                        if (_e1278 > _e859) {
                                                            phi_4108_ = ((_e1256 > f64(0f)) == (_e1269 > f64(0f)));
                                                        } else {
                                                            phi_4108_ = false;
                                                        }
                                                        let _e1286 = phi_4108_;
                                                        phi_4110_ = !(_e1286);
                                                    } else {
                                                        phi_4110_ = false;
                                                    }
                                                    let _e1289 = phi_4110_;
                                                    if _e1289 {
                                                        phi_4115_ = f64();
                                                        phi_4116_ = false;
                                                    } else {
                                                        phi_4115_ = (_e1224 + _e1224);
                                                        phi_4116_ = true;
                                                    }
                                                    let _e1292 = phi_4115_;
                                                    let _e1294 = phi_4116_;
                                                    phi_4117_ = _e1292;
                                                    phi_4118_ = _e1294;
                                                    phi_4119_ = _e1289;
                                                    phi_4120_ = false;
                                                } else {
                                                    phi_4117_ = f64();
                                                    phi_4118_ = false;
                                                    phi_4119_ = false;
                                                    phi_4120_ = true;
                                                }
                                                let _e1296 = phi_4117_;
                                                let _e1298 = phi_4118_;
                                                let _e1300 = phi_4119_;
                                                let _e1302 = phi_4120_;
                                                phi_4121_ = _e1242;
                                                phi_4023_ = _e1296;
                                                phi_4122_ = _e1298;
                                                phi_4123_ = _e1300;
                                                phi_4124_ = _e1302;
                                                phi_4125_ = false;
                                            } else {
                                                phi_4121_ = f64();
                                                phi_4023_ = f64();
                                                phi_4122_ = false;
                                                phi_4123_ = false;
                                                phi_4124_ = false;
                                                phi_4125_ = true;
                                            }
                                            let _e1304 = phi_4121_;
                                            let _e1306 = phi_4023_;
                                            let _e1308 = phi_4122_;
                                            let _e1310 = phi_4123_;
                                            let _e1312 = phi_4124_;
                                            let _e1314 = phi_4125_;
                                            local_15 = _e1310;
                                            local_46 = _e1312;
                                            local_47 = _e1314;
                                            local_48 = _e1304;
                                            continue;
                                            continuing {
                                                phi_4019_ = _e1236;
                                                phi_4022_ = _e1306;
                                                break if !(_e1308);
                                            }
                                        }
                                        let _e1317 = local_15;
                                        if _e1317 {
                                            phi_4129_ = false;
                                            phi_4130_ = false;
                                        } else {
                                            let _e4286 = local_46;
                                            phi_4129_ = _e4286;
                                            let _e4289 = local_47;
                                            phi_4130_ = _e4289;
                                        }
                                        let _e1319 = phi_4129_;
                                        let _e1321 = phi_4130_;
                                        if _e1319 {
                                            phi_4134_ = true;
                                        } else {
                                            phi_4134_ = _e1321;
                                        }
                                        let _e1323 = phi_4134_;
                                        if _e1323 {
                                            phi_4138_ = _e1028;
                                        } else {
                                            let _e4293 = local_48;
                                            phi_4138_ = _e4293;
                                        }
                                        let _e1325 = phi_4138_;
                                        phi_4139_ = _e1325;
                                    } else {
                                        phi_4139_ = _e1028;
                                    }
                                    let _e1327 = phi_4139_;
                                    phi_4141_ = type_43(_e1218, _e1327, _e1078);
                                } else {
                                    phi_4141_ = _e1088;
                                }
                                let _e1330 = phi_4141_;
                                if (_e1330.member > _e1330.member_1) {
                                    phi_6286_ = f64();
                                    phi_6287_ = true;
                                    phi_6288_ = false;
                                    phi_6289_ = false;
                                    phi_6290_ = false;
                                } else {
                                    let _e1338 = ((_e1330.member_1 - _e1330.member) * f64(0.5f));
                                    let _e1339 = (_e1330.member + _e1338);
                                    let _e1342 = (_e1338 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1344 = local_12.member_3;
                                    let _e1347 = local_12.member[0u];
                                    if (_e1347[0] < 0.0lf) {
                                        phi_4172_ = -(_e1347[0]);
                                    } else {
                                        phi_4172_ = _e1347[0];
                                    }
                                    let _e1354 = phi_4172_;
                                    if (_e1347[1] < 0.0lf) {
                                        phi_4179_ = -(_e1347[1]);
                                    } else {
                                        phi_4179_ = _e1347[1];
                                    }
                                    let _e1358 = phi_4179_;
                                    if (_e1354 > _e1358) {
                                        phi_4184_ = _e1354;
                                    } else {
                                        phi_4184_ = _e1358;
                                    }
                                    let _e1361 = phi_4184_;
                                    if (_e1347[2] < 0.0lf) {
                                        phi_4191_ = -(_e1347[2]);
                                    } else {
                                        phi_4191_ = _e1347[2];
                                    }
                                    let _e1365 = phi_4191_;
                                    if (_e1361 > _e1365) {
                                        phi_4196_ = _e1361;
                                    } else {
                                        phi_4196_ = _e1365;
                                    }
                                    let _e1368 = phi_4196_;
                                    let _e1370 = local_12.member[1u];
                                    if (_e1370[0] < 0.0lf) {
                                        phi_4209_ = -(_e1370[0]);
                                    } else {
                                        phi_4209_ = _e1370[0];
                                    }
                                    let _e1377 = phi_4209_;
                                    if (_e1370[1] < 0.0lf) {
                                        phi_4216_ = -(_e1370[1]);
                                    } else {
                                        phi_4216_ = _e1370[1];
                                    }
                                    let _e1381 = phi_4216_;
                                    if (_e1377 > _e1381) {
                                        phi_4221_ = _e1377;
                                    } else {
                                        phi_4221_ = _e1381;
                                    }
                                    let _e1384 = phi_4221_;
                                    if (_e1370[2] < 0.0lf) {
                                        phi_4228_ = -(_e1370[2]);
                                    } else {
                                        phi_4228_ = _e1370[2];
                                    }
                                    let _e1388 = phi_4228_;
                                    if (_e1384 > _e1388) {
                                        phi_4233_ = _e1384;
                                    } else {
                                        phi_4233_ = _e1388;
                                    }
                                    let _e1391 = phi_4233_;
                                    if (_e1368 > _e1391) {
                                        phi_4238_ = _e1368;
                                    } else {
                                        phi_4238_ = _e1391;
                                    }
                                    let _e1394 = phi_4238_;
                                    let _e1397 = local_12.member[0u];
                                    let _e1402 = local_12.member[1u];
                                    let _e1412 = (_e1397[0] + ((_e1402[0] - _e1397[0]) * _e1339));
                                    let _e1413 = (_e1397[1] + ((_e1402[1] - _e1397[1]) * _e1339));
                                    let _e1414 = (_e1397[2] + ((_e1402[2] - _e1397[2]) * _e1339));
                                    let _e1416 = local_12.member[1u];
                                    let _e1421 = local_12.member[0u];
                                    let _e1425 = (_e1416[0] - _e1421[0]);
                                    let _e1426 = (_e1416[1] - _e1421[1]);
                                    let _e1427 = (_e1416[2] - _e1421[2]);
                                    if (_e1425 < 0.0lf) {
                                        phi_4297_ = -(_e1425);
                                    } else {
                                        phi_4297_ = _e1425;
                                    }
                                    let _e1431 = phi_4297_;
                                    if (_e1426 < 0.0lf) {
                                        phi_4303_ = -(_e1426);
                                    } else {
                                        phi_4303_ = _e1426;
                                    }
                                    let _e1435 = phi_4303_;
                                    if (_e1431 > _e1435) {
                                        phi_4308_ = _e1431;
                                    } else {
                                        phi_4308_ = _e1435;
                                    }
                                    let _e1438 = phi_4308_;
                                    if (_e1427 < 0.0lf) {
                                        phi_4314_ = -(_e1427);
                                    } else {
                                        phi_4314_ = _e1427;
                                    }
                                    let _e1442 = phi_4314_;
                                    if (_e1438 > _e1442) {
                                        phi_4319_ = _e1438;
                                    } else {
                                        phi_4319_ = _e1442;
                                    }
                                    let _e1445 = phi_4319_;
                                    let _e1453 = ((((_e1342 * _e1445) * f64(1.01f)) + ((_e1394 + _e1344) * (1.1102230246251565e-16lf * f64(8f)))) + _e1344);
                                    if (_e1412 < 0.0lf) {
                                        phi_4333_ = -(_e1412);
                                    } else {
                                        phi_4333_ = _e1412;
                                    }
                                    let _e1457 = phi_4333_;
                                    if (_e1413 < 0.0lf) {
                                        phi_4339_ = -(_e1413);
                                    } else {
                                        phi_4339_ = _e1413;
                                    }
                                    let _e1461 = phi_4339_;
                                    if (_e1457 > _e1461) {
                                        phi_4344_ = _e1457;
                                    } else {
                                        phi_4344_ = _e1461;
                                    }
                                    let _e1464 = phi_4344_;
                                    if (_e1414 < 0.0lf) {
                                        phi_4350_ = -(_e1414);
                                    } else {
                                        phi_4350_ = _e1414;
                                    }
                                    let _e1468 = phi_4350_;
                                    if (_e1464 > _e1468) {
                                        phi_4355_ = _e1464;
                                    } else {
                                        phi_4355_ = _e1468;
                                    }
                                    let _e1471 = phi_4355_;
                                    local_2 = type_34(array<f64, 3>(_e1412, _e1413, _e1414), _e1453, (_e1471 + _e1453));
                                    let _e1477 = local_12.member_3;
                                    let _e1479 = local_12.member_1[0u];
                                    if (_e1479[0] < 0.0lf) {
                                        phi_4381_ = -(_e1479[0]);
                                    } else {
                                        phi_4381_ = _e1479[0];
                                    }
                                    let _e1486 = phi_4381_;
                                    if (_e1479[1] < 0.0lf) {
                                        phi_4388_ = -(_e1479[1]);
                                    } else {
                                        phi_4388_ = _e1479[1];
                                    }
                                    let _e1490 = phi_4388_;
                                    if (_e1486 > _e1490) {
                                        phi_4393_ = _e1486;
                                    } else {
                                        phi_4393_ = _e1490;
                                    }
                                    let _e1493 = phi_4393_;
                                    if (_e1479[2] < 0.0lf) {
                                        phi_4400_ = -(_e1479[2]);
                                    } else {
                                        phi_4400_ = _e1479[2];
                                    }
                                    let _e1497 = phi_4400_;
                                    if (_e1493 > _e1497) {
                                        phi_4405_ = _e1493;
                                    } else {
                                        phi_4405_ = _e1497;
                                    }
                                    let _e1500 = phi_4405_;
                                    let _e1502 = local_12.member_1[1u];
                                    if (_e1502[0] < 0.0lf) {
                                        phi_4418_ = -(_e1502[0]);
                                    } else {
                                        phi_4418_ = _e1502[0];
                                    }
                                    let _e1509 = phi_4418_;
                                    if (_e1502[1] < 0.0lf) {
                                        phi_4425_ = -(_e1502[1]);
                                    } else {
                                        phi_4425_ = _e1502[1];
                                    }
                                    let _e1513 = phi_4425_;
                                    if (_e1509 > _e1513) {
                                        phi_4430_ = _e1509;
                                    } else {
                                        phi_4430_ = _e1513;
                                    }
                                    let _e1516 = phi_4430_;
                                    if (_e1502[2] < 0.0lf) {
                                        phi_4437_ = -(_e1502[2]);
                                    } else {
                                        phi_4437_ = _e1502[2];
                                    }
                                    let _e1520 = phi_4437_;
                                    if (_e1516 > _e1520) {
                                        phi_4442_ = _e1516;
                                    } else {
                                        phi_4442_ = _e1520;
                                    }
                                    let _e1523 = phi_4442_;
                                    if (_e1500 > _e1523) {
                                        phi_4447_ = _e1500;
                                    } else {
                                        phi_4447_ = _e1523;
                                    }
                                    let _e1526 = phi_4447_;
                                    let _e1529 = local_12.member_1[0u];
                                    let _e1534 = local_12.member_1[1u];
                                    let _e1544 = (_e1529[0] + ((_e1534[0] - _e1529[0]) * _e1339));
                                    let _e1545 = (_e1529[1] + ((_e1534[1] - _e1529[1]) * _e1339));
                                    let _e1546 = (_e1529[2] + ((_e1534[2] - _e1529[2]) * _e1339));
                                    let _e1548 = local_12.member_1[1u];
                                    let _e1553 = local_12.member_1[0u];
                                    let _e1557 = (_e1548[0] - _e1553[0]);
                                    let _e1558 = (_e1548[1] - _e1553[1]);
                                    let _e1559 = (_e1548[2] - _e1553[2]);
                                    if (_e1557 < 0.0lf) {
                                        phi_4506_ = -(_e1557);
                                    } else {
                                        phi_4506_ = _e1557;
                                    }
                                    let _e1563 = phi_4506_;
                                    if (_e1558 < 0.0lf) {
                                        phi_4512_ = -(_e1558);
                                    } else {
                                        phi_4512_ = _e1558;
                                    }
                                    let _e1567 = phi_4512_;
                                    if (_e1563 > _e1567) {
                                        phi_4517_ = _e1563;
                                    } else {
                                        phi_4517_ = _e1567;
                                    }
                                    let _e1570 = phi_4517_;
                                    if (_e1559 < 0.0lf) {
                                        phi_4523_ = -(_e1559);
                                    } else {
                                        phi_4523_ = _e1559;
                                    }
                                    let _e1574 = phi_4523_;
                                    if (_e1570 > _e1574) {
                                        phi_4528_ = _e1570;
                                    } else {
                                        phi_4528_ = _e1574;
                                    }
                                    let _e1577 = phi_4528_;
                                    let _e1585 = ((((_e1342 * _e1577) * f64(1.01f)) + ((_e1526 + _e1477) * (1.1102230246251565e-16lf * f64(8f)))) + _e1477);
                                    if (_e1544 < 0.0lf) {
                                        phi_4542_ = -(_e1544);
                                    } else {
                                        phi_4542_ = _e1544;
                                    }
                                    let _e1589 = phi_4542_;
                                    if (_e1545 < 0.0lf) {
                                        phi_4548_ = -(_e1545);
                                    } else {
                                        phi_4548_ = _e1545;
                                    }
                                    let _e1593 = phi_4548_;
                                    if (_e1589 > _e1593) {
                                        phi_4553_ = _e1589;
                                    } else {
                                        phi_4553_ = _e1593;
                                    }
                                    let _e1596 = phi_4553_;
                                    if (_e1546 < 0.0lf) {
                                        phi_4559_ = -(_e1546);
                                    } else {
                                        phi_4559_ = _e1546;
                                    }
                                    let _e1600 = phi_4559_;
                                    if (_e1596 > _e1600) {
                                        phi_4564_ = _e1596;
                                    } else {
                                        phi_4564_ = _e1600;
                                    }
                                    let _e1603 = phi_4564_;
                                    local_3 = type_34(array<f64, 3>(_e1544, _e1545, _e1546), _e1585, (_e1603 + _e1585));
                                    let _e1609 = local_12.member_3;
                                    let _e1611 = local_12.member_2[0u];
                                    if (_e1611[0] < 0.0lf) {
                                        phi_4590_ = -(_e1611[0]);
                                    } else {
                                        phi_4590_ = _e1611[0];
                                    }
                                    let _e1618 = phi_4590_;
                                    if (_e1611[1] < 0.0lf) {
                                        phi_4597_ = -(_e1611[1]);
                                    } else {
                                        phi_4597_ = _e1611[1];
                                    }
                                    let _e1622 = phi_4597_;
                                    if (_e1618 > _e1622) {
                                        phi_4602_ = _e1618;
                                    } else {
                                        phi_4602_ = _e1622;
                                    }
                                    let _e1625 = phi_4602_;
                                    if (_e1611[2] < 0.0lf) {
                                        phi_4609_ = -(_e1611[2]);
                                    } else {
                                        phi_4609_ = _e1611[2];
                                    }
                                    let _e1629 = phi_4609_;
                                    if (_e1625 > _e1629) {
                                        phi_4614_ = _e1625;
                                    } else {
                                        phi_4614_ = _e1629;
                                    }
                                    let _e1632 = phi_4614_;
                                    let _e1634 = local_12.member_2[1u];
                                    if (_e1634[0] < 0.0lf) {
                                        phi_4627_ = -(_e1634[0]);
                                    } else {
                                        phi_4627_ = _e1634[0];
                                    }
                                    let _e1641 = phi_4627_;
                                    if (_e1634[1] < 0.0lf) {
                                        phi_4634_ = -(_e1634[1]);
                                    } else {
                                        phi_4634_ = _e1634[1];
                                    }
                                    let _e1645 = phi_4634_;
                                    if (_e1641 > _e1645) {
                                        phi_4639_ = _e1641;
                                    } else {
                                        phi_4639_ = _e1645;
                                    }
                                    let _e1648 = phi_4639_;
                                    if (_e1634[2] < 0.0lf) {
                                        phi_4646_ = -(_e1634[2]);
                                    } else {
                                        phi_4646_ = _e1634[2];
                                    }
                                    let _e1652 = phi_4646_;
                                    if (_e1648 > _e1652) {
                                        phi_4651_ = _e1648;
                                    } else {
                                        phi_4651_ = _e1652;
                                    }
                                    let _e1655 = phi_4651_;
                                    if (_e1632 > _e1655) {
                                        phi_4656_ = _e1632;
                                    } else {
                                        phi_4656_ = _e1655;
                                    }
                                    let _e1658 = phi_4656_;
                                    let _e1661 = local_12.member_2[0u];
                                    let _e1666 = local_12.member_2[1u];
                                    let _e1676 = (_e1661[0] + ((_e1666[0] - _e1661[0]) * _e1339));
                                    let _e1677 = (_e1661[1] + ((_e1666[1] - _e1661[1]) * _e1339));
                                    let _e1678 = (_e1661[2] + ((_e1666[2] - _e1661[2]) * _e1339));
                                    let _e1680 = local_12.member_2[1u];
                                    let _e1685 = local_12.member_2[0u];
                                    let _e1689 = (_e1680[0] - _e1685[0]);
                                    let _e1690 = (_e1680[1] - _e1685[1]);
                                    let _e1691 = (_e1680[2] - _e1685[2]);
                                    if (_e1689 < 0.0lf) {
                                        phi_4715_ = -(_e1689);
                                    } else {
                                        phi_4715_ = _e1689;
                                    }
                                    let _e1695 = phi_4715_;
                                    if (_e1690 < 0.0lf) {
                                        phi_4721_ = -(_e1690);
                                    } else {
                                        phi_4721_ = _e1690;
                                    }
                                    let _e1699 = phi_4721_;
                                    if (_e1695 > _e1699) {
                                        phi_4726_ = _e1695;
                                    } else {
                                        phi_4726_ = _e1699;
                                    }
                                    let _e1702 = phi_4726_;
                                    if (_e1691 < 0.0lf) {
                                        phi_4732_ = -(_e1691);
                                    } else {
                                        phi_4732_ = _e1691;
                                    }
                                    let _e1706 = phi_4732_;
                                    if (_e1702 > _e1706) {
                                        phi_4737_ = _e1702;
                                    } else {
                                        phi_4737_ = _e1706;
                                    }
                                    let _e1709 = phi_4737_;
                                    let _e1717 = ((((_e1342 * _e1709) * f64(1.01f)) + ((_e1658 + _e1609) * (1.1102230246251565e-16lf * f64(8f)))) + _e1609);
                                    if (_e1676 < 0.0lf) {
                                        phi_4751_ = -(_e1676);
                                    } else {
                                        phi_4751_ = _e1676;
                                    }
                                    let _e1721 = phi_4751_;
                                    if (_e1677 < 0.0lf) {
                                        phi_4757_ = -(_e1677);
                                    } else {
                                        phi_4757_ = _e1677;
                                    }
                                    let _e1725 = phi_4757_;
                                    if (_e1721 > _e1725) {
                                        phi_4762_ = _e1721;
                                    } else {
                                        phi_4762_ = _e1725;
                                    }
                                    let _e1728 = phi_4762_;
                                    if (_e1678 < 0.0lf) {
                                        phi_4768_ = -(_e1678);
                                    } else {
                                        phi_4768_ = _e1678;
                                    }
                                    let _e1732 = phi_4768_;
                                    if (_e1728 > _e1732) {
                                        phi_4773_ = _e1728;
                                    } else {
                                        phi_4773_ = _e1732;
                                    }
                                    let _e1735 = phi_4773_;
                                    local_4 = type_34(array<f64, 3>(_e1676, _e1677, _e1678), _e1717, (_e1735 + _e1717));
                                    let _e1740 = local_3.member;
                                    let _e1745 = local_4.member;
                                    let _e1751 = ((_e1740[1] * _e1745[2]) - (_e1740[2] * _e1745[1]));
                                    let _e1754 = ((_e1740[2] * _e1745[0]) - (_e1740[0] * _e1745[2]));
                                    let _e1757 = ((_e1740[0] * _e1745[1]) - (_e1740[1] * _e1745[0]));
                                    if (_e1751 < 0.0lf) {
                                        phi_4822_ = -(_e1751);
                                    } else {
                                        phi_4822_ = _e1751;
                                    }
                                    let _e1761 = phi_4822_;
                                    if (_e1754 < 0.0lf) {
                                        phi_4828_ = -(_e1754);
                                    } else {
                                        phi_4828_ = _e1754;
                                    }
                                    let _e1765 = phi_4828_;
                                    if (_e1761 > _e1765) {
                                        if (_e1751 < 0.0lf) {
                                            phi_4838_ = -(_e1751);
                                        } else {
                                            phi_4838_ = _e1751;
                                        }
                                        let _e1783 = phi_4838_;
                                        if (_e1757 < 0.0lf) {
                                            phi_4844_ = -(_e1757);
                                        } else {
                                            phi_4844_ = _e1757;
                                        }
                                        let _e1787 = phi_4844_;
                                        if (_e1783 > _e1787) {
                                            phi_4849_ = 2u;
                                            phi_4850_ = 1u;
                                        } else {
                                            phi_4849_ = 1u;
                                            phi_4850_ = 0u;
                                        }
                                        let _e1790 = phi_4849_;
                                        let _e1792 = phi_4850_;
                                        phi_4869_ = _e1790;
                                        phi_4870_ = _e1792;
                                    } else {
                                        if (_e1754 < 0.0lf) {
                                            phi_4856_ = -(_e1754);
                                        } else {
                                            phi_4856_ = _e1754;
                                        }
                                        let _e1770 = phi_4856_;
                                        if (_e1757 < 0.0lf) {
                                            phi_4862_ = -(_e1757);
                                        } else {
                                            phi_4862_ = _e1757;
                                        }
                                        let _e1774 = phi_4862_;
                                        if (_e1770 > _e1774) {
                                            phi_4867_ = 0u;
                                            phi_4868_ = 2u;
                                        } else {
                                            phi_4867_ = 1u;
                                            phi_4868_ = 0u;
                                        }
                                        let _e1777 = phi_4867_;
                                        let _e1779 = phi_4868_;
                                        phi_4869_ = _e1777;
                                        phi_4870_ = _e1779;
                                    }
                                    let _e1794 = phi_4869_;
                                    let _e1796 = phi_4870_;
                                    let _e1799 = local_3.member[_e1796];
                                    let _e1802 = local_4.member[_e1794];
                                    let _e1806 = local_3.member[_e1794];
                                    let _e1809 = local_4.member[_e1796];
                                    let _e1811 = ((_e1799 * _e1802) - (_e1806 * _e1809));
                                    let _e1812 = f64(1f);
                                    let _e1814 = local_3.member_1;
                                    let _e1816 = local_4.member_2;
                                    let _e1819 = local_3.member_2;
                                    let _e1821 = local_4.member_1;
                                    let _e1827 = local_3.member_2;
                                    let _e1829 = local_4.member_2;
                                    let _e1838 = local_3.member_2;
                                    let _e1841 = local_4.member_2;
                                    let _e1845 = (((((_e1814 * _e1816) + (_e1819 * _e1821)) * f64(2.01f)) + ((_e1827 * _e1829) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1812 + _e1838) * (_e1812 + _e1841))));
                                    if (_e1811 < 0.0lf) {
                                        phi_4941_ = -(_e1811);
                                    } else {
                                        phi_4941_ = _e1811;
                                    }
                                    let _e1849 = phi_4941_;
                                    if (_e1849 > _e1845) {
                                        if (_e1811 < f64(0f)) {
                                            phi_4953_ = f64(-1f);
                                        } else {
                                            phi_4953_ = f64(1f);
                                        }
                                        let _e1856 = phi_4953_;
                                        let _e1859 = local_2.member[_e1796];
                                        let _e1862 = local_4.member[_e1794];
                                        let _e1866 = local_2.member[_e1794];
                                        let _e1869 = local_4.member[_e1796];
                                        let _e1872 = f64(1f);
                                        let _e1874 = local_2.member_1;
                                        let _e1876 = local_4.member_2;
                                        let _e1879 = local_2.member_2;
                                        let _e1881 = local_4.member_1;
                                        let _e1887 = local_2.member_2;
                                        let _e1889 = local_4.member_2;
                                        let _e1898 = local_2.member_2;
                                        let _e1901 = local_4.member_2;
                                        let _e1905 = (((((_e1874 * _e1876) + (_e1879 * _e1881)) * f64(2.01f)) + ((_e1887 * _e1889) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1872 + _e1898) * (_e1872 + _e1901))));
                                        let _e1908 = local_3.member[_e1796];
                                        let _e1911 = local_2.member[_e1794];
                                        let _e1915 = local_3.member[_e1794];
                                        let _e1918 = local_2.member[_e1796];
                                        let _e1921 = f64(1f);
                                        let _e1923 = local_3.member_1;
                                        let _e1925 = local_2.member_2;
                                        let _e1928 = local_3.member_2;
                                        let _e1930 = local_2.member_1;
                                        let _e1936 = local_3.member_2;
                                        let _e1938 = local_2.member_2;
                                        let _e1947 = local_3.member_2;
                                        let _e1950 = local_2.member_2;
                                        let _e1954 = (((((_e1923 * _e1925) + (_e1928 * _e1930)) * f64(2.01f)) + ((_e1936 * _e1938) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1921 + _e1947) * (_e1921 + _e1950))));
                                        let _e1955 = (_e1811 * _e1856);
                                        let _e1956 = (((_e1859 * _e1862) - (_e1866 * _e1869)) * _e1856);
                                        let _e1957 = (((_e1908 * _e1911) - (_e1915 * _e1918)) * _e1856);
                                        if (_e1955 < 0.0lf) {
                                            phi_5092_ = -(_e1955);
                                        } else {
                                            phi_5092_ = _e1955;
                                        }
                                        let _e1961 = phi_5092_;
                                        if (_e1956 < 0.0lf) {
                                            phi_5098_ = -(_e1956);
                                        } else {
                                            phi_5098_ = _e1956;
                                        }
                                        let _e1965 = phi_5098_;
                                        if (_e1957 < 0.0lf) {
                                            phi_5105_ = -(_e1957);
                                        } else {
                                            phi_5105_ = _e1957;
                                        }
                                        let _e1970 = phi_5105_;
                                        let _e1976 = ((_e1955 - _e1956) - _e1957);
                                        let _e1979 = (((_e1845 + _e1905) + _e1954) + (((_e1961 + _e1965) + _e1970) * (1.1102230246251565e-16lf * f64(4f))));
                                        local_5[0u].member = _e1956;
                                        local_5[0u].member_1 = _e1905;
                                        local_5[1u].member = _e1957;
                                        local_5[1u].member_1 = _e1954;
                                        local_5[2u].member = _e1976;
                                        local_5[2u].member_1 = _e1979;
                                        local_5[3u].member = _e1976;
                                        local_5[3u].member_1 = _e1979;
                                        phi_5149_ = type_9(0u, 4u);
                                        phi_5152_ = true;
                                        loop {
                                            let _e1994 = phi_5149_;
                                            let _e1996 = phi_5152_;
                                            local_17 = _e1996;
                                            if (_e1994.member < _e1994.member_1) {
                                                phi_5150_ = type_9((_e1994.member + 1u), _e1994.member_1);
                                                phi_5175_ = type_9(1u, _e1994.member);
                                            } else {
                                                phi_5150_ = _e1994;
                                                phi_5175_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2008 = phi_5150_;
                                            let _e2010 = phi_5175_;
                                            if (bitcast<i32>(_e2010.member) != 0i) {
                                                let _e2017 = local_5[_e2010.member_1].member;
                                                let _e2020 = local_5[_e2010.member_1].member_1;
                                                let _e2022 = (_e2017 < -(_e2020));
                                                if _e2022 {
                                                    phi_5202_ = bool();
                                                    phi_5203_ = false;
                                                } else {
                                                    phi_5202_ = (_e1996 && (_e2017 > _e2020));
                                                    phi_5203_ = true;
                                                }
                                                let _e2026 = phi_5202_;
                                                let _e2028 = phi_5203_;
                                                phi_5153_ = _e2026;
                                                phi_5204_ = _e2028;
                                                phi_5205_ = _e2022;
                                            } else {
                                                phi_5153_ = bool();
                                                phi_5204_ = false;
                                                phi_5205_ = false;
                                            }
                                            let _e2030 = phi_5153_;
                                            let _e2032 = phi_5204_;
                                            let _e2034 = phi_5205_;
                                            local_16 = _e2034;
                                            continue;
                                            continuing {
                                                phi_5149_ = _e2008;
                                                phi_5152_ = _e2030;
                                                break if !(_e2032);
                                            }
                                        }
                                        let _e2037 = local_16;
                                        if _e2037 {
                                            phi_5209_ = false;
                                        } else {
                                            phi_5209_ = true;
                                        }
                                        let _e2039 = phi_5209_;
                                        if _e2039 {
                                            let _e2041 = local_17;
                                            if _e2041 {
                                                phi_5216_ = 1u;
                                            } else {
                                                phi_5216_ = 2u;
                                            }
                                            let _e2043 = phi_5216_;
                                            phi_5217_ = _e2043;
                                            phi_5218_ = false;
                                        } else {
                                            phi_5217_ = u32();
                                            phi_5218_ = true;
                                        }
                                        let _e2045 = phi_5217_;
                                        let _e2047 = phi_5218_;
                                        phi_5219_ = _e2045;
                                        phi_5220_ = 0u;
                                        phi_5221_ = _e2047;
                                    } else {
                                        phi_5219_ = u32();
                                        phi_5220_ = 2u;
                                        phi_5221_ = true;
                                    }
                                    let _e2049 = phi_5219_;
                                    let _e2051 = phi_5220_;
                                    let _e2053 = phi_5221_;
                                    if _e2053 {
                                        phi_5225_ = _e2051;
                                    } else {
                                        phi_5225_ = _e2049;
                                    }
                                    let _e2055 = phi_5225_;
                                    let _e2056 = (_e2055 == 0u);
                                    if _e2056 {
                                        phi_6282_ = f64();
                                        phi_6283_ = false;
                                        phi_6284_ = false;
                                        phi_6285_ = false;
                                    } else {
                                        if (_e2055 == 1u) {
                                            if _e1330.member_2 {
                                                if ((_e1330.member_1 - _e1330.member) <= f64(0.0000005f)) {
                                                    phi_5246_ = false;
                                                } else {
                                                    phi_5246_ = true;
                                                }
                                                let _e2065 = phi_5246_;
                                                phi_5247_ = _e2065;
                                            } else {
                                                phi_5247_ = true;
                                            }
                                            let _e2067 = phi_5247_;
                                            phi_5248_ = _e2067;
                                        } else {
                                            phi_5248_ = true;
                                        }
                                        let _e2069 = phi_5248_;
                                        if _e2069 {
                                            let _e2075 = local_12.member[0u];
                                            let _e2081 = local_12.member_1[0u];
                                            let _e2087 = local_12.member_2[0u];
                                            local = array<array<f64, 3>, 4>(_e2075, array<f64, 3>((_e2075[0] - _e2081[0]), (_e2075[1] - _e2081[1]), (_e2075[2] - _e2081[2])), array<f64, 3>((_e2075[0] - _e2087[0]), (_e2075[1] - _e2087[1]), (_e2075[2] - _e2087[2])), _e2075);
                                            let _e2102 = local_12.member[1u];
                                            let _e2108 = local_12.member_1[1u];
                                            let _e2114 = local_12.member_2[1u];
                                            local_1 = array<array<f64, 3>, 4>(_e2102, array<f64, 3>((_e2102[0] - _e2108[0]), (_e2102[1] - _e2108[1]), (_e2102[2] - _e2108[2])), array<f64, 3>((_e2102[0] - _e2114[0]), (_e2102[1] - _e2114[1]), (_e2102[2] - _e2114[2])), _e2102);
                                            let _e2129 = local_12.member[0u];
                                            if (_e2129[0] < 0.0lf) {
                                                phi_5445_ = -(_e2129[0]);
                                            } else {
                                                phi_5445_ = _e2129[0];
                                            }
                                            let _e2136 = phi_5445_;
                                            if (_e2129[1] < 0.0lf) {
                                                phi_5452_ = -(_e2129[1]);
                                            } else {
                                                phi_5452_ = _e2129[1];
                                            }
                                            let _e2140 = phi_5452_;
                                            if (_e2136 > _e2140) {
                                                phi_5457_ = _e2136;
                                            } else {
                                                phi_5457_ = _e2140;
                                            }
                                            let _e2143 = phi_5457_;
                                            if (_e2129[2] < 0.0lf) {
                                                phi_5464_ = -(_e2129[2]);
                                            } else {
                                                phi_5464_ = _e2129[2];
                                            }
                                            let _e2147 = phi_5464_;
                                            if (_e2143 > _e2147) {
                                                phi_5469_ = _e2143;
                                            } else {
                                                phi_5469_ = _e2147;
                                            }
                                            let _e2150 = phi_5469_;
                                            let _e2153 = local_12.member[1u];
                                            if (_e2153[0] < 0.0lf) {
                                                phi_5482_ = -(_e2153[0]);
                                            } else {
                                                phi_5482_ = _e2153[0];
                                            }
                                            let _e2160 = phi_5482_;
                                            if (_e2153[1] < 0.0lf) {
                                                phi_5489_ = -(_e2153[1]);
                                            } else {
                                                phi_5489_ = _e2153[1];
                                            }
                                            let _e2164 = phi_5489_;
                                            if (_e2160 > _e2164) {
                                                phi_5494_ = _e2160;
                                            } else {
                                                phi_5494_ = _e2164;
                                            }
                                            let _e2167 = phi_5494_;
                                            if (_e2153[2] < 0.0lf) {
                                                phi_5501_ = -(_e2153[2]);
                                            } else {
                                                phi_5501_ = _e2153[2];
                                            }
                                            let _e2171 = phi_5501_;
                                            if (_e2167 > _e2171) {
                                                phi_5506_ = _e2167;
                                            } else {
                                                phi_5506_ = _e2171;
                                            }
                                            let _e2174 = phi_5506_;
                                            if (_e2150 > _e2174) {
                                                phi_5511_ = _e2150;
                                            } else {
                                                phi_5511_ = _e2174;
                                            }
                                            let _e2177 = phi_5511_;
                                            let _e2179 = local_12.member_3;
                                            let _e2183 = local_12.member_1[0u];
                                            if (_e2183[0] < 0.0lf) {
                                                phi_5528_ = -(_e2183[0]);
                                            } else {
                                                phi_5528_ = _e2183[0];
                                            }
                                            let _e2190 = phi_5528_;
                                            if (_e2183[1] < 0.0lf) {
                                                phi_5535_ = -(_e2183[1]);
                                            } else {
                                                phi_5535_ = _e2183[1];
                                            }
                                            let _e2194 = phi_5535_;
                                            if (_e2190 > _e2194) {
                                                phi_5540_ = _e2190;
                                            } else {
                                                phi_5540_ = _e2194;
                                            }
                                            let _e2197 = phi_5540_;
                                            if (_e2183[2] < 0.0lf) {
                                                phi_5547_ = -(_e2183[2]);
                                            } else {
                                                phi_5547_ = _e2183[2];
                                            }
                                            let _e2201 = phi_5547_;
                                            if (_e2197 > _e2201) {
                                                phi_5552_ = _e2197;
                                            } else {
                                                phi_5552_ = _e2201;
                                            }
                                            let _e2204 = phi_5552_;
                                            let _e2207 = local_12.member_1[1u];
                                            if (_e2207[0] < 0.0lf) {
                                                phi_5566_ = -(_e2207[0]);
                                            } else {
                                                phi_5566_ = _e2207[0];
                                            }
                                            let _e2214 = phi_5566_;
                                            if (_e2207[1] < 0.0lf) {
                                                phi_5573_ = -(_e2207[1]);
                                            } else {
                                                phi_5573_ = _e2207[1];
                                            }
                                            let _e2218 = phi_5573_;
                                            if (_e2214 > _e2218) {
                                                phi_5578_ = _e2214;
                                            } else {
                                                phi_5578_ = _e2218;
                                            }
                                            let _e2221 = phi_5578_;
                                            if (_e2207[2] < 0.0lf) {
                                                phi_5585_ = -(_e2207[2]);
                                            } else {
                                                phi_5585_ = _e2207[2];
                                            }
                                            let _e2225 = phi_5585_;
                                            if (_e2221 > _e2225) {
                                                phi_5590_ = _e2221;
                                            } else {
                                                phi_5590_ = _e2225;
                                            }
                                            let _e2228 = phi_5590_;
                                            if (_e2204 > _e2228) {
                                                phi_5595_ = _e2204;
                                            } else {
                                                phi_5595_ = _e2228;
                                            }
                                            let _e2231 = phi_5595_;
                                            let _e2233 = local_12.member_3;
                                            let _e2237 = local_12.member_2[0u];
                                            if (_e2237[0] < 0.0lf) {
                                                phi_5612_ = -(_e2237[0]);
                                            } else {
                                                phi_5612_ = _e2237[0];
                                            }
                                            let _e2244 = phi_5612_;
                                            if (_e2237[1] < 0.0lf) {
                                                phi_5619_ = -(_e2237[1]);
                                            } else {
                                                phi_5619_ = _e2237[1];
                                            }
                                            let _e2248 = phi_5619_;
                                            if (_e2244 > _e2248) {
                                                phi_5624_ = _e2244;
                                            } else {
                                                phi_5624_ = _e2248;
                                            }
                                            let _e2251 = phi_5624_;
                                            if (_e2237[2] < 0.0lf) {
                                                phi_5631_ = -(_e2237[2]);
                                            } else {
                                                phi_5631_ = _e2237[2];
                                            }
                                            let _e2255 = phi_5631_;
                                            if (_e2251 > _e2255) {
                                                phi_5636_ = _e2251;
                                            } else {
                                                phi_5636_ = _e2255;
                                            }
                                            let _e2258 = phi_5636_;
                                            let _e2261 = local_12.member_2[1u];
                                            if (_e2261[0] < 0.0lf) {
                                                phi_5650_ = -(_e2261[0]);
                                            } else {
                                                phi_5650_ = _e2261[0];
                                            }
                                            let _e2268 = phi_5650_;
                                            if (_e2261[1] < 0.0lf) {
                                                phi_5657_ = -(_e2261[1]);
                                            } else {
                                                phi_5657_ = _e2261[1];
                                            }
                                            let _e2272 = phi_5657_;
                                            if (_e2268 > _e2272) {
                                                phi_5662_ = _e2268;
                                            } else {
                                                phi_5662_ = _e2272;
                                            }
                                            let _e2275 = phi_5662_;
                                            if (_e2261[2] < 0.0lf) {
                                                phi_5669_ = -(_e2261[2]);
                                            } else {
                                                phi_5669_ = _e2261[2];
                                            }
                                            let _e2279 = phi_5669_;
                                            if (_e2275 > _e2279) {
                                                phi_5674_ = _e2275;
                                            } else {
                                                phi_5674_ = _e2279;
                                            }
                                            let _e2282 = phi_5674_;
                                            if (_e2258 > _e2282) {
                                                phi_5679_ = _e2258;
                                            } else {
                                                phi_5679_ = _e2282;
                                            }
                                            let _e2285 = phi_5679_;
                                            let _e2287 = local_12.member_3;
                                            let _e2295 = local_12.member_3;
                                            phi_5699_ = type_9(0u, 48u);
                                            phi_5702_ = _e1330.member;
                                            loop {
                                                let _e2304 = phi_5699_;
                                                let _e2306 = phi_5702_;
                                                local_61 = _e2306;
                                                local_24 = _e2306;
                                                local_25 = _e2306;
                                                local_26 = _e2306;
                                                local_27 = _e2306;
                                                if (_e2304.member < _e2304.member_1) {
                                                    phi_5700_ = type_9((_e2304.member + 1u), _e2304.member_1);
                                                    phi_5725_ = type_9(1u, _e2304.member);
                                                } else {
                                                    phi_5700_ = _e2304;
                                                    phi_5725_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2318 = phi_5700_;
                                                let _e2320 = phi_5725_;
                                                if (bitcast<i32>(_e2320.member) != 0i) {
                                                    let _e2326 = local_12.member[0u];
                                                    let _e2332 = local_12.member[1u];
                                                    let _e2348 = local_12.member_1[0u];
                                                    let _e2354 = local_12.member_1[1u];
                                                    let _e2370 = local_12.member_2[0u];
                                                    let _e2376 = local_12.member_2[1u];
                                                    let _e2390 = function_2(array<f64, 3>((_e2326[0] + ((_e2332[0] - _e2326[0]) * _e2306)), (_e2326[1] + ((_e2332[1] - _e2326[1]) * _e2306)), (_e2326[2] + ((_e2332[2] - _e2326[2]) * _e2306))), array<f64, 3>((_e2348[0] + ((_e2354[0] - _e2348[0]) * _e2306)), (_e2348[1] + ((_e2354[1] - _e2348[1]) * _e2306)), (_e2348[2] + ((_e2354[2] - _e2348[2]) * _e2306))), array<f64, 3>((_e2370[0] + ((_e2376[0] - _e2370[0]) * _e2306)), (_e2370[1] + ((_e2376[1] - _e2370[1]) * _e2306)), (_e2370[2] + ((_e2376[2] - _e2370[2]) * _e2306))), 0u);
                                                    if (_e2390[0] < 0.0lf) {
                                                        phi_5836_ = -(_e2390[0]);
                                                    } else {
                                                        phi_5836_ = _e2390[0];
                                                    }
                                                    let _e2395 = phi_5836_;
                                                    if (_e2390[1] < 0.0lf) {
                                                        phi_5843_ = -(_e2390[1]);
                                                    } else {
                                                        phi_5843_ = _e2390[1];
                                                    }
                                                    let _e2400 = phi_5843_;
                                                    if (_e2390[2] < 0.0lf) {
                                                        phi_5851_ = -(_e2390[2]);
                                                    } else {
                                                        phi_5851_ = _e2390[2];
                                                    }
                                                    let _e2406 = phi_5851_;
                                                    let _e2407 = ((_e2395 + _e2400) + _e2406);
                                                    if (_e2407 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2407) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2413 = (f64(1f) / _e2407);
                                                            let _e2415 = (_e2390[0] * _e2413);
                                                            let _e2417 = (_e2390[1] * _e2413);
                                                            let _e2419 = (_e2390[2] * _e2413);
                                                            let _e2424 = (((_e2415 * _e2415) + (_e2417 * _e2417)) + (_e2419 * _e2419));
                                                            if (_e2424 <= 2.2250738585072014e-308lf) {
                                                                if (_e2424 > 0.0lf) {
                                                                    phi_5889_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_5889_ = 0.0lf;
                                                                }
                                                                let _e2476 = phi_5889_;
                                                                phi_5953_ = _e2476;
                                                            } else {
                                                                phi_5896_ = type_16(0i, 5i);
                                                                phi_5899_ = bitcast<f64>(((bitcast<u64>(_e2424) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2431 = phi_5896_;
                                                                    let _e2433 = phi_5899_;
                                                                    local_18 = _e2433;
                                                                    if (_e2431.member < _e2431.member_1) {
                                                                        let _e2440 = (_e2431.member + 1i);
                                                                        if ((false == (_e2440 > _e2431.member)) != false) {
                                                                            phi_5920_ = true;
                                                                        } else {
                                                                            phi_5920_ = false;
                                                                        }
                                                                        let _e2445 = phi_5920_;
                                                                        if _e2445 {
                                                                            phi_5926_ = type_17(0u, type_17().member_1);
                                                                        } else {
                                                                            phi_5926_ = type_17(1u, _e2440);
                                                                        }
                                                                        let _e2450 = phi_5926_;
                                                                        phi_5897_ = type_16(_e2450.member_1, _e2431.member_1);
                                                                        phi_5940_ = type_17(1u, _e2431.member);
                                                                    } else {
                                                                        phi_5897_ = _e2431;
                                                                        phi_5940_ = type_17(0u, type_17().member_1);
                                                                    }
                                                                    let _e2456 = phi_5897_;
                                                                    let _e2458 = phi_5940_;
                                                                    let _e2461 = (bitcast<i32>(_e2458.member) != 0i);
                                                                    if _e2461 {
                                                                        phi_5900_ = (0.5lf * (_e2433 + (_e2424 / _e2433)));
                                                                    } else {
                                                                        phi_5900_ = f64();
                                                                    }
                                                                    let _e2466 = phi_5900_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_5896_ = _e2456;
                                                                        phi_5899_ = _e2466;
                                                                        break if !(_e2461);
                                                                    }
                                                                }
                                                                let _e2471 = local_18;
                                                                phi_5953_ = (_e2471 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2478 = phi_5953_;
                                                            phi_5966_ = type_9(0u, 4u);
                                                            phi_5969_ = f64(2f);
                                                            loop {
                                                                let _e2490 = phi_5966_;
                                                                let _e2492 = phi_5969_;
                                                                local_20 = _e2492;
                                                                local_21 = _e2492;
                                                                local_22 = _e2492;
                                                                local_51 = _e2492;
                                                                local_52 = _e2492;
                                                                if (_e2490.member < _e2490.member_1) {
                                                                    phi_5967_ = type_9((_e2490.member + 1u), _e2490.member_1);
                                                                    phi_5992_ = type_9(1u, _e2490.member);
                                                                } else {
                                                                    phi_5967_ = _e2490;
                                                                    phi_5992_ = type_9(0u, type_9().member_1);
                                                                }
                                                                let _e2504 = phi_5967_;
                                                                let _e2506 = phi_5992_;
                                                                if (bitcast<i32>(_e2506.member) != 0i) {
                                                                    let _e2512 = local[_e2506.member_1];
                                                                    let _e2520 = (((_e2415 * _e2512[0]) + (_e2417 * _e2512[1])) + (_e2419 * _e2512[2]));
                                                                    let _e2522 = local_1[_e2506.member_1];
                                                                    let _e2530 = (((_e2415 * _e2522[0]) + (_e2417 * _e2522[1])) + (_e2419 * _e2522[2]));
                                                                    if (_e2520 < 0.0lf) {
                                                                        phi_6043_ = -(_e2520);
                                                                    } else {
                                                                        phi_6043_ = _e2520;
                                                                    }
                                                                    let _e2534 = phi_6043_;
                                                                    if (_e2530 < 0.0lf) {
                                                                        phi_6049_ = -(_e2530);
                                                                    } else {
                                                                        phi_6049_ = _e2530;
                                                                    }
                                                                    let _e2538 = phi_6049_;
                                                                    let _e2543 = (((((((((_e2177 + _e2179) + (_e2231 + _e2233)) + (_e2285 + _e2287)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2295 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2478) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2534 + _e2538) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2520 > _e2543) {
                                                                        if (_e2530 > _e2543) {
                                                                            phi_6063_ = false;
                                                                        } else {
                                                                            phi_6063_ = true;
                                                                        }
                                                                        let _e2547 = phi_6063_;
                                                                        phi_6064_ = _e2547;
                                                                    } else {
                                                                        phi_6064_ = true;
                                                                    }
                                                                    let _e2549 = phi_6064_;
                                                                    if _e2549 {
                                                                        if ((_e2520 + ((_e2530 - _e2520) * _e2306)) > _e2543) {
                                                                            if (_e2530 < _e2520) {
                                                                                let _e2558 = ((_e2520 - _e2530) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                                                if _e2558 {
                                                                                    let _e2566 = (((_e2520 - _e2543) / (_e2520 - _e2530)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    if (_e2492 < _e2566) {
                                                                                        phi_6098_ = _e2492;
                                                                                    } else {
                                                                                        phi_6098_ = _e2566;
                                                                                    }
                                                                                    let _e2569 = phi_6098_;
                                                                                    phi_6099_ = _e2569;
                                                                                } else {
                                                                                    phi_6099_ = f64();
                                                                                }
                                                                                let _e2571 = phi_6099_;
                                                                                phi_6100_ = _e2571;
                                                                                phi_6101_ = _e2558;
                                                                            } else {
                                                                                phi_6100_ = _e2492;
                                                                                phi_6101_ = true;
                                                                            }
                                                                            let _e2573 = phi_6100_;
                                                                            let _e2575 = phi_6101_;
                                                                            if _e2575 {
                                                                                phi_6105_ = false;
                                                                            } else {
                                                                                phi_6105_ = true;
                                                                            }
                                                                            let _e2577 = phi_6105_;
                                                                            phi_6106_ = _e2573;
                                                                            phi_6107_ = _e2575;
                                                                            phi_6108_ = _e2577;
                                                                            phi_6109_ = false;
                                                                        } else {
                                                                            phi_6106_ = f64();
                                                                            phi_6107_ = false;
                                                                            phi_6108_ = false;
                                                                            phi_6109_ = true;
                                                                        }
                                                                        let _e2579 = phi_6106_;
                                                                        let _e2581 = phi_6107_;
                                                                        let _e2583 = phi_6108_;
                                                                        let _e2585 = phi_6109_;
                                                                        phi_6110_ = _e2579;
                                                                        phi_6111_ = _e2581;
                                                                        phi_6112_ = _e2583;
                                                                        phi_6113_ = _e2585;
                                                                    } else {
                                                                        phi_6110_ = _e2492;
                                                                        phi_6111_ = true;
                                                                        phi_6112_ = false;
                                                                        phi_6113_ = false;
                                                                    }
                                                                    let _e2587 = phi_6110_;
                                                                    let _e2589 = phi_6111_;
                                                                    let _e2591 = phi_6112_;
                                                                    let _e2593 = phi_6113_;
                                                                    phi_5970_ = _e2587;
                                                                    phi_6114_ = _e2589;
                                                                    phi_6115_ = false;
                                                                    phi_6116_ = _e2591;
                                                                    phi_6117_ = _e2593;
                                                                } else {
                                                                    phi_5970_ = f64();
                                                                    phi_6114_ = false;
                                                                    phi_6115_ = true;
                                                                    phi_6116_ = false;
                                                                    phi_6117_ = false;
                                                                }
                                                                let _e2595 = phi_5970_;
                                                                let _e2597 = phi_6114_;
                                                                let _e2599 = phi_6115_;
                                                                let _e2601 = phi_6116_;
                                                                let _e2603 = phi_6117_;
                                                                local_19 = _e2599;
                                                                local_49 = _e2601;
                                                                local_50 = _e2603;
                                                                continue;
                                                                continuing {
                                                                    phi_5966_ = _e2504;
                                                                    phi_5969_ = _e2595;
                                                                    break if !(_e2597);
                                                                }
                                                            }
                                                            let _e2606 = local_19;
                                                            if _e2606 {
                                                                let _e2608 = local_20;
                                                                let _e2609 = (_e2608 > _e1330.member_1);
                                                                if _e2609 {
                                                                    phi_6139_ = false;
                                                                    phi_6140_ = false;
                                                                    phi_6141_ = false;
                                                                } else {
                                                                    let _e2611 = local_21;
                                                                    if (_e2611 > _e2306) {
                                                                        let _e2614 = local_22;
                                                                        let _e2617 = ((_e2614 - _e2306) < f64(0.00000000023283064f));
                                                                        if _e2617 {
                                                                            phi_6135_ = false;
                                                                        } else {
                                                                            phi_6135_ = true;
                                                                        }
                                                                        let _e2619 = phi_6135_;
                                                                        phi_6136_ = _e2619;
                                                                        phi_6137_ = _e2617;
                                                                        phi_6138_ = false;
                                                                    } else {
                                                                        phi_6136_ = false;
                                                                        phi_6137_ = false;
                                                                        phi_6138_ = true;
                                                                    }
                                                                    let _e2621 = phi_6136_;
                                                                    let _e2623 = phi_6137_;
                                                                    let _e2625 = phi_6138_;
                                                                    phi_6139_ = _e2621;
                                                                    phi_6140_ = _e2623;
                                                                    phi_6141_ = _e2625;
                                                                }
                                                                let _e2627 = phi_6139_;
                                                                let _e2629 = phi_6140_;
                                                                let _e2631 = phi_6141_;
                                                                phi_6142_ = _e2627;
                                                                phi_6143_ = _e2609;
                                                                phi_6144_ = _e2629;
                                                                phi_6145_ = _e2631;
                                                                phi_6146_ = false;
                                                                phi_6147_ = false;
                                                            } else {
                                                                phi_6142_ = false;
                                                                phi_6143_ = false;
                                                                phi_6144_ = false;
                                                                phi_6145_ = false;
                                                                let _e4491 = local_49;
                                                                phi_6146_ = _e4491;
                                                                let _e4494 = local_50;
                                                                phi_6147_ = _e4494;
                                                            }
                                                            let _e2633 = phi_6142_;
                                                            let _e2635 = phi_6143_;
                                                            let _e2637 = phi_6144_;
                                                            let _e2639 = phi_6145_;
                                                            let _e2641 = phi_6146_;
                                                            let _e2643 = phi_6147_;
                                                            let _e4497 = local_51;
                                                            phi_6148_ = _e4497;
                                                            let _e4500 = local_52;
                                                            phi_6149_ = _e4500;
                                                            phi_6150_ = _e2633;
                                                            phi_6151_ = _e2635;
                                                            phi_6152_ = _e2637;
                                                            phi_6153_ = _e2639;
                                                            phi_6154_ = _e2641;
                                                            phi_6155_ = _e2643;
                                                            phi_6156_ = false;
                                                        } else {
                                                            phi_6148_ = f64();
                                                            phi_6149_ = f64();
                                                            phi_6150_ = false;
                                                            phi_6151_ = false;
                                                            phi_6152_ = false;
                                                            phi_6153_ = false;
                                                            phi_6154_ = false;
                                                            phi_6155_ = false;
                                                            phi_6156_ = true;
                                                        }
                                                        let _e2645 = phi_6148_;
                                                        let _e2647 = phi_6149_;
                                                        let _e2649 = phi_6150_;
                                                        let _e2651 = phi_6151_;
                                                        let _e2653 = phi_6152_;
                                                        let _e2655 = phi_6153_;
                                                        let _e2657 = phi_6154_;
                                                        let _e2659 = phi_6155_;
                                                        let _e2661 = phi_6156_;
                                                        phi_6157_ = _e2645;
                                                        phi_6158_ = _e2647;
                                                        phi_6159_ = _e2649;
                                                        phi_6160_ = _e2651;
                                                        phi_6161_ = _e2653;
                                                        phi_6162_ = _e2655;
                                                        phi_6163_ = _e2657;
                                                        phi_6164_ = _e2659;
                                                        phi_6165_ = _e2661;
                                                        phi_6166_ = false;
                                                    } else {
                                                        phi_6157_ = f64();
                                                        phi_6158_ = f64();
                                                        phi_6159_ = false;
                                                        phi_6160_ = false;
                                                        phi_6161_ = false;
                                                        phi_6162_ = false;
                                                        phi_6163_ = false;
                                                        phi_6164_ = false;
                                                        phi_6165_ = false;
                                                        phi_6166_ = true;
                                                    }
                                                    let _e2663 = phi_6157_;
                                                    let _e2665 = phi_6158_;
                                                    let _e2667 = phi_6159_;
                                                    let _e2669 = phi_6160_;
                                                    let _e2671 = phi_6161_;
                                                    let _e2673 = phi_6162_;
                                                    let _e2675 = phi_6163_;
                                                    let _e2677 = phi_6164_;
                                                    let _e2679 = phi_6165_;
                                                    let _e2681 = phi_6166_;
                                                    phi_6167_ = _e2663;
                                                    phi_5703_ = _e2665;
                                                    phi_6168_ = _e2667;
                                                    phi_6169_ = _e2669;
                                                    phi_6170_ = _e2671;
                                                    phi_6171_ = false;
                                                    phi_6172_ = _e2673;
                                                    phi_6173_ = _e2675;
                                                    phi_6174_ = _e2677;
                                                    phi_6175_ = _e2679;
                                                    phi_6176_ = _e2681;
                                                } else {
                                                    phi_6167_ = f64();
                                                    phi_5703_ = f64();
                                                    phi_6168_ = false;
                                                    phi_6169_ = false;
                                                    phi_6170_ = false;
                                                    phi_6171_ = true;
                                                    phi_6172_ = false;
                                                    phi_6173_ = false;
                                                    phi_6174_ = false;
                                                    phi_6175_ = false;
                                                    phi_6176_ = false;
                                                }
                                                let _e2683 = phi_6167_;
                                                let _e2685 = phi_5703_;
                                                let _e2687 = phi_6168_;
                                                let _e2689 = phi_6169_;
                                                let _e2691 = phi_6170_;
                                                let _e2693 = phi_6171_;
                                                let _e2695 = phi_6172_;
                                                let _e2697 = phi_6173_;
                                                let _e2699 = phi_6174_;
                                                let _e2701 = phi_6175_;
                                                let _e2703 = phi_6176_;
                                                local_23 = _e2689;
                                                local_53 = _e2691;
                                                local_54 = _e2693;
                                                local_55 = _e2695;
                                                local_56 = _e2697;
                                                local_57 = _e2699;
                                                local_58 = _e2701;
                                                local_59 = _e2703;
                                                local_60 = _e2683;
                                                local_62 = _e2689;
                                                continue;
                                                continuing {
                                                    phi_5699_ = _e2318;
                                                    phi_5702_ = _e2685;
                                                    break if !(_e2687);
                                                }
                                            }
                                            let _e2706 = local_23;
                                            if _e2706 {
                                                phi_6181_ = type_42(0u, type_42().member_1);
                                                phi_6182_ = false;
                                                phi_6183_ = false;
                                                phi_6184_ = false;
                                                phi_6185_ = false;
                                                phi_6186_ = false;
                                                phi_6187_ = false;
                                                phi_6188_ = false;
                                            } else {
                                                phi_6181_ = type_42();
                                                let _e4533 = local_53;
                                                phi_6182_ = _e4533;
                                                let _e4536 = local_54;
                                                phi_6183_ = _e4536;
                                                let _e4539 = local_55;
                                                phi_6184_ = _e4539;
                                                let _e4542 = local_56;
                                                phi_6185_ = _e4542;
                                                let _e4545 = local_57;
                                                phi_6186_ = _e4545;
                                                let _e4548 = local_58;
                                                phi_6187_ = _e4548;
                                                let _e4551 = local_59;
                                                phi_6188_ = _e4551;
                                            }
                                            let _e2710 = phi_6181_;
                                            let _e2712 = phi_6182_;
                                            let _e2714 = phi_6183_;
                                            let _e2716 = phi_6184_;
                                            let _e2718 = phi_6185_;
                                            let _e2720 = phi_6186_;
                                            let _e2722 = phi_6187_;
                                            let _e2724 = phi_6188_;
                                            if _e2712 {
                                                let _e4554 = local_60;
                                                phi_6192_ = _e4554;
                                                phi_6193_ = true;
                                                phi_6194_ = false;
                                                phi_6195_ = false;
                                                phi_6196_ = false;
                                                phi_6197_ = false;
                                                phi_6198_ = false;
                                                phi_6199_ = false;
                                            } else {
                                                let _e4556 = local_61;
                                                phi_6192_ = _e4556;
                                                phi_6193_ = _e2714;
                                                phi_6194_ = _e2716;
                                                phi_6195_ = _e2718;
                                                phi_6196_ = _e2720;
                                                let _e4563 = local_62;
                                                phi_6197_ = _e4563;
                                                phi_6198_ = _e2722;
                                                phi_6199_ = _e2724;
                                            }
                                            let _e2726 = phi_6192_;
                                            let _e2728 = phi_6193_;
                                            let _e2730 = phi_6194_;
                                            let _e2732 = phi_6195_;
                                            let _e2734 = phi_6196_;
                                            let _e2736 = phi_6197_;
                                            let _e2738 = phi_6198_;
                                            let _e2740 = phi_6199_;
                                            if _e2728 {
                                                phi_6204_ = type_42(1u, _e2726);
                                                phi_6205_ = false;
                                                phi_6206_ = false;
                                                phi_6207_ = false;
                                                phi_6208_ = false;
                                                phi_6209_ = false;
                                                phi_6210_ = false;
                                            } else {
                                                phi_6204_ = type_42();
                                                phi_6205_ = _e2730;
                                                phi_6206_ = _e2732;
                                                phi_6207_ = _e2734;
                                                phi_6208_ = _e2736;
                                                phi_6209_ = _e2738;
                                                phi_6210_ = _e2740;
                                            }
                                            let _e2743 = phi_6204_;
                                            let _e2745 = phi_6205_;
                                            let _e2747 = phi_6206_;
                                            let _e2749 = phi_6207_;
                                            let _e2751 = phi_6208_;
                                            let _e2753 = phi_6209_;
                                            let _e2755 = phi_6210_;
                                            if _e2745 {
                                                let _e2757 = local_24;
                                                phi_6215_ = type_42(1u, _e2757);
                                                phi_6216_ = false;
                                                phi_6217_ = false;
                                                phi_6218_ = true;
                                                phi_6219_ = false;
                                                phi_6220_ = false;
                                            } else {
                                                phi_6215_ = _e2710;
                                                phi_6216_ = _e2747;
                                                phi_6217_ = _e2749;
                                                phi_6218_ = _e2751;
                                                phi_6219_ = _e2753;
                                                phi_6220_ = _e2755;
                                            }
                                            let _e2760 = phi_6215_;
                                            let _e2762 = phi_6216_;
                                            let _e2764 = phi_6217_;
                                            let _e2766 = phi_6218_;
                                            let _e2768 = phi_6219_;
                                            let _e2770 = phi_6220_;
                                            if _e2762 {
                                                let _e2772 = local_25;
                                                phi_6225_ = type_42(1u, _e2772);
                                                phi_6226_ = false;
                                                phi_6227_ = false;
                                                phi_6228_ = false;
                                                phi_6229_ = false;
                                            } else {
                                                phi_6225_ = type_42();
                                                phi_6226_ = _e2764;
                                                phi_6227_ = _e2766;
                                                phi_6228_ = _e2768;
                                                phi_6229_ = _e2770;
                                            }
                                            let _e2775 = phi_6225_;
                                            let _e2777 = phi_6226_;
                                            let _e2779 = phi_6227_;
                                            let _e2781 = phi_6228_;
                                            let _e2783 = phi_6229_;
                                            if _e2777 {
                                                let _e2785 = local_26;
                                                phi_6234_ = type_42(1u, _e2785);
                                                phi_6235_ = true;
                                                phi_6236_ = false;
                                                phi_6237_ = false;
                                                phi_6238_ = false;
                                            } else {
                                                phi_6234_ = _e2775;
                                                phi_6235_ = _e2762;
                                                phi_6236_ = _e2779;
                                                phi_6237_ = _e2781;
                                                phi_6238_ = _e2783;
                                            }
                                            let _e2788 = phi_6234_;
                                            let _e2790 = phi_6235_;
                                            let _e2792 = phi_6236_;
                                            let _e2794 = phi_6237_;
                                            let _e2796 = phi_6238_;
                                            if _e2790 {
                                                phi_6242_ = _e2788;
                                                phi_6243_ = true;
                                                phi_6244_ = false;
                                                phi_6245_ = false;
                                            } else {
                                                phi_6242_ = _e2760;
                                                phi_6243_ = _e2792;
                                                phi_6244_ = _e2794;
                                                phi_6245_ = _e2796;
                                            }
                                            let _e2798 = phi_6242_;
                                            let _e2800 = phi_6243_;
                                            let _e2802 = phi_6244_;
                                            let _e2804 = phi_6245_;
                                            if _e2800 {
                                                phi_6249_ = false;
                                                phi_6250_ = false;
                                            } else {
                                                phi_6249_ = _e2802;
                                                phi_6250_ = _e2804;
                                            }
                                            let _e2806 = phi_6249_;
                                            let _e2808 = phi_6250_;
                                            if _e2806 {
                                                phi_6254_ = false;
                                                phi_6255_ = false;
                                            } else {
                                                phi_6254_ = _e2808;
                                                phi_6255_ = _e2800;
                                            }
                                            let _e2810 = phi_6254_;
                                            let _e2812 = phi_6255_;
                                            if _e2810 {
                                                phi_6259_ = true;
                                                phi_6260_ = false;
                                            } else {
                                                phi_6259_ = _e2806;
                                                phi_6260_ = _e2812;
                                            }
                                            let _e2814 = phi_6259_;
                                            let _e2816 = phi_6260_;
                                            if _e2814 {
                                                let _e2818 = local_27;
                                                phi_6265_ = type_42(1u, _e2818);
                                                phi_6266_ = true;
                                            } else {
                                                phi_6265_ = _e2798;
                                                phi_6266_ = _e2816;
                                            }
                                            let _e2821 = phi_6265_;
                                            let _e2823 = phi_6266_;
                                            if _e2823 {
                                                phi_6270_ = _e2821;
                                            } else {
                                                phi_6270_ = _e2743;
                                            }
                                            let _e2825 = phi_6270_;
                                            let _e2828 = (_e2825.member != 0u);
                                            if _e2828 {
                                                phi_6277_ = false;
                                            } else {
                                                phi_6277_ = true;
                                            }
                                            let _e2830 = phi_6277_;
                                            phi_6278_ = _e2825.member_1;
                                            phi_6279_ = _e2830;
                                            phi_6280_ = _e2828;
                                            phi_6281_ = false;
                                        } else {
                                            phi_6278_ = f64();
                                            phi_6279_ = false;
                                            phi_6280_ = false;
                                            phi_6281_ = true;
                                        }
                                        let _e2832 = phi_6278_;
                                        let _e2834 = phi_6279_;
                                        let _e2836 = phi_6280_;
                                        let _e2838 = phi_6281_;
                                        phi_6282_ = _e2832;
                                        phi_6283_ = _e2834;
                                        phi_6284_ = _e2836;
                                        phi_6285_ = _e2838;
                                    }
                                    let _e2840 = phi_6282_;
                                    let _e2842 = phi_6283_;
                                    let _e2844 = phi_6284_;
                                    let _e2846 = phi_6285_;
                                    phi_6286_ = _e2840;
                                    phi_6287_ = _e2056;
                                    phi_6288_ = _e2842;
                                    phi_6289_ = _e2844;
                                    phi_6290_ = _e2846;
                                }
                                let _e2848 = phi_6286_;
                                let _e2850 = phi_6287_;
                                let _e2852 = phi_6288_;
                                let _e2854 = phi_6289_;
                                let _e2856 = phi_6290_;
                                if _e2850 {
                                    phi_6294_ = true;
                                    phi_6295_ = false;
                                    phi_6296_ = false;
                                } else {
                                    phi_6294_ = _e2852;
                                    phi_6295_ = _e2854;
                                    phi_6296_ = _e2856;
                                }
                                let _e2858 = phi_6294_;
                                let _e2860 = phi_6295_;
                                let _e2862 = phi_6296_;
                                phi_6297_ = _e2848;
                                phi_6298_ = _e1330;
                                phi_6299_ = _e2858;
                                phi_6300_ = false;
                                phi_6301_ = _e2860;
                                phi_6302_ = _e2862;
                            } else {
                                phi_6297_ = f64();
                                phi_6298_ = type_43();
                                phi_6299_ = false;
                                phi_6300_ = true;
                                phi_6301_ = false;
                                phi_6302_ = false;
                            }
                            let _e2864 = phi_6297_;
                            let _e2866 = phi_6298_;
                            let _e2868 = phi_6299_;
                            let _e2870 = phi_6300_;
                            let _e2872 = phi_6301_;
                            let _e2874 = phi_6302_;
                            local_28 = _e2870;
                            local_63 = _e2872;
                            local_64 = _e2874;
                            local_29 = _e2864;
                            local_30 = _e2866;
                            continue;
                            continuing {
                                phi_3738_ = _e1017;
                                break if !(_e2868);
                            }
                        }
                        let _e2877 = local_28;
                        if _e2877 {
                            phi_6307_ = type_42(0u, type_42().member_1);
                            phi_6308_ = false;
                            phi_6309_ = false;
                        } else {
                            phi_6307_ = type_42();
                            let _e4633 = local_63;
                            phi_6308_ = _e4633;
                            let _e4636 = local_64;
                            phi_6309_ = _e4636;
                        }
                        let _e2881 = phi_6307_;
                        let _e2883 = phi_6308_;
                        let _e2885 = phi_6309_;
                        if _e2883 {
                            let _e2887 = local_29;
                            phi_6314_ = type_42(2u, _e2887);
                            phi_6315_ = false;
                        } else {
                            phi_6314_ = type_42();
                            phi_6315_ = _e2885;
                        }
                        let _e2890 = phi_6314_;
                        let _e2892 = phi_6315_;
                        if _e2892 {
                            let _e2894 = local_30;
                            phi_6321_ = type_42(1u, _e2894.member);
                            phi_6322_ = true;
                        } else {
                            phi_6321_ = _e2890;
                            phi_6322_ = _e2883;
                        }
                        let _e2898 = phi_6321_;
                        let _e2900 = phi_6322_;
                        if _e2900 {
                            phi_6326_ = _e2898;
                        } else {
                            phi_6326_ = _e2881;
                        }
                        let _e2902 = phi_6326_;
                        phi_6330_ = _e2902;
                    }
                    let _e4039 = phi_6330_;
                    phi_6331_ = _e4039;
                }
                let _e4043 = phi_6331_;
                switch bitcast<i32>(_e4043.member) {
                    case 0: {
                        phi_6344_ = type_32(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4049 = function_3(_e4043.member_1);
                        phi_6344_ = type_32(0u, _e4049, true);
                        break;
                    }
                    case 2: {
                        let _e4047 = function_3(_e4043.member_1);
                        phi_6344_ = type_32(1u, _e4047, true);
                        break;
                    }
                    default: {
                        phi_6344_ = type_32();
                        break;
                    }
                }
                let _e4052 = phi_6344_;
                if _e4052.member_2 {
                    let _e4059 = (_e4052.member_1[1] >> bitcast<u32>(20i));
                    if (_e4059 <= 896u) {
                        phi_6367_ = 0u;
                    } else {
                        phi_6367_ = ((((_e4059 - 896u) << bitcast<u32>(23i)) | ((_e4052.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4052.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4074 = phi_6367_;
                    let _e4076 = atomicMin((&earliest.member[0u]), _e4074);
                }
                phi_6371_ = type_22(0u, _e4052.member, _e172, _e175, _e4052.member_1);
                phi_6372_ = _e4052.member_2;
            } else {
                phi_6371_ = type_22(0u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_6372_ = false;
            }
            let _e4078 = phi_6371_;
            let _e4080 = phi_6372_;
            let _e4083 = params.member.member.member_1;
            if ((_e4083 & 16u) != 0u) {
                if (_e101 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4080 {
                    let _e4089 = atomicAdd((&counters[0u]), 1u);
                    phi_6391_ = _e4089;
                } else {
                    phi_6391_ = 0u;
                }
                let _e4091 = phi_6391_;
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
                if _e4080 {
                    let _e4104 = params.member.member_1.member_3;
                    if (_e4101 < _e4104) {
                        let _e4106 = (6u * _e4101);
                        atomicStore((&contacts.member[(4u + _e4106)]), _e4078.member);
                        atomicStore((&contacts.member[(_e4106 + 5u)]), _e4078.member_1);
                        atomicStore((&contacts.member[(_e4106 + 6u)]), _e4078.member_2);
                        atomicStore((&contacts.member[(_e4106 + 7u)]), _e4078.member_3);
                        atomicStore((&contacts.member[(_e4106 + 8u)]), _e4078.member_4[0]);
                        atomicStore((&contacts.member[(_e4106 + 9u)]), _e4078.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_834_ = _e157;
            break if !(_e163);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
