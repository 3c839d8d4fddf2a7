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
    member: array<array<u32, 2>>,
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
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_33 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_34 {
    member: f64,
    member_1: f64,
}

struct type_38 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_40 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_41 {
    member: type_38,
    member_1: f64,
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

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> paths: type_27;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_46;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> wide: type_23;
@group(0) @binding(3) 
var<storage> elements: type_14;
@group(0) @binding(4) 
var<storage> input: type_12;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_46;

fn function_(param: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    var phi_8934_: array<f64, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_8934_ = param_2;
    } else {
        phi_8934_ = param_1;
    }
    let _e26 = phi_8934_;
    return _e26;
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_8498_: bool;
    var phi_8499_: bool;
    var phi_8500_: bool;
    var phi_8501_: bool;
    var phi_8505_: bool;
    var phi_8478_: bool;
    var phi_8479_: bool;
    var phi_8480_: bool;
    var phi_8481_: bool;
    var phi_8482_: bool;
    var phi_8483_: bool;
    var phi_8487_: bool;
    var phi_8506_: bool;
    var phi_8536_: array<f64, 3>;
    var phi_8537_: bool;
    var phi_8538_: array<f64, 3>;
    var phi_8539_: bool;
    var phi_8785_: f64;
    var phi_8787_: f64;
    var phi_8829_: f64;
    var phi_8831_: f64;
    var phi_8879_: f64;
    var phi_8881_: f64;
    var phi_8590_: f64;
    var phi_8592_: f64;
    var phi_8640_: f64;
    var phi_8642_: f64;
    var phi_8687_: f64;
    var phi_8689_: f64;
    var phi_8740_: f64;
    var phi_8742_: f64;
    var phi_8896_: array<array<f64, 3>, 4>;
    var phi_8904_: array<f64, 3>;

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
                    phi_8478_ = (_e78 <= _e70);
                    phi_8479_ = false;
                } else {
                    phi_8478_ = bool();
                    phi_8479_ = true;
                }
                let _e99 = phi_8478_;
                let _e101 = phi_8479_;
                phi_8480_ = _e99;
                phi_8481_ = _e101;
            } else {
                phi_8480_ = bool();
                phi_8481_ = true;
            }
            let _e103 = phi_8480_;
            let _e105 = phi_8481_;
            phi_8482_ = _e103;
            phi_8483_ = _e105;
        } else {
            phi_8482_ = bool();
            phi_8483_ = true;
        }
        let _e107 = phi_8482_;
        let _e109 = phi_8483_;
        if _e109 {
            phi_8487_ = false;
        } else {
            phi_8487_ = _e107;
        }
        let _e111 = phi_8487_;
        phi_8506_ = _e111;
    } else {
        if (_e74 >= _e69) {
            if (_e78 >= _e69) {
                phi_8498_ = ((_e74 + _e78) <= _e70);
                phi_8499_ = false;
            } else {
                phi_8498_ = bool();
                phi_8499_ = true;
            }
            let _e85 = phi_8498_;
            let _e87 = phi_8499_;
            phi_8500_ = _e85;
            phi_8501_ = _e87;
        } else {
            phi_8500_ = bool();
            phi_8501_ = true;
        }
        let _e89 = phi_8500_;
        let _e91 = phi_8501_;
        if _e91 {
            phi_8505_ = false;
        } else {
            phi_8505_ = _e89;
        }
        let _e93 = phi_8505_;
        phi_8506_ = _e93;
    }
    let _e113 = phi_8506_;
    if (_e68 > _e69) {
        if _e113 {
            phi_8536_ = array<f64, 3>((param_3[0] - ((param_4[0] * _e74) + (param_5[0] * _e78))), (param_3[1] - ((param_4[1] * _e74) + (param_5[1] * _e78))), (param_3[2] - ((param_4[2] * _e74) + (param_5[2] * _e78))));
            phi_8537_ = false;
        } else {
            phi_8536_ = array<f64, 3>();
            phi_8537_ = true;
        }
        let _e138 = phi_8536_;
        let _e140 = phi_8537_;
        phi_8538_ = _e138;
        phi_8539_ = _e140;
    } else {
        phi_8538_ = array<f64, 3>();
        phi_8539_ = true;
    }
    let _e142 = phi_8538_;
    let _e144 = phi_8539_;
    if _e144 {
        let _e147 = (param_3[0] - param_4[0]);
        let _e150 = (param_3[1] - param_4[1]);
        let _e153 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e307 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e307 > f64(0f)) {
                if (_e307 < f64(1f)) {
                    phi_8590_ = _e307;
                } else {
                    phi_8590_ = f64(1f);
                }
                let _e315 = phi_8590_;
                phi_8592_ = _e315;
            } else {
                phi_8592_ = f64(0f);
            }
            let _e317 = phi_8592_;
            let _e353 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e353 > f64(0f)) {
                if (_e353 < f64(1f)) {
                    phi_8640_ = _e353;
                } else {
                    phi_8640_ = f64(1f);
                }
                let _e361 = phi_8640_;
                phi_8642_ = _e361;
            } else {
                phi_8642_ = f64(0f);
            }
            let _e363 = phi_8642_;
            let _e396 = ((((_e147 * param_5[0]) + (_e150 * param_5[1])) + (_e153 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e396 > f64(0f)) {
                if (_e396 < f64(1f)) {
                    phi_8687_ = _e396;
                } else {
                    phi_8687_ = f64(1f);
                }
                let _e404 = phi_8687_;
                phi_8689_ = _e404;
            } else {
                phi_8689_ = f64(0f);
            }
            let _e406 = phi_8689_;
            let _e419 = (param_3[0] - param_5[0]);
            let _e422 = (param_3[1] - param_5[1]);
            let _e425 = (param_3[2] - param_5[2]);
            let _e445 = ((((_e419 * param_4[0]) + (_e422 * param_4[1])) + (_e425 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e445 > f64(0f)) {
                if (_e445 < f64(1f)) {
                    phi_8740_ = _e445;
                } else {
                    phi_8740_ = f64(1f);
                }
                let _e453 = phi_8740_;
                phi_8742_ = _e453;
            } else {
                phi_8742_ = f64(0f);
            }
            let _e455 = phi_8742_;
            phi_8896_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e317)), (param_3[1] - (param_4[1] * _e317)), (param_3[2] - (param_4[2] * _e317))), array<f64, 3>((param_3[0] - (param_5[0] * _e363)), (param_3[1] - (param_5[1] * _e363)), (param_3[2] - (param_5[2] * _e363))), array<f64, 3>((_e147 - (param_5[0] * _e406)), (_e150 - (param_5[1] * _e406)), (_e153 - (param_5[2] * _e406))), array<f64, 3>((_e419 - (param_4[0] * _e455)), (_e422 - (param_4[1] * _e455)), (_e425 - (param_4[2] * _e455))));
        } else {
            let _e157 = (param_5[0] - param_4[0]);
            let _e160 = (param_5[1] - param_4[1]);
            let _e163 = (param_5[2] - param_4[2]);
            let _e174 = ((((_e147 * _e157) + (_e150 * _e160)) + (_e153 * _e163)) / (((_e157 * _e157) + (_e160 * _e160)) + (_e163 * _e163)));
            if (_e174 > f64(0f)) {
                if (_e174 < f64(1f)) {
                    phi_8785_ = _e174;
                } else {
                    phi_8785_ = f64(1f);
                }
                let _e182 = phi_8785_;
                phi_8787_ = _e182;
            } else {
                phi_8787_ = f64(0f);
            }
            let _e184 = phi_8787_;
            let _e191 = array<f64, 3>((_e147 - (_e157 * _e184)), (_e150 - (_e160 * _e184)), (_e153 - (_e163 * _e184)));
            let _e214 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e214 > f64(0f)) {
                if (_e214 < f64(1f)) {
                    phi_8829_ = _e214;
                } else {
                    phi_8829_ = f64(1f);
                }
                let _e222 = phi_8829_;
                phi_8831_ = _e222;
            } else {
                phi_8831_ = f64(0f);
            }
            let _e224 = phi_8831_;
            let _e260 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e260 > f64(0f)) {
                if (_e260 < f64(1f)) {
                    phi_8879_ = _e260;
                } else {
                    phi_8879_ = f64(1f);
                }
                let _e268 = phi_8879_;
                phi_8881_ = _e268;
            } else {
                phi_8881_ = f64(0f);
            }
            let _e270 = phi_8881_;
            phi_8896_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e224)), (param_3[1] - (param_4[1] * _e224)), (param_3[2] - (param_4[2] * _e224))), array<f64, 3>((param_3[0] - (param_5[0] * _e270)), (param_3[1] - (param_5[1] * _e270)), (param_3[2] - (param_5[2] * _e270))), _e191, _e191);
        }
        let _e468 = phi_8896_;
        let _e471 = function_1(_e468[0], _e468[1]);
        let _e473 = function_1(_e471, _e468[2]);
        let _e475 = function_1(_e473, _e468[3]);
        phi_8904_ = _e475;
    } else {
        phi_8904_ = _e142;
    }
    let _e477 = phi_8904_;
    return _e477;
}

