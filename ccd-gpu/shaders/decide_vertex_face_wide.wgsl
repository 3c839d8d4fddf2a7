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

struct type_10 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
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
    member_5: u32,
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

struct type_32 {
    member: array<array<f64, 3>>,
}

struct type_33 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_35 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_37 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_38 {
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_39 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_40 {
    member: f64,
    member_1: f64,
}

struct type_44 {
    member: array<array<array<f64, 3>, 4>, 2>,
    member_1: f64,
    member_2: f64,
}

struct type_45 {
    member: type_35,
    member_1: f64,
}

struct type_46 {
    member: u32,
    member_1: f64,
}

struct type_47 {
    member: type_46,
    member_1: u32,
}

struct type_48 {
    member: f64,
    member_1: f64,
    member_2: u32,
}

struct type_49 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_53 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_21;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_26;
@group(0) @binding(4) 
var<storage> input: type_10;
@group(0) @binding(2) 
var<storage> positions: type_32;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_53;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_53;
@group(0) @binding(3) 
var<storage> elements: type_28;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    return array<f64, 3>(f64(param[0]), f64(param[1]), f64(param[2]));
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    var phi_772_: array<f64, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_772_ = param_2;
    } else {
        phi_772_ = param_1;
    }
    let _e26 = phi_772_;
    return _e26;
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_624_: f64;
    var phi_626_: f64;
    var phi_668_: f64;
    var phi_670_: f64;
    var phi_718_: f64;
    var phi_720_: f64;
    var phi_429_: f64;
    var phi_431_: f64;
    var phi_479_: f64;
    var phi_481_: f64;
    var phi_526_: f64;
    var phi_528_: f64;
    var phi_579_: f64;
    var phi_581_: f64;
    var phi_735_: array<array<f64, 3>, 4>;

    let _e9 = (param_3[0] - param_4[0]);
    let _e12 = (param_3[1] - param_4[1]);
    let _e15 = (param_3[2] - param_4[2]);
    if (param_6 != 0u) {
        let _e169 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e169 > f64(0f)) {
            if (_e169 < f64(1f)) {
                phi_429_ = _e169;
            } else {
                phi_429_ = f64(1f);
            }
            let _e177 = phi_429_;
            phi_431_ = _e177;
        } else {
            phi_431_ = f64(0f);
        }
        let _e179 = phi_431_;
        let _e215 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e215 > f64(0f)) {
            if (_e215 < f64(1f)) {
                phi_479_ = _e215;
            } else {
                phi_479_ = f64(1f);
            }
            let _e223 = phi_479_;
            phi_481_ = _e223;
        } else {
            phi_481_ = f64(0f);
        }
        let _e225 = phi_481_;
        let _e258 = ((((_e9 * param_5[0]) + (_e12 * param_5[1])) + (_e15 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e258 > f64(0f)) {
            if (_e258 < f64(1f)) {
                phi_526_ = _e258;
            } else {
                phi_526_ = f64(1f);
            }
            let _e266 = phi_526_;
            phi_528_ = _e266;
        } else {
            phi_528_ = f64(0f);
        }
        let _e268 = phi_528_;
        let _e281 = (param_3[0] - param_5[0]);
        let _e284 = (param_3[1] - param_5[1]);
        let _e287 = (param_3[2] - param_5[2]);
        let _e307 = ((((_e281 * param_4[0]) + (_e284 * param_4[1])) + (_e287 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e307 > f64(0f)) {
            if (_e307 < f64(1f)) {
                phi_579_ = _e307;
            } else {
                phi_579_ = f64(1f);
            }
            let _e315 = phi_579_;
            phi_581_ = _e315;
        } else {
            phi_581_ = f64(0f);
        }
        let _e317 = phi_581_;
        phi_735_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e179)), (param_3[1] - (param_4[1] * _e179)), (param_3[2] - (param_4[2] * _e179))), array<f64, 3>((param_3[0] - (param_5[0] * _e225)), (param_3[1] - (param_5[1] * _e225)), (param_3[2] - (param_5[2] * _e225))), array<f64, 3>((_e9 - (param_5[0] * _e268)), (_e12 - (param_5[1] * _e268)), (_e15 - (param_5[2] * _e268))), array<f64, 3>((_e281 - (param_4[0] * _e317)), (_e284 - (param_4[1] * _e317)), (_e287 - (param_4[2] * _e317))));
    } else {
        let _e19 = (param_5[0] - param_4[0]);
        let _e22 = (param_5[1] - param_4[1]);
        let _e25 = (param_5[2] - param_4[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > f64(0f)) {
            if (_e36 < f64(1f)) {
                phi_624_ = _e36;
            } else {
                phi_624_ = f64(1f);
            }
            let _e44 = phi_624_;
            phi_626_ = _e44;
        } else {
            phi_626_ = f64(0f);
        }
        let _e46 = phi_626_;
        let _e53 = array<f64, 3>((_e9 - (_e19 * _e46)), (_e12 - (_e22 * _e46)), (_e15 - (_e25 * _e46)));
        let _e76 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e76 > f64(0f)) {
            if (_e76 < f64(1f)) {
                phi_668_ = _e76;
            } else {
                phi_668_ = f64(1f);
            }
            let _e84 = phi_668_;
            phi_670_ = _e84;
        } else {
            phi_670_ = f64(0f);
        }
        let _e86 = phi_670_;
        let _e122 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e122 > f64(0f)) {
            if (_e122 < f64(1f)) {
                phi_718_ = _e122;
            } else {
                phi_718_ = f64(1f);
            }
            let _e130 = phi_718_;
            phi_720_ = _e130;
        } else {
            phi_720_ = f64(0f);
        }
        let _e132 = phi_720_;
        phi_735_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e86)), (param_3[1] - (param_4[1] * _e86)), (param_3[2] - (param_4[2] * _e86))), array<f64, 3>((param_3[0] - (param_5[0] * _e132)), (param_3[1] - (param_5[1] * _e132)), (param_3[2] - (param_5[2] * _e132))), _e53, _e53);
    }
    let _e330 = phi_735_;
    let _e333 = function_1(_e330[0], _e330[1]);
    let _e335 = function_1(_e333, _e330[2]);
    let _e337 = function_1(_e335, _e330[3]);
    return _e337;
}

fn function_3(param_7: array<f64, 3>, param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: u32) -> array<f64, 3> {
    var phi_326_: bool;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_329_: bool;
    var phi_333_: bool;
    var phi_306_: bool;
    var phi_307_: bool;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_315_: bool;
    var phi_334_: bool;
    var phi_368_: array<f64, 3>;
    var phi_369_: bool;
    var phi_370_: array<f64, 3>;
    var phi_371_: bool;
    var phi_376_: array<f64, 3>;

    let _e23 = (((param_8[0] * param_8[0]) + (param_8[1] * param_8[1])) + (param_8[2] * param_8[2]));
    let _e34 = (((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2]));
    let _e45 = (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2]));
    let _e56 = (((param_7[0] * param_8[0]) + (param_7[1] * param_8[1])) + (param_7[2] * param_8[2]));
    let _e67 = (((param_7[0] * param_9[0]) + (param_7[1] * param_9[1])) + (param_7[2] * param_9[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e71 = f64(0f);
    let _e72 = f64(1f);
    let _e76 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e80 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_10 != 0u) {
        if (_e76 >= _e71) {
            if (_e80 >= _e71) {
                if (_e76 <= _e72) {
                    phi_306_ = (_e80 <= _e72);
                    phi_307_ = false;
                } else {
                    phi_306_ = bool();
                    phi_307_ = true;
                }
                let _e101 = phi_306_;
                let _e103 = phi_307_;
                phi_308_ = _e101;
                phi_309_ = _e103;
            } else {
                phi_308_ = bool();
                phi_309_ = true;
            }
            let _e105 = phi_308_;
            let _e107 = phi_309_;
            phi_310_ = _e105;
            phi_311_ = _e107;
        } else {
            phi_310_ = bool();
            phi_311_ = true;
        }
        let _e109 = phi_310_;
        let _e111 = phi_311_;
        if _e111 {
            phi_315_ = false;
        } else {
            phi_315_ = _e109;
        }
        let _e113 = phi_315_;
        phi_334_ = _e113;
    } else {
        if (_e76 >= _e71) {
            if (_e80 >= _e71) {
                phi_326_ = ((_e76 + _e80) <= _e72);
                phi_327_ = false;
            } else {
                phi_326_ = bool();
                phi_327_ = true;
            }
            let _e87 = phi_326_;
            let _e89 = phi_327_;
            phi_328_ = _e87;
            phi_329_ = _e89;
        } else {
            phi_328_ = bool();
            phi_329_ = true;
        }
        let _e91 = phi_328_;
        let _e93 = phi_329_;
        if _e93 {
            phi_333_ = false;
        } else {
            phi_333_ = _e91;
        }
        let _e95 = phi_333_;
        phi_334_ = _e95;
    }
    let _e115 = phi_334_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e115 {
            phi_368_ = array<f64, 3>((param_7[0] - ((param_8[0] * _e76) + (param_9[0] * _e80))), (param_7[1] - ((param_8[1] * _e76) + (param_9[1] * _e80))), (param_7[2] - ((param_8[2] * _e76) + (param_9[2] * _e80))));
            phi_369_ = false;
        } else {
            phi_368_ = array<f64, 3>();
            phi_369_ = true;
        }
        let _e144 = phi_368_;
        let _e146 = phi_369_;
        phi_370_ = _e144;
        phi_371_ = _e146;
    } else {
        phi_370_ = array<f64, 3>();
        phi_371_ = true;
    }
    let _e148 = phi_370_;
    let _e150 = phi_371_;
    if _e150 {
        let _e151 = function_2(param_7, param_8, param_9, param_10);
        phi_376_ = _e151;
    } else {
        phi_376_ = _e148;
    }
    let _e153 = phi_376_;
    return _e153;
}

fn function_4(param_11: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_11);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_5(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_38;
    var local_1: type_38;
    var local_2: type_39;
    var local_3: type_39;
    var local_4: type_39;
    var local_5: array<type_40, 4>;
    var local_6: array<f64, 4>;
    var local_7: array<f64, 2>;
    var local_8: type_38;
    var local_9: type_38;
    var local_10: type_38;
    var local_11: type_38;
    var local_12: array<f64, 4>;
    var local_13: array<f32, 3>;
    var local_14: type_44;
    var local_15: type_38;
    var local_16: type_38;
    var local_17: type_38;
    var local_18: type_35;
    var phi_839_: u32;
    var phi_855_: u32;
    var phi_876_: u32;
    var phi_877_: u32;
    var phi_880_: type_12;
    var phi_881_: type_12;
    var phi_904_: type_12;
    var phi_1151_: type_33;
    var phi_1276_: f64;
    var phi_1282_: f64;
    var phi_1287_: f64;
    var phi_1293_: f64;
    var phi_1298_: f64;
    var phi_1304_: f64;
    var phi_1310_: f64;
    var phi_1315_: f64;
    var phi_1321_: f64;
    var phi_1326_: f64;
    var phi_1331_: f64;
    var phi_1338_: f64;
    var phi_1344_: f64;
    var phi_1349_: f64;
    var phi_1355_: f64;
    var phi_1360_: f64;
    var phi_1366_: f64;
    var phi_1372_: f64;
    var phi_1377_: f64;
    var phi_1383_: f64;
    var phi_1388_: f64;
    var phi_1393_: f64;
    var phi_1400_: f64;
    var phi_1406_: f64;
    var phi_1411_: f64;
    var phi_1417_: f64;
    var phi_1422_: f64;
    var phi_1428_: f64;
    var phi_1434_: f64;
    var phi_1439_: f64;
    var phi_1445_: f64;
    var phi_1450_: f64;
    var phi_1455_: f64;
    var phi_1461_: f64;
    var phi_1466_: f64;
    var phi_1475_: bool;
    var phi_1499_: u64;
    var phi_1511_: f64;
    var phi_1512_: f64;
    var phi_1543_: type_45;
    var phi_1544_: bool;
    var phi_1545_: type_45;
    var phi_1546_: bool;
    var phi_1547_: type_45;
    var phi_1548_: bool;
    var phi_1553_: type_45;
    var phi_8619_: f64;
    var phi_8626_: f64;
    var phi_8631_: f64;
    var phi_8638_: f64;
    var phi_8643_: f64;
    var phi_8656_: f64;
    var phi_8663_: f64;
    var phi_8668_: f64;
    var phi_8675_: f64;
    var phi_8680_: f64;
    var phi_8685_: f64;
    var phi_8702_: f64;
    var phi_8709_: f64;
    var phi_8714_: f64;
    var phi_8721_: f64;
    var phi_8726_: f64;
    var phi_8740_: f64;
    var phi_8747_: f64;
    var phi_8752_: f64;
    var phi_8759_: f64;
    var phi_8764_: f64;
    var phi_8769_: f64;
    var phi_8786_: f64;
    var phi_8793_: f64;
    var phi_8798_: f64;
    var phi_8805_: f64;
    var phi_8810_: f64;
    var phi_8824_: f64;
    var phi_8831_: f64;
    var phi_8836_: f64;
    var phi_8843_: f64;
    var phi_8848_: f64;
    var phi_8853_: f64;
    var phi_8890_: f64;
    var phi_8896_: f64;
    var phi_8903_: f64;
    var phi_8910_: f64;
    var phi_8916_: f64;
    var phi_8923_: f64;
    var phi_8929_: f64;
    var phi_8935_: f64;
    var phi_8941_: f64;
    var phi_8948_: f64;
    var phi_8955_: f64;
    var phi_8983_: f64;
    var phi_8988_: f64;
    var phi_8993_: f64;
    var phi_8998_: f64;
    var phi_9003_: f64;
    var phi_9008_: f64;
    var phi_9019_: f64;
    var phi_9033_: f64;
    var phi_9039_: f64;
    var phi_9044_: f64;
    var phi_9050_: f64;
    var phi_9056_: f64;
    var phi_9061_: f64;
    var phi_9066_: f64;
    var phi_9076_: bool;
    var phi_9083_: f64;
    var phi_9091_: f64;
    var phi_9099_: f64;
    var phi_9118_: f64;
    var phi_9267_: f64;
    var phi_9274_: f64;
    var phi_9279_: f64;
    var phi_9286_: f64;
    var phi_9291_: f64;
    var phi_9304_: f64;
    var phi_9311_: f64;
    var phi_9316_: f64;
    var phi_9323_: f64;
    var phi_9328_: f64;
    var phi_9333_: f64;
    var phi_9350_: f64;
    var phi_9357_: f64;
    var phi_9362_: f64;
    var phi_9369_: f64;
    var phi_9374_: f64;
    var phi_9388_: f64;
    var phi_9395_: f64;
    var phi_9400_: f64;
    var phi_9407_: f64;
    var phi_9412_: f64;
    var phi_9417_: f64;
    var phi_9434_: f64;
    var phi_9441_: f64;
    var phi_9446_: f64;
    var phi_9453_: f64;
    var phi_9458_: f64;
    var phi_9472_: f64;
    var phi_9479_: f64;
    var phi_9484_: f64;
    var phi_9491_: f64;
    var phi_9496_: f64;
    var phi_9501_: f64;
    var phi_9622_: f64;
    var phi_9629_: f64;
    var phi_9637_: f64;
    var phi_9683_: type_16;
    var phi_9686_: f64;
    var phi_9707_: bool;
    var phi_9713_: type_17;
    var phi_9684_: type_16;
    var phi_9727_: type_17;
    var phi_9687_: f64;
    var local_19: f64;
    var phi_9676_: f64;
    var phi_9740_: f64;
    var phi_9809_: f64;
    var phi_9815_: f64;
    var phi_9824_: f64;
    var phi_9830_: f64;
    var phi_9839_: f64;
    var phi_9845_: f64;
    var phi_9854_: f64;
    var phi_9860_: f64;
    var phi_9866_: type_38;
    var phi_9867_: bool;
    var phi_9868_: type_38;
    var phi_9869_: bool;
    var phi_9879_: type_38;
    var phi_10049_: bool;
    var phi_10050_: bool;
    var phi_10051_: bool;
    var phi_10052_: bool;
    var phi_10053_: bool;
    var phi_10054_: bool;
    var phi_10058_: bool;
    var phi_10086_: f64;
    var phi_10092_: f64;
    var phi_10099_: f64;
    var phi_10142_: type_16;
    var phi_10145_: f64;
    var phi_10166_: bool;
    var phi_10172_: type_17;
    var phi_10143_: type_16;
    var phi_10186_: type_17;
    var phi_10146_: f64;
    var local_20: f64;
    var phi_10135_: f64;
    var phi_10199_: f64;
    var phi_10268_: f64;
    var phi_10274_: f64;
    var phi_10283_: f64;
    var phi_10289_: f64;
    var phi_10298_: f64;
    var phi_10304_: f64;
    var phi_10313_: f64;
    var phi_10319_: f64;
    var phi_10325_: type_38;
    var phi_10326_: bool;
    var phi_10327_: type_38;
    var phi_10328_: bool;
    var phi_10338_: type_38;
    var phi_10508_: bool;
    var phi_10509_: bool;
    var phi_10510_: bool;
    var phi_10511_: bool;
    var phi_10512_: bool;
    var phi_10513_: bool;
    var phi_10517_: bool;
    var phi_10545_: f64;
    var phi_10551_: f64;
    var phi_10558_: f64;
    var phi_10601_: type_16;
    var phi_10604_: f64;
    var phi_10625_: bool;
    var phi_10631_: type_17;
    var phi_10602_: type_16;
    var phi_10645_: type_17;
    var phi_10605_: f64;
    var local_21: f64;
    var phi_10594_: f64;
    var phi_10658_: f64;
    var phi_10727_: f64;
    var phi_10733_: f64;
    var phi_10742_: f64;
    var phi_10748_: f64;
    var phi_10757_: f64;
    var phi_10763_: f64;
    var phi_10772_: f64;
    var phi_10778_: f64;
    var phi_10784_: type_38;
    var phi_10785_: bool;
    var phi_10786_: type_38;
    var phi_10787_: bool;
    var phi_10797_: type_38;
    var phi_10967_: bool;
    var phi_10968_: bool;
    var phi_10969_: bool;
    var phi_10970_: bool;
    var phi_10971_: bool;
    var phi_10972_: bool;
    var phi_10976_: bool;
    var phi_11004_: f64;
    var phi_11010_: f64;
    var phi_11017_: f64;
    var phi_11060_: type_16;
    var phi_11063_: f64;
    var phi_11084_: bool;
    var phi_11090_: type_17;
    var phi_11061_: type_16;
    var phi_11104_: type_17;
    var phi_11064_: f64;
    var local_22: f64;
    var phi_11053_: f64;
    var phi_11117_: f64;
    var phi_11186_: f64;
    var phi_11192_: f64;
    var phi_11201_: f64;
    var phi_11207_: f64;
    var phi_11216_: f64;
    var phi_11222_: f64;
    var phi_11231_: f64;
    var phi_11237_: f64;
    var phi_11243_: type_38;
    var phi_11244_: bool;
    var phi_11245_: type_38;
    var phi_11246_: bool;
    var phi_11256_: type_38;
    var phi_11426_: bool;
    var phi_11427_: bool;
    var phi_11428_: bool;
    var phi_11429_: bool;
    var phi_11430_: bool;
    var phi_11431_: bool;
    var phi_11435_: bool;
    var phi_11436_: bool;
    var phi_11437_: bool;
    var phi_11438_: bool;
    var phi_11439_: bool;
    var phi_11440_: bool;
    var phi_11444_: bool;
    var phi_11450_: type_46;
    var phi_11451_: bool;
    var phi_11452_: type_46;
    var phi_11453_: bool;
    var phi_11499_: type_16;
    var phi_11502_: f64;
    var phi_11523_: bool;
    var phi_11529_: type_17;
    var phi_11500_: type_16;
    var phi_11543_: type_17;
    var phi_11503_: f64;
    var local_23: f64;
    var phi_11492_: f64;
    var phi_11556_: f64;
    var phi_11562_: f64;
    var phi_11587_: type_12;
    var phi_11590_: u32;
    var phi_11588_: type_12;
    var phi_11613_: type_12;
    var phi_11657_: u32;
    var phi_11658_: u32;
    var phi_11591_: u32;
    var phi_11659_: u32;
    var phi_11679_: type_12;
    var phi_11680_: type_12;
    var phi_11703_: type_12;
    var phi_11722_: f64;
    var phi_11735_: f64;
    var phi_11771_: f64;
    var phi_11778_: f64;
    var phi_11790_: bool;
    var phi_11791_: bool;
    var phi_11792_: bool;
    var phi_11793_: bool;
    var phi_11797_: bool;
    var phi_11809_: type_49;
    var phi_11810_: type_49;
    var phi_11811_: bool;
    var phi_11812_: type_49;
    var phi_11813_: bool;
    var phi_11826_: f64;
    var phi_11838_: type_12;
    var phi_11841_: f64;
    var phi_11843_: f64;
    var phi_11845_: f64;
    var phi_11839_: type_12;
    var phi_11868_: type_12;
    var phi_11895_: f64;
    var phi_11896_: f64;
    var phi_11924_: f64;
    var phi_11940_: f64;
    var phi_11947_: bool;
    var phi_11948_: bool;
    var phi_11949_: bool;
    var phi_11955_: f64;
    var phi_11956_: f64;
    var phi_11957_: bool;
    var phi_11842_: f64;
    var phi_11844_: f64;
    var phi_11846_: f64;
    var phi_11958_: f64;
    var phi_11959_: bool;
    var phi_11960_: bool;
    var local_24: bool;
    var phi_11964_: f64;
    var phi_11965_: f64;
    var phi_11975_: f64;
    var phi_11979_: type_12;
    var phi_11982_: f64;
    var phi_11980_: type_12;
    var phi_12005_: type_12;
    var phi_12036_: f64;
    var phi_12037_: bool;
    var phi_12038_: f64;
    var phi_12039_: bool;
    var phi_12040_: bool;
    var phi_12041_: bool;
    var phi_12042_: f64;
    var phi_11983_: f64;
    var phi_12043_: bool;
    var phi_12044_: bool;
    var phi_12045_: bool;
    var phi_12046_: bool;
    var local_25: bool;
    var phi_12050_: bool;
    var phi_12051_: bool;
    var phi_12055_: bool;
    var phi_12059_: f64;
    var phi_12060_: f64;
    var phi_12062_: type_49;
    var phi_12093_: f64;
    var phi_12100_: f64;
    var phi_12105_: f64;
    var phi_12112_: f64;
    var phi_12117_: f64;
    var phi_12130_: f64;
    var phi_12137_: f64;
    var phi_12142_: f64;
    var phi_12149_: f64;
    var phi_12154_: f64;
    var phi_12159_: f64;
    var phi_12218_: f64;
    var phi_12224_: f64;
    var phi_12229_: f64;
    var phi_12235_: f64;
    var phi_12240_: f64;
    var phi_12254_: f64;
    var phi_12260_: f64;
    var phi_12265_: f64;
    var phi_12271_: f64;
    var phi_12276_: f64;
    var phi_12302_: f64;
    var phi_12309_: f64;
    var phi_12314_: f64;
    var phi_12321_: f64;
    var phi_12326_: f64;
    var phi_12339_: f64;
    var phi_12346_: f64;
    var phi_12351_: f64;
    var phi_12358_: f64;
    var phi_12363_: f64;
    var phi_12368_: f64;
    var phi_12427_: f64;
    var phi_12433_: f64;
    var phi_12438_: f64;
    var phi_12444_: f64;
    var phi_12449_: f64;
    var phi_12463_: f64;
    var phi_12469_: f64;
    var phi_12474_: f64;
    var phi_12480_: f64;
    var phi_12485_: f64;
    var phi_12511_: f64;
    var phi_12518_: f64;
    var phi_12523_: f64;
    var phi_12530_: f64;
    var phi_12535_: f64;
    var phi_12548_: f64;
    var phi_12555_: f64;
    var phi_12560_: f64;
    var phi_12567_: f64;
    var phi_12572_: f64;
    var phi_12577_: f64;
    var phi_12636_: f64;
    var phi_12642_: f64;
    var phi_12647_: f64;
    var phi_12653_: f64;
    var phi_12658_: f64;
    var phi_12672_: f64;
    var phi_12678_: f64;
    var phi_12683_: f64;
    var phi_12689_: f64;
    var phi_12694_: f64;
    var phi_12743_: f64;
    var phi_12749_: f64;
    var phi_12777_: f64;
    var phi_12783_: f64;
    var phi_12788_: u32;
    var phi_12789_: u32;
    var phi_12759_: f64;
    var phi_12765_: f64;
    var phi_12770_: u32;
    var phi_12771_: u32;
    var phi_12790_: u32;
    var phi_12791_: u32;
    var phi_12864_: f64;
    var phi_12876_: f64;
    var phi_13019_: f64;
    var phi_13025_: f64;
    var phi_13032_: f64;
    var phi_13088_: type_12;
    var phi_13091_: bool;
    var phi_13089_: type_12;
    var phi_13114_: type_12;
    var phi_13141_: bool;
    var phi_13142_: bool;
    var phi_13092_: bool;
    var phi_13143_: bool;
    var phi_13144_: bool;
    var local_26: bool;
    var phi_13148_: bool;
    var local_27: bool;
    var phi_13155_: u32;
    var phi_13156_: u32;
    var phi_13157_: bool;
    var phi_13158_: u32;
    var phi_13159_: u32;
    var phi_13160_: bool;
    var phi_13164_: u32;
    var phi_13174_: bool;
    var phi_13187_: bool;
    var phi_13188_: bool;
    var phi_13336_: f64;
    var phi_13343_: f64;
    var phi_13348_: f64;
    var phi_13355_: f64;
    var phi_13360_: f64;
    var phi_13373_: f64;
    var phi_13380_: f64;
    var phi_13385_: f64;
    var phi_13392_: f64;
    var phi_13397_: f64;
    var phi_13402_: f64;
    var phi_13419_: f64;
    var phi_13426_: f64;
    var phi_13431_: f64;
    var phi_13438_: f64;
    var phi_13443_: f64;
    var phi_13457_: f64;
    var phi_13464_: f64;
    var phi_13469_: f64;
    var phi_13476_: f64;
    var phi_13481_: f64;
    var phi_13486_: f64;
    var phi_13503_: f64;
    var phi_13510_: f64;
    var phi_13515_: f64;
    var phi_13522_: f64;
    var phi_13527_: f64;
    var phi_13541_: f64;
    var phi_13548_: f64;
    var phi_13553_: f64;
    var phi_13560_: f64;
    var phi_13565_: f64;
    var phi_13570_: f64;
    var phi_13617_: type_12;
    var phi_13620_: f64;
    var phi_13622_: f64;
    var phi_13624_: f64;
    var phi_13626_: f64;
    var phi_13628_: bool;
    var phi_13630_: u32;
    var phi_13618_: type_12;
    var phi_13653_: type_12;
    var phi_13768_: f64;
    var phi_13774_: f64;
    var phi_13780_: f64;
    var phi_13782_: array<f64, 3>;
    var phi_13789_: f64;
    var phi_13796_: f64;
    var phi_13804_: f64;
    var phi_13850_: type_16;
    var phi_13853_: f64;
    var phi_13874_: bool;
    var phi_13880_: type_17;
    var phi_13851_: type_16;
    var phi_13894_: type_17;
    var phi_13854_: f64;
    var local_28: f64;
    var phi_13843_: f64;
    var phi_13907_: f64;
    var phi_13976_: f64;
    var phi_13982_: f64;
    var phi_13991_: f64;
    var phi_13997_: f64;
    var phi_14006_: f64;
    var phi_14012_: f64;
    var phi_14021_: f64;
    var phi_14027_: f64;
    var phi_14033_: type_38;
    var phi_14034_: bool;
    var phi_14035_: type_38;
    var phi_14036_: bool;
    var phi_14046_: type_38;
    var phi_14218_: bool;
    var phi_14219_: bool;
    var phi_14220_: bool;
    var phi_14221_: bool;
    var phi_14222_: bool;
    var phi_14223_: bool;
    var phi_14227_: bool;
    var phi_14525_: bool;
    var phi_14526_: bool;
    var phi_14527_: bool;
    var phi_14528_: bool;
    var phi_14529_: bool;
    var phi_14530_: bool;
    var phi_14534_: bool;
    var phi_14538_: bool;
    var phi_14549_: bool;
    var phi_14550_: bool;
    var phi_14624_: bool;
    var phi_14625_: bool;
    var phi_14648_: f64;
    var phi_14649_: bool;
    var phi_14650_: f64;
    var phi_14651_: bool;
    var phi_14652_: f64;
    var phi_14653_: bool;
    var phi_14654_: bool;
    var phi_14659_: f64;
    var phi_14660_: bool;
    var phi_14664_: f64;
    var phi_14696_: bool;
    var phi_14697_: bool;
    var phi_14720_: f64;
    var phi_14721_: bool;
    var phi_14722_: f64;
    var phi_14723_: bool;
    var phi_14724_: f64;
    var phi_14725_: bool;
    var phi_14726_: bool;
    var phi_14731_: f64;
    var phi_14732_: bool;
    var phi_14736_: f64;
    var phi_14741_: f64;
    var phi_14773_: bool;
    var phi_14774_: bool;
    var phi_14797_: f64;
    var phi_14798_: bool;
    var phi_14799_: f64;
    var phi_14800_: bool;
    var phi_14801_: f64;
    var phi_14802_: bool;
    var phi_14803_: bool;
    var phi_14808_: f64;
    var phi_14809_: bool;
    var phi_14813_: f64;
    var phi_14845_: bool;
    var phi_14846_: bool;
    var phi_14869_: f64;
    var phi_14870_: bool;
    var phi_14871_: f64;
    var phi_14872_: bool;
    var phi_14873_: f64;
    var phi_14874_: bool;
    var phi_14875_: bool;
    var phi_14880_: f64;
    var phi_14881_: bool;
    var phi_14885_: f64;
    var phi_14890_: f64;
    var phi_14895_: f64;
    var phi_14900_: f64;
    var phi_14914_: f64;
    var phi_15052_: type_16;
    var phi_15055_: f64;
    var phi_15076_: bool;
    var phi_15082_: type_17;
    var phi_15053_: type_16;
    var phi_15096_: type_17;
    var phi_15056_: f64;
    var local_29: f64;
    var phi_15045_: f64;
    var phi_15109_: f64;
    var phi_15127_: f64;
    var phi_15134_: f64;
    var phi_15139_: f64;
    var phi_15146_: f64;
    var phi_15151_: f64;
    var phi_15164_: f64;
    var phi_15171_: f64;
    var phi_15176_: f64;
    var phi_15183_: f64;
    var phi_15188_: f64;
    var phi_15193_: f64;
    var phi_15210_: f64;
    var phi_15217_: f64;
    var phi_15222_: f64;
    var phi_15229_: f64;
    var phi_15234_: f64;
    var phi_15248_: f64;
    var phi_15255_: f64;
    var phi_15260_: f64;
    var phi_15267_: f64;
    var phi_15272_: f64;
    var phi_15277_: f64;
    var phi_15294_: f64;
    var phi_15301_: f64;
    var phi_15306_: f64;
    var phi_15313_: f64;
    var phi_15318_: f64;
    var phi_15332_: f64;
    var phi_15339_: f64;
    var phi_15344_: f64;
    var phi_15351_: f64;
    var phi_15356_: f64;
    var phi_15361_: f64;
    var phi_15385_: bool;
    var phi_15386_: bool;
    var phi_15387_: bool;
    var phi_15404_: f64;
    var phi_15405_: bool;
    var phi_15406_: f64;
    var phi_15407_: bool;
    var phi_15412_: f64;
    var phi_15414_: f64;
    var phi_15415_: f64;
    var phi_15416_: bool;
    var phi_15417_: f64;
    var phi_15418_: f64;
    var phi_15419_: bool;
    var phi_15420_: bool;
    var phi_15421_: f64;
    var phi_15422_: f64;
    var phi_15423_: f64;
    var phi_15424_: f64;
    var phi_15425_: bool;
    var phi_15426_: bool;
    var phi_15427_: bool;
    var phi_15428_: bool;
    var phi_15429_: f64;
    var phi_15430_: f64;
    var phi_15431_: f64;
    var phi_15432_: f64;
    var phi_15433_: bool;
    var phi_15434_: bool;
    var phi_15435_: bool;
    var phi_15436_: bool;
    var phi_15437_: bool;
    var phi_15438_: f64;
    var phi_15439_: f64;
    var phi_15440_: f64;
    var phi_15441_: f64;
    var phi_15442_: bool;
    var phi_15443_: bool;
    var phi_15444_: bool;
    var phi_15445_: bool;
    var phi_15446_: bool;
    var phi_15532_: f64;
    var phi_15605_: f64;
    var phi_15610_: f64;
    var phi_15683_: f64;
    var phi_15756_: f64;
    var phi_15761_: f64;
    var phi_15782_: f64;
    var phi_15783_: f64;
    var phi_15784_: f64;
    var phi_15459_: bool;
    var phi_15786_: u32;
    var phi_15787_: f64;
    var phi_15788_: bool;
    var phi_15789_: bool;
    var phi_15790_: bool;
    var phi_15791_: u32;
    var phi_15792_: f64;
    var phi_15793_: f64;
    var phi_15794_: f64;
    var phi_15795_: f64;
    var phi_15796_: bool;
    var phi_15797_: u32;
    var phi_15798_: bool;
    var phi_15799_: bool;
    var phi_15800_: bool;
    var phi_15801_: bool;
    var phi_15802_: bool;
    var phi_15803_: bool;
    var phi_15812_: f64;
    var phi_15817_: f64;
    var phi_15826_: bool;
    var phi_15830_: bool;
    var phi_15831_: f64;
    var phi_15832_: f64;
    var phi_15833_: f64;
    var phi_15834_: f64;
    var phi_15835_: bool;
    var phi_15836_: u32;
    var phi_15837_: bool;
    var phi_15838_: bool;
    var phi_15839_: bool;
    var phi_15840_: bool;
    var phi_15841_: bool;
    var phi_15842_: bool;
    var phi_13621_: f64;
    var phi_13623_: f64;
    var phi_13625_: f64;
    var phi_13627_: f64;
    var phi_13629_: bool;
    var phi_13631_: u32;
    var phi_15843_: f64;
    var phi_15844_: f64;
    var phi_15845_: bool;
    var phi_15846_: bool;
    var phi_15847_: bool;
    var phi_15848_: bool;
    var phi_15849_: bool;
    var phi_15850_: bool;
    var phi_15851_: bool;
    var local_30: bool;
    var phi_15855_: bool;
    var phi_15856_: bool;
    var phi_15857_: bool;
    var phi_15858_: bool;
    var phi_15859_: bool;
    var local_31: f64;
    var phi_15864_: type_46;
    var phi_15865_: bool;
    var phi_15866_: bool;
    var phi_15867_: bool;
    var phi_15868_: bool;
    var phi_15869_: bool;
    var phi_15874_: type_46;
    var phi_15875_: bool;
    var phi_15876_: bool;
    var phi_15877_: bool;
    var phi_15878_: bool;
    var phi_15879_: bool;
    var phi_15883_: f64;
    var phi_15884_: bool;
    var phi_15885_: bool;
    var phi_15886_: bool;
    var phi_15887_: bool;
    var phi_15891_: f64;
    var phi_15892_: bool;
    var phi_15893_: bool;
    var phi_15894_: bool;
    var phi_15899_: type_46;
    var phi_15900_: bool;
    var phi_15901_: bool;
    var phi_15906_: type_46;
    var phi_15907_: bool;
    var phi_15911_: type_46;
    var phi_15918_: bool;
    var phi_15919_: f64;
    var phi_15920_: bool;
    var phi_15921_: bool;
    var phi_15922_: bool;
    var phi_15923_: bool;
    var phi_15924_: f64;
    var phi_15925_: f64;
    var phi_15926_: bool;
    var phi_15927_: bool;
    var phi_15928_: bool;
    var phi_15929_: bool;
    var phi_15930_: f64;
    var phi_15931_: f64;
    var phi_15932_: bool;
    var phi_15933_: bool;
    var phi_15934_: bool;
    var phi_15935_: bool;
    var phi_15939_: bool;
    var phi_15940_: bool;
    var phi_15941_: bool;
    var phi_15942_: type_49;
    var phi_15943_: bool;
    var phi_15944_: f64;
    var phi_15945_: f64;
    var phi_15946_: type_49;
    var phi_15947_: bool;
    var phi_15948_: bool;
    var phi_15949_: bool;
    var phi_15950_: bool;
    var phi_15954_: bool;
    var phi_15955_: bool;
    var phi_15956_: bool;
    var phi_15957_: type_49;
    var phi_15958_: bool;
    var phi_15959_: f64;
    var phi_15960_: f64;
    var phi_15961_: type_49;
    var phi_15962_: bool;
    var phi_15963_: bool;
    var phi_15964_: bool;
    var phi_15965_: bool;
    var local_32: bool;
    var phi_15970_: type_46;
    var phi_15971_: bool;
    var phi_15972_: bool;
    var local_33: bool;
    var local_34: type_49;
    var local_35: f64;
    var local_36: f64;
    var local_37: f64;
    var phi_15986_: type_46;
    var phi_15987_: bool;
    var phi_15988_: type_46;
    var phi_15989_: bool;
    var local_38: f64;
    var phi_15994_: type_46;
    var phi_15995_: type_46;
    var phi_15996_: bool;
    var local_39: type_49;
    var phi_16002_: type_46;
    var phi_16003_: bool;
    var phi_16007_: type_46;
    var phi_16008_: type_46;
    var phi_16009_: bool;
    var phi_16013_: type_46;
    var phi_16014_: type_46;
    var phi_16015_: bool;
    var phi_16019_: type_46;
    var phi_16030_: bool;
    var phi_16031_: bool;
    var phi_16035_: bool;
    var phi_16039_: u32;
    var phi_1728_: type_16;
    var phi_1731_: f64;
    var phi_1752_: bool;
    var phi_1758_: type_17;
    var phi_1729_: type_16;
    var phi_1772_: type_17;
    var phi_1732_: f64;
    var local_40: f64;
    var phi_1721_: f64;
    var phi_1785_: f64;
    var phi_1803_: f64;
    var phi_1810_: f64;
    var phi_1815_: f64;
    var phi_1822_: f64;
    var phi_1827_: f64;
    var phi_1840_: f64;
    var phi_1847_: f64;
    var phi_1852_: f64;
    var phi_1859_: f64;
    var phi_1864_: f64;
    var phi_1869_: f64;
    var phi_1886_: f64;
    var phi_1893_: f64;
    var phi_1898_: f64;
    var phi_1905_: f64;
    var phi_1910_: f64;
    var phi_1924_: f64;
    var phi_1931_: f64;
    var phi_1936_: f64;
    var phi_1943_: f64;
    var phi_1948_: f64;
    var phi_1953_: f64;
    var phi_1970_: f64;
    var phi_1977_: f64;
    var phi_1982_: f64;
    var phi_1989_: f64;
    var phi_1994_: f64;
    var phi_2008_: f64;
    var phi_2015_: f64;
    var phi_2020_: f64;
    var phi_2027_: f64;
    var phi_2032_: f64;
    var phi_2037_: f64;
    var phi_2302_: f64;
    var phi_2309_: f64;
    var phi_2314_: f64;
    var phi_2321_: f64;
    var phi_2326_: f64;
    var phi_2339_: f64;
    var phi_2346_: f64;
    var phi_2351_: f64;
    var phi_2358_: f64;
    var phi_2363_: f64;
    var phi_2368_: f64;
    var phi_2385_: f64;
    var phi_2392_: f64;
    var phi_2397_: f64;
    var phi_2404_: f64;
    var phi_2409_: f64;
    var phi_2423_: f64;
    var phi_2430_: f64;
    var phi_2435_: f64;
    var phi_2442_: f64;
    var phi_2447_: f64;
    var phi_2452_: f64;
    var phi_2469_: f64;
    var phi_2476_: f64;
    var phi_2481_: f64;
    var phi_2488_: f64;
    var phi_2493_: f64;
    var phi_2507_: f64;
    var phi_2514_: f64;
    var phi_2519_: f64;
    var phi_2526_: f64;
    var phi_2531_: f64;
    var phi_2536_: f64;
    var phi_2573_: f64;
    var phi_2579_: f64;
    var phi_2586_: f64;
    var phi_2593_: f64;
    var phi_2599_: f64;
    var phi_2606_: f64;
    var phi_2612_: f64;
    var phi_2618_: f64;
    var phi_2624_: f64;
    var phi_2631_: f64;
    var phi_2638_: f64;
    var phi_2666_: f64;
    var phi_2671_: f64;
    var phi_2676_: f64;
    var phi_2681_: f64;
    var phi_2686_: f64;
    var phi_2691_: f64;
    var phi_2702_: f64;
    var phi_2712_: type_47;
    var phi_2713_: bool;
    var phi_2714_: type_47;
    var phi_2715_: bool;
    var phi_2721_: type_16;
    var phi_2724_: f64;
    var phi_2726_: u32;
    var phi_2728_: f64;
    var phi_2749_: bool;
    var phi_2755_: type_17;
    var phi_2722_: type_16;
    var phi_2769_: type_17;
    var phi_2784_: bool;
    var phi_2785_: bool;
    var phi_2931_: f64;
    var phi_2938_: f64;
    var phi_2943_: f64;
    var phi_2950_: f64;
    var phi_2955_: f64;
    var phi_2968_: f64;
    var phi_2975_: f64;
    var phi_2980_: f64;
    var phi_2987_: f64;
    var phi_2992_: f64;
    var phi_2997_: f64;
    var phi_3014_: f64;
    var phi_3021_: f64;
    var phi_3026_: f64;
    var phi_3033_: f64;
    var phi_3038_: f64;
    var phi_3052_: f64;
    var phi_3059_: f64;
    var phi_3064_: f64;
    var phi_3071_: f64;
    var phi_3076_: f64;
    var phi_3081_: f64;
    var phi_3098_: f64;
    var phi_3105_: f64;
    var phi_3110_: f64;
    var phi_3117_: f64;
    var phi_3122_: f64;
    var phi_3136_: f64;
    var phi_3143_: f64;
    var phi_3148_: f64;
    var phi_3155_: f64;
    var phi_3160_: f64;
    var phi_3165_: f64;
    var phi_3212_: type_12;
    var phi_3215_: f64;
    var phi_3217_: f64;
    var phi_3219_: f64;
    var phi_3221_: f64;
    var phi_3223_: bool;
    var phi_3225_: u32;
    var phi_3213_: type_12;
    var phi_3248_: type_12;
    var phi_3363_: f64;
    var phi_3369_: f64;
    var phi_3375_: f64;
    var phi_3377_: array<f64, 3>;
    var phi_3384_: f64;
    var phi_3391_: f64;
    var phi_3399_: f64;
    var phi_3445_: type_16;
    var phi_3448_: f64;
    var phi_3469_: bool;
    var phi_3475_: type_17;
    var phi_3446_: type_16;
    var phi_3489_: type_17;
    var phi_3449_: f64;
    var local_41: f64;
    var phi_3438_: f64;
    var phi_3502_: f64;
    var phi_3571_: f64;
    var phi_3577_: f64;
    var phi_3586_: f64;
    var phi_3592_: f64;
    var phi_3601_: f64;
    var phi_3607_: f64;
    var phi_3616_: f64;
    var phi_3622_: f64;
    var phi_3628_: type_38;
    var phi_3629_: bool;
    var phi_3630_: type_38;
    var phi_3631_: bool;
    var phi_3641_: type_38;
    var phi_3813_: bool;
    var phi_3814_: bool;
    var phi_3815_: bool;
    var phi_3816_: bool;
    var phi_3817_: bool;
    var phi_3818_: bool;
    var phi_3822_: bool;
    var phi_4120_: bool;
    var phi_4121_: bool;
    var phi_4122_: bool;
    var phi_4123_: bool;
    var phi_4124_: bool;
    var phi_4125_: bool;
    var phi_4129_: bool;
    var phi_4133_: bool;
    var phi_4144_: bool;
    var phi_4145_: bool;
    var phi_4219_: bool;
    var phi_4220_: bool;
    var phi_4243_: f64;
    var phi_4244_: bool;
    var phi_4245_: f64;
    var phi_4246_: bool;
    var phi_4247_: f64;
    var phi_4248_: bool;
    var phi_4249_: bool;
    var phi_4254_: f64;
    var phi_4255_: bool;
    var phi_4259_: f64;
    var phi_4291_: bool;
    var phi_4292_: bool;
    var phi_4315_: f64;
    var phi_4316_: bool;
    var phi_4317_: f64;
    var phi_4318_: bool;
    var phi_4319_: f64;
    var phi_4320_: bool;
    var phi_4321_: bool;
    var phi_4326_: f64;
    var phi_4327_: bool;
    var phi_4331_: f64;
    var phi_4336_: f64;
    var phi_4368_: bool;
    var phi_4369_: bool;
    var phi_4392_: f64;
    var phi_4393_: bool;
    var phi_4394_: f64;
    var phi_4395_: bool;
    var phi_4396_: f64;
    var phi_4397_: bool;
    var phi_4398_: bool;
    var phi_4403_: f64;
    var phi_4404_: bool;
    var phi_4408_: f64;
    var phi_4440_: bool;
    var phi_4441_: bool;
    var phi_4464_: f64;
    var phi_4465_: bool;
    var phi_4466_: f64;
    var phi_4467_: bool;
    var phi_4468_: f64;
    var phi_4469_: bool;
    var phi_4470_: bool;
    var phi_4475_: f64;
    var phi_4476_: bool;
    var phi_4480_: f64;
    var phi_4485_: f64;
    var phi_4490_: f64;
    var phi_4495_: f64;
    var phi_4509_: f64;
    var phi_4647_: type_16;
    var phi_4650_: f64;
    var phi_4671_: bool;
    var phi_4677_: type_17;
    var phi_4648_: type_16;
    var phi_4691_: type_17;
    var phi_4651_: f64;
    var local_42: f64;
    var phi_4640_: f64;
    var phi_4704_: f64;
    var phi_4722_: f64;
    var phi_4729_: f64;
    var phi_4734_: f64;
    var phi_4741_: f64;
    var phi_4746_: f64;
    var phi_4759_: f64;
    var phi_4766_: f64;
    var phi_4771_: f64;
    var phi_4778_: f64;
    var phi_4783_: f64;
    var phi_4788_: f64;
    var phi_4805_: f64;
    var phi_4812_: f64;
    var phi_4817_: f64;
    var phi_4824_: f64;
    var phi_4829_: f64;
    var phi_4843_: f64;
    var phi_4850_: f64;
    var phi_4855_: f64;
    var phi_4862_: f64;
    var phi_4867_: f64;
    var phi_4872_: f64;
    var phi_4889_: f64;
    var phi_4896_: f64;
    var phi_4901_: f64;
    var phi_4908_: f64;
    var phi_4913_: f64;
    var phi_4927_: f64;
    var phi_4934_: f64;
    var phi_4939_: f64;
    var phi_4946_: f64;
    var phi_4951_: f64;
    var phi_4956_: f64;
    var phi_4980_: bool;
    var phi_4981_: bool;
    var phi_4982_: bool;
    var phi_4999_: f64;
    var phi_5000_: bool;
    var phi_5001_: f64;
    var phi_5002_: bool;
    var phi_5007_: f64;
    var phi_5009_: f64;
    var phi_5010_: f64;
    var phi_5011_: bool;
    var phi_5012_: f64;
    var phi_5013_: f64;
    var phi_5014_: bool;
    var phi_5015_: bool;
    var phi_5016_: f64;
    var phi_5017_: f64;
    var phi_5018_: f64;
    var phi_5019_: f64;
    var phi_5020_: bool;
    var phi_5021_: bool;
    var phi_5022_: bool;
    var phi_5023_: bool;
    var phi_5024_: f64;
    var phi_5025_: f64;
    var phi_5026_: f64;
    var phi_5027_: f64;
    var phi_5028_: bool;
    var phi_5029_: bool;
    var phi_5030_: bool;
    var phi_5031_: bool;
    var phi_5032_: bool;
    var phi_5033_: f64;
    var phi_5034_: f64;
    var phi_5035_: f64;
    var phi_5036_: f64;
    var phi_5037_: bool;
    var phi_5038_: bool;
    var phi_5039_: bool;
    var phi_5040_: bool;
    var phi_5041_: bool;
    var phi_5127_: f64;
    var phi_5200_: f64;
    var phi_5205_: f64;
    var phi_5278_: f64;
    var phi_5351_: f64;
    var phi_5356_: f64;
    var phi_5377_: f64;
    var phi_5378_: f64;
    var phi_5379_: f64;
    var phi_5054_: bool;
    var phi_5381_: u32;
    var phi_5382_: f64;
    var phi_5383_: bool;
    var phi_5384_: bool;
    var phi_5385_: bool;
    var phi_5386_: u32;
    var phi_5387_: f64;
    var phi_5388_: f64;
    var phi_5389_: f64;
    var phi_5390_: f64;
    var phi_5391_: bool;
    var phi_5392_: u32;
    var phi_5393_: bool;
    var phi_5394_: bool;
    var phi_5395_: bool;
    var phi_5396_: bool;
    var phi_5397_: bool;
    var phi_5398_: bool;
    var phi_5407_: f64;
    var phi_5412_: f64;
    var phi_5421_: bool;
    var phi_5425_: bool;
    var phi_5426_: f64;
    var phi_5427_: f64;
    var phi_5428_: f64;
    var phi_5429_: f64;
    var phi_5430_: bool;
    var phi_5431_: u32;
    var phi_5432_: bool;
    var phi_5433_: bool;
    var phi_5434_: bool;
    var phi_5435_: bool;
    var phi_5436_: bool;
    var phi_5437_: bool;
    var phi_3216_: f64;
    var phi_3218_: f64;
    var phi_3220_: f64;
    var phi_3222_: f64;
    var phi_3224_: bool;
    var phi_3226_: u32;
    var phi_5438_: f64;
    var phi_5439_: f64;
    var phi_5440_: bool;
    var phi_5441_: bool;
    var phi_5442_: bool;
    var phi_5443_: bool;
    var phi_5444_: bool;
    var phi_5445_: bool;
    var phi_5446_: bool;
    var local_43: bool;
    var phi_5450_: bool;
    var phi_5451_: bool;
    var phi_5452_: bool;
    var phi_5453_: bool;
    var phi_5454_: bool;
    var local_44: f64;
    var phi_5459_: type_46;
    var phi_5460_: bool;
    var phi_5461_: bool;
    var phi_5462_: bool;
    var phi_5463_: bool;
    var phi_5464_: bool;
    var phi_5469_: type_46;
    var phi_5470_: bool;
    var phi_5471_: bool;
    var phi_5472_: bool;
    var phi_5473_: bool;
    var phi_5474_: bool;
    var phi_5478_: f64;
    var phi_5479_: bool;
    var phi_5480_: bool;
    var phi_5481_: bool;
    var phi_5482_: bool;
    var phi_5486_: f64;
    var phi_5487_: bool;
    var phi_5488_: bool;
    var phi_5489_: bool;
    var phi_5494_: type_46;
    var phi_5495_: bool;
    var phi_5496_: bool;
    var phi_5501_: type_46;
    var phi_5502_: bool;
    var phi_5506_: type_46;
    var phi_5513_: f64;
    var phi_5514_: bool;
    var phi_5627_: f64;
    var phi_5634_: f64;
    var phi_5642_: f64;
    var phi_5793_: f64;
    var phi_5800_: f64;
    var phi_5805_: f64;
    var phi_5812_: f64;
    var phi_5817_: f64;
    var phi_5830_: f64;
    var phi_5837_: f64;
    var phi_5842_: f64;
    var phi_5849_: f64;
    var phi_5854_: f64;
    var phi_5859_: f64;
    var phi_5876_: f64;
    var phi_5883_: f64;
    var phi_5888_: f64;
    var phi_5895_: f64;
    var phi_5900_: f64;
    var phi_5914_: f64;
    var phi_5921_: f64;
    var phi_5926_: f64;
    var phi_5933_: f64;
    var phi_5938_: f64;
    var phi_5943_: f64;
    var phi_5960_: f64;
    var phi_5967_: f64;
    var phi_5972_: f64;
    var phi_5979_: f64;
    var phi_5984_: f64;
    var phi_5998_: f64;
    var phi_6005_: f64;
    var phi_6010_: f64;
    var phi_6017_: f64;
    var phi_6022_: f64;
    var phi_6027_: f64;
    var phi_6139_: type_16;
    var phi_6142_: f64;
    var phi_6163_: bool;
    var phi_6169_: type_17;
    var phi_6140_: type_16;
    var phi_6183_: type_17;
    var phi_6143_: f64;
    var local_45: f64;
    var phi_6132_: f64;
    var phi_6196_: f64;
    var phi_6333_: f64;
    var phi_6339_: f64;
    var phi_6348_: f64;
    var phi_6354_: f64;
    var phi_6363_: f64;
    var phi_6369_: f64;
    var phi_6378_: f64;
    var phi_6384_: f64;
    var phi_6434_: type_16;
    var phi_6437_: f64;
    var phi_6458_: bool;
    var phi_6464_: type_17;
    var phi_6435_: type_16;
    var phi_6478_: type_17;
    var phi_6438_: f64;
    var local_46: f64;
    var phi_6427_: f64;
    var phi_6491_: f64;
    var phi_6523_: type_16;
    var phi_6526_: f64;
    var phi_6547_: bool;
    var phi_6553_: type_17;
    var phi_6524_: type_16;
    var phi_6567_: type_17;
    var phi_6527_: f64;
    var local_47: f64;
    var phi_6516_: f64;
    var phi_6580_: f64;
    var phi_6598_: f64;
    var phi_6605_: f64;
    var phi_6610_: f64;
    var phi_6617_: f64;
    var phi_6622_: f64;
    var phi_6635_: f64;
    var phi_6642_: f64;
    var phi_6647_: f64;
    var phi_6654_: f64;
    var phi_6659_: f64;
    var phi_6664_: f64;
    var phi_6681_: f64;
    var phi_6688_: f64;
    var phi_6693_: f64;
    var phi_6700_: f64;
    var phi_6705_: f64;
    var phi_6719_: f64;
    var phi_6726_: f64;
    var phi_6731_: f64;
    var phi_6738_: f64;
    var phi_6743_: f64;
    var phi_6748_: f64;
    var phi_6765_: f64;
    var phi_6772_: f64;
    var phi_6777_: f64;
    var phi_6784_: f64;
    var phi_6789_: f64;
    var phi_6803_: f64;
    var phi_6810_: f64;
    var phi_6815_: f64;
    var phi_6822_: f64;
    var phi_6827_: f64;
    var phi_6832_: f64;
    var phi_6880_: f64;
    var phi_6886_: f64;
    var phi_6898_: type_12;
    var phi_6901_: f64;
    var phi_6899_: type_12;
    var phi_6924_: type_12;
    var phi_6954_: f64;
    var phi_6960_: f64;
    var phi_6974_: f64;
    var phi_6902_: f64;
    var local_48: f64;
    var local_49: f64;
    var phi_7003_: type_16;
    var phi_7006_: f64;
    var phi_7027_: bool;
    var phi_7033_: type_17;
    var phi_7004_: type_16;
    var phi_7047_: type_17;
    var phi_7007_: f64;
    var local_50: f64;
    var phi_6996_: f64;
    var phi_7060_: f64;
    var phi_7067_: type_12;
    var phi_7070_: f64;
    var phi_7072_: bool;
    var phi_7074_: bool;
    var phi_7068_: type_12;
    var phi_7097_: type_12;
    var phi_7134_: f64;
    var phi_7141_: f64;
    var phi_7149_: f64;
    var phi_7157_: f64;
    var phi_7164_: f64;
    var phi_7172_: f64;
    var phi_7178_: f64;
    var phi_7198_: f64;
    var phi_7204_: f64;
    var phi_7211_: f64;
    var phi_7240_: f64;
    var phi_7246_: f64;
    var phi_7283_: bool;
    var phi_7290_: bool;
    var phi_7303_: f64;
    var phi_7309_: f64;
    var phi_7310_: f64;
    var phi_7311_: f64;
    var phi_7071_: f64;
    var phi_7073_: bool;
    var phi_7075_: bool;
    var local_51: f64;
    var phi_7317_: f64;
    var local_52: bool;
    var local_53: bool;
    var phi_7328_: type_48;
    var phi_7329_: type_48;
    var phi_7330_: bool;
    var local_54: bool;
    var phi_7348_: f64;
    var phi_7349_: f64;
    var phi_7352_: type_12;
    var phi_7355_: f64;
    var phi_7357_: f64;
    var phi_7353_: type_12;
    var phi_7380_: type_12;
    var phi_7466_: f64;
    var phi_7467_: f64;
    var phi_7468_: f64;
    var phi_7449_: f64;
    var phi_7469_: f64;
    var phi_7470_: f64;
    var phi_7356_: f64;
    var phi_7358_: f64;
    var local_55: f64;
    var local_56: f64;
    var local_57: f64;
    var phi_7633_: bool;
    var phi_7634_: bool;
    var phi_7635_: bool;
    var phi_7636_: bool;
    var phi_7637_: bool;
    var phi_7638_: bool;
    var phi_7642_: bool;
    var phi_7646_: bool;
    var phi_7647_: bool;
    var phi_7648_: bool;
    var phi_7653_: f64;
    var phi_7657_: type_48;
    var phi_7658_: type_48;
    var phi_7659_: bool;
    var phi_7660_: type_48;
    var phi_7661_: type_48;
    var phi_7662_: bool;
    var phi_7668_: type_48;
    var phi_7669_: type_48;
    var phi_7670_: bool;
    var phi_7674_: type_48;
    var phi_7675_: type_48;
    var phi_7676_: bool;
    var phi_7677_: bool;
    var phi_7678_: type_48;
    var phi_7679_: type_48;
    var phi_7680_: bool;
    var phi_7681_: bool;
    var phi_7687_: type_48;
    var phi_7688_: bool;
    var phi_7692_: type_48;
    var phi_7708_: f64;
    var phi_7709_: f64;
    var phi_7710_: bool;
    var phi_7711_: f64;
    var phi_7712_: f64;
    var phi_7713_: bool;
    var phi_7714_: bool;
    var phi_7715_: bool;
    var phi_7716_: f64;
    var phi_7717_: f64;
    var phi_7718_: bool;
    var phi_7719_: bool;
    var phi_7720_: bool;
    var phi_7721_: f64;
    var phi_7722_: u32;
    var phi_7723_: f64;
    var phi_7724_: type_48;
    var phi_7725_: u32;
    var phi_7726_: u32;
    var phi_7727_: bool;
    var phi_7728_: bool;
    var phi_7729_: bool;
    var phi_7730_: f64;
    var phi_7731_: u32;
    var phi_7732_: f64;
    var phi_7733_: type_48;
    var phi_7734_: u32;
    var phi_7735_: u32;
    var phi_7736_: bool;
    var phi_7737_: bool;
    var phi_7738_: bool;
    var phi_7739_: bool;
    var phi_7740_: bool;
    var phi_7741_: f64;
    var phi_2725_: f64;
    var phi_2727_: u32;
    var phi_2729_: f64;
    var phi_7742_: type_48;
    var phi_7743_: u32;
    var phi_7744_: f64;
    var phi_7745_: u32;
    var phi_7746_: bool;
    var phi_7747_: bool;
    var phi_7748_: bool;
    var phi_7749_: bool;
    var phi_7750_: bool;
    var phi_7751_: bool;
    var local_58: bool;
    var phi_7755_: bool;
    var phi_7756_: bool;
    var phi_7757_: bool;
    var phi_7758_: bool;
    var local_59: type_48;
    var local_60: type_48;
    var phi_7775_: u32;
    var local_61: type_48;
    var phi_7780_: type_47;
    var phi_7781_: type_47;
    var phi_7782_: bool;
    var phi_7783_: bool;
    var phi_7784_: bool;
    var phi_7785_: bool;
    var phi_7789_: u32;
    var phi_7790_: f64;
    var phi_7791_: bool;
    var phi_7792_: bool;
    var phi_7793_: bool;
    var phi_7794_: bool;
    var phi_7798_: f64;
    var phi_7799_: u32;
    var phi_7800_: bool;
    var phi_7801_: bool;
    var phi_7802_: bool;
    var phi_7816_: f64;
    var phi_7819_: type_12;
    var phi_7820_: type_12;
    var phi_7843_: type_12;
    var phi_7865_: f64;
    var phi_7995_: type_16;
    var phi_7998_: f64;
    var phi_8019_: bool;
    var phi_8025_: type_17;
    var phi_7996_: type_16;
    var phi_8039_: type_17;
    var phi_7999_: f64;
    var local_62: f64;
    var phi_7988_: f64;
    var phi_8052_: f64;
    var phi_8070_: f64;
    var phi_8077_: f64;
    var phi_8082_: f64;
    var phi_8089_: f64;
    var phi_8094_: f64;
    var phi_8107_: f64;
    var phi_8114_: f64;
    var phi_8119_: f64;
    var phi_8126_: f64;
    var phi_8131_: f64;
    var phi_8136_: f64;
    var phi_8153_: f64;
    var phi_8160_: f64;
    var phi_8165_: f64;
    var phi_8172_: f64;
    var phi_8177_: f64;
    var phi_8191_: f64;
    var phi_8198_: f64;
    var phi_8203_: f64;
    var phi_8210_: f64;
    var phi_8215_: f64;
    var phi_8220_: f64;
    var phi_8237_: f64;
    var phi_8244_: f64;
    var phi_8249_: f64;
    var phi_8256_: f64;
    var phi_8261_: f64;
    var phi_8275_: f64;
    var phi_8282_: f64;
    var phi_8287_: f64;
    var phi_8294_: f64;
    var phi_8299_: f64;
    var phi_8304_: f64;
    var phi_8328_: bool;
    var phi_8329_: bool;
    var phi_8330_: bool;
    var local_63: bool;
    var phi_8338_: u32;
    var phi_8342_: type_47;
    var phi_8343_: bool;
    var phi_8351_: u32;
    var phi_8355_: type_47;
    var phi_8356_: type_47;
    var phi_8357_: bool;
    var phi_8358_: bool;
    var phi_8365_: type_47;
    var phi_8366_: bool;
    var phi_8370_: type_47;
    var phi_8371_: type_47;
    var phi_8372_: bool;
    var phi_8376_: type_47;
    var phi_16043_: type_47;
    var phi_16058_: type_37;
    var phi_16082_: u32;
    var phi_16086_: type_22;
    var phi_16087_: bool;
    var phi_16106_: u32;
    var local_64: u32;
    var local_65: f64;
    var local_66: f64;
    var local_67: bool;
    var local_68: bool;
    var local_69: f64;
    var local_70: bool;
    var local_71: bool;
    var local_72: bool;
    var local_73: bool;
    var local_74: bool;
    var local_75: bool;
    var local_76: f64;
    var local_77: f64;
    var local_78: f64;
    var local_79: bool;
    var local_80: bool;
    var local_81: bool;
    var local_82: bool;
    var local_83: bool;
    var local_84: bool;
    var local_85: bool;
    var local_86: bool;
    var local_87: f64;
    var local_88: f64;
    var local_89: f64;
    var local_90: f64;
    var local_91: bool;
    var local_92: bool;
    var local_93: bool;
    var local_94: bool;
    var local_95: bool;
    var local_96: u32;
    var local_97: bool;
    var local_98: u32;
    var local_99: u32;
    var local_100: f64;
    var local_101: f64;
    var local_102: f64;
    var local_103: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e122 = id_2;
    let _e123 = n_2;
    let _e124 = lane_2;
    let _e136 = ((_e122.y * _e123.x) + _e122.x);
    let _e139 = (_e123.x * _e123.y);
    let _e142 = params.member.member_1.member_2;
    let _e144 = input.member[0u];
    if (_e142 < _e144) {
        phi_839_ = _e142;
    } else {
        phi_839_ = _e144;
    }
    let _e147 = phi_839_;
    let _e148 = (_e147 / 64u);
    if ((_e147 % 64u) > 0u) {
        phi_855_ = (_e148 + 1u);
    } else {
        phi_855_ = _e148;
    }
    let _e153 = phi_855_;
    if (_e153 > _e136) {
        let _e155 = (_e153 - _e136);
        if (_e139 == 0u) {
            return;
        }
        let _e157 = (_e155 / _e139);
        if (_e139 == 0u) {
            return;
        }
        if ((_e155 % _e139) > 0u) {
            phi_876_ = (_e157 + 1u);
        } else {
            phi_876_ = _e157;
        }
        let _e163 = phi_876_;
        phi_877_ = _e163;
    } else {
        phi_877_ = 0u;
    }
    let _e165 = phi_877_;
    phi_880_ = type_12(0u, _e165);
    loop {
        let _e168 = phi_880_;
        if (_e168.member < _e168.member_1) {
            phi_881_ = type_12((_e168.member + 1u), _e168.member_1);
            phi_904_ = type_12(1u, _e168.member);
        } else {
            phi_881_ = _e168;
            phi_904_ = type_12(0u, type_12().member_1);
        }
        let _e180 = phi_881_;
        let _e182 = phi_904_;
        let _e186 = (bitcast<i32>(_e182.member) != 0i);
        if _e186 {
            let _e190 = (((_e136 + (_e182.member_1 * _e139)) * 64u) + _e124);
            if (_e190 < _e147) {
                let _e192 = (2u * _e190);
                let _e195 = input.member[(4u + _e192)];
                let _e198 = input.member[(_e192 + 5u)];
                let _e201 = elements.member[_e198];
                let _e206 = params.member.member.member_1;
                if ((_e206 & 8u) != 0u) {
                    let _e245 = paths.member[_e195];
                    let _e247 = paths.member[_e201[0]];
                    let _e253 = paths.member[_e201[1]];
                    let _e255 = paths.member[_e201[2]];
                    let _e292 = function_(array<f32, 3>(_e245.member[0], _e245.member[1], _e245.member[2]));
                    let _e293 = function_(array<f32, 3>(_e247.member[0], _e247.member[1], _e247.member[2]));
                    let _e294 = function_(array<f32, 3>(_e253.member[0], _e253.member[1], _e253.member[2]));
                    let _e295 = function_(array<f32, 3>(_e255.member[0], _e255.member[1], _e255.member[2]));
                    let _e297 = function_(array<f32, 3>(_e245.member_1[0], _e245.member_1[1], _e245.member_1[2]));
                    let _e298 = function_(array<f32, 3>(_e247.member_1[0], _e247.member_1[1], _e247.member_1[2]));
                    let _e299 = function_(array<f32, 3>(_e253.member_1[0], _e253.member_1[1], _e253.member_1[2]));
                    let _e300 = function_(array<f32, 3>(_e255.member_1[0], _e255.member_1[1], _e255.member_1[2]));
                    phi_1151_ = type_33(array<array<f64, 3>, 4>(_e292, _e293, _e294, _e295), array<array<f64, 3>, 4>(_e297, _e298, _e299, _e300));
                } else {
                    let _e210 = positions.member[_e195];
                    let _e213 = params.member.member.member[0u];
                    let _e216 = positions.member[(_e213 + _e195)];
                    let _e218 = positions.member[_e201[0]];
                    let _e221 = params.member.member.member[0u];
                    let _e224 = positions.member[(_e221 + _e201[0])];
                    let _e226 = positions.member[_e201[1]];
                    let _e229 = params.member.member.member[0u];
                    let _e232 = positions.member[(_e229 + _e201[1])];
                    let _e234 = positions.member[_e201[2]];
                    let _e237 = params.member.member.member[0u];
                    let _e240 = positions.member[(_e237 + _e201[2])];
                    phi_1151_ = type_33(array<array<f64, 3>, 4>(_e210, _e218, _e226, _e234), array<array<f64, 3>, 4>(_e216, _e224, _e232, _e240));
                }
                let _e304 = phi_1151_;
                let _e311 = (_e304.member[0][0] - _e304.member[1][0]);
                let _e314 = (_e304.member[0][1] - _e304.member[1][1]);
                let _e317 = (_e304.member[0][2] - _e304.member[1][2]);
                let _e323 = (_e304.member_1[0][0] - _e304.member_1[1][0]);
                let _e326 = (_e304.member_1[0][1] - _e304.member_1[1][1]);
                let _e329 = (_e304.member_1[0][2] - _e304.member_1[1][2]);
                let _e336 = (_e304.member[2][0] - _e304.member[1][0]);
                let _e339 = (_e304.member[2][1] - _e304.member[1][1]);
                let _e342 = (_e304.member[2][2] - _e304.member[1][2]);
                let _e348 = (_e304.member_1[2][0] - _e304.member_1[1][0]);
                let _e351 = (_e304.member_1[2][1] - _e304.member_1[1][1]);
                let _e354 = (_e304.member_1[2][2] - _e304.member_1[1][2]);
                let _e361 = (_e304.member[3][0] - _e304.member[1][0]);
                let _e364 = (_e304.member[3][1] - _e304.member[1][1]);
                let _e367 = (_e304.member[3][2] - _e304.member[1][2]);
                let _e373 = (_e304.member_1[3][0] - _e304.member_1[1][0]);
                let _e376 = (_e304.member_1[3][1] - _e304.member_1[1][1]);
                let _e379 = (_e304.member_1[3][2] - _e304.member_1[1][2]);
                let _e382 = (0.0lf + 0.0lf);
                let _e385 = params.member.member.member_7;
                let _e392 = bitcast<f64>(((u64(_e385[1]) * 4294967296lu) + u64(_e385[0])));
                let _e394 = params.member.member.member_14;
                let _e401 = bitcast<f64>(((u64(_e394[1]) * 4294967296lu) + u64(_e394[0])));
                let _e403 = params.member.member.member_15;
                let _e410 = bitcast<f64>(((u64(_e403[1]) * 4294967296lu) + u64(_e403[0])));
                let _e412 = params.member.member.member_16;
                let _e419 = bitcast<f64>(((u64(_e412[1]) * 4294967296lu) + u64(_e412[0])));
                let _e421 = params.member.member.member_1;
                if (_e311 < 0.0lf) {
                    phi_1276_ = -(_e311);
                } else {
                    phi_1276_ = _e311;
                }
                let _e427 = phi_1276_;
                if (_e314 < 0.0lf) {
                    phi_1282_ = -(_e314);
                } else {
                    phi_1282_ = _e314;
                }
                let _e431 = phi_1282_;
                if (_e427 > _e431) {
                    phi_1287_ = _e427;
                } else {
                    phi_1287_ = _e431;
                }
                let _e434 = phi_1287_;
                if (_e317 < 0.0lf) {
                    phi_1293_ = -(_e317);
                } else {
                    phi_1293_ = _e317;
                }
                let _e438 = phi_1293_;
                if (_e434 > _e438) {
                    phi_1298_ = _e434;
                } else {
                    phi_1298_ = _e438;
                }
                let _e441 = phi_1298_;
                if (_e323 < 0.0lf) {
                    phi_1304_ = -(_e323);
                } else {
                    phi_1304_ = _e323;
                }
                let _e445 = phi_1304_;
                if (_e326 < 0.0lf) {
                    phi_1310_ = -(_e326);
                } else {
                    phi_1310_ = _e326;
                }
                let _e449 = phi_1310_;
                if (_e445 > _e449) {
                    phi_1315_ = _e445;
                } else {
                    phi_1315_ = _e449;
                }
                let _e452 = phi_1315_;
                if (_e329 < 0.0lf) {
                    phi_1321_ = -(_e329);
                } else {
                    phi_1321_ = _e329;
                }
                let _e456 = phi_1321_;
                if (_e452 > _e456) {
                    phi_1326_ = _e452;
                } else {
                    phi_1326_ = _e456;
                }
                let _e459 = phi_1326_;
                if (_e441 > _e459) {
                    phi_1331_ = _e441;
                } else {
                    phi_1331_ = _e459;
                }
                let _e462 = phi_1331_;
                let _e463 = (_e462 + _e382);
                if (_e336 < 0.0lf) {
                    phi_1338_ = -(_e336);
                } else {
                    phi_1338_ = _e336;
                }
                let _e467 = phi_1338_;
                if (_e339 < 0.0lf) {
                    phi_1344_ = -(_e339);
                } else {
                    phi_1344_ = _e339;
                }
                let _e471 = phi_1344_;
                if (_e467 > _e471) {
                    phi_1349_ = _e467;
                } else {
                    phi_1349_ = _e471;
                }
                let _e474 = phi_1349_;
                if (_e342 < 0.0lf) {
                    phi_1355_ = -(_e342);
                } else {
                    phi_1355_ = _e342;
                }
                let _e478 = phi_1355_;
                if (_e474 > _e478) {
                    phi_1360_ = _e474;
                } else {
                    phi_1360_ = _e478;
                }
                let _e481 = phi_1360_;
                if (_e348 < 0.0lf) {
                    phi_1366_ = -(_e348);
                } else {
                    phi_1366_ = _e348;
                }
                let _e485 = phi_1366_;
                if (_e351 < 0.0lf) {
                    phi_1372_ = -(_e351);
                } else {
                    phi_1372_ = _e351;
                }
                let _e489 = phi_1372_;
                if (_e485 > _e489) {
                    phi_1377_ = _e485;
                } else {
                    phi_1377_ = _e489;
                }
                let _e492 = phi_1377_;
                if (_e354 < 0.0lf) {
                    phi_1383_ = -(_e354);
                } else {
                    phi_1383_ = _e354;
                }
                let _e496 = phi_1383_;
                if (_e492 > _e496) {
                    phi_1388_ = _e492;
                } else {
                    phi_1388_ = _e496;
                }
                let _e499 = phi_1388_;
                if (_e481 > _e499) {
                    phi_1393_ = _e481;
                } else {
                    phi_1393_ = _e499;
                }
                let _e502 = phi_1393_;
                let _e503 = (_e502 + _e382);
                if (_e361 < 0.0lf) {
                    phi_1400_ = -(_e361);
                } else {
                    phi_1400_ = _e361;
                }
                let _e507 = phi_1400_;
                if (_e364 < 0.0lf) {
                    phi_1406_ = -(_e364);
                } else {
                    phi_1406_ = _e364;
                }
                let _e511 = phi_1406_;
                if (_e507 > _e511) {
                    phi_1411_ = _e507;
                } else {
                    phi_1411_ = _e511;
                }
                let _e514 = phi_1411_;
                if (_e367 < 0.0lf) {
                    phi_1417_ = -(_e367);
                } else {
                    phi_1417_ = _e367;
                }
                let _e518 = phi_1417_;
                if (_e514 > _e518) {
                    phi_1422_ = _e514;
                } else {
                    phi_1422_ = _e518;
                }
                let _e521 = phi_1422_;
                if (_e373 < 0.0lf) {
                    phi_1428_ = -(_e373);
                } else {
                    phi_1428_ = _e373;
                }
                let _e525 = phi_1428_;
                if (_e376 < 0.0lf) {
                    phi_1434_ = -(_e376);
                } else {
                    phi_1434_ = _e376;
                }
                let _e529 = phi_1434_;
                if (_e525 > _e529) {
                    phi_1439_ = _e525;
                } else {
                    phi_1439_ = _e529;
                }
                let _e532 = phi_1439_;
                if (_e379 < 0.0lf) {
                    phi_1445_ = -(_e379);
                } else {
                    phi_1445_ = _e379;
                }
                let _e536 = phi_1445_;
                if (_e532 > _e536) {
                    phi_1450_ = _e532;
                } else {
                    phi_1450_ = _e536;
                }
                let _e539 = phi_1450_;
                if (_e521 > _e539) {
                    phi_1455_ = _e521;
                } else {
                    phi_1455_ = _e539;
                }
                let _e542 = phi_1455_;
                let _e543 = (_e542 + _e382);
                if (_e463 > _e503) {
                    phi_1461_ = _e463;
                } else {
                    phi_1461_ = _e503;
                }
                let _e546 = phi_1461_;
                if (_e546 > _e543) {
                    phi_1466_ = _e546;
                } else {
                    phi_1466_ = _e543;
                }
                let _e549 = phi_1466_;
                if (_e549 <= f64(65536f)) {
                    phi_1475_ = (_e549 >= f64((1f / 65536f)));
                } else {
                    phi_1475_ = false;
                }
                let _e556 = phi_1475_;
                if _e556 {
                    phi_1547_ = type_45();
                    phi_1548_ = true;
                } else {
                    if (_e549 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e549) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e563 = (9214364837600034816lu - (bitcast<u64>(_e549) & 9218868437227405312lu));
                            if (_e563 > 4503599627370496lu) {
                                phi_1499_ = _e563;
                            } else {
                                phi_1499_ = 4503599627370496lu;
                            }
                            let _e566 = phi_1499_;
                            let _e567 = bitcast<f64>(_e566);
                            let _e568 = (_e392 * _e567);
                            if (_e392 > f64(0f)) {
                                if (_e568 > 2.2250738585072014e-308lf) {
                                    phi_1511_ = _e568;
                                } else {
                                    phi_1511_ = 2.2250738585072014e-308lf;
                                }
                                let _e573 = phi_1511_;
                                phi_1512_ = _e573;
                            } else {
                                phi_1512_ = _e568;
                            }
                            let _e575 = phi_1512_;
                            phi_1543_ = type_45(type_35(array<array<f64, 3>, 2>(array<f64, 3>((_e311 * _e567), (_e314 * _e567), (_e317 * _e567)), array<f64, 3>((_e323 * _e567), (_e326 * _e567), (_e329 * _e567))), array<array<f64, 3>, 2>(array<f64, 3>((_e336 * _e567), (_e339 * _e567), (_e342 * _e567)), array<f64, 3>((_e348 * _e567), (_e351 * _e567), (_e354 * _e567))), array<array<f64, 3>, 2>(array<f64, 3>((_e361 * _e567), (_e364 * _e567), (_e367 * _e567)), array<f64, 3>((_e373 * _e567), (_e376 * _e567), (_e379 * _e567))), (_e382 * _e567)), _e575);
                            phi_1544_ = false;
                        } else {
                            phi_1543_ = type_45();
                            phi_1544_ = true;
                        }
                        let _e607 = phi_1543_;
                        let _e609 = phi_1544_;
                        phi_1545_ = _e607;
                        phi_1546_ = _e609;
                    } else {
                        phi_1545_ = type_45();
                        phi_1546_ = true;
                    }
                    let _e611 = phi_1545_;
                    let _e613 = phi_1546_;
                    phi_1547_ = _e611;
                    phi_1548_ = _e613;
                }
                let _e615 = phi_1547_;
                let _e617 = phi_1548_;
                if _e617 {
                    phi_1553_ = type_45(type_35(array<array<f64, 3>, 2>(array<f64, 3>(_e311, _e314, _e317), array<f64, 3>(_e323, _e326, _e329)), array<array<f64, 3>, 2>(array<f64, 3>(_e336, _e339, _e342), array<f64, 3>(_e348, _e351, _e354)), array<array<f64, 3>, 2>(array<f64, 3>(_e361, _e364, _e367), array<f64, 3>(_e373, _e376, _e379)), _e382), _e392);
                } else {
                    phi_1553_ = _e615;
                }
                let _e620 = phi_1553_;
                local_18 = type_35(array<array<f64, 3>, 2>(array<f64, 3>(_e620.member.member[0][0], _e620.member.member[0][1], _e620.member.member[0][2]), array<f64, 3>(_e620.member.member[1][0], _e620.member.member[1][1], _e620.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e620.member.member_1[0][0], _e620.member.member_1[0][1], _e620.member.member_1[0][2]), array<f64, 3>(_e620.member.member_1[1][0], _e620.member.member_1[1][1], _e620.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e620.member.member_2[0][0], _e620.member.member_2[0][1], _e620.member.member_2[0][2]), array<f64, 3>(_e620.member.member_2[1][0], _e620.member.member_2[1][1], _e620.member.member_2[1][2])), _e620.member.member_3);
                if (_e620.member_1 > f64(0f)) {
                    let _e5853 = local_18.member[0u];
                    let _e5859 = local_18.member[1u];
                    let _e5875 = local_18.member_1[0u];
                    let _e5881 = local_18.member_1[1u];
                    let _e5897 = local_18.member_2[0u];
                    let _e5903 = local_18.member_2[1u];
                    let _e5917 = function_3(array<f64, 3>((_e5853[0] + ((_e5859[0] - _e5853[0]) * _e410)), (_e5853[1] + ((_e5859[1] - _e5853[1]) * _e410)), (_e5853[2] + ((_e5859[2] - _e5853[2]) * _e410))), array<f64, 3>((_e5875[0] + ((_e5881[0] - _e5875[0]) * _e410)), (_e5875[1] + ((_e5881[1] - _e5875[1]) * _e410)), (_e5875[2] + ((_e5881[2] - _e5875[2]) * _e410))), array<f64, 3>((_e5897[0] + ((_e5903[0] - _e5897[0]) * _e410)), (_e5897[1] + ((_e5903[1] - _e5897[1]) * _e410)), (_e5897[2] + ((_e5903[2] - _e5897[2]) * _e410))), 0u);
                    let _e5928 = (((_e5917[0] * _e5917[0]) + (_e5917[1] * _e5917[1])) + (_e5917[2] * _e5917[2]));
                    if (_e5928 <= 2.2250738585072014e-308lf) {
                        if (_e5928 > 0.0lf) {
                            phi_1721_ = (1.464336215552873e-154lf * 2.0lf);
                        } else {
                            phi_1721_ = 0.0lf;
                        }
                        let _e5980 = phi_1721_;
                        phi_1785_ = _e5980;
                    } else {
                        phi_1728_ = type_16(0i, 5i);
                        phi_1731_ = bitcast<f64>(((bitcast<u64>(_e5928) / 2lu) + 2303426169912950784lu));
                        loop {
                            let _e5935 = phi_1728_;
                            let _e5937 = phi_1731_;
                            local_40 = _e5937;
                            if (_e5935.member < _e5935.member_1) {
                                let _e5944 = (_e5935.member + 1i);
                                if ((false == (_e5944 > _e5935.member)) != false) {
                                    phi_1752_ = true;
                                } else {
                                    phi_1752_ = false;
                                }
                                let _e5949 = phi_1752_;
                                if _e5949 {
                                    phi_1758_ = type_17(0u, type_17().member_1);
                                } else {
                                    phi_1758_ = type_17(1u, _e5944);
                                }
                                let _e5954 = phi_1758_;
                                phi_1729_ = type_16(_e5954.member_1, _e5935.member_1);
                                phi_1772_ = type_17(1u, _e5935.member);
                            } else {
                                phi_1729_ = _e5935;
                                phi_1772_ = type_17(0u, type_17().member_1);
                            }
                            let _e5960 = phi_1729_;
                            let _e5962 = phi_1772_;
                            let _e5965 = (bitcast<i32>(_e5962.member) != 0i);
                            if _e5965 {
                                phi_1732_ = (0.5lf * (_e5937 + (_e5928 / _e5937)));
                            } else {
                                phi_1732_ = f64();
                            }
                            let _e5970 = phi_1732_;
                            continue;
                            continuing {
                                phi_1728_ = _e5960;
                                phi_1731_ = _e5970;
                                break if !(_e5965);
                            }
                        }
                        let _e5975 = local_40;
                        phi_1785_ = (_e5975 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                    }
                    let _e5982 = phi_1785_;
                    let _e5990 = local_18.member[0u];
                    if (_e5990[0] < 0.0lf) {
                        phi_1803_ = -(_e5990[0]);
                    } else {
                        phi_1803_ = _e5990[0];
                    }
                    let _e5997 = phi_1803_;
                    if (_e5990[1] < 0.0lf) {
                        phi_1810_ = -(_e5990[1]);
                    } else {
                        phi_1810_ = _e5990[1];
                    }
                    let _e6001 = phi_1810_;
                    if (_e5997 > _e6001) {
                        phi_1815_ = _e5997;
                    } else {
                        phi_1815_ = _e6001;
                    }
                    let _e6004 = phi_1815_;
                    if (_e5990[2] < 0.0lf) {
                        phi_1822_ = -(_e5990[2]);
                    } else {
                        phi_1822_ = _e5990[2];
                    }
                    let _e6008 = phi_1822_;
                    if (_e6004 > _e6008) {
                        phi_1827_ = _e6004;
                    } else {
                        phi_1827_ = _e6008;
                    }
                    let _e6011 = phi_1827_;
                    let _e6014 = local_18.member[1u];
                    if (_e6014[0] < 0.0lf) {
                        phi_1840_ = -(_e6014[0]);
                    } else {
                        phi_1840_ = _e6014[0];
                    }
                    let _e6021 = phi_1840_;
                    if (_e6014[1] < 0.0lf) {
                        phi_1847_ = -(_e6014[1]);
                    } else {
                        phi_1847_ = _e6014[1];
                    }
                    let _e6025 = phi_1847_;
                    if (_e6021 > _e6025) {
                        phi_1852_ = _e6021;
                    } else {
                        phi_1852_ = _e6025;
                    }
                    let _e6028 = phi_1852_;
                    if (_e6014[2] < 0.0lf) {
                        phi_1859_ = -(_e6014[2]);
                    } else {
                        phi_1859_ = _e6014[2];
                    }
                    let _e6032 = phi_1859_;
                    if (_e6028 > _e6032) {
                        phi_1864_ = _e6028;
                    } else {
                        phi_1864_ = _e6032;
                    }
                    let _e6035 = phi_1864_;
                    if (_e6011 > _e6035) {
                        phi_1869_ = _e6011;
                    } else {
                        phi_1869_ = _e6035;
                    }
                    let _e6038 = phi_1869_;
                    let _e6040 = local_18.member_3;
                    let _e6044 = local_18.member_1[0u];
                    if (_e6044[0] < 0.0lf) {
                        phi_1886_ = -(_e6044[0]);
                    } else {
                        phi_1886_ = _e6044[0];
                    }
                    let _e6051 = phi_1886_;
                    if (_e6044[1] < 0.0lf) {
                        phi_1893_ = -(_e6044[1]);
                    } else {
                        phi_1893_ = _e6044[1];
                    }
                    let _e6055 = phi_1893_;
                    if (_e6051 > _e6055) {
                        phi_1898_ = _e6051;
                    } else {
                        phi_1898_ = _e6055;
                    }
                    let _e6058 = phi_1898_;
                    if (_e6044[2] < 0.0lf) {
                        phi_1905_ = -(_e6044[2]);
                    } else {
                        phi_1905_ = _e6044[2];
                    }
                    let _e6062 = phi_1905_;
                    if (_e6058 > _e6062) {
                        phi_1910_ = _e6058;
                    } else {
                        phi_1910_ = _e6062;
                    }
                    let _e6065 = phi_1910_;
                    let _e6068 = local_18.member_1[1u];
                    if (_e6068[0] < 0.0lf) {
                        phi_1924_ = -(_e6068[0]);
                    } else {
                        phi_1924_ = _e6068[0];
                    }
                    let _e6075 = phi_1924_;
                    if (_e6068[1] < 0.0lf) {
                        phi_1931_ = -(_e6068[1]);
                    } else {
                        phi_1931_ = _e6068[1];
                    }
                    let _e6079 = phi_1931_;
                    if (_e6075 > _e6079) {
                        phi_1936_ = _e6075;
                    } else {
                        phi_1936_ = _e6079;
                    }
                    let _e6082 = phi_1936_;
                    if (_e6068[2] < 0.0lf) {
                        phi_1943_ = -(_e6068[2]);
                    } else {
                        phi_1943_ = _e6068[2];
                    }
                    let _e6086 = phi_1943_;
                    if (_e6082 > _e6086) {
                        phi_1948_ = _e6082;
                    } else {
                        phi_1948_ = _e6086;
                    }
                    let _e6089 = phi_1948_;
                    if (_e6065 > _e6089) {
                        phi_1953_ = _e6065;
                    } else {
                        phi_1953_ = _e6089;
                    }
                    let _e6092 = phi_1953_;
                    let _e6094 = local_18.member_3;
                    let _e6098 = local_18.member_2[0u];
                    if (_e6098[0] < 0.0lf) {
                        phi_1970_ = -(_e6098[0]);
                    } else {
                        phi_1970_ = _e6098[0];
                    }
                    let _e6105 = phi_1970_;
                    if (_e6098[1] < 0.0lf) {
                        phi_1977_ = -(_e6098[1]);
                    } else {
                        phi_1977_ = _e6098[1];
                    }
                    let _e6109 = phi_1977_;
                    if (_e6105 > _e6109) {
                        phi_1982_ = _e6105;
                    } else {
                        phi_1982_ = _e6109;
                    }
                    let _e6112 = phi_1982_;
                    if (_e6098[2] < 0.0lf) {
                        phi_1989_ = -(_e6098[2]);
                    } else {
                        phi_1989_ = _e6098[2];
                    }
                    let _e6116 = phi_1989_;
                    if (_e6112 > _e6116) {
                        phi_1994_ = _e6112;
                    } else {
                        phi_1994_ = _e6116;
                    }
                    let _e6119 = phi_1994_;
                    let _e6122 = local_18.member_2[1u];
                    if (_e6122[0] < 0.0lf) {
                        phi_2008_ = -(_e6122[0]);
                    } else {
                        phi_2008_ = _e6122[0];
                    }
                    let _e6129 = phi_2008_;
                    if (_e6122[1] < 0.0lf) {
                        phi_2015_ = -(_e6122[1]);
                    } else {
                        phi_2015_ = _e6122[1];
                    }
                    let _e6133 = phi_2015_;
                    if (_e6129 > _e6133) {
                        phi_2020_ = _e6129;
                    } else {
                        phi_2020_ = _e6133;
                    }
                    let _e6136 = phi_2020_;
                    if (_e6122[2] < 0.0lf) {
                        phi_2027_ = -(_e6122[2]);
                    } else {
                        phi_2027_ = _e6122[2];
                    }
                    let _e6140 = phi_2027_;
                    if (_e6136 > _e6140) {
                        phi_2032_ = _e6136;
                    } else {
                        phi_2032_ = _e6140;
                    }
                    let _e6143 = phi_2032_;
                    if (_e6119 > _e6143) {
                        phi_2037_ = _e6119;
                    } else {
                        phi_2037_ = _e6143;
                    }
                    let _e6146 = phi_2037_;
                    let _e6148 = local_18.member_3;
                    let _e6156 = local_18.member_3;
                    let _e6166 = (((_e5982 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e6038 + _e6040) + (_e6092 + _e6094)) + (_e6146 + _e6148)) * (1.1102230246251565e-16lf * f64(16f))) + (_e6156 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e620.member_1);
                    if _e6166 {
                        phi_2714_ = type_47();
                        phi_2715_ = true;
                    } else {
                        let _e6169 = local_18.member_1[0u];
                        let _e6175 = local_18.member_2[0u];
                        let _e6181 = ((_e6169[1] * _e6175[2]) - (_e6169[2] * _e6175[1]));
                        let _e6184 = ((_e6169[2] * _e6175[0]) - (_e6169[0] * _e6175[2]));
                        let _e6187 = ((_e6169[0] * _e6175[1]) - (_e6169[1] * _e6175[0]));
                        let _e6190 = local_18.member_1[1u];
                        let _e6196 = local_18.member_2[1u];
                        let _e6202 = ((_e6190[1] * _e6196[2]) - (_e6190[2] * _e6196[1]));
                        let _e6205 = ((_e6190[2] * _e6196[0]) - (_e6190[0] * _e6196[2]));
                        let _e6208 = ((_e6190[0] * _e6196[1]) - (_e6190[1] * _e6196[0]));
                        let _e6211 = local_18.member_1[0u];
                        let _e6217 = local_18.member_2[1u];
                        let _e6232 = local_18.member_1[1u];
                        let _e6238 = local_18.member_2[0u];
                        let _e6251 = (((_e6211[1] * _e6217[2]) - (_e6211[2] * _e6217[1])) + ((_e6232[1] * _e6238[2]) - (_e6232[2] * _e6238[1])));
                        let _e6252 = (((_e6211[2] * _e6217[0]) - (_e6211[0] * _e6217[2])) + ((_e6232[2] * _e6238[0]) - (_e6232[0] * _e6238[2])));
                        let _e6253 = (((_e6211[0] * _e6217[1]) - (_e6211[1] * _e6217[0])) + ((_e6232[0] * _e6238[1]) - (_e6232[1] * _e6238[0])));
                        let _e6256 = local_18.member[0u];
                        let _e6267 = local_18.member[1u];
                        let _e6278 = local_18.member[0u];
                        let _e6287 = ((((_e6267[0] * _e6181) + (_e6267[1] * _e6184)) + (_e6267[2] * _e6187)) + (((_e6278[0] * _e6251) + (_e6278[1] * _e6252)) + (_e6278[2] * _e6253)));
                        let _e6290 = local_18.member[0u];
                        let _e6301 = local_18.member[1u];
                        let _e6310 = ((((_e6290[0] * _e6202) + (_e6290[1] * _e6205)) + (_e6290[2] * _e6208)) + (((_e6301[0] * _e6251) + (_e6301[1] * _e6252)) + (_e6301[2] * _e6253)));
                        let _e6313 = local_18.member[1u];
                        let _e6324 = local_18.member[0u];
                        if (_e6324[0] < 0.0lf) {
                            phi_2302_ = -(_e6324[0]);
                        } else {
                            phi_2302_ = _e6324[0];
                        }
                        let _e6331 = phi_2302_;
                        if (_e6324[1] < 0.0lf) {
                            phi_2309_ = -(_e6324[1]);
                        } else {
                            phi_2309_ = _e6324[1];
                        }
                        let _e6335 = phi_2309_;
                        if (_e6331 > _e6335) {
                            phi_2314_ = _e6331;
                        } else {
                            phi_2314_ = _e6335;
                        }
                        let _e6338 = phi_2314_;
                        if (_e6324[2] < 0.0lf) {
                            phi_2321_ = -(_e6324[2]);
                        } else {
                            phi_2321_ = _e6324[2];
                        }
                        let _e6342 = phi_2321_;
                        if (_e6338 > _e6342) {
                            phi_2326_ = _e6338;
                        } else {
                            phi_2326_ = _e6342;
                        }
                        let _e6345 = phi_2326_;
                        let _e6348 = local_18.member[1u];
                        if (_e6348[0] < 0.0lf) {
                            phi_2339_ = -(_e6348[0]);
                        } else {
                            phi_2339_ = _e6348[0];
                        }
                        let _e6355 = phi_2339_;
                        if (_e6348[1] < 0.0lf) {
                            phi_2346_ = -(_e6348[1]);
                        } else {
                            phi_2346_ = _e6348[1];
                        }
                        let _e6359 = phi_2346_;
                        if (_e6355 > _e6359) {
                            phi_2351_ = _e6355;
                        } else {
                            phi_2351_ = _e6359;
                        }
                        let _e6362 = phi_2351_;
                        if (_e6348[2] < 0.0lf) {
                            phi_2358_ = -(_e6348[2]);
                        } else {
                            phi_2358_ = _e6348[2];
                        }
                        let _e6366 = phi_2358_;
                        if (_e6362 > _e6366) {
                            phi_2363_ = _e6362;
                        } else {
                            phi_2363_ = _e6366;
                        }
                        let _e6369 = phi_2363_;
                        if (_e6345 > _e6369) {
                            phi_2368_ = _e6345;
                        } else {
                            phi_2368_ = _e6369;
                        }
                        let _e6372 = phi_2368_;
                        let _e6374 = local_18.member_3;
                        let _e6375 = (_e6372 + _e6374);
                        let _e6378 = local_18.member_1[0u];
                        if (_e6378[0] < 0.0lf) {
                            phi_2385_ = -(_e6378[0]);
                        } else {
                            phi_2385_ = _e6378[0];
                        }
                        let _e6385 = phi_2385_;
                        if (_e6378[1] < 0.0lf) {
                            phi_2392_ = -(_e6378[1]);
                        } else {
                            phi_2392_ = _e6378[1];
                        }
                        let _e6389 = phi_2392_;
                        if (_e6385 > _e6389) {
                            phi_2397_ = _e6385;
                        } else {
                            phi_2397_ = _e6389;
                        }
                        let _e6392 = phi_2397_;
                        if (_e6378[2] < 0.0lf) {
                            phi_2404_ = -(_e6378[2]);
                        } else {
                            phi_2404_ = _e6378[2];
                        }
                        let _e6396 = phi_2404_;
                        if (_e6392 > _e6396) {
                            phi_2409_ = _e6392;
                        } else {
                            phi_2409_ = _e6396;
                        }
                        let _e6399 = phi_2409_;
                        let _e6402 = local_18.member_1[1u];
                        if (_e6402[0] < 0.0lf) {
                            phi_2423_ = -(_e6402[0]);
                        } else {
                            phi_2423_ = _e6402[0];
                        }
                        let _e6409 = phi_2423_;
                        if (_e6402[1] < 0.0lf) {
                            phi_2430_ = -(_e6402[1]);
                        } else {
                            phi_2430_ = _e6402[1];
                        }
                        let _e6413 = phi_2430_;
                        if (_e6409 > _e6413) {
                            phi_2435_ = _e6409;
                        } else {
                            phi_2435_ = _e6413;
                        }
                        let _e6416 = phi_2435_;
                        if (_e6402[2] < 0.0lf) {
                            phi_2442_ = -(_e6402[2]);
                        } else {
                            phi_2442_ = _e6402[2];
                        }
                        let _e6420 = phi_2442_;
                        if (_e6416 > _e6420) {
                            phi_2447_ = _e6416;
                        } else {
                            phi_2447_ = _e6420;
                        }
                        let _e6423 = phi_2447_;
                        if (_e6399 > _e6423) {
                            phi_2452_ = _e6399;
                        } else {
                            phi_2452_ = _e6423;
                        }
                        let _e6426 = phi_2452_;
                        let _e6428 = local_18.member_3;
                        let _e6429 = (_e6426 + _e6428);
                        let _e6432 = local_18.member_2[0u];
                        if (_e6432[0] < 0.0lf) {
                            phi_2469_ = -(_e6432[0]);
                        } else {
                            phi_2469_ = _e6432[0];
                        }
                        let _e6439 = phi_2469_;
                        if (_e6432[1] < 0.0lf) {
                            phi_2476_ = -(_e6432[1]);
                        } else {
                            phi_2476_ = _e6432[1];
                        }
                        let _e6443 = phi_2476_;
                        if (_e6439 > _e6443) {
                            phi_2481_ = _e6439;
                        } else {
                            phi_2481_ = _e6443;
                        }
                        let _e6446 = phi_2481_;
                        if (_e6432[2] < 0.0lf) {
                            phi_2488_ = -(_e6432[2]);
                        } else {
                            phi_2488_ = _e6432[2];
                        }
                        let _e6450 = phi_2488_;
                        if (_e6446 > _e6450) {
                            phi_2493_ = _e6446;
                        } else {
                            phi_2493_ = _e6450;
                        }
                        let _e6453 = phi_2493_;
                        let _e6456 = local_18.member_2[1u];
                        if (_e6456[0] < 0.0lf) {
                            phi_2507_ = -(_e6456[0]);
                        } else {
                            phi_2507_ = _e6456[0];
                        }
                        let _e6463 = phi_2507_;
                        if (_e6456[1] < 0.0lf) {
                            phi_2514_ = -(_e6456[1]);
                        } else {
                            phi_2514_ = _e6456[1];
                        }
                        let _e6467 = phi_2514_;
                        if (_e6463 > _e6467) {
                            phi_2519_ = _e6463;
                        } else {
                            phi_2519_ = _e6467;
                        }
                        let _e6470 = phi_2519_;
                        if (_e6456[2] < 0.0lf) {
                            phi_2526_ = -(_e6456[2]);
                        } else {
                            phi_2526_ = _e6456[2];
                        }
                        let _e6474 = phi_2526_;
                        if (_e6470 > _e6474) {
                            phi_2531_ = _e6470;
                        } else {
                            phi_2531_ = _e6474;
                        }
                        let _e6477 = phi_2531_;
                        if (_e6453 > _e6477) {
                            phi_2536_ = _e6453;
                        } else {
                            phi_2536_ = _e6477;
                        }
                        let _e6480 = phi_2536_;
                        let _e6482 = local_18.member_3;
                        let _e6483 = (_e6480 + _e6482);
                        let _e6484 = f64(1f);
                        let _e6485 = f64(8f);
                        let _e6487 = ((_e6429 * _e6485) * _e6483);
                        let _e6495 = local_18.member_3;
                        if (_e6181 < 0.0lf) {
                            phi_2573_ = -(_e6181);
                        } else {
                            phi_2573_ = _e6181;
                        }
                        let _e6515 = phi_2573_;
                        if (_e6184 < 0.0lf) {
                            phi_2579_ = -(_e6184);
                        } else {
                            phi_2579_ = _e6184;
                        }
                        let _e6519 = phi_2579_;
                        if (_e6187 < 0.0lf) {
                            phi_2586_ = -(_e6187);
                        } else {
                            phi_2586_ = _e6187;
                        }
                        let _e6524 = phi_2586_;
                        let _e6525 = ((_e6515 + _e6519) + _e6524);
                        if (_e6202 < 0.0lf) {
                            phi_2593_ = -(_e6202);
                        } else {
                            phi_2593_ = _e6202;
                        }
                        let _e6529 = phi_2593_;
                        if (_e6205 < 0.0lf) {
                            phi_2599_ = -(_e6205);
                        } else {
                            phi_2599_ = _e6205;
                        }
                        let _e6533 = phi_2599_;
                        if (_e6208 < 0.0lf) {
                            phi_2606_ = -(_e6208);
                        } else {
                            phi_2606_ = _e6208;
                        }
                        let _e6538 = phi_2606_;
                        let _e6539 = ((_e6529 + _e6533) + _e6538);
                        if (_e6525 > _e6539) {
                            phi_2612_ = _e6525;
                        } else {
                            phi_2612_ = _e6539;
                        }
                        let _e6542 = phi_2612_;
                        if (_e6251 < 0.0lf) {
                            phi_2618_ = -(_e6251);
                        } else {
                            phi_2618_ = _e6251;
                        }
                        let _e6546 = phi_2618_;
                        if (_e6252 < 0.0lf) {
                            phi_2624_ = -(_e6252);
                        } else {
                            phi_2624_ = _e6252;
                        }
                        let _e6550 = phi_2624_;
                        if (_e6253 < 0.0lf) {
                            phi_2631_ = -(_e6253);
                        } else {
                            phi_2631_ = _e6253;
                        }
                        let _e6555 = phi_2631_;
                        let _e6557 = (((_e6546 + _e6550) + _e6555) * f64(0.5f));
                        if (_e6542 > _e6557) {
                            phi_2638_ = _e6542;
                        } else {
                            phi_2638_ = _e6557;
                        }
                        let _e6560 = phi_2638_;
                        let _e6566 = local_18.member_3;
                        let _e6581 = f64(3f);
                        let _e6582 = ((((_e6256[0] * _e6181) + (_e6256[1] * _e6184)) + (_e6256[2] * _e6187)) * _e6581);
                        let _e6583 = ((((_e6313[0] * _e6202) + (_e6313[1] * _e6205)) + (_e6313[2] * _e6208)) * _e6581);
                        if (_e6582 < _e6583) {
                            phi_2666_ = _e6582;
                        } else {
                            phi_2666_ = _e6583;
                        }
                        let _e6586 = phi_2666_;
                        if (_e6287 < _e6310) {
                            phi_2671_ = _e6287;
                        } else {
                            phi_2671_ = _e6310;
                        }
                        let _e6589 = phi_2671_;
                        if (_e6586 < _e6589) {
                            phi_2676_ = _e6586;
                        } else {
                            phi_2676_ = _e6589;
                        }
                        let _e6592 = phi_2676_;
                        if (_e6582 > _e6583) {
                            phi_2681_ = _e6582;
                        } else {
                            phi_2681_ = _e6583;
                        }
                        let _e6595 = phi_2681_;
                        if (_e6287 > _e6310) {
                            phi_2686_ = _e6287;
                        } else {
                            phi_2686_ = _e6310;
                        }
                        let _e6598 = phi_2686_;
                        if (_e6595 > _e6598) {
                            phi_2691_ = _e6595;
                        } else {
                            phi_2691_ = _e6598;
                        }
                        let _e6601 = phi_2691_;
                        let _e6607 = -(_e6601);
                        if (_e6592 > _e6607) {
                            phi_2702_ = _e6592;
                        } else {
                            phi_2702_ = _e6607;
                        }
                        let _e6610 = phi_2702_;
                        if ((_e6610 - ((((((_e6375 * _e6485) * _e6487) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e6495 * f64(19f)) * ((_e6375 * (_e6429 + _e6483)) + (_e6429 * _e6483)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e6484 + _e6375) * ((_e6484 + _e6429) * (_e6484 + _e6483))))) + ((_e620.member_1 * (((_e6560 + (_e6487 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e6566 * f64(6f)) * (_e6429 + _e6483))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e6484 + _e6429) * (_e6484 + _e6483))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                            phi_2712_ = type_47(type_46(0u, f64()), 0u);
                            phi_2713_ = false;
                        } else {
                            phi_2712_ = type_47();
                            phi_2713_ = true;
                        }
                        let _e6617 = phi_2712_;
                        let _e6619 = phi_2713_;
                        phi_2714_ = _e6617;
                        phi_2715_ = _e6619;
                    }
                    let _e6621 = phi_2714_;
                    let _e6623 = phi_2715_;
                    if _e6623 {
                        phi_2721_ = type_16(0i, 2i);
                        phi_2724_ = _e410;
                        phi_2726_ = 0u;
                        phi_2728_ = _e410;
                        loop {
                            let _e6625 = phi_2721_;
                            let _e6627 = phi_2724_;
                            let _e6629 = phi_2726_;
                            let _e6631 = phi_2728_;
                            local_99 = _e6629;
                            local_102 = _e6627;
                            local_103 = _e6629;
                            if (_e6625.member < _e6625.member_1) {
                                let _e6638 = (_e6625.member + 1i);
                                if ((false == (_e6638 > _e6625.member)) != false) {
                                    phi_2749_ = true;
                                } else {
                                    phi_2749_ = false;
                                }
                                let _e6643 = phi_2749_;
                                if _e6643 {
                                    phi_2755_ = type_17(0u, type_17().member_1);
                                } else {
                                    phi_2755_ = type_17(1u, _e6638);
                                }
                                let _e6648 = phi_2755_;
                                phi_2722_ = type_16(_e6648.member_1, _e6625.member_1);
                                phi_2769_ = type_17(1u, _e6625.member);
                            } else {
                                phi_2722_ = _e6625;
                                phi_2769_ = type_17(0u, type_17().member_1);
                            }
                            let _e6654 = phi_2722_;
                            let _e6656 = phi_2769_;
                            if (bitcast<i32>(_e6656.member) != 0i) {
                                if (_e6656.member_1 > 0i) {
                                    phi_2785_ = true;
                                } else {
                                    if _e6166 {
                                        phi_2784_ = false;
                                    } else {
                                        phi_2784_ = true;
                                    }
                                    let _e6663 = phi_2784_;
                                    phi_2785_ = _e6663;
                                }
                                let _e6665 = phi_2785_;
                                if _e6665 {
                                    let _e6668 = local_18.member[0u];
                                    let _e6674 = local_18.member_1[0u];
                                    let _e6680 = local_18.member_2[0u];
                                    let _e6692 = local_18.member[1u];
                                    let _e6698 = local_18.member_1[1u];
                                    let _e6704 = local_18.member_2[1u];
                                    let _e6716 = local_18.member[0u];
                                    if (_e6716[0] < 0.0lf) {
                                        phi_2931_ = -(_e6716[0]);
                                    } else {
                                        phi_2931_ = _e6716[0];
                                    }
                                    let _e6723 = phi_2931_;
                                    if (_e6716[1] < 0.0lf) {
                                        phi_2938_ = -(_e6716[1]);
                                    } else {
                                        phi_2938_ = _e6716[1];
                                    }
                                    let _e6727 = phi_2938_;
                                    if (_e6723 > _e6727) {
                                        phi_2943_ = _e6723;
                                    } else {
                                        phi_2943_ = _e6727;
                                    }
                                    let _e6730 = phi_2943_;
                                    if (_e6716[2] < 0.0lf) {
                                        phi_2950_ = -(_e6716[2]);
                                    } else {
                                        phi_2950_ = _e6716[2];
                                    }
                                    let _e6734 = phi_2950_;
                                    if (_e6730 > _e6734) {
                                        phi_2955_ = _e6730;
                                    } else {
                                        phi_2955_ = _e6734;
                                    }
                                    let _e6737 = phi_2955_;
                                    let _e6740 = local_18.member[1u];
                                    if (_e6740[0] < 0.0lf) {
                                        phi_2968_ = -(_e6740[0]);
                                    } else {
                                        phi_2968_ = _e6740[0];
                                    }
                                    let _e6747 = phi_2968_;
                                    if (_e6740[1] < 0.0lf) {
                                        phi_2975_ = -(_e6740[1]);
                                    } else {
                                        phi_2975_ = _e6740[1];
                                    }
                                    let _e6751 = phi_2975_;
                                    if (_e6747 > _e6751) {
                                        phi_2980_ = _e6747;
                                    } else {
                                        phi_2980_ = _e6751;
                                    }
                                    let _e6754 = phi_2980_;
                                    if (_e6740[2] < 0.0lf) {
                                        phi_2987_ = -(_e6740[2]);
                                    } else {
                                        phi_2987_ = _e6740[2];
                                    }
                                    let _e6758 = phi_2987_;
                                    if (_e6754 > _e6758) {
                                        phi_2992_ = _e6754;
                                    } else {
                                        phi_2992_ = _e6758;
                                    }
                                    let _e6761 = phi_2992_;
                                    if (_e6737 > _e6761) {
                                        phi_2997_ = _e6737;
                                    } else {
                                        phi_2997_ = _e6761;
                                    }
                                    let _e6764 = phi_2997_;
                                    let _e6766 = local_18.member_3;
                                    let _e6770 = local_18.member_1[0u];
                                    if (_e6770[0] < 0.0lf) {
                                        phi_3014_ = -(_e6770[0]);
                                    } else {
                                        phi_3014_ = _e6770[0];
                                    }
                                    let _e6777 = phi_3014_;
                                    if (_e6770[1] < 0.0lf) {
                                        phi_3021_ = -(_e6770[1]);
                                    } else {
                                        phi_3021_ = _e6770[1];
                                    }
                                    let _e6781 = phi_3021_;
                                    if (_e6777 > _e6781) {
                                        phi_3026_ = _e6777;
                                    } else {
                                        phi_3026_ = _e6781;
                                    }
                                    let _e6784 = phi_3026_;
                                    if (_e6770[2] < 0.0lf) {
                                        phi_3033_ = -(_e6770[2]);
                                    } else {
                                        phi_3033_ = _e6770[2];
                                    }
                                    let _e6788 = phi_3033_;
                                    if (_e6784 > _e6788) {
                                        phi_3038_ = _e6784;
                                    } else {
                                        phi_3038_ = _e6788;
                                    }
                                    let _e6791 = phi_3038_;
                                    let _e6794 = local_18.member_1[1u];
                                    if (_e6794[0] < 0.0lf) {
                                        phi_3052_ = -(_e6794[0]);
                                    } else {
                                        phi_3052_ = _e6794[0];
                                    }
                                    let _e6801 = phi_3052_;
                                    if (_e6794[1] < 0.0lf) {
                                        phi_3059_ = -(_e6794[1]);
                                    } else {
                                        phi_3059_ = _e6794[1];
                                    }
                                    let _e6805 = phi_3059_;
                                    if (_e6801 > _e6805) {
                                        phi_3064_ = _e6801;
                                    } else {
                                        phi_3064_ = _e6805;
                                    }
                                    let _e6808 = phi_3064_;
                                    if (_e6794[2] < 0.0lf) {
                                        phi_3071_ = -(_e6794[2]);
                                    } else {
                                        phi_3071_ = _e6794[2];
                                    }
                                    let _e6812 = phi_3071_;
                                    if (_e6808 > _e6812) {
                                        phi_3076_ = _e6808;
                                    } else {
                                        phi_3076_ = _e6812;
                                    }
                                    let _e6815 = phi_3076_;
                                    if (_e6791 > _e6815) {
                                        phi_3081_ = _e6791;
                                    } else {
                                        phi_3081_ = _e6815;
                                    }
                                    let _e6818 = phi_3081_;
                                    let _e6820 = local_18.member_3;
                                    let _e6824 = local_18.member_2[0u];
                                    if (_e6824[0] < 0.0lf) {
                                        phi_3098_ = -(_e6824[0]);
                                    } else {
                                        phi_3098_ = _e6824[0];
                                    }
                                    let _e6831 = phi_3098_;
                                    if (_e6824[1] < 0.0lf) {
                                        phi_3105_ = -(_e6824[1]);
                                    } else {
                                        phi_3105_ = _e6824[1];
                                    }
                                    let _e6835 = phi_3105_;
                                    if (_e6831 > _e6835) {
                                        phi_3110_ = _e6831;
                                    } else {
                                        phi_3110_ = _e6835;
                                    }
                                    let _e6838 = phi_3110_;
                                    if (_e6824[2] < 0.0lf) {
                                        phi_3117_ = -(_e6824[2]);
                                    } else {
                                        phi_3117_ = _e6824[2];
                                    }
                                    let _e6842 = phi_3117_;
                                    if (_e6838 > _e6842) {
                                        phi_3122_ = _e6838;
                                    } else {
                                        phi_3122_ = _e6842;
                                    }
                                    let _e6845 = phi_3122_;
                                    let _e6848 = local_18.member_2[1u];
                                    if (_e6848[0] < 0.0lf) {
                                        phi_3136_ = -(_e6848[0]);
                                    } else {
                                        phi_3136_ = _e6848[0];
                                    }
                                    let _e6855 = phi_3136_;
                                    if (_e6848[1] < 0.0lf) {
                                        phi_3143_ = -(_e6848[1]);
                                    } else {
                                        phi_3143_ = _e6848[1];
                                    }
                                    let _e6859 = phi_3143_;
                                    if (_e6855 > _e6859) {
                                        phi_3148_ = _e6855;
                                    } else {
                                        phi_3148_ = _e6859;
                                    }
                                    let _e6862 = phi_3148_;
                                    if (_e6848[2] < 0.0lf) {
                                        phi_3155_ = -(_e6848[2]);
                                    } else {
                                        phi_3155_ = _e6848[2];
                                    }
                                    let _e6866 = phi_3155_;
                                    if (_e6862 > _e6866) {
                                        phi_3160_ = _e6862;
                                    } else {
                                        phi_3160_ = _e6866;
                                    }
                                    let _e6869 = phi_3160_;
                                    if (_e6845 > _e6869) {
                                        phi_3165_ = _e6845;
                                    } else {
                                        phi_3165_ = _e6869;
                                    }
                                    let _e6872 = phi_3165_;
                                    let _e6874 = local_18.member_3;
                                    let _e6882 = local_18.member_3;
                                    let _e6890 = (_e401 * f64(0.00390625f));
                                    let _e6891 = f64(0f);
                                    let _e6892 = f64(1f);
                                    local_16 = type_38(array<f64, 4>(_e6891, _e6891, _e6891, _e6891), array<f64, 4>(_e6891, _e6891, _e6891, _e6891), array<f64, 4>(_e6892, _e6892, _e6892, _e6892));
                                    phi_3212_ = type_12(0u, 96u);
                                    phi_3215_ = _e6631;
                                    phi_3217_ = _e6631;
                                    phi_3219_ = (_e419 - _e6631);
                                    phi_3221_ = _e6631;
                                    phi_3223_ = false;
                                    phi_3225_ = 0u;
                                    loop {
                                        let _e6899 = phi_3212_;
                                        let _e6901 = phi_3215_;
                                        let _e6903 = phi_3217_;
                                        let _e6905 = phi_3219_;
                                        let _e6907 = phi_3221_;
                                        let _e6909 = phi_3223_;
                                        let _e6911 = phi_3225_;
                                        local_44 = _e6901;
                                        local_89 = _e6903;
                                        if (_e6899.member < _e6899.member_1) {
                                            phi_3213_ = type_12((_e6899.member + 1u), _e6899.member_1);
                                            phi_3248_ = type_12(1u, _e6899.member);
                                        } else {
                                            phi_3213_ = _e6899;
                                            phi_3248_ = type_12(0u, type_12().member_1);
                                        }
                                        let _e6923 = phi_3213_;
                                        let _e6925 = phi_3248_;
                                        if (bitcast<i32>(_e6925.member) != 0i) {
                                            let _e6931 = local_18.member[0u];
                                            let _e6937 = local_18.member[1u];
                                            let _e6953 = local_18.member_1[0u];
                                            let _e6959 = local_18.member_1[1u];
                                            let _e6975 = local_18.member_2[0u];
                                            let _e6981 = local_18.member_2[1u];
                                            let _e6995 = function_3(array<f64, 3>((_e6931[0] + ((_e6937[0] - _e6931[0]) * _e6901)), (_e6931[1] + ((_e6937[1] - _e6931[1]) * _e6901)), (_e6931[2] + ((_e6937[2] - _e6931[2]) * _e6901))), array<f64, 3>((_e6953[0] + ((_e6959[0] - _e6953[0]) * _e6901)), (_e6953[1] + ((_e6959[1] - _e6953[1]) * _e6901)), (_e6953[2] + ((_e6959[2] - _e6953[2]) * _e6901))), array<f64, 3>((_e6975[0] + ((_e6981[0] - _e6975[0]) * _e6901)), (_e6975[1] + ((_e6981[1] - _e6975[1]) * _e6901)), (_e6975[2] + ((_e6981[2] - _e6975[2]) * _e6901))), 0u);
                                            if (_e6911 == 0u) {
                                                phi_3377_ = _e6995;
                                            } else {
                                                let _e6997 = f64(0f);
                                                if (_e6911 == 1u) {
                                                    phi_3363_ = _e6995[0];
                                                } else {
                                                    phi_3363_ = _e6997;
                                                }
                                                let _e7001 = phi_3363_;
                                                if (_e6911 == 2u) {
                                                    phi_3369_ = _e6995[1];
                                                } else {
                                                    phi_3369_ = _e6997;
                                                }
                                                let _e7005 = phi_3369_;
                                                if (_e6911 == 3u) {
                                                    phi_3375_ = _e6995[2];
                                                } else {
                                                    phi_3375_ = _e6997;
                                                }
                                                let _e7009 = phi_3375_;
                                                phi_3377_ = array<f64, 3>(_e7001, _e7005, _e7009);
                                            }
                                            let _e7012 = phi_3377_;
                                            if (_e7012[0] < 0.0lf) {
                                                phi_3384_ = -(_e7012[0]);
                                            } else {
                                                phi_3384_ = _e7012[0];
                                            }
                                            let _e7017 = phi_3384_;
                                            if (_e7012[1] < 0.0lf) {
                                                phi_3391_ = -(_e7012[1]);
                                            } else {
                                                phi_3391_ = _e7012[1];
                                            }
                                            let _e7022 = phi_3391_;
                                            if (_e7012[2] < 0.0lf) {
                                                phi_3399_ = -(_e7012[2]);
                                            } else {
                                                phi_3399_ = _e7012[2];
                                            }
                                            let _e7028 = phi_3399_;
                                            let _e7029 = ((_e7017 + _e7022) + _e7028);
                                            if (_e7029 > f64(0f)) {
                                                if ((bitcast<u64>(_e7029) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                    let _e7036 = (f64(1f) / _e7029);
                                                    let _e7038 = (_e7012[0] * _e7036);
                                                    let _e7040 = (_e7012[1] * _e7036);
                                                    let _e7042 = (_e7012[2] * _e7036);
                                                    let _e7047 = (((_e7038 * _e7038) + (_e7040 * _e7040)) + (_e7042 * _e7042));
                                                    if (_e7047 <= 2.2250738585072014e-308lf) {
                                                        if (_e7047 > 0.0lf) {
                                                            phi_3438_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_3438_ = 0.0lf;
                                                        }
                                                        let _e7099 = phi_3438_;
                                                        phi_3502_ = _e7099;
                                                    } else {
                                                        phi_3445_ = type_16(0i, 5i);
                                                        phi_3448_ = bitcast<f64>(((bitcast<u64>(_e7047) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e7054 = phi_3445_;
                                                            let _e7056 = phi_3448_;
                                                            local_41 = _e7056;
                                                            if (_e7054.member < _e7054.member_1) {
                                                                let _e7063 = (_e7054.member + 1i);
                                                                if ((false == (_e7063 > _e7054.member)) != false) {
                                                                    phi_3469_ = true;
                                                                } else {
                                                                    phi_3469_ = false;
                                                                }
                                                                let _e7068 = phi_3469_;
                                                                if _e7068 {
                                                                    phi_3475_ = type_17(0u, type_17().member_1);
                                                                } else {
                                                                    phi_3475_ = type_17(1u, _e7063);
                                                                }
                                                                let _e7073 = phi_3475_;
                                                                phi_3446_ = type_16(_e7073.member_1, _e7054.member_1);
                                                                phi_3489_ = type_17(1u, _e7054.member);
                                                            } else {
                                                                phi_3446_ = _e7054;
                                                                phi_3489_ = type_17(0u, type_17().member_1);
                                                            }
                                                            let _e7079 = phi_3446_;
                                                            let _e7081 = phi_3489_;
                                                            let _e7084 = (bitcast<i32>(_e7081.member) != 0i);
                                                            if _e7084 {
                                                                phi_3449_ = (0.5lf * (_e7056 + (_e7047 / _e7056)));
                                                            } else {
                                                                phi_3449_ = f64();
                                                            }
                                                            let _e7089 = phi_3449_;
                                                            continue;
                                                            continuing {
                                                                phi_3445_ = _e7079;
                                                                phi_3448_ = _e7089;
                                                                break if !(_e7084);
                                                            }
                                                        }
                                                        let _e7094 = local_41;
                                                        phi_3502_ = (_e7094 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e7101 = phi_3502_;
                                                    let _e7103 = (1.1102230246251565e-16lf * f64(12f));
                                                    let _e7110 = ((((((((_e6764 + _e6766) + (_e6818 + _e6820)) + (_e6872 + _e6874)) * (1.1102230246251565e-16lf * f64(16f))) + (_e6882 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e620.member_1 * _e7101) * (f64(1f) + _e7103)));
                                                    let _e7115 = (((_e7038 * _e6668[0]) + (_e7040 * _e6668[1])) + (_e7042 * _e6668[2]));
                                                    let _e7120 = (((_e7038 * (_e6668[0] - _e6674[0])) + (_e7040 * (_e6668[1] - _e6674[1]))) + (_e7042 * (_e6668[2] - _e6674[2])));
                                                    let _e7125 = (((_e7038 * (_e6668[0] - _e6680[0])) + (_e7040 * (_e6668[1] - _e6680[1]))) + (_e7042 * (_e6668[2] - _e6680[2])));
                                                    let _e7130 = (((_e7038 * _e6668[0]) + (_e7040 * _e6668[1])) + (_e7042 * _e6668[2]));
                                                    let _e7136 = (((_e7038 * _e6692[0]) + (_e7040 * _e6692[1])) + (_e7042 * _e6692[2]));
                                                    let _e7141 = (((_e7038 * (_e6692[0] - _e6698[0])) + (_e7040 * (_e6692[1] - _e6698[1]))) + (_e7042 * (_e6692[2] - _e6698[2])));
                                                    let _e7146 = (((_e7038 * (_e6692[0] - _e6704[0])) + (_e7040 * (_e6692[1] - _e6704[1]))) + (_e7042 * (_e6692[2] - _e6704[2])));
                                                    let _e7151 = (((_e7038 * _e6692[0]) + (_e7040 * _e6692[1])) + (_e7042 * _e6692[2]));
                                                    if (_e7115 < 0.0lf) {
                                                        phi_3571_ = -(_e7115);
                                                    } else {
                                                        phi_3571_ = _e7115;
                                                    }
                                                    let _e7156 = phi_3571_;
                                                    if (_e7136 < 0.0lf) {
                                                        phi_3577_ = -(_e7136);
                                                    } else {
                                                        phi_3577_ = _e7136;
                                                    }
                                                    let _e7160 = phi_3577_;
                                                    if (_e7120 < 0.0lf) {
                                                        phi_3586_ = -(_e7120);
                                                    } else {
                                                        phi_3586_ = _e7120;
                                                    }
                                                    let _e7167 = phi_3586_;
                                                    if (_e7141 < 0.0lf) {
                                                        phi_3592_ = -(_e7141);
                                                    } else {
                                                        phi_3592_ = _e7141;
                                                    }
                                                    let _e7171 = phi_3592_;
                                                    if (_e7125 < 0.0lf) {
                                                        phi_3601_ = -(_e7125);
                                                    } else {
                                                        phi_3601_ = _e7125;
                                                    }
                                                    let _e7178 = phi_3601_;
                                                    if (_e7146 < 0.0lf) {
                                                        phi_3607_ = -(_e7146);
                                                    } else {
                                                        phi_3607_ = _e7146;
                                                    }
                                                    let _e7182 = phi_3607_;
                                                    if (_e7130 < 0.0lf) {
                                                        phi_3616_ = -(_e7130);
                                                    } else {
                                                        phi_3616_ = _e7130;
                                                    }
                                                    let _e7189 = phi_3616_;
                                                    if (_e7151 < 0.0lf) {
                                                        phi_3622_ = -(_e7151);
                                                    } else {
                                                        phi_3622_ = _e7151;
                                                    }
                                                    let _e7193 = phi_3622_;
                                                    phi_3628_ = type_38(array<f64, 4>(_e7115, _e7120, _e7125, _e7130), array<f64, 4>(_e7136, _e7141, _e7146, _e7151), array<f64, 4>((_e7110 + ((_e7156 + _e7160) * _e7103)), (_e7110 + ((_e7167 + _e7171) * _e7103)), (_e7110 + ((_e7178 + _e7182) * _e7103)), (_e7110 + ((_e7189 + _e7193) * _e7103))));
                                                    phi_3629_ = false;
                                                } else {
                                                    phi_3628_ = type_38();
                                                    phi_3629_ = true;
                                                }
                                                let _e7200 = phi_3628_;
                                                let _e7202 = phi_3629_;
                                                phi_3630_ = _e7200;
                                                phi_3631_ = _e7202;
                                            } else {
                                                phi_3630_ = type_38();
                                                phi_3631_ = true;
                                            }
                                            let _e7204 = phi_3630_;
                                            let _e7206 = phi_3631_;
                                            if _e7206 {
                                                let _e7207 = f64(0f);
                                                let _e7208 = f64(1f);
                                                phi_3641_ = type_38(array<f64, 4>(_e7207, _e7207, _e7207, _e7207), array<f64, 4>(_e7207, _e7207, _e7207, _e7207), array<f64, 4>(_e7208, _e7208, _e7208, _e7208));
                                            } else {
                                                phi_3641_ = _e7204;
                                            }
                                            let _e7214 = phi_3641_;
                                            local_17 = type_38(array<f64, 4>(_e7214.member[0], _e7214.member[1], _e7214.member[2], _e7214.member[3]), array<f64, 4>(_e7214.member_1[0], _e7214.member_1[1], _e7214.member_1[2], _e7214.member_1[3]), array<f64, 4>(_e7214.member_2[0], _e7214.member_2[1], _e7214.member_2[2], _e7214.member_2[3]));
                                            let _e7234 = (_e6901 - _e6907);
                                            let _e7236 = f64(0f);
                                            let _e7239 = local_17.member[0u];
                                            let _e7242 = local_17.member_1[0u];
                                            let _e7245 = local_17.member[0u];
                                            let _e7251 = local_17.member_2[0u];
                                            if (((_e7239 + ((_e7242 - _e7245) * _e6901)) - _e7251) > _e7236) {
                                                let _e7256 = local_17.member[1u];
                                                let _e7259 = local_17.member_1[1u];
                                                let _e7262 = local_17.member[1u];
                                                let _e7268 = local_17.member_2[1u];
                                                if (((_e7256 + ((_e7259 - _e7262) * _e6901)) - _e7268) > _e7236) {
                                                    let _e7273 = local_17.member[2u];
                                                    let _e7276 = local_17.member_1[2u];
                                                    let _e7279 = local_17.member[2u];
                                                    let _e7285 = local_17.member_2[2u];
                                                    if (((_e7273 + ((_e7276 - _e7279) * _e6901)) - _e7285) > _e7236) {
                                                        let _e7290 = local_17.member[3u];
                                                        let _e7293 = local_17.member_1[3u];
                                                        let _e7296 = local_17.member[3u];
                                                        let _e7302 = local_17.member_2[3u];
                                                        phi_3813_ = (((_e7290 + ((_e7293 - _e7296) * _e6901)) - _e7302) > _e7236);
                                                        phi_3814_ = false;
                                                    } else {
                                                        phi_3813_ = bool();
                                                        phi_3814_ = true;
                                                    }
                                                    let _e7306 = phi_3813_;
                                                    let _e7308 = phi_3814_;
                                                    phi_3815_ = _e7306;
                                                    phi_3816_ = _e7308;
                                                } else {
                                                    phi_3815_ = bool();
                                                    phi_3816_ = true;
                                                }
                                                let _e7310 = phi_3815_;
                                                let _e7312 = phi_3816_;
                                                phi_3817_ = _e7310;
                                                phi_3818_ = _e7312;
                                            } else {
                                                phi_3817_ = bool();
                                                phi_3818_ = true;
                                            }
                                            let _e7314 = phi_3817_;
                                            let _e7316 = phi_3818_;
                                            if _e7316 {
                                                phi_3822_ = false;
                                            } else {
                                                phi_3822_ = _e7314;
                                            }
                                            let _e7318 = phi_3822_;
                                            if _e7318 {
                                                if (_e6901 <= _e6903) {
                                                    phi_4133_ = true;
                                                } else {
                                                    let _e7320 = f64(0f);
                                                    let _e7323 = local_16.member[0u];
                                                    let _e7326 = local_16.member_1[0u];
                                                    let _e7329 = local_16.member[0u];
                                                    let _e7335 = local_16.member_2[0u];
                                                    let _e7339 = local_17.member[0u];
                                                    let _e7342 = local_17.member_1[0u];
                                                    let _e7345 = local_17.member[0u];
                                                    let _e7351 = local_17.member_2[0u];
                                                    if ((((_e7323 + ((_e7326 - _e7329) * _e6901)) - _e7335) + ((_e7339 + ((_e7342 - _e7345) * _e6907)) - _e7351)) > _e7320) {
                                                        let _e7357 = local_16.member[1u];
                                                        let _e7360 = local_16.member_1[1u];
                                                        let _e7363 = local_16.member[1u];
                                                        let _e7369 = local_16.member_2[1u];
                                                        let _e7373 = local_17.member[1u];
                                                        let _e7376 = local_17.member_1[1u];
                                                        let _e7379 = local_17.member[1u];
                                                        let _e7385 = local_17.member_2[1u];
                                                        if ((((_e7357 + ((_e7360 - _e7363) * _e6901)) - _e7369) + ((_e7373 + ((_e7376 - _e7379) * _e6907)) - _e7385)) > _e7320) {
                                                            let _e7391 = local_16.member[2u];
                                                            let _e7394 = local_16.member_1[2u];
                                                            let _e7397 = local_16.member[2u];
                                                            let _e7403 = local_16.member_2[2u];
                                                            let _e7407 = local_17.member[2u];
                                                            let _e7410 = local_17.member_1[2u];
                                                            let _e7413 = local_17.member[2u];
                                                            let _e7419 = local_17.member_2[2u];
                                                            if ((((_e7391 + ((_e7394 - _e7397) * _e6901)) - _e7403) + ((_e7407 + ((_e7410 - _e7413) * _e6907)) - _e7419)) > _e7320) {
                                                                let _e7425 = local_16.member[3u];
                                                                let _e7428 = local_16.member_1[3u];
                                                                let _e7431 = local_16.member[3u];
                                                                let _e7437 = local_16.member_2[3u];
                                                                let _e7441 = local_17.member[3u];
                                                                let _e7444 = local_17.member_1[3u];
                                                                let _e7447 = local_17.member[3u];
                                                                let _e7453 = local_17.member_2[3u];
                                                                phi_4120_ = ((((_e7425 + ((_e7428 - _e7431) * _e6901)) - _e7437) + ((_e7441 + ((_e7444 - _e7447) * _e6907)) - _e7453)) > _e7320);
                                                                phi_4121_ = false;
                                                            } else {
                                                                phi_4120_ = bool();
                                                                phi_4121_ = true;
                                                            }
                                                            let _e7458 = phi_4120_;
                                                            let _e7460 = phi_4121_;
                                                            phi_4122_ = _e7458;
                                                            phi_4123_ = _e7460;
                                                        } else {
                                                            phi_4122_ = bool();
                                                            phi_4123_ = true;
                                                        }
                                                        let _e7462 = phi_4122_;
                                                        let _e7464 = phi_4123_;
                                                        phi_4124_ = _e7462;
                                                        phi_4125_ = _e7464;
                                                    } else {
                                                        phi_4124_ = bool();
                                                        phi_4125_ = true;
                                                    }
                                                    let _e7466 = phi_4124_;
                                                    let _e7468 = phi_4125_;
                                                    if _e7468 {
                                                        phi_4129_ = false;
                                                    } else {
                                                        phi_4129_ = _e7466;
                                                    }
                                                    let _e7470 = phi_4129_;
                                                    phi_4133_ = _e7470;
                                                }
                                                let _e7472 = phi_4133_;
                                                if _e7472 {
                                                    if _e6909 {
                                                        if (_e6901 >= _e419) {
                                                            phi_4144_ = false;
                                                        } else {
                                                            phi_4144_ = true;
                                                        }
                                                        let _e7475 = phi_4144_;
                                                        phi_4145_ = _e7475;
                                                    } else {
                                                        phi_4145_ = true;
                                                    }
                                                    let _e7477 = phi_4145_;
                                                    if _e7477 {
                                                        local_16 = type_38(array<f64, 4>(_e7214.member[0], _e7214.member[1], _e7214.member[2], _e7214.member[3]), array<f64, 4>(_e7214.member_1[0], _e7214.member_1[1], _e7214.member_1[2], _e7214.member_1[3]), array<f64, 4>(_e7214.member_2[0], _e7214.member_2[1], _e7214.member_2[2], _e7214.member_2[3]));
                                                        let _e7499 = local_16.member[0u];
                                                        let _e7502 = local_16.member_1[0u];
                                                        let _e7505 = local_16.member_2[0u];
                                                        if (_e7499 > _e7505) {
                                                            if (_e7502 > _e7505) {
                                                                phi_4219_ = false;
                                                            } else {
                                                                phi_4219_ = true;
                                                            }
                                                            let _e7509 = phi_4219_;
                                                            phi_4220_ = _e7509;
                                                        } else {
                                                            phi_4220_ = true;
                                                        }
                                                        let _e7511 = phi_4220_;
                                                        if _e7511 {
                                                            let _e7512 = (_e7502 >= _e7499);
                                                            if _e7512 {
                                                                phi_4245_ = f64();
                                                                phi_4246_ = false;
                                                            } else {
                                                                if ((_e7499 - _e7502) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4243_ = (((_e7499 - _e7505) / (_e7499 - _e7502)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4244_ = false;
                                                                } else {
                                                                    phi_4243_ = f64();
                                                                    phi_4244_ = true;
                                                                }
                                                                let _e7526 = phi_4243_;
                                                                let _e7528 = phi_4244_;
                                                                phi_4245_ = _e7526;
                                                                phi_4246_ = _e7528;
                                                            }
                                                            let _e7530 = phi_4245_;
                                                            let _e7532 = phi_4246_;
                                                            phi_4247_ = _e7530;
                                                            phi_4248_ = _e7512;
                                                            phi_4249_ = _e7532;
                                                        } else {
                                                            phi_4247_ = f64();
                                                            phi_4248_ = true;
                                                            phi_4249_ = false;
                                                        }
                                                        let _e7534 = phi_4247_;
                                                        let _e7536 = phi_4248_;
                                                        let _e7538 = phi_4249_;
                                                        if _e7536 {
                                                            phi_4254_ = f64(2f);
                                                            phi_4255_ = true;
                                                        } else {
                                                            phi_4254_ = _e6901;
                                                            phi_4255_ = _e7538;
                                                        }
                                                        let _e7541 = phi_4254_;
                                                        let _e7543 = phi_4255_;
                                                        if _e7543 {
                                                            phi_4259_ = _e7541;
                                                        } else {
                                                            phi_4259_ = _e7534;
                                                        }
                                                        let _e7545 = phi_4259_;
                                                        let _e7548 = local_16.member[1u];
                                                        let _e7551 = local_16.member_1[1u];
                                                        let _e7554 = local_16.member_2[1u];
                                                        if (_e7548 > _e7554) {
                                                            if (_e7551 > _e7554) {
                                                                phi_4291_ = false;
                                                            } else {
                                                                phi_4291_ = true;
                                                            }
                                                            let _e7558 = phi_4291_;
                                                            phi_4292_ = _e7558;
                                                        } else {
                                                            phi_4292_ = true;
                                                        }
                                                        let _e7560 = phi_4292_;
                                                        if _e7560 {
                                                            let _e7561 = (_e7551 >= _e7548);
                                                            if _e7561 {
                                                                phi_4317_ = f64();
                                                                phi_4318_ = false;
                                                            } else {
                                                                if ((_e7548 - _e7551) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4315_ = (((_e7548 - _e7554) / (_e7548 - _e7551)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4316_ = false;
                                                                } else {
                                                                    phi_4315_ = f64();
                                                                    phi_4316_ = true;
                                                                }
                                                                let _e7575 = phi_4315_;
                                                                let _e7577 = phi_4316_;
                                                                phi_4317_ = _e7575;
                                                                phi_4318_ = _e7577;
                                                            }
                                                            let _e7579 = phi_4317_;
                                                            let _e7581 = phi_4318_;
                                                            phi_4319_ = _e7579;
                                                            phi_4320_ = _e7561;
                                                            phi_4321_ = _e7581;
                                                        } else {
                                                            phi_4319_ = f64();
                                                            phi_4320_ = true;
                                                            phi_4321_ = false;
                                                        }
                                                        let _e7583 = phi_4319_;
                                                        let _e7585 = phi_4320_;
                                                        let _e7587 = phi_4321_;
                                                        if _e7585 {
                                                            phi_4326_ = f64(2f);
                                                            phi_4327_ = true;
                                                        } else {
                                                            phi_4326_ = _e6901;
                                                            phi_4327_ = _e7587;
                                                        }
                                                        let _e7590 = phi_4326_;
                                                        let _e7592 = phi_4327_;
                                                        if _e7592 {
                                                            phi_4331_ = _e7590;
                                                        } else {
                                                            phi_4331_ = _e7583;
                                                        }
                                                        let _e7594 = phi_4331_;
                                                        if (_e7545 < _e7594) {
                                                            phi_4336_ = _e7545;
                                                        } else {
                                                            phi_4336_ = _e7594;
                                                        }
                                                        let _e7597 = phi_4336_;
                                                        let _e7600 = local_16.member[2u];
                                                        let _e7603 = local_16.member_1[2u];
                                                        let _e7606 = local_16.member_2[2u];
                                                        if (_e7600 > _e7606) {
                                                            if (_e7603 > _e7606) {
                                                                phi_4368_ = false;
                                                            } else {
                                                                phi_4368_ = true;
                                                            }
                                                            let _e7610 = phi_4368_;
                                                            phi_4369_ = _e7610;
                                                        } else {
                                                            phi_4369_ = true;
                                                        }
                                                        let _e7612 = phi_4369_;
                                                        if _e7612 {
                                                            let _e7613 = (_e7603 >= _e7600);
                                                            if _e7613 {
                                                                phi_4394_ = f64();
                                                                phi_4395_ = false;
                                                            } else {
                                                                if ((_e7600 - _e7603) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4392_ = (((_e7600 - _e7606) / (_e7600 - _e7603)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4393_ = false;
                                                                } else {
                                                                    phi_4392_ = f64();
                                                                    phi_4393_ = true;
                                                                }
                                                                let _e7627 = phi_4392_;
                                                                let _e7629 = phi_4393_;
                                                                phi_4394_ = _e7627;
                                                                phi_4395_ = _e7629;
                                                            }
                                                            let _e7631 = phi_4394_;
                                                            let _e7633 = phi_4395_;
                                                            phi_4396_ = _e7631;
                                                            phi_4397_ = _e7613;
                                                            phi_4398_ = _e7633;
                                                        } else {
                                                            phi_4396_ = f64();
                                                            phi_4397_ = true;
                                                            phi_4398_ = false;
                                                        }
                                                        let _e7635 = phi_4396_;
                                                        let _e7637 = phi_4397_;
                                                        let _e7639 = phi_4398_;
                                                        if _e7637 {
                                                            phi_4403_ = f64(2f);
                                                            phi_4404_ = true;
                                                        } else {
                                                            phi_4403_ = _e6901;
                                                            phi_4404_ = _e7639;
                                                        }
                                                        let _e7642 = phi_4403_;
                                                        let _e7644 = phi_4404_;
                                                        if _e7644 {
                                                            phi_4408_ = _e7642;
                                                        } else {
                                                            phi_4408_ = _e7635;
                                                        }
                                                        let _e7646 = phi_4408_;
                                                        let _e7649 = local_16.member[3u];
                                                        let _e7652 = local_16.member_1[3u];
                                                        let _e7655 = local_16.member_2[3u];
                                                        if (_e7649 > _e7655) {
                                                            if (_e7652 > _e7655) {
                                                                phi_4440_ = false;
                                                            } else {
                                                                phi_4440_ = true;
                                                            }
                                                            let _e7659 = phi_4440_;
                                                            phi_4441_ = _e7659;
                                                        } else {
                                                            phi_4441_ = true;
                                                        }
                                                        let _e7661 = phi_4441_;
                                                        if _e7661 {
                                                            let _e7662 = (_e7652 >= _e7649);
                                                            if _e7662 {
                                                                phi_4466_ = f64();
                                                                phi_4467_ = false;
                                                            } else {
                                                                if ((_e7649 - _e7652) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4464_ = (((_e7649 - _e7655) / (_e7649 - _e7652)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4465_ = false;
                                                                } else {
                                                                    phi_4464_ = f64();
                                                                    phi_4465_ = true;
                                                                }
                                                                let _e7676 = phi_4464_;
                                                                let _e7678 = phi_4465_;
                                                                phi_4466_ = _e7676;
                                                                phi_4467_ = _e7678;
                                                            }
                                                            let _e7680 = phi_4466_;
                                                            let _e7682 = phi_4467_;
                                                            phi_4468_ = _e7680;
                                                            phi_4469_ = _e7662;
                                                            phi_4470_ = _e7682;
                                                        } else {
                                                            phi_4468_ = f64();
                                                            phi_4469_ = true;
                                                            phi_4470_ = false;
                                                        }
                                                        let _e7684 = phi_4468_;
                                                        let _e7686 = phi_4469_;
                                                        let _e7688 = phi_4470_;
                                                        if _e7686 {
                                                            phi_4475_ = f64(2f);
                                                            phi_4476_ = true;
                                                        } else {
                                                            phi_4475_ = _e6901;
                                                            phi_4476_ = _e7688;
                                                        }
                                                        let _e7691 = phi_4475_;
                                                        let _e7693 = phi_4476_;
                                                        if _e7693 {
                                                            phi_4480_ = _e7691;
                                                        } else {
                                                            phi_4480_ = _e7684;
                                                        }
                                                        let _e7695 = phi_4480_;
                                                        if (_e7646 < _e7695) {
                                                            phi_4485_ = _e7646;
                                                        } else {
                                                            phi_4485_ = _e7695;
                                                        }
                                                        let _e7698 = phi_4485_;
                                                        if (_e7597 < _e7698) {
                                                            phi_4490_ = _e7597;
                                                        } else {
                                                            phi_4490_ = _e7698;
                                                        }
                                                        let _e7701 = phi_4490_;
                                                        if (_e7701 > _e6901) {
                                                            phi_4495_ = _e7701;
                                                        } else {
                                                            phi_4495_ = _e6901;
                                                        }
                                                        let _e7704 = phi_4495_;
                                                        let _e7705 = (_e7704 > _e419);
                                                        if _e7705 {
                                                            phi_5012_ = f64();
                                                            phi_5013_ = f64();
                                                            phi_5014_ = false;
                                                            phi_5015_ = false;
                                                        } else {
                                                            let _e7706 = (_e7704 - _e6901);
                                                            let _e7707 = (_e7706 <= _e6890);
                                                            let _e7710 = (_e7704 + (_e401 * f64(0.01f)));
                                                            if (_e7710 < _e419) {
                                                                phi_4509_ = _e7710;
                                                            } else {
                                                                phi_4509_ = _e419;
                                                            }
                                                            let _e7713 = phi_4509_;
                                                            if _e7707 {
                                                                if (_e620.member_1 > f64(0f)) {
                                                                    let _e7718 = local_18.member[0u];
                                                                    let _e7724 = local_18.member[1u];
                                                                    let _e7740 = local_18.member_1[0u];
                                                                    let _e7746 = local_18.member_1[1u];
                                                                    let _e7762 = local_18.member_2[0u];
                                                                    let _e7768 = local_18.member_2[1u];
                                                                    let _e7782 = function_3(array<f64, 3>((_e7718[0] + ((_e7724[0] - _e7718[0]) * _e7713)), (_e7718[1] + ((_e7724[1] - _e7718[1]) * _e7713)), (_e7718[2] + ((_e7724[2] - _e7718[2]) * _e7713))), array<f64, 3>((_e7740[0] + ((_e7746[0] - _e7740[0]) * _e7713)), (_e7740[1] + ((_e7746[1] - _e7740[1]) * _e7713)), (_e7740[2] + ((_e7746[2] - _e7740[2]) * _e7713))), array<f64, 3>((_e7762[0] + ((_e7768[0] - _e7762[0]) * _e7713)), (_e7762[1] + ((_e7768[1] - _e7762[1]) * _e7713)), (_e7762[2] + ((_e7768[2] - _e7762[2]) * _e7713))), 0u);
                                                                    let _e7793 = (((_e7782[0] * _e7782[0]) + (_e7782[1] * _e7782[1])) + (_e7782[2] * _e7782[2]));
                                                                    if (_e7793 <= 2.2250738585072014e-308lf) {
                                                                        if (_e7793 > 0.0lf) {
                                                                            phi_4640_ = (1.464336215552873e-154lf * 2.0lf);
                                                                        } else {
                                                                            phi_4640_ = 0.0lf;
                                                                        }
                                                                        let _e7845 = phi_4640_;
                                                                        phi_4704_ = _e7845;
                                                                    } else {
                                                                        phi_4647_ = type_16(0i, 5i);
                                                                        phi_4650_ = bitcast<f64>(((bitcast<u64>(_e7793) / 2lu) + 2303426169912950784lu));
                                                                        loop {
                                                                            let _e7800 = phi_4647_;
                                                                            let _e7802 = phi_4650_;
                                                                            local_42 = _e7802;
                                                                            if (_e7800.member < _e7800.member_1) {
                                                                                let _e7809 = (_e7800.member + 1i);
                                                                                if ((false == (_e7809 > _e7800.member)) != false) {
                                                                                    phi_4671_ = true;
                                                                                } else {
                                                                                    phi_4671_ = false;
                                                                                }
                                                                                let _e7814 = phi_4671_;
                                                                                if _e7814 {
                                                                                    phi_4677_ = type_17(0u, type_17().member_1);
                                                                                } else {
                                                                                    phi_4677_ = type_17(1u, _e7809);
                                                                                }
                                                                                let _e7819 = phi_4677_;
                                                                                phi_4648_ = type_16(_e7819.member_1, _e7800.member_1);
                                                                                phi_4691_ = type_17(1u, _e7800.member);
                                                                            } else {
                                                                                phi_4648_ = _e7800;
                                                                                phi_4691_ = type_17(0u, type_17().member_1);
                                                                            }
                                                                            let _e7825 = phi_4648_;
                                                                            let _e7827 = phi_4691_;
                                                                            let _e7830 = (bitcast<i32>(_e7827.member) != 0i);
                                                                            if _e7830 {
                                                                                phi_4651_ = (0.5lf * (_e7802 + (_e7793 / _e7802)));
                                                                            } else {
                                                                                phi_4651_ = f64();
                                                                            }
                                                                            let _e7835 = phi_4651_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_4647_ = _e7825;
                                                                                phi_4650_ = _e7835;
                                                                                break if !(_e7830);
                                                                            }
                                                                        }
                                                                        let _e7840 = local_42;
                                                                        phi_4704_ = (_e7840 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                    }
                                                                    let _e7847 = phi_4704_;
                                                                    let _e7855 = local_18.member[0u];
                                                                    if (_e7855[0] < 0.0lf) {
                                                                        phi_4722_ = -(_e7855[0]);
                                                                    } else {
                                                                        phi_4722_ = _e7855[0];
                                                                    }
                                                                    let _e7862 = phi_4722_;
                                                                    if (_e7855[1] < 0.0lf) {
                                                                        phi_4729_ = -(_e7855[1]);
                                                                    } else {
                                                                        phi_4729_ = _e7855[1];
                                                                    }
                                                                    let _e7866 = phi_4729_;
                                                                    if (_e7862 > _e7866) {
                                                                        phi_4734_ = _e7862;
                                                                    } else {
                                                                        phi_4734_ = _e7866;
                                                                    }
                                                                    let _e7869 = phi_4734_;
                                                                    if (_e7855[2] < 0.0lf) {
                                                                        phi_4741_ = -(_e7855[2]);
                                                                    } else {
                                                                        phi_4741_ = _e7855[2];
                                                                    }
                                                                    let _e7873 = phi_4741_;
                                                                    if (_e7869 > _e7873) {
                                                                        phi_4746_ = _e7869;
                                                                    } else {
                                                                        phi_4746_ = _e7873;
                                                                    }
                                                                    let _e7876 = phi_4746_;
                                                                    let _e7879 = local_18.member[1u];
                                                                    if (_e7879[0] < 0.0lf) {
                                                                        phi_4759_ = -(_e7879[0]);
                                                                    } else {
                                                                        phi_4759_ = _e7879[0];
                                                                    }
                                                                    let _e7886 = phi_4759_;
                                                                    if (_e7879[1] < 0.0lf) {
                                                                        phi_4766_ = -(_e7879[1]);
                                                                    } else {
                                                                        phi_4766_ = _e7879[1];
                                                                    }
                                                                    let _e7890 = phi_4766_;
                                                                    if (_e7886 > _e7890) {
                                                                        phi_4771_ = _e7886;
                                                                    } else {
                                                                        phi_4771_ = _e7890;
                                                                    }
                                                                    let _e7893 = phi_4771_;
                                                                    if (_e7879[2] < 0.0lf) {
                                                                        phi_4778_ = -(_e7879[2]);
                                                                    } else {
                                                                        phi_4778_ = _e7879[2];
                                                                    }
                                                                    let _e7897 = phi_4778_;
                                                                    if (_e7893 > _e7897) {
                                                                        phi_4783_ = _e7893;
                                                                    } else {
                                                                        phi_4783_ = _e7897;
                                                                    }
                                                                    let _e7900 = phi_4783_;
                                                                    if (_e7876 > _e7900) {
                                                                        phi_4788_ = _e7876;
                                                                    } else {
                                                                        phi_4788_ = _e7900;
                                                                    }
                                                                    let _e7903 = phi_4788_;
                                                                    let _e7905 = local_18.member_3;
                                                                    let _e7909 = local_18.member_1[0u];
                                                                    if (_e7909[0] < 0.0lf) {
                                                                        phi_4805_ = -(_e7909[0]);
                                                                    } else {
                                                                        phi_4805_ = _e7909[0];
                                                                    }
                                                                    let _e7916 = phi_4805_;
                                                                    if (_e7909[1] < 0.0lf) {
                                                                        phi_4812_ = -(_e7909[1]);
                                                                    } else {
                                                                        phi_4812_ = _e7909[1];
                                                                    }
                                                                    let _e7920 = phi_4812_;
                                                                    if (_e7916 > _e7920) {
                                                                        phi_4817_ = _e7916;
                                                                    } else {
                                                                        phi_4817_ = _e7920;
                                                                    }
                                                                    let _e7923 = phi_4817_;
                                                                    if (_e7909[2] < 0.0lf) {
                                                                        phi_4824_ = -(_e7909[2]);
                                                                    } else {
                                                                        phi_4824_ = _e7909[2];
                                                                    }
                                                                    let _e7927 = phi_4824_;
                                                                    if (_e7923 > _e7927) {
                                                                        phi_4829_ = _e7923;
                                                                    } else {
                                                                        phi_4829_ = _e7927;
                                                                    }
                                                                    let _e7930 = phi_4829_;
                                                                    let _e7933 = local_18.member_1[1u];
                                                                    if (_e7933[0] < 0.0lf) {
                                                                        phi_4843_ = -(_e7933[0]);
                                                                    } else {
                                                                        phi_4843_ = _e7933[0];
                                                                    }
                                                                    let _e7940 = phi_4843_;
                                                                    if (_e7933[1] < 0.0lf) {
                                                                        phi_4850_ = -(_e7933[1]);
                                                                    } else {
                                                                        phi_4850_ = _e7933[1];
                                                                    }
                                                                    let _e7944 = phi_4850_;
                                                                    if (_e7940 > _e7944) {
                                                                        phi_4855_ = _e7940;
                                                                    } else {
                                                                        phi_4855_ = _e7944;
                                                                    }
                                                                    let _e7947 = phi_4855_;
                                                                    if (_e7933[2] < 0.0lf) {
                                                                        phi_4862_ = -(_e7933[2]);
                                                                    } else {
                                                                        phi_4862_ = _e7933[2];
                                                                    }
                                                                    let _e7951 = phi_4862_;
                                                                    if (_e7947 > _e7951) {
                                                                        phi_4867_ = _e7947;
                                                                    } else {
                                                                        phi_4867_ = _e7951;
                                                                    }
                                                                    let _e7954 = phi_4867_;
                                                                    if (_e7930 > _e7954) {
                                                                        phi_4872_ = _e7930;
                                                                    } else {
                                                                        phi_4872_ = _e7954;
                                                                    }
                                                                    let _e7957 = phi_4872_;
                                                                    let _e7959 = local_18.member_3;
                                                                    let _e7963 = local_18.member_2[0u];
                                                                    if (_e7963[0] < 0.0lf) {
                                                                        phi_4889_ = -(_e7963[0]);
                                                                    } else {
                                                                        phi_4889_ = _e7963[0];
                                                                    }
                                                                    let _e7970 = phi_4889_;
                                                                    if (_e7963[1] < 0.0lf) {
                                                                        phi_4896_ = -(_e7963[1]);
                                                                    } else {
                                                                        phi_4896_ = _e7963[1];
                                                                    }
                                                                    let _e7974 = phi_4896_;
                                                                    if (_e7970 > _e7974) {
                                                                        phi_4901_ = _e7970;
                                                                    } else {
                                                                        phi_4901_ = _e7974;
                                                                    }
                                                                    let _e7977 = phi_4901_;
                                                                    if (_e7963[2] < 0.0lf) {
                                                                        phi_4908_ = -(_e7963[2]);
                                                                    } else {
                                                                        phi_4908_ = _e7963[2];
                                                                    }
                                                                    let _e7981 = phi_4908_;
                                                                    if (_e7977 > _e7981) {
                                                                        phi_4913_ = _e7977;
                                                                    } else {
                                                                        phi_4913_ = _e7981;
                                                                    }
                                                                    let _e7984 = phi_4913_;
                                                                    let _e7987 = local_18.member_2[1u];
                                                                    if (_e7987[0] < 0.0lf) {
                                                                        phi_4927_ = -(_e7987[0]);
                                                                    } else {
                                                                        phi_4927_ = _e7987[0];
                                                                    }
                                                                    let _e7994 = phi_4927_;
                                                                    if (_e7987[1] < 0.0lf) {
                                                                        phi_4934_ = -(_e7987[1]);
                                                                    } else {
                                                                        phi_4934_ = _e7987[1];
                                                                    }
                                                                    let _e7998 = phi_4934_;
                                                                    if (_e7994 > _e7998) {
                                                                        phi_4939_ = _e7994;
                                                                    } else {
                                                                        phi_4939_ = _e7998;
                                                                    }
                                                                    let _e8001 = phi_4939_;
                                                                    if (_e7987[2] < 0.0lf) {
                                                                        phi_4946_ = -(_e7987[2]);
                                                                    } else {
                                                                        phi_4946_ = _e7987[2];
                                                                    }
                                                                    let _e8005 = phi_4946_;
                                                                    if (_e8001 > _e8005) {
                                                                        phi_4951_ = _e8001;
                                                                    } else {
                                                                        phi_4951_ = _e8005;
                                                                    }
                                                                    let _e8008 = phi_4951_;
                                                                    if (_e7984 > _e8008) {
                                                                        phi_4956_ = _e7984;
                                                                    } else {
                                                                        phi_4956_ = _e8008;
                                                                    }
                                                                    let _e8011 = phi_4956_;
                                                                    let _e8013 = local_18.member_3;
                                                                    let _e8021 = local_18.member_3;
                                                                    if (((_e7847 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e7903 + _e7905) + (_e7957 + _e7959)) + (_e8011 + _e8013)) * (1.1102230246251565e-16lf * f64(16f))) + (_e8021 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e620.member_1) {
                                                                        phi_4980_ = false;
                                                                    } else {
                                                                        phi_4980_ = true;
                                                                    }
                                                                    let _e8033 = phi_4980_;
                                                                    phi_4981_ = _e8033;
                                                                } else {
                                                                    phi_4981_ = true;
                                                                }
                                                                let _e8035 = phi_4981_;
                                                                phi_4982_ = _e8035;
                                                            } else {
                                                                phi_4982_ = true;
                                                            }
                                                            let _e8037 = phi_4982_;
                                                            if _e8037 {
                                                                if _e6909 {
                                                                    if _e7707 {
                                                                        phi_5001_ = f64();
                                                                        phi_5002_ = true;
                                                                    } else {
                                                                        if (_e7706 <= (_e6905 * f64(0.25f))) {
                                                                            phi_4999_ = f64(0f);
                                                                            phi_5000_ = false;
                                                                        } else {
                                                                            phi_4999_ = f64();
                                                                            phi_5000_ = true;
                                                                        }
                                                                        let _e8044 = phi_4999_;
                                                                        let _e8046 = phi_5000_;
                                                                        phi_5001_ = _e8044;
                                                                        phi_5002_ = _e8046;
                                                                    }
                                                                    let _e8048 = phi_5001_;
                                                                    let _e8050 = phi_5002_;
                                                                    if _e8050 {
                                                                        phi_5007_ = (_e7234 + _e7234);
                                                                    } else {
                                                                        phi_5007_ = _e8048;
                                                                    }
                                                                    let _e8053 = phi_5007_;
                                                                    phi_5009_ = _e8053;
                                                                } else {
                                                                    phi_5009_ = (_e419 - _e6901);
                                                                }
                                                                let _e8055 = phi_5009_;
                                                                phi_5010_ = _e8055;
                                                                phi_5011_ = false;
                                                            } else {
                                                                phi_5010_ = f64();
                                                                phi_5011_ = true;
                                                            }
                                                            let _e8057 = phi_5010_;
                                                            let _e8059 = phi_5011_;
                                                            phi_5012_ = _e8057;
                                                            phi_5013_ = _e7706;
                                                            phi_5014_ = _e8037;
                                                            phi_5015_ = _e8059;
                                                        }
                                                        let _e8061 = phi_5012_;
                                                        let _e8063 = phi_5013_;
                                                        let _e8065 = phi_5014_;
                                                        let _e8067 = phi_5015_;
                                                        phi_5016_ = _e7704;
                                                        phi_5017_ = _e8061;
                                                        phi_5018_ = _e8063;
                                                        phi_5019_ = _e7704;
                                                        phi_5020_ = _e8065;
                                                        phi_5021_ = _e7705;
                                                        phi_5022_ = _e8067;
                                                        phi_5023_ = false;
                                                    } else {
                                                        phi_5016_ = f64();
                                                        phi_5017_ = f64();
                                                        phi_5018_ = f64();
                                                        phi_5019_ = f64();
                                                        phi_5020_ = false;
                                                        phi_5021_ = false;
                                                        phi_5022_ = false;
                                                        phi_5023_ = true;
                                                    }
                                                    let _e8069 = phi_5016_;
                                                    let _e8071 = phi_5017_;
                                                    let _e8073 = phi_5018_;
                                                    let _e8075 = phi_5019_;
                                                    let _e8077 = phi_5020_;
                                                    let _e8079 = phi_5021_;
                                                    let _e8081 = phi_5022_;
                                                    let _e8083 = phi_5023_;
                                                    phi_5024_ = _e8069;
                                                    phi_5025_ = _e8071;
                                                    phi_5026_ = _e8073;
                                                    phi_5027_ = _e8075;
                                                    phi_5028_ = false;
                                                    phi_5029_ = _e8077;
                                                    phi_5030_ = _e8079;
                                                    phi_5031_ = _e8081;
                                                    phi_5032_ = _e8083;
                                                } else {
                                                    phi_5024_ = f64();
                                                    phi_5025_ = f64();
                                                    phi_5026_ = f64();
                                                    phi_5027_ = f64();
                                                    phi_5028_ = true;
                                                    phi_5029_ = false;
                                                    phi_5030_ = false;
                                                    phi_5031_ = false;
                                                    phi_5032_ = false;
                                                }
                                                let _e8085 = phi_5024_;
                                                let _e8087 = phi_5025_;
                                                let _e8089 = phi_5026_;
                                                let _e8091 = phi_5027_;
                                                let _e8093 = phi_5028_;
                                                let _e8095 = phi_5029_;
                                                let _e8097 = phi_5030_;
                                                let _e8099 = phi_5031_;
                                                let _e8101 = phi_5032_;
                                                phi_5033_ = _e8085;
                                                phi_5034_ = _e8087;
                                                phi_5035_ = _e8089;
                                                phi_5036_ = _e8091;
                                                phi_5037_ = _e8093;
                                                phi_5038_ = _e8095;
                                                phi_5039_ = _e8097;
                                                phi_5040_ = _e8099;
                                                phi_5041_ = _e8101;
                                            } else {
                                                phi_5033_ = f64();
                                                phi_5034_ = f64();
                                                phi_5035_ = f64();
                                                phi_5036_ = f64();
                                                phi_5037_ = true;
                                                phi_5038_ = false;
                                                phi_5039_ = false;
                                                phi_5040_ = false;
                                                phi_5041_ = false;
                                            }
                                            let _e8103 = phi_5033_;
                                            let _e8105 = phi_5034_;
                                            let _e8107 = phi_5035_;
                                            let _e8109 = phi_5036_;
                                            let _e8111 = phi_5037_;
                                            let _e8113 = phi_5038_;
                                            let _e8115 = phi_5039_;
                                            let _e8117 = phi_5040_;
                                            let _e8119 = phi_5041_;
                                            if _e8111 {
                                                if (_e6901 <= _e6903) {
                                                    let _e8285 = (_e6911 + 1u);
                                                    let _e8286 = (_e8285 > 3u);
                                                    if _e8286 {
                                                        phi_5054_ = false;
                                                    } else {
                                                        phi_5054_ = true;
                                                    }
                                                    let _e8288 = phi_5054_;
                                                    phi_5381_ = _e8285;
                                                    phi_5382_ = f64();
                                                    phi_5383_ = false;
                                                    phi_5384_ = _e8288;
                                                    phi_5385_ = _e8286;
                                                } else {
                                                    let _e8123 = local_16.member[0u];
                                                    let _e8126 = local_16.member_1[0u];
                                                    let _e8129 = local_16.member[0u];
                                                    let _e8135 = local_16.member_2[0u];
                                                    let _e8136 = ((_e8123 + ((_e8126 - _e8129) * _e6907)) - _e8135);
                                                    let _e8139 = local_16.member[1u];
                                                    let _e8142 = local_16.member_1[1u];
                                                    let _e8145 = local_16.member[1u];
                                                    let _e8151 = local_16.member_2[1u];
                                                    let _e8152 = ((_e8139 + ((_e8142 - _e8145) * _e6907)) - _e8151);
                                                    if (_e8136 < _e8152) {
                                                        phi_5127_ = _e8136;
                                                    } else {
                                                        phi_5127_ = _e8152;
                                                    }
                                                    let _e8155 = phi_5127_;
                                                    let _e8158 = local_16.member[2u];
                                                    let _e8161 = local_16.member_1[2u];
                                                    let _e8164 = local_16.member[2u];
                                                    let _e8170 = local_16.member_2[2u];
                                                    let _e8171 = ((_e8158 + ((_e8161 - _e8164) * _e6907)) - _e8170);
                                                    let _e8174 = local_16.member[3u];
                                                    let _e8177 = local_16.member_1[3u];
                                                    let _e8180 = local_16.member[3u];
                                                    let _e8186 = local_16.member_2[3u];
                                                    let _e8187 = ((_e8174 + ((_e8177 - _e8180) * _e6907)) - _e8186);
                                                    if (_e8171 < _e8187) {
                                                        phi_5200_ = _e8171;
                                                    } else {
                                                        phi_5200_ = _e8187;
                                                    }
                                                    let _e8190 = phi_5200_;
                                                    if (_e8155 < _e8190) {
                                                        phi_5205_ = _e8155;
                                                    } else {
                                                        phi_5205_ = _e8190;
                                                    }
                                                    let _e8193 = phi_5205_;
                                                    let _e8196 = local_17.member[0u];
                                                    let _e8199 = local_17.member_1[0u];
                                                    let _e8202 = local_17.member[0u];
                                                    let _e8208 = local_17.member_2[0u];
                                                    let _e8209 = ((_e8196 + ((_e8199 - _e8202) * _e6901)) - _e8208);
                                                    let _e8212 = local_17.member[1u];
                                                    let _e8215 = local_17.member_1[1u];
                                                    let _e8218 = local_17.member[1u];
                                                    let _e8224 = local_17.member_2[1u];
                                                    let _e8225 = ((_e8212 + ((_e8215 - _e8218) * _e6901)) - _e8224);
                                                    if (_e8209 < _e8225) {
                                                        phi_5278_ = _e8209;
                                                    } else {
                                                        phi_5278_ = _e8225;
                                                    }
                                                    let _e8228 = phi_5278_;
                                                    let _e8231 = local_17.member[2u];
                                                    let _e8234 = local_17.member_1[2u];
                                                    let _e8237 = local_17.member[2u];
                                                    let _e8243 = local_17.member_2[2u];
                                                    let _e8244 = ((_e8231 + ((_e8234 - _e8237) * _e6901)) - _e8243);
                                                    let _e8247 = local_17.member[3u];
                                                    let _e8250 = local_17.member_1[3u];
                                                    let _e8253 = local_17.member[3u];
                                                    let _e8259 = local_17.member_2[3u];
                                                    let _e8260 = ((_e8247 + ((_e8250 - _e8253) * _e6901)) - _e8259);
                                                    if (_e8244 < _e8260) {
                                                        phi_5351_ = _e8244;
                                                    } else {
                                                        phi_5351_ = _e8260;
                                                    }
                                                    let _e8263 = phi_5351_;
                                                    if (_e8228 < _e8263) {
                                                        phi_5356_ = _e8228;
                                                    } else {
                                                        phi_5356_ = _e8263;
                                                    }
                                                    let _e8266 = phi_5356_;
                                                    let _e8267 = f64(0.0625f);
                                                    let _e8269 = f64(0.9f);
                                                    if (_e8266 > f64(0f)) {
                                                        phi_5379_ = f64(0.5f);
                                                    } else {
                                                        let _e8275 = (f64(0.95f) * (_e8193 / (_e8193 - _e8266)));
                                                        if (_e8275 > _e8267) {
                                                            if (_e8275 < _e8269) {
                                                                phi_5377_ = _e8275;
                                                            } else {
                                                                phi_5377_ = _e8269;
                                                            }
                                                            let _e8279 = phi_5377_;
                                                            phi_5378_ = _e8279;
                                                        } else {
                                                            phi_5378_ = _e8267;
                                                        }
                                                        let _e8281 = phi_5378_;
                                                        phi_5379_ = _e8281;
                                                    }
                                                    let _e8283 = phi_5379_;
                                                    phi_5381_ = u32();
                                                    phi_5382_ = (_e7234 * _e8283);
                                                    phi_5383_ = true;
                                                    phi_5384_ = false;
                                                    phi_5385_ = false;
                                                }
                                                let _e8290 = phi_5381_;
                                                let _e8292 = phi_5382_;
                                                let _e8294 = phi_5383_;
                                                let _e8296 = phi_5384_;
                                                let _e8298 = phi_5385_;
                                                phi_5386_ = _e8290;
                                                phi_5387_ = _e6903;
                                                phi_5388_ = _e8292;
                                                phi_5389_ = _e6905;
                                                phi_5390_ = _e6907;
                                                phi_5391_ = _e6909;
                                                phi_5392_ = _e6911;
                                                phi_5393_ = _e8294;
                                                phi_5394_ = _e8296;
                                                phi_5395_ = _e8298;
                                                phi_5396_ = false;
                                                phi_5397_ = false;
                                                phi_5398_ = false;
                                            } else {
                                                phi_5386_ = u32();
                                                phi_5387_ = _e8103;
                                                phi_5388_ = _e8105;
                                                phi_5389_ = _e8107;
                                                phi_5390_ = _e6901;
                                                phi_5391_ = true;
                                                phi_5392_ = 0u;
                                                phi_5393_ = _e8113;
                                                phi_5394_ = false;
                                                phi_5395_ = false;
                                                phi_5396_ = _e8115;
                                                phi_5397_ = _e8117;
                                                phi_5398_ = _e8119;
                                            }
                                            let _e8300 = phi_5386_;
                                            let _e8302 = phi_5387_;
                                            let _e8304 = phi_5388_;
                                            let _e8306 = phi_5389_;
                                            let _e8308 = phi_5390_;
                                            let _e8310 = phi_5391_;
                                            let _e8312 = phi_5392_;
                                            let _e8314 = phi_5393_;
                                            let _e8316 = phi_5394_;
                                            let _e8318 = phi_5395_;
                                            let _e8320 = phi_5396_;
                                            let _e8322 = phi_5397_;
                                            let _e8324 = phi_5398_;
                                            if _e8314 {
                                                let _e8325 = (_e8308 + _e8304);
                                                if (_e8325 > _e8302) {
                                                    phi_5407_ = _e8325;
                                                } else {
                                                    phi_5407_ = _e8302;
                                                }
                                                let _e8328 = phi_5407_;
                                                if (_e8328 < _e419) {
                                                    phi_5412_ = _e8328;
                                                } else {
                                                    phi_5412_ = _e419;
                                                }
                                                let _e8331 = phi_5412_;
                                                if !(_e6909) {
                                                    phi_5421_ = true;
                                                } else {
                                                    phi_5421_ = ((_e8331 - _e8308) > _e6890);
                                                }
                                                let _e8335 = phi_5421_;
                                                if _e8335 {
                                                    phi_5425_ = false;
                                                } else {
                                                    phi_5425_ = true;
                                                }
                                                let _e8337 = phi_5425_;
                                                phi_5426_ = _e8331;
                                                phi_5427_ = _e8302;
                                                phi_5428_ = _e8306;
                                                phi_5429_ = _e8308;
                                                phi_5430_ = _e8310;
                                                phi_5431_ = _e8312;
                                                phi_5432_ = _e8335;
                                                phi_5433_ = _e8337;
                                                phi_5434_ = false;
                                                phi_5435_ = false;
                                                phi_5436_ = false;
                                                phi_5437_ = false;
                                            } else {
                                                phi_5426_ = _e6901;
                                                phi_5427_ = _e6903;
                                                phi_5428_ = _e6905;
                                                phi_5429_ = _e6907;
                                                phi_5430_ = _e6909;
                                                phi_5431_ = _e8300;
                                                phi_5432_ = _e8316;
                                                phi_5433_ = false;
                                                phi_5434_ = _e8318;
                                                phi_5435_ = _e8320;
                                                phi_5436_ = _e8322;
                                                phi_5437_ = _e8324;
                                            }
                                            let _e8339 = phi_5426_;
                                            let _e8341 = phi_5427_;
                                            let _e8343 = phi_5428_;
                                            let _e8345 = phi_5429_;
                                            let _e8347 = phi_5430_;
                                            let _e8349 = phi_5431_;
                                            let _e8351 = phi_5432_;
                                            let _e8353 = phi_5433_;
                                            let _e8355 = phi_5434_;
                                            let _e8357 = phi_5435_;
                                            let _e8359 = phi_5436_;
                                            let _e8361 = phi_5437_;
                                            phi_3216_ = _e8339;
                                            phi_3218_ = _e8341;
                                            phi_3220_ = _e8343;
                                            phi_3222_ = _e8345;
                                            phi_3224_ = _e8347;
                                            phi_3226_ = _e8349;
                                            phi_5438_ = _e8302;
                                            phi_5439_ = _e8109;
                                            phi_5440_ = _e8351;
                                            phi_5441_ = _e8353;
                                            phi_5442_ = _e8355;
                                            phi_5443_ = _e8357;
                                            phi_5444_ = _e8359;
                                            phi_5445_ = false;
                                            phi_5446_ = _e8361;
                                        } else {
                                            phi_3216_ = f64();
                                            phi_3218_ = f64();
                                            phi_3220_ = f64();
                                            phi_3222_ = f64();
                                            phi_3224_ = bool();
                                            phi_3226_ = u32();
                                            phi_5438_ = f64();
                                            phi_5439_ = f64();
                                            phi_5440_ = false;
                                            phi_5441_ = false;
                                            phi_5442_ = false;
                                            phi_5443_ = false;
                                            phi_5444_ = false;
                                            phi_5445_ = true;
                                            phi_5446_ = false;
                                        }
                                        let _e8363 = phi_3216_;
                                        let _e8365 = phi_3218_;
                                        let _e8367 = phi_3220_;
                                        let _e8369 = phi_3222_;
                                        let _e8371 = phi_3224_;
                                        let _e8373 = phi_3226_;
                                        let _e8375 = phi_5438_;
                                        let _e8377 = phi_5439_;
                                        let _e8379 = phi_5440_;
                                        let _e8381 = phi_5441_;
                                        let _e8383 = phi_5442_;
                                        let _e8385 = phi_5443_;
                                        let _e8387 = phi_5444_;
                                        let _e8389 = phi_5445_;
                                        let _e8391 = phi_5446_;
                                        local_43 = _e8381;
                                        local_81 = _e8383;
                                        local_82 = _e8385;
                                        local_83 = _e8387;
                                        local_84 = _e8389;
                                        local_85 = _e8391;
                                        local_86 = _e8381;
                                        local_87 = _e8377;
                                        local_88 = _e8375;
                                        continue;
                                        continuing {
                                            phi_3212_ = _e6923;
                                            phi_3215_ = _e8363;
                                            phi_3217_ = _e8365;
                                            phi_3219_ = _e8367;
                                            phi_3221_ = _e8369;
                                            phi_3223_ = _e8371;
                                            phi_3225_ = _e8373;
                                            break if !(_e8379);
                                        }
                                    }
                                    let _e8394 = local_43;
                                    if _e8394 {
                                        phi_5450_ = false;
                                        phi_5451_ = false;
                                        phi_5452_ = false;
                                        phi_5453_ = false;
                                        phi_5454_ = false;
                                    } else {
                                        let _e11860 = local_81;
                                        phi_5450_ = _e11860;
                                        let _e11863 = local_82;
                                        phi_5451_ = _e11863;
                                        let _e11866 = local_83;
                                        phi_5452_ = _e11866;
                                        let _e11869 = local_84;
                                        phi_5453_ = _e11869;
                                        let _e11872 = local_85;
                                        phi_5454_ = _e11872;
                                    }
                                    let _e8396 = phi_5450_;
                                    let _e8398 = phi_5451_;
                                    let _e8400 = phi_5452_;
                                    let _e8402 = phi_5453_;
                                    let _e8404 = phi_5454_;
                                    if _e8396 {
                                        let _e8406 = local_44;
                                        phi_5459_ = type_46(1u, _e8406);
                                        phi_5460_ = false;
                                        phi_5461_ = false;
                                        phi_5462_ = false;
                                        phi_5463_ = false;
                                        phi_5464_ = false;
                                    } else {
                                        phi_5459_ = type_46();
                                        phi_5460_ = _e8398;
                                        phi_5461_ = _e8400;
                                        let _e11879 = local_86;
                                        phi_5462_ = _e11879;
                                        phi_5463_ = _e8402;
                                        phi_5464_ = _e8404;
                                    }
                                    let _e8409 = phi_5459_;
                                    let _e8411 = phi_5460_;
                                    let _e8413 = phi_5461_;
                                    let _e8415 = phi_5462_;
                                    let _e8417 = phi_5463_;
                                    let _e8419 = phi_5464_;
                                    if _e8411 {
                                        phi_5469_ = type_46(0u, type_46().member_1);
                                        phi_5470_ = false;
                                        phi_5471_ = false;
                                        phi_5472_ = false;
                                        phi_5473_ = false;
                                        phi_5474_ = true;
                                    } else {
                                        phi_5469_ = _e8409;
                                        phi_5470_ = _e8413;
                                        phi_5471_ = _e8415;
                                        phi_5472_ = _e8417;
                                        phi_5473_ = _e8419;
                                        phi_5474_ = _e8396;
                                    }
                                    let _e8423 = phi_5469_;
                                    let _e8425 = phi_5470_;
                                    let _e8427 = phi_5471_;
                                    let _e8429 = phi_5472_;
                                    let _e8431 = phi_5473_;
                                    let _e8433 = phi_5474_;
                                    if _e8425 {
                                        let _e11890 = local_87;
                                        phi_5478_ = _e11890;
                                        phi_5479_ = true;
                                        phi_5480_ = false;
                                        phi_5481_ = false;
                                        phi_5482_ = false;
                                    } else {
                                        let _e11892 = local_88;
                                        phi_5478_ = _e11892;
                                        phi_5479_ = _e8427;
                                        phi_5480_ = _e8429;
                                        phi_5481_ = _e8431;
                                        phi_5482_ = _e8433;
                                    }
                                    let _e8435 = phi_5478_;
                                    let _e8437 = phi_5479_;
                                    let _e8439 = phi_5480_;
                                    let _e8441 = phi_5481_;
                                    let _e8443 = phi_5482_;
                                    if _e8437 {
                                        phi_5486_ = _e8435;
                                        phi_5487_ = true;
                                        phi_5488_ = false;
                                        phi_5489_ = false;
                                    } else {
                                        let _e11899 = local_89;
                                        phi_5486_ = _e11899;
                                        phi_5487_ = _e8439;
                                        phi_5488_ = _e8441;
                                        phi_5489_ = _e8443;
                                    }
                                    let _e8445 = phi_5486_;
                                    let _e8447 = phi_5487_;
                                    let _e8449 = phi_5488_;
                                    let _e8451 = phi_5489_;
                                    if _e8447 {
                                        phi_5494_ = type_46(1u, _e8445);
                                        phi_5495_ = false;
                                        phi_5496_ = false;
                                    } else {
                                        phi_5494_ = type_46();
                                        phi_5495_ = _e8449;
                                        phi_5496_ = _e8451;
                                    }
                                    let _e8454 = phi_5494_;
                                    let _e8456 = phi_5495_;
                                    let _e8458 = phi_5496_;
                                    if _e8456 {
                                        phi_5501_ = type_46(0u, type_46().member_1);
                                        phi_5502_ = true;
                                    } else {
                                        phi_5501_ = _e8423;
                                        phi_5502_ = _e8458;
                                    }
                                    let _e8462 = phi_5501_;
                                    let _e8464 = phi_5502_;
                                    if _e8464 {
                                        phi_5506_ = _e8462;
                                    } else {
                                        phi_5506_ = _e8454;
                                    }
                                    let _e8466 = phi_5506_;
                                    phi_5513_ = _e8466.member_1;
                                    phi_5514_ = (_e8466.member != 0u);
                                } else {
                                    phi_5513_ = _e6627;
                                    phi_5514_ = true;
                                }
                                let _e8471 = phi_5513_;
                                let _e8473 = phi_5514_;
                                if _e8473 {
                                    let _e8474 = (_e8471 > _e410);
                                    if _e8474 {
                                        phi_7721_ = f64();
                                        phi_7722_ = u32();
                                        phi_7723_ = f64();
                                        phi_7724_ = type_48();
                                        phi_7725_ = u32();
                                        phi_7726_ = u32();
                                        phi_7727_ = false;
                                        phi_7728_ = false;
                                        phi_7729_ = false;
                                    } else {
                                        let _e8478 = local_18.member[0u];
                                        let _e8484 = local_18.member[1u];
                                        let _e8500 = local_18.member_1[0u];
                                        let _e8506 = local_18.member_1[1u];
                                        let _e8522 = local_18.member_2[0u];
                                        let _e8528 = local_18.member_2[1u];
                                        let _e8542 = function_3(array<f64, 3>((_e8478[0] + ((_e8484[0] - _e8478[0]) * _e6631)), (_e8478[1] + ((_e8484[1] - _e8478[1]) * _e6631)), (_e8478[2] + ((_e8484[2] - _e8478[2]) * _e6631))), array<f64, 3>((_e8500[0] + ((_e8506[0] - _e8500[0]) * _e6631)), (_e8500[1] + ((_e8506[1] - _e8500[1]) * _e6631)), (_e8500[2] + ((_e8506[2] - _e8500[2]) * _e6631))), array<f64, 3>((_e8522[0] + ((_e8528[0] - _e8522[0]) * _e6631)), (_e8522[1] + ((_e8528[1] - _e8522[1]) * _e6631)), (_e8522[2] + ((_e8528[2] - _e8522[2]) * _e6631))), 0u);
                                        if (_e8542[0] < 0.0lf) {
                                            phi_5627_ = -(_e8542[0]);
                                        } else {
                                            phi_5627_ = _e8542[0];
                                        }
                                        let _e8547 = phi_5627_;
                                        if (_e8542[1] < 0.0lf) {
                                            phi_5634_ = -(_e8542[1]);
                                        } else {
                                            phi_5634_ = _e8542[1];
                                        }
                                        let _e8552 = phi_5634_;
                                        if (_e8542[2] < 0.0lf) {
                                            phi_5642_ = -(_e8542[2]);
                                        } else {
                                            phi_5642_ = _e8542[2];
                                        }
                                        let _e8558 = phi_5642_;
                                        let _e8559 = ((_e8547 + _e8552) + _e8558);
                                        let _e8562 = local_18.member[0u];
                                        let _e8568 = local_18.member_1[0u];
                                        let _e8574 = local_18.member_2[0u];
                                        let _e8586 = local_18.member[1u];
                                        let _e8592 = local_18.member_1[1u];
                                        let _e8598 = local_18.member_2[1u];
                                        let _e8610 = local_18.member[0u];
                                        if (_e8610[0] < 0.0lf) {
                                            phi_5793_ = -(_e8610[0]);
                                        } else {
                                            phi_5793_ = _e8610[0];
                                        }
                                        let _e8617 = phi_5793_;
                                        if (_e8610[1] < 0.0lf) {
                                            phi_5800_ = -(_e8610[1]);
                                        } else {
                                            phi_5800_ = _e8610[1];
                                        }
                                        let _e8621 = phi_5800_;
                                        if (_e8617 > _e8621) {
                                            phi_5805_ = _e8617;
                                        } else {
                                            phi_5805_ = _e8621;
                                        }
                                        let _e8624 = phi_5805_;
                                        if (_e8610[2] < 0.0lf) {
                                            phi_5812_ = -(_e8610[2]);
                                        } else {
                                            phi_5812_ = _e8610[2];
                                        }
                                        let _e8628 = phi_5812_;
                                        if (_e8624 > _e8628) {
                                            phi_5817_ = _e8624;
                                        } else {
                                            phi_5817_ = _e8628;
                                        }
                                        let _e8631 = phi_5817_;
                                        let _e8634 = local_18.member[1u];
                                        if (_e8634[0] < 0.0lf) {
                                            phi_5830_ = -(_e8634[0]);
                                        } else {
                                            phi_5830_ = _e8634[0];
                                        }
                                        let _e8641 = phi_5830_;
                                        if (_e8634[1] < 0.0lf) {
                                            phi_5837_ = -(_e8634[1]);
                                        } else {
                                            phi_5837_ = _e8634[1];
                                        }
                                        let _e8645 = phi_5837_;
                                        if (_e8641 > _e8645) {
                                            phi_5842_ = _e8641;
                                        } else {
                                            phi_5842_ = _e8645;
                                        }
                                        let _e8648 = phi_5842_;
                                        if (_e8634[2] < 0.0lf) {
                                            phi_5849_ = -(_e8634[2]);
                                        } else {
                                            phi_5849_ = _e8634[2];
                                        }
                                        let _e8652 = phi_5849_;
                                        if (_e8648 > _e8652) {
                                            phi_5854_ = _e8648;
                                        } else {
                                            phi_5854_ = _e8652;
                                        }
                                        let _e8655 = phi_5854_;
                                        if (_e8631 > _e8655) {
                                            phi_5859_ = _e8631;
                                        } else {
                                            phi_5859_ = _e8655;
                                        }
                                        let _e8658 = phi_5859_;
                                        let _e8660 = local_18.member_3;
                                        let _e8664 = local_18.member_1[0u];
                                        if (_e8664[0] < 0.0lf) {
                                            phi_5876_ = -(_e8664[0]);
                                        } else {
                                            phi_5876_ = _e8664[0];
                                        }
                                        let _e8671 = phi_5876_;
                                        if (_e8664[1] < 0.0lf) {
                                            phi_5883_ = -(_e8664[1]);
                                        } else {
                                            phi_5883_ = _e8664[1];
                                        }
                                        let _e8675 = phi_5883_;
                                        if (_e8671 > _e8675) {
                                            phi_5888_ = _e8671;
                                        } else {
                                            phi_5888_ = _e8675;
                                        }
                                        let _e8678 = phi_5888_;
                                        if (_e8664[2] < 0.0lf) {
                                            phi_5895_ = -(_e8664[2]);
                                        } else {
                                            phi_5895_ = _e8664[2];
                                        }
                                        let _e8682 = phi_5895_;
                                        if (_e8678 > _e8682) {
                                            phi_5900_ = _e8678;
                                        } else {
                                            phi_5900_ = _e8682;
                                        }
                                        let _e8685 = phi_5900_;
                                        let _e8688 = local_18.member_1[1u];
                                        if (_e8688[0] < 0.0lf) {
                                            phi_5914_ = -(_e8688[0]);
                                        } else {
                                            phi_5914_ = _e8688[0];
                                        }
                                        let _e8695 = phi_5914_;
                                        if (_e8688[1] < 0.0lf) {
                                            phi_5921_ = -(_e8688[1]);
                                        } else {
                                            phi_5921_ = _e8688[1];
                                        }
                                        let _e8699 = phi_5921_;
                                        if (_e8695 > _e8699) {
                                            phi_5926_ = _e8695;
                                        } else {
                                            phi_5926_ = _e8699;
                                        }
                                        let _e8702 = phi_5926_;
                                        if (_e8688[2] < 0.0lf) {
                                            phi_5933_ = -(_e8688[2]);
                                        } else {
                                            phi_5933_ = _e8688[2];
                                        }
                                        let _e8706 = phi_5933_;
                                        if (_e8702 > _e8706) {
                                            phi_5938_ = _e8702;
                                        } else {
                                            phi_5938_ = _e8706;
                                        }
                                        let _e8709 = phi_5938_;
                                        if (_e8685 > _e8709) {
                                            phi_5943_ = _e8685;
                                        } else {
                                            phi_5943_ = _e8709;
                                        }
                                        let _e8712 = phi_5943_;
                                        let _e8714 = local_18.member_3;
                                        let _e8718 = local_18.member_2[0u];
                                        if (_e8718[0] < 0.0lf) {
                                            phi_5960_ = -(_e8718[0]);
                                        } else {
                                            phi_5960_ = _e8718[0];
                                        }
                                        let _e8725 = phi_5960_;
                                        if (_e8718[1] < 0.0lf) {
                                            phi_5967_ = -(_e8718[1]);
                                        } else {
                                            phi_5967_ = _e8718[1];
                                        }
                                        let _e8729 = phi_5967_;
                                        if (_e8725 > _e8729) {
                                            phi_5972_ = _e8725;
                                        } else {
                                            phi_5972_ = _e8729;
                                        }
                                        let _e8732 = phi_5972_;
                                        if (_e8718[2] < 0.0lf) {
                                            phi_5979_ = -(_e8718[2]);
                                        } else {
                                            phi_5979_ = _e8718[2];
                                        }
                                        let _e8736 = phi_5979_;
                                        if (_e8732 > _e8736) {
                                            phi_5984_ = _e8732;
                                        } else {
                                            phi_5984_ = _e8736;
                                        }
                                        let _e8739 = phi_5984_;
                                        let _e8742 = local_18.member_2[1u];
                                        if (_e8742[0] < 0.0lf) {
                                            phi_5998_ = -(_e8742[0]);
                                        } else {
                                            phi_5998_ = _e8742[0];
                                        }
                                        let _e8749 = phi_5998_;
                                        if (_e8742[1] < 0.0lf) {
                                            phi_6005_ = -(_e8742[1]);
                                        } else {
                                            phi_6005_ = _e8742[1];
                                        }
                                        let _e8753 = phi_6005_;
                                        if (_e8749 > _e8753) {
                                            phi_6010_ = _e8749;
                                        } else {
                                            phi_6010_ = _e8753;
                                        }
                                        let _e8756 = phi_6010_;
                                        if (_e8742[2] < 0.0lf) {
                                            phi_6017_ = -(_e8742[2]);
                                        } else {
                                            phi_6017_ = _e8742[2];
                                        }
                                        let _e8760 = phi_6017_;
                                        if (_e8756 > _e8760) {
                                            phi_6022_ = _e8756;
                                        } else {
                                            phi_6022_ = _e8760;
                                        }
                                        let _e8763 = phi_6022_;
                                        if (_e8739 > _e8763) {
                                            phi_6027_ = _e8739;
                                        } else {
                                            phi_6027_ = _e8763;
                                        }
                                        let _e8766 = phi_6027_;
                                        let _e8768 = local_18.member_3;
                                        let _e8776 = local_18.member_3;
                                        local_14 = type_44(array<array<array<f64, 3>, 4>, 2>(array<array<f64, 3>, 4>(_e8562, array<f64, 3>((_e8562[0] - _e8568[0]), (_e8562[1] - _e8568[1]), (_e8562[2] - _e8568[2])), array<f64, 3>((_e8562[0] - _e8574[0]), (_e8562[1] - _e8574[1]), (_e8562[2] - _e8574[2])), _e8562), array<array<f64, 3>, 4>(_e8586, array<f64, 3>((_e8586[0] - _e8592[0]), (_e8586[1] - _e8592[1]), (_e8586[2] - _e8592[2])), array<f64, 3>((_e8586[0] - _e8598[0]), (_e8586[1] - _e8598[1]), (_e8586[2] - _e8598[2])), _e8586)), ((((((_e8658 + _e8660) + (_e8712 + _e8714)) + (_e8766 + _e8768)) * (1.1102230246251565e-16lf * f64(16f))) + (_e8776 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))), _e620.member_1);
                                        let _e8792 = local_14.member_1;
                                        if (_e8559 > _e8792) {
                                            if ((bitcast<u64>(_e8559) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e8798 = (f64(1f) / _e8559);
                                                let _e8800 = (_e8542[0] * _e8798);
                                                let _e8802 = (_e8542[1] * _e8798);
                                                let _e8804 = (_e8542[2] * _e8798);
                                                let _e8809 = (((_e8800 * _e8800) + (_e8802 * _e8802)) + (_e8804 * _e8804));
                                                if (_e8809 <= 2.2250738585072014e-308lf) {
                                                    if (_e8809 > 0.0lf) {
                                                        phi_6132_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6132_ = 0.0lf;
                                                    }
                                                    let _e8861 = phi_6132_;
                                                    phi_6196_ = _e8861;
                                                } else {
                                                    phi_6139_ = type_16(0i, 5i);
                                                    phi_6142_ = bitcast<f64>(((bitcast<u64>(_e8809) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e8816 = phi_6139_;
                                                        let _e8818 = phi_6142_;
                                                        local_45 = _e8818;
                                                        if (_e8816.member < _e8816.member_1) {
                                                            let _e8825 = (_e8816.member + 1i);
                                                            if ((false == (_e8825 > _e8816.member)) != false) {
                                                                phi_6163_ = true;
                                                            } else {
                                                                phi_6163_ = false;
                                                            }
                                                            let _e8830 = phi_6163_;
                                                            if _e8830 {
                                                                phi_6169_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_6169_ = type_17(1u, _e8825);
                                                            }
                                                            let _e8835 = phi_6169_;
                                                            phi_6140_ = type_16(_e8835.member_1, _e8816.member_1);
                                                            phi_6183_ = type_17(1u, _e8816.member);
                                                        } else {
                                                            phi_6140_ = _e8816;
                                                            phi_6183_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e8841 = phi_6140_;
                                                        let _e8843 = phi_6183_;
                                                        let _e8846 = (bitcast<i32>(_e8843.member) != 0i);
                                                        if _e8846 {
                                                            phi_6143_ = (0.5lf * (_e8818 + (_e8809 / _e8818)));
                                                        } else {
                                                            phi_6143_ = f64();
                                                        }
                                                        let _e8851 = phi_6143_;
                                                        continue;
                                                        continuing {
                                                            phi_6139_ = _e8841;
                                                            phi_6142_ = _e8851;
                                                            break if !(_e8846);
                                                        }
                                                    }
                                                    let _e8856 = local_45;
                                                    phi_6196_ = (_e8856 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e8863 = phi_6196_;
                                                let _e8865 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e8867 = local_14.member_1;
                                                let _e8871 = local_14.member_2;
                                                let _e8876 = ((_e8867 * f64(1.01f)) + ((_e8871 * _e8863) * (f64(1f) + _e8865)));
                                                let _e8880 = local_14.member[0u][0u];
                                                let _e8888 = (((_e8800 * _e8880[0]) + (_e8802 * _e8880[1])) + (_e8804 * _e8880[2]));
                                                let _e8892 = local_14.member[0u][1u];
                                                let _e8900 = (((_e8800 * _e8892[0]) + (_e8802 * _e8892[1])) + (_e8804 * _e8892[2]));
                                                let _e8904 = local_14.member[0u][2u];
                                                let _e8912 = (((_e8800 * _e8904[0]) + (_e8802 * _e8904[1])) + (_e8804 * _e8904[2]));
                                                let _e8916 = local_14.member[0u][3u];
                                                let _e8924 = (((_e8800 * _e8916[0]) + (_e8802 * _e8916[1])) + (_e8804 * _e8916[2]));
                                                let _e8928 = local_14.member[1u][0u];
                                                let _e8936 = (((_e8800 * _e8928[0]) + (_e8802 * _e8928[1])) + (_e8804 * _e8928[2]));
                                                let _e8940 = local_14.member[1u][1u];
                                                let _e8948 = (((_e8800 * _e8940[0]) + (_e8802 * _e8940[1])) + (_e8804 * _e8940[2]));
                                                let _e8952 = local_14.member[1u][2u];
                                                let _e8960 = (((_e8800 * _e8952[0]) + (_e8802 * _e8952[1])) + (_e8804 * _e8952[2]));
                                                let _e8964 = local_14.member[1u][3u];
                                                let _e8972 = (((_e8800 * _e8964[0]) + (_e8802 * _e8964[1])) + (_e8804 * _e8964[2]));
                                                if (_e8888 < 0.0lf) {
                                                    phi_6333_ = -(_e8888);
                                                } else {
                                                    phi_6333_ = _e8888;
                                                }
                                                let _e8976 = phi_6333_;
                                                if (_e8936 < 0.0lf) {
                                                    phi_6339_ = -(_e8936);
                                                } else {
                                                    phi_6339_ = _e8936;
                                                }
                                                let _e8980 = phi_6339_;
                                                if (_e8900 < 0.0lf) {
                                                    phi_6348_ = -(_e8900);
                                                } else {
                                                    phi_6348_ = _e8900;
                                                }
                                                let _e8987 = phi_6348_;
                                                if (_e8948 < 0.0lf) {
                                                    phi_6354_ = -(_e8948);
                                                } else {
                                                    phi_6354_ = _e8948;
                                                }
                                                let _e8991 = phi_6354_;
                                                if (_e8912 < 0.0lf) {
                                                    phi_6363_ = -(_e8912);
                                                } else {
                                                    phi_6363_ = _e8912;
                                                }
                                                let _e8998 = phi_6363_;
                                                if (_e8960 < 0.0lf) {
                                                    phi_6369_ = -(_e8960);
                                                } else {
                                                    phi_6369_ = _e8960;
                                                }
                                                let _e9002 = phi_6369_;
                                                if (_e8924 < 0.0lf) {
                                                    phi_6378_ = -(_e8924);
                                                } else {
                                                    phi_6378_ = _e8924;
                                                }
                                                let _e9009 = phi_6378_;
                                                if (_e8972 < 0.0lf) {
                                                    phi_6384_ = -(_e8972);
                                                } else {
                                                    phi_6384_ = _e8972;
                                                }
                                                let _e9013 = phi_6384_;
                                                local_15 = type_38(array<f64, 4>(_e8888, _e8900, _e8912, _e8924), array<f64, 4>(_e8936, _e8948, _e8960, _e8972), array<f64, 4>((_e8876 + ((_e8976 + _e8980) * _e8865)), (_e8876 + ((_e8987 + _e8991) * _e8865)), (_e8876 + ((_e8998 + _e9002) * _e8865)), (_e8876 + ((_e9009 + _e9013) * _e8865))));
                                                let _e9025 = (((_e8800 * _e8800) + (_e8802 * _e8802)) + (_e8804 * _e8804));
                                                if (_e9025 <= 2.2250738585072014e-308lf) {
                                                    if (_e9025 > 0.0lf) {
                                                        phi_6427_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6427_ = 0.0lf;
                                                    }
                                                    let _e9077 = phi_6427_;
                                                    phi_6491_ = _e9077;
                                                } else {
                                                    phi_6434_ = type_16(0i, 5i);
                                                    phi_6437_ = bitcast<f64>(((bitcast<u64>(_e9025) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9032 = phi_6434_;
                                                        let _e9034 = phi_6437_;
                                                        local_46 = _e9034;
                                                        if (_e9032.member < _e9032.member_1) {
                                                            let _e9041 = (_e9032.member + 1i);
                                                            if ((false == (_e9041 > _e9032.member)) != false) {
                                                                phi_6458_ = true;
                                                            } else {
                                                                phi_6458_ = false;
                                                            }
                                                            let _e9046 = phi_6458_;
                                                            if _e9046 {
                                                                phi_6464_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_6464_ = type_17(1u, _e9041);
                                                            }
                                                            let _e9051 = phi_6464_;
                                                            phi_6435_ = type_16(_e9051.member_1, _e9032.member_1);
                                                            phi_6478_ = type_17(1u, _e9032.member);
                                                        } else {
                                                            phi_6435_ = _e9032;
                                                            phi_6478_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e9057 = phi_6435_;
                                                        let _e9059 = phi_6478_;
                                                        let _e9062 = (bitcast<i32>(_e9059.member) != 0i);
                                                        if _e9062 {
                                                            phi_6438_ = (0.5lf * (_e9034 + (_e9025 / _e9034)));
                                                        } else {
                                                            phi_6438_ = f64();
                                                        }
                                                        let _e9067 = phi_6438_;
                                                        continue;
                                                        continuing {
                                                            phi_6434_ = _e9057;
                                                            phi_6437_ = _e9067;
                                                            break if !(_e9062);
                                                        }
                                                    }
                                                    let _e9072 = local_46;
                                                    phi_6491_ = (_e9072 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9079 = phi_6491_;
                                                let _e9090 = (((_e8542[0] * _e8542[0]) + (_e8542[1] * _e8542[1])) + (_e8542[2] * _e8542[2]));
                                                if (_e9090 <= 2.2250738585072014e-308lf) {
                                                    if (_e9090 > 0.0lf) {
                                                        phi_6516_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6516_ = 0.0lf;
                                                    }
                                                    let _e9142 = phi_6516_;
                                                    phi_6580_ = _e9142;
                                                } else {
                                                    phi_6523_ = type_16(0i, 5i);
                                                    phi_6526_ = bitcast<f64>(((bitcast<u64>(_e9090) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9097 = phi_6523_;
                                                        let _e9099 = phi_6526_;
                                                        local_47 = _e9099;
                                                        if (_e9097.member < _e9097.member_1) {
                                                            let _e9106 = (_e9097.member + 1i);
                                                            if ((false == (_e9106 > _e9097.member)) != false) {
                                                                phi_6547_ = true;
                                                            } else {
                                                                phi_6547_ = false;
                                                            }
                                                            let _e9111 = phi_6547_;
                                                            if _e9111 {
                                                                phi_6553_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_6553_ = type_17(1u, _e9106);
                                                            }
                                                            let _e9116 = phi_6553_;
                                                            phi_6524_ = type_16(_e9116.member_1, _e9097.member_1);
                                                            phi_6567_ = type_17(1u, _e9097.member);
                                                        } else {
                                                            phi_6524_ = _e9097;
                                                            phi_6567_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e9122 = phi_6524_;
                                                        let _e9124 = phi_6567_;
                                                        let _e9127 = (bitcast<i32>(_e9124.member) != 0i);
                                                        if _e9127 {
                                                            phi_6527_ = (0.5lf * (_e9099 + (_e9090 / _e9099)));
                                                        } else {
                                                            phi_6527_ = f64();
                                                        }
                                                        let _e9132 = phi_6527_;
                                                        continue;
                                                        continuing {
                                                            phi_6523_ = _e9122;
                                                            phi_6526_ = _e9132;
                                                            break if !(_e9127);
                                                        }
                                                    }
                                                    let _e9137 = local_47;
                                                    phi_6580_ = (_e9137 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9144 = phi_6580_;
                                                let _e9152 = local_18.member[0u];
                                                if (_e9152[0] < 0.0lf) {
                                                    phi_6598_ = -(_e9152[0]);
                                                } else {
                                                    phi_6598_ = _e9152[0];
                                                }
                                                let _e9159 = phi_6598_;
                                                if (_e9152[1] < 0.0lf) {
                                                    phi_6605_ = -(_e9152[1]);
                                                } else {
                                                    phi_6605_ = _e9152[1];
                                                }
                                                let _e9163 = phi_6605_;
                                                if (_e9159 > _e9163) {
                                                    phi_6610_ = _e9159;
                                                } else {
                                                    phi_6610_ = _e9163;
                                                }
                                                let _e9166 = phi_6610_;
                                                if (_e9152[2] < 0.0lf) {
                                                    phi_6617_ = -(_e9152[2]);
                                                } else {
                                                    phi_6617_ = _e9152[2];
                                                }
                                                let _e9170 = phi_6617_;
                                                if (_e9166 > _e9170) {
                                                    phi_6622_ = _e9166;
                                                } else {
                                                    phi_6622_ = _e9170;
                                                }
                                                let _e9173 = phi_6622_;
                                                let _e9176 = local_18.member[1u];
                                                if (_e9176[0] < 0.0lf) {
                                                    phi_6635_ = -(_e9176[0]);
                                                } else {
                                                    phi_6635_ = _e9176[0];
                                                }
                                                let _e9183 = phi_6635_;
                                                if (_e9176[1] < 0.0lf) {
                                                    phi_6642_ = -(_e9176[1]);
                                                } else {
                                                    phi_6642_ = _e9176[1];
                                                }
                                                let _e9187 = phi_6642_;
                                                if (_e9183 > _e9187) {
                                                    phi_6647_ = _e9183;
                                                } else {
                                                    phi_6647_ = _e9187;
                                                }
                                                let _e9190 = phi_6647_;
                                                if (_e9176[2] < 0.0lf) {
                                                    phi_6654_ = -(_e9176[2]);
                                                } else {
                                                    phi_6654_ = _e9176[2];
                                                }
                                                let _e9194 = phi_6654_;
                                                if (_e9190 > _e9194) {
                                                    phi_6659_ = _e9190;
                                                } else {
                                                    phi_6659_ = _e9194;
                                                }
                                                let _e9197 = phi_6659_;
                                                if (_e9173 > _e9197) {
                                                    phi_6664_ = _e9173;
                                                } else {
                                                    phi_6664_ = _e9197;
                                                }
                                                let _e9200 = phi_6664_;
                                                let _e9202 = local_18.member_3;
                                                let _e9206 = local_18.member_1[0u];
                                                if (_e9206[0] < 0.0lf) {
                                                    phi_6681_ = -(_e9206[0]);
                                                } else {
                                                    phi_6681_ = _e9206[0];
                                                }
                                                let _e9213 = phi_6681_;
                                                if (_e9206[1] < 0.0lf) {
                                                    phi_6688_ = -(_e9206[1]);
                                                } else {
                                                    phi_6688_ = _e9206[1];
                                                }
                                                let _e9217 = phi_6688_;
                                                if (_e9213 > _e9217) {
                                                    phi_6693_ = _e9213;
                                                } else {
                                                    phi_6693_ = _e9217;
                                                }
                                                let _e9220 = phi_6693_;
                                                if (_e9206[2] < 0.0lf) {
                                                    phi_6700_ = -(_e9206[2]);
                                                } else {
                                                    phi_6700_ = _e9206[2];
                                                }
                                                let _e9224 = phi_6700_;
                                                if (_e9220 > _e9224) {
                                                    phi_6705_ = _e9220;
                                                } else {
                                                    phi_6705_ = _e9224;
                                                }
                                                let _e9227 = phi_6705_;
                                                let _e9230 = local_18.member_1[1u];
                                                if (_e9230[0] < 0.0lf) {
                                                    phi_6719_ = -(_e9230[0]);
                                                } else {
                                                    phi_6719_ = _e9230[0];
                                                }
                                                let _e9237 = phi_6719_;
                                                if (_e9230[1] < 0.0lf) {
                                                    phi_6726_ = -(_e9230[1]);
                                                } else {
                                                    phi_6726_ = _e9230[1];
                                                }
                                                let _e9241 = phi_6726_;
                                                if (_e9237 > _e9241) {
                                                    phi_6731_ = _e9237;
                                                } else {
                                                    phi_6731_ = _e9241;
                                                }
                                                let _e9244 = phi_6731_;
                                                if (_e9230[2] < 0.0lf) {
                                                    phi_6738_ = -(_e9230[2]);
                                                } else {
                                                    phi_6738_ = _e9230[2];
                                                }
                                                let _e9248 = phi_6738_;
                                                if (_e9244 > _e9248) {
                                                    phi_6743_ = _e9244;
                                                } else {
                                                    phi_6743_ = _e9248;
                                                }
                                                let _e9251 = phi_6743_;
                                                if (_e9227 > _e9251) {
                                                    phi_6748_ = _e9227;
                                                } else {
                                                    phi_6748_ = _e9251;
                                                }
                                                let _e9254 = phi_6748_;
                                                let _e9256 = local_18.member_3;
                                                let _e9260 = local_18.member_2[0u];
                                                if (_e9260[0] < 0.0lf) {
                                                    phi_6765_ = -(_e9260[0]);
                                                } else {
                                                    phi_6765_ = _e9260[0];
                                                }
                                                let _e9267 = phi_6765_;
                                                if (_e9260[1] < 0.0lf) {
                                                    phi_6772_ = -(_e9260[1]);
                                                } else {
                                                    phi_6772_ = _e9260[1];
                                                }
                                                let _e9271 = phi_6772_;
                                                if (_e9267 > _e9271) {
                                                    phi_6777_ = _e9267;
                                                } else {
                                                    phi_6777_ = _e9271;
                                                }
                                                let _e9274 = phi_6777_;
                                                if (_e9260[2] < 0.0lf) {
                                                    phi_6784_ = -(_e9260[2]);
                                                } else {
                                                    phi_6784_ = _e9260[2];
                                                }
                                                let _e9278 = phi_6784_;
                                                if (_e9274 > _e9278) {
                                                    phi_6789_ = _e9274;
                                                } else {
                                                    phi_6789_ = _e9278;
                                                }
                                                let _e9281 = phi_6789_;
                                                let _e9284 = local_18.member_2[1u];
                                                if (_e9284[0] < 0.0lf) {
                                                    phi_6803_ = -(_e9284[0]);
                                                } else {
                                                    phi_6803_ = _e9284[0];
                                                }
                                                let _e9291 = phi_6803_;
                                                if (_e9284[1] < 0.0lf) {
                                                    phi_6810_ = -(_e9284[1]);
                                                } else {
                                                    phi_6810_ = _e9284[1];
                                                }
                                                let _e9295 = phi_6810_;
                                                if (_e9291 > _e9295) {
                                                    phi_6815_ = _e9291;
                                                } else {
                                                    phi_6815_ = _e9295;
                                                }
                                                let _e9298 = phi_6815_;
                                                if (_e9284[2] < 0.0lf) {
                                                    phi_6822_ = -(_e9284[2]);
                                                } else {
                                                    phi_6822_ = _e9284[2];
                                                }
                                                let _e9302 = phi_6822_;
                                                if (_e9298 > _e9302) {
                                                    phi_6827_ = _e9298;
                                                } else {
                                                    phi_6827_ = _e9302;
                                                }
                                                let _e9305 = phi_6827_;
                                                if (_e9281 > _e9305) {
                                                    phi_6832_ = _e9281;
                                                } else {
                                                    phi_6832_ = _e9305;
                                                }
                                                let _e9308 = phi_6832_;
                                                let _e9310 = local_18.member_3;
                                                let _e9318 = local_18.member_3;
                                                let _e9333 = ((((_e9144 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e9200 + _e9202) + (_e9254 + _e9256)) + (_e9308 + _e9310)) * (1.1102230246251565e-16lf * f64(16f))) + (_e9318 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) * _e9079) * (f64(1f) + (1.1102230246251565e-16lf * f64(64f))));
                                                let _e9336 = local_15.member[0u];
                                                let _e9339 = local_15.member_1[0u];
                                                if (_e9336 < 0.0lf) {
                                                    phi_6880_ = -(_e9336);
                                                } else {
                                                    phi_6880_ = _e9336;
                                                }
                                                let _e9345 = phi_6880_;
                                                if (_e9339 < 0.0lf) {
                                                    phi_6886_ = -(_e9339);
                                                } else {
                                                    phi_6886_ = _e9339;
                                                }
                                                let _e9349 = phi_6886_;
                                                phi_6898_ = type_12(1u, 4u);
                                                phi_6901_ = ((_e9336 + ((_e9339 - _e9336) * _e6631)) - ((_e8792 * f64(1.01f)) + ((_e9345 + _e9349) * (1.1102230246251565e-16lf * f64(12f)))));
                                                loop {
                                                    let _e9360 = phi_6898_;
                                                    let _e9362 = phi_6901_;
                                                    local_48 = _e9362;
                                                    local_49 = _e9362;
                                                    if (_e9360.member < _e9360.member_1) {
                                                        phi_6899_ = type_12((_e9360.member + 1u), _e9360.member_1);
                                                        phi_6924_ = type_12(1u, _e9360.member);
                                                    } else {
                                                        phi_6899_ = _e9360;
                                                        phi_6924_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e9374 = phi_6899_;
                                                    let _e9376 = phi_6924_;
                                                    let _e9380 = (bitcast<i32>(_e9376.member) != 0i);
                                                    if _e9380 {
                                                        let _e9383 = local_15.member[_e9376.member_1];
                                                        let _e9386 = local_15.member_1[_e9376.member_1];
                                                        if (_e9383 < 0.0lf) {
                                                            phi_6954_ = -(_e9383);
                                                        } else {
                                                            phi_6954_ = _e9383;
                                                        }
                                                        let _e9392 = phi_6954_;
                                                        if (_e9386 < 0.0lf) {
                                                            phi_6960_ = -(_e9386);
                                                        } else {
                                                            phi_6960_ = _e9386;
                                                        }
                                                        let _e9396 = phi_6960_;
                                                        let _e9405 = ((_e9383 + ((_e9386 - _e9383) * _e6631)) - ((_e8792 * f64(1.01f)) + ((_e9392 + _e9396) * (1.1102230246251565e-16lf * f64(12f)))));
                                                        if (_e9362 < _e9405) {
                                                            phi_6974_ = _e9362;
                                                        } else {
                                                            phi_6974_ = _e9405;
                                                        }
                                                        let _e9408 = phi_6974_;
                                                        phi_6902_ = _e9408;
                                                    } else {
                                                        phi_6902_ = f64();
                                                    }
                                                    let _e9410 = phi_6902_;
                                                    continue;
                                                    continuing {
                                                        phi_6898_ = _e9374;
                                                        phi_6901_ = _e9410;
                                                        break if !(_e9380);
                                                    }
                                                }
                                                let _e9413 = local_48;
                                                if (_e9413 > f64(0f)) {
                                                    let _e9418 = local_49;
                                                    let _e9422 = (((_e9333 - _e9418) / _e9333) * f64(2.02f));
                                                    if (_e9422 <= 2.2250738585072014e-308lf) {
                                                        if (_e9422 > 0.0lf) {
                                                            phi_6996_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_6996_ = 0.0lf;
                                                        }
                                                        let _e9474 = phi_6996_;
                                                        phi_7060_ = _e9474;
                                                    } else {
                                                        phi_7003_ = type_16(0i, 5i);
                                                        phi_7006_ = bitcast<f64>(((bitcast<u64>(_e9422) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e9429 = phi_7003_;
                                                            let _e9431 = phi_7006_;
                                                            local_50 = _e9431;
                                                            if (_e9429.member < _e9429.member_1) {
                                                                let _e9438 = (_e9429.member + 1i);
                                                                if ((false == (_e9438 > _e9429.member)) != false) {
                                                                    phi_7027_ = true;
                                                                } else {
                                                                    phi_7027_ = false;
                                                                }
                                                                let _e9443 = phi_7027_;
                                                                if _e9443 {
                                                                    phi_7033_ = type_17(0u, type_17().member_1);
                                                                } else {
                                                                    phi_7033_ = type_17(1u, _e9438);
                                                                }
                                                                let _e9448 = phi_7033_;
                                                                phi_7004_ = type_16(_e9448.member_1, _e9429.member_1);
                                                                phi_7047_ = type_17(1u, _e9429.member);
                                                            } else {
                                                                phi_7004_ = _e9429;
                                                                phi_7047_ = type_17(0u, type_17().member_1);
                                                            }
                                                            let _e9454 = phi_7004_;
                                                            let _e9456 = phi_7047_;
                                                            let _e9459 = (bitcast<i32>(_e9456.member) != 0i);
                                                            if _e9459 {
                                                                phi_7007_ = (0.5lf * (_e9431 + (_e9422 / _e9431)));
                                                            } else {
                                                                phi_7007_ = f64();
                                                            }
                                                            let _e9464 = phi_7007_;
                                                            continue;
                                                            continuing {
                                                                phi_7003_ = _e9454;
                                                                phi_7006_ = _e9464;
                                                                break if !(_e9459);
                                                            }
                                                        }
                                                        let _e9469 = local_50;
                                                        phi_7060_ = (_e9469 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e9476 = phi_7060_;
                                                    let _e9479 = ((_e9476 * _e9079) * f64(1.01f));
                                                    phi_7067_ = type_12(0u, 4u);
                                                    phi_7070_ = f64(2f);
                                                    phi_7072_ = true;
                                                    phi_7074_ = true;
                                                    loop {
                                                        let _e9482 = phi_7067_;
                                                        let _e9484 = phi_7070_;
                                                        let _e9486 = phi_7072_;
                                                        let _e9488 = phi_7074_;
                                                        local_51 = _e9484;
                                                        local_90 = _e9484;
                                                        local_52 = _e9486;
                                                        local_53 = _e9488;
                                                        local_91 = _e9488;
                                                        local_54 = _e9488;
                                                        if (_e9482.member < _e9482.member_1) {
                                                            phi_7068_ = type_12((_e9482.member + 1u), _e9482.member_1);
                                                            phi_7097_ = type_12(1u, _e9482.member);
                                                        } else {
                                                            phi_7068_ = _e9482;
                                                            phi_7097_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e9500 = phi_7068_;
                                                        let _e9502 = phi_7097_;
                                                        let _e9506 = (bitcast<i32>(_e9502.member) != 0i);
                                                        if _e9506 {
                                                            let _e9510 = local_14.member[0u][_e9502.member_1];
                                                            let _e9517 = local_14.member[1u][_e9502.member_1];
                                                            if (_e9510[0] < 0.0lf) {
                                                                phi_7134_ = -(_e9510[0]);
                                                            } else {
                                                                phi_7134_ = _e9510[0];
                                                            }
                                                            let _e9524 = phi_7134_;
                                                            if (_e9510[1] < 0.0lf) {
                                                                phi_7141_ = -(_e9510[1]);
                                                            } else {
                                                                phi_7141_ = _e9510[1];
                                                            }
                                                            let _e9528 = phi_7141_;
                                                            if (_e9510[2] < 0.0lf) {
                                                                phi_7149_ = -(_e9510[2]);
                                                            } else {
                                                                phi_7149_ = _e9510[2];
                                                            }
                                                            let _e9533 = phi_7149_;
                                                            let _e9534 = ((_e9524 + _e9528) + _e9533);
                                                            if (_e9517[0] < 0.0lf) {
                                                                phi_7157_ = -(_e9517[0]);
                                                            } else {
                                                                phi_7157_ = _e9517[0];
                                                            }
                                                            let _e9538 = phi_7157_;
                                                            if (_e9517[1] < 0.0lf) {
                                                                phi_7164_ = -(_e9517[1]);
                                                            } else {
                                                                phi_7164_ = _e9517[1];
                                                            }
                                                            let _e9542 = phi_7164_;
                                                            if (_e9517[2] < 0.0lf) {
                                                                phi_7172_ = -(_e9517[2]);
                                                            } else {
                                                                phi_7172_ = _e9517[2];
                                                            }
                                                            let _e9547 = phi_7172_;
                                                            let _e9548 = ((_e9538 + _e9542) + _e9547);
                                                            if (_e9534 > _e9548) {
                                                                phi_7178_ = _e9534;
                                                            } else {
                                                                phi_7178_ = _e9548;
                                                            }
                                                            let _e9551 = phi_7178_;
                                                            let _e9557 = (_e9517[0] - _e9510[0]);
                                                            let _e9558 = (_e9517[1] - _e9510[1]);
                                                            let _e9559 = (_e9517[2] - _e9510[2]);
                                                            if (_e9557 < 0.0lf) {
                                                                phi_7198_ = -(_e9557);
                                                            } else {
                                                                phi_7198_ = _e9557;
                                                            }
                                                            let _e9563 = phi_7198_;
                                                            if (_e9558 < 0.0lf) {
                                                                phi_7204_ = -(_e9558);
                                                            } else {
                                                                phi_7204_ = _e9558;
                                                            }
                                                            let _e9567 = phi_7204_;
                                                            if (_e9559 < 0.0lf) {
                                                                phi_7211_ = -(_e9559);
                                                            } else {
                                                                phi_7211_ = _e9559;
                                                            }
                                                            let _e9572 = phi_7211_;
                                                            let _e9581 = local_15.member[_e9502.member_1];
                                                            let _e9584 = local_15.member_1[_e9502.member_1];
                                                            if (_e9581 < 0.0lf) {
                                                                phi_7240_ = -(_e9581);
                                                            } else {
                                                                phi_7240_ = _e9581;
                                                            }
                                                            let _e9590 = phi_7240_;
                                                            if (_e9584 < 0.0lf) {
                                                                phi_7246_ = -(_e9584);
                                                            } else {
                                                                phi_7246_ = _e9584;
                                                            }
                                                            let _e9594 = phi_7246_;
                                                            let _e9599 = ((_e8792 * f64(1.01f)) + ((_e9590 + _e9594) * (1.1102230246251565e-16lf * f64(12f))));
                                                            let _e9606 = local_15.member_1[_e9502.member_1];
                                                            let _e9609 = local_15.member[_e9502.member_1];
                                                            let _e9610 = (_e9606 - _e9609);
                                                            let _e9613 = ((_e9599 + _e9599) + (_e9479 * ((((_e9563 + _e9567) + _e9572) + (_e8792 * f64(6f))) * f64(1.01f))));
                                                            let _e9616 = ((((_e9581 + ((_e9584 - _e9581) * _e6631)) - _e9599) - (_e9479 * ((_e9551 + (_e8792 * f64(3f))) * f64(1.01f)))) - _e9333);
                                                            let _e9617 = (_e9616 > 2.2250738585072014e-308lf);
                                                            let _e9618 = (_e9610 > _e9613);
                                                            if _e9618 {
                                                                phi_7283_ = true;
                                                            } else {
                                                                phi_7283_ = _e9617;
                                                            }
                                                            let _e9620 = phi_7283_;
                                                            if (_e9610 < -(_e9613)) {
                                                                phi_7290_ = true;
                                                            } else {
                                                                phi_7290_ = _e9617;
                                                            }
                                                            let _e9625 = phi_7290_;
                                                            if _e9618 {
                                                                phi_7311_ = _e9484;
                                                            } else {
                                                                if _e9617 {
                                                                    let _e9627 = (_e9613 - _e9610);
                                                                    if (_e9627 > 2.2250738585072014e-308lf) {
                                                                        phi_7303_ = _e9627;
                                                                    } else {
                                                                        phi_7303_ = 2.2250738585072014e-308lf;
                                                                    }
                                                                    let _e9630 = phi_7303_;
                                                                    let _e9631 = (_e9616 / _e9630);
                                                                    if (_e9484 < _e9631) {
                                                                        phi_7309_ = _e9484;
                                                                    } else {
                                                                        phi_7309_ = _e9631;
                                                                    }
                                                                    let _e9634 = phi_7309_;
                                                                    phi_7310_ = _e9634;
                                                                } else {
                                                                    phi_7310_ = _e9484;
                                                                }
                                                                let _e9636 = phi_7310_;
                                                                phi_7311_ = _e9636;
                                                            }
                                                            let _e9638 = phi_7311_;
                                                            phi_7071_ = _e9638;
                                                            phi_7073_ = (_e9486 && _e9625);
                                                            phi_7075_ = (_e9488 && _e9620);
                                                        } else {
                                                            phi_7071_ = f64();
                                                            phi_7073_ = bool();
                                                            phi_7075_ = bool();
                                                        }
                                                        let _e9640 = phi_7071_;
                                                        let _e9642 = phi_7073_;
                                                        let _e9644 = phi_7075_;
                                                        continue;
                                                        continuing {
                                                            phi_7067_ = _e9500;
                                                            phi_7070_ = _e9640;
                                                            phi_7072_ = _e9642;
                                                            phi_7074_ = _e9644;
                                                            break if !(_e9506);
                                                        }
                                                    }
                                                    let _e9646 = f64(2f);
                                                    let _e9648 = local_51;
                                                    if (_e9648 < _e9646) {
                                                        let _e12070 = local_90;
                                                        phi_7317_ = _e12070;
                                                    } else {
                                                        phi_7317_ = _e9646;
                                                    }
                                                    let _e9651 = phi_7317_;
                                                    let _e9653 = (_e9651 * f64(0.999f));
                                                    let _e9655 = local_52;
                                                    if _e9655 {
                                                        let _e9657 = local_53;
                                                        if _e9657 {
                                                            phi_7328_ = type_48();
                                                        } else {
                                                            phi_7328_ = type_48(_e6631, f64(2f), 1u);
                                                        }
                                                        let _e9661 = phi_7328_;
                                                        phi_7329_ = _e9661;
                                                        let _e12077 = local_91;
                                                        phi_7330_ = _e12077;
                                                    } else {
                                                        phi_7329_ = type_48();
                                                        phi_7330_ = true;
                                                    }
                                                    let _e9663 = phi_7329_;
                                                    let _e9665 = phi_7330_;
                                                    if _e9665 {
                                                        let _e9667 = local_54;
                                                        if _e9667 {
                                                            if (_e9653 > (1.1102230246251565e-16lf * f64(4096f))) {
                                                                let _e9673 = (_e6631 + _e9653);
                                                                if (_e9673 < _e419) {
                                                                    phi_7348_ = _e9673;
                                                                } else {
                                                                    phi_7348_ = _e419;
                                                                }
                                                                let _e9676 = phi_7348_;
                                                                phi_7349_ = _e9676;
                                                            } else {
                                                                phi_7349_ = _e6631;
                                                            }
                                                            let _e9678 = phi_7349_;
                                                            phi_7352_ = type_12(0u, 4u);
                                                            phi_7355_ = _e9678;
                                                            phi_7357_ = _e6631;
                                                            loop {
                                                                let _e9680 = phi_7352_;
                                                                let _e9682 = phi_7355_;
                                                                let _e9684 = phi_7357_;
                                                                local_55 = _e9682;
                                                                local_56 = _e9684;
                                                                local_57 = _e9684;
                                                                if (_e9680.member < _e9680.member_1) {
                                                                    phi_7353_ = type_12((_e9680.member + 1u), _e9680.member_1);
                                                                    phi_7380_ = type_12(1u, _e9680.member);
                                                                } else {
                                                                    phi_7353_ = _e9680;
                                                                    phi_7380_ = type_12(0u, type_12().member_1);
                                                                }
                                                                let _e9696 = phi_7353_;
                                                                let _e9698 = phi_7380_;
                                                                let _e9702 = (bitcast<i32>(_e9698.member) != 0i);
                                                                if _e9702 {
                                                                    let _e9705 = local_15.member[_e9698.member_1];
                                                                    let _e9708 = local_15.member_1[_e9698.member_1];
                                                                    let _e9711 = local_15.member[_e9698.member_1];
                                                                    let _e9717 = local_15.member_2[_e9698.member_1];
                                                                    let _e9718 = ((_e9705 + ((_e9708 - _e9711) * _e6631)) - _e9717);
                                                                    let _e9721 = local_15.member_1[_e9698.member_1];
                                                                    let _e9724 = local_15.member[_e9698.member_1];
                                                                    let _e9725 = (_e9721 - _e9724);
                                                                    if (_e9725 > f64(0f)) {
                                                                        let _e9742 = (_e6631 - (_e9718 / _e9725));
                                                                        if (_e9684 > _e9742) {
                                                                            phi_7449_ = _e9684;
                                                                        } else {
                                                                            phi_7449_ = _e9742;
                                                                        }
                                                                        let _e9745 = phi_7449_;
                                                                        phi_7469_ = _e9682;
                                                                        phi_7470_ = _e9745;
                                                                    } else {
                                                                        if (_e9718 > f64(0f)) {
                                                                            if (_e9725 < f64(0f)) {
                                                                                let _e9733 = (_e6631 - (_e9718 / _e9725));
                                                                                if (_e9682 < _e9733) {
                                                                                    phi_7466_ = _e9682;
                                                                                } else {
                                                                                    phi_7466_ = _e9733;
                                                                                }
                                                                                let _e9736 = phi_7466_;
                                                                                phi_7467_ = _e9736;
                                                                            } else {
                                                                                phi_7467_ = _e9682;
                                                                            }
                                                                            let _e9738 = phi_7467_;
                                                                            phi_7468_ = _e9738;
                                                                        } else {
                                                                            phi_7468_ = _e9682;
                                                                        }
                                                                        let _e9740 = phi_7468_;
                                                                        phi_7469_ = _e9740;
                                                                        phi_7470_ = _e9684;
                                                                    }
                                                                    let _e9747 = phi_7469_;
                                                                    let _e9749 = phi_7470_;
                                                                    phi_7356_ = _e9747;
                                                                    phi_7358_ = _e9749;
                                                                } else {
                                                                    phi_7356_ = f64();
                                                                    phi_7358_ = f64();
                                                                }
                                                                let _e9751 = phi_7356_;
                                                                let _e9753 = phi_7358_;
                                                                continue;
                                                                continuing {
                                                                    phi_7352_ = _e9696;
                                                                    phi_7355_ = _e9751;
                                                                    phi_7357_ = _e9753;
                                                                    break if !(_e9702);
                                                                }
                                                            }
                                                            let _e9756 = local_55;
                                                            let _e9758 = local_56;
                                                            let _e9763 = local_57;
                                                            let _e9764 = (_e9763 + ((_e9756 - _e9758) * f64(0.5f)));
                                                            if (_e9764 > _e6631) {
                                                                if (_e9764 <= _e9678) {
                                                                    let _e9767 = f64(0f);
                                                                    let _e9770 = local_15.member[0u];
                                                                    let _e9773 = local_15.member_1[0u];
                                                                    let _e9776 = local_15.member[0u];
                                                                    let _e9782 = local_15.member_2[0u];
                                                                    if (((_e9770 + ((_e9773 - _e9776) * _e9764)) - _e9782) > _e9767) {
                                                                        let _e9787 = local_15.member[1u];
                                                                        let _e9790 = local_15.member_1[1u];
                                                                        let _e9793 = local_15.member[1u];
                                                                        let _e9799 = local_15.member_2[1u];
                                                                        if (((_e9787 + ((_e9790 - _e9793) * _e9764)) - _e9799) > _e9767) {
                                                                            let _e9804 = local_15.member[2u];
                                                                            let _e9807 = local_15.member_1[2u];
                                                                            let _e9810 = local_15.member[2u];
                                                                            let _e9816 = local_15.member_2[2u];
                                                                            if (((_e9804 + ((_e9807 - _e9810) * _e9764)) - _e9816) > _e9767) {
                                                                                let _e9821 = local_15.member[3u];
                                                                                let _e9824 = local_15.member_1[3u];
                                                                                let _e9827 = local_15.member[3u];
                                                                                let _e9833 = local_15.member_2[3u];
                                                                                phi_7633_ = (((_e9821 + ((_e9824 - _e9827) * _e9764)) - _e9833) > _e9767);
                                                                                phi_7634_ = false;
                                                                            } else {
                                                                                phi_7633_ = bool();
                                                                                phi_7634_ = true;
                                                                            }
                                                                            let _e9837 = phi_7633_;
                                                                            let _e9839 = phi_7634_;
                                                                            phi_7635_ = _e9837;
                                                                            phi_7636_ = _e9839;
                                                                        } else {
                                                                            phi_7635_ = bool();
                                                                            phi_7636_ = true;
                                                                        }
                                                                        let _e9841 = phi_7635_;
                                                                        let _e9843 = phi_7636_;
                                                                        phi_7637_ = _e9841;
                                                                        phi_7638_ = _e9843;
                                                                    } else {
                                                                        phi_7637_ = bool();
                                                                        phi_7638_ = true;
                                                                    }
                                                                    let _e9845 = phi_7637_;
                                                                    let _e9847 = phi_7638_;
                                                                    if _e9847 {
                                                                        phi_7642_ = false;
                                                                    } else {
                                                                        phi_7642_ = _e9845;
                                                                    }
                                                                    let _e9849 = phi_7642_;
                                                                    if _e9849 {
                                                                        phi_7646_ = false;
                                                                    } else {
                                                                        phi_7646_ = true;
                                                                    }
                                                                    let _e9851 = phi_7646_;
                                                                    phi_7647_ = _e9851;
                                                                } else {
                                                                    phi_7647_ = true;
                                                                }
                                                                let _e9853 = phi_7647_;
                                                                phi_7648_ = _e9853;
                                                            } else {
                                                                phi_7648_ = true;
                                                            }
                                                            let _e9855 = phi_7648_;
                                                            if _e9855 {
                                                                phi_7653_ = f64(2f);
                                                            } else {
                                                                phi_7653_ = _e9764;
                                                            }
                                                            let _e9858 = phi_7653_;
                                                            phi_7657_ = type_48(_e9678, _e9858, 2u);
                                                            phi_7658_ = type_48();
                                                            phi_7659_ = false;
                                                        } else {
                                                            phi_7657_ = type_48();
                                                            phi_7658_ = type_48(_e6631, f64(2f), 0u);
                                                            phi_7659_ = true;
                                                        }
                                                        let _e9861 = phi_7657_;
                                                        let _e9863 = phi_7658_;
                                                        let _e9865 = phi_7659_;
                                                        phi_7660_ = _e9861;
                                                        phi_7661_ = _e9863;
                                                        phi_7662_ = _e9865;
                                                    } else {
                                                        phi_7660_ = type_48();
                                                        phi_7661_ = _e9663;
                                                        phi_7662_ = true;
                                                    }
                                                    let _e9867 = phi_7660_;
                                                    let _e9869 = phi_7661_;
                                                    let _e9871 = phi_7662_;
                                                    phi_7668_ = _e9869;
                                                    phi_7669_ = _e9867;
                                                    phi_7670_ = _e9871;
                                                } else {
                                                    phi_7668_ = type_48(_e6631, f64(2f), 0u);
                                                    phi_7669_ = type_48();
                                                    phi_7670_ = true;
                                                }
                                                let _e9873 = phi_7668_;
                                                let _e9875 = phi_7669_;
                                                let _e9877 = phi_7670_;
                                                phi_7674_ = _e9873;
                                                phi_7675_ = _e9875;
                                                phi_7676_ = false;
                                                phi_7677_ = _e9877;
                                            } else {
                                                phi_7674_ = type_48();
                                                phi_7675_ = type_48();
                                                phi_7676_ = true;
                                                phi_7677_ = false;
                                            }
                                            let _e9879 = phi_7674_;
                                            let _e9881 = phi_7675_;
                                            let _e9883 = phi_7676_;
                                            let _e9885 = phi_7677_;
                                            phi_7678_ = _e9879;
                                            phi_7679_ = _e9881;
                                            phi_7680_ = _e9883;
                                            phi_7681_ = _e9885;
                                        } else {
                                            phi_7678_ = type_48();
                                            phi_7679_ = type_48();
                                            phi_7680_ = true;
                                            phi_7681_ = false;
                                        }
                                        let _e9887 = phi_7678_;
                                        let _e9889 = phi_7679_;
                                        let _e9891 = phi_7680_;
                                        let _e9893 = phi_7681_;
                                        if _e9891 {
                                            phi_7687_ = type_48(_e6631, f64(2f), 0u);
                                            phi_7688_ = true;
                                        } else {
                                            phi_7687_ = _e9887;
                                            phi_7688_ = _e9893;
                                        }
                                        let _e9897 = phi_7687_;
                                        let _e9899 = phi_7688_;
                                        if _e9899 {
                                            phi_7692_ = _e9897;
                                        } else {
                                            phi_7692_ = _e9889;
                                        }
                                        let _e9901 = phi_7692_;
                                        if ((_e421 & 64u) != 0u) {
                                            if (_e9901.member_2 == 2u) {
                                                let _e9905 = (_e9901.member_1 <= _e419);
                                                if _e9905 {
                                                    phi_7708_ = _e9901.member_1;
                                                    phi_7709_ = _e9901.member_1;
                                                    phi_7710_ = false;
                                                } else {
                                                    phi_7708_ = f64();
                                                    phi_7709_ = f64();
                                                    phi_7710_ = true;
                                                }
                                                let _e9909 = phi_7708_;
                                                let _e9911 = phi_7709_;
                                                let _e9913 = phi_7710_;
                                                phi_7711_ = _e9909;
                                                phi_7712_ = _e9911;
                                                phi_7713_ = _e9905;
                                                phi_7714_ = _e9913;
                                                phi_7715_ = false;
                                            } else {
                                                phi_7711_ = f64();
                                                phi_7712_ = f64();
                                                phi_7713_ = false;
                                                phi_7714_ = false;
                                                phi_7715_ = true;
                                            }
                                            let _e9915 = phi_7711_;
                                            let _e9917 = phi_7712_;
                                            let _e9919 = phi_7713_;
                                            let _e9921 = phi_7714_;
                                            let _e9923 = phi_7715_;
                                            phi_7716_ = _e9915;
                                            phi_7717_ = _e9917;
                                            phi_7718_ = _e9919;
                                            phi_7719_ = _e9921;
                                            phi_7720_ = _e9923;
                                        } else {
                                            phi_7716_ = f64();
                                            phi_7717_ = f64();
                                            phi_7718_ = false;
                                            phi_7719_ = false;
                                            phi_7720_ = true;
                                        }
                                        let _e9925 = phi_7716_;
                                        let _e9927 = phi_7717_;
                                        let _e9929 = phi_7718_;
                                        let _e9931 = phi_7719_;
                                        let _e9933 = phi_7720_;
                                        phi_7721_ = _e9925;
                                        phi_7722_ = _e9901.member_2;
                                        phi_7723_ = _e9927;
                                        phi_7724_ = _e9901;
                                        phi_7725_ = _e9901.member_2;
                                        phi_7726_ = _e9901.member_2;
                                        phi_7727_ = _e9929;
                                        phi_7728_ = _e9931;
                                        phi_7729_ = _e9933;
                                    }
                                    let _e9935 = phi_7721_;
                                    let _e9937 = phi_7722_;
                                    let _e9939 = phi_7723_;
                                    let _e9941 = phi_7724_;
                                    let _e9943 = phi_7725_;
                                    let _e9945 = phi_7726_;
                                    let _e9947 = phi_7727_;
                                    let _e9949 = phi_7728_;
                                    let _e9951 = phi_7729_;
                                    phi_7730_ = _e9935;
                                    phi_7731_ = _e9937;
                                    phi_7732_ = _e9939;
                                    phi_7733_ = _e9941;
                                    phi_7734_ = _e9943;
                                    phi_7735_ = _e9945;
                                    phi_7736_ = _e9947;
                                    phi_7737_ = _e8474;
                                    phi_7738_ = _e9949;
                                    phi_7739_ = _e9951;
                                    phi_7740_ = false;
                                } else {
                                    phi_7730_ = f64();
                                    phi_7731_ = u32();
                                    phi_7732_ = f64();
                                    phi_7733_ = type_48();
                                    phi_7734_ = u32();
                                    phi_7735_ = u32();
                                    phi_7736_ = false;
                                    phi_7737_ = false;
                                    phi_7738_ = false;
                                    phi_7739_ = false;
                                    phi_7740_ = true;
                                }
                                let _e9953 = phi_7730_;
                                let _e9955 = phi_7731_;
                                let _e9957 = phi_7732_;
                                let _e9959 = phi_7733_;
                                let _e9961 = phi_7734_;
                                let _e9963 = phi_7735_;
                                let _e9965 = phi_7736_;
                                let _e9967 = phi_7737_;
                                let _e9969 = phi_7738_;
                                let _e9971 = phi_7739_;
                                let _e9973 = phi_7740_;
                                phi_7741_ = _e8471;
                                phi_2725_ = _e9953;
                                phi_2727_ = _e9955;
                                phi_2729_ = _e9957;
                                phi_7742_ = _e9959;
                                phi_7743_ = _e9961;
                                phi_7744_ = _e8471;
                                phi_7745_ = _e9963;
                                phi_7746_ = _e9965;
                                phi_7747_ = _e9967;
                                phi_7748_ = _e9969;
                                phi_7749_ = _e9971;
                                phi_7750_ = false;
                                phi_7751_ = _e9973;
                            } else {
                                phi_7741_ = f64();
                                phi_2725_ = f64();
                                phi_2727_ = u32();
                                phi_2729_ = f64();
                                phi_7742_ = type_48();
                                phi_7743_ = u32();
                                phi_7744_ = f64();
                                phi_7745_ = u32();
                                phi_7746_ = false;
                                phi_7747_ = false;
                                phi_7748_ = false;
                                phi_7749_ = false;
                                phi_7750_ = true;
                                phi_7751_ = false;
                            }
                            let _e9975 = phi_7741_;
                            let _e9977 = phi_2725_;
                            let _e9979 = phi_2727_;
                            let _e9981 = phi_2729_;
                            let _e9983 = phi_7742_;
                            let _e9985 = phi_7743_;
                            let _e9987 = phi_7744_;
                            let _e9989 = phi_7745_;
                            let _e9991 = phi_7746_;
                            let _e9993 = phi_7747_;
                            let _e9995 = phi_7748_;
                            let _e9997 = phi_7749_;
                            let _e9999 = phi_7750_;
                            let _e10001 = phi_7751_;
                            local_58 = _e9993;
                            local_92 = _e9995;
                            local_93 = _e9997;
                            local_94 = _e9999;
                            local_95 = _e10001;
                            local_59 = _e9983;
                            local_60 = _e9983;
                            local_96 = _e9985;
                            local_61 = _e9983;
                            local_97 = _e9993;
                            local_98 = _e9989;
                            local_100 = _e9987;
                            local_101 = _e9975;
                            continue;
                            continuing {
                                phi_2721_ = _e6654;
                                phi_2724_ = _e9977;
                                phi_2726_ = _e9979;
                                phi_2728_ = _e9981;
                                break if !(_e9991);
                            }
                        }
                        let _e10004 = local_58;
                        if _e10004 {
                            phi_7755_ = false;
                            phi_7756_ = false;
                            phi_7757_ = false;
                            phi_7758_ = false;
                        } else {
                            let _e12178 = local_92;
                            phi_7755_ = _e12178;
                            let _e12181 = local_93;
                            phi_7756_ = _e12181;
                            let _e12184 = local_94;
                            phi_7757_ = _e12184;
                            let _e12187 = local_95;
                            phi_7758_ = _e12187;
                        }
                        let _e10006 = phi_7755_;
                        let _e10008 = phi_7756_;
                        let _e10010 = phi_7757_;
                        let _e10012 = phi_7758_;
                        if _e10006 {
                            let _e10014 = local_59;
                            if (_e10014.member >= _e419) {
                                phi_7780_ = type_47(type_46(0u, f64()), 0u);
                            } else {
                                let _e10018 = local_60;
                                if (_e10018.member > _e410) {
                                    phi_7775_ = 0u;
                                } else {
                                    let _e12192 = local_96;
                                    phi_7775_ = _e12192;
                                }
                                let _e10022 = phi_7775_;
                                let _e10024 = local_61;
                                phi_7780_ = type_47(type_46(2u, _e10024.member), _e10022);
                            }
                            let _e10031 = phi_7780_;
                            phi_7781_ = _e10031;
                            phi_7782_ = false;
                            phi_7783_ = false;
                            phi_7784_ = false;
                            phi_7785_ = false;
                        } else {
                            phi_7781_ = type_47();
                            phi_7782_ = _e10008;
                            let _e12199 = local_97;
                            phi_7783_ = _e12199;
                            phi_7784_ = _e10010;
                            phi_7785_ = _e10012;
                        }
                        let _e10033 = phi_7781_;
                        let _e10035 = phi_7782_;
                        let _e10037 = phi_7783_;
                        let _e10039 = phi_7784_;
                        let _e10041 = phi_7785_;
                        if _e10035 {
                            let _e12204 = local_98;
                            phi_7789_ = _e12204;
                            let _e12209 = local_100;
                            phi_7790_ = _e12209;
                            phi_7791_ = true;
                            phi_7792_ = false;
                            phi_7793_ = false;
                            phi_7794_ = false;
                        } else {
                            let _e12206 = local_99;
                            phi_7789_ = _e12206;
                            let _e12211 = local_101;
                            phi_7790_ = _e12211;
                            phi_7791_ = _e10037;
                            phi_7792_ = _e10039;
                            phi_7793_ = _e10041;
                            phi_7794_ = _e10006;
                        }
                        let _e10043 = phi_7789_;
                        let _e10045 = phi_7790_;
                        let _e10047 = phi_7791_;
                        let _e10049 = phi_7792_;
                        let _e10051 = phi_7793_;
                        let _e10053 = phi_7794_;
                        if _e10047 {
                            phi_7798_ = _e10045;
                            phi_7799_ = _e10043;
                            phi_7800_ = true;
                            phi_7801_ = false;
                            phi_7802_ = false;
                        } else {
                            let _e12218 = local_102;
                            phi_7798_ = _e12218;
                            let _e12221 = local_103;
                            phi_7799_ = _e12221;
                            phi_7800_ = _e10049;
                            phi_7801_ = _e10051;
                            phi_7802_ = _e10053;
                        }
                        let _e10055 = phi_7798_;
                        let _e10057 = phi_7799_;
                        let _e10059 = phi_7800_;
                        let _e10061 = phi_7801_;
                        let _e10063 = phi_7802_;
                        if _e10059 {
                            local_13[0u] = 0.01f;
                            local_13[1u] = 0f;
                            local_13[2u] = 0.8f;
                            if (_e401 >= (1.1102230246251565e-16lf * f64(8f))) {
                                phi_7816_ = _e401;
                            } else {
                                phi_7816_ = f64(0f);
                            }
                            let _e10072 = phi_7816_;
                            phi_7819_ = type_12(0u, 3u);
                            loop {
                                let _e10074 = phi_7819_;
                                if (_e10074.member < _e10074.member_1) {
                                    phi_7820_ = type_12((_e10074.member + 1u), _e10074.member_1);
                                    phi_7843_ = type_12(1u, _e10074.member);
                                } else {
                                    phi_7820_ = _e10074;
                                    phi_7843_ = type_12(0u, type_12().member_1);
                                }
                                let _e10086 = phi_7820_;
                                let _e10088 = phi_7843_;
                                if (bitcast<i32>(_e10088.member) != 0i) {
                                    let _e10094 = local_13[_e10088.member_1];
                                    let _e10097 = (_e10055 + (_e10072 * f64(_e10094)));
                                    if (_e10097 < _e419) {
                                        phi_7865_ = _e10097;
                                    } else {
                                        phi_7865_ = _e419;
                                    }
                                    let _e10100 = phi_7865_;
                                    let _e10103 = local_18.member[0u];
                                    let _e10109 = local_18.member[1u];
                                    let _e10125 = local_18.member_1[0u];
                                    let _e10131 = local_18.member_1[1u];
                                    let _e10147 = local_18.member_2[0u];
                                    let _e10153 = local_18.member_2[1u];
                                    let _e10167 = function_3(array<f64, 3>((_e10103[0] + ((_e10109[0] - _e10103[0]) * _e10100)), (_e10103[1] + ((_e10109[1] - _e10103[1]) * _e10100)), (_e10103[2] + ((_e10109[2] - _e10103[2]) * _e10100))), array<f64, 3>((_e10125[0] + ((_e10131[0] - _e10125[0]) * _e10100)), (_e10125[1] + ((_e10131[1] - _e10125[1]) * _e10100)), (_e10125[2] + ((_e10131[2] - _e10125[2]) * _e10100))), array<f64, 3>((_e10147[0] + ((_e10153[0] - _e10147[0]) * _e10100)), (_e10147[1] + ((_e10153[1] - _e10147[1]) * _e10100)), (_e10147[2] + ((_e10153[2] - _e10147[2]) * _e10100))), 0u);
                                    let _e10178 = (((_e10167[0] * _e10167[0]) + (_e10167[1] * _e10167[1])) + (_e10167[2] * _e10167[2]));
                                    if (_e10178 <= 2.2250738585072014e-308lf) {
                                        if (_e10178 > 0.0lf) {
                                            phi_7988_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_7988_ = 0.0lf;
                                        }
                                        let _e10230 = phi_7988_;
                                        phi_8052_ = _e10230;
                                    } else {
                                        phi_7995_ = type_16(0i, 5i);
                                        phi_7998_ = bitcast<f64>(((bitcast<u64>(_e10178) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e10185 = phi_7995_;
                                            let _e10187 = phi_7998_;
                                            local_62 = _e10187;
                                            if (_e10185.member < _e10185.member_1) {
                                                let _e10194 = (_e10185.member + 1i);
                                                if ((false == (_e10194 > _e10185.member)) != false) {
                                                    phi_8019_ = true;
                                                } else {
                                                    phi_8019_ = false;
                                                }
                                                let _e10199 = phi_8019_;
                                                if _e10199 {
                                                    phi_8025_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_8025_ = type_17(1u, _e10194);
                                                }
                                                let _e10204 = phi_8025_;
                                                phi_7996_ = type_16(_e10204.member_1, _e10185.member_1);
                                                phi_8039_ = type_17(1u, _e10185.member);
                                            } else {
                                                phi_7996_ = _e10185;
                                                phi_8039_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e10210 = phi_7996_;
                                            let _e10212 = phi_8039_;
                                            let _e10215 = (bitcast<i32>(_e10212.member) != 0i);
                                            if _e10215 {
                                                phi_7999_ = (0.5lf * (_e10187 + (_e10178 / _e10187)));
                                            } else {
                                                phi_7999_ = f64();
                                            }
                                            let _e10220 = phi_7999_;
                                            continue;
                                            continuing {
                                                phi_7995_ = _e10210;
                                                phi_7998_ = _e10220;
                                                break if !(_e10215);
                                            }
                                        }
                                        let _e10225 = local_62;
                                        phi_8052_ = (_e10225 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e10232 = phi_8052_;
                                    let _e10240 = local_18.member[0u];
                                    if (_e10240[0] < 0.0lf) {
                                        phi_8070_ = -(_e10240[0]);
                                    } else {
                                        phi_8070_ = _e10240[0];
                                    }
                                    let _e10247 = phi_8070_;
                                    if (_e10240[1] < 0.0lf) {
                                        phi_8077_ = -(_e10240[1]);
                                    } else {
                                        phi_8077_ = _e10240[1];
                                    }
                                    let _e10251 = phi_8077_;
                                    if (_e10247 > _e10251) {
                                        phi_8082_ = _e10247;
                                    } else {
                                        phi_8082_ = _e10251;
                                    }
                                    let _e10254 = phi_8082_;
                                    if (_e10240[2] < 0.0lf) {
                                        phi_8089_ = -(_e10240[2]);
                                    } else {
                                        phi_8089_ = _e10240[2];
                                    }
                                    let _e10258 = phi_8089_;
                                    if (_e10254 > _e10258) {
                                        phi_8094_ = _e10254;
                                    } else {
                                        phi_8094_ = _e10258;
                                    }
                                    let _e10261 = phi_8094_;
                                    let _e10264 = local_18.member[1u];
                                    if (_e10264[0] < 0.0lf) {
                                        phi_8107_ = -(_e10264[0]);
                                    } else {
                                        phi_8107_ = _e10264[0];
                                    }
                                    let _e10271 = phi_8107_;
                                    if (_e10264[1] < 0.0lf) {
                                        phi_8114_ = -(_e10264[1]);
                                    } else {
                                        phi_8114_ = _e10264[1];
                                    }
                                    let _e10275 = phi_8114_;
                                    if (_e10271 > _e10275) {
                                        phi_8119_ = _e10271;
                                    } else {
                                        phi_8119_ = _e10275;
                                    }
                                    let _e10278 = phi_8119_;
                                    if (_e10264[2] < 0.0lf) {
                                        phi_8126_ = -(_e10264[2]);
                                    } else {
                                        phi_8126_ = _e10264[2];
                                    }
                                    let _e10282 = phi_8126_;
                                    if (_e10278 > _e10282) {
                                        phi_8131_ = _e10278;
                                    } else {
                                        phi_8131_ = _e10282;
                                    }
                                    let _e10285 = phi_8131_;
                                    if (_e10261 > _e10285) {
                                        phi_8136_ = _e10261;
                                    } else {
                                        phi_8136_ = _e10285;
                                    }
                                    let _e10288 = phi_8136_;
                                    let _e10290 = local_18.member_3;
                                    let _e10294 = local_18.member_1[0u];
                                    if (_e10294[0] < 0.0lf) {
                                        phi_8153_ = -(_e10294[0]);
                                    } else {
                                        phi_8153_ = _e10294[0];
                                    }
                                    let _e10301 = phi_8153_;
                                    if (_e10294[1] < 0.0lf) {
                                        phi_8160_ = -(_e10294[1]);
                                    } else {
                                        phi_8160_ = _e10294[1];
                                    }
                                    let _e10305 = phi_8160_;
                                    if (_e10301 > _e10305) {
                                        phi_8165_ = _e10301;
                                    } else {
                                        phi_8165_ = _e10305;
                                    }
                                    let _e10308 = phi_8165_;
                                    if (_e10294[2] < 0.0lf) {
                                        phi_8172_ = -(_e10294[2]);
                                    } else {
                                        phi_8172_ = _e10294[2];
                                    }
                                    let _e10312 = phi_8172_;
                                    if (_e10308 > _e10312) {
                                        phi_8177_ = _e10308;
                                    } else {
                                        phi_8177_ = _e10312;
                                    }
                                    let _e10315 = phi_8177_;
                                    let _e10318 = local_18.member_1[1u];
                                    if (_e10318[0] < 0.0lf) {
                                        phi_8191_ = -(_e10318[0]);
                                    } else {
                                        phi_8191_ = _e10318[0];
                                    }
                                    let _e10325 = phi_8191_;
                                    if (_e10318[1] < 0.0lf) {
                                        phi_8198_ = -(_e10318[1]);
                                    } else {
                                        phi_8198_ = _e10318[1];
                                    }
                                    let _e10329 = phi_8198_;
                                    if (_e10325 > _e10329) {
                                        phi_8203_ = _e10325;
                                    } else {
                                        phi_8203_ = _e10329;
                                    }
                                    let _e10332 = phi_8203_;
                                    if (_e10318[2] < 0.0lf) {
                                        phi_8210_ = -(_e10318[2]);
                                    } else {
                                        phi_8210_ = _e10318[2];
                                    }
                                    let _e10336 = phi_8210_;
                                    if (_e10332 > _e10336) {
                                        phi_8215_ = _e10332;
                                    } else {
                                        phi_8215_ = _e10336;
                                    }
                                    let _e10339 = phi_8215_;
                                    if (_e10315 > _e10339) {
                                        phi_8220_ = _e10315;
                                    } else {
                                        phi_8220_ = _e10339;
                                    }
                                    let _e10342 = phi_8220_;
                                    let _e10344 = local_18.member_3;
                                    let _e10348 = local_18.member_2[0u];
                                    if (_e10348[0] < 0.0lf) {
                                        phi_8237_ = -(_e10348[0]);
                                    } else {
                                        phi_8237_ = _e10348[0];
                                    }
                                    let _e10355 = phi_8237_;
                                    if (_e10348[1] < 0.0lf) {
                                        phi_8244_ = -(_e10348[1]);
                                    } else {
                                        phi_8244_ = _e10348[1];
                                    }
                                    let _e10359 = phi_8244_;
                                    if (_e10355 > _e10359) {
                                        phi_8249_ = _e10355;
                                    } else {
                                        phi_8249_ = _e10359;
                                    }
                                    let _e10362 = phi_8249_;
                                    if (_e10348[2] < 0.0lf) {
                                        phi_8256_ = -(_e10348[2]);
                                    } else {
                                        phi_8256_ = _e10348[2];
                                    }
                                    let _e10366 = phi_8256_;
                                    if (_e10362 > _e10366) {
                                        phi_8261_ = _e10362;
                                    } else {
                                        phi_8261_ = _e10366;
                                    }
                                    let _e10369 = phi_8261_;
                                    let _e10372 = local_18.member_2[1u];
                                    if (_e10372[0] < 0.0lf) {
                                        phi_8275_ = -(_e10372[0]);
                                    } else {
                                        phi_8275_ = _e10372[0];
                                    }
                                    let _e10379 = phi_8275_;
                                    if (_e10372[1] < 0.0lf) {
                                        phi_8282_ = -(_e10372[1]);
                                    } else {
                                        phi_8282_ = _e10372[1];
                                    }
                                    let _e10383 = phi_8282_;
                                    if (_e10379 > _e10383) {
                                        phi_8287_ = _e10379;
                                    } else {
                                        phi_8287_ = _e10383;
                                    }
                                    let _e10386 = phi_8287_;
                                    if (_e10372[2] < 0.0lf) {
                                        phi_8294_ = -(_e10372[2]);
                                    } else {
                                        phi_8294_ = _e10372[2];
                                    }
                                    let _e10390 = phi_8294_;
                                    if (_e10386 > _e10390) {
                                        phi_8299_ = _e10386;
                                    } else {
                                        phi_8299_ = _e10390;
                                    }
                                    let _e10393 = phi_8299_;
                                    if (_e10369 > _e10393) {
                                        phi_8304_ = _e10369;
                                    } else {
                                        phi_8304_ = _e10393;
                                    }
                                    let _e10396 = phi_8304_;
                                    let _e10398 = local_18.member_3;
                                    let _e10406 = local_18.member_3;
                                    let _e10416 = (((_e10232 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e10288 + _e10290) + (_e10342 + _e10344)) + (_e10396 + _e10398)) * (1.1102230246251565e-16lf * f64(16f))) + (_e10406 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e620.member_1);
                                    if _e10416 {
                                        phi_8328_ = false;
                                    } else {
                                        phi_8328_ = true;
                                    }
                                    let _e10418 = phi_8328_;
                                    phi_8329_ = _e10418;
                                    phi_8330_ = _e10416;
                                } else {
                                    phi_8329_ = false;
                                    phi_8330_ = false;
                                }
                                let _e10420 = phi_8329_;
                                let _e10422 = phi_8330_;
                                local_63 = _e10422;
                                continue;
                                continuing {
                                    phi_7819_ = _e10086;
                                    break if !(_e10420);
                                }
                            }
                            let _e10425 = local_63;
                            if _e10425 {
                                if (_e10055 > _e410) {
                                    phi_8338_ = 1u;
                                } else {
                                    phi_8338_ = _e10057;
                                }
                                let _e10428 = phi_8338_;
                                phi_8342_ = type_47(type_46(1u, _e10055), _e10428);
                                phi_8343_ = false;
                            } else {
                                phi_8342_ = type_47();
                                phi_8343_ = true;
                            }
                            let _e10432 = phi_8342_;
                            let _e10434 = phi_8343_;
                            if _e10434 {
                                if (_e10055 > _e410) {
                                    phi_8351_ = 0u;
                                } else {
                                    phi_8351_ = _e10057;
                                }
                                let _e10437 = phi_8351_;
                                phi_8355_ = type_47(type_46(2u, _e10055), _e10437);
                            } else {
                                phi_8355_ = _e10432;
                            }
                            let _e10441 = phi_8355_;
                            phi_8356_ = _e10441;
                            phi_8357_ = false;
                            phi_8358_ = false;
                        } else {
                            phi_8356_ = type_47();
                            phi_8357_ = _e10061;
                            phi_8358_ = _e10063;
                        }
                        let _e10443 = phi_8356_;
                        let _e10445 = phi_8357_;
                        let _e10447 = phi_8358_;
                        if _e10445 {
                            phi_8365_ = type_47(type_46(0u, f64()), 0u);
                            phi_8366_ = true;
                        } else {
                            phi_8365_ = _e10033;
                            phi_8366_ = _e10447;
                        }
                        let _e10451 = phi_8365_;
                        let _e10453 = phi_8366_;
                        phi_8370_ = _e10451;
                        phi_8371_ = _e10443;
                        phi_8372_ = _e10453;
                    } else {
                        phi_8370_ = _e6621;
                        phi_8371_ = type_47();
                        phi_8372_ = true;
                    }
                    let _e10455 = phi_8370_;
                    let _e10457 = phi_8371_;
                    let _e10459 = phi_8372_;
                    if _e10459 {
                        phi_8376_ = _e10455;
                    } else {
                        phi_8376_ = _e10457;
                    }
                    let _e10461 = phi_8376_;
                    phi_16043_ = _e10461;
                } else {
                    let _e663 = f64(0f);
                    let _e666 = local_18.member_1[0u];
                    let _e672 = local_18.member_2[0u];
                    let _e678 = ((_e666[1] * _e672[2]) - (_e666[2] * _e672[1]));
                    let _e681 = ((_e666[2] * _e672[0]) - (_e666[0] * _e672[2]));
                    let _e684 = ((_e666[0] * _e672[1]) - (_e666[1] * _e672[0]));
                    let _e687 = local_18.member_1[1u];
                    let _e693 = local_18.member_2[1u];
                    let _e699 = ((_e687[1] * _e693[2]) - (_e687[2] * _e693[1]));
                    let _e702 = ((_e687[2] * _e693[0]) - (_e687[0] * _e693[2]));
                    let _e705 = ((_e687[0] * _e693[1]) - (_e687[1] * _e693[0]));
                    let _e708 = local_18.member_1[0u];
                    let _e714 = local_18.member_2[1u];
                    let _e729 = local_18.member_1[1u];
                    let _e735 = local_18.member_2[0u];
                    let _e748 = (((_e708[1] * _e714[2]) - (_e708[2] * _e714[1])) + ((_e729[1] * _e735[2]) - (_e729[2] * _e735[1])));
                    let _e749 = (((_e708[2] * _e714[0]) - (_e708[0] * _e714[2])) + ((_e729[2] * _e735[0]) - (_e729[0] * _e735[2])));
                    let _e750 = (((_e708[0] * _e714[1]) - (_e708[1] * _e714[0])) + ((_e729[0] * _e735[1]) - (_e729[1] * _e735[0])));
                    let _e753 = local_18.member[0u];
                    let _e761 = (((_e753[0] * _e678) + (_e753[1] * _e681)) + (_e753[2] * _e684));
                    let _e764 = local_18.member[1u];
                    let _e775 = local_18.member[0u];
                    let _e784 = ((((_e764[0] * _e678) + (_e764[1] * _e681)) + (_e764[2] * _e684)) + (((_e775[0] * _e748) + (_e775[1] * _e749)) + (_e775[2] * _e750)));
                    let _e787 = local_18.member[0u];
                    let _e798 = local_18.member[1u];
                    let _e807 = ((((_e787[0] * _e699) + (_e787[1] * _e702)) + (_e787[2] * _e705)) + (((_e798[0] * _e748) + (_e798[1] * _e749)) + (_e798[2] * _e750)));
                    let _e810 = local_18.member[1u];
                    let _e818 = (((_e810[0] * _e699) + (_e810[1] * _e702)) + (_e810[2] * _e705));
                    let _e821 = local_18.member[0u];
                    if (_e821[0] < 0.0lf) {
                        phi_8619_ = -(_e821[0]);
                    } else {
                        phi_8619_ = _e821[0];
                    }
                    let _e828 = phi_8619_;
                    if (_e821[1] < 0.0lf) {
                        phi_8626_ = -(_e821[1]);
                    } else {
                        phi_8626_ = _e821[1];
                    }
                    let _e832 = phi_8626_;
                    if (_e828 > _e832) {
                        phi_8631_ = _e828;
                    } else {
                        phi_8631_ = _e832;
                    }
                    let _e835 = phi_8631_;
                    if (_e821[2] < 0.0lf) {
                        phi_8638_ = -(_e821[2]);
                    } else {
                        phi_8638_ = _e821[2];
                    }
                    let _e839 = phi_8638_;
                    if (_e835 > _e839) {
                        phi_8643_ = _e835;
                    } else {
                        phi_8643_ = _e839;
                    }
                    let _e842 = phi_8643_;
                    let _e845 = local_18.member[1u];
                    if (_e845[0] < 0.0lf) {
                        phi_8656_ = -(_e845[0]);
                    } else {
                        phi_8656_ = _e845[0];
                    }
                    let _e852 = phi_8656_;
                    if (_e845[1] < 0.0lf) {
                        phi_8663_ = -(_e845[1]);
                    } else {
                        phi_8663_ = _e845[1];
                    }
                    let _e856 = phi_8663_;
                    if (_e852 > _e856) {
                        phi_8668_ = _e852;
                    } else {
                        phi_8668_ = _e856;
                    }
                    let _e859 = phi_8668_;
                    if (_e845[2] < 0.0lf) {
                        phi_8675_ = -(_e845[2]);
                    } else {
                        phi_8675_ = _e845[2];
                    }
                    let _e863 = phi_8675_;
                    if (_e859 > _e863) {
                        phi_8680_ = _e859;
                    } else {
                        phi_8680_ = _e863;
                    }
                    let _e866 = phi_8680_;
                    if (_e842 > _e866) {
                        phi_8685_ = _e842;
                    } else {
                        phi_8685_ = _e866;
                    }
                    let _e869 = phi_8685_;
                    let _e871 = local_18.member_3;
                    let _e872 = (_e869 + _e871);
                    let _e875 = local_18.member_1[0u];
                    if (_e875[0] < 0.0lf) {
                        phi_8702_ = -(_e875[0]);
                    } else {
                        phi_8702_ = _e875[0];
                    }
                    let _e882 = phi_8702_;
                    if (_e875[1] < 0.0lf) {
                        phi_8709_ = -(_e875[1]);
                    } else {
                        phi_8709_ = _e875[1];
                    }
                    let _e886 = phi_8709_;
                    if (_e882 > _e886) {
                        phi_8714_ = _e882;
                    } else {
                        phi_8714_ = _e886;
                    }
                    let _e889 = phi_8714_;
                    if (_e875[2] < 0.0lf) {
                        phi_8721_ = -(_e875[2]);
                    } else {
                        phi_8721_ = _e875[2];
                    }
                    let _e893 = phi_8721_;
                    if (_e889 > _e893) {
                        phi_8726_ = _e889;
                    } else {
                        phi_8726_ = _e893;
                    }
                    let _e896 = phi_8726_;
                    let _e899 = local_18.member_1[1u];
                    if (_e899[0] < 0.0lf) {
                        phi_8740_ = -(_e899[0]);
                    } else {
                        phi_8740_ = _e899[0];
                    }
                    let _e906 = phi_8740_;
                    if (_e899[1] < 0.0lf) {
                        phi_8747_ = -(_e899[1]);
                    } else {
                        phi_8747_ = _e899[1];
                    }
                    let _e910 = phi_8747_;
                    if (_e906 > _e910) {
                        phi_8752_ = _e906;
                    } else {
                        phi_8752_ = _e910;
                    }
                    let _e913 = phi_8752_;
                    if (_e899[2] < 0.0lf) {
                        phi_8759_ = -(_e899[2]);
                    } else {
                        phi_8759_ = _e899[2];
                    }
                    let _e917 = phi_8759_;
                    if (_e913 > _e917) {
                        phi_8764_ = _e913;
                    } else {
                        phi_8764_ = _e917;
                    }
                    let _e920 = phi_8764_;
                    if (_e896 > _e920) {
                        phi_8769_ = _e896;
                    } else {
                        phi_8769_ = _e920;
                    }
                    let _e923 = phi_8769_;
                    let _e925 = local_18.member_3;
                    let _e926 = (_e923 + _e925);
                    let _e929 = local_18.member_2[0u];
                    if (_e929[0] < 0.0lf) {
                        phi_8786_ = -(_e929[0]);
                    } else {
                        phi_8786_ = _e929[0];
                    }
                    let _e936 = phi_8786_;
                    if (_e929[1] < 0.0lf) {
                        phi_8793_ = -(_e929[1]);
                    } else {
                        phi_8793_ = _e929[1];
                    }
                    let _e940 = phi_8793_;
                    if (_e936 > _e940) {
                        phi_8798_ = _e936;
                    } else {
                        phi_8798_ = _e940;
                    }
                    let _e943 = phi_8798_;
                    if (_e929[2] < 0.0lf) {
                        phi_8805_ = -(_e929[2]);
                    } else {
                        phi_8805_ = _e929[2];
                    }
                    let _e947 = phi_8805_;
                    if (_e943 > _e947) {
                        phi_8810_ = _e943;
                    } else {
                        phi_8810_ = _e947;
                    }
                    let _e950 = phi_8810_;
                    let _e953 = local_18.member_2[1u];
                    if (_e953[0] < 0.0lf) {
                        phi_8824_ = -(_e953[0]);
                    } else {
                        phi_8824_ = _e953[0];
                    }
                    let _e960 = phi_8824_;
                    if (_e953[1] < 0.0lf) {
                        phi_8831_ = -(_e953[1]);
                    } else {
                        phi_8831_ = _e953[1];
                    }
                    let _e964 = phi_8831_;
                    if (_e960 > _e964) {
                        phi_8836_ = _e960;
                    } else {
                        phi_8836_ = _e964;
                    }
                    let _e967 = phi_8836_;
                    if (_e953[2] < 0.0lf) {
                        phi_8843_ = -(_e953[2]);
                    } else {
                        phi_8843_ = _e953[2];
                    }
                    let _e971 = phi_8843_;
                    if (_e967 > _e971) {
                        phi_8848_ = _e967;
                    } else {
                        phi_8848_ = _e971;
                    }
                    let _e974 = phi_8848_;
                    if (_e950 > _e974) {
                        phi_8853_ = _e950;
                    } else {
                        phi_8853_ = _e974;
                    }
                    let _e977 = phi_8853_;
                    let _e979 = local_18.member_3;
                    let _e980 = (_e977 + _e979);
                    let _e981 = f64(1f);
                    let _e982 = f64(8f);
                    let _e984 = ((_e926 * _e982) * _e980);
                    let _e992 = local_18.member_3;
                    if (_e678 < 0.0lf) {
                        phi_8890_ = -(_e678);
                    } else {
                        phi_8890_ = _e678;
                    }
                    let _e1012 = phi_8890_;
                    if (_e681 < 0.0lf) {
                        phi_8896_ = -(_e681);
                    } else {
                        phi_8896_ = _e681;
                    }
                    let _e1016 = phi_8896_;
                    if (_e684 < 0.0lf) {
                        phi_8903_ = -(_e684);
                    } else {
                        phi_8903_ = _e684;
                    }
                    let _e1021 = phi_8903_;
                    let _e1022 = ((_e1012 + _e1016) + _e1021);
                    if (_e699 < 0.0lf) {
                        phi_8910_ = -(_e699);
                    } else {
                        phi_8910_ = _e699;
                    }
                    let _e1026 = phi_8910_;
                    if (_e702 < 0.0lf) {
                        phi_8916_ = -(_e702);
                    } else {
                        phi_8916_ = _e702;
                    }
                    let _e1030 = phi_8916_;
                    if (_e705 < 0.0lf) {
                        phi_8923_ = -(_e705);
                    } else {
                        phi_8923_ = _e705;
                    }
                    let _e1035 = phi_8923_;
                    let _e1036 = ((_e1026 + _e1030) + _e1035);
                    if (_e1022 > _e1036) {
                        phi_8929_ = _e1022;
                    } else {
                        phi_8929_ = _e1036;
                    }
                    let _e1039 = phi_8929_;
                    if (_e748 < 0.0lf) {
                        phi_8935_ = -(_e748);
                    } else {
                        phi_8935_ = _e748;
                    }
                    let _e1043 = phi_8935_;
                    if (_e749 < 0.0lf) {
                        phi_8941_ = -(_e749);
                    } else {
                        phi_8941_ = _e749;
                    }
                    let _e1047 = phi_8941_;
                    if (_e750 < 0.0lf) {
                        phi_8948_ = -(_e750);
                    } else {
                        phi_8948_ = _e750;
                    }
                    let _e1052 = phi_8948_;
                    let _e1054 = (((_e1043 + _e1047) + _e1052) * f64(0.5f));
                    if (_e1039 > _e1054) {
                        phi_8955_ = _e1039;
                    } else {
                        phi_8955_ = _e1054;
                    }
                    let _e1057 = phi_8955_;
                    let _e1063 = local_18.member_3;
                    let _e1077 = (((((_e872 * _e982) * _e984) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e992 * f64(19f)) * ((_e872 * (_e926 + _e980)) + (_e926 * _e980)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e981 + _e872) * ((_e981 + _e926) * (_e981 + _e980)))));
                    let _e1078 = f64(3f);
                    let _e1079 = (_e761 * _e1078);
                    let _e1080 = (_e818 * _e1078);
                    if (_e1079 < _e1080) {
                        phi_8983_ = _e1079;
                    } else {
                        phi_8983_ = _e1080;
                    }
                    let _e1083 = phi_8983_;
                    if (_e784 < _e807) {
                        phi_8988_ = _e784;
                    } else {
                        phi_8988_ = _e807;
                    }
                    let _e1086 = phi_8988_;
                    if (_e1083 < _e1086) {
                        phi_8993_ = _e1083;
                    } else {
                        phi_8993_ = _e1086;
                    }
                    let _e1089 = phi_8993_;
                    if (_e1079 > _e1080) {
                        phi_8998_ = _e1079;
                    } else {
                        phi_8998_ = _e1080;
                    }
                    let _e1092 = phi_8998_;
                    if (_e784 > _e807) {
                        phi_9003_ = _e784;
                    } else {
                        phi_9003_ = _e807;
                    }
                    let _e1095 = phi_9003_;
                    if (_e1092 > _e1095) {
                        phi_9008_ = _e1092;
                    } else {
                        phi_9008_ = _e1095;
                    }
                    let _e1098 = phi_9008_;
                    let _e1104 = -(_e1098);
                    if (_e1089 > _e1104) {
                        phi_9019_ = _e1089;
                    } else {
                        phi_9019_ = _e1104;
                    }
                    let _e1107 = phi_9019_;
                    if ((_e1107 - (_e1077 + ((_e663 * (((_e1057 + (_e984 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1063 * f64(6f)) * (_e926 + _e980))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e981 + _e926) * (_e981 + _e980))))) * f64((3f * 1.0001f))))) > _e663) {
                        phi_16013_ = type_46(0u, type_46().member_1);
                        phi_16014_ = type_46();
                        phi_16015_ = true;
                    } else {
                        if (_e761 < 0.0lf) {
                            phi_9033_ = -(_e761);
                        } else {
                            phi_9033_ = _e761;
                        }
                        let _e1115 = phi_9033_;
                        if (_e784 < 0.0lf) {
                            phi_9039_ = -(_e784);
                        } else {
                            phi_9039_ = _e784;
                        }
                        let _e1119 = phi_9039_;
                        if (_e1115 > _e1119) {
                            phi_9044_ = _e1115;
                        } else {
                            phi_9044_ = _e1119;
                        }
                        let _e1122 = phi_9044_;
                        if (_e807 < 0.0lf) {
                            phi_9050_ = -(_e807);
                        } else {
                            phi_9050_ = _e807;
                        }
                        let _e1126 = phi_9050_;
                        if (_e818 < 0.0lf) {
                            phi_9056_ = -(_e818);
                        } else {
                            phi_9056_ = _e818;
                        }
                        let _e1130 = phi_9056_;
                        if (_e1126 > _e1130) {
                            phi_9061_ = _e1126;
                        } else {
                            phi_9061_ = _e1130;
                        }
                        let _e1133 = phi_9061_;
                        if (_e1122 > _e1133) {
                            phi_9066_ = _e1122;
                        } else {
                            phi_9066_ = _e1133;
                        }
                        let _e1136 = phi_9066_;
                        let _e1138 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1139 = f64(1f);
                        if (_e1136 >= _e1138) {
                            phi_9076_ = (_e1136 <= (_e1139 / _e1138));
                        } else {
                            phi_9076_ = false;
                        }
                        let _e1144 = phi_9076_;
                        if _e1144 {
                            phi_9083_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_9083_ = f64(2f);
                        }
                        let _e1149 = phi_9083_;
                        let _e1151 = ((_e1077 * f64(0.34f)) + (_e1136 * _e1149));
                        if _e1144 {
                            phi_9091_ = (_e1139 / _e1136);
                        } else {
                            phi_9091_ = f64(0f);
                        }
                        let _e1155 = phi_9091_;
                        let _e1156 = f64(0.00000000000022737368f);
                        let _e1158 = (_e401 * f64(0.0625f));
                        if (_e1156 < _e1158) {
                            phi_9099_ = _e1156;
                        } else {
                            phi_9099_ = _e1158;
                        }
                        let _e1161 = phi_9099_;
                        let _e1163 = (f64(1f) - _e410);
                        let _e1174 = ((((_e761 * _e1163) + (_e784 * _e410)) * (_e1163 * _e1163)) + (((_e807 * _e1163) + (_e818 * _e410)) * (_e410 * _e410)));
                        if (_e1174 < 0.0lf) {
                            phi_9118_ = -(_e1174);
                        } else {
                            phi_9118_ = _e1174;
                        }
                        let _e1178 = phi_9118_;
                        if !((_e1178 > _e1151)) {
                            let _e1181 = f64(0f);
                            let _e1184 = local_18.member[0u];
                            let _e1190 = local_18.member_1[0u];
                            let _e1196 = local_18.member_2[0u];
                            let _e1200 = (_e1184[0] - _e1190[0]);
                            let _e1201 = (_e1184[1] - _e1190[1]);
                            let _e1202 = (_e1184[2] - _e1190[2]);
                            let _e1203 = (_e1184[0] - _e1196[0]);
                            let _e1204 = (_e1184[1] - _e1196[1]);
                            let _e1205 = (_e1184[2] - _e1196[2]);
                            let _e1208 = local_18.member[1u];
                            let _e1214 = local_18.member_1[1u];
                            let _e1220 = local_18.member_2[1u];
                            let _e1224 = (_e1208[0] - _e1214[0]);
                            let _e1225 = (_e1208[1] - _e1214[1]);
                            let _e1226 = (_e1208[2] - _e1214[2]);
                            let _e1227 = (_e1208[0] - _e1220[0]);
                            let _e1228 = (_e1208[1] - _e1220[1]);
                            let _e1229 = (_e1208[2] - _e1220[2]);
                            let _e1232 = local_18.member[0u];
                            if (_e1232[0] < 0.0lf) {
                                phi_9267_ = -(_e1232[0]);
                            } else {
                                phi_9267_ = _e1232[0];
                            }
                            let _e1239 = phi_9267_;
                            if (_e1232[1] < 0.0lf) {
                                phi_9274_ = -(_e1232[1]);
                            } else {
                                phi_9274_ = _e1232[1];
                            }
                            let _e1243 = phi_9274_;
                            if (_e1239 > _e1243) {
                                phi_9279_ = _e1239;
                            } else {
                                phi_9279_ = _e1243;
                            }
                            let _e1246 = phi_9279_;
                            if (_e1232[2] < 0.0lf) {
                                phi_9286_ = -(_e1232[2]);
                            } else {
                                phi_9286_ = _e1232[2];
                            }
                            let _e1250 = phi_9286_;
                            if (_e1246 > _e1250) {
                                phi_9291_ = _e1246;
                            } else {
                                phi_9291_ = _e1250;
                            }
                            let _e1253 = phi_9291_;
                            let _e1256 = local_18.member[1u];
                            if (_e1256[0] < 0.0lf) {
                                phi_9304_ = -(_e1256[0]);
                            } else {
                                phi_9304_ = _e1256[0];
                            }
                            let _e1263 = phi_9304_;
                            if (_e1256[1] < 0.0lf) {
                                phi_9311_ = -(_e1256[1]);
                            } else {
                                phi_9311_ = _e1256[1];
                            }
                            let _e1267 = phi_9311_;
                            if (_e1263 > _e1267) {
                                phi_9316_ = _e1263;
                            } else {
                                phi_9316_ = _e1267;
                            }
                            let _e1270 = phi_9316_;
                            if (_e1256[2] < 0.0lf) {
                                phi_9323_ = -(_e1256[2]);
                            } else {
                                phi_9323_ = _e1256[2];
                            }
                            let _e1274 = phi_9323_;
                            if (_e1270 > _e1274) {
                                phi_9328_ = _e1270;
                            } else {
                                phi_9328_ = _e1274;
                            }
                            let _e1277 = phi_9328_;
                            if (_e1253 > _e1277) {
                                phi_9333_ = _e1253;
                            } else {
                                phi_9333_ = _e1277;
                            }
                            let _e1280 = phi_9333_;
                            let _e1282 = local_18.member_3;
                            let _e1286 = local_18.member_1[0u];
                            if (_e1286[0] < 0.0lf) {
                                phi_9350_ = -(_e1286[0]);
                            } else {
                                phi_9350_ = _e1286[0];
                            }
                            let _e1293 = phi_9350_;
                            if (_e1286[1] < 0.0lf) {
                                phi_9357_ = -(_e1286[1]);
                            } else {
                                phi_9357_ = _e1286[1];
                            }
                            let _e1297 = phi_9357_;
                            if (_e1293 > _e1297) {
                                phi_9362_ = _e1293;
                            } else {
                                phi_9362_ = _e1297;
                            }
                            let _e1300 = phi_9362_;
                            if (_e1286[2] < 0.0lf) {
                                phi_9369_ = -(_e1286[2]);
                            } else {
                                phi_9369_ = _e1286[2];
                            }
                            let _e1304 = phi_9369_;
                            if (_e1300 > _e1304) {
                                phi_9374_ = _e1300;
                            } else {
                                phi_9374_ = _e1304;
                            }
                            let _e1307 = phi_9374_;
                            let _e1310 = local_18.member_1[1u];
                            if (_e1310[0] < 0.0lf) {
                                phi_9388_ = -(_e1310[0]);
                            } else {
                                phi_9388_ = _e1310[0];
                            }
                            let _e1317 = phi_9388_;
                            if (_e1310[1] < 0.0lf) {
                                phi_9395_ = -(_e1310[1]);
                            } else {
                                phi_9395_ = _e1310[1];
                            }
                            let _e1321 = phi_9395_;
                            if (_e1317 > _e1321) {
                                phi_9400_ = _e1317;
                            } else {
                                phi_9400_ = _e1321;
                            }
                            let _e1324 = phi_9400_;
                            if (_e1310[2] < 0.0lf) {
                                phi_9407_ = -(_e1310[2]);
                            } else {
                                phi_9407_ = _e1310[2];
                            }
                            let _e1328 = phi_9407_;
                            if (_e1324 > _e1328) {
                                phi_9412_ = _e1324;
                            } else {
                                phi_9412_ = _e1328;
                            }
                            let _e1331 = phi_9412_;
                            if (_e1307 > _e1331) {
                                phi_9417_ = _e1307;
                            } else {
                                phi_9417_ = _e1331;
                            }
                            let _e1334 = phi_9417_;
                            let _e1336 = local_18.member_3;
                            let _e1340 = local_18.member_2[0u];
                            if (_e1340[0] < 0.0lf) {
                                phi_9434_ = -(_e1340[0]);
                            } else {
                                phi_9434_ = _e1340[0];
                            }
                            let _e1347 = phi_9434_;
                            if (_e1340[1] < 0.0lf) {
                                phi_9441_ = -(_e1340[1]);
                            } else {
                                phi_9441_ = _e1340[1];
                            }
                            let _e1351 = phi_9441_;
                            if (_e1347 > _e1351) {
                                phi_9446_ = _e1347;
                            } else {
                                phi_9446_ = _e1351;
                            }
                            let _e1354 = phi_9446_;
                            if (_e1340[2] < 0.0lf) {
                                phi_9453_ = -(_e1340[2]);
                            } else {
                                phi_9453_ = _e1340[2];
                            }
                            let _e1358 = phi_9453_;
                            if (_e1354 > _e1358) {
                                phi_9458_ = _e1354;
                            } else {
                                phi_9458_ = _e1358;
                            }
                            let _e1361 = phi_9458_;
                            let _e1364 = local_18.member_2[1u];
                            if (_e1364[0] < 0.0lf) {
                                phi_9472_ = -(_e1364[0]);
                            } else {
                                phi_9472_ = _e1364[0];
                            }
                            let _e1371 = phi_9472_;
                            if (_e1364[1] < 0.0lf) {
                                phi_9479_ = -(_e1364[1]);
                            } else {
                                phi_9479_ = _e1364[1];
                            }
                            let _e1375 = phi_9479_;
                            if (_e1371 > _e1375) {
                                phi_9484_ = _e1371;
                            } else {
                                phi_9484_ = _e1375;
                            }
                            let _e1378 = phi_9484_;
                            if (_e1364[2] < 0.0lf) {
                                phi_9491_ = -(_e1364[2]);
                            } else {
                                phi_9491_ = _e1364[2];
                            }
                            let _e1382 = phi_9491_;
                            if (_e1378 > _e1382) {
                                phi_9496_ = _e1378;
                            } else {
                                phi_9496_ = _e1382;
                            }
                            let _e1385 = phi_9496_;
                            if (_e1361 > _e1385) {
                                phi_9501_ = _e1361;
                            } else {
                                phi_9501_ = _e1385;
                            }
                            let _e1388 = phi_9501_;
                            let _e1390 = local_18.member_3;
                            let _e1398 = local_18.member_3;
                            let _e1404 = ((((((_e1280 + _e1282) + (_e1334 + _e1336)) + (_e1388 + _e1390)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1398 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f)));
                            let _e1407 = local_18.member[0u];
                            let _e1413 = local_18.member[1u];
                            let _e1429 = local_18.member_1[0u];
                            let _e1435 = local_18.member_1[1u];
                            let _e1451 = local_18.member_2[0u];
                            let _e1457 = local_18.member_2[1u];
                            let _e1471 = function_3(array<f64, 3>((_e1407[0] + ((_e1413[0] - _e1407[0]) * _e410)), (_e1407[1] + ((_e1413[1] - _e1407[1]) * _e410)), (_e1407[2] + ((_e1413[2] - _e1407[2]) * _e410))), array<f64, 3>((_e1429[0] + ((_e1435[0] - _e1429[0]) * _e410)), (_e1429[1] + ((_e1435[1] - _e1429[1]) * _e410)), (_e1429[2] + ((_e1435[2] - _e1429[2]) * _e410))), array<f64, 3>((_e1451[0] + ((_e1457[0] - _e1451[0]) * _e410)), (_e1451[1] + ((_e1457[1] - _e1451[1]) * _e410)), (_e1451[2] + ((_e1457[2] - _e1451[2]) * _e410))), 0u);
                            if (_e1471[0] < 0.0lf) {
                                phi_9622_ = -(_e1471[0]);
                            } else {
                                phi_9622_ = _e1471[0];
                            }
                            let _e1476 = phi_9622_;
                            if (_e1471[1] < 0.0lf) {
                                phi_9629_ = -(_e1471[1]);
                            } else {
                                phi_9629_ = _e1471[1];
                            }
                            let _e1481 = phi_9629_;
                            if (_e1471[2] < 0.0lf) {
                                phi_9637_ = -(_e1471[2]);
                            } else {
                                phi_9637_ = _e1471[2];
                            }
                            let _e1487 = phi_9637_;
                            let _e1488 = ((_e1476 + _e1481) + _e1487);
                            if (_e1488 > f64(0f)) {
                                if ((bitcast<u64>(_e1488) & 9218868437227405312lu) != 9218868437227405312lu) {
                                    let _e1495 = (f64(1f) / _e1488);
                                    let _e1497 = (_e1471[0] * _e1495);
                                    let _e1499 = (_e1471[1] * _e1495);
                                    let _e1501 = (_e1471[2] * _e1495);
                                    let _e1506 = (((_e1497 * _e1497) + (_e1499 * _e1499)) + (_e1501 * _e1501));
                                    if (_e1506 <= 2.2250738585072014e-308lf) {
                                        if (_e1506 > 0.0lf) {
                                            phi_9676_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_9676_ = 0.0lf;
                                        }
                                        let _e1558 = phi_9676_;
                                        phi_9740_ = _e1558;
                                    } else {
                                        phi_9683_ = type_16(0i, 5i);
                                        phi_9686_ = bitcast<f64>(((bitcast<u64>(_e1506) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1513 = phi_9683_;
                                            let _e1515 = phi_9686_;
                                            local_19 = _e1515;
                                            if (_e1513.member < _e1513.member_1) {
                                                let _e1522 = (_e1513.member + 1i);
                                                if ((false == (_e1522 > _e1513.member)) != false) {
                                                    phi_9707_ = true;
                                                } else {
                                                    phi_9707_ = false;
                                                }
                                                let _e1527 = phi_9707_;
                                                if _e1527 {
                                                    phi_9713_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_9713_ = type_17(1u, _e1522);
                                                }
                                                let _e1532 = phi_9713_;
                                                phi_9684_ = type_16(_e1532.member_1, _e1513.member_1);
                                                phi_9727_ = type_17(1u, _e1513.member);
                                            } else {
                                                phi_9684_ = _e1513;
                                                phi_9727_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e1538 = phi_9684_;
                                            let _e1540 = phi_9727_;
                                            let _e1543 = (bitcast<i32>(_e1540.member) != 0i);
                                            if _e1543 {
                                                phi_9687_ = (0.5lf * (_e1515 + (_e1506 / _e1515)));
                                            } else {
                                                phi_9687_ = f64();
                                            }
                                            let _e1548 = phi_9687_;
                                            continue;
                                            continuing {
                                                phi_9683_ = _e1538;
                                                phi_9686_ = _e1548;
                                                break if !(_e1543);
                                            }
                                        }
                                        let _e1553 = local_19;
                                        phi_9740_ = (_e1553 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e1560 = phi_9740_;
                                    let _e1562 = (1.1102230246251565e-16lf * f64(12f));
                                    let _e1569 = ((_e1404 * f64(1.01f)) + ((_e1181 * _e1560) * (f64(1f) + _e1562)));
                                    let _e1574 = (((_e1497 * _e1184[0]) + (_e1499 * _e1184[1])) + (_e1501 * _e1184[2]));
                                    let _e1579 = (((_e1497 * _e1200) + (_e1499 * _e1201)) + (_e1501 * _e1202));
                                    let _e1584 = (((_e1497 * _e1203) + (_e1499 * _e1204)) + (_e1501 * _e1205));
                                    let _e1589 = (((_e1497 * _e1184[0]) + (_e1499 * _e1184[1])) + (_e1501 * _e1184[2]));
                                    let _e1595 = (((_e1497 * _e1208[0]) + (_e1499 * _e1208[1])) + (_e1501 * _e1208[2]));
                                    let _e1600 = (((_e1497 * _e1224) + (_e1499 * _e1225)) + (_e1501 * _e1226));
                                    let _e1605 = (((_e1497 * _e1227) + (_e1499 * _e1228)) + (_e1501 * _e1229));
                                    let _e1610 = (((_e1497 * _e1208[0]) + (_e1499 * _e1208[1])) + (_e1501 * _e1208[2]));
                                    if (_e1574 < 0.0lf) {
                                        phi_9809_ = -(_e1574);
                                    } else {
                                        phi_9809_ = _e1574;
                                    }
                                    let _e1615 = phi_9809_;
                                    if (_e1595 < 0.0lf) {
                                        phi_9815_ = -(_e1595);
                                    } else {
                                        phi_9815_ = _e1595;
                                    }
                                    let _e1619 = phi_9815_;
                                    if (_e1579 < 0.0lf) {
                                        phi_9824_ = -(_e1579);
                                    } else {
                                        phi_9824_ = _e1579;
                                    }
                                    let _e1626 = phi_9824_;
                                    if (_e1600 < 0.0lf) {
                                        phi_9830_ = -(_e1600);
                                    } else {
                                        phi_9830_ = _e1600;
                                    }
                                    let _e1630 = phi_9830_;
                                    if (_e1584 < 0.0lf) {
                                        phi_9839_ = -(_e1584);
                                    } else {
                                        phi_9839_ = _e1584;
                                    }
                                    let _e1637 = phi_9839_;
                                    if (_e1605 < 0.0lf) {
                                        phi_9845_ = -(_e1605);
                                    } else {
                                        phi_9845_ = _e1605;
                                    }
                                    let _e1641 = phi_9845_;
                                    if (_e1589 < 0.0lf) {
                                        phi_9854_ = -(_e1589);
                                    } else {
                                        phi_9854_ = _e1589;
                                    }
                                    let _e1648 = phi_9854_;
                                    if (_e1610 < 0.0lf) {
                                        phi_9860_ = -(_e1610);
                                    } else {
                                        phi_9860_ = _e1610;
                                    }
                                    let _e1652 = phi_9860_;
                                    phi_9866_ = type_38(array<f64, 4>(_e1574, _e1579, _e1584, _e1589), array<f64, 4>(_e1595, _e1600, _e1605, _e1610), array<f64, 4>((_e1569 + ((_e1615 + _e1619) * _e1562)), (_e1569 + ((_e1626 + _e1630) * _e1562)), (_e1569 + ((_e1637 + _e1641) * _e1562)), (_e1569 + ((_e1648 + _e1652) * _e1562))));
                                    phi_9867_ = false;
                                } else {
                                    phi_9866_ = type_38();
                                    phi_9867_ = true;
                                }
                                let _e1659 = phi_9866_;
                                let _e1661 = phi_9867_;
                                phi_9868_ = _e1659;
                                phi_9869_ = _e1661;
                            } else {
                                phi_9868_ = type_38();
                                phi_9869_ = true;
                            }
                            let _e1663 = phi_9868_;
                            let _e1665 = phi_9869_;
                            if _e1665 {
                                let _e1666 = f64(0f);
                                let _e1667 = f64(1f);
                                phi_9879_ = type_38(array<f64, 4>(_e1666, _e1666, _e1666, _e1666), array<f64, 4>(_e1666, _e1666, _e1666, _e1666), array<f64, 4>(_e1667, _e1667, _e1667, _e1667));
                            } else {
                                phi_9879_ = _e1663;
                            }
                            let _e1673 = phi_9879_;
                            local_8 = type_38(array<f64, 4>(_e1673.member[0], _e1673.member[1], _e1673.member[2], _e1673.member[3]), array<f64, 4>(_e1673.member_1[0], _e1673.member_1[1], _e1673.member_1[2], _e1673.member_1[3]), array<f64, 4>(_e1673.member_2[0], _e1673.member_2[1], _e1673.member_2[2], _e1673.member_2[3]));
                            let _e1693 = f64(0f);
                            let _e1696 = local_8.member[0u];
                            let _e1699 = local_8.member_1[0u];
                            let _e1702 = local_8.member[0u];
                            let _e1708 = local_8.member_2[0u];
                            if (((_e1696 + ((_e1699 - _e1702) * _e410)) - _e1708) > _e1693) {
                                let _e1713 = local_8.member[1u];
                                let _e1716 = local_8.member_1[1u];
                                let _e1719 = local_8.member[1u];
                                let _e1725 = local_8.member_2[1u];
                                if (((_e1713 + ((_e1716 - _e1719) * _e410)) - _e1725) > _e1693) {
                                    let _e1730 = local_8.member[2u];
                                    let _e1733 = local_8.member_1[2u];
                                    let _e1736 = local_8.member[2u];
                                    let _e1742 = local_8.member_2[2u];
                                    if (((_e1730 + ((_e1733 - _e1736) * _e410)) - _e1742) > _e1693) {
                                        let _e1747 = local_8.member[3u];
                                        let _e1750 = local_8.member_1[3u];
                                        let _e1753 = local_8.member[3u];
                                        let _e1759 = local_8.member_2[3u];
                                        phi_10049_ = (((_e1747 + ((_e1750 - _e1753) * _e410)) - _e1759) > _e1693);
                                        phi_10050_ = false;
                                    } else {
                                        phi_10049_ = bool();
                                        phi_10050_ = true;
                                    }
                                    let _e1763 = phi_10049_;
                                    let _e1765 = phi_10050_;
                                    phi_10051_ = _e1763;
                                    phi_10052_ = _e1765;
                                } else {
                                    phi_10051_ = bool();
                                    phi_10052_ = true;
                                }
                                let _e1767 = phi_10051_;
                                let _e1769 = phi_10052_;
                                phi_10053_ = _e1767;
                                phi_10054_ = _e1769;
                            } else {
                                phi_10053_ = bool();
                                phi_10054_ = true;
                            }
                            let _e1771 = phi_10053_;
                            let _e1773 = phi_10054_;
                            if _e1773 {
                                phi_10058_ = false;
                            } else {
                                phi_10058_ = _e1771;
                            }
                            let _e1775 = phi_10058_;
                            if _e1775 {
                                phi_11439_ = bool();
                                phi_11440_ = true;
                            } else {
                                let _e1776 = f64(0f);
                                if (_e1471[0] < 0.0lf) {
                                    phi_10086_ = -(_e1471[0]);
                                } else {
                                    phi_10086_ = _e1471[0];
                                }
                                let _e1781 = phi_10086_;
                                if (_e1776 < 0.0lf) {
                                    phi_10092_ = -(_e1776);
                                } else {
                                    phi_10092_ = _e1776;
                                }
                                let _e1785 = phi_10092_;
                                if (_e1776 < 0.0lf) {
                                    phi_10099_ = -(_e1776);
                                } else {
                                    phi_10099_ = _e1776;
                                }
                                let _e1790 = phi_10099_;
                                let _e1791 = ((_e1781 + _e1785) + _e1790);
                                if (_e1791 > f64(0f)) {
                                    if ((bitcast<u64>(_e1791) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e1798 = (f64(1f) / _e1791);
                                        let _e1799 = (_e1471[0] * _e1798);
                                        let _e1800 = (_e1776 * _e1798);
                                        let _e1801 = (_e1776 * _e1798);
                                        let _e1806 = (((_e1799 * _e1799) + (_e1800 * _e1800)) + (_e1801 * _e1801));
                                        if (_e1806 <= 2.2250738585072014e-308lf) {
                                            if (_e1806 > 0.0lf) {
                                                phi_10135_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_10135_ = 0.0lf;
                                            }
                                            let _e1858 = phi_10135_;
                                            phi_10199_ = _e1858;
                                        } else {
                                            phi_10142_ = type_16(0i, 5i);
                                            phi_10145_ = bitcast<f64>(((bitcast<u64>(_e1806) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e1813 = phi_10142_;
                                                let _e1815 = phi_10145_;
                                                local_20 = _e1815;
                                                if (_e1813.member < _e1813.member_1) {
                                                    let _e1822 = (_e1813.member + 1i);
                                                    if ((false == (_e1822 > _e1813.member)) != false) {
                                                        phi_10166_ = true;
                                                    } else {
                                                        phi_10166_ = false;
                                                    }
                                                    let _e1827 = phi_10166_;
                                                    if _e1827 {
                                                        phi_10172_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_10172_ = type_17(1u, _e1822);
                                                    }
                                                    let _e1832 = phi_10172_;
                                                    phi_10143_ = type_16(_e1832.member_1, _e1813.member_1);
                                                    phi_10186_ = type_17(1u, _e1813.member);
                                                } else {
                                                    phi_10143_ = _e1813;
                                                    phi_10186_ = type_17(0u, type_17().member_1);
                                                }
                                                let _e1838 = phi_10143_;
                                                let _e1840 = phi_10186_;
                                                let _e1843 = (bitcast<i32>(_e1840.member) != 0i);
                                                if _e1843 {
                                                    phi_10146_ = (0.5lf * (_e1815 + (_e1806 / _e1815)));
                                                } else {
                                                    phi_10146_ = f64();
                                                }
                                                let _e1848 = phi_10146_;
                                                continue;
                                                continuing {
                                                    phi_10142_ = _e1838;
                                                    phi_10145_ = _e1848;
                                                    break if !(_e1843);
                                                }
                                            }
                                            let _e1853 = local_20;
                                            phi_10199_ = (_e1853 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e1860 = phi_10199_;
                                        let _e1862 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e1869 = ((_e1404 * f64(1.01f)) + ((_e1181 * _e1860) * (f64(1f) + _e1862)));
                                        let _e1874 = (((_e1799 * _e1184[0]) + (_e1800 * _e1184[1])) + (_e1801 * _e1184[2]));
                                        let _e1879 = (((_e1799 * _e1200) + (_e1800 * _e1201)) + (_e1801 * _e1202));
                                        let _e1884 = (((_e1799 * _e1203) + (_e1800 * _e1204)) + (_e1801 * _e1205));
                                        let _e1889 = (((_e1799 * _e1184[0]) + (_e1800 * _e1184[1])) + (_e1801 * _e1184[2]));
                                        let _e1895 = (((_e1799 * _e1208[0]) + (_e1800 * _e1208[1])) + (_e1801 * _e1208[2]));
                                        let _e1900 = (((_e1799 * _e1224) + (_e1800 * _e1225)) + (_e1801 * _e1226));
                                        let _e1905 = (((_e1799 * _e1227) + (_e1800 * _e1228)) + (_e1801 * _e1229));
                                        let _e1910 = (((_e1799 * _e1208[0]) + (_e1800 * _e1208[1])) + (_e1801 * _e1208[2]));
                                        if (_e1874 < 0.0lf) {
                                            phi_10268_ = -(_e1874);
                                        } else {
                                            phi_10268_ = _e1874;
                                        }
                                        let _e1915 = phi_10268_;
                                        if (_e1895 < 0.0lf) {
                                            phi_10274_ = -(_e1895);
                                        } else {
                                            phi_10274_ = _e1895;
                                        }
                                        let _e1919 = phi_10274_;
                                        if (_e1879 < 0.0lf) {
                                            phi_10283_ = -(_e1879);
                                        } else {
                                            phi_10283_ = _e1879;
                                        }
                                        let _e1926 = phi_10283_;
                                        if (_e1900 < 0.0lf) {
                                            phi_10289_ = -(_e1900);
                                        } else {
                                            phi_10289_ = _e1900;
                                        }
                                        let _e1930 = phi_10289_;
                                        if (_e1884 < 0.0lf) {
                                            phi_10298_ = -(_e1884);
                                        } else {
                                            phi_10298_ = _e1884;
                                        }
                                        let _e1937 = phi_10298_;
                                        if (_e1905 < 0.0lf) {
                                            phi_10304_ = -(_e1905);
                                        } else {
                                            phi_10304_ = _e1905;
                                        }
                                        let _e1941 = phi_10304_;
                                        if (_e1889 < 0.0lf) {
                                            phi_10313_ = -(_e1889);
                                        } else {
                                            phi_10313_ = _e1889;
                                        }
                                        let _e1948 = phi_10313_;
                                        if (_e1910 < 0.0lf) {
                                            phi_10319_ = -(_e1910);
                                        } else {
                                            phi_10319_ = _e1910;
                                        }
                                        let _e1952 = phi_10319_;
                                        phi_10325_ = type_38(array<f64, 4>(_e1874, _e1879, _e1884, _e1889), array<f64, 4>(_e1895, _e1900, _e1905, _e1910), array<f64, 4>((_e1869 + ((_e1915 + _e1919) * _e1862)), (_e1869 + ((_e1926 + _e1930) * _e1862)), (_e1869 + ((_e1937 + _e1941) * _e1862)), (_e1869 + ((_e1948 + _e1952) * _e1862))));
                                        phi_10326_ = false;
                                    } else {
                                        phi_10325_ = type_38();
                                        phi_10326_ = true;
                                    }
                                    let _e1959 = phi_10325_;
                                    let _e1961 = phi_10326_;
                                    phi_10327_ = _e1959;
                                    phi_10328_ = _e1961;
                                } else {
                                    phi_10327_ = type_38();
                                    phi_10328_ = true;
                                }
                                let _e1963 = phi_10327_;
                                let _e1965 = phi_10328_;
                                if _e1965 {
                                    let _e1966 = f64(0f);
                                    let _e1967 = f64(1f);
                                    phi_10338_ = type_38(array<f64, 4>(_e1966, _e1966, _e1966, _e1966), array<f64, 4>(_e1966, _e1966, _e1966, _e1966), array<f64, 4>(_e1967, _e1967, _e1967, _e1967));
                                } else {
                                    phi_10338_ = _e1963;
                                }
                                let _e1973 = phi_10338_;
                                local_9 = type_38(array<f64, 4>(_e1973.member[0], _e1973.member[1], _e1973.member[2], _e1973.member[3]), array<f64, 4>(_e1973.member_1[0], _e1973.member_1[1], _e1973.member_1[2], _e1973.member_1[3]), array<f64, 4>(_e1973.member_2[0], _e1973.member_2[1], _e1973.member_2[2], _e1973.member_2[3]));
                                let _e1993 = f64(0f);
                                let _e1996 = local_9.member[0u];
                                let _e1999 = local_9.member_1[0u];
                                let _e2002 = local_9.member[0u];
                                let _e2008 = local_9.member_2[0u];
                                if (((_e1996 + ((_e1999 - _e2002) * _e410)) - _e2008) > _e1993) {
                                    let _e2013 = local_9.member[1u];
                                    let _e2016 = local_9.member_1[1u];
                                    let _e2019 = local_9.member[1u];
                                    let _e2025 = local_9.member_2[1u];
                                    if (((_e2013 + ((_e2016 - _e2019) * _e410)) - _e2025) > _e1993) {
                                        let _e2030 = local_9.member[2u];
                                        let _e2033 = local_9.member_1[2u];
                                        let _e2036 = local_9.member[2u];
                                        let _e2042 = local_9.member_2[2u];
                                        if (((_e2030 + ((_e2033 - _e2036) * _e410)) - _e2042) > _e1993) {
                                            let _e2047 = local_9.member[3u];
                                            let _e2050 = local_9.member_1[3u];
                                            let _e2053 = local_9.member[3u];
                                            let _e2059 = local_9.member_2[3u];
                                            phi_10508_ = (((_e2047 + ((_e2050 - _e2053) * _e410)) - _e2059) > _e1993);
                                            phi_10509_ = false;
                                        } else {
                                            phi_10508_ = bool();
                                            phi_10509_ = true;
                                        }
                                        let _e2063 = phi_10508_;
                                        let _e2065 = phi_10509_;
                                        phi_10510_ = _e2063;
                                        phi_10511_ = _e2065;
                                    } else {
                                        phi_10510_ = bool();
                                        phi_10511_ = true;
                                    }
                                    let _e2067 = phi_10510_;
                                    let _e2069 = phi_10511_;
                                    phi_10512_ = _e2067;
                                    phi_10513_ = _e2069;
                                } else {
                                    phi_10512_ = bool();
                                    phi_10513_ = true;
                                }
                                let _e2071 = phi_10512_;
                                let _e2073 = phi_10513_;
                                if _e2073 {
                                    phi_10517_ = false;
                                } else {
                                    phi_10517_ = _e2071;
                                }
                                let _e2075 = phi_10517_;
                                if _e2075 {
                                    phi_11437_ = bool();
                                    phi_11438_ = true;
                                } else {
                                    let _e2076 = f64(0f);
                                    if (_e2076 < 0.0lf) {
                                        phi_10545_ = -(_e2076);
                                    } else {
                                        phi_10545_ = _e2076;
                                    }
                                    let _e2081 = phi_10545_;
                                    if (_e1471[1] < 0.0lf) {
                                        phi_10551_ = -(_e1471[1]);
                                    } else {
                                        phi_10551_ = _e1471[1];
                                    }
                                    let _e2085 = phi_10551_;
                                    if (_e2076 < 0.0lf) {
                                        phi_10558_ = -(_e2076);
                                    } else {
                                        phi_10558_ = _e2076;
                                    }
                                    let _e2090 = phi_10558_;
                                    let _e2091 = ((_e2081 + _e2085) + _e2090);
                                    if (_e2091 > f64(0f)) {
                                        if ((bitcast<u64>(_e2091) & 9218868437227405312lu) != 9218868437227405312lu) {
                                            let _e2098 = (f64(1f) / _e2091);
                                            let _e2099 = (_e2076 * _e2098);
                                            let _e2100 = (_e1471[1] * _e2098);
                                            let _e2101 = (_e2076 * _e2098);
                                            let _e2106 = (((_e2099 * _e2099) + (_e2100 * _e2100)) + (_e2101 * _e2101));
                                            if (_e2106 <= 2.2250738585072014e-308lf) {
                                                if (_e2106 > 0.0lf) {
                                                    phi_10594_ = (1.464336215552873e-154lf * 2.0lf);
                                                } else {
                                                    phi_10594_ = 0.0lf;
                                                }
                                                let _e2158 = phi_10594_;
                                                phi_10658_ = _e2158;
                                            } else {
                                                phi_10601_ = type_16(0i, 5i);
                                                phi_10604_ = bitcast<f64>(((bitcast<u64>(_e2106) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e2113 = phi_10601_;
                                                    let _e2115 = phi_10604_;
                                                    local_21 = _e2115;
                                                    if (_e2113.member < _e2113.member_1) {
                                                        let _e2122 = (_e2113.member + 1i);
                                                        if ((false == (_e2122 > _e2113.member)) != false) {
                                                            phi_10625_ = true;
                                                        } else {
                                                            phi_10625_ = false;
                                                        }
                                                        let _e2127 = phi_10625_;
                                                        if _e2127 {
                                                            phi_10631_ = type_17(0u, type_17().member_1);
                                                        } else {
                                                            phi_10631_ = type_17(1u, _e2122);
                                                        }
                                                        let _e2132 = phi_10631_;
                                                        phi_10602_ = type_16(_e2132.member_1, _e2113.member_1);
                                                        phi_10645_ = type_17(1u, _e2113.member);
                                                    } else {
                                                        phi_10602_ = _e2113;
                                                        phi_10645_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e2138 = phi_10602_;
                                                    let _e2140 = phi_10645_;
                                                    let _e2143 = (bitcast<i32>(_e2140.member) != 0i);
                                                    if _e2143 {
                                                        phi_10605_ = (0.5lf * (_e2115 + (_e2106 / _e2115)));
                                                    } else {
                                                        phi_10605_ = f64();
                                                    }
                                                    let _e2148 = phi_10605_;
                                                    continue;
                                                    continuing {
                                                        phi_10601_ = _e2138;
                                                        phi_10604_ = _e2148;
                                                        break if !(_e2143);
                                                    }
                                                }
                                                let _e2153 = local_21;
                                                phi_10658_ = (_e2153 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e2160 = phi_10658_;
                                            let _e2162 = (1.1102230246251565e-16lf * f64(12f));
                                            let _e2169 = ((_e1404 * f64(1.01f)) + ((_e1181 * _e2160) * (f64(1f) + _e2162)));
                                            let _e2174 = (((_e2099 * _e1184[0]) + (_e2100 * _e1184[1])) + (_e2101 * _e1184[2]));
                                            let _e2179 = (((_e2099 * _e1200) + (_e2100 * _e1201)) + (_e2101 * _e1202));
                                            let _e2184 = (((_e2099 * _e1203) + (_e2100 * _e1204)) + (_e2101 * _e1205));
                                            let _e2189 = (((_e2099 * _e1184[0]) + (_e2100 * _e1184[1])) + (_e2101 * _e1184[2]));
                                            let _e2195 = (((_e2099 * _e1208[0]) + (_e2100 * _e1208[1])) + (_e2101 * _e1208[2]));
                                            let _e2200 = (((_e2099 * _e1224) + (_e2100 * _e1225)) + (_e2101 * _e1226));
                                            let _e2205 = (((_e2099 * _e1227) + (_e2100 * _e1228)) + (_e2101 * _e1229));
                                            let _e2210 = (((_e2099 * _e1208[0]) + (_e2100 * _e1208[1])) + (_e2101 * _e1208[2]));
                                            if (_e2174 < 0.0lf) {
                                                phi_10727_ = -(_e2174);
                                            } else {
                                                phi_10727_ = _e2174;
                                            }
                                            let _e2215 = phi_10727_;
                                            if (_e2195 < 0.0lf) {
                                                phi_10733_ = -(_e2195);
                                            } else {
                                                phi_10733_ = _e2195;
                                            }
                                            let _e2219 = phi_10733_;
                                            if (_e2179 < 0.0lf) {
                                                phi_10742_ = -(_e2179);
                                            } else {
                                                phi_10742_ = _e2179;
                                            }
                                            let _e2226 = phi_10742_;
                                            if (_e2200 < 0.0lf) {
                                                phi_10748_ = -(_e2200);
                                            } else {
                                                phi_10748_ = _e2200;
                                            }
                                            let _e2230 = phi_10748_;
                                            if (_e2184 < 0.0lf) {
                                                phi_10757_ = -(_e2184);
                                            } else {
                                                phi_10757_ = _e2184;
                                            }
                                            let _e2237 = phi_10757_;
                                            if (_e2205 < 0.0lf) {
                                                phi_10763_ = -(_e2205);
                                            } else {
                                                phi_10763_ = _e2205;
                                            }
                                            let _e2241 = phi_10763_;
                                            if (_e2189 < 0.0lf) {
                                                phi_10772_ = -(_e2189);
                                            } else {
                                                phi_10772_ = _e2189;
                                            }
                                            let _e2248 = phi_10772_;
                                            if (_e2210 < 0.0lf) {
                                                phi_10778_ = -(_e2210);
                                            } else {
                                                phi_10778_ = _e2210;
                                            }
                                            let _e2252 = phi_10778_;
                                            phi_10784_ = type_38(array<f64, 4>(_e2174, _e2179, _e2184, _e2189), array<f64, 4>(_e2195, _e2200, _e2205, _e2210), array<f64, 4>((_e2169 + ((_e2215 + _e2219) * _e2162)), (_e2169 + ((_e2226 + _e2230) * _e2162)), (_e2169 + ((_e2237 + _e2241) * _e2162)), (_e2169 + ((_e2248 + _e2252) * _e2162))));
                                            phi_10785_ = false;
                                        } else {
                                            phi_10784_ = type_38();
                                            phi_10785_ = true;
                                        }
                                        let _e2259 = phi_10784_;
                                        let _e2261 = phi_10785_;
                                        phi_10786_ = _e2259;
                                        phi_10787_ = _e2261;
                                    } else {
                                        phi_10786_ = type_38();
                                        phi_10787_ = true;
                                    }
                                    let _e2263 = phi_10786_;
                                    let _e2265 = phi_10787_;
                                    if _e2265 {
                                        let _e2266 = f64(0f);
                                        let _e2267 = f64(1f);
                                        phi_10797_ = type_38(array<f64, 4>(_e2266, _e2266, _e2266, _e2266), array<f64, 4>(_e2266, _e2266, _e2266, _e2266), array<f64, 4>(_e2267, _e2267, _e2267, _e2267));
                                    } else {
                                        phi_10797_ = _e2263;
                                    }
                                    let _e2273 = phi_10797_;
                                    local_10 = type_38(array<f64, 4>(_e2273.member[0], _e2273.member[1], _e2273.member[2], _e2273.member[3]), array<f64, 4>(_e2273.member_1[0], _e2273.member_1[1], _e2273.member_1[2], _e2273.member_1[3]), array<f64, 4>(_e2273.member_2[0], _e2273.member_2[1], _e2273.member_2[2], _e2273.member_2[3]));
                                    let _e2293 = f64(0f);
                                    let _e2296 = local_10.member[0u];
                                    let _e2299 = local_10.member_1[0u];
                                    let _e2302 = local_10.member[0u];
                                    let _e2308 = local_10.member_2[0u];
                                    if (((_e2296 + ((_e2299 - _e2302) * _e410)) - _e2308) > _e2293) {
                                        let _e2313 = local_10.member[1u];
                                        let _e2316 = local_10.member_1[1u];
                                        let _e2319 = local_10.member[1u];
                                        let _e2325 = local_10.member_2[1u];
                                        if (((_e2313 + ((_e2316 - _e2319) * _e410)) - _e2325) > _e2293) {
                                            let _e2330 = local_10.member[2u];
                                            let _e2333 = local_10.member_1[2u];
                                            let _e2336 = local_10.member[2u];
                                            let _e2342 = local_10.member_2[2u];
                                            if (((_e2330 + ((_e2333 - _e2336) * _e410)) - _e2342) > _e2293) {
                                                let _e2347 = local_10.member[3u];
                                                let _e2350 = local_10.member_1[3u];
                                                let _e2353 = local_10.member[3u];
                                                let _e2359 = local_10.member_2[3u];
                                                phi_10967_ = (((_e2347 + ((_e2350 - _e2353) * _e410)) - _e2359) > _e2293);
                                                phi_10968_ = false;
                                            } else {
                                                phi_10967_ = bool();
                                                phi_10968_ = true;
                                            }
                                            let _e2363 = phi_10967_;
                                            let _e2365 = phi_10968_;
                                            phi_10969_ = _e2363;
                                            phi_10970_ = _e2365;
                                        } else {
                                            phi_10969_ = bool();
                                            phi_10970_ = true;
                                        }
                                        let _e2367 = phi_10969_;
                                        let _e2369 = phi_10970_;
                                        phi_10971_ = _e2367;
                                        phi_10972_ = _e2369;
                                    } else {
                                        phi_10971_ = bool();
                                        phi_10972_ = true;
                                    }
                                    let _e2371 = phi_10971_;
                                    let _e2373 = phi_10972_;
                                    if _e2373 {
                                        phi_10976_ = false;
                                    } else {
                                        phi_10976_ = _e2371;
                                    }
                                    let _e2375 = phi_10976_;
                                    if _e2375 {
                                        phi_11436_ = bool();
                                    } else {
                                        let _e2376 = f64(0f);
                                        if (_e2376 < 0.0lf) {
                                            phi_11004_ = -(_e2376);
                                        } else {
                                            phi_11004_ = _e2376;
                                        }
                                        let _e2381 = phi_11004_;
                                        if (_e2376 < 0.0lf) {
                                            phi_11010_ = -(_e2376);
                                        } else {
                                            phi_11010_ = _e2376;
                                        }
                                        let _e2385 = phi_11010_;
                                        if (_e1471[2] < 0.0lf) {
                                            phi_11017_ = -(_e1471[2]);
                                        } else {
                                            phi_11017_ = _e1471[2];
                                        }
                                        let _e2390 = phi_11017_;
                                        let _e2391 = ((_e2381 + _e2385) + _e2390);
                                        if (_e2391 > f64(0f)) {
                                            if ((bitcast<u64>(_e2391) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2398 = (f64(1f) / _e2391);
                                                let _e2399 = (_e2376 * _e2398);
                                                let _e2400 = (_e2376 * _e2398);
                                                let _e2401 = (_e1471[2] * _e2398);
                                                let _e2406 = (((_e2399 * _e2399) + (_e2400 * _e2400)) + (_e2401 * _e2401));
                                                if (_e2406 <= 2.2250738585072014e-308lf) {
                                                    if (_e2406 > 0.0lf) {
                                                        phi_11053_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_11053_ = 0.0lf;
                                                    }
                                                    let _e2458 = phi_11053_;
                                                    phi_11117_ = _e2458;
                                                } else {
                                                    phi_11060_ = type_16(0i, 5i);
                                                    phi_11063_ = bitcast<f64>(((bitcast<u64>(_e2406) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2413 = phi_11060_;
                                                        let _e2415 = phi_11063_;
                                                        local_22 = _e2415;
                                                        if (_e2413.member < _e2413.member_1) {
                                                            let _e2422 = (_e2413.member + 1i);
                                                            if ((false == (_e2422 > _e2413.member)) != false) {
                                                                phi_11084_ = true;
                                                            } else {
                                                                phi_11084_ = false;
                                                            }
                                                            let _e2427 = phi_11084_;
                                                            if _e2427 {
                                                                phi_11090_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_11090_ = type_17(1u, _e2422);
                                                            }
                                                            let _e2432 = phi_11090_;
                                                            phi_11061_ = type_16(_e2432.member_1, _e2413.member_1);
                                                            phi_11104_ = type_17(1u, _e2413.member);
                                                        } else {
                                                            phi_11061_ = _e2413;
                                                            phi_11104_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e2438 = phi_11061_;
                                                        let _e2440 = phi_11104_;
                                                        let _e2443 = (bitcast<i32>(_e2440.member) != 0i);
                                                        if _e2443 {
                                                            phi_11064_ = (0.5lf * (_e2415 + (_e2406 / _e2415)));
                                                        } else {
                                                            phi_11064_ = f64();
                                                        }
                                                        let _e2448 = phi_11064_;
                                                        continue;
                                                        continuing {
                                                            phi_11060_ = _e2438;
                                                            phi_11063_ = _e2448;
                                                            break if !(_e2443);
                                                        }
                                                    }
                                                    let _e2453 = local_22;
                                                    phi_11117_ = (_e2453 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2460 = phi_11117_;
                                                let _e2462 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2469 = ((_e1404 * f64(1.01f)) + ((_e1181 * _e2460) * (f64(1f) + _e2462)));
                                                let _e2474 = (((_e2399 * _e1184[0]) + (_e2400 * _e1184[1])) + (_e2401 * _e1184[2]));
                                                let _e2479 = (((_e2399 * _e1200) + (_e2400 * _e1201)) + (_e2401 * _e1202));
                                                let _e2484 = (((_e2399 * _e1203) + (_e2400 * _e1204)) + (_e2401 * _e1205));
                                                let _e2489 = (((_e2399 * _e1184[0]) + (_e2400 * _e1184[1])) + (_e2401 * _e1184[2]));
                                                let _e2495 = (((_e2399 * _e1208[0]) + (_e2400 * _e1208[1])) + (_e2401 * _e1208[2]));
                                                let _e2500 = (((_e2399 * _e1224) + (_e2400 * _e1225)) + (_e2401 * _e1226));
                                                let _e2505 = (((_e2399 * _e1227) + (_e2400 * _e1228)) + (_e2401 * _e1229));
                                                let _e2510 = (((_e2399 * _e1208[0]) + (_e2400 * _e1208[1])) + (_e2401 * _e1208[2]));
                                                if (_e2474 < 0.0lf) {
                                                    phi_11186_ = -(_e2474);
                                                } else {
                                                    phi_11186_ = _e2474;
                                                }
                                                let _e2515 = phi_11186_;
                                                if (_e2495 < 0.0lf) {
                                                    phi_11192_ = -(_e2495);
                                                } else {
                                                    phi_11192_ = _e2495;
                                                }
                                                let _e2519 = phi_11192_;
                                                if (_e2479 < 0.0lf) {
                                                    phi_11201_ = -(_e2479);
                                                } else {
                                                    phi_11201_ = _e2479;
                                                }
                                                let _e2526 = phi_11201_;
                                                if (_e2500 < 0.0lf) {
                                                    phi_11207_ = -(_e2500);
                                                } else {
                                                    phi_11207_ = _e2500;
                                                }
                                                let _e2530 = phi_11207_;
                                                if (_e2484 < 0.0lf) {
                                                    phi_11216_ = -(_e2484);
                                                } else {
                                                    phi_11216_ = _e2484;
                                                }
                                                let _e2537 = phi_11216_;
                                                if (_e2505 < 0.0lf) {
                                                    phi_11222_ = -(_e2505);
                                                } else {
                                                    phi_11222_ = _e2505;
                                                }
                                                let _e2541 = phi_11222_;
                                                if (_e2489 < 0.0lf) {
                                                    phi_11231_ = -(_e2489);
                                                } else {
                                                    phi_11231_ = _e2489;
                                                }
                                                let _e2548 = phi_11231_;
                                                if (_e2510 < 0.0lf) {
                                                    phi_11237_ = -(_e2510);
                                                } else {
                                                    phi_11237_ = _e2510;
                                                }
                                                let _e2552 = phi_11237_;
                                                phi_11243_ = type_38(array<f64, 4>(_e2474, _e2479, _e2484, _e2489), array<f64, 4>(_e2495, _e2500, _e2505, _e2510), array<f64, 4>((_e2469 + ((_e2515 + _e2519) * _e2462)), (_e2469 + ((_e2526 + _e2530) * _e2462)), (_e2469 + ((_e2537 + _e2541) * _e2462)), (_e2469 + ((_e2548 + _e2552) * _e2462))));
                                                phi_11244_ = false;
                                            } else {
                                                phi_11243_ = type_38();
                                                phi_11244_ = true;
                                            }
                                            let _e2559 = phi_11243_;
                                            let _e2561 = phi_11244_;
                                            phi_11245_ = _e2559;
                                            phi_11246_ = _e2561;
                                        } else {
                                            phi_11245_ = type_38();
                                            phi_11246_ = true;
                                        }
                                        let _e2563 = phi_11245_;
                                        let _e2565 = phi_11246_;
                                        if _e2565 {
                                            let _e2566 = f64(0f);
                                            let _e2567 = f64(1f);
                                            phi_11256_ = type_38(array<f64, 4>(_e2566, _e2566, _e2566, _e2566), array<f64, 4>(_e2566, _e2566, _e2566, _e2566), array<f64, 4>(_e2567, _e2567, _e2567, _e2567));
                                        } else {
                                            phi_11256_ = _e2563;
                                        }
                                        let _e2573 = phi_11256_;
                                        local_11 = type_38(array<f64, 4>(_e2573.member[0], _e2573.member[1], _e2573.member[2], _e2573.member[3]), array<f64, 4>(_e2573.member_1[0], _e2573.member_1[1], _e2573.member_1[2], _e2573.member_1[3]), array<f64, 4>(_e2573.member_2[0], _e2573.member_2[1], _e2573.member_2[2], _e2573.member_2[3]));
                                        let _e2593 = f64(0f);
                                        let _e2596 = local_11.member[0u];
                                        let _e2599 = local_11.member_1[0u];
                                        let _e2602 = local_11.member[0u];
                                        let _e2608 = local_11.member_2[0u];
                                        if (((_e2596 + ((_e2599 - _e2602) * _e410)) - _e2608) > _e2593) {
                                            let _e2613 = local_11.member[1u];
                                            let _e2616 = local_11.member_1[1u];
                                            let _e2619 = local_11.member[1u];
                                            let _e2625 = local_11.member_2[1u];
                                            if (((_e2613 + ((_e2616 - _e2619) * _e410)) - _e2625) > _e2593) {
                                                let _e2630 = local_11.member[2u];
                                                let _e2633 = local_11.member_1[2u];
                                                let _e2636 = local_11.member[2u];
                                                let _e2642 = local_11.member_2[2u];
                                                if (((_e2630 + ((_e2633 - _e2636) * _e410)) - _e2642) > _e2593) {
                                                    let _e2647 = local_11.member[3u];
                                                    let _e2650 = local_11.member_1[3u];
                                                    let _e2653 = local_11.member[3u];
                                                    let _e2659 = local_11.member_2[3u];
                                                    phi_11426_ = (((_e2647 + ((_e2650 - _e2653) * _e410)) - _e2659) > _e2593);
                                                    phi_11427_ = false;
                                                } else {
                                                    phi_11426_ = bool();
                                                    phi_11427_ = true;
                                                }
                                                let _e2663 = phi_11426_;
                                                let _e2665 = phi_11427_;
                                                phi_11428_ = _e2663;
                                                phi_11429_ = _e2665;
                                            } else {
                                                phi_11428_ = bool();
                                                phi_11429_ = true;
                                            }
                                            let _e2667 = phi_11428_;
                                            let _e2669 = phi_11429_;
                                            phi_11430_ = _e2667;
                                            phi_11431_ = _e2669;
                                        } else {
                                            phi_11430_ = bool();
                                            phi_11431_ = true;
                                        }
                                        let _e2671 = phi_11430_;
                                        let _e2673 = phi_11431_;
                                        if _e2673 {
                                            phi_11435_ = false;
                                        } else {
                                            phi_11435_ = _e2671;
                                        }
                                        let _e2675 = phi_11435_;
                                        phi_11436_ = _e2675;
                                    }
                                    let _e2677 = phi_11436_;
                                    phi_11437_ = _e2677;
                                    phi_11438_ = _e2375;
                                }
                                let _e2679 = phi_11437_;
                                let _e2681 = phi_11438_;
                                phi_11439_ = _e2679;
                                phi_11440_ = _e2681;
                            }
                            let _e2683 = phi_11439_;
                            let _e2685 = phi_11440_;
                            if _e2685 {
                                phi_11444_ = true;
                            } else {
                                phi_11444_ = _e2683;
                            }
                            let _e2687 = phi_11444_;
                            if !(_e2687) {
                                phi_11450_ = type_46(2u, _e410);
                                phi_11451_ = false;
                            } else {
                                phi_11450_ = type_46();
                                phi_11451_ = true;
                            }
                            let _e2691 = phi_11450_;
                            let _e2693 = phi_11451_;
                            phi_11452_ = _e2691;
                            phi_11453_ = _e2693;
                        } else {
                            phi_11452_ = type_46();
                            phi_11453_ = true;
                        }
                        let _e2695 = phi_11452_;
                        let _e2697 = phi_11453_;
                        if _e2697 {
                            let _e2698 = f64(0f);
                            let _e2699 = f64(1f);
                            let _e2700 = f64(3f);
                            let _e2706 = ((_e784 - (_e2700 * _e761)) * _e1155);
                            let _e2707 = ((_e807 - _e784) * _e1155);
                            let _e2708 = (((_e2700 * _e818) - _e807) * _e1155);
                            local_6[0u] = _e2698;
                            local_6[1u] = _e2699;
                            local_6[2u] = _e2699;
                            local_6[3u] = _e2699;
                            let _e2715 = ((_e2707 * _e2707) - (_e2706 * _e2708));
                            if (_e2715 > _e2698) {
                                if (_e2715 <= 2.2250738585072014e-308lf) {
                                    if (_e2715 > 0.0lf) {
                                        phi_11492_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_11492_ = 0.0lf;
                                    }
                                    let _e2768 = phi_11492_;
                                    phi_11556_ = _e2768;
                                } else {
                                    phi_11499_ = type_16(0i, 5i);
                                    phi_11502_ = bitcast<f64>(((bitcast<u64>(_e2715) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e2723 = phi_11499_;
                                        let _e2725 = phi_11502_;
                                        local_23 = _e2725;
                                        if (_e2723.member < _e2723.member_1) {
                                            let _e2732 = (_e2723.member + 1i);
                                            if ((false == (_e2732 > _e2723.member)) != false) {
                                                phi_11523_ = true;
                                            } else {
                                                phi_11523_ = false;
                                            }
                                            let _e2737 = phi_11523_;
                                            if _e2737 {
                                                phi_11529_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_11529_ = type_17(1u, _e2732);
                                            }
                                            let _e2742 = phi_11529_;
                                            phi_11500_ = type_16(_e2742.member_1, _e2723.member_1);
                                            phi_11543_ = type_17(1u, _e2723.member);
                                        } else {
                                            phi_11500_ = _e2723;
                                            phi_11543_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e2748 = phi_11500_;
                                        let _e2750 = phi_11543_;
                                        let _e2753 = (bitcast<i32>(_e2750.member) != 0i);
                                        if _e2753 {
                                            phi_11503_ = (0.5lf * (_e2725 + (_e2715 / _e2725)));
                                        } else {
                                            phi_11503_ = f64();
                                        }
                                        let _e2758 = phi_11503_;
                                        continue;
                                        continuing {
                                            phi_11499_ = _e2748;
                                            phi_11502_ = _e2758;
                                            break if !(_e2753);
                                        }
                                    }
                                    let _e2763 = local_23;
                                    phi_11556_ = (_e2763 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e2770 = phi_11556_;
                                if (_e2707 < _e2698) {
                                    phi_11562_ = -(_e2770);
                                } else {
                                    phi_11562_ = _e2770;
                                }
                                let _e2774 = phi_11562_;
                                let _e2776 = -((_e2707 + _e2774));
                                local_7[0u] = (_e2776 / (_e2776 + _e2708));
                                local_7[1u] = (_e2706 / (_e2706 + _e2776));
                                let _e2785 = local_7[1u];
                                let _e2786 = local_7[0u];
                                if (_e2785 < _e2786) {
                                    let _e2789 = local_7[1u];
                                    let _e2791 = local_7[0u];
                                    local_7[0u] = _e2789;
                                    local_7[1u] = _e2791;
                                }
                                phi_11587_ = type_12(0u, 2u);
                                phi_11590_ = 1u;
                                loop {
                                    let _e2795 = phi_11587_;
                                    let _e2797 = phi_11590_;
                                    local_64 = _e2797;
                                    if (_e2795.member < _e2795.member_1) {
                                        phi_11588_ = type_12((_e2795.member + 1u), _e2795.member_1);
                                        phi_11613_ = type_12(1u, _e2795.member);
                                    } else {
                                        phi_11588_ = _e2795;
                                        phi_11613_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e2809 = phi_11588_;
                                    let _e2811 = phi_11613_;
                                    let _e2815 = (bitcast<i32>(_e2811.member) != 0i);
                                    if _e2815 {
                                        let _e2817 = local_7[_e2811.member_1];
                                        if (_e2817 > _e2698) {
                                            let _e2820 = local_7[_e2811.member_1];
                                            if (_e2820 < _e2699) {
                                                let _e2823 = local_7[_e2811.member_1];
                                                local_6[_e2797] = _e2823;
                                                phi_11657_ = (_e2797 + 1u);
                                            } else {
                                                phi_11657_ = _e2797;
                                            }
                                            let _e2827 = phi_11657_;
                                            phi_11658_ = _e2827;
                                        } else {
                                            phi_11658_ = _e2797;
                                        }
                                        let _e2829 = phi_11658_;
                                        phi_11591_ = _e2829;
                                    } else {
                                        phi_11591_ = u32();
                                    }
                                    let _e2831 = phi_11591_;
                                    continue;
                                    continuing {
                                        phi_11587_ = _e2809;
                                        phi_11590_ = _e2831;
                                        break if !(_e2815);
                                    }
                                }
                                let _e10870 = local_64;
                                phi_11659_ = _e10870;
                            } else {
                                phi_11659_ = 1u;
                            }
                            let _e2834 = phi_11659_;
                            local_6[_e2834] = _e2699;
                            let _e2836 = local_6;
                            local_12 = _e2836;
                            phi_11679_ = type_12(0u, _e2834);
                            loop {
                                let _e2839 = phi_11679_;
                                if (_e2839.member < _e2839.member_1) {
                                    phi_11680_ = type_12((_e2839.member + 1u), _e2839.member_1);
                                    phi_11703_ = type_12(1u, _e2839.member);
                                } else {
                                    phi_11680_ = _e2839;
                                    phi_11703_ = type_12(0u, type_12().member_1);
                                }
                                let _e2851 = phi_11680_;
                                let _e2853 = phi_11703_;
                                if (bitcast<i32>(_e2853.member) != 0i) {
                                    let _e2859 = local_12[_e2853.member_1];
                                    if (_e2859 > _e410) {
                                        phi_11722_ = _e2859;
                                    } else {
                                        phi_11722_ = _e410;
                                    }
                                    let _e2862 = phi_11722_;
                                    let _e2865 = local_12[(_e2853.member_1 + 1u)];
                                    if (_e2865 < _e419) {
                                        phi_11735_ = _e2865;
                                    } else {
                                        phi_11735_ = _e419;
                                    }
                                    let _e2868 = phi_11735_;
                                    if (_e2862 <= _e2868) {
                                        let _e2871 = (f64(1f) - _e2862);
                                        let _e2882 = ((((_e761 * _e2871) + (_e784 * _e2862)) * (_e2871 * _e2871)) + (((_e807 * _e2871) + (_e818 * _e2862)) * (_e2862 * _e2862)));
                                        let _e2884 = (f64(1f) - _e2868);
                                        let _e2895 = ((((_e761 * _e2884) + (_e784 * _e2868)) * (_e2884 * _e2884)) + (((_e807 * _e2884) + (_e818 * _e2868)) * (_e2868 * _e2868)));
                                        if (_e2882 < 0.0lf) {
                                            phi_11771_ = -(_e2882);
                                        } else {
                                            phi_11771_ = _e2882;
                                        }
                                        let _e2899 = phi_11771_;
                                        let _e2900 = (_e2899 > _e1151);
                                        if (_e2895 < 0.0lf) {
                                            phi_11778_ = -(_e2895);
                                        } else {
                                            phi_11778_ = _e2895;
                                        }
                                        let _e2904 = phi_11778_;
                                        let _e2905 = (_e2904 > _e1151);
                                        let _e2906 = f64(0f);
                                        if _e2900 {
                                            if _e2905 {
                                                phi_11790_ = ((_e2882 > _e2906) != (_e2895 > _e2906));
                                                phi_11791_ = false;
                                            } else {
                                                phi_11790_ = bool();
                                                phi_11791_ = true;
                                            }
                                            let _e2911 = phi_11790_;
                                            let _e2913 = phi_11791_;
                                            phi_11792_ = _e2911;
                                            phi_11793_ = _e2913;
                                        } else {
                                            phi_11792_ = bool();
                                            phi_11793_ = true;
                                        }
                                        let _e2915 = phi_11792_;
                                        let _e2917 = phi_11793_;
                                        if _e2917 {
                                            phi_11797_ = false;
                                        } else {
                                            phi_11797_ = _e2915;
                                        }
                                        let _e2919 = phi_11797_;
                                        if _e2900 {
                                            if _e2905 {
                                                if _e2919 {
                                                    phi_11809_ = type_49();
                                                } else {
                                                    phi_11809_ = type_49(f64(1f), _e2906, _e2919);
                                                }
                                                let _e2923 = phi_11809_;
                                                phi_11810_ = _e2923;
                                                phi_11811_ = _e2919;
                                            } else {
                                                phi_11810_ = type_49();
                                                phi_11811_ = true;
                                            }
                                            let _e2925 = phi_11810_;
                                            let _e2927 = phi_11811_;
                                            phi_11812_ = _e2925;
                                            phi_11813_ = _e2927;
                                        } else {
                                            phi_11812_ = type_49();
                                            phi_11813_ = true;
                                        }
                                        let _e2929 = phi_11812_;
                                        let _e2931 = phi_11813_;
                                        if _e2931 {
                                            if _e2900 {
                                                if (_e2882 < _e2906) {
                                                    phi_11826_ = f64(-1f);
                                                } else {
                                                    phi_11826_ = f64(1f);
                                                }
                                                let _e2936 = phi_11826_;
                                                let _e2937 = f64(0.5f);
                                                let _e2938 = f64(3f);
                                                let _e2941 = (_e807 - _e784);
                                                phi_11838_ = type_12(0u, 64u);
                                                phi_11841_ = _e2868;
                                                phi_11843_ = _e2862;
                                                phi_11845_ = (_e2937 * (_e2862 + _e2868));
                                                loop {
                                                    let _e2947 = phi_11838_;
                                                    let _e2949 = phi_11841_;
                                                    let _e2951 = phi_11843_;
                                                    let _e2953 = phi_11845_;
                                                    local_66 = _e2951;
                                                    if (_e2947.member < _e2947.member_1) {
                                                        phi_11839_ = type_12((_e2947.member + 1u), _e2947.member_1);
                                                        phi_11868_ = type_12(1u, _e2947.member);
                                                    } else {
                                                        phi_11839_ = _e2947;
                                                        phi_11868_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2965 = phi_11839_;
                                                    let _e2967 = phi_11868_;
                                                    if (bitcast<i32>(_e2967.member) != 0i) {
                                                        let _e2972 = (f64(1f) - _e2953);
                                                        let _e2985 = ((_e2936 * ((((_e761 * _e2972) + (_e784 * _e2953)) * (_e2972 * _e2972)) + (((_e807 * _e2972) + (_e818 * _e2953)) * (_e2953 * _e2953)))) - _e1151);
                                                        if (_e2985 > f64(0f)) {
                                                            phi_11895_ = _e2949;
                                                            phi_11896_ = _e2953;
                                                        } else {
                                                            phi_11895_ = _e2953;
                                                            phi_11896_ = _e2951;
                                                        }
                                                        let _e2989 = phi_11895_;
                                                        let _e2991 = phi_11896_;
                                                        let _e2993 = ((_e2989 - _e2991) > _e1161);
                                                        if _e2993 {
                                                            let _e2995 = (f64(1f) - _e2953);
                                                            let _e3007 = (-(_e2985) / (_e2936 * (((((_e784 - (_e2938 * _e761)) * _e2995) + (_e2941 * _e2953)) * _e2995) + (((_e2941 * _e2995) + (((_e2938 * _e818) - _e807) * _e2953)) * _e2953))));
                                                            if (_e2985 > f64(0f)) {
                                                                phi_11924_ = (_e2937 * _e1161);
                                                            } else {
                                                                phi_11924_ = -((_e2937 * _e1161));
                                                            }
                                                            let _e3014 = phi_11924_;
                                                            let _e3016 = ((_e2953 + _e3007) + _e3014);
                                                            if (_e3016 > _e2991) {
                                                                if (_e3016 < _e2989) {
                                                                    if (_e3007 < 0.0lf) {
                                                                        phi_11940_ = -(_e3007);
                                                                    } else {
                                                                        phi_11940_ = _e3007;
                                                                    }
                                                                    let _e3022 = phi_11940_;
                                                                    if (_e3022 < (_e2937 * (_e2989 - _e2991))) {
                                                                        phi_11947_ = false;
                                                                    } else {
                                                                        phi_11947_ = true;
                                                                    }
                                                                    let _e3027 = phi_11947_;
                                                                    phi_11948_ = _e3027;
                                                                } else {
                                                                    phi_11948_ = true;
                                                                }
                                                                let _e3029 = phi_11948_;
                                                                phi_11949_ = _e3029;
                                                            } else {
                                                                phi_11949_ = true;
                                                            }
                                                            let _e3031 = phi_11949_;
                                                            if _e3031 {
                                                                phi_11955_ = (_e2937 * (_e2991 + _e2989));
                                                            } else {
                                                                phi_11955_ = _e3016;
                                                            }
                                                            let _e3035 = phi_11955_;
                                                            phi_11956_ = _e3035;
                                                            phi_11957_ = false;
                                                        } else {
                                                            phi_11956_ = f64();
                                                            phi_11957_ = true;
                                                        }
                                                        let _e3037 = phi_11956_;
                                                        let _e3039 = phi_11957_;
                                                        phi_11842_ = _e2989;
                                                        phi_11844_ = _e2991;
                                                        phi_11846_ = _e3037;
                                                        phi_11958_ = _e2991;
                                                        phi_11959_ = _e2993;
                                                        phi_11960_ = _e3039;
                                                    } else {
                                                        phi_11842_ = f64();
                                                        phi_11844_ = f64();
                                                        phi_11846_ = f64();
                                                        phi_11958_ = f64();
                                                        phi_11959_ = false;
                                                        phi_11960_ = false;
                                                    }
                                                    let _e3041 = phi_11842_;
                                                    let _e3043 = phi_11844_;
                                                    let _e3045 = phi_11846_;
                                                    let _e3047 = phi_11958_;
                                                    let _e3049 = phi_11959_;
                                                    let _e3051 = phi_11960_;
                                                    local_24 = _e3051;
                                                    local_65 = _e3047;
                                                    continue;
                                                    continuing {
                                                        phi_11838_ = _e2965;
                                                        phi_11841_ = _e3041;
                                                        phi_11843_ = _e3043;
                                                        phi_11845_ = _e3045;
                                                        break if !(_e3049);
                                                    }
                                                }
                                                let _e3054 = local_24;
                                                if _e3054 {
                                                    let _e10914 = local_65;
                                                    phi_11964_ = _e10914;
                                                } else {
                                                    let _e10916 = local_66;
                                                    phi_11964_ = _e10916;
                                                }
                                                let _e3056 = phi_11964_;
                                                phi_11965_ = _e3056;
                                            } else {
                                                phi_11965_ = _e2862;
                                            }
                                            let _e3058 = phi_11965_;
                                            if _e2905 {
                                                if (_e2895 < _e2906) {
                                                    phi_11975_ = f64(-1f);
                                                } else {
                                                    phi_11975_ = f64(1f);
                                                }
                                                let _e3063 = phi_11975_;
                                                phi_11979_ = type_12(0u, 64u);
                                                phi_11982_ = (_e1161 + _e1161);
                                                loop {
                                                    let _e3066 = phi_11979_;
                                                    let _e3068 = phi_11982_;
                                                    if (_e3066.member < _e3066.member_1) {
                                                        phi_11980_ = type_12((_e3066.member + 1u), _e3066.member_1);
                                                        phi_12005_ = type_12(1u, _e3066.member);
                                                    } else {
                                                        phi_11980_ = _e3066;
                                                        phi_12005_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e3080 = phi_11980_;
                                                    let _e3082 = phi_12005_;
                                                    if (bitcast<i32>(_e3082.member) != 0i) {
                                                        let _e3086 = (_e3058 + _e3068);
                                                        if (_e3086 < _e2868) {
                                                            let _e3089 = (f64(1f) - _e3086);
                                                            let _e3102 = ((_e3063 * ((((_e761 * _e3089) + (_e784 * _e3086)) * (_e3089 * _e3089)) + (((_e807 * _e3089) + (_e818 * _e3086)) * (_e3086 * _e3086)))) > _e1151);
                                                            if _e3102 {
                                                                phi_12036_ = f64();
                                                                phi_12037_ = false;
                                                            } else {
                                                                phi_12036_ = (_e3068 + _e3068);
                                                                phi_12037_ = true;
                                                            }
                                                            let _e3105 = phi_12036_;
                                                            let _e3107 = phi_12037_;
                                                            phi_12038_ = _e3105;
                                                            phi_12039_ = _e3107;
                                                            phi_12040_ = _e3102;
                                                            phi_12041_ = false;
                                                        } else {
                                                            phi_12038_ = f64();
                                                            phi_12039_ = false;
                                                            phi_12040_ = false;
                                                            phi_12041_ = true;
                                                        }
                                                        let _e3109 = phi_12038_;
                                                        let _e3111 = phi_12039_;
                                                        let _e3113 = phi_12040_;
                                                        let _e3115 = phi_12041_;
                                                        phi_12042_ = _e3086;
                                                        phi_11983_ = _e3109;
                                                        phi_12043_ = _e3111;
                                                        phi_12044_ = _e3113;
                                                        phi_12045_ = _e3115;
                                                        phi_12046_ = false;
                                                    } else {
                                                        phi_12042_ = f64();
                                                        phi_11983_ = f64();
                                                        phi_12043_ = false;
                                                        phi_12044_ = false;
                                                        phi_12045_ = false;
                                                        phi_12046_ = true;
                                                    }
                                                    let _e3117 = phi_12042_;
                                                    let _e3119 = phi_11983_;
                                                    let _e3121 = phi_12043_;
                                                    let _e3123 = phi_12044_;
                                                    let _e3125 = phi_12045_;
                                                    let _e3127 = phi_12046_;
                                                    local_25 = _e3123;
                                                    local_67 = _e3125;
                                                    local_68 = _e3127;
                                                    local_69 = _e3117;
                                                    continue;
                                                    continuing {
                                                        phi_11979_ = _e3080;
                                                        phi_11982_ = _e3119;
                                                        break if !(_e3121);
                                                    }
                                                }
                                                let _e3130 = local_25;
                                                if _e3130 {
                                                    phi_12050_ = false;
                                                    phi_12051_ = false;
                                                } else {
                                                    let _e10938 = local_67;
                                                    phi_12050_ = _e10938;
                                                    let _e10941 = local_68;
                                                    phi_12051_ = _e10941;
                                                }
                                                let _e3132 = phi_12050_;
                                                let _e3134 = phi_12051_;
                                                if _e3132 {
                                                    phi_12055_ = true;
                                                } else {
                                                    phi_12055_ = _e3134;
                                                }
                                                let _e3136 = phi_12055_;
                                                if _e3136 {
                                                    phi_12059_ = _e2868;
                                                } else {
                                                    let _e10945 = local_69;
                                                    phi_12059_ = _e10945;
                                                }
                                                let _e3138 = phi_12059_;
                                                phi_12060_ = _e3138;
                                            } else {
                                                phi_12060_ = _e2868;
                                            }
                                            let _e3140 = phi_12060_;
                                            phi_12062_ = type_49(_e3058, _e3140, _e2919);
                                        } else {
                                            phi_12062_ = _e2929;
                                        }
                                        let _e3143 = phi_12062_;
                                        if (_e3143.member > _e3143.member_1) {
                                            phi_15929_ = bool();
                                            phi_15930_ = f64();
                                            phi_15931_ = f64();
                                            phi_15932_ = true;
                                            phi_15933_ = false;
                                            phi_15934_ = false;
                                            phi_15935_ = false;
                                        } else {
                                            let _e3151 = ((_e3143.member_1 - _e3143.member) * f64(0.5f));
                                            let _e3152 = (_e3143.member + _e3151);
                                            let _e3155 = (_e3151 + (1.1102230246251565e-16lf * f64(4f)));
                                            let _e3157 = local_18.member_3;
                                            let _e3160 = local_18.member[0u];
                                            if (_e3160[0] < 0.0lf) {
                                                phi_12093_ = -(_e3160[0]);
                                            } else {
                                                phi_12093_ = _e3160[0];
                                            }
                                            let _e3167 = phi_12093_;
                                            if (_e3160[1] < 0.0lf) {
                                                phi_12100_ = -(_e3160[1]);
                                            } else {
                                                phi_12100_ = _e3160[1];
                                            }
                                            let _e3171 = phi_12100_;
                                            if (_e3167 > _e3171) {
                                                phi_12105_ = _e3167;
                                            } else {
                                                phi_12105_ = _e3171;
                                            }
                                            let _e3174 = phi_12105_;
                                            if (_e3160[2] < 0.0lf) {
                                                phi_12112_ = -(_e3160[2]);
                                            } else {
                                                phi_12112_ = _e3160[2];
                                            }
                                            let _e3178 = phi_12112_;
                                            if (_e3174 > _e3178) {
                                                phi_12117_ = _e3174;
                                            } else {
                                                phi_12117_ = _e3178;
                                            }
                                            let _e3181 = phi_12117_;
                                            let _e3183 = local_18.member[1u];
                                            if (_e3183[0] < 0.0lf) {
                                                phi_12130_ = -(_e3183[0]);
                                            } else {
                                                phi_12130_ = _e3183[0];
                                            }
                                            let _e3190 = phi_12130_;
                                            if (_e3183[1] < 0.0lf) {
                                                phi_12137_ = -(_e3183[1]);
                                            } else {
                                                phi_12137_ = _e3183[1];
                                            }
                                            let _e3194 = phi_12137_;
                                            if (_e3190 > _e3194) {
                                                phi_12142_ = _e3190;
                                            } else {
                                                phi_12142_ = _e3194;
                                            }
                                            let _e3197 = phi_12142_;
                                            if (_e3183[2] < 0.0lf) {
                                                phi_12149_ = -(_e3183[2]);
                                            } else {
                                                phi_12149_ = _e3183[2];
                                            }
                                            let _e3201 = phi_12149_;
                                            if (_e3197 > _e3201) {
                                                phi_12154_ = _e3197;
                                            } else {
                                                phi_12154_ = _e3201;
                                            }
                                            let _e3204 = phi_12154_;
                                            if (_e3181 > _e3204) {
                                                phi_12159_ = _e3181;
                                            } else {
                                                phi_12159_ = _e3204;
                                            }
                                            let _e3207 = phi_12159_;
                                            let _e3210 = local_18.member[0u];
                                            let _e3215 = local_18.member[1u];
                                            let _e3225 = (_e3210[0] + ((_e3215[0] - _e3210[0]) * _e3152));
                                            let _e3226 = (_e3210[1] + ((_e3215[1] - _e3210[1]) * _e3152));
                                            let _e3227 = (_e3210[2] + ((_e3215[2] - _e3210[2]) * _e3152));
                                            let _e3229 = local_18.member[1u];
                                            let _e3234 = local_18.member[0u];
                                            let _e3238 = (_e3229[0] - _e3234[0]);
                                            let _e3239 = (_e3229[1] - _e3234[1]);
                                            let _e3240 = (_e3229[2] - _e3234[2]);
                                            if (_e3238 < 0.0lf) {
                                                phi_12218_ = -(_e3238);
                                            } else {
                                                phi_12218_ = _e3238;
                                            }
                                            let _e3244 = phi_12218_;
                                            if (_e3239 < 0.0lf) {
                                                phi_12224_ = -(_e3239);
                                            } else {
                                                phi_12224_ = _e3239;
                                            }
                                            let _e3248 = phi_12224_;
                                            if (_e3244 > _e3248) {
                                                phi_12229_ = _e3244;
                                            } else {
                                                phi_12229_ = _e3248;
                                            }
                                            let _e3251 = phi_12229_;
                                            if (_e3240 < 0.0lf) {
                                                phi_12235_ = -(_e3240);
                                            } else {
                                                phi_12235_ = _e3240;
                                            }
                                            let _e3255 = phi_12235_;
                                            if (_e3251 > _e3255) {
                                                phi_12240_ = _e3251;
                                            } else {
                                                phi_12240_ = _e3255;
                                            }
                                            let _e3258 = phi_12240_;
                                            let _e3266 = ((((_e3155 * _e3258) * f64(1.01f)) + ((_e3207 + _e3157) * (1.1102230246251565e-16lf * f64(8f)))) + _e3157);
                                            if (_e3225 < 0.0lf) {
                                                phi_12254_ = -(_e3225);
                                            } else {
                                                phi_12254_ = _e3225;
                                            }
                                            let _e3270 = phi_12254_;
                                            if (_e3226 < 0.0lf) {
                                                phi_12260_ = -(_e3226);
                                            } else {
                                                phi_12260_ = _e3226;
                                            }
                                            let _e3274 = phi_12260_;
                                            if (_e3270 > _e3274) {
                                                phi_12265_ = _e3270;
                                            } else {
                                                phi_12265_ = _e3274;
                                            }
                                            let _e3277 = phi_12265_;
                                            if (_e3227 < 0.0lf) {
                                                phi_12271_ = -(_e3227);
                                            } else {
                                                phi_12271_ = _e3227;
                                            }
                                            let _e3281 = phi_12271_;
                                            if (_e3277 > _e3281) {
                                                phi_12276_ = _e3277;
                                            } else {
                                                phi_12276_ = _e3281;
                                            }
                                            let _e3284 = phi_12276_;
                                            local_2 = type_39(array<f64, 3>(_e3225, _e3226, _e3227), _e3266, (_e3284 + _e3266));
                                            let _e3290 = local_18.member_3;
                                            let _e3292 = local_18.member_1[0u];
                                            if (_e3292[0] < 0.0lf) {
                                                phi_12302_ = -(_e3292[0]);
                                            } else {
                                                phi_12302_ = _e3292[0];
                                            }
                                            let _e3299 = phi_12302_;
                                            if (_e3292[1] < 0.0lf) {
                                                phi_12309_ = -(_e3292[1]);
                                            } else {
                                                phi_12309_ = _e3292[1];
                                            }
                                            let _e3303 = phi_12309_;
                                            if (_e3299 > _e3303) {
                                                phi_12314_ = _e3299;
                                            } else {
                                                phi_12314_ = _e3303;
                                            }
                                            let _e3306 = phi_12314_;
                                            if (_e3292[2] < 0.0lf) {
                                                phi_12321_ = -(_e3292[2]);
                                            } else {
                                                phi_12321_ = _e3292[2];
                                            }
                                            let _e3310 = phi_12321_;
                                            if (_e3306 > _e3310) {
                                                phi_12326_ = _e3306;
                                            } else {
                                                phi_12326_ = _e3310;
                                            }
                                            let _e3313 = phi_12326_;
                                            let _e3315 = local_18.member_1[1u];
                                            if (_e3315[0] < 0.0lf) {
                                                phi_12339_ = -(_e3315[0]);
                                            } else {
                                                phi_12339_ = _e3315[0];
                                            }
                                            let _e3322 = phi_12339_;
                                            if (_e3315[1] < 0.0lf) {
                                                phi_12346_ = -(_e3315[1]);
                                            } else {
                                                phi_12346_ = _e3315[1];
                                            }
                                            let _e3326 = phi_12346_;
                                            if (_e3322 > _e3326) {
                                                phi_12351_ = _e3322;
                                            } else {
                                                phi_12351_ = _e3326;
                                            }
                                            let _e3329 = phi_12351_;
                                            if (_e3315[2] < 0.0lf) {
                                                phi_12358_ = -(_e3315[2]);
                                            } else {
                                                phi_12358_ = _e3315[2];
                                            }
                                            let _e3333 = phi_12358_;
                                            if (_e3329 > _e3333) {
                                                phi_12363_ = _e3329;
                                            } else {
                                                phi_12363_ = _e3333;
                                            }
                                            let _e3336 = phi_12363_;
                                            if (_e3313 > _e3336) {
                                                phi_12368_ = _e3313;
                                            } else {
                                                phi_12368_ = _e3336;
                                            }
                                            let _e3339 = phi_12368_;
                                            let _e3342 = local_18.member_1[0u];
                                            let _e3347 = local_18.member_1[1u];
                                            let _e3357 = (_e3342[0] + ((_e3347[0] - _e3342[0]) * _e3152));
                                            let _e3358 = (_e3342[1] + ((_e3347[1] - _e3342[1]) * _e3152));
                                            let _e3359 = (_e3342[2] + ((_e3347[2] - _e3342[2]) * _e3152));
                                            let _e3361 = local_18.member_1[1u];
                                            let _e3366 = local_18.member_1[0u];
                                            let _e3370 = (_e3361[0] - _e3366[0]);
                                            let _e3371 = (_e3361[1] - _e3366[1]);
                                            let _e3372 = (_e3361[2] - _e3366[2]);
                                            if (_e3370 < 0.0lf) {
                                                phi_12427_ = -(_e3370);
                                            } else {
                                                phi_12427_ = _e3370;
                                            }
                                            let _e3376 = phi_12427_;
                                            if (_e3371 < 0.0lf) {
                                                phi_12433_ = -(_e3371);
                                            } else {
                                                phi_12433_ = _e3371;
                                            }
                                            let _e3380 = phi_12433_;
                                            if (_e3376 > _e3380) {
                                                phi_12438_ = _e3376;
                                            } else {
                                                phi_12438_ = _e3380;
                                            }
                                            let _e3383 = phi_12438_;
                                            if (_e3372 < 0.0lf) {
                                                phi_12444_ = -(_e3372);
                                            } else {
                                                phi_12444_ = _e3372;
                                            }
                                            let _e3387 = phi_12444_;
                                            if (_e3383 > _e3387) {
                                                phi_12449_ = _e3383;
                                            } else {
                                                phi_12449_ = _e3387;
                                            }
                                            let _e3390 = phi_12449_;
                                            let _e3398 = ((((_e3155 * _e3390) * f64(1.01f)) + ((_e3339 + _e3290) * (1.1102230246251565e-16lf * f64(8f)))) + _e3290);
                                            if (_e3357 < 0.0lf) {
                                                phi_12463_ = -(_e3357);
                                            } else {
                                                phi_12463_ = _e3357;
                                            }
                                            let _e3402 = phi_12463_;
                                            if (_e3358 < 0.0lf) {
                                                phi_12469_ = -(_e3358);
                                            } else {
                                                phi_12469_ = _e3358;
                                            }
                                            let _e3406 = phi_12469_;
                                            if (_e3402 > _e3406) {
                                                phi_12474_ = _e3402;
                                            } else {
                                                phi_12474_ = _e3406;
                                            }
                                            let _e3409 = phi_12474_;
                                            if (_e3359 < 0.0lf) {
                                                phi_12480_ = -(_e3359);
                                            } else {
                                                phi_12480_ = _e3359;
                                            }
                                            let _e3413 = phi_12480_;
                                            if (_e3409 > _e3413) {
                                                phi_12485_ = _e3409;
                                            } else {
                                                phi_12485_ = _e3413;
                                            }
                                            let _e3416 = phi_12485_;
                                            local_3 = type_39(array<f64, 3>(_e3357, _e3358, _e3359), _e3398, (_e3416 + _e3398));
                                            let _e3422 = local_18.member_3;
                                            let _e3424 = local_18.member_2[0u];
                                            if (_e3424[0] < 0.0lf) {
                                                phi_12511_ = -(_e3424[0]);
                                            } else {
                                                phi_12511_ = _e3424[0];
                                            }
                                            let _e3431 = phi_12511_;
                                            if (_e3424[1] < 0.0lf) {
                                                phi_12518_ = -(_e3424[1]);
                                            } else {
                                                phi_12518_ = _e3424[1];
                                            }
                                            let _e3435 = phi_12518_;
                                            if (_e3431 > _e3435) {
                                                phi_12523_ = _e3431;
                                            } else {
                                                phi_12523_ = _e3435;
                                            }
                                            let _e3438 = phi_12523_;
                                            if (_e3424[2] < 0.0lf) {
                                                phi_12530_ = -(_e3424[2]);
                                            } else {
                                                phi_12530_ = _e3424[2];
                                            }
                                            let _e3442 = phi_12530_;
                                            if (_e3438 > _e3442) {
                                                phi_12535_ = _e3438;
                                            } else {
                                                phi_12535_ = _e3442;
                                            }
                                            let _e3445 = phi_12535_;
                                            let _e3447 = local_18.member_2[1u];
                                            if (_e3447[0] < 0.0lf) {
                                                phi_12548_ = -(_e3447[0]);
                                            } else {
                                                phi_12548_ = _e3447[0];
                                            }
                                            let _e3454 = phi_12548_;
                                            if (_e3447[1] < 0.0lf) {
                                                phi_12555_ = -(_e3447[1]);
                                            } else {
                                                phi_12555_ = _e3447[1];
                                            }
                                            let _e3458 = phi_12555_;
                                            if (_e3454 > _e3458) {
                                                phi_12560_ = _e3454;
                                            } else {
                                                phi_12560_ = _e3458;
                                            }
                                            let _e3461 = phi_12560_;
                                            if (_e3447[2] < 0.0lf) {
                                                phi_12567_ = -(_e3447[2]);
                                            } else {
                                                phi_12567_ = _e3447[2];
                                            }
                                            let _e3465 = phi_12567_;
                                            if (_e3461 > _e3465) {
                                                phi_12572_ = _e3461;
                                            } else {
                                                phi_12572_ = _e3465;
                                            }
                                            let _e3468 = phi_12572_;
                                            if (_e3445 > _e3468) {
                                                phi_12577_ = _e3445;
                                            } else {
                                                phi_12577_ = _e3468;
                                            }
                                            let _e3471 = phi_12577_;
                                            let _e3474 = local_18.member_2[0u];
                                            let _e3479 = local_18.member_2[1u];
                                            let _e3489 = (_e3474[0] + ((_e3479[0] - _e3474[0]) * _e3152));
                                            let _e3490 = (_e3474[1] + ((_e3479[1] - _e3474[1]) * _e3152));
                                            let _e3491 = (_e3474[2] + ((_e3479[2] - _e3474[2]) * _e3152));
                                            let _e3493 = local_18.member_2[1u];
                                            let _e3498 = local_18.member_2[0u];
                                            let _e3502 = (_e3493[0] - _e3498[0]);
                                            let _e3503 = (_e3493[1] - _e3498[1]);
                                            let _e3504 = (_e3493[2] - _e3498[2]);
                                            if (_e3502 < 0.0lf) {
                                                phi_12636_ = -(_e3502);
                                            } else {
                                                phi_12636_ = _e3502;
                                            }
                                            let _e3508 = phi_12636_;
                                            if (_e3503 < 0.0lf) {
                                                phi_12642_ = -(_e3503);
                                            } else {
                                                phi_12642_ = _e3503;
                                            }
                                            let _e3512 = phi_12642_;
                                            if (_e3508 > _e3512) {
                                                phi_12647_ = _e3508;
                                            } else {
                                                phi_12647_ = _e3512;
                                            }
                                            let _e3515 = phi_12647_;
                                            if (_e3504 < 0.0lf) {
                                                phi_12653_ = -(_e3504);
                                            } else {
                                                phi_12653_ = _e3504;
                                            }
                                            let _e3519 = phi_12653_;
                                            if (_e3515 > _e3519) {
                                                phi_12658_ = _e3515;
                                            } else {
                                                phi_12658_ = _e3519;
                                            }
                                            let _e3522 = phi_12658_;
                                            let _e3530 = ((((_e3155 * _e3522) * f64(1.01f)) + ((_e3471 + _e3422) * (1.1102230246251565e-16lf * f64(8f)))) + _e3422);
                                            if (_e3489 < 0.0lf) {
                                                phi_12672_ = -(_e3489);
                                            } else {
                                                phi_12672_ = _e3489;
                                            }
                                            let _e3534 = phi_12672_;
                                            if (_e3490 < 0.0lf) {
                                                phi_12678_ = -(_e3490);
                                            } else {
                                                phi_12678_ = _e3490;
                                            }
                                            let _e3538 = phi_12678_;
                                            if (_e3534 > _e3538) {
                                                phi_12683_ = _e3534;
                                            } else {
                                                phi_12683_ = _e3538;
                                            }
                                            let _e3541 = phi_12683_;
                                            if (_e3491 < 0.0lf) {
                                                phi_12689_ = -(_e3491);
                                            } else {
                                                phi_12689_ = _e3491;
                                            }
                                            let _e3545 = phi_12689_;
                                            if (_e3541 > _e3545) {
                                                phi_12694_ = _e3541;
                                            } else {
                                                phi_12694_ = _e3545;
                                            }
                                            let _e3548 = phi_12694_;
                                            local_4 = type_39(array<f64, 3>(_e3489, _e3490, _e3491), _e3530, (_e3548 + _e3530));
                                            let _e3553 = local_3.member;
                                            let _e3558 = local_4.member;
                                            let _e3564 = ((_e3553[1] * _e3558[2]) - (_e3553[2] * _e3558[1]));
                                            let _e3567 = ((_e3553[2] * _e3558[0]) - (_e3553[0] * _e3558[2]));
                                            let _e3570 = ((_e3553[0] * _e3558[1]) - (_e3553[1] * _e3558[0]));
                                            if (_e3564 < 0.0lf) {
                                                phi_12743_ = -(_e3564);
                                            } else {
                                                phi_12743_ = _e3564;
                                            }
                                            let _e3574 = phi_12743_;
                                            if (_e3567 < 0.0lf) {
                                                phi_12749_ = -(_e3567);
                                            } else {
                                                phi_12749_ = _e3567;
                                            }
                                            let _e3578 = phi_12749_;
                                            if (_e3574 > _e3578) {
                                                if (_e3564 < 0.0lf) {
                                                    phi_12759_ = -(_e3564);
                                                } else {
                                                    phi_12759_ = _e3564;
                                                }
                                                let _e3596 = phi_12759_;
                                                if (_e3570 < 0.0lf) {
                                                    phi_12765_ = -(_e3570);
                                                } else {
                                                    phi_12765_ = _e3570;
                                                }
                                                let _e3600 = phi_12765_;
                                                if (_e3596 > _e3600) {
                                                    phi_12770_ = 2u;
                                                    phi_12771_ = 1u;
                                                } else {
                                                    phi_12770_ = 1u;
                                                    phi_12771_ = 0u;
                                                }
                                                let _e3603 = phi_12770_;
                                                let _e3605 = phi_12771_;
                                                phi_12790_ = _e3603;
                                                phi_12791_ = _e3605;
                                            } else {
                                                if (_e3567 < 0.0lf) {
                                                    phi_12777_ = -(_e3567);
                                                } else {
                                                    phi_12777_ = _e3567;
                                                }
                                                let _e3583 = phi_12777_;
                                                if (_e3570 < 0.0lf) {
                                                    phi_12783_ = -(_e3570);
                                                } else {
                                                    phi_12783_ = _e3570;
                                                }
                                                let _e3587 = phi_12783_;
                                                if (_e3583 > _e3587) {
                                                    phi_12788_ = 0u;
                                                    phi_12789_ = 2u;
                                                } else {
                                                    phi_12788_ = 1u;
                                                    phi_12789_ = 0u;
                                                }
                                                let _e3590 = phi_12788_;
                                                let _e3592 = phi_12789_;
                                                phi_12790_ = _e3590;
                                                phi_12791_ = _e3592;
                                            }
                                            let _e3607 = phi_12790_;
                                            let _e3609 = phi_12791_;
                                            let _e3612 = local_3.member[_e3609];
                                            let _e3615 = local_4.member[_e3607];
                                            let _e3619 = local_3.member[_e3607];
                                            let _e3622 = local_4.member[_e3609];
                                            let _e3624 = ((_e3612 * _e3615) - (_e3619 * _e3622));
                                            let _e3625 = f64(1f);
                                            let _e3626 = f64(2f);
                                            let _e3628 = local_3.member_1;
                                            let _e3630 = local_4.member_2;
                                            let _e3633 = local_3.member_2;
                                            let _e3635 = local_4.member_1;
                                            let _e3641 = local_3.member_2;
                                            let _e3644 = local_4.member_2;
                                            let _e3653 = local_3.member_2;
                                            let _e3656 = local_4.member_2;
                                            let _e3660 = (((((_e3628 * _e3630) + (_e3633 * _e3635)) * f64(2.01f)) + (((_e3641 * _e3626) * (_e3644 * _e3626)) * (1.1102230246251565e-16lf * _e3626))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3625 + _e3653) * (_e3625 + _e3656))));
                                            if (_e3624 < 0.0lf) {
                                                phi_12864_ = -(_e3624);
                                            } else {
                                                phi_12864_ = _e3624;
                                            }
                                            let _e3664 = phi_12864_;
                                            if (_e3664 > _e3660) {
                                                if (_e3624 < f64(0f)) {
                                                    phi_12876_ = f64(-1f);
                                                } else {
                                                    phi_12876_ = f64(1f);
                                                }
                                                let _e3671 = phi_12876_;
                                                let _e3674 = local_2.member[_e3609];
                                                let _e3677 = local_4.member[_e3607];
                                                let _e3681 = local_2.member[_e3607];
                                                let _e3684 = local_4.member[_e3609];
                                                let _e3687 = f64(1f);
                                                let _e3688 = f64(2f);
                                                let _e3690 = local_2.member_1;
                                                let _e3692 = local_4.member_2;
                                                let _e3695 = local_2.member_2;
                                                let _e3697 = local_4.member_1;
                                                let _e3703 = local_2.member_2;
                                                let _e3706 = local_4.member_2;
                                                let _e3715 = local_2.member_2;
                                                let _e3718 = local_4.member_2;
                                                let _e3722 = (((((_e3690 * _e3692) + (_e3695 * _e3697)) * f64(2.01f)) + (((_e3703 * _e3688) * (_e3706 * _e3688)) * (1.1102230246251565e-16lf * _e3688))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3687 + _e3715) * (_e3687 + _e3718))));
                                                let _e3725 = local_3.member[_e3609];
                                                let _e3728 = local_2.member[_e3607];
                                                let _e3732 = local_3.member[_e3607];
                                                let _e3735 = local_2.member[_e3609];
                                                let _e3738 = f64(1f);
                                                let _e3739 = f64(2f);
                                                let _e3741 = local_3.member_1;
                                                let _e3743 = local_2.member_2;
                                                let _e3746 = local_3.member_2;
                                                let _e3748 = local_2.member_1;
                                                let _e3754 = local_3.member_2;
                                                let _e3757 = local_2.member_2;
                                                let _e3766 = local_3.member_2;
                                                let _e3769 = local_2.member_2;
                                                let _e3773 = (((((_e3741 * _e3743) + (_e3746 * _e3748)) * f64(2.01f)) + (((_e3754 * _e3739) * (_e3757 * _e3739)) * (1.1102230246251565e-16lf * _e3739))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3738 + _e3766) * (_e3738 + _e3769))));
                                                let _e3774 = (_e3624 * _e3671);
                                                let _e3775 = (((_e3674 * _e3677) - (_e3681 * _e3684)) * _e3671);
                                                let _e3776 = (((_e3725 * _e3728) - (_e3732 * _e3735)) * _e3671);
                                                if (_e3774 < 0.0lf) {
                                                    phi_13019_ = -(_e3774);
                                                } else {
                                                    phi_13019_ = _e3774;
                                                }
                                                let _e3780 = phi_13019_;
                                                if (_e3775 < 0.0lf) {
                                                    phi_13025_ = -(_e3775);
                                                } else {
                                                    phi_13025_ = _e3775;
                                                }
                                                let _e3784 = phi_13025_;
                                                if (_e3776 < 0.0lf) {
                                                    phi_13032_ = -(_e3776);
                                                } else {
                                                    phi_13032_ = _e3776;
                                                }
                                                let _e3789 = phi_13032_;
                                                let _e3795 = ((_e3774 - _e3775) - _e3776);
                                                let _e3798 = (((_e3660 + _e3722) + _e3773) + (((_e3780 + _e3784) + _e3789) * (1.1102230246251565e-16lf * f64(4f))));
                                                local_5 = array<type_40, 4>(type_40(_e3775, _e3722), type_40(_e3776, _e3773), type_40(_e3795, _e3798), type_40(_e3795, _e3798));
                                                phi_13088_ = type_12(0u, 4u);
                                                phi_13091_ = true;
                                                loop {
                                                    let _e3805 = phi_13088_;
                                                    let _e3807 = phi_13091_;
                                                    local_27 = _e3807;
                                                    if (_e3805.member < _e3805.member_1) {
                                                        phi_13089_ = type_12((_e3805.member + 1u), _e3805.member_1);
                                                        phi_13114_ = type_12(1u, _e3805.member);
                                                    } else {
                                                        phi_13089_ = _e3805;
                                                        phi_13114_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e3819 = phi_13089_;
                                                    let _e3821 = phi_13114_;
                                                    if (bitcast<i32>(_e3821.member) != 0i) {
                                                        let _e3828 = local_5[_e3821.member_1].member;
                                                        let _e3831 = local_5[_e3821.member_1].member_1;
                                                        let _e3833 = (_e3828 < -(_e3831));
                                                        if _e3833 {
                                                            phi_13141_ = bool();
                                                            phi_13142_ = false;
                                                        } else {
                                                            phi_13141_ = (_e3807 && (_e3828 > _e3831));
                                                            phi_13142_ = true;
                                                        }
                                                        let _e3837 = phi_13141_;
                                                        let _e3839 = phi_13142_;
                                                        phi_13092_ = _e3837;
                                                        phi_13143_ = _e3839;
                                                        phi_13144_ = _e3833;
                                                    } else {
                                                        phi_13092_ = bool();
                                                        phi_13143_ = false;
                                                        phi_13144_ = false;
                                                    }
                                                    let _e3841 = phi_13092_;
                                                    let _e3843 = phi_13143_;
                                                    let _e3845 = phi_13144_;
                                                    local_26 = _e3845;
                                                    continue;
                                                    continuing {
                                                        phi_13088_ = _e3819;
                                                        phi_13091_ = _e3841;
                                                        break if !(_e3843);
                                                    }
                                                }
                                                let _e3848 = local_26;
                                                if _e3848 {
                                                    phi_13148_ = false;
                                                } else {
                                                    phi_13148_ = true;
                                                }
                                                let _e3850 = phi_13148_;
                                                if _e3850 {
                                                    let _e3852 = local_27;
                                                    if _e3852 {
                                                        phi_13155_ = 1u;
                                                    } else {
                                                        phi_13155_ = 2u;
                                                    }
                                                    let _e3854 = phi_13155_;
                                                    phi_13156_ = _e3854;
                                                    phi_13157_ = false;
                                                } else {
                                                    phi_13156_ = u32();
                                                    phi_13157_ = true;
                                                }
                                                let _e3856 = phi_13156_;
                                                let _e3858 = phi_13157_;
                                                phi_13158_ = _e3856;
                                                phi_13159_ = 0u;
                                                phi_13160_ = _e3858;
                                            } else {
                                                phi_13158_ = u32();
                                                phi_13159_ = 2u;
                                                phi_13160_ = true;
                                            }
                                            let _e3860 = phi_13158_;
                                            let _e3862 = phi_13159_;
                                            let _e3864 = phi_13160_;
                                            if _e3864 {
                                                phi_13164_ = _e3862;
                                            } else {
                                                phi_13164_ = _e3860;
                                            }
                                            let _e3866 = phi_13164_;
                                            let _e3867 = (_e3866 == 0u);
                                            if _e3867 {
                                                phi_15923_ = bool();
                                                phi_15924_ = f64();
                                                phi_15925_ = f64();
                                                phi_15926_ = false;
                                                phi_15927_ = false;
                                                phi_15928_ = false;
                                            } else {
                                                if (_e3866 == 1u) {
                                                    phi_13174_ = _e3143.member_2;
                                                } else {
                                                    phi_13174_ = false;
                                                }
                                                let _e3871 = phi_13174_;
                                                let _e3873 = (_e401 * f64(0.99f));
                                                if _e3871 {
                                                    if ((_e3143.member_1 - _e3143.member) <= _e3873) {
                                                        phi_13187_ = false;
                                                    } else {
                                                        phi_13187_ = true;
                                                    }
                                                    let _e3879 = phi_13187_;
                                                    phi_13188_ = _e3879;
                                                } else {
                                                    phi_13188_ = true;
                                                }
                                                let _e3881 = phi_13188_;
                                                if _e3881 {
                                                    let _e3886 = local_18.member[0u];
                                                    let _e3892 = local_18.member_1[0u];
                                                    let _e3898 = local_18.member_2[0u];
                                                    let _e3910 = local_18.member[1u];
                                                    let _e3916 = local_18.member_1[1u];
                                                    let _e3922 = local_18.member_2[1u];
                                                    let _e3934 = local_18.member[0u];
                                                    if (_e3934[0] < 0.0lf) {
                                                        phi_13336_ = -(_e3934[0]);
                                                    } else {
                                                        phi_13336_ = _e3934[0];
                                                    }
                                                    let _e3941 = phi_13336_;
                                                    if (_e3934[1] < 0.0lf) {
                                                        phi_13343_ = -(_e3934[1]);
                                                    } else {
                                                        phi_13343_ = _e3934[1];
                                                    }
                                                    let _e3945 = phi_13343_;
                                                    if (_e3941 > _e3945) {
                                                        phi_13348_ = _e3941;
                                                    } else {
                                                        phi_13348_ = _e3945;
                                                    }
                                                    let _e3948 = phi_13348_;
                                                    if (_e3934[2] < 0.0lf) {
                                                        phi_13355_ = -(_e3934[2]);
                                                    } else {
                                                        phi_13355_ = _e3934[2];
                                                    }
                                                    let _e3952 = phi_13355_;
                                                    if (_e3948 > _e3952) {
                                                        phi_13360_ = _e3948;
                                                    } else {
                                                        phi_13360_ = _e3952;
                                                    }
                                                    let _e3955 = phi_13360_;
                                                    let _e3958 = local_18.member[1u];
                                                    if (_e3958[0] < 0.0lf) {
                                                        phi_13373_ = -(_e3958[0]);
                                                    } else {
                                                        phi_13373_ = _e3958[0];
                                                    }
                                                    let _e3965 = phi_13373_;
                                                    if (_e3958[1] < 0.0lf) {
                                                        phi_13380_ = -(_e3958[1]);
                                                    } else {
                                                        phi_13380_ = _e3958[1];
                                                    }
                                                    let _e3969 = phi_13380_;
                                                    if (_e3965 > _e3969) {
                                                        phi_13385_ = _e3965;
                                                    } else {
                                                        phi_13385_ = _e3969;
                                                    }
                                                    let _e3972 = phi_13385_;
                                                    if (_e3958[2] < 0.0lf) {
                                                        phi_13392_ = -(_e3958[2]);
                                                    } else {
                                                        phi_13392_ = _e3958[2];
                                                    }
                                                    let _e3976 = phi_13392_;
                                                    if (_e3972 > _e3976) {
                                                        phi_13397_ = _e3972;
                                                    } else {
                                                        phi_13397_ = _e3976;
                                                    }
                                                    let _e3979 = phi_13397_;
                                                    if (_e3955 > _e3979) {
                                                        phi_13402_ = _e3955;
                                                    } else {
                                                        phi_13402_ = _e3979;
                                                    }
                                                    let _e3982 = phi_13402_;
                                                    let _e3984 = local_18.member_3;
                                                    let _e3988 = local_18.member_1[0u];
                                                    if (_e3988[0] < 0.0lf) {
                                                        phi_13419_ = -(_e3988[0]);
                                                    } else {
                                                        phi_13419_ = _e3988[0];
                                                    }
                                                    let _e3995 = phi_13419_;
                                                    if (_e3988[1] < 0.0lf) {
                                                        phi_13426_ = -(_e3988[1]);
                                                    } else {
                                                        phi_13426_ = _e3988[1];
                                                    }
                                                    let _e3999 = phi_13426_;
                                                    if (_e3995 > _e3999) {
                                                        phi_13431_ = _e3995;
                                                    } else {
                                                        phi_13431_ = _e3999;
                                                    }
                                                    let _e4002 = phi_13431_;
                                                    if (_e3988[2] < 0.0lf) {
                                                        phi_13438_ = -(_e3988[2]);
                                                    } else {
                                                        phi_13438_ = _e3988[2];
                                                    }
                                                    let _e4006 = phi_13438_;
                                                    if (_e4002 > _e4006) {
                                                        phi_13443_ = _e4002;
                                                    } else {
                                                        phi_13443_ = _e4006;
                                                    }
                                                    let _e4009 = phi_13443_;
                                                    let _e4012 = local_18.member_1[1u];
                                                    if (_e4012[0] < 0.0lf) {
                                                        phi_13457_ = -(_e4012[0]);
                                                    } else {
                                                        phi_13457_ = _e4012[0];
                                                    }
                                                    let _e4019 = phi_13457_;
                                                    if (_e4012[1] < 0.0lf) {
                                                        phi_13464_ = -(_e4012[1]);
                                                    } else {
                                                        phi_13464_ = _e4012[1];
                                                    }
                                                    let _e4023 = phi_13464_;
                                                    if (_e4019 > _e4023) {
                                                        phi_13469_ = _e4019;
                                                    } else {
                                                        phi_13469_ = _e4023;
                                                    }
                                                    let _e4026 = phi_13469_;
                                                    if (_e4012[2] < 0.0lf) {
                                                        phi_13476_ = -(_e4012[2]);
                                                    } else {
                                                        phi_13476_ = _e4012[2];
                                                    }
                                                    let _e4030 = phi_13476_;
                                                    if (_e4026 > _e4030) {
                                                        phi_13481_ = _e4026;
                                                    } else {
                                                        phi_13481_ = _e4030;
                                                    }
                                                    let _e4033 = phi_13481_;
                                                    if (_e4009 > _e4033) {
                                                        phi_13486_ = _e4009;
                                                    } else {
                                                        phi_13486_ = _e4033;
                                                    }
                                                    let _e4036 = phi_13486_;
                                                    let _e4038 = local_18.member_3;
                                                    let _e4042 = local_18.member_2[0u];
                                                    if (_e4042[0] < 0.0lf) {
                                                        phi_13503_ = -(_e4042[0]);
                                                    } else {
                                                        phi_13503_ = _e4042[0];
                                                    }
                                                    let _e4049 = phi_13503_;
                                                    if (_e4042[1] < 0.0lf) {
                                                        phi_13510_ = -(_e4042[1]);
                                                    } else {
                                                        phi_13510_ = _e4042[1];
                                                    }
                                                    let _e4053 = phi_13510_;
                                                    if (_e4049 > _e4053) {
                                                        phi_13515_ = _e4049;
                                                    } else {
                                                        phi_13515_ = _e4053;
                                                    }
                                                    let _e4056 = phi_13515_;
                                                    if (_e4042[2] < 0.0lf) {
                                                        phi_13522_ = -(_e4042[2]);
                                                    } else {
                                                        phi_13522_ = _e4042[2];
                                                    }
                                                    let _e4060 = phi_13522_;
                                                    if (_e4056 > _e4060) {
                                                        phi_13527_ = _e4056;
                                                    } else {
                                                        phi_13527_ = _e4060;
                                                    }
                                                    let _e4063 = phi_13527_;
                                                    let _e4066 = local_18.member_2[1u];
                                                    if (_e4066[0] < 0.0lf) {
                                                        phi_13541_ = -(_e4066[0]);
                                                    } else {
                                                        phi_13541_ = _e4066[0];
                                                    }
                                                    let _e4073 = phi_13541_;
                                                    if (_e4066[1] < 0.0lf) {
                                                        phi_13548_ = -(_e4066[1]);
                                                    } else {
                                                        phi_13548_ = _e4066[1];
                                                    }
                                                    let _e4077 = phi_13548_;
                                                    if (_e4073 > _e4077) {
                                                        phi_13553_ = _e4073;
                                                    } else {
                                                        phi_13553_ = _e4077;
                                                    }
                                                    let _e4080 = phi_13553_;
                                                    if (_e4066[2] < 0.0lf) {
                                                        phi_13560_ = -(_e4066[2]);
                                                    } else {
                                                        phi_13560_ = _e4066[2];
                                                    }
                                                    let _e4084 = phi_13560_;
                                                    if (_e4080 > _e4084) {
                                                        phi_13565_ = _e4080;
                                                    } else {
                                                        phi_13565_ = _e4084;
                                                    }
                                                    let _e4087 = phi_13565_;
                                                    if (_e4063 > _e4087) {
                                                        phi_13570_ = _e4063;
                                                    } else {
                                                        phi_13570_ = _e4087;
                                                    }
                                                    let _e4090 = phi_13570_;
                                                    let _e4092 = local_18.member_3;
                                                    let _e4100 = local_18.member_3;
                                                    let _e4108 = (_e401 * f64(0.00390625f));
                                                    let _e4109 = f64(0f);
                                                    let _e4110 = f64(1f);
                                                    local = type_38(array<f64, 4>(_e4109, _e4109, _e4109, _e4109), array<f64, 4>(_e4109, _e4109, _e4109, _e4109), array<f64, 4>(_e4110, _e4110, _e4110, _e4110));
                                                    phi_13617_ = type_12(0u, 96u);
                                                    phi_13620_ = _e3143.member;
                                                    phi_13622_ = _e3143.member;
                                                    phi_13624_ = (_e3143.member_1 - _e3143.member);
                                                    phi_13626_ = _e3143.member;
                                                    phi_13628_ = false;
                                                    phi_13630_ = 0u;
                                                    loop {
                                                        let _e4117 = phi_13617_;
                                                        let _e4119 = phi_13620_;
                                                        let _e4121 = phi_13622_;
                                                        let _e4123 = phi_13624_;
                                                        let _e4125 = phi_13626_;
                                                        let _e4127 = phi_13628_;
                                                        let _e4129 = phi_13630_;
                                                        local_31 = _e4119;
                                                        local_78 = _e4121;
                                                        if (_e4117.member < _e4117.member_1) {
                                                            phi_13618_ = type_12((_e4117.member + 1u), _e4117.member_1);
                                                            phi_13653_ = type_12(1u, _e4117.member);
                                                        } else {
                                                            phi_13618_ = _e4117;
                                                            phi_13653_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e4141 = phi_13618_;
                                                        let _e4143 = phi_13653_;
                                                        if (bitcast<i32>(_e4143.member) != 0i) {
                                                            let _e4149 = local_18.member[0u];
                                                            let _e4155 = local_18.member[1u];
                                                            let _e4171 = local_18.member_1[0u];
                                                            let _e4177 = local_18.member_1[1u];
                                                            let _e4193 = local_18.member_2[0u];
                                                            let _e4199 = local_18.member_2[1u];
                                                            let _e4213 = function_3(array<f64, 3>((_e4149[0] + ((_e4155[0] - _e4149[0]) * _e4119)), (_e4149[1] + ((_e4155[1] - _e4149[1]) * _e4119)), (_e4149[2] + ((_e4155[2] - _e4149[2]) * _e4119))), array<f64, 3>((_e4171[0] + ((_e4177[0] - _e4171[0]) * _e4119)), (_e4171[1] + ((_e4177[1] - _e4171[1]) * _e4119)), (_e4171[2] + ((_e4177[2] - _e4171[2]) * _e4119))), array<f64, 3>((_e4193[0] + ((_e4199[0] - _e4193[0]) * _e4119)), (_e4193[1] + ((_e4199[1] - _e4193[1]) * _e4119)), (_e4193[2] + ((_e4199[2] - _e4193[2]) * _e4119))), 0u);
                                                            if (_e4129 == 0u) {
                                                                phi_13782_ = _e4213;
                                                            } else {
                                                                let _e4215 = f64(0f);
                                                                if (_e4129 == 1u) {
                                                                    phi_13768_ = _e4213[0];
                                                                } else {
                                                                    phi_13768_ = _e4215;
                                                                }
                                                                let _e4219 = phi_13768_;
                                                                if (_e4129 == 2u) {
                                                                    phi_13774_ = _e4213[1];
                                                                } else {
                                                                    phi_13774_ = _e4215;
                                                                }
                                                                let _e4223 = phi_13774_;
                                                                if (_e4129 == 3u) {
                                                                    phi_13780_ = _e4213[2];
                                                                } else {
                                                                    phi_13780_ = _e4215;
                                                                }
                                                                let _e4227 = phi_13780_;
                                                                phi_13782_ = array<f64, 3>(_e4219, _e4223, _e4227);
                                                            }
                                                            let _e4230 = phi_13782_;
                                                            if (_e4230[0] < 0.0lf) {
                                                                phi_13789_ = -(_e4230[0]);
                                                            } else {
                                                                phi_13789_ = _e4230[0];
                                                            }
                                                            let _e4235 = phi_13789_;
                                                            if (_e4230[1] < 0.0lf) {
                                                                phi_13796_ = -(_e4230[1]);
                                                            } else {
                                                                phi_13796_ = _e4230[1];
                                                            }
                                                            let _e4240 = phi_13796_;
                                                            if (_e4230[2] < 0.0lf) {
                                                                phi_13804_ = -(_e4230[2]);
                                                            } else {
                                                                phi_13804_ = _e4230[2];
                                                            }
                                                            let _e4246 = phi_13804_;
                                                            let _e4247 = ((_e4235 + _e4240) + _e4246);
                                                            if (_e4247 > f64(0f)) {
                                                                if ((bitcast<u64>(_e4247) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                                    let _e4254 = (f64(1f) / _e4247);
                                                                    let _e4256 = (_e4230[0] * _e4254);
                                                                    let _e4258 = (_e4230[1] * _e4254);
                                                                    let _e4260 = (_e4230[2] * _e4254);
                                                                    let _e4265 = (((_e4256 * _e4256) + (_e4258 * _e4258)) + (_e4260 * _e4260));
                                                                    if (_e4265 <= 2.2250738585072014e-308lf) {
                                                                        if (_e4265 > 0.0lf) {
                                                                            phi_13843_ = (1.464336215552873e-154lf * 2.0lf);
                                                                        } else {
                                                                            phi_13843_ = 0.0lf;
                                                                        }
                                                                        let _e4317 = phi_13843_;
                                                                        phi_13907_ = _e4317;
                                                                    } else {
                                                                        phi_13850_ = type_16(0i, 5i);
                                                                        phi_13853_ = bitcast<f64>(((bitcast<u64>(_e4265) / 2lu) + 2303426169912950784lu));
                                                                        loop {
                                                                            let _e4272 = phi_13850_;
                                                                            let _e4274 = phi_13853_;
                                                                            local_28 = _e4274;
                                                                            if (_e4272.member < _e4272.member_1) {
                                                                                let _e4281 = (_e4272.member + 1i);
                                                                                if ((false == (_e4281 > _e4272.member)) != false) {
                                                                                    phi_13874_ = true;
                                                                                } else {
                                                                                    phi_13874_ = false;
                                                                                }
                                                                                let _e4286 = phi_13874_;
                                                                                if _e4286 {
                                                                                    phi_13880_ = type_17(0u, type_17().member_1);
                                                                                } else {
                                                                                    phi_13880_ = type_17(1u, _e4281);
                                                                                }
                                                                                let _e4291 = phi_13880_;
                                                                                phi_13851_ = type_16(_e4291.member_1, _e4272.member_1);
                                                                                phi_13894_ = type_17(1u, _e4272.member);
                                                                            } else {
                                                                                phi_13851_ = _e4272;
                                                                                phi_13894_ = type_17(0u, type_17().member_1);
                                                                            }
                                                                            let _e4297 = phi_13851_;
                                                                            let _e4299 = phi_13894_;
                                                                            let _e4302 = (bitcast<i32>(_e4299.member) != 0i);
                                                                            if _e4302 {
                                                                                phi_13854_ = (0.5lf * (_e4274 + (_e4265 / _e4274)));
                                                                            } else {
                                                                                phi_13854_ = f64();
                                                                            }
                                                                            let _e4307 = phi_13854_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_13850_ = _e4297;
                                                                                phi_13853_ = _e4307;
                                                                                break if !(_e4302);
                                                                            }
                                                                        }
                                                                        let _e4312 = local_28;
                                                                        phi_13907_ = (_e4312 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                    }
                                                                    let _e4319 = phi_13907_;
                                                                    let _e4321 = (1.1102230246251565e-16lf * f64(12f));
                                                                    let _e4328 = ((((((((_e3982 + _e3984) + (_e4036 + _e4038)) + (_e4090 + _e4092)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4100 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e663 * _e4319) * (f64(1f) + _e4321)));
                                                                    let _e4333 = (((_e4256 * _e3886[0]) + (_e4258 * _e3886[1])) + (_e4260 * _e3886[2]));
                                                                    let _e4338 = (((_e4256 * (_e3886[0] - _e3892[0])) + (_e4258 * (_e3886[1] - _e3892[1]))) + (_e4260 * (_e3886[2] - _e3892[2])));
                                                                    let _e4343 = (((_e4256 * (_e3886[0] - _e3898[0])) + (_e4258 * (_e3886[1] - _e3898[1]))) + (_e4260 * (_e3886[2] - _e3898[2])));
                                                                    let _e4348 = (((_e4256 * _e3886[0]) + (_e4258 * _e3886[1])) + (_e4260 * _e3886[2]));
                                                                    let _e4354 = (((_e4256 * _e3910[0]) + (_e4258 * _e3910[1])) + (_e4260 * _e3910[2]));
                                                                    let _e4359 = (((_e4256 * (_e3910[0] - _e3916[0])) + (_e4258 * (_e3910[1] - _e3916[1]))) + (_e4260 * (_e3910[2] - _e3916[2])));
                                                                    let _e4364 = (((_e4256 * (_e3910[0] - _e3922[0])) + (_e4258 * (_e3910[1] - _e3922[1]))) + (_e4260 * (_e3910[2] - _e3922[2])));
                                                                    let _e4369 = (((_e4256 * _e3910[0]) + (_e4258 * _e3910[1])) + (_e4260 * _e3910[2]));
                                                                    if (_e4333 < 0.0lf) {
                                                                        phi_13976_ = -(_e4333);
                                                                    } else {
                                                                        phi_13976_ = _e4333;
                                                                    }
                                                                    let _e4374 = phi_13976_;
                                                                    if (_e4354 < 0.0lf) {
                                                                        phi_13982_ = -(_e4354);
                                                                    } else {
                                                                        phi_13982_ = _e4354;
                                                                    }
                                                                    let _e4378 = phi_13982_;
                                                                    if (_e4338 < 0.0lf) {
                                                                        phi_13991_ = -(_e4338);
                                                                    } else {
                                                                        phi_13991_ = _e4338;
                                                                    }
                                                                    let _e4385 = phi_13991_;
                                                                    if (_e4359 < 0.0lf) {
                                                                        phi_13997_ = -(_e4359);
                                                                    } else {
                                                                        phi_13997_ = _e4359;
                                                                    }
                                                                    let _e4389 = phi_13997_;
                                                                    if (_e4343 < 0.0lf) {
                                                                        phi_14006_ = -(_e4343);
                                                                    } else {
                                                                        phi_14006_ = _e4343;
                                                                    }
                                                                    let _e4396 = phi_14006_;
                                                                    if (_e4364 < 0.0lf) {
                                                                        phi_14012_ = -(_e4364);
                                                                    } else {
                                                                        phi_14012_ = _e4364;
                                                                    }
                                                                    let _e4400 = phi_14012_;
                                                                    if (_e4348 < 0.0lf) {
                                                                        phi_14021_ = -(_e4348);
                                                                    } else {
                                                                        phi_14021_ = _e4348;
                                                                    }
                                                                    let _e4407 = phi_14021_;
                                                                    if (_e4369 < 0.0lf) {
                                                                        phi_14027_ = -(_e4369);
                                                                    } else {
                                                                        phi_14027_ = _e4369;
                                                                    }
                                                                    let _e4411 = phi_14027_;
                                                                    phi_14033_ = type_38(array<f64, 4>(_e4333, _e4338, _e4343, _e4348), array<f64, 4>(_e4354, _e4359, _e4364, _e4369), array<f64, 4>((_e4328 + ((_e4374 + _e4378) * _e4321)), (_e4328 + ((_e4385 + _e4389) * _e4321)), (_e4328 + ((_e4396 + _e4400) * _e4321)), (_e4328 + ((_e4407 + _e4411) * _e4321))));
                                                                    phi_14034_ = false;
                                                                } else {
                                                                    phi_14033_ = type_38();
                                                                    phi_14034_ = true;
                                                                }
                                                                let _e4418 = phi_14033_;
                                                                let _e4420 = phi_14034_;
                                                                phi_14035_ = _e4418;
                                                                phi_14036_ = _e4420;
                                                            } else {
                                                                phi_14035_ = type_38();
                                                                phi_14036_ = true;
                                                            }
                                                            let _e4422 = phi_14035_;
                                                            let _e4424 = phi_14036_;
                                                            if _e4424 {
                                                                let _e4425 = f64(0f);
                                                                let _e4426 = f64(1f);
                                                                phi_14046_ = type_38(array<f64, 4>(_e4425, _e4425, _e4425, _e4425), array<f64, 4>(_e4425, _e4425, _e4425, _e4425), array<f64, 4>(_e4426, _e4426, _e4426, _e4426));
                                                            } else {
                                                                phi_14046_ = _e4422;
                                                            }
                                                            let _e4432 = phi_14046_;
                                                            local_1 = type_38(array<f64, 4>(_e4432.member[0], _e4432.member[1], _e4432.member[2], _e4432.member[3]), array<f64, 4>(_e4432.member_1[0], _e4432.member_1[1], _e4432.member_1[2], _e4432.member_1[3]), array<f64, 4>(_e4432.member_2[0], _e4432.member_2[1], _e4432.member_2[2], _e4432.member_2[3]));
                                                            let _e4452 = (_e4119 - _e4125);
                                                            let _e4454 = f64(0f);
                                                            let _e4457 = local_1.member[0u];
                                                            let _e4460 = local_1.member_1[0u];
                                                            let _e4463 = local_1.member[0u];
                                                            let _e4469 = local_1.member_2[0u];
                                                            if (((_e4457 + ((_e4460 - _e4463) * _e4119)) - _e4469) > _e4454) {
                                                                let _e4474 = local_1.member[1u];
                                                                let _e4477 = local_1.member_1[1u];
                                                                let _e4480 = local_1.member[1u];
                                                                let _e4486 = local_1.member_2[1u];
                                                                if (((_e4474 + ((_e4477 - _e4480) * _e4119)) - _e4486) > _e4454) {
                                                                    let _e4491 = local_1.member[2u];
                                                                    let _e4494 = local_1.member_1[2u];
                                                                    let _e4497 = local_1.member[2u];
                                                                    let _e4503 = local_1.member_2[2u];
                                                                    if (((_e4491 + ((_e4494 - _e4497) * _e4119)) - _e4503) > _e4454) {
                                                                        let _e4508 = local_1.member[3u];
                                                                        let _e4511 = local_1.member_1[3u];
                                                                        let _e4514 = local_1.member[3u];
                                                                        let _e4520 = local_1.member_2[3u];
                                                                        phi_14218_ = (((_e4508 + ((_e4511 - _e4514) * _e4119)) - _e4520) > _e4454);
                                                                        phi_14219_ = false;
                                                                    } else {
                                                                        phi_14218_ = bool();
                                                                        phi_14219_ = true;
                                                                    }
                                                                    let _e4524 = phi_14218_;
                                                                    let _e4526 = phi_14219_;
                                                                    phi_14220_ = _e4524;
                                                                    phi_14221_ = _e4526;
                                                                } else {
                                                                    phi_14220_ = bool();
                                                                    phi_14221_ = true;
                                                                }
                                                                let _e4528 = phi_14220_;
                                                                let _e4530 = phi_14221_;
                                                                phi_14222_ = _e4528;
                                                                phi_14223_ = _e4530;
                                                            } else {
                                                                phi_14222_ = bool();
                                                                phi_14223_ = true;
                                                            }
                                                            let _e4532 = phi_14222_;
                                                            let _e4534 = phi_14223_;
                                                            if _e4534 {
                                                                phi_14227_ = false;
                                                            } else {
                                                                phi_14227_ = _e4532;
                                                            }
                                                            let _e4536 = phi_14227_;
                                                            if _e4536 {
                                                                if (_e4119 <= _e4121) {
                                                                    phi_14538_ = true;
                                                                } else {
                                                                    let _e4538 = f64(0f);
                                                                    let _e4541 = local.member[0u];
                                                                    let _e4544 = local.member_1[0u];
                                                                    let _e4547 = local.member[0u];
                                                                    let _e4553 = local.member_2[0u];
                                                                    let _e4557 = local_1.member[0u];
                                                                    let _e4560 = local_1.member_1[0u];
                                                                    let _e4563 = local_1.member[0u];
                                                                    let _e4569 = local_1.member_2[0u];
                                                                    if ((((_e4541 + ((_e4544 - _e4547) * _e4119)) - _e4553) + ((_e4557 + ((_e4560 - _e4563) * _e4125)) - _e4569)) > _e4538) {
                                                                        let _e4575 = local.member[1u];
                                                                        let _e4578 = local.member_1[1u];
                                                                        let _e4581 = local.member[1u];
                                                                        let _e4587 = local.member_2[1u];
                                                                        let _e4591 = local_1.member[1u];
                                                                        let _e4594 = local_1.member_1[1u];
                                                                        let _e4597 = local_1.member[1u];
                                                                        let _e4603 = local_1.member_2[1u];
                                                                        if ((((_e4575 + ((_e4578 - _e4581) * _e4119)) - _e4587) + ((_e4591 + ((_e4594 - _e4597) * _e4125)) - _e4603)) > _e4538) {
                                                                            let _e4609 = local.member[2u];
                                                                            let _e4612 = local.member_1[2u];
                                                                            let _e4615 = local.member[2u];
                                                                            let _e4621 = local.member_2[2u];
                                                                            let _e4625 = local_1.member[2u];
                                                                            let _e4628 = local_1.member_1[2u];
                                                                            let _e4631 = local_1.member[2u];
                                                                            let _e4637 = local_1.member_2[2u];
                                                                            if ((((_e4609 + ((_e4612 - _e4615) * _e4119)) - _e4621) + ((_e4625 + ((_e4628 - _e4631) * _e4125)) - _e4637)) > _e4538) {
                                                                                let _e4643 = local.member[3u];
                                                                                let _e4646 = local.member_1[3u];
                                                                                let _e4649 = local.member[3u];
                                                                                let _e4655 = local.member_2[3u];
                                                                                let _e4659 = local_1.member[3u];
                                                                                let _e4662 = local_1.member_1[3u];
                                                                                let _e4665 = local_1.member[3u];
                                                                                let _e4671 = local_1.member_2[3u];
                                                                                phi_14525_ = ((((_e4643 + ((_e4646 - _e4649) * _e4119)) - _e4655) + ((_e4659 + ((_e4662 - _e4665) * _e4125)) - _e4671)) > _e4538);
                                                                                phi_14526_ = false;
                                                                            } else {
                                                                                phi_14525_ = bool();
                                                                                phi_14526_ = true;
                                                                            }
                                                                            let _e4676 = phi_14525_;
                                                                            let _e4678 = phi_14526_;
                                                                            phi_14527_ = _e4676;
                                                                            phi_14528_ = _e4678;
                                                                        } else {
                                                                            phi_14527_ = bool();
                                                                            phi_14528_ = true;
                                                                        }
                                                                        let _e4680 = phi_14527_;
                                                                        let _e4682 = phi_14528_;
                                                                        phi_14529_ = _e4680;
                                                                        phi_14530_ = _e4682;
                                                                    } else {
                                                                        phi_14529_ = bool();
                                                                        phi_14530_ = true;
                                                                    }
                                                                    let _e4684 = phi_14529_;
                                                                    let _e4686 = phi_14530_;
                                                                    if _e4686 {
                                                                        phi_14534_ = false;
                                                                    } else {
                                                                        phi_14534_ = _e4684;
                                                                    }
                                                                    let _e4688 = phi_14534_;
                                                                    phi_14538_ = _e4688;
                                                                }
                                                                let _e4690 = phi_14538_;
                                                                if _e4690 {
                                                                    if _e4127 {
                                                                        if (_e4119 >= _e3143.member_1) {
                                                                            phi_14549_ = false;
                                                                        } else {
                                                                            phi_14549_ = true;
                                                                        }
                                                                        let _e4693 = phi_14549_;
                                                                        phi_14550_ = _e4693;
                                                                    } else {
                                                                        phi_14550_ = true;
                                                                    }
                                                                    let _e4695 = phi_14550_;
                                                                    if _e4695 {
                                                                        local = type_38(array<f64, 4>(_e4432.member[0], _e4432.member[1], _e4432.member[2], _e4432.member[3]), array<f64, 4>(_e4432.member_1[0], _e4432.member_1[1], _e4432.member_1[2], _e4432.member_1[3]), array<f64, 4>(_e4432.member_2[0], _e4432.member_2[1], _e4432.member_2[2], _e4432.member_2[3]));
                                                                        let _e4717 = local.member[0u];
                                                                        let _e4720 = local.member_1[0u];
                                                                        let _e4723 = local.member_2[0u];
                                                                        if (_e4717 > _e4723) {
                                                                            if (_e4720 > _e4723) {
                                                                                phi_14624_ = false;
                                                                            } else {
                                                                                phi_14624_ = true;
                                                                            }
                                                                            let _e4727 = phi_14624_;
                                                                            phi_14625_ = _e4727;
                                                                        } else {
                                                                            phi_14625_ = true;
                                                                        }
                                                                        let _e4729 = phi_14625_;
                                                                        if _e4729 {
                                                                            let _e4730 = (_e4720 >= _e4717);
                                                                            if _e4730 {
                                                                                phi_14650_ = f64();
                                                                                phi_14651_ = false;
                                                                            } else {
                                                                                if ((_e4717 - _e4720) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14648_ = (((_e4717 - _e4723) / (_e4717 - _e4720)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14649_ = false;
                                                                                } else {
                                                                                    phi_14648_ = f64();
                                                                                    phi_14649_ = true;
                                                                                }
                                                                                let _e4744 = phi_14648_;
                                                                                let _e4746 = phi_14649_;
                                                                                phi_14650_ = _e4744;
                                                                                phi_14651_ = _e4746;
                                                                            }
                                                                            let _e4748 = phi_14650_;
                                                                            let _e4750 = phi_14651_;
                                                                            phi_14652_ = _e4748;
                                                                            phi_14653_ = _e4730;
                                                                            phi_14654_ = _e4750;
                                                                        } else {
                                                                            phi_14652_ = f64();
                                                                            phi_14653_ = true;
                                                                            phi_14654_ = false;
                                                                        }
                                                                        let _e4752 = phi_14652_;
                                                                        let _e4754 = phi_14653_;
                                                                        let _e4756 = phi_14654_;
                                                                        if _e4754 {
                                                                            phi_14659_ = f64(2f);
                                                                            phi_14660_ = true;
                                                                        } else {
                                                                            phi_14659_ = _e4119;
                                                                            phi_14660_ = _e4756;
                                                                        }
                                                                        let _e4759 = phi_14659_;
                                                                        let _e4761 = phi_14660_;
                                                                        if _e4761 {
                                                                            phi_14664_ = _e4759;
                                                                        } else {
                                                                            phi_14664_ = _e4752;
                                                                        }
                                                                        let _e4763 = phi_14664_;
                                                                        let _e4766 = local.member[1u];
                                                                        let _e4769 = local.member_1[1u];
                                                                        let _e4772 = local.member_2[1u];
                                                                        if (_e4766 > _e4772) {
                                                                            if (_e4769 > _e4772) {
                                                                                phi_14696_ = false;
                                                                            } else {
                                                                                phi_14696_ = true;
                                                                            }
                                                                            let _e4776 = phi_14696_;
                                                                            phi_14697_ = _e4776;
                                                                        } else {
                                                                            phi_14697_ = true;
                                                                        }
                                                                        let _e4778 = phi_14697_;
                                                                        if _e4778 {
                                                                            let _e4779 = (_e4769 >= _e4766);
                                                                            if _e4779 {
                                                                                phi_14722_ = f64();
                                                                                phi_14723_ = false;
                                                                            } else {
                                                                                if ((_e4766 - _e4769) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14720_ = (((_e4766 - _e4772) / (_e4766 - _e4769)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14721_ = false;
                                                                                } else {
                                                                                    phi_14720_ = f64();
                                                                                    phi_14721_ = true;
                                                                                }
                                                                                let _e4793 = phi_14720_;
                                                                                let _e4795 = phi_14721_;
                                                                                phi_14722_ = _e4793;
                                                                                phi_14723_ = _e4795;
                                                                            }
                                                                            let _e4797 = phi_14722_;
                                                                            let _e4799 = phi_14723_;
                                                                            phi_14724_ = _e4797;
                                                                            phi_14725_ = _e4779;
                                                                            phi_14726_ = _e4799;
                                                                        } else {
                                                                            phi_14724_ = f64();
                                                                            phi_14725_ = true;
                                                                            phi_14726_ = false;
                                                                        }
                                                                        let _e4801 = phi_14724_;
                                                                        let _e4803 = phi_14725_;
                                                                        let _e4805 = phi_14726_;
                                                                        if _e4803 {
                                                                            phi_14731_ = f64(2f);
                                                                            phi_14732_ = true;
                                                                        } else {
                                                                            phi_14731_ = _e4119;
                                                                            phi_14732_ = _e4805;
                                                                        }
                                                                        let _e4808 = phi_14731_;
                                                                        let _e4810 = phi_14732_;
                                                                        if _e4810 {
                                                                            phi_14736_ = _e4808;
                                                                        } else {
                                                                            phi_14736_ = _e4801;
                                                                        }
                                                                        let _e4812 = phi_14736_;
                                                                        if (_e4763 < _e4812) {
                                                                            phi_14741_ = _e4763;
                                                                        } else {
                                                                            phi_14741_ = _e4812;
                                                                        }
                                                                        let _e4815 = phi_14741_;
                                                                        let _e4818 = local.member[2u];
                                                                        let _e4821 = local.member_1[2u];
                                                                        let _e4824 = local.member_2[2u];
                                                                        if (_e4818 > _e4824) {
                                                                            if (_e4821 > _e4824) {
                                                                                phi_14773_ = false;
                                                                            } else {
                                                                                phi_14773_ = true;
                                                                            }
                                                                            let _e4828 = phi_14773_;
                                                                            phi_14774_ = _e4828;
                                                                        } else {
                                                                            phi_14774_ = true;
                                                                        }
                                                                        let _e4830 = phi_14774_;
                                                                        if _e4830 {
                                                                            let _e4831 = (_e4821 >= _e4818);
                                                                            if _e4831 {
                                                                                phi_14799_ = f64();
                                                                                phi_14800_ = false;
                                                                            } else {
                                                                                if ((_e4818 - _e4821) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14797_ = (((_e4818 - _e4824) / (_e4818 - _e4821)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14798_ = false;
                                                                                } else {
                                                                                    phi_14797_ = f64();
                                                                                    phi_14798_ = true;
                                                                                }
                                                                                let _e4845 = phi_14797_;
                                                                                let _e4847 = phi_14798_;
                                                                                phi_14799_ = _e4845;
                                                                                phi_14800_ = _e4847;
                                                                            }
                                                                            let _e4849 = phi_14799_;
                                                                            let _e4851 = phi_14800_;
                                                                            phi_14801_ = _e4849;
                                                                            phi_14802_ = _e4831;
                                                                            phi_14803_ = _e4851;
                                                                        } else {
                                                                            phi_14801_ = f64();
                                                                            phi_14802_ = true;
                                                                            phi_14803_ = false;
                                                                        }
                                                                        let _e4853 = phi_14801_;
                                                                        let _e4855 = phi_14802_;
                                                                        let _e4857 = phi_14803_;
                                                                        if _e4855 {
                                                                            phi_14808_ = f64(2f);
                                                                            phi_14809_ = true;
                                                                        } else {
                                                                            phi_14808_ = _e4119;
                                                                            phi_14809_ = _e4857;
                                                                        }
                                                                        let _e4860 = phi_14808_;
                                                                        let _e4862 = phi_14809_;
                                                                        if _e4862 {
                                                                            phi_14813_ = _e4860;
                                                                        } else {
                                                                            phi_14813_ = _e4853;
                                                                        }
                                                                        let _e4864 = phi_14813_;
                                                                        let _e4867 = local.member[3u];
                                                                        let _e4870 = local.member_1[3u];
                                                                        let _e4873 = local.member_2[3u];
                                                                        if (_e4867 > _e4873) {
                                                                            if (_e4870 > _e4873) {
                                                                                phi_14845_ = false;
                                                                            } else {
                                                                                phi_14845_ = true;
                                                                            }
                                                                            let _e4877 = phi_14845_;
                                                                            phi_14846_ = _e4877;
                                                                        } else {
                                                                            phi_14846_ = true;
                                                                        }
                                                                        let _e4879 = phi_14846_;
                                                                        if _e4879 {
                                                                            let _e4880 = (_e4870 >= _e4867);
                                                                            if _e4880 {
                                                                                phi_14871_ = f64();
                                                                                phi_14872_ = false;
                                                                            } else {
                                                                                if ((_e4867 - _e4870) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14869_ = (((_e4867 - _e4873) / (_e4867 - _e4870)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14870_ = false;
                                                                                } else {
                                                                                    phi_14869_ = f64();
                                                                                    phi_14870_ = true;
                                                                                }
                                                                                let _e4894 = phi_14869_;
                                                                                let _e4896 = phi_14870_;
                                                                                phi_14871_ = _e4894;
                                                                                phi_14872_ = _e4896;
                                                                            }
                                                                            let _e4898 = phi_14871_;
                                                                            let _e4900 = phi_14872_;
                                                                            phi_14873_ = _e4898;
                                                                            phi_14874_ = _e4880;
                                                                            phi_14875_ = _e4900;
                                                                        } else {
                                                                            phi_14873_ = f64();
                                                                            phi_14874_ = true;
                                                                            phi_14875_ = false;
                                                                        }
                                                                        let _e4902 = phi_14873_;
                                                                        let _e4904 = phi_14874_;
                                                                        let _e4906 = phi_14875_;
                                                                        if _e4904 {
                                                                            phi_14880_ = f64(2f);
                                                                            phi_14881_ = true;
                                                                        } else {
                                                                            phi_14880_ = _e4119;
                                                                            phi_14881_ = _e4906;
                                                                        }
                                                                        let _e4909 = phi_14880_;
                                                                        let _e4911 = phi_14881_;
                                                                        if _e4911 {
                                                                            phi_14885_ = _e4909;
                                                                        } else {
                                                                            phi_14885_ = _e4902;
                                                                        }
                                                                        let _e4913 = phi_14885_;
                                                                        if (_e4864 < _e4913) {
                                                                            phi_14890_ = _e4864;
                                                                        } else {
                                                                            phi_14890_ = _e4913;
                                                                        }
                                                                        let _e4916 = phi_14890_;
                                                                        if (_e4815 < _e4916) {
                                                                            phi_14895_ = _e4815;
                                                                        } else {
                                                                            phi_14895_ = _e4916;
                                                                        }
                                                                        let _e4919 = phi_14895_;
                                                                        if (_e4919 > _e4119) {
                                                                            phi_14900_ = _e4919;
                                                                        } else {
                                                                            phi_14900_ = _e4119;
                                                                        }
                                                                        let _e4922 = phi_14900_;
                                                                        let _e4923 = (_e4922 > _e3143.member_1);
                                                                        if _e4923 {
                                                                            phi_15417_ = f64();
                                                                            phi_15418_ = f64();
                                                                            phi_15419_ = false;
                                                                            phi_15420_ = false;
                                                                        } else {
                                                                            let _e4924 = (_e4922 - _e4119);
                                                                            let _e4925 = (_e4924 <= _e4108);
                                                                            let _e4928 = (_e4922 + (_e401 * f64(0.01f)));
                                                                            if (_e4928 < _e3143.member_1) {
                                                                                phi_14914_ = _e4928;
                                                                            } else {
                                                                                phi_14914_ = _e3143.member_1;
                                                                            }
                                                                            let _e4931 = phi_14914_;
                                                                            if _e4925 {
                                                                                if (_e663 > f64(0f)) {
                                                                                    let _e4936 = local_18.member[0u];
                                                                                    let _e4942 = local_18.member[1u];
                                                                                    let _e4958 = local_18.member_1[0u];
                                                                                    let _e4964 = local_18.member_1[1u];
                                                                                    let _e4980 = local_18.member_2[0u];
                                                                                    let _e4986 = local_18.member_2[1u];
                                                                                    let _e5000 = function_3(array<f64, 3>((_e4936[0] + ((_e4942[0] - _e4936[0]) * _e4931)), (_e4936[1] + ((_e4942[1] - _e4936[1]) * _e4931)), (_e4936[2] + ((_e4942[2] - _e4936[2]) * _e4931))), array<f64, 3>((_e4958[0] + ((_e4964[0] - _e4958[0]) * _e4931)), (_e4958[1] + ((_e4964[1] - _e4958[1]) * _e4931)), (_e4958[2] + ((_e4964[2] - _e4958[2]) * _e4931))), array<f64, 3>((_e4980[0] + ((_e4986[0] - _e4980[0]) * _e4931)), (_e4980[1] + ((_e4986[1] - _e4980[1]) * _e4931)), (_e4980[2] + ((_e4986[2] - _e4980[2]) * _e4931))), 0u);
                                                                                    let _e5011 = (((_e5000[0] * _e5000[0]) + (_e5000[1] * _e5000[1])) + (_e5000[2] * _e5000[2]));
                                                                                    if (_e5011 <= 2.2250738585072014e-308lf) {
                                                                                        if (_e5011 > 0.0lf) {
                                                                                            phi_15045_ = (1.464336215552873e-154lf * 2.0lf);
                                                                                        } else {
                                                                                            phi_15045_ = 0.0lf;
                                                                                        }
                                                                                        let _e5063 = phi_15045_;
                                                                                        phi_15109_ = _e5063;
                                                                                    } else {
                                                                                        phi_15052_ = type_16(0i, 5i);
                                                                                        phi_15055_ = bitcast<f64>(((bitcast<u64>(_e5011) / 2lu) + 2303426169912950784lu));
                                                                                        loop {
                                                                                            let _e5018 = phi_15052_;
                                                                                            let _e5020 = phi_15055_;
                                                                                            local_29 = _e5020;
                                                                                            if (_e5018.member < _e5018.member_1) {
                                                                                                let _e5027 = (_e5018.member + 1i);
                                                                                                if ((false == (_e5027 > _e5018.member)) != false) {
                                                                                                    phi_15076_ = true;
                                                                                                } else {
                                                                                                    phi_15076_ = false;
                                                                                                }
                                                                                                let _e5032 = phi_15076_;
                                                                                                if _e5032 {
                                                                                                    phi_15082_ = type_17(0u, type_17().member_1);
                                                                                                } else {
                                                                                                    phi_15082_ = type_17(1u, _e5027);
                                                                                                }
                                                                                                let _e5037 = phi_15082_;
                                                                                                phi_15053_ = type_16(_e5037.member_1, _e5018.member_1);
                                                                                                phi_15096_ = type_17(1u, _e5018.member);
                                                                                            } else {
                                                                                                phi_15053_ = _e5018;
                                                                                                phi_15096_ = type_17(0u, type_17().member_1);
                                                                                            }
                                                                                            let _e5043 = phi_15053_;
                                                                                            let _e5045 = phi_15096_;
                                                                                            let _e5048 = (bitcast<i32>(_e5045.member) != 0i);
                                                                                            if _e5048 {
                                                                                                phi_15056_ = (0.5lf * (_e5020 + (_e5011 / _e5020)));
                                                                                            } else {
                                                                                                phi_15056_ = f64();
                                                                                            }
                                                                                            let _e5053 = phi_15056_;
                                                                                            continue;
                                                                                            continuing {
                                                                                                phi_15052_ = _e5043;
                                                                                                phi_15055_ = _e5053;
                                                                                                break if !(_e5048);
                                                                                            }
                                                                                        }
                                                                                        let _e5058 = local_29;
                                                                                        phi_15109_ = (_e5058 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                                    }
                                                                                    let _e5065 = phi_15109_;
                                                                                    let _e5073 = local_18.member[0u];
                                                                                    if (_e5073[0] < 0.0lf) {
                                                                                        phi_15127_ = -(_e5073[0]);
                                                                                    } else {
                                                                                        phi_15127_ = _e5073[0];
                                                                                    }
                                                                                    let _e5080 = phi_15127_;
                                                                                    if (_e5073[1] < 0.0lf) {
                                                                                        phi_15134_ = -(_e5073[1]);
                                                                                    } else {
                                                                                        phi_15134_ = _e5073[1];
                                                                                    }
                                                                                    let _e5084 = phi_15134_;
                                                                                    if (_e5080 > _e5084) {
                                                                                        phi_15139_ = _e5080;
                                                                                    } else {
                                                                                        phi_15139_ = _e5084;
                                                                                    }
                                                                                    let _e5087 = phi_15139_;
                                                                                    if (_e5073[2] < 0.0lf) {
                                                                                        phi_15146_ = -(_e5073[2]);
                                                                                    } else {
                                                                                        phi_15146_ = _e5073[2];
                                                                                    }
                                                                                    let _e5091 = phi_15146_;
                                                                                    if (_e5087 > _e5091) {
                                                                                        phi_15151_ = _e5087;
                                                                                    } else {
                                                                                        phi_15151_ = _e5091;
                                                                                    }
                                                                                    let _e5094 = phi_15151_;
                                                                                    let _e5097 = local_18.member[1u];
                                                                                    if (_e5097[0] < 0.0lf) {
                                                                                        phi_15164_ = -(_e5097[0]);
                                                                                    } else {
                                                                                        phi_15164_ = _e5097[0];
                                                                                    }
                                                                                    let _e5104 = phi_15164_;
                                                                                    if (_e5097[1] < 0.0lf) {
                                                                                        phi_15171_ = -(_e5097[1]);
                                                                                    } else {
                                                                                        phi_15171_ = _e5097[1];
                                                                                    }
                                                                                    let _e5108 = phi_15171_;
                                                                                    if (_e5104 > _e5108) {
                                                                                        phi_15176_ = _e5104;
                                                                                    } else {
                                                                                        phi_15176_ = _e5108;
                                                                                    }
                                                                                    let _e5111 = phi_15176_;
                                                                                    if (_e5097[2] < 0.0lf) {
                                                                                        phi_15183_ = -(_e5097[2]);
                                                                                    } else {
                                                                                        phi_15183_ = _e5097[2];
                                                                                    }
                                                                                    let _e5115 = phi_15183_;
                                                                                    if (_e5111 > _e5115) {
                                                                                        phi_15188_ = _e5111;
                                                                                    } else {
                                                                                        phi_15188_ = _e5115;
                                                                                    }
                                                                                    let _e5118 = phi_15188_;
                                                                                    if (_e5094 > _e5118) {
                                                                                        phi_15193_ = _e5094;
                                                                                    } else {
                                                                                        phi_15193_ = _e5118;
                                                                                    }
                                                                                    let _e5121 = phi_15193_;
                                                                                    let _e5123 = local_18.member_3;
                                                                                    let _e5127 = local_18.member_1[0u];
                                                                                    if (_e5127[0] < 0.0lf) {
                                                                                        phi_15210_ = -(_e5127[0]);
                                                                                    } else {
                                                                                        phi_15210_ = _e5127[0];
                                                                                    }
                                                                                    let _e5134 = phi_15210_;
                                                                                    if (_e5127[1] < 0.0lf) {
                                                                                        phi_15217_ = -(_e5127[1]);
                                                                                    } else {
                                                                                        phi_15217_ = _e5127[1];
                                                                                    }
                                                                                    let _e5138 = phi_15217_;
                                                                                    if (_e5134 > _e5138) {
                                                                                        phi_15222_ = _e5134;
                                                                                    } else {
                                                                                        phi_15222_ = _e5138;
                                                                                    }
                                                                                    let _e5141 = phi_15222_;
                                                                                    if (_e5127[2] < 0.0lf) {
                                                                                        phi_15229_ = -(_e5127[2]);
                                                                                    } else {
                                                                                        phi_15229_ = _e5127[2];
                                                                                    }
                                                                                    let _e5145 = phi_15229_;
                                                                                    if (_e5141 > _e5145) {
                                                                                        phi_15234_ = _e5141;
                                                                                    } else {
                                                                                        phi_15234_ = _e5145;
                                                                                    }
                                                                                    let _e5148 = phi_15234_;
                                                                                    let _e5151 = local_18.member_1[1u];
                                                                                    if (_e5151[0] < 0.0lf) {
                                                                                        phi_15248_ = -(_e5151[0]);
                                                                                    } else {
                                                                                        phi_15248_ = _e5151[0];
                                                                                    }
                                                                                    let _e5158 = phi_15248_;
                                                                                    if (_e5151[1] < 0.0lf) {
                                                                                        phi_15255_ = -(_e5151[1]);
                                                                                    } else {
                                                                                        phi_15255_ = _e5151[1];
                                                                                    }
                                                                                    let _e5162 = phi_15255_;
                                                                                    if (_e5158 > _e5162) {
                                                                                        phi_15260_ = _e5158;
                                                                                    } else {
                                                                                        phi_15260_ = _e5162;
                                                                                    }
                                                                                    let _e5165 = phi_15260_;
                                                                                    if (_e5151[2] < 0.0lf) {
                                                                                        phi_15267_ = -(_e5151[2]);
                                                                                    } else {
                                                                                        phi_15267_ = _e5151[2];
                                                                                    }
                                                                                    let _e5169 = phi_15267_;
                                                                                    if (_e5165 > _e5169) {
                                                                                        phi_15272_ = _e5165;
                                                                                    } else {
                                                                                        phi_15272_ = _e5169;
                                                                                    }
                                                                                    let _e5172 = phi_15272_;
                                                                                    if (_e5148 > _e5172) {
                                                                                        phi_15277_ = _e5148;
                                                                                    } else {
                                                                                        phi_15277_ = _e5172;
                                                                                    }
                                                                                    let _e5175 = phi_15277_;
                                                                                    let _e5177 = local_18.member_3;
                                                                                    let _e5181 = local_18.member_2[0u];
                                                                                    if (_e5181[0] < 0.0lf) {
                                                                                        phi_15294_ = -(_e5181[0]);
                                                                                    } else {
                                                                                        phi_15294_ = _e5181[0];
                                                                                    }
                                                                                    let _e5188 = phi_15294_;
                                                                                    if (_e5181[1] < 0.0lf) {
                                                                                        phi_15301_ = -(_e5181[1]);
                                                                                    } else {
                                                                                        phi_15301_ = _e5181[1];
                                                                                    }
                                                                                    let _e5192 = phi_15301_;
                                                                                    if (_e5188 > _e5192) {
                                                                                        phi_15306_ = _e5188;
                                                                                    } else {
                                                                                        phi_15306_ = _e5192;
                                                                                    }
                                                                                    let _e5195 = phi_15306_;
                                                                                    if (_e5181[2] < 0.0lf) {
                                                                                        phi_15313_ = -(_e5181[2]);
                                                                                    } else {
                                                                                        phi_15313_ = _e5181[2];
                                                                                    }
                                                                                    let _e5199 = phi_15313_;
                                                                                    if (_e5195 > _e5199) {
                                                                                        phi_15318_ = _e5195;
                                                                                    } else {
                                                                                        phi_15318_ = _e5199;
                                                                                    }
                                                                                    let _e5202 = phi_15318_;
                                                                                    let _e5205 = local_18.member_2[1u];
                                                                                    if (_e5205[0] < 0.0lf) {
                                                                                        phi_15332_ = -(_e5205[0]);
                                                                                    } else {
                                                                                        phi_15332_ = _e5205[0];
                                                                                    }
                                                                                    let _e5212 = phi_15332_;
                                                                                    if (_e5205[1] < 0.0lf) {
                                                                                        phi_15339_ = -(_e5205[1]);
                                                                                    } else {
                                                                                        phi_15339_ = _e5205[1];
                                                                                    }
                                                                                    let _e5216 = phi_15339_;
                                                                                    if (_e5212 > _e5216) {
                                                                                        phi_15344_ = _e5212;
                                                                                    } else {
                                                                                        phi_15344_ = _e5216;
                                                                                    }
                                                                                    let _e5219 = phi_15344_;
                                                                                    if (_e5205[2] < 0.0lf) {
                                                                                        phi_15351_ = -(_e5205[2]);
                                                                                    } else {
                                                                                        phi_15351_ = _e5205[2];
                                                                                    }
                                                                                    let _e5223 = phi_15351_;
                                                                                    if (_e5219 > _e5223) {
                                                                                        phi_15356_ = _e5219;
                                                                                    } else {
                                                                                        phi_15356_ = _e5223;
                                                                                    }
                                                                                    let _e5226 = phi_15356_;
                                                                                    if (_e5202 > _e5226) {
                                                                                        phi_15361_ = _e5202;
                                                                                    } else {
                                                                                        phi_15361_ = _e5226;
                                                                                    }
                                                                                    let _e5229 = phi_15361_;
                                                                                    let _e5231 = local_18.member_3;
                                                                                    let _e5239 = local_18.member_3;
                                                                                    if (((_e5065 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5121 + _e5123) + (_e5175 + _e5177)) + (_e5229 + _e5231)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5239 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e663) {
                                                                                        phi_15385_ = false;
                                                                                    } else {
                                                                                        phi_15385_ = true;
                                                                                    }
                                                                                    let _e5251 = phi_15385_;
                                                                                    phi_15386_ = _e5251;
                                                                                } else {
                                                                                    phi_15386_ = true;
                                                                                }
                                                                                let _e5253 = phi_15386_;
                                                                                phi_15387_ = _e5253;
                                                                            } else {
                                                                                phi_15387_ = true;
                                                                            }
                                                                            let _e5255 = phi_15387_;
                                                                            if _e5255 {
                                                                                if _e4127 {
                                                                                    if _e4925 {
                                                                                        phi_15406_ = f64();
                                                                                        phi_15407_ = true;
                                                                                    } else {
                                                                                        if (_e4924 <= (_e4123 * f64(0.25f))) {
                                                                                            phi_15404_ = f64(0f);
                                                                                            phi_15405_ = false;
                                                                                        } else {
                                                                                            phi_15404_ = f64();
                                                                                            phi_15405_ = true;
                                                                                        }
                                                                                        let _e5262 = phi_15404_;
                                                                                        let _e5264 = phi_15405_;
                                                                                        phi_15406_ = _e5262;
                                                                                        phi_15407_ = _e5264;
                                                                                    }
                                                                                    let _e5266 = phi_15406_;
                                                                                    let _e5268 = phi_15407_;
                                                                                    if _e5268 {
                                                                                        phi_15412_ = (_e4452 + _e4452);
                                                                                    } else {
                                                                                        phi_15412_ = _e5266;
                                                                                    }
                                                                                    let _e5271 = phi_15412_;
                                                                                    phi_15414_ = _e5271;
                                                                                } else {
                                                                                    phi_15414_ = (_e3143.member_1 - _e4119);
                                                                                }
                                                                                let _e5273 = phi_15414_;
                                                                                phi_15415_ = _e5273;
                                                                                phi_15416_ = false;
                                                                            } else {
                                                                                phi_15415_ = f64();
                                                                                phi_15416_ = true;
                                                                            }
                                                                            let _e5275 = phi_15415_;
                                                                            let _e5277 = phi_15416_;
                                                                            phi_15417_ = _e5275;
                                                                            phi_15418_ = _e4924;
                                                                            phi_15419_ = _e5255;
                                                                            phi_15420_ = _e5277;
                                                                        }
                                                                        let _e5279 = phi_15417_;
                                                                        let _e5281 = phi_15418_;
                                                                        let _e5283 = phi_15419_;
                                                                        let _e5285 = phi_15420_;
                                                                        phi_15421_ = _e4922;
                                                                        phi_15422_ = _e5279;
                                                                        phi_15423_ = _e5281;
                                                                        phi_15424_ = _e4922;
                                                                        phi_15425_ = _e5283;
                                                                        phi_15426_ = _e4923;
                                                                        phi_15427_ = _e5285;
                                                                        phi_15428_ = false;
                                                                    } else {
                                                                        phi_15421_ = f64();
                                                                        phi_15422_ = f64();
                                                                        phi_15423_ = f64();
                                                                        phi_15424_ = f64();
                                                                        phi_15425_ = false;
                                                                        phi_15426_ = false;
                                                                        phi_15427_ = false;
                                                                        phi_15428_ = true;
                                                                    }
                                                                    let _e5287 = phi_15421_;
                                                                    let _e5289 = phi_15422_;
                                                                    let _e5291 = phi_15423_;
                                                                    let _e5293 = phi_15424_;
                                                                    let _e5295 = phi_15425_;
                                                                    let _e5297 = phi_15426_;
                                                                    let _e5299 = phi_15427_;
                                                                    let _e5301 = phi_15428_;
                                                                    phi_15429_ = _e5287;
                                                                    phi_15430_ = _e5289;
                                                                    phi_15431_ = _e5291;
                                                                    phi_15432_ = _e5293;
                                                                    phi_15433_ = false;
                                                                    phi_15434_ = _e5295;
                                                                    phi_15435_ = _e5297;
                                                                    phi_15436_ = _e5299;
                                                                    phi_15437_ = _e5301;
                                                                } else {
                                                                    phi_15429_ = f64();
                                                                    phi_15430_ = f64();
                                                                    phi_15431_ = f64();
                                                                    phi_15432_ = f64();
                                                                    phi_15433_ = true;
                                                                    phi_15434_ = false;
                                                                    phi_15435_ = false;
                                                                    phi_15436_ = false;
                                                                    phi_15437_ = false;
                                                                }
                                                                let _e5303 = phi_15429_;
                                                                let _e5305 = phi_15430_;
                                                                let _e5307 = phi_15431_;
                                                                let _e5309 = phi_15432_;
                                                                let _e5311 = phi_15433_;
                                                                let _e5313 = phi_15434_;
                                                                let _e5315 = phi_15435_;
                                                                let _e5317 = phi_15436_;
                                                                let _e5319 = phi_15437_;
                                                                phi_15438_ = _e5303;
                                                                phi_15439_ = _e5305;
                                                                phi_15440_ = _e5307;
                                                                phi_15441_ = _e5309;
                                                                phi_15442_ = _e5311;
                                                                phi_15443_ = _e5313;
                                                                phi_15444_ = _e5315;
                                                                phi_15445_ = _e5317;
                                                                phi_15446_ = _e5319;
                                                            } else {
                                                                phi_15438_ = f64();
                                                                phi_15439_ = f64();
                                                                phi_15440_ = f64();
                                                                phi_15441_ = f64();
                                                                phi_15442_ = true;
                                                                phi_15443_ = false;
                                                                phi_15444_ = false;
                                                                phi_15445_ = false;
                                                                phi_15446_ = false;
                                                            }
                                                            let _e5321 = phi_15438_;
                                                            let _e5323 = phi_15439_;
                                                            let _e5325 = phi_15440_;
                                                            let _e5327 = phi_15441_;
                                                            let _e5329 = phi_15442_;
                                                            let _e5331 = phi_15443_;
                                                            let _e5333 = phi_15444_;
                                                            let _e5335 = phi_15445_;
                                                            let _e5337 = phi_15446_;
                                                            if _e5329 {
                                                                if (_e4119 <= _e4121) {
                                                                    let _e5503 = (_e4129 + 1u);
                                                                    let _e5504 = (_e5503 > 3u);
                                                                    if _e5504 {
                                                                        phi_15459_ = false;
                                                                    } else {
                                                                        phi_15459_ = true;
                                                                    }
                                                                    let _e5506 = phi_15459_;
                                                                    phi_15786_ = _e5503;
                                                                    phi_15787_ = f64();
                                                                    phi_15788_ = false;
                                                                    phi_15789_ = _e5506;
                                                                    phi_15790_ = _e5504;
                                                                } else {
                                                                    let _e5341 = local.member[0u];
                                                                    let _e5344 = local.member_1[0u];
                                                                    let _e5347 = local.member[0u];
                                                                    let _e5353 = local.member_2[0u];
                                                                    let _e5354 = ((_e5341 + ((_e5344 - _e5347) * _e4125)) - _e5353);
                                                                    let _e5357 = local.member[1u];
                                                                    let _e5360 = local.member_1[1u];
                                                                    let _e5363 = local.member[1u];
                                                                    let _e5369 = local.member_2[1u];
                                                                    let _e5370 = ((_e5357 + ((_e5360 - _e5363) * _e4125)) - _e5369);
                                                                    if (_e5354 < _e5370) {
                                                                        phi_15532_ = _e5354;
                                                                    } else {
                                                                        phi_15532_ = _e5370;
                                                                    }
                                                                    let _e5373 = phi_15532_;
                                                                    let _e5376 = local.member[2u];
                                                                    let _e5379 = local.member_1[2u];
                                                                    let _e5382 = local.member[2u];
                                                                    let _e5388 = local.member_2[2u];
                                                                    let _e5389 = ((_e5376 + ((_e5379 - _e5382) * _e4125)) - _e5388);
                                                                    let _e5392 = local.member[3u];
                                                                    let _e5395 = local.member_1[3u];
                                                                    let _e5398 = local.member[3u];
                                                                    let _e5404 = local.member_2[3u];
                                                                    let _e5405 = ((_e5392 + ((_e5395 - _e5398) * _e4125)) - _e5404);
                                                                    if (_e5389 < _e5405) {
                                                                        phi_15605_ = _e5389;
                                                                    } else {
                                                                        phi_15605_ = _e5405;
                                                                    }
                                                                    let _e5408 = phi_15605_;
                                                                    if (_e5373 < _e5408) {
                                                                        phi_15610_ = _e5373;
                                                                    } else {
                                                                        phi_15610_ = _e5408;
                                                                    }
                                                                    let _e5411 = phi_15610_;
                                                                    let _e5414 = local_1.member[0u];
                                                                    let _e5417 = local_1.member_1[0u];
                                                                    let _e5420 = local_1.member[0u];
                                                                    let _e5426 = local_1.member_2[0u];
                                                                    let _e5427 = ((_e5414 + ((_e5417 - _e5420) * _e4119)) - _e5426);
                                                                    let _e5430 = local_1.member[1u];
                                                                    let _e5433 = local_1.member_1[1u];
                                                                    let _e5436 = local_1.member[1u];
                                                                    let _e5442 = local_1.member_2[1u];
                                                                    let _e5443 = ((_e5430 + ((_e5433 - _e5436) * _e4119)) - _e5442);
                                                                    if (_e5427 < _e5443) {
                                                                        phi_15683_ = _e5427;
                                                                    } else {
                                                                        phi_15683_ = _e5443;
                                                                    }
                                                                    let _e5446 = phi_15683_;
                                                                    let _e5449 = local_1.member[2u];
                                                                    let _e5452 = local_1.member_1[2u];
                                                                    let _e5455 = local_1.member[2u];
                                                                    let _e5461 = local_1.member_2[2u];
                                                                    let _e5462 = ((_e5449 + ((_e5452 - _e5455) * _e4119)) - _e5461);
                                                                    let _e5465 = local_1.member[3u];
                                                                    let _e5468 = local_1.member_1[3u];
                                                                    let _e5471 = local_1.member[3u];
                                                                    let _e5477 = local_1.member_2[3u];
                                                                    let _e5478 = ((_e5465 + ((_e5468 - _e5471) * _e4119)) - _e5477);
                                                                    if (_e5462 < _e5478) {
                                                                        phi_15756_ = _e5462;
                                                                    } else {
                                                                        phi_15756_ = _e5478;
                                                                    }
                                                                    let _e5481 = phi_15756_;
                                                                    if (_e5446 < _e5481) {
                                                                        phi_15761_ = _e5446;
                                                                    } else {
                                                                        phi_15761_ = _e5481;
                                                                    }
                                                                    let _e5484 = phi_15761_;
                                                                    let _e5485 = f64(0.0625f);
                                                                    let _e5487 = f64(0.9f);
                                                                    if (_e5484 > f64(0f)) {
                                                                        phi_15784_ = f64(0.5f);
                                                                    } else {
                                                                        let _e5493 = (f64(0.95f) * (_e5411 / (_e5411 - _e5484)));
                                                                        if (_e5493 > _e5485) {
                                                                            if (_e5493 < _e5487) {
                                                                                phi_15782_ = _e5493;
                                                                            } else {
                                                                                phi_15782_ = _e5487;
                                                                            }
                                                                            let _e5497 = phi_15782_;
                                                                            phi_15783_ = _e5497;
                                                                        } else {
                                                                            phi_15783_ = _e5485;
                                                                        }
                                                                        let _e5499 = phi_15783_;
                                                                        phi_15784_ = _e5499;
                                                                    }
                                                                    let _e5501 = phi_15784_;
                                                                    phi_15786_ = u32();
                                                                    phi_15787_ = (_e4452 * _e5501);
                                                                    phi_15788_ = true;
                                                                    phi_15789_ = false;
                                                                    phi_15790_ = false;
                                                                }
                                                                let _e5508 = phi_15786_;
                                                                let _e5510 = phi_15787_;
                                                                let _e5512 = phi_15788_;
                                                                let _e5514 = phi_15789_;
                                                                let _e5516 = phi_15790_;
                                                                phi_15791_ = _e5508;
                                                                phi_15792_ = _e4121;
                                                                phi_15793_ = _e5510;
                                                                phi_15794_ = _e4123;
                                                                phi_15795_ = _e4125;
                                                                phi_15796_ = _e4127;
                                                                phi_15797_ = _e4129;
                                                                phi_15798_ = _e5512;
                                                                phi_15799_ = _e5514;
                                                                phi_15800_ = _e5516;
                                                                phi_15801_ = false;
                                                                phi_15802_ = false;
                                                                phi_15803_ = false;
                                                            } else {
                                                                phi_15791_ = u32();
                                                                phi_15792_ = _e5321;
                                                                phi_15793_ = _e5323;
                                                                phi_15794_ = _e5325;
                                                                phi_15795_ = _e4119;
                                                                phi_15796_ = true;
                                                                phi_15797_ = 0u;
                                                                phi_15798_ = _e5331;
                                                                phi_15799_ = false;
                                                                phi_15800_ = false;
                                                                phi_15801_ = _e5333;
                                                                phi_15802_ = _e5335;
                                                                phi_15803_ = _e5337;
                                                            }
                                                            let _e5518 = phi_15791_;
                                                            let _e5520 = phi_15792_;
                                                            let _e5522 = phi_15793_;
                                                            let _e5524 = phi_15794_;
                                                            let _e5526 = phi_15795_;
                                                            let _e5528 = phi_15796_;
                                                            let _e5530 = phi_15797_;
                                                            let _e5532 = phi_15798_;
                                                            let _e5534 = phi_15799_;
                                                            let _e5536 = phi_15800_;
                                                            let _e5538 = phi_15801_;
                                                            let _e5540 = phi_15802_;
                                                            let _e5542 = phi_15803_;
                                                            if _e5532 {
                                                                let _e5543 = (_e5526 + _e5522);
                                                                if (_e5543 > _e5520) {
                                                                    phi_15812_ = _e5543;
                                                                } else {
                                                                    phi_15812_ = _e5520;
                                                                }
                                                                let _e5546 = phi_15812_;
                                                                if (_e5546 < _e3143.member_1) {
                                                                    phi_15817_ = _e5546;
                                                                } else {
                                                                    phi_15817_ = _e3143.member_1;
                                                                }
                                                                let _e5549 = phi_15817_;
                                                                if !(_e4127) {
                                                                    phi_15826_ = true;
                                                                } else {
                                                                    phi_15826_ = ((_e5549 - _e5526) > _e4108);
                                                                }
                                                                let _e5553 = phi_15826_;
                                                                if _e5553 {
                                                                    phi_15830_ = false;
                                                                } else {
                                                                    phi_15830_ = true;
                                                                }
                                                                let _e5555 = phi_15830_;
                                                                phi_15831_ = _e5549;
                                                                phi_15832_ = _e5520;
                                                                phi_15833_ = _e5524;
                                                                phi_15834_ = _e5526;
                                                                phi_15835_ = _e5528;
                                                                phi_15836_ = _e5530;
                                                                phi_15837_ = _e5553;
                                                                phi_15838_ = _e5555;
                                                                phi_15839_ = false;
                                                                phi_15840_ = false;
                                                                phi_15841_ = false;
                                                                phi_15842_ = false;
                                                            } else {
                                                                phi_15831_ = _e4119;
                                                                phi_15832_ = _e4121;
                                                                phi_15833_ = _e4123;
                                                                phi_15834_ = _e4125;
                                                                phi_15835_ = _e4127;
                                                                phi_15836_ = _e5518;
                                                                phi_15837_ = _e5534;
                                                                phi_15838_ = false;
                                                                phi_15839_ = _e5536;
                                                                phi_15840_ = _e5538;
                                                                phi_15841_ = _e5540;
                                                                phi_15842_ = _e5542;
                                                            }
                                                            let _e5557 = phi_15831_;
                                                            let _e5559 = phi_15832_;
                                                            let _e5561 = phi_15833_;
                                                            let _e5563 = phi_15834_;
                                                            let _e5565 = phi_15835_;
                                                            let _e5567 = phi_15836_;
                                                            let _e5569 = phi_15837_;
                                                            let _e5571 = phi_15838_;
                                                            let _e5573 = phi_15839_;
                                                            let _e5575 = phi_15840_;
                                                            let _e5577 = phi_15841_;
                                                            let _e5579 = phi_15842_;
                                                            phi_13621_ = _e5557;
                                                            phi_13623_ = _e5559;
                                                            phi_13625_ = _e5561;
                                                            phi_13627_ = _e5563;
                                                            phi_13629_ = _e5565;
                                                            phi_13631_ = _e5567;
                                                            phi_15843_ = _e5520;
                                                            phi_15844_ = _e5327;
                                                            phi_15845_ = _e5569;
                                                            phi_15846_ = _e5571;
                                                            phi_15847_ = _e5573;
                                                            phi_15848_ = _e5575;
                                                            phi_15849_ = _e5577;
                                                            phi_15850_ = false;
                                                            phi_15851_ = _e5579;
                                                        } else {
                                                            phi_13621_ = f64();
                                                            phi_13623_ = f64();
                                                            phi_13625_ = f64();
                                                            phi_13627_ = f64();
                                                            phi_13629_ = bool();
                                                            phi_13631_ = u32();
                                                            phi_15843_ = f64();
                                                            phi_15844_ = f64();
                                                            phi_15845_ = false;
                                                            phi_15846_ = false;
                                                            phi_15847_ = false;
                                                            phi_15848_ = false;
                                                            phi_15849_ = false;
                                                            phi_15850_ = true;
                                                            phi_15851_ = false;
                                                        }
                                                        let _e5581 = phi_13621_;
                                                        let _e5583 = phi_13623_;
                                                        let _e5585 = phi_13625_;
                                                        let _e5587 = phi_13627_;
                                                        let _e5589 = phi_13629_;
                                                        let _e5591 = phi_13631_;
                                                        let _e5593 = phi_15843_;
                                                        let _e5595 = phi_15844_;
                                                        let _e5597 = phi_15845_;
                                                        let _e5599 = phi_15846_;
                                                        let _e5601 = phi_15847_;
                                                        let _e5603 = phi_15848_;
                                                        let _e5605 = phi_15849_;
                                                        let _e5607 = phi_15850_;
                                                        let _e5609 = phi_15851_;
                                                        local_30 = _e5599;
                                                        local_70 = _e5601;
                                                        local_71 = _e5603;
                                                        local_72 = _e5605;
                                                        local_73 = _e5607;
                                                        local_74 = _e5609;
                                                        local_75 = _e5599;
                                                        local_76 = _e5595;
                                                        local_77 = _e5593;
                                                        continue;
                                                        continuing {
                                                            phi_13617_ = _e4141;
                                                            phi_13620_ = _e5581;
                                                            phi_13622_ = _e5583;
                                                            phi_13624_ = _e5585;
                                                            phi_13626_ = _e5587;
                                                            phi_13628_ = _e5589;
                                                            phi_13630_ = _e5591;
                                                            break if !(_e5597);
                                                        }
                                                    }
                                                    let _e5612 = local_30;
                                                    if _e5612 {
                                                        phi_15855_ = false;
                                                        phi_15856_ = false;
                                                        phi_15857_ = false;
                                                        phi_15858_ = false;
                                                        phi_15859_ = false;
                                                    } else {
                                                        let _e11338 = local_70;
                                                        phi_15855_ = _e11338;
                                                        let _e11341 = local_71;
                                                        phi_15856_ = _e11341;
                                                        let _e11344 = local_72;
                                                        phi_15857_ = _e11344;
                                                        let _e11347 = local_73;
                                                        phi_15858_ = _e11347;
                                                        let _e11350 = local_74;
                                                        phi_15859_ = _e11350;
                                                    }
                                                    let _e5614 = phi_15855_;
                                                    let _e5616 = phi_15856_;
                                                    let _e5618 = phi_15857_;
                                                    let _e5620 = phi_15858_;
                                                    let _e5622 = phi_15859_;
                                                    if _e5614 {
                                                        let _e5624 = local_31;
                                                        phi_15864_ = type_46(1u, _e5624);
                                                        phi_15865_ = false;
                                                        phi_15866_ = false;
                                                        phi_15867_ = false;
                                                        phi_15868_ = false;
                                                        phi_15869_ = false;
                                                    } else {
                                                        phi_15864_ = type_46();
                                                        phi_15865_ = _e5616;
                                                        phi_15866_ = _e5618;
                                                        let _e11357 = local_75;
                                                        phi_15867_ = _e11357;
                                                        phi_15868_ = _e5620;
                                                        phi_15869_ = _e5622;
                                                    }
                                                    let _e5627 = phi_15864_;
                                                    let _e5629 = phi_15865_;
                                                    let _e5631 = phi_15866_;
                                                    let _e5633 = phi_15867_;
                                                    let _e5635 = phi_15868_;
                                                    let _e5637 = phi_15869_;
                                                    if _e5629 {
                                                        phi_15874_ = type_46(0u, type_46().member_1);
                                                        phi_15875_ = false;
                                                        phi_15876_ = false;
                                                        phi_15877_ = false;
                                                        phi_15878_ = false;
                                                        phi_15879_ = true;
                                                    } else {
                                                        phi_15874_ = _e5627;
                                                        phi_15875_ = _e5631;
                                                        phi_15876_ = _e5633;
                                                        phi_15877_ = _e5635;
                                                        phi_15878_ = _e5637;
                                                        phi_15879_ = _e5614;
                                                    }
                                                    let _e5641 = phi_15874_;
                                                    let _e5643 = phi_15875_;
                                                    let _e5645 = phi_15876_;
                                                    let _e5647 = phi_15877_;
                                                    let _e5649 = phi_15878_;
                                                    let _e5651 = phi_15879_;
                                                    if _e5643 {
                                                        let _e11368 = local_76;
                                                        phi_15883_ = _e11368;
                                                        phi_15884_ = true;
                                                        phi_15885_ = false;
                                                        phi_15886_ = false;
                                                        phi_15887_ = false;
                                                    } else {
                                                        let _e11370 = local_77;
                                                        phi_15883_ = _e11370;
                                                        phi_15884_ = _e5645;
                                                        phi_15885_ = _e5647;
                                                        phi_15886_ = _e5649;
                                                        phi_15887_ = _e5651;
                                                    }
                                                    let _e5653 = phi_15883_;
                                                    let _e5655 = phi_15884_;
                                                    let _e5657 = phi_15885_;
                                                    let _e5659 = phi_15886_;
                                                    let _e5661 = phi_15887_;
                                                    if _e5655 {
                                                        phi_15891_ = _e5653;
                                                        phi_15892_ = true;
                                                        phi_15893_ = false;
                                                        phi_15894_ = false;
                                                    } else {
                                                        let _e11377 = local_78;
                                                        phi_15891_ = _e11377;
                                                        phi_15892_ = _e5657;
                                                        phi_15893_ = _e5659;
                                                        phi_15894_ = _e5661;
                                                    }
                                                    let _e5663 = phi_15891_;
                                                    let _e5665 = phi_15892_;
                                                    let _e5667 = phi_15893_;
                                                    let _e5669 = phi_15894_;
                                                    if _e5665 {
                                                        phi_15899_ = type_46(1u, _e5663);
                                                        phi_15900_ = false;
                                                        phi_15901_ = false;
                                                    } else {
                                                        phi_15899_ = type_46();
                                                        phi_15900_ = _e5667;
                                                        phi_15901_ = _e5669;
                                                    }
                                                    let _e5672 = phi_15899_;
                                                    let _e5674 = phi_15900_;
                                                    let _e5676 = phi_15901_;
                                                    if _e5674 {
                                                        phi_15906_ = type_46(0u, type_46().member_1);
                                                        phi_15907_ = true;
                                                    } else {
                                                        phi_15906_ = _e5641;
                                                        phi_15907_ = _e5676;
                                                    }
                                                    let _e5680 = phi_15906_;
                                                    let _e5682 = phi_15907_;
                                                    if _e5682 {
                                                        phi_15911_ = _e5680;
                                                    } else {
                                                        phi_15911_ = _e5672;
                                                    }
                                                    let _e5684 = phi_15911_;
                                                    let _e5687 = (_e5684.member != 0u);
                                                    if _e5687 {
                                                        phi_15918_ = false;
                                                    } else {
                                                        phi_15918_ = true;
                                                    }
                                                    let _e5689 = phi_15918_;
                                                    phi_15919_ = _e5684.member_1;
                                                    phi_15920_ = _e5689;
                                                    phi_15921_ = _e5687;
                                                    phi_15922_ = false;
                                                } else {
                                                    phi_15919_ = f64();
                                                    phi_15920_ = false;
                                                    phi_15921_ = false;
                                                    phi_15922_ = true;
                                                }
                                                let _e5691 = phi_15919_;
                                                let _e5693 = phi_15920_;
                                                let _e5695 = phi_15921_;
                                                let _e5697 = phi_15922_;
                                                phi_15923_ = _e3871;
                                                phi_15924_ = _e3873;
                                                phi_15925_ = _e5691;
                                                phi_15926_ = _e5693;
                                                phi_15927_ = _e5695;
                                                phi_15928_ = _e5697;
                                            }
                                            let _e5699 = phi_15923_;
                                            let _e5701 = phi_15924_;
                                            let _e5703 = phi_15925_;
                                            let _e5705 = phi_15926_;
                                            let _e5707 = phi_15927_;
                                            let _e5709 = phi_15928_;
                                            phi_15929_ = _e5699;
                                            phi_15930_ = _e5701;
                                            phi_15931_ = _e5703;
                                            phi_15932_ = _e3867;
                                            phi_15933_ = _e5705;
                                            phi_15934_ = _e5707;
                                            phi_15935_ = _e5709;
                                        }
                                        let _e5711 = phi_15929_;
                                        let _e5713 = phi_15930_;
                                        let _e5715 = phi_15931_;
                                        let _e5717 = phi_15932_;
                                        let _e5719 = phi_15933_;
                                        let _e5721 = phi_15934_;
                                        let _e5723 = phi_15935_;
                                        if _e5717 {
                                            phi_15939_ = false;
                                            phi_15940_ = false;
                                            phi_15941_ = false;
                                        } else {
                                            phi_15939_ = _e5719;
                                            phi_15940_ = _e5721;
                                            phi_15941_ = _e5723;
                                        }
                                        let _e5725 = phi_15939_;
                                        let _e5727 = phi_15940_;
                                        let _e5729 = phi_15941_;
                                        phi_15942_ = _e3143;
                                        phi_15943_ = _e5711;
                                        phi_15944_ = _e5713;
                                        phi_15945_ = _e5715;
                                        phi_15946_ = _e3143;
                                        phi_15947_ = _e5717;
                                        phi_15948_ = _e5725;
                                        phi_15949_ = _e5727;
                                        phi_15950_ = _e5729;
                                    } else {
                                        phi_15942_ = type_49();
                                        phi_15943_ = bool();
                                        phi_15944_ = f64();
                                        phi_15945_ = f64();
                                        phi_15946_ = type_49();
                                        phi_15947_ = true;
                                        phi_15948_ = false;
                                        phi_15949_ = false;
                                        phi_15950_ = false;
                                    }
                                    let _e5731 = phi_15942_;
                                    let _e5733 = phi_15943_;
                                    let _e5735 = phi_15944_;
                                    let _e5737 = phi_15945_;
                                    let _e5739 = phi_15946_;
                                    let _e5741 = phi_15947_;
                                    let _e5743 = phi_15948_;
                                    let _e5745 = phi_15949_;
                                    let _e5747 = phi_15950_;
                                    if _e5741 {
                                        phi_15954_ = true;
                                        phi_15955_ = false;
                                        phi_15956_ = false;
                                    } else {
                                        phi_15954_ = _e5743;
                                        phi_15955_ = _e5745;
                                        phi_15956_ = _e5747;
                                    }
                                    let _e5749 = phi_15954_;
                                    let _e5751 = phi_15955_;
                                    let _e5753 = phi_15956_;
                                    phi_15957_ = _e5731;
                                    phi_15958_ = _e5733;
                                    phi_15959_ = _e5735;
                                    phi_15960_ = _e5737;
                                    phi_15961_ = _e5739;
                                    phi_15962_ = _e5749;
                                    phi_15963_ = false;
                                    phi_15964_ = _e5751;
                                    phi_15965_ = _e5753;
                                } else {
                                    phi_15957_ = type_49();
                                    phi_15958_ = bool();
                                    phi_15959_ = f64();
                                    phi_15960_ = f64();
                                    phi_15961_ = type_49();
                                    phi_15962_ = false;
                                    phi_15963_ = true;
                                    phi_15964_ = false;
                                    phi_15965_ = false;
                                }
                                let _e5755 = phi_15957_;
                                let _e5757 = phi_15958_;
                                let _e5759 = phi_15959_;
                                let _e5761 = phi_15960_;
                                let _e5763 = phi_15961_;
                                let _e5765 = phi_15962_;
                                let _e5767 = phi_15963_;
                                let _e5769 = phi_15964_;
                                let _e5771 = phi_15965_;
                                local_32 = _e5767;
                                local_79 = _e5769;
                                local_80 = _e5771;
                                local_33 = _e5757;
                                local_34 = _e5755;
                                local_35 = _e5761;
                                local_36 = _e5759;
                                local_37 = _e5761;
                                local_38 = _e5761;
                                local_39 = _e5763;
                                continue;
                                continuing {
                                    phi_11679_ = _e2851;
                                    break if !(_e5765);
                                }
                            }
                            let _e5774 = local_32;
                            if _e5774 {
                                phi_15970_ = type_46(0u, type_46().member_1);
                                phi_15971_ = false;
                                phi_15972_ = false;
                            } else {
                                phi_15970_ = type_46();
                                let _e11433 = local_79;
                                phi_15971_ = _e11433;
                                let _e11436 = local_80;
                                phi_15972_ = _e11436;
                            }
                            let _e5778 = phi_15970_;
                            let _e5780 = phi_15971_;
                            let _e5782 = phi_15972_;
                            if _e5780 {
                                let _e5784 = local_33;
                                if _e5784 {
                                    let _e5786 = local_34;
                                    let _e5789 = local_35;
                                    let _e5792 = local_36;
                                    if ((_e5786.member_1 - _e5789) <= _e5792) {
                                        let _e5795 = local_37;
                                        phi_15986_ = type_46(1u, _e5795);
                                        phi_15987_ = false;
                                    } else {
                                        phi_15986_ = type_46();
                                        phi_15987_ = true;
                                    }
                                    let _e5798 = phi_15986_;
                                    let _e5800 = phi_15987_;
                                    phi_15988_ = _e5798;
                                    phi_15989_ = _e5800;
                                } else {
                                    phi_15988_ = type_46();
                                    phi_15989_ = true;
                                }
                                let _e5802 = phi_15988_;
                                let _e5804 = phi_15989_;
                                if _e5804 {
                                    let _e5806 = local_38;
                                    phi_15994_ = type_46(2u, _e5806);
                                } else {
                                    phi_15994_ = _e5802;
                                }
                                let _e5809 = phi_15994_;
                                phi_15995_ = _e5809;
                                phi_15996_ = false;
                            } else {
                                phi_15995_ = type_46();
                                phi_15996_ = _e5782;
                            }
                            let _e5811 = phi_15995_;
                            let _e5813 = phi_15996_;
                            if _e5813 {
                                let _e5815 = local_39;
                                phi_16002_ = type_46(1u, _e5815.member);
                                phi_16003_ = true;
                            } else {
                                phi_16002_ = _e5811;
                                phi_16003_ = _e5780;
                            }
                            let _e5819 = phi_16002_;
                            let _e5821 = phi_16003_;
                            phi_16007_ = _e5819;
                            phi_16008_ = _e5778;
                            phi_16009_ = _e5821;
                        } else {
                            phi_16007_ = _e2695;
                            phi_16008_ = type_46();
                            phi_16009_ = true;
                        }
                        let _e5823 = phi_16007_;
                        let _e5825 = phi_16008_;
                        let _e5827 = phi_16009_;
                        phi_16013_ = _e5823;
                        phi_16014_ = _e5825;
                        phi_16015_ = _e5827;
                    }
                    let _e5831 = phi_16013_;
                    let _e5833 = phi_16014_;
                    let _e5835 = phi_16015_;
                    if _e5835 {
                        phi_16019_ = _e5831;
                    } else {
                        phi_16019_ = _e5833;
                    }
                    let _e5837 = phi_16019_;
                    if (_e5837.member == 1u) {
                        if (_e5837.member_1 > _e410) {
                            phi_16030_ = false;
                        } else {
                            phi_16030_ = true;
                        }
                        let _e5843 = phi_16030_;
                        phi_16031_ = _e5843;
                    } else {
                        phi_16031_ = true;
                    }
                    let _e5845 = phi_16031_;
                    if _e5845 {
                        phi_16035_ = false;
                    } else {
                        phi_16035_ = true;
                    }
                    let _e5847 = phi_16035_;
                    if _e5847 {
                        phi_16039_ = 1u;
                    } else {
                        phi_16039_ = 0u;
                    }
                    let _e5849 = phi_16039_;
                    phi_16043_ = type_47(_e5837, _e5849);
                }
                let _e10463 = phi_16043_;
                switch bitcast<i32>(_e10463.member.member) {
                    case 0: {
                        phi_16058_ = type_37(0u, _e10463.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e10474 = function_4(_e10463.member.member_1);
                        phi_16058_ = type_37(0u, _e10463.member_1, _e10474, true);
                        break;
                    }
                    case 2: {
                        let _e10470 = function_4(_e10463.member.member_1);
                        phi_16058_ = type_37(1u, _e10463.member_1, _e10470, true);
                        break;
                    }
                    default: {
                        phi_16058_ = type_37();
                        break;
                    }
                }
                let _e10478 = phi_16058_;
                if _e10478.member_3 {
                    let _e10486 = (_e10478.member_2[1] >> bitcast<u32>(20i));
                    if (_e10486 <= 896u) {
                        phi_16082_ = 0u;
                    } else {
                        phi_16082_ = ((((_e10486 - 896u) << bitcast<u32>(23i)) | ((_e10478.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e10478.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e10501 = phi_16082_;
                    let _e10503 = atomicMin((&earliest.member[0u]), _e10501);
                }
                phi_16086_ = type_22(0u, _e10478.member, _e195, _e198, _e10478.member_2, _e10478.member_1);
                phi_16087_ = _e10478.member_3;
            } else {
                phi_16086_ = type_22(0u, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_16087_ = false;
            }
            let _e10505 = phi_16086_;
            let _e10507 = phi_16087_;
            let _e10510 = params.member.member.member_1;
            if ((_e10510 & 16u) != 0u) {
                if (_e124 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e10507 {
                    let _e10516 = atomicAdd((&counters[0u]), 1u);
                    phi_16106_ = _e10516;
                } else {
                    phi_16106_ = 0u;
                }
                let _e10518 = phi_16106_;
                workgroupBarrier();
                if (_e124 == 0u) {
                    let _e10521 = atomicLoad((&counters[0u]));
                    if (_e10521 > 0u) {
                        let _e10524 = atomicAdd((&contacts.member[0u]), _e10521);
                        atomicStore((&counters[1u]), _e10524);
                    }
                }
                workgroupBarrier();
                let _e10527 = atomicLoad((&counters[1u]));
                let _e10528 = (_e10527 + _e10518);
                if _e10507 {
                    let _e10531 = params.member.member_1.member_3;
                    if (_e10528 < _e10531) {
                        let _e10533 = (7u * _e10528);
                        atomicStore((&contacts.member[(4u + _e10533)]), _e10505.member);
                        atomicStore((&contacts.member[(_e10533 + 5u)]), _e10505.member_1);
                        atomicStore((&contacts.member[(_e10533 + 6u)]), _e10505.member_2);
                        atomicStore((&contacts.member[(_e10533 + 7u)]), _e10505.member_3);
                        atomicStore((&contacts.member[(_e10533 + 8u)]), _e10505.member_4[0]);
                        atomicStore((&contacts.member[(_e10533 + 9u)]), _e10505.member_4[1]);
                        atomicStore((&contacts.member[(_e10533 + 10u)]), _e10505.member_5);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_880_ = _e180;
            break if !(_e186);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
