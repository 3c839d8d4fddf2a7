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
    var phi_254_: f64;
    var phi_232_: array<u32, 2>;
    var phi_255_: f64;
    var phi_297_: f64;
    var phi_275_: array<u32, 2>;
    var phi_298_: f64;
    var phi_340_: f64;
    var phi_318_: array<u32, 2>;
    var phi_341_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e21 = bitcast<u32>(param[0]);
        let _e22 = (_e21 & 2147483647u);
        if (_e22 < 8388608u) {
            phi_232_ = array<u32, 2>(0u, 0u);
        } else {
            phi_232_ = array<u32, 2>((_e21 << bitcast<u32>(29i)), ((_e21 ^ _e22) | ((_e22 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e33 = phi_232_;
        phi_255_ = bitcast<f64>(((u64(_e33[1]) * 4294967296lu) + u64(_e33[0])));
    } else {
        if (_e10 == _e11) {
            phi_254_ = (f64(_e11) * 1.401298464324817e-45lf);
        } else {
            phi_254_ = -((f64(_e11) * 1.401298464324817e-45lf));
        }
        let _e20 = phi_254_;
        phi_255_ = _e20;
    }
    let _e42 = phi_255_;
    let _e44 = bitcast<u32>(param[1]);
    let _e45 = (_e44 & 2147483647u);
    if (_e45 >= 8388608u) {
        let _e55 = bitcast<u32>(param[1]);
        let _e56 = (_e55 & 2147483647u);
        if (_e56 < 8388608u) {
            phi_275_ = array<u32, 2>(0u, 0u);
        } else {
            phi_275_ = array<u32, 2>((_e55 << bitcast<u32>(29i)), ((_e55 ^ _e56) | ((_e56 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e67 = phi_275_;
        phi_298_ = bitcast<f64>(((u64(_e67[1]) * 4294967296lu) + u64(_e67[0])));
    } else {
        if (_e44 == _e45) {
            phi_297_ = (f64(_e45) * 1.401298464324817e-45lf);
        } else {
            phi_297_ = -((f64(_e45) * 1.401298464324817e-45lf));
        }
        let _e54 = phi_297_;
        phi_298_ = _e54;
    }
    let _e76 = phi_298_;
    let _e78 = bitcast<u32>(param[2]);
    let _e79 = (_e78 & 2147483647u);
    if (_e79 >= 8388608u) {
        let _e89 = bitcast<u32>(param[2]);
        let _e90 = (_e89 & 2147483647u);
        if (_e90 < 8388608u) {
            phi_318_ = array<u32, 2>(0u, 0u);
        } else {
            phi_318_ = array<u32, 2>((_e89 << bitcast<u32>(29i)), ((_e89 ^ _e90) | ((_e90 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e101 = phi_318_;
        phi_341_ = bitcast<f64>(((u64(_e101[1]) * 4294967296lu) + u64(_e101[0])));
    } else {
        if (_e78 == _e79) {
            phi_340_ = (f64(_e79) * 1.401298464324817e-45lf);
        } else {
            phi_340_ = -((f64(_e79) * 1.401298464324817e-45lf));
        }
        let _e88 = phi_340_;
        phi_341_ = _e88;
    }
    let _e110 = phi_341_;
    return array<f64, 3>(_e42, _e76, _e110);
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    var phi_899_: array<f64, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_899_ = param_2;
    } else {
        phi_899_ = param_1;
    }
    let _e26 = phi_899_;
    return _e26;
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_751_: f64;
    var phi_753_: f64;
    var phi_795_: f64;
    var phi_797_: f64;
    var phi_845_: f64;
    var phi_847_: f64;
    var phi_556_: f64;
    var phi_558_: f64;
    var phi_606_: f64;
    var phi_608_: f64;
    var phi_653_: f64;
    var phi_655_: f64;
    var phi_706_: f64;
    var phi_708_: f64;
    var phi_862_: array<array<f64, 3>, 4>;

    let _e9 = (param_3[0] - param_4[0]);
    let _e12 = (param_3[1] - param_4[1]);
    let _e15 = (param_3[2] - param_4[2]);
    if (param_6 != 0u) {
        let _e169 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e169 > f64(0f)) {
            if (_e169 < f64(1f)) {
                phi_556_ = _e169;
            } else {
                phi_556_ = f64(1f);
            }
            let _e177 = phi_556_;
            phi_558_ = _e177;
        } else {
            phi_558_ = f64(0f);
        }
        let _e179 = phi_558_;
        let _e215 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e215 > f64(0f)) {
            if (_e215 < f64(1f)) {
                phi_606_ = _e215;
            } else {
                phi_606_ = f64(1f);
            }
            let _e223 = phi_606_;
            phi_608_ = _e223;
        } else {
            phi_608_ = f64(0f);
        }
        let _e225 = phi_608_;
        let _e258 = ((((_e9 * param_5[0]) + (_e12 * param_5[1])) + (_e15 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e258 > f64(0f)) {
            if (_e258 < f64(1f)) {
                phi_653_ = _e258;
            } else {
                phi_653_ = f64(1f);
            }
            let _e266 = phi_653_;
            phi_655_ = _e266;
        } else {
            phi_655_ = f64(0f);
        }
        let _e268 = phi_655_;
        let _e281 = (param_3[0] - param_5[0]);
        let _e284 = (param_3[1] - param_5[1]);
        let _e287 = (param_3[2] - param_5[2]);
        let _e307 = ((((_e281 * param_4[0]) + (_e284 * param_4[1])) + (_e287 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e307 > f64(0f)) {
            if (_e307 < f64(1f)) {
                phi_706_ = _e307;
            } else {
                phi_706_ = f64(1f);
            }
            let _e315 = phi_706_;
            phi_708_ = _e315;
        } else {
            phi_708_ = f64(0f);
        }
        let _e317 = phi_708_;
        phi_862_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e179)), (param_3[1] - (param_4[1] * _e179)), (param_3[2] - (param_4[2] * _e179))), array<f64, 3>((param_3[0] - (param_5[0] * _e225)), (param_3[1] - (param_5[1] * _e225)), (param_3[2] - (param_5[2] * _e225))), array<f64, 3>((_e9 - (param_5[0] * _e268)), (_e12 - (param_5[1] * _e268)), (_e15 - (param_5[2] * _e268))), array<f64, 3>((_e281 - (param_4[0] * _e317)), (_e284 - (param_4[1] * _e317)), (_e287 - (param_4[2] * _e317))));
    } else {
        let _e19 = (param_5[0] - param_4[0]);
        let _e22 = (param_5[1] - param_4[1]);
        let _e25 = (param_5[2] - param_4[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > f64(0f)) {
            if (_e36 < f64(1f)) {
                phi_751_ = _e36;
            } else {
                phi_751_ = f64(1f);
            }
            let _e44 = phi_751_;
            phi_753_ = _e44;
        } else {
            phi_753_ = f64(0f);
        }
        let _e46 = phi_753_;
        let _e53 = array<f64, 3>((_e9 - (_e19 * _e46)), (_e12 - (_e22 * _e46)), (_e15 - (_e25 * _e46)));
        let _e76 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e76 > f64(0f)) {
            if (_e76 < f64(1f)) {
                phi_795_ = _e76;
            } else {
                phi_795_ = f64(1f);
            }
            let _e84 = phi_795_;
            phi_797_ = _e84;
        } else {
            phi_797_ = f64(0f);
        }
        let _e86 = phi_797_;
        let _e122 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e122 > f64(0f)) {
            if (_e122 < f64(1f)) {
                phi_845_ = _e122;
            } else {
                phi_845_ = f64(1f);
            }
            let _e130 = phi_845_;
            phi_847_ = _e130;
        } else {
            phi_847_ = f64(0f);
        }
        let _e132 = phi_847_;
        phi_862_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e86)), (param_3[1] - (param_4[1] * _e86)), (param_3[2] - (param_4[2] * _e86))), array<f64, 3>((param_3[0] - (param_5[0] * _e132)), (param_3[1] - (param_5[1] * _e132)), (param_3[2] - (param_5[2] * _e132))), _e53, _e53);
    }
    let _e330 = phi_862_;
    let _e333 = function_1(_e330[0], _e330[1]);
    let _e335 = function_1(_e333, _e330[2]);
    let _e337 = function_1(_e335, _e330[3]);
    return _e337;
}

fn function_3(param_7: array<f64, 3>, param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: u32) -> array<f64, 3> {
    var phi_453_: bool;
    var phi_454_: bool;
    var phi_455_: bool;
    var phi_456_: bool;
    var phi_460_: bool;
    var phi_433_: bool;
    var phi_434_: bool;
    var phi_435_: bool;
    var phi_436_: bool;
    var phi_437_: bool;
    var phi_438_: bool;
    var phi_442_: bool;
    var phi_461_: bool;
    var phi_495_: array<f64, 3>;
    var phi_496_: bool;
    var phi_497_: array<f64, 3>;
    var phi_498_: bool;
    var phi_503_: array<f64, 3>;

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
                    phi_433_ = (_e80 <= _e72);
                    phi_434_ = false;
                } else {
                    phi_433_ = bool();
                    phi_434_ = true;
                }
                let _e101 = phi_433_;
                let _e103 = phi_434_;
                phi_435_ = _e101;
                phi_436_ = _e103;
            } else {
                phi_435_ = bool();
                phi_436_ = true;
            }
            let _e105 = phi_435_;
            let _e107 = phi_436_;
            phi_437_ = _e105;
            phi_438_ = _e107;
        } else {
            phi_437_ = bool();
            phi_438_ = true;
        }
        let _e109 = phi_437_;
        let _e111 = phi_438_;
        if _e111 {
            phi_442_ = false;
        } else {
            phi_442_ = _e109;
        }
        let _e113 = phi_442_;
        phi_461_ = _e113;
    } else {
        if (_e76 >= _e71) {
            if (_e80 >= _e71) {
                phi_453_ = ((_e76 + _e80) <= _e72);
                phi_454_ = false;
            } else {
                phi_453_ = bool();
                phi_454_ = true;
            }
            let _e87 = phi_453_;
            let _e89 = phi_454_;
            phi_455_ = _e87;
            phi_456_ = _e89;
        } else {
            phi_455_ = bool();
            phi_456_ = true;
        }
        let _e91 = phi_455_;
        let _e93 = phi_456_;
        if _e93 {
            phi_460_ = false;
        } else {
            phi_460_ = _e91;
        }
        let _e95 = phi_460_;
        phi_461_ = _e95;
    }
    let _e115 = phi_461_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e115 {
            phi_495_ = array<f64, 3>((param_7[0] - ((param_8[0] * _e76) + (param_9[0] * _e80))), (param_7[1] - ((param_8[1] * _e76) + (param_9[1] * _e80))), (param_7[2] - ((param_8[2] * _e76) + (param_9[2] * _e80))));
            phi_496_ = false;
        } else {
            phi_495_ = array<f64, 3>();
            phi_496_ = true;
        }
        let _e144 = phi_495_;
        let _e146 = phi_496_;
        phi_497_ = _e144;
        phi_498_ = _e146;
    } else {
        phi_497_ = array<f64, 3>();
        phi_498_ = true;
    }
    let _e148 = phi_497_;
    let _e150 = phi_498_;
    if _e150 {
        let _e151 = function_2(param_7, param_8, param_9, param_10);
        phi_503_ = _e151;
    } else {
        phi_503_ = _e148;
    }
    let _e153 = phi_503_;
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
    var phi_966_: u32;
    var phi_976_: u32;
    var phi_983_: u32;
    var phi_999_: u32;
    var phi_1020_: u32;
    var phi_1021_: u32;
    var phi_1024_: type_12;
    var phi_1025_: type_12;
    var phi_1048_: type_12;
    var phi_1299_: type_33;
    var phi_1424_: f64;
    var phi_1430_: f64;
    var phi_1435_: f64;
    var phi_1441_: f64;
    var phi_1446_: f64;
    var phi_1452_: f64;
    var phi_1458_: f64;
    var phi_1463_: f64;
    var phi_1469_: f64;
    var phi_1474_: f64;
    var phi_1479_: f64;
    var phi_1486_: f64;
    var phi_1492_: f64;
    var phi_1497_: f64;
    var phi_1503_: f64;
    var phi_1508_: f64;
    var phi_1514_: f64;
    var phi_1520_: f64;
    var phi_1525_: f64;
    var phi_1531_: f64;
    var phi_1536_: f64;
    var phi_1541_: f64;
    var phi_1548_: f64;
    var phi_1554_: f64;
    var phi_1559_: f64;
    var phi_1565_: f64;
    var phi_1570_: f64;
    var phi_1576_: f64;
    var phi_1582_: f64;
    var phi_1587_: f64;
    var phi_1593_: f64;
    var phi_1598_: f64;
    var phi_1603_: f64;
    var phi_1609_: f64;
    var phi_1614_: f64;
    var phi_1623_: bool;
    var phi_1647_: u64;
    var phi_1659_: f64;
    var phi_1660_: f64;
    var phi_1694_: type_45;
    var phi_1695_: bool;
    var phi_1696_: type_45;
    var phi_1697_: bool;
    var phi_1698_: type_45;
    var phi_1699_: bool;
    var phi_1704_: type_45;
    var phi_8770_: f64;
    var phi_8777_: f64;
    var phi_8782_: f64;
    var phi_8789_: f64;
    var phi_8794_: f64;
    var phi_8807_: f64;
    var phi_8814_: f64;
    var phi_8819_: f64;
    var phi_8826_: f64;
    var phi_8831_: f64;
    var phi_8836_: f64;
    var phi_8853_: f64;
    var phi_8860_: f64;
    var phi_8865_: f64;
    var phi_8872_: f64;
    var phi_8877_: f64;
    var phi_8891_: f64;
    var phi_8898_: f64;
    var phi_8903_: f64;
    var phi_8910_: f64;
    var phi_8915_: f64;
    var phi_8920_: f64;
    var phi_8937_: f64;
    var phi_8944_: f64;
    var phi_8949_: f64;
    var phi_8956_: f64;
    var phi_8961_: f64;
    var phi_8975_: f64;
    var phi_8982_: f64;
    var phi_8987_: f64;
    var phi_8994_: f64;
    var phi_8999_: f64;
    var phi_9004_: f64;
    var phi_9041_: f64;
    var phi_9047_: f64;
    var phi_9054_: f64;
    var phi_9061_: f64;
    var phi_9067_: f64;
    var phi_9074_: f64;
    var phi_9080_: f64;
    var phi_9086_: f64;
    var phi_9092_: f64;
    var phi_9099_: f64;
    var phi_9106_: f64;
    var phi_9134_: f64;
    var phi_9139_: f64;
    var phi_9144_: f64;
    var phi_9149_: f64;
    var phi_9154_: f64;
    var phi_9159_: f64;
    var phi_9170_: f64;
    var phi_9184_: f64;
    var phi_9190_: f64;
    var phi_9195_: f64;
    var phi_9201_: f64;
    var phi_9207_: f64;
    var phi_9212_: f64;
    var phi_9217_: f64;
    var phi_9227_: bool;
    var phi_9234_: f64;
    var phi_9242_: f64;
    var phi_9250_: f64;
    var phi_9269_: f64;
    var phi_9418_: f64;
    var phi_9425_: f64;
    var phi_9430_: f64;
    var phi_9437_: f64;
    var phi_9442_: f64;
    var phi_9455_: f64;
    var phi_9462_: f64;
    var phi_9467_: f64;
    var phi_9474_: f64;
    var phi_9479_: f64;
    var phi_9484_: f64;
    var phi_9501_: f64;
    var phi_9508_: f64;
    var phi_9513_: f64;
    var phi_9520_: f64;
    var phi_9525_: f64;
    var phi_9539_: f64;
    var phi_9546_: f64;
    var phi_9551_: f64;
    var phi_9558_: f64;
    var phi_9563_: f64;
    var phi_9568_: f64;
    var phi_9585_: f64;
    var phi_9592_: f64;
    var phi_9597_: f64;
    var phi_9604_: f64;
    var phi_9609_: f64;
    var phi_9623_: f64;
    var phi_9630_: f64;
    var phi_9635_: f64;
    var phi_9642_: f64;
    var phi_9647_: f64;
    var phi_9652_: f64;
    var phi_9773_: f64;
    var phi_9780_: f64;
    var phi_9788_: f64;
    var phi_9834_: type_16;
    var phi_9837_: f64;
    var phi_9858_: bool;
    var phi_9864_: type_17;
    var phi_9835_: type_16;
    var phi_9878_: type_17;
    var phi_9838_: f64;
    var local_19: f64;
    var phi_9827_: f64;
    var phi_9891_: f64;
    var phi_9960_: f64;
    var phi_9966_: f64;
    var phi_9975_: f64;
    var phi_9981_: f64;
    var phi_9990_: f64;
    var phi_9996_: f64;
    var phi_10005_: f64;
    var phi_10011_: f64;
    var phi_10017_: type_38;
    var phi_10018_: bool;
    var phi_10019_: type_38;
    var phi_10020_: bool;
    var phi_10030_: type_38;
    var phi_10200_: bool;
    var phi_10201_: bool;
    var phi_10202_: bool;
    var phi_10203_: bool;
    var phi_10204_: bool;
    var phi_10205_: bool;
    var phi_10209_: bool;
    var phi_10237_: f64;
    var phi_10243_: f64;
    var phi_10250_: f64;
    var phi_10293_: type_16;
    var phi_10296_: f64;
    var phi_10317_: bool;
    var phi_10323_: type_17;
    var phi_10294_: type_16;
    var phi_10337_: type_17;
    var phi_10297_: f64;
    var local_20: f64;
    var phi_10286_: f64;
    var phi_10350_: f64;
    var phi_10419_: f64;
    var phi_10425_: f64;
    var phi_10434_: f64;
    var phi_10440_: f64;
    var phi_10449_: f64;
    var phi_10455_: f64;
    var phi_10464_: f64;
    var phi_10470_: f64;
    var phi_10476_: type_38;
    var phi_10477_: bool;
    var phi_10478_: type_38;
    var phi_10479_: bool;
    var phi_10489_: type_38;
    var phi_10659_: bool;
    var phi_10660_: bool;
    var phi_10661_: bool;
    var phi_10662_: bool;
    var phi_10663_: bool;
    var phi_10664_: bool;
    var phi_10668_: bool;
    var phi_10696_: f64;
    var phi_10702_: f64;
    var phi_10709_: f64;
    var phi_10752_: type_16;
    var phi_10755_: f64;
    var phi_10776_: bool;
    var phi_10782_: type_17;
    var phi_10753_: type_16;
    var phi_10796_: type_17;
    var phi_10756_: f64;
    var local_21: f64;
    var phi_10745_: f64;
    var phi_10809_: f64;
    var phi_10878_: f64;
    var phi_10884_: f64;
    var phi_10893_: f64;
    var phi_10899_: f64;
    var phi_10908_: f64;
    var phi_10914_: f64;
    var phi_10923_: f64;
    var phi_10929_: f64;
    var phi_10935_: type_38;
    var phi_10936_: bool;
    var phi_10937_: type_38;
    var phi_10938_: bool;
    var phi_10948_: type_38;
    var phi_11118_: bool;
    var phi_11119_: bool;
    var phi_11120_: bool;
    var phi_11121_: bool;
    var phi_11122_: bool;
    var phi_11123_: bool;
    var phi_11127_: bool;
    var phi_11155_: f64;
    var phi_11161_: f64;
    var phi_11168_: f64;
    var phi_11211_: type_16;
    var phi_11214_: f64;
    var phi_11235_: bool;
    var phi_11241_: type_17;
    var phi_11212_: type_16;
    var phi_11255_: type_17;
    var phi_11215_: f64;
    var local_22: f64;
    var phi_11204_: f64;
    var phi_11268_: f64;
    var phi_11337_: f64;
    var phi_11343_: f64;
    var phi_11352_: f64;
    var phi_11358_: f64;
    var phi_11367_: f64;
    var phi_11373_: f64;
    var phi_11382_: f64;
    var phi_11388_: f64;
    var phi_11394_: type_38;
    var phi_11395_: bool;
    var phi_11396_: type_38;
    var phi_11397_: bool;
    var phi_11407_: type_38;
    var phi_11577_: bool;
    var phi_11578_: bool;
    var phi_11579_: bool;
    var phi_11580_: bool;
    var phi_11581_: bool;
    var phi_11582_: bool;
    var phi_11586_: bool;
    var phi_11587_: bool;
    var phi_11588_: bool;
    var phi_11589_: bool;
    var phi_11590_: bool;
    var phi_11591_: bool;
    var phi_11595_: bool;
    var phi_11601_: type_46;
    var phi_11602_: bool;
    var phi_11603_: type_46;
    var phi_11604_: bool;
    var phi_11650_: type_16;
    var phi_11653_: f64;
    var phi_11674_: bool;
    var phi_11680_: type_17;
    var phi_11651_: type_16;
    var phi_11694_: type_17;
    var phi_11654_: f64;
    var local_23: f64;
    var phi_11643_: f64;
    var phi_11707_: f64;
    var phi_11713_: f64;
    var phi_11738_: type_12;
    var phi_11741_: u32;
    var phi_11739_: type_12;
    var phi_11764_: type_12;
    var phi_11808_: u32;
    var phi_11809_: u32;
    var phi_11742_: u32;
    var phi_11810_: u32;
    var phi_11830_: type_12;
    var phi_11831_: type_12;
    var phi_11854_: type_12;
    var phi_11873_: f64;
    var phi_11886_: f64;
    var phi_11922_: f64;
    var phi_11929_: f64;
    var phi_11941_: bool;
    var phi_11942_: bool;
    var phi_11943_: bool;
    var phi_11944_: bool;
    var phi_11948_: bool;
    var phi_11960_: type_49;
    var phi_11961_: type_49;
    var phi_11962_: bool;
    var phi_11963_: type_49;
    var phi_11964_: bool;
    var phi_11977_: f64;
    var phi_11989_: type_12;
    var phi_11992_: f64;
    var phi_11994_: f64;
    var phi_11996_: f64;
    var phi_11990_: type_12;
    var phi_12019_: type_12;
    var phi_12046_: f64;
    var phi_12047_: f64;
    var phi_12075_: f64;
    var phi_12091_: f64;
    var phi_12098_: bool;
    var phi_12099_: bool;
    var phi_12100_: bool;
    var phi_12106_: f64;
    var phi_12107_: f64;
    var phi_12108_: bool;
    var phi_11993_: f64;
    var phi_11995_: f64;
    var phi_11997_: f64;
    var phi_12109_: f64;
    var phi_12110_: bool;
    var phi_12111_: bool;
    var local_24: bool;
    var phi_12115_: f64;
    var phi_12116_: f64;
    var phi_12126_: f64;
    var phi_12130_: type_12;
    var phi_12133_: f64;
    var phi_12131_: type_12;
    var phi_12156_: type_12;
    var phi_12187_: f64;
    var phi_12188_: bool;
    var phi_12189_: f64;
    var phi_12190_: bool;
    var phi_12191_: bool;
    var phi_12192_: bool;
    var phi_12193_: f64;
    var phi_12134_: f64;
    var phi_12194_: bool;
    var phi_12195_: bool;
    var phi_12196_: bool;
    var phi_12197_: bool;
    var local_25: bool;
    var phi_12201_: bool;
    var phi_12202_: bool;
    var phi_12206_: bool;
    var phi_12210_: f64;
    var phi_12211_: f64;
    var phi_12213_: type_49;
    var phi_12244_: f64;
    var phi_12251_: f64;
    var phi_12256_: f64;
    var phi_12263_: f64;
    var phi_12268_: f64;
    var phi_12281_: f64;
    var phi_12288_: f64;
    var phi_12293_: f64;
    var phi_12300_: f64;
    var phi_12305_: f64;
    var phi_12310_: f64;
    var phi_12369_: f64;
    var phi_12375_: f64;
    var phi_12380_: f64;
    var phi_12386_: f64;
    var phi_12391_: f64;
    var phi_12405_: f64;
    var phi_12411_: f64;
    var phi_12416_: f64;
    var phi_12422_: f64;
    var phi_12427_: f64;
    var phi_12453_: f64;
    var phi_12460_: f64;
    var phi_12465_: f64;
    var phi_12472_: f64;
    var phi_12477_: f64;
    var phi_12490_: f64;
    var phi_12497_: f64;
    var phi_12502_: f64;
    var phi_12509_: f64;
    var phi_12514_: f64;
    var phi_12519_: f64;
    var phi_12578_: f64;
    var phi_12584_: f64;
    var phi_12589_: f64;
    var phi_12595_: f64;
    var phi_12600_: f64;
    var phi_12614_: f64;
    var phi_12620_: f64;
    var phi_12625_: f64;
    var phi_12631_: f64;
    var phi_12636_: f64;
    var phi_12662_: f64;
    var phi_12669_: f64;
    var phi_12674_: f64;
    var phi_12681_: f64;
    var phi_12686_: f64;
    var phi_12699_: f64;
    var phi_12706_: f64;
    var phi_12711_: f64;
    var phi_12718_: f64;
    var phi_12723_: f64;
    var phi_12728_: f64;
    var phi_12787_: f64;
    var phi_12793_: f64;
    var phi_12798_: f64;
    var phi_12804_: f64;
    var phi_12809_: f64;
    var phi_12823_: f64;
    var phi_12829_: f64;
    var phi_12834_: f64;
    var phi_12840_: f64;
    var phi_12845_: f64;
    var phi_12894_: f64;
    var phi_12900_: f64;
    var phi_12928_: f64;
    var phi_12934_: f64;
    var phi_12939_: u32;
    var phi_12940_: u32;
    var phi_12910_: f64;
    var phi_12916_: f64;
    var phi_12921_: u32;
    var phi_12922_: u32;
    var phi_12941_: u32;
    var phi_12942_: u32;
    var phi_13015_: f64;
    var phi_13027_: f64;
    var phi_13170_: f64;
    var phi_13176_: f64;
    var phi_13183_: f64;
    var phi_13239_: type_12;
    var phi_13242_: bool;
    var phi_13240_: type_12;
    var phi_13265_: type_12;
    var phi_13292_: bool;
    var phi_13293_: bool;
    var phi_13243_: bool;
    var phi_13294_: bool;
    var phi_13295_: bool;
    var local_26: bool;
    var phi_13299_: bool;
    var local_27: bool;
    var phi_13306_: u32;
    var phi_13307_: u32;
    var phi_13308_: bool;
    var phi_13309_: u32;
    var phi_13310_: u32;
    var phi_13311_: bool;
    var phi_13315_: u32;
    var phi_13325_: bool;
    var phi_13338_: bool;
    var phi_13339_: bool;
    var phi_13487_: f64;
    var phi_13494_: f64;
    var phi_13499_: f64;
    var phi_13506_: f64;
    var phi_13511_: f64;
    var phi_13524_: f64;
    var phi_13531_: f64;
    var phi_13536_: f64;
    var phi_13543_: f64;
    var phi_13548_: f64;
    var phi_13553_: f64;
    var phi_13570_: f64;
    var phi_13577_: f64;
    var phi_13582_: f64;
    var phi_13589_: f64;
    var phi_13594_: f64;
    var phi_13608_: f64;
    var phi_13615_: f64;
    var phi_13620_: f64;
    var phi_13627_: f64;
    var phi_13632_: f64;
    var phi_13637_: f64;
    var phi_13654_: f64;
    var phi_13661_: f64;
    var phi_13666_: f64;
    var phi_13673_: f64;
    var phi_13678_: f64;
    var phi_13692_: f64;
    var phi_13699_: f64;
    var phi_13704_: f64;
    var phi_13711_: f64;
    var phi_13716_: f64;
    var phi_13721_: f64;
    var phi_13768_: type_12;
    var phi_13771_: f64;
    var phi_13773_: f64;
    var phi_13775_: f64;
    var phi_13777_: f64;
    var phi_13779_: bool;
    var phi_13781_: u32;
    var phi_13769_: type_12;
    var phi_13804_: type_12;
    var phi_13919_: f64;
    var phi_13925_: f64;
    var phi_13931_: f64;
    var phi_13933_: array<f64, 3>;
    var phi_13940_: f64;
    var phi_13947_: f64;
    var phi_13955_: f64;
    var phi_14001_: type_16;
    var phi_14004_: f64;
    var phi_14025_: bool;
    var phi_14031_: type_17;
    var phi_14002_: type_16;
    var phi_14045_: type_17;
    var phi_14005_: f64;
    var local_28: f64;
    var phi_13994_: f64;
    var phi_14058_: f64;
    var phi_14127_: f64;
    var phi_14133_: f64;
    var phi_14142_: f64;
    var phi_14148_: f64;
    var phi_14157_: f64;
    var phi_14163_: f64;
    var phi_14172_: f64;
    var phi_14178_: f64;
    var phi_14184_: type_38;
    var phi_14185_: bool;
    var phi_14186_: type_38;
    var phi_14187_: bool;
    var phi_14197_: type_38;
    var phi_14369_: bool;
    var phi_14370_: bool;
    var phi_14371_: bool;
    var phi_14372_: bool;
    var phi_14373_: bool;
    var phi_14374_: bool;
    var phi_14378_: bool;
    var phi_14676_: bool;
    var phi_14677_: bool;
    var phi_14678_: bool;
    var phi_14679_: bool;
    var phi_14680_: bool;
    var phi_14681_: bool;
    var phi_14685_: bool;
    var phi_14689_: bool;
    var phi_14700_: bool;
    var phi_14701_: bool;
    var phi_14775_: bool;
    var phi_14776_: bool;
    var phi_14799_: f64;
    var phi_14800_: bool;
    var phi_14801_: f64;
    var phi_14802_: bool;
    var phi_14803_: f64;
    var phi_14804_: bool;
    var phi_14805_: bool;
    var phi_14810_: f64;
    var phi_14811_: bool;
    var phi_14815_: f64;
    var phi_14847_: bool;
    var phi_14848_: bool;
    var phi_14871_: f64;
    var phi_14872_: bool;
    var phi_14873_: f64;
    var phi_14874_: bool;
    var phi_14875_: f64;
    var phi_14876_: bool;
    var phi_14877_: bool;
    var phi_14882_: f64;
    var phi_14883_: bool;
    var phi_14887_: f64;
    var phi_14892_: f64;
    var phi_14924_: bool;
    var phi_14925_: bool;
    var phi_14948_: f64;
    var phi_14949_: bool;
    var phi_14950_: f64;
    var phi_14951_: bool;
    var phi_14952_: f64;
    var phi_14953_: bool;
    var phi_14954_: bool;
    var phi_14959_: f64;
    var phi_14960_: bool;
    var phi_14964_: f64;
    var phi_14996_: bool;
    var phi_14997_: bool;
    var phi_15020_: f64;
    var phi_15021_: bool;
    var phi_15022_: f64;
    var phi_15023_: bool;
    var phi_15024_: f64;
    var phi_15025_: bool;
    var phi_15026_: bool;
    var phi_15031_: f64;
    var phi_15032_: bool;
    var phi_15036_: f64;
    var phi_15041_: f64;
    var phi_15046_: f64;
    var phi_15051_: f64;
    var phi_15065_: f64;
    var phi_15203_: type_16;
    var phi_15206_: f64;
    var phi_15227_: bool;
    var phi_15233_: type_17;
    var phi_15204_: type_16;
    var phi_15247_: type_17;
    var phi_15207_: f64;
    var local_29: f64;
    var phi_15196_: f64;
    var phi_15260_: f64;
    var phi_15278_: f64;
    var phi_15285_: f64;
    var phi_15290_: f64;
    var phi_15297_: f64;
    var phi_15302_: f64;
    var phi_15315_: f64;
    var phi_15322_: f64;
    var phi_15327_: f64;
    var phi_15334_: f64;
    var phi_15339_: f64;
    var phi_15344_: f64;
    var phi_15361_: f64;
    var phi_15368_: f64;
    var phi_15373_: f64;
    var phi_15380_: f64;
    var phi_15385_: f64;
    var phi_15399_: f64;
    var phi_15406_: f64;
    var phi_15411_: f64;
    var phi_15418_: f64;
    var phi_15423_: f64;
    var phi_15428_: f64;
    var phi_15445_: f64;
    var phi_15452_: f64;
    var phi_15457_: f64;
    var phi_15464_: f64;
    var phi_15469_: f64;
    var phi_15483_: f64;
    var phi_15490_: f64;
    var phi_15495_: f64;
    var phi_15502_: f64;
    var phi_15507_: f64;
    var phi_15512_: f64;
    var phi_15536_: bool;
    var phi_15537_: bool;
    var phi_15538_: bool;
    var phi_15555_: f64;
    var phi_15556_: bool;
    var phi_15557_: f64;
    var phi_15558_: bool;
    var phi_15563_: f64;
    var phi_15565_: f64;
    var phi_15566_: f64;
    var phi_15567_: bool;
    var phi_15568_: f64;
    var phi_15569_: f64;
    var phi_15570_: bool;
    var phi_15571_: bool;
    var phi_15572_: f64;
    var phi_15573_: f64;
    var phi_15574_: f64;
    var phi_15575_: f64;
    var phi_15576_: bool;
    var phi_15577_: bool;
    var phi_15578_: bool;
    var phi_15579_: bool;
    var phi_15580_: f64;
    var phi_15581_: f64;
    var phi_15582_: f64;
    var phi_15583_: f64;
    var phi_15584_: bool;
    var phi_15585_: bool;
    var phi_15586_: bool;
    var phi_15587_: bool;
    var phi_15588_: bool;
    var phi_15589_: f64;
    var phi_15590_: f64;
    var phi_15591_: f64;
    var phi_15592_: f64;
    var phi_15593_: bool;
    var phi_15594_: bool;
    var phi_15595_: bool;
    var phi_15596_: bool;
    var phi_15597_: bool;
    var phi_15683_: f64;
    var phi_15756_: f64;
    var phi_15761_: f64;
    var phi_15834_: f64;
    var phi_15907_: f64;
    var phi_15912_: f64;
    var phi_15933_: f64;
    var phi_15934_: f64;
    var phi_15935_: f64;
    var phi_15610_: bool;
    var phi_15937_: u32;
    var phi_15938_: f64;
    var phi_15939_: bool;
    var phi_15940_: bool;
    var phi_15941_: bool;
    var phi_15942_: u32;
    var phi_15943_: f64;
    var phi_15944_: f64;
    var phi_15945_: f64;
    var phi_15946_: f64;
    var phi_15947_: bool;
    var phi_15948_: u32;
    var phi_15949_: bool;
    var phi_15950_: bool;
    var phi_15951_: bool;
    var phi_15952_: bool;
    var phi_15953_: bool;
    var phi_15954_: bool;
    var phi_15963_: f64;
    var phi_15968_: f64;
    var phi_15977_: bool;
    var phi_15981_: bool;
    var phi_15982_: f64;
    var phi_15983_: f64;
    var phi_15984_: f64;
    var phi_15985_: f64;
    var phi_15986_: bool;
    var phi_15987_: u32;
    var phi_15988_: bool;
    var phi_15989_: bool;
    var phi_15990_: bool;
    var phi_15991_: bool;
    var phi_15992_: bool;
    var phi_15993_: bool;
    var phi_13772_: f64;
    var phi_13774_: f64;
    var phi_13776_: f64;
    var phi_13778_: f64;
    var phi_13780_: bool;
    var phi_13782_: u32;
    var phi_15994_: f64;
    var phi_15995_: f64;
    var phi_15996_: bool;
    var phi_15997_: bool;
    var phi_15998_: bool;
    var phi_15999_: bool;
    var phi_16000_: bool;
    var phi_16001_: bool;
    var phi_16002_: bool;
    var local_30: bool;
    var phi_16006_: bool;
    var phi_16007_: bool;
    var phi_16008_: bool;
    var phi_16009_: bool;
    var phi_16010_: bool;
    var local_31: f64;
    var phi_16015_: type_46;
    var phi_16016_: bool;
    var phi_16017_: bool;
    var phi_16018_: bool;
    var phi_16019_: bool;
    var phi_16020_: bool;
    var phi_16025_: type_46;
    var phi_16026_: bool;
    var phi_16027_: bool;
    var phi_16028_: bool;
    var phi_16029_: bool;
    var phi_16030_: bool;
    var phi_16034_: f64;
    var phi_16035_: bool;
    var phi_16036_: bool;
    var phi_16037_: bool;
    var phi_16038_: bool;
    var phi_16042_: f64;
    var phi_16043_: bool;
    var phi_16044_: bool;
    var phi_16045_: bool;
    var phi_16050_: type_46;
    var phi_16051_: bool;
    var phi_16052_: bool;
    var phi_16057_: type_46;
    var phi_16058_: bool;
    var phi_16062_: type_46;
    var phi_16069_: bool;
    var phi_16070_: f64;
    var phi_16071_: bool;
    var phi_16072_: bool;
    var phi_16073_: bool;
    var phi_16074_: bool;
    var phi_16075_: f64;
    var phi_16076_: f64;
    var phi_16077_: bool;
    var phi_16078_: bool;
    var phi_16079_: bool;
    var phi_16080_: bool;
    var phi_16081_: f64;
    var phi_16082_: f64;
    var phi_16083_: bool;
    var phi_16084_: bool;
    var phi_16085_: bool;
    var phi_16086_: bool;
    var phi_16090_: bool;
    var phi_16091_: bool;
    var phi_16092_: bool;
    var phi_16093_: type_49;
    var phi_16094_: bool;
    var phi_16095_: f64;
    var phi_16096_: f64;
    var phi_16097_: type_49;
    var phi_16098_: bool;
    var phi_16099_: bool;
    var phi_16100_: bool;
    var phi_16101_: bool;
    var phi_16105_: bool;
    var phi_16106_: bool;
    var phi_16107_: bool;
    var phi_16108_: type_49;
    var phi_16109_: bool;
    var phi_16110_: f64;
    var phi_16111_: f64;
    var phi_16112_: type_49;
    var phi_16113_: bool;
    var phi_16114_: bool;
    var phi_16115_: bool;
    var phi_16116_: bool;
    var local_32: bool;
    var phi_16121_: type_46;
    var phi_16122_: bool;
    var phi_16123_: bool;
    var local_33: bool;
    var local_34: type_49;
    var local_35: f64;
    var local_36: f64;
    var local_37: f64;
    var phi_16137_: type_46;
    var phi_16138_: bool;
    var phi_16139_: type_46;
    var phi_16140_: bool;
    var local_38: f64;
    var phi_16145_: type_46;
    var phi_16146_: type_46;
    var phi_16147_: bool;
    var local_39: type_49;
    var phi_16153_: type_46;
    var phi_16154_: bool;
    var phi_16158_: type_46;
    var phi_16159_: type_46;
    var phi_16160_: bool;
    var phi_16164_: type_46;
    var phi_16165_: type_46;
    var phi_16166_: bool;
    var phi_16170_: type_46;
    var phi_16181_: bool;
    var phi_16182_: bool;
    var phi_16186_: bool;
    var phi_16190_: u32;
    var phi_1879_: type_16;
    var phi_1882_: f64;
    var phi_1903_: bool;
    var phi_1909_: type_17;
    var phi_1880_: type_16;
    var phi_1923_: type_17;
    var phi_1883_: f64;
    var local_40: f64;
    var phi_1872_: f64;
    var phi_1936_: f64;
    var phi_1954_: f64;
    var phi_1961_: f64;
    var phi_1966_: f64;
    var phi_1973_: f64;
    var phi_1978_: f64;
    var phi_1991_: f64;
    var phi_1998_: f64;
    var phi_2003_: f64;
    var phi_2010_: f64;
    var phi_2015_: f64;
    var phi_2020_: f64;
    var phi_2037_: f64;
    var phi_2044_: f64;
    var phi_2049_: f64;
    var phi_2056_: f64;
    var phi_2061_: f64;
    var phi_2075_: f64;
    var phi_2082_: f64;
    var phi_2087_: f64;
    var phi_2094_: f64;
    var phi_2099_: f64;
    var phi_2104_: f64;
    var phi_2121_: f64;
    var phi_2128_: f64;
    var phi_2133_: f64;
    var phi_2140_: f64;
    var phi_2145_: f64;
    var phi_2159_: f64;
    var phi_2166_: f64;
    var phi_2171_: f64;
    var phi_2178_: f64;
    var phi_2183_: f64;
    var phi_2188_: f64;
    var phi_2453_: f64;
    var phi_2460_: f64;
    var phi_2465_: f64;
    var phi_2472_: f64;
    var phi_2477_: f64;
    var phi_2490_: f64;
    var phi_2497_: f64;
    var phi_2502_: f64;
    var phi_2509_: f64;
    var phi_2514_: f64;
    var phi_2519_: f64;
    var phi_2536_: f64;
    var phi_2543_: f64;
    var phi_2548_: f64;
    var phi_2555_: f64;
    var phi_2560_: f64;
    var phi_2574_: f64;
    var phi_2581_: f64;
    var phi_2586_: f64;
    var phi_2593_: f64;
    var phi_2598_: f64;
    var phi_2603_: f64;
    var phi_2620_: f64;
    var phi_2627_: f64;
    var phi_2632_: f64;
    var phi_2639_: f64;
    var phi_2644_: f64;
    var phi_2658_: f64;
    var phi_2665_: f64;
    var phi_2670_: f64;
    var phi_2677_: f64;
    var phi_2682_: f64;
    var phi_2687_: f64;
    var phi_2724_: f64;
    var phi_2730_: f64;
    var phi_2737_: f64;
    var phi_2744_: f64;
    var phi_2750_: f64;
    var phi_2757_: f64;
    var phi_2763_: f64;
    var phi_2769_: f64;
    var phi_2775_: f64;
    var phi_2782_: f64;
    var phi_2789_: f64;
    var phi_2817_: f64;
    var phi_2822_: f64;
    var phi_2827_: f64;
    var phi_2832_: f64;
    var phi_2837_: f64;
    var phi_2842_: f64;
    var phi_2853_: f64;
    var phi_2863_: type_47;
    var phi_2864_: bool;
    var phi_2865_: type_47;
    var phi_2866_: bool;
    var phi_2872_: type_16;
    var phi_2875_: f64;
    var phi_2877_: u32;
    var phi_2879_: f64;
    var phi_2900_: bool;
    var phi_2906_: type_17;
    var phi_2873_: type_16;
    var phi_2920_: type_17;
    var phi_2935_: bool;
    var phi_2936_: bool;
    var phi_3082_: f64;
    var phi_3089_: f64;
    var phi_3094_: f64;
    var phi_3101_: f64;
    var phi_3106_: f64;
    var phi_3119_: f64;
    var phi_3126_: f64;
    var phi_3131_: f64;
    var phi_3138_: f64;
    var phi_3143_: f64;
    var phi_3148_: f64;
    var phi_3165_: f64;
    var phi_3172_: f64;
    var phi_3177_: f64;
    var phi_3184_: f64;
    var phi_3189_: f64;
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
    var phi_3363_: type_12;
    var phi_3366_: f64;
    var phi_3368_: f64;
    var phi_3370_: f64;
    var phi_3372_: f64;
    var phi_3374_: bool;
    var phi_3376_: u32;
    var phi_3364_: type_12;
    var phi_3399_: type_12;
    var phi_3514_: f64;
    var phi_3520_: f64;
    var phi_3526_: f64;
    var phi_3528_: array<f64, 3>;
    var phi_3535_: f64;
    var phi_3542_: f64;
    var phi_3550_: f64;
    var phi_3596_: type_16;
    var phi_3599_: f64;
    var phi_3620_: bool;
    var phi_3626_: type_17;
    var phi_3597_: type_16;
    var phi_3640_: type_17;
    var phi_3600_: f64;
    var local_41: f64;
    var phi_3589_: f64;
    var phi_3653_: f64;
    var phi_3722_: f64;
    var phi_3728_: f64;
    var phi_3737_: f64;
    var phi_3743_: f64;
    var phi_3752_: f64;
    var phi_3758_: f64;
    var phi_3767_: f64;
    var phi_3773_: f64;
    var phi_3779_: type_38;
    var phi_3780_: bool;
    var phi_3781_: type_38;
    var phi_3782_: bool;
    var phi_3792_: type_38;
    var phi_3964_: bool;
    var phi_3965_: bool;
    var phi_3966_: bool;
    var phi_3967_: bool;
    var phi_3968_: bool;
    var phi_3969_: bool;
    var phi_3973_: bool;
    var phi_4271_: bool;
    var phi_4272_: bool;
    var phi_4273_: bool;
    var phi_4274_: bool;
    var phi_4275_: bool;
    var phi_4276_: bool;
    var phi_4280_: bool;
    var phi_4284_: bool;
    var phi_4295_: bool;
    var phi_4296_: bool;
    var phi_4370_: bool;
    var phi_4371_: bool;
    var phi_4394_: f64;
    var phi_4395_: bool;
    var phi_4396_: f64;
    var phi_4397_: bool;
    var phi_4398_: f64;
    var phi_4399_: bool;
    var phi_4400_: bool;
    var phi_4405_: f64;
    var phi_4406_: bool;
    var phi_4410_: f64;
    var phi_4442_: bool;
    var phi_4443_: bool;
    var phi_4466_: f64;
    var phi_4467_: bool;
    var phi_4468_: f64;
    var phi_4469_: bool;
    var phi_4470_: f64;
    var phi_4471_: bool;
    var phi_4472_: bool;
    var phi_4477_: f64;
    var phi_4478_: bool;
    var phi_4482_: f64;
    var phi_4487_: f64;
    var phi_4519_: bool;
    var phi_4520_: bool;
    var phi_4543_: f64;
    var phi_4544_: bool;
    var phi_4545_: f64;
    var phi_4546_: bool;
    var phi_4547_: f64;
    var phi_4548_: bool;
    var phi_4549_: bool;
    var phi_4554_: f64;
    var phi_4555_: bool;
    var phi_4559_: f64;
    var phi_4591_: bool;
    var phi_4592_: bool;
    var phi_4615_: f64;
    var phi_4616_: bool;
    var phi_4617_: f64;
    var phi_4618_: bool;
    var phi_4619_: f64;
    var phi_4620_: bool;
    var phi_4621_: bool;
    var phi_4626_: f64;
    var phi_4627_: bool;
    var phi_4631_: f64;
    var phi_4636_: f64;
    var phi_4641_: f64;
    var phi_4646_: f64;
    var phi_4660_: f64;
    var phi_4798_: type_16;
    var phi_4801_: f64;
    var phi_4822_: bool;
    var phi_4828_: type_17;
    var phi_4799_: type_16;
    var phi_4842_: type_17;
    var phi_4802_: f64;
    var local_42: f64;
    var phi_4791_: f64;
    var phi_4855_: f64;
    var phi_4873_: f64;
    var phi_4880_: f64;
    var phi_4885_: f64;
    var phi_4892_: f64;
    var phi_4897_: f64;
    var phi_4910_: f64;
    var phi_4917_: f64;
    var phi_4922_: f64;
    var phi_4929_: f64;
    var phi_4934_: f64;
    var phi_4939_: f64;
    var phi_4956_: f64;
    var phi_4963_: f64;
    var phi_4968_: f64;
    var phi_4975_: f64;
    var phi_4980_: f64;
    var phi_4994_: f64;
    var phi_5001_: f64;
    var phi_5006_: f64;
    var phi_5013_: f64;
    var phi_5018_: f64;
    var phi_5023_: f64;
    var phi_5040_: f64;
    var phi_5047_: f64;
    var phi_5052_: f64;
    var phi_5059_: f64;
    var phi_5064_: f64;
    var phi_5078_: f64;
    var phi_5085_: f64;
    var phi_5090_: f64;
    var phi_5097_: f64;
    var phi_5102_: f64;
    var phi_5107_: f64;
    var phi_5131_: bool;
    var phi_5132_: bool;
    var phi_5133_: bool;
    var phi_5150_: f64;
    var phi_5151_: bool;
    var phi_5152_: f64;
    var phi_5153_: bool;
    var phi_5158_: f64;
    var phi_5160_: f64;
    var phi_5161_: f64;
    var phi_5162_: bool;
    var phi_5163_: f64;
    var phi_5164_: f64;
    var phi_5165_: bool;
    var phi_5166_: bool;
    var phi_5167_: f64;
    var phi_5168_: f64;
    var phi_5169_: f64;
    var phi_5170_: f64;
    var phi_5171_: bool;
    var phi_5172_: bool;
    var phi_5173_: bool;
    var phi_5174_: bool;
    var phi_5175_: f64;
    var phi_5176_: f64;
    var phi_5177_: f64;
    var phi_5178_: f64;
    var phi_5179_: bool;
    var phi_5180_: bool;
    var phi_5181_: bool;
    var phi_5182_: bool;
    var phi_5183_: bool;
    var phi_5184_: f64;
    var phi_5185_: f64;
    var phi_5186_: f64;
    var phi_5187_: f64;
    var phi_5188_: bool;
    var phi_5189_: bool;
    var phi_5190_: bool;
    var phi_5191_: bool;
    var phi_5192_: bool;
    var phi_5278_: f64;
    var phi_5351_: f64;
    var phi_5356_: f64;
    var phi_5429_: f64;
    var phi_5502_: f64;
    var phi_5507_: f64;
    var phi_5528_: f64;
    var phi_5529_: f64;
    var phi_5530_: f64;
    var phi_5205_: bool;
    var phi_5532_: u32;
    var phi_5533_: f64;
    var phi_5534_: bool;
    var phi_5535_: bool;
    var phi_5536_: bool;
    var phi_5537_: u32;
    var phi_5538_: f64;
    var phi_5539_: f64;
    var phi_5540_: f64;
    var phi_5541_: f64;
    var phi_5542_: bool;
    var phi_5543_: u32;
    var phi_5544_: bool;
    var phi_5545_: bool;
    var phi_5546_: bool;
    var phi_5547_: bool;
    var phi_5548_: bool;
    var phi_5549_: bool;
    var phi_5558_: f64;
    var phi_5563_: f64;
    var phi_5572_: bool;
    var phi_5576_: bool;
    var phi_5577_: f64;
    var phi_5578_: f64;
    var phi_5579_: f64;
    var phi_5580_: f64;
    var phi_5581_: bool;
    var phi_5582_: u32;
    var phi_5583_: bool;
    var phi_5584_: bool;
    var phi_5585_: bool;
    var phi_5586_: bool;
    var phi_5587_: bool;
    var phi_5588_: bool;
    var phi_3367_: f64;
    var phi_3369_: f64;
    var phi_3371_: f64;
    var phi_3373_: f64;
    var phi_3375_: bool;
    var phi_3377_: u32;
    var phi_5589_: f64;
    var phi_5590_: f64;
    var phi_5591_: bool;
    var phi_5592_: bool;
    var phi_5593_: bool;
    var phi_5594_: bool;
    var phi_5595_: bool;
    var phi_5596_: bool;
    var phi_5597_: bool;
    var local_43: bool;
    var phi_5601_: bool;
    var phi_5602_: bool;
    var phi_5603_: bool;
    var phi_5604_: bool;
    var phi_5605_: bool;
    var local_44: f64;
    var phi_5610_: type_46;
    var phi_5611_: bool;
    var phi_5612_: bool;
    var phi_5613_: bool;
    var phi_5614_: bool;
    var phi_5615_: bool;
    var phi_5620_: type_46;
    var phi_5621_: bool;
    var phi_5622_: bool;
    var phi_5623_: bool;
    var phi_5624_: bool;
    var phi_5625_: bool;
    var phi_5629_: f64;
    var phi_5630_: bool;
    var phi_5631_: bool;
    var phi_5632_: bool;
    var phi_5633_: bool;
    var phi_5637_: f64;
    var phi_5638_: bool;
    var phi_5639_: bool;
    var phi_5640_: bool;
    var phi_5645_: type_46;
    var phi_5646_: bool;
    var phi_5647_: bool;
    var phi_5652_: type_46;
    var phi_5653_: bool;
    var phi_5657_: type_46;
    var phi_5664_: f64;
    var phi_5665_: bool;
    var phi_5778_: f64;
    var phi_5785_: f64;
    var phi_5793_: f64;
    var phi_5944_: f64;
    var phi_5951_: f64;
    var phi_5956_: f64;
    var phi_5963_: f64;
    var phi_5968_: f64;
    var phi_5981_: f64;
    var phi_5988_: f64;
    var phi_5993_: f64;
    var phi_6000_: f64;
    var phi_6005_: f64;
    var phi_6010_: f64;
    var phi_6027_: f64;
    var phi_6034_: f64;
    var phi_6039_: f64;
    var phi_6046_: f64;
    var phi_6051_: f64;
    var phi_6065_: f64;
    var phi_6072_: f64;
    var phi_6077_: f64;
    var phi_6084_: f64;
    var phi_6089_: f64;
    var phi_6094_: f64;
    var phi_6111_: f64;
    var phi_6118_: f64;
    var phi_6123_: f64;
    var phi_6130_: f64;
    var phi_6135_: f64;
    var phi_6149_: f64;
    var phi_6156_: f64;
    var phi_6161_: f64;
    var phi_6168_: f64;
    var phi_6173_: f64;
    var phi_6178_: f64;
    var phi_6290_: type_16;
    var phi_6293_: f64;
    var phi_6314_: bool;
    var phi_6320_: type_17;
    var phi_6291_: type_16;
    var phi_6334_: type_17;
    var phi_6294_: f64;
    var local_45: f64;
    var phi_6283_: f64;
    var phi_6347_: f64;
    var phi_6484_: f64;
    var phi_6490_: f64;
    var phi_6499_: f64;
    var phi_6505_: f64;
    var phi_6514_: f64;
    var phi_6520_: f64;
    var phi_6529_: f64;
    var phi_6535_: f64;
    var phi_6585_: type_16;
    var phi_6588_: f64;
    var phi_6609_: bool;
    var phi_6615_: type_17;
    var phi_6586_: type_16;
    var phi_6629_: type_17;
    var phi_6589_: f64;
    var local_46: f64;
    var phi_6578_: f64;
    var phi_6642_: f64;
    var phi_6674_: type_16;
    var phi_6677_: f64;
    var phi_6698_: bool;
    var phi_6704_: type_17;
    var phi_6675_: type_16;
    var phi_6718_: type_17;
    var phi_6678_: f64;
    var local_47: f64;
    var phi_6667_: f64;
    var phi_6731_: f64;
    var phi_6749_: f64;
    var phi_6756_: f64;
    var phi_6761_: f64;
    var phi_6768_: f64;
    var phi_6773_: f64;
    var phi_6786_: f64;
    var phi_6793_: f64;
    var phi_6798_: f64;
    var phi_6805_: f64;
    var phi_6810_: f64;
    var phi_6815_: f64;
    var phi_6832_: f64;
    var phi_6839_: f64;
    var phi_6844_: f64;
    var phi_6851_: f64;
    var phi_6856_: f64;
    var phi_6870_: f64;
    var phi_6877_: f64;
    var phi_6882_: f64;
    var phi_6889_: f64;
    var phi_6894_: f64;
    var phi_6899_: f64;
    var phi_6916_: f64;
    var phi_6923_: f64;
    var phi_6928_: f64;
    var phi_6935_: f64;
    var phi_6940_: f64;
    var phi_6954_: f64;
    var phi_6961_: f64;
    var phi_6966_: f64;
    var phi_6973_: f64;
    var phi_6978_: f64;
    var phi_6983_: f64;
    var phi_7031_: f64;
    var phi_7037_: f64;
    var phi_7049_: type_12;
    var phi_7052_: f64;
    var phi_7050_: type_12;
    var phi_7075_: type_12;
    var phi_7105_: f64;
    var phi_7111_: f64;
    var phi_7125_: f64;
    var phi_7053_: f64;
    var local_48: f64;
    var local_49: f64;
    var phi_7154_: type_16;
    var phi_7157_: f64;
    var phi_7178_: bool;
    var phi_7184_: type_17;
    var phi_7155_: type_16;
    var phi_7198_: type_17;
    var phi_7158_: f64;
    var local_50: f64;
    var phi_7147_: f64;
    var phi_7211_: f64;
    var phi_7218_: type_12;
    var phi_7221_: f64;
    var phi_7223_: bool;
    var phi_7225_: bool;
    var phi_7219_: type_12;
    var phi_7248_: type_12;
    var phi_7285_: f64;
    var phi_7292_: f64;
    var phi_7300_: f64;
    var phi_7308_: f64;
    var phi_7315_: f64;
    var phi_7323_: f64;
    var phi_7329_: f64;
    var phi_7349_: f64;
    var phi_7355_: f64;
    var phi_7362_: f64;
    var phi_7391_: f64;
    var phi_7397_: f64;
    var phi_7434_: bool;
    var phi_7441_: bool;
    var phi_7454_: f64;
    var phi_7460_: f64;
    var phi_7461_: f64;
    var phi_7462_: f64;
    var phi_7222_: f64;
    var phi_7224_: bool;
    var phi_7226_: bool;
    var local_51: f64;
    var phi_7468_: f64;
    var local_52: bool;
    var local_53: bool;
    var phi_7479_: type_48;
    var phi_7480_: type_48;
    var phi_7481_: bool;
    var local_54: bool;
    var phi_7499_: f64;
    var phi_7500_: f64;
    var phi_7503_: type_12;
    var phi_7506_: f64;
    var phi_7508_: f64;
    var phi_7504_: type_12;
    var phi_7531_: type_12;
    var phi_7617_: f64;
    var phi_7618_: f64;
    var phi_7619_: f64;
    var phi_7600_: f64;
    var phi_7620_: f64;
    var phi_7621_: f64;
    var phi_7507_: f64;
    var phi_7509_: f64;
    var local_55: f64;
    var local_56: f64;
    var local_57: f64;
    var phi_7784_: bool;
    var phi_7785_: bool;
    var phi_7786_: bool;
    var phi_7787_: bool;
    var phi_7788_: bool;
    var phi_7789_: bool;
    var phi_7793_: bool;
    var phi_7797_: bool;
    var phi_7798_: bool;
    var phi_7799_: bool;
    var phi_7804_: f64;
    var phi_7808_: type_48;
    var phi_7809_: type_48;
    var phi_7810_: bool;
    var phi_7811_: type_48;
    var phi_7812_: type_48;
    var phi_7813_: bool;
    var phi_7819_: type_48;
    var phi_7820_: type_48;
    var phi_7821_: bool;
    var phi_7825_: type_48;
    var phi_7826_: type_48;
    var phi_7827_: bool;
    var phi_7828_: bool;
    var phi_7829_: type_48;
    var phi_7830_: type_48;
    var phi_7831_: bool;
    var phi_7832_: bool;
    var phi_7838_: type_48;
    var phi_7839_: bool;
    var phi_7843_: type_48;
    var phi_7859_: f64;
    var phi_7860_: f64;
    var phi_7861_: bool;
    var phi_7862_: f64;
    var phi_7863_: f64;
    var phi_7864_: bool;
    var phi_7865_: bool;
    var phi_7866_: bool;
    var phi_7867_: f64;
    var phi_7868_: f64;
    var phi_7869_: bool;
    var phi_7870_: bool;
    var phi_7871_: bool;
    var phi_7872_: f64;
    var phi_7873_: u32;
    var phi_7874_: f64;
    var phi_7875_: type_48;
    var phi_7876_: u32;
    var phi_7877_: u32;
    var phi_7878_: bool;
    var phi_7879_: bool;
    var phi_7880_: bool;
    var phi_7881_: f64;
    var phi_7882_: u32;
    var phi_7883_: f64;
    var phi_7884_: type_48;
    var phi_7885_: u32;
    var phi_7886_: u32;
    var phi_7887_: bool;
    var phi_7888_: bool;
    var phi_7889_: bool;
    var phi_7890_: bool;
    var phi_7891_: bool;
    var phi_7892_: f64;
    var phi_2876_: f64;
    var phi_2878_: u32;
    var phi_2880_: f64;
    var phi_7893_: type_48;
    var phi_7894_: u32;
    var phi_7895_: f64;
    var phi_7896_: u32;
    var phi_7897_: bool;
    var phi_7898_: bool;
    var phi_7899_: bool;
    var phi_7900_: bool;
    var phi_7901_: bool;
    var phi_7902_: bool;
    var local_58: bool;
    var phi_7906_: bool;
    var phi_7907_: bool;
    var phi_7908_: bool;
    var phi_7909_: bool;
    var local_59: type_48;
    var local_60: type_48;
    var phi_7926_: u32;
    var local_61: type_48;
    var phi_7931_: type_47;
    var phi_7932_: type_47;
    var phi_7933_: bool;
    var phi_7934_: bool;
    var phi_7935_: bool;
    var phi_7936_: bool;
    var phi_7940_: u32;
    var phi_7941_: f64;
    var phi_7942_: bool;
    var phi_7943_: bool;
    var phi_7944_: bool;
    var phi_7945_: bool;
    var phi_7949_: f64;
    var phi_7950_: u32;
    var phi_7951_: bool;
    var phi_7952_: bool;
    var phi_7953_: bool;
    var phi_7967_: f64;
    var phi_7970_: type_12;
    var phi_7971_: type_12;
    var phi_7994_: type_12;
    var phi_8016_: f64;
    var phi_8146_: type_16;
    var phi_8149_: f64;
    var phi_8170_: bool;
    var phi_8176_: type_17;
    var phi_8147_: type_16;
    var phi_8190_: type_17;
    var phi_8150_: f64;
    var local_62: f64;
    var phi_8139_: f64;
    var phi_8203_: f64;
    var phi_8221_: f64;
    var phi_8228_: f64;
    var phi_8233_: f64;
    var phi_8240_: f64;
    var phi_8245_: f64;
    var phi_8258_: f64;
    var phi_8265_: f64;
    var phi_8270_: f64;
    var phi_8277_: f64;
    var phi_8282_: f64;
    var phi_8287_: f64;
    var phi_8304_: f64;
    var phi_8311_: f64;
    var phi_8316_: f64;
    var phi_8323_: f64;
    var phi_8328_: f64;
    var phi_8342_: f64;
    var phi_8349_: f64;
    var phi_8354_: f64;
    var phi_8361_: f64;
    var phi_8366_: f64;
    var phi_8371_: f64;
    var phi_8388_: f64;
    var phi_8395_: f64;
    var phi_8400_: f64;
    var phi_8407_: f64;
    var phi_8412_: f64;
    var phi_8426_: f64;
    var phi_8433_: f64;
    var phi_8438_: f64;
    var phi_8445_: f64;
    var phi_8450_: f64;
    var phi_8455_: f64;
    var phi_8479_: bool;
    var phi_8480_: bool;
    var phi_8481_: bool;
    var local_63: bool;
    var phi_8489_: u32;
    var phi_8493_: type_47;
    var phi_8494_: bool;
    var phi_8502_: u32;
    var phi_8506_: type_47;
    var phi_8507_: type_47;
    var phi_8508_: bool;
    var phi_8509_: bool;
    var phi_8516_: type_47;
    var phi_8517_: bool;
    var phi_8521_: type_47;
    var phi_8522_: type_47;
    var phi_8523_: bool;
    var phi_8527_: type_47;
    var phi_16194_: type_47;
    var phi_16209_: type_37;
    var phi_16233_: u32;
    var phi_16237_: type_22;
    var phi_16238_: bool;
    var phi_16257_: u32;
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
        phi_966_ = _e142;
    } else {
        phi_966_ = _e144;
    }
    let _e147 = phi_966_;
    let _e149 = params.member.member_1.member_1;
    if (_e147 > _e149) {
        let _e152 = params.member.member_1.member_1;
        phi_976_ = (_e147 - _e152);
    } else {
        phi_976_ = 0u;
    }
    let _e155 = phi_976_;
    let _e157 = params.member.member_1.member;
    if (_e157 < _e155) {
        phi_983_ = _e157;
    } else {
        phi_983_ = _e155;
    }
    let _e160 = phi_983_;
    let _e161 = (_e160 / 64u);
    if ((_e160 % 64u) > 0u) {
        phi_999_ = (_e161 + 1u);
    } else {
        phi_999_ = _e161;
    }
    let _e166 = phi_999_;
    if (_e166 > _e136) {
        let _e168 = (_e166 - _e136);
        if (_e139 == 0u) {
            return;
        }
        let _e170 = (_e168 / _e139);
        if (_e139 == 0u) {
            return;
        }
        if ((_e168 % _e139) > 0u) {
            phi_1020_ = (_e170 + 1u);
        } else {
            phi_1020_ = _e170;
        }
        let _e176 = phi_1020_;
        phi_1021_ = _e176;
    } else {
        phi_1021_ = 0u;
    }
    let _e178 = phi_1021_;
    phi_1024_ = type_12(0u, _e178);
    loop {
        let _e181 = phi_1024_;
        if (_e181.member < _e181.member_1) {
            phi_1025_ = type_12((_e181.member + 1u), _e181.member_1);
            phi_1048_ = type_12(1u, _e181.member);
        } else {
            phi_1025_ = _e181;
            phi_1048_ = type_12(0u, type_12().member_1);
        }
        let _e193 = phi_1025_;
        let _e195 = phi_1048_;
        let _e199 = (bitcast<i32>(_e195.member) != 0i);
        if _e199 {
            let _e203 = (((_e136 + (_e195.member_1 * _e139)) * 64u) + _e124);
            if (_e203 < _e160) {
                let _e207 = params.member.member_1.member_1;
                let _e209 = (2u * (_e207 + _e203));
                let _e212 = input.member[(4u + _e209)];
                let _e215 = input.member[(_e209 + 5u)];
                let _e218 = elements.member[_e215];
                let _e223 = params.member.member.member_1;
                if ((_e223 & 8u) != 0u) {
                    let _e262 = paths.member[_e212];
                    let _e264 = paths.member[_e218[0]];
                    let _e270 = paths.member[_e218[1]];
                    let _e272 = paths.member[_e218[2]];
                    let _e309 = function_(array<f32, 3>(_e262.member[0], _e262.member[1], _e262.member[2]));
                    let _e310 = function_(array<f32, 3>(_e264.member[0], _e264.member[1], _e264.member[2]));
                    let _e311 = function_(array<f32, 3>(_e270.member[0], _e270.member[1], _e270.member[2]));
                    let _e312 = function_(array<f32, 3>(_e272.member[0], _e272.member[1], _e272.member[2]));
                    let _e314 = function_(array<f32, 3>(_e262.member_1[0], _e262.member_1[1], _e262.member_1[2]));
                    let _e315 = function_(array<f32, 3>(_e264.member_1[0], _e264.member_1[1], _e264.member_1[2]));
                    let _e316 = function_(array<f32, 3>(_e270.member_1[0], _e270.member_1[1], _e270.member_1[2]));
                    let _e317 = function_(array<f32, 3>(_e272.member_1[0], _e272.member_1[1], _e272.member_1[2]));
                    phi_1299_ = type_33(array<array<f64, 3>, 4>(_e309, _e310, _e311, _e312), array<array<f64, 3>, 4>(_e314, _e315, _e316, _e317));
                } else {
                    let _e227 = positions.member[_e212];
                    let _e230 = params.member.member.member[0u];
                    let _e233 = positions.member[(_e230 + _e212)];
                    let _e235 = positions.member[_e218[0]];
                    let _e238 = params.member.member.member[0u];
                    let _e241 = positions.member[(_e238 + _e218[0])];
                    let _e243 = positions.member[_e218[1]];
                    let _e246 = params.member.member.member[0u];
                    let _e249 = positions.member[(_e246 + _e218[1])];
                    let _e251 = positions.member[_e218[2]];
                    let _e254 = params.member.member.member[0u];
                    let _e257 = positions.member[(_e254 + _e218[2])];
                    phi_1299_ = type_33(array<array<f64, 3>, 4>(_e227, _e235, _e243, _e251), array<array<f64, 3>, 4>(_e233, _e241, _e249, _e257));
                }
                let _e321 = phi_1299_;
                let _e328 = (_e321.member[0][0] - _e321.member[1][0]);
                let _e331 = (_e321.member[0][1] - _e321.member[1][1]);
                let _e334 = (_e321.member[0][2] - _e321.member[1][2]);
                let _e340 = (_e321.member_1[0][0] - _e321.member_1[1][0]);
                let _e343 = (_e321.member_1[0][1] - _e321.member_1[1][1]);
                let _e346 = (_e321.member_1[0][2] - _e321.member_1[1][2]);
                let _e353 = (_e321.member[2][0] - _e321.member[1][0]);
                let _e356 = (_e321.member[2][1] - _e321.member[1][1]);
                let _e359 = (_e321.member[2][2] - _e321.member[1][2]);
                let _e365 = (_e321.member_1[2][0] - _e321.member_1[1][0]);
                let _e368 = (_e321.member_1[2][1] - _e321.member_1[1][1]);
                let _e371 = (_e321.member_1[2][2] - _e321.member_1[1][2]);
                let _e378 = (_e321.member[3][0] - _e321.member[1][0]);
                let _e381 = (_e321.member[3][1] - _e321.member[1][1]);
                let _e384 = (_e321.member[3][2] - _e321.member[1][2]);
                let _e390 = (_e321.member_1[3][0] - _e321.member_1[1][0]);
                let _e393 = (_e321.member_1[3][1] - _e321.member_1[1][1]);
                let _e396 = (_e321.member_1[3][2] - _e321.member_1[1][2]);
                let _e399 = (0.0lf + 0.0lf);
                let _e402 = params.member.member.member_7;
                let _e409 = bitcast<f64>(((u64(_e402[1]) * 4294967296lu) + u64(_e402[0])));
                let _e411 = params.member.member.member_14;
                let _e418 = bitcast<f64>(((u64(_e411[1]) * 4294967296lu) + u64(_e411[0])));
                let _e420 = params.member.member.member_15;
                let _e427 = bitcast<f64>(((u64(_e420[1]) * 4294967296lu) + u64(_e420[0])));
                let _e429 = params.member.member.member_16;
                let _e436 = bitcast<f64>(((u64(_e429[1]) * 4294967296lu) + u64(_e429[0])));
                let _e438 = params.member.member.member_1;
                if (_e328 < 0.0lf) {
                    phi_1424_ = -(_e328);
                } else {
                    phi_1424_ = _e328;
                }
                let _e444 = phi_1424_;
                if (_e331 < 0.0lf) {
                    phi_1430_ = -(_e331);
                } else {
                    phi_1430_ = _e331;
                }
                let _e448 = phi_1430_;
                if (_e444 > _e448) {
                    phi_1435_ = _e444;
                } else {
                    phi_1435_ = _e448;
                }
                let _e451 = phi_1435_;
                if (_e334 < 0.0lf) {
                    phi_1441_ = -(_e334);
                } else {
                    phi_1441_ = _e334;
                }
                let _e455 = phi_1441_;
                if (_e451 > _e455) {
                    phi_1446_ = _e451;
                } else {
                    phi_1446_ = _e455;
                }
                let _e458 = phi_1446_;
                if (_e340 < 0.0lf) {
                    phi_1452_ = -(_e340);
                } else {
                    phi_1452_ = _e340;
                }
                let _e462 = phi_1452_;
                if (_e343 < 0.0lf) {
                    phi_1458_ = -(_e343);
                } else {
                    phi_1458_ = _e343;
                }
                let _e466 = phi_1458_;
                if (_e462 > _e466) {
                    phi_1463_ = _e462;
                } else {
                    phi_1463_ = _e466;
                }
                let _e469 = phi_1463_;
                if (_e346 < 0.0lf) {
                    phi_1469_ = -(_e346);
                } else {
                    phi_1469_ = _e346;
                }
                let _e473 = phi_1469_;
                if (_e469 > _e473) {
                    phi_1474_ = _e469;
                } else {
                    phi_1474_ = _e473;
                }
                let _e476 = phi_1474_;
                if (_e458 > _e476) {
                    phi_1479_ = _e458;
                } else {
                    phi_1479_ = _e476;
                }
                let _e479 = phi_1479_;
                let _e480 = (_e479 + _e399);
                if (_e353 < 0.0lf) {
                    phi_1486_ = -(_e353);
                } else {
                    phi_1486_ = _e353;
                }
                let _e484 = phi_1486_;
                if (_e356 < 0.0lf) {
                    phi_1492_ = -(_e356);
                } else {
                    phi_1492_ = _e356;
                }
                let _e488 = phi_1492_;
                if (_e484 > _e488) {
                    phi_1497_ = _e484;
                } else {
                    phi_1497_ = _e488;
                }
                let _e491 = phi_1497_;
                if (_e359 < 0.0lf) {
                    phi_1503_ = -(_e359);
                } else {
                    phi_1503_ = _e359;
                }
                let _e495 = phi_1503_;
                if (_e491 > _e495) {
                    phi_1508_ = _e491;
                } else {
                    phi_1508_ = _e495;
                }
                let _e498 = phi_1508_;
                if (_e365 < 0.0lf) {
                    phi_1514_ = -(_e365);
                } else {
                    phi_1514_ = _e365;
                }
                let _e502 = phi_1514_;
                if (_e368 < 0.0lf) {
                    phi_1520_ = -(_e368);
                } else {
                    phi_1520_ = _e368;
                }
                let _e506 = phi_1520_;
                if (_e502 > _e506) {
                    phi_1525_ = _e502;
                } else {
                    phi_1525_ = _e506;
                }
                let _e509 = phi_1525_;
                if (_e371 < 0.0lf) {
                    phi_1531_ = -(_e371);
                } else {
                    phi_1531_ = _e371;
                }
                let _e513 = phi_1531_;
                if (_e509 > _e513) {
                    phi_1536_ = _e509;
                } else {
                    phi_1536_ = _e513;
                }
                let _e516 = phi_1536_;
                if (_e498 > _e516) {
                    phi_1541_ = _e498;
                } else {
                    phi_1541_ = _e516;
                }
                let _e519 = phi_1541_;
                let _e520 = (_e519 + _e399);
                if (_e378 < 0.0lf) {
                    phi_1548_ = -(_e378);
                } else {
                    phi_1548_ = _e378;
                }
                let _e524 = phi_1548_;
                if (_e381 < 0.0lf) {
                    phi_1554_ = -(_e381);
                } else {
                    phi_1554_ = _e381;
                }
                let _e528 = phi_1554_;
                if (_e524 > _e528) {
                    phi_1559_ = _e524;
                } else {
                    phi_1559_ = _e528;
                }
                let _e531 = phi_1559_;
                if (_e384 < 0.0lf) {
                    phi_1565_ = -(_e384);
                } else {
                    phi_1565_ = _e384;
                }
                let _e535 = phi_1565_;
                if (_e531 > _e535) {
                    phi_1570_ = _e531;
                } else {
                    phi_1570_ = _e535;
                }
                let _e538 = phi_1570_;
                if (_e390 < 0.0lf) {
                    phi_1576_ = -(_e390);
                } else {
                    phi_1576_ = _e390;
                }
                let _e542 = phi_1576_;
                if (_e393 < 0.0lf) {
                    phi_1582_ = -(_e393);
                } else {
                    phi_1582_ = _e393;
                }
                let _e546 = phi_1582_;
                if (_e542 > _e546) {
                    phi_1587_ = _e542;
                } else {
                    phi_1587_ = _e546;
                }
                let _e549 = phi_1587_;
                if (_e396 < 0.0lf) {
                    phi_1593_ = -(_e396);
                } else {
                    phi_1593_ = _e396;
                }
                let _e553 = phi_1593_;
                if (_e549 > _e553) {
                    phi_1598_ = _e549;
                } else {
                    phi_1598_ = _e553;
                }
                let _e556 = phi_1598_;
                if (_e538 > _e556) {
                    phi_1603_ = _e538;
                } else {
                    phi_1603_ = _e556;
                }
                let _e559 = phi_1603_;
                let _e560 = (_e559 + _e399);
                if (_e480 > _e520) {
                    phi_1609_ = _e480;
                } else {
                    phi_1609_ = _e520;
                }
                let _e563 = phi_1609_;
                if (_e563 > _e560) {
                    phi_1614_ = _e563;
                } else {
                    phi_1614_ = _e560;
                }
                let _e566 = phi_1614_;
                if (_e566 <= f64(65536f)) {
                    phi_1623_ = (_e566 >= f64((1f / 65536f)));
                } else {
                    phi_1623_ = false;
                }
                let _e573 = phi_1623_;
                if _e573 {
                    phi_1698_ = type_45();
                    phi_1699_ = true;
                } else {
                    if (_e566 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e566) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e580 = (9214364837600034816lu - (bitcast<u64>(_e566) & 9218868437227405312lu));
                            if (_e580 > 4503599627370496lu) {
                                phi_1647_ = _e580;
                            } else {
                                phi_1647_ = 4503599627370496lu;
                            }
                            let _e583 = phi_1647_;
                            let _e584 = bitcast<f64>(_e583);
                            let _e585 = (_e409 * _e584);
                            if (_e409 > f64(0f)) {
                                if (_e585 > 2.2250738585072014e-308lf) {
                                    phi_1659_ = _e585;
                                } else {
                                    phi_1659_ = 2.2250738585072014e-308lf;
                                }
                                let _e590 = phi_1659_;
                                phi_1660_ = _e590;
                            } else {
                                phi_1660_ = _e585;
                            }
                            let _e592 = phi_1660_;
                            phi_1694_ = type_45(type_35(array<array<f64, 3>, 2>(array<f64, 3>((_e328 * _e584), (_e331 * _e584), (_e334 * _e584)), array<f64, 3>((_e340 * _e584), (_e343 * _e584), (_e346 * _e584))), array<array<f64, 3>, 2>(array<f64, 3>((_e353 * _e584), (_e356 * _e584), (_e359 * _e584)), array<f64, 3>((_e365 * _e584), (_e368 * _e584), (_e371 * _e584))), array<array<f64, 3>, 2>(array<f64, 3>((_e378 * _e584), (_e381 * _e584), (_e384 * _e584)), array<f64, 3>((_e390 * _e584), (_e393 * _e584), (_e396 * _e584))), ((_e399 + (2.2250738585072014e-308lf * f64(8f))) * _e584)), _e592);
                            phi_1695_ = false;
                        } else {
                            phi_1694_ = type_45();
                            phi_1695_ = true;
                        }
                        let _e627 = phi_1694_;
                        let _e629 = phi_1695_;
                        phi_1696_ = _e627;
                        phi_1697_ = _e629;
                    } else {
                        phi_1696_ = type_45();
                        phi_1697_ = true;
                    }
                    let _e631 = phi_1696_;
                    let _e633 = phi_1697_;
                    phi_1698_ = _e631;
                    phi_1699_ = _e633;
                }
                let _e635 = phi_1698_;
                let _e637 = phi_1699_;
                if _e637 {
                    phi_1704_ = type_45(type_35(array<array<f64, 3>, 2>(array<f64, 3>(_e328, _e331, _e334), array<f64, 3>(_e340, _e343, _e346)), array<array<f64, 3>, 2>(array<f64, 3>(_e353, _e356, _e359), array<f64, 3>(_e365, _e368, _e371)), array<array<f64, 3>, 2>(array<f64, 3>(_e378, _e381, _e384), array<f64, 3>(_e390, _e393, _e396)), _e399), _e409);
                } else {
                    phi_1704_ = _e635;
                }
                let _e640 = phi_1704_;
                local_18 = type_35(array<array<f64, 3>, 2>(array<f64, 3>(_e640.member.member[0][0], _e640.member.member[0][1], _e640.member.member[0][2]), array<f64, 3>(_e640.member.member[1][0], _e640.member.member[1][1], _e640.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e640.member.member_1[0][0], _e640.member.member_1[0][1], _e640.member.member_1[0][2]), array<f64, 3>(_e640.member.member_1[1][0], _e640.member.member_1[1][1], _e640.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e640.member.member_2[0][0], _e640.member.member_2[0][1], _e640.member.member_2[0][2]), array<f64, 3>(_e640.member.member_2[1][0], _e640.member.member_2[1][1], _e640.member.member_2[1][2])), _e640.member.member_3);
                if (_e640.member_1 > f64(0f)) {
                    let _e5873 = local_18.member[0u];
                    let _e5879 = local_18.member[1u];
                    let _e5895 = local_18.member_1[0u];
                    let _e5901 = local_18.member_1[1u];
                    let _e5917 = local_18.member_2[0u];
                    let _e5923 = local_18.member_2[1u];
                    let _e5937 = function_3(array<f64, 3>((_e5873[0] + ((_e5879[0] - _e5873[0]) * _e427)), (_e5873[1] + ((_e5879[1] - _e5873[1]) * _e427)), (_e5873[2] + ((_e5879[2] - _e5873[2]) * _e427))), array<f64, 3>((_e5895[0] + ((_e5901[0] - _e5895[0]) * _e427)), (_e5895[1] + ((_e5901[1] - _e5895[1]) * _e427)), (_e5895[2] + ((_e5901[2] - _e5895[2]) * _e427))), array<f64, 3>((_e5917[0] + ((_e5923[0] - _e5917[0]) * _e427)), (_e5917[1] + ((_e5923[1] - _e5917[1]) * _e427)), (_e5917[2] + ((_e5923[2] - _e5917[2]) * _e427))), 0u);
                    let _e5948 = (((_e5937[0] * _e5937[0]) + (_e5937[1] * _e5937[1])) + (_e5937[2] * _e5937[2]));
                    if (_e5948 <= 2.2250738585072014e-308lf) {
                        if (_e5948 > 0.0lf) {
                            phi_1872_ = (1.464336215552873e-154lf * 2.0lf);
                        } else {
                            phi_1872_ = 0.0lf;
                        }
                        let _e6000 = phi_1872_;
                        phi_1936_ = _e6000;
                    } else {
                        phi_1879_ = type_16(0i, 5i);
                        phi_1882_ = bitcast<f64>(((bitcast<u64>(_e5948) / 2lu) + 2303426169912950784lu));
                        loop {
                            let _e5955 = phi_1879_;
                            let _e5957 = phi_1882_;
                            local_40 = _e5957;
                            if (_e5955.member < _e5955.member_1) {
                                let _e5964 = (_e5955.member + 1i);
                                if ((false == (_e5964 > _e5955.member)) != false) {
                                    phi_1903_ = true;
                                } else {
                                    phi_1903_ = false;
                                }
                                let _e5969 = phi_1903_;
                                if _e5969 {
                                    phi_1909_ = type_17(0u, type_17().member_1);
                                } else {
                                    phi_1909_ = type_17(1u, _e5964);
                                }
                                let _e5974 = phi_1909_;
                                phi_1880_ = type_16(_e5974.member_1, _e5955.member_1);
                                phi_1923_ = type_17(1u, _e5955.member);
                            } else {
                                phi_1880_ = _e5955;
                                phi_1923_ = type_17(0u, type_17().member_1);
                            }
                            let _e5980 = phi_1880_;
                            let _e5982 = phi_1923_;
                            let _e5985 = (bitcast<i32>(_e5982.member) != 0i);
                            if _e5985 {
                                phi_1883_ = (0.5lf * (_e5957 + (_e5948 / _e5957)));
                            } else {
                                phi_1883_ = f64();
                            }
                            let _e5990 = phi_1883_;
                            continue;
                            continuing {
                                phi_1879_ = _e5980;
                                phi_1882_ = _e5990;
                                break if !(_e5985);
                            }
                        }
                        let _e5995 = local_40;
                        phi_1936_ = (_e5995 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                    }
                    let _e6002 = phi_1936_;
                    let _e6010 = local_18.member[0u];
                    if (_e6010[0] < 0.0lf) {
                        phi_1954_ = -(_e6010[0]);
                    } else {
                        phi_1954_ = _e6010[0];
                    }
                    let _e6017 = phi_1954_;
                    if (_e6010[1] < 0.0lf) {
                        phi_1961_ = -(_e6010[1]);
                    } else {
                        phi_1961_ = _e6010[1];
                    }
                    let _e6021 = phi_1961_;
                    if (_e6017 > _e6021) {
                        phi_1966_ = _e6017;
                    } else {
                        phi_1966_ = _e6021;
                    }
                    let _e6024 = phi_1966_;
                    if (_e6010[2] < 0.0lf) {
                        phi_1973_ = -(_e6010[2]);
                    } else {
                        phi_1973_ = _e6010[2];
                    }
                    let _e6028 = phi_1973_;
                    if (_e6024 > _e6028) {
                        phi_1978_ = _e6024;
                    } else {
                        phi_1978_ = _e6028;
                    }
                    let _e6031 = phi_1978_;
                    let _e6034 = local_18.member[1u];
                    if (_e6034[0] < 0.0lf) {
                        phi_1991_ = -(_e6034[0]);
                    } else {
                        phi_1991_ = _e6034[0];
                    }
                    let _e6041 = phi_1991_;
                    if (_e6034[1] < 0.0lf) {
                        phi_1998_ = -(_e6034[1]);
                    } else {
                        phi_1998_ = _e6034[1];
                    }
                    let _e6045 = phi_1998_;
                    if (_e6041 > _e6045) {
                        phi_2003_ = _e6041;
                    } else {
                        phi_2003_ = _e6045;
                    }
                    let _e6048 = phi_2003_;
                    if (_e6034[2] < 0.0lf) {
                        phi_2010_ = -(_e6034[2]);
                    } else {
                        phi_2010_ = _e6034[2];
                    }
                    let _e6052 = phi_2010_;
                    if (_e6048 > _e6052) {
                        phi_2015_ = _e6048;
                    } else {
                        phi_2015_ = _e6052;
                    }
                    let _e6055 = phi_2015_;
                    if (_e6031 > _e6055) {
                        phi_2020_ = _e6031;
                    } else {
                        phi_2020_ = _e6055;
                    }
                    let _e6058 = phi_2020_;
                    let _e6060 = local_18.member_3;
                    let _e6064 = local_18.member_1[0u];
                    if (_e6064[0] < 0.0lf) {
                        phi_2037_ = -(_e6064[0]);
                    } else {
                        phi_2037_ = _e6064[0];
                    }
                    let _e6071 = phi_2037_;
                    if (_e6064[1] < 0.0lf) {
                        phi_2044_ = -(_e6064[1]);
                    } else {
                        phi_2044_ = _e6064[1];
                    }
                    let _e6075 = phi_2044_;
                    if (_e6071 > _e6075) {
                        phi_2049_ = _e6071;
                    } else {
                        phi_2049_ = _e6075;
                    }
                    let _e6078 = phi_2049_;
                    if (_e6064[2] < 0.0lf) {
                        phi_2056_ = -(_e6064[2]);
                    } else {
                        phi_2056_ = _e6064[2];
                    }
                    let _e6082 = phi_2056_;
                    if (_e6078 > _e6082) {
                        phi_2061_ = _e6078;
                    } else {
                        phi_2061_ = _e6082;
                    }
                    let _e6085 = phi_2061_;
                    let _e6088 = local_18.member_1[1u];
                    if (_e6088[0] < 0.0lf) {
                        phi_2075_ = -(_e6088[0]);
                    } else {
                        phi_2075_ = _e6088[0];
                    }
                    let _e6095 = phi_2075_;
                    if (_e6088[1] < 0.0lf) {
                        phi_2082_ = -(_e6088[1]);
                    } else {
                        phi_2082_ = _e6088[1];
                    }
                    let _e6099 = phi_2082_;
                    if (_e6095 > _e6099) {
                        phi_2087_ = _e6095;
                    } else {
                        phi_2087_ = _e6099;
                    }
                    let _e6102 = phi_2087_;
                    if (_e6088[2] < 0.0lf) {
                        phi_2094_ = -(_e6088[2]);
                    } else {
                        phi_2094_ = _e6088[2];
                    }
                    let _e6106 = phi_2094_;
                    if (_e6102 > _e6106) {
                        phi_2099_ = _e6102;
                    } else {
                        phi_2099_ = _e6106;
                    }
                    let _e6109 = phi_2099_;
                    if (_e6085 > _e6109) {
                        phi_2104_ = _e6085;
                    } else {
                        phi_2104_ = _e6109;
                    }
                    let _e6112 = phi_2104_;
                    let _e6114 = local_18.member_3;
                    let _e6118 = local_18.member_2[0u];
                    if (_e6118[0] < 0.0lf) {
                        phi_2121_ = -(_e6118[0]);
                    } else {
                        phi_2121_ = _e6118[0];
                    }
                    let _e6125 = phi_2121_;
                    if (_e6118[1] < 0.0lf) {
                        phi_2128_ = -(_e6118[1]);
                    } else {
                        phi_2128_ = _e6118[1];
                    }
                    let _e6129 = phi_2128_;
                    if (_e6125 > _e6129) {
                        phi_2133_ = _e6125;
                    } else {
                        phi_2133_ = _e6129;
                    }
                    let _e6132 = phi_2133_;
                    if (_e6118[2] < 0.0lf) {
                        phi_2140_ = -(_e6118[2]);
                    } else {
                        phi_2140_ = _e6118[2];
                    }
                    let _e6136 = phi_2140_;
                    if (_e6132 > _e6136) {
                        phi_2145_ = _e6132;
                    } else {
                        phi_2145_ = _e6136;
                    }
                    let _e6139 = phi_2145_;
                    let _e6142 = local_18.member_2[1u];
                    if (_e6142[0] < 0.0lf) {
                        phi_2159_ = -(_e6142[0]);
                    } else {
                        phi_2159_ = _e6142[0];
                    }
                    let _e6149 = phi_2159_;
                    if (_e6142[1] < 0.0lf) {
                        phi_2166_ = -(_e6142[1]);
                    } else {
                        phi_2166_ = _e6142[1];
                    }
                    let _e6153 = phi_2166_;
                    if (_e6149 > _e6153) {
                        phi_2171_ = _e6149;
                    } else {
                        phi_2171_ = _e6153;
                    }
                    let _e6156 = phi_2171_;
                    if (_e6142[2] < 0.0lf) {
                        phi_2178_ = -(_e6142[2]);
                    } else {
                        phi_2178_ = _e6142[2];
                    }
                    let _e6160 = phi_2178_;
                    if (_e6156 > _e6160) {
                        phi_2183_ = _e6156;
                    } else {
                        phi_2183_ = _e6160;
                    }
                    let _e6163 = phi_2183_;
                    if (_e6139 > _e6163) {
                        phi_2188_ = _e6139;
                    } else {
                        phi_2188_ = _e6163;
                    }
                    let _e6166 = phi_2188_;
                    let _e6168 = local_18.member_3;
                    let _e6176 = local_18.member_3;
                    let _e6186 = (((_e6002 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e6058 + _e6060) + (_e6112 + _e6114)) + (_e6166 + _e6168)) * (1.1102230246251565e-16lf * f64(16f))) + (_e6176 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e640.member_1);
                    if _e6186 {
                        phi_2865_ = type_47();
                        phi_2866_ = true;
                    } else {
                        let _e6189 = local_18.member_1[0u];
                        let _e6195 = local_18.member_2[0u];
                        let _e6201 = ((_e6189[1] * _e6195[2]) - (_e6189[2] * _e6195[1]));
                        let _e6204 = ((_e6189[2] * _e6195[0]) - (_e6189[0] * _e6195[2]));
                        let _e6207 = ((_e6189[0] * _e6195[1]) - (_e6189[1] * _e6195[0]));
                        let _e6210 = local_18.member_1[1u];
                        let _e6216 = local_18.member_2[1u];
                        let _e6222 = ((_e6210[1] * _e6216[2]) - (_e6210[2] * _e6216[1]));
                        let _e6225 = ((_e6210[2] * _e6216[0]) - (_e6210[0] * _e6216[2]));
                        let _e6228 = ((_e6210[0] * _e6216[1]) - (_e6210[1] * _e6216[0]));
                        let _e6231 = local_18.member_1[0u];
                        let _e6237 = local_18.member_2[1u];
                        let _e6252 = local_18.member_1[1u];
                        let _e6258 = local_18.member_2[0u];
                        let _e6271 = (((_e6231[1] * _e6237[2]) - (_e6231[2] * _e6237[1])) + ((_e6252[1] * _e6258[2]) - (_e6252[2] * _e6258[1])));
                        let _e6272 = (((_e6231[2] * _e6237[0]) - (_e6231[0] * _e6237[2])) + ((_e6252[2] * _e6258[0]) - (_e6252[0] * _e6258[2])));
                        let _e6273 = (((_e6231[0] * _e6237[1]) - (_e6231[1] * _e6237[0])) + ((_e6252[0] * _e6258[1]) - (_e6252[1] * _e6258[0])));
                        let _e6276 = local_18.member[0u];
                        let _e6287 = local_18.member[1u];
                        let _e6298 = local_18.member[0u];
                        let _e6307 = ((((_e6287[0] * _e6201) + (_e6287[1] * _e6204)) + (_e6287[2] * _e6207)) + (((_e6298[0] * _e6271) + (_e6298[1] * _e6272)) + (_e6298[2] * _e6273)));
                        let _e6310 = local_18.member[0u];
                        let _e6321 = local_18.member[1u];
                        let _e6330 = ((((_e6310[0] * _e6222) + (_e6310[1] * _e6225)) + (_e6310[2] * _e6228)) + (((_e6321[0] * _e6271) + (_e6321[1] * _e6272)) + (_e6321[2] * _e6273)));
                        let _e6333 = local_18.member[1u];
                        let _e6344 = local_18.member[0u];
                        if (_e6344[0] < 0.0lf) {
                            phi_2453_ = -(_e6344[0]);
                        } else {
                            phi_2453_ = _e6344[0];
                        }
                        let _e6351 = phi_2453_;
                        if (_e6344[1] < 0.0lf) {
                            phi_2460_ = -(_e6344[1]);
                        } else {
                            phi_2460_ = _e6344[1];
                        }
                        let _e6355 = phi_2460_;
                        if (_e6351 > _e6355) {
                            phi_2465_ = _e6351;
                        } else {
                            phi_2465_ = _e6355;
                        }
                        let _e6358 = phi_2465_;
                        if (_e6344[2] < 0.0lf) {
                            phi_2472_ = -(_e6344[2]);
                        } else {
                            phi_2472_ = _e6344[2];
                        }
                        let _e6362 = phi_2472_;
                        if (_e6358 > _e6362) {
                            phi_2477_ = _e6358;
                        } else {
                            phi_2477_ = _e6362;
                        }
                        let _e6365 = phi_2477_;
                        let _e6368 = local_18.member[1u];
                        if (_e6368[0] < 0.0lf) {
                            phi_2490_ = -(_e6368[0]);
                        } else {
                            phi_2490_ = _e6368[0];
                        }
                        let _e6375 = phi_2490_;
                        if (_e6368[1] < 0.0lf) {
                            phi_2497_ = -(_e6368[1]);
                        } else {
                            phi_2497_ = _e6368[1];
                        }
                        let _e6379 = phi_2497_;
                        if (_e6375 > _e6379) {
                            phi_2502_ = _e6375;
                        } else {
                            phi_2502_ = _e6379;
                        }
                        let _e6382 = phi_2502_;
                        if (_e6368[2] < 0.0lf) {
                            phi_2509_ = -(_e6368[2]);
                        } else {
                            phi_2509_ = _e6368[2];
                        }
                        let _e6386 = phi_2509_;
                        if (_e6382 > _e6386) {
                            phi_2514_ = _e6382;
                        } else {
                            phi_2514_ = _e6386;
                        }
                        let _e6389 = phi_2514_;
                        if (_e6365 > _e6389) {
                            phi_2519_ = _e6365;
                        } else {
                            phi_2519_ = _e6389;
                        }
                        let _e6392 = phi_2519_;
                        let _e6394 = local_18.member_3;
                        let _e6395 = (_e6392 + _e6394);
                        let _e6398 = local_18.member_1[0u];
                        if (_e6398[0] < 0.0lf) {
                            phi_2536_ = -(_e6398[0]);
                        } else {
                            phi_2536_ = _e6398[0];
                        }
                        let _e6405 = phi_2536_;
                        if (_e6398[1] < 0.0lf) {
                            phi_2543_ = -(_e6398[1]);
                        } else {
                            phi_2543_ = _e6398[1];
                        }
                        let _e6409 = phi_2543_;
                        if (_e6405 > _e6409) {
                            phi_2548_ = _e6405;
                        } else {
                            phi_2548_ = _e6409;
                        }
                        let _e6412 = phi_2548_;
                        if (_e6398[2] < 0.0lf) {
                            phi_2555_ = -(_e6398[2]);
                        } else {
                            phi_2555_ = _e6398[2];
                        }
                        let _e6416 = phi_2555_;
                        if (_e6412 > _e6416) {
                            phi_2560_ = _e6412;
                        } else {
                            phi_2560_ = _e6416;
                        }
                        let _e6419 = phi_2560_;
                        let _e6422 = local_18.member_1[1u];
                        if (_e6422[0] < 0.0lf) {
                            phi_2574_ = -(_e6422[0]);
                        } else {
                            phi_2574_ = _e6422[0];
                        }
                        let _e6429 = phi_2574_;
                        if (_e6422[1] < 0.0lf) {
                            phi_2581_ = -(_e6422[1]);
                        } else {
                            phi_2581_ = _e6422[1];
                        }
                        let _e6433 = phi_2581_;
                        if (_e6429 > _e6433) {
                            phi_2586_ = _e6429;
                        } else {
                            phi_2586_ = _e6433;
                        }
                        let _e6436 = phi_2586_;
                        if (_e6422[2] < 0.0lf) {
                            phi_2593_ = -(_e6422[2]);
                        } else {
                            phi_2593_ = _e6422[2];
                        }
                        let _e6440 = phi_2593_;
                        if (_e6436 > _e6440) {
                            phi_2598_ = _e6436;
                        } else {
                            phi_2598_ = _e6440;
                        }
                        let _e6443 = phi_2598_;
                        if (_e6419 > _e6443) {
                            phi_2603_ = _e6419;
                        } else {
                            phi_2603_ = _e6443;
                        }
                        let _e6446 = phi_2603_;
                        let _e6448 = local_18.member_3;
                        let _e6449 = (_e6446 + _e6448);
                        let _e6452 = local_18.member_2[0u];
                        if (_e6452[0] < 0.0lf) {
                            phi_2620_ = -(_e6452[0]);
                        } else {
                            phi_2620_ = _e6452[0];
                        }
                        let _e6459 = phi_2620_;
                        if (_e6452[1] < 0.0lf) {
                            phi_2627_ = -(_e6452[1]);
                        } else {
                            phi_2627_ = _e6452[1];
                        }
                        let _e6463 = phi_2627_;
                        if (_e6459 > _e6463) {
                            phi_2632_ = _e6459;
                        } else {
                            phi_2632_ = _e6463;
                        }
                        let _e6466 = phi_2632_;
                        if (_e6452[2] < 0.0lf) {
                            phi_2639_ = -(_e6452[2]);
                        } else {
                            phi_2639_ = _e6452[2];
                        }
                        let _e6470 = phi_2639_;
                        if (_e6466 > _e6470) {
                            phi_2644_ = _e6466;
                        } else {
                            phi_2644_ = _e6470;
                        }
                        let _e6473 = phi_2644_;
                        let _e6476 = local_18.member_2[1u];
                        if (_e6476[0] < 0.0lf) {
                            phi_2658_ = -(_e6476[0]);
                        } else {
                            phi_2658_ = _e6476[0];
                        }
                        let _e6483 = phi_2658_;
                        if (_e6476[1] < 0.0lf) {
                            phi_2665_ = -(_e6476[1]);
                        } else {
                            phi_2665_ = _e6476[1];
                        }
                        let _e6487 = phi_2665_;
                        if (_e6483 > _e6487) {
                            phi_2670_ = _e6483;
                        } else {
                            phi_2670_ = _e6487;
                        }
                        let _e6490 = phi_2670_;
                        if (_e6476[2] < 0.0lf) {
                            phi_2677_ = -(_e6476[2]);
                        } else {
                            phi_2677_ = _e6476[2];
                        }
                        let _e6494 = phi_2677_;
                        if (_e6490 > _e6494) {
                            phi_2682_ = _e6490;
                        } else {
                            phi_2682_ = _e6494;
                        }
                        let _e6497 = phi_2682_;
                        if (_e6473 > _e6497) {
                            phi_2687_ = _e6473;
                        } else {
                            phi_2687_ = _e6497;
                        }
                        let _e6500 = phi_2687_;
                        let _e6502 = local_18.member_3;
                        let _e6503 = (_e6500 + _e6502);
                        let _e6504 = f64(1f);
                        let _e6505 = f64(8f);
                        let _e6507 = ((_e6449 * _e6505) * _e6503);
                        let _e6515 = local_18.member_3;
                        if (_e6201 < 0.0lf) {
                            phi_2724_ = -(_e6201);
                        } else {
                            phi_2724_ = _e6201;
                        }
                        let _e6535 = phi_2724_;
                        if (_e6204 < 0.0lf) {
                            phi_2730_ = -(_e6204);
                        } else {
                            phi_2730_ = _e6204;
                        }
                        let _e6539 = phi_2730_;
                        if (_e6207 < 0.0lf) {
                            phi_2737_ = -(_e6207);
                        } else {
                            phi_2737_ = _e6207;
                        }
                        let _e6544 = phi_2737_;
                        let _e6545 = ((_e6535 + _e6539) + _e6544);
                        if (_e6222 < 0.0lf) {
                            phi_2744_ = -(_e6222);
                        } else {
                            phi_2744_ = _e6222;
                        }
                        let _e6549 = phi_2744_;
                        if (_e6225 < 0.0lf) {
                            phi_2750_ = -(_e6225);
                        } else {
                            phi_2750_ = _e6225;
                        }
                        let _e6553 = phi_2750_;
                        if (_e6228 < 0.0lf) {
                            phi_2757_ = -(_e6228);
                        } else {
                            phi_2757_ = _e6228;
                        }
                        let _e6558 = phi_2757_;
                        let _e6559 = ((_e6549 + _e6553) + _e6558);
                        if (_e6545 > _e6559) {
                            phi_2763_ = _e6545;
                        } else {
                            phi_2763_ = _e6559;
                        }
                        let _e6562 = phi_2763_;
                        if (_e6271 < 0.0lf) {
                            phi_2769_ = -(_e6271);
                        } else {
                            phi_2769_ = _e6271;
                        }
                        let _e6566 = phi_2769_;
                        if (_e6272 < 0.0lf) {
                            phi_2775_ = -(_e6272);
                        } else {
                            phi_2775_ = _e6272;
                        }
                        let _e6570 = phi_2775_;
                        if (_e6273 < 0.0lf) {
                            phi_2782_ = -(_e6273);
                        } else {
                            phi_2782_ = _e6273;
                        }
                        let _e6575 = phi_2782_;
                        let _e6577 = (((_e6566 + _e6570) + _e6575) * f64(0.5f));
                        if (_e6562 > _e6577) {
                            phi_2789_ = _e6562;
                        } else {
                            phi_2789_ = _e6577;
                        }
                        let _e6580 = phi_2789_;
                        let _e6586 = local_18.member_3;
                        let _e6601 = f64(3f);
                        let _e6602 = ((((_e6276[0] * _e6201) + (_e6276[1] * _e6204)) + (_e6276[2] * _e6207)) * _e6601);
                        let _e6603 = ((((_e6333[0] * _e6222) + (_e6333[1] * _e6225)) + (_e6333[2] * _e6228)) * _e6601);
                        if (_e6602 < _e6603) {
                            phi_2817_ = _e6602;
                        } else {
                            phi_2817_ = _e6603;
                        }
                        let _e6606 = phi_2817_;
                        if (_e6307 < _e6330) {
                            phi_2822_ = _e6307;
                        } else {
                            phi_2822_ = _e6330;
                        }
                        let _e6609 = phi_2822_;
                        if (_e6606 < _e6609) {
                            phi_2827_ = _e6606;
                        } else {
                            phi_2827_ = _e6609;
                        }
                        let _e6612 = phi_2827_;
                        if (_e6602 > _e6603) {
                            phi_2832_ = _e6602;
                        } else {
                            phi_2832_ = _e6603;
                        }
                        let _e6615 = phi_2832_;
                        if (_e6307 > _e6330) {
                            phi_2837_ = _e6307;
                        } else {
                            phi_2837_ = _e6330;
                        }
                        let _e6618 = phi_2837_;
                        if (_e6615 > _e6618) {
                            phi_2842_ = _e6615;
                        } else {
                            phi_2842_ = _e6618;
                        }
                        let _e6621 = phi_2842_;
                        let _e6627 = -(_e6621);
                        if (_e6612 > _e6627) {
                            phi_2853_ = _e6612;
                        } else {
                            phi_2853_ = _e6627;
                        }
                        let _e6630 = phi_2853_;
                        if ((_e6630 - ((((((_e6395 * _e6505) * _e6507) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e6515 * f64(19f)) * ((_e6395 * (_e6449 + _e6503)) + (_e6449 * _e6503)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e6504 + _e6395) * ((_e6504 + _e6449) * (_e6504 + _e6503))))) + ((_e640.member_1 * (((_e6580 + (_e6507 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e6586 * f64(6f)) * (_e6449 + _e6503))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e6504 + _e6449) * (_e6504 + _e6503))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                            phi_2863_ = type_47(type_46(0u, f64()), 0u);
                            phi_2864_ = false;
                        } else {
                            phi_2863_ = type_47();
                            phi_2864_ = true;
                        }
                        let _e6637 = phi_2863_;
                        let _e6639 = phi_2864_;
                        phi_2865_ = _e6637;
                        phi_2866_ = _e6639;
                    }
                    let _e6641 = phi_2865_;
                    let _e6643 = phi_2866_;
                    if _e6643 {
                        phi_2872_ = type_16(0i, 2i);
                        phi_2875_ = _e427;
                        phi_2877_ = 0u;
                        phi_2879_ = _e427;
                        loop {
                            let _e6645 = phi_2872_;
                            let _e6647 = phi_2875_;
                            let _e6649 = phi_2877_;
                            let _e6651 = phi_2879_;
                            local_99 = _e6649;
                            local_102 = _e6647;
                            local_103 = _e6649;
                            if (_e6645.member < _e6645.member_1) {
                                let _e6658 = (_e6645.member + 1i);
                                if ((false == (_e6658 > _e6645.member)) != false) {
                                    phi_2900_ = true;
                                } else {
                                    phi_2900_ = false;
                                }
                                let _e6663 = phi_2900_;
                                if _e6663 {
                                    phi_2906_ = type_17(0u, type_17().member_1);
                                } else {
                                    phi_2906_ = type_17(1u, _e6658);
                                }
                                let _e6668 = phi_2906_;
                                phi_2873_ = type_16(_e6668.member_1, _e6645.member_1);
                                phi_2920_ = type_17(1u, _e6645.member);
                            } else {
                                phi_2873_ = _e6645;
                                phi_2920_ = type_17(0u, type_17().member_1);
                            }
                            let _e6674 = phi_2873_;
                            let _e6676 = phi_2920_;
                            if (bitcast<i32>(_e6676.member) != 0i) {
                                if (_e6676.member_1 > 0i) {
                                    phi_2936_ = true;
                                } else {
                                    if _e6186 {
                                        phi_2935_ = false;
                                    } else {
                                        phi_2935_ = true;
                                    }
                                    let _e6683 = phi_2935_;
                                    phi_2936_ = _e6683;
                                }
                                let _e6685 = phi_2936_;
                                if _e6685 {
                                    let _e6688 = local_18.member[0u];
                                    let _e6694 = local_18.member_1[0u];
                                    let _e6700 = local_18.member_2[0u];
                                    let _e6712 = local_18.member[1u];
                                    let _e6718 = local_18.member_1[1u];
                                    let _e6724 = local_18.member_2[1u];
                                    let _e6736 = local_18.member[0u];
                                    if (_e6736[0] < 0.0lf) {
                                        phi_3082_ = -(_e6736[0]);
                                    } else {
                                        phi_3082_ = _e6736[0];
                                    }
                                    let _e6743 = phi_3082_;
                                    if (_e6736[1] < 0.0lf) {
                                        phi_3089_ = -(_e6736[1]);
                                    } else {
                                        phi_3089_ = _e6736[1];
                                    }
                                    let _e6747 = phi_3089_;
                                    if (_e6743 > _e6747) {
                                        phi_3094_ = _e6743;
                                    } else {
                                        phi_3094_ = _e6747;
                                    }
                                    let _e6750 = phi_3094_;
                                    if (_e6736[2] < 0.0lf) {
                                        phi_3101_ = -(_e6736[2]);
                                    } else {
                                        phi_3101_ = _e6736[2];
                                    }
                                    let _e6754 = phi_3101_;
                                    if (_e6750 > _e6754) {
                                        phi_3106_ = _e6750;
                                    } else {
                                        phi_3106_ = _e6754;
                                    }
                                    let _e6757 = phi_3106_;
                                    let _e6760 = local_18.member[1u];
                                    if (_e6760[0] < 0.0lf) {
                                        phi_3119_ = -(_e6760[0]);
                                    } else {
                                        phi_3119_ = _e6760[0];
                                    }
                                    let _e6767 = phi_3119_;
                                    if (_e6760[1] < 0.0lf) {
                                        phi_3126_ = -(_e6760[1]);
                                    } else {
                                        phi_3126_ = _e6760[1];
                                    }
                                    let _e6771 = phi_3126_;
                                    if (_e6767 > _e6771) {
                                        phi_3131_ = _e6767;
                                    } else {
                                        phi_3131_ = _e6771;
                                    }
                                    let _e6774 = phi_3131_;
                                    if (_e6760[2] < 0.0lf) {
                                        phi_3138_ = -(_e6760[2]);
                                    } else {
                                        phi_3138_ = _e6760[2];
                                    }
                                    let _e6778 = phi_3138_;
                                    if (_e6774 > _e6778) {
                                        phi_3143_ = _e6774;
                                    } else {
                                        phi_3143_ = _e6778;
                                    }
                                    let _e6781 = phi_3143_;
                                    if (_e6757 > _e6781) {
                                        phi_3148_ = _e6757;
                                    } else {
                                        phi_3148_ = _e6781;
                                    }
                                    let _e6784 = phi_3148_;
                                    let _e6786 = local_18.member_3;
                                    let _e6790 = local_18.member_1[0u];
                                    if (_e6790[0] < 0.0lf) {
                                        phi_3165_ = -(_e6790[0]);
                                    } else {
                                        phi_3165_ = _e6790[0];
                                    }
                                    let _e6797 = phi_3165_;
                                    if (_e6790[1] < 0.0lf) {
                                        phi_3172_ = -(_e6790[1]);
                                    } else {
                                        phi_3172_ = _e6790[1];
                                    }
                                    let _e6801 = phi_3172_;
                                    if (_e6797 > _e6801) {
                                        phi_3177_ = _e6797;
                                    } else {
                                        phi_3177_ = _e6801;
                                    }
                                    let _e6804 = phi_3177_;
                                    if (_e6790[2] < 0.0lf) {
                                        phi_3184_ = -(_e6790[2]);
                                    } else {
                                        phi_3184_ = _e6790[2];
                                    }
                                    let _e6808 = phi_3184_;
                                    if (_e6804 > _e6808) {
                                        phi_3189_ = _e6804;
                                    } else {
                                        phi_3189_ = _e6808;
                                    }
                                    let _e6811 = phi_3189_;
                                    let _e6814 = local_18.member_1[1u];
                                    if (_e6814[0] < 0.0lf) {
                                        phi_3203_ = -(_e6814[0]);
                                    } else {
                                        phi_3203_ = _e6814[0];
                                    }
                                    let _e6821 = phi_3203_;
                                    if (_e6814[1] < 0.0lf) {
                                        phi_3210_ = -(_e6814[1]);
                                    } else {
                                        phi_3210_ = _e6814[1];
                                    }
                                    let _e6825 = phi_3210_;
                                    if (_e6821 > _e6825) {
                                        phi_3215_ = _e6821;
                                    } else {
                                        phi_3215_ = _e6825;
                                    }
                                    let _e6828 = phi_3215_;
                                    if (_e6814[2] < 0.0lf) {
                                        phi_3222_ = -(_e6814[2]);
                                    } else {
                                        phi_3222_ = _e6814[2];
                                    }
                                    let _e6832 = phi_3222_;
                                    if (_e6828 > _e6832) {
                                        phi_3227_ = _e6828;
                                    } else {
                                        phi_3227_ = _e6832;
                                    }
                                    let _e6835 = phi_3227_;
                                    if (_e6811 > _e6835) {
                                        phi_3232_ = _e6811;
                                    } else {
                                        phi_3232_ = _e6835;
                                    }
                                    let _e6838 = phi_3232_;
                                    let _e6840 = local_18.member_3;
                                    let _e6844 = local_18.member_2[0u];
                                    if (_e6844[0] < 0.0lf) {
                                        phi_3249_ = -(_e6844[0]);
                                    } else {
                                        phi_3249_ = _e6844[0];
                                    }
                                    let _e6851 = phi_3249_;
                                    if (_e6844[1] < 0.0lf) {
                                        phi_3256_ = -(_e6844[1]);
                                    } else {
                                        phi_3256_ = _e6844[1];
                                    }
                                    let _e6855 = phi_3256_;
                                    if (_e6851 > _e6855) {
                                        phi_3261_ = _e6851;
                                    } else {
                                        phi_3261_ = _e6855;
                                    }
                                    let _e6858 = phi_3261_;
                                    if (_e6844[2] < 0.0lf) {
                                        phi_3268_ = -(_e6844[2]);
                                    } else {
                                        phi_3268_ = _e6844[2];
                                    }
                                    let _e6862 = phi_3268_;
                                    if (_e6858 > _e6862) {
                                        phi_3273_ = _e6858;
                                    } else {
                                        phi_3273_ = _e6862;
                                    }
                                    let _e6865 = phi_3273_;
                                    let _e6868 = local_18.member_2[1u];
                                    if (_e6868[0] < 0.0lf) {
                                        phi_3287_ = -(_e6868[0]);
                                    } else {
                                        phi_3287_ = _e6868[0];
                                    }
                                    let _e6875 = phi_3287_;
                                    if (_e6868[1] < 0.0lf) {
                                        phi_3294_ = -(_e6868[1]);
                                    } else {
                                        phi_3294_ = _e6868[1];
                                    }
                                    let _e6879 = phi_3294_;
                                    if (_e6875 > _e6879) {
                                        phi_3299_ = _e6875;
                                    } else {
                                        phi_3299_ = _e6879;
                                    }
                                    let _e6882 = phi_3299_;
                                    if (_e6868[2] < 0.0lf) {
                                        phi_3306_ = -(_e6868[2]);
                                    } else {
                                        phi_3306_ = _e6868[2];
                                    }
                                    let _e6886 = phi_3306_;
                                    if (_e6882 > _e6886) {
                                        phi_3311_ = _e6882;
                                    } else {
                                        phi_3311_ = _e6886;
                                    }
                                    let _e6889 = phi_3311_;
                                    if (_e6865 > _e6889) {
                                        phi_3316_ = _e6865;
                                    } else {
                                        phi_3316_ = _e6889;
                                    }
                                    let _e6892 = phi_3316_;
                                    let _e6894 = local_18.member_3;
                                    let _e6902 = local_18.member_3;
                                    let _e6910 = (_e418 * f64(0.00390625f));
                                    let _e6911 = f64(0f);
                                    let _e6912 = f64(1f);
                                    local_16 = type_38(array<f64, 4>(_e6911, _e6911, _e6911, _e6911), array<f64, 4>(_e6911, _e6911, _e6911, _e6911), array<f64, 4>(_e6912, _e6912, _e6912, _e6912));
                                    phi_3363_ = type_12(0u, 96u);
                                    phi_3366_ = _e6651;
                                    phi_3368_ = _e6651;
                                    phi_3370_ = (_e436 - _e6651);
                                    phi_3372_ = _e6651;
                                    phi_3374_ = false;
                                    phi_3376_ = 0u;
                                    loop {
                                        let _e6919 = phi_3363_;
                                        let _e6921 = phi_3366_;
                                        let _e6923 = phi_3368_;
                                        let _e6925 = phi_3370_;
                                        let _e6927 = phi_3372_;
                                        let _e6929 = phi_3374_;
                                        let _e6931 = phi_3376_;
                                        local_44 = _e6921;
                                        local_89 = _e6923;
                                        if (_e6919.member < _e6919.member_1) {
                                            phi_3364_ = type_12((_e6919.member + 1u), _e6919.member_1);
                                            phi_3399_ = type_12(1u, _e6919.member);
                                        } else {
                                            phi_3364_ = _e6919;
                                            phi_3399_ = type_12(0u, type_12().member_1);
                                        }
                                        let _e6943 = phi_3364_;
                                        let _e6945 = phi_3399_;
                                        if (bitcast<i32>(_e6945.member) != 0i) {
                                            let _e6951 = local_18.member[0u];
                                            let _e6957 = local_18.member[1u];
                                            let _e6973 = local_18.member_1[0u];
                                            let _e6979 = local_18.member_1[1u];
                                            let _e6995 = local_18.member_2[0u];
                                            let _e7001 = local_18.member_2[1u];
                                            let _e7015 = function_3(array<f64, 3>((_e6951[0] + ((_e6957[0] - _e6951[0]) * _e6921)), (_e6951[1] + ((_e6957[1] - _e6951[1]) * _e6921)), (_e6951[2] + ((_e6957[2] - _e6951[2]) * _e6921))), array<f64, 3>((_e6973[0] + ((_e6979[0] - _e6973[0]) * _e6921)), (_e6973[1] + ((_e6979[1] - _e6973[1]) * _e6921)), (_e6973[2] + ((_e6979[2] - _e6973[2]) * _e6921))), array<f64, 3>((_e6995[0] + ((_e7001[0] - _e6995[0]) * _e6921)), (_e6995[1] + ((_e7001[1] - _e6995[1]) * _e6921)), (_e6995[2] + ((_e7001[2] - _e6995[2]) * _e6921))), 0u);
                                            if (_e6931 == 0u) {
                                                phi_3528_ = _e7015;
                                            } else {
                                                let _e7017 = f64(0f);
                                                if (_e6931 == 1u) {
                                                    phi_3514_ = _e7015[0];
                                                } else {
                                                    phi_3514_ = _e7017;
                                                }
                                                let _e7021 = phi_3514_;
                                                if (_e6931 == 2u) {
                                                    phi_3520_ = _e7015[1];
                                                } else {
                                                    phi_3520_ = _e7017;
                                                }
                                                let _e7025 = phi_3520_;
                                                if (_e6931 == 3u) {
                                                    phi_3526_ = _e7015[2];
                                                } else {
                                                    phi_3526_ = _e7017;
                                                }
                                                let _e7029 = phi_3526_;
                                                phi_3528_ = array<f64, 3>(_e7021, _e7025, _e7029);
                                            }
                                            let _e7032 = phi_3528_;
                                            if (_e7032[0] < 0.0lf) {
                                                phi_3535_ = -(_e7032[0]);
                                            } else {
                                                phi_3535_ = _e7032[0];
                                            }
                                            let _e7037 = phi_3535_;
                                            if (_e7032[1] < 0.0lf) {
                                                phi_3542_ = -(_e7032[1]);
                                            } else {
                                                phi_3542_ = _e7032[1];
                                            }
                                            let _e7042 = phi_3542_;
                                            if (_e7032[2] < 0.0lf) {
                                                phi_3550_ = -(_e7032[2]);
                                            } else {
                                                phi_3550_ = _e7032[2];
                                            }
                                            let _e7048 = phi_3550_;
                                            let _e7049 = ((_e7037 + _e7042) + _e7048);
                                            if (_e7049 > f64(0f)) {
                                                if ((bitcast<u64>(_e7049) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                    let _e7056 = (f64(1f) / _e7049);
                                                    let _e7058 = (_e7032[0] * _e7056);
                                                    let _e7060 = (_e7032[1] * _e7056);
                                                    let _e7062 = (_e7032[2] * _e7056);
                                                    let _e7067 = (((_e7058 * _e7058) + (_e7060 * _e7060)) + (_e7062 * _e7062));
                                                    if (_e7067 <= 2.2250738585072014e-308lf) {
                                                        if (_e7067 > 0.0lf) {
                                                            phi_3589_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_3589_ = 0.0lf;
                                                        }
                                                        let _e7119 = phi_3589_;
                                                        phi_3653_ = _e7119;
                                                    } else {
                                                        phi_3596_ = type_16(0i, 5i);
                                                        phi_3599_ = bitcast<f64>(((bitcast<u64>(_e7067) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e7074 = phi_3596_;
                                                            let _e7076 = phi_3599_;
                                                            local_41 = _e7076;
                                                            if (_e7074.member < _e7074.member_1) {
                                                                let _e7083 = (_e7074.member + 1i);
                                                                if ((false == (_e7083 > _e7074.member)) != false) {
                                                                    phi_3620_ = true;
                                                                } else {
                                                                    phi_3620_ = false;
                                                                }
                                                                let _e7088 = phi_3620_;
                                                                if _e7088 {
                                                                    phi_3626_ = type_17(0u, type_17().member_1);
                                                                } else {
                                                                    phi_3626_ = type_17(1u, _e7083);
                                                                }
                                                                let _e7093 = phi_3626_;
                                                                phi_3597_ = type_16(_e7093.member_1, _e7074.member_1);
                                                                phi_3640_ = type_17(1u, _e7074.member);
                                                            } else {
                                                                phi_3597_ = _e7074;
                                                                phi_3640_ = type_17(0u, type_17().member_1);
                                                            }
                                                            let _e7099 = phi_3597_;
                                                            let _e7101 = phi_3640_;
                                                            let _e7104 = (bitcast<i32>(_e7101.member) != 0i);
                                                            if _e7104 {
                                                                phi_3600_ = (0.5lf * (_e7076 + (_e7067 / _e7076)));
                                                            } else {
                                                                phi_3600_ = f64();
                                                            }
                                                            let _e7109 = phi_3600_;
                                                            continue;
                                                            continuing {
                                                                phi_3596_ = _e7099;
                                                                phi_3599_ = _e7109;
                                                                break if !(_e7104);
                                                            }
                                                        }
                                                        let _e7114 = local_41;
                                                        phi_3653_ = (_e7114 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e7121 = phi_3653_;
                                                    let _e7123 = (1.1102230246251565e-16lf * f64(12f));
                                                    let _e7130 = ((((((((_e6784 + _e6786) + (_e6838 + _e6840)) + (_e6892 + _e6894)) * (1.1102230246251565e-16lf * f64(16f))) + (_e6902 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e640.member_1 * _e7121) * (f64(1f) + _e7123)));
                                                    let _e7135 = (((_e7058 * _e6688[0]) + (_e7060 * _e6688[1])) + (_e7062 * _e6688[2]));
                                                    let _e7140 = (((_e7058 * (_e6688[0] - _e6694[0])) + (_e7060 * (_e6688[1] - _e6694[1]))) + (_e7062 * (_e6688[2] - _e6694[2])));
                                                    let _e7145 = (((_e7058 * (_e6688[0] - _e6700[0])) + (_e7060 * (_e6688[1] - _e6700[1]))) + (_e7062 * (_e6688[2] - _e6700[2])));
                                                    let _e7150 = (((_e7058 * _e6688[0]) + (_e7060 * _e6688[1])) + (_e7062 * _e6688[2]));
                                                    let _e7156 = (((_e7058 * _e6712[0]) + (_e7060 * _e6712[1])) + (_e7062 * _e6712[2]));
                                                    let _e7161 = (((_e7058 * (_e6712[0] - _e6718[0])) + (_e7060 * (_e6712[1] - _e6718[1]))) + (_e7062 * (_e6712[2] - _e6718[2])));
                                                    let _e7166 = (((_e7058 * (_e6712[0] - _e6724[0])) + (_e7060 * (_e6712[1] - _e6724[1]))) + (_e7062 * (_e6712[2] - _e6724[2])));
                                                    let _e7171 = (((_e7058 * _e6712[0]) + (_e7060 * _e6712[1])) + (_e7062 * _e6712[2]));
                                                    if (_e7135 < 0.0lf) {
                                                        phi_3722_ = -(_e7135);
                                                    } else {
                                                        phi_3722_ = _e7135;
                                                    }
                                                    let _e7176 = phi_3722_;
                                                    if (_e7156 < 0.0lf) {
                                                        phi_3728_ = -(_e7156);
                                                    } else {
                                                        phi_3728_ = _e7156;
                                                    }
                                                    let _e7180 = phi_3728_;
                                                    if (_e7140 < 0.0lf) {
                                                        phi_3737_ = -(_e7140);
                                                    } else {
                                                        phi_3737_ = _e7140;
                                                    }
                                                    let _e7187 = phi_3737_;
                                                    if (_e7161 < 0.0lf) {
                                                        phi_3743_ = -(_e7161);
                                                    } else {
                                                        phi_3743_ = _e7161;
                                                    }
                                                    let _e7191 = phi_3743_;
                                                    if (_e7145 < 0.0lf) {
                                                        phi_3752_ = -(_e7145);
                                                    } else {
                                                        phi_3752_ = _e7145;
                                                    }
                                                    let _e7198 = phi_3752_;
                                                    if (_e7166 < 0.0lf) {
                                                        phi_3758_ = -(_e7166);
                                                    } else {
                                                        phi_3758_ = _e7166;
                                                    }
                                                    let _e7202 = phi_3758_;
                                                    if (_e7150 < 0.0lf) {
                                                        phi_3767_ = -(_e7150);
                                                    } else {
                                                        phi_3767_ = _e7150;
                                                    }
                                                    let _e7209 = phi_3767_;
                                                    if (_e7171 < 0.0lf) {
                                                        phi_3773_ = -(_e7171);
                                                    } else {
                                                        phi_3773_ = _e7171;
                                                    }
                                                    let _e7213 = phi_3773_;
                                                    phi_3779_ = type_38(array<f64, 4>(_e7135, _e7140, _e7145, _e7150), array<f64, 4>(_e7156, _e7161, _e7166, _e7171), array<f64, 4>((_e7130 + ((_e7176 + _e7180) * _e7123)), (_e7130 + ((_e7187 + _e7191) * _e7123)), (_e7130 + ((_e7198 + _e7202) * _e7123)), (_e7130 + ((_e7209 + _e7213) * _e7123))));
                                                    phi_3780_ = false;
                                                } else {
                                                    phi_3779_ = type_38();
                                                    phi_3780_ = true;
                                                }
                                                let _e7220 = phi_3779_;
                                                let _e7222 = phi_3780_;
                                                phi_3781_ = _e7220;
                                                phi_3782_ = _e7222;
                                            } else {
                                                phi_3781_ = type_38();
                                                phi_3782_ = true;
                                            }
                                            let _e7224 = phi_3781_;
                                            let _e7226 = phi_3782_;
                                            if _e7226 {
                                                let _e7227 = f64(0f);
                                                let _e7228 = f64(1f);
                                                phi_3792_ = type_38(array<f64, 4>(_e7227, _e7227, _e7227, _e7227), array<f64, 4>(_e7227, _e7227, _e7227, _e7227), array<f64, 4>(_e7228, _e7228, _e7228, _e7228));
                                            } else {
                                                phi_3792_ = _e7224;
                                            }
                                            let _e7234 = phi_3792_;
                                            local_17 = type_38(array<f64, 4>(_e7234.member[0], _e7234.member[1], _e7234.member[2], _e7234.member[3]), array<f64, 4>(_e7234.member_1[0], _e7234.member_1[1], _e7234.member_1[2], _e7234.member_1[3]), array<f64, 4>(_e7234.member_2[0], _e7234.member_2[1], _e7234.member_2[2], _e7234.member_2[3]));
                                            let _e7254 = (_e6921 - _e6927);
                                            let _e7256 = f64(0f);
                                            let _e7259 = local_17.member[0u];
                                            let _e7262 = local_17.member_1[0u];
                                            let _e7265 = local_17.member[0u];
                                            let _e7271 = local_17.member_2[0u];
                                            if (((_e7259 + ((_e7262 - _e7265) * _e6921)) - _e7271) > _e7256) {
                                                let _e7276 = local_17.member[1u];
                                                let _e7279 = local_17.member_1[1u];
                                                let _e7282 = local_17.member[1u];
                                                let _e7288 = local_17.member_2[1u];
                                                if (((_e7276 + ((_e7279 - _e7282) * _e6921)) - _e7288) > _e7256) {
                                                    let _e7293 = local_17.member[2u];
                                                    let _e7296 = local_17.member_1[2u];
                                                    let _e7299 = local_17.member[2u];
                                                    let _e7305 = local_17.member_2[2u];
                                                    if (((_e7293 + ((_e7296 - _e7299) * _e6921)) - _e7305) > _e7256) {
                                                        let _e7310 = local_17.member[3u];
                                                        let _e7313 = local_17.member_1[3u];
                                                        let _e7316 = local_17.member[3u];
                                                        let _e7322 = local_17.member_2[3u];
                                                        phi_3964_ = (((_e7310 + ((_e7313 - _e7316) * _e6921)) - _e7322) > _e7256);
                                                        phi_3965_ = false;
                                                    } else {
                                                        phi_3964_ = bool();
                                                        phi_3965_ = true;
                                                    }
                                                    let _e7326 = phi_3964_;
                                                    let _e7328 = phi_3965_;
                                                    phi_3966_ = _e7326;
                                                    phi_3967_ = _e7328;
                                                } else {
                                                    phi_3966_ = bool();
                                                    phi_3967_ = true;
                                                }
                                                let _e7330 = phi_3966_;
                                                let _e7332 = phi_3967_;
                                                phi_3968_ = _e7330;
                                                phi_3969_ = _e7332;
                                            } else {
                                                phi_3968_ = bool();
                                                phi_3969_ = true;
                                            }
                                            let _e7334 = phi_3968_;
                                            let _e7336 = phi_3969_;
                                            if _e7336 {
                                                phi_3973_ = false;
                                            } else {
                                                phi_3973_ = _e7334;
                                            }
                                            let _e7338 = phi_3973_;
                                            if _e7338 {
                                                if (_e6921 <= _e6923) {
                                                    phi_4284_ = true;
                                                } else {
                                                    let _e7340 = f64(0f);
                                                    let _e7343 = local_16.member[0u];
                                                    let _e7346 = local_16.member_1[0u];
                                                    let _e7349 = local_16.member[0u];
                                                    let _e7355 = local_16.member_2[0u];
                                                    let _e7359 = local_17.member[0u];
                                                    let _e7362 = local_17.member_1[0u];
                                                    let _e7365 = local_17.member[0u];
                                                    let _e7371 = local_17.member_2[0u];
                                                    if ((((_e7343 + ((_e7346 - _e7349) * _e6921)) - _e7355) + ((_e7359 + ((_e7362 - _e7365) * _e6927)) - _e7371)) > _e7340) {
                                                        let _e7377 = local_16.member[1u];
                                                        let _e7380 = local_16.member_1[1u];
                                                        let _e7383 = local_16.member[1u];
                                                        let _e7389 = local_16.member_2[1u];
                                                        let _e7393 = local_17.member[1u];
                                                        let _e7396 = local_17.member_1[1u];
                                                        let _e7399 = local_17.member[1u];
                                                        let _e7405 = local_17.member_2[1u];
                                                        if ((((_e7377 + ((_e7380 - _e7383) * _e6921)) - _e7389) + ((_e7393 + ((_e7396 - _e7399) * _e6927)) - _e7405)) > _e7340) {
                                                            let _e7411 = local_16.member[2u];
                                                            let _e7414 = local_16.member_1[2u];
                                                            let _e7417 = local_16.member[2u];
                                                            let _e7423 = local_16.member_2[2u];
                                                            let _e7427 = local_17.member[2u];
                                                            let _e7430 = local_17.member_1[2u];
                                                            let _e7433 = local_17.member[2u];
                                                            let _e7439 = local_17.member_2[2u];
                                                            if ((((_e7411 + ((_e7414 - _e7417) * _e6921)) - _e7423) + ((_e7427 + ((_e7430 - _e7433) * _e6927)) - _e7439)) > _e7340) {
                                                                let _e7445 = local_16.member[3u];
                                                                let _e7448 = local_16.member_1[3u];
                                                                let _e7451 = local_16.member[3u];
                                                                let _e7457 = local_16.member_2[3u];
                                                                let _e7461 = local_17.member[3u];
                                                                let _e7464 = local_17.member_1[3u];
                                                                let _e7467 = local_17.member[3u];
                                                                let _e7473 = local_17.member_2[3u];
                                                                phi_4271_ = ((((_e7445 + ((_e7448 - _e7451) * _e6921)) - _e7457) + ((_e7461 + ((_e7464 - _e7467) * _e6927)) - _e7473)) > _e7340);
                                                                phi_4272_ = false;
                                                            } else {
                                                                phi_4271_ = bool();
                                                                phi_4272_ = true;
                                                            }
                                                            let _e7478 = phi_4271_;
                                                            let _e7480 = phi_4272_;
                                                            phi_4273_ = _e7478;
                                                            phi_4274_ = _e7480;
                                                        } else {
                                                            phi_4273_ = bool();
                                                            phi_4274_ = true;
                                                        }
                                                        let _e7482 = phi_4273_;
                                                        let _e7484 = phi_4274_;
                                                        phi_4275_ = _e7482;
                                                        phi_4276_ = _e7484;
                                                    } else {
                                                        phi_4275_ = bool();
                                                        phi_4276_ = true;
                                                    }
                                                    let _e7486 = phi_4275_;
                                                    let _e7488 = phi_4276_;
                                                    if _e7488 {
                                                        phi_4280_ = false;
                                                    } else {
                                                        phi_4280_ = _e7486;
                                                    }
                                                    let _e7490 = phi_4280_;
                                                    phi_4284_ = _e7490;
                                                }
                                                let _e7492 = phi_4284_;
                                                if _e7492 {
                                                    if _e6929 {
                                                        if (_e6921 >= _e436) {
                                                            phi_4295_ = false;
                                                        } else {
                                                            phi_4295_ = true;
                                                        }
                                                        let _e7495 = phi_4295_;
                                                        phi_4296_ = _e7495;
                                                    } else {
                                                        phi_4296_ = true;
                                                    }
                                                    let _e7497 = phi_4296_;
                                                    if _e7497 {
                                                        local_16 = type_38(array<f64, 4>(_e7234.member[0], _e7234.member[1], _e7234.member[2], _e7234.member[3]), array<f64, 4>(_e7234.member_1[0], _e7234.member_1[1], _e7234.member_1[2], _e7234.member_1[3]), array<f64, 4>(_e7234.member_2[0], _e7234.member_2[1], _e7234.member_2[2], _e7234.member_2[3]));
                                                        let _e7519 = local_16.member[0u];
                                                        let _e7522 = local_16.member_1[0u];
                                                        let _e7525 = local_16.member_2[0u];
                                                        if (_e7519 > _e7525) {
                                                            if (_e7522 > _e7525) {
                                                                phi_4370_ = false;
                                                            } else {
                                                                phi_4370_ = true;
                                                            }
                                                            let _e7529 = phi_4370_;
                                                            phi_4371_ = _e7529;
                                                        } else {
                                                            phi_4371_ = true;
                                                        }
                                                        let _e7531 = phi_4371_;
                                                        if _e7531 {
                                                            let _e7532 = (_e7522 >= _e7519);
                                                            if _e7532 {
                                                                phi_4396_ = f64();
                                                                phi_4397_ = false;
                                                            } else {
                                                                if ((_e7519 - _e7522) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4394_ = (((_e7519 - _e7525) / (_e7519 - _e7522)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4395_ = false;
                                                                } else {
                                                                    phi_4394_ = f64();
                                                                    phi_4395_ = true;
                                                                }
                                                                let _e7546 = phi_4394_;
                                                                let _e7548 = phi_4395_;
                                                                phi_4396_ = _e7546;
                                                                phi_4397_ = _e7548;
                                                            }
                                                            let _e7550 = phi_4396_;
                                                            let _e7552 = phi_4397_;
                                                            phi_4398_ = _e7550;
                                                            phi_4399_ = _e7532;
                                                            phi_4400_ = _e7552;
                                                        } else {
                                                            phi_4398_ = f64();
                                                            phi_4399_ = true;
                                                            phi_4400_ = false;
                                                        }
                                                        let _e7554 = phi_4398_;
                                                        let _e7556 = phi_4399_;
                                                        let _e7558 = phi_4400_;
                                                        if _e7556 {
                                                            phi_4405_ = f64(2f);
                                                            phi_4406_ = true;
                                                        } else {
                                                            phi_4405_ = _e6921;
                                                            phi_4406_ = _e7558;
                                                        }
                                                        let _e7561 = phi_4405_;
                                                        let _e7563 = phi_4406_;
                                                        if _e7563 {
                                                            phi_4410_ = _e7561;
                                                        } else {
                                                            phi_4410_ = _e7554;
                                                        }
                                                        let _e7565 = phi_4410_;
                                                        let _e7568 = local_16.member[1u];
                                                        let _e7571 = local_16.member_1[1u];
                                                        let _e7574 = local_16.member_2[1u];
                                                        if (_e7568 > _e7574) {
                                                            if (_e7571 > _e7574) {
                                                                phi_4442_ = false;
                                                            } else {
                                                                phi_4442_ = true;
                                                            }
                                                            let _e7578 = phi_4442_;
                                                            phi_4443_ = _e7578;
                                                        } else {
                                                            phi_4443_ = true;
                                                        }
                                                        let _e7580 = phi_4443_;
                                                        if _e7580 {
                                                            let _e7581 = (_e7571 >= _e7568);
                                                            if _e7581 {
                                                                phi_4468_ = f64();
                                                                phi_4469_ = false;
                                                            } else {
                                                                if ((_e7568 - _e7571) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4466_ = (((_e7568 - _e7574) / (_e7568 - _e7571)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4467_ = false;
                                                                } else {
                                                                    phi_4466_ = f64();
                                                                    phi_4467_ = true;
                                                                }
                                                                let _e7595 = phi_4466_;
                                                                let _e7597 = phi_4467_;
                                                                phi_4468_ = _e7595;
                                                                phi_4469_ = _e7597;
                                                            }
                                                            let _e7599 = phi_4468_;
                                                            let _e7601 = phi_4469_;
                                                            phi_4470_ = _e7599;
                                                            phi_4471_ = _e7581;
                                                            phi_4472_ = _e7601;
                                                        } else {
                                                            phi_4470_ = f64();
                                                            phi_4471_ = true;
                                                            phi_4472_ = false;
                                                        }
                                                        let _e7603 = phi_4470_;
                                                        let _e7605 = phi_4471_;
                                                        let _e7607 = phi_4472_;
                                                        if _e7605 {
                                                            phi_4477_ = f64(2f);
                                                            phi_4478_ = true;
                                                        } else {
                                                            phi_4477_ = _e6921;
                                                            phi_4478_ = _e7607;
                                                        }
                                                        let _e7610 = phi_4477_;
                                                        let _e7612 = phi_4478_;
                                                        if _e7612 {
                                                            phi_4482_ = _e7610;
                                                        } else {
                                                            phi_4482_ = _e7603;
                                                        }
                                                        let _e7614 = phi_4482_;
                                                        if (_e7565 < _e7614) {
                                                            phi_4487_ = _e7565;
                                                        } else {
                                                            phi_4487_ = _e7614;
                                                        }
                                                        let _e7617 = phi_4487_;
                                                        let _e7620 = local_16.member[2u];
                                                        let _e7623 = local_16.member_1[2u];
                                                        let _e7626 = local_16.member_2[2u];
                                                        if (_e7620 > _e7626) {
                                                            if (_e7623 > _e7626) {
                                                                phi_4519_ = false;
                                                            } else {
                                                                phi_4519_ = true;
                                                            }
                                                            let _e7630 = phi_4519_;
                                                            phi_4520_ = _e7630;
                                                        } else {
                                                            phi_4520_ = true;
                                                        }
                                                        let _e7632 = phi_4520_;
                                                        if _e7632 {
                                                            let _e7633 = (_e7623 >= _e7620);
                                                            if _e7633 {
                                                                phi_4545_ = f64();
                                                                phi_4546_ = false;
                                                            } else {
                                                                if ((_e7620 - _e7623) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4543_ = (((_e7620 - _e7626) / (_e7620 - _e7623)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4544_ = false;
                                                                } else {
                                                                    phi_4543_ = f64();
                                                                    phi_4544_ = true;
                                                                }
                                                                let _e7647 = phi_4543_;
                                                                let _e7649 = phi_4544_;
                                                                phi_4545_ = _e7647;
                                                                phi_4546_ = _e7649;
                                                            }
                                                            let _e7651 = phi_4545_;
                                                            let _e7653 = phi_4546_;
                                                            phi_4547_ = _e7651;
                                                            phi_4548_ = _e7633;
                                                            phi_4549_ = _e7653;
                                                        } else {
                                                            phi_4547_ = f64();
                                                            phi_4548_ = true;
                                                            phi_4549_ = false;
                                                        }
                                                        let _e7655 = phi_4547_;
                                                        let _e7657 = phi_4548_;
                                                        let _e7659 = phi_4549_;
                                                        if _e7657 {
                                                            phi_4554_ = f64(2f);
                                                            phi_4555_ = true;
                                                        } else {
                                                            phi_4554_ = _e6921;
                                                            phi_4555_ = _e7659;
                                                        }
                                                        let _e7662 = phi_4554_;
                                                        let _e7664 = phi_4555_;
                                                        if _e7664 {
                                                            phi_4559_ = _e7662;
                                                        } else {
                                                            phi_4559_ = _e7655;
                                                        }
                                                        let _e7666 = phi_4559_;
                                                        let _e7669 = local_16.member[3u];
                                                        let _e7672 = local_16.member_1[3u];
                                                        let _e7675 = local_16.member_2[3u];
                                                        if (_e7669 > _e7675) {
                                                            if (_e7672 > _e7675) {
                                                                phi_4591_ = false;
                                                            } else {
                                                                phi_4591_ = true;
                                                            }
                                                            let _e7679 = phi_4591_;
                                                            phi_4592_ = _e7679;
                                                        } else {
                                                            phi_4592_ = true;
                                                        }
                                                        let _e7681 = phi_4592_;
                                                        if _e7681 {
                                                            let _e7682 = (_e7672 >= _e7669);
                                                            if _e7682 {
                                                                phi_4617_ = f64();
                                                                phi_4618_ = false;
                                                            } else {
                                                                if ((_e7669 - _e7672) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4615_ = (((_e7669 - _e7675) / (_e7669 - _e7672)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4616_ = false;
                                                                } else {
                                                                    phi_4615_ = f64();
                                                                    phi_4616_ = true;
                                                                }
                                                                let _e7696 = phi_4615_;
                                                                let _e7698 = phi_4616_;
                                                                phi_4617_ = _e7696;
                                                                phi_4618_ = _e7698;
                                                            }
                                                            let _e7700 = phi_4617_;
                                                            let _e7702 = phi_4618_;
                                                            phi_4619_ = _e7700;
                                                            phi_4620_ = _e7682;
                                                            phi_4621_ = _e7702;
                                                        } else {
                                                            phi_4619_ = f64();
                                                            phi_4620_ = true;
                                                            phi_4621_ = false;
                                                        }
                                                        let _e7704 = phi_4619_;
                                                        let _e7706 = phi_4620_;
                                                        let _e7708 = phi_4621_;
                                                        if _e7706 {
                                                            phi_4626_ = f64(2f);
                                                            phi_4627_ = true;
                                                        } else {
                                                            phi_4626_ = _e6921;
                                                            phi_4627_ = _e7708;
                                                        }
                                                        let _e7711 = phi_4626_;
                                                        let _e7713 = phi_4627_;
                                                        if _e7713 {
                                                            phi_4631_ = _e7711;
                                                        } else {
                                                            phi_4631_ = _e7704;
                                                        }
                                                        let _e7715 = phi_4631_;
                                                        if (_e7666 < _e7715) {
                                                            phi_4636_ = _e7666;
                                                        } else {
                                                            phi_4636_ = _e7715;
                                                        }
                                                        let _e7718 = phi_4636_;
                                                        if (_e7617 < _e7718) {
                                                            phi_4641_ = _e7617;
                                                        } else {
                                                            phi_4641_ = _e7718;
                                                        }
                                                        let _e7721 = phi_4641_;
                                                        if (_e7721 > _e6921) {
                                                            phi_4646_ = _e7721;
                                                        } else {
                                                            phi_4646_ = _e6921;
                                                        }
                                                        let _e7724 = phi_4646_;
                                                        let _e7725 = (_e7724 > _e436);
                                                        if _e7725 {
                                                            phi_5163_ = f64();
                                                            phi_5164_ = f64();
                                                            phi_5165_ = false;
                                                            phi_5166_ = false;
                                                        } else {
                                                            let _e7726 = (_e7724 - _e6921);
                                                            let _e7727 = (_e7726 <= _e6910);
                                                            let _e7730 = (_e7724 + (_e418 * f64(0.01f)));
                                                            if (_e7730 < _e436) {
                                                                phi_4660_ = _e7730;
                                                            } else {
                                                                phi_4660_ = _e436;
                                                            }
                                                            let _e7733 = phi_4660_;
                                                            if _e7727 {
                                                                if (_e640.member_1 > f64(0f)) {
                                                                    let _e7738 = local_18.member[0u];
                                                                    let _e7744 = local_18.member[1u];
                                                                    let _e7760 = local_18.member_1[0u];
                                                                    let _e7766 = local_18.member_1[1u];
                                                                    let _e7782 = local_18.member_2[0u];
                                                                    let _e7788 = local_18.member_2[1u];
                                                                    let _e7802 = function_3(array<f64, 3>((_e7738[0] + ((_e7744[0] - _e7738[0]) * _e7733)), (_e7738[1] + ((_e7744[1] - _e7738[1]) * _e7733)), (_e7738[2] + ((_e7744[2] - _e7738[2]) * _e7733))), array<f64, 3>((_e7760[0] + ((_e7766[0] - _e7760[0]) * _e7733)), (_e7760[1] + ((_e7766[1] - _e7760[1]) * _e7733)), (_e7760[2] + ((_e7766[2] - _e7760[2]) * _e7733))), array<f64, 3>((_e7782[0] + ((_e7788[0] - _e7782[0]) * _e7733)), (_e7782[1] + ((_e7788[1] - _e7782[1]) * _e7733)), (_e7782[2] + ((_e7788[2] - _e7782[2]) * _e7733))), 0u);
                                                                    let _e7813 = (((_e7802[0] * _e7802[0]) + (_e7802[1] * _e7802[1])) + (_e7802[2] * _e7802[2]));
                                                                    if (_e7813 <= 2.2250738585072014e-308lf) {
                                                                        if (_e7813 > 0.0lf) {
                                                                            phi_4791_ = (1.464336215552873e-154lf * 2.0lf);
                                                                        } else {
                                                                            phi_4791_ = 0.0lf;
                                                                        }
                                                                        let _e7865 = phi_4791_;
                                                                        phi_4855_ = _e7865;
                                                                    } else {
                                                                        phi_4798_ = type_16(0i, 5i);
                                                                        phi_4801_ = bitcast<f64>(((bitcast<u64>(_e7813) / 2lu) + 2303426169912950784lu));
                                                                        loop {
                                                                            let _e7820 = phi_4798_;
                                                                            let _e7822 = phi_4801_;
                                                                            local_42 = _e7822;
                                                                            if (_e7820.member < _e7820.member_1) {
                                                                                let _e7829 = (_e7820.member + 1i);
                                                                                if ((false == (_e7829 > _e7820.member)) != false) {
                                                                                    phi_4822_ = true;
                                                                                } else {
                                                                                    phi_4822_ = false;
                                                                                }
                                                                                let _e7834 = phi_4822_;
                                                                                if _e7834 {
                                                                                    phi_4828_ = type_17(0u, type_17().member_1);
                                                                                } else {
                                                                                    phi_4828_ = type_17(1u, _e7829);
                                                                                }
                                                                                let _e7839 = phi_4828_;
                                                                                phi_4799_ = type_16(_e7839.member_1, _e7820.member_1);
                                                                                phi_4842_ = type_17(1u, _e7820.member);
                                                                            } else {
                                                                                phi_4799_ = _e7820;
                                                                                phi_4842_ = type_17(0u, type_17().member_1);
                                                                            }
                                                                            let _e7845 = phi_4799_;
                                                                            let _e7847 = phi_4842_;
                                                                            let _e7850 = (bitcast<i32>(_e7847.member) != 0i);
                                                                            if _e7850 {
                                                                                phi_4802_ = (0.5lf * (_e7822 + (_e7813 / _e7822)));
                                                                            } else {
                                                                                phi_4802_ = f64();
                                                                            }
                                                                            let _e7855 = phi_4802_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_4798_ = _e7845;
                                                                                phi_4801_ = _e7855;
                                                                                break if !(_e7850);
                                                                            }
                                                                        }
                                                                        let _e7860 = local_42;
                                                                        phi_4855_ = (_e7860 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                    }
                                                                    let _e7867 = phi_4855_;
                                                                    let _e7875 = local_18.member[0u];
                                                                    if (_e7875[0] < 0.0lf) {
                                                                        phi_4873_ = -(_e7875[0]);
                                                                    } else {
                                                                        phi_4873_ = _e7875[0];
                                                                    }
                                                                    let _e7882 = phi_4873_;
                                                                    if (_e7875[1] < 0.0lf) {
                                                                        phi_4880_ = -(_e7875[1]);
                                                                    } else {
                                                                        phi_4880_ = _e7875[1];
                                                                    }
                                                                    let _e7886 = phi_4880_;
                                                                    if (_e7882 > _e7886) {
                                                                        phi_4885_ = _e7882;
                                                                    } else {
                                                                        phi_4885_ = _e7886;
                                                                    }
                                                                    let _e7889 = phi_4885_;
                                                                    if (_e7875[2] < 0.0lf) {
                                                                        phi_4892_ = -(_e7875[2]);
                                                                    } else {
                                                                        phi_4892_ = _e7875[2];
                                                                    }
                                                                    let _e7893 = phi_4892_;
                                                                    if (_e7889 > _e7893) {
                                                                        phi_4897_ = _e7889;
                                                                    } else {
                                                                        phi_4897_ = _e7893;
                                                                    }
                                                                    let _e7896 = phi_4897_;
                                                                    let _e7899 = local_18.member[1u];
                                                                    if (_e7899[0] < 0.0lf) {
                                                                        phi_4910_ = -(_e7899[0]);
                                                                    } else {
                                                                        phi_4910_ = _e7899[0];
                                                                    }
                                                                    let _e7906 = phi_4910_;
                                                                    if (_e7899[1] < 0.0lf) {
                                                                        phi_4917_ = -(_e7899[1]);
                                                                    } else {
                                                                        phi_4917_ = _e7899[1];
                                                                    }
                                                                    let _e7910 = phi_4917_;
                                                                    if (_e7906 > _e7910) {
                                                                        phi_4922_ = _e7906;
                                                                    } else {
                                                                        phi_4922_ = _e7910;
                                                                    }
                                                                    let _e7913 = phi_4922_;
                                                                    if (_e7899[2] < 0.0lf) {
                                                                        phi_4929_ = -(_e7899[2]);
                                                                    } else {
                                                                        phi_4929_ = _e7899[2];
                                                                    }
                                                                    let _e7917 = phi_4929_;
                                                                    if (_e7913 > _e7917) {
                                                                        phi_4934_ = _e7913;
                                                                    } else {
                                                                        phi_4934_ = _e7917;
                                                                    }
                                                                    let _e7920 = phi_4934_;
                                                                    if (_e7896 > _e7920) {
                                                                        phi_4939_ = _e7896;
                                                                    } else {
                                                                        phi_4939_ = _e7920;
                                                                    }
                                                                    let _e7923 = phi_4939_;
                                                                    let _e7925 = local_18.member_3;
                                                                    let _e7929 = local_18.member_1[0u];
                                                                    if (_e7929[0] < 0.0lf) {
                                                                        phi_4956_ = -(_e7929[0]);
                                                                    } else {
                                                                        phi_4956_ = _e7929[0];
                                                                    }
                                                                    let _e7936 = phi_4956_;
                                                                    if (_e7929[1] < 0.0lf) {
                                                                        phi_4963_ = -(_e7929[1]);
                                                                    } else {
                                                                        phi_4963_ = _e7929[1];
                                                                    }
                                                                    let _e7940 = phi_4963_;
                                                                    if (_e7936 > _e7940) {
                                                                        phi_4968_ = _e7936;
                                                                    } else {
                                                                        phi_4968_ = _e7940;
                                                                    }
                                                                    let _e7943 = phi_4968_;
                                                                    if (_e7929[2] < 0.0lf) {
                                                                        phi_4975_ = -(_e7929[2]);
                                                                    } else {
                                                                        phi_4975_ = _e7929[2];
                                                                    }
                                                                    let _e7947 = phi_4975_;
                                                                    if (_e7943 > _e7947) {
                                                                        phi_4980_ = _e7943;
                                                                    } else {
                                                                        phi_4980_ = _e7947;
                                                                    }
                                                                    let _e7950 = phi_4980_;
                                                                    let _e7953 = local_18.member_1[1u];
                                                                    if (_e7953[0] < 0.0lf) {
                                                                        phi_4994_ = -(_e7953[0]);
                                                                    } else {
                                                                        phi_4994_ = _e7953[0];
                                                                    }
                                                                    let _e7960 = phi_4994_;
                                                                    if (_e7953[1] < 0.0lf) {
                                                                        phi_5001_ = -(_e7953[1]);
                                                                    } else {
                                                                        phi_5001_ = _e7953[1];
                                                                    }
                                                                    let _e7964 = phi_5001_;
                                                                    if (_e7960 > _e7964) {
                                                                        phi_5006_ = _e7960;
                                                                    } else {
                                                                        phi_5006_ = _e7964;
                                                                    }
                                                                    let _e7967 = phi_5006_;
                                                                    if (_e7953[2] < 0.0lf) {
                                                                        phi_5013_ = -(_e7953[2]);
                                                                    } else {
                                                                        phi_5013_ = _e7953[2];
                                                                    }
                                                                    let _e7971 = phi_5013_;
                                                                    if (_e7967 > _e7971) {
                                                                        phi_5018_ = _e7967;
                                                                    } else {
                                                                        phi_5018_ = _e7971;
                                                                    }
                                                                    let _e7974 = phi_5018_;
                                                                    if (_e7950 > _e7974) {
                                                                        phi_5023_ = _e7950;
                                                                    } else {
                                                                        phi_5023_ = _e7974;
                                                                    }
                                                                    let _e7977 = phi_5023_;
                                                                    let _e7979 = local_18.member_3;
                                                                    let _e7983 = local_18.member_2[0u];
                                                                    if (_e7983[0] < 0.0lf) {
                                                                        phi_5040_ = -(_e7983[0]);
                                                                    } else {
                                                                        phi_5040_ = _e7983[0];
                                                                    }
                                                                    let _e7990 = phi_5040_;
                                                                    if (_e7983[1] < 0.0lf) {
                                                                        phi_5047_ = -(_e7983[1]);
                                                                    } else {
                                                                        phi_5047_ = _e7983[1];
                                                                    }
                                                                    let _e7994 = phi_5047_;
                                                                    if (_e7990 > _e7994) {
                                                                        phi_5052_ = _e7990;
                                                                    } else {
                                                                        phi_5052_ = _e7994;
                                                                    }
                                                                    let _e7997 = phi_5052_;
                                                                    if (_e7983[2] < 0.0lf) {
                                                                        phi_5059_ = -(_e7983[2]);
                                                                    } else {
                                                                        phi_5059_ = _e7983[2];
                                                                    }
                                                                    let _e8001 = phi_5059_;
                                                                    if (_e7997 > _e8001) {
                                                                        phi_5064_ = _e7997;
                                                                    } else {
                                                                        phi_5064_ = _e8001;
                                                                    }
                                                                    let _e8004 = phi_5064_;
                                                                    let _e8007 = local_18.member_2[1u];
                                                                    if (_e8007[0] < 0.0lf) {
                                                                        phi_5078_ = -(_e8007[0]);
                                                                    } else {
                                                                        phi_5078_ = _e8007[0];
                                                                    }
                                                                    let _e8014 = phi_5078_;
                                                                    if (_e8007[1] < 0.0lf) {
                                                                        phi_5085_ = -(_e8007[1]);
                                                                    } else {
                                                                        phi_5085_ = _e8007[1];
                                                                    }
                                                                    let _e8018 = phi_5085_;
                                                                    if (_e8014 > _e8018) {
                                                                        phi_5090_ = _e8014;
                                                                    } else {
                                                                        phi_5090_ = _e8018;
                                                                    }
                                                                    let _e8021 = phi_5090_;
                                                                    if (_e8007[2] < 0.0lf) {
                                                                        phi_5097_ = -(_e8007[2]);
                                                                    } else {
                                                                        phi_5097_ = _e8007[2];
                                                                    }
                                                                    let _e8025 = phi_5097_;
                                                                    if (_e8021 > _e8025) {
                                                                        phi_5102_ = _e8021;
                                                                    } else {
                                                                        phi_5102_ = _e8025;
                                                                    }
                                                                    let _e8028 = phi_5102_;
                                                                    if (_e8004 > _e8028) {
                                                                        phi_5107_ = _e8004;
                                                                    } else {
                                                                        phi_5107_ = _e8028;
                                                                    }
                                                                    let _e8031 = phi_5107_;
                                                                    let _e8033 = local_18.member_3;
                                                                    let _e8041 = local_18.member_3;
                                                                    if (((_e7867 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e7923 + _e7925) + (_e7977 + _e7979)) + (_e8031 + _e8033)) * (1.1102230246251565e-16lf * f64(16f))) + (_e8041 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e640.member_1) {
                                                                        phi_5131_ = false;
                                                                    } else {
                                                                        phi_5131_ = true;
                                                                    }
                                                                    let _e8053 = phi_5131_;
                                                                    phi_5132_ = _e8053;
                                                                } else {
                                                                    phi_5132_ = true;
                                                                }
                                                                let _e8055 = phi_5132_;
                                                                phi_5133_ = _e8055;
                                                            } else {
                                                                phi_5133_ = true;
                                                            }
                                                            let _e8057 = phi_5133_;
                                                            if _e8057 {
                                                                if _e6929 {
                                                                    if _e7727 {
                                                                        phi_5152_ = f64();
                                                                        phi_5153_ = true;
                                                                    } else {
                                                                        if (_e7726 <= (_e6925 * f64(0.25f))) {
                                                                            phi_5150_ = f64(0f);
                                                                            phi_5151_ = false;
                                                                        } else {
                                                                            phi_5150_ = f64();
                                                                            phi_5151_ = true;
                                                                        }
                                                                        let _e8064 = phi_5150_;
                                                                        let _e8066 = phi_5151_;
                                                                        phi_5152_ = _e8064;
                                                                        phi_5153_ = _e8066;
                                                                    }
                                                                    let _e8068 = phi_5152_;
                                                                    let _e8070 = phi_5153_;
                                                                    if _e8070 {
                                                                        phi_5158_ = (_e7254 + _e7254);
                                                                    } else {
                                                                        phi_5158_ = _e8068;
                                                                    }
                                                                    let _e8073 = phi_5158_;
                                                                    phi_5160_ = _e8073;
                                                                } else {
                                                                    phi_5160_ = (_e436 - _e6921);
                                                                }
                                                                let _e8075 = phi_5160_;
                                                                phi_5161_ = _e8075;
                                                                phi_5162_ = false;
                                                            } else {
                                                                phi_5161_ = f64();
                                                                phi_5162_ = true;
                                                            }
                                                            let _e8077 = phi_5161_;
                                                            let _e8079 = phi_5162_;
                                                            phi_5163_ = _e8077;
                                                            phi_5164_ = _e7726;
                                                            phi_5165_ = _e8057;
                                                            phi_5166_ = _e8079;
                                                        }
                                                        let _e8081 = phi_5163_;
                                                        let _e8083 = phi_5164_;
                                                        let _e8085 = phi_5165_;
                                                        let _e8087 = phi_5166_;
                                                        phi_5167_ = _e7724;
                                                        phi_5168_ = _e8081;
                                                        phi_5169_ = _e8083;
                                                        phi_5170_ = _e7724;
                                                        phi_5171_ = _e8085;
                                                        phi_5172_ = _e7725;
                                                        phi_5173_ = _e8087;
                                                        phi_5174_ = false;
                                                    } else {
                                                        phi_5167_ = f64();
                                                        phi_5168_ = f64();
                                                        phi_5169_ = f64();
                                                        phi_5170_ = f64();
                                                        phi_5171_ = false;
                                                        phi_5172_ = false;
                                                        phi_5173_ = false;
                                                        phi_5174_ = true;
                                                    }
                                                    let _e8089 = phi_5167_;
                                                    let _e8091 = phi_5168_;
                                                    let _e8093 = phi_5169_;
                                                    let _e8095 = phi_5170_;
                                                    let _e8097 = phi_5171_;
                                                    let _e8099 = phi_5172_;
                                                    let _e8101 = phi_5173_;
                                                    let _e8103 = phi_5174_;
                                                    phi_5175_ = _e8089;
                                                    phi_5176_ = _e8091;
                                                    phi_5177_ = _e8093;
                                                    phi_5178_ = _e8095;
                                                    phi_5179_ = false;
                                                    phi_5180_ = _e8097;
                                                    phi_5181_ = _e8099;
                                                    phi_5182_ = _e8101;
                                                    phi_5183_ = _e8103;
                                                } else {
                                                    phi_5175_ = f64();
                                                    phi_5176_ = f64();
                                                    phi_5177_ = f64();
                                                    phi_5178_ = f64();
                                                    phi_5179_ = true;
                                                    phi_5180_ = false;
                                                    phi_5181_ = false;
                                                    phi_5182_ = false;
                                                    phi_5183_ = false;
                                                }
                                                let _e8105 = phi_5175_;
                                                let _e8107 = phi_5176_;
                                                let _e8109 = phi_5177_;
                                                let _e8111 = phi_5178_;
                                                let _e8113 = phi_5179_;
                                                let _e8115 = phi_5180_;
                                                let _e8117 = phi_5181_;
                                                let _e8119 = phi_5182_;
                                                let _e8121 = phi_5183_;
                                                phi_5184_ = _e8105;
                                                phi_5185_ = _e8107;
                                                phi_5186_ = _e8109;
                                                phi_5187_ = _e8111;
                                                phi_5188_ = _e8113;
                                                phi_5189_ = _e8115;
                                                phi_5190_ = _e8117;
                                                phi_5191_ = _e8119;
                                                phi_5192_ = _e8121;
                                            } else {
                                                phi_5184_ = f64();
                                                phi_5185_ = f64();
                                                phi_5186_ = f64();
                                                phi_5187_ = f64();
                                                phi_5188_ = true;
                                                phi_5189_ = false;
                                                phi_5190_ = false;
                                                phi_5191_ = false;
                                                phi_5192_ = false;
                                            }
                                            let _e8123 = phi_5184_;
                                            let _e8125 = phi_5185_;
                                            let _e8127 = phi_5186_;
                                            let _e8129 = phi_5187_;
                                            let _e8131 = phi_5188_;
                                            let _e8133 = phi_5189_;
                                            let _e8135 = phi_5190_;
                                            let _e8137 = phi_5191_;
                                            let _e8139 = phi_5192_;
                                            if _e8131 {
                                                if (_e6921 <= _e6923) {
                                                    let _e8305 = (_e6931 + 1u);
                                                    let _e8306 = (_e8305 > 3u);
                                                    if _e8306 {
                                                        phi_5205_ = false;
                                                    } else {
                                                        phi_5205_ = true;
                                                    }
                                                    let _e8308 = phi_5205_;
                                                    phi_5532_ = _e8305;
                                                    phi_5533_ = f64();
                                                    phi_5534_ = false;
                                                    phi_5535_ = _e8308;
                                                    phi_5536_ = _e8306;
                                                } else {
                                                    let _e8143 = local_16.member[0u];
                                                    let _e8146 = local_16.member_1[0u];
                                                    let _e8149 = local_16.member[0u];
                                                    let _e8155 = local_16.member_2[0u];
                                                    let _e8156 = ((_e8143 + ((_e8146 - _e8149) * _e6927)) - _e8155);
                                                    let _e8159 = local_16.member[1u];
                                                    let _e8162 = local_16.member_1[1u];
                                                    let _e8165 = local_16.member[1u];
                                                    let _e8171 = local_16.member_2[1u];
                                                    let _e8172 = ((_e8159 + ((_e8162 - _e8165) * _e6927)) - _e8171);
                                                    if (_e8156 < _e8172) {
                                                        phi_5278_ = _e8156;
                                                    } else {
                                                        phi_5278_ = _e8172;
                                                    }
                                                    let _e8175 = phi_5278_;
                                                    let _e8178 = local_16.member[2u];
                                                    let _e8181 = local_16.member_1[2u];
                                                    let _e8184 = local_16.member[2u];
                                                    let _e8190 = local_16.member_2[2u];
                                                    let _e8191 = ((_e8178 + ((_e8181 - _e8184) * _e6927)) - _e8190);
                                                    let _e8194 = local_16.member[3u];
                                                    let _e8197 = local_16.member_1[3u];
                                                    let _e8200 = local_16.member[3u];
                                                    let _e8206 = local_16.member_2[3u];
                                                    let _e8207 = ((_e8194 + ((_e8197 - _e8200) * _e6927)) - _e8206);
                                                    if (_e8191 < _e8207) {
                                                        phi_5351_ = _e8191;
                                                    } else {
                                                        phi_5351_ = _e8207;
                                                    }
                                                    let _e8210 = phi_5351_;
                                                    if (_e8175 < _e8210) {
                                                        phi_5356_ = _e8175;
                                                    } else {
                                                        phi_5356_ = _e8210;
                                                    }
                                                    let _e8213 = phi_5356_;
                                                    let _e8216 = local_17.member[0u];
                                                    let _e8219 = local_17.member_1[0u];
                                                    let _e8222 = local_17.member[0u];
                                                    let _e8228 = local_17.member_2[0u];
                                                    let _e8229 = ((_e8216 + ((_e8219 - _e8222) * _e6921)) - _e8228);
                                                    let _e8232 = local_17.member[1u];
                                                    let _e8235 = local_17.member_1[1u];
                                                    let _e8238 = local_17.member[1u];
                                                    let _e8244 = local_17.member_2[1u];
                                                    let _e8245 = ((_e8232 + ((_e8235 - _e8238) * _e6921)) - _e8244);
                                                    if (_e8229 < _e8245) {
                                                        phi_5429_ = _e8229;
                                                    } else {
                                                        phi_5429_ = _e8245;
                                                    }
                                                    let _e8248 = phi_5429_;
                                                    let _e8251 = local_17.member[2u];
                                                    let _e8254 = local_17.member_1[2u];
                                                    let _e8257 = local_17.member[2u];
                                                    let _e8263 = local_17.member_2[2u];
                                                    let _e8264 = ((_e8251 + ((_e8254 - _e8257) * _e6921)) - _e8263);
                                                    let _e8267 = local_17.member[3u];
                                                    let _e8270 = local_17.member_1[3u];
                                                    let _e8273 = local_17.member[3u];
                                                    let _e8279 = local_17.member_2[3u];
                                                    let _e8280 = ((_e8267 + ((_e8270 - _e8273) * _e6921)) - _e8279);
                                                    if (_e8264 < _e8280) {
                                                        phi_5502_ = _e8264;
                                                    } else {
                                                        phi_5502_ = _e8280;
                                                    }
                                                    let _e8283 = phi_5502_;
                                                    if (_e8248 < _e8283) {
                                                        phi_5507_ = _e8248;
                                                    } else {
                                                        phi_5507_ = _e8283;
                                                    }
                                                    let _e8286 = phi_5507_;
                                                    let _e8287 = f64(0.0625f);
                                                    let _e8289 = f64(0.9f);
                                                    if (_e8286 > f64(0f)) {
                                                        phi_5530_ = f64(0.5f);
                                                    } else {
                                                        let _e8295 = (f64(0.95f) * (_e8213 / (_e8213 - _e8286)));
                                                        if (_e8295 > _e8287) {
                                                            if (_e8295 < _e8289) {
                                                                phi_5528_ = _e8295;
                                                            } else {
                                                                phi_5528_ = _e8289;
                                                            }
                                                            let _e8299 = phi_5528_;
                                                            phi_5529_ = _e8299;
                                                        } else {
                                                            phi_5529_ = _e8287;
                                                        }
                                                        let _e8301 = phi_5529_;
                                                        phi_5530_ = _e8301;
                                                    }
                                                    let _e8303 = phi_5530_;
                                                    phi_5532_ = u32();
                                                    phi_5533_ = (_e7254 * _e8303);
                                                    phi_5534_ = true;
                                                    phi_5535_ = false;
                                                    phi_5536_ = false;
                                                }
                                                let _e8310 = phi_5532_;
                                                let _e8312 = phi_5533_;
                                                let _e8314 = phi_5534_;
                                                let _e8316 = phi_5535_;
                                                let _e8318 = phi_5536_;
                                                phi_5537_ = _e8310;
                                                phi_5538_ = _e6923;
                                                phi_5539_ = _e8312;
                                                phi_5540_ = _e6925;
                                                phi_5541_ = _e6927;
                                                phi_5542_ = _e6929;
                                                phi_5543_ = _e6931;
                                                phi_5544_ = _e8314;
                                                phi_5545_ = _e8316;
                                                phi_5546_ = _e8318;
                                                phi_5547_ = false;
                                                phi_5548_ = false;
                                                phi_5549_ = false;
                                            } else {
                                                phi_5537_ = u32();
                                                phi_5538_ = _e8123;
                                                phi_5539_ = _e8125;
                                                phi_5540_ = _e8127;
                                                phi_5541_ = _e6921;
                                                phi_5542_ = true;
                                                phi_5543_ = 0u;
                                                phi_5544_ = _e8133;
                                                phi_5545_ = false;
                                                phi_5546_ = false;
                                                phi_5547_ = _e8135;
                                                phi_5548_ = _e8137;
                                                phi_5549_ = _e8139;
                                            }
                                            let _e8320 = phi_5537_;
                                            let _e8322 = phi_5538_;
                                            let _e8324 = phi_5539_;
                                            let _e8326 = phi_5540_;
                                            let _e8328 = phi_5541_;
                                            let _e8330 = phi_5542_;
                                            let _e8332 = phi_5543_;
                                            let _e8334 = phi_5544_;
                                            let _e8336 = phi_5545_;
                                            let _e8338 = phi_5546_;
                                            let _e8340 = phi_5547_;
                                            let _e8342 = phi_5548_;
                                            let _e8344 = phi_5549_;
                                            if _e8334 {
                                                let _e8345 = (_e8328 + _e8324);
                                                if (_e8345 > _e8322) {
                                                    phi_5558_ = _e8345;
                                                } else {
                                                    phi_5558_ = _e8322;
                                                }
                                                let _e8348 = phi_5558_;
                                                if (_e8348 < _e436) {
                                                    phi_5563_ = _e8348;
                                                } else {
                                                    phi_5563_ = _e436;
                                                }
                                                let _e8351 = phi_5563_;
                                                if !(_e6929) {
                                                    phi_5572_ = true;
                                                } else {
                                                    phi_5572_ = ((_e8351 - _e8328) > _e6910);
                                                }
                                                let _e8355 = phi_5572_;
                                                if _e8355 {
                                                    phi_5576_ = false;
                                                } else {
                                                    phi_5576_ = true;
                                                }
                                                let _e8357 = phi_5576_;
                                                phi_5577_ = _e8351;
                                                phi_5578_ = _e8322;
                                                phi_5579_ = _e8326;
                                                phi_5580_ = _e8328;
                                                phi_5581_ = _e8330;
                                                phi_5582_ = _e8332;
                                                phi_5583_ = _e8355;
                                                phi_5584_ = _e8357;
                                                phi_5585_ = false;
                                                phi_5586_ = false;
                                                phi_5587_ = false;
                                                phi_5588_ = false;
                                            } else {
                                                phi_5577_ = _e6921;
                                                phi_5578_ = _e6923;
                                                phi_5579_ = _e6925;
                                                phi_5580_ = _e6927;
                                                phi_5581_ = _e6929;
                                                phi_5582_ = _e8320;
                                                phi_5583_ = _e8336;
                                                phi_5584_ = false;
                                                phi_5585_ = _e8338;
                                                phi_5586_ = _e8340;
                                                phi_5587_ = _e8342;
                                                phi_5588_ = _e8344;
                                            }
                                            let _e8359 = phi_5577_;
                                            let _e8361 = phi_5578_;
                                            let _e8363 = phi_5579_;
                                            let _e8365 = phi_5580_;
                                            let _e8367 = phi_5581_;
                                            let _e8369 = phi_5582_;
                                            let _e8371 = phi_5583_;
                                            let _e8373 = phi_5584_;
                                            let _e8375 = phi_5585_;
                                            let _e8377 = phi_5586_;
                                            let _e8379 = phi_5587_;
                                            let _e8381 = phi_5588_;
                                            phi_3367_ = _e8359;
                                            phi_3369_ = _e8361;
                                            phi_3371_ = _e8363;
                                            phi_3373_ = _e8365;
                                            phi_3375_ = _e8367;
                                            phi_3377_ = _e8369;
                                            phi_5589_ = _e8322;
                                            phi_5590_ = _e8129;
                                            phi_5591_ = _e8371;
                                            phi_5592_ = _e8373;
                                            phi_5593_ = _e8375;
                                            phi_5594_ = _e8377;
                                            phi_5595_ = _e8379;
                                            phi_5596_ = false;
                                            phi_5597_ = _e8381;
                                        } else {
                                            phi_3367_ = f64();
                                            phi_3369_ = f64();
                                            phi_3371_ = f64();
                                            phi_3373_ = f64();
                                            phi_3375_ = bool();
                                            phi_3377_ = u32();
                                            phi_5589_ = f64();
                                            phi_5590_ = f64();
                                            phi_5591_ = false;
                                            phi_5592_ = false;
                                            phi_5593_ = false;
                                            phi_5594_ = false;
                                            phi_5595_ = false;
                                            phi_5596_ = true;
                                            phi_5597_ = false;
                                        }
                                        let _e8383 = phi_3367_;
                                        let _e8385 = phi_3369_;
                                        let _e8387 = phi_3371_;
                                        let _e8389 = phi_3373_;
                                        let _e8391 = phi_3375_;
                                        let _e8393 = phi_3377_;
                                        let _e8395 = phi_5589_;
                                        let _e8397 = phi_5590_;
                                        let _e8399 = phi_5591_;
                                        let _e8401 = phi_5592_;
                                        let _e8403 = phi_5593_;
                                        let _e8405 = phi_5594_;
                                        let _e8407 = phi_5595_;
                                        let _e8409 = phi_5596_;
                                        let _e8411 = phi_5597_;
                                        local_43 = _e8401;
                                        local_81 = _e8403;
                                        local_82 = _e8405;
                                        local_83 = _e8407;
                                        local_84 = _e8409;
                                        local_85 = _e8411;
                                        local_86 = _e8401;
                                        local_87 = _e8397;
                                        local_88 = _e8395;
                                        continue;
                                        continuing {
                                            phi_3363_ = _e6943;
                                            phi_3366_ = _e8383;
                                            phi_3368_ = _e8385;
                                            phi_3370_ = _e8387;
                                            phi_3372_ = _e8389;
                                            phi_3374_ = _e8391;
                                            phi_3376_ = _e8393;
                                            break if !(_e8399);
                                        }
                                    }
                                    let _e8414 = local_43;
                                    if _e8414 {
                                        phi_5601_ = false;
                                        phi_5602_ = false;
                                        phi_5603_ = false;
                                        phi_5604_ = false;
                                        phi_5605_ = false;
                                    } else {
                                        let _e11882 = local_81;
                                        phi_5601_ = _e11882;
                                        let _e11885 = local_82;
                                        phi_5602_ = _e11885;
                                        let _e11888 = local_83;
                                        phi_5603_ = _e11888;
                                        let _e11891 = local_84;
                                        phi_5604_ = _e11891;
                                        let _e11894 = local_85;
                                        phi_5605_ = _e11894;
                                    }
                                    let _e8416 = phi_5601_;
                                    let _e8418 = phi_5602_;
                                    let _e8420 = phi_5603_;
                                    let _e8422 = phi_5604_;
                                    let _e8424 = phi_5605_;
                                    if _e8416 {
                                        let _e8426 = local_44;
                                        phi_5610_ = type_46(1u, _e8426);
                                        phi_5611_ = false;
                                        phi_5612_ = false;
                                        phi_5613_ = false;
                                        phi_5614_ = false;
                                        phi_5615_ = false;
                                    } else {
                                        phi_5610_ = type_46();
                                        phi_5611_ = _e8418;
                                        phi_5612_ = _e8420;
                                        let _e11901 = local_86;
                                        phi_5613_ = _e11901;
                                        phi_5614_ = _e8422;
                                        phi_5615_ = _e8424;
                                    }
                                    let _e8429 = phi_5610_;
                                    let _e8431 = phi_5611_;
                                    let _e8433 = phi_5612_;
                                    let _e8435 = phi_5613_;
                                    let _e8437 = phi_5614_;
                                    let _e8439 = phi_5615_;
                                    if _e8431 {
                                        phi_5620_ = type_46(0u, type_46().member_1);
                                        phi_5621_ = false;
                                        phi_5622_ = false;
                                        phi_5623_ = false;
                                        phi_5624_ = false;
                                        phi_5625_ = true;
                                    } else {
                                        phi_5620_ = _e8429;
                                        phi_5621_ = _e8433;
                                        phi_5622_ = _e8435;
                                        phi_5623_ = _e8437;
                                        phi_5624_ = _e8439;
                                        phi_5625_ = _e8416;
                                    }
                                    let _e8443 = phi_5620_;
                                    let _e8445 = phi_5621_;
                                    let _e8447 = phi_5622_;
                                    let _e8449 = phi_5623_;
                                    let _e8451 = phi_5624_;
                                    let _e8453 = phi_5625_;
                                    if _e8445 {
                                        let _e11912 = local_87;
                                        phi_5629_ = _e11912;
                                        phi_5630_ = true;
                                        phi_5631_ = false;
                                        phi_5632_ = false;
                                        phi_5633_ = false;
                                    } else {
                                        let _e11914 = local_88;
                                        phi_5629_ = _e11914;
                                        phi_5630_ = _e8447;
                                        phi_5631_ = _e8449;
                                        phi_5632_ = _e8451;
                                        phi_5633_ = _e8453;
                                    }
                                    let _e8455 = phi_5629_;
                                    let _e8457 = phi_5630_;
                                    let _e8459 = phi_5631_;
                                    let _e8461 = phi_5632_;
                                    let _e8463 = phi_5633_;
                                    if _e8457 {
                                        phi_5637_ = _e8455;
                                        phi_5638_ = true;
                                        phi_5639_ = false;
                                        phi_5640_ = false;
                                    } else {
                                        let _e11921 = local_89;
                                        phi_5637_ = _e11921;
                                        phi_5638_ = _e8459;
                                        phi_5639_ = _e8461;
                                        phi_5640_ = _e8463;
                                    }
                                    let _e8465 = phi_5637_;
                                    let _e8467 = phi_5638_;
                                    let _e8469 = phi_5639_;
                                    let _e8471 = phi_5640_;
                                    if _e8467 {
                                        phi_5645_ = type_46(1u, _e8465);
                                        phi_5646_ = false;
                                        phi_5647_ = false;
                                    } else {
                                        phi_5645_ = type_46();
                                        phi_5646_ = _e8469;
                                        phi_5647_ = _e8471;
                                    }
                                    let _e8474 = phi_5645_;
                                    let _e8476 = phi_5646_;
                                    let _e8478 = phi_5647_;
                                    if _e8476 {
                                        phi_5652_ = type_46(0u, type_46().member_1);
                                        phi_5653_ = true;
                                    } else {
                                        phi_5652_ = _e8443;
                                        phi_5653_ = _e8478;
                                    }
                                    let _e8482 = phi_5652_;
                                    let _e8484 = phi_5653_;
                                    if _e8484 {
                                        phi_5657_ = _e8482;
                                    } else {
                                        phi_5657_ = _e8474;
                                    }
                                    let _e8486 = phi_5657_;
                                    phi_5664_ = _e8486.member_1;
                                    phi_5665_ = (_e8486.member != 0u);
                                } else {
                                    phi_5664_ = _e6647;
                                    phi_5665_ = true;
                                }
                                let _e8491 = phi_5664_;
                                let _e8493 = phi_5665_;
                                if _e8493 {
                                    let _e8494 = (_e8491 > _e427);
                                    if _e8494 {
                                        phi_7872_ = f64();
                                        phi_7873_ = u32();
                                        phi_7874_ = f64();
                                        phi_7875_ = type_48();
                                        phi_7876_ = u32();
                                        phi_7877_ = u32();
                                        phi_7878_ = false;
                                        phi_7879_ = false;
                                        phi_7880_ = false;
                                    } else {
                                        let _e8498 = local_18.member[0u];
                                        let _e8504 = local_18.member[1u];
                                        let _e8520 = local_18.member_1[0u];
                                        let _e8526 = local_18.member_1[1u];
                                        let _e8542 = local_18.member_2[0u];
                                        let _e8548 = local_18.member_2[1u];
                                        let _e8562 = function_3(array<f64, 3>((_e8498[0] + ((_e8504[0] - _e8498[0]) * _e6651)), (_e8498[1] + ((_e8504[1] - _e8498[1]) * _e6651)), (_e8498[2] + ((_e8504[2] - _e8498[2]) * _e6651))), array<f64, 3>((_e8520[0] + ((_e8526[0] - _e8520[0]) * _e6651)), (_e8520[1] + ((_e8526[1] - _e8520[1]) * _e6651)), (_e8520[2] + ((_e8526[2] - _e8520[2]) * _e6651))), array<f64, 3>((_e8542[0] + ((_e8548[0] - _e8542[0]) * _e6651)), (_e8542[1] + ((_e8548[1] - _e8542[1]) * _e6651)), (_e8542[2] + ((_e8548[2] - _e8542[2]) * _e6651))), 0u);
                                        if (_e8562[0] < 0.0lf) {
                                            phi_5778_ = -(_e8562[0]);
                                        } else {
                                            phi_5778_ = _e8562[0];
                                        }
                                        let _e8567 = phi_5778_;
                                        if (_e8562[1] < 0.0lf) {
                                            phi_5785_ = -(_e8562[1]);
                                        } else {
                                            phi_5785_ = _e8562[1];
                                        }
                                        let _e8572 = phi_5785_;
                                        if (_e8562[2] < 0.0lf) {
                                            phi_5793_ = -(_e8562[2]);
                                        } else {
                                            phi_5793_ = _e8562[2];
                                        }
                                        let _e8578 = phi_5793_;
                                        let _e8579 = ((_e8567 + _e8572) + _e8578);
                                        let _e8582 = local_18.member[0u];
                                        let _e8588 = local_18.member_1[0u];
                                        let _e8594 = local_18.member_2[0u];
                                        let _e8606 = local_18.member[1u];
                                        let _e8612 = local_18.member_1[1u];
                                        let _e8618 = local_18.member_2[1u];
                                        let _e8630 = local_18.member[0u];
                                        if (_e8630[0] < 0.0lf) {
                                            phi_5944_ = -(_e8630[0]);
                                        } else {
                                            phi_5944_ = _e8630[0];
                                        }
                                        let _e8637 = phi_5944_;
                                        if (_e8630[1] < 0.0lf) {
                                            phi_5951_ = -(_e8630[1]);
                                        } else {
                                            phi_5951_ = _e8630[1];
                                        }
                                        let _e8641 = phi_5951_;
                                        if (_e8637 > _e8641) {
                                            phi_5956_ = _e8637;
                                        } else {
                                            phi_5956_ = _e8641;
                                        }
                                        let _e8644 = phi_5956_;
                                        if (_e8630[2] < 0.0lf) {
                                            phi_5963_ = -(_e8630[2]);
                                        } else {
                                            phi_5963_ = _e8630[2];
                                        }
                                        let _e8648 = phi_5963_;
                                        if (_e8644 > _e8648) {
                                            phi_5968_ = _e8644;
                                        } else {
                                            phi_5968_ = _e8648;
                                        }
                                        let _e8651 = phi_5968_;
                                        let _e8654 = local_18.member[1u];
                                        if (_e8654[0] < 0.0lf) {
                                            phi_5981_ = -(_e8654[0]);
                                        } else {
                                            phi_5981_ = _e8654[0];
                                        }
                                        let _e8661 = phi_5981_;
                                        if (_e8654[1] < 0.0lf) {
                                            phi_5988_ = -(_e8654[1]);
                                        } else {
                                            phi_5988_ = _e8654[1];
                                        }
                                        let _e8665 = phi_5988_;
                                        if (_e8661 > _e8665) {
                                            phi_5993_ = _e8661;
                                        } else {
                                            phi_5993_ = _e8665;
                                        }
                                        let _e8668 = phi_5993_;
                                        if (_e8654[2] < 0.0lf) {
                                            phi_6000_ = -(_e8654[2]);
                                        } else {
                                            phi_6000_ = _e8654[2];
                                        }
                                        let _e8672 = phi_6000_;
                                        if (_e8668 > _e8672) {
                                            phi_6005_ = _e8668;
                                        } else {
                                            phi_6005_ = _e8672;
                                        }
                                        let _e8675 = phi_6005_;
                                        if (_e8651 > _e8675) {
                                            phi_6010_ = _e8651;
                                        } else {
                                            phi_6010_ = _e8675;
                                        }
                                        let _e8678 = phi_6010_;
                                        let _e8680 = local_18.member_3;
                                        let _e8684 = local_18.member_1[0u];
                                        if (_e8684[0] < 0.0lf) {
                                            phi_6027_ = -(_e8684[0]);
                                        } else {
                                            phi_6027_ = _e8684[0];
                                        }
                                        let _e8691 = phi_6027_;
                                        if (_e8684[1] < 0.0lf) {
                                            phi_6034_ = -(_e8684[1]);
                                        } else {
                                            phi_6034_ = _e8684[1];
                                        }
                                        let _e8695 = phi_6034_;
                                        if (_e8691 > _e8695) {
                                            phi_6039_ = _e8691;
                                        } else {
                                            phi_6039_ = _e8695;
                                        }
                                        let _e8698 = phi_6039_;
                                        if (_e8684[2] < 0.0lf) {
                                            phi_6046_ = -(_e8684[2]);
                                        } else {
                                            phi_6046_ = _e8684[2];
                                        }
                                        let _e8702 = phi_6046_;
                                        if (_e8698 > _e8702) {
                                            phi_6051_ = _e8698;
                                        } else {
                                            phi_6051_ = _e8702;
                                        }
                                        let _e8705 = phi_6051_;
                                        let _e8708 = local_18.member_1[1u];
                                        if (_e8708[0] < 0.0lf) {
                                            phi_6065_ = -(_e8708[0]);
                                        } else {
                                            phi_6065_ = _e8708[0];
                                        }
                                        let _e8715 = phi_6065_;
                                        if (_e8708[1] < 0.0lf) {
                                            phi_6072_ = -(_e8708[1]);
                                        } else {
                                            phi_6072_ = _e8708[1];
                                        }
                                        let _e8719 = phi_6072_;
                                        if (_e8715 > _e8719) {
                                            phi_6077_ = _e8715;
                                        } else {
                                            phi_6077_ = _e8719;
                                        }
                                        let _e8722 = phi_6077_;
                                        if (_e8708[2] < 0.0lf) {
                                            phi_6084_ = -(_e8708[2]);
                                        } else {
                                            phi_6084_ = _e8708[2];
                                        }
                                        let _e8726 = phi_6084_;
                                        if (_e8722 > _e8726) {
                                            phi_6089_ = _e8722;
                                        } else {
                                            phi_6089_ = _e8726;
                                        }
                                        let _e8729 = phi_6089_;
                                        if (_e8705 > _e8729) {
                                            phi_6094_ = _e8705;
                                        } else {
                                            phi_6094_ = _e8729;
                                        }
                                        let _e8732 = phi_6094_;
                                        let _e8734 = local_18.member_3;
                                        let _e8738 = local_18.member_2[0u];
                                        if (_e8738[0] < 0.0lf) {
                                            phi_6111_ = -(_e8738[0]);
                                        } else {
                                            phi_6111_ = _e8738[0];
                                        }
                                        let _e8745 = phi_6111_;
                                        if (_e8738[1] < 0.0lf) {
                                            phi_6118_ = -(_e8738[1]);
                                        } else {
                                            phi_6118_ = _e8738[1];
                                        }
                                        let _e8749 = phi_6118_;
                                        if (_e8745 > _e8749) {
                                            phi_6123_ = _e8745;
                                        } else {
                                            phi_6123_ = _e8749;
                                        }
                                        let _e8752 = phi_6123_;
                                        if (_e8738[2] < 0.0lf) {
                                            phi_6130_ = -(_e8738[2]);
                                        } else {
                                            phi_6130_ = _e8738[2];
                                        }
                                        let _e8756 = phi_6130_;
                                        if (_e8752 > _e8756) {
                                            phi_6135_ = _e8752;
                                        } else {
                                            phi_6135_ = _e8756;
                                        }
                                        let _e8759 = phi_6135_;
                                        let _e8762 = local_18.member_2[1u];
                                        if (_e8762[0] < 0.0lf) {
                                            phi_6149_ = -(_e8762[0]);
                                        } else {
                                            phi_6149_ = _e8762[0];
                                        }
                                        let _e8769 = phi_6149_;
                                        if (_e8762[1] < 0.0lf) {
                                            phi_6156_ = -(_e8762[1]);
                                        } else {
                                            phi_6156_ = _e8762[1];
                                        }
                                        let _e8773 = phi_6156_;
                                        if (_e8769 > _e8773) {
                                            phi_6161_ = _e8769;
                                        } else {
                                            phi_6161_ = _e8773;
                                        }
                                        let _e8776 = phi_6161_;
                                        if (_e8762[2] < 0.0lf) {
                                            phi_6168_ = -(_e8762[2]);
                                        } else {
                                            phi_6168_ = _e8762[2];
                                        }
                                        let _e8780 = phi_6168_;
                                        if (_e8776 > _e8780) {
                                            phi_6173_ = _e8776;
                                        } else {
                                            phi_6173_ = _e8780;
                                        }
                                        let _e8783 = phi_6173_;
                                        if (_e8759 > _e8783) {
                                            phi_6178_ = _e8759;
                                        } else {
                                            phi_6178_ = _e8783;
                                        }
                                        let _e8786 = phi_6178_;
                                        let _e8788 = local_18.member_3;
                                        let _e8796 = local_18.member_3;
                                        local_14 = type_44(array<array<array<f64, 3>, 4>, 2>(array<array<f64, 3>, 4>(_e8582, array<f64, 3>((_e8582[0] - _e8588[0]), (_e8582[1] - _e8588[1]), (_e8582[2] - _e8588[2])), array<f64, 3>((_e8582[0] - _e8594[0]), (_e8582[1] - _e8594[1]), (_e8582[2] - _e8594[2])), _e8582), array<array<f64, 3>, 4>(_e8606, array<f64, 3>((_e8606[0] - _e8612[0]), (_e8606[1] - _e8612[1]), (_e8606[2] - _e8612[2])), array<f64, 3>((_e8606[0] - _e8618[0]), (_e8606[1] - _e8618[1]), (_e8606[2] - _e8618[2])), _e8606)), ((((((_e8678 + _e8680) + (_e8732 + _e8734)) + (_e8786 + _e8788)) * (1.1102230246251565e-16lf * f64(16f))) + (_e8796 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))), _e640.member_1);
                                        let _e8812 = local_14.member_1;
                                        if (_e8579 > _e8812) {
                                            if ((bitcast<u64>(_e8579) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e8818 = (f64(1f) / _e8579);
                                                let _e8820 = (_e8562[0] * _e8818);
                                                let _e8822 = (_e8562[1] * _e8818);
                                                let _e8824 = (_e8562[2] * _e8818);
                                                let _e8829 = (((_e8820 * _e8820) + (_e8822 * _e8822)) + (_e8824 * _e8824));
                                                if (_e8829 <= 2.2250738585072014e-308lf) {
                                                    if (_e8829 > 0.0lf) {
                                                        phi_6283_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6283_ = 0.0lf;
                                                    }
                                                    let _e8881 = phi_6283_;
                                                    phi_6347_ = _e8881;
                                                } else {
                                                    phi_6290_ = type_16(0i, 5i);
                                                    phi_6293_ = bitcast<f64>(((bitcast<u64>(_e8829) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e8836 = phi_6290_;
                                                        let _e8838 = phi_6293_;
                                                        local_45 = _e8838;
                                                        if (_e8836.member < _e8836.member_1) {
                                                            let _e8845 = (_e8836.member + 1i);
                                                            if ((false == (_e8845 > _e8836.member)) != false) {
                                                                phi_6314_ = true;
                                                            } else {
                                                                phi_6314_ = false;
                                                            }
                                                            let _e8850 = phi_6314_;
                                                            if _e8850 {
                                                                phi_6320_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_6320_ = type_17(1u, _e8845);
                                                            }
                                                            let _e8855 = phi_6320_;
                                                            phi_6291_ = type_16(_e8855.member_1, _e8836.member_1);
                                                            phi_6334_ = type_17(1u, _e8836.member);
                                                        } else {
                                                            phi_6291_ = _e8836;
                                                            phi_6334_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e8861 = phi_6291_;
                                                        let _e8863 = phi_6334_;
                                                        let _e8866 = (bitcast<i32>(_e8863.member) != 0i);
                                                        if _e8866 {
                                                            phi_6294_ = (0.5lf * (_e8838 + (_e8829 / _e8838)));
                                                        } else {
                                                            phi_6294_ = f64();
                                                        }
                                                        let _e8871 = phi_6294_;
                                                        continue;
                                                        continuing {
                                                            phi_6290_ = _e8861;
                                                            phi_6293_ = _e8871;
                                                            break if !(_e8866);
                                                        }
                                                    }
                                                    let _e8876 = local_45;
                                                    phi_6347_ = (_e8876 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e8883 = phi_6347_;
                                                let _e8885 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e8887 = local_14.member_1;
                                                let _e8891 = local_14.member_2;
                                                let _e8896 = ((_e8887 * f64(1.01f)) + ((_e8891 * _e8883) * (f64(1f) + _e8885)));
                                                let _e8900 = local_14.member[0u][0u];
                                                let _e8908 = (((_e8820 * _e8900[0]) + (_e8822 * _e8900[1])) + (_e8824 * _e8900[2]));
                                                let _e8912 = local_14.member[0u][1u];
                                                let _e8920 = (((_e8820 * _e8912[0]) + (_e8822 * _e8912[1])) + (_e8824 * _e8912[2]));
                                                let _e8924 = local_14.member[0u][2u];
                                                let _e8932 = (((_e8820 * _e8924[0]) + (_e8822 * _e8924[1])) + (_e8824 * _e8924[2]));
                                                let _e8936 = local_14.member[0u][3u];
                                                let _e8944 = (((_e8820 * _e8936[0]) + (_e8822 * _e8936[1])) + (_e8824 * _e8936[2]));
                                                let _e8948 = local_14.member[1u][0u];
                                                let _e8956 = (((_e8820 * _e8948[0]) + (_e8822 * _e8948[1])) + (_e8824 * _e8948[2]));
                                                let _e8960 = local_14.member[1u][1u];
                                                let _e8968 = (((_e8820 * _e8960[0]) + (_e8822 * _e8960[1])) + (_e8824 * _e8960[2]));
                                                let _e8972 = local_14.member[1u][2u];
                                                let _e8980 = (((_e8820 * _e8972[0]) + (_e8822 * _e8972[1])) + (_e8824 * _e8972[2]));
                                                let _e8984 = local_14.member[1u][3u];
                                                let _e8992 = (((_e8820 * _e8984[0]) + (_e8822 * _e8984[1])) + (_e8824 * _e8984[2]));
                                                if (_e8908 < 0.0lf) {
                                                    phi_6484_ = -(_e8908);
                                                } else {
                                                    phi_6484_ = _e8908;
                                                }
                                                let _e8996 = phi_6484_;
                                                if (_e8956 < 0.0lf) {
                                                    phi_6490_ = -(_e8956);
                                                } else {
                                                    phi_6490_ = _e8956;
                                                }
                                                let _e9000 = phi_6490_;
                                                if (_e8920 < 0.0lf) {
                                                    phi_6499_ = -(_e8920);
                                                } else {
                                                    phi_6499_ = _e8920;
                                                }
                                                let _e9007 = phi_6499_;
                                                if (_e8968 < 0.0lf) {
                                                    phi_6505_ = -(_e8968);
                                                } else {
                                                    phi_6505_ = _e8968;
                                                }
                                                let _e9011 = phi_6505_;
                                                if (_e8932 < 0.0lf) {
                                                    phi_6514_ = -(_e8932);
                                                } else {
                                                    phi_6514_ = _e8932;
                                                }
                                                let _e9018 = phi_6514_;
                                                if (_e8980 < 0.0lf) {
                                                    phi_6520_ = -(_e8980);
                                                } else {
                                                    phi_6520_ = _e8980;
                                                }
                                                let _e9022 = phi_6520_;
                                                if (_e8944 < 0.0lf) {
                                                    phi_6529_ = -(_e8944);
                                                } else {
                                                    phi_6529_ = _e8944;
                                                }
                                                let _e9029 = phi_6529_;
                                                if (_e8992 < 0.0lf) {
                                                    phi_6535_ = -(_e8992);
                                                } else {
                                                    phi_6535_ = _e8992;
                                                }
                                                let _e9033 = phi_6535_;
                                                local_15 = type_38(array<f64, 4>(_e8908, _e8920, _e8932, _e8944), array<f64, 4>(_e8956, _e8968, _e8980, _e8992), array<f64, 4>((_e8896 + ((_e8996 + _e9000) * _e8885)), (_e8896 + ((_e9007 + _e9011) * _e8885)), (_e8896 + ((_e9018 + _e9022) * _e8885)), (_e8896 + ((_e9029 + _e9033) * _e8885))));
                                                let _e9045 = (((_e8820 * _e8820) + (_e8822 * _e8822)) + (_e8824 * _e8824));
                                                if (_e9045 <= 2.2250738585072014e-308lf) {
                                                    if (_e9045 > 0.0lf) {
                                                        phi_6578_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6578_ = 0.0lf;
                                                    }
                                                    let _e9097 = phi_6578_;
                                                    phi_6642_ = _e9097;
                                                } else {
                                                    phi_6585_ = type_16(0i, 5i);
                                                    phi_6588_ = bitcast<f64>(((bitcast<u64>(_e9045) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9052 = phi_6585_;
                                                        let _e9054 = phi_6588_;
                                                        local_46 = _e9054;
                                                        if (_e9052.member < _e9052.member_1) {
                                                            let _e9061 = (_e9052.member + 1i);
                                                            if ((false == (_e9061 > _e9052.member)) != false) {
                                                                phi_6609_ = true;
                                                            } else {
                                                                phi_6609_ = false;
                                                            }
                                                            let _e9066 = phi_6609_;
                                                            if _e9066 {
                                                                phi_6615_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_6615_ = type_17(1u, _e9061);
                                                            }
                                                            let _e9071 = phi_6615_;
                                                            phi_6586_ = type_16(_e9071.member_1, _e9052.member_1);
                                                            phi_6629_ = type_17(1u, _e9052.member);
                                                        } else {
                                                            phi_6586_ = _e9052;
                                                            phi_6629_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e9077 = phi_6586_;
                                                        let _e9079 = phi_6629_;
                                                        let _e9082 = (bitcast<i32>(_e9079.member) != 0i);
                                                        if _e9082 {
                                                            phi_6589_ = (0.5lf * (_e9054 + (_e9045 / _e9054)));
                                                        } else {
                                                            phi_6589_ = f64();
                                                        }
                                                        let _e9087 = phi_6589_;
                                                        continue;
                                                        continuing {
                                                            phi_6585_ = _e9077;
                                                            phi_6588_ = _e9087;
                                                            break if !(_e9082);
                                                        }
                                                    }
                                                    let _e9092 = local_46;
                                                    phi_6642_ = (_e9092 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9099 = phi_6642_;
                                                let _e9110 = (((_e8562[0] * _e8562[0]) + (_e8562[1] * _e8562[1])) + (_e8562[2] * _e8562[2]));
                                                if (_e9110 <= 2.2250738585072014e-308lf) {
                                                    if (_e9110 > 0.0lf) {
                                                        phi_6667_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6667_ = 0.0lf;
                                                    }
                                                    let _e9162 = phi_6667_;
                                                    phi_6731_ = _e9162;
                                                } else {
                                                    phi_6674_ = type_16(0i, 5i);
                                                    phi_6677_ = bitcast<f64>(((bitcast<u64>(_e9110) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9117 = phi_6674_;
                                                        let _e9119 = phi_6677_;
                                                        local_47 = _e9119;
                                                        if (_e9117.member < _e9117.member_1) {
                                                            let _e9126 = (_e9117.member + 1i);
                                                            if ((false == (_e9126 > _e9117.member)) != false) {
                                                                phi_6698_ = true;
                                                            } else {
                                                                phi_6698_ = false;
                                                            }
                                                            let _e9131 = phi_6698_;
                                                            if _e9131 {
                                                                phi_6704_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_6704_ = type_17(1u, _e9126);
                                                            }
                                                            let _e9136 = phi_6704_;
                                                            phi_6675_ = type_16(_e9136.member_1, _e9117.member_1);
                                                            phi_6718_ = type_17(1u, _e9117.member);
                                                        } else {
                                                            phi_6675_ = _e9117;
                                                            phi_6718_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e9142 = phi_6675_;
                                                        let _e9144 = phi_6718_;
                                                        let _e9147 = (bitcast<i32>(_e9144.member) != 0i);
                                                        if _e9147 {
                                                            phi_6678_ = (0.5lf * (_e9119 + (_e9110 / _e9119)));
                                                        } else {
                                                            phi_6678_ = f64();
                                                        }
                                                        let _e9152 = phi_6678_;
                                                        continue;
                                                        continuing {
                                                            phi_6674_ = _e9142;
                                                            phi_6677_ = _e9152;
                                                            break if !(_e9147);
                                                        }
                                                    }
                                                    let _e9157 = local_47;
                                                    phi_6731_ = (_e9157 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9164 = phi_6731_;
                                                let _e9172 = local_18.member[0u];
                                                if (_e9172[0] < 0.0lf) {
                                                    phi_6749_ = -(_e9172[0]);
                                                } else {
                                                    phi_6749_ = _e9172[0];
                                                }
                                                let _e9179 = phi_6749_;
                                                if (_e9172[1] < 0.0lf) {
                                                    phi_6756_ = -(_e9172[1]);
                                                } else {
                                                    phi_6756_ = _e9172[1];
                                                }
                                                let _e9183 = phi_6756_;
                                                if (_e9179 > _e9183) {
                                                    phi_6761_ = _e9179;
                                                } else {
                                                    phi_6761_ = _e9183;
                                                }
                                                let _e9186 = phi_6761_;
                                                if (_e9172[2] < 0.0lf) {
                                                    phi_6768_ = -(_e9172[2]);
                                                } else {
                                                    phi_6768_ = _e9172[2];
                                                }
                                                let _e9190 = phi_6768_;
                                                if (_e9186 > _e9190) {
                                                    phi_6773_ = _e9186;
                                                } else {
                                                    phi_6773_ = _e9190;
                                                }
                                                let _e9193 = phi_6773_;
                                                let _e9196 = local_18.member[1u];
                                                if (_e9196[0] < 0.0lf) {
                                                    phi_6786_ = -(_e9196[0]);
                                                } else {
                                                    phi_6786_ = _e9196[0];
                                                }
                                                let _e9203 = phi_6786_;
                                                if (_e9196[1] < 0.0lf) {
                                                    phi_6793_ = -(_e9196[1]);
                                                } else {
                                                    phi_6793_ = _e9196[1];
                                                }
                                                let _e9207 = phi_6793_;
                                                if (_e9203 > _e9207) {
                                                    phi_6798_ = _e9203;
                                                } else {
                                                    phi_6798_ = _e9207;
                                                }
                                                let _e9210 = phi_6798_;
                                                if (_e9196[2] < 0.0lf) {
                                                    phi_6805_ = -(_e9196[2]);
                                                } else {
                                                    phi_6805_ = _e9196[2];
                                                }
                                                let _e9214 = phi_6805_;
                                                if (_e9210 > _e9214) {
                                                    phi_6810_ = _e9210;
                                                } else {
                                                    phi_6810_ = _e9214;
                                                }
                                                let _e9217 = phi_6810_;
                                                if (_e9193 > _e9217) {
                                                    phi_6815_ = _e9193;
                                                } else {
                                                    phi_6815_ = _e9217;
                                                }
                                                let _e9220 = phi_6815_;
                                                let _e9222 = local_18.member_3;
                                                let _e9226 = local_18.member_1[0u];
                                                if (_e9226[0] < 0.0lf) {
                                                    phi_6832_ = -(_e9226[0]);
                                                } else {
                                                    phi_6832_ = _e9226[0];
                                                }
                                                let _e9233 = phi_6832_;
                                                if (_e9226[1] < 0.0lf) {
                                                    phi_6839_ = -(_e9226[1]);
                                                } else {
                                                    phi_6839_ = _e9226[1];
                                                }
                                                let _e9237 = phi_6839_;
                                                if (_e9233 > _e9237) {
                                                    phi_6844_ = _e9233;
                                                } else {
                                                    phi_6844_ = _e9237;
                                                }
                                                let _e9240 = phi_6844_;
                                                if (_e9226[2] < 0.0lf) {
                                                    phi_6851_ = -(_e9226[2]);
                                                } else {
                                                    phi_6851_ = _e9226[2];
                                                }
                                                let _e9244 = phi_6851_;
                                                if (_e9240 > _e9244) {
                                                    phi_6856_ = _e9240;
                                                } else {
                                                    phi_6856_ = _e9244;
                                                }
                                                let _e9247 = phi_6856_;
                                                let _e9250 = local_18.member_1[1u];
                                                if (_e9250[0] < 0.0lf) {
                                                    phi_6870_ = -(_e9250[0]);
                                                } else {
                                                    phi_6870_ = _e9250[0];
                                                }
                                                let _e9257 = phi_6870_;
                                                if (_e9250[1] < 0.0lf) {
                                                    phi_6877_ = -(_e9250[1]);
                                                } else {
                                                    phi_6877_ = _e9250[1];
                                                }
                                                let _e9261 = phi_6877_;
                                                if (_e9257 > _e9261) {
                                                    phi_6882_ = _e9257;
                                                } else {
                                                    phi_6882_ = _e9261;
                                                }
                                                let _e9264 = phi_6882_;
                                                if (_e9250[2] < 0.0lf) {
                                                    phi_6889_ = -(_e9250[2]);
                                                } else {
                                                    phi_6889_ = _e9250[2];
                                                }
                                                let _e9268 = phi_6889_;
                                                if (_e9264 > _e9268) {
                                                    phi_6894_ = _e9264;
                                                } else {
                                                    phi_6894_ = _e9268;
                                                }
                                                let _e9271 = phi_6894_;
                                                if (_e9247 > _e9271) {
                                                    phi_6899_ = _e9247;
                                                } else {
                                                    phi_6899_ = _e9271;
                                                }
                                                let _e9274 = phi_6899_;
                                                let _e9276 = local_18.member_3;
                                                let _e9280 = local_18.member_2[0u];
                                                if (_e9280[0] < 0.0lf) {
                                                    phi_6916_ = -(_e9280[0]);
                                                } else {
                                                    phi_6916_ = _e9280[0];
                                                }
                                                let _e9287 = phi_6916_;
                                                if (_e9280[1] < 0.0lf) {
                                                    phi_6923_ = -(_e9280[1]);
                                                } else {
                                                    phi_6923_ = _e9280[1];
                                                }
                                                let _e9291 = phi_6923_;
                                                if (_e9287 > _e9291) {
                                                    phi_6928_ = _e9287;
                                                } else {
                                                    phi_6928_ = _e9291;
                                                }
                                                let _e9294 = phi_6928_;
                                                if (_e9280[2] < 0.0lf) {
                                                    phi_6935_ = -(_e9280[2]);
                                                } else {
                                                    phi_6935_ = _e9280[2];
                                                }
                                                let _e9298 = phi_6935_;
                                                if (_e9294 > _e9298) {
                                                    phi_6940_ = _e9294;
                                                } else {
                                                    phi_6940_ = _e9298;
                                                }
                                                let _e9301 = phi_6940_;
                                                let _e9304 = local_18.member_2[1u];
                                                if (_e9304[0] < 0.0lf) {
                                                    phi_6954_ = -(_e9304[0]);
                                                } else {
                                                    phi_6954_ = _e9304[0];
                                                }
                                                let _e9311 = phi_6954_;
                                                if (_e9304[1] < 0.0lf) {
                                                    phi_6961_ = -(_e9304[1]);
                                                } else {
                                                    phi_6961_ = _e9304[1];
                                                }
                                                let _e9315 = phi_6961_;
                                                if (_e9311 > _e9315) {
                                                    phi_6966_ = _e9311;
                                                } else {
                                                    phi_6966_ = _e9315;
                                                }
                                                let _e9318 = phi_6966_;
                                                if (_e9304[2] < 0.0lf) {
                                                    phi_6973_ = -(_e9304[2]);
                                                } else {
                                                    phi_6973_ = _e9304[2];
                                                }
                                                let _e9322 = phi_6973_;
                                                if (_e9318 > _e9322) {
                                                    phi_6978_ = _e9318;
                                                } else {
                                                    phi_6978_ = _e9322;
                                                }
                                                let _e9325 = phi_6978_;
                                                if (_e9301 > _e9325) {
                                                    phi_6983_ = _e9301;
                                                } else {
                                                    phi_6983_ = _e9325;
                                                }
                                                let _e9328 = phi_6983_;
                                                let _e9330 = local_18.member_3;
                                                let _e9338 = local_18.member_3;
                                                let _e9353 = ((((_e9164 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e9220 + _e9222) + (_e9274 + _e9276)) + (_e9328 + _e9330)) * (1.1102230246251565e-16lf * f64(16f))) + (_e9338 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) * _e9099) * (f64(1f) + (1.1102230246251565e-16lf * f64(64f))));
                                                let _e9356 = local_15.member[0u];
                                                let _e9359 = local_15.member_1[0u];
                                                if (_e9356 < 0.0lf) {
                                                    phi_7031_ = -(_e9356);
                                                } else {
                                                    phi_7031_ = _e9356;
                                                }
                                                let _e9365 = phi_7031_;
                                                if (_e9359 < 0.0lf) {
                                                    phi_7037_ = -(_e9359);
                                                } else {
                                                    phi_7037_ = _e9359;
                                                }
                                                let _e9369 = phi_7037_;
                                                phi_7049_ = type_12(1u, 4u);
                                                phi_7052_ = ((_e9356 + ((_e9359 - _e9356) * _e6651)) - ((_e8812 * f64(1.01f)) + ((_e9365 + _e9369) * (1.1102230246251565e-16lf * f64(12f)))));
                                                loop {
                                                    let _e9380 = phi_7049_;
                                                    let _e9382 = phi_7052_;
                                                    local_48 = _e9382;
                                                    local_49 = _e9382;
                                                    if (_e9380.member < _e9380.member_1) {
                                                        phi_7050_ = type_12((_e9380.member + 1u), _e9380.member_1);
                                                        phi_7075_ = type_12(1u, _e9380.member);
                                                    } else {
                                                        phi_7050_ = _e9380;
                                                        phi_7075_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e9394 = phi_7050_;
                                                    let _e9396 = phi_7075_;
                                                    let _e9400 = (bitcast<i32>(_e9396.member) != 0i);
                                                    if _e9400 {
                                                        let _e9403 = local_15.member[_e9396.member_1];
                                                        let _e9406 = local_15.member_1[_e9396.member_1];
                                                        if (_e9403 < 0.0lf) {
                                                            phi_7105_ = -(_e9403);
                                                        } else {
                                                            phi_7105_ = _e9403;
                                                        }
                                                        let _e9412 = phi_7105_;
                                                        if (_e9406 < 0.0lf) {
                                                            phi_7111_ = -(_e9406);
                                                        } else {
                                                            phi_7111_ = _e9406;
                                                        }
                                                        let _e9416 = phi_7111_;
                                                        let _e9425 = ((_e9403 + ((_e9406 - _e9403) * _e6651)) - ((_e8812 * f64(1.01f)) + ((_e9412 + _e9416) * (1.1102230246251565e-16lf * f64(12f)))));
                                                        if (_e9382 < _e9425) {
                                                            phi_7125_ = _e9382;
                                                        } else {
                                                            phi_7125_ = _e9425;
                                                        }
                                                        let _e9428 = phi_7125_;
                                                        phi_7053_ = _e9428;
                                                    } else {
                                                        phi_7053_ = f64();
                                                    }
                                                    let _e9430 = phi_7053_;
                                                    continue;
                                                    continuing {
                                                        phi_7049_ = _e9394;
                                                        phi_7052_ = _e9430;
                                                        break if !(_e9400);
                                                    }
                                                }
                                                let _e9433 = local_48;
                                                if (_e9433 > f64(0f)) {
                                                    let _e9438 = local_49;
                                                    let _e9442 = (((_e9353 - _e9438) / _e9353) * f64(2.02f));
                                                    if (_e9442 <= 2.2250738585072014e-308lf) {
                                                        if (_e9442 > 0.0lf) {
                                                            phi_7147_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_7147_ = 0.0lf;
                                                        }
                                                        let _e9494 = phi_7147_;
                                                        phi_7211_ = _e9494;
                                                    } else {
                                                        phi_7154_ = type_16(0i, 5i);
                                                        phi_7157_ = bitcast<f64>(((bitcast<u64>(_e9442) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e9449 = phi_7154_;
                                                            let _e9451 = phi_7157_;
                                                            local_50 = _e9451;
                                                            if (_e9449.member < _e9449.member_1) {
                                                                let _e9458 = (_e9449.member + 1i);
                                                                if ((false == (_e9458 > _e9449.member)) != false) {
                                                                    phi_7178_ = true;
                                                                } else {
                                                                    phi_7178_ = false;
                                                                }
                                                                let _e9463 = phi_7178_;
                                                                if _e9463 {
                                                                    phi_7184_ = type_17(0u, type_17().member_1);
                                                                } else {
                                                                    phi_7184_ = type_17(1u, _e9458);
                                                                }
                                                                let _e9468 = phi_7184_;
                                                                phi_7155_ = type_16(_e9468.member_1, _e9449.member_1);
                                                                phi_7198_ = type_17(1u, _e9449.member);
                                                            } else {
                                                                phi_7155_ = _e9449;
                                                                phi_7198_ = type_17(0u, type_17().member_1);
                                                            }
                                                            let _e9474 = phi_7155_;
                                                            let _e9476 = phi_7198_;
                                                            let _e9479 = (bitcast<i32>(_e9476.member) != 0i);
                                                            if _e9479 {
                                                                phi_7158_ = (0.5lf * (_e9451 + (_e9442 / _e9451)));
                                                            } else {
                                                                phi_7158_ = f64();
                                                            }
                                                            let _e9484 = phi_7158_;
                                                            continue;
                                                            continuing {
                                                                phi_7154_ = _e9474;
                                                                phi_7157_ = _e9484;
                                                                break if !(_e9479);
                                                            }
                                                        }
                                                        let _e9489 = local_50;
                                                        phi_7211_ = (_e9489 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e9496 = phi_7211_;
                                                    let _e9499 = ((_e9496 * _e9099) * f64(1.01f));
                                                    phi_7218_ = type_12(0u, 4u);
                                                    phi_7221_ = f64(2f);
                                                    phi_7223_ = true;
                                                    phi_7225_ = true;
                                                    loop {
                                                        let _e9502 = phi_7218_;
                                                        let _e9504 = phi_7221_;
                                                        let _e9506 = phi_7223_;
                                                        let _e9508 = phi_7225_;
                                                        local_51 = _e9504;
                                                        local_90 = _e9504;
                                                        local_52 = _e9506;
                                                        local_53 = _e9508;
                                                        local_91 = _e9508;
                                                        local_54 = _e9508;
                                                        if (_e9502.member < _e9502.member_1) {
                                                            phi_7219_ = type_12((_e9502.member + 1u), _e9502.member_1);
                                                            phi_7248_ = type_12(1u, _e9502.member);
                                                        } else {
                                                            phi_7219_ = _e9502;
                                                            phi_7248_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e9520 = phi_7219_;
                                                        let _e9522 = phi_7248_;
                                                        let _e9526 = (bitcast<i32>(_e9522.member) != 0i);
                                                        if _e9526 {
                                                            let _e9530 = local_14.member[0u][_e9522.member_1];
                                                            let _e9537 = local_14.member[1u][_e9522.member_1];
                                                            if (_e9530[0] < 0.0lf) {
                                                                phi_7285_ = -(_e9530[0]);
                                                            } else {
                                                                phi_7285_ = _e9530[0];
                                                            }
                                                            let _e9544 = phi_7285_;
                                                            if (_e9530[1] < 0.0lf) {
                                                                phi_7292_ = -(_e9530[1]);
                                                            } else {
                                                                phi_7292_ = _e9530[1];
                                                            }
                                                            let _e9548 = phi_7292_;
                                                            if (_e9530[2] < 0.0lf) {
                                                                phi_7300_ = -(_e9530[2]);
                                                            } else {
                                                                phi_7300_ = _e9530[2];
                                                            }
                                                            let _e9553 = phi_7300_;
                                                            let _e9554 = ((_e9544 + _e9548) + _e9553);
                                                            if (_e9537[0] < 0.0lf) {
                                                                phi_7308_ = -(_e9537[0]);
                                                            } else {
                                                                phi_7308_ = _e9537[0];
                                                            }
                                                            let _e9558 = phi_7308_;
                                                            if (_e9537[1] < 0.0lf) {
                                                                phi_7315_ = -(_e9537[1]);
                                                            } else {
                                                                phi_7315_ = _e9537[1];
                                                            }
                                                            let _e9562 = phi_7315_;
                                                            if (_e9537[2] < 0.0lf) {
                                                                phi_7323_ = -(_e9537[2]);
                                                            } else {
                                                                phi_7323_ = _e9537[2];
                                                            }
                                                            let _e9567 = phi_7323_;
                                                            let _e9568 = ((_e9558 + _e9562) + _e9567);
                                                            if (_e9554 > _e9568) {
                                                                phi_7329_ = _e9554;
                                                            } else {
                                                                phi_7329_ = _e9568;
                                                            }
                                                            let _e9571 = phi_7329_;
                                                            let _e9577 = (_e9537[0] - _e9530[0]);
                                                            let _e9578 = (_e9537[1] - _e9530[1]);
                                                            let _e9579 = (_e9537[2] - _e9530[2]);
                                                            if (_e9577 < 0.0lf) {
                                                                phi_7349_ = -(_e9577);
                                                            } else {
                                                                phi_7349_ = _e9577;
                                                            }
                                                            let _e9583 = phi_7349_;
                                                            if (_e9578 < 0.0lf) {
                                                                phi_7355_ = -(_e9578);
                                                            } else {
                                                                phi_7355_ = _e9578;
                                                            }
                                                            let _e9587 = phi_7355_;
                                                            if (_e9579 < 0.0lf) {
                                                                phi_7362_ = -(_e9579);
                                                            } else {
                                                                phi_7362_ = _e9579;
                                                            }
                                                            let _e9592 = phi_7362_;
                                                            let _e9601 = local_15.member[_e9522.member_1];
                                                            let _e9604 = local_15.member_1[_e9522.member_1];
                                                            if (_e9601 < 0.0lf) {
                                                                phi_7391_ = -(_e9601);
                                                            } else {
                                                                phi_7391_ = _e9601;
                                                            }
                                                            let _e9610 = phi_7391_;
                                                            if (_e9604 < 0.0lf) {
                                                                phi_7397_ = -(_e9604);
                                                            } else {
                                                                phi_7397_ = _e9604;
                                                            }
                                                            let _e9614 = phi_7397_;
                                                            let _e9619 = ((_e8812 * f64(1.01f)) + ((_e9610 + _e9614) * (1.1102230246251565e-16lf * f64(12f))));
                                                            let _e9626 = local_15.member_1[_e9522.member_1];
                                                            let _e9629 = local_15.member[_e9522.member_1];
                                                            let _e9630 = (_e9626 - _e9629);
                                                            let _e9633 = ((_e9619 + _e9619) + (_e9499 * ((((_e9583 + _e9587) + _e9592) + (_e8812 * f64(6f))) * f64(1.01f))));
                                                            let _e9636 = ((((_e9601 + ((_e9604 - _e9601) * _e6651)) - _e9619) - (_e9499 * ((_e9571 + (_e8812 * f64(3f))) * f64(1.01f)))) - _e9353);
                                                            let _e9637 = (_e9636 > 2.2250738585072014e-308lf);
                                                            let _e9638 = (_e9630 > _e9633);
                                                            if _e9638 {
                                                                phi_7434_ = true;
                                                            } else {
                                                                phi_7434_ = _e9637;
                                                            }
                                                            let _e9640 = phi_7434_;
                                                            if (_e9630 < -(_e9633)) {
                                                                phi_7441_ = true;
                                                            } else {
                                                                phi_7441_ = _e9637;
                                                            }
                                                            let _e9645 = phi_7441_;
                                                            if _e9638 {
                                                                phi_7462_ = _e9504;
                                                            } else {
                                                                if _e9637 {
                                                                    let _e9647 = (_e9633 - _e9630);
                                                                    if (_e9647 > 2.2250738585072014e-308lf) {
                                                                        phi_7454_ = _e9647;
                                                                    } else {
                                                                        phi_7454_ = 2.2250738585072014e-308lf;
                                                                    }
                                                                    let _e9650 = phi_7454_;
                                                                    let _e9651 = (_e9636 / _e9650);
                                                                    if (_e9504 < _e9651) {
                                                                        phi_7460_ = _e9504;
                                                                    } else {
                                                                        phi_7460_ = _e9651;
                                                                    }
                                                                    let _e9654 = phi_7460_;
                                                                    phi_7461_ = _e9654;
                                                                } else {
                                                                    phi_7461_ = _e9504;
                                                                }
                                                                let _e9656 = phi_7461_;
                                                                phi_7462_ = _e9656;
                                                            }
                                                            let _e9658 = phi_7462_;
                                                            phi_7222_ = _e9658;
                                                            phi_7224_ = (_e9506 && _e9645);
                                                            phi_7226_ = (_e9508 && _e9640);
                                                        } else {
                                                            phi_7222_ = f64();
                                                            phi_7224_ = bool();
                                                            phi_7226_ = bool();
                                                        }
                                                        let _e9660 = phi_7222_;
                                                        let _e9662 = phi_7224_;
                                                        let _e9664 = phi_7226_;
                                                        continue;
                                                        continuing {
                                                            phi_7218_ = _e9520;
                                                            phi_7221_ = _e9660;
                                                            phi_7223_ = _e9662;
                                                            phi_7225_ = _e9664;
                                                            break if !(_e9526);
                                                        }
                                                    }
                                                    let _e9666 = f64(2f);
                                                    let _e9668 = local_51;
                                                    if (_e9668 < _e9666) {
                                                        let _e12092 = local_90;
                                                        phi_7468_ = _e12092;
                                                    } else {
                                                        phi_7468_ = _e9666;
                                                    }
                                                    let _e9671 = phi_7468_;
                                                    let _e9673 = (_e9671 * f64(0.999f));
                                                    let _e9675 = local_52;
                                                    if _e9675 {
                                                        let _e9677 = local_53;
                                                        if _e9677 {
                                                            phi_7479_ = type_48();
                                                        } else {
                                                            phi_7479_ = type_48(_e6651, f64(2f), 1u);
                                                        }
                                                        let _e9681 = phi_7479_;
                                                        phi_7480_ = _e9681;
                                                        let _e12099 = local_91;
                                                        phi_7481_ = _e12099;
                                                    } else {
                                                        phi_7480_ = type_48();
                                                        phi_7481_ = true;
                                                    }
                                                    let _e9683 = phi_7480_;
                                                    let _e9685 = phi_7481_;
                                                    if _e9685 {
                                                        let _e9687 = local_54;
                                                        if _e9687 {
                                                            if (_e9673 > (1.1102230246251565e-16lf * f64(4096f))) {
                                                                let _e9693 = (_e6651 + _e9673);
                                                                if (_e9693 < _e436) {
                                                                    phi_7499_ = _e9693;
                                                                } else {
                                                                    phi_7499_ = _e436;
                                                                }
                                                                let _e9696 = phi_7499_;
                                                                phi_7500_ = _e9696;
                                                            } else {
                                                                phi_7500_ = _e6651;
                                                            }
                                                            let _e9698 = phi_7500_;
                                                            phi_7503_ = type_12(0u, 4u);
                                                            phi_7506_ = _e9698;
                                                            phi_7508_ = _e6651;
                                                            loop {
                                                                let _e9700 = phi_7503_;
                                                                let _e9702 = phi_7506_;
                                                                let _e9704 = phi_7508_;
                                                                local_55 = _e9702;
                                                                local_56 = _e9704;
                                                                local_57 = _e9704;
                                                                if (_e9700.member < _e9700.member_1) {
                                                                    phi_7504_ = type_12((_e9700.member + 1u), _e9700.member_1);
                                                                    phi_7531_ = type_12(1u, _e9700.member);
                                                                } else {
                                                                    phi_7504_ = _e9700;
                                                                    phi_7531_ = type_12(0u, type_12().member_1);
                                                                }
                                                                let _e9716 = phi_7504_;
                                                                let _e9718 = phi_7531_;
                                                                let _e9722 = (bitcast<i32>(_e9718.member) != 0i);
                                                                if _e9722 {
                                                                    let _e9725 = local_15.member[_e9718.member_1];
                                                                    let _e9728 = local_15.member_1[_e9718.member_1];
                                                                    let _e9731 = local_15.member[_e9718.member_1];
                                                                    let _e9737 = local_15.member_2[_e9718.member_1];
                                                                    let _e9738 = ((_e9725 + ((_e9728 - _e9731) * _e6651)) - _e9737);
                                                                    let _e9741 = local_15.member_1[_e9718.member_1];
                                                                    let _e9744 = local_15.member[_e9718.member_1];
                                                                    let _e9745 = (_e9741 - _e9744);
                                                                    if (_e9745 > f64(0f)) {
                                                                        let _e9762 = (_e6651 - (_e9738 / _e9745));
                                                                        if (_e9704 > _e9762) {
                                                                            phi_7600_ = _e9704;
                                                                        } else {
                                                                            phi_7600_ = _e9762;
                                                                        }
                                                                        let _e9765 = phi_7600_;
                                                                        phi_7620_ = _e9702;
                                                                        phi_7621_ = _e9765;
                                                                    } else {
                                                                        if (_e9738 > f64(0f)) {
                                                                            if (_e9745 < f64(0f)) {
                                                                                let _e9753 = (_e6651 - (_e9738 / _e9745));
                                                                                if (_e9702 < _e9753) {
                                                                                    phi_7617_ = _e9702;
                                                                                } else {
                                                                                    phi_7617_ = _e9753;
                                                                                }
                                                                                let _e9756 = phi_7617_;
                                                                                phi_7618_ = _e9756;
                                                                            } else {
                                                                                phi_7618_ = _e9702;
                                                                            }
                                                                            let _e9758 = phi_7618_;
                                                                            phi_7619_ = _e9758;
                                                                        } else {
                                                                            phi_7619_ = _e9702;
                                                                        }
                                                                        let _e9760 = phi_7619_;
                                                                        phi_7620_ = _e9760;
                                                                        phi_7621_ = _e9704;
                                                                    }
                                                                    let _e9767 = phi_7620_;
                                                                    let _e9769 = phi_7621_;
                                                                    phi_7507_ = _e9767;
                                                                    phi_7509_ = _e9769;
                                                                } else {
                                                                    phi_7507_ = f64();
                                                                    phi_7509_ = f64();
                                                                }
                                                                let _e9771 = phi_7507_;
                                                                let _e9773 = phi_7509_;
                                                                continue;
                                                                continuing {
                                                                    phi_7503_ = _e9716;
                                                                    phi_7506_ = _e9771;
                                                                    phi_7508_ = _e9773;
                                                                    break if !(_e9722);
                                                                }
                                                            }
                                                            let _e9776 = local_55;
                                                            let _e9778 = local_56;
                                                            let _e9783 = local_57;
                                                            let _e9784 = (_e9783 + ((_e9776 - _e9778) * f64(0.5f)));
                                                            if (_e9784 > _e6651) {
                                                                if (_e9784 <= _e9698) {
                                                                    let _e9787 = f64(0f);
                                                                    let _e9790 = local_15.member[0u];
                                                                    let _e9793 = local_15.member_1[0u];
                                                                    let _e9796 = local_15.member[0u];
                                                                    let _e9802 = local_15.member_2[0u];
                                                                    if (((_e9790 + ((_e9793 - _e9796) * _e9784)) - _e9802) > _e9787) {
                                                                        let _e9807 = local_15.member[1u];
                                                                        let _e9810 = local_15.member_1[1u];
                                                                        let _e9813 = local_15.member[1u];
                                                                        let _e9819 = local_15.member_2[1u];
                                                                        if (((_e9807 + ((_e9810 - _e9813) * _e9784)) - _e9819) > _e9787) {
                                                                            let _e9824 = local_15.member[2u];
                                                                            let _e9827 = local_15.member_1[2u];
                                                                            let _e9830 = local_15.member[2u];
                                                                            let _e9836 = local_15.member_2[2u];
                                                                            if (((_e9824 + ((_e9827 - _e9830) * _e9784)) - _e9836) > _e9787) {
                                                                                let _e9841 = local_15.member[3u];
                                                                                let _e9844 = local_15.member_1[3u];
                                                                                let _e9847 = local_15.member[3u];
                                                                                let _e9853 = local_15.member_2[3u];
                                                                                phi_7784_ = (((_e9841 + ((_e9844 - _e9847) * _e9784)) - _e9853) > _e9787);
                                                                                phi_7785_ = false;
                                                                            } else {
                                                                                phi_7784_ = bool();
                                                                                phi_7785_ = true;
                                                                            }
                                                                            let _e9857 = phi_7784_;
                                                                            let _e9859 = phi_7785_;
                                                                            phi_7786_ = _e9857;
                                                                            phi_7787_ = _e9859;
                                                                        } else {
                                                                            phi_7786_ = bool();
                                                                            phi_7787_ = true;
                                                                        }
                                                                        let _e9861 = phi_7786_;
                                                                        let _e9863 = phi_7787_;
                                                                        phi_7788_ = _e9861;
                                                                        phi_7789_ = _e9863;
                                                                    } else {
                                                                        phi_7788_ = bool();
                                                                        phi_7789_ = true;
                                                                    }
                                                                    let _e9865 = phi_7788_;
                                                                    let _e9867 = phi_7789_;
                                                                    if _e9867 {
                                                                        phi_7793_ = false;
                                                                    } else {
                                                                        phi_7793_ = _e9865;
                                                                    }
                                                                    let _e9869 = phi_7793_;
                                                                    if _e9869 {
                                                                        phi_7797_ = false;
                                                                    } else {
                                                                        phi_7797_ = true;
                                                                    }
                                                                    let _e9871 = phi_7797_;
                                                                    phi_7798_ = _e9871;
                                                                } else {
                                                                    phi_7798_ = true;
                                                                }
                                                                let _e9873 = phi_7798_;
                                                                phi_7799_ = _e9873;
                                                            } else {
                                                                phi_7799_ = true;
                                                            }
                                                            let _e9875 = phi_7799_;
                                                            if _e9875 {
                                                                phi_7804_ = f64(2f);
                                                            } else {
                                                                phi_7804_ = _e9784;
                                                            }
                                                            let _e9878 = phi_7804_;
                                                            phi_7808_ = type_48(_e9698, _e9878, 2u);
                                                            phi_7809_ = type_48();
                                                            phi_7810_ = false;
                                                        } else {
                                                            phi_7808_ = type_48();
                                                            phi_7809_ = type_48(_e6651, f64(2f), 0u);
                                                            phi_7810_ = true;
                                                        }
                                                        let _e9881 = phi_7808_;
                                                        let _e9883 = phi_7809_;
                                                        let _e9885 = phi_7810_;
                                                        phi_7811_ = _e9881;
                                                        phi_7812_ = _e9883;
                                                        phi_7813_ = _e9885;
                                                    } else {
                                                        phi_7811_ = type_48();
                                                        phi_7812_ = _e9683;
                                                        phi_7813_ = true;
                                                    }
                                                    let _e9887 = phi_7811_;
                                                    let _e9889 = phi_7812_;
                                                    let _e9891 = phi_7813_;
                                                    phi_7819_ = _e9889;
                                                    phi_7820_ = _e9887;
                                                    phi_7821_ = _e9891;
                                                } else {
                                                    phi_7819_ = type_48(_e6651, f64(2f), 0u);
                                                    phi_7820_ = type_48();
                                                    phi_7821_ = true;
                                                }
                                                let _e9893 = phi_7819_;
                                                let _e9895 = phi_7820_;
                                                let _e9897 = phi_7821_;
                                                phi_7825_ = _e9893;
                                                phi_7826_ = _e9895;
                                                phi_7827_ = false;
                                                phi_7828_ = _e9897;
                                            } else {
                                                phi_7825_ = type_48();
                                                phi_7826_ = type_48();
                                                phi_7827_ = true;
                                                phi_7828_ = false;
                                            }
                                            let _e9899 = phi_7825_;
                                            let _e9901 = phi_7826_;
                                            let _e9903 = phi_7827_;
                                            let _e9905 = phi_7828_;
                                            phi_7829_ = _e9899;
                                            phi_7830_ = _e9901;
                                            phi_7831_ = _e9903;
                                            phi_7832_ = _e9905;
                                        } else {
                                            phi_7829_ = type_48();
                                            phi_7830_ = type_48();
                                            phi_7831_ = true;
                                            phi_7832_ = false;
                                        }
                                        let _e9907 = phi_7829_;
                                        let _e9909 = phi_7830_;
                                        let _e9911 = phi_7831_;
                                        let _e9913 = phi_7832_;
                                        if _e9911 {
                                            phi_7838_ = type_48(_e6651, f64(2f), 0u);
                                            phi_7839_ = true;
                                        } else {
                                            phi_7838_ = _e9907;
                                            phi_7839_ = _e9913;
                                        }
                                        let _e9917 = phi_7838_;
                                        let _e9919 = phi_7839_;
                                        if _e9919 {
                                            phi_7843_ = _e9917;
                                        } else {
                                            phi_7843_ = _e9909;
                                        }
                                        let _e9921 = phi_7843_;
                                        if ((_e438 & 64u) != 0u) {
                                            if (_e9921.member_2 == 2u) {
                                                let _e9925 = (_e9921.member_1 <= _e436);
                                                if _e9925 {
                                                    phi_7859_ = _e9921.member_1;
                                                    phi_7860_ = _e9921.member_1;
                                                    phi_7861_ = false;
                                                } else {
                                                    phi_7859_ = f64();
                                                    phi_7860_ = f64();
                                                    phi_7861_ = true;
                                                }
                                                let _e9929 = phi_7859_;
                                                let _e9931 = phi_7860_;
                                                let _e9933 = phi_7861_;
                                                phi_7862_ = _e9929;
                                                phi_7863_ = _e9931;
                                                phi_7864_ = _e9925;
                                                phi_7865_ = _e9933;
                                                phi_7866_ = false;
                                            } else {
                                                phi_7862_ = f64();
                                                phi_7863_ = f64();
                                                phi_7864_ = false;
                                                phi_7865_ = false;
                                                phi_7866_ = true;
                                            }
                                            let _e9935 = phi_7862_;
                                            let _e9937 = phi_7863_;
                                            let _e9939 = phi_7864_;
                                            let _e9941 = phi_7865_;
                                            let _e9943 = phi_7866_;
                                            phi_7867_ = _e9935;
                                            phi_7868_ = _e9937;
                                            phi_7869_ = _e9939;
                                            phi_7870_ = _e9941;
                                            phi_7871_ = _e9943;
                                        } else {
                                            phi_7867_ = f64();
                                            phi_7868_ = f64();
                                            phi_7869_ = false;
                                            phi_7870_ = false;
                                            phi_7871_ = true;
                                        }
                                        let _e9945 = phi_7867_;
                                        let _e9947 = phi_7868_;
                                        let _e9949 = phi_7869_;
                                        let _e9951 = phi_7870_;
                                        let _e9953 = phi_7871_;
                                        phi_7872_ = _e9945;
                                        phi_7873_ = _e9921.member_2;
                                        phi_7874_ = _e9947;
                                        phi_7875_ = _e9921;
                                        phi_7876_ = _e9921.member_2;
                                        phi_7877_ = _e9921.member_2;
                                        phi_7878_ = _e9949;
                                        phi_7879_ = _e9951;
                                        phi_7880_ = _e9953;
                                    }
                                    let _e9955 = phi_7872_;
                                    let _e9957 = phi_7873_;
                                    let _e9959 = phi_7874_;
                                    let _e9961 = phi_7875_;
                                    let _e9963 = phi_7876_;
                                    let _e9965 = phi_7877_;
                                    let _e9967 = phi_7878_;
                                    let _e9969 = phi_7879_;
                                    let _e9971 = phi_7880_;
                                    phi_7881_ = _e9955;
                                    phi_7882_ = _e9957;
                                    phi_7883_ = _e9959;
                                    phi_7884_ = _e9961;
                                    phi_7885_ = _e9963;
                                    phi_7886_ = _e9965;
                                    phi_7887_ = _e9967;
                                    phi_7888_ = _e8494;
                                    phi_7889_ = _e9969;
                                    phi_7890_ = _e9971;
                                    phi_7891_ = false;
                                } else {
                                    phi_7881_ = f64();
                                    phi_7882_ = u32();
                                    phi_7883_ = f64();
                                    phi_7884_ = type_48();
                                    phi_7885_ = u32();
                                    phi_7886_ = u32();
                                    phi_7887_ = false;
                                    phi_7888_ = false;
                                    phi_7889_ = false;
                                    phi_7890_ = false;
                                    phi_7891_ = true;
                                }
                                let _e9973 = phi_7881_;
                                let _e9975 = phi_7882_;
                                let _e9977 = phi_7883_;
                                let _e9979 = phi_7884_;
                                let _e9981 = phi_7885_;
                                let _e9983 = phi_7886_;
                                let _e9985 = phi_7887_;
                                let _e9987 = phi_7888_;
                                let _e9989 = phi_7889_;
                                let _e9991 = phi_7890_;
                                let _e9993 = phi_7891_;
                                phi_7892_ = _e8491;
                                phi_2876_ = _e9973;
                                phi_2878_ = _e9975;
                                phi_2880_ = _e9977;
                                phi_7893_ = _e9979;
                                phi_7894_ = _e9981;
                                phi_7895_ = _e8491;
                                phi_7896_ = _e9983;
                                phi_7897_ = _e9985;
                                phi_7898_ = _e9987;
                                phi_7899_ = _e9989;
                                phi_7900_ = _e9991;
                                phi_7901_ = false;
                                phi_7902_ = _e9993;
                            } else {
                                phi_7892_ = f64();
                                phi_2876_ = f64();
                                phi_2878_ = u32();
                                phi_2880_ = f64();
                                phi_7893_ = type_48();
                                phi_7894_ = u32();
                                phi_7895_ = f64();
                                phi_7896_ = u32();
                                phi_7897_ = false;
                                phi_7898_ = false;
                                phi_7899_ = false;
                                phi_7900_ = false;
                                phi_7901_ = true;
                                phi_7902_ = false;
                            }
                            let _e9995 = phi_7892_;
                            let _e9997 = phi_2876_;
                            let _e9999 = phi_2878_;
                            let _e10001 = phi_2880_;
                            let _e10003 = phi_7893_;
                            let _e10005 = phi_7894_;
                            let _e10007 = phi_7895_;
                            let _e10009 = phi_7896_;
                            let _e10011 = phi_7897_;
                            let _e10013 = phi_7898_;
                            let _e10015 = phi_7899_;
                            let _e10017 = phi_7900_;
                            let _e10019 = phi_7901_;
                            let _e10021 = phi_7902_;
                            local_58 = _e10013;
                            local_92 = _e10015;
                            local_93 = _e10017;
                            local_94 = _e10019;
                            local_95 = _e10021;
                            local_59 = _e10003;
                            local_60 = _e10003;
                            local_96 = _e10005;
                            local_61 = _e10003;
                            local_97 = _e10013;
                            local_98 = _e10009;
                            local_100 = _e10007;
                            local_101 = _e9995;
                            continue;
                            continuing {
                                phi_2872_ = _e6674;
                                phi_2875_ = _e9997;
                                phi_2877_ = _e9999;
                                phi_2879_ = _e10001;
                                break if !(_e10011);
                            }
                        }
                        let _e10024 = local_58;
                        if _e10024 {
                            phi_7906_ = false;
                            phi_7907_ = false;
                            phi_7908_ = false;
                            phi_7909_ = false;
                        } else {
                            let _e12200 = local_92;
                            phi_7906_ = _e12200;
                            let _e12203 = local_93;
                            phi_7907_ = _e12203;
                            let _e12206 = local_94;
                            phi_7908_ = _e12206;
                            let _e12209 = local_95;
                            phi_7909_ = _e12209;
                        }
                        let _e10026 = phi_7906_;
                        let _e10028 = phi_7907_;
                        let _e10030 = phi_7908_;
                        let _e10032 = phi_7909_;
                        if _e10026 {
                            let _e10034 = local_59;
                            if (_e10034.member >= _e436) {
                                phi_7931_ = type_47(type_46(0u, f64()), 0u);
                            } else {
                                let _e10038 = local_60;
                                if (_e10038.member > _e427) {
                                    phi_7926_ = 0u;
                                } else {
                                    let _e12214 = local_96;
                                    phi_7926_ = _e12214;
                                }
                                let _e10042 = phi_7926_;
                                let _e10044 = local_61;
                                phi_7931_ = type_47(type_46(2u, _e10044.member), _e10042);
                            }
                            let _e10051 = phi_7931_;
                            phi_7932_ = _e10051;
                            phi_7933_ = false;
                            phi_7934_ = false;
                            phi_7935_ = false;
                            phi_7936_ = false;
                        } else {
                            phi_7932_ = type_47();
                            phi_7933_ = _e10028;
                            let _e12221 = local_97;
                            phi_7934_ = _e12221;
                            phi_7935_ = _e10030;
                            phi_7936_ = _e10032;
                        }
                        let _e10053 = phi_7932_;
                        let _e10055 = phi_7933_;
                        let _e10057 = phi_7934_;
                        let _e10059 = phi_7935_;
                        let _e10061 = phi_7936_;
                        if _e10055 {
                            let _e12226 = local_98;
                            phi_7940_ = _e12226;
                            let _e12231 = local_100;
                            phi_7941_ = _e12231;
                            phi_7942_ = true;
                            phi_7943_ = false;
                            phi_7944_ = false;
                            phi_7945_ = false;
                        } else {
                            let _e12228 = local_99;
                            phi_7940_ = _e12228;
                            let _e12233 = local_101;
                            phi_7941_ = _e12233;
                            phi_7942_ = _e10057;
                            phi_7943_ = _e10059;
                            phi_7944_ = _e10061;
                            phi_7945_ = _e10026;
                        }
                        let _e10063 = phi_7940_;
                        let _e10065 = phi_7941_;
                        let _e10067 = phi_7942_;
                        let _e10069 = phi_7943_;
                        let _e10071 = phi_7944_;
                        let _e10073 = phi_7945_;
                        if _e10067 {
                            phi_7949_ = _e10065;
                            phi_7950_ = _e10063;
                            phi_7951_ = true;
                            phi_7952_ = false;
                            phi_7953_ = false;
                        } else {
                            let _e12240 = local_102;
                            phi_7949_ = _e12240;
                            let _e12243 = local_103;
                            phi_7950_ = _e12243;
                            phi_7951_ = _e10069;
                            phi_7952_ = _e10071;
                            phi_7953_ = _e10073;
                        }
                        let _e10075 = phi_7949_;
                        let _e10077 = phi_7950_;
                        let _e10079 = phi_7951_;
                        let _e10081 = phi_7952_;
                        let _e10083 = phi_7953_;
                        if _e10079 {
                            local_13[0u] = 0.01f;
                            local_13[1u] = 0f;
                            local_13[2u] = 0.8f;
                            if (_e418 >= (1.1102230246251565e-16lf * f64(8f))) {
                                phi_7967_ = _e418;
                            } else {
                                phi_7967_ = f64(0f);
                            }
                            let _e10092 = phi_7967_;
                            phi_7970_ = type_12(0u, 3u);
                            loop {
                                let _e10094 = phi_7970_;
                                if (_e10094.member < _e10094.member_1) {
                                    phi_7971_ = type_12((_e10094.member + 1u), _e10094.member_1);
                                    phi_7994_ = type_12(1u, _e10094.member);
                                } else {
                                    phi_7971_ = _e10094;
                                    phi_7994_ = type_12(0u, type_12().member_1);
                                }
                                let _e10106 = phi_7971_;
                                let _e10108 = phi_7994_;
                                if (bitcast<i32>(_e10108.member) != 0i) {
                                    let _e10114 = local_13[_e10108.member_1];
                                    let _e10117 = (_e10075 + (_e10092 * f64(_e10114)));
                                    if (_e10117 < _e436) {
                                        phi_8016_ = _e10117;
                                    } else {
                                        phi_8016_ = _e436;
                                    }
                                    let _e10120 = phi_8016_;
                                    let _e10123 = local_18.member[0u];
                                    let _e10129 = local_18.member[1u];
                                    let _e10145 = local_18.member_1[0u];
                                    let _e10151 = local_18.member_1[1u];
                                    let _e10167 = local_18.member_2[0u];
                                    let _e10173 = local_18.member_2[1u];
                                    let _e10187 = function_3(array<f64, 3>((_e10123[0] + ((_e10129[0] - _e10123[0]) * _e10120)), (_e10123[1] + ((_e10129[1] - _e10123[1]) * _e10120)), (_e10123[2] + ((_e10129[2] - _e10123[2]) * _e10120))), array<f64, 3>((_e10145[0] + ((_e10151[0] - _e10145[0]) * _e10120)), (_e10145[1] + ((_e10151[1] - _e10145[1]) * _e10120)), (_e10145[2] + ((_e10151[2] - _e10145[2]) * _e10120))), array<f64, 3>((_e10167[0] + ((_e10173[0] - _e10167[0]) * _e10120)), (_e10167[1] + ((_e10173[1] - _e10167[1]) * _e10120)), (_e10167[2] + ((_e10173[2] - _e10167[2]) * _e10120))), 0u);
                                    let _e10198 = (((_e10187[0] * _e10187[0]) + (_e10187[1] * _e10187[1])) + (_e10187[2] * _e10187[2]));
                                    if (_e10198 <= 2.2250738585072014e-308lf) {
                                        if (_e10198 > 0.0lf) {
                                            phi_8139_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_8139_ = 0.0lf;
                                        }
                                        let _e10250 = phi_8139_;
                                        phi_8203_ = _e10250;
                                    } else {
                                        phi_8146_ = type_16(0i, 5i);
                                        phi_8149_ = bitcast<f64>(((bitcast<u64>(_e10198) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e10205 = phi_8146_;
                                            let _e10207 = phi_8149_;
                                            local_62 = _e10207;
                                            if (_e10205.member < _e10205.member_1) {
                                                let _e10214 = (_e10205.member + 1i);
                                                if ((false == (_e10214 > _e10205.member)) != false) {
                                                    phi_8170_ = true;
                                                } else {
                                                    phi_8170_ = false;
                                                }
                                                let _e10219 = phi_8170_;
                                                if _e10219 {
                                                    phi_8176_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_8176_ = type_17(1u, _e10214);
                                                }
                                                let _e10224 = phi_8176_;
                                                phi_8147_ = type_16(_e10224.member_1, _e10205.member_1);
                                                phi_8190_ = type_17(1u, _e10205.member);
                                            } else {
                                                phi_8147_ = _e10205;
                                                phi_8190_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e10230 = phi_8147_;
                                            let _e10232 = phi_8190_;
                                            let _e10235 = (bitcast<i32>(_e10232.member) != 0i);
                                            if _e10235 {
                                                phi_8150_ = (0.5lf * (_e10207 + (_e10198 / _e10207)));
                                            } else {
                                                phi_8150_ = f64();
                                            }
                                            let _e10240 = phi_8150_;
                                            continue;
                                            continuing {
                                                phi_8146_ = _e10230;
                                                phi_8149_ = _e10240;
                                                break if !(_e10235);
                                            }
                                        }
                                        let _e10245 = local_62;
                                        phi_8203_ = (_e10245 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e10252 = phi_8203_;
                                    let _e10260 = local_18.member[0u];
                                    if (_e10260[0] < 0.0lf) {
                                        phi_8221_ = -(_e10260[0]);
                                    } else {
                                        phi_8221_ = _e10260[0];
                                    }
                                    let _e10267 = phi_8221_;
                                    if (_e10260[1] < 0.0lf) {
                                        phi_8228_ = -(_e10260[1]);
                                    } else {
                                        phi_8228_ = _e10260[1];
                                    }
                                    let _e10271 = phi_8228_;
                                    if (_e10267 > _e10271) {
                                        phi_8233_ = _e10267;
                                    } else {
                                        phi_8233_ = _e10271;
                                    }
                                    let _e10274 = phi_8233_;
                                    if (_e10260[2] < 0.0lf) {
                                        phi_8240_ = -(_e10260[2]);
                                    } else {
                                        phi_8240_ = _e10260[2];
                                    }
                                    let _e10278 = phi_8240_;
                                    if (_e10274 > _e10278) {
                                        phi_8245_ = _e10274;
                                    } else {
                                        phi_8245_ = _e10278;
                                    }
                                    let _e10281 = phi_8245_;
                                    let _e10284 = local_18.member[1u];
                                    if (_e10284[0] < 0.0lf) {
                                        phi_8258_ = -(_e10284[0]);
                                    } else {
                                        phi_8258_ = _e10284[0];
                                    }
                                    let _e10291 = phi_8258_;
                                    if (_e10284[1] < 0.0lf) {
                                        phi_8265_ = -(_e10284[1]);
                                    } else {
                                        phi_8265_ = _e10284[1];
                                    }
                                    let _e10295 = phi_8265_;
                                    if (_e10291 > _e10295) {
                                        phi_8270_ = _e10291;
                                    } else {
                                        phi_8270_ = _e10295;
                                    }
                                    let _e10298 = phi_8270_;
                                    if (_e10284[2] < 0.0lf) {
                                        phi_8277_ = -(_e10284[2]);
                                    } else {
                                        phi_8277_ = _e10284[2];
                                    }
                                    let _e10302 = phi_8277_;
                                    if (_e10298 > _e10302) {
                                        phi_8282_ = _e10298;
                                    } else {
                                        phi_8282_ = _e10302;
                                    }
                                    let _e10305 = phi_8282_;
                                    if (_e10281 > _e10305) {
                                        phi_8287_ = _e10281;
                                    } else {
                                        phi_8287_ = _e10305;
                                    }
                                    let _e10308 = phi_8287_;
                                    let _e10310 = local_18.member_3;
                                    let _e10314 = local_18.member_1[0u];
                                    if (_e10314[0] < 0.0lf) {
                                        phi_8304_ = -(_e10314[0]);
                                    } else {
                                        phi_8304_ = _e10314[0];
                                    }
                                    let _e10321 = phi_8304_;
                                    if (_e10314[1] < 0.0lf) {
                                        phi_8311_ = -(_e10314[1]);
                                    } else {
                                        phi_8311_ = _e10314[1];
                                    }
                                    let _e10325 = phi_8311_;
                                    if (_e10321 > _e10325) {
                                        phi_8316_ = _e10321;
                                    } else {
                                        phi_8316_ = _e10325;
                                    }
                                    let _e10328 = phi_8316_;
                                    if (_e10314[2] < 0.0lf) {
                                        phi_8323_ = -(_e10314[2]);
                                    } else {
                                        phi_8323_ = _e10314[2];
                                    }
                                    let _e10332 = phi_8323_;
                                    if (_e10328 > _e10332) {
                                        phi_8328_ = _e10328;
                                    } else {
                                        phi_8328_ = _e10332;
                                    }
                                    let _e10335 = phi_8328_;
                                    let _e10338 = local_18.member_1[1u];
                                    if (_e10338[0] < 0.0lf) {
                                        phi_8342_ = -(_e10338[0]);
                                    } else {
                                        phi_8342_ = _e10338[0];
                                    }
                                    let _e10345 = phi_8342_;
                                    if (_e10338[1] < 0.0lf) {
                                        phi_8349_ = -(_e10338[1]);
                                    } else {
                                        phi_8349_ = _e10338[1];
                                    }
                                    let _e10349 = phi_8349_;
                                    if (_e10345 > _e10349) {
                                        phi_8354_ = _e10345;
                                    } else {
                                        phi_8354_ = _e10349;
                                    }
                                    let _e10352 = phi_8354_;
                                    if (_e10338[2] < 0.0lf) {
                                        phi_8361_ = -(_e10338[2]);
                                    } else {
                                        phi_8361_ = _e10338[2];
                                    }
                                    let _e10356 = phi_8361_;
                                    if (_e10352 > _e10356) {
                                        phi_8366_ = _e10352;
                                    } else {
                                        phi_8366_ = _e10356;
                                    }
                                    let _e10359 = phi_8366_;
                                    if (_e10335 > _e10359) {
                                        phi_8371_ = _e10335;
                                    } else {
                                        phi_8371_ = _e10359;
                                    }
                                    let _e10362 = phi_8371_;
                                    let _e10364 = local_18.member_3;
                                    let _e10368 = local_18.member_2[0u];
                                    if (_e10368[0] < 0.0lf) {
                                        phi_8388_ = -(_e10368[0]);
                                    } else {
                                        phi_8388_ = _e10368[0];
                                    }
                                    let _e10375 = phi_8388_;
                                    if (_e10368[1] < 0.0lf) {
                                        phi_8395_ = -(_e10368[1]);
                                    } else {
                                        phi_8395_ = _e10368[1];
                                    }
                                    let _e10379 = phi_8395_;
                                    if (_e10375 > _e10379) {
                                        phi_8400_ = _e10375;
                                    } else {
                                        phi_8400_ = _e10379;
                                    }
                                    let _e10382 = phi_8400_;
                                    if (_e10368[2] < 0.0lf) {
                                        phi_8407_ = -(_e10368[2]);
                                    } else {
                                        phi_8407_ = _e10368[2];
                                    }
                                    let _e10386 = phi_8407_;
                                    if (_e10382 > _e10386) {
                                        phi_8412_ = _e10382;
                                    } else {
                                        phi_8412_ = _e10386;
                                    }
                                    let _e10389 = phi_8412_;
                                    let _e10392 = local_18.member_2[1u];
                                    if (_e10392[0] < 0.0lf) {
                                        phi_8426_ = -(_e10392[0]);
                                    } else {
                                        phi_8426_ = _e10392[0];
                                    }
                                    let _e10399 = phi_8426_;
                                    if (_e10392[1] < 0.0lf) {
                                        phi_8433_ = -(_e10392[1]);
                                    } else {
                                        phi_8433_ = _e10392[1];
                                    }
                                    let _e10403 = phi_8433_;
                                    if (_e10399 > _e10403) {
                                        phi_8438_ = _e10399;
                                    } else {
                                        phi_8438_ = _e10403;
                                    }
                                    let _e10406 = phi_8438_;
                                    if (_e10392[2] < 0.0lf) {
                                        phi_8445_ = -(_e10392[2]);
                                    } else {
                                        phi_8445_ = _e10392[2];
                                    }
                                    let _e10410 = phi_8445_;
                                    if (_e10406 > _e10410) {
                                        phi_8450_ = _e10406;
                                    } else {
                                        phi_8450_ = _e10410;
                                    }
                                    let _e10413 = phi_8450_;
                                    if (_e10389 > _e10413) {
                                        phi_8455_ = _e10389;
                                    } else {
                                        phi_8455_ = _e10413;
                                    }
                                    let _e10416 = phi_8455_;
                                    let _e10418 = local_18.member_3;
                                    let _e10426 = local_18.member_3;
                                    let _e10436 = (((_e10252 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e10308 + _e10310) + (_e10362 + _e10364)) + (_e10416 + _e10418)) * (1.1102230246251565e-16lf * f64(16f))) + (_e10426 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e640.member_1);
                                    if _e10436 {
                                        phi_8479_ = false;
                                    } else {
                                        phi_8479_ = true;
                                    }
                                    let _e10438 = phi_8479_;
                                    phi_8480_ = _e10438;
                                    phi_8481_ = _e10436;
                                } else {
                                    phi_8480_ = false;
                                    phi_8481_ = false;
                                }
                                let _e10440 = phi_8480_;
                                let _e10442 = phi_8481_;
                                local_63 = _e10442;
                                continue;
                                continuing {
                                    phi_7970_ = _e10106;
                                    break if !(_e10440);
                                }
                            }
                            let _e10445 = local_63;
                            if _e10445 {
                                if (_e10075 > _e427) {
                                    phi_8489_ = 1u;
                                } else {
                                    phi_8489_ = _e10077;
                                }
                                let _e10448 = phi_8489_;
                                phi_8493_ = type_47(type_46(1u, _e10075), _e10448);
                                phi_8494_ = false;
                            } else {
                                phi_8493_ = type_47();
                                phi_8494_ = true;
                            }
                            let _e10452 = phi_8493_;
                            let _e10454 = phi_8494_;
                            if _e10454 {
                                if (_e10075 > _e427) {
                                    phi_8502_ = 0u;
                                } else {
                                    phi_8502_ = _e10077;
                                }
                                let _e10457 = phi_8502_;
                                phi_8506_ = type_47(type_46(2u, _e10075), _e10457);
                            } else {
                                phi_8506_ = _e10452;
                            }
                            let _e10461 = phi_8506_;
                            phi_8507_ = _e10461;
                            phi_8508_ = false;
                            phi_8509_ = false;
                        } else {
                            phi_8507_ = type_47();
                            phi_8508_ = _e10081;
                            phi_8509_ = _e10083;
                        }
                        let _e10463 = phi_8507_;
                        let _e10465 = phi_8508_;
                        let _e10467 = phi_8509_;
                        if _e10465 {
                            phi_8516_ = type_47(type_46(0u, f64()), 0u);
                            phi_8517_ = true;
                        } else {
                            phi_8516_ = _e10053;
                            phi_8517_ = _e10467;
                        }
                        let _e10471 = phi_8516_;
                        let _e10473 = phi_8517_;
                        phi_8521_ = _e10471;
                        phi_8522_ = _e10463;
                        phi_8523_ = _e10473;
                    } else {
                        phi_8521_ = _e6641;
                        phi_8522_ = type_47();
                        phi_8523_ = true;
                    }
                    let _e10475 = phi_8521_;
                    let _e10477 = phi_8522_;
                    let _e10479 = phi_8523_;
                    if _e10479 {
                        phi_8527_ = _e10475;
                    } else {
                        phi_8527_ = _e10477;
                    }
                    let _e10481 = phi_8527_;
                    phi_16194_ = _e10481;
                } else {
                    let _e683 = f64(0f);
                    let _e686 = local_18.member_1[0u];
                    let _e692 = local_18.member_2[0u];
                    let _e698 = ((_e686[1] * _e692[2]) - (_e686[2] * _e692[1]));
                    let _e701 = ((_e686[2] * _e692[0]) - (_e686[0] * _e692[2]));
                    let _e704 = ((_e686[0] * _e692[1]) - (_e686[1] * _e692[0]));
                    let _e707 = local_18.member_1[1u];
                    let _e713 = local_18.member_2[1u];
                    let _e719 = ((_e707[1] * _e713[2]) - (_e707[2] * _e713[1]));
                    let _e722 = ((_e707[2] * _e713[0]) - (_e707[0] * _e713[2]));
                    let _e725 = ((_e707[0] * _e713[1]) - (_e707[1] * _e713[0]));
                    let _e728 = local_18.member_1[0u];
                    let _e734 = local_18.member_2[1u];
                    let _e749 = local_18.member_1[1u];
                    let _e755 = local_18.member_2[0u];
                    let _e768 = (((_e728[1] * _e734[2]) - (_e728[2] * _e734[1])) + ((_e749[1] * _e755[2]) - (_e749[2] * _e755[1])));
                    let _e769 = (((_e728[2] * _e734[0]) - (_e728[0] * _e734[2])) + ((_e749[2] * _e755[0]) - (_e749[0] * _e755[2])));
                    let _e770 = (((_e728[0] * _e734[1]) - (_e728[1] * _e734[0])) + ((_e749[0] * _e755[1]) - (_e749[1] * _e755[0])));
                    let _e773 = local_18.member[0u];
                    let _e781 = (((_e773[0] * _e698) + (_e773[1] * _e701)) + (_e773[2] * _e704));
                    let _e784 = local_18.member[1u];
                    let _e795 = local_18.member[0u];
                    let _e804 = ((((_e784[0] * _e698) + (_e784[1] * _e701)) + (_e784[2] * _e704)) + (((_e795[0] * _e768) + (_e795[1] * _e769)) + (_e795[2] * _e770)));
                    let _e807 = local_18.member[0u];
                    let _e818 = local_18.member[1u];
                    let _e827 = ((((_e807[0] * _e719) + (_e807[1] * _e722)) + (_e807[2] * _e725)) + (((_e818[0] * _e768) + (_e818[1] * _e769)) + (_e818[2] * _e770)));
                    let _e830 = local_18.member[1u];
                    let _e838 = (((_e830[0] * _e719) + (_e830[1] * _e722)) + (_e830[2] * _e725));
                    let _e841 = local_18.member[0u];
                    if (_e841[0] < 0.0lf) {
                        phi_8770_ = -(_e841[0]);
                    } else {
                        phi_8770_ = _e841[0];
                    }
                    let _e848 = phi_8770_;
                    if (_e841[1] < 0.0lf) {
                        phi_8777_ = -(_e841[1]);
                    } else {
                        phi_8777_ = _e841[1];
                    }
                    let _e852 = phi_8777_;
                    if (_e848 > _e852) {
                        phi_8782_ = _e848;
                    } else {
                        phi_8782_ = _e852;
                    }
                    let _e855 = phi_8782_;
                    if (_e841[2] < 0.0lf) {
                        phi_8789_ = -(_e841[2]);
                    } else {
                        phi_8789_ = _e841[2];
                    }
                    let _e859 = phi_8789_;
                    if (_e855 > _e859) {
                        phi_8794_ = _e855;
                    } else {
                        phi_8794_ = _e859;
                    }
                    let _e862 = phi_8794_;
                    let _e865 = local_18.member[1u];
                    if (_e865[0] < 0.0lf) {
                        phi_8807_ = -(_e865[0]);
                    } else {
                        phi_8807_ = _e865[0];
                    }
                    let _e872 = phi_8807_;
                    if (_e865[1] < 0.0lf) {
                        phi_8814_ = -(_e865[1]);
                    } else {
                        phi_8814_ = _e865[1];
                    }
                    let _e876 = phi_8814_;
                    if (_e872 > _e876) {
                        phi_8819_ = _e872;
                    } else {
                        phi_8819_ = _e876;
                    }
                    let _e879 = phi_8819_;
                    if (_e865[2] < 0.0lf) {
                        phi_8826_ = -(_e865[2]);
                    } else {
                        phi_8826_ = _e865[2];
                    }
                    let _e883 = phi_8826_;
                    if (_e879 > _e883) {
                        phi_8831_ = _e879;
                    } else {
                        phi_8831_ = _e883;
                    }
                    let _e886 = phi_8831_;
                    if (_e862 > _e886) {
                        phi_8836_ = _e862;
                    } else {
                        phi_8836_ = _e886;
                    }
                    let _e889 = phi_8836_;
                    let _e891 = local_18.member_3;
                    let _e892 = (_e889 + _e891);
                    let _e895 = local_18.member_1[0u];
                    if (_e895[0] < 0.0lf) {
                        phi_8853_ = -(_e895[0]);
                    } else {
                        phi_8853_ = _e895[0];
                    }
                    let _e902 = phi_8853_;
                    if (_e895[1] < 0.0lf) {
                        phi_8860_ = -(_e895[1]);
                    } else {
                        phi_8860_ = _e895[1];
                    }
                    let _e906 = phi_8860_;
                    if (_e902 > _e906) {
                        phi_8865_ = _e902;
                    } else {
                        phi_8865_ = _e906;
                    }
                    let _e909 = phi_8865_;
                    if (_e895[2] < 0.0lf) {
                        phi_8872_ = -(_e895[2]);
                    } else {
                        phi_8872_ = _e895[2];
                    }
                    let _e913 = phi_8872_;
                    if (_e909 > _e913) {
                        phi_8877_ = _e909;
                    } else {
                        phi_8877_ = _e913;
                    }
                    let _e916 = phi_8877_;
                    let _e919 = local_18.member_1[1u];
                    if (_e919[0] < 0.0lf) {
                        phi_8891_ = -(_e919[0]);
                    } else {
                        phi_8891_ = _e919[0];
                    }
                    let _e926 = phi_8891_;
                    if (_e919[1] < 0.0lf) {
                        phi_8898_ = -(_e919[1]);
                    } else {
                        phi_8898_ = _e919[1];
                    }
                    let _e930 = phi_8898_;
                    if (_e926 > _e930) {
                        phi_8903_ = _e926;
                    } else {
                        phi_8903_ = _e930;
                    }
                    let _e933 = phi_8903_;
                    if (_e919[2] < 0.0lf) {
                        phi_8910_ = -(_e919[2]);
                    } else {
                        phi_8910_ = _e919[2];
                    }
                    let _e937 = phi_8910_;
                    if (_e933 > _e937) {
                        phi_8915_ = _e933;
                    } else {
                        phi_8915_ = _e937;
                    }
                    let _e940 = phi_8915_;
                    if (_e916 > _e940) {
                        phi_8920_ = _e916;
                    } else {
                        phi_8920_ = _e940;
                    }
                    let _e943 = phi_8920_;
                    let _e945 = local_18.member_3;
                    let _e946 = (_e943 + _e945);
                    let _e949 = local_18.member_2[0u];
                    if (_e949[0] < 0.0lf) {
                        phi_8937_ = -(_e949[0]);
                    } else {
                        phi_8937_ = _e949[0];
                    }
                    let _e956 = phi_8937_;
                    if (_e949[1] < 0.0lf) {
                        phi_8944_ = -(_e949[1]);
                    } else {
                        phi_8944_ = _e949[1];
                    }
                    let _e960 = phi_8944_;
                    if (_e956 > _e960) {
                        phi_8949_ = _e956;
                    } else {
                        phi_8949_ = _e960;
                    }
                    let _e963 = phi_8949_;
                    if (_e949[2] < 0.0lf) {
                        phi_8956_ = -(_e949[2]);
                    } else {
                        phi_8956_ = _e949[2];
                    }
                    let _e967 = phi_8956_;
                    if (_e963 > _e967) {
                        phi_8961_ = _e963;
                    } else {
                        phi_8961_ = _e967;
                    }
                    let _e970 = phi_8961_;
                    let _e973 = local_18.member_2[1u];
                    if (_e973[0] < 0.0lf) {
                        phi_8975_ = -(_e973[0]);
                    } else {
                        phi_8975_ = _e973[0];
                    }
                    let _e980 = phi_8975_;
                    if (_e973[1] < 0.0lf) {
                        phi_8982_ = -(_e973[1]);
                    } else {
                        phi_8982_ = _e973[1];
                    }
                    let _e984 = phi_8982_;
                    if (_e980 > _e984) {
                        phi_8987_ = _e980;
                    } else {
                        phi_8987_ = _e984;
                    }
                    let _e987 = phi_8987_;
                    if (_e973[2] < 0.0lf) {
                        phi_8994_ = -(_e973[2]);
                    } else {
                        phi_8994_ = _e973[2];
                    }
                    let _e991 = phi_8994_;
                    if (_e987 > _e991) {
                        phi_8999_ = _e987;
                    } else {
                        phi_8999_ = _e991;
                    }
                    let _e994 = phi_8999_;
                    if (_e970 > _e994) {
                        phi_9004_ = _e970;
                    } else {
                        phi_9004_ = _e994;
                    }
                    let _e997 = phi_9004_;
                    let _e999 = local_18.member_3;
                    let _e1000 = (_e997 + _e999);
                    let _e1001 = f64(1f);
                    let _e1002 = f64(8f);
                    let _e1004 = ((_e946 * _e1002) * _e1000);
                    let _e1012 = local_18.member_3;
                    if (_e698 < 0.0lf) {
                        phi_9041_ = -(_e698);
                    } else {
                        phi_9041_ = _e698;
                    }
                    let _e1032 = phi_9041_;
                    if (_e701 < 0.0lf) {
                        phi_9047_ = -(_e701);
                    } else {
                        phi_9047_ = _e701;
                    }
                    let _e1036 = phi_9047_;
                    if (_e704 < 0.0lf) {
                        phi_9054_ = -(_e704);
                    } else {
                        phi_9054_ = _e704;
                    }
                    let _e1041 = phi_9054_;
                    let _e1042 = ((_e1032 + _e1036) + _e1041);
                    if (_e719 < 0.0lf) {
                        phi_9061_ = -(_e719);
                    } else {
                        phi_9061_ = _e719;
                    }
                    let _e1046 = phi_9061_;
                    if (_e722 < 0.0lf) {
                        phi_9067_ = -(_e722);
                    } else {
                        phi_9067_ = _e722;
                    }
                    let _e1050 = phi_9067_;
                    if (_e725 < 0.0lf) {
                        phi_9074_ = -(_e725);
                    } else {
                        phi_9074_ = _e725;
                    }
                    let _e1055 = phi_9074_;
                    let _e1056 = ((_e1046 + _e1050) + _e1055);
                    if (_e1042 > _e1056) {
                        phi_9080_ = _e1042;
                    } else {
                        phi_9080_ = _e1056;
                    }
                    let _e1059 = phi_9080_;
                    if (_e768 < 0.0lf) {
                        phi_9086_ = -(_e768);
                    } else {
                        phi_9086_ = _e768;
                    }
                    let _e1063 = phi_9086_;
                    if (_e769 < 0.0lf) {
                        phi_9092_ = -(_e769);
                    } else {
                        phi_9092_ = _e769;
                    }
                    let _e1067 = phi_9092_;
                    if (_e770 < 0.0lf) {
                        phi_9099_ = -(_e770);
                    } else {
                        phi_9099_ = _e770;
                    }
                    let _e1072 = phi_9099_;
                    let _e1074 = (((_e1063 + _e1067) + _e1072) * f64(0.5f));
                    if (_e1059 > _e1074) {
                        phi_9106_ = _e1059;
                    } else {
                        phi_9106_ = _e1074;
                    }
                    let _e1077 = phi_9106_;
                    let _e1083 = local_18.member_3;
                    let _e1097 = (((((_e892 * _e1002) * _e1004) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1012 * f64(19f)) * ((_e892 * (_e946 + _e1000)) + (_e946 * _e1000)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1001 + _e892) * ((_e1001 + _e946) * (_e1001 + _e1000)))));
                    let _e1098 = f64(3f);
                    let _e1099 = (_e781 * _e1098);
                    let _e1100 = (_e838 * _e1098);
                    if (_e1099 < _e1100) {
                        phi_9134_ = _e1099;
                    } else {
                        phi_9134_ = _e1100;
                    }
                    let _e1103 = phi_9134_;
                    if (_e804 < _e827) {
                        phi_9139_ = _e804;
                    } else {
                        phi_9139_ = _e827;
                    }
                    let _e1106 = phi_9139_;
                    if (_e1103 < _e1106) {
                        phi_9144_ = _e1103;
                    } else {
                        phi_9144_ = _e1106;
                    }
                    let _e1109 = phi_9144_;
                    if (_e1099 > _e1100) {
                        phi_9149_ = _e1099;
                    } else {
                        phi_9149_ = _e1100;
                    }
                    let _e1112 = phi_9149_;
                    if (_e804 > _e827) {
                        phi_9154_ = _e804;
                    } else {
                        phi_9154_ = _e827;
                    }
                    let _e1115 = phi_9154_;
                    if (_e1112 > _e1115) {
                        phi_9159_ = _e1112;
                    } else {
                        phi_9159_ = _e1115;
                    }
                    let _e1118 = phi_9159_;
                    let _e1124 = -(_e1118);
                    if (_e1109 > _e1124) {
                        phi_9170_ = _e1109;
                    } else {
                        phi_9170_ = _e1124;
                    }
                    let _e1127 = phi_9170_;
                    if ((_e1127 - (_e1097 + ((_e683 * (((_e1077 + (_e1004 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1083 * f64(6f)) * (_e946 + _e1000))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1001 + _e946) * (_e1001 + _e1000))))) * f64((3f * 1.0001f))))) > _e683) {
                        phi_16164_ = type_46(0u, type_46().member_1);
                        phi_16165_ = type_46();
                        phi_16166_ = true;
                    } else {
                        if (_e781 < 0.0lf) {
                            phi_9184_ = -(_e781);
                        } else {
                            phi_9184_ = _e781;
                        }
                        let _e1135 = phi_9184_;
                        if (_e804 < 0.0lf) {
                            phi_9190_ = -(_e804);
                        } else {
                            phi_9190_ = _e804;
                        }
                        let _e1139 = phi_9190_;
                        if (_e1135 > _e1139) {
                            phi_9195_ = _e1135;
                        } else {
                            phi_9195_ = _e1139;
                        }
                        let _e1142 = phi_9195_;
                        if (_e827 < 0.0lf) {
                            phi_9201_ = -(_e827);
                        } else {
                            phi_9201_ = _e827;
                        }
                        let _e1146 = phi_9201_;
                        if (_e838 < 0.0lf) {
                            phi_9207_ = -(_e838);
                        } else {
                            phi_9207_ = _e838;
                        }
                        let _e1150 = phi_9207_;
                        if (_e1146 > _e1150) {
                            phi_9212_ = _e1146;
                        } else {
                            phi_9212_ = _e1150;
                        }
                        let _e1153 = phi_9212_;
                        if (_e1142 > _e1153) {
                            phi_9217_ = _e1142;
                        } else {
                            phi_9217_ = _e1153;
                        }
                        let _e1156 = phi_9217_;
                        let _e1158 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1159 = f64(1f);
                        if (_e1156 >= _e1158) {
                            phi_9227_ = (_e1156 <= (_e1159 / _e1158));
                        } else {
                            phi_9227_ = false;
                        }
                        let _e1164 = phi_9227_;
                        if _e1164 {
                            phi_9234_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_9234_ = f64(2f);
                        }
                        let _e1169 = phi_9234_;
                        let _e1171 = ((_e1097 * f64(0.34f)) + (_e1156 * _e1169));
                        if _e1164 {
                            phi_9242_ = (_e1159 / _e1156);
                        } else {
                            phi_9242_ = f64(0f);
                        }
                        let _e1175 = phi_9242_;
                        let _e1176 = f64(0.00000000000022737368f);
                        let _e1178 = (_e418 * f64(0.0625f));
                        if (_e1176 < _e1178) {
                            phi_9250_ = _e1176;
                        } else {
                            phi_9250_ = _e1178;
                        }
                        let _e1181 = phi_9250_;
                        let _e1183 = (f64(1f) - _e427);
                        let _e1194 = ((((_e781 * _e1183) + (_e804 * _e427)) * (_e1183 * _e1183)) + (((_e827 * _e1183) + (_e838 * _e427)) * (_e427 * _e427)));
                        if (_e1194 < 0.0lf) {
                            phi_9269_ = -(_e1194);
                        } else {
                            phi_9269_ = _e1194;
                        }
                        let _e1198 = phi_9269_;
                        if !((_e1198 > _e1171)) {
                            let _e1201 = f64(0f);
                            let _e1204 = local_18.member[0u];
                            let _e1210 = local_18.member_1[0u];
                            let _e1216 = local_18.member_2[0u];
                            let _e1220 = (_e1204[0] - _e1210[0]);
                            let _e1221 = (_e1204[1] - _e1210[1]);
                            let _e1222 = (_e1204[2] - _e1210[2]);
                            let _e1223 = (_e1204[0] - _e1216[0]);
                            let _e1224 = (_e1204[1] - _e1216[1]);
                            let _e1225 = (_e1204[2] - _e1216[2]);
                            let _e1228 = local_18.member[1u];
                            let _e1234 = local_18.member_1[1u];
                            let _e1240 = local_18.member_2[1u];
                            let _e1244 = (_e1228[0] - _e1234[0]);
                            let _e1245 = (_e1228[1] - _e1234[1]);
                            let _e1246 = (_e1228[2] - _e1234[2]);
                            let _e1247 = (_e1228[0] - _e1240[0]);
                            let _e1248 = (_e1228[1] - _e1240[1]);
                            let _e1249 = (_e1228[2] - _e1240[2]);
                            let _e1252 = local_18.member[0u];
                            if (_e1252[0] < 0.0lf) {
                                phi_9418_ = -(_e1252[0]);
                            } else {
                                phi_9418_ = _e1252[0];
                            }
                            let _e1259 = phi_9418_;
                            if (_e1252[1] < 0.0lf) {
                                phi_9425_ = -(_e1252[1]);
                            } else {
                                phi_9425_ = _e1252[1];
                            }
                            let _e1263 = phi_9425_;
                            if (_e1259 > _e1263) {
                                phi_9430_ = _e1259;
                            } else {
                                phi_9430_ = _e1263;
                            }
                            let _e1266 = phi_9430_;
                            if (_e1252[2] < 0.0lf) {
                                phi_9437_ = -(_e1252[2]);
                            } else {
                                phi_9437_ = _e1252[2];
                            }
                            let _e1270 = phi_9437_;
                            if (_e1266 > _e1270) {
                                phi_9442_ = _e1266;
                            } else {
                                phi_9442_ = _e1270;
                            }
                            let _e1273 = phi_9442_;
                            let _e1276 = local_18.member[1u];
                            if (_e1276[0] < 0.0lf) {
                                phi_9455_ = -(_e1276[0]);
                            } else {
                                phi_9455_ = _e1276[0];
                            }
                            let _e1283 = phi_9455_;
                            if (_e1276[1] < 0.0lf) {
                                phi_9462_ = -(_e1276[1]);
                            } else {
                                phi_9462_ = _e1276[1];
                            }
                            let _e1287 = phi_9462_;
                            if (_e1283 > _e1287) {
                                phi_9467_ = _e1283;
                            } else {
                                phi_9467_ = _e1287;
                            }
                            let _e1290 = phi_9467_;
                            if (_e1276[2] < 0.0lf) {
                                phi_9474_ = -(_e1276[2]);
                            } else {
                                phi_9474_ = _e1276[2];
                            }
                            let _e1294 = phi_9474_;
                            if (_e1290 > _e1294) {
                                phi_9479_ = _e1290;
                            } else {
                                phi_9479_ = _e1294;
                            }
                            let _e1297 = phi_9479_;
                            if (_e1273 > _e1297) {
                                phi_9484_ = _e1273;
                            } else {
                                phi_9484_ = _e1297;
                            }
                            let _e1300 = phi_9484_;
                            let _e1302 = local_18.member_3;
                            let _e1306 = local_18.member_1[0u];
                            if (_e1306[0] < 0.0lf) {
                                phi_9501_ = -(_e1306[0]);
                            } else {
                                phi_9501_ = _e1306[0];
                            }
                            let _e1313 = phi_9501_;
                            if (_e1306[1] < 0.0lf) {
                                phi_9508_ = -(_e1306[1]);
                            } else {
                                phi_9508_ = _e1306[1];
                            }
                            let _e1317 = phi_9508_;
                            if (_e1313 > _e1317) {
                                phi_9513_ = _e1313;
                            } else {
                                phi_9513_ = _e1317;
                            }
                            let _e1320 = phi_9513_;
                            if (_e1306[2] < 0.0lf) {
                                phi_9520_ = -(_e1306[2]);
                            } else {
                                phi_9520_ = _e1306[2];
                            }
                            let _e1324 = phi_9520_;
                            if (_e1320 > _e1324) {
                                phi_9525_ = _e1320;
                            } else {
                                phi_9525_ = _e1324;
                            }
                            let _e1327 = phi_9525_;
                            let _e1330 = local_18.member_1[1u];
                            if (_e1330[0] < 0.0lf) {
                                phi_9539_ = -(_e1330[0]);
                            } else {
                                phi_9539_ = _e1330[0];
                            }
                            let _e1337 = phi_9539_;
                            if (_e1330[1] < 0.0lf) {
                                phi_9546_ = -(_e1330[1]);
                            } else {
                                phi_9546_ = _e1330[1];
                            }
                            let _e1341 = phi_9546_;
                            if (_e1337 > _e1341) {
                                phi_9551_ = _e1337;
                            } else {
                                phi_9551_ = _e1341;
                            }
                            let _e1344 = phi_9551_;
                            if (_e1330[2] < 0.0lf) {
                                phi_9558_ = -(_e1330[2]);
                            } else {
                                phi_9558_ = _e1330[2];
                            }
                            let _e1348 = phi_9558_;
                            if (_e1344 > _e1348) {
                                phi_9563_ = _e1344;
                            } else {
                                phi_9563_ = _e1348;
                            }
                            let _e1351 = phi_9563_;
                            if (_e1327 > _e1351) {
                                phi_9568_ = _e1327;
                            } else {
                                phi_9568_ = _e1351;
                            }
                            let _e1354 = phi_9568_;
                            let _e1356 = local_18.member_3;
                            let _e1360 = local_18.member_2[0u];
                            if (_e1360[0] < 0.0lf) {
                                phi_9585_ = -(_e1360[0]);
                            } else {
                                phi_9585_ = _e1360[0];
                            }
                            let _e1367 = phi_9585_;
                            if (_e1360[1] < 0.0lf) {
                                phi_9592_ = -(_e1360[1]);
                            } else {
                                phi_9592_ = _e1360[1];
                            }
                            let _e1371 = phi_9592_;
                            if (_e1367 > _e1371) {
                                phi_9597_ = _e1367;
                            } else {
                                phi_9597_ = _e1371;
                            }
                            let _e1374 = phi_9597_;
                            if (_e1360[2] < 0.0lf) {
                                phi_9604_ = -(_e1360[2]);
                            } else {
                                phi_9604_ = _e1360[2];
                            }
                            let _e1378 = phi_9604_;
                            if (_e1374 > _e1378) {
                                phi_9609_ = _e1374;
                            } else {
                                phi_9609_ = _e1378;
                            }
                            let _e1381 = phi_9609_;
                            let _e1384 = local_18.member_2[1u];
                            if (_e1384[0] < 0.0lf) {
                                phi_9623_ = -(_e1384[0]);
                            } else {
                                phi_9623_ = _e1384[0];
                            }
                            let _e1391 = phi_9623_;
                            if (_e1384[1] < 0.0lf) {
                                phi_9630_ = -(_e1384[1]);
                            } else {
                                phi_9630_ = _e1384[1];
                            }
                            let _e1395 = phi_9630_;
                            if (_e1391 > _e1395) {
                                phi_9635_ = _e1391;
                            } else {
                                phi_9635_ = _e1395;
                            }
                            let _e1398 = phi_9635_;
                            if (_e1384[2] < 0.0lf) {
                                phi_9642_ = -(_e1384[2]);
                            } else {
                                phi_9642_ = _e1384[2];
                            }
                            let _e1402 = phi_9642_;
                            if (_e1398 > _e1402) {
                                phi_9647_ = _e1398;
                            } else {
                                phi_9647_ = _e1402;
                            }
                            let _e1405 = phi_9647_;
                            if (_e1381 > _e1405) {
                                phi_9652_ = _e1381;
                            } else {
                                phi_9652_ = _e1405;
                            }
                            let _e1408 = phi_9652_;
                            let _e1410 = local_18.member_3;
                            let _e1418 = local_18.member_3;
                            let _e1424 = ((((((_e1300 + _e1302) + (_e1354 + _e1356)) + (_e1408 + _e1410)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1418 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f)));
                            let _e1427 = local_18.member[0u];
                            let _e1433 = local_18.member[1u];
                            let _e1449 = local_18.member_1[0u];
                            let _e1455 = local_18.member_1[1u];
                            let _e1471 = local_18.member_2[0u];
                            let _e1477 = local_18.member_2[1u];
                            let _e1491 = function_3(array<f64, 3>((_e1427[0] + ((_e1433[0] - _e1427[0]) * _e427)), (_e1427[1] + ((_e1433[1] - _e1427[1]) * _e427)), (_e1427[2] + ((_e1433[2] - _e1427[2]) * _e427))), array<f64, 3>((_e1449[0] + ((_e1455[0] - _e1449[0]) * _e427)), (_e1449[1] + ((_e1455[1] - _e1449[1]) * _e427)), (_e1449[2] + ((_e1455[2] - _e1449[2]) * _e427))), array<f64, 3>((_e1471[0] + ((_e1477[0] - _e1471[0]) * _e427)), (_e1471[1] + ((_e1477[1] - _e1471[1]) * _e427)), (_e1471[2] + ((_e1477[2] - _e1471[2]) * _e427))), 0u);
                            if (_e1491[0] < 0.0lf) {
                                phi_9773_ = -(_e1491[0]);
                            } else {
                                phi_9773_ = _e1491[0];
                            }
                            let _e1496 = phi_9773_;
                            if (_e1491[1] < 0.0lf) {
                                phi_9780_ = -(_e1491[1]);
                            } else {
                                phi_9780_ = _e1491[1];
                            }
                            let _e1501 = phi_9780_;
                            if (_e1491[2] < 0.0lf) {
                                phi_9788_ = -(_e1491[2]);
                            } else {
                                phi_9788_ = _e1491[2];
                            }
                            let _e1507 = phi_9788_;
                            let _e1508 = ((_e1496 + _e1501) + _e1507);
                            if (_e1508 > f64(0f)) {
                                if ((bitcast<u64>(_e1508) & 9218868437227405312lu) != 9218868437227405312lu) {
                                    let _e1515 = (f64(1f) / _e1508);
                                    let _e1517 = (_e1491[0] * _e1515);
                                    let _e1519 = (_e1491[1] * _e1515);
                                    let _e1521 = (_e1491[2] * _e1515);
                                    let _e1526 = (((_e1517 * _e1517) + (_e1519 * _e1519)) + (_e1521 * _e1521));
                                    if (_e1526 <= 2.2250738585072014e-308lf) {
                                        if (_e1526 > 0.0lf) {
                                            phi_9827_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_9827_ = 0.0lf;
                                        }
                                        let _e1578 = phi_9827_;
                                        phi_9891_ = _e1578;
                                    } else {
                                        phi_9834_ = type_16(0i, 5i);
                                        phi_9837_ = bitcast<f64>(((bitcast<u64>(_e1526) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1533 = phi_9834_;
                                            let _e1535 = phi_9837_;
                                            local_19 = _e1535;
                                            if (_e1533.member < _e1533.member_1) {
                                                let _e1542 = (_e1533.member + 1i);
                                                if ((false == (_e1542 > _e1533.member)) != false) {
                                                    phi_9858_ = true;
                                                } else {
                                                    phi_9858_ = false;
                                                }
                                                let _e1547 = phi_9858_;
                                                if _e1547 {
                                                    phi_9864_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_9864_ = type_17(1u, _e1542);
                                                }
                                                let _e1552 = phi_9864_;
                                                phi_9835_ = type_16(_e1552.member_1, _e1533.member_1);
                                                phi_9878_ = type_17(1u, _e1533.member);
                                            } else {
                                                phi_9835_ = _e1533;
                                                phi_9878_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e1558 = phi_9835_;
                                            let _e1560 = phi_9878_;
                                            let _e1563 = (bitcast<i32>(_e1560.member) != 0i);
                                            if _e1563 {
                                                phi_9838_ = (0.5lf * (_e1535 + (_e1526 / _e1535)));
                                            } else {
                                                phi_9838_ = f64();
                                            }
                                            let _e1568 = phi_9838_;
                                            continue;
                                            continuing {
                                                phi_9834_ = _e1558;
                                                phi_9837_ = _e1568;
                                                break if !(_e1563);
                                            }
                                        }
                                        let _e1573 = local_19;
                                        phi_9891_ = (_e1573 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e1580 = phi_9891_;
                                    let _e1582 = (1.1102230246251565e-16lf * f64(12f));
                                    let _e1589 = ((_e1424 * f64(1.01f)) + ((_e1201 * _e1580) * (f64(1f) + _e1582)));
                                    let _e1594 = (((_e1517 * _e1204[0]) + (_e1519 * _e1204[1])) + (_e1521 * _e1204[2]));
                                    let _e1599 = (((_e1517 * _e1220) + (_e1519 * _e1221)) + (_e1521 * _e1222));
                                    let _e1604 = (((_e1517 * _e1223) + (_e1519 * _e1224)) + (_e1521 * _e1225));
                                    let _e1609 = (((_e1517 * _e1204[0]) + (_e1519 * _e1204[1])) + (_e1521 * _e1204[2]));
                                    let _e1615 = (((_e1517 * _e1228[0]) + (_e1519 * _e1228[1])) + (_e1521 * _e1228[2]));
                                    let _e1620 = (((_e1517 * _e1244) + (_e1519 * _e1245)) + (_e1521 * _e1246));
                                    let _e1625 = (((_e1517 * _e1247) + (_e1519 * _e1248)) + (_e1521 * _e1249));
                                    let _e1630 = (((_e1517 * _e1228[0]) + (_e1519 * _e1228[1])) + (_e1521 * _e1228[2]));
                                    if (_e1594 < 0.0lf) {
                                        phi_9960_ = -(_e1594);
                                    } else {
                                        phi_9960_ = _e1594;
                                    }
                                    let _e1635 = phi_9960_;
                                    if (_e1615 < 0.0lf) {
                                        phi_9966_ = -(_e1615);
                                    } else {
                                        phi_9966_ = _e1615;
                                    }
                                    let _e1639 = phi_9966_;
                                    if (_e1599 < 0.0lf) {
                                        phi_9975_ = -(_e1599);
                                    } else {
                                        phi_9975_ = _e1599;
                                    }
                                    let _e1646 = phi_9975_;
                                    if (_e1620 < 0.0lf) {
                                        phi_9981_ = -(_e1620);
                                    } else {
                                        phi_9981_ = _e1620;
                                    }
                                    let _e1650 = phi_9981_;
                                    if (_e1604 < 0.0lf) {
                                        phi_9990_ = -(_e1604);
                                    } else {
                                        phi_9990_ = _e1604;
                                    }
                                    let _e1657 = phi_9990_;
                                    if (_e1625 < 0.0lf) {
                                        phi_9996_ = -(_e1625);
                                    } else {
                                        phi_9996_ = _e1625;
                                    }
                                    let _e1661 = phi_9996_;
                                    if (_e1609 < 0.0lf) {
                                        phi_10005_ = -(_e1609);
                                    } else {
                                        phi_10005_ = _e1609;
                                    }
                                    let _e1668 = phi_10005_;
                                    if (_e1630 < 0.0lf) {
                                        phi_10011_ = -(_e1630);
                                    } else {
                                        phi_10011_ = _e1630;
                                    }
                                    let _e1672 = phi_10011_;
                                    phi_10017_ = type_38(array<f64, 4>(_e1594, _e1599, _e1604, _e1609), array<f64, 4>(_e1615, _e1620, _e1625, _e1630), array<f64, 4>((_e1589 + ((_e1635 + _e1639) * _e1582)), (_e1589 + ((_e1646 + _e1650) * _e1582)), (_e1589 + ((_e1657 + _e1661) * _e1582)), (_e1589 + ((_e1668 + _e1672) * _e1582))));
                                    phi_10018_ = false;
                                } else {
                                    phi_10017_ = type_38();
                                    phi_10018_ = true;
                                }
                                let _e1679 = phi_10017_;
                                let _e1681 = phi_10018_;
                                phi_10019_ = _e1679;
                                phi_10020_ = _e1681;
                            } else {
                                phi_10019_ = type_38();
                                phi_10020_ = true;
                            }
                            let _e1683 = phi_10019_;
                            let _e1685 = phi_10020_;
                            if _e1685 {
                                let _e1686 = f64(0f);
                                let _e1687 = f64(1f);
                                phi_10030_ = type_38(array<f64, 4>(_e1686, _e1686, _e1686, _e1686), array<f64, 4>(_e1686, _e1686, _e1686, _e1686), array<f64, 4>(_e1687, _e1687, _e1687, _e1687));
                            } else {
                                phi_10030_ = _e1683;
                            }
                            let _e1693 = phi_10030_;
                            local_8 = type_38(array<f64, 4>(_e1693.member[0], _e1693.member[1], _e1693.member[2], _e1693.member[3]), array<f64, 4>(_e1693.member_1[0], _e1693.member_1[1], _e1693.member_1[2], _e1693.member_1[3]), array<f64, 4>(_e1693.member_2[0], _e1693.member_2[1], _e1693.member_2[2], _e1693.member_2[3]));
                            let _e1713 = f64(0f);
                            let _e1716 = local_8.member[0u];
                            let _e1719 = local_8.member_1[0u];
                            let _e1722 = local_8.member[0u];
                            let _e1728 = local_8.member_2[0u];
                            if (((_e1716 + ((_e1719 - _e1722) * _e427)) - _e1728) > _e1713) {
                                let _e1733 = local_8.member[1u];
                                let _e1736 = local_8.member_1[1u];
                                let _e1739 = local_8.member[1u];
                                let _e1745 = local_8.member_2[1u];
                                if (((_e1733 + ((_e1736 - _e1739) * _e427)) - _e1745) > _e1713) {
                                    let _e1750 = local_8.member[2u];
                                    let _e1753 = local_8.member_1[2u];
                                    let _e1756 = local_8.member[2u];
                                    let _e1762 = local_8.member_2[2u];
                                    if (((_e1750 + ((_e1753 - _e1756) * _e427)) - _e1762) > _e1713) {
                                        let _e1767 = local_8.member[3u];
                                        let _e1770 = local_8.member_1[3u];
                                        let _e1773 = local_8.member[3u];
                                        let _e1779 = local_8.member_2[3u];
                                        phi_10200_ = (((_e1767 + ((_e1770 - _e1773) * _e427)) - _e1779) > _e1713);
                                        phi_10201_ = false;
                                    } else {
                                        phi_10200_ = bool();
                                        phi_10201_ = true;
                                    }
                                    let _e1783 = phi_10200_;
                                    let _e1785 = phi_10201_;
                                    phi_10202_ = _e1783;
                                    phi_10203_ = _e1785;
                                } else {
                                    phi_10202_ = bool();
                                    phi_10203_ = true;
                                }
                                let _e1787 = phi_10202_;
                                let _e1789 = phi_10203_;
                                phi_10204_ = _e1787;
                                phi_10205_ = _e1789;
                            } else {
                                phi_10204_ = bool();
                                phi_10205_ = true;
                            }
                            let _e1791 = phi_10204_;
                            let _e1793 = phi_10205_;
                            if _e1793 {
                                phi_10209_ = false;
                            } else {
                                phi_10209_ = _e1791;
                            }
                            let _e1795 = phi_10209_;
                            if _e1795 {
                                phi_11590_ = bool();
                                phi_11591_ = true;
                            } else {
                                let _e1796 = f64(0f);
                                if (_e1491[0] < 0.0lf) {
                                    phi_10237_ = -(_e1491[0]);
                                } else {
                                    phi_10237_ = _e1491[0];
                                }
                                let _e1801 = phi_10237_;
                                if (_e1796 < 0.0lf) {
                                    phi_10243_ = -(_e1796);
                                } else {
                                    phi_10243_ = _e1796;
                                }
                                let _e1805 = phi_10243_;
                                if (_e1796 < 0.0lf) {
                                    phi_10250_ = -(_e1796);
                                } else {
                                    phi_10250_ = _e1796;
                                }
                                let _e1810 = phi_10250_;
                                let _e1811 = ((_e1801 + _e1805) + _e1810);
                                if (_e1811 > f64(0f)) {
                                    if ((bitcast<u64>(_e1811) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e1818 = (f64(1f) / _e1811);
                                        let _e1819 = (_e1491[0] * _e1818);
                                        let _e1820 = (_e1796 * _e1818);
                                        let _e1821 = (_e1796 * _e1818);
                                        let _e1826 = (((_e1819 * _e1819) + (_e1820 * _e1820)) + (_e1821 * _e1821));
                                        if (_e1826 <= 2.2250738585072014e-308lf) {
                                            if (_e1826 > 0.0lf) {
                                                phi_10286_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_10286_ = 0.0lf;
                                            }
                                            let _e1878 = phi_10286_;
                                            phi_10350_ = _e1878;
                                        } else {
                                            phi_10293_ = type_16(0i, 5i);
                                            phi_10296_ = bitcast<f64>(((bitcast<u64>(_e1826) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e1833 = phi_10293_;
                                                let _e1835 = phi_10296_;
                                                local_20 = _e1835;
                                                if (_e1833.member < _e1833.member_1) {
                                                    let _e1842 = (_e1833.member + 1i);
                                                    if ((false == (_e1842 > _e1833.member)) != false) {
                                                        phi_10317_ = true;
                                                    } else {
                                                        phi_10317_ = false;
                                                    }
                                                    let _e1847 = phi_10317_;
                                                    if _e1847 {
                                                        phi_10323_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_10323_ = type_17(1u, _e1842);
                                                    }
                                                    let _e1852 = phi_10323_;
                                                    phi_10294_ = type_16(_e1852.member_1, _e1833.member_1);
                                                    phi_10337_ = type_17(1u, _e1833.member);
                                                } else {
                                                    phi_10294_ = _e1833;
                                                    phi_10337_ = type_17(0u, type_17().member_1);
                                                }
                                                let _e1858 = phi_10294_;
                                                let _e1860 = phi_10337_;
                                                let _e1863 = (bitcast<i32>(_e1860.member) != 0i);
                                                if _e1863 {
                                                    phi_10297_ = (0.5lf * (_e1835 + (_e1826 / _e1835)));
                                                } else {
                                                    phi_10297_ = f64();
                                                }
                                                let _e1868 = phi_10297_;
                                                continue;
                                                continuing {
                                                    phi_10293_ = _e1858;
                                                    phi_10296_ = _e1868;
                                                    break if !(_e1863);
                                                }
                                            }
                                            let _e1873 = local_20;
                                            phi_10350_ = (_e1873 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e1880 = phi_10350_;
                                        let _e1882 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e1889 = ((_e1424 * f64(1.01f)) + ((_e1201 * _e1880) * (f64(1f) + _e1882)));
                                        let _e1894 = (((_e1819 * _e1204[0]) + (_e1820 * _e1204[1])) + (_e1821 * _e1204[2]));
                                        let _e1899 = (((_e1819 * _e1220) + (_e1820 * _e1221)) + (_e1821 * _e1222));
                                        let _e1904 = (((_e1819 * _e1223) + (_e1820 * _e1224)) + (_e1821 * _e1225));
                                        let _e1909 = (((_e1819 * _e1204[0]) + (_e1820 * _e1204[1])) + (_e1821 * _e1204[2]));
                                        let _e1915 = (((_e1819 * _e1228[0]) + (_e1820 * _e1228[1])) + (_e1821 * _e1228[2]));
                                        let _e1920 = (((_e1819 * _e1244) + (_e1820 * _e1245)) + (_e1821 * _e1246));
                                        let _e1925 = (((_e1819 * _e1247) + (_e1820 * _e1248)) + (_e1821 * _e1249));
                                        let _e1930 = (((_e1819 * _e1228[0]) + (_e1820 * _e1228[1])) + (_e1821 * _e1228[2]));
                                        if (_e1894 < 0.0lf) {
                                            phi_10419_ = -(_e1894);
                                        } else {
                                            phi_10419_ = _e1894;
                                        }
                                        let _e1935 = phi_10419_;
                                        if (_e1915 < 0.0lf) {
                                            phi_10425_ = -(_e1915);
                                        } else {
                                            phi_10425_ = _e1915;
                                        }
                                        let _e1939 = phi_10425_;
                                        if (_e1899 < 0.0lf) {
                                            phi_10434_ = -(_e1899);
                                        } else {
                                            phi_10434_ = _e1899;
                                        }
                                        let _e1946 = phi_10434_;
                                        if (_e1920 < 0.0lf) {
                                            phi_10440_ = -(_e1920);
                                        } else {
                                            phi_10440_ = _e1920;
                                        }
                                        let _e1950 = phi_10440_;
                                        if (_e1904 < 0.0lf) {
                                            phi_10449_ = -(_e1904);
                                        } else {
                                            phi_10449_ = _e1904;
                                        }
                                        let _e1957 = phi_10449_;
                                        if (_e1925 < 0.0lf) {
                                            phi_10455_ = -(_e1925);
                                        } else {
                                            phi_10455_ = _e1925;
                                        }
                                        let _e1961 = phi_10455_;
                                        if (_e1909 < 0.0lf) {
                                            phi_10464_ = -(_e1909);
                                        } else {
                                            phi_10464_ = _e1909;
                                        }
                                        let _e1968 = phi_10464_;
                                        if (_e1930 < 0.0lf) {
                                            phi_10470_ = -(_e1930);
                                        } else {
                                            phi_10470_ = _e1930;
                                        }
                                        let _e1972 = phi_10470_;
                                        phi_10476_ = type_38(array<f64, 4>(_e1894, _e1899, _e1904, _e1909), array<f64, 4>(_e1915, _e1920, _e1925, _e1930), array<f64, 4>((_e1889 + ((_e1935 + _e1939) * _e1882)), (_e1889 + ((_e1946 + _e1950) * _e1882)), (_e1889 + ((_e1957 + _e1961) * _e1882)), (_e1889 + ((_e1968 + _e1972) * _e1882))));
                                        phi_10477_ = false;
                                    } else {
                                        phi_10476_ = type_38();
                                        phi_10477_ = true;
                                    }
                                    let _e1979 = phi_10476_;
                                    let _e1981 = phi_10477_;
                                    phi_10478_ = _e1979;
                                    phi_10479_ = _e1981;
                                } else {
                                    phi_10478_ = type_38();
                                    phi_10479_ = true;
                                }
                                let _e1983 = phi_10478_;
                                let _e1985 = phi_10479_;
                                if _e1985 {
                                    let _e1986 = f64(0f);
                                    let _e1987 = f64(1f);
                                    phi_10489_ = type_38(array<f64, 4>(_e1986, _e1986, _e1986, _e1986), array<f64, 4>(_e1986, _e1986, _e1986, _e1986), array<f64, 4>(_e1987, _e1987, _e1987, _e1987));
                                } else {
                                    phi_10489_ = _e1983;
                                }
                                let _e1993 = phi_10489_;
                                local_9 = type_38(array<f64, 4>(_e1993.member[0], _e1993.member[1], _e1993.member[2], _e1993.member[3]), array<f64, 4>(_e1993.member_1[0], _e1993.member_1[1], _e1993.member_1[2], _e1993.member_1[3]), array<f64, 4>(_e1993.member_2[0], _e1993.member_2[1], _e1993.member_2[2], _e1993.member_2[3]));
                                let _e2013 = f64(0f);
                                let _e2016 = local_9.member[0u];
                                let _e2019 = local_9.member_1[0u];
                                let _e2022 = local_9.member[0u];
                                let _e2028 = local_9.member_2[0u];
                                if (((_e2016 + ((_e2019 - _e2022) * _e427)) - _e2028) > _e2013) {
                                    let _e2033 = local_9.member[1u];
                                    let _e2036 = local_9.member_1[1u];
                                    let _e2039 = local_9.member[1u];
                                    let _e2045 = local_9.member_2[1u];
                                    if (((_e2033 + ((_e2036 - _e2039) * _e427)) - _e2045) > _e2013) {
                                        let _e2050 = local_9.member[2u];
                                        let _e2053 = local_9.member_1[2u];
                                        let _e2056 = local_9.member[2u];
                                        let _e2062 = local_9.member_2[2u];
                                        if (((_e2050 + ((_e2053 - _e2056) * _e427)) - _e2062) > _e2013) {
                                            let _e2067 = local_9.member[3u];
                                            let _e2070 = local_9.member_1[3u];
                                            let _e2073 = local_9.member[3u];
                                            let _e2079 = local_9.member_2[3u];
                                            phi_10659_ = (((_e2067 + ((_e2070 - _e2073) * _e427)) - _e2079) > _e2013);
                                            phi_10660_ = false;
                                        } else {
                                            phi_10659_ = bool();
                                            phi_10660_ = true;
                                        }
                                        let _e2083 = phi_10659_;
                                        let _e2085 = phi_10660_;
                                        phi_10661_ = _e2083;
                                        phi_10662_ = _e2085;
                                    } else {
                                        phi_10661_ = bool();
                                        phi_10662_ = true;
                                    }
                                    let _e2087 = phi_10661_;
                                    let _e2089 = phi_10662_;
                                    phi_10663_ = _e2087;
                                    phi_10664_ = _e2089;
                                } else {
                                    phi_10663_ = bool();
                                    phi_10664_ = true;
                                }
                                let _e2091 = phi_10663_;
                                let _e2093 = phi_10664_;
                                if _e2093 {
                                    phi_10668_ = false;
                                } else {
                                    phi_10668_ = _e2091;
                                }
                                let _e2095 = phi_10668_;
                                if _e2095 {
                                    phi_11588_ = bool();
                                    phi_11589_ = true;
                                } else {
                                    let _e2096 = f64(0f);
                                    if (_e2096 < 0.0lf) {
                                        phi_10696_ = -(_e2096);
                                    } else {
                                        phi_10696_ = _e2096;
                                    }
                                    let _e2101 = phi_10696_;
                                    if (_e1491[1] < 0.0lf) {
                                        phi_10702_ = -(_e1491[1]);
                                    } else {
                                        phi_10702_ = _e1491[1];
                                    }
                                    let _e2105 = phi_10702_;
                                    if (_e2096 < 0.0lf) {
                                        phi_10709_ = -(_e2096);
                                    } else {
                                        phi_10709_ = _e2096;
                                    }
                                    let _e2110 = phi_10709_;
                                    let _e2111 = ((_e2101 + _e2105) + _e2110);
                                    if (_e2111 > f64(0f)) {
                                        if ((bitcast<u64>(_e2111) & 9218868437227405312lu) != 9218868437227405312lu) {
                                            let _e2118 = (f64(1f) / _e2111);
                                            let _e2119 = (_e2096 * _e2118);
                                            let _e2120 = (_e1491[1] * _e2118);
                                            let _e2121 = (_e2096 * _e2118);
                                            let _e2126 = (((_e2119 * _e2119) + (_e2120 * _e2120)) + (_e2121 * _e2121));
                                            if (_e2126 <= 2.2250738585072014e-308lf) {
                                                if (_e2126 > 0.0lf) {
                                                    phi_10745_ = (1.464336215552873e-154lf * 2.0lf);
                                                } else {
                                                    phi_10745_ = 0.0lf;
                                                }
                                                let _e2178 = phi_10745_;
                                                phi_10809_ = _e2178;
                                            } else {
                                                phi_10752_ = type_16(0i, 5i);
                                                phi_10755_ = bitcast<f64>(((bitcast<u64>(_e2126) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e2133 = phi_10752_;
                                                    let _e2135 = phi_10755_;
                                                    local_21 = _e2135;
                                                    if (_e2133.member < _e2133.member_1) {
                                                        let _e2142 = (_e2133.member + 1i);
                                                        if ((false == (_e2142 > _e2133.member)) != false) {
                                                            phi_10776_ = true;
                                                        } else {
                                                            phi_10776_ = false;
                                                        }
                                                        let _e2147 = phi_10776_;
                                                        if _e2147 {
                                                            phi_10782_ = type_17(0u, type_17().member_1);
                                                        } else {
                                                            phi_10782_ = type_17(1u, _e2142);
                                                        }
                                                        let _e2152 = phi_10782_;
                                                        phi_10753_ = type_16(_e2152.member_1, _e2133.member_1);
                                                        phi_10796_ = type_17(1u, _e2133.member);
                                                    } else {
                                                        phi_10753_ = _e2133;
                                                        phi_10796_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e2158 = phi_10753_;
                                                    let _e2160 = phi_10796_;
                                                    let _e2163 = (bitcast<i32>(_e2160.member) != 0i);
                                                    if _e2163 {
                                                        phi_10756_ = (0.5lf * (_e2135 + (_e2126 / _e2135)));
                                                    } else {
                                                        phi_10756_ = f64();
                                                    }
                                                    let _e2168 = phi_10756_;
                                                    continue;
                                                    continuing {
                                                        phi_10752_ = _e2158;
                                                        phi_10755_ = _e2168;
                                                        break if !(_e2163);
                                                    }
                                                }
                                                let _e2173 = local_21;
                                                phi_10809_ = (_e2173 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e2180 = phi_10809_;
                                            let _e2182 = (1.1102230246251565e-16lf * f64(12f));
                                            let _e2189 = ((_e1424 * f64(1.01f)) + ((_e1201 * _e2180) * (f64(1f) + _e2182)));
                                            let _e2194 = (((_e2119 * _e1204[0]) + (_e2120 * _e1204[1])) + (_e2121 * _e1204[2]));
                                            let _e2199 = (((_e2119 * _e1220) + (_e2120 * _e1221)) + (_e2121 * _e1222));
                                            let _e2204 = (((_e2119 * _e1223) + (_e2120 * _e1224)) + (_e2121 * _e1225));
                                            let _e2209 = (((_e2119 * _e1204[0]) + (_e2120 * _e1204[1])) + (_e2121 * _e1204[2]));
                                            let _e2215 = (((_e2119 * _e1228[0]) + (_e2120 * _e1228[1])) + (_e2121 * _e1228[2]));
                                            let _e2220 = (((_e2119 * _e1244) + (_e2120 * _e1245)) + (_e2121 * _e1246));
                                            let _e2225 = (((_e2119 * _e1247) + (_e2120 * _e1248)) + (_e2121 * _e1249));
                                            let _e2230 = (((_e2119 * _e1228[0]) + (_e2120 * _e1228[1])) + (_e2121 * _e1228[2]));
                                            if (_e2194 < 0.0lf) {
                                                phi_10878_ = -(_e2194);
                                            } else {
                                                phi_10878_ = _e2194;
                                            }
                                            let _e2235 = phi_10878_;
                                            if (_e2215 < 0.0lf) {
                                                phi_10884_ = -(_e2215);
                                            } else {
                                                phi_10884_ = _e2215;
                                            }
                                            let _e2239 = phi_10884_;
                                            if (_e2199 < 0.0lf) {
                                                phi_10893_ = -(_e2199);
                                            } else {
                                                phi_10893_ = _e2199;
                                            }
                                            let _e2246 = phi_10893_;
                                            if (_e2220 < 0.0lf) {
                                                phi_10899_ = -(_e2220);
                                            } else {
                                                phi_10899_ = _e2220;
                                            }
                                            let _e2250 = phi_10899_;
                                            if (_e2204 < 0.0lf) {
                                                phi_10908_ = -(_e2204);
                                            } else {
                                                phi_10908_ = _e2204;
                                            }
                                            let _e2257 = phi_10908_;
                                            if (_e2225 < 0.0lf) {
                                                phi_10914_ = -(_e2225);
                                            } else {
                                                phi_10914_ = _e2225;
                                            }
                                            let _e2261 = phi_10914_;
                                            if (_e2209 < 0.0lf) {
                                                phi_10923_ = -(_e2209);
                                            } else {
                                                phi_10923_ = _e2209;
                                            }
                                            let _e2268 = phi_10923_;
                                            if (_e2230 < 0.0lf) {
                                                phi_10929_ = -(_e2230);
                                            } else {
                                                phi_10929_ = _e2230;
                                            }
                                            let _e2272 = phi_10929_;
                                            phi_10935_ = type_38(array<f64, 4>(_e2194, _e2199, _e2204, _e2209), array<f64, 4>(_e2215, _e2220, _e2225, _e2230), array<f64, 4>((_e2189 + ((_e2235 + _e2239) * _e2182)), (_e2189 + ((_e2246 + _e2250) * _e2182)), (_e2189 + ((_e2257 + _e2261) * _e2182)), (_e2189 + ((_e2268 + _e2272) * _e2182))));
                                            phi_10936_ = false;
                                        } else {
                                            phi_10935_ = type_38();
                                            phi_10936_ = true;
                                        }
                                        let _e2279 = phi_10935_;
                                        let _e2281 = phi_10936_;
                                        phi_10937_ = _e2279;
                                        phi_10938_ = _e2281;
                                    } else {
                                        phi_10937_ = type_38();
                                        phi_10938_ = true;
                                    }
                                    let _e2283 = phi_10937_;
                                    let _e2285 = phi_10938_;
                                    if _e2285 {
                                        let _e2286 = f64(0f);
                                        let _e2287 = f64(1f);
                                        phi_10948_ = type_38(array<f64, 4>(_e2286, _e2286, _e2286, _e2286), array<f64, 4>(_e2286, _e2286, _e2286, _e2286), array<f64, 4>(_e2287, _e2287, _e2287, _e2287));
                                    } else {
                                        phi_10948_ = _e2283;
                                    }
                                    let _e2293 = phi_10948_;
                                    local_10 = type_38(array<f64, 4>(_e2293.member[0], _e2293.member[1], _e2293.member[2], _e2293.member[3]), array<f64, 4>(_e2293.member_1[0], _e2293.member_1[1], _e2293.member_1[2], _e2293.member_1[3]), array<f64, 4>(_e2293.member_2[0], _e2293.member_2[1], _e2293.member_2[2], _e2293.member_2[3]));
                                    let _e2313 = f64(0f);
                                    let _e2316 = local_10.member[0u];
                                    let _e2319 = local_10.member_1[0u];
                                    let _e2322 = local_10.member[0u];
                                    let _e2328 = local_10.member_2[0u];
                                    if (((_e2316 + ((_e2319 - _e2322) * _e427)) - _e2328) > _e2313) {
                                        let _e2333 = local_10.member[1u];
                                        let _e2336 = local_10.member_1[1u];
                                        let _e2339 = local_10.member[1u];
                                        let _e2345 = local_10.member_2[1u];
                                        if (((_e2333 + ((_e2336 - _e2339) * _e427)) - _e2345) > _e2313) {
                                            let _e2350 = local_10.member[2u];
                                            let _e2353 = local_10.member_1[2u];
                                            let _e2356 = local_10.member[2u];
                                            let _e2362 = local_10.member_2[2u];
                                            if (((_e2350 + ((_e2353 - _e2356) * _e427)) - _e2362) > _e2313) {
                                                let _e2367 = local_10.member[3u];
                                                let _e2370 = local_10.member_1[3u];
                                                let _e2373 = local_10.member[3u];
                                                let _e2379 = local_10.member_2[3u];
                                                phi_11118_ = (((_e2367 + ((_e2370 - _e2373) * _e427)) - _e2379) > _e2313);
                                                phi_11119_ = false;
                                            } else {
                                                phi_11118_ = bool();
                                                phi_11119_ = true;
                                            }
                                            let _e2383 = phi_11118_;
                                            let _e2385 = phi_11119_;
                                            phi_11120_ = _e2383;
                                            phi_11121_ = _e2385;
                                        } else {
                                            phi_11120_ = bool();
                                            phi_11121_ = true;
                                        }
                                        let _e2387 = phi_11120_;
                                        let _e2389 = phi_11121_;
                                        phi_11122_ = _e2387;
                                        phi_11123_ = _e2389;
                                    } else {
                                        phi_11122_ = bool();
                                        phi_11123_ = true;
                                    }
                                    let _e2391 = phi_11122_;
                                    let _e2393 = phi_11123_;
                                    if _e2393 {
                                        phi_11127_ = false;
                                    } else {
                                        phi_11127_ = _e2391;
                                    }
                                    let _e2395 = phi_11127_;
                                    if _e2395 {
                                        phi_11587_ = bool();
                                    } else {
                                        let _e2396 = f64(0f);
                                        if (_e2396 < 0.0lf) {
                                            phi_11155_ = -(_e2396);
                                        } else {
                                            phi_11155_ = _e2396;
                                        }
                                        let _e2401 = phi_11155_;
                                        if (_e2396 < 0.0lf) {
                                            phi_11161_ = -(_e2396);
                                        } else {
                                            phi_11161_ = _e2396;
                                        }
                                        let _e2405 = phi_11161_;
                                        if (_e1491[2] < 0.0lf) {
                                            phi_11168_ = -(_e1491[2]);
                                        } else {
                                            phi_11168_ = _e1491[2];
                                        }
                                        let _e2410 = phi_11168_;
                                        let _e2411 = ((_e2401 + _e2405) + _e2410);
                                        if (_e2411 > f64(0f)) {
                                            if ((bitcast<u64>(_e2411) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2418 = (f64(1f) / _e2411);
                                                let _e2419 = (_e2396 * _e2418);
                                                let _e2420 = (_e2396 * _e2418);
                                                let _e2421 = (_e1491[2] * _e2418);
                                                let _e2426 = (((_e2419 * _e2419) + (_e2420 * _e2420)) + (_e2421 * _e2421));
                                                if (_e2426 <= 2.2250738585072014e-308lf) {
                                                    if (_e2426 > 0.0lf) {
                                                        phi_11204_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_11204_ = 0.0lf;
                                                    }
                                                    let _e2478 = phi_11204_;
                                                    phi_11268_ = _e2478;
                                                } else {
                                                    phi_11211_ = type_16(0i, 5i);
                                                    phi_11214_ = bitcast<f64>(((bitcast<u64>(_e2426) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2433 = phi_11211_;
                                                        let _e2435 = phi_11214_;
                                                        local_22 = _e2435;
                                                        if (_e2433.member < _e2433.member_1) {
                                                            let _e2442 = (_e2433.member + 1i);
                                                            if ((false == (_e2442 > _e2433.member)) != false) {
                                                                phi_11235_ = true;
                                                            } else {
                                                                phi_11235_ = false;
                                                            }
                                                            let _e2447 = phi_11235_;
                                                            if _e2447 {
                                                                phi_11241_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_11241_ = type_17(1u, _e2442);
                                                            }
                                                            let _e2452 = phi_11241_;
                                                            phi_11212_ = type_16(_e2452.member_1, _e2433.member_1);
                                                            phi_11255_ = type_17(1u, _e2433.member);
                                                        } else {
                                                            phi_11212_ = _e2433;
                                                            phi_11255_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e2458 = phi_11212_;
                                                        let _e2460 = phi_11255_;
                                                        let _e2463 = (bitcast<i32>(_e2460.member) != 0i);
                                                        if _e2463 {
                                                            phi_11215_ = (0.5lf * (_e2435 + (_e2426 / _e2435)));
                                                        } else {
                                                            phi_11215_ = f64();
                                                        }
                                                        let _e2468 = phi_11215_;
                                                        continue;
                                                        continuing {
                                                            phi_11211_ = _e2458;
                                                            phi_11214_ = _e2468;
                                                            break if !(_e2463);
                                                        }
                                                    }
                                                    let _e2473 = local_22;
                                                    phi_11268_ = (_e2473 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2480 = phi_11268_;
                                                let _e2482 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2489 = ((_e1424 * f64(1.01f)) + ((_e1201 * _e2480) * (f64(1f) + _e2482)));
                                                let _e2494 = (((_e2419 * _e1204[0]) + (_e2420 * _e1204[1])) + (_e2421 * _e1204[2]));
                                                let _e2499 = (((_e2419 * _e1220) + (_e2420 * _e1221)) + (_e2421 * _e1222));
                                                let _e2504 = (((_e2419 * _e1223) + (_e2420 * _e1224)) + (_e2421 * _e1225));
                                                let _e2509 = (((_e2419 * _e1204[0]) + (_e2420 * _e1204[1])) + (_e2421 * _e1204[2]));
                                                let _e2515 = (((_e2419 * _e1228[0]) + (_e2420 * _e1228[1])) + (_e2421 * _e1228[2]));
                                                let _e2520 = (((_e2419 * _e1244) + (_e2420 * _e1245)) + (_e2421 * _e1246));
                                                let _e2525 = (((_e2419 * _e1247) + (_e2420 * _e1248)) + (_e2421 * _e1249));
                                                let _e2530 = (((_e2419 * _e1228[0]) + (_e2420 * _e1228[1])) + (_e2421 * _e1228[2]));
                                                if (_e2494 < 0.0lf) {
                                                    phi_11337_ = -(_e2494);
                                                } else {
                                                    phi_11337_ = _e2494;
                                                }
                                                let _e2535 = phi_11337_;
                                                if (_e2515 < 0.0lf) {
                                                    phi_11343_ = -(_e2515);
                                                } else {
                                                    phi_11343_ = _e2515;
                                                }
                                                let _e2539 = phi_11343_;
                                                if (_e2499 < 0.0lf) {
                                                    phi_11352_ = -(_e2499);
                                                } else {
                                                    phi_11352_ = _e2499;
                                                }
                                                let _e2546 = phi_11352_;
                                                if (_e2520 < 0.0lf) {
                                                    phi_11358_ = -(_e2520);
                                                } else {
                                                    phi_11358_ = _e2520;
                                                }
                                                let _e2550 = phi_11358_;
                                                if (_e2504 < 0.0lf) {
                                                    phi_11367_ = -(_e2504);
                                                } else {
                                                    phi_11367_ = _e2504;
                                                }
                                                let _e2557 = phi_11367_;
                                                if (_e2525 < 0.0lf) {
                                                    phi_11373_ = -(_e2525);
                                                } else {
                                                    phi_11373_ = _e2525;
                                                }
                                                let _e2561 = phi_11373_;
                                                if (_e2509 < 0.0lf) {
                                                    phi_11382_ = -(_e2509);
                                                } else {
                                                    phi_11382_ = _e2509;
                                                }
                                                let _e2568 = phi_11382_;
                                                if (_e2530 < 0.0lf) {
                                                    phi_11388_ = -(_e2530);
                                                } else {
                                                    phi_11388_ = _e2530;
                                                }
                                                let _e2572 = phi_11388_;
                                                phi_11394_ = type_38(array<f64, 4>(_e2494, _e2499, _e2504, _e2509), array<f64, 4>(_e2515, _e2520, _e2525, _e2530), array<f64, 4>((_e2489 + ((_e2535 + _e2539) * _e2482)), (_e2489 + ((_e2546 + _e2550) * _e2482)), (_e2489 + ((_e2557 + _e2561) * _e2482)), (_e2489 + ((_e2568 + _e2572) * _e2482))));
                                                phi_11395_ = false;
                                            } else {
                                                phi_11394_ = type_38();
                                                phi_11395_ = true;
                                            }
                                            let _e2579 = phi_11394_;
                                            let _e2581 = phi_11395_;
                                            phi_11396_ = _e2579;
                                            phi_11397_ = _e2581;
                                        } else {
                                            phi_11396_ = type_38();
                                            phi_11397_ = true;
                                        }
                                        let _e2583 = phi_11396_;
                                        let _e2585 = phi_11397_;
                                        if _e2585 {
                                            let _e2586 = f64(0f);
                                            let _e2587 = f64(1f);
                                            phi_11407_ = type_38(array<f64, 4>(_e2586, _e2586, _e2586, _e2586), array<f64, 4>(_e2586, _e2586, _e2586, _e2586), array<f64, 4>(_e2587, _e2587, _e2587, _e2587));
                                        } else {
                                            phi_11407_ = _e2583;
                                        }
                                        let _e2593 = phi_11407_;
                                        local_11 = type_38(array<f64, 4>(_e2593.member[0], _e2593.member[1], _e2593.member[2], _e2593.member[3]), array<f64, 4>(_e2593.member_1[0], _e2593.member_1[1], _e2593.member_1[2], _e2593.member_1[3]), array<f64, 4>(_e2593.member_2[0], _e2593.member_2[1], _e2593.member_2[2], _e2593.member_2[3]));
                                        let _e2613 = f64(0f);
                                        let _e2616 = local_11.member[0u];
                                        let _e2619 = local_11.member_1[0u];
                                        let _e2622 = local_11.member[0u];
                                        let _e2628 = local_11.member_2[0u];
                                        if (((_e2616 + ((_e2619 - _e2622) * _e427)) - _e2628) > _e2613) {
                                            let _e2633 = local_11.member[1u];
                                            let _e2636 = local_11.member_1[1u];
                                            let _e2639 = local_11.member[1u];
                                            let _e2645 = local_11.member_2[1u];
                                            if (((_e2633 + ((_e2636 - _e2639) * _e427)) - _e2645) > _e2613) {
                                                let _e2650 = local_11.member[2u];
                                                let _e2653 = local_11.member_1[2u];
                                                let _e2656 = local_11.member[2u];
                                                let _e2662 = local_11.member_2[2u];
                                                if (((_e2650 + ((_e2653 - _e2656) * _e427)) - _e2662) > _e2613) {
                                                    let _e2667 = local_11.member[3u];
                                                    let _e2670 = local_11.member_1[3u];
                                                    let _e2673 = local_11.member[3u];
                                                    let _e2679 = local_11.member_2[3u];
                                                    phi_11577_ = (((_e2667 + ((_e2670 - _e2673) * _e427)) - _e2679) > _e2613);
                                                    phi_11578_ = false;
                                                } else {
                                                    phi_11577_ = bool();
                                                    phi_11578_ = true;
                                                }
                                                let _e2683 = phi_11577_;
                                                let _e2685 = phi_11578_;
                                                phi_11579_ = _e2683;
                                                phi_11580_ = _e2685;
                                            } else {
                                                phi_11579_ = bool();
                                                phi_11580_ = true;
                                            }
                                            let _e2687 = phi_11579_;
                                            let _e2689 = phi_11580_;
                                            phi_11581_ = _e2687;
                                            phi_11582_ = _e2689;
                                        } else {
                                            phi_11581_ = bool();
                                            phi_11582_ = true;
                                        }
                                        let _e2691 = phi_11581_;
                                        let _e2693 = phi_11582_;
                                        if _e2693 {
                                            phi_11586_ = false;
                                        } else {
                                            phi_11586_ = _e2691;
                                        }
                                        let _e2695 = phi_11586_;
                                        phi_11587_ = _e2695;
                                    }
                                    let _e2697 = phi_11587_;
                                    phi_11588_ = _e2697;
                                    phi_11589_ = _e2395;
                                }
                                let _e2699 = phi_11588_;
                                let _e2701 = phi_11589_;
                                phi_11590_ = _e2699;
                                phi_11591_ = _e2701;
                            }
                            let _e2703 = phi_11590_;
                            let _e2705 = phi_11591_;
                            if _e2705 {
                                phi_11595_ = true;
                            } else {
                                phi_11595_ = _e2703;
                            }
                            let _e2707 = phi_11595_;
                            if !(_e2707) {
                                phi_11601_ = type_46(2u, _e427);
                                phi_11602_ = false;
                            } else {
                                phi_11601_ = type_46();
                                phi_11602_ = true;
                            }
                            let _e2711 = phi_11601_;
                            let _e2713 = phi_11602_;
                            phi_11603_ = _e2711;
                            phi_11604_ = _e2713;
                        } else {
                            phi_11603_ = type_46();
                            phi_11604_ = true;
                        }
                        let _e2715 = phi_11603_;
                        let _e2717 = phi_11604_;
                        if _e2717 {
                            let _e2718 = f64(0f);
                            let _e2719 = f64(1f);
                            let _e2720 = f64(3f);
                            let _e2726 = ((_e804 - (_e2720 * _e781)) * _e1175);
                            let _e2727 = ((_e827 - _e804) * _e1175);
                            let _e2728 = (((_e2720 * _e838) - _e827) * _e1175);
                            local_6[0u] = _e2718;
                            local_6[1u] = _e2719;
                            local_6[2u] = _e2719;
                            local_6[3u] = _e2719;
                            let _e2735 = ((_e2727 * _e2727) - (_e2726 * _e2728));
                            if (_e2735 > _e2718) {
                                if (_e2735 <= 2.2250738585072014e-308lf) {
                                    if (_e2735 > 0.0lf) {
                                        phi_11643_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_11643_ = 0.0lf;
                                    }
                                    let _e2788 = phi_11643_;
                                    phi_11707_ = _e2788;
                                } else {
                                    phi_11650_ = type_16(0i, 5i);
                                    phi_11653_ = bitcast<f64>(((bitcast<u64>(_e2735) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e2743 = phi_11650_;
                                        let _e2745 = phi_11653_;
                                        local_23 = _e2745;
                                        if (_e2743.member < _e2743.member_1) {
                                            let _e2752 = (_e2743.member + 1i);
                                            if ((false == (_e2752 > _e2743.member)) != false) {
                                                phi_11674_ = true;
                                            } else {
                                                phi_11674_ = false;
                                            }
                                            let _e2757 = phi_11674_;
                                            if _e2757 {
                                                phi_11680_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_11680_ = type_17(1u, _e2752);
                                            }
                                            let _e2762 = phi_11680_;
                                            phi_11651_ = type_16(_e2762.member_1, _e2743.member_1);
                                            phi_11694_ = type_17(1u, _e2743.member);
                                        } else {
                                            phi_11651_ = _e2743;
                                            phi_11694_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e2768 = phi_11651_;
                                        let _e2770 = phi_11694_;
                                        let _e2773 = (bitcast<i32>(_e2770.member) != 0i);
                                        if _e2773 {
                                            phi_11654_ = (0.5lf * (_e2745 + (_e2735 / _e2745)));
                                        } else {
                                            phi_11654_ = f64();
                                        }
                                        let _e2778 = phi_11654_;
                                        continue;
                                        continuing {
                                            phi_11650_ = _e2768;
                                            phi_11653_ = _e2778;
                                            break if !(_e2773);
                                        }
                                    }
                                    let _e2783 = local_23;
                                    phi_11707_ = (_e2783 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e2790 = phi_11707_;
                                if (_e2727 < _e2718) {
                                    phi_11713_ = -(_e2790);
                                } else {
                                    phi_11713_ = _e2790;
                                }
                                let _e2794 = phi_11713_;
                                let _e2796 = -((_e2727 + _e2794));
                                local_7[0u] = (_e2796 / (_e2796 + _e2728));
                                local_7[1u] = (_e2726 / (_e2726 + _e2796));
                                let _e2805 = local_7[1u];
                                let _e2806 = local_7[0u];
                                if (_e2805 < _e2806) {
                                    let _e2809 = local_7[1u];
                                    let _e2811 = local_7[0u];
                                    local_7[0u] = _e2809;
                                    local_7[1u] = _e2811;
                                }
                                phi_11738_ = type_12(0u, 2u);
                                phi_11741_ = 1u;
                                loop {
                                    let _e2815 = phi_11738_;
                                    let _e2817 = phi_11741_;
                                    local_64 = _e2817;
                                    if (_e2815.member < _e2815.member_1) {
                                        phi_11739_ = type_12((_e2815.member + 1u), _e2815.member_1);
                                        phi_11764_ = type_12(1u, _e2815.member);
                                    } else {
                                        phi_11739_ = _e2815;
                                        phi_11764_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e2829 = phi_11739_;
                                    let _e2831 = phi_11764_;
                                    let _e2835 = (bitcast<i32>(_e2831.member) != 0i);
                                    if _e2835 {
                                        let _e2837 = local_7[_e2831.member_1];
                                        if (_e2837 > _e2718) {
                                            let _e2840 = local_7[_e2831.member_1];
                                            if (_e2840 < _e2719) {
                                                let _e2843 = local_7[_e2831.member_1];
                                                local_6[_e2817] = _e2843;
                                                phi_11808_ = (_e2817 + 1u);
                                            } else {
                                                phi_11808_ = _e2817;
                                            }
                                            let _e2847 = phi_11808_;
                                            phi_11809_ = _e2847;
                                        } else {
                                            phi_11809_ = _e2817;
                                        }
                                        let _e2849 = phi_11809_;
                                        phi_11742_ = _e2849;
                                    } else {
                                        phi_11742_ = u32();
                                    }
                                    let _e2851 = phi_11742_;
                                    continue;
                                    continuing {
                                        phi_11738_ = _e2829;
                                        phi_11741_ = _e2851;
                                        break if !(_e2835);
                                    }
                                }
                                let _e10892 = local_64;
                                phi_11810_ = _e10892;
                            } else {
                                phi_11810_ = 1u;
                            }
                            let _e2854 = phi_11810_;
                            local_6[_e2854] = _e2719;
                            let _e2856 = local_6;
                            local_12 = _e2856;
                            phi_11830_ = type_12(0u, _e2854);
                            loop {
                                let _e2859 = phi_11830_;
                                if (_e2859.member < _e2859.member_1) {
                                    phi_11831_ = type_12((_e2859.member + 1u), _e2859.member_1);
                                    phi_11854_ = type_12(1u, _e2859.member);
                                } else {
                                    phi_11831_ = _e2859;
                                    phi_11854_ = type_12(0u, type_12().member_1);
                                }
                                let _e2871 = phi_11831_;
                                let _e2873 = phi_11854_;
                                if (bitcast<i32>(_e2873.member) != 0i) {
                                    let _e2879 = local_12[_e2873.member_1];
                                    if (_e2879 > _e427) {
                                        phi_11873_ = _e2879;
                                    } else {
                                        phi_11873_ = _e427;
                                    }
                                    let _e2882 = phi_11873_;
                                    let _e2885 = local_12[(_e2873.member_1 + 1u)];
                                    if (_e2885 < _e436) {
                                        phi_11886_ = _e2885;
                                    } else {
                                        phi_11886_ = _e436;
                                    }
                                    let _e2888 = phi_11886_;
                                    if (_e2882 <= _e2888) {
                                        let _e2891 = (f64(1f) - _e2882);
                                        let _e2902 = ((((_e781 * _e2891) + (_e804 * _e2882)) * (_e2891 * _e2891)) + (((_e827 * _e2891) + (_e838 * _e2882)) * (_e2882 * _e2882)));
                                        let _e2904 = (f64(1f) - _e2888);
                                        let _e2915 = ((((_e781 * _e2904) + (_e804 * _e2888)) * (_e2904 * _e2904)) + (((_e827 * _e2904) + (_e838 * _e2888)) * (_e2888 * _e2888)));
                                        if (_e2902 < 0.0lf) {
                                            phi_11922_ = -(_e2902);
                                        } else {
                                            phi_11922_ = _e2902;
                                        }
                                        let _e2919 = phi_11922_;
                                        let _e2920 = (_e2919 > _e1171);
                                        if (_e2915 < 0.0lf) {
                                            phi_11929_ = -(_e2915);
                                        } else {
                                            phi_11929_ = _e2915;
                                        }
                                        let _e2924 = phi_11929_;
                                        let _e2925 = (_e2924 > _e1171);
                                        let _e2926 = f64(0f);
                                        if _e2920 {
                                            if _e2925 {
                                                phi_11941_ = ((_e2902 > _e2926) != (_e2915 > _e2926));
                                                phi_11942_ = false;
                                            } else {
                                                phi_11941_ = bool();
                                                phi_11942_ = true;
                                            }
                                            let _e2931 = phi_11941_;
                                            let _e2933 = phi_11942_;
                                            phi_11943_ = _e2931;
                                            phi_11944_ = _e2933;
                                        } else {
                                            phi_11943_ = bool();
                                            phi_11944_ = true;
                                        }
                                        let _e2935 = phi_11943_;
                                        let _e2937 = phi_11944_;
                                        if _e2937 {
                                            phi_11948_ = false;
                                        } else {
                                            phi_11948_ = _e2935;
                                        }
                                        let _e2939 = phi_11948_;
                                        if _e2920 {
                                            if _e2925 {
                                                if _e2939 {
                                                    phi_11960_ = type_49();
                                                } else {
                                                    phi_11960_ = type_49(f64(1f), _e2926, _e2939);
                                                }
                                                let _e2943 = phi_11960_;
                                                phi_11961_ = _e2943;
                                                phi_11962_ = _e2939;
                                            } else {
                                                phi_11961_ = type_49();
                                                phi_11962_ = true;
                                            }
                                            let _e2945 = phi_11961_;
                                            let _e2947 = phi_11962_;
                                            phi_11963_ = _e2945;
                                            phi_11964_ = _e2947;
                                        } else {
                                            phi_11963_ = type_49();
                                            phi_11964_ = true;
                                        }
                                        let _e2949 = phi_11963_;
                                        let _e2951 = phi_11964_;
                                        if _e2951 {
                                            if _e2920 {
                                                if (_e2902 < _e2926) {
                                                    phi_11977_ = f64(-1f);
                                                } else {
                                                    phi_11977_ = f64(1f);
                                                }
                                                let _e2956 = phi_11977_;
                                                let _e2957 = f64(0.5f);
                                                let _e2958 = f64(3f);
                                                let _e2961 = (_e827 - _e804);
                                                phi_11989_ = type_12(0u, 64u);
                                                phi_11992_ = _e2888;
                                                phi_11994_ = _e2882;
                                                phi_11996_ = (_e2957 * (_e2882 + _e2888));
                                                loop {
                                                    let _e2967 = phi_11989_;
                                                    let _e2969 = phi_11992_;
                                                    let _e2971 = phi_11994_;
                                                    let _e2973 = phi_11996_;
                                                    local_66 = _e2971;
                                                    if (_e2967.member < _e2967.member_1) {
                                                        phi_11990_ = type_12((_e2967.member + 1u), _e2967.member_1);
                                                        phi_12019_ = type_12(1u, _e2967.member);
                                                    } else {
                                                        phi_11990_ = _e2967;
                                                        phi_12019_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2985 = phi_11990_;
                                                    let _e2987 = phi_12019_;
                                                    if (bitcast<i32>(_e2987.member) != 0i) {
                                                        let _e2992 = (f64(1f) - _e2973);
                                                        let _e3005 = ((_e2956 * ((((_e781 * _e2992) + (_e804 * _e2973)) * (_e2992 * _e2992)) + (((_e827 * _e2992) + (_e838 * _e2973)) * (_e2973 * _e2973)))) - _e1171);
                                                        if (_e3005 > f64(0f)) {
                                                            phi_12046_ = _e2969;
                                                            phi_12047_ = _e2973;
                                                        } else {
                                                            phi_12046_ = _e2973;
                                                            phi_12047_ = _e2971;
                                                        }
                                                        let _e3009 = phi_12046_;
                                                        let _e3011 = phi_12047_;
                                                        let _e3013 = ((_e3009 - _e3011) > _e1181);
                                                        if _e3013 {
                                                            let _e3015 = (f64(1f) - _e2973);
                                                            let _e3027 = (-(_e3005) / (_e2956 * (((((_e804 - (_e2958 * _e781)) * _e3015) + (_e2961 * _e2973)) * _e3015) + (((_e2961 * _e3015) + (((_e2958 * _e838) - _e827) * _e2973)) * _e2973))));
                                                            if (_e3005 > f64(0f)) {
                                                                phi_12075_ = (_e2957 * _e1181);
                                                            } else {
                                                                phi_12075_ = -((_e2957 * _e1181));
                                                            }
                                                            let _e3034 = phi_12075_;
                                                            let _e3036 = ((_e2973 + _e3027) + _e3034);
                                                            if (_e3036 > _e3011) {
                                                                if (_e3036 < _e3009) {
                                                                    if (_e3027 < 0.0lf) {
                                                                        phi_12091_ = -(_e3027);
                                                                    } else {
                                                                        phi_12091_ = _e3027;
                                                                    }
                                                                    let _e3042 = phi_12091_;
                                                                    if (_e3042 < (_e2957 * (_e3009 - _e3011))) {
                                                                        phi_12098_ = false;
                                                                    } else {
                                                                        phi_12098_ = true;
                                                                    }
                                                                    let _e3047 = phi_12098_;
                                                                    phi_12099_ = _e3047;
                                                                } else {
                                                                    phi_12099_ = true;
                                                                }
                                                                let _e3049 = phi_12099_;
                                                                phi_12100_ = _e3049;
                                                            } else {
                                                                phi_12100_ = true;
                                                            }
                                                            let _e3051 = phi_12100_;
                                                            if _e3051 {
                                                                phi_12106_ = (_e2957 * (_e3011 + _e3009));
                                                            } else {
                                                                phi_12106_ = _e3036;
                                                            }
                                                            let _e3055 = phi_12106_;
                                                            phi_12107_ = _e3055;
                                                            phi_12108_ = false;
                                                        } else {
                                                            phi_12107_ = f64();
                                                            phi_12108_ = true;
                                                        }
                                                        let _e3057 = phi_12107_;
                                                        let _e3059 = phi_12108_;
                                                        phi_11993_ = _e3009;
                                                        phi_11995_ = _e3011;
                                                        phi_11997_ = _e3057;
                                                        phi_12109_ = _e3011;
                                                        phi_12110_ = _e3013;
                                                        phi_12111_ = _e3059;
                                                    } else {
                                                        phi_11993_ = f64();
                                                        phi_11995_ = f64();
                                                        phi_11997_ = f64();
                                                        phi_12109_ = f64();
                                                        phi_12110_ = false;
                                                        phi_12111_ = false;
                                                    }
                                                    let _e3061 = phi_11993_;
                                                    let _e3063 = phi_11995_;
                                                    let _e3065 = phi_11997_;
                                                    let _e3067 = phi_12109_;
                                                    let _e3069 = phi_12110_;
                                                    let _e3071 = phi_12111_;
                                                    local_24 = _e3071;
                                                    local_65 = _e3067;
                                                    continue;
                                                    continuing {
                                                        phi_11989_ = _e2985;
                                                        phi_11992_ = _e3061;
                                                        phi_11994_ = _e3063;
                                                        phi_11996_ = _e3065;
                                                        break if !(_e3069);
                                                    }
                                                }
                                                let _e3074 = local_24;
                                                if _e3074 {
                                                    let _e10936 = local_65;
                                                    phi_12115_ = _e10936;
                                                } else {
                                                    let _e10938 = local_66;
                                                    phi_12115_ = _e10938;
                                                }
                                                let _e3076 = phi_12115_;
                                                phi_12116_ = _e3076;
                                            } else {
                                                phi_12116_ = _e2882;
                                            }
                                            let _e3078 = phi_12116_;
                                            if _e2925 {
                                                if (_e2915 < _e2926) {
                                                    phi_12126_ = f64(-1f);
                                                } else {
                                                    phi_12126_ = f64(1f);
                                                }
                                                let _e3083 = phi_12126_;
                                                phi_12130_ = type_12(0u, 64u);
                                                phi_12133_ = (_e1181 + _e1181);
                                                loop {
                                                    let _e3086 = phi_12130_;
                                                    let _e3088 = phi_12133_;
                                                    if (_e3086.member < _e3086.member_1) {
                                                        phi_12131_ = type_12((_e3086.member + 1u), _e3086.member_1);
                                                        phi_12156_ = type_12(1u, _e3086.member);
                                                    } else {
                                                        phi_12131_ = _e3086;
                                                        phi_12156_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e3100 = phi_12131_;
                                                    let _e3102 = phi_12156_;
                                                    if (bitcast<i32>(_e3102.member) != 0i) {
                                                        let _e3106 = (_e3078 + _e3088);
                                                        if (_e3106 < _e2888) {
                                                            let _e3109 = (f64(1f) - _e3106);
                                                            let _e3122 = ((_e3083 * ((((_e781 * _e3109) + (_e804 * _e3106)) * (_e3109 * _e3109)) + (((_e827 * _e3109) + (_e838 * _e3106)) * (_e3106 * _e3106)))) > _e1171);
                                                            if _e3122 {
                                                                phi_12187_ = f64();
                                                                phi_12188_ = false;
                                                            } else {
                                                                phi_12187_ = (_e3088 + _e3088);
                                                                phi_12188_ = true;
                                                            }
                                                            let _e3125 = phi_12187_;
                                                            let _e3127 = phi_12188_;
                                                            phi_12189_ = _e3125;
                                                            phi_12190_ = _e3127;
                                                            phi_12191_ = _e3122;
                                                            phi_12192_ = false;
                                                        } else {
                                                            phi_12189_ = f64();
                                                            phi_12190_ = false;
                                                            phi_12191_ = false;
                                                            phi_12192_ = true;
                                                        }
                                                        let _e3129 = phi_12189_;
                                                        let _e3131 = phi_12190_;
                                                        let _e3133 = phi_12191_;
                                                        let _e3135 = phi_12192_;
                                                        phi_12193_ = _e3106;
                                                        phi_12134_ = _e3129;
                                                        phi_12194_ = _e3131;
                                                        phi_12195_ = _e3133;
                                                        phi_12196_ = _e3135;
                                                        phi_12197_ = false;
                                                    } else {
                                                        phi_12193_ = f64();
                                                        phi_12134_ = f64();
                                                        phi_12194_ = false;
                                                        phi_12195_ = false;
                                                        phi_12196_ = false;
                                                        phi_12197_ = true;
                                                    }
                                                    let _e3137 = phi_12193_;
                                                    let _e3139 = phi_12134_;
                                                    let _e3141 = phi_12194_;
                                                    let _e3143 = phi_12195_;
                                                    let _e3145 = phi_12196_;
                                                    let _e3147 = phi_12197_;
                                                    local_25 = _e3143;
                                                    local_67 = _e3145;
                                                    local_68 = _e3147;
                                                    local_69 = _e3137;
                                                    continue;
                                                    continuing {
                                                        phi_12130_ = _e3100;
                                                        phi_12133_ = _e3139;
                                                        break if !(_e3141);
                                                    }
                                                }
                                                let _e3150 = local_25;
                                                if _e3150 {
                                                    phi_12201_ = false;
                                                    phi_12202_ = false;
                                                } else {
                                                    let _e10960 = local_67;
                                                    phi_12201_ = _e10960;
                                                    let _e10963 = local_68;
                                                    phi_12202_ = _e10963;
                                                }
                                                let _e3152 = phi_12201_;
                                                let _e3154 = phi_12202_;
                                                if _e3152 {
                                                    phi_12206_ = true;
                                                } else {
                                                    phi_12206_ = _e3154;
                                                }
                                                let _e3156 = phi_12206_;
                                                if _e3156 {
                                                    phi_12210_ = _e2888;
                                                } else {
                                                    let _e10967 = local_69;
                                                    phi_12210_ = _e10967;
                                                }
                                                let _e3158 = phi_12210_;
                                                phi_12211_ = _e3158;
                                            } else {
                                                phi_12211_ = _e2888;
                                            }
                                            let _e3160 = phi_12211_;
                                            phi_12213_ = type_49(_e3078, _e3160, _e2939);
                                        } else {
                                            phi_12213_ = _e2949;
                                        }
                                        let _e3163 = phi_12213_;
                                        if (_e3163.member > _e3163.member_1) {
                                            phi_16080_ = bool();
                                            phi_16081_ = f64();
                                            phi_16082_ = f64();
                                            phi_16083_ = true;
                                            phi_16084_ = false;
                                            phi_16085_ = false;
                                            phi_16086_ = false;
                                        } else {
                                            let _e3171 = ((_e3163.member_1 - _e3163.member) * f64(0.5f));
                                            let _e3172 = (_e3163.member + _e3171);
                                            let _e3175 = (_e3171 + (1.1102230246251565e-16lf * f64(4f)));
                                            let _e3177 = local_18.member_3;
                                            let _e3180 = local_18.member[0u];
                                            if (_e3180[0] < 0.0lf) {
                                                phi_12244_ = -(_e3180[0]);
                                            } else {
                                                phi_12244_ = _e3180[0];
                                            }
                                            let _e3187 = phi_12244_;
                                            if (_e3180[1] < 0.0lf) {
                                                phi_12251_ = -(_e3180[1]);
                                            } else {
                                                phi_12251_ = _e3180[1];
                                            }
                                            let _e3191 = phi_12251_;
                                            if (_e3187 > _e3191) {
                                                phi_12256_ = _e3187;
                                            } else {
                                                phi_12256_ = _e3191;
                                            }
                                            let _e3194 = phi_12256_;
                                            if (_e3180[2] < 0.0lf) {
                                                phi_12263_ = -(_e3180[2]);
                                            } else {
                                                phi_12263_ = _e3180[2];
                                            }
                                            let _e3198 = phi_12263_;
                                            if (_e3194 > _e3198) {
                                                phi_12268_ = _e3194;
                                            } else {
                                                phi_12268_ = _e3198;
                                            }
                                            let _e3201 = phi_12268_;
                                            let _e3203 = local_18.member[1u];
                                            if (_e3203[0] < 0.0lf) {
                                                phi_12281_ = -(_e3203[0]);
                                            } else {
                                                phi_12281_ = _e3203[0];
                                            }
                                            let _e3210 = phi_12281_;
                                            if (_e3203[1] < 0.0lf) {
                                                phi_12288_ = -(_e3203[1]);
                                            } else {
                                                phi_12288_ = _e3203[1];
                                            }
                                            let _e3214 = phi_12288_;
                                            if (_e3210 > _e3214) {
                                                phi_12293_ = _e3210;
                                            } else {
                                                phi_12293_ = _e3214;
                                            }
                                            let _e3217 = phi_12293_;
                                            if (_e3203[2] < 0.0lf) {
                                                phi_12300_ = -(_e3203[2]);
                                            } else {
                                                phi_12300_ = _e3203[2];
                                            }
                                            let _e3221 = phi_12300_;
                                            if (_e3217 > _e3221) {
                                                phi_12305_ = _e3217;
                                            } else {
                                                phi_12305_ = _e3221;
                                            }
                                            let _e3224 = phi_12305_;
                                            if (_e3201 > _e3224) {
                                                phi_12310_ = _e3201;
                                            } else {
                                                phi_12310_ = _e3224;
                                            }
                                            let _e3227 = phi_12310_;
                                            let _e3230 = local_18.member[0u];
                                            let _e3235 = local_18.member[1u];
                                            let _e3245 = (_e3230[0] + ((_e3235[0] - _e3230[0]) * _e3172));
                                            let _e3246 = (_e3230[1] + ((_e3235[1] - _e3230[1]) * _e3172));
                                            let _e3247 = (_e3230[2] + ((_e3235[2] - _e3230[2]) * _e3172));
                                            let _e3249 = local_18.member[1u];
                                            let _e3254 = local_18.member[0u];
                                            let _e3258 = (_e3249[0] - _e3254[0]);
                                            let _e3259 = (_e3249[1] - _e3254[1]);
                                            let _e3260 = (_e3249[2] - _e3254[2]);
                                            if (_e3258 < 0.0lf) {
                                                phi_12369_ = -(_e3258);
                                            } else {
                                                phi_12369_ = _e3258;
                                            }
                                            let _e3264 = phi_12369_;
                                            if (_e3259 < 0.0lf) {
                                                phi_12375_ = -(_e3259);
                                            } else {
                                                phi_12375_ = _e3259;
                                            }
                                            let _e3268 = phi_12375_;
                                            if (_e3264 > _e3268) {
                                                phi_12380_ = _e3264;
                                            } else {
                                                phi_12380_ = _e3268;
                                            }
                                            let _e3271 = phi_12380_;
                                            if (_e3260 < 0.0lf) {
                                                phi_12386_ = -(_e3260);
                                            } else {
                                                phi_12386_ = _e3260;
                                            }
                                            let _e3275 = phi_12386_;
                                            if (_e3271 > _e3275) {
                                                phi_12391_ = _e3271;
                                            } else {
                                                phi_12391_ = _e3275;
                                            }
                                            let _e3278 = phi_12391_;
                                            let _e3286 = ((((_e3175 * _e3278) * f64(1.01f)) + ((_e3227 + _e3177) * (1.1102230246251565e-16lf * f64(8f)))) + _e3177);
                                            if (_e3245 < 0.0lf) {
                                                phi_12405_ = -(_e3245);
                                            } else {
                                                phi_12405_ = _e3245;
                                            }
                                            let _e3290 = phi_12405_;
                                            if (_e3246 < 0.0lf) {
                                                phi_12411_ = -(_e3246);
                                            } else {
                                                phi_12411_ = _e3246;
                                            }
                                            let _e3294 = phi_12411_;
                                            if (_e3290 > _e3294) {
                                                phi_12416_ = _e3290;
                                            } else {
                                                phi_12416_ = _e3294;
                                            }
                                            let _e3297 = phi_12416_;
                                            if (_e3247 < 0.0lf) {
                                                phi_12422_ = -(_e3247);
                                            } else {
                                                phi_12422_ = _e3247;
                                            }
                                            let _e3301 = phi_12422_;
                                            if (_e3297 > _e3301) {
                                                phi_12427_ = _e3297;
                                            } else {
                                                phi_12427_ = _e3301;
                                            }
                                            let _e3304 = phi_12427_;
                                            local_2 = type_39(array<f64, 3>(_e3245, _e3246, _e3247), _e3286, (_e3304 + _e3286));
                                            let _e3310 = local_18.member_3;
                                            let _e3312 = local_18.member_1[0u];
                                            if (_e3312[0] < 0.0lf) {
                                                phi_12453_ = -(_e3312[0]);
                                            } else {
                                                phi_12453_ = _e3312[0];
                                            }
                                            let _e3319 = phi_12453_;
                                            if (_e3312[1] < 0.0lf) {
                                                phi_12460_ = -(_e3312[1]);
                                            } else {
                                                phi_12460_ = _e3312[1];
                                            }
                                            let _e3323 = phi_12460_;
                                            if (_e3319 > _e3323) {
                                                phi_12465_ = _e3319;
                                            } else {
                                                phi_12465_ = _e3323;
                                            }
                                            let _e3326 = phi_12465_;
                                            if (_e3312[2] < 0.0lf) {
                                                phi_12472_ = -(_e3312[2]);
                                            } else {
                                                phi_12472_ = _e3312[2];
                                            }
                                            let _e3330 = phi_12472_;
                                            if (_e3326 > _e3330) {
                                                phi_12477_ = _e3326;
                                            } else {
                                                phi_12477_ = _e3330;
                                            }
                                            let _e3333 = phi_12477_;
                                            let _e3335 = local_18.member_1[1u];
                                            if (_e3335[0] < 0.0lf) {
                                                phi_12490_ = -(_e3335[0]);
                                            } else {
                                                phi_12490_ = _e3335[0];
                                            }
                                            let _e3342 = phi_12490_;
                                            if (_e3335[1] < 0.0lf) {
                                                phi_12497_ = -(_e3335[1]);
                                            } else {
                                                phi_12497_ = _e3335[1];
                                            }
                                            let _e3346 = phi_12497_;
                                            if (_e3342 > _e3346) {
                                                phi_12502_ = _e3342;
                                            } else {
                                                phi_12502_ = _e3346;
                                            }
                                            let _e3349 = phi_12502_;
                                            if (_e3335[2] < 0.0lf) {
                                                phi_12509_ = -(_e3335[2]);
                                            } else {
                                                phi_12509_ = _e3335[2];
                                            }
                                            let _e3353 = phi_12509_;
                                            if (_e3349 > _e3353) {
                                                phi_12514_ = _e3349;
                                            } else {
                                                phi_12514_ = _e3353;
                                            }
                                            let _e3356 = phi_12514_;
                                            if (_e3333 > _e3356) {
                                                phi_12519_ = _e3333;
                                            } else {
                                                phi_12519_ = _e3356;
                                            }
                                            let _e3359 = phi_12519_;
                                            let _e3362 = local_18.member_1[0u];
                                            let _e3367 = local_18.member_1[1u];
                                            let _e3377 = (_e3362[0] + ((_e3367[0] - _e3362[0]) * _e3172));
                                            let _e3378 = (_e3362[1] + ((_e3367[1] - _e3362[1]) * _e3172));
                                            let _e3379 = (_e3362[2] + ((_e3367[2] - _e3362[2]) * _e3172));
                                            let _e3381 = local_18.member_1[1u];
                                            let _e3386 = local_18.member_1[0u];
                                            let _e3390 = (_e3381[0] - _e3386[0]);
                                            let _e3391 = (_e3381[1] - _e3386[1]);
                                            let _e3392 = (_e3381[2] - _e3386[2]);
                                            if (_e3390 < 0.0lf) {
                                                phi_12578_ = -(_e3390);
                                            } else {
                                                phi_12578_ = _e3390;
                                            }
                                            let _e3396 = phi_12578_;
                                            if (_e3391 < 0.0lf) {
                                                phi_12584_ = -(_e3391);
                                            } else {
                                                phi_12584_ = _e3391;
                                            }
                                            let _e3400 = phi_12584_;
                                            if (_e3396 > _e3400) {
                                                phi_12589_ = _e3396;
                                            } else {
                                                phi_12589_ = _e3400;
                                            }
                                            let _e3403 = phi_12589_;
                                            if (_e3392 < 0.0lf) {
                                                phi_12595_ = -(_e3392);
                                            } else {
                                                phi_12595_ = _e3392;
                                            }
                                            let _e3407 = phi_12595_;
                                            if (_e3403 > _e3407) {
                                                phi_12600_ = _e3403;
                                            } else {
                                                phi_12600_ = _e3407;
                                            }
                                            let _e3410 = phi_12600_;
                                            let _e3418 = ((((_e3175 * _e3410) * f64(1.01f)) + ((_e3359 + _e3310) * (1.1102230246251565e-16lf * f64(8f)))) + _e3310);
                                            if (_e3377 < 0.0lf) {
                                                phi_12614_ = -(_e3377);
                                            } else {
                                                phi_12614_ = _e3377;
                                            }
                                            let _e3422 = phi_12614_;
                                            if (_e3378 < 0.0lf) {
                                                phi_12620_ = -(_e3378);
                                            } else {
                                                phi_12620_ = _e3378;
                                            }
                                            let _e3426 = phi_12620_;
                                            if (_e3422 > _e3426) {
                                                phi_12625_ = _e3422;
                                            } else {
                                                phi_12625_ = _e3426;
                                            }
                                            let _e3429 = phi_12625_;
                                            if (_e3379 < 0.0lf) {
                                                phi_12631_ = -(_e3379);
                                            } else {
                                                phi_12631_ = _e3379;
                                            }
                                            let _e3433 = phi_12631_;
                                            if (_e3429 > _e3433) {
                                                phi_12636_ = _e3429;
                                            } else {
                                                phi_12636_ = _e3433;
                                            }
                                            let _e3436 = phi_12636_;
                                            local_3 = type_39(array<f64, 3>(_e3377, _e3378, _e3379), _e3418, (_e3436 + _e3418));
                                            let _e3442 = local_18.member_3;
                                            let _e3444 = local_18.member_2[0u];
                                            if (_e3444[0] < 0.0lf) {
                                                phi_12662_ = -(_e3444[0]);
                                            } else {
                                                phi_12662_ = _e3444[0];
                                            }
                                            let _e3451 = phi_12662_;
                                            if (_e3444[1] < 0.0lf) {
                                                phi_12669_ = -(_e3444[1]);
                                            } else {
                                                phi_12669_ = _e3444[1];
                                            }
                                            let _e3455 = phi_12669_;
                                            if (_e3451 > _e3455) {
                                                phi_12674_ = _e3451;
                                            } else {
                                                phi_12674_ = _e3455;
                                            }
                                            let _e3458 = phi_12674_;
                                            if (_e3444[2] < 0.0lf) {
                                                phi_12681_ = -(_e3444[2]);
                                            } else {
                                                phi_12681_ = _e3444[2];
                                            }
                                            let _e3462 = phi_12681_;
                                            if (_e3458 > _e3462) {
                                                phi_12686_ = _e3458;
                                            } else {
                                                phi_12686_ = _e3462;
                                            }
                                            let _e3465 = phi_12686_;
                                            let _e3467 = local_18.member_2[1u];
                                            if (_e3467[0] < 0.0lf) {
                                                phi_12699_ = -(_e3467[0]);
                                            } else {
                                                phi_12699_ = _e3467[0];
                                            }
                                            let _e3474 = phi_12699_;
                                            if (_e3467[1] < 0.0lf) {
                                                phi_12706_ = -(_e3467[1]);
                                            } else {
                                                phi_12706_ = _e3467[1];
                                            }
                                            let _e3478 = phi_12706_;
                                            if (_e3474 > _e3478) {
                                                phi_12711_ = _e3474;
                                            } else {
                                                phi_12711_ = _e3478;
                                            }
                                            let _e3481 = phi_12711_;
                                            if (_e3467[2] < 0.0lf) {
                                                phi_12718_ = -(_e3467[2]);
                                            } else {
                                                phi_12718_ = _e3467[2];
                                            }
                                            let _e3485 = phi_12718_;
                                            if (_e3481 > _e3485) {
                                                phi_12723_ = _e3481;
                                            } else {
                                                phi_12723_ = _e3485;
                                            }
                                            let _e3488 = phi_12723_;
                                            if (_e3465 > _e3488) {
                                                phi_12728_ = _e3465;
                                            } else {
                                                phi_12728_ = _e3488;
                                            }
                                            let _e3491 = phi_12728_;
                                            let _e3494 = local_18.member_2[0u];
                                            let _e3499 = local_18.member_2[1u];
                                            let _e3509 = (_e3494[0] + ((_e3499[0] - _e3494[0]) * _e3172));
                                            let _e3510 = (_e3494[1] + ((_e3499[1] - _e3494[1]) * _e3172));
                                            let _e3511 = (_e3494[2] + ((_e3499[2] - _e3494[2]) * _e3172));
                                            let _e3513 = local_18.member_2[1u];
                                            let _e3518 = local_18.member_2[0u];
                                            let _e3522 = (_e3513[0] - _e3518[0]);
                                            let _e3523 = (_e3513[1] - _e3518[1]);
                                            let _e3524 = (_e3513[2] - _e3518[2]);
                                            if (_e3522 < 0.0lf) {
                                                phi_12787_ = -(_e3522);
                                            } else {
                                                phi_12787_ = _e3522;
                                            }
                                            let _e3528 = phi_12787_;
                                            if (_e3523 < 0.0lf) {
                                                phi_12793_ = -(_e3523);
                                            } else {
                                                phi_12793_ = _e3523;
                                            }
                                            let _e3532 = phi_12793_;
                                            if (_e3528 > _e3532) {
                                                phi_12798_ = _e3528;
                                            } else {
                                                phi_12798_ = _e3532;
                                            }
                                            let _e3535 = phi_12798_;
                                            if (_e3524 < 0.0lf) {
                                                phi_12804_ = -(_e3524);
                                            } else {
                                                phi_12804_ = _e3524;
                                            }
                                            let _e3539 = phi_12804_;
                                            if (_e3535 > _e3539) {
                                                phi_12809_ = _e3535;
                                            } else {
                                                phi_12809_ = _e3539;
                                            }
                                            let _e3542 = phi_12809_;
                                            let _e3550 = ((((_e3175 * _e3542) * f64(1.01f)) + ((_e3491 + _e3442) * (1.1102230246251565e-16lf * f64(8f)))) + _e3442);
                                            if (_e3509 < 0.0lf) {
                                                phi_12823_ = -(_e3509);
                                            } else {
                                                phi_12823_ = _e3509;
                                            }
                                            let _e3554 = phi_12823_;
                                            if (_e3510 < 0.0lf) {
                                                phi_12829_ = -(_e3510);
                                            } else {
                                                phi_12829_ = _e3510;
                                            }
                                            let _e3558 = phi_12829_;
                                            if (_e3554 > _e3558) {
                                                phi_12834_ = _e3554;
                                            } else {
                                                phi_12834_ = _e3558;
                                            }
                                            let _e3561 = phi_12834_;
                                            if (_e3511 < 0.0lf) {
                                                phi_12840_ = -(_e3511);
                                            } else {
                                                phi_12840_ = _e3511;
                                            }
                                            let _e3565 = phi_12840_;
                                            if (_e3561 > _e3565) {
                                                phi_12845_ = _e3561;
                                            } else {
                                                phi_12845_ = _e3565;
                                            }
                                            let _e3568 = phi_12845_;
                                            local_4 = type_39(array<f64, 3>(_e3509, _e3510, _e3511), _e3550, (_e3568 + _e3550));
                                            let _e3573 = local_3.member;
                                            let _e3578 = local_4.member;
                                            let _e3584 = ((_e3573[1] * _e3578[2]) - (_e3573[2] * _e3578[1]));
                                            let _e3587 = ((_e3573[2] * _e3578[0]) - (_e3573[0] * _e3578[2]));
                                            let _e3590 = ((_e3573[0] * _e3578[1]) - (_e3573[1] * _e3578[0]));
                                            if (_e3584 < 0.0lf) {
                                                phi_12894_ = -(_e3584);
                                            } else {
                                                phi_12894_ = _e3584;
                                            }
                                            let _e3594 = phi_12894_;
                                            if (_e3587 < 0.0lf) {
                                                phi_12900_ = -(_e3587);
                                            } else {
                                                phi_12900_ = _e3587;
                                            }
                                            let _e3598 = phi_12900_;
                                            if (_e3594 > _e3598) {
                                                if (_e3584 < 0.0lf) {
                                                    phi_12910_ = -(_e3584);
                                                } else {
                                                    phi_12910_ = _e3584;
                                                }
                                                let _e3616 = phi_12910_;
                                                if (_e3590 < 0.0lf) {
                                                    phi_12916_ = -(_e3590);
                                                } else {
                                                    phi_12916_ = _e3590;
                                                }
                                                let _e3620 = phi_12916_;
                                                if (_e3616 > _e3620) {
                                                    phi_12921_ = 2u;
                                                    phi_12922_ = 1u;
                                                } else {
                                                    phi_12921_ = 1u;
                                                    phi_12922_ = 0u;
                                                }
                                                let _e3623 = phi_12921_;
                                                let _e3625 = phi_12922_;
                                                phi_12941_ = _e3623;
                                                phi_12942_ = _e3625;
                                            } else {
                                                if (_e3587 < 0.0lf) {
                                                    phi_12928_ = -(_e3587);
                                                } else {
                                                    phi_12928_ = _e3587;
                                                }
                                                let _e3603 = phi_12928_;
                                                if (_e3590 < 0.0lf) {
                                                    phi_12934_ = -(_e3590);
                                                } else {
                                                    phi_12934_ = _e3590;
                                                }
                                                let _e3607 = phi_12934_;
                                                if (_e3603 > _e3607) {
                                                    phi_12939_ = 0u;
                                                    phi_12940_ = 2u;
                                                } else {
                                                    phi_12939_ = 1u;
                                                    phi_12940_ = 0u;
                                                }
                                                let _e3610 = phi_12939_;
                                                let _e3612 = phi_12940_;
                                                phi_12941_ = _e3610;
                                                phi_12942_ = _e3612;
                                            }
                                            let _e3627 = phi_12941_;
                                            let _e3629 = phi_12942_;
                                            let _e3632 = local_3.member[_e3629];
                                            let _e3635 = local_4.member[_e3627];
                                            let _e3639 = local_3.member[_e3627];
                                            let _e3642 = local_4.member[_e3629];
                                            let _e3644 = ((_e3632 * _e3635) - (_e3639 * _e3642));
                                            let _e3645 = f64(1f);
                                            let _e3646 = f64(2f);
                                            let _e3648 = local_3.member_1;
                                            let _e3650 = local_4.member_2;
                                            let _e3653 = local_3.member_2;
                                            let _e3655 = local_4.member_1;
                                            let _e3661 = local_3.member_2;
                                            let _e3664 = local_4.member_2;
                                            let _e3673 = local_3.member_2;
                                            let _e3676 = local_4.member_2;
                                            let _e3680 = (((((_e3648 * _e3650) + (_e3653 * _e3655)) * f64(2.01f)) + (((_e3661 * _e3646) * (_e3664 * _e3646)) * (1.1102230246251565e-16lf * _e3646))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3645 + _e3673) * (_e3645 + _e3676))));
                                            if (_e3644 < 0.0lf) {
                                                phi_13015_ = -(_e3644);
                                            } else {
                                                phi_13015_ = _e3644;
                                            }
                                            let _e3684 = phi_13015_;
                                            if (_e3684 > _e3680) {
                                                if (_e3644 < f64(0f)) {
                                                    phi_13027_ = f64(-1f);
                                                } else {
                                                    phi_13027_ = f64(1f);
                                                }
                                                let _e3691 = phi_13027_;
                                                let _e3694 = local_2.member[_e3629];
                                                let _e3697 = local_4.member[_e3627];
                                                let _e3701 = local_2.member[_e3627];
                                                let _e3704 = local_4.member[_e3629];
                                                let _e3707 = f64(1f);
                                                let _e3708 = f64(2f);
                                                let _e3710 = local_2.member_1;
                                                let _e3712 = local_4.member_2;
                                                let _e3715 = local_2.member_2;
                                                let _e3717 = local_4.member_1;
                                                let _e3723 = local_2.member_2;
                                                let _e3726 = local_4.member_2;
                                                let _e3735 = local_2.member_2;
                                                let _e3738 = local_4.member_2;
                                                let _e3742 = (((((_e3710 * _e3712) + (_e3715 * _e3717)) * f64(2.01f)) + (((_e3723 * _e3708) * (_e3726 * _e3708)) * (1.1102230246251565e-16lf * _e3708))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3707 + _e3735) * (_e3707 + _e3738))));
                                                let _e3745 = local_3.member[_e3629];
                                                let _e3748 = local_2.member[_e3627];
                                                let _e3752 = local_3.member[_e3627];
                                                let _e3755 = local_2.member[_e3629];
                                                let _e3758 = f64(1f);
                                                let _e3759 = f64(2f);
                                                let _e3761 = local_3.member_1;
                                                let _e3763 = local_2.member_2;
                                                let _e3766 = local_3.member_2;
                                                let _e3768 = local_2.member_1;
                                                let _e3774 = local_3.member_2;
                                                let _e3777 = local_2.member_2;
                                                let _e3786 = local_3.member_2;
                                                let _e3789 = local_2.member_2;
                                                let _e3793 = (((((_e3761 * _e3763) + (_e3766 * _e3768)) * f64(2.01f)) + (((_e3774 * _e3759) * (_e3777 * _e3759)) * (1.1102230246251565e-16lf * _e3759))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3758 + _e3786) * (_e3758 + _e3789))));
                                                let _e3794 = (_e3644 * _e3691);
                                                let _e3795 = (((_e3694 * _e3697) - (_e3701 * _e3704)) * _e3691);
                                                let _e3796 = (((_e3745 * _e3748) - (_e3752 * _e3755)) * _e3691);
                                                if (_e3794 < 0.0lf) {
                                                    phi_13170_ = -(_e3794);
                                                } else {
                                                    phi_13170_ = _e3794;
                                                }
                                                let _e3800 = phi_13170_;
                                                if (_e3795 < 0.0lf) {
                                                    phi_13176_ = -(_e3795);
                                                } else {
                                                    phi_13176_ = _e3795;
                                                }
                                                let _e3804 = phi_13176_;
                                                if (_e3796 < 0.0lf) {
                                                    phi_13183_ = -(_e3796);
                                                } else {
                                                    phi_13183_ = _e3796;
                                                }
                                                let _e3809 = phi_13183_;
                                                let _e3815 = ((_e3794 - _e3795) - _e3796);
                                                let _e3818 = (((_e3680 + _e3742) + _e3793) + (((_e3800 + _e3804) + _e3809) * (1.1102230246251565e-16lf * f64(4f))));
                                                local_5 = array<type_40, 4>(type_40(_e3795, _e3742), type_40(_e3796, _e3793), type_40(_e3815, _e3818), type_40(_e3815, _e3818));
                                                phi_13239_ = type_12(0u, 4u);
                                                phi_13242_ = true;
                                                loop {
                                                    let _e3825 = phi_13239_;
                                                    let _e3827 = phi_13242_;
                                                    local_27 = _e3827;
                                                    if (_e3825.member < _e3825.member_1) {
                                                        phi_13240_ = type_12((_e3825.member + 1u), _e3825.member_1);
                                                        phi_13265_ = type_12(1u, _e3825.member);
                                                    } else {
                                                        phi_13240_ = _e3825;
                                                        phi_13265_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e3839 = phi_13240_;
                                                    let _e3841 = phi_13265_;
                                                    if (bitcast<i32>(_e3841.member) != 0i) {
                                                        let _e3848 = local_5[_e3841.member_1].member;
                                                        let _e3851 = local_5[_e3841.member_1].member_1;
                                                        let _e3853 = (_e3848 < -(_e3851));
                                                        if _e3853 {
                                                            phi_13292_ = bool();
                                                            phi_13293_ = false;
                                                        } else {
                                                            phi_13292_ = (_e3827 && (_e3848 > _e3851));
                                                            phi_13293_ = true;
                                                        }
                                                        let _e3857 = phi_13292_;
                                                        let _e3859 = phi_13293_;
                                                        phi_13243_ = _e3857;
                                                        phi_13294_ = _e3859;
                                                        phi_13295_ = _e3853;
                                                    } else {
                                                        phi_13243_ = bool();
                                                        phi_13294_ = false;
                                                        phi_13295_ = false;
                                                    }
                                                    let _e3861 = phi_13243_;
                                                    let _e3863 = phi_13294_;
                                                    let _e3865 = phi_13295_;
                                                    local_26 = _e3865;
                                                    continue;
                                                    continuing {
                                                        phi_13239_ = _e3839;
                                                        phi_13242_ = _e3861;
                                                        break if !(_e3863);
                                                    }
                                                }
                                                let _e3868 = local_26;
                                                if _e3868 {
                                                    phi_13299_ = false;
                                                } else {
                                                    phi_13299_ = true;
                                                }
                                                let _e3870 = phi_13299_;
                                                if _e3870 {
                                                    let _e3872 = local_27;
                                                    if _e3872 {
                                                        phi_13306_ = 1u;
                                                    } else {
                                                        phi_13306_ = 2u;
                                                    }
                                                    let _e3874 = phi_13306_;
                                                    phi_13307_ = _e3874;
                                                    phi_13308_ = false;
                                                } else {
                                                    phi_13307_ = u32();
                                                    phi_13308_ = true;
                                                }
                                                let _e3876 = phi_13307_;
                                                let _e3878 = phi_13308_;
                                                phi_13309_ = _e3876;
                                                phi_13310_ = 0u;
                                                phi_13311_ = _e3878;
                                            } else {
                                                phi_13309_ = u32();
                                                phi_13310_ = 2u;
                                                phi_13311_ = true;
                                            }
                                            let _e3880 = phi_13309_;
                                            let _e3882 = phi_13310_;
                                            let _e3884 = phi_13311_;
                                            if _e3884 {
                                                phi_13315_ = _e3882;
                                            } else {
                                                phi_13315_ = _e3880;
                                            }
                                            let _e3886 = phi_13315_;
                                            let _e3887 = (_e3886 == 0u);
                                            if _e3887 {
                                                phi_16074_ = bool();
                                                phi_16075_ = f64();
                                                phi_16076_ = f64();
                                                phi_16077_ = false;
                                                phi_16078_ = false;
                                                phi_16079_ = false;
                                            } else {
                                                if (_e3886 == 1u) {
                                                    phi_13325_ = _e3163.member_2;
                                                } else {
                                                    phi_13325_ = false;
                                                }
                                                let _e3891 = phi_13325_;
                                                let _e3893 = (_e418 * f64(0.99f));
                                                if _e3891 {
                                                    if ((_e3163.member_1 - _e3163.member) <= _e3893) {
                                                        phi_13338_ = false;
                                                    } else {
                                                        phi_13338_ = true;
                                                    }
                                                    let _e3899 = phi_13338_;
                                                    phi_13339_ = _e3899;
                                                } else {
                                                    phi_13339_ = true;
                                                }
                                                let _e3901 = phi_13339_;
                                                if _e3901 {
                                                    let _e3906 = local_18.member[0u];
                                                    let _e3912 = local_18.member_1[0u];
                                                    let _e3918 = local_18.member_2[0u];
                                                    let _e3930 = local_18.member[1u];
                                                    let _e3936 = local_18.member_1[1u];
                                                    let _e3942 = local_18.member_2[1u];
                                                    let _e3954 = local_18.member[0u];
                                                    if (_e3954[0] < 0.0lf) {
                                                        phi_13487_ = -(_e3954[0]);
                                                    } else {
                                                        phi_13487_ = _e3954[0];
                                                    }
                                                    let _e3961 = phi_13487_;
                                                    if (_e3954[1] < 0.0lf) {
                                                        phi_13494_ = -(_e3954[1]);
                                                    } else {
                                                        phi_13494_ = _e3954[1];
                                                    }
                                                    let _e3965 = phi_13494_;
                                                    if (_e3961 > _e3965) {
                                                        phi_13499_ = _e3961;
                                                    } else {
                                                        phi_13499_ = _e3965;
                                                    }
                                                    let _e3968 = phi_13499_;
                                                    if (_e3954[2] < 0.0lf) {
                                                        phi_13506_ = -(_e3954[2]);
                                                    } else {
                                                        phi_13506_ = _e3954[2];
                                                    }
                                                    let _e3972 = phi_13506_;
                                                    if (_e3968 > _e3972) {
                                                        phi_13511_ = _e3968;
                                                    } else {
                                                        phi_13511_ = _e3972;
                                                    }
                                                    let _e3975 = phi_13511_;
                                                    let _e3978 = local_18.member[1u];
                                                    if (_e3978[0] < 0.0lf) {
                                                        phi_13524_ = -(_e3978[0]);
                                                    } else {
                                                        phi_13524_ = _e3978[0];
                                                    }
                                                    let _e3985 = phi_13524_;
                                                    if (_e3978[1] < 0.0lf) {
                                                        phi_13531_ = -(_e3978[1]);
                                                    } else {
                                                        phi_13531_ = _e3978[1];
                                                    }
                                                    let _e3989 = phi_13531_;
                                                    if (_e3985 > _e3989) {
                                                        phi_13536_ = _e3985;
                                                    } else {
                                                        phi_13536_ = _e3989;
                                                    }
                                                    let _e3992 = phi_13536_;
                                                    if (_e3978[2] < 0.0lf) {
                                                        phi_13543_ = -(_e3978[2]);
                                                    } else {
                                                        phi_13543_ = _e3978[2];
                                                    }
                                                    let _e3996 = phi_13543_;
                                                    if (_e3992 > _e3996) {
                                                        phi_13548_ = _e3992;
                                                    } else {
                                                        phi_13548_ = _e3996;
                                                    }
                                                    let _e3999 = phi_13548_;
                                                    if (_e3975 > _e3999) {
                                                        phi_13553_ = _e3975;
                                                    } else {
                                                        phi_13553_ = _e3999;
                                                    }
                                                    let _e4002 = phi_13553_;
                                                    let _e4004 = local_18.member_3;
                                                    let _e4008 = local_18.member_1[0u];
                                                    if (_e4008[0] < 0.0lf) {
                                                        phi_13570_ = -(_e4008[0]);
                                                    } else {
                                                        phi_13570_ = _e4008[0];
                                                    }
                                                    let _e4015 = phi_13570_;
                                                    if (_e4008[1] < 0.0lf) {
                                                        phi_13577_ = -(_e4008[1]);
                                                    } else {
                                                        phi_13577_ = _e4008[1];
                                                    }
                                                    let _e4019 = phi_13577_;
                                                    if (_e4015 > _e4019) {
                                                        phi_13582_ = _e4015;
                                                    } else {
                                                        phi_13582_ = _e4019;
                                                    }
                                                    let _e4022 = phi_13582_;
                                                    if (_e4008[2] < 0.0lf) {
                                                        phi_13589_ = -(_e4008[2]);
                                                    } else {
                                                        phi_13589_ = _e4008[2];
                                                    }
                                                    let _e4026 = phi_13589_;
                                                    if (_e4022 > _e4026) {
                                                        phi_13594_ = _e4022;
                                                    } else {
                                                        phi_13594_ = _e4026;
                                                    }
                                                    let _e4029 = phi_13594_;
                                                    let _e4032 = local_18.member_1[1u];
                                                    if (_e4032[0] < 0.0lf) {
                                                        phi_13608_ = -(_e4032[0]);
                                                    } else {
                                                        phi_13608_ = _e4032[0];
                                                    }
                                                    let _e4039 = phi_13608_;
                                                    if (_e4032[1] < 0.0lf) {
                                                        phi_13615_ = -(_e4032[1]);
                                                    } else {
                                                        phi_13615_ = _e4032[1];
                                                    }
                                                    let _e4043 = phi_13615_;
                                                    if (_e4039 > _e4043) {
                                                        phi_13620_ = _e4039;
                                                    } else {
                                                        phi_13620_ = _e4043;
                                                    }
                                                    let _e4046 = phi_13620_;
                                                    if (_e4032[2] < 0.0lf) {
                                                        phi_13627_ = -(_e4032[2]);
                                                    } else {
                                                        phi_13627_ = _e4032[2];
                                                    }
                                                    let _e4050 = phi_13627_;
                                                    if (_e4046 > _e4050) {
                                                        phi_13632_ = _e4046;
                                                    } else {
                                                        phi_13632_ = _e4050;
                                                    }
                                                    let _e4053 = phi_13632_;
                                                    if (_e4029 > _e4053) {
                                                        phi_13637_ = _e4029;
                                                    } else {
                                                        phi_13637_ = _e4053;
                                                    }
                                                    let _e4056 = phi_13637_;
                                                    let _e4058 = local_18.member_3;
                                                    let _e4062 = local_18.member_2[0u];
                                                    if (_e4062[0] < 0.0lf) {
                                                        phi_13654_ = -(_e4062[0]);
                                                    } else {
                                                        phi_13654_ = _e4062[0];
                                                    }
                                                    let _e4069 = phi_13654_;
                                                    if (_e4062[1] < 0.0lf) {
                                                        phi_13661_ = -(_e4062[1]);
                                                    } else {
                                                        phi_13661_ = _e4062[1];
                                                    }
                                                    let _e4073 = phi_13661_;
                                                    if (_e4069 > _e4073) {
                                                        phi_13666_ = _e4069;
                                                    } else {
                                                        phi_13666_ = _e4073;
                                                    }
                                                    let _e4076 = phi_13666_;
                                                    if (_e4062[2] < 0.0lf) {
                                                        phi_13673_ = -(_e4062[2]);
                                                    } else {
                                                        phi_13673_ = _e4062[2];
                                                    }
                                                    let _e4080 = phi_13673_;
                                                    if (_e4076 > _e4080) {
                                                        phi_13678_ = _e4076;
                                                    } else {
                                                        phi_13678_ = _e4080;
                                                    }
                                                    let _e4083 = phi_13678_;
                                                    let _e4086 = local_18.member_2[1u];
                                                    if (_e4086[0] < 0.0lf) {
                                                        phi_13692_ = -(_e4086[0]);
                                                    } else {
                                                        phi_13692_ = _e4086[0];
                                                    }
                                                    let _e4093 = phi_13692_;
                                                    if (_e4086[1] < 0.0lf) {
                                                        phi_13699_ = -(_e4086[1]);
                                                    } else {
                                                        phi_13699_ = _e4086[1];
                                                    }
                                                    let _e4097 = phi_13699_;
                                                    if (_e4093 > _e4097) {
                                                        phi_13704_ = _e4093;
                                                    } else {
                                                        phi_13704_ = _e4097;
                                                    }
                                                    let _e4100 = phi_13704_;
                                                    if (_e4086[2] < 0.0lf) {
                                                        phi_13711_ = -(_e4086[2]);
                                                    } else {
                                                        phi_13711_ = _e4086[2];
                                                    }
                                                    let _e4104 = phi_13711_;
                                                    if (_e4100 > _e4104) {
                                                        phi_13716_ = _e4100;
                                                    } else {
                                                        phi_13716_ = _e4104;
                                                    }
                                                    let _e4107 = phi_13716_;
                                                    if (_e4083 > _e4107) {
                                                        phi_13721_ = _e4083;
                                                    } else {
                                                        phi_13721_ = _e4107;
                                                    }
                                                    let _e4110 = phi_13721_;
                                                    let _e4112 = local_18.member_3;
                                                    let _e4120 = local_18.member_3;
                                                    let _e4128 = (_e418 * f64(0.00390625f));
                                                    let _e4129 = f64(0f);
                                                    let _e4130 = f64(1f);
                                                    local = type_38(array<f64, 4>(_e4129, _e4129, _e4129, _e4129), array<f64, 4>(_e4129, _e4129, _e4129, _e4129), array<f64, 4>(_e4130, _e4130, _e4130, _e4130));
                                                    phi_13768_ = type_12(0u, 96u);
                                                    phi_13771_ = _e3163.member;
                                                    phi_13773_ = _e3163.member;
                                                    phi_13775_ = (_e3163.member_1 - _e3163.member);
                                                    phi_13777_ = _e3163.member;
                                                    phi_13779_ = false;
                                                    phi_13781_ = 0u;
                                                    loop {
                                                        let _e4137 = phi_13768_;
                                                        let _e4139 = phi_13771_;
                                                        let _e4141 = phi_13773_;
                                                        let _e4143 = phi_13775_;
                                                        let _e4145 = phi_13777_;
                                                        let _e4147 = phi_13779_;
                                                        let _e4149 = phi_13781_;
                                                        local_31 = _e4139;
                                                        local_78 = _e4141;
                                                        if (_e4137.member < _e4137.member_1) {
                                                            phi_13769_ = type_12((_e4137.member + 1u), _e4137.member_1);
                                                            phi_13804_ = type_12(1u, _e4137.member);
                                                        } else {
                                                            phi_13769_ = _e4137;
                                                            phi_13804_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e4161 = phi_13769_;
                                                        let _e4163 = phi_13804_;
                                                        if (bitcast<i32>(_e4163.member) != 0i) {
                                                            let _e4169 = local_18.member[0u];
                                                            let _e4175 = local_18.member[1u];
                                                            let _e4191 = local_18.member_1[0u];
                                                            let _e4197 = local_18.member_1[1u];
                                                            let _e4213 = local_18.member_2[0u];
                                                            let _e4219 = local_18.member_2[1u];
                                                            let _e4233 = function_3(array<f64, 3>((_e4169[0] + ((_e4175[0] - _e4169[0]) * _e4139)), (_e4169[1] + ((_e4175[1] - _e4169[1]) * _e4139)), (_e4169[2] + ((_e4175[2] - _e4169[2]) * _e4139))), array<f64, 3>((_e4191[0] + ((_e4197[0] - _e4191[0]) * _e4139)), (_e4191[1] + ((_e4197[1] - _e4191[1]) * _e4139)), (_e4191[2] + ((_e4197[2] - _e4191[2]) * _e4139))), array<f64, 3>((_e4213[0] + ((_e4219[0] - _e4213[0]) * _e4139)), (_e4213[1] + ((_e4219[1] - _e4213[1]) * _e4139)), (_e4213[2] + ((_e4219[2] - _e4213[2]) * _e4139))), 0u);
                                                            if (_e4149 == 0u) {
                                                                phi_13933_ = _e4233;
                                                            } else {
                                                                let _e4235 = f64(0f);
                                                                if (_e4149 == 1u) {
                                                                    phi_13919_ = _e4233[0];
                                                                } else {
                                                                    phi_13919_ = _e4235;
                                                                }
                                                                let _e4239 = phi_13919_;
                                                                if (_e4149 == 2u) {
                                                                    phi_13925_ = _e4233[1];
                                                                } else {
                                                                    phi_13925_ = _e4235;
                                                                }
                                                                let _e4243 = phi_13925_;
                                                                if (_e4149 == 3u) {
                                                                    phi_13931_ = _e4233[2];
                                                                } else {
                                                                    phi_13931_ = _e4235;
                                                                }
                                                                let _e4247 = phi_13931_;
                                                                phi_13933_ = array<f64, 3>(_e4239, _e4243, _e4247);
                                                            }
                                                            let _e4250 = phi_13933_;
                                                            if (_e4250[0] < 0.0lf) {
                                                                phi_13940_ = -(_e4250[0]);
                                                            } else {
                                                                phi_13940_ = _e4250[0];
                                                            }
                                                            let _e4255 = phi_13940_;
                                                            if (_e4250[1] < 0.0lf) {
                                                                phi_13947_ = -(_e4250[1]);
                                                            } else {
                                                                phi_13947_ = _e4250[1];
                                                            }
                                                            let _e4260 = phi_13947_;
                                                            if (_e4250[2] < 0.0lf) {
                                                                phi_13955_ = -(_e4250[2]);
                                                            } else {
                                                                phi_13955_ = _e4250[2];
                                                            }
                                                            let _e4266 = phi_13955_;
                                                            let _e4267 = ((_e4255 + _e4260) + _e4266);
                                                            if (_e4267 > f64(0f)) {
                                                                if ((bitcast<u64>(_e4267) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                                    let _e4274 = (f64(1f) / _e4267);
                                                                    let _e4276 = (_e4250[0] * _e4274);
                                                                    let _e4278 = (_e4250[1] * _e4274);
                                                                    let _e4280 = (_e4250[2] * _e4274);
                                                                    let _e4285 = (((_e4276 * _e4276) + (_e4278 * _e4278)) + (_e4280 * _e4280));
                                                                    if (_e4285 <= 2.2250738585072014e-308lf) {
                                                                        if (_e4285 > 0.0lf) {
                                                                            phi_13994_ = (1.464336215552873e-154lf * 2.0lf);
                                                                        } else {
                                                                            phi_13994_ = 0.0lf;
                                                                        }
                                                                        let _e4337 = phi_13994_;
                                                                        phi_14058_ = _e4337;
                                                                    } else {
                                                                        phi_14001_ = type_16(0i, 5i);
                                                                        phi_14004_ = bitcast<f64>(((bitcast<u64>(_e4285) / 2lu) + 2303426169912950784lu));
                                                                        loop {
                                                                            let _e4292 = phi_14001_;
                                                                            let _e4294 = phi_14004_;
                                                                            local_28 = _e4294;
                                                                            if (_e4292.member < _e4292.member_1) {
                                                                                let _e4301 = (_e4292.member + 1i);
                                                                                if ((false == (_e4301 > _e4292.member)) != false) {
                                                                                    phi_14025_ = true;
                                                                                } else {
                                                                                    phi_14025_ = false;
                                                                                }
                                                                                let _e4306 = phi_14025_;
                                                                                if _e4306 {
                                                                                    phi_14031_ = type_17(0u, type_17().member_1);
                                                                                } else {
                                                                                    phi_14031_ = type_17(1u, _e4301);
                                                                                }
                                                                                let _e4311 = phi_14031_;
                                                                                phi_14002_ = type_16(_e4311.member_1, _e4292.member_1);
                                                                                phi_14045_ = type_17(1u, _e4292.member);
                                                                            } else {
                                                                                phi_14002_ = _e4292;
                                                                                phi_14045_ = type_17(0u, type_17().member_1);
                                                                            }
                                                                            let _e4317 = phi_14002_;
                                                                            let _e4319 = phi_14045_;
                                                                            let _e4322 = (bitcast<i32>(_e4319.member) != 0i);
                                                                            if _e4322 {
                                                                                phi_14005_ = (0.5lf * (_e4294 + (_e4285 / _e4294)));
                                                                            } else {
                                                                                phi_14005_ = f64();
                                                                            }
                                                                            let _e4327 = phi_14005_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_14001_ = _e4317;
                                                                                phi_14004_ = _e4327;
                                                                                break if !(_e4322);
                                                                            }
                                                                        }
                                                                        let _e4332 = local_28;
                                                                        phi_14058_ = (_e4332 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                    }
                                                                    let _e4339 = phi_14058_;
                                                                    let _e4341 = (1.1102230246251565e-16lf * f64(12f));
                                                                    let _e4348 = ((((((((_e4002 + _e4004) + (_e4056 + _e4058)) + (_e4110 + _e4112)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4120 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e683 * _e4339) * (f64(1f) + _e4341)));
                                                                    let _e4353 = (((_e4276 * _e3906[0]) + (_e4278 * _e3906[1])) + (_e4280 * _e3906[2]));
                                                                    let _e4358 = (((_e4276 * (_e3906[0] - _e3912[0])) + (_e4278 * (_e3906[1] - _e3912[1]))) + (_e4280 * (_e3906[2] - _e3912[2])));
                                                                    let _e4363 = (((_e4276 * (_e3906[0] - _e3918[0])) + (_e4278 * (_e3906[1] - _e3918[1]))) + (_e4280 * (_e3906[2] - _e3918[2])));
                                                                    let _e4368 = (((_e4276 * _e3906[0]) + (_e4278 * _e3906[1])) + (_e4280 * _e3906[2]));
                                                                    let _e4374 = (((_e4276 * _e3930[0]) + (_e4278 * _e3930[1])) + (_e4280 * _e3930[2]));
                                                                    let _e4379 = (((_e4276 * (_e3930[0] - _e3936[0])) + (_e4278 * (_e3930[1] - _e3936[1]))) + (_e4280 * (_e3930[2] - _e3936[2])));
                                                                    let _e4384 = (((_e4276 * (_e3930[0] - _e3942[0])) + (_e4278 * (_e3930[1] - _e3942[1]))) + (_e4280 * (_e3930[2] - _e3942[2])));
                                                                    let _e4389 = (((_e4276 * _e3930[0]) + (_e4278 * _e3930[1])) + (_e4280 * _e3930[2]));
                                                                    if (_e4353 < 0.0lf) {
                                                                        phi_14127_ = -(_e4353);
                                                                    } else {
                                                                        phi_14127_ = _e4353;
                                                                    }
                                                                    let _e4394 = phi_14127_;
                                                                    if (_e4374 < 0.0lf) {
                                                                        phi_14133_ = -(_e4374);
                                                                    } else {
                                                                        phi_14133_ = _e4374;
                                                                    }
                                                                    let _e4398 = phi_14133_;
                                                                    if (_e4358 < 0.0lf) {
                                                                        phi_14142_ = -(_e4358);
                                                                    } else {
                                                                        phi_14142_ = _e4358;
                                                                    }
                                                                    let _e4405 = phi_14142_;
                                                                    if (_e4379 < 0.0lf) {
                                                                        phi_14148_ = -(_e4379);
                                                                    } else {
                                                                        phi_14148_ = _e4379;
                                                                    }
                                                                    let _e4409 = phi_14148_;
                                                                    if (_e4363 < 0.0lf) {
                                                                        phi_14157_ = -(_e4363);
                                                                    } else {
                                                                        phi_14157_ = _e4363;
                                                                    }
                                                                    let _e4416 = phi_14157_;
                                                                    if (_e4384 < 0.0lf) {
                                                                        phi_14163_ = -(_e4384);
                                                                    } else {
                                                                        phi_14163_ = _e4384;
                                                                    }
                                                                    let _e4420 = phi_14163_;
                                                                    if (_e4368 < 0.0lf) {
                                                                        phi_14172_ = -(_e4368);
                                                                    } else {
                                                                        phi_14172_ = _e4368;
                                                                    }
                                                                    let _e4427 = phi_14172_;
                                                                    if (_e4389 < 0.0lf) {
                                                                        phi_14178_ = -(_e4389);
                                                                    } else {
                                                                        phi_14178_ = _e4389;
                                                                    }
                                                                    let _e4431 = phi_14178_;
                                                                    phi_14184_ = type_38(array<f64, 4>(_e4353, _e4358, _e4363, _e4368), array<f64, 4>(_e4374, _e4379, _e4384, _e4389), array<f64, 4>((_e4348 + ((_e4394 + _e4398) * _e4341)), (_e4348 + ((_e4405 + _e4409) * _e4341)), (_e4348 + ((_e4416 + _e4420) * _e4341)), (_e4348 + ((_e4427 + _e4431) * _e4341))));
                                                                    phi_14185_ = false;
                                                                } else {
                                                                    phi_14184_ = type_38();
                                                                    phi_14185_ = true;
                                                                }
                                                                let _e4438 = phi_14184_;
                                                                let _e4440 = phi_14185_;
                                                                phi_14186_ = _e4438;
                                                                phi_14187_ = _e4440;
                                                            } else {
                                                                phi_14186_ = type_38();
                                                                phi_14187_ = true;
                                                            }
                                                            let _e4442 = phi_14186_;
                                                            let _e4444 = phi_14187_;
                                                            if _e4444 {
                                                                let _e4445 = f64(0f);
                                                                let _e4446 = f64(1f);
                                                                phi_14197_ = type_38(array<f64, 4>(_e4445, _e4445, _e4445, _e4445), array<f64, 4>(_e4445, _e4445, _e4445, _e4445), array<f64, 4>(_e4446, _e4446, _e4446, _e4446));
                                                            } else {
                                                                phi_14197_ = _e4442;
                                                            }
                                                            let _e4452 = phi_14197_;
                                                            local_1 = type_38(array<f64, 4>(_e4452.member[0], _e4452.member[1], _e4452.member[2], _e4452.member[3]), array<f64, 4>(_e4452.member_1[0], _e4452.member_1[1], _e4452.member_1[2], _e4452.member_1[3]), array<f64, 4>(_e4452.member_2[0], _e4452.member_2[1], _e4452.member_2[2], _e4452.member_2[3]));
                                                            let _e4472 = (_e4139 - _e4145);
                                                            let _e4474 = f64(0f);
                                                            let _e4477 = local_1.member[0u];
                                                            let _e4480 = local_1.member_1[0u];
                                                            let _e4483 = local_1.member[0u];
                                                            let _e4489 = local_1.member_2[0u];
                                                            if (((_e4477 + ((_e4480 - _e4483) * _e4139)) - _e4489) > _e4474) {
                                                                let _e4494 = local_1.member[1u];
                                                                let _e4497 = local_1.member_1[1u];
                                                                let _e4500 = local_1.member[1u];
                                                                let _e4506 = local_1.member_2[1u];
                                                                if (((_e4494 + ((_e4497 - _e4500) * _e4139)) - _e4506) > _e4474) {
                                                                    let _e4511 = local_1.member[2u];
                                                                    let _e4514 = local_1.member_1[2u];
                                                                    let _e4517 = local_1.member[2u];
                                                                    let _e4523 = local_1.member_2[2u];
                                                                    if (((_e4511 + ((_e4514 - _e4517) * _e4139)) - _e4523) > _e4474) {
                                                                        let _e4528 = local_1.member[3u];
                                                                        let _e4531 = local_1.member_1[3u];
                                                                        let _e4534 = local_1.member[3u];
                                                                        let _e4540 = local_1.member_2[3u];
                                                                        phi_14369_ = (((_e4528 + ((_e4531 - _e4534) * _e4139)) - _e4540) > _e4474);
                                                                        phi_14370_ = false;
                                                                    } else {
                                                                        phi_14369_ = bool();
                                                                        phi_14370_ = true;
                                                                    }
                                                                    let _e4544 = phi_14369_;
                                                                    let _e4546 = phi_14370_;
                                                                    phi_14371_ = _e4544;
                                                                    phi_14372_ = _e4546;
                                                                } else {
                                                                    phi_14371_ = bool();
                                                                    phi_14372_ = true;
                                                                }
                                                                let _e4548 = phi_14371_;
                                                                let _e4550 = phi_14372_;
                                                                phi_14373_ = _e4548;
                                                                phi_14374_ = _e4550;
                                                            } else {
                                                                phi_14373_ = bool();
                                                                phi_14374_ = true;
                                                            }
                                                            let _e4552 = phi_14373_;
                                                            let _e4554 = phi_14374_;
                                                            if _e4554 {
                                                                phi_14378_ = false;
                                                            } else {
                                                                phi_14378_ = _e4552;
                                                            }
                                                            let _e4556 = phi_14378_;
                                                            if _e4556 {
                                                                if (_e4139 <= _e4141) {
                                                                    phi_14689_ = true;
                                                                } else {
                                                                    let _e4558 = f64(0f);
                                                                    let _e4561 = local.member[0u];
                                                                    let _e4564 = local.member_1[0u];
                                                                    let _e4567 = local.member[0u];
                                                                    let _e4573 = local.member_2[0u];
                                                                    let _e4577 = local_1.member[0u];
                                                                    let _e4580 = local_1.member_1[0u];
                                                                    let _e4583 = local_1.member[0u];
                                                                    let _e4589 = local_1.member_2[0u];
                                                                    if ((((_e4561 + ((_e4564 - _e4567) * _e4139)) - _e4573) + ((_e4577 + ((_e4580 - _e4583) * _e4145)) - _e4589)) > _e4558) {
                                                                        let _e4595 = local.member[1u];
                                                                        let _e4598 = local.member_1[1u];
                                                                        let _e4601 = local.member[1u];
                                                                        let _e4607 = local.member_2[1u];
                                                                        let _e4611 = local_1.member[1u];
                                                                        let _e4614 = local_1.member_1[1u];
                                                                        let _e4617 = local_1.member[1u];
                                                                        let _e4623 = local_1.member_2[1u];
                                                                        if ((((_e4595 + ((_e4598 - _e4601) * _e4139)) - _e4607) + ((_e4611 + ((_e4614 - _e4617) * _e4145)) - _e4623)) > _e4558) {
                                                                            let _e4629 = local.member[2u];
                                                                            let _e4632 = local.member_1[2u];
                                                                            let _e4635 = local.member[2u];
                                                                            let _e4641 = local.member_2[2u];
                                                                            let _e4645 = local_1.member[2u];
                                                                            let _e4648 = local_1.member_1[2u];
                                                                            let _e4651 = local_1.member[2u];
                                                                            let _e4657 = local_1.member_2[2u];
                                                                            if ((((_e4629 + ((_e4632 - _e4635) * _e4139)) - _e4641) + ((_e4645 + ((_e4648 - _e4651) * _e4145)) - _e4657)) > _e4558) {
                                                                                let _e4663 = local.member[3u];
                                                                                let _e4666 = local.member_1[3u];
                                                                                let _e4669 = local.member[3u];
                                                                                let _e4675 = local.member_2[3u];
                                                                                let _e4679 = local_1.member[3u];
                                                                                let _e4682 = local_1.member_1[3u];
                                                                                let _e4685 = local_1.member[3u];
                                                                                let _e4691 = local_1.member_2[3u];
                                                                                phi_14676_ = ((((_e4663 + ((_e4666 - _e4669) * _e4139)) - _e4675) + ((_e4679 + ((_e4682 - _e4685) * _e4145)) - _e4691)) > _e4558);
                                                                                phi_14677_ = false;
                                                                            } else {
                                                                                phi_14676_ = bool();
                                                                                phi_14677_ = true;
                                                                            }
                                                                            let _e4696 = phi_14676_;
                                                                            let _e4698 = phi_14677_;
                                                                            phi_14678_ = _e4696;
                                                                            phi_14679_ = _e4698;
                                                                        } else {
                                                                            phi_14678_ = bool();
                                                                            phi_14679_ = true;
                                                                        }
                                                                        let _e4700 = phi_14678_;
                                                                        let _e4702 = phi_14679_;
                                                                        phi_14680_ = _e4700;
                                                                        phi_14681_ = _e4702;
                                                                    } else {
                                                                        phi_14680_ = bool();
                                                                        phi_14681_ = true;
                                                                    }
                                                                    let _e4704 = phi_14680_;
                                                                    let _e4706 = phi_14681_;
                                                                    if _e4706 {
                                                                        phi_14685_ = false;
                                                                    } else {
                                                                        phi_14685_ = _e4704;
                                                                    }
                                                                    let _e4708 = phi_14685_;
                                                                    phi_14689_ = _e4708;
                                                                }
                                                                let _e4710 = phi_14689_;
                                                                if _e4710 {
                                                                    if _e4147 {
                                                                        if (_e4139 >= _e3163.member_1) {
                                                                            phi_14700_ = false;
                                                                        } else {
                                                                            phi_14700_ = true;
                                                                        }
                                                                        let _e4713 = phi_14700_;
                                                                        phi_14701_ = _e4713;
                                                                    } else {
                                                                        phi_14701_ = true;
                                                                    }
                                                                    let _e4715 = phi_14701_;
                                                                    if _e4715 {
                                                                        local = type_38(array<f64, 4>(_e4452.member[0], _e4452.member[1], _e4452.member[2], _e4452.member[3]), array<f64, 4>(_e4452.member_1[0], _e4452.member_1[1], _e4452.member_1[2], _e4452.member_1[3]), array<f64, 4>(_e4452.member_2[0], _e4452.member_2[1], _e4452.member_2[2], _e4452.member_2[3]));
                                                                        let _e4737 = local.member[0u];
                                                                        let _e4740 = local.member_1[0u];
                                                                        let _e4743 = local.member_2[0u];
                                                                        if (_e4737 > _e4743) {
                                                                            if (_e4740 > _e4743) {
                                                                                phi_14775_ = false;
                                                                            } else {
                                                                                phi_14775_ = true;
                                                                            }
                                                                            let _e4747 = phi_14775_;
                                                                            phi_14776_ = _e4747;
                                                                        } else {
                                                                            phi_14776_ = true;
                                                                        }
                                                                        let _e4749 = phi_14776_;
                                                                        if _e4749 {
                                                                            let _e4750 = (_e4740 >= _e4737);
                                                                            if _e4750 {
                                                                                phi_14801_ = f64();
                                                                                phi_14802_ = false;
                                                                            } else {
                                                                                if ((_e4737 - _e4740) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14799_ = (((_e4737 - _e4743) / (_e4737 - _e4740)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14800_ = false;
                                                                                } else {
                                                                                    phi_14799_ = f64();
                                                                                    phi_14800_ = true;
                                                                                }
                                                                                let _e4764 = phi_14799_;
                                                                                let _e4766 = phi_14800_;
                                                                                phi_14801_ = _e4764;
                                                                                phi_14802_ = _e4766;
                                                                            }
                                                                            let _e4768 = phi_14801_;
                                                                            let _e4770 = phi_14802_;
                                                                            phi_14803_ = _e4768;
                                                                            phi_14804_ = _e4750;
                                                                            phi_14805_ = _e4770;
                                                                        } else {
                                                                            phi_14803_ = f64();
                                                                            phi_14804_ = true;
                                                                            phi_14805_ = false;
                                                                        }
                                                                        let _e4772 = phi_14803_;
                                                                        let _e4774 = phi_14804_;
                                                                        let _e4776 = phi_14805_;
                                                                        if _e4774 {
                                                                            phi_14810_ = f64(2f);
                                                                            phi_14811_ = true;
                                                                        } else {
                                                                            phi_14810_ = _e4139;
                                                                            phi_14811_ = _e4776;
                                                                        }
                                                                        let _e4779 = phi_14810_;
                                                                        let _e4781 = phi_14811_;
                                                                        if _e4781 {
                                                                            phi_14815_ = _e4779;
                                                                        } else {
                                                                            phi_14815_ = _e4772;
                                                                        }
                                                                        let _e4783 = phi_14815_;
                                                                        let _e4786 = local.member[1u];
                                                                        let _e4789 = local.member_1[1u];
                                                                        let _e4792 = local.member_2[1u];
                                                                        if (_e4786 > _e4792) {
                                                                            if (_e4789 > _e4792) {
                                                                                phi_14847_ = false;
                                                                            } else {
                                                                                phi_14847_ = true;
                                                                            }
                                                                            let _e4796 = phi_14847_;
                                                                            phi_14848_ = _e4796;
                                                                        } else {
                                                                            phi_14848_ = true;
                                                                        }
                                                                        let _e4798 = phi_14848_;
                                                                        if _e4798 {
                                                                            let _e4799 = (_e4789 >= _e4786);
                                                                            if _e4799 {
                                                                                phi_14873_ = f64();
                                                                                phi_14874_ = false;
                                                                            } else {
                                                                                if ((_e4786 - _e4789) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14871_ = (((_e4786 - _e4792) / (_e4786 - _e4789)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14872_ = false;
                                                                                } else {
                                                                                    phi_14871_ = f64();
                                                                                    phi_14872_ = true;
                                                                                }
                                                                                let _e4813 = phi_14871_;
                                                                                let _e4815 = phi_14872_;
                                                                                phi_14873_ = _e4813;
                                                                                phi_14874_ = _e4815;
                                                                            }
                                                                            let _e4817 = phi_14873_;
                                                                            let _e4819 = phi_14874_;
                                                                            phi_14875_ = _e4817;
                                                                            phi_14876_ = _e4799;
                                                                            phi_14877_ = _e4819;
                                                                        } else {
                                                                            phi_14875_ = f64();
                                                                            phi_14876_ = true;
                                                                            phi_14877_ = false;
                                                                        }
                                                                        let _e4821 = phi_14875_;
                                                                        let _e4823 = phi_14876_;
                                                                        let _e4825 = phi_14877_;
                                                                        if _e4823 {
                                                                            phi_14882_ = f64(2f);
                                                                            phi_14883_ = true;
                                                                        } else {
                                                                            phi_14882_ = _e4139;
                                                                            phi_14883_ = _e4825;
                                                                        }
                                                                        let _e4828 = phi_14882_;
                                                                        let _e4830 = phi_14883_;
                                                                        if _e4830 {
                                                                            phi_14887_ = _e4828;
                                                                        } else {
                                                                            phi_14887_ = _e4821;
                                                                        }
                                                                        let _e4832 = phi_14887_;
                                                                        if (_e4783 < _e4832) {
                                                                            phi_14892_ = _e4783;
                                                                        } else {
                                                                            phi_14892_ = _e4832;
                                                                        }
                                                                        let _e4835 = phi_14892_;
                                                                        let _e4838 = local.member[2u];
                                                                        let _e4841 = local.member_1[2u];
                                                                        let _e4844 = local.member_2[2u];
                                                                        if (_e4838 > _e4844) {
                                                                            if (_e4841 > _e4844) {
                                                                                phi_14924_ = false;
                                                                            } else {
                                                                                phi_14924_ = true;
                                                                            }
                                                                            let _e4848 = phi_14924_;
                                                                            phi_14925_ = _e4848;
                                                                        } else {
                                                                            phi_14925_ = true;
                                                                        }
                                                                        let _e4850 = phi_14925_;
                                                                        if _e4850 {
                                                                            let _e4851 = (_e4841 >= _e4838);
                                                                            if _e4851 {
                                                                                phi_14950_ = f64();
                                                                                phi_14951_ = false;
                                                                            } else {
                                                                                if ((_e4838 - _e4841) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14948_ = (((_e4838 - _e4844) / (_e4838 - _e4841)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14949_ = false;
                                                                                } else {
                                                                                    phi_14948_ = f64();
                                                                                    phi_14949_ = true;
                                                                                }
                                                                                let _e4865 = phi_14948_;
                                                                                let _e4867 = phi_14949_;
                                                                                phi_14950_ = _e4865;
                                                                                phi_14951_ = _e4867;
                                                                            }
                                                                            let _e4869 = phi_14950_;
                                                                            let _e4871 = phi_14951_;
                                                                            phi_14952_ = _e4869;
                                                                            phi_14953_ = _e4851;
                                                                            phi_14954_ = _e4871;
                                                                        } else {
                                                                            phi_14952_ = f64();
                                                                            phi_14953_ = true;
                                                                            phi_14954_ = false;
                                                                        }
                                                                        let _e4873 = phi_14952_;
                                                                        let _e4875 = phi_14953_;
                                                                        let _e4877 = phi_14954_;
                                                                        if _e4875 {
                                                                            phi_14959_ = f64(2f);
                                                                            phi_14960_ = true;
                                                                        } else {
                                                                            phi_14959_ = _e4139;
                                                                            phi_14960_ = _e4877;
                                                                        }
                                                                        let _e4880 = phi_14959_;
                                                                        let _e4882 = phi_14960_;
                                                                        if _e4882 {
                                                                            phi_14964_ = _e4880;
                                                                        } else {
                                                                            phi_14964_ = _e4873;
                                                                        }
                                                                        let _e4884 = phi_14964_;
                                                                        let _e4887 = local.member[3u];
                                                                        let _e4890 = local.member_1[3u];
                                                                        let _e4893 = local.member_2[3u];
                                                                        if (_e4887 > _e4893) {
                                                                            if (_e4890 > _e4893) {
                                                                                phi_14996_ = false;
                                                                            } else {
                                                                                phi_14996_ = true;
                                                                            }
                                                                            let _e4897 = phi_14996_;
                                                                            phi_14997_ = _e4897;
                                                                        } else {
                                                                            phi_14997_ = true;
                                                                        }
                                                                        let _e4899 = phi_14997_;
                                                                        if _e4899 {
                                                                            let _e4900 = (_e4890 >= _e4887);
                                                                            if _e4900 {
                                                                                phi_15022_ = f64();
                                                                                phi_15023_ = false;
                                                                            } else {
                                                                                if ((_e4887 - _e4890) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_15020_ = (((_e4887 - _e4893) / (_e4887 - _e4890)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_15021_ = false;
                                                                                } else {
                                                                                    phi_15020_ = f64();
                                                                                    phi_15021_ = true;
                                                                                }
                                                                                let _e4914 = phi_15020_;
                                                                                let _e4916 = phi_15021_;
                                                                                phi_15022_ = _e4914;
                                                                                phi_15023_ = _e4916;
                                                                            }
                                                                            let _e4918 = phi_15022_;
                                                                            let _e4920 = phi_15023_;
                                                                            phi_15024_ = _e4918;
                                                                            phi_15025_ = _e4900;
                                                                            phi_15026_ = _e4920;
                                                                        } else {
                                                                            phi_15024_ = f64();
                                                                            phi_15025_ = true;
                                                                            phi_15026_ = false;
                                                                        }
                                                                        let _e4922 = phi_15024_;
                                                                        let _e4924 = phi_15025_;
                                                                        let _e4926 = phi_15026_;
                                                                        if _e4924 {
                                                                            phi_15031_ = f64(2f);
                                                                            phi_15032_ = true;
                                                                        } else {
                                                                            phi_15031_ = _e4139;
                                                                            phi_15032_ = _e4926;
                                                                        }
                                                                        let _e4929 = phi_15031_;
                                                                        let _e4931 = phi_15032_;
                                                                        if _e4931 {
                                                                            phi_15036_ = _e4929;
                                                                        } else {
                                                                            phi_15036_ = _e4922;
                                                                        }
                                                                        let _e4933 = phi_15036_;
                                                                        if (_e4884 < _e4933) {
                                                                            phi_15041_ = _e4884;
                                                                        } else {
                                                                            phi_15041_ = _e4933;
                                                                        }
                                                                        let _e4936 = phi_15041_;
                                                                        if (_e4835 < _e4936) {
                                                                            phi_15046_ = _e4835;
                                                                        } else {
                                                                            phi_15046_ = _e4936;
                                                                        }
                                                                        let _e4939 = phi_15046_;
                                                                        if (_e4939 > _e4139) {
                                                                            phi_15051_ = _e4939;
                                                                        } else {
                                                                            phi_15051_ = _e4139;
                                                                        }
                                                                        let _e4942 = phi_15051_;
                                                                        let _e4943 = (_e4942 > _e3163.member_1);
                                                                        if _e4943 {
                                                                            phi_15568_ = f64();
                                                                            phi_15569_ = f64();
                                                                            phi_15570_ = false;
                                                                            phi_15571_ = false;
                                                                        } else {
                                                                            let _e4944 = (_e4942 - _e4139);
                                                                            let _e4945 = (_e4944 <= _e4128);
                                                                            let _e4948 = (_e4942 + (_e418 * f64(0.01f)));
                                                                            if (_e4948 < _e3163.member_1) {
                                                                                phi_15065_ = _e4948;
                                                                            } else {
                                                                                phi_15065_ = _e3163.member_1;
                                                                            }
                                                                            let _e4951 = phi_15065_;
                                                                            if _e4945 {
                                                                                if (_e683 > f64(0f)) {
                                                                                    let _e4956 = local_18.member[0u];
                                                                                    let _e4962 = local_18.member[1u];
                                                                                    let _e4978 = local_18.member_1[0u];
                                                                                    let _e4984 = local_18.member_1[1u];
                                                                                    let _e5000 = local_18.member_2[0u];
                                                                                    let _e5006 = local_18.member_2[1u];
                                                                                    let _e5020 = function_3(array<f64, 3>((_e4956[0] + ((_e4962[0] - _e4956[0]) * _e4951)), (_e4956[1] + ((_e4962[1] - _e4956[1]) * _e4951)), (_e4956[2] + ((_e4962[2] - _e4956[2]) * _e4951))), array<f64, 3>((_e4978[0] + ((_e4984[0] - _e4978[0]) * _e4951)), (_e4978[1] + ((_e4984[1] - _e4978[1]) * _e4951)), (_e4978[2] + ((_e4984[2] - _e4978[2]) * _e4951))), array<f64, 3>((_e5000[0] + ((_e5006[0] - _e5000[0]) * _e4951)), (_e5000[1] + ((_e5006[1] - _e5000[1]) * _e4951)), (_e5000[2] + ((_e5006[2] - _e5000[2]) * _e4951))), 0u);
                                                                                    let _e5031 = (((_e5020[0] * _e5020[0]) + (_e5020[1] * _e5020[1])) + (_e5020[2] * _e5020[2]));
                                                                                    if (_e5031 <= 2.2250738585072014e-308lf) {
                                                                                        if (_e5031 > 0.0lf) {
                                                                                            phi_15196_ = (1.464336215552873e-154lf * 2.0lf);
                                                                                        } else {
                                                                                            phi_15196_ = 0.0lf;
                                                                                        }
                                                                                        let _e5083 = phi_15196_;
                                                                                        phi_15260_ = _e5083;
                                                                                    } else {
                                                                                        phi_15203_ = type_16(0i, 5i);
                                                                                        phi_15206_ = bitcast<f64>(((bitcast<u64>(_e5031) / 2lu) + 2303426169912950784lu));
                                                                                        loop {
                                                                                            let _e5038 = phi_15203_;
                                                                                            let _e5040 = phi_15206_;
                                                                                            local_29 = _e5040;
                                                                                            if (_e5038.member < _e5038.member_1) {
                                                                                                let _e5047 = (_e5038.member + 1i);
                                                                                                if ((false == (_e5047 > _e5038.member)) != false) {
                                                                                                    phi_15227_ = true;
                                                                                                } else {
                                                                                                    phi_15227_ = false;
                                                                                                }
                                                                                                let _e5052 = phi_15227_;
                                                                                                if _e5052 {
                                                                                                    phi_15233_ = type_17(0u, type_17().member_1);
                                                                                                } else {
                                                                                                    phi_15233_ = type_17(1u, _e5047);
                                                                                                }
                                                                                                let _e5057 = phi_15233_;
                                                                                                phi_15204_ = type_16(_e5057.member_1, _e5038.member_1);
                                                                                                phi_15247_ = type_17(1u, _e5038.member);
                                                                                            } else {
                                                                                                phi_15204_ = _e5038;
                                                                                                phi_15247_ = type_17(0u, type_17().member_1);
                                                                                            }
                                                                                            let _e5063 = phi_15204_;
                                                                                            let _e5065 = phi_15247_;
                                                                                            let _e5068 = (bitcast<i32>(_e5065.member) != 0i);
                                                                                            if _e5068 {
                                                                                                phi_15207_ = (0.5lf * (_e5040 + (_e5031 / _e5040)));
                                                                                            } else {
                                                                                                phi_15207_ = f64();
                                                                                            }
                                                                                            let _e5073 = phi_15207_;
                                                                                            continue;
                                                                                            continuing {
                                                                                                phi_15203_ = _e5063;
                                                                                                phi_15206_ = _e5073;
                                                                                                break if !(_e5068);
                                                                                            }
                                                                                        }
                                                                                        let _e5078 = local_29;
                                                                                        phi_15260_ = (_e5078 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                                    }
                                                                                    let _e5085 = phi_15260_;
                                                                                    let _e5093 = local_18.member[0u];
                                                                                    if (_e5093[0] < 0.0lf) {
                                                                                        phi_15278_ = -(_e5093[0]);
                                                                                    } else {
                                                                                        phi_15278_ = _e5093[0];
                                                                                    }
                                                                                    let _e5100 = phi_15278_;
                                                                                    if (_e5093[1] < 0.0lf) {
                                                                                        phi_15285_ = -(_e5093[1]);
                                                                                    } else {
                                                                                        phi_15285_ = _e5093[1];
                                                                                    }
                                                                                    let _e5104 = phi_15285_;
                                                                                    if (_e5100 > _e5104) {
                                                                                        phi_15290_ = _e5100;
                                                                                    } else {
                                                                                        phi_15290_ = _e5104;
                                                                                    }
                                                                                    let _e5107 = phi_15290_;
                                                                                    if (_e5093[2] < 0.0lf) {
                                                                                        phi_15297_ = -(_e5093[2]);
                                                                                    } else {
                                                                                        phi_15297_ = _e5093[2];
                                                                                    }
                                                                                    let _e5111 = phi_15297_;
                                                                                    if (_e5107 > _e5111) {
                                                                                        phi_15302_ = _e5107;
                                                                                    } else {
                                                                                        phi_15302_ = _e5111;
                                                                                    }
                                                                                    let _e5114 = phi_15302_;
                                                                                    let _e5117 = local_18.member[1u];
                                                                                    if (_e5117[0] < 0.0lf) {
                                                                                        phi_15315_ = -(_e5117[0]);
                                                                                    } else {
                                                                                        phi_15315_ = _e5117[0];
                                                                                    }
                                                                                    let _e5124 = phi_15315_;
                                                                                    if (_e5117[1] < 0.0lf) {
                                                                                        phi_15322_ = -(_e5117[1]);
                                                                                    } else {
                                                                                        phi_15322_ = _e5117[1];
                                                                                    }
                                                                                    let _e5128 = phi_15322_;
                                                                                    if (_e5124 > _e5128) {
                                                                                        phi_15327_ = _e5124;
                                                                                    } else {
                                                                                        phi_15327_ = _e5128;
                                                                                    }
                                                                                    let _e5131 = phi_15327_;
                                                                                    if (_e5117[2] < 0.0lf) {
                                                                                        phi_15334_ = -(_e5117[2]);
                                                                                    } else {
                                                                                        phi_15334_ = _e5117[2];
                                                                                    }
                                                                                    let _e5135 = phi_15334_;
                                                                                    if (_e5131 > _e5135) {
                                                                                        phi_15339_ = _e5131;
                                                                                    } else {
                                                                                        phi_15339_ = _e5135;
                                                                                    }
                                                                                    let _e5138 = phi_15339_;
                                                                                    if (_e5114 > _e5138) {
                                                                                        phi_15344_ = _e5114;
                                                                                    } else {
                                                                                        phi_15344_ = _e5138;
                                                                                    }
                                                                                    let _e5141 = phi_15344_;
                                                                                    let _e5143 = local_18.member_3;
                                                                                    let _e5147 = local_18.member_1[0u];
                                                                                    if (_e5147[0] < 0.0lf) {
                                                                                        phi_15361_ = -(_e5147[0]);
                                                                                    } else {
                                                                                        phi_15361_ = _e5147[0];
                                                                                    }
                                                                                    let _e5154 = phi_15361_;
                                                                                    if (_e5147[1] < 0.0lf) {
                                                                                        phi_15368_ = -(_e5147[1]);
                                                                                    } else {
                                                                                        phi_15368_ = _e5147[1];
                                                                                    }
                                                                                    let _e5158 = phi_15368_;
                                                                                    if (_e5154 > _e5158) {
                                                                                        phi_15373_ = _e5154;
                                                                                    } else {
                                                                                        phi_15373_ = _e5158;
                                                                                    }
                                                                                    let _e5161 = phi_15373_;
                                                                                    if (_e5147[2] < 0.0lf) {
                                                                                        phi_15380_ = -(_e5147[2]);
                                                                                    } else {
                                                                                        phi_15380_ = _e5147[2];
                                                                                    }
                                                                                    let _e5165 = phi_15380_;
                                                                                    if (_e5161 > _e5165) {
                                                                                        phi_15385_ = _e5161;
                                                                                    } else {
                                                                                        phi_15385_ = _e5165;
                                                                                    }
                                                                                    let _e5168 = phi_15385_;
                                                                                    let _e5171 = local_18.member_1[1u];
                                                                                    if (_e5171[0] < 0.0lf) {
                                                                                        phi_15399_ = -(_e5171[0]);
                                                                                    } else {
                                                                                        phi_15399_ = _e5171[0];
                                                                                    }
                                                                                    let _e5178 = phi_15399_;
                                                                                    if (_e5171[1] < 0.0lf) {
                                                                                        phi_15406_ = -(_e5171[1]);
                                                                                    } else {
                                                                                        phi_15406_ = _e5171[1];
                                                                                    }
                                                                                    let _e5182 = phi_15406_;
                                                                                    if (_e5178 > _e5182) {
                                                                                        phi_15411_ = _e5178;
                                                                                    } else {
                                                                                        phi_15411_ = _e5182;
                                                                                    }
                                                                                    let _e5185 = phi_15411_;
                                                                                    if (_e5171[2] < 0.0lf) {
                                                                                        phi_15418_ = -(_e5171[2]);
                                                                                    } else {
                                                                                        phi_15418_ = _e5171[2];
                                                                                    }
                                                                                    let _e5189 = phi_15418_;
                                                                                    if (_e5185 > _e5189) {
                                                                                        phi_15423_ = _e5185;
                                                                                    } else {
                                                                                        phi_15423_ = _e5189;
                                                                                    }
                                                                                    let _e5192 = phi_15423_;
                                                                                    if (_e5168 > _e5192) {
                                                                                        phi_15428_ = _e5168;
                                                                                    } else {
                                                                                        phi_15428_ = _e5192;
                                                                                    }
                                                                                    let _e5195 = phi_15428_;
                                                                                    let _e5197 = local_18.member_3;
                                                                                    let _e5201 = local_18.member_2[0u];
                                                                                    if (_e5201[0] < 0.0lf) {
                                                                                        phi_15445_ = -(_e5201[0]);
                                                                                    } else {
                                                                                        phi_15445_ = _e5201[0];
                                                                                    }
                                                                                    let _e5208 = phi_15445_;
                                                                                    if (_e5201[1] < 0.0lf) {
                                                                                        phi_15452_ = -(_e5201[1]);
                                                                                    } else {
                                                                                        phi_15452_ = _e5201[1];
                                                                                    }
                                                                                    let _e5212 = phi_15452_;
                                                                                    if (_e5208 > _e5212) {
                                                                                        phi_15457_ = _e5208;
                                                                                    } else {
                                                                                        phi_15457_ = _e5212;
                                                                                    }
                                                                                    let _e5215 = phi_15457_;
                                                                                    if (_e5201[2] < 0.0lf) {
                                                                                        phi_15464_ = -(_e5201[2]);
                                                                                    } else {
                                                                                        phi_15464_ = _e5201[2];
                                                                                    }
                                                                                    let _e5219 = phi_15464_;
                                                                                    if (_e5215 > _e5219) {
                                                                                        phi_15469_ = _e5215;
                                                                                    } else {
                                                                                        phi_15469_ = _e5219;
                                                                                    }
                                                                                    let _e5222 = phi_15469_;
                                                                                    let _e5225 = local_18.member_2[1u];
                                                                                    if (_e5225[0] < 0.0lf) {
                                                                                        phi_15483_ = -(_e5225[0]);
                                                                                    } else {
                                                                                        phi_15483_ = _e5225[0];
                                                                                    }
                                                                                    let _e5232 = phi_15483_;
                                                                                    if (_e5225[1] < 0.0lf) {
                                                                                        phi_15490_ = -(_e5225[1]);
                                                                                    } else {
                                                                                        phi_15490_ = _e5225[1];
                                                                                    }
                                                                                    let _e5236 = phi_15490_;
                                                                                    if (_e5232 > _e5236) {
                                                                                        phi_15495_ = _e5232;
                                                                                    } else {
                                                                                        phi_15495_ = _e5236;
                                                                                    }
                                                                                    let _e5239 = phi_15495_;
                                                                                    if (_e5225[2] < 0.0lf) {
                                                                                        phi_15502_ = -(_e5225[2]);
                                                                                    } else {
                                                                                        phi_15502_ = _e5225[2];
                                                                                    }
                                                                                    let _e5243 = phi_15502_;
                                                                                    if (_e5239 > _e5243) {
                                                                                        phi_15507_ = _e5239;
                                                                                    } else {
                                                                                        phi_15507_ = _e5243;
                                                                                    }
                                                                                    let _e5246 = phi_15507_;
                                                                                    if (_e5222 > _e5246) {
                                                                                        phi_15512_ = _e5222;
                                                                                    } else {
                                                                                        phi_15512_ = _e5246;
                                                                                    }
                                                                                    let _e5249 = phi_15512_;
                                                                                    let _e5251 = local_18.member_3;
                                                                                    let _e5259 = local_18.member_3;
                                                                                    if (((_e5085 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5141 + _e5143) + (_e5195 + _e5197)) + (_e5249 + _e5251)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5259 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e683) {
                                                                                        phi_15536_ = false;
                                                                                    } else {
                                                                                        phi_15536_ = true;
                                                                                    }
                                                                                    let _e5271 = phi_15536_;
                                                                                    phi_15537_ = _e5271;
                                                                                } else {
                                                                                    phi_15537_ = true;
                                                                                }
                                                                                let _e5273 = phi_15537_;
                                                                                phi_15538_ = _e5273;
                                                                            } else {
                                                                                phi_15538_ = true;
                                                                            }
                                                                            let _e5275 = phi_15538_;
                                                                            if _e5275 {
                                                                                if _e4147 {
                                                                                    if _e4945 {
                                                                                        phi_15557_ = f64();
                                                                                        phi_15558_ = true;
                                                                                    } else {
                                                                                        if (_e4944 <= (_e4143 * f64(0.25f))) {
                                                                                            phi_15555_ = f64(0f);
                                                                                            phi_15556_ = false;
                                                                                        } else {
                                                                                            phi_15555_ = f64();
                                                                                            phi_15556_ = true;
                                                                                        }
                                                                                        let _e5282 = phi_15555_;
                                                                                        let _e5284 = phi_15556_;
                                                                                        phi_15557_ = _e5282;
                                                                                        phi_15558_ = _e5284;
                                                                                    }
                                                                                    let _e5286 = phi_15557_;
                                                                                    let _e5288 = phi_15558_;
                                                                                    if _e5288 {
                                                                                        phi_15563_ = (_e4472 + _e4472);
                                                                                    } else {
                                                                                        phi_15563_ = _e5286;
                                                                                    }
                                                                                    let _e5291 = phi_15563_;
                                                                                    phi_15565_ = _e5291;
                                                                                } else {
                                                                                    phi_15565_ = (_e3163.member_1 - _e4139);
                                                                                }
                                                                                let _e5293 = phi_15565_;
                                                                                phi_15566_ = _e5293;
                                                                                phi_15567_ = false;
                                                                            } else {
                                                                                phi_15566_ = f64();
                                                                                phi_15567_ = true;
                                                                            }
                                                                            let _e5295 = phi_15566_;
                                                                            let _e5297 = phi_15567_;
                                                                            phi_15568_ = _e5295;
                                                                            phi_15569_ = _e4944;
                                                                            phi_15570_ = _e5275;
                                                                            phi_15571_ = _e5297;
                                                                        }
                                                                        let _e5299 = phi_15568_;
                                                                        let _e5301 = phi_15569_;
                                                                        let _e5303 = phi_15570_;
                                                                        let _e5305 = phi_15571_;
                                                                        phi_15572_ = _e4942;
                                                                        phi_15573_ = _e5299;
                                                                        phi_15574_ = _e5301;
                                                                        phi_15575_ = _e4942;
                                                                        phi_15576_ = _e5303;
                                                                        phi_15577_ = _e4943;
                                                                        phi_15578_ = _e5305;
                                                                        phi_15579_ = false;
                                                                    } else {
                                                                        phi_15572_ = f64();
                                                                        phi_15573_ = f64();
                                                                        phi_15574_ = f64();
                                                                        phi_15575_ = f64();
                                                                        phi_15576_ = false;
                                                                        phi_15577_ = false;
                                                                        phi_15578_ = false;
                                                                        phi_15579_ = true;
                                                                    }
                                                                    let _e5307 = phi_15572_;
                                                                    let _e5309 = phi_15573_;
                                                                    let _e5311 = phi_15574_;
                                                                    let _e5313 = phi_15575_;
                                                                    let _e5315 = phi_15576_;
                                                                    let _e5317 = phi_15577_;
                                                                    let _e5319 = phi_15578_;
                                                                    let _e5321 = phi_15579_;
                                                                    phi_15580_ = _e5307;
                                                                    phi_15581_ = _e5309;
                                                                    phi_15582_ = _e5311;
                                                                    phi_15583_ = _e5313;
                                                                    phi_15584_ = false;
                                                                    phi_15585_ = _e5315;
                                                                    phi_15586_ = _e5317;
                                                                    phi_15587_ = _e5319;
                                                                    phi_15588_ = _e5321;
                                                                } else {
                                                                    phi_15580_ = f64();
                                                                    phi_15581_ = f64();
                                                                    phi_15582_ = f64();
                                                                    phi_15583_ = f64();
                                                                    phi_15584_ = true;
                                                                    phi_15585_ = false;
                                                                    phi_15586_ = false;
                                                                    phi_15587_ = false;
                                                                    phi_15588_ = false;
                                                                }
                                                                let _e5323 = phi_15580_;
                                                                let _e5325 = phi_15581_;
                                                                let _e5327 = phi_15582_;
                                                                let _e5329 = phi_15583_;
                                                                let _e5331 = phi_15584_;
                                                                let _e5333 = phi_15585_;
                                                                let _e5335 = phi_15586_;
                                                                let _e5337 = phi_15587_;
                                                                let _e5339 = phi_15588_;
                                                                phi_15589_ = _e5323;
                                                                phi_15590_ = _e5325;
                                                                phi_15591_ = _e5327;
                                                                phi_15592_ = _e5329;
                                                                phi_15593_ = _e5331;
                                                                phi_15594_ = _e5333;
                                                                phi_15595_ = _e5335;
                                                                phi_15596_ = _e5337;
                                                                phi_15597_ = _e5339;
                                                            } else {
                                                                phi_15589_ = f64();
                                                                phi_15590_ = f64();
                                                                phi_15591_ = f64();
                                                                phi_15592_ = f64();
                                                                phi_15593_ = true;
                                                                phi_15594_ = false;
                                                                phi_15595_ = false;
                                                                phi_15596_ = false;
                                                                phi_15597_ = false;
                                                            }
                                                            let _e5341 = phi_15589_;
                                                            let _e5343 = phi_15590_;
                                                            let _e5345 = phi_15591_;
                                                            let _e5347 = phi_15592_;
                                                            let _e5349 = phi_15593_;
                                                            let _e5351 = phi_15594_;
                                                            let _e5353 = phi_15595_;
                                                            let _e5355 = phi_15596_;
                                                            let _e5357 = phi_15597_;
                                                            if _e5349 {
                                                                if (_e4139 <= _e4141) {
                                                                    let _e5523 = (_e4149 + 1u);
                                                                    let _e5524 = (_e5523 > 3u);
                                                                    if _e5524 {
                                                                        phi_15610_ = false;
                                                                    } else {
                                                                        phi_15610_ = true;
                                                                    }
                                                                    let _e5526 = phi_15610_;
                                                                    phi_15937_ = _e5523;
                                                                    phi_15938_ = f64();
                                                                    phi_15939_ = false;
                                                                    phi_15940_ = _e5526;
                                                                    phi_15941_ = _e5524;
                                                                } else {
                                                                    let _e5361 = local.member[0u];
                                                                    let _e5364 = local.member_1[0u];
                                                                    let _e5367 = local.member[0u];
                                                                    let _e5373 = local.member_2[0u];
                                                                    let _e5374 = ((_e5361 + ((_e5364 - _e5367) * _e4145)) - _e5373);
                                                                    let _e5377 = local.member[1u];
                                                                    let _e5380 = local.member_1[1u];
                                                                    let _e5383 = local.member[1u];
                                                                    let _e5389 = local.member_2[1u];
                                                                    let _e5390 = ((_e5377 + ((_e5380 - _e5383) * _e4145)) - _e5389);
                                                                    if (_e5374 < _e5390) {
                                                                        phi_15683_ = _e5374;
                                                                    } else {
                                                                        phi_15683_ = _e5390;
                                                                    }
                                                                    let _e5393 = phi_15683_;
                                                                    let _e5396 = local.member[2u];
                                                                    let _e5399 = local.member_1[2u];
                                                                    let _e5402 = local.member[2u];
                                                                    let _e5408 = local.member_2[2u];
                                                                    let _e5409 = ((_e5396 + ((_e5399 - _e5402) * _e4145)) - _e5408);
                                                                    let _e5412 = local.member[3u];
                                                                    let _e5415 = local.member_1[3u];
                                                                    let _e5418 = local.member[3u];
                                                                    let _e5424 = local.member_2[3u];
                                                                    let _e5425 = ((_e5412 + ((_e5415 - _e5418) * _e4145)) - _e5424);
                                                                    if (_e5409 < _e5425) {
                                                                        phi_15756_ = _e5409;
                                                                    } else {
                                                                        phi_15756_ = _e5425;
                                                                    }
                                                                    let _e5428 = phi_15756_;
                                                                    if (_e5393 < _e5428) {
                                                                        phi_15761_ = _e5393;
                                                                    } else {
                                                                        phi_15761_ = _e5428;
                                                                    }
                                                                    let _e5431 = phi_15761_;
                                                                    let _e5434 = local_1.member[0u];
                                                                    let _e5437 = local_1.member_1[0u];
                                                                    let _e5440 = local_1.member[0u];
                                                                    let _e5446 = local_1.member_2[0u];
                                                                    let _e5447 = ((_e5434 + ((_e5437 - _e5440) * _e4139)) - _e5446);
                                                                    let _e5450 = local_1.member[1u];
                                                                    let _e5453 = local_1.member_1[1u];
                                                                    let _e5456 = local_1.member[1u];
                                                                    let _e5462 = local_1.member_2[1u];
                                                                    let _e5463 = ((_e5450 + ((_e5453 - _e5456) * _e4139)) - _e5462);
                                                                    if (_e5447 < _e5463) {
                                                                        phi_15834_ = _e5447;
                                                                    } else {
                                                                        phi_15834_ = _e5463;
                                                                    }
                                                                    let _e5466 = phi_15834_;
                                                                    let _e5469 = local_1.member[2u];
                                                                    let _e5472 = local_1.member_1[2u];
                                                                    let _e5475 = local_1.member[2u];
                                                                    let _e5481 = local_1.member_2[2u];
                                                                    let _e5482 = ((_e5469 + ((_e5472 - _e5475) * _e4139)) - _e5481);
                                                                    let _e5485 = local_1.member[3u];
                                                                    let _e5488 = local_1.member_1[3u];
                                                                    let _e5491 = local_1.member[3u];
                                                                    let _e5497 = local_1.member_2[3u];
                                                                    let _e5498 = ((_e5485 + ((_e5488 - _e5491) * _e4139)) - _e5497);
                                                                    if (_e5482 < _e5498) {
                                                                        phi_15907_ = _e5482;
                                                                    } else {
                                                                        phi_15907_ = _e5498;
                                                                    }
                                                                    let _e5501 = phi_15907_;
                                                                    if (_e5466 < _e5501) {
                                                                        phi_15912_ = _e5466;
                                                                    } else {
                                                                        phi_15912_ = _e5501;
                                                                    }
                                                                    let _e5504 = phi_15912_;
                                                                    let _e5505 = f64(0.0625f);
                                                                    let _e5507 = f64(0.9f);
                                                                    if (_e5504 > f64(0f)) {
                                                                        phi_15935_ = f64(0.5f);
                                                                    } else {
                                                                        let _e5513 = (f64(0.95f) * (_e5431 / (_e5431 - _e5504)));
                                                                        if (_e5513 > _e5505) {
                                                                            if (_e5513 < _e5507) {
                                                                                phi_15933_ = _e5513;
                                                                            } else {
                                                                                phi_15933_ = _e5507;
                                                                            }
                                                                            let _e5517 = phi_15933_;
                                                                            phi_15934_ = _e5517;
                                                                        } else {
                                                                            phi_15934_ = _e5505;
                                                                        }
                                                                        let _e5519 = phi_15934_;
                                                                        phi_15935_ = _e5519;
                                                                    }
                                                                    let _e5521 = phi_15935_;
                                                                    phi_15937_ = u32();
                                                                    phi_15938_ = (_e4472 * _e5521);
                                                                    phi_15939_ = true;
                                                                    phi_15940_ = false;
                                                                    phi_15941_ = false;
                                                                }
                                                                let _e5528 = phi_15937_;
                                                                let _e5530 = phi_15938_;
                                                                let _e5532 = phi_15939_;
                                                                let _e5534 = phi_15940_;
                                                                let _e5536 = phi_15941_;
                                                                phi_15942_ = _e5528;
                                                                phi_15943_ = _e4141;
                                                                phi_15944_ = _e5530;
                                                                phi_15945_ = _e4143;
                                                                phi_15946_ = _e4145;
                                                                phi_15947_ = _e4147;
                                                                phi_15948_ = _e4149;
                                                                phi_15949_ = _e5532;
                                                                phi_15950_ = _e5534;
                                                                phi_15951_ = _e5536;
                                                                phi_15952_ = false;
                                                                phi_15953_ = false;
                                                                phi_15954_ = false;
                                                            } else {
                                                                phi_15942_ = u32();
                                                                phi_15943_ = _e5341;
                                                                phi_15944_ = _e5343;
                                                                phi_15945_ = _e5345;
                                                                phi_15946_ = _e4139;
                                                                phi_15947_ = true;
                                                                phi_15948_ = 0u;
                                                                phi_15949_ = _e5351;
                                                                phi_15950_ = false;
                                                                phi_15951_ = false;
                                                                phi_15952_ = _e5353;
                                                                phi_15953_ = _e5355;
                                                                phi_15954_ = _e5357;
                                                            }
                                                            let _e5538 = phi_15942_;
                                                            let _e5540 = phi_15943_;
                                                            let _e5542 = phi_15944_;
                                                            let _e5544 = phi_15945_;
                                                            let _e5546 = phi_15946_;
                                                            let _e5548 = phi_15947_;
                                                            let _e5550 = phi_15948_;
                                                            let _e5552 = phi_15949_;
                                                            let _e5554 = phi_15950_;
                                                            let _e5556 = phi_15951_;
                                                            let _e5558 = phi_15952_;
                                                            let _e5560 = phi_15953_;
                                                            let _e5562 = phi_15954_;
                                                            if _e5552 {
                                                                let _e5563 = (_e5546 + _e5542);
                                                                if (_e5563 > _e5540) {
                                                                    phi_15963_ = _e5563;
                                                                } else {
                                                                    phi_15963_ = _e5540;
                                                                }
                                                                let _e5566 = phi_15963_;
                                                                if (_e5566 < _e3163.member_1) {
                                                                    phi_15968_ = _e5566;
                                                                } else {
                                                                    phi_15968_ = _e3163.member_1;
                                                                }
                                                                let _e5569 = phi_15968_;
                                                                if !(_e4147) {
                                                                    phi_15977_ = true;
                                                                } else {
                                                                    phi_15977_ = ((_e5569 - _e5546) > _e4128);
                                                                }
                                                                let _e5573 = phi_15977_;
                                                                if _e5573 {
                                                                    phi_15981_ = false;
                                                                } else {
                                                                    phi_15981_ = true;
                                                                }
                                                                let _e5575 = phi_15981_;
                                                                phi_15982_ = _e5569;
                                                                phi_15983_ = _e5540;
                                                                phi_15984_ = _e5544;
                                                                phi_15985_ = _e5546;
                                                                phi_15986_ = _e5548;
                                                                phi_15987_ = _e5550;
                                                                phi_15988_ = _e5573;
                                                                phi_15989_ = _e5575;
                                                                phi_15990_ = false;
                                                                phi_15991_ = false;
                                                                phi_15992_ = false;
                                                                phi_15993_ = false;
                                                            } else {
                                                                phi_15982_ = _e4139;
                                                                phi_15983_ = _e4141;
                                                                phi_15984_ = _e4143;
                                                                phi_15985_ = _e4145;
                                                                phi_15986_ = _e4147;
                                                                phi_15987_ = _e5538;
                                                                phi_15988_ = _e5554;
                                                                phi_15989_ = false;
                                                                phi_15990_ = _e5556;
                                                                phi_15991_ = _e5558;
                                                                phi_15992_ = _e5560;
                                                                phi_15993_ = _e5562;
                                                            }
                                                            let _e5577 = phi_15982_;
                                                            let _e5579 = phi_15983_;
                                                            let _e5581 = phi_15984_;
                                                            let _e5583 = phi_15985_;
                                                            let _e5585 = phi_15986_;
                                                            let _e5587 = phi_15987_;
                                                            let _e5589 = phi_15988_;
                                                            let _e5591 = phi_15989_;
                                                            let _e5593 = phi_15990_;
                                                            let _e5595 = phi_15991_;
                                                            let _e5597 = phi_15992_;
                                                            let _e5599 = phi_15993_;
                                                            phi_13772_ = _e5577;
                                                            phi_13774_ = _e5579;
                                                            phi_13776_ = _e5581;
                                                            phi_13778_ = _e5583;
                                                            phi_13780_ = _e5585;
                                                            phi_13782_ = _e5587;
                                                            phi_15994_ = _e5540;
                                                            phi_15995_ = _e5347;
                                                            phi_15996_ = _e5589;
                                                            phi_15997_ = _e5591;
                                                            phi_15998_ = _e5593;
                                                            phi_15999_ = _e5595;
                                                            phi_16000_ = _e5597;
                                                            phi_16001_ = false;
                                                            phi_16002_ = _e5599;
                                                        } else {
                                                            phi_13772_ = f64();
                                                            phi_13774_ = f64();
                                                            phi_13776_ = f64();
                                                            phi_13778_ = f64();
                                                            phi_13780_ = bool();
                                                            phi_13782_ = u32();
                                                            phi_15994_ = f64();
                                                            phi_15995_ = f64();
                                                            phi_15996_ = false;
                                                            phi_15997_ = false;
                                                            phi_15998_ = false;
                                                            phi_15999_ = false;
                                                            phi_16000_ = false;
                                                            phi_16001_ = true;
                                                            phi_16002_ = false;
                                                        }
                                                        let _e5601 = phi_13772_;
                                                        let _e5603 = phi_13774_;
                                                        let _e5605 = phi_13776_;
                                                        let _e5607 = phi_13778_;
                                                        let _e5609 = phi_13780_;
                                                        let _e5611 = phi_13782_;
                                                        let _e5613 = phi_15994_;
                                                        let _e5615 = phi_15995_;
                                                        let _e5617 = phi_15996_;
                                                        let _e5619 = phi_15997_;
                                                        let _e5621 = phi_15998_;
                                                        let _e5623 = phi_15999_;
                                                        let _e5625 = phi_16000_;
                                                        let _e5627 = phi_16001_;
                                                        let _e5629 = phi_16002_;
                                                        local_30 = _e5619;
                                                        local_70 = _e5621;
                                                        local_71 = _e5623;
                                                        local_72 = _e5625;
                                                        local_73 = _e5627;
                                                        local_74 = _e5629;
                                                        local_75 = _e5619;
                                                        local_76 = _e5615;
                                                        local_77 = _e5613;
                                                        continue;
                                                        continuing {
                                                            phi_13768_ = _e4161;
                                                            phi_13771_ = _e5601;
                                                            phi_13773_ = _e5603;
                                                            phi_13775_ = _e5605;
                                                            phi_13777_ = _e5607;
                                                            phi_13779_ = _e5609;
                                                            phi_13781_ = _e5611;
                                                            break if !(_e5617);
                                                        }
                                                    }
                                                    let _e5632 = local_30;
                                                    if _e5632 {
                                                        phi_16006_ = false;
                                                        phi_16007_ = false;
                                                        phi_16008_ = false;
                                                        phi_16009_ = false;
                                                        phi_16010_ = false;
                                                    } else {
                                                        let _e11360 = local_70;
                                                        phi_16006_ = _e11360;
                                                        let _e11363 = local_71;
                                                        phi_16007_ = _e11363;
                                                        let _e11366 = local_72;
                                                        phi_16008_ = _e11366;
                                                        let _e11369 = local_73;
                                                        phi_16009_ = _e11369;
                                                        let _e11372 = local_74;
                                                        phi_16010_ = _e11372;
                                                    }
                                                    let _e5634 = phi_16006_;
                                                    let _e5636 = phi_16007_;
                                                    let _e5638 = phi_16008_;
                                                    let _e5640 = phi_16009_;
                                                    let _e5642 = phi_16010_;
                                                    if _e5634 {
                                                        let _e5644 = local_31;
                                                        phi_16015_ = type_46(1u, _e5644);
                                                        phi_16016_ = false;
                                                        phi_16017_ = false;
                                                        phi_16018_ = false;
                                                        phi_16019_ = false;
                                                        phi_16020_ = false;
                                                    } else {
                                                        phi_16015_ = type_46();
                                                        phi_16016_ = _e5636;
                                                        phi_16017_ = _e5638;
                                                        let _e11379 = local_75;
                                                        phi_16018_ = _e11379;
                                                        phi_16019_ = _e5640;
                                                        phi_16020_ = _e5642;
                                                    }
                                                    let _e5647 = phi_16015_;
                                                    let _e5649 = phi_16016_;
                                                    let _e5651 = phi_16017_;
                                                    let _e5653 = phi_16018_;
                                                    let _e5655 = phi_16019_;
                                                    let _e5657 = phi_16020_;
                                                    if _e5649 {
                                                        phi_16025_ = type_46(0u, type_46().member_1);
                                                        phi_16026_ = false;
                                                        phi_16027_ = false;
                                                        phi_16028_ = false;
                                                        phi_16029_ = false;
                                                        phi_16030_ = true;
                                                    } else {
                                                        phi_16025_ = _e5647;
                                                        phi_16026_ = _e5651;
                                                        phi_16027_ = _e5653;
                                                        phi_16028_ = _e5655;
                                                        phi_16029_ = _e5657;
                                                        phi_16030_ = _e5634;
                                                    }
                                                    let _e5661 = phi_16025_;
                                                    let _e5663 = phi_16026_;
                                                    let _e5665 = phi_16027_;
                                                    let _e5667 = phi_16028_;
                                                    let _e5669 = phi_16029_;
                                                    let _e5671 = phi_16030_;
                                                    if _e5663 {
                                                        let _e11390 = local_76;
                                                        phi_16034_ = _e11390;
                                                        phi_16035_ = true;
                                                        phi_16036_ = false;
                                                        phi_16037_ = false;
                                                        phi_16038_ = false;
                                                    } else {
                                                        let _e11392 = local_77;
                                                        phi_16034_ = _e11392;
                                                        phi_16035_ = _e5665;
                                                        phi_16036_ = _e5667;
                                                        phi_16037_ = _e5669;
                                                        phi_16038_ = _e5671;
                                                    }
                                                    let _e5673 = phi_16034_;
                                                    let _e5675 = phi_16035_;
                                                    let _e5677 = phi_16036_;
                                                    let _e5679 = phi_16037_;
                                                    let _e5681 = phi_16038_;
                                                    if _e5675 {
                                                        phi_16042_ = _e5673;
                                                        phi_16043_ = true;
                                                        phi_16044_ = false;
                                                        phi_16045_ = false;
                                                    } else {
                                                        let _e11399 = local_78;
                                                        phi_16042_ = _e11399;
                                                        phi_16043_ = _e5677;
                                                        phi_16044_ = _e5679;
                                                        phi_16045_ = _e5681;
                                                    }
                                                    let _e5683 = phi_16042_;
                                                    let _e5685 = phi_16043_;
                                                    let _e5687 = phi_16044_;
                                                    let _e5689 = phi_16045_;
                                                    if _e5685 {
                                                        phi_16050_ = type_46(1u, _e5683);
                                                        phi_16051_ = false;
                                                        phi_16052_ = false;
                                                    } else {
                                                        phi_16050_ = type_46();
                                                        phi_16051_ = _e5687;
                                                        phi_16052_ = _e5689;
                                                    }
                                                    let _e5692 = phi_16050_;
                                                    let _e5694 = phi_16051_;
                                                    let _e5696 = phi_16052_;
                                                    if _e5694 {
                                                        phi_16057_ = type_46(0u, type_46().member_1);
                                                        phi_16058_ = true;
                                                    } else {
                                                        phi_16057_ = _e5661;
                                                        phi_16058_ = _e5696;
                                                    }
                                                    let _e5700 = phi_16057_;
                                                    let _e5702 = phi_16058_;
                                                    if _e5702 {
                                                        phi_16062_ = _e5700;
                                                    } else {
                                                        phi_16062_ = _e5692;
                                                    }
                                                    let _e5704 = phi_16062_;
                                                    let _e5707 = (_e5704.member != 0u);
                                                    if _e5707 {
                                                        phi_16069_ = false;
                                                    } else {
                                                        phi_16069_ = true;
                                                    }
                                                    let _e5709 = phi_16069_;
                                                    phi_16070_ = _e5704.member_1;
                                                    phi_16071_ = _e5709;
                                                    phi_16072_ = _e5707;
                                                    phi_16073_ = false;
                                                } else {
                                                    phi_16070_ = f64();
                                                    phi_16071_ = false;
                                                    phi_16072_ = false;
                                                    phi_16073_ = true;
                                                }
                                                let _e5711 = phi_16070_;
                                                let _e5713 = phi_16071_;
                                                let _e5715 = phi_16072_;
                                                let _e5717 = phi_16073_;
                                                phi_16074_ = _e3891;
                                                phi_16075_ = _e3893;
                                                phi_16076_ = _e5711;
                                                phi_16077_ = _e5713;
                                                phi_16078_ = _e5715;
                                                phi_16079_ = _e5717;
                                            }
                                            let _e5719 = phi_16074_;
                                            let _e5721 = phi_16075_;
                                            let _e5723 = phi_16076_;
                                            let _e5725 = phi_16077_;
                                            let _e5727 = phi_16078_;
                                            let _e5729 = phi_16079_;
                                            phi_16080_ = _e5719;
                                            phi_16081_ = _e5721;
                                            phi_16082_ = _e5723;
                                            phi_16083_ = _e3887;
                                            phi_16084_ = _e5725;
                                            phi_16085_ = _e5727;
                                            phi_16086_ = _e5729;
                                        }
                                        let _e5731 = phi_16080_;
                                        let _e5733 = phi_16081_;
                                        let _e5735 = phi_16082_;
                                        let _e5737 = phi_16083_;
                                        let _e5739 = phi_16084_;
                                        let _e5741 = phi_16085_;
                                        let _e5743 = phi_16086_;
                                        if _e5737 {
                                            phi_16090_ = false;
                                            phi_16091_ = false;
                                            phi_16092_ = false;
                                        } else {
                                            phi_16090_ = _e5739;
                                            phi_16091_ = _e5741;
                                            phi_16092_ = _e5743;
                                        }
                                        let _e5745 = phi_16090_;
                                        let _e5747 = phi_16091_;
                                        let _e5749 = phi_16092_;
                                        phi_16093_ = _e3163;
                                        phi_16094_ = _e5731;
                                        phi_16095_ = _e5733;
                                        phi_16096_ = _e5735;
                                        phi_16097_ = _e3163;
                                        phi_16098_ = _e5737;
                                        phi_16099_ = _e5745;
                                        phi_16100_ = _e5747;
                                        phi_16101_ = _e5749;
                                    } else {
                                        phi_16093_ = type_49();
                                        phi_16094_ = bool();
                                        phi_16095_ = f64();
                                        phi_16096_ = f64();
                                        phi_16097_ = type_49();
                                        phi_16098_ = true;
                                        phi_16099_ = false;
                                        phi_16100_ = false;
                                        phi_16101_ = false;
                                    }
                                    let _e5751 = phi_16093_;
                                    let _e5753 = phi_16094_;
                                    let _e5755 = phi_16095_;
                                    let _e5757 = phi_16096_;
                                    let _e5759 = phi_16097_;
                                    let _e5761 = phi_16098_;
                                    let _e5763 = phi_16099_;
                                    let _e5765 = phi_16100_;
                                    let _e5767 = phi_16101_;
                                    if _e5761 {
                                        phi_16105_ = true;
                                        phi_16106_ = false;
                                        phi_16107_ = false;
                                    } else {
                                        phi_16105_ = _e5763;
                                        phi_16106_ = _e5765;
                                        phi_16107_ = _e5767;
                                    }
                                    let _e5769 = phi_16105_;
                                    let _e5771 = phi_16106_;
                                    let _e5773 = phi_16107_;
                                    phi_16108_ = _e5751;
                                    phi_16109_ = _e5753;
                                    phi_16110_ = _e5755;
                                    phi_16111_ = _e5757;
                                    phi_16112_ = _e5759;
                                    phi_16113_ = _e5769;
                                    phi_16114_ = false;
                                    phi_16115_ = _e5771;
                                    phi_16116_ = _e5773;
                                } else {
                                    phi_16108_ = type_49();
                                    phi_16109_ = bool();
                                    phi_16110_ = f64();
                                    phi_16111_ = f64();
                                    phi_16112_ = type_49();
                                    phi_16113_ = false;
                                    phi_16114_ = true;
                                    phi_16115_ = false;
                                    phi_16116_ = false;
                                }
                                let _e5775 = phi_16108_;
                                let _e5777 = phi_16109_;
                                let _e5779 = phi_16110_;
                                let _e5781 = phi_16111_;
                                let _e5783 = phi_16112_;
                                let _e5785 = phi_16113_;
                                let _e5787 = phi_16114_;
                                let _e5789 = phi_16115_;
                                let _e5791 = phi_16116_;
                                local_32 = _e5787;
                                local_79 = _e5789;
                                local_80 = _e5791;
                                local_33 = _e5777;
                                local_34 = _e5775;
                                local_35 = _e5781;
                                local_36 = _e5779;
                                local_37 = _e5781;
                                local_38 = _e5781;
                                local_39 = _e5783;
                                continue;
                                continuing {
                                    phi_11830_ = _e2871;
                                    break if !(_e5785);
                                }
                            }
                            let _e5794 = local_32;
                            if _e5794 {
                                phi_16121_ = type_46(0u, type_46().member_1);
                                phi_16122_ = false;
                                phi_16123_ = false;
                            } else {
                                phi_16121_ = type_46();
                                let _e11455 = local_79;
                                phi_16122_ = _e11455;
                                let _e11458 = local_80;
                                phi_16123_ = _e11458;
                            }
                            let _e5798 = phi_16121_;
                            let _e5800 = phi_16122_;
                            let _e5802 = phi_16123_;
                            if _e5800 {
                                let _e5804 = local_33;
                                if _e5804 {
                                    let _e5806 = local_34;
                                    let _e5809 = local_35;
                                    let _e5812 = local_36;
                                    if ((_e5806.member_1 - _e5809) <= _e5812) {
                                        let _e5815 = local_37;
                                        phi_16137_ = type_46(1u, _e5815);
                                        phi_16138_ = false;
                                    } else {
                                        phi_16137_ = type_46();
                                        phi_16138_ = true;
                                    }
                                    let _e5818 = phi_16137_;
                                    let _e5820 = phi_16138_;
                                    phi_16139_ = _e5818;
                                    phi_16140_ = _e5820;
                                } else {
                                    phi_16139_ = type_46();
                                    phi_16140_ = true;
                                }
                                let _e5822 = phi_16139_;
                                let _e5824 = phi_16140_;
                                if _e5824 {
                                    let _e5826 = local_38;
                                    phi_16145_ = type_46(2u, _e5826);
                                } else {
                                    phi_16145_ = _e5822;
                                }
                                let _e5829 = phi_16145_;
                                phi_16146_ = _e5829;
                                phi_16147_ = false;
                            } else {
                                phi_16146_ = type_46();
                                phi_16147_ = _e5802;
                            }
                            let _e5831 = phi_16146_;
                            let _e5833 = phi_16147_;
                            if _e5833 {
                                let _e5835 = local_39;
                                phi_16153_ = type_46(1u, _e5835.member);
                                phi_16154_ = true;
                            } else {
                                phi_16153_ = _e5831;
                                phi_16154_ = _e5800;
                            }
                            let _e5839 = phi_16153_;
                            let _e5841 = phi_16154_;
                            phi_16158_ = _e5839;
                            phi_16159_ = _e5798;
                            phi_16160_ = _e5841;
                        } else {
                            phi_16158_ = _e2715;
                            phi_16159_ = type_46();
                            phi_16160_ = true;
                        }
                        let _e5843 = phi_16158_;
                        let _e5845 = phi_16159_;
                        let _e5847 = phi_16160_;
                        phi_16164_ = _e5843;
                        phi_16165_ = _e5845;
                        phi_16166_ = _e5847;
                    }
                    let _e5851 = phi_16164_;
                    let _e5853 = phi_16165_;
                    let _e5855 = phi_16166_;
                    if _e5855 {
                        phi_16170_ = _e5851;
                    } else {
                        phi_16170_ = _e5853;
                    }
                    let _e5857 = phi_16170_;
                    if (_e5857.member == 1u) {
                        if (_e5857.member_1 > _e427) {
                            phi_16181_ = false;
                        } else {
                            phi_16181_ = true;
                        }
                        let _e5863 = phi_16181_;
                        phi_16182_ = _e5863;
                    } else {
                        phi_16182_ = true;
                    }
                    let _e5865 = phi_16182_;
                    if _e5865 {
                        phi_16186_ = false;
                    } else {
                        phi_16186_ = true;
                    }
                    let _e5867 = phi_16186_;
                    if _e5867 {
                        phi_16190_ = 1u;
                    } else {
                        phi_16190_ = 0u;
                    }
                    let _e5869 = phi_16190_;
                    phi_16194_ = type_47(_e5857, _e5869);
                }
                let _e10483 = phi_16194_;
                switch bitcast<i32>(_e10483.member.member) {
                    case 0: {
                        phi_16209_ = type_37(0u, _e10483.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e10494 = function_4(_e10483.member.member_1);
                        phi_16209_ = type_37(0u, _e10483.member_1, _e10494, true);
                        break;
                    }
                    case 2: {
                        let _e10490 = function_4(_e10483.member.member_1);
                        phi_16209_ = type_37(1u, _e10483.member_1, _e10490, true);
                        break;
                    }
                    default: {
                        phi_16209_ = type_37();
                        break;
                    }
                }
                let _e10498 = phi_16209_;
                if _e10498.member_3 {
                    let _e10506 = (_e10498.member_2[1] >> bitcast<u32>(20i));
                    if (_e10506 <= 896u) {
                        phi_16233_ = 0u;
                    } else {
                        phi_16233_ = ((((_e10506 - 896u) << bitcast<u32>(23i)) | ((_e10498.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e10498.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e10521 = phi_16233_;
                    let _e10523 = atomicMin((&earliest.member[0u]), _e10521);
                }
                phi_16237_ = type_22(0u, _e10498.member, _e212, _e215, _e10498.member_2, _e10498.member_1);
                phi_16238_ = _e10498.member_3;
            } else {
                phi_16237_ = type_22(0u, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_16238_ = false;
            }
            let _e10525 = phi_16237_;
            let _e10527 = phi_16238_;
            let _e10530 = params.member.member.member_1;
            if ((_e10530 & 16u) != 0u) {
                if (_e124 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e10527 {
                    let _e10536 = atomicAdd((&counters[0u]), 1u);
                    phi_16257_ = _e10536;
                } else {
                    phi_16257_ = 0u;
                }
                let _e10538 = phi_16257_;
                workgroupBarrier();
                if (_e124 == 0u) {
                    let _e10541 = atomicLoad((&counters[0u]));
                    if (_e10541 > 0u) {
                        let _e10544 = atomicAdd((&contacts.member[0u]), _e10541);
                        atomicStore((&counters[1u]), _e10544);
                    }
                }
                workgroupBarrier();
                let _e10547 = atomicLoad((&counters[1u]));
                let _e10548 = (_e10547 + _e10538);
                if _e10527 {
                    let _e10551 = params.member.member_1.member_3;
                    if (_e10548 < _e10551) {
                        let _e10553 = (7u * _e10548);
                        atomicStore((&contacts.member[(4u + _e10553)]), _e10525.member);
                        atomicStore((&contacts.member[(_e10553 + 5u)]), _e10525.member_1);
                        atomicStore((&contacts.member[(_e10553 + 6u)]), _e10525.member_2);
                        atomicStore((&contacts.member[(_e10553 + 7u)]), _e10525.member_3);
                        atomicStore((&contacts.member[(_e10553 + 8u)]), _e10525.member_4[0]);
                        atomicStore((&contacts.member[(_e10553 + 9u)]), _e10525.member_4[1]);
                        atomicStore((&contacts.member[(_e10553 + 10u)]), _e10525.member_5);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_1024_ = _e193;
            break if !(_e199);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_vertex_face_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