fn function_3(param_7: array<f32, 3>) -> array<f64, 3> {
    return array<f64, 3>(f64(param_7[0]), f64(param_7[1]), f64(param_7[2]));
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_32;
    var local_1: type_32;
    var local_2: type_33;
    var local_3: type_33;
    var local_4: type_33;
    var local_5: array<type_34, 4>;
    var local_6: array<f64, 4>;
    var local_7: array<f64, 2>;
    var local_8: array<f64, 4>;
    var local_9: type_32;
    var local_10: type_32;
    var local_11: array<f32, 3>;
    var local_12: type_38;
    var phi_234_: u32;
    var phi_250_: u32;
    var phi_271_: u32;
    var phi_272_: u32;
    var phi_275_: type_19;
    var phi_276_: type_19;
    var phi_299_: type_19;
    var phi_558_: type_40;
    var phi_652_: f64;
    var phi_658_: f64;
    var phi_663_: f64;
    var phi_669_: f64;
    var phi_674_: f64;
    var phi_680_: f64;
    var phi_686_: f64;
    var phi_691_: f64;
    var phi_697_: f64;
    var phi_702_: f64;
    var phi_707_: f64;
    var phi_714_: f64;
    var phi_720_: f64;
    var phi_725_: f64;
    var phi_731_: f64;
    var phi_736_: f64;
    var phi_742_: f64;
    var phi_748_: f64;
    var phi_753_: f64;
    var phi_759_: f64;
    var phi_764_: f64;
    var phi_769_: f64;
    var phi_776_: f64;
    var phi_782_: f64;
    var phi_787_: f64;
    var phi_793_: f64;
    var phi_798_: f64;
    var phi_804_: f64;
    var phi_810_: f64;
    var phi_815_: f64;
    var phi_821_: f64;
    var phi_826_: f64;
    var phi_831_: f64;
    var phi_837_: f64;
    var phi_842_: f64;
    var phi_851_: bool;
    var phi_875_: u64;
    var phi_887_: f64;
    var phi_888_: f64;
    var phi_919_: type_41;
    var phi_920_: bool;
    var phi_921_: type_41;
    var phi_922_: bool;
    var phi_923_: type_41;
    var phi_924_: bool;
    var phi_929_: type_41;
    var phi_1211_: f64;
    var phi_1218_: f64;
    var phi_1223_: f64;
    var phi_1230_: f64;
    var phi_1235_: f64;
    var phi_1248_: f64;
    var phi_1255_: f64;
    var phi_1260_: f64;
    var phi_1267_: f64;
    var phi_1272_: f64;
    var phi_1277_: f64;
    var phi_1294_: f64;
    var phi_1301_: f64;
    var phi_1306_: f64;
    var phi_1313_: f64;
    var phi_1318_: f64;
    var phi_1332_: f64;
    var phi_1339_: f64;
    var phi_1344_: f64;
    var phi_1351_: f64;
    var phi_1356_: f64;
    var phi_1361_: f64;
    var phi_1378_: f64;
    var phi_1385_: f64;
    var phi_1390_: f64;
    var phi_1397_: f64;
    var phi_1402_: f64;
    var phi_1416_: f64;
    var phi_1423_: f64;
    var phi_1428_: f64;
    var phi_1435_: f64;
    var phi_1440_: f64;
    var phi_1445_: f64;
    var phi_1482_: f64;
    var phi_1488_: f64;
    var phi_1495_: f64;
    var phi_1502_: f64;
    var phi_1508_: f64;
    var phi_1515_: f64;
    var phi_1521_: f64;
    var phi_1527_: f64;
    var phi_1533_: f64;
    var phi_1540_: f64;
    var phi_1547_: f64;
    var phi_1575_: f64;
    var phi_1580_: f64;
    var phi_1585_: f64;
    var phi_1590_: f64;
    var phi_1595_: f64;
    var phi_1600_: f64;
    var phi_1611_: f64;
    var phi_4308_: f64;
    var phi_4314_: f64;
    var phi_4319_: f64;
    var phi_4325_: f64;
    var phi_4331_: f64;
    var phi_4336_: f64;
    var phi_4341_: f64;
    var phi_4351_: bool;
    var phi_4358_: f64;
    var phi_4366_: f64;
    var phi_4409_: type_17;
    var phi_4412_: f64;
    var phi_4433_: bool;
    var phi_4439_: type_18;
    var phi_4410_: type_17;
    var phi_4453_: type_18;
    var phi_4413_: f64;
    var local_13: f64;
    var phi_4402_: f64;
    var phi_4466_: f64;
    var phi_4472_: f64;
    var phi_4497_: type_19;
    var phi_4500_: u32;
    var phi_4498_: type_19;
    var phi_4523_: type_19;
    var phi_4567_: u32;
    var phi_4568_: u32;
    var phi_4501_: u32;
    var phi_4569_: u32;
    var phi_4589_: type_19;
    var phi_4590_: type_19;
    var phi_4613_: type_19;
    var phi_4667_: f64;
    var phi_4674_: f64;
    var phi_4686_: bool;
    var phi_4687_: bool;
    var phi_4688_: bool;
    var phi_4689_: bool;
    var phi_4693_: bool;
    var phi_4705_: type_43;
    var phi_4706_: type_43;
    var phi_4707_: bool;
    var phi_4708_: type_43;
    var phi_4709_: bool;
    var phi_4722_: f64;
    var phi_4735_: type_19;
    var phi_4738_: f64;
    var phi_4740_: f64;
    var phi_4742_: f64;
    var phi_4736_: type_19;
    var phi_4765_: type_19;
    var phi_4792_: f64;
    var phi_4793_: f64;
    var phi_4821_: f64;
    var phi_4837_: f64;
    var phi_4844_: bool;
    var phi_4845_: bool;
    var phi_4846_: bool;
    var phi_4852_: f64;
    var phi_4853_: f64;
    var phi_4854_: bool;
    var phi_4739_: f64;
    var phi_4741_: f64;
    var phi_4743_: f64;
    var phi_4855_: f64;
    var phi_4856_: bool;
    var phi_4857_: bool;
    var local_14: bool;
    var phi_4861_: f64;
    var phi_4862_: f64;
    var phi_4872_: f64;
    var phi_4877_: type_19;
    var phi_4880_: f64;
    var phi_4878_: type_19;
    var phi_4903_: type_19;
    var phi_4934_: f64;
    var phi_4935_: bool;
    var phi_4936_: f64;
    var phi_4937_: bool;
    var phi_4938_: bool;
    var phi_4939_: bool;
    var phi_4940_: f64;
    var phi_4881_: f64;
    var phi_4941_: bool;
    var phi_4942_: bool;
    var phi_4943_: bool;
    var phi_4944_: bool;
    var local_15: bool;
    var phi_4948_: bool;
    var phi_4949_: bool;
    var phi_4953_: bool;
    var phi_4957_: f64;
    var phi_4958_: f64;
    var phi_4960_: type_43;
    var phi_4991_: f64;
    var phi_4998_: f64;
    var phi_5003_: f64;
    var phi_5010_: f64;
    var phi_5015_: f64;
    var phi_5028_: f64;
    var phi_5035_: f64;
    var phi_5040_: f64;
    var phi_5047_: f64;
    var phi_5052_: f64;
    var phi_5057_: f64;
    var phi_5116_: f64;
    var phi_5122_: f64;
    var phi_5127_: f64;
    var phi_5133_: f64;
    var phi_5138_: f64;
    var phi_5152_: f64;
    var phi_5158_: f64;
    var phi_5163_: f64;
    var phi_5169_: f64;
    var phi_5174_: f64;
    var phi_5200_: f64;
    var phi_5207_: f64;
    var phi_5212_: f64;
    var phi_5219_: f64;
    var phi_5224_: f64;
    var phi_5237_: f64;
    var phi_5244_: f64;
    var phi_5249_: f64;
    var phi_5256_: f64;
    var phi_5261_: f64;
    var phi_5266_: f64;
    var phi_5325_: f64;
    var phi_5331_: f64;
    var phi_5336_: f64;
    var phi_5342_: f64;
    var phi_5347_: f64;
    var phi_5361_: f64;
    var phi_5367_: f64;
    var phi_5372_: f64;
    var phi_5378_: f64;
    var phi_5383_: f64;
    var phi_5409_: f64;
    var phi_5416_: f64;
    var phi_5421_: f64;
    var phi_5428_: f64;
    var phi_5433_: f64;
    var phi_5446_: f64;
    var phi_5453_: f64;
    var phi_5458_: f64;
    var phi_5465_: f64;
    var phi_5470_: f64;
    var phi_5475_: f64;
    var phi_5534_: f64;
    var phi_5540_: f64;
    var phi_5545_: f64;
    var phi_5551_: f64;
    var phi_5556_: f64;
    var phi_5570_: f64;
    var phi_5576_: f64;
    var phi_5581_: f64;
    var phi_5587_: f64;
    var phi_5592_: f64;
    var phi_5641_: f64;
    var phi_5647_: f64;
    var phi_5675_: f64;
    var phi_5681_: f64;
    var phi_5686_: u32;
    var phi_5687_: u32;
    var phi_5657_: f64;
    var phi_5663_: f64;
    var phi_5668_: u32;
    var phi_5669_: u32;
    var phi_5688_: u32;
    var phi_5689_: u32;
    var phi_5762_: f64;
    var phi_5774_: f64;
    var phi_5917_: f64;
    var phi_5923_: f64;
    var phi_5930_: f64;
    var phi_5974_: type_19;
    var phi_5977_: bool;
    var phi_5975_: type_19;
    var phi_6000_: type_19;
    var phi_6027_: bool;
    var phi_6028_: bool;
    var phi_5978_: bool;
    var phi_6029_: bool;
    var phi_6030_: bool;
    var local_16: bool;
    var phi_6034_: bool;
    var local_17: bool;
    var phi_6041_: u32;
    var phi_6042_: u32;
    var phi_6043_: bool;
    var phi_6044_: u32;
    var phi_6045_: u32;
    var phi_6046_: bool;
    var phi_6050_: u32;
    var phi_6071_: bool;
    var phi_6072_: bool;
    var phi_6073_: bool;
    var phi_6222_: f64;
    var phi_6229_: f64;
    var phi_6234_: f64;
    var phi_6241_: f64;
    var phi_6246_: f64;
    var phi_6259_: f64;
    var phi_6266_: f64;
    var phi_6271_: f64;
    var phi_6278_: f64;
    var phi_6283_: f64;
    var phi_6288_: f64;
    var phi_6305_: f64;
    var phi_6312_: f64;
    var phi_6317_: f64;
    var phi_6324_: f64;
    var phi_6329_: f64;
    var phi_6343_: f64;
    var phi_6350_: f64;
    var phi_6355_: f64;
    var phi_6362_: f64;
    var phi_6367_: f64;
    var phi_6372_: f64;
    var phi_6389_: f64;
    var phi_6396_: f64;
    var phi_6401_: f64;
    var phi_6408_: f64;
    var phi_6413_: f64;
    var phi_6427_: f64;
    var phi_6434_: f64;
    var phi_6439_: f64;
    var phi_6446_: f64;
    var phi_6451_: f64;
    var phi_6456_: f64;
    var phi_6500_: type_19;
    var phi_6503_: f64;
    var phi_6505_: f64;
    var phi_6507_: f64;
    var phi_6501_: type_19;
    var phi_6530_: type_19;
    var phi_6642_: f64;
    var phi_6649_: f64;
    var phi_6657_: f64;
    var phi_6703_: type_17;
    var phi_6706_: f64;
    var phi_6727_: bool;
    var phi_6733_: type_18;
    var phi_6704_: type_17;
    var phi_6747_: type_18;
    var phi_6707_: f64;
    var local_18: f64;
    var phi_6696_: f64;
    var phi_6760_: f64;
    var phi_6829_: f64;
    var phi_6835_: f64;
    var phi_6844_: f64;
    var phi_6850_: f64;
    var phi_6859_: f64;
    var phi_6865_: f64;
    var phi_6874_: f64;
    var phi_6880_: f64;
    var phi_6886_: type_32;
    var phi_6887_: bool;
    var phi_6888_: type_32;
    var phi_6889_: bool;
    var phi_6899_: type_32;
    var phi_7070_: bool;
    var phi_7071_: bool;
    var phi_7072_: bool;
    var phi_7073_: bool;
    var phi_7074_: bool;
    var phi_7075_: bool;
    var phi_7079_: bool;
    var phi_7377_: bool;
    var phi_7378_: bool;
    var phi_7379_: bool;
    var phi_7380_: bool;
    var phi_7381_: bool;
    var phi_7382_: bool;
    var phi_7386_: bool;
    var phi_7390_: bool;
    var phi_7402_: bool;
    var phi_7403_: bool;
    var phi_7477_: bool;
    var phi_7478_: bool;
    var phi_7501_: f64;
    var phi_7502_: bool;
    var phi_7503_: f64;
    var phi_7504_: bool;
    var phi_7505_: f64;
    var phi_7506_: bool;
    var phi_7507_: bool;
    var phi_7512_: f64;
    var phi_7513_: bool;
    var phi_7517_: f64;
    var phi_7549_: bool;
    var phi_7550_: bool;
    var phi_7573_: f64;
    var phi_7574_: bool;
    var phi_7575_: f64;
    var phi_7576_: bool;
    var phi_7577_: f64;
    var phi_7578_: bool;
    var phi_7579_: bool;
    var phi_7584_: f64;
    var phi_7585_: bool;
    var phi_7589_: f64;
    var phi_7594_: f64;
    var phi_7626_: bool;
    var phi_7627_: bool;
    var phi_7650_: f64;
    var phi_7651_: bool;
    var phi_7652_: f64;
    var phi_7653_: bool;
    var phi_7654_: f64;
    var phi_7655_: bool;
    var phi_7656_: bool;
    var phi_7661_: f64;
    var phi_7662_: bool;
    var phi_7666_: f64;
    var phi_7698_: bool;
    var phi_7699_: bool;
    var phi_7722_: f64;
    var phi_7723_: bool;
    var phi_7724_: f64;
    var phi_7725_: bool;
    var phi_7726_: f64;
    var phi_7727_: bool;
    var phi_7728_: bool;
    var phi_7733_: f64;
    var phi_7734_: bool;
    var phi_7738_: f64;
    var phi_7743_: f64;
    var phi_7748_: f64;
    var phi_7753_: f64;
    var phi_7764_: f64;
    var phi_7765_: f64;
    var phi_7766_: bool;
    var phi_7767_: f64;
    var phi_7768_: f64;
    var phi_7769_: bool;
    var phi_7770_: bool;
    var phi_7771_: bool;
    var phi_7772_: f64;
    var phi_7773_: f64;
    var phi_7774_: bool;
    var phi_7775_: bool;
    var phi_7776_: bool;
    var phi_7777_: bool;
    var phi_7778_: f64;
    var phi_7779_: f64;
    var phi_7780_: bool;
    var phi_7781_: bool;
    var phi_7782_: bool;
    var phi_7783_: bool;
    var phi_7863_: f64;
    var phi_7936_: f64;
    var phi_7941_: f64;
    var phi_8014_: f64;
    var phi_8087_: f64;
    var phi_8092_: f64;
    var phi_8113_: f64;
    var phi_8114_: f64;
    var phi_8115_: f64;
    var phi_8117_: f64;
    var phi_8118_: bool;
    var phi_8119_: f64;
    var phi_8120_: f64;
    var phi_8121_: f64;
    var phi_8122_: bool;
    var phi_8123_: bool;
    var phi_8124_: bool;
    var phi_8125_: bool;
    var phi_8134_: f64;
    var phi_8139_: f64;
    var phi_8150_: bool;
    var phi_8154_: bool;
    var phi_8155_: f64;
    var phi_8156_: bool;
    var phi_8157_: bool;
    var phi_8158_: bool;
    var phi_8159_: bool;
    var phi_8160_: bool;
    var phi_6504_: f64;
    var phi_6506_: f64;
    var phi_6508_: f64;
    var phi_8161_: f64;
    var phi_8162_: bool;
    var phi_8163_: bool;
    var phi_8164_: bool;
    var phi_8165_: bool;
    var phi_8166_: bool;
    var phi_8167_: bool;
    var local_19: bool;
    var phi_8171_: f64;
    var phi_8172_: bool;
    var phi_8173_: bool;
    var phi_8174_: bool;
    var phi_8175_: bool;
    var phi_8180_: type_42;
    var phi_8181_: bool;
    var phi_8182_: bool;
    var phi_8183_: bool;
    var local_20: f64;
    var phi_8188_: type_42;
    var phi_8189_: bool;
    var phi_8190_: bool;
    var phi_8195_: type_42;
    var phi_8196_: bool;
    var phi_8197_: bool;
    var phi_8202_: type_42;
    var phi_8203_: bool;
    var phi_8207_: type_42;
    var phi_8214_: bool;
    var phi_8215_: f64;
    var phi_8216_: bool;
    var phi_8217_: bool;
    var phi_8218_: bool;
    var phi_8219_: f64;
    var phi_8220_: bool;
    var phi_8221_: bool;
    var phi_8222_: bool;
    var phi_8223_: f64;
    var phi_8224_: bool;
    var phi_8225_: bool;
    var phi_8226_: bool;
    var phi_8227_: bool;
    var phi_8231_: bool;
    var phi_8232_: bool;
    var phi_8233_: bool;
    var phi_8234_: f64;
    var phi_8235_: type_43;
    var phi_8236_: bool;
    var phi_8237_: bool;
    var phi_8238_: bool;
    var phi_8239_: bool;
    var local_21: bool;
    var phi_8244_: type_42;
    var phi_8245_: bool;
    var phi_8246_: bool;
    var local_22: f64;
    var phi_8251_: type_42;
    var phi_8252_: bool;
    var local_23: type_43;
    var phi_8258_: type_42;
    var phi_8259_: bool;
    var phi_8263_: type_42;
    var phi_1768_: f64;
    var phi_1775_: f64;
    var phi_1780_: f64;
    var phi_1787_: f64;
    var phi_1792_: f64;
    var phi_1805_: f64;
    var phi_1812_: f64;
    var phi_1817_: f64;
    var phi_1824_: f64;
    var phi_1829_: f64;
    var phi_1834_: f64;
    var phi_1851_: f64;
    var phi_1858_: f64;
    var phi_1863_: f64;
    var phi_1870_: f64;
    var phi_1875_: f64;
    var phi_1889_: f64;
    var phi_1896_: f64;
    var phi_1901_: f64;
    var phi_1908_: f64;
    var phi_1913_: f64;
    var phi_1918_: f64;
    var phi_1935_: f64;
    var phi_1942_: f64;
    var phi_1947_: f64;
    var phi_1954_: f64;
    var phi_1959_: f64;
    var phi_1973_: f64;
    var phi_1980_: f64;
    var phi_1985_: f64;
    var phi_1992_: f64;
    var phi_1997_: f64;
    var phi_2002_: f64;
    var phi_2046_: type_19;
    var phi_2049_: f64;
    var phi_2051_: f64;
    var phi_2053_: f64;
    var phi_2047_: type_19;
    var phi_2076_: type_19;
    var phi_2188_: f64;
    var phi_2195_: f64;
    var phi_2203_: f64;
    var phi_2249_: type_17;
    var phi_2252_: f64;
    var phi_2273_: bool;
    var phi_2279_: type_18;
    var phi_2250_: type_17;
    var phi_2293_: type_18;
    var phi_2253_: f64;
    var local_24: f64;
    var phi_2242_: f64;
    var phi_2306_: f64;
    var phi_2375_: f64;
    var phi_2381_: f64;
    var phi_2390_: f64;
    var phi_2396_: f64;
    var phi_2405_: f64;
    var phi_2411_: f64;
    var phi_2420_: f64;
    var phi_2426_: f64;
    var phi_2432_: type_32;
    var phi_2433_: bool;
    var phi_2434_: type_32;
    var phi_2435_: bool;
    var phi_2445_: type_32;
    var phi_2616_: bool;
    var phi_2617_: bool;
    var phi_2618_: bool;
    var phi_2619_: bool;
    var phi_2620_: bool;
    var phi_2621_: bool;
    var phi_2625_: bool;
    var phi_2923_: bool;
    var phi_2924_: bool;
    var phi_2925_: bool;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var phi_2928_: bool;
    var phi_2932_: bool;
    var phi_2936_: bool;
    var phi_2948_: bool;
    var phi_2949_: bool;
    var phi_3023_: bool;
    var phi_3024_: bool;
    var phi_3047_: f64;
    var phi_3048_: bool;
    var phi_3049_: f64;
    var phi_3050_: bool;
    var phi_3051_: f64;
    var phi_3052_: bool;
    var phi_3053_: bool;
    var phi_3058_: f64;
    var phi_3059_: bool;
    var phi_3063_: f64;
    var phi_3095_: bool;
    var phi_3096_: bool;
    var phi_3119_: f64;
    var phi_3120_: bool;
    var phi_3121_: f64;
    var phi_3122_: bool;
    var phi_3123_: f64;
    var phi_3124_: bool;
    var phi_3125_: bool;
    var phi_3130_: f64;
    var phi_3131_: bool;
    var phi_3135_: f64;
    var phi_3140_: f64;
    var phi_3172_: bool;
    var phi_3173_: bool;
    var phi_3196_: f64;
    var phi_3197_: bool;
    var phi_3198_: f64;
    var phi_3199_: bool;
    var phi_3200_: f64;
    var phi_3201_: bool;
    var phi_3202_: bool;
    var phi_3207_: f64;
    var phi_3208_: bool;
    var phi_3212_: f64;
    var phi_3244_: bool;
    var phi_3245_: bool;
    var phi_3268_: f64;
    var phi_3269_: bool;
    var phi_3270_: f64;
    var phi_3271_: bool;
    var phi_3272_: f64;
    var phi_3273_: bool;
    var phi_3274_: bool;
    var phi_3279_: f64;
    var phi_3280_: bool;
    var phi_3284_: f64;
    var phi_3289_: f64;
    var phi_3294_: f64;
    var phi_3299_: f64;
    var phi_3310_: f64;
    var phi_3311_: f64;
    var phi_3312_: bool;
    var phi_3313_: f64;
    var phi_3314_: f64;
    var phi_3315_: bool;
    var phi_3316_: bool;
    var phi_3317_: bool;
    var phi_3318_: f64;
    var phi_3319_: f64;
    var phi_3320_: bool;
    var phi_3321_: bool;
    var phi_3322_: bool;
    var phi_3323_: bool;
    var phi_3324_: f64;
    var phi_3325_: f64;
    var phi_3326_: bool;
    var phi_3327_: bool;
    var phi_3328_: bool;
    var phi_3329_: bool;
    var phi_3409_: f64;
    var phi_3482_: f64;
    var phi_3487_: f64;
    var phi_3560_: f64;
    var phi_3633_: f64;
    var phi_3638_: f64;
    var phi_3659_: f64;
    var phi_3660_: f64;
    var phi_3661_: f64;
    var phi_3663_: f64;
    var phi_3664_: bool;
    var phi_3665_: f64;
    var phi_3666_: f64;
    var phi_3667_: f64;
    var phi_3668_: bool;
    var phi_3669_: bool;
    var phi_3670_: bool;
    var phi_3671_: bool;
    var phi_3680_: f64;
    var phi_3685_: f64;
    var phi_3696_: bool;
    var phi_3700_: bool;
    var phi_3701_: f64;
    var phi_3702_: bool;
    var phi_3703_: bool;
    var phi_3704_: bool;
    var phi_3705_: bool;
    var phi_3706_: bool;
    var phi_2050_: f64;
    var phi_2052_: f64;
    var phi_2054_: f64;
    var phi_3707_: f64;
    var phi_3708_: bool;
    var phi_3709_: bool;
    var phi_3710_: bool;
    var phi_3711_: bool;
    var phi_3712_: bool;
    var phi_3713_: bool;
    var local_25: bool;
    var phi_3717_: f64;
    var phi_3718_: bool;
    var phi_3719_: bool;
    var phi_3720_: bool;
    var phi_3721_: bool;
    var phi_3726_: type_42;
    var phi_3727_: bool;
    var phi_3728_: bool;
    var phi_3729_: bool;
    var local_26: f64;
    var phi_3734_: type_42;
    var phi_3735_: bool;
    var phi_3736_: bool;
    var phi_3741_: type_42;
    var phi_3742_: bool;
    var phi_3743_: bool;
    var phi_3748_: type_42;
    var phi_3749_: bool;
    var phi_3753_: type_42;
    var phi_3767_: type_19;
    var phi_3768_: type_19;
    var phi_3791_: type_19;
    var phi_3812_: f64;
    var phi_3942_: type_17;
    var phi_3945_: f64;
    var phi_3966_: bool;
    var phi_3972_: type_18;
    var phi_3943_: type_17;
    var phi_3986_: type_18;
    var phi_3946_: f64;
    var local_27: f64;
    var phi_3935_: f64;
    var phi_3999_: f64;
    var phi_4017_: f64;
    var phi_4024_: f64;
    var phi_4029_: f64;
    var phi_4036_: f64;
    var phi_4041_: f64;
    var phi_4054_: f64;
    var phi_4061_: f64;
    var phi_4066_: f64;
    var phi_4073_: f64;
    var phi_4078_: f64;
    var phi_4083_: f64;
    var phi_4100_: f64;
    var phi_4107_: f64;
    var phi_4112_: f64;
    var phi_4119_: f64;
    var phi_4124_: f64;
    var phi_4138_: f64;
    var phi_4145_: f64;
    var phi_4150_: f64;
    var phi_4157_: f64;
    var phi_4162_: f64;
    var phi_4167_: f64;
    var phi_4184_: f64;
    var phi_4191_: f64;
    var phi_4196_: f64;
    var phi_4203_: f64;
    var phi_4208_: f64;
    var phi_4222_: f64;
    var phi_4229_: f64;
    var phi_4234_: f64;
    var phi_4241_: f64;
    var phi_4246_: f64;
    var phi_4251_: f64;
    var phi_4275_: bool;
    var phi_4276_: bool;
    var phi_4277_: bool;
    var local_28: bool;
    var phi_4282_: type_42;
    var phi_4283_: bool;
    var phi_4288_: type_42;
    var phi_4289_: bool;
    var phi_4291_: type_42;
    var phi_4292_: type_42;
    var phi_4293_: bool;
    var phi_4297_: type_42;
    var phi_8267_: type_42;
    var phi_8268_: type_42;
    var phi_8281_: type_30;
    var phi_8304_: u32;
    var phi_8308_: type_29;
    var phi_8309_: bool;
    var phi_8327_: u32;
    var local_29: u32;
    var local_30: f64;
    var local_31: f64;
    var local_32: bool;
    var local_33: bool;
    var local_34: f64;
    var local_35: f64;
    var local_36: f64;
    var local_37: bool;
    var local_38: bool;
    var local_39: bool;
    var local_40: bool;
    var local_41: bool;
    var local_42: bool;
    var local_43: f64;
    var local_44: f64;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e108 = id_2;
    let _e109 = n_2;
    let _e110 = lane_2;
    let _e122 = ((_e108.y * _e109.x) + _e108.x);
    let _e125 = (_e109.x * _e109.y);
    let _e127 = params.member.member_15;
    let _e129 = input.member[0u];
    if (_e127 < _e129) {
        phi_234_ = _e127;
    } else {
        phi_234_ = _e129;
    }
    let _e132 = phi_234_;
    let _e133 = (_e132 / 64u);
    if ((_e132 % 64u) > 0u) {
        phi_250_ = (_e133 + 1u);
    } else {
        phi_250_ = _e133;
    }
    let _e138 = phi_250_;
    if (_e138 > _e122) {
        let _e140 = (_e138 - _e122);
        if (_e125 == 0u) {
            return;
        }
        let _e142 = (_e140 / _e125);
        if (_e125 == 0u) {
            return;
        }
        if ((_e140 % _e125) > 0u) {
            phi_271_ = (_e142 + 1u);
        } else {
            phi_271_ = _e142;
        }
        let _e148 = phi_271_;
        phi_272_ = _e148;
    } else {
        phi_272_ = 0u;
    }
    let _e150 = phi_272_;
    phi_275_ = type_19(0u, _e150);
    loop {
        let _e153 = phi_275_;
        if (_e153.member < _e153.member_1) {
            phi_276_ = type_19((_e153.member + 1u), _e153.member_1);
            phi_299_ = type_19(1u, _e153.member);
        } else {
            phi_276_ = _e153;
            phi_299_ = type_19(0u, type_19().member_1);
        }
        let _e165 = phi_276_;
        let _e167 = phi_299_;
        let _e171 = (bitcast<i32>(_e167.member) != 0i);
        if _e171 {
            let _e175 = (((_e122 + (_e167.member_1 * _e125)) * 64u) + _e110);
            let _e177 = params.member.member_8;
            if (_e175 < _e132) {
                let _e180 = (2u * _e175);
                let _e183 = input.member[(4u + _e180)];
                let _e186 = input.member[(_e180 + 5u)];
                let _e188 = elements.member[_e183];
                let _e190 = elements.member[_e186];
                let _e196 = params.member.member_1;
                if ((_e196 & 8u) != 0u) {
                    let _e235 = paths.member[_e188[0]];
                    let _e237 = paths.member[_e188[1]];
                    let _e243 = paths.member[_e190[0]];
                    let _e245 = paths.member[_e190[1]];
                    let _e282 = function_3(array<f32, 3>(_e235.member[0], _e235.member[1], _e235.member[2]));
                    let _e283 = function_3(array<f32, 3>(_e237.member[0], _e237.member[1], _e237.member[2]));
                    let _e284 = function_3(array<f32, 3>(_e243.member[0], _e243.member[1], _e243.member[2]));
                    let _e285 = function_3(array<f32, 3>(_e245.member[0], _e245.member[1], _e245.member[2]));
                    let _e287 = function_3(array<f32, 3>(_e235.member_1[0], _e235.member_1[1], _e235.member_1[2]));
                    let _e288 = function_3(array<f32, 3>(_e237.member_1[0], _e237.member_1[1], _e237.member_1[2]));
                    let _e289 = function_3(array<f32, 3>(_e243.member_1[0], _e243.member_1[1], _e243.member_1[2]));
                    let _e290 = function_3(array<f32, 3>(_e245.member_1[0], _e245.member_1[1], _e245.member_1[2]));
                    phi_558_ = type_40(array<array<f64, 3>, 4>(_e282, _e283, _e284, _e285), array<array<f64, 3>, 4>(_e287, _e288, _e289, _e290));
                } else {
                    let _e200 = wide.member[_e188[0]];
                    let _e203 = params.member.member[0u];
                    let _e206 = wide.member[(_e203 + _e188[0])];
                    let _e208 = wide.member[_e188[1]];
                    let _e211 = params.member.member[0u];
                    let _e214 = wide.member[(_e211 + _e188[1])];
                    let _e216 = wide.member[_e190[0]];
                    let _e219 = params.member.member[0u];
                    let _e222 = wide.member[(_e219 + _e190[0])];
                    let _e224 = wide.member[_e190[1]];
                    let _e227 = params.member.member[0u];
                    let _e230 = wide.member[(_e227 + _e190[1])];
                    phi_558_ = type_40(array<array<f64, 3>, 4>(_e200, _e208, _e216, _e224), array<array<f64, 3>, 4>(_e206, _e214, _e222, _e230));
                }
                let _e294 = phi_558_;
                let _e301 = (_e294.member[2][0] - _e294.member[0][0]);
                let _e304 = (_e294.member[2][1] - _e294.member[0][1]);
                let _e307 = (_e294.member[2][2] - _e294.member[0][2]);
                let _e313 = (_e294.member_1[2][0] - _e294.member_1[0][0]);
                let _e316 = (_e294.member_1[2][1] - _e294.member_1[0][1]);
                let _e319 = (_e294.member_1[2][2] - _e294.member_1[0][2]);
                let _e326 = (_e294.member[1][0] - _e294.member[0][0]);
                let _e329 = (_e294.member[1][1] - _e294.member[0][1]);
                let _e332 = (_e294.member[1][2] - _e294.member[0][2]);
                let _e338 = (_e294.member_1[1][0] - _e294.member_1[0][0]);
                let _e341 = (_e294.member_1[1][1] - _e294.member_1[0][1]);
                let _e344 = (_e294.member_1[1][2] - _e294.member_1[0][2]);
                let _e351 = (_e294.member[2][0] - _e294.member[3][0]);
                let _e354 = (_e294.member[2][1] - _e294.member[3][1]);
                let _e357 = (_e294.member[2][2] - _e294.member[3][2]);
                let _e363 = (_e294.member_1[2][0] - _e294.member_1[3][0]);
                let _e366 = (_e294.member_1[2][1] - _e294.member_1[3][1]);
                let _e369 = (_e294.member_1[2][2] - _e294.member_1[3][2]);
                let _e372 = (0.0lf + 0.0lf);
                let _e375 = params.member.member_7;
                let _e382 = bitcast<f64>(((u64(_e375[1]) * 4294967296lu) + u64(_e375[0])));
                if (_e301 < 0.0lf) {
                    phi_652_ = -(_e301);
                } else {
                    phi_652_ = _e301;
                }
                let _e386 = phi_652_;
                if (_e304 < 0.0lf) {
                    phi_658_ = -(_e304);
                } else {
                    phi_658_ = _e304;
                }
                let _e390 = phi_658_;
                if (_e386 > _e390) {
                    phi_663_ = _e386;
                } else {
                    phi_663_ = _e390;
                }
                let _e393 = phi_663_;
                if (_e307 < 0.0lf) {
                    phi_669_ = -(_e307);
                } else {
                    phi_669_ = _e307;
                }
                let _e397 = phi_669_;
                if (_e393 > _e397) {
                    phi_674_ = _e393;
                } else {
                    phi_674_ = _e397;
                }
                let _e400 = phi_674_;
                if (_e313 < 0.0lf) {
                    phi_680_ = -(_e313);
                } else {
                    phi_680_ = _e313;
                }
                let _e404 = phi_680_;
                if (_e316 < 0.0lf) {
                    phi_686_ = -(_e316);
                } else {
                    phi_686_ = _e316;
                }
                let _e408 = phi_686_;
                if (_e404 > _e408) {
                    phi_691_ = _e404;
                } else {
                    phi_691_ = _e408;
                }
                let _e411 = phi_691_;
                if (_e319 < 0.0lf) {
                    phi_697_ = -(_e319);
                } else {
                    phi_697_ = _e319;
                }
                let _e415 = phi_697_;
                if (_e411 > _e415) {
                    phi_702_ = _e411;
                } else {
                    phi_702_ = _e415;
                }
                let _e418 = phi_702_;
                if (_e400 > _e418) {
                    phi_707_ = _e400;
                } else {
                    phi_707_ = _e418;
                }
                let _e421 = phi_707_;
                let _e422 = (_e421 + _e372);
                if (_e326 < 0.0lf) {
                    phi_714_ = -(_e326);
                } else {
                    phi_714_ = _e326;
                }
                let _e426 = phi_714_;
                if (_e329 < 0.0lf) {
                    phi_720_ = -(_e329);
                } else {
                    phi_720_ = _e329;
                }
                let _e430 = phi_720_;
                if (_e426 > _e430) {
                    phi_725_ = _e426;
                } else {
                    phi_725_ = _e430;
                }
                let _e433 = phi_725_;
                if (_e332 < 0.0lf) {
                    phi_731_ = -(_e332);
                } else {
                    phi_731_ = _e332;
                }
                let _e437 = phi_731_;
                if (_e433 > _e437) {
                    phi_736_ = _e433;
                } else {
                    phi_736_ = _e437;
                }
                let _e440 = phi_736_;
                if (_e338 < 0.0lf) {
                    phi_742_ = -(_e338);
                } else {
                    phi_742_ = _e338;
                }
                let _e444 = phi_742_;
                if (_e341 < 0.0lf) {
                    phi_748_ = -(_e341);
                } else {
                    phi_748_ = _e341;
                }
                let _e448 = phi_748_;
                if (_e444 > _e448) {
                    phi_753_ = _e444;
                } else {
                    phi_753_ = _e448;
                }
                let _e451 = phi_753_;
                if (_e344 < 0.0lf) {
                    phi_759_ = -(_e344);
                } else {
                    phi_759_ = _e344;
                }
                let _e455 = phi_759_;
                if (_e451 > _e455) {
                    phi_764_ = _e451;
                } else {
                    phi_764_ = _e455;
                }
                let _e458 = phi_764_;
                if (_e440 > _e458) {
                    phi_769_ = _e440;
                } else {
                    phi_769_ = _e458;
                }
                let _e461 = phi_769_;
                let _e462 = (_e461 + _e372);
                if (_e351 < 0.0lf) {
                    phi_776_ = -(_e351);
                } else {
                    phi_776_ = _e351;
                }
                let _e466 = phi_776_;
                if (_e354 < 0.0lf) {
                    phi_782_ = -(_e354);
                } else {
                    phi_782_ = _e354;
                }
                let _e470 = phi_782_;
                if (_e466 > _e470) {
                    phi_787_ = _e466;
                } else {
                    phi_787_ = _e470;
                }
                let _e473 = phi_787_;
                if (_e357 < 0.0lf) {
                    phi_793_ = -(_e357);
                } else {
                    phi_793_ = _e357;
                }
                let _e477 = phi_793_;
                if (_e473 > _e477) {
                    phi_798_ = _e473;
                } else {
                    phi_798_ = _e477;
                }
                let _e480 = phi_798_;
                if (_e363 < 0.0lf) {
                    phi_804_ = -(_e363);
                } else {
                    phi_804_ = _e363;
                }
                let _e484 = phi_804_;
                if (_e366 < 0.0lf) {
                    phi_810_ = -(_e366);
                } else {
                    phi_810_ = _e366;
                }
                let _e488 = phi_810_;
                if (_e484 > _e488) {
                    phi_815_ = _e484;
                } else {
                    phi_815_ = _e488;
                }
                let _e491 = phi_815_;
                if (_e369 < 0.0lf) {
                    phi_821_ = -(_e369);
                } else {
                    phi_821_ = _e369;
                }
                let _e495 = phi_821_;
                if (_e491 > _e495) {
                    phi_826_ = _e491;
                } else {
                    phi_826_ = _e495;
                }
                let _e498 = phi_826_;
                if (_e480 > _e498) {
                    phi_831_ = _e480;
                } else {
                    phi_831_ = _e498;
                }
                let _e501 = phi_831_;
                let _e502 = (_e501 + _e372);
                if (_e422 > _e462) {
                    phi_837_ = _e422;
                } else {
                    phi_837_ = _e462;
                }
                let _e505 = phi_837_;
                if (_e505 > _e502) {
                    phi_842_ = _e505;
                } else {
                    phi_842_ = _e502;
                }
                let _e508 = phi_842_;
                if (_e508 <= f64(65536f)) {
                    phi_851_ = (_e508 >= f64((1f / 65536f)));
                } else {
                    phi_851_ = false;
                }
                let _e515 = phi_851_;
                if _e515 {
                    phi_923_ = type_41();
                    phi_924_ = true;
                } else {
                    if (_e508 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e508) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e522 = (9214364837600034816lu - (bitcast<u64>(_e508) & 9218868437227405312lu));
                            if (_e522 > 4503599627370496lu) {
                                phi_875_ = _e522;
                            } else {
                                phi_875_ = 4503599627370496lu;
                            }
                            let _e525 = phi_875_;
                            let _e526 = bitcast<f64>(_e525);
                            let _e527 = (_e382 * _e526);
                            if (_e382 > f64(0f)) {
                                if (_e527 > 2.2250738585072014e-308lf) {
                                    phi_887_ = _e527;
                                } else {
                                    phi_887_ = 2.2250738585072014e-308lf;
                                }
                                let _e532 = phi_887_;
                                phi_888_ = _e532;
                            } else {
                                phi_888_ = _e527;
                            }
                            let _e534 = phi_888_;
                            phi_919_ = type_41(type_38(array<array<f64, 3>, 2>(array<f64, 3>((_e301 * _e526), (_e304 * _e526), (_e307 * _e526)), array<f64, 3>((_e313 * _e526), (_e316 * _e526), (_e319 * _e526))), array<array<f64, 3>, 2>(array<f64, 3>((_e326 * _e526), (_e329 * _e526), (_e332 * _e526)), array<f64, 3>((_e338 * _e526), (_e341 * _e526), (_e344 * _e526))), array<array<f64, 3>, 2>(array<f64, 3>((_e351 * _e526), (_e354 * _e526), (_e357 * _e526)), array<f64, 3>((_e363 * _e526), (_e366 * _e526), (_e369 * _e526))), (_e372 * _e526)), _e534);
                            phi_920_ = false;
                        } else {
                            phi_919_ = type_41();
                            phi_920_ = true;
                        }
                        let _e566 = phi_919_;
                        let _e568 = phi_920_;
                        phi_921_ = _e566;
                        phi_922_ = _e568;
                    } else {
                        phi_921_ = type_41();
                        phi_922_ = true;
                    }
                    let _e570 = phi_921_;
                    let _e572 = phi_922_;
                    phi_923_ = _e570;
                    phi_924_ = _e572;
                }
                let _e574 = phi_923_;
                let _e576 = phi_924_;
                if _e576 {
                    phi_929_ = type_41(type_38(array<array<f64, 3>, 2>(array<f64, 3>(_e301, _e304, _e307), array<f64, 3>(_e313, _e316, _e319)), array<array<f64, 3>, 2>(array<f64, 3>(_e326, _e329, _e332), array<f64, 3>(_e338, _e341, _e344)), array<array<f64, 3>, 2>(array<f64, 3>(_e351, _e354, _e357), array<f64, 3>(_e363, _e366, _e369)), _e372), _e382);
                } else {
                    phi_929_ = _e574;
                }
                let _e579 = phi_929_;
                local_12 = type_38(array<array<f64, 3>, 2>(array<f64, 3>(_e579.member.member[0][0], _e579.member.member[0][1], _e579.member.member[0][2]), array<f64, 3>(_e579.member.member[1][0], _e579.member.member[1][1], _e579.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e579.member.member_1[0][0], _e579.member.member_1[0][1], _e579.member.member_1[0][2]), array<f64, 3>(_e579.member.member_1[1][0], _e579.member.member_1[1][1], _e579.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e579.member.member_2[0][0], _e579.member.member_2[0][1], _e579.member.member_2[0][2]), array<f64, 3>(_e579.member.member_2[1][0], _e579.member.member_2[1][1], _e579.member.member_2[1][2])), _e579.member.member_3);
                let _e622 = local_12.member_1[0u];
                let _e628 = local_12.member_2[0u];
                let _e634 = ((_e622[1] * _e628[2]) - (_e622[2] * _e628[1]));
                let _e637 = ((_e622[2] * _e628[0]) - (_e622[0] * _e628[2]));
                let _e640 = ((_e622[0] * _e628[1]) - (_e622[1] * _e628[0]));
                let _e643 = local_12.member_1[1u];
                let _e649 = local_12.member_2[1u];
                let _e655 = ((_e643[1] * _e649[2]) - (_e643[2] * _e649[1]));
                let _e658 = ((_e643[2] * _e649[0]) - (_e643[0] * _e649[2]));
                let _e661 = ((_e643[0] * _e649[1]) - (_e643[1] * _e649[0]));
                let _e664 = local_12.member_1[0u];
                let _e670 = local_12.member_2[1u];
                let _e685 = local_12.member_1[1u];
                let _e691 = local_12.member_2[0u];
                let _e704 = (((_e664[1] * _e670[2]) - (_e664[2] * _e670[1])) + ((_e685[1] * _e691[2]) - (_e685[2] * _e691[1])));
                let _e705 = (((_e664[2] * _e670[0]) - (_e664[0] * _e670[2])) + ((_e685[2] * _e691[0]) - (_e685[0] * _e691[2])));
                let _e706 = (((_e664[0] * _e670[1]) - (_e664[1] * _e670[0])) + ((_e685[0] * _e691[1]) - (_e685[1] * _e691[0])));
                let _e709 = local_12.member[0u];
                let _e717 = (((_e709[0] * _e634) + (_e709[1] * _e637)) + (_e709[2] * _e640));
                let _e720 = local_12.member[1u];
                let _e731 = local_12.member[0u];
                let _e740 = ((((_e720[0] * _e634) + (_e720[1] * _e637)) + (_e720[2] * _e640)) + (((_e731[0] * _e704) + (_e731[1] * _e705)) + (_e731[2] * _e706)));
                let _e743 = local_12.member[0u];
                let _e754 = local_12.member[1u];
                let _e763 = ((((_e743[0] * _e655) + (_e743[1] * _e658)) + (_e743[2] * _e661)) + (((_e754[0] * _e704) + (_e754[1] * _e705)) + (_e754[2] * _e706)));
                let _e766 = local_12.member[1u];
                let _e774 = (((_e766[0] * _e655) + (_e766[1] * _e658)) + (_e766[2] * _e661));
                let _e777 = local_12.member[0u];
                if (_e777[0] < 0.0lf) {
                    phi_1211_ = -(_e777[0]);
                } else {
                    phi_1211_ = _e777[0];
                }
                let _e784 = phi_1211_;
                if (_e777[1] < 0.0lf) {
                    phi_1218_ = -(_e777[1]);
                } else {
                    phi_1218_ = _e777[1];
                }
                let _e788 = phi_1218_;
                if (_e784 > _e788) {
                    phi_1223_ = _e784;
                } else {
                    phi_1223_ = _e788;
                }
                let _e791 = phi_1223_;
                if (_e777[2] < 0.0lf) {
                    phi_1230_ = -(_e777[2]);
                } else {
                    phi_1230_ = _e777[2];
                }
                let _e795 = phi_1230_;
                if (_e791 > _e795) {
                    phi_1235_ = _e791;
                } else {
                    phi_1235_ = _e795;
                }
                let _e798 = phi_1235_;
                let _e801 = local_12.member[1u];
                if (_e801[0] < 0.0lf) {
                    phi_1248_ = -(_e801[0]);
                } else {
                    phi_1248_ = _e801[0];
                }
                let _e808 = phi_1248_;
                if (_e801[1] < 0.0lf) {
                    phi_1255_ = -(_e801[1]);
                } else {
                    phi_1255_ = _e801[1];
                }
                let _e812 = phi_1255_;
                if (_e808 > _e812) {
                    phi_1260_ = _e808;
                } else {
                    phi_1260_ = _e812;
                }
                let _e815 = phi_1260_;
                if (_e801[2] < 0.0lf) {
                    phi_1267_ = -(_e801[2]);
                } else {
                    phi_1267_ = _e801[2];
                }
                let _e819 = phi_1267_;
                if (_e815 > _e819) {
                    phi_1272_ = _e815;
                } else {
                    phi_1272_ = _e819;
                }
                let _e822 = phi_1272_;
                if (_e798 > _e822) {
                    phi_1277_ = _e798;
                } else {
                    phi_1277_ = _e822;
                }
                let _e825 = phi_1277_;
                let _e827 = local_12.member_3;
                let _e828 = (_e825 + _e827);
                let _e831 = local_12.member_1[0u];
                if (_e831[0] < 0.0lf) {
                    phi_1294_ = -(_e831[0]);
                } else {
                    phi_1294_ = _e831[0];
                }
                let _e838 = phi_1294_;
                if (_e831[1] < 0.0lf) {
                    phi_1301_ = -(_e831[1]);
                } else {
                    phi_1301_ = _e831[1];
                }
                let _e842 = phi_1301_;
                if (_e838 > _e842) {
                    phi_1306_ = _e838;
                } else {
                    phi_1306_ = _e842;
                }
                let _e845 = phi_1306_;
                if (_e831[2] < 0.0lf) {
                    phi_1313_ = -(_e831[2]);
                } else {
                    phi_1313_ = _e831[2];
                }
                let _e849 = phi_1313_;
                if (_e845 > _e849) {
                    phi_1318_ = _e845;
                } else {
                    phi_1318_ = _e849;
                }
                let _e852 = phi_1318_;
                let _e855 = local_12.member_1[1u];
                if (_e855[0] < 0.0lf) {
                    phi_1332_ = -(_e855[0]);
                } else {
                    phi_1332_ = _e855[0];
                }
                let _e862 = phi_1332_;
                if (_e855[1] < 0.0lf) {
                    phi_1339_ = -(_e855[1]);
                } else {
                    phi_1339_ = _e855[1];
                }
                let _e866 = phi_1339_;
                if (_e862 > _e866) {
                    phi_1344_ = _e862;
                } else {
                    phi_1344_ = _e866;
                }
                let _e869 = phi_1344_;
                if (_e855[2] < 0.0lf) {
                    phi_1351_ = -(_e855[2]);
                } else {
                    phi_1351_ = _e855[2];
                }
                let _e873 = phi_1351_;
                if (_e869 > _e873) {
                    phi_1356_ = _e869;
                } else {
                    phi_1356_ = _e873;
                }
                let _e876 = phi_1356_;
                if (_e852 > _e876) {
                    phi_1361_ = _e852;
                } else {
                    phi_1361_ = _e876;
                }
                let _e879 = phi_1361_;
                let _e881 = local_12.member_3;
                let _e882 = (_e879 + _e881);
                let _e885 = local_12.member_2[0u];
                if (_e885[0] < 0.0lf) {
                    phi_1378_ = -(_e885[0]);
                } else {
                    phi_1378_ = _e885[0];
                }
                let _e892 = phi_1378_;
                if (_e885[1] < 0.0lf) {
                    phi_1385_ = -(_e885[1]);
                } else {
                    phi_1385_ = _e885[1];
                }
                let _e896 = phi_1385_;
                if (_e892 > _e896) {
                    phi_1390_ = _e892;
                } else {
                    phi_1390_ = _e896;
                }
                let _e899 = phi_1390_;
                if (_e885[2] < 0.0lf) {
                    phi_1397_ = -(_e885[2]);
                } else {
                    phi_1397_ = _e885[2];
                }
                let _e903 = phi_1397_;
                if (_e899 > _e903) {
                    phi_1402_ = _e899;
                } else {
                    phi_1402_ = _e903;
                }
                let _e906 = phi_1402_;
                let _e909 = local_12.member_2[1u];
                if (_e909[0] < 0.0lf) {
                    phi_1416_ = -(_e909[0]);
                } else {
                    phi_1416_ = _e909[0];
                }
                let _e916 = phi_1416_;
                if (_e909[1] < 0.0lf) {
                    phi_1423_ = -(_e909[1]);
                } else {
                    phi_1423_ = _e909[1];
                }
                let _e920 = phi_1423_;
                if (_e916 > _e920) {
                    phi_1428_ = _e916;
                } else {
                    phi_1428_ = _e920;
                }
                let _e923 = phi_1428_;
                if (_e909[2] < 0.0lf) {
                    phi_1435_ = -(_e909[2]);
                } else {
                    phi_1435_ = _e909[2];
                }
                let _e927 = phi_1435_;
                if (_e923 > _e927) {
                    phi_1440_ = _e923;
                } else {
                    phi_1440_ = _e927;
                }
                let _e930 = phi_1440_;
                if (_e906 > _e930) {
                    phi_1445_ = _e906;
                } else {
                    phi_1445_ = _e930;
                }
                let _e933 = phi_1445_;
                let _e935 = local_12.member_3;
                let _e936 = (_e933 + _e935);
                let _e937 = f64(1f);
                let _e938 = f64(8f);
                let _e940 = ((_e882 * _e938) * _e936);
                let _e948 = local_12.member_3;
                if (_e634 < 0.0lf) {
                    phi_1482_ = -(_e634);
                } else {
                    phi_1482_ = _e634;
                }
                let _e968 = phi_1482_;
                if (_e637 < 0.0lf) {
                    phi_1488_ = -(_e637);
                } else {
                    phi_1488_ = _e637;
                }
                let _e972 = phi_1488_;
                if (_e640 < 0.0lf) {
                    phi_1495_ = -(_e640);
                } else {
                    phi_1495_ = _e640;
                }
                let _e977 = phi_1495_;
                let _e978 = ((_e968 + _e972) + _e977);
                if (_e655 < 0.0lf) {
                    phi_1502_ = -(_e655);
                } else {
                    phi_1502_ = _e655;
                }
                let _e982 = phi_1502_;
                if (_e658 < 0.0lf) {
                    phi_1508_ = -(_e658);
                } else {
                    phi_1508_ = _e658;
                }
                let _e986 = phi_1508_;
                if (_e661 < 0.0lf) {
                    phi_1515_ = -(_e661);
                } else {
                    phi_1515_ = _e661;
                }
                let _e991 = phi_1515_;
                let _e992 = ((_e982 + _e986) + _e991);
                if (_e978 > _e992) {
                    phi_1521_ = _e978;
                } else {
                    phi_1521_ = _e992;
                }
                let _e995 = phi_1521_;
                if (_e704 < 0.0lf) {
                    phi_1527_ = -(_e704);
                } else {
                    phi_1527_ = _e704;
                }
                let _e999 = phi_1527_;
                if (_e705 < 0.0lf) {
                    phi_1533_ = -(_e705);
                } else {
                    phi_1533_ = _e705;
                }
                let _e1003 = phi_1533_;
                if (_e706 < 0.0lf) {
                    phi_1540_ = -(_e706);
                } else {
                    phi_1540_ = _e706;
                }
                let _e1008 = phi_1540_;
                let _e1010 = (((_e999 + _e1003) + _e1008) * f64(0.5f));
                if (_e995 > _e1010) {
                    phi_1547_ = _e995;
                } else {
                    phi_1547_ = _e1010;
                }
                let _e1013 = phi_1547_;
                let _e1019 = local_12.member_3;
                let _e1033 = (((((_e828 * _e938) * _e940) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e948 * f64(19f)) * ((_e828 * (_e882 + _e936)) + (_e882 * _e936)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e937 + _e828) * ((_e937 + _e882) * (_e937 + _e936)))));
                let _e1034 = f64(3f);
                let _e1035 = (_e717 * _e1034);
                let _e1036 = (_e774 * _e1034);
                if (_e1035 < _e1036) {
                    phi_1575_ = _e1035;
                } else {
                    phi_1575_ = _e1036;
                }
                let _e1039 = phi_1575_;
                if (_e740 < _e763) {
                    phi_1580_ = _e740;
                } else {
                    phi_1580_ = _e763;
                }
                let _e1042 = phi_1580_;
                if (_e1039 < _e1042) {
                    phi_1585_ = _e1039;
                } else {
                    phi_1585_ = _e1042;
                }
                let _e1045 = phi_1585_;
                if (_e1035 > _e1036) {
                    phi_1590_ = _e1035;
                } else {
                    phi_1590_ = _e1036;
                }
                let _e1048 = phi_1590_;
                if (_e740 > _e763) {
                    phi_1595_ = _e740;
                } else {
                    phi_1595_ = _e763;
                }
                let _e1051 = phi_1595_;
                if (_e1048 > _e1051) {
                    phi_1600_ = _e1048;
                } else {
                    phi_1600_ = _e1051;
                }
                let _e1054 = phi_1600_;
                let _e1060 = -(_e1054);
                if (_e1045 > _e1060) {
                    phi_1611_ = _e1045;
                } else {
                    phi_1611_ = _e1060;
                }
                let _e1063 = phi_1611_;
                if ((_e1063 - (_e1033 + ((_e579.member_1 * (((_e1013 + (_e940 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1019 * f64(6f)) * (_e882 + _e936))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e937 + _e882) * (_e937 + _e936))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                    phi_8268_ = type_42(0u, type_42().member_1);
                } else {
                    if (_e579.member_1 > f64(0f)) {
                        let _e3723 = f64(1f);
                        let _e3724 = f64(0f);
                        let _e3727 = local_12.member[0u];
                        let _e3733 = local_12.member_1[0u];
                        let _e3739 = local_12.member_2[0u];
                        let _e3743 = (_e3727[0] - _e3733[0]);
                        let _e3744 = (_e3727[1] - _e3733[1]);
                        let _e3745 = (_e3727[2] - _e3733[2]);
                        let _e3754 = local_12.member[1u];
                        let _e3760 = local_12.member_1[1u];
                        let _e3766 = local_12.member_2[1u];
                        let _e3770 = (_e3754[0] - _e3760[0]);
                        let _e3771 = (_e3754[1] - _e3760[1]);
                        let _e3772 = (_e3754[2] - _e3760[2]);
                        let _e3781 = local_12.member[0u];
                        if (_e3781[0] < 0.0lf) {
                            phi_1768_ = -(_e3781[0]);
                        } else {
                            phi_1768_ = _e3781[0];
                        }
                        let _e3788 = phi_1768_;
                        if (_e3781[1] < 0.0lf) {
                            phi_1775_ = -(_e3781[1]);
                        } else {
                            phi_1775_ = _e3781[1];
                        }
                        let _e3792 = phi_1775_;
                        if (_e3788 > _e3792) {
                            phi_1780_ = _e3788;
                        } else {
                            phi_1780_ = _e3792;
                        }
                        let _e3795 = phi_1780_;
                        if (_e3781[2] < 0.0lf) {
                            phi_1787_ = -(_e3781[2]);
                        } else {
                            phi_1787_ = _e3781[2];
                        }
                        let _e3799 = phi_1787_;
                        if (_e3795 > _e3799) {
                            phi_1792_ = _e3795;
                        } else {
                            phi_1792_ = _e3799;
                        }
                        let _e3802 = phi_1792_;
                        let _e3805 = local_12.member[1u];
                        if (_e3805[0] < 0.0lf) {
                            phi_1805_ = -(_e3805[0]);
                        } else {
                            phi_1805_ = _e3805[0];
                        }
                        let _e3812 = phi_1805_;
                        if (_e3805[1] < 0.0lf) {
                            phi_1812_ = -(_e3805[1]);
                        } else {
                            phi_1812_ = _e3805[1];
                        }
                        let _e3816 = phi_1812_;
                        if (_e3812 > _e3816) {
                            phi_1817_ = _e3812;
                        } else {
                            phi_1817_ = _e3816;
                        }
                        let _e3819 = phi_1817_;
                        if (_e3805[2] < 0.0lf) {
                            phi_1824_ = -(_e3805[2]);
                        } else {
                            phi_1824_ = _e3805[2];
                        }
                        let _e3823 = phi_1824_;
                        if (_e3819 > _e3823) {
                            phi_1829_ = _e3819;
                        } else {
                            phi_1829_ = _e3823;
                        }
                        let _e3826 = phi_1829_;
                        if (_e3802 > _e3826) {
                            phi_1834_ = _e3802;
                        } else {
                            phi_1834_ = _e3826;
                        }
                        let _e3829 = phi_1834_;
                        let _e3831 = local_12.member_3;
                        let _e3835 = local_12.member_1[0u];
                        if (_e3835[0] < 0.0lf) {
                            phi_1851_ = -(_e3835[0]);
                        } else {
                            phi_1851_ = _e3835[0];
                        }
                        let _e3842 = phi_1851_;
                        if (_e3835[1] < 0.0lf) {
                            phi_1858_ = -(_e3835[1]);
                        } else {
                            phi_1858_ = _e3835[1];
                        }
                        let _e3846 = phi_1858_;
                        if (_e3842 > _e3846) {
                            phi_1863_ = _e3842;
                        } else {
                            phi_1863_ = _e3846;
                        }
                        let _e3849 = phi_1863_;
                        if (_e3835[2] < 0.0lf) {
                            phi_1870_ = -(_e3835[2]);
                        } else {
                            phi_1870_ = _e3835[2];
                        }
                        let _e3853 = phi_1870_;
                        if (_e3849 > _e3853) {
                            phi_1875_ = _e3849;
                        } else {
                            phi_1875_ = _e3853;
                        }
                        let _e3856 = phi_1875_;
                        let _e3859 = local_12.member_1[1u];
                        if (_e3859[0] < 0.0lf) {
                            phi_1889_ = -(_e3859[0]);
                        } else {
                            phi_1889_ = _e3859[0];
                        }
                        let _e3866 = phi_1889_;
                        if (_e3859[1] < 0.0lf) {
                            phi_1896_ = -(_e3859[1]);
                        } else {
                            phi_1896_ = _e3859[1];
                        }
                        let _e3870 = phi_1896_;
                        if (_e3866 > _e3870) {
                            phi_1901_ = _e3866;
                        } else {
                            phi_1901_ = _e3870;
                        }
                        let _e3873 = phi_1901_;
                        if (_e3859[2] < 0.0lf) {
                            phi_1908_ = -(_e3859[2]);
                        } else {
                            phi_1908_ = _e3859[2];
                        }
                        let _e3877 = phi_1908_;
                        if (_e3873 > _e3877) {
                            phi_1913_ = _e3873;
                        } else {
                            phi_1913_ = _e3877;
                        }
                        let _e3880 = phi_1913_;
                        if (_e3856 > _e3880) {
                            phi_1918_ = _e3856;
                        } else {
                            phi_1918_ = _e3880;
                        }
                        let _e3883 = phi_1918_;
                        let _e3885 = local_12.member_3;
                        let _e3889 = local_12.member_2[0u];
                        if (_e3889[0] < 0.0lf) {
                            phi_1935_ = -(_e3889[0]);
                        } else {
                            phi_1935_ = _e3889[0];
                        }
                        let _e3896 = phi_1935_;
                        if (_e3889[1] < 0.0lf) {
                            phi_1942_ = -(_e3889[1]);
                        } else {
                            phi_1942_ = _e3889[1];
                        }
                        let _e3900 = phi_1942_;
                        if (_e3896 > _e3900) {
                            phi_1947_ = _e3896;
                        } else {
                            phi_1947_ = _e3900;
                        }
                        let _e3903 = phi_1947_;
                        if (_e3889[2] < 0.0lf) {
                            phi_1954_ = -(_e3889[2]);
                        } else {
                            phi_1954_ = _e3889[2];
                        }
                        let _e3907 = phi_1954_;
                        if (_e3903 > _e3907) {
                            phi_1959_ = _e3903;
                        } else {
                            phi_1959_ = _e3907;
                        }
                        let _e3910 = phi_1959_;
                        let _e3913 = local_12.member_2[1u];
                        if (_e3913[0] < 0.0lf) {
                            phi_1973_ = -(_e3913[0]);
                        } else {
                            phi_1973_ = _e3913[0];
                        }
                        let _e3920 = phi_1973_;
                        if (_e3913[1] < 0.0lf) {
                            phi_1980_ = -(_e3913[1]);
                        } else {
                            phi_1980_ = _e3913[1];
                        }
                        let _e3924 = phi_1980_;
                        if (_e3920 > _e3924) {
                            phi_1985_ = _e3920;
                        } else {
                            phi_1985_ = _e3924;
                        }
                        let _e3927 = phi_1985_;
                        if (_e3913[2] < 0.0lf) {
                            phi_1992_ = -(_e3913[2]);
                        } else {
                            phi_1992_ = _e3913[2];
                        }
                        let _e3931 = phi_1992_;
                        if (_e3927 > _e3931) {
                            phi_1997_ = _e3927;
                        } else {
                            phi_1997_ = _e3931;
                        }
                        let _e3934 = phi_1997_;
                        if (_e3910 > _e3934) {
                            phi_2002_ = _e3910;
                        } else {
                            phi_2002_ = _e3934;
                        }
                        let _e3937 = phi_2002_;
                        let _e3939 = local_12.member_3;
                        let _e3947 = local_12.member_3;
                        let _e3954 = f64(0f);
                        let _e3955 = f64(1f);
                        local_9 = type_32(array<f64, 4>(_e3954, _e3954, _e3954, _e3954), array<f64, 4>(_e3954, _e3954, _e3954, _e3954), array<f64, 4>(_e3955, _e3955, _e3955, _e3955));
                        phi_2046_ = type_19(0u, 96u);
                        phi_2049_ = _e3724;
                        phi_2051_ = _e3724;
                        phi_2053_ = _e3724;
                        loop {
                            let _e3961 = phi_2046_;
                            let _e3963 = phi_2049_;
                            let _e3965 = phi_2051_;
                            let _e3967 = phi_2053_;
                            local_44 = _e3965;
                            local_26 = _e3963;
                            if (_e3961.member < _e3961.member_1) {
                                phi_2047_ = type_19((_e3961.member + 1u), _e3961.member_1);
                                phi_2076_ = type_19(1u, _e3961.member);
                            } else {
                                phi_2047_ = _e3961;
                                phi_2076_ = type_19(0u, type_19().member_1);
                            }
                            let _e3979 = phi_2047_;
                            let _e3981 = phi_2076_;
                            if (bitcast<i32>(_e3981.member) != 0i) {
                                let _e3988 = local_12.member[0u];
                                let _e3994 = local_12.member[1u];
                                let _e4010 = local_12.member_1[0u];
                                let _e4016 = local_12.member_1[1u];
                                let _e4032 = local_12.member_2[0u];
                                let _e4038 = local_12.member_2[1u];
                                let _e4052 = function_2(array<f64, 3>((_e3988[0] + ((_e3994[0] - _e3988[0]) * _e3963)), (_e3988[1] + ((_e3994[1] - _e3988[1]) * _e3963)), (_e3988[2] + ((_e3994[2] - _e3988[2]) * _e3963))), array<f64, 3>((_e4010[0] + ((_e4016[0] - _e4010[0]) * _e3963)), (_e4010[1] + ((_e4016[1] - _e4010[1]) * _e3963)), (_e4010[2] + ((_e4016[2] - _e4010[2]) * _e3963))), array<f64, 3>((_e4032[0] + ((_e4038[0] - _e4032[0]) * _e3963)), (_e4032[1] + ((_e4038[1] - _e4032[1]) * _e3963)), (_e4032[2] + ((_e4038[2] - _e4032[2]) * _e3963))), 1u);
                                if (_e4052[0] < 0.0lf) {
                                    phi_2188_ = -(_e4052[0]);
                                } else {
                                    phi_2188_ = _e4052[0];
                                }
                                let _e4057 = phi_2188_;
                                if (_e4052[1] < 0.0lf) {
                                    phi_2195_ = -(_e4052[1]);
                                } else {
                                    phi_2195_ = _e4052[1];
                                }
                                let _e4062 = phi_2195_;
                                if (_e4052[2] < 0.0lf) {
                                    phi_2203_ = -(_e4052[2]);
                                } else {
                                    phi_2203_ = _e4052[2];
                                }
                                let _e4068 = phi_2203_;
                                let _e4069 = ((_e4057 + _e4062) + _e4068);
                                if (_e4069 > f64(0f)) {
                                    if ((bitcast<u64>(_e4069) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e4076 = (f64(1f) / _e4069);
                                        let _e4078 = (_e4052[0] * _e4076);
                                        let _e4080 = (_e4052[1] * _e4076);
                                        let _e4082 = (_e4052[2] * _e4076);
                                        let _e4087 = (((_e4078 * _e4078) + (_e4080 * _e4080)) + (_e4082 * _e4082));
                                        if (_e4087 <= 2.2250738585072014e-308lf) {
                                            if (_e4087 > 0.0lf) {
                                                phi_2242_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2242_ = 0.0lf;
                                            }
                                            let _e4139 = phi_2242_;
                                            phi_2306_ = _e4139;
                                        } else {
                                            phi_2249_ = type_17(0i, 5i);
                                            phi_2252_ = bitcast<f64>(((bitcast<u64>(_e4087) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e4094 = phi_2249_;
                                                let _e4096 = phi_2252_;
                                                local_24 = _e4096;
                                                if (_e4094.member < _e4094.member_1) {
                                                    let _e4103 = (_e4094.member + 1i);
                                                    if ((false == (_e4103 > _e4094.member)) != false) {
                                                        phi_2273_ = true;
                                                    } else {
                                                        phi_2273_ = false;
                                                    }
                                                    let _e4108 = phi_2273_;
                                                    if _e4108 {
                                                        phi_2279_ = type_18(0u, type_18().member_1);
                                                    } else {
                                                        phi_2279_ = type_18(1u, _e4103);
                                                    }
                                                    let _e4113 = phi_2279_;
                                                    phi_2250_ = type_17(_e4113.member_1, _e4094.member_1);
                                                    phi_2293_ = type_18(1u, _e4094.member);
                                                } else {
                                                    phi_2250_ = _e4094;
                                                    phi_2293_ = type_18(0u, type_18().member_1);
                                                }
                                                let _e4119 = phi_2250_;
                                                let _e4121 = phi_2293_;
                                                let _e4124 = (bitcast<i32>(_e4121.member) != 0i);
                                                if _e4124 {
                                                    phi_2253_ = (0.5lf * (_e4096 + (_e4087 / _e4096)));
                                                } else {
                                                    phi_2253_ = f64();
                                                }
                                                let _e4129 = phi_2253_;
                                                continue;
                                                continuing {
                                                    phi_2249_ = _e4119;
                                                    phi_2252_ = _e4129;
                                                    break if !(_e4124);
                                                }
                                            }
                                            let _e4134 = local_24;
                                            phi_2306_ = (_e4134 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e4141 = phi_2306_;
                                        let _e4143 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e4150 = ((((((((_e3829 + _e3831) + (_e3883 + _e3885)) + (_e3937 + _e3939)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3947 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e579.member_1 * _e4141) * (f64(1f) + _e4143)));
                                        let _e4155 = (((_e4078 * _e3727[0]) + (_e4080 * _e3727[1])) + (_e4082 * _e3727[2]));
                                        let _e4160 = (((_e4078 * _e3743) + (_e4080 * _e3744)) + (_e4082 * _e3745));
                                        let _e4165 = (((_e4078 * (_e3727[0] - _e3739[0])) + (_e4080 * (_e3727[1] - _e3739[1]))) + (_e4082 * (_e3727[2] - _e3739[2])));
                                        let _e4170 = (((_e4078 * (_e3743 - _e3739[0])) + (_e4080 * (_e3744 - _e3739[1]))) + (_e4082 * (_e3745 - _e3739[2])));
                                        let _e4176 = (((_e4078 * _e3754[0]) + (_e4080 * _e3754[1])) + (_e4082 * _e3754[2]));
                                        let _e4181 = (((_e4078 * _e3770) + (_e4080 * _e3771)) + (_e4082 * _e3772));
                                        let _e4186 = (((_e4078 * (_e3754[0] - _e3766[0])) + (_e4080 * (_e3754[1] - _e3766[1]))) + (_e4082 * (_e3754[2] - _e3766[2])));
                                        let _e4191 = (((_e4078 * (_e3770 - _e3766[0])) + (_e4080 * (_e3771 - _e3766[1]))) + (_e4082 * (_e3772 - _e3766[2])));
                                        if (_e4155 < 0.0lf) {
                                            phi_2375_ = -(_e4155);
                                        } else {
                                            phi_2375_ = _e4155;
                                        }
                                        let _e4196 = phi_2375_;
                                        if (_e4176 < 0.0lf) {
                                            phi_2381_ = -(_e4176);
                                        } else {
                                            phi_2381_ = _e4176;
                                        }
                                        let _e4200 = phi_2381_;
                                        if (_e4160 < 0.0lf) {
                                            phi_2390_ = -(_e4160);
                                        } else {
                                            phi_2390_ = _e4160;
                                        }
                                        let _e4207 = phi_2390_;
                                        if (_e4181 < 0.0lf) {
                                            phi_2396_ = -(_e4181);
                                        } else {
                                            phi_2396_ = _e4181;
                                        }
                                        let _e4211 = phi_2396_;
                                        if (_e4165 < 0.0lf) {
                                            phi_2405_ = -(_e4165);
                                        } else {
                                            phi_2405_ = _e4165;
                                        }
                                        let _e4218 = phi_2405_;
                                        if (_e4186 < 0.0lf) {
                                            phi_2411_ = -(_e4186);
                                        } else {
                                            phi_2411_ = _e4186;
                                        }
                                        let _e4222 = phi_2411_;
                                        if (_e4170 < 0.0lf) {
                                            phi_2420_ = -(_e4170);
                                        } else {
                                            phi_2420_ = _e4170;
                                        }
                                        let _e4229 = phi_2420_;
                                        if (_e4191 < 0.0lf) {
                                            phi_2426_ = -(_e4191);
                                        } else {
                                            phi_2426_ = _e4191;
                                        }
                                        let _e4233 = phi_2426_;
                                        phi_2432_ = type_32(array<f64, 4>(_e4155, _e4160, _e4165, _e4170), array<f64, 4>(_e4176, _e4181, _e4186, _e4191), array<f64, 4>((_e4150 + ((_e4196 + _e4200) * _e4143)), (_e4150 + ((_e4207 + _e4211) * _e4143)), (_e4150 + ((_e4218 + _e4222) * _e4143)), (_e4150 + ((_e4229 + _e4233) * _e4143))));
                                        phi_2433_ = false;
                                    } else {
                                        phi_2432_ = type_32();
                                        phi_2433_ = true;
                                    }
                                    let _e4240 = phi_2432_;
                                    let _e4242 = phi_2433_;
                                    phi_2434_ = _e4240;
                                    phi_2435_ = _e4242;
                                } else {
                                    phi_2434_ = type_32();
                                    phi_2435_ = true;
                                }
                                let _e4244 = phi_2434_;
                                let _e4246 = phi_2435_;
                                if _e4246 {
                                    let _e4247 = f64(0f);
                                    let _e4248 = f64(1f);
                                    phi_2445_ = type_32(array<f64, 4>(_e4247, _e4247, _e4247, _e4247), array<f64, 4>(_e4247, _e4247, _e4247, _e4247), array<f64, 4>(_e4248, _e4248, _e4248, _e4248));
                                } else {
                                    phi_2445_ = _e4244;
                                }
                                let _e4254 = phi_2445_;
                                local_10 = type_32(array<f64, 4>(_e4254.member[0], _e4254.member[1], _e4254.member[2], _e4254.member[3]), array<f64, 4>(_e4254.member_1[0], _e4254.member_1[1], _e4254.member_1[2], _e4254.member_1[3]), array<f64, 4>(_e4254.member_2[0], _e4254.member_2[1], _e4254.member_2[2], _e4254.member_2[3]));
                                let _e4274 = (_e3963 - _e3967);
                                let _e4275 = f64(0f);
                                let _e4278 = local_10.member[0u];
                                let _e4281 = local_10.member_1[0u];
                                let _e4284 = local_10.member[0u];
                                let _e4290 = local_10.member_2[0u];
                                if (((_e4278 + ((_e4281 - _e4284) * _e3963)) - _e4290) > _e4275) {
                                    let _e4295 = local_10.member[1u];
                                    let _e4298 = local_10.member_1[1u];
                                    let _e4301 = local_10.member[1u];
                                    let _e4307 = local_10.member_2[1u];
                                    if (((_e4295 + ((_e4298 - _e4301) * _e3963)) - _e4307) > _e4275) {
                                        let _e4312 = local_10.member[2u];
                                        let _e4315 = local_10.member_1[2u];
                                        let _e4318 = local_10.member[2u];
                                        let _e4324 = local_10.member_2[2u];
                                        if (((_e4312 + ((_e4315 - _e4318) * _e3963)) - _e4324) > _e4275) {
                                            let _e4329 = local_10.member[3u];
                                            let _e4332 = local_10.member_1[3u];
                                            let _e4335 = local_10.member[3u];
                                            let _e4341 = local_10.member_2[3u];
                                            phi_2616_ = (((_e4329 + ((_e4332 - _e4335) * _e3963)) - _e4341) > _e4275);
                                            phi_2617_ = false;
                                        } else {
                                            phi_2616_ = bool();
                                            phi_2617_ = true;
                                        }
                                        let _e4345 = phi_2616_;
                                        let _e4347 = phi_2617_;
                                        phi_2618_ = _e4345;
                                        phi_2619_ = _e4347;
                                    } else {
                                        phi_2618_ = bool();
                                        phi_2619_ = true;
                                    }
                                    let _e4349 = phi_2618_;
                                    let _e4351 = phi_2619_;
                                    phi_2620_ = _e4349;
                                    phi_2621_ = _e4351;
                                } else {
                                    phi_2620_ = bool();
                                    phi_2621_ = true;
                                }
                                let _e4353 = phi_2620_;
                                let _e4355 = phi_2621_;
                                if _e4355 {
                                    phi_2625_ = false;
                                } else {
                                    phi_2625_ = _e4353;
                                }
                                let _e4357 = phi_2625_;
                                if _e4357 {
                                    if (_e3963 <= _e3965) {
                                        phi_2936_ = true;
                                    } else {
                                        let _e4359 = f64(0f);
                                        let _e4362 = local_9.member[0u];
                                        let _e4365 = local_9.member_1[0u];
                                        let _e4368 = local_9.member[0u];
                                        let _e4374 = local_9.member_2[0u];
                                        let _e4378 = local_10.member[0u];
                                        let _e4381 = local_10.member_1[0u];
                                        let _e4384 = local_10.member[0u];
                                        let _e4390 = local_10.member_2[0u];
                                        if ((((_e4362 + ((_e4365 - _e4368) * _e3963)) - _e4374) + ((_e4378 + ((_e4381 - _e4384) * _e3967)) - _e4390)) > _e4359) {
                                            let _e4396 = local_9.member[1u];
                                            let _e4399 = local_9.member_1[1u];
                                            let _e4402 = local_9.member[1u];
                                            let _e4408 = local_9.member_2[1u];
                                            let _e4412 = local_10.member[1u];
                                            let _e4415 = local_10.member_1[1u];
                                            let _e4418 = local_10.member[1u];
                                            let _e4424 = local_10.member_2[1u];
                                            if ((((_e4396 + ((_e4399 - _e4402) * _e3963)) - _e4408) + ((_e4412 + ((_e4415 - _e4418) * _e3967)) - _e4424)) > _e4359) {
                                                let _e4430 = local_9.member[2u];
                                                let _e4433 = local_9.member_1[2u];
                                                let _e4436 = local_9.member[2u];
                                                let _e4442 = local_9.member_2[2u];
                                                let _e4446 = local_10.member[2u];
                                                let _e4449 = local_10.member_1[2u];
                                                let _e4452 = local_10.member[2u];
                                                let _e4458 = local_10.member_2[2u];
                                                if ((((_e4430 + ((_e4433 - _e4436) * _e3963)) - _e4442) + ((_e4446 + ((_e4449 - _e4452) * _e3967)) - _e4458)) > _e4359) {
                                                    let _e4464 = local_9.member[3u];
                                                    let _e4467 = local_9.member_1[3u];
                                                    let _e4470 = local_9.member[3u];
                                                    let _e4476 = local_9.member_2[3u];
                                                    let _e4480 = local_10.member[3u];
                                                    let _e4483 = local_10.member_1[3u];
                                                    let _e4486 = local_10.member[3u];
                                                    let _e4492 = local_10.member_2[3u];
                                                    phi_2923_ = ((((_e4464 + ((_e4467 - _e4470) * _e3963)) - _e4476) + ((_e4480 + ((_e4483 - _e4486) * _e3967)) - _e4492)) > _e4359);
                                                    phi_2924_ = false;
                                                } else {
                                                    phi_2923_ = bool();
                                                    phi_2924_ = true;
                                                }
                                                let _e4497 = phi_2923_;
                                                let _e4499 = phi_2924_;
                                                phi_2925_ = _e4497;
                                                phi_2926_ = _e4499;
                                            } else {
                                                phi_2925_ = bool();
                                                phi_2926_ = true;
                                            }
                                            let _e4501 = phi_2925_;
                                            let _e4503 = phi_2926_;
                                            phi_2927_ = _e4501;
                                            phi_2928_ = _e4503;
                                        } else {
                                            phi_2927_ = bool();
                                            phi_2928_ = true;
                                        }
                                        let _e4505 = phi_2927_;
                                        let _e4507 = phi_2928_;
                                        if _e4507 {
                                            phi_2932_ = false;
                                        } else {
                                            phi_2932_ = _e4505;
                                        }
                                        let _e4509 = phi_2932_;
                                        phi_2936_ = _e4509;
                                    }
                                    let _e4511 = phi_2936_;
                                    if _e4511 {
                                        if (_e3981.member_1 > 0u) {
                                            if (_e3963 >= _e3723) {
                                                phi_2948_ = false;
                                            } else {
                                                phi_2948_ = true;
                                            }
                                            let _e4515 = phi_2948_;
                                            phi_2949_ = _e4515;
                                        } else {
                                            phi_2949_ = true;
                                        }
                                        let _e4517 = phi_2949_;
                                        if _e4517 {
                                            local_9 = type_32(array<f64, 4>(_e4254.member[0], _e4254.member[1], _e4254.member[2], _e4254.member[3]), array<f64, 4>(_e4254.member_1[0], _e4254.member_1[1], _e4254.member_1[2], _e4254.member_1[3]), array<f64, 4>(_e4254.member_2[0], _e4254.member_2[1], _e4254.member_2[2], _e4254.member_2[3]));
                                            let _e4539 = local_9.member[0u];
                                            let _e4542 = local_9.member_1[0u];
                                            let _e4545 = local_9.member_2[0u];
                                            if (_e4539 > _e4545) {
                                                if (_e4542 > _e4545) {
                                                    phi_3023_ = false;
                                                } else {
                                                    phi_3023_ = true;
                                                }
                                                let _e4549 = phi_3023_;
                                                phi_3024_ = _e4549;
                                            } else {
                                                phi_3024_ = true;
                                            }
                                            let _e4551 = phi_3024_;
                                            if _e4551 {
                                                let _e4552 = (_e4542 >= _e4539);
                                                if _e4552 {
                                                    phi_3049_ = f64();
                                                    phi_3050_ = false;
                                                } else {
                                                    if ((_e4539 - _e4542) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3047_ = (((_e4539 - _e4545) / (_e4539 - _e4542)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3048_ = false;
                                                    } else {
                                                        phi_3047_ = f64();
                                                        phi_3048_ = true;
                                                    }
                                                    let _e4566 = phi_3047_;
                                                    let _e4568 = phi_3048_;
                                                    phi_3049_ = _e4566;
                                                    phi_3050_ = _e4568;
                                                }
                                                let _e4570 = phi_3049_;
                                                let _e4572 = phi_3050_;
                                                phi_3051_ = _e4570;
                                                phi_3052_ = _e4552;
                                                phi_3053_ = _e4572;
                                            } else {
                                                phi_3051_ = f64();
                                                phi_3052_ = true;
                                                phi_3053_ = false;
                                            }
                                            let _e4574 = phi_3051_;
                                            let _e4576 = phi_3052_;
                                            let _e4578 = phi_3053_;
                                            if _e4576 {
                                                phi_3058_ = f64(2f);
                                                phi_3059_ = true;
                                            } else {
                                                phi_3058_ = _e3963;
                                                phi_3059_ = _e4578;
                                            }
                                            let _e4581 = phi_3058_;
                                            let _e4583 = phi_3059_;
                                            if _e4583 {
                                                phi_3063_ = _e4581;
                                            } else {
                                                phi_3063_ = _e4574;
                                            }
                                            let _e4585 = phi_3063_;
                                            let _e4588 = local_9.member[1u];
                                            let _e4591 = local_9.member_1[1u];
                                            let _e4594 = local_9.member_2[1u];
                                            if (_e4588 > _e4594) {
                                                if (_e4591 > _e4594) {
                                                    phi_3095_ = false;
                                                } else {
                                                    phi_3095_ = true;
                                                }
                                                let _e4598 = phi_3095_;
                                                phi_3096_ = _e4598;
                                            } else {
                                                phi_3096_ = true;
                                            }
                                            let _e4600 = phi_3096_;
                                            if _e4600 {
                                                let _e4601 = (_e4591 >= _e4588);
                                                if _e4601 {
                                                    phi_3121_ = f64();
                                                    phi_3122_ = false;
                                                } else {
                                                    if ((_e4588 - _e4591) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3119_ = (((_e4588 - _e4594) / (_e4588 - _e4591)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3120_ = false;
                                                    } else {
                                                        phi_3119_ = f64();
                                                        phi_3120_ = true;
                                                    }
                                                    let _e4615 = phi_3119_;
                                                    let _e4617 = phi_3120_;
                                                    phi_3121_ = _e4615;
                                                    phi_3122_ = _e4617;
                                                }
                                                let _e4619 = phi_3121_;
                                                let _e4621 = phi_3122_;
                                                phi_3123_ = _e4619;
                                                phi_3124_ = _e4601;
                                                phi_3125_ = _e4621;
                                            } else {
                                                phi_3123_ = f64();
                                                phi_3124_ = true;
                                                phi_3125_ = false;
                                            }
                                            let _e4623 = phi_3123_;
                                            let _e4625 = phi_3124_;
                                            let _e4627 = phi_3125_;
                                            if _e4625 {
                                                phi_3130_ = f64(2f);
                                                phi_3131_ = true;
                                            } else {
                                                phi_3130_ = _e3963;
                                                phi_3131_ = _e4627;
                                            }
                                            let _e4630 = phi_3130_;
                                            let _e4632 = phi_3131_;
                                            if _e4632 {
                                                phi_3135_ = _e4630;
                                            } else {
                                                phi_3135_ = _e4623;
                                            }
                                            let _e4634 = phi_3135_;
                                            if (_e4585 < _e4634) {
                                                phi_3140_ = _e4585;
                                            } else {
                                                phi_3140_ = _e4634;
                                            }
                                            let _e4637 = phi_3140_;
                                            let _e4640 = local_9.member[2u];
                                            let _e4643 = local_9.member_1[2u];
                                            let _e4646 = local_9.member_2[2u];
                                            if (_e4640 > _e4646) {
                                                if (_e4643 > _e4646) {
                                                    phi_3172_ = false;
                                                } else {
                                                    phi_3172_ = true;
                                                }
                                                let _e4650 = phi_3172_;
                                                phi_3173_ = _e4650;
                                            } else {
                                                phi_3173_ = true;
                                            }
                                            let _e4652 = phi_3173_;
                                            if _e4652 {
                                                let _e4653 = (_e4643 >= _e4640);
                                                if _e4653 {
                                                    phi_3198_ = f64();
                                                    phi_3199_ = false;
                                                } else {
                                                    if ((_e4640 - _e4643) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3196_ = (((_e4640 - _e4646) / (_e4640 - _e4643)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3197_ = false;
                                                    } else {
                                                        phi_3196_ = f64();
                                                        phi_3197_ = true;
                                                    }
                                                    let _e4667 = phi_3196_;
                                                    let _e4669 = phi_3197_;
                                                    phi_3198_ = _e4667;
                                                    phi_3199_ = _e4669;
                                                }
                                                let _e4671 = phi_3198_;
                                                let _e4673 = phi_3199_;
                                                phi_3200_ = _e4671;
                                                phi_3201_ = _e4653;
                                                phi_3202_ = _e4673;
                                            } else {
                                                phi_3200_ = f64();
                                                phi_3201_ = true;
                                                phi_3202_ = false;
                                            }
                                            let _e4675 = phi_3200_;
                                            let _e4677 = phi_3201_;
                                            let _e4679 = phi_3202_;
                                            if _e4677 {
                                                phi_3207_ = f64(2f);
                                                phi_3208_ = true;
                                            } else {
                                                phi_3207_ = _e3963;
                                                phi_3208_ = _e4679;
                                            }
                                            let _e4682 = phi_3207_;
                                            let _e4684 = phi_3208_;
                                            if _e4684 {
                                                phi_3212_ = _e4682;
                                            } else {
                                                phi_3212_ = _e4675;
                                            }
                                            let _e4686 = phi_3212_;
                                            let _e4689 = local_9.member[3u];
                                            let _e4692 = local_9.member_1[3u];
                                            let _e4695 = local_9.member_2[3u];
                                            if (_e4689 > _e4695) {
                                                if (_e4692 > _e4695) {
                                                    phi_3244_ = false;
                                                } else {
                                                    phi_3244_ = true;
                                                }
                                                let _e4699 = phi_3244_;
                                                phi_3245_ = _e4699;
                                            } else {
                                                phi_3245_ = true;
                                            }
                                            let _e4701 = phi_3245_;
                                            if _e4701 {
                                                let _e4702 = (_e4692 >= _e4689);
                                                if _e4702 {
                                                    phi_3270_ = f64();
                                                    phi_3271_ = false;
                                                } else {
                                                    if ((_e4689 - _e4692) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3268_ = (((_e4689 - _e4695) / (_e4689 - _e4692)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3269_ = false;
                                                    } else {
                                                        phi_3268_ = f64();
                                                        phi_3269_ = true;
                                                    }
                                                    let _e4716 = phi_3268_;
                                                    let _e4718 = phi_3269_;
                                                    phi_3270_ = _e4716;
                                                    phi_3271_ = _e4718;
                                                }
                                                let _e4720 = phi_3270_;
                                                let _e4722 = phi_3271_;
                                                phi_3272_ = _e4720;
                                                phi_3273_ = _e4702;
                                                phi_3274_ = _e4722;
                                            } else {
                                                phi_3272_ = f64();
                                                phi_3273_ = true;
                                                phi_3274_ = false;
                                            }
                                            let _e4724 = phi_3272_;
                                            let _e4726 = phi_3273_;
                                            let _e4728 = phi_3274_;
                                            if _e4726 {
                                                phi_3279_ = f64(2f);
                                                phi_3280_ = true;
                                            } else {
                                                phi_3279_ = _e3963;
                                                phi_3280_ = _e4728;
                                            }
                                            let _e4731 = phi_3279_;
                                            let _e4733 = phi_3280_;
                                            if _e4733 {
                                                phi_3284_ = _e4731;
                                            } else {
                                                phi_3284_ = _e4724;
                                            }
                                            let _e4735 = phi_3284_;
                                            if (_e4686 < _e4735) {
                                                phi_3289_ = _e4686;
                                            } else {
                                                phi_3289_ = _e4735;
                                            }
                                            let _e4738 = phi_3289_;
                                            if (_e4637 < _e4738) {
                                                phi_3294_ = _e4637;
                                            } else {
                                                phi_3294_ = _e4738;
                                            }
                                            let _e4741 = phi_3294_;
                                            if (_e4741 > _e3963) {
                                                phi_3299_ = _e4741;
                                            } else {
                                                phi_3299_ = _e3963;
                                            }
                                            let _e4744 = phi_3299_;
                                            let _e4745 = (_e4744 > _e3723);
                                            if _e4745 {
                                                phi_3311_ = f64();
                                                phi_3312_ = false;
                                            } else {
                                                if (_e3981.member_1 == 0u) {
                                                    phi_3310_ = (_e3723 - _e3963);
                                                } else {
                                                    phi_3310_ = (_e4274 + _e4274);
                                                }
                                                let _e4750 = phi_3310_;
                                                phi_3311_ = _e4750;
                                                phi_3312_ = true;
                                            }
                                            let _e4752 = phi_3311_;
                                            let _e4754 = phi_3312_;
                                            phi_3313_ = _e4744;
                                            phi_3314_ = _e4752;
                                            phi_3315_ = _e4754;
                                            phi_3316_ = _e4745;
                                            phi_3317_ = false;
                                        } else {
                                            phi_3313_ = f64();
                                            phi_3314_ = f64();
                                            phi_3315_ = false;
                                            phi_3316_ = false;
                                            phi_3317_ = true;
                                        }
                                        let _e4756 = phi_3313_;
                                        let _e4758 = phi_3314_;
                                        let _e4760 = phi_3315_;
                                        let _e4762 = phi_3316_;
                                        let _e4764 = phi_3317_;
                                        phi_3318_ = _e4756;
                                        phi_3319_ = _e4758;
                                        phi_3320_ = false;
                                        phi_3321_ = _e4760;
                                        phi_3322_ = _e4762;
                                        phi_3323_ = _e4764;
                                    } else {
                                        phi_3318_ = f64();
                                        phi_3319_ = f64();
                                        phi_3320_ = true;
                                        phi_3321_ = false;
                                        phi_3322_ = false;
                                        phi_3323_ = false;
                                    }
                                    let _e4766 = phi_3318_;
                                    let _e4768 = phi_3319_;
                                    let _e4770 = phi_3320_;
                                    let _e4772 = phi_3321_;
                                    let _e4774 = phi_3322_;
                                    let _e4776 = phi_3323_;
                                    phi_3324_ = _e4766;
                                    phi_3325_ = _e4768;
                                    phi_3326_ = _e4770;
                                    phi_3327_ = _e4772;
                                    phi_3328_ = _e4774;
                                    phi_3329_ = _e4776;
                                } else {
                                    phi_3324_ = f64();
                                    phi_3325_ = f64();
                                    phi_3326_ = true;
                                    phi_3327_ = false;
                                    phi_3328_ = false;
                                    phi_3329_ = false;
                                }
                                let _e4778 = phi_3324_;
                                let _e4780 = phi_3325_;
                                let _e4782 = phi_3326_;
                                let _e4784 = phi_3327_;
                                let _e4786 = phi_3328_;
                                let _e4788 = phi_3329_;
                                if _e4782 {
                                    let _e4789 = (_e3963 <= _e3965);
                                    if _e4789 {
                                        phi_3663_ = f64();
                                        phi_3664_ = false;
                                    } else {
                                        let _e4792 = local_9.member[0u];
                                        let _e4795 = local_9.member_1[0u];
                                        let _e4798 = local_9.member[0u];
                                        let _e4804 = local_9.member_2[0u];
                                        let _e4805 = ((_e4792 + ((_e4795 - _e4798) * _e3967)) - _e4804);
                                        let _e4808 = local_9.member[1u];
                                        let _e4811 = local_9.member_1[1u];
                                        let _e4814 = local_9.member[1u];
                                        let _e4820 = local_9.member_2[1u];
                                        let _e4821 = ((_e4808 + ((_e4811 - _e4814) * _e3967)) - _e4820);
                                        if (_e4805 < _e4821) {
                                            phi_3409_ = _e4805;
                                        } else {
                                            phi_3409_ = _e4821;
                                        }
                                        let _e4824 = phi_3409_;
                                        let _e4827 = local_9.member[2u];
                                        let _e4830 = local_9.member_1[2u];
                                        let _e4833 = local_9.member[2u];
                                        let _e4839 = local_9.member_2[2u];
                                        let _e4840 = ((_e4827 + ((_e4830 - _e4833) * _e3967)) - _e4839);
                                        let _e4843 = local_9.member[3u];
                                        let _e4846 = local_9.member_1[3u];
                                        let _e4849 = local_9.member[3u];
                                        let _e4855 = local_9.member_2[3u];
                                        let _e4856 = ((_e4843 + ((_e4846 - _e4849) * _e3967)) - _e4855);
                                        if (_e4840 < _e4856) {
                                            phi_3482_ = _e4840;
                                        } else {
                                            phi_3482_ = _e4856;
                                        }
                                        let _e4859 = phi_3482_;
                                        if (_e4824 < _e4859) {
                                            phi_3487_ = _e4824;
                                        } else {
                                            phi_3487_ = _e4859;
                                        }
                                        let _e4862 = phi_3487_;
                                        let _e4865 = local_10.member[0u];
                                        let _e4868 = local_10.member_1[0u];
                                        let _e4871 = local_10.member[0u];
                                        let _e4877 = local_10.member_2[0u];
                                        let _e4878 = ((_e4865 + ((_e4868 - _e4871) * _e3963)) - _e4877);
                                        let _e4881 = local_10.member[1u];
                                        let _e4884 = local_10.member_1[1u];
                                        let _e4887 = local_10.member[1u];
                                        let _e4893 = local_10.member_2[1u];
                                        let _e4894 = ((_e4881 + ((_e4884 - _e4887) * _e3963)) - _e4893);
                                        if (_e4878 < _e4894) {
                                            phi_3560_ = _e4878;
                                        } else {
                                            phi_3560_ = _e4894;
                                        }
                                        let _e4897 = phi_3560_;
                                        let _e4900 = local_10.member[2u];
                                        let _e4903 = local_10.member_1[2u];
                                        let _e4906 = local_10.member[2u];
                                        let _e4912 = local_10.member_2[2u];
                                        let _e4913 = ((_e4900 + ((_e4903 - _e4906) * _e3963)) - _e4912);
                                        let _e4916 = local_10.member[3u];
                                        let _e4919 = local_10.member_1[3u];
                                        let _e4922 = local_10.member[3u];
                                        let _e4928 = local_10.member_2[3u];
                                        let _e4929 = ((_e4916 + ((_e4919 - _e4922) * _e3963)) - _e4928);
                                        if (_e4913 < _e4929) {
                                            phi_3633_ = _e4913;
                                        } else {
                                            phi_3633_ = _e4929;
                                        }
                                        let _e4932 = phi_3633_;
                                        if (_e4897 < _e4932) {
                                            phi_3638_ = _e4897;
                                        } else {
                                            phi_3638_ = _e4932;
                                        }
                                        let _e4935 = phi_3638_;
                                        let _e4936 = f64(0.0625f);
                                        let _e4938 = f64(0.9f);
                                        if (_e4935 > f64(0f)) {
                                            phi_3661_ = f64(0.5f);
                                        } else {
                                            let _e4944 = (f64(0.95f) * (_e4862 / (_e4862 - _e4935)));
                                            if (_e4944 > _e4936) {
                                                if (_e4944 < _e4938) {
                                                    phi_3659_ = _e4944;
                                                } else {
                                                    phi_3659_ = _e4938;
                                                }
                                                let _e4948 = phi_3659_;
                                                phi_3660_ = _e4948;
                                            } else {
                                                phi_3660_ = _e4936;
                                            }
                                            let _e4950 = phi_3660_;
                                            phi_3661_ = _e4950;
                                        }
                                        let _e4952 = phi_3661_;
                                        phi_3663_ = (_e4274 * _e4952);
                                        phi_3664_ = true;
                                    }
                                    let _e4955 = phi_3663_;
                                    let _e4957 = phi_3664_;
                                    phi_3665_ = _e3965;
                                    phi_3666_ = _e4955;
                                    phi_3667_ = _e3967;
                                    phi_3668_ = _e4957;
                                    phi_3669_ = _e4789;
                                    phi_3670_ = false;
                                    phi_3671_ = false;
                                } else {
                                    phi_3665_ = _e4778;
                                    phi_3666_ = _e4780;
                                    phi_3667_ = _e3963;
                                    phi_3668_ = _e4784;
                                    phi_3669_ = false;
                                    phi_3670_ = _e4786;
                                    phi_3671_ = _e4788;
                                }
                                let _e4959 = phi_3665_;
                                let _e4961 = phi_3666_;
                                let _e4963 = phi_3667_;
                                let _e4965 = phi_3668_;
                                let _e4967 = phi_3669_;
                                let _e4969 = phi_3670_;
                                let _e4971 = phi_3671_;
                                if _e4965 {
                                    let _e4972 = (_e4963 + _e4961);
                                    if (_e4972 > _e4959) {
                                        phi_3680_ = _e4972;
                                    } else {
                                        phi_3680_ = _e4959;
                                    }
                                    let _e4975 = phi_3680_;
                                    if (_e4975 < _e3723) {
                                        phi_3685_ = _e4975;
                                    } else {
                                        phi_3685_ = _e3723;
                                    }
                                    let _e4978 = phi_3685_;
                                    if (_e3981.member_1 > 0u) {
                                        phi_3696_ = ((_e4978 - _e4963) > f64(0.0000000037252903f));
                                    } else {
                                        phi_3696_ = true;
                                    }
                                    let _e4984 = phi_3696_;
                                    if _e4984 {
                                        phi_3700_ = false;
                                    } else {
                                        phi_3700_ = true;
                                    }
                                    let _e4986 = phi_3700_;
                                    phi_3701_ = _e4978;
                                    phi_3702_ = _e4984;
                                    phi_3703_ = _e4986;
                                    phi_3704_ = false;
                                    phi_3705_ = false;
                                    phi_3706_ = false;
                                } else {
                                    phi_3701_ = f64();
                                    phi_3702_ = false;
                                    phi_3703_ = false;
                                    phi_3704_ = _e4967;
                                    phi_3705_ = _e4969;
                                    phi_3706_ = _e4971;
                                }
                                let _e4988 = phi_3701_;
                                let _e4990 = phi_3702_;
                                let _e4992 = phi_3703_;
                                let _e4994 = phi_3704_;
                                let _e4996 = phi_3705_;
                                let _e4998 = phi_3706_;
                                phi_2050_ = _e4988;
                                phi_2052_ = _e4959;
                                phi_2054_ = _e4963;
                                phi_3707_ = _e4959;
                                phi_3708_ = _e4990;
                                phi_3709_ = _e4992;
                                phi_3710_ = false;
                                phi_3711_ = _e4994;
                                phi_3712_ = _e4996;
                                phi_3713_ = _e4998;
                            } else {
                                phi_2050_ = f64();
                                phi_2052_ = f64();
                                phi_2054_ = f64();
                                phi_3707_ = f64();
                                phi_3708_ = false;
                                phi_3709_ = false;
                                phi_3710_ = true;
                                phi_3711_ = false;
                                phi_3712_ = false;
                                phi_3713_ = false;
                            }
                            let _e5000 = phi_2050_;
                            let _e5002 = phi_2052_;
                            let _e5004 = phi_2054_;
                            let _e5006 = phi_3707_;
                            let _e5008 = phi_3708_;
                            let _e5010 = phi_3709_;
                            let _e5012 = phi_3710_;
                            let _e5014 = phi_3711_;
                            let _e5016 = phi_3712_;
                            let _e5018 = phi_3713_;
                            local_25 = _e5010;
                            local_43 = _e5006;
                            local_45 = _e5012;
                            local_46 = _e5014;
                            local_47 = _e5016;
                            local_48 = _e5018;
                            continue;
                            continuing {
                                phi_2046_ = _e3979;
                                phi_2049_ = _e5000;
                                phi_2051_ = _e5002;
                                phi_2053_ = _e5004;
                                break if !(_e5008);
                            }
                        }
                        let _e5021 = local_25;
                        if _e5021 {
                            let _e6304 = local_43;
                            phi_3717_ = _e6304;
                            phi_3718_ = true;
                            phi_3719_ = false;
                            phi_3720_ = false;
                            phi_3721_ = false;
                        } else {
                            let _e6306 = local_44;
                            phi_3717_ = _e6306;
                            let _e6309 = local_45;
                            phi_3718_ = _e6309;
                            let _e6312 = local_46;
                            phi_3719_ = _e6312;
                            let _e6315 = local_47;
                            phi_3720_ = _e6315;
                            let _e6318 = local_48;
                            phi_3721_ = _e6318;
                        }
                        let _e5023 = phi_3717_;
                        let _e5025 = phi_3718_;
                        let _e5027 = phi_3719_;
                        let _e5029 = phi_3720_;
                        let _e5031 = phi_3721_;
                        if _e5025 {
                            phi_3726_ = type_42(1u, _e5023);
                            phi_3727_ = false;
                            phi_3728_ = false;
                            phi_3729_ = false;
                        } else {
                            phi_3726_ = type_42();
                            phi_3727_ = _e5027;
                            phi_3728_ = _e5029;
                            phi_3729_ = _e5031;
                        }
                        let _e5034 = phi_3726_;
                        let _e5036 = phi_3727_;
                        let _e5038 = phi_3728_;
                        let _e5040 = phi_3729_;
                        if _e5036 {
                            let _e5042 = local_26;
                            phi_3734_ = type_42(1u, _e5042);
                            phi_3735_ = false;
                            phi_3736_ = false;
                        } else {
                            phi_3734_ = type_42();
                            phi_3735_ = _e5038;
                            phi_3736_ = _e5040;
                        }
                        let _e5045 = phi_3734_;
                        let _e5047 = phi_3735_;
                        let _e5049 = phi_3736_;
                        if _e5047 {
                            phi_3741_ = type_42(0u, type_42().member_1);
                            phi_3742_ = false;
                            phi_3743_ = true;
                        } else {
                            phi_3741_ = _e5045;
                            phi_3742_ = _e5049;
                            phi_3743_ = _e5036;
                        }
                        let _e5053 = phi_3741_;
                        let _e5055 = phi_3742_;
                        let _e5057 = phi_3743_;
                        if _e5055 {
                            phi_3748_ = type_42(0u, type_42().member_1);
                            phi_3749_ = true;
                        } else {
                            phi_3748_ = _e5053;
                            phi_3749_ = _e5057;
                        }
                        let _e5061 = phi_3748_;
                        let _e5063 = phi_3749_;
                        if _e5063 {
                            phi_3753_ = _e5061;
                        } else {
                            phi_3753_ = _e5034;
                        }
                        let _e5065 = phi_3753_;
                        if (_e5065.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_3767_ = type_19(0u, 3u);
                            loop {
                                let _e5077 = phi_3767_;
                                if (_e5077.member < _e5077.member_1) {
                                    phi_3768_ = type_19((_e5077.member + 1u), _e5077.member_1);
                                    phi_3791_ = type_19(1u, _e5077.member);
                                } else {
                                    phi_3768_ = _e5077;
                                    phi_3791_ = type_19(0u, type_19().member_1);
                                }
                                let _e5089 = phi_3768_;
                                let _e5091 = phi_3791_;
                                if (bitcast<i32>(_e5091.member) != 0i) {
                                    let _e5097 = local_11[_e5091.member_1];
                                    let _e5099 = (_e5065.member_1 + f64(_e5097));
                                    if (_e5099 < _e3723) {
                                        phi_3812_ = _e5099;
                                    } else {
                                        phi_3812_ = _e3723;
                                    }
                                    let _e5102 = phi_3812_;
                                    let _e5105 = local_12.member[0u];
                                    let _e5111 = local_12.member[1u];
                                    let _e5127 = local_12.member_1[0u];
                                    let _e5133 = local_12.member_1[1u];
                                    let _e5149 = local_12.member_2[0u];
                                    let _e5155 = local_12.member_2[1u];
                                    let _e5169 = function_2(array<f64, 3>((_e5105[0] + ((_e5111[0] - _e5105[0]) * _e5102)), (_e5105[1] + ((_e5111[1] - _e5105[1]) * _e5102)), (_e5105[2] + ((_e5111[2] - _e5105[2]) * _e5102))), array<f64, 3>((_e5127[0] + ((_e5133[0] - _e5127[0]) * _e5102)), (_e5127[1] + ((_e5133[1] - _e5127[1]) * _e5102)), (_e5127[2] + ((_e5133[2] - _e5127[2]) * _e5102))), array<f64, 3>((_e5149[0] + ((_e5155[0] - _e5149[0]) * _e5102)), (_e5149[1] + ((_e5155[1] - _e5149[1]) * _e5102)), (_e5149[2] + ((_e5155[2] - _e5149[2]) * _e5102))), 1u);
                                    let _e5180 = (((_e5169[0] * _e5169[0]) + (_e5169[1] * _e5169[1])) + (_e5169[2] * _e5169[2]));
                                    if (_e5180 <= 2.2250738585072014e-308lf) {
                                        if (_e5180 > 0.0lf) {
                                            phi_3935_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3935_ = 0.0lf;
                                        }
                                        let _e5232 = phi_3935_;
                                        phi_3999_ = _e5232;
                                    } else {
                                        phi_3942_ = type_17(0i, 5i);
                                        phi_3945_ = bitcast<f64>(((bitcast<u64>(_e5180) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e5187 = phi_3942_;
                                            let _e5189 = phi_3945_;
                                            local_27 = _e5189;
                                            if (_e5187.member < _e5187.member_1) {
                                                let _e5196 = (_e5187.member + 1i);
                                                if ((false == (_e5196 > _e5187.member)) != false) {
                                                    phi_3966_ = true;
                                                } else {
                                                    phi_3966_ = false;
                                                }
                                                let _e5201 = phi_3966_;
                                                if _e5201 {
                                                    phi_3972_ = type_18(0u, type_18().member_1);
                                                } else {
                                                    phi_3972_ = type_18(1u, _e5196);
                                                }
                                                let _e5206 = phi_3972_;
                                                phi_3943_ = type_17(_e5206.member_1, _e5187.member_1);
                                                phi_3986_ = type_18(1u, _e5187.member);
                                            } else {
                                                phi_3943_ = _e5187;
                                                phi_3986_ = type_18(0u, type_18().member_1);
                                            }
                                            let _e5212 = phi_3943_;
                                            let _e5214 = phi_3986_;
                                            let _e5217 = (bitcast<i32>(_e5214.member) != 0i);
                                            if _e5217 {
                                                phi_3946_ = (0.5lf * (_e5189 + (_e5180 / _e5189)));
                                            } else {
                                                phi_3946_ = f64();
                                            }
                                            let _e5222 = phi_3946_;
                                            continue;
                                            continuing {
                                                phi_3942_ = _e5212;
                                                phi_3945_ = _e5222;
                                                break if !(_e5217);
                                            }
                                        }
                                        let _e5227 = local_27;
                                        phi_3999_ = (_e5227 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e5234 = phi_3999_;
                                    let _e5242 = local_12.member[0u];
                                    if (_e5242[0] < 0.0lf) {
                                        phi_4017_ = -(_e5242[0]);
                                    } else {
                                        phi_4017_ = _e5242[0];
                                    }
                                    let _e5249 = phi_4017_;
                                    if (_e5242[1] < 0.0lf) {
                                        phi_4024_ = -(_e5242[1]);
                                    } else {
                                        phi_4024_ = _e5242[1];
                                    }
                                    let _e5253 = phi_4024_;
                                    if (_e5249 > _e5253) {
                                        phi_4029_ = _e5249;
                                    } else {
                                        phi_4029_ = _e5253;
                                    }
                                    let _e5256 = phi_4029_;
                                    if (_e5242[2] < 0.0lf) {
                                        phi_4036_ = -(_e5242[2]);
                                    } else {
                                        phi_4036_ = _e5242[2];
                                    }
                                    let _e5260 = phi_4036_;
                                    if (_e5256 > _e5260) {
                                        phi_4041_ = _e5256;
                                    } else {
                                        phi_4041_ = _e5260;
                                    }
                                    let _e5263 = phi_4041_;
                                    let _e5266 = local_12.member[1u];
                                    if (_e5266[0] < 0.0lf) {
                                        phi_4054_ = -(_e5266[0]);
                                    } else {
                                        phi_4054_ = _e5266[0];
                                    }
                                    let _e5273 = phi_4054_;
                                    if (_e5266[1] < 0.0lf) {
                                        phi_4061_ = -(_e5266[1]);
                                    } else {
                                        phi_4061_ = _e5266[1];
                                    }
                                    let _e5277 = phi_4061_;
                                    if (_e5273 > _e5277) {
                                        phi_4066_ = _e5273;
                                    } else {
                                        phi_4066_ = _e5277;
                                    }
                                    let _e5280 = phi_4066_;
                                    if (_e5266[2] < 0.0lf) {
                                        phi_4073_ = -(_e5266[2]);
                                    } else {
                                        phi_4073_ = _e5266[2];
                                    }
                                    let _e5284 = phi_4073_;
                                    if (_e5280 > _e5284) {
                                        phi_4078_ = _e5280;
                                    } else {
                                        phi_4078_ = _e5284;
                                    }
                                    let _e5287 = phi_4078_;
                                    if (_e5263 > _e5287) {
                                        phi_4083_ = _e5263;
                                    } else {
                                        phi_4083_ = _e5287;
                                    }
                                    let _e5290 = phi_4083_;
                                    let _e5292 = local_12.member_3;
                                    let _e5296 = local_12.member_1[0u];
                                    if (_e5296[0] < 0.0lf) {
                                        phi_4100_ = -(_e5296[0]);
                                    } else {
                                        phi_4100_ = _e5296[0];
                                    }
                                    let _e5303 = phi_4100_;
                                    if (_e5296[1] < 0.0lf) {
                                        phi_4107_ = -(_e5296[1]);
                                    } else {
                                        phi_4107_ = _e5296[1];
                                    }
                                    let _e5307 = phi_4107_;
                                    if (_e5303 > _e5307) {
                                        phi_4112_ = _e5303;
                                    } else {
                                        phi_4112_ = _e5307;
                                    }
                                    let _e5310 = phi_4112_;
                                    if (_e5296[2] < 0.0lf) {
                                        phi_4119_ = -(_e5296[2]);
                                    } else {
                                        phi_4119_ = _e5296[2];
                                    }
                                    let _e5314 = phi_4119_;
                                    if (_e5310 > _e5314) {
                                        phi_4124_ = _e5310;
                                    } else {
                                        phi_4124_ = _e5314;
                                    }
                                    let _e5317 = phi_4124_;
                                    let _e5320 = local_12.member_1[1u];
                                    if (_e5320[0] < 0.0lf) {
                                        phi_4138_ = -(_e5320[0]);
                                    } else {
                                        phi_4138_ = _e5320[0];
                                    }
                                    let _e5327 = phi_4138_;
                                    if (_e5320[1] < 0.0lf) {
                                        phi_4145_ = -(_e5320[1]);
                                    } else {
                                        phi_4145_ = _e5320[1];
                                    }
                                    let _e5331 = phi_4145_;
                                    if (_e5327 > _e5331) {
                                        phi_4150_ = _e5327;
                                    } else {
                                        phi_4150_ = _e5331;
                                    }
                                    let _e5334 = phi_4150_;
                                    if (_e5320[2] < 0.0lf) {
                                        phi_4157_ = -(_e5320[2]);
                                    } else {
                                        phi_4157_ = _e5320[2];
                                    }
                                    let _e5338 = phi_4157_;
                                    if (_e5334 > _e5338) {
                                        phi_4162_ = _e5334;
                                    } else {
                                        phi_4162_ = _e5338;
                                    }
                                    let _e5341 = phi_4162_;
                                    if (_e5317 > _e5341) {
                                        phi_4167_ = _e5317;
                                    } else {
                                        phi_4167_ = _e5341;
                                    }
                                    let _e5344 = phi_4167_;
                                    let _e5346 = local_12.member_3;
                                    let _e5350 = local_12.member_2[0u];
                                    if (_e5350[0] < 0.0lf) {
                                        phi_4184_ = -(_e5350[0]);
                                    } else {
                                        phi_4184_ = _e5350[0];
                                    }
                                    let _e5357 = phi_4184_;
                                    if (_e5350[1] < 0.0lf) {
                                        phi_4191_ = -(_e5350[1]);
                                    } else {
                                        phi_4191_ = _e5350[1];
                                    }
                                    let _e5361 = phi_4191_;
                                    if (_e5357 > _e5361) {
                                        phi_4196_ = _e5357;
                                    } else {
                                        phi_4196_ = _e5361;
                                    }
                                    let _e5364 = phi_4196_;
                                    if (_e5350[2] < 0.0lf) {
                                        phi_4203_ = -(_e5350[2]);
                                    } else {
                                        phi_4203_ = _e5350[2];
                                    }
                                    let _e5368 = phi_4203_;
                                    if (_e5364 > _e5368) {
                                        phi_4208_ = _e5364;
                                    } else {
                                        phi_4208_ = _e5368;
                                    }
                                    let _e5371 = phi_4208_;
                                    let _e5374 = local_12.member_2[1u];
                                    if (_e5374[0] < 0.0lf) {
                                        phi_4222_ = -(_e5374[0]);
                                    } else {
                                        phi_4222_ = _e5374[0];
                                    }
                                    let _e5381 = phi_4222_;
                                    if (_e5374[1] < 0.0lf) {
                                        phi_4229_ = -(_e5374[1]);
                                    } else {
                                        phi_4229_ = _e5374[1];
                                    }
                                    let _e5385 = phi_4229_;
                                    if (_e5381 > _e5385) {
                                        phi_4234_ = _e5381;
                                    } else {
                                        phi_4234_ = _e5385;
                                    }
                                    let _e5388 = phi_4234_;
                                    if (_e5374[2] < 0.0lf) {
                                        phi_4241_ = -(_e5374[2]);
                                    } else {
                                        phi_4241_ = _e5374[2];
                                    }
                                    let _e5392 = phi_4241_;
                                    if (_e5388 > _e5392) {
                                        phi_4246_ = _e5388;
                                    } else {
                                        phi_4246_ = _e5392;
                                    }
                                    let _e5395 = phi_4246_;
                                    if (_e5371 > _e5395) {
                                        phi_4251_ = _e5371;
                                    } else {
                                        phi_4251_ = _e5395;
                                    }
                                    let _e5398 = phi_4251_;
                                    let _e5400 = local_12.member_3;
                                    let _e5408 = local_12.member_3;
                                    let _e5418 = (((_e5234 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5290 + _e5292) + (_e5344 + _e5346)) + (_e5398 + _e5400)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5408 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e579.member_1);
                                    if _e5418 {
                                        phi_4275_ = false;
                                    } else {
                                        phi_4275_ = true;
                                    }
                                    let _e5420 = phi_4275_;
                                    phi_4276_ = _e5420;
                                    phi_4277_ = _e5418;
                                } else {
                                    phi_4276_ = false;
                                    phi_4277_ = false;
                                }
                                let _e5422 = phi_4276_;
                                let _e5424 = phi_4277_;
                                local_28 = _e5424;
                                continue;
                                continuing {
                                    phi_3767_ = _e5089;
                                    break if !(_e5422);
                                }
                            }
                            let _e5427 = local_28;
                            if _e5427 {
                                phi_4282_ = type_42(1u, _e5065.member_1);
                                phi_4283_ = false;
                            } else {
                                phi_4282_ = type_42();
                                phi_4283_ = true;
                            }
                            let _e5430 = phi_4282_;
                            let _e5432 = phi_4283_;
                            if _e5432 {
                                phi_4288_ = type_42(2u, _e5065.member_1);
                                phi_4289_ = false;
                            } else {
                                phi_4288_ = type_42();
                                phi_4289_ = true;
                            }
                            let _e5435 = phi_4288_;
                            let _e5437 = phi_4289_;
                            phi_4291_ = _e5435;
                            phi_4292_ = _e5430;
                            phi_4293_ = _e5437;
                        } else {
                            phi_4291_ = type_42();
                            phi_4292_ = type_42(0u, type_42().member_1);
                            phi_4293_ = true;
                        }
                        let _e5439 = phi_4291_;
                        let _e5441 = phi_4292_;
                        let _e5443 = phi_4293_;
                        if _e5443 {
                            phi_4297_ = _e5441;
                        } else {
                            phi_4297_ = _e5439;
                        }
                        let _e5445 = phi_4297_;
                        phi_8267_ = _e5445;
                    } else {
                        if (_e717 < 0.0lf) {
                            phi_4308_ = -(_e717);
                        } else {
                            phi_4308_ = _e717;
                        }
                        let _e1074 = phi_4308_;
                        if (_e740 < 0.0lf) {
                            phi_4314_ = -(_e740);
                        } else {
                            phi_4314_ = _e740;
                        }
                        let _e1078 = phi_4314_;
                        if (_e1074 > _e1078) {
                            phi_4319_ = _e1074;
                        } else {
                            phi_4319_ = _e1078;
                        }
                        let _e1081 = phi_4319_;
                        if (_e763 < 0.0lf) {
                            phi_4325_ = -(_e763);
                        } else {
                            phi_4325_ = _e763;
                        }
                        let _e1085 = phi_4325_;
                        if (_e774 < 0.0lf) {
                            phi_4331_ = -(_e774);
                        } else {
                            phi_4331_ = _e774;
                        }
                        let _e1089 = phi_4331_;
                        if (_e1085 > _e1089) {
                            phi_4336_ = _e1085;
                        } else {
                            phi_4336_ = _e1089;
                        }
                        let _e1092 = phi_4336_;
                        if (_e1081 > _e1092) {
                            phi_4341_ = _e1081;
                        } else {
                            phi_4341_ = _e1092;
                        }
                        let _e1095 = phi_4341_;
                        let _e1097 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1098 = f64(1f);
                        if (_e1095 >= _e1097) {
                            phi_4351_ = (_e1095 <= (_e1098 / _e1097));
                        } else {
                            phi_4351_ = false;
                        }
                        let _e1103 = phi_4351_;
                        if _e1103 {
                            phi_4358_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4358_ = f64(2f);
                        }
                        let _e1108 = phi_4358_;
                        let _e1110 = ((_e1033 * f64(0.34f)) + (_e1095 * _e1108));
                        if _e1103 {
                            phi_4366_ = (_e1098 / _e1095);
                        } else {
                            phi_4366_ = f64(0f);
                        }
                        let _e1114 = phi_4366_;
                        let _e1115 = f64(0f);
                        let _e1116 = f64(1f);
                        let _e1117 = f64(3f);
                        let _e1123 = ((_e740 - (_e1117 * _e717)) * _e1114);
                        let _e1124 = ((_e763 - _e740) * _e1114);
                        let _e1125 = (((_e1117 * _e774) - _e763) * _e1114);
                        local_6[0u] = _e1115;
                        local_6[1u] = _e1116;
                        local_6[2u] = _e1116;
                        local_6[3u] = _e1116;
                        let _e1132 = ((_e1124 * _e1124) - (_e1123 * _e1125));
                        if (_e1132 > _e1115) {
                            if (_e1132 <= 2.2250738585072014e-308lf) {
                                if (_e1132 > 0.0lf) {
                                    phi_4402_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4402_ = 0.0lf;
                                }
                                let _e1185 = phi_4402_;
                                phi_4466_ = _e1185;
                            } else {
                                phi_4409_ = type_17(0i, 5i);
                                phi_4412_ = bitcast<f64>(((bitcast<u64>(_e1132) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e1140 = phi_4409_;
                                    let _e1142 = phi_4412_;
                                    local_13 = _e1142;
                                    if (_e1140.member < _e1140.member_1) {
                                        let _e1149 = (_e1140.member + 1i);
                                        if ((false == (_e1149 > _e1140.member)) != false) {
                                            phi_4433_ = true;
                                        } else {
                                            phi_4433_ = false;
                                        }
                                        let _e1154 = phi_4433_;
                                        if _e1154 {
                                            phi_4439_ = type_18(0u, type_18().member_1);
                                        } else {
                                            phi_4439_ = type_18(1u, _e1149);
                                        }
                                        let _e1159 = phi_4439_;
                                        phi_4410_ = type_17(_e1159.member_1, _e1140.member_1);
                                        phi_4453_ = type_18(1u, _e1140.member);
                                    } else {
                                        phi_4410_ = _e1140;
                                        phi_4453_ = type_18(0u, type_18().member_1);
                                    }
                                    let _e1165 = phi_4410_;
                                    let _e1167 = phi_4453_;
                                    let _e1170 = (bitcast<i32>(_e1167.member) != 0i);
                                    if _e1170 {
                                        phi_4413_ = (0.5lf * (_e1142 + (_e1132 / _e1142)));
                                    } else {
                                        phi_4413_ = f64();
                                    }
                                    let _e1175 = phi_4413_;
                                    continue;
                                    continuing {
                                        phi_4409_ = _e1165;
                                        phi_4412_ = _e1175;
                                        break if !(_e1170);
                                    }
                                }
                                let _e1180 = local_13;
                                phi_4466_ = (_e1180 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1187 = phi_4466_;
                            if (_e1124 < _e1115) {
                                phi_4472_ = -(_e1187);
                            } else {
                                phi_4472_ = _e1187;
                            }
                            let _e1191 = phi_4472_;
                            let _e1193 = -((_e1124 + _e1191));
                            local_7[0u] = (_e1193 / (_e1193 + _e1125));
                            local_7[1u] = (_e1123 / (_e1123 + _e1193));
                            let _e1202 = local_7[1u];
                            let _e1203 = local_7[0u];
                            if (_e1202 < _e1203) {
                                let _e1206 = local_7[1u];
                                let _e1208 = local_7[0u];
                                local_7[0u] = _e1206;
                                local_7[1u] = _e1208;
                            }
                            phi_4497_ = type_19(0u, 2u);
                            phi_4500_ = 1u;
                            loop {
                                let _e1212 = phi_4497_;
                                let _e1214 = phi_4500_;
                                local_29 = _e1214;
                                if (_e1212.member < _e1212.member_1) {
                                    phi_4498_ = type_19((_e1212.member + 1u), _e1212.member_1);
                                    phi_4523_ = type_19(1u, _e1212.member);
                                } else {
                                    phi_4498_ = _e1212;
                                    phi_4523_ = type_19(0u, type_19().member_1);
                                }
                                let _e1226 = phi_4498_;
                                let _e1228 = phi_4523_;
                                let _e1232 = (bitcast<i32>(_e1228.member) != 0i);
                                if _e1232 {
                                    let _e1234 = local_7[_e1228.member_1];
                                    if (_e1234 > _e1115) {
                                        let _e1237 = local_7[_e1228.member_1];
                                        if (_e1237 < _e1116) {
                                            let _e1240 = local_7[_e1228.member_1];
                                            local_6[_e1214] = _e1240;
                                            phi_4567_ = (_e1214 + 1u);
                                        } else {
                                            phi_4567_ = _e1214;
                                        }
                                        let _e1244 = phi_4567_;
                                        phi_4568_ = _e1244;
                                    } else {
                                        phi_4568_ = _e1214;
                                    }
                                    let _e1246 = phi_4568_;
                                    phi_4501_ = _e1246;
                                } else {
                                    phi_4501_ = u32();
                                }
                                let _e1248 = phi_4501_;
                                continue;
                                continuing {
                                    phi_4497_ = _e1226;
                                    phi_4500_ = _e1248;
                                    break if !(_e1232);
                                }
                            }
                            let _e5669 = local_29;
                            phi_4569_ = _e5669;
                        } else {
                            phi_4569_ = 1u;
                        }
                        let _e1251 = phi_4569_;
                        local_6[_e1251] = _e1116;
                        let _e1253 = local_6;
                        local_8 = _e1253;
                        phi_4589_ = type_19(0u, _e1251);
                        loop {
                            let _e1256 = phi_4589_;
                            if (_e1256.member < _e1256.member_1) {
                                phi_4590_ = type_19((_e1256.member + 1u), _e1256.member_1);
                                phi_4613_ = type_19(1u, _e1256.member);
                            } else {
                                phi_4590_ = _e1256;
                                phi_4613_ = type_19(0u, type_19().member_1);
                            }
                            let _e1268 = phi_4590_;
                            let _e1270 = phi_4613_;
                            if (bitcast<i32>(_e1270.member) != 0i) {
                                let _e1276 = local_8[_e1270.member_1];
                                let _e1279 = local_8[(_e1270.member_1 + 1u)];
                                let _e1281 = (f64(1f) - _e1276);
                                let _e1292 = ((((_e717 * _e1281) + (_e740 * _e1276)) * (_e1281 * _e1281)) + (((_e763 * _e1281) + (_e774 * _e1276)) * (_e1276 * _e1276)));
                                let _e1294 = (f64(1f) - _e1279);
                                let _e1305 = ((((_e717 * _e1294) + (_e740 * _e1279)) * (_e1294 * _e1294)) + (((_e763 * _e1294) + (_e774 * _e1279)) * (_e1279 * _e1279)));
                                if (_e1292 < 0.0lf) {
                                    phi_4667_ = -(_e1292);
                                } else {
                                    phi_4667_ = _e1292;
                                }
                                let _e1309 = phi_4667_;
                                let _e1310 = (_e1309 > _e1110);
                                if (_e1305 < 0.0lf) {
                                    phi_4674_ = -(_e1305);
                                } else {
                                    phi_4674_ = _e1305;
                                }
                                let _e1314 = phi_4674_;
                                let _e1315 = (_e1314 > _e1110);
                                let _e1316 = f64(0f);
                                if _e1310 {
                                    if _e1315 {
                                        phi_4686_ = ((_e1292 > _e1316) != (_e1305 > _e1316));
                                        phi_4687_ = false;
                                    } else {
                                        phi_4686_ = bool();
                                        phi_4687_ = true;
                                    }
                                    let _e1321 = phi_4686_;
                                    let _e1323 = phi_4687_;
                                    phi_4688_ = _e1321;
                                    phi_4689_ = _e1323;
                                } else {
                                    phi_4688_ = bool();
                                    phi_4689_ = true;
                                }
                                let _e1325 = phi_4688_;
                                let _e1327 = phi_4689_;
                                if _e1327 {
                                    phi_4693_ = false;
                                } else {
                                    phi_4693_ = _e1325;
                                }
                                let _e1329 = phi_4693_;
                                if _e1310 {
                                    if _e1315 {
                                        if _e1329 {
                                            phi_4705_ = type_43();
                                        } else {
                                            phi_4705_ = type_43(f64(1f), _e1316, _e1329);
                                        }
                                        let _e1333 = phi_4705_;
                                        phi_4706_ = _e1333;
                                        phi_4707_ = _e1329;
                                    } else {
                                        phi_4706_ = type_43();
                                        phi_4707_ = true;
                                    }
                                    let _e1335 = phi_4706_;
                                    let _e1337 = phi_4707_;
                                    phi_4708_ = _e1335;
                                    phi_4709_ = _e1337;
                                } else {
                                    phi_4708_ = type_43();
                                    phi_4709_ = true;
                                }
                                let _e1339 = phi_4708_;
                                let _e1341 = phi_4709_;
                                if _e1341 {
                                    if _e1310 {
                                        if (_e1292 < _e1316) {
                                            phi_4722_ = f64(-1f);
                                        } else {
                                            phi_4722_ = f64(1f);
                                        }
                                        let _e1346 = phi_4722_;
                                        let _e1347 = f64(0.00000000000022737368f);
                                        let _e1348 = f64(0.5f);
                                        let _e1349 = f64(3f);
                                        let _e1352 = (_e763 - _e740);
                                        phi_4735_ = type_19(0u, 64u);
                                        phi_4738_ = _e1279;
                                        phi_4740_ = _e1276;
                                        phi_4742_ = (_e1348 * (_e1276 + _e1279));
                                        loop {
                                            let _e1358 = phi_4735_;
                                            let _e1360 = phi_4738_;
                                            let _e1362 = phi_4740_;
                                            let _e1364 = phi_4742_;
                                            local_31 = _e1362;
                                            if (_e1358.member < _e1358.member_1) {
                                                phi_4736_ = type_19((_e1358.member + 1u), _e1358.member_1);
                                                phi_4765_ = type_19(1u, _e1358.member);
                                            } else {
                                                phi_4736_ = _e1358;
                                                phi_4765_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1376 = phi_4736_;
                                            let _e1378 = phi_4765_;
                                            if (bitcast<i32>(_e1378.member) != 0i) {
                                                let _e1383 = (f64(1f) - _e1364);
                                                let _e1396 = ((_e1346 * ((((_e717 * _e1383) + (_e740 * _e1364)) * (_e1383 * _e1383)) + (((_e763 * _e1383) + (_e774 * _e1364)) * (_e1364 * _e1364)))) - _e1110);
                                                if (_e1396 > f64(0f)) {
                                                    phi_4792_ = _e1360;
                                                    phi_4793_ = _e1364;
                                                } else {
                                                    phi_4792_ = _e1364;
                                                    phi_4793_ = _e1362;
                                                }
                                                let _e1400 = phi_4792_;
                                                let _e1402 = phi_4793_;
                                                let _e1404 = ((_e1400 - _e1402) > _e1347);
                                                if _e1404 {
                                                    let _e1406 = (f64(1f) - _e1364);
                                                    let _e1418 = (-(_e1396) / (_e1346 * (((((_e740 - (_e1349 * _e717)) * _e1406) + (_e1352 * _e1364)) * _e1406) + (((_e1352 * _e1406) + (((_e1349 * _e774) - _e763) * _e1364)) * _e1364))));
                                                    if (_e1396 > f64(0f)) {
                                                        phi_4821_ = (_e1348 * _e1347);
                                                    } else {
                                                        phi_4821_ = -((_e1348 * _e1347));
                                                    }
                                                    let _e1425 = phi_4821_;
                                                    let _e1427 = ((_e1364 + _e1418) + _e1425);
                                                    if (_e1427 > _e1402) {
                                                        if (_e1427 < _e1400) {
                                                            if (_e1418 < 0.0lf) {
                                                                phi_4837_ = -(_e1418);
                                                            } else {
                                                                phi_4837_ = _e1418;
                                                            }
                                                            let _e1433 = phi_4837_;
                                                            if (_e1433 < (_e1348 * (_e1400 - _e1402))) {
                                                                phi_4844_ = false;
                                                            } else {
                                                                phi_4844_ = true;
                                                            }
                                                            let _e1438 = phi_4844_;
                                                            phi_4845_ = _e1438;
                                                        } else {
                                                            phi_4845_ = true;
                                                        }
                                                        let _e1440 = phi_4845_;
                                                        phi_4846_ = _e1440;
                                                    } else {
                                                        phi_4846_ = true;
                                                    }
                                                    let _e1442 = phi_4846_;
                                                    if _e1442 {
                                                        phi_4852_ = (_e1348 * (_e1402 + _e1400));
                                                    } else {
                                                        phi_4852_ = _e1427;
                                                    }
                                                    let _e1446 = phi_4852_;
                                                    phi_4853_ = _e1446;
                                                    phi_4854_ = false;
                                                } else {
                                                    phi_4853_ = f64();
                                                    phi_4854_ = true;
                                                }
                                                let _e1448 = phi_4853_;
                                                let _e1450 = phi_4854_;
                                                phi_4739_ = _e1400;
                                                phi_4741_ = _e1402;
                                                phi_4743_ = _e1448;
                                                phi_4855_ = _e1402;
                                                phi_4856_ = _e1404;
                                                phi_4857_ = _e1450;
                                            } else {
                                                phi_4739_ = f64();
                                                phi_4741_ = f64();
                                                phi_4743_ = f64();
                                                phi_4855_ = f64();
                                                phi_4856_ = false;
                                                phi_4857_ = false;
                                            }
                                            let _e1452 = phi_4739_;
                                            let _e1454 = phi_4741_;
                                            let _e1456 = phi_4743_;
                                            let _e1458 = phi_4855_;
                                            let _e1460 = phi_4856_;
                                            let _e1462 = phi_4857_;
                                            local_14 = _e1462;
                                            local_30 = _e1458;
                                            continue;
                                            continuing {
                                                phi_4735_ = _e1376;
                                                phi_4738_ = _e1452;
                                                phi_4740_ = _e1454;
                                                phi_4742_ = _e1456;
                                                break if !(_e1460);
                                            }
                                        }
                                        let _e1465 = local_14;
                                        if _e1465 {
                                            let _e5711 = local_30;
                                            phi_4861_ = _e5711;
                                        } else {
                                            let _e5713 = local_31;
                                            phi_4861_ = _e5713;
                                        }
                                        let _e1467 = phi_4861_;
                                        phi_4862_ = _e1467;
                                    } else {
                                        phi_4862_ = _e1276;
                                    }
                                    let _e1469 = phi_4862_;
                                    if _e1315 {
                                        if (_e1305 < _e1316) {
                                            phi_4872_ = f64(-1f);
                                        } else {
                                            phi_4872_ = f64(1f);
                                        }
                                        let _e1474 = phi_4872_;
                                        phi_4877_ = type_19(0u, 64u);
                                        phi_4880_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1478 = phi_4877_;
                                            let _e1480 = phi_4880_;
                                            if (_e1478.member < _e1478.member_1) {
                                                phi_4878_ = type_19((_e1478.member + 1u), _e1478.member_1);
                                                phi_4903_ = type_19(1u, _e1478.member);
                                            } else {
                                                phi_4878_ = _e1478;
                                                phi_4903_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1492 = phi_4878_;
                                            let _e1494 = phi_4903_;
                                            if (bitcast<i32>(_e1494.member) != 0i) {
                                                let _e1498 = (_e1469 + _e1480);
                                                if (_e1498 < _e1279) {
                                                    let _e1501 = (f64(1f) - _e1498);
                                                    let _e1514 = ((_e1474 * ((((_e717 * _e1501) + (_e740 * _e1498)) * (_e1501 * _e1501)) + (((_e763 * _e1501) + (_e774 * _e1498)) * (_e1498 * _e1498)))) > _e1110);
                                                    if _e1514 {
                                                        phi_4934_ = f64();
                                                        phi_4935_ = false;
                                                    } else {
                                                        phi_4934_ = (_e1480 + _e1480);
                                                        phi_4935_ = true;
                                                    }
                                                    let _e1517 = phi_4934_;
                                                    let _e1519 = phi_4935_;
                                                    phi_4936_ = _e1517;
                                                    phi_4937_ = _e1519;
                                                    phi_4938_ = _e1514;
                                                    phi_4939_ = false;
                                                } else {
                                                    phi_4936_ = f64();
                                                    phi_4937_ = false;
                                                    phi_4938_ = false;
                                                    phi_4939_ = true;
                                                }
                                                let _e1521 = phi_4936_;
                                                let _e1523 = phi_4937_;
                                                let _e1525 = phi_4938_;
                                                let _e1527 = phi_4939_;
                                                phi_4940_ = _e1498;
                                                phi_4881_ = _e1521;
                                                phi_4941_ = _e1523;
                                                phi_4942_ = _e1525;
                                                phi_4943_ = _e1527;
                                                phi_4944_ = false;
                                            } else {
                                                phi_4940_ = f64();
                                                phi_4881_ = f64();
                                                phi_4941_ = false;
                                                phi_4942_ = false;
                                                phi_4943_ = false;
                                                phi_4944_ = true;
                                            }
                                            let _e1529 = phi_4940_;
                                            let _e1531 = phi_4881_;
                                            let _e1533 = phi_4941_;
                                            let _e1535 = phi_4942_;
                                            let _e1537 = phi_4943_;
                                            let _e1539 = phi_4944_;
                                            local_15 = _e1535;
                                            local_32 = _e1537;
                                            local_33 = _e1539;
                                            local_34 = _e1529;
                                            continue;
                                            continuing {
                                                phi_4877_ = _e1492;
                                                phi_4880_ = _e1531;
                                                break if !(_e1533);
                                            }
                                        }
                                        let _e1542 = local_15;
                                        if _e1542 {
                                            phi_4948_ = false;
                                            phi_4949_ = false;
                                        } else {
                                            let _e5735 = local_32;
                                            phi_4948_ = _e5735;
                                            let _e5738 = local_33;
                                            phi_4949_ = _e5738;
                                        }
                                        let _e1544 = phi_4948_;
                                        let _e1546 = phi_4949_;
                                        if _e1544 {
                                            phi_4953_ = true;
                                        } else {
                                            phi_4953_ = _e1546;
                                        }
                                        let _e1548 = phi_4953_;
                                        if _e1548 {
                                            phi_4957_ = _e1279;
                                        } else {
                                            let _e5742 = local_34;
                                            phi_4957_ = _e5742;
                                        }
                                        let _e1550 = phi_4957_;
                                        phi_4958_ = _e1550;
                                    } else {
                                        phi_4958_ = _e1279;
                                    }
                                    let _e1552 = phi_4958_;
                                    phi_4960_ = type_43(_e1469, _e1552, _e1329);
                                } else {
                                    phi_4960_ = _e1339;
                                }
                                let _e1555 = phi_4960_;
                                if (_e1555.member > _e1555.member_1) {
                                    phi_8223_ = f64();
                                    phi_8224_ = true;
                                    phi_8225_ = false;
                                    phi_8226_ = false;
                                    phi_8227_ = false;
                                } else {
                                    let _e1563 = ((_e1555.member_1 - _e1555.member) * f64(0.5f));
                                    let _e1564 = (_e1555.member + _e1563);
                                    let _e1567 = (_e1563 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1569 = local_12.member_3;
                                    let _e1572 = local_12.member[0u];
                                    if (_e1572[0] < 0.0lf) {
                                        phi_4991_ = -(_e1572[0]);
                                    } else {
                                        phi_4991_ = _e1572[0];
                                    }
                                    let _e1579 = phi_4991_;
                                    if (_e1572[1] < 0.0lf) {
                                        phi_4998_ = -(_e1572[1]);
                                    } else {
                                        phi_4998_ = _e1572[1];
                                    }
                                    let _e1583 = phi_4998_;
                                    if (_e1579 > _e1583) {
                                        phi_5003_ = _e1579;
                                    } else {
                                        phi_5003_ = _e1583;
                                    }
                                    let _e1586 = phi_5003_;
                                    if (_e1572[2] < 0.0lf) {
                                        phi_5010_ = -(_e1572[2]);
                                    } else {
                                        phi_5010_ = _e1572[2];
                                    }
                                    let _e1590 = phi_5010_;
                                    if (_e1586 > _e1590) {
                                        phi_5015_ = _e1586;
                                    } else {
                                        phi_5015_ = _e1590;
                                    }
                                    let _e1593 = phi_5015_;
                                    let _e1595 = local_12.member[1u];
                                    if (_e1595[0] < 0.0lf) {
                                        phi_5028_ = -(_e1595[0]);
                                    } else {
                                        phi_5028_ = _e1595[0];
                                    }
                                    let _e1602 = phi_5028_;
                                    if (_e1595[1] < 0.0lf) {
                                        phi_5035_ = -(_e1595[1]);
                                    } else {
                                        phi_5035_ = _e1595[1];
                                    }
                                    let _e1606 = phi_5035_;
                                    if (_e1602 > _e1606) {
                                        phi_5040_ = _e1602;
                                    } else {
                                        phi_5040_ = _e1606;
                                    }
                                    let _e1609 = phi_5040_;
                                    if (_e1595[2] < 0.0lf) {
                                        phi_5047_ = -(_e1595[2]);
                                    } else {
                                        phi_5047_ = _e1595[2];
                                    }
                                    let _e1613 = phi_5047_;
                                    if (_e1609 > _e1613) {
                                        phi_5052_ = _e1609;
                                    } else {
                                        phi_5052_ = _e1613;
                                    }
                                    let _e1616 = phi_5052_;
                                    if (_e1593 > _e1616) {
                                        phi_5057_ = _e1593;
                                    } else {
                                        phi_5057_ = _e1616;
                                    }
                                    let _e1619 = phi_5057_;
                                    let _e1622 = local_12.member[0u];
                                    let _e1627 = local_12.member[1u];
                                    let _e1637 = (_e1622[0] + ((_e1627[0] - _e1622[0]) * _e1564));
                                    let _e1638 = (_e1622[1] + ((_e1627[1] - _e1622[1]) * _e1564));
                                    let _e1639 = (_e1622[2] + ((_e1627[2] - _e1622[2]) * _e1564));
                                    let _e1641 = local_12.member[1u];
                                    let _e1646 = local_12.member[0u];
                                    let _e1650 = (_e1641[0] - _e1646[0]);
                                    let _e1651 = (_e1641[1] - _e1646[1]);
                                    let _e1652 = (_e1641[2] - _e1646[2]);
                                    if (_e1650 < 0.0lf) {
                                        phi_5116_ = -(_e1650);
                                    } else {
                                        phi_5116_ = _e1650;
                                    }
                                    let _e1656 = phi_5116_;
                                    if (_e1651 < 0.0lf) {
                                        phi_5122_ = -(_e1651);
                                    } else {
                                        phi_5122_ = _e1651;
                                    }
                                    let _e1660 = phi_5122_;
                                    if (_e1656 > _e1660) {
                                        phi_5127_ = _e1656;
                                    } else {
                                        phi_5127_ = _e1660;
                                    }
                                    let _e1663 = phi_5127_;
                                    if (_e1652 < 0.0lf) {
                                        phi_5133_ = -(_e1652);
                                    } else {
                                        phi_5133_ = _e1652;
                                    }
                                    let _e1667 = phi_5133_;
                                    if (_e1663 > _e1667) {
                                        phi_5138_ = _e1663;
                                    } else {
                                        phi_5138_ = _e1667;
                                    }
                                    let _e1670 = phi_5138_;
                                    let _e1678 = ((((_e1567 * _e1670) * f64(1.01f)) + ((_e1619 + _e1569) * (1.1102230246251565e-16lf * f64(8f)))) + _e1569);
                                    if (_e1637 < 0.0lf) {
                                        phi_5152_ = -(_e1637);
                                    } else {
                                        phi_5152_ = _e1637;
                                    }
                                    let _e1682 = phi_5152_;
                                    if (_e1638 < 0.0lf) {
                                        phi_5158_ = -(_e1638);
                                    } else {
                                        phi_5158_ = _e1638;
                                    }
                                    let _e1686 = phi_5158_;
                                    if (_e1682 > _e1686) {
                                        phi_5163_ = _e1682;
                                    } else {
                                        phi_5163_ = _e1686;
                                    }
                                    let _e1689 = phi_5163_;
                                    if (_e1639 < 0.0lf) {
                                        phi_5169_ = -(_e1639);
                                    } else {
                                        phi_5169_ = _e1639;
                                    }
                                    let _e1693 = phi_5169_;
                                    if (_e1689 > _e1693) {
                                        phi_5174_ = _e1689;
                                    } else {
                                        phi_5174_ = _e1693;
                                    }
                                    let _e1696 = phi_5174_;
                                    local_2 = type_33(array<f64, 3>(_e1637, _e1638, _e1639), _e1678, (_e1696 + _e1678));
                                    let _e1702 = local_12.member_3;
                                    let _e1704 = local_12.member_1[0u];
                                    if (_e1704[0] < 0.0lf) {
                                        phi_5200_ = -(_e1704[0]);
                                    } else {
                                        phi_5200_ = _e1704[0];
                                    }
                                    let _e1711 = phi_5200_;
                                    if (_e1704[1] < 0.0lf) {
                                        phi_5207_ = -(_e1704[1]);
                                    } else {
                                        phi_5207_ = _e1704[1];
                                    }
                                    let _e1715 = phi_5207_;
                                    if (_e1711 > _e1715) {
                                        phi_5212_ = _e1711;
                                    } else {
                                        phi_5212_ = _e1715;
                                    }
                                    let _e1718 = phi_5212_;
                                    if (_e1704[2] < 0.0lf) {
                                        phi_5219_ = -(_e1704[2]);
                                    } else {
                                        phi_5219_ = _e1704[2];
                                    }
                                    let _e1722 = phi_5219_;
                                    if (_e1718 > _e1722) {
                                        phi_5224_ = _e1718;
                                    } else {
                                        phi_5224_ = _e1722;
                                    }
                                    let _e1725 = phi_5224_;
                                    let _e1727 = local_12.member_1[1u];
                                    if (_e1727[0] < 0.0lf) {
                                        phi_5237_ = -(_e1727[0]);
                                    } else {
                                        phi_5237_ = _e1727[0];
                                    }
                                    let _e1734 = phi_5237_;
                                    if (_e1727[1] < 0.0lf) {
                                        phi_5244_ = -(_e1727[1]);
                                    } else {
                                        phi_5244_ = _e1727[1];
                                    }
                                    let _e1738 = phi_5244_;
                                    if (_e1734 > _e1738) {
                                        phi_5249_ = _e1734;
                                    } else {
                                        phi_5249_ = _e1738;
                                    }
                                    let _e1741 = phi_5249_;
                                    if (_e1727[2] < 0.0lf) {
                                        phi_5256_ = -(_e1727[2]);
                                    } else {
                                        phi_5256_ = _e1727[2];
                                    }
                                    let _e1745 = phi_5256_;
                                    if (_e1741 > _e1745) {
                                        phi_5261_ = _e1741;
                                    } else {
                                        phi_5261_ = _e1745;
                                    }
                                    let _e1748 = phi_5261_;
                                    if (_e1725 > _e1748) {
                                        phi_5266_ = _e1725;
                                    } else {
                                        phi_5266_ = _e1748;
                                    }
                                    let _e1751 = phi_5266_;
                                    let _e1754 = local_12.member_1[0u];
                                    let _e1759 = local_12.member_1[1u];
                                    let _e1769 = (_e1754[0] + ((_e1759[0] - _e1754[0]) * _e1564));
                                    let _e1770 = (_e1754[1] + ((_e1759[1] - _e1754[1]) * _e1564));
                                    let _e1771 = (_e1754[2] + ((_e1759[2] - _e1754[2]) * _e1564));
                                    let _e1773 = local_12.member_1[1u];
                                    let _e1778 = local_12.member_1[0u];
                                    let _e1782 = (_e1773[0] - _e1778[0]);
                                    let _e1783 = (_e1773[1] - _e1778[1]);
                                    let _e1784 = (_e1773[2] - _e1778[2]);
                                    if (_e1782 < 0.0lf) {
                                        phi_5325_ = -(_e1782);
                                    } else {
                                        phi_5325_ = _e1782;
                                    }
                                    let _e1788 = phi_5325_;
                                    if (_e1783 < 0.0lf) {
                                        phi_5331_ = -(_e1783);
                                    } else {
                                        phi_5331_ = _e1783;
                                    }
                                    let _e1792 = phi_5331_;
                                    if (_e1788 > _e1792) {
                                        phi_5336_ = _e1788;
                                    } else {
                                        phi_5336_ = _e1792;
                                    }
                                    let _e1795 = phi_5336_;
                                    if (_e1784 < 0.0lf) {
                                        phi_5342_ = -(_e1784);
                                    } else {
                                        phi_5342_ = _e1784;
                                    }
                                    let _e1799 = phi_5342_;
                                    if (_e1795 > _e1799) {
                                        phi_5347_ = _e1795;
                                    } else {
                                        phi_5347_ = _e1799;
                                    }
                                    let _e1802 = phi_5347_;
                                    let _e1810 = ((((_e1567 * _e1802) * f64(1.01f)) + ((_e1751 + _e1702) * (1.1102230246251565e-16lf * f64(8f)))) + _e1702);
                                    if (_e1769 < 0.0lf) {
                                        phi_5361_ = -(_e1769);
                                    } else {
                                        phi_5361_ = _e1769;
                                    }
                                    let _e1814 = phi_5361_;
                                    if (_e1770 < 0.0lf) {
                                        phi_5367_ = -(_e1770);
                                    } else {
                                        phi_5367_ = _e1770;
                                    }
                                    let _e1818 = phi_5367_;
                                    if (_e1814 > _e1818) {
                                        phi_5372_ = _e1814;
                                    } else {
                                        phi_5372_ = _e1818;
                                    }
                                    let _e1821 = phi_5372_;
                                    if (_e1771 < 0.0lf) {
                                        phi_5378_ = -(_e1771);
                                    } else {
                                        phi_5378_ = _e1771;
                                    }
                                    let _e1825 = phi_5378_;
                                    if (_e1821 > _e1825) {
                                        phi_5383_ = _e1821;
                                    } else {
                                        phi_5383_ = _e1825;
                                    }
                                    let _e1828 = phi_5383_;
                                    local_3 = type_33(array<f64, 3>(_e1769, _e1770, _e1771), _e1810, (_e1828 + _e1810));
                                    let _e1834 = local_12.member_3;
                                    let _e1836 = local_12.member_2[0u];
                                    if (_e1836[0] < 0.0lf) {
                                        phi_5409_ = -(_e1836[0]);
                                    } else {
                                        phi_5409_ = _e1836[0];
                                    }
                                    let _e1843 = phi_5409_;
                                    if (_e1836[1] < 0.0lf) {
                                        phi_5416_ = -(_e1836[1]);
                                    } else {
                                        phi_5416_ = _e1836[1];
                                    }
                                    let _e1847 = phi_5416_;
                                    if (_e1843 > _e1847) {
                                        phi_5421_ = _e1843;
                                    } else {
                                        phi_5421_ = _e1847;
                                    }
                                    let _e1850 = phi_5421_;
                                    if (_e1836[2] < 0.0lf) {
                                        phi_5428_ = -(_e1836[2]);
                                    } else {
                                        phi_5428_ = _e1836[2];
                                    }
                                    let _e1854 = phi_5428_;
                                    if (_e1850 > _e1854) {
                                        phi_5433_ = _e1850;
                                    } else {
                                        phi_5433_ = _e1854;
                                    }
                                    let _e1857 = phi_5433_;
                                    let _e1859 = local_12.member_2[1u];
                                    if (_e1859[0] < 0.0lf) {
                                        phi_5446_ = -(_e1859[0]);
                                    } else {
                                        phi_5446_ = _e1859[0];
                                    }
                                    let _e1866 = phi_5446_;
                                    if (_e1859[1] < 0.0lf) {
                                        phi_5453_ = -(_e1859[1]);
                                    } else {
                                        phi_5453_ = _e1859[1];
                                    }
                                    let _e1870 = phi_5453_;
                                    if (_e1866 > _e1870) {
                                        phi_5458_ = _e1866;
                                    } else {
                                        phi_5458_ = _e1870;
                                    }
                                    let _e1873 = phi_5458_;
                                    if (_e1859[2] < 0.0lf) {
                                        phi_5465_ = -(_e1859[2]);
                                    } else {
                                        phi_5465_ = _e1859[2];
                                    }
                                    let _e1877 = phi_5465_;
                                    if (_e1873 > _e1877) {
                                        phi_5470_ = _e1873;
                                    } else {
                                        phi_5470_ = _e1877;
                                    }
                                    let _e1880 = phi_5470_;
                                    if (_e1857 > _e1880) {
                                        phi_5475_ = _e1857;
                                    } else {
                                        phi_5475_ = _e1880;
                                    }
                                    let _e1883 = phi_5475_;
                                    let _e1886 = local_12.member_2[0u];
                                    let _e1891 = local_12.member_2[1u];
                                    let _e1901 = (_e1886[0] + ((_e1891[0] - _e1886[0]) * _e1564));
                                    let _e1902 = (_e1886[1] + ((_e1891[1] - _e1886[1]) * _e1564));
                                    let _e1903 = (_e1886[2] + ((_e1891[2] - _e1886[2]) * _e1564));
                                    let _e1905 = local_12.member_2[1u];
                                    let _e1910 = local_12.member_2[0u];
                                    let _e1914 = (_e1905[0] - _e1910[0]);
                                    let _e1915 = (_e1905[1] - _e1910[1]);
                                    let _e1916 = (_e1905[2] - _e1910[2]);
                                    if (_e1914 < 0.0lf) {
                                        phi_5534_ = -(_e1914);
                                    } else {
                                        phi_5534_ = _e1914;
                                    }
                                    let _e1920 = phi_5534_;
                                    if (_e1915 < 0.0lf) {
                                        phi_5540_ = -(_e1915);
                                    } else {
                                        phi_5540_ = _e1915;
                                    }
                                    let _e1924 = phi_5540_;
                                    if (_e1920 > _e1924) {
                                        phi_5545_ = _e1920;
                                    } else {
                                        phi_5545_ = _e1924;
                                    }
                                    let _e1927 = phi_5545_;
                                    if (_e1916 < 0.0lf) {
                                        phi_5551_ = -(_e1916);
                                    } else {
                                        phi_5551_ = _e1916;
                                    }
                                    let _e1931 = phi_5551_;
                                    if (_e1927 > _e1931) {
                                        phi_5556_ = _e1927;
                                    } else {
                                        phi_5556_ = _e1931;
                                    }
                                    let _e1934 = phi_5556_;
                                    let _e1942 = ((((_e1567 * _e1934) * f64(1.01f)) + ((_e1883 + _e1834) * (1.1102230246251565e-16lf * f64(8f)))) + _e1834);
                                    if (_e1901 < 0.0lf) {
                                        phi_5570_ = -(_e1901);
                                    } else {
                                        phi_5570_ = _e1901;
                                    }
                                    let _e1946 = phi_5570_;
                                    if (_e1902 < 0.0lf) {
                                        phi_5576_ = -(_e1902);
                                    } else {
                                        phi_5576_ = _e1902;
                                    }
                                    let _e1950 = phi_5576_;
                                    if (_e1946 > _e1950) {
                                        phi_5581_ = _e1946;
                                    } else {
                                        phi_5581_ = _e1950;
                                    }
                                    let _e1953 = phi_5581_;
                                    if (_e1903 < 0.0lf) {
                                        phi_5587_ = -(_e1903);
                                    } else {
                                        phi_5587_ = _e1903;
                                    }
                                    let _e1957 = phi_5587_;
                                    if (_e1953 > _e1957) {
                                        phi_5592_ = _e1953;
                                    } else {
                                        phi_5592_ = _e1957;
                                    }
                                    let _e1960 = phi_5592_;
                                    local_4 = type_33(array<f64, 3>(_e1901, _e1902, _e1903), _e1942, (_e1960 + _e1942));
                                    let _e1965 = local_3.member;
                                    let _e1970 = local_4.member;
                                    let _e1976 = ((_e1965[1] * _e1970[2]) - (_e1965[2] * _e1970[1]));
                                    let _e1979 = ((_e1965[2] * _e1970[0]) - (_e1965[0] * _e1970[2]));
                                    let _e1982 = ((_e1965[0] * _e1970[1]) - (_e1965[1] * _e1970[0]));
                                    if (_e1976 < 0.0lf) {
                                        phi_5641_ = -(_e1976);
                                    } else {
                                        phi_5641_ = _e1976;
                                    }
                                    let _e1986 = phi_5641_;
                                    if (_e1979 < 0.0lf) {
                                        phi_5647_ = -(_e1979);
                                    } else {
                                        phi_5647_ = _e1979;
                                    }
                                    let _e1990 = phi_5647_;
                                    if (_e1986 > _e1990) {
                                        if (_e1976 < 0.0lf) {
                                            phi_5657_ = -(_e1976);
                                        } else {
                                            phi_5657_ = _e1976;
                                        }
                                        let _e2008 = phi_5657_;
                                        if (_e1982 < 0.0lf) {
                                            phi_5663_ = -(_e1982);
                                        } else {
                                            phi_5663_ = _e1982;
                                        }
                                        let _e2012 = phi_5663_;
                                        if (_e2008 > _e2012) {
                                            phi_5668_ = 2u;
                                            phi_5669_ = 1u;
                                        } else {
                                            phi_5668_ = 1u;
                                            phi_5669_ = 0u;
                                        }
                                        let _e2015 = phi_5668_;
                                        let _e2017 = phi_5669_;
                                        phi_5688_ = _e2015;
                                        phi_5689_ = _e2017;
                                    } else {
                                        if (_e1979 < 0.0lf) {
                                            phi_5675_ = -(_e1979);
                                        } else {
                                            phi_5675_ = _e1979;
                                        }
                                        let _e1995 = phi_5675_;
                                        if (_e1982 < 0.0lf) {
                                            phi_5681_ = -(_e1982);
                                        } else {
                                            phi_5681_ = _e1982;
                                        }
                                        let _e1999 = phi_5681_;
                                        if (_e1995 > _e1999) {
                                            phi_5686_ = 0u;
                                            phi_5687_ = 2u;
                                        } else {
                                            phi_5686_ = 1u;
                                            phi_5687_ = 0u;
                                        }
                                        let _e2002 = phi_5686_;
                                        let _e2004 = phi_5687_;
                                        phi_5688_ = _e2002;
                                        phi_5689_ = _e2004;
                                    }
                                    let _e2019 = phi_5688_;
                                    let _e2021 = phi_5689_;
                                    let _e2024 = local_3.member[_e2021];
                                    let _e2027 = local_4.member[_e2019];
                                    let _e2031 = local_3.member[_e2019];
                                    let _e2034 = local_4.member[_e2021];
                                    let _e2036 = ((_e2024 * _e2027) - (_e2031 * _e2034));
                                    let _e2037 = f64(1f);
                                    let _e2038 = f64(2f);
                                    let _e2040 = local_3.member_1;
                                    let _e2042 = local_4.member_2;
                                    let _e2045 = local_3.member_2;
                                    let _e2047 = local_4.member_1;
                                    let _e2053 = local_3.member_2;
                                    let _e2056 = local_4.member_2;
                                    let _e2065 = local_3.member_2;
                                    let _e2068 = local_4.member_2;
                                    let _e2072 = (((((_e2040 * _e2042) + (_e2045 * _e2047)) * f64(2.01f)) + (((_e2053 * _e2038) * (_e2056 * _e2038)) * (1.1102230246251565e-16lf * _e2038))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2037 + _e2065) * (_e2037 + _e2068))));
                                    if (_e2036 < 0.0lf) {
                                        phi_5762_ = -(_e2036);
                                    } else {
                                        phi_5762_ = _e2036;
                                    }
                                    let _e2076 = phi_5762_;
                                    if (_e2076 > _e2072) {
                                        if (_e2036 < f64(0f)) {
                                            phi_5774_ = f64(-1f);
                                        } else {
                                            phi_5774_ = f64(1f);
                                        }
                                        let _e2083 = phi_5774_;
                                        let _e2086 = local_2.member[_e2021];
                                        let _e2089 = local_4.member[_e2019];
                                        let _e2093 = local_2.member[_e2019];
                                        let _e2096 = local_4.member[_e2021];
                                        let _e2099 = f64(1f);
                                        let _e2100 = f64(2f);
                                        let _e2102 = local_2.member_1;
                                        let _e2104 = local_4.member_2;
                                        let _e2107 = local_2.member_2;
                                        let _e2109 = local_4.member_1;
                                        let _e2115 = local_2.member_2;
                                        let _e2118 = local_4.member_2;
                                        let _e2127 = local_2.member_2;
                                        let _e2130 = local_4.member_2;
                                        let _e2134 = (((((_e2102 * _e2104) + (_e2107 * _e2109)) * f64(2.01f)) + (((_e2115 * _e2100) * (_e2118 * _e2100)) * (1.1102230246251565e-16lf * _e2100))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2099 + _e2127) * (_e2099 + _e2130))));
                                        let _e2137 = local_3.member[_e2021];
                                        let _e2140 = local_2.member[_e2019];
                                        let _e2144 = local_3.member[_e2019];
                                        let _e2147 = local_2.member[_e2021];
                                        let _e2150 = f64(1f);
                                        let _e2151 = f64(2f);
                                        let _e2153 = local_3.member_1;
                                        let _e2155 = local_2.member_2;
                                        let _e2158 = local_3.member_2;
                                        let _e2160 = local_2.member_1;
                                        let _e2166 = local_3.member_2;
                                        let _e2169 = local_2.member_2;
                                        let _e2178 = local_3.member_2;
                                        let _e2181 = local_2.member_2;
                                        let _e2185 = (((((_e2153 * _e2155) + (_e2158 * _e2160)) * f64(2.01f)) + (((_e2166 * _e2151) * (_e2169 * _e2151)) * (1.1102230246251565e-16lf * _e2151))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2150 + _e2178) * (_e2150 + _e2181))));
                                        let _e2186 = (_e2036 * _e2083);
                                        let _e2187 = (((_e2086 * _e2089) - (_e2093 * _e2096)) * _e2083);
                                        let _e2188 = (((_e2137 * _e2140) - (_e2144 * _e2147)) * _e2083);
                                        if (_e2186 < 0.0lf) {
                                            phi_5917_ = -(_e2186);
                                        } else {
                                            phi_5917_ = _e2186;
                                        }
                                        let _e2192 = phi_5917_;
                                        if (_e2187 < 0.0lf) {
                                            phi_5923_ = -(_e2187);
                                        } else {
                                            phi_5923_ = _e2187;
                                        }
                                        let _e2196 = phi_5923_;
                                        if (_e2188 < 0.0lf) {
                                            phi_5930_ = -(_e2188);
                                        } else {
                                            phi_5930_ = _e2188;
                                        }
                                        let _e2201 = phi_5930_;
                                        let _e2205 = (((_e2192 + _e2196) + _e2201) * (1.1102230246251565e-16lf * f64(4f)));
                                        local_5[0u].member = _e2187;
                                        local_5[0u].member_1 = _e2134;
                                        local_5[1u].member = _e2188;
                                        local_5[1u].member_1 = _e2185;
                                        local_5[2u].member = (_e2186 - _e2187);
                                        local_5[2u].member_1 = ((_e2072 + _e2134) + _e2205);
                                        local_5[3u].member = (_e2186 - _e2188);
                                        local_5[3u].member_1 = ((_e2072 + _e2185) + _e2205);
                                        phi_5974_ = type_19(0u, 4u);
                                        phi_5977_ = true;
                                        loop {
                                            let _e2226 = phi_5974_;
                                            let _e2228 = phi_5977_;
                                            local_17 = _e2228;
                                            if (_e2226.member < _e2226.member_1) {
                                                phi_5975_ = type_19((_e2226.member + 1u), _e2226.member_1);
                                                phi_6000_ = type_19(1u, _e2226.member);
                                            } else {
                                                phi_5975_ = _e2226;
                                                phi_6000_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e2240 = phi_5975_;
                                            let _e2242 = phi_6000_;
                                            if (bitcast<i32>(_e2242.member) != 0i) {
                                                let _e2249 = local_5[_e2242.member_1].member;
                                                let _e2252 = local_5[_e2242.member_1].member_1;
                                                let _e2254 = (_e2249 < -(_e2252));
                                                if _e2254 {
                                                    phi_6027_ = bool();
                                                    phi_6028_ = false;
                                                } else {
                                                    phi_6027_ = (_e2228 && (_e2249 > _e2252));
                                                    phi_6028_ = true;
                                                }
                                                let _e2258 = phi_6027_;
                                                let _e2260 = phi_6028_;
                                                phi_5978_ = _e2258;
                                                phi_6029_ = _e2260;
                                                phi_6030_ = _e2254;
                                            } else {
                                                phi_5978_ = bool();
                                                phi_6029_ = false;
                                                phi_6030_ = false;
                                            }
                                            let _e2262 = phi_5978_;
                                            let _e2264 = phi_6029_;
                                            let _e2266 = phi_6030_;
                                            local_16 = _e2266;
                                            continue;
                                            continuing {
                                                phi_5974_ = _e2240;
                                                phi_5977_ = _e2262;
                                                break if !(_e2264);
                                            }
                                        }
                                        let _e2269 = local_16;
                                        if _e2269 {
                                            phi_6034_ = false;
                                        } else {
                                            phi_6034_ = true;
                                        }
                                        let _e2271 = phi_6034_;
                                        if _e2271 {
                                            let _e2273 = local_17;
                                            if _e2273 {
                                                phi_6041_ = 1u;
                                            } else {
                                                phi_6041_ = 2u;
                                            }
                                            let _e2275 = phi_6041_;
                                            phi_6042_ = _e2275;
                                            phi_6043_ = false;
                                        } else {
                                            phi_6042_ = u32();
                                            phi_6043_ = true;
                                        }
                                        let _e2277 = phi_6042_;
                                        let _e2279 = phi_6043_;
                                        phi_6044_ = _e2277;
                                        phi_6045_ = 0u;
                                        phi_6046_ = _e2279;
                                    } else {
                                        phi_6044_ = u32();
                                        phi_6045_ = 2u;
                                        phi_6046_ = true;
                                    }
                                    let _e2281 = phi_6044_;
                                    let _e2283 = phi_6045_;
                                    let _e2285 = phi_6046_;
                                    if _e2285 {
                                        phi_6050_ = _e2283;
                                    } else {
                                        phi_6050_ = _e2281;
                                    }
                                    let _e2287 = phi_6050_;
                                    let _e2288 = (_e2287 == 0u);
                                    if _e2288 {
                                        phi_8219_ = f64();
                                        phi_8220_ = false;
                                        phi_8221_ = false;
                                        phi_8222_ = false;
                                    } else {
                                        if (_e2287 == 1u) {
                                            if _e1555.member_2 {
                                                if ((_e1555.member_1 - _e1555.member) <= f64(0.0000005f)) {
                                                    phi_6071_ = false;
                                                } else {
                                                    phi_6071_ = true;
                                                }
                                                let _e2297 = phi_6071_;
                                                phi_6072_ = _e2297;
                                            } else {
                                                phi_6072_ = true;
                                            }
                                            let _e2299 = phi_6072_;
                                            phi_6073_ = _e2299;
                                        } else {
                                            phi_6073_ = true;
                                        }
                                        let _e2301 = phi_6073_;
                                        if _e2301 {
                                            let _e2307 = local_12.member[0u];
                                            let _e2313 = local_12.member_1[0u];
                                            let _e2319 = local_12.member_2[0u];
                                            let _e2323 = (_e2307[0] - _e2313[0]);
                                            let _e2324 = (_e2307[1] - _e2313[1]);
                                            let _e2325 = (_e2307[2] - _e2313[2]);
                                            let _e2334 = local_12.member[1u];
                                            let _e2340 = local_12.member_1[1u];
                                            let _e2346 = local_12.member_2[1u];
                                            let _e2350 = (_e2334[0] - _e2340[0]);
                                            let _e2351 = (_e2334[1] - _e2340[1]);
                                            let _e2352 = (_e2334[2] - _e2340[2]);
                                            let _e2361 = local_12.member[0u];
                                            if (_e2361[0] < 0.0lf) {
                                                phi_6222_ = -(_e2361[0]);
                                            } else {
                                                phi_6222_ = _e2361[0];
                                            }
                                            let _e2368 = phi_6222_;
                                            if (_e2361[1] < 0.0lf) {
                                                phi_6229_ = -(_e2361[1]);
                                            } else {
                                                phi_6229_ = _e2361[1];
                                            }
                                            let _e2372 = phi_6229_;
                                            if (_e2368 > _e2372) {
                                                phi_6234_ = _e2368;
                                            } else {
                                                phi_6234_ = _e2372;
                                            }
                                            let _e2375 = phi_6234_;
                                            if (_e2361[2] < 0.0lf) {
                                                phi_6241_ = -(_e2361[2]);
                                            } else {
                                                phi_6241_ = _e2361[2];
                                            }
                                            let _e2379 = phi_6241_;
                                            if (_e2375 > _e2379) {
                                                phi_6246_ = _e2375;
                                            } else {
                                                phi_6246_ = _e2379;
                                            }
                                            let _e2382 = phi_6246_;
                                            let _e2385 = local_12.member[1u];
                                            if (_e2385[0] < 0.0lf) {
                                                phi_6259_ = -(_e2385[0]);
                                            } else {
                                                phi_6259_ = _e2385[0];
                                            }
                                            let _e2392 = phi_6259_;
                                            if (_e2385[1] < 0.0lf) {
                                                phi_6266_ = -(_e2385[1]);
                                            } else {
                                                phi_6266_ = _e2385[1];
                                            }
                                            let _e2396 = phi_6266_;
                                            if (_e2392 > _e2396) {
                                                phi_6271_ = _e2392;
                                            } else {
                                                phi_6271_ = _e2396;
                                            }
                                            let _e2399 = phi_6271_;
                                            if (_e2385[2] < 0.0lf) {
                                                phi_6278_ = -(_e2385[2]);
                                            } else {
                                                phi_6278_ = _e2385[2];
                                            }
                                            let _e2403 = phi_6278_;
                                            if (_e2399 > _e2403) {
                                                phi_6283_ = _e2399;
                                            } else {
                                                phi_6283_ = _e2403;
                                            }
                                            let _e2406 = phi_6283_;
                                            if (_e2382 > _e2406) {
                                                phi_6288_ = _e2382;
                                            } else {
                                                phi_6288_ = _e2406;
                                            }
                                            let _e2409 = phi_6288_;
                                            let _e2411 = local_12.member_3;
                                            let _e2415 = local_12.member_1[0u];
                                            if (_e2415[0] < 0.0lf) {
                                                phi_6305_ = -(_e2415[0]);
                                            } else {
                                                phi_6305_ = _e2415[0];
                                            }
                                            let _e2422 = phi_6305_;
                                            if (_e2415[1] < 0.0lf) {
                                                phi_6312_ = -(_e2415[1]);
                                            } else {
                                                phi_6312_ = _e2415[1];
                                            }
                                            let _e2426 = phi_6312_;
                                            if (_e2422 > _e2426) {
                                                phi_6317_ = _e2422;
                                            } else {
                                                phi_6317_ = _e2426;
                                            }
                                            let _e2429 = phi_6317_;
                                            if (_e2415[2] < 0.0lf) {
                                                phi_6324_ = -(_e2415[2]);
                                            } else {
                                                phi_6324_ = _e2415[2];
                                            }
                                            let _e2433 = phi_6324_;
                                            if (_e2429 > _e2433) {
                                                phi_6329_ = _e2429;
                                            } else {
                                                phi_6329_ = _e2433;
                                            }
                                            let _e2436 = phi_6329_;
                                            let _e2439 = local_12.member_1[1u];
                                            if (_e2439[0] < 0.0lf) {
                                                phi_6343_ = -(_e2439[0]);
                                            } else {
                                                phi_6343_ = _e2439[0];
                                            }
                                            let _e2446 = phi_6343_;
                                            if (_e2439[1] < 0.0lf) {
                                                phi_6350_ = -(_e2439[1]);
                                            } else {
                                                phi_6350_ = _e2439[1];
                                            }
                                            let _e2450 = phi_6350_;
                                            if (_e2446 > _e2450) {
                                                phi_6355_ = _e2446;
                                            } else {
                                                phi_6355_ = _e2450;
                                            }
                                            let _e2453 = phi_6355_;
                                            if (_e2439[2] < 0.0lf) {
                                                phi_6362_ = -(_e2439[2]);
                                            } else {
                                                phi_6362_ = _e2439[2];
                                            }
                                            let _e2457 = phi_6362_;
                                            if (_e2453 > _e2457) {
                                                phi_6367_ = _e2453;
                                            } else {
                                                phi_6367_ = _e2457;
                                            }
                                            let _e2460 = phi_6367_;
                                            if (_e2436 > _e2460) {
                                                phi_6372_ = _e2436;
                                            } else {
                                                phi_6372_ = _e2460;
                                            }
                                            let _e2463 = phi_6372_;
                                            let _e2465 = local_12.member_3;
                                            let _e2469 = local_12.member_2[0u];
                                            if (_e2469[0] < 0.0lf) {
                                                phi_6389_ = -(_e2469[0]);
                                            } else {
                                                phi_6389_ = _e2469[0];
                                            }
                                            let _e2476 = phi_6389_;
                                            if (_e2469[1] < 0.0lf) {
                                                phi_6396_ = -(_e2469[1]);
                                            } else {
                                                phi_6396_ = _e2469[1];
                                            }
                                            let _e2480 = phi_6396_;
                                            if (_e2476 > _e2480) {
                                                phi_6401_ = _e2476;
                                            } else {
                                                phi_6401_ = _e2480;
                                            }
                                            let _e2483 = phi_6401_;
                                            if (_e2469[2] < 0.0lf) {
                                                phi_6408_ = -(_e2469[2]);
                                            } else {
                                                phi_6408_ = _e2469[2];
                                            }
                                            let _e2487 = phi_6408_;
                                            if (_e2483 > _e2487) {
                                                phi_6413_ = _e2483;
                                            } else {
                                                phi_6413_ = _e2487;
                                            }
                                            let _e2490 = phi_6413_;
                                            let _e2493 = local_12.member_2[1u];
                                            if (_e2493[0] < 0.0lf) {
                                                phi_6427_ = -(_e2493[0]);
                                            } else {
                                                phi_6427_ = _e2493[0];
                                            }
                                            let _e2500 = phi_6427_;
                                            if (_e2493[1] < 0.0lf) {
                                                phi_6434_ = -(_e2493[1]);
                                            } else {
                                                phi_6434_ = _e2493[1];
                                            }
                                            let _e2504 = phi_6434_;
                                            if (_e2500 > _e2504) {
                                                phi_6439_ = _e2500;
                                            } else {
                                                phi_6439_ = _e2504;
                                            }
                                            let _e2507 = phi_6439_;
                                            if (_e2493[2] < 0.0lf) {
                                                phi_6446_ = -(_e2493[2]);
                                            } else {
                                                phi_6446_ = _e2493[2];
                                            }
                                            let _e2511 = phi_6446_;
                                            if (_e2507 > _e2511) {
                                                phi_6451_ = _e2507;
                                            } else {
                                                phi_6451_ = _e2511;
                                            }
                                            let _e2514 = phi_6451_;
                                            if (_e2490 > _e2514) {
                                                phi_6456_ = _e2490;
                                            } else {
                                                phi_6456_ = _e2514;
                                            }
                                            let _e2517 = phi_6456_;
                                            let _e2519 = local_12.member_3;
                                            let _e2527 = local_12.member_3;
                                            let _e2534 = f64(0f);
                                            let _e2535 = f64(1f);
                                            local = type_32(array<f64, 4>(_e2534, _e2534, _e2534, _e2534), array<f64, 4>(_e2534, _e2534, _e2534, _e2534), array<f64, 4>(_e2535, _e2535, _e2535, _e2535));
                                            phi_6500_ = type_19(0u, 96u);
                                            phi_6503_ = _e1555.member;
                                            phi_6505_ = _e1555.member;
                                            phi_6507_ = _e1555.member;
                                            loop {
                                                let _e2541 = phi_6500_;
                                                let _e2543 = phi_6503_;
                                                let _e2545 = phi_6505_;
                                                let _e2547 = phi_6507_;
                                                local_36 = _e2545;
                                                local_20 = _e2543;
                                                if (_e2541.member < _e2541.member_1) {
                                                    phi_6501_ = type_19((_e2541.member + 1u), _e2541.member_1);
                                                    phi_6530_ = type_19(1u, _e2541.member);
                                                } else {
                                                    phi_6501_ = _e2541;
                                                    phi_6530_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2559 = phi_6501_;
                                                let _e2561 = phi_6530_;
                                                if (bitcast<i32>(_e2561.member) != 0i) {
                                                    let _e2568 = local_12.member[0u];
                                                    let _e2574 = local_12.member[1u];
                                                    let _e2590 = local_12.member_1[0u];
                                                    let _e2596 = local_12.member_1[1u];
                                                    let _e2612 = local_12.member_2[0u];
                                                    let _e2618 = local_12.member_2[1u];
                                                    let _e2632 = function_2(array<f64, 3>((_e2568[0] + ((_e2574[0] - _e2568[0]) * _e2543)), (_e2568[1] + ((_e2574[1] - _e2568[1]) * _e2543)), (_e2568[2] + ((_e2574[2] - _e2568[2]) * _e2543))), array<f64, 3>((_e2590[0] + ((_e2596[0] - _e2590[0]) * _e2543)), (_e2590[1] + ((_e2596[1] - _e2590[1]) * _e2543)), (_e2590[2] + ((_e2596[2] - _e2590[2]) * _e2543))), array<f64, 3>((_e2612[0] + ((_e2618[0] - _e2612[0]) * _e2543)), (_e2612[1] + ((_e2618[1] - _e2612[1]) * _e2543)), (_e2612[2] + ((_e2618[2] - _e2612[2]) * _e2543))), 1u);
                                                    if (_e2632[0] < 0.0lf) {
                                                        phi_6642_ = -(_e2632[0]);
                                                    } else {
                                                        phi_6642_ = _e2632[0];
                                                    }
                                                    let _e2637 = phi_6642_;
                                                    if (_e2632[1] < 0.0lf) {
                                                        phi_6649_ = -(_e2632[1]);
                                                    } else {
                                                        phi_6649_ = _e2632[1];
                                                    }
                                                    let _e2642 = phi_6649_;
                                                    if (_e2632[2] < 0.0lf) {
                                                        phi_6657_ = -(_e2632[2]);
                                                    } else {
                                                        phi_6657_ = _e2632[2];
                                                    }
                                                    let _e2648 = phi_6657_;
                                                    let _e2649 = ((_e2637 + _e2642) + _e2648);
                                                    if (_e2649 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2649) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2656 = (f64(1f) / _e2649);
                                                            let _e2658 = (_e2632[0] * _e2656);
                                                            let _e2660 = (_e2632[1] * _e2656);
                                                            let _e2662 = (_e2632[2] * _e2656);
                                                            let _e2667 = (((_e2658 * _e2658) + (_e2660 * _e2660)) + (_e2662 * _e2662));
                                                            if (_e2667 <= 2.2250738585072014e-308lf) {
                                                                if (_e2667 > 0.0lf) {
                                                                    phi_6696_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_6696_ = 0.0lf;
                                                                }
                                                                let _e2719 = phi_6696_;
                                                                phi_6760_ = _e2719;
                                                            } else {
                                                                phi_6703_ = type_17(0i, 5i);
                                                                phi_6706_ = bitcast<f64>(((bitcast<u64>(_e2667) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2674 = phi_6703_;
                                                                    let _e2676 = phi_6706_;
                                                                    local_18 = _e2676;
                                                                    if (_e2674.member < _e2674.member_1) {
                                                                        let _e2683 = (_e2674.member + 1i);
                                                                        if ((false == (_e2683 > _e2674.member)) != false) {
                                                                            phi_6727_ = true;
                                                                        } else {
                                                                            phi_6727_ = false;
                                                                        }
                                                                        let _e2688 = phi_6727_;
                                                                        if _e2688 {
                                                                            phi_6733_ = type_18(0u, type_18().member_1);
                                                                        } else {
                                                                            phi_6733_ = type_18(1u, _e2683);
                                                                        }
                                                                        let _e2693 = phi_6733_;
                                                                        phi_6704_ = type_17(_e2693.member_1, _e2674.member_1);
                                                                        phi_6747_ = type_18(1u, _e2674.member);
                                                                    } else {
                                                                        phi_6704_ = _e2674;
                                                                        phi_6747_ = type_18(0u, type_18().member_1);
                                                                    }
                                                                    let _e2699 = phi_6704_;
                                                                    let _e2701 = phi_6747_;
                                                                    let _e2704 = (bitcast<i32>(_e2701.member) != 0i);
                                                                    if _e2704 {
                                                                        phi_6707_ = (0.5lf * (_e2676 + (_e2667 / _e2676)));
                                                                    } else {
                                                                        phi_6707_ = f64();
                                                                    }
                                                                    let _e2709 = phi_6707_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6703_ = _e2699;
                                                                        phi_6706_ = _e2709;
                                                                        break if !(_e2704);
                                                                    }
                                                                }
                                                                let _e2714 = local_18;
                                                                phi_6760_ = (_e2714 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2721 = phi_6760_;
                                                            let _e2723 = (1.1102230246251565e-16lf * f64(12f));
                                                            let _e2730 = ((((((((_e2409 + _e2411) + (_e2463 + _e2465)) + (_e2517 + _e2519)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2527 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2721) * (f64(1f) + _e2723)));
                                                            let _e2735 = (((_e2658 * _e2307[0]) + (_e2660 * _e2307[1])) + (_e2662 * _e2307[2]));
                                                            let _e2740 = (((_e2658 * _e2323) + (_e2660 * _e2324)) + (_e2662 * _e2325));
                                                            let _e2745 = (((_e2658 * (_e2307[0] - _e2319[0])) + (_e2660 * (_e2307[1] - _e2319[1]))) + (_e2662 * (_e2307[2] - _e2319[2])));
                                                            let _e2750 = (((_e2658 * (_e2323 - _e2319[0])) + (_e2660 * (_e2324 - _e2319[1]))) + (_e2662 * (_e2325 - _e2319[2])));
                                                            let _e2756 = (((_e2658 * _e2334[0]) + (_e2660 * _e2334[1])) + (_e2662 * _e2334[2]));
                                                            let _e2761 = (((_e2658 * _e2350) + (_e2660 * _e2351)) + (_e2662 * _e2352));
                                                            let _e2766 = (((_e2658 * (_e2334[0] - _e2346[0])) + (_e2660 * (_e2334[1] - _e2346[1]))) + (_e2662 * (_e2334[2] - _e2346[2])));
                                                            let _e2771 = (((_e2658 * (_e2350 - _e2346[0])) + (_e2660 * (_e2351 - _e2346[1]))) + (_e2662 * (_e2352 - _e2346[2])));
                                                            if (_e2735 < 0.0lf) {
                                                                phi_6829_ = -(_e2735);
                                                            } else {
                                                                phi_6829_ = _e2735;
                                                            }
                                                            let _e2776 = phi_6829_;
                                                            if (_e2756 < 0.0lf) {
                                                                phi_6835_ = -(_e2756);
                                                            } else {
                                                                phi_6835_ = _e2756;
                                                            }
                                                            let _e2780 = phi_6835_;
                                                            if (_e2740 < 0.0lf) {
                                                                phi_6844_ = -(_e2740);
                                                            } else {
                                                                phi_6844_ = _e2740;
                                                            }
                                                            let _e2787 = phi_6844_;
                                                            if (_e2761 < 0.0lf) {
                                                                phi_6850_ = -(_e2761);
                                                            } else {
                                                                phi_6850_ = _e2761;
                                                            }
                                                            let _e2791 = phi_6850_;
                                                            if (_e2745 < 0.0lf) {
                                                                phi_6859_ = -(_e2745);
                                                            } else {
                                                                phi_6859_ = _e2745;
                                                            }
                                                            let _e2798 = phi_6859_;
                                                            if (_e2766 < 0.0lf) {
                                                                phi_6865_ = -(_e2766);
                                                            } else {
                                                                phi_6865_ = _e2766;
                                                            }
                                                            let _e2802 = phi_6865_;
                                                            if (_e2750 < 0.0lf) {
                                                                phi_6874_ = -(_e2750);
                                                            } else {
                                                                phi_6874_ = _e2750;
                                                            }
                                                            let _e2809 = phi_6874_;
                                                            if (_e2771 < 0.0lf) {
                                                                phi_6880_ = -(_e2771);
                                                            } else {
                                                                phi_6880_ = _e2771;
                                                            }
                                                            let _e2813 = phi_6880_;
                                                            phi_6886_ = type_32(array<f64, 4>(_e2735, _e2740, _e2745, _e2750), array<f64, 4>(_e2756, _e2761, _e2766, _e2771), array<f64, 4>((_e2730 + ((_e2776 + _e2780) * _e2723)), (_e2730 + ((_e2787 + _e2791) * _e2723)), (_e2730 + ((_e2798 + _e2802) * _e2723)), (_e2730 + ((_e2809 + _e2813) * _e2723))));
                                                            phi_6887_ = false;
                                                        } else {
                                                            phi_6886_ = type_32();
                                                            phi_6887_ = true;
                                                        }
                                                        let _e2820 = phi_6886_;
                                                        let _e2822 = phi_6887_;
                                                        phi_6888_ = _e2820;
                                                        phi_6889_ = _e2822;
                                                    } else {
                                                        phi_6888_ = type_32();
                                                        phi_6889_ = true;
                                                    }
                                                    let _e2824 = phi_6888_;
                                                    let _e2826 = phi_6889_;
                                                    if _e2826 {
                                                        let _e2827 = f64(0f);
                                                        let _e2828 = f64(1f);
                                                        phi_6899_ = type_32(array<f64, 4>(_e2827, _e2827, _e2827, _e2827), array<f64, 4>(_e2827, _e2827, _e2827, _e2827), array<f64, 4>(_e2828, _e2828, _e2828, _e2828));
                                                    } else {
                                                        phi_6899_ = _e2824;
                                                    }
                                                    let _e2834 = phi_6899_;
                                                    local_1 = type_32(array<f64, 4>(_e2834.member[0], _e2834.member[1], _e2834.member[2], _e2834.member[3]), array<f64, 4>(_e2834.member_1[0], _e2834.member_1[1], _e2834.member_1[2], _e2834.member_1[3]), array<f64, 4>(_e2834.member_2[0], _e2834.member_2[1], _e2834.member_2[2], _e2834.member_2[3]));
                                                    let _e2854 = (_e2543 - _e2547);
                                                    let _e2855 = f64(0f);
                                                    let _e2858 = local_1.member[0u];
                                                    let _e2861 = local_1.member_1[0u];
                                                    let _e2864 = local_1.member[0u];
                                                    let _e2870 = local_1.member_2[0u];
                                                    if (((_e2858 + ((_e2861 - _e2864) * _e2543)) - _e2870) > _e2855) {
                                                        let _e2875 = local_1.member[1u];
                                                        let _e2878 = local_1.member_1[1u];
                                                        let _e2881 = local_1.member[1u];
                                                        let _e2887 = local_1.member_2[1u];
                                                        if (((_e2875 + ((_e2878 - _e2881) * _e2543)) - _e2887) > _e2855) {
                                                            let _e2892 = local_1.member[2u];
                                                            let _e2895 = local_1.member_1[2u];
                                                            let _e2898 = local_1.member[2u];
                                                            let _e2904 = local_1.member_2[2u];
                                                            if (((_e2892 + ((_e2895 - _e2898) * _e2543)) - _e2904) > _e2855) {
                                                                let _e2909 = local_1.member[3u];
                                                                let _e2912 = local_1.member_1[3u];
                                                                let _e2915 = local_1.member[3u];
                                                                let _e2921 = local_1.member_2[3u];
                                                                phi_7070_ = (((_e2909 + ((_e2912 - _e2915) * _e2543)) - _e2921) > _e2855);
                                                                phi_7071_ = false;
                                                            } else {
                                                                phi_7070_ = bool();
                                                                phi_7071_ = true;
                                                            }
                                                            let _e2925 = phi_7070_;
                                                            let _e2927 = phi_7071_;
                                                            phi_7072_ = _e2925;
                                                            phi_7073_ = _e2927;
                                                        } else {
                                                            phi_7072_ = bool();
                                                            phi_7073_ = true;
                                                        }
                                                        let _e2929 = phi_7072_;
                                                        let _e2931 = phi_7073_;
                                                        phi_7074_ = _e2929;
                                                        phi_7075_ = _e2931;
                                                    } else {
                                                        phi_7074_ = bool();
                                                        phi_7075_ = true;
                                                    }
                                                    let _e2933 = phi_7074_;
                                                    let _e2935 = phi_7075_;
                                                    if _e2935 {
                                                        phi_7079_ = false;
                                                    } else {
                                                        phi_7079_ = _e2933;
                                                    }
                                                    let _e2937 = phi_7079_;
                                                    if _e2937 {
                                                        if (_e2543 <= _e2545) {
                                                            phi_7390_ = true;
                                                        } else {
                                                            let _e2939 = f64(0f);
                                                            let _e2942 = local.member[0u];
                                                            let _e2945 = local.member_1[0u];
                                                            let _e2948 = local.member[0u];
                                                            let _e2954 = local.member_2[0u];
                                                            let _e2958 = local_1.member[0u];
                                                            let _e2961 = local_1.member_1[0u];
                                                            let _e2964 = local_1.member[0u];
                                                            let _e2970 = local_1.member_2[0u];
                                                            if ((((_e2942 + ((_e2945 - _e2948) * _e2543)) - _e2954) + ((_e2958 + ((_e2961 - _e2964) * _e2547)) - _e2970)) > _e2939) {
                                                                let _e2976 = local.member[1u];
                                                                let _e2979 = local.member_1[1u];
                                                                let _e2982 = local.member[1u];
                                                                let _e2988 = local.member_2[1u];
                                                                let _e2992 = local_1.member[1u];
                                                                let _e2995 = local_1.member_1[1u];
                                                                let _e2998 = local_1.member[1u];
                                                                let _e3004 = local_1.member_2[1u];
                                                                if ((((_e2976 + ((_e2979 - _e2982) * _e2543)) - _e2988) + ((_e2992 + ((_e2995 - _e2998) * _e2547)) - _e3004)) > _e2939) {
                                                                    let _e3010 = local.member[2u];
                                                                    let _e3013 = local.member_1[2u];
                                                                    let _e3016 = local.member[2u];
                                                                    let _e3022 = local.member_2[2u];
                                                                    let _e3026 = local_1.member[2u];
                                                                    let _e3029 = local_1.member_1[2u];
                                                                    let _e3032 = local_1.member[2u];
                                                                    let _e3038 = local_1.member_2[2u];
                                                                    if ((((_e3010 + ((_e3013 - _e3016) * _e2543)) - _e3022) + ((_e3026 + ((_e3029 - _e3032) * _e2547)) - _e3038)) > _e2939) {
                                                                        let _e3044 = local.member[3u];
                                                                        let _e3047 = local.member_1[3u];
                                                                        let _e3050 = local.member[3u];
                                                                        let _e3056 = local.member_2[3u];
                                                                        let _e3060 = local_1.member[3u];
                                                                        let _e3063 = local_1.member_1[3u];
                                                                        let _e3066 = local_1.member[3u];
                                                                        let _e3072 = local_1.member_2[3u];
                                                                        phi_7377_ = ((((_e3044 + ((_e3047 - _e3050) * _e2543)) - _e3056) + ((_e3060 + ((_e3063 - _e3066) * _e2547)) - _e3072)) > _e2939);
                                                                        phi_7378_ = false;
                                                                    } else {
                                                                        phi_7377_ = bool();
                                                                        phi_7378_ = true;
                                                                    }
                                                                    let _e3077 = phi_7377_;
                                                                    let _e3079 = phi_7378_;
                                                                    phi_7379_ = _e3077;
                                                                    phi_7380_ = _e3079;
                                                                } else {
                                                                    phi_7379_ = bool();
                                                                    phi_7380_ = true;
                                                                }
                                                                let _e3081 = phi_7379_;
                                                                let _e3083 = phi_7380_;
                                                                phi_7381_ = _e3081;
                                                                phi_7382_ = _e3083;
                                                            } else {
                                                                phi_7381_ = bool();
                                                                phi_7382_ = true;
                                                            }
                                                            let _e3085 = phi_7381_;
                                                            let _e3087 = phi_7382_;
                                                            if _e3087 {
                                                                phi_7386_ = false;
                                                            } else {
                                                                phi_7386_ = _e3085;
                                                            }
                                                            let _e3089 = phi_7386_;
                                                            phi_7390_ = _e3089;
                                                        }
                                                        let _e3091 = phi_7390_;
                                                        if _e3091 {
                                                            if (_e2561.member_1 > 0u) {
                                                                if (_e2543 >= _e1555.member_1) {
                                                                    phi_7402_ = false;
                                                                } else {
                                                                    phi_7402_ = true;
                                                                }
                                                                let _e3095 = phi_7402_;
                                                                phi_7403_ = _e3095;
                                                            } else {
                                                                phi_7403_ = true;
                                                            }
                                                            let _e3097 = phi_7403_;
                                                            if _e3097 {
                                                                local = type_32(array<f64, 4>(_e2834.member[0], _e2834.member[1], _e2834.member[2], _e2834.member[3]), array<f64, 4>(_e2834.member_1[0], _e2834.member_1[1], _e2834.member_1[2], _e2834.member_1[3]), array<f64, 4>(_e2834.member_2[0], _e2834.member_2[1], _e2834.member_2[2], _e2834.member_2[3]));
                                                                let _e3119 = local.member[0u];
                                                                let _e3122 = local.member_1[0u];
                                                                let _e3125 = local.member_2[0u];
                                                                if (_e3119 > _e3125) {
                                                                    if (_e3122 > _e3125) {
                                                                        phi_7477_ = false;
                                                                    } else {
                                                                        phi_7477_ = true;
                                                                    }
                                                                    let _e3129 = phi_7477_;
                                                                    phi_7478_ = _e3129;
                                                                } else {
                                                                    phi_7478_ = true;
                                                                }
                                                                let _e3131 = phi_7478_;
                                                                if _e3131 {
                                                                    let _e3132 = (_e3122 >= _e3119);
                                                                    if _e3132 {
                                                                        phi_7503_ = f64();
                                                                        phi_7504_ = false;
                                                                    } else {
                                                                        if ((_e3119 - _e3122) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7501_ = (((_e3119 - _e3125) / (_e3119 - _e3122)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7502_ = false;
                                                                        } else {
                                                                            phi_7501_ = f64();
                                                                            phi_7502_ = true;
                                                                        }
                                                                        let _e3146 = phi_7501_;
                                                                        let _e3148 = phi_7502_;
                                                                        phi_7503_ = _e3146;
                                                                        phi_7504_ = _e3148;
                                                                    }
                                                                    let _e3150 = phi_7503_;
                                                                    let _e3152 = phi_7504_;
                                                                    phi_7505_ = _e3150;
                                                                    phi_7506_ = _e3132;
                                                                    phi_7507_ = _e3152;
                                                                } else {
                                                                    phi_7505_ = f64();
                                                                    phi_7506_ = true;
                                                                    phi_7507_ = false;
                                                                }
                                                                let _e3154 = phi_7505_;
                                                                let _e3156 = phi_7506_;
                                                                let _e3158 = phi_7507_;
                                                                if _e3156 {
                                                                    phi_7512_ = f64(2f);
                                                                    phi_7513_ = true;
                                                                } else {
                                                                    phi_7512_ = _e2543;
                                                                    phi_7513_ = _e3158;
                                                                }
                                                                let _e3161 = phi_7512_;
                                                                let _e3163 = phi_7513_;
                                                                if _e3163 {
                                                                    phi_7517_ = _e3161;
                                                                } else {
                                                                    phi_7517_ = _e3154;
                                                                }
                                                                let _e3165 = phi_7517_;
                                                                let _e3168 = local.member[1u];
                                                                let _e3171 = local.member_1[1u];
                                                                let _e3174 = local.member_2[1u];
                                                                if (_e3168 > _e3174) {
                                                                    if (_e3171 > _e3174) {
                                                                        phi_7549_ = false;
                                                                    } else {
                                                                        phi_7549_ = true;
                                                                    }
                                                                    let _e3178 = phi_7549_;
                                                                    phi_7550_ = _e3178;
                                                                } else {
                                                                    phi_7550_ = true;
                                                                }
                                                                let _e3180 = phi_7550_;
                                                                if _e3180 {
                                                                    let _e3181 = (_e3171 >= _e3168);
                                                                    if _e3181 {
                                                                        phi_7575_ = f64();
                                                                        phi_7576_ = false;
                                                                    } else {
                                                                        if ((_e3168 - _e3171) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7573_ = (((_e3168 - _e3174) / (_e3168 - _e3171)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7574_ = false;
                                                                        } else {
                                                                            phi_7573_ = f64();
                                                                            phi_7574_ = true;
                                                                        }
                                                                        let _e3195 = phi_7573_;
                                                                        let _e3197 = phi_7574_;
                                                                        phi_7575_ = _e3195;
                                                                        phi_7576_ = _e3197;
                                                                    }
                                                                    let _e3199 = phi_7575_;
                                                                    let _e3201 = phi_7576_;
                                                                    phi_7577_ = _e3199;
                                                                    phi_7578_ = _e3181;
                                                                    phi_7579_ = _e3201;
                                                                } else {
                                                                    phi_7577_ = f64();
                                                                    phi_7578_ = true;
                                                                    phi_7579_ = false;
                                                                }
                                                                let _e3203 = phi_7577_;
                                                                let _e3205 = phi_7578_;
                                                                let _e3207 = phi_7579_;
                                                                if _e3205 {
                                                                    phi_7584_ = f64(2f);
                                                                    phi_7585_ = true;
                                                                } else {
                                                                    phi_7584_ = _e2543;
                                                                    phi_7585_ = _e3207;
                                                                }
                                                                let _e3210 = phi_7584_;
                                                                let _e3212 = phi_7585_;
                                                                if _e3212 {
                                                                    phi_7589_ = _e3210;
                                                                } else {
                                                                    phi_7589_ = _e3203;
                                                                }
                                                                let _e3214 = phi_7589_;
                                                                if (_e3165 < _e3214) {
                                                                    phi_7594_ = _e3165;
                                                                } else {
                                                                    phi_7594_ = _e3214;
                                                                }
                                                                let _e3217 = phi_7594_;
                                                                let _e3220 = local.member[2u];
                                                                let _e3223 = local.member_1[2u];
                                                                let _e3226 = local.member_2[2u];
                                                                if (_e3220 > _e3226) {
                                                                    if (_e3223 > _e3226) {
                                                                        phi_7626_ = false;
                                                                    } else {
                                                                        phi_7626_ = true;
                                                                    }
                                                                    let _e3230 = phi_7626_;
                                                                    phi_7627_ = _e3230;
                                                                } else {
                                                                    phi_7627_ = true;
                                                                }
                                                                let _e3232 = phi_7627_;
                                                                if _e3232 {
                                                                    let _e3233 = (_e3223 >= _e3220);
                                                                    if _e3233 {
                                                                        phi_7652_ = f64();
                                                                        phi_7653_ = false;
                                                                    } else {
                                                                        if ((_e3220 - _e3223) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7650_ = (((_e3220 - _e3226) / (_e3220 - _e3223)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7651_ = false;
                                                                        } else {
                                                                            phi_7650_ = f64();
                                                                            phi_7651_ = true;
                                                                        }
                                                                        let _e3247 = phi_7650_;
                                                                        let _e3249 = phi_7651_;
                                                                        phi_7652_ = _e3247;
                                                                        phi_7653_ = _e3249;
                                                                    }
                                                                    let _e3251 = phi_7652_;
                                                                    let _e3253 = phi_7653_;
                                                                    phi_7654_ = _e3251;
                                                                    phi_7655_ = _e3233;
                                                                    phi_7656_ = _e3253;
                                                                } else {
                                                                    phi_7654_ = f64();
                                                                    phi_7655_ = true;
                                                                    phi_7656_ = false;
                                                                }
                                                                let _e3255 = phi_7654_;
                                                                let _e3257 = phi_7655_;
                                                                let _e3259 = phi_7656_;
                                                                if _e3257 {
                                                                    phi_7661_ = f64(2f);
                                                                    phi_7662_ = true;
                                                                } else {
                                                                    phi_7661_ = _e2543;
                                                                    phi_7662_ = _e3259;
                                                                }
                                                                let _e3262 = phi_7661_;
                                                                let _e3264 = phi_7662_;
                                                                if _e3264 {
                                                                    phi_7666_ = _e3262;
                                                                } else {
                                                                    phi_7666_ = _e3255;
                                                                }
                                                                let _e3266 = phi_7666_;
                                                                let _e3269 = local.member[3u];
                                                                let _e3272 = local.member_1[3u];
                                                                let _e3275 = local.member_2[3u];
                                                                if (_e3269 > _e3275) {
                                                                    if (_e3272 > _e3275) {
                                                                        phi_7698_ = false;
                                                                    } else {
                                                                        phi_7698_ = true;
                                                                    }
                                                                    let _e3279 = phi_7698_;
                                                                    phi_7699_ = _e3279;
                                                                } else {
                                                                    phi_7699_ = true;
                                                                }
                                                                let _e3281 = phi_7699_;
                                                                if _e3281 {
                                                                    let _e3282 = (_e3272 >= _e3269);
                                                                    if _e3282 {
                                                                        phi_7724_ = f64();
                                                                        phi_7725_ = false;
                                                                    } else {
                                                                        if ((_e3269 - _e3272) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7722_ = (((_e3269 - _e3275) / (_e3269 - _e3272)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7723_ = false;
                                                                        } else {
                                                                            phi_7722_ = f64();
                                                                            phi_7723_ = true;
                                                                        }
                                                                        let _e3296 = phi_7722_;
                                                                        let _e3298 = phi_7723_;
                                                                        phi_7724_ = _e3296;
                                                                        phi_7725_ = _e3298;
                                                                    }
                                                                    let _e3300 = phi_7724_;
                                                                    let _e3302 = phi_7725_;
                                                                    phi_7726_ = _e3300;
                                                                    phi_7727_ = _e3282;
                                                                    phi_7728_ = _e3302;
                                                                } else {
                                                                    phi_7726_ = f64();
                                                                    phi_7727_ = true;
                                                                    phi_7728_ = false;
                                                                }
                                                                let _e3304 = phi_7726_;
                                                                let _e3306 = phi_7727_;
                                                                let _e3308 = phi_7728_;
                                                                if _e3306 {
                                                                    phi_7733_ = f64(2f);
                                                                    phi_7734_ = true;
                                                                } else {
                                                                    phi_7733_ = _e2543;
                                                                    phi_7734_ = _e3308;
                                                                }
                                                                let _e3311 = phi_7733_;
                                                                let _e3313 = phi_7734_;
                                                                if _e3313 {
                                                                    phi_7738_ = _e3311;
                                                                } else {
                                                                    phi_7738_ = _e3304;
                                                                }
                                                                let _e3315 = phi_7738_;
                                                                if (_e3266 < _e3315) {
                                                                    phi_7743_ = _e3266;
                                                                } else {
                                                                    phi_7743_ = _e3315;
                                                                }
                                                                let _e3318 = phi_7743_;
                                                                if (_e3217 < _e3318) {
                                                                    phi_7748_ = _e3217;
                                                                } else {
                                                                    phi_7748_ = _e3318;
                                                                }
                                                                let _e3321 = phi_7748_;
                                                                if (_e3321 > _e2543) {
                                                                    phi_7753_ = _e3321;
                                                                } else {
                                                                    phi_7753_ = _e2543;
                                                                }
                                                                let _e3324 = phi_7753_;
                                                                let _e3325 = (_e3324 > _e1555.member_1);
                                                                if _e3325 {
                                                                    phi_7765_ = f64();
                                                                    phi_7766_ = false;
                                                                } else {
                                                                    if (_e2561.member_1 == 0u) {
                                                                        phi_7764_ = (_e1555.member_1 - _e2543);
                                                                    } else {
                                                                        phi_7764_ = (_e2854 + _e2854);
                                                                    }
                                                                    let _e3330 = phi_7764_;
                                                                    phi_7765_ = _e3330;
                                                                    phi_7766_ = true;
                                                                }
                                                                let _e3332 = phi_7765_;
                                                                let _e3334 = phi_7766_;
                                                                phi_7767_ = _e3324;
                                                                phi_7768_ = _e3332;
                                                                phi_7769_ = _e3334;
                                                                phi_7770_ = _e3325;
                                                                phi_7771_ = false;
                                                            } else {
                                                                phi_7767_ = f64();
                                                                phi_7768_ = f64();
                                                                phi_7769_ = false;
                                                                phi_7770_ = false;
                                                                phi_7771_ = true;
                                                            }
                                                            let _e3336 = phi_7767_;
                                                            let _e3338 = phi_7768_;
                                                            let _e3340 = phi_7769_;
                                                            let _e3342 = phi_7770_;
                                                            let _e3344 = phi_7771_;
                                                            phi_7772_ = _e3336;
                                                            phi_7773_ = _e3338;
                                                            phi_7774_ = false;
                                                            phi_7775_ = _e3340;
                                                            phi_7776_ = _e3342;
                                                            phi_7777_ = _e3344;
                                                        } else {
                                                            phi_7772_ = f64();
                                                            phi_7773_ = f64();
                                                            phi_7774_ = true;
                                                            phi_7775_ = false;
                                                            phi_7776_ = false;
                                                            phi_7777_ = false;
                                                        }
                                                        let _e3346 = phi_7772_;
                                                        let _e3348 = phi_7773_;
                                                        let _e3350 = phi_7774_;
                                                        let _e3352 = phi_7775_;
                                                        let _e3354 = phi_7776_;
                                                        let _e3356 = phi_7777_;
                                                        phi_7778_ = _e3346;
                                                        phi_7779_ = _e3348;
                                                        phi_7780_ = _e3350;
                                                        phi_7781_ = _e3352;
                                                        phi_7782_ = _e3354;
                                                        phi_7783_ = _e3356;
                                                    } else {
                                                        phi_7778_ = f64();
                                                        phi_7779_ = f64();
                                                        phi_7780_ = true;
                                                        phi_7781_ = false;
                                                        phi_7782_ = false;
                                                        phi_7783_ = false;
                                                    }
                                                    let _e3358 = phi_7778_;
                                                    let _e3360 = phi_7779_;
                                                    let _e3362 = phi_7780_;
                                                    let _e3364 = phi_7781_;
                                                    let _e3366 = phi_7782_;
                                                    let _e3368 = phi_7783_;
                                                    if _e3362 {
                                                        let _e3369 = (_e2543 <= _e2545);
                                                        if _e3369 {
                                                            phi_8117_ = f64();
                                                            phi_8118_ = false;
                                                        } else {
                                                            let _e3372 = local.member[0u];
                                                            let _e3375 = local.member_1[0u];
                                                            let _e3378 = local.member[0u];
                                                            let _e3384 = local.member_2[0u];
                                                            let _e3385 = ((_e3372 + ((_e3375 - _e3378) * _e2547)) - _e3384);
                                                            let _e3388 = local.member[1u];
                                                            let _e3391 = local.member_1[1u];
                                                            let _e3394 = local.member[1u];
                                                            let _e3400 = local.member_2[1u];
                                                            let _e3401 = ((_e3388 + ((_e3391 - _e3394) * _e2547)) - _e3400);
                                                            if (_e3385 < _e3401) {
                                                                phi_7863_ = _e3385;
                                                            } else {
                                                                phi_7863_ = _e3401;
                                                            }
                                                            let _e3404 = phi_7863_;
                                                            let _e3407 = local.member[2u];
                                                            let _e3410 = local.member_1[2u];
                                                            let _e3413 = local.member[2u];
                                                            let _e3419 = local.member_2[2u];
                                                            let _e3420 = ((_e3407 + ((_e3410 - _e3413) * _e2547)) - _e3419);
                                                            let _e3423 = local.member[3u];
                                                            let _e3426 = local.member_1[3u];
                                                            let _e3429 = local.member[3u];
                                                            let _e3435 = local.member_2[3u];
                                                            let _e3436 = ((_e3423 + ((_e3426 - _e3429) * _e2547)) - _e3435);
                                                            if (_e3420 < _e3436) {
                                                                phi_7936_ = _e3420;
                                                            } else {
                                                                phi_7936_ = _e3436;
                                                            }
                                                            let _e3439 = phi_7936_;
                                                            if (_e3404 < _e3439) {
                                                                phi_7941_ = _e3404;
                                                            } else {
                                                                phi_7941_ = _e3439;
                                                            }
                                                            let _e3442 = phi_7941_;
                                                            let _e3445 = local_1.member[0u];
                                                            let _e3448 = local_1.member_1[0u];
                                                            let _e3451 = local_1.member[0u];
                                                            let _e3457 = local_1.member_2[0u];
                                                            let _e3458 = ((_e3445 + ((_e3448 - _e3451) * _e2543)) - _e3457);
                                                            let _e3461 = local_1.member[1u];
                                                            let _e3464 = local_1.member_1[1u];
                                                            let _e3467 = local_1.member[1u];
                                                            let _e3473 = local_1.member_2[1u];
                                                            let _e3474 = ((_e3461 + ((_e3464 - _e3467) * _e2543)) - _e3473);
                                                            if (_e3458 < _e3474) {
                                                                phi_8014_ = _e3458;
                                                            } else {
                                                                phi_8014_ = _e3474;
                                                            }
                                                            let _e3477 = phi_8014_;
                                                            let _e3480 = local_1.member[2u];
                                                            let _e3483 = local_1.member_1[2u];
                                                            let _e3486 = local_1.member[2u];
                                                            let _e3492 = local_1.member_2[2u];
                                                            let _e3493 = ((_e3480 + ((_e3483 - _e3486) * _e2543)) - _e3492);
                                                            let _e3496 = local_1.member[3u];
                                                            let _e3499 = local_1.member_1[3u];
                                                            let _e3502 = local_1.member[3u];
                                                            let _e3508 = local_1.member_2[3u];
                                                            let _e3509 = ((_e3496 + ((_e3499 - _e3502) * _e2543)) - _e3508);
                                                            if (_e3493 < _e3509) {
                                                                phi_8087_ = _e3493;
                                                            } else {
                                                                phi_8087_ = _e3509;
                                                            }
                                                            let _e3512 = phi_8087_;
                                                            if (_e3477 < _e3512) {
                                                                phi_8092_ = _e3477;
                                                            } else {
                                                                phi_8092_ = _e3512;
                                                            }
                                                            let _e3515 = phi_8092_;
                                                            let _e3516 = f64(0.0625f);
                                                            let _e3518 = f64(0.9f);
                                                            if (_e3515 > f64(0f)) {
                                                                phi_8115_ = f64(0.5f);
                                                            } else {
                                                                let _e3524 = (f64(0.95f) * (_e3442 / (_e3442 - _e3515)));
                                                                if (_e3524 > _e3516) {
                                                                    if (_e3524 < _e3518) {
                                                                        phi_8113_ = _e3524;
                                                                    } else {
                                                                        phi_8113_ = _e3518;
                                                                    }
                                                                    let _e3528 = phi_8113_;
                                                                    phi_8114_ = _e3528;
                                                                } else {
                                                                    phi_8114_ = _e3516;
                                                                }
                                                                let _e3530 = phi_8114_;
                                                                phi_8115_ = _e3530;
                                                            }
                                                            let _e3532 = phi_8115_;
                                                            phi_8117_ = (_e2854 * _e3532);
                                                            phi_8118_ = true;
                                                        }
                                                        let _e3535 = phi_8117_;
                                                        let _e3537 = phi_8118_;
                                                        phi_8119_ = _e2545;
                                                        phi_8120_ = _e3535;
                                                        phi_8121_ = _e2547;
                                                        phi_8122_ = _e3537;
                                                        phi_8123_ = _e3369;
                                                        phi_8124_ = false;
                                                        phi_8125_ = false;
                                                    } else {
                                                        phi_8119_ = _e3358;
                                                        phi_8120_ = _e3360;
                                                        phi_8121_ = _e2543;
                                                        phi_8122_ = _e3364;
                                                        phi_8123_ = false;
                                                        phi_8124_ = _e3366;
                                                        phi_8125_ = _e3368;
                                                    }
                                                    let _e3539 = phi_8119_;
                                                    let _e3541 = phi_8120_;
                                                    let _e3543 = phi_8121_;
                                                    let _e3545 = phi_8122_;
                                                    let _e3547 = phi_8123_;
                                                    let _e3549 = phi_8124_;
                                                    let _e3551 = phi_8125_;
                                                    if _e3545 {
                                                        let _e3552 = (_e3543 + _e3541);
                                                        if (_e3552 > _e3539) {
                                                            phi_8134_ = _e3552;
                                                        } else {
                                                            phi_8134_ = _e3539;
                                                        }
                                                        let _e3555 = phi_8134_;
                                                        if (_e3555 < _e1555.member_1) {
                                                            phi_8139_ = _e3555;
                                                        } else {
                                                            phi_8139_ = _e1555.member_1;
                                                        }
                                                        let _e3558 = phi_8139_;
                                                        if (_e2561.member_1 > 0u) {
                                                            phi_8150_ = ((_e3558 - _e3543) > f64(0.0000000037252903f));
                                                        } else {
                                                            phi_8150_ = true;
                                                        }
                                                        let _e3564 = phi_8150_;
                                                        if _e3564 {
                                                            phi_8154_ = false;
                                                        } else {
                                                            phi_8154_ = true;
                                                        }
                                                        let _e3566 = phi_8154_;
                                                        phi_8155_ = _e3558;
                                                        phi_8156_ = _e3564;
                                                        phi_8157_ = _e3566;
                                                        phi_8158_ = false;
                                                        phi_8159_ = false;
                                                        phi_8160_ = false;
                                                    } else {
                                                        phi_8155_ = f64();
                                                        phi_8156_ = false;
                                                        phi_8157_ = false;
                                                        phi_8158_ = _e3547;
                                                        phi_8159_ = _e3549;
                                                        phi_8160_ = _e3551;
                                                    }
                                                    let _e3568 = phi_8155_;
                                                    let _e3570 = phi_8156_;
                                                    let _e3572 = phi_8157_;
                                                    let _e3574 = phi_8158_;
                                                    let _e3576 = phi_8159_;
                                                    let _e3578 = phi_8160_;
                                                    phi_6504_ = _e3568;
                                                    phi_6506_ = _e3539;
                                                    phi_6508_ = _e3543;
                                                    phi_8161_ = _e3539;
                                                    phi_8162_ = _e3570;
                                                    phi_8163_ = _e3572;
                                                    phi_8164_ = false;
                                                    phi_8165_ = _e3574;
                                                    phi_8166_ = _e3576;
                                                    phi_8167_ = _e3578;
                                                } else {
                                                    phi_6504_ = f64();
                                                    phi_6506_ = f64();
                                                    phi_6508_ = f64();
                                                    phi_8161_ = f64();
                                                    phi_8162_ = false;
                                                    phi_8163_ = false;
                                                    phi_8164_ = true;
                                                    phi_8165_ = false;
                                                    phi_8166_ = false;
                                                    phi_8167_ = false;
                                                }
                                                let _e3580 = phi_6504_;
                                                let _e3582 = phi_6506_;
                                                let _e3584 = phi_6508_;
                                                let _e3586 = phi_8161_;
                                                let _e3588 = phi_8162_;
                                                let _e3590 = phi_8163_;
                                                let _e3592 = phi_8164_;
                                                let _e3594 = phi_8165_;
                                                let _e3596 = phi_8166_;
                                                let _e3598 = phi_8167_;
                                                local_19 = _e3590;
                                                local_35 = _e3586;
                                                local_37 = _e3592;
                                                local_38 = _e3594;
                                                local_39 = _e3596;
                                                local_40 = _e3598;
                                                continue;
                                                continuing {
                                                    phi_6500_ = _e2559;
                                                    phi_6503_ = _e3580;
                                                    phi_6505_ = _e3582;
                                                    phi_6507_ = _e3584;
                                                    break if !(_e3588);
                                                }
                                            }
                                            let _e3601 = local_19;
                                            if _e3601 {
                                                let _e6042 = local_35;
                                                phi_8171_ = _e6042;
                                                phi_8172_ = true;
                                                phi_8173_ = false;
                                                phi_8174_ = false;
                                                phi_8175_ = false;
                                            } else {
                                                let _e6044 = local_36;
                                                phi_8171_ = _e6044;
                                                let _e6047 = local_37;
                                                phi_8172_ = _e6047;
                                                let _e6050 = local_38;
                                                phi_8173_ = _e6050;
                                                let _e6053 = local_39;
                                                phi_8174_ = _e6053;
                                                let _e6056 = local_40;
                                                phi_8175_ = _e6056;
                                            }
                                            let _e3603 = phi_8171_;
                                            let _e3605 = phi_8172_;
                                            let _e3607 = phi_8173_;
                                            let _e3609 = phi_8174_;
                                            let _e3611 = phi_8175_;
                                            if _e3605 {
                                                phi_8180_ = type_42(1u, _e3603);
                                                phi_8181_ = false;
                                                phi_8182_ = false;
                                                phi_8183_ = false;
                                            } else {
                                                phi_8180_ = type_42();
                                                phi_8181_ = _e3607;
                                                phi_8182_ = _e3609;
                                                phi_8183_ = _e3611;
                                            }
                                            let _e3614 = phi_8180_;
                                            let _e3616 = phi_8181_;
                                            let _e3618 = phi_8182_;
                                            let _e3620 = phi_8183_;
                                            if _e3616 {
                                                let _e3622 = local_20;
                                                phi_8188_ = type_42(1u, _e3622);
                                                phi_8189_ = false;
                                                phi_8190_ = false;
                                            } else {
                                                phi_8188_ = type_42();
                                                phi_8189_ = _e3618;
                                                phi_8190_ = _e3620;
                                            }
                                            let _e3625 = phi_8188_;
                                            let _e3627 = phi_8189_;
                                            let _e3629 = phi_8190_;
                                            if _e3627 {
                                                phi_8195_ = type_42(0u, type_42().member_1);
                                                phi_8196_ = false;
                                                phi_8197_ = true;
                                            } else {
                                                phi_8195_ = _e3625;
                                                phi_8196_ = _e3629;
                                                phi_8197_ = _e3616;
                                            }
                                            let _e3633 = phi_8195_;
                                            let _e3635 = phi_8196_;
                                            let _e3637 = phi_8197_;
                                            if _e3635 {
                                                phi_8202_ = type_42(0u, type_42().member_1);
                                                phi_8203_ = true;
                                            } else {
                                                phi_8202_ = _e3633;
                                                phi_8203_ = _e3637;
                                            }
                                            let _e3641 = phi_8202_;
                                            let _e3643 = phi_8203_;
                                            if _e3643 {
                                                phi_8207_ = _e3641;
                                            } else {
                                                phi_8207_ = _e3614;
                                            }
                                            let _e3645 = phi_8207_;
                                            let _e3648 = (_e3645.member != 0u);
                                            if _e3648 {
                                                phi_8214_ = false;
                                            } else {
                                                phi_8214_ = true;
                                            }
                                            let _e3650 = phi_8214_;
                                            phi_8215_ = _e3645.member_1;
                                            phi_8216_ = _e3650;
                                            phi_8217_ = _e3648;
                                            phi_8218_ = false;
                                        } else {
                                            phi_8215_ = f64();
                                            phi_8216_ = false;
                                            phi_8217_ = false;
                                            phi_8218_ = true;
                                        }
                                        let _e3652 = phi_8215_;
                                        let _e3654 = phi_8216_;
                                        let _e3656 = phi_8217_;
                                        let _e3658 = phi_8218_;
                                        phi_8219_ = _e3652;
                                        phi_8220_ = _e3654;
                                        phi_8221_ = _e3656;
                                        phi_8222_ = _e3658;
                                    }
                                    let _e3660 = phi_8219_;
                                    let _e3662 = phi_8220_;
                                    let _e3664 = phi_8221_;
                                    let _e3666 = phi_8222_;
                                    phi_8223_ = _e3660;
                                    phi_8224_ = _e2288;
                                    phi_8225_ = _e3662;
                                    phi_8226_ = _e3664;
                                    phi_8227_ = _e3666;
                                }
                                let _e3668 = phi_8223_;
                                let _e3670 = phi_8224_;
                                let _e3672 = phi_8225_;
                                let _e3674 = phi_8226_;
                                let _e3676 = phi_8227_;
                                if _e3670 {
                                    phi_8231_ = true;
                                    phi_8232_ = false;
                                    phi_8233_ = false;
                                } else {
                                    phi_8231_ = _e3672;
                                    phi_8232_ = _e3674;
                                    phi_8233_ = _e3676;
                                }
                                let _e3678 = phi_8231_;
                                let _e3680 = phi_8232_;
                                let _e3682 = phi_8233_;
                                phi_8234_ = _e3668;
                                phi_8235_ = _e1555;
                                phi_8236_ = _e3678;
                                phi_8237_ = false;
                                phi_8238_ = _e3680;
                                phi_8239_ = _e3682;
                            } else {
                                phi_8234_ = f64();
                                phi_8235_ = type_43();
                                phi_8236_ = false;
                                phi_8237_ = true;
                                phi_8238_ = false;
                                phi_8239_ = false;
                            }
                            let _e3684 = phi_8234_;
                            let _e3686 = phi_8235_;
                            let _e3688 = phi_8236_;
                            let _e3690 = phi_8237_;
                            let _e3692 = phi_8238_;
                            let _e3694 = phi_8239_;
                            local_21 = _e3690;
                            local_41 = _e3692;
                            local_42 = _e3694;
                            local_22 = _e3684;
                            local_23 = _e3686;
                            continue;
                            continuing {
                                phi_4589_ = _e1268;
                                break if !(_e3688);
                            }
                        }
                        let _e3697 = local_21;
                        if _e3697 {
                            phi_8244_ = type_42(0u, type_42().member_1);
                            phi_8245_ = false;
                            phi_8246_ = false;
                        } else {
                            phi_8244_ = type_42();
                            let _e6098 = local_41;
                            phi_8245_ = _e6098;
                            let _e6101 = local_42;
                            phi_8246_ = _e6101;
                        }
                        let _e3701 = phi_8244_;
                        let _e3703 = phi_8245_;
                        let _e3705 = phi_8246_;
                        if _e3703 {
                            let _e3707 = local_22;
                            phi_8251_ = type_42(2u, _e3707);
                            phi_8252_ = false;
                        } else {
                            phi_8251_ = type_42();
                            phi_8252_ = _e3705;
                        }
                        let _e3710 = phi_8251_;
                        let _e3712 = phi_8252_;
                        if _e3712 {
                            let _e3714 = local_23;
                            phi_8258_ = type_42(1u, _e3714.member);
                            phi_8259_ = true;
                        } else {
                            phi_8258_ = _e3710;
                            phi_8259_ = _e3703;
                        }
                        let _e3718 = phi_8258_;
                        let _e3720 = phi_8259_;
                        if _e3720 {
                            phi_8263_ = _e3718;
                        } else {
                            phi_8263_ = _e3701;
                        }
                        let _e3722 = phi_8263_;
                        phi_8267_ = _e3722;
                    }
                    let _e5447 = phi_8267_;
                    phi_8268_ = _e5447;
                }
                let _e5451 = phi_8268_;
                switch bitcast<i32>(_e5451.member) {
                    case 0: {
                        phi_8281_ = type_30(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5457 = function_(_e5451.member_1);
                        phi_8281_ = type_30(0u, _e5457, true);
                        break;
                    }
                    case 2: {
                        let _e5455 = function_(_e5451.member_1);
                        phi_8281_ = type_30(1u, _e5455, true);
                        break;
                    }
                    default: {
                        phi_8281_ = type_30();
                        break;
                    }
                }
                let _e5460 = phi_8281_;
                if _e5460.member_2 {
                    let _e5467 = (_e5460.member_1[1] >> bitcast<u32>(20i));
                    if (_e5467 <= 896u) {
                        phi_8304_ = 0u;
                    } else {
                        phi_8304_ = ((((_e5467 - 896u) << bitcast<u32>(23i)) | ((_e5460.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5460.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5482 = phi_8304_;
                    let _e5484 = atomicMin((&earliest.member[0u]), _e5482);
                }
                phi_8308_ = type_29(_e177, _e5460.member, _e183, _e186, _e5460.member_1);
                phi_8309_ = _e5460.member_2;
            } else {
                phi_8308_ = type_29(_e177, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_8309_ = false;
            }
            let _e5486 = phi_8308_;
            let _e5488 = phi_8309_;
            let _e5490 = params.member.member_1;
            if ((_e5490 & 16u) != 0u) {
                if (_e110 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5488 {
                    let _e5496 = atomicAdd((&counters[0u]), 1u);
                    phi_8327_ = _e5496;
                } else {
                    phi_8327_ = 0u;
                }
                let _e5498 = phi_8327_;
                workgroupBarrier();
                if (_e110 == 0u) {
                    let _e5501 = atomicLoad((&counters[0u]));
                    if (_e5501 > 0u) {
                        let _e5504 = atomicAdd((&contacts.member[0u]), _e5501);
                        atomicStore((&counters[1u]), _e5504);
                    }
                }
                workgroupBarrier();
                let _e5507 = atomicLoad((&counters[1u]));
                let _e5508 = (_e5507 + _e5498);
                if _e5488 {
                    let _e5510 = params.member.member_16;
                    if (_e5508 < _e5510) {
                        let _e5512 = (6u * _e5508);
                        atomicStore((&contacts.member[(4u + _e5512)]), _e5486.member);
                        atomicStore((&contacts.member[(_e5512 + 5u)]), _e5486.member_1);
                        atomicStore((&contacts.member[(_e5512 + 6u)]), _e5486.member_2);
                        atomicStore((&contacts.member[(_e5512 + 7u)]), _e5486.member_3);
                        atomicStore((&contacts.member[(_e5512 + 8u)]), _e5486.member_4[0]);
                        atomicStore((&contacts.member[(_e5512 + 9u)]), _e5486.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_275_ = _e165;
            break if !(_e171);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
